"""The mistakes that are tried for every exercise: transforms of the right answer, and of the
arguments."""

import itertools

import numpy as np

from course_lib.checks.comparisons import attempt, same
from course_lib.checks.format_numbers import ORDINALS
from course_lib.checks.mistake import Mistake

_MAX_ORDERED = 4  # entries, rows or columns, of which all orders are tried
_MAX_ENTRIES = 16  # of an answer, of which each is tried with the other sign
_MAX_LINES = 6  # rows or columns, of which each is tried with the other sign
MIN_NUMBERS = 3  # numbers that differ: fewer agree with some transform by chance


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
        *_in_reverse_order(right),
        *_in_other_order(right),
        *_of_other_sign(right),
        *folds,
    ):
        yield Mistake(
            name,
            hint,
            ChangedAnswer(lambda right, *case, change=change: change(right)),
            alike=_alike_in_radians(exercise) if change is np.rad2deg else None,
        )
    yield Mistake(*CUT_OFF, seen=_cut_off)
    for k, argument in enumerate(exercise.arguments):
        first = naming.cases[0][k]
        for name, hint, change in _OF_A_CHANGE:
            yield Mistake(name.format(argument), hint, ChangedAnswer(_from(k, change, first)))
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
    for names, change in _kept_from(naming.cases[0], exercise.arguments):
        yield Mistake(
            f"the answer is that for {names} of the first call",
            _KEPT,
            _asked(exercise.library, change),
        )
    for k, argument in numbers_first:
        first = naming.cases[0][k]
        yield Mistake(
            f"{argument} is returned as it came",
            _RETURN,
            lambda *case, k=k, first=first: _numbers(case[k], first),
        )
        for name, hint, change in (*_OF_AN_ARGUMENT, *_of_an_entry(first)):
            changed = _asked(exercise.library, _at(k, change, first))
            yield Mistake(name.format(argument), hint, changed)


def _alike_in_radians(exercise):
    """Return how answers in degrees are compared with each other; None if number by number.

    An exercise that does not compare number by number knows of full revolutions, which are 2 pi and
    not 360, or compares what the angles, in radians, lead to.
    """
    if exercise.alike is same:
        return None
    return lambda value, predicted, *case: exercise.alike(
        np.deg2rad(value), np.deg2rad(predicted), *case
    )


class ChangedAnswer:
    """A mistake in the answer itself: change(right answer, *arguments) is returned in its place,
    unless it is None."""

    def __init__(self, change):
        self.change = change

    def __call__(self, right, *case):  # noqa: D102
        other = self.change(right, *case)
        return None if other is None else _unless_equal(np.asarray(other, float), right)


def is_whole(array):
    """Return whether all numbers are whole; nan counts as whole."""
    return np.array_equal(array, np.round(array), equal_nan=True)


def is_telling(numbers):
    """Return whether numbers are equal to others hardly by chance: a single 0 or 1 often is, and so
    is nan."""
    return np.isfinite(numbers).all() and (
        np.size(numbers) >= MIN_NUMBERS or not np.isin(numbers, (-1, 0, 1)).all()
    )


def _cut_off(value, *case):
    """Return whether an answer to lists or arrays of whole numbers is made of such."""
    has_whole_numbers = any(
        attempt(np.asarray, argument).dtype.kind == "i"
        for argument in case
        if isinstance(argument, np.ndarray | list)
    )
    return (
        has_whole_numbers
        and np.size(value) >= MIN_NUMBERS
        and np.array_equal(value, np.trunc(value))
    )


def _numbers(argument, first):
    """Return a float, or an array of numbers, which may come as a list; raises for all else, as for
    a count.

    first: the argument in the first case. If it is a float, a whole number is none that counts.
    """
    array = np.asarray(argument)
    is_number = array.dtype.kind == "i" and (array.ndim > 0 or isinstance(first, float))
    if array.dtype.kind != "f" and not is_number:
        raise TypeError("not numbers to compute with")
    return array if array.ndim else float(argument)


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


# ---- of the answer ----


def _in_reverse_order(right):
    """Yield the names, hints and changes of parts of the answer from the last to the first."""
    if np.ndim(right) == 2:
        axes = {"the rows": 0, "the columns": 1}
    else:
        axes = {"the entries": -1}
    for what, axis in axes.items():
        if np.ndim(right) == 2 and np.shape(right)[axis] == 2:
            continue  # two rows that have changed places are in another order
        yield (
            f"{what} of the answer are in reverse order",
            f"Compare the order of {what} with the task.",
            lambda x, axis=axis: np.flip(x, axis),
        )


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
    for index, (name, hint, fold) in itertools.product(columns, _FOLDS):

        def folded(x, index=index, fold=fold):
            x = np.array(x)
            x[index] = fold(x[index])
            return x

        yield name, hint, folded


def _from(k, change, first):
    def changed(right, *case):
        if np.shape(case[k]) != np.shape(right):
            raise ValueError("no argument that the answer changes")
        return change(right, _numbers(case[k], first))

    return changed


# ---- of the arguments ----


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


def _swapped(i, j):
    def change(case):
        case = list(case)
        case[i], case[j] = case[j], case[i]
        return case

    return change


def _at(k, change, first):
    """Return the change of a case that changes its argument k; first: this argument in the first
    case."""

    def changed(case):
        return [*case[:k], change(_numbers(case[k], first)), *case[k + 1 :]]

    return changed


def _kept_from(first, names):
    """Yield some of the arguments, in words, and the change of a case that puts those of the first
    case in their places."""
    for number in range(1, len(names)):
        for kept in itertools.combinations(range(len(names)), number):

            def changed(case, kept=kept):
                return [first[k] if k in kept else case[k] for k in range(len(names))]

            yield " and ".join(names[k] for k in kept), changed


def _of_an_entry(argument):
    """Yield the names, hints and changes of a vector: another sign of an entry, 0 for it, another
    order."""
    vector = attempt(_numbers, argument, argument)
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


# ---- transforms ----


def _transposed(M):
    return _of_dimension(M, 2).T


def _inverse(M):
    return np.linalg.inv(_of_dimension(M, 2))


def _reversed(x):
    return np.asarray(x)[..., ::-1]


def _flattened(x):
    if np.ndim(x) < 2:
        raise ValueError("no rows")
    return np.ravel(x)


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


# ---- hints ----

_ALWAYS = "Print each comparison for the case above, and return what it gives."
_ORDER = (
    "Your answer is the right one for these two arguments exchanged. Where does your function use "
    "the one, and where the other?"
)
_RETURN = "Return the result."
_KEPT = (
    "Called alone with the input below, does your function give this answer? A default such as "
    "x=[], and a list outside the function, outlive the call: what stands in them?"
)
_SAME = "Where does your function use its arguments?"
_RADIANS = "Angles are in radians throughout."
_SIGN = "Compare the sign with an example that you can do by hand."
_ROWS = "Rows and columns have changed places."
_FACTOR = "Look for a factor 2."
_UNIT = "In which unit does the task ask for the answer?"
_FRAMES = "Which frame do you start from, and in which do you end?"
_ENTRIES = "Compare the order of the entries with the task."
_HALVES = "Compare the order of the entries with the task: which three come first?"
_NEXT_TO_A_COSINE = (
    "arccos gives angles from 0 to pi only. Which second number, besides the cosine, tells the "
    "sign of the angle?"
)
_NEXT_TO_A_SINE = (
    "arcsin gives angles from -pi/2 to pi/2 only. Which second number, besides the sine, tells in "
    "which half of the circle the angle lies?"
)
_QUOTIENT = (
    "arctan gives angles from -pi/2 to pi/2 only, since a quotient is the same for opposite "
    "directions. Which two numbers does the quotient lose the signs of?"
)
_COPIES = (
    "An array that changes in place changes wherever it stands: does a list hold it more than once?"
)
CUT_OFF = (
    "digits after the point are cut off",
    (
        "Which line makes integers of your numbers: int(...), //, or an array made from "
        "integers, which holds integers, too?"
    ),
)
_INTEGERS = (
    "Follow the digits after the point through your function. Which operation, or which array made "
    "from integers, cuts them off?"
)
WRONG_FOR_INTEGERS = ("the answer is wrong for {} only", _INTEGERS)
USE_FLOAT64 = (
    "Which line makes float32 of numbers? numpy computes with 16 digits unless a line asks"
    " otherwise."
)
USE_ALL_DIGITS = (
    "Compute with all digits. Is there a rounding, a small step in place of a derivative, a short "
    "number for pi, or something small that is added?"
)


# ---- names, hints and transforms ----

_OF_THE_ANSWER = (
    ("the answer is the transpose of what it should be", _ROWS, _transposed),
    ("the sign of the answer is changed", _SIGN, np.negative),
    ("the answer is the inverse of what it should be", _FRAMES, _inverse),
    ("the answer is twice what it should be", _FACTOR, lambda x: 2 * x),
    ("the answer is half of what it should be", _FACTOR, lambda x: x / 2),
    ("the answer is in degrees", _RADIANS, np.rad2deg),
    ("the answer is converted from degrees to radians", _RADIANS, np.deg2rad),
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
    (CUT_OFF[0], CUT_OFF[1], np.trunc),
    ("the answer is 100 times what it should be", _UNIT, lambda x: 100 * x),
    ("the answer is 1000 times what it should be", _UNIT, lambda x: 1000 * x),
)
_FOLDS = (
    (
        "an angle comes from arcsin, which knows half of the circle only",
        _NEXT_TO_A_SINE,
        lambda x: np.arcsin(np.sin(x)),
    ),
    (
        "a sign is lost, as that of an angle by arccos",
        _NEXT_TO_A_COSINE,
        lambda x: np.arccos(np.cos(x)),
    ),
    (
        "an angle comes from arctan, which knows half of the circle only",
        _QUOTIENT,
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
OTHER_FORMS = (
    (
        "an axis of length 1 is lost",
        "An axis is a dimension of the array here: if there is one item only, the answer still has "
        "a place for it. Which line, or which branch for such an input, drops the dimension?",
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
    (  # of a matrix; poses and numbers are items, below
        "the last row is missing",
        "The whole matrix is asked for.",
        lambda x: _of_dimension(x, 2)[:-1],
    ),
    ("only the first half is returned", "Both halves are asked for.", lambda x: x[: len(x) // 2]),
    ("only the second half is returned", "Both halves are asked for.", lambda x: x[len(x) // 2 :]),
    ("the last item is missing", "How many items are there, both ends included?", lambda x: x[:-1]),
    ("the first item is missing", "How many items are there, both ends included?", lambda x: x[1:]),
    ("the answer is flattened", "Keep the rows.", _flattened),
    (
        "there is one pair of brackets too many",
        "Print your answer and its np.shape.",
        lambda x: x[None],
    ),
)
