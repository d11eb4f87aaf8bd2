"""exp and log of SO(3), SE(2) and SE(3) against 50 digits; batches of every function against single
answers."""

from functools import cache

import mpmath
import numpy as np
import pytest
from helpers import close, cross_matrix, twist_matrix
from numpy.testing import assert_allclose
from signatures import BATCHED, FUNCTIONS, Numbers, call_name, expected_type, parts, valid_arguments

from course_lib import rigid, rotations

# Both sides of every place where a formula may change: the ends, small angles, the neighbourhood of
# pi.
ANGLES = [
    1e-300,
    1e-12,
    1e-9,
    1e-8,
    1e-5,
    1e-3,
    0.1,
    0.29,
    0.2999999,
    0.3,
    0.3000001,
    1.0,
    np.pi / 2,
    2.0,
]
ANGLES += [3.0, np.pi - 1e-3, np.pi - 1e-7, np.pi - 1e-12, np.pi]
BATCHES = [(), (0,), (1,), (3, 1, 2)]
SEVERAL = [
    call for call in BATCHED if sum(isinstance(kind, Numbers) for kind in call[1].values()) > 1
]
AXES = np.array(
    [
        [1, 0, 0],
        [0, -1, 0],
        [0, 0, 1],
        [1, 1, 1],
        [0.6, 0, -0.8],
        [-0.3, 0.5, 0.2],
        [-1, 1e-6, 1e-9],
    ]
)
# entries of rotation and of translation, exp, log, and the matrix whose exponential is the element
GROUPS = {
    "SO(3)": (3, 0, rotations.exp_so3, rotations.log_so3, cross_matrix),
    "SE(2)": (1, 2, rigid.exp_se2, rigid.log_se2, twist_matrix),
    "SE(3)": (3, 3, rigid.exp_se3, rigid.log_se3, twist_matrix),
}


def exp_of_fifty_digits(matrices):
    """Return matrix exponentials, summed with 50 digits and rounded once."""
    with mpmath.workdps(50):
        return np.array(
            [mpmath.expm(mpmath.matrix(each.tolist())).tolist() for each in matrices], dtype=float
        )


@cache
def truth(name, angle):
    """Return tangent vectors about axes on all sides by exactly this angle, and the matrices they
    lead to."""
    n, moving, _, _, algebra = GROUPS[name]
    axes = (
        AXES / np.linalg.norm(AXES, axis=-1, keepdims=True) if n == 3 else np.array([[1.0], [-1.0]])
    )
    v = np.random.default_rng(5).uniform(-1, 1, (len(axes), moving))
    tangents = np.concatenate([angle * axes, v], -1)
    return tangents, exp_of_fifty_digits(algebra(tangents))


@pytest.mark.parametrize("name", GROUPS)
@pytest.mark.parametrize("angle", ANGLES)
def test_exp_and_log_against_fifty_digits(name, angle):
    """Entries that are as small as the angle are right to 1e-14 of it."""
    n, moving, exp, log, algebra = GROUPS[name]
    tangents, matrices = truth(name, angle)
    got = exp(tangents)
    close(got, matrices)
    size = matrices.shape[-1] - (moving > 0)
    beside = np.s_[:, ~np.eye(size, dtype=bool)]
    close(got[:, :size, :size][beside], matrices[:, :size, :size][beside], 1e-14 * min(angle, 1))
    for back in (log(matrices), log(got)):
        if (
            angle == np.pi
        ):  # either sign of the axis is right there, and each goes with a translation of its own
            close(np.linalg.norm(back[:, :n], axis=-1), np.pi)
            close(exp_of_fifty_digits(algebra(back)), matrices)
        else:
            close(back[:, :n], tangents[:, :n], 1e-14 * min(angle, 1))
            close(back[:, n:], tangents[:, n:])
        assert (np.linalg.norm(back[:, :n], axis=-1) <= np.pi * (1 + 1e-15)).all()


@pytest.mark.parametrize("name", GROUPS)
def test_the_identity_is_exact(name):
    n, moving, exp, log, _ = GROUPS[name]
    identity = exp(np.zeros(n + moving))
    assert np.array_equal(identity, np.eye(len(identity)))
    assert np.array_equal(log(identity), np.zeros(n + moving))


@pytest.mark.parametrize("batch", BATCHES, ids=str)
@pytest.mark.parametrize("call", BATCHED, ids=call_name)
def test_a_batch_is_the_single_answers_stacked(call, batch):
    name, kinds = call
    rng = np.random.default_rng(8)
    arguments = valid_arguments(kinds, rng, batch)
    arrays = [
        value for argument, value in arguments.items() if isinstance(kinds[argument], Numbers)
    ]
    for array in arrays:
        array.flags.writeable = False  # what the library is given it leaves as it was
    got = parts(FUNCTIONS[name](**arguments))
    assert not any(np.shares_memory(part, array) for part in got.values() for array in arrays)
    for part, one in parts(FUNCTIONS[name](**valid_arguments(kinds, rng))).items():
        assert got[part].shape == batch + one.shape
        assert got[part].dtype == one.dtype == expected_type(name, part)
    for index in np.ndindex(batch):
        item = {a: v[index] if isinstance(kinds[a], Numbers) else v for a, v in arguments.items()}
        for part, one in parts(FUNCTIONS[name](**item)).items():
            close = 1e-13 if name == "damped_path" else 1e-15  # its steps carry the last bits on
            assert_allclose(got[part][index], one, rtol=close, atol=close)


@pytest.mark.parametrize("call", SEVERAL, ids=call_name)
def test_the_batches_of_all_arguments_are_broadcast(call):
    name, kinds = call
    rng, arrays = (
        np.random.default_rng(12),
        [argument for argument, kind in kinds.items() if isinstance(kind, Numbers)],
    )
    batches = dict.fromkeys(arrays, (2,)) | {arrays[0]: (3, 1), arrays[-1]: ()}
    arguments = valid_arguments(kinds, rng)
    arguments |= {
        argument: kinds[argument].sample(rng, batch) for argument, batch in batches.items()
    }
    batch = np.broadcast_shapes(*batches.values())
    whole = {
        a: np.broadcast_to(arguments[a], batch + arguments[a].shape[len(batches[a]) :])
        for a in arrays
    }
    got = parts(FUNCTIONS[name](**arguments))
    for part, expected in parts(FUNCTIONS[name](**(arguments | whole))).items():
        assert got[part].shape == expected.shape
        assert_allclose(got[part], expected, rtol=1e-15, atol=1e-15)


@pytest.mark.parametrize("call", BATCHED, ids=call_name)
def test_a_batch_in_several_pieces(call, monkeypatch):
    """Seven items, laid out three at a time, the last piece one."""
    name, kinds = call
    arguments = valid_arguments(kinds, np.random.default_rng(10), (7,))
    whole = parts(FUNCTIONS[name](**arguments))
    monkeypatch.setattr("course_lib.batching.ITEMS", 3)
    for part, got in parts(FUNCTIONS[name](**arguments)).items():
        assert_allclose(got, whole[part], rtol=1e-15, atol=1e-15)


@pytest.mark.parametrize("call", BATCHED, ids=call_name)
@pytest.mark.parametrize(
    "convert", [np.ndarray.tolist, np.float32, np.longdouble, np.asfortranarray]
)
def test_lists_and_other_floats_are_taken(call, convert):
    name, kinds = call
    arguments = valid_arguments(kinds, np.random.default_rng(9), (4,))
    first = next(argument for argument, kind in kinds.items() if isinstance(kind, Numbers))
    got = parts(FUNCTIONS[name](**{**arguments, first: convert(arguments[first])}))
    for part, expected in parts(FUNCTIONS[name](**arguments)).items():
        assert got[part].dtype == expected_type(name, part)
        assert_allclose(got[part], expected, rtol=0, atol=1e-5 if convert is np.float32 else 1e-15)
