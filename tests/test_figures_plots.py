"""Plots and movies in the plane draw the numbers that they are given: lines, dots, arms, histograms."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from course_lib import rotations
from course_lib.arms import planar_arm
from course_lib.figures.style import BLUE
from course_lib.lessons.decomposition_ik import figures as nb6
from course_lib.lessons.poe_kuka_iiwa import figures as nb4
from course_lib.lessons.rigid_motion import figures as nb2
from course_lib.lessons.subproblems_damped_ik import figures as nb3
from course_lib.planar import interpolate_arm, interpolate_body

N = 31
POSES = interpolate_body([-7, -5, 2.6], [6, 5, -2.2], N)
ANGLES = interpolate_arm([0.1, 0.2], [np.pi - 0.2, np.pi / 2], N)
ARM = planar_arm([1, 1]).frames(ANGLES)[..., :2, 3]
TARGET = np.array([-1.9, 1.1])
SPACE = np.random.default_rng(2).normal(size=(9, 3))
ELBOWS = np.array([[0.0, np.pi / 2], [np.pi / 2, -np.pi / 2]])
STEPS = np.arange(N)
S = np.linspace(0.01, 4.2, 300)
COSTS = {"table": 240000, "formula": 16}, {"table": 0.2, "formula": 2e-14}


def wrist_rates(b):
    """The columns of Ry(b1) Rx(b2) Ry(b3): the axes of its rates."""
    first = rotations.rot_y(b[0])
    return np.column_stack([[0, 1, 0], first[:, 0], (first @ rotations.rot_x(b[1]))[:, 1]])


def over(x, *series):
    return [np.stack([x, y], -1) for y in series]


B2 = np.linspace(0.02, np.pi - 0.02, 301)
MISS = np.hypot(*(ARM[:, -1] - TARGET).T)
DESCENT = nb3.descents({"run": ARM, "back": ARM[::-1]}, TARGET, "")
# (picture, which of its panels, the points of the lines that it draws first)
LINES = {
    "outlines": (nb2.past_a_gate({"a": POSES}), 0, [POSES[:, :2], *(nb2.outline(POSES[i]) for i in (0, 16, 30))]),
    "Euler": (nb2.euler_paths({"a": POSES[:, :2], "b": ARM[:, -1]}), 0, [POSES[:, :2], ARM[:, -1]]),
    "car": (nb2.parking(POSES, [1, 2, 1.6], [0.6, 1, 0.4], 0.5), 0, [POSES[:, :2]]),
    "arm": (nb2.arm_paths({"a": ARM}), 0, [*ARM[::10], ARM[:, -1]]),
    "descent": (DESCENT, 0, [ARM[:, -1], ARM[-1], ARM[::-1, -1], ARM[0], [TARGET]]),
    "distance": (DESCENT, 1, over(STEPS, MISS, MISS[::-1])),
    "gains": (nb3.gains([0.5, 50], {}), 0, [*over(S, 1 / S, S / (S**2 + 0.5)), [[0.5**0.5, 0.5**0.5]]]),
    "rates": (nb3.largest_rates(lambda b: np.linalg.inv(wrist_rates(b))), 0,
              over(B2, 1 / np.sqrt(1 - np.abs(np.cos(B2))), 1 / np.sin(B2))),
    "elbows": (nb6.two_elbows(ELBOWS, np.ones(2)), 0, [[[0, 0], [1, 0], [1, 1]], [[0, 0], [0, 1], [1, 1]], [[1, 1]]]),
    "costs": (nb6.costs(*COSTS), 0, [[[240000, 0.2]], [[16, 2e-14]]]),
    "from above": (nb4.plane_projections(SPACE), 0, [SPACE[:, :2]]),
    "velocities": (nb4.velocities_against_each_other({"a": SPACE, "b": 2 * SPACE}), 5, [2 * SPACE[:, [1, 2]]]),
    "scalings": (nb2.time_scalings(np.arange(9), {"a": SPACE.T, "b": 2 * SPACE.T}), 1,
                 over(np.arange(9), SPACE[:, 1], 2 * SPACE[:, 1])),
    "components": (nb4.velocities_over_time(np.arange(9), {"a": SPACE}), 0, over(np.arange(9), *SPACE.T)),
}  # fmt: skip


@pytest.mark.parametrize("name", LINES)
def test_lines_go_through_their_data_and_lie_in_the_panel(name):
    picture, panel, expected = LINES[name]
    ax = picture.fig.axes[panel]
    low, high = np.transpose([ax.get_xlim(), ax.get_ylim()])
    for line, points in zip(ax.lines, expected, strict=False):
        assert_allclose(np.transpose(line.get_data()), points, atol=1e-9)
        assert ((low <= points) & (points <= high)).all() or name == "gains"


def test_larger_errors_are_larger_and_darker_and_a_missing_one_is_not_drawn():
    xy, off = np.array([[0.0, 1.0], [1.0, 1.0], [2.0, 0.0]]), np.array([0.3, 12, np.nan])
    ax = nb6.errors({"a": (xy, off)}, "").fig.axes[0]
    (dots,) = ax.collections
    assert_allclose(dots.get_offsets(), xy[:2])
    assert_allclose(dots.get_array(), [0.3, 10])
    assert dots.get_sizes()[1] > dots.get_sizes()[0]
    assert [text.get_text() for text in ax.texts] == ["12.0 cm"]


# ---- films: bodies and arms are where their data say, at each time ----

CORNERS = np.array([[-1, -0.7], [0.7, -0.7], [1.4, 0], [0.7, 0.7], [-1, 0.7], [-1, -0.7]])
TIMES = np.linspace(0, 3, N)
FILMS = [nb2.body_movie("body", POSES, TIMES), nb2.arm_movie("arm", ARM, TIMES, ARM[::-1])]
ROUNDED = 6e-4  # films keep millimetres


@pytest.mark.parametrize(("number", "track"), [(0, POSES[:, :2]), (1, ARM[:, -1])])
def test_a_film_shows_its_whole_path_and_all_of_it_is_in_the_window(number, track):
    film = FILMS[number].meta
    assert film["movie"] == ["body", "arm"][number]
    assert_allclose(film["times"], TIMES, atol=1e-4)
    (path, colour, dash), *others = film["still"]
    assert_allclose(path, track, atol=ROUNDED)
    assert (colour, dash) == (BLUE, [7, 5])
    seen = np.concatenate(
        [
            np.reshape(each, (-1, 2))
            for each in (*film["shapes"], *(points for points, *_ in others))
        ]
    )
    room = film["half"] * np.array([1, film["proportion"]])
    assert (np.abs(seen - film["centre"]) < room).all()


def test_the_body_stands_at_each_pose_with_its_nose_ahead():
    for corners, (x, y, theta) in zip(FILMS[0].meta["shapes"][0], POSES, strict=True):
        ahead, left = (
            np.array([np.cos(theta), np.sin(theta)]),
            np.array([-np.sin(theta), np.cos(theta)]),
        )
        assert_allclose(
            corners, [x, y] + CORNERS[:, :1] * ahead + CORNERS[:, 1:] * left, atol=ROUNDED
        )
        nose = np.array(corners)[np.argmax((corners - np.array([x, y])) @ ahead)]
        assert_allclose(nose, [x, y] + 1.4 * ahead, atol=ROUNDED)
        assert_allclose(nb2.outline([x, y, theta]), corners, atol=1e-9)
