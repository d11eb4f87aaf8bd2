"""The errors that `course_lib.trajectory.load` raises beside plain ValueError; each of them is
one."""

import json


class UnclearFileError(ValueError):
    """A file can be understood in more than one way, or in none: its message says what to write."""


class JointCountError(ValueError):
    """A file has another number of joints than the arm.

    Attributes
    ----------
    found, expected : int
        The number of joints in the file, and that of the limits.
    """

    def __init__(self, name, found, expected):
        joints = f"{found} joint{'s' if found > 1 else ''}"
        super().__init__(f"{name}: this file has {joints}, and limits are given for {expected}")
        self.found, self.expected = found, expected


def unclear(table, problem, columns, advice):
    """Return an UnclearFileError: the problem, the header, what was understood, what to write."""
    lines = [f"{table.name}: {problem}"]
    if table.header:
        lines.append(f"  header: {shortened(','.join(table.header), 300)}")
        lines.append(f"  understood: {shortened(described(table, columns), 700)}")
    lines.append(f"  {advice}")
    return UnclearFileError("\n".join(lines))


def described(table, columns):
    """Return what was understood of each column; neighbours of one kind are named together."""
    parts, group, last = [], [], None
    for column in columns:
        kind = (_meaning(table, column), column.number is not None and column.stem)
        if kind != last and group:
            parts.append(f"{_from_to(group)}: {last[0]}")
            group = []
        group.append(column.title or f"(no title, column {column.place + 1})")
        last = kind
    return "; ".join([*parts, f"{_from_to(group)}: {last[0]}"])


def quoted(value):
    """Return a value as it is written in Python, with double quotes."""
    return json.dumps(value, ensure_ascii=False)


def shortened(text, size):
    """Return a text of at most `size` characters, from which the middle is left out."""
    return text if len(text) <= size else f"{text[: size - 40]} ... {text[-35:]}"


def _from_to(titles):
    return titles[0] if len(titles) == 1 else f"{titles[0]} to {titles[-1]} ({len(titles)} columns)"


def _meaning(table, column):
    kinds = {
        "position": "joint angle",
        "velocity": "joint velocity",
        "time": "time",
        "label": "which joint a row is of",
        "name": "names of joints",
        "unclear": "desired angle, or derivative",
    }
    unit = column.unit or ""
    if unit.startswith("?"):
        return f"{kinds[column.quantity]}, but {unit[1:]} is not one of its units"
    target = (
        "target of a " if column.commanded and column.quantity in ("position", "velocity") else ""
    )
    in_unit = f" in {unit}" if unit else ""
    if column.quantity in kinds:
        return f"{target}{kinds[column.quantity]}{in_unit}"
    if column.quantity == "unknown":
        return "not understood" if table.numeric(column.place) else "text"
    return f"{column.quantity}, no joint angle"
