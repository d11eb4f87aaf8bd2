"""Find the name of a mistake: those of the exercise first, then those that are tried for every
exercise."""

import copy
import itertools

import numpy as np

from course_lib.checks.format_numbers import ORDINALS
from course_lib.checks.mistake import Mistake
from course_lib.checks.special_cases import MadeCase
from course_lib.checks.tolerances import EXACT, PREDICTED
from course_lib.checks.wire import Seed

_MAX_ORDERED = 4  # entries, rows or columns, of which all orders are tried
_MAX_ENTRIES = 16  # of an answer, of which each is tried with the other sign
_MAX_LINES = 6  # rows or columns, of which each is tried with the other sign
_MIN_NUMBERS = 3  # numbers that differ: fewer agree with some transform by chance
_FIRST_DIGITS = 3e-3  # two or three digits: 22/7 for pi is off by 4e-4


def same(value, predicted, *arguments, tolerance=PREDICTED):
    """Return whether two answers are equal within a tolerance, absolute and relative to the size of
    `predicted`.

    Complex numbers, and anything that is not numbers, are equal to nothing. The arguments of the
    case are not used; see `alike` of an Exercise.
    """
    try:
        if np.iscomplexobj(value):
            return False
        value, predicted = np.asarray(value, float), np.asarray(predicted, float)
    except (TypeError, ValueError, OverflowError):
        return False
    if value.shape != predicted.shape:
        return False
    if not np.isfinite(predicted).all():
        return np.allclose(value, predicted, rtol=tolerance, atol=tolerance, equal_nan=True)
    with np.errstate(invalid="ignore", over="ignore"):
        return bool((np.abs(value - predicted) <= tolerance + tolerance * np.abs(predicted)).all())


def difference(value, predicted, *arguments):
    """Return the largest difference of two answers; inf if their shapes differ or nan stands
    elsewhere.

    The arguments of the case are not used; see `distance` of an Exercise.
    """
    value, predicted = np.asarray(value, float), np.asarray(predicted, float)
    if value.shape != predicted.shape:
        return np.inf
    if not np.array_equal(np.isfinite(value), np.isfinite(predicted)):
        return np.inf
    return _gap(value, predicted)


def attempt(formula, *arguments):
    """Return the value of a formula, or None if it raises: answers, and mistakes, may be numbers of
    any size."""
    try:
        return formula(*arguments)
    except Exception:
        return None


def predict(answer, case):
    """Return what a student with this mistake answers: None where the function raises, or does not
    apply."""
    return attempt(answer, *(_given(argument) for argument in case))


def _given(argument):
    return (
        np.random.default_rng(argument.number)
        if isinstance(argument, Seed)
        else copy.deepcopy(argument)
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
        self._rights = {}

    def mistake(self, failing, wrong):
        """Return the Mistake that accounts for all wrong answers, those at the positions `wrong`,
        or None.

        failing: the positions among them at which the property fails of which the message speaks;
        a mistake that is recognised in the answers, and not predicted, is looked for in these.

        Said first is what can be told from the answers themselves: rounding, float32, and digits
        cut off in whole numbers. Then comes a mistake of the exercise that predicts every answer,
        and then that only the first digits are right: such an answer is blamed for nothing else.
        At last, one that explains all answers is preferred to one that explains the wrong ones
        only; a few True or False, or signs, fit many mistakes by chance, so these must explain all.
        """
        own = self.exercise.mistakes
        of_digits = self._shortened(wrong)
        if of_digits is None and self._is_for_whole_numbers_only(wrong):
            of_digits = Mistake(*_ONLY_WHOLE)
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
        if self.has_few_values():
            return None
        for known in own:
            if self._explains(known, failing, wrong):
                return known
        return None

    def _predicts_all(self, mistake, wrong):
        """Return whether a function of the mistake predicts all wrong answers, and contradicts no
        other."""
        return any(
            self._accounts_for(mistake, answer, wrong, everywhere=True)
            for answer in mistake.answers
        )

    def _is_for_whole_numbers_only(self, wrong):
        """Return whether the answers are wrong in cases with whole numbers only, and right in all
        others."""
        of_floats = [i for i, case in enumerate(self.cases) if not _has_integers(case)]
        return bool(of_floats) and not set(of_floats) & set(wrong)

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
        if all(map(_is_whole, arrays)):
            return Mistake(*_WHOLE) if self._are_cut_off(arrays, wrong) else None
        in_float32 = all(np.array_equal(x, x.astype(np.float32), equal_nan=True) for x in arrays)
        if in_float32 and not all(map(_is_short, arrays)):
            return Mistake("the answer has the seven digits of float32", _FLOAT64)
        if not self._are_nearly_right(wrong):
            return None
        for k in range(1, 9):
            if all(np.array_equal(x, np.round(x, k), equal_nan=True) for x in arrays):
                return Mistake(f"the answer is rounded to {k} digits", _FEW_DIGITS)
        return None

    def _are_cut_off(self, arrays, wrong):
        """Return whether wrong answers, whole numbers all, are the right ones without the digits
        after the point."""
        if (
            not any(array.any() for array in arrays)
            or sum(arrays[i].size for i in wrong) < _MIN_NUMBERS
        ):
            return False
        rights = [self.right(i) for i in wrong]
        if all(right is None or _is_whole(right) for right in rights):
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
        return Mistake("the answer is right to its first digits only", _FEW_DIGITS)

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
        for name, hint, change in _OTHER_FORMS:
            form = attempt(change, right)
            if form is not None and _telling(form) and same(value, form):
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
        return sum(explained.values()) >= _MIN_NUMBERS

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
        """Return what a variant of a mistake answers to a case, or None."""
        case = self.cases[position]
        return (
            attempt(answer, self.right(position), *case)
            if isinstance(answer, _Changed)
            else predict(answer, case)
        )

    def _predicts(self, mistake, answer, position):
        """Return whether a variant predicts the answer to a case; None if it does not apply
        there."""
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
        between = _gap(predicted, right)
        rounding = 1e-13 * max(1, _gap(right, 0))
        if between <= rounding:
            return True if _gap(value, predicted) <= rounding else None
        return same(value, predicted) and bool(_gap(value, predicted) <= 0.1 * between)


def common_mistakes(naming):
    """Yield the Mistakes that are tried for every exercise: transforms of the right answer, and of
    the arguments."""
    exercise, values = naming.exercise, naming.values
    if isinstance(values[0], bool):
        for always in (True, False):
            yield Mistake(
                f"the answer is always {always}", _ALWAYS, lambda *case, always=always: always
            )
        return
    no_number = attempt(lambda value: np.isnan(value).all(), values[0])
    if len({str(value) for value in values}) == 1 < len(values) and not no_number:
        yield Mistake("the answer is the same for every input", _SAME, lambda *case: values[0])
    if exercise.library is None or naming.right(0) is None:
        return
    right = naming.right(0)
    folds = () if naming.has_few_values() else _folded(right)
    for name, hint, change in (
        *_OF_THE_ANSWER,
        *_in_other_order(right),
        *_of_other_sign(right),
        *folds,
    ):
        yield Mistake(name, hint, _Changed(lambda right, *case, change=change: change(right)))
    yield Mistake(*_WHOLE, seen=_cut_off)
    for k, argument in enumerate(exercise.arguments):
        for name, hint, change in _OF_A_CHANGE:
            yield Mistake(name.format(argument), hint, _Changed(_from(k, change)))
    if not exercise.tries_arguments:
        return
    for (i, one), (j, other) in itertools.combinations(enumerate(exercise.arguments), 2):
        yield Mistake(
            f"{one} and {other} have changed places",
            _ORDER,
            _asked(exercise.library, _swapped(i, j)),
        )
    numbers_first = sorted(
        enumerate(exercise.arguments),
        key=lambda numbered: attempt(np.ndim, naming.cases[0][numbered[0]]) or 0,
    )
    for k, argument in numbers_first:
        yield Mistake(
            f"{argument} is returned as it came", _RETURN, lambda *case, k=k: _numbers(case[k])
        )
        for name, hint, change in (*_OF_AN_ARGUMENT, *_of_an_entry(naming.cases[0][k])):
            yield Mistake(name.format(argument), hint, _asked(exercise.library, _at(k, change)))


def _has_integers(case):
    """Return whether an argument is a whole number, or an array of such, of type int."""
    numbers = [argument for argument in case if isinstance(argument, np.ndarray | int)]
    return any(np.asarray(number).dtype.kind == "i" for number in numbers)


def _is_short(array):
    """Return whether the numbers have few decimals, as 0.125 has, which is the same in float32."""
    return np.array_equal(array, np.round(array, 5), equal_nan=True)


def _is_cut_off(array, right):
    """Return whether whole numbers are those before the point, up to rounding."""
    smaller = np.abs(array) <= np.abs(right) + EXACT
    return bool(smaller.all() and (np.abs(right - array) < 1).all())


def _is_whole(array):
    return np.array_equal(array, np.round(array), equal_nan=True)


def _gap(value, other):
    """Return the largest difference of two answers, in which nan and inf stand at the same
    entries."""
    return np.nan_to_num(np.abs(np.asarray(value, float) - other), posinf=0).max(initial=0)


def _telling(numbers):
    """Return whether numbers are equal to others hardly by chance: a single 0 or 1 often is, and so
    is nan."""
    return np.isfinite(numbers).all() and (
        np.size(numbers) >= _MIN_NUMBERS or not np.isin(numbers, (-1, 0, 1)).all()
    )


class _Changed:
    """A mistake in the answer itself: change(right answer, *arguments) is returned in its place,
    unless it is None."""

    def __init__(self, change):
        self.change = change

    def __call__(self, right, *case):
        other = self.change(right, *case)
        return None if other is None else _unless_equal(np.asarray(other, float), right)


def _in_other_order(right):
    """Yield the names, hints and changes of axes, or entries, of the answer in another order, if
    they are few."""
    for axis, what in enumerate(_AXES.get(np.ndim(right), ())):
        n = np.shape(right)[axis]
        for order in itertools.permutations(range(n)) if 1 < n <= _MAX_ORDERED else ():
            yield (
                f"{what} of the answer are in another order",
                _ENTRIES,
                lambda x, o=order, a=axis: np.take(x, o, a),
            )


def _of_other_sign(right):
    """Yield the names, hints and changes of an entry, a row or a column with another sign, if they
    are few."""
    shape, parts = np.shape(right), []
    if 1 < np.size(right) <= _MAX_ENTRIES:
        parts = [(f"entry {list(index)}", index) for index in np.ndindex(shape)]
    if len(shape) == 2 and max(shape) <= _MAX_LINES:
        parts += [(f"the {ORDINALS[i]} row", i) for i in range(shape[0])]
        parts += [(f"the {ORDINALS[j]} column", np.s_[:, j]) for j in range(shape[1])]
    for what, index in parts:

        def negated(x, index=index):
            x = x.copy()
            x[index] *= -1
            return x

        yield f"{what} of the answer has the wrong sign", _SIGN, negated


def _folded(right):
    """Yield the names, hints and changes of angles, in all of the answer or in one column, on half
    of the circle."""
    n = np.shape(right)[-1] if np.ndim(right) else 0
    columns = [..., *((..., j) for j in range(n if n <= _MAX_LINES else 0))]
    for index, (name, fold) in itertools.product(columns, _FOLDS):

        def folded(x, index=index, fold=fold):
            x = np.array(x)
            x[index] = fold(x[index])
            return x

        yield name, _HALF, folded


def _asked(right, change):
    """Return a function that answers rightly, but to changed arguments; None where these are the
    same."""

    def answer(*case):
        other = change(case)
        return (
            None
            if other is None
            else _unless_equal(
                *(np.asarray(right(*arguments), float) for arguments in (other, case))
            )
        )

    return answer


def _unless_equal(other, exact):
    """Return the other answer; None if it has another shape, or is the same.

    Whether it is the same goes by the size of the numbers: 1e-13 is not 0 among such numbers.
    """
    size = np.abs(exact[np.isfinite(exact)]).max(initial=0)
    rounding = 1e-12 * (min(size, 1) or 1)
    if other.shape != exact.shape or np.allclose(
        other, exact, rtol=1e-9, atol=rounding, equal_nan=True
    ):
        return None
    return other


def _from(k, change):
    def changed(right, *case):
        if np.shape(case[k]) != np.shape(right):
            raise ValueError("no argument that the answer changes")
        return change(right, _numbers(case[k]))

    return changed


def _of_an_entry(argument):
    """Yield the names, hints and changes of a vector: another sign of an entry, 0 for it, another
    order."""
    vector = attempt(_numbers, argument)
    n = len(vector) if np.ndim(vector) == 1 else 0
    for j in range(n if 1 < n <= _MAX_LINES else 0):
        yield (
            f"entry [{j}] of {{}} has the wrong sign",
            _SIGN,
            lambda x, j=j: x * np.where(np.arange(n) == j, -1, 1),
        )
        yield f"entry [{j}] of {{}} is not used", _SAME, lambda x, j=j: x * (np.arange(n) != j)
    for order in itertools.permutations(range(n)) if 1 < n <= _MAX_ORDERED else ():
        yield (
            "the entries of {} are in another order",
            _ENTRIES,
            lambda x, order=order: x[list(order)],
        )


def _swapped(i, j):
    def change(case):
        case = list(case)
        case[i], case[j] = case[j], case[i]
        return case

    return change


def _at(k, change):
    def changed(case):
        return [
            change(_numbers(argument)) if i == k else argument for i, argument in enumerate(case)
        ]

    return changed


def _numbers(argument):
    """Return a float, or an array of numbers, which may come as a list; raises for all else, as for
    a count."""
    array = np.asarray(argument)
    if array.dtype.kind not in ("fi" if array.ndim else "f"):
        raise TypeError("not numbers to compute with")
    return array if array.ndim else argument


def _cut_off(value, *case):
    """Return whether an answer to lists or arrays of whole numbers is made of such."""
    has_whole_numbers = any(
        attempt(np.asarray, argument).dtype.kind == "i"
        for argument in case
        if isinstance(argument, np.ndarray | list)
    )
    return (
        has_whole_numbers
        and np.size(value) >= _MIN_NUMBERS
        and np.array_equal(value, np.trunc(value))
    )


def _transposed(M):
    return _of_dimension(M, 2).T


def _inverse(M):
    return np.linalg.inv(_of_dimension(M, 2))


def _reversed(x):
    return np.asarray(x)[..., ::-1]


def _negated_bits(x):
    if not np.isin(x, (0, 1)).all():
        raise ValueError("not True or False")
    return 1 - x


def _halves_swapped(x):
    if np.ndim(x) not in (1, 2) or len(x) % 2 or len(x) < 4:
        raise ValueError("no halves")
    return np.roll(x, len(x) // 2, axis=0)


def _no_matrix(x):
    """Return x unless it is a matrix: nobody negates a pose, or an arm, or takes 0 for it."""
    if np.ndim(x) == 2:
        raise ValueError("a matrix")
    return x


def _of_dimension(x, n):
    if np.ndim(x) != n:
        raise ValueError(f"not of {n} dimensions")
    return x


_ALWAYS = "Print each comparison for the case above, and return what it gives."
_ORDER = "Compare the order of the arguments with the task."
_RETURN = "Return the result."
_SAME = "Where does your function use its arguments?"
_RADIANS = "Angles are in radians throughout."
_SIGN = "Compare the sign with an example that you can do by hand."
_ROWS = "Rows and columns have changed places."
_FACTOR = "Look for a factor 2."
_UNIT = "In which unit does the task ask for the answer?"
_FRAMES = "Which frame do you start from, and in which do you end?"
_ENTRIES = "Compare the order of the entries with the task."
_HALVES = "Compare the order of the entries with the task: which three come first?"
_HALF = "np.arctan2(y, x) takes sine and cosine separately, and finds angles on the whole circle."
_COPIES = (
    "An array that changes in place changes wherever it stands: does a list hold it more than once?"
)

_WHOLE = (
    "digits after the point are cut off",
    (
        "np.zeros_like(a) and a.copy() hold whole numbers only if a does. np.zeros(np.shape(a)) has"
        " room for digits."
    ),
)

_ONLY_WHOLE = (
    "the answer is wrong for whole numbers only: digits after the point are cut off",
    (
        "np.array(a), a.copy() and np.zeros_like(a) hold whole numbers only if a does. What becomes"
        " of the digits that you write into such an array?"
    ),
)

_FLOAT64 = (
    "Which line makes float32 of numbers? numpy computes with 16 digits unless it is told"
    " otherwise."
)

_FEW_DIGITS = (
    "Compute with all digits: no np.round, no small steps in place of a derivative, and pi is "
    "np.pi."
)

_OF_THE_ANSWER = (
    ("the answer is the transpose of what it should be", _ROWS, _transposed),
    ("the sign of the answer is changed", _SIGN, np.negative),
    ("the answer is the inverse of what it should be", _FRAMES, _inverse),
    ("the answer is twice what it should be", _FACTOR, lambda x: 2 * x),
    ("the answer is half of what it should be", _FACTOR, lambda x: x / 2),
    ("the answer is in degrees", _RADIANS, np.rad2deg),
    ("the answer is converted from degrees to radians", _RADIANS, np.deg2rad),
    ("the entries of the answer are in reverse order", _ENTRIES, _reversed),
    ("the two halves of the answer have changed places", _HALVES, _halves_swapped),
    ("the signs of the answer are lost", "Which line loses the sign?", np.abs),
    (
        "0 stands where nan is asked for",
        "Could 0 be a right answer? What would it say here?",
        np.nan_to_num,
    ),
    ("True and False have changed places", "What does True mean in the task?", _negated_bits),
    ("each item is the last one", _COPIES, lambda x: x[[-1] * len(x)]),
    ("each item after the first is the last one", _COPIES, lambda x: x[[0] + [-1] * (len(x) - 1)]),
    ("the answer is the square of what it should be", "Where does a root belong?", np.square),
    (_WHOLE[0], _WHOLE[1], np.trunc),
    ("the answer is 100 times what it should be", _UNIT, lambda x: 100 * x),
    ("the answer is 1000 times what it should be", _UNIT, lambda x: 1000 * x),
)

_FOLDS = (
    (
        "an angle comes from arcsin, which knows half of the circle only",
        lambda x: np.arcsin(np.sin(x)),
    ),
    ("a sign is lost, as that of an angle by arccos", lambda x: np.arccos(np.cos(x))),
    (
        "an angle comes from arctan, which knows half of the circle only",
        lambda x: np.arctan(np.tan(x)),
    ),
)

_OF_A_CHANGE = (  # of an argument, to which the answer adds something
    (
        "only the change of {} is returned",
        "What is asked for: the change, or what comes after it?",
        np.subtract,
    ),
    ("the change of {} has the opposite sign", _SIGN, lambda right, before: 2 * before - right),
)

_AXES = {1: ("the entries",), 2: ("the rows", "the columns")}

_OF_AN_ARGUMENT = (
    ("{} is taken for degrees", _RADIANS, np.deg2rad),
    ("{} is converted to degrees", _RADIANS, np.rad2deg),
    ("the sign of {} is changed", _SIGN, lambda x: _no_matrix(-x)),
    ("the answer is that for the transpose of {}", _ROWS, _transposed),
    ("the answer is that for the inverse of {}", _FRAMES, _inverse),
    ("{} is doubled", _FACTOR, lambda x: _no_matrix(2 * x)),
    ("{} is halved", _FACTOR, lambda x: _no_matrix(x / 2)),
    ("the entries of {} are in reverse order", _ENTRIES, _reversed),
    ("the two halves of {} have changed places", _HALVES, _halves_swapped),
    ("the signs of {} are lost", "Which line loses the sign?", lambda x: _no_matrix(np.abs(x))),
    ("{} is not used: the answer is that for 0", _SAME, lambda x: _no_matrix(0.0 * x)),
    (
        "{} is not used: the answer is that for the identity",
        _SAME,
        lambda x: 0 * x + np.eye(len(_of_dimension(x, 2))),
    ),
)

_OTHER_FORMS = (
    (
        "an axis of length 1 is lost",
        "One item, too, is a row of the answer. Which line drops the axis?",
        np.squeeze,
    ),
    (
        "only the first item is returned",
        "Collect the results of all items, and return them together.",
        lambda x: x[0],
    ),
    (
        "only the last item is returned",
        "Is the result overwritten in each pass of the loop?",
        lambda x: x[-1],
    ),
    ("rows and columns have changed places", "Compare the shape with the task.", _transposed),
    (
        "only the upper left block is returned",
        "The last row and column belong to the answer.",
        lambda x: x[:-1, :-1],
    ),
    ("only the last column is returned", "The whole matrix is asked for.", lambda x: x[:-1, -1]),
    ("the last row is missing", "The whole matrix is asked for.", lambda x: x[:-1]),
    ("only the first half is returned", "Both halves are asked for.", lambda x: x[: len(x) // 2]),
    ("only the second half is returned", "Both halves are asked for.", lambda x: x[len(x) // 2 :]),
    ("the last item is missing", "How many items are there, both ends included?", lambda x: x[:-1]),
    ("the first item is missing", "How many items are there, both ends included?", lambda x: x[1:]),
    ("the answer is flattened", "Keep the rows.", np.ravel),
    (
        "there is one pair of brackets too many",
        "Print your answer and its np.shape.",
        lambda x: x[None],
    ),
)
