"""Tables in text and NPY files: what separates columns, which line is the header, which rows hold
numbers.

The standard library's csv module reads cells and quotes. Its Sniffer is not used: it prefers a
comma over a semicolon, and so it splits the decimal commas of a German spreadsheet.
"""

import csv
import re
from collections import Counter
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

_SEPARATORS = (";", "\t", "|", ",", " ")  # of equals the one least likely to be part of a number
_SAMPLE_LINES = 200  # from which the separator is chosen
# Swedish spreadsheets write a minus sign, U+2212, and Fortran an exponent with a D.
_SIGN, _EXPONENT = r"[-+\u2212]?", r"([ed][-+\u2212]?\d+)?"
_AS_PYTHON = str.maketrans("\u2212dD", "-ee")
_NUMBER = re.compile(
    rf"{_SIGN}(\d+\.?\d*|\.\d+){_EXPONENT}|[-+]?\.?(nan|inf|infinity)", re.IGNORECASE
)
_DECIMAL_COMMA = re.compile(rf"{_SIGN}\d*,\d+{_EXPONENT}", re.IGNORECASE)
_LIST = re.compile(r"[\[(](.*)[\])]", re.S)


@dataclass(frozen=True)
class Table:
    """A table as it stands in a file; its rows count from 1, without the header.

    Attributes
    ----------
    name : str
        The file's name, for messages.
    header : tuple of str
        The titles of the columns; empty if there is no header.
    rows : list of list of str
        The cells.
    transposed : bool
        Whether rows and columns are exchanged against those of the file.
    """

    name: str
    header: tuple
    rows: list
    transposed: bool = False

    @property
    def width(self):
        """The number of columns."""
        return len(self.rows[0])

    @cached_property
    def decimal_comma(self):
        """Whether a cell, in whatever row, is a number with a decimal comma."""
        return any(_DECIMAL_COMMA.fullmatch(cell) for row in self.rows for cell in row)

    def title(self, place):
        """Return the title of a column; its number, which counts from 1, if it has none."""
        return (self.header and self.header[place]) or str(place + 1)

    def where(self, row, place, label):
        """Return where a cell stands in the file; label: what messages call its column."""
        if self.transposed:
            return f"row {place + 1}, column {row + 1}"
        return f"row {row + 1}, {label}"

    def with_samples_as_rows(self, joint_count):
        """Return the table with samples as rows, if only its columns fit this number of joints."""
        fits = self.width == joint_count or len(self.rows) != joint_count
        if self.header or fits:
            return self
        return replace(
            self, rows=[list(row) for row in zip(*self.rows, strict=True)], transposed=True
        )

    def cells(self, place):
        """Return the cells of a column as text, numbers with a decimal point."""
        cells = [row[place] for row in self.rows]
        return [cell.replace(",", ".") for cell in cells] if self.decimal_comma else cells

    def numerals(self, place):
        """Return the cells of a column of numbers as Python writes these."""
        return [cell.translate(_AS_PYTHON) for cell in self.cells(place)]

    def holds_numbers(self, place):
        """Return whether a cell of a column is a number."""
        return any(_is_number(row[place]) for row in self.rows)

    def numbers(self, place, label):
        """Return a column as floats (n,), or refuse the first cell that is no number.

        label: what the message calls the column.
        """
        rows = self.rows
        point = next((i for i, row in enumerate(rows) if "." in row[place]), None)
        if self.decimal_comma and point is not None:
            raise ValueError(
                f"{self.name}: {self.where(point, place, label)} is {rows[point][place]!r:.40}, "
                "with a point, and other numbers have a decimal comma. Write all decimals in one "
                "way, and no separators of thousands"
            )
        cells = self.cells(place)
        for row, cell in enumerate(cells):
            if not _NUMBER.fullmatch(cell):
                raise ValueError(
                    f"{self.name}: {self.where(row, place, label)} is {rows[row][place]!r:.40}, "
                    "which is not a number"
                )
        # YAML, in which ROS prints messages, writes .nan and .inf.
        numerals = [re.sub(r"\.(?=[ni])", "", cell, flags=re.I) for cell in self.numerals(place)]
        return np.array(numerals, float)


def read_table(path):
    """Return the Table in a file; a column of lists becomes a column for each of their entries.

    Parameters
    ----------
    path : pathlib.Path
        A text file, or an NPY file.

    Raises
    ------
    ValueError
        If the file holds no table of numbers.
    """
    if path.suffix.lower() == ".npy":
        return _read_npy(path)
    return _with_entries_of_lists(_read_text(path))


def _read_npy(path):
    try:
        table = np.load(path, allow_pickle=False)
    except (ValueError, EOFError) as unreadable:
        raise ValueError(f"{path.name} cannot be read as NPY: {unreadable}") from unreadable
    if not isinstance(table, np.ndarray):  # an NPZ archive under a wrong name
        raise ValueError(f"{path.name} cannot be read as NPY: it is an archive of several arrays")
    if table.dtype.kind not in "iuf":
        raise ValueError(f"{path.name} must hold real numbers; it holds {table.dtype}")
    if table.ndim != 2 or table.size == 0:
        raise ValueError(
            f"{path.name} must hold a table with a row for each sample; its shape is {table.shape}"
        )
    return Table(path.name, (), [[str(value) for value in row] for row in table.tolist()])


def _read_text(path):
    lines = re.split(r"\r\n|\r|\n", _decoded(path.read_bytes()).replace("\ufeff", ""))
    lines = [line.strip(" ") for line in lines if line.strip(" ,;\t|")]
    # Excel reads the line sep=; and hides it.
    lines = [line for line in lines if not re.fullmatch(r'"?sep=.?"?', line, re.I)]
    comments = [line.lstrip("#% ") for line in lines if line.startswith(("#", "%"))]
    body = [line for line in lines if not line.startswith(("#", "%"))]
    separator = max(_SEPARATORS, key=lambda separator: _share_of_numbers(body, separator))
    try:
        rows = _split(body, separator)
    except csv.Error as unreadable:
        raise ValueError(f"{path.name} cannot be read as a table: {unreadable}") from unreadable
    # pandas writes the numbers of columns, 0, 1, 2 ..., where they have no titles.
    counted = bool(rows) and len(rows[0]) > 3 and _counts_columns(rows[0])
    first = next((i for i, row in enumerate(rows) if i >= counted and _has_number(row)), None)
    if first is None:
        titles = f"; its header is {body[0]:.80}" if body else ""
        raise ValueError(
            f"{path.name} cannot be read as a table: it must hold a row of numbers, and holds none"
            f"{titles}"
        )
    data = rows[first:]
    (usual_width, _), *_ = Counter(map(len, data)).most_common(1)
    header = _header([*comments, *body[:first]], separator, usual_width)
    while not any(row[-1] for row in data if row) and all(len(row) == usual_width for row in data):
        if len(header) == usual_width and header[-1]:
            break
        # Each line ends with a separator.
        usual_width -= 1
        header, data = header[:usual_width], [row[:-1] for row in data]
    _refuse_ragged(path.name, header, data, len(header) or len(data[0]))
    return Table(path.name, tuple(header), data)


def _decoded(data):
    """Return the text of a file: UTF-16 by its byte order mark, else UTF-8, else Windows' code."""
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return data.decode("utf-16", "replace")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("cp1252", "replace")  # as spreadsheets write


def _split(lines, separator):
    """Return the cells of lines, without the spaces around them."""
    if separator == " ":
        lines = [re.sub(" +", " ", line) for line in lines]
    rows = csv.reader(lines, delimiter=separator, skipinitialspace=True)
    return [[cell.strip() for cell in row] for row in rows if row]


def _share_of_numbers(lines, separator):
    """Return what share of the cells are numbers, in rows of the commonest width, times the share
    of these rows: it is most for the separator of the file."""
    try:
        rows = _split(lines[:_SAMPLE_LINES], separator)
    except csv.Error:
        return 0.0
    (width, _), *_ = Counter(map(len, rows)).most_common(1) or [(0, 0)]
    fitting = [row for row in rows if len(row) == width > 1]
    count, size = 0, 0
    for cell in (cell for row in fitting for cell in row):
        entries = _entries(cell)
        count += _is_number(cell) if entries is None else len(entries)
        size += 1 if entries is None else len(entries)
    return count / max(size, 1) * len(fitting) / max(len(rows), 1)


def _is_number(cell):
    return bool(_NUMBER.fullmatch(cell) or _DECIMAL_COMMA.fullmatch(cell))


def _has_number(row):
    return any(_is_number(cell) or _LIST.fullmatch(cell) for cell in row)


def _counts_columns(row):
    counted = [str(i) for i in range(len(row))]
    return row in (counted, ["", *counted[:-1]])


def _header(lines, separator, width):
    """Return the titles of the last line that has as many as there are columns, or of the last.

    lines: those before the first row, comments first; their separator may be another one.
    """
    before = [line for line in reversed(lines) if line.strip()]
    for line in before:
        for other in _SEPARATORS:
            (titles,) = _split([line], other) or [[]]
            if len(titles) == width and (_counts_columns(titles) or not _has_number(titles)):
                return titles
    (titles,) = _split(before[:1], separator) or [[]]
    return titles if len(titles) > 1 else []


def _refuse_ragged(name, header, rows, width):
    wrong = [number for number, row in enumerate(rows, 1) if len(row) != width]
    if not wrong:
        return
    number = wrong[0]
    count = len(rows[number - 1])
    reason = ""
    if 1 < number == len(rows) and count < width:
        reason = ": is the file cut off?"
    elif len(wrong) < len(rows):
        reason = (
            f"; {len(wrong)} of {len(rows)} rows have another number of columns than the rest. Fill"
            " their missing cells, or leave these rows out"
        )
    elif header:
        reason = f"; its header is {','.join(header):.80}. Write a title for each column"
    raise ValueError(
        f"{name}: row {number} has {count} column{'s' * (count > 1)}, not {width}{reason}"
    )


def _with_entries_of_lists(table):
    """Return a table in which a column of lists, such as "[0.1, 0.2]", is a column for each entry.

    Tools that write a message of ROS in a row, and pandas, write arrays in this way.
    """
    header, columns = [], []
    for place in range(table.width if table.header else 0):
        cells = [row[place] for row in table.rows]
        lists = [_entries(cell) for cell in cells]
        lengths = {0 if entries is None else len(entries) for entries in lists}
        if len(lengths) == 1 and 0 not in lengths:
            header += [f"{table.header[place]}[{i}]" for i in range(lengths.pop())]
            columns += zip(*lists, strict=True)
        else:
            header.append(table.header[place])
            columns.append(cells)
    if len(header) == len(table.header):
        return table
    return replace(
        table, header=tuple(header), rows=[list(row) for row in zip(*columns, strict=True)]
    )


def _entries(cell):
    """Return the entries of a list in a cell, or None if it is not one."""
    inside = _LIST.fullmatch(cell)
    if not inside or "..." in cell:  # numpy leaves the middle of a long array out
        return None
    inner = inside[1].strip()
    entries = inner.split(",") if "," in inner else inner.split()
    return [entry.strip(" '\"\n") for entry in entries]
