"""Joint trajectories in files: read one, or refuse a broken one in a sentence that names row and column.

Either one file holds everything: CSV with a header, or NPY, an array (n, 1 + 2 k), with the columns t in seconds, the
positions q1 ... qk in radians, the velocities qd1 ... qdk in radians per second. Or two files, CSV without a header or
NPY, hold positions and velocities, (n, k) or (k, n), and the time step is given. Rows count from 1, without a header.
"""

import os
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from course_lib.arguments import positive, real_array


@dataclass(frozen=True)
class Trajectory:
    """A joint trajectory.

    Attributes
    ----------
    t : array (n,)
        Seconds.
    q, qd : array (n, k)
        Joint angles in radians, joint velocities in radians per second.
    """

    t: np.ndarray
    q: np.ndarray
    qd: np.ndarray


def load(path, limits=None, velocities=None, step=None):
    """Return the Trajectory in a CSV or NPY file, or in one of positions and one of velocities.

    Parameters
    ----------
    path : str or pathlib.Path
        A file as described at the top of this module; of positions alone if `velocities` is given.
    limits : array_like (k, 2), optional
        Lowest and highest angle of each joint, in radians. None for any.
    velocities : str or pathlib.Path, optional
        The file of the velocities. Samples are the rows, or the columns if only the columns have `limits` for rows.
    step : float, optional
        The time between two samples, in seconds, if times are not in the file.

    Returns
    -------
    Trajectory

    Raises
    ------
    ValueError
        If a column is missing or occurs twice, or a cell is not a finite number, is outside its limits, or makes time
        stand still; it names file, row and column. If one of `velocities` and `step` is given without the other.

    Examples
    --------
    >>> import tempfile
    >>> folder = Path(tempfile.mkdtemp())
    >>> _ = (folder / "own.csv").write_text("t,q1,qd1\\n0,0.1,1\\n0.5,0.6,1\\n")
    >>> print(load(folder / "own.csv", limits=[[-1, 1]]).q.T)
    [[0.1 0.6]]
    >>> _ = (folder / "q.csv").write_text("0.1\\n0.6\\n"), (folder / "qd.csv").write_text("1\\n1\\n")
    >>> print(load(folder / "q.csv", velocities=folder / "qd.csv", step=0.5).t)
    [0.  0.5]
    """
    if (velocities is None) != (step is None):
        raise ValueError("velocities and step belong together: a file of velocities needs the time step, in seconds")
    paths = [_path(path)] if velocities is None else [_path(path), _path(velocities)]
    for each in paths:
        if each.suffix.lower() not in (".csv", ".npy"):
            raise ValueError(f"path must name a .csv or .npy file; it is {str(each)!r}")
    if limits is not None:
        limits = real_array(limits, "limits", (2,), infinite=True)
    tables, names = zip(*(_read(each, step is None) for each in paths), strict=True)
    if step is None:
        table, places = tables[0], lambda row, column: f"{paths[0].name}: row {row + 1}, column {names[0][column]}"
    else:
        table, places = _joined(paths, tables, limits, positive(step, "step", batched=False))
    _refuse(places, ~np.isfinite(table), "is not a finite number")
    t, k = table[:, 0], table.shape[1] // 2
    back = np.zeros(table.shape, bool)
    back[1:, 0] = np.diff(t) <= 0
    _refuse(places, back, "is {:g} s, after {:g} s: time must increase", table, np.roll(table, 1, 0))
    low, high = np.full(table.shape, -np.inf), np.full(table.shape, np.inf)
    if limits is not None:
        low[:, 1 : k + 1], high[:, 1 : k + 1] = real_array(limits, "limits", (k, 2), batched=False, infinite=True).T
    outside = (table < low) | (table > high)
    _refuse(places, outside, "is {:.4f} rad, outside {:.4f} to {:.4f}", table, low, high)
    return Trajectory(t, table[:, 1 : k + 1], table[:, k + 1 :])


def disagreement(trajectory):
    """Return a sentence on how positions, velocities and times disagree, or "" if they agree or nothing moves.

    Between two samples a joint should move by the time times the mean of both velocities. The factor by which all
    times would have to be multiplied for the best fit should be 1 (within 10 %), and little should be left over.

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
    moved, steps = np.diff(q, axis=0), np.diff(t)
    expected = steps[:, None] * (qd[1:] + qd[:-1]) / 2
    if max(np.abs(moved).max(initial=0), np.abs(expected).max(initial=0)) < 1e-6:
        return ""
    factor = (moved * expected).sum() / max((expected**2).sum(), 1e-300)
    left = np.linalg.norm(moved - factor * expected) / max(np.linalg.norm(moved), 1e-300)
    if left > 0.3 or factor <= 0:
        off = np.abs((moved - expected) / steps[:, None]).max()
        return f"The velocities are not those of the positions, whatever the times: off by up to {off:.3g} rad/s."
    if abs(factor - 1) < 0.1:
        return ""
    said = f"The velocities fit times that are {factor:.3g} times as far apart"
    return f"{said}: a mean step of about {factor * steps.mean():.2g} s, not {steps.mean():.3g} s."


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
        raise ValueError(f"trajectory must be a Trajectory; it is of type {type(trajectory).__name__}")
    t, q, qd = (real_array(getattr(trajectory, name), f"trajectory.{name}", ()) for name in ("t", "q", "qd"))
    if t.ndim != 1 or q.ndim != 2 or q.shape != qd.shape or len(t) != len(q):
        raise ValueError(
            f"trajectory must hold t (n,), q and qd (n, k); their shapes are {t.shape}, {q.shape} and {qd.shape}"
        )
    return t, q, qd


def _path(path):
    if not isinstance(path, str | os.PathLike):
        raise ValueError(f"path must be a text or a pathlib.Path; it is of type {type(path).__name__}")
    if "\0" in os.fspath(path):
        raise ValueError(f"path must name a file; it holds a null character: {str(path)!r:.80}")
    return Path(path)


def _names(k):
    return ["t", *(f"q{i}" for i in range(1, k + 1)), *(f"qd{i}" for i in range(1, k + 1))]


def _joined(paths, tables, limits, step):
    """Return one table of those of positions and velocities, and a function (row, column): where an entry is."""
    swapped = [limits is not None and len(limits) == len(table) != table.shape[1] for table in tables]
    q, qd = (table.T if swap else table for table, swap in zip(tables, swapped, strict=True))
    if q.shape != qd.shape:
        shapes = " and ".join(f"{table.shape} in {path.name}" for table, path in zip(tables, paths, strict=True))
        raise ValueError(f"positions and velocities must have one shape; they are {shapes}")

    def place(row, column):
        second = int(column > q.shape[1])
        at = [row + 1, column - second * q.shape[1]]
        return "{}: row {}, column {}".format(paths[second].name, *(at[::-1] if swapped[second] else at))

    return np.column_stack([step * np.arange(len(q)), q, qd]), place


def _read(path, header):
    """Return the table of numbers in a file, and its columns' names: t, q1 ... if it has a header, else 1, 2 ..."""
    if path.suffix.lower() == ".csv":
        return _read_csv(path, header)
    try:
        table = np.load(path, allow_pickle=False)
    except (ValueError, EOFError) as unreadable:
        raise ValueError(f"{path.name} cannot be read as NPY: {unreadable}") from unreadable
    if table.dtype.kind not in "iuf":
        raise ValueError(f"{path.name} must hold real numbers; it holds {table.dtype}")
    if table.ndim != 2 or table.size == 0 or (header and (table.shape[1] < 3 or table.shape[1] % 2 == 0)):
        kind = "an array of shape (n, 1 + 2 k): t, q1.., qd1.." if header else "a table with a row for each sample"
        raise ValueError(f"{path.name} must hold {kind}; its shape is {table.shape}")
    return table.astype(float), _names(table.shape[1] // 2) if header else range(1, table.shape[1] + 1)


def _read_csv(path, header):
    """Return the same of a CSV file. Semicolons and spaces separate, too; without names, a line of words is ignored."""
    try:
        lines = path.read_text("utf-8-sig").replace('"', "").splitlines()
    except UnicodeDecodeError as unreadable:
        raise ValueError(f"{path.name} cannot be read as CSV: {unreadable}") from unreadable
    rows = [re.split(r"\s*[,;]\s*|\s+", line.strip().rstrip("; ")) for line in lines if line.strip(" ,;\t")]
    head = rows.pop(0) if rows and not any(map(_is_number, rows[0])) else []
    if header and rows and not head:
        raise ValueError(
            f"{path.name} must begin with a header t,q1,...,qd1,...: column t is missing, its first line holds "
            "numbers. For positions alone, name the file of the velocities and the time step"
        )
    if not rows:
        raise ValueError(f"{path.name} must hold a row of numbers; it holds none")
    k = max(1, *(sum(bool(re.match(rf"{kind}\d", name)) for name in head) for kind in ("q", "qd")))
    names = _names(k) if header else range(1, len(rows[0]) + 1)
    for name in names if header else ():
        if head.count(name) != 1:
            how = "is missing" if name not in head else "occurs twice"
            raise ValueError(f"{path.name}: column {name} {how}; its header is {','.join(head):.80}")
    columns = head if header else list(names)
    table = np.empty((len(rows), len(names)))
    for number, row in enumerate(rows):
        if len(row) != len(columns):
            raise ValueError(f"{path.name}: row {number + 1} has {len(row)} columns, not {len(columns)}")
        for column, name in enumerate(names):
            cell = row[columns.index(name)]
            if not _is_number(cell):
                where = f"{path.name}: row {number + 1}, column {name}"
                raise ValueError(f"{where} is {cell!r:.40}, which is not a number")
            table[number, column] = float(cell)
    return table, names


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
        raise ValueError(f"{place(row, column)} {reason.format(*(table[row, column] for table in tables))}")
