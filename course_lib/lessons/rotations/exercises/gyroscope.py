"""gyroscope: the orientations of a body from the log of a gyroscope that is mounted rotated."""

import itertools

import numpy as np

from course_lib.checks.comparisons import difference
from course_lib.checks.declared import declared
from course_lib.checks.exercise import Property
from course_lib.checks.kinds import FACTOR, ROTATION, Kind, leaning_axis, number, whole_numbers
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import (
    any_rotation,
    first_off,
    near,
    no_rotation,
    orthogonality_error,
    unit,
)
from course_lib.rotations import exp_so3, hat, rot_z

_NEARLY = 1e-5  # off by less than a small rotation
_ROLL = np.array([[1.0, 0, 0], [1, 0, 0]])
# rad/s: at these the error of the second order is too small to be seen in one step, and adds up.
_SLOW = (1e-2, 5.6e-3, 3.1e-3, 1.8e-3, 1e-3, 3.1e-4, 1e-4, 5e-5)


# rad/s: in a tenth of a second the slowest of these rotates the body by two thirds of a revolution.
_FAST = (42.0, -75.0, 120.0, -63.0)


def _fast_samples(rng):
    """Return samples by which the body rotates far. In each some entry of the rotation vector is
    beyond pi."""
    return np.array([[rate * entry for entry in leaning_axis(rng)] for rate in _FAST])


def _slow_samples(rng, rate):
    return np.tile(rate * unit(rng), (100, 1))


def _coarse_log(rng):
    """Return samples of rests, and of rotations about the axes, opposite ones and equal ones."""
    n = int(rng.integers(1, 6))
    return np.eye(3)[rng.integers(3, size=n)] * whole_numbers(rng, (n, 1))


LOG = Kind(
    drawn=lambda rng: rng.normal(size=(4, 3)),
    named=lambda rng: [
        _ROLL,
        2 * rng.normal(size=(1, 3)),
        np.zeros((0, 3)),
        _fast_samples(rng),
        # Rates that are whole along the sensor's axes, and not whole along the body's. With as many
        # rows as a drawn log it is asked with whole matrices, too.
        np.array([[1.0, -2, 0], [0, 1, 2], [2, 0, -1], [1, 1, 0]]),
    ],
    beside=(("a hundred slow samples", _slow_samples, _SLOW),),
    coarse=_coarse_log,
    small=True,
)


def _cases(rng):
    R_0, R_bi = any_rotation(rng), any_rotation(rng)
    return [
        (np.eye(3), _ROLL, 0.5, np.eye(3)),
        (rot_z(np.pi / 2), _ROLL, 0.5, np.eye(3)),  # the body's x axis is not the world's
        (R_0, rng.normal(size=(4, 3)), 0.4, np.eye(3)),
        (np.eye(3), _ROLL, 0.5, rot_z(np.pi / 2)),
        (R_0, rng.normal(size=(6, 3)), 0.3, R_bi),
    ]


def _flown(R_0, steps, next_one=lambda R, step: R @ exp_so3(step)):
    """Return the orientations from R_0 on by so many steps, rotation vectors about the body's own
    axes."""
    return np.array(list(itertools.accumulate(steps, next_one, initial=R_0)))


def _right(R_0, log, dt, R_bi):
    return _flown(R_0, dt * log @ R_bi.T)


def _fixed_axes(R, step):
    return exp_so3(step) @ R


def _angles_added_up(R_0, log, dt, R_bi):
    sums = itertools.accumulate(dt * log @ R_bi.T, initial=np.zeros(3))
    return np.array([R_0 @ exp_so3(w) for w in sums])


def _with_R_bi(next_one):
    """Return the answer that multiplies R_bi into each step."""
    return lambda R_0, log, dt, R_bi: _flown(
        R_0, dt * log, lambda R, step: next_one(R, exp_so3(step), R_bi)
    )


def _found(R, *case):
    right = _right(*case)
    k = int(np.argmax([not near(*pair) for pair in zip(R, right, strict=True)]))
    return f"R[{k}] is the first orientation that differs. " + first_off(R[k], right[k])


def _tell_no_rotation(R, *case):
    k = next(k for k, each in enumerate(R) if orthogonality_error(each) >= EXACT)
    return f"R[{k}] is the first orientation that is no rotation. {no_rotation(R[k])}"


def _otherwise(R, *case):
    """Return the Mistake of orientations that are nearly right; None of others."""
    if difference(R, _right(*case)) > _NEARLY:
        return None
    return Question(
        "small rotations are left out, or lose their digits",
        "The orientations are nearly right. Which lines of yours treat a small rotation, that of a "
        "sample or R_bi, otherwise than a large one, and which lose digits?",
    )


EXERCISE = declared(
    "gyroscope",
    points=3,
    arguments={
        "R_0": FACTOR,
        "log": LOG,
        "dt": number(0.1, 0.6),
        "R_bi": ROTATION.but(beside=()),
    },
    tolerance=EXACT,
    cases=_cases,
    library=_right,
    properties=(
        Property("the first orientation is R_0", lambda R, R_0, log, dt, R_bi: near(R[0], R_0)),
        Property(
            "every orientation is a rotation",
            lambda R, *case: max(map(orthogonality_error, R)) < EXACT,
            says=_tell_no_rotation,
        ),
        Property(
            "with the sensor's axes along the body's (R_bi = I), each sample rotates the body "
            "about its own axes",
            lambda R, *case: near(R, _right(*case)),
            says=_found,
            where=lambda R_0, log, dt, R_bi: np.array_equal(R_bi, np.eye(3)),
            points=1,
        ),
    ),
    says="however the sensor is mounted, each sample rotates the body about the axis, and by the "
    "angle, that the sensor has reported along its own axes",
    found=_found,
    otherwise=_otherwise,
    hints=(
        "A sample holds the coordinates of the angular velocity in the sensor's frame. What are "
        "its coordinates in the body's frame? Read the letters of R_bi.",
        "During dt the body rotates by |omega| dt about the axis omega, which is given in the "
        "body's own axes. On which side of R does such a step stand?",
        "Start with [R_0]; for each sample append the last orientation times exp_so3(R_bi @ sample "
        "* dt).",
    ),
    mistakes=(
        Mistake(
            "there is one orientation too few",
            "Is R_0 the first orientation, and does one more follow for each sample, whatever the "
            "sample is?",
            form=lambda array, R_0, log, *rest: array.shape == (len(log), 3, 3),
        ),
        Mistake(
            "the mounting is ignored",
            "The sensor's x axis need not be the body's.",
            lambda R_0, log, dt, R_bi: _right(R_0, log, dt, np.eye(3)),
        ),
        Mistake(
            "R_bi^T takes the place of R_bi",
            "From which frame to which frame does R_bi change coordinates?",
            lambda R_0, log, dt, R_bi: _right(R_0, log, dt, R_bi.T),
        ),
        Mistake(
            "each step is made about the fixed axes",
            "A gyroscope is carried along: about whose axes does it report?",
            lambda R_0, log, dt, R_bi: _flown(R_0, dt * log @ R_bi.T, _fixed_axes),
            lambda R_0, log, dt, R_bi: _flown(R_0, dt * log, _fixed_axes),
            lambda R_0, log, dt, R_bi: _flown(R_0, dt * log @ R_bi, _fixed_axes),
        ),
        Mistake(
            "the orientations are those of the sensor",
            "The task asks for the orientations of the body, which begin at R_0.",
            lambda R_0, log, dt, R_bi: _flown(R_0 @ R_bi, dt * log),
        ),
        Mistake(
            "R_bi is multiplied into the orientation with each step",
            "From which frame to which frame does R_bi change coordinates?",
            _with_R_bi(lambda R, step, R_bi: R @ step @ R_bi),
            _with_R_bi(lambda R, step, R_bi: R @ R_bi @ step),
        ),
        Mistake(
            "R [omega] dt is added to R, as at the beginning of the notebook",
            "What did the drone do then?",
            lambda R_0, log, dt, R_bi: _flown(
                R_0, dt * log @ R_bi.T, lambda R, step: R + R @ hat(step)
            ),
        ),
        Mistake(
            "the rotation vectors are added up, and the exponential of their sum is taken",
            "Rotations about different axes do not commute: is exp(a) exp(b) the same as exp(a + "
            "b)?",
            _angles_added_up,
        ),
        Mistake(
            "dt is missing",
            "By which angle does a body rotate in dt seconds?",
            lambda R_0, log, dt, R_bi: _right(R_0, log, 1.0, R_bi),
        ),
    ),
)
