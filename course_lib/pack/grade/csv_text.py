"""Tables as CSV text: no cell is a formula to a spreadsheet, and what any spreadsheet saves can be read."""

import csv
import functools
import io
import re
import unicodedata

from course_lib.pack.grade import GradingStopped

LONGEST = 1000  # characters of a message in a table; the feedback has all
LONGEST_ANSWER = 30_000  # characters that a spreadsheet's cell can hold
# how a formula may begin in a spreadsheet, also in full-width letters
FORMULA = "=+-@\uff1d\uff0b\uff0d\uff20"
# For a program that separates cells by semicolons, tabs or line ends, a formula may begin after
# those too.
INSIDE = re.compile(rf"([;\t\n]\s*)(?=[{re.escape(FORMULA)}])")
MARKED_INSIDE = re.compile(rf"([;\t\n]\s*)'(?=[{re.escape(FORMULA)}])")
# without it Excel on Windows shows accents wrongly; Canvas and Moodle import a file that has it
MARK = "\ufeff"


def table_text(columns, rows, lines=False):
    """Return a table as CSV text in which no value is a formula. lines: see cell."""
    file = io.StringIO(newline="")
    table = [[cell(value, lines) for value in row] for row in (columns, *rows)]
    csv.writer(file, lineterminator="\n").writerows(table)
    return MARK + file.getvalue()


def read_table(path, known):
    """Return the rows of a CSV file as dicts; of columns with the same name the first that is filled counts.

    The file is UTF-8, UTF-16, or the single bytes of Windows. Of commas, semicolons and tabs, the
    separator is the one that finds most of the `known` names of columns.
    """

    def lines(separator):
        return csv.reader(io.StringIO(text, newline=""), delimiter=separator)

    def names_by(separator):
        return [name.strip().strip('"') for name in next(lines(separator), [])]

    try:
        text, found = (
            re.sub(r"\Asep=.\s*", "", _decoded(path.read_bytes())),
            [],
        )  # a line that is for Excel
        separator = max(
            ",;\t", key=lambda each: (len(known & {*names_by(each)}), len(names_by(each)))
        )
        names, rows = names_by(separator), list(lines(separator))[1:]
    except OSError as error:
        raise GradingStopped(f"{path} cannot be read: {error.strerror}.") from error
    except csv.Error as problem:
        raise GradingStopped(f"{path} is not a table: {problem}.") from problem
    for row in filter(any, rows):
        line = dict.fromkeys(names, "")
        for name, value in zip(names, row, strict=False):
            line[name] = line[name] or value
        found.append(line)
    return found


def _decoded(content):
    if content.startswith((b"\xff\xfe", b"\xfe\xff")):
        return content.decode("utf-16", "replace")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("cp1252", "replace")


@functools.lru_cache(10_000, typed=True)  # most cells repeat others
def cell(value, lines=False):
    """Return a value as text that no spreadsheet reads as a formula.

    lines: True keeps its line breaks and length.
    """
    if isinstance(value, int | float):
        return f"{value:g}" if value < 1e5 else str(value)
    text = clean(value)
    if not lines:
        text = " ".join(text.split())
        text = text if len(text) <= LONGEST else text[:LONGEST] + " ..."
    text = f"'{text}" if text.lstrip()[:1] and text.lstrip()[:1] in FORMULA else text
    return INSIDE.sub(r"\1'", text)


def cell_text(text):
    """Return the text of a cell without the apostrophes that `cell` may have added."""
    text = MARKED_INSIDE.sub(r"\1", text)
    return text[1:] if text[:1] == "'" and text[1:].lstrip()[:1] in tuple(FORMULA) else text


def clean(text):
    """Return a text without lone surrogates and control characters, which cannot be stored or shown."""
    text = str(text).encode("utf-8", "replace").decode()
    return re.sub(
        r"[\x00-\x08\x0b-\x1f\x7f-\x9f]", "", text.replace("\r\n", "\n").replace("\r", "\n")
    )


def words(name):
    """Return the sorted words of a name without accents, the same for "Doe, Jane" and "Jane Doe".

    Without the signs that Moodle leaves out of file names too (public/lib/classes/param.php,
    clean_param_value_file).
    """
    plain = re.sub(r"[&<>\"`|':\\/]", "", unicodedata.normalize("NFKD", name).casefold())
    return " ".join(
        sorted(re.findall(r"\w+", "".join(c for c in plain if not unicodedata.combining(c))))
    )


def answer_text(text):
    """Return a written answer, cut to the length that a cell can hold."""
    text = clean(text).strip()
    return (
        text
        if len(text) <= LONGEST_ANSWER
        else text[:LONGEST_ANSWER] + "\n... (the feedback has all of it)"
    )


def count_noun(number, name):
    """Return a number with a noun that agrees with it."""
    return f"{number} {name}" if number == 1 else f"{number} {name}s"
