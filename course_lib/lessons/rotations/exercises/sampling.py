"""What the checks of random rotations share: they judge by what is drawn, not by how."""

import itertools

import numpy as np

from course_lib.checks.comparisons import attempt
from course_lib.checks.exercise import Property
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import SameGenerator
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import no_rotation
from course_lib.checks.wire import Seed

LEVEL = 1e-6  # each test rejects a right sampler for one seed in a million
MANY = 20_000
SEVERAL = 2_000  # of two seeds, which are compared
# Calls for one draw. A sampler that draws some candidates and rejects most of them now and then has
# none left: if it happens in one call of twenty, it is missed in 200 calls once in 30,000 times.
_SINGLE = 200
CIRCLE = (-np.pi, np.pi)
_EDGES = range(0, 181, 30)  # degrees: of the intervals in which messages count rotation angles


def cases(rng):
    """Return the arguments of a sampler: a few draws, the same again, others, others from the same
    generator, one draw of each of many seeds, many draws, and several of two seeds."""
    first, second, third, *two = (Seed(int(s)) for s in rng.integers(2**31, size=5))
    few = [(3, first), (3, first), (3, second), SameGenerator((3, second)), (1, first)]
    single = [(1, Seed(int(s))) for s in rng.integers(2**31, size=_SINGLE)]
    return [*few, *single, (MANY, third), *((SEVERAL, seed) for seed in two)]


def many(n, rng):
    """Return whether this is the case of many draws, which the tests of a distribution need."""
    return n == MANY


def of_many(seen):
    """Return a Mistake's seen(value, n, rng) that looks at the case of many draws only."""
    return lambda value, n, rng: n == MANY and bool(seen(value))


def _pair(first, second, is_wrong):
    """Return the holds(values, cases) of two answers, by their positions, that must not be wrong
    together; it holds if the second is not there."""

    def position(values, cases):
        is_there = second < len(values)
        return second if is_there and is_wrong(values[first], values[second]) else None

    return position


def _have_a_common_draw(some, others):
    """Return whether a draw, or its negative, is among the others in the same place."""
    pairs = zip(some, others, strict=True)
    return any(np.allclose(a, b) or np.allclose(a, -b) for a, b in pairs)


DRAWS = (
    Property(
        "the same seed draws the same again",
        _pair(0, 1, lambda once, again: not np.array_equal(once, again)),
        across=True,
        otherwise=Question(
            "the numbers do not come from rng",
            "Which of your numbers do not come from the rng passed in, or stay from the call "
            "before? Neither numpy.random nor a new generator knows the seed.",
        ),
    ),
    Property(
        "another seed draws something else",
        _pair(0, 2, np.allclose),
        across=True,
        otherwise=Question(
            "a generator is made inside the function",
            "Which of your numbers come from the rng that is passed in?",
        ),
    ),
    Property(
        "with another seed each of the n draws is another one",
        _pair(0, 2, _have_a_common_draw),
        across=True,
        otherwise=Question(
            "a draw is the same for every seed",
            "Which of the n is it? Each of them needs numbers from the rng that is passed in.",
        ),
    ),
    Property(
        "called again with the same generator, it draws others",
        _pair(2, 3, np.allclose),
        across=True,
        otherwise=Question(
            "the generator that is passed in does not advance",
            "A generator is meant to change with each draw. From where do the numbers of your "
            "function come, and has the generator that is passed in changed afterwards?",
        ),
    ),
    Property(
        "n draws are n different ones",
        lambda value, n, rng: n < 2 or not np.allclose(value[0], value[1]),
        otherwise=Question(
            "one draw is repeated n times",
            "Each of the n needs numbers of its own. How many does your code draw, and when?",
        ),
    ),
)


def _values_between(draws, i, j):
    """Return how many directions the numbers i and j of each draw have, seen as coordinates."""
    flat = draws.reshape(len(draws), -1)
    return len(np.unique(np.arctan2(flat[:, i], flat[:, j]).round(9)))


def _of_few_values(draws):
    """Return whether two numbers of each draw come from an angle that takes few values, such as
    whole degrees."""
    some = draws[:SEVERAL]
    pairs = itertools.combinations(range(some[0].size), 2)
    return any(_values_between(some, i, j) < len(some) / 2 for i, j in pairs)


CONTINUOUS = Property(
    "each angle may be any number in its range",
    lambda value, n, rng: not _of_few_values(value),
    where=many,
    otherwise=Question(
        "an angle, or another number, takes few values only",
        "Print some of your random numbers with all their digits. Which function of rng draws "
        "numbers from a whole range, and not whole numbers?",
    ),
)


def _are_rotations(R):
    """Return for each of many matrices (n, 3, 3) whether it is a rotation, to rounding."""
    errors = np.abs(np.swapaxes(R, 1, 2) @ R - np.eye(3)).max((1, 2))
    return (errors < EXACT) & (np.linalg.det(R) > 0)


ROTATIONS = Property(
    "every matrix is a rotation",
    lambda R, n, rng: _are_rotations(R).all(),
    says=lambda R, n, rng: no_rotation(R[np.argmin(_are_rotations(R))]),
    otherwise=Question(
        "the matrices are not orthogonal",
        "From which matrices does your code make each one, and by which operation? Matrix products "
        "of rotations are rotations; their sums, and products entry by entry (*), are not.",
    ),
)


def uniform(values, low, high):
    """Return whether the values are uniformly distributed from low to high."""
    from scipy.stats import kstest

    return kstest(values, "uniform", args=(low, high - low), method="asymp").pvalue > LEVEL


def _counts(columns, ranges, bins):
    """Return how many draws fall in each cell: columns holds one array for each coordinate."""
    return np.histogramdd(np.stack(columns, -1), bins=bins, range=ranges)[0]


def cells_p_value(columns, ranges, bins):
    """Return the chi-square p-value of coordinates that are to be uniform and independent."""
    from scipy.stats import chisquare

    return chisquare(_counts(columns, ranges, bins).ravel()).pvalue


def angles_of(R):
    """Return the rotation angles (n,) of R (n, 3, 3), between 0 and pi."""
    return np.arccos(np.clip((np.trace(R, axis1=1, axis2=2) - 1) / 2, -1, 1))


def angle_p_value(R):
    """Return the Kolmogorov-Smirnov p-value of the rotation angles against their density (1 - cos
    a)/pi."""
    from scipy.stats import kstest

    return kstest(angles_of(R), lambda a: (a - np.sin(a)) / np.pi, method="asymp").pvalue


def _shares_of_angles(R):
    """Return which shares of the rotation angles lie between multiples of 30 degrees, and which
    should."""
    edges = np.radians(_EDGES)
    counts, _ = np.histogram(angles_of(R), edges)
    return counts / len(R), np.diff(edges - np.sin(edges)) / np.pi


def _between(k):
    return f"between {_EDGES[k]} and {_EDGES[k + 1]} degrees"


# Standard deviations by which the share of an interval is off: chance explains 4 once in 3,000
# samples with six intervals.
_MIN_DEVIATIONS = 4


def _off_most(R):
    """Return the numbers of the intervals whose angles come too often and too rarely, by the most
    standard deviations; None if no interval is off by more than chance explains."""
    shares, right = _shares_of_angles(R)
    deviations = (shares - right) * np.sqrt(len(R) / right)
    if np.abs(deviations).max() < _MIN_DEVIATIONS:
        return None
    return int(np.argmax(deviations)), int(np.argmin(deviations))


def _tell_angles(R):
    if _off_most(R) is None:
        return "Within an interval of 30 degrees, some of your angles come too often."
    shares, right = _shares_of_angles(R)
    often, rarely = (
        f"{100 * shares[k]:.1f} % of your angles lie {_between(k)}, where {100 * right[k]:.1f} % "
        "should."
        for k in _off_most(R)
    )
    return f"{often} {rarely}"


def _other_angles(R):
    intervals = _off_most(R)
    if intervals is None:
        name = "within intervals of 30 degrees, some rotation angles come too often"
    else:
        often, rarely = map(_between, intervals)
        name = f"rotation angles {often} come too often, and those {rarely} too rarely"
    return Mistake(
        name,
        "Compare the histogram of your angles with (1 - cos a)/pi. Which random numbers decide the "
        "angle? Do they have the right distribution, are they drawn anew for each of the n, and "
        "does each later step, such as a change of sign, keep the distribution uniform?",
    )


def axis_p_value(R, axis):
    """Return the chi-square p-value of where e_axis lands, counted in 10 x 12 cells of equal
    area."""
    from scipy.stats import chisquare

    return chisquare(_images(R, axis)).pvalue


def _images(R, axis):
    """Return how often e_axis lands in each of 10 x 12 cells of equal area."""
    x, y, z = R[:, :, axis].T
    counts, _, _ = np.histogram2d(
        z, np.arctan2(y, x), bins=[10, 12], range=[[-1, 1], [-np.pi, np.pi]]
    )
    return counts.ravel()


def _tell_images(R, axis):
    counts = _images(R, axis)
    return (
        f"Of {counts.size} cells of equal area on the sphere, each should hold about "
        f"{counts.mean():.0f} of the images. In yours the counts go from {counts.min():.0f} to "
        f"{counts.max():.0f}."
    )


def trace_p_value(R):
    """Return the p-value of the mean of tr(R)^2, which has mean 1 and variance 2 for uniform R."""
    from scipy.stats import norm

    return 2 * norm.sf(abs(_mean_of_squares(R) - 1) / np.sqrt(2 / len(R)))


def _mean_of_squares(R):
    return np.mean(np.trace(R, axis1=1, axis2=2) ** 2)


ARVO_RANGES = [(0, 1), CIRCLE, CIRCLE]


def arvo(R):
    """Return (z, phi, theta) of R = (2 V V^T - I) Rz(theta): for uniform rotations uniform and
    independent."""
    x, y, z = R[:, 0, 2], R[:, 1, 2], np.clip((1 - R[:, 2, 2]) / 2, 0, 1)
    phi = np.arctan2(y, x)
    V = np.stack([np.cos(phi) * np.sqrt(z), np.sin(phi) * np.sqrt(z), np.sqrt(1 - z)], -1)
    image = 2 * V * (V * R[:, :, 0]).sum(-1, keepdims=True) - R[:, :, 0]  # of e_x under Rz(theta)
    return z, phi, np.arctan2(image[:, 1], image[:, 0])


_CROWDED = Question(
    "the rotations crowd in some directions, or leave some out",
    "Draw where the axes land. Does each random number cover its whole range, is it drawn anew "
    "for each of the n, and is it independent of the others?",
)


def _p_value_between(one, other):
    """Return the least p-value of the rotations from draws to others, which are uniform, too, if
    the draws are independent."""
    back = np.swapaxes(one, 1, 2)
    between = back @ other, other @ back
    images = [axis_p_value(R, axis) for R in between for axis in range(3)]
    return min(angle_p_value(between[0]), *images)


def _depends_on_the_other_seed(matrices):
    """Return the holds(values, cases) of draws of two seeds that are independent."""

    def position(values, cases):
        one, other = (attempt(matrices, value) for value in values[-2:])
        p_value = attempt(_p_value_between, one, other)  # None for what are no rotations
        return len(values) - 1 if p_value is not None and p_value <= LEVEL else None

    return position


def uniform_rotations(matrices):
    """Return the properties of uniform rotations; matrices(value): the rotations of an answer."""
    return (
        CONTINUOUS,
        Property(
            "the angles follow the density (1 - cos a)/pi",
            lambda value, n, rng: angle_p_value(matrices(value)) > LEVEL,
            says=lambda value, n, rng: _tell_angles(matrices(value)),
            where=many,
            otherwise=lambda value, n, rng: _other_angles(matrices(value)),
        ),
        *(
            Property(
                f"the images of e_{name} are uniform on the sphere",
                lambda value, n, rng, axis=axis: axis_p_value(matrices(value), axis) > LEVEL,
                says=lambda value, n, rng, axis=axis: _tell_images(matrices(value), axis),
                where=many,
                otherwise=_CROWDED,
            )
            for axis, name in enumerate("xyz")
        ),
        Property(
            "the mean of tr(R)^2 is 1",
            lambda value, n, rng: trace_p_value(matrices(value)) > LEVEL,
            says=lambda value, n, rng: f"In yours it is {_mean_of_squares(matrices(value)):.3f}.",
            where=many,
        ),
        Property(
            "where e_z lands is independent of the rotation about it",
            lambda value, n, rng: cells_p_value(arvo(matrices(value)), ARVO_RANGES, 6) > LEVEL,
            where=many,
        ),
        Property(
            "draws of two seeds are independent",
            _depends_on_the_other_seed(matrices),
            across=True,
            otherwise=Question(
                "some of the numbers do not come from rng",
                "Does another generator, or a number that is always the same, decide a part of "
                "each rotation? Every random number comes from the rng passed in.",
            ),
        ),
    )


LIBRARY_SAMPLERS = (
    "course_lib.rotations.random_rotations",
    "course_lib.rotations.random_quaternions",
    "scipy.spatial.transform.Rotation",
    "scipy.stats.special_ortho_group",
)
