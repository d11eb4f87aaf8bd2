"""lm_step: one damped least-squares step of the planar arm towards a point."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.kinds import OWN_CASES, QUARTER, quarters, whole_numbers
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import SMALL_NUMBERS, Sweep
from course_lib.checks.tolerances import EXACT, SOLVED
from course_lib.checks.vocabulary import angle_gap, compared
from course_lib.lessons.subproblems_damped_ik.exercises.planar_jacobian import ARMS, jacobian, tip

_BENT, _STRAIGHT = np.array([0, 0, 0, QUARTER]), np.zeros(4)
_NEARLY_STRAIGHT = np.array([0, 0, 0, 0.01])


def step(q, target, alpha, eps):
    """Return the angles after the step, by the smaller system of equations: it is the same step."""
    J = jacobian(q)
    return q - alpha * J.T @ np.linalg.solve(J @ J.T + eps * np.eye(2), tip(q) - target)


def allowed(q, target, alpha, eps):
    """Return how far from the right angles an answer may be: an error by rounding in J is divided
    by eps."""
    return (SOLVED + EXACT / eps) * (1 + np.abs(step(q, target, alpha, eps) - q).max())


def _cases(rng):
    there = rng.uniform(0.3, 1.5, 4)
    named = [
        (_BENT, [2, 1], 1.0, 1.0),
        (_BENT, [3, 1], 0.2, 2.0),
        (_BENT, [2, 1], 1.0, 4.0),
        (_STRAIGHT, [3, 1], 0.5, 2.0),
        (np.array([QUARTER, 0, 0, 0]), [1, 3], 0.2, 50.0),
        (_STRAIGHT, [6, 8], 0.2, 2.0),
        (there, tip(there), 1.0, 0.3),
        (_STRAIGHT, [3, 1], 1.0, 1e-6),
        (np.array([7.0, -8, 20, -1]), [-1, 2], 0.6, 1.5),
        (np.array([1, 0, -1, 2]), [0, 3], 0.5, 2.0),
        (_NEARLY_STRAIGHT, [3, 0.2], 0.05, 1e-4),  # a step of more than 2 rad
        (_NEARLY_STRAIGHT, [3, 0.2], 1.0, 1e-4),  # and one of almost 50 rad
        (_NEARLY_STRAIGHT, [3, 0.2], 0.01, 1e-6),
    ]
    drawn = [
        (rng.uniform(0.3, 1.5, 4) * rng.choice([-1, 1], 4), rng.uniform(-2, 2, 2), alpha, eps)
        for alpha, eps in ((0.2, 2.0), (0.7, 0.5), (1.5, 10.0), (0.4, 0.1), (0.3, 0.02), (0.1, 30))
    ]
    return [(q, np.array(target, float), alpha, eps) for q, target, alpha, eps in named + drawn]


def _small_angles(rng, size):
    """Return small angles, and a target nearby, so that the angles stay small."""
    q, beside = size * rng.uniform(-0.9, 0.9, 4), size * rng.uniform(-0.9, 0.9, 2)
    return q, tip(q) + beside, 0.5, 2.0


def _nearby(rng, size):
    """Return a target at a small distance."""
    q = rng.uniform(0.3, 1.5, 4)
    return q, tip(q) + size * rng.uniform(0.3, 0.9, 2), 0.7, 0.3


def _little_damping(rng, eps):
    """Return an arm so nearly straight that the square of its smaller singular value is about eps,
    and a target at which it arrives by a step of about half a radian."""
    root = np.sqrt(eps)
    q = np.array([0, 0, 0, root])
    return q, tip(q) - root * rng.uniform([1.8, -0.2], [2.2, 0.2]), 0.5, eps


def _motion(answer, q, *rest):
    wanted = step(q, *rest) - q
    moved = answer - q
    j = int(np.argmax(np.abs(moved - wanted) > allowed(q, *rest)))
    return f"The change of joint {j + 1} (rad) should be " + compared(wanted[j], moved[j]) + "."


def _is_alike(answer, predicted, *case):
    """Return whether an answer is that of a mistake; with a small eps, rounding tells ways of
    computing apart."""
    share = 1e-6 if case[3] > 1e-3 else 1e-3
    size = 1 + np.abs(predicted - case[0]).max()
    return angle_gap(answer, predicted) < min(share * size, 0.01)


def _is_wrapped(answer, *case):
    return angle_gap(answer, step(*case)) < allowed(*case)


def _solves_another(answer, q, target, alpha, eps):
    """Return whether the step solves the equations undamped, or damped in every entry, so well that
    eps would show, or is as large as rounding makes it."""
    J, moved = jacobian(q), answer - q
    right_side = alpha * J.T @ (tip(q) - target)
    if np.abs(moved).max() > 1e6 * (1 + np.abs(step(q, target, alpha, eps)).max()):
        return True
    missed = [np.abs(M @ moved + right_side).max() for M in (J.T @ J, J.T @ J + eps)]
    return min(missed) < 1e-3 * eps * np.abs(moved).max()


def _undamped(share):
    """Return the step in whose equations share(eps) is added to every entry."""

    def answer(q, target, alpha, eps):
        J = jacobian(q)
        return q - alpha * np.linalg.pinv(J.T @ J + share * eps) @ J.T @ (tip(q) - target)

    return answer


def _with_damping(changed):
    return lambda q, target, alpha, eps: step(q, target, alpha, changed(eps))


def _gradient_step(q, target, alpha, eps):
    return q - alpha * jacobian(q).T @ (tip(q) - target)


def _special(rng):
    return quarters(rng, 4), whole_numbers(rng, 2), float(rng.integers(1, 5) / 4), 0.5


EXERCISE = declared(
    "lm_step",
    points=2,
    arguments={
        "q": OWN_CASES.but(angle=True, free=True),
        "target": OWN_CASES.but(free=True),
        "alpha": OWN_CASES.but(free=True),
        "eps": OWN_CASES.but(free=True),
    },
    cases=_cases,
    sweeps=(
        Sweep("small angles", _small_angles, SMALL_NUMBERS),
        Sweep("a target nearby", _nearby, SMALL_NUMBERS),
        Sweep("little damping near a singularity", _little_damping, SMALL_NUMBERS),
    ),
    special=_special,
    tolerance=SOLVED,
    allowed=allowed,
    library=step,
    alike=_is_alike,
    says="the answer is q - alpha (J^T J + eps I)^-1 J^T (p(q) - target)",
    found=_motion,
    otherwise=Question(
        "the step is not the damped one",
        "Compute this step in parts: p(q) and the target as they are given, their difference, J, "
        "the matrix that is inverted, and what alpha multiplies. Which part differs in your code?",
    ),
    hints=(
        "J = planar_jacobian(q), e = tip(q) - target.",
        "The matrix is J.T @ J + eps * np.eye(4), the right side J.T @ e.",
        "q - alpha * np.linalg.solve(matrix, right side): a new array, so that q stays as it is.",
    ),
    forbidden=("course_lib.ik.damped_path", "course_lib.ik._damped_step", *ARMS),
    mistakes=(
        Mistake(
            "the angles are wrapped, so that they jump by 2 pi",
            "The path of a joint is its angle over time, without jumps: which line changes an "
            "angle by 2 pi?",
            seen=_is_wrapped,
        ),
        Mistake(
            "a matrix is inverted that has no inverse",
            "J^T J has rank 2 at most. What has to be added to which of its entries to make it "
            "invertible?",
            raises=("LinAlgError", "ingular"),
        ),
        Mistake(
            "J^T J is not damped: eps is not used, or it is added elsewhere than on the diagonal",
            "J^T J is 4 x 4 and has rank 2 at most. What has to be added to which of its entries "
            "to make it invertible?",
            *map(_undamped, (0, 1)),
            seen=_solves_another,
        ),
        Mistake(
            "eps is added in another way, squared or as a root",
            "How does eps stand in J^T J + eps I?",
            *map(_with_damping, (np.square, np.sqrt)),
        ),
        Mistake(
            "the step is one of gradient descent, alpha J^T e",
            "Which matrix stands before J^T?",
            _gradient_step,
        ),
    ),
)
