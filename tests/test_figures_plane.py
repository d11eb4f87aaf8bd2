"""Pictures in the plane: movies of bodies and arms, paths, steps of an arm: what they draw is true."""

import numpy as np
import pytest
from helpers import places, stored
from matplotlib.colors import same_color
from numpy.testing import assert_allclose

from course_lib import rotations
from course_lib.arms import planar_arm
from course_lib.figures import rigid_motion as figures
from course_lib.figures import subproblems_damped_ik as steps
from course_lib.figures.style import CRIMSON
from course_lib.planar import interpolate_arm, interpolate_body

ROUNDED = 6e-4  # pictures keep millimetres
N = 31
TIMES = np.linspace(0, 3, N)
POSES = interpolate_body([-7, -5, 2.6], [6, 5, -2.2], N)
ANGLES = interpolate_arm([0.1, 0.2], [np.pi - 0.2, np.pi / 2], N)
POINTS = planar_arm([1, 1]).frames(ANGLES)[..., :2, 3]

TARGET = np.array([-1.9, 1.1])
ALPHAS, EPSILONS, LARGEST = np.geomspace(0.01, 10, 7), np.geomspace(0.01, 100, 5), 2.5
ERRORS = 10 ** np.linspace(-7, 0, 35).reshape(7, 5)
CORNERS = np.array([[-1, -0.7], [0.7, -0.7], [1.4, 0], [0.7, 0.7], [-1, 0.7], [-1, -0.7]])


MOVIES = [stored(figures.body_movie("body", POSES, TIMES)), stored(figures.arm_movie("arm", POINTS, TIMES))]


def drawn_lines(ax):
    return [np.transpose(line.get_data()) for line in ax.lines]


# ---- movies ----


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


@pytest.mark.parametrize(("number", "way"), [(0, POSES[:, :2]), (1, POINTS[:, -1])])
def test_a_movie_shows_its_whole_path_and_begins_with_its_first_frame(number, way):
    figure = MOVIES[number]
    path, marks, mover = figure["data"]
    assert_allclose(places(path), way, atol=ROUNDED)
    assert_allclose(places(marks), way[[0, -1]] if number == 0 else [[0, 0]], atol=ROUNDED)
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


# ---- plain pictures ----


def test_body_paths_draw_the_outline_at_every_so_many_poses_and_the_last():
    drawn = figures.past_a_gate({"one": POSES, "two": POSES[::-1]}).fig
    for ax, poses in zip(drawn.axes, (POSES, POSES[::-1]), strict=True):
        way, *outlines = drawn_lines(ax)
        assert_allclose(way, poses[:, :2])
        assert_allclose(outlines, [figures.outline(poses[i]) for i in (0, 16, 30)])
        alphas = [line.get_alpha() for line in ax.lines[1:]]
        assert alphas == sorted(alphas)
        assert alphas[-1] == 1
        assert ax.get_aspect() == 1
        for outline in outlines:
            assert np.abs(outline).max() < ax.get_xlim()[1] == ax.get_ylim()[1]


def test_paths_by_euler_s_method_are_drawn_with_their_error():
    fig = figures.euler_paths({"a": POSES[:, :2], "b": POINTS[:, -1]}).fig
    a, b = drawn_lines(fig.axes[0])
    assert_allclose(a, POSES[:, :2])
    assert_allclose(b, POINTS[:, -1])
    off = np.linalg.norm(POSES[-1, :2] - POINTS[-1, -1])
    assert [text.get_text() for text in fig.legends[0].get_texts()] == [f"a: {off:.3f} m off", "b"]


def test_the_dock_stands_before_the_robot_that_drove_to_it_and_the_other_robot_where_it_is_believed():
    driven, believed = np.array([[0, 0, 0], [1, 0.5, np.pi / 2]]), np.array([[0, 0, 0], [1.1, 0.4, np.pi / 2]])
    (ax,) = figures.missed_dock(driven, believed).fig.axes
    assert_allclose(drawn_lines(ax)[0], driven[:, :2])
    assert_allclose(drawn_lines(ax)[1], believed[:, :2])
    circles = [patch for patch in ax.patches if hasattr(patch, "center")]
    assert_allclose(circles[-1].center, believed[-1, :2])
    assert same_color(circles[-1].get_edgecolor(), CRIMSON)
    assert_allclose([circles[0].center, circles[-2].center], driven[:, :2])
    (dock,) = [patch for patch in ax.patches if not hasattr(patch, "center")]
    x, y = dock.get_xy()[:4].T
    assert_allclose(np.mean(x), 1)
    assert np.min(y) > 0.5 + circles[0].radius


def test_a_car_parks_beside_the_table_as_it_drove():
    poses = np.array([[0, 0, 0], [0.5, 0, 0], [1, 0.3, np.pi / 2]])
    (ax,) = figures.parking(poses, [1, 2, np.pi / 2], [0.6, 1, 0.4], 0.5).fig.axes
    assert_allclose(drawn_lines(ax)[0], poses[:, :2])
    circles = [patch for patch in ax.patches if hasattr(patch, "center")]
    assert_allclose([circles[0].center, circles[1].center], 2 * [[0.6, 1]])
    assert [circles[0].radius, circles[1].radius] == [0.5, 0.4]
    (dock,) = [patch for patch in ax.patches if not hasattr(patch, "center")]
    assert dock.get_xy()[:, 1].min() > 2 + circles[-1].radius


def test_joint_tracks_draw_the_angles():
    (ax,) = figures.joint_tracks({"a": ANGLES}).fig.axes
    assert_allclose(drawn_lines(ax), [ANGLES])


def test_arm_paths_draw_the_arm_at_every_so_many_instants_and_the_last_in_red():
    (ax,) = figures.arm_paths({"one": POINTS}, every=7).fig.axes
    *postures, way = drawn_lines(ax)
    assert_allclose(postures, POINTS[[0, 7, 14, 21, 28, 30]])
    assert_allclose(way, POINTS[:, -1])
    assert [same_color(line.get_color(), CRIMSON) for line in ax.lines[:-1]] == 5 * [False] + [True]


def test_descents_draw_tip_last_configuration_and_distance():
    drawn = steps.descents({"run": POINTS, "back": POINTS[::-1]}, TARGET)
    plane, error = drawn.fig.axes
    tips, arm, tips_back, arm_back, goal = drawn_lines(plane)
    assert_allclose(tips, POINTS[:, -1])
    assert_allclose(arm, POINTS[-1])
    assert_allclose(tips_back, POINTS[::-1, -1])
    assert_allclose(arm_back, POINTS[0])
    assert_allclose(goal, [TARGET])
    distances = np.hypot(*(POINTS[:, -1] - TARGET).T)
    assert_allclose(drawn_lines(error)[0], np.stack([np.arange(N), distances], -1))
    assert [line.get_color() for line in error.lines] == [line.get_color() for line in plane.lines[:4:2]]
    low, high = np.transpose([plane.get_xlim(), plane.get_ylim()])
    shown = np.concatenate([POINTS[:, -1], POINTS[-1], POINTS[0], [TARGET]])
    assert ((low < shown) & (shown < high)).all(), "everything drawn lies in the window"
    assert f"run: ends {distances[-1]:.2g} m from it" in drawn.alt


def test_descents_that_jump_are_drawn_as_dots_and_small_errors_on_a_logarithmic_axis():
    jumping = POINTS * np.where(np.arange(N) % 2, 1, -1)[:, None, None]
    closer = POINTS[-1] + np.geomspace(1, 1e-6, N)[:, None, None]
    drawn = steps.descents({"jumps": jumping, "closer": closer}, POINTS[-1, -1])
    plane, error = drawn.fig.axes
    assert [line.get_linestyle() for line in plane.lines[:2]] == ["None", "--"]
    assert error.get_yscale() == "log"
    assert "jumps: jumps about" in drawn.alt


def test_gains_peak_at_the_root_of_the_damping():
    (ax,) = steps.gains([0.5, 2, 50], {"s2": 1.1, "s1": 2.6}).fig.axes
    lines = {line.get_label(): np.transpose(line.get_data()) for line in ax.lines}
    s, factor = lines["no damping: $1/s$"].T
    assert_allclose(factor, 1 / s)
    for eps in (0.5, 2, 50):
        assert_allclose(lines[rf"$\epsilon$ = {eps:g} m$^2$"], np.stack([s, s / (s**2 + eps)], -1))
    dots = [np.transpose(line.get_data())[0] for line in ax.lines if line.get_marker() == "o"]
    assert_allclose([dot[0] for dot in dots], np.sqrt([0.5, 2]), err_msg="that of 50 lies outside")
    for dot, eps in zip(dots, (0.5, 2), strict=True):
        assert dot[1] == pytest.approx(max(s / (s**2 + eps)), rel=1e-4)
    assert [line.get_xdata()[0] for line in ax.lines[-2:]] == [1.1, 2.6]
    assert [(note.get_text(), note.xy[0]) for note in ax.texts] == [("$s_2$", 1.1), ("$s_1$", 2.6)]


def test_the_largest_rates_are_those_of_the_matrix_and_follow_the_text_s_formulas():
    b2 = np.linspace(0.02, np.pi - 0.02, 301)
    (ax,) = steps.largest_rates(lambda b: np.linalg.inv(wrist_rates(b))).fig.axes
    together, single = (line.get_ydata() for line in ax.lines)
    assert_allclose(single, 1 / np.sin(b2))
    assert_allclose(together, 1 / np.sqrt(1 - np.abs(np.cos(b2))))


def wrist_rates(b):
    """The columns of Ry(b1) Rx(b2) Ry(b3): the axes of its rates."""
    first = rotations.rot_y(b[0])
    return np.column_stack([[0, 1, 0], first[:, 0], (first @ rotations.rot_x(b[1]))[:, 1]])


def test_the_step_map_shows_each_run_where_it_belongs_and_the_limit():
    runs = [(0.2, 2.0), (2.8, 2.0)]
    ax, _ = steps.step_map(ALPHAS, EPSILONS, ERRORS, LARGEST, runs).fig.axes
    (mesh,) = ax.collections
    assert_allclose(mesh.get_array().reshape(5, 7), np.log10(ERRORS).T)
    corners = mesh.get_coordinates()  # of 5 rows and 7 columns of cells, each about its own run
    low, high = corners[:-1, :-1], corners[1:, 1:]
    centres = np.stack(np.meshgrid(ALPHAS, EPSILONS), -1)
    assert ((low < centres) & (centres < high)).all()
    limit, marks = drawn_lines(ax)
    assert_allclose(limit, np.stack([2 * (1 + EPSILONS / LARGEST**2), EPSILONS], -1))
    assert_allclose(marks, runs)
    assert (ax.get_xscale(), ax.get_yscale()) == ("log", "log")
