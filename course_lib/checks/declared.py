"""An exercise whose right answer is the library's: it says what its arguments are, what should hold
in words, and which mistakes there are.

The cases follow from the kinds of the arguments, and one property follows: the answer is the
library's, within the tolerance of the task. Most exercises are of this form. One that has several
right answers is an `Exercise` with properties of its own.
"""

import functools

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.comparisons import difference
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.kinds import OWN_CASES, cases_of, special_case, sweeps_of
from course_lib.checks.mistake import Mistakes
from course_lib.checks.naming import looks_right
from course_lib.checks.reasons import Finding, first_entry_off
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import compared, first_off
from course_lib.checks.wire import write

# Just below the 1e-12 that tasks name, so that a case at 1e-12 counts and one at 9.9e-13 does not:
# there an error of a thousandth comes near the rounding of numbers near 1.
_SMALLEST = 0.995e-12
_MAX_REMEMBERED = 2000  # right answers of an exercise: those to a few sets of cases
OF_THE_KINDS = object()  # in place of the function `special`
_NEARLY = 1000  # times the allowed error: so near, a message speaks of the error


def declared(
    name,
    points,
    arguments,
    library,
    says,
    hints,
    mistakes,
    *,
    cases=(),
    tolerance=None,
    allowed=None,
    distance=difference,
    scale=None,
    otherwise=None,
    found=None,
    properties=(),
    reads=None,
    sweeps=(),
    special=OF_THE_KINDS,
    **more,
):
    """Return an Exercise.

    Parameters
    ----------
    name : str
    points : int
    arguments : dict
        {name: Kind}.
    library : callable
        A right answer.
    says : str
        What should hold, as a sentence that can follow "What should hold:".
    hints : tuple of str
    mistakes : tuple of Mistake
        In the order in which they are tried.
    cases : tuple of tuple, or callable
        Cases beside those of the kinds, asked first; or cases(rng).
    tolerance : float, optional
        The error that a right answer may have, as the task states it; else EXACT. It is relative to
        the largest entry of the answer where that is above 1.
    allowed : callable, optional
        allowed(*arguments): the error that the answer to this case may have, where the task states
        more than one bound.
    distance : callable
        distance(value, right, *arguments): how far an answer is from the right one.
    scale : callable, optional
        scale(*arguments): how large the effect of the arguments is. Where it is small the error may
        be a thousandth of it at most, so that small numbers count.
    otherwise : Question or callable, optional
        What is asked about answers that no mistake explains; as of a Property.
    found : callable, optional
        found(value, *arguments): what was found instead, in words; usually both answers. What
        `compared` and `first_off` return is joined to texts with +, so that it keeps by how much
        the answer is off; see Finding in reasons.py.
    properties : tuple of Property
        What is examined before; seldom needed.
    reads : callable, optional
        As `returns` of an Exercise; usually it reads the shape of the library's answer.
    sweeps : tuple of Sweep
        Beside those of the kinds.
    special : callable, optional
        As of an Exercise. Without it, all arguments are special values of their kinds, unless the
        exercise makes its cases itself; None if there are no such cases.
    **more
        As of an Exercise.

    Returns
    -------
    Exercise
    """
    kinds = tuple(arguments.values())
    makes_own_cases = any(kind.drawn is OWN_CASES.drawn for kind in kinds)
    usual = EXACT if tolerance is None else tolerance
    is_stated = tolerance is not None or allowed is not None

    def all_cases(rng):
        own = cases(rng) if callable(cases) else list(cases)
        return own if makes_own_cases else [*own, *cases_of(kinds, rng)]

    if special is OF_THE_KINDS:
        special = None if makes_own_cases else functools.partial(special_case, kinds)

    @_remembered
    def right_answer(*case):
        return np.array(library(*case), float)

    def error_of(right, *case):
        """Return the error that an answer may have."""
        if allowed is not None:
            return allowed(*case)
        error = usual * max(1, np.nan_to_num(np.abs(right), posinf=0).max(initial=0))
        size = np.inf if scale is None else scale(*case)
        if size > _SMALLEST:
            error = min(error, 1e-3 * size)
        return error

    def is_right(value, *case):
        right = right_answer(*case)
        return distance(value, right, *case) <= error_of(right, *case)

    def in_words(value, *case):
        right = right_answer(*case)
        if right.ndim == 2:
            return first_off(value, right)
        return "The right answer is " + compared(right, value) + "."

    def remark(value, *case):
        """Return what was found and, of a nearly right answer, that the task says which error is
        allowed, if it does."""
        finding = Finding() + (found or in_words)(value, *case)
        right = right_answer(*case)
        gap = distance(value, right, *case)
        is_nearly_right = gap < _NEARLY * error_of(right, *case)
        if looks_right(gap, right) and finding.off_by is None and distance is difference:
            finding += " " + first_entry_off(value, right, error_of(right, *case))
        if is_stated and is_nearly_right:
            finding += " The task says how large the error may be."
        return finding

    is_the_library_s = Property(says, is_right, remark, otherwise=otherwise, compares=True)
    return Exercise(
        name=name,
        points=points,
        arguments=tuple(arguments),
        cases=all_cases,
        returns=reads or numbers(lambda *case: right_answer(*case).shape),
        properties=(*properties, is_the_library_s),
        hints=hints,
        library=library,
        tolerance=tolerance,
        distance=distance,
        sweeps=(*sweeps, *sweeps_of(kinds)),
        angles=tuple(name for name, kind in arguments.items() if kind.angle),
        small=tuple(name for name, kind in arguments.items() if kind.small),
        free=tuple(name for name, kind in arguments.items() if kind.free),
        special=special,
        mistakes=Mistakes(mistakes),
        **more,
    )


def _remembered(right_answer):
    """Return a function with a memory of its last results, arrays that nobody can change.

    How an answer is read, whether it is right and which error it may have all need the right one.
    """

    @functools.wraps(right_answer)
    def ask(*case):
        key = write(case)
        if key not in results:
            right = right_answer(*case)
            right.flags.writeable = False
            if len(results) == _MAX_REMEMBERED:
                del results[next(iter(results))]
            results[key] = right
        return results[key]

    results = {}
    return ask
