"""constant_omega: the constant angular velocity from one orientation to another."""

import numpy as np

from course_lib.checks.answer_types import NOT_A_NUMBER, numbers
from course_lib.checks.exercise import Exercise, Mistake, Property, Unreadable
from course_lib.checks.vocabulary import unit
from course_lib.rotations import exp_so3, log_so3, random_rotations, rot_x, rot_y, rot_z

_HALF_TURNS = [np.diag([1.0, -1.0, -1.0]), np.diag([-1.0, 1.0, -1.0]), np.diag([-1.0, -1.0, 1.0])]
_BELOW, _ABOVE = -1 - 2.0**-52, 1 + 2.0**-50  # a hair beyond -1 and 1, as products of rotations may come out
_COARSE = 1e-6  # how far from Rf a right answer may end at no turn and at a half one, where arccos loses digits

_NO_AXIS = Mistake(
    "the angle is divided by where nothing rotates",
    "For R0 = Rf there is no axis, and omega is 0. log_so3 gives angle times axis at once, without a division.",
)
_OUTSIDE = Mistake(
    "arccos is asked outside [-1, 1]: rounding has taken the trace a hair beyond 3 or below -1",
    "np.clip((np.trace(R) - 1) / 2, -1, 1) before arccos, or log_so3, which needs no arccos.",
)
_NO_SINE = Mistake(
    "sin(angle) is divided by at a half turn, where it is 0",
    "At pi, R - R^T is 0 and tells nothing of the axis. log_so3 has the branch that it takes.",
)


def _cases(rng):
    eye = np.eye(3)
    named = [(eye, rot_y(1.0), 2.0), (eye, rot_z(0.5), 1.0), (eye, eye, 1.0), (rot_x(0.5), rot_x(1.5), 2.0)]
    named += [(rot_z(0.5), eye, 0.5), (rot_x(np.pi / 2), rot_y(np.pi / 2), 1.0), (rot_y(0.7), rot_y(0.7), 2)]
    turns = [(0.8, 4.0), (2.0, 0.5), (3.0, 2.0), (np.pi - 1e-3, 3.0), (1.234e-4, 2.5), (1.0, 10)]
    starts = random_rotations(len(turns) + 4, rng)
    drawn = [(R, exp_so3(angle * unit(rng)) @ R, T) for R, (angle, T) in zip(starts, turns, strict=False)]
    same = [(starts[-1], starts[-1], 2.0)]
    axes = [unit(rng), np.array([0.6, 0.0, -0.8]), np.array([-0.36, 0.48, 0.8])]
    half = [(eye, H, 2.0) for H in _HALF_TURNS] + [(starts[-2], _HALF_TURNS[0] @ starts[-2], 0.5)]
    half += [(R, (2 * np.outer(n, n) - eye) @ R, T) for R, n, T in zip(starts[-4:-1], axes, (1.0, 3.0, 2), strict=True)]
    tiny = [(starts[1], exp_so3(1e-9 * unit(rng)) @ starts[1], 3.0)]
    rounded = [(eye, np.diag([_ABOVE] * 3), 1.0), (eye, np.diag([1.0, _BELOW, _BELOW]), 1.0)]
    return [*named, *drawn, *same, *half, *tiny, *rounded]


def _turn(R0, Rf, T):
    """The rotation vector of the whole turn, in the fixed frame."""
    return log_so3(Rf @ R0.T)


def _angle(R0, Rf, T):
    return np.linalg.norm(_turn(R0, Rf, T))


def _none(*case):
    return _angle(*case) < 1e-12


def _tiny(*case):
    return 1e-12 < _angle(*case) < 1e-6


def _half(*case):
    return _angle(*case) > np.pi - 1e-6


def _plain(*case):
    return 1e-6 < _angle(*case) < np.pi - 1e-6


def _fine(*case):
    """How far from Rf a right answer may end; dividing by sin(angle) costs digits towards pi."""
    return 1e-9 + 1e-11 / (np.pi - _angle(*case))


def _miss(omega, R0, Rf, T):
    """How far from Rf it ends; a turn of enormous size ends nowhere."""
    turn = omega * T
    return np.abs(exp_so3(turn) @ R0 - Rf).max() if np.abs(turn).max() < 1e9 else np.inf


def _velocity(omega, *case):
    try:
        return numbers(lambda *any_case: (3,))(omega)
    except Unreadable as wrong:
        if wrong.mistake is not NOT_A_NUMBER or _plain(*case):
            raise
        outside = abs(np.trace(case[1] @ case[0].T) - 1) > 2
        raise Unreadable(str(wrong), _OUTSIDE if outside else _NO_SINE if _half(*case) else _NO_AXIS) from None


def _seen(omega, R0, Rf, T):
    return (
        f"From R0 to Rf is a rotation by {_angle(R0, Rf, T):.5g} rad. With your omega it is |omega| T = "
        f"{np.linalg.norm(omega) * T:.5g} rad and ends {_apart(omega, R0, Rf, T)} from Rf."
    )


def _apart(omega, R0, Rf, T):
    turn = omega * T
    if np.abs(turn).max() > 1e9:
        return "somewhere"
    return f"{np.linalg.norm(log_so3(Rf @ (exp_so3(turn) @ R0).T)):.3g} rad"


def _like(words, *formulas):
    """One mistake, name and hint in `words`, that may be made in more than one way: each formula(R0, Rf, T) an omega.

    Where the turn of a formula is half a turn, the other sign is as good.
    """
    name, hint = words

    def seen(formula):
        def matches(omega, *case):
            wanted = formula(*case)
            size = max(np.linalg.norm(wanted), 1e-9)
            return min(np.linalg.norm(omega - wanted), np.linalg.norm(omega + wanted) + _sided(*case)) < 1e-5 * size

        return matches

    return tuple(Mistake(name, hint, seen=seen(formula)) for formula in formulas)


def _sided(*case):
    return 0.0 if _half(*case) else np.inf


def _scaled(factor):
    """The prediction of those who multiply the right omega by factor(angle, T)."""

    def prediction(*case):
        angle, T = _angle(*case), case[2]
        return _turn(*case) / T * factor(angle, T)

    return prediction


def _vector_of(W):
    return np.array([W[2, 1], W[0, 2], W[1, 0]])


def _log_of(words, *products):
    """The mistake of the logarithm of another product of rotations, of either sign, over T."""
    signed = [(sign, product) for sign in (1, -1) for product in products]
    return _like(words, *(lambda R0, Rf, T, s=s, p=p: s * log_so3(p(R0, Rf)) / T for s, p in signed))


def _angular_velocity(R0, Rf, T):
    return log_so3(Rf @ R0.T) / T


EXERCISE = Exercise(
    name="constant_omega",
    points=2,
    arguments=("R0", "Rf", "T"),
    cases=_cases,
    returns=_velocity,
    properties=(
        Property(
            "after T seconds the orientation is Rf: exp(T [omega]) R0 = Rf",
            lambda omega, *case: _miss(omega, *case) < _fine(*case),
            _seen,
            where=_plain,
        ),
        Property(
            "the smallest angle is taken: |omega| T is at most pi",
            lambda omega, R0, Rf, T: np.linalg.norm(omega) * T < np.pi + _COARSE,
            lambda omega, R0, Rf, T: f"Yours rotates by {np.linalg.norm(omega) * T:.5g} rad.",
            where=lambda *case: _plain(*case) or _half(*case),
            mistake=Mistake("the long way round is taken", "2 pi - a about the opposite axis is the shorter way."),
        ),
        Property(
            "if R0 is Rf already, nothing rotates: omega = 0",
            lambda omega, R0, Rf, T: np.linalg.norm(omega) * T < _COARSE,
            where=_none,
            mistake=Mistake("an axis is returned where nothing rotates", "Angle times axis is 0 there, for any axis."),
        ),
        Property(
            "for a tiny rotation omega is the vector of (R - R^T) / 2 over T, with R = Rf R0^T, or zero",
            lambda omega, *case: (
                not omega.any() or np.linalg.norm(omega * case[2] - _turn(*case)) < 1e-3 * _angle(*case)
            ),
            where=_tiny,
            mistake=Mistake("the branch for tiny rotations is wrong", "There sin(a) is a, and no division is needed."),
        ),
        Property(
            "after T seconds the orientation is Rf, also where that is half a turn: exp(T [omega]) R0 = Rf",
            lambda omega, *case: _miss(omega, *case) < _COARSE,
            _seen,
            where=_half,
            mistake=Mistake(
                "at a half turn the answer is not the axis times pi / T",
                "At pi, R - R^T is 0 to rounding: no axis can be had from it. log_so3 takes it from R + I.",
            ),
        ),
    ),
    mistakes=(
        Mistake(
            "a rotation by 180 degrees is taken for none",
            "At pi, R equals R^T, and R - R^T tells nothing. log_so3 knows what to do.",
            seen=lambda omega, *case: _half(*case) and np.linalg.norm(omega) * case[2] < 1e-3,
        ),
        Mistake(
            "small rotations are cut off to zero",
            "A small rotation is a rotation. log_so3 needs no help with it.",
            seen=lambda omega, *case: not omega.any() and 0 < _angle(*case) < 0.1,
        ),
        *_like(
            (
                "omega is seen from the rotating end-effector, not from the fixed frame",
                "log(R0^T Rf) belongs to R0 exp(...) = Rf. In the fixed frame exp(...) stands on the left: "
                "log(Rf R0^T).",
            ),
            lambda R0, Rf, T: log_so3(R0.T @ Rf) / T,
        ),
        *_like(
            (
                "the rotation is backwards, from Rf to R0",
                "exp(T [omega]) R0 = Rf, so exp(T [omega]) = Rf R0^T, in this order.",
            ),
            _scaled(lambda angle, T: -1.0),
            lambda R0, Rf, T: log_so3(Rf.T @ R0) / T,
        ),
        *_like(
            (
                "the rotation is not divided by T",
                "The logarithm is the whole rotation in rad. In rad/s it is that over T.",
            ),
            _scaled(lambda angle, T: T),
        ),
        *_like(
            ("the rotation is multiplied by T", "In more time the same rotation is slower: divide by T."),
            _scaled(lambda angle, T: T * T),
        ),
        *_like(
            ("the rotation is divided by T twice", "rad over s is rad/s: divide once."),
            _scaled(lambda angle, T: 1 / T),
        ),
        *_like(
            (
                "the rotation vectors of R0 and Rf are subtracted",
                "log Rf - log R0 is no rotation from one to the other, unless both have one axis: it is log(Rf R0^T).",
            ),
            lambda R0, Rf, T: (log_so3(Rf) - log_so3(R0)) / T,
        ),
        *_log_of(
            (
                "R0 is left out: this is the logarithm of Rf alone",
                "R0 need not be a rotation about the axis of the motion. Only Rf R0^T is.",
            ),
            lambda R0, Rf: Rf,
        ),
        *_log_of(
            ("the transpose is missing: this is the logarithm of a plain product", "exp(T [omega]) = Rf R0^T."),
            lambda R0, Rf: Rf @ R0,
            lambda R0, Rf: R0 @ Rf,
        ),
        *_like(
            ("degrees and radians are mixed up", "log_so3 is in radians, omega in rad/s: nothing to convert."),
            _scaled(lambda angle, T: 180 / np.pi),
            _scaled(lambda angle, T: np.pi / 180),
        ),
        *_like(
            ("the axis alone is returned, without the angle", "The logarithm is angle times unit axis: keep both."),
            _scaled(lambda angle, T: T / angle),
            _scaled(lambda angle, T: 1 / angle),
        ),
        *_like(
            ("the angle is multiplied twice", "log_so3 is angle times axis already."),
            _scaled(lambda angle, T: angle),
        ),
        *_like(
            (
                "the skew part of Rf R0^T is taken for its logarithm",
                "(R - R^T)/2 is sin(a) [n], and right for small rotations only. log_so3 gives a n.",
            ),
            _scaled(lambda angle, T: np.sin(angle) / angle),
        ),
        *_like(
            ("the half is missing: R - R^T is 2 sin(a) [n]", "Divide by 2 sin(a), multiply by a. log_so3 does that."),
            _scaled(lambda angle, T: 2 * np.sin(angle) / angle),
        ),
        *_like(
            (
                "the difference Rf - R0 is taken for the derivative of R",
                "[omega] = R' R^T holds at each instant. (Rf - R0) / T is R' for a small rotation only.",
            ),
            lambda R0, Rf, T: _vector_of((Rf - R0) @ R0.T) / T,
            lambda R0, Rf, T: _vector_of((Rf - R0) @ Rf.T) / T,
            lambda R0, Rf, T: _vector_of(Rf - R0) / T,
        ),
        *_like(
            (
                "the angle is wrong beyond a quarter turn: arcsin ends there",
                "The trace of R is 1 + 2 cos(a) and tells a from pi - a. log_so3 looks at both.",
            ),
            _scaled(lambda angle, T: min(angle, np.pi - angle) / angle),
        ),
        *_like(("half of the angle is used", "Only a quaternion holds the half angle."), _scaled(lambda angle, T: 0.5)),
        *_like(("twice the angle is used", "log_so3 is the whole rotation, once."), _scaled(lambda angle, T: 2.0)),
    ),
    library=_angular_velocity,
    hints=(
        "Which rotation, from the left, takes R0 to Rf? Solve exp(T [omega]) R0 = Rf for the exponential.",
        "The inverse of a rotation is its transpose: exp(T [omega]) = Rf R0^T.",
        "log_so3 of that is T omega. At R0 = Rf and at half a turn it needs no further line.",
    ),
)
