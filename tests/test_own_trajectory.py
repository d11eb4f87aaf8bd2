"""Notebook 4 with a trajectory of your own: one line is changed, and what follows holds for any
file within limits."""

import contextlib
import re
from pathlib import Path

import nbformat
import numpy as np
import pytest

from course_lib import trajectory
from course_lib.arms import iiwa14

NOTEBOOK = Path(__file__).parents[1] / "notebooks" / "04_poe_kuka_iiwa.ipynb"
LINES = "TRAJECTORY = SHIPPED\nVELOCITIES = STEP = None"
# What has nothing to do with the trajectory; without their checks the library's functions take the
# student's place.
SKIPPED = (
    "drawing arm-with toy digits picture newton lost singular challenge drift rodrigues robot "
    "reproduce wrong"
)
USED = ("build-up-toy", "planes-picture", "lissajous-picture", "manipulability-picture")
ARM = iiwa14()


def another_path(n=150, step=0.04):
    """A motion of all joints within their limits, with its exact velocities."""
    t = step * np.arange(n)
    speed, phase = np.linspace(0.4, 1.3, 7), np.arange(7)
    q = 0.6 * ARM.limits[:, 1] * np.sin(np.outer(t, speed) + phase)
    return t, q, 0.6 * ARM.limits[:, 1] * speed * np.cos(np.outer(t, speed) + phase)


def noisy_and_uneven():
    t, q, qd = another_path(120, 0.1)
    rng = np.random.default_rng(5)
    noise, keep = 1e-3 * rng.normal(size=(2, 120, 7)), np.sort(rng.choice(120, 80, replace=False))
    return t[keep] + 7.0, (q + noise[0])[keep], (qd + noise[1])[keep]


def still():
    return 0.1 * np.arange(30), np.tile(ARM.limits[:, 1] / 3, (30, 1)), np.zeros((30, 7))


def run_with(path, velocities=None, step=None):
    """Run the notebook's code with another trajectory; return its names and all alternative
    texts."""
    cells = [c for c in nbformat.read(NOTEBOOK, 4).cells if c.cell_type == "code"]
    assert sum(LINES in cell.source for cell in cells) == 1
    space, told = {"__name__": "notebook"}, []
    for cell in cells:
        graded = cell.metadata.get("nbgrader", {})
        other = any(word in cell.id for word in SKIPPED.split()) and cell.id not in USED
        if graded.get("grade") or (not graded and other):
            continue
        own = (
            f"TRAJECTORY = {str(path)!r}\nVELOCITIES, STEP = {velocities and str(velocities)!r}, "
            f"{step}"
        )
        exec(compile(cell.source.replace(LINES, own), cell.id, "exec"), space)
        if cell.id == "setup":
            space["show"] = lambda picture, alt=None, caption=None: told.append(
                (picture.alt, picture.caption)
            )
    return space, told


def load_cell(lines, written):
    """Run the cell that loads the file, with lines of it replaced: {line: another}, and return its
    names."""
    cells = {cell.id: cell for cell in nbformat.read(NOTEBOOK, 4).cells}
    source = cells["trajectory-load"].source
    for line, other in lines.items():
        assert source.count(line) == 1, line
        source = source.replace(line, other)
    source = source.replace("TRAJECTORY = SHIPPED\n", f"TRAJECTORY = {str(written)!r}\n", 1)
    space = {"trajectory": trajectory, "np": np, "arm": ARM}
    exec(compile(source, "trajectory-load", "exec"), space)
    return space


def film_of(told):
    (film,) = (alt for alt, _ in told if alt.startswith("Moving picture"))
    return film


@pytest.mark.parametrize("made", [noisy_and_uneven, still])
@pytest.mark.filterwarnings("error")
def test_the_notebook_describes_the_student_s_trajectory(made, tmp_path, capsys):
    path = tmp_path / "own.csv"
    trajectory.save(path, trajectory.Trajectory(*made()))
    with contextlib.chdir(NOTEBOOK.parent):
        space, told = run_with(path)
    said = capsys.readouterr().out
    assert not space["shipped"]
    assert len(space["path"]) == len(made()[0])
    x = space["path"][:, 0]
    assert f"x from {x.min():.2f} to {x.max():.2f} m" in film_of(told)
    assert "to a micrometre" not in said
    assert "times and velocities: no disagreement" in said
    assert re.search(r"hybrid +\d\.\d+ +< 1e-9", said)
    assert not any("smallest velocity" in caption for _, caption in told)


def test_a_time_step_that_does_not_fit_two_files_is_reported(tmp_path, capsys):
    motion = trajectory.load(NOTEBOOK.parent / "data/iiwa_trajectory.csv")
    files = [tmp_path / f"{name}.csv" for name in ("positions", "velocities")]
    for file, table in zip(files, (motion.q, motion.qd), strict=True):
        np.savetxt(file, table.T, delimiter=",")
    with contextlib.chdir(NOTEBOOK.parent):
        space, told = run_with(*files, 0.05)
    said = capsys.readouterr().out
    np.testing.assert_array_equal(space["motion"].q, motion.q)
    assert f"{199 * 0.05:.1f} s" in film_of(told)
    assert (
        "times that are 1.26 times as far apart: a mean step of about 0.063 s, not 0.05 s" in said
    )


def test_a_file_beyond_the_limits_is_refused(tmp_path, capsys):
    t, q, qd = another_path()
    q[40, 3] = 2.2
    path = tmp_path / "own.csv"
    trajectory.save(path, trajectory.Trajectory(t, q, qd))
    with contextlib.chdir(NOTEBOOK.parent):
        space, told = run_with(path)
    assert re.search(
        r"refused: own\.csv: row 41, column q4 .*\nFrom here on: data/", capsys.readouterr().out
    )
    assert space["shipped"]
    assert len(told) > 5


def a_few_rows(header, k):
    rows = [
        ",".join([f"{0.1 * i:.1f}", *[f"{0.01 * j + 0.02 * i:.3f}" for j in range(k)]])
        for i in range(4)
    ]
    return "\n".join([header, *rows]) + "\n"


JOINT_NAMES = [f"part_{letter}" for letter in "abcdefg"]
ANSWERS = {
    "joints": (
        a_few_rows("t," + ",".join(JOINT_NAMES), 7),
        'joints=["part_a", "part_b",',
        {"JOINTS = None": f"JOINTS = {JOINT_NAMES}"},
    ),
    "columns": (
        a_few_rows("t," + ",".join([f"left_{i}" for i in range(7)] + [f"right_{i}" for i in range(7)]), 14),
        'columns={"q": "left_*"}',
        {"COLUMNS = None": 'COLUMNS = {"q": "left_*"}'},
    ),
    "units": (
        a_few_rows("t," + ",".join(f"q{i + 1}" for i in range(7)), 7).replace("0.1,", "100,").replace("0.2,", "200,")
        .replace("0.3,", "300,"),
        'units={"t": "s"}',
        {"UNITS = None": 'UNITS = {"t": "ms"}'},
    ),
    "step": (
        a_few_rows("row," + ",".join(f"q{i + 1}" for i in range(7)), 7),
        "step=0.01",
        {"VELOCITIES = STEP = None": "VELOCITIES, STEP = None, 0.1"},
    ),
}  # fmt: skip


@pytest.mark.parametrize("question", ANSWERS)
def test_the_cell_has_a_line_for_each_answer(question, tmp_path, capsys):
    text, asked, lines = ANSWERS[question]
    (tmp_path / "own.csv").write_text(text)
    with contextlib.chdir(NOTEBOOK.parent):
        assert load_cell({}, tmp_path / "own.csv")["shipped"]
        said = capsys.readouterr().out
        assert said.startswith("not clear: own.csv")
        assert asked in said
        space = load_cell(lines, tmp_path / "own.csv")
    assert not space["shipped"]
    np.testing.assert_allclose(space["motion"].q[:, 6], 0.06 + 0.02 * np.arange(4))
    np.testing.assert_allclose(space["motion"].t, 0.1 * np.arange(4))


def test_a_file_of_six_joints_is_refused_with_both_numbers(tmp_path, capsys):
    (tmp_path / "own.csv").write_text(a_few_rows("t," + ",".join(f"q{i + 1}" for i in range(6)), 6))
    with contextlib.chdir(NOTEBOOK.parent):
        assert load_cell({}, tmp_path / "own.csv")["shipped"]
    assert "this file has 6 joints, but the iiwa has 7" in capsys.readouterr().out


def test_the_cell_says_which_column_each_joint_came_from(tmp_path, capsys):
    (tmp_path / "own.csv").write_text(
        a_few_rows("t," + ",".join(f"lbr_joint_{i}" for i in range(7)), 7)
    )
    with contextlib.chdir(NOTEBOOK.parent):
        load_cell({}, tmp_path / "own.csv")
    said = capsys.readouterr().out
    assert "q7: 'lbr_joint_6', no unit in the header, 3.4 to 6.9 degrees" in said
    assert "times and velocities: no disagreement" in said


def test_a_file_that_is_not_there_is_said_in_a_line(tmp_path, capsys):
    with contextlib.chdir(NOTEBOOK.parent):
        assert load_cell({}, tmp_path / "none.csv")["shipped"]
    assert "refused: " in capsys.readouterr().out
