"""holding_torques: the joint torques that hold a load still."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake
from course_lib.checks.special_cases import SMALL_NUMBERS, Sweep
from course_lib.checks.vocabulary import any_pose, away_from_zero, part_is
from course_lib.lessons.poe_kuka_iiwa.exercises import shared
from course_lib.rigid import adjoint, inverse

G = 9.81  # m/s^2
_WRENCH = Mistake("a wrench is returned", "The task asks for one torque for each joint.")


# Axes along -y, links along x.
_UPRIGHT = np.hstack([shared.TWO[:, [0, 2, 1]] * [1, -1, 1], shared.TWO[:, [3, 5, 4]] * [1, 1, -1]])


def _cases(rng):
    arm = (shared.KUKA, shared.KUKA_HOME)
    drawn = [
        (
            shared.axes(*shared.drawn_axes(rng, n)),
            any_pose(rng),
            away_from_zero(rng, n),
            rng.uniform(1, 5),
            away_from_zero(rng, 3),
        )
        for n in (2, 4, 5, 7)
    ]
    return [
        (_UPRIGHT, shared.at(2, 0, 0), np.zeros(2), 1.0, np.zeros(3)),
        (_UPRIGHT, shared.at(2, 0, 0), np.array([0.4, 0.5]), 2.0, np.array([0.1, 0, 0])),
        (*arm, np.array([0.3, 0.7, -0.4, 1.1, 0.5, 0.9, 0.2]), 10.0, np.array([0.02, -0.05, 0.1])),
        *drawn,
        (*arm, np.zeros(7), 10.0, np.array([0.1, 0.2, 0.05])),
    ]


def _nearly_zero(rng, size):
    return *shared.SMALL_ANGLES.case(rng, size), rng.uniform(1, 5), away_from_zero(rng, 3)


def _light(rng, mass):
    return _UPRIGHT, shared.at(2, 0, 0), away_from_zero(rng, 2), mass, away_from_zero(rng, 3)


def _nearly_upright(rng, size):
    """The arm stands upright but for small angles: the light load's lever is short."""
    q = np.array([np.pi / 2 - size, 0.6 * size])
    return _UPRIGHT, shared.at(2, 0, 0), q, rng.uniform(0.05, 0.1), np.zeros(3)


def _weight(screws, M, q, mass, center):
    """Return the wrench of the load's weight, as the base sees it."""
    T, f = shared.tool_pose(screws, M, q), np.array([0, 0, -mass * G])
    return np.append(np.cross(T[:3, :3] @ center + T[:3, 3], f), f)


def _right(screws, M, q, mass, center):
    return -shared.jacobian(screws, q).T @ _weight(screws, M, q, mass, center)


EXERCISE = Exercise(
    name="holding_torques",
    points=3,
    arguments=("screws", "M", "q", "mass", "center"),
    cases=_cases,
    returns=numbers(
        lambda screws, M, q, mass, center: (len(q),),
    ),
    library=_right,
    sweeps=(
        Sweep("an angle is nearly 0", _nearly_zero, shared.SMALL_ANGLES.values),
        Sweep("a load of little mass", _light, SMALL_NUMBERS),
        Sweep("a load nearly above the joints", _nearly_upright, shared.SMALL_ANGLES.values),
    ),
    angles=("q",),
    properties=(
        part_is(
            "the torques hold the load: their work in a small motion is the energy that it gains",
            _right,
            ...,
            Mistake(
                "these torques do not hold the load",
                "How large is the weight of the load, in which direction does it pull, and "
                "where is "
                "its center of mass at these angles, all seen from the base? Which matrix takes a "
                "wrench to joint torques?",
            ),
        ),
    ),
    hints=(
        "Three steps: where is the center of mass, seen from the base? What wrench (m, f) is the "
        "weight, seen from the "
        "base? Which torques balance it?",
        "A motion with joint velocities q' lets the weight do the power F_s . (J_s q'). The "
        "joints' power is "
        "tau . q'. Held still, the two add up to 0 for every q'.",
        "So tau is minus the transpose of the space Jacobian, times F_s; and F_s is (p x f, f), f "
        "= (0, 0, -9.81 "
        "mass).",
    ),
)

EXERCISE.mistake(_WRENCH, form=lambda array, screws, *rest: array.shape == (6,))


def _by(screws, M, q, mass, center, wrench):
    """Return the torques of somebody who has another wrench: (m, f) = wrench(p of the load, T,
    f)."""
    T, f = shared.tool_pose(screws, M, q), np.array([0, 0, -mass * G])
    return -shared.jacobian(screws, q).T @ np.concatenate(
        wrench(T[:3, :3] @ center + T[:3, 3], T, f)
    )


@EXERCISE.mistake(
    "the center of mass is not rotated into the base's axes",
    "In which frame is `center` given?",
    origin=(0, 1),
)
def center_not_rotated(screws, M, q, mass, center, origin):
    return _by(
        screws, M, q, mass, center, lambda p, T, f: (np.cross(origin * T[:3, 3] + center, f), f)
    )


@EXERCISE.mistake(
    "the moment of the weight is missing, or has the wrong sign",
    "Which moment does a force at the point p have about the base's origin?",
    factor=(0, -1),
)
def moment(*case, factor):
    return _by(*case, lambda p, T, f: (factor * np.cross(p, f), f))


@EXERCISE.mistake(
    "the torques are those that the weight exerts on the joints",
    "Which torques of the motors balance the torques of the weight?",
)
def torques_of_the_weight(*case):
    return -_right(*case)


@EXERCISE.mistake(
    "the force stands above the moment in the wrench",
    "In which order are the halves of a twist, and so the rows of the space Jacobian?",
)
def force_first(*case):
    return _by(*case, lambda p, T, f: (f, np.cross(p, f)))


@EXERCISE.mistake(
    "the Jacobian and the wrench are seen from two different frames",
    "From which frame is your Jacobian seen, and from which frame is your wrench seen?",
)
def body_jacobian_with_a_space_wrench(screws, M, q, mass, center):
    T = shared.tool_pose(screws, M, q)
    body = adjoint(inverse(T)) @ shared.jacobian(screws, q)
    return -body.T @ _weight(screws, M, q, mass, center)


@EXERCISE.mistake(
    "an inverse of the Jacobian takes the wrench to the torques",
    "The joints' power equals the power at the load. Which matrix follows from that?",
)
def inverse_for_the_transpose(screws, M, q, mass, center):
    wrench = _weight(screws, M, q, mass, center)
    return -np.linalg.pinv(shared.jacobian(screws, q)) @ wrench


@EXERCISE.mistake(
    "the load hangs at the end-effector's origin",
    "Where does your code use `center`?",
)
def load_at_the_end_effector(screws, M, q, mass, center):
    return _right(screws, M, q, mass, 0 * center)


@EXERCISE.mistake(
    "the weight of the load is not mass times 9.81",
    "Which force, in newtons, pulls at `mass` kilograms?",
    weight=(lambda mass: 1, lambda mass: 1 / G, lambda mass: mass / G),
)
def another_weight(screws, M, q, mass, center, weight):
    return _right(screws, M, q, weight(mass), center)


@EXERCISE.mistake(
    "gravity does not have the value of the task",
    "How many m/s^2 does the task state?",
    g=(9.8, 10, 9.80665, 9.82),
)
def another_gravity(screws, M, q, mass, center, g):
    return _right(screws, M, q, mass * g / G, center)


@EXERCISE.mistake(
    "the screw axes at zero stand in place of the Jacobian at q",
    "Where are the joints' axes when the joints have rotated by q?",
)
def axes_at_zero(*case):
    screws = case[0]
    return -screws @ _weight(*case)


@EXERCISE.mistake(
    "gravity pulls along the end-effector's axes",
    "Along which axis, of which frame, does gravity pull?",
)
def gravity_of_the_end_effector(screws, M, q, mass, center):
    def wrench(p, T, f):
        return np.cross(p, T[:3, :3] @ f), T[:3, :3] @ f

    return _by(screws, M, q, mass, center, wrench)
