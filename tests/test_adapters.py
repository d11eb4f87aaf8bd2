"""Functions asked with SymPy symbols, and judged by numbers."""

import json
import math

import numpy as np
import pytest
import sympy as sp

from course_lib.checks import call_student, wire
from course_lib.checks.adapters import NoNumber, with_symbols
from course_lib.checks.judge import LocalFunction, judge
from course_lib.checks.messages import describe
from course_lib.checks.verdict import ERROR
from course_lib.lessons.decomposition_ik import check

DH_SYMBOLIC = check.dh_symbolic.exercise


def put(function, **arguments):
    """Put one case to the function as ask.py does; return its answer."""
    asked = {"cases": [list(arguments.values())], "forbidden": [], "seconds": 5}
    asked |= {"through": "symbols", "names": list(arguments), "exercise": ""}
    return json.loads(call_student.reply(function, wire.write(asked)))["answers"][0]


def value(function, **arguments):
    return wire.from_json(put(function, **arguments)["value"])


def test_floats_go_in_as_real_symbols_of_their_names():
    given = []

    def notes(a, theta):
        given.extend([a, theta])
        return theta

    assert value(notes, a=2, theta=0.5) == 0.5
    assert given[0] == 2
    assert isinstance(given[1], sp.Symbol)
    assert given[1].name == "theta"
    assert given[1].is_real
    assert given[1] != sp.Symbol("theta", real=True)


@pytest.mark.parametrize(
    "function",
    [
        lambda x: sp.Matrix([[sp.cos(x), 0], [1, x]]),
        lambda x: sp.Array([[sp.cos(x), 0], [1, x]]),
        lambda x: sp.MatMul(sp.Matrix([[sp.cos(x), 0], [1, x]]), sp.eye(2)),
        lambda x: np.array([[sp.cos(x), 0], [1, x]]),
        lambda x: [[sp.cos(x), 0.0], (1, x)],
        lambda x: (
            [(sp.exp(sp.I * x) + sp.exp(-sp.I * x)) / 2, sp.Integer(0)],
            [sp.Rational(2, 2), x],
        ),
        lambda x: sp.Matrix([[sp.cos(sp.Symbol("y")), 0], [1, sp.Symbol("y")]]).subs(
            sp.Symbol("y"), x
        ),
    ],
)
def test_an_answer_in_any_form_comes_back_as_its_numbers(function):
    got = np.asarray(value(function, x=0.3), float)
    assert np.abs(got - [[math.cos(0.3), 0], [1, 0.3]]).max() < 1e-15


def test_a_number_keeps_all_its_digits():
    assert value(lambda x: x, x=0.1 + 0.2) == 0.1 + 0.2
    assert value(lambda x: sp.pi * x, x=1e-12) == pytest.approx(math.pi * 1e-12, rel=1e-15)


def test_numbers_that_are_complex_or_infinite_come_back_as_such():
    assert value(lambda x: sp.sqrt(-x), x=4.0) == 2j
    assert value(lambda x: [sp.oo * (x + 1)], x=1.0) == [math.inf]
    assert np.isnan(value(lambda x: sp.nan * x, x=1.0))


def test_a_function_is_asked_with_the_numbers_themselves_too():
    assert value(lambda x: 2 * x if isinstance(x, sp.Symbol) else x, x=0.5) == 0.5
    assert value(lambda x: [sp.nsimplify(x, tolerance=0.01)], x=0.3922) == [20 / 51]


@pytest.mark.parametrize("text", ["__import__('os').abort()", "1 + 1", "x"])
def test_no_text_is_made_into_an_expression(text):
    assert value(lambda x: text, x=0.5) == text
    assert value(lambda x: [x, text], x=0.5) == [0.5, text]
    assert value(lambda x: {"x": text}, x=0.5) == {"x": text}


class Hostile:
    """An object that would have itself taken for an expression, a number or an array."""

    def _touched(self, *arguments, **named):
        raise AssertionError("asked what it is")

    _sympy_ = _sympystr = __str__ = __repr__ = __float__ = __complex__ = __array__ = __iter__ = (
        evalf
    ) = subs = _touched


def by_a_template(a, b):
    """Replace symbols of its own by the arguments, one after the other."""
    own = sp.symbols("a b")
    return (own[0] + 2 * own[1]).subs(own[0], a).subs(own[1], b)


def by_the_type_of_the_last(a, b):
    return math.sin(a) if isinstance(b, float) else sp.sin(a)


@pytest.mark.parametrize(
    ("function", "right"),
    [
        (by_a_template, lambda a, b: a + 2 * b),
        (by_the_type_of_the_last, lambda a, b: math.sin(a)),
    ],
)
def test_other_symbols_and_symbols_beside_numbers_are_passed_too(function, right):
    answer = put(function, a=0.5, b=0.25)
    assert answer.get("value") != wire.to_json(right(0.5, 0.25))


KEPT = sp.zeros(1, 1)


def in_one_matrix(a, b):
    KEPT[0, 0] = a + b
    return KEPT


@pytest.mark.parametrize(
    ("function", "is_kept"), [(in_one_matrix, True), (lambda a, b: sp.Matrix([[a + b]]), False)]
)
def test_a_matrix_that_a_later_call_changes_is_called_overwritten(function, is_kept):
    answer = put(function, a=0.5, b=0.25)
    assert wire.from_json(answer["value"]) == 0.75
    assert answer.get("overwritten", False) is is_kept


@pytest.mark.parametrize(
    "wrap", [lambda thing: thing, lambda thing: [thing], lambda thing: ([1, thing],)]
)
def test_what_is_no_expression_is_not_asked_what_it_is(wrap):
    error = put(lambda x: wrap(Hostile()), x=0.5)["error"]
    assert (error["type"], error["message"]) == ("NotPlain", "a Hostile")


ENDLESS = []
ENDLESS.append(ENDLESS)


@pytest.mark.parametrize(
    "thing", [sp.true, sp.Symbol, sp.S.EmptySet, sp.Eq(sp.Symbol("x"), 1), ENDLESS], ids=repr
)
def test_what_is_neither_expression_nor_number_is_not_plain(thing):
    assert put(lambda x: [thing], x=0.5)["error"]["type"] == "NotPlain"


@pytest.mark.parametrize(
    "entry", [sp.Symbol("theta"), sp.Function("f")(1), 2 * sp.Symbol("theta", real=True)]
)
def test_what_stays_an_expression_is_no_number(entry):
    with pytest.raises(NoNumber, match=r"theta|f"):
        with_symbols(lambda theta: [theta, entry], ["theta"], [0.5])


# In the messages of a check


@pytest.mark.parametrize(
    "function",
    [
        lambda a, alpha, d, theta: np.cos(theta),
        lambda a, alpha, d, theta: sp.Matrix([math.sin(alpha)]),
        lambda a, alpha, d, theta: np.arctan2(theta, alpha),
    ],
)
def test_a_function_for_numbers_used_on_symbols_is_named(function):
    verdict = judge(DH_SYMBOLIC, LocalFunction(function))
    assert verdict.state == ERROR
    assert "For theta" not in describe(verdict)
    assert "a function of numpy or math is called with symbols" in describe(verdict)
