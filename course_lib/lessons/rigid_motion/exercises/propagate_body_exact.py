"""propagate_body_exact: a plan of body velocities, followed by the exponential of SE(2)."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.mistake import Mistake
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


def exact(pose, velocity, h):
    """Return the pose after a step, by its exponential."""
    T = pose_matrix(pose) @ exp_se2(velocity[[2, 0, 1]] * h)
    return np.array([T[0, 2], T[1, 2], pose[2] + velocity[2] * h])


def _straight_steps(share):
    """Return the answer that goes straight in each step, along the direction after this share of
    it."""
    return shared.follow(propagate_body.move_by(lambda theta, omega, h: theta + share * omega * h))


def _by(step, angle_of=lambda T, theta: theta):
    """Return the answer of a student whose pose after a step is step(pose as a matrix, velocity,
    h)."""

    def move(pose, velocity, h):
        T = step(pose_matrix(pose), velocity, h)
        return np.array([T[0, 2], T[1, 2], angle_of(T, pose[2] + velocity[2] * h)])

    return shared.follow(move)


def _right_step(T, velocity, h):
    return T @ exp_se2(velocity[[2, 0, 1]] * h)


def _slow_rotation_lost(bound):
    def move(pose, velocity, h):
        step = propagate_body.euler if abs(velocity[2]) < bound else exact
        return step(pose, velocity, h)

    def answer(start, plan, dt):
        if not any(0 < abs(velocity[2]) < bound for velocity, _ in plan):
            return None
        rows, right = shared.follow(move)(start, plan, dt), shared.follow(exact)(start, plan, dt)
        return None if shared.near(rows, right, shared.BODY, EXACT) else rows

    return answer


EXERCISE = declared(
    "propagate_body_exact",
    points=2,
    sets=2,
    arguments=propagate_body.PLAN,
    cases=_cases,
    special=propagate_body.special(3),
    admits=propagate_body.quarters_of_steps,
    sweeps=(
        Sweep("omega near 0", _slow, ON_BOTH_SIDES),
        shared.slow_motions(3),
        propagate_body.LAST_STEPS,
    ),
    tolerance=EXACT,
    reads=propagate_body.read_poses,
    properties=shared.form(shared.BODY),
    library=propagate_body_exact,
    alike=shared.same_rows(shared.BODY),
    distance=shared.distance_of_rows(shared.BODY),
    says="each pose is the previous pose times the exponential of the twist times the time",
    found=shared.first_wrong_step(propagate_body_exact, shared.BODY),
    hints=(
        "The loops are those of propagate_body; only the step differs.",
        "T = pose_matrix(pose) @ rigid.exp_se2(np.array([omega, vx, vy]) * h), and x = T[0, 2], y "
        "= T[1, 2].",
        "theta = theta + omega * h is exact already.",
    ),
    forbidden=("course_lib.planar.propagate_body_exact",),
    mistakes=(
        shared.MATRICES,
        Mistake(
            "each step goes straight, in one direction",
            "On which curve does a body move if it rotates meanwhile? And how far is it from the "
            "beginning of that curve to its end?",
            *map(_straight_steps, (0, 0.5, 1)),
        ),
        Mistake(
            "a slow rotation is taken for none",
            "A body that drives 1 m and rotates by 1e-5 rad meanwhile ends 5 micrometres to the "
            "side: which lines does your function use for such an omega?",
            *map(_slow_rotation_lost, (1e-2, 1e-3, 1e-4, 1e-6)),
        ),
        Mistake(
            "the exponential stands on the left",
            "The velocities are in the body's frame: on which side of the pose does a motion in "
            "the body's frame stand?",
            _by(lambda T, velocity, h: exp_se2(velocity[[2, 0, 1]] * h) @ T),
        ),
        Mistake(
            "the twist is in the order (vx, vy, omega)",
            "rigid.exp_se2 takes the angular velocity first.",
            _by(lambda T, velocity, h: T @ exp_se2(velocity * h)),
            _by(
                lambda T, velocity, h: T @ exp_se2(velocity * h),
                lambda T, theta: np.arctan2(T[1, 0], T[0, 0]),
            ),
        ),
        Mistake(
            "the twist is not multiplied by the time",
            "A twist is a velocity, and the exponential takes it for one second. How long is the "
            "step that is shown?",
            _by(
                lambda T, velocity, h: T @ exp_se2(velocity[[2, 0, 1]]),
                lambda T, theta: np.arctan2(T[1, 0], T[0, 0]),
            ),
        ),
        shared.lost_sign(_by(_right_step, lambda T, theta: np.arccos(min(1, T[0, 0])))),
        *shared.step_mistakes(exact),
    ),
)
