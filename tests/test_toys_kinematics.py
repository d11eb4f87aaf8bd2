"""The toys' scripts agree with the library to 1e-9, on 100 random inputs each."""

import json

import numpy as np
import pytest
from numpy.testing import assert_allclose
from py_mini_racer import MiniRacer

from course_lib import ik, registration, rigid, rotations
from course_lib.arms import SerialArm, panda, planar_arm, ur5e
from course_lib.figures.solids import meshes
from course_lib.figures.toys.toy import script
from course_lib.lessons.panda_dh_ik.toys import SPOTS
from course_lib.planar import (
    interpolate_body_screw,
    pose_matrix,
    propagate_body,
    propagate_body_exact,
)
from course_lib.subproblems import subproblem2

N, CLOSE = 100, {"rtol": 0, "atol": 1e-9}


@pytest.fixture(scope="module")
def js():
    """A function: what one of the scripts answers to cases, its arguments one after the other, each
    as a column."""
    engine = MiniRacer()
    engine.eval(script("motion"))

    def ask(name, *columns):
        cases = json.dumps(list(zip(*columns, strict=True)), default=lambda array: array.tolist())
        return json.loads(
            engine.eval(f"JSON.stringify({cases}.map((case_) => course.motion.{name}(...case_)))")
        )

    return ask


@pytest.fixture
def rng():
    return np.random.default_rng(18)


def unit_axes(rng, n=N):
    axes = rng.normal(size=(n, 3))
    return axes / np.linalg.norm(axes, axis=-1, keepdims=True)


def a_model(arm):
    return {"screws": arm.screw_axes.tolist(), "home": arm.home.tolist()}


# ---- rigid motions ----


def twists(rng):
    angles = np.r_[
        np.zeros(10), 10 ** rng.uniform(-12, -1, 30), rng.uniform(0, np.pi, 50), np.full(10, np.pi)
    ]
    angles[90:] -= 10 ** rng.uniform(-12, -1, 10)
    return np.concatenate([angles[:, None] * unit_axes(rng), rng.normal(size=(N, 3))], 1)


def test_exponential_and_logarithm_are_the_librarys(js, rng):
    xi = twists(rng)
    poses = rigid.exp_se3(xi)
    assert_allclose(js("exp", xi), poses, rtol=0, atol=1e-12)
    back = np.array(js("log", poses))
    assert_allclose(rigid.exp_se3(back), poses, **CLOSE)
    assert_allclose(back[:90], rigid.log_se3(poses)[:90], **CLOSE)
    half = rigid.transform(rotations.random_rotations(1, rng)[0], np.zeros(3))
    for axis in ([1, 0, 0], [0, 0, 1]):  # exactly pi
        T = half @ rigid.exp_se3(np.r_[np.pi * np.array(axis), 1, 2, 3.0]) @ rigid.inverse(half)
        assert_allclose(rigid.exp_se3(np.array(js("log", [T])[0])), T, **CLOSE)


def test_the_motion_between_two_poses_is_the_librarys(js, rng):
    A, B = rigid.exp_se3(twists(rng)), rigid.exp_se3(twists(rng))
    between = A @ rigid.exp_se3(0.3 * rigid.log_se3(rigid.inverse(A) @ B))
    assert_allclose(js("interpolate", A, B, N * [0.3]), between, **CLOSE)


# ---- rotations ----


@pytest.fixture(scope="module")
def turns():
    """Unit axes and angles, special ones among them."""
    rng = np.random.default_rng(0)
    few = [0.0, 1e-12, 1e-8, 1e-4, 1e-3, np.pi, np.pi - 1e-9, -np.pi, 2 * np.pi]
    return unit_axes(rng), np.r_[few, rng.uniform(-7, 7, N - len(few))]


def test_a_rotation_is_that_of_its_axis_and_angle(js, turns):
    axes, angles = turns
    R = np.array(js("rotation", axes, angles))
    assert_allclose(R, rotations.exp_so3(angles[:, None] * axes), **CLOSE)


def test_a_quaternion_is_that_of_its_axis_and_angle(js, turns):
    axes, angles = turns
    q = np.array(js("quaternion", axes, angles))
    R = rotations.exp_so3(angles[:, None] * axes)
    assert_allclose(rotations.quaternion_to_matrix(q), R, **CLOSE)


def test_a_quaternion_changes_its_sign_after_a_revolution(js, turns):
    axes, angles = turns
    q = np.array(js("quaternion", axes, angles))
    assert_allclose(js("quaternion", axes, angles + 2 * np.pi), -q, **CLOSE)


def test_a_product_of_quaternions_is_that_of_their_rotations(js, rng):
    p, q = rotations.random_quaternions(N, rng), rotations.random_quaternions(N, rng)
    product = np.array(js("multiply", p, q))
    matrices = rotations.quaternion_to_matrix(p) @ rotations.quaternion_to_matrix(q)
    assert_allclose(rotations.quaternion_to_matrix(product), matrices, **CLOSE)


# ---- planar motions ----


def planar_poses(rng):
    A, B = (np.c_[rng.uniform(-4, 4, (N, 2)), rng.uniform(-3, 3, N)] for _ in range(2))
    B[:5, 2] = A[:5, 2] + [0, 1e-12, 1e-6, 1e-4, -1e-3]
    return A, B


def test_the_twist_between_two_poses_leads_from_one_to_the_other(js, rng):
    A, B = planar_poses(rng)
    twists = np.array(js("logPlanar", A, B))
    assert_allclose(twists, rigid.log_se2(np.linalg.inv(pose_matrix(A)) @ pose_matrix(B)), **CLOSE)
    reached = np.array(js("expPlanar", A, twists))
    assert_allclose(pose_matrix(reached), pose_matrix(B), **CLOSE)
    half = np.array(js("expPlanar", A, twists / 2))
    assert_allclose(pose_matrix(half), pose_matrix(interpolate_body_screw(A, B, 3)[:, 1]), **CLOSE)


def test_the_pole_is_a_fixed_point_and_a_translation_has_none(js, rng):
    A, B = planar_poses(rng)
    A, B = A[5:], B[5:]
    poles = np.array(js("pole", A, js("logPlanar", A, B)))
    motion = pose_matrix(B) @ np.linalg.inv(pose_matrix(A))
    moved = (motion @ np.c_[poles, np.ones(len(poles))][..., None])[:, :2, 0]
    assert_allclose(moved, poles, rtol=1e-9, atol=1e-9)
    assert js("pole", [[0, 0, 1]], [[0, 1, 2]]) == [None]


def test_three_errors_between_planar_poses_are_the_librarys(js, rng):
    A, B = planar_poses(rng)
    errors = js("planarErrors", A, B)
    T, T_target = pose_matrix(A), pose_matrix(B)
    spatial = rigid.log_se2(T_target @ np.linalg.inv(T))
    body = rigid.log_se2(np.linalg.inv(T) @ T_target)
    assert_allclose([error["space"] for error in errors], spatial, **CLOSE)
    assert_allclose([error["body"] for error in errors], body, **CLOSE)
    geometric = np.array([error["geometric"] for error in errors])
    assert_allclose(geometric[:, :2], (B - A)[:, :2], **CLOSE)
    assert_allclose(geometric[:, 2], body[:, 0], **CLOSE)


def test_two_wheels_roll_at_the_speeds_of_their_twist(js, rng):
    left, right, track = *rng.uniform(-0.5, 0.5, (2, N)), rng.uniform(0.1, 0.6, N)
    left[:5] = right[:5]
    h = 1e-6
    for v_l, v_r, b, twist in zip(
        left, right, track, js("twistOfWheels", left, right, track), strict=True
    ):
        omega, *v = twist
        T = pose_matrix(propagate_body_exact(np.zeros(3), [((*v, omega), h)], h)[-1])
        for speed, y in ((v_l, b / 2), (v_r, -b / 2)):
            moved = (T @ [0, y, 1])[:2] - [0, y]
            assert_allclose(moved / h, [speed, 0], atol=1e-5)


def test_dead_reckoning_by_euler_and_exactly(js, rng):
    plans = [[[rng.normal(size=3).tolist(), t] for t in rng.uniform(0.1, 2, 3)] for _ in range(N)]
    starts, steps = rng.normal(size=(N, 3)), rng.uniform(0.05, 0.6, N).tolist()
    plans[0], steps[0] = [[[1, 0, 0], 2.1]], 0.3  # 2.1 / 0.3 is slightly above 7
    for start, plan, dt, found in zip(
        starts, plans, steps, js("propagate", starts, plans, steps), strict=True
    ):
        assert_allclose(found["euler"], propagate_body(start, plan, dt), **CLOSE)
        assert_allclose(found["exact"], propagate_body_exact(start, plan, dt), **CLOSE)


# ---- circles ----


def test_circles_meet_at_the_solutions_of_subproblem_2(js, rng):
    """Circles without a solution do not meet."""
    k1, k2, p1, p2 = (unit_axes(rng) for _ in range(4))
    found = js("meetings", k1, k2, p1, p2)
    right = subproblem2(k1, k2, p1, p2)
    assert [len(points) > 0 for points in found] == right.exact.tolist()
    assert 20 < right.exact.sum() < 80
    meeting = np.flatnonzero(right.exact)
    for i in meeting:
        expected = rotations.exp_so3(right.theta[i, :, :1] * k1[i]) @ p1[i]
        by_x = np.argsort(expected[:, 0]), np.argsort(np.array(found[i])[:, 0])
        assert_allclose(np.array(found[i])[by_x[1]], expected[by_x[0]], **CLOSE)
    axes, starts, points = zip(
        *((k1[i], p1[i], point) for i in meeting for point in found[i]), strict=True
    )
    R = rotations.exp_so3(np.array(js("angleAbout", axes, starts, points))[:, None] * axes)
    assert_allclose((R @ np.array(starts)[..., None])[..., 0], points, **CLOSE)


# ---- arms ----


@pytest.mark.parametrize("which", ["panda", "random", "planar"])
def test_frames_and_jacobian_of_an_arm(which, js, rng):
    home = rigid.transform(rotations.random_rotations(1, rng)[0], rng.normal(size=3))
    some = SerialArm.from_screws(rng.normal(size=(5, 3)), rng.normal(size=(5, 3)), home)
    arm = {"panda": panda(), "random": some, "planar": planar_arm([1, 0.5])}[which]
    q = rng.uniform(-np.pi, np.pi, (N, arm.n))
    q[0] = 0
    cases = N * [a_model(arm)], q
    assert_allclose(js("frames", *cases), arm.frames(q), **CLOSE)
    assert_allclose(js("geometricJacobian", *cases), arm.geometric_jacobian(q), **CLOSE)
    assert_allclose(js("spaceJacobian", *cases), arm.space_jacobian(q), **CLOSE)
    moved = arm.frames(q)[:, :-1] @ rigid.inverse(arm.home[:-1])
    assert_allclose(np.array(js("bodies", *cases))[:, 1:], moved, **CLOSE)


def test_a_planar_arms_points_and_jacobian(js, rng):
    lengths, q = rng.uniform(0.3, 2, (N, 3)), rng.uniform(-4, 4, (N, 3))
    arms = [(planar_arm(row), angles) for row, angles in zip(lengths, q, strict=True)]
    assert_allclose(
        js("planarPoints", lengths, q),
        [arm.frames(angles)[:, :2, 3] for arm, angles in arms],
        **CLOSE,
    )
    jacobians = [arm.position_jacobian(angles)[:2] for arm, angles in arms]
    assert_allclose(js("planarJacobian", lengths, q), jacobians, **CLOSE)


def test_two_link_ik_solves_the_positions_within_reach(js, rng):
    lengths, points = rng.uniform(0.5, 1.5, (N, 2)), rng.uniform(-2, 2, (N, 2))
    r = np.linalg.norm(points, axis=-1)
    within = (np.abs(lengths[:, 0] - lengths[:, 1]) <= r) & (r <= lengths.sum(-1))
    for row, point, theta, reaches in zip(
        lengths, points, js("twoLink", lengths, points), within, strict=True
    ):
        assert (theta is not None) == reaches
        if reaches:
            assert theta[1] >= 0
            assert_allclose(planar_arm(row).fk(theta)[:2, 3], point, **CLOSE)


def test_a_damped_step_is_that_of_least_squares(js, rng):
    J, e, damping = rng.normal(size=(N, 2, 4)), rng.normal(size=(N, 2)), rng.uniform(0.01, 3, N)
    J[:10, 1] = 2 * J[:10, 0]  # singular
    for j, error, eps, step in zip(J, e, damping, js("dampedStep", J, e, damping), strict=True):
        stacked = np.vstack([j, np.sqrt(eps) * np.eye(4)])
        assert_allclose(step, np.linalg.lstsq(stacked, np.r_[error, np.zeros(4)])[0], **CLOSE)


def test_a_run_of_damped_steps_is_the_librarys(js, rng):
    q, targets = rng.uniform(-2, 2, (N, 4)), rng.uniform(-3, 3, (N, 2))
    alphas, epsilons = rng.uniform(0.05, 0.9, N), rng.uniform(0.5, 5, N)
    runs = js("dampedRun", N * [[1] * 4], q, targets, alphas, epsilons, N * [20])
    expected = ik.damped_path(planar_arm([1] * 4), targets, q, alphas, epsilons, 20)
    assert_allclose(runs, expected, **CLOSE)


def test_eigenvalues_and_vectors_of_symmetric_matrices(js, rng):
    A = rng.normal(size=(N, 3, 5))
    A[:5, 2] = A[:5, 1]  # a flat ellipsoid
    A = A @ np.swapaxes(A, 1, 2)
    for matrix, found in zip(A, js("eigen", A), strict=True):
        assert_allclose(found["values"], np.linalg.eigvalsh(matrix)[::-1], **CLOSE)
        V = np.array(found["vectors"])
        assert_allclose(matrix @ V.T, V.T * found["values"], **CLOSE)
        assert_allclose(V @ V.T, np.eye(3), **CLOSE)


def test_the_null_vector_is_in_the_null_space_of_the_jacobian(js, rng):
    arm = panda()
    q = rng.uniform(*arm.limits.T, (N, 7))
    J = arm.geometric_jacobian(q)
    found = np.array(js("nullVector", J))
    assert_allclose((J @ found[..., None])[..., 0], 0, **CLOSE)
    assert_allclose(np.linalg.norm(found, axis=-1), 1, **CLOSE)


def test_a_pose_error_agrees_with_the_library(js, rng):
    R = rotations.random_rotations(2 * N, rng)
    T = rigid.transform(R, rng.normal(size=(2 * N, 3)))
    T[N, :3, :3] = T[0, :3, :3]
    assert_allclose(js("poseError", T[:N], T[N:]), ik.pose_error(T[:N], T[N:]), **CLOSE)


def test_an_arm_reaches_a_pose_within_its_limits(js, rng):
    arm = panda()
    q = np.array([0.2, -0.6, 0.1, -2.0, 0.3, 1.6, 0.5])
    targets = arm.fk(np.clip(q + rng.uniform(-0.25, 0.25, (20, 7)), *arm.limits.T))
    found = np.array(
        js("reach", 20 * [a_model(arm)], 20 * [q], targets, 20 * [arm.limits.tolist()])
    )
    assert_allclose(arm.fk(found), targets, rtol=0, atol=1e-6)
    assert (found >= arm.limits[:, 0]).all()
    assert (found <= arm.limits[:, 1]).all()


def test_out_of_reach_an_arm_comes_to_rest(js):
    arm, far = ur5e(), rigid.transform(rotations.rot_z(0.3), [-1.15, -0.9, 0.8])
    q, beside = (
        np.array([0.4, -1.1, 1.3, -0.9, 0.7, 0.2]),
        rigid.transform(np.eye(3), [0.005, 0, 0]) @ far,
    )
    found = []
    for target in (far, beside, far):
        q = np.array(js("reach", [a_model(arm)], [q], [target], [arm.limits.tolist()])[0])
        found.append(np.linalg.norm(arm.fk(q)[:3, 3] - target[:3, 3]))
    assert abs(q[2]) < 1e-3, "the elbow is stretched"
    assert_allclose(np.diff(found), 0, atol=0.005)
    assert_allclose(found[2], found[0], rtol=0, atol=1e-4)


def test_points_are_registered_as_the_library_does(js, rng):
    angles = np.r_[rng.uniform(0, 3, N - 10), np.full(10, np.pi)]
    for n in (3, 7):
        src = rng.uniform(-0.1, 0.1, (N, n, 3))
        T = rigid.exp_se3(
            np.concatenate([angles[:, None] * unit_axes(rng), rng.normal(size=(N, 3))], 1)
        )
        dst = (
            src @ np.swapaxes(T[:, :3, :3], 1, 2)
            + T[:, None, :3, 3]
            + 0.002 * rng.normal(size=src.shape)
        )
        assert_allclose(js("register", src, dst), registration.register_points(src, dst), atol=1e-6)


def test_a_ray_meets_the_mug_at_its_spots_and_nothing_above_it(js):
    mug = meshes.mug()
    for eye in ([0.2, -0.41, 0.256], [0.197, -0.232, 0.6]):  # both cameras see all spots
        triangles = [(mug.vertices - eye)[mug.faces]] * 8
        met = js("firstHit", np.concatenate([0.5 * (SPOTS - eye), [[0, 0, 1]]]), triangles)
        assert_allclose(met[:7], 2, atol=0.002)
        assert met[7] is None  # Infinity, in JSON
