"""branch_by_sign: find the bug. The samples of one elbow are split in two."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.kinds import Kind, some_equal, whole_numbers
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import ON_BOTH_SIDES
from course_lib.checks.vocabulary import two_link_angles
from course_lib.lessons.decomposition_ik.exercises.split_branches import split_branches

_SMALL = 0.05  # rad: of an angle that somebody may take for 0


def _right(q):
    """Return 0 for each sample with q2 >= 0 and 1 for the others, (m,)."""
    return np.where(q[:, 1] < 0, 1, 0)


def _at_the_widest_gap(q):
    order = np.argsort(-q[:, 1])
    gaps = -np.diff(q[order, 1])
    return (np.argsort(order) > (gaps.argmax() if len(gaps) else 0)).astype(int)


def _one_elbow(q):
    return len(set(_right(q))) < 2


def _named(rng):
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
    whole = np.array([[1.0, -2], [0, 0], [-3, 1], [2, -1]])
    few = np.array([[0.4, -0.2]]), np.array([[0.4, -0.0]]), np.zeros((0, 2))
    positive, negative, stretched, tiny, far = (
        np.column_stack([np.round(rng.uniform(-0.5, 1.5, len(q)), 2), q[:, 1]])
        for q in (positive, negative, stretched, tiny, far)
    )
    tiny[:, 0] = np.rint(tiny[:, 0])  # one column holds whole numbers, and the other does not
    samples = (both, positive, negative, stretched, drawn, lopsided)
    return [*samples, tiny, zeros, far, whole, *few]


_SAMPLES = Kind(
    drawn=lambda rng: rng.uniform([0, -1], [2.9, 1], (int(rng.integers(2, 9)), 2)),
    named=_named,
    beside=(("q2 nearly 0", lambda rng, q2: np.array([[0.4, q2], [0.7, 0.3]]), ON_BOTH_SIDES),),
    coarse=lambda rng: some_equal(rng, whole_numbers(rng, (int(rng.integers(1, 5)), 2))),
)


def _found(labels, q):
    k = int(np.argmax(labels != _right(q)))
    return f"Sample {k} has q2 = {float(q[k, 1])!r}; its label in your answer is {labels[k]:g}."


def _small_negative_is_zero(labels, q):
    other = q[labels != _right(q), 1]
    return bool(((other < 0) & (other > -_SMALL)).all())


def _still_split(one_elbow, cut):
    """Return the answer that cuts only samples of both signs."""
    return lambda q: one_elbow(q) if _one_elbow(q) else cut(q)


def _branch_0(q):
    return 0 * _right(q)


EXERCISE = declared(
    "branch_by_sign",
    points=1,
    arguments={"q": _SAMPLES},
    library=_right,
    broken=_at_the_widest_gap,
    says="the label of a sample is 0 if its q2 >= 0, and 1 if its q2 < 0, whatever the other "
    "samples are",
    found=_found,
    otherwise=Question(
        "a sample does not have the label that its own q2 gives",
        "Which line gives this sample its label, and which numbers does that line look at?",
    ),
    hints=(
        "Run the broken code on samples that all have q2 > 0. How many branches does it report?",
        "The q2 of a sample decides its label. The other samples of the cell do not matter.",
        "Compare q[:, 1] with 0; a comparison gives True and False, which astype(int) turns into 1 "
        "and 0.",
    ),
    mistakes=(
        Mistake(
            "q2 = 0 is in branch 1",
            "On which side of the comparison in the task is 0?",
            lambda q: q[:, 1] <= 0,
        ),
        Mistake(
            "the zero with a minus sign, -0.0, is in branch 1",
            "Is -0.0 >= 0 true in Python?",
            lambda q: np.signbit(q[:, 1]),
        ),
        Mistake(
            "a small negative q2 counts as 0",
            "Which number does the task compare q2 with?",
            seen=_small_negative_is_zero,
        ),
        Mistake(
            "the sine of q2 decides",
            "What is the sign of the sine beyond pi?",
            lambda q: np.sin(q[:, 1]) < 0,
        ),
        Mistake(
            "samples of both signs are still cut at a gap, or by k-means",
            "What happens if the two clouds touch?",
            _still_split(_right, split_branches),
            _still_split(_right, _at_the_widest_gap),
            _still_split(_branch_0, split_branches),
            _still_split(_branch_0, _at_the_widest_gap),
        ),
        Mistake(
            "samples that all have q2 < 0 are in branch 0",
            "Does their label depend on the other samples of the cell?",
            lambda q: _branch_0(q) if _one_elbow(q) else None,
        ),
    ),
)
