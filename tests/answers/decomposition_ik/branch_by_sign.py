"""What students write for branch_by_sign(q), whose cell holds broken code."""

import numpy as np
from sklearn.cluster import KMeans


def right_by_comparison(q):
    return (q[:, 1] < 0).astype(int)


def right_truth_values(q):
    return np.signbit(q[:, 1])


def right_one_by_one(q):
    return [0 if second >= 0 else 1 for _, second in q]


def wrong_other_order(q):
    """the labels are swapped"""
    return (q[:, 1] >= 0).astype(int)


def wrong_zero_is_negative(q):
    """q2 = 0 is in branch 1"""
    return 1 - (q[:, 1] > 0)


def wrong_sign_itself(q):
    """the signs themselves are returned"""
    return np.sign(q[:, 1])


def wrong_mean(q):
    """the samples are compared with their own mean"""
    if len(q) == 0:
        return np.zeros(0)
    return (q[:, 1] < q[:, 1].mean()).astype(int)


def wrong_k_means_if_both_signs(q):
    """every cell is still split by k-means if its samples have both signs"""
    negative = q[:, 1] < 0
    if len(q) == 0 or negative.all() or not negative.any():
        return negative.astype(int)
    found = KMeans(n_clusters=2, random_state=0).fit(q)
    return found.labels_ if found.cluster_centers_[0, 1] > found.cluster_centers_[1, 1] else 1 - found.labels_


def wrong_one_elbow_is_branch_0(q):
    """samples that all have q2 < 0 are in branch 0"""
    negative = q[:, 1] < 0
    return np.zeros(len(q), int) if negative.all() else negative.astype(int)
