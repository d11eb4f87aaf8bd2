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
from course_lib.rigid import is_se
from course_lib.rotations import length, log_so3

REACHED = 1e-6  # metres and radians: what counts as a target reached
_DAMPING = 0.1  # times the squared error: far away short steps, near the target full ones
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


def solve(arm, targets, rng, q0=None, starts=200, steps=20):
    """Return an IKResult: joint angles inside the arm's limits for which its end has the poses `targets`.

    Levenberg-Marquardt from q0, or a random posture, and from other random postures where that leads nowhere.
    arm: a SerialArm. targets: (..., 4, 4). rng: a numpy Generator, for the starts. q0: (..., n), where to begin, or
    None; outside the limits it is brought to them. starts: how many at most for a target. steps: at most from each.
    """
    if not isinstance(arm, SerialArm):
        raise ValueError(f"arm must be a SerialArm; it is of type {type(arm).__name__}")
    targets = real_array(targets, "targets", (4, 4))
    refuse_first(~is_se(targets), "targets", lambda i: "is not a pose (rigid.nearest_se gives one near it)")
    generator(rng)
    starts, steps = count(starts, "starts", least=1), count(steps, "steps", least=1)
    batch, low, high = targets.shape[:-2], *arm.limits.T
    poses = targets.reshape(-1, 4, 4)
    if q0 is None:
        q = _random_postures(arm, len(poses), rng)
    else:
        q0 = real_array(q0, "q0", (arm.n,))
        broadcast(targets=batch, q0=q0.shape[:-1])
        try:
            q = np.clip(np.broadcast_to(q0, (*batch, arm.n)).reshape(-1, arm.n), low, high)
        except ValueError as too_many:
            raise ValueError(
                f"q0 must have a start for each target, {batch}; its batch is {q0.shape[:-1]}"
            ) from too_many
    best, spent = _search(arm, poses, q, rng, starts, steps)
    residual = _lengths(_error(arm.fk(best), poses))
    return IKResult(
        best.reshape(*batch, arm.n),
        (residual <= REACHED).all(-1).reshape(batch),
        spent.reshape(batch),
        residual.reshape(*batch, 2),
    )


def _search(arm, poses, q, rng, starts, steps):
    """Return the best joint angles (m, n) for poses (m, 4, 4), beginning at q, and how many steps each pose took."""
    best, least = q.copy(), np.full(len(q), np.inf)
    spent, started = np.zeros(len(q), int), np.ones(len(q), int)
    target, age = np.arange(len(q)), np.zeros(len(q), int)  # of each posture under way: which pose it is for, how old
    while len(target):
        error = _error(arm.fk(q), poses[target])
        cost = (error**2).sum(-1)
        better = cost < least[target]
        best[target[better]], least[target[better]] = q[better], cost[better]
        done = (_lengths(error) <= REACHED / 10).all(-1)  # a tenth, for the result is measured once more
        moved = _step(arm, q, error)
        stuck = np.abs(moved - q).max(-1) < 1e-9
        spent[target] += 1
        q, age = moved, age + 1
        over = ~done & (stuck | (age >= steps))
        again = over & (started[target] < starts)
        q[again], age[again] = _random_postures(arm, again.sum(), rng), 0
        started[target[again]] += 1
        keep = ~done & ~(over & ~again)
        target, q, age = target[keep], q[keep], age[keep]
    return best, spent


def _step(arm, q, error):
    """Return q after one damped step. A joint at its limit that would go beyond is held, and the others do its part."""
    J = arm.geometric_jacobian(q)
    low, high = arm.limits.T
    downhill = (np.swapaxes(J, -1, -2) @ error[..., None])[..., 0]
    held = ((q <= low) & (downhill < 0)) | ((q >= high) & (downhill > 0))
    J = J * ~held[..., None, :]
    damping = _DAMPING * (error**2).sum(-1) + _LEAST_DAMPING
    damped = J @ np.swapaxes(J, -1, -2) + damping[..., None, None] * np.eye(6)
    return np.clip(q + (np.swapaxes(J, -1, -2) @ np.linalg.solve(damped, error[..., None]))[..., 0], low, high)


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


def _random_postures(arm, n, rng):
    """n postures (n, joints), even between the limits; a joint without limits anywhere in its turn."""
    low, high = np.clip(arm.limits.T, -np.pi, np.pi)
    return rng.uniform(low, high, (n, arm.n))


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
    k, steps = target.shape[-1], count(steps, "steps")
    path = np.empty((*batch, steps + 1, arm.n))
    path[..., 0, :] = q
    for i in range(steps):
        q = path[..., i, :]
        J = arm.position_jacobian(q)[..., :k, :]
        error = arm.fk(q)[..., :k, 3] - target
        # J^T (J J^T + eps I)^-1 is the same as (J^T J + eps I)^-1 J^T, and the smaller system of equations.
        damped = J @ np.swapaxes(J, -1, -2) + eps[..., None, None] * np.eye(k)
        try:
            with np.errstate(all="ignore"):
                step = (np.swapaxes(J, -1, -2) @ np.linalg.solve(damped, error[..., None]))[..., 0]
                path[..., i + 1, :] = q - alpha[..., None] * step
        except np.linalg.LinAlgError as singular:
            raise ValueError("eps is too small: where the arm is singular, rounding leaves nothing of it") from singular
        refuse_first(~np.isfinite(path[..., i + 1, :]).all(-1), "alpha", lambda i: "is too large: the angles overflow")
    return path
