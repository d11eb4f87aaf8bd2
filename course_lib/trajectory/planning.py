"""Which columns of a table are times, joint angles and velocities: as their titles or the user say,
or a question."""

from dataclasses import replace

from course_lib.trajectory.chosen_columns import as_chosen
from course_lib.trajectory.clocks import time_of
from course_lib.trajectory.column_names import understand
from course_lib.trajectory.joint_names import with_names_from_rows
from course_lib.trajectory.joint_sets import joints_of
from course_lib.trajectory.layouts import joint_label, pivoted, with_ros2_titles, without_header
from course_lib.trajectory.plan import Plan
from course_lib.trajectory.refusals import unclear


def plan_of(table, joint_count, has_step, joints, chosen, want_velocities=False):
    """Return the table, which is another one if it had a row for each joint, and its Plan.

    joint_count: the number of joints, or None. has_step: whether the user gave the time step.
    joints, chosen: the arguments `joints` and `columns` of load, or None. want_velocities: whether
    the file is the one of the velocities.
    """
    columns = [understand(place, table.title(place)) for place in range(table.width)]
    if not table.header:
        columns = [replace(column, quantity="unknown", unit=None) for column in columns]
        table, columns = with_ros2_titles(table, columns)
    columns = with_names_from_rows(table, columns)
    if chosen is None and (label := joint_label(table, columns)) is not None:
        table = pivoted(table, columns, label)
        columns = [understand(place, title) for place, title in enumerate(table.header)]
    if chosen is not None:
        plan = as_chosen(table, columns, has_step, joints, chosen)
    elif not table.header:
        if joints is not None:
            raise unclear(
                table,
                "joints are named, and the file has no header with names.",
                columns,
                'Write which column is which, from 1: columns={"t": 1, "q1": 2, "q2": 3, ...}',
            )
        plan = without_header(table, columns, joint_count, has_step)
    else:
        time = () if has_step else time_of(table, columns)
        q, qd = joints_of(table, columns, joints, want_velocities)
        if not time and not has_step:
            raise unclear(
                table,
                "column t is missing: no title says that a column holds times.",
                columns,
                'If one does, write columns={"t": "its title"}, or its number from 1; if samples'
                " are evenly spaced, write the time between two of them in seconds, step=0.01.",
            )
        plan = Plan(time, q, qd)
    used = {column.place for column in (*plan.time, *plan.q, *plan.qd)}
    unused = [c for c in columns if c.place not in used and table.numeric(c.place)]
    return table, replace(plan, unused=tuple(unused))
