"""Each check against answers: right ones, its own mistakes, and a few wrong ones of which it knows
no formula.

tests/lessons/<notebook>/answers/<exercise>.py holds functions as students write them. Those called
right_... are accepted: three at least, different in method or form. Those called wrong_... are
refused; the first line of their docstring is a phrase of the name that the check gives the mistake,
the type of the error they end in, or "unnamed" if no known mistake is to be claimed. The mistakes
of the exercise itself, which stand below its check, are refused and named.

The notebook's sets of cases decide about wrong answers, and the first of these about right ones.
With ALL=yes right ones must pass the others and one of a secret seed, too: SEEDS=50 in the
environment tries fifty of these instead of one.
"""

import copy
import importlib
import importlib.util
import os
import pickle
import textwrap
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from course_lib.checks.comparisons import attempt, predict
from course_lib.checks.judge import LocalFunction, judge, review
from course_lib.checks.messages import describe
from course_lib.checks.verdict import ERROR, RIGHT, WRONG

LESSONS = Path(__file__).parent / "lessons"
FILES = sorted(
    LESSONS.glob("*/answers/*.py")
)  # by their names, so that nothing is imported that is not asked for
SECRET_SEEDS = (7, *range(10_000, 10_000 + int(os.environ.get("SEEDS", 1)) - 1))
MAX_LINES = 24  # of a message
# Exercises whose answers are of all types: numbers, arrays, truth values, lists, symbols, random
# numbers, and a test.
OF_EACH_TYPE = (
    "cell_index",
    "hat_se3",
    "is_valid",
    "two_link_angles",
    "dh_symbolic",
    "random_rotations",
    "fit_cells",
    "test_log_so3",
)


def notebook_of(path):
    """Return the name of the notebook to whose lesson a file of answers belongs."""
    return path.parents[1].name


each_exercise = pytest.mark.parametrize(
    "path", FILES, ids=[f"{notebook_of(path)}-{path.stem}" for path in FILES]
)


@cache
def exercise_of(path):
    """Return the Exercise of a file of answers.

    What its library and its mistakes answer to a case is computed once, for all the answers that
    are judged.
    """
    exercise = importlib.import_module(
        f"course_lib.lessons.{notebook_of(path)}.exercises.{path.stem}"
    ).EXERCISE
    if exercise.cases is None:
        return exercise
    mistakes = [copy.copy(mistake) for mistake in exercise.mistakes]
    for mistake in mistakes:
        mistake.answers = tuple(map(_remembering, mistake.answers))
    library = exercise.library and _remembering(exercise.library)
    return replace(exercise, mistakes=mistakes, library=library)


def _remembering(function):
    """Return a function with a memory of its answers and errors; with a random generator it is
    called anew."""
    memory = {}

    def answer(*case):
        if any(isinstance(argument, np.random.Generator) for argument in case):
            return function(*case)
        key = pickle.dumps(case)
        if key not in memory:
            try:
                memory[key] = function(*case), None
            except Exception as error:
                memory[key] = None, error
        value, error = memory[key]
        if error is not None:
            raise error
        return value

    return answer


@cache
def answers(path):
    """Return the answers to one exercise: {name: function}."""
    spec = importlib.util.spec_from_file_location(f"{notebook_of(path)}_{path.stem}", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return {
        name: value for name, value in vars(module).items() if name.startswith(("right_", "wrong_"))
    }


def called(verdict):
    """Return the words by which a verdict calls the mistake; for an error in the code, the words
    that describe it."""
    if verdict.state == ERROR:
        return str(verdict.reason)
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
    if len(lines) > (1 if verdict.state == RIGHT else MAX_LINES):
        yield f"{name}: the message has {len(lines)} lines"
    for machinery in ("Traceback", ".py", " at 0x", "<function", "<lambda>"):
        if machinery in text:
            yield f"{name}: the message shows {machinery}:\n{text}"


@each_exercise
def test_right_answers_pass_a_set_and_wrong_ones_are_named(path, record_property):
    """The row recorded here is shown in the summary of the test run; see conftest.py."""
    exercise, found, met = exercise_of(path), [], []
    for name, function in answers(path).items():
        if name.startswith("right_"):
            verdict = judge(exercise, LocalFunction(function))
        else:
            verdict = review(exercise, LocalFunction(function))
            met.append(verdict.mistake)
        found += complaints(name, function, verdict)
    never = [
        known.name
        for known in exercise.mistakes
        if known.seen and not known.answers and known not in met
    ]
    found += [f'no answer is called "{name}", which no function predicts' for name in never]
    assert not found, "\n".join(found)
    right = sum(name.startswith("right_") for name in answers(path))
    counts = (right, len(answers(path)) - right, len(exercise.mistakes))
    record_property("bank", (notebook_of(path), exercise.name, *map(str, counts)))
    assert right >= 3, (
        f"tests/lessons/{notebook_of(path)}/answers/{path.name} holds {right} answers right_...:"
        " three at least"
    )


@pytest.mark.slow
@each_exercise
def test_right_answers_pass_all_sets_and_secret_ones(path):
    """The first set is that of the test above."""
    exercise, found = exercise_of(path), []
    right = {name: each for name, each in answers(path).items() if name.startswith("right_")}
    for seed in (*exercise.public_seeds[1:], *SECRET_SEEDS):
        for name, function in right.items():
            found += complaints(name, function, judge(exercise, LocalFunction(function), seed))
    assert not found, "\n".join(found)


def made_by(mistake, answer, exercise):
    """Return the function of a student who makes this mistake, and is right where it does not
    apply; and its use.

    The second function returns in how many cases the mistake spoke.
    """
    spoke = []

    def student(*case):
        value = predict(answer, case)
        if value is None:
            return exercise.library(*case)
        spoke.append(True)
        if mistake.part is None:
            return value
        whole = np.array(exercise.library(*case), float)
        whole[mistake.part] = value
        return whole

    return student, lambda: len(spoke)


FIRST_FORM, OTHER_FORMS = slice(1), slice(1, None)


@pytest.mark.parametrize(
    "forms",
    [FIRST_FORM, pytest.param(OTHER_FORMS, marks=pytest.mark.slow)],
    ids=["first form", "other forms"],
)
@each_exercise
def test_each_mistake_is_refused_and_called_by_its_name(path, forms):
    exercise, found = replace(exercise_of(path), forbidden=(), through=""), []
    for mistake in exercise.mistakes:
        for k, answer in list(enumerate(mistake.answers))[forms]:
            student, spoke = made_by(mistake, answer, exercise)
            verdict = review(exercise, LocalFunction(student))
            about = f'"{mistake.name}", answer {k}'
            if not spoke():
                found.append(f"{about}: no case shows it")
            elif verdict.state == RIGHT:
                found.append(f"{about}: is right")
            elif verdict.mistake is not mistake:
                found.append(f'{about}: is called "{called(verdict)}"')
    assert not found, "\n".join(found)


@each_exercise
def test_the_library_s_answer_is_right(path):
    exercise = replace(exercise_of(path), forbidden=())
    if exercise.library is None:
        assert hasattr(exercise, "versions"), (
            "an exercise has the library's function, for check.<name>.use"
        )
        return
    verdict = judge(exercise, LocalFunction(exercise.library))
    assert verdict.state == RIGHT, describe(verdict)


@pytest.mark.slow
@pytest.mark.parametrize(
    "path", [path for path in FILES if path.stem in OF_EACH_TYPE], ids=lambda path: path.stem
)
def test_an_answer_of_any_kind_is_rejected_without_an_error(path):
    exercise = replace(exercise_of(path), forbidden=())
    right = next(function for name, function in answers(path).items() if name.startswith("right_"))
    shapes = []
    judge(
        exercise, LocalFunction(lambda *case: shapes.append(attempt(np.shape, right(*case)) or ()))
    )  # () for a pair of arrays
    for number in (0.0, -1.0, 1e-320, 1e200, -1.7e308, 2**70):
        shape = iter(shapes)
        verdict = judge(
            exercise,
            LocalFunction(lambda *case, number=number, shape=shape: np.full(next(shape), number)),
        )
        assert verdict.state == WRONG
        assert describe(verdict)
    kinds = [
        None,
        "",
        "1",
        10**400,
        [10**400, 1.0],
        [],
        [[]],
        [[], [1]],
        {},
        {"R": 1},
        [None],
        [[1, 2], [3]],
        1j,
    ]
    for value in [*kinds, {1}, object, np.zeros((3000, 3000))]:
        verdict = judge(exercise, LocalFunction(lambda *case, value=value: value))
        assert verdict.state == WRONG
        assert describe(verdict)


@pytest.mark.parametrize("notebook", sorted({notebook_of(path) for path in FILES}))
def test_exercises_have_the_names_of_their_modules_and_answers(notebook):
    module = importlib.import_module(f"course_lib.lessons.{notebook}.check")
    names = [check.exercise.name for check in module.CHECKS]
    assert [*module.EXERCISES, *getattr(module, "MORE", ())] == names
    assert {path.stem for path in FILES if notebook_of(path) == notebook} == set(names)
