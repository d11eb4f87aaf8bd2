"""What notebook 6 measures its tables with."""

import numpy as np
import pytest

from course_lib.lessons.decomposition_ik import cells, check
from course_lib.lessons.decomposition_ik.grid_ik import planar_forward

BOTH = np.array([[1.0, 1.0], [2.0, -1.0], [1.1, 1.1], [2.1, -1.1], [1.2, 1.0], [2.2, -1.2]])


def test_what_is_sent_leads_to_the_angles_that_are_to_be_taken():
    taken = np.random.default_rng(3).uniform(-2, 2, (3, 4, 2))
    np.testing.assert_allclose(cells.sagged(cells.sent(taken)), taken, atol=1e-13)
    upright = [np.pi / 2, 0.0]  # without load, and with a straight elbow
    np.testing.assert_allclose(cells.sagged(upright), upright, atol=1e-15)


def test_a_forward_kinematics_learnt_in_cells_is_the_arms():
    rng, ranges = np.random.default_rng(0), np.array([[0, -1.5], [2.9, 1.5]])
    q = rng.uniform(*ranges, (20_000, 2))
    learnt = cells.JointCells(*ranges, 8).fit(planar_forward(cells.sagged(q))[0], q).forward
    theta = rng.uniform(*ranges, (50, 2))
    position, J = learnt(theta)
    assert np.abs(position - planar_forward(cells.sagged(theta))[0]).max() < 2e-3
    for joint in (0, 1):
        step = 1e-7 * np.eye(2)[joint]
        ahead, behind = (learnt(theta + side * step)[0] for side in (1, -1))
        near = np.abs(ahead - behind).max(axis=1) < 1e-6  # both in one cell
        assert near.mean() > 0.9
        np.testing.assert_allclose(J[near, :, joint], ((ahead - behind) / 2e-7)[near], atol=1e-6)


def by_angle(q):
    return (q[:, 0] > 1.5).astype(int)


@pytest.mark.parametrize(
    ("q", "split", "kind"),
    [
        (BOTH, by_angle, cells.KINDS[0]),
        (np.abs(BOTH), by_angle, cells.KINDS[1]),
        (BOTH, lambda q: by_angle(q[::-1]), cells.KINDS[2]),
        (BOTH[:5], by_angle, cells.FEW),
    ],
)
def test_a_cell_has_its_kind(q, split, kind):
    kind_of, _ = cells.kinds(q, np.full(len(q), 2), 4, split)
    assert kind_of.tolist() == [cells.FEW, cells.FEW, kind, cells.FEW]


def test_a_branch_table_answers_only_in_cells_with_models():
    rng = np.random.default_rng(1)
    q = rng.uniform([0.5, -1.2], [1.5, 1.2], (4000, 2))
    xy, _ = planar_forward(q)
    number = np.floor(xy[:, 0] / 0.2).astype(int)
    parts = (check.fit_square.library, check.branch_by_sign.library)
    table = cells.BranchTable(cells.quadratic_terms, *parts).fit(xy, q, number)
    assert table.size == 14 * len(table.models)
    found = table.predict(xy[:200], number[:200])
    branch = (q[:200, 1] < 0).astype(int)
    assert np.nanmedian(np.abs(found[np.arange(200), branch] - q[:200])) < 0.02
    assert np.isnan(table.predict(xy[:3], np.array([-1, 99, -1]))).all()
