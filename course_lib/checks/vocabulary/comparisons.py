"""Compare two answers. As `alike` of an exercise, these functions also take the arguments of the case."""

import numpy as np

from course_lib.checks.exercise import same

FINE = 1e-9  # the error that a right answer may have, relative to its size


def near(answer, right, *arguments):
    """Return whether an answer is right within FINE times the largest entry, or 1; an empty one is right."""
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


def same_with_gaps(value, predicted, *arguments, tolerance=1e-6):
    """Return whether two arrays are the same, nan at the same entries included."""
    value, predicted = np.asarray(value, float), np.asarray(predicted, float)
    return value.shape == predicted.shape and np.allclose(
        value, predicted, rtol=tolerance, atol=tolerance, equal_nan=True
    )


def orthogonality_error(R):
    """Return the largest entry of R^T R - I by its size."""
    return np.abs(R.T @ R - np.eye(R.shape[1])).max()
