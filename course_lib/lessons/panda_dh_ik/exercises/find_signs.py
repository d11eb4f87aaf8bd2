"""find_signs: which joints of a standard table have the opposite sign, by a search over all
patterns of signs."""

import functools
import itertools

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.exercise import Property
from course_lib.checks.kinds import OWN_CASES
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import BESIDE, Sweep
from course_lib.checks.vocabulary import remembered
from course_lib.lessons.panda_dh_ik.exercises.shared import T_W0, modified, standard
from course_lib.rigid import inverse

_VISIBLE = tuple(size for size in BESIDE if size > 1e-7)


def _patterns(table):
    return np.array(list(itertools.product([1, -1], repeat=len(table))))


@functools.lru_cache(maxsize=1000)
def _step(convention, *row):
    """Return the pose of one row, which the poses of all patterns need."""
    return convention(*row)


def _ends(table, q, patterns, convention=standard):
    """Return the poses of all configurations with each pattern of signs, (patterns, m, 4, 4)."""
    T = np.eye(4)
    for row, angles, signs in zip(table, np.transpose(q), np.transpose(patterns), strict=True):
        steps = {
            sign: [_step(convention, *row, sign * angle) for angle in angles] for sign in (1, -1)
        }
        T = T @ np.array([steps[sign] for sign in signs])
    return T


@remembered
def _all_ends(table, q):
    """Return the poses of all patterns, which every wrong answer that is tried needs."""
    return _ends(table, q, _patterns(table))


def _gaps(table, q, poses, convention=standard):
    """Return the largest difference of each pattern and configuration in position and orientation,
    (2^n, m, 2)."""
    if convention is standard:
        gap = np.abs(_all_ends(table, q) - poses)
    else:
        gap = np.abs(_ends(table, q, _patterns(table), convention) - poses)
    return np.stack([gap[..., :3, 3].max(-1), gap[..., :3, :3].max((-1, -2))], -1)


def _best(table, costs):
    """Return the pattern of the least cost, (2^n,); the first of those that are equal."""
    return _patterns(table)[np.argmin(np.round(costs, 9))]


def _right(table, q, poses):
    """Return the pattern whose worst configuration is best."""
    return _best(table, _gaps(table, q, poses).max((1, 2)))


def _judged(cost):
    """Return the answer whose pattern has the least cost(gaps), of gaps (2^n, m, 2)."""
    return lambda table, q, poses: _best(table, cost(_gaps(table, q, poses)))


def _other_convention(table, q, poses):
    return _best(table, _gaps(table, q, poses, modified).max((1, 2)))


def _differences(table, q, poses):
    """Return the poses of each pattern minus those measured, (2^n, m, 4, 4)."""
    return _all_ends(table, q) - poses


def _largest(differences):
    return np.abs(differences).max((1, 2, 3))


def _squares(differences):
    return (differences**2).sum((1, 2, 3))


def _absolute(differences):
    return np.abs(differences).sum((1, 2, 3))


def _with_signs(part, size):
    """Return the answer that adds up a part of the differences with their signs."""

    def answer(table, q, poses):
        differences = _differences(table, q, poses)[part]
        return _best(table, size(differences.reshape(len(differences), -1).sum(1)))

    return answer


_SIGNED = tuple(
    _with_signs(part, size)
    for part in (np.s_[..., :3, 3], np.s_[...])
    for size in (np.positive, np.abs)
)


def _one_at_a_time(from_last, size, rounds):
    """Return the answer that decides the sign of one joint after the other."""

    def answer(table, q, poses):
        costs = np.round(size(_differences(table, q, poses)), 9)
        cost_of = dict(zip(map(tuple, _patterns(table)), costs, strict=True))
        joints = range(len(table))
        order = joints[::-1] if from_last else joints
        signs = [1] * len(table)
        for i in [*order] * rounds:
            plus, minus = ((*signs[:i], sign, *signs[i + 1 :]) for sign in (1, -1))
            signs[i] = 1 if cost_of[plus] <= cost_of[minus] else -1
        return np.array(signs)

    return answer


_JOINT_BY_JOINT = tuple(
    _one_at_a_time(*form) for form in itertools.product((False, True), (_largest, _squares), (1, 8))
)


def _between_frames(seen_from, size):
    return lambda table, q, poses: _best(table, size(seen_from(_all_ends(table, q), poses)))


_IN_THE_WORLD = tuple(
    _between_frames(seen_from, size)
    for seen_from in (
        lambda ends, poses: T_W0 @ ends - poses,
        lambda ends, poses: ends - T_W0 @ poses,
        lambda ends, poses: ends - inverse(T_W0) @ poses,
    )
    for size in (_largest, _squares, _absolute)
)


def _signs_pile_up(table, q, poses):
    piled = np.cumprod(_patterns(table), axis=0)
    return _best(table, np.abs(_ends(table, q, piled) - poses).max((1, 2, 3)))


def _first_within(tolerance):
    def answer(table, q, poses):
        close = np.abs(_differences(table, q, poses)).max((1, 2, 3)) < tolerance
        return _patterns(table)[np.argmax(close)] if close.any() else _right(table, q, poses)

    return answer


def _case(rng, n, m=3, zero=None, noise=0.0, deceives=(), reversed_joints=None, small=False):
    """Return a table, m configurations, and the poses that they have if some joints have the
    opposite sign.

    The last row has a = 0, so that no position shows the sign of the last joint. deceives: wrong
    answers to the case. reversed_joints: how many joints have the opposite sign, or None for any
    number but all. small: whether all angles are small, so that all patterns are close, and the
    links so long that the positions differ by more than the orientations.
    """
    least = 0.02 if small else 0.2  # of the difference of the second best pattern
    while True:
        table = np.round(rng.uniform(0.2, 0.8, (n, 3)), 2)
        table[:, 1] = rng.choice([-1, 1], n) * np.round(rng.uniform(0.6, 1.5, n), 2)
        table[-1, :2] = 0
        if small:
            table[:, [0, 2]] *= 5
        signs = rng.choice([-1, 1], n)
        signs[-1] = -1
        if reversed_joints is not None:
            signs = np.ones(n, int)
            signs[n - reversed_joints :] = -1
        size = rng.uniform(0.03, 0.1, (2, n)) if small else rng.uniform(0.4, 1.4, (m, n))
        q = np.round(size * rng.choice([-1, 1], size.shape), 3)
        if zero is not None:
            q[zero] = 0  # which fits any pattern
        poses = _ends(table, q, [signs])[0]
        if noise:
            poses[:, :3] += rng.uniform(-noise, noise, (m, 3, 4))  # so R is not quite a rotation
        mixed = reversed_joints is not None or (signs > 0).any()
        clear = mixed and np.sort(_gaps(table, q, poses).max((1, 2)))[1] > least
        if clear and not any(np.array_equal(answer(table, q, poses), signs) for answer in deceives):
            return table, q, poses


def _cases(rng):
    table, q = np.array([[0.5, np.pi / 2, 0.3], [0.4, 0, 0]]), np.array([[0.3, 0.2], [-0.25, 0.3]])
    simple = table, q, _ends(table, q, [[1, -1]])[0]
    drawn = [_case(rng, 3, zero=zero, deceives=[_other_convention]) for zero in (None, 0, -1)]
    noisy = [_case(rng, 4, noise=noise, deceives=_JOINT_BY_JOINT[:1]) for noise in (1e-4, 9e-4)]
    drawn.append(_case(rng, 8, m=1))  # more joints than the Panda has
    many = [_case(rng, 4, reversed_joints=3), _case(rng, 4, reversed_joints=4)]
    one = [_one_joint(rng, sign) for sign in (-1, 1)]
    given = [simple, *drawn, *noisy, *many, *one, *_equal_orientations(rng), _one_joint_moves(rng)]
    unlucky = _unlucky(rng, [*_JOINT_BY_JOINT, *_SIGNED[:3]], given)
    whole = np.array([[1, 1, 0], [2, 0, 1]]), np.array([[1, 2], [-1, 1], [2, -1]])
    # A constant difference of all poses decides only where the patterns are close.
    given += [
        *unlucky,
        _mirrored(rng),
        *_unlucky(rng, _IN_THE_WORLD, [*given, *unlucky], small=True),
    ]
    # A whole table and small angles: the squares of all differences are below 1.
    lengths = np.array([[1, 1, 0], [1, 0, 1]]), np.array([[0.05, 0.1], [-0.1, 0.05]])
    return [*given, *((*arm, _ends(*arm, [[-1, 1]])[0]) for arm in (lengths, whole))]


def _equal_orientations(rng):
    """Return two cases in which the orientations fit two patterns, and the positions only one.

    The first two axes are parallel and their angles equal, so with opposite signs the orientations
    do not say which of the two is reversed.
    """
    lengths, height = np.round(rng.uniform(0.3, 0.8, 2), 2), round(rng.uniform(0.1, 0.4), 2)
    table = np.array([[lengths[0], 0, 0], [lengths[1], 0, 0], [0, 0, height]])
    equal, last = np.round(rng.uniform(0.4, 1.2, (2, 3)), 2) * rng.choice([-1, 1], (2, 3))
    q = np.column_stack([equal, equal, last])
    return [(table, q, _ends(table, q, [signs])[0]) for signs in ([-1, 1, 1], [1, -1, -1])]


def _one_joint(rng, sign):
    """Return a case of one joint in one configuration."""
    table, q = np.array([[0.5, 0.0, 0.0]]), np.round(rng.uniform(0.3, 1.4, (1, 1)), 2)
    return table, q, _ends(table, q, [[sign]])[0]


def _one_joint_moves(rng):
    """Return a case in which each configuration shows the sign of one joint only."""
    table = np.round(rng.uniform(0.3, 0.8, (3, 3)), 2)
    q = np.diag(np.round(rng.uniform(0.4, 1.2, 3), 2) * rng.choice([-1, 1], 3))
    return table, q, _ends(table, q, [[-1, 1, -1]])[0]


def _nearly_alike(rng, size):
    """Return a case with a small angle: the poses of two patterns hardly differ."""
    table = np.round(rng.uniform(0.2, 0.8, (2, 3)), 2)
    q = np.array([[0.7, size], [-0.4, -size]])
    return table, q, _ends(table, q, [[1, -1]])[0]


def _mirrored(rng):
    """Return a case of a planar arm in configurations q and -q.

    With all signs reversed, the end-effector is mirrored in both configurations, and differences
    from the measured poses have the sum 0, as with the right signs.
    """
    table = np.array([[0.5, 0, 0], [0.4, 0, 0], [0, 0, 0]]) + rng.choice([0, 0.1], (3, 1)) * [
        1,
        0,
        0,
    ]
    half = np.round(rng.uniform(0.4, 1.2, 3), 2) * rng.choice([-1, 1], 3)
    q = np.array([half, -half])
    return table, q, _ends(table, q, [[-1, *rng.choice([-1, 1], 2)]])[0]


def _unlucky(rng, shortcuts, cases, small=False):
    """Return further cases, so that each shortcut, which is often right by luck, misses one."""
    added = []
    for shortcut in shortcuts:
        if not any(_is_wrong(shortcut, case) for case in (*cases, *added)):
            added.append(_case(rng, 3 if small else 4, deceives=[shortcut], small=small))
    return added


def _is_wrong(shortcut, case):
    return not np.array_equal(shortcut(*case), _right(*case))


def _found(answer, table, q, poses):
    k = int((_patterns(table) == answer).all(1).argmax())
    gaps = _gaps(table, q, poses).reshape(len(_patterns(table)), -1).max(1)
    return (
        f"With your signs the poses differ by up to {gaps[k]:.2g}, and with another pattern by "
        f"{gaps.min():.2g} at most."
    )


EXERCISE = declared(
    "find_signs",
    points=2,
    sets=1,
    arguments={"table": OWN_CASES, "q": OWN_CASES, "poses": OWN_CASES},
    cases=_cases,
    library=_right,
    tries_arguments=False,
    properties=(
        Property(
            "the answer holds 1 and -1 only",
            lambda answer, *case: np.isin(answer, [1, -1]).all(),
            otherwise=Question(
                "something other than signs is returned",
                "Which pattern is the best, and what does your code return for it? A pattern "
                "holds 1 and -1.",
            ),
        ),
    ),
    says="with the signs applied to its angles, the table gives the poses that were measured",
    found=_found,
    otherwise=Question(
        "another pattern fits better",
        "For the case below, print the largest difference between your poses and the measured "
        "poses for each of the 2^n patterns. Is the pattern that you return the one with the least "
        "difference?",
    ),
    # Poses are compared to nine digits, so a smaller angle shows nothing.
    sweeps=(Sweep("two patterns hardly differ", _nearly_alike, _VISIBLE),),
    hints=(
        "itertools.product([1, -1], repeat=n) runs through all patterns. For each one, compute the "
        "pose of every configuration and compare it with the one measured.",
        "A pattern is as good as its worst configuration. Keep the pattern whose worst difference "
        "is the least.",
        "The pose of one configuration: T = np.eye(4), then T = T @ dh_standard(a, alpha, d, "
        "theta) for each row, with theta the sign times the angle.",
    ),
    mistakes=(
        Mistake(
            "a part of each pose is not compared",
            "Which joint may rotate the end-effector without changing its position?",
            _judged(lambda gaps: gaps[..., 0].max(1)),
        ),
        Mistake(
            "only one configuration is compared",
            "May a wrong pattern fit one configuration by chance?",
            _judged(lambda gaps: gaps[:, 0].max(1)),
            _judged(lambda gaps: gaps[:, -1].max(1)),
        ),
        Mistake(
            "only some of the configurations are compared",
            "May a wrong pattern fit two configurations, if some of their angles are 0?",
            _judged(lambda gaps: gaps[:, :2].max((1, 2))),
            _judged(lambda gaps: gaps[:, -2:].max((1, 2))),
        ),
        Mistake(
            "only orientations are compared",
            "Two axes are parallel. What do the orientations say of their two signs if the angles "
            "are equal?",
            _judged(lambda gaps: gaps[..., 1].max(1)),
        ),
        Mistake(
            "differences are added up with their signs",
            "What is the sum of the differences 0.3 and -0.3?",
            *_SIGNED,
        ),
        Mistake(
            "the sign of one joint is decided after the other",
            "Does the best sign of one joint depend on those of the others?",
            *_JOINT_BY_JOINT,
        ),
        Mistake(
            "the table is read in the modified convention",
            "Which convention does the task name for the table?",
            _other_convention,
        ),
        Mistake(
            "the table's poses and the measured poses are seen from two different frames",
            "From which frame are the measured poses seen, and does T_w0 belong into your product?",
            *_IN_THE_WORLD,
        ),
        Mistake(
            "the signs of all patterns so far are multiplied to the same angles",
            "Which angles does the second pattern find after q *= signs?",
            _signs_pile_up,
        ),
        Mistake(
            "the first pattern within a tolerance is returned",
            "May several patterns come close to the measured poses? Which of them does the task "
            "ask for?",
            *map(_first_within, (0.1, 0.02, 0.01, 1e-3, 1e-4)),
        ),
    ),
)
