"""propagate_body_exact: a plan of body velocities, followed by the exponential of SE(2)."""

import numpy as np

from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.special_cases import ON_BOTH_SIDES, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.lessons.rigid_motion.exercises import propagate_body, shared
from course_lib.planar import pose_matrix, propagate_body_exact
from course_lib.rigid import exp_se2


def _cases(rng):
    """Those of Euler's method; one start and plan with three dt; slow rotations, a whole
    revolution."""
    origin = np.array(propagate_body.ORIGIN)
    quarter = [([0, 0, 0], [((1, 0, np.pi / 2), 1.0)], 1.0)]
    halved = [([0, 0, 0], [((1, 0, np.pi / 2), 1.0)], 0.5)]
    slow = [
        (np.array([0.0, 0.0, 0.5]), [((1.0, 0.5, omega), 1.0)], 0.5)
        for omega in (1e-9, -1e-9, 2e-5, -2e-5)
    ]
    round_about = [(origin, [((0.5, 0.0, 2 * np.pi), 1.0)], 0.25)]
    # Steps of more than half a revolution, and of several.
    wide = [
        (np.array([0.0, 0.0, 0.5]), [((1.0, 0.3, omega), 2.0)], 1.0)
        for omega in (4.0, -4.0, 2 * np.pi, 41.0)
    ]
    start, plan, dt = propagate_body.drawn_case(rng)
    any_dt = [(start, plan, step) for step in (dt, 0.6 * dt, 10.0)]
    return [
        *propagate_body.body_cases(rng),
        *quarter,
        *halved,
        *slow,
        *round_about,
        *wide,
        *any_dt,
    ]


def _slow(rng, gap):
    velocity = (*rng.uniform(-1, 1, 2).round(2).tolist(), gap)
    return np.array([1.0, -2.0, 0.5]), [(velocity, 1.0)], 0.5


def _end_moves(values, cases):
    """The position of the first answer whose last pose another dt has changed."""
    for i, (start, plan, _) in enumerate(cases):
        for j, (other_start, other_plan, _) in enumerate(cases[:i]):
            alike = plan == other_plan and np.array_equal(start, other_start)
            if alike and not shared.near(values[i][-1:], values[j][-1:], shared.BODY, EXACT):
                return i
    return None


def exact(pose, velocity, h):
    """The pose after a step, by its exponential."""
    T = pose_matrix(pose) @ exp_se2(velocity[[2, 0, 1]] * h)
    return np.array([T[0, 2], T[1, 2], pose[2] + velocity[2] * h])


EXERCISE = Exercise(
    name="propagate_body_exact",
    points=2,
    sets=2,
    arguments=("start", "plan", "dt"),
    tolerance=EXACT,
    cases=_cases,
    returns=propagate_body.read_poses,
    properties=(
        *shared.form(shared.BODY),
        shared.STEP_LENGTHS,
        propagate_body.THETA,
        shared.each_step(
            "without rotation the path is straight, along R(theta) (vx, vy)",
            exact,
            shared.BODY,
            where=shared.goes_straight,
        ),
        Property(
            "the last pose is the same for every dt",
            _end_moves,
            says=lambda poses, *case: (
                f"With dt = {case[2]:.4g} yours is {format_tuple(poses[-1])}. With another dt it "
                f"differs."
            ),
            across=True,
        ),
        shared.each_step(
            "each pose is the previous pose times the exponential of the twist times the time",
            exact,
            shared.BODY,
        ),
    ),
    library=propagate_body_exact,
    hints=(
        "The loops are those of propagate_body; only the step differs.",
        "T = pose_matrix(pose) @ rigid.exp_se2(np.array([omega, vx, vy]) * h), and x = T[0, 2], y "
        "= T[1, 2].",
        "theta = theta + omega * h is exact already.",
    ),
    alike=shared.same_rows(shared.BODY),
    distance=shared.distance_of_rows(shared.BODY),
    sweeps=(
        Sweep("omega near 0", _slow, ON_BOTH_SIDES),
        shared.slow_motions(3),
        propagate_body.LAST_STEPS,
    ),
    forbidden=("course_lib.planar.propagate_body_exact",),
)

EXERCISE.mistake(shared.MATRICES, form=shared.are_matrices)


@EXERCISE.mistake(
    "each step goes straight, in one direction",
    "On which curve does a body move if it rotates meanwhile? And how far is it from the beginning "
    "of that curve to its end?",
    share=(0, 0.5, 1),
)
def straight_steps(start, plan, dt, share):
    return shared.follow(propagate_body.move_by(lambda theta, omega, h: theta + share * omega * h))(
        start, plan, dt
    )


def _by(step, angle_of=lambda T, theta: theta):
    """Return the answer of a student whose pose after a step is step(pose as a matrix, velocity,
    h)."""

    def move(pose, velocity, h):
        T = step(pose_matrix(pose), velocity, h)
        return np.array([T[0, 2], T[1, 2], angle_of(T, pose[2] + velocity[2] * h)])

    return shared.follow(move)


@EXERCISE.mistake(
    "a slow rotation is taken for none",
    "A body that drives 1 m and rotates by 1e-5 rad meanwhile ends 5 micrometres to the side: "
    "which lines does your function use for such an omega?",
    bound=(1e-2, 1e-3, 1e-4, 1e-6),
)
def slow_rotation_lost(start, plan, dt, bound):
    if not any(0 < abs(velocity[2]) < bound for velocity, _ in plan):
        return None

    def move(pose, velocity, h):
        step = propagate_body.euler if abs(velocity[2]) < bound else exact
        return step(pose, velocity, h)

    rows, right = shared.follow(move)(start, plan, dt), shared.follow(exact)(start, plan, dt)
    return None if shared.near(rows, right, shared.BODY, EXACT) else rows


@EXERCISE.mistake(
    "the exponential stands on the left",
    "The velocities are in the body's frame: on which side of the pose does a motion in the body's "
    "frame stand?",
)
def on_the_left(*case):
    return _by(lambda T, velocity, h: exp_se2(velocity[[2, 0, 1]] * h) @ T)(*case)


@EXERCISE.mistake(
    "the twist is in the order (vx, vy, omega)",
    "rigid.exp_se2 takes the angular velocity first.",
    angle_of=(lambda T, theta: theta, lambda T, theta: np.arctan2(T[1, 0], T[0, 0])),
)
def order_of_the_twist(*case, angle_of):
    return _by(lambda T, velocity, h: T @ exp_se2(velocity * h), angle_of)(*case)


@EXERCISE.mistake(
    "arccos loses the sign of the angle",
    "Which function uses both sine and cosine, so that the angle keeps its sign?",
)
def angle_without_sign(*case):
    step = _by(
        lambda T, velocity, h: T @ exp_se2(velocity[[2, 0, 1]] * h),
        lambda T, theta: np.arccos(min(1, T[0, 0])),
    )
    return step(*case)


shared.add_step_mistakes(EXERCISE, exact)
