"""The public data of notebook 4: a trajectory with late velocities, and targets in reach and beyond
it."""

import contextlib
from pathlib import Path

import nbformat
import numpy as np
import pytest
from scipy.interpolate import CubicSpline
from scipy.optimize import least_squares, minimize

from course_lib import trajectory
from course_lib.arms import iiwa14

NOTEBOOK = Path(__file__).parents[1] / "notebooks" / "04_poe_kuka_iiwa.ipynb"
DATA = NOTEBOOK.parent / "data"
ARM = iiwa14()
LOW, HIGH = ARM.limits.T
MOTION = trajectory.load(DATA / "iiwa_trajectory.csv", ARM.limits)
WANTED = np.array([1, 1, -1, -1, 1, 1, 1.0])


@pytest.mark.parametrize("name", ["iiwa_trajectory.csv", "iiwa_targets.csv"])
def test_each_data_file_names_its_source_and_licence(name):
    comments = [line for line in (DATA / name).read_text().splitlines() if line.startswith("#")]
    header = " ".join(comments)
    for words in ("righetti/ROB6003", "Copyright (c) 2021 Ludovic Righetti", "BSD 3-Clause"):
        assert words in header
    assert "iiwa_LICENSE.txt" in header
    licence = (DATA / "iiwa_LICENSE.txt").read_text()
    assert name in licence
    assert "Redistributions of source code must retain the above copyright notice" in licence
    assert "THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS" in licence


def test_the_end_effector_is_within_1_mm_of_the_text_s_curve():
    t = MOTION.t
    x, y, z = 0.1 * np.sin(2 * t) - 0.5, 0.1 * np.sin(t) + 0.5, 0.2 * np.cos(t) + 0.3
    path = ARM.fk(MOTION.q)[:, :3, 3]
    np.testing.assert_allclose(path, np.stack([x, y, z], -1), rtol=0, atol=1e-3)


def test_the_velocities_are_half_a_step_late():
    derivative = CubicSpline(MOTION.t, MOTION.q).derivative()
    at_their_rows = np.abs(MOTION.qd[1:] - derivative(MOTION.t[1:])).max()
    half_before = np.abs(MOTION.qd[1:] - derivative((MOTION.t[1:] + MOTION.t[:-1]) / 2)).max()
    assert half_before < 0.25 * at_their_rows
    assert not MOTION.qd[0].any()
    said = trajectory.disagreement(MOTION)
    assert "differences with the sample before" in said
    assert "the first row is zero" in said


# ---- ten targets ----


def smallest_error(target, seed):
    """Return the angles within the limits that are nearest to a target from one of six starts."""
    starts = np.random.default_rng(seed).uniform(LOW, HIGH, (6, 7))
    solutions = [
        least_squares(
            lambda q: ARM.fk(q)[:3, 3] - target,
            start,
            jac=ARM.position_jacobian,
            bounds=(LOW, HIGH),
            xtol=1e-12,
            ftol=1e-12,
            gtol=1e-12,
        )
        for start in starts
    ]
    return min(np.linalg.norm(solution.fun) for solution in solutions)


def damped(target, q0, steps=1500):
    """A right answer to the challenge: damped steps, and near the target the null space."""
    q = q0
    for _ in range(steps):
        J = ARM.position_jacobian(q)
        error = target - ARM.fk(q)[:3, 3]
        damping = 0.5 * np.linalg.norm(error)  # none at the target, much beyond reach
        step = 0.3 * J.T @ np.linalg.solve(J @ J.T + damping * np.eye(3), error)
        if np.linalg.norm(error) < 0.01:
            step = step + 0.1 * (np.eye(7) - np.linalg.pinv(J) @ J) @ (WANTED - q)
        q = np.clip(q + step, LOW, HIGH)
    return q


@pytest.fixture(scope="module")
def cells():
    """The names of the notebook's cells on the ten targets."""
    space = {"np": np, "arm": ARM}
    sources = {cell.id: cell.source for cell in nbformat.read(NOTEBOOK, 4).cells}
    with contextlib.chdir(NOTEBOOK.parent):
        for name in ("targets-code", "targets-bring", "targets-score"):
            exec(compile(sources[name], name, "exec"), space)
    return space


def test_no_solver_comes_nearer_than_the_shoulder_s_sphere(cells):
    found = [smallest_error(target, k) for k, target in enumerate(cells["targets"])]
    np.testing.assert_allclose(found, cells["beyond"], rtol=0, atol=1e-6)


def test_damped_steps_and_the_null_space_win_the_challenge(cells):
    score = cells["score_of_targets"](damped)
    assert score.startswith("100 of 100"), score


def test_the_given_function_does_not_win_it(cells):
    assert cells["score_of_targets"](cells["bring"]).startswith("36 of 100: 6 of 10 nearest, 0 of")


def test_without_null_space_gain_the_distance_is_a_minimum(cells):
    for target in cells["targets"][cells["beyond"] == 0]:
        q = damped(target, np.array([0.1, 0.5, -0.1, -1, 0.1, 0.5, 0.1]))
        nearest = minimize(
            lambda at: np.sum((at - WANTED) ** 2),
            q,
            jac=lambda at: 2 * (at - WANTED),
            bounds=ARM.limits,
            constraints={
                "type": "eq",
                "fun": lambda at, target=target: ARM.fk(at)[:3, 3] - target,
                "jac": ARM.position_jacobian,
            },
            method="SLSQP",
        )
        assert nearest.success
        assert np.linalg.norm(q - WANTED) < np.sqrt(nearest.fun) + 1e-3
