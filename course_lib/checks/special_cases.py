"""Cases that the engine makes of what an exercise says of its arguments.

Wrong answers hide between the cases that an author thinks of: an answer may be right at pi and at
pi - 1e-9 and wrong between the two, or right for floats and wrong for whole numbers. An exercise
names its special values (`Sweep`) and its angles; the rest the engine does for every exercise.
"""

import itertools
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from course_lib.checks.comparisons import attempt
from course_lib.checks.tolerances import EXACT
from course_lib.checks.wire import write
from course_lib.rigid import adjoint
from course_lib.rotations import exp_so3, is_so

_MAX_WHOLE = 4  # cases repeated with whole numbers in their arrays
_MAX_ZEROS = 2  # cases repeated with -0.0 in place of 0.0
_ROUNDING = 1e-12  # 6e-17, the cosine of pi/2, is taken for 0
_MAX_WHOLE_NUMBER = 1e6
# Cases of special arguments, and how many of them come rounded, too, and as integers.
_SPECIAL, _ROUNDED, _INTEGERS = 40, 20, 10
# By so much numbers are off that are nearly special: a tolerance of np.isclose, or a wider one.
_OFF_BY = (3e-3, 3e-4, 3e-5, 3e-6, 3e-7, 3e-8)
_LAST_BIT = 2.0**-53  # of numbers near 1

# From 0.3 down to the rounding of numbers near 1, four to a power of ten. Whoever changes formulas
# near a special value does so at a round number, 1, 2, 3 or 5 times a power of ten, and the error
# of the wrong formula is largest just inside it, whatever power of the distance it grows with.
_DIGITS = (9.9, 4.9, 2.9, 1.9)
BESIDE = tuple(float(f"{digit}e-{k}") for k in range(1, 17) for digit in _DIGITS)[2:]
ON_BOTH_SIDES = tuple(sign * gap for gap in BESIDE for sign in (1, -1))
# Sizes of numbers that somebody may take for 0, and whose loss shows in answers right to EXACT.
SMALL = tuple(size for size in BESIDE if size > EXACT)
OUT_OF_REACH = (1e-6, 1e-3, 0.02, 0.1)  # relative to the reach: what a too generous bound lets pass
# Relative to the reach: two solutions are apart by the root of this, at least by 1e-4 rad.
JUST_WITHIN = tuple(gap for gap in BESIDE if gap > 5 * EXACT)
SIZES = (1, 2, 3, 7, 9)  # 9: more than an arm has joints
REVOLUTIONS = (2, 16)  # by which angles are changed: a series of thirty terms ends between these
# Of the numbers in arguments that may be small. The numbers are between 0.3 and 0.9 of these, so
# that each threshold below which somebody takes a number for 0 has numbers beneath it that count.
SMALL_NUMBERS = tuple(float(f"1e-{k}") for k in range(2, 9))


@dataclass(frozen=True)
class Sweep:
    """Cases beside a special value of the arguments, or of different sizes.

    Parameters
    ----------
    what : str
        What is special, for authors: "a rotation by nearly pi".
    case : callable
        case(rng, value): the arguments of one case, whose distance from what is special, or whose
        size, is the value; None where there is no such case.
    values : tuple of float, optional
        BESIDE, ON_BOTH_SIDES, SMALL, OUT_OF_REACH, JUST_WITHIN, SIZES, or others.

    Examples
    --------
    >>> nearly_pi = Sweep("nearly pi", lambda rng, gap: (np.pi - gap,), values=(0.1, 0.01))
    >>> nearly_pi.cases(np.random.default_rng(0))
    [(3.041592653589793,), (3.1315926535897933,)]
    """

    what: str
    case: Callable
    values: tuple[float, ...] = BESIDE

    def cases(self, rng):
        """Return the cases of all values."""
        cases = [self.case(rng, value) for value in self.values]
        return [case for case in cases if case is not None]


class MadeCase(tuple):
    """The arguments of a case that the engine has made; those of the author are plain tuples."""

    __slots__ = ()


class SmallNumbers(MadeCase):
    """A case in which arguments hold small numbers, or differ little from a special value."""

    __slots__ = ()


class NearlySpecial(MadeCase):
    """A case whose arguments are all nearly special."""

    __slots__ = ()


class InPlace(MadeCase):
    """A case whose numbers are put into the arrays with which the case before it was asked."""

    __slots__ = ()


class SameGenerator(MadeCase):
    """A case whose generator is that with which the case before it was asked, as it is then."""

    __slots__ = ()


class OneChanged(InPlace):
    """A case that differs in one argument from a case that was asked with the same arrays."""

    __slots__ = ()


def made_cases(cases, names, sweeps, angles, rng, small=(), free=()):
    """Return what the engine adds to the cases of an exercise.

    Parameters
    ----------
    cases : list of tuple
        The author's.
    names : tuple of str
        Of the arguments.
    sweeps : tuple of Sweep
    angles : tuple of str
        The names of the arguments that are angles.
    rng : numpy.random.Generator
    small : tuple of str
        The names of the arguments that may hold small numbers.
    free : tuple of str
        The names of the arguments that do not depend on the others.

    Returns
    -------
    list of tuple
        The sweeps; whole numbers, of type int, in arrays that hold such in a case of the author,
        and in place of numbers that are whole there; -0.0 in place of 0.0; angles of more than one
        revolution; small numbers; the same arrays with other numbers in them; and the same
        arguments but for one.
    """
    swept = [case for sweep in sweeps for case in sweep.cases(rng)]
    whole = _different([_with_whole_numbers(case) for case in cases])[:_MAX_WHOLE]
    whole += _with_one_whole_argument(cases)
    whole += _with_all_free_arguments_whole(cases, names, free)
    whole += _different([_with_integers(case) for case in cases])[:_MAX_WHOLE]
    negative_zeros = [_with_negative_zeros(case) for case in cases]
    several = []
    if angles:
        most_different = max(cases, key=_variety)
        several = [beyond_a_revolution(most_different, names, angles, n) for n in REVOLUTIONS]
    with_zeros = [case for case in negative_zeros if case is not None]
    made = [*swept, *whole, *with_zeros[:_MAX_ZEROS], *several]
    of_small_numbers = map(SmallNumbers, small_numbers(cases, names, small, rng))
    in_place = [*in_the_same_arrays(cases), *with_one_changed(cases, names, free)]
    return [*map(MadeCase, made), *of_small_numbers, *in_place]


def special_at_once(special, admits, rng, is_exact):
    """Return cases whose arguments are all special at once; some of them as they come out of a
    computation, changed in the last bits; some changed by a little more; and some with integers
    in place of whole numbers.

    An answer that knows a special case by the wrong sign, such as a sum that is 0, is wrong where
    the sign is there by coincidence; one that compares with ==, where rounding takes it away; and
    one that compares with a tolerance, where numbers are nearly equal, or nearly 0, and count.

    Parameters
    ----------
    special : callable
        special(rng): the arguments of one case; None where there is no such case.
    admits : callable
        admits(*arguments): whether the task admits these arguments together.
    rng : numpy.random.Generator
    is_exact : bool
        Whether the last bits decide which answer is right, so that they may not change.

    Returns
    -------
    list of tuple
    """
    drawn = [special(rng) for _ in range(_SPECIAL)]
    cases = [case for case in drawn if case is not None and admits(*case)]
    again = [with_some_integers(case, rng) for case in cases[:_INTEGERS]]
    if not is_exact:
        again += [rounded(case, rng) for case in cases[:_ROUNDED]]
    beside = [] if is_exact else [case for case in nearly(cases, rng) if admits(*case)]
    return [*map(MadeCase, (*cases, *again)), *map(NearlySpecial, beside)]


def with_some_integers(case, rng):
    """Return the case with integers for the whole numbers of some of its arguments."""

    def changed(argument):
        if rng.random() < 0.5:
            return argument
        if _is_whole(argument):
            return np.rint(argument).astype(int)
        return round(argument) if _is_whole_number(argument) else argument

    return tuple(map(changed, case))


def nearly(cases, rng):
    """Return the cases with numbers that are off by a little, relative to the largest.

    What is a rotation, a pose, a unit vector, a screw or a skew-symmetric matrix in all cases stays
    one, and a number that is the same in all of them is not changed.
    """
    if not cases:
        return []
    movers = [_mover([case[k] for case in cases]) for k in range(len(cases[0]))]
    sizes = itertools.cycle(_OFF_BY)
    return [
        tuple(
            argument if move is None else _in_the_form_of(argument, move(rng, argument, size))
            for move, argument in zip(movers, case, strict=True)
        )
        for case, size in zip(cases, sizes, strict=False)
    ]


def _mover(arguments):
    """Return the function that moves an argument by a little; None if these do not move."""
    if not all(_is_floats(argument) or isinstance(argument, float) for argument in arguments):
        return None
    arrays = list(map(np.asarray, arguments))
    for is_of_kind, move in _MOVED:
        if all(map(is_of_kind, arrays)):
            return move
    if len({array.ndim for array in arrays}) > 1:
        return _moved_numbers
    # Of arrays with another number of rows those are compared that all of them have.
    common = tuple(slice(n) for n in np.min([array.shape for array in arrays], axis=0).astype(int))
    fixed = np.all([array[common] == arrays[0][common] for array in arrays], axis=0)

    def move(rng, argument, size):
        moved = _moved_numbers(rng, argument, size)
        moved[common] = np.where(fixed, np.asarray(argument)[common], moved[common])
        return moved

    return move


def rounded(case, rng, bits=1):
    """Return a case of the same type whose numbers are off by up to so many last bits of the
    largest, also those that are 0; but not the last row of a pose."""

    def off(argument):
        if not _is_floats(argument) and not isinstance(argument, float):
            return argument
        finite = np.abs(argument)[np.isfinite(argument)]
        size = _LAST_BIT * finite.max(initial=0)
        noise = size * rng.integers(-bits, bits + 1, np.shape(argument))
        if np.ndim(argument) == 2 and _is_pose(argument):
            noise[-1] = 0
        return _in_the_form_of(argument, np.asarray(argument) + noise)

    return type(case)(map(off, case))


def in_the_same_arrays(cases):
    """Return two cases of one form, the second of which is asked with the arrays of the first; or
    none.

    A function that keeps a result for an array, and not for the numbers in it, answers the second
    as the first.
    """
    by_form = {}
    for case in sorted(cases, key=_variety, reverse=True):
        arrays = [argument for argument in case if isinstance(argument, np.ndarray)]
        form = tuple((array.shape, array.dtype.str) for array in arrays)
        if not any(array.size for array in arrays):
            continue
        before, earlier = by_form.setdefault(form, (case, arrays))
        if any(
            not np.array_equal(a, b, equal_nan=True) for a, b in zip(earlier, arrays, strict=True)
        ):
            return [MadeCase(before), InPlace(case)]
    return []


def with_one_changed(cases, names, free):
    """Return for each free argument the last case, and then this case with that argument changed,
    asked with the same arrays.

    A function that keeps a result for some of its arguments, and not for all, answers both alike.
    """
    last = cases[-1]
    if len(last) < 2:
        return []
    pairs = []
    for k in (names.index(name) for name in free):
        other = [case[k] for case in cases if _are_alike_but_differ(case[k], last[k])]
        if other:
            pairs += [MadeCase(last), OneChanged((*last[:k], other[-1], *last[k + 1 :]))]
    return pairs


def _are_alike_but_differ(argument, other):
    if type(argument) is not type(other) or write([argument]) == write([other]):
        return False
    return attempt(np.shape, argument) == attempt(np.shape, other)  # None of a plan of pairs


def _is_floats(argument):
    return isinstance(argument, np.ndarray) and argument.dtype.kind == "f" and argument.size > 0


def _is_whole(argument):
    if not _is_floats(argument) or not np.isfinite(argument).all():
        return False
    small = np.abs(argument).max() < _MAX_WHOLE_NUMBER
    return bool(small and np.abs(argument - np.rint(argument)).max() < _ROUNDING)


def _is_whole_number(argument):
    return isinstance(argument, float) and _is_whole(np.array([argument]))


def _with_whole_numbers(case):
    """Return the case with arrays of integers where it holds whole numbers; None if it does not."""
    if not any(map(_is_whole, case)):
        return None
    return tuple(np.rint(arg).astype(int) if _is_whole(arg) else arg for arg in case)


def _with_integers(case):
    """Return the case with an integer for each number that is whole; None if none is."""
    if not any(map(_is_whole_number, case)):
        return None
    return tuple(round(arg) if _is_whole_number(arg) else arg for arg in case)


def _with_one_whole_argument(cases):
    """Return a case for each argument that may hold whole numbers: an array of integers, beside
    others of floats.

    It is the case in which the fewest of the others are whole: an answer that takes its type from
    one argument cuts off digits only if another one has some.
    """
    best = {}
    for case in cases:
        arrays = [k for k, argument in enumerate(case) if _is_floats(argument)]
        whole = [k for k in arrays if _is_whole(case[k])]
        if len(arrays) < 2:
            continue
        for k in whole:
            variety = _variety((case[k],))
            rank = (variety > 0, len(arrays) - len(whole), variety, _variety(case))
            if k not in best or rank > best[k][0]:
                best[k] = rank, case
    return [
        (*case[:k], np.rint(case[k]).astype(int), *case[k + 1 :]) for k, (_, case) in best.items()
    ]


def _with_all_free_arguments_whole(cases, names, free):
    """Return the last case with integers for each free argument that holds whole numbers, or is
    one, in some case; or none.

    An answer whose array has the common type of its arguments cuts off digits only then.
    """
    last = cases[-1]
    changed = list(last)
    for k in (names.index(name) for name in free):
        whole = [np.rint(case[k]).astype(int) for case in cases if _is_whole(case[k])]
        alike = [array for array in whole if array.shape == np.shape(last[k])]
        if alike:
            changed[k] = max(alike, key=lambda array: _variety((array,)))
        numbers = [round(case[k]) for case in cases if _is_whole_number(case[k])]
        if numbers:
            changed[k] = max(numbers, key=abs)
    return [tuple(changed)] if sum(map(_has_integers, changed)) > 1 else []


def _has_integers(argument):
    is_array = isinstance(argument, np.ndarray) and argument.dtype.kind == "i"
    return is_array or isinstance(argument, int)


def _different(cases):
    """Return the cases that are not None, those with the most different entries first."""
    return sorted((case for case in cases if case is not None), key=_variety, reverse=True)


def _variety(case):
    """Return how many numbers other than 0 stand in the arrays of a case, each counted once."""
    arrays = [argument for argument in case if isinstance(argument, np.ndarray)]
    return sum(len(np.unique(array[array != 0])) for array in arrays)


def _in_the_form_of(argument, changed):
    """Return a changed argument as an array, a list or a number, whichever the argument is."""
    if isinstance(argument, np.ndarray):
        return changed
    return changed.tolist() if isinstance(argument, list | tuple) else float(changed)


def _with_negative_zeros(case):
    """Return the case with -0.0 for each 0.0 of its floats; None if it has none."""
    changed, has_zeros = [], False
    for argument in case:
        if _is_floats(argument) or isinstance(argument, float):
            zeros = np.asarray(argument) == 0
            has_zeros = has_zeros or bool(zeros.any())
            argument = _in_the_form_of(argument, np.where(zeros, -0.0, argument))
        changed.append(argument)
    return tuple(changed) if has_zeros else None


def beyond_a_revolution(case, names, angles, revolutions):
    """Return the case with its angles changed by some revolutions, of alternating signs.

    The signs in one argument are opposite to those in the next, so that differences change, too.
    """
    changed, first = [], 0
    for name, argument in zip(names, case, strict=True):
        if name in angles:
            odd = (np.arange(np.size(argument)) + first) % 2
            signs, first = np.where(odd, -1, 1).reshape(np.shape(argument)), 1 - first
            argument = _in_the_form_of(
                argument, np.asarray(argument) + 2 * np.pi * revolutions * signs
            )
        changed.append(argument)
    return tuple(changed)


def small_numbers(cases, names, small, rng):
    """Return cases in which arguments hold small numbers, which somebody may take for 0.

    At each size in SMALL_NUMBERS all numbers of all these arguments are small, then some numbers of
    each argument, in three ways, and then all numbers of one argument. What is a rotation, a pose
    or a unit vector in all of the author's cases stays one. Its difference from the identity, from
    a quarter of a revolution about one of the axes, or from an axis is small then.

    Parameters
    ----------
    cases : list of tuple
        The author's.
    names : tuple of str
        Of the arguments.
    small : tuple of str
        The names of the arguments that may hold small numbers.
    rng : numpy.random.Generator

    Returns
    -------
    list of tuple
    """
    if not small:
        return []
    base = max(cases, key=_variety)
    kinds = {name: _kind_of([case[names.index(name)] for case in cases]) for name in small}
    groups = [(small, None), *((small, way) for way in range(3))]
    if len(small) > 1:
        groups += [((name,), None) for name in small]

    def changed(group, way, size):
        arguments = dict(zip(names, base, strict=True))
        for name in group:
            made = kinds[name](rng, np.asarray(arguments[name], float), size, way)
            arguments[name] = _in_the_form_of(arguments[name], made)
        return tuple(arguments.values())

    return [changed(group, way, size) for size in SMALL_NUMBERS for group, way in groups]


def _kind_of(arguments):
    """Return the function that makes a small argument of the kind that all of these are of."""
    for is_of_kind, kind in _KINDS:
        if all(is_of_kind(np.asarray(argument)) for argument in arguments):
            return kind
    return _numbers


def _is_rotation(R):
    return R.shape in ((2, 2), (3, 3)) and bool(is_so(R))


def _is_pose(T):
    square = T.shape in ((3, 3), (4, 4))
    return square and _is_rotation(T[:-1, :-1]) and np.array_equal(T[-1], np.eye(len(T))[-1])


def _is_unit_vector(v):
    return v.ndim == 1 and abs(np.linalg.norm(v) - 1) < EXACT


def _drawn(rng, shape, size):
    return size * rng.choice([-1, 1], shape) * rng.uniform(0.3, 0.9, shape)


# way: 0, 1 or 2 if some numbers of the argument are small; None if all of them are.


def _numbers(rng, argument, size, way):
    """Return small numbers, or the argument with small numbers in every second entry."""
    drawn = _drawn(rng, argument.shape, size)
    if way is None or argument.ndim == 0:
        return drawn
    index = np.arange(argument.size).reshape(argument.shape)
    return np.where(index % 2 == way % 2, argument, drawn)


def _rotation(rng, R, size, way):
    """Return a rotation by a small angle, or one that is nearly a quarter about an axis."""
    quarter = 0.0 if way is None else np.pi / 2
    if len(R) == 2:
        angle = quarter + _drawn(rng, (), size)
        return np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    axis = np.eye(3)[way or 0]
    return exp_so3(quarter * axis + _drawn(rng, 3, size))


def _pose(rng, T, size, way):
    made = np.eye(len(T))
    made[:-1, :-1] = _rotation(rng, T[:-1, :-1], size, way)
    made[:-1, -1] = _numbers(rng, T[:-1, -1], size, way)
    return made


def _unit_vector(rng, v, size, way):
    """Return a unit vector that is nearly along an axis."""
    made = np.eye(len(v))[(way or 0) % len(v)] + _drawn(rng, len(v), size)
    return made / np.linalg.norm(made)


def _moved_numbers(rng, argument, size):
    """Return an array, also of a single number, so that its entries can be assigned to."""
    array = np.asarray(argument)
    largest = np.abs(array).max(initial=0)
    return np.array(array + size * largest * rng.choice([-1, 0, 1], array.shape))


def _moved_rotation(rng, R, size):
    return R @ _rotation(rng, R, size, None)


def _moved_pose(rng, T, size):
    return T @ _pose(rng, T, size, None)


def _moved_poses(rng, poses, size):
    return np.array([_moved_pose(rng, T, size) for T in poses])


def _moved_unit_vector(rng, v, size):
    moved = v + _drawn(rng, len(v), size)
    return moved / np.linalg.norm(moved)


def _moved_screws(rng, screws, size):
    return np.array([adjoint(_pose(rng, np.eye(4), size, None)) @ S for S in screws])


def _is_skew_symmetric(array):
    return array.ndim == 2 and array.shape == array.T.shape and np.array_equal(array, -array.T)


def _moved_skew_symmetric(rng, W, size):
    moved = _moved_numbers(rng, W, size)
    return (moved - moved.T) / 2


def _are_poses(array):
    return array.ndim == 3 and all(map(_is_pose, array))


def _are_screws(array):
    """Return whether the rows are screw axes (omega, v) of joints."""
    if array.ndim != 2 or array.shape[1] != 6:
        return False
    lengths = np.linalg.norm(array[:, :3], axis=1)
    return bool(np.all((lengths == 0) | (np.abs(lengths - 1) < EXACT)))


_MOVED = (
    (_is_rotation, _moved_rotation),
    (_is_pose, _moved_pose),
    (_are_poses, _moved_poses),
    (_is_unit_vector, _moved_unit_vector),
    (_are_screws, _moved_screws),
    (_is_skew_symmetric, _moved_skew_symmetric),
)
_KINDS = (
    (_is_rotation, _rotation),
    (_is_pose, _pose),
    (_is_unit_vector, _unit_vector),
)
