"""What the checks of random rotations share: they judge by what is drawn, not by how."""

import itertools

import numpy as np

from course_lib.checks.exercise import Mistake, Property
from course_lib.checks.wire import Seed

LEVEL = 1e-6  # each test refuses a right sampler once in a million seeds
MANY = 20_000


def cases(rng):
    first, second, third = (Seed(int(s)) for s in rng.integers(2**31, size=3))
    return [(1, first), (3, first), (3, first), (3, second), (MANY, third)]


def many(n, rng):
    return n == MANY


def of_many(seen):
    """A Mistake's seen(value, n, rng) that looks at the case of many draws only."""
    return lambda value, n, rng: n == MANY and bool(seen(value))


def _unrepeatable(values, cases):
    return None if np.array_equal(values[1], values[2]) else 2


def _unmoved(values, cases):
    return 3 if np.allclose(values[1], values[3]) else None


def _repeats_itself(value, n, rng):
    return n > 1 and np.allclose(value[0], value[1])


DRAWS = (
    Property(
        "the same seed draws the same again",
        _unrepeatable,
        across=True,
        mistake=Mistake(
            "numpy.random is used instead of rng",
            "Draw with rng.random(n) or rng.uniform(...). A new default_rng() does not know the seed.",
        ),
    ),
    Property(
        "another seed draws something else",
        _unmoved,
        across=True,
        mistake=Mistake(
            "a generator of its own is made inside the function", "Use the rng that is passed in; do not make one."
        ),
    ),
    Property(
        "n draws are n different ones",
        lambda value, n, rng: not _repeats_itself(value, n, rng),
        where=lambda n, rng: n > 1,
        mistake=Mistake("one draw is repeated n times", "Draw n numbers for each angle, or draw inside the loop."),
    ),
)

ROTATIONS = Property(
    "every matrix is a rotation",
    lambda R, n, rng: np.abs(np.swapaxes(R, 1, 2) @ R - np.eye(3)).max() < 1e-9 and np.linalg.det(R).min() > 0,
    seen=lambda R, n, rng: (
        f"The determinants lie between {np.linalg.det(R).min():.3g} and {np.linalg.det(R).max():.3g}, the largest "
        f"entry of R^T R - I is {np.abs(np.swapaxes(R, 1, 2) @ R - np.eye(3)).max():.2g}."
    ),
    mistake=Mistake(
        "the matrices are not orthogonal",
        "Products of rotations with @ are rotations; sums of them, and products entry by entry (*), are not.",
    ),
)

TIED = Mistake(
    "the same draw serves for several of the three numbers", "Call rng once for each of them: they are independent."
)


def _against_even(values, low, high):
    from scipy.stats import kstest

    return kstest(values, "uniform", args=(low, high - low))


def even(values, low, high):
    """Whether the values are spread evenly from low to high."""
    return _against_even(values, low, high).pvalue > LEVEL


def nearly_even(values, low, high):
    """Whether they are but for a few percent, as an angle that goes many times round."""
    return _against_even(values, low, high).statistic < 0.05


def counts(columns, ranges, bins):
    """How many draws fall in each cell: columns holds one array for each coordinate."""
    return np.histogramdd(np.stack(columns, -1), bins=bins, range=ranges)[0]


def cells_p_value(columns, ranges, bins):
    """The chi-square p-value of coordinates that are to be even and independent."""
    from scipy.stats import chisquare

    return chisquare(counts(columns, ranges, bins).ravel()).pvalue


def gaps(values, low, high):
    """Whether part of the range from low to high is never drawn."""
    return (counts([values], [(low, high)], 12) == 0).any()


def tied(columns, ranges):
    """Whether two coordinates hang together: few pairs occur of those that could, from what each alone does."""

    def occupied(i, j):
        drawn = counts([columns[i], columns[j]], [ranges[i], ranges[j]], 24) > 0
        return drawn.sum() / (drawn.any(0).sum() * drawn.any(1).sum())

    return any(occupied(i, j) < 0.4 for i, j in itertools.combinations(range(len(columns)), 2))
