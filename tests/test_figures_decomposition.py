"""The pictures of notebook 6 show the arm, the samples, the clusters, the errors and the costs that they are given."""

import numpy as np
from helpers import shown

from course_lib.figures import decomposition_ik as figures
from course_lib.figures.style import COLOURS


def png_only(fig):
    return set(shown(fig).data) == {"image/png", "text/plain"}


def offsets(ax):
    """The places of the dots of every scatter of a panel."""
    return [np.asarray(dots.get_offsets()) for dots in ax.collections]


def test_both_postures_lead_from_the_base_to_the_place():
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


def test_each_cluster_has_its_marker_and_stands_where_its_samples_are():
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


def test_costs_stand_where_memory_and_error_are_with_their_time():
    table = {
        "table": {"bytes": 240000, "mean_error": 2e-3, "seconds": 1.6e-7},
        "formula": {"bytes": 16, "mean_error": 2e-16, "seconds": 1e-7},
    }
    (ax,) = figures.costs(table).axes
    assert [tuple(line.get_xydata()[0]) for line in ax.lines] == [(240000, 2e-3), (16, 2e-16)]
    assert [text.get_text() for text in ax.texts] == ["table\n0.16 µs a query", "formula\n0.1 µs a query"]
    assert (ax.get_xscale(), ax.get_yscale()) == ("log", "log")
    assert len({line.get_color() for line in ax.lines}) == 2
    assert ax.lines[0].get_color() == COLOURS[0]
