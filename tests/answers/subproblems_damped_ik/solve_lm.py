"""What students write for solve_lm(q0, target, alpha, eps, steps)."""

import numpy as np

from course_lib import arms, ik


def tip(q):
    angles = np.cumsum(q)
    return np.array([np.cos(angles).sum(), np.sin(angles).sum()])


def planar_jacobian(q):
    angles = np.cumsum(q)
    links = np.array([-np.sin(angles), np.cos(angles)])
    return np.cumsum(links[:, ::-1], axis=1)[:, ::-1]


def lm_step(q, target, alpha, eps):
    J = planar_jacobian(q)
    return q - alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ (tip(q) - target))


def right_appended(q0, target, alpha, eps, steps):
    way = [np.array(q0, float)]
    for _ in range(steps):
        way.append(lm_step(way[-1], target, alpha, eps))
    return np.array(way)


def right_filled_in(q0, target, alpha, eps, steps):
    way = np.zeros((steps + 1, 4))
    way[0] = q0
    for k in range(1, steps + 1):
        way[k] = lm_step(way[k - 1], target, alpha, eps)
    return way


def right_list_of_arrays(q0, target, alpha, eps, steps):
    q, way = q0, [q0]
    while len(way) <= steps:
        q = lm_step(q, target, alpha, eps)
        way += [q]
    return way


def right_recursive(q0, target, alpha, eps, steps):
    if steps == 0:
        return [list(q0)]
    return [list(q0), *right_recursive(lm_step(q0, target, alpha, eps), target, alpha, eps, steps - 1)]


def right_stacked(q0, target, alpha, eps, steps):
    way = np.reshape(q0, (1, 4))
    for _ in range(steps):
        q = way[-1]
        J = planar_jacobian(q)
        step = alpha * J.T @ np.linalg.inv(J @ J.T + eps * np.eye(2)) @ (tip(q) - target)
        way = np.concatenate([way, [q - step]])
    return way


def right_one_array_and_copies(q0, target, alpha, eps, steps):
    q = np.array(q0, dtype=float)
    way = [q.copy()]
    for _ in range(steps):
        J = planar_jacobian(q)
        q += alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ (target - tip(q)))
        way.append(q.copy())
    return np.vstack(way)


def wrong_start_missing(q0, target, alpha, eps, steps):
    """q0 is missing"""
    q, way = q0, []
    for _ in range(steps):
        q = lm_step(q, target, alpha, eps)
        way.append(q)
    return np.array(way)


def wrong_start_missing_and_a_step_more(q0, target, alpha, eps, steps):
    """q0 is missing"""
    q, way = q0, []
    for _ in range(steps + 1):
        q = lm_step(q, target, alpha, eps)
        way.append(q)
    return np.array(way)


def wrong_last_only(q0, target, alpha, eps, steps):
    """only the last angles"""
    q = q0
    for _ in range(steps):
        q = lm_step(q, target, alpha, eps)
    return q


def wrong_kept_before_each_step(q0, target, alpha, eps, steps):
    """one step too few"""
    q, way = q0, []
    for _ in range(steps):
        way.append(q)
        q = lm_step(q, target, alpha, eps)
    return np.array(way).reshape(-1, 4)


def wrong_one_step_too_few(q0, target, alpha, eps, steps):
    """one step too few"""
    way = [q0]
    for _ in range(1, steps):
        way.append(lm_step(way[-1], target, alpha, eps))
    return np.array(way)


def wrong_one_step_too_many(q0, target, alpha, eps, steps):
    """one step too many"""
    way = [q0]
    for _ in range(steps + 1):
        way.append(lm_step(way[-1], target, alpha, eps))
    return np.array(way)


def wrong_last_row_not_filled(q0, target, alpha, eps, steps):
    """the last row is never filled"""
    way = np.zeros((steps + 1, 4))
    way[0] = q0
    for k in range(1, steps):
        way[k] = lm_step(way[k - 1], target, alpha, eps)
    return way


def wrong_start_twice(q0, target, alpha, eps, steps):
    """q0 appears twice"""
    q, way = q0, [q0]
    for _ in range(steps + 1):
        way.append(q)
        q = lm_step(q, target, alpha, eps)
    return np.array(way)


def wrong_all_from_the_start(q0, target, alpha, eps, steps):
    """all steps start from q0"""
    way = [q0]
    for _ in range(steps):
        way.append(lm_step(q0, target, alpha, eps))
    return np.array(way)


def wrong_step_without_a_name(q0, target, alpha, eps, steps):
    """no step is kept"""
    q, way = q0, [q0]
    for _ in range(steps):
        lm_step(q, target, alpha, eps)
        way.append(q)
    return np.array(way)


def wrong_jacobian_of_the_start(q0, target, alpha, eps, steps):
    """J is not recomputed"""
    J, way = planar_jacobian(q0), [q0]
    for _ in range(steps):
        e = tip(way[-1]) - target
        way.append(way[-1] - alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ e))
    return np.array(way)


def wrong_error_of_the_start(q0, target, alpha, eps, steps):
    """the error is not recomputed"""
    e, way = tip(q0) - target, [q0]
    for _ in range(steps):
        J = planar_jacobian(way[-1])
        way.append(way[-1] - alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ e))
    return np.array(way)


def wrong_the_same_step_again(q0, target, alpha, eps, steps):
    """J and the error are not recomputed"""
    step = lm_step(q0, target, alpha, eps) - q0
    return np.array([q0 + k * step for k in range(steps + 1)])


def wrong_one_array_kept_many_times(q0, target, alpha, eps, steps):
    """every row is the same array"""
    q = np.array(q0, float)
    way = [q]
    for _ in range(steps):
        q[:] = lm_step(q, target, alpha, eps)
        way.append(q)
    return np.array(way)


def wrong_start_changed_in_place(q0, target, alpha, eps, steps):
    """q0 is changed in place"""
    way = [q0.copy()]
    for _ in range(steps):
        q0[:] = lm_step(q0, target, alpha, eps)
        way.append(q0.copy())
    return np.array(way)


def wrong_whole_numbers(q0, target, alpha, eps, steps):
    """digits after the point"""
    way = np.zeros((steps + 1, 4), dtype=q0.dtype)
    way[0] = q0
    for k in range(steps):
        way[k + 1] = lm_step(way[k], target, alpha, eps)
    return way


def wrong_tips(q0, target, alpha, eps, steps):
    """the positions of the tip"""
    q, way = q0, [tip(q0)]
    for _ in range(steps):
        q = lm_step(q, target, alpha, eps)
        way.append(tip(q))
    return np.array(way)


def wrong_errors(q0, target, alpha, eps, steps):
    """one number is kept for each step"""
    q, way = q0, [np.linalg.norm(tip(q0) - target)]
    for _ in range(steps):
        q = lm_step(q, target, alpha, eps)
        way.append(np.linalg.norm(tip(q) - target))
    return np.array(way)


def wrong_transposed(q0, target, alpha, eps, steps):
    """the transpose"""
    return right_appended(q0, target, alpha, eps, steps).T


def wrong_reversed(q0, target, alpha, eps, steps):
    """reverse order"""
    return right_appended(q0, target, alpha, eps, steps)[::-1]


def wrong_stops_when_there(q0, target, alpha, eps, steps):
    """it stops before all steps"""
    way = [q0]
    for _ in range(steps):
        if np.linalg.norm(tip(way[-1]) - target) < 1e-6:
            break
        way.append(lm_step(way[-1], target, alpha, eps))
    return np.array(way)


def wrong_stops_after_a_few(q0, target, alpha, eps, steps):
    """it stops before all steps"""
    way = [q0]
    for _ in range(min(steps, 10)):
        way.append(lm_step(way[-1], target, alpha, eps))
    return np.array(way)


def wrong_steps_kept(q0, target, alpha, eps, steps):
    """the steps are kept"""
    way = right_appended(q0, target, alpha, eps, steps)
    return np.vstack([way[:1], way[1:] - way[:-1]])


def wrong_return_in_the_loop(q0, target, alpha, eps, steps):
    """a return is missing"""
    way = [q0]
    for _ in range(steps):
        way.append(lm_step(way[-1], target, alpha, eps))
        return np.array(way)


def wrong_alpha_shrinks(q0, target, alpha, eps, steps):
    """alpha changes from step to step"""
    way = [q0]
    for k in range(steps):
        way.append(lm_step(way[-1], target, alpha / (k + 1), eps))
    return np.array(way)


def wrong_steps_without_damping(q0, target, alpha, eps, steps):
    """eps is not used"""
    way = [q0]
    for _ in range(steps):
        way.append(way[-1] - alpha * np.linalg.pinv(planar_jacobian(way[-1])) @ (tip(way[-1]) - target))
    return np.array(way)


def wrong_steps_away(q0, target, alpha, eps, steps):
    """the step leads away"""
    way = [q0]
    for _ in range(steps):
        way.append(2 * way[-1] - lm_step(way[-1], target, alpha, eps))
    return np.array(way)


def wrong_alpha_and_eps_swapped(q0, target, alpha, eps, steps):
    """alpha and eps are swapped"""
    way = [q0]
    for _ in range(steps):
        way.append(lm_step(way[-1], target, eps, alpha))
    return np.array(way)


def wrong_halfway_between(q0, target, alpha, eps, steps):
    """unnamed"""
    way = [q0]
    for _ in range(steps):
        way.append((way[-1] + lm_step(way[-1], target, alpha, eps)) / 2)
    return np.array(way)


def wrong_every_second_step(q0, target, alpha, eps, steps):
    """unnamed"""
    q, way = q0, [q0]
    for _ in range(steps):
        q = lm_step(lm_step(q, target, alpha, eps), target, alpha, eps)
        way.append(q)
    return np.array(way)


def wrong_the_librarys(q0, target, alpha, eps, steps):
    """course_lib.ik.damped_path is called"""
    return ik.damped_path(None, q0, target, alpha, eps, steps)


def wrong_the_librarys_with_its_arm(q0, target, alpha, eps, steps):
    """course_lib.arms.planar_arm is called"""
    return ik.damped_path(arms.planar_arm([1, 1, 1, 1]), q0, target, alpha, eps, steps)


def wrong_wrapped(q0, target, alpha, eps, steps):
    """the angles are wrapped"""
    way = [np.array(q0, float)]
    for _ in range(steps):
        way.append((lm_step(way[-1], target, alpha, eps) + np.pi) % (2 * np.pi) - np.pi)
    return np.array(way)
