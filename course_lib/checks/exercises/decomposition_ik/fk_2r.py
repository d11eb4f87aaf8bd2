"""fk_2r: the position of the tip of a planar arm with two links of one metre."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercises.decomposition_ik.shared import position, with_a_list
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.vocabulary import argument_degrees

_FIRST_ROWS = Mistake(
    "q[0] and q[1] are taken for the two angles: in a batch they are its first two rows",
    "q[..., 0] is the first joint's angle of every row, and of a single pair too.",
)
_WRONG_AXIS = Mistake(
    "x and y are stacked along the first axis",
    "np.stack([x, y], axis=-1) puts the two beside each other at the end.",
)
_ONE_NUMBER = Mistake("only one number comes back for each pair of angles", "A position is two numbers: x and y.")
_THREE = Mistake("the positions are those of space, with three numbers", "The arm is planar: x and y only.")
_ONE_POSITION = Mistake(
    "one position comes back for the whole batch", "Keep the axes of the batch: q[..., 0] has one number each row."
)
_COLUMNS_ONLY = Mistake(
    "q[:, 0] asks for a list of pairs: a single pair has no rows",
    "q[..., 0] is the first joint's angle of a single pair, and of each pair in a batch.",
)


def _cases(rng):
    quarter = np.pi / 2
    named = [[0.0, 0], [quarter, 0], [0, quarter], [0, -quarter], [quarter, quarter], [0.0, np.pi]]
    low, high = np.deg2rad([0, -90]), np.deg2rad([170, 90])
    drawn = np.round(np.array([[0.4, 0.7], [1.9, -1.2]]) + rng.uniform(-0.2, 0.2, (2, 2)), 2)
    batches = [rng.uniform(low, high, (*batch, 2)) for batch in [(5,), (2,), (2, 3), (2, 0)]]
    return [(q,) for q in [*map(np.array, named), *drawn, *batches]]


def _known_form(array, q):
    batch, shape = q.shape[:-1], array.shape
    if shape == batch:
        return _ONE_NUMBER
    if shape == (*batch, 3):
        return _THREE
    if len(batch) > 0 and shape == (2, *batch):
        return _WRONG_AXIS
    if len(batch) > 0 and shape in ((2,), (2, 1)):
        return _ONE_POSITION
    if len(batch) > 0 and (shape == (*q.shape[1:-1], 2, 2) or shape in (q.shape[1:], (2, *q.shape[1:]))):
        return _FIRST_ROWS
    return None


def _from_elbow(positions, q):
    return positions - np.stack([np.cos(q[..., 0]), np.sin(q[..., 0])], -1)


def _worst(positions, q):
    """The angles and the position that is farthest from where it should be."""
    off = np.linalg.norm(positions - position(q), axis=-1).reshape(-1)
    k = np.argmax(off)
    return q.reshape(-1, 2)[k], positions.reshape(-1, 2)[k]


def _tell_length(positions, q):
    angles, end = _worst(positions, q)
    distance = np.linalg.norm(_from_elbow(end, angles))
    return f"For q = {format_tuple(angles)} it is {round(distance, 9):.4g} m away in your answer."


def _tell_position(positions, q):
    angles, end = _worst(positions, q)
    wanted, found = format_tuple(np.round(position(angles), 9)), format_tuple(np.round(end, 9))
    return f"For q = {format_tuple(angles)} that is {wanted}. Yours is {found}."


def _sum(first, second):
    """A prediction: the sum of the links, each a function of both angles."""
    return lambda q: np.stack(
        [a + b for a, b in zip(first(*np.moveaxis(q, -1, 0)), second(*np.moveaxis(q, -1, 0)), strict=True)], -1
    )


def _link(angle):
    return lambda t1, t2: (np.cos(angle(t1, t2)), np.sin(angle(t1, t2)))


def _nothing(t1, t2):
    return 0 * t1, 0 * t2


_FIRST, _BOTH = _link(lambda t1, t2: t1), _link(lambda t1, t2: t1 + t2)

EXERCISE = with_a_list(
    Exercise(
        name="fk_2r",
        points=1,
        arguments=("q",),
        cases=_cases,
        returns=numbers(lambda q: q.shape, _known_form),
        properties=(
            Property(
                "with both angles zero the arm is stretched along x: the tip is at (2, 0)",
                lambda positions, q: np.allclose(positions, [2, 0], rtol=0, atol=1e-9),
                where=lambda q: q.size > 0 and not q.any(),
            ),
            Property(
                "the tip is 1 m from the elbow, which is at (cos q1, sin q1)",
                lambda positions, q: np.allclose(
                    np.linalg.norm(_from_elbow(positions, q), axis=-1), 1, rtol=0, atol=1e-9
                ),
                says=_tell_length,
            ),
            Property(
                "the second link points in the direction q1 + q2: the tip is at "
                "(cos q1 + cos(q1 + q2), sin q1 + sin(q1 + q2))",
                lambda positions, q: np.allclose(positions, position(q), rtol=0, atol=1e-9),
                says=_tell_position,
            ),
        ),
        mistakes=(
            Mistake(
                "q2 is counted from the x axis",
                "q2 is counted from the first link's direction, so the second link points along q1 + q2.",
                _sum(_FIRST, _link(lambda t1, t2: t2)),
            ),
            Mistake(
                "q2 is subtracted from q1",
                "Both are counted counter-clockwise: the second link points along q1 + q2.",
                _sum(_FIRST, _link(lambda t1, t2: t1 - t2)),
                _sum(_FIRST, _link(lambda t1, t2: t2 - t1)),
            ),
            argument_degrees(position, name="the angles are taken for degrees"),
            Mistake(
                "the angles are converted to degrees",
                "np.cos and np.sin take radians.",
                lambda q: position(np.rad2deg(q)),
            ),
            Mistake(
                "x and y are swapped, or sine and cosine are: the cosines belong to x",
                "At the angle 0 a link points along x: x = cos 0 = 1, y = sin 0 = 0.",
                lambda q: position(q)[..., ::-1],
            ),
            Mistake(
                "the second link is missing",
                "Add cos(q1 + q2) to x and sin(q1 + q2) to y.",
                _sum(_FIRST, _nothing),
            ),
            Mistake(
                "the first link is missing",
                "The second link begins at the elbow, at (cos q1, sin q1).",
                _sum(_nothing, _BOTH),
            ),
            Mistake(
                "y has the wrong sign",
                "Angles are counted from x towards y: a small q1 gives a small y above 0.",
                lambda q: position(-q),
            ),
            Mistake(
                "the second link is subtracted from the first",
                "Both links add up: the tip is elbow + second link.",
                _sum(_FIRST, _link(lambda t1, t2: t1 + t2 + np.pi)),
            ),
            Mistake(
                "q1 and q2 are swapped",
                "q[..., 0] is the joint at the base.",
                lambda q: position(q[..., ::-1]),
            ),
            Mistake(
                "q1 is counted twice",
                "The second link points along q1 + q2.",
                _sum(_FIRST, _link(lambda t1, t2: 2 * t1 + t2)),
            ),
            Mistake(
                "a link is not 1 m long",
                "Both links are 1 m: nothing stands before the sines and cosines.",
                lambda q: position(q) / 2,
                lambda q: 2 * position(q),
            ),
            Mistake(
                "x and y are stacked along the first axis and then put into rows",
                "np.stack([x, y], axis=-1); reshape does not swap axes.",
                lambda q: np.moveaxis(position(q), -1, 0).reshape(q.shape) if q.ndim > 1 else position(q),
            ),
        ),
        library=lambda q: position(np.asarray(q, float)),
        hints=(
            "The first link ends at the elbow, (cos q1, sin q1). Add the second link to it.",
            "q2 is counted from the first link, so the second one points in the direction q1 + q2.",
            "q1, q2 = q[..., 0], q[..., 1] works for one pair and for many; np.stack([x, y], axis=-1) "
            "puts x and y back at the end.",
        ),
        forbidden=(
            "course_lib.arms.SerialArm",
            "course_lib.arms.planar_arm",
        ),
        errors=(
            ("IndexError", "too many indices", _COLUMNS_ONLY),
            ("ValueError", "values to unpack", _FIRST_ROWS),
        ),
    ),
    position=4,
)
