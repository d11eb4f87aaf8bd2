"""Tables in text and NPY files: which rows hold numbers, which one is the header, what separates
columns.

The standard library's csv module reads cells and quotes. Its Sniffer is not used: it prefers a
comma over a semicolon, and so it splits the decimal commas of a German spreadsheet.
"""

import codecs
import csv
import re
from collections import Counter
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

_SEPARATORS = (";", "\t", "|", ",", " ")
# Lines from which the separator is chosen: half from the beginning, half from the end.
_SAMPLE = 400
_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?|[-+]?(nan|inf|infinity)", re.I)
_DECIMAL_COMMA = re.compile(r"[-+]?\d*,\d+(e[-+]?\d+)?", re.I)
_LIST = re.compile(r"\s*[\[(](.*)[\])]\s*", re.S)
_BYTE_ORDER_MARKS = {
    codecs.BOM_UTF8: "utf-8-sig",
    codecs.BOM_UTF32_LE: "utf-32",  # before UTF-16, whose mark is its beginning
    codecs.BOM_UTF16_LE: "utf-16",
    codecs.BOM_UTF16_BE: "utf-16",
}


@dataclass(frozen=True)
class Table:
    """A table as it stands in a file; its rows count from 1, without the header.

    Attributes
    ----------
    name : str
        The file's name, for messages.
    header : tuple of str
        The titles of the columns; empty if there is no header.
    rows : list of list of str, or array (n, m)
        The cells; an array if the file was NPY.
    remark : str
        What is said of the file beside its columns, for example ", decimal comma".
    transposed : bool
        Whether rows and columns are exchanged against those of the file.
    """

    name: str
    header: tuple
    rows: object
    remark: str = ""
    transposed: bool = False

    @property
    def width(self):
        """The number of columns."""
        return len(self.rows[0])

    @cached_property
    def decimal_comma(self):
        """Whether a cell, in whatever row, is a number with a decimal comma."""
        if isinstance(self.rows, np.ndarray):
            return False
        return any(
            "," in cell and _DECIMAL_COMMA.fullmatch(cell) for row in self.rows for cell in row
        )

    def title(self, place):
        """Return the title of a column, or its number, which counts from 1, if there is no
        header."""
        return self.header[place] if self.header else str(place + 1)

    def where(self, row, place, label):
        """Return where a cell stands in the file, for messages; label: what its column is
        called."""
        if self.transposed:
            return f"row {place + 1}, column {row + 1}"
        return f"row {row + 1}, {label}"

    def with_samples_as_rows(self, k):
        """Return the table of k joints with samples as rows; they may be columns if it has no
        header.

        With k = None, or if columns fit as well, the table stays.
        """
        rows, columns = len(self.rows), self.width
        if self.header or k is None or rows != k or columns == k:
            return self
        values = np.column_stack([self.values(i, f"column {i + 1}") for i in range(columns)])
        return replace(self, rows=values.T, transposed=True)

    def cells(self, place):
        """Return the cells of a column as text."""
        return [str(row[place]) for row in self.rows]

    def numeric(self, place):
        """Return whether a column holds numbers."""
        if isinstance(self.rows, np.ndarray):
            return True
        return any(is_number(row[place]) for row in self.rows[:_SAMPLE])

    def values(self, place, label):
        """Return a column as floats (n,), or refuse the first cell that is no number.

        label: what the message calls the column.
        """
        if isinstance(self.rows, np.ndarray):
            return self.rows[:, place].astype(float)
        cells = self.cells(place)
        if self.decimal_comma:
            self._refuse_decimal_points(place, label)
            cells = [cell.replace(",", ".") for cell in cells]
        try:
            # float() also reads 1_000, which no program writes for a number.
            if not any("_" in cell for cell in cells):
                return np.array(cells, float)
        except ValueError:
            pass
        row = next(i for i, cell in enumerate(cells) if not _NUMBER.fullmatch(cell))
        cell = str(self.rows[row][place])
        raise ValueError(
            f"{self.name}: row {row + 1}, {label} is {cell!r:.40}, which is not a number"
        )

    def _refuse_decimal_points(self, place, label):
        point = next((i for i, row in enumerate(self.rows) if "." in row[place]), None)
        if point is None:
            return
        commas = ((i, cell) for i, row in enumerate(self.rows) for cell in row)
        comma = next((i, cell) for i, cell in commas if _DECIMAL_COMMA.fullmatch(cell))
        raise ValueError(
            f"{self.name}: row {point + 1}, {label} is {self.rows[point][place]!r:.40}, with a"
            f" point, and row {comma[0] + 1} has {comma[1]!r:.40}, with a comma. Write all decimals"
            " in one way, and no separators of thousands"
        )


def read_table(path):
    """Return the Table in a file, with the lists in its cells spread over columns.

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
    return _spread_lists(_read_text(path))


def is_number(cell):
    """Return whether a cell is a number, with a decimal point or a decimal comma."""
    return bool(_NUMBER.fullmatch(cell) or _DECIMAL_COMMA.fullmatch(cell))


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
    return Table(path.name, (), table)


def _decoded(data):
    """Return the text of a file: by its byte order mark, else UTF-8, UTF-16 or Windows' Western
    code page."""
    for mark, encoding in _BYTE_ORDER_MARKS.items():
        if data.startswith(mark):
            return data.decode(encoding, "replace")
    # UTF-16 without a mark has a null byte in nearly every digit, always on the same side.
    even, odd = data[:200:2], data[1:200:2]
    if 2 * odd.count(0) > len(odd) and not even.count(0):
        return data.decode("utf-16-le", "replace")
    if 2 * even.count(0) > len(even) and not odd.count(0):
        return data.decode("utf-16-be", "replace")
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError:
        return data.decode("cp1252", "replace")  # as spreadsheets write


def _split(lines, separator):
    """Return the cells of lines, without the spaces around them."""
    if separator == " ":
        lines = [" ".join(line.split()) for line in lines]
    else:
        lines = [line.strip(" ") + "\n" for line in lines]
    # A quoted cell may hold a whole message; the standard limit of 131,072 characters is enough.
    cells = csv.reader(lines, delimiter=separator, skipinitialspace=True)
    try:
        return [[cell.strip() for cell in row] for row in cells if row]
    except csv.Error as unreadable:
        raise ValueError(f"cannot be read as a table: {unreadable}") from unreadable


def _share_of_numbers(lines, separator):
    """Return how well a separator fits: the share of cells that are numbers, in rows of the
    commonest width."""
    try:
        rows = _split(lines, separator)
    except ValueError:
        return 0.0
    if not rows:
        return 0.0
    (width, count), *_ = Counter(map(len, rows)).most_common(1)
    if width < 2:
        return 0.0
    # An empty cell belongs to a table, too: a text that is missing, or a sample.
    fitting = [cell for row in rows if len(row) == width for cell in row]
    good = sum(is_number(cell) or not cell or bool(_LIST.fullmatch(cell)) for cell in fitting)
    return good / len(fitting) * count / len(rows)


def _separator(lines):
    """Return the separator of columns that fits best; of equals the one least likely to be part of
    a number."""
    sample = lines[: _SAMPLE // 2] + lines[-_SAMPLE // 2 :]
    return max(_SEPARATORS, key=lambda separator: _share_of_numbers(sample, separator))


def _read_text(path):
    lines = re.split(r"\r\n|\r|\n", _decoded(path.read_bytes()).lstrip("\ufeff"))
    separator = None
    if declared := re.fullmatch(r'"?sep=(.)"?', lines[0].strip(" "), re.I):  # as Excel writes
        separator, lines = declared[1], lines[1:]
    lines = [line for line in lines if line.strip(" ,;\t|")]
    comments = [line.lstrip("#% ") for line in lines if line.startswith(("#", "%"))]
    body = [line for line in lines if not line.startswith(("#", "%"))]
    separator = separator or _separator(body)
    try:
        rows = _split(body, separator)
    except ValueError as unreadable:
        raise ValueError(f"{path.name} {unreadable}") from unreadable
    counted = bool(rows) and _counts_columns(rows[0])
    first = next((i for i, row in enumerate(rows) if i >= counted and _holds_numbers(row)), None)
    if first is None:
        raise ValueError(
            f"{path.name} cannot be read as a table: it must hold a row of numbers, and holds none"
        )
    header, data = _header(rows[:first], rows[first:], body[:first], comments, separator)
    header, data = _without_empty_last_columns(header, data)
    table = Table(path.name, tuple(header), data)
    _refuse_ragged(table)
    return replace(table, remark=", decimal comma" if table.decimal_comma else "")


def _holds_numbers(row):
    """Return whether a row is one of data: some of its cells are numbers, or lists."""
    return any(is_number(cell) or _LIST.fullmatch(cell) for cell in row)


def _counts_columns(row):
    """Return whether a row is the header of a table without titles, as pandas writes it: 0, 1, 2, 3
    ..."""
    counted = [str(i) for i in range(len(row))]
    return (len(row) > 3 and row == counted) or (len(row) > 1 and row == ["", *counted[:-1]])


def _header(before, data, lines_before, comments, separator):
    """Return the titles of the columns, [] if there are none, and the rows of data.

    before: the rows before the first row of data; lines_before: their lines; comments: the
    commented lines of the file.
    """
    width = len(data[0])
    (common, _), *_ = Counter(map(len, data)).most_common(1)
    if len(before) > 1 and len(before[-2]) == width and _is_unit_row(before[-1]):
        *_, titles, units = before
        pairs = zip(titles, units, strict=False)
        return [f"{title} [{unit}]" if unit else title for title, unit in pairs], data
    if before and len(before[-1]) in (width, common):
        return before[-1], data
    # Perhaps the header is a comment, or its separator differs from that of the rows.
    for line in [*lines_before[::-1], *comments[::-1]]:
        for other in (separator, ",", ";", "\t", " "):
            titles = _split([line], other)
            if titles and len(titles[0]) == width and not _holds_numbers(titles[0]):
                return titles[0], data
    return (before[-1] if before else []), data


def _is_unit_row(row):
    bare = [cell.strip("[]()").lower() for cell in row if cell]
    units = {"s", "ms", "us", "µs", "ns", "rad", "deg", "°", "rad/s", "deg/s", "°/s", "-", "nm"}
    return bool(bare) and set(bare) <= units


def _without_empty_last_columns(header, data):
    """Leave out columns at the end that only a separator at the end of each line makes."""
    while len(data[0]) > 1 and all(len(row) == len(data[0]) and not row[-1] for row in data):
        if len(header) == len(data[0]):
            if header[-1]:
                break
            header = header[:-1]
        data = [row[:-1] for row in data]
    if len(header) == len(data[0]) + 1 and not header[-1]:
        header = header[:-1]
    return header, data


def _refuse_ragged(table):
    width = len(table.header) or table.width
    for number, row in enumerate(table.rows):
        if len(row) != width:
            cut_off = number and number == len(table.rows) - 1 and len(row) < width
            reason = ": is the file cut off?" if cut_off else ""
            if table.header and number == 0:
                reason = f"; its header is {','.join(table.header):.80}"
            raise ValueError(
                f"{table.name}: row {number + 1} has {len(row)} columns, not {width}{reason}"
            )


def _spread_lists(table):
    """Return a table in which a column of lists, such as "[0.1, 0.2]", is a column for each entry.

    rosbag's tools and pandas write the arrays of a message in this way.
    """
    if isinstance(table.rows, np.ndarray) or not table.header:
        return table
    places = [i for i in range(table.width) if _LIST.fullmatch(table.rows[0][i])]
    if not places:
        return table
    columns, header = [], []
    for place, title in enumerate(table.header):
        cells = table.cells(place)
        lists = [_list_entries(cell) for cell in cells] if place in places else [None]
        lengths = {None if entries is None else len(entries) for entries in lists}
        if len(lengths) != 1 or None in lengths or 0 in lengths:
            header.append(title)
            columns.append(cells)
            continue
        for i, entries in enumerate(zip(*lists, strict=True)):
            header.append(f"{title}[{i}]")
            columns.append(entries)
    rows = [list(row) for row in zip(*columns, strict=True)]
    return replace(table, header=tuple(header), rows=rows)


def _list_entries(cell):
    """Return the entries of a list in a cell, or None if it is not one."""
    inside = _LIST.fullmatch(cell)
    if not inside or "..." in cell:  # numpy leaves the middle of a long array out
        return None
    inner = inside[1].strip()
    entries = inner.split(",") if "," in inner else inner.split()
    return [entry.strip(" '\"\n") for entry in entries]
