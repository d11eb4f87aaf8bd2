"""Each check against a bank of answers as students write them, and against the mistakes that it predicts itself.

tests/wrong_answers/<notebook>/<exercise>.py holds functions. Those called right_... are to be accepted. Those called
wrong_... are to be refused, and the first line of their docstring is a phrase of the name that the check gives the
mistake, or the type of the error they end in, or "unnamed" if no known mistake is to be claimed.

SEEDS=50 in the environment tries fifty seeds of the cases instead of two.
"""

import importlib
import importlib.util
import json
import os
import textwrap
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from remembering import remembering

from course_lib.checks.answer_types import NOT_A_NUMBER
from course_lib.checks.exercise import ERROR, PUBLIC_SEED, RIGHT, WRONG, Here, attempt, judge
from course_lib.checks.notebook import describe
from course_lib.checks.wire import NotPlain, Seed, to_json

BANK = Path(__file__).parent / "wrong_answers"
FILES = sorted(BANK.glob("*/*.py"))  # by their names, so that nothing is imported that is not asked for
SEEDS = [PUBLIC_SEED, 7, *range(10_000, 10_000 + int(os.environ.get("SEEDS", 2)) - 2)]
MOST_LINES = 24  # of a message

each_exercise = pytest.mark.parametrize("path", FILES, ids=[f"{path.parent.name}-{path.stem}" for path in FILES])


def exercise_of(path):
    package = importlib.import_module(f"course_lib.checks.{path.parent.name}")
    return remembering(getattr(package, path.stem).exercise)


@cache
def answers(path):
    """The bank of one exercise: {name: function}."""
    spec = importlib.util.spec_from_file_location(f"{path.parent.name}_{path.stem}", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return {name: value for name, value in vars(module).items() if name.startswith(("right_", "wrong_"))}


def called(verdict):
    """Return the words by which a verdict calls the mistake; for an error in the code, the words that describe it."""
    if verdict.state == ERROR:
        return verdict.reason
    return verdict.mistake.name if verdict.mistake else "unnamed"


def complaints(name, function, verdict):
    """Yield what is wrong with the verdict on one answer of the bank."""
    text = describe(verdict)
    if name.startswith("right_") and verdict.state != RIGHT:
        yield f"{name} is refused:\n{text}"
    if name.startswith("wrong_"):
        expected = function.__doc__.splitlines()[0]
        if verdict.state == RIGHT:
            yield f"{name} is accepted"
        elif expected not in called(verdict):
            yield f'{name} is called "{called(verdict)}", not "{expected}":\n{text}'
    lines = [part for line in text.splitlines() for part in textwrap.wrap(line, 100) or [""]]
    if len(lines) > (1 if verdict.state == RIGHT else MOST_LINES):
        yield f"{name}: the message has {len(lines)} lines"
    for machinery in ("Traceback", ".py", " at 0x", "<function", "<lambda>"):
        if machinery in text:
            yield f"{name}: the message shows {machinery}:\n{text}"


@each_exercise
def test_right_answers_are_accepted_and_wrong_ones_refused_by_name(path, record_property):
    """The row recorded here is shown in the summary of the test run; see conftest.py."""
    exercise, found, named = exercise_of(path), [], 0
    for name, function in answers(path).items():
        verdicts = [judge(exercise, Here(function), seed) for seed in SEEDS]
        for seed, verdict in zip(SEEDS, verdicts, strict=True):
            found += [f"seed {seed}: {complaint}" for complaint in complaints(name, function, verdict)]
        named += name.startswith("wrong_") and all(called(verdict) != "unnamed" for verdict in verdicts)
    assert not found, "\n".join(found)
    wrong = sum(name.startswith("wrong_") for name in answers(path))
    right = len(answers(path)) - wrong
    record_property("bank", (path.parent.name, exercise.name, str(wrong), str(named), str(right)))
    bank = f"tests/wrong_answers/{path.parent.name}/{path.name}"
    assert wrong >= 4, f"{bank} holds {wrong} answers wrong_...: four at least"
    assert right >= 3, f"{bank} holds {right} answers right_...: three at least"
    enough = named >= 0.8 * wrong or hasattr(exercise, "versions")  # a test that is too weak has no name
    assert enough, f"the check calls {named} of {wrong} wrong answers by a name: 80 % at least"


class Predicted:
    """Stands for a student who makes one mistake of the check's own list, and is right where it says nothing.

    It is asked the cases that the exercise remembers, not copies of them: what a mistake predicts of each is computed
    once, for this student and for every verdict.
    """

    def __init__(self, answer, exercise, right):
        self.answer, self.right, self.speaks = answer, right, False
        self.cases, _ = exercise.questions(np.random.default_rng(PUBLIC_SEED))

    def reply(self, questions, consult=None):
        with np.errstate(all="ignore"):
            predicted = [self._predicted(case) for case in self.cases]
        self.speaks = any(predicted)
        answers = [answer or self.right(k) for k, answer in enumerate(predicted)]
        return json.dumps({"answers": answers, "calls": []})

    def _predicted(self, case):
        value = attempt(self.answer, *case)
        try:
            return None if value is None else told(value)
        except NotPlain:
            return None


def told(value):
    return {"value": to_json(value), "changed": []}


def rightly(exercise):
    """Return a function of a case's position: the library's answer, computed once."""
    cases, _ = exercise.questions(np.random.default_rng(PUBLIC_SEED))

    @cache
    def right(k):
        real = [np.random.default_rng(a.number) if isinstance(a, Seed) else a for a in cases[k]]
        return told(exercise.library(*real))

    return right


@each_exercise
def test_each_mistake_is_refused_and_named_itself_or_by_the_one_that_shadows_it(path):
    exercise = replace(exercise_of(path), forbidden=(), through="")
    right, found = rightly(exercise), []
    for mistake in (*exercise.mistakes, *(p.mistake for p in exercise.properties if p.mistake)):
        for k, answer in enumerate(mistake.answers):
            student = Predicted(answer, exercise, right)
            verdict = judge(exercise, student)
            if not student.speaks:
                found.append(f'"{mistake.name}", answer {k}: no case shows it')
            elif verdict.state == RIGHT:
                found.append(f'"{mistake.name}", answer {k}: is right')
            elif called(verdict) not in (mistake.name, mistake.shadowed_by, NOT_A_NUMBER.name):
                found.append(f'"{mistake.name}", answer {k}: is called "{called(verdict)}"')
    assert not found, "\n".join(found)


@each_exercise
def test_the_library_s_answer_is_right(path):
    exercise = replace(exercise_of(path), forbidden=())
    if exercise.library is None:
        assert hasattr(exercise, "versions"), "an exercise has the library's function, for check.<name>.use"
        return
    for seed in SEEDS:
        verdict = judge(exercise, Here(exercise.library), seed)
        assert verdict.state == RIGHT, describe(verdict)


@each_exercise
def test_an_answer_of_any_size_or_kind_is_refused_without_an_error(path):
    exercise = exercise_of(path)
    right = next(function for name, function in answers(path).items() if name.startswith("right_"))
    shapes = []
    judge(exercise, Here(lambda *case: shapes.append(np.shape(right(*case)))))
    for number in (0.0, -1.0, 1e-320, 1e200, -1.7e308, 2**70):
        shape = iter(shapes)
        verdict = judge(exercise, Here(lambda *case, number=number, shape=shape: np.full(next(shape), number)))
        assert verdict.state == WRONG
        assert describe(verdict)
    kinds = [None, "", "1", 10**400, [10**400, 1.0], [], [[]], [[], [1]], {}, {"R": 1}, [None], [[1, 2], [3]], 1j]
    for value in [*kinds, {1}, object, np.zeros((3000, 3000))]:
        verdict = judge(exercise, Here(lambda *case, value=value: value))
        assert verdict.state == WRONG
        assert describe(verdict)


@pytest.mark.parametrize("notebook", sorted({path.parent.name for path in FILES}))
def test_exercises_their_modules_and_their_banks_have_the_same_names(notebook):
    package = importlib.import_module(f"course_lib.checks.{notebook}")
    names = [check.exercise.name for check in package.CHECKS]
    assert list(package.EXERCISES) == names
    assert {path.stem for path in FILES if path.parent.name == notebook} == set(names)
