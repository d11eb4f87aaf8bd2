"""panda_ik: joint angles inside the Panda's limits for which its flange has a given pose in the
world."""

import itertools

import numpy as np

from course_lib.checks.answer_types import NOT_A_NUMBER, numbers
from course_lib.checks.call_student import TOGETHER
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.reasons import Finding
from course_lib.checks.tolerances import EXACT, SIX_DIGITS
from course_lib.checks.vocabulary import SOLVERS, compared, remembered
from course_lib.ik import solve
from course_lib.lessons.panda_dh_ik.exercises.shared import (
    HIGH,
    LOW,
    PANDA,
    READY,
    T_W0,
    flange,
    frames,
)
from course_lib.rigid import inverse, transform
from course_lib.rotations import exp_so3, length, log_so3, rot_z

# metres and radians; a little more than asked for, because the student's sums round otherwise
_REACHED = 1.001 * SIX_DIGITS

_AT_A_POSE = 1e-3  # m and rad: of a pose that the iteration was to reach, by mistake

_LOW_DOWN = np.array(
    [0.1, 0.6, -0.1, -2.0, 0.1, 2.6, 0.8]
)  # its flange is within reach of the base, and of the world
_OUTSIDE = READY + 2.3 * np.eye(7)[6]  # a start that reaches its target outside the limits
_BEYOND = np.array([0.3, 0.4, -0.5, -1.9, 0.4, 3.4, 0.2])  # with joint 6 beyond pi

# Configurations whose flange poses are not reached from the ready configuration without a restart:
# damped steps of many kinds (damping constant, or by the error, large and small), clipped to the
# limits after each step, end near these poses; steps without limits end outside the limits. From
# a random configuration about every third start succeeds.
_HARD = np.array(
    [
        [-2.16, -0.75, -2.27, -2.42, -2.15, 0.72, -1.98],
        [-1.34, 1.45, -0.59, -2.27, -1.75, 0.91, -0.73],
        [1.17, -0.12, 0.61, -2.39, -1.6, 1.81, -0.98],
        [1.16, 0.92, -0.39, -2.7, -2.07, 1.86, -0.45],
        [-0.77, -0.09, 0.57, -2.62, -2.43, 2.8, 2.4],
        [1.8, -0.2, 0.58, -2.04, -0.03, 2.31, -1.74],
        [-1.53, 0.41, -2.09, -2.63, 0.7, 1.96, -2.14],
        [2.46, 0.33, 0.54, -2.67, 1.02, 0.84, -1.96],
    ]
)


# With joint 1 at its limit, and starts 0.2 rad below: solvers with few steps, with a damping that
# is large or negative, or that leave the limits in between, end near one of these. No case is
# there whose difficulty depends on the numbers drawn: who finds all targets in the notebook finds
# all of them in grading.
_AT_A_LIMIT = np.column_stack(
    [
        np.full(9, HIGH[0] - 0.01),
        [
            [0.52, 0.74, -1.62, 0.49, 2.73, 1.23],
            [0.87, 0.49, -2.19, 1.44, 1.49, -0.82],
            [-0.85, -0.34, -2.14, -1.22, 2.33, -1.39],
            [0.79, 0.36, -1.36, 1.34, 1.25, -1.11],
            [0.32, 0.81, -1.86, 1.38, 0.93, 1.0],
            [0.71, 0.99, -1.27, -0.79, 1.12, 0.74],
            [0.68, 0.94, -1.51, -1.43, 2.19, 1.27],
            [0.42, -1.36, -1.58, 1.43, 2.62, -1.0],
            [-0.64, -1.45, -1.58, -0.97, 1.1, 0.87],
        ],
    ]
)
_ABOUT_READY = READY + 0.1 * np.array(
    [-1, 1, -1, 1, -1, -1, 1]
)  # of all such signs, those that take the most steps
# Of the wrist, from the shoulder, and a configuration in which it is there.
_REACH = np.hypot(0.316, 0.0825) + np.hypot(0.384, 0.0825)
_ELBOW = -np.arctan2(0.0825, 0.316) - np.arctan2(0.0825, 0.384)
_STRETCHED = np.array([0.3, 0.5, 0, _ELBOW, 0, 2.0, 0.4])
_WHOLE = np.array([0, -1, 0, -2, 0, 2, 1])
_AT_TWO_LIMITS = np.where(np.arange(7) == 3, LOW, np.where(np.arange(7) == 5, HIGH, READY))
# Elbow and wrist are bent so that the flange is as far from the shoulder as can be.
_FARTHEST = np.array([0.3, 0.6, 0, -0.46700242, 0, 2.66495059, 0.5])
_NEARLY_FARTHEST = _FARTHEST - [0, 0, 0, 0.02, 0, 0, 0]
_BACK_TO_FRONT = READY - [0, 0, 0, 0, 0, 0, np.pi]  # the flange is rotated by half a revolution
_ABOUT_LOW_DOWN = _LOW_DOWN + 0.02 * np.array([-1, 1, -1, 1, -1, -1, -1])


# Symmetries of the arm, by which each case is replaced by another one of the same difficulty, so
# that a table of answers computed at home answers none. A rotation of target and start about the
# axis of joint 1 adds an angle to joint 1, and a rotation of the flange about its own axis adds one
# to joint 7: all steps of an iteration stay the same, but for the limits of these two joints, which
# the angles added keep away from. A reflection in the plane of the arm negates the joints whose
# axes lie in that plane; their limits are symmetric.
_MAX_ADDED = 0.4  # rad; with more, the starts would differ in their distance from the limits
_MIRROR = np.diag([1.0, -1.0, 1.0, 1.0])
_MIRRORED = np.array([-1, 1, -1, 1, -1, 1, -1])


def _moved(rng, T_target, q0, q_target):
    """Return another case of the same difficulty.

    q_target: joint angles that reach the target; joints 1 and 7 stay within their limits for them.
    """
    room = np.minimum(HIGH - np.abs(q_target) - 0.005, _MAX_ADDED).clip(0)
    added = rng.uniform(-room[0], room[0]), rng.uniform(-room[6], room[6])
    q0 = q0 + added[0] * np.eye(7)[0] + added[1] * np.eye(7)[6]
    T = transform(rot_z(added[0]), np.zeros(3)) @ inverse(T_W0) @ T_target
    T = T @ transform(rot_z(added[1]), np.zeros(3))
    if rng.random() < 0.5:
        T, q0 = _MIRROR @ T @ _MIRROR, _MIRRORED * q0
    return T_W0 @ T, q0


def _two_starts_that_solve(rng):
    """Return a target twice, each time with another start that reaches it already."""
    T, q = _moved(rng, flange(READY), READY, READY)
    still = np.linalg.svd(PANDA.body_jacobian(q))[2][-1]  # moves the joints, and not the flange
    other = solved(T, q + 0.3 * np.sign(still[0]) * still)
    return [(flange(other), q), (flange(other), other)]  # which other reaches to the last digit


def _cases(rng):
    at_ready = flange(READY)
    # Who stops too early answers q0: by the larger half of the error, or by its largest number.
    errors = ([0, 1.3e-6, 0], [9e-7, 0, 9e-7]), (3 * [6e-7], 3 * [6e-7])
    shifted = transform(at_ready[:3, :3], at_ready[:3, 3] - [0.03, 0.02, 0.04])
    rotated = transform(exp_so3([0.1, 0.2, -0.3]) @ at_ready[:3, :3], at_ready[:3, 3])
    reached = [  # start and joint angles that reach the target
        (READY, READY + 0.03 * rng.choice([-1, 1], 7)),
        (READY, READY),
        *((q, q) for q in (_BEYOND, _OUTSIDE)),
        (READY, _ABOUT_READY),
        (_LOW_DOWN, _ABOUT_LOW_DOWN),
        (_NEARLY_FARTHEST, _NEARLY_FARTHEST),
        (_AT_TWO_LIMITS, _AT_TWO_LIMITS),
        (READY, _BACK_TO_FRONT),
        *((np.clip(q - 0.2, LOW, HIGH), q) for q in _AT_A_LIMIT),
        *((READY, q) for q in _HARD),
    ]
    poses = [at_ready @ transform(exp_so3(w), p) for w, p in errors]
    poses += [shifted, rotated]
    cases = [_moved(rng, flange(q), q0, q) for q0, q in reached]
    out_of_reach = [
        _moved(rng, _just_out_of_reach(), READY, READY),
        _moved(rng, _just_beyond_the_farthest(), _FARTHEST, _FARTHEST),
    ]
    cases = [
        *cases[:4],
        *(_moved(rng, T, READY, READY) for T in poses),
        *out_of_reach,
        *cases[4:],
    ]
    cases += _two_starts_that_solve(rng)
    return [*cases, (flange(_WHOLE + 0.05 * rng.choice([-1, 1], 7)), _WHOLE)]


@remembered
def solved(T, q0):
    """Return the library's answer."""
    found = solve(PANDA, inverse(T_W0) @ T, np.random.default_rng(0), q0=q0, starts=100)
    return found.q if found.success else np.full(7, np.nan)


def _just_out_of_reach():
    """Return a pose of the flange at which the wrist is farther from the shoulder than the
    stretched arm reaches, by 0.3 mm."""
    T, shoulder, wrist = flange(_STRETCHED), *frames(_STRETCHED)[[0, 5], :3, 3]
    T[:3, 3] += 3e-4 * (wrist - shoulder) / _REACH
    return T


def _just_beyond_the_farthest():
    """Return a pose 0.05 mm farther from the shoulder than the flange gets in any direction."""
    T = flange(_FARTHEST)
    away = T[:3, 3] - frames(_FARTHEST)[0, :3, 3]
    T[:3, 3] += 5e-5 * away / np.linalg.norm(away)
    return T


def _reachable(T, q0):
    """Return whether the elbow can stretch far enough for a pose of the flange.

    The wrist is somewhere on a circle about the flange's axis.
    """
    x, y, z = T[:3, :3].T @ (T[:3, 3] - frames(READY)[0, :3, 3]) - [0, 0, 0.107]
    return np.hypot(z, np.hypot(x, y) - 0.088) < _REACH + 1e-5


def _gaps(A, B):
    """Return the metres and radians between two poses."""
    return np.array([length(B[:3, 3] - A[:3, 3]), length(log_so3(B[:3, :3] @ A[:3, :3].T))])


def _found(q, *case):
    return bool(np.isfinite(q).all())


def _inside(q, T, q0):
    return not _found(q) or bool(((q >= LOW - EXACT) & (q <= HIGH + EXACT)).all())


def _near(T, q0):
    """Return whether a target within reach is close to the pose at q0."""
    is_close = np.linalg.norm(_gaps(flange(np.clip(q0, LOW, HIGH)), T)) < 0.15
    return bool(is_close and _reachable(T, q0))


def _solved(q, T, q0):
    return _found(q) and _inside(q, T, q0) and _gaps(flange(q), T).max() <= _REACHED


def _second_missed(values, cases):
    missed = (
        k for k, case in enumerate(cases) if _reachable(*case) and not _solved(values[k], *case)
    )
    return next(itertools.islice(missed, 1, None), None)


def _outside(q, T, q0):
    j = int(np.argmax(np.maximum(LOW - q, q - HIGH)))
    beyond = max(LOW[j] - q[j], q[j] - HIGH[j])
    return (
        f"Joint {j + 1} may be between {LOW[j]:.4f} and {HIGH[j]:.4f} rad; yours is {beyond:.2g} "
        f"rad "
        f"beyond."
    )


def _off(q, T, q0):
    p, (metres, angle) = flange(q)[:3, 3], _gaps(flange(q), T)
    text = f"With your angles the flange is {metres:.3g} m and {angle:.3g} rad from the target"
    if metres <= _REACHED:
        return Finding(f"{text}.", metres)
    return f"{text}. Its position should be " + compared(T[:3, 3], p) + "."


def _elsewhere(q, T, q0):
    j = int(np.argmax(np.abs(q - q0)))
    return f"Joint {j + 1} changes by {q[j] - q0[j]:.2g} rad, although q0 is a solution."


_NOT_CONVERGING = Question(
    "the steps do not converge to a target close by",
    "Print the length of the error before the first step and after each step. The first length is "
    "at most 0.15 here. After which step does it not become smaller, and what is e, J and q there?",
)
_STUCK = Question(
    "no start leads to this target, because there are no restarts or because too few of them "
    "converge",
    "A descent may get stuck in a local minimum or at a limit. How many starts does your code make "
    "for this target, how many of them are different, and with which error does each end?",
)
_START = Mistake(
    "q0 is returned unchanged",
    "q0 may lie outside the limits. What do the given lines do with q0 first?",
)
_IGNORED = Question(
    "the limits are ignored",
    "Which line keeps this joint within its limits: at a start, after a step, and in the answer?",
)
_LAST = Question(
    "the last angles are returned, although they do not reach T_target",
    "Which test of the error stands before your return, and of which q is this error?",
)

EXERCISE = Exercise(
    name="panda_ik",
    points=4,
    sets=1,  # another set has the same cases, but for signs and symmetries of the arm
    arguments=("T_target", "q0"),
    cases=_cases,
    returns=numbers(
        lambda *case: (7,),
        gaps=True,
    ),
    properties=(
        Property(
            "the answer is seven numbers, or seven NaN",
            lambda q, *case: _found(q) or np.isnan(q).all(),
            otherwise=NOT_A_NUMBER,
        ),
        Property(
            "every joint is inside its limits",
            _inside,
            _outside,
            where=_reachable,
            otherwise=lambda q, T, q0: _START if np.abs(q - q0).max() < SIX_DIGITS else _IGNORED,
        ),
        Property(
            "the flange is within 1e-6 m and 1e-6 rad of T_target, in the world",
            lambda q, T, q0: not _found(q) or _gaps(flange(q), T).max() <= _REACHED,
            _off,
            where=_reachable,
            otherwise=_LAST,
        ),
        Property(
            "the iteration begins at q0: if q0 reaches T_target already, the answer is q0",
            lambda q, T, q0: not _found(q) or np.abs(q - q0).max() < SIX_DIGITS,
            _elsewhere,
            otherwise=Question(
                "the iteration does not begin at q0, or makes a step without a test before it",
                "What is q before the first step, where is the error tested for the first time, "
                "and what becomes of q before it is returned?",
            ),
            where=lambda T, q0: np.abs(T - flange(np.clip(q0, LOW, HIGH))).max() < EXACT,
        ),
        Property(
            "a target close by is reached: seven numbers are returned, not NaN",
            _found,
            where=_near,
            otherwise=_NOT_CONVERGING,
        ),
        Property(
            "a target that some joint angles inside the limits reach is found: seven numbers are "
            "returned, not NaN",
            _found,
            where=_reachable,
            otherwise=_STUCK,
        ),
        Property(
            "for a target out of reach seven NaN are returned",
            lambda q, *case: not _found(q),
            says=lambda q, T, q0: (
                f"The target is {np.linalg.norm(T[:3, 3] - T_W0[:3, 3]):.3g} m from the arm's base."
            ),
            where=lambda *case: not _reachable(*case),
            otherwise=Question(
                "angles are returned for a target out of reach",
                "What does your code return if no start converges, and how does it know that?",
            ),
        ),
        Property("each target close by is reached", _solved, where=_near, points=2),
        Property(
            "at most one target within reach is missed", _second_missed, across=True, points=1
        ),
    ),
    hints=(
        "One start is a loop: the frames at q, the error to T_target, return q if it is small "
        "enough, else a damped "
        "step and np.clip to the limits.",
        "How should the damping depend on the error, so that the last steps converge fast and the "
        "first ones are safe?",
        "Around it a second loop over the starts: if a start fails, where should the next one "
        "begin, and what is "
        "returned after the last? Print how many steps a start takes that converges: more than "
        "twice that is wasted.",
    ),
    library=solved,
    tries_arguments=False,
    forbidden=SOLVERS,
)

EXERCISE.mistake(
    Mistake("a pose is returned", "Inverse kinematics leads from a pose to joint angles."),
    form=(4, 4),
)
EXERCISE.mistake(
    Mistake(
        "no single call takes very long, but all of them together make too many steps",
        "How many steps does a start take that converges? If it slows down near the target, what "
        "makes its steps short there?",
    ),
    raises=("TimeUp", TOGETHER),
)
EXERCISE.mistake(
    Mistake(
        "too many steps are made, or a loop never ends",
        "For a target out of reach all your steps are made, starts times steps. How many are "
        "they in "
        "your code, and how many steps does a start take that converges?",
    ),
    raises=("TimeUp", ""),
)


@EXERCISE.mistake(
    "the flange comes near T_target, but not as near as the task asks",
    "By which numbers does the task bound the two lengths of the error, and what does your code "
    "compare with them? Are the angles that it has tested those that it returns?",
    recognises=True,
)
def stopped_too_early(q, T, q0):
    return _REACHED < _gaps(flange(q), T).max() < 0.02 and _inside(q, T, q0)


@EXERCISE.mistake(
    "T_w0 is left out, or used twice, or inverted",
    "From which frame is T_target seen, and from which frame is the pose of your flange seen?",
    recognises=True,
)
def base_forgotten(q, T, q0):
    back = inverse(T_W0)
    return any(
        (_gaps(PANDA.fk(q), goal) < _AT_A_POSE).all() for goal in (T, T_W0 @ T, back @ back @ T)
    )


@EXERCISE.mistake(
    "the frame of joint 7 is at T_target, and not the flange",
    "Which of the eight poses is that of the flange?",
    recognises=True,
)
def flange_forgotten(q, T, q0):
    return bool((_gaps(frames(q)[6], T) < _AT_A_POSE).all())


@EXERCISE.mistake(
    "only the position, or only the orientation, is brought to T_target",
    "Print all six numbers of your error for the angles that you return. Which of them are 0 "
    "although the flange is not at T_target, and how are they computed?",
    recognises=True,
)
def one_half_only(q, T, q0):
    metres, angle = _gaps(flange(q), T)
    return _reachable(T, q0) and min(metres, angle) <= _REACHED < max(metres, angle)
