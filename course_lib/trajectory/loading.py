"""Read joint trajectories from the files of other programs."""

import re
from dataclasses import replace
from datetime import datetime
from decimal import Decimal, InvalidOperation

import numpy as np

from course_lib.arguments import file_path, positive, real_array
from course_lib.trajectory.column_names import UNITS
from course_lib.trajectory.motion import Trajectory
from course_lib.trajectory.planning import plan_of
from course_lib.trajectory.refusals import JointCountError, UnclearFileError, unclear
from course_lib.trajectory.text_table import read_table

_SUFFIXES = (".csv", ".tsv", ".txt", ".dat", ".npy")
_MAX_RADIANS = 4 * np.pi  # beyond it angles without a unit are asked about: two full turns
_MAX_VALUE = 1e100  # of a cell, as for all arguments of this library
_SLOW = 1.0  # seconds between samples, from which times without a unit are asked about
# Seconds since 1970 in the years 2000 to 2100: a time in no unit that, in one of these units, falls
# there, is in that unit. ROS counts nanoseconds since 1970, others micro- or milliseconds.
_SINCE_1970 = (9.4e8, 4.2e9)
_UNITS_IN_WORDS = {"t": "times", "q": "angles", "qd": "angular velocities"}
_FILE_UNITS = {"t": ("time",), "q": ("angle",), "qd": ("rate", "angle")}


def load(path, limits=None, velocities=None, step=None, units=None, joints=None, columns=None):
    """Return the Trajectory in a file of another program, or in one of positions and one of
    velocities.

    A column is used if its title says what it is: time, or the angle or velocity of a numbered
    joint, such as `t`, `q1`, `joint_2_pos [deg]`. Joints with names are put in order by these names
    where the names are those of a known arm, such as `shoulder_pan_joint`. In all other cases the
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
        Units that the header does not say, or says wrongly: of "t" (s, ms, us, ns), of all joints
        as "q" (rad, deg, mrad) and "qd" (rad/s, deg/s, rpm), or of one, as "q3", for example
        ``{"t": "ms", "q": "deg"}``. A pair such as ``("ms", "deg")`` is for times and angles.
    joints : sequence of str, optional
        The names of the joints from the base to the end-effector, as they are in the file, for
        example `SerialArm.joint_names`.
    columns : dict, optional
        Which column is what, for example ``{"t": "stamp", "q1": "shoulder_pan_joint"}``, by title
        or by number from 1. "q" and "qd" take a list of all joints, or one title with * for the
        joint's number, such as ``{"q": "actual_q_*"}``; "t" may be a list of a column of seconds
        and one of nanoseconds. Joint angles that are named are all that are used.

    Returns
    -------
    Trajectory
        Its `understood` says which column each joint came from, its unit and its range in degrees.
        Velocities that are not in the file are differences of the samples.

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
    if columns is not None and not (isinstance(columns, dict) and columns):
        raise ValueError(
            'columns must be a dict such as {"t": "time", "q1": "a title"}; it is'
            f" {columns!r:.60}"
        )
    path = _table_file(path, "path")
    if limits is not None:
        limits = real_array(limits, "limits", ("n", 2), batched=False, infinite=True)
    if step is not None:
        step = float(positive(step, "step", batched=False))
    count = None if limits is None else len(limits)
    has_step, chosen = step is not None, columns is not None
    table = read_table(path).with_samples_as_rows(count if has_step else None)
    table, plan = plan_of(table, count, has_step, joints, columns)
    q_columns = _with_units(table, plan, plan.q, "q", units, chosen)
    if count is not None and len(q_columns) != count:
        raise JointCountError(table.name, len(q_columns), count)
    q = _values(table, q_columns, "q")
    qd_table, qd_columns = table, _with_units(table, plan, plan.qd, "qd", units, chosen)
    if velocities is not None:
        qd_table = read_table(_table_file(velocities, "velocities")).with_samples_as_rows(count)
        qd_table, qd_plan = plan_of(qd_table, count, has_step, joints, None, True)
        qd_columns = _with_units(qd_table, qd_plan, qd_plan.q, "qd", units)
    qd = _values(qd_table, qd_columns, "qd") if qd_columns else None
    if qd is not None and qd.shape != q.shape:
        raise ValueError(
            f"positions and velocities must have one shape; they are {q.shape} in {table.name} and "
            f"{qd.shape} in {qd_table.name}, a row for each sample"
        )
    if has_step:
        t = elapsed = step * np.arange(len(q))
        time_said = f"steps of {step:g} s"
    else:
        t, elapsed, unit = _times(table, plan.time, units.get("t"), chosen, q, qd)
        time_said = f"t in {unit}"
    _ask_for_degrees(table, q_columns, q)
    q = q * _sizes(q_columns)
    if limits is not None:
        _refuse_outside(table, q_columns, q, limits)
    given = qd is not None
    if given:
        if all(column.unit is None for column in qd_columns):  # that of the angles, per second
            pairs = zip(qd_columns, q_columns, strict=True)
            qd_columns = [replace(column, unit=angle.unit) for column, angle in pairs]
        qd = qd * _sizes(qd_columns)
    elif len(q) > 1:
        qd = np.gradient(q, elapsed, axis=0)
    else:
        qd = np.zeros_like(q)
    summary = _summary(table, plan, time_said, q_columns, len(q), given)
    lines = [] if has_step else [f"t: {_came_from(plan.time)}"]
    lines += _joint_lines(q_columns, qd_columns, q)
    if plan.unused:
        lines.append(f"not used: {_titles(plan.unused)}")
    return Trajectory(t, q, qd, "\n  ".join([summary, *lines]), given)


# Arguments
# -------------------------------------------------------------------------------------------------


def _table_file(path, name):
    path = file_path(path, name)
    if path.suffix.lower() not in _SUFFIXES:
        raise ValueError(
            f"{name} must name a {', '.join(_SUFFIXES[:-1])} or {_SUFFIXES[-1]} file; it is "
            f"{str(path)!r}"
        )
    return path


def _checked_units(units):
    """Return the argument `units` as a dict of units by quantity or joint."""
    if units is None:
        return {}
    if isinstance(units, list | tuple) and len(units) == 2:
        units = {key: unit for key, unit in zip(("t", "q"), units, strict=True) if unit is not None}
    expected = 'units must be such as {"t": "ms", "q": "deg"}, or ("ms", "deg")'
    if not isinstance(units, dict):
        raise ValueError(f"{expected}; it is {units!r:.60}")
    for key, unit in units.items():
        parted = re.fullmatch(r"(t|qd?)(\d*)", key) if isinstance(key, str) else None
        if not parted:
            raise ValueError(f"{expected}: its keys are t, q, qd, q1, qd1 ...; one is {key!r:.40}")
        kinds = _FILE_UNITS[parted[1]]
        known = [name for name, (kind, _) in UNITS.items() if kind in kinds]
        if not isinstance(unit, str) or unit not in known:
            raise ValueError(
                f"{expected}: of {key} it may be {', '.join(known)}; it is {unit!r:.40}"
            )
    return units


def _checked_joints(joints):
    if joints is None:
        return None
    if isinstance(joints, str) or not isinstance(joints, list | tuple) or not joints:
        raise ValueError(
            f'joints must be a list of names, such as ["joint_a1"]; it is {joints!r:.60}'
        )
    for joint in joints:
        if not isinstance(joint, str) or not joint.strip():
            raise ValueError(f"joints must be names; one is {joint!r:.40}")
    if len(set(joints)) < len(joints):
        raise ValueError(f"joints must be different names; they are {joints!r:.200}")
    return list(joints)


# Columns of angles and velocities
# -------------------------------------------------------------------------------------------------


def _with_units(table, plan, columns, kind, units, chosen=False):
    """Return the columns of angles, "q", or velocities, "qd", with the units that the user or the
    header says."""
    numbered = []
    for i, column in enumerate(columns, 1):
        key = f"{kind}{i}" if f"{kind}{i}" in units else kind
        numbered.append(_with_unit(table, column, key, units.get(key), chosen))
    _refuse_wrong_units(table, numbered, kind)
    known = {column.unit for column in numbered}
    if None in known and len(known) > 1:
        number = next(i for i, column in enumerate(numbered, 1) if column.unit is None)
        raise unclear(
            table,
            f"some columns have a unit, and {columns[number - 1].title!r} has none.",
            [*plan.time, *columns],
            f'Write its unit, for example units={{"{kind}{number}": "rad"}}.',
        )
    return numbered


def _with_unit(table, column, key, unit, chosen):
    """Return a column with the unit that the user says, if any; refuse one that its title denies.

    chosen: whether the user chose the columns, and so knows what their titles say.
    """
    if unit is None:
        return column
    known = UNITS.get(column.unit)
    if known is not None and known[1] != UNITS[unit][1] and not chosen:
        raise unclear(
            table,
            f"units says that {key} is in {unit}, and {column.title!r} says {column.unit}.",
            [column],
            f'Leave it out of units, or, if the title is wrong, add columns={{"{key}": ...}}.',
        )
    return replace(column, unit=unit)


def _refuse_wrong_units(table, columns, kind):
    """Refuse columns whose unit in the header is not one of their quantity."""
    what, kinds = _UNITS_IN_WORDS[kind], _FILE_UNITS[kind]
    known = ", ".join(name for name, (unit_kind, _) in UNITS.items() if unit_kind in kinds)
    for number, column in enumerate(columns, 1):
        if column.unit and column.unit.startswith("?"):
            key = kind if kind == "t" else f"{kind}{number}"
            raise unclear(
                table,
                f"{column.title!r} has the unit {column.unit[1:]}. The units of {what} that are "
                f"known here are {known}.",
                columns,
                f"If it is in one of these nevertheless, write it, for example "
                f'units={{"{key}": "{known.split(",")[0]}"}}.',
            )


def _values(table, columns, kind):
    """Return the columns as an array (n, k), as they stand in the file; refuse what is not
    finite."""
    labels = [_label(f"{kind}{i}", column) for i, column in enumerate(columns, 1)]
    values = [
        table.values(column.place, label) for column, label in zip(columns, labels, strict=True)
    ]
    array = np.column_stack(values)
    _refuse(table, columns, labels, ~(np.abs(array) <= _MAX_VALUE), "is not a finite number")
    return array


def _label(name, column):
    """Return what a message calls a column: its name here, and its title if that is another one."""
    if column.title.isdigit():  # there is no header
        return f"column {column.title}"
    return f"column {name}" if name == column.title else f"column {name} ({column.title!r})"


def _sizes(columns):
    return np.array([UNITS[column.unit or "rad"][1] for column in columns])


def _refuse(table, columns, labels, bad, reason, *arrays):
    """Raise ValueError for the first True in bad (n, k), with the entries of arrays in its
    reason."""
    if bad.any():
        row, column = np.argwhere(bad)[0]
        where = table.where(row, columns[column].place, labels[column])
        reason = reason.format(*(array[row, column] for array in arrays))
        raise ValueError(f"{table.name}: {where} {reason}")


def _refuse_outside(table, columns, q, limits):
    low, high = (np.broadcast_to(limit, q.shape) for limit in limits.T)
    outside = (q < low) | (q > high)
    reason = "is {:.4f} rad, outside {:.4f} to {:.4f}"
    in_degrees = np.deg2rad(q)
    fits = ((in_degrees >= low) & (in_degrees <= high)).all()
    if fits and np.abs(q).max() > np.pi and all(column.unit is None for column in columns):
        reason += '. If the angles are degrees, add units={{"q": "deg"}}'
    labels = [_label(f"q{i}", column) for i, column in enumerate(columns, 1)]
    _refuse(table, columns, labels, outside, reason, q, low, high)


# Units that nobody said
# -------------------------------------------------------------------------------------------------


def _ask_for_degrees(table, columns, q):
    reach = np.abs(q).max()
    if reach > _MAX_RADIANS and all(column.unit is None for column in columns):
        raise UnclearFileError(
            f"{table.name}: angles reach {reach:.4g}, and the header has no unit. Are they degrees?"
            ' Then add units={"q": "deg"}; if they are radians, units={"q": "rad"}'
        )


def _times(table, columns, unit, chosen, q, qd):
    """Return times (n,) in seconds, the same less the first, exact to the last digit, and their
    unit."""
    if len(columns) == 1:
        columns = [_with_unit(table, columns[0], "t", unit, chosen)]
    _refuse_wrong_units(table, columns, "t")
    ticks, unit = _ticks(table, columns)
    unit = unit or _unit_of_times(table, columns[0], ticks, q, qd)
    size = Decimal(repr(UNITS[unit][1]))
    start = ticks[0] * size
    elapsed = np.array([float((tick - ticks[0]) * size) for tick in ticks])
    t = np.array([float(tick * size) for tick in ticks])
    back = np.append(False, np.diff(elapsed) <= 0)
    if back.any():
        row = int(np.argmax(back))
        offset = 0 if abs(start) < 10**6 else start
        now, before = (float(ticks[i] * size - offset) for i in (row, row - 1))
        since = "" if offset == 0 else f" (since {float(offset):.0f} s)"
        raise ValueError(
            f"{table.name}: row {row + 1}, {_label('t', columns[0])} is {now:g} s, after {before:g}"
            f" s{since}: time must increase"
        )
    return t, elapsed, unit


def _ticks(table, columns):
    """Return the times as they stand in the file, as decimals without rounding, and their unit, or
    None."""
    label = _label("t", columns[0])
    texts = _clock_readings(table, columns[0].place)
    if texts is not None:
        return texts, "s"
    for column in columns:
        values = table.values(column.place, _label("t", column))[:, None]
        bad = ~(np.abs(values) <= _MAX_VALUE)
        _refuse(table, [column], [label], bad, "is not a finite number")
    cells = [_decimals(table, column.place) for column in columns]
    if len(columns) == 1:
        return cells[0], columns[0].unit
    nano = Decimal("1e-9")
    return [whole + nano * part for whole, part in zip(*cells, strict=True)], "s"


def _decimals(table, place):
    cells = table.cells(place)
    if table.decimal_comma:
        cells = [cell.replace(",", ".") for cell in cells]
    return [Decimal(cell) for cell in cells]


def _clock_readings(table, place):
    """Return times that are no plain numbers, in seconds, or None: "0.1 sec", 00:01:02.5, dates of
    ISO 8601.

    MATLAB writes the first two for a duration.
    """
    cells = table.cells(place)
    try:
        if all(re.fullmatch(r"[-+.,\de]+ ?s(ec)?", cell) for cell in cells):
            return [Decimal(cell.rstrip("sec ").replace(",", ".")) for cell in cells]
        if all(re.fullmatch(r"\d+:\d\d:\d\d([.,]\d+)?", cell) for cell in cells):
            return [_seconds_of_clock(cell.replace(",", ".")) for cell in cells]
        if all(re.match(r"\d{4}-\d\d-\d\d[ T]\d", cell) for cell in cells):
            moments = [datetime.fromisoformat(cell) for cell in cells]
            return [_seconds_between(moments[0], moment) for moment in moments]
    except (ValueError, TypeError, InvalidOperation):  # TypeError: only some have a time zone
        return None
    return None


def _seconds_of_clock(cell):
    hours, minutes, seconds = cell.split(":")
    return 3600 * int(hours) + 60 * int(minutes) + Decimal(seconds)


def _seconds_between(first, moment):
    passed = moment - first
    return Decimal(86400 * passed.days + passed.seconds) + Decimal(passed.microseconds) / 10**6


def _unit_of_times(table, column, ticks, q, qd):
    """Return the unit of times without one: seconds, or what is certain from the numbers; else
    ask."""
    first = float(ticks[0])
    for unit in ("ns", "us", "ms", "s"):
        if _SINCE_1970[0] < first * UNITS[unit][1] < _SINCE_1970[1]:
            return unit
    if len(ticks) < 2:
        return "s"
    steps = np.diff([float(tick) for tick in ticks])
    step = float(np.median(steps))
    if step < _SLOW:
        return "s"
    if qd is not None:
        # Velocities tell: a motion that fits them in seconds is a slow one.
        moved = np.abs(np.diff(q, axis=0)).sum()
        expected = np.abs(steps[:, None] * qd[1:]).sum()
        if moved >= 0.05 * expected > 0:
            return "s"
    rates = ", ".join(f"{1 / (step * UNITS[u][1]):.4g} in {u}" for u in ("s", "ms", "us", "ns"))
    raise UnclearFileError(
        f"{table.name}: times, {column.title!r}, are {step:.4g} apart, and the header has no unit. "
        "Are they milliseconds? Or micro- or nanoseconds? Samples per second would be: "
        f'{rates}. Add the right one, units={{"t": "s"}}, {{"t": "ms"}}, {{"t": "us"}} or '
        '{"t": "ns"}'
    )


# What is said of the file
# -------------------------------------------------------------------------------------------------


def _summary(table, plan, time_said, q_columns, rows, given):
    k = len(q_columns)
    plural = k > 1
    units = " and ".join(sorted({column.unit or "rad" for column in q_columns}))
    velocities = "no velocities (differences of the samples)"
    if given:
        velocities = f"{k} velocities" if plural else "1 velocity"
    angles = f"{k} angle{'s' * plural} in {units}"
    return f"{rows} rows, {time_said}, {angles}, {velocities}{table.remark}{plan.remark}"


def _came_from(columns):
    titles = " and ".join(f"{column.title!r}" for column in columns)
    if len(columns) == 2:
        return f"{titles}, seconds and nanoseconds"
    unit = "no unit in the header" if columns[0].unit is None else columns[0].unit
    return f"{titles}, {unit}"


def _joint_lines(q_columns, qd_columns, q):
    """Return a line for each joint: its columns, its unit, and its range in degrees."""
    lines = []
    for i, column in enumerate(q_columns):
        unit = "no unit in the header" if column.unit is None else column.unit
        low, high = np.rad2deg([q[:, i].min(), q[:, i].max()])
        speed = f"; qd{i + 1}: {qd_columns[i].title!r}" if qd_columns else ""
        reach = f"{low + 0.0:.1f} to {high + 0.0:.1f} degrees"
        lines.append(f"q{i + 1}: {column.title!r}, {unit}, {reach}{speed}")
    return lines


def _titles(columns):
    titles = [column.title or f"column {column.place + 1}" for column in columns]
    if len(titles) > 12:
        titles = [*titles[:6], "...", *titles[-5:]]
    return ", ".join(titles)
