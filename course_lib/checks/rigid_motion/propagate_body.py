"""propagate_body: a plan of body velocities, followed by Euler's rule."""

import numpy as np

from course_lib.checks.answer_types import rows
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
    off,
    steps,
    turned,
)
from course_lib.planar import propagate_body, propagate_body_exact

BODY = (False, False, True)  # x, y, theta: the last is an angle
ORIGIN = (0.0, 0.0, 0.0)
AHEAD, LEFT, SPIN = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


def read_poses(value, *case):
    return rows(3, "poses, an array of shape (n, 3)", most=2000)(value, *case)


def _signed(rng, low, high, size):
    return rng.choice([-1, 1], size) * rng.uniform(low, high, size)


def drawn_durations(dt, rng):
    """Durations of three pairs: not a multiple of dt, a multiple, and shorter than dt."""
    ratios = rng.integers(1, 4) + rng.uniform(0.2, 0.8), rng.integers(2, 4), rng.uniform(0.3, 0.7)
    return [float(np.round(dt * ratio, 4)) for ratio in ratios]


def drawn_case(rng, angles=1, places=2):
    """A case in general position; the columns of start are places, and then angles."""
    dt = float(np.round(rng.uniform(0.1, 0.4), 2))
    start = np.round([*_signed(rng, 1, 5, places), *_signed(rng, 1, 5, angles)], 2)
    velocities = [tuple(np.round(_signed(rng, 0.5, 2, places + angles), 2).tolist()) for _ in range(3)]
    return start, list(zip(velocities, drawn_durations(dt, rng), strict=True)), dt


def body_cases(rng):
    """Cases (start, plan, dt), also of the exact way."""
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
    rounding = ((0.3, 0.1), (0.9, 0.3), (1.0, 0.1), (1.1, 0.1), (2.1, 0.3))  # a hair above or below a multiple
    sums = [(origin, [(AHEAD, duration)], dt) for duration, dt in rounding]
    several = [
        (origin, [(AHEAD, 0.25), (LEFT, 0.1)], 0.1),
        (origin, [(SPIN, 0.25), (AHEAD, 0.25)], 0.1),
        ([-1.0, 2.0, 3.0], [(AHEAD, 0.5), ((1.0, 0.0, 2.0), 0.6), ((1.0, 0.0, -1.0), 0.45)], 0.25),
    ]
    return [*simple, *sums, *several, *(drawn_case(rng) for _ in range(4))]


def _turns(poses, start, plan, dt):
    velocities, h = steps(plan, dt)
    return off(np.diff(poses[:, 2]) - velocities[:, 2] * h, True)


def _ways_off(poses, start, plan, dt):
    velocities, h = steps(plan, dt)
    way = turned(poses[:-1, 2], velocities[:, :2]) * h[:, None]
    return np.abs(np.diff(poses[:, :2], axis=0) - way).max(axis=1)


def _wrong_turn(poses, *case):
    k = int(np.argmax(_turns(poses, *case) > FINE))
    velocities, h = steps(*case[1:])
    return (
        f"In step {k + 1} omega is {velocities[k, 2]:.4g} and the step {h[k]:.4g} s long, so theta goes from "
        f"{poses[k, 2]:.4g} to {poses[k, 2] + velocities[k, 2] * h[k]:.4g}. Yours goes to {poses[k + 1, 2]:.4g}."
    )


def _wrong_way(poses, *case):
    k = int(np.argmax(_ways_off(poses, *case) > FINE))
    velocities, h = steps(*case[1:])
    way = turned(poses[k, 2], velocities[k, :2]) * h[k]
    return (
        f"Step {k + 1} begins with theta = {poses[k, 2]:.4g}, so it goes by {format_tuple(way)}. "
        f"Yours goes by {format_tuple(poses[k + 1, :2] - poses[k, :2])}."
    )


THETA = Property(
    "theta grows by omega times the length of the step",
    lambda poses, *case: _turns(poses, *case).max() < FINE,
    seen=_wrong_turn,
)


def move_by(direction, turn=lambda theta, omega, h: theta + omega * h):
    """A move(pose, velocity, h) along R(direction(theta, omega, h)) (vx, vy)."""

    def move(pose, velocity, h):
        theta, omega = pose[2], velocity[2]
        way = turned(direction(theta, omega, h), velocity[:2]) * h
        return np.array([*(pose[:2] + way), turn(theta, omega, h)])

    return move


euler = move_by(lambda theta, omega, h: theta)


def _before(change):
    """Euler's rule with the velocity changed beforehand."""
    return lambda pose, velocity, h: euler(pose, change(*velocity), h)


def assigned(move):
    """The printed rule: theta is omega times the time that the pair has lasted, and is not added to what was."""

    def answer(start, plan, dt, time_of=lambda elapsed, duration: elapsed):
        poses = [np.array(start, float)]
        for velocity, duration in plan:
            for elapsed, h in zip(np.cumsum(found := lengths(duration, dt)), found, strict=True):
                pose = move(poses[-1], np.array(velocity, float), h)
                poses.append(np.array([*pose[:2], velocity[2] * time_of(elapsed, duration)]))
        return np.array(poses)

    return answer, lambda *case: answer(*case, time_of=lambda elapsed, duration: duration)


def _all_assigned(start, plan, dt):
    poses = assigned(euler)[0](start, plan, dt)
    velocities, h = steps(plan, dt)
    return np.array([poses[0], *np.column_stack([turned(poses[:-1, 2], velocities[:, :2]) * h[:, None], poses[1:, 2]])])


def _theta_kept(start, plan, dt, from_start=False):
    """The angle at the beginning of each pair, or of the plan, for all its steps."""
    poses = [np.array(start, float)]
    for velocity, duration in plan:
        theta = start[2] if from_start else poses[-1][2]
        for h in lengths(duration, dt):
            pose = euler([*poses[-1][:2], theta], np.array(velocity, float), h)
            poses.append(np.array([*pose[:2], poses[-1][2] + velocity[2] * h]))
    return np.array(poses)


def _swapped(start, plan, dt):
    return propagate_body(start, plan, dt)[:, [1, 0, 2]]


ADDED = (
    "theta is assigned where it should be added, as in the printed rule theta = omega t",
    "The body had an angle before the step: theta = theta + omega * h.",
)
WORLD = (
    "the velocities are taken along the axes of the world",
    "(vx, vy) is ahead and to the left of the body. Turn it by R(theta) first.",
)
TRANSPOSED = (
    "R is transposed: the velocity is turned the other way round",
    "R(theta) = [[cos, -sin], [sin, cos]]: a body that faces up drives up, y grows.",
)
SIDEWAYS = ("vx and vy are swapped", "vx is ahead, along the body's x axis, and vy to its left.")
DEGREES = ("degrees and radians are mixed up", "Angles are radians everywhere: no np.deg2rad, no np.rad2deg.")
NO_TURN = ("theta stays as it is", "A step has three parts: x, y and theta, which grows by omega * h.")

EXERCISE = Exercise(
    name="propagate_body",
    points=3,
    arguments=("start", "plan", "dt"),
    cases=body_cases,
    returns=read_poses,
    properties=(
        *form(BODY),
        STEP_LENGTHS,
        THETA,
        Property(
            "each step goes by R(theta) (vx, vy) times its length, with theta at its beginning",
            lambda poses, *case: _ways_off(poses, *case).max() < FINE,
            seen=_wrong_way,
        ),
    ),
    mistakes=(
        *step_mistakes(BODY, propagate_body, euler),
        *like(BODY, ADDED, *assigned(euler), _all_assigned, follow(move_by(lambda a, w, h: a, lambda a, w, h: w * h))),
        *like(BODY, WORLD, follow(move_by(lambda theta, omega, h: 0 * theta))),
        *like(BODY, TRANSPOSED, follow(move_by(lambda theta, omega, h: -theta))),
        *like(
            BODY,
            (
                "theta at the end of the step is used, not at its beginning",
                "First move x and y with the old theta; then change theta.",
            ),
            follow(move_by(lambda theta, omega, h: theta + omega * h)),
        ),
        *like(
            BODY,
            ("theta in the middle of the step is used", "That is better than Euler's rule, but not what is asked."),
            follow(move_by(lambda theta, omega, h: theta + omega * h / 2)),
        ),
        *like(
            BODY,
            (
                "each step follows the exact arc",
                "That is propagate_body_exact, which comes next. Euler's rule goes straight in each step.",
            ),
            propagate_body_exact,
        ),
        *like(
            BODY,
            (
                "R is not computed anew in each step",
                "theta changes with each step, and R(theta) with it: compute it inside the inner loop.",
            ),
            _theta_kept,
            lambda *case: _theta_kept(*case, from_start=True),
        ),
        *like(BODY, SIDEWAYS, follow(_before(lambda vx, vy, omega: np.array([vy, vx, omega])))),
        *like(BODY, ("x and y are swapped", "A row is (x, y, theta)."), _swapped),
        *like(
            BODY,
            (
                "the velocities are not multiplied by the length of the step",
                "m/s times s is m: R(theta) (vx, vy) * h, and omega * h.",
            ),
            follow(lambda pose, velocity, h: euler(pose, velocity, 1.0)),
            follow(move_by(lambda theta, omega, h: theta, lambda theta, omega, h: theta + omega)),
            follow(lambda pose, velocity, h: np.append(euler(pose, velocity, 1.0)[:2], pose[2] + velocity[2] * h)),
        ),
        *like(
            BODY,
            DEGREES,
            follow(move_by(lambda theta, omega, h: np.deg2rad(theta))),
            follow(move_by(lambda theta, omega, h: np.rad2deg(theta))),
            follow(_before(lambda vx, vy, omega: np.array([vx, vy, np.deg2rad(omega)]))),
            follow(_before(lambda vx, vy, omega: np.array([vx, vy, np.rad2deg(omega)]))),
        ),
        *like(BODY, NO_TURN, follow(_before(lambda vx, vy, omega: np.array([vx, vy, 0.0])))),
        *like(
            BODY,
            ("omega has its sign turned", "A positive omega turns counter-clockwise: theta grows."),
            follow(_before(lambda vx, vy, omega: np.array([vx, vy, -omega]))),
        ),
        *like(
            BODY,
            ("vy is left out", "R(theta) (vx, vy) = (cos vx - sin vy, sin vx + cos vy)."),
            follow(_before(lambda vx, vy, omega: np.array([vx, 0.0, omega]))),
        ),
    ),
    library=propagate_body,
    hints=(
        "Two loops: over the pairs of the plan, and in each over the steps. Begin with poses = [start] and append.",
        "Keep the time that is left of a pair: left = duration; while left > 1e-9: h = min(dt, left); ...; left -= h.",
        "x grows by (cos(theta) vx - sin(theta) vy) h, y by (sin(theta) vx + cos(theta) vy) h, and only then theta by "
        "omega h.",
    ),
    forbidden=("course_lib.planar.propagate_body",),
)
