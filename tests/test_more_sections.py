"""Sections of More in notebooks 1 to 5: their numbers by a second computation."""

import re
from functools import cache
from itertools import pairwise
from pathlib import Path

import nbformat
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import linprog
from scipy.spatial.transform import Rotation

from course_lib import arms, ik, rotations
from course_lib.ik import damped_path
from course_lib.lessons.panda_dh_ik.exercises.shared import READY
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
def test_the_swept_area_is_that_of_random_points(eps, printed):
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


# ---- notebook 4: the workspace of the UR5e, and its manipulability ----

UR5E = arms.ur5e()


def gripper_down(r, z):
    names = {"fk": lambda screws, M, q: UR5E.fk(q), "own_screws": None, "own_M": None}
    return functions_of("04_poe_kuka_iiwa", "workspace-ik", **names)["gripper_down"](r, z)


def solved_by_iteration(r, z, count=60):
    """The configurations with the flange down at (r, 0, z), from random starts."""
    T = np.array([[1.0, 0, 0, r], [0, -1, 0, 0], [0, 0, -1, z], [0, 0, 0, 1]])
    generator = np.random.default_rng(4)
    starts = generator.uniform(-np.pi, np.pi, (count, 6))
    answer = ik.solve(UR5E, np.tile(T, (count, 1, 1)), generator, q0=starts)
    return answer.q[answer.success]


def differences(arm, q, h=1e-6):
    """The geometric Jacobian (6, n), (v, omega), by central differences of the pose."""
    columns = []
    for step in h * np.eye(len(q)):
        before, after = arm.fk(q - step), arm.fk(q + step)
        omega = Rotation.from_matrix(after[:3, :3] @ before[:3, :3].T).as_rotvec()
        columns.append(np.append((after - before)[:3, 3], omega) / (2 * h))
    return np.transpose(columns)


@pytest.mark.parametrize(("r", "z"), [(0.6, 0.2), (0.3, 0.4), (0.77, 0.0)])
def test_iteration_finds_the_exact_manipulabilities(r, z):
    found = [np.linalg.svd(differences(UR5E, q))[1].prod() for q in solved_by_iteration(r, z)]
    s3 = np.sin(gripper_down(r, z)[:, 2])
    formula = 0.425 * 0.3922 * np.abs(s3) * np.sqrt(r**2 - 0.1333**2)
    assert set(np.round(found, 4)) == set(np.round(formula, 4))


@pytest.mark.parametrize(("r", "reached"), [(0.128, 0), (0.139, 4), (0.919, 2), (0.930, 0)])
def test_iterations_end_at_the_hole_as_at_the_outer_edge(r, reached):
    assert len(gripper_down(r, 0)) == reached
    assert bool(len(solved_by_iteration(r, 0, 5))) == bool(reached)


@cache
def on_the_table():
    """Distances and Jacobians with the flange down at height 0, over angles of the elbow."""
    found = []
    for q3 in np.linspace(-2.9, 2.9, 401):
        # The shoulder follows from the height of the wrist, which is 6 cm below the shoulder.
        length = np.sqrt(0.425**2 + 0.3922**2 + 2 * 0.425 * 0.3922 * np.cos(q3))
        drop = np.arcsin((0.1625 - 0.0996) / length)
        q2 = np.pi - drop - np.arctan2(0.3922 * np.sin(q3), 0.425 + 0.3922 * np.cos(q3))
        for q5 in (-np.pi / 2, np.pi / 2):
            q = np.array([0, q2, q3, q5 - q2 - q3, q5, 0])
            T = UR5E.fk(q)
            np.testing.assert_allclose(T[2], [0, 0, -1, 0], atol=1e-12)
            found.append((np.hypot(*T[:2, 3]), differences(UR5E, q)))
    return found


def test_the_best_place_is_that_of_a_search_over_elbows():
    """A second way: a grid of elbow angles instead of places, by differences of the pose."""
    volumes = [(abs(np.linalg.det(J)), r) for r, J in on_the_table()]
    printed = source_of("04_poe_kuka_iiwa", "workspace-map")[1]
    assert f"largest at r = {max(volumes)[1]:.2f} m" in printed


@pytest.mark.parametrize(("name", "unit"), [("1 m", 1), ("1 mm", 0.001), ("40 cm", 0.4)])
def test_the_least_condition_numbers_are_those_of_a_search(name, unit):
    lengths = np.array([1 / unit, 1 / unit, 1 / unit, 1, 1, 1])[:, None]
    least, place = min((np.linalg.cond(lengths * J), r) for r, J in on_the_table())
    printed = source_of("04_poe_kuka_iiwa", "workspace-units")[1]
    (row,) = re.findall(rf"unit {name} *: least +([\d.]+) at r = ([\d.]+) m", printed)
    assert float(row[0]) == pytest.approx(least, rel=0.01)
    assert float(row[1]) == pytest.approx(place, abs=0.015)


# ---- notebook 5: a target that moves ----

PANDA = arms.panda()
BELT = np.array([0, 0.1, 0, 0, 0, 0])  # m/s


def error_of(q, T_d):
    T = PANDA.fk(q)
    rotation = Rotation.from_matrix(T_d[:3, :3] @ T[:3, :3].T).as_rotvec()
    return np.append((T_d - T)[:3, 3], rotation)


def on_the_belt(t):
    T_d = PANDA.fk(READY).copy()
    T_d[:3, 3] += np.array([0, 0.02, 0]) + BELT[:3] * t
    return T_d


@cache
def errors_of_the_notebook(K, feed_forward, dt, n):
    def geometric(frames):
        z, o = frames[:-1, :3, 2], frames[:-1, :3, 3]
        return np.vstack([np.cross(z, frames[-1, :3, 3] - o).T, z.T])

    def error(T, T_d):
        return np.append(
            (T_d - T)[:3, 3], Rotation.from_matrix(T_d[:3, :3] @ T[:3, :3].T).as_rotvec()
        )

    names = {"fk": PANDA.frames, "J_of": geometric, "error": error, "ready": READY}
    follow_target = functions_of("05_panda_dh_ik", "moving-code", **names)["follow_target"]
    return np.linalg.norm(follow_target(K, feed_forward * BELT, dt, n)[0][:, :3], axis=1)


@pytest.mark.parametrize("feed_forward", [0, 1])
def test_the_errors_are_those_of_the_differential_equation(feed_forward):
    """A second way: continuous control, with differences of the pose for the Jacobian."""

    def q_dot(t, q):
        wanted = feed_forward * BELT + 2 * error_of(q, on_the_belt(t))
        return np.linalg.lstsq(differences(PANDA, q), wanted)[0]

    times = np.linspace(0, 4, 9)
    solved = solve_ivp(q_dot, (0, 4), READY, t_eval=times, rtol=1e-5, atol=1e-7)
    distances = [
        np.linalg.norm(error_of(q, on_the_belt(t))[:3])
        for t, q in zip(solved.t, solved.y.T, strict=True)
    ]
    lag = 0 if feed_forward else 0.1 / 2  # v / K, in metres
    np.testing.assert_allclose(distances, lag + (0.02 - lag) * np.exp(-2 * times), atol=1e-5)
    stepwise = errors_of_the_notebook(2.0, feed_forward, 0.02, 200)[::25]
    np.testing.assert_allclose(stepwise, distances, atol=5e-4)


@pytest.mark.parametrize(("K", "shrinks"), [(1, True), (19.8, True), (20.2, False)])
def test_a_step_shrinks_the_errors_for_gains_below_two_over_dt(K, shrinks):
    """A second way: the eigenvalues of one step, linearized at the target by differences."""
    dt, h, T_d = 0.1, 1e-6, PANDA.fk(READY)
    columns = []
    for change in h * np.eye(7):
        q = READY + change
        step = np.linalg.pinv(differences(PANDA, q)) @ (K * error_of(q, T_d))
        columns.append((change + dt * step) / h)
    sizes = np.sort(np.abs(np.linalg.eigvals(np.transpose(columns))))
    six = np.delete(sizes, np.abs(sizes - 1).argmin())  # without the null space, which keeps q
    np.testing.assert_allclose(six, abs(1 - K * dt), atol=1e-4)
    assert (six < 1).all() == shrinks


def test_a_gain_converges_only_below_two_over_dt():
    below, above = (errors_of_the_notebook(K, 1, 0.1, 20) for K in (19.0, 21.0))
    np.testing.assert_allclose(below, 0.02 * 0.9 ** np.arange(21), rtol=0.35)
    np.testing.assert_allclose(above[:6], 0.02 * 1.1 ** np.arange(6), rtol=0.05)
    assert above[-1] > 10 * above[0]
    assert f"from 2.0 to {100 * below[-1]:.1f} cm" in source_of("05_panda_dh_ik", "moving-run")[1]
