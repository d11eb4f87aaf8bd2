"""find_signs: which joints of a standard table have the opposite sign, by a search over all
patterns of signs."""

import itertools

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.lessons.panda_dh_ik.exercises.shared import modified, standard
from course_lib.rotations import exp_so3


def _patterns(table):
    return np.array(list(itertools.product([1, -1], repeat=len(table))))


def _ends(table, q, patterns, convention=standard):
    """Return the poses of all configurations with each pattern of signs, (patterns, m, 4, 4)."""
    T = np.eye(4)
    for row, angles, signs in zip(table, np.transpose(q), np.transpose(patterns), strict=True):
        steps = {sign: [convention(*row, sign * angle) for angle in angles] for sign in (1, -1)}
        T = T @ np.array([steps[sign] for sign in signs])
    return T


def _gaps(table, q, poses, convention=standard):
    """Return the largest difference of each pattern and configuration in position and orientation,
    (2^n, m, 2)."""
    gap = np.abs(_ends(table, q, _patterns(table), convention) - poses)
    return np.stack([gap[..., :3, 3].max(-1), gap[..., :3, :3].max((-1, -2))], -1)


def _best(table, costs):
    """Return the pattern of the least cost, (2^n,); the first of those that are alike."""
    return _patterns(table)[np.argmin(np.round(costs, 9))]


def right(table, q, poses):
    """Return the pattern whose worst configuration is best."""
    return _best(table, _gaps(table, q, poses).max((1, 2)))


def _case(rng, n, zero=None, noise=0.0, deceives=()):
    """Return a table, configurations, and the poses that they have if some joints have the opposite
    sign.

    The last row has a = 0, so that no position shows the sign of the last joint. deceives: wrong
    answers to the case.
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
        poses = _ends(table, q, [signs])[0]
        if noise:
            poses[:, :3, :3] = poses[:, :3, :3] @ exp_so3(noise * rng.normal(size=(3, 3)))
        clear = (signs > 0).any() and np.sort(_gaps(table, q, poses).max((1, 2)))[1] > 0.2
        if clear and not any(np.array_equal(answer(table, q, poses), signs) for answer in deceives):
            return table, q, poses


def _cases(rng):
    table, q = np.array([[0.5, np.pi / 2, 0.3], [0.4, 0, 0]]), np.array([[0.3, 0.2], [-0.25, 0.3]])
    simple = table, q, _ends(table, q, [[1, -1]])[0]
    drawn = [_case(rng, 3, zero=zero, deceives=[other_convention]) for zero in (None, 0, -1)]
    return [simple, *drawn, _case(rng, 4, noise=1e-4, deceives=[one_joint_at_a_time])]


def _off(answer, table, q, poses):
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
            mistake=Mistake(
                "something other than signs is returned", "Return the best pattern itself."
            ),
        ),
        Property(
            "with the signs applied to its angles, the table gives the poses that were measured",
            lambda answer, *case: np.array_equal(answer, right(*case)),
            says=_off,
            mistake=Mistake(
                "another pattern fits better",
                "Is each of the 2^n patterns tried as a whole, by dh_standard, in all "
                "configurations, by whole poses?",
            ),
        ),
    ),
    hints=(
        "itertools.product([1, -1], repeat=n) runs through all patterns. For each one, compute the "
        "pose of every "
        "configuration and compare it with the one measured.",
        "A pattern is as good as its worst configuration. Keep the pattern whose worst difference "
        "is the least.",
        "The pose of one configuration: T = np.eye(4), then T = T @ dh_standard(a, alpha, d, "
        "theta) for each row, with "
        "theta the sign times the angle.",
    ),
    library=right,
    tries_arguments=False,
)


@EXERCISE.mistake
def positions_only(table, q, poses):
    """only positions are compared. Which joint may rotate the end-effector without moving it?"""
    return _best(table, _gaps(table, q, poses)[..., 0].max(1))


@EXERCISE.mistake(k=(0, -1))
def one_configuration(table, q, poses, k):
    """only one configuration is compared. May a wrong pattern fit one configuration by chance?"""
    return _best(table, _gaps(table, q, poses)[:, k].max(1))


@EXERCISE.mistake
def one_joint_at_a_time(table, q, poses):
    """one joint is decided after the other.

    Does the best sign of one joint depend on those of the others?
    """
    worst = dict(zip(map(tuple, _patterns(table)), _gaps(table, q, poses).max((1, 2)), strict=True))
    signs = [1] * len(table)
    for i in range(len(table)):
        signs[i] = min(
            (1, -1), key=lambda sign, i=i: round(worst[(*signs[:i], sign, *signs[i + 1 :])], 9)
        )
    return np.array(signs)


@EXERCISE.mistake
def other_convention(table, q, poses):
    """the table is read in the modified convention. Which convention does the task name?"""
    return _best(table, _gaps(table, q, poses, modified).max((1, 2)))
