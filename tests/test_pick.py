"""Clearances and bounds of the Panda: against the shape that is drawn, and against motions known in
closed form."""

import numpy as np
import pytest

from course_lib import rigid
from course_lib.arms import panda
from course_lib.figures.solids import Model, link_poses, shells
from course_lib.lessons.panda_dh_ik import pick
from course_lib.lessons.panda_dh_ik.exercises.shared import READY

FAR = rigid.transform(np.eye(3), [3.0, 0, 0.6])


def solid(q):
    """The vertices of the drawn arm with its open gripper in the world, and the number of the body
    of each."""
    arm = panda()
    tip = arm.home[-1] @ pick.IN_FLANGE
    parts = shells.gripper(7, tip)
    for side in (1, -1):
        parts += [
            p.moved(tip @ rigid.transform(np.eye(3), [0, -0.04 * side, 0]))
            for p in shells.finger(7, side)
        ]
    model = Model.of([*shells.shell(arm), *parts])
    return model.placed(link_poses(arm, q)) + pick.BASE[:3, 3], model.bodies


def test_the_clearance_from_the_worktop_is_that_of_what_is_drawn():
    for q in READY + np.random.default_rng(0).uniform(-0.5, 0.5, (20, 7)):
        vertices, bodies = solid(q)
        assert (
            abs(pick.clearances(q, FAR)["worktop"] - (vertices[bodies > 1, 2].min() - 0.6)) < 0.022
        )


def test_a_mug_is_touched_only_where_the_arm_is_drawn():
    vertices, bodies = solid(READY)
    lowest = min(vertices[bodies == 7], key=lambda p: p[2])
    below = rigid.transform(np.eye(3), lowest - [0, 0, 0.1])
    assert 0 < pick.clearances(READY, below)["mug"] < 0.02
    assert pick.clearances(READY, rigid.transform(np.eye(3), lowest - [0, 0, 0.05]))["mug"] < 0
    assert pick.clearances(READY, FAR)["mug"] > 2


def test_an_arm_folded_onto_itself_touches_itself():
    assert pick.clearances(READY, FAR)["itself"] > 0.03
    assert pick.clearances([0, -1.2, 0, -3.07, 0, 0.2, 0], FAR)["itself"] < 0


def test_shares_are_those_of_cubic_time_scaling():
    u = np.linspace(0, 1, 401)
    x = np.zeros((401, 8))
    x[:, 0], x[:, 2] = 2 * u, 0.8 * (3 * u**2 - 2 * u**3)
    speed, acceleration = pick.shares(x)
    np.testing.assert_allclose(speed.max(), 0.8 * 1.5 / 2 / 2.175, rtol=1e-3)
    np.testing.assert_allclose(acceleration.max(), 0.8 * 6 / 4 / 7.5, rtol=1e-2)
    x[:, 0] /= 2
    np.testing.assert_allclose(
        [share.max() for share in pick.shares(x)], [2 * speed.max(), 4 * acceleration.max()]
    )


def test_a_start_at_full_speed_takes_an_acceleration():
    x = np.column_stack([np.linspace(0, 1, 11), np.outer(np.linspace(0, 1, 11), np.ones(7))])
    speed, acceleration = pick.shares(x)
    np.testing.assert_allclose(speed[:-1], 1 / 2.175)
    np.testing.assert_allclose(acceleration[[0, -1]], 1 / 0.1 / 7.5)
    assert acceleration[1:-1].max() < 1e-9


@pytest.mark.parametrize("times", [[0, 0, 1], [0, 2, 1], [0]])
def test_times_that_do_not_increase_are_refused(times):
    x = np.zeros((len(times), 8))
    x[:, 0] = times
    with pytest.raises(ValueError, match="times that increase"):
        pick.shares(x)
