"""Explain the errors in which a call of the student's function ends."""

import re

from course_lib.checks.call_student import ALONE, CPU_SECONDS, TOGETHER, TOO_MANY_CALLS
from course_lib.checks.mistake import Mistake
from course_lib.checks.reasons import CallsForbidden, Fails, OutOfTime, Raised, WaitsFor

UNWRITTEN = "Write {} here."  # the message of the line that replaces an answer not yet written

_ANOTHER_SYMBOL = Mistake(
    "a symbol that is no argument stands in the answer",
    "Use the arguments themselves. Whoever calls the function passes symbols, or numbers.",
)
_NO_POWER = Mistake("^ is taken for a power", "In Python a power is written with **, as in x**2.")
_LIST_FOR_ARRAY = Mistake(
    "a list is taken for an array",
    "np.array(x, float) makes an array of a list. Arrays can be added and multiplied, and indexed "
    "by several numbers or slices.",
)
_ARRAY_FOR_NUMBER = Mistake(
    "an array is taken for one number",
    "float(...), the functions of math, `if` and one entry of an array, as in x[0] = ..., expect a "
    "single number. numpy's functions work on whole arrays.",
)
_NUMBER_FOR_ARRAY = Mistake(
    "a number is taken for an array or a list",
    "A number has no entries to index or to loop over. numpy's functions work on numbers and on "
    "arrays.",
)
_WHOLE_NUMBERS = Mistake(
    "an array of whole numbers is changed in place, by +=, -=, *= or /=, and the result has "
    "decimals",
    "An array of whole numbers stays one, also in a part like x[1:]. Which of your names is an "
    "array that may hold decimals, and is it yours or the caller's?",
)
_READ_ONLY = Mistake(
    "an array that was made outside the function is changed in place, by +=, @= or T[...] =",
    "Other code still needs this array, so it is read-only. x = x + ... and T = T @ ... make a new "
    "array.",
)
_SHAPES = Mistake("two arrays are combined whose shapes do not fit", "Print the .shape of both.")
_OTHER_PLACE = Mistake(
    "an array is written into a place of another shape",
    "Print the .shape of the array, and that of the place to the left of the equals sign. Which "
    "axis of the array belongs to which axis of the place?",
)
_UNEVEN_PARTS = Mistake(
    "parts that differ in shape are put into one array",
    "np.array needs rows of equal length, and one number in each place. Which function puts a "
    "matrix together from blocks? Or begin with np.zeros, and write each block into its place.",
)
_NOTHING_TO_STACK = Mistake(
    "an empty list of arrays is stacked",
    "For this input the list holds no array. What does the task ask for in this case?",
)
_OTHER_SHAPE = Mistake(
    "an array has fewer axes than this line uses",
    "Print the .shape of the array before this line. np.atleast_2d makes the shape (1, n) of "
    "(n,). A "
    "column has the shape (n, 1).",
)
_BEYOND_THE_END = Mistake(
    "an index goes beyond the last entry",
    "The indices of n entries are 0 to n - 1. Print the .shape of the array, or the len of the"
    " list, before this line: how many entries are there, and how many does your code expect?",
)
_RAISED = Mistake(
    "your own line raises this error", "What should the function return in this case?"
)
_TOO_LONG = Mistake(
    "a loop never ends, or the loops take longer than the check waits",
    "Print how often each loop runs for this input. The passes of loops inside each other "
    "multiply.",
)
_TOO_LONG_TOGETHER = Mistake(
    "no single call takes very long, but all of them together take longer than the check waits",
    "Print how often each loop runs in each call. Which of these passes are not needed for the "
    "result?",
)
_TOO_MANY_CALLS = Mistake(
    "the test calls the function more often than the task allows",
    "Count the calls. The passes of loops inside each other multiply.",
)
_OUT_OF_TIME = {
    ALONE: _TOO_LONG,
    TOGETHER: _TOO_LONG_TOGETHER,
    TOO_MANY_CALLS: _TOO_MANY_CALLS,
}
_DIVIDED = Mistake(
    "something is divided by zero",
    "Which length or angle is 0 for this input? Treat that case separately, before the division.",
)
_NOT_FINITE = Mistake(
    "an earlier line computes nan or infinity, and this line uses it",
    "Print each intermediate value for this input. Where does the first nan or inf appear?",
)
_OUTSIDE_THE_DOMAIN = Mistake(
    "a function gets a number outside its domain",
    "Print this number. For which numbers is the function defined, and how far may rounding take a "
    "number out of that range?",
)
# in any exercise: type, a pattern of the message, mistake; an exercise's own are tried first
_KNOWN = (
    ("UFuncTypeError", "Cannot cast", _WHOLE_NUMBERS),
    (
        "TypeError",
        "'list' and 'list'|can't multiply sequence by non-int|list indices must be",
        _LIST_FOR_ARRAY,
    ),
    (
        "AttributeError",
        "'list' object has no attribute '(shape|ndim|T|sum|mean|reshape)'",
        _LIST_FOR_ARRAY,
    ),
    (
        "TypeError",
        r"'(float|int|numpy\.float64)' object is not (iterable|subscriptable)",
        _NUMBER_FOR_ARRAY,
    ),
    ("IndexError", "invalid index to scalar variable", _NUMBER_FOR_ARRAY),
    ("IndexError", "too many indices for array", _OTHER_SHAPE),
    ("IndexError", "out of bounds for axis|index out of range", _BEYOND_THE_END),
    ("TypeError", r"operand type\(s\) for \^|bitwise_xor", _NO_POWER),
    (
        "TypeError",
        "only (0-dimensional|length-1|size-1) arrays can be converted",
        _ARRAY_FOR_NUMBER,
    ),
    ("ValueError", "truth value of an array", _ARRAY_FOR_NUMBER),
    ("ValueError", "must be finite; ", _NOT_FINITE),
    ("ZeroDivisionError", "", _DIVIDED),
    (
        "ValueError",
        "math domain error|expected a (number in range|nonnegative|positive)",
        _OUTSIDE_THE_DOMAIN,
    ),
    ("ValueError", "read-only", _READ_ONLY),
    ("ValueError", "could not broadcast input array", _OTHER_PLACE),
    (
        "ValueError",
        "matmul|could not be broadcast|must match exactly|same number of dim|for cross product",
        _SHAPES,
    ),
    ("ValueError", "inhomogeneous shape", _UNEVEN_PARTS),
    ("ValueError", "setting an array element with a sequence", _ARRAY_FOR_NUMBER),
    ("ValueError", "need at least one array", _NOTHING_TO_STACK),
)


def explain_error(exercise, error):
    """Return what an error says of an answer: ("waits", "wrong" or "error", reason, Mistake or
    None, show the case).

    Parameters
    ----------
    exercise : Exercise
    error : dict
        "type" and "message", the name of the exception's type and its text, which for TimeUp is the
        bound that was reached; and, where they are known, "line", "source", "cell" and "caller":
        the number and the text of the student's last line that ran, the function whose cell holds
        it if that is another one, and the line of the exercise's cell that led there; and
        "seconds", the processor time that there was for all cases.
    """
    kind, message = error["type"], error["message"]
    call = f"{exercise.name}({', '.join(exercise.arguments)})"
    if kind == "NotImplementedError":
        return "waits", _what_to_write_first(exercise.name, message), None, False
    if kind == "NotPlain":
        kinds = "the answer is numbers, booleans, arrays or lists"
        return "wrong", Fails(kinds, f"Yours is {message}."), None, False
    if kind == "NotAllowed":
        mistake = Mistake(f"{message} is called", "It does what you are asked to write here.")
        return "wrong", CallsForbidden(message), mistake, False
    if kind == "KeyboardInterrupt":
        return "error", f"{call} was interrupted.", None, False
    if kind == "NoNumber":
        holds = "if the arguments are numbers, each entry of the answer is a number"
        return "wrong", Fails(holds, f"One of yours is {message}."), _ANOTHER_SYMBOL, False
    own = [mistake for mistake in exercise.mistakes if mistake.is_raised(kind, message)]
    if kind == "TimeUp":
        mistake = own[0] if own else _OUT_OF_TIME.get(message, _TOO_LONG)
        # The case in which the time of all calls together ends depends on the machine.
        shows_case = message != TOGETHER
        reason = OutOfTime(call, message, error.get("seconds", CPU_SECONDS))
        return "error", reason, mistake, shows_case
    of_any_exercise = [
        mistake
        for known_kind, words, mistake in _KNOWN
        if known_kind == kind and re.search(words, message)
    ]
    mistakes = own + of_any_exercise
    source = error.get("source", "")
    if source.startswith("raise "):
        mistakes.append(_RAISED)
    mistake = mistakes[0] if mistakes else None
    where = (error.get(part, "") for part in ("cell", "line", "caller"))
    reason = Raised(call, kind, message, source, *where)
    # A function that was called with symbols was not given the numbers of the case.
    shows_case = not exercise.through
    return "error", reason, mistake, shows_case


def _what_to_write_first(name, message):
    """Return the reason WaitsFor if the function calls another exercise that is not written yet;
    else ""."""
    unwritten = re.fullmatch(UNWRITTEN.format(r"(\w+)"), message)
    if unwritten is None or unwritten[1] == name:
        return ""
    return WaitsFor(unwritten[1])
