"""Read an answer as the type that an exercise asks for, in any equivalent form."""

import numpy as np

from course_lib.checks.mistake import OTHER_FORM, Question
from course_lib.checks.reasons import Fails

NOT_A_NUMBER = Question(
    "something is divided by zero, a function is asked outside its domain, or nan or inf is "
    "returned as it stands",
    "Print each intermediate value for this input: where does the first nan or inf appear? "
    "What does the task ask for in this case?",
)


class Unreadable(ValueError):
    """The answer has the wrong kind or shape.

    Parameters
    ----------
    holds, found : str
        What should hold of the answer, a sentence without its end, and what was returned.
    mistake : Mistake or Question
    array : ndarray, optional
        The answer, if it is an array of another shape.
    not_a_number : bool, optional
        Whether it holds nan or inf. Mistakes of the exercise that know such answers take the place
        of this one.
    """

    def __init__(self, holds, found, mistake, array=None, not_a_number=False):
        self.reason = Fails(holds, found)
        super().__init__(str(self.reason))
        self.mistake, self.array, self.not_a_number = mistake, array, not_a_number


def boolean(value, *case):
    """Return an answer as True or False.

    Parameters
    ----------
    value : object
        A bool, a numpy bool, or a single 0 or 1, also in an array.
    *case
        The arguments of the case; not used.

    Returns
    -------
    bool

    Raises
    ------
    Unreadable
        For anything else.
    """
    array = _array(value, "True or False")
    if array.size != 1 or array.item() not in (0, 1):
        raise Unreadable("the answer is True or False", f"Yours is {_form(array)}.", OTHER_FORM)
    return bool(array.item())


def numbers(shape_of, gaps=False, exact=False):
    """Return a reader of arrays; (4, 1) and (1, 4) are read as (4,), and an array with one entry as
    a number.

    Parameters
    ----------
    shape_of : callable
        shape_of(*arguments) is the shape that the answer should have.
    gaps : bool, optional
        True to allow nan and inf.
    exact : bool, optional
        True to read no other shape, where an answer to many items has one row for each.

    Returns
    -------
    callable
        reader(value, *arguments) returns an array of floats, or raises Unreadable.

    Examples
    --------
    >>> read_vector = numbers(lambda p: (3,))
    >>> read_vector([[1], [2], [3]], None)
    array([1., 2., 3.])
    """

    def reader(value, *case):
        shape = tuple(shape_of(*case))
        expected = f"an array of shape {shape}" if shape else "a number"
        array = _array(value, expected)
        vectors = (
            len(shape) == 1 and array.size == shape[0] and array.ndim == 2 and 1 in array.shape
        )
        number = shape == () and array.size == 1
        if array.shape != shape and (exact or not (vectors or number)):
            raise Unreadable(
                f"the answer is {expected}",
                f"Yours has shape {array.shape}.",
                OTHER_FORM,
                array=array.real,
            )
        return _finite(array, gaps).reshape(shape)

    return reader


def rows(width, expected, most=16):
    """Return a reader of lists of any length, none included, of items of `width` numbers each.

    Parameters
    ----------
    width : int
    expected : str
        The list in words, to follow "the answer is".
    most : int, optional
        The largest number of items.

    Returns
    -------
    callable
        reader(value, *arguments) returns an array (n, width), or (n,) with a width of 1, or raises
        Unreadable. A single item needs no list around it.

    Examples
    --------
    >>> read_pairs = rows(2, "a list of pairs of angles")
    >>> read_pairs([1, 2]), read_pairs([])
    (array([[1., 2.]]), array([], shape=(0, 2), dtype=float64))
    """

    def reader(value, *case):
        array = _array(value, expected)
        one_item = array.ndim <= 1 and array.size == width
        column = width == 1 and array.size == max(array.shape, default=1)
        if array.size and not (one_item or column or array.shape[1:] in ((width,), (width, 1))):
            raise Unreadable(
                f"the answer is {expected}",
                f"Yours is {_form(array)}.",
                OTHER_FORM,
                array=array.real,
            )
        if array.size > most * width:
            raise Unreadable(
                f"the answer is {expected}",
                f"Yours has {array.size // width} of them.",
                OTHER_FORM,
            )
        items = _finite(array).reshape(array.size // width, width)
        return items[:, 0] if width == 1 else items

    return reader


def _finite(array, gaps=False):
    """Return the entries as floats; raise Unreadable if they are complex, or not numbers unless
    gaps allows that."""
    if array.dtype.kind == "c":
        if np.abs(array.imag).max(initial=0) > 0:
            raise Unreadable(
                "the answer's entries are real numbers", "Yours are complex.", OTHER_FORM
            )
        array = array.real
    array = array.astype(float)
    if not gaps and not np.isfinite(array).all():
        raise Unreadable(
            "every entry of the answer is a number",
            "Yours holds nan or inf.",
            NOT_A_NUMBER,
            not_a_number=True,
        )
    return array


def _array(value, expected):
    try:
        array = np.asarray(value)
    except ValueError:
        kind = f"a {type(value).__name__} whose parts differ in shape"
        raise Unreadable(f"the answer is {expected}", f"Yours is {kind}.", OTHER_FORM) from None
    if array.dtype.kind not in "biufc":
        raise Unreadable(
            f"the answer is {expected}",
            f"Yours is of type {type(value).__name__}.",
            OTHER_FORM,
        )
    return array


def _form(array):
    return str(array.item()) if array.shape == () else f"an array of shape {array.shape}"
