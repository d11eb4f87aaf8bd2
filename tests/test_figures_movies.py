"""Movies in the plane: bodies and arms are where their data say, at each time."""

import numpy as np
import pytest
from helpers import places, stored
from numpy.testing import assert_allclose

from course_lib.arms import planar_arm
from course_lib.figures import rigid_motion as figures
from course_lib.figures.style import CRIMSON
from course_lib.planar import interpolate_arm, interpolate_body

ROUNDED = 6e-4  # pictures keep millimetres
N = 31
TIMES = np.linspace(0, 3, N)
POSES = interpolate_body([-7, -5, 2.6], [6, 5, -2.2], N)
ANGLES = interpolate_arm([0.1, 0.2], [np.pi - 0.2, np.pi / 2], N)
POINTS = planar_arm([1, 1]).frames(ANGLES)[..., :2, 3]

CORNERS = np.array([[-1, -0.7], [0.7, -0.7], [1.4, 0], [0.7, 0.7], [-1, 0.7], [-1, -0.7]])


MOVIES = [stored(figures.body_movie("body", POSES, TIMES)), stored(figures.arm_movie("arm", POINTS, TIMES))]


@pytest.mark.parametrize("number", [0, 1])
def test_a_movie_has_a_frame_and_a_label_for_each_time(number):
    figure = MOVIES[number]
    assert [frame["name"] for frame in figure["frames"]] == [str(i) for i in range(N)]
    (slider,), (menu,) = figure["layout"]["sliders"], figure["layout"]["updatemenus"]
    assert [step["label"] for step in slider["steps"]] == [f"{t:.2f}" for t in TIMES]
    assert [step["args"][0] for step in slider["steps"]] == [[str(i)] for i in range(N)]
    assert slider["currentvalue"]["prefix"] == "time (s): "
    play, pause = menu["buttons"]
    assert play["args"][1]["frame"]["duration"] * (N - 1) == pytest.approx(3000, rel=1e-5), "it plays in real time"
    assert pause["args"][0] == [None]
    assert figure["layout"]["meta"] | {"controls": 0} == {"movie": ["body", "arm"][number], "seconds": 3, "controls": 0}


@pytest.mark.parametrize(("number", "track"), [(0, POSES[:, :2]), (1, POINTS[:, -1])])
def test_a_movie_shows_its_whole_path_and_begins_with_its_first_frame(number, track):
    figure = MOVIES[number]
    path, marks, mover = figure["data"]
    assert_allclose(places(path), track, atol=ROUNDED)
    assert_allclose(places(marks), track[[0, -1]] if number == 0 else [[0, 0]], atol=ROUNDED)
    assert all(frame["traces"] == [2] for frame in figure["frames"])
    assert_allclose(places(mover), places(figure["frames"][0]["data"][0]))
    assert mover["line"]["color"] == CRIMSON


@pytest.mark.parametrize("number", [0, 1])
def test_a_movie_stays_in_its_window_at_equal_scales(number):
    layout = MOVIES[number]["layout"]
    for letter in "xy":
        low, high = layout[f"{letter}axis"]["range"]
        assert all(low < x < high for frame in MOVIES[number]["frames"] for x in frame["data"][0][letter])
        assert layout[f"{letter}axis"]["title"]["text"] == f"{letter} (m)"
    assert (layout["yaxis"]["scaleanchor"], layout["yaxis"]["scaleratio"]) == ("x", 1)


def test_the_body_stands_at_each_pose_with_its_nose_ahead():
    frames = MOVIES[0]["frames"]
    for frame, (x, y, theta) in zip(frames, POSES, strict=True):
        ahead, left = np.array([np.cos(theta), np.sin(theta)]), np.array([-np.sin(theta), np.cos(theta)])
        corners = places(frame["data"][0])
        assert_allclose(corners, [x, y] + CORNERS[:, :1] * ahead + CORNERS[:, 1:] * left, atol=ROUNDED)
        nose = corners[np.argmax((corners - [x, y]) @ ahead)]
        assert_allclose(nose, [x, y] + 1.4 * ahead, atol=ROUNDED)
        assert_allclose(figures.outline([x, y, theta]), corners, atol=1e-9)


def test_the_arm_stands_at_its_angles_in_each_frame():
    for frame, (first, second) in zip(MOVIES[1]["frames"], ANGLES, strict=True):
        elbow = np.array([np.cos(first), np.sin(first)])
        tip = elbow + np.array([np.cos(first + second), np.sin(first + second)])
        assert_allclose(places(frame["data"][0]), [[0, 0], elbow, tip], atol=ROUNDED)
