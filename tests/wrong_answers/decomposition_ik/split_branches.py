"""What students write for split_branches(theta)."""

import numpy as np
from scipy.cluster.vq import kmeans2
from sklearn.cluster import KMeans

from course_lib.arms import planar_arm


def right_kmeans_with_its_labels_flipped(theta):
    theta = np.asarray(theta, float)
    if len(np.unique(theta, axis=0)) < 2:
        return np.zeros(len(theta), int)
    labels = KMeans(n_clusters=2, n_init=10, random_state=0).fit_predict(theta)
    if theta[labels == 0, 1].mean() < theta[labels == 1, 1].mean():
        labels = 1 - labels
    return labels


def right_order_of_the_centres_as_a_list(theta):
    theta = np.asarray(theta, float)
    if len({tuple(sample) for sample in theta.tolist()}) < 2:
        return [0 for _ in theta]
    found = KMeans(2, random_state=7).fit(theta)
    names = np.argsort(-found.cluster_centers_[:, 1]).tolist()
    return [names.index(label) for label in found.labels_]


def right_own_loop_as_truth_values(theta):
    theta = np.asarray(theta, float)
    if len(theta) < 2 or np.ptp(theta, axis=0).max() == 0:
        return np.zeros(len(theta), bool)
    far = theta[np.argmax(((theta - theta[0]) ** 2).sum(axis=1))]
    centres = [far, theta[np.argmax(((theta - far) ** 2).sum(axis=1))]]
    for _ in range(50):
        second = ((theta - centres[1]) ** 2).sum(axis=1) < ((theta - centres[0]) ** 2).sum(axis=1)
        centres = [theta[~second].mean(axis=0), theta[second].mean(axis=0)]
    return second if centres[0][1] > centres[1][1] else ~second


def right_scipys_as_a_column(theta):
    theta = np.asarray(theta, float)
    if len(theta) == 0 or np.all(theta == theta[0]):
        return np.zeros((len(theta), 1))
    best = min(
        (kmeans2(theta, 2, minit="++", rng=seed) for seed in range(5)),
        key=lambda found: ((theta - found[0][found[1]]) ** 2).sum(),
    )
    upper = np.argmax(best[0][:, 1])
    return np.where(best[1] == upper, 0.0, 1.0)[:, None]


def right_kmeans_of_unsettled_order(theta):
    theta = np.asarray(theta, float)
    labels = np.zeros(len(theta), dtype=np.int32)
    if len(theta) > 1 and not np.allclose(theta, theta[0]):
        found = KMeans(n_clusters=2, n_init=10).fit(theta)
        labels[:] = found.predict(theta) != found.cluster_centers_[:, 1].argmax()
    return labels


def _kmeans(theta):
    return KMeans(n_clusters=2, n_init=10, random_state=0).fit_predict(theta)


def _alike(theta):
    return len(np.unique(theta, axis=0)) < 2


def _larger_first(theta, labels):
    return labels if theta[labels == 0, 1].mean() > theta[labels == 1, 1].mean() else 1 - labels


def wrong_kmeans_own_order(theta):
    """KMeans calls its clusters 0 and 1 in any order"""
    theta = np.asarray(theta, float)
    return np.zeros(len(theta), int) if _alike(theta) else _kmeans(theta)


def wrong_labels_swapped(theta):
    """the labels are swapped"""
    theta = np.asarray(theta, float)
    return np.zeros(len(theta), int) if _alike(theta) else 1 - _larger_first(theta, _kmeans(theta))


def wrong_first_sample_is_in_cluster_0(theta):
    """KMeans calls its clusters 0 and 1 in any order"""
    theta = np.asarray(theta, float)
    if _alike(theta):
        return np.zeros(len(theta), int)
    labels = _kmeans(theta)
    return labels if labels[0] == 0 else 1 - labels


def wrong_sign_of_theta2(theta):
    """by the sign of theta2"""
    theta = np.asarray(theta, float)
    return np.where(theta[:, 1] > 0, 0, 1)


def wrong_sign_of_theta2_where_samples_differ(theta):
    """by the sign of theta2"""
    theta = np.asarray(theta, float)
    return np.zeros(len(theta)) if _alike(theta) else (theta[:, 1] < 0).astype(int)


def wrong_median_of_theta1(theta):
    """at the median of theta1"""
    theta = np.asarray(theta, float)
    return np.zeros(len(theta)) if _alike(theta) else theta[:, 0] > np.median(theta[:, 0])


def wrong_median_of_theta2(theta):
    """at the median of theta2"""
    theta = np.asarray(theta, float)
    return np.zeros(len(theta)) if _alike(theta) else theta[:, 1] < np.median(theta[:, 1])


def wrong_labels_sorted(theta):
    """the labels are sorted"""
    theta = np.asarray(theta, float)
    return np.zeros(len(theta)) if _alike(theta) else np.sort(_larger_first(theta, _kmeans(theta)))


def wrong_theta_sorted(theta):
    """theta is sorted before it is clustered"""
    theta = np.asarray(theta, float)
    if _alike(theta):
        return np.zeros(len(theta))
    theta = theta[np.argsort(theta[:, 1])]
    return _larger_first(theta, _kmeans(theta))


def wrong_centres(theta):
    """the centres of the clusters are returned"""
    theta = np.asarray(theta, float)
    if _alike(theta):
        return np.zeros(len(theta))
    return KMeans(n_clusters=2, n_init=10, random_state=0).fit(theta).cluster_centers_


def wrong_three_clusters(theta):
    """more than two clusters"""
    theta = np.asarray(theta, float)
    if len(np.unique(theta, axis=0)) < 3:
        return np.zeros(len(theta))
    return KMeans(n_clusters=3, n_init=10, random_state=0).fit_predict(theta)


def wrong_one_sample_crashes(theta):
    """ValueError"""
    theta = np.asarray(theta, float)
    return _larger_first(theta, _kmeans(theta))


def wrong_one_sample_only_treated_apart(theta):
    """equal samples, or a single one, are not treated apart"""
    theta = np.asarray(theta, float)
    if len(theta) < 2:
        return np.zeros(len(theta))
    return _larger_first(theta, _kmeans(theta))


def wrong_two_samples_not_split(theta):
    """all samples are in one cluster"""
    theta = np.asarray(theta, float)
    return np.zeros(len(theta)) if len(theta) <= 2 or _alike(theta) else _larger_first(theta, _kmeans(theta))


def wrong_all_in_one(theta):
    """all samples are in one cluster"""
    theta = np.asarray(theta, float)
    return np.zeros(len(theta), int)


def wrong_places_clustered(theta):
    """the places are clustered, not the joint angles"""
    theta = np.asarray(theta, float)
    if _alike(theta):
        return np.zeros(len(theta))
    return _larger_first(theta, _kmeans(planar_arm([1, 1]).fk(theta)[:, :2, 3]))


def wrong_ordered_by_theta1(theta):
    """the clusters are ordered by theta1"""
    theta = np.asarray(theta, float)
    if _alike(theta):
        return np.zeros(len(theta))
    labels = _kmeans(theta)
    return labels if theta[labels == 0, 0].mean() > theta[labels == 1, 0].mean() else 1 - labels


def wrong_ordered_by_size_of_the_angle(theta):
    """without its sign"""
    theta = np.asarray(theta, float)
    if _alike(theta):
        return np.zeros(len(theta))
    labels = _kmeans(theta)
    return labels if abs(theta[labels == 0, 1].mean()) > abs(theta[labels == 1, 1].mean()) else 1 - labels


def wrong_ordered_by_the_number_of_samples(theta):
    """KMeans calls its clusters 0 and 1 in any order"""
    theta = np.asarray(theta, float)
    if _alike(theta):
        return np.zeros(len(theta))
    labels = _kmeans(theta)
    return labels if (labels == 0).sum() > (labels == 1).sum() else 1 - labels


def wrong_ordered_by_the_largest(theta):
    """by their largest or smallest theta2"""
    theta = np.asarray(theta, float)
    if _alike(theta):
        return np.zeros(len(theta))
    labels = _kmeans(theta)
    return labels if theta[labels == 0, 1].max() > theta[labels == 1, 1].max() else 1 - labels


def wrong_ordered_by_the_sum(theta):
    """by the sum of theta2"""
    theta = np.asarray(theta, float)
    if _alike(theta):
        return np.zeros(len(theta))
    labels = _kmeans(theta)
    return labels if theta[labels == 0, 1].sum() > theta[labels == 1, 1].sum() else 1 - labels


def wrong_scaled(theta):
    """scaled before they are clustered"""
    theta = np.asarray(theta, float)
    if _alike(theta):
        return np.zeros(len(theta))
    return _larger_first(theta, _kmeans((theta - theta.mean(axis=0)) / theta.std(axis=0).clip(1e-9)))


def wrong_theta2_alone(theta):
    """only theta2 is looked at"""
    theta = np.asarray(theta, float)
    return np.zeros(len(theta)) if _alike(theta) else _larger_first(theta, _kmeans(theta[:, 1:]))


def wrong_theta1_alone(theta):
    """only theta1 is looked at"""
    theta = np.asarray(theta, float)
    return np.zeros(len(theta)) if _alike(theta) else _larger_first(theta, _kmeans(theta[:, [0]]))


def wrong_labels_from_one(theta):
    """the labels are 1 and 2"""
    theta = np.asarray(theta, float)
    return np.zeros(len(theta)) if _alike(theta) else 1 + _larger_first(theta, _kmeans(theta))


def wrong_no_return(theta):
    """a return is missing"""
    theta = np.asarray(theta, float)
    KMeans(n_clusters=2, n_init=10, random_state=0)


def wrong_changed_in_place(theta):
    """theta is changed in place"""
    theta = np.asarray(theta, float)
    if _alike(theta):
        return np.zeros(len(theta))
    theta -= theta.mean(axis=0)
    return _larger_first(theta, _kmeans(theta))
