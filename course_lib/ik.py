"""Inverse kinematics by steps: joint angles for a pose, or a place, that the end of an arm is to reach.

Arrays are batched on the left. Every function raises ValueError, naming the argument, for a wrong shape and for
entries that are not finite real numbers.

Sources: Sugihara, Solvability-unconcerned inverse kinematics by the Levenberg-Marquardt method, IEEE Transactions on
Robotics 27 (2011), for damping by the squared error; Nakamura and Hanafusa, Inverse kinematic solutions with
singularity robustness for robot manipulator control, Journal of Dynamic Systems, Measurement, and Control 108 (1986),
for damping at all.
"""

from dataclasses import dataclass

import numpy as np

from course_lib.arguments import broadcast, count, generator, positive, real_array, refuse_first
from course_lib.arms import SerialArm
from course_lib.batched_arm import CHUNK
from course_lib.rigid import is_se
from course_lib.rotations import length, log_so3

REACHED = 1e-6  # metres and radians: what counts as a target reached
_DAMPING = 0.1  # times the squared error: far away short steps, near the target full ones
_PATIENCE = 10  # steps; after so many one that leaves more than half of the squared error is the last of its start,
_NEAR = 0.01  # unless the squared error is below this or there is no other start to go on with
_DRAWN = 8  # random postures, of which the one whose end is nearest to the target is a start
_TOGETHER = 128  # postures that are stepped in about the time of one
_LEAST_DAMPING = 1e-12  # so that a stretched arm beside its target divides by no zero


@dataclass(frozen=True)
class IKResult:
    """What solve found. The batch (...) is that of the targets.

    q: (..., n) the joint angles that come nearest, inside the limits. success: (...) whether the end is within 1e-6 m
    and 1e-6 rad of the target there, by forward kinematics. iterations: (...) steps taken for the target, all starts
    together. residual: (..., 2) metres and radians that are left.
    """

    q: np.ndarray
    success: np.ndarray
    iterations: np.ndarray
    residual: np.ndarray


def solve(arm, targets, rng, q0=None, starts=400, steps=50):
    """Return an IKResult: joint angles inside the arm's limits for which its end has the poses `targets`.

    Levenberg-Marquardt from q0, or a random posture, and from other random postures where that leads nowhere: each the
    one that is nearest to its target of a few drawn.
    arm: a SerialArm. targets: (..., 4, 4). rng: a numpy Generator, for the starts. q0: (..., n), where to begin, or
    None; outside the limits it is brought to them. starts: how many at most for a target. steps: at most from each.
    """
    if not isinstance(arm, SerialArm):
        raise ValueError(f"arm must be a SerialArm; it is of type {type(arm).__name__}")
    targets = real_array(targets, "targets", (4, 4))
    refuse_first(~is_se(targets), "targets", lambda i: "is not a pose (rigid.nearest_se gives one near it)")
    generator(rng)
    starts, steps = count(starts, "starts", least=1), count(steps, "steps", least=1)
    batch, poses = targets.shape[:-2], targets.reshape(-1, 4, 4)
    if q0 is not None:
        q0 = real_array(q0, "q0", (arm.n,))
        broadcast(targets=batch, q0=q0.shape[:-1])
        try:
            q0 = np.clip(np.broadcast_to(q0, (*batch, arm.n)).reshape(-1, arm.n), *arm.limits.T)
        except ValueError as too_many:
            raise ValueError(
                f"q0 must have a start for each target, {batch}; its batch is {q0.shape[:-1]}"
            ) from too_many
    best, spent = np.empty((len(poses), arm.n)), np.empty(len(poses), int)
    for first in range(0, len(poses), CHUNK):
        some = slice(first, first + CHUNK)
        with np.errstate(over="ignore"):  # squares of what is left to a target far beyond any arm
            q = _starts(arm, poses[some], rng) if q0 is None else q0[some]
            best[some], spent[some] = _search(arm, poses[some], q, rng, starts, steps)
    residual = _lengths(_error(arm.fk(best), poses))
    return IKResult(
        best.reshape(*batch, arm.n),
        (residual <= REACHED).all(-1).reshape(batch),
        spent.reshape(batch),
        residual.reshape(*batch, 2),
    )


def _search(arm, poses, q, rng, starts, steps):
    """Return the best joint angles (m, n) for poses (m, 4, 4), beginning at q, and how many steps each pose took.

    In course_lib.batching's layout: postures under way lie along the last axis. In it a few cost as much as a hundred
    (_TOGETHER). So where fewer are under way, the poses whose first start led nowhere get several more starts at once.
    """
    goals, limits = _columns_and_place(poses), arm.limits.T[..., None]
    best, least = q.copy(), np.full(len(q), np.inf)
    spent, started, solved = np.zeros(len(q), int), np.ones(len(q), int), np.zeros(len(q), bool)
    # Of each posture under way: joint angles, which pose it is for, steps taken, squared error before the last of them.
    q, target, age, before = q.T, *_new(np.arange(len(q)))
    while len(target):
        J = np.empty((6, *q.shape))
        error = _left(*arm.batched.fill_geometric_jacobian(q, J), goals[..., target])
        way, turn = (error[3:] ** 2).sum(0), (error[:3] ** 2).sum(0)
        cost = way + turn
        np.fmin.at(least, target, cost)
        nearest = cost == least[target]
        best[target[nearest]] = q.T[nearest]
        solved[target[np.maximum(way, turn) <= (REACHED / 10) ** 2]] = True  # a tenth: it is measured once more
        moved, age = _within(q, J, error, *limits), age + 1
        spent += np.bincount(target, minlength=len(spent))
        slow = (age > _PATIENCE) & (cost > np.maximum(before / 2, _NEAR)) & (started < starts)[target]
        on = ~solved[target] & ~slow & (np.abs(moved - q).max(0) >= 1e-9) & (age < steps)
        more = _more_starts(target[on], started, ~solved & (started < starts), starts)
        q, target, age, before = moved[:, on], target[on], age[on], cost[on]
        if len(more):
            started += np.bincount(more, minlength=len(started))
            q = np.concatenate([q, _starts(arm, poses[more], rng).T], -1)
            target, age, before = map(np.append, (target, age, before), _new(more))
    return best, spent


def _new(target):
    """Of postures that begin: which pose each is for, steps taken, squared error before the last of them."""
    return target, np.zeros(len(target), int), np.full(len(target), np.inf)


def _more_starts(target, started, may, starts):
    """Return for which poses to start anew: all that may and have no posture under way, more where there is room."""
    idle = may & (np.bincount(target, minlength=len(may)) == 0)
    hard = may & (idle | (started > 1))
    share = max(0, _TOGETHER - len(target) - idle.sum()) // max(1, hard.sum())
    return np.repeat(np.arange(len(may)), np.minimum(idle + share * hard, starts - started))


def _within(q, J, error, low, high):
    """Return q after one damped step. A joint at its limit that would go beyond is held, and the others do its part."""
    downhill = np.einsum("kn...,k...->n...", J, error)
    held = ((q <= low) & (downhill < 0)) | ((q >= high) & (downhill > 0))
    step, sound = _step(J * ~held, error, _DAMPING * (error**2).sum(0) + _LEAST_DAMPING)
    return np.clip(q + np.where(sound & np.isfinite(step).all(0), step, 0.0), low, high)


def _step(J, error, damping):
    """Return J^T (J J^T + damping I)^-1 error, (n, N), and of each of N whether rounding left something of the damping.

    J: (k, n, N). error: (k, N). damping: (N,). It is the same as (J^T J + damping I)^-1 J^T error, by a smaller system.
    Gauss's elimination, all N systems at once; for positive definite matrices it needs no choice of pivots (Golub and
    Van Loan, Matrix Computations, section 4.2).
    """
    k = len(error)
    sound = np.ones(error.shape[1], bool)
    with np.errstate(all="ignore"):
        A = np.einsum("in...,jn...->ij...", J, J)
        A[range(k), range(k)] += damping
        A = np.concatenate([A, error[:, None]], 1)  # the right side as a last column
        for i in range(k):
            sound &= A[i, i] > 0
            A[i, i:] /= A[i, i].copy()
            A[i + 1 :, i + 1 :] -= A[i + 1 :, i, None] * A[i, i + 1 :]
        x = A[:, k]
        for i in reversed(range(k)):
            x[:i] -= A[:i, i] * x[i]
        return np.einsum("kn...,k...->n...", J, x), sound


def _columns_and_place(T):
    """The columns and the place of poses (N, 4, 4), in course_lib.batching's layout: (4, 3, N)."""
    return np.ascontiguousarray(np.moveaxis(T[:, :3], (0, 1, 2), (2, 1, 0)))


def _left(columns, place, goal):
    """What _error gives, in course_lib.batching's layout: (6, N), from how and where an end is to goals (4, 3, N)."""
    end = np.empty(goal.shape)
    for i, column in enumerate((*columns, place)):
        end[i] = column
    R = np.einsum("ka...,kb...->ab...", goal[:3], end[:3])
    axis_times_sine = np.stack([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2  # MR eq. 3.53
    sine, cosine = np.sqrt((axis_times_sine**2).sum(0)), (np.trace(R) - 1) / 2
    turn = axis_times_sine * np.divide(np.arctan2(sine, cosine), sine, out=np.ones_like(sine), where=sine > 0)
    half = np.flatnonzero(cosine < -0.99)  # near half a turn the sine has few digits of the axis left
    if len(half):
        turn[:, half] = log_so3(np.moveaxis(R[..., half], -1, 0)).T
    return np.concatenate([turn, goal[3] - end[3]])


def pose_error(T, target):
    """Return what is left to do from the poses T (..., 4, 4) to the targets (..., 4, 4): (..., 6), a turn and a way.

    The turn is a rotation vector, in radians, the way is the origin's, both along the base's axes: in the order and
    the axes of SerialArm.geometric_jacobian, so that J q' is about equal to it for a small one. Sugihara, section II.
    """
    T, target = real_array(T, "T", (4, 4)), real_array(target, "target", (4, 4))
    for name, poses in (("T", T), ("target", target)):
        refuse_first(~is_se(poses), name, lambda i: "is not a pose (rigid.nearest_se gives one near it)")
    broadcast(T=T.shape[:-2], target=target.shape[:-2])
    return _error(T, target)


def _error(T, target):
    turn = log_so3(target[..., :3, :3] @ np.swapaxes(T[..., :3, :3], -1, -2))
    return np.concatenate([turn, target[..., :3, 3] - T[..., :3, 3]], -1)


def _lengths(error):
    """Metres and radians of an error (..., 6)."""
    return np.stack([length(error[..., 3:]), length(error[..., :3])], -1)


def _starts(arm, poses, rng):
    """Return for each of the poses (m, 4, 4) the nearest of a few random postures, (m, n).

    They are even between the limits; a joint without limits turns anywhere. Small turns count as much as ways.
    """
    q = rng.uniform(*np.clip(arm.limits.T, -np.pi, np.pi), (_DRAWN, len(poses), arm.n))
    off = (arm.fk(q) - poses) ** 2
    distance = off[..., :3, :3].sum((-2, -1)) / 2 + off[..., :3, 3].sum(-1)
    return np.take_along_axis(q, distance.argmin(0)[None, :, None], 0)[0]


def damped_path(arm, q0, target, alpha, eps, steps):
    """Return the joint angles (..., steps + 1, n) of damped least-squares steps towards a point, q0 first.

    q <- q - alpha (eps I + J^T J)^-1 J^T (p(q) - target), p the place of the arm's end and J its Jacobian.
    arm: a SerialArm. q0: (..., n). target: (..., 2) for an arm in the plane z = 0, or (..., 3). alpha, eps: (...),
    above zero: the step size and the damping, in square metres. steps: how many. No limits are looked at.
    """
    if not isinstance(arm, SerialArm):
        raise ValueError(f"arm must be a SerialArm; it is of type {type(arm).__name__}")
    q = real_array(q0, "q0", (arm.n,))
    target = real_array(target, "target", (2,), (3,))
    alpha, eps = positive(alpha, "alpha"), positive(eps, "eps")
    batch = broadcast(q0=q.shape[:-1], target=target.shape[:-1], alpha=alpha.shape, eps=eps.shape)
    k, steps, n = target.shape[-1], count(steps, "steps"), arm.n
    flat = int(np.prod(batch))
    target = np.broadcast_to(target, (*batch, k)).reshape(flat, k).T
    alpha, eps = (np.broadcast_to(value, batch).reshape(flat) for value in (alpha, eps))
    path = np.empty((*batch, steps + 1, n))
    path[..., 0, :] = q
    q, J = path[..., 0, :].reshape(flat, n).T, np.empty((6, n, flat))
    for i in range(steps):
        _, place = arm.batched.fill_geometric_jacobian(q, J)
        step, sound = _step(J[3 : 3 + k], place[:k] - target, eps)
        if not sound.all():
            raise ValueError("eps is too small: where the arm is singular, rounding leaves nothing of it")
        with np.errstate(over="ignore"):
            q = q - alpha * step
        path[..., i + 1, :] = q.T.reshape(*batch, n)
        refuse_first(~np.isfinite(path[..., i + 1, :]).all(-1), "alpha", lambda i: "is too large: the angles overflow")
    return path
