"""Axioms stated once and run on every group; exp and log against 50 digits; batches against single answers."""

import numpy as np
import pytest
from helpers import ANGLES, BATCHES, GROUPS, same_sign, true_exp
from numpy.testing import assert_allclose
from signatures import ARGUMENTS, BATCHED, FUNCTIONS, Numbers, call_name, expected_type, parts, valid_arguments

EVERY_GROUP = pytest.mark.parametrize("group", GROUPS, ids=str)


def assert_same(group, got, expected, atol=1e-14):
    got = same_sign(got, expected) if group.name == "quaternions" else got
    assert_allclose(got, expected, rtol=0, atol=atol)


def assert_tangent(group, got, expected, angle):
    """Compare tangent vectors to 1e-14 of the angle in their turn, where it is small, and to 1e-14 elsewhere."""
    turn = group.turning
    assert_allclose(got[..., :turn], expected[..., :turn], rtol=0, atol=1e-14 * min(angle, 1))
    assert_allclose(got[..., turn:], expected[..., turn:], rtol=0, atol=1e-14)


@pytest.fixture(scope="module")
def truth():
    """Return a function of (group, angle) that gives tangent vectors and the matrices they lead to; each made once."""
    known = {}

    def of(group, angle):
        key = group.algebra, group.turning, group.moving, angle
        if key not in known:
            tangents = group.at_angle(angle)
            known[key] = tangents, np.array([true_exp(matrix) for matrix in group.algebra(tangents)])
        return known[key]

    return of


@EVERY_GROUP
@pytest.mark.parametrize("angle", ANGLES)
class TestAgainstFiftyDigits:
    def test_exp(self, group, angle, truth):
        tangents, expected = truth(group, angle)
        got = group.matrix(group.exp(tangents))
        assert_allclose(got, expected, rtol=0, atol=1e-14)
        n = expected.shape[-1] - (group.moving > 0)
        off_diagonal = np.s_[:, ~np.eye(n, dtype=bool)]
        turn, expected_turn = got[:, :n, :n], expected[:, :n, :n]
        assert_allclose(turn[off_diagonal], expected_turn[off_diagonal], rtol=0, atol=1e-14 * min(angle, 1))

    def test_log(self, group, angle, truth):
        tangents, matrices = truth(group, angle)
        elements = matrices if group.name != "quaternions" else group.exp(tangents)
        got = group.log(elements)
        assert (np.linalg.norm(got[:, : group.turning], axis=-1) <= np.pi * (1 + 1e-15)).all()
        if angle == np.pi:  # either sign of the axis is right there, and each goes with a translation of its own
            assert_allclose(np.linalg.norm(got[:, : group.turning], axis=-1), np.pi, rtol=0, atol=1e-14)
            back = np.array([true_exp(matrix) for matrix in group.algebra(got)])
            assert_allclose(back, matrices, rtol=0, atol=1e-14)
        else:
            assert_tangent(group, got, tangents, angle)

    def test_log_undoes_exp(self, group, angle):
        tangents = group.at_angle(angle)
        got = group.log(group.exp(tangents))
        if angle == np.pi:
            assert_same(group, group.exp(got), group.exp(tangents))
        else:
            assert_tangent(group, got, tangents, angle)


@EVERY_GROUP
class TestAxioms:
    @pytest.fixture
    def elements(self, group):
        """Return three times 300 elements, a third of them near the identity in each."""
        rng = np.random.default_rng(17)
        return [rng.permutation(group.exp(group.tangents(300, rng))) for _ in range(3)]

    def test_closed(self, group, elements):
        a, b, _ = elements
        assert group.contains(group.product(a, b), 1e-14).all()

    def test_identity(self, group, elements):
        a, _, _ = elements
        zero = np.zeros(group.turning + group.moving)
        identity = group.exp(zero)
        assert np.array_equal(group.matrix(identity), np.eye(len(group.matrix(identity))))
        assert np.array_equal(group.log(identity), zero)
        assert_same(group, group.product(a, identity), a, atol=0)
        assert_same(group, group.product(identity, a), a, atol=0)

    def test_inverse(self, group, elements):
        a, _, _ = elements
        identity = np.broadcast_to(group.exp(np.zeros(group.turning + group.moving)), a.shape)
        assert_same(group, group.product(a, group.inverse(a)), identity)
        assert_same(group, group.product(group.inverse(a), a), identity)
        assert_same(group, group.exp(-group.log(a)), group.inverse(a))

    def test_associative(self, group, elements):
        a, b, c = elements
        assert_same(group, group.product(group.product(a, b), c), group.product(a, group.product(b, c)))

    def test_product_of_matrices(self, group, elements):
        a, b, _ = elements
        assert_allclose(group.matrix(group.product(a, b)), group.matrix(a) @ group.matrix(b), rtol=0, atol=1e-14)

    def test_exp_undoes_log(self, group, elements):
        a, _, _ = elements
        assert_same(group, group.exp(group.log(a)), a)

    def test_one_axis_adds(self, group):
        t = group.tangents(300, np.random.default_rng(3))
        assert_same(group, group.product(group.exp(0.3 * t), group.exp(0.7 * t)), group.exp(t))

    def test_adjoint_moves_the_tangent(self, group, elements):
        a, _, _ = elements
        t = group.tangents(300, np.random.default_rng(4))
        moved = (group.adjoint(a) @ t[..., None])[..., 0]
        conjugate = group.product(group.product(a, group.exp(t)), group.inverse(a))
        assert_same(group, group.exp(moved), conjugate, atol=3e-14)

    def test_adjoint_of_a_product(self, group, elements):
        a, b, _ = elements
        expected = group.adjoint(a) @ group.adjoint(b)
        assert_allclose(group.adjoint(group.product(a, b)), expected, rtol=0, atol=3e-14)


@pytest.mark.parametrize("batch", BATCHES, ids=str)
@pytest.mark.parametrize("call", BATCHED, ids=call_name)
def test_a_batch_is_the_single_answers_stacked(call, batch):
    name, kinds = call
    rng = np.random.default_rng(8)
    arguments = valid_arguments(kinds, rng, batch)
    for argument, value in arguments.items():
        if isinstance(kinds[argument], Numbers):
            value.flags.writeable = False  # what the library is given it leaves as it was
    got = parts(FUNCTIONS[name](**arguments))
    for part, one in parts(FUNCTIONS[name](**valid_arguments(kinds, rng))).items():
        assert got[part].shape == batch + one.shape
        assert got[part].dtype == one.dtype == expected_type(name, part)
    for index in np.ndindex(batch):
        item = {a: v[index] if isinstance(kinds[a], Numbers) else v for a, v in arguments.items()}
        for part, one in parts(FUNCTIONS[name](**item)).items():
            close = 1e-13 if name == "damped_path" else 1e-15  # its steps carry the last bits on
            assert_allclose(got[part][index], one, rtol=close, atol=close)


@pytest.mark.parametrize("call", BATCHED, ids=call_name)
def test_a_batch_in_several_pieces(call, monkeypatch):
    """Seven items, laid out three at a time, the last piece one."""
    name, kinds = call
    arguments = valid_arguments(kinds, np.random.default_rng(10), (7,))
    whole = parts(FUNCTIONS[name](**arguments))
    monkeypatch.setattr("course_lib.batching.ITEMS", 3)
    for part, got in parts(FUNCTIONS[name](**arguments)).items():
        assert_allclose(got, whole[part], rtol=1e-15, atol=1e-15)


@pytest.mark.parametrize("batch", [(), (2,)], ids=str)
@pytest.mark.parametrize("call", BATCHED, ids=call_name)
def test_an_answer_is_no_view_of_what_was_given(call, batch):
    name, kinds = call
    arguments = valid_arguments(kinds, np.random.default_rng(11), batch)
    given = [value for argument, value in arguments.items() if isinstance(kinds[argument], Numbers)]
    for got in parts(FUNCTIONS[name](**arguments)).values():
        assert not any(np.shares_memory(got, value) for value in given)


@pytest.mark.parametrize("call", BATCHED, ids=call_name)
@pytest.mark.parametrize("convert", [np.ndarray.tolist, np.float32, np.longdouble, np.asfortranarray])
def test_lists_and_other_floats_are_taken(call, convert):
    name, kinds = call
    arguments = valid_arguments(kinds, np.random.default_rng(9), (4,))
    first = next(argument for argument, kind in kinds.items() if isinstance(kind, Numbers))
    got = parts(FUNCTIONS[name](**{**arguments, first: convert(arguments[first])}))
    for part, expected in parts(FUNCTIONS[name](**arguments)).items():
        assert got[part].dtype == expected_type(name, part)
        assert_allclose(got[part], expected, rtol=0, atol=1e-5 if convert is np.float32 else 1e-15)


@pytest.mark.parametrize("n", [0, 1, 2, 17])
@pytest.mark.parametrize("name", [name for name, sets in ARGUMENTS.items() if "rng" in sets[0]])
def test_random_draws_come_in_the_number_asked_for(name, n):
    got = FUNCTIONS[name](n, np.random.default_rng(1))
    assert got.shape == (n, *{"random_rotations": (3, 3), "random_quaternions": (4,)}[name])
    assert got.dtype == float
