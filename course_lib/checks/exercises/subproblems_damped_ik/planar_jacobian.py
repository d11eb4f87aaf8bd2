"""planar_jacobian: how fast the tip of the planar arm moves for each joint's velocity."""

import itertools

import numpy as np

from course_lib.arms import planar_arm
from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_array
from course_lib.checks.vocabulary import remembered

_ARM = planar_arm([1, 1, 1, 1])
_H = 1e-5  # radians: the step of the differences that are shown
_FINE = 1e-8  # how far an entry may be off: good finite differences pass

# Of the library, what would do the work: refused in all exercises with this arm.
ARMS = ("course_lib.arms.planar_arm", "course_lib.arms.SerialArm")

_TRANSPOSED = Mistake(
    "the transpose is returned", "Two rows, for x and y, and four columns, one for each joint: np.array(...).T."
)
_WITH_ANGLE = Mistake(
    "the Jacobian of a whole pose is returned",
    "Only the tip's position counts here: two rows, the velocities of x and y.",
)


@remembered
def tip(q):
    """Return where the arm's tip is, (2,)."""
    return _ARM.fk(q)[:2, 3]


@remembered
def jacobian(q):
    """Return the derivative (2, 4) of the tip's position by the joint angles."""
    return _ARM.position_jacobian(q)[:2]


def _cases(rng):
    quarter = np.pi / 2
    named = [[0, 0, 0, 0], [quarter, 0, 0, 0], [0, 0, 0, quarter], [0, quarter, 0, 0], [0.3, 0, 0, 0]]
    drawn = [rng.uniform(0.2, 1.2, 4) * signs for signs in itertools.product((1, -1), repeat=4) if signs[0] == 1]
    beyond = [rng.uniform(-9, 9, 4) for _ in range(3)]
    return [(np.array(q, float),) for q in [*named, *drawn, *beyond]] + [(np.array([1, -1, 2, 0]),)]


def _wrong_column(J, q):
    j = int(np.argmax(np.abs(J - jacobian(q)).max(axis=0) > _FINE))
    step = _H * np.eye(4)[j]
    velocity = np.round((tip(q + step) - tip(q - step)) / (2 * _H), 9)
    return (
        f"If only joint {j + 1} moves, at 1 rad/s, the tip moves at {format_array(velocity)} m/s, by finite "
        f"differences. That is column {j + 1}; yours is {format_array(J[:, j])}."
    )


def _of_links(directions, moved_by):
    """The Jacobian of links that point along `directions`, where joint j moves the links with moved_by[j]."""
    return np.array([-np.sin(directions), np.cos(directions)]) @ np.transpose(moved_by)


_AFTER = np.triu(np.ones((4, 4)))  # joint j moves the links from j on


def _moving(moved_by):
    """The prediction of those for whom joint j moves other links."""
    return lambda q: _of_links(np.cumsum(q), moved_by)


def _signed(signs):
    return lambda q: jacobian(q) * np.array(signs)[:, None]


def _with_lengths(*lengths):
    return lambda q: _of_links(np.cumsum(q), _AFTER * np.array(lengths))


def _parts(q):
    """The sums of cosines and of sines that make the columns."""
    sines, cosines = jacobian(q) * [[-1], [1]]
    return cosines, sines


def _each_from_its_joint(q, own):
    """The Jacobian with column j seen along the link before joint j, or (own = 0) along link j."""
    base = np.cumsum(q) - own * q
    return np.transpose([_of_links(np.cumsum(q) - base[j], _AFTER)[:, j] for j in range(4)])


def _without(link):
    return _AFTER * (np.arange(4) != link)


EXERCISE = Exercise(
    name="planar_jacobian",
    points=2,
    arguments=("q",),
    cases=_cases,
    returns=numbers(lambda q: (2, 4), {(4, 2): _TRANSPOSED, (3, 4): _WITH_ANGLE, (6, 4): _WITH_ANGLE}),
    properties=(
        Property(
            "column j is the velocity of the tip when joint j alone moves, at 1 rad/s",
            lambda J, q: np.abs(J - jacobian(q)).max() < _FINE,
            _wrong_column,
        ),
    ),
    mistakes=(
        Mistake(
            "the angles are not summed: link i points along q1 + ... + qi",
            "Each joint angle is measured from the link before it. np.cumsum(q) gives the directions of the links.",
            lambda q: _of_links(q, _AFTER),
            lambda q: _of_links(q, np.eye(4)),
            lambda q: _of_links(q, np.ones((4, 4))),
        ),
        Mistake(
            "each joint moves only its own link",
            "Joint j carries all links from j on: add them up.",
            _moving(np.eye(4)),
        ),
        Mistake(
            "only the last link counts",
            "The tip moves with each link from j on: add them up.",
            _moving(_AFTER * [0, 0, 0, 1]),
        ),
        Mistake(
            "the sums run in the wrong direction: over the links up to j",
            "Joint j moves the links j, ..., 4, and none before it: a cumulative sum from the back.",
            _moving(_AFTER.T),
        ),
        Mistake("every joint moves all links", "Joint j moves only the links j, ..., 4.", _moving(np.ones((4, 4)))),
        Mistake(
            "a link is left out: joint j moves link j too",
            "The sum for column j starts with link j itself.",
            _moving(np.triu(np.ones((4, 4)), 1)),
        ),
        Mistake("a link is left out", "The arm has four links.", *(_moving(_without(i)) for i in (3, 0, 1, 2))),
        Mistake("the sign of the first row is wrong", "The derivative of cos is -sin.", _signed([-1, 1])),
        Mistake("the sign of the second row is wrong", "The derivative of sin is cos.", _signed([1, -1])),
        Mistake(
            "the whole matrix has the wrong sign",
            "A positive joint velocity is counter-clockwise.",
            _signed([-1, -1]),
        ),
        Mistake(
            "the two rows are swapped", "Row 1 is the velocity along x: that with -sin.", lambda q: jacobian(q)[::-1]
        ),
        Mistake(
            "cosine and sine are not differentiated",
            "These are the arrows from the joints to the tip. Rotated by +90 degrees they are the columns.",
            lambda q: np.array(_parts(q)),
            lambda q: np.array(_parts(q)) * [[-1], [1]],
        ),
        Mistake(
            "the columns stand in reverse order",
            "Column 1 belongs to joint 1, which moves all four links.",
            lambda q: jacobian(q)[:, ::-1],
        ),
        Mistake(
            "the directions of the links are summed from the tip",
            "Link 1 points along q1, link 4 along the sum of all.",
            lambda q: _of_links(np.cumsum(q[::-1])[::-1], _AFTER),
            lambda q: _of_links(np.cumsum(q[::-1]), _AFTER),
        ),
        Mistake(
            "the angle of link i leaves out joint i itself, or counts one joint too many",
            "Link i points along q1 + ... + qi: sum(q[: i + 1]) where i counts from 0.",
            lambda q: _of_links(np.cumsum(q) - q, _AFTER),
            lambda q: _of_links(np.append(np.cumsum(q)[1:], np.sum(q)), _AFTER),
        ),
        Mistake(
            "the angles are summed from joint j on, not from the base",
            "The velocity is asked for along x and y of the base: every link points along q1 + ... + qi.",
            lambda q: _each_from_its_joint(q, 1),
            lambda q: _each_from_its_joint(q, 0),
        ),
        Mistake(
            "the angles are taken for degrees",
            "Angles are radians everywhere; np.deg2rad is not needed.",
            lambda q: jacobian(np.deg2rad(q)),
            lambda q: np.deg2rad(jacobian(q)),
            lambda q: np.rad2deg(jacobian(q)),
        ),
        Mistake(
            "the links have other lengths",
            "All four links are 1 m long.",
            _with_lengths(4, 3, 2, 1),
            _with_lengths(1, 2, 3, 4),
            *(_with_lengths(*[length] * 4) for length in (0.25, 0.5, 2, 4)),
        ),
        Mistake("the joint angles are multiplied in", "J itself, please, not J times q.", lambda q: jacobian(q) * q),
        Mistake(
            "finite differences are used that lose too many digits",
            "Take half a step to either side, (f(q + h) - f(q - h)) / (2 h) with h = 1e-6, or the formula.",
            seen=lambda J, q: np.abs(J - jacobian(q)).max() < 0.1,
        ),
    ),
    library=jacobian,
    hints=(
        "Link i points along a_i = q1 + ... + qi: a = np.cumsum(q). Its end moves at (-sin a_i, cos a_i) for each "
        "rad/s of a joint up to i.",
        "Joint j rotates the links j, ..., 4: column j is the sum of (-sin a_i, cos a_i) over i = j, ..., 4.",
        "Two loops, or a cumulative sum from the back: np.cumsum(x[::-1])[::-1].",
    ),
    forbidden=ARMS,
)
