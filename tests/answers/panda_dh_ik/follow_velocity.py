"""What students write for follow_velocity(q, v, dt, n, near, most)."""

import numpy as np

from course_lib.arms import panda

arm = panda()


def jacobian(q):
    return np.roll(arm.geometric_jacobian(q), 3, axis=0)


def damping(J, near, most):
    s = np.linalg.svd(J, compute_uv=False).min()
    return most * (1 - (s / near) ** 2) if s < near else 0.0


def damped(J, v, eps):
    return J.T @ np.linalg.solve(J @ J.T + eps * np.eye(6), v)


def right_in_a_loop(q, v, dt, n, near, most):
    path = [np.array(q)]
    for _ in range(n):
        J = jacobian(path[-1])
        path.append(path[-1] + dt * damped(J, v, damping(J, near, most)))
    return np.array(path)


def right_by_singular_values(q, v, dt, n, near, most):
    path = np.zeros((n + 1, 7))
    path[0] = q
    for k in range(n):
        U, s, Vt = np.linalg.svd(jacobian(path[k]), full_matrices=False)
        eps = 0 if s[-1] >= near else most * (1 - s[-1] ** 2 / near**2)
        path[k + 1] = path[k] + dt * Vt.T @ (s / (s**2 + eps) * (U.T @ v))
    return path


def right_as_a_list(q, v, dt, n, near, most):
    path = [list(q)]
    for _ in range(int(n)):
        J = jacobian(path[-1])
        eps = max(0.0, damping(J, near, most))
        A = np.vstack([J.T @ J + eps * np.eye(7)])
        q_dot = np.linalg.pinv(J) @ v if eps == 0 else np.linalg.solve(A, J.T @ v)
        path.append([a + dt * b for a, b in zip(path[-1], q_dot, strict=True)])
    return path


def wrong_always_damped(q, v, dt, n, near, most):
    """the damping acts everywhere"""
    path = [q]
    for _ in range(n):
        path.append(path[-1] + dt * damped(jacobian(path[-1]), v, most))
    return np.array(path)


def wrong_never_damped(q, v, dt, n, near, most):
    """there is no damping"""
    path = [q]
    for _ in range(n):
        path.append(path[-1] + dt * np.linalg.pinv(jacobian(path[-1])) @ v)
    return np.array(path)


def wrong_switched_on(q, v, dt, n, near, most):
    """all of the damping is switched on at once"""
    path = [q]
    for _ in range(n):
        J = jacobian(path[-1])
        s = np.linalg.svd(J, compute_uv=False)[-1]
        path.append(path[-1] + dt * damped(J, v, most if s < near else 0))
    return np.array(path)


def wrong_not_squared(q, v, dt, n, near, most):
    """1 - s / near"""
    path = [q]
    for _ in range(n):
        J = jacobian(path[-1])
        s = np.linalg.svd(J, compute_uv=False)[-1]
        path.append(path[-1] + dt * damped(J, v, most * (1 - s / near) if s < near else 0))
    return np.array(path)


def wrong_largest_singular_value(q, v, dt, n, near, most):
    """there is no damping"""
    path = [q]
    for _ in range(n):
        J = jacobian(path[-1])
        s = np.linalg.svd(J, compute_uv=False)[0]
        path.append(path[-1] + dt * damped(J, v, most * (1 - (s / near) ** 2) if s < near else 0))
    return np.array(path)


def wrong_jacobian_of_the_start(q, v, dt, n, near, most):
    """the Jacobian is that of the start"""
    J = jacobian(q)
    q_dot = damped(J, v, damping(J, near, most))
    return np.array([q + k * dt * q_dot for k in range(n + 1)])


def wrong_without_dt(q, v, dt, n, near, most):
    """dt is not used"""
    path = [q]
    for _ in range(n):
        J = jacobian(path[-1])
        path.append(path[-1] + damped(J, v, damping(J, near, most)))
    return np.array(path)


def wrong_start_left_out(q, v, dt, n, near, most):
    """the start is left out"""
    return right_in_a_loop(q, v, dt, n, near, most)[1:]


def wrong_only_the_end(q, v, dt, n, near, most):
    """only the last"""
    return right_in_a_loop(q, v, dt, n, near, most)[-1]


def wrong_order_of_v(q, v, dt, n, near, most):
    """order (omega, v)"""
    return right_in_a_loop(q, np.roll(v, 3), dt, n, near, most)


def wrong_joint_velocities(q, v, dt, n, near, most):
    """unnamed"""
    path = right_in_a_loop(q, v, dt, n, near, most)
    return np.vstack([np.diff(path, axis=0) / dt, np.zeros(7)])


def wrong_q_moved_in_place(q, v, dt, n, near, most):
    """q is changed in place"""
    path = [q]
    for _ in range(n):
        J = jacobian(q)
        q += dt * damped(J, v, damping(J, near, most))
        path.append(q)
    return np.array(path)


def wrong_all_the_same_array(q, v, dt, n, near, most):
    """one and the same array"""
    q = q.copy()
    path = [q]
    for _ in range(n):
        J = jacobian(q)
        q += dt * damped(J, v, damping(J, near, most))
        path.append(q)
    return np.array(path)
