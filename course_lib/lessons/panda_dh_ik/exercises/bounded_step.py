"""bounded_step: joint velocities within bounds that come closest to an end-effector velocity."""

import functools

import numpy as np
from scipy.optimize import lsq_linear

from course_lib.checks.declared import declared
from course_lib.checks.kinds import OWN_CASES
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import BESIDE, Sweep
from course_lib.checks.tolerances import EXACT, FOUR_DIGITS
from course_lib.checks.vocabulary import away_from_zero, remembered
from course_lib.lessons.panda_dh_ik.exercises.shared import HIGH, LOW, panda_jacobian

_FLAT = np.array([[1.0, 1, 0], [0, 1, 1]])
# A Jacobian and a velocity for which an iteration must go on for long, because two singular values
# differ tenfold and two joints have little to do: projected gradients need 1,671 steps.
_SLOW = (
    np.array([[0.3, -0.1, 1.9, 0.5], [-0.1, -0.1, -0.3, -0.2]]),
    np.array([0.8, 0.0]),
    0.3,
    0.01,
)
# Joints that move the flange in nearly the same way, with hardly more than the least eps that the
# task allows. In these two cases projected gradients need more than 5,000 steps, and an answer
# that goes joint by joint needs more than 2,000 rounds: it has to look at its progress.
_ALIKE = np.array([[1.0, 1, 1], [0, 0.02, 0.01]])
_LEAST_EPS = 0.00101
_SLOWEST = (
    (_ALIKE, np.array([0.5, 0.05]), 1.0, _LEAST_EPS),  # no joint is at its bound
    (_ALIKE, np.array([0.5, 0.03]), 0.3, _LEAST_EPS),  # one joint is
)


def _stacked(J, v, eps):
    n = J.shape[1]
    return np.vstack([J, np.sqrt(eps) * np.eye(n)]), np.append(v, np.zeros(n))


def _free(J, v, bound, eps):
    if not np.isfinite(eps) or eps < 0:
        raise ValueError("eps must be a finite number, 0 or more")
    return np.linalg.lstsq(*_stacked(J, v, eps))[0]


@remembered
def _right(J, v, bound, eps):
    """Return the right answer, by scipy's solver for linear least squares with bounds."""
    # LAPACK, called with something else, writes "** On entry to DLASCL ..." above the message.
    if not all(np.isfinite(part).all() for part in (J, v, bound, eps)) or bound <= 0 or eps < 0:
        raise ValueError("J, v, bound and eps must be finite, with a positive bound and eps >= 0")
    return lsq_linear(*_stacked(J, v, eps), bounds=(-bound, bound), method="bvls", tol=1e-14).x


def _cost(q_dot, J, v, bound, eps):
    return ((J @ q_dot - v) ** 2).sum() + eps * (q_dot**2).sum()


def _case(rng, draw_jacobian, bound, eps):
    """Return a case in which some joints are at their bounds, some are not, and clipping afterwards
    is worse.

    Each attempt has another Jacobian, because there are some for which no velocity is such a case.
    """
    while True:
        J = draw_jacobian(rng)
        case = J, np.round(rng.uniform(-1, 1, len(J)), 2), bound, eps
        best, clipped = _right(*case), np.clip(_free(*case), -bound, bound)
        at_bound = np.abs(best) > bound - EXACT
        if (
            at_bound.any()
            and not at_bound.all()
            and _cost(clipped, *case) > 1.02 * _cost(best, *case) + 1e-4
        ):
            return case


def _any_panda_jacobian(rng):
    return panda_jacobian(np.round(rng.uniform(LOW, HIGH), 2))


def _as_hard_as(case, rng):
    """Return a case as hard as this one, whatever is drawn: its task space is rotated, and its
    joints are numbered and directed otherwise."""
    J, v, bound, eps = case
    angle = rng.uniform(0.3, 2.8)
    R = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    J = J[:, rng.permutation(J.shape[1])] * rng.choice([-1, 1], J.shape[1])
    return R @ J, R @ v, bound, eps


def _cases(rng):
    drawn = [
        _case(rng, functools.partial(away_from_zero, shape=shape), bound, eps)
        for shape, bound, eps in (((2, 3), 0.3, 0.01), ((2, 4), 0.2, 0.3), ((1, 3), 0.2, 0.01))
    ]
    drawn += [_case(rng, _any_panda_jacobian, bound, 0.01) for bound in (0.5, 0.8)]
    free = [
        (_FLAT, np.array([0.3, 0.2]), 1.0, 0.1),
        (_FLAT, np.array([0.9, 0.4]), 1.0, 4.0),
        (_FLAT, np.array([2.0, 0]), 0.004, 0.1),
        (away_from_zero(rng, (3, 5)), away_from_zero(rng, 3), 50.0, 0.02),
        (away_from_zero(rng, (2, 1)), away_from_zero(rng, 2), 0.2, 0.02),
    ]
    drawn += [_as_hard_as(case, rng) for case in (_SLOW, *_SLOWEST)]
    return [(_FLAT, np.array([2.0, 0]), 0.8, 0.1), *free, *drawn, (_FLAT, np.zeros(2), 0.5, 0.1)]


# Half of the usual ones, since an answer that iterates makes a thousand steps for each.
_GAPS = tuple(sign * gap for gap in BESIDE[::2] for sign in (1, -1))


def _beside_the_bound(rng, gap):
    """Return a case whose fastest joint, without bounds, is near the bound."""
    J, v, eps = _FLAT, np.array([0.9, 0.4]), 0.1
    fastest = np.abs(_free(J, v, 1.0, eps)).max()
    return J, v, fastest * (1 + gap), eps


_EXACT_JACOBIAN = np.array([[1.2, -0.4, 0.3], [0.5, 0.9, -0.6], [-0.2, 0.7, 1.1]])


def _small(rng, size):
    """Return a case that is _EXACT_JACOBIAN's in smaller units: the answer is the same, although
    eps is tiny. No joint is at its bound."""
    v = _EXACT_JACOBIAN @ away_from_zero(rng, 3)
    return size * _EXACT_JACOBIAN, size * v, 20.0, 0.05 * size**2


def _found(q_dot, *case):
    _, _, bound, _ = case
    least = _cost(_right(*case), *case)
    excess = _cost(q_dot, *case) - least
    if np.abs(q_dot).max() > bound + FOUR_DIGITS or excess <= 0:
        return f"Your fastest joint exceeds the bound by {np.abs(q_dot).max() - bound:.2g}."
    return f"Your answer makes this sum {excess:.2g} larger than the least sum, {least:.6g}."


_FASTER = Mistake(
    "a joint is faster than the argument `bound`",
    "Where does your code use `bound`, and for which joints?",
)
_OTHERS_ARE_BETTER = Question(
    "other velocities within the bounds are better",
    "Change a joint velocity of your answer a little, or several together, within the bounds. For "
    "which change does the sum in the task become smaller? Which sum does your code make small, "
    "and how near does it come to the least one?",
)


def _otherwise(q_dot, J, v, bound, eps):
    return _FASTER if np.abs(q_dot).max() > bound + FOUR_DIGITS else _OTHERS_ARE_BETTER


def _alike(answer, predicted, *case):
    return np.shape(answer) == np.shape(predicted) and np.allclose(
        answer, predicted, atol=FOUR_DIGITS
    )


def _cut_afterwards(cut):
    """Return the answer that cuts the best step without bounds, where it exceeds them."""

    def answer(J, v, bound, eps):
        q_dot = _free(J, v, bound, eps)
        return cut(q_dot, bound) if np.abs(q_dot).max() > bound else q_dot

    return answer


def _forwards_only(J, v, bound, eps):
    A, b = _stacked(J, v, eps)
    return lsq_linear(A, b, bounds=(0, bound), method="bvls", tol=1e-14).x


EXERCISE = declared(
    "bounded_step",
    points=2,
    arguments={"J": OWN_CASES, "v": OWN_CASES, "bound": OWN_CASES, "eps": OWN_CASES},
    cases=_cases,
    tolerance=FOUR_DIGITS,
    library=_right,
    alike=_alike,
    says="no joint velocities within `bound` make |J q_dot - v|^2 + eps |q_dot|^2 smaller",
    found=_found,
    otherwise=_otherwise,
    sweeps=(
        Sweep("a joint nearly at its bound", _beside_the_bound, _GAPS),
        Sweep("a small Jacobian and a tiny eps", _small, (0.1, 0.03, 0.01, 3e-3, 1e-3, 3e-4)),
    ),
    hints=(
        "|J q_dot - v|^2 + eps |q_dot|^2 is one sum of squares: that of A q_dot - b, with more "
        "rows than J has.",
        "A is J above sqrt(eps) I, b is v above zeros. scipy.optimize.lsq_linear minimizes |A x - "
        "b|^2 within bounds.",
        "lsq_linear(np.vstack([J, np.sqrt(eps) * np.eye(n)]), np.append(v, np.zeros(n)), "
        "bounds=(-bound, bound)).x",
    ),
    mistakes=(
        Mistake(
            "the bounds are ignored",
            "How fast is the fastest joint of your answer, and how fast may it be?",
            _free,
        ),
        Mistake(
            "the best step without bounds is clipped, or scaled down, afterwards",
            "If one joint is at its bound, could other joints do a part of its work?",
            _cut_afterwards(lambda q_dot, bound: np.clip(q_dot, -bound, bound)),
            _cut_afterwards(lambda q_dot, bound: q_dot * bound / np.abs(q_dot).max()),
        ),
        Mistake(
            "eps stands for its square root",
            "A row r of the stacked matrix adds (r q_dot)^2 to the sum. Which r makes this eps "
            "q_dot^2?",
            lambda J, v, bound, eps: _right(J, v, bound, eps**2),
        ),
        Mistake(
            "eps is left out",
            "Which of the two terms of the sum contains eps, and where does it stand in your code?",
            lambda J, v, bound, eps: _right(J, v, bound, 1e-12),
        ),
        Mistake(
            "the bounds go from 0 to `bound`",
            "May a joint move backwards?",
            _forwards_only,
        ),
    ),
)
