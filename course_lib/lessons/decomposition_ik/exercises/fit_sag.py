"""fit_sag: how far the shoulder of the sagging arm rotates back, from angles sent and positions
measured."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.kinds import OWN_CASES, QUARTER, quarters, whole_numbers
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.vocabulary import two_link_tip
from course_lib.lessons.decomposition_ik.exercises.shared import some_twice


def _wrapped(angle):
    return np.angle(np.exp(1j * angle))


def _gap(q, xy):
    return q[:, 0] + q[:, 1] / 2 - np.arctan2(xy[:, 1], xy[:, 0])


def _between_directions(q, xy):
    """Return the same up to a full revolution, if both directions come from arctan2."""
    return _wrapped(q[:, 0] + q[:, 1] / 2) - np.arctan2(xy[:, 1], xy[:, 0])


def _cosines(q):
    return np.column_stack([np.cos(q[:, 0]), np.cos(q[:, 0] + q[:, 1])])


def _fitted(gap=_gap, wrap=_wrapped, columns=_cosines):
    """Return the answer that fits columns(q) to wrap(gap(q, xy)) by least squares."""

    def answer(q, xy):
        q, xy = np.asarray(q, float), np.asarray(xy, float)
        return np.linalg.lstsq(columns(q), wrap(gap(q, xy)), rcond=None)[0]

    return answer


_right = _fitted()


def _samples(rng, m, sag, noise, low=0.2, high=1.6, bend=1.5):
    """Angles sent (m, 2), and positions of an arm with these coefficients of sag; q1 from low to
    high, and q2 up to bend."""
    q = rng.uniform([low, -bend], [high, bend], (m, 2))
    q[0] = high, bend  # whose tip is beyond 180 degrees if any can be
    taken = q - np.column_stack([_cosines(q) @ sag, np.zeros(m)])
    return q, two_link_tip(taken) + noise * rng.normal(size=(m, 2))


def _cases(rng):
    drawn = rng.uniform(0.03, 0.12, (3, 2))
    return [
        _samples(rng, 3, [0.1, 0.05], 0),
        _samples(rng, 20, [0.08, 0.0], 0),
        _samples(rng, 20, drawn[0], 0, 0, 2.9),
        _samples(rng, 40, drawn[1], 0.001),
        _samples(rng, 60, drawn[2], 0.01, 0, 2.9),
        _samples(rng, 40, drawn[1], 0.001, -2.9, 2.9),
        # An arm that rises, so that the other of the two directions is the one beyond 180 degrees.
        _samples(rng, 60, [-0.5, -0.2], 0.001, -2.9, 2.9),
        # An arm that is nearly straight in all samples, so that its two cosines differ little.
        _samples(rng, 12, drawn[0], 0, bend=1e-3),
        # An arm so weak that delta exceeds a right angle: no sample may be left out as too far off.
        _samples(rng, 30, [1.9, 0.6], 0.005),
        _samples(rng, 30, [7e-7, -4e-7], 0),
        some_twice(*_samples(rng, 6, drawn[1], 0.01)),
        # Joints that have made whole revolutions: one more or less does not wrap these.
        _revolved(*_samples(rng, 30, drawn[0], 0)),
        (np.array([[0, 0], [1, 0], [0, 1], [2, -1]]), np.array([[2, 0], [1, 2], [2, 1], [0, 2]])),
    ]


def _special(rng):
    """Samples of some quarters of a revolution, and directions half a revolution from none of
    them; None now and then."""
    q = np.column_stack([quarters(rng, 6), QUARTER * rng.integers(-1, 2, 6)])
    xy = whole_numbers(rng, (6, 2))
    is_clear = np.abs(_wrapped(_gap(q, xy))).max() < 3 and np.hypot(*xy.T).min() > 0
    return (q, xy) if is_clear and np.linalg.matrix_rank(_cosines(q), 1e-6) == 2 else None


def _revolved(q, xy):
    """Return samples whose first joint has made up to three revolutions, either way."""
    revolutions = np.arange(len(q)) % 7 - 3
    return q + np.column_stack([2 * np.pi * revolutions, np.zeros(len(q))]), xy


def _otherwise(answer, q, xy):
    largest = np.abs(_wrapped(_gap(q, xy))).max()
    return Question(
        "delta, one of its two columns, or their fit is not that of the text",
        f"Print the largest |delta| over all samples, which is {largest:.2g} here. Then compare "
        "your two columns with cos q1 and cos(q1 + q2). If both are right, which samples does your "
        "fit use, and what else?",
    )


def _second_cosine_of(second):
    return _fitted(columns=lambda q: np.cos(np.column_stack([q[:, 0], second(q)])))


def _direction_with(share):
    """Return the answer whose rigid tip lies in the direction q1 + share q2."""
    return _fitted(gap=lambda q, xy: _gap(q, xy) + (share - 0.5) * q[:, 1])


def _with_a_constant(q, xy):
    with_ones = _fitted(columns=lambda q: np.column_stack([_cosines(q), np.ones(len(q))]))
    return with_ones(q, xy)[:2]


_ONE_SIDED = (
    lambda gap: np.where(gap > np.pi, gap - 2 * np.pi, gap),
    lambda gap: np.where(gap < -np.pi, gap + 2 * np.pi, gap),
)

EXERCISE = declared(
    "fit_sag",
    points=2,
    arguments={"q": OWN_CASES, "xy": OWN_CASES},
    cases=_cases,
    library=_right,
    says="the two coefficients are the least-squares fit to delta, including for tips beyond 180 "
    "degrees",
    otherwise=_otherwise,
    special=_special,
    hints=(
        "In which direction does the tip of the rigid arm lie? np.arctan2 gives the measured "
        "direction.",
        "A direction just beyond 180 degrees is given as -180. What does that do to the "
        "difference, and how did notebook 2 wrap an angle?",
        "The unknowns are factors of two known columns: np.linalg.lstsq(A, b)[0] with A of shape "
        "(m, 2).",
        "A = np.column_stack([np.cos(q1), np.cos(q1 + q2)]), and b = wrapped(q1 + q2 / 2 - "
        "direction).",
    ),
    mistakes=(
        Mistake(
            "delta has the other sign",
            "If the arm sags, which direction has the larger angle: the rigid arm's, or the "
            "measured one?",
            lambda q, xy: -_right(q, xy),
            _fitted(gap=lambda q, xy: -_gap(q, xy), wrap=lambda gap: gap),
        ),
        Mistake(
            "a delta is off by a full revolution, or by several",
            "Print the largest |delta| over all samples. What does arctan2 return for a tip just "
            "beyond 180 degrees?",
            _fitted(wrap=lambda gap: gap),
            _fitted(wrap=lambda gap: gap % (2 * np.pi)),
            *(_fitted(gap, wrap) for gap in (_gap, _between_directions) for wrap in _ONE_SIDED),
            _fitted(wrap=np.unwrap),
            _fitted(
                wrap=lambda gap: np.where(np.abs(gap) > np.pi, gap - np.sign(gap) * 2 * np.pi, gap)
            ),
        ),
        Mistake(
            "the second cosine is not that of q1 + q2",
            "In which direction does the second link point?",
            _second_cosine_of(lambda q: q[:, 1]),
            _second_cosine_of(lambda q: q[:, 0] + q[:, 1] / 2),
        ),
        Mistake(
            "the tip of the rigid arm is not taken to lie in the direction q1 + q2 / 2",
            "Both links are equally long: where does the tip lie between their directions?",
            *map(_direction_with, (0, 1, -0.5)),
        ),
        Mistake(
            "a constant term is fitted as well",
            "What is delta if both links stand upright?",
            _with_a_constant,
        ),
    ),
)
