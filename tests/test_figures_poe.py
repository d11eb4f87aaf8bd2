"""The pictures of notebook 4: the arm stands where forward kinematics puts it, in every frame."""

import numpy as np
from helpers import assert_in_scene, places, shown, stored

from course_lib import rigid
from course_lib.arms import iiwa14
from course_lib.figures import poe_kuka_iiwa as figures
from course_lib.figures.style import BLUE, GREEN

ARM = iiwa14()
Q = np.array([2.2, 0.7, 0, -1.3, 0, 0.5, 0]) + np.random.default_rng(1).uniform(-0.7, 0.7, (5, 7))
TIMES = np.linspace(0, 2, 5)


def movie():
    return stored(figures.arm_movie("iiwa", ARM, Q, TIMES))


def test_the_arm_stands_where_forward_kinematics_puts_it():
    figure = movie()
    assert_in_scene(figure)
    assert len(figure["frames"]) == len(Q)
    middle = places(figure["data"][1])[0]  # the base
    for frame, q in zip(figure["frames"], Q, strict=True):
        joints = places(frame["data"][0]) - middle
        np.testing.assert_allclose(joints[1:], ARM.frames(q)[:, :3, 3], atol=2e-3)
        for i in range(3):
            axes = places(frame["data"][1 + i]).reshape(-1, 3, 3) - middle
            np.testing.assert_allclose(axes[:, 1] - axes[:, 0], 0.12 * ARM.frames(q)[:, :3, i], atol=2e-3)


def test_the_hands_path_is_drawn_through_all_samples():
    figure = movie()
    path, base = places(figure["data"][0]), places(figure["data"][1])
    np.testing.assert_allclose(path - base, ARM.fk(Q)[:, :3, 3], atol=2e-3)


def test_a_movie_in_space_is_drawn_anew_in_every_frame():
    (menu,), (slider,) = (movie()["layout"][key] for key in ("updatemenus", "sliders"))
    assert all(button["args"][1]["frame"]["redraw"] for button in menu["buttons"])
    assert all(step["args"][1]["frame"]["redraw"] for step in slider["steps"])
    assert [step["label"] for step in slider["steps"]] == ["0.00", "0.50", "1.00", "1.50", "2.00"]


def test_axes_are_drawn_through_their_joints():
    figure = stored(figures.arm_with_axes(ARM))
    assert_in_scene(figure)
    names = [trace["text"][0] for trace in figure["data"] if trace["mode"] == "text"]
    assert names == list("1234567xy")
    lines = [places(trace) for trace in figure["data"] if trace["mode"] == "lines" and len(trace["x"]) == 2]
    for line, frame, direction in zip(lines, ARM.home, ARM.screw_axes[:, :3], strict=False):
        along = line[1] - line[0]
        np.testing.assert_allclose(np.cross(along, direction), 0, atol=2e-3)
        np.testing.assert_allclose(line[0] + [0, 0, 0.66], frame[:3, 3], atol=2e-3)
        assert along @ direction > 0
    drawn = {trace["text"][0]: trace["textfont"]["color"] for trace in figure["data"] if trace["mode"] == "text"}
    assert [drawn[name] for name in "1234567"] == [BLUE, GREEN, BLUE, GREEN, BLUE, GREEN, BLUE]  # as in any frame


def test_a_screw_is_drawn_along_its_way():
    way = rigid.exp_se3(np.linspace(0, 6, 30)[:, None] * np.array([0, 0, 1, 0, -0.5, 0.1]))
    figure = stored(figures.screw_motion(way, np.array([0.5, 0, 0]), np.array([0.0, 0, 1])))
    drawn = next(places(trace) for trace in figure["data"] if len(trace["x"]) == 30)
    np.testing.assert_allclose(drawn, way[:, :3, 3], atol=2e-3)


def test_plain_pictures_show_the_pairs_that_their_axes_name():
    path = np.random.default_rng(2).normal(size=(9, 3))
    projections, pairs = figures.plane_projections(path), figures.against_each_other({"a": path, "b": 2 * path})
    for fig, scale in ((projections, [1, 1, 1]), (pairs, [1, 1, 1, 2, 2, 2])):
        assert set(shown(fig).data) == {"image/png", "text/plain"}
        for ax, factor in zip(fig.axes, scale, strict=True):
            names = [label.split()[0][-1] for label in (ax.get_xlabel(), ax.get_ylabel())]
            line = ax.lines[0]
            for name, numbers in zip(names, (line.get_xdata(), line.get_ydata()), strict=True):
                np.testing.assert_allclose(numbers, factor * path[:, "xyz".index(name)])
