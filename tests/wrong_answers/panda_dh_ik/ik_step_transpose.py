"""What students write for ik_step_transpose(q, J, e, step)."""

import numpy as np

from course_lib.arms import panda


def right_in_one_line(q, J, e, step):
    return q + step * J.T @ e


def right_from_the_left(q, J, e, step):
    return q + e @ J * step


def right_in_loops_as_a_list(q, J, e, step):
    moved = []
    for j in range(len(q)):
        downhill = 0
        for i in range(len(e)):
            downhill += J[i][j] * e[i]
        moved.append(q[j] + step * downhill)
    return moved


def right_as_a_column(q, J, e, step):
    return q.reshape(-1, 1) + step * J.transpose() @ e.reshape(-1, 1)


def right_on_a_copy_and_wrapped(q, J, e, step):
    moved = np.array(q, float)
    moved += np.einsum("ij,i->j", J, step * e)
    return np.arctan2(np.sin(moved), np.cos(moved))


def right_minus_the_gradient_by_differences(q, J, e, step):
    """Half the squared error is quadratic where J is taken as fixed: central differences are exact."""

    def half_squared(dq):
        return 0.5 * np.sum((e - J @ dq) ** 2)

    gradient = [(half_squared(d) - half_squared(-d)) / 2 for d in np.eye(len(q))]
    return tuple(q - step * np.array(gradient))


def right_weighted_sum_of_rows(q, J, e, step):
    return q + step * sum(weight * row for weight, row in zip(e, J))


def wrong_minus(q, J, e, step):
    """the step goes the other way"""
    return q - step * J.T @ e


def wrong_no_transpose(q, J, e, step):
    """ValueError"""
    return q + step * J @ e


def wrong_dot_without_transpose(q, J, e, step):
    """ValueError"""
    return q + step * np.dot(J, e)


def wrong_entry_by_entry(q, J, e, step):
    """ValueError"""
    return q + step * J.T * e


def wrong_transpose_only_where_shapes_ask_for_it(q, J, e, step):
    """J stands for its transpose"""
    return q + step * (J @ e if J.shape[0] == J.shape[1] else J.T @ e)


def wrong_step_forgotten(q, J, e, step):
    """step is not used"""
    return q + J.T @ e


def wrong_step_squared(q, J, e, step):
    """step is squared"""
    dq = step * J.T @ e
    return q + step * dq


def wrong_divided_by_step(q, J, e, step):
    """divided by step"""
    return q + J.T @ e / step


def wrong_pseudoinverse(q, J, e, step):
    """the pseudoinverse's"""
    return q + step * np.linalg.pinv(J) @ e


def wrong_pseudoinverse_in_full(q, J, e, step):
    """the pseudoinverse's"""
    return q + np.linalg.pinv(J) @ e


def wrong_damped(q, J, e, step):
    """the damped one"""
    return q + np.linalg.solve(J.T @ J + step * np.eye(len(q)), J.T @ e)


def wrong_inverse(q, J, e, step):
    """LinAlgError"""
    return q + step * np.linalg.inv(J) @ e


def wrong_only_the_step(q, J, e, step):
    """only the step is returned"""
    return step * J.T @ e


def wrong_in_place(q, J, e, step):
    """UFuncTypeError"""
    q += step * J.T @ e
    return q


def wrong_in_place_with_any_kind_of_numbers(q, J, e, step):
    """q is changed in place"""
    for j in range(len(q)):
        q[j] = q[j] + step * (J[:, j] @ e)
    return q


def wrong_error_scaled_in_place(q, J, e, step):
    """e is changed in place"""
    e *= step
    return q + J.T @ e


def wrong_not_returned(q, J, e, step):
    """a return is missing"""
    q = q + step * J.T @ e


def wrong_unit_step(q, J, e, step):
    """scaled to the length"""
    dq = J.T @ e
    size = np.linalg.norm(dq)
    return q + (step * dq / size if size > 0 else dq)


def wrong_unit_step_without_a_thought_for_zero(q, J, e, step):
    """divided by zero"""
    dq = J.T @ e
    return q + step * dq / np.linalg.norm(dq)


def wrong_unit_error(q, J, e, step):
    """the error is divided by its length"""
    return q + step * J.T @ (e / max(np.linalg.norm(e), 1e-12))


def wrong_factor_two(q, J, e, step):
    """twice as long"""
    return q + 2 * step * J.T @ e


def wrong_brackets(q, J, e, step):
    """step multiplies q as well"""
    return step * (q + J.T @ e)


def wrong_clipped_to_half_turns(q, J, e, step):
    """kept inside limits"""
    return np.clip(q + step * J.T @ e, -np.pi, np.pi)


def wrong_clipped_to_the_pandas_limits(q, J, e, step):
    """kept inside limits"""
    moved = q + step * J.T @ e
    return np.clip(moved, *panda().limits.T) if len(q) == 7 else moved


def wrong_degrees(q, J, e, step):
    """degrees and radians"""
    return np.rad2deg(q + step * J.T @ e)


def wrong_column_of_errors(q, J, e, step):
    """differ in shape"""
    return q + step * J.T @ e[:, None]


def wrong_whole_numbers(q, J, e, step):
    """digits after the point are cut off"""
    moved = np.zeros_like(q)
    moved[:] = q + step * J.T @ e
    return moved


def wrong_rounded(q, J, e, step):
    """first digits only"""
    return np.round(q + step * J.T @ e, 4)


def wrong_step_of_the_notebook(q, J, e, step):
    """a wrong length"""
    return q + 0.3 * J.T @ e


def wrong_step_capped(q, J, e, step):
    """step is not used"""
    return q + min(step, 1) * J.T @ e


def wrong_halves_exchanged(q, J, e, step):
    """halves of e are exchanged"""
    return q + step * J.T @ (np.concatenate([e[3:], e[:3]]) if len(e) == 6 else e)


def wrong_only_the_position(q, J, e, step):
    """unnamed"""
    return q + step * J[:3].T @ e[:3]


def wrong_joint_of_the_largest_slope_only(q, J, e, step):
    """unnamed"""
    dq = J.T @ e
    return q + step * np.where(np.abs(dq) == np.abs(dq).max(), dq, 0)
