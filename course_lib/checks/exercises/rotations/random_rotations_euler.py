"""random_rotations_euler: the naive sampler, which has to be naive in the published manner."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.rotations.sampling import (
    CIRCLE,
    DRAWS,
    LEVEL,
    ROTATIONS,
    cases,
    cells_p_value,
    has_gaps,
    many,
    nearly_uniform,
    of_many,
    tied,
    uniform,
)
from course_lib.rotations import rot_x, rot_y, rot_z


def _right(n, rng):
    alpha, beta, gamma = rng.random((3, n)) * [[2 * np.pi], [np.pi], [2 * np.pi]]
    return rot_z(gamma) @ rot_y(beta) @ rot_x(alpha)


def _angles(R):
    """(alpha, beta, gamma) of R = Rz(gamma) Ry(beta) Rx(alpha), beta in [-pi/2, pi/2].

    With beta beyond pi/2, alpha + pi, pi - beta and gamma + pi are read off, which are the same rotation: what is
    uniform and independent stays so. So beta from [0, pi/2) alone gives the same distribution, and is right too.
    """
    return (
        np.arctan2(R[:, 2, 1], R[:, 2, 2]),
        np.arcsin(np.clip(-R[:, 2, 0], -1, 1)),
        np.arctan2(R[:, 1, 0], R[:, 0, 0]),
    )


_RANGES = [CIRCLE, (0, np.pi / 2), CIRCLE]


def _signs(R, i, j):
    """Return which signs R[i, j] has among the draws: (any negative, any positive)."""
    return bool(R[:, i, j].min() < -1e-12), bool(R[:, i, j].max() > 1e-12)


_BOTH, _NEVER_POSITIVE, _NEVER_NEGATIVE = (True, True), (True, False), (False, True)


def _in_one_half(R):
    alpha, _, gamma = _angles(R)
    return not has_gaps(alpha, *CIRCLE) and np.mean(np.sin(alpha) * np.sin(gamma) >= 0) > 0.999


EXERCISE = Exercise(
    name="random_rotations_euler",
    points=1,
    arguments=("n", "rng"),
    cases=cases,
    returns=numbers(lambda n, rng: (n, 3, 3)),
    library=_right,
    properties=(
        ROTATIONS,
        *DRAWS,
        Property(
            "beta is drawn from [0, pi], so R[2, 0] = -sin(beta) is never positive",
            lambda R, n, rng: R[:, 2, 0].max() <= 1e-12,
            says=lambda R, n, rng: f"The share of positive ones is {np.mean(R[:, 2, 0] > 1e-12):.2f}.",
            where=many,
        ),
        Property(
            "beta is drawn uniformly",
            lambda R, n, rng: uniform(_angles(R)[1], 0, np.pi / 2),
            where=many,
            mistake=Mistake("beta is not uniform in [0, pi]", "What does rng.random(n) have to be multiplied by?"),
        ),
        Property(
            "alpha and gamma are drawn uniformly from the full circle",
            lambda R, n, rng: all(uniform(_angles(R)[i], *CIRCLE) for i in (0, 2)),
            where=many,
            mistake=Mistake(
                "alpha or gamma is not uniform on the full circle", "What does rng.random(n) have to be multiplied by?"
            ),
        ),
        Property(
            "the three angles are drawn independently",
            lambda R, n, rng: cells_p_value(_angles(R), _RANGES, (6, 4, 6)) > LEVEL,
            where=many,
        ),
    ),
    hints=(
        "Draw alpha, beta, gamma as three arrays of n numbers.",
        "rng.random(n) is uniform in [0, 1): scale it by 2 pi, pi, 2 pi.",
        "rot_x, rot_y and rot_z take arrays of angles; the first to act stands on the right: Rz(gamma) Ry(beta) "
        "Rx(alpha).",
    ),
)


def _product(n, rng, factors=(2 * np.pi, np.pi, 2 * np.pi), shift=0):
    alpha, beta, gamma = rng.random((3, n)) * np.array(factors)[:, None]
    return rot_z(gamma) @ rot_y(beta + shift) @ rot_x(alpha)


@EXERCISE.mistake(seen=of_many(lambda R: tied(_angles(R), _RANGES)), count=(1, 2))
def one_draw_for_two(n, rng, count):
    """the same draw serves for several of the three numbers. Each is independent: it needs its own numbers."""
    x, y = rng.random((2, n))
    return rot_z(2 * np.pi * x) @ rot_y(np.pi * (x if count == 1 else y)) @ rot_x(2 * np.pi * x)


@EXERCISE.mistake(seen=of_many(_in_one_half))
def half_the_circle(n, rng):
    """alpha and gamma are drawn from half the circle. Only beta ends at pi."""
    return _product(n, rng, (np.pi, np.pi, np.pi))


@EXERCISE.mistake(seen=of_many(lambda R: _signs(R, 2, 0) == _BOTH and _signs(R, 0, 2) == _NEVER_NEGATIVE))
def other_order(n, rng):
    """the factors stand in the other order, Rx Ry Rz. The rotation about x is the first to act: on which side does
    it stand?"""
    alpha, beta, gamma = rng.random((3, n)) * [[2 * np.pi], [np.pi], [2 * np.pi]]
    return rot_x(alpha) @ rot_y(beta) @ rot_z(gamma)


@EXERCISE.mistake(seen=of_many(lambda R: _signs(R, 2, 0) == _BOTH and _signs(R, 0, 2) == _NEVER_POSITIVE))
def transposed(n, rng):
    """the rotations are transposed: their signs are those of R^T. Check the signs of the sines in your Rx, Ry, Rz."""
    return np.swapaxes(_product(n, rng), 1, 2)


@EXERCISE.mistake(
    seen=of_many(lambda R: nearly_uniform(_angles(R)[1], -np.pi / 2, np.pi / 2)),
    beta=((2 * np.pi, 0), (np.pi, -np.pi / 2), (180, 0)),
)
def beta_range(n, rng, beta):
    """beta is drawn from the full circle, from -pi/2 to pi/2, or in degrees. The task takes beta from [0, pi), in
    radians."""
    return _product(n, rng, (2 * np.pi, beta[0], 2 * np.pi), beta[1])
