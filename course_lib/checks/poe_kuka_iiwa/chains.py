"""Arms to ask about: the KUKA iiwa 14 and others, as screw axes (omega, v), home pose M and joint angles theta."""

import functools
import itertools

import numpy as np

from course_lib.checks.exercise import Mistake, Property
from course_lib.checks.poe_kuka_iiwa.matrices import near
from course_lib.checks.rotations.exponential import unit
from course_lib.rigid import exp_se3, transform
from course_lib.rotations import exp_so3

X, Y, Z = np.eye(3)
KUKA_OMEGA = np.array([Z, Y, Z, -Y, Z, Y, Z])
KUKA_POINTS = np.outer([0, 0.36, 0.36, 0.78, 0.78, 1.18, 1.18], Z)
KUKA_HOME = transform(np.eye(3), 1.301 * Z)


def axes(omega, points):
    """The screw axes (n, 6) of joints about these directions through these points."""
    return np.concatenate([omega, np.cross(points, omega)], -1)


KUKA = axes(KUKA_OMEGA, KUKA_POINTS)
ONE = axes([Z], [0 * X])
TWO = axes([Z, Z], [0 * X, X])  # a planar arm with links of one metre
SHOULDER = axes([Z, Y], [0 * X, Z])
ELBOW = axes([Z, Y, Y], [0 * X, Z, X + Z])
WHOLE_ANGLES = np.array([1, 2, -1])
WHOLE = np.array([[0, 0, 1, 0, -1, 0], [1, 0, 0, 0, 2, 0], [0, 1, 0, 1, 0, 0]])
WHOLE_HOME = np.array([[0, -1, 0, 2], [1, 0, 0, 1], [0, 0, 1, 3], [0, 0, 0, 1]])


def at(*place):
    """A hand at this place, turned as the space frame."""
    return transform(np.eye(3), place)


def away_from_zero(rng, shape, low=0.3, high=1.4):
    """Numbers of either sign, to two digits, none of them small."""
    return np.round(rng.choice([-1, 1], shape) * rng.uniform(low, high, shape), 2)


def drawn_axes(rng, n):
    """Directions and points (n, 3) of axes that lie askew."""
    return np.array([unit(rng) for _ in range(n)]), away_from_zero(rng, (n, 3), 0.2, 1.0)


def turned_hand(rng):
    """A pose turned by an angle between 0.8 and 2.2."""
    return transform(exp_so3(rng.uniform(0.8, 2.2) * unit(rng)), away_from_zero(rng, 3, 0.4, 1.5))


def arms(rng, whole=()):
    """Cases (screws, M, theta), the simplest first. whole: those with arrays of whole numbers."""
    quarter = np.pi / 2
    hand = transform(exp_so3(quarter * X), [2.0, 0, 1])
    named = [
        (ONE, at(1, 0, 0), np.zeros(1)),
        (ONE, at(1, 0, 0), np.array([quarter])),
        (TWO, at(2, 0, 0), np.array([0, quarter])),
        (TWO, at(2, 0, 0), np.array([quarter, 0])),
        (TWO, at(2, 0, 0), np.array([0.5, -1.2])),
        (TWO, hand, np.zeros(2)),
        (TWO, hand, np.array([0.5, 0.8])),
        (SHOULDER, at(1, 0, 1), np.array([quarter, 0])),
        (SHOULDER, at(1, 0, 1), np.array([0.5, 0.8])),
        (ELBOW, at(2, 0, 1), np.array([0.5, 0.8, -1.2])),
        (KUKA, KUKA_HOME, np.zeros(7)),
        (KUKA, KUKA_HOME, np.array([0.3, -0.7, 1.1, 0.9, -0.4, 1.3, 0.6])),
    ]
    drawn = [(axes(*drawn_axes(rng, n)), turned_hand(rng), away_from_zero(rng, n)) for n in (1, 2, 3, 4, 5, 7)]
    screws, M, _ = drawn[2]
    far = [(screws, M, np.array([7.5, -9.25, 40.0])), (KUKA, KUKA_HOME, away_from_zero(rng, 7, 3.3, 6.0))]
    return [
        *named,
        *drawn,
        *far,
        *whole,
        (axes(*drawn_axes(rng, 6)), turned_hand(rng), away_from_zero(rng, 6)),
        named[4],
    ]


def whole_axes():
    """Cases with screw axes in whole numbers."""
    return [(WHOLE, at(2, 1, 0), np.array([0.5, 1.2, -0.7])), (WHOLE, at(2, 1, 0), WHOLE_ANGLES)]


def remembered(function):
    """A function of arrays that keeps its last results: the mistakes of an exercise all ask for the same ones."""

    @functools.lru_cache(maxsize=128)
    def again(*packed):
        return function(*(np.frombuffer(data).reshape(shape) for data, shape in packed))

    @functools.wraps(function)
    def ask(*arrays):
        return again(*((np.asarray(array, float).tobytes(), np.shape(array)) for array in arrays))

    return ask


@remembered
def turns(screws, theta):
    """exp([S1] theta1), ..., exp([Sn] thetan)."""
    return exp_se3(screws * theta[:, None])


def products(matrices):
    """The products of the first 0, 1, ..., n matrices."""
    return list(itertools.accumulate(matrices, np.matmul, initial=np.eye(4)))


def _first_otherwise(values, cases):
    """The position of the first case that was asked before and answered otherwise."""
    for (i, earlier), (j, later) in itertools.combinations(enumerate(cases), 2):
        if all(np.array_equal(a, b) for a, b in zip(earlier, later, strict=True)) and not near(values[j], values[i]):
            return j
    return None


SAME_TWICE = Property(
    "called a second time with the same arguments, the function gives the same result",
    _first_otherwise,
    across=True,
    mistake=Mistake(
        "something is kept from one call to the next",
        "A list outside the function, or a default like products=[], is made once only and grows or shrinks with "
        "each call. Make it inside the function.",
    ),
)


def whole_numbers(right):
    """The mistake of filling an array that holds whole numbers only. right(*arguments): the right answer."""
    name = "digits after the point are cut off"
    hint = (
        "np.zeros_like(a) and a.copy() hold whole numbers only where a does. np.zeros(np.shape(a)) has room for digits."
    )

    def whole(*case):
        return any(np.asarray(argument).dtype.kind == "i" for argument in case)

    return Mistake(name, hint, seen=lambda value, *case: whole(*case) and np.array_equal(value, np.trunc(value))), *(
        Mistake(
            name,
            hint,
            lambda *case, i=i: np.trunc(right(*case)) if np.asarray(case[i]).dtype.kind == "i" else None,
        )
        for i in range(2)
    )


def few_digits(right):
    """The mistake of an answer that is nearly right. right(*arguments): the right answer. To be thought of first."""

    def seen(value, *case):
        exact = right(*case)
        return np.abs(value - exact).max() <= 3e-3 * max(1, np.abs(exact).max())

    return Mistake(
        "the answer is right to its first digits only",
        "Compute with all digits: no np.round, no small steps in place of a derivative, and pi is np.pi.",
        seen=seen,
    )
