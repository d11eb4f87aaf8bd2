"""Inverse kinematics for poses: what can be reached is reached, inside the limits, and the result
tells the truth."""

import numpy as np
import pytest
from helpers import close, pose_samples

from course_lib import ik, rigid, rotations
from course_lib.arms import SerialArm, iiwa14, panda, planar_arm, ur5e
from course_lib.batched_arm import CHUNK
from course_lib.ik import pose_error, solve


def reachable(arm, n, seed=0):
    return arm.fk(np.random.default_rng(seed).uniform(*arm.limits.T, (n, arm.n)))


def apart(T, target):
    """Metres and radians between poses, by other means than the library's."""
    R = np.swapaxes(T[..., :3, :3], -1, -2) @ target[..., :3, :3]
    off = np.linalg.norm(R - np.eye(3), axis=(-2, -1))
    return np.linalg.norm(T[..., :3, 3] - target[..., :3, 3], axis=-1), 2 * np.arcsin(
        np.minimum(off / np.sqrt(8), 1)
    )


@pytest.mark.parametrize("make", [panda, iiwa14, ur5e])
def test_targets_are_reached_from_cold_starts(make):
    """Targets are solved together and one by one."""
    arm = make()
    targets = reachable(arm, 1000)
    together = solve(arm, targets, np.random.default_rng(1))
    one_by_one = [
        solve(arm, target, np.random.default_rng(i)) for i, target in enumerate(targets[:100])
    ]
    alone = ik.IKResult(
        *(np.array([vars(one)[name] for one in one_by_one]) for name in vars(together))
    )
    for found, goals in ((together, targets), (alone, targets[:100])):
        assert found.success.all()
        assert ((found.q >= arm.limits[:, 0]) & (found.q <= arm.limits[:, 1])).all()
        assert (found.iterations >= 1).all()
        for i, gap in enumerate(apart(arm.fk(found.q), goals)):
            assert gap.max() <= 1e-6
            close(found.residual[:, i], gap, 1e-7)
    assert np.median(alone.iterations) <= 15, (
        "a single target is first tried by itself, with few steps for most"
    )


@pytest.mark.parametrize("make", [panda, iiwa14, ur5e])
def test_a_thousand_targets_take_few_steps(make):
    """The Panda's took 25 each when starts were the nearest of eight configurations."""
    arm = make()
    found = solve(arm, reachable(arm, 1000), np.random.default_rng(1))
    assert found.iterations.mean() <= 20


def test_equal_targets_are_reached_by_different_joint_angles():
    arm = panda()
    target = arm.fk([0, -np.pi / 4, 0, -3 * np.pi / 4, 0, np.pi / 2, np.pi / 4])
    found = solve(arm, np.tile(target, (8, 1, 1)), np.random.default_rng(0))
    assert found.success.all()
    gaps = np.abs(found.q[:, None] - found.q).max(-1)
    assert gaps[np.triu_indices(8, 1)].min() > 1e-2


def test_an_unreachable_target_ends_nearby_without_success():
    arm = panda()
    far = rigid.transform(np.diag([1.0, -1, -1]), [3.0, 0, 0.333])
    found = solve(arm, far, np.random.default_rng(2), starts=20)
    assert not found.success
    metres, radians = apart(arm.fk(found.q), far)
    np.testing.assert_allclose(found.residual, [metres, radians], atol=1e-7)
    # No better than the stretched arm can, and not much worse.
    assert 2.1 < metres < 2.4
    assert (found.q >= arm.limits[:, 0]).all()
    assert (found.q <= arm.limits[:, 1]).all()


def test_a_target_beyond_the_limits_is_not_reached():
    free = panda()
    narrow = SerialArm(free.screw_axes, free.home, np.tile([-0.1, 0.1], (7, 1)))
    found = solve(
        narrow, free.fk([0.5, 0.4, 0.3, -1.5, 0.2, 1.5, 0.1]), np.random.default_rng(3), starts=10
    )
    assert not found.success
    assert np.abs(found.q).max() <= 0.1


@pytest.mark.parametrize("shift", [2 * np.pi, -6 * np.pi, 1.0])
def test_limits_far_from_zero(shift):
    limits = panda().limits + shift
    limits[::2] = (
        [shift, np.inf],
        [-np.inf, shift],
        [shift - 10, shift + 10],
        [shift - 9, shift + 20],
    )
    arm = SerialArm(panda().screw_axes, panda().home, limits)
    targets = panda().fk(
        np.random.default_rng(0).uniform(*np.clip(limits, shift - 3, shift + 3).T, (20, 7))
    )
    for found in (
        solve(arm, targets, np.random.default_rng(0)),
        solve(arm, targets[0], np.random.default_rng(0)),
    ):
        assert found.success.all()
        assert ((found.q >= limits[:, 0]) & (found.q <= limits[:, 1])).all()


def test_the_start_that_is_given_is_used():
    arm = panda()
    q0 = np.array([0, -np.pi / 4, 0, -3 * np.pi / 4, 0, np.pi / 2, np.pi / 4])
    there = solve(arm, arm.fk(q0), np.random.default_rng(4), q0=q0)
    assert there.iterations == 1
    np.testing.assert_allclose(there.q, q0, atol=1e-12)
    near = solve(arm, arm.fk(q0 + 0.01), np.random.default_rng(4), q0=q0)
    assert near.success
    assert np.abs(near.q - q0).max() < 0.1
    outside = solve(arm, arm.fk(q0), np.random.default_rng(4), q0=q0 + 100)
    assert outside.success


def test_the_same_seed_gives_the_same_answer():
    arm, targets = panda(), reachable(panda(), 20)
    one, two = (solve(arm, targets, np.random.default_rng(5)) for _ in range(2))
    assert all(np.array_equal(vars(one)[name], vars(two)[name]) for name in vars(one))


@pytest.mark.parametrize("batch", [(), (0,), (1,), (2, 1, 3)])
def test_the_result_has_the_batch_of_the_targets(batch):
    arm = iiwa14()
    targets = reachable(arm, 6)[: int(np.prod(batch))].reshape(*batch, 4, 4)
    found = solve(arm, targets, np.random.default_rng(6))
    assert found.q.shape == (*batch, 7)
    assert found.success.shape == found.iterations.shape == batch
    assert found.residual.shape == (*batch, 2)
    assert found.success.all()


def test_an_arm_of_few_degrees_of_freedom_reports_its_residual():
    arm = planar_arm([1, 1, 1])
    inside, tilted = arm.fk([0.3, 0.5, -0.4]), rigid.transform(rotations.rot_x(0.5), [2.0, 0.5, 0])
    found = solve(arm, [inside, tilted], np.random.default_rng(8), starts=10)
    assert found.success.tolist() == [True, False]
    assert found.residual[1, 1] > 0.1


def test_no_more_starts_and_steps_than_allowed():
    far = rigid.transform(np.eye(3), [3.0, 0, 0.333])
    for starts, steps in [(1, 1), (1, 30), (3, 5), (40, 4), (300, 2)]:
        # Two targets are searched together; each start takes at least one step.
        found = solve(panda(), [far, far], np.random.default_rng(1), starts=starts, steps=steps)
        assert (found.iterations <= starts * steps).all()
        assert (found.iterations >= starts).all()


def test_more_targets_than_are_stepped_together():
    arm, n = iiwa14(), CHUNK + 30
    assert solve(arm, reachable(arm, n), np.random.default_rng(3)).success.all()
    q0 = np.random.default_rng(0).uniform(*arm.limits.T, (n, 7))
    there = solve(arm, arm.fk(q0), np.random.default_rng(3), q0=q0)
    assert (there.iterations == 1).all()
    np.testing.assert_allclose(there.q, q0, atol=1e-12)


def test_poses_as_printed_with_six_digits_are_targets():
    arm = panda()
    q = np.random.default_rng(0).uniform(*arm.limits.T, (4000, 7))
    exact, printed = arm.fk(q), arm.fk(q).round(6)
    poses = rigid.is_se(printed)
    assert 2000 < poses.sum() < 4000
    error = pose_error(exact[poses], printed[poses])
    assert np.abs(error).max() < 2e-6
    assert np.abs(pose_error(printed[poses], printed[poses][::-1])[:, :3]).max() <= np.pi
    assert solve(arm, printed[poses][:50], np.random.default_rng(0), q[poses][:50]).success.all()


def test_a_printed_target_half_a_revolution_away_is_reached():
    """Its rotation from the start may be off by a little more than a pose may be."""
    arm = panda()
    low, high = arm.limits.T
    q = np.random.default_rng(0).uniform(low, [*high[:-1], low[-1] + 2], (2000, 7))
    printed = arm.fk(q).round(6)
    poses = rigid.is_se(printed)
    half_a_revolution = np.pi * np.eye(7)[6]
    for target, q0 in zip(printed[poses][:200], q[poses] + half_a_revolution, strict=False):
        assert solve(arm, target, np.random.default_rng(0), q0).success
    together = solve(arm, printed[poses], np.random.default_rng(0), q[poses] + half_a_revolution)
    assert together.success.all()


def test_the_pose_error_leads_from_one_pose_to_the_other():
    """Also at an angle of pi and near it, and for no rotation at all."""
    T, target = pose_samples(3)(np.random.default_rng(8), (2, 1000))
    beside = np.array([np.pi, np.pi - 1e-12, np.pi - 1e-7, 1e-9, 1e-200, 0])
    target[:6, :3, :3] = rotations.exp_so3(beside[:, None] * [0.6, 0, -0.8]) @ T[:6, :3, :3]
    left = pose_error(T, target)
    rotated = rotations.exp_so3(left[:, :3]) @ T[:, :3, :3]
    np.testing.assert_allclose(rotated, target[:, :3, :3], atol=1e-13)
    np.testing.assert_allclose(T[:, :3, 3] + left[:, 3:], target[:, :3, 3], atol=1e-13)
    assert np.linalg.norm(left[:, :3], axis=-1).max() <= np.pi + 1e-12


def test_the_pose_error_belongs_to_the_geometric_jacobian():
    arm, rng = panda(), np.random.default_rng(9)
    q, change = rng.uniform(*arm.limits.T, (100, 7)), 1e-6 * rng.normal(size=(100, 7))
    moved = (arm.geometric_jacobian(q) @ change[..., None])[..., 0]
    np.testing.assert_allclose(
        pose_error(arm.fk(q - change / 2), arm.fk(q + change / 2)), moved, atol=1e-13
    )


@pytest.mark.parametrize("targets", [1, 2])
def test_a_target_at_exactly_half_a_revolution_causes_no_warning(targets):
    """numpy would warn of pi divided by a sine that is 0; warnings are errors in the tests."""
    arm = planar_arm([1, 1])
    goal = arm.fk(np.zeros(2))
    goal[:3, :3] = np.diag([-1.0, -1, 1])
    poses = goal if targets == 1 else np.stack([goal, arm.fk(np.array([0.3, 0.4]))])
    q0 = np.zeros(2) if targets == 1 else np.zeros((2, 2))
    found = solve(arm, poses, np.random.default_rng(0), q0, starts=2)
    assert np.isfinite(found.residual).all()
