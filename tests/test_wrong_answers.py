"""Each check against a bank of answers as students write them, wrong ones and right ones.

tests/wrong_answers/<notebook>/<exercise>.py holds functions. Those called right_... are to be accepted. Those called
wrong_... are to be refused, and the first line of their docstring is a phrase of the name that the check is to give
the mistake, or the type of the error they end in, or "unnamed" where no known mistake is to be claimed.
"""

import importlib
import importlib.util
import pkgutil
import textwrap
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import course_lib.checks
from course_lib.checks.exercise import ERROR, PUBLIC_SEED, RIGHT, WRONG, Exercise, Here, judge
from course_lib.checks.notebook import describe

BANK = Path(__file__).parent / "wrong_answers"
SEEDS = (PUBLIC_SEED, 7, 1234, 99_991)  # of the cases; grading takes seeds that nobody knows beforehand

NOTEBOOKS = {
    found.name: module
    for found in pkgutil.iter_modules(course_lib.checks.__path__)
    if hasattr(module := importlib.import_module(f"course_lib.checks.{found.name}"), "CHECKS")
}


@dataclass(frozen=True)
class Answer:
    notebook: str
    exercise: Exercise
    name: str
    function: object

    def __str__(self):
        return f"{self.notebook}-{self.exercise.name}-{self.name}"

    @property
    def expected(self):
        """The phrase in the docstring of a wrong answer."""
        return self.function.__doc__.splitlines()[0]


def _functions(path):
    spec = importlib.util.spec_from_file_location(f"{path.parent.name}_{path.stem}", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return {name: value for name, value in vars(module).items() if name.startswith(("right_", "wrong_"))}


def _answers(notebook, exercise):
    path = BANK / notebook / f"{exercise.name}.py"
    return [Answer(notebook, exercise, *item) for item in _functions(path).items()] if path.exists() else []


EXERCISES = [(notebook, check.exercise) for notebook, module in NOTEBOOKS.items() for check in module.CHECKS]
ANSWERS = [answer for notebook, exercise in EXERCISES for answer in _answers(notebook, exercise)]
RIGHT_ONES = [answer for answer in ANSWERS if answer.name.startswith("right_")]
WRONG_ONES = [answer for answer in ANSWERS if answer.name.startswith("wrong_")]

each_exercise = pytest.mark.parametrize(
    ("notebook", "exercise"), EXERCISES, ids=[f"{n}-{e.name}" for n, e in EXERCISES]
)


@cache
def verdicts(answer):
    return [judge(answer.exercise, Here(answer.function), seed) for seed in SEEDS]


def called(verdict):
    """Return the words by which a verdict calls the mistake; for an error in the code, the words that tell of it."""
    if verdict.state == ERROR:
        return verdict.reason
    return verdict.mistake.name if verdict.mistake else "unnamed"


@pytest.mark.parametrize("answer", RIGHT_ONES, ids=str)
def test_a_right_answer_is_accepted(answer):
    for verdict in verdicts(answer):
        assert verdict.state == RIGHT, describe(verdict)


@pytest.mark.parametrize("answer", WRONG_ONES, ids=str)
def test_a_wrong_answer_is_refused_and_called_by_its_name(answer):
    for verdict in verdicts(answer):
        assert verdict.state in (WRONG, ERROR)
        assert answer.expected in called(verdict), describe(verdict)


@pytest.mark.parametrize("answer", ANSWERS, ids=str)
def test_a_message_fits_on_a_screen_and_shows_nothing_of_the_machinery(answer):
    for verdict in verdicts(answer):
        text = describe(verdict)
        lines = [part for line in text.splitlines() for part in textwrap.wrap(line, 100) or [""]]
        assert len(lines) <= (1 if verdict.state == RIGHT else 24)
        for machinery in ("Traceback", ".py", " at 0x", "<function", "<lambda>"):
            assert machinery not in text


@each_exercise
def test_each_exercise_has_its_bank(notebook, exercise, record_property):
    """The row recorded here is shown in the summary of the test run; see conftest.py."""
    found = {
        answer: verdicts(answer) for answer in ANSWERS if (answer.notebook, answer.exercise) == (notebook, exercise)
    }
    wrong = [all_of for answer, all_of in found.items() if answer in WRONG_ONES]
    right = [all_of for answer, all_of in found.items() if answer in RIGHT_ONES]
    refused = sum(all(verdict.state != RIGHT for verdict in all_of) for all_of in wrong)
    named = sum(all(called(verdict) != "unnamed" for verdict in all_of) for all_of in wrong)
    accepted = sum(all(verdict.state == RIGHT for verdict in all_of) for all_of in right)
    row = (refused, len(wrong)), (named, len(wrong)), (accepted, len(right))
    record_property("bank", (notebook, exercise.name, *(f"{part} of {whole}" for part, whole in row)))
    bank = f"tests/wrong_answers/{notebook}/{exercise.name}.py"
    assert len(wrong) >= 4, f"{bank} holds {len(wrong)} answers wrong_...: four at least"
    assert len(right) >= 3, f"{bank} holds {len(right)} answers right_...: three at least"
    assert named >= 0.8 * len(wrong), f"the check calls {named} of {len(wrong)} wrong answers by a name: 80 % at least"


@pytest.mark.parametrize("notebook", NOTEBOOKS)
def test_no_file_of_the_bank_is_without_its_exercise(notebook):
    names = {exercise.name for name, exercise in EXERCISES if name == notebook}
    without = {path.stem for path in (BANK / notebook).glob("*.py")} - names
    assert not without, f"course_lib/checks/{notebook}/__init__.py has no line for {', '.join(sorted(without))}"


def test_no_folder_of_the_bank_is_without_its_notebook():
    assert {path.name for path in BANK.iterdir() if any(path.glob("*.py"))} == set(NOTEBOOKS)


@each_exercise
@pytest.mark.parametrize("number", [0.0, -1.0, 1e-320, 1e200, -1.7e308, 2**70])
def test_an_answer_of_the_right_shape_and_any_size_is_refused_in_peace(notebook, exercise, number):
    if not (answers := _answers(notebook, exercise)):
        pytest.skip("it has no bank yet, which another test tells")
    right = answers[0].function
    verdict = judge(exercise, Here(lambda *arguments: np.full(np.shape(right(*arguments)), number)))
    assert verdict.state == WRONG
    assert describe(verdict)


@each_exercise
@pytest.mark.parametrize(
    "value",
    [None, "", "1", 10**400, [10**400, 1.0], [], [[]], [[], [1]], {}, {"R": 1}, [None], [[1, 2], [3]], 1j, {1}, object],
    ids=repr,
)
def test_an_answer_of_any_other_kind_is_refused_in_peace(notebook, exercise, value):
    verdict = judge(exercise, Here(lambda *arguments: value))
    assert verdict.state == WRONG
    assert describe(verdict)
