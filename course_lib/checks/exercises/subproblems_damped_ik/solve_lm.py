"""solve_lm: the path of the planar arm's joints to a point, step by step."""

from itertools import pairwise

import numpy as np

from course_lib.checks.answer_types import rows
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.subproblems_damped_ik.lm_step import WRAPPED, WRONG_STEPS, allowed, off, step
from course_lib.checks.exercises.subproblems_damped_ik.planar_jacobian import ARMS, jacobian, tip
from course_lib.checks.format_numbers import format_array

_TIPS = Mistake(
    "the positions of the tip are returned, not the joint angles",
    "Keep q after each step. The tip positions follow from it later.",
)
_TRANSPOSED = Mistake("the transpose is returned", "One row for each step, one column for each joint: np.array(...).T.")
_NUMBERS = Mistake("one number is kept for each step", "Keep q itself, all four angles, after each step.")


def _cases(rng):
    bent = np.array([0, 0, 0, np.pi / 2])
    named = [(bent, [2, 1], 1.0, 1.0, 1), (bent, [2, 1], 1.0, 1.0, 2), (bent, [2.2, 1.8], 0.2, 2.0, 6)]
    named += [
        (bent, [3, 1], 0.2, 2.0, 4),
        (np.zeros(4), [3, 4], 0.2, 2, 5),
        (np.array([1, -1, 1, 0]), [1, 2], 0.5, 1, 4),
    ]
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
        if array.shape == (4, steps + 1):
            return _TRANSPOSED
        if array.shape in ((steps,), (steps + 1,)):
            return _NUMBERS
        return _TIPS if array.shape[-1:] == (2,) else None

    return rows(4, f"an array of shape ({steps + 1}, 4)", most=2 * steps + 8, known=known)(value)


def _from(q0, count, *rest):
    """The right path of `count` steps."""
    path = [np.array(q0, float)]
    for _ in range(count):
        path.append(step(path[-1], *rest))
    return np.array(path)


def _path(q0, target, alpha, eps, steps):
    return _from(q0, steps, target, alpha, eps)


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


def _row_by_row(name, hint, *nexts):
    """The mistake of somebody whose next row is one of next(q0, q, target, alpha, eps), q being the row before it."""

    def seen(path, q0, target, alpha, eps, steps):
        for next_of in nexts:
            after = [next_of(q0, q, target, alpha, eps) for q in path[:-1]]
            if after and off(path[1:], after) < 1e-6 * (1 + np.abs(after).max()):
                return True
        return False

    return Mistake(name, hint, seen=seen)


def _rows_of(change):
    """The rows that change(path, steps) makes of the right path, of two steps more than are asked for."""
    return lambda q0, target, alpha, eps, steps: change(_from(q0, steps + 2, target, alpha, eps), steps)


def _kept(J_of, e_of):
    """The next row of somebody who takes J and e at J_of(q0, q) and e_of(q0, q)."""

    def next_of(q0, q, target, alpha, eps):
        J, e = jacobian(J_of(q0, q)), tip(e_of(q0, q)) - target
        return q - alpha * J.T @ np.linalg.solve(J @ J.T + eps * np.eye(2), e)

    return next_of


def _changing(q0, target, alpha, eps, steps, change):
    """The path with change(alpha, k) in step k, k from 1 on."""
    path = [np.array(q0, float)]
    for k in range(1, steps + 1):
        path.append(step(path[-1], target, change(alpha, k), eps))
    return np.array(path)


def _with_fixed(a, e):
    """Return the answer of somebody who takes a for alpha, or e for eps; None where that makes no difference."""

    def answer(q0, target, alpha, eps, steps):
        used = alpha if a is None else a, eps if e is None else e
        return None if used == (alpha, eps) else _from(q0, steps, target, *used)

    return answer


def _part_of_the_path(path, *case):
    right = _path(*case)
    return 0 < len(path) < len(right) and off(path, right[: len(path)]) < 1e-6


def _of_a_wrong_step(mistake):
    """The mistake of somebody who repeats a wrong step."""
    nexts = (lambda q0, *case, wrong=wrong: wrong(*case) for wrong in mistake.answers)
    return _row_by_row(f"each step is wrong: {mistake.name}", mistake.hint, *nexts)


def _first(q0, q):
    return q0


def _latest(q0, q):
    return q


EXERCISE = Exercise(
    name="solve_lm",
    points=2,
    arguments=("q0", "target", "alpha", "eps", "steps"),
    cases=_cases,
    returns=_read,
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
        Property(
            "no angle jumps by 2 pi: the path of a joint has no gaps",
            _is_unwrapped,
            mistake=WRAPPED,
        ),
    ),
    mistakes=(
        Mistake(
            "digits after the point are cut off",
            "An array made like q0, or np.array([1, -1, 1, 0]), holds whole numbers only: np.array(q0, float).",
            seen=lambda path, q0, *rest: (
                q0.dtype.kind == "i" and len(path) > 1 and np.array_equal(path, np.trunc(path))
            ),
        ),
        Mistake(
            "q0 is missing: the first row is that after the first step",
            "Keep q0 before the loop begins.",
            _rows_of(lambda path, steps: path[1 : steps + 1]),
            _rows_of(lambda path, steps: path[1 : steps + 2]),
            _rows_of(lambda path, steps: path[1:steps]),
        ),
        Mistake(
            "only the last angles are returned",
            "Keep q after each step: the whole path is asked for.",
            _rows_of(lambda path, steps: path[steps : steps + 1]),
        ),
        Mistake(
            "every row is the same array, changed in place: all show the last angles",
            "Appending q does not copy it. Make a new array in each step, or append q.copy().",
            _rows_of(lambda path, steps: np.tile(path[steps], (steps + 1, 1))),
            _rows_of(lambda path, steps: np.tile(path[steps], (steps, 1))),
        ),
        Mistake(
            "the rows are in reverse order",
            "q0 is the first row, the last angles are the last.",
            _rows_of(lambda path, steps: path[steps::-1]),
        ),
        Mistake(
            "one step too few is taken",
            "range(steps) counts steps of them, from 0 to steps - 1.",
            _rows_of(lambda path, steps: path[:steps]),
        ),
        Mistake(
            "one step too many is taken",
            "range(steps) counts steps of them; with q0 that makes steps + 1 rows.",
            _rows_of(lambda path, steps: path[: steps + 2]),
        ),
        Mistake(
            "q0 appears twice",
            "q0 once, and then the angles after each step.",
            _rows_of(lambda path, steps: np.vstack([path[:1], path[: steps + 1]])),
            _rows_of(lambda path, steps: np.vstack([path[:1], path[:steps]])),
        ),
        Mistake(
            "all steps start from q0",
            "Each step starts where the last one ended: q = lm_step(q, ...).",
            lambda q0, target, alpha, eps, steps: np.array([q0] + [step(q0, target, alpha, eps)] * steps),
        ),
        Mistake(
            "q stays at q0: no step is kept",
            "q = lm_step(q, ...): the result needs a name.",
            lambda q0, target, alpha, eps, steps: np.tile(q0, (steps + 1, 1)),
        ),
        Mistake(
            "the last row is never filled",
            "With steps + 1 rows there are steps steps to fill in: rows 1 to steps.",
            _rows_of(lambda path, steps: np.vstack([path[:steps], np.zeros((1, 4))])),
        ),
        _row_by_row(
            "J and the error are not recomputed in each step",
            "Both depend on q: compute them in the loop.",
            _kept(_first, _first),
        ),
        _row_by_row(
            "J is not recomputed in each step", "J depends on q: compute it in the loop.", _kept(_first, _latest)
        ),
        _row_by_row(
            "the error is not recomputed in each step",
            "e = tip(q) - target, with the present q.",
            _kept(_latest, _first),
        ),
        Mistake(
            "the steps are kept rather than the angles",
            "Keep q after each step, not what is taken off it.",
            lambda q0, *rest: np.vstack([q0, np.diff(_path(q0, *rest), axis=0)]),
        ),
        Mistake(
            "alpha or eps is a fixed number, not the argument",
            "lm_step(q, target, alpha, eps): pass on the numbers that your function is given.",
            *(_with_fixed(a, e) for a, e in ((0.2, 2.0), (0.2, None), (None, 2.0), (1.0, None), (None, 1.0))),
        ),
        Mistake(
            "the number of steps is fixed",
            "Make as many steps as the argument `steps` says.",
            seen=lambda path, *case: len(path) in (100, 101) and len(path) != case[-1] + 1,
        ),
        Mistake(
            "alpha changes from step to step",
            "alpha is the same in all steps.",
            *(
                lambda q0, target, alpha, eps, steps, change=change: _changing(q0, target, alpha, eps, steps, change)
                for change in (lambda a, k: a**k, lambda a, k: a / k)
            ),
        ),
        Mistake(
            "it stops before all steps are taken",
            "All steps are asked for, also when the tip is there already: the array has steps + 1 rows.",
            seen=_part_of_the_path,
        ),
        *map(_of_a_wrong_step, WRONG_STEPS),
    ),
    alike=_same,
    library=_path,
    hints=(
        "A list with a copy of q0 in it, and a loop over range(steps) that appends lm_step of the last entry.",
        "path = [np.array(q0, float)], then path.append(lm_step(path[-1], target, alpha, eps)), then np.array(path).",
        "lm_step must not change its q in place: the rows kept before would change with it.",
    ),
    forbidden=("course_lib.ik.damped_path", "course_lib.ik._damped_step", *ARMS),
)
