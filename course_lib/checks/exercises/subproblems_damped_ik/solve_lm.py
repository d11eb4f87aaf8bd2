"""solve_lm: the path of the planar arm's joints to a point, step by step."""

from itertools import pairwise

import numpy as np

from course_lib.checks.answer_types import rows
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.subproblems_damped_ik.lm_step import WRAPPED, allowed, off, step
from course_lib.checks.exercises.subproblems_damped_ik.planar_jacobian import ARMS, tip
from course_lib.checks.format_numbers import format_array

_TIPS = Mistake("the positions of the tip are returned, not the joint angles", "Which arrays do you keep?")
_TRANSPOSED = Mistake("rows and columns have changed places", "One row for each step, one column for each joint.")


def _cases(rng):
    bent, whole = np.array([0, 0, 0, np.pi / 2]), np.array([1, -1, 1, 0])
    named = [(bent, [2, 1], 1.0, 1.0, 1), (bent, [2, 1], 1.0, 1.0, 2), (bent, [2.2, 1.8], 0.2, 2.0, 6)]
    named += [(bent, [3, 1], 0.2, 2.0, 4), (np.zeros(4), [3, 4], 0.2, 2, 5), (whole, [1, 2], 0.5, 1, 4)]
    drawn = [
        (rng.uniform(0.3, 1.2, 4) * rng.choice([-1, 1], 4), rng.uniform(-2, 2, 2), alpha, eps, steps)
        for alpha, eps, steps in ((0.5, 1.0, 2), (0.2, 0.5, 10), (0.8, 5.0, 7), (1.0, 0.1, 20), (0.4, 20.0, 12))
    ]
    reached = rng.uniform(0.3, 1.2, 4)
    drawn.append((np.array([0.2, 3.5, 3.0, -4.0]), [1, 2], 0.2, 2.0, 3))  # angles beyond pi
    ends = [(reached, tip(reached), 0.2, 2.0, 5), (drawn[0][0], drawn[0][1], 0.3, 1.0, 0)]
    return [(q0, np.array(target, float), alpha, eps, steps) for q0, target, alpha, eps, steps in named + drawn + ends]


def _read(value, q0, target, alpha, eps, steps):
    def known(array):
        transposed = array.shape == (4, steps + 1)
        return _TRANSPOSED if transposed else _TIPS if array.shape[1:] == (2,) else None

    return rows(4, f"an array of shape ({steps + 1}, 4)", most=2 * steps + 8, known=known)(value)


def _path(q0, target, alpha, eps, steps, step=step):
    path = [np.array(q0, float)]
    for _ in range(steps):
        path.append(step(path[-1], target, alpha, eps))
    return np.array(path)


def _steps_that_fit(path, *rest):
    """Return whether each row follows from the row before it by a step."""
    return [off(after, step(before, *rest)) < allowed(before, *rest) for before, after in pairwise(path)]


def _is_unwrapped(path, q0, *rest):
    """Return whether each row, right up to multiples of 2 pi, is where the step leads."""
    wanted = [np.asarray(q0, float), *(step(before, *rest[:3]) for before in path[:-1])]
    return np.abs(path - wanted).max() < 1


def _begins(path, q0, target, alpha, eps, steps):
    return off(path[0], q0) < 1e-9 if len(path) else steps == 0


def _first_row(path, q0, *rest):
    return f"Yours is {format_array(path[0], 5)}." if len(path) else "Your answer is empty."


def _wrong_row(path, q0, target, alpha, eps, steps):
    k = _steps_that_fit(path, target, alpha, eps).index(False)
    wanted = step(path[k], target, alpha, eps)
    yours = f"Your row {k + 1} is {format_array(path[k + 1], 5)}."
    return f"From row {k}, {format_array(path[k], 5)}, a step leads to {format_array(wanted, 5)}. {yours}"


def _same(path, predicted, *case):
    predicted = np.asarray(predicted)
    return path.shape == predicted.shape and (path.size == 0 or off(path, predicted) < 1e-6)


EXERCISE = Exercise(
    name="solve_lm",
    points=2,
    arguments=("q0", "target", "alpha", "eps", "steps"),
    cases=_cases,
    returns=_read,
    library=_path,
    alike=_same,
    properties=(
        Property("the first row is q0", _begins, _first_row),
        Property(
            "each row follows from the row before it by one damped step",
            lambda path, q0, target, alpha, eps, steps: all(_steps_that_fit(path, target, alpha, eps)),
            _wrong_row,
        ),
        Property(
            "there are steps + 1 rows: q0, and one after each step",
            lambda path, q0, target, alpha, eps, steps: len(path) == steps + 1,
            lambda path, q0, target, alpha, eps, steps: (
                f"With steps = {steps} that is {steps + 1}. Yours has {len(path)}."
            ),
        ),
        Property("no angle jumps by 2 pi: the path of a joint has no gaps", _is_unwrapped, mistake=WRAPPED),
    ),
    hints=(
        "A list with a copy of q0 in it, and a loop over range(steps) that appends lm_step of the last entry.",
        "path = [np.array(q0, float)], then path.append(lm_step(path[-1], target, alpha, eps)), then np.array(path).",
        "lm_step must not change its q in place: the rows kept before would change with it.",
    ),
    forbidden=("course_lib.ik.damped_path", "course_lib.ik._damped_step", *ARMS),
)


@EXERCISE.mistake
def whole_numbers(*case):
    """digits after the point are cut off. Does an array made like q0 hold decimals if q0 holds whole numbers?"""
    return _path(*case, lambda *now: np.trunc(step(*now))) if case[0].dtype.kind == "i" else None


@EXERCISE.mistake(last=(1, 2))
def start_missing(*case, last):
    """q0 is missing: the first row is that after the first step. What do you keep before the loop begins?"""
    return _path(*case[:4], case[4] + 1)[1 : case[4] + last]


@EXERCISE.mistake
def one_array(*case):
    """every row is the same array, changed in place: all show the last angles. Does append copy an array?"""
    return np.tile(_path(*case)[-1], (case[4] + 1, 1))


@EXERCISE.mistake(reached=(lambda *case: step(*case[:4]), lambda *case: case[0]))
def always_from_the_start(*case, reached):
    """all steps start from q0, or none is kept. Where does each step start, and which name gets its result?"""
    return np.array([case[0]] + [reached(*case)] * case[4])


def _part(path, *case):
    right = _path(*case)
    return 0 < len(path) < len(right) and off(path, right[: len(path)]) < 1e-6


@EXERCISE.mistake(rows=(lambda steps: steps, lambda steps: min(steps + 1, 10)), seen=_part)
def too_few(*case, rows):
    """the path ends before all steps are taken. How many times does the loop run, and what ends it?"""
    return _path(*case)[: rows(case[4])]
