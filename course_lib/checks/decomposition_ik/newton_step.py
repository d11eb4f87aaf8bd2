"""newton_step: one step of Newton's method from approximate joint angles towards a position."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.decomposition_ik.two_links import place, solutions
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.vocabulary import near


def jacobian(theta):
    """Return the derivatives (2, 2) of x and y by the two joint angles."""
    first, both = theta[0], theta[0] + theta[1]
    second = np.array([-np.sin(both), np.cos(both)])
    return np.column_stack([np.array([-np.sin(first), np.cos(first)]) + second, second])


def _step(change):
    """Return the answer that adds change(J, residual) to the angles."""
    return lambda theta, xy: theta + change(jacobian(theta), xy - place(theta))


right = _step(np.linalg.solve)


def _cases(rng):
    simple = np.array([0.0, np.pi / 2]), np.array([1.1, 1.0])
    there = np.array([0.3, -1.2])
    xy = np.stack([np.cos(a := rng.uniform(0.3, 2.4, 4)), np.sin(a)], -1) * rng.uniform(1.4, 1.8, (4, 1))
    elbow = solutions(xy)[np.arange(4), [0, 1, 0, 1]]
    near_ones = elbow + rng.choice([-1, 1], (4, 2)) * rng.uniform(0.03, 0.2, (4, 2))
    return [simple, *zip(near_ones, xy, strict=True), (there, place(there))]


def _absolute(theta):
    """The Jacobian of those who take theta2 for the direction of the second link."""
    return np.array([[-np.sin(theta[0]), -np.sin(theta[1])], [np.cos(theta[0]), np.cos(theta[1])]])


EXERCISE = Exercise(
    name="newton_step",
    points=2,
    arguments=("theta", "xy"),
    cases=_cases,
    returns=numbers(lambda theta, xy: (2,)),
    properties=(
        Property(
            "if theta leads to xy already, it stays as it is",
            lambda answer, theta, xy: near(answer, theta),
            where=lambda theta, xy: near(place(theta), xy),
        ),
        Property(
            "J times the change of theta is xy - f(theta)",
            lambda answer, theta, xy: near(answer, right(theta, xy)),
        ),
    ),
    mistakes=(
        Mistake(
            "the step leads away from xy",
            "The residual is the target minus the position reached.",
            _step(lambda J, e: -np.linalg.solve(J, e)),
        ),
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
            "only the change is returned",
            "Add it to theta.",
            lambda theta, xy: np.linalg.solve(jacobian(theta), xy - place(theta)),
        ),
        Mistake(
            "the position reached is not subtracted",
            "The step has to mend what is missing: xy minus the position that theta reaches.",
            lambda theta, xy: theta + np.linalg.solve(jacobian(theta), xy),
        ),
        Mistake(
            "theta2 is taken for the direction of the second link",
            "The second link points along theta1 + theta2.",
            lambda theta, xy: theta + np.linalg.solve(_absolute(theta), xy - place(theta)),
        ),
        Mistake(
            "the second link does not move with theta1",
            "theta1 moves both links: its column has two terms in each row.",
            _step(lambda J, e: np.linalg.solve(np.column_stack([J[:, 0] - J[:, 1], J[:, 1]]), e)),
        ),
        Mistake(
            "the columns of J are swapped",
            "The first column belongs to theta1.",
            _step(lambda J, e: np.linalg.solve(J[:, ::-1], e)),
        ),
        Mistake("theta is returned as it came", "Add the step.", lambda theta, xy: theta),
        Mistake(
            "more than one step is made",
            "One step is asked; whoever needs more calls the function again.",
            lambda theta, xy: right(right(theta, xy), xy),
            lambda theta, xy: right(right(right(theta, xy), xy), xy),
        ),
    ),
    hints=(
        "The residual xy - f(theta) is what the step has to make up for; near theta, f changes by J times the step.",
        "The first row of J holds the derivatives of x = cos(theta1) + cos(theta1 + theta2), the second those of y.",
        "np.linalg.solve(J, residual) is the change of theta.",
    ),
    library=right,
)
