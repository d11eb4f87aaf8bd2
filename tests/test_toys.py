"""Toys in Python: their models and texts, the output in stored and in live notebooks, and the
answers of jog."""

import json
from pathlib import Path

import nbformat
import numpy as np
import pytest
import some_toys
from nbformat.v4 import new_code_cell, new_notebook, new_output
from numpy.testing import assert_allclose
from some_toys import Q7, ROUND, TOYS, VIEWS

from course_lib import figures, rigid, rotations
from course_lib.arms import iiwa14, panda, planar_arm, ur5e
from course_lib.figures.solids import Part
from course_lib.figures.solids.meshes import ball
from course_lib.figures.solids.model import AMBER, VIOLET
from course_lib.figures.stills import TOY, stored_stills
from course_lib.figures.toys.film import film, flat_film, still
from course_lib.figures.toys.toy import ELSEWHERE, PARTS, SCRIPTS, is_live, script_names
from course_lib.lessons.decomposition_ik.toys import table
from course_lib.lessons.panda_dh_ik.toys import click, panda_toy
from course_lib.lessons.rigid_motion.toys import drive
from course_lib.lessons.rotations.toys import fly, orientation_toy
from course_lib.lessons.subproblems_damped_ik.toys import planar_arm_toy
from course_lib.pack.notebooks import run, tidy
from course_lib.planar import propagate_body

Q = np.array(Q7)
ROOT = Path(__file__).parents[1]

# ---- every toy ----


def test_every_toy_is_among_those_that_are_tested():
    tested = Path(some_toys.__file__).read_text()
    assert [
        name for name in figures.__all__ if name not in ("lines", "show") and name not in tested
    ] == []


@pytest.mark.parametrize("name", TOYS)
def test_a_toy_is_little_data_and_its_words_are_a_sentence(name):
    toy = TOYS[name]()
    assert len(json.dumps(toy.stored(), allow_nan=False)) < 60_000
    assert 60 < len(toy.alt) < 1200
    assert toy.alt.endswith(".")


def test_only_a_live_notebook_gets_the_widget(monkeypatch):
    """A stored notebook gets the model of the toy."""
    toy, outputs = TOYS["table"](), []
    monkeypatch.setattr("IPython.display.display", lambda data, raw, metadata: outputs.append(data))
    monkeypatch.delenv("JPY_SESSION_NAME", raising=False)
    assert not is_live()
    toy._ipython_display_()
    monkeypatch.setenv("JPY_SESSION_NAME", "/home/student/01_rotations.ipynb")
    toy._ipython_display_()
    stored, live = (data for data in outputs if "text/markdown" not in data)  # the captions apart
    assert set(stored) == {TOY, "text/plain"}
    assert set(live) == {"application/vnd.jupyter.widget-view+json", TOY, "text/html", "text/plain"}
    assert stored["text/plain"] == toy.alt
    assert live["text/plain"] == f"{toy.alt} {ELSEWHERE}"
    assert stored[TOY]["layout"]["meta"]["course"]["kind"] == toy.meta["kind"]


def test_where_widgets_do_not_run_the_stored_still_is_shown(tmp_path, monkeypatch):
    toy, outputs = TOYS["reach"](), []
    stored = new_output("display_data", data={TOY: toy.stored(), "image/png": "iVBORw0KGgo="})
    nbformat.write(
        new_notebook(cells=[new_code_cell("toy", outputs=[stored])]), tmp_path / "01.ipynb"
    )
    (tmp_path / "02.ipynb").write_text(f"<<<<<<< {TOY}")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(
        "IPython.display.display", lambda data, raw, metadata: outputs.append((data, metadata))
    )
    monkeypatch.setenv("JPY_SESSION_NAME", "01.ipynb")
    stored_stills.cache_clear()
    toy._ipython_display_()
    stored_stills.cache_clear()
    data, metadata = outputs[0]
    assert data["image/png"] == "iVBORw0KGgo="
    assert metadata["image/png"]["alt"] == toy.alt
    assert 'src="data:image/png;base64,iVBORw0KGgo="' in data["text/html"]
    assert ELSEWHERE in data["text/html"]


@pytest.mark.parametrize("live", [False, True])
def test_a_stored_caption_says_where_the_figure_moves(live, monkeypatch):
    outputs = []
    monkeypatch.setattr(
        "IPython.display.display", lambda *data, **more: outputs.append((data, more))
    )
    monkeypatch.delenv("JPY_SESSION_NAME", raising=False)
    if live:
        monkeypatch.setenv("JPY_SESSION_NAME", "/home/student/01_rotations.ipynb")
    toy = TOYS["wheels"]()
    toy._ipython_display_()
    ((words,), options) = outputs[-1]
    remark = "" if live else f" *{ELSEWHERE}*"
    assert words["text/markdown"] == toy.caption + remark
    assert options["metadata"] == {"caption": toy.caption}


def test_the_caption_of_a_still_says_nothing_of_motion(monkeypatch):
    outputs = []
    monkeypatch.setattr("IPython.display.display", lambda data, **more: outputs.append(data))
    monkeypatch.delenv("JPY_SESSION_NAME", raising=False)
    globe = still([Part(0, AMBER, ball(np.zeros(3), 0.1))], "A globe that stands.", "A globe.")
    globe._ipython_display_()
    assert outputs[-1]["text/markdown"] == "A globe."


def test_a_notebook_with_toys_stores_the_same_every_time(tmp_path, monkeypatch):
    """It stores no widgets."""
    monkeypatch.setenv("JPY_SESSION_NAME", "as if make ran in a notebook of JupyterLab")
    sources = [
        "from course_lib.lessons.rotations.toys import orientation_toy\n"
        "from course_lib.lessons.subproblems_damped_ik.toys import planar_arm_toy",
        "planar_arm_toy()",
        "orientation_toy('belt')",
    ]
    book = new_notebook(
        cells=[new_code_cell(source, id=f"c{i}") for i, source in enumerate(sources)]
    )
    run(book, tmp_path / "toys.ipynb")
    tidy(book)
    for cell, name in zip(book.cells[1:], ("planar_arm_toy", "belt"), strict=True):
        assert cell.outputs[0].data[TOY] == TOYS[name]().stored(), "the same in another process"
    assert "widget" not in nbformat.writes(book)


@pytest.mark.parametrize(
    ("toy", "arguments", "named"),
    [
        (orientation_toy, {"mode": "gimbal"}, "mode"),
        (planar_arm_toy, {"q": [0.1]}, "q"),
        (planar_arm_toy, {"step": 7}, "step"),
        (panda_toy, {"q": "up"}, "q"),
        (figures.jog, {"arm": iiwa14(), "q": Q, "fk": np.eye(4)}, "fk"),
        (figures.jog, {"arm": iiwa14(), "q": Q, "names": "sb"}, "names"),
        (figures.jog, {"arm": iiwa14(), "q": Q, "names": ("0", "")}, "names"),
        (figures.reach, {"arm": iiwa14(), "q": Q, "target": [1]}, "target"),
        (fly, {"start": np.eye(3), "goal": 2 * np.eye(3)}, "goal"),
        (table, {"at": [1, 1, 1]}, "at"),
        (drive, {"plan": [((1, 2), 3)]}, "plan"),
        (figures.alive, {"figure": "reach"}, "figure"),
        (figures.alive, {"figure": table([1, 1]), "f": 3}, "f"),
    ],
)
def test_a_wrong_argument_is_named(toy, arguments, named):
    with pytest.raises(ValueError, match=rf"^{named}\b"):
        toy(**arguments)


def test_a_wrong_pose_of_the_mug_is_named():
    with pytest.raises(ValueError, match=r"^T_wm\b"):
        click(np.eye(3), np.eye(4), np.eye(4), 2 * np.eye(4))


# ---- ghosts of films ----


def two_balls(ghosts):
    """A film of two balls, of which the second moves."""
    poses = np.broadcast_to(np.eye(4), (3, 2, 4, 4)).copy()
    poses[:, 1, 0, 3] = [0.5, 0.8, 1.5]
    parts = [Part(body, AMBER, ball(np.zeros(3), 0.1)) for body in (0, 1)]
    return film(parts, poses, [0.0, 1.0, 2.0], "Two balls: one moves.", ghosts=ghosts)


def test_ghosts_of_a_film_are_of_the_bodies_that_move():
    course = two_balls(2).meta
    assert course["ghosts"] == [1.0, 2.0]
    assert course["moving"] == [1]
    assert "ghosts" not in two_balls(0).meta


def test_too_many_ghosts_of_a_film_are_refused_by_name():
    with pytest.raises(ValueError, match=r"^ghosts must be from 0 to 4; it is 9"):
        two_balls(9)


def test_things_of_a_flat_film_keep_what_stands_still():
    corners = np.zeros((2, 3, 2))
    toy = flat_film(
        [corners, corners],
        [0.0, 1.0],
        "A film. It has two things.",
        name="two",
        still=[(np.zeros((1, 2)), "#222222", (), 1)],
        half=1,
        names=("first", "second"),
    )
    assert toy.meta["names"] == ["first", "second"]
    assert toy.meta["still"] == [[[[0.0, 0.0]], "#222222", [], 1]]


# ---- scripts ----


@pytest.mark.parametrize("name", PARTS)
def test_every_file_of_a_script_is_among_its_parts(name):
    files = [path.stem for path in (SCRIPTS / name).iterdir()]
    assert sorted(files) == sorted(PARTS[name])


def test_every_folder_of_scripts_is_a_script():
    assert {path.name for path in SCRIPTS.iterdir() if path.is_dir()} == set(PARTS)


@pytest.mark.parametrize(
    "path", sorted((ROOT / "notebooks").glob("0*.ipynb")), ids=lambda p: p.stem
)
def test_a_stored_notebook_names_scripts_that_there_are(path):
    outputs = [o for c in nbformat.read(path, 4).cells for o in c.get("outputs", [])]
    toys = [o.data[TOY] for o in outputs if TOY in o.get("data", {})]
    named = {name for toy in toys for name in toy["layout"]["meta"]["course"]["scripts"]}
    assert toys
    assert named <= set(script_names())


# ---- what jog answers ----


def by_screws(screws, M, theta):
    T = np.eye(4)
    for screw, angle in zip(screws, theta, strict=True):
        T = T @ rigid.exp_se3(np.array(screw) * angle)
    return T @ M


def reversed_order(screws, M, theta):
    return by_screws(screws[::-1], M, theta[::-1])


def answer(arm, fk, base=None, q=Q):
    found = figures.jog(arm, fk, q=q, base=base).answer({"q": q.tolist()})
    return found | (found["value"] or {"end": None, "bodies": None})


def test_a_right_function_moves_every_body_as_the_library():
    def changes(screws, M, theta):
        T = by_screws(screws, M, theta)
        screws[:], M[:], theta[:] = 0, 0, 0
        return T

    arm = iiwa14()
    found = answer(arm, changes)
    assert found["problem"] is None
    assert_allclose(found["end"], arm.fk(Q), atol=1e-12)
    assert found["gap"] < 1e-12
    assert_allclose(np.array(found["bodies"])[1:] @ arm.home[:-1], arm.frames(Q)[:-1], atol=1e-12)


def test_a_wrong_function_moves_the_bodies_to_its_own_poses():
    arm = iiwa14()
    found = answer(arm, reversed_order)
    assert_allclose(found["end"], reversed_order(arm.screw_axes, arm.home[-1], Q))
    assert found["gap"] > 0.1
    assert_allclose(found["bodies"][2], reversed_order(arm.screw_axes[:2], np.eye(4), Q[:2]))


def test_a_function_of_angles_may_return_all_frames_or_the_last():
    arm, base = panda(), rigid.transform(np.eye(3), [-0.2, 0.13, 0.6])
    q = np.array([0.1, -0.5, 0.2, -2.0, 0.3, 1.4, 0.5])
    frames = answer(arm, lambda q: base @ arm.frames(q), base, q)
    assert_allclose(np.array(frames["bodies"])[1:] @ arm.home[:-1], arm.frames(q)[:-1], atol=1e-12)
    assert_allclose(frames["end"], arm.fk(q), atol=1e-12)
    alone = answer(arm, lambda q: base @ arm.fk(q), base, q)
    assert alone["bodies"] is None
    assert_allclose(alone["end"], arm.fk(q), atol=1e-12)


FAILING = [lambda q: q[9], lambda q: None, lambda q: np.zeros(3), lambda q: np.full((4, 4), np.nan)]


@pytest.mark.parametrize("broken", FAILING)
def test_a_function_that_fails_leaves_the_library_s_arm(broken):
    """The failure is reported."""
    found = answer(iiwa14(), broken)
    assert found["end"] is found["bodies"] is None
    assert found["problem"].split(": ")[1] in ("IndexError", "TypeError", "ValueError")
    assert found["problem"].startswith("Your function: ")
    assert "\n" not in found["problem"]
    json.dumps(found, allow_nan=False)


def test_the_answer_names_whose_function_moves_the_arm():
    def fk(q):
        return planar_arm([1, 1]).fk(q)

    assert answer(planar_arm([1, 1]), fk, q=np.zeros(2))["whose"] == "your function"
    fk.whose = "the library's"
    assert answer(planar_arm([1, 1]), fk, q=np.zeros(2))["whose"] == "the library's function"


# ---- the student's function alive in a figure ----


def asked(figure, f, **question):
    return figures.alive(figure, f).answer(question)


def test_any_number_of_solutions_reaches_the_figure():
    arm, target = ur5e(), ur5e().fk(Q[:6])
    figure = figures.reach(
        arm, target, q=Q[:6], says=lambda T, found: f"{len(found)} at {T[0, 3]:.3f}"
    )

    def given(answer):
        seen = []
        found = asked(figure, lambda T: seen.append(T.copy()) or answer, target=target.tolist())
        assert_allclose(seen, [target])
        return found

    assert given(Q[:6])["value"] == [Q7[:6]]
    both = given(np.array([Q[:6], np.full(6, np.nan), -Q[:6]]))
    assert both["value"] == [Q7[:6], (-Q[:6]).tolist()]
    assert both["said"] == f"2 at {target[0, 3]:.3f}"
    assert given(None)["value"] == given([])["value"] == []
    wrong = given([1, 2, 3])
    assert wrong["value"] is None
    assert "should have shape (6,) or (k, 6); it is (3,)" in wrong["problem"]


@pytest.mark.parametrize("quaternions", [False, True])
def test_a_motion_between_two_orientations_is_sampled(quaternions):
    start, goal = rotations.rot_x(0.3), rotations.rot_z(1.0)

    def shortest(A, B, s):
        if quaternions:
            A, B = rotations.quaternion_to_matrix(A), rotations.quaternion_to_matrix(B)
        R = A @ rotations.exp_so3(s * rotations.log_so3(A.T @ B))
        return rotations.matrix_to_quaternion(R) if quaternions else R

    figure = fly(start, goal, quaternions=quaternions)
    found = np.array(asked(figure, shortest, ends=[start.tolist(), goal.tolist()])["value"])
    assert_allclose(found[[0, -1]], [start, goal], atol=1e-12)
    assert rotations.is_so(found).all()
    wrong = {
        "of shape": lambda A, B, s: s,
        "contains NaN": lambda A, B, s: A * (np.nan if s else 1),
    }
    wrong["at s = 0.025 is not a"] = lambda A, B, s: (1 + s) * A
    for words, f in wrong.items():
        assert words in asked(figure, f, ends=[start.tolist(), goal.tolist()])["problem"]


def test_a_table_is_asked_beforehand_for_pages():
    toy = figures.alive(table([1, 1]), lambda p: p if p[0] > 0 else None)
    at, q = (np.array(toy.meta["stored"][name], float).T for name in ("at", "q"))
    assert (np.linalg.norm(at, axis=1) <= 2 + 1e-3).all()
    assert_allclose(q, np.where(at[:, :1] > 0, at, np.nan))
    for error in (IndexError, KeyboardInterrupt):

        def broken(p, error=error):
            raise error

        toy = figures.alive(table([1, 1]), broken)
        assert not np.isfinite(np.array(toy.meta["stored"]["q"], float)).any()
        assert toy.answer({"at": [1, 1]})["problem"].startswith(
            f"Your function: {error.__name__}: "
        )


def test_the_log_of_a_drive_reaches_the_function():
    """The poses that it returns reach the figure."""
    figure, log, seen = drive(ROUND), [[[0.5, 0.0, 0.9], 0.7]], []
    found = asked(figure, propagate_body, plan=log, dt=0.5)["value"]
    assert_allclose(found, propagate_body([0] * 3, log, 0.5), atol=1e-5)
    asked(figure, lambda *case: seen.append(case), plan=log, dt=0.5)
    assert_allclose(seen[0][0], np.zeros(3))
    assert seen[0][1:] == ([((0.5, 0.0, 0.9), 0.7)], 0.5)
    assert (
        "of shape (n, 3); its shape is (3,)"
        in asked(figure, lambda *case: [0, 0, 0], plan=log, dt=0.5)["problem"]
    )


def test_the_function_gets_what_is_clicked():
    """The figure gets the pose that it returns."""
    figure, seen = click(*VIEWS), []
    pixels, depths = figure.model["clicks"], np.ones((2, 7)).tolist()
    found = asked(figure, lambda *case: seen.append(case) or VIEWS[3], pixels=pixels, depths=depths)
    assert_allclose(found["value"], VIEWS[3])
    assert_allclose(seen[0][0], pixels)
    assert_allclose(seen[0][1], depths)
    for wrong, words in (
        (np.eye(3), "of shape (4, 4); its shape is (3, 3)"),
        (np.full((4, 4), np.nan), "contains NaN"),
    ):
        assert (
            words
            in asked(figure, lambda *case, T=wrong: T, pixels=pixels, depths=depths)["problem"]
        )


@pytest.mark.parametrize("what", ["paths", "words", "arrows"])
def test_a_line_in_a_colour_of_bodies_is_refused(what):
    drawn = {
        "paths": [(np.array([[0.0, 0, 0], [1, 0, 0]]), VIOLET, ())],
        "words": [("here", np.zeros(3), VIOLET)],
        "arrows": [(0, VIOLET, np.zeros((3, 3)))],
    }
    parts = [Part(0, VIOLET, ball(np.zeros(3), 0.1))]
    poses = np.tile(np.eye(4), (3, 1, 1, 1))
    with pytest.raises(TypeError, match="must be a text like '#0072B2'; it is 11"):
        film(parts, poses, [0.0, 1.0, 2.0], "A ball.", **{what: drawn[what]})
