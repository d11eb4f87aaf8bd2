"""The pictures of notebook 5: both conventions on one arm, the null space, registration, and a gripper that grasps."""

import numpy as np
from helpers import assert_in_scene, places, shown, stored

from course_lib import rigid, rotations
from course_lib.arms import panda
from course_lib.figures import panda_dh_ik as figures

ARM = panda()
BASE = np.array([-0.2, 0.13, 0.6])
T_W0 = rigid.transform(np.eye(3), BASE)
READY = np.array([0, -np.pi / 4, 0, -3 * np.pi / 4, 0, np.pi / 2, np.pi / 4])
Q = READY + np.random.default_rng(1).uniform(-0.3, 0.3, (4, 7))
TIMES = np.linspace(0, 3, 4)


def pick():
    """A gripper somewhere above the table, closing; a mug beside it."""
    grippers = rigid.transform(
        rotations.rot_x(np.pi) @ rotations.rot_z(np.linspace(0, 1, 4)), np.linspace([0.2, 0, 0.9], [0.3, 0.3, 0.7], 4)
    )
    mugs = rigid.transform(rotations.rot_z(np.linspace(0, 2, 4)), np.linspace([0.2, 0, 0.6], [0.3, 0.3, 0.6], 4))
    openings = np.array([0.08, 0.08, 0.07, 0.07])
    figure = stored(figures.pick("pick", T_W0 @ ARM.frames(Q), grippers, openings, mugs, TIMES, BASE))
    return figure, grippers, openings, mugs


def middle_of(figure):
    """What was subtracted from every place: the dot of the base tells."""
    base = next(places(trace) for trace in figure["data"] if trace["mode"] == "markers")
    return BASE - base[0]


def test_both_conventions_stand_on_the_same_arm():
    frames = T_W0 @ ARM.frames(READY)
    figure = stored(figures.conventions({"modified": frames, "standard": frames[[*range(1, 8), 7]]}, BASE))
    assert_in_scene(figure)
    lines = [trace for trace in figure["data"] if trace["mode"] == "lines+markers"]
    assert [line["scene"] for line in lines] == ["scene", "scene2"]
    middle = middle_of(figure)
    for line, shift in zip(lines, (0, 1), strict=True):
        np.testing.assert_allclose(places(line)[1] + middle, frames[shift, :3, 3], atol=2e-3)
        np.testing.assert_allclose(places(line)[-1] + middle, frames[-1, :3, 3], atol=2e-3)
    assert [note["text"] for note in figure["layout"]["annotations"]] == ["modified", "standard"]


def test_frames_with_one_origin_are_named_together():
    figure = stored(figures.conventions({"modified": T_W0 @ ARM.frames(READY)}, BASE))
    names = [trace["text"][0] for trace in figure["data"] if trace["mode"] == "text"]
    assert names == ["1, 2", "3", "4", "5, 6", "7"]


def test_frames_are_drawn_along_their_axes():
    frames = T_W0 @ ARM.frames(READY)
    figure = stored(figures.conventions({"modified": frames}, BASE))
    axes = [trace for trace in figure["data"] if len(trace["x"]) == 21]
    assert len(axes) == 3
    for i, trace in enumerate(axes):
        along = places(trace).reshape(-1, 3, 3)
        np.testing.assert_allclose(along[:, 1] - along[:, 0], 0.13 * frames[:-1, :3, i], atol=2e-3)


def test_the_elbows_path_is_drawn_and_the_arm_stands_where_its_frames_are():
    frames = T_W0 @ ARM.frames(Q)
    figure = stored(figures.null_space("elbow", frames, TIMES, BASE))
    assert_in_scene(figure)
    middle = middle_of(figure)
    np.testing.assert_allclose(places(figure["data"][0]) + middle, frames[:, 3, :3, 3], atol=2e-3)
    for shot, at in zip(figure["frames"], frames, strict=True):
        np.testing.assert_allclose(places(shot["data"][0])[1:] + middle, at[:, :3, 3], atol=2e-3)


def test_histograms_count_every_target():
    counts = {"one": np.array([1, 1, 99]), "two": np.array([50])}
    fig = figures.iterations(counts, 100)
    for ax, (title, taken) in zip(fig.axes, counts.items(), strict=True):
        assert sum(bar.get_height() for bar in ax.patches) == len(taken)
        assert ax.get_title() == title
    assert set(shown(fig).data) == {"image/png", "text/plain"}


def test_the_template_is_laid_on_the_scene_and_the_dropped_match_stands_out():
    template = np.random.default_rng(2).uniform(-0.03, 0.06, (5, 3))
    T = rigid.transform(rotations.rot_z(0.7), [0.3, -0.05, 0.6])
    scene = template @ T[:3, :3].T + T[:3, 3]
    scene[2] += [0, 0.02, -0.02]
    figure = stored(figures.matches(template, scene, T, 2))
    assert_in_scene(figure)
    seen = [trace for trace in figure["data"] if trace["mode"] == "markers"]
    own_middle = np.array([0.015, 0, 0.045])
    middle = (T @ [*own_middle, 1])[:3]
    np.testing.assert_allclose(places(seen[0]) / 100 + own_middle, template, atol=1e-4)
    np.testing.assert_allclose(places(seen[1]) / 100 + middle, scene, atol=1e-4)
    np.testing.assert_allclose(places(seen[2])[0] / 100 + middle, scene[2], atol=1e-4)
    dashed = next(trace for trace in figure["data"] if trace.get("line", {}).get("dash") == "dash")
    np.testing.assert_allclose(places(dashed)[1] / 100 + middle, (T @ [*template[2], 1])[:3], atol=1e-4)


def test_fingers_stand_as_far_apart_as_the_gripper_is_open():
    figure, grippers, openings, _ = pick()
    assert_in_scene(figure)
    middle = middle_of(figure)
    for shot, T, opening in zip(figure["frames"], grippers, openings, strict=True):
        fork = places(shot["data"][1]) + middle
        np.testing.assert_allclose(np.linalg.norm(fork[0] - fork[-1]), opening, atol=2e-3)
        np.testing.assert_allclose((fork[0] + fork[-1]) / 2, T[:3, 3], atol=2e-3)
        np.testing.assert_allclose(fork[-1] - fork[0], opening * T[:3, 1], atol=2e-3)
        assert (T[:3, 2] @ (fork[0] - fork[1])) > 0.04  # the fingers point where the gripper reaches


def test_the_mug_moves_as_it_is_told():
    figure, _, _, mugs = pick()
    middle = middle_of(figure)
    for shot, T in zip(figure["frames"], mugs, strict=True):
        outline = places(shot["data"][2]) + middle
        own = (outline - T[:3, 3]) @ T[:3, :3]
        round_about = np.hypot(own[:, 0], own[:, 1])
        assert np.isclose(np.nanmin(own[:, 2]), 0, atol=2e-3)
        assert np.isclose(np.nanmax(own[:, 2]), 0.09, atol=2e-3)
        assert np.isclose(np.nanmin(round_about), 0.035, atol=2e-3)
        handle = own[np.nanargmax(round_about)]
        assert handle[0] > 0.06
        assert abs(handle[1]) < 2e-3
