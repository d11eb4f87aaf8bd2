"""Tables as CSV text: no cell is a formula to a spreadsheet, and what any spreadsheet saves can be
read."""

import csv
import functools
import io
import os
import re
import unicodedata
from collections.abc import Iterable
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
# A line for Excel that names the separator.
EXCEL_SEPARATOR = re.compile(r"\Asep=.\s*")
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


def read_table(path: Path, known: set[str]) -> list[dict[str, str]]:
    """Return the rows of a CSV file as dicts; of columns with the same name the first that is
    filled counts.

    The file is UTF-8, UTF-16, or the single bytes of Windows. Of commas, semicolons and tabs, the
    separator is the one that finds most of the `known` names of columns.
    """
    try:
        text = EXCEL_SEPARATOR.sub("", _decoded(path.read_bytes()))
        separator = max(SEPARATORS, key=lambda sign: _rank(_headings(text, sign), known))
        headings = _headings(text, separator)
        rows = list(csv.reader(io.StringIO(text, newline=""), delimiter=separator))[1:]
    except OSError as error:
        raise GradingStopped(f"{path} cannot be read: {error.strerror}.") from error
    except csv.Error as problem:
        raise GradingStopped(f"{path} is not a table: {problem}.") from problem
    table = []
    for row in filter(any, rows):
        line = dict.fromkeys(headings, "")
        for heading, value in zip(headings, row, strict=False):
            line[heading] = line[heading] or value
        table.append(line)
    return table


def _headings(text: str, separator: str) -> list[str]:
    first = next(csv.reader(io.StringIO(text, newline=""), delimiter=separator), [])
    return [name.strip().strip('"') for name in first]


def _rank(headings: list[str], known: set[str]) -> tuple[int, int]:
    """Return how well headings fit: the more known names, then the more columns, the better."""
    return len(known & {*headings}), len(headings)


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
    text = unicodedata.normalize("NFC", os.fsencode(str(name)).decode("utf-8", "backslashreplace"))
    return "".join(c if c.isprintable() or c in JOINERS else f"\\x{ord(c):02x}" for c in text)


def words(name: str) -> str:
    """Return the sorted words of a name without accents, the same for "Doe, Jane" and "Jane Doe".

    Without the signs that Moodle leaves out of file names too (public/lib/classes/param.php,
    clean_param_value_file).
    """
    plain = re.sub(r"[&<>\"`|':\\/]", "", unicodedata.normalize("NFKD", name).casefold())
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
