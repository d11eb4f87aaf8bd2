"""The questions that load asks if it is not clear which columns are the joints."""

import re

from course_lib.trajectory.refusals import quoted, unclear


def no_joints(table, columns):
    """Return the question which columns are the joints, if no title says so."""
    unknown = [
        column
        for column in columns
        if column.quantity == "unknown" and column.title and table.numeric(column.place)
    ]
    families = _families(unknown)
    if families:
        patterns = ", ".join(quoted(pattern) for pattern in families)
        return unclear(
            table,
            "no title says that a column holds the angle of a joint. Numbered columns:"
            f" {patterns}.",
            columns,
            'If some are joint angles, write them, for example columns={"q": '
            f"{quoted(families[0])}}}; * is for the numbers.",
        )
    if unknown:
        return unknown_order(table, columns, unknown)
    return unclear(
        table,
        "column q1 is missing: no title says that a column holds the angle of a joint.",
        columns,
        'If some do, write columns={"q1": "title", "q2": "title", ...} in the order of the joints.',
    )


def _families(columns):
    """Return the patterns of titles that differ by a number alone, for two titles or more."""
    numbered = {}
    for column in columns:
        if match := re.fullmatch(r"(.*?\D)(\d+)(\D*)", column.title):
            numbered.setdefault(f"{match[1]}*{match[3]}", []).append(int(match[2]))
    return [
        pattern
        for pattern, numbers in numbered.items()
        if len(numbers) > 1 and sorted(numbers) == list(range(min(numbers), max(numbers) + 1))
    ]


def unknown_order(table, columns, named):
    """Return the question which order joints with names have."""
    names = quoted([re.sub(r".*\((.*)\)", r"\1", column.title) for column in named])
    return unclear(
        table,
        "no number or known name says which columns are the joints, or in which order.",
        columns,
        f"If these are the joints, write them from the base to the end-effector: joints={names}.",
    )


def several_sets(table, columns, sets, velocities, what, unclear_columns=()):
    """Return the question which of several sets of columns holds the joints."""
    several, plural = (sets, "angles") if what == "angle" else (velocities, "velocities")
    named = [_pattern(numbers) for numbers in several]
    if unclear_columns:
        named.append(_pattern({column.number: [column] for column in unclear_columns}))
    first = [f'"q": {_pattern(sets[0]) if sets else named[0]}']
    if velocities:
        first.append(f'"qd": {_pattern(velocities[0])}')
    return unclear(
        table,
        f"{len(named)} sets of columns may hold the joint {plural}: {', '.join(named)}.",
        columns,
        f"Write the right one, for example columns={{{', '.join(first)}}}; * is for the numbers.",
    )


def _pattern(numbers):
    """Return the titles of a set as one pattern, such as "actual_q_*", or as a list."""
    titles = [(number, found[0].title) for number, found in numbers.items()]
    patterns = set()
    for number, title in titles:
        before, mark, after = title.rpartition(str(number))
        patterns.add(f"{before}*{after}" if mark else title)
    if len(patterns) == 1 and None not in numbers:
        return quoted(patterns.pop())
    return quoted([column.title for found in numbers.values() for column in found])
