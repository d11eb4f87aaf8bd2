"""fit_sag: how far the shoulder of the sagging arm rotates back, from angles sent and positions
measured."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.tolerances import HALF_THE_DIGITS
from course_lib.checks.vocabulary import two_link_tip


def _wrapped(angle):
    return np.angle(np.exp(1j * angle))


def _gap(q, xy):
    return q[:, 0] + q[:, 1] / 2 - np.arctan2(xy[:, 1], xy[:, 0])


def _cosines(q):
    return np.column_stack([np.cos(q[:, 0]), np.cos(q[:, 0] + q[:, 1])])


def fit_sag(q, xy, gap=_gap, wrap=_wrapped, columns=_cosines):
    """Return the coefficients (2,) of cos q1 and cos(q1 + q2) in delta, by which the first joint
    stops short."""
    q, xy = np.asarray(q, float), np.asarray(xy, float)
    return np.linalg.lstsq(columns(q), wrap(gap(q, xy)), rcond=None)[0]


def _samples(rng, m, sag, noise, low=0.2, high=1.6):
    """Angles sent (m, 2), and positions of an arm with these coefficients of sag; q1 from low to
    high."""
    q = rng.uniform([low, -1.5], [high, 1.5], (m, 2))
    q[0] = high, 1.5  # whose tip is beyond 180 degrees if any can be
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
        # An arm so weak that delta exceeds a right angle: no sample may be left out as too far off.
        _samples(rng, 30, [1.9, 0.6], 0.005),
        _samples(rng, 30, [7e-7, -4e-7], 0),
        # Joints that have made whole revolutions: one more or less does not wrap these.
        _revolved(*_samples(rng, 30, drawn[0], 0)),
        (np.array([[0, 0], [1, 0], [0, 1], [2, -1]]), np.array([[2, 0], [1, 2], [2, 1], [0, 2]])),
    ]


def _revolved(q, xy):
    """Return samples whose first joint has made up to three revolutions, either way."""
    revolutions = np.arange(len(q)) % 7 - 3
    return q + np.column_stack([2 * np.pi * revolutions, np.zeros(len(q))]), xy


def _other_fit(answer, q, xy):
    largest = np.abs(_wrapped(_gap(q, xy))).max()
    return Mistake(
        "delta, one of its two columns, or their fit is not that of the text",
        f"Print the largest |delta| over all samples, which is {largest:.2g} here. Then compare "
        "your two columns with cos q1 and cos(q1 + q2).",
    )


EXERCISE = Exercise(
    name="fit_sag",
    points=2,
    arguments=("q", "xy"),
    cases=_cases,
    returns=numbers(lambda q, xy: (2,)),
    library=fit_sag,
    properties=(
        Property(
            "the two coefficients are the least-squares fit to delta, including for tips beyond "
            "180 "
            "degrees",
            lambda answer, *case: np.abs(answer - fit_sag(*case)).max() < HALF_THE_DIGITS,
            mistake=_other_fit,
        ),
    ),
    hints=(
        "In which direction does the tip of the rigid arm lie? np.arctan2 gives the measured "
        "direction.",
        "A direction just beyond 180 degrees is given as -180. What does that do to the "
        "difference, and how did "
        "notebook 2 wrap an angle?",
        "The unknowns are factors of two known columns: np.linalg.lstsq(A, b)[0] with A of shape "
        "(m, 2).",
        "A = np.column_stack([np.cos(q1), np.cos(q1 + q2)]), and b = wrapped(q1 + q2 / 2 - "
        "direction).",
    ),
)


@EXERCISE.mistake(
    "delta has the other sign",
    "If the arm sags, which direction has the larger angle: the rigid arm's, or the measured one?",
)
def other_sign(q, xy):
    return -fit_sag(q, xy)


@EXERCISE.mistake(
    "a delta is off by a full revolution, or by several",
    "Print the largest |delta| over all samples. What does arctan2 return for a tip just beyond "
    "180 "
    "degrees?",
    wrap=(
        lambda gap: gap,
        lambda gap: gap % (2 * np.pi),
        lambda gap: np.where(gap > np.pi, gap - 2 * np.pi, gap),
        lambda gap: np.where(gap < -np.pi, gap + 2 * np.pi, gap),
        np.unwrap,
        lambda gap: np.where(np.abs(gap) > np.pi, gap - np.sign(gap) * 2 * np.pi, gap),
    ),
)
def not_wrapped(q, xy, wrap):
    return fit_sag(q, xy, wrap=wrap)


@EXERCISE.mistake(
    "the second cosine is not that of q1 + q2",
    "In which direction does the second link point?",
    second=(lambda q: q[:, 1], lambda q: q[:, 0] + q[:, 1] / 2),
)
def other_cosine(q, xy, second):
    return fit_sag(q, xy, columns=lambda q: np.cos(np.column_stack([q[:, 0], second(q)])))


@EXERCISE.mistake(
    "the tip of the rigid arm is not taken to lie in the direction q1 + q2 / 2",
    "Both links are equally long: where does the tip lie between their directions?",
    share=(0, 1, -0.5),
)
def other_direction(q, xy, share):
    return fit_sag(q, xy, gap=lambda q, xy: _gap(q, xy) + (share - 0.5) * q[:, 1])


@EXERCISE.mistake(
    "a constant term is fitted as well",
    "What is delta if both links stand upright?",
)
def with_a_constant(q, xy):
    return fit_sag(q, xy, columns=lambda q: np.column_stack([_cosines(q), np.ones(len(q))]))[:2]
