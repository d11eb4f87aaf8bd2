"""random_rotations_euler: the naive sampler, which is to be naive in the published way."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.rotations.sampling import (
    DRAWS,
    LEVEL,
    ROTATIONS,
    TIED,
    cases,
    cells_p_value,
    even,
    gaps,
    many,
    nearly_even,
    of_many,
    tied,
)


def _angles(R):
    """(alpha, beta, gamma) of R = Rz(gamma) Ry(beta) Rx(alpha), beta in [-pi/2, pi/2].

    With beta beyond pi/2, alpha + pi, pi - beta and gamma + pi are read off: what is even and independent stays so.
    """
    return (
        np.arctan2(R[:, 2, 1], R[:, 2, 2]),
        np.arcsin(np.clip(-R[:, 2, 0], -1, 1)),
        np.arctan2(R[:, 1, 0], R[:, 0, 0]),
    )


_RANGES = [(-np.pi, np.pi), (0, np.pi / 2), (-np.pi, np.pi)]


def _entry(R, i, j):
    """Which signs R[i, j] has among the draws: (any negative, any positive)."""
    return bool(R[:, i, j].min() < -1e-12), bool(R[:, i, j].max() > 1e-12)


_BOTH, _NEVER_POSITIVE, _NEVER_NEGATIVE = (True, True), (True, False), (False, True)


def _other_order(R):
    return _entry(R, 2, 0) == _BOTH and _entry(R, 0, 2) == _NEVER_NEGATIVE


def _transposed(R):
    return _entry(R, 2, 0) == _BOTH and _entry(R, 0, 2) == _NEVER_POSITIVE


def _other_range(R):
    return nearly_even(_angles(R)[1], -np.pi / 2, np.pi / 2)


def _one_axis_twice(R):
    """R = Rz Ry Rz has cos(beta) in one corner, R = Rx Ry Rx in the other."""
    return any(even(np.arccos(np.clip(R[:, i, i], -1, 1)), 0, np.pi) for i in (0, 2))


def _in_one_half(R):
    alpha, _, gamma = _angles(R)
    return not gaps(alpha, -np.pi, np.pi) and np.mean(np.sin(alpha) * np.sin(gamma) >= 0) > 0.999


RANDOM_ROTATIONS_EULER = Exercise(
    name="random_rotations_euler",
    points=1,
    arguments=("n", "rng"),
    cases=cases,
    returns=numbers(lambda n, rng: (n, 3, 3)),
    properties=(
        ROTATIONS,
        *DRAWS,
        Property(
            "beta is drawn from [0, pi], so R[2, 0] = -sin(beta) is never positive",
            lambda R, n, rng: R[:, 2, 0].max() <= 1e-12,
            seen=lambda R, n, rng: f"The share of positive ones is {np.mean(R[:, 2, 0] > 1e-12):.2f}.",
            where=many,
        ),
        Property(
            "beta is drawn evenly",
            lambda R, n, rng: even(_angles(R)[1], 0, np.pi / 2),
            where=many,
            mistake=Mistake("beta is not drawn evenly from [0, pi]", "np.pi * rng.random(n)"),
        ),
        Property(
            "alpha and gamma are drawn evenly from the full turn",
            lambda R, n, rng: all(even(_angles(R)[i], -np.pi, np.pi) for i in (0, 2)),
            where=many,
            mistake=Mistake("alpha or gamma does not cover a full turn evenly", "2 * np.pi * rng.random(n) for each"),
        ),
        Property(
            "the three angles are drawn independently",
            lambda R, n, rng: cells_p_value(_angles(R), _RANGES, (6, 4, 6)) > LEVEL,
            where=many,
            mistake=TIED,
        ),
    ),
    mistakes=(
        Mistake(TIED.name, TIED.hint, seen=of_many(lambda R: tied(_angles(R), _RANGES))),
        Mistake(
            "alpha and gamma are drawn from half a turn",
            "Only beta is: 2 * np.pi * rng.random(n) for the other two.",
            seen=of_many(_in_one_half),
        ),
        Mistake(
            "the factors stand in the other order, Rx Ry Rz",
            "R = Rz Ry Rx turns about x first; it stands on the right.",
            seen=of_many(_other_order),
        ),
        Mistake(
            "the rotations are transposed: their signs are those of R^T",
            "Look at the signs of the sines in your Rx, Ry, Rz.",
            seen=of_many(_transposed),
        ),
        Mistake(
            "the sine in Ry has the other sign",
            "Ry takes e_z towards e_x: Ry[0, 2] = +sin(beta), Ry[2, 0] = -sin(beta).",
            seen=of_many(lambda R: _entry(R, 2, 0) == _NEVER_NEGATIVE),
        ),
        Mistake(
            "the first and the last turn are about the same axis, as in Rz Ry Rz",
            "Rz(gamma) Ry(beta) Rx(alpha): each axis once.",
            seen=of_many(_one_axis_twice),
        ),
        Mistake(
            "beta is drawn from a full turn, from -pi/2 to pi/2, or in degrees",
            "The naive sampler of the report takes [0, pi], in radians: np.pi * rng.random(n).",
            seen=of_many(_other_range),
        ),
    ),
    hints=(
        "Draw alpha, beta, gamma as arrays of n numbers: 2 pi, pi and 2 pi times rng.random(n).",
        "Rz(gamma) Ry(beta) Rx(alpha): the first to act stands on the right.",
        "rot_x, rot_y and rot_z of the library take arrays of angles.",
    ),
    forbidden=(),
)
