"""Inverse kinematics by steps: joint angles for a place that the end of an arm is to reach.

Arrays are batched on the left. Every function raises ValueError, naming the argument, for a wrong shape and for
entries that are not finite real numbers.

Source: Nakamura and Hanafusa, Inverse kinematic solutions with singularity robustness for robot manipulator control,
Journal of Dynamic Systems, Measurement, and Control 108 (1986), for the damping.
"""

import numpy as np

from course_lib.arguments import broadcast, count, positive, real_array, refuse_first
from course_lib.arms import SerialArm


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
