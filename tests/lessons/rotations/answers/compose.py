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


def wrong_step_seen_from_the_body(R, step, frame):
    """the answers to some inputs only are wrong"""
    return step @ R if frame == "world" else R.T @ step @ R @ R
