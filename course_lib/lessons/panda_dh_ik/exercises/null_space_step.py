"""null_space_step: a step towards the middle of the joint ranges that does not move the
end-effector."""

import numpy as np

from course_lib.checks.comparisons import difference
from course_lib.checks.declared import declared
from course_lib.checks.kinds import joint_angles, number, table
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import BESIDE, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import away_from_zero, wrapped
from course_lib.lessons.panda_dh_ik.exercises.shared import FLAT, HIGH, LOW, changed, panda_jacobian

_ROUNDING = 1e-14  # of J J^T, relative: what it does to J^+ is divided by the square of the least s
_SINGULAR = np.array([[1.0, 2, 0], [2, 4, 0]])
_SINGULAR_SQUARE = np.array([[1.0, 2, 0], [2, 4, 0], [0, 1, 1]])
_LARGEST = 3.5  # a singular value of the cases with a small one
# With a smaller singular value, that error is as large as a direction of the null space.
_LEAST_VALUES = tuple(size for size in BESIDE if size > 1e-6)


def _step(q, J, q_middle, gain):
    return gain * (q_middle - q)


def _through(projected, answer=_step):
    """Return the answer q + projected(J, step)."""
    return lambda q, *rest: q + projected(rest[0], answer(q, *rest))


def _into_the_null_space(J, step):
    return step - np.linalg.pinv(J) @ (J @ step)


_right = _through(_into_the_null_space)


def _cases(rng):
    middle = (LOW + HIGH) / 2
    q, ones = np.array([0.1, 0.2, 0.3]), np.ones(3)
    drawn = [
        (away_from_zero(rng, n), away_from_zero(rng, (m, n)), away_from_zero(rng, n), gain)
        for m, n, gain in ((2, 4, 0.2), (1, 3, 1.0), (2, 3, 2.5), (1, 1, 0.5))
    ]
    panda, stretched = np.round(rng.uniform(LOW, HIGH), 2), np.array([0.2, 0, 0.4, 0, 0.3, 0, 0.5])
    return [
        (q, FLAT, ones, 0.5),
        *drawn,
        (panda, panda_jacobian(panda), middle, 0.1),
        (panda, panda_jacobian(panda), panda[::-1], 0.4),
        (panda, panda_jacobian(panda), panda, 0.3),
        (stretched, panda_jacobian(stretched), middle, 0.2),
        (q, _SINGULAR, ones, 0.5),
        (q, _SINGULAR_SQUARE, away_from_zero(rng, 3), 0.5),
        (q, 0 * _SINGULAR, away_from_zero(rng, 3), 0.5),
    ]


def _nearly_singular(rng, size):
    """Return a case with a singular value of about this size, in directions without a meaning."""
    U, V = (np.linalg.qr(rng.normal(size=(n, n)))[0] for n in (3, 5))
    J = U @ np.column_stack([np.diag([_LARGEST, 0.7, size]), np.zeros((3, 2))]) @ V
    return away_from_zero(rng, 5), J, away_from_zero(rng, 5), 0.5


def _least_share(J):
    """Return the smallest singular value that is not 0, as a share of the largest; 1 if all are
    0."""
    values = np.linalg.svd(J, compute_uv=False)
    values = values[values > EXACT * values[0]]
    return values[-1] / values[0] if values.size else 1


def _distance(answer, right, q, J, *rest):
    """Return how far an answer is from the right one, near a singularity as a share of what
    rounding does there."""
    return difference(answer, right) / max(1, _ROUNDING / EXACT / _least_share(J) ** 2)


def _found(answer, q, J, *rest):
    moved = np.abs(J @ (answer - q)).max()
    if moved > EXACT:
        return f"J times the change in your answer has an entry of {moved:.3g}, and not 0."
    closer = changed(answer, _right(q, J, *rest), q)
    return "J times the change in your answer is nearly 0, and the change is another one. " + closer


_MOVES = Question(
    "the step still moves the end-effector",
    "Print J times your change of q, and J times your matrix in place of I - J^+ J. Which line of "
    "your code makes it differ from 0?",
)
_OTHER_STEP = Question(
    "the step is not gain (I - J^+ J)(q_middle - q)",
    "Compare your change of q with this product for the case below, factor by factor.",
)
_OTHER_SIZE = (
    "J J^+ stands for J^+ J, or I has another size",
    "Which shape does a matrix have that acts on joint angles?",
)


def _of_full_rank(answer, q, J, *rest):
    return np.linalg.svd(J, compute_uv=False)[-1] < EXACT


EXERCISE = declared(
    "null_space_step",
    points=2,
    arguments={
        "q": joint_angles(5, small=True),
        "J": table(3, 5, small=True),
        "q_middle": joint_angles(5, small=True),
        "gain": number(0.1, 0.9, 0.5, 1.0, 2.5, -0.4, 0.0),
    },
    cases=_cases,
    library=_right,
    distance=_distance,
    says="the answer is q + gain (I - J^+ J)(q_middle - q): to first order the end-effector stays, "
    "and no other such change is closer to gain (q_middle - q)",
    found=_found,
    otherwise=lambda answer, q, J, *rest: (
        _MOVES if np.abs(J @ (answer - q)).max() > EXACT else _OTHER_STEP
    ),
    sweeps=(Sweep("nearly singular", _nearly_singular, _LEAST_VALUES),),
    hints=(
        "The pseudoinverse J^+ gives the shortest joint motion for a motion of the end-effector. "
        "J^+ J takes out of any joint motion the part that moves the end-effector.",
        "The step is gain (I - J^+ J)(q_middle - q). np.linalg.pinv has the pseudoinverse, at "
        "singularities too.",
        "q + gain * (np.eye(len(q)) - np.linalg.pinv(J) @ J) @ (q_middle - q)",
    ),
    mistakes=(
        Mistake(
            "the projector is returned, not the joint angles",
            "To which vector does the task apply the projector, and what does it add to q?",
            form=lambda array, q, *rest: array.shape == (len(q), len(q)),
        ),
        Mistake(
            "J J^T is inverted, which fails at a singularity",
            "Which function of numpy gives J^+ at a singularity, too?",
            raises=("LinAlgError", "Singular"),
        ),
        Mistake(*_OTHER_SIZE, raises=("ValueError", "core dimension")),
        Mistake(*_OTHER_SIZE, raises=("ValueError", "could not be broadcast")),
        Mistake(
            "the answer is wrong where the rank of J is not full",
            "J J^T has no inverse at a singularity, and the null space has more dimensions. Which "
            "part of your formula needs full rank?",
            seen=_of_full_rank,
        ),
        Mistake(
            "q_middle - q is not projected, or the other part of it is kept",
            "Which part of q_middle - q is J^+ J (q_middle - q)?",
            _through(lambda J, step: step),
            _through(lambda J, step: np.linalg.pinv(J) @ (J @ step)),
        ),
        Mistake(
            "q_middle - q is wrapped to less than half a revolution",
            "Is a joint at 4 pi in the same place within its range as a joint at 0?",
            *(
                _through(
                    _into_the_null_space,
                    lambda q, J, q_middle, gain, wrap=wrap: gain * wrap(q_middle - q),
                )
                for wrap in (lambda q: np.angle(np.exp(1j * q)), lambda q: q % (2 * np.pi))
            ),
        ),
        wrapped(_right),
    ),
)
