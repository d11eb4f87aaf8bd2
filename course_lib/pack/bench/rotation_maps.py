"""Rotations: exp, log, matrix to quaternion and back, compared with the libraries that are exact up to pi."""

import numpy as np

from course_lib import rotations
from course_lib.pack.bench.measure import Contestant, Task
from course_lib.pack.bench.peers import over

EXACT = 1e-12


def tasks(peers, n=100_000):
    """Return the tasks for n rotations, and lines that say how exact each is near 0 and near pi."""
    rng = np.random.default_rng(0)
    axes = rng.normal(size=(n, 3))
    w = axes / np.linalg.norm(axes, axis=-1, keepdims=True) * rng.uniform(0, np.pi, (n, 1))
    R, q = rotations.exp_so3(w), rotations.matrix_to_quaternion(rotations.exp_so3(w))
    hard_w, hard_R, hard_q = hard_cases()
    made, lines = [], []
    for title, name, items, hard, right in (
        ("Rotation vector to matrix (exp)", "exp", w, hard_w, hard_R),
        ("Matrix to rotation vector (log)", "log", R, hard_R, hard_w),
        ("Matrix to quaternion", "to_quaternion", R, hard_R, hard_q),
        ("Quaternion to matrix", "from_quaternion", q, hard_q, hard_R),
    ):
        contestants = []
        for peer, maps in rotation_maps_of(peers).items():
            if name in maps:
                run, few = maps[name]
                with np.errstate(all="ignore"):
                    lost = _gap(np.asarray(run(hard)), right, sign=name in ("log", "to_quaternion"))
                lines.append(f"  {title}: {peer:32} {lost:.0e}{'' if lost <= EXACT else '   loses digits'}")
                at_most = 1.2 if lost <= EXACT and peer != "course_lib" else None
                contestants.append(Contestant(peer, run, few, at_most=at_most))
        made.append(Task(f"{title}, {n:,} rotations, a rotation", items, contestants))
    return made, lines


def rotation_maps_of(peers):
    """Return {name: {map: (function of a batch, how many items it gets)}}; quaternions are (w, x, y, z), w >= 0."""
    maps = {
        "course_lib": {
            "exp": (rotations.exp_so3, None),
            "log": (rotations.log_so3, None),
            "to_quaternion": (rotations.matrix_to_quaternion, None),
            "from_quaternion": (rotations.quaternion_to_matrix, None),
        }
    }
    if "scipy" in peers:
        from scipy.spatial.transform import Rotation

        maps["scipy"] = {
            "exp": (lambda w: Rotation.from_rotvec(w).as_matrix(), None),
            "log": (lambda R: Rotation.from_matrix(R).as_rotvec(), None),
            "to_quaternion": (lambda R: Rotation.from_matrix(R).as_quat(canonical=True, scalar_first=True), None),
            "from_quaternion": (lambda q: Rotation.from_quat(q, scalar_first=True).as_matrix(), None),
        }
    if "pytransform3d" in peers:
        from pytransform3d import batch_rotations as batch

        def log(R):
            axis_angle = batch.axis_angles_from_matrices(R)
            return axis_angle[..., :3] * axis_angle[..., 3:]

        def to_quaternion(R):
            q = batch.quaternions_from_matrices(R)
            return np.where(q[..., :1] < 0, -q, q)

        maps["pytransform3d"] = {
            "exp": (batch.matrices_from_compact_axis_angles, None),
            "log": (log, None),
            "to_quaternion": (to_quaternion, None),
            "from_quaternion": (batch.matrices_from_quaternions, None),
        }
    if pin := peers.get("pinocchio"):
        maps["pinocchio, Python loop"] = {
            "exp": (lambda w: over(pin.exp3, w), 20_000),
            "log": (lambda R: over(pin.log3, R), 20_000),
        }
    if mr := peers.get("modern_robotics"):
        maps["modern_robotics, Python loop"] = {
            "exp": (lambda w: over(lambda one: mr.MatrixExp3(mr.VecToso3(one)), w), 1000),
            "log": (lambda R: over(lambda one: mr.so3ToVec(mr.MatrixLog3(one)), R), 1000),
        }
    return maps


def hard_cases():
    """Return rotation vectors, matrices and quaternions of angles near 0 and up to pi, in extended precision.

    Without it (where np.longdouble is double) they are right to about 1e-15, which is enough.
    """
    small = 10.0 ** -np.arange(1, 17)
    angles = np.concatenate([small, np.pi - small, [0.5, 1, 2, 3, np.pi]]).astype(np.longdouble)
    axes = np.random.default_rng(1).normal(size=(40, 1, 3)).astype(np.longdouble)
    axes[:3, 0] = np.eye(3)
    axes /= np.sqrt((axes**2).sum(-1, keepdims=True))
    n, angle = np.broadcast_arrays(axes, angles[:, None])
    n, angle = n.reshape(-1, 3), angle[..., :1].reshape(-1, 1)
    q = np.concatenate([np.cos(angle / 2), np.sin(angle / 2) * n], -1)
    x, y, z = n.T
    zero = 0 * x
    N = np.stack([zero, -z, y, z, zero, -x, -y, x, zero], -1).reshape(-1, 3, 3)
    R = np.eye(3) + np.sin(angle)[..., None] * N + 2 * np.sin(angle / 2)[..., None] ** 2 * (N @ N)
    return (angle * n).astype(float), R.astype(float), q.astype(float)


def _gap(theirs, right, sign):
    """Return the largest difference; at exactly pi both signs of a vector or quaternion are right."""
    off = np.abs(theirs - right).reshape(len(right), -1).max(-1)
    if sign:
        half = np.pi - np.linalg.norm(right, axis=-1) < 1e-9 if right.shape[-1] == 3 else np.abs(right[:, 0]) < 1e-9
        other = np.abs(theirs + right).reshape(len(right), -1).max(-1)
        off = np.where(half, np.minimum(off, other), off)
    return float(np.nan_to_num(off, nan=np.inf).max())
