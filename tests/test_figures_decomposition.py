"""The pictures of notebook 6 show the arm, the samples, the clusters, the errors and the costs that they are given."""

import numpy as np
from helpers import shown

from course_lib.figures import decomposition_ik as figures
from course_lib.figures import decomposition_pictures as pictures
from course_lib.figures.style import COLOURS


def png_only(fig):
    return set(shown(fig).data) == {"image/png", "text/plain"}


def offsets(ax):
    """The positions of the dots of every scatter plot in a panel."""
    return [np.asarray(dots.get_offsets()) for dots in ax.collections]


def test_both_arms_connect_the_base_to_the_position():
    solutions = np.array([[0.0, np.pi / 2], [np.pi / 2, -np.pi / 2]])
    fig = figures.two_elbows(solutions, np.array([1.0, 1.0]))
    for line, elbow in zip(fig.axes[0].lines, ([1, 0], [0, 1]), strict=False):
        np.testing.assert_allclose(line.get_xydata(), [[0, 0], elbow, [1, 1]], atol=1e-12)
    assert len({line.get_linestyle() for line in fig.axes[0].lines[:2]}) == 2  # told apart without colour
    assert png_only(fig)


def test_samples_are_drawn_twice_and_neighbouring_cells_differ():
    column, row = np.meshgrid(range(4), range(4))
    cell = np.stack([column.ravel(), row.ravel()], -1)
    xy = (cell + 0.5) / 4
    fig = figures.samples(xy, cell, np.zeros(2), np.ones(2), 4)
    for ax in fig.axes:
        np.testing.assert_allclose(offsets(ax)[0], xy)
    colour = fig.axes[1].collections[0].get_facecolors().reshape(4, 4, 4)  # row, column
    assert (colour[1:] != colour[:-1]).any(-1).all()
    assert (colour[:, 1:] != colour[:, :-1]).any(-1).all()
    lines = sorted({round(float(line.get_xdata()[0]), 6) for line in fig.axes[1].lines if line.get_xdata()[0] <= 1})
    assert lines == [0, 0.25, 0.5, 0.75, 1]


def test_each_cluster_has_its_marker_at_each_of_its_samples():
    q, labels = np.deg2rad([[10, 20], [30, -40], [50, 60.0]]), np.array([0, 1, 0])
    fig = figures.clusters({"one": (q, labels), "two": (-q, 1 - labels)})
    assert [ax.get_title() for ax in fig.axes] == ["one", "two"]
    np.testing.assert_allclose(offsets(fig.axes[0])[0], [[10, 20], [50, 60]])
    np.testing.assert_allclose(offsets(fig.axes[0])[1], [[30, -40]])
    np.testing.assert_allclose(offsets(fig.axes[1])[0], [[-30, 40]])
    assert png_only(fig)


def test_larger_errors_are_larger_and_darker():
    xy, error = np.array([[0, 0], [1, 0], [1, 2.0]]), np.array([0.01, 0.5, 8.0])
    fig = figures.errors(xy, {"better": error, "both": 2 * error})
    for ax, factor in zip(fig.axes, (1, 2), strict=False):
        (dots,) = ax.collections
        np.testing.assert_allclose(dots.get_offsets(), xy)
        np.testing.assert_allclose(dots.get_array(), np.minimum(factor * error, 10))
        assert (np.diff(dots.get_sizes()) > 0).all()
    assert fig.axes[-1].get_ylabel() == "error (cm)"
    assert png_only(fig)


def test_costs_are_plotted_at_memory_and_error_with_their_names():
    table = {
        "table": {"bytes": 240000, "mean_error": 2e-3, "seconds": 1.6e-7},
        "formula": {"bytes": 16, "mean_error": 2e-16, "seconds": 1e-7},
    }
    (ax,) = figures.costs(table).axes
    assert [tuple(line.get_xydata()[0]) for line in ax.lines] == [(240000, 2e-3), (16, 2e-16)]
    assert [text.get_text() for text in ax.texts] == ["table", "formula"]
    assert (ax.get_xscale(), ax.get_yscale()) == ("log", "log")
    assert len({line.get_color() for line in ax.lines}) == 2
    assert ax.lines[0].get_color() == COLOURS[0]


def test_the_text_on_two_elbows_reports_whether_the_tips_reach_the_position():
    q = np.array([[0.0, np.pi / 2], [np.pi / 2, -np.pi / 2]])
    assert pictures.two_elbows(q, np.array([1.0, 1.0]))["caption"] == "Both elbows lead to the same position."
    assert "miss it by 10.0 and 10.0 cm" in pictures.two_elbows(q, np.array([1.0, 1.1]))["caption"]


def test_the_text_on_a_curve_gives_its_largest_value():
    alt = pictures.by_bend(np.array([0, 2, 10, 90]), np.array([0.1, 0.3, 0.02]))["alt"]
    assert "largest, 0.30 cm, between 2 and 10 degrees" in alt


def test_each_picture_has_alternative_text_and_a_caption():
    xy, share = np.array([[0.0, 1.0], [1.0, 1.0]]), np.linspace(5, 100, 5)
    cost = {"bytes": 240000, "mean_error": 2e-3, "seconds": 1.6e-7}
    made = [
        pictures.samples(xy, np.array([[0, 0], [1, 1]]), xy.min(0), xy.max(0) + 1, 2),
        pictures.clusters({"one": (xy, np.array([0, 1]))}),
        pictures.percentiles({"box": share / 100}),
        pictures.errors_in_the_report(xy, np.array([0.1, 2.0])),
        pictures.convergence(np.array([0.2, 0.1]), {"affine": np.array([0.04, 0.01])}, {"affine": 2.0}),
        pictures.costs({"table": cost}),
    ]
    assert all(picture["caption"].endswith(".") and len(picture["alt"]) > 60 for picture in made)
    assert "the largest 2.0 at (1.0, 1.0) m" in made[3]["alt"]
    assert "240,000 bytes, 2e-03 m, 0.16 µs" in made[5]["alt"]


def test_the_better_and_the_worse_answer_are_separated_if_there_are_both():
    xy, off = np.array([[0.0, 1.0], [1.0, 1.0], [2.0, 0.0]]), np.array([[0.1, 0.4], [0.3, 0.2], [0.5, np.nan]])
    picture = pictures.errors_of_both(xy, off)
    better, worse = (ax.collections[0].get_array() for ax in picture["fig"].axes[:2])
    np.testing.assert_allclose([better, worse], [[0.1, 0.2], [0.4, 0.3]])
    assert "of 2 queries" in picture["alt"]


def test_percentiles_ignore_queries_without_an_answer():
    alt = pictures.percentiles({"all": np.array([[1.0, 3.0], [2.0, np.nan]])})["alt"]
    assert "half below 2, all below 3" in alt
