"""The pictures of notebook 4: a screw motion, and the dimensioned drawings of arms."""

import itertools

import numpy as np
import pytest
from films import Film

from course_lib import rigid
from course_lib.arms import iiwa14, ur5e
from course_lib.figures import three_views
from course_lib.lessons.poe_kuka_iiwa import figures

ARMS = {"iiwa": iiwa14(), "ur5e": ur5e()}


def test_a_screw_motion_shows_its_path_and_four_of_its_poses():
    poses = rigid.exp_se3(np.linspace(0, 6, 30)[:, None] * np.array([0, 0, 1, 0, -0.5, 0.1]))
    film = Film(figures.screw_motion(poses, np.array([0.5, 0, 0]), np.array([0.0, 0, 1])))
    np.testing.assert_allclose(film.paths[0], poses[:, :3, 3], atol=6e-5)
    for k in (0, 9, 19, 29):
        for axis in range(3):
            tip = poses[k, :3, 3] + 0.2 * np.ptp(poses[:, :3, 3], axis=0).max() * poses[k, :3, axis]
            assert np.linalg.norm(film.at(0) - tip, axis=1).min() < 1e-3


# ---- the dimensioned drawings ----


@pytest.mark.parametrize("name", ARMS)
def test_the_drawing_s_corners_lie_on_the_axes_and_end_at_the_flange(name):
    arm, corners = ARMS[name], np.array(three_views._ARMS[name]["corners"])
    np.testing.assert_allclose(corners[-1], arm.home[-1][:3, 3], atol=1e-12)
    for S in arm.screw_axes:
        assert min(np.linalg.norm(np.cross(S[:3], corner) + S[3:]) for corner in corners) < 1e-12


@pytest.mark.parametrize("name", ARMS)
def test_every_length_of_the_arm_stands_in_the_drawing_once(name):
    lengths = np.abs(np.diff(np.array(three_views._ARMS[name]["corners"]), axis=0)).max(1)
    fig, alt, _ = three_views.three_views(name, ARMS[name])
    texts = [text.get_text() for ax in fig.axes for text in ax.texts]
    for length in lengths:
        assert texts.count(f"{1000 * length:g}") == 1
        assert f"{1000 * length:g} along" in alt


@pytest.mark.parametrize("name", ARMS)
def test_no_word_of_the_drawing_covers_another(name):
    fig = three_views.three_views(name, ARMS[name]).fig
    fig.draw_without_rendering()
    boxes = [text.get_window_extent() for ax in fig.axes for text in ax.texts if text.get_text()]
    assert len(boxes) > 20
    assert not any(one.overlaps(other) for one, other in itertools.combinations(boxes, 2))
