"""The pictures of notebook 5: both conventions on one arm, registration, and a gripper that grasps."""

import numpy as np
from films import Film
from helpers import places, stored

from course_lib import rigid, rotations
from course_lib.arms import panda
from course_lib.figures import panda_dh_ik as figures
from course_lib.figures import solids
from course_lib.figures.solids.model import X_RED

ARM = panda()
BASE = np.array([-0.2, 0.13, 0.6])
T_W0 = rigid.transform(np.eye(3), BASE)
READY = np.array([0, -np.pi / 4, 0, -3 * np.pi / 4, 0, np.pi / 2, np.pi / 4])
Q = READY + np.random.default_rng(1).uniform(-0.3, 0.3, (4, 7))
TIMES = np.linspace(0, 3, 4)
IN_FLANGE = rigid.transform(rotations.rot_z(-np.pi / 4), [0, 0, 0.1034])


CAMERA = rigid.transform(rotations.rot_x(np.pi), [0.3, 0.1, 1.4])


def pick():
    """A gripper above the table, closing; a mug beside it, below a camera."""
    frames = T_W0 @ ARM.frames(Q)
    grippers = frames[:, -1] @ IN_FLANGE
    mugs = rigid.transform(rotations.rot_z(np.linspace(0, 2, 4)), np.linspace([0.2, 0, 0.6], [0.3, 0.3, 0.6], 4))
    openings = np.array([0.08, 0.08, 0.07, 0.07])
    return figures.pick(frames, grippers, openings, mugs, TIMES, BASE, CAMERA), grippers, openings, mugs


def bodies_of(frames):
    stands = np.broadcast_to(T_W0, (*frames.shape[:-3], 1, 4, 4))
    return np.concatenate([stands, frames[..., :-1, :, :] @ rigid.inverse(ARM.home[:-1])], -3)


def test_both_conventions_are_drawn_on_one_arm_with_arrows_along_their_axes_and_shared_origins_named_together():
    frames = T_W0 @ ARM.frames(READY)
    drawn = figures.conventions(frames[:-1], frames[1:], BASE)
    figure = stored(drawn)
    arms = [trace for trace in figure["data"] if trace.get("opacity")]
    assert [arm["scene"] for arm in arms] == ["scene", "scene2"]
    true = solids.arm_model(ARM).placed(bodies_of(frames))
    for arm in arms:
        np.testing.assert_allclose(places(arm), true, atol=2e-4)
    triads = [t for t in figure["data"] if t["type"] == "mesh3d" and not t.get("opacity") and t["cmax"] < 99]
    for triad, shown_frames in zip(triads, (frames[:-1], frames[1:]), strict=True):
        vertices, colours = places(triad), np.array(X_RED) + np.arange(3)
        of = next(trace.intensity for trace in drawn.fig.data if trace.x.size == len(vertices))
        for T in shown_frames:
            for k in range(3):
                tip = T[:3, 3] + 0.13 * T[:3, k]
                assert np.linalg.norm(vertices[of == colours[k]] - tip, axis=1).min() < 2e-3
    assert [note["text"] for note in figure["layout"]["annotations"]] == ["modified", "standard"]
    names = [trace["text"] for trace in figure["data"] if trace.get("mode") == "text"]
    assert names == [["1, 2", "3", "4", "5, 6", "7"], ["1", "2", "3", "4, 5", "6", "7"]]


def test_the_mug_is_drawn_at_the_registered_pose_and_the_rejected_match_is_marked():
    template = np.random.default_rng(2).uniform([-0.03, -0.03, 0.015], [0.03, 0.03, 0.075], (7, 3))
    T = rigid.transform(rotations.rot_z(0.4), [0.4, 0.1, 0.6])
    seen = template @ T[:3, :3].T + T[:3, 3]
    seen[2] += 0.03
    figure = stored(figures.matches(template, seen, T, [2]))
    dots = [places(trace) for trace in figure["data"] if trace.get("mode") == "markers"]
    for drawn, true in zip(dots, (template, seen, seen[[2]]), strict=True):
        np.testing.assert_allclose(drawn, true, atol=6e-4)
    one, other = [places(trace) for trace in figure["data"] if trace["type"] == "mesh3d"]
    np.testing.assert_allclose(other, one @ T[:3, :3].T + T[:3, 3], atol=2e-4)
    dashed = next(places(trace) for trace in figure["data"] if trace.get("line", {}).get("dash") == "dash")
    np.testing.assert_allclose(dashed, [seen[2], (T @ [*template[2], 1])[:3]], atol=6e-4)


def test_fingers_are_as_far_apart_as_the_gripper_is_open():
    figure, grippers, openings, _ = pick()
    film = Film(figure)
    np.testing.assert_allclose(film.poses[:, :8], bodies_of(T_W0 @ ARM.frames(Q)), atol=5e-5)
    for i, (T, opening) in enumerate(zip(grippers, openings, strict=True)):
        at = film.at(i)
        left, right = (((at[film.of_body == k] - T[:3, 3]) @ T[:3, :3])[:, 1] for k in (9, 10))
        assert min(right) - max(left) == np.clip(min(right) - max(left), opening - 2e-3, opening + 2e-3)
        assert abs(min(right) + max(left)) < 1e-3, "in the middle"
        depth = ((at[(film.of_body == 9)] - T[:3, 3]) @ T[:3, :3])[:, 2]
        assert depth.min() < -0.03 < 0 < depth.max(), "they reach from the palm to the mug"


def test_the_palm_is_on_the_flange_and_the_mug_follows_the_poses_it_is_given():
    figure, grippers, _, mugs = pick()
    film = Film(figure)
    np.testing.assert_allclose(film.bodies[8][:, 2].min(), -0.1034, atol=1e-3)
    np.testing.assert_allclose(film.poses[:, 8], grippers, atol=5e-5)
    np.testing.assert_allclose(film.poses[:, 11], mugs, atol=5e-5)
    mug = film.bodies[11]
    assert np.ptp(mug[:, 2]) == np.clip(np.ptp(mug[:, 2]), 0.089, 0.091)
    handle = mug[np.hypot(mug[:, 0], mug[:, 1]).argmax()]
    assert handle[0] > 0.06
    assert abs(handle[1]) < 0.01


def test_the_four_parameters_are_drawn_with_their_angles_and_names():
    a, alpha, d, theta = 0.8, 0.7, 0.6, 0.9
    figure = stored(figures.four_parameters(a, alpha, d, theta))
    arcs = [places(t) for t in figure["data"] if t.get("mode") == "lines" and len(t["x"]) > 2]
    for arc, angle in zip(arcs, (alpha, theta), strict=True):
        start, middle, end = arc[[0, len(arc) // 2, -1]]
        height = np.linalg.norm(middle - (start + end) / 2)  # of the arc over its chord
        assert abs(4 * np.arctan2(2 * height, np.linalg.norm(end - start)) - angle) < 0.02
    names = {name for trace in figure["data"] if trace.get("mode") == "text" for name in trace["text"]}
    assert {"a", "d", "\u03b1", "θ"} <= names


def test_the_camera_is_drawn_at_its_pose_and_points_at_the_table():
    film = Film(pick()[0])
    np.testing.assert_allclose(film.poses[:, 12], np.broadcast_to(CAMERA, (4, 4, 4)), atol=6e-6)
    assert film.bodies[12][:, 2].max() > 0.04, "its lens looks along its z axis"
