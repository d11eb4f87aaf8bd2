"""compose: one more rotation, about the axes of the world or of the body."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.naming import difference
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import any_rotation
from course_lib.rotations import rot_x, rot_y, rot_z


def _right(R, step, frame):
    return step @ R if frame == "world" else R @ step


def _cases(rng):
    quarter = np.pi / 2
    pairs = [(rot_z(quarter), rot_x(quarter)), (rot_x(quarter), rot_y(0.3))]
    pairs += [(any_rotation(rng), any_rotation(rng)) for _ in range(3)] + [(np.eye(3), rot_z(1.0))]
    return [(R, step, frame) for R, step in pairs for frame in ("world", "body")]


def _agrees(new, R, step, frame):
    return difference(new, _right(R, step, frame)) <= EXACT


_FACTORS = Mistake(
    "the answer is not the product of R and step for this frame",
    "Which two matrices does your line multiply, is each of them as it came, and which of them "
    "acts first on a point of the body?",
)

EXERCISE = Exercise(
    name="compose",
    points=1,
    arguments=("R", "step", "frame"),
    tolerance=EXACT,
    cases=_cases,
    small=("R", "step"),
    returns=numbers(lambda R, step, frame: (3, 3)),
    library=_right,
    properties=(
        Property(
            'with frame = "world", step rotates every point of the body about the world\'s axes',
            _agrees,
            where=lambda R, step, frame: frame == "world",
            mistake=_FACTORS,
        ),
        Property(
            'with frame = "body", step rotates the body about its own axes, where R has taken them',
            _agrees,
            where=lambda R, step, frame: frame == "body",
            mistake=_FACTORS,
        ),
    ),
    hints=(
        "Let p be a point of the body, in the body's coordinates. In the world's coordinates it is "
        "R p.",
        "If step is about the world's axes, it acts on R p. If it is about the body's axes, it "
        "acts on p.",
        'frame "world": step R; frame "body": R step.',
    ),
)


@EXERCISE.mistake(
    "world and body are swapped",
    "In `step @ R @ p`, which rotation acts last, and about whose axes?",
)
def world_and_body_swapped(R, step, frame):
    return R @ step if frame == "world" else step @ R


@EXERCISE.mistake(
    "the frame makes no difference",
    "Compare both orders for rotations by 90 degrees about z and about x.",
    order=(1, -1),
)
def frame_not_used(R, step, frame, order):
    first, second = (R, step)[::order]
    return first @ second


@EXERCISE.mistake(
    "step rotates in the opposite direction",
    "Does the task ask for step, or for its inverse? Which line transposes or inverts it?",
    frames=(("world", "body"), ("world",), ("body",)),
)
def step_reversed(R, step, frame, frames):
    return _right(R, step.T if frame in frames else step, frame)


@EXERCISE.mistake(
    "* works entry by entry",
    "In numpy the product of matrices is @.",
)
def entry_by_entry(R, step, frame):
    return R * step
