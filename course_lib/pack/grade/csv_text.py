"""Tables as CSV text: no cell is a formula to a spreadsheet, and what any spreadsheet saves can be
read."""

import csv
import functools
import io
import itertools
import os
import re
import unicodedata
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from course_lib.pack.grade import GradingStopped

MAX_MESSAGE = 1000  # characters of a message in a table; the feedback has all
MAX_ANSWER = 30_000  # characters that a spreadsheet's cell can hold
# How a formula may begin in a spreadsheet, also in full-width letters.
FORMULA = "=+-@\uff1d\uff0b\uff0d\uff20"
# For a program that separates cells by semicolons, tabs or line ends, a formula may begin after
# those too.
INSIDE = re.compile(rf"([;\t\n]\s*)(?=[{re.escape(FORMULA)}])")
MARKED_INSIDE = re.compile(rf"([;\t\n]\s*)'(?=[{re.escape(FORMULA)}])")
# Without it Excel on Windows shows accents wrongly; Canvas and Moodle import a file that has it.
MARK = "\ufeff"
SEPARATORS = ",;\t"
MAX_ABOVE = 20  # lines among which the names of the columns are looked for
# How files begin that are sent in place of a table, and what they are.
KINDS = {
    b"PK\x03\x04": "a spreadsheet's file (.xlsx or .ods), or another zip",
    b"\xd0\xcf\x11\xe0": "a file of Excel (.xls)",
    b"%PDF": "a PDF",
    b"<!DOCTYPE": "a web page",
    b"<html": "a web page",
}
# A line for Excel that names the separator.
EXCEL_SEPARATOR = re.compile(r"\Asep=.\s*")
# The signs that keyboards and programs write for the apostrophe of O'Neill.
APOSTROPHES = dict.fromkeys(map(ord, "'`\u00b4\u2018\u2019\u02bc\u2032"))
JOINERS = "\u200c\u200d"  # not printable by themselves, and part of some names


def table_text(
    columns: Iterable,
    rows: Iterable[Iterable],
    lines: bool = False,
    formulas: bool = False,
    mark: bool = True,
    quotes: bool = False,
) -> str:
    """Return a table as CSV text.

    lines: see `cell`. formulas: True leaves cells as they are, even if a spreadsheet takes them for
    formulas. mark: whether the text begins with the mark by which Excel knows that it is UTF-8.
    quotes: whether each cell stands in quotation marks, not only those that need them.
    """
    file = io.StringIO(newline="")
    quoting = csv.QUOTE_ALL if quotes else csv.QUOTE_MINIMAL
    writer = csv.writer(file, lineterminator="\n", quoting=quoting)
    for row in (columns, *rows):
        writer.writerow([clean(value) if formulas else cell(value, lines) for value in row])
    return (MARK if mark else "") + file.getvalue()


@dataclass(frozen=True)
class Line:
    """A line of a table that was read.

    number: of the last line of the file that it takes, from 1. separator: of the table's cells.
    """

    number: int
    cells: list[str]
    separator: str


def read_table(path: Path, known: set[str]) -> list[dict[str, str]]:
    """Return the rows of a CSV file as dicts; of columns with the same name the first that is
    filled counts. See read_lines."""
    return rows_below(read_lines(path, known))


def read_lines(path: Path, known: set[str]) -> list[Line]:
    """Return the filled lines of a CSV file, of which the first has the names of the columns.

    The file is UTF-8, UTF-16, or the single bytes of Windows. Of commas, semicolons and tabs, the
    separator is the one that finds most of the `known` names of columns. Raises GradingStopped if
    the file cannot be read, or is of another kind, such as a spreadsheet's.
    """
    try:
        content = path.read_bytes()
        if kind := next((kind for begin, kind in KINDS.items() if content.startswith(begin)), ""):
            raise GradingStopped(
                f"{path} is {kind}, and not a table as text. Open it and save it as CSV (UTF-8), "
                "or download it as CSV."
            )
        text = EXCEL_SEPARATOR.sub("", _decoded(content))
        separator = max(SEPARATORS, key=lambda sign: _rank(text, sign, known))
        rows = csv.reader(io.StringIO(text, newline=""), delimiter=separator)
        lines = [Line(rows.line_num, row, separator) for row in rows if any(map(str.strip, row))]
    except OSError as error:
        raise GradingStopped(f"{path} cannot be read: {error.strerror}.") from error
    except csv.Error as problem:
        raise GradingStopped(f"{path} is not a table: {problem}.") from problem
    if lines:
        lines[0] = replace(lines[0], cells=[name.strip().strip('"') for name in lines[0].cells])
    return lines


def rows_below(lines: Sequence[Line]) -> list[dict[str, str]]:
    """Return the rows below the first of some Lines as {name of a column: cell}."""
    if not lines:
        return []
    headings = lines[0].cells
    table = []
    for line in lines[1:]:
        row = dict.fromkeys(headings, "")
        for heading, value in zip(headings, line.cells, strict=False):
            row[heading] = row[heading] or value
        table.append(row)
    return table


def _rank(text: str, separator: str, known: set[str]) -> tuple[int, int]:
    """Return how well a separator fits the first lines: the more known names are in one of them,
    then the more columns there are, the better."""
    rows = csv.reader(io.StringIO(text, newline=""), delimiter=separator)
    names = [[cell.strip().strip('"') for cell in row] for row in itertools.islice(rows, MAX_ABOVE)]
    return max((len(known & {*row}) for row in names), default=0), max(map(len, names), default=0)


def _decoded(content: bytes) -> str:
    if content.startswith((b"\xff\xfe", b"\xfe\xff")):
        return content.decode("utf-16", "replace")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("cp1252", "replace")


@functools.lru_cache(10_000, typed=True)  # most cells repeat others
def cell(value: object, lines: bool = False) -> str:
    """Return a value as text that no spreadsheet reads as a formula.

    lines: True keeps its line breaks and length.
    """
    if isinstance(value, int | float):
        return f"{value:g}" if value < 1e5 else str(value)
    text = clean(value)
    if not lines:
        text = " ".join(text.split())
        text = text if len(text) <= MAX_MESSAGE else text[:MAX_MESSAGE] + " ..."
    first = text.lstrip()[:1]
    if first and first in FORMULA:
        text = f"'{text}"
    return INSIDE.sub(r"\1'", text)


def cell_text(text: str) -> str:
    """Return the text of a cell without the apostrophes that `cell` may have added."""
    text = MARKED_INSIDE.sub(r"\1", text)
    return text[1:] if text[:1] == "'" and text[1:].lstrip()[:1] in tuple(FORMULA) else text


def clean(text: object) -> str:
    """Return a text without lone surrogates and control characters, which cannot be stored or
    shown."""
    if isinstance(text, float):
        text = f"{text:g}"
    text = str(text).encode("utf-8", "replace").decode()
    text = text.replace("\r\n", "\n").replace("\r", "\n")
    return re.sub(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]", "", text)


def printable(name: str) -> str:
    """Return a name from the file system as printable text, normalized and on one line."""
    try:
        # In the bytes that the file system has: its names need not be UTF-8, nor this locale's.
        name = os.fsencode(str(name)).decode("utf-8", "backslashreplace")
    except UnicodeEncodeError:  # a name from a zip, with letters that this locale does not have
        name = str(name)
    # Some programs write a no-break space before PM, and keyboards of Macs write one by Alt.
    text = "".join(" " if unicodedata.category(c) == "Zs" else c for c in name)
    text = unicodedata.normalize("NFC", text)
    return "".join(c if c.isprintable() or c in JOINERS else f"\\x{ord(c):02x}" for c in text)


def words(name: str) -> str:
    """Return the sorted words of a name, the same for "Doe, Jane" and "Jane Doe", without accents
    or apostrophes.

    Without the signs that Moodle leaves out of file names too (public/lib/classes/param.php,
    clean_param_value_file).
    """
    decomposed = unicodedata.normalize("NFKD", name.translate(APOSTROPHES))
    plain = re.sub(r"[&<>\"`|':\\/]", "", decomposed.casefold())
    letters = "".join(c for c in plain if not unicodedata.combining(c))
    return " ".join(sorted(re.findall(r"\w+", letters)))


def answer_text(text: str) -> str:
    """Return a written answer, cut to the length that a cell can hold."""
    text = clean(text).strip()
    if len(text) <= MAX_ANSWER:
        return text
    return text[:MAX_ANSWER] + "\n... (the feedback has all of it)"


def count_noun(number: int, name: str) -> str:
    """Return a number with a noun that agrees with it."""
    return f"{number} {name}" if number == 1 else f"{number} {name}s"


def listing(names: Iterable[str], most: int = 10) -> str:
    """Return names in a row, separated by commas; of many, the first and how many more there
    are."""
    names = list(names)
    if len(names) <= most:
        return ", ".join(names)
    return f"{', '.join(names[:most])} and {len(names) - most} more"
