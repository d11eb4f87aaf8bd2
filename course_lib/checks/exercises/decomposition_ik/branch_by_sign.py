"""branch_by_sign: find the bug. The samples of one elbow are split in two."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercises.decomposition_ik.shared import both_elbows_at
from course_lib.checks.exercises.decomposition_ik.split_branches import split_branches
from course_lib.checks.exercise import Exercise, Mistake, Property


def right(q):
    """Return 0 for each sample with q2 >= 0 and 1 for the others, (m,)."""
    return np.where(q[:, 1] < 0, 1, 0)


def _one_elbow(q):
    return len(set(right(q))) < 2


def _cases(rng):
    both = np.array([[0.1, 1.0], [1.1, -1.0], [0.2, 1.1], [1.2, -1.1]])
    positive = np.array([[0.5, 0.7], [0.6, 0.9], [0.7, 0.4], [0.4, 1.2]])
    negative = positive * [1, -1] + [1.0, 0]
    stretched = np.array([[0.8, 0.05], [0.9, -0.05], [0.85, 0.0], [1.4, 0.3], [0.3, -0.4], [0.2, 0.02]])
    drawn = rng.permutation(both_elbows_at(rng, (0.6, 1.3), 9))
    lopsided = rng.uniform([0, -0.1], [2.9, 0.9], (12, 2))
    single = np.array([[0.4, -0.2]])
    return [(each,) for each in (both, positive, negative, stretched, drawn, lopsided, single, np.zeros((0, 2)))]


EXERCISE = Exercise(
    name="branch_by_sign",
    points=1,
    arguments=("q",),
    cases=_cases,
    returns=numbers(lambda q: (len(q),)),
    properties=(
        Property(
            "samples of one elbow all have the same label: 0 if q2 >= 0, 1 if q2 < 0",
            lambda labels, q: np.array_equal(labels, right(q)),
            where=_one_elbow,
        ),
        Property(
            "the label of a sample is 0 if its q2 >= 0, and 1 if its q2 < 0",
            lambda labels, q: np.array_equal(labels, right(q)),
        ),
    ),
    mistakes=(
        Mistake(
            "the labels are swapped",
            "Branch 0 is the one with q2 >= 0, as in ik_2r.",
            lambda q: 1 - right(q),
            lambda q: np.where(q[:, 1] > 0, 1, 0),
        ),
        Mistake(
            "samples that all have q2 < 0 are in branch 0",
            "Branch 1 is theirs, even if there is no other sample in the cell.",
            lambda q: 0 * right(q) if _one_elbow(q) else right(q),
        ),
        Mistake("q2 = 0 is in branch 1", "0 is not negative.", lambda q: np.where(q[:, 1] <= 0, 1, 0)),
        Mistake("q1 decides", "The elbow bends by q2.", lambda q: np.where(q[:, 0] < 0, 1, 0)),
        Mistake(
            "the signs themselves are returned",
            "The labels are 0 and 1.",
            lambda q: np.sign(q[:, 1]),
            lambda q: -np.sign(q[:, 1]),
        ),
        Mistake(
            "the samples are compared with their own mean",
            "A cell of one elbow has no zero between its samples. Compare with a fixed angle.",
            lambda q: np.where(q[:, 1] < q[:, 1].sum() / max(len(q), 1), 1, 0),
            lambda q: np.where(q[:, 1] < np.median(q[:, 1]), 1, 0) if len(q) else None,
        ),
        Mistake(
            "every cell is still split by k-means if its samples have both signs",
            "Which elbow a sample belongs to does not depend on the other samples.",
            lambda q: right(q) if _one_elbow(q) else split_branches(q),
            lambda q: 0 * right(q) if _one_elbow(q) else split_branches(q),
        ),
    ),
    hints=(
        "Run the broken code on samples that all have q2 > 0. How many elbows does it report?",
        "Each sample carries the answer in itself; the other samples of its cell are not needed.",
        "Compare q[:, 1] with 0; a comparison gives True and False, which astype(int) turns into 1 and 0.",
    ),
    library=right,
    broken=split_branches,
)
