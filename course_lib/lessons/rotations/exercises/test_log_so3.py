"""test_log_so3: a test that distinguishes right logarithms of rotations from wrong ones."""

import numpy as np

from course_lib.checks.mistake import Mistake
from course_lib.checks.write_test import ALWAYS_FALSE, Version, WriteTest
from course_lib.rotations import log_so3, matrix_to_quaternion


def _angle(R):
    return np.linalg.norm(log_so3(R))


def _half_turn(R):
    return _angle(R) > np.pi - 1e-9


def _nearly_half(R):
    return np.pi - 0.02 < _angle(R) and not _half_turn(R)


def _by_quaternion(R):
    q = matrix_to_quaternion(R)
    sine = np.linalg.norm(q[1:])
    return 2 * np.arctan2(sine, q[0]) / sine * q[1:] if sine > 0 else np.zeros(3)


def _closer_than(gap):
    """Return whether(R): its angle is nearer to 180 degrees than the gap, in radians."""
    return lambda R: _angle(R) > np.pi - gap


def _if(where, otherwise):
    """Right but where where(R): there otherwise(w, R) is returned."""

    def version(R):
        w = log_so3(R)
        return otherwise(w, R) if where(R) else w

    return version


def _by_column(k):
    """The version that takes column k of R + I at 180 degrees, which is 0 if the axis has no entry
    k."""

    def at_half_turns(w, R):
        column = (R + np.eye(3))[:, k]
        return np.pi * column / np.linalg.norm(column)

    return _if(_half_turn, at_half_turns)


def _longer(w):
    angle = np.linalg.norm(w)
    return w * (angle - 2 * np.pi) / angle if angle > 0 else w


_ONE_SIGN = Mistake(
    "your test accepts only one of the two signs at 180 degrees",
    "The rotations by 180 degrees about n and about -n are the same: what has to hold of an answer,"
    " whichever of the two it is?",
)
_STRICT = Mistake(
    "your test rejects an answer that is longer than pi by rounding only",
    "At 180 degrees |w| may be 3.1415926535897936, which is > np.pi. By how much may an answer be "
    "off?",
)
_EXACT_ONLY = Mistake(
    "your test rejects an answer whose error the task allows",
    "By how much may the exponential of a correct answer differ from the matrix, and by how much "
    "may the length of the answer exceed pi?",
)

EXERCISE = WriteTest(
    name="test_log_so3",
    points=3,
    arguments=("log_so3",),
    shapes=((3, 3),),
    refuses=Mistake(
        ALWAYS_FALSE.name,
        "A right version must pass. If you compare its answer with a w of your own, R being"
        " exp_so3(w): which vectors have the same exponential, beyond 180 degrees and at 180"
        " degrees, and which of them are right answers? By how much may a right answer be off?",
    ),
    versions=(
        Version("that is the library's", log_so3, right=True),
        Version("that goes by the quaternion", _by_quaternion, right=True),
        Version(
            "that takes the other axis at 180 degrees",
            _if(_half_turn, lambda w, R: -w),
            right=True,
            mistake=_ONE_SIGN,
        ),
        Version("that differs by rounding", lambda R: log_so3(R) * (1 - 1e-12), right=True),
        Version(
            "that differs by rounding",
            lambda R: log_so3(R) * (1 + 1e-12),
            right=True,
            mistake=_STRICT,
        ),
        Version(
            "that takes the other axis at 180 degrees",
            _if(_closer_than(1e-7), lambda w, R: -w),
            right=True,
            mistake=_ONE_SIGN,
        ),
        Version(
            "that is off by half of what is allowed",
            lambda R: log_so3(R) * (1 + 1.5e-7),
            right=True,
            mistake=_EXACT_ONLY,
        ),
        Version("that returns lists", lambda R: log_so3(R).tolist(), right=True),
        Version("whose sign is wrong", lambda R: -log_so3(R)),
        Version("that answers in degrees", lambda R: np.rad2deg(log_so3(R))),
        Version("that lacks a factor 1/2", lambda R: 2 * log_so3(R)),
        Version("whose length is always 1", lambda R: log_so3(R) / (_angle(R) or 1)),
        Version(
            "that returns the skew part of R", lambda R: log_so3(R) * np.sinc(_angle(R) / np.pi)
        ),
        Version("that takes the longer of the two rotations", lambda R: _longer(log_so3(R))),
        Version(
            "that is wrong only beyond 90 degrees",
            _if(lambda R: _angle(R) > np.pi / 2 + 1e-6, lambda w, R: w * (np.pi / _angle(R) - 1)),
        ),
        Version(
            "that is wrong only near 180 degrees",
            _if(_nearly_half, lambda w, R: np.pi * w / _angle(R)),
        ),
        Version(
            "that is wrong only near 180 degrees",
            _if(_closer_than(5e-4), lambda w, R: _longer(w)),
        ),
        Version("that is wrong only at 180 degrees", _if(_half_turn, lambda w, R: np.zeros(3))),
        Version("that loses signs at 180 degrees", _if(_half_turn, lambda w, R: np.abs(w))),
        Version("that is wrong only at 180 degrees about some axes", _by_column(0)),
        Version("that is wrong only at 180 degrees about some axes", _by_column(2)),
        Version(
            "that is wrong only at the identity",
            _if(lambda R: _angle(R) == 0, lambda w, R: np.full(3, np.nan)),
        ),
        Version(
            "that is wrong only for small angles",
            _if(lambda R: _angle(R) < 0.01, lambda w, R: np.zeros(3)),
        ),
        Version(
            "that is wrong only for small angles",
            _if(lambda R: _angle(R) < 1e-4, lambda w, R: np.zeros(3)),
        ),
    ),
    hints=(
        (
            "You need no right logarithm to compare with: the exponential of the answer has to be R"
            " again."
        ),
        (
            "Which rotations are special? Try the identity, small angles, angles beyond 90 degrees,"
            " 180 degrees and a little less, about axes of every sign and the coordinate axes. The"
            " exponential cannot see whether the shortest vector is returned: its length can."
        ),
        (
            "Make rotations as exp_so3(w) of vectors w of your own; two conditions hold for each "
            "answer. np.allclose "
            "compares arrays, np.asarray turns a list into one."
        ),
    ),
)
