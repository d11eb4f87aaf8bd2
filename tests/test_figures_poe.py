"""The pictures of notebook 4: the arm is where forward kinematics puts it, in every frame."""

import numpy as np
from films import Film, assert_in_ranges
from helpers import places, shown, stored

from course_lib import rigid
from course_lib.arms import iiwa14
from course_lib.figures import poe_kuka_iiwa as figures
from course_lib.figures import solids

ARM = iiwa14()
Q = np.array([2.2, 0.7, 0, -1.3, 0, 0.5, 0]) + np.random.default_rng(1).uniform(-0.7, 0.7, (5, 7))
TIMES = np.linspace(0, 2, 5)


def movie():
    return stored(figures.arm_movie("iiwa", ARM, Q, TIMES))


def test_the_arm_is_where_forward_kinematics_puts_it():
    figure = movie()
    film = Film(figure)
    assert len(figure["frames"]) == len(Q)
    np.testing.assert_allclose(film.poses, solids.link_poses(ARM, Q), atol=5e-5)
    for i in range(len(Q)):
        np.testing.assert_allclose(film.frame(i), film.at(i), atol=1e-3)
        assert_in_ranges(film.at(i), figure["layout"]["scene"], 1000)


def test_the_end_effectors_path_is_drawn_through_all_samples():
    path = next(places(trace) for trace in movie()["data"] if len(trace["x"]) == len(Q))
    np.testing.assert_allclose(path / 1000, ARM.fk(Q)[:, :3, 3], atol=1e-3)


def test_a_movie_in_space_is_redrawn_in_every_frame():
    (menu,), (slider,) = (movie()["layout"][key] for key in ("updatemenus", "sliders"))
    assert all(button["args"][1]["frame"]["redraw"] for button in menu["buttons"])
    assert all(step["args"][1]["frame"]["redraw"] for step in slider["steps"])
    assert [step["label"] for step in slider["steps"]] == ["0.00", "0.50", "1.00", "1.50", "2.00"]


def test_joint_axes_are_numbered_at_zero_and_elsewhere():
    for q, names in ((None, ["1, 3, 5, 7", "2", "4", "6"]), (Q[0], list("1234567"))):
        figure = stored(figures.arm_with_axes(ARM, q))
        assert [name for trace in figure["data"] if trace.get("mode") == "text" for name in trace["text"]] == names


def test_the_upright_arm_fills_more_than_half_of_the_picture_s_height():
    figure = stored(figures.arm_with_axes(ARM))
    body = solids.arm_model(ARM).placed(solids.link_poses(ARM, np.zeros(7)))
    assert np.ptp(solids.scene.projected(body, figure["layout"]["scene"])[:, 1]) / 2 > 0.5
    assert figure["layout"]["height"] >= 560


def test_a_screw_motion_shows_its_path_and_four_of_its_poses():
    poses = rigid.exp_se3(np.linspace(0, 6, 30)[:, None] * np.array([0, 0, 1, 0, -0.5, 0.1]))
    figure = stored(figures.screw_motion(poses, np.array([0.5, 0, 0]), np.array([0.0, 0, 1])))
    drawn = next(places(trace) for trace in figure["data"] if len(trace["x"]) == 30)
    np.testing.assert_allclose(drawn, poses[:, :3, 3], atol=2e-3)
    mesh = places(next(trace for trace in figure["data"] if trace["type"] == "mesh3d" and trace["cmax"] < 99))
    for k in (0, 9, 19, 29):
        for axis in range(3):
            tip = poses[k, :3, 3] + 0.2 * np.ptp(poses[:, :3, 3], axis=0).max() * poses[k, :3, axis]
            assert np.linalg.norm(mesh - tip, axis=1).min() < 1e-3


def test_plain_pictures_show_the_pairs_that_their_axes_name():
    path = np.random.default_rng(2).normal(size=(9, 3))
    projections, pairs = figures.plane_projections(path), figures.against_each_other({"a": path, "b": 2 * path})
    for fig, scale in ((projections, [1, 1, 1]), (pairs, [1, 1, 1, 2, 2, 2])):
        assert set(shown(fig).data) == {"image/png", "text/plain"}
        for ax, factor in zip(fig.axes, scale, strict=True):
            names = [label.split()[0].strip("$")[-1] for label in (ax.get_xlabel(), ax.get_ylabel())]
            line = ax.lines[0]
            for name, numbers in zip(names, (line.get_xdata(), line.get_ydata()), strict=True):
                np.testing.assert_allclose(numbers, factor * path[:, "xyz".index(name)])
