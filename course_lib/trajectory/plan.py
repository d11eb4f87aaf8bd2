"""Which columns of a table are times, joint angles and velocities: as their titles or the user say, or a question."""

import re
from dataclasses import dataclass, replace

import numpy as np

from course_lib.trajectory.column_names import (
    UNITS,
    only_quantity,
    quantity_beside,
    understand,
    words_of,
)
from course_lib.trajectory.refusals import quoted, unclear

# Names of joints from the base to the end-effector, as these arms' makers give them: Universal
# Robots' ROS description and teach pendant; Yaskawa Motoman; Rethink's Baxter; Hugging Face's SO-101;
# Fetch Robotics.
NAMED_ARMS = (
    ("shoulder_pan", "shoulder_lift", "elbow", "wrist_1", "wrist_2", "wrist_3"),
    ("base", "shoulder", "elbow", "wrist_1", "wrist_2", "wrist_3"),
    ("joint_s", "joint_l", "joint_u", "joint_r", "joint_b", "joint_t"),
    ("joint_s", "joint_l", "joint_e", "joint_u", "joint_r", "joint_b", "joint_t"),
    ("s0", "s1", "e0", "e1", "w0", "w1", "w2"),
    ("shoulder_pan", "shoulder_lift", "elbow_flex", "wrist_flex", "wrist_roll"),
    (
        "shoulder_pan",
        "shoulder_lift",
        "upperarm_roll",
        "elbow_flex",
        "forearm_roll",
        "wrist_flex",
        "wrist_roll",
    ),
)
_OWN_CLOCK = {("t",), ("time",)}  # of the program that wrote the row
_MAX_SPLIT_NANOSECONDS = 10**9  # a column of nanoseconds beside one of seconds stays below


@dataclass(frozen=True)
class Plan:
    """Where things stand in a table.

    Attributes
    ----------
    time : tuple of Column
        One column of times, or one of seconds and one of nanoseconds, or none.
    q, qd : tuple of Column
        One for each joint, from the base; qd is empty without velocities.
    remark : str
        What else is to be said, for example that there is no header.
    unused : tuple of Column
        Columns of numbers that are not used.
    """

    time: tuple
    q: tuple
    qd: tuple
    remark: str = ""
    unused: tuple = ()


def plan_of(table, joint_count, has_step, joints, chosen, want_velocities=False):
    """Return the table, which is another one if it had a row for each joint, and its Plan.

    joint_count: the number of joints, or None. has_step: whether the user gave the time step.
    joints, chosen: the arguments `joints` and `columns` of load, or None. want_velocities: whether
    the file is the one of the velocities.
    """
    columns = [understand(place, table.title(place)) for place in range(table.width)]
    if not table.header:
        columns = [replace(column, quantity="unknown", unit=None) for column in columns]
        table, columns = _with_ros2_titles(table, columns)
    columns = _with_names_from_rows(table, columns)
    if chosen is None and (label := _label(table, columns)) is not None:
        table = _pivoted(table, columns, label)
        columns = [understand(place, title) for place, title in enumerate(table.header)]
    if chosen is not None:
        plan = _as_chosen(table, columns, has_step, joints, chosen)
    elif not table.header:
        if joints is not None:
            raise unclear(
                table,
                "joints are named, and the file has no header with names.",
                columns,
                'Write which column is which, from 1: columns={"t": 1, "q1": 2, "q2": 3, ...}',
            )
        plan = _without_header(table, columns, joint_count, has_step)
    else:
        time = () if has_step else _time(table, columns)
        q, qd = _joints_of(table, columns, joints, want_velocities)
        if not time and not has_step:
            raise unclear(
                table,
                "column t is missing: no title says that a column holds times.",
                columns,
                'If one does, write columns={"t": "its title"}, or its number from 1; if samples are '
                "evenly spaced, write the time between two of them in seconds, step=0.01.",
            )
        plan = Plan(time, q, qd)
    used = {column.place for column in (*plan.time, *plan.q, *plan.qd)}
    unused = [c for c in columns if c.place not in used and table.numeric(c.place)]
    return table, replace(plan, unused=tuple(unused))


# What the user chose
# -------------------------------------------------------------------------------------------------


def _as_chosen(table, columns, has_step, joints, chosen):
    """Return the Plan of the argument `columns`; what it does not name is found by titles."""
    places = {}
    for key, value in chosen.items():
        places |= _places(table, columns, key, value)
    time = tuple(columns[place] for place in places.get("t", ()))
    time = tuple(replace(column, quantity="time", unit=_kept(column, "time")) for column in time)
    if len(time) == 2:
        time = (replace(time[0], unit="s"), replace(time[1], unit="ns"))
    if not time and not has_step:
        time = _time(table, columns) if table.header else ()
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
        q, qd = _joints_of(table, columns, joints, False)
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
            f"{table.name}: {where} is {value!r}, a title that occurs {len(places)} times: write the "
            f"column's number, {numbers}"
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
            f"columns[{quoted(key)}] is {pattern!r}: it must match titles with all numbers from 0 or "
            f"1 on; it matches {', '.join(numbers.values()) or 'none'}"
        )
    return [numbers[number] for number in sorted(numbers)]


# Times
# -------------------------------------------------------------------------------------------------


def _time(table, columns):
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
    """Return the clocks of columns of times: each one column, or one of seconds and one of nanoseconds."""
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
    """Return whether one column holds whole seconds and the other the nanoseconds that belong to them."""
    if (whole.unit, part.unit) != ("s", "ns") or whole.words != part.words:
        return False
    cells = table.cells(part.place)
    if not all(cell.isdigit() and int(cell) < _MAX_SPLIT_NANOSECONDS for cell in cells):
        return False
    return all(re.fullmatch(r"-?\d+", cell) for cell in table.cells(whole.place))


# Joints
# -------------------------------------------------------------------------------------------------


def _joints_of(table, columns, joints, want_velocities):
    """Return the columns of joint angles and of velocities, from the base, or ask."""
    if joints is not None:
        return _by_names(table, columns, joints)
    usable = [_named_target(column, columns) for column in columns if _usable(table, column)]
    known = _known_arm(usable)
    if known is not None:
        return known
    sets, velocities = _sets(usable, "position"), _sets(usable, "velocity")
    if want_velocities and velocities and not sets:
        sets, velocities = velocities, []
    if not sets:
        if velocities:
            raise unclear(
                table,
                "column q1 is missing: there are velocities, and no joint angles.",
                columns,
                'If a column holds the angles, write columns={"q1": "its title", ...}.',
            )
        raise _no_joints(table, columns)
    if len(sets) > 1 or None in sets[0] or _unclear_of(usable):
        return _one_joint(table, columns, usable, sets, velocities)
    if len(velocities) > 1:
        raise _several_sets(table, columns, sets, velocities, "velocity")
    return _numbered(table, columns, sets[0], velocities[0] if velocities else {})


def _usable(table, column):
    """Return whether a column holds numbers; a joint angle without them is kept, to be refused by its cell."""
    numbered = column.quantity == "position" and column.number is not None
    return numbered or table.numeric(column.place)


def _sets(columns, quantity):
    """Return the sets of columns of a quantity: {number: columns} of each, None for columns without number.

    Columns with the same words but for the number are one set. So are columns that differ in words
    if each number occurs once, such as joint_1_s, joint_2_l, joint_3_u.
    """
    of_stem = {}
    for column in columns:
        if column.quantity == quantity:
            numbers = of_stem.setdefault((column.commanded, column.stem), {})
            numbers.setdefault(column.number, []).append(column)
    # What was measured comes before targets, so that the message suggests it.
    sets = [of_stem[key] for key in sorted(of_stem, key=lambda key: key[0])]
    alone = all(len(numbers) == 1 and None not in numbers for numbers in sets)
    together = {number: found for numbers in sets for number, found in numbers.items()}
    commanded = {commanded for commanded, _ in of_stem}
    if len(sets) > 1 and alone and len(together) == len(sets) and len(commanded) == 1:
        return [together]
    # Columns with names instead of numbers are one set, however their titles differ.
    named = [column for numbers in sets for column in numbers.get(None, ())]
    numbered = [{k: v for k, v in numbers.items() if k is not None} for numbers in sets]
    numbered = [numbers for numbers in numbered if numbers]
    return [*numbered, {None: named}] if named else numbered


def _named_target(column, columns):
    """Return q_d as a target if velocities are called dq: then its d is not for the derivative."""
    if column.quantity != "unclear":
        return column
    velocities = {c.number for c in columns if c.quantity == "velocity" and "d" not in c.words}
    if column.number in velocities:
        return replace(column, quantity="position", commanded=True)
    return column


def _unclear_of(columns):
    return [column for column in columns if column.quantity == "unclear"]


def _one_joint(table, columns, usable, sets, velocities):
    """Return the column of a single joint, which needs no number; ask if there are more."""
    alone = [column for numbers in sets for found in numbers.values() for column in found]
    speeds = [column for numbers in velocities for found in numbers.values() for column in found]
    if len(alone) == 1 and len(speeds) <= 1 and not _unclear_of(usable):
        others = [column for column in usable if column.quantity in ("unknown", "pose")]
        if only_quantity(alone[0]) or not others:
            return tuple(alone), tuple(speeds)
    if len(sets) == 1 and None in sets[0]:
        raise _unknown_order(table, columns, sets[0][None])
    raise _several_sets(table, columns, sets, velocities, "angle", _unclear_of(usable))


def _numbered(table, columns, q, qd):
    """Return the columns of joints 1 to k, or refuse the first that is missing or occurs twice."""
    qd = {number: found for number, found in qd.items() if number is not None}
    start = 0 if 0 in q or 0 in qd else 1
    last = max(*q, *qd) if qd else max(q)
    for name, numbers in (("q", q), ("qd", qd)):
        for number in range(start, last + 1):
            joint = f"column {name}{number + 1 - start}"
            if not numbers and name == "qd":
                break
            if number not in numbers:
                raise unclear(
                    table,
                    f"{joint} is missing.",
                    columns,
                    f'If a column holds it, write columns={{"{name}1": "its title", ...}} with all '
                    "joints.",
                )
            if len(numbers[number]) > 1:
                places = [str(column.place + 1) for column in numbers[number]]
                raise unclear(
                    table,
                    f"{joint} occurs twice: columns {' and '.join(places)} have this title.",
                    columns,
                    f'Write the numbers of the right ones: columns={{"{name}1": {places[0]}, ...}}.',
                )
    q, qd = (tuple(numbers[i][0] for i in sorted(numbers)) for numbers in (q, qd))
    if qd and {c.commanded for c in qd} != {c.commanded for c in q}:
        qd = ()  # targets are not the velocities of what was measured
    return q, qd


# Joints with names
# -------------------------------------------------------------------------------------------------


def _matches(names, columns):
    """Return {(quantity, commanded, words beside the name): {joint: columns}} for names of joints."""
    matches = {}
    wanted = [tuple(words_of(name)) for name in names]
    for column in columns:
        # wrist_1 is in wrist_1_joint, and also where a longer name of the list stands.
        fitting = [(len(name), i) for i, name in enumerate(wanted) if _at(name, column) is not None]
        if not fitting or column.quantity in ("time", "label", "name"):
            continue
        size, joint = max(fitting)
        at = _at(wanted[joint], column)
        beside = (*column.words[:at], *column.words[at + size :])
        quantity, commanded = quantity_beside(beside)
        if column.quantity == "velocity":  # perhaps by its unit alone
            quantity = "velocity"
        found = matches.setdefault((quantity, commanded, beside), {})
        found.setdefault(joint, []).append(column)
    return matches


def _at(name, column):
    """Return where the words of a name stand in a title, or None."""
    words, size = column.words, len(name)
    for at in range(len(words) - size + 1):
        if tuple(words[at : at + size]) == tuple(name):
            return at
    return None


def _known_arm(columns):
    """Return the columns of an arm whose joints have the names of NAMED_ARMS, if all and no others are there."""
    for names in NAMED_ARMS:
        matches = _matches(names, columns)
        positions = [found for (quantity, *_), found in matches.items() if quantity == "position"]
        if len(positions) != 1:
            continue
        found = positions[0]
        complete = len(found) == len(names) and all(len(those) == 1 for those in found.values())
        used = {column.place for those in found.values() for column in those}
        others = [
            column
            for column in columns
            if column.quantity in ("position", "unclear") and column.place not in used
        ]
        if not complete or others:
            continue
        speeds = [speed for (quantity, *_), speed in matches.items() if quantity == "velocity"]
        if len(speeds) > 1:
            continue
        q = tuple(found[i][0] for i in range(len(names)))
        q = tuple(replace(column, quantity="position") for column in q)
        qd = ()
        if speeds and len(speeds[0]) == len(names):
            qd = tuple(speeds[0][i][0] for i in range(len(names)))
        return q, qd
    return None


def _by_names(table, columns, joints):
    """Return the columns of the joints that the user names."""
    usable = [column for column in columns if table.numeric(column.place)]
    exact = {column.title: column for column in usable}
    if all(joint in exact for joint in joints):
        q = tuple(replace(exact[joint], quantity="position") for joint in joints)
    else:
        q = None
    matches = _matches(joints, usable)
    if not any(key[0] == "position" for key in matches):
        # A name may be given as elbow_joint, and stand in the file as elbow.
        bare = [_without_joint(joint) for joint in joints]
        matches = _matches(bare, usable)
    found = {"position": [], "velocity": []}
    for (quantity, _, _), of_joint in matches.items():
        if quantity in found:
            found[quantity].append(of_joint)
    if q is None:
        missing = [
            joint for i, joint in enumerate(joints) if not any(i in s for s in found["position"])
        ]
        if missing:
            raise unclear(
                table,
                f"joints names {', '.join(map(repr, missing))}, and no column is this joint's angle.",
                columns,
                "Write the names as they stand in the file, from the base to the end-effector.",
            )
        whole = [s for s in found["position"] if len(s) == len(joints)]
        if len(whole) != 1 or any(len(those) > 1 for those in whole[0].values()):
            raise unclear(
                table,
                "joints names each joint, but several columns have its name.",
                columns,
                'Write which ones: columns={"q1": "title", "q2": "title", ...}.',
            )
        q = tuple(replace(whole[0][i][0], quantity="position") for i in range(len(joints)))
    speeds = [s for s in found["velocity"] if len(s) == len(joints)]
    single = len(speeds) == 1 and all(len(those) == 1 for those in speeds[0].values())
    qd = tuple(speeds[0][i][0] for i in range(len(joints))) if single else ()
    return q, qd


def _without_joint(name):
    words = [word for word in words_of(name) if word not in ("joint", "joints")]
    return "_".join(words) if any(len(word) > 1 and word.isalpha() for word in words) else name


def _with_names_from_rows(table, columns):
    """Return the columns, with the joints' names that stand in rows of text, as ROS writes them.

    A message of joint states has the names beside the numbers, in an order of its own.
    """
    names = {}
    for column in columns:
        if column.quantity == "name" and column.number is not None:
            cells = table.cells(column.place)
            if len(set(cells)) > 1:
                row = next(i for i, cell in enumerate(cells) if cell != cells[0])
                raise unclear(
                    table,
                    f"the joints change their places: {column.title} is {cells[0]!r} in row 1 and "
                    f"{cells[row]!r} in row {row + 1}.",
                    columns,
                    "Write the file with one order of the joints.",
                )
            if cells[0]:
                names[column.number] = cells[0]
    if not names:
        return columns
    named = []
    for column in columns:
        name = names.get(column.number)
        if name is None or column.quantity not in ("position", "velocity"):
            named.append(column)
            continue
        joint = understand(column.place, name)
        quantity = joint.quantity if joint.quantity == "gripper" else column.quantity
        number = joint.number if joint.quantity == "position" else None
        stem = (*joint.stem, *column.stem) if number is not None else column.stem
        title = f"{column.title} ({name})"
        named.append(
            replace(
                column,
                title=title,
                quantity=quantity,
                number=number,
                words=tuple(words_of(name)),
                stem=stem,
            )
        )
    return named


# A row for each joint
# -------------------------------------------------------------------------------------------------


def _label(table, columns):
    """Return the column that says which joint a row is of, or None."""
    labels = [column for column in columns if column.quantity == "label"]
    if len(labels) != 1 or any(c.quantity == "position" and c.number is not None for c in columns):
        return None
    label = labels[0]
    return (
        label
        if len(set(table.cells(label.place))) < len(table.rows) or len(table.rows) == 1
        else None
    )


def _pivoted(table, columns, label):
    """Return a table with a row for each time, from one with a row for each time and joint."""
    clock = _time(table, columns)
    if len(clock) != 1:
        raise unclear(
            table,
            "there is a row for each joint, and not one column of times.",
            columns,
            'Pivot it, in pandas by table.pivot(index="time", columns="joint", values="position").',
        )
    kinds = [column for column in columns if column.quantity in ("position", "velocity")]
    for column in kinds:
        table.values(column.place, f"column {column.title}")  # refuse what is no number by its row
    samples = {}
    for number, row in enumerate(table.rows):
        sample = samples.setdefault(row[clock[0].place], {})
        if row[label.place] in sample:
            raise ValueError(
                f"{table.name}: row {number + 1} is of joint {row[label.place]} at time "
                f"{row[clock[0].place]}, which has a row before"
            )
        sample[row[label.place]] = row
    names = list(next(iter(samples.values())))
    for time, sample in samples.items():
        if set(sample) != set(names):
            odd = sorted(set(sample) ^ set(names))[0]
            raise ValueError(
                f"{table.name}: there is a row for each joint, but joint {odd} has none at some "
                f"times; time {time} is the first at which the joints differ"
            )
    header, rows = [clock[0].title], [[time] for time in samples]
    for column in kinds:
        for name in names:
            joint = f"joint_{name}" if name.isdigit() else name
            header.append(f"{joint} {column.title}")
            for row, sample in zip(rows, samples.values(), strict=True):
                row.append(sample[name][column.place])
    return replace(
        table, header=tuple(header), rows=rows, remark=f"{table.remark}, a row for each joint"
    )


# No header
# -------------------------------------------------------------------------------------------------


def _without_header(table, columns, joint_count, has_step):
    """Return the Plan of a table without header: t, q1 ... qk, and perhaps qd1 ... qdk, if k is known."""
    values = np.column_stack([table.values(i, f"column {i + 1}") for i in range(table.width)])
    _refuse_poses(table, values)
    if has_step:
        return Plan((), tuple(columns), (), ", no header")
    m, k = table.width, joint_count
    if k is None and m == 2:
        k = 1
    if k is None and m % 2 and m > 1 and _second_half_are_velocities(values):
        k = m // 2
    if k is None or m not in (1 + k, 1 + 2 * k):
        known = "" if joint_count is None else f", of {joint_count} joints as in limits"
        raise unclear(
            table,
            f"the file must begin with a header, or hold t, q1 ..., qd1 ...{known}: column t is "
            f"missing, or others, or it is not clear which is which; its shape is {values.shape}.",
            columns,
            'Write the columns by their numbers, from 1: columns={"t": 1, "q1": 2, "q2": 3, ...}. '
            "For positions alone, give the time step, and the file of the velocities if any: "
            'step=0.01, velocities="a second file".',
        )
    return Plan((columns[0],), tuple(columns[1 : k + 1]), tuple(columns[k + 1 :]), ", no header")


def _second_half_are_velocities(values):
    """Return whether columns t, a1 ... ak, b1 ... bk have b for the derivatives of a, where they move."""
    t, k = values[:, 0], values.shape[1] // 2
    q, qd = values[:, 1 : k + 1], values[:, k + 1 :]
    if len(t) < 3 or not np.isfinite(values).all() or (np.diff(t) <= 0).any():
        return False
    moved = np.diff(q, axis=0)
    expected = np.diff(t)[:, None] * (qd[1:] + qd[:-1]) / 2
    size = np.abs(moved).sum(0)
    return bool((size > 0).any() and (np.abs(moved - expected).sum(0) <= 0.2 * size + 1e-9).all())


def _refuse_poses(table, values):
    """Refuse tables that hold poses: t and a quaternion (TUM), or the first rows of matrices (KITTI)."""
    if not np.isfinite(values).all():
        return
    what = ""
    if values.shape[1] in (7, 8):
        lengths = np.linalg.norm(values[:, -4:], axis=1)
        if (np.abs(lengths - 1) < 1e-3).all():
            what = "t x y z qx qy qz qw, as in the TUM format"
            what = what if values.shape[1] == 8 else what[2:]
    elif values.shape[1] == 12:
        R = values.reshape(-1, 3, 4)[:, :, :3]
        if (np.abs(R @ R.swapaxes(-1, -2) - np.eye(3)).max(initial=0)) < 1e-3:
            what = "the 3 by 4 matrices of poses, as in the KITTI format"
    if what:
        raise unclear(
            table,
            f"this looks like poses, no joint angles: {what}.",
            [],
            'If they are joint angles, write columns={"t": 1, "q1": 2, "q2": 3, ...}.',
        )


def _with_ros2_titles(table, columns):
    """Return titles for what `ros2 topic echo --csv` writes of sensor_msgs/JointState, which has no header.

    The fields stand in the message's order: sec, nanosec, frame_id, names, positions, and, where
    they are filled, velocities and efforts.
    """
    if isinstance(table.rows, np.ndarray) or table.width < 5:
        return table, columns
    row = table.rows[0]
    texts = [not table.numeric(place) for place in range(table.width)]
    k = 0
    while 3 + k < table.width and texts[3 + k] and row[3 + k]:
        k += 1
    rest = table.width - 3 - k
    whole = row[0].isdigit() and row[1].isdigit() and int(row[1]) < _MAX_SPLIT_NANOSECONDS
    if not whole or not texts[2] or k == 0 or rest not in (k, 3 * k) or any(texts[3 + k :]):
        return table, columns
    kinds = ["name", "position", "velocity", "effort"][: 1 + rest // k]
    titles = ["sec", "nanosec", "frame_id", *(f"{kind}{i}" for kind in kinds for i in range(k))]
    table = replace(table, header=tuple(titles), remark=f"{table.remark}, no header")
    return table, [understand(place, title) for place, title in enumerate(titles)]


# Questions
# -------------------------------------------------------------------------------------------------


def _no_joints(table, columns):
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
            f"no title says that a column holds the angle of a joint. Numbered columns: {patterns}.",
            columns,
            f'If some are joint angles, write them, for example columns={{"q": '
            f"{quoted(families[0])}}}; * is for the numbers.",
        )
    if unknown:
        return _unknown_order(table, columns, unknown)
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


def _unknown_order(table, columns, named):
    """Return the question which order joints with names have."""
    names = quoted([re.sub(r".*\((.*)\)", r"\1", column.title) for column in named])
    return unclear(
        table,
        "no number or known name says which columns are the joints, or in which order.",
        columns,
        f"If these are the joints, write them from the base to the end-effector: joints={names}.",
    )


def _several_sets(table, columns, sets, velocities, what, unclear_columns=()):
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
