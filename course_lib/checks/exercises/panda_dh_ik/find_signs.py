"""find_signs: which joints of a standard table have the opposite sign, by a search over all patterns of signs."""

import itertools

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.panda_dh_ik.shared import standard
from course_lib.checks.vocabulary import negated
from course_lib.rotations import exp_so3

_WHOLE_POSE = "The last joint may rotate the end-effector without moving it: compare whole poses."
_EVERY = "A pattern may fit one configuration by chance: it has to fit all of them."


def _end(table, q):
    T = np.eye(4)
    for row, theta in zip(table, q, strict=True):
        T = T @ standard(*row, theta)
    return T


def _patterns(table):
    return np.array(list(itertools.product([1, -1], repeat=len(table))))


def _gaps(table, q, poses):
    """Return the largest difference of each pattern and configuration in position and orientation, (2^n, m, 2)."""
    gap = np.array([[_end(table, signs * angles) for angles in q] for signs in _patterns(table)]) - poses
    return np.stack([np.abs(gap[..., :3, 3]).max(-1), np.abs(gap[..., :3, :3]).max((-1, -2))], -1)


def _chosen(by):
    """Return an answer: the pattern that by(gaps) (2^n,) makes least; the first of those that are alike."""
    return lambda table, q, poses: _patterns(table)[np.argmin(np.round(by(_gaps(table, q, poses)), 9))]


right = _chosen(lambda gaps: gaps.max((1, 2)))


def _one_at_a_time(table, q, poses):
    """Return the signs of somebody who decides joint after joint and never comes back to one."""
    worst = dict(zip(map(tuple, _patterns(table)), _gaps(table, q, poses).max((1, 2)), strict=True))
    signs = [1] * len(table)
    for i in range(len(table)):
        signs[i] = min((1, -1), key=lambda sign, i=i: round(worst[(*signs[:i], sign, *signs[i + 1 :])], 9))
    return np.array(signs)


def _case(rng, n, zero=None, noise=0.0, misleading=False):
    """Return a table, configurations, and the poses that they have if some joints have the opposite sign.

    The last row has a = 0, so that no position shows the sign of the last joint.
    """
    while True:
        table = np.round(rng.uniform(0.2, 0.8, (n, 3)), 2)
        table[:, 1] = rng.choice([-1, 1], n) * np.round(rng.uniform(0.6, 1.5, n), 2)
        table[-1, :2] = 0
        signs = rng.choice([-1, 1], n)
        signs[-1] = -1
        q = np.round(rng.uniform(0.4, 1.4, (3, n)) * rng.choice([-1, 1], (3, n)), 2)
        if zero is not None:
            q[zero] = 0  # which fits any pattern
        poses = np.array([_end(table, signs * angles) for angles in q])
        if noise:
            poses[:, :3, :3] = poses[:, :3, :3] @ exp_so3(noise * rng.normal(size=(3, 3)))
        worst = np.sort(_gaps(table, q, poses).max((1, 2)))
        clear = (signs > 0).any() and worst[1] > 0.2
        if clear and (not misleading or not np.array_equal(_one_at_a_time(table, q, poses), signs)):
            return table, q, poses


def _cases(rng):
    quarter = np.pi / 2
    table, q = np.array([[0.5, quarter, 0.3], [0.4, 0, 0]]), np.array([[0.3, 0.2], [-0.25, 0.3]])
    simple = table, q, np.array([_end(table, [1, -1] * angles) for angles in q])
    return [
        simple,
        _case(rng, 3),
        _case(rng, 3, zero=0),
        _case(rng, 3, zero=-1),
        _case(rng, 4, noise=1e-4, misleading=True),
    ]


def _seen(answer, table, q, poses):
    k = int((_patterns(table) == answer).all(1).argmax())
    return f"With yours the poses differ by up to {_gaps(table, q, poses)[k].max():.2g}."


EXERCISE = Exercise(
    name="find_signs",
    points=2,
    arguments=("table", "q", "poses"),
    cases=_cases,
    returns=numbers(lambda table, q, poses: (len(table),)),
    properties=(
        Property(
            "the answer holds 1 and -1 only",
            lambda answer, *case: np.isin(answer, [1, -1]).all(),
            mistake=Mistake("something other than signs is returned", "Return the best pattern itself."),
        ),
        Property(
            "with the signs applied to its angles, the table gives the poses that were measured",
            lambda answer, *case: np.array_equal(answer, right(*case)),
            says=_seen,
        ),
    ),
    mistakes=(
        Mistake(
            "the worst pattern is chosen", "The smallest difference wins.", _chosen(lambda gaps: -gaps.max((1, 2)))
        ),
        Mistake("only positions are compared", _WHOLE_POSE, _chosen(lambda gaps: gaps[..., 0].max(1))),
        Mistake("only the last configuration is compared", _EVERY, _chosen(lambda gaps: gaps[:, -1].max(1))),
        Mistake("only the first configuration is compared", _EVERY, _chosen(lambda gaps: gaps[:, 0].max(1))),
        negated(right, "all signs are opposite", "1 means: as the table says."),
        Mistake("no joint has the sign -1", "Try all patterns.", lambda table, *rest: np.ones(len(table))),
        Mistake("all joints have the sign -1", "Try all patterns.", lambda table, *rest: -np.ones(len(table))),
        Mistake(
            "one joint is decided after the other",
            "The best sign of one joint depends on those of the others: try all patterns.",
            _one_at_a_time,
        ),
        Mistake(
            "the signs are in the reverse order",
            "The first sign belongs to the first row.",
            lambda *case: right(*case)[::-1],
        ),
    ),
    hints=(
        "itertools.product([1, -1], repeat=n) runs through all patterns. For each one, compute the pose of every "
        "configuration and compare it with the one measured.",
        "A pattern is as good as its worst configuration. Keep the pattern whose worst difference is the least.",
        "The pose of one configuration: T = np.eye(4), then T = T @ dh_standard(a, alpha, d, theta) for each row, with "
        "theta the sign times the angle.",
    ),
    library=right,
)
