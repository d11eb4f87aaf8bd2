"""newton_ik: joint angles for a pose of the end-effector, by Newton's method with the body
Jacobian.

Many joint angles are right, so its properties ask where they bring the end-effector.
"""

import numpy as np

from course_lib.arms import ur5e
from course_lib.checks.answer_types import NOT_A_NUMBER, numbers
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.tolerances import EXACT, SIX_DIGITS
from course_lib.checks.vocabulary import SOLVERS, any_pose, away_from_zero, compared, pose
from course_lib.lessons.poe_kuka_iiwa.exercises.shared import KUKA, KUKA_HOME, jacobian, tool_pose
from course_lib.rigid import adjoint, exp_se3, inverse, log_se3

STEPS = 20  # are enough: the targets need up to 16, and wrong steps do not arrive in any number
_CLOSE = SIX_DIGITS  # radians and metres
_REACHED = (
    1.001 * SIX_DIGITS
)  # a little more than asked for, because the student's sums round otherwise
_UNCHANGED = 1e-12  # rad: rounding of angles near pi
_UR5E = ur5e().screw_axes, ur5e().home[-1]
_LONG = np.array(
    [-1.5, -1.3, 1.6, 1.6, -0.1, -0.8]
)  # from which 16 steps are needed, and the error may grow
_BENT = np.array([0.4, -1.1, 1.3, -0.9, 0.7, 3.5])  # the last beyond pi
# From the first of these to the second, the error of the UR5e becomes nine times as long in the
# first step, and 10 steps are needed.
_GROWING = np.array([0.5, 0.6, 1.7, -1.2, 0.8, 1.1])
_GROWN = _GROWING + np.array([0.4, -0.4, 0.4, -0.4, 0.4, 0.4])
_NEAR_THE_LIMITS = np.array([0.3, 2.0, -0.4, 2.0, 0.5, 2.0, 0.2])  # of the iiwa


def body_error(T, T_target):
    """Return the twist that leads from T to T_target in unit time, seen from the end-effector."""
    return log_se3(inverse(T) @ T_target)


def _step(T, J, V):
    return np.linalg.pinv(adjoint(inverse(T)) @ J) @ V


def descent(screws, M, T_target, q0, error=body_error, step=_step, steps=STEPS):
    """Return joint angles for T_target, or nan; step(T, J, V) is how the angles change, J the space
    Jacobian."""
    q = np.array(q0, float)
    for _ in range(steps):
        T = tool_pose(screws, M, q)
        V = error(T, T_target)
        if max(np.linalg.norm(V[:3]), np.linalg.norm(V[3:])) <= _CLOSE:
            return q
        q = q + step(T, jacobian(screws, q), V)
    return np.full(len(q), np.nan)


def _near(arm, q0, rng):
    """Return a case whose target Newton's method reaches from q0 in a few steps."""
    while True:
        T = tool_pose(*arm, q0 + away_from_zero(rng, len(q0), 0.2, 0.5))
        if np.isfinite(descent(*arm, T, q0, steps=6)).all():
            return (*arm, T, q0)


def _cases(rng):
    base = any_pose(rng)
    elsewhere = _UR5E[0] @ adjoint(base).T, base @ _UR5E[1]
    kuka, bent = (KUKA, KUKA_HOME), np.array([0.3, 0.7, -0.4, 1.1, 0.5, 0.9, 0.2])
    here = tool_pose(*_UR5E, _BENT)
    hardly = here @ exp_se3([0, 9e-7, 9e-7, 0, -9e-7, 9e-7])  # an answer that stops too early is q0
    converged = here @ exp_se3(
        [0, 3e-10, 0, 0, 0, 3e-10]
    )  # for a stricter tolerance than the task's too
    return [
        _near(_UR5E, _BENT, rng),
        (*_UR5E, here, _BENT),
        (*_UR5E, converged, _BENT),
        (*_UR5E, hardly, _BENT),
        (*_UR5E, here @ pose(np.eye(3), [0.05, -0.04, 0.03]), _BENT),
        (*_UR5E, here @ exp_se3([0.2, -0.1, 0.3, 0, 0, 0]), _BENT),
        _near(_UR5E, np.array([-1, -1.5, 1.2, 0.5, -1, 2]), rng),
        _near(kuka, bent, rng),
        _near(kuka, -bent, rng),
        _near(kuka, np.array([1, 1, -1, 2, 0, 1, 1]), rng),
        _near(elsewhere, _BENT, rng),
        (*_UR5E, tool_pose(*_UR5E, _LONG - [0.3, 0.4, 0.1, 0.3, -0.2, -0.4]), _LONG),
        (*_UR5E, tool_pose(*_UR5E, _GROWN), _GROWING),
        (*kuka, tool_pose(*kuka, _NEAR_THE_LIMITS + 0.4), _NEAR_THE_LIMITS),
        (*_UR5E, pose(here[:3, :3], [3.0, 0.5, 0.2]), _BENT),
        (*kuka, pose(tool_pose(*kuka, bent)[:3, :3], [3.0, 0.5, 0.2]), bent),
    ]


def _out_of_reach(screws, M, T_target, q0):
    return T_target[0, 3] == 3


def _found(q, *case):
    return bool(np.isfinite(q).all())


def _gaps(q, screws, M, T_target, q0):
    """Return the radians and metres from the pose at q to the target."""
    V = body_error(tool_pose(screws, M, q), T_target)
    return np.array([np.linalg.norm(V[:3]), np.linalg.norm(V[3:])])


def _off(q, *case):
    return "At your angles the end-effector is {:.2g} rad and {:.2g} m from the target.".format(
        *_gaps(q, *case)
    )


_INVERTED = Mistake(
    "the Jacobian is inverted",
    "With seven joints the Jacobian has seven columns. Which matrix stands in place of an inverse?",
)

EXERCISE = Exercise(
    name="newton_ik",
    points=4,
    sets=2,
    arguments=("screws", "M", "T_target", "q0"),
    cases=_cases,
    returns=numbers(
        lambda screws, M, T_target, q0: (len(q0),),
        gaps=True,
    ),
    library=descent,
    tries_arguments=False,
    properties=(
        Property(
            "the answer is n numbers, or n times nan",
            lambda q, *case: _found(q) or np.isnan(q).all(),
            otherwise=NOT_A_NUMBER,
        ),
        Property(
            "a target close by is reached: numbers are returned, not nan",
            _found,
            where=lambda *case: not _out_of_reach(*case),
            otherwise=Question(
                "the iteration gives up although the target can be reached",
                "Print q and the error in each step for this target; the error may grow in a step. "
                "How many steps may it need according to the task, and what ends your loop before "
                "that?",
            ),
        ),
        Property(
            "at the angles returned the end-effector is within 1e-6 rad and 1e-6 m of T_target",
            lambda q, *case: _gaps(q, *case).max() <= _REACHED,
            _off,
            where=lambda *case: not _out_of_reach(*case),
            otherwise=Question(
                "the steps end before the target is reached",
                "Print the error of the q that you return. Where in your loop is `short` asked, "
                "and about the error of which q?",
            ),
            points=1,
        ),
        Property(
            "the steps begin at q0: if q0 reaches T_target already, the answer is q0",
            lambda q, screws, M, T_target, q0: np.abs(q - q0).max() < 0.1,
            lambda q, screws, M, T_target, q0: "The answer should be " + compared(q0, q) + ".",
            where=lambda screws, M, T_target, q0: (
                np.abs(T_target - tool_pose(screws, M, q0)).max() < 1e-5
            ),
            otherwise=Question(
                "the steps do not begin at q0",
                "With which q does your loop begin in this call, what is its error, and what "
                "becomes of q before it is returned?",
            ),
        ),
        Property(
            "a q0 that has converged is returned unchanged",
            lambda q, screws, M, T_target, q0: np.abs(q - q0).max() < _UNCHANGED,
            lambda q, screws, M, T_target, q0: "The answer should be " + compared(q0, q) + ".",
            where=lambda screws, M, T_target, q0: (
                np.abs(T_target - tool_pose(screws, M, q0)).max() < EXACT
            ),
            otherwise=Question(
                "a step is made without a test before it",
                "With which q does your loop begin in this call, where is the error tested for the "
                "first time, and what becomes of q before it is returned?",
            ),
        ),
        Property(
            "for a target out of reach nan is returned",
            lambda q, *case: not _found(q),
            says=lambda q, screws, M, T_target, q0: (
                f"The target is {np.linalg.norm(T_target[:3, 3]):.3g} m from the arm's base."
            ),
            where=_out_of_reach,
            otherwise=Question(
                "the last angles are returned, although they do not reach the target",
                "Which value does the task ask for if no step reaches the target, and which line "
                "of yours returns it?",
            ),
        ),
    ),
    hints=(
        "In the loop: where is the end-effector at q, and which twist leads from there to T_target "
        "in unit time?",
        "log(T^-1 T_target) is seen from the end-effector. Which Jacobian belongs to such a twist?",
        "If short(twist), return q. Else add np.linalg.pinv(J) @ twist to q. After the last step, "
        "np.full(len(q0), np.nan).",
    ),
    forbidden=SOLVERS,
)

EXERCISE.mistake(
    Mistake("a pose is returned", "Inverse kinematics leads from a pose to joint angles."),
    form=(4, 4),
)
EXERCISE.mistake(_INVERTED, raises=("LinAlgError", "must be square"))


@EXERCISE.mistake(
    "the steps do not converge to a target close by, or end too soon",
    "Print the error after each step. From which pose to which pose does it lead? Compare its "
    "frame, "
    "and the order of its halves, with those of your Jacobian.",
    error=(
        lambda T, T_target: log_se3(inverse(T_target) @ T),
        lambda T, T_target: log_se3(T_target @ inverse(T)),
        lambda T, T_target: np.roll(body_error(T, T_target), 3),
    ),
)
def another_error(screws, M, T_target, q0, error):
    return descent(screws, M, T_target, q0, error)
