"""Each check against the notebook's own solution with one small mistake made in it by machine.

A mutant that the check accepts answers as the solution does on wider inputs, or as rightly if the
exercise has several right answers (see equal_mutants.py). The summary of the test run shows the
counts.
"""

import math
from dataclasses import replace

import pytest
from equal_mutants import Solution
from mutants import NOTEBOOKS, made, mutants, solved, spread
from test_bank import FILES, exercise_of, notebook_of

from course_lib.checks.exercise import PUBLIC_SEED
from course_lib.checks.judge import LocalFunction, judge
from course_lib.checks.verdict import RIGHT
from course_lib.checks.write_test import WriteTest

MAX_MUTANTS = 35  # of the mutants of an exercise, of which every second one is tried
SLOW = (
    "random_rotations random_quaternions newton_ik panda_ik plan_pick good_matches reached_targets "
    "test_wrap_angle"
)
SLOW += " test_log_so3 test_subproblem2"  # of which sixteen are tried
TOO_LARGE = "axis=-2"  # with it random_rotations asks for gigabytes
# A line of the given code. Newton's last step makes all six numbers short at once, which hides this.
AS_RIGHT = {
    "newton_ik": ["return np.linalg.norm(V[:3]) <= 1e-06 and np.linalg.norm(V[4:]) <= 1e-06"],
    # Of several largest sets it returns the last one. The task does not say which.
    "good_matches": ["if good.sum() >= best.sum():"],
    # Of several patterns that fit equally well, each is accepted.
    "find_signs": ["if worst <= least:"],
}
ENOUGH = 1000  # passes through loops that a call may make, besides five times those of the solution


class Judge:
    """Asks a check about mutants.

    Neither the name of a mistake nor the functions that are called matter here.
    """

    def __init__(self, exercise, space):
        self.exercise = exercise = replace(exercise, mistakes=[], forbidden=())
        self.name, self.passes, self.parts, self.space = (
            exercise.name,
            space["passes"],
            list(parts(exercise)),
            space,
        )

    def accepts(self, solution):
        """Return whether the check accepts the solution, and bound the passes through loops by
        those that it makes."""
        self.passes.most, self.passes.allowed = 0, math.inf
        said = self.lives(solution)
        self.passes.allowed = ENOUGH + 5 * self.passes.most
        return said

    def lives(self, mutant):
        """Return whether the check accepts a mutant.

        The part that refuses it comes first for the next mutant.
        """
        student = LocalFunction(made(mutant, self.name, self.space))
        refusing = next((part for part in self.parts if judge(part, student).state != RIGHT), None)
        if refusing:
            self.parts.remove(refusing)
            self.parts.insert(0, refusing)
        return refusing is None


def parts(exercise):
    """Yield exercises that together ask what this one asks: one for each case, those that the
    engine makes included, then what holds across the cases."""
    if isinstance(exercise, WriteTest):
        both = [next(v for v in exercise.versions if v.right is right) for right in (True, False)]
        yield replace(exercise, versions=tuple(both))
        yield exercise
        return
    alone = tuple(wanted for wanted in exercise.properties if not wanted.across)
    cases, _ = exercise.questions(PUBLIC_SEED)
    nothing_more = {"sweeps": (), "angles": (), "small": (), "free": (), "special": None}
    single = replace(exercise, properties=alone, broken=None, **nothing_more)
    for case in cases:
        yield replace(single, cases=lambda rng, case=case: [case])
    if exercise.broken or alone != exercise.properties:
        yield exercise


@pytest.mark.slow
# The interrupt for processor time may come while a mutant's objects are deleted, where nothing can
# catch it.
@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
@pytest.mark.parametrize("path", FILES, ids=[f"{notebook_of(path)}-{path.stem}" for path in FILES])
def test_a_mutant_is_refused_or_equal(path, record_property):
    exercise, name = exercise_of(path), path.stem
    (notebook,) = (found.stem for found in NOTEBOOKS.glob(f"[0-9][0-9]_{notebook_of(path)}.ipynb"))
    space, sources = solved(notebook)
    judge_of, solution = Judge(exercise, space), Solution(exercise, space, sources)
    assert judge_of.accepts(sources[name])
    every = mutants(sources[name])
    tried = [
        mutant
        for mutant in (
            spread(every, 16) if name in SLOW.split() else spread(every, MAX_MUTANTS)[::2]
        )
        if TOO_LARGE not in mutant.source
    ]
    alive = [mutant for mutant in tried if judge_of.lives(mutant.source)]
    assert 2 * len(alive) < len(tried), f"the check of {name} accepts most mutants"
    different = [mutant.line for mutant in alive if not solution.is_equalled_by(mutant.source)]
    record_property(
        "mutants", (notebook, name, *map(str, (len(every), len(tried), len(alive), len(different))))
    )
    # Whether the inputs drawn here show that a right one answers differently is chance.
    unexplained = [line for line in different if line not in AS_RIGHT.get(name, [])]
    assert not unexplained, (
        f"the check of {name} accepts these mutants, which answer differently from the solution: "
        f"{unexplained}. Let its cases or properties distinguish them, or, if they are right too, "
        "list them in AS_RIGHT"
    )
