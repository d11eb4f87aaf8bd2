"""The pictures of notebook 5: both conventions on one arm, registration, and a gripper that
grasps."""

import numpy as np
from films import Film

from course_lib import rigid, rotations
from course_lib.arms import panda
from course_lib.figures import solids
from course_lib.lessons.panda_dh_ik import figures
from course_lib.lessons.panda_dh_ik.exercises.shared import READY

ARM = panda()
BASE = np.array([-0.2, 0.13, 0.6])
T_W0 = rigid.transform(np.eye(3), BASE)
Q = READY + np.random.default_rng(1).uniform(-0.3, 0.3, (4, 7))
TIMES = np.linspace(0, 3, 4)
IN_FLANGE = rigid.transform(rotations.rot_z(-np.pi / 4), [0, 0, 0.1034])


CAMERA = rigid.transform(rotations.rot_x(np.pi), [0.3, 0.1, 1.4])


def pick():
    """A gripper above the table, closing; a mug beside it, below a camera."""
    frames = T_W0 @ ARM.frames(Q)
    grippers = frames[:, -1] @ IN_FLANGE
    mugs = rigid.transform(
        rotations.rot_z(np.linspace(0, 2, 4)), np.linspace([0.2, 0, 0.6], [0.3, 0.3, 0.6], 4)
    )
    openings = np.array([0.08, 0.08, 0.07, 0.07])
    return (
        figures.pick(frames, grippers, openings, mugs, TIMES, BASE, CAMERA),
        grippers,
        openings,
        mugs,
    )


def bodies_of(frames):
    stands = np.broadcast_to(T_W0, (*frames.shape[:-3], 1, 4, 4))
    return np.concatenate([stands, frames[..., :-1, :, :] @ rigid.inverse(ARM.home[:-1])], -3)


def test_both_conventions_are_drawn_on_one_arm():
    frames = T_W0 @ ARM.frames(READY)
    film = Film(figures.conventions(frames[:-1], frames[1:], BASE))
    stands = solids.Model.of(solids.shell(ARM)).placed(bodies_of(frames)) - BASE
    offsets = film.poses[0, :, :3, 3]
    np.testing.assert_allclose(
        film.pale(), np.concatenate([stands + offset for offset in offsets]), atol=2e-4
    )
    for shown_frames, offset in zip((frames[:-1], frames[1:]), offsets, strict=True):
        for T in shown_frames:
            for k in range(3):
                tip = T[:3, 3] + 0.13 * T[:3, k] - BASE + offset
                assert np.linalg.norm(film.at(0) - tip, axis=1).min() < 2e-3
    names = [word for word, *_ in film.course["words"]]
    assert names == [
        "1, 2",
        "3",
        "4",
        "5, 6",
        "7",
        "modified",
        "1",
        "2",
        "3",
        "4, 5",
        "6",
        "7",
        "standard",
    ]


def test_fingers_are_as_far_apart_as_the_gripper_is_open():
    figure, grippers, openings, _ = pick()
    film = Film(figure)
    np.testing.assert_allclose(film.poses[:, :8], bodies_of(T_W0 @ ARM.frames(Q)), atol=5e-5)
    for i, (T, opening) in enumerate(zip(grippers, openings, strict=True)):
        at = film.at(i)
        left, right = (((at[film.of_body == k] - T[:3, 3]) @ T[:3, :3])[:, 1] for k in (9, 10))
        assert min(right) - max(left) == np.clip(
            min(right) - max(left), opening - 2e-3, opening + 2e-3
        )
        assert abs(min(right) + max(left)) < 1e-3, "in the middle"


def test_gripper_mug_and_camera_are_at_the_poses_that_are_given():
    figure, grippers, _, mugs = pick()
    film = Film(figure)
    np.testing.assert_allclose(film.poses[:, 8], grippers, atol=5e-5)
    np.testing.assert_allclose(film.poses[:, 11], mugs, atol=5e-5)
    np.testing.assert_allclose(film.poses[:, 12], np.broadcast_to(CAMERA, (4, 4, 4)), atol=6e-6)
