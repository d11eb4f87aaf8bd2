"""What students write for compose(R, step, frame)."""

import numpy as np


def right_two_branches(R, step, frame):
    if frame == "world":
        return step @ R
    return R @ step


def right_by_columns(R, step, frame):
    if frame == "body":
        return [list(row) for row in R.dot(step)]
    return np.column_stack([step @ R[:, k] for k in range(3)])


def right_step_seen_from_the_world(R, step, frame):
    seen = R @ step @ R.T if frame == "body" else step
    return np.einsum("ij,jk->ik", seen, R)


def wrong_world_and_body_swapped(R, step, frame):
    """world and body are swapped"""
    return R @ step if frame == "world" else step @ R


def wrong_always_the_world(R, step, frame):
    """the frame makes no difference"""
    return np.matmul(step, R)


def wrong_name_of_the_frame(R, step, frame):
    """the frame makes no difference"""
    return step @ R if frame == "World" else R @ step


def wrong_conjugated(R, step, frame):
    """R stands on both sides of step"""
    return step @ R if frame == "world" else R @ step @ R.T


def wrong_star(R, step, frame):
    """entry by entry"""
    return step * R if frame == "world" else R * step


def wrong_transpose_for_the_body(R, step, frame):
    """one of the two is transposed"""
    return step @ R if frame == "world" else R.T @ step


def wrong_no_return_for_the_body(R, step, frame):
    """a return is missing"""
    if frame == "world":
        return step @ R


def wrong_in_place(R, step, frame):
    """R is changed in place"""
    R[:] = step @ R if frame == "world" else R @ step
    return R


def wrong_step_seen_from_the_body(R, step, frame):
    """unnamed"""
    return step @ R if frame == "world" else R.T @ step @ R @ R
