"""What `make bench` makes of its measurements: ratios, promises kept or not, peers left out."""

import numpy as np
import pytest
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

from course_lib import rotations
from course_lib.arms import panda
from course_lib.pack.bench import kinematics, notebook_times, peers, picture, rotation_maps
from course_lib.pack.bench.measure import Contestant, Outcome, Task, duration, measured, table
from course_lib.pack.bench.notebook_times import import_only

LIBRARY = Contestant("course_lib", lambda x: 2 * x)


def outcome(*seconds, **promises):
    contestants = [LIBRARY, *(Contestant(f"peer {i}", LIBRARY.run, **promises) for i in range(1, len(seconds)))]
    task = Task("Twice", np.arange(3.0), contestants)
    return Outcome(task, {c.name: list(times) for c, times in zip(contestants, seconds, strict=True)})


def test_the_table_gives_times_and_the_librarys_share_of_each():
    lines = table(outcome([2e-6, 1e-6, 4e-6], [4e-3, 8e-3, 5e-3], at_most=0.5))
    assert lines[0] == "Twice"
    assert lines[2].split() == ["course_lib", "1", "us", "2", "us"]
    assert lines[3].split()[:9] == ["peer", "1", "4", "ms", "5", "ms", "0.00025", "x", "(0.0004"]
    assert lines[3].endswith("at most 0.5: 0.00025 yes")


@pytest.mark.parametrize(("seconds", "word"), [(0.999, "yes"), (1.0, "yes"), (1.001, "NO")])
def test_a_promise_that_is_not_kept_is_shown(seconds, word):
    assert table(outcome([seconds], [2.0], at_most=0.5))[3].endswith(word)
    assert "at most" not in table(outcome([seconds], [2.0]))[3]


def test_durations_have_three_digits_and_a_unit():
    assert [duration(s) for s in (12.345, 0.012345, 1.2e-5, 3.456e-8)] == ["12.3 s", "12.3 ms", "12 us", "34.6 ns"]


def test_libraries_alternate_and_each_gets_the_items_it_can_bear():
    calls = []

    def counted(name):
        def run(items):
            calls.append((name, len(items)))
            np.sort(np.random.default_rng(0).random(2_000_000))  # longer than a measurement lasts at least
            return items

        return run

    names = [Contestant("a", counted("a")), Contestant("b", counted("b"), items=2)]
    result = measured(Task("turns", np.arange(5.0), names, agree=1), repeats=3)
    assert [len(times) for times in result.seconds.values()] == [3, 3]
    assert calls[-6:] == 3 * [("a", 5), ("b", 2)]
    # A call of b is for two items, of a for five.
    assert 1.2 < np.median(result.seconds["b"]) / np.median(result.seconds["a"]) < 6


def test_a_library_that_gives_another_answer_is_not_measured():
    near, far = Contestant("near", lambda x: 2 * x + 5e-10), Contestant("far", lambda x: 2 * x + 1e-8)
    other = Contestant("other shape", lambda x: x[:, None])
    nan = Contestant("nan", lambda x: x * np.nan)
    turned = Contestant("turned", lambda x: -2 * x, convert=np.negative)
    result = measured(Task("Twice", np.arange(3.0), [LIBRARY, near, far, other, nan, turned]), repeats=1)
    assert set(result.seconds) == {"course_lib", "near", "turned"}
    lines = {line.strip()[:12].strip(): line for line in table(result)}
    assert lines["far"].endswith("not measured: it differs by 1e-08")
    assert "not measured" in lines["other shape"]
    assert "not measured" in lines["nan"]


# ---- peers ----


def test_a_peer_that_is_not_here_is_left_out_with_its_reason(tmp_path, monkeypatch):
    (tmp_path / "broken_peer.py").write_text("raise RuntimeError('made for an older numpy')")
    monkeypatch.syspath_prepend(tmp_path)
    left_out = tmp_path / "left-out"
    left_out.write_text("absent-peer==1.2: The packages could not be downloaded: no network.\n")
    names = {"numpy": "numpy", "absent_peer": "absent-peer", "broken_peer": "broken-peer", "gone_peer": "gone"}
    here, missing = peers.load(names, left_out)
    assert here == {"numpy": np}
    assert missing["absent_peer"] == "The packages could not be downloaded: no network."
    assert missing["broken_peer"] == "RuntimeError: made for an older numpy"
    assert "gone_peer" in missing["gone_peer"]
    assert peers.load({"numpy": "numpy"}, tmp_path / "no such file") == ({"numpy": np}, {})


def test_without_any_peer_the_library_is_measured_alone():
    many = kinematics.poses({}, 20), kinematics.poses_and_jacobians({}, 20)
    for task in (*many, kinematics.single_pose({}), kinematics.single_target({}, 5)):
        assert [c.name for c in task.contestants] == ["course_lib"]
        assert list(measured(task, repeats=1).seconds) == ["course_lib"]
    task, reached = kinematics.inverse({}, 30)
    assert "30 of 30 within 1e-6 m, 1e-6 rad and the limits" in reached[0]
    tasks, exact = rotation_maps.tasks({}, 20)
    assert len(tasks) == len(exact) == 4


def test_scipy_is_compared_if_it_is_installed():
    tasks, exact = rotation_maps.tasks({"scipy": object()}, 200)
    for task in tasks:
        assert list(measured(task, repeats=1).seconds) == ["course_lib", "scipy"]
    assert len(exact) == 8
    assert not any("loses digits" in line for line in exact)


def test_a_map_that_loses_digits_near_pi_binds_nobody(monkeypatch):
    def textbook(R):
        angle = np.arccos((np.trace(R, axis1=-2, axis2=-1) - 1) / 2)[:, None]
        w = np.stack([R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]], -1)
        return angle * w / (2 * np.sin(angle))

    ways = rotation_maps.rotation_maps_of({}) | {"textbook": {"log": (textbook, None)}}
    monkeypatch.setattr(rotation_maps, "rotation_maps_of", lambda here: ways)
    tasks, exact = rotation_maps.tasks({}, 50)
    assert next(line for line in exact if "textbook" in line).endswith("loses digits")
    assert tasks[1].contestants[1].at_most is None


def test_the_hard_rotations_are_right():
    w, R, q = rotation_maps.hard_cases()
    assert np.abs(rotations.quaternion_to_matrix(q) - R).max() < 1e-14
    assert np.linalg.norm(w, axis=-1).min() < 1e-15
    assert np.linalg.norm(w, axis=-1).max() == pytest.approx(np.pi, abs=1e-15)


def test_success_means_that_the_target_is_reached():
    q = panda().limits.mean(-1) + np.zeros((3, 7))
    targets = panda().fk(q)
    targets[1, 0, 3] += 2e-6
    q[2, 0] = 100
    solved, left = kinematics._solved(q, targets)
    assert solved.tolist() == [True, False, False]
    assert left[1] == pytest.approx(2e-6)


# ---- the picture ----


def curve(*seconds):
    return 10 ** np.arange(len(seconds)), np.array(seconds, float)


@pytest.mark.parametrize(
    ("batch", "loop", "size"),
    [
        (curve(100, 10, 1), curve(10, 10), 10),
        (curve(100, 1, 1), curve(10, 10, 10), 3),  # halfway on the logarithmic axis: 3.16
        (curve(5, 1), curve(10, 10), 1),
        (curve(100, 50), curve(10, 10), None),
    ],
)
def test_from_which_size_a_batch_pays(batch, loop, size):
    assert picture.pays_from({"batch": batch, "loop": loop}, "batch", "loop") == size


def test_the_picture_is_drawn(tmp_path):
    curves = {"course_lib, one batch": curve(3e-5, 4e-6, 1e-6), "pinocchio, Python loop": curve(2e-6, 2e-6)}
    picture.draw(curves, {"pinocchio, Python loop": 42}, tmp_path / "cost.png")
    assert (tmp_path / "cost.png").read_bytes().startswith(b"\x89PNG")


def test_a_notebook_of_imports_alone_holds_each_import_once_and_nothing_else():
    cells = ["import json\nfrom pathlib import Path\nx = 1", "import json\nprint(x)", "def f():\n    import os"]
    book = new_notebook(cells=[new_markdown_cell("# Words"), *map(new_code_cell, cells)])
    (cell,) = import_only(book).cells
    assert cell.source == "import json\nfrom pathlib import Path"
    assert len(book.cells) == 4


def test_the_notebooks_share_and_their_slowest_cells_are_told(monkeypatch):
    output = "3.00s call     notebooks/05_panda_dh_ik.ipynb::Cell 34\n1.00s setup    notebooks/06.ipynb::Cell 0\n"

    def nbval(books):
        return (7.0, output) if "robot" in books[0].read_text(encoding="utf-8") else (2.0, "")

    monkeypatch.setattr(notebook_times, "_nbval", nbval)
    lines = notebook_times.notebook_times(repeats=1)
    assert lines[2] == "  3.5 x   at most 2.5: 3.5 NO"
    assert lines[4:] == ["     3.0 s  05_panda_dh_ik.ipynb::Cell 34", ""]
