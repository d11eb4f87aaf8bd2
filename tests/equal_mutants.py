"""Whether a mutant of a notebook's solution answers as the solution does, on more inputs than its check asks.

The inputs are the exercise's cases with other seeds, and these cases with an argument changed, wherever the solution is
right on them: the exercise's properties hold, and its library answers the same. A test is asked about the candidates of
its exercise and about mutants of the function that it tests.
"""

from dataclasses import replace
from functools import cached_property, partial

import numpy as np
from mutants import made, mutants, spread

from course_lib import rotations
from course_lib.arms import panda
from course_lib.checks.exercise import RIGHT, Here, Property, attempt, judge
from course_lib.checks.write_test import Version, WriteTest

SEEDS = range(100, 103)
VARIED = 40
MOST = 40  # inputs besides the cases of one seed; half as many candidates of a test, besides its exercise's
TOLERANCE = 1e-6  # absolute and relative
SAMPLES = 20_000  # of a random answer
STANDARD_ERRORS = 5  # by which its moments may differ


# A form in which all right answers are equal, for the exercises that accept more than one ----------------------------


def _set(rows, *case):
    """Angles, or rows of them, in any order and up to whole revolutions."""
    rows = np.reshape(rows, (len(rows), -1))
    circles = np.concatenate([np.cos(rows), np.sin(rows)], axis=1)
    return np.sort(circles @ np.random.default_rng(0).normal(size=(circles.shape[1], 4)), axis=0)


def _line(vector, *case):
    return np.multiply.outer(vector, vector)


def _three_angles(triples, R):
    b1, b2, b3 = np.transpose(triples)
    return np.sort(b2), rotations.rot_y(b1) @ rotations.rot_x(b2) @ rotations.rot_y(b3)


def _causes(q):
    """Which of the iiwa's joints are at a singular angle."""
    return np.abs(np.concatenate([q[:, [1, 3, 5]], np.cos(q[:, [2, 4]])], axis=1)) < TOLERANCE


def _moments(samples):
    """The means of products of up to four entries, and their standard errors."""
    x = np.reshape(samples, (len(samples), -1))
    z = np.concatenate([np.ones((len(x), 1)), x, x**2], axis=1)
    products = (z[:, :, None] * z[:, None]).reshape(len(x), -1)
    if np.ndim(samples) == 3:
        products = np.column_stack([products, np.linalg.det(samples)])
    return products.mean(axis=0), products.std(axis=0) / np.sqrt(len(x))


FORMS = {
    "log_so3": lambda w, R: rotations.exp_so3(w),
    "slerp": _line,
    "matrix_to_quaternion": _line,
    "singular_configurations": _causes,
    "euler_yxy": _three_angles,
    "subproblem1": lambda angle, *case: (np.cos(angle), np.sin(angle)),
    "panda_ik": lambda q, *case: panda().fk(q),
    "plan_pick": lambda rows, *case: panda().fk(rows[-1, 1:]),
    **dict.fromkeys(("two_link_angles", "subproblem2", "subproblem3", "subproblem4"), _set),
    **dict.fromkeys(("arm_angles", "six_axis_ik"), _set),
    **dict.fromkeys(("random_rotations", "random_quaternions"), _moments),
}


def agree(name, value, expected, case=()):
    """Return whether two answers to a case of the exercise of this name are equal, or as right as each other."""
    form = FORMS.get(name)
    if form is _moments:
        (mean, error), (expected, other_error) = _moments(value), _moments(expected)
        return bool((np.abs(mean - expected) <= STANDARD_ERRORS * np.hypot(error, other_error) + TOLERANCE).all())
    formed = [form and attempt(form, np.array(answer, float), *case) for answer in (value, expected)]
    return _equal(value, expected) if formed[1] is None else formed[0] is not None and _equal(*formed)


def _equal(value, expected):
    if isinstance(value, tuple | list) and isinstance(expected, tuple | list) and len(value) == len(expected):
        return all(map(_equal, value, expected))
    try:
        value, expected = np.asarray(value, float), np.asarray(expected, float)
    except (TypeError, ValueError):
        return bool(value == expected)
    return value.shape == expected.shape and np.allclose(value, expected, TOLERANCE, TOLERANCE, equal_nan=True)


# The solution and a mutant, asked the same ----------------------------------------------------------------------------


class Solution:
    """The solution of an exercise: its source, among the names of a notebook and the sources of its other solutions."""

    def __init__(self, exercise, space, sources):
        mistakes = type(exercise.mistakes)()  # none: what a wrong answer is called does not matter here
        self.exercise = replace(exercise, mistakes=mistakes, forbidden=(), broken=None)
        self.space, self.sources = space, sources

    def is_equalled_by(self, mutant):
        """Return whether a mutant, given as source, answers everywhere as the solution does."""
        if isinstance(self.exercise, WriteTest):
            return self._judges(self._student(mutant), self._versions)
        cases, expected = self._wider
        got = self._answers(mutant, cases)
        return len(got) == len(cases) and all(map(partial(agree, self.exercise.name), got, expected, cases))

    @cached_property
    def _wider(self):
        """The wider inputs and the solution's answers to them."""
        own, rng = self.sources[self.exercise.name], np.random.default_rng(0)
        cases, *others = (self.exercise.cases(np.random.default_rng(seed)) for seed in SEEDS)
        if FORMS.get(self.exercise.name) is _moments:
            cases = [(SAMPLES, *cases[0][1:])]
        elif cases[0]:
            more = [case for seed in others for case in seed]
            pairs = rng.integers(len(more), size=(VARIED, 2))
            varied = (_varied(more[i], more[j], rng) for i, j in pairs)
            more += [case for case in varied if attempt(self._is_right, own, case)]
            cases += [more[i] for i in rng.permutation(len(more))[:MOST]]
        return cases, self._answers(own, cases)

    def _is_right(self, source, case):
        expected = self.exercise.library(*case)  # raises for most of the inputs that are none
        properties = tuple(wanted for wanted in self.exercise.properties if not wanted.across)
        asked = replace(self.exercise, cases=lambda rng: [case], properties=properties)
        if judge(asked, self._student(source)).state != RIGHT:
            return False
        return agree(self.exercise.name, *self._answers(source, [case]), expected, case)

    def _answers(self, source, cases):
        """Return the answers of the function with this source, none if one of them is missing or of another kind."""
        found = []
        record = Property("", lambda values, cases: found.extend(values), across=True)
        judge(replace(self.exercise, cases=lambda rng: cases, properties=(record,)), self._student(source), seconds=60)
        return found

    def _student(self, source):
        return Here(made(source, self.exercise.name, self.space))

    @cached_property
    def _versions(self):
        """The candidates that a test is asked to judge, each as right or wrong as the solution says."""
        tested = self.exercise.name.removeprefix("test_")
        others = spread(mutants(self.sources[tested]), MOST // 2) if tested in self.sources else []
        functions = [_raising_value_errors(made(other.source, tested, self.space)) for other in others]
        own, student = self.exercise.versions, self._student(self.sources[self.exercise.name])
        both = [[Version("", function, right) for right in (True, False)] for function in functions]
        return own + tuple(each for pair in both for each in pair if self._judges(student, [each]))

    def _judges(self, student, versions):
        """Return whether a student's test accepts the right versions, of which it needs one, and refuses the wrong."""
        either = [next(v for v in self.exercise.versions if v.right is right) for right in (True, False)]
        return judge(replace(self.exercise, versions=(*either, *versions)), student, seconds=60).state == RIGHT


def _raising_value_errors(function):
    def candidate(*arguments):
        try:
            return np.array(function(*arguments), float)
        except Exception as error:  # whatever a mutant raises
            raise ValueError(str(error)) from error

    return candidate


def _varied(case, other, rng):
    """Return a case with one argument of another case, or with the numbers of one argument changed."""
    case, k, how = list(case), rng.integers(len(case)), rng.integers(3)
    if how == 0 or not (isinstance(case[k], float | np.ndarray) and np.asarray(case[k]).dtype.kind == "f"):
        case[k] = other[k]
    elif how == 1:
        case[k] = case[k] * rng.uniform(0.3, 3)
    else:
        case[k] = case[k] + rng.normal(0, 0.3, np.shape(case[k]))
    return tuple(case)
