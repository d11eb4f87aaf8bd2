"""holding_torques: the joint torques that hold a load still."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.kinds import POSE, Kind, joint_angles, number, vector
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import SMALL_NUMBERS, Sweep
from course_lib.checks.vocabulary import any_pose, away_from_zero
from course_lib.lessons.poe_kuka_iiwa.exercises import shared
from course_lib.rigid import adjoint, inverse

G = 9.81  # m/s^2
_SCREWS = Kind(
    drawn=lambda rng: shared.axes(*shared.drawn_axes(rng, 4)),
    coarse=lambda rng: shared.coarse_screws(rng, 4),
)
_MASS = number(1, 5, beside=(("a load of little mass", lambda rng, mass: mass, SMALL_NUMBERS),))

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
        for n in (1, 2, 5, 7)
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


def _nearly_upright(rng, size):
    """The arm stands upright but for small angles: the light load's lever is short."""
    q = np.array([np.pi / 2 - size, 0.6 * size])
    return _UPRIGHT, shared.at(2, 0, 0), q, rng.uniform(0.05, 0.1), np.zeros(3)


def _position(T, center):
    return T[:3, :3] @ center + T[:3, 3]


def _moment_and_force(T, center, f):
    return np.cross(_position(T, center), f), f


def _torques(wrench=_moment_and_force, jacobian=lambda screws, M, q: shared.jacobian(screws, q).T):
    """Return the answer by a wrench(T, center, f), and by what takes it to torques."""

    def answer(screws, M, q, mass, center):
        T, f = shared.tool_pose(screws, M, q), np.array([0, 0, -mass * G])
        return -jacobian(screws, M, q) @ np.concatenate(wrench(T, center, f))

    return answer


def _load_at(position):
    return _torques(lambda T, center, f: (np.cross(position(T, center), f), f))


def _mass_changed(change):
    return lambda screws, M, q, mass, center: _torques()(screws, M, q, change(mass), center)


def _body_jacobian(screws, M, q):
    return (adjoint(inverse(shared.tool_pose(screws, M, q))) @ shared.jacobian(screws, q)).T


EXERCISE = declared(
    "holding_torques",
    points=3,
    arguments={
        "screws": _SCREWS,
        "M": POSE,
        "q": joint_angles(4),
        "mass": _MASS,
        "center": vector(small=True),
    },
    cases=_cases,
    library=_torques(),
    says="the torques hold the load: their work in a small motion is the energy that it gains",
    otherwise=Question(
        "these torques do not hold the load",
        "How large is the weight of the load, in which direction does it pull, and where is its "
        "center of mass at these angles, all seen from the base? Which matrix takes a wrench to "
        "joint torques, and what becomes of the torques before they are returned?",
    ),
    sweeps=(
        Sweep("an angle is nearly 0", _nearly_zero, shared.SMALL_ANGLES.values),
        Sweep("a load nearly above the joints", _nearly_upright, shared.SMALL_ANGLES.values),
    ),
    hints=(
        "Three steps: where is the center of mass, seen from the base? What wrench (m, f) is the "
        "weight, seen from the base? Which torques balance it?",
        "A motion with joint velocities q' lets the weight do the power F_s . (J_s q'). The "
        "joints' power is tau . q'. Held still, the two add up to 0 for every q'.",
        "So tau is minus the transpose of the space Jacobian, times F_s; and F_s is (p x f, f), f "
        "= (0, 0, -9.81 mass).",
    ),
    mistakes=(
        Mistake("a wrench is returned", "The task asks for one torque for each joint.", form=(6,)),
        Mistake(
            "the center of mass is not rotated into the base's axes",
            "In which frame is `center` given?",
            _load_at(lambda T, center: center),
            _load_at(lambda T, center: T[:3, 3] + center),
        ),
        Mistake(
            "the moment of the weight is missing, or has the wrong sign",
            "Which moment does a force at the point p have about the base's origin?",
            _torques(lambda T, center, f: (0 * f, f)),
            _torques(lambda T, center, f: (np.cross(f, _position(T, center)), f)),
        ),
        Mistake(
            "the torques are those that the weight exerts on the joints",
            "Which torques of the motors balance the torques of the weight?",
            lambda *case: -_torques()(*case),
        ),
        Mistake(
            "the force stands above the moment in the wrench",
            "In which order are the halves of a twist, and so the rows of the space Jacobian?",
            _torques(lambda T, center, f: _moment_and_force(T, center, f)[::-1]),
        ),
        Mistake(
            "the Jacobian and the wrench are seen from two different frames",
            "From which frame is your Jacobian seen, and from which frame is your wrench seen?",
            _torques(jacobian=_body_jacobian),
        ),
        Mistake(
            "an inverse of the Jacobian takes the wrench to the torques",
            "The joints' power equals the power at the load. Which matrix follows from that?",
            _torques(jacobian=lambda screws, M, q: np.linalg.pinv(shared.jacobian(screws, q))),
        ),
        Mistake(
            "the load hangs at the end-effector's origin",
            "Where does your code use `center`?",
            _load_at(lambda T, center: T[:3, 3]),
        ),
        Mistake(
            "the weight of the load is not mass times 9.81",
            "Which force, in newtons, pulls at `mass` kilograms?",
            _mass_changed(lambda mass: 1),
            _mass_changed(lambda mass: 1 / G),
            _mass_changed(lambda mass: mass / G),
        ),
        Mistake(
            "gravity does not have the value of the task",
            "How many m/s^2 does the task state?",
            *(_mass_changed(lambda mass, g=g: mass * g / G) for g in (9.8, 10, 9.80665, 9.82)),
        ),
        Mistake(
            "the screw axes at zero stand in place of the Jacobian at q",
            "Where are the joints' axes when the joints have rotated by q?",
            _torques(jacobian=lambda screws, M, q: screws),
        ),
        Mistake(
            "gravity pulls along the end-effector's axes",
            "Along which axis, of which frame, does gravity pull?",
            _torques(lambda T, center, f: _moment_and_force(T, center, T[:3, :3] @ f)),
        ),
    ),
)
