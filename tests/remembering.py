"""Exercises as they are, but for what they compute again and again: that is kept for the next answer that is judged.

A bank of answers and forty mutants are judged on the same cases. The cases of a seed are drawn once, and what a known
mistake predicts of each of them is computed once. Nothing may change such a case: its arrays can only be read.
"""

import copy
from dataclasses import replace
from functools import cache

import numpy as np

from course_lib.checks.exercise import attempt


@cache
def remembering(exercise):
    """Return an exercise with the same verdicts, which draws its cases once a seed and predicts once a case."""
    cases = _Cases(exercise.cases)
    known = {id(m): m for m in (*exercise.mistakes, *(p.mistake for p in exercise.properties)) if m}
    copies = {None: None} | {key: _with_memory(mistake, cases) for key, mistake in known.items()}
    return replace(
        exercise,
        cases=cases,
        mistakes=tuple(copies[id(mistake)] for mistake in exercise.mistakes),
        properties=tuple(replace(p, mistake=copies[p.mistake and id(p.mistake)]) for p in exercise.properties),
    )


class _Cases:
    """Draws the cases of a generator's state once."""

    def __init__(self, draw):
        self.draw, self.drawn, self.own = draw, {}, {}

    def __call__(self, rng):
        state = repr(rng.bit_generator.state)
        if state not in self.drawn:
            self.drawn[state] = cases = self.draw(rng)
            for case in cases:
                _only_read(case)
                self.own[tuple(map(id, case))] = case  # which keeps each id that of one thing
        return list(self.drawn[state])


def _only_read(value):
    if isinstance(value, np.ndarray):
        value.flags.writeable = False
    elif isinstance(value, list | tuple | dict):
        for item in value.values() if isinstance(value, dict) else value:
            _only_read(item)


def _with_memory(mistake, cases):
    """A copy of a mistake that computes once what it predicts of a case that was drawn."""
    mistake = copy.copy(mistake)
    mistake.answers = tuple(_Predictions(answer, cases.own) for answer in mistake.answers)
    return mistake


class _Predictions:
    def __init__(self, answer, own):
        self.answer, self.own, self.known = answer, own, {}

    def __call__(self, *case):
        key = tuple(map(id, case))
        if key not in self.own:
            return self.answer(*case)
        if key not in self.known:
            self.known[key] = attempt(self.answer, *case)
        return self.known[key]
