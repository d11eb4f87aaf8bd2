"""Compare two answers. As `alike` of an exercise, these functions also take the arguments of the case."""

import numpy as np

from course_lib.checks.exercise import same

FINE = 1e-9  # the error that a right answer may have, relative to its size


def near(answer, right, *arguments):
    """Return whether an answer is right: the error is at most FINE times the largest entry, or FINE if that is below 1.

    An empty array is right.

    Examples
    --------
    >>> bool(near(np.array([1000 + 1e-7]), np.array([1000.0]))), bool(near(np.array([1e-7]), np.array([0.0])))
    (True, False)
    """
    return np.abs(answer - right).max(initial=0) <= FINE * max(1, np.abs(right).max(initial=0))


def same_up_to_sign(value, predicted, *arguments):
    """Return whether two quaternions (4,) are the same up to their sign.

    Examples
    --------
    >>> same_up_to_sign([0, 1, 0, 0], [0, -1, 0, 0])
    True
    """
    return same(value, predicted) or same(value, -np.asarray(predicted, float))


def same_angles(value, predicted, *arguments, tolerance=1e-6):
    """Return whether angles of any shape are the same up to multiples of 2 pi.

    Examples
    --------
    >>> bool(same_angles([np.pi, 0], [-np.pi, 2 * np.pi]))
    True
    """
    return np.shape(value) == np.shape(predicted) and angle_gap(value, predicted) < tolerance


def angle_gap(angles, wanted):
    """Return the largest difference between angles and those wanted, up to multiples of 2 pi.

    Examples
    --------
    >>> round(float(angle_gap([3.0, 0.1], np.array([3.0, 2 * np.pi]))), 12)
    0.1
    """
    return np.abs(np.angle(np.exp(1j * (np.asarray(angles) - wanted)))).max(initial=0)


def same_with_gaps(value, predicted, *arguments, tolerance=1e-6):
    """Return whether two arrays are the same, nan at the same entries included.

    Examples
    --------
    >>> same_with_gaps([1, np.nan], [1, np.nan])
    True
    """
    value, predicted = np.asarray(value, float), np.asarray(predicted, float)
    return value.shape == predicted.shape and np.allclose(
        value, predicted, rtol=tolerance, atol=tolerance, equal_nan=True
    )


def orthogonality_error(R):
    """Return the largest entry of R^T R - I, by its absolute value.

    Examples
    --------
    >>> float(orthogonality_error(2 * np.eye(3)))
    3.0
    """
    return np.abs(R.T @ R - np.eye(R.shape[1])).max()
