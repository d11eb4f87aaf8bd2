"""newton_step: one step of Newton's method from approximate joint angles towards a position."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.special_cases import BESIDE, SMALL, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import near, two_link_angles, two_link_tip

# rad: with a smaller bend, rounding is multiplied by more than 1,000.
_BENDS = tuple(bend for bend in BESIDE if bend > 2e-3)


def _jacobian(q):
    """The derivatives (2, 2) of x and y by the two joint angles."""
    first, both = q[0], q[0] + q[1]
    second = np.array([-np.sin(both), np.cos(both)])
    return np.column_stack([np.array([-np.sin(first), np.cos(first)]) + second, second])


def newton_step(q, xy, jacobian=_jacobian, solve=np.linalg.solve):
    """Return the joint angles (2,) after one Newton step from q (2,) towards the position xy
    (2,)."""
    return q + solve(jacobian(q), xy - two_link_tip(q))


def _cases(rng):
    simple = np.array([0.0, np.pi / 2]), np.array([1.1, 1.0])
    there = np.array([0.3, -1.2])
    xy = np.stack([np.cos(a := rng.uniform(0.3, 2.4, 4)), np.sin(a)], -1) * rng.uniform(
        1.4, 1.8, (4, 1)
    )
    elbow = two_link_angles(xy)[np.arange(4), [0, 1, 0, 1]]
    near_ones = elbow + rng.choice([-1, 1], (4, 2)) * rng.uniform(0.03, 0.2, (4, 2))
    # Joints beyond one revolution, and long steps: neither is wrapped, or shortened.
    far_ones = near_ones[:2] + 2 * np.pi * rng.choice([-2, -1, 1, 2], (2, 2))
    long_ones = [
        (np.array([0.3, 1.4]), np.array([-1.2, 0.9])),
        (np.array([2.9, -1.6]), np.array([1.5, 0.4])),
        # Positions far out of reach: steps of several revolutions.
        (rng.uniform(0.3, 1.4, 2), 40 * np.array([np.cos(a[0]), np.sin(a[0])])),
        (rng.uniform(0.3, 1.4, 2), -70 * np.array([np.cos(a[1]), np.sin(a[1])])),
    ]
    whole = [(np.array([1, 1]), np.array([1, 1])), (np.array([0, -2]), np.array([1.2, -0.8]))]
    return [
        simple,
        *zip(near_ones, xy, strict=True),
        (there, two_link_tip(there)),
        *zip(far_ones, xy, strict=False),
        *long_ones,
        *whole,
    ]


def _nearly_there(rng, gap):
    """Return angles that are off by the gap, and the position."""
    q = np.array([rng.uniform(0.2, 1.5), rng.choice([-1, 1]) * rng.uniform(0.6, 1.8)])
    return q + gap, two_link_tip(q)


def _nearly_singular(rng, bend):
    """Return angles of an arm that is nearly stretched, and a position a short way off."""
    q = np.array([rng.uniform(-3, 3), rng.choice([-1, 1]) * bend])
    return q, two_link_tip(q) + _jacobian(q) @ rng.uniform(0.2, 0.8, 2)


def _small(rng, size):
    q = np.array([size, rng.uniform(0.6, 1.8)])
    return q, two_link_tip(q) + size * rng.uniform(-0.4, 0.4, 2)


EXERCISE = Exercise(
    name="newton_step",
    points=2,
    arguments=("q", "xy"),
    cases=_cases,
    returns=numbers(lambda q, xy: (2,)),
    library=newton_step,
    tolerance=EXACT,
    sweeps=(
        Sweep("nearly at the position", _nearly_there),
        Sweep("a nearly stretched arm", _nearly_singular, _BENDS),
        Sweep("a small q1, before and after the step", _small, SMALL),
        Sweep("q1 and y nearly 0", lambda rng, x: (np.array([x, 1.2]), np.array([1.1, x])), SMALL),
    ),
    angles=("q",),
    properties=(
        Property(
            "if q leads to xy already, it stays as it is",
            lambda answer, q, xy: near(answer, q),
            where=lambda q, xy: np.array_equal(two_link_tip(q), xy),
        ),
        Property(
            "J times the change of q is p - f(q)",
            lambda answer, q, xy: near(answer, newton_step(q, xy)),
            mistake=Mistake(
                "the step is not J^-1 (p - f(q))",
                "Compare the columns of your J with differences of f for small changes of q1 and "
                "q2, and compare J times your step with p - f(q).",
            ),
        ),
    ),
    hints=(
        "The residual xy - f(q) is what the step has to make up for; near q, f changes by J times "
        "the step.",
        "The first row of J holds the derivatives of x = cos(q1) + cos(q1 + q2), the second those "
        "of y.",
        "np.linalg.solve(J, residual) is the change of q.",
    ),
    forbidden=("course_lib.lessons.decomposition_ik.grid_ik.planar_forward",),
)


@EXERCISE.mistake(
    "J is not inverted as it stands",
    "Do you take the transpose, J itself, or 1 / J entry by entry (as by **-1)?",
    solve=(
        lambda J, e: np.linalg.solve(J.T, e),
        lambda J, e: J.T @ e,
        lambda J, e: J @ e,
        lambda J, e: (1 / J) @ e,
    ),
)
def no_inverse(q, xy, solve):
    return newton_step(q, xy, solve=solve)


def _with_cosine_of_q2(q):
    """Return J with the sine and the cosine of q2 in place of those of q1 + q2."""
    first, second = (np.array([-np.sin(angle), np.cos(angle)]) for angle in q)
    return np.column_stack([first + second, second])


@EXERCISE.mistake(
    "a column of J is not the derivative by its angle",
    "Which links move with q1, which links move with q2, and in which direction?",
    jacobian=(
        _with_cosine_of_q2,
        lambda q: np.vstack([_jacobian(q)[0], _with_cosine_of_q2(q)[1]]),
        lambda q: np.vstack([_with_cosine_of_q2(q)[0], _jacobian(q)[1]]),
        lambda q: np.array([[-np.sin(q[0]), -np.sin(q[1])], [np.cos(q[0]), np.cos(q[1])]]),
        lambda q: _jacobian(q) - _jacobian(q)[:, 1:] * [1, 0],
        lambda q: (
            _jacobian(q)[:, 1:] * [1, 1] + (_jacobian(q)[:, :1] - _jacobian(q)[:, 1:]) * [0, 1]
        ),
        lambda q: _jacobian(q)[:, ::-1],
    ),
)
def another_jacobian(q, xy, jacobian):
    return newton_step(q, xy, jacobian)


@EXERCISE.mistake(
    "long steps are shortened",
    "Print J^-1 (p - f(q)) for the case below. By how much do your angles change?",
    recognises=True,
)
def shortened(answer, q, xy):
    step, right = answer - q, newton_step(q, xy) - q
    length = np.linalg.norm(right)
    shorter = np.linalg.norm(step) < 0.99 * length
    clipped = np.allclose(step, np.clip(right, -np.abs(step).max(), np.abs(step).max()), atol=EXACT)
    parallel = np.linalg.norm(step * length - right * np.linalg.norm(step)) < EXACT * length
    return length > 0.1 and shorter and step.any() and (clipped or parallel)


@EXERCISE.mistake(
    "more than one step is made",
    "How many steps does the task ask for?",
    steps=(2, 3, 5, 30),
)
def several_steps(q, xy, steps):
    for _ in range(steps):
        q = newton_step(q, xy)
    return q


@EXERCISE.mistake(
    "the step leads away from the position",
    "From which position to which position does p - f(q) lead?",
)
def away_from_the_target(q, xy):
    return 2 * q - newton_step(q, xy)


@EXERCISE.mistake(
    "the step itself is returned",
    "Which angles does the arm have after this step?",
)
def step_without_q(q, xy):
    return newton_step(q, xy) - q


@EXERCISE.mistake(
    "the angles are brought between -pi and pi, or between 0 and 2 pi",
    "Does the formula in the task change an angle by whole revolutions?",
    wrap=(lambda q: np.arctan2(np.sin(q), np.cos(q)), lambda q: q % (2 * np.pi)),
)
def wrapped(q, xy, wrap):
    return wrap(newton_step(q, xy))


@EXERCISE.mistake(
    "the step is damped",
    "Which matrix stands before p - f(q) in a Newton step?",
    eps=(1e-6, 1e-4, 1e-2),
)
def damped(q, xy, eps):
    return newton_step(
        q, xy, solve=lambda J, e: J.T @ np.linalg.solve(J @ J.T + eps * np.eye(2), e)
    )
