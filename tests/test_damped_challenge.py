"""The challenge of notebook 3: what counts as a step, and what a rule may return."""

import numpy as np
import pytest

from course_lib.arms import planar_arm
from course_lib.lessons.subproblems_damped_ik.exercises.challenge import mean_steps

ARM = planar_arm([1, 1, 1, 1])


def damped_step(q, target, alpha, eps):
    J, e = ARM.position_jacobian(q)[:2], ARM.fk(q)[:2, 3] - target
    return q - alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ e)


def test_an_adaptive_rule_needs_far_fewer_than_124_steps():
    def adapting(k, before, after, alpha, eps):
        return 1.0, max(eps / 3, 1e-3) if after < before else 4 * eps

    assert mean_steps(lambda *tried: (0.2, 2.0), damped_step) == pytest.approx(124.3, abs=0.05)
    assert mean_steps(adapting, damped_step) < 10


def test_an_adaptive_rule_can_do_better_than_the_constants_that_the_notebook_names():
    def adapting(k, before, after, alpha, eps):
        if k == 0:
            return 1.0, 0.6
        return 1.0, eps / 20 if after < before else 4 * eps

    scores = [mean_steps(lambda *tried, eps=eps: (1.0, eps), damped_step) for eps in (0.1, 0.003)]
    assert [f"{score:.1f}" for score in scores] == ["7.0", "6.0"]
    assert f"{mean_steps(adapting, damped_step):.1f}" == "5.7"


def test_a_rule_hears_of_each_step():
    heard = []

    def listening(k, before, after, alpha, eps):
        heard.append((k, before, after, alpha, eps))
        return 1.0 + k, 3.0

    mean_steps(listening, lambda q, target, alpha, eps: q + 0.1)
    assert [row[0] for row in heard[:3]] == [0, 1, 2]
    assert [row[3:] for row in heard[:3]] == [(0.2, 2.0), (1.0, 3.0), (2.0, 3.0)]
    assert heard[0][2] == heard[1][1]


@pytest.mark.parametrize(
    "answer", [None, 0.2, (0.2,), (np.nan, 2.0), (0.2, np.inf), (1.0, 0.0), ("a", "b")]
)
def test_the_error_of_a_rule_says_what_it_should_return(answer):
    with pytest.raises(
        ValueError,
        match="rule must return two finite numbers, alpha and a positive eps; it returned",
    ):
        mean_steps(lambda *tried: answer, damped_step)
