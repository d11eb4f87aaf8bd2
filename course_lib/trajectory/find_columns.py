"""Which columns of a table are times, joint angles and velocities: as their titles or the user say,
or a question."""

import re
from dataclasses import dataclass, replace

import numpy as np

from course_lib.trajectory.column_names import (
    KIND_OF,
    Column,
    column_of_words,
    kind_of,
    understand,
    words_of,
)
from course_lib.trajectory.understood import example, no_joints, pattern_of, quoted, unclear

# Names of joints from the base to the end-effector, as these arms' makers give them: Universal
# Robots' ROS description and teach pendant, Rethink's Sawyer and Baxter.
_NAMED_ARMS = (
    ("shoulder_pan", "shoulder_lift", "elbow", "wrist_1", "wrist_2", "wrist_3"),
    ("base", "shoulder", "elbow", "wrist_1", "wrist_2", "wrist_3"),
    ("s0", "s1", "e0", "e1", "w0", "w1", "w2"),
)
_MEANING = {"q": "joint angles", "qd": "joint velocities"}
_NO_HEADER = ", no header"


@dataclass(frozen=True)
class FoundColumns:
    """The columns of a trajectory: one of times, or those of seconds and of nanoseconds, and one of
    each joint's angles and velocities, from the base.

    remark: what else is to be said, for example that there is no header. unused: other columns.
    """

    t: tuple
    q: tuple
    qd: tuple
    remark: str = ""
    unused: tuple = ()


def find_columns(table, joint_count, has_step, joints=None, chosen=None):
    """Return the FoundColumns of a table, or ask.

    joint_count: the number of joints, or None. has_step: whether the user gave the time step.
    joints, chosen: the arguments `joints` and `columns` of load.
    """
    columns, remark = _understood_columns(table)
    places = _chosen_places(table, chosen or {})
    t, q, qd = ([columns[place] for place in places[kind]] for kind in ("t", "q", "qd"))
    if not table.header and not remark and not q:
        t, q, qd = _without_header(table, columns, joint_count, has_step)
        remark = _NO_HEADER
    if not t and not has_step:
        t = _times(table, columns)
    if not q:
        q, qd = _joints(table, columns, joints)
    used = {column.place for column in (*t, *q, *qd)}
    unused = [c for c in columns if c.place not in used and table.holds_numbers(c.place)]
    return FoundColumns(tuple(t), tuple(q), tuple(qd), remark, tuple(unused))


def find_velocities(table, joints=None, chosen=None):
    """Return the columns of the velocities, from the base, in a file that holds no positions, or
    ask.

    joints: the argument `joints` of load. chosen: the entries of its `columns` for velocities.
    """
    columns, remark = _understood_columns(table)
    if chosen:
        places = _chosen_places(table, chosen, needed="qd")
        return [columns[place] for place in places["qd"]]
    if not table.header and not remark:
        return columns
    # A program that writes both files may give both the same titles, such as q1 or joint_1.
    if all(column.kind != "qd" for column in columns):
        columns = [replace(c, kind="qd") if c.kind == "q" else c for c in columns]
    sets = _joint_sets(table, columns, joints)
    return _only_set(table, columns, sets.get("qd") or sets.get("q", []), "qd")


def _understood_columns(table):
    """Return the columns of a table, as their titles say or the rows of a ROS 2 message, and a
    remark if such rows have no titles."""
    titles, remark = table.header, ""
    if not titles and (titles := _titles_of_ros2(table)):
        remark = _NO_HEADER
    columns = [understand(i, title) for i, title in enumerate(titles)]
    columns = _named_by_rows(table, columns)
    if titles[:2] == ("duration", "success_rate"):  # libfranka's log, which counts milliseconds
        columns[0] = replace(columns[0], kind="t", unit="ms")
    if not columns:
        columns = [Column(i, str(i + 1)) for i in range(table.width)]
    return columns, remark


def _times(table, columns):
    """Return the column of times, or those of seconds and nanoseconds."""
    clocks = [column for column in columns if column.kind == "t"]
    # The program's own clock comes before those of the messages that it writes.
    plain = [clock for clock in clocks if clock.words in (("t",), ("time",))]
    if len(plain) == 1:
        return plain
    parts = {column.unit: column for column in clocks}
    if set(parts) >= {"s", "ns"} and parts["s"].words == parts["ns"].words:
        return [parts["s"], parts["ns"]]
    if len(clocks) == 1:
        return clocks
    if clocks:
        names = [quoted(clock.title) for clock in clocks]
        raise unclear(
            table,
            columns,
            f"{len(clocks)} columns hold times: {', '.join(names)}.",
            f'Write which one, for example columns={{"t": {names[0]}}}.',
        )
    others = [column.place for column in columns if not column.kind]
    one_does = ""
    if others:
        one_does = f'If one does, write columns={{"t": {example(table, others[0])}}}. '
    raise unclear(
        table,
        columns,
        "column t is missing: no title says that a column holds times.",
        f"{one_does}If samples are evenly spaced, write the time between two of them in seconds, "
        "step=0.01.",
    )


def _joints(table, columns, joints):
    """Return the columns of the angles and of the velocities, from the base."""
    sets = _joint_sets(table, columns, joints)
    angles = _only_set(table, columns, sets.get("q", []), "q")
    return angles, _of_these_joints(table, columns, angles, sets.get("qd", []))


def _joint_sets(table, columns, joints):
    """Return {kind: sets} of columns, each with a column for every joint.

    joints: the argument of load.
    """
    if joints is None:
        sets = _numbered_sets(table, columns)
        for names in _NAMED_ARMS:
            named = _named_sets(columns, names)
            if "q" in named and "q" not in sets:
                sets = named
    else:
        sets = _named_sets(columns, joints)
        missing = [name for name in joints if not _columns_of_name(columns, name)]
        if missing:
            raise unclear(
                table,
                columns,
                f"joints names {missing[0]!r}, and no column has this name.",
                "Write the names as they stand in the file, from the base to the end-effector.",
            )
    return sets


def _only_set(table, columns, sets, kind):
    """Return the columns of the only one of these sets, or ask; kind: "q" or "qd"."""
    if not sets:
        raise no_joints(table, columns, kind)
    first = pattern_of(sets[0])
    if len(sets) > 1:
        raise unclear(
            table,
            columns,
            f"{len(sets)} sets of columns may hold the {_MEANING[kind]}: "
            f"{', '.join(pattern_of(joint_set) for joint_set in sets)}.",
            f'Write the right one, for example columns={{"{kind}": {first}}}; * is for the '
            "numbers.",
        )
    if _are_quaternions(table, sets[0]):
        raise unclear(
            table,
            columns,
            f"{first} are four columns whose squares add up to 1 in each row, as those of a "
            "quaternion do.",
            f'If they are {_MEANING[kind]}, write columns={{"{kind}": {first}}}.',
        )
    return sets[0]


def _are_quaternions(table, columns):
    """Return whether these columns are four, and the sum of their squares is 1 in each row."""
    if len(columns) != 4:
        return False
    values = [table.numbers(column.place, f"column {column.title}") for column in columns]
    return bool((np.abs(np.linalg.norm(values, axis=0) - 1) < 1e-3).all())


def _numbered_sets(table, columns):
    """Return {kind: sets}: columns whose titles differ by their numbers alone, in their order."""
    of_pattern = {}
    for column in columns:
        if column.kind in ("q", "qd") and column.number is not None:
            of_pattern.setdefault((column.kind, column.pattern), []).append(column)
    sets = {}
    for (kind, _), joint_set in of_pattern.items():
        joint_set.sort(key=lambda column: column.number)
        sets.setdefault(kind, []).append(joint_set)
    only_sets = {kind: of_kind[0] for kind, of_kind in sets.items() if len(of_kind) == 1}
    numbers = {column.number for joint_set in only_sets.values() for column in joint_set}
    for kind, joint_set in only_sets.items():
        _refuse_gaps(table, columns, kind, joint_set, numbers)
    return sets


def _refuse_gaps(table, columns, kind, joint_set, numbers):
    """Refuse the first joint that has no column, or two; numbers: of all joints in the file."""
    start = 0 if 0 in numbers else 1
    by_number = {number: [] for number in range(start, max(numbers) + 1)}
    for column in joint_set:
        by_number[column.number].append(column)
    wrong = [number for number, same in by_number.items() if len(same) != 1]
    if not wrong:
        return
    joint = f"column {kind}{wrong[0] + 1 - start}"
    problem = f"{joint} is missing."
    if by_number[wrong[0]]:
        twice = [str(column.place + 1) for column in by_number[wrong[0]]]
        problem = f"{joint} occurs twice: columns {' and '.join(twice)} have this title."
    # A column without a title may be the one that is missing; of two, the first is shown.
    places = [column.place for column in joint_set]
    shown = [same[0].place for same in by_number.values() if same]
    shown += [c.place for c in columns if not c.title and min(places) < c.place < max(places)]
    line = ", ".join(example(table, place) for place in sorted(shown))
    raise unclear(
        table,
        columns,
        problem,
        "Write all joints from the base, each by title or by number from 1, for example "
        f'columns={{"{kind}": [{line}]}}.',
    )


def _named_sets(columns, names):
    """Return {kind: sets} of columns whose titles differ by these names alone."""
    of_pattern = {}
    for i, name in enumerate(names):
        for column, pattern in _columns_of_name(columns, name):
            kind = kind_of(pattern, has_name=True)
            kind = "qd" if kind and column.unit in ("rad/s", "deg/s", "rpm") else kind
            of_pattern.setdefault((kind, pattern), {}).setdefault(i, []).append(column)
    sets = {}
    for (kind, _), by_joint in of_pattern.items():
        is_whole = len(by_joint) == len(names)
        if kind and is_whole and all(len(same) == 1 for same in by_joint.values()):
            sets.setdefault(kind, []).append([by_joint[i][0] for i in range(len(names))])
    return sets


def _columns_of_name(columns, name):
    """Return the columns with the words of a joint's name, and their words with * for the name."""
    wanted = words_of(name)
    if wanted[-1:] == ("joint",):
        wanted = wanted[:-1]
    matches = []
    for column in columns:
        words, size = column.words, len(wanted)
        for at in range(len(words) - size + 1):
            if words[at : at + size] == wanted:
                matches.append((column, (*words[:at], "*", *words[at + size :])))
                break
    return matches


def _of_these_joints(table, columns, angles, sets):
    """Return the velocities of these joints, of which there may be none, or ask."""
    if not sets:
        return []
    if len(sets) == 1 and len(sets[0]) == len(angles):
        return sets[0]
    raise unclear(
        table,
        columns,
        "it is not clear which columns are the velocities of these joints.",
        f'Write them, for example columns={{"q": {pattern_of(angles)}, '
        f'"qd": {pattern_of(sets[0])}}}.',
    )


def _named_by_rows(table, columns):
    """Return the columns, with the names of joints that stand beside the numbers of a message."""
    names = {}
    for column in columns:
        if column.kind != "name" or column.number is None:
            continue
        cells = table.cells(column.place)
        if len(set(cells)) > 1:
            row = next(i for i, cell in enumerate(cells) if cell != cells[0])
            raise unclear(
                table,
                columns,
                f"the joints change their places: {column.title} is {cells[0]!r} in row 1 and "
                f"{cells[row]!r} in row {row + 1}.",
                "Write the file with one order of the joints.",
            )
        names[column.number] = cells[0]
    named = []
    for column in columns:
        values = {word for word in column.pattern if KIND_OF.get(word) in ("q", "qd")}
        if column.kind == "name" or not values or not names.get(column.number):
            named.append(column)
            continue
        name = names[column.number]
        beside = [word for word in column.pattern if word != "*"]
        words = (*beside, *words_of(name))
        named.append(column_of_words(column.place, f"{column.title} ({name})", words))
    return named


def _titles_of_ros2(table):
    """Return titles for what `ros2 topic echo --csv` writes of sensor_msgs/JointState, or ().

    There is no header, and the fields stand in the message's order: sec, nanosec, frame_id, names,
    positions, and, where they are filled, velocities and efforts.
    """
    row = table.rows[0]
    joint_count = 0
    for place in range(3, table.width):
        if table.holds_numbers(place) or not row[place]:
            break
        joint_count += 1
    rest = table.width - 3 - joint_count
    begins = (
        table.width > 3 and row[0].isdigit() and row[1].isdigit() and not table.holds_numbers(2)
    )
    if not begins or not joint_count or rest not in (joint_count, 3 * joint_count):
        return ()
    kinds = ("name", "position", "velocity", "effort")[: 1 + rest // joint_count]
    return (
        "sec",
        "nanosec",
        "frame_id",
        *(f"{kind}_{i}" for kind in kinds for i in range(joint_count)),
    )


def _without_header(table, columns, joint_count, has_step):
    """Return the columns of a table without header: t, q1 ... qk and perhaps qd1 ... qdk.

    With a time step there are no times, and the file holds positions alone.
    """
    if has_step and joint_count in (None, table.width):
        return [], columns, []
    k = joint_count
    problem = (
        "it must begin with a header, or hold t, q1 ..., qd1 ... of as many joints as limits has: "
        f"column t is missing, or others; its shape is ({len(table.rows)}, {table.width})."
    )
    if table.width in (7, 8) and _are_quaternions(table, columns[-4:]):
        problem = "it looks like poses, because its last four columns are unit quaternions."
    elif k is not None and table.width in (1 + k, 1 + 2 * k) and not has_step:
        return columns[:1], columns[1 : k + 1], columns[k + 1 :]
    raise unclear(
        table,
        [],
        problem,
        'Write the columns by their numbers, from 1: columns={"t": 1, "q1": 2, "q2": 3, ...}. For '
        "positions alone, give the time step, and the file of the velocities if any: step=0.01, "
        'velocities="a second file".',
    )


# Columns that the user chose
# -------------------------------------------------------------------------------------------------


def _chosen_places(table, chosen, needed="q"):
    """Return {"t": places, "q": places, "qd": places} of the argument `columns`.

    needed: of which kind there must be a column for each joint that the argument names.
    """
    numbered = {"t": {}, "q": {}, "qd": {}}
    for key, value in chosen.items():
        parted = re.fullmatch(r"(t|qd?)([1-9]\d*)?", key) if isinstance(key, str) else None
        if not parted or (parted[1] == "t" and parted[2]):
            raise ValueError(
                f'columns must have keys such as "t", "q1" and "qd1"; one is {key!r:.40}'
            )
        places = _places(table, key, value)
        kind, number = parted[1], parted[2]
        if kind == "t" and len(places) > 2:
            raise ValueError('columns["t"] must be one column, or those of seconds and nanoseconds')
        if number and len(places) != 1:
            raise ValueError(f"columns[{quoted(key)}] must be one column; it is {value!r:.60}")
        first = int(number or 1)
        numbered[kind] |= {first + i: place for i, place in enumerate(places)}
    count = max([*numbered["q"], *numbered["qd"]], default=0)
    for kind in ("q", "qd"):
        missing = [i for i in range(1, count + 1) if i not in numbered[kind]]
        if missing and (numbered[kind] or kind == needed):
            raise ValueError(
                f"columns must name {kind}1 to {kind}{count}; {kind}{missing[0]} is missing"
            )
    return {kind: [places[i] for i in sorted(places)] for kind, places in numbered.items()}


def _places(table, key, value):
    """Return the places of one entry of `columns`: of titles, of numbers, or of a pattern."""
    values = list(value) if isinstance(value, list | tuple) else [value]
    is_pattern = len(values) == 1 and isinstance(values[0], str) and "*" in values[0]
    if is_pattern and values[0] not in table.header:
        return _matching(table, key, values[0])
    return [_place(table, key, value) for value in values]


def _place(table, key, value):
    where = f"columns[{quoted(key)}]"
    if isinstance(value, int | np.integer) and not isinstance(value, bool):
        if not 1 <= value <= table.width:
            raise ValueError(
                f"{where} is {value}: columns count from 1, and {table.name} has {table.width}"
            )
        return int(value) - 1
    if not isinstance(value, str):
        raise ValueError(f"{where} must be a title or a number from 1; it is {value!r:.60}")
    # The mark of a comment before the first title is not part of it.
    places = [i for i, title in enumerate(table.header) if title == value.lstrip("#% ")]
    if len(places) > 1:
        numbers = " or ".join(str(place + 1) for place in places)
        raise ValueError(
            f"{table.name}: {where} is {value!r}, a title that occurs {len(places)} times: write"
            f" the column's number, {numbers}"
        )
    if not places:
        raise unclear(
            table,
            [understand(i, title) for i, title in enumerate(table.header)],
            f"{where} is {value!r}, and no column has this title.",
            "Write a title as it stands in the header, or the number of a column, from 1.",
        )
    return places[0]


def _matching(table, key, pattern):
    """Return the places of the titles that a pattern such as "actual_q_*" matches, by number."""
    before, _, after = pattern.partition("*")
    form = re.compile(rf"{re.escape(before)}(\d+){re.escape(after)}")
    matches = []
    for place, title in enumerate(table.header):
        if match := form.fullmatch(title):
            matches.append((int(match[1]), place))
    matches.sort()
    numbers = [number for number, _ in matches]
    first = min(numbers, default=2)
    matched = ", ".join(table.header[place] for _, place in matches) or "none"
    if first > 1 or numbers != list(range(first, first + len(numbers))):
        raise ValueError(
            f"columns[{quoted(key)}] is {pattern!r}: it must match titles with all numbers from 0"
            f" or 1 on, each once; it matches {matched}"
        )
    return [place for _, place in matches]
