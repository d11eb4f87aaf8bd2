"""Ask once more whatever is not right, with right functions in place of the others."""

from collections.abc import Sequence
from dataclasses import replace

from course_lib.checks.exercise import Exercise
from course_lib.checks.follow_through import followed_through, in_circles
from course_lib.checks.verdict import RIGHT
from course_lib.pack.grade.jail.statements import needed, stubs_only
from course_lib.pack.grade.verdicts.grading import Grading, Instead, Outcome
from course_lib.pack.grade.verdicts.notebook_run import all_forbidden, run_and_ask
from course_lib.pack.grade.verdicts.whole_run import only_by_names


def ask_with_right_functions(grading: Grading, outcomes: dict[str, Outcome]) -> None:
    """Ask once more whatever is not right, with right functions in place of all others that are
    not; see course_lib/checks/follow_through.py.
    """
    wrong = [e for e in grading.exercises if outcomes[e.name].verdict.state != RIGHT]
    instead = {e.name: [other for other in wrong if other is not e] for e in wrong}
    unwritten = stubs_only(grading.statements) | grading.untouched
    asked = [e for e in wrong if e.name not in unwritten and _is_named(grading, e)]
    judged_again = {}
    for whole in (False, True):
        exercises = [
            e
            for e in asked
            if outcomes[e.name].whole == whole and (whole or _may_call(grading, e, wrong))
        ]
        if exercises and len(wrong) > 1 and not grading.is_out_of_time():
            judged_again |= _in_one_run_or_alone(grading, exercises, whole, instead)
    circles = in_circles({name: outcome.called for name, outcome in judged_again.items()})
    for name, again in judged_again.items():
        verdict = followed_through(
            outcomes[name].verdict,
            lambda again=again: again.verdict,
            [grading.exercise_named(other) for other in again.called],
            circles.get(name),
        )
        outcomes[name] = replace(outcomes[name], verdict=verdict)


def _is_named(grading: Grading, exercise: Exercise) -> bool:
    """Return whether the notebook names the function at all, so that it may call others."""
    return any(exercise.name in source for source in grading.sources)


def _may_call(grading: Grading, exercise: Exercise, others: Sequence[Exercise]) -> bool:
    """Return whether the cells that a function needs name another exercise at all, or find names by
    other ways than by writing them."""
    cells = {statement.cell for statement in needed(grading.statements, [exercise.name])}
    names = [other.name for other in others if other is not exercise]
    if any(name in grading.sources[cell] for name in names for cell in cells):
        return True
    return not only_by_names(grading.sources[cell] for cell in cells - grading.given_cells)


def _in_one_run_or_alone(
    grading: Grading, exercises: Sequence[Exercise], whole: bool, instead: Instead
) -> dict[str, Outcome]:
    """Return {name: Outcome} with right functions in place of others, in one process or each in its
    own."""
    outcomes = run_and_ask(grading, exercises, all_forbidden(exercises), whole, instead)
    for exercise in exercises:
        outcome = outcomes[exercise.name]
        may_be_better = outcome.too_late or (outcome.hindered and outcome.called)
        if may_be_better and not grading.is_out_of_time():
            forbidden = frozenset(exercise.forbidden)
            outcomes |= run_and_ask(grading, [exercise], forbidden, whole, instead)
    return outcomes
