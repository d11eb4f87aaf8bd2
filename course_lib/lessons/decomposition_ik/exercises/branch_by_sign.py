"""branch_by_sign: find the bug. The samples of one elbow are split in two."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.special_cases import ON_BOTH_SIDES, Sweep
from course_lib.checks.vocabulary import two_link_angles
from course_lib.lessons.decomposition_ik.exercises.split_branches import split_branches

_SMALL = 0.05  # rad: of an angle that somebody may take for 0


def right(q):
    """Return 0 for each sample with q2 >= 0 and 1 for the others, (m,)."""
    return np.where(q[:, 1] < 0, 1, 0)


def _at_the_widest_gap(q):
    order = np.argsort(-q[:, 1])
    gaps = -np.diff(q[order, 1])
    return (np.argsort(order) > (gaps.argmax() if len(gaps) else 0)).astype(int)


def _one_elbow(q):
    return len(set(right(q))) < 2


def _cases(rng):
    """Return samples whose q2 are special and stand in every set; most of their q1, which decide
    nothing, are drawn."""
    both = np.array([[0.1, 1.0], [1.1, -1.0], [0.2, 1.1], [1.2, -1.1]])
    positive = np.array([[0.5, 0.7], [0.6, 0.9], [0.7, 0.4], [0.4, 1.2]])
    negative = positive * [1, -1] + [1.0, 0]
    stretched = np.array(
        [[0.8, 0.05], [0.9, -0.05], [0.85, 0.0], [1.4, 0.3], [0.3, -0.4], [0.2, -1e-6]]
    )
    drawn = rng.permutation(
        np.concatenate(two_link_angles(np.array([0.6, 1.3]) + rng.uniform(-0.03, 0.03, (9, 2))))
    )
    lopsided = rng.uniform([0, -0.1], [2.9, 0.9], (12, 2))
    # No angle is too small to have a sign; -0.0 is 0, and an angle beyond pi keeps its own.
    tiny = np.array([[0.4, size] for size in (-1e-3, -1e-9, -1e-300, 1e-300)])
    zeros = np.array([[0.3, 0.0], [-0.2, -0.0], [-0.0, 0.1], [0.5, -0.1]])
    far = np.array([[0.1, 3.5], [0.2, -3.5], [-4.0, 6.0], [7.0, -6.5], [0.3, 8.0]])
    whole = np.array([[1, -2], [0, 0], [-3, 1], [2, -1]])
    few = np.array([[0.4, -0.2]]), np.array([[0.4, -0.0]]), np.zeros((0, 2))
    positive, negative, stretched, tiny, far = (
        np.column_stack([np.round(rng.uniform(-0.5, 1.5, len(q)), 2), q[:, 1]])
        for q in (positive, negative, stretched, tiny, far)
    )
    samples = (both, positive, negative, stretched, drawn, lopsided)
    return [(q,) for q in (*samples, tiny, zeros, far, whole, *few)]


def _first_off(labels, q):
    k = int(np.argmax(labels != right(q)))
    return f"Sample {k} has q2 = {float(q[k, 1])!r}; its label in your answer is {labels[k]:g}."


EXERCISE = Exercise(
    name="branch_by_sign",
    points=1,
    arguments=("q",),
    cases=_cases,
    returns=numbers(lambda q: (len(q),)),
    library=right,
    sweeps=(
        Sweep("q2 nearly 0", lambda rng, q2: (np.array([[0.4, q2], [0.7, 0.3]]),), ON_BOTH_SIDES),
    ),
    broken=_at_the_widest_gap,
    properties=(
        Property(
            "the label of a sample is 0 if its q2 >= 0, and 1 if its q2 < 0, whatever the other "
            "samples are",
            lambda labels, q: np.array_equal(labels, right(q)),
            says=_first_off,
            mistake=Mistake(
                "a sample does not have the label that its own q2 gives",
                "Which comparison gives the label of the sample named below?",
            ),
        ),
    ),
    hints=(
        "Run the broken code on samples that all have q2 > 0. How many branches does it report?",
        "The q2 of a sample decides its label. The other samples of the cell do not matter.",
        "Compare q[:, 1] with 0; a comparison gives True and False, which astype(int) turns into 1 "
        "and 0.",
    ),
)


@EXERCISE.mistake(
    "q2 = 0 is in branch 1",
    "On which side of the comparison in the task is 0?",
)
def zero_is_negative(q):
    return q[:, 1] <= 0


@EXERCISE.mistake(
    "the zero with a minus sign, -0.0, is in branch 1",
    "Is -0.0 >= 0 true in Python?",
)
def sign_of_minus_zero(q):
    return np.signbit(q[:, 1])


@EXERCISE.mistake(
    "a small negative q2 counts as 0",
    "Which number does the task compare q2 with?",
    recognises=True,
)
def tiny_angle_is_zero(labels, q):
    other = q[labels != right(q), 1]
    return bool(((other < 0) & (other > -_SMALL)).all())


@EXERCISE.mistake(
    "the sine of q2 decides",
    "What is the sign of the sine beyond pi?",
)
def sign_of_the_sine(q):
    return np.sin(q[:, 1]) < 0


@EXERCISE.mistake(
    "samples of both signs are still cut at a gap, or by k-means",
    "What happens if the two clouds touch?",
    one_elbow=(right, lambda q: 0 * right(q)),
    cut=(split_branches, _at_the_widest_gap),
)
def still_split(q, one_elbow, cut):
    return one_elbow(q) if _one_elbow(q) else cut(q)


@EXERCISE.mistake(
    "samples that all have q2 < 0 are in branch 0",
    "Does their label depend on the other samples of the cell?",
)
def one_elbow_is_branch_0(q):
    return 0 * right(q) if _one_elbow(q) else None
