"""lm_step: one damped least-squares step of the planar arm towards a point."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.subproblems_damped_ik.planar_jacobian import ARMS, jacobian, tip
from course_lib.checks.vocabulary import wrong_steps


def step(q, target, alpha, eps):
    """Return the angles after the step, by the smaller system of equations: it is the same step."""
    J = jacobian(q)
    return q - alpha * J.T @ np.linalg.solve(J @ J.T + eps * np.eye(2), tip(q) - target)


def allowed(q, target, alpha, eps):
    """Return how far beside the right angles an answer may be: what rounding in J does is divided by eps."""
    return (1e-8 + 1e-9 / eps) * (1 + np.abs(step(q, target, alpha, eps) - q).max())


def off(angles, wanted):
    """Return how far angles are from those wanted, up to multiples of 2 pi."""
    return np.abs(np.angle(np.exp(1j * (np.asarray(angles) - wanted)))).max()


def _cases(rng):
    bent, quarter = np.array([0, 0, 0, np.pi / 2]), np.array([np.pi / 2, 0, 0, 0])
    near, straight = np.array([0, 0, 0, 0.01]), np.zeros(4)
    named = [(bent, [2, 1], 1.0, 1.0), (bent, [3, 1], 0.2, 2.0), (bent, [2, 1], 0.5, 1.0), (bent, [2, 1], 1.0, 4.0)]
    named += [(straight, [3, 1], 0.5, 2.0), (straight, [3, 0], 1.0, 0.5), (quarter, [1, 3], 0.2, 50.0)]
    named += [(near, [3, 0.2], 1.0, 0.5), (bent, [2.2, 1.8], 0.2, 2.0), (straight, [6, 8], 0.2, 2)]
    named += [(near, [3, 0.2], 0.1, 0.01), (np.array([0.2, 3, 3, 3]), [1, 1], 0.2, 2.0)]
    drawn = [
        (q, rng.uniform(-2, 2, 2), alpha, eps)
        for q, alpha, eps in zip(
            rng.uniform(0.3, 1.5, (6, 4)) * rng.choice([-1, 1], (6, 4)),
            (0.2, 0.7, 1.5, 0.4, 0.3, 0.1),
            (2.0, 0.5, 10.0, 0.1, 0.02, 30.0),
            strict=True,
        )
    ]
    there = rng.uniform(0.3, 1.5, 4)
    ends = [(there, tip(there), 1.0, 0.3), (straight, [3, 1], 1.0, 1e-6), (drawn[0][0], [1, 1], 0.1, 1e-6)]
    ends += [(np.array([7.0, -8, 20, -1]), [-1, 2], 0.6, 1.5), (np.array([1, 0, -1, 2]), [0, 3], 0.5, 2.0)]
    ends += [(near, [3, 0.2], 0.05, 1e-4), (near, [3, 0.2], 0.01, 1e-6)]
    return [(q, np.array(target, float), alpha, eps) for q, target, alpha, eps in named + drawn + ends]


def _there(q, target, alpha, eps):
    return np.abs(tip(q) - target).max() < 1e-12


def _right(answer, *case):
    return off(answer, step(*case)) < allowed(*case)


def _motion(answer, q, *rest):
    wanted = step(q, *rest) - q
    moved = answer - q
    j = int(np.argmax(np.abs(np.exp(1j * moved) - np.exp(1j * wanted)) > allowed(q, *rest)))
    return f"Joint {j + 1} should move by {wanted[j]:.5g} rad; in your answer it moves by {moved[j]:.5g}."


def _same(answer, predicted, *case):
    """Return whether an answer is that of a mistake; not if the mistake makes no difference in this case."""
    share = 1e-6 if case[3] > 1e-3 else 1e-3  # with a small eps, rounding tells ways of computing apart
    size = 1 + np.abs(predicted - case[0]).max()
    return off(answer, predicted) < min(share * size, 0.01) and not _right(predicted, *case)


def _by(step_of):
    """The angles of somebody who subtracts step_of(J, e, alpha, eps)."""
    return lambda q, target, alpha, eps: q - step_of(jacobian(q), tip(q) - target, alpha, eps)


def _solved(matrix_of):
    """The angles with another matrix, matrix_of(J^T J, eps), in place of J^T J + eps I."""
    return _by(lambda J, e, alpha, eps: alpha * np.linalg.solve(matrix_of(J.T @ J, eps), J.T @ e))


def _with(change):
    """The angles with other numbers in place of alpha and eps."""
    return lambda q, target, alpha, eps: step(q, target, *change(alpha, eps))


def _not_summed(q, target, alpha, eps):
    links = np.array([-np.sin(q), np.cos(q)])
    J = np.cumsum(links[:, ::-1], axis=1)[:, ::-1]
    e = np.array([np.cos(q).sum(), np.sin(q).sum()]) - target
    return q - alpha * J.T @ np.linalg.solve(J @ J.T + eps * np.eye(2), e)


def _solution_of(mistake, matrix_of):
    """The mistake again, for those whose step solves matrix_of(J^T J, eps) x = alpha J^T e in another way."""

    def seen(answer, q, target, alpha, eps):
        J = jacobian(q)
        moved = answer - q
        missed = matrix_of(J.T @ J, eps) @ moved + alpha * J.T @ (tip(q) - target)
        small = np.abs(missed).max() < 1e-6 * (1 + np.abs(moved).max())
        return small and not _there(q, target, alpha, eps)

    return Mistake(mistake.name, mistake.hint, seen=seen)


def _parallel(answer, *case):
    wanted, moved = step(*case) - case[0], answer - case[0]
    size = wanted @ wanted
    return size > 0 and np.abs(moved - (moved @ wanted) / size * wanted).max() < allowed(*case)


WRAPPED = Mistake(
    "the angles are wrapped, so that they jump by 2 pi",
    "The path of a joint is its angle over time, without jumps: keep the angles as the steps make them.",
)
_I = np.eye(4)

_NO_EPS = Mistake(
    "eps is not used: this is the Gauss-Newton step",
    "eps is added to the diagonal of J^T J.",
    _by(lambda J, e, alpha, eps: alpha * np.linalg.pinv(J) @ e),
)
_EVERY_ENTRY = Mistake(
    "eps is added to every entry of the matrix",
    "Only the diagonal is damped: eps * np.eye(4), not eps.",
    _by(lambda J, e, alpha, eps: alpha * np.linalg.pinv(J.T @ J + eps) @ J.T @ e),
    _by(lambda J, e, alpha, eps: alpha * J.T @ np.linalg.solve(J @ J.T + eps, e)),
)

WRONG_STEPS = (
    *wrong_steps(step),
    _NO_EPS,
    Mistake(
        "eps is squared, or its root is taken",
        "eps stands in the formula as it is: J^T J + eps I.",
        _with(lambda alpha, eps: (alpha, eps**2)),
        _with(lambda alpha, eps: (alpha, eps**0.5)),
    ),
    Mistake("eps is subtracted", "J^T J + eps I, with a plus.", _solved(lambda M, eps: M - eps * _I)),
    Mistake("alpha is missing", "The whole step is multiplied by alpha.", _with(lambda alpha, eps: (1.0, eps))),
    Mistake("alpha is squared", "The step is multiplied by alpha once.", _with(lambda alpha, eps: (alpha**2, eps))),
    Mistake("alpha is divided by", "The step is multiplied by alpha.", _with(lambda alpha, eps: (1 / alpha, eps))),
    Mistake("alpha and eps are swapped", "lm_step(q, target, alpha, eps).", _with(lambda alpha, eps: (eps, alpha))),
    Mistake(
        "this is gradient descent: the matrix J^T J + eps I is left out",
        "Solve (J^T J + eps I) x = J^T e for x. The step is alpha x.",
        _by(lambda J, e, alpha, eps: alpha * J.T @ e),
        _by(lambda J, e, alpha, eps: alpha / eps * J.T @ e),
    ),
    Mistake(
        "the matrix is multiplied by, not divided by",
        "Solve (J^T J + eps I) x = J^T e for x: np.linalg.solve.",
        _by(lambda J, e, alpha, eps: alpha * (J.T @ J + eps * _I) @ J.T @ e),
    ),
    _EVERY_ENTRY,
    Mistake(
        "the diagonal is scaled by eps, as Marquardt did",
        "Here eps is added, to each entry of the diagonal.",
        _solved(lambda M, eps: M + eps * np.diag(np.diag(M))),
        _by(lambda J, e, alpha, eps: alpha * np.linalg.pinv((1 + eps) * J) @ e),
    ),
    Mistake(
        "each entry of the matrix is inverted by itself",
        "The inverse of a matrix is np.linalg.inv(M), not 1 / M.",
        _by(lambda J, e, alpha, eps: alpha * (1 / (J.T @ J + eps * _I)) @ J.T @ e),
    ),
    Mistake(
        "alpha multiplies q as well",
        "Only the step is multiplied by alpha.",
        lambda q, target, alpha, eps: alpha * step(q, target, 1.0, eps),
        lambda q, target, alpha, eps: (1 - alpha) * q + alpha * (step(q, target, 1.0, eps) - q),
    ),
    Mistake(
        "the error is divided by its length",
        "The step is made of e itself: near the target it gets small.",
        _by(lambda J, e, alpha, eps: alpha * J.T @ np.linalg.solve(J @ J.T + eps * np.eye(2), e / np.linalg.norm(e))),
    ),
    Mistake(
        "the error is not p(q) - target",
        "e = tip(q) - target: where the tip is, less where it should be.",
        lambda q, target, alpha, eps: step(q, 0 * target, alpha, eps),
        lambda q, target, alpha, eps: 2 * q - step(q, tip(q) + target, alpha, eps),
        lambda q, target, alpha, eps: step(q, tip(q) + target, alpha, eps),
        lambda q, target, alpha, eps: step(q, -target, alpha, eps),
        lambda q, target, alpha, eps: step(q, target[::-1], alpha, eps),
    ),
    Mistake(
        "eps is added to the step, not to the matrix",
        "eps belongs to the diagonal of J^T J: J^T J + eps I.",
        _by(lambda J, e, alpha, eps: alpha * (np.linalg.pinv(J) @ e + eps)),
        _by(lambda J, e, alpha, eps: alpha * np.linalg.pinv(J) @ e + eps),
        _by(lambda J, e, alpha, eps: alpha * np.linalg.pinv(J) @ e - eps),
    ),
    Mistake(
        "the distance is taken for both coordinates of the error",
        "e = tip(q) - target is a vector of two numbers. Its length alone has no direction.",
        _by(
            lambda J, e, alpha, eps: (
                alpha * J.T @ np.linalg.solve(J @ J.T + eps * np.eye(2), np.full(2, np.linalg.norm(e)))
            )
        ),
    ),
    Mistake(
        "the angles are not summed: link i points along q1 + ... + qi",
        "tip(q) is there, and planar_jacobian(q).",
        _not_summed,
    ),
    Mistake(
        "degrees and radians are mixed up",
        "Angles are radians everywhere: no np.deg2rad, no np.rad2deg.",
        lambda *case: case[0] + np.rad2deg(step(*case) - case[0]),
        lambda *case: case[0] + np.deg2rad(step(*case) - case[0]),
        lambda *case: np.rad2deg(step(*case)),
    ),
)

EXERCISE = Exercise(
    name="lm_step",
    points=2,
    arguments=("q", "target", "alpha", "eps"),
    cases=_cases,
    returns=numbers(lambda *case: (4,)),
    properties=(
        Property("at the target nothing moves: the answer is q", _right, _motion, where=_there),
        Property(
            "the answer is q - alpha (J^T J + eps I)^-1 J^T (p(q) - target)",
            _right,
            _motion,
            where=lambda *case: not _there(*case),
        ),
        Property(
            "the angles are not wrapped: the answer is q and a small step",
            lambda answer, *case: np.abs(answer - step(*case)).max() < 1,
            mistake=WRAPPED,
        ),
    ),
    mistakes=(
        Mistake(
            "digits after the point are cut off",
            "np.array([1, 0, -1, 2]) holds whole numbers only: np.array(q, float).",
            seen=lambda answer, q, *rest: q.dtype.kind == "i" and np.array_equal(answer, np.trunc(answer)),
        ),
        *WRONG_STEPS,
        _solution_of(_NO_EPS, lambda M, eps: M),
        _solution_of(_EVERY_ENTRY, lambda M, eps: M + eps),
        Mistake(
            "a matrix is inverted that has no inverse: eps is missing in J^T J + eps I",
            "J^T J is 4 x 4 and of rank 2 at most. eps * np.eye(4), added to it, makes it invertible.",
            seen=lambda answer, *case: np.abs(answer).max() > 1e6 * (1 + np.abs(step(*case)).max()),
        ),
        Mistake(
            "the step has the right direction and a wrong length",
            "Print your step for this input, and alpha: is there a factor that does not belong?",
            seen=_parallel,
        ),
    ),
    alike=_same,
    library=step,
    hints=(
        "J = planar_jacobian(q), e = tip(q) - target.",
        "The matrix is J.T @ J + eps * np.eye(4), the right side J.T @ e.",
        "q - alpha * np.linalg.solve(matrix, right side): a new array, so that q stays as it is.",
    ),
    errors=(("LinAlgError", "ingular", _EVERY_ENTRY),),
    forbidden=("course_lib.ik.damped_path", "course_lib.ik._damped_step", *ARMS),
)
