"""Notebook 4 with a trajectory of your own: one line is changed, and what follows holds for any file within limits."""

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
    """Run the notebook's code with another trajectory; return its names and all alternative texts."""
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


def film_of(told):
    (film,) = (alt for alt, _ in told if alt.startswith("Moving picture"))
    return film


@pytest.mark.parametrize("made", [noisy_and_uneven, still])
@pytest.mark.filterwarnings("error")
def test_the_notebook_runs_with_another_trajectory_and_tells_of_that_one(made, tmp_path, capsys):
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


def test_positions_and_velocities_of_two_files_and_a_time_step_that_does_not_fit_is_said(
    tmp_path, capsys
):
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


def test_a_file_beyond_the_limits_is_refused_and_the_course_s_own_is_shown(tmp_path, capsys):
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
