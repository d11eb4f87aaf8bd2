"""gyroscope: the orientations of a body from the log of a gyroscope that is mounted rotated."""

import itertools

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import any_rotation, near, orthogonality_error
from course_lib.rotations import exp_so3, hat, rot_z


def _flown(R_0, steps, next_one=lambda R, step: R @ exp_so3(step)):
    """The orientations from R_0 on by so many steps, rotation vectors about the body's own axes."""
    return np.array(list(itertools.accumulate(steps, next_one, initial=R_0)))


def _right(R_0, log, dt, R_bi):
    return _flown(R_0, dt * log @ R_bi.T)


def _cases(rng):
    roll, R_0, R_bi = np.array([[1.0, 0, 0], [1, 0, 0]]), any_rotation(rng), any_rotation(rng)
    straight = [(np.eye(3), roll, 0.5, np.eye(3)), (R_0, rng.normal(size=(4, 3)), 0.4, np.eye(3))]
    mounted = [(np.eye(3), roll, 0.5, rot_z(np.pi / 2)), (R_0, rng.normal(size=(6, 3)), 0.3, R_bi)]
    return [
        *straight,
        *mounted,
        (R_bi, 2 * rng.normal(size=(1, 3)), 0.2, R_0),
        (R_0, np.zeros((0, 3)), 0.1, R_bi),
        # Rates that are whole along the sensor's axes, and not whole along the body's.
        (R_0, np.array([[1, -2, 0], [0, 1, 2]]), 0.3, R_bi),
    ]


def _is_straight(R_0, log, dt, R_bi):
    return np.array_equal(R_bi, np.eye(3))


_ONE_TOO_FEW = Mistake(
    "R_0, or the last orientation, is missing",
    "Is R_0 the first orientation, and does one more follow for each sample?",
)


EXERCISE = Exercise(
    name="gyroscope",
    points=3,
    arguments=("R_0", "log", "dt", "R_bi"),
    tolerance=EXACT,
    cases=_cases,
    small=("R_0", "log", "R_bi"),
    returns=numbers(lambda R_0, log, dt, R_bi: (len(log) + 1, 3, 3)),
    library=_right,
    properties=(
        Property("the first orientation is R_0", lambda R, R_0, log, dt, R_bi: near(R[0], R_0)),
        Property(
            "every orientation is a rotation",
            lambda R, *case: max(map(orthogonality_error, R)) < EXACT,
            says=lambda R, *case: (
                f"The largest entry of R^T R - I is {max(map(orthogonality_error, R)):.2g}."
            ),
        ),
        Property(
            "with the sensor's axes along the body's (R_bi = I), each sample rotates the body "
            "about its own axes",
            lambda R, *case: near(R, _right(*case)),
            where=_is_straight,
            points=1,
        ),
        Property(
            "with the sensor mounted rotated, too, each sample rotates the body about an axis of "
            "its own",
            lambda R, *case: near(R, _right(*case)),
            where=lambda *case: not _is_straight(*case),
        ),
    ),
    hints=(
        "A sample holds the coordinates of the angular velocity in the sensor's frame. What are "
        "its coordinates in the "
        "body's frame? Read the letters of R_bi.",
        "During dt the body rotates by |omega| dt about the axis omega, which is given in the "
        "body's own axes. On "
        "which side of R does such a step stand?",
        "Start with [R_0]; for each sample append the last orientation times exp_so3(R_bi @ sample "
        "* dt).",
    ),
)

EXERCISE.mistake(_ONE_TOO_FEW, form=lambda array, R_0, log, *rest: array.shape == (len(log), 3, 3))


@EXERCISE.mistake(
    "the mounting is ignored",
    "The sensor's x axis need not be the body's.",
)
def mounting_ignored(R_0, log, dt, R_bi):
    return _right(R_0, log, dt, np.eye(3))


@EXERCISE.mistake(
    "each step is made about the fixed axes",
    "A gyroscope is carried along: about whose axes does it report?",
    mounted=(True, False),
)
def taken_for_spatial(R_0, log, dt, R_bi, mounted):
    return _flown(R_0, dt * (log @ R_bi.T if mounted else log), lambda R, step: exp_so3(step) @ R)


@EXERCISE.mistake(
    "the orientations are those of the sensor",
    "The task asks for the orientations of the body, which begin at R_0.",
)
def of_the_sensor(R_0, log, dt, R_bi):
    return _flown(R_0 @ R_bi, dt * log)


@EXERCISE.mistake(
    "R_bi is multiplied into the orientation with each step",
    "From which frame to which frame does R_bi change coordinates?",
    next_one=(
        lambda R, step, R_bi: R @ exp_so3(step) @ R_bi,
        lambda R, step, R_bi: R @ R_bi @ exp_so3(step),
    ),
)
def mounting_in_each_step(R_0, log, dt, R_bi, next_one):
    return _flown(R_0, dt * log, lambda R, step: next_one(R, step, R_bi))


@EXERCISE.mistake(
    "R [omega] dt is added to R, as at the beginning of the notebook",
    "What did the drone do then?",
)
def added(R_0, log, dt, R_bi):
    return _flown(R_0, dt * log @ R_bi.T, lambda R, step: R + R @ hat(step))


@EXERCISE.mistake(
    "the rotation vectors are added up, and the exponential of their sum is taken",
    "Rotations about different axes do not commute: is exp(a) exp(b) the same as exp(a + b)?",
)
def angles_added_up(R_0, log, dt, R_bi):
    sums = itertools.accumulate(dt * log @ R_bi.T, initial=np.zeros(3))
    return np.array([R_0 @ exp_so3(w) for w in sums])


@EXERCISE.mistake(
    "dt is missing",
    "By which angle does a body rotate in dt seconds?",
)
def time_step_missing(R_0, log, dt, R_bi):
    return _right(R_0, log, 1.0, R_bi)
