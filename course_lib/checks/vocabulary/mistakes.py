"""Common mistakes, made from the right function.

Each function takes `right(*arguments)`, which returns the right answer, and returns a Mistake; an exercise can give it
a more specific `name` and `hint`. A mistake does not apply to a case in which it changes nothing.
"""

import itertools

import numpy as np

from course_lib.checks.exercise import Mistake, Property
from course_lib.checks.vocabulary.comparisons import near


def _changed(right, change):
    """Return the right answer changed by `change`; None if that makes no difference."""

    def answer(*case):
        exact = np.asarray(right(*case), float)
        other = change(exact)
        return None if other.shape == exact.shape and np.allclose(other, exact, rtol=1e-9, atol=1e-12) else other

    return answer


def _with_argument(right, position, change):
    """Return the right answer for other arguments: change(argument) at this position."""
    return lambda *case: right(*(change(a) if i == position else a for i, a in enumerate(case)))


def transposed(right, name="the transpose is returned", hint="Rows and columns have changed places."):
    """Return the mistake of an answer that is the transpose of the right one.

    Examples
    --------
    >>> transposed(lambda R: R).answers[0](np.array([[0, -1], [1, 0]]))
    array([[ 0.,  1.],
           [-1.,  0.]])
    """
    return Mistake(name, hint, _changed(right, np.transpose))


def inverted(right, name="the inverse is returned", hint="Which frame do you start from, and in which do you end?"):
    """Return the mistake of an answer that is the inverse of the right one.

    Examples
    --------
    >>> inverted(lambda T: T).answers[0](np.diag([2.0, 4.0]))
    array([[0.5 , 0.  ],
           [0.  , 0.25]])
    """
    return Mistake(name, hint, _changed(right, np.linalg.inv))


def negated(right, name="the sign is changed", hint="Compare the sign with an example that you can do by hand."):
    """Return the mistake of an answer with the opposite sign.

    Examples
    --------
    >>> mistake = negated(lambda x: x)
    >>> float(mistake.answers[0](2.0)), mistake.answers[0](0.0)  # at zero the sign changes nothing
    (-2.0, None)
    """
    return Mistake(name, hint, _changed(right, np.negative))


def doubled(right, name="the answer is twice what it should be", hint="Look for a factor 2."):
    """Return the mistake of an answer that is twice the right one.

    Examples
    --------
    >>> float(doubled(lambda x: x).answers[0](3.0))
    6.0
    """
    return Mistake(name, hint, _changed(right, lambda x: 2 * x))


def halved(right, name="the answer is half of what it should be", hint="Look for a factor 1/2."):
    """Return the mistake of an answer that is half the right one.

    Examples
    --------
    >>> float(halved(lambda x: x).answers[0](3.0))
    1.5
    """
    return Mistake(name, hint, _changed(right, lambda x: x / 2))


def in_degrees(right, name="the answer is in degrees", hint="Angles are in radians throughout."):
    """Return the mistake of an answer in degrees.

    Examples
    --------
    >>> float(in_degrees(lambda x: x).answers[0](np.pi))
    180.0
    """
    return Mistake(name, hint, _changed(right, np.rad2deg))


def argument_degrees(
    right, position=0, name="the angle is taken for degrees", hint="Angles are in radians throughout."
):
    """Return the mistake of converting an argument as if it were in degrees.

    Examples
    --------
    >>> float(argument_degrees(np.sin).answers[0](90.0))
    1.0
    """
    return Mistake(name, hint, _with_argument(right, position, np.deg2rad))


def degrees_mixed_up(right, position):
    """Return the mistake of converting an argument from degrees or to degrees.

    Examples
    --------
    >>> [round(float(answer(1.0)), 4) for answer in degrees_mixed_up(lambda angle: angle, 0).answers]
    [0.0175, 57.2958]
    """
    return Mistake(
        "degrees and radians are mixed up",
        "Angles are radians everywhere: no np.deg2rad, no np.rad2deg.",
        *(_with_argument(right, position, convert) for convert in (np.deg2rad, np.rad2deg)),
    )


def argument_returned(position=0, name="the argument is returned as it came", hint="Return the result."):
    """Return the mistake of returning an argument unchanged.

    Examples
    --------
    >>> argument_returned(position=1).answers[0]("a", "b")
    'b'
    """
    return Mistake(name, hint, lambda *case: case[position])


def arguments_swapped(
    right, i=0, j=1, name="two arguments have changed places", hint="Compare the order with the task."
):
    """Return the mistake of exchanging the arguments at positions i and j.

    Examples
    --------
    >>> arguments_swapped(lambda a, b: a - b).answers[0](5, 3)
    -2
    """

    def answer(*case):
        swapped = list(case)
        swapped[i], swapped[j] = case[j], case[i]
        return right(*swapped)

    return Mistake(name, hint, answer)


def halves_swapped(
    right, name="the two halves have changed places", hint="Twists are (omega, v): the rotation comes first.", axis=0
):
    """Return the mistake of exchanging the halves of a twist, or of a matrix of twists along `axis`.

    Examples
    --------
    >>> halves_swapped(lambda twist: twist).answers[0]([0, 0, 1, 5, 6, 7])
    array([5., 6., 7., 0., 0., 1.])
    """
    return Mistake(name, hint, _changed(right, lambda x: np.roll(x, x.shape[axis] // 2, axis)))


def wrong_steps(right):
    """Return the mistakes in the last line of a function that returns joint angles, its first argument, after one step.

    Examples
    --------
    >>> [mistake.answers[0](1.0, 0.5) for mistake in wrong_steps(lambda q, step: q + step)]
    [0.5, 0.5, 1.0]
    """
    return (
        Mistake(
            "the step leads away from the target",
            "Is the error the target minus what is reached, or the other way round? The step has one sign, not two.",
            lambda q, *rest: 2 * q - right(q, *rest),
        ),
        Mistake(
            "only the step is returned",
            "The answer is the joint angles after the step.",
            lambda q, *rest: right(q, *rest) - q,
            lambda q, *rest: q - right(q, *rest),
        ),
        Mistake("q is returned as it came: nothing moves", "Add the step to it.", lambda q, *rest: q),
    )


def entry_by_entry(
    wrong, name="* or ** works entry by entry", hint="In numpy the product of matrices is @; M ** 2 squares each entry."
):
    """Return the mistake of entrywise products in place of matrix products; wrong(*arguments) has them.

    Examples
    --------
    >>> entry_by_entry(lambda A, B: A * B).answers[0](np.eye(2), np.full((2, 2), 3))
    array([[3., 0.],
           [0., 3.]])
    """
    return Mistake(name, hint, wrong)


def series_cut(right, matrix):
    """Return the mistake of summing too few terms of the exponential series of matrix(*arguments), if that shows.

    Examples
    --------
    >>> mistake = series_cut(lambda x: np.exp([[x]]), lambda x: np.array([[x]]))
    >>> [float(answer(1.0)[0, 0]) for answer in mistake.answers[:3]]  # 2, 3 and 4 terms
    [2.0, 2.5, 2.6666666666666665]
    """

    def answer(terms):
        def partial_sum(*case):
            M = matrix(*case)
            steps = range(1, terms)
            total = sum(itertools.accumulate(steps, lambda term, k: term @ M / k, initial=np.eye(len(M))))
            return None if np.allclose(total, right(*case), rtol=1e-11, atol=1e-11) else total

        return partial_sum

    return Mistake(
        "the series of the exponential is cut after some terms",
        "A few terms are enough for small angles only. The closed formula is the sum of all of them.",
        *(answer(terms) for terms in range(2, 21)),
    )


def partial_sum(M, terms):
    """Return the sum of so many terms of the exponential series of M; None if it has converged."""
    total = sum(itertools.accumulate(range(1, terms), lambda term, k: term @ M / k, initial=np.eye(len(M))))
    following = sum(itertools.accumulate(range(1, terms + 1), lambda term, k: term @ M / k, initial=np.eye(len(M))))
    return None if np.allclose(total, following, rtol=1e-11, atol=1e-11) else total


def few_digits(right):
    """Return the mistake of an answer that is nearly right; to be tried first.

    Examples
    --------
    >>> bool(few_digits(lambda: np.pi).seen(3.14)), bool(few_digits(lambda: np.pi).seen(3.0))
    (True, False)
    """

    def seen(value, *case):
        exact = right(*case)
        return np.abs(value - exact).max() <= 3e-3 * max(1, np.abs(exact).max())

    return Mistake(
        "the answer is right to its first digits only",
        "Compute with all digits: no np.round, no small steps in place of a derivative, and pi is np.pi.",
        seen=seen,
    )


def whole_numbers(right):
    """Return the mistake of filling an array that holds whole numbers only.

    Examples
    --------
    >>> whole_numbers(lambda p: p / 2).answers[0](np.array([1, 4]))
    array([0., 2.])
    """

    def whole(*case):
        return any(np.asarray(argument).dtype.kind == "i" for argument in case)

    def like(i):
        return lambda *case: np.trunc(right(*case)) if np.asarray(case[i]).dtype.kind == "i" else None

    return Mistake(
        "digits after the point are cut off",
        "np.zeros_like(a) and a.copy() hold whole numbers only if a does. np.zeros(np.shape(a)) has room for digits.",
        like(0),
        like(1),
        seen=lambda value, *case: whole(*case) and np.array_equal(value, np.trunc(value)),
    )


ALWAYS_THE_SAME = (
    Mistake("the answer is always True", "Return what the comparison gives.", lambda *case: True),
    Mistake(
        "the answer is always False", "Print each comparison for the case above: which is False?", lambda *case: False
    ),
)


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
