"""newton_step: one step of Newton's method from approximate joint angles towards a position."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.kinds import QUARTER, joint_angles, quarters, vector
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import BESIDE, SMALL, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import two_link_angles, two_link_tip, wrapped

# rad: with a smaller bend, rounding is multiplied by more than 1,000.
_BENDS = tuple(bend for bend in BESIDE if bend > 2e-3)


def _jacobian(q):
    """The derivatives (2, 2) of x and y by the two joint angles."""
    first, both = q[0], q[0] + q[1]
    second = np.array([-np.sin(both), np.cos(both)])
    return np.column_stack([np.array([-np.sin(first), np.cos(first)]) + second, second])


def _stepped(jacobian=_jacobian, solve=np.linalg.solve):
    """Return the answer q + solve(jacobian(q), xy - f(q))."""
    return lambda q, xy: q + solve(jacobian(q), xy - two_link_tip(q))


_right = _stepped()

# Angles of an arm that is neither stretched nor folded.
_ANGLES = joint_angles(2).but(
    named=lambda rng: [np.array([0.0, np.pi / 2]), np.array([1.0, 1]), np.array([0.0, -2])],
    coarse=lambda rng: np.array([quarters(rng), QUARTER * rng.choice([-3, -1, 1, 3])]),
)


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
    return [
        simple,
        *zip(near_ones, xy, strict=True),
        (there, two_link_tip(there)),
        *zip(far_ones, xy, strict=False),
        *long_ones,
        (np.array([1.0, 1]), np.array([1.0, 1])),
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


def _with_cosine_of_q2(q):
    """Return J with the sine and the cosine of q2 in place of those of q1 + q2."""
    first, second = (np.array([-np.sin(angle), np.cos(angle)]) for angle in q)
    return np.column_stack([first + second, second])


def _first_column_of_one_link(q):
    return _jacobian(q) - _jacobian(q)[:, 1:] * [1, 0]


def _second_column_of_the_first_link(q):
    first, second = _jacobian(q).T
    return np.column_stack([second, first - second])


def _shortened(answer, q, xy):
    step, right = answer - q, _right(q, xy) - q
    length = np.linalg.norm(right)
    shorter = np.linalg.norm(step) < 0.99 * length
    clipped = np.allclose(step, np.clip(right, -np.abs(step).max(), np.abs(step).max()), atol=EXACT)
    parallel = np.linalg.norm(step * length - right * np.linalg.norm(step)) < EXACT * length
    return length > 0.1 and shorter and step.any() and (clipped or parallel)


def _several_steps(n):
    def answer(q, xy):
        for _ in range(n):
            q = _right(q, xy)
        return q

    return answer


def _damped(eps):
    return _stepped(solve=lambda J, e: J.T @ np.linalg.solve(J @ J.T + eps * np.eye(2), e))


EXERCISE = declared(
    "newton_step",
    points=2,
    arguments={"q": _ANGLES, "xy": vector(2)},
    cases=_cases,
    tolerance=EXACT,
    library=_right,
    says="J times the change of q is p - f(q)",
    otherwise=Question(
        "the step is not J^-1 (p - f(q))",
        "Compare the columns of your J with differences of f for small changes of q1 and q2, and "
        "compare J times your step with p - f(q). What becomes of the step afterwards?",
    ),
    sweeps=(
        Sweep("nearly at the position", _nearly_there),
        Sweep("a nearly stretched arm", _nearly_singular, _BENDS),
        Sweep("a small q1, before and after the step", _small, SMALL),
        Sweep("q1 and y nearly 0", lambda rng, x: (np.array([x, 1.2]), np.array([1.1, x])), SMALL),
    ),
    hints=(
        "The residual xy - f(q) is what the step has to make up for; near q, f changes by J times "
        "the step.",
        "The first row of J holds the derivatives of x = cos(q1) + cos(q1 + q2), the second those "
        "of y.",
        "np.linalg.solve(J, residual) is the change of q.",
    ),
    forbidden=("course_lib.lessons.decomposition_ik.grid_ik.planar_forward",),
    mistakes=(
        Mistake(
            "J is not inverted as it stands",
            "Do you take the transpose, J itself, or 1 / J entry by entry (as by **-1)?",
            _stepped(solve=lambda J, e: np.linalg.solve(J.T, e)),
            _stepped(solve=lambda J, e: J.T @ e),
            _stepped(solve=lambda J, e: J @ e),
            _stepped(solve=lambda J, e: (1 / J) @ e),
        ),
        Mistake(
            "a column of J is not the derivative by its angle",
            "Which links move with q1, which links move with q2, and in which direction?",
            _stepped(_with_cosine_of_q2),
            _stepped(lambda q: np.vstack([_jacobian(q)[0], _with_cosine_of_q2(q)[1]])),
            _stepped(lambda q: np.vstack([_with_cosine_of_q2(q)[0], _jacobian(q)[1]])),
            _stepped(lambda q: np.array([-np.sin(q), np.cos(q)])),
            _stepped(_first_column_of_one_link),
            _stepped(_second_column_of_the_first_link),
            _stepped(lambda q: _jacobian(q)[:, ::-1]),
        ),
        Mistake(
            "long steps are shortened",
            "Print J^-1 (p - f(q)) for the case below. By how much do your angles change?",
            seen=_shortened,
        ),
        Mistake(
            "more than one step is made",
            "How many steps does the task ask for?",
            *map(_several_steps, (2, 3, 5, 30)),
        ),
        Mistake(
            "the step leads away from the position",
            "From which position to which position does p - f(q) lead?",
            lambda q, xy: 2 * q - _right(q, xy),
        ),
        Mistake(
            "the step itself is returned",
            "Which angles does the arm have after this step?",
            lambda q, xy: _right(q, xy) - q,
        ),
        wrapped(_right),
        Mistake(
            "the step is damped",
            "Which matrix stands before p - f(q) in a Newton step?",
            *map(_damped, (1e-6, 1e-4, 1e-2)),
        ),
    ),
)
