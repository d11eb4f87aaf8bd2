"""Each check against the notebook's own solution with one small mistake made in it by machine.

A mutant that the check lets live stands in equivalent_mutants.py: with the reason why it answers as the solution does,
or, where it does not, with an input that tells the two apart: a hole in the check. `pytest -rP` prints the counts.
"""

import time
from dataclasses import replace

import pytest
from equivalent_mutants import EQUIVALENT, HOLES, REASONS
from mutants import NOTEBOOKS, made, mutants, solved, spread
from test_bank import FILES, exercise_of

from course_lib.checks.exercise import RIGHT, Here, judge
from course_lib.checks.write_test import WriteTest

MOST = 40  # of the mutants of an exercise
SLOW = {"random_rotations": 16, "panda_ik": 16}
TOO_LARGE = "axis=-2"  # with it random_rotations asks for gigabytes
FIRST = 3  # cases that are asked before all of them


class Judge:
    """Says of a mutant whether it lives. Neither the name of its mistake nor what it calls matters here."""

    def __init__(self, exercise, space):
        self.exercise, self.space = replace(exercise, mistakes=(), forbidden=()), space
        self.seconds = 60

    def bounded_by(self, source):
        """Allow a mutant many times the processor time of this source, since it may never end; say whether it lives."""
        begin = time.process_time()
        said = self.lives(source)
        self.seconds = 1 + 5 * (time.process_time() - begin)
        return said

    def lives(self, source):
        student = Here(made(source, self.exercise.name, self.space))
        return all(judge(asked, student, seconds=self.seconds).state == RIGHT for asked in self._asked())

    def _asked(self):
        """A part of the exercise, which is enough to refuse most mutants, and then the whole exercise."""
        if isinstance(self.exercise, WriteTest):
            both = [next(v for v in self.exercise.versions if v.right is right) for right in (True, False)]
            yield replace(self.exercise, versions=tuple(both))
        elif not any(wanted.across for wanted in self.exercise.properties):
            yield replace(self.exercise, cases=lambda rng: self.exercise.cases(rng)[:FIRST], broken=None)
        yield self.exercise


# The clock may ring while a mutant's objects are thrown away, where nobody can catch it.
@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
@pytest.mark.parametrize("path", FILES, ids=[f"{path.parent.name}-{path.stem}" for path in FILES])
def test_a_mutant_is_refused_or_known(path, record_property):
    exercise, name = exercise_of(path), path.stem
    (notebook,) = (found.stem for found in NOTEBOOKS.glob(f"[0-9][0-9]_{path.parent.name}.ipynb"))
    space, sources = solved(notebook)
    judge_of = Judge(exercise, space)
    assert judge_of.bounded_by(sources[name])
    every = mutants(sources[name])
    tried = [mutant for mutant in spread(every, SLOW.get(name, MOST)) if TOO_LARGE not in mutant.source]
    alive = {mutant.line for mutant in tried if judge_of.lives(mutant.source)}
    equivalent, holes = set(EQUIVALENT.get(name, {})), set(HOLES.get(name, {}))
    counts = {"mutants": len(every), "tried": len(tried), "refused": len(tried) - len(alive)}
    counts |= {"alive, equivalent": len(alive & equivalent), "alive, a hole": len(alive & holes)}
    record_property("mutants", (notebook, name, *map(str, counts.values())))
    print(f"{notebook} {name}: " + ", ".join(f"{count} {what}" for what, count in counts.items()))
    for line in sorted(alive & equivalent):
        print(f"    {line}\n        {REASONS[EQUIVALENT[name][line]]}")
    for line in sorted(alive & holes):
        print(f"    {line}\n        NOT equivalent: {HOLES[name][line]}")
    assert sorted(alive - equivalent - holes) == [], "these live, and nobody has said why"
    assert sorted((equivalent | holes) - alive) == [], "these are listed, and do not arise or no longer live"


def test_what_is_listed_belongs_to_an_exercise_and_has_its_reason():
    names = [path.stem for path in FILES]
    assert len(set(names)) == len(names)
    assert set(EQUIVALENT) | set(HOLES) <= set(names)
    assert {reason for lines in EQUIVALENT.values() for reason in lines.values()} == set(REASONS)
    assert [name for name in EQUIVALENT if set(EQUIVALENT[name]) & set(HOLES.get(name, {}))] == []


def test_mutants_change_one_thing_and_are_spread_over_the_kinds():
    found = mutants('def f(a, b):\n    """Text."""\n    return a[0] @ b.T + 2 * a')
    lines = {mutant.line for mutant in found}
    assert {"return a[1] @ b.T + 2 * a", "return a[0] @ b + 2 * a", "return b.T @ a[0] + 2 * a"} <= lines
    assert {"return a[0] @ b.T - 2 * a", "return a[0] @ b.T", "return a[0] @ b.T + -2 * a"} <= lines
    assert len(lines) == len(found)
    few = spread(found, 6)
    assert len(few) == 6
    assert len({mutant.kind for mutant in few}) == 6


def test_mutants_are_known_by_the_same_lines_after_a_reformatting_and_leave_broken_code_alone():
    compact = 'def f(a, b):\n    """Text."""\n    c = (a+b)*2\n    return [c, "x"]'
    airy = (
        "def f(\n    a,\n    b,\n):\n    'Text.'\n    c = (\n        (a + b) * 2\n    )\n\n"
        "    return [\n        c,\n        'x',\n    ]"
    )
    broken = compact + "\n    return a - b"
    assert {m.line for m in mutants(compact)} == {m.line for m in mutants(airy)} == {m.line for m in mutants(broken)}
