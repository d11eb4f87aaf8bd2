"""propagate_body_exact: a plan of body velocities, followed by the exponential of SE(2)."""

import numpy as np

from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.rigid_motion.plan_mistakes import step_mistakes
from course_lib.checks.rigid_motion.plans import (
    FINE,
    STEP_LENGTHS,
    follow,
    form,
    lengths,
    like,
    near,
    off,
    straight,
)
from course_lib.checks.rigid_motion.propagate_body import (
    ADDED,
    BODY,
    DEGREES,
    NO_TURN,
    ORIGIN,
    SIDEWAYS,
    THETA,
    WORLD,
    assigned,
    body_cases,
    drawn_case,
    euler,
    move_by,
    read_poses,
)
from course_lib.planar import pose_matrix, propagate_body, propagate_body_exact
from course_lib.rigid import exp_se2, inverse


def _cases(rng):
    """Those of Euler's rule; one start and plan with three dt; slow turns, a whole turn, and standing still."""
    origin = np.array(ORIGIN)
    quarter = [([0, 0, 0], [((1, 0, np.pi / 2), 1.0)], 1.0)]
    halved = [([0, 0, 0], [((1, 0, np.pi / 2), 1.0)], 0.5)]
    slow = [(np.array([0.0, 0.0, 0.5]), [((1.0, 0.5, omega), 1.0)], 0.5) for omega in (1e-9, -1e-9, 2e-5, -2e-5)]
    still = [(np.array([1.0, 2.0, 0.5]), [(ORIGIN, 0.5), ((1.0, 0.0, 1.0), 0.5)], 0.25)]
    round_about = [(origin, [((0.5, 0.0, 2 * np.pi), 1.0)], 0.25)]
    start, plan, dt = drawn_case(rng)
    any_dt = [(start, plan, step) for step in (dt, 0.6 * dt, 10.0)]
    return [*body_cases(rng), *quarter, *halved, *slow, *still, *round_about, *any_dt]


def _end_moves(values, cases):
    """The position of the first answer whose last pose another dt has changed."""
    for i, (start, plan, _) in enumerate(cases):
        for j, (other_start, other_plan, _) in enumerate(cases[:i]):
            alike = plan == other_plan and np.array_equal(start, other_start)
            if alike and not near(values[i][-1:], values[j][-1:], BODY, FINE):
                return i
    return None


def _errors(poses, *case):
    return off(poses - propagate_body_exact(*case), BODY).max(axis=1)


def _right(poses, *case):
    return _errors(poses, *case).max() < FINE * max(1, np.abs(propagate_body_exact(*case)).max())


def _wrong_pose(poses, *case):
    errors = _errors(poses, *case)
    k = int(np.argmax(errors > FINE))
    return (
        f"Row {k}, counted from 0, should be {format_tuple(propagate_body_exact(*case)[k])}. "
        f"Yours is {format_tuple(poses[k])}, off by {errors[k]:.2g}."
    )


def _row(T, theta):
    return np.array([T[0, 2], T[1, 2], theta])


def exact(pose, velocity, h, times=1.0):
    """The pose after a step, by its exponential."""
    T = pose_matrix(pose) @ exp_se2(velocity[[2, 0, 1]] * h * times)
    return _row(T, pose[2] + velocity[2] * h * times)


def _before(pose, velocity, h):
    """The exponential on the left: a turn about the world's origin."""
    T = exp_se2(velocity[[2, 0, 1]] * h) @ pose_matrix(pose)
    return _row(T, pose[2] + velocity[2] * h)


def _exponential_of(twist):
    """The exponential of another vector where the twist (omega, vx, vy) times h belongs."""

    def move(pose, velocity, h):
        T = pose_matrix(pose) @ exp_se2(twist(*velocity, h))
        return _row(T, np.arctan2(T[1, 0], T[0, 0]))

    return move


def _only_theta(move):
    """The position by another move, with the right theta."""
    return lambda pose, velocity, h: np.append(move(pose, velocity, h)[:2], pose[2] + velocity[2] * h)


def _backwards(pose, velocity, h):
    T = pose_matrix(pose) @ inverse(exp_se2(velocity[[2, 0, 1]] * h))
    return _row(T, pose[2] - velocity[2] * h)


def _not_turned(pose, velocity, h):
    return pose + _row(exp_se2(velocity[[2, 0, 1]] * h), velocity[2] * h)


def _mean_of_ends(pose, velocity, h):
    after = move_by(lambda theta, omega, h: theta + omega * h)
    return (euler(pose, velocity, h) + after(pose, velocity, h)) / 2


def _total(start, plan, dt):
    """The exponential of all velocities times their durations so far."""
    total, poses = np.zeros(3), [np.array(start, float)]
    for velocity, duration in plan:
        for h in lengths(duration, dt):
            total = total + np.array(velocity, float) * h
            poses.append(exact(np.array(start, float), total, 1.0))
    return np.array(poses)


def _elapsed_twice(start, plan, dt):
    """The time since the pair's beginning where the length of the step belongs."""
    poses = [np.array(start, float)]
    for velocity, duration in plan:
        for elapsed in np.cumsum(lengths(duration, dt)):
            poses.append(exact(poses[-1], np.array(velocity, float), elapsed))
    return np.array(poses)


def _slow_cut(bound):
    """Turns slower than `bound` taken for none, in the position or altogether."""

    def move(pose, velocity, h):
        return _only_theta(euler)(pose, velocity, h) if abs(velocity[2]) < bound else exact(pose, velocity, h)

    return follow(move)


EXERCISE = Exercise(
    name="propagate_body_exact",
    points=2,
    arguments=("start", "plan", "dt"),
    cases=_cases,
    returns=read_poses,
    properties=(
        *form(BODY),
        STEP_LENGTHS,
        THETA,
        Property("without turning the way is straight, along R(theta) (vx, vy)", _right, _wrong_pose, where=straight),
        Property(
            "the last pose is the same for every dt",
            _end_moves,
            seen=lambda poses, *case: (
                f"Yours, with dt = {case[2]:.4g}, is {format_tuple(poses[-1])}; with another dt it was another."
            ),
            across=True,
        ),
        Property(
            "each pose is the one before times the exponential of the twist (omega, vx, vy) times the time",
            _right,
            seen=_wrong_pose,
        ),
    ),
    mistakes=(
        *step_mistakes(BODY, propagate_body_exact, exact),
        *like(
            BODY,
            (
                "each step goes straight: this is Euler's rule",
                "While the body turns, its way bends. The exponential knows: T exp(h [twist]).",
            ),
            propagate_body,
            follow(move_by(lambda theta, omega, h: theta + omega * h)),
        ),
        *like(
            BODY,
            (
                "each step goes straight, with an angle halfway between its ends",
                "That is closer than Euler's rule, and still not exact: the chord of an arc is shorter than the arc.",
            ),
            follow(move_by(lambda theta, omega, h: theta + omega * h / 2)),
            follow(_mean_of_ends),
        ),
        *like(
            BODY,
            (
                "the exponential stands on the left",
                "The velocities are in the body's frame: T exp(h [twist]). On the left they are the world's.",
            ),
            follow(_before),
        ),
        *like(
            BODY,
            (
                "the twist is in the order (vx, vy, omega)",
                "rigid.exp_se2 takes the turning first: (omega, vx, vy).",
            ),
            follow(_exponential_of(lambda vx, vy, omega, h: np.array([vx, vy, omega]) * h)),
            follow(_only_theta(_exponential_of(lambda vx, vy, omega, h: np.array([vx, vy, omega]) * h))),
        ),
        *like(
            BODY,
            (
                "one exponential is taken of all velocities together",
                "exp(A) exp(B) is not exp(A + B): each pair has an exponential of its own, one after the other.",
            ),
            _total,
        ),
        *like(
            BODY,
            (
                "the time since the pair began is counted from the row before",
                "Either the pose at the pair's beginning and the time since then, or the row before and one step.",
            ),
            _elapsed_twice,
        ),
        *like(
            BODY,
            (
                "slow turns are taken for none",
                "Only omega = 0 needs a branch of its own, if any; rigid.exp_se2 needs none at all.",
            ),
            *(_slow_cut(bound) for bound in (1e-4, 0.1, 0.7)),
        ),
        *like(
            BODY,
            (
                "the velocities are not multiplied by the time",
                "rigid.exp_se2 follows a twist for one second. For h seconds, give it the twist times h.",
            ),
            follow(lambda pose, velocity, h: exact(pose, velocity, 1.0)),
            follow(_only_theta(lambda pose, velocity, h: exact(pose, velocity, 1.0))),
        ),
        *like(
            BODY,
            (
                "the way of the exponential is not turned by theta",
                "exp(h [twist]) says where the body goes as it sees it itself: T exp(h [twist]) turns that.",
            ),
            follow(_not_turned),
        ),
        *like(
            BODY,
            ("the motion is backwards", "T exp(h [twist]): no inverse, no minus."),
            follow(_backwards),
        ),
        *like(BODY, ADDED, *assigned(exact)),
        *like(BODY, WORLD, follow(move_by(lambda theta, omega, h: 0 * theta))),
        *like(BODY, SIDEWAYS, follow(_exponential_of(lambda vx, vy, omega, h: np.array([omega, vy, vx]) * h))),
        *like(BODY, NO_TURN, follow(_exponential_of(lambda vx, vy, omega, h: np.array([0, vx, vy]) * h))),
        *like(
            BODY,
            DEGREES,
            follow(_exponential_of(lambda vx, vy, omega, h: np.array([np.deg2rad(omega), vx, vy]) * h)),
            follow(_exponential_of(lambda vx, vy, omega, h: np.array([np.rad2deg(omega), vx, vy]) * h)),
            lambda *case: propagate_body_exact(*case) * [1, 1, 180 / np.pi],
        ),
        *like(
            BODY, ("x and y are swapped", "A row is (x, y, theta)."), lambda *c: propagate_body_exact(*c)[:, [1, 0, 2]]
        ),
    ),
    library=propagate_body_exact,
    hints=(
        "The loops are those of propagate_body; only what happens in a step is another.",
        "T = pose_matrix(pose) @ rigid.exp_se2(np.array([omega, vx, vy]) * h), and x = T[0, 2], y = T[1, 2].",
        "theta = theta + omega * h is exact already.",
    ),
    forbidden=("course_lib.planar.propagate_body_exact",),
)
