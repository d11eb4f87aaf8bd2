"""exp_se3: the pose reached by following a constant twist for one second."""

import numpy as np

from course_lib.checks.answer_types import NOT_A_NUMBER, numbers
from course_lib.checks.exercise import Exercise, Mistake, Property, Unreadable, same
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.poe_kuka_iiwa.matrices import BLOCK, COLUMN, FINE, in_part, told
from course_lib.checks.poe_kuka_iiwa.ways import degrees_inside, formed, partial_sum, turn, way, whole_length
from course_lib.checks.rotations.exponential import unit
from course_lib.checks.rotations.poses import pose
from course_lib.rigid import exp_se3, hat_se3
from course_lib.rotations import exp_so3, length

_NO_FACTOR_V = Mistake(
    "the factor v is missing, as in the formula that the report prints",
    "I a + (1 - cos a) [n] + (a - sin a) [n]^2 is a matrix. p is that matrix times v / a: p = (...) @ v / a.",
)
_NO_LENGTH = Mistake(
    "something is divided by zero: for omega = 0 there is no axis",
    "Ask whether the length of omega is 0, before you divide by it: then R = I and p = v.",
)
_UNDERFLOW = Mistake(
    "the length of omega, or a power of it, comes out as 0, and something is divided by it: |omega| is 1e-170 here",
    "The square of 1e-170 is too small for a computer: it is 0. Ask whether what you divide by is 0, not omega.",
)
_TINY = 1e-100
_matrix = numbers(lambda: (4, 4), dict.fromkeys(((4, 6), (3, 6), (3, 3)), _NO_FACTOR_V))


def _cases(rng):
    x, y, z = np.eye(3)
    still, quarter, n = np.zeros(3), np.pi / 2, unit(rng)
    named = [(still, still), (still, x), (still, np.array([1.0, 2, 3])), (1e-170 * n, still), (1e-170 * n, n + 1)]
    named += [(turned * quarter, still) for turned in (x, y, z)]
    named += [(quarter * z, x), (quarter * z, y), (quarter * z, z), (-quarter * x, z), (z, np.array([1.0, 2, 3]))]
    for angle in (0.5, 2.0, np.pi, 5.0, 2 * np.pi, 20.0, 1e-4, 1e-7, 1e-12):
        n, along = unit(rng), rng.uniform(0.5, 1)
        across = np.cross(n, unit(rng) + 2 * np.eye(3)[np.argmin(np.abs(n))])
        named.append((angle * n, across / np.linalg.norm(across) + along * n))
    named.append((2 * unit(rng), 50 * rng.normal(size=3)))
    return [(np.concatenate(twist),) for twist in named]


def _angle(twist):
    return float(length(twist[:3]))


def _no_turn(twist):
    return _angle(twist) < _TINY


def _pose(value, twist):
    """The answer as a matrix; what is no number has its reason in this twist."""
    try:
        return _matrix(value)
    except Unreadable as wrong:
        if wrong.mistake is NOT_A_NUMBER and _no_turn(twist):
            raise Unreadable(str(wrong), _UNDERFLOW if twist[:3].any() else _NO_LENGTH) from None
        raise


def _right_block(twist):
    return exp_so3(twist[:3])


def _right_way(twist):
    return exp_se3(twist)[COLUMN]


def _goes_right(T, twist):
    """Textbook formulas divide what 1 - cos has lost at tiny angles; that much is let pass."""
    fine = 5 * FINE if _angle(twist) < 1e-6 else FINE
    return np.abs(T[COLUMN] - _right_way(twist)).max() <= fine * max(1.0, np.abs(twist[3:]).max())


def _tell_way(T, twist):
    right, p = _right_way(twist), T[COLUMN]
    off = np.abs(p - right).max()
    return f"|omega| is {_angle(twist):.4g}. p should be {format_tuple(right)}; yours is {format_tuple(p)}, off by {off:.2g}."


_in_block, _in_column = in_part(BLOCK, _right_block), in_part(COLUMN, _right_way)

EXP_SE3 = Exercise(
    name="exp_se3",
    points=3,
    arguments=("twist",),
    cases=_cases,
    returns=_pose,
    properties=(
        Property(
            "the last row is (0, 0, 0, 1)",
            lambda T, twist: np.abs(T[3] - np.eye(4)[3]).max() < FINE,
            seen=lambda T, twist: f"Yours is {format_tuple(T[3])}.",
            mistake=Mistake("the last row is not that of a pose", "Start from np.eye(4) and fill in R and p."),
        ),
        Property(
            "the upper left 3x3 block is the rotation by |omega| about omega, as rodrigues gives it",
            lambda T, twist: np.abs(T[BLOCK] - _right_block(twist)).max() < FINE,
            seen=told(lambda T: T[BLOCK], _right_block),
            points=1,
        ),
        Property(
            "for v = 0 the origin stays where it is: p = 0",
            lambda T, twist: np.abs(T[COLUMN]).max() < FINE,
            seen=lambda T, twist: f"Your p is {format_tuple(T[COLUMN])}.",
            where=lambda twist: not twist[3:].any(),
            mistake=_NO_FACTOR_V,
        ),
        Property(
            "p is where the origin comes to, led by v while it turns",
            _goes_right,
            seen=_tell_way,
            where=lambda twist: not _no_turn(twist),
        ),
        Property(
            "without turning, omega = 0, the motion is a translation by v: R = I and p = v",
            _goes_right,
            seen=_tell_way,
            where=_no_turn,
            mistake=Mistake("the branch for omega = 0 is wrong", "There R = I and p = v."),
        ),
    ),
    mistakes=(
        Mistake(
            "small angles are cut off: the turn is taken for none",
            "Only |omega| = 0 needs a branch of its own; 1e-7 is no zero, and the formula takes it.",
            lambda twist: pose(_right_block(twist), twist[3:]) if 0 < _angle(twist) < 1e-3 else None,
            lambda twist: pose(np.eye(3), twist[3:]) if 0 < _angle(twist) < 1e-3 else None,
        ),
        Mistake(
            "v and omega are swapped",
            "A twist is (omega, v): the first three entries are omega.",
            lambda twist: exp_se3(np.roll(twist, 3)),
        ),
        Mistake(
            "the motion goes backwards: this is the inverse pose",
            "Look at the signs in [n], and in v.",
            lambda twist: exp_se3(-twist),
        ),
        Mistake(
            "angles are taken for degrees",
            "Angles are radians everywhere; np.deg2rad is not needed.",
            lambda twist: exp_se3(np.append(np.deg2rad(twist[:3]), twist[3:])),
            lambda twist: exp_se3(np.append(np.rad2deg(twist[:3]), twist[3:])),
            degrees_inside,
        ),
        Mistake(
            "np.exp takes each entry by itself",
            "The exponential of a matrix is another thing: scipy.linalg.expm.",
            lambda twist: np.exp(hat_se3(twist)),
        ),
        Mistake(
            "the series is cut after its first terms",
            "The closed formula adds up all of them.",
            *map(partial_sum, (2, 3, 4, 5, 8)),
        ),
        Mistake(
            "a is the length of the whole twist", "a is the angle: the length of omega = twist[:3] alone.", whole_length
        ),
        Mistake(
            "omega is not divided by its length before [n] is formed",
            "n is a unit axis in these formulas: n = omega / a.",
            formed(turn(unit_axis=False), way(unit_axis=False)),
            formed(turn(), way(unit_axis=False)),
            formed(turn(unit_axis=False), way()),
        ),
        Mistake(
            "for omega = 0 the identity is returned: v is forgotten",
            "Without turning, the origin goes straight along v: p = v.",
            seen=lambda T, twist: _no_turn(twist) and same(T, np.eye(4)),
        ),
        _in_block(
            ("R^T stands in the block: the rotation goes the other way round", "[n] p must be n x p."),
            lambda twist: exp_so3(-twist[:3]),
        ),
        _in_block(("the block is the identity: nothing turns", "T[:3, :3] = R"), lambda twist: np.eye(3)),
        _in_block(
            ("the term with [n]^2 is left out of R", "R = I + sin(a) [n] + (1 - cos(a)) [n]^2."),
            lambda twist: turn(versine=lambda a: 0.0)(twist),
        ),
        _in_block(
            ("cos stands where 1 - cos belongs in R", "At angle 0 the last term must vanish."),
            lambda twist: turn(versine=np.cos)(twist),
        ),
        _in_block(
            ("the identity is left out of R", "R = I + ...: a small turn leaves a point nearly where it is."),
            lambda twist: exp_so3(twist[:3]) - np.eye(3),
        ),
        _in_block(
            ("angles are taken for degrees", "Angles are radians everywhere."),
            lambda twist: exp_so3(np.deg2rad(twist[:3])),
        ),
        _in_block(
            ("the angle 1 is taken, not |omega|", "The axis n = omega / a turns by the angle a."),
            lambda twist: exp_so3(twist[:3] / _angle(twist)),
        ),
        _in_column(
            ("p = v: the origin is not led round", "While it goes along v it turns: p = (I a + ...) v / a."),
            lambda twist: twist[3:],
        ),
        _in_column(
            ("p has its sign changed", "p = (I a + (1 - cos a) [n] + (a - sin a) [n]^2) v / a."),
            lambda twist: -_right_way(twist),
        ),
        _in_column(
            ("p = R v", "That is v after the whole turn. On the way it points anywhere between v and R v."),
            lambda twist: _right_block(twist) @ twist[3:],
            lambda twist: _right_block(twist).T @ twist[3:],
        ),
        _in_column(("p is left out", "T[:3, 3] = p"), lambda twist: np.zeros(3)),
        _in_column(
            ("v is not divided by a", "n has length one, so that |omega| = a is in a: p = (...) v / a."),
            way(divisions=0),
        ),
        _in_column(
            ("v is divided by a twice", "p = (I a + (1 - cos a) [n] + (a - sin a) [n]^2) v / a: once."),
            way(divisions=2),
        ),
        _in_column(
            ("I stands where I a belongs", "Straight ahead, n along v, p = v: that is I a v / a."),
            way(straight=lambda a: 1.0),
            way(straight=lambda a: 1.0, divisions=0),
        ),
        _in_column(
            ("the term I a is left out of p", "Straight ahead, n along v, p = v: that is I a v / a."),
            way(straight=lambda a: 0.0),
        ),
        _in_column(
            ("the term with [n]^2 is left out of p", "I a + (1 - cos a) [n] + (a - sin a) [n]^2."),
            way(second=lambda a: 0.0),
        ),
        _in_column(
            ("the term with [n] is left out of p", "I a + (1 - cos a) [n] + (a - sin a) [n]^2."),
            way(first=lambda a: 0.0),
        ),
        _in_column(
            ("the factors 1 - cos a and a - sin a are swapped", "1 - cos a goes with [n], a - sin a with [n]^2."),
            way(first=lambda a: a - np.sin(a), second=lambda a: 1 - np.cos(a)),
        ),
        _in_column(
            ("the factors of R stand in p", "p is the integral: of cos comes sin, and of sin comes 1 - cos."),
            way(first=np.sin, second=lambda a: 1 - np.cos(a)),
            way(first=np.sin, second=lambda a: 1 - np.cos(a), straight=lambda a: 1.0),
            way(first=np.sin, second=lambda a: 1 - np.cos(a), straight=lambda a: 1.0, divisions=0),
        ),
        _in_column(
            ("a sign in the formula of p is wrong", "I a + (1 - cos a) [n] + (a - sin a) [n]^2: at a = 0 all is 0."),
            way(first=lambda a: np.cos(a) - 1),
            way(second=lambda a: np.sin(a) - a),
            way(first=lambda a: np.cos(a) - 1, second=lambda a: np.sin(a) - a),
            way(first=lambda a: 1 + np.cos(a)),
            way(second=lambda a: a + np.sin(a)),
        ),
        _in_column(
            ("cos a stands where 1 - cos a belongs, or sin a where a - sin a", "At a = 0 every term must vanish."),
            way(first=np.cos),
            way(second=np.sin),
            way(first=np.cos, second=np.sin),
            way(second=lambda a: 1 - np.sin(a)),
        ),
        _in_column(
            ("[n] * [n], entry by entry, stands for the matrix product", "In numpy the matrix product is @."),
            way(product=np.multiply),
        ),
    ),
    hints=(
        "omega, v = twist[:3], twist[3:]; a is the length of omega, n = omega / a, N = hat(n).",
        "For a = 0 there is no axis: R = I and p = v, before you divide.",
        "p = (I a + (1 - cos(a)) N + (a - sin(a)) N @ N) @ v / a, and R = rodrigues(n, a).",
        "T = np.eye(4), then T[:3, :3] = R and T[:3, 3] = p.",
    ),
    forbidden=("course_lib.rigid.exp_se3",),
)
