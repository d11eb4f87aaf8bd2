"""Joint trajectories in files: read what other programs write, or say in a sentence what is wrong or not clear.

A file holds time in seconds, the joint angles in radians and, if it has them, the velocities: a
table as text (comma, semicolon, tab or spaces between columns, decimal point or comma) or NPY. A
header names the columns in the words of common programs; without one they are t, q1 ... qk, qd1 ...
qdk. Or two files hold positions and velocities, (n, k) or (k, n), and the time step is given. Rows
count from 1, without a header.
"""

import codecs
import csv
import os
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from course_lib.arguments import positive, real_array

# What a column of a header is, by the first of these that fits; a number in its name is the
# joint's.
_KINDS = {
    "other": r"name|header|frame|seq|eff|torque|acc|qdd|ddq|current|finger|gripper",
    "qd": r"vel|speed|qd|dq|dot|geschw|^v\d",
    "t": r"^\W*t$|time|zeit|stamp|^sec",
    "q": r"\d|joint|pos",
}
_UNIT = r"(.*?)[\[(_ ]+(s|ms|ns|rad|deg|°)(?:/s)?[\])]?$"
_TIMES, _ANGLES = {"s": 1.0, "ms": 1e-3, "ns": 1e-9}, {"rad": 1.0, "deg": np.pi / 180}


@dataclass(frozen=True)
class Trajectory:
    """A joint trajectory.

    Attributes
    ----------
    t : array (n,)
        Seconds.
    q, qd : array (n, k)
        Joint angles in radians, joint velocities in radians per second.
    understood : str
        How the file was read, in words.
    """

    t: np.ndarray
    q: np.ndarray
    qd: np.ndarray
    understood: str = ""


def load(path, limits=None, velocities=None, step=None, units=None):
    """Return the Trajectory in a file of another program, or in one of positions and one of velocities.

    Parameters
    ----------
    path : str or pathlib.Path
        A file as described at the top of this module; of positions alone if `velocities` or `step`
        is given.
    limits : array_like (k, 2), optional
        Lowest and highest angle of each joint, in radians. None for any.
    velocities : str or pathlib.Path, optional
        The file of the velocities. Samples are the rows, or the columns if only the columns have
        `limits` for rows.
    step : float, optional
        The time between two samples, in seconds, if times are not in the file.
    units : (str, str), optional
        Of times, "s", "ms" or "ns", and of angles, "rad" or "deg", if the header does not say.

    Returns
    -------
    Trajectory
        Velocities that are not in the file are differences of the samples.

    Raises
    ------
    ValueError
        If a column is missing or occurs twice, samples are the columns of a table with times, or a
        cell is not a finite number, is outside its limits, or makes time stand still; it names
        file, row and column. If units are not clear, it asks.

    Examples
    --------
    >>> import tempfile
    >>> folder = Path(tempfile.mkdtemp())
    >>> _ = (folder / "own.csv").write_text("Zeit;Achse 1\\n0,0;0,1\\n0,5;0,6\\n")
    >>> own = load(folder / "own.csv", limits=[[-1, 1]])
    >>> print(own.q.T, own.understood, sep="\\n")
    [[0.1 0.6]]
    2 rows, t in s, 1 angle in rad, no velocities (differences of the samples), decimal comma
    """
    if velocities is not None and step is None:
        raise ValueError("velocities need the time step between two samples, in seconds")
    if units is not None and (len(units) != 2 or units[0] not in _TIMES or units[1] not in _ANGLES):
        raise ValueError(
            f"units must be of times, s, ms or ns, and of angles, rad or deg; it is {units!r:.60}"
        )
    paths = [_path(path)] + ([] if velocities is None else [_path(velocities)])
    for each in paths:
        if each.suffix.lower() not in (".csv", ".tsv", ".txt", ".dat", ".npy"):
            raise ValueError(
                f"path must name a .csv, .tsv, .txt, .dat or .npy file; it is {str(each)!r}"
            )
    if limits is not None:
        limits = real_array(limits, "limits", (2,), infinite=True)
    tables, names, found, said = zip(
        *(_read(each, limits, step is None) for each in paths), strict=True
    )
    if step is None:
        table, places = (
            tables[0],
            lambda row, column: f"{paths[0].name}: row {row + 1}, column {names[0][column]}",
        )
        k = sum(not name.startswith("qd") for name in names[0]) - 1
    else:
        table, places = _joined(paths, tables, limits, positive(step, "step", batched=False))
        k = (table.shape[1] - 1) // len(paths)
    _refuse(places, ~np.isfinite(table), "is not a finite number")
    time, angle = _units(
        paths[0].name, table, k, units or (found[0][0] if step is None else "s", found[0][1])
    )
    table = table * np.r_[_TIMES[time], np.full(table.shape[1] - 1, _ANGLES[angle])]
    t = table[:, 0]
    back = np.zeros(table.shape, bool)
    back[1:, 0] = np.diff(t) <= 0
    _refuse(
        places, back, "is {:g} s, after {:g} s: time must increase", table, np.roll(table, 1, 0)
    )
    low, high = np.full(table.shape, -np.inf), np.full(table.shape, np.inf)
    if limits is not None:
        low[:, 1 : k + 1], high[:, 1 : k + 1] = real_array(
            limits, "limits", (k, 2), batched=False, infinite=True
        ).T
    outside = (table < low) | (table > high)
    _refuse(places, outside, "is {:.4f} rad, outside {:.4f} to {:.4f}", table, low, high)
    q, qd, count = (
        table[:, 1 : k + 1],
        table[:, k + 1 :],
        f"{k} velocities" if k > 1 else "1 velocity",
    )
    if not qd.size:
        qd, count = (
            np.gradient(q, t, axis=0) if len(t) > 1 else 0 * q,
            "no velocities (differences of the samples)",
        )
    steps = f"t in {time}" if step is None else f"steps of {step:g} s"
    understood = f"{len(t)} rows, {steps}, {k} angle{'s' * (k > 1)} in {angle}, {count}{said[0]}"
    return Trajectory(t, q, qd, understood)


def disagreement(trajectory):
    """Return a sentence on how positions, velocities and times disagree, or "" if they agree or nothing moves.

    Joint by joint: its angles less the integral of its velocity must not grow, and the factor by
    which all times would have to be multiplied for the best fit must be 1. The tolerance of the
    factor follows from the sampling: from how much the trapezoidal rule may be off, by the changes
    of the velocity, and from the scatter of the fit.

    Parameters
    ----------
    trajectory : Trajectory

    Returns
    -------
    str

    Examples
    --------
    >>> disagreement(Trajectory(np.array([0.0, 1]), np.array([[0.0], [2]]), np.array([[1.0], [1]])))
    'The velocities fit times that are 2 times as far apart: a mean step of about 2 s, not 1 s.'
    """
    t, q, qd = _checked(trajectory)
    moved, steps = np.diff(q, axis=0), np.diff(t)[:, None]
    expected = steps * (qd[1:] + qd[:-1]) / 2
    moving = np.maximum(np.abs(moved).max(0, initial=0), np.abs(expected).max(0, initial=0)) > 1e-6
    if not moving.any():
        return ""
    square = np.maximum((expected**2).sum(0), 1e-300)
    factor = (moved * expected).sum(0) / square
    left = np.cumsum(moved - factor * expected, axis=0)
    scatter = np.linalg.norm(moved - factor * expected, axis=0) / np.sqrt(
        square * max(len(moved) - 1, 1)
    )
    change = (
        np.abs(np.diff(qd, 2, axis=0)).max(0) / 6
        if len(t) > 2
        else np.abs(np.diff(qd, axis=0)).max(0) / 2
    )
    allowed = 0.01 + 3 * scatter + change * np.linalg.norm(steps) / np.sqrt(square)
    noise = 4 * np.std(np.diff(q, 2, axis=0), axis=0) if len(t) > 2 else 0
    wrong = moving & (
        (np.ptp(left, axis=0) > 0.3 * np.ptp(q, axis=0) + noise) | ((factor <= 0) & (allowed < 1))
    )
    off = moving & (np.abs(factor - 1) > allowed)
    if not (wrong | off).any():
        return ""
    which = np.flatnonzero(wrong | off) + 1
    joint = f" of joint{'s' * (len(which) > 1)} {', '.join(map(str, which))}"
    if wrong.any():
        worst = np.abs((moved - expected) / steps)[:, wrong].max()
        whose = "" if wrong[moving].all() else joint
        said = f"The velocities{whose} are not those of the positions, whatever the times"
        return f"{said}: off by up to {worst:.3g} rad/s."
    mean = np.median(factor[moving])
    if (np.abs(factor - mean)[moving] <= allowed[moving] + 0.01 * mean).all():
        said = f"The velocities fit times that are {mean:.3g} times as far apart"
        return (
            f"{said}: a mean step of about {mean * steps.mean():.2g} s, not {steps.mean():.3g} s."
        )
    factors = ", ".join(f"{each:.3g}" for each in factor[off])
    return f"The positions move {factors} times as fast as the velocities{joint} say."


def save(path, trajectory):
    """Write a Trajectory as CSV, with ten decimals.

    Parameters
    ----------
    path : str or pathlib.Path
        The file; an existing one is replaced.
    trajectory : Trajectory

    Examples
    --------
    >>> import tempfile
    >>> path = Path(tempfile.mkdtemp()) / "made.csv"
    >>> save(path, Trajectory(np.array([0.0, 1]), np.array([[1.0], [2]]), np.array([[1.0], [1]])))
    >>> print(path.read_text().splitlines()[0])
    t,q1,qd1
    """
    t, q, qd = _checked(trajectory)
    header, table = ",".join(_names(q.shape[1])), np.column_stack([t, q, qd])
    np.savetxt(_path(path), table, fmt="%.10f", delimiter=",", header=header, comments="")


def _checked(trajectory):
    """Return the arrays t, q and qd of a Trajectory, or refuse it."""
    if not isinstance(trajectory, Trajectory):
        raise ValueError(
            f"trajectory must be a Trajectory; it is of type {type(trajectory).__name__}"
        )
    t, q, qd = (
        real_array(getattr(trajectory, name), f"trajectory.{name}", ()) for name in ("t", "q", "qd")
    )
    if t.ndim != 1 or q.ndim != 2 or q.shape != qd.shape or len(t) != len(q):
        raise ValueError(
            f"trajectory must hold t (n,), q and qd (n, k); their shapes are {t.shape}, {q.shape} "
            f"and {qd.shape}"
        )
    return t, q, qd


def _path(path):
    if not isinstance(path, str | os.PathLike):
        raise ValueError(
            f"path must be a text or a pathlib.Path; it is of type {type(path).__name__}"
        )
    if "\0" in os.fspath(path):
        raise ValueError(f"path must name a file; it holds a null character: {str(path)!r:.80}")
    return Path(path)


def _names(k):
    return ["t", *(f"q{i}" for i in range(1, k + 1)), *(f"qd{i}" for i in range(1, k + 1))]


def _units(name, table, k, units):
    """Return the units of times and angles, as given or as certain from the numbers; else ask."""
    (time, angle), t, q, qd = units, table[:, 0], table[:, 1 : k + 1], table[:, k + 1 :]
    reach, step = np.abs(q).max(), np.median(np.diff(t)) if len(t) > 1 else 0
    ask = "Then add units=(%r, %r); if not, units=('s', 'rad')"
    if angle is None and reach > 4 * np.pi:
        raise ValueError(
            f"{name}: angles reach {reach:.4g}. Are they degrees? {ask % (time or 's', 'deg')}"
        )
    if time is None and t[0] > 1e17:
        time = "ns"  # since 1970, as ROS counts
    moved, expected = np.abs(np.diff(q, axis=0)).sum(), np.abs(np.diff(t)[:, None] * qd[1:]).sum()
    if time is None and step >= 1 and (moved < 0.05 * expected or not qd.size):
        raise ValueError(
            f"{name}: times are {step:.4g} apart. Are they milliseconds? "
            f"{ask % ('ms', angle or 'rad')}"
        )
    return time or "s", angle or "rad"


def _joined(paths, tables, limits, step):
    """Return one table of those of positions and velocities, and a function (row, column): where an entry is."""
    swapped = [
        limits is not None and len(limits) == len(table) != table.shape[1] for table in tables
    ]
    tables = [table.T if swap else table for table, swap in zip(tables, swapped, strict=True)]
    if tables[0].shape != tables[-1].shape:
        shapes = " and ".join(
            f"{table.shape} in {path.name}" for table, path in zip(tables, paths, strict=True)
        )
        raise ValueError(
            f"positions and velocities must have one shape; they are {shapes}, a row for each "
            f"sample"
        )
    n, k = tables[0].shape

    def place(row, column):
        second = int(column > k)
        at = [row + 1, column - second * k]
        return "{}: row {}, column {}".format(
            paths[second].name, *(at[::-1] if swapped[second] else at)
        )

    return np.column_stack([step * np.arange(n), *tables]), place


def _read(path, limits, times):
    """Return a file's table, with the columns t, q1 ...

    qd1 ... if it has times; their names, units, and a remark.
    """
    head, rows, remark = _npy(path) if path.suffix.lower() == ".npy" else _text(path)
    if head and times:
        columns, units = _columns(path.name, head)
        return _numbers(path.name, rows, columns, len(head)), list(columns), units, remark
    table = _numbers(path.name, rows, {i + 1: i for i in range(len(rows[0]))}, len(rows[0]))
    if not times:
        return table, range(1, table.shape[1] + 1), (None, None), remark
    k = 0 if limits is None else len(limits)
    fits = (1 + k, 1 + 2 * k) if k else range(3, 1000, 2)
    if (m := table.shape[1]) not in fits:
        raise ValueError(
            f"{path.name} must begin with a header, or hold t, q1 ..., qd1 ...: column t is "
            f"missing, or others; its "
            f"shape is {table.shape}. For positions alone, give the time step, and the file of the "
            f"velocities if any"
        )
    return table, _names(k or m // 2)[:m], (None, None), f"{remark}, no header"


def _npy(path):
    try:
        table = np.load(path, allow_pickle=False)
    except (ValueError, EOFError) as unreadable:
        raise ValueError(f"{path.name} cannot be read as NPY: {unreadable}") from unreadable
    if table.dtype.kind not in "iuf":
        raise ValueError(f"{path.name} must hold real numbers; it holds {table.dtype}")
    if table.ndim != 2 or table.size == 0:
        raise ValueError(
            f"{path.name} must hold a table with a row for each sample; its shape is {table.shape}"
        )
    return [], table, ""


def _text(path):
    """Return the header, [] if there is none, the rows of a text file, cells as text, and a remark."""
    data = path.read_bytes()
    wide = data[:2] in (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
    try:
        text = data.decode("utf-16" if wide else "utf-8-sig", "replace" if wide else "strict")
    except UnicodeDecodeError:
        text = data.decode("cp1252", "replace")  # as spreadsheets write
    lines = [
        line
        for line in text.splitlines()
        if line.strip(" ,;\t") and not line.lower().startswith("sep=")
    ]
    first = next((i for i, line in enumerate(lines) if _is_data(line)), None)
    if first is None:
        raise ValueError(
            f"{path.name} cannot be read as a table: it must hold a row of numbers, and holds none"
        )
    line = lines[first].strip()
    words = line.split()
    comma = len(words) > 1 and all(
        re.fullmatch(r"[-+]?\d+(,\d+)?(e[-+]?\d+)?", word, re.I) for word in words
    )
    separator = next(
        (each for each in ";\t" if each in line), " " if "," not in line or comma else ","
    )

    def cells(lines, separator=separator):
        lines = [
            " ".join(line.split()) if separator == " " else line.strip(" \r\n").rstrip("; ")
            for line in lines
        ]
        return [
            [cell.strip() for cell in row]
            for row in csv.reader(lines, delimiter=separator, skipinitialspace=True)
        ]

    rows = cells(line for line in lines[first:] if line[0] not in "#%")
    titles = [
        cells([line.lstrip("#% ")], each)[0]
        for each in (separator, ",", " ")
        for line in lines[:first][::-1]
    ]
    head = next((found for found in titles if len(found) == len(rows[0])), [])
    if not head and first and lines[first - 1][0] not in "#%":
        head = cells([lines[first - 1]])[0]
    decimal = separator != "," and any("," in cell for cell in rows[0])
    if decimal:
        rows = [[cell.replace(",", ".") for cell in row] for row in rows]
    return head, rows, ", decimal comma" if decimal else ""


def _columns(name, head):
    """Return where the columns t, q1 ...

    and, if there are any, qd1 ... stand in a header, and the units in it.
    """
    found, units = {"t": [], "q": [], "qd": [], "other": []}, [None, None]
    for place, title in enumerate(head):
        bare, unit = (
            parted.groups()
            if (parted := re.fullmatch(_UNIT, title.lower()))
            else (title.lower(), None)
        )
        kind = next((kind for kind, words in _KINDS.items() if re.search(words, bare)), "other")
        number = re.findall(r"\d+", bare) or [len(found[kind]) + 1]
        found[kind].append((int(number[-1]), place))
        if kind in "tq" and unit:
            units[kind == "q"] = unit.replace("°", "deg")
    numbers = [number for number, _ in found["q"] + found["qd"]]
    start, k = int(min(numbers, default=1) > 0), max(numbers, default=1)
    columns = {"t": [place for _, place in found["t"][:1]]}
    for kind in ("q", "qd") if found["qd"] else ("q",):
        for i in range(start, k + 1):
            columns[f"{kind}{i + 1 - start}"] = [
                place for number, place in found[kind] if number == i
            ]
    for column, places in columns.items():
        if len(places) != 1:
            how = "occurs twice" if places else "is missing"
            raise ValueError(f"{name}: column {column} {how}; its header is {','.join(head):.80}")
    return {column: places[0] for column, places in columns.items()}, units


def _numbers(name, rows, columns, width):
    """Return a table of the numbers in some columns {name: place} of rows of text."""
    table = np.empty((len(rows), len(columns)))
    for number, row in enumerate(rows):
        if len(row) != width:
            raise ValueError(f"{name}: row {number + 1} has {len(row)} columns, not {width}")
        for i, (column, place) in enumerate(columns.items()):
            if not _is_number(row[place]):
                where = f"{name}: row {number + 1}, column {column}"
                raise ValueError(f"{where} is {row[place]!r:.40}, which is not a number")
            table[number, i] = float(row[place])
    return table


def _is_data(line):
    words = [word for word in re.split(r"[\s,;\"]+", line) if word]
    return line[0] not in "#%" and 2 * sum(map(_is_number, words)) > len(words)


def _is_number(text):
    try:
        float(text)
    except ValueError:
        return False
    return True


def _refuse(place, bad, reason, *tables):
    """Raise ValueError for the first True in bad, as refuse_first does; place(row, column) says where it is."""
    if bad.any():
        row, column = np.argwhere(bad)[0]
        raise ValueError(
            f"{place(row, column)} {reason.format(*(table[row, column] for table in tables))}"
        )
