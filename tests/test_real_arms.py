"""Arms from DH parameters, the iiwa and the Panda: against products of their own, print, and one
another."""

import numpy as np
import pytest
from helpers import close

from course_lib.arms import DHRow, SerialArm, panda, ur5e

QUARTER = np.pi / 2
# The Panda's standard table, which moves like the manufacturer's modified one.
STANDARD = [
    DHRow(0, -QUARTER, 0.333),
    DHRow(0, QUARTER, 0),
    DHRow(0.0825, QUARTER, 0.316),
    DHRow(-0.0825, -QUARTER, 0),
    DHRow(0, QUARTER, 0.384),
    DHRow(0.088, QUARTER, 0),
    DHRow(0, 0, 0.107),
]


# The manufacturer's table of the UR5e, in the standard convention.
UR5E = [
    DHRow(0, QUARTER, 0.1625),
    DHRow(-0.425, 0, 0),
    DHRow(-0.3922, 0, 0),
    DHRow(0, QUARTER, 0.1333),
    DHRow(0, -QUARTER, 0.0997),
    DHRow(0, 0, 0.0996),
]


def craig(row, q):
    """One row's transform as Craig prints it, equation 3.6."""
    c, s, ca, sa = (
        np.cos(row.theta + q),
        np.sin(row.theta + q),
        np.cos(row.alpha),
        np.sin(row.alpha),
    )
    return np.array(
        [
            [c, -s, 0, row.a],
            [s * ca, c * ca, -sa, -sa * row.d],
            [s * sa, c * sa, ca, ca * row.d],
            [0, 0, 0, 1],
        ]
    )


def siciliano(row, q):
    """One row's transform in the standard convention, Siciliano and others, equation 2.52."""
    c, s, ca, sa = (
        np.cos(row.theta + q),
        np.sin(row.theta + q),
        np.cos(row.alpha),
        np.sin(row.alpha),
    )
    return np.array(
        [
            [c, -s * ca, s * sa, row.a * c],
            [s, c * ca, -c * sa, row.a * s],
            [0, sa, ca, row.d],
            [0, 0, 0, 1],
        ]
    )


@pytest.mark.parametrize(("convention", "printed"), [("modified", craig), ("standard", siciliano)])
def test_frames_are_the_products_of_the_printed_transforms(convention, printed):
    rng = np.random.default_rng(2)
    rows = [DHRow(*rng.normal(size=4)) for _ in range(5)]
    end = SerialArm.from_screws([[0, 0, 1]], [[0.1, 0.2, 0.3]], np.eye(4)).fk([0.7])
    arm = SerialArm.from_dh(rows, convention, end)
    for q in rng.uniform(-7, 7, (20, 5)):
        T, frames = np.eye(4), arm.frames(q)
        for row, angle, frame in zip(rows, q, frames, strict=False):
            T = T @ printed(row, angle)
            close(frame, T, 1e-13)
        close(frames[-1], T @ end, 1e-13)
        close(arm.fk(q), T @ end, 1e-13)


@pytest.mark.parametrize(
    ("arm", "table"), [(panda(), STANDARD), (ur5e(), UR5E)], ids=["panda", "ur5e"]
)
def test_an_arm_moves_as_its_standard_table_and_as_its_screws(arm, table):
    screws = arm.screw_axes
    points = np.cross(screws[:, :3], screws[:, 3:])
    q = np.random.default_rng(3).uniform(-3, 3, (1000, arm.n))
    for other in (
        SerialArm.from_dh(table, "standard"),
        SerialArm.from_screws(screws[:, :3], points, arm.home[-1]),
    ):
        close(other.fk(q), arm.fk(q), 1e-14)
        close(other.space_jacobian(q), arm.space_jacobian(q), 1e-13)
