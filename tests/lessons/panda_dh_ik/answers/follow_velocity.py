"""What students write for follow_velocity(q, v, dt, n, near, most)."""

import numpy as np

from course_lib.arms import panda

arm = panda()


def jacobian(q):
    return np.roll(arm.geometric_jacobian(q), 3, axis=0)


def damping(J, near, most):
    s = np.linalg.svd(J, compute_uv=False).min()
    return most * (1 - (s / near) ** 2) if s < near else 0.0


def right_in_a_loop(q, v, dt, n, near, most):
    path = [np.array(q)]
    for _ in range(n):
        J = jacobian(path[-1])
        path.append(
            path[-1] + dt * J.T @ np.linalg.solve(J @ J.T + damping(J, near, most) * np.eye(6), v)
        )
    return np.array(path)


def right_by_singular_values(q, v, dt, n, near, most):
    path = np.zeros((n + 1, 7))
    path[0] = q
    for k in range(n):
        U, s, Vt = np.linalg.svd(jacobian(path[k]), full_matrices=False)
        eps = 0 if s[-1] >= near else most * (1 - s[-1] ** 2 / near**2)
        path[k + 1] = path[k] + dt * Vt.T @ (s / (s**2 + eps) * (U.T @ v))
    return path


def right_by_the_pseudoinverse_where_it_is_undamped(q, v, dt, n, near, most):
    path = [list(q)]
    for _ in range(int(n)):
        J = jacobian(path[-1])
        eps = damping(J, near, most)
        q_dot = (
            np.linalg.pinv(J) @ v
            if eps == 0
            else np.linalg.solve(J.T @ J + eps * np.eye(7), J.T @ v)
        )
        path.append([a + dt * b for a, b in zip(path[-1], q_dot, strict=True)])
    return path


def wrong_at_least_some_damping(q, v, dt, n, near, most):
    """the answer is right to its first digits only"""
    return right_in_a_loop(q, v, dt, n, near, max(most, 1e-6))


def wrong_near_raised(q, v, dt, n, near, most):
    """the answers to some inputs only are wrong"""
    return right_in_a_loop(q, v, dt, n, max(near, 1e-3), most)


def wrong_small_near_taken_for_0(q, v, dt, n, near, most):
    """the answers to some inputs only are wrong"""
    return right_in_a_loop(q, v, dt, n, near if near > 1e-4 else 0.0, most)


def wrong_slow_joints(q, v, dt, n, near, most):
    """the answers to some inputs only are wrong"""
    path = [np.array(q, float)]
    for _ in range(n):
        q_dot = (right_in_a_loop(path[-1], v, dt, 1, near, most)[1] - path[-1]) / dt
        path.append(path[-1] + dt * np.clip(q_dot, -5, 5))
    return np.array(path)


def wrong_damping_of_a_tenth_at_most(q, v, dt, n, near, most):
    """the answers to some inputs only are wrong"""
    return right_in_a_loop(q, v, dt, n, near, min(most, 0.1))
