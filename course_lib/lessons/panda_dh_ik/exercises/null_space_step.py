"""null_space_step: a step towards the middle of the joint ranges that does not move the
end-effector."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.special_cases import BESIDE, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import away_from_zero, near
from course_lib.lessons.panda_dh_ik.exercises.shared import FLAT, HIGH, LOW, panda_jacobian

_OTHER_SIZE = Mistake(
    "J J^+ stands for J^+ J, or I has another size",
    "Which shape does a matrix have that acts on joint angles?",
)
_PROJECTOR = Mistake(
    "the projector is returned, not the joint angles",
    "To which vector does the task apply the projector, and what does it add to q?",
)


def _projector(J):
    return np.eye(J.shape[1]) - np.linalg.pinv(J) @ J


def right(q, J, q_middle, gain):
    """Return the right answer."""
    return q + gain * _projector(J) @ (q_middle - q)


def _cases(rng):
    middle = (LOW + HIGH) / 2
    drawn = [
        (away_from_zero(rng, n), away_from_zero(rng, (m, n)), away_from_zero(rng, n), gain)
        for m, n, gain in ((2, 4, 0.2), (1, 3, 1.0), (3, 5, -0.4), (2, 3, 2.5))
    ]
    panda = [np.round(rng.uniform(LOW, HIGH), 2) for _ in range(3)]
    drawn += [
        (q, panda_jacobian(q), middle, gain)
        for q, gain in zip(panda, (0.1, 1.0, 0.05), strict=True)
    ]
    stretched = np.array([0.2, 0, 0.4, 0, 0.3, 0, 0.5])  # a singularity: J J^T has no inverse
    return [
        (np.array([0.1, 0.2, 0.3]), FLAT, np.array([1.0, 1, 1]), 0.5),
        *drawn,
        (panda[0], panda_jacobian(panda[0]), panda[0], 0.3),
        (stretched, panda_jacobian(stretched), middle, 0.2),
        (
            np.array([0.1, 0.2, 0.3]),
            np.array([[1.0, 2, 0], [2, 4, 0]]),
            np.array([1.0, 1, 1]),
            0.5,
        ),  # exactly singular
        (
            np.array([0.1, 0.2, 0.3]),
            np.array([[1.0, 2, 0], [2, 4, 0], [0, 1, 1]]),
            away_from_zero(rng, 3),
            0.5,
        ),  # square, and singular
        (np.array([1, 2, 3]), np.array([[1, 1, 0], [0, 1, 1]]), np.array([3, 1, 1]), 0.25),
    ]


def _nearly_singular(rng, size):
    """Return a case with a singular value of about this size, in directions without a meaning."""
    U, V = (np.linalg.qr(rng.normal(size=(n, n)))[0] for n in (3, 5))
    J = U @ np.column_stack([np.diag([1.3, 0.7, size]), np.zeros((3, 2))]) @ V
    return away_from_zero(rng, 5), J, away_from_zero(rng, 5), 0.5


EXERCISE = Exercise(
    name="null_space_step",
    points=2,
    arguments=("q", "J", "q_middle", "gain"),
    cases=_cases,
    small=("q", "q_middle"),
    returns=numbers(
        lambda q, *rest: (len(q),),
    ),
    properties=(
        Property(
            "to first order the end-effector stays: J times the change of q is 0",
            lambda answer, q, J, *rest: near(J @ (answer - q), np.zeros(len(J))),
            says=lambda answer, q, J, *rest: (
                f"J times the change in your answer has an entry of "
                f"{np.abs(J @ (answer - q)).max():.3g}."
            ),
            mistake=Mistake(
                "the step still moves the end-effector",
                "Print J times your matrix in place of I - J^+ J. Which of your steps makes it "
                "differ "
                "from 0: the inverse, a damping, or a cut-off of singular values?",
            ),
        ),
        Property(
            "of all such changes this one is closest to gain (q_middle - q)",
            lambda answer, *case: near(answer, right(*case)),
            mistake=Mistake(
                "the step is not gain (I - J^+ J)(q_middle - q)",
                "Compare your change of q with this product for the case below, factor by factor.",
            ),
        ),
    ),
    hints=(
        "The pseudoinverse J^+ gives the shortest joint motion for a motion of the end-effector. "
        "J^+ J takes out of "
        "any joint motion the part that moves the end-effector.",
        "The step is gain (I - J^+ J)(q_middle - q). np.linalg.pinv has the pseudoinverse, at "
        "singularities too.",
        "q + gain * (np.eye(len(q)) - np.linalg.pinv(J) @ J) @ (q_middle - q)",
    ),
    library=right,
    # With a smaller singular value, rounding in J decides the directions of the null space.
    sweeps=(Sweep("nearly singular", _nearly_singular, tuple(x for x in BESIDE if x > 1e-5)),),
    angles=("q",),
)

EXERCISE.mistake(_PROJECTOR, form=lambda array, q, *rest: array.shape == (len(q), len(q)))
EXERCISE.mistake(
    Mistake(
        "J J^T is inverted, which fails at a singularity",
        "Which function of numpy gives J^+ at a singularity, too?",
    ),
    raises=("LinAlgError", "Singular"),
)
EXERCISE.mistake(_OTHER_SIZE, raises=("ValueError", "core dimension"))
EXERCISE.mistake(_OTHER_SIZE, raises=("ValueError", "could not be broadcast"))


@EXERCISE.mistake(
    "J is assumed to have full rank, which is false at a singularity",
    "J J^T has no inverse at a singularity, and the null space has more dimensions. Which part of "
    "your formula needs full rank?",
    recognises=True,
)
def full_rank(answer, q, J, *rest):
    return np.linalg.svd(J, compute_uv=False)[-1] < EXACT


@EXERCISE.mistake(
    "q_middle - q is not projected, or the other part of it is kept",
    "Which part of q_middle - q is J^+ J (q_middle - q)?",
    kept=(lambda J: np.eye(J.shape[1]), lambda J: np.linalg.pinv(J) @ J),
)
def no_projection(q, J, q_middle, gain, kept):
    return q + gain * kept(J) @ (q_middle - q)


@EXERCISE.mistake(
    "q_middle - q is wrapped to less than half a revolution",
    "Is a joint at 4 pi in the same place within its range as a joint at 0?",
    wrap=(lambda q: np.arctan2(np.sin(q), np.cos(q)), lambda q: q % (2 * np.pi)),
)
def difference_wrapped(q, J, q_middle, gain, wrap):
    return q + gain * _projector(J) @ wrap(q_middle - q)


@EXERCISE.mistake(
    "the answer is brought between -pi and pi, or between 0 and 2 pi",
    "Does the formula in the task change an angle by whole revolutions?",
    wrap=(lambda q: np.arctan2(np.sin(q), np.cos(q)), lambda q: q % (2 * np.pi)),
)
def wrapped(*case, wrap):
    return wrap(right(*case))
