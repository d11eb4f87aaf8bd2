"""Ask once more whatever is not right, with right functions in place of the others."""

from collections.abc import Sequence
from dataclasses import replace

from course_lib.checks.exercise import ERROR, RIGHT, WRONG, Exercise, Verdict, with_blame
from course_lib.checks.follow_through import in_circles
from course_lib.pack.grade.jail.statements import needed, stubs_only
from course_lib.pack.grade.verdicts.attempt import all_forbidden, attempt
from course_lib.pack.grade.verdicts.progress import Instead, Outcome, Run

# Words without which a function reads only names that it writes down.
FINDS_NAMES = ("globals", "locals", "vars", "eval", "exec", "getattr", "import_", "importlib")
FINDS_NAMES += ("sys", "gc", "inspect", "__dict__", "__main__", "get_ipython")


def follow_through(run: Run, outcomes: dict[str, Outcome]) -> None:
    """Ask once more whatever is not right, with right functions in place of all others that are
    not.

    Those that it called are known by having been asked. Functions that call each other in a circle
    earn nothing by it, and nothing is earned by a call that the task excludes.
    """
    wrong = [e for e in run.exercises if outcomes[e.name].verdict.state != RIGHT]
    instead = {e.name: [other for other in wrong if other is not e] for e in wrong}
    unwritten = stubs_only(run.statements) | run.untouched
    asked = [e for e in wrong if e.name not in unwritten and _is_named(run, e)]
    judged_again = {}
    for whole in (False, True):
        exercises = [
            e
            for e in asked
            if outcomes[e.name].whole == whole and (whole or _may_call(run, e, wrong))
        ]
        if exercises and len(wrong) > 1 and not run.over():
            judged_again |= _with_right_ones(run, exercises, whole, instead)
    calls = {name: outcome.called for name, outcome in judged_again.items()}
    circles = in_circles(calls)
    for name, again in judged_again.items():
        before = outcomes[name]
        if name in circles:
            others = " and ".join([name, *circles[name]])
            outcomes[name] = replace(before, remark=f"Your {others} call each other in a circle.")
        elif again.verdict.mistake is not None and again.verdict.mistake.name in _refusals(again):
            outcomes[name] = again
        elif not again.called:
            continue
        elif _is_no_worse(again.verdict, before.verdict):
            outcomes[name] = replace(again, instead=again.called)
        elif before.verdict.state in (WRONG, ERROR):
            blamed = [outcomes[other].verdict for other in again.called]
            outcomes[name] = replace(before, verdict=with_blame(before.verdict, blamed))


def _is_no_worse(again: Verdict, before: Verdict) -> bool:
    """Return whether a verdict with right functions in place of others says more of the answer
    itself."""
    if again.points == before.points:
        return again.state == WRONG
    return again.points > before.points


def _refusals(outcome: Outcome) -> list[str]:
    """Return the names of the mistakes of calling each function that the task excludes."""
    return [f"{name} is called" for name in outcome.called]


def _is_named(run: Run, exercise: Exercise) -> bool:
    """Return whether the notebook names the function at all, so that it may call others."""
    return any(exercise.name in source for source in run.sources)


def _may_call(run: Run, exercise: Exercise, others: Sequence[Exercise]) -> bool:
    """Return whether the cells that a function needs name another exercise at all, or find names by
    other ways than by writing them."""
    cells = {statement.cell for statement in needed(run.statements, [exercise.name])}
    text = "\n".join(run.sources[cell] for cell in sorted(cells))
    names = [other.name for other in others if other is not exercise]
    return any(name in text for name in (*names, *FINDS_NAMES))


def _with_right_ones(
    run: Run, exercises: Sequence[Exercise], whole: bool, instead: Instead
) -> dict[str, Outcome]:
    """Return {name: Outcome} with right functions in place of others, in one process or each in its
    own."""
    outcomes = attempt(run, exercises, all_forbidden(exercises), whole, instead)
    for exercise in exercises:
        outcome = outcomes[exercise.name]
        may_be_better = outcome.too_late or (outcome.hindered and outcome.called)
        if may_be_better and not run.over():
            forbidden = frozenset(exercise.forbidden)
            outcomes |= attempt(run, [exercise], forbidden, whole, instead)
    return outcomes
