"""Compute a joint trajectory of the iiwa with exact velocities.

`make data` runs this.

The velocities of the file that notebook 4 comes with are differences of its positions and lag half
a step. Those computed here are exact, for comparison: notebook 4 reads this file as it reads any
other.

The end-effector follows a given curve twice. The curve determines three of the seven degrees of
freedom; the smallest joint velocity at every instant, q' = J^+ p', determines the others. This is a
differential equation for q, and its right side is the velocity that is stored with each sample.
"""

import argparse
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike
from scipy.integrate import solve_ivp

from course_lib.arms import iiwa14
from course_lib.trajectory import Trajectory, save

FILE = Path("build/data/iiwa_trajectory.csv")
TIMES = 2 * np.pi * np.arange(200) / 100  # seconds: two rounds
# Radians: the configuration at time 0 is the solution that Newton's method finds from this one.
NEAR = np.array([2.3, 0.3, 0.2, -1.9, 0.1, 0.9, 0.0])
# Metres by which the end-effector may leave the curve; the integration below is 100 times as exact.
MAX_ERROR = 1e-9


def end_effector(t: ArrayLike) -> np.ndarray:
    """Return the positions (..., 3) of the end-effector in metres at times (...) in seconds."""
    return np.stack([-0.5 + 0.1 * np.sin(2 * t), 0.5 + 0.1 * np.sin(t), 0.3 + 0.2 * np.cos(t)], -1)


def end_effector_velocity(t: ArrayLike) -> np.ndarray:
    """Return the derivative of `end_effector`, metres per second."""
    return np.stack([0.2 * np.cos(2 * t), 0.1 * np.cos(t), -0.2 * np.sin(t)], -1)


def iiwa_trajectory() -> Trajectory:
    """Return the joint trajectory of the iiwa that follows the curve twice.

    Raises RuntimeError if the end-effector leaves the curve, or a joint its limits.
    """
    arm = iiwa14()

    def velocity(t: float, q: np.ndarray) -> np.ndarray:
        return np.linalg.pinv(arm.position_jacobian(q)) @ end_effector_velocity(t)

    q0 = NEAR
    for _ in range(50):
        error = end_effector(0.0) - arm.fk(q0)[:3, 3]
        q0 = q0 + np.linalg.pinv(arm.position_jacobian(q0)) @ error
    solved = solve_ivp(velocity, (0, TIMES[-1]), q0, "DOP853", t_eval=TIMES, rtol=1e-11, atol=1e-12)
    q = solved.y.T
    error = np.abs(arm.fk(q)[:, :3, 3] - end_effector(TIMES)).max()
    inside = ((q > arm.limits[:, 0]) & (q < arm.limits[:, 1])).all()
    if error > MAX_ERROR or not inside:
        raise RuntimeError(
            f"the trajectory is not valid: {error:.1e} m off the curve, inside the limits: {inside}"
        )
    qd = np.array([velocity(t, at) for t, at in zip(TIMES, q, strict=True)])
    return Trajectory(TIMES, _rounded(q), _rounded(qd))


def _rounded(values: np.ndarray) -> np.ndarray:
    """Return values with as many decimals as are saved."""
    # + 0.0 makes 0.0 of -0.0, because its sign differs between machines.
    return np.round(values, 10) + 0.0


def main(arguments: Sequence[str] | None = None) -> None:
    """Write the trajectory, and say how notebook 4 reads it."""
    argparse.ArgumentParser(
        prog="python -m course_lib.pack.authors.data",
        description=f"Compute the iiwa's joint trajectory and write {FILE}. It takes a few "
        "seconds.",
        epilog="example: make data",
    ).parse_args(arguments)
    FILE.parent.mkdir(parents=True, exist_ok=True)
    save(FILE, iiwa_trajectory())
    print(f"{FILE}: {len(TIMES)} samples. Give this name to trajectory.load in notebook 4.")


if __name__ == "__main__":
    main()
