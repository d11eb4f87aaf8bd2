"""Which column of a table holds times, or which two: seconds and nanoseconds."""

import re

from course_lib.trajectory.refusals import quoted, unclear

_OWN_CLOCK = {("t",), ("time",)}  # of the program that wrote the row
MAX_SPLIT_NANOSECONDS = 10**9  # a column of nanoseconds beside one of seconds stays below


def time_of(table, columns):
    """Return the column of times, or those of seconds and nanoseconds; () if there is none."""
    clocks = _clocks(table, [column for column in columns if column.quantity == "time"])
    if len(clocks) > 1:  # a stamp that nobody set stays 0
        clocks = [clock for clock in clocks if len(set(table.cells(clock[0].place))) > 1] or clocks
    if len(clocks) > 1:
        own = [clock for clock in clocks if clock[0].words in _OWN_CLOCK]
        clocks = own if len(own) == 1 else clocks
    if len(clocks) > 1:
        names = [quoted(clock[0].title) for clock in clocks]
        raise unclear(
            table,
            f"{len(clocks)} columns hold times: {', '.join(names)}.",
            columns,
            f'Write which one, for example columns={{"t": {names[0]}}}.',
        )
    return clocks[0] if clocks else ()


def _clocks(table, columns):
    """Return the clocks of columns of times: each one column, or one of seconds and one of
    nanoseconds."""
    clocks, taken = [], set()
    for column in columns:
        if column.place in taken:
            continue
        part = next((c for c in columns if _splits(table, column, c)), None)
        if part is not None:
            taken.add(part.place)
            clocks = [clock for clock in clocks if clock[0].place != part.place]
        clocks.append((column,) if part is None else (column, part))
    return clocks


def _splits(table, whole, part):
    """Return whether one column holds whole seconds and the other the nanoseconds that belong to
    them."""
    if (whole.unit, part.unit) != ("s", "ns") or whole.words != part.words:
        return False
    cells = table.cells(part.place)
    if not all(cell.isdigit() and int(cell) < MAX_SPLIT_NANOSECONDS for cell in cells):
        return False
    return all(re.fullmatch(r"-?\d+", cell) for cell in table.cells(whole.place))
