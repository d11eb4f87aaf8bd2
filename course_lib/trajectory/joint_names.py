"""Joints with names: those of known arms, those that the user gives, and those in rows of a
recording."""

from dataclasses import replace

from course_lib.trajectory.column_names import quantity_beside, understand, words_of
from course_lib.trajectory.refusals import unclear

# Names of joints from the base to the end-effector, as these arms' makers give them: Universal
# Robots' ROS description and teach pendant; Yaskawa Motoman; Rethink's Baxter; Hugging Face's
# SO-101;
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


def _matches(names, columns):
    """Return {(quantity, commanded, words beside the name): {joint: columns}} for names of
    joints."""
    matches = {}
    wanted = [tuple(words_of(name)) for name in names]
    for column in columns:
        # wrist_1 is in wrist_1_joint, and even where a longer name of the list stands.
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


def known_arm(columns):
    """Return the columns of an arm whose joints have the names of NAMED_ARMS, if all and no others
    are there."""
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


def by_names(table, columns, joints):
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
                f"joints names {', '.join(map(repr, missing))}, and no column is this joint's"
                " angle.",
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


def with_names_from_rows(table, columns):
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
