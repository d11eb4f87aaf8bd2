"""branch_by_sign: find the bug. The samples of one elbow are split in two."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.decomposition_ik.split_branches import split_branches
from course_lib.checks.decomposition_ik.two_links import both_elbows_at
from course_lib.checks.exercise import Exercise, Mistake, Property


def right(theta):
    """Return 0 for each sample with theta2 >= 0 and 1 for the others, (m,)."""
    return np.where(theta[:, 1] < 0, 1, 0)


def _one_elbow(theta):
    return len(set(right(theta))) < 2


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
    arguments=("theta",),
    cases=_cases,
    returns=numbers(lambda theta: (len(theta),)),
    properties=(
        Property(
            "samples of one elbow all have the same label: 0 if theta2 >= 0, 1 if theta2 < 0",
            lambda labels, theta: np.array_equal(labels, right(theta)),
            where=_one_elbow,
        ),
        Property(
            "the label of a sample is 0 if its theta2 >= 0, and 1 if its theta2 < 0",
            lambda labels, theta: np.array_equal(labels, right(theta)),
        ),
    ),
    mistakes=(
        Mistake(
            "the labels are swapped",
            "Branch 0 is the one with theta2 >= 0, as in ik_2r.",
            lambda theta: 1 - right(theta),
            lambda theta: np.where(theta[:, 1] > 0, 1, 0),
        ),
        Mistake("theta2 = 0 is in branch 1", "0 is not negative.", lambda theta: np.where(theta[:, 1] <= 0, 1, 0)),
        Mistake("theta1 decides", "The elbow bends by theta2.", lambda theta: np.where(theta[:, 0] < 0, 1, 0)),
        Mistake(
            "the signs themselves are returned",
            "The labels are 0 and 1.",
            lambda theta: np.sign(theta[:, 1]),
            lambda theta: -np.sign(theta[:, 1]),
        ),
        Mistake(
            "the samples are compared with their own mean",
            "A cell of one elbow has no zero between its samples. Compare with a fixed angle.",
            lambda theta: np.where(theta[:, 1] < theta[:, 1].sum() / max(len(theta), 1), 1, 0),
            lambda theta: np.where(theta[:, 1] < np.median(theta[:, 1]), 1, 0) if len(theta) else None,
        ),
        Mistake(
            "every cell is still split by k-means if its samples have both signs",
            "Which elbow a sample belongs to does not depend on the other samples.",
            lambda theta: right(theta) if _one_elbow(theta) else split_branches(theta),
        ),
    ),
    hints=(
        "Run the broken code on samples that all have theta2 > 0. How many elbows does it report?",
        "Each sample carries the answer in itself; the other samples of its cell are not needed.",
        "Compare theta[:, 1] with 0; a comparison gives True and False, which astype(int) turns into 1 and 0.",
    ),
    library=right,
    broken=split_branches,
)
