"""What students write for branch_by_sign(theta), whose cell holds broken code."""

import numpy as np
from sklearn.cluster import KMeans


def right_by_comparison(theta):
    return (theta[:, 1] < 0).astype(int)


def right_truth_values(theta):
    return np.signbit(theta[:, 1])


def right_one_by_one(theta):
    return [0 if second >= 0 else 1 for _, second in theta]


def wrong_other_order(theta):
    """the labels are swapped"""
    return (theta[:, 1] >= 0).astype(int)


def wrong_zero_is_negative(theta):
    """theta2 = 0 is in branch 1"""
    return 1 - (theta[:, 1] > 0)


def wrong_sign_itself(theta):
    """the signs themselves are returned"""
    return np.sign(theta[:, 1])


def wrong_mean(theta):
    """the samples are compared with their own mean"""
    if len(theta) == 0:
        return np.zeros(0)
    return (theta[:, 1] < theta[:, 1].mean()).astype(int)


def wrong_k_means_if_both_signs(theta):
    """every cell is still split by k-means if its samples have both signs"""
    negative = theta[:, 1] < 0
    if len(theta) == 0 or negative.all() or not negative.any():
        return negative.astype(int)
    found = KMeans(n_clusters=2, random_state=0).fit(theta)
    return found.labels_ if found.cluster_centers_[0, 1] > found.cluster_centers_[1, 1] else 1 - found.labels_
