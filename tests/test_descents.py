"""The measure of notebook 5's methods: the distance of poses, and a descent to many targets."""

import numpy as np

from course_lib import arms, ik, rigid, rotations
from course_lib.lessons.panda_dh_ik import descents
from course_lib.lessons.panda_dh_ik.exercises.shared import READY

PANDA = arms.panda()
TARGETS = PANDA.fk(READY + 0.3 * np.random.default_rng(2).uniform(-1, 1, (20, 7)))


def damped(J, e, distance):
    x = np.linalg.solve(J @ J.mT + 0.01 * np.eye(6), e[..., None])
    return (J.mT @ x)[..., 0]


def as_it_is(q):
    return q


def test_the_distance_is_that_of_seven_numbers():
    random = np.random.default_rng(0)
    A, B = (
        rigid.transform(rotations.random_rotations(200, random), random.normal(size=(200, 3)))
        for _ in range(2)
    )
    a, b = (rotations.matrix_to_quaternion(T[:, :3, :3]) for T in (A, B))
    p = np.linalg.norm(A[:, :3, 3] - B[:, :3, 3], axis=1)
    nearer = np.minimum(np.linalg.norm(a - b, axis=1), np.linalg.norm(a + b, axis=1))
    np.testing.assert_allclose(descents.pose_distance(A, B), np.hypot(p, nearer), atol=1e-12)


def test_a_descent_stops_at_the_first_step_within_the_distance():
    """It counts the steps up to there."""
    reached, taken = descents.descend(
        PANDA, TARGETS, READY, (ik.pose_error, damped, as_it_is), 50, 0.02
    )
    assert reached.all()
    for target, steps in zip(TARGETS[:5], taken, strict=False):
        q, distances = READY[None], []
        for _step in range(steps + 1):
            T = PANDA.fk(q)
            distances.append(descents.pose_distance(T, target)[0])
            q = q + damped(PANDA.geometric_jacobian(q), ik.pose_error(T, target[None]), None)
        assert distances[-1] <= 0.02 < min(distances[:-1])


def test_a_target_that_is_not_reached_counts_one_step_more():
    far = np.concatenate([PANDA.fk(READY)[None], rigid.transform(np.eye(3), [[9.0, 0, 0]])])
    reached, taken = descents.descend(PANDA, far, READY, (ik.pose_error, damped, as_it_is), 7, 0.02)
    assert reached.tolist() == [True, False]
    assert taken.tolist() == [0, 8]


def test_the_rule_for_the_limits_is_applied_after_each_step():
    seen = []

    def inside(q):
        seen.append(q)
        return np.clip(q, *PANDA.limits.T)

    descents.descend(
        PANDA,
        TARGETS[:1],
        READY,
        (ik.pose_error, lambda J, e, far: 0 * J[:, 0] + 9, inside),
        3,
        0.02,
    )
    assert np.array_equal(seen[1], np.clip(seen[0], *PANDA.limits.T) + 9)


def test_each_target_may_have_a_start_of_its_own():
    rules = ik.pose_error, damped, as_it_is
    starts = np.array([READY, READY + 0.1])
    together = descents.descend(PANDA, TARGETS[:2], starts, rules, 20, 1e-3)[1]
    alone = [
        descents.descend(PANDA, TARGETS[[k]], starts[k], rules, 20, 1e-3)[1][0] for k in range(2)
    ]
    assert together.tolist() == alone
