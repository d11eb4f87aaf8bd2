"""The known ways to go wrong in pose_error."""

import numpy as np

from course_lib.checks.exercise import Mistake, same
from course_lib.checks.panda_dh_ik.error_parts import (
    NEARLY_HALF,
    as_twist,
    from_hand,
    from_world,
    left,
    log,
    other_angles,
    place_left,
    quaternion_parts,
    roll_pitch_yaw,
    skew_part,
    stretched,
    subtracted,
    translation,
)
from course_lib.checks.poe_kuka_iiwa.matrices import near
from course_lib.rotations import length, log_so3

_PLACE = "The places are simply subtracted: p_target - p, along the world's axes as the Jacobian's upper half is."
_WAY = "What is left to do leads from T to T_target: p_target - p, and the logarithm of R_target R^T."
_WORLD = "The Jacobian's lower half is along the world's axes, so phi has to be too: R_target R^T."
_LOGARITHM = "phi is angle times unit axis, the logarithm of R_target R^T: rotations.log_so3."
_FROM_ORIGIN = (
    "T_target T^-1 is seen from the world's origin, where a turn moves the hand too: that fits the space Jacobian. "
    "The geometric one wants p_target - p."
)
_ANGLES = (
    "From 179 to -179 degrees it is 2, not -358, and such differences pair with no Jacobian of angular velocities. "
    "Take the logarithm of R_target R^T."
)
_right = log(lambda R, R_target: R_target @ R.T)


def _angle(T, T_target):
    return length(left(T, T_target)[3:])


def _both_signs(vector):
    """At half a turn the other sign is as good."""
    return (vector, -vector) if length(vector) > NEARLY_HALF else (vector,)


def _alike(phi, guess, angle, turns):
    """Whether they are the same to the digits that the turn has; turns: whole turns do not matter."""
    gap = phi - guess
    gap = gap - 2 * np.pi * np.round(gap / (2 * np.pi)) if turns else gap
    return np.abs(gap).max() <= 1e-4 * min(angle, 0.01) + 1e-12


def _slip(words, *variants, signs=(1,), turns=False, swapped=False):
    """A mistake that shows in both halves. variants: pairs (place, vector); swapped: the halves stand so too."""
    name, hint = words

    def seen(e, T, T_target):
        angle, blocks = _angle(T, T_target), (T[:3, :3], T_target[:3, :3])
        answer = np.roll(e, 3) if swapped else e
        for place, vector in variants:
            where, guesses = place(T, T_target), _both_signs(vector(*blocks))
            for sign in signs:
                fits = same(answer[:3], sign * where)
                if fits and any(_alike(answer[3:], sign * guess, angle, turns) for guess in guesses):
                    return True
        return False

    return Mistake(name, hint, seen=seen)


def _in_turn(words, *vectors, **options):
    """A mistake in phi alone."""
    return _slip(words, *((place_left, vector) for vector in vectors), **options)


def _in_place(words, *places, vectors=(_right,), **options):
    """A mistake in the place alone, or along with one of `vectors`."""
    return _slip(words, *((place, vector) for place in places for vector in vectors), **options)


def _in_hand(R, R_target):
    return log_so3(R.T @ R_target)


def _none(*pair):
    return np.zeros(3)


def _place_in_hand(T, T_target):
    return T[:3, :3].T @ place_left(T, T_target)


def _place_in_target(T, T_target):
    return T_target[:3, :3].T @ place_left(T, T_target)


def _back(T, T_target):
    return -place_left(T, T_target)


def _unwrapped(angle):
    return angle - 2 * np.pi


def _difference(R, R_target):
    return R_target - R


def _columns(R, R_target):
    """Half the sum of the cross products of the axes, which is sin(angle) times the unit axis."""
    return skew_part(R_target @ R.T)


def _cut_off(e, T, T_target):
    return not e[3:].any() and 0 < _angle(T, T_target) < 0.02 and near(e[:3], place_left(T, T_target))


def _few_digits(e, T, T_target):
    return _angle(T, T_target) < 1e-2 and np.abs(e - left(T, T_target)).max() < 1e-7


def _at_half_a_turn(e, T, T_target):
    return _angle(T, T_target) > np.pi - 1e-3 and near(e[:3], place_left(T, T_target))


def _nearly(e, T, T_target):
    right = left(T, T_target)
    halves = [np.concatenate([right[:3], phi]) for phi in _both_signs(right[3:])]
    return min(np.abs(e - half).max() for half in halves) <= 3e-3 * max(1, np.abs(right).max())


MISTAKES = (
    Mistake(
        "half a turn is taken for none, or its axis is wrong",
        "At half a turn X - X^T is 0 and tells nothing of the axis. rotations.log_so3 takes care of it.",
        seen=_at_half_a_turn,
    ),
    Mistake(
        "small turns are cut off to zero",
        "The last steps to a target are made of them. A cut takes them away, and so may arccos of a trace near 3: "
        "rotations.log_so3 keeps them.",
        seen=_cut_off,
    ),
    Mistake(
        "digits are lost at small turns, as arccos of the trace loses them",
        "The trace is 3 - angle^2: of an angle of 1e-9 nothing is left in it. rotations.log_so3 keeps all digits.",
        seen=_few_digits,
    ),
    Mistake(
        "the logarithm fails both at tiny turns and at half a turn",
        "At the one arccos loses its digits, at the other X - X^T is 0. rotations.log_so3 takes care of both.",
        seen=lambda *case: _few_digits(*case) or _at_half_a_turn(*case),
    ),
    _slip(("the error has its sign turned: current minus target", _WAY), (place_left, _right), signs=(-1,)),
    _slip(
        ("phi stands before the difference of the places", "The Jacobian has v above omega: places first, then phi."),
        (place_left, _right),
        (as_twist(from_world), _right),
        (as_twist(from_hand), _in_hand),
        (_place_in_hand, _in_hand),
        (translation(from_world), _right),
        signs=(1, -1),
        swapped=True,
    ),
    _in_turn(("phi has its sign turned: the logarithm of R R_target^T", _WAY), log(lambda R, R_target: R @ R_target.T)),
    _in_place(("the difference of the places has its sign turned: p - p_target", _WAY), _back),
    _slip(
        ("the whole error is seen from the hand", _PLACE + " " + _WORLD),
        (_place_in_hand, _in_hand),
        (as_twist(from_hand), _in_hand),
        signs=(1, -1),
    ),
    _in_turn(
        ("phi is seen from the hand: the logarithm of R^T R_target", _WORLD),
        _in_hand,
        log(lambda R, R_target: R_target.T @ R),
    ),
    _in_place(
        ("the difference of the places is turned into the hand's axes", _PLACE), _place_in_hand, _place_in_target
    ),
    _in_place(
        (
            "the translation holds a part of the rotation: it is that of T_target T^-1, or of T T_target^-1",
            _FROM_ORIGIN,
        ),
        translation(from_world),
        lambda T, T_target: translation(from_world)(T_target, T),
        lambda T, T_target: -translation(from_world)(T_target, T),
        as_twist(from_world),
        signs=(1, -1),
    ),
    _in_turn(
        ("roll, pitch and yaw are subtracted", _ANGLES),
        *(
            lambda R, R_target, measure=measure, order=order: subtracted(measure)(R, R_target)[::order]
            for measure in (roll_pitch_yaw, other_angles)
            for order in (1, -1)
        ),
        turns=True,
    ),
    _in_turn(
        (
            "roll, pitch and yaw of R_target R^T stand for its rotation vector",
            "They are three turns one after the other; phi is one turn about one axis. " + _LOGARITHM,
        ),
        *(
            lambda R, R_target, measure=measure, order=order: measure(R_target @ R.T)[::order]
            for measure in (roll_pitch_yaw, other_angles)
            for order in (1, -1)
        ),
        turns=True,
    ),
    _in_turn(
        (
            "two rotation vectors are subtracted",
            "log(R_target) - log(R) is not the logarithm of R_target R^T: turns about different axes do not add up.",
        ),
        subtracted(log_so3),
    ),
    _in_turn(
        (
            "quaternions are subtracted",
            "Their difference is no rotation vector, and kappa and -kappa are the same rotation. " + _LOGARITHM,
        ),
        *(
            lambda R, R_target, factor=factor, sign=sign: (
                factor * (quaternion_parts(R_target) + sign * quaternion_parts(R))
            )
            for factor in (1, 2, -1, -2)
            for sign in (-1, 1)
        ),
    ),
    _in_turn(
        (
            "only the sine of the angle is taken: the vector of (X - X^T) / 2, which is right for small turns only",
            "Beyond 90 degrees it gets shorter again, and at 180 it is 0. " + _LOGARITHM,
        ),
        _columns,
        stretched(lambda a: 2 * np.sin(a)),
        stretched(lambda a: a * np.sin(a)),
    ),
    _in_turn(
        (
            "a part of the quaternion of R_target R^T is taken for its rotation vector",
            "It is sin(angle / 2) times the axis, twice that is right for small turns only. " + _LOGARITHM,
        ),
        *(stretched(lambda a, factor=factor: factor * np.sin(a / 2)) for factor in (1, 2, 0.5, -1, -2)),
    ),
    _in_turn(
        ("the long way round is taken", "2 pi - a about the opposite axis is the shorter way."), stretched(_unwrapped)
    ),
    _in_turn(
        (
            "the angle is wrong beyond a quarter turn: arcsin ends there",
            "arcsin gives the same for a and pi - a. " + _LOGARITHM,
        ),
        stretched(lambda a: np.arcsin(np.sin(a))),
    ),
    _in_turn(("phi is in degrees", "Angles are radians everywhere."), stretched(np.rad2deg), stretched(np.deg2rad)),
    _in_turn(("phi is twice as long, or half", _LOGARITHM), stretched(lambda a: 2 * a), stretched(lambda a: a / 2)),
    _in_turn(("the axis is returned without the angle", _LOGARITHM), stretched(lambda a: 1)),
    _in_turn(
        (
            "the rotations are subtracted entry by entry",
            "R_target - R is no rotation. Rotations are compared by a product: R_target R^T.",
        ),
        lambda R, R_target: skew_part(_difference(R, R_target)),
        lambda R, R_target: 2 * skew_part(_difference(R, R_target)),
        lambda R, R_target: np.array([1, 1, 1]) * _difference(R, R_target)[[2, 0, 1], [1, 2, 0]],
    ),
    _in_turn(
        ("R is not transposed: this is the logarithm of a product of R and R_target", _WORLD),
        log(lambda R, R_target: R_target @ R),
        log(lambda R, R_target: R @ R_target),
    ),
    _in_turn(("R is left out: this is the logarithm of R_target", _WORLD), log(lambda R, R_target: R_target)),
    _in_turn(("phi is left out", "Six numbers: the last three are " + _LOGARITHM), _none),
    _in_place(
        (
            "the difference of the places is left out, or taken from the last row",
            "Places stand in the last column. " + _PLACE,
        ),
        _none,
    ),
    _in_place(
        ("p is added, or left out", _PLACE),
        lambda T, T_target: T_target[:3, 3] + T[:3, 3],
        lambda T, T_target: T_target[:3, 3],
    ),
    Mistake(
        "the answer is right to its first digits only",
        "Compute with all digits: no np.round, and pi is np.pi.",
        seen=_nearly,
    ),
)
