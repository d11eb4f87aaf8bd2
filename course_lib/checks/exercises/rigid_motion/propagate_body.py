"""propagate_body: a plan of body velocities, followed by Euler's method."""

import numpy as np

from course_lib.checks.answer_types import rows
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.rigid_motion.shared import (
    BODY,
    FINE,
    MATRICES,
    STEP_LENGTHS,
    follow,
    form,
    lengths,
    rotated,
    same_rows,
    size_of,
    steps,
)
from course_lib.checks.exercises.rigid_motion.shared_mistakes import step_mistakes
from course_lib.planar import propagate_body, propagate_body_exact

ORIGIN = (0.0, 0.0, 0.0)
AHEAD, LEFT, SPIN = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


def _matrices(array, *case):
    return MATRICES if array.ndim == 3 and array.shape[1:] == (3, 3) else None


def read_poses(value, *case):
    """Return an answer as rows (x, y, theta), of any number."""
    return rows(3, "poses, an array of shape (n, 3)", most=2000, known=_matrices)(value, *case)


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
    velocities = [tuple(np.round(_signed(rng, 0.5, 2, lengths + angles), 2).tolist()) for _ in range(3)]
    return start, list(zip(velocities, drawn_durations(dt, rng), strict=True)), dt


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
    rounding = ((0.3, 0.1), (0.9, 0.3), (1.0, 0.1), (1.1, 0.1), (2.1, 0.3))  # a hair above or below a multiple
    sums = [(origin, [(AHEAD, duration)], dt) for duration, dt in rounding]
    several = [
        (origin, [(AHEAD, 0.25), (LEFT, 0.1)], 0.1),
        (origin, [(SPIN, 0.25), (AHEAD, 0.25)], 0.1),
        ([-1.0, 2.0, 3.0], [(AHEAD, 0.5), ((1.0, 0.0, 2.0), 0.6), ((1.0, 0.0, -1.0), 0.45)], 0.25),
    ]
    return [*simple, *sums, *several, *(drawn_case(rng) for _ in range(4))]


def _theta_errors(poses, start, plan, dt):
    velocities, h = steps(plan, dt)
    return size_of(np.diff(poses[:, 2]) - velocities[:, 2] * h, True)


def _translation_errors(poses, start, plan, dt):
    velocities, h = steps(plan, dt)
    wanted = rotated(poses[:-1, 2], velocities[:, :2]) * h[:, None]
    return np.abs(np.diff(poses[:, :2], axis=0) - wanted).max(axis=1)


def _wrong_theta(poses, *case):
    k = int(np.argmax(_theta_errors(poses, *case) > FINE))
    velocities, h = steps(*case[1:])
    return (
        f"In step {k + 1} omega is {velocities[k, 2]:.4g} and the step {h[k]:.4g} s long, so theta goes from "
        f"{poses[k, 2]:.4g} to {poses[k, 2] + velocities[k, 2] * h[k]:.4g}. Yours goes to {poses[k + 1, 2]:.4g}."
    )


def _wrong_translation(poses, *case):
    k = int(np.argmax(_translation_errors(poses, *case) > FINE))
    velocities, h = steps(*case[1:])
    wanted = rotated(poses[k, 2], velocities[k, :2]) * h[k]
    return (
        f"Step {k + 1} begins with theta = {poses[k, 2]:.4g}, so the translation is {format_tuple(wanted)}. "
        f"Yours is {format_tuple(poses[k + 1, :2] - poses[k, :2])}."
    )


THETA = Property(
    "theta grows by omega times the length of the step",
    lambda poses, *case: _theta_errors(poses, *case).max() < FINE,
    says=_wrong_theta,
)


def move_by(direction, theta_after=lambda theta, omega, h: theta + omega * h):
    """Return a move(pose, velocity, h) along R(direction(theta, omega, h)) (vx, vy)."""

    def move(pose, velocity, h):
        theta, omega = pose[2], velocity[2]
        translation = rotated(direction(theta, omega, h), velocity[:2]) * h
        return np.array([*(pose[:2] + translation), theta_after(theta, omega, h)])

    return move


euler = move_by(lambda theta, omega, h: theta)


def _before(change):
    """Euler's method with the velocity changed beforehand."""
    return lambda pose, velocity, h: euler(pose, change(*velocity), h)


def assigned(move):
    """Return the answers of the printed rule: theta is omega times the time in the pair, and is not added."""

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
    return np.array(
        [poses[0], *np.column_stack([rotated(poses[:-1, 2], velocities[:, :2]) * h[:, None], poses[1:, 2]])]
    )


def _theta_kept(start, plan, dt, from_start=False):
    """The angle at the beginning of each pair, or of the plan, for all its steps."""
    poses = [np.array(start, float)]
    for velocity, duration in plan:
        theta = start[2] if from_start else poses[-1][2]
        for h in lengths(duration, dt):
            pose = euler([*poses[-1][:2], theta], np.array(velocity, float), h)
            poses.append(np.array([*pose[:2], poses[-1][2] + velocity[2] * h]))
    return np.array(poses)


def _with_matrix(matrix):
    """Euler's method with matrix(c, s) for R(theta)."""

    def move(pose, velocity, h):
        R = np.array(matrix(np.cos(pose[2]), np.sin(pose[2])))
        return pose + np.append(R @ velocity[:2], velocity[2]) * h

    return follow(move)


_WRONG_MATRICES = (
    lambda c, s: [[c, s], [s, c]],
    lambda c, s: [[c, -s], [-s, c]],
    lambda c, s: [[c, -s], [s, -c]],
    lambda c, s: [[s, -c], [c, s]],
    lambda c, s: [[s, c], [c, -s]],
)


def _mixed(x_after, y_after):
    """Euler's method with theta at the end of the step in x, or in y."""

    def move(pose, velocity, h):
        ends = [rotated(pose[2] + after * velocity[2] * h, velocity[:2]) for after in (x_after, y_after)]
        return pose + np.array([ends[0][0], ends[1][1], velocity[2]]) * h

    return follow(move)


def _x_and_y_swapped(start, plan, dt):
    return propagate_body(start, plan, dt)[:, [1, 0, 2]]


ADDED = (
    "theta is assigned where it should be added, as in the printed rule theta = omega t",
    "The body had an angle before the step: theta = theta + omega * h.",
)
WORLD = (
    "the velocities are taken along the axes of the world",
    "(vx, vy) is ahead and to the left of the body. Multiply it by R(theta) first.",
)
TRANSPOSED = (
    "R is transposed: the velocity is rotated in the opposite direction",
    "R(theta) = [[cos, -sin], [sin, cos]]: a body that faces up drives up, y grows.",
)
SIDEWAYS = ("vx and vy are swapped", "vx is ahead, along the body's x axis, and vy to its left.")
DEGREES = ("degrees and radians are mixed up", "Angles are radians everywhere: no np.deg2rad, no np.rad2deg.")
NO_ROTATION = ("theta stays as it is", "A step has three parts: x, y and theta, which grows by omega * h.")

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
            "the translation in each step is R(theta) (vx, vy) h, with theta at its beginning",
            lambda poses, *case: _translation_errors(poses, *case).max() < FINE,
            says=_wrong_translation,
        ),
    ),
    mistakes=(
        *step_mistakes(BODY, propagate_body, euler),
        Mistake(*ADDED, *assigned(euler), _all_assigned, follow(move_by(lambda a, w, h: a, lambda a, w, h: w * h))),
        Mistake(*WORLD, follow(move_by(lambda theta, omega, h: 0 * theta))),
        Mistake(*TRANSPOSED, follow(move_by(lambda theta, omega, h: -theta))),
        Mistake(
            "theta at the end of the step is used, not at its beginning",
            "First move x and y with the old theta; then change theta.",
            follow(move_by(lambda theta, omega, h: theta + omega * h)),
        ),
        Mistake(
            "theta in the middle of the step is used",
            "That is more accurate than Euler's method, but not what is asked.",
            follow(move_by(lambda theta, omega, h: theta + omega * h / 2)),
        ),
        Mistake(
            "each step follows the exact arc",
            "That is propagate_body_exact, which comes next. Euler's method goes straight in each step.",
            propagate_body_exact,
        ),
        Mistake(
            "R is not computed anew in each step",
            "theta changes with each step, and R(theta) with it: compute it inside the inner loop.",
            _theta_kept,
            lambda *case: _theta_kept(*case, from_start=True),
        ),
        Mistake(*SIDEWAYS, follow(_before(lambda vx, vy, omega: np.array([vy, vx, omega])))),
        Mistake("x and y are swapped", "A row is (x, y, theta).", _x_and_y_swapped),
        Mistake(
            "the velocities are not multiplied by the length of the step",
            "m/s times s is m: R(theta) (vx, vy) * h, and omega * h.",
            follow(lambda pose, velocity, h: euler(pose, velocity, 1.0)),
            follow(move_by(lambda theta, omega, h: theta, lambda theta, omega, h: theta + omega)),
            follow(lambda pose, velocity, h: np.append(euler(pose, velocity, 1.0)[:2], pose[2] + velocity[2] * h)),
        ),
        Mistake(
            *DEGREES,
            follow(move_by(lambda theta, omega, h: np.deg2rad(theta))),
            follow(move_by(lambda theta, omega, h: np.rad2deg(theta))),
            follow(_before(lambda vx, vy, omega: np.array([vx, vy, np.deg2rad(omega)]))),
            follow(_before(lambda vx, vy, omega: np.array([vx, vy, np.rad2deg(omega)]))),
        ),
        Mistake(*NO_ROTATION, follow(_before(lambda vx, vy, omega: np.array([vx, vy, 0.0])))),
        Mistake(
            "omega has the opposite sign",
            "With a positive omega, theta grows: counter-clockwise.",
            follow(_before(lambda vx, vy, omega: np.array([vx, vy, -omega]))),
        ),
        Mistake(
            "a sine or cosine of R(theta) has a wrong sign, or is in the wrong entry",
            "R(theta) = [[cos, -sin], [sin, cos]]: x grows by (cos vx - sin vy) h, y by (sin vx + cos vy) h.",
            *map(_with_matrix, _WRONG_MATRICES),
        ),
        Mistake(
            "theta changes between x and y: y moves with the new theta",
            "Both x and y move with the old theta; theta changes last.",
            _mixed(0, 1),
            _mixed(1, 0),
        ),
        Mistake(
            "the velocities are read as (omega, vx, vy)",
            "A plan holds (vx, vy, omega).",
            follow(_before(lambda omega, vx, vy: np.array([vx, vy, omega]))),
        ),
        Mistake(
            "vy is ignored",
            "R(theta) (vx, vy) = (cos vx - sin vy, sin vx + cos vy).",
            follow(_before(lambda vx, vy, omega: np.array([vx, 0.0, omega]))),
        ),
    ),
    library=propagate_body,
    hints=(
        "Two loops: over the pairs of the plan, and in each over the steps. Begin with poses = [start] and append.",
        "The steps of a pair are those of step_lengths(duration, dt): for h in step_lengths(duration, dt).",
        "x grows by (cos(theta) vx - sin(theta) vy) h, y by (sin(theta) vx + cos(theta) vy) h, and only then theta by "
        "omega h.",
    ),
    alike=same_rows(BODY),
    forbidden=("course_lib.planar.propagate_body",),
)
