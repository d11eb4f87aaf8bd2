"""The thirty mugs of notebook 5: what is drawn, and what counts as picked."""

import numpy as np

from course_lib import rigid, rotations
from course_lib.lessons.panda_dh_ik import check, pick
from course_lib.lessons.panda_dh_ik.exercises import challenge
from course_lib.lessons.panda_dh_ik.exercises.shared import READY

MUG = rigid.transform(rotations.rot_z(0.7), [0.3, -0.05, 0.6])


def approach(beside=0.0, height=0.06, tilt=0.0, mug=MUG):
    """The library's plan to a grasp, metres and radians off the one from above."""
    grasp = mug @ rigid.transform(rotations.rot_x(np.pi + tilt), [beside, 0, height])
    return check.plan_pick.library(READY, grasp)


def test_a_motion_from_above_picks_the_mug():
    assert challenge.picked(MUG, approach())
    assert challenge.picked(MUG, approach(beside=0.004, tilt=np.deg2rad(4)))


def test_a_grasp_out_of_tolerance_picks_no_mug():
    assert not challenge.picked(MUG, approach(beside=0.006))
    assert not challenge.picked(MUG, approach(height=0.09))
    assert not challenge.picked(MUG, approach(tilt=np.deg2rad(12)))
    good = approach()
    for factor in (0.9, 5):
        assert not challenge.picked(MUG, good * np.array([factor, *np.ones(7)])), (
            "too fast, too slow"
        )
    jumping = good.copy()
    jumping[3, 7] += 0.5
    assert not challenge.picked(MUG, jumping)
    assert not challenge.picked(MUG, good[5:]), "it begins somewhere else"
    assert not challenge.picked(MUG, good[-1:]), "one configuration is no motion"


def test_what_touches_something_picks_nothing():
    good = approach()
    assert not challenge.picked(
        MUG @ rigid.transform(rotations.rot_z(np.pi / 2), np.zeros(3)), good
    ), "the handle"
    low = approach(height=0.031, tilt=np.deg2rad(9))
    assert min(gap.min() for gap in pick.clearances(low[:, 1:], MUG).values()) < 0
    assert not challenge.picked(MUG, low)


def test_at_most_three_points_of_a_scene_are_wrong():
    random = np.random.default_rng(3)
    counts = set()
    for _ in range(200):
        T, points = challenge.mug_scene(random)
        off = np.linalg.norm(challenge.TEMPLATE @ T[:3, :3].T + T[:3, 3] - points, axis=1)
        counts.add(int((off > 0.006).sum()))
    assert counts == {0, 1, 2, 3}


def test_each_of_the_thirty_mugs_can_be_picked_from_some_side():
    random = np.random.default_rng(11)  # as in `score`
    scenes = [challenge.mug_scene(random)[0] for _ in range(30)]
    assert all(any(picked_from(angle, mug) for angle in SIDES) for mug in scenes)


SIDES = np.deg2rad(np.arange(0, 360, 20))  # angles of the gripper about the mug's axis


def picked_from(angle, mug):
    """Whether the library's plan, with the gripper rotated about the mug's axis, picks the mug."""
    rotation = rotations.rot_z(angle) @ rotations.rot_x(np.pi)
    plan = check.plan_pick.library(READY, mug @ rigid.transform(rotation, [0, 0, 0.06]))
    return challenge.picked(mug, plan)
