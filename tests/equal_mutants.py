"""Whether a mutant of a notebook's solution answers as the solution does, on more inputs than its
check asks.

The inputs are the exercise's cases with other seeds, and these cases with an argument changed,
wherever the solution is right on them: the exercise's properties hold, and its library answers the
same. A test is asked about the candidates of its exercise and about mutants of the function that it
tests.
"""

from dataclasses import replace
from functools import cached_property

import numpy as np
from mutants import made, mutants, spread

from course_lib.checks.comparisons import attempt
from course_lib.checks.exercise import Property
from course_lib.checks.judge import LocalFunction, judge
from course_lib.checks.verdict import RIGHT
from course_lib.checks.write_test import Version, WriteTest

SEEDS = range(100, 103)
VARIED = 12
MAX_CASES = (
    12  # inputs besides the cases of one seed; as many candidates of a test, besides its exercise's
)

# These have more than one right answer to an input: the properties of the exercise decide.
SEVERAL = (
    "slerp euler_yxy subproblem1 subproblem2 subproblem3 subproblem4 arm_angles six_axis_ik "
    "two_link_angles"
)
SEVERAL += " singular_configurations panda_ik plan_pick random_rotations random_quaternions"
SEVERAL += " split_branches read_ur5e"


class Solution:
    """The solution of an exercise: its source, among the names of a notebook and the sources of its
    other solutions."""

    def __init__(self, exercise, space, sources):
        mistakes = type(
            exercise.mistakes
        )()  # none: what a wrong answer is called does not matter here
        self.exercise = replace(exercise, mistakes=mistakes, forbidden=(), broken=None)
        self.space, self.sources, self.own = space, sources, sources[exercise.name]

    def is_equalled_by(self, mutant):
        """Return whether a mutant, given as source, answers everywhere as the solution does."""
        if isinstance(self.exercise, WriteTest):
            return self._judges(self._student(mutant), self._versions)
        return self._is_right(mutant, *self._wider)

    @cached_property
    def _wider(self):
        """The wider inputs and the solution's answers to them."""
        rng = np.random.default_rng(0)
        cases, *others = (self.exercise.cases(np.random.default_rng(seed)) for seed in SEEDS)
        if cases[0]:
            more = [case for seed in others for case in seed]
            pairs = rng.integers(len(more), size=(VARIED, 2))
            more += [
                case for i, j in pairs if self._is_input(case := _varied(more[i], more[j], rng))
            ]
            cases += [more[i] for i in rng.permutation(len(more))[:MAX_CASES]]
        return cases, self._answers(self.own, cases)

    def _is_input(self, case):
        expected = attempt(
            self.exercise.library, *case
        )  # None for most of the inputs that are none
        return expected is not None and self._is_right(self.own, [case], [expected])

    def _is_right(self, source, cases, expected):
        """Return whether the function with this source is right in each case and, if one answer is,
        gives it."""
        alone = tuple(wanted for wanted in self.exercise.properties if not wanted.across)
        got = self._answers(source, cases, *alone)
        if len(got) != len(cases) or self.exercise.name in SEVERAL.split():
            return len(got) == len(cases)
        return all(map(self.exercise.alike, got, expected, *zip(*cases, strict=True)))

    def _answers(self, source, cases, *properties):
        """Return the answers of the function with this source; none if one is missing or lacks a
        property."""
        found = []
        record = Property("", lambda values, cases: found.extend(values), across=True)
        asked = replace(self.exercise, cases=lambda rng: cases, properties=(*properties, record))
        judge(asked, self._student(source), seconds=60)
        return found[: len(cases)]  # the engine asks cases that it makes itself after these

    def _student(self, source):
        return LocalFunction(made(source, self.exercise.name, self.space))

    @cached_property
    def _versions(self):
        """The candidates that a test is asked to judge, each as right or wrong as the solution
        says."""
        tested = self.exercise.name.removeprefix("test_")
        others = spread(mutants(self.sources[tested]), MAX_CASES) if tested in self.sources else []
        functions = [made(other.source, tested, self.space) for other in others]
        either = [
            [Version("", function, right) for right in (True, False)] for function in functions
        ]
        student = self._student(self.own)
        return self.exercise.versions + tuple(
            v for both in either for v in both if self._judges(student, [v])
        )

    def _judges(self, student, versions):
        """Return whether a student's test accepts the right versions, of which it needs one, and
        refuses the wrong."""
        either = [
            next(v for v in self.exercise.versions if v.right is right) for right in (True, False)
        ]
        return (
            judge(replace(self.exercise, versions=(*either, *versions)), student, seconds=60).state
            == RIGHT
        )


def _varied(case, other, rng):
    """Return a case with one argument of another case, or with the numbers of one argument
    changed."""
    case, k, how = list(case), rng.integers(len(case)), rng.integers(3)
    if how == 0 or not (
        isinstance(case[k], float | np.ndarray) and np.asarray(case[k]).dtype.kind == "f"
    ):
        case[k] = other[k]
    elif how == 1:
        case[k] = case[k] * rng.uniform(0.3, 3)
    else:
        case[k] = case[k] + rng.normal(0, 0.3, np.shape(case[k]))
    return tuple(case)
