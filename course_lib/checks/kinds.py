"""Kinds of arguments. Each knows its ordinary values, its special ones, and what lies beside these.

An exercise says of which kind each argument is, and its cases follow; see declared.py. An answer
that is wrong only in a corner of a kind, such as beyond ten radians, is then refused in every
exercise that has an argument of this kind.
"""

import itertools
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from course_lib.checks.special_cases import BESIDE, ON_BOTH_SIDES, SMALL, Sweep
from course_lib.checks.vocabulary import (
    any_pose,
    any_rotation,
    away_from_zero,
    pose,
    two_link_tip,
    unit,
)
from course_lib.checks.wire import Seed
from course_lib.rigid import transform
from course_lib.rotations import exp_so3, hat, random_quaternions, rot_x, rot_y, rot_z

QUARTER = np.pi / 2
# Of rotation vectors, from the lengths that somebody takes for 0 to several revolutions. The series
# of the exponential with thirty terms is wrong from ten radians on.
_TINY = (3.1e-4, 9e-5, 1e-5, 1e-9, 1e-12)
_ORDINARY = (0.5, 2.0, np.pi, 5.0)
_FAR = (12.0, 41.7, 200.0)
_SECRET_DRAWS = 4  # ordinary cases, all of whose numbers depend on the seed
_ON_THE_GRID = 0.7  # of the special values of an argument; the others are its named ones


@dataclass(frozen=True)
class Kind:
    """What an argument is.

    Attributes
    ----------
    drawn : callable
        drawn(rng): an ordinary value, far from all that is special.
    named : callable
        named(rng): a list of values, the simplest first, then the special ones.
    beside : tuple of (str, callable, tuple of float)
        What is special, value(rng, gap) beside it, and the gaps.
    beside_another : tuple of (str, callable, tuple of float)
        Of two arguments that are drawn alike: what is special of them together, value(rng, other,
        gap) of the second one beside this, and the gaps.
    coarse : callable, optional
        coarse(rng): a value on a coarse grid, of whole numbers from -2 to 2 or of quarters of a
        revolution. There coincidences are usual: a sum or a sine that is 0, two equal entries, or
        opposite directions, by which an answer may know a special case.
    angle : bool
        Whether it may exceed one revolution.
    small : bool
        Whether it may hold small numbers, which somebody may take for 0.
    free : bool
        Whether it does not depend on the other arguments.
    """

    drawn: Callable
    named: Callable = lambda rng: []
    beside: tuple[tuple[str, Callable, tuple[float, ...]], ...] = ()
    beside_another: tuple[tuple[str, Callable, tuple[float, ...]], ...] = ()
    coarse: Callable | None = None
    angle: bool = False
    small: bool = False
    free: bool = True

    def special(self, rng):
        """Return a value on the coarse grid, or, now and then, one of those that are named."""
        named = self.named(rng)
        if self.coarse is not None and (not named or rng.random() < _ON_THE_GRID):
            return self.coarse(rng)
        return named[rng.integers(len(named))] if named else self.drawn(rng)

    def but(self, **changed):
        """Return the same with some attributes changed."""
        return replace(self, **changed)


def cases_of(kinds, rng):
    """Return cases: each named value of each argument among ordinary others, and ordinary ones."""
    named = [kind.named(rng) for kind in kinds]
    simplest = []
    for kind, values in zip(kinds, named, strict=True):
        simplest.append(values[0] if values else kind.drawn(rng))
    cases = [tuple(simplest)]
    for k, values in enumerate(named):
        for value in values[len(kinds) == 1 :]:  # alone, the simplest one has been asked
            cases.append(_among_ordinary(kinds, rng, k, value))
    return cases + [tuple(kind.drawn(rng) for kind in kinds) for _ in range(_SECRET_DRAWS)]


def sweeps_of(kinds):
    """Return the sweeps: beside each special value of each argument, and beside what is special of
    two arguments that are drawn alike, among ordinary others."""
    of_one = [_sweep(kinds, k, *beside) for k, kind in enumerate(kinds) for beside in kind.beside]
    alike = [
        (first, second)
        for first, second in itertools.combinations(range(len(kinds)), 2)
        if kinds[first].drawn is kinds[second].drawn
    ]
    of_two = [
        _sweep_of_two(kinds, *pair, *beside)
        for pair in alike
        for beside in kinds[pair[0]].beside_another
    ]
    return (*of_one, *of_two)


def special_case(kinds, rng):
    """Return a case whose arguments are all special at once."""
    return tuple(kind.special(rng) for kind in kinds)


def _sweep(kinds, k, what, value, gaps):
    return Sweep(what, lambda rng, gap: _among_ordinary(kinds, rng, k, value(rng, gap)), gaps)


def _sweep_of_two(kinds, first, second, what, value, gaps):
    def case(rng, gap):
        arguments = [kind.drawn(rng) for kind in kinds]
        arguments[second] = value(rng, arguments[first], gap)
        return tuple(arguments)

    return Sweep(what, case, gaps)


def _among_ordinary(kinds, rng, k, value):
    """Return a case whose argument k is this value."""
    others = [kind.drawn(rng) for kind in kinds]
    return (*others[:k], value, *others[k + 1 :])


# ---- on a coarse grid ----


def whole_numbers(rng, shape=()):
    """Return numbers from -2 to 2, any of them 0, and any two of them equal or opposite."""
    return rng.integers(-2, 3, shape).astype(float)


def some_equal(rng, rows):
    """Return rows drawn from these, in any order, so that some occur twice."""
    return rows[rng.integers(len(rows), size=len(rows))]


def quarters(rng, shape=()):
    """Return angles of some quarters of a revolution, up to one revolution."""
    return QUARTER * rng.integers(-4, 5, shape)


def eighths(rng, shape=()):
    """Return angles of some eighths of a revolution, up to two revolutions."""
    return QUARTER / 2 * rng.integers(-16, 17, shape)


def tip_on_the_grid(rng):
    """Return a position (2,) for an arm with two links of one metre: at the edge of its reach, one
    that angles of some eighths of a revolution lead to, or whole numbers."""
    direction = rng.uniform(-np.pi, np.pi)
    at_the_edge = 2 * np.array([np.cos(direction), np.sin(direction)])
    tips = at_the_edge, two_link_tip(eighths(rng, 2)), whole_numbers(rng, 2)
    return tips[rng.integers(len(tips))]


def _turns_of_a_cube():
    """Return the 24 rotations whose matrices hold 0, 1 and -1 only."""
    signed = [
        np.eye(3)[list(order)] * signs
        for order in itertools.permutations(range(3))
        for signs in itertools.product((1.0, -1.0), repeat=3)
    ]
    return [R + 0.0 for R in signed if np.linalg.det(R) > 0]


TURNS_OF_A_CUBE = _turns_of_a_cube()


def coarse_axis(rng):
    """Return a unit vector (3,) along an axis, or between two or three axes."""
    signs = np.zeros(3)
    while not signs.any():
        signs = rng.integers(-1, 2, 3)
    return signs / np.linalg.norm(signs)


def coarse_rotation(rng):
    """Return a rotation of a cube onto itself, or now and then one by an eighth of a revolution
    more."""
    R = TURNS_OF_A_CUBE[rng.integers(len(TURNS_OF_A_CUBE))]
    if rng.random() < _ON_THE_GRID:
        return R
    return R @ (rot_x, rot_y, rot_z)[rng.integers(3)](QUARTER / 2)


def coarse_pose(rng):
    """Return a pose with a coarse rotation, and whole numbers from -2 to 2 for its position."""
    return transform(coarse_rotation(rng), whole_numbers(rng, 3))


# ---- rotations ----


def leaning_axis(rng):
    """Return a unit vector (3,) far from the coordinate planes, with any signs."""
    sizes = rng.uniform(0.45, 0.69, 3)
    return sizes / np.linalg.norm(sizes) * rng.choice([-1, 1], 3)


def _rotation_vectors(rng):
    quarters = QUARTER * np.eye(3)[::-1]
    whole = np.array([1.0, -2.0, 2.0])  # whose unit vector is not whole
    lengths = (*_ORDINARY, *_TINY, *_FAR)
    drawn = [length * unit(rng) for length in lengths]
    return [*quarters, *-np.eye(3), whole, *drawn, np.zeros(3)]


ROTATION_VECTOR = Kind(
    drawn=lambda rng: rng.uniform(0.5, 2.5) * unit(rng),
    named=_rotation_vectors,
    beside=(
        ("a tiny angle", lambda rng, gap: gap * unit(rng), BESIDE),
        ("an angle near pi", lambda rng, gap: (np.pi - gap) * unit(rng), ON_BOTH_SIDES),
        ("a length near 1", lambda rng, gap: (1 + gap) * unit(rng), SMALL),
    ),
    coarse=lambda rng: quarters(rng) * coarse_axis(rng),
)


def half_turn(axis):
    """Return the rotation by pi about a unit vector, exactly symmetric."""
    return 2 * np.outer(axis, axis) - np.eye(3)


def half_turns(rng):
    """Return rotations by pi: about the axes, about axes in the coordinate planes, those halfway
    between two axes included, and about any axis. They are as exact as they can be, and as they
    come from a sine of pi, which is 1.2e-16."""
    slope = rng.uniform(0.5, 0.7)
    in_a_plane = np.array([0, np.sin(slope), -np.cos(slope)])
    axes = [*np.eye(3), *(np.roll(in_a_plane, k) for k in range(3)), leaning_axis(rng)]
    opposite = [-axis for axis in axes]
    return [
        *map(half_turn, axes),
        *_half_turns_halfway_between_axes(),
        *(exp_so3(np.pi * axis) for axis in (*axes, *opposite)),
        rot_x(np.pi),
        rot_y(np.pi),
        rot_z(np.pi),
    ]


def _half_turns_halfway_between_axes():
    """Return rotations by pi that exchange two axes, or exchange and reverse them.

    The two largest entries on the diagonal are equal. If the axes are reversed, each column of
    R + I adds up to 0.
    """
    exchanges = [np.eye(3)[order] for order in ([0, 2, 1], [2, 1, 0], [1, 0, 2])]
    return [half for P in exchanges for half in (P - 2 * np.diag(np.diag(P)), 0 - P)]


def _half_turns_nearly_about_the_axes():
    """Return rotations by pi about axes with one entry of 1, to rounding, one small one and a 0.

    The square of the small entry is 1e-14. So a comparison of two entries on the diagonal finds the
    small one larger than 0, but its root has lost its digits.
    """
    small = 1e-7 * (1 - np.eye(3))
    pairs = itertools.permutations(range(3), 2)
    return [half_turn(np.eye(3)[i] + small[i, j] * np.eye(3)[j]) for i, j in pairs]


def _rounded_rotations():
    """Return rotations as products come out: a trace beyond its bounds, a half turn that is not
    quite symmetric."""
    up, short, down = 1 + 2.0**-50, 1 - 2.0**-53, -1 - 2.0**-52
    return [
        up * np.eye(3),
        short * np.eye(3),
        np.diag([1.0, down, down]) + 2.0**-52 * hat([1.0, 0, 0]),
        *(_rounded_near_pi(axis) for axis in np.array([[6.0, 6, 7], [-6, 7, 6], [2, 3, -6]])),
    ]


def _rounded_near_pi(axis):
    """Return a rotation by pi - 1.05e-12 about an axis (3,), whose skew part has lost digits: its
    direction is off by 3e-4, and its entries by 3e-16."""
    n = axis / np.linalg.norm(axis)
    across = np.cross(n, [1.0, 0, 0])
    return half_turn(n) + 1.05e-12 * hat(n + 3e-4 * across / np.linalg.norm(across))


def _rotations(rng):
    quarters = [rot_x(QUARTER), rot_y(QUARTER), rot_z(QUARTER)]
    drawn = [exp_so3(angle * unit(rng)) for angle in (QUARTER, 0.5, 2.0, *_TINY)]
    axis = leaning_axis(rng)  # whichever column of R + I is taken
    # By a third of a revolution: whole numbers, half of whose skew part is not whole.
    third = np.array([[0.0, 0, -1], [1, 0, 0], [0, -1, 0]])
    nearly_half = [np.pi - gap for gap in (0.14, 3.1e-4, 1e-5, 1e-9)]
    near = [exp_so3(sign * angle * axis) for angle in nearly_half for sign in (1, -1)]
    half = [*half_turns(rng), *_half_turns_nearly_about_the_axes()]
    return [*quarters, third, *drawn, *near, *half, np.eye(3), *_rounded_rotations()]


def _just_below_pi(rng, gap):
    return exp_so3((np.pi - abs(gap)) * np.sign(gap) * leaning_axis(rng))


_APART = (0.0, 1e-8, 1e-4)  # radians


def _half_a_revolution_from(rng, R, gap):
    return R @ exp_so3((np.pi - gap) * leaning_axis(rng))


def _with_a_half_turn(rng, R, gap):
    """Return the rotation whose product with R is a rotation by nearly pi."""
    return _half_a_revolution_from(rng, R.T, gap)


def _locked_with(rng, R, gap):
    """Return a rotation whose roll, pitch and yaw relative to R are nearly at gimbal lock."""
    yaw, roll = rng.uniform(0.3, 1.2, 2)
    return R @ rot_z(yaw) @ rot_y(QUARTER - gap) @ rot_x(roll)


ROTATION = Kind(
    drawn=any_rotation,
    named=_rotations,
    beside=(
        ("a tiny angle", lambda rng, gap: exp_so3(gap * unit(rng)), BESIDE),
        ("an angle just below pi", _just_below_pi, ON_BOTH_SIDES),
    ),
    beside_another=(
        ("half a revolution apart", _half_a_revolution_from, _APART),
        ("of which the product is half a revolution", _with_a_half_turn, _APART),
        ("a pitch of a quarter apart", _locked_with, _APART),
    ),
    coarse=coarse_rotation,
    small=True,
)


# In a product, which answers by quaternions or angles may form: half a revolution is special.
FACTOR = ROTATION.but(
    named=lambda rng: [rot_z(QUARTER), rot_x(np.pi), half_turn(leaning_axis(rng))], beside=()
)


_SIGNS = np.array(np.meshgrid(*[[0.5, -0.5]] * 4)).reshape(4, -1).T  # unit quaternions


def _quaternions(rng):
    axes = np.eye(4)
    turned = [np.array([0.8, 0.6, 0, 0]), np.array([0.6, 0, -0.8, 0]), np.array([-0.8, 0, 0, 0.6])]
    of_length_one = [np.array([-0.5, 0.1, 0.7, -0.5]), np.array([0.5, -0.1, -0.5, -0.7])]
    drawn = [v / np.linalg.norm(v) for v in rng.normal(size=(3, 4))]
    return [*turned, *of_length_one, *axes, *-axes, *_SIGNS[::5], *drawn]


def _small_quaternion(rng, gap):
    """Return the quaternion of a rotation by a tiny angle, or, with a negative gap, its
    negative."""
    half = abs(gap) / 2
    return np.sign(gap) * np.append(np.cos(half), np.sin(half) * unit(rng))


def _half_turn_quaternion(rng, gap):
    """Return the quaternion of a rotation by nearly pi: w is nearly 0."""
    return np.append(np.sin(gap / 2), np.cos(gap / 2) * unit(rng))


def _coarse_quaternion(rng):
    """Return a unit quaternion with one, two or four entries other than 0, equal or opposite."""
    nonzero = rng.permutation(4) < (1, 2, 4)[rng.integers(3)]
    entries = np.where(nonzero, rng.choice([-1.0, 1.0], 4), 0.0)
    return entries / np.linalg.norm(entries)


QUATERNION = Kind(
    drawn=lambda rng: random_quaternions(1, rng)[0],
    named=_quaternions,
    beside=(
        ("a tiny rotation", _small_quaternion, ON_BOTH_SIDES),
        ("a rotation by nearly pi", _half_turn_quaternion, ON_BOTH_SIDES),
    ),
    coarse=_coarse_quaternion,
)


# ---- poses ----


def _poses(rng):
    far = np.array([1.0, 2, 3])
    turned = [pose(rot(QUARTER), far) for rot in (rot_z, rot_x, rot_y)]
    distant = any_pose(rng)
    distant[:3, 3] *= 100
    # Formulas by quaternions divide by 0 there, or by roll, pitch and yaw.
    half = transform(half_turn(leaning_axis(rng)), away_from_zero(rng, 3))
    pitched = np.array([[0.0, 0, -1], [0, 1, 0], [1, 0, 0]])  # by exactly 90 degrees
    upright = transform(rot_z(0.7) @ pitched, away_from_zero(rng, 3))
    return [
        *turned,
        distant,
        half,
        upright,
        pose(np.eye(3), far),
        pose(rot_z(QUARTER), 0 * far),
        np.eye(4),
    ]


def _near_identity(rng, size):
    return transform(exp_so3(size * unit(rng)), size * away_from_zero(rng, 3))


POSE = Kind(
    drawn=any_pose,
    named=_poses,
    beside=(("nearly the identity", _near_identity, SMALL),),
    coarse=coarse_pose,
    small=True,
)


# ---- numbers, vectors, words ----


def vector(n=3, **more):
    """Return the Kind of vectors (n,) whose entries are not small.

    One named value holds whole numbers, one holds them in its first half only, and one is 0.
    """
    whole = np.arange(1.0, n + 1)
    partly_whole = np.where(np.arange(n) < max(1, n // 2), 2 * whole, whole / 4 + 0.1)
    return Kind(
        drawn=lambda rng: away_from_zero(rng, n),
        named=lambda rng: [whole, partly_whole, np.zeros(n)],
        coarse=lambda rng: whole_numbers(rng, n),
        **more,
    )


def nearly_unit_omega(rng, gap):
    """Return a twist (6,) whose omega is nearly of length one, as that of a screw axis is."""
    return np.append((1 + gap) * unit(rng), away_from_zero(rng, 3))


TWIST = vector(6, beside=(("an omega nearly of length one", nearly_unit_omega, SMALL),))


def _nearly_quarter(rng, gap):
    return rng.choice([-1, 1]) * (QUARTER + gap)


ANGLE = Kind(
    drawn=lambda rng: float(np.round(rng.choice([-1, 1]) * rng.uniform(0.6, 2.5), 2)),
    named=lambda rng: [QUARTER, -QUARTER, np.pi, 0.0, 0.3, -2.7, 6.9, -12.0, 41.7, -200.0],
    beside=(
        ("a tiny angle", lambda rng, gap: gap, ON_BOTH_SIDES),
        ("nearly a quarter of a revolution", _nearly_quarter, SMALL),
    ),
    coarse=lambda rng: float(eighths(rng)),
    angle=True,
    small=True,
)


# Of a row of a Denavit-Hartenberg table: of either sign, also 0.
LENGTH = Kind(
    drawn=lambda rng: float(away_from_zero(rng, ())),
    named=lambda rng: [0.5, 2.0, -0.0825, 0.0],
    coarse=lambda rng: float(whole_numbers(rng)),
    small=True,
)


def joint_angles(n, **more):
    """Return the Kind of the angles (n,) of an arm's joints: of either sign, below and above 90 and
    180 degrees, several revolutions, in whole numbers too, and 0 of some joints or of all."""

    def named(rng):
        obtuse = away_from_zero(rng, n, 1.7, 3.0)
        reflex = away_from_zero(rng, n, 3.3, 6.0)
        some_still = np.where(np.arange(n) % 2, 0.0, away_from_zero(rng, n))
        whole = np.arange(1.0, n + 1)
        far = (whole + 7) * np.where(np.arange(n) % 2, -1, 1)
        return [away_from_zero(rng, n), obtuse, reflex, whole, far, some_still, np.zeros(n)]

    return Kind(
        drawn=lambda rng: away_from_zero(rng, n),
        named=named,
        coarse=lambda rng: quarters(rng, n),
        angle=True,
        **more,
    )


def number(low, high, *named, **more):
    """Return the Kind of numbers between two bounds; `named` are asked, too, the simplest first."""
    return Kind(
        drawn=lambda rng: float(np.round(rng.uniform(low, high), 2)),
        named=lambda rng: list(named),
        beside_another=(("two nearly equal numbers", lambda rng, other, gap: other + gap, SMALL),),
        **more,
    )


def one_of(*words):
    """Return the Kind of arguments that are one of a few words."""
    return Kind(drawn=lambda rng: words[rng.integers(len(words))], named=lambda rng: list(words))


def table(rows, columns, **more):
    """Return the Kind of tables (rows, columns) of numbers that are not small.

    One named value holds whole numbers; in one the first row does, and no other.
    """
    whole = np.arange(1.0, rows * columns + 1).reshape(rows, columns)
    partly_whole = np.where(np.arange(rows)[:, None] == 0, whole, whole / 8)
    return Kind(
        drawn=lambda rng: away_from_zero(rng, (rows, columns)),
        named=lambda rng: [whole, partly_whole],
        coarse=lambda rng: whole_numbers(rng, (rows, columns)),
        **more,
    )


GENERATOR = Kind(
    drawn=lambda rng: Seed(int(rng.integers(2**31))), named=lambda rng: [Seed(0), Seed(1)]
)


# Of an argument whose cases the exercise makes itself, because it depends on the other arguments.
OWN_CASES = Kind(drawn=lambda rng: None, free=False)
