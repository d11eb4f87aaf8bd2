"""test_ik_2r: write the test. Candidates are right and wrong versions of ik_2r."""

import itertools

import numpy as np

from course_lib.checks.mistake import Mistake
from course_lib.checks.tolerances import EXACT, SIX_DIGITS
from course_lib.checks.vocabulary import two_link_angles
from course_lib.checks.write_test import ALWAYS_FALSE, Version, WriteTest

_REACH = 2 + EXACT
_EITHER = 2 + SIX_DIGITS  # metres: from the edge up to here, the task accepts either answer


def closed_form(xy):
    """Return both solutions (2, 2) for a position (2,), nan out of reach."""
    return two_link_angles(xy) if np.linalg.norm(xy) < _REACH else np.full((2, 2), np.nan)


def _changed(change):
    return lambda xy: change(closed_form(xy), xy)


def _by_circles(xy):
    """Return the same from the two points where circles around the base and the tip meet: the
    elbows."""
    r = np.linalg.norm(xy)
    if not 0 < r < _REACH:
        return closed_form(xy)
    side = np.sqrt(max(1 - r**2 / 4, 0)) * np.array([xy[1], -xy[0]]) / r
    found = []
    for elbow in (xy / 2 + side, xy / 2 - side):
        first = np.arctan2(elbow[1], elbow[0])
        second = np.arctan2(*(xy - elbow)[::-1])
        found.append([first, np.angle(np.exp(1j * (second - first)))])
    return np.array(found)


def _with_q1(q1):
    return _changed(lambda q, xy: np.column_stack([q1(q, xy), q[:, 1]]))


def _wrong_in_quadrant(signs):
    """Return the Version whose q1 points backward where x and y have these signs."""
    wrong = _with_q1(lambda q, xy: q[:, 0] - np.pi * np.array_equal(np.sign(xy), signs))
    x, y = ("> 0" if sign > 0 else "< 0" for sign in signs)
    return Version(f"that is wrong only for x {x} and y {y}", wrong)


def _answering_up_to(distance):
    """Return the version that takes every position up to this distance from the base as reached."""
    return lambda xy: two_link_angles(xy) if np.linalg.norm(xy) <= distance else closed_form(xy)


def _answering_beyond_on_a_side(axis, sign):
    """Return the Version that answers beyond 2 m where this coordinate has this sign."""
    side = f"{'xy'[axis]} {'>' if sign > 0 else '<'} 0"
    return Version(
        f"that answers beyond 2 m for {side}",
        lambda xy: two_link_angles(xy) if sign * xy[axis] > 0 else closed_form(xy),
    )


def _is_off_the_axes(xy):
    return np.abs(xy).min() > EXACT


def _right(kind, ik, example=False):
    return Version(kind, ik, right=True, example=example)


_ELBOWS = "that gives one elbow twice"
_SIGN = "with a wrong sign"

EXERCISE = WriteTest(
    name="test_ik_2r",
    points=2,
    arguments=("ik_2r",),
    hints=(
        "You need no right version to compare with: fk_2r says where a solution leads.",
        "Look at both rows: each leads to xy, q2 >= 0 stands first, and q2 <= 0 second. Try "
        "positions in all "
        "four quadrants.",
        "Three kinds of position are left: farther away than 2 m, where all is nan; at 2 m "
        "in any direction, where nothing is "
        "nan; and slightly nearer than 2 m, where both rows lead to xy.",
    ),
    shapes=((2,),),
    refuses=Mistake(
        ALWAYS_FALSE.name,
        "A right version must pass. Its answer is NaN beyond 2 m: what do your comparisons give "
        "for NaN? By how much may a right answer be off? Does your test ask only where the task "
        "says which answer is right?",
    ),
    versions=(
        _right("that is as in the text", closed_form, example=True),
        _right("whose q1 may differ by a full revolution", _by_circles),
        _right("that still answers up to a micrometre beyond 2 m", _answering_up_to(_EITHER)),
        _right(
            "whose q1 at the base is 0.7",
            _with_q1(lambda q, xy: q[:, 0] if xy.any() else [0.7, 0.7]),
        ),
        _right("whose last digits differ", _changed(lambda q, xy: q * (1 + 1e-13))),
        _right("that returns a list", _changed(lambda q, xy: q.tolist())),
        Version("that always returns zeros", lambda xy: np.zeros((2, 2)), example=True),
        Version("with its rows in the other order", _changed(lambda q, xy: q[::-1])),
        Version(_ELBOWS, _changed(lambda q, xy: q[[0, 0]])),
        Version(_ELBOWS, _changed(lambda q, xy: q[[1, 1]])),
        Version(_SIGN, _changed(lambda q, xy: q * [1, -1])),
        Version(_SIGN, _changed(lambda q, xy: q * [-1, 1])),
        Version("with one q1 for both rows", _with_q1(lambda q, xy: q[[0, 0], 0])),
        Version("that leaves q2 out of q1", _with_q1(lambda q, xy: [np.arctan2(xy[1], xy[0])] * 2)),
        *(_wrong_in_quadrant(signs) for signs in itertools.product((1, -1), repeat=2)),
        Version("in degrees", _changed(lambda q, xy: np.rad2deg(q))),
        Version("that is right to four digits only", _changed(lambda q, xy: np.round(q, 4))),
        Version("that answers beyond 2 m", two_link_angles),
        Version(
            "that answers beyond 2 m with NaN for q1 alone",
            lambda xy: (
                closed_form(xy)
                if np.linalg.norm(xy) < _REACH
                else two_link_angles(xy) * [np.nan, 1]
            ),
        ),
        Version("that answers up to 5 cm beyond 2 m", _answering_up_to(2.05)),
        *(_answering_beyond_on_a_side(*side) for side in ((0, -1), (1, 1), (1, -1))),
        Version(
            "whose tip is off by four millionths of the distance",
            lambda xy: closed_form(xy / (1 + 4e-6) if np.linalg.norm(xy) < _REACH else xy),
        ),
        Version(
            "that has no answer at 2 m, except on the axes",
            _changed(
                lambda q, xy: (
                    q * np.nan if np.linalg.norm(xy) > 2 - 1e-12 and _is_off_the_axes(xy) else q
                )
            ),
        ),
        Version(
            "that is wrong only within 1 m of the base",
            _changed(lambda q, xy: q[::-1] if np.linalg.norm(xy) < 1 else q),
        ),
        Version(
            "that is wrong only in the last two centimetres before 2 m",
            _changed(lambda q, xy: q if np.linalg.norm(xy) < 1.98 else q * [1, 0]),
        ),
    ),
)
