"""follow_velocity: joint angles on a path through a singularity, with a damping that acts near it only."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.panda_dh_ik.ik_step_dls import step_of
from course_lib.checks.exercises.panda_dh_ik.shared import HIGH, LOW, READY, panda_jacobian
from course_lib.checks.vocabulary import few_digits, remembered

_DAMPING = "eps = most (1 - (s / near)^2) if s < near, and 0 otherwise; s is the smallest singular value of J."
_OUT = np.array([0.25, 0, 0, 0, 0, 0])  # m/s, away from the base
_EARLY = np.array([0.0, 0.5, 0, -0.6, 0, 1.6, 0.8])  # nearly stretched


def _smallest(q):
    return np.linalg.svd(panda_jacobian(q), compute_uv=False)[-1]


def _eps(s, near, most):
    return most * (1 - (s / near) ** 2) if s < near else 0.0


def _walked(eps_of=_eps, jacobian_at=lambda path: path[-1], v_of=np.copy, step=1.0, stop=None):
    """Return an answer with another damping eps_of(s, near, most), another Jacobian, another v or another time step.

    stop: of each step, what is kept inside these limits.
    """

    def answer(q, v, dt, n, near, most):
        path = [q]
        for _ in range(int(n)):
            J = panda_jacobian(jacobian_at(path))
            s = np.linalg.svd(J, compute_uv=False)[-1]
            following = step_of(path[-1], J, (dt if step else 1.0) * v_of(v), eps_of(s, near, most))
            path.append(following if stop is None else np.clip(following, *stop))
        return np.array(path)

    return answer


right = remembered(lambda q, v, dt, n, near, most: _walked()(q, v, float(dt), n, float(near), float(most)))


def _drawn(rng):
    """Return a configuration away from singularities."""
    while True:
        q = np.round(rng.uniform(0.6 * LOW, 0.6 * HIGH), 2)
        if _smallest(q) > 0.1:
            return q


def _cases(rng):
    v = np.round(rng.uniform(0.1, 0.4, (2, 6)) * rng.choice([-1, 1], (2, 6)), 2)
    q = [_drawn(rng) for _ in range(2)]
    s = _smallest(q[1])
    return [
        (READY, _OUT, 0.1, 3, 0.02, 0.01),
        (q[0], v[0], 0.05, 4, 0.01, 0.05),
        (_EARLY + 0.05 * rng.uniform(-1, 1, 7), _OUT, 0.1, 8, 0.1, 0.02),
        (q[1], v[1], 0.1, 4, round(2 * s, 3), 0.03),
        (q[0], v[1], 0.1, 0, 0.1, 0.01),
    ]


def _known_form(array, q, v, dt, n, *rest):
    if array.shape == (n, 7):
        return Mistake("the start is left out", "The first of the n + 1 configurations is q.")
    if array.shape == (7,):
        return Mistake("only the last configuration is returned", "Return all n + 1 of them.")
    if array.shape in ((7, n + 1), (7, n)):
        return Mistake("rows and columns are swapped", "One row for each configuration.")
    return None


def _first_off(path, *case):
    k = int(np.argmax(np.abs(path - right(*case)).max(1) > 1e-8))
    return f"Configuration {k} is the first that differs."


EXERCISE = Exercise(
    name="follow_velocity",
    points=2,
    arguments=("q", "v", "dt", "n", "near", "most"),
    cases=_cases,
    returns=numbers(lambda q, v, dt, n, *rest: (n + 1, 7), _known_form),
    properties=(
        Property("the first configuration is q", lambda path, q, *rest: np.abs(path[0] - q).max() < 1e-9),
        Property(
            "away from singularities, s > near, the flange moves with v: q_dot is J^+ v",
            lambda path, *case: np.abs(path - right(*case)).max() < 1e-8,
            _first_off,
            where=lambda q, v, dt, n, near, most: min(map(_smallest, right(q, v, dt, n, near, most))) > near,
        ),
        Property(
            f"each step is dt q_dot, with q_dot = J^T (J J^T + eps I)^-1 v at the configuration before it; {_DAMPING}",
            lambda path, *case: np.abs(path - right(*case)).max() < 1e-7,
            _first_off,
        ),
    ),
    mistakes=(
        Mistake(
            "all configurations are one and the same array, changed in place",
            "q += ... changes the array that is in the list already. path[-1] + ... makes a new one.",
            lambda *case: np.tile(right(*case)[-1], (len(right(*case)), 1)) if case[3] else None,
        ),
        Mistake("the damping acts everywhere", _DAMPING, _walked(lambda s, near, most: most)),
        Mistake("there is no damping near the singularity", _DAMPING, _walked(lambda s, near, most: 0.0)),
        Mistake(
            "all of the damping is switched on at once",
            "The joint velocities jump there. " + _DAMPING,
            _walked(lambda s, near, most: most if s < near else 0.0),
        ),
        Mistake(
            "1 - s / near stands for 1 - (s / near)^2",
            _DAMPING,
            _walked(lambda s, near, most: most * (1 - s / near) if s < near else 0.0),
        ),
        Mistake(
            "the damping grows with s",
            "At the singularity itself, s = 0, it is largest.",
            _walked(lambda s, near, most: most * (s / near) ** 2 if s < near else 0.0),
            _walked(lambda s, near, most: most if s > near else 0.0),
        ),
        Mistake(
            "the damping is squared, or its root is taken",
            _DAMPING,
            _walked(lambda *a: _eps(*a) ** 2),
            _walked(lambda *a: _eps(*a) ** 0.5),
        ),
        Mistake(
            "the Jacobian is that of the start in all steps",
            "Each step begins elsewhere: compute J again.",
            _walked(jacobian_at=lambda path: path[0]),
        ),
        Mistake("dt is not used", "A step is dt times the joint velocities.", _walked(step=0)),
        Mistake(
            "v is taken in the order (omega, v)",
            "The rows of J are (v, omega), and so is v.",
            _walked(v_of=lambda v: np.roll(v, 3)),
        ),
        Mistake("the arm moves backwards", "Add the step.", _walked(v_of=np.negative)),
        Mistake("the arm does not move", "Add the step.", _walked(v_of=np.zeros_like)),
        few_digits(right),
    ),
    hints=(
        "A loop of n steps, in each: J at the configuration, its smallest singular value, the damping, the step.",
        "np.linalg.svd(J, compute_uv=False) has the singular values, the smallest last. With eps = 0 the step is that "
        "of the pseudoinverse, so one formula serves both cases.",
        "ik_step_dls(q, J, dt * v, eps) is the next configuration.",
    ),
    library=right,
)
