"""Each function of course_lib.rotations against numpy, scipy, 50 digits or a statistical law."""

import numpy as np
import pytest
import scipy.linalg
from helpers import close, cross_matrix, rotation_samples
from hypothesis import assume, given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from scipy.spatial.transform import Rotation

from course_lib import rotations
from course_lib.batching import ITEMS
from course_lib.rotations import (
    exp_so3,
    hat,
    is_quaternion,
    is_so,
    matrix_to_quaternion,
    nearest_quaternion,
    nearest_so,
    quaternion_to_matrix,
    random_quaternions,
    vee,
)

# hat, vee, rotations about one axis, exp
# ----------------------------------------------------------------------------


def test_hat_is_the_cross_product():
    w = np.random.default_rng(0).normal(size=(100, 3))
    assert np.array_equal(hat(w), cross_matrix(w))


@pytest.mark.parametrize("size", [5e-324, 1e-300, 1.0, 1e100])
def test_vee_undoes_hat_exactly(size):
    w = size * np.array([[1.0, 0, -1], [0, -1, 1], [-1, 1, 1]])
    assert np.array_equal(vee(hat(w)), w)


def test_rotations_about_one_axis():
    angle = np.linspace(-7, 7, 29)
    for rot, axis in zip(
        (rotations.rot_x, rotations.rot_y, rotations.rot_z), np.eye(3), strict=True
    ):
        close(rot(angle), exp_so3(angle[:, None] * axis))


def test_exp_rotates_by_any_angle():
    w = np.random.default_rng(1).normal(size=(100, 3)) * np.linspace(0, 10, 100)[:, None]
    close(exp_so3(w), scipy.linalg.expm(cross_matrix(w)), 1e-12)
    for angle in (
        1e2,
        1e8,
        1e16,
        1e100,
    ):  # the sine of any float is exact; the axis is left as it was
        close(exp_so3([0, -angle, 0]), rotations.rot_y(-angle))


# Quaternions
# ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("largest", range(4))
def test_each_branch_of_matrix_to_quaternion(largest):
    """Quaternions whose largest entry is this one: barely, and by far, to where the others
    vanish."""
    rng = np.random.default_rng(largest)
    q = (
        rng.uniform(-1, 1, (200, 4))
        * np.where(np.arange(200) % 2, 10 ** rng.uniform(-20, 0, 200), 1)[:, None]
    )
    q[:, largest] = 1.0
    q /= np.linalg.norm(q, axis=-1, keepdims=True)
    R = Rotation.from_quat(q, scalar_first=True).as_matrix()
    close(quaternion_to_matrix(q), R)
    close(matrix_to_quaternion(R), q * np.where(q[:, :1] < 0, -1, 1))


@pytest.mark.parametrize(
    "axis", [(1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 3, -4), (3, 0, -4), (3, -4, 0)], ids=str
)
@pytest.mark.parametrize("sign", [1, -1])
def test_sign_of_a_quaternion(axis, sign):
    """w >= 0, and at an angle of pi the first entry that is not 0 is positive; 0 is not -0."""
    axis = np.array(axis) / np.linalg.norm(axis)
    q = matrix_to_quaternion(2 * np.outer(sign * axis, sign * axis) - np.eye(3))
    assert q[0] == 0
    assert q[q != 0][0] > 0
    assert not np.signbit(q[q == 0]).any()
    for angle in (0.3, 3.0, np.pi - 1e-12):
        assert matrix_to_quaternion(exp_so3(sign * angle * axis))[0] > 0


@pytest.mark.parametrize("off", [-9e-7, 9e-7])
def test_a_quaternion_slightly_off_gives_a_rotation(off):
    q = random_quaternions(100, np.random.default_rng(3))
    assert is_so(quaternion_to_matrix((1 + off) * q), 2e-15).all()
    close(quaternion_to_matrix((1 + off) * q), quaternion_to_matrix(q))


@pytest.mark.parametrize(
    ("size", "tol", "expected"),
    [
        (1, 0, True),
        (1.0049, 0.005, True),
        (1.0051, 0.005, False),
        (0.9951, 0.005, True),
        (0.9949, 0.005, False),
    ],
)
def test_is_quaternion(size, tol, expected):
    for q in [(0, 0, -size, 0), (size / 2, -size / 2, size / 2, size / 2)]:
        assert is_quaternion(q, tol) == expected
    assert is_quaternion([[1 + 0.9e-6, 0, 0, 0], [1 + 1.1e-6, 0, 0, 0], [0, 0, 0, 0]]).tolist() == [
        True,
        False,
        False,
    ]


@given(hnp.arrays(float, 4, elements=st.floats(-1, 1)), st.sampled_from([1e-300, 3e-9, 7.0, 1e99]))
def test_nearest_quaternion(q, scale):
    assume(np.abs(q).max() > 1e-5)
    nearest = nearest_quaternion(q)
    close(np.linalg.norm(nearest), 1, 1e-15)
    close(nearest * np.linalg.norm(q), q, 1e-15)
    close(nearest_quaternion(scale * q), nearest, 1e-15)


# Rotations and the one nearest
# ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("n", [2, 3])
def test_is_so_is_the_definition_of_the_exercise(n):
    """Every entry of R^T R within tol of I, and det R within tol of 1."""
    rng = np.random.default_rng(12)
    R = rotation_samples(n)(rng, (4000,)) + rng.normal(size=(4000, n, n)) * 10.0 ** rng.uniform(
        -4, 0, (4000, 1, 1)
    )
    R[:3] = (
        np.eye(n),
        -np.eye(n),
        1.0049 * np.eye(n),
    )  # for the last one det R alone is off, for n = 3
    tol = 0.01
    expected = [
        np.abs(M.T @ M - np.eye(n)).max() <= tol and abs(np.linalg.det(M) - 1) <= tol for M in R
    ]
    assert 500 < sum(expected) < 3500
    assert is_so(R, tol).tolist() == expected
    assert is_so(np.eye(n), 0)
    beside = [np.sqrt(1 + off) * np.eye(n) for off in (0.6e-6, 1.1e-6)]
    assert is_so(beside).tolist() == [True, False], "the default tolerance is 1e-6"


@st.composite
def square_matrices(draw):
    """Draw (2, 2) or (3, 3) matrices of every rank, with det of either sign, and equal singular
    values in some."""
    n = draw(st.sampled_from([2, 3]))
    entries = st.one_of(st.sampled_from([-1.0, 0.0, 1.0]), st.floats(-5, 5))
    how = draw(st.sampled_from(["any", "rank", "singular values"]))
    if how == "any":
        return draw(hnp.arrays(float, (n, n), elements=entries))
    if how == "rank":
        rank = draw(st.integers(0, n - 1))
        return draw(hnp.arrays(float, (n, rank), elements=entries)) @ draw(
            hnp.arrays(float, (rank, n), elements=entries)
        )
    U, V = rotation_samples(n)(np.random.default_rng(draw(st.integers(0, 999))), (2,))
    return (
        U
        * draw(
            hnp.arrays(float, n, elements=st.sampled_from([-2.0, -1.0, -1e-9, 0.0, 1e-9, 1.0, 2.0]))
        )
        @ V
    )


@given(square_matrices(), st.sampled_from([1.0, 1e-300, 1e-9, 1e99]))
def test_nearest_so_is_nearest(M, scale):
    n = len(M)
    M = scale * M
    R = nearest_so(M)
    assert is_so(R, 1e-14)
    M /= max(np.abs(M).max(), 5e-324)
    # Of all rotations the one for which R^T M is symmetric, with no two eigenvalues of negative
    # sum, for else a rotation in their plane would bring it nearer.
    S = R.T @ M
    close(S, S.T, 3e-14)
    assert np.linalg.eigvalsh(S)[:2].sum() >= -3e-14
    others = rotation_samples(n)(np.random.default_rng(5), (200,))
    assert np.linalg.norm(M - R) <= np.linalg.norm(M - others, axis=(-2, -1)).min() + 1e-14


# Large batches, which are computed in chunks
# ----------------------------------------------------------------------------


def _large_batch(function):
    """Return ITEMS + 2 arguments of a function, more than one chunk holds."""
    rng = np.random.default_rng(5)
    if function is exp_so3:
        return rng.normal(size=(ITEMS + 2, 3))
    return random_quaternions(ITEMS + 2, rng)


@pytest.mark.parametrize("function", [exp_so3, quaternion_to_matrix])
def test_the_chunks_of_a_large_batch_are_in_their_places(function):
    batch = _large_batch(function)
    at_the_border = slice(ITEMS - 2, ITEMS + 2)
    close(function(batch)[at_the_border], function(batch[at_the_border]), 1e-15)


@pytest.mark.parametrize("function", [exp_so3, quaternion_to_matrix])
def test_a_large_batch_may_lie_in_any_order_in_memory(function):
    batch = _large_batch(function)
    assert np.array_equal(function(np.asfortranarray(batch)), function(batch))
    assert np.array_equal(function(batch[::-1]), function(batch)[::-1])


def test_exp_so3_keeps_digits_where_squares_underflow():
    w = _large_batch(exp_so3)
    w[-1] = [3e-170, -2e-170, 1e-170]
    w[-2] = 0
    R = exp_so3(w)
    close(vee(R[-1] - np.eye(3)) / 1e-170, [3, -2, 1], 1e-14)
    assert np.array_equal(R[-2], np.eye(3))


def test_a_nonunit_quaternion_is_named_in_a_later_chunk():
    q = _large_batch(quaternion_to_matrix)
    q[ITEMS + 1] *= 1 + 2e-6
    with pytest.raises(ValueError, match=rf"q\[{ITEMS + 1}\] is not a unit quaternion"):
        quaternion_to_matrix(q)


@pytest.mark.parametrize("factor", [1 - 0.9e-6, 1 + 0.9e-6])
def test_quaternions_within_the_tolerance_are_accepted(factor):
    q = _large_batch(quaternion_to_matrix)
    close(quaternion_to_matrix(factor * q), quaternion_to_matrix(q), 2e-15)
