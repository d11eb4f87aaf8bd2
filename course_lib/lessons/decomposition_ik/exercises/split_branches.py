"""split_branches: the samples of one cell in two clusters, one for each elbow."""

import functools

import numpy as np
from sklearn.cluster import KMeans
from threadpoolctl import ThreadpoolController

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.tolerances import FOUR_DIGITS
from course_lib.checks.vocabulary import SAME_TWICE, compared, remembered, two_link_angles

_ROUNDING = 1e-12  # of a sum of squares that is 0
_ONE_SAMPLE = Mistake(
    "the case of fewer than two different samples is not treated separately",
    "How many different samples does k-means need? What does the task ask for if there are fewer?",
)
_CENTRES = Mistake(
    "the centres of the clusters are returned",
    "Which attribute of KMeans holds one label for each sample?",
)


@functools.cache
def _thread_pools():
    """The thread pools of the libraries, scikit-learn's among them; finding them takes as long as
    k-means."""
    return ThreadpoolController()


@remembered
def k_means(points, n_init=10):
    """Return the labels of two clusters by scikit-learn, in one thread: so few points take far
    longer in several."""
    with _thread_pools().limit(limits=1):
        return KMeans(2, n_init=int(n_init), random_state=0).fit_predict(points)


def several(q):
    """Return whether there are two different samples at least."""
    return len(q) > 1 and bool((np.asarray(q) != q[0]).any())


def labelled(q, number=lambda own: own[:, 1].mean(), n_init=10):
    """Return the clusters of q, of which the one with the larger number(samples) is 0; as they come
    for None."""
    q = np.asarray(q, float)
    if not several(q):
        return np.zeros(len(q), int)
    labels = k_means(q, n_init)
    in_order = number is None or number(q[labels == 0]) > number(q[labels == 1])
    return labels if in_order else 1 - labels


def split_branches(q):
    """Return labels (m,) of two clusters by k-means, 0 for the one with the larger mean q2."""
    return labelled(q, n_init=1)


def _both_elbows(rng, middle, up, down):
    xy = np.array(middle) + rng.uniform(-0.05, 0.05, (up + down, 2))
    return np.concatenate([two_link_angles(xy[:up])[:, 0], two_link_angles(xy[up:])[:, 1]])


def lumps(rng, *each):
    """Return lumps of samples, each (q1, q2, half widths, how many): q1 and q2 are exactly the
    mean."""
    found = []
    for q1, q2, *widths, n in each:
        points = rng.uniform(-1, 1, (n, 2))
        found.append([q1, q2] + (points - points.mean(axis=0)) * widths)
    return np.concatenate(found)


def _one_elbow(rng):
    """Elongated clouds of samples of one elbow; comments say what makes each of them hard."""
    largest = lumps(
        rng, (0.4, 0.55, 0.04, 0.01, 12), (1.6, 0.5, 0.04, 0.2, 12)
    )  # is not in the one of larger mean
    smallest = lumps(rng, (0.4, -0.5, 0.04, 0.2, 12), (1.6, -0.55, 0.04, 0.01, 12))  # nor is this
    level = lumps(rng, (0.4, 0.5, 0.1, 0.05, 12), (1.6, 0.5, 0.1, 0.05, 12))
    slightly = np.repeat([[0, 1e-7], [0, 0]], 12, axis=0)  # the first lump has the larger mean q2
    towers = lumps(rng, *[(x, 0.6 + y, 0.15, 0.005, n) for x, y, n in _TOWERS])
    return [
        rng.permutation(
            lumps(rng, (0.4, 1.3, 0.06, 0.1, 12), (0.8, 0.6, 0.06, 0.1, 12))
        ),  # q2 > 0 in both
        rng.permutation(
            lumps(rng, (0.4, -1.3, 0.06, 0.1, 11), (0.8, -0.6, 0.06, 0.1, 13))
        ),  # q2 < 0 in both
        rng.permutation(
            lumps(rng, (0.8, 0.02, 0.06, 0.07, 12), (0.85, 0.7, 0.06, 0.07, 12))
        ),  # nearly stretched
        rng.permutation(
            lumps(rng, (0.6, 0.9, 0.05, 0.05, 4), (0.8, 0.3, 0.05, 0.05, 20))
        ),  # the sum is not the mean
        *(largest, largest[::-1], smallest, smallest[::-1]),
        *(level + slightly, level - slightly),
        rng.permutation(
            lumps(rng, (3.1, 0.6, 0.3, 0.05, 12), (3.2, -0.6, 0.3, 0.05, 12))
        ),  # q1 is below pi in some samples, and above in others
        np.array(_SKEWED),  # the cluster of the larger mean has the smaller median
        rng.permutation(towers),  # q1 tells more than q2, unless both are scaled
        rng.permutation(towers)[:, ::-1],  # and here q2
    ]


_SKEWED = [[0.2, 0.0], [0.2, 0.1], [0.2, 0.2], [1.8, 0.3], [1.8, 0.4], [1.8, -0.6]]
# Means of q2 of 1/2 and 1/3; whichever cluster comes first.
_FRACTIONS = (
    [[0, 1], [0, 0], [9, 0], [9, 0], [9, 1]],
    [[9, 0], [9, 0], [9, 1], [0, 1], [0, 0]],
)
_NEAR = 1e-6  # rad: np.allclose takes angles for equal that differ by less than 1e-5 of their size
_TOWERS = [(0.6, 0.1, 8), (0.6, -0.1, 4), (1.4, 0.1, 4), (1.4, -0.1, 8)]


def _cases(rng):
    first = _both_elbows(rng, (1.2, 1.3), 3, 3)
    one = two_link_angles(np.array([[1.0, 1.3], [0.9, 1.4]]))
    equal = [
        one[0, 1:],
        one[1, :1],
        one[0, [0, 0]],
        one[1, [1] * 5],
        one[[0, 0, 1, 1, 1], [1, 1, 0, 0, 0]],
    ]
    cells = [((0.2, 1.75), 12, 12), ((1.1, 1.4), 22, 3), ((-0.3, 1.8), 3, 22)]
    cells = [rng.permutation(_both_elbows(rng, *cell)) for cell in cells]
    near = rng.uniform(0.4, 1.6, 2) + _NEAR * np.array([[0, 0], [1, -1]])
    pair = _both_elbows(rng, (0.4, 1.6), 1, 1)[::-1]
    whole = np.array([[0, 1], [1, -1], [0, 2], [2, -1]])
    whole_with_fractions = map(np.array, _FRACTIONS)
    samples = [
        first,
        whole,
        *whole_with_fractions,
        first[::-1],
        pair,
        *equal,
        near[[0, 1, 0, 1, 1]],
        *cells,
        *_one_elbow(rng),
        np.zeros((0, 2)),
    ]
    return [*((q.copy(),) for q in samples), (first.tolist(),)]


def _within(q, labels):
    """Return the sum of the squared distances of the samples from the mean of their cluster."""
    q = np.asarray(q, float)
    return sum(
        ((own - own.mean(axis=0)) ** 2).sum()
        for own in (q[labels == k] for k in (0, 1))
        if len(own)
    )


def _means(labels, q):
    mean = [np.asarray(q)[labels == k, 1].mean() for k in (0, 1)]
    return (
        f"The mean q2 of your cluster 0 is {mean[0]:.4g}, and that of your cluster 1 is "
        f"{mean[1] - mean[0]:.2g} larger."
    )


EXERCISE = Exercise(
    name="split_branches",
    points=2,
    arguments=("q",),
    tolerance=FOUR_DIGITS,
    cases=_cases,
    returns=numbers(
        lambda q: (len(q),),
    ),
    library=split_branches,
    tries_arguments=False,
    properties=(
        Property(
            "each label is 0 or 1",
            lambda labels, q: np.isin(labels, (0, 1)).all(),
            says=lambda labels, q: (
                f"One of your labels is {labels[~np.isin(labels, (0, 1))][0]:.4g}."
            ),
            otherwise=Question(
                "there are other labels than 0 and 1",
                "By which numbers does the task call the two clusters, and what do yours stand "
                "for?",
            ),
        ),
        Property(
            "with fewer than two different samples there is nothing to split: all labels are 0",
            lambda labels, q: not labels.any(),
            where=lambda q: not several(q),
            otherwise=Question(
                _ONE_SAMPLE.name,
                "How many different samples are there? What does the task ask for if there are "
                "fewer than two, and which line of yours sees to it?",
            ),
        ),
        SAME_TWICE,
        Property(
            "both labels occur, wherever there are two different samples",
            lambda labels, q: labels.any() and not labels.all(),
            where=several,
            otherwise=Question(
                "all samples have the same label",
                "Which labels does k-means give for these samples, and what does your code do with "
                "them?",
            ),
        ),
        Property(
            "the samples lie as near to the means of their clusters as two clusters can bring "
            "them: the sum of the "
            "squared distances is the least",
            lambda labels, q: (
                _within(q, labels) <= (1 + FOUR_DIGITS) * _within(q, labelled(q)) + _ROUNDING
            ),
            says=lambda labels, q: (
                "The least sum is " + compared(_within(q, labelled(q)), _within(q, labels)) + "."
            ),
            where=several,
        ),
        Property(
            "cluster 0 is the one whose mean q2 is the larger",
            lambda labels, q: np.array_equal(labels, labelled(q)),
            says=_means,
            where=several,
            otherwise=Question(
                "cluster 0 has the smaller mean q2",
                "Which numbers does your code compare to decide which cluster is 0?",
            ),
        ),
    ),
    hints=(
        "K-means may call either cluster 0. In which case are its labels right without a change?",
        "Compare the mean q2 of both clusters, centres[0, 1] and centres[1, 1]. Which array has 0 "
        "in place of 1, and 1 in place of 0?",
        "If the first is the smaller one, 1 - labels exchanges the two.",
    ),
)

EXERCISE.mistake(_CENTRES, form=lambda array, q: len(q) > 2 and array.shape == (2, 2))
EXERCISE.mistake(_ONE_SAMPLE, raises=("ValueError", "should be >= n_clusters"))


def _other(q, **changes):
    """The labels of a student who changes a step; None if there is nothing to cut."""
    return labelled(q, **changes) if several(q) else None


@EXERCISE.mistake(
    "the labels are swapped in some cells, or in all",
    "Which cluster does KMeans call 0, and which cluster should be 0?",
    n_init=(1, 10),
    swapped=(False, True),
)
def not_renumbered(q, n_init, swapped):
    return 1 - labelled(q) if swapped and several(q) else _other(q, number=None, n_init=n_init)


@EXERCISE.mistake(
    "the samples are split by the sign of q2",
    "Which labels did k-means give, and what does your code still have to decide?",
    every=(True, False),
)
def by_the_sign(q, every):
    return (np.asarray(q)[:, 1] < 0).astype(int) if every or several(q) else None


@EXERCISE.mistake(
    "the cluster of the first sample, or of the last one, is always 0",
    "May the order of the samples decide which cluster is 0?",
    sample=(0, -1),
)
def by_the_order(q, sample):
    labels = _other(q)
    return labels if labels is None or labels[sample] == 0 else 1 - labels


@EXERCISE.mistake(
    "the clusters are not numbered by their mean q2",
    "Which column of q does the task name, and which function of it?",
    number=(
        lambda own: own[:, 0].mean(),
        lambda own: -own[:, 0].mean(),
        lambda own: own[:, 1].sum(),
        lambda own: abs(own[:, 1].mean()),
        len,
        lambda own: own.mean(),
        lambda own: own[:, 1].max(),
        lambda own: own[:, 1].min(),
    ),
)
def ordered_otherwise(q, number):
    return _other(q, number=number)
