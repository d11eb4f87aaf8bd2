"""What a joint trajectory is, and how it is written to a file."""

from dataclasses import dataclass

import numpy as np

from course_lib.arguments import file_path, real_array


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
        How the file was read, in words: a summary in the first line, then a line for each joint
        with the column that it came from, its unit, and its range in degrees.
    velocities_given : bool
        False if qd are differences of q, because no velocities were given.
    """

    t: np.ndarray
    q: np.ndarray
    qd: np.ndarray
    understood: str = ""
    velocities_given: bool = True


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
    >>> from pathlib import Path
    >>> path = Path(tempfile.mkdtemp()) / "made.csv"
    >>> save(path, Trajectory(np.array([0.0, 1]), np.array([[1.0], [2]]), np.array([[1.0], [1]])))
    >>> print(path.read_text().splitlines()[0])
    t,q1,qd1
    """
    t, q, qd = checked_trajectory(trajectory)
    joints = range(1, q.shape[1] + 1)
    header = ",".join(["t", *(f"q{i}" for i in joints), *(f"qd{i}" for i in joints)])
    table = np.column_stack([t, q, qd])
    np.savetxt(file_path(path), table, fmt="%.10f", delimiter=",", header=header, comments="")


def checked_trajectory(trajectory):
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
