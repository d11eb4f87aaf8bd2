"""Read joint trajectories from the files of other programs, or ask what is not clear."""

import re
from dataclasses import replace
from decimal import Decimal

import numpy as np

from course_lib.arguments import file_path, positive, real_array
from course_lib.trajectory.column_names import UNITS
from course_lib.trajectory.find_columns import find_columns, find_velocities
from course_lib.trajectory.motion import Trajectory
from course_lib.trajectory.text_table import read_table
from course_lib.trajectory.understood import (
    UnclearFileError,
    came_from,
    column_label,
    joint_lines,
    listed_titles,
    quoted,
    summary,
    unclear,
)

_SUFFIXES = (".csv", ".tsv", ".txt", ".dat", ".npy")
_BY_ROS = (
    "ROS writes the messages in it as a table by `ros2 topic echo --csv` or `rostopic echo -p`"
)
_IN_SPREADSHEET = "Open it in a spreadsheet, and save it as CSV"
_OTHER_FILES = {
    **dict.fromkeys((".yaml", ".yml", ".bag", ".db3", ".mcap"), _BY_ROS),
    **dict.fromkeys((".xlsx", ".xls", ".ods"), _IN_SPREADSHEET),
    ".mat": "MATLAB writes a table by `writetable(array2table(...), 'own.csv')`",
}
_MAX_RADIANS = 4 * np.pi  # beyond it angles without a unit are asked about: two full turns
_MAX_VALUE = 1e100  # of a cell, as for all arguments of this library
_SLOW = 1.0  # seconds between samples, from which times without a unit are asked about
# Seconds since 1970 in the years 2000 to 2100: a time in no unit that, in one of these units, falls
# there, is in that unit. ROS counts nanoseconds since 1970, others micro- or milliseconds.
_SINCE_1970 = (9.4e8, 4.2e9)
_QUANTITIES = {"t": "times", "q": "angles", "qd": "angular velocities"}


class JointCountError(ValueError):
    """A file has another number of joints than the arm.

    Attributes
    ----------
    found, expected : int
        The number of joints in the file, and that of the limits.
    """

    def __init__(self, name, found, expected):
        joints = f"{found} joint{'s' if found > 1 else ''}"
        super().__init__(f"{name}: this file has {joints}, and limits are given for {expected}")
        self.found, self.expected = found, expected


def load(path, limits=None, velocities=None, step=None, units=None, joints=None, columns=None):
    """Return the Trajectory in a file of another program, or in one of positions and one of
    velocities.

    A column is used if its title says what it is: time, or the angle or velocity of a numbered
    joint, such as `t`, `q1`, `joint_2 [deg]`, `actual_q_0`, `state.q[0]`, `panda_joint1`. The
    joints of Universal Robots, Sawyer and Baxter are known by their names. In all other cases the
    error shows the header, says what was understood of each column, and names the argument to
    write.

    Parameters
    ----------
    path : str or pathlib.Path
        A table as text (comma, semicolon, tab or spaces between columns, decimal point or comma,
        with a header), or an NPY file.
    limits : array_like (k, 2), optional
        Lowest and highest angle of each joint, in radians. None for any. A file without header is
        read only with limits, because they say how many joints there are: t, q1 ... qk, and, if
        there are so many columns, qd1 ... qdk.
    velocities : str or pathlib.Path, optional
        The file of the velocities, if `path` holds positions alone; `step` is needed. Samples are
        the rows, or the columns if only the columns have `limits` for rows.
    step : float, optional
        The time between two samples, in seconds, if times are not in the file.
    units : dict, optional
        Units that the header does not say, or says wrongly: of "t" (s, ms, us, ns), of the angles
        "q" (rad, deg, mrad) and of the velocities "qd" (rad/s, deg/s, rpm), for example
        ``{"t": "ms", "q": "deg"}``.
    joints : sequence of str, optional
        The names of the joints from the base to the end-effector, as they are in the file, for
        example `SerialArm.joint_names`.
    columns : dict, optional
        Which column is what, for example ``{"t": "stamp", "q1": "shoulder_pan_joint"}``, by title
        or by number from 1. "q" and "qd" take a list of all joints, or one title with * for the
        joint's number, such as ``{"q": "actual_q_*"}``; "t" may be a list of a column of seconds
        and one of nanoseconds. Joint angles that are named are all that are used. With a file of
        `velocities`, "qd" is of this file, and "q" is of `path`.

    Returns
    -------
    Trajectory
        Its `understood` says which column each joint came from, its unit and its range in degrees.
        Velocities that are not in the file, or are NaN throughout, are differences of the samples.
        A joint that was logged within one turn, and so jumps by 2 pi, is unwrapped.

    Raises
    ------
    ValueError
        If a cell is not a finite number, is outside its limits, or makes time stand still; it names
        file, row and column. UnclearFileError, which is a ValueError, if it is not clear what a
        column or a number means; its message says what to write. JointCountError, which is one,
        too, if `limits` are of another number of joints.
    OSError
        If there is no such file.

    Examples
    --------
    >>> import tempfile
    >>> from pathlib import Path
    >>> folder = Path(tempfile.mkdtemp())
    >>> _ = (folder / "own.csv").write_text("Zeit;Achse 1\\n0,0;0,1\\n0,5;0,6\\n")
    >>> own = load(folder / "own.csv", limits=[[-1, 1]])
    >>> print(own.q.T, own.understood, sep="\\n")
    [[0.1 0.6]]
    2 rows, t in s, 1 angle in rad, no velocities (differences of the samples), decimal comma
      t: 'Zeit', no unit in the header
      q1: 'Achse 1', no unit in the header, 5.7 to 34.4 degrees
    """
    if velocities is not None and step is None:
        raise ValueError("velocities need the time step between two samples, in seconds")
    units = _checked_units(units)
    joints = _checked_joints(joints)
    columns, velocity_columns = _checked_columns(columns, velocities is not None)
    if step is not None:
        _refuse_times("units", units, step)
        _refuse_times("columns", columns, step)
    path = _table_file(path, "path")
    if limits is not None:
        limits = real_array(limits, "limits", ("n", 2), batched=False, infinite=True)
    if step is not None:
        step = float(positive(step, "step", batched=False))
    joint_count = None if limits is None else len(limits)
    table = read_table(path)
    if step is not None and joint_count is not None:
        table = table.with_samples_as_rows(joint_count)
    file_columns = find_columns(table, joint_count, step is not None, joints, columns)
    chosen = bool(columns)
    q_columns = _with_units(table, file_columns.q, "q", units.get("q"), chosen)
    if joint_count is not None and len(q_columns) != joint_count:
        raise JointCountError(table.name, len(q_columns), joint_count)
    q = _values(table, q_columns, "q")
    if step is None:
        t, elapsed, unit = _times(table, file_columns.t, units.get("t"), chosen)
        times, understood = f"t in {unit}", [f"t: {came_from(file_columns.t)}"]
    else:
        t = elapsed = step * np.arange(len(q))
        times, understood = f"steps of {step:g} s", []
    _ask_for_degrees(table, q_columns, q)
    q = q * _sizes(q_columns)
    qd_table, qd_columns = table, file_columns.qd
    if velocities is not None:
        qd_table = read_table(_table_file(velocities, "velocities"))
        qd_table = qd_table.with_samples_as_rows(len(q_columns))
        qd_columns = find_velocities(qd_table, joints, velocity_columns)
        chosen = bool(velocity_columns)
    qd_columns = _with_units(qd_table, qd_columns, "qd", units.get("qd"), chosen)
    qd = _velocities(qd_table, qd_columns, q, q_columns)
    q, unwrapped = _unwrapped(table, q_columns, q, qd, elapsed, limits)
    if limits is not None:
        _refuse_outside(table, q_columns, q, limits)
    understood += joint_lines(q_columns, qd_columns, q)
    qd, missing = _with_differences(q, qd, elapsed)
    if qd_columns and missing:
        names = ", ".join(qd_columns[i].title for i in missing)
        understood.append(f"left out, because they are NaN throughout: {names}")
    understood += unwrapped
    if file_columns.unused:
        understood.append(f"not used: {listed_titles(file_columns.unused)}")
    given_count = len(q_columns) - len(missing)
    first_line = summary(
        len(q), times, q_columns, given_count, table.decimal_comma, file_columns.remark
    )
    lines = "\n  ".join([first_line, *understood])
    return Trajectory(t, q, qd, lines, velocities_given=given_count > 0)


# Arguments
# -------------------------------------------------------------------------------------------------


def _table_file(path, name):
    path = file_path(path, name)
    if path.suffix.lower() not in _SUFFIXES:
        advice = _OTHER_FILES.get(path.suffix.lower(), "")
        raise ValueError(
            f"{name} must name a {', '.join(_SUFFIXES[:-1])} or {_SUFFIXES[-1]} file; it is "
            f"{str(path)!r}{advice and '. '}{advice}"
        )
    return path


def _checked_units(units):
    """Return the argument `units` as a dict."""
    if units is None:
        return {}
    expected = 'units must be such as {"t": "ms", "q": "deg"}'
    if not isinstance(units, dict):
        raise ValueError(f"{expected}; it is {units!r:.60}")
    for key, unit in units.items():
        if key not in ("t", "q", "qd"):
            raise ValueError(f"{expected}: its keys are t, q and qd; one is {key!r:.40}")
        known = UNITS[key]
        if not isinstance(unit, str) or unit not in known:
            raise ValueError(
                f"{expected}: of {key} it may be {', '.join(known)}; it is {unit!r:.40}"
            )
    return units


def _checked_columns(columns, two_files):
    """Return the argument `columns` as a dict for the first file, and one for the file of the
    velocities."""
    if columns is None:
        return {}, {}
    if not isinstance(columns, dict) or not columns:
        raise ValueError(
            'columns must be a dict such as {"t": "time", "q1": "a title"}; it is'
            f" {columns!r:.60}"
        )
    if not two_files:
        return columns, {}
    of_velocities = {key: value for key, value in columns.items() if str(key).startswith("qd")}
    of_positions = {key: value for key, value in columns.items() if key not in of_velocities}
    return of_positions, of_velocities


def _refuse_times(name, argument, step):
    """Refuse an argument that says something of times in the file, beside `step`."""
    if "t" in argument:
        raise ValueError(
            f'{name} must not have "t" beside step={step:g}, which gives all times in seconds, so '
            f"that none are read; it is {argument['t']!r:.60}. Leave out one of the two"
        )


def _checked_joints(joints):
    if joints is None:
        return None
    if isinstance(joints, str) or not isinstance(joints, list | tuple) or not joints:
        raise ValueError(
            f'joints must be a list of names, such as ["joint_a1"]; it is {joints!r:.60}'
        )
    for joint in joints:
        if not isinstance(joint, str) or not re.search(r"\w", joint):
            raise ValueError(f"joints must be names; one is {joint!r:.40}")
    if len(set(joints)) < len(joints):
        raise ValueError(f"joints must be different names; they are {joints!r:.200}")
    return list(joints)


# Units
# -------------------------------------------------------------------------------------------------


def _with_units(table, columns, kind, unit, chosen):
    """Return the columns of one kind with the unit that the user says, or with those of the header.

    unit: what the user says, or None. chosen: whether the user chose the columns, and so knows what
    their titles say.
    """
    if unit is not None and not columns:
        raise ValueError(
            f'units must not have "{kind}", because no {_QUANTITIES[kind]} are read from '
            f"{table.name}; it is {unit!r}"
        )
    columns = [_with_unit(table, column, kind, unit, chosen) for column in columns]
    with_unit = [column for column in columns if column.unit is not None]
    without = [column for column in columns if column.unit is None]
    if with_unit and without:
        raise unclear(
            table,
            columns,
            f"some columns have a unit, and {without[0].title!r} has none.",
            f'If it has the same, write units={{"{kind}": "{with_unit[0].unit}"}}.',
        )
    return columns


def _with_unit(table, column, kind, unit, chosen):
    """Return a column with the unit that the user says, else that of its title, if it is known."""
    in_title = column.unit if column.unit in UNITS[kind] else None
    known = ", ".join(UNITS[kind])
    if column.unit and in_title is None and unit is None:
        raise unclear(
            table,
            [column],
            f"{column.title!r} has the unit {column.unit.removeprefix('?')}. The units of "
            f"{_QUANTITIES[kind]} that are known here are {known}.",
            "If it is in one of these nevertheless, write it, for example "
            f'units={{"{kind}": "{known.split(",")[0]}"}}.',
        )
    if unit is not None and in_title not in (None, unit) and not chosen:
        raise unclear(
            table,
            [column],
            f"units says that {kind} is in {unit}, and {column.title!r} says {in_title}.",
            f'Leave it out of units, or, if the title is wrong, add columns={{"{kind}": ...}}.',
        )
    return replace(column, unit=unit or in_title)


def _sizes(columns):
    return np.array([(UNITS["q"] | UNITS["qd"])[column.unit or "rad"] for column in columns])


def _ask_for_degrees(table, columns, q):
    reach = np.abs(q).max()
    if reach > _MAX_RADIANS and all(column.unit is None for column in columns):
        raise UnclearFileError(
            f"{table.name}: angles reach {reach:.4g}, and the header has no unit. Are they degrees?"
            ' Then add units={"q": "deg"}; if they are radians, units={"q": "rad"}'
        )


# Times
# -------------------------------------------------------------------------------------------------


def _times(table, columns, unit, chosen):
    """Return times (n,) in seconds, the same less the first, exact to the last digit, and their
    unit."""
    label = column_label("t", columns[0])
    if len(columns) == 1:
        columns = _with_units(table, columns, "t", unit, chosen)
    elif unit is not None:
        raise ValueError(
            f'units must not have "t", because times are read from {came_from(columns)}; it is '
            f'{unit!r}. For one column alone, write columns={{"t": {quoted(columns[0].title)}}}'
        )
    for column in columns:
        if not table.holds_numbers(column.place):
            raise _no_numbers(table, column, label)
        values = table.numbers(column.place, label)[:, None]
        bad = ~(np.abs(values) <= _MAX_VALUE)
        _refuse(table, [column], [label], bad, "is not a finite number")
    # Decimals, because a float holds nanoseconds since 1970 to 256 of them.
    ticks = [Decimal(cell) for cell in table.numerals(columns[0].place)]
    if len(columns) == 2:
        parts = [Decimal(cell) for cell in table.numerals(columns[1].place)]
        ticks = [whole + Decimal("1e-9") * part for whole, part in zip(ticks, parts, strict=True)]
        unit = "s"
    else:
        unit = columns[0].unit or _unit_of_times(table, columns[0], ticks)
    size = Decimal(repr(UNITS["t"][unit]))
    elapsed = np.array([float((tick - ticks[0]) * size) for tick in ticks])
    t = np.array([float(tick * size) for tick in ticks])
    back = np.append(False, np.diff(elapsed) <= 0)
    if back.any():
        row = int(np.argmax(back))
        since_start = abs(t[0]) >= 1e6  # such as seconds since 1970
        now, before = (elapsed if since_start else t)[[row, row - 1]]
        since = f" (since {t[0]:.0f} s)" if since_start else ""
        raise ValueError(
            f"{table.name}: row {row + 1}, {label} is {now:g} s, after {before:g}"
            f" s{since}: time must increase"
        )
    return t, elapsed, unit


def _no_numbers(table, column, label):
    """Return what to say of times that are dates or texts, all of them."""
    return unclear(
        table,
        [column],
        f"{label} holds {table.cells(column.place)[0]!r:.40}, and a time must be a number.",
        "Write the times as numbers, for example in seconds since the first one. If samples are "
        "evenly spaced, write the time between two of them in seconds instead, step=0.01.",
    )


def _unit_of_times(table, column, ticks):
    """Return the unit of times without one: what is certain from the numbers; else ask."""
    for unit in ("ns", "us", "ms", "s"):
        if _SINCE_1970[0] < float(ticks[0]) * UNITS["t"][unit] < _SINCE_1970[1]:
            return unit
    step = float(np.median(np.diff([float(tick) for tick in ticks]))) if len(ticks) > 1 else 0.0
    if step < _SLOW:
        return "s"
    rates = ", ".join(f"{1 / (step * size):.4g} in {unit}" for unit, size in UNITS["t"].items())
    raise UnclearFileError(
        f"{table.name}: times, {column.title!r}, are {step:.4g} apart, and the header has no unit. "
        "Are they milliseconds? Or micro- or nanoseconds? Samples per second would be: "
        f'{rates}. Add the right one, units={{"t": "s"}}, {{"t": "ms"}}, {{"t": "us"}} or '
        '{"t": "ns"}'
    )


# Angles and velocities
# -------------------------------------------------------------------------------------------------


def _values(table, columns, kind):
    """Return the columns as an array (n, k), as they stand in the file; refuse what is not
    finite."""
    labels = [column_label(f"{kind}{i}", column) for i, column in enumerate(columns, 1)]
    pairs = zip(columns, labels, strict=True)
    array = np.column_stack([table.numbers(column.place, label) for column, label in pairs])
    bad = ~(np.abs(array) <= _MAX_VALUE)
    if kind == "qd":
        bad &= ~np.isnan(array).all(0)
    _refuse(table, columns, labels, bad, "is not a finite number")
    return array


def _velocities(table, columns, q, q_columns):
    """Return the velocities in radians per second, or None; NaN where a column is NaN throughout.

    Drivers of robots that do not measure velocities fill the columns with NaN, or leave them empty.
    """
    if not columns:
        return None
    filled = [column for column in columns if any(table.cells(column.place))]
    if not filled:
        return np.full(q.shape, np.nan)
    qd = _values(table, columns, "qd")
    if qd.shape != q.shape:
        raise ValueError(
            f"positions and velocities must have one shape; positions are {q.shape}, and "
            f"velocities in {table.name} are {qd.shape}, a row for each sample. Columns may be "
            'chosen, such as columns={"qd": [2, 3, ...]}'
        )
    if all(column.unit is None for column in columns):  # that of the angles, per second
        pairs = zip(columns, q_columns, strict=True)
        columns = [replace(column, unit=angle.unit) for column, angle in pairs]
    return qd * _sizes(columns)


def _with_differences(q, qd, elapsed):
    """Return velocities, which are differences of the samples where none are given, and the joints
    for which they are."""
    missing = np.ones(q.shape[1], bool) if qd is None else np.isnan(qd).all(0)
    velocities = np.zeros_like(q) if qd is None else qd.copy()
    if missing.any() and len(q) > 1:
        velocities[:, missing] = np.gradient(q[:, missing], elapsed, axis=0)
    return velocities, np.flatnonzero(missing).tolist()


def _unwrapped(table, columns, q, qd, elapsed, limits):
    """Return the angles, continued over jumps of a joint that was logged within one turn, and what
    is to be said of it.

    A step of more than pi is such a jump if the shorter way round fits the velocities in
    the file, or, without any, the joint's other steps. Where the limits forbid the shorter way, the
    joint stays as it is in the file. Where neither is certain, the user is asked.
    """
    q, remarks = q.copy(), []
    for i, column in enumerate(columns):
        steps = np.diff(q[:, i])
        jumps = np.abs(steps) > np.pi
        if not jumps.any():
            continue
        rows = [int(row) + 1 for row in np.flatnonzero(jumps)]
        where = f"after row{'s' * (len(rows) > 1)} {', '.join(map(str, rows[:5]))}"
        where += ", ..." if len(rows) > 5 else ""
        continued = np.unwrap(q[:, i])
        low, high = (-np.inf, np.inf) if limits is None else limits[i]
        endless = limits is not None and not np.isfinite([low, high]).any()
        largest = np.abs(steps[jumps]).max()
        if ((continued < low) | (continued > high)).any():
            remarks.append(f"q{i + 1} jumps by up to {largest:.2f} rad {where}, as in the file")
            continue
        if not endless and not _goes_the_short_way(steps, jumps, qd, i, elapsed):
            raise unclear(
                table,
                columns,
                f"{column_label(f'q{i + 1}', column)} jumps by up to {largest:.2f} rad {where}. "
                "Was it logged within one turn, or did the joint go that far?",
                "Write limits, a row for each joint: [-np.inf, np.inf] for one that turns without "
                "end and was logged within one turn, else its lowest and highest angle.",
            )
        q[:, i] = continued
        remarks.append(f"q{i + 1} is logged within one turn, and unwrapped {where}")
    return q, remarks


def _goes_the_short_way(steps, jumps, qd, joint, elapsed):
    """Return whether all jumps of a joint are those of an angle logged within one turn."""
    short = np.abs(steps - 2 * np.pi * np.sign(steps))[jumps]
    if qd is not None and not np.isnan(qd[:, joint]).any():
        expected = (np.diff(elapsed) * (qd[1:, joint] + qd[:-1, joint]) / 2)[jumps]
        far, near = steps[jumps], steps[jumps] - 2 * np.pi * np.sign(steps[jumps])
        return bool((np.abs(near - expected) < np.abs(far - expected)).all())
    others = np.abs(steps[~jumps])
    return bool(len(others) and short.max() <= 2 * others.max() + 0.01)


def _refuse_outside(table, columns, q, limits):
    low, high = (np.broadcast_to(limit, q.shape) for limit in limits.T)
    outside = (q < low) | (q > high)
    reason = "is {:.4f} rad, outside {:.4f} to {:.4f}"
    in_degrees = np.deg2rad(q)
    fits = ((in_degrees >= low) & (in_degrees <= high)).all()
    if fits and np.abs(q).max() > np.pi and all(column.unit is None for column in columns):
        reason += '. If the angles are degrees, add units={{"q": "deg"}}'
    labels = [column_label(f"q{i}", column) for i, column in enumerate(columns, 1)]
    _refuse(table, columns, labels, outside, reason, q, low, high)


def _refuse(table, columns, labels, bad, reason, *arrays):
    """Raise ValueError for the first True in bad (n, k), with the entries of arrays in its
    reason."""
    if bad.any():
        row, column = np.argwhere(bad)[0]
        where = table.where(row, columns[column].place, labels[column])
        reason = reason.format(*(array[row, column] for array in arrays))
        raise ValueError(f"{table.name}: {where} {reason}")
