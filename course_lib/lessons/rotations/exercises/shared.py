"""What nearest_so and nearest_se share: damaged matrices, and what may be made of them."""

import numpy as np

from course_lib.checks.kinds import whole_numbers
from course_lib.checks.mistake import Question
from course_lib.checks.vocabulary import any_rotation, compared, first_off
from course_lib.rotations import nearest_so, random_rotations

# The block of the 4x4 matrix that the source report corrects: its determinant is negative.
_PUBLISHED = np.array(
    [
        [0.69942428, 0.57542726, 0.83226602],
        [0.51703353, 0.77526382, 0.78676897],
        [0.99073504, 0.09942187, 0.47534292],
    ]
)

# Rank 2, and exactly so in floating point: det M is 0 and says nothing about the sign of det(U
# V^T), which differs between this matrix and its negative. The nearest rotation is unique all the
# same.
SINGULAR = np.array([[1.0, 2.0, 3.0], [2.0, 4.0, 6.0], [1.0, 0.0, 1.0]])


# A determinant between 2^63 and 2^64, which an integer of 64 bits holds with the wrong sign. The
# square of the largest entry fits.
_OVERFLOWING = 1.3e19


def large_whole_numbers(rng, sign):
    """Return a matrix (3, 3) of large whole numbers, whose determinant has this sign and is too
    large for an integer. The numbers are of type int."""
    M = any_rotation(rng) @ np.diag([1.2, 1.0, 0.8 * sign]) @ any_rotation(rng)
    return np.rint(np.cbrt(_OVERFLOWING / abs(np.linalg.det(M))) * M).astype(int)


def damaged_rotations(rng):
    """Return square matrices, each with one nearest rotation: the singular values are well
    apart."""
    R = random_rotations(3, rng)
    return [
        np.array([[0.9, -0.5], [0.5, 0.8]]),
        R[0] + 0.1 * rng.normal(size=(3, 3)),
        np.array([[2.0, 0.0], [0.0, 1.0]]),
        R[1] @ np.diag([2.0, 1.0, 0.5]),
        _PUBLISHED,
        np.array([[1.0, 0.0], [0.0, -0.4]]),
        np.array([[0.3, 0.9], [0.8, 0.1]]),
        # Of angles below -90 degrees, of 90 and of -90 degrees
        np.array([[-0.9, 0.4], [-0.3, -0.7]]),
        np.array([[0.0, -2.0], [1.0, 0.0]]),
        np.array([[0.0, 1.0], [-2.0, 0.0]]),
        R[2] @ np.diag([1.5, 1.0, -0.4]),
        SINGULAR,
        -SINGULAR,
    ]


def coarse(rng):
    """Return a matrix (2, 2) or (3, 3) in whole numbers that is nearer to one rotation than to all
    others."""
    M = whole_numbers(rng, (int(rng.integers(2, 4)),) * 2)
    s = np.linalg.svd(M, compute_uv=False)
    is_certain = s[-2] + np.sign(np.linalg.det(M)) * s[-1] > 0.5
    return M if is_certain else coarse(rng)


# Of the largest entry of a matrix. The tasks name 1e-9 and 1e9.
SCALES = (1.1e-9, 2e-9, 1e-8, 1e-6, 2e-6, 1e-3, 2e-3, 1e3, 1e6, 0.9e9)


def nearly_singular(rng, size):
    """Return a matrix (3, 3) with a small singular value, and a determinant of either sign."""
    return any_rotation(rng) @ np.diag([2.0, 1.0, rng.choice([-1, 1]) * size]) @ any_rotation(rng)


def of_a_scale(rng, scale):
    """Return a matrix (3, 3) whose largest entry is this large, and which may be a mirror."""
    M = any_rotation(rng) @ np.diag([2.0, 1.0, 0.5 * rng.choice([-1, 1])])
    return scale * M / np.abs(M).max()


def nearly_diagonal(rng, size):
    """Return a matrix (3, 3) that is nearly diagonal, and of which no entry is 0."""
    sizes = rng.uniform(0.3, 0.9, (3, 3))
    # The signs on the two sides of the diagonal are opposite, so that the nearest rotation is not
    # the identity.
    return np.diag([1.5, 1.0, 0.7]) + size * (np.triu(sizes) - np.tril(sizes, -1))


def nearly_rotation(rng, gap):
    """Return a rotation (3, 3) but for an error in each entry, which is this large at most."""
    signs = rng.choice([-1, 1], (3, 3))
    return random_rotations(1, rng)[0] + gap * signs * rng.uniform(0.5, 1, (3, 3))


def polar(M, *signs):
    """Return U diag(signs) V^T; without signs U V^T, which is a reflection where det M < 0."""
    U, _, Vt = np.linalg.svd(M)
    return (U * np.array(signs)) @ Vt if signs else U @ Vt


def last_column_negated(M):
    """Return U V^T with its last column negated if its determinant is -1: the published
    correction."""
    return right_handed(polar(M))


def right_handed(Q):
    """Return Q with its last column negated if det Q < 0."""
    return Q @ np.diag([*ones(Q), np.sign(np.linalg.det(Q))])


def ones(M):
    """Return a sign + for each column of M but the last."""
    return [1.0] * (len(M) - 1)


NOT_NEAREST = Question(
    "the answer is a rotation, and another one is nearer",
    "What are U V^T and its determinant here, and does your code compute them for this matrix? If "
    "the determinant is 1, U V^T is nearest. Else one sign changes between U and V^T: where is the "
    "matrix weakest?",
)


def distances(R, M):
    """Return the Finding of the distances of R and of the nearest rotation to M."""
    of_yours, of_nearest = np.linalg.norm(M - R), np.linalg.norm(M - nearest_so(M))
    if of_yours - of_nearest < 1e-6 * of_nearest:  # far from all rotations, the distances agree
        return first_off(R, nearest_so(M))
    return (
        "The distance from M to the nearest rotation, in the Frobenius norm, is "
        + compared(of_nearest, of_yours)
        + "."
    )


CONJUGATE = np.array([1.0, -1.0, -1.0, -1.0])


def hamilton_product(p, q):
    """Return the product of two quaternions (w, x, y, z)."""
    return np.array(
        [p[0] * q[0] - p[1:] @ q[1:], *(p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:]))]
    )
