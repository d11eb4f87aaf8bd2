"""How often a function is asked in grading: for several sets of cases, and not at all where a
student has written nothing."""

from types import SimpleNamespace

import numpy as np
import pytest
from hostile.build import NAME, OTHERS, SEED, book
from toy_exercises import NEAREST_SO, right

from course_lib.checks.judge import LocalFunction, review
from course_lib.checks.messages import describe
from course_lib.checks.verdict import RIGHT, WRONG
from course_lib.checks.wire import read
from course_lib.pack.grade.bounded import cpu_deadline
from course_lib.pack.grade.hand_ins import notebook_file
from course_lib.pack.grade.hand_ins.notebook_file import courses
from course_lib.pack.grade.jail.sandbox import Limits
from course_lib.pack.grade.verdicts import follow_through, judging, submission
from course_lib.pack.grade.verdicts.grading import Grading
from course_lib.pack.grade.verdicts.judging import ask_and_judge
from course_lib.pack.grade.verdicts.submission import grade

ALL_EXERCISES = [exercise for course in courses().values() for exercise in course.exercises]
SECRET_SEEDS = 20

# ---- several sets of cases ----


class InThisProcess(SimpleNamespace):
    """A student's function in this process, with what judging.ask_and_judge wants to know of it."""

    def __init__(self, function, **about):
        usual = {"ended": "", "too_slow": False, "hindered": False, "too_late": False}
        super().__init__(**usual | {"candidates": False, "called": (), "asked": 0} | about)
        self.function, self.exercise = function, NEAREST_SO

    def reply(self, questions, consult=None):
        self.asked += 1
        self.cases = len(read(questions)["cases"])
        return LocalFunction(self.function).reply(questions, consult)


def wrong_for_one_set_in(number):
    """Return a function whose answers are wrong for about one set of cases in so many."""

    def answer(M):
        is_unlucky = int(abs(M).sum() * 1e6) % number == 1  # one case of a set is random
        return -right(M) if is_unlucky else right(M)

    return answer


def outcome(function, seed):
    return ask_and_judge(Grading([], Limits(), seed, (NEAREST_SO,), None), function, {})


def test_a_right_answer_is_asked_for_several_sets_of_cases():
    function = InThisProcess(right)
    assert outcome(function, SEED).verdict.state == RIGHT
    assert function.asked == 1 + NEAREST_SO.sets >= 3


def test_a_wrong_answer_is_asked_once_more_with_the_same_cases():
    function = InThisProcess(lambda M: M)
    assert outcome(function, SEED).verdict.state == WRONG
    assert function.asked == 2, "again, in case it is random, and for no other set"


def test_the_second_time_a_wrong_answer_is_asked_no_more_than_what_its_message_quotes():
    student = InThisProcess(lambda M: M)
    quoted = outcome(student, SEED).verdict.case
    cases = NEAREST_SO.questions(NEAREST_SO.public_seeds[0])[0]
    assert any(np.array_equal(quoted[0], case[0]) for case in cases[: student.cases])
    assert student.cases < len(cases)


def test_a_student_s_test_is_asked_for_one_set_of_cases():
    """Each of its candidates has a sandbox of its own, which takes a second."""
    function = InThisProcess(right, candidates=True)
    outcome(function, SEED)
    assert function.asked == 1


def test_an_answer_that_is_wrong_for_some_numbers_is_refused():
    answers = (InThisProcess(wrong_for_one_set_in(4)) for _ in range(40))
    states = [outcome(answer, seed).verdict.state for seed, answer in enumerate(answers)]
    assert WRONG in states


def test_grading_asks_the_notebook_s_sets_and_a_secret_one():
    seeds = judging._seeds(Grading([], Limits(), SEED, (NEAREST_SO,), None), NEAREST_SO)
    assert seeds == [*NEAREST_SO.public_seeds, SEED]
    texts = {repr(NEAREST_SO.questions(seed)[0]) for seed in seeds}
    assert len(texts) == len(seeds)


@pytest.mark.slow
@pytest.mark.parametrize("exercise", ALL_EXERCISES, ids=lambda exercise: exercise.name)
def test_cases_of_secret_seeds_are_drawn_within_the_grader_s_bound(exercise):
    """Some are drawn until they are hard enough. A seed for which none is would cost the student
    the points of a right answer."""
    for seed in range(SECRET_SEEDS):
        with cpu_deadline(judging.JUDGING_SECONDS):
            exercise.questions(seed)


def test_a_wrong_answer_gets_the_notebook_s_message():
    in_the_notebook = describe(review(NEAREST_SO, LocalFunction(lambda M: -right(M))))
    graded = {
        describe(outcome(InThisProcess(lambda M: -right(M)), seed).verdict) for seed in range(5)
    }
    assert graded == {in_the_notebook}


# ---- what nobody has worked on ----


@pytest.fixture
def attempts(monkeypatch):
    """The names of the exercises of each run of a notebook."""
    runs = []

    def run_and_ask(grading, exercises, *rest, **named):
        runs.append(sorted(exercise.name for exercise in exercises))
        return one_run(grading, exercises, *rest, **named)

    one_run = submission.run_and_ask
    for module in (submission, follow_through):
        monkeypatch.setattr(module, "run_and_ask", run_and_ask)
    return runs


def given(name):
    """The cell of an exercise as students get it."""
    (source,) = (text for text in courses()[NAME].given if text.startswith(f"def {name}("))
    return source


@pytest.mark.usefixtures("isolated")
def test_a_notebook_of_right_answers_runs_once(few, attempts):
    first, right = few
    written = [source for source in right if "def is_valid(" not in source]
    result = grade(book(first, *written, given("is_valid")), NAME, SEED)
    states = {row["exercise"]: row["state"] for row in result["exercises"]}
    assert states.pop("is_valid") == "not attempted yet"
    assert set(states.values()) == {"right"}
    assert attempts == [sorted([*OTHERS, "nearest_so"])]


@pytest.mark.parametrize(
    "cell",
    [
        "exec('def is_valid(X, kind, tol): return True')",
        "is_valid = lambda X, kind, tol: True",
        "%%writefile mine.py\ndef is_valid(X, kind, tol): return True",
        "globals()['is_valid'] = print",
        "def ｉs_valid(X, kind, tol): return True",
    ],
)
def test_an_exercise_named_in_an_own_cell_is_worked_on(cell):
    course = courses()[NAME]
    sources = [*course.given, cell]
    names = {exercise.name for exercise in course.exercises}
    assert notebook_file.untouched(course, sources) == names - {"is_valid"}


def test_all_exercises_of_a_given_notebook_are_untouched():
    course = courses()[NAME]
    names = {exercise.name for exercise in course.exercises}
    assert notebook_file.untouched(course, course.given) == names
