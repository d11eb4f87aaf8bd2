"""newton_step: one step of Newton's method from approximate joint angles towards a position."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercises.decomposition_ik.shared import position, solutions
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.vocabulary import near, wrong_steps


def jacobian(q):
    """Return the derivatives (2, 2) of x and y by the two joint angles."""
    first, both = q[0], q[0] + q[1]
    second = np.array([-np.sin(both), np.cos(both)])
    return np.column_stack([np.array([-np.sin(first), np.cos(first)]) + second, second])


def _step(change):
    """Return the answer that adds change(J, residual) to the angles."""
    return lambda q, xy: q + change(jacobian(q), xy - position(q))


right = _step(np.linalg.solve)


def _cases(rng):
    simple = np.array([0.0, np.pi / 2]), np.array([1.1, 1.0])
    there = np.array([0.3, -1.2])
    xy = np.stack([np.cos(a := rng.uniform(0.3, 2.4, 4)), np.sin(a)], -1) * rng.uniform(1.4, 1.8, (4, 1))
    elbow = solutions(xy)[np.arange(4), [0, 1, 0, 1]]
    near_ones = elbow + rng.choice([-1, 1], (4, 2)) * rng.uniform(0.03, 0.2, (4, 2))
    return [simple, *zip(near_ones, xy, strict=True), (there, position(there))]


def _absolute(q):
    """The Jacobian of those who take q2 for the direction of the second link."""
    return np.array([[-np.sin(q[0]), -np.sin(q[1])], [np.cos(q[0]), np.cos(q[1])]])


def _second_along_first(q):
    """The Jacobian of those who differentiate the second link as if it pointed along q1."""
    J = np.array([[-np.sin(q[0]), -np.sin(q[0])], [np.cos(q[0]), np.cos(q[0])]])
    J[:, 0] += jacobian(q)[:, 1]
    return J


def _step_from(changed):
    return lambda q, xy: q + np.linalg.solve(changed(q), xy - position(q))


_SIGNS = [np.where(np.reshape(flipped, (2, 2)), -1, 1) for flipped in np.ndindex(2, 2, 2, 2) if 0 < sum(flipped) < 4]

EXERCISE = Exercise(
    name="newton_step",
    points=2,
    arguments=("q", "xy"),
    cases=_cases,
    returns=numbers(lambda q, xy: (2,)),
    properties=(
        Property(
            "if q leads to xy already, it stays as it is",
            lambda answer, q, xy: near(answer, q),
            where=lambda q, xy: near(position(q), xy),
        ),
        Property(
            "J times the change of q is xy - f(q)",
            lambda answer, q, xy: near(answer, right(q, xy)),
        ),
    ),
    mistakes=(
        *wrong_steps(right),
        Mistake(
            "the Jacobian is transposed",
            "Rows belong to x and y, columns to the joints.",
            _step(lambda J, e: np.linalg.solve(J.T, e)),
        ),
        Mistake(
            "the transpose of J stands for its inverse",
            "That is a gradient step. Newton's step solves J step = residual.",
            _step(lambda J, e: J.T @ e),
        ),
        Mistake("J stands for its inverse", "Solve J step = residual for the step.", _step(lambda J, e: J @ e)),
        Mistake(
            "each entry of J is inverted by itself",
            "J**-1 is 1 / J, entry by entry. np.linalg.solve(J, residual) solves J step = residual.",
            _step(lambda J, e: (1 / J) @ e),
        ),
        Mistake(
            "an entry of J has the wrong sign",
            "The derivative of the cosine is minus the sine, that of the sine is the cosine.",
            *(_step(lambda J, e, signs=signs: np.linalg.solve(J * signs, e)) for signs in _SIGNS),
        ),
        Mistake(
            "the position that q leads to is not subtracted from xy",
            "The residual is xy - fk_2r(q): the position asked for minus the position reached.",
            lambda q, xy: q + np.linalg.solve(jacobian(q), xy - q),
            lambda q, xy: q + np.linalg.solve(jacobian(q), xy),
        ),
        Mistake(
            "q2 is taken for the direction of the second link",
            "The second link points along q1 + q2.",
            lambda q, xy: q + np.linalg.solve(_absolute(q), xy - position(q)),
            _step_from(_second_along_first),
        ),
        Mistake(
            "the second link does not move with q1",
            "q1 moves both links: its column has two terms in each row.",
            _step(lambda J, e: np.linalg.solve(np.column_stack([J[:, 0] - J[:, 1], J[:, 1]]), e)),
        ),
        Mistake(
            "the columns of J are swapped",
            "The first column belongs to q1.",
            _step(lambda J, e: np.linalg.solve(J[:, ::-1], e)),
        ),
        Mistake(
            "more than one step is made",
            "One step is asked; call the function again for more.",
            lambda q, xy: right(right(q, xy), xy),
            lambda q, xy: right(right(right(q, xy), xy), xy),
        ),
        Mistake(
            "the exact solution is returned, not one step",
            "Return the angles after one step: neither the closed form nor a loop is needed.",
            seen=lambda answer, q, xy: near(position(answer), xy) and not near(answer, q),
        ),
    ),
    hints=(
        "The residual xy - f(q) is what the step has to make up for; near q, f changes by J times the step.",
        "The first row of J holds the derivatives of x = cos(q1) + cos(q1 + q2), the second those of y.",
        "np.linalg.solve(J, residual) is the change of q.",
    ),
    library=right,
)
