"""Pictures in space: their pieces, the subproblems' circles, rotations on the sphere, all with the right data."""

import numpy as np
import pytest
from helpers import places, stored
from numpy.testing import assert_allclose

from course_lib import subproblems
from course_lib.figures import rotations as nb1
from course_lib.figures import subproblems_damped_ik as figures
from course_lib.figures.solids.model import X_RED, Y_GREEN, Z_BLUE
from course_lib.figures.solids.scene import projected
from course_lib.figures.style import BLACK, BLUE, CRIMSON, GREEN, GREY, ORANGE
from course_lib.rotations import exp_so3, random_rotations

ROUNDED = 2e-3  # pictures keep thousandths
EZ, EX = np.eye(3)[[2, 0]]


def unit(v):
    return np.array(v) / np.linalg.norm(v)


K, P, G = unit([0.0, 0.6, 0.8]), np.array([1.2, 0.1, 0.2]), np.array([-0.6, 1.0, 1.1])
K1, K2, P1, P2 = unit([0.1, 0.2, 1]), unit([1, 0.1, 0.2]), unit([0.8, 0.6, 0.3]), unit([0.5, 0.3, -0.8])
MISS = EZ, EX, unit([0.5, 0.2, 1]), unit([1, 0.5, -0.1])
K3, P3, G3, D3 = unit([0.2, 0.1, 1.0]), np.array([1.0, 0.2, 0.3]), np.array([0.2, 0.9, 0.5]), 0.7
H, D4 = 2 * unit([-0.3, 0.8, 0.6]), 0.8  # not of length one
DRAWS = random_rotations(200, np.random.default_rng(0))
SHARE = np.linspace(0, 1, 21)[:, None]
STEADY = exp_so3(SHARE * [0.3, 1.2, -0.5])
TRACKS = {"steady": STEADY, "winding": STEADY @ exp_so3(np.sin(np.pi * SHARE) * [0, 0.2, 0.4])}


def traces(figure, colour, mode="lines"):
    """The positions of all traces of one colour and mode, in order."""
    looks = [(t, t.get("line") or t.get("marker") or t.get("textfont")) for t in figure["data"] if "mode" in t]
    return [places(trace) for trace, look in looks if trace["mode"] == mode and look["color"] == colour]


def named(figure):
    """The position of each label: {text: position}."""
    words = [trace for trace in figure["data"] if trace.get("mode") == "text"]
    return {word: place for trace in words for word, place in zip(trace["text"], places(trace), strict=True)}


def assert_circle(circle, k, p):
    """Assert that points run once about k on the circle of p."""
    heights, radii = circle @ k, np.linalg.norm(np.cross(circle, k), axis=-1)
    assert_allclose(heights, p @ k, atol=ROUNDED)
    assert_allclose(radii, np.linalg.norm(np.cross(p, k)), atol=ROUNDED)
    assert_allclose(circle[[0, -1]], [p, p], atol=ROUNDED)
    steps = np.linalg.norm(np.diff(circle, axis=0), axis=-1)
    assert steps.sum() == pytest.approx(2 * np.pi * radii[0], rel=5e-3)


def arrows(figure, count):
    """Start and tip (count, 2, 3) of the arrows of a figure: the points that close each."""
    (mesh,) = [t for t in figure["data"] if t["type"] == "mesh3d" and "intensity" in t]
    return places(mesh).reshape(count, -1, 3)[:, -2:]


def assert_axes(figure, *axes):
    """Assert that the arrows of a figure are these axes, each about the origin, with its tip where the axis points."""
    for arrow, k in zip(arrows(figure, len(axes)), axes, strict=True):
        assert_allclose(np.cross(arrow, k), 0, atol=ROUNDED)
        assert_allclose(arrow.sum(0), 0, atol=ROUNDED)
        assert arrow[1] @ k > 0


def assert_answers(figure, k, p):
    """Assert that the circle of p about k is drawn, with two answers on it, named 1 and 2; return these (2, 3)."""
    ((circle,), (answers,)) = traces(figure, BLUE), traces(figure, CRIMSON, "markers")
    assert_circle(circle, k, p)
    assert_allclose(answers @ k, 2 * [p @ k], atol=ROUNDED)
    assert_allclose(np.linalg.norm(answers, axis=-1), np.linalg.norm(p), atol=ROUNDED)
    assert np.linalg.norm(answers[0] - answers[1]) > 0.1
    assert set("12") < set(named(figure))
    return answers


# ---- subproblems ----


def test_subproblem_1_shows_the_circle_and_the_point_on_it_nearest_to_g():
    figure = stored(figures.rotated_onto(K, P, G, subproblems.subproblem1(K, P, G).theta))
    (circle,) = traces(figure, BLUE)
    assert_circle(circle, K, P)
    (dots,) = traces(figure, BLACK, "markers")
    assert_allclose(dots, [P, G], atol=ROUNDED)
    ((end,),) = traces(figure, CRIMSON, "markers")
    assert np.linalg.norm(end - G) <= np.linalg.norm(circle - G, axis=-1).min() + ROUNDED
    assert_allclose([end @ K, np.linalg.norm(end)], [P @ K, np.linalg.norm(P)], atol=ROUNDED)
    ((foot, p),), ((same_foot, tip),) = traces(figure, GREY), traces(figure, CRIMSON)
    assert_allclose([p, tip, foot], [P, end, same_foot], atol=ROUNDED)
    assert_allclose([(P - foot) @ K, *np.cross(foot, K)], 0, atol=ROUNDED)
    assert_axes(figure, K)
    assert set(named(figure)) == {"p", "g", "R p", "k"}


def test_subproblem_2_marks_where_the_circles_meet():
    figure = stored(figures.circles_meet(K1, K2, P1, P2, subproblems.subproblem2(K1, K2, P1, P2).theta))
    (first,), (second,) = traces(figure, BLUE), traces(figure, GREEN)
    assert_circle(first, K1, P1)
    assert_circle(second, K2, P2)
    meetings = np.array(traces(figure, CRIMSON, "markers"))
    assert meetings.shape == (2, 2, 3)
    assert_allclose(meetings[:, 0], meetings[:, 1], atol=ROUNDED)
    assert_allclose(meetings[:, 0] @ K1, P1 @ K1, atol=ROUNDED)
    assert_allclose(meetings[:, 0] @ K2, P2 @ K2, atol=ROUNDED)
    assert np.linalg.norm(meetings[0] - meetings[1]) > 0.1
    words, settings = named(figure), figure["layout"]["scene"]
    assert set(words) == {"p1", "p2", "k1", "k2", "1", "2"}
    lines = projected(np.concatenate([first, second]), settings)
    for name, dot in [("p1", P1), ("p2", P2), ("1", meetings[0, 0]), ("2", meetings[1, 0])]:
        (word,), (seen,) = projected([words[name]], settings), projected([dot], settings)
        assert 0.06 < np.linalg.norm(word - seen) < 0.25, "beside its dot, not under it"
        assert np.linalg.norm(lines - word, axis=1).min() > 0.04, "on no line"
    assert_axes(figure, K1, K2)


def test_subproblem_2_joins_the_nearest_points_of_circles_that_miss():
    figure = stored(figures.circles_meet(*MISS, subproblems.subproblem2(*MISS).theta[:1]))
    (first,), (second,) = traces(figure, BLUE), traces(figure, GREEN)
    ((a, b),) = traces(figure, CRIMSON, "markers")
    assert_allclose([a @ EZ, b @ EX], [MISS[2] @ EZ, MISS[3] @ EX], atol=ROUNDED)
    nearest = np.linalg.norm(first[:, None] - second, axis=-1).min()
    assert 0.1 < np.linalg.norm(a - b) <= nearest + ROUNDED
    assert_allclose(traces(figure, CRIMSON), [[a, b]])
    assert "1" not in named(figure), "a meeting that is none has no number"


def test_subproblem_3_shows_the_sphere_and_where_the_circle_pierces_it():
    figure = stored(figures.circle_and_sphere(K3, P3, G3, D3, subproblems.subproblem3(K3, P3, G3, D3).theta))
    (ball,) = [np.array([t[c] for c in "xyz"]) for t in figure["data"] if t["type"] == "surface"]
    assert_allclose(np.linalg.norm(ball - G3[:, None, None], axis=0), D3, atol=ROUNDED)
    assert_allclose(np.linalg.norm(assert_answers(figure, K3, P3) - G3, axis=-1), D3, atol=ROUNDED)
    words = named(figure)
    assert set(words) == {"p", "g", "k", "1", "2"}
    to_eye = figures.CAMERA / np.linalg.norm(figures.CAMERA)
    for word in "12":
        behind = np.linalg.norm(words[word] + np.linspace(0, 2, 200)[:, None] * to_eye - G3, axis=1) < D3
        assert not behind.any(), "the sphere hides no word"


def test_subproblem_4_shows_the_plane_and_where_the_circle_cuts_it():
    figure = stored(figures.circle_and_plane(K3, H, P3, D4, subproblems.subproblem4(K3, H, P3, D4).theta))
    (plane,) = [t for t in figure["data"] if t["type"] == "mesh3d" and "intensity" not in t]
    corners = places(plane)
    assert plane["color"] == ORANGE
    assert_allclose(corners @ H, D4, atol=ROUNDED)
    side = np.linalg.norm(corners[1] - corners[0])
    assert_allclose(np.linalg.norm(np.roll(corners, 1, 0) - corners, axis=-1), side, atol=ROUNDED)
    diagonals = np.linalg.norm(corners[2:] - corners[:2], axis=-1)
    assert_allclose(diagonals, np.sqrt(2) * side, atol=ROUNDED)
    assert side / 2 > np.linalg.norm(P3), "the circle ends inside the plane's edges"
    assert_allclose(assert_answers(figure, K3, P3) @ H, D4, atol=ROUNDED)
    assert_axes(figure, K3, H)
    assert set(named(figure)) == {"p", "k", "h", "1", "2"}


# ---- orientations ----


def test_orientations_on_the_sphere_follow_e_x():
    figure = stored(figures.orientation_paths(TRACKS, 2.0))
    for (name, R), colour in zip(TRACKS.items(), (BLUE, CRIMSON), strict=True):
        (track,) = traces(figure, colour)
        assert_allclose(track, R[:, :, 0], atol=ROUNDED)
        assert [t["name"] for t in figure["data"] if t.get("line", {}).get("color") == colour] == [name]
    assert [t["name"] for t in figure["data"] if t["showlegend"]] == list(TRACKS)
    (ends,) = traces(figure, BLACK, "markers")
    assert_allclose(ends, STEADY[[0, -1], :, 0], atol=ROUNDED)
    words = [named(figure)[name] for name in ("start", "end")]
    seen, beside = (projected(at, figure["layout"]["scene"]) for at in (ends, words))
    assert (np.linalg.norm(beside - seen, axis=1) < 0.35).all(), "each word is beside its end"


# ---- rotations ----


def test_the_sphere_shows_where_e_x_goes_and_which_way_e_y():
    drawn = nb1.on_sphere({"a": DRAWS}).fig.data
    dots = next(t for t in drawn if t.type == "scatter3d" and t.mode == "markers")
    assert_allclose(np.stack([dots.x, dots.y, dots.z], -1), DRAWS[:, :, 0], atol=1e-3)
    arrows = next(t for t in drawn if t.type == "scatter3d" and len(t.x) == 3 * len(DRAWS))
    ends = np.stack([arrows.x, arrows.y, arrows.z], -1).reshape(-1, 3, 3)
    assert_allclose(10 * (ends[:, 1] - ends[:, 0]), DRAWS[:, :, 1], atol=2e-2)


def test_the_rotated_point_is_drawn_by_the_function_it_is_given():
    still = nb1.rotated_point(np.array([0, 0, 1.0]), np.array([1.0, 0, 0.2]), lambda w: np.eye(3)).fig
    path = next(t for t in still.data if len(t.x) == 60)
    assert np.ptp(path.x) == np.ptp(path.y) == np.ptp(path.z) == 0


def test_the_arrows_of_the_body_frame_are_the_columns_of_its_matrix():
    fig = nb1.body_frame(DRAWS[0]).fig
    mesh = fig.data[0]
    corners = np.stack([mesh.x, mesh.y, mesh.z], -1)
    for colour, column in zip((X_RED, Y_GREEN, Z_BLUE), DRAWS[0].T, strict=True):
        arrow = corners[np.asarray(mesh.intensity) == colour]
        tip = arrow[np.linalg.norm(arrow, axis=1).argmax()]
        assert_allclose(tip / np.linalg.norm(tip), column, atol=1e-3)
    words = [word for trace in fig.data[1:] for word in trace.text]
    assert words == [f"{axis}<sub>{frame}</sub>" for frame in "ab" for axis in "xyz"]
