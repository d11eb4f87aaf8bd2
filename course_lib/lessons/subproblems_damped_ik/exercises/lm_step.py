"""lm_step: one damped least-squares step of the planar arm towards a point."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.special_cases import SMALL_NUMBERS, Sweep
from course_lib.checks.tolerances import EXACT, SOLVED
from course_lib.checks.vocabulary import angle_gap
from course_lib.lessons.subproblems_damped_ik.exercises.planar_jacobian import ARMS, jacobian, tip


def step(q, target, alpha, eps):
    """Return the angles after the step, by the smaller system of equations: it is the same step."""
    J = jacobian(q)
    return q - alpha * J.T @ np.linalg.solve(J @ J.T + eps * np.eye(2), tip(q) - target)


def allowed(q, target, alpha, eps):
    """Return how far from the right angles an answer may be: an error by rounding in J is divided
    by eps."""
    return (SOLVED + EXACT / eps) * (1 + np.abs(step(q, target, alpha, eps) - q).max())


def _cases(rng):
    bent, quarter = np.array([0, 0, 0, np.pi / 2]), np.array([np.pi / 2, 0, 0, 0])
    near, straight = np.array([0, 0, 0, 0.01]), np.zeros(4)
    named = [
        (bent, [2, 1], 1.0, 1.0),
        (bent, [3, 1], 0.2, 2.0),
        (bent, [2, 1], 0.5, 1.0),
        (bent, [2, 1], 1.0, 4.0),
    ]
    named += [
        (straight, [3, 1], 0.5, 2.0),
        (straight, [3, 0], 1.0, 0.5),
        (quarter, [1, 3], 0.2, 50.0),
    ]
    named += [(near, [3, 0.2], 1.0, 0.5), (bent, [2.2, 1.8], 0.2, 2.0), (straight, [6, 8], 0.2, 2)]
    named += [(near, [3, 0.2], 0.1, 0.01), (np.array([0.2, 3, 3, 3]), [1, 1], 0.2, 2.0)]
    sizes = zip((0.2, 0.7, 1.5, 0.4, 0.3, 0.1), (2.0, 0.5, 10.0, 0.1, 0.02, 30.0), strict=True)
    bends = rng.uniform(0.3, 1.5, (6, 4)) * rng.choice([-1, 1], (6, 4))
    drawn = [
        (q, rng.uniform(-2, 2, 2), alpha, eps) for q, (alpha, eps) in zip(bends, sizes, strict=True)
    ]
    there = rng.uniform(0.3, 1.5, 4)
    ends = [
        (there, tip(there), 1.0, 0.3),
        (there, tip(there) + 4e-4, 1.0, 0.3),
        (straight, [3, 1], 1.0, 1e-6),
        (drawn[0][0], [1, 1], 0.1, 1e-6),
    ]
    ends += [
        (np.array([7.0, -8, 20, -1]), [-1, 2], 0.6, 1.5),
        (np.array([1, 0, -1, 2]), [0, 3], 0.5, 2.0),
    ]
    ends += [(near, [3, 0.2], 0.05, 1e-4), (near, [3, 0.2], 0.01, 1e-6)]
    return [
        (q, np.array(target, float), alpha, eps) for q, target, alpha, eps in named + drawn + ends
    ]


def _small(rng, size):
    """Small angles, and a target nearby, so that the angles stay small."""
    q, beside = size * rng.uniform(-0.9, 0.9, 4), size * rng.uniform(-0.9, 0.9, 2)
    return q, tip(q) + beside, 0.5, 2.0


def _there(q, target, alpha, eps):
    return np.abs(tip(q) - target).max() < 1e-12


def _right(answer, *case):
    return angle_gap(answer, step(*case)) < allowed(*case)


def _motion(answer, q, *rest):
    wanted = step(q, *rest) - q
    moved = answer - q
    j = int(np.argmax(np.abs(np.exp(1j * moved) - np.exp(1j * wanted)) > allowed(q, *rest)))
    return (
        f"Joint {j + 1} should move by {wanted[j]:.5g} rad; in your answer it moves by "
        f"{moved[j]:.5g}."
    )


def _same(answer, predicted, *case):
    """Return whether an answer is that of a mistake."""
    share = (
        1e-6 if case[3] > 1e-3 else 1e-3
    )  # with a small eps, rounding tells ways of computing apart
    size = 1 + np.abs(predicted - case[0]).max()
    return angle_gap(answer, predicted) < min(share * size, 0.01)


WRAPPED = Mistake(
    "the angles are wrapped, so that they jump by 2 pi",
    "The path of a joint is its angle over time, without jumps: which line changes an angle by 2 "
    "pi?",
)
_SINGULAR = Mistake(
    "a matrix is inverted that has no inverse",
    "J^T J has rank 2 at most. What has to be added to which of its entries to make it invertible?",
)

EXERCISE = Exercise(
    name="lm_step",
    points=2,
    arguments=("q", "target", "alpha", "eps"),
    tolerance=SOLVED,
    cases=_cases,
    sweeps=(Sweep("small angles", _small, SMALL_NUMBERS),),
    angles=("q",),
    returns=numbers(lambda *case: (4,)),
    library=step,
    alike=_same,
    properties=(
        Property("at the target nothing moves: the answer is q", _right, _motion, where=_there),
        Property(
            "the answer is q - alpha (J^T J + eps I)^-1 J^T (p(q) - target)",
            _right,
            _motion,
            where=lambda *case: not _there(*case),
            mistake=Mistake(
                "the step is not the damped one",
                "Which matrix is inverted, what does alpha multiply, and is a large or a small "
                "step treated otherwise?",
            ),
        ),
        Property(
            "the angles are not wrapped: the answer is q and a small step",
            lambda answer, *case: np.abs(answer - step(*case)).max() < 1,
            mistake=WRAPPED,
        ),
    ),
    hints=(
        "J = planar_jacobian(q), e = tip(q) - target.",
        "The matrix is J.T @ J + eps * np.eye(4), the right side J.T @ e.",
        "q - alpha * np.linalg.solve(matrix, right side): a new array, so that q stays as it is.",
    ),
    forbidden=("course_lib.ik.damped_path", "course_lib.ik._damped_step", *ARMS),
)

EXERCISE.mistake(_SINGULAR, raises=("LinAlgError", "ingular"))


def _solves_another(answer, q, target, alpha, eps):
    """Return whether the step solves the equations undamped, or damped in every entry, or is as
    large as rounding."""
    J, moved = jacobian(q), answer - q
    right_side = alpha * J.T @ (tip(q) - target)
    if np.abs(moved).max() > 1e6 * (1 + np.abs(step(q, target, alpha, eps)).max()):
        return True
    missed = [np.abs(M @ moved + right_side).max() for M in (J.T @ J, J.T @ J + eps)]
    return min(missed) < 1e-6 * (1 + np.abs(moved).max()) and not _right(
        answer, q, target, alpha, eps
    )


@EXERCISE.mistake(
    "J^T J is not damped: eps is not used, or it is added elsewhere than on the diagonal",
    "J^T J is 4 x 4 and has rank 2 at most. What has to be added to which of its entries to make "
    "it invertible?",
    share=(0, 1),
    seen=_solves_another,
)
def not_damped(q, target, alpha, eps, share):
    J = jacobian(q)
    return q - alpha * np.linalg.pinv(J.T @ J + share * eps) @ J.T @ (tip(q) - target)


@EXERCISE.mistake(
    "eps is added in another way, squared or as a root",
    "How does eps stand in J^T J + eps I?",
    changed=(np.square, np.sqrt),
)
def other_damping(q, target, alpha, eps, changed):
    return step(q, target, alpha, changed(eps))


@EXERCISE.mistake(
    "the step is one of gradient descent, alpha J^T e",
    "Which matrix stands before J^T?",
)
def gradient_step(q, target, alpha, eps):
    return q - alpha * jacobian(q).T @ (tip(q) - target)
