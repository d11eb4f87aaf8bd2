"""The thirty mugs of notebook 5: what is drawn, and what counts as picked."""

import numpy as np

from course_lib import rigid, rotations
from course_lib.checks import panda_dh_ik as check
from course_lib.checks.exercises.panda_dh_ik import challenge

READY = np.array([0, -np.pi / 4, 0, -3 * np.pi / 4, 0, np.pi / 2, np.pi / 4])
T_FG = rigid.transform(rotations.rot_z(-np.pi / 4), [0, 0, 0.1034])
MUG = rigid.transform(rotations.rot_z(0.7), [0.3, -0.05, 0.6])


def approach(beside=0.0, height=0.06, tilt=0.0, n=8, above=0.15, mug=MUG):
    """Joint angles from above the mug down to a grasp, first with joint 1 towards it; metres and radians."""
    grasp = mug @ rigid.transform(rotations.rot_x(np.pi + tilt), [beside, 0, height])
    start = rigid.transform(np.eye(3), [0, 0, above]) @ grasp
    x, y = mug[:2, 3] - [-0.2, 0.13]
    joints = [np.array([np.arctan2(y, x), *READY[1:]])]
    for T in check.straight_path.library(start, grasp, np.linspace(0, 1, n)):
        joints.append(check.panda_ik.library(T @ rigid.inverse(T_FG), joints[-1]))
    return np.array(joints[1:])


def test_a_straight_approach_from_above_picks_the_mug():
    assert challenge.picked(MUG, approach(), T_FG)
    assert challenge.picked(MUG, approach(beside=0.004, tilt=np.deg2rad(8)), T_FG)


def test_a_grasp_beside_the_mug_too_high_tilted_or_too_fast_does_not():
    assert not challenge.picked(MUG, approach(beside=0.006), T_FG)
    assert not challenge.picked(MUG, approach(height=0.09), T_FG)
    assert not challenge.picked(MUG, approach(tilt=np.deg2rad(12)), T_FG)
    assert not challenge.picked(MUG, approach(above=0.1), T_FG)
    jumping = approach()
    jumping[3, 6] += 0.5
    assert not challenge.picked(MUG, jumping, T_FG)
    assert not challenge.picked(MUG, approach()[-1:], T_FG), "one configuration is no approach"


def test_at_most_three_points_of_a_scene_are_wrong_and_the_others_are_nearly_exact():
    random = np.random.default_rng(3)
    counts = set()
    for _ in range(200):
        T, points = challenge.mug_scene(random)
        off = np.linalg.norm(challenge.TEMPLATE @ T[:3, :3].T + T[:3, 3] - points, axis=1)
        counts.add(int((off > 0.006).sum()))
    assert counts == {0, 1, 2, 3}


def test_each_of_the_thirty_mugs_can_be_picked():
    random = np.random.default_rng(11)
    for _ in range(30):
        mug, _points = challenge.mug_scene(random)
        rotated = (mug @ rigid.transform(rotations.rot_z(np.pi * k / 12), np.zeros(3)) for k in range(24))
        assert any(challenge.picked(mug, approach(mug=each), T_FG) for each in rotated), mug[:3, 3]
