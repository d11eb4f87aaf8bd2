"""Adjoints as they go wrong, for the exercises that use one."""

import numpy as np

from course_lib.rotations import hat

# (name of the mistake, hint) -> the 6 x 6 matrices of somebody who makes it, each a function of (R, p).
ADJOINTS = {
    (
        "the adjoint is the one the report prints, with R^-1 in its upper half",
        "Ad(T) = [[R, 0], [[p] R, R]]: R stands in the upper half too, not its inverse.",
    ): (
        lambda R, p: np.block([[R.T, 0 * R], [hat(p) @ R, R]]),
        lambda R, p: np.block([[R.T, 0 * R], [hat(p) @ R.T, R]]),
    ),
    ("R^T stands where R belongs in the adjoint", "Ad(T) = [[R, 0], [[p] R, R]], with the R and p of T itself."): (
        lambda R, p: np.block([[R.T, 0 * R], [hat(p) @ R.T, R.T]]),
        lambda R, p: np.block([[R.T, 0 * R], [hat(p) @ R, R.T]]),
        lambda R, p: np.block([[R, 0 * R], [hat(p) @ R, R.T]]),
        lambda R, p: np.block([[R, 0 * R], [hat(p) @ R.T, R]]),
    ),
    (
        "[p] R is left out of the adjoint",
        "Ad(T) = [[R, 0], [[p] R, R]]: a turn about an axis far away moves the origin.",
    ): (lambda R, p: np.block([[R, 0 * R], [0 * R, R]]),),
    (
        "the blocks of the adjoint are in the order (v, omega)",
        "Twists are (omega, v) here: Ad(T) = [[R, 0], [[p] R, R]].",
    ): (lambda R, p: np.block([[R, hat(p) @ R], [0 * R, R]]),),
    (
        "[p] R is turned round in the adjoint",
        "Ad(T) = [[R, 0], [[p] R, R]]: [p] stands on the left, without a minus.",
    ): (
        lambda R, p: np.block([[R, 0 * R], [R @ hat(p), R]]),
        lambda R, p: np.block([[R, 0 * R], [-hat(p) @ R, R]]),
    ),
    ("the adjoint has [p] where [p] R belongs", "Ad(T) = [[R, 0], [[p] R, R]]."): (
        lambda R, p: np.block([[R, 0 * R], [hat(p), R]]),
    ),
    ("the adjoint is transposed", "Ad(T) = [[R, 0], [[p] R, R]]: the block of zeros is on the upper right."): (
        lambda R, p: np.block([[R, 0 * R], [hat(p) @ R, R]]).T,
    ),
}
