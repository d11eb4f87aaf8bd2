"""Modules that a notebook imports and that are neither installed nor handed in with it."""

import re
from dataclasses import replace

from course_lib.checks.reasons import first_error
from course_lib.checks.verdict import ERROR, NOT_ATTEMPTED, Verdict
from course_lib.pack.grade.hand_ins import notebook_file
from course_lib.pack.grade.jail.statements import no_python
from course_lib.pack.grade.verdicts.grading import Grading, Outcome

NOT_HANDED_IN = (
    "It imports {}, which is not installed here and was not handed in with it. What needs it was "
    "not graded: ask the student for a notebook that holds all of its own code."
)
MISSES_SOMETHING = ("NameError", "ImportError", "ModuleNotFoundError")  # types of errors


def note_missing(grading: Grading, name: str) -> None:
    """Note the name of a module that an import did not find, if the notebook imports it."""
    if re.fullmatch(r"[A-Za-z_]\w{0,60}", name) is None:
        return
    imported = re.compile(rf"\b(import|from)\s+[\w., ]*\b{name}\b")
    if any(map(imported.search, grading.sources)):
        grading.missing_modules.add(name)


def modules_missing(grading: Grading) -> list[str]:
    """Return the modules that the notebook needs and that are not there, without those of installed
    names."""
    written = re.compile(r"^\s*%run\s+(?:-\S+\s+)*['\"]?([\w./-]+)", re.MULTILINE)
    files = {name for source in grading.sources for name in written.findall(source)}
    made = re.compile(r"^\s*%%(?:writefile|file)\s+(?:-a\s+)?(\S+)", re.MULTILINE)
    files -= {name for source in grading.sources for name in made.findall(source)}
    return sorted({*grading.missing_modules, *files})


def explain_missing(grading: Grading, outcomes: dict[str, Outcome]) -> None:
    """Say of each function that is not there, or misses something, why that is so."""
    missing = ", ".join(modules_missing(grading))
    for name, outcome in outcomes.items():
        verdict = outcome.verdict
        if verdict.state == NOT_ATTEMPTED:
            why = no_python(grading.sources, name)
            if not why and missing and not notebook_file.defines(grading.sources, name):
                why = (
                    f"{name} is not in the notebook, which imports {missing}. That is not handed "
                    f"in with it: only what stands in the notebook is graded."
                )
            if why:
                outcomes[name] = Outcome(Verdict(verdict.exercise, ERROR, why))
        elif missing and verdict.state == ERROR and _misses_something(verdict):
            remark = f"The notebook imports {missing}, which is not handed in with it."
            outcomes[name] = replace(outcome, remark=remark)


def _misses_something(verdict: Verdict) -> bool:
    """Return whether the answer ended in an error that a missing name or module raises."""
    error = first_error(verdict.reason)
    return error is not None and error.kind in MISSES_SOMETHING
