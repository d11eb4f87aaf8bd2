"""holding_torques: the joint torques that hold a load still."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.poe_kuka_iiwa.shared import (
    KUKA,
    KUKA_HOME,
    TWO,
    at,
    axes,
    drawn_axes,
    jacobian,
    tool_pose,
)
from course_lib.checks.vocabulary import any_pose, away_from_zero, few_digits, near, negated
from course_lib.rigid import adjoint, inverse

G = 9.81  # m/s^2
_WRENCH = Mistake("a wrench is returned", "Asked for is one torque for each joint.")


def _cases(rng):
    # Axes along -y, links along x.
    upright = np.hstack([TWO[:, [0, 2, 1]] * [1, -1, 1], TWO[:, [3, 5, 4]] * [1, 1, -1]])
    arm = (KUKA, KUKA_HOME)
    drawn = [
        (axes(*drawn_axes(rng, n)), any_pose(rng), away_from_zero(rng, n), rng.uniform(1, 5), away_from_zero(rng, 3))
        for n in (2, 4, 5, 7)
    ]
    return [
        (upright, at(2, 0, 0), np.zeros(2), 1.0, np.zeros(3)),
        (upright, at(2, 0, 0), np.array([0.4, 0.5]), 2.0, np.array([0.1, 0, 0])),
        (*arm, np.array([0.3, 0.7, -0.4, 1.1, 0.5, 0.9, 0.2]), 10.0, np.array([0.02, -0.05, 0.1])),
        *drawn,
        (*arm, np.zeros(7), 10.0, np.array([0.1, 0.2, 0.05])),
    ]


def _wrench(screws, M, q, mass, center):
    """The weight as the base sees it."""
    T, f = tool_pose(screws, M, q), np.array([0, 0, -mass * G])
    return np.append(np.cross(T[:3, :3] @ center + T[:3, 3], f), f)


def _right(screws, M, q, mass, center):
    return -jacobian(screws, q).T @ _wrench(screws, M, q, mass, center)


def _by_wrench(wrench):
    """The torques of somebody who has another wrench: wrench(p of the load, T, f)."""

    def answer(screws, M, q, mass, center):
        T, f = tool_pose(screws, M, q), np.array([0, 0, -mass * G])
        return -jacobian(screws, q).T @ wrench(T[:3, :3] @ center + T[:3, 3], T, f, center)

    return answer


def _seen(tau, *case):
    right = _right(*case)
    i = int(np.argmax(np.abs(tau - right)))
    return f"Joint {i + 1} needs {right[i]:.4g} N m; yours is {tau[i]:.4g} N m."


EXERCISE = Exercise(
    name="holding_torques",
    points=3,
    arguments=("screws", "M", "q", "mass", "center"),
    cases=_cases,
    returns=numbers(
        lambda screws, M, q, mass, center: (len(q),),
        lambda array, screws, *rest: _WRENCH if array.shape == (6,) else None,
    ),
    properties=(
        Property(
            "the torques hold the load: their work in a small motion is the energy that the load gains",
            lambda tau, *case: near(tau, _right(*case)),
            says=_seen,
        ),
    ),
    mistakes=(
        few_digits(_right),
        negated(
            _right,
            "the torques have their sign changed: they are those that the load exerts",
            "To lift a load costs work. Which sign has the torque of a joint that lifts it?",
        ),
        Mistake(
            "the weight acts at the end-effector's origin, not at the center of mass",
            "The center of mass is given in the end-effector's frame: where is it, seen from the base?",
            lambda S, M, q, mass, center: _right(S, M, q, mass, 0 * center),
        ),
        Mistake(
            "the center of mass is taken for a position in the base frame",
            "It is known in the end-effector's frame: where is it, seen from the base?",
            _by_wrench(lambda p, T, f, c: np.append(np.cross(c, f), f)),
        ),
        Mistake(
            "the torques are multiplied by the angles",
            "The angles only say where the axes are.",
            lambda *case: _right(*case) * case[2],
        ),
        Mistake(
            "the center of mass is added without rotating it",
            "It is known along the end-effector's axes.",
            _by_wrench(lambda p, T, f, c: np.append(np.cross(T[:3, 3] + c, f), f)),
        ),
        Mistake(
            "the moment of the weight is left out",
            "A force at p has the moment p x f about the base's origin.",
            _by_wrench(lambda p, T, f, c: np.append(0 * f, f)),
        ),
        Mistake(
            "the moment of the weight has its sign changed",
            "The moment is p x f, in this order.",
            _by_wrench(lambda p, T, f, c: np.append(np.cross(f, p), f)),
        ),
        Mistake(
            "the force stands before the moment",
            "Wrenches are (m, f), as twists are (omega, v).",
            _by_wrench(lambda p, T, f, c: np.append(f, np.cross(p, f))),
        ),
        Mistake(
            "the weight points along the end-effector's z axis, not down",
            "Gravity is along the base's -z, whatever the arm does.",
            _by_wrench(lambda p, T, f, c: np.append(np.cross(p, T[:3, :3] @ f), T[:3, :3] @ f)),
            _by_wrench(lambda p, T, f, c: adjoint(inverse(T)).T @ np.append(np.cross(c, f), f)),
        ),
        Mistake(
            "gravity is missing, or is another number",
            "The weight is mass times 9.81 m/s^2.",
            lambda *case: _right(*case) / G,
            lambda *case: _right(*case) * 9.8 / G,
            lambda *case: _right(*case) * 9.80665 / G,
            lambda *case: _right(*case) * 10 / G,
        ),
        Mistake(
            "mass is left out",
            "The weight is mass times 9.81 m/s^2.",
            lambda S, M, q, mass, center: _right(S, M, q, 1.0, center),
        ),
        Mistake(
            "the wrench of the base frame is used with the body Jacobian, or the body wrench with the space Jacobian",
            "A Jacobian's transpose takes the wrench seen from the same frame as its columns.",
            lambda S, M, q, mass, center: (
                (adjoint(inverse(tool_pose(S, M, q))) @ jacobian(S, q)).T @ -_wrench(S, M, q, mass, center)
            ),
        ),
        Mistake(
            "the load is placed as if the arm were at home",
            "Where is the end-effector at these angles?",
            lambda S, M, q, mass, center: -jacobian(S, q).T @ _wrench(S, M, 0 * q, mass, center),
        ),
        Mistake(
            "the screw axes are left as they are at home",
            "The joints before have moved them: that is what the Jacobian says.",
            lambda S, M, q, mass, center: -S @ _wrench(S, M, q, mass, center),
        ),
        Mistake(
            "gravity pulls along y",
            "Gravity is along the base's -z.",
            _by_wrench(lambda p, T, f, c: np.append(np.cross(p, f[[0, 2, 1]]), f[[0, 2, 1]])),
        ),
    ),
    hints=(
        "Three steps: where is the center of mass, seen from the base? What wrench (m, f) is the weight, seen from the "
        "base? Which torques balance it?",
        "A motion with joint velocities q' lets the weight do the power F_s . (J_s q'). The joints' power is "
        "tau . q'. Held still, the two add up to 0 for every q'.",
        "So tau is minus the transpose of the space Jacobian, times F_s; and F_s is (p x f, f), f = (0, 0, -9.81 "
        "mass).",
    ),
    library=_right,
)
