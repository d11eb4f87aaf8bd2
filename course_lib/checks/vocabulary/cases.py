"""Random arguments for cases, away from special values."""

import functools
import itertools

import numpy as np

from course_lib.rotations import exp_so3

X, Y, Z = np.eye(3)


def unit(rng):
    """Return a unit vector (3,) in a direction drawn uniformly.

    Examples
    --------
    >>> round(float(np.linalg.norm(unit(np.random.default_rng(0)))), 12)
    1.0
    """
    v = rng.normal(size=3)
    return v / np.linalg.norm(v)


def away_from_zero(rng, shape, low=0.3, high=1.4):
    """Return numbers of either sign, to two digits, whose sizes lie between `low` and `high`.

    Examples
    --------
    >>> away_from_zero(np.random.default_rng(0), 3)
    array([0.35, 0.32, 1.19])
    """
    return np.round(rng.choice([-1, 1], shape) * rng.uniform(low, high, shape), 2)


def any_rotation(rng, low=0.8, high=2.2):
    """Return a rotation matrix (3, 3) whose angle lies between `low` and `high` (rad).

    Examples
    --------
    >>> R = any_rotation(np.random.default_rng(0), low=1, high=1)
    >>> round(float(np.arccos((np.trace(R) - 1) / 2)), 12)
    1.0
    """
    return exp_so3(rng.uniform(low, high) * unit(rng))


def any_pose(rng):
    """Return a pose (4, 4) whose rotation angle lies between 0.8 and 2.2 rad and whose entries of p are not small.

    Examples
    --------
    >>> T = any_pose(np.random.default_rng(0))
    >>> T[3].tolist(), bool((abs(T[:3, 3]) >= 0.4).all())
    ([0.0, 0.0, 0.0, 1.0], True)
    """
    return pose(any_rotation(rng), away_from_zero(rng, 3, 0.4, 1.5))


def pose(R, p, *row):
    """Return the matrix [[R, p], [row]]; without a row, that of a pose.

    Examples
    --------
    >>> pose([[0, -1], [1, 0]], [3, 4])
    array([[ 0., -1.,  3.],
           [ 1.,  0.,  4.],
           [ 0.,  0.,  1.]])
    """
    n = len(p)
    T = np.eye(n + 1)
    T[:n, :n], T[:n, n] = R, p
    T[n] = row or T[n]
    return T


def products(matrices):
    """Return the products of the first 0, 1, ..., n matrices (4, 4).

    Examples
    --------
    >>> [int(T[0, 3]) for T in products([pose(np.eye(3), [2, 0, 0]), pose(np.eye(3), [3, 0, 0])])]
    [0, 2, 5]
    """
    return list(itertools.accumulate(matrices, np.matmul, initial=np.eye(4)))


def remembered(function):
    """Return a function of arrays with a cache, because all mistakes of an exercise need the same results.

    Examples
    --------
    >>> remembered(np.sum)([1, 2])
    np.float64(3.0)
    """

    @functools.lru_cache(maxsize=1000)
    def again(*packed):
        return function(*(np.frombuffer(data).reshape(shape) for data, shape in packed))

    @functools.wraps(function)
    def ask(*arrays):
        return again(*((np.asarray(array, float).tobytes(), np.shape(array)) for array in arrays))

    return ask
