"""ik_2r: both pairs of joint angles that bring the tip of a planar arm with two links of one metre
to a position."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.vocabulary import other_bend, two_link_angles, two_link_tip

_EDGE, _REACH = 2 - 1e-3, 2 + 1e-9  # from here on a position is near the edge, and out of reach
_FINE, _ROUGH = (
    1e-9,
    1e-7,
)  # metres: inside, and near the edge, where a rounding of r moves q2 by its root

# Metres just out of reach; the task allows a tolerance of a micrometre for rounding.
_BEYOND = (1e-5, 1e-4, 3e-4, 1e-3, 0.01, 0.03, 0.1)
_SMALL = (0.1, 5e-3, 1e-3, 2e-4)  # metres from the base, where the arm is nearly folded

_NO_ROWS = Mistake(
    "a position out of reach is given another form",
    "Every answer has the shape (2, 2), so that a table of queries can go on. What stands in it "
    "here?",
)
_DIVIDED = Mistake(
    "y is divided by x, which may be 0", "Which function takes y and x without dividing them?"
)
_NO_COSINE = Mistake(
    "arccos gets a number outside [-1, 1]: out of reach, or by rounding at the edge",
    "Which positions have no solution? What is your cosine for xy = [np.nextafter(2, 3), 0], and "
    "what do you do then?",
)


def _cases(rng):
    named = [[1.0, 1.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.2], [1.6, 0.0]]
    angles = np.array([0.3, 1.2, 2.0, 2.8, 3.5, 4.4, 5.0, 6.0]) + rng.uniform(-0.2, 0.2, 8)
    sizes = np.concatenate([rng.uniform(0.2, 1.3, 4), rng.uniform(1.5, 1.95, 4)])[
        [0, 4, 1, 5, 6, 2, 7, 3]
    ]
    within = [np.round(r * _direction(a), 3) for r, a in zip(sizes, angles, strict=True)]
    beyond = np.nextafter(2, 3)
    edge = [[2.0, 0], [0, -2.0], [beyond, 0], [0, beyond], [-beyond, 0], [1.9999, 0.0]]
    edge += [2 * _direction(a) for a in rng.uniform(-3, 3, 6)]
    far = [[3.0, 0], [0, -2.5], [1.6, 1.6], [-2.001, 0]]
    far += [r * _direction(a) for r, a in rng.uniform(2.1, 6, (3, 2))]
    far += [(2 + d) * _direction(a) for d, a in zip(_BEYOND, rng.uniform(-3, 3, 7), strict=True)]
    middle = [[0.0, 0.0], [0.01, -0.02]]
    middle += [r * _direction(a) for r, a in zip(_SMALL, rng.uniform(-3, 3, 4), strict=True)]
    whole = [np.array([1, 1]), np.array([0, -1]), np.array([-1, 1]), np.array([3, 0])]
    return [(np.array(xy),) for xy in [*named, *within, *middle, *edge, *far, *whole]]


def _direction(angle):
    return np.array([np.cos(angle), np.sin(angle)])


def _inside(xy):
    return np.linalg.norm(xy) < _EDGE


def _outside(xy):
    return np.linalg.norm(xy) > _REACH


def _at_edge(xy):
    return not _inside(xy) and not _outside(xy)


def _reaches(within):
    return lambda q, xy: (np.linalg.norm(two_link_tip(q) - xy, axis=-1) < within).all()


def _in_order(q, xy):
    """Whether the row with q2 >= 0 is the first; at q2 = pi the sign has no meaning."""
    bend, slack = np.angle(np.exp(1j * q[:, 1])), 1e-3 * _at_edge(xy)
    return (np.abs(bend) > np.pi - 1e-6).all() or (bend[0] >= -slack and bend[1] <= slack)


def _tell_tip(q, xy):
    if np.isnan(q).any():
        return (
            f"xy = {xy.tolist()} is {float(np.linalg.norm(xy))} m from the base. Your answer holds "
            f"NaN."
        )
    row = int(np.argmax(np.linalg.norm(two_link_tip(q) - xy, axis=-1)))
    tip = format_tuple(np.round(two_link_tip(q[row]), 6))
    return f"With your {('first', 'second')[row]} row the tip is at {tip}, for xy = {xy.tolist()}."


def _alike(q, predicted, xy):
    """Whether the angles are the same up to multiples of 2 pi, and NaN stands at the same
    places."""
    gap = np.abs(np.angle(np.exp(1j * (q - predicted))))
    return np.array_equal(np.isnan(q), np.isnan(predicted)) and np.nanmax(gap, initial=0) < 1e-6


def ik_2r(xy):
    """Return both solutions (..., 2, 2) for positions (..., 2), q2 >= 0 first; NaN out of reach."""
    xy = np.asarray(xy, float)
    in_reach = np.linalg.norm(xy, axis=-1) <= 2 + 1e-12
    return np.where(in_reach[..., None, None], two_link_angles(xy), np.nan)


EXERCISE = Exercise(
    name="ik_2r",
    points=2,
    arguments=("xy",),
    cases=_cases,
    returns=numbers(lambda xy: (2, 2), gaps=True),
    library=ik_2r,
    alike=_alike,
    properties=(
        Property(
            "each row brings the tip to xy",
            _reaches(_FINE),
            _tell_tip,
            where=_inside,
            mistake=other_bend,
        ),
        Property(
            "the first row has q2 >= 0, the second q2 <= 0",
            _in_order,
            lambda q, xy: (
                f"Your q2 are {format_tuple(np.angle(np.exp(1j * q[:, 1])))}, up to multiples of 2 "
                f"pi."
            ),
            where=_inside,
        ),
        Property(
            "the tip reaches xy at the edge of the workspace too, stretched, where both rows are "
            "the same",
            lambda q, xy: _reaches(_ROUGH)(q, xy) and _in_order(q, xy),
            _tell_tip,
            where=_at_edge,
            mistake=Mistake(
                "the edge is treated too roughly",
                "Up to which distance is the arm not quite stretched?",
            ),
        ),
        Property(
            "a position out of reach, farther than 2 m from the base, has two rows of NaN",
            lambda q, xy: np.isnan(q).all(),
            lambda q, xy: f"This position is {np.linalg.norm(xy):.6g} m from the base.",
            where=_outside,
            mistake=Mistake(
                "a position out of reach has an answer", "Which distance is allowed for rounding?"
            ),
        ),
    ),
    hints=(
        "r^2 = x^2 + y^2 = 2 + 2 cos q2 gives cos q2, and arccos gives q2 >= 0; -q2 is the other "
        "one.",
        "The direction to the position, np.arctan2(y, x), halves the angle q2 between the links: "
        "q1 is half of q2 "
        "less, for each of the two q2.",
        "Out of reach is r > 2: return np.full((2, 2), np.nan). By rounding, r may be 2 + 4e-16 at "
        "the edge "
        "and arccos's argument may leave [-1, 1]: let r > 2 + 1e-9 be out of reach, and np.clip "
        "before arccos.",
    ),
    forbidden=("course_lib.arms.SerialArm", "course_lib.arms.planar_arm", "course_lib.ik.solve"),
)

EXERCISE.mistake(_NO_ROWS, form=lambda array, xy: _outside(xy))
EXERCISE.mistake(_DIVIDED, raises=("ZeroDivisionError", ""))
EXERCISE.mistake(_NO_COSINE, raises=("ValueError", "math domain error"))
EXERCISE.mistake(_NO_COSINE, raises=("ValueError", "expected a number in range"))


@EXERCISE.mistake(
    "positions at the edge of the workspace count as out of reach",
    "May rounding make the cosine exceed 1?",
    recognises=True,
)
def edge_out_of_reach(q, xy):
    return _at_edge(xy) and np.isnan(q).any()


@EXERCISE.mistake(
    "the angle between the first link and the direction to the tip has another size or sign",
    "Which angles of the triangle of both links are equal, and what is their sum?",
    factor=(1, 0.5, -0.5),
)
def another_half(xy, factor):
    return np.column_stack([ik_2r(xy)[:, 0] + factor * ik_2r(xy)[:, 1], ik_2r(xy)[:, 1]])


@EXERCISE.mistake(
    "q2 is the angle inside the triangle",
    "What is q2 of a stretched arm?",
    q1=(lambda q, q2: q[:, 0], lambda q, q2: q.sum(1) - q[:, 1] / 2 - q2 / 2),
)
def inner_angle(xy, q1):
    q = ik_2r(xy)
    q2 = np.sign(q[:, 1]) * np.pi - q[:, 1]
    return np.column_stack([q1(q, q2), q2])
