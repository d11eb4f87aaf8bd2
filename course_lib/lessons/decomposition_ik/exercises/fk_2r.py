"""fk_2r: the position of the tip of a planar arm with two links of one metre."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.comparisons import same
from course_lib.checks.declared import declared
from course_lib.checks.format_numbers import format_as_needed
from course_lib.checks.kinds import QUARTER, joint_angles
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import BESIDE
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import compared, two_link_tip

_SHOWN = 0.01  # m: a difference that three digits show

_FIRST_ROWS = (
    "q[0] and q[1] are taken for the two angles: in a batch they are its first two rows",
    "Along which axis do the two angles of a pair lie? The dots in q[..., 0] stand for all axes "
    "before it.",
)
_NOT_FROM_THE_ELBOW = Question(
    "the tip is not 1 m from the elbow",
    "Print the elbow, (cos q1, sin q1), and your tip for these angles. Which angle stands in each "
    "cosine and each sine, and how long is each link in your code?",
)


def _named(rng):
    pairs = [[0.0, 0], [QUARTER, 0], [0, QUARTER], [0, -QUARTER], [QUARTER, QUARTER], [0.0, np.pi]]
    low, high = np.deg2rad([0, -90]), np.deg2rad([170, 90])
    batches = [rng.uniform(low, high, (*batch, 2)) for batch in [(5,), (2,), (2, 3), (2, 0), (1,)]]
    whole = [np.array([1.0, 2]), np.array([[1.0, 0], [0, 2]])]
    return [*map(np.array, pairs), *batches, [QUARTER, QUARTER], *whole]


_ANGLES = joint_angles(2).but(
    named=_named,
    beside=(
        ("nearly stretched", lambda rng, q2: np.array([rng.uniform(0.3, 2), q2]), BESIDE),
        ("nearly folded", lambda rng, gap: np.array([rng.uniform(0.3, 2), np.pi - gap]), BESIDE),
    ),
    small=True,
)


def _first_rows(q):
    q1, q2 = q[0], q[1]
    return np.array([np.cos(q1) + np.cos(q1 + q2), np.sin(q1) + np.sin(q1 + q2)])


def _are_first_rows(array, q):
    rows = _first_rows(q)
    return np.ndim(q) > 1 and (same(array, rows) or same(array, np.moveaxis(rows, 0, -1)))


def _elbow(q):
    q1 = np.asarray(q, float)[..., 0]
    return np.stack([np.cos(q1), np.sin(q1)], -1)


def _gaps(found, q):
    """Return for each pair how far the tip's distance from the elbow is from 1 m."""
    return np.ravel(np.linalg.norm(found - _elbow(q), axis=-1) - 1)


def _is_off_the_elbow(found, q):
    return np.abs(_gaps(found, q)).max(initial=0) > EXACT


def _written(pair, tip):
    """Return two angles with so many digits that the tip's error is not that of the digits."""
    gap = np.abs(two_link_tip(pair) - tip).max()
    return format_as_needed(
        pair, lambda written: np.abs(two_link_tip(written) - two_link_tip(pair)).max() < gap / 10
    )


def _found(found, q):
    """Describe the pair whose tip has the distance from the elbow that is farthest from 1 m, or
    else the one whose tip is farthest from where it should be."""
    pairs, tips, right = (np.reshape(each, (-1, 2)) for each in (q, found, two_link_tip(q)))
    if not _is_off_the_elbow(found, q):
        k = int(np.argmax(np.linalg.norm(tips - right, axis=-1)))
        return (
            f"For q = {_written(pairs[k], tips[k])} the tip is at "
            + compared(right[k], tips[k])
            + "."
        )
    gaps = _gaps(found, q)
    k = int(np.argmax(np.abs(gaps)))
    distance = f"is {1 + gaps[k]:.3g} m"
    if abs(gaps[k]) < _SHOWN:
        distance = f"differs from 1 m by {gaps[k]:.2g} m"
    return (
        f"For q = {_written(pairs[k], tips[k])} the tip is at "
        + compared(right[k], tips[k])
        + f". The distance of your tip from the elbow {distance}."
    )


def _second_link_along(direction):
    def answer(q):
        q = np.asarray(q, float)
        second = direction(q[..., 0], q[..., 1])
        return _elbow(q) + np.stack([np.cos(second), np.sin(second)], -1)

    return answer


EXERCISE = declared(
    "fk_2r",
    points=1,
    arguments={"q": _ANGLES},
    tolerance=EXACT,
    reads=numbers(np.shape, exact=True),
    library=two_link_tip,
    says="the tip is 1 m from the elbow, in the direction q1 + q2; the elbow is 1 m from the base, "
    "in the direction q1",
    found=_found,
    otherwise=lambda found, q: _NOT_FROM_THE_ELBOW if _is_off_the_elbow(found, q) else None,
    hints=(
        "The first link ends at the elbow, (cos q1, sin q1). Add the second link to it.",
        "q2 is measured from the first link, so the second link points in the direction q1 + q2.",
        "q1, q2 = q[..., 0], q[..., 1] works for one pair and for many; np.stack([x, y], axis=-1) "
        "puts x and y back at the end.",
    ),
    forbidden=(
        "course_lib.arms.SerialArm",
        "course_lib.arms.planar_arm",
        "course_lib.lessons.decomposition_ik.grid_ik.planar_forward",
    ),
    mistakes=(
        Mistake(*_FIRST_ROWS, form=_are_first_rows),
        Mistake(
            "q[:, 0] asks for a list of pairs: a single pair has no rows",
            "Which index takes the first angle of a single pair, and of each pair in a batch?",
            raises=("IndexError", "too many indices"),
        ),
        Mistake(*_FIRST_ROWS, raises=("ValueError", "values to unpack")),
        Mistake(
            "the second link does not have the direction q1 + q2",
            "From which direction is q2 measured, and in which sense of rotation?",
            _second_link_along(lambda q1, q2: q2),
            _second_link_along(lambda q1, q2: q1 - q2),
            _second_link_along(lambda q1, q2: q2 - q1),
            _second_link_along(lambda q1, q2: 2 * q1 + q2),
        ),
    ),
)
