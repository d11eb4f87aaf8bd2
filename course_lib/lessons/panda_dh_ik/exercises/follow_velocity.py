"""follow_velocity: joint angles on a path through a singularity, with a damping that acts near it
only."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.kinds import OWN_CASES
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import Sweep
from course_lib.checks.tolerances import SOLVED
from course_lib.checks.vocabulary import compared, remembered
from course_lib.lessons.panda_dh_ik.exercises.shared import HIGH, LOW, READY, damped, panda_jacobian

_OUT = np.array([0.25, 0, 0, 0, 0, 0])  # m/s, away from the base
# Relative to `near`. With less damping than these leave, rounding in J^T J would decide.
_GAPS = (0.3, -0.3, 0.1, -0.1, 0.03, -0.03, 0.01, -0.01, 1e-3, -1e-3)
# Of the smallest singular value, about. With smaller ones, rounding would show in the step, which
# has no damping, or one of the value itself, or of its square.
_NEARLY_SINGULAR = (0.1, 0.03, 0.01, 3e-3, 1e-3, 1e-4, 1e-5)
_LITTLE_DAMPING = (0.1, 0.03, 0.01, 3e-3, 1e-3)
_SINGULAR = np.zeros(7), np.array([0.0, 0, 0, 0, 1, 1, 0]), np.array([0.3, 0, 0, 0, 0.5, 2, 0.4])
_EARLY = np.array([0.0, 0.5, 0, -0.6, 0, 1.6, 0.8])  # nearly stretched


def _smallest(q):
    return np.linalg.svd(panda_jacobian(q), compute_uv=False)[-1]


def _eps(s, near, most):
    return most * (1 - (s / near) ** 2) if s < near else 0.0


def _walked(q, v, dt, n, near, most, eps_of=_eps, step=-1, limits=None):
    path = [q]
    for _ in range(int(n)):
        J = panda_jacobian(path[step])
        q = damped(path[-1], J, dt * v, eps_of(np.linalg.svd(J, compute_uv=False)[-1], near, most))
        path.append(q if limits is None else np.clip(q, *limits))
    return np.array(path)


@remembered
def _remembered(q, v, numbers):
    return _walked(q, v, *numbers)


def _right(q, v, *numbers):
    """Return the right answer, computed once for equal arguments."""
    return _remembered(q, v, np.array(numbers, float))


def _drawn(rng):
    """Return a configuration away from singularities."""
    while True:
        q = np.round(rng.uniform(0.6 * LOW, 0.6 * HIGH), 2)
        if _smallest(q) > 0.1:
            return q


def _leaves_the_limits(rng, v):
    """Return the arguments for a path away from singularities that leaves the joint limits."""
    while True:
        q = _drawn(rng)
        q[5] = HIGH[5] - 0.005
        path = _right(q, v, 0.1, 4, 0.01, 0.05)
        if path[1:, 5].min() > HIGH[5] + 0.005 and min(map(_smallest, path)) > 0.05:
            return q, v, 0.1, 4, 0.01, 0.05


def _cases(rng):
    v = np.round(rng.uniform(0.1, 0.4, (2, 6)) * rng.choice([-1, 1], (2, 6)), 2)
    q = [_drawn(rng) for _ in range(2)]
    s = _smallest(q[1])
    return [
        (READY, _OUT, 0.1, 3, 0.02, 0.01),
        (READY, _OUT, 0.1, 2, 0.0, 0.01),
        (q[0], v[0], 0.05, 4, 0.01, 0.05),
        (_EARLY + 0.05 * rng.uniform(-1, 1, 7), _OUT, 0.1, 8, 0.1, 0.02),
        (q[1], v[1], 0.1, 4, round(2 * s, 3), 0.03),
        *((q[1], v[0], 0.1, 2, round(2 * s, 3), most) for most in (1e-5, 1e-7)),  # which count
        (q[1], v[0], 0.1, 2, round(2 * s, 3), 0.6),
        (q[0], 50 * v[1], 0.002, 2, 0.0, 0.01),  # fast joints
        (q[0], 1e-8 * v[1], 3600.0, 2, 0.0, 0.01),  # slow, and for long
        (q[0], v[1], 0.1, 0, 0.1, 0.01),
        # At a singularity rounding makes the smallest eigenvalue of J J^T negative, or large.
        *((singular, v[0], 0.02, 2, 0.1, 0.02) for singular in _SINGULAR),
        _leaves_the_limits(rng, v[0]),
        (np.array([0, -1, 0, -2, 0, 2, 1]), np.array([1, 0, -1, 0, 1, 0]), 0.1, 2, 0.01, 0.05),
    ]


def _beside_near(rng, gap):
    """Return a step whose smallest singular value is near `near`, where the damping begins."""
    q = _drawn(rng)
    return q, np.round(rng.uniform(0.1, 0.4, 6), 2), 0.1, 1, _smallest(q) * (1 + gap), 0.05


def _beyond(near, most):
    """Return the case(rng, size) of a step from a nearly singular configuration, with near and most
    of its smallest singular value s."""

    def case(rng, size):
        q = size * _drawn(rng)  # with all angles 0 the arm is singular
        s = _smallest(q)
        return q, s * np.round(rng.uniform(0.1, 0.4, 6), 2), 0.1, 1, near * s, most(s)

    return case


def _found(path, *case):
    k = int(np.argmax(np.abs(path - _right(*case)).max(1) > SOLVED))
    both = compared(_right(*case)[k], path[k])
    return f"Configuration {k} is the first that differs. It should be " + both + "."


def _with_damping(eps_of):
    return lambda *case: _walked(*case, eps_of=eps_of)


EXERCISE = declared(
    "follow_velocity",
    points=2,
    arguments=dict.fromkeys(("q", "v", "dt", "n", "near", "most"), OWN_CASES),
    cases=_cases,
    tolerance=SOLVED,
    library=_right,
    says="each step is dt q_dot, with q_dot = J^T (J J^T + eps I)^-1 v at the configuration before "
    "it, eps = most (1 - (s / near)^2) if s < near, and 0 otherwise",
    found=_found,
    otherwise=Question(
        "a step is not dt q_dot, with q_dot of the configuration before the step",
        "Compute the step to this configuration by hand, from the configuration before "
        "it: J, its smallest singular value, eps, q_dot and dt q_dot. What differs in your code?",
    ),
    sweeps=(
        Sweep("s nearly as large as near", _beside_near, _GAPS),
        Sweep("s is small, and larger than near", _beyond(0.6, lambda s: s), _NEARLY_SINGULAR),
        Sweep("s and near are small", _beyond(1.5, lambda s: s), _NEARLY_SINGULAR),
        Sweep("s, near and most are small", _beyond(1.5, np.square), _LITTLE_DAMPING),
    ),
    hints=(
        "A loop of n steps, in each: J at the configuration, its smallest singular value, the "
        "damping, the step.",
        "np.linalg.svd(J, compute_uv=False) has the singular values, the smallest last. With eps = "
        "0 the step is that of the pseudoinverse, so one formula serves both cases.",
        "ik_step_dls(q, J, dt * v, eps) is the next configuration.",
    ),
    mistakes=(
        Mistake(
            "J^T J is inverted where eps is 0",
            "Which of J J^T and J^T J has an inverse for seven joints?",
            raises=("LinAlgError", "Singular"),
        ),
        Mistake(
            "the damping is not that of the task",
            "Print your eps for s = 0, s = near / 2, s slightly below near and s above near, and "
            "compare these four numbers with the formula of the task.",
            _with_damping(lambda s, near, most: most),
            _with_damping(lambda s, near, most: 0.0),
            _with_damping(lambda s, near, most: most if s < near else 0.0),
            _with_damping(lambda s, near, most: most * (1 - s / near) if s < near else 0.0),
            _with_damping(lambda s, near, most: most * (1 - s / near) ** 2 if s < near else 0.0),
            _with_damping(lambda s, near, most: most * (s / near) ** 2 if s < near else 0.0),
            _with_damping(
                lambda s, near, most: most * (1 - (s**2 / near) ** 2) if s**2 < near else 0.0
            ),
        ),
        Mistake(
            "the configurations are clipped to the joint limits",
            "What does the task say about the joint limits?",
            lambda *case: _walked(*case, limits=(LOW, HIGH)),
        ),
    ),
)
