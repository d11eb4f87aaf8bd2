"""What students write for lm_step(q, target, alpha, eps)."""

import numpy as np

from course_lib import arms, ik


def tip(q):
    angles = np.cumsum(q)
    return np.array([np.cos(angles).sum(), np.sin(angles).sum()])


def planar_jacobian(q):
    angles = np.cumsum(q)
    links = np.array([-np.sin(angles), np.cos(angles)])
    return np.cumsum(links[:, ::-1], axis=1)[:, ::-1]


def right_solved(q, target, alpha, eps):
    J = planar_jacobian(q)
    return q - alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ (tip(q) - target))


def right_inverted_as_a_list(q, target, alpha, eps):
    J = planar_jacobian(q)
    return list(q + alpha * np.linalg.inv(J.T @ J + eps * np.eye(4)) @ J.T @ (target - tip(q)))


def right_smaller_matrix(q, target, alpha, eps):
    J = planar_jacobian(q)
    e = (tip(q) - target)[:, None]
    return q[:, None] - alpha * J.T @ np.linalg.inv(J @ J.T + eps * np.eye(2)) @ e


def right_singular_values(q, target, alpha, eps):
    U, s, Vt = np.linalg.svd(planar_jacobian(q), full_matrices=False)
    return q - alpha * Vt.T @ np.diag(s / (s**2 + eps)) @ U.T @ (tip(q) - target)


def right_least_squares(q, target, alpha, eps):
    A = np.vstack([planar_jacobian(q), np.sqrt(eps) * np.eye(4)])
    e = np.concatenate([tip(q) - target, np.zeros(4)])
    return q - alpha * np.linalg.lstsq(A, e, rcond=None)[0]


def right_by_differences_and_loops(q, target, alpha, eps):
    h, J = 1e-6, np.zeros((2, 4))
    for j in range(4):
        plus, minus = np.array(q, float), np.array(q, float)
        plus[j] += h
        minus[j] -= h
        J[:, j] = (tip(plus) - tip(minus)) / (2 * h)
    M = [[sum(J[k, i] * J[k, j] for k in range(2)) + (eps if i == j else 0) for j in range(4)] for i in range(4)]
    b = [sum(J[k, i] * (tip(q)[k] - target[k]) for k in range(2)) for i in range(4)]
    x = np.linalg.solve(M, b)
    return tuple(q[i] - alpha * x[i] for i in range(4))


def wrong_plus(q, target, alpha, eps):
    """the step leads away"""
    J = planar_jacobian(q)
    return q + alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ (tip(q) - target))


def wrong_sign_of_the_error(q, target, alpha, eps):
    """the step leads away"""
    J = planar_jacobian(q)
    return q - alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ (target - tip(q)))


def wrong_eps_squared(q, target, alpha, eps):
    """eps is squared"""
    J = planar_jacobian(q)
    return q - alpha * np.linalg.solve(J.T @ J + eps**2 * np.eye(4), J.T @ (tip(q) - target))


def wrong_root_of_eps(q, target, alpha, eps):
    """its root is taken"""
    J = planar_jacobian(q)
    return q - alpha * np.linalg.solve(J.T @ J + np.sqrt(eps) * np.eye(4), J.T @ (tip(q) - target))


def wrong_pseudoinverse(q, target, alpha, eps):
    """eps is not used"""
    return q - alpha * np.linalg.pinv(planar_jacobian(q)) @ (tip(q) - target)


def wrong_eps_missing(q, target, alpha, eps):
    """eps is not used"""
    J = planar_jacobian(q)
    return q - alpha * np.linalg.solve(J.T @ J, J.T @ (tip(q) - target))


def wrong_eps_missing_in_the_smaller_matrix(q, target, alpha, eps):
    """eps is not used"""
    J = planar_jacobian(q)
    return q - alpha * J.T @ np.linalg.inv(J @ J.T) @ (tip(q) - target)


def wrong_hardly_damped(q, target, alpha, eps):
    """eps is not used"""
    J = planar_jacobian(q)
    return q - alpha * np.linalg.solve(J.T @ J + 1e-9 * np.eye(4), J.T @ (tip(q) - target))


def wrong_alpha_missing(q, target, alpha, eps):
    """alpha is missing"""
    J = planar_jacobian(q)
    return q - np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ (tip(q) - target))


def wrong_alpha_fixed(q, target, alpha, eps):
    """a wrong length"""
    J = planar_jacobian(q)
    return q - 0.2 * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ (tip(q) - target))


def wrong_eps_fixed(q, target, alpha, eps):
    """unnamed"""
    J = planar_jacobian(q)
    return q - alpha * np.linalg.solve(J.T @ J + 2 * np.eye(4), J.T @ (tip(q) - target))


def wrong_gradient_descent(q, target, alpha, eps):
    """this is gradient descent"""
    return q - alpha * planar_jacobian(q).T @ (tip(q) - target)


def wrong_gradient_over_eps(q, target, alpha, eps):
    """this is gradient descent"""
    return q - alpha / eps * planar_jacobian(q).T @ (tip(q) - target)


def wrong_multiplied_by_the_matrix(q, target, alpha, eps):
    """multiplied by, not divided by"""
    J = planar_jacobian(q)
    return q - alpha * (J.T @ J + eps * np.eye(4)) @ J.T @ (tip(q) - target)


def wrong_eps_in_every_entry(q, target, alpha, eps):
    """eps is added to every entry"""
    J = planar_jacobian(q)
    return q - alpha * np.linalg.pinv(J.T @ J + eps) @ J.T @ (tip(q) - target)


def wrong_eps_in_every_entry_of_the_smaller_matrix(q, target, alpha, eps):
    """eps is added to every entry"""
    J = planar_jacobian(q)
    return q - alpha * J.T @ np.linalg.solve(J @ J.T + eps, tip(q) - target)


def wrong_each_entry_inverted(q, target, alpha, eps):
    """each entry of the matrix is inverted"""
    J = planar_jacobian(q)
    return q - alpha * (J.T @ J + eps * np.eye(4)) ** -1 @ J.T @ (tip(q) - target)


def wrong_wrong_sides(q, target, alpha, eps):
    """ValueError"""
    J = planar_jacobian(q)
    return q - alpha * np.linalg.inv(J @ J.T + eps * np.eye(2)) @ J.T @ (tip(q) - target)


def wrong_diagonal_scaled(q, target, alpha, eps):
    """as Marquardt did"""
    M = planar_jacobian(q).T @ planar_jacobian(q)
    return q - alpha * np.linalg.pinv(M + eps * np.diag(np.diag(M))) @ planar_jacobian(q).T @ (tip(q) - target)


def wrong_step_alone(q, target, alpha, eps):
    """only the step"""
    J = planar_jacobian(q)
    return -alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ (tip(q) - target))


def wrong_step_alone_without_the_sign(q, target, alpha, eps):
    """only the step"""
    J = planar_jacobian(q)
    return alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ (tip(q) - target))


def wrong_twice_the_gradient(q, target, alpha, eps):
    """a wrong length"""
    J = planar_jacobian(q)
    return q - alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), 2 * J.T @ (tip(q) - target))


def wrong_alpha_and_eps_swapped(q, target, alpha, eps):
    """swapped"""
    J = planar_jacobian(q)
    return q - eps * np.linalg.solve(J.T @ J + alpha * np.eye(4), J.T @ (tip(q) - target))


def wrong_alpha_times_all(q, target, alpha, eps):
    """alpha multiplies q"""
    J = planar_jacobian(q)
    return alpha * (q - np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ (tip(q) - target)))


def wrong_unit_error(q, target, alpha, eps):
    """something is divided by zero"""
    J = planar_jacobian(q)
    e = (tip(q) - target) / np.linalg.norm(tip(q) - target)
    return q - alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ e)


def wrong_target_for_the_error(q, target, alpha, eps):
    """the error is not p(q) - target"""
    J = planar_jacobian(q)
    return q - alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ target)


def wrong_tip_for_the_error(q, target, alpha, eps):
    """the error is not p(q) - target"""
    J = planar_jacobian(q)
    return q - alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ tip(q))


def wrong_angles_not_summed(q, target, alpha, eps):
    """the angles are not summed"""
    J = np.array([[-np.sin(q[j:]).sum() for j in range(4)], [np.cos(q[j:]).sum() for j in range(4)]])
    e = np.array([np.cos(q).sum(), np.sin(q).sum()]) - target
    return q - alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ e)


def wrong_jacobian_of_the_last_link(q, target, alpha, eps):
    """unnamed"""
    angle = np.sum(q)
    J = np.array([[-np.sin(angle)] * 4, [np.cos(angle)] * 4])
    return q - alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ (tip(q) - target))


def wrong_degrees(q, target, alpha, eps):
    """degrees"""
    J = planar_jacobian(q)
    return q - np.rad2deg(alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ (tip(q) - target)))


def wrong_q_changed_in_place(q, target, alpha, eps):
    """q is changed in place"""
    J = planar_jacobian(q)
    q[:] = q - alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ (tip(q) - target))
    return q


def wrong_whole_numbers(q, target, alpha, eps):
    """digits after the point"""
    J = planar_jacobian(q)
    new = np.zeros_like(q)
    new[:] = q - alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ (tip(q) - target))
    return new


def wrong_taken_off_a_copy(q, target, alpha, eps):
    """UFuncTypeError"""
    J = planar_jacobian(q)
    new = q.copy()
    new -= alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ (tip(q) - target))
    return new


def wrong_the_librarys(q, target, alpha, eps):
    """course_lib.ik.damped_path is called"""
    return ik.damped_path(None, q, target, alpha, eps, 1)[1]


def wrong_the_librarys_arm(q, target, alpha, eps):
    """course_lib.arms.planar_arm is called"""
    J = arms.planar_arm(np.ones(4)).position_jacobian(q)[:2]
    return q - alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ (tip(q) - target))


def wrong_eps_added_to_every_entry_and_solved(q, target, alpha, eps):
    """eps is added to every entry"""
    J = planar_jacobian(q)
    return q - alpha * np.linalg.solve(J.T @ J + eps, J.T @ (tip(q) - target))


def wrong_wrapped(q, target, alpha, eps):
    """the angles are wrapped"""
    J = planar_jacobian(q)
    found = q - alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ (tip(q) - target))
    return (found + np.pi) % (2 * np.pi) - np.pi


def wrong_eps_added_to_the_step(q, target, alpha, eps):
    """eps is added to the step"""
    return q - alpha * (np.linalg.pinv(planar_jacobian(q)) @ (tip(q) - target) + eps)


def wrong_distance_for_both_coordinates(q, target, alpha, eps):
    """the distance is taken for both coordinates"""
    J, e = planar_jacobian(q), np.full(2, np.linalg.norm(tip(q) - target))
    return q - alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ e)
