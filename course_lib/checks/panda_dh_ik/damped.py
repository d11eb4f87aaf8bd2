"""ik_step_dls: one damped least-squares step of the joint angles."""

import numpy as np

from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.panda_dh_ik.downhill import (
    FLAT,
    NO_PRODUCTS,
    SQUARE,
    WHOLE,
    WHOLE_NUMBERS,
    clipped,
    cut_off,
    halves_exchanged,
    in_degrees,
    panda_jacobian,
    panda_step,
    read,
    some_step,
    turns,
    unit_or_zero,
)
from course_lib.checks.poe_kuka_iiwa.chains import few_digits
from course_lib.checks.subproblems_damped_ik.damped_step import off


def step_of(q, J, e, eps):
    """Return the angles after the step, by singular values: nothing is lost to rounding."""
    U, s, Vt = np.linalg.svd(J, full_matrices=False)
    return q + Vt.T @ (s / (s**2 + eps) * (U.T @ e))


def allowed(q, J, e, eps):
    """Return how far beside the right angles an answer may be: what rounding in J^T J does is divided by eps."""
    size = 1 + np.abs(step_of(q, J, e, eps)).max()
    return (1e-9 + 1e-14 * np.linalg.norm(J, 2) ** 2 / eps) * size


def _cases(rng):
    some, low = np.array([0.5, -0.5, 2]), np.array([[1.0, 0, 0], [0, 1e-3, 0]])
    named = [
        (np.zeros(3), FLAT, [1, 2], 1.0),
        (some, FLAT, [1, 2], 0.25),
        (some, FLAT, [0, 0], 0.25),
        (some, FLAT, [1e-5, 2e-5], 0.25),
        (np.array([1.0, 2]), SQUARE, [1, 3], 0.5),
        (np.array([8.0, -9]), SQUARE, [1, 3], 2.0),
        (some, FLAT[[0, 0]], [1, 2], 0.25),
        (np.array([1, 2, -1]), WHOLE, [1, 3], 0.5),
    ]
    sizes = ((2, 4), 0.3), ((1, 3), 1.5), ((3, 3), 0.05), ((6, 6), 0.7), ((3, 2), 0.4), ((6, 4), 0.01)
    drawn = [(*some_step(rng, *size), eps) for size, eps in sizes]
    drawn += [(*panda_step(rng), eps) for eps in (0.3, 0.01, 1e-3, 1e-4, 4.0)]
    q, J, _ = panda_step(rng)
    stretched = np.zeros(7)  # a singular posture
    ends = [(q, J, np.zeros(6), 0.3), (stretched, panda_jacobian(stretched), np.ones(6), 0.1)]
    ends += [(some, low, [1, 2e-3], 1e-6), (some, low, [1, 0.2], 1e-4), (some, low**2, [1, 2e-6], 1e-12)]
    ends += [(*panda_step(rng), eps) for eps in (1e-6, 1e-12)]
    return [(q, J, np.array(e, float), eps) for q, J, e, eps in [*named, *drawn, *ends]]


def _right(answer, *case):
    return off(answer, step_of(*case)) < allowed(*case)


def _there(q, J, e, eps):
    return not e.any()


def _like(words, *ways):
    """One mistake, name and hint in `words`, made by adding way(J, e, eps) to q; None where it says nothing."""

    def seen(way):
        def matches(answer, q, J, e, eps):
            step = way(J, e, eps)
            share = min(1e-6 * (1 + np.abs(q).max() + np.abs(step).max()), 0.01)
            return off(answer, q + step) < max(share, allowed(q, J, e, eps))

        return matches

    return tuple(Mistake(*words, lambda q, *rest, way=way: q + way(*rest), seen(way)) for way in ways)


def _solved(matrix_of):
    """The step with another matrix, matrix_of(M, eps), in place of M + eps I, in either form."""

    def by_joints(J, e, eps):
        return np.linalg.pinv(matrix_of(J.T @ J, eps)) @ J.T @ e

    def by_errors(J, e, eps):
        return J.T @ np.linalg.pinv(matrix_of(J @ J.T, eps)) @ e

    return by_joints, by_errors


def _right_step(J, e, eps):
    return step_of(0, J, e, eps)


def _with(eps_of):
    """The step with another number in place of eps."""
    return lambda J, e, eps: _right_step(J, e, eps_of(eps))


def _where_square(way):
    """The step by a formula that has a shape at all only where J is square."""
    return lambda J, e, eps: way(J, e, eps * np.eye(len(J))) if J.shape == J.T.shape else _right_step(J, e, eps)


def _parallel(answer, *case):
    wanted, turned = step_of(*case) - case[0], answer - case[0]
    size = wanted @ wanted
    return size > 0 and np.abs(turned - (turned @ wanted) / size * wanted).max() < allowed(*case)


_FORMULA = "J.T @ np.linalg.solve(J @ J.T + eps * np.eye(m), e), with J of shape (m, n)."
_SINGULAR = Mistake(
    "a matrix is inverted that has no inverse, or nearly none: eps I is missing in it",
    "J^T J, and at times J J^T, has none. eps * np.eye(...), added to it, makes it invertible.",
)
_NOT_SQUARE = Mistake("J itself is inverted", f"J is not square, in general. {_FORMULA}")
_OTHER_SIZE = Mistake(
    "the unit matrix, or another array, has not the size of what it is added to",
    "J @ J.T is (m, m), J.T @ J is (n, n), with (m, n) the shape of J: np.eye(len(e)) for the one, np.eye(len(q)) for "
    "the other.",
)

_MISTAKES = (
    *_like(
        (
            "the step goes the other way, away from the target",
            "e is what is left to do, target minus place. So the step is added.",
        ),
        lambda J, e, eps: -_right_step(J, e, eps),
    ),
    *(
        Mistake("only the step is returned", "The angles after the step: q and the step together.", answer)
        for answer in (lambda q, *rest: _right_step(*rest), lambda q, *rest: -_right_step(*rest))
    ),
    Mistake("q itself is returned: nothing moves", "Add the step to it.", lambda q, *rest: q),
    *_like(
        ("eps is not used: this is the pseudoinverse's step", "eps is added to the diagonal of J J^T, or of J^T J."),
        lambda J, e, eps: np.linalg.pinv(J) @ e,
        *_solved(lambda M, eps: M),
    ),
    *_like(
        ("eps is squared, or its root is taken", "eps stands in the formula as it is: J J^T + eps I."),
        _with(lambda eps: eps**2),
        _with(lambda eps: eps**0.5),
    ),
    *_like(("eps is subtracted", "J J^T + eps I, with a plus."), *_solved(lambda M, eps: M - eps * np.eye(len(M)))),
    *_like(
        ("eps is multiplied by a number", "eps stands in the formula as it is: J J^T + eps I."),
        *(_with(lambda eps, factor=factor: factor * eps) for factor in (2, 0.5)),
    ),
    *_like(
        ("I stands there without eps", "eps times the unit matrix is added: eps * np.eye(m)."), _with(lambda eps: 1.0)
    ),
    *_like(("eps is divided by", "eps times the unit matrix is added."), _with(lambda eps: 1 / eps)),
    *_like(
        (
            "this is the transpose's step: the matrix J J^T + eps I is left out",
            "Solve (J J^T + eps I) x = e for x. The step is J^T x.",
        ),
        lambda J, e, eps: J.T @ e,
        lambda J, e, eps: eps * J.T @ e,
        lambda J, e, eps: J.T @ e / eps,
    ),
    *_like(
        ("the matrix is multiplied by, not divided by", "Solve (J J^T + eps I) x = e for x: np.linalg.solve."),
        lambda J, e, eps: J.T @ (J @ J.T + eps * np.eye(len(J))) @ e,
    ),
    *_like(
        ("eps is added to every entry of the matrix", "Only the diagonal is damped: eps * np.eye(m), not eps."),
        *_solved(lambda M, eps: M + eps),
    ),
    *_like(
        ("the diagonal is scaled by eps, as Marquardt did", "Here eps is added, to each entry of the diagonal."),
        *_solved(lambda M, eps: M + eps * np.diag(np.diag(M))),
        *_solved(lambda M, eps: (1 + eps) * M),
    ),
    *_like(
        ("each entry of the matrix is inverted by itself", "The inverse of a matrix is np.linalg.inv(M), not 1 / M."),
        lambda J, e, eps: 1 / (J.T @ J + eps * np.eye(J.shape[1])) @ J.T @ e,
        lambda J, e, eps: J.T @ (1 / (J @ J.T + eps * np.eye(len(J)))) @ e,
    ),
    *_like(
        ("eps damps the step as a whole, not the matrix", _FORMULA),
        lambda J, e, eps: eps * _right_step(J, e, eps),
        lambda J, e, eps: _right_step(J, e, eps) / (1 + eps),
        lambda J, e, eps: eps * np.linalg.pinv(J) @ e,
        lambda J, e, eps: np.linalg.pinv(J) @ e / (1 + eps),
    ),
    *_like(
        ("the error is divided by its length", "The step is made of e itself: near the target it gets small."),
        lambda J, e, eps: _right_step(J, unit_or_zero(e), eps),
    ),
    *_like(
        ("J and J^T have changed places: only a square J lets that pass", _FORMULA),
        _where_square(lambda J, e, D: J @ np.linalg.solve(J.T @ J + D, e)),
        _where_square(lambda J, e, D: J.T @ np.linalg.solve(J.T @ J + D, e)),
        _where_square(lambda J, e, D: np.linalg.solve(J @ J.T + D, J.T @ e)),
        _where_square(lambda J, e, D: np.linalg.solve(J.T @ J + D, J @ e)),
    ),
    *_like(
        ("a square J is inverted without damping", "Damping is wanted for every shape of J."),
        _where_square(lambda J, e, D: np.linalg.pinv(J) @ e),
    ),
    *_like(
        ("the halves of e are exchanged", "e and the rows of J stand in the same order already."),
        lambda J, e, eps: _right_step(J, halves_exchanged(e), eps),
    ),
    *_like(
        ("eps is never below a least value of your own", "Use eps as it is given, however small."),
        *(_with(lambda eps, least=least: max(eps, least)) for least in 10.0 ** np.arange(-11, -1)),
    ),
    *_like(
        ("eps is a fixed number", "Use the eps that is given."),
        *(_with(lambda eps, fixed=fixed: fixed) for fixed in 10.0 ** np.arange(-12, 0)),
    ),
    *clipped(step_of),
    *in_degrees(step_of),
    *cut_off(step_of),
)

IK_STEP_DLS = Exercise(
    name="ik_step_dls",
    points=1,
    arguments=("q", "J", "e", "eps"),
    cases=_cases,
    returns=read,
    properties=(
        Property(
            "where nothing is left to do (e is 0) the angles stay as they are", _right, turns(step_of), where=_there
        ),
        Property(
            "the answer is q + J^T (J J^T + eps I)^-1 e",
            _right,
            turns(step_of),
            where=lambda *case: not _there(*case),
        ),
    ),
    mistakes=(
        few_digits(step_of),
        *_MISTAKES,
        Mistake(
            _SINGULAR.name,
            _SINGULAR.hint,
            seen=lambda answer, *case: np.abs(answer).max() > 1e6 * (1 + np.abs(step_of(*case)).max()),
        ),
        Mistake(
            "the step has the right direction and a wrong length",
            "Print your step for this input: is there a factor that does not belong?",
            seen=_parallel,
        ),
    ),
    hints=(
        "J J^T is (m, m), with m the number of rows of J. Add eps times the unit matrix of that size.",
        "Solve (J J^T + eps I) x = e: x = np.linalg.solve(J @ J.T + eps * np.eye(len(e)), e).",
        "The step is J.T @ x. Add it to q: a new array, so that q stays as it is.",
    ),
    forbidden=("course_lib.ik.damped_path", "course_lib.ik._damped_step"),
    errors=(
        ("LinAlgError", "Singular", _SINGULAR),
        ("LinAlgError", "square", _NOT_SQUARE),
        *NO_PRODUCTS,
        ("ValueError", "broadcast", _OTHER_SIZE),
        ("UFuncTypeError", "", WHOLE_NUMBERS),
    ),
)
