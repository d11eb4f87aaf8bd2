"""Sections of More in notebooks 1 to 3: their numbers by a second computation."""

from functools import cache
from itertools import pairwise
from pathlib import Path

import nbformat
import numpy as np
import pytest
from scipy.optimize import linprog
from scipy.spatial.transform import Rotation

from course_lib import arms, ik, rotations
from course_lib.ik import damped_path
from course_lib.lessons.subproblems_damped_ik.exercises import six_axis_arm

NOTEBOOKS = Path(__file__).parent.parent / "notebooks"


@cache
def source_of(notebook, cell_id):
    """The source of a cell, and what it printed."""
    cells = nbformat.read(NOTEBOOKS / f"{notebook}.ipynb", 4).cells
    (cell,) = [cell for cell in cells if cell.id == cell_id]
    return cell.source, "".join(output.get("text", "") for output in cell.outputs)


def functions_of(notebook, cell_id, **names):
    """What a cell defines, given the names that earlier cells define."""
    space = {"np": np, **names}
    exec(source_of(notebook, cell_id)[0], space)
    return space


# ---- notebook 1: distances between rotations ----


def distances(first, second):
    defined = functions_of("01_rotations", "distance-code", rotations=rotations)
    return defined["distances"](first.as_matrix(), second.as_matrix())


def pairs():
    draw = np.random.default_rng(20)
    return Rotation.random(200, rng=draw), Rotation.random(200, rng=draw)


def test_the_angle_is_that_of_scipy():
    first, second = pairs()
    np.testing.assert_allclose(
        distances(first, second)[1], (first.inv() * second).magnitude(), atol=1e-9
    )


def test_the_difference_of_euler_angles_is_that_of_scipys_angles():
    first, second = pairs()
    change = second.as_euler("ZYX") - first.as_euler("ZYX")  # yaw, pitch, roll
    shorter = np.angle(np.exp(1j * change))
    np.testing.assert_allclose(
        distances(first, second)[0], np.linalg.norm(shorter, axis=1), atol=1e-7
    )


def test_the_quaternion_distance_follows_from_the_trace():
    first, second = pairs()
    cosine = (np.trace((first.inv() * second).as_matrix(), axis1=1, axis2=2) - 1) / 2
    half_angle_cosine = np.sqrt((1 + cosine) / 2)
    np.testing.assert_allclose(distances(first, second)[2], 1 - half_angle_cosine, atol=1e-9)


# ---- notebook 2: trapezoidal profile and blends ----


def trapezoid(*arguments):
    return functions_of("02_rigid_motion", "limits-trapezoid-code")["trapezoid"](*arguments)


@pytest.mark.parametrize(("D", "V", "A"), [(6, 2, 1), (2, 2, 1), (4, 2, 1), (0.3, 5, 7)])
def test_the_profile_is_the_integral_of_its_acceleration(D, V, A):
    T = trapezoid(0.0, D, V, A)[-1]
    t = np.linspace(0, T, 20001)
    s, v, a, _ = trapezoid(t, D, V, A)
    speed = np.append(0, np.cumsum((a[1:] + a[:-1]) / 2 * np.diff(t)))
    distance = np.append(0, np.cumsum((v[1:] + v[:-1]) / 2 * np.diff(t)))
    np.testing.assert_allclose(speed, v, atol=3e-4 * V)
    np.testing.assert_allclose(distance, s, atol=1e-6 * D)
    assert np.isclose(s[-1], D)


def farthest(T, V, A, steps=400):
    """How far a body with these limits gets in the time T, at rest in the end: a linear program."""
    h = T / steps
    # The speeds at steps + 1 times; the distance is the sum of their means over each step.
    weights = np.full(steps + 1, h)
    weights[[0, -1]] = h / 2
    differences = np.diff(np.eye(steps + 1), axis=0)
    bounds = [(0, 0), *[(0, V)] * (steps - 1), (0, 0)]
    limits = np.full(2 * steps, A * h)
    solved = linprog(-weights, np.vstack([differences, -differences]), limits, bounds=bounds)
    return -solved.fun


@pytest.mark.parametrize(("D", "V", "A"), [(6.0, 2.0, 1.0), (2.0, 2.0, 1.0)])
def test_no_motion_within_the_limits_is_faster_than_the_profile(D, V, A):
    T = trapezoid(0.0, D, V, A)[-1]
    assert farthest(T, V, A) == pytest.approx(D, rel=1e-4)
    assert farthest(0.99 * T, V, A) < 0.995 * D


def test_a_blend_is_the_integral_of_a_constant_acceleration():
    blended = functions_of("02_rigid_motion", "limits-blend-code")["blended"]
    times, points, tau = np.array([0.0, 2, 3.5]), np.array([[0.0, 0], [3, 1], [1, 4]]), 0.8
    before, after = np.diff(points, axis=0) / np.diff(times)[:, None]
    t = np.linspace(0, 3.5, 35001)
    share = np.clip((t - (2 - tau / 2)) / tau, 0, 1)[:, None]  # of the change of the velocity
    velocity = before + share * (after - before)
    middle = (velocity[1:] + velocity[:-1]) / 2
    path = points[0] + np.append([[0, 0]], np.cumsum(middle * (t[1] - t[0]), axis=0), axis=0)
    np.testing.assert_allclose(blended(t, times, points, tau), path, atol=1e-6)


# ---- notebook 3: one of the eight, and what the report says of its runs ----

LIMITS = np.array(  # rad, and rad/s below: from abb_irb120_support, irb120_3_58_macro.xacro
    [
        [-2.87979, 2.87979],
        [-1.91986, 1.91986],
        [-1.91986, 1.22173],
        [-2.79253, 2.79253],
        [-2.094395, 2.094395],
        [-6.98132, 6.98132],
    ]
)
SPEEDS = np.array([4.36332, 4.36332, 4.36332, 5.58505, 5.58505, 7.33038])


def choice():
    def solve_arm(T):
        return six_axis_arm.all_solutions(T)

    return functions_of("03_subproblems_damped_ik", "choice-code", solve_arm=solve_arm)


def test_limits_and_speeds_are_those_of_the_source():
    np.testing.assert_allclose(choice()["LIMITS"], LIMITS, atol=1e-5)
    np.testing.assert_allclose(choice()["SPEEDS"], SPEEDS, atol=1e-5)


def test_iterations_from_many_starts_find_the_same_candidates():
    """A second way: damped steps from 400 random starts, within the limits of the arm."""
    arm = arms.SerialArm.from_screws(
        six_axis_arm.ARM.screw_axes[:, :3],
        points_on(six_axis_arm.ARM.screw_axes),
        six_axis_arm.HOME,
        limits=LIMITS,
    )
    generator = np.random.default_rng(3)
    T = arm.fk(np.array([0.3, 0.4, -0.5, 0.6, 0.7, -0.8]))
    starts = generator.uniform(*LIMITS.T, (400, 6))
    answer = ik.solve(arm, np.tile(T, (400, 1, 1)), generator, q0=starts)
    reached = answer.q[answer.success]
    inside = ((LIMITS[:, 0] <= reached) & (reached <= LIMITS[:, 1])).all(axis=1)
    different = np.unique(reached[inside].round(2), axis=0)
    candidates = choice()["candidates"](T)
    assert len(candidates) == len(different) == 9
    for q in candidates:
        assert np.abs(different - q).max(axis=1).min() < 0.02


def points_on(screw_axes):
    """A point on each axis: omega x v."""
    return np.cross(screw_axes[:, :3], screw_axes[:, 3:])


def test_a_motion_takes_as_long_as_its_slowest_joint():
    q_now, q = np.zeros(6), np.array([0.5, 0, 0, -1.0, 0, 1.2])
    speeds = (q - q_now) / choice()["seconds"](q, q_now)
    assert (np.abs(speeds) <= SPEEDS + 1e-5).all()
    assert np.isclose(np.abs(speeds / SPEEDS).max(), 1, atol=1e-5)


PLANAR, START = arms.planar_arm([1, 1, 1, 1]), np.array([0, 0, 0, np.pi / 2])
GOAL = np.array([-1.8663, 1.1207])


def points_of(q):
    return PLANAR.frames(q)[..., :2, 3]


@pytest.mark.parametrize(("eps", "printed"), [(0.5, 6.3), (8, 7.6), (50, 7.8)])
def test_the_area_that_the_arm_passes_over_is_that_of_random_points(eps, printed):
    """A second way: the share of random points of a square that a link crosses in some step."""
    path = damped_path(PLANAR, GOAL, START, 0.2, eps, 2000)
    covered = np.append(0, np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1)))
    even = np.arange(0, covered[-1], 0.01)  # rad, so that chords stand for arcs
    points = points_of(np.stack([np.interp(even, covered, q) for q in path.T], -1))
    asked = np.random.default_rng(1).uniform(-4, 4, (4000, 2))
    crossed = np.zeros(len(asked), bool)
    for now, later in pairwise(points):
        for i in range(4):
            corners = np.array([now[i], now[i + 1], later[i + 1], later[i]])
            sides = np.roll(corners, -1, axis=0) - corners
            to = asked[:, None] - corners
            left_of = sides[:, 0] * to[..., 1] - sides[:, 1] * to[..., 0]
            crossed |= (left_of >= 0).all(axis=1) | (left_of <= 0).all(axis=1)
    assert 64 * crossed.mean() == pytest.approx(printed, rel=0.06)
    assert f"{eps:4} m^2: {printed:.1f} m^2" in source_of(
        "03_subproblems_damped_ik", "claims-area"
    )[1].replace("eps = ", "")


def test_a_least_squares_fit_by_powers_needs_the_same_orders():
    """A second way, with powers of the distance instead of Chebyshev's polynomials."""
    printed = source_of("03_subproblems_damped_ik", "error-order-run")[1]
    for eps in (0.5, 2, 8, 50):
        tips = points_of(damped_path(PLANAR, GOAL, START, 0.2, eps, 3000))[:, -1]
        covered = np.append(0, np.cumsum(np.linalg.norm(np.diff(tips, axis=0), axis=1)))
        u = np.linspace(0, 1, 400)
        even = np.stack([np.interp(u * covered[-1], covered, x) for x in tips.T], -1)
        orders = [order_by_powers(u, even, tolerance) for tolerance in (0.05, 0.02, 0.01)]
        assert f"eps = {eps:4} m^2: orders {orders}" in printed


def order_by_powers(u, even, tolerance):
    for order in range(1, 15):
        Q, _ = np.linalg.qr(np.vander(u, order + 1, increasing=True))
        if np.linalg.norm(Q @ (Q.T @ even) - even, axis=1).max() < tolerance:
            return order
    return None
