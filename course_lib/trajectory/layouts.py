"""Tables of another layout: a row for each joint, or no header."""

from dataclasses import replace

import numpy as np

from course_lib.trajectory.clocks import MAX_SPLIT_NANOSECONDS, time_of
from course_lib.trajectory.column_names import understand
from course_lib.trajectory.plan import Plan
from course_lib.trajectory.refusals import unclear


def joint_label(table, columns):
    """Return the column that says which joint a row is of, or None."""
    labels = [column for column in columns if column.quantity == "label"]
    if len(labels) != 1 or any(c.quantity == "position" and c.number is not None for c in columns):
        return None
    # A table whose label is another one in each row has joints for samples, not samples of joints.
    repeats = len(set(table.cells(labels[0].place))) < len(table.rows)
    return labels[0] if repeats or len(table.rows) == 1 else None


def pivoted(table, columns, label):
    """Return a table with a row for each time, from a table with a row for each time and joint."""
    clock = time_of(table, columns)
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


def without_header(table, columns, joint_count, has_step):
    """Return the Plan of a table without header: t, q1 ... qk, and perhaps qd1 ... qdk, if k is
    known."""
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
    """Return whether columns t, a1 ... ak, b1 ... bk have b for the derivatives of a, where they
    move."""
    t, k = values[:, 0], values.shape[1] // 2
    q, qd = values[:, 1 : k + 1], values[:, k + 1 :]
    if len(t) < 3 or not np.isfinite(values).all() or (np.diff(t) <= 0).any():
        return False
    moved = np.diff(q, axis=0)
    expected = np.diff(t)[:, None] * (qd[1:] + qd[:-1]) / 2
    size = np.abs(moved).sum(0)
    return bool((size > 0).any() and (np.abs(moved - expected).sum(0) <= 0.2 * size + 1e-9).all())


def _refuse_poses(table, values):
    """Refuse tables that hold poses: t and a quaternion (TUM), or the first rows of matrices
    (KITTI)."""
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


def with_ros2_titles(table, columns):
    """Return titles for what `ros2 topic echo --csv` writes of sensor_msgs/JointState, which has no
    header.

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
    whole = row[0].isdigit() and row[1].isdigit() and int(row[1]) < MAX_SPLIT_NANOSECONDS
    if not whole or not texts[2] or k == 0 or rest not in (k, 3 * k) or any(texts[3 + k :]):
        return table, columns
    kinds = ["name", "position", "velocity", "effort"][: 1 + rest // k]
    titles = ["sec", "nanosec", "frame_id", *(f"{kind}{i}" for kind in kinds for i in range(k))]
    table = replace(table, header=tuple(titles), remark=f"{table.remark}, no header")
    return table, [understand(place, title) for place, title in enumerate(titles)]
