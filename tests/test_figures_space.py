"""Pictures in space: the subproblems' circles and rotations, all with the right data."""

import numpy as np
import pytest
from films import Film
from numpy.testing import assert_allclose

from course_lib import subproblems
from course_lib.lessons.rotations import figures as nb1
from course_lib.lessons.subproblems_damped_ik import figures
from course_lib.rotations import exp_so3, random_rotations

ROUNDED = 2e-3  # pictures keep tenths of a millimetre
EZ, EX = np.eye(3)[[2, 0]]


def unit(v):
    return np.array(v) / np.linalg.norm(v)


K, P, G = unit([0.0, 0.6, 0.8]), np.array([1.2, 0.1, 0.2]), np.array([-0.6, 1.0, 1.1])
K1, K2, P1, P2 = (
    unit([0.1, 0.2, 1]),
    unit([1, 0.1, 0.2]),
    unit([0.8, 0.6, 0.3]),
    unit([0.5, 0.3, -0.8]),
)
MISS = EZ, EX, unit([0.5, 0.2, 1]), unit([1, 0.5, -0.1])
K3, P3, G3, D3 = unit([0.2, 0.1, 1.0]), np.array([1.0, 0.2, 0.3]), np.array([0.2, 0.9, 0.5]), 0.7
H, D4 = 2 * unit([-0.3, 0.8, 0.6]), 0.8  # not of length one
DRAWS = random_rotations(200, np.random.default_rng(0))
SHARE = np.linspace(0, 1, 21)[:, None]
STEADY = exp_so3(SHARE * [0.3, 1.2, -0.5])
TRACKS = {"steady": STEADY, "winding": STEADY @ exp_so3(np.sin(np.pi * SHARE) * [0, 0.2, 0.4])}


def assert_circle(circle, k, p):
    """Assert that points run once about k on the circle of p."""
    heights, radii = circle @ k, np.linalg.norm(np.cross(circle, k), axis=-1)
    assert_allclose(heights, p @ k, atol=ROUNDED)
    assert_allclose(radii, np.linalg.norm(np.cross(p, k)), atol=ROUNDED)
    assert_allclose(circle[[0, -1]], [p, p], atol=ROUNDED)
    steps = np.linalg.norm(np.diff(circle, axis=0), axis=-1)
    assert steps.sum() == pytest.approx(2 * np.pi * radii[0], rel=5e-3)


def answers_of(film, k, p):
    """Assert that dots named 1 and 2 stand on the circle of p about k; return them (2, 3)."""
    (circle,) = film.paths
    assert_circle(circle, k, p)
    named = [film.words[word] for word in "12"]
    dots = np.array([circle[np.linalg.norm(circle - word, axis=1).argmin()] for word in named])
    assert np.linalg.norm(dots - named, axis=1).max() < 0.2, "each number is beside its dot"
    return dots


def test_subproblem_1_shows_the_point_of_the_circle_nearest_to_g():
    theta = subproblems.subproblem1(K, P, G).theta
    film, end = Film(figures.rotated_onto(K, P, G, theta)), exp_so3(theta * K) @ P
    circle = film.paths[0]
    assert_circle(circle, K, P)
    assert np.linalg.norm(end - G) <= np.linalg.norm(circle - G, axis=-1).min() + ROUNDED
    assert all(film.has_dot(point) for point in (P, G, end))
    assert not film.has_dot(P + 0.2)
    assert set(film.words) == {"p", "g", "R p", "k"}


def test_subproblem_2_marks_where_the_circles_meet():
    pairs = subproblems.subproblem2(K1, K2, P1, P2).theta
    film = Film(figures.circles_meet(K1, K2, P1, P2, pairs))
    assert_circle(film.paths[0], K1, P1)
    assert_circle(film.paths[1], K2, P2)
    meetings = np.array([exp_so3(t1 * K1) @ P1 for t1, _ in pairs])
    assert all(film.has_dot(point) for point in (P1, P2, *meetings))
    for name, dot in {"p1": P1, "p2": P2, "1": meetings[0], "2": meetings[1]}.items():
        assert np.linalg.norm(film.words[name] - dot) < 0.2
    assert set(film.words) == {"p1", "p2", "k1", "k2", "1", "2"}


def test_subproblem_2_joins_the_nearest_points_of_two_circles():
    film = Film(figures.circles_meet(*MISS, subproblems.subproblem2(*MISS).theta[:1]))
    first, second, (a, b) = film.paths
    assert_allclose([a @ EZ, b @ EX], [MISS[2] @ EZ, MISS[3] @ EX], atol=ROUNDED)
    nearest = np.linalg.norm(first[:, None] - second, axis=-1).min()
    assert 0.1 < np.linalg.norm(a - b) <= nearest + ROUNDED
    assert film.has_dot(a)
    assert film.has_dot(b)
    assert "1" not in film.words, "a meeting that is none has no number"


def test_subproblem_3_shows_where_the_circle_pierces_the_sphere():
    theta = subproblems.subproblem3(K3, P3, G3, D3).theta
    film = Film(figures.circle_and_sphere(K3, P3, G3, D3, theta))
    assert_allclose(np.linalg.norm(film.pale()[:-2] - G3, axis=1), D3, atol=ROUNDED)
    assert_allclose(np.linalg.norm(answers_of(film, K3, P3) - G3, axis=-1), D3, atol=0.06)
    assert all(film.has_dot(exp_so3(t * K3) @ P3) for t in theta)
    assert set(film.words) == {"p", "g", "k", "1", "2"}


def test_subproblem_4_shows_where_the_circle_cuts_the_plane():
    theta = subproblems.subproblem4(K3, H, P3, D4).theta
    film = Film(figures.circle_and_plane(K3, H, P3, D4, theta))
    assert_allclose(film.pale() @ H, D4, atol=ROUNDED)
    assert_allclose(answers_of(film, K3, P3) @ H, D4, atol=0.1)
    assert all(film.has_dot(exp_so3(t * K3) @ P3) for t in theta)
    assert set(film.words) == {"p", "k", "h", "1", "2"}


def test_orientations_on_the_sphere_follow_e_x():
    film = Film(figures.orientation_paths(TRACKS, 2.0))
    for track, R in zip(film.paths, TRACKS.values(), strict=True):
        assert_allclose(track, 1.005 * R[:, :, 0], atol=ROUNDED)
    for name, at in {"start": STEADY[0, :, 0], "end": STEADY[-1, :, 0]}.items():
        assert film.has_dot(at)
        assert np.linalg.norm(film.words[name] - at) < 0.2
    assert set(TRACKS) < set(film.words)


def test_the_arrows_of_a_frame_are_the_columns_of_its_matrix():
    film = Film(nb1.body_frame(DRAWS[0]))
    for column in DRAWS[0].T:
        assert np.linalg.norm(film.at(0) - 1.15 * column, axis=1).min() < ROUNDED
    assert [word for word, *_ in film.course["words"]] == list("xyzxyz")


def test_orientations_beside_each_other_are_drawn_to_one_scale():
    longer = 4 * DRAWS[1]
    film = Film(nb1.frames({"a": DRAWS[0], "b": longer}))
    scale, vertices, apart = 2.4 / 4, film.at(0), film.poses[0, :, :3, 3]
    for column, middle in [
        *zip(DRAWS[0].T, apart[[0, 0, 0]], strict=True),
        *zip(longer.T, apart[[1] * 3], strict=True),
    ]:
        assert np.linalg.norm(vertices - middle - scale * column, axis=1).min() < ROUNDED
    assert np.linalg.norm(apart[1] - apart[0]) > 2 * 2.4 - 0.2, "they do not touch"
