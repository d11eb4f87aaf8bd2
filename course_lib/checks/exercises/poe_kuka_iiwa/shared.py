"""What several exercises of this notebook share: arms to ask about, their right answers, and mistakes in one part."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Mistake
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.vocabulary import (
    X,
    Y,
    Z,
    any_pose,
    away_from_zero,
    near,
    products,
    remembered,
    unit,
    whole_numbers,
)
from course_lib.rigid import adjoint, exp_se3, transform
from course_lib.rotations import exp_so3, hat

BLOCK, COLUMN = (slice(0, 3), slice(0, 3)), (slice(0, 3), 3)  # R and p of a pose

KUKA_OMEGA = np.array([Z, Y, Z, -Y, Z, Y, Z])
KUKA_POINTS = np.outer([0, 0.36, 0.36, 0.78, 0.78, 1.18, 1.18], Z)
KUKA_HOME = transform(np.eye(3), 1.301 * Z)


def axes(omega, points):
    """Return the screw axes (n, 6) of joints about the directions `omega` through `points`, both (n, 3)."""
    return np.concatenate([omega, np.cross(points, omega)], -1)


KUKA = axes(KUKA_OMEGA, KUKA_POINTS)
ONE = axes([Z], [0 * X])
TWO = axes([Z, Z], [0 * X, X])  # a planar arm with links of one metre
ELBOW = axes([Z, Y, Y], [0 * X, Z, X + Z])
WHOLE = np.array([[0, 0, 1, 0, -1, 0], [1, 0, 0, 0, 2, 0], [0, 1, 0, 1, 0, 0]])
WHOLE_HOME = np.array([[0, -1, 0, 2], [1, 0, 0, 1], [0, 0, 1, 3], [0, 0, 0, 1]])
WHOLE_ANGLES = np.array([1, 2, -1])


def at(*position):
    """Return a pose (4, 4) at this position, parallel to the base.

    Examples
    --------
    >>> at(0, 0, 2)[:3, 3]
    array([0., 0., 2.])
    """
    return transform(np.eye(3), position)


def drawn_axes(rng, n):
    """Return directions and points (n, 3) of axes in general position."""
    return np.array([unit(rng) for _ in range(n)]), away_from_zero(rng, (n, 3), 0.2, 1.0)


def arms(rng):
    """Return cases (screws, M, q): simple arms first, then any, then those given in whole numbers.

    Examples
    --------
    >>> [len(q) for _, _, q in arms(np.random.default_rng(0))][:6]
    [1, 2, 2, 2, 2, 3]
    """
    tool = transform(exp_so3(np.pi / 2 * X), [2.0, 0, 1])
    named = [
        (ONE, at(1, 0, 0), np.array([np.pi / 2])),
        (TWO, at(2, 0, 0), np.array([0, np.pi / 2])),
        (TWO, at(2, 0, 0), np.array([0.5, -1.2])),
        (TWO, tool, np.zeros(2)),
        (TWO, tool, np.array([0.5, 0.8])),
        (ELBOW, at(2, 0, 1), np.array([0.5, 0.8, -1.2])),
        (KUKA, KUKA_HOME, np.array([0.3, -0.7, 1.1, 0.9, -0.4, 1.3, 0.6])),
        (KUKA, KUKA_HOME, np.zeros(7)),
    ]
    drawn = [(axes(*drawn_axes(rng, n)), any_pose(rng), away_from_zero(rng, n)) for n in (1, 3, 4, 6, 7)]
    screws, M, _ = drawn[1]
    far = [(screws, M, np.array([7.5, -9.25, 40.0])), (KUKA, KUKA_HOME, away_from_zero(rng, 7, 3.3, 6.0))]
    whole = [(WHOLE, at(2, 1, 0), np.array([0.5, 1.2, -0.7])), (WHOLE, at(2, 1, 0), WHOLE_ANGLES)]
    return [*named, *drawn, *far, *whole, named[2]]


@remembered
def exponentials(screws, q):
    """Return exp([S1] q1), ..., exp([Sn] qn)."""
    return exp_se3(screws * q[:, None])


@remembered
def tool_pose(screws, M, q):
    """Return the pose of the end-effector, by the product of exponentials."""
    return products(exponentials(screws, q))[-1] @ M


@remembered
def before(screws, q):
    """Return for each joint the product of the exponentials of the joints before it."""
    return products(exponentials(screws, q))[:-1]


@remembered
def jacobian(screws, q):
    """Return the space Jacobian (6, n)."""
    return columns(adjoint(before(screws, q)), screws)


def columns(matrices, screws):
    """Return matrix i times screw axis i, side by side.

    Examples
    --------
    >>> columns(np.array([2 * np.eye(6)]), ONE).ravel()
    array([0., 0., 2., 0., 0., 0.])
    """
    return np.einsum("nij,nj->in", matrices, screws)


# ---- Jacobians as answers ----

TRANSPOSED = Mistake(
    "rows and columns are swapped", "One column for each joint: the shape is (6, n). What does np.array([...]) stack?"
)
_ONE_COLUMN = Mistake("only one column is returned", "Collect the columns of all joints, and put them side by side.")
_HALF = Mistake("only one half of the Jacobian is returned", "Each column is a twist: omega above, v below.")


def read_jacobian(joints):
    """Return a reader of arrays (6, n); joints(*arguments) is n."""

    def known(array, *case):
        n = joints(*case)
        if array.shape in ((n, 6), (n, 6, 1)):
            return TRANSPOSED
        if array.shape in ((6,), (6, 1)):
            return _ONE_COLUMN
        return _HALF if array.shape == (3, n) else None

    return numbers(lambda *case: (6, joints(*case)), known)


def off_column(J, right, first=0, last=6):
    """Return which column is the first that is off in these rows, in words."""
    i = int(np.argmax([not near(J[first:last, k], right[first:last, k]) for k in range(right.shape[1])]))
    wanted, yours = right[first:last, i], J[first:last, i]
    return f"J[{first}:{last}, {i}] should be {format_tuple(wanted)}; yours is {format_tuple(yours)}."


def whole_screws(right):
    """The mistake of filling a copy of the first argument, which holds whole numbers only."""
    both = whole_numbers(right)
    return Mistake(both.name, both.hint, both.answers[0], seen=both.seen)


def reshaped(right):
    """The mistake of a Jacobian whose rows are filled with its columns. right(*arguments): the right one."""

    def answer(*case):
        J = right(*case)
        return None if J.shape[1] == 1 else J.T.reshape(6, -1)

    return Mistake(
        "the numbers are right, but reshaped to (6, n) where a transpose is needed",
        "reshape keeps the order of the numbers in memory; it does not turn rows into columns.",
        answer,
    )


# ---- answers that are wrong in one part ----


def in_part(right, where):
    """Return a maker of mistakes that show in one part of the answer, whatever the rest of it holds.

    right(*arguments): the right answer. where: an index of the part. The maker takes the name, the hint, and functions
    of the arguments that give what stands there instead.
    """

    def answer_with(part):
        def answer(*case):
            whole = np.array(right(*case), float)
            other = part(*case)
            if other is None or near(np.asarray(other), whole[where]):
                return None
            whole[where] = other
            return whole

        return answer

    def alike(value, predicted, *case):
        part, other, exact = (np.asarray(matrix)[where] for matrix in (value, predicted, right(*case)))
        off = np.abs(part - other).max()
        return off <= 1e-6 * max(1, np.abs(other).max()) and off <= 0.1 * np.abs(other - exact).max()

    def mistake(name, hint, *parts, **more):
        return Mistake(name, hint, *map(answer_with, parts), alike=alike, **more)

    return mistake


def worst_column(part, right):
    """Return a `seen` that describes the worst column. part(answer), right(*arguments): the part that is compared."""

    def seen(answer, *case):
        found, wanted = part(answer), right(*case)
        k = np.abs(found - wanted).max(axis=0).argmax()
        which = ("first", "second", "third")[k]
        off = np.abs(found - wanted).max()
        return (
            f"Its {which} column should be {format_tuple(wanted[:, k])}. Yours is {format_tuple(found[:, k])}, off by "
            f"{off:.2g}."
        )

    return seen


# ---- wrong adjoints, which show in whatever uses one: (name, hint): matrices (6, 6) as functions of R and p ----

_BOTH_DIAGONAL = "omega and v are both rotated from frame b to frame a: the same rotation stands in both places."
ADJOINTS = {
    ("the upper left block of the adjoint is R^-1", _BOTH_DIAGONAL): (
        lambda R, p: np.block([[R.T, 0 * R], [hat(p) @ R, R]]),
        lambda R, p: np.block([[R.T, 0 * R], [hat(p) @ R.T, R]]),
    ),
    ("R^T stands where R belongs in the adjoint", _BOTH_DIAGONAL): (
        lambda R, p: np.block([[R.T, 0 * R], [hat(p) @ R.T, R.T]]),
        lambda R, p: np.block([[R, 0 * R], [hat(p) @ R, R.T]]),
        lambda R, p: np.block([[R, 0 * R], [hat(p) @ R.T, R]]),
    ),
    ("[p] R is left out of the adjoint", "The velocity at another origin differs: omega contributes to the new v."): (
        lambda R, p: np.block([[R, 0 * R], [0 * R, R]]),
    ),
    (
        "the blocks of the adjoint are in the order (v, omega)",
        "Twists are (omega, v) here. Which of the two is changed by the other when the origin moves?",
    ): (lambda R, p: np.block([[R, hat(p) @ R], [0 * R, R]]),),
    ("the lower left block of the adjoint is wrong", "Rotate omega into frame a first; then p x omega, with a plus."): (
        lambda R, p: np.block([[R, 0 * R], [R @ hat(p), R]]),
        lambda R, p: np.block([[R, 0 * R], [-hat(p) @ R, R]]),
        lambda R, p: np.block([[R, 0 * R], [hat(p), R]]),
    ),
    ("the adjoint is transposed", "omega never depends on v: the block of zeros is on the upper right."): (
        lambda R, p: np.block([[R, 0 * R], [hat(p) @ R, R]]).T,
    ),
}


def adjoint_mistakes(*with_matrix, without=()):
    """Return a Mistake for each of ADJOINTS.

    with_matrix: each(matrix) is the answer of somebody with that adjoint. without: names to leave out.
    """
    return tuple(
        Mistake(name, hint, *(use(matrix) for use in with_matrix for matrix in matrices))
        for (name, hint), matrices in ADJOINTS.items()
        if name not in without
    )


def first_off(found, wanted, what="Column"):
    """Return in words which column is the first that is off; for rows, give both transposed."""
    i = int(np.argmax([not near(yours, right) for yours, right in zip(found.T, wanted.T, strict=True)]))
    right, yours = format_tuple(wanted[:, i]), format_tuple(found[:, i])
    by = f", off by {np.abs(found - wanted)[:, i].max():.2g}" if right == yours else ""
    return f"{what} {i} should be {right}; yours is {yours}{by}."


def in_blocks(T, form):
    """Return the matrix of blocks form(R, [p], zeros) of a pose."""
    return np.block(form(T[BLOCK], hat(T[COLUMN]), np.zeros((3, 3))))


WRONG_ADJOINTS = (  # forms for in_blocks
    lambda R, P, zero: [[R.T, zero], [P @ R, R]],
    lambda R, P, zero: [[R.T, zero], [P @ R.T, R.T]],
    lambda R, P, zero: [[R, zero], [P @ R, R.T]],
    lambda R, P, zero: [[R, zero], [P @ R.T, R]],
    lambda R, P, zero: [[R, zero], [zero, R]],
    lambda R, P, zero: [[R, zero], [R @ P, R]],
    lambda R, P, zero: [[R, zero], [-P @ R, R]],
    lambda R, P, zero: [[R, zero], [P, R]],
    lambda R, P, zero: [[R, P @ R], [zero, R]],
    lambda R, P, zero: [[R.T, (P @ R).T], [zero, R.T]],
)

read_jacobian = numbers(
    lambda screws, *rest: (6, len(screws)),
    {(6,): Mistake("one column is returned, not a matrix (6, n)", "Where does your loop collect the columns?")},
)
