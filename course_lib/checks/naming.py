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
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import (
    InPlace,
    MadeCase,
    NearlySpecial,
    OneChanged,
    SmallNumbers,
    rounded,
)
from course_lib.checks.tolerances import EXACT
from course_lib.checks.wire import Seed, write

_CLEARLY_OFF = 0.1  # more than a small angle that is taken for 0
_SIMILAR = 0.01  # what rounding to two decimals makes equal
_LAST_BITS = 8  # more than the rounding of a product of matrices
_NUDGES = 8  # so that both signs occur that rounding may give to a number
_NUDGED = 1e-6  # how far two answers may be apart of which rounding decides
_FIRST_DIGITS = 3e-3  # two or three digits: 22/7 for pi is off by 4e-4
_MOST_OF_A_STEP = 0.3  # of which more is right than is lost
_FEW_DIGITS = 1e-4  # relative: so near another idea does not come by chance
_TO_ROUNDING = 2e-15  # relative: what a number that should be 0 may be
_FEW = 1 / 2  # of all answers
_MAX_WRONG = 5  # answers that are looked at for this


KEPT_FOR_AN_ARRAY = Mistake(
    "a result is kept for an array, and found again when other numbers stand in the array",
    "The same array may hold other numbers at the next call, for example in a loop that fills it. "
    "Compute the result from the numbers.",
)

ONLY_WITH_NEW_NUMBERS = Question(
    "the answer is wrong only where an array of the call before holds other numbers",
    "All answers are right but those to an array of the call before, with other numbers in it. "
    "Called alone with the input below, does your function give this answer? What does it keep "
    "from one call to the next?",
)

KEPT_FOR_SOME_ARGUMENTS = Mistake(
    "a result is kept for some of the arguments, and found again when another one has changed",
    "Does your function compute anew when only one of its arguments changes? Compute the result "
    "from all of them.",
)

ONLY_WITH_ONE_CHANGED = Question(
    "the answer is wrong only where one argument has changed since the call before",
    "All answers are right but those to a call that differs from the call before in one argument "
    "only. Called alone with the input below, does your function give this answer? What does it "
    "keep from one call to the next?",
)

GIVEN_TO_SIMILAR_INPUT = Mistake(
    "the answer is the one to an earlier, similar input",
    "Called alone with the input below, does your function give this answer, too? If it does, "
    "which line takes the two inputs for the same? If not, what does it keep from one call to the "
    "next?",
)

GIVEN_TO_EARLIER_CALL = Mistake(
    "the answer is the one to an earlier call, with other arguments",
    "Called alone with the input below, does your function give this answer, too? If not, what "
    "does it keep from one call to the next?",
)

KEPT_FOR_THE_NEXT_CALL = Mistake(
    "something is kept from one call to the next",
    "A list or an array outside the function, or a default like products=[], is made once only, "
    "and each call finds in it what the calls before have left there. Which of your names live "
    "longer than one call?",
)

CHANGES_FROM_CALL_TO_CALL = Question(KEPT_FOR_THE_NEXT_CALL.name, KEPT_FOR_THE_NEXT_CALL.hint)

FIRST_DIGITS_HERE = Mistake(
    "the answer is right to its first digits only, for the input below",
    "Which line loses digits for this input, or is only nearly right for it, for example because "
    "something small is added, or left out? Compare each intermediate value with one that you "
    "compute in another way.",
)

WRONG_FOR_SMALL_NUMBERS = Mistake(
    "the answer is wrong where some numbers are small, as below",
    "Which line treats such numbers otherwise than larger ones, or loses their digits? Look for a "
    "comparison with a tolerance, a rounding, a root, a difference of nearly equal numbers, and a "
    "bound for a result that may be very large.",
)

WRONG_BEYOND_A_REVOLUTION = Mistake(
    "the answer is wrong for angles beyond one revolution",
    "A joint, or a body, may rotate more than once. Which line changes an angle, or is right for "
    "angles within one revolution only?",
)

FIRST_DIGITS_BEYOND_A_REVOLUTION = Mistake(
    "the answer is right to its first digits only, for angles beyond one revolution",
    "A joint, or a body, may rotate more than once. Which line changes an angle, or loses its last "
    "digits where the angle is large?",
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

    def mistake(self, failing, wrong, of_digits=None):
        """Return the Mistake that accounts for all wrong answers, those at the positions `wrong`,
        or None.

        failing: the positions among them at which the property fails of which the message speaks;
        a mistake that is recognised in the answers, and not predicted, is looked for in these.
        of_digits: the Mistake of answers that lack digits, if they do; they are blamed for no
        mistake that is only recognised.

        Said first is what can be told from the answers themselves: a result kept for an array that
        is filled again, or for some of the arguments, rounding, float32, and answers wrong for
        whole numbers only. Then comes a mistake of the exercise that predicts every answer, and
        then that only the first digits are right: such an answer is blamed for nothing else. Then
        one that explains all answers is preferred to one that explains the wrong ones only; a few
        True or False, or signs, fit many mistakes by chance, so these must explain all.
        """
        own = self.exercise.mistakes
        if wrong and all(map(self._begins_with_an_earlier_answer, wrong)):
            return KEPT_FOR_THE_NEXT_CALL
        from_before = self._kept_from_the_call_before(wrong)
        if from_before is not None:
            return from_before
        shortened = self._shortened(wrong)
        if shortened is None and self._is_wrong_only_where(_has_integers, wrong):
            shortened = self._wrong_for_integers(wrong)
        if shortened is not None:
            return shortened
        recognised_in = failing if of_digits is None else ()
        for known in own:
            if self._predicts_all(known, wrong):
                return known
        few_digits = self._few_digits(wrong)
        if few_digits is not None:
            return few_digits
        for known in own:
            if self._explains(known, recognised_in, wrong, everywhere=True):
                return known
        for known in common_mistakes(self):
            if self._explains_enough(known, failing, wrong):
                return known
        if wrong and all(map(self._is_given_again, wrong)):
            return GIVEN_TO_SIMILAR_INPUT
        # What draws random numbers may differ without keeping anything.
        draws = any(isinstance(argument, Seed) for argument in self.cases[0])
        if not draws and attempt(first_otherwise, self.values, self.cases) in wrong:
            return KEPT_FOR_THE_NEXT_CALL
        earlier = None if draws else self._of_an_earlier_call(wrong)
        if earlier is not None:
            return earlier
        for known in () if self.has_few_values() else own:
            if self._explains(known, recognised_in, wrong):
                return known
        return None

    def in_common(self, wrong):
        """Return the Mistake that says where all wrong answers are, and only these; or None."""
        if self._is_wrong_only_where(_has_small_numbers, wrong):
            is_of_small_ones = isinstance(self.cases[wrong[0]], SmallNumbers)
            return WRONG_FOR_SMALL_NUMBERS if is_of_small_ones else None
        if self._is_wrong_only_where(self._has_an_angle_beyond_a_revolution, wrong):
            return WRONG_BEYOND_A_REVOLUTION
        return None

    def of_few(self, wrong):
        """Return the Question about wrong answers that are few, or None.

        Where most answers are right, a question about the steps that every answer takes leads to
        lines that are right.
        """
        if 0 in wrong or len(wrong) > _FEW * len(self.cases):
            return None
        return Question(
            "the answers to some inputs only are wrong",
            f"{len(self.cases) - len(wrong)} of {len(self.cases)} answers are right. What is "
            "special about this input, and which of your lines does it take?",
        )

    def of_digits(self, failing, wrong):
        """Return the Mistake of answers that are right to their first digits only, or None.

        An answer may come near the right one by chance, so all wrong ones must, or the one that is
        shown must come very near.
        """
        if not self._lacks_digits(failing[0]):
            return None
        is_chance = not self._lacks_digits(failing[0], _FEW_DIGITS)
        # An entry that is nearly 0 has no digits that could be right.
        with_digits = [i for i in wrong if not isinstance(self.cases[i], NearlySpecial)] or wrong
        if is_chance and not all(map(self._lacks_digits, with_digits)):
            return None
        where = self.in_common(wrong)
        if where is WRONG_BEYOND_A_REVOLUTION:
            return FIRST_DIGITS_BEYOND_A_REVOLUTION
        return where or FIRST_DIGITS_HERE

    def _lacks_digits(self, position, share=_FIRST_DIGITS):
        """Return whether an answer differs from the right one in later digits of its entries
        only."""
        right = self.right(position)
        value = attempt(np.asarray, self.values[position], float)
        if isinstance(self.values[position], bool) or right is None or value is None:
            return False
        if value.shape != right.shape or not np.isfinite(right).all() or is_whole(value):
            return False
        size = self._size(position)
        gaps, sizes = np.abs(value - right), np.abs(right)
        # The cosine of pi/2 is 6e-17, and 1e-6 with a short number for pi.
        is_zero = sizes <= _TO_ROUNDING * size
        near = np.where(is_zero, gaps <= _FEW_DIGITS * size, gaps <= share * sizes)
        for argument in self.cases[position]:
            if _is_array(argument) and argument.shape == right.shape:
                # The answer may be a step from this argument: the step must be there, too.
                changes = np.abs(right - argument)
                stays = changes <= _TO_ROUNDING * size
                near &= stays | (gaps <= _MOST_OF_A_STEP * changes)
        return bool(near.all()) and self.distance(position) > 0

    def _begins_with_an_earlier_answer(self, position):
        """Return whether the first rows are, to the last bit, the answer to an earlier call, and
        should be others: a list has grown from call to call."""
        value, right = self.values[position], self.right(position)
        if not _is_array(value) or value.ndim != 2 or is_whole(value):
            return False
        for earlier in self.values[:position]:
            n = len(earlier) if _is_array(earlier) and earlier.ndim == 2 else 0
            if not MIN_NUMBERS <= n < len(value) or not np.array_equal(value[:n], earlier):
                continue
            if right is None or not attempt(np.allclose, right[:n], earlier):
                return True
        return False

    def _kept_from_the_call_before(self, wrong):
        """Return what is said of answers that are wrong only for the arrays of the call before, or
        None.

        It is a Mistake only if each is the answer to the call before.
        """
        if not wrong or not all(isinstance(self.cases[i], InPlace) for i in wrong):
            return None
        is_repeated = all(attempt(self._equals_answer, i, i - 1) for i in wrong)
        if all(isinstance(self.cases[i], OneChanged) for i in wrong):
            return KEPT_FOR_SOME_ARGUMENTS if is_repeated else ONLY_WITH_ONE_CHANGED
        return KEPT_FOR_AN_ARRAY if is_repeated else ONLY_WITH_NEW_NUMBERS

    def _equals_answer(self, position, earlier):
        value, before = self.values[position], self.values[earlier]
        return difference(value, before) <= EXACT * max(1, largest_gap(before, 0))

    def returned_argument(self, wrong):
        """Return the Mistake of wrong answers that are an argument as it came, to the last bit, or
        None."""
        if not wrong:
            return None
        arrays = [attempt(np.asarray, self.values[i], float) for i in wrong]
        if any(array is None or array.size < MIN_NUMBERS - 1 for array in arrays):
            return None
        if all(map(is_whole, arrays)):
            return None
        for k, argument in enumerate(self.exercise.arguments):
            given = [attempt(np.asarray, self.cases[i][k], float) for i in wrong]
            if all(attempt(np.array_equal, *pair) for pair in zip(arrays, given, strict=True)):
                return Mistake(
                    f"{argument} is returned as it came, for the input below",
                    f"Which line of yours leaves {argument} as it is for this input? Does the task "
                    "ask for a change here, even for a small one?",
                )
        return None

    def _of_an_earlier_call(self, wrong):
        """Return the Mistake of wrong answers that are right for an earlier call, or for some of
        its arguments; or None."""
        positions = wrong[:_MAX_WRONG]
        if not positions or self.has_few_values():
            return None
        if not all(map(self._is_clearly_another, positions)):
            return None
        earlier = [self._call_answered_instead(i) for i in positions]
        if all(k is not None for k in earlier):
            return self._answered_instead(self._differing(positions[0], earlier[0]))
        if len(positions) == 1 or not self.exercise.tries_arguments:
            return None  # one answer may be right for other arguments by chance
        kept = self._kept_arguments(positions)
        return None if kept is None else self._answered_instead(kept)

    def _differing(self, position, earlier):
        """Return the numbers of the arguments in which two cases differ."""
        pairs = zip(self.cases[position], self.cases[earlier], strict=True)
        return {k for k, (one, other) in enumerate(pairs) if write([one]) != write([other])}

    def _answered_instead(self, kept):
        """Return the Mistake of answers to an earlier call, for some of its arguments.

        It is None if these are single numbers: a bound may have made them of those that are given.
        """
        if not any(_is_array(self.cases[0][k]) for k in kept):
            return None
        names = [self.exercise.arguments[k] for k in sorted(kept)]
        *others, last = names
        listed = f"{', '.join(others)} and {last}" if others else last
        return Mistake(
            f"the answer is the right one for {listed} of an earlier call",
            "Called alone with the input below, does your function give this answer, too? If it "
            "does, what does it compute from the arguments that have changed? If not, what does "
            "it keep from one call to the next?",
        )

    def _is_clearly_another(self, position):
        """Return whether an answer holds numbers enough to be recognised, and is far from the right
        one."""
        value = attempt(np.asarray, self.values[position], float)
        right = self.right(position)
        if value is None or right is None or value.shape != right.shape:
            return False
        if value.size < MIN_NUMBERS or np.ptp(value) == 0 or not np.isfinite(value).all():
            return False  # zeros, for example, are the answer to much
        return self.distance(position) > _CLEARLY_OFF * max(1, self._size(position))

    def _call_answered_instead(self, position):
        """Return the position of the last earlier case to which the library gives this answer, or
        None."""
        value, case = np.asarray(self.values[position], float), self.cases[position]
        for k in reversed(range(position)):
            right = self.right(k)
            is_special = all(map(is_whole, filter(_is_array, self.cases[k])))
            if is_special or _are_similar(*map(_within_a_revolution, (self.cases[k], case))):
                continue  # one input may be taken for the other, and nothing is kept
            if (
                right is not None
                and right.shape == value.shape
                and self._is_to_the_last(value, right)
            ):
                return k
        return None

    def _is_to_the_last(self, value, right):
        is_near = largest_gap(value, right) <= EXACT * max(1, largest_gap(right, 0))
        return np.isfinite(right).all() and is_near

    def _kept_arguments(self, positions):
        """Return the numbers of the arguments that answers take from the call before; None if there
        are no such."""
        number = len(self.exercise.arguments)
        single = [{k} for k in range(number)] if number > 1 else []
        all_but_one = [set(range(number)) - one for one in single] if number > 2 else []
        kept_in_all = (
            kept
            for kept in (*single, *all_but_one)
            if all(i and self._is_mixed(i, i - 1, kept) for i in positions)
        )
        return next(kept_in_all, None)

    def _is_mixed(self, position, earlier, kept):
        """Return whether an answer is right if these arguments are those of an earlier call."""
        case, before = self.cases[position], self.cases[earlier]
        mixed = tuple(before[k] if k in kept else case[k] for k in range(len(case)))
        predicted = attempt(np.asarray, predict(self.exercise.library, mixed), float)
        value = np.asarray(self.values[position], float)
        if predicted is None or predicted.shape != value.shape:
            return False
        return self._is_to_the_last(value, predicted)

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

    def looks_right(self, position):
        """Return whether an answer differs from the library's in later digits only."""
        right = self.right(position)
        return right is not None and looks_right(self.distance(position), right)

    def _size(self, position):
        """Return the largest entry of the library's answer, without its sign; 0 if there is
        none."""
        right = self.right(position)
        return 0.0 if right is None else largest_gap(right, 0)

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

    def _explains(self, mistake, recognised_in, wrong, everywhere=False):
        is_recognised = [
            mistake.seen is not None and attempt(mistake.seen, self.values[i], *self.cases[i])
            for i in recognised_in
        ]
        if is_recognised and all(is_recognised):
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
        n_right = sum(self._is_right(transform, i) for i in clearly_wrong)
        if 2 * n_right >= len(clearly_wrong):
            # A list of solutions in reverse order, for example: this is not what is wrong. But 0
            # degrees are 0 rad.
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
            Naming(
                self.exercise,
                [rounded(case, np.random.default_rng(seed), _LAST_BITS) for case in self.cases],
                self.values,
            )
            for seed in range(_NUDGES)
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
            return True if difference(value, predicted) <= 0.1 * between else None
        return same(value, predicted) and bool(difference(value, predicted) <= 0.1 * between)


def looks_right(distance, right):
    """Return whether an answer at a distance from the right one is off in later digits only."""
    return bool(0 < distance <= _FIRST_DIGITS * max(1, largest_gap(right, 0)))


def _is_array(argument):
    return isinstance(argument, np.ndarray)


def _within_a_revolution(case):
    """Return a case with the numbers in its arrays as angles between -pi and pi."""

    def wrapped(argument):
        return np.angle(np.exp(1j * argument)) if _is_array(argument) else argument

    return [wrapped(argument) for argument in case]


def _are_similar(case, other):
    """Return whether two cases are different and have arguments that differ by little."""
    pairs = list(zip(case, other, strict=True))
    if all(attempt(np.array_equal, a, b) for a, b in pairs):
        return False
    return all(
        same(a, b, tolerance=_SIMILAR) if isinstance(a, np.ndarray | float) else a == b
        for a, b in pairs
    )


def _has_small_numbers(case):
    """Return whether numbers in a case are small, or differ little from special ones."""
    return isinstance(case, SmallNumbers | NearlySpecial)


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
