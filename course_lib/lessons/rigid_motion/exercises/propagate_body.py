"""propagate_body: a plan of body velocities, followed by Euler's method."""

import itertools

import numpy as np

from course_lib.checks.answer_types import rows
from course_lib.checks.declared import declared
from course_lib.checks.kinds import OWN_CASES, eighths, quarters, whole_numbers
from course_lib.checks.mistake import Mistake
from course_lib.checks.special_cases import Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.lessons.rigid_motion.exercises import shared
from course_lib.planar import propagate_body

ORIGIN = (0.0, 0.0, 0.0)
AHEAD, LEFT, SPIN = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
PLAN = dict.fromkeys(("start", "plan", "dt"), OWN_CASES.but(free=True))


def read_poses(value, *case):
    """Return an answer as rows (x, y, theta), of any number."""
    return rows(3, "poses, an array of shape (n, 3)", most=2000)(value, *case)


def _signed(rng, low, high, size):
    return rng.choice([-1, 1], size) * rng.uniform(low, high, size)


def drawn_durations(dt, rng):
    """Return durations of three pairs: not a multiple of dt, a multiple, and shorter than dt."""
    ratios = rng.integers(1, 4) + rng.uniform(0.2, 0.8), rng.integers(2, 4), rng.uniform(0.3, 0.7)
    return [float(np.round(dt * ratio, 4)) for ratio in ratios]


def drawn_case(rng, angles=1, lengths=2):
    """Return a case in general position; the columns of start are lengths, and then angles."""
    dt = float(np.round(rng.uniform(0.1, 0.4), 2))
    start = np.round([*_signed(rng, 1, 5, lengths), *_signed(rng, 1, 5, angles)], 2)
    velocities = [
        tuple(np.round(_signed(rng, 0.5, 2, lengths + angles), 2).tolist()) for _ in range(3)
    ]
    return start, list(zip(velocities, drawn_durations(dt, rng), strict=True)), dt


def special(columns):
    """Return special(rng) of an exercise on a plan: rows that return to where they were, velocities
    that occur twice, and steps of quarters of a revolution, up to a whole one."""

    def pair(rng, dt):
        velocity = np.append(whole_numbers(rng, columns - 1), quarters(rng) / dt)
        return tuple(velocity.tolist()), dt * float(rng.integers(1, 65) / 4)

    def case(rng):
        start = np.append(whole_numbers(rng, columns - 1), eighths(rng))
        dt = float(rng.integers(1, 5) / 4)
        plan = [pair(rng, dt) for _ in range(rng.integers(1, 4))]
        return start, [*plan, *plan[: rng.integers(2)]], dt

    return case


def quarters_of_steps(start, plan, dt):
    """Return whether each part of a plan takes quarters of steps: another rest may be a step so
    short that rounding decides whether it is one."""
    return all((4 * duration / dt).is_integer() for _, duration in plan)


def body_cases(rng):
    """Return cases (start, plan, dt), also of the exact method."""
    origin = np.array(ORIGIN)
    simple = [
        ([0, 0, 0], [((1, 0, 0), 0.25)], 0.1),
        (origin, [(SPIN, 0.5)], 0.25),
        (np.array([1.0, 2.0, np.pi / 2]), [(AHEAD, 0.5)], 0.25),
        (origin, [(LEFT, 0.5)], 0.25),
        (np.array([0.0, 3.0, 1.0]), [((2.0, 1.0, 0.0), 0.35)], 0.1),
        (origin, [((1.0, 0.0, 1.0), 0.75)], 0.25),
        (np.array([2.0, 0.0, -0.5]), [((1.0, 0.5, -2.0), 0.7)], 0.2),
        (origin, [(AHEAD, 0.3)], 1.0),
        (origin, [(AHEAD, 0.2005)], 0.1),
        (origin, [(AHEAD, 0.2995)], 0.1),
        (np.array([0, 1, 1]), [((1, 0, 0), 1)], 0.5),
    ]
    rounding = (
        (0.3, 0.1),
        (0.9, 0.3),
        (1.0, 0.1),
        (1.1, 0.1),
        (2.1, 0.3),
    )  # a hair above or below a multiple
    sums = [(origin, [(AHEAD, duration)], dt) for duration, dt in rounding]
    several = [
        ([1, 2, 3], [(ORIGIN, 0.5)], 0.25),
        (origin, [(AHEAD, 0.25), (LEFT, 0.1)], 0.1),
        (origin, [(SPIN, 0.25), (AHEAD, 0.25)], 0.1),
        ([-1.0, 2.0, 3.0], [(AHEAD, 0.5), ((1.0, 0.0, 2.0), 0.6), ((1.0, 0.0, -1.0), 0.45)], 0.25),
    ]
    # Any of the three velocities may be 0, whatever the others are.
    several += [
        (np.array([1.0, 2.0, 0.5]), [(tuple(zeros * np.array([1.0, 0.5, 2.0])), 0.5)], 0.25)
        for zeros in np.array(list(itertools.product((0, 1), repeat=3)))[1:]
    ]
    start, plan, dt = drawn_case(rng)
    several.append((np.rint(start), plan, dt))  # whole numbers, and legs that end between them
    return [*simple, *sums, *several, *shared.plans(3), *(drawn_case(rng) for _ in range(4))]


def _nearly_a_multiple(rng, gap):
    """Return a case in which the last step of a pair is tiny, or, with a negative gap, nearly as
    long as the others."""
    start, (first, *others), dt = drawn_case(rng)
    return start, [(first[0], dt * (2 + gap)), *others], dt


# A step shorter than 1e-9 s is none for step_lengths.
LAST_STEPS = Sweep(
    "a duration that is nearly a multiple of dt",
    _nearly_a_multiple,
    tuple(sign * gap for gap in (0.1, 1e-2, 1e-3, 1e-4, 1e-5) for sign in (1, -1)),
)


def move_by(direction):
    """Return a move(pose, velocity, h) along R(direction(theta, omega, h)) (vx, vy)."""

    def move(pose, velocity, h):
        theta, omega = pose[2], velocity[2]
        translation = shared.rotated(direction(theta, omega, h), velocity[:2]) * h
        return np.array([*(pose[:2] + translation), theta + omega * h])

    return move


euler = move_by(lambda theta, omega, h: theta)


def _along(direction):
    """Return the answer of Euler's method along another direction."""
    return shared.follow(move_by(direction))


def _with_velocity(change):
    """Return the answer of Euler's method with change(velocity) for each velocity."""
    return shared.follow(lambda pose, velocity, h: euler(pose, change(velocity), h))


def _along_the_axes(factors):
    """Return the answer whose velocities in the world are those of the plan times
    factors(theta)."""
    return shared.follow(lambda pose, velocity, h: pose + velocity * factors(pose[2]) * h)


def _with_theta_of_the_start(start, plan, dt):
    return _along(lambda theta, omega, h: start[2])(start, plan, dt)


EXERCISE = declared(
    "propagate_body",
    points=3,
    arguments=PLAN,
    cases=body_cases,
    sweeps=(shared.slow_motions(3), LAST_STEPS),
    special=special(3),
    admits=quarters_of_steps,
    tolerance=EXACT,
    reads=read_poses,
    properties=shared.form(shared.BODY),
    library=propagate_body,
    alike=shared.same_rows(shared.BODY),
    distance=shared.distance_of_rows(shared.BODY),
    says="in each step of length h, (x, y) moves by R(theta) (vx, vy) h, with theta at the "
    "beginning of the step, and theta grows by omega h",
    found=shared.first_wrong_step(propagate_body, shared.BODY),
    hints=(
        "Two loops: over the pairs of the plan, and in each over the steps. Begin with poses = "
        "[start] and append.",
        "The steps of a pair are those of step_lengths(duration, dt): for h in "
        "step_lengths(duration, dt).",
        "x grows by (cos(theta) vx - sin(theta) vy) h, y by (sin(theta) vx + cos(theta) vy) h, and "
        "only then theta by omega h.",
    ),
    forbidden=("course_lib.planar.propagate_body",),
    mistakes=(
        shared.MATRICES,
        Mistake(
            "theta at the end or in the middle of the step is used, not at its beginning",
            "Euler's method takes the velocity at the beginning of a step: which line comes last?",
            _along(lambda theta, omega, h: theta + omega * h),
            _along(lambda theta, omega, h: theta + omega * h / 2),
        ),
        Mistake(
            "vx changes only x, and vy only y, as along the axes of the world",
            "vx is the velocity ahead and vy that to the left of the body: which matrix rotates "
            "(vx, vy) into the axes of the world?",
            _along_the_axes(lambda theta: (1, 1, 1)),
            _along_the_axes(lambda theta: (np.cos(theta), np.sin(theta), 1)),
        ),
        Mistake(
            "vy is left out, or counted to the right",
            "Where does a body go that moves only to its left?",
            _with_velocity(lambda velocity: velocity * [1, 0, 1]),
            _with_velocity(lambda velocity: velocity * [1, -1, 1]),
        ),
        Mistake(
            "R is transposed: the velocity is rotated in the opposite direction",
            "If a body that faces along y drives ahead, does its y grow? And in your rows?",
            _along(lambda theta, omega, h: -theta),
        ),
        Mistake(
            "R is computed only once",
            "The body rotates, and with it the direction in which it moves. From which theta do "
            "you compute R in each step?",
            _with_theta_of_the_start,
        ),
        Mistake(
            "the velocities are read as (omega, vx, vy)",
            "In a plan omega is the last of the three.",
            _with_velocity(lambda velocity: velocity[[1, 2, 0]]),
        ),
        *shared.step_mistakes(euler),
    ),
)
