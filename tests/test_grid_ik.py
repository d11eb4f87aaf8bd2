"""GridIK beside the closed form: how exact, complete and large, and what is refused."""

import pickle
import tracemalloc
from functools import partial

import numpy as np
import pytest
from sklearn.utils.estimator_checks import check_estimator

from course_lib.arms import planar_arm
from course_lib.lessons.decomposition_ik import check
from course_lib.lessons.decomposition_ik.grid_ik import GridIK, planar_forward

LOW, HIGH = np.deg2rad([0, -90]), np.deg2rad([170, 90])


def places(theta):
    """Return where the arm's end is, (..., 2), for joint angles (..., 2)."""
    first, both = theta[..., 0], theta.sum(-1)
    return np.stack([np.cos(first) + np.cos(both), np.sin(first) + np.sin(both)], -1)


def samples(n, seed):
    """Return n places, and the joint angles they belong to, which are uniform in the joints'
    ranges."""
    theta = np.random.default_rng(seed).uniform(LOW, HIGH, (n, 2))
    return places(theta), theta


def area_queries(n, seed):
    """Return n places uniform in the area that the arm reaches within its ranges."""
    xy = np.random.default_rng(seed).uniform([-2, -1], [2, 2], (6 * n, 2))
    return xy[~np.isnan(in_range(check.ik_2r.library(xy))).all((1, 2))][:n]


def in_range(theta, low=LOW, high=HIGH):
    """Return the solutions with theta1 in the revolution from just below `low`, and NaN for those
    outside."""
    theta = theta.copy()
    theta[..., 0] -= 2 * np.pi * np.floor((theta[..., 0] - low[0] + 1e-9) / (2 * np.pi))
    theta[~((theta >= low) & (theta <= high)).all(-1)] = np.nan
    return theta


SAMPLES = samples(50_000, 0)
QUERIES = {
    "of uniform angles": samples(20_000, 1)[0],
    "of the reachable area": area_queries(20_000, 2),
}
EVERY_QUERY = pytest.mark.parametrize("xy", QUERIES.values(), ids=QUERIES)
FORWARDS = pytest.mark.parametrize(
    "forward", [planar_forward, None], ids=["forward", "models alone"]
)


def fitted(forward=planar_forward, **parameters):
    return GridIK(forward=forward, **parameters).fit(*SAMPLES)


def misses(theta, xy):
    """Return how far the answers lead from their queries, one number for each answer of either
    branch."""
    off = np.linalg.norm(places(theta) - xy[:, None], axis=-1)
    return off[~np.isnan(off)]


@EVERY_QUERY
@pytest.mark.parametrize(
    ("forward", "share", "off"), [(planar_forward, 0.999, 1e-4), (None, 0.985, 1e-2)]
)
def test_nearly_every_solution_is_found_and_no_other(forward, share, off, xy):
    got, true = fitted(forward).predict(xy), in_range(check.ik_2r.library(xy))
    assert misses(got, xy).max() <= (1.5e-9 if forward else 1e-2)
    found, exists = ~np.isnan(got[..., 0]), ~np.isnan(true[..., 0])
    assert (found & exists).sum() >= share * exists.sum()
    assert 0.3 < exists.mean() < 0.95  # there are queries where one branch has nothing
    assert (found & ~exists).sum() <= (0 if forward else 1e-4 * found.sum())
    np.testing.assert_allclose(got[found & exists], true[found & exists], rtol=0, atol=off)
    assert np.array_equal(np.isnan(got[..., 0]), np.isnan(got[..., 1]))
    assert (got[:, 0, 1][found[:, 0]] >= 0).all()
    assert (got[:, 1, 1][found[:, 1]] <= 0).all()


def test_any_point_in_a_wide_square_gets_a_right_answer_or_none():
    xy = np.random.default_rng(3).uniform(-3, 3, (100_000, 2))
    got, true = fitted().predict(xy), in_range(check.ik_2r.library(xy))
    assert not (np.isnan(true) & ~np.isnan(got)).any()
    assert misses(got, xy).max() <= 1.5e-9


def test_beside_the_edge_where_the_branches_meet():
    edge = np.stack([np.cos(angle := np.linspace(0.1, 2.9, 500)), np.sin(angle)], -1)
    exact, models = fitted(), fitted(None)
    for gap in [1e-2, 1e-4, 1e-6, 1e-8, 1e-10]:
        xy = (2 - gap) * edge
        got = exact.predict(xy)
        answered = ~np.isnan(got).any(
            (1, 2)
        )  # not where the chord of the box or a cell without samples is in the way
        assert answered.mean() > 0.97
        np.testing.assert_allclose(
            places(got[answered]), np.stack([xy[answered]] * 2, 1), rtol=0, atol=1e-9
        )
        assert np.isnan(exact.predict((2 + 1e-8 + gap) * edge)).all()
    assert np.isnan(models.predict(2.01 * edge)).all()
    assert misses(models.predict(1.9999 * edge), 1.9999 * edge).max() < 1e-3


@FORWARDS
@pytest.mark.parametrize("gone", [(0,), (1,), (0, 1)])
def test_a_branch_has_no_answer_in_cells_without_its_samples(forward, gone):
    xy, theta = SAMPLES
    hole, inner = (np.linalg.norm(xy - [0.3, 1.6], axis=-1) < radius for radius in (0.25, 0.1))
    keep = ~(hole & np.isin(theta[:, 1] < 0, gone))
    whole, holed = (
        fitted(forward).predict(xy[inner]),
        GridIK(forward=forward).fit(xy[keep], theta[keep]),
    )
    assert len(whole) > 100
    assert not np.isnan(whole).any()
    for branch in (0, 1):
        got = holed.predict(xy[inner])[:, branch]
        assert np.isnan(got).all() if branch in gone else np.array_equal(got, whole[:, branch])


def test_more_steps_and_a_finer_tolerance():
    xy = QUERIES["of uniform angles"]
    one, three = (misses(fitted(steps=steps).predict(xy), xy) for steps in (1, 3))
    assert len(one) < 0.999 * len(three)
    assert misses(fitted(tol=1e-14, steps=5).predict(xy), xy).max() <= 2e-14


def test_many_queries_take_little_memory():
    model, (xy, _) = fitted(), samples(400_000, 4)
    tracemalloc.start()
    answer = model.predict(xy)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak <= answer.nbytes + xy.nbytes + 8e6


@FORWARDS
def test_a_cell_takes_thirty_to_forty_bytes(forward):
    model = fitted(forward)
    arrays = [value for value in vars(model).values() if isinstance(value, np.ndarray)]
    assert model.nbytes == sum(array.nbytes for array in arrays)
    assert 30 * 50**2 < model.nbytes < 40 * 50**2


@FORWARDS
def test_the_same_answers_again_in_any_order_and_one_by_one(forward):
    xy, (places_, theta) = QUERIES["of uniform angles"][:300], SAMPLES
    model = fitted(forward)
    got = model.predict(xy)
    assert np.array_equal(got, fitted(forward).predict(xy), equal_nan=True)
    assert np.array_equal(got, model.fit(places_, theta).predict(xy), equal_nan=True)
    assert np.array_equal(got, pickle.loads(pickle.dumps(model)).predict(xy), equal_nan=True)
    singly = np.concatenate([model.predict(xy[i : i + 1]) for i in range(len(xy))])
    np.testing.assert_allclose(singly, got, rtol=0, atol=1e-7)
    order = np.random.default_rng(6).permutation(len(theta))
    shuffled = GridIK(forward=forward).fit(places_[order], theta[order]).predict(xy)
    np.testing.assert_allclose(
        places(shuffled), places(got), rtol=0, atol=1e-4 if forward is None else 3e-9
    )
    assert model.predict(np.empty((0, 2))).shape == (0, 2, 2)


@pytest.mark.parametrize("lengths", [(1.0, 0.6), (0.3, 1.0), (400.0, 300.0)])
def test_other_arms(lengths):
    theta = np.random.default_rng(7).uniform(LOW, HIGH, (50_000, 2))
    forward = partial(planar_forward, lengths=lengths)
    xy, _ = forward(theta)
    got = GridIK((60, 40), forward).fit(xy[:40_000], theta[:40_000]).predict(xy[40_000:])
    own = got[np.arange(10_000), (theta[40_000:, 1] < 0).astype(int)]
    there = ~np.isnan(own[:, 0])
    assert there.mean() > 0.998
    np.testing.assert_allclose(own[there], theta[40_000:][there], rtol=0, atol=1e-4)


def test_a_serial_arm_as_forward_and_samples_of_one_branch():
    arm = planar_arm([1, 1])

    def forward(theta):
        return arm.fk(theta)[:, :2, 3], arm.position_jacobian(theta)[:, :2]

    theta = SAMPLES[1][:500]
    for got, expected in zip(planar_forward(theta), forward(theta), strict=True):
        np.testing.assert_allclose(got, expected, rtol=0, atol=1e-14)
    xy, theta = (array[SAMPLES[1][:, 1] < 0][:5000] for array in SAMPLES)
    got, same = (
        GridIK((20, 20), f).fit(xy, theta).predict(xy[:500]) for f in (forward, planar_forward)
    )
    np.testing.assert_allclose(got, same, rtol=0, atol=1e-7)
    assert np.isnan(got[:, 0]).all()
    assert not np.isnan(got[:, 1]).any()


def test_what_scikit_learn_asks_of_every_estimator():
    """The other checks fit three and more columns, or a target of one; what they look at is tested
    above."""
    results = check_estimator(GridIK(), on_skip=None, on_fail=None)
    passed = {result["check_name"] for result in results if result["status"] == "passed"}
    assert {
        "check_estimator_cloneable",
        "check_get_params_invariance",
        "check_set_params",
    } <= passed
    assert len(passed) >= 12
    model = fitted(cells=(30, 40), steps=2)
    assert model.n_features_in_ == 2
    assert model.fit(*SAMPLES) is model
