"""split_branches: the samples of one cell in two clusters, one for each elbow."""

import functools
from dataclasses import replace

import numpy as np
from sklearn.cluster import KMeans
from threadpoolctl import ThreadpoolController

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercises.decomposition_ik.shared import (
    best_split,
    lump,
    position,
    rewired,
    several,
    solutions,
    split,
    with_a_list,
    within,
)
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.vocabulary import SAME_TWICE

_RANDOM = Mistake(
    "the labels depend on a random start",
    "With KMeans(n_clusters=2, random_state=0) the same samples get the same labels each time.",
)
_ONE_SAMPLE = Mistake(
    "equal samples, or a single one, are not treated apart",
    "Count the different samples with len(np.unique(q, axis=0)); for 0 or 1 return zeros.",
)
_CENTRES = Mistake("the centres of the clusters are returned", "One label for each sample: labels_ of the KMeans.")


def k_means(points, **settings):
    """Return the labels of two clusters by scikit-learn, in one thread: so few points take far longer in several."""
    with _thread_pools().limit(limits=1):
        return KMeans(2, **settings).fit_predict(points)


@functools.cache
def _thread_pools():
    """The thread pools of the libraries, scikit-learn's among them; finding them takes as long as k-means."""
    return ThreadpoolController()


def both_elbows(rng, middle, up, down, width=0.1):
    """Return joint angles (up + down, 2) of positions in a square cell: first those with q2 > 0."""
    xy = np.array(middle) + rng.uniform(-width / 2, width / 2, (up + down, 2))
    return np.concatenate([solutions(xy[:up])[:, 0], solutions(xy[up:])[:, 1]])


def _two_lumps(rng, one, other):
    """Two lumps of samples, each (middle, widths, how many), in any order."""
    return rng.permutation(np.concatenate([lump(rng, *one), lump(rng, *other)]))


def _one_elbow(rng):
    """Elongated clouds of samples of one elbow; what makes each of them hard for whom stands beside it."""
    tight, wide = (0.04, 0.01), (0.04, 0.2)
    largest = np.concatenate([lump(rng, (0.4, 0.55), tight, 12), lump(rng, (1.6, 0.5), wide, 12)])  # is not the mean
    smallest = np.concatenate([lump(rng, (0.4, -0.5), wide, 12), lump(rng, (1.6, -0.55), tight, 12)])  # nor is this
    towers = [lump(rng, (x, 0.6 + y), (0.15, 0.005), n) for x, y, n in _TOWERS]
    return [
        _two_lumps(rng, ((0.4, 1.3), (0.06, 0.1), 12), ((0.8, 0.6), (0.06, 0.1), 12)),  # q2 > 0 in both
        _two_lumps(rng, ((0.4, -1.3), (0.06, 0.1), 11), ((0.8, -0.6), (0.06, 0.1), 13)),  # q2 < 0 in both
        _two_lumps(rng, ((0.8, 0.02), (0.06, 0.07), 12), ((0.85, 0.7), (0.06, 0.07), 12)),  # nearly stretched
        _two_lumps(rng, ((0.6, 0.9), (0.05, 0.05), 4), ((0.8, 0.3), (0.05, 0.05), 20)),  # the sum is not the mean
        *(largest, largest[::-1]),
        *(smallest, smallest[::-1]),
        rng.permutation(np.concatenate(towers)),  # q1 tells more than q2, unless both are scaled
        rng.permutation(np.concatenate(towers))[:, ::-1],  # and here q2
    ]


_TOWERS = [(0.6, 0.1, 8), (0.6, -0.1, 4), (1.4, 0.1, 4), (1.4, -0.1, 8)]


_TIED = np.array([[1.75, 0.5], [-0.25, 0.5], [0.75, 1.5], [0.75, -0.5]])  # a square on its corner: two cuts are as good
_TIMES = 20  # that it is asked: a random start gives the same cut each time with a chance of one in a million


def _tied(q):
    return np.array_equal(q, _TIED)


def _unless_tied(function):
    """The same function, which says nothing of the square: there a mistake may show either way."""
    return lambda *case: None if _tied(case[-1]) else function(*case)


def _cases(rng):
    first = both_elbows(rng, (1.2, 1.3), 3, 3)
    pair = both_elbows(rng, (0.4, 1.6), 1, 1)[::-1]
    cells = [
        both_elbows(rng, *counted) for counted in (((0.2, 1.75), 12, 12), ((1.1, 1.4), 22, 3), ((-0.3, 1.8), 3, 22))
    ]
    one = solutions(np.array([[1.0, 1.3], [0.9, 1.4]]))
    samples = [
        first,
        first[::-1],
        pair,
        one[0, 1:],
        one[1, :1],
        np.repeat(one[0, :1], 2, axis=0),
        np.repeat(one[1, 1:], 5, axis=0),
        np.repeat(one[0, ::-1], [2, 3], axis=0),
        *(rng.permutation(cell) for cell in cells),
        *_one_elbow(rng),
        np.zeros((0, 2)),
        *[_TIED] * _TIMES,
    ]
    return [(q.copy(),) for q in samples]


def _one_best(q):
    """Return whether there are two different samples at least, and one best cut."""
    return several(q) and not _tied(q)


def _numbered(number):
    """Return the answer of somebody who calls that cluster 0 which has the larger number(q, own)."""
    return lambda q: split(q, number=number)


def _by_limit(joint, *limits):
    """Both ways to name the samples on the two sides of a limit of one joint's angle."""

    def named(limit, compare):
        return lambda q: compare(q[:, joint], limit(q[:, joint])) if several(q) else None

    return [named(limit, compare) for limit in limits for compare in (np.greater, np.less_equal, np.less)]


def _settled(labels, q, by):
    """Return whether wrong labels are a possible end of k-means of by(q): no point is nearer to the other mean."""
    if not several(q) or not labels.any() or labels.all() or _least(labels, q):
        return False
    points = by(q)
    distances = [np.linalg.norm(points - points[labels == k].mean(axis=0), axis=1) for k in (0, 1)]
    return np.array_equal(labels == 1, distances[1] < distances[0])


def _clustered(name, hint, by):
    """The mistake of those who cluster by(q): with the best two clusters, or others at which k-means may end."""
    return Mistake(name, hint, lambda q: split(q, by), seen=lambda labels, q: _settled(labels, q, by))


def _least(labels, q):
    return within(q, labels) <= 1.0001 * within(q, best_split(q)) + 1e-12


def _means(labels, q):
    mean = [q[labels == k, 1].mean() for k in (0, 1)]
    return f"The mean q2 of your cluster 0 is {mean[0]:.4g}, that of your cluster 1 is {mean[1]:.4g}."


def split_branches(q):
    """Return labels (m,) of two clusters by k-means, 0 for the one with the larger mean q2."""
    q = np.asarray(q, float)
    if not several(q):
        return np.zeros(len(q), int)
    labels = k_means(q, random_state=0)
    means = [q[labels == k, 1].mean() for k in (0, 1)]
    return labels if means[0] > means[1] else 1 - labels


_MISTAKES = (
    Mistake(
        "there are more than two clusters",
        "Two elbows, two clusters: KMeans(n_clusters=2).",
        seen=lambda labels, q: {0, 1, 2} <= set(labels) <= set(range(9)),
    ),
    Mistake("the labels are 1 and 2", "Return 0 and 1.", seen=lambda labels, q: set(labels) == {1, 2}),
    Mistake(
        "the labels are swapped: KMeans calls its clusters 0 and 1 in any order",
        "Compare q[labels == 0, 1].mean() with that of labels == 1; return 1 - labels where it is smaller.",
        lambda q: 1 - split(q) if several(q) else None,
        lambda q: k_means(q, random_state=0) if several(q) else None,
    ),
    Mistake(
        "the samples are split by the sign of q2",
        "A cell may hold one elbow only, and q2 has one sign: KMeans still finds two clusters.",
        lambda q: q[:, 1] <= 0 if several(q) else None,
        lambda q: q[:, 1] > 0 if several(q) else None,
        lambda q: q[:, 1] <= 0,
        lambda q: q[:, 1] > 0,
    ),
    _clustered(
        "the positions are clustered, not the joint angles",
        "Both elbows reach the same positions: only q tells them apart.",
        position,
    ),
    _clustered(
        "only q1 is looked at",
        "Both columns of q go into KMeans, as they are.",
        lambda q: q * [1, 0],
    ),
    _clustered(
        "only q2 is looked at",
        "Both columns of q go into KMeans, as they are.",
        lambda q: q * [0, 1],
    ),
    _clustered(
        "the angles are scaled before they are clustered",
        "Both are radians: give q to KMeans as it is.",
        lambda q: (q - q.mean(axis=0)) / np.maximum(q.std(axis=0), 1e-9),
    ),
    Mistake(
        "only q2 is looked at, and the samples are split at its mean or median",
        "The clusters need not be of the same size, and KMeans looks at both angles.",
        *_by_limit(1, np.mean, np.median),
    ),
    Mistake(
        "only q1 is looked at, and the samples are split at its mean or median",
        "KMeans looks at both angles, and sizes may differ.",
        *_by_limit(0, np.mean, np.median),
    ),
    Mistake("the labels are sorted", "Label i belongs to sample i.", lambda q: np.sort(split(q))),
    Mistake(
        "q is sorted before it is clustered",
        "Label i belongs to sample i: leave q as it is.",
        lambda q: split(np.sort(q, axis=0)) if several(q) else None,
        lambda q: split(q[np.argsort(q[:, 0])]) if several(q) else None,
        lambda q: split(q[np.argsort(q[:, 1])]) if several(q) else None,
    ),
    Mistake(
        "the clusters are ordered by q1",
        "q2 is the second column: q[:, 1].",
        _numbered(lambda q, own: q[own, 0].mean()),
        _numbered(lambda q, own: -q[own, 0].mean()),
    ),
    Mistake(
        "the clusters are ordered by the sum of q2",
        "The mean, not the sum: sizes may differ.",
        _numbered(lambda q, own: q[own, 1].sum()),
    ),
    Mistake(
        "the clusters are ordered by their largest or smallest q2",
        "The mean q2 of all samples counts.",
        _numbered(lambda q, own: q[own, 1].max()),
        _numbered(lambda q, own: q[own, 1].min()),
    ),
    Mistake(
        "the clusters are ordered by the size of q2, without its sign",
        "Leave abs away.",
        _numbered(lambda q, own: np.abs(q[own, 1]).mean()),
        _numbered(lambda q, own: np.abs(q[own, 1].mean())),
    ),
    Mistake(
        "all samples are in one cluster",
        "Return labels_ of the KMeans, unless all samples are equal.",
        seen=lambda labels, q: several(q) and (labels == labels[0]).all(),
    ),
)


EXERCISE = with_a_list(
    Exercise(
        name="split_branches",
        points=2,
        arguments=("q",),
        cases=_cases,
        returns=numbers(
            lambda q: (len(q),),
            lambda array, q: _CENTRES if len(q) > 2 and array.shape == (2, 2) else None,
        ),
        properties=(
            Property(
                "each label is 0 or 1",
                lambda labels, q: np.isin(labels, (0, 1)).all(),
                says=lambda labels, q: f"Among yours is {labels[~np.isin(labels, (0, 1))][0]:.4g}.",
                where=lambda q: not _tied(q),
            ),
            Property(
                "with fewer than two different samples there is nothing to split: all labels are 0",
                lambda labels, q: not labels.any(),
                where=lambda q: not several(q),
                mistake=_ONE_SAMPLE,
            ),
            replace(SAME_TWICE, mistake=_RANDOM),
            Property(
                "both labels occur, wherever there are two different samples",
                lambda labels, q: labels.any() and not labels.all(),
                where=_one_best,
            ),
            Property(
                "the samples lie as near to the means of their clusters as two clusters can bring them: the sum of the "
                "squared distances is the least",
                _least,
                says=lambda labels, q: (
                    f"Yours is {within(q, labels):.4g}, and {within(q, best_split(q)):.4g} is possible."
                ),
                where=_one_best,
            ),
            Property(
                "cluster 0 is the one whose mean q2 is the larger",
                lambda labels, q: np.array_equal(labels, split(q)),
                says=_means,
                where=_one_best,
            ),
        ),
        mistakes=tuple(rewired(known, _unless_tied, _unless_tied) for known in _MISTAKES),
        errors=(("ValueError", "should be >= n_clusters", _ONE_SAMPLE),),
        library=split_branches,
        hints=(
            "KMeans(n_clusters=2, random_state=0) has the method fit_predict, which returns a label for each sample.",
            "KMeans may call either cluster 0. Compare q[labels == 0, 1].mean() with q[labels == 1, 1].mean(): if the "
            "first is the smaller one, 1 - labels exchanges the two.",
            "Before that: with fewer than two different samples, len(np.unique(q, axis=0)) < 2, return zeros.",
        ),
    ),
    position=0,
)
