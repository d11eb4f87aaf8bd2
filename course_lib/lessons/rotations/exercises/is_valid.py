"""is_valid: what counts as a rotation, a pose or a unit quaternion, within a tolerance."""

import numpy as np

from course_lib.checks.answer_types import boolean
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import Sweep
from course_lib.checks.vocabulary import orthogonality_error, pose, unit
from course_lib.rotations import exp_so3, nearest_quaternion, random_rotations

TIGHT, LOOSE = 1e-9, 0.01
NEARLY_ONE = (
    1 + 4e-6
)  # off by more than TIGHT, and by less than numpy's own relative tolerance of 1e-5
_SHAPES = {"rotation": ((2, 2), (3, 3)), "pose": ((3, 3), (4, 4)), "quaternion": ((4,), (4, 1))}


def has_form(X, kind):
    """Return whether X has a shape that its kind may have."""
    return X.shape in _SHAPES[kind]


def _is_rotation(R, tol):
    return (
        has_form(R, "rotation")
        and orthogonality_error(R) <= tol
        and abs(np.linalg.det(R) - 1) <= tol
    )


def row_error(T):
    """Return the difference of the last row from (0, ..., 0, 1)."""
    return T[-1] - np.eye(T.shape[1])[-1]


def is_valid(X, kind, tol):
    """Return whether X is what its kind says, within tol."""
    if not has_form(X, kind):
        return False
    if kind == "quaternion":
        return abs(np.linalg.norm(X) - 1) <= tol
    if kind == "pose":
        return _is_rotation(X[:-1, :-1], tol) and np.abs(row_error(X)).max() <= tol
    return _is_rotation(X, tol)


def plane_rotation(angle):
    """Return the rotation of the plane by an angle."""
    return exp_so3([0.0, 0.0, angle])[:2, :2]


def _unit_columns(cosine, size=2):
    """A matrix with columns of length one, the first two at an angle with the given cosine."""
    R = np.eye(size)
    R[:2, 1] = cosine, np.sqrt(1 - cosine**2)
    return R


def _rotations(rng):
    R, flat = random_rotations(1, rng)[0], plane_rotation(2.0)
    stretched = plane_rotation(0.5) @ np.diag([1.003, 1.0])
    tight = [
        flat,
        R,
        plane_rotation(np.pi),
        np.diag([1.0, 1.0, -1.0]),
        np.diag([1.0, -1.0]),
        -R,
        2 * R,
    ]
    tight += [np.diag([2.0, 0.5, 1.0]), _unit_columns(0.6), np.zeros((3, 3))]
    tight += [
        R @ np.diag([NEARLY_ONE, 1 / NEARLY_ONE, 1.0]),
        np.eye(4),
        np.eye(5),
        R[:, :2],
        R[:2],
        R[0],
        R[None],
    ]
    # every entry of R^T R - I is 0.007, all of them together more than 0.01; so it is for R R^T too
    loose = [
        stretched,
        R @ np.diag([1.0035, 1.0035, 1 / 1.0035]),
        R @ np.diag([1.02, 1 / 1.02, 1.0]),
    ]
    loose += [np.diag([0.991, 1.0045, 1.0045]), _unit_columns(-0.08), _unit_columns(-0.08, 3)]
    loose += [plane_rotation(0.5) @ np.diag([1.0, -0.997]), R @ np.diag([1.0, 1.0, -0.997])]
    loose += [
        1.0045 * R,
        plane_rotation(np.pi / 4) @ np.diag([1.006, 1.0]),
    ]  # det R alone is off; R R^T alone is not
    return tight, loose, [stretched]


def _poses(rng):
    R, flat, p = random_rotations(1, rng)[0], plane_rotation(0.5), 10 * unit(rng)
    tight = [pose(flat, p[:2]), pose(R, p), pose(-R, p), pose(R @ np.diag([2.0, 0.5, 1.0]), p)]
    tight += [
        pose(R, p, 0.3, -0.3, 0.0, 1.0),
        pose(flat, 0 * p[:2], -0.3, 0.0, 1.0),
        pose(flat, p[:2], 0.0, 0.0, 0.5),
    ]
    tight += [pose(R, p, 0.0, 0.0, 0.0, last) for last in (2.0, -1.0, NEARLY_ONE)]
    tight += [np.eye(2), np.eye(5), np.vstack([pose(R, p), np.eye(4)[3]]), np.eye(4, 5)]
    tight += [pose(R, p)[:3], np.eye(3, 4), pose(R, p)[None]]
    both = [pose(flat, p[:2], 0.004, 0.0, 1.0), pose(R @ np.diag([1.003, 1.0, 1.0]), p)]
    # the mean of the row's errors and its length are within tol, the largest error is not; and the
    # reverse
    rows = [pose(R, p, 0.012, 0.0, 0.0, 1.0), pose(R, p, 0.009, 0.009, 0.009, 1.0)]
    # What is no rotation is no block of a pose either.
    blocks = [pose(block, p[: len(block)]) for block in _rotations(rng)[1]]
    return tight, [*both, *rows, *blocks], both


def _quaternions(rng):
    q = nearest_quaternion(rng.normal(size=4))
    tight = [
        np.array([1.0, 0, 0, 0]),
        q,
        -q,
        q[:, None],
        np.array([1.0, 1, 0, 0]),
        np.array([0.5, 0.5, 0.0, 0.0]),
    ]
    tight += [
        2 * q[:, None],
        np.zeros(4),
        NEARLY_ONE * q,
        np.array([1.0, 0, 0]),
        q[None, :],
        q.reshape(2, 2),
        np.append(q, 0.0),
        q[None, :, None],
    ]
    return (
        [*tight, 0.5 * np.eye(4)],
        [1.008 * q, 1.004 * q, 0.992 * q],
        [1.008 * q, 0.992 * q[:, None]],
    )


# From errors that are plain to see to some that are a thousand times rounding.
_ERRORS = tuple(float(f"1e-{k}") for k in range(2, 14))


def _off_by(rng, kind, error):
    """Return something of this kind that is off by the error, for a rotation by twice the error."""
    if kind == "quaternion":
        return (1 + error) * np.eye(4)[rng.integers(4)]
    stretched = np.eye(2 if kind == "rotation" else 3)
    if kind == "rotation":
        stretched[0, 0] += error * rng.choice([-1, 1])
        return stretched
    stretched[2, rng.integers(3)] += error * rng.choice([-1, 1])
    return stretched


def _with_tolerance(kind, share):
    """Sweep over errors, with a tolerance that is this share of the error, or 0."""

    def case(rng, error):
        return _off_by(rng, kind, error), kind, share * error

    return Sweep("an error, and a tolerance of about its size", case, _ERRORS)


def _special(rng):
    """Return a matrix of any shape that is nearly square, or one of the right shape in whole
    numbers, most of them 0, 1 or -1."""
    kind = tuple(_SHAPES)[rng.integers(3)]
    shapes = _SHAPES[kind]
    shape = shapes[rng.integers(2)]
    if rng.random() < 0.5:
        return np.eye(*rng.integers(1, 6, 2)), kind, TIGHT
    signed = np.eye(max(shape))[rng.permutation(max(shape))] * rng.choice([-1, 1], max(shape))
    signed[rng.integers(max(shape))] += rng.choice([0, 0, 0, 1], max(shape))
    X = signed[0] if kind == "quaternion" else signed
    return X.reshape(shape), kind, TIGHT


def _determinant_alone(kind):
    """Sweep over errors of a size, with a tolerance that only the determinant exceeds."""

    def case(rng, error):
        R = (1 + error) * np.eye(3)
        X = pose(R, rng.uniform(-1, 1, 3)) if kind == "pose" else R
        return X, kind, 2.5 * error

    return Sweep("an error of the determinant alone", case, _ERRORS)


def _cases(rng):
    drawn = {"rotation": _rotations(rng), "pose": _poses(rng), "quaternion": _quaternions(rng)}
    # Off by exactly tol: all these numbers have few binary digits.
    exact = [
        (np.diag([1.125, 1.0]), "rotation", 0.265625),
        (1.125 * np.eye(3), "rotation", 0.423828125),
    ]
    exact += [
        (pose(np.eye(2), [3, 1], 0.25, 0, 1), "pose", 0.25),
        (np.array([0, 1.25, 0, 0]), "quaternion", 0.25),
    ]
    return exact + [
        (X, kind, tol)
        for kind, parts in drawn.items()
        for each, tol in zip(parts, (TIGHT, LOOSE, 1e-4), strict=True)
        for X in each
    ]


def _errors(ok, X, kind, tol):
    """Return what an answer should have seen in X, in words."""
    if not has_form(X, kind):
        return f"Its shape is {X.shape}."
    if kind == "quaternion":
        return f"|q| - 1 is {np.linalg.norm(X) - 1:.8g}, tol is {tol:g}."
    R = X[:-1, :-1] if kind == "pose" else X
    seen = (
        f"An entry of R^T R differs by {orthogonality_error(R):.8g} from that of I, det R - 1 is "
        f"{np.linalg.det(R) - 1:.8g}, "
    )
    if kind == "pose":
        seen += (
            "the last row differs from (0, ..., 0, 1) by at most"
            f" {np.abs(row_error(X)).max():.8g}, "
        )
    return seen + f"tol is {tol:.8g}."


def _says(kind, text):
    return Property(
        text,
        lambda ok, X, kind, tol: ok == is_valid(X, kind, tol),
        says=_errors,
        where=lambda X, asked, tol: asked == kind,
        points=1,
    )


_SHAPE_IGNORED = Mistake(
    "the shape is ignored, or one size is assumed",
    "Which line comes first in your function: one that computes with X, or one that looks at its "
    "shape? What does the task ask for if X has another shape?",
)


def _other_shape(ok, X, kind, tol):
    return Question(
        f"the shape of a {kind} is not tested, or not all of it",
        f"X has the shape {X.shape}. Which shapes does the task allow for a {kind}?",
    )


EXERCISE = Exercise(
    name="is_valid",
    points=3,
    arguments=("X", "kind", "tol"),
    cases=_cases,
    returns=boolean,
    library=is_valid,
    special=_special,
    sweeps=(
        *(_with_tolerance(kind, share) for kind in _SHAPES for share in (0, 0.4, 4)),
        *map(_determinant_alone, ("rotation", "pose")),
    ),
    properties=(
        Property(
            "for an array of another shape the answer is False",
            lambda ok, X, kind, tol: not ok,
            where=lambda X, kind, tol: not has_form(X, kind),
            otherwise=_other_shape,
        ),
        _says(
            "rotation",
            '"rotation": every entry of R^T R is within tol of I, and det R within tol of 1',
        ),
        _says(
            "pose",
            '"pose": the upper left block is a rotation, and each entry of the last row is'
            " within tol",
        ),
        _says("quaternion", '"quaternion": |q| is within tol of 1'),
    ),
    hints=(
        (
            "First the shape. A rotation is 2x2 or 3x3, a pose 3x3 or 4x4; a quaternion has the"
            " shape (4,) or (4, 1)."
        ),
        (
            "A rotation: R^T R = I within tol, entry by entry, and a determinant that tells it from"
            " a mirror. A pose contains a rotation: is_valid may call itself with the block and"
            ' "rotation".'
        ),
        (
            "np.abs(R.T @ R - np.eye(len(R))).max() is the largest error of any entry; do the same "
            "with the last row, and "
            "with the length of q."
        ),
    ),
    forbidden=(
        "course_lib.rotations.is_so",
        "course_lib.rigid.is_se",
        "course_lib.rotations.is_quaternion",
    ),
)

EXERCISE.mistake(_SHAPE_IGNORED, raises=("LinAlgError", "must be square"))
EXERCISE.mistake(_SHAPE_IGNORED, raises=("ValueError", "could not be broadcast together"))

# A mistake answers for one kind only, and with `only` says nothing of the others.


def _only(kind, X, asked, test):
    return bool(has_form(X, kind) and test(X)) if asked == kind else None


def _entries(R):
    return R.T @ R - np.eye(len(R))


def _upright(R, tol):
    return abs(np.linalg.det(R) - 1) <= tol


@EXERCISE.mistake(
    "a negative error always passes",
    "An error of -0.5 is as wrong as 0.5.",
    about=_SHAPES,
    low=(-np.inf, 0),
)
def negative_errors_pass(X, kind, tol, about, low):
    tests = {
        "rotation": lambda R: _entries(R).max() <= tol and low <= np.linalg.det(R) <= 1 + tol,
        "pose": lambda T: _is_rotation(T[:-1, :-1], tol) and row_error(T).max() <= tol,
        "quaternion": lambda q: np.linalg.norm(q) - 1 <= tol,
    }
    return _only(about, X, kind, tests[about])


@EXERCISE.mistake(
    "a relative tolerance is added: numpy.allclose and numpy.isclose have one of their own",
    "Which keyword of theirs sets it to zero?",
    about=_SHAPES,
    upright=(lambda d, tol: np.isclose(d, 1, atol=tol), lambda d, tol: d > 0),
)
def relative_tolerance(X, kind, tol, about, upright):
    tests = {
        "rotation": lambda R: (
            np.allclose(R.T @ R, np.eye(len(R)), atol=tol) and upright(np.linalg.det(R), tol)
        ),
        "pose": lambda T: (
            _is_rotation(T[:-1, :-1], tol) and np.allclose(T[-1], np.eye(len(T))[-1], atol=tol)
        ),
        "quaternion": lambda q: np.isclose(np.linalg.norm(q), 1, atol=tol),
    }
    return _only(about, X, kind, tests[about])


@EXERCISE.mistake(
    "the length of a quaternion is not the root of the sum of its squares",
    "Within a tolerance, is the square as good?",
    size=(lambda q: np.sum(q**2), np.sum),
)
def other_length(X, kind, tol, size):
    return _only("quaternion", X, kind, lambda q: abs(size(q) - 1) <= tol)


@EXERCISE.mistake(
    "the errors of all entries of R^T R are added up, in a norm or a mean",
    "The largest error decides.",
    size=(np.linalg.norm, lambda E: np.abs(E).mean()),
)
def errors_added_up(X, kind, tol, size):
    return _only("rotation", X, kind, lambda R: size(_entries(R)) <= tol and _upright(R, tol))


@EXERCISE.mistake(
    "one shape alone is accepted",
    "Which shapes does the task name for each kind?",
    shape=[shape for shapes in _SHAPES.values() for shape in shapes],
)
def one_shape_alone(X, kind, tol, shape):
    return X.shape == shape and is_valid(X, kind, tol) if shape in _SHAPES[kind] else None


@EXERCISE.mistake(
    "the determinant is not compared with 1, within tol",
    "For which matrices is R^T R = I, although they are no rotations? And is a positive "
    "determinant enough?",
    passes=(lambda d, tol: True, lambda d, tol: d > 0, lambda d, tol: abs(abs(d) - 1) <= tol),
)
def determinant_left_out(X, kind, tol, passes):
    return _only(
        "rotation",
        X,
        kind,
        lambda R: np.abs(_entries(R)).max() <= tol and passes(np.linalg.det(R), tol),
    )


@EXERCISE.mistake(
    "the last row of a pose is not compared with (0, ..., 0, 1), or not all of it",
    "How large may its entries be?",
    entries=(0, 1),
)
def last_row_left_out(X, kind, tol, entries):
    row = np.abs(row_error(X))[::-1][:entries] if X.ndim == 2 else ()
    return _only(
        "pose", X, kind, lambda T: _is_rotation(T[:-1, :-1], tol) and max(row, default=0) <= tol
    )


@EXERCISE.mistake(
    "an error of exactly tol is refused",
    "What does *at most* say of equal numbers?",
    about=_SHAPES,
)
def exactly_tol_refused(X, kind, tol, about):
    return is_valid(X, kind, tol * (1 - 1e-12)) if kind == about else None
