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
LINE = 'TRAJECTORY = "data/iiwa_trajectory.csv"'
# What has nothing to do with the trajectory; without their checks the library's functions take the student's place.
SKIPPED = ("drawing", "toy", "digits", "screw-picture", "rodrigues", "challenge", "drift", "wrong", "back")
ARM = iiwa14()


def another_path(n=150, step=0.04):
    """A motion of all joints within their limits, with its exact velocities."""
    t = step * np.arange(n)
    speed, phase = np.linspace(0.4, 1.3, 7), np.arange(7)
    q = 0.6 * ARM.limits[:, 1] * np.sin(np.outer(t, speed) + phase)
    return t, q, 0.6 * ARM.limits[:, 1] * speed * np.cos(np.outer(t, speed) + phase)


def backward_differences():
    t, q, _ = another_path(120, 0.05)
    return t, q, np.vstack([np.zeros(7), np.diff(q, axis=0) / np.diff(t)[:, None]])


def noisy():
    t, q, qd = another_path(80, 0.1)
    rng = np.random.default_rng(5)
    return t + 7.0, q + 1e-3 * rng.normal(size=q.shape), qd + 1e-3 * rng.normal(size=q.shape)


def fast_and_uneven():
    t, q, qd = another_path(300, 0.01)
    keep = np.sort(np.random.default_rng(6).choice(300, 200, replace=False))
    return t[keep], q[keep], qd[keep]


def run_with(path):
    """Run the notebook's code with another trajectory; return its names and all alternative texts."""
    cells = [c for c in nbformat.read(NOTEBOOK, 4).cells if c.cell_type == "code"]
    assert sum(LINE in cell.source for cell in cells) == 1
    space, told = {"__name__": "notebook"}, []
    for cell in cells:
        graded = cell.metadata.get("nbgrader", {})
        if graded.get("grade") or (not graded and any(word in cell.id for word in SKIPPED)):
            continue
        source = cell.source.replace(LINE, f"TRAJECTORY = {str(path)!r}")
        exec(compile(source, cell.id, "exec"), space)
        if cell.id == "setup":
            space["show"] = lambda picture, alt=None, caption=None: told.append(alt or picture.alt)
    return space, told


@pytest.mark.parametrize("made", [backward_differences, noisy, fast_and_uneven])
def test_the_notebook_runs_with_another_trajectory_and_tells_of_that_one(made, tmp_path, capsys):
    path = tmp_path / "own.csv"
    trajectory.save(path, trajectory.Trajectory(*made()))
    with contextlib.chdir(NOTEBOOK.parent):
        space, told = run_with(path)
    said = capsys.readouterr().out
    assert not space["shipped"]
    assert len(space["path"]) == len(made()[0])
    (film,) = (alt for alt in told if alt.startswith("Moving picture"))
    x = space["path"][:, 0]
    assert f"x from {x.min():.2f} to {x.max():.2f} m" in film
    assert "to a micrometre" not in said
    assert re.search(r"hybrid +\d\.\d+ +< 1e-9", said)


def test_a_file_beyond_the_limits_is_refused_by_the_line_that_reads_it(tmp_path):
    t, q, qd = another_path()
    q[40, 3] = 2.2
    path = tmp_path / "own.csv"
    trajectory.save(path, trajectory.Trajectory(t, q, qd))
    with contextlib.chdir(NOTEBOOK.parent), pytest.raises(ValueError, match="row 41, column q4"):
        run_with(path)
