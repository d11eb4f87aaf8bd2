"""Inverse kinematics by iteration, for a pose or a position of the end-effector.

Sources: Sugihara, Solvability-unconcerned inverse kinematics by the Levenberg-Marquardt method,
IEEE Transactions on Robotics 27 (2011), for damping by the squared error; Nakamura and Hanafusa,
Inverse kinematic solutions with singularity robustness for robot manipulator control, Journal of
Dynamic Systems, Measurement, and Control 108 (1986), for damping as such. Lynch and Park, Modern
Robotics (2017), is called MR.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from course_lib.arguments import broadcast, count, generator, positive, real_array, refuse_first
from course_lib.arms import checked_arm
from course_lib.batched_arm import CHUNK
from course_lib.rigid import checked_pose
from course_lib.rotations import length, log_so3, nearest_so

REACHED = 1e-6  # metres and radians: a target is reached when both errors are at most this
# The search asks for a tenth of that, because `solve` measures the result once more.
_REACHED_SQUARED = (REACHED / 10) ** 2
# The damping is this many times the squared error (Sugihara 2011): steps are short far from the
# target, and full Newton steps near it.
_DAMPING = 0.1
# This is added to the damping, so that nothing is divided by zero when the arm is stretched towards
# its target.
_MIN_DAMPING = 1e-12
# After _PATIENCE steps a descent is given up if its last step failed to halve the squared error,
# unless the squared error is below _NEAR.
_PATIENCE = 6
_NEAR = 1e-4
# Radians. A step in which no joint moves more ends a descent; it is far below _REACHED_SQUARED's
# root, 1e-7.
_STANDSTILL = 1e-9
# Random configurations of an arm whose poses are computed only once, and the seed that draws them:
# none that a caller is likely to draw targets with, because these would then be in the table.
_TABLE = 4000
_TABLE_SEED = 20110602
# The number of these among which a search looks for starts. From the nearest of a thousand the
# Panda needs a third fewer steps than from the nearest of eight; more would cost more than they
# save.
_CANDIDATES = 1000
# Descents for a single target before many are tried at once.
_ONE_BY_ONE = 8
# Descents that together take about the time of one.
_TOGETHER = 128


@dataclass(frozen=True)
class IKResult:
    """The result of `solve`, with the batch (...) of the targets.

    Attributes
    ----------
    q : array (..., n)
        Joint angles in radians, within the limits, with the smallest error found.
    success : bool array (...)
        Whether forward kinematics at q is within 1e-6 m and 1e-6 rad of the target.
    iterations : int array (...)
        Steps taken for the target, over all its starts.
    residual : array (..., 2)
        The errors at q: distance in metres, rotation angle in radians.
    """

    q: np.ndarray
    success: np.ndarray
    iterations: np.ndarray
    residual: np.ndarray


def solve(arm, targets, rng, q0=None, starts=400, steps=50):
    """Return joint angles, within the limits, at which an arm has the poses `targets`.

    Levenberg-Marquardt descends from q0, or from a random configuration. If it fails to converge,
    it descends again from other random configurations. Each start is the one nearest to the target
    among many candidates, so for several answers to the same target give several q0.

    Parameters
    ----------
    arm : SerialArm
    targets : array_like (..., 4, 4)
        Poses of the end-effector frame in the base frame; metres.
    rng : numpy.random.Generator
        Draws the starts.
    q0 : array_like (..., n), optional
        The first start, in radians; clipped to the limits. None draws one.
    starts : int, default 400
        The largest number of starts for each target.
    steps : int, default 50
        The largest number of steps from each start.

    Returns
    -------
    IKResult
        With `success` False for a target that was not reached; q is then the nearest that was
        found.

    Examples
    --------
    >>> from course_lib.arms import panda
    >>> arm = panda()
    >>> target = arm.fk([0.1, -0.5, 0.2, -2.0, 0.3, 1.8, 0.4])
    >>> result = solve(arm, target, np.random.default_rng(0))
    >>> bool(result.success), bool(np.abs(arm.fk(result.q) - target).max() < 1e-6)
    (True, True)
    """
    checked_arm(arm, "arm")
    targets = checked_pose(targets, "targets", (4, 4))
    generator(rng)
    starts = count(starts, "starts", least=1)
    steps = count(steps, "steps", least=1)
    batch = targets.shape[:-2]
    poses = targets.reshape(-1, 4, 4)
    if q0 is not None:
        q0 = real_array(q0, "q0", (arm.n,))
        if broadcast(targets=batch, q0=q0.shape[:-1]) != batch:
            raise ValueError(
                f"q0 must have a start for each target, {batch}; its batch is {q0.shape[:-1]}"
            )
        q0 = np.broadcast_to(q0, (*batch, arm.n)).reshape(-1, arm.n)
        q0 = np.clip(q0, *arm.limits.T)
    best = np.empty((len(poses), arm.n))
    iterations = np.empty(len(poses), int)
    for first in range(0, len(poses), CHUNK):
        chunk = slice(first, first + CHUNK)
        search = _Search(arm, poses[chunk], rng, starts, steps)
        best[chunk], iterations[chunk] = search.run(None if q0 is None else q0[chunk])
    error = _error_by_entries(_entries(arm.fk(best)), _entries(poses))
    residual = np.stack([length(error[3:].T), length(error[:3].T)], -1).reshape(*batch, 2)
    success = (residual <= REACHED).all(-1)
    return IKResult(best.reshape(*batch, arm.n), success, iterations.reshape(batch), residual)


class _Search:
    """The search of `solve` for m targets at once.

    A descent is the sequence of steps from one start.

    N descents are their joint angles (n, N), targets (N,), steps taken (N,) and squared errors
    before the last (N,). They lie along the last axis, as in course_lib.batching, where a hundred
    cost little more than one. So when few are left, the unsolved targets get several new starts at
    once. A single target is first tried alone, because one descent by matrix products is faster
    than one by arrays.
    """

    def __init__(self, arm, poses, rng, starts, steps):
        m = len(poses)
        self.arm = arm
        self.poses = poses
        self.starts = starts
        self.steps = steps
        self.candidates = _Candidates(arm, rng)
        self.goals = _entries(poses)
        # For each target: the best joint angles and their squared error, the steps and the starts
        # so far, and whether it is reached.
        self.best = np.zeros((m, arm.n))
        self.least = np.full(m, np.inf)
        self.iterations = np.zeros(m, int)
        self.started = np.zeros(m, int)
        self.solved = np.zeros(m, bool)

    def run(self, q0):
        """Return the best joint angles (m, n) and the steps taken (m,).

        q0: (m, n), the first starts, or None.
        """
        if len(self.poses) == 1:
            self._descend_one_by_one(q0)
            if self.solved[0]:
                return self.best, self.iterations
            q0 = None
        q, target, age, before = self._new_descents(np.empty(0, int), q0)
        while len(target):
            J = np.empty((6, *q.shape))
            columns, position = self.arm.batched.fill_geometric_jacobian(q, J)
            end = np.array([*columns, position])
            error = _error_by_entries(end, self.goals.take(target, -1))
            cost = self._record(q, target, error)
            moved = _step_within_limits(q, J, error, cost, *self.arm.limits.T[..., None])
            may_restart = (self.started < self.starts)[target]
            ended = self.solved[target] | _ends(
                q, moved, age + 1, before, cost, self.steps, may_restart
            )
            going_on = np.flatnonzero(~ended)
            q, target, age, before = (
                array.take(going_on, -1) for array in (moved, target, age + 1, cost)
            )
            new = self._new_descents(target)
            if len(new[1]):
                q, target, age, before = (
                    np.concatenate(pair, -1)
                    for pair in zip((q, target, age, before), new, strict=True)
                )
        return self.best, self.iterations

    def _descend_one_by_one(self, q0):
        """Try the only target with a few descents by themselves."""
        goal = self.goals[..., 0]
        low, high = self.arm.limits.T
        starts = min(_ONE_BY_ONE, self.starts)
        while not self.solved[0] and self.started[0] < starts:
            if q0 is None:
                q = self.candidates.take_nearest(self.goals)[0]
            else:
                q = q0[0]
                q0 = None
            age = 0
            before = np.inf
            ended = False
            self.started[0] += 1
            while not ended:
                T, J = self.arm.pose_and_geometric_jacobian(q)
                error = _error_by_entries(T[:3].T, goal)
                cost, reached = _cost(error)
                if cost < self.least[0]:
                    self.best[0] = q
                    self.least[0] = cost
                moved = _step_within_limits(q, J, error, cost, low, high)
                age += 1
                may_restart = self.started[0] < self.starts
                ended = reached or _ends(q, moved, age, before, cost, self.steps, may_restart)
                q = moved
                before = cost
            self.solved[0] = reached
            self.iterations[0] += age

    def _record(self, q, target, error):
        """Keep the best joint angles of each target, and return each descent's squared error."""
        cost, reached = _cost(error)
        np.fmin.at(self.least, target, cost)
        best = cost == self.least[target]
        self.best[target[best]] = q.T[best]
        self.solved[target[reached]] = True
        self.iterations += np.bincount(target, minlength=len(self.iterations))
        return cost

    def _new_descents(self, running, q0=None):
        """Return new descents, which begin at q0 (m, n) or at random configurations.

        running: the targets (N,) of the descents that go on.

        Every unsolved target without a descent gets one. Those that have failed before share the
        remaining room.
        """
        allowed = ~self.solved & (self.started < self.starts)
        idle = allowed & (np.bincount(running, minlength=len(allowed)) == 0)
        hard = allowed & (self.started > 0) & (idle | (self.started > 1))
        extra = max(0, _TOGETHER - len(running) - idle.sum()) // max(1, hard.sum())
        starts_left = self.starts - self.started
        number = np.minimum(idle + extra * hard, starts_left)
        target = np.repeat(np.arange(len(allowed)), number)
        self.started += number
        if q0 is not None:
            q = q0
        elif len(target):
            q = self.candidates.take_nearest(self.goals.take(target, -1))
        else:
            q = np.empty((0, self.arm.n))
        return q.T, target, np.zeros(len(target), int), np.full(len(target), np.inf)


class _Candidates:
    """Random configurations of an arm, of which those nearest to a target become its starts.

    Each becomes a start only once, so a target that was not reached gets other starts next time.
    They are a random part of the arm's table at first. When fewer than half are left, new ones are
    drawn.
    """

    def __init__(self, arm, rng):
        self.arm = arm
        self.rng = rng
        q, factors = _table(arm)
        first = rng.integers(_TABLE - _CANDIDATES, endpoint=True)
        part = slice(first, first + _CANDIDATES)
        self.q = q[part]
        self.factors = factors[:, part].copy()

    def take_nearest(self, goals):
        """Return for each of the goals (4, 3, N) the nearest configuration that is left, (N, n).

        Equal goals get different configurations, unless there are more goals than _TOGETHER.

        Radians weigh as much as metres: half the squared Frobenius distance of two rotations, which
        is 4 sin^2(a/2), is a^2 for small angles a. Half the squared distance of R, p from a goal S,
        s is then, but for a number that is the same for all candidates, |p|^2 / 2 less the sum of
        the products of the entries of R / 2 and S and of p and s. One matrix product computes that
        for all.
        """
        number = goals.shape[-1]
        if np.isfinite(self.factors[-1]).sum() < _CANDIDATES // 2:
            self.q, self.factors = _random_configurations(self.arm, self.rng, _CANDIDATES)
        entries = np.concatenate([goals.reshape(12, number), np.ones((1, number))])
        closeness = entries.T @ self.factors
        if number > _TOGETHER:
            chosen = closeness.argmax(-1)
        else:
            chosen = np.empty(number, int)
            for i in range(number):
                chosen[i] = closeness[i].argmax()
                closeness[:, chosen[i]] = -np.inf
        self.factors[-1, chosen] = -np.inf  # which makes them infinitely far from every goal
        return self.q[chosen]


@lru_cache(maxsize=8)
def _table(arm):
    """Return the arm's table of random configurations, as _random_configurations does."""
    return _random_configurations(arm, np.random.default_rng(_TABLE_SEED), _TABLE)


def _random_configurations(arm, rng, number):
    """Return joint angles (number, n), uniformly distributed between the limits of starts.

    Also returns the factors (13, number) of their closeness to goals, for _Candidates.
    """
    low, high = _start_limits(arm)
    # Generator.uniform draws the same numbers, but takes twice as long with arrays of limits.
    q = low + (high - low) * rng.random((number, arm.n))
    columns, position = arm.batched.end_effector(q.T)
    half_square = (position * position).sum(0) / 2
    return q, np.concatenate([np.concatenate(columns) / 2, position, -half_square[None]])


def _cost(error):
    """Return the squared error (N,) of pose errors (6, N), and whether each is small enough.

    Small enough means that the target is reached. Both may be without N, for one pose.
    """
    x, y, z, dx, dy, dz = error * error
    angle, distance = x + y + z, dx + dy + dz
    reached = (angle <= _REACHED_SQUARED) & (distance <= _REACHED_SQUARED)
    return angle + distance, reached


def _ends(q, moved, age, before, cost, steps, may_restart):
    """Return whether a descent that steps from q to `moved` ends.

    It ends if it fails to converge, stands still, or is too long.

    age: steps taken, with this one. before, cost: the squared errors one step earlier and at q.
    """
    fails = (age > _PATIENCE) & (cost > np.maximum(before / 2, _NEAR)) & may_restart
    stands_still = abs(moved - q).max(0) < _STANDSTILL
    return fails | stands_still | (age >= steps)


def _step_within_limits(q, J, error, cost, low, high):
    """Return q after one damped step within the limits.

    A joint that is at its limit and would leave it is held; the others compensate.

    Arrays as in _damped_step; cost: the squared errors; low, high: (n, 1) or (n,). The columns of J
    that belong to held joints are set to zero.
    """
    downhill = _transpose_times(J, error)
    held = ((q <= low) & (downhill < 0)) | ((q >= high) & (downhill > 0))
    J *= ~held
    step, sound = _damped_step(J, error, _DAMPING * cost + _MIN_DAMPING)
    usable = sound & np.isfinite(step.sum(0))
    if not usable.all():
        step = np.where(usable, step, 0.0)
    step += q
    return np.minimum(np.maximum(step, low, out=step), high, out=step)


def _damped_step(J, error, damping):
    """Return the damped least-squares steps (n, N), and whether each can be trusted (N,).

    A step is J^T (J J^T + damping I)^-1 error. It can be trusted if the damping outweighs rounding.

    J: (k, n, N). error: (k, N). damping: (N,). Or all without N, for one. It equals (J^T J +
    damping I)^-1 J^T error, by a smaller system. Many systems are solved together by Gaussian
    elimination; being positive definite they need no pivoting (Golub and Van Loan, Matrix
    Computations, section 4.2).
    """
    k = len(error)
    if error.ndim == 1:
        A = J @ J.T
        # Every (k + 1)-th entry of a k x k matrix is one of its diagonal.
        A.flat[:: k + 1] += damping
        try:
            return np.linalg.solve(A, error) @ J, True
        except np.linalg.LinAlgError:
            return np.zeros(J.shape[1]), False
    A = np.empty((k, k + 1, *error.shape[1:]))
    np.einsum("inN,jnN->ijN", J, J, out=A[:, :k])
    A[:, k] = error  # the right side as a last column
    # A view, so this changes A.
    pivots = np.einsum("iiN->iN", A[:, :k])
    pivots += damping
    with np.errstate(all="ignore"):
        for i in range(k):
            A[i, i + 1 :] /= A[i, i]
            A[i + 1 :, i + 1 :] -= A[i + 1 :, i, None] * A[i, i + 1 :]
        x = A[:, k]
        for i in reversed(range(1, k)):
            x[:i] -= A[:i, i] * x[i]
        # A pivot that is not positive can only come from rounding: the damping was lost in it.
        return _transpose_times(J, x), (pivots > 0).all(0)


def _transpose_times(J, x):
    """Return J^T x, which is (n, N), for J (k, n, N) and x (k, N), or all without N."""
    return x @ J if x.ndim == 1 else np.einsum("knN,kN->nN", J, x)


def _entries(poses):
    """Return the three columns and the position of poses (m, 4, 4) as one array (4, 3, m)."""
    return np.ascontiguousarray(poses[:, :3].T)


def _error_by_entries(end, goal):
    """Return the pose errors (6, N) from frames to goals, both (4, 3, N), or without N.

    A frame or goal is given by its three columns and its position.
    """
    # The nine entries of R_goal R_end^T, summed over the three columns. For one pose, Python's own
    # floats are faster than arrays without axes.
    if goal.ndim == 2:
        R = (goal[:3].T @ end[:3]).tolist()
    else:
        R = np.einsum("kaN,kbN->abN", goal[:3], end[:3])
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = R
    # The axis times the sine of the angle: MR eq. 3.53.
    x, y, z = (zy - yz) / 2, (xz - zx) / 2, (yx - xy) / 2
    sine = np.sqrt(x * x + y * y + z * z)
    cosine = (xx + yy + zz - 1) / 2
    # arctan2 keeps all digits near 0, which arccos(cosine) does not. Where the sine is 0, x, y and
    # z are 0 as well, so any divisor but 0 gives the right product. At half a revolution the
    # quotient may be pi / 1e-300, which is still a float.
    stretch = np.arctan2(sine, cosine) / np.maximum(sine, 1e-300)
    error = np.array([x, y, z, *(goal[3] - end[3])])
    error[:3] *= stretch
    # Near pi the axis times the sine has too few correct digits of the axis.
    near_pi = cosine < -0.99
    if np.count_nonzero(near_pi):
        rotations = np.moveaxis(np.asarray(R)[..., near_pi], -1, 0)
        # Of two poses within the tolerance, as printed ones are, the product may lie beyond it.
        error[:3, near_pi] = log_so3(nearest_so(rotations)).T
    return error


def _start_limits(arm):
    """Return the lowest and highest angles (n,) of random starts.

    They are the limits, or one revolution if the limits allow more.
    """
    low, high = arm.limits.T
    wide = high - low > 2 * np.pi
    # The revolution about 0, moved so that it stays within the limits.
    middle = np.clip(0.0, low + np.pi, high - np.pi)
    return np.where(wide, middle - np.pi, low), np.where(wide, middle + np.pi, high)


def pose_error(T, target):
    """Return the error from a pose to a target, a rotation vector and a translation.

    Both are expressed along the base frame's axes, in the order of SerialArm.geometric_jacobian:
    for small errors, geometric_jacobian(q) @ dq is about equal to the error that dq removes.

    Parameters
    ----------
    T, target : array_like (..., 4, 4)
        Poses in the base frame, batches broadcast; metres.

    Returns
    -------
    array (..., 6)
        Three entries of a rotation vector in radians, of length at most pi, then three of a
        translation in metres.

    Examples
    --------
    >>> from course_lib import rigid, rotations
    >>> print(pose_error(np.eye(4), rigid.transform(rotations.rot_z(0.5), [1, 2, 3])))
    [0.  0.  0.5 1.  2.  3. ]
    """
    T, target = checked_pose(T, "T", (4, 4)), checked_pose(target, "target", (4, 4))
    broadcast(T=T.shape[:-2], target=target.shape[:-2])
    return _pose_error(T, target)


def _pose_error(T, target):
    # Of two poses within the tolerance, as printed ones are, the product may lie beyond it, so it
    # is made a rotation again.
    R = nearest_so(target[..., :3, :3] @ np.swapaxes(T[..., :3, :3], -1, -2))
    translation = target[..., :3, 3] - T[..., :3, 3]
    return np.concatenate([log_so3(R), translation], -1)


def damped_path(arm, target, q0, alpha, eps, steps):
    """Return the joint angles of damped least-squares steps towards a point, q0 first.

    Source: Nakamura and Hanafusa (1986).

    Each step is q <- q - alpha (eps I + J^T J)^-1 J^T (p(q) - target), with the end-effector's
    position p and its Jacobian J. It ignores the joint limits.

    Parameters
    ----------
    arm : SerialArm
    target : array_like (..., 2) or (..., 3)
        The point, in metres; two coordinates for an arm that moves in the plane z = 0.
    q0 : array_like (..., n)
        Joint angles at the beginning, in radians.
    alpha : array_like (...)
        The step size, above zero; 1 is the full step.
    eps : array_like (...)
        The damping, above zero, in square metres.
    steps : int

    Returns
    -------
    array (..., steps + 1, n)
        Joint angles in radians. The batches of all arguments are broadcast.

    Examples
    --------
    >>> from course_lib.arms import planar_arm
    >>> arm = planar_arm([1, 1])
    >>> path = damped_path(arm, [1, 1], q0=[0.3, 0.5], alpha=1, eps=0.01, steps=30)
    >>> print(arm.fk(path[-1])[:2, 3].round(6))
    [1. 1.]
    """
    checked_arm(arm, "arm")
    target = real_array(target, "target", *([(2,), (3,)] if _is_planar(arm) else [(3,)]))
    q = real_array(q0, "q0", (arm.n,))
    alpha, eps = positive(alpha, "alpha"), positive(eps, "eps")
    batch = broadcast(target=target.shape[:-1], q0=q.shape[:-1], alpha=alpha.shape, eps=eps.shape)
    k = target.shape[-1]
    n = arm.n
    steps = count(steps, "steps")
    flat = int(np.prod(batch))
    target = np.broadcast_to(target, (*batch, k)).reshape(flat, k).T
    alpha, eps = (np.broadcast_to(value, batch).reshape(flat) for value in (alpha, eps))
    path = np.empty((*batch, steps + 1, n))
    path[..., 0, :] = q
    q = path[..., 0, :].reshape(flat, n).T
    J = np.empty((6, n, flat))
    for i in range(steps):
        _, position = arm.batched.fill_geometric_jacobian(q, J)
        step, sound = _damped_step(J[3 : 3 + k], position[:k] - target, eps)
        if not sound.all():
            raise ValueError("eps is too small: rounding outweighs it where the arm is singular")
        with np.errstate(over="ignore"):
            q = q - alpha * step
        path[..., i + 1, :] = q.T.reshape(*batch, n)
        refuse_first(
            ~np.isfinite(path[..., i + 1, :]).all(-1), "alpha", "is too large: the angles overflow"
        )
    return path


def _is_planar(arm):
    """Return whether the end-effector stays in the plane z = 0.

    It does if all axes are along z and it begins there.
    """
    return not arm.screw_axes[:, [0, 1, 5]].any() and arm.home[-1, 2, 3] == 0
