"""propagate_body_exact: a plan of body velocities, followed by the exponential of SE(2)."""

import numpy as np

from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.rigid_motion.propagate_body import (
    ADDED,
    DEGREES,
    NO_ROTATION,
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
from course_lib.checks.exercises.rigid_motion.shared import (
    BODY,
    FINE,
    STEP_LENGTHS,
    follow,
    form,
    goes_straight,
    lengths,
    near,
    same_rows,
    size_of,
)
from course_lib.checks.exercises.rigid_motion.shared_mistakes import step_mistakes
from course_lib.planar import pose_matrix, propagate_body, propagate_body_exact
from course_lib.rigid import exp_se2, inverse


def _cases(rng):
    """Those of Euler's method; one start and plan with three dt; slow rotations, a whole revolution, standing still."""
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
    return size_of(poses - propagate_body_exact(*case), BODY).max(axis=1)


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
    """The exponential on the left: a rotation about the world's origin."""
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


def _not_rotated(pose, velocity, h):
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


def _product(step):
    """Matrices multiplied up by step(T, vx, vy, omega, h), and theta added up beside them."""

    def answer(start, plan, dt):
        T, rows = pose_matrix(start), [np.array(start, float)]
        for velocity, duration in plan:
            for h in lengths(duration, dt):
                T = step(T, *velocity, h)
                rows.append(_row(T, rows[-1][2] + velocity[2] * h))
        return np.array(rows)

    return answer


def _from_the_pair_s_beginning(move):
    """Each pose of a pair by one move from the pose at its beginning, for the time since then."""

    def answer(start, plan, dt):
        poses = [np.array(start, float)]
        for velocity, duration in plan:
            begin = poses[-1]
            poses += [move(begin, np.array(velocity, float), time) for time in np.cumsum(lengths(duration, dt))]
        return np.array(poses)

    return answer


def _theta_read_by(inverse_function):
    def answer(*case):
        rows = propagate_body_exact(*case)
        return np.column_stack([rows[:, :2], inverse_function(rows[:, 2])])

    return answer


def _slow_cut(bound):
    """Rotations slower than `bound` taken for none in the position."""

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
        Property(
            "without rotation the path is straight, along R(theta) (vx, vy)", _right, _wrong_pose, where=goes_straight
        ),
        Property(
            "the last pose is the same for every dt",
            _end_moves,
            says=lambda poses, *case: (
                f"Yours, with dt = {case[2]:.4g}, is {format_tuple(poses[-1])}; with another dt it was another."
            ),
            across=True,
        ),
        Property(
            "each pose is the one before times the exponential of the twist (omega, vx, vy) times the time",
            _right,
            says=_wrong_pose,
        ),
    ),
    mistakes=(
        *step_mistakes(BODY, propagate_body_exact, exact),
        Mistake(
            "each step goes straight: this is Euler's method",
            "While the body rotates, its path bends: T exp(h [twist]).",
            propagate_body,
            follow(move_by(lambda theta, omega, h: theta + omega * h)),
        ),
        Mistake(
            "each step goes straight, with an angle halfway between its ends",
            "That is closer than Euler's method, and still not exact: the chord of an arc is shorter than the arc.",
            follow(move_by(lambda theta, omega, h: theta + omega * h / 2)),
            follow(_mean_of_ends),
        ),
        Mistake(
            "the exponential stands on the left",
            "The velocities are in the body's frame: T exp(h [twist]). On the left they are the world's.",
            follow(_before),
        ),
        Mistake(
            "the twist is in the order (vx, vy, omega)",
            "rigid.exp_se2 takes the angular velocity first: (omega, vx, vy).",
            follow(_exponential_of(lambda vx, vy, omega, h: np.array([vx, vy, omega]) * h)),
            *(
                moved(_only_theta(_exponential_of(lambda vx, vy, omega, h: np.array([vx, vy, omega]) * h)))
                for moved in (follow, _from_the_pair_s_beginning)
            ),
            _product(lambda T, vx, vy, omega, h: T @ exp_se2(np.array([vx, vy, omega]) * h)),
        ),
        Mistake(
            "one exponential is taken of all velocities together",
            "exp(A) exp(B) is not exp(A + B): each pair has an exponential of its own, one after the other.",
            _total,
        ),
        Mistake(
            "the time since the pair began is counted from the row before",
            "Either the pose at the pair's beginning and the time since then, or the row before and one step.",
            _elapsed_twice,
        ),
        Mistake(
            "start is ignored: the motion begins at the origin",
            "The first pose is pose_matrix(start), and each step multiplies the pose before it.",
            lambda start, plan, dt: np.array([start, *propagate_body_exact(np.zeros(3), plan, dt)[1:]]),
            lambda start, plan, dt: propagate_body_exact(np.zeros(3), plan, dt),
        ),
        Mistake(
            "start is added to a motion that begins at the origin",
            "start has a direction too: pose_matrix(start) @ ... rotates the motion.",
            lambda start, plan, dt: np.add(start, propagate_body_exact(np.zeros(3), plan, dt)),
        ),
        Mistake(
            "the exponential is multiplied by h, and not the twist",
            "exp(h twist) is not h exp(twist): scale the twist first.",
            _product(lambda T, vx, vy, omega, h: T @ (h * exp_se2([omega, vx, vy]))),
        ),
        Mistake(
            "the product is entry by entry",
            "In numpy the matrix product is @.",
            _product(lambda T, vx, vy, omega, h: T * exp_se2(np.array([omega, vx, vy]) * h)),
        ),
        Mistake(
            "theta is read by arccos, arcsin or arctan, which know the angle on half of the circle only",
            "theta = np.arctan2(T[1, 0], T[0, 0]), or start's theta plus omega times the time.",
            *map(_theta_read_by, (lambda a: np.arcsin(np.sin(a)), lambda a: np.arccos(np.cos(a)))),
            _theta_read_by(lambda a: np.arctan(np.tan(a))),
        ),
        Mistake(
            *NO_ROTATION, lambda start, plan, dt: propagate_body_exact(start, plan, dt) * [1, 1, 0] + [0, 0, start[2]]
        ),
        Mistake(
            "slow rotations are taken for none",
            "Only omega = 0 needs a branch of its own, if any; rigid.exp_se2 needs none at all.",
            *(_slow_cut(bound) for bound in (1e-4, 0.1, 0.7)),
        ),
        Mistake(
            "the velocities are not multiplied by the time",
            "rigid.exp_se2 follows a twist for one second. For h seconds, give it the twist times h.",
            follow(lambda pose, velocity, h: exact(pose, velocity, 1.0)),
            follow(_only_theta(lambda pose, velocity, h: exact(pose, velocity, 1.0))),
        ),
        Mistake(
            "the translation of the exponential is not rotated by theta",
            "The exponential gives the translation in the body's frame; T exp(h [twist]) has it in the world's.",
            follow(_not_rotated),
        ),
        Mistake("the motion is backwards", "T exp(h [twist]): no inverse, no minus.", follow(_backwards)),
        Mistake(*ADDED, *assigned(exact)),
        Mistake(*WORLD, follow(move_by(lambda theta, omega, h: 0 * theta))),
        Mistake(*SIDEWAYS, follow(_exponential_of(lambda vx, vy, omega, h: np.array([omega, vy, vx]) * h))),
        Mistake(*NO_ROTATION, follow(_exponential_of(lambda vx, vy, omega, h: np.array([0, vx, vy]) * h))),
        Mistake(
            *DEGREES,
            follow(_exponential_of(lambda vx, vy, omega, h: np.array([np.deg2rad(omega), vx, vy]) * h)),
            follow(_exponential_of(lambda vx, vy, omega, h: np.array([np.rad2deg(omega), vx, vy]) * h)),
            lambda *case: propagate_body_exact(*case) * [1, 1, 180 / np.pi],
        ),
        Mistake("x and y are swapped", "A row is (x, y, theta).", lambda *c: propagate_body_exact(*c)[:, [1, 0, 2]]),
    ),
    library=propagate_body_exact,
    hints=(
        "The loops are those of propagate_body; only the step differs.",
        "T = pose_matrix(pose) @ rigid.exp_se2(np.array([omega, vx, vy]) * h), and x = T[0, 2], y = T[1, 2].",
        "theta = theta + omega * h is exact already.",
    ),
    alike=same_rows(BODY),
    forbidden=("course_lib.planar.propagate_body_exact",),
)
