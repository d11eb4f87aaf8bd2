"""ik_2r: both pairs of joint angles that bring the tip of a planar arm with two links of one metre to a position."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercises.decomposition_ik.ik_2r_mistakes import (
    at_edge,
    by_arctan,
    corrected,
    correction,
    cosine_is,
    in_order,
    inside,
    off,
    outside,
    q1_is,
    right_after,
    right_bend,
    same_q1,
    supplement,
    towards,
    with_q1,
    with_q2,
    wrapped,
)
from course_lib.checks.exercises.decomposition_ik.shared import position, solutions
from course_lib.checks.exercise import Exercise, Mistake, Property, Unreadable
from course_lib.checks.format_numbers import format_tuple

_FINE, _ROUGH = 1e-9, 1e-7  # metres: inside, and near the edge, where a rounding of r moves q2 by its root

_ONLY_ONE = Mistake(
    "only one solution is returned",
    "The elbow can be on either side: q2 = arccos(...) and q2 = -arccos(...), each with its own q1.",
)
_NO_ROWS = Mistake(
    "a position out of reach is given another form",
    "Return two rows of NaN there, np.full((2, 2), np.nan), so that every answer has the shape (2, 2).",
)
_RAISED = Mistake(
    "an error is raised for a position out of reach",
    "Return two rows of NaN there, np.full((2, 2), np.nan): a table of queries goes on with the next one.",
)
_DIVIDED = Mistake(
    "y is divided by x, which may be 0",
    "np.arctan2(y, x) needs no quotient, and looks at both signs.",
)
_NO_COSINE = Mistake(
    "arccos gets a number outside [-1, 1]: out of reach, or by rounding at the edge",
    "Ask first whether r > 2 + 1e-9, and return NaN there; else clip the number to [-1, 1].",
)

_pairs = numbers(lambda xy: (2, 2), dict.fromkeys(((2,), (1, 2), (2, 1)), _ONLY_ONE), gaps=True)


def _read(value, xy):
    """Return the answer as an array (2, 2), with NaN in it where the answer says so."""
    try:
        return _pairs(value, xy)
    except Unreadable as wrong:
        if outside(xy):
            raise Unreadable(str(wrong), _NO_ROWS) from None
        raise


def _cases(rng):
    named = [[1.0, 1.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.2], [1.6, 0.0]]
    angles = np.array([0.3, 1.2, 2.0, 2.8, 3.5, 4.4, 5.0, 6.0]) + rng.uniform(-0.2, 0.2, 8)
    sizes = np.concatenate([rng.uniform(0.2, 1.3, 4), rng.uniform(1.5, 1.95, 4)])[[0, 4, 1, 5, 6, 2, 7, 3]]
    within = [np.round(r * _direction(a), 3) for r, a in zip(sizes, angles, strict=True)]
    beyond = np.nextafter(2, 3)
    edge = [[2.0, 0], [0, -2.0], [beyond, 0], [0, beyond], [-beyond, 0], [1.9999, 0.0]]
    edge += [2 * _direction(a) for a in rng.uniform(-3, 3, 6)]
    far = [[3.0, 0], [0, -2.5], [1.6, 1.6], [-2.001, 0]]
    far += [r * _direction(a) for r, a in rng.uniform(2.1, 6, (3, 2))]
    return [(np.array(xy),) for xy in [*named, *within, [0.0, 0.0], [0.01, -0.02], *edge, *far]]


def _direction(angle):
    return np.array([np.cos(angle), np.sin(angle)])


def _reaches(within):
    return lambda q, xy: (off(q, xy) < within).all()


def _tell_end(q, xy):
    if np.isnan(q).any():
        return f"This position is {np.linalg.norm(xy):.6g} m from the base. Your answer holds NaN."
    row = int(np.argmax(off(q, xy)))
    return f"With your {('first', 'second')[row]} row the tip is at {format_tuple(np.round(position(q[row]), 6))}."


def _tell_bend(q, xy):
    first, second = wrapped(q[:, 1])
    return f"Your q2 are {first:.4g} and {second:.4g}, up to multiples of 2 pi."


def ik_2r(xy):
    """Return both solutions (..., 2, 2) for positions (..., 2), q2 >= 0 first; NaN out of reach."""
    xy = np.asarray(xy, float)
    in_reach = np.linalg.norm(xy, axis=-1) <= 2 + 1e-12
    return np.where(in_reach[..., None, None], solutions(xy), np.nan)


EXERCISE = Exercise(
    name="ik_2r",
    points=2,
    arguments=("xy",),
    cases=_cases,
    returns=_read,
    properties=(
        Property(
            "each row brings the tip to xy: cos q1 + cos(q1 + q2) = x, sin q1 + sin(q1 + q2) = y",
            _reaches(_FINE),
            _tell_end,
            where=inside,
        ),
        Property(
            "the first row has q2 >= 0, the second q2 <= 0",
            in_order,
            _tell_bend,
            where=inside,
        ),
        Property(
            "the tip reaches xy at the edge of the workspace too, stretched, where both rows are the same",
            lambda q, xy: _reaches(_ROUGH)(q, xy) and in_order(q, xy),
            _tell_end,
            where=at_edge,
        ),
        Property(
            "a position out of reach, farther than 2 m from the base, has two rows of NaN",
            lambda q, xy: np.isnan(q).all(),
            lambda q, xy: f"This position is {np.linalg.norm(xy):.6g} m from the base.",
            where=outside,
            mistake=Mistake(
                "a position out of reach is answered nevertheless: clipping hides that there is no solution",
                "Ask for the distance first: where it is beyond 2 by more than rounding, return two rows of NaN.",
            ),
        ),
    ),
    mistakes=(
        Mistake(
            "positions at the edge of the workspace count as out of reach: by rounding, r exceeds 2 by 4e-16",
            "Let only r > 2 + 1e-9 be out of reach, and np.clip the number to [-1, 1] before arccos.",
            seen=lambda q, xy: at_edge(xy) and np.isnan(q).any(),
        ),
        Mistake(
            "only one solution is returned, twice",
            _ONLY_ONE.hint,
            seen=lambda q, xy: inside(xy) and (off(q, xy) < 1e-6).all() and (np.abs(wrapped(q[0] - q[1])) < 1e-9).all(),
        ),
        right_after(
            "the two rows are in the other order: q2 >= 0 is asked for first",
            "Return the row with q2 = +arccos(...) before that with q2 = -arccos(...).",
            lambda q, xy: q[::-1],
        ),
        right_after(
            "the angles are given in degrees",
            "Angles are radians everywhere: no np.rad2deg.",
            lambda q, xy: np.deg2rad(q),
            lambda q, xy: np.deg2rad(q[::-1]),
        ),
        right_after(
            "q1 and q2 have changed positions in the rows",
            "Each row is (q1, q2).",
            lambda q, xy: q[:, ::-1],
        ),
        right_after(
            "the answer is transposed: its rows are both q1 and both q2",
            "Each row is one solution, (q1, q2).",
            lambda q, xy: q.T,
        ),
        right_after(
            "q2 is counted from the x axis",
            "q2 is counted from the first link's direction: take q1 off.",
            with_q2(lambda t1, t2, xy: t2 - t1),
        ),
        Mistake(
            "q1 is the direction of the position alone, without the correction for the elbow",
            "q1 = atan2(y, x) - atan2(sin q2, 1 + cos q2): the first link points beside the position.",
            seen=q1_is(lambda xy, t2: towards(xy)),
        ),
        Mistake(
            "q1 is the same for both solutions",
            "The correction for the elbow has q2 in it: compute q1 anew for each q2.",
            seen=same_q1,
        ),
        right_after(
            "the elbow correction of q1 has the wrong sign",
            "q2 > 0 bends to the left, so the first link points to the right of the position: "
            "q1 = atan2(y, x) - atan2(sin q2, 1 + cos q2).",
            with_q1(lambda t1, t2, xy: 2 * towards(xy) - t1),
        ),
        Mistake(
            "the position at the base is given NaN",
            "There y / x is 0 / 0. Any q1 is right, so np.arctan2(0, 0) = 0 will do.",
            seen=lambda q, xy: not xy.any() and np.isnan(q).any(),
        ),
        Mistake(
            "q1 is wrong by pi if x < 0: atan of y / x looks at one quotient only",
            "np.arctan2(y, x) looks at both signs.",
            seen=by_arctan(1),
        ),
        Mistake(
            "the elbow correction of q1 has the wrong sign, and atan of y / x looks at one quotient only",
            "q1 = atan2(y, x) - atan2(sin q2, 1 + cos q2): np.arctan2(y, x) looks at both signs.",
            seen=by_arctan(-1),
        ),
        Mistake(
            "x and y are swapped in atan2",
            "np.arctan2(y, x), in this order.",
            seen=q1_is(lambda xy, t2: np.arctan2(xy[0], xy[1]) - correction(t2)),
        ),
        Mistake(
            "the two arguments of atan2 are swapped in the elbow correction",
            "atan2(sin q2, 1 + cos q2): the sine is the height, so it comes first.",
            seen=q1_is(lambda xy, t2: towards(xy) - np.arctan2(1 + np.cos(t2), np.sin(t2))),
        ),
        Mistake(
            "the elbow correction is q2, not half of it",
            "With links of the same length, atan2(sin q2, 1 + cos q2) is q2 / 2.",
            seen=q1_is(lambda xy, t2: towards(xy) - t2),
        ),
        right_after(
            "the angle inside the elbow is taken for q2: the law of cosines has the wrong sign",
            "q2 is what the second link bends from the first one's direction: r^2 = 2 + 2 cos q2.",
            lambda q, xy: corrected(supplement(q), xy),
            lambda q, xy: corrected(supplement(q[::-1]), xy),
        ),
        *(
            Mistake(
                "the cosine of q2 is not (r^2 - 2) / 2",
                "From r^2 = 1 + 1 + 2 cos q2: cos q2 = (x^2 + y^2 - 2) / 2.",
                seen=cosine_is(formula),
            )
            for formula in (
                lambda r: r**2 - 2,
                lambda r: (r - 2) / 2,
                lambda r: (r**2 - 1) / 2,
                lambda r: (r**2 - 2) / 4,
                lambda r: r**2 / 2,
                lambda r: r / 2,
                lambda r: (r**2 + 2) / 2,
            )
        ),
        Mistake(
            "q2 is right, and q1 is not",
            "q1 = atan2(y, x) - atan2(sin q2, 1 + cos q2).",
            seen=right_bend,
        ),
        Mistake(
            "only some of the numbers are NaN out of reach",
            "Return two rows of NaN there, np.full((2, 2), np.nan): q1 has no value either.",
            seen=lambda q, xy: outside(xy) and np.isnan(q).any(),
        ),
        Mistake(
            "NaN is returned for a position within reach",
            "Print the number you give to arccos or to the root: it has to lie in its range up to r = 2.",
            seen=lambda q, xy: np.isnan(q).any(),
        ),
    ),
    library=ik_2r,
    hints=(
        "r^2 = x^2 + y^2 = 2 + 2 cos q2 gives cos q2, and arccos gives q2 >= 0; -q2 is the other one.",
        "The direction to the position, np.arctan2(y, x), halves the angle q2 between the links: q1 is half of q2 "
        "less, for each of the two q2.",
        "Out of reach is r > 2: return np.full((2, 2), np.nan). By rounding, r may be 2 + 4e-16 at the edge "
        "and arccos's argument may leave [-1, 1]: let r > 2 + 1e-9 be out of reach, and np.clip before arccos.",
    ),
    forbidden=(
        "course_lib.arms.SerialArm",
        "course_lib.arms.planar_arm",
        "course_lib.ik.solve",
    ),
    errors=(
        ("ZeroDivisionError", "", _DIVIDED),
        ("ValueError", "math domain error", _NO_COSINE),
        ("ValueError", "reach", _RAISED),
        ("Exception", "reach", _RAISED),
        ("ValueError", "expected a number in range", _NO_COSINE),
    ),
)
