"""ik_step_dls: one damped least-squares step of the joint angles."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.panda_dh_ik.shared import PANDA, panda_jacobian
from course_lib.checks.vocabulary import angle_gap, few_digits, whole_numbers, wrong_steps

_FLAT = np.array([[1.0, 0, 0], [0, 1, 0]])
_SQUARE = np.array([[1.0, 2], [0, 1]])
_WHOLE = np.array([[0, 1, 2], [1, -1, 0]])


def panda_step(rng):
    """Return joint angles of the Panda, their Jacobian and an error."""
    q = np.round(rng.uniform(*PANDA.limits.T), 2)
    return q, panda_jacobian(q), np.round(rng.uniform(0.2, 0.9, 6) * rng.choice([-1, 1], 6), 2)


def _some_step(rng, m, n):
    """Return angles (n,), one of them beyond pi, a matrix (m, n) and an error (m,), none of their entries small."""
    drawn = (rng.uniform(0.3, 1.2, size) * rng.choice([-1, 1], size) for size in (n, (m, n), m))
    q, J, e = (np.round(array, 2) for array in drawn)
    q[-1] += 3
    return q, J, e


def step_of(q, J, e, eps):
    """Return the angles after the step, by singular values: nothing is lost to rounding."""
    U, s, Vt = np.linalg.svd(J, full_matrices=False)
    return q + Vt.T @ (s / (s**2 + eps) * (U.T @ e))


def _allowed(q, J, e, eps):
    """Return the error that a right answer may have: what rounding in J^T J does is divided by eps."""
    size = 1 + np.abs(step_of(q, J, e, eps)).max()
    return (1e-9 + 1e-14 * np.linalg.norm(J, 2) ** 2 / eps) * size


def _cases(rng):
    some, low = np.array([0.5, -0.5, 2]), np.array([[1.0, 0, 0], [0, 1e-3, 0]])
    named = [
        (some, _FLAT, [1, 2], 0.25),
        (np.zeros(3), _FLAT, [1, 2], 1.0),
        (np.array([1.0, 2]), _SQUARE, [1, 3], 0.5),
        (np.array([8.0, -9]), _SQUARE, [1, 3], 2.0),
    ]
    sizes = ((2, 4), 0.3), ((1, 3), 1.5), ((3, 3), 0.05), ((6, 6), 0.7), ((3, 2), 0.4), ((6, 4), 0.01)
    drawn = [(*_some_step(rng, *size), eps) for size, eps in sizes]
    drawn += [(*panda_step(rng), eps) for eps in (0.3, 0.01, 1e-4, 4.0)]
    q, J, _ = panda_step(rng)
    ends = [(some, _FLAT, [0, 0], 0.25), (some, _FLAT, [1e-5, 2e-5], 0.25), (some, _FLAT[[0, 0]], [1, 2], 0.25)]
    ends += [(q, J, np.zeros(6), 0.3), (np.zeros(7), panda_jacobian(np.zeros(7)), np.ones(6), 0.1)]
    ends += [(some, low, [1, 2e-3], 1e-6), (some, low, [1, 0.2], 1e-4), (some, low**2, [1, 2e-6], 1e-12)]
    ends += [(*panda_step(rng), 1e-12), (np.array([1, 2, -1]), _WHOLE, [1, 3], 0.5)]
    return [(q, J, np.array(e, float), eps) for q, J, e, eps in [*named, *drawn, *ends]]


def _right(answer, *case):
    return angle_gap(answer, step_of(*case)) < _allowed(*case)


def _alike(answer, predicted, q, *rest):
    """Return whether an answer is what is predicted, to the digits that the step has."""
    if np.shape(answer) != np.shape(predicted):
        return False
    share = min(1e-6 * (1 + np.abs(q).max() + np.abs(predicted - q).max()), 0.01)
    return angle_gap(answer, predicted) < max(share, _allowed(q, *rest))


def _off(answer, q, *rest):
    wanted, changed = step_of(q, *rest) - q, answer - q
    j = int(np.argmax(np.abs(np.exp(1j * changed) - np.exp(1j * wanted))))
    return f"q[{j}] should change by {wanted[j]:.5g}; in your answer it changes by {changed[j]:.5g}."


def _by(step):
    """Return the answer of somebody who adds step(J, e, eps) to q."""
    return lambda q, *rest: q + step(*rest)


def _solved(matrix_of):
    """Return the answers with another matrix, matrix_of(M, eps), in place of M + eps I, in either form."""
    return (
        _by(lambda J, e, eps: np.linalg.pinv(matrix_of(J.T @ J, eps)) @ J.T @ e),
        _by(lambda J, e, eps: J.T @ np.linalg.pinv(matrix_of(J @ J.T, eps)) @ e),
    )


def _with(eps_of):
    """Return the answer with another number in place of eps."""
    return lambda q, J, e, eps: step_of(q, J, e, eps_of(eps))


def _step(J, e, eps):
    return step_of(0, J, e, eps)


def _if_square(step):
    """Return the answer by a formula that has a shape only if J is square."""
    return lambda q, J, e, eps: q + step(J, e, eps * np.eye(len(J))) if J.shape == J.T.shape else step_of(q, J, e, eps)


def _unit(e):
    return e / (np.linalg.norm(e) or 1)


def _parallel(answer, *case):
    wanted, changed = step_of(*case) - case[0], answer - case[0]
    size = wanted @ wanted
    return size > 0 and np.abs(changed - (changed @ wanted) / size * wanted).max() < _allowed(*case)


_FORMULA = "The formula has J, its transpose, e and eps I, each once as it is written above this exercise."
_SHAPES = "J is (m, n), e is (m,), q is (n,). Which product of J, or J^T, and e has the shape (n,)?"
_DIAGONAL = "The damping is eps times the unit matrix: it is added to the diagonal only."
_OUTER = Mistake("q and what is added to it differ in shape", "Arrays of shapes (n,) and (n, 1) add up to (n, n).")
_SINGULAR = Mistake(
    "a matrix is inverted that is singular, or nearly: it is not damped by eps I",
    "J^T J is never invertible if J is wide, and J J^T is not at a singularity. " + _DIAGONAL,
)
_NOT_SQUARE = Mistake("J itself is inverted", "J is not square in general. " + _FORMULA)
_OTHER_SIZE = Mistake(
    "the unit matrix, or another array, has another size than what it is added to",
    "J may have any shape (m, n): J J^T is (m, m), J^T J is (n, n).",
)
_NO_PRODUCT = Mistake("e is multiplied by a matrix of another shape", _SHAPES)
_WHOLE_NUMBERS = Mistake("q is changed in place", "q += ... writes into q itself. q + ... makes a new array.")

_MISTAKES = (
    few_digits(step_of),
    *wrong_steps(step_of),
    Mistake(
        "eps is not used: this is the step of the pseudoinverse",
        _DIAGONAL,
        _by(lambda J, e, eps: np.linalg.pinv(J) @ e),
    ),
    Mistake("eps is squared, or its root is taken", _FORMULA, _with(lambda eps: eps**2), _with(lambda eps: eps**0.5)),
    Mistake("eps is subtracted", _FORMULA, *_solved(lambda M, eps: M - eps * np.eye(len(M)))),
    Mistake("eps is multiplied by a number", _FORMULA, _with(lambda eps: 2 * eps), _with(lambda eps: eps / 2)),
    Mistake("I is added without eps", _DIAGONAL, _with(lambda eps: 1.0)),
    Mistake("eps is divided by", _FORMULA, _with(lambda eps: 1 / eps)),
    Mistake(
        "this is a step along J^T e: no equations are solved",
        _FORMULA,
        _by(lambda J, e, eps: J.T @ e),
        _by(lambda J, e, eps: eps * J.T @ e),
        _by(lambda J, e, eps: J.T @ e / eps),
        _by(lambda J, e, eps: J.T @ e / (1 + eps)),
    ),
    Mistake(
        "e is multiplied by the matrix, not by its inverse",
        "np.linalg.solve(A, b) is the x with A x = b.",
        _by(lambda J, e, eps: J.T @ (J @ J.T + eps * np.eye(len(J))) @ e),
    ),
    Mistake("eps is added to every entry of the matrix", _DIAGONAL, *_solved(lambda M, eps: M + eps)),
    Mistake(
        "the diagonal is scaled by eps, as Marquardt did",
        _DIAGONAL,
        *_solved(lambda M, eps: M + eps * np.diag(np.diag(M))),
        *_solved(lambda M, eps: (1 + eps) * M),
    ),
    Mistake(
        "eps is added to J, before the pseudoinverse",
        _DIAGONAL,
        _by(lambda J, e, eps: np.linalg.pinv(J + eps * np.eye(*J.shape)) @ e),
        _by(lambda J, e, eps: np.linalg.pinv(J + eps) @ e),
    ),
    Mistake(
        "eps damps the step as a whole, not the matrix",
        _DIAGONAL,
        _by(lambda J, e, eps: eps * _step(J, e, eps)),
        _by(lambda J, e, eps: _step(J, e, eps) / (1 + eps)),
        _by(lambda J, e, eps: eps * np.linalg.pinv(J) @ e),
    ),
    Mistake(
        "e is divided by its length",
        "Near the target the step is to get small, as e does.",
        _by(lambda J, e, eps: _step(J, _unit(e), eps)),
    ),
    Mistake(
        "J and J^T are swapped, which shows only if J is square",
        _FORMULA,
        _if_square(lambda J, e, D: J @ np.linalg.solve(J.T @ J + D, e)),
        _if_square(lambda J, e, D: J.T @ np.linalg.solve(J.T @ J + D, e)),
        _if_square(lambda J, e, D: np.linalg.solve(J @ J.T + D, J.T @ e)),
        _if_square(lambda J, e, D: np.linalg.solve(J.T @ J + D, J @ e)),
    ),
    Mistake(
        "a square J is inverted without damping",
        "The task asks for damping whatever the shape of J.",
        _if_square(lambda J, e, D: np.linalg.pinv(J) @ e),
    ),
    Mistake(
        "eps is never below a least value of your own",
        "Use eps as it is given, however small.",
        *(_with(lambda eps, least=least: max(eps, least)) for least in 10.0 ** np.arange(-11, -1)),
    ),
    Mistake(
        "eps is a fixed number",
        "Use the eps that is given.",
        *(_with(lambda eps, fixed=fixed: fixed) for fixed in 10.0 ** np.arange(-12, 0)),
    ),
    Mistake(
        "the angles are kept inside limits",
        "This function knows no limits: panda_ik handles them, after the step.",
        lambda *case: np.clip(step_of(*case), -np.pi, np.pi),
        lambda q, *rest: np.clip(step_of(q, *rest), *PANDA.limits.T) if len(q) == 7 else None,
    ),
    Mistake(
        "degrees and radians are mixed up",
        "Angles are in radians throughout.",
        *(_by(lambda *c, to=to: to(_step(*c))) for to in (np.rad2deg, np.deg2rad)),
        *(lambda *case, to=to: to(step_of(*case)) for to in (np.rad2deg, np.deg2rad)),
    ),
    whole_numbers(step_of),
    Mistake(
        _SINGULAR.name,
        _SINGULAR.hint,
        seen=lambda answer, *case: np.abs(answer).max() > 1e6 * (1 + np.abs(step_of(*case)).max()),
    ),
    Mistake("the step has the right direction and a wrong length", "Is there a factor too many?", seen=_parallel),
)

EXERCISE = Exercise(
    name="ik_step_dls",
    points=1,
    arguments=("q", "J", "e", "eps"),
    cases=_cases,
    returns=numbers(
        lambda q, *rest: (len(q),),
        lambda array, q, J, *rest: _OUTER if array.shape in ((len(q), len(q)), J.T.shape) else None,
    ),
    properties=(
        Property("the answer is q + J^T (J J^T + eps I)^-1 e", _right, _off, where=lambda q, J, e, eps: e.any()),
        Property("if e is 0, the angles stay as they are", _right, _off),
    ),
    mistakes=_MISTAKES,
    hints=(
        "J J^T is (m, m), with m the number of rows of J. The unit matrix has to have that size too.",
        "Solve (J J^T + eps I) x = e: x = np.linalg.solve(J @ J.T + eps * np.eye(len(e)), e).",
        "The step is J.T @ x. Add it to q: a new array, so that q stays as it is.",
    ),
    library=step_of,
    alike=_alike,
    forbidden=("course_lib.ik.damped_path",),
    errors=(
        ("LinAlgError", "Singular", _SINGULAR),
        ("LinAlgError", "square", _NOT_SQUARE),
        ("ValueError", "core dimension", _NO_PRODUCT),
        ("ValueError", "not aligned", _NO_PRODUCT),
        ("ValueError", "broadcast", _OTHER_SIZE),
        ("UFuncTypeError", "", _WHOLE_NUMBERS),
    ),
)
