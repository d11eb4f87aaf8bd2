"""What students write for split_branches(q)."""

import numpy as np
from scipy.cluster.vq import kmeans2
from sklearn.cluster import KMeans
from threadpoolctl import threadpool_limits

threadpool_limits(1)  # as in the notebook


def right_kmeans_with_its_labels_flipped(q):
    q = np.asarray(q, float)
    if len(np.unique(q, axis=0)) < 2:
        return np.zeros(len(q), int)
    labels = KMeans(n_clusters=2, random_state=0).fit_predict(q)
    return labels if q[labels == 0, 1].mean() > q[labels == 1, 1].mean() else 1 - labels


def right_order_of_the_centres_as_a_list(q):
    if len({tuple(sample) for sample in q}) < 2:
        return [0 for _ in q]
    found = KMeans(2, random_state=7).fit(q)
    names = np.argsort(-found.cluster_centers_[:, 1]).tolist()
    return [names.index(label) for label in found.labels_]


def right_scipys_as_a_column(q):
    q = np.asarray(q, float)
    if len(q) == 0 or np.all(q == q[0]):
        return np.zeros((len(q), 1))
    tries = [kmeans2(q, 2, minit="++", rng=seed) for seed in range(5)]
    best = min(tries, key=lambda found: ((q - found[0][found[1]]) ** 2).sum())
    return np.where(best[1] == np.argmax(best[0][:, 1]), 0.0, 1.0)[:, None]


def wrong_one_sample_crashes(q):
    """ValueError"""
    found = KMeans(n_clusters=2, random_state=0).fit(q)
    return found.labels_ != found.cluster_centers_[:, 1].argmax()


def wrong_equal_samples_split(q):
    """fewer than two different samples is not treated separately"""
    labels = right_kmeans_with_its_labels_flipped(q)
    labels[len(q) // 2 :] |= len(np.unique(q, axis=0)) == 1
    return labels


def wrong_three_clusters(q):
    """there are other labels"""
    return (
        np.zeros(len(q))
        if len(np.unique(q, axis=0)) < 3
        else KMeans(3, random_state=0).fit_predict(q)
    )


def wrong_nearly_equal_means_left_in_any_order(q):
    """cluster 0 has the smaller mean q2"""
    if len(np.unique(q, axis=0)) < 2:
        return np.zeros(len(q), int)
    found = KMeans(n_clusters=2, random_state=0).fit(q)
    first, second = found.cluster_centers_[:, 1]
    return found.labels_ if first > second or np.isclose(first, second) else 1 - found.labels_


def wrong_medians_compared(q):
    """cluster 0 has the smaller mean q2"""
    labels, q = np.asarray(right_kmeans_with_its_labels_flipped(q)), np.asarray(q, float)
    if not labels.any():
        return labels
    first, second = (np.median(q[labels == k, 1]) for k in (0, 1))
    return labels if first > second else 1 - labels


def wrong_nearly_equal_samples_taken_for_equal(q):
    """all samples have the same label"""
    q = np.asarray(q, float)
    if len(q) == 0 or np.allclose(q, q[0]):
        return np.zeros(len(q), int)
    return right_kmeans_with_its_labels_flipped(q)
