"""compose: one more rotation, about the axes of the world or of the body."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.vocabulary import any_rotation, argument_returned, entry_by_entry, transposed
from course_lib.rotations import rot_x, rot_y, rot_z

_OTHER = {"world": "body", "body": "world"}


def _right(R, step, frame):
    return step @ R if frame == "world" else R @ step


def _cases(rng):
    quarter = np.pi / 2
    pairs = [(rot_z(quarter), rot_x(quarter)), (rot_x(quarter), rot_y(0.3))]
    pairs += [(any_rotation(rng), any_rotation(rng)) for _ in range(3)] + [(np.eye(3), rot_z(1.0))]
    return [(R, step, frame) for R, step in pairs for frame in ("world", "body")]


EXERCISE = Exercise(
    name="compose",
    points=1,
    arguments=("R", "step", "frame"),
    cases=_cases,
    returns=numbers(lambda R, step, frame: (3, 3)),
    library=_right,
    properties=(
        Property(
            'about the world\'s axes (frame = "world"), every point of the rotated body is rotated by step',
            lambda new, R, step, frame: np.allclose(new, _right(R, step, frame), atol=1e-9),
            where=lambda R, step, frame: frame == "world",
        ),
        Property(
            'about the body\'s own axes (frame = "body"), step is made before R carries everything along',
            lambda new, R, step, frame: np.allclose(new, _right(R, step, frame), atol=1e-9),
            where=lambda R, step, frame: frame == "body",
        ),
    ),
    mistakes=(
        Mistake(
            "world and body are swapped",
            "The factor next to the point acts first, about the axes in which the point is given.",
            lambda R, step, frame: _right(R, step, _OTHER[frame]),
        ),
        Mistake(
            "the frame makes no difference",
            "Compare both orders for rotations by 90 degrees about z and about x: they end differently.",
            lambda R, step, frame: step @ R,
            lambda R, step, frame: R @ step,
        ),
        transposed(
            _right, "the transpose, which is the inverse, is returned", "Neither R nor step has to be transposed."
        ),
        Mistake(
            "one of the two is transposed",
            "Neither R nor step has to be transposed.",
            lambda R, step, frame: _right(R, step.T, frame),
            lambda R, step, frame: _right(R.T, step, frame),
        ),
        Mistake(
            "R stands on both sides of step",
            "R step R^T is step as seen from the world. What is missing to make it the new orientation?",
            lambda R, step, frame: R @ step @ R.T,
            lambda R, step, frame: R @ step @ R.T if frame == "body" else step @ R,
            lambda R, step, frame: R.T @ step @ R,
        ),
        entry_by_entry(lambda R, step, frame: R * step),
        Mistake("the matrices are added", "Rotations follow one another as products.", lambda R, step, frame: R + step),
        argument_returned(0, "R is returned without the new rotation"),
        argument_returned(1, "step is returned without R"),
    ),
    hints=(
        "Let p be a point of the body, in the body's coordinates. In the world's coordinates it is R p.",
        "If step is about the world's axes, it acts on R p. If it is about the body's axes, it acts on p.",
        'frame "world": step R; frame "body": R step.',
    ),
)
