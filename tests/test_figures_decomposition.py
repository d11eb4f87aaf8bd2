"""The pictures of notebook 6 show the arm, the samples, the clusters, the errors and the costs that they are given."""

import numpy as np

from course_lib.figures import decomposition_ik as figures
from course_lib.figures.style import COLOURS


def offsets(ax):
    """The positions of the dots of every scatter plot in a panel."""
    return [np.asarray(dots.get_offsets()) for dots in ax.collections]


def test_both_arms_connect_the_base_to_the_position():
    solutions = np.array([[0.0, np.pi / 2], [np.pi / 2, -np.pi / 2]])
    fig = figures.two_elbows(solutions, np.array([1.0, 1.0])).fig
    for line, elbow in zip(fig.axes[0].lines, ([1, 0], [0, 1]), strict=False):
        np.testing.assert_allclose(line.get_xydata(), [[0, 0], elbow, [1, 1]], atol=1e-12)
    assert len({line.get_linestyle() for line in fig.axes[0].lines[:2]}) == 2  # told apart without colour


def test_samples_are_drawn_twice_and_neighbouring_cells_differ():
    column, row = np.meshgrid(range(4), range(4))
    cell = np.stack([column.ravel(), row.ravel()], -1)
    xy = (cell + 0.5) / 4
    fig = figures.samples(xy, cell, np.zeros(2), np.ones(2), 4).fig
    for ax in fig.axes:
        np.testing.assert_allclose(offsets(ax)[0], xy)
    colour = fig.axes[1].collections[0].get_facecolors().reshape(4, 4, 4)  # row, column
    assert (colour[1:] != colour[:-1]).any(-1).all()
    assert (colour[:, 1:] != colour[:, :-1]).any(-1).all()
    lines = sorted({round(float(line.get_xdata()[0]), 6) for line in fig.axes[1].lines if line.get_xdata()[0] <= 1})
    assert lines == [0, 0.25, 0.5, 0.75, 1]


def test_each_cluster_has_its_marker_at_each_of_its_samples():
    q, labels = np.deg2rad([[10, 20], [30, -40], [50, 60.0]]), np.array([0, 1, 0])
    fig = figures.clusters({"one": (q, labels), "two": (-q, 1 - labels)}).fig
    assert [ax.get_title() for ax in fig.axes] == ["one", "two"]
    np.testing.assert_allclose(offsets(fig.axes[0])[0], [[10, 20], [50, 60]])
    np.testing.assert_allclose(offsets(fig.axes[0])[1], [[30, -40]])
    np.testing.assert_allclose(offsets(fig.axes[1])[0], [[-30, 40]])


def test_larger_errors_are_larger_and_darker_and_the_better_answer_is_separated_from_the_worse():
    xy, off = np.array([[0.0, 1.0], [1.0, 1.0], [2.0, 0.0]]), np.array([[0.1, 12], [0.3, 0.2], [0.5, np.nan]])
    axes = figures.errors_of_both(xy, off).fig.axes
    for ax, error in zip(axes, ([0.1, 0.2], [12, 0.3]), strict=False):
        (dots,) = ax.collections
        np.testing.assert_allclose(dots.get_offsets(), xy[:2])
        np.testing.assert_allclose(dots.get_array(), np.minimum(error, 10))
        assert (np.sign(np.diff(dots.get_sizes())) == np.sign(np.diff(error))).all()
    assert axes[-1].get_ylabel() == "error (cm)"


def test_costs_are_plotted_at_memory_and_error_with_their_names():
    table = {
        "table": {"bytes": 240000, "mean_error": 2e-3, "seconds": 1.6e-7},
        "formula": {"bytes": 16, "mean_error": 2e-16, "seconds": 1e-7},
    }
    (ax,) = figures.costs(table).fig.axes
    assert [tuple(line.get_xydata()[0]) for line in ax.lines] == [(240000, 2e-3), (16, 2e-16)]
    assert [text.get_text() for text in ax.texts] == ["table", "formula"]
    assert (ax.get_xscale(), ax.get_yscale()) == ("log", "log")
    assert len({line.get_color() for line in ax.lines}) == 2
    assert ax.lines[0].get_color() == COLOURS[0]
