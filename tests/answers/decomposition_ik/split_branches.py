"""What students write for split_branches(q)."""

import numpy as np
from scipy.cluster.vq import kmeans2
from sklearn.cluster import KMeans

from course_lib.arms import planar_arm


def right_kmeans_with_its_labels_flipped(q):
    q = np.asarray(q, float)
    if len(np.unique(q, axis=0)) < 2:
        return np.zeros(len(q), int)
    labels = KMeans(n_clusters=2, n_init=10, random_state=0).fit_predict(q)
    if q[labels == 0, 1].mean() < q[labels == 1, 1].mean():
        labels = 1 - labels
    return labels


def right_order_of_the_centres_as_a_list(q):
    q = np.asarray(q, float)
    if len({tuple(sample) for sample in q.tolist()}) < 2:
        return [0 for _ in q]
    found = KMeans(2, random_state=7).fit(q)
    names = np.argsort(-found.cluster_centers_[:, 1]).tolist()
    return [names.index(label) for label in found.labels_]


def right_own_loop_as_truth_values(q):
    q = np.asarray(q, float)
    if len(q) < 2 or np.ptp(q, axis=0).max() == 0:
        return np.zeros(len(q), bool)
    far = q[np.argmax(((q - q[0]) ** 2).sum(axis=1))]
    centres = [far, q[np.argmax(((q - far) ** 2).sum(axis=1))]]
    for _ in range(50):
        second = ((q - centres[1]) ** 2).sum(axis=1) < ((q - centres[0]) ** 2).sum(axis=1)
        centres = [q[~second].mean(axis=0), q[second].mean(axis=0)]
    return second if centres[0][1] > centres[1][1] else ~second


def right_scipys_as_a_column(q):
    q = np.asarray(q, float)
    if len(q) == 0 or np.all(q == q[0]):
        return np.zeros((len(q), 1))
    best = min(
        (kmeans2(q, 2, minit="++", rng=seed) for seed in range(5)),
        key=lambda found: ((q - found[0][found[1]]) ** 2).sum(),
    )
    upper = np.argmax(best[0][:, 1])
    return np.where(best[1] == upper, 0.0, 1.0)[:, None]


def _kmeans(q):
    return KMeans(n_clusters=2, random_state=0).fit_predict(q)


def _alike(q):
    return len(np.unique(q, axis=0)) < 2


def _larger_first(q, labels):
    return labels if q[labels == 0, 1].mean() > q[labels == 1, 1].mean() else 1 - labels


def wrong_kmeans_own_order(q):
    """KMeans calls its clusters 0 and 1 in any order"""
    q = np.asarray(q, float)
    return np.zeros(len(q), int) if _alike(q) else _kmeans(q)


def wrong_labels_swapped(q):
    """the labels are swapped"""
    q = np.asarray(q, float)
    return np.zeros(len(q), int) if _alike(q) else 1 - _larger_first(q, _kmeans(q))


def wrong_first_sample_is_in_cluster_0(q):
    """KMeans calls its clusters 0 and 1 in any order"""
    q = np.asarray(q, float)
    if _alike(q):
        return np.zeros(len(q), int)
    labels = _kmeans(q)
    return labels if labels[0] == 0 else 1 - labels


def wrong_sign_of_q2(q):
    """by the sign of q2"""
    q = np.asarray(q, float)
    return np.where(q[:, 1] > 0, 0, 1)


def wrong_sign_of_q2_where_samples_differ(q):
    """by the sign of q2"""
    q = np.asarray(q, float)
    return np.zeros(len(q)) if _alike(q) else (q[:, 1] < 0).astype(int)


def wrong_median_of_q1(q):
    """only q1 is looked at"""
    q = np.asarray(q, float)
    return np.zeros(len(q)) if _alike(q) else q[:, 0] > np.median(q[:, 0])


def wrong_median_of_q2(q):
    """only q2 is looked at"""
    q = np.asarray(q, float)
    return np.zeros(len(q)) if _alike(q) else q[:, 1] < np.median(q[:, 1])


def wrong_labels_sorted(q):
    """the labels are sorted"""
    q = np.asarray(q, float)
    return np.zeros(len(q)) if _alike(q) else np.sort(_larger_first(q, _kmeans(q)))


def wrong_q_sorted(q):
    """q is sorted before it is clustered"""
    q = np.asarray(q, float)
    if _alike(q):
        return np.zeros(len(q))
    q = q[np.argsort(q[:, 1])]
    return _larger_first(q, _kmeans(q))


def wrong_centres(q):
    """the centres of the clusters are returned"""
    q = np.asarray(q, float)
    if _alike(q):
        return np.zeros(len(q))
    return KMeans(n_clusters=2, n_init=10, random_state=0).fit(q).cluster_centers_


def wrong_three_clusters(q):
    """more than two clusters"""
    q = np.asarray(q, float)
    if len(np.unique(q, axis=0)) < 3:
        return np.zeros(len(q))
    return KMeans(n_clusters=3, n_init=10, random_state=0).fit_predict(q)


def wrong_one_sample_crashes(q):
    """ValueError"""
    q = np.asarray(q, float)
    return _larger_first(q, _kmeans(q))


def wrong_one_sample_only_treated_apart(q):
    """equal samples, or a single one, are not treated apart"""
    q = np.asarray(q, float)
    if len(q) < 2:
        return np.zeros(len(q))
    return _larger_first(q, _kmeans(q))


def wrong_two_samples_not_split(q):
    """all samples are in one cluster"""
    q = np.asarray(q, float)
    return np.zeros(len(q)) if len(q) <= 2 or _alike(q) else _larger_first(q, _kmeans(q))


def wrong_all_in_one(q):
    """all samples are in one cluster"""
    q = np.asarray(q, float)
    return np.zeros(len(q), int)


def wrong_places_clustered(q):
    """the positions are clustered, not the joint angles"""
    q = np.asarray(q, float)
    if _alike(q):
        return np.zeros(len(q))
    return _larger_first(q, _kmeans(planar_arm([1, 1]).fk(q)[:, :2, 3]))


def wrong_ordered_by_q1(q):
    """the clusters are ordered by q1"""
    q = np.asarray(q, float)
    if _alike(q):
        return np.zeros(len(q))
    labels = _kmeans(q)
    return labels if q[labels == 0, 0].mean() > q[labels == 1, 0].mean() else 1 - labels


def wrong_ordered_by_size_of_the_angle(q):
    """without its sign"""
    q = np.asarray(q, float)
    if _alike(q):
        return np.zeros(len(q))
    labels = _kmeans(q)
    return labels if abs(q[labels == 0, 1].mean()) > abs(q[labels == 1, 1].mean()) else 1 - labels


def wrong_ordered_by_the_number_of_samples(q):
    """KMeans calls its clusters 0 and 1 in any order"""
    q = np.asarray(q, float)
    if _alike(q):
        return np.zeros(len(q))
    labels = _kmeans(q)
    return labels if (labels == 0).sum() > (labels == 1).sum() else 1 - labels


def wrong_ordered_by_the_largest(q):
    """by their largest or smallest q2"""
    q = np.asarray(q, float)
    if _alike(q):
        return np.zeros(len(q))
    labels = _kmeans(q)
    return labels if q[labels == 0, 1].max() > q[labels == 1, 1].max() else 1 - labels


def wrong_ordered_by_the_sum(q):
    """by the sum of q2"""
    q = np.asarray(q, float)
    if _alike(q):
        return np.zeros(len(q))
    labels = _kmeans(q)
    return labels if q[labels == 0, 1].sum() > q[labels == 1, 1].sum() else 1 - labels


def wrong_scaled(q):
    """scaled before they are clustered"""
    q = np.asarray(q, float)
    if _alike(q):
        return np.zeros(len(q))
    return _larger_first(q, _kmeans((q - q.mean(axis=0)) / q.std(axis=0).clip(1e-9)))


def wrong_q2_alone(q):
    """only q2 is looked at"""
    q = np.asarray(q, float)
    return np.zeros(len(q)) if _alike(q) else _larger_first(q, _kmeans(q[:, 1:]))


def wrong_q1_alone(q):
    """only q1 is looked at"""
    q = np.asarray(q, float)
    return np.zeros(len(q)) if _alike(q) else _larger_first(q, _kmeans(q[:, [0]]))


def wrong_labels_from_one(q):
    """the labels are 1 and 2"""
    q = np.asarray(q, float)
    return np.zeros(len(q)) if _alike(q) else 1 + _larger_first(q, _kmeans(q))


def wrong_no_return(q):
    """a return is missing"""
    q = np.asarray(q, float)
    KMeans(n_clusters=2, n_init=10, random_state=0)


def wrong_changed_in_place(q):
    """q is changed in place"""
    q = np.asarray(q, float)
    if _alike(q):
        return np.zeros(len(q))
    q -= q.mean(axis=0)
    return _larger_first(q, _kmeans(q))


def wrong_no_random_state(q):
    """depend on a random start"""
    q = np.asarray(q, float)
    labels = np.zeros(len(q), dtype=np.int32)
    if len(q) > 1 and not np.allclose(q, q[0]):
        found = KMeans(n_clusters=2, n_init=10).fit(q)
        labels[:] = found.predict(q) != found.cluster_centers_[:, 1].argmax()
    return labels


def wrong_split_at_the_mean(q):
    """only q2 is looked at"""
    q = np.asarray(q, float)
    return (q[:, 1] < q[:, 1].mean()).astype(int) if len(q) else np.zeros(0)


def wrong_labels_as_k_means_returns_them(q):
    """KMeans calls its clusters 0 and 1 in any order"""
    return KMeans(n_clusters=2, random_state=0).fit(q).labels_
