"""Measurement of methods of inverse kinematics, by descents to many targets."""

import numpy as np

from course_lib.arguments import count, positive, real_array
from course_lib.arms import checked_arm
from course_lib.ik import pose_error
from course_lib.rigid import checked_pose
from course_lib.rotations import length


def pose_distance(T, target):
    """Return the distance of two poses as seven numbers.

    These are the position, and the quaternion of the nearer sign.

    Parameters
    ----------
    T, target : array_like (..., 4, 4)
        Poses in one frame, batches broadcast; metres.

    Returns
    -------
    array (...)
        The length of the difference, sqrt(|p - p_target|^2 + min |kappa -+ kappa_target|^2).

    Examples
    --------
    The distance of these two is the root of 0.3^2 + 0.4^2 + 2 = 2.25:

    >>> from course_lib.rigid import transform
    >>> T = transform(np.diag([-1, -1, 1]), [0.3, 0.4, 0])
    >>> print(pose_distance(np.eye(4), T).round(9))
    1.5
    """
    # Unit quaternions whose rotations differ by phi are 2 sin(phi / 4) apart.
    phi, p = np.split(pose_error(T, target), 2, axis=-1)
    return np.hypot(2 * np.sin(length(phi) / 4), length(p))


def descend(arm, targets, q0, rules, steps, near):
    """Return which targets the given rules reach, and after how many steps.

    Parameters
    ----------
    arm : SerialArm
    targets : array_like (m, 4, 4)
        Poses of the end-effector in the base frame; metres.
    q0 : array_like (n,) or (m, n)
        The start for all targets, or one for each, in radians.
    rules : (error_of, move, inside)
        error_of(T, target) is the error of poses (k, 4, 4), shape (k, 6); move(J, e, distance) are
        the steps (k, n) for Jacobians (k, 6, n), errors and distances (k,); inside(q) are the joint
        angles (k, n) within the limits. Errors and Jacobians are those of `ik.pose_error` and
        `SerialArm.geometric_jacobian`, (omega, v) in the base frame.
    steps : int
        The largest number of steps for each target.
    near : float
        The `pose_distance` at which a target is reached.

    Returns
    -------
    reached : bool array (m,)
    taken : int array (m,)
        Steps until the target was reached; steps + 1 if it was not.

    Examples
    --------
    >>> from course_lib.arms import planar_arm
    >>> arm = planar_arm([1, 1])
    >>> rules = pose_error, lambda J, e, distance: np.einsum("kij,ki->kj", J, e) / 4, lambda q: q
    >>> targets = arm.fk([[0.3, 0.5], [0.5, 0.9]])
    >>> reached, taken = descend(arm, targets, [0.4, 0.6], rules, steps=100, near=1e-3)
    >>> print(reached, bool(taken[0] < taken[1]))
    [ True  True] True
    """
    checked_arm(arm, "arm")
    targets = checked_pose(targets, "targets", ("n", 4, 4), batched=False)
    q0 = real_array(q0, "q0", (arm.n,), (len(targets), arm.n), batched=False)
    steps = count(steps, "steps")
    near = positive(near, "near", batched=False)
    if not (isinstance(rules, tuple | list) and len(rules) == 3 and all(map(callable, rules))):
        raise ValueError(
            f"rules must be three functions (error_of, move, inside); it is {rules!r:.80}"
        )
    q = np.broadcast_to(q0, (len(targets), arm.n)).copy()
    error_of, move, inside = rules
    taken = np.full(len(q), steps + 1)
    busy = np.arange(len(q))
    for k in range(steps + 1):
        T, J = arm.pose_and_geometric_jacobian(q[busy])
        # This is pose_distance without its checks, to 1e-8. The Frobenius norm of the difference of
        # two rotations by an angle phi is 8^(1/2) sin(phi / 2).
        gap = T - targets[busy]
        half_sine = np.minimum(length(gap[:, :3, :3].reshape(-1, 9)) / 8**0.5, 1)
        distance = np.hypot(2 * np.sin(np.arcsin(half_sine) / 2), length(gap[:, :3, 3]))
        far = distance > near
        taken[busy[~far]] = k
        busy = busy[far]
        if not busy.size:
            break
        error = error_of(T[far], targets[busy])
        q[busy] = inside(q[busy] + move(J[far], error, distance[far]))
    return taken <= steps, taken
