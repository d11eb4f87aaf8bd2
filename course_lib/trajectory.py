"""Joint trajectories in files: read one, or refuse a broken one in a sentence that names row and column.

A file is CSV, with a header, or NPY, an array (n, 1 + 2 k). Columns: t in seconds, then the positions q1 ... qk in
radians, then the velocities qd1 ... qdk in radians per second. Rows count from 1, a header is not counted.
"""

import csv
import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from course_lib.arguments import real_array


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


def load(path, limits=None):
    """Return the Trajectory in a CSV or NPY file.

    Parameters
    ----------
    path : str or pathlib.Path
        A file as described at the top of this module.
    limits : array_like (k, 2), optional
        Lowest and highest angle of each joint, in radians. None for any.

    Returns
    -------
    Trajectory

    Raises
    ------
    ValueError
        If a column is missing or occurs twice, or a cell is not a finite number, is outside its limits, or makes time
        stand still; it names file, row and column.
    OSError
        If there is no such file.

    Examples
    --------
    >>> import tempfile
    >>> path = Path(tempfile.mkdtemp()) / "own.csv"
    >>> _ = path.write_text("t,q1,qd1\\n0,0.1,1\\n0.5,0.6,1\\n")
    >>> print(load(path, limits=[[-1, 1]]).q.T)
    [[0.1 0.6]]
    """
    path = _path(path)
    kind = path.suffix.lower()
    if kind not in (".csv", ".npy"):
        raise ValueError(f"path must name a .csv or .npy file; it is {str(path)!r}")
    table, names = _read_csv(path) if kind == ".csv" else _read_npy(path)
    _refuse(path, names, ~np.isfinite(table), lambda row, column: "is not a finite number")
    t, k = table[:, 0], (len(names) - 1) // 2
    back = np.zeros(table.shape, bool)
    back[1:, 0] = np.diff(t) <= 0
    _refuse(path, names, back, lambda row, column: f"is {t[row]:g} s, after {t[row - 1]:g} s: time must increase")
    if limits is not None:
        limits = real_array(limits, "limits", (2,), infinite=True)
        if limits.shape != (k, 2):
            raise ValueError(
                f"limits must have shape ({k}, 2), for the {k} joints of {path.name}; it is {limits.shape}"
            )
        outside = np.zeros(table.shape, bool)
        outside[:, 1 : k + 1] = (table[:, 1 : k + 1] < limits[:, 0]) | (table[:, 1 : k + 1] > limits[:, 1])
        _refuse(
            path,
            names,
            outside,
            lambda row, column: (
                f"is {table[row, column]:.4f} rad, outside {limits[column - 1, 0]:.4f} to {limits[column - 1, 1]:.4f}"
            ),
        )
    return Trajectory(t, table[:, 1 : k + 1], table[:, k + 1 :])


def save(path, trajectory):
    """Write a Trajectory as CSV, with ten decimals.

    Parameters
    ----------
    path : str or pathlib.Path
        The file; an existing one is replaced.
    trajectory : Trajectory

    Raises
    ------
    ValueError
        If `trajectory` is not a Trajectory of finite real numbers with matching shapes.
    OSError
        If the file cannot be written.

    Examples
    --------
    >>> import tempfile
    >>> path = Path(tempfile.mkdtemp()) / "made.csv"
    >>> save(path, Trajectory(np.array([0.0, 1]), np.array([[1.0], [2]]), np.array([[1.0], [1]])))
    >>> print(path.read_text().splitlines()[0])
    t,q1,qd1
    """
    if not isinstance(trajectory, Trajectory):
        raise ValueError(f"trajectory must be a Trajectory; it is of type {type(trajectory).__name__}")
    t, q, qd = (real_array(getattr(trajectory, name), f"trajectory.{name}", ()) for name in ("t", "q", "qd"))
    if t.ndim != 1 or q.ndim != 2 or q.shape != qd.shape or len(t) != len(q):
        raise ValueError(
            f"trajectory must hold t (n,), q and qd (n, k); their shapes are {t.shape}, {q.shape} and {qd.shape}"
        )
    names = _names(q.shape[1])
    table = np.column_stack([t, q, qd])
    np.savetxt(_path(path), table, fmt="%.10f", delimiter=",", header=",".join(names), comments="")


def _path(path):
    if not isinstance(path, str | os.PathLike):
        raise ValueError(f"path must be a text or a pathlib.Path; it is of type {type(path).__name__}")
    if "\0" in os.fspath(path):
        raise ValueError(f"path must name a file; it holds a null character: {str(path)!r:.80}")
    return Path(path)


def _names(k):
    return ["t", *(f"q{i}" for i in range(1, k + 1)), *(f"qd{i}" for i in range(1, k + 1))]


def _read_csv(path):
    with path.open(newline="", encoding="utf-8-sig") as file:
        try:
            rows = [row for row in csv.reader(file) if any(cell.strip() for cell in row)]
        except (csv.Error, UnicodeDecodeError) as unreadable:
            raise ValueError(f"{path.name} cannot be read as CSV: {unreadable}") from unreadable
    if len(rows) < 2:
        raise ValueError(f"{path.name} must hold a header and at least one row; it holds {len(rows)} lines")
    header = [cell.strip() for cell in rows[0]]
    positions = sum(name.startswith("q") and not name.startswith("qd") for name in header)
    velocities = sum(name.startswith("qd") for name in header)
    names = _names(max(1, positions, velocities))
    for name in names:
        if header.count(name) != 1:
            how = "is missing" if name not in header else "occurs twice"
            raise ValueError(f"{path.name}: column {name} {how}; its header is {','.join(header):.80}")
    order = [header.index(name) for name in names]
    table = np.empty((len(rows) - 1, len(names)))
    for number, row in enumerate(rows[1:]):
        if len(row) != len(header):
            raise ValueError(f"{path.name}: row {number + 1} has {len(row)} columns, the header {len(header)}")
        for column, position in enumerate(order):
            try:
                table[number, column] = float(row[position])
            except ValueError:
                where = f"{path.name}: row {number + 1}, column {names[column]}"
                raise ValueError(f"{where} is {row[position]!r:.40}, which is not a number") from None
    return table, names


def _read_npy(path):
    try:
        table = np.load(path, allow_pickle=False)
    except (ValueError, EOFError) as unreadable:
        raise ValueError(f"{path.name} cannot be read as NPY: {unreadable}") from unreadable
    if table.ndim != 2 or table.shape[1] < 3 or table.shape[1] % 2 == 0 or len(table) == 0:
        raise ValueError(f"{path.name} must hold an array of shape (n, 1 + 2 k): t, q1.., qd1..; it is {table.shape}")
    if table.dtype.kind not in "iuf":
        raise ValueError(f"{path.name} must hold real numbers; it holds {table.dtype}")
    return table.astype(float), _names(table.shape[1] // 2)


def _refuse(path, names, bad, reason):
    """Raise ValueError for the first True in bad, (rows, columns)."""
    if bad.any():
        row, column = np.argwhere(bad)[0]
        raise ValueError(f"{path.name}: row {row + 1}, column {names[column]} {reason(row, column)}")
