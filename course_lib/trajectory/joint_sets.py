"""Which columns of a table are the joints: sets of numbered columns, or the names of joints."""

from dataclasses import replace

from course_lib.trajectory.column_names import only_quantity
from course_lib.trajectory.joint_names import by_names, known_arm
from course_lib.trajectory.questions import no_joints, several_sets, unknown_order
from course_lib.trajectory.refusals import unclear


def joints_of(table, columns, joints, want_velocities):
    """Return the columns of joint angles and of velocities, from the base, or ask."""
    if joints is not None:
        return by_names(table, columns, joints)
    usable = [_named_target(column, columns) for column in columns if _usable(table, column)]
    known = known_arm(usable)
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
        raise no_joints(table, columns)
    if len(sets) > 1 or None in sets[0] or _unclear_of(usable):
        return _one_joint(table, columns, usable, sets, velocities)
    if len(velocities) > 1:
        raise several_sets(table, columns, sets, velocities, "velocity")
    return _numbered(table, columns, sets[0], velocities[0] if velocities else {})


def _usable(table, column):
    """Return whether a column holds numbers; a joint angle without them is kept, to be refused by
    its cell."""
    numbered = column.quantity == "position" and column.number is not None
    return numbered or table.numeric(column.place)


def _sets(columns, quantity):
    """Return the sets of columns of a quantity: {number: columns} of each, None for columns without
    number.

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
        raise unknown_order(table, columns, sets[0][None])
    raise several_sets(table, columns, sets, velocities, "angle", _unclear_of(usable))


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
                    f'Write the numbers of the right columns: columns={{"{name}1": {places[0]},'
                    " ...}.",
                )
    q, qd = (tuple(numbers[i][0] for i in sorted(numbers)) for numbers in (q, qd))
    if qd and {c.commanded for c in qd} != {c.commanded for c in q}:
        qd = ()  # targets are not the velocities of what was measured
    return q, qd
