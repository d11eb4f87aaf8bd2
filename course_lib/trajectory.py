"""Joint trajectories in files: read one, and refuse a broken one in a sentence that names row and column.

A file is CSV, with a header, or NPY, an array (n, 1 + 2 k). Columns: t in seconds, then the positions q1 ... qk in
radians, then the velocities qd1 ... qdk in radians per second. Rows count from 1, a header is not counted.
"""

import csv
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from course_lib.arguments import real_array


@dataclass(frozen=True)
class Trajectory:
    """A joint trajectory. t: (n,) seconds. q, qd: (n, k), radians and radians per second."""

    t: np.ndarray
    q: np.ndarray
    qd: np.ndarray


def load(path, limits=None):
    """Return the Trajectory in a CSV or NPY file.

    limits: (k, 2), lowest and highest angle of each joint, None for any. Raises ValueError, naming file, row and
    column, for a missing or doubled column, something that is no finite number, a position outside its limits, and
    time that does not run forwards; OSError where there is no such file.
    """
    path = Path(path)
    kind = path.suffix.lower()
    if kind not in (".csv", ".npy"):
        raise ValueError(f"path must name a .csv or .npy file; it is {str(path)!r}")
    table, names = _read_csv(path) if kind == ".csv" else _read_npy(path)
    _refuse(path, names, ~np.isfinite(table), lambda row, column: "is no finite number")
    t, k = table[:, 0], (len(names) - 1) // 2
    back = np.zeros(table.shape, bool)
    back[1:, 0] = np.diff(t) <= 0
    _refuse(path, names, back, lambda row, column: f"is {t[row]:g} s, after {t[row - 1]:g} s: time must run forwards")
    if limits is not None:
        limits = real_array(limits, "limits", (2,))
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
    """Write a Trajectory as CSV, with ten decimals. path: where; the file is written anew."""
    names = _names(trajectory.q.shape[1])
    table = np.column_stack([trajectory.t, trajectory.q, trajectory.qd])
    np.savetxt(path, table, fmt="%.10f", delimiter=",", header=",".join(names), comments="")


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
            how = "is missing" if name not in header else "stands twice"
            raise ValueError(f"{path.name}: column {name} {how}; its header is {','.join(header):.80}")
    order = [header.index(name) for name in names]
    table = np.empty((len(rows) - 1, len(names)))
    for number, row in enumerate(rows[1:]):
        if len(row) != len(header):
            raise ValueError(f"{path.name}: row {number + 1} has {len(row)} columns, the header {len(header)}")
        for column, place in enumerate(order):
            try:
                table[number, column] = float(row[place])
            except ValueError:
                where = f"{path.name}: row {number + 1}, column {names[column]}"
                raise ValueError(f"{where} is {row[place]!r:.40}, which is no number") from None
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
