"""The pictures of notebook 4 that tell their data in words."""

from pathlib import Path

import numpy as np
import pytest

from course_lib import arms, trajectory
from course_lib.figures import poe_drawing
from course_lib.figures import poe_pictures as pictures

ARMS = {"iiwa": arms.iiwa14(), "ur5e": arms.ur5e()}


@pytest.mark.parametrize("name", ARMS)
def test_the_drawing_s_corners_lie_on_the_axes_and_end_at_the_flange(name):
    arm, data = ARMS[name], poe_drawing._ARMS[name]
    corners = np.array(data["corners"])
    np.testing.assert_allclose(corners[-1], arm.home[-1][:3, 3], atol=1e-12)
    np.testing.assert_allclose(data["flange"], arm.home[-1][:3, :3], atol=1e-12)
    for S in arm.screw_axes:
        assert min(np.linalg.norm(np.cross(S[:3], corner) + S[3:]) for corner in corners) < 1e-12


@pytest.mark.parametrize("name", ARMS)
def test_every_length_of_the_arm_stands_in_the_drawing_once(name):
    data = poe_drawing._ARMS[name]
    lengths = np.abs(np.diff(np.array(data["corners"]), axis=0)).max(1)
    drawn = [np.abs(np.subtract(end, start)).max() for _, start, end, _ in data["dimensions"]]
    np.testing.assert_allclose(sorted(lengths), sorted(drawn), atol=1e-12)
    told = poe_drawing.three_views(name, ARMS[name])
    texts = [text.get_text() for ax in told["fig"].axes for text in ax.texts]
    for length in lengths:
        assert f"{1000 * length:g}" in texts
        assert f"{1000 * length:g} along" in told["alt"]


def test_a_figure_of_eight_crosses_itself_once_and_an_ellipse_does_not():
    motion = trajectory.load(Path(__file__).parents[1] / "notebooks/data/iiwa_trajectory.csv")
    alt = pictures.plane_projections(ARMS["iiwa"].fk(motion.q)[:, :3, 3])["alt"]
    assert "x-y 1 times, x-z 1 times, y-z 0 times" in alt


def test_the_words_on_the_table_tell_whether_a_path_goes_through_it():
    down = np.column_stack([np.zeros(5), np.zeros(5), np.linspace(0.5, 0.1, 5)])
    assert "goes through the table" in pictures.wrong_frame({"a": down}, 0.25)["alt"]
    assert "No path touches" in pictures.wrong_frame({"a": down}, 0.05)["alt"]
    assert "moves by 40 cm" in pictures.wrong_frame({"a": down}, 0.05)["alt"]


@pytest.mark.parametrize("n", [3, 200])
def test_a_film_of_any_length_has_words_of_its_own(n):
    t = np.linspace(0, 2, n)
    motion = trajectory.Trajectory(t, np.outer(t, np.full(7, 0.2)), np.full((n, 7), 0.2))
    made = pictures.arm_movie(ARMS["iiwa"], motion)
    assert "2.0 s" in made["alt"]
    assert len(made["fig"].frames) <= 20
