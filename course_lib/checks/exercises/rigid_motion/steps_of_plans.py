"""Mistakes in the steps of a plan, which following it with a body and with an arm share."""

import numpy as np

from course_lib.checks.exercises.rigid_motion.shared import follow


def _full(count):
    """Steps of dt, as many as count(duration / dt)."""
    return lambda duration, dt: np.full(int(count(duration / dt)), dt)


def add_step_mistakes(exercise, right, move):
    """Add them to an exercise.

    right(start, plan, dt): the answer; move(row, velocity, h): a step of it.
    """

    @exercise.mistake
    def start_missing(start, plan, dt):
        """start is missing. With what does the list of rows begin?"""
        return right(start, plan, dt)[1:]

    @exercise.mistake(
        count=(lambda ratio: np.ceil(ratio - 1e-6), np.ceil, np.round, lambda ratio: max(1, round(ratio)))
    )
    def not_on_time(start, plan, dt, count):
        """the last step of a pair is not shortened, and the pair ends too late or too early. How much time of its
        duration remains for the last step?"""
        return follow(move, _full(count))(start, plan, dt)

    @exercise.mistake(count=(lambda ratio: np.floor(ratio + 1e-6), int))
    def rest_lost(start, plan, dt, count):
        """the time that remains after the whole steps is lost. Each pair ends on time: which step takes what
        remains?"""
        return follow(move, _full(count))(start, plan, dt)

    @exercise.mistake
    def one_step_a_pair(start, plan, dt):
        """only one step is taken for each pair. dt says how long a step is: how many does a pair of 0.25 s have?"""
        return follow(move, lambda duration, dt: [duration])(start, plan, dt)

    @exercise.mistake
    def start_again(start, plan, dt):
        """each pair begins at start again. Where did the pair before end?"""
        parts = [right(start, [pair], dt)[1:] for pair in plan]
        return np.concatenate([np.array([start], float), *parts])

    @exercise.mistake
    def row_twice(start, plan, dt):
        """the row at which a pair begins occurs twice. It is the last row of the pair before."""
        rows = [np.array([start], float)]
        for pair in plan:
            rows.append(right(rows[-1][-1], [pair], dt))
        return np.concatenate(rows[1:])

    @exercise.mistake
    def one_array(start, plan, dt):
        """all rows are one and the same array. An array that changes in place changes in every row: append a copy."""
        rows = right(start, plan, dt)
        return rows[[-1] * len(rows)]
