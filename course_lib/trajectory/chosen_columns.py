"""The columns that the user chose, by the argument `columns` of load."""

import re
from dataclasses import replace

import numpy as np

from course_lib.trajectory.clocks import time_of
from course_lib.trajectory.column_names import UNITS
from course_lib.trajectory.joint_sets import joints_of
from course_lib.trajectory.plan import Plan
from course_lib.trajectory.refusals import quoted, unclear


def as_chosen(table, columns, has_step, joints, chosen):
    """Return the Plan of the argument `columns`; what it does not name is found by titles."""
    places = {}
    for key, value in chosen.items():
        places |= _places(table, columns, key, value)
    time = tuple(columns[place] for place in places.get("t", ()))
    time = tuple(replace(column, quantity="time", unit=_kept(column, "time")) for column in time)
    if len(time) == 2:
        time = (replace(time[0], unit="s"), replace(time[1], unit="ns"))
    if not time and not has_step:
        time = time_of(table, columns) if table.header else ()
        if not time:
            raise unclear(
                table,
                "column t is missing: columns names no times.",
                columns,
                'Add "t" to columns, or write the time step, step=0.01.',
            )
    numbered = {"q": {}, "qd": {}}
    for key, (place, *_) in ((key, value) for key, value in places.items() if key != "t"):
        kind = "qd" if key.startswith("qd") else "q"
        numbered[kind][int(key.removeprefix(kind))] = columns[place]
    if not numbered["q"]:
        if not table.header:
            raise ValueError(
                "columns must name the joint angles: q1, q2 ... of a file without header"
            )
        q, qd = joints_of(table, columns, joints, False)
        return Plan(time, q, qd)
    k = max(max(numbers, default=0) for numbers in numbered.values())
    for kind, numbers in numbered.items():
        missing = [i for i in range(1, k + 1) if i not in numbers]
        if missing and numbers:
            raise ValueError(
                f"columns must name {kind}1 to {kind}{k}; {kind}{missing[0]} is missing"
            )
    q, qd = (tuple(numbers[i] for i in sorted(numbers)) for numbers in numbered.values())
    return Plan(time, _as_quantity(q, "position"), _as_quantity(qd, "velocity"))


def _as_quantity(columns, quantity):
    """Return columns that the user chose as those of a quantity."""
    kinds = ("angle",) if quantity == "position" else ("angle", "rate")
    return tuple(
        replace(column, quantity=quantity, unit=_kept(column, *kinds)) for column in columns
    )


def _kept(column, *kinds):
    """Return the unit of a column if it is one of these kinds, else None."""
    return column.unit if UNITS.get(column.unit, ("",))[0] in kinds else None


def _places(table, columns, key, value):
    """Return {"t": places} or {"q1": (place,), ...} for one entry of the argument `columns`."""
    if not isinstance(key, str) or not re.fullmatch(r"t|qd?[1-9]?\d*", key):
        raise ValueError(f'columns must have keys such as "t", "q1" and "qd1"; one is {key!r:.40}')
    values = list(value) if isinstance(value, list | tuple) else [value]
    if key == "t":
        found = tuple(_place(table, columns, key, value) for value in values)
        if len(found) not in (1, 2):
            raise ValueError('columns["t"] must be one column, or those of seconds and nanoseconds')
        return {"t": found}
    if key not in ("q", "qd"):
        if len(values) != 1:
            raise ValueError(f"columns[{quoted(key)}] must be one column; it is {value!r:.60}")
        return {key: (_place(table, columns, key, values[0]),)}
    if len(values) == 1 and isinstance(values[0], str) and "*" in values[0]:
        values = _matching(table, key, values[0])
    found = [_place(table, columns, key, value) for value in values]
    return {f"{key}{i + 1}": (place,) for i, place in enumerate(found)}


def _place(table, columns, key, value):
    where = f"columns[{quoted(key)}]"
    if isinstance(value, int | np.integer) and not isinstance(value, bool):
        if not 1 <= value <= table.width:
            raise ValueError(
                f"{where} is {value}: columns count from 1, and {table.name} has {table.width}"
            )
        return int(value) - 1
    if not isinstance(value, str):
        raise ValueError(f"{where} must be a title or a number from 1; it is {value!r:.60}")
    places = [place for place, title in enumerate(table.header) if title == value]
    if not places:  # the mark of a comment before the first title is not part of it
        bare = value.lstrip("#% ").lower()
        places = [place for place, title in enumerate(table.header) if title.lower() == bare]
    if len(places) > 1:
        numbers = " or ".join(str(place + 1) for place in places)
        raise ValueError(
            f"{table.name}: {where} is {value!r}, a title that occurs {len(places)} times: write"
            f" the column's number, {numbers}"
        )
    if not places:
        raise unclear(
            table,
            f"{where} is {value!r}, and no column has this title.",
            columns,
            "Write a title as it stands in the header, or the number of a column, from 1.",
        )
    return places[0]


def _matching(table, key, pattern):
    """Return the titles that a pattern such as "actual_q_*" matches, by their numbers."""
    before, _, after = pattern.partition("*")
    form = re.compile(rf"{re.escape(before)}(\d+){re.escape(after)}")
    numbers = {}
    for title in table.header:
        if match := form.fullmatch(title):
            numbers[int(match[1])] = title
    first = min(numbers, default=0)
    if not numbers or sorted(numbers) != list(range(first, first + len(numbers))) or first > 1:
        raise ValueError(
            f"columns[{quoted(key)}] is {pattern!r}: it must match titles with all numbers from 0"
            f" or 1 on; it matches {', '.join(numbers.values()) or 'none'}"
        )
    return [numbers[number] for number in sorted(numbers)]
