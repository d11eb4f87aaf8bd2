"""Find the name of a mistake: those of the exercise first, then those that are tried for every
exercise."""

import functools

import numpy as np

from course_lib.checks.common_mistakes import (
    CUT_OFF,
    MIN_NUMBERS,
    OTHER_FORMS,
    USE_ALL_DIGITS,
    USE_FLOAT64,
    WRONG_FOR_INTEGERS,
    ChangedAnswer,
    common_mistakes,
    is_telling,
    is_whole,
)
from course_lib.checks.comparisons import (
    attempt,
    difference,
    first_otherwise,
    largest_gap,
    predict,
    same,
)
from course_lib.checks.mistake import Mistake
from course_lib.checks.special_cases import InPlace, MadeCase, OneChanged, SmallNumbers
from course_lib.checks.tolerances import EXACT
from course_lib.checks.wire import Seed

_CLEARLY_OFF = 0.1  # more than a small angle that is taken for 0
_SIMILAR = 0.01  # what rounding to two decimals makes equal
_LAST_BITS = 1e-15  # relative: more than the rounding of a product of matrices
_NUDGED = 1e-6  # how far two answers may be apart of which rounding decides
_FIRST_DIGITS = 3e-3  # two or three digits: 22/7 for pi is off by 4e-4


KEPT_FOR_AN_ARRAY = Mistake(
    "a result is kept for an array, and found again when other numbers stand in the array",
    "The same array may hold other numbers at the next call, for example in a loop that fills it. "
    "Compute the result from the numbers.",
)

KEPT_FOR_SOME_ARGUMENTS = Mistake(
    "a result is kept for some of the arguments, and found again when another one has changed",
    "Does your function compute anew when only one of its arguments changes? Compute the result "
    "from all of them.",
)

KEPT_FOR_SIMILAR_INPUT = Mistake(
    "the answer to an earlier, similar input is returned again",
    "Called alone with the input below, does your function give this answer? What does it keep "
    "from one call to the next, and when does it take two inputs for the same?",
)

KEPT_FOR_THE_NEXT_CALL = Mistake(
    "something is kept from one call to the next",
    "A list or an array outside the function, or a default like products=[], is made once only, "
    "and each call finds in it what the calls before have left there. Which of your names live "
    "longer than one call?",
)

WRONG_FOR_SMALL_NUMBERS = Mistake(
    "the answer is wrong where some numbers are small, as below",
    "Which line treats such numbers otherwise than larger ones, or loses their digits? Look for a "
    "comparison with a tolerance, a rounding, a root, and a difference of nearly equal numbers.",
)

WRONG_BEYOND_A_REVOLUTION = Mistake(
    "the answer is wrong for angles beyond one revolution",
    "A joint, or a body, may rotate more than once. Which line changes an angle, or is right for "
    "angles within one revolution only?",
)


class Naming:
    """The answers to all cases of an exercise, compared with what its mistakes predict.

    Parameters
    ----------
    exercise : Exercise
    cases : list of tuple
    values : list
        The answers, as the exercise reads them.
    """

    def __init__(self, exercise, cases, values):
        self.exercise, self.cases, self.values = exercise, cases, values
        self._rights, self._predictions = {}, {}

    def mistake(self, failing, wrong):
        """Return the Mistake that accounts for all wrong answers, those at the positions `wrong`,
        or None.

        failing: the positions among them at which the property fails of which the message speaks;
        a mistake that is recognised in the answers, and not predicted, is looked for in these.

        Said first is what can be told from the answers themselves: a result kept for an array that
        is filled again, or for some of the arguments, rounding, float32, and answers wrong for
        whole numbers only. Then comes a mistake of the exercise that predicts every answer, and
        then that only the first digits are right: such an answer is blamed for nothing else. Then
        one that explains all answers is preferred to one that explains the wrong ones only; a few
        True or False, or signs, fit many mistakes by chance, so these must explain all.
        """
        own = self.exercise.mistakes
        if wrong and all(isinstance(self.cases[i], OneChanged) for i in wrong):
            return KEPT_FOR_SOME_ARGUMENTS
        if wrong and all(isinstance(self.cases[i], InPlace) for i in wrong):
            return KEPT_FOR_AN_ARRAY
        of_digits = self._shortened(wrong)
        if of_digits is None and self._is_wrong_only_where(_has_integers, wrong):
            of_digits = self._wrong_for_integers(wrong)
        if of_digits is not None:
            return of_digits
        for known in own:
            if self._predicts_all(known, wrong):
                return known
        of_digits = self._few_digits(wrong)
        if of_digits is not None:
            return of_digits
        for known in own:
            if self._explains(known, failing, wrong, everywhere=True):
                return known
        for known in common_mistakes(self):
            if self._explains_enough(known, failing, wrong):
                return known
        if wrong and all(map(self._is_given_again, wrong)):
            return KEPT_FOR_SIMILAR_INPUT
        # What draws random numbers may differ without keeping anything.
        draws = any(isinstance(argument, Seed) for argument in self.cases[0])
        if not draws and attempt(first_otherwise, self.values, self.cases) in wrong:
            return KEPT_FOR_THE_NEXT_CALL
        for known in () if self.has_few_values() else own:
            if self._explains(known, failing, wrong):
                return known
        return None

    def in_common(self, wrong):
        """Return the Mistake that says what all cases with wrong answers, and no others, have in
        common; or None."""
        if self._is_wrong_only_where(lambda case: isinstance(case, SmallNumbers), wrong):
            return WRONG_FOR_SMALL_NUMBERS
        if self._is_wrong_only_where(self._has_an_angle_beyond_a_revolution, wrong):
            return WRONG_BEYOND_A_REVOLUTION
        return None

    def _is_given_again(self, position):
        """Return whether an answer is, to the last digit, that to a similar case asked before.

        Whoever takes small numbers for 0 returns again what 0 got: nothing is kept for that.
        """
        value = attempt(np.asarray, self.values[position], float)
        if value is None or value.size < MIN_NUMBERS or is_whole(value):
            return False  # two inputs may rightly have the same few, or whole, numbers
        return any(
            attempt(np.array_equal, value, self.values[k])
            and _are_similar(self.cases[k], self.cases[position])
            and not all(map(is_whole, filter(_is_array, self.cases[k])))
            for k in range(position)
        )

    def _predicts_all(self, mistake, wrong):
        """Return whether a function of the mistake predicts all wrong answers, and contradicts no
        other."""
        return any(
            self._accounts_for(mistake, answer, wrong, everywhere=True)
            for answer in mistake.answers
        )

    def _is_wrong_only_where(self, is_special, wrong):
        """Return whether the answers are wrong in special cases only, and right in all others, of
        which there are some."""
        others = [i for i, case in enumerate(self.cases) if not is_special(case)]
        return bool(others) and not set(others) & set(wrong)

    def _wrong_for_integers(self, wrong):
        """Return the Mistake of answers that are wrong for integers only."""
        name, hint = WRONG_FOR_INTEGERS
        in_arrays = all(_has_integers(self.cases[i], np.ndarray) for i in wrong)
        name = name.format("arrays of integers" if in_arrays else "integers")
        if all(attempt(_is_cut_off, self.values[i], self.right(i)) for i in wrong):
            name += ": digits after the point are cut off"
        return Mistake(name, hint)

    def _has_an_angle_beyond_a_revolution(self, case):
        named = zip(self.exercise.arguments, case, strict=True)
        angles = [np.ravel(argument) for name, argument in named if name in self.exercise.angles]
        return any(np.abs(angle).max(initial=0) > 2 * np.pi for angle in angles)

    def has_few_values(self):
        """Return whether all answers are made of True, False, 0, 1 and -1, which fit many mistakes
        by chance."""
        return all(
            bool(attempt(lambda bits: np.isin(bits, (-1, 0, 1)).all(), value))
            for value in self.values
        )

    def distance(self, position):
        """Return how far the answer to a case is from the library's: inf if that cannot be said."""
        right = self.right(position)
        if right is None:
            return np.inf
        value = self.values[position]
        gap = attempt(self.exercise.distance, value, right, *self.cases[position])
        return np.inf if gap is None or np.isnan(gap) else float(gap)

    def gap(self, position):
        """Return by how much an answer is off in its entries, as messages say it; a distance that
        is smaller, as one up to the sign, takes its place."""
        distance = self.distance(position)
        in_entries = attempt(difference, self.values[position], self.right(position))
        return distance if in_entries is None else min(distance, in_entries)

    def looks_right(self, position):
        """Return whether an answer differs from the library's in later digits only."""
        return bool(0 < self.distance(position) <= _FIRST_DIGITS * max(1, self._size(position)))

    def _size(self, position):
        """Return the largest entry of the library's answer, without its sign; 0 if there is
        none."""
        right = self.right(position)
        return 0.0 if right is None else np.nan_to_num(np.abs(right), posinf=0).max(initial=0)

    def _shortened(self, wrong):
        """Return the Mistake of answers of float32, of rounded ones that are nearly right, or of
        digits cut off after the point; or None."""
        arrays = [attempt(np.asarray, value, float) for value in self.values]
        if any(array is None for array in arrays):
            return None
        all_are_whole = all(map(is_whole, arrays))
        # A single whole number, or the identity for a small rotation, is not a number cut off.
        are_telling = all(
            arrays[i].size >= MIN_NUMBERS and self.distance(i) > _CLEARLY_OFF for i in wrong
        )
        if (all_are_whole or are_telling) and self._are_cut_off(arrays, wrong):
            return Mistake(*CUT_OFF)
        if all_are_whole:
            return None
        in_float32 = all(np.array_equal(x, x.astype(np.float32), equal_nan=True) for x in arrays)
        if in_float32 and not all(map(_is_short, arrays)):
            return Mistake("the answer has the seven digits of float32", USE_FLOAT64)
        if not self._are_nearly_right(wrong):
            return None
        for k in range(1, 9):
            if all(np.array_equal(x, np.round(x, k), equal_nan=True) for x in arrays):
                return Mistake(f"the answer is rounded to {k} digits", USE_ALL_DIGITS)
        return None

    def _are_cut_off(self, arrays, wrong):
        """Return whether wrong answers, whole numbers all, are the right ones without the digits
        after the point."""
        if (
            not any(arrays[i].any() for i in wrong)
            or sum(arrays[i].size for i in wrong) < MIN_NUMBERS
        ):
            return False
        rights = [self.right(i) for i in wrong]
        if all(right is None or is_whole(right) for right in rights):
            return False  # then no digit stands after the point
        return all(
            right is not None
            and right.shape == arrays[i].shape
            and np.isfinite(right).all()
            and _is_cut_off(arrays[i], right)
            for i, right in zip(wrong, rights, strict=True)
        )

    def _few_digits(self, wrong):
        """Return the Mistake of most answers being right to their first digits only, or None."""
        ordinary = [i for i, case in enumerate(self.cases) if not isinstance(case, MadeCase)]
        of_most = 2 * len(set(wrong) & set(ordinary)) >= len(ordinary)
        if not of_most or not self._are_nearly_right(wrong):
            return None  # or digits are lost beside a special value only
        return Mistake("the answer is right to its first digits only", USE_ALL_DIGITS)

    def _are_nearly_right(self, wrong):
        """Return whether each wrong answer is a number or an array that differs from the right one
        in later digits."""
        if any(isinstance(self.values[i], bool) for i in wrong):
            return False
        sizes = [1 + self._size(i) for i in wrong]
        off = [self.distance(i) for i in wrong]
        return all(0 < gap <= _FIRST_DIGITS * size for gap, size in zip(off, sizes, strict=True))

    def of_other_form(self, position, value):
        """Return the Mistake of an answer whose shape is not the one asked for, or None."""
        right = self.right(position)
        if right is None or not isinstance(value, (np.ndarray, list, tuple, int, float)):
            return None
        for name, hint, change in OTHER_FORMS:
            form = attempt(change, right)
            if form is not None and is_telling(form) and same(value, form):
                return Mistake(name, hint)
        return None

    def right(self, position):
        """Return the library's answer to a case as an array of floats; None if it is not one."""
        if position not in self._rights:
            library = self.exercise.library
            answer = predict(library, self.cases[position]) if library else None
            self._rights[position] = (
                attempt(np.asarray, answer, float) if answer is not None else None
            )
        return self._rights[position]

    def _explains(self, mistake, failing, wrong, everywhere=False):
        if mistake.seen is not None and all(
            attempt(mistake.seen, self.values[i], *self.cases[i]) for i in failing
        ):
            return True
        return any(
            self._accounts_for(mistake, answer, wrong, everywhere) for answer in mistake.answers
        )

    def _accounts_for(self, mistake, answer, wrong, everywhere):
        """Return whether a variant predicts the wrong answers, and contradicts none, or few, of the
        others.

        Few: right answers which the mistake would have made wrong, as long as they are fewer than
        the wrong ones.
        """
        if not all(self._predicts(mistake, answer, i) for i in wrong):
            return False
        others = set(range(len(self.values))) - set(wrong)
        contradicted = [i for i in others if self._predicts(mistake, answer, i) is False]
        if everywhere:
            return not contradicted
        right = [
            i
            for i in contradicted
            if attempt(self.exercise.alike, self.values[i], self.right(i), *self.cases[i])
        ]
        return len(right) < len(wrong)

    def _explains_enough(self, mistake, failing, wrong):
        """Return whether a transform explains all answers, and enough numbers for this to be no
        accident."""
        if not self._explains(mistake, failing, wrong, everywhere=True):
            return False
        if not mistake.answers:
            return True
        transform = mistake.answers[0]
        # Where the answer is nearly right, so is whatever explains it.
        clearly_wrong = [i for i in wrong if not self.looks_right(i)]
        if not clearly_wrong or any(self._is_right(transform, i) for i in clearly_wrong):
            # a list of solutions in reverse order, for example: this is not what is wrong
            return False
        explained = {
            str(value): np.size(value)
            for i, value in enumerate(self.values)
            if self._predicts(mistake, transform, i)
        }
        return sum(explained.values()) >= MIN_NUMBERS

    def _is_right(self, answer, position):
        """Return whether what a mistake predicts is right as well, as a list of solutions is in
        reverse order.

        A transposed rotation by 1e-7 is close to the right one, but it is not right.
        """
        case, right = self.cases[position], self.right(position)
        predicted = self._predicted(answer, position)
        if right is None or predicted is None:
            return False
        if self.exercise.distance is difference and self.exercise.alike is not same:
            return bool(attempt(self.exercise.alike, right, predicted, *case))
        gap = attempt(self.exercise.distance, predicted, right, *case)
        return gap is not None and bool(gap <= 1e-12 * max(1, self._size(position)))

    def _predicted(self, answer, position):
        """Return what a variant of a mistake answers to a case, or None.

        It is computed once, because a mistake is looked for in several ways and an iteration takes
        long.
        """
        key = id(answer), position
        if key not in self._predictions:
            case = self.cases[position]
            if isinstance(answer, ChangedAnswer):
                predicted = attempt(answer, self.right(position), *case)
            else:
                predicted = predict(answer, case)
            self._predictions[key] = answer, predicted  # the answer is kept, and so its id
        return self._predictions[key][1]

    def _predicts(self, mistake, answer, position):
        """Return whether a variant predicts the answer to a case; None if it does not apply
        there."""
        found = self._predicts_as_asked(mistake, answer, position)
        if found is False:
            return any(
                naming._predicts_as_asked(mistake, answer, position)
                for naming in self._namings_of_other_rights(position)
            )
        return found

    def _namings_of_other_rights(self, position):
        """Return the namings of nudged cases in which the library answers this case otherwise, and
        rightly all the same.

        A rotation by pi has two rotation vectors. Rounding decides which of them the library
        returns, and so do a student and a mistake that begins with it.
        """
        right, case = self.right(position), self.cases[position]
        if right is None or self.exercise.distance is difference:
            return []
        others = []
        for naming in self._nudged:
            other = naming.right(position)
            if other is None or same(other, right):
                continue
            gap = attempt(self.exercise.distance, other, right, *case)
            if gap is not None and gap <= _NUDGED:
                others.append(naming)
        return others

    @functools.cached_property
    def _nudged(self):
        """The namings of the same answers to cases that differ in the last bits."""
        return [
            Naming(self.exercise, [_nudge(case, sign) for case in self.cases], self.values)
            for sign in (1, -1)
        ]

    def _predicts_as_asked(self, mistake, answer, position):
        """Return whether a variant predicts the answer from the case as it is, to the last bit;
        None if it does not apply there."""
        case, value = self.cases[position], self.values[position]
        predicted = self._predicted(answer, position)
        if predicted is None:
            return None
        alike, right = mistake.alike or self.exercise.alike, self.right(position)
        if mistake.part is not None:
            alike, value = same, np.asarray(value)[mistake.part]
            right = right[mistake.part]
        if alike is not same or right is None or not same(predicted, right, tolerance=1e-3):
            return bool(attempt(alike, value, predicted, *case))
        # The prediction is close to the right answer: the answer must be much closer to the one
        # than to the other.
        between = largest_gap(predicted, right)
        rounding = 1e-13 * max(1, largest_gap(right, 0))
        if between <= rounding:
            return True if difference(value, predicted) <= rounding else None
        return same(value, predicted) and bool(difference(value, predicted) <= 0.1 * between)


def _nudge(case, sign):
    """Return a case whose numbers are larger or smaller by a few units in the last place."""
    rng = np.random.default_rng(0)

    def nudged(argument):
        if not isinstance(argument, float) and not (
            isinstance(argument, np.ndarray) and argument.dtype.kind == "f"
        ):
            return argument
        return argument * (1 + sign * _LAST_BITS * rng.choice([-1, 1], np.shape(argument)))

    return type(case)(map(nudged, case))


def _is_array(argument):
    return isinstance(argument, np.ndarray)


def _are_similar(case, other):
    """Return whether two cases are different and have arguments that differ by little."""
    pairs = list(zip(case, other, strict=True))
    if all(attempt(np.array_equal, a, b) for a, b in pairs):
        return False
    return all(
        same(a, b, tolerance=_SIMILAR) if isinstance(a, np.ndarray | float) else a == b
        for a, b in pairs
    )


def _has_integers(case, kind=np.ndarray | int):
    """Return whether an argument is a whole number, or an array of such, of type int; or of these a
    kind."""
    numbers = [argument for argument in case if isinstance(argument, kind)]
    return any(np.asarray(number).dtype.kind == "i" for number in numbers)


def _is_short(array):
    """Return whether the numbers have few decimals, as 0.125 has, which is the same in float32."""
    return np.array_equal(array, np.round(array, 5), equal_nan=True)


def _is_cut_off(array, right):
    """Return whether the numbers are whole, and those before the point up to rounding."""
    if not is_whole(array):
        return False
    smaller = np.abs(array) <= np.abs(right) + EXACT
    return bool(smaller.all() and (np.abs(right - array) < 1).all())
