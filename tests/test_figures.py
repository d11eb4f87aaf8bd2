"""show() and the pictures: words for every picture, numbers that do not depend on the machine, and the right data."""

import json
from unittest import mock

import numpy as np
import pytest
from helpers import ALT, FIGURE, assert_in_scene, shown, stored
from matplotlib.figure import Figure

from course_lib import rotations
from course_lib.figures import lines, show
from course_lib.figures import rotations as figures
from course_lib.figures.solids.model import X_RED, Y_GREEN, Z_BLUE


@pytest.fixture(scope="module")
def draws():
    return rotations.random_rotations(200, np.random.default_rng(0))


@pytest.fixture(scope="module")
def plain_outputs(draws):
    return [shown(fig) for fig in plain_figures(draws)]


@pytest.fixture(scope="module")
def space_outputs(draws):
    return [shown(fig) for fig in space_figures(draws)]


def plain_figures(R):
    return [
        figures.angle_histogram({"a": R, "b": R}),
        figures.height_histogram({"a": R}),
        figures.nearest_on_circle(np.array([[0.3, 0.9], [0.8, 0.1]]), {"one": np.eye(2)}),
        lines([1, 2], {"a": [1, 2], "b": [2, 3]}, xlabel="time (s)", ylabel="angle (rad)", log="xy"),
    ]


def space_figures(R):
    return [
        figures.rotations_on_sphere({"a": R, "b": R}),
        figures.frames({"a": R[0]}),
        figures.body_frame(R[0]),
        figures.rotated_point(np.array([0, 0, 1.0]), np.array([1.0, 0, 0.2])),
    ]


@pytest.mark.parametrize("alt", ["", "short", None, 3])
def test_a_picture_without_words_is_refused(alt):
    with pytest.raises(ValueError, match="alt must say"):
        show(Figure(), alt=alt)


def test_a_caption_follows_its_figure_as_an_output_of_its_own(draws):
    words = "It rises by $\\pi$."
    with mock.patch("IPython.display.display") as display:
        show(plain_figures(draws)[0], alt=ALT, caption=words)
    (_, figure), (_, caption) = ((*call.args, call.kwargs["metadata"]) for call in display.call_args_list)
    assert "caption" not in figure
    assert caption == {"caption": words}
    assert display.call_args.args == ({"text/markdown": words, "text/plain": words},)
    with pytest.raises(ValueError, match="caption must be a sentence"):
        show(Figure(), alt=ALT, caption=3)


def test_something_that_is_no_figure_is_refused():
    with pytest.raises(ValueError, match="fig must be a matplotlib or plotly figure; it is of type list"):
        show([1, 2], alt=ALT)


def test_every_picture_carries_its_words(plain_outputs, space_outputs):
    for output in plain_outputs + space_outputs:
        assert output.data["text/plain"] == ALT
        assert output.metadata["image/png"]["alt"] == ALT


def test_students_get_plotly_alone_and_matplotlib_as_png(plain_outputs, space_outputs):
    assert all(set(output.data) == {"image/png", "text/plain"} for output in plain_outputs)
    assert all(set(output.data) == {FIGURE, "text/plain"} for output in space_outputs)


def test_plain_pictures_have_the_same_bytes_again(draws, plain_outputs):
    for fig, output in zip(plain_figures(draws), plain_outputs, strict=True):
        assert shown(fig).data["image/png"] == output.data["image/png"]


def test_plain_pictures_do_not_name_the_version_that_drew_them():
    assert b"Software" not in shown(Figure()).data["image/png"]


def test_plain_pictures_name_every_axis(draws):
    for fig in plain_figures(draws):
        axes = fig.axes
        assert all(ax.get_xlabel() for ax in axes)
        assert axes[0].get_ylabel()


def test_numbers_are_rounded_and_zero_has_no_sign():
    import plotly.graph_objects as go

    noisy = [1.0, -0.0, 1 / 3, 1e-17, -1e-17, float("nan")]
    fig = go.Figure(go.Scatter(x=np.array(noisy), y=[1, 2, 3, 4, 5, 6], marker={"size": 1 / 3}))
    (trace,) = stored(fig)["data"]
    assert json.dumps(trace["x"]) == "[1.0, 0.0, 0.33333, 0.0, 0.0, null]"
    assert trace["y"] == [1, 2, 3, 4, 5, 6]
    assert trace["marker"]["size"] == 0.333333


def test_the_last_bits_of_a_machine_do_not_reach_the_file(draws):
    shaken = draws * (1 + 1e-15)
    for one, two in zip(space_figures(draws), space_figures(shaken), strict=True):
        assert json.dumps(stored(one)) == json.dumps(stored(two))


def test_nothing_lies_outside_its_scene(draws):
    for fig in space_figures(draws):
        assert_in_scene(stored(fig))


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_the_sphere_shows_where_the_axis_goes_and_which_way_the_next_one_went(draws, axis):
    fig = figures.rotations_on_sphere({"a": draws}, axis=axis)
    dots = next(t for t in fig.data if t.type == "scatter3d" and t.mode == "markers")
    feet = np.stack([dots.x, dots.y, dots.z], -1)
    np.testing.assert_allclose(feet, draws @ np.eye(3)[axis], atol=1e-3)
    arrows = next(t for t in fig.data if t.type == "scatter3d" and len(t.x) == 3 * len(draws))
    ends = np.stack([arrows.x, arrows.y, arrows.z], -1).reshape(-1, 3, 3)
    np.testing.assert_allclose(10 * (ends[:, 1] - ends[:, 0]), draws @ np.eye(3)[(axis + 1) % 3], atol=2e-2)


def test_the_histogram_is_a_density_of_the_angle(draws):
    (ax,) = figures.angle_histogram({"a": draws}).axes
    assert sum(bar.get_width() * bar.get_height() for bar in ax.patches) == pytest.approx(1)
    angles = np.linalg.norm(rotations.log_so3(draws), axis=-1)
    first = ax.patches[15]
    inside = (angles >= first.get_x()) & (angles < first.get_x() + first.get_width())
    assert first.get_height() == pytest.approx(inside.mean() / first.get_width())


def test_the_nearest_rotation_sits_at_the_bottom_of_the_curve():
    M = np.array([[0.3, 0.9], [0.8, 0.1]])
    fig = figures.nearest_on_circle(M, {"nearest": rotations.nearest_so(M)})
    marked, curve = fig.axes[1].lines
    assert marked.get_ydata()[0] == pytest.approx(min(curve.get_ydata()), abs=1e-9)


def test_the_rotated_point_is_drawn_by_the_function_it_is_given():
    still = figures.rotated_point(np.array([0, 0, 1.0]), np.array([1.0, 0, 0.2]), lambda w: np.eye(3))
    way = next(t for t in still.data if len(t.x) == 60)
    assert np.ptp(way.x) == np.ptp(way.y) == np.ptp(way.z) == 0


def test_the_arrows_of_the_body_frame_are_the_columns_of_its_matrix(draws):
    fig = figures.body_frame(draws[0])
    mesh = fig.data[0]
    corners = np.stack([mesh.x, mesh.y, mesh.z], -1)
    for colour, column in zip((X_RED, Y_GREEN, Z_BLUE), draws[0].T, strict=True):
        arrow = corners[np.asarray(mesh.intensity) == colour]
        tip = arrow[np.linalg.norm(arrow, axis=1).argmax()]
        np.testing.assert_allclose(tip / np.linalg.norm(tip), column, atol=1e-3)
    words = [word for trace in fig.data[1:] for word in trace.text]
    assert words == [f"{axis}<sub>{frame}</sub>" for frame in "ab" for axis in "xyz"]
