"""branch_by_sign: find the bug. The samples of one elbow are split in two."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.vocabulary import two_link_angles
from course_lib.lessons.decomposition_ik.exercises.split_branches import split_branches


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
    tiny = np.array([[0.4, size] for size in (-1e-3, -1e-9, -1e-12, -1e-15, -1e-300, 1e-300)])
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


EXERCISE = Exercise(
    name="branch_by_sign",
    points=1,
    arguments=("q",),
    cases=_cases,
    returns=numbers(lambda q: (len(q),)),
    library=right,
    broken=_at_the_widest_gap,
    properties=(
        Property(
            "the label of a sample is 0 if its q2 >= 0, and 1 if its q2 < 0, whatever the other "
            "samples are",
            lambda labels, q: np.array_equal(labels, right(q)),
            mistake=Mistake(
                "a sample has another label than its own q2 says", "Where does label 1 begin?"
            ),
        ),
    ),
    hints=(
        "Run the broken code on samples that all have q2 > 0. How many elbows does it report?",
        "Each sample carries the answer in itself; the other samples of its cell are not needed.",
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
    "-0.0 is in branch 1",
    "numpy has a zero with a minus sign: how does it compare with 0?",
)
def sign_of_minus_zero(q):
    return np.signbit(q[:, 1])


@EXERCISE.mistake(
    "a small negative q2 counts as 0",
    "Which number does the task compare q2 with?",
    tolerance=(1e-16, 1e-13, 1e-10, 1e-8, 1e-4),
)
def tiny_angle_is_zero(q, tolerance):
    return q[:, 1] < -tolerance


@EXERCISE.mistake(
    "the sine of q2 decides",
    "What is the sign of the sine beyond pi?",
)
def sign_of_the_sine(q):
    return np.sin(q[:, 1]) < 0


@EXERCISE.mistake(
    "samples of both signs are still cut at a gap, or by k-means",
    "What if the two clouds touch?",
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
