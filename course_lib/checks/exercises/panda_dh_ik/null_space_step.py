"""null_space_step: a step towards the middle of the joint ranges that does not move the end-effector."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.panda_dh_ik.shared import HIGH, LOW, panda_jacobian, truncated
from course_lib.checks.vocabulary import away_from_zero, few_digits, near, wrong_steps

_OTHER_SIZE = Mistake(
    "J J^+ stands for J^+ J, or I has another size", "The projector acts on joint motions: it is (n, n)."
)
_PROJECTOR = "J^+ J projects on the joint motions that move the end-effector. Which projector keeps the others?"
_SINGULAR = Mistake("J J^T is inverted, which fails at a singularity", "np.linalg.pinv works there too.")
_FLAT = np.array([[1.0, 0, 0], [0, 1, 0]])


def _projector(J):
    return np.eye(J.shape[1]) - np.linalg.pinv(J) @ J


def right(q, J, q_middle, gain):
    """Return the right answer."""
    return q + gain * _projector(J) @ (q_middle - q)


def _cases(rng):
    middle = (LOW + HIGH) / 2
    simple = np.array([0.1, 0.2, 0.3]), _FLAT, np.array([1.0, 1, 1]), 0.5
    drawn = [
        (away_from_zero(rng, n), away_from_zero(rng, (m, n)), away_from_zero(rng, n), gain)
        for m, n, gain in ((2, 4, 0.2), (1, 3, 1.0), (3, 5, -0.4))
    ]
    panda = [np.round(rng.uniform(LOW, HIGH), 2) for _ in range(3)]
    drawn += [(q, panda_jacobian(q), middle, gain) for q, gain in zip(panda, (0.1, 1.0, 0.05), strict=True)]
    stretched = np.array([0.2, 0, 0.4, 0, 0.3, 0, 0.5])  # a singularity: J J^T has no inverse
    whole = np.array([1, 2, 3]), np.array([[1, 1, 0], [0, 1, 1]]), np.array([3, 1, 1]), 0.25
    return [
        simple,
        *drawn,
        (panda[0], panda_jacobian(panda[0]), panda[0], 0.3),
        (stretched, panda_jacobian(stretched), middle, 0.2),
        whole,
    ]


EXERCISE = Exercise(
    name="null_space_step",
    points=2,
    arguments=("q", "J", "q_middle", "gain"),
    cases=_cases,
    returns=numbers(
        lambda q, *rest: (len(q),),
        lambda array, q, *rest: (
            Mistake("the projector is returned, not the joint angles", "Apply it to q_middle - q, and add q.")
            if array.shape == (len(q), len(q))
            else None
        ),
    ),
    properties=(
        Property(
            "to first order the end-effector stays: J times the change of q is 0",
            lambda answer, q, J, q_middle, gain: near(J @ (answer - q), np.zeros(len(J))),
            says=lambda answer, q, J, *rest: f"Yours moves it at {np.abs(J @ (answer - q)).max():.3g}.",
        ),
        Property(
            "of all such changes this one is closest to gain (q_middle - q)",
            lambda answer, *case: near(answer, right(*case)),
        ),
    ),
    mistakes=(
        few_digits(right),
        Mistake(
            "the step goes towards the middle without regard to J",
            _PROJECTOR,
            lambda q, J, q_middle, gain: q + gain * (q_middle - q),
        ),
        Mistake(
            "only the motion that moves the end-effector is kept",
            _PROJECTOR,
            lambda q, J, q_middle, gain: q + gain * np.linalg.pinv(J) @ J @ (q_middle - q),
        ),
        *wrong_steps(right),
        Mistake(
            "gain is not used",
            "The step is multiplied by gain.",
            lambda q, J, q_middle, gain: right(q, J, q_middle, 1.0),
        ),
        Mistake(
            "the step goes towards 0, or along q_middle",
            "The direction is q_middle - q.",
            lambda q, J, q_middle, gain: q - gain * _projector(J) @ q,
            lambda q, J, q_middle, gain: q + gain * _projector(J) @ q_middle,
        ),
        Mistake(
            "q is projected too",
            "Only the step is projected.",
            lambda q, J, q_middle, gain: _projector(J) @ (q + gain * (q_middle - q)),
        ),
        Mistake(
            "J^T J stands for J^+ J",
            "The transpose is not the pseudoinverse: J^T J is no projector.",
            lambda q, J, q_middle, gain: q + gain * (np.eye(len(q)) - J.T @ J) @ (q_middle - q),
        ),
        Mistake(
            "the unit matrix is an array of ones, or the products are entry by entry",
            _PROJECTOR,
            lambda q, J, q_middle, gain: q + gain * (1 - np.linalg.pinv(J) @ J) @ (q_middle - q),
        ),
        Mistake(
            _SINGULAR.name,
            _SINGULAR.hint,
            seen=lambda answer, q, J, *rest: np.linalg.svd(J, compute_uv=False)[-1] < 1e-9,
        ),
        truncated(right),
    ),
    hints=(
        "The pseudoinverse J^+ gives the shortest joint motion for a motion of the end-effector. J^+ J takes out of "
        "any joint motion the part that moves the end-effector.",
        "The step is gain (I - J^+ J)(q_middle - q). np.linalg.pinv has the pseudoinverse, at singularities too.",
        "q + gain * (np.eye(len(q)) - np.linalg.pinv(J) @ J) @ (q_middle - q)",
    ),
    library=right,
    errors=(
        ("LinAlgError", "Singular", _SINGULAR),
        ("ValueError", "core dimension", _OTHER_SIZE),
        ("ValueError", "could not be broadcast", _OTHER_SIZE),
    ),
)
