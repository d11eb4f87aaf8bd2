"""Random arguments for cases, away from special values."""

import functools
import itertools

import numpy as np

from course_lib.rotations import exp_so3

X, Y, Z = np.eye(3)


def unit(rng):
    """Return a unit vector (3,) in a direction drawn uniformly."""
    v = rng.normal(size=3)
    return v / np.linalg.norm(v)


def away_from_zero(rng, shape, low=0.3, high=1.4):
    """Return numbers of either sign, to two digits, none of them small."""
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
    """Return the function of arrays with a cache, because all mistakes of an exercise need the same results."""

    @functools.lru_cache(maxsize=128)
    def again(*packed):
        return function(*(np.frombuffer(data).reshape(shape) for data, shape in packed))

    @functools.wraps(function)
    def ask(*arrays):
        return again(*((np.asarray(array, float).tobytes(), np.shape(array)) for array in arrays))

    return ask
