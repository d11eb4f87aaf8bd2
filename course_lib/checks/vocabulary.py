"""Cases, comparisons and properties that exercises of several notebooks share."""

import functools
import itertools

import numpy as np

from course_lib.checks.exercise import Mistake, Property, same
from course_lib.rotations import exp_so3

X, Y, Z = np.eye(3)


def unit(rng):
    """Return a unit vector (3,) in a direction drawn uniformly."""
    v = rng.normal(size=3)
    return v / np.linalg.norm(v)


def away_from_zero(rng, shape, low=0.3, high=1.4):
    """Return numbers of either sign, to two digits, whose sizes lie between `low` and `high`."""
    return np.round(rng.choice([-1, 1], shape) * rng.uniform(low, high, shape), 2)


def any_rotation(rng, low=0.8, high=2.2):
    """Return a rotation matrix (3, 3) whose angle lies between `low` and `high` (rad)."""
    return exp_so3(rng.uniform(low, high) * unit(rng))


def any_pose(rng):
    """Return a pose (4, 4) whose rotation angle lies between 0.8 and 2.2 rad and whose entries of p are not small."""
    return pose(any_rotation(rng), away_from_zero(rng, 3, 0.4, 1.5))


def pose(R, p, *row):
    """Return the matrix [[R, p], [row]]; without a row, that of a pose."""
    n = len(p)
    T = np.eye(n + 1)
    T[:n, :n], T[:n, n] = R, p
    T[n] = row or T[n]
    return T


def products(matrices):
    """Return the products of the first 0, 1, ..., n matrices (4, 4)."""
    return list(itertools.accumulate(matrices, np.matmul, initial=np.eye(4)))


def remembered(function):
    """Return a function of arrays with a cache, because all mistakes of an exercise need the same results."""

    @functools.lru_cache(maxsize=1000)
    def again(*packed):
        return function(*(np.frombuffer(data).reshape(shape) for data, shape in packed))

    @functools.wraps(function)
    def ask(*arrays):
        return again(*((np.asarray(array, float).tobytes(), np.shape(array)) for array in arrays))

    return ask


def partial_sum(M, terms):
    """Return the sum of so many terms of the exponential series of M; None if it has converged."""
    total = sum(itertools.accumulate(range(1, terms), lambda term, k: term @ M / k, initial=np.eye(len(M))))
    following = sum(itertools.accumulate(range(1, terms + 1), lambda term, k: term @ M / k, initial=np.eye(len(M))))
    return None if np.allclose(total, following, rtol=1e-11, atol=1e-11) else total


# ---- comparisons; as `alike` of an exercise, they also take the arguments of the case ----

FINE = 1e-9  # the error that a right answer may have, relative to its size


def near(answer, right, *arguments):
    """Return whether an answer is right: the error is at most FINE times the largest entry, or FINE if that is below 1.

    An empty array is right.
    """
    return np.abs(answer - right).max(initial=0) <= FINE * max(1, np.abs(right).max(initial=0))


def same_up_to_sign(value, predicted, *arguments):
    """Return whether two quaternions (4,) are the same up to their sign."""
    return same(value, predicted) or same(value, -np.asarray(predicted, float))


def same_angles(value, predicted, *arguments, tolerance=1e-6):
    """Return whether angles of any shape are the same up to multiples of 2 pi."""
    return np.shape(value) == np.shape(predicted) and angle_gap(value, predicted) < tolerance


def angle_gap(angles, wanted):
    """Return the largest difference between angles and those wanted, up to multiples of 2 pi."""
    return np.abs(np.angle(np.exp(1j * (np.asarray(angles) - wanted)))).max(initial=0)


def orthogonality_error(R):
    """Return the largest entry of R^T R - I, by its absolute value."""
    return np.abs(R.T @ R - np.eye(R.shape[1])).max()


def _first_otherwise(values, cases):
    """The position of the first case that was asked before and answered otherwise."""
    for (i, earlier), (j, later) in itertools.combinations(enumerate(cases), 2):
        if all(np.array_equal(a, b) for a, b in zip(earlier, later, strict=True)) and not near(values[j], values[i]):
            return j
    return None


SAME_TWICE = Property(
    "called a second time with the same arguments, the function gives the same result",
    _first_otherwise,
    across=True,
    mistake=Mistake(
        "something is kept from one call to the next",
        "A list outside the function, or a default like products=[], is made once only and grows or shrinks with "
        "each call. Make it inside the function.",
    ),
)
