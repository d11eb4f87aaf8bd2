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


# ---- charts of a trajectory ----

T = np.array([0.0, 0.5, 2.0])
V = {"space": np.arange(9.0).reshape(3, 3), "body": -np.eye(3)}


def test_a_point_of_a_curve_without_a_time_axis_says_its_time():
    path = figures.plane_projections(T, V["space"]).fig.data[0]
    velocity = figures.velocities_against_each_other(T, V).fig.data[0]
    for curve in (path, velocity):
        assert [list(row) for row in curve.customdata] == [[0.0], [0.5], [2.0]]
        assert "time: %{customdata[0]" in curve.hovertemplate


def test_no_cell_of_the_workspace_reaches_beyond_its_edges():
    angle = np.linspace(-np.pi / 2, np.pi / 2, 201)
    edge = 0.1 + 0.97 * np.cos(angle), 0.97 * np.sin(angle)  # half a circle beside a hole
    radii, heights = np.arange(0.15, 1.2, 0.1), np.arange(-1.05, 1.1, 0.1)
    everywhere = np.ones((len(heights), len(radii)))
    drawn = figures.workspace(radii, heights, everywhere, 0.1, edge).fig.data[0]
    r, z = np.meshgrid(drawn.x, drawn.y)
    has_colour = np.isfinite(np.array(drawn.z, float))
    farthest = np.hypot(r + 0.05 - 0.1, np.abs(z) + 0.05)
    assert (has_colour == (farthest < 0.97)).all()


POSES = rigid.transform(np.eye(3), np.array([[0.0, 0, 0], [0.1, 0, 0], [0.1, 0.3, 0]]))


def test_the_charts_hold_the_velocities_of_each_frame():
    course = figures.velocities_over_time(T, V, POSES).meta
    assert course["times"] == T.tolist()
    for chart, (frame, velocities) in zip(course["charts"], V.items(), strict=True):
        assert chart["title"] == frame
        drawn = np.transpose([values for *_, values in chart["curves"]])
        np.testing.assert_allclose(drawn, velocities, atol=1e-4)
        low, high = chart["range"]
        assert low < velocities.min()
        assert velocities.max() < high
        assert all(low <= tick <= high for tick in chart["ticks"])


def test_the_arrow_at_the_end_effector_is_along_its_velocity():
    ((body, _, vectors),) = figures.velocities_over_time(T, V, POSES).meta["arrows"]
    assert body == 0
    np.testing.assert_allclose(np.cross(vectors, V["body"]), 0, atol=1e-4)
    assert (np.sum(vectors * V["body"], axis=1) > 0).all()


def test_what_rounding_decides_is_drawn_as_zero():
    film = figures.velocities_over_time(T, {"space": np.full((3, 3), 3e-12)}, POSES)
    assert not np.any([values for *_, values in film.meta["charts"][0]["curves"]])


def test_each_arm_holds_its_glass_at_both_ends_of_the_film():
    q = np.array([[0, 0.5, 0, -1.2, 0, 0.8, 0], [0, 0.9, 0, -1.2, 0, 0.8, 0]])
    film = Film(figures.wrong_frame(ARMS["iiwa"], {"A": q}, 0.1))
    T = ARMS["iiwa"].fk(q)
    rim = np.array([0, 0, 0.06])  # the middle of the rim, upright at the beginning
    in_gripper = rigid.inverse(T[0])[:3, :3] @ rim
    for pose, vertices in ((T[0], film.pale()), (T[1], film.at(0))):
        middle = pose[:3, :3] @ in_gripper + pose[:3, 3]
        away = np.linalg.norm(vertices - middle, axis=1)
        on_the_rim = np.abs(away - 0.045) < 1e-3
        assert on_the_rim.sum() >= 16


# ---- one motion, two observers ----


def drawn_velocities(ax):
    """Return the start and the end of each arrow of a velocity, and the places of the dots."""
    arrows = [(tuple(text.xyann), tuple(text.xy)) for text in ax.texts if text.arrow_patch]
    dots = [tuple(line.get_xydata()[0]) for line in ax.lines if line.get_marker() == "o"]
    return arrows, dots


def test_a_velocity_is_drawn_at_the_origin_of_its_observer():
    turntable, door = figures.two_observers().fig.axes
    about_z = np.array([[0, -1], [1, 0]])  # omega x p for a rotation about z at 1 rad/s
    origin_a, origin_b = np.zeros(2), np.array([1.0, 0])
    for ax, axle in ((turntable, origin_b), (door, origin_a)):
        arrows, dots = drawn_velocities(ax)
        (moving,) = [origin for origin in (origin_a, origin_b) if any(origin != axle)]
        assert (tuple(moving), tuple(moving + about_z @ (moving - axle))) in arrows
        assert dots == [tuple(axle)]


# ---- the dimensioned drawings ----


@pytest.mark.parametrize("name", ARMS)
def test_the_corners_of_a_drawing_lie_on_the_joint_axes(name):
    """The last corner is the flange."""
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


def test_the_caption_of_a_drawing_begins_with_its_finding():
    plain, told = (three_views.three_views("iiwa", ARMS["iiwa"], finding=f) for f in ("", "Found."))
    assert plain.caption.startswith("The dimensions are in millimetres.")
    assert told.caption == f"Found. {plain.caption}"


@pytest.mark.parametrize("name", ARMS)
def test_no_word_of_the_drawing_covers_another(name):
    fig = three_views.three_views(name, ARMS[name]).fig
    fig.draw_without_rendering()
    boxes = [text.get_window_extent() for ax in fig.axes for text in ax.texts if text.get_text()]
    assert len(boxes) > 20
    assert not any(one.overlaps(other) for one, other in itertools.combinations(boxes, 2))
