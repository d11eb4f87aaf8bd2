"""What students write for null_space_step(q, J, q_middle, gain)."""

import numpy as np
import scipy.linalg


def right_by_the_pseudoinverse(q, J, q_middle, gain):
    step = gain * (q_middle - q)
    return q + step - np.linalg.pinv(J) @ (J @ step)


def right_by_a_basis(q, J, q_middle, gain):
    N = scipy.linalg.null_space(J, rcond=1e-10)
    return (q + gain * N @ (N.T @ (q_middle - q))).reshape(-1, 1)


def right_by_least_squares(q, J, q_middle, gain):
    step = np.array(gain * (q_middle - q), float)
    return list(q + step - np.linalg.lstsq(J, J @ step, rcond=1e-12)[0])


def wrong_inverse_of_J_J_T(q, J, q_middle, gain):
    """LinAlgError"""
    return q + gain * (np.eye(len(q)) - J.T @ np.linalg.solve(J @ J.T, J)) @ (q_middle - q)


def wrong_basis_of_n_minus_m_vectors(q, J, q_middle, gain):
    """the answer is wrong where the rank of J is not full"""
    N = np.linalg.svd(J)[2][len(J) :]
    return q + gain * N.T @ N @ (q_middle - q)


def wrong_projector(q, J, q_middle, gain):
    """the projector is returned"""
    return np.eye(len(q)) - np.linalg.pinv(J) @ J


def wrong_shorter_way_round(q, J, q_middle, gain):
    """q_middle - q is wrapped"""
    d = q_middle - q
    d = np.angle(np.exp(1j * d))
    return q + gain * (d - np.linalg.pinv(J) @ (J @ d))


def wrong_no_null_space_of_a_square_J(q, J, q_middle, gain):
    """the answer is wrong where the rank of J is not full"""
    if J.shape[0] == J.shape[1]:
        return q.astype(float)
    return right_by_the_pseudoinverse(q, J, q_middle, gain)


def wrong_gain_at_most_one(q, J, q_middle, gain):
    """the step is not gain (I - J^+ J)(q_middle - q)"""
    return right_by_the_pseudoinverse(q, J, q_middle, min(gain, 1))


def right_by_the_pseudoinverse_of_J_J_T(q, J, q_middle, gain):
    return q + gain * (np.eye(len(q)) - J.T @ np.linalg.pinv(J @ J.T) @ J) @ (q_middle - q)


def wrong_small_singular_values_cut_off(q, J, q_middle, gain):
    """the step still moves the end-effector"""
    return q + gain * (np.eye(len(q)) - np.linalg.pinv(J, rcond=1e-5) @ J) @ (q_middle - q)


def wrong_difference_wrapped_beyond_two_revolutions(q, J, q_middle, gain):
    """the step is not gain (I - J^+ J)(q_middle - q)"""
    d = q_middle - q
    d = np.where(np.abs(d) > 4 * np.pi, np.angle(np.exp(1j * d)), d)
    return right_by_the_pseudoinverse(q, J, q + d, gain)


def wrong_cut_off_relative_to_the_largest(q, J, q_middle, gain):
    """the step still moves the end-effector"""
    return q + gain * (np.eye(len(q)) - np.linalg.pinv(J, rcond=1e-6) @ J) @ (q_middle - q)


def wrong_rank_of_at_least_one(q, J, q_middle, gain):
    """the answer is wrong where the rank of J is not full"""
    V = np.linalg.svd(J)[2][: max(1, np.linalg.matrix_rank(J, tol=1e-9))]
    d = q_middle - q
    return q + gain * (d - V.T @ (V @ d))
