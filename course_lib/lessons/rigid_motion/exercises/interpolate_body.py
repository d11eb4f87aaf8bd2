"""interpolate_body: from pose to pose, each coordinate separately."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.kinds import OWN_CASES, eighths, whole_numbers
from course_lib.checks.mistake import Mistake
from course_lib.checks.special_cases import ON_BOTH_SIDES, SMALL, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import away_from_zero
from course_lib.lessons.rigid_motion.exercises import shared
from course_lib.lessons.rigid_motion.exercises.shared import change as right_change
from course_lib.planar import interpolate_body, wrap_angle


def between(rng, first, last, n):
    """Return a case with these directions, and positions drawn."""
    positions = np.round(rng.choice([-1, 1], (2, 2)) * rng.uniform(1, 9, (2, 2)), 2)
    return np.array([*positions[0], first]), np.array([*positions[1], last]), n


def plain_cases(rng):
    """Return simple cases, and some in which the angle does not pass pi."""
    named = [
        ([0, 0, 0], [4, 2, 1], 3),
        (np.zeros(3), np.array([4.0, 2.0, 1.0]), 5),
        (np.array([1.0, 2.0, 0.5]), np.array([1.0, 2.0, 0.5]), 4),
        (np.array([1.0, 2.0, -0.4]), np.array([-3.0, 1.0, -0.4]), 5),
        (np.array([1.0, 2.0, -0.4]), np.array([1.0, 2.0, 1.1]), 6),
        (np.array([1.0, -1.0, 0.3]), np.array([2.0, 3.0, 2.0]), 2),
    ]
    angles = np.round(rng.uniform(0.4, 2.8, 2) * [1, -1], 2)
    return named + [
        between(rng, 0.1, 0.1 + angle, n) for angle, n in zip(angles, (7, 5), strict=True)
    ]


def rotating_cases(rng):
    """Return cases past pi, over several revolutions, by nearly and by exactly half of one; and
    whole numbers."""
    named = [
        (np.array([0.0, 0.0, 3.0]), np.array([4.0, 2.0, -3.0]), 5),
        (np.array([-7.0, -5.0, -2.6]), np.array([6.0, 5.0, 2.2]), 6),
    ]
    beyond = np.round(rng.uniform(1.7, 3.0, 4) * [1, -1, -1, 1], 2)
    directions = [
        *beyond.reshape(2, 2),
        (0.3, 1.2 + 2 * shared.REVOLUTION),
        (-0.5, -1.8 - 3 * shared.REVOLUTION),
        (0.3, 1.2 + 16 * shared.REVOLUTION),
    ]
    directions += [
        (4.0, 5.2 - shared.REVOLUTION),
        (4.0, 5.0),
        (9.4, 8.5),
        (0.2, 3.341),
        (0.2, 3.342),
    ]
    directions += [(0.0, np.pi), (np.pi / 2, -np.pi / 2), (0.7, 0.7 + np.pi)]
    drawn = [between(rng, *pair, 5) for pair in directions]
    return [*named, *drawn, ([2, -1, 3], [-2, 1, -3], 5), between(rng, 2.0, -2.0, 21)]


def special(rng):
    """Return a case of poses in whole numbers whose directions are some eighths of a revolution."""
    start, goal = (np.append(whole_numbers(rng, 2), eighths(rng)) for _ in range(2))
    return start, goal, int(rng.integers(2, 6))


def _rotating_by(angle):
    """Two poses whose directions differ by nearly this angle, on opposite sides of the origin: so
    no two poses with as large coordinates are farther apart."""

    def case(rng, gap):
        first = round(rng.uniform(-1, 1), 2)
        start, goal, n = between(rng, first, first + angle + gap, 5)
        goal[:2] = -start[:2]
        return start, goal, n

    return Sweep(f"a rotation by nearly {angle:.4g}", case, ON_BOTH_SIDES)


def _nearly_there(rng, gap):
    """Return two positions far from the origin whose difference is small, but not to rounding."""
    far = np.array([100.0, -80.0, 0.5])
    return far, far + gap * np.append(away_from_zero(rng, 2), 0), 4


def _of_a_number(rng, n):
    return between(rng, *rng.uniform(-1, 1, 2).round(2), n)


SWEEPS = (
    # A sum of n - 1 steps of 1 / (n - 1) is rounded to more than 1 for some n.
    Sweep("the number of poses", _of_a_number, tuple(range(2, 60))),
    *(_rotating_by(angle) for angle in (0.0, np.pi, -2 * np.pi)),
    Sweep("nearly the same position, far from the origin", _nearly_there, SMALL),
)


def _path(start, goal, n, s=None, change=None):
    change = right_change(start, goal) if change is None else change
    return shared.straight(start, change, shared.scaling(n) if s is None else s)


def _with_angle(difference):
    """Return the answer with difference(first angle, last angle) as the change of theta."""

    def answer(start, goal, n):
        angle = difference(start[2], goal[2])
        return _path(start, goal, n, change=[*right_change(start, goal)[:2], angle])

    return answer


def _wrapped_once(a, b):
    apart = b - a
    return apart - shared.REVOLUTION * (apart > np.pi) + shared.REVOLUTION * (apart < -np.pi)


def _lengths_wrapped(start, goal, n):
    return _path(start, goal, n, change=wrap_angle(np.subtract(goal, start)))


def _whole_change(start, goal, n):
    if not all(np.asarray(pose).dtype.kind == "i" for pose in (start, goal)):
        return None
    return _path(start, goal, n, change=np.trunc(right_change(start, goal)))


EXERCISE = declared(
    "interpolate_body",
    points=2,
    sets=2,
    arguments={
        "start": OWN_CASES.but(small=True, free=True),
        "goal": OWN_CASES.but(small=True, free=True),
        "n": OWN_CASES.but(free=True),
    },
    cases=lambda rng: plain_cases(rng) + rotating_cases(rng),
    sweeps=SWEEPS,
    special=special,
    tolerance=EXACT,
    allowed=lambda start, goal, n: EXACT * shared.size(start, goal),
    library=interpolate_body,
    alike=shared.same_path,
    distance=shared.distance_of_paths,
    says="at evenly spaced u from 0 to 1, the part s = 3 u^2 - 2 u^3 of the change is made, theta "
    "along the shorter arc",
    found=shared.first_wrong_row(interpolate_body),
    otherwise=shared.longer_arc,
    hints=(
        "u = np.linspace(0, 1, n) has n evenly spaced times; s = 3 u^2 - 2 u^3 is the part of the "
        "change that is made.",
        "The change is goal - start, of arrays (np.array(start, float)); its third entry, that of "
        "theta, is wrapped.",
        "start + s[:, None] * change is an array (n, 3): each s multiplies the whole change.",
    ),
    forbidden=("course_lib.planar.interpolate_body", "course_lib.planar.interpolate_arm"),
    mistakes=(
        shared.MATRICES,
        *shared.path_mistakes(_path),
        Mistake(
            "the difference of theta is not wrapped to [-pi, pi], so the body takes the longer arc",
            "Print the difference of the two angles just before it is multiplied by s: between "
            "which bounds should it lie?",
            _with_angle(lambda a, b: b - a),
            _with_angle(lambda a, b: (b - a) % shared.REVOLUTION),
            _with_angle(lambda a, b: wrap_angle(b) - wrap_angle(a)),
            _with_angle(_wrapped_once),
        ),
        Mistake(
            "x and y are wrapped as if they were angles",
            "Which of the three numbers repeats after 2 pi?",
            _lengths_wrapped,
        ),
        Mistake(
            "the wrapped difference is cut off to a whole number",
            "np.array([2, -1, 3]) holds integers, and so does a difference of two such arrays. "
            "Which line of your code makes an array, and what does that array hold?",
            _whole_change,
        ),
    ),
)
