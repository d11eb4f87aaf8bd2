"""What is said of a file: what was understood of it, and the question about what is not clear."""

import json
import re

import numpy as np


class UnclearFileError(ValueError):
    """A file can be understood in more than one way, or in none: its message says what to write."""


def unclear(table, columns, problem, advice):
    """Return an UnclearFileError: the problem, the header, what was understood, what to write."""
    lines = [f"{table.name}: {problem}"]
    if table.header:
        header = ",".join(table.header)
        lines.append(f"  header: {_shortened(header, 300)}")
    if columns:
        lines.append(f"  understood: {_shortened(_understood(table, columns), 700)}")
    lines.append(f"  {advice}")
    return UnclearFileError("\n".join(lines))


def _understood(table, columns):
    """Return what was understood of each column; neighbours of one set are named together."""
    words = {"t": "time", "q": "joint angle", "qd": "joint velocity", "name": "names of joints"}
    groups = []
    for column in columns:
        meaning = words.get(column.kind)
        if meaning is None:
            meaning = "not known" if table.holds_numbers(column.place) else "text"
        if column.unit:
            meaning += f" in {column.unit.removeprefix('?')}"
        if groups and groups[-1][0] == meaning:
            groups[-1][1].append(column)
        else:
            groups.append((meaning, [column]))
    parts = []
    for meaning, group in groups:
        names = [column.title or f"(no title, column {column.place + 1})" for column in group]
        several = f"{names[0]} to {names[-1]} ({len(names)} columns)"
        parts.append(f"{names[0] if len(names) == 1 else several}: {meaning}")
    return "; ".join(parts)


def no_joints(table, columns, kind):
    """Return the question which columns are the joints, with the line for those of the file.

    kind: "q" if angles are missing, "qd" if velocities are.
    """
    unknown = [c for c in columns if c.kind in ("", "q", "qd") and table.holds_numbers(c.place)]
    meaning = {"q": "angle", "qd": "velocity"}[kind]
    problem = (
        f"column {kind}1 is missing: no title says that a column holds the {meaning} of a joint."
    )
    labels = [c for c in columns if c.words and set(c.words) <= {"joint", "name", "joints"}]
    if labels and not table.holds_numbers(labels[0].place):
        return unclear(
            table,
            columns,
            f"it has a row for each joint, named by {labels[0].title!r}, and must have a row for"
            " each time, with a column for each joint.",
            f"Write it anew, for example with pandas: table.pivot(index=..., columns="
            f"{quoted(labels[0].title)}, values=...).",
        )
    of_pattern = {}
    for column in unknown:
        if column.number is not None:
            of_pattern.setdefault(column.pattern, []).append(column)
    families = [pattern_of(same) for same in of_pattern.values() if len(same) > 1]
    if families:
        return unclear(
            table,
            columns,
            f"{problem} Numbered columns: {', '.join(families)}.",
            f"If each holds the {meaning} of a joint, write them, for example "
            f'columns={{"{kind}": {families[0]}}}; * is for the numbers.',
        )
    if kind == "qd" and table.header:
        written = ", ".join(example(table, column.place) for column in unknown)
        return unclear(
            table,
            columns,
            problem,
            "If these are the joints, write them from the base to the end-effector: "
            f'columns={{"qd": [{written}]}}.',
        )
    titled = [re.sub(r".*\((.*)\)", r"\1", column.title) for column in unknown if column.title]
    if titled:
        return unclear(
            table,
            columns,
            problem,
            "If these are the joints, write them from the base to the end-effector: "
            f"joints={quoted(titled)}.",
        )
    return unclear(
        table,
        columns,
        problem,
        'If some do, write their numbers, in the order of the joints: columns={"q": [2, 3, ...]}.',
    )


def pattern_of(joint_set):
    """Return the titles of a set as one pattern, such as "actual_q_*", or as a list."""
    patterns = set()
    for column in joint_set:
        before, mark, after = column.title.rpartition(str(column.number))
        patterns.add(f"{before}*{after}" if mark else column.title)
    return quoted(patterns.pop() if len(patterns) == 1 else [column.title for column in joint_set])


def example(table, place):
    """Return a column as the user may write it: its title, or its number if it has none."""
    titles = table.header
    unique = titles and titles[place] and titles.count(titles[place]) == 1
    return quoted(titles[place]) if unique else str(place + 1)


def quoted(value):
    """Return a value as it is written in Python, with double quotes."""
    return json.dumps(value, ensure_ascii=False)


def _shortened(text, size):
    """Return a text of at most `size` characters, from which the middle is left out."""
    return text if len(text) <= size else f"{text[: size - 40]} ... {text[-35:]}"


# What was understood
# -------------------------------------------------------------------------------------------------


def column_label(name, column):
    """Return what a message calls a column: its name here, and its title if that is another one."""
    if column.title.isdigit():  # there is no header
        return f"column {column.title}"
    return f"column {name}" if name == column.title else f"column {name} ({column.title!r})"


def summary(rows, time_said, q_columns, velocity_count, decimal_comma, remark):
    """Return the first line: how many rows, times, angles and velocities, their units, and how the
    numbers are written.

    remark: what else is to be said of the file, from its comma on, or "".
    """
    k = len(q_columns)
    units = " and ".join(sorted({column.unit or "rad" for column in q_columns}))
    velocities = "no velocities (differences of the samples)"
    if velocity_count:
        velocities = f"{velocity_count} velocit{'ies' if velocity_count > 1 else 'y'}"
    comma = ", decimal comma" if decimal_comma else ""
    angles = f"{k} angle{'s' * (k > 1)} in {units}"
    return f"{rows} rows, {time_said}, {angles}, {velocities}{comma}{remark}"


def came_from(columns):
    """Return from which columns times came, with the unit."""
    titles = " and ".join(f"{column.title!r}" for column in columns)
    if len(columns) == 2:
        return f"{titles}, seconds and nanoseconds"
    unit = "no unit in the header" if columns[0].unit is None else columns[0].unit
    return f"{titles}, {unit}"


def joint_lines(q_columns, qd_columns, q):
    """Return a line for each joint: its columns, its unit, and its range in degrees."""
    lines = []
    for i, column in enumerate(q_columns):
        unit = "no unit in the header" if column.unit is None else column.unit
        low, high = np.rad2deg([q[:, i].min(), q[:, i].max()])
        speed = f"; qd{i + 1}: {qd_columns[i].title!r}" if qd_columns else ""
        reach = f"{low + 0.0:.1f} to {high + 0.0:.1f} degrees"
        lines.append(f"q{i + 1}: {column.title!r}, {unit}, {reach}{speed}")
    return lines


def listed_titles(columns):
    """Return the titles of columns, at most twelve."""
    titles = [column.title or f"column {column.place + 1}" for column in columns]
    if len(titles) > 12:
        titles = [*titles[:6], "...", *titles[-5:]]
    return ", ".join(titles)
