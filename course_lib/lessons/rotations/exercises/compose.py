"""compose: one more rotation, about the axes of the world or of the body."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.kinds import FACTOR, one_of
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.tolerances import EXACT
from course_lib.rotations import rot_x, rot_y, rot_z

FRAMES = ("world", "body")
_QUARTER = np.pi / 2


def _right(R, step, frame):
    return step @ R if frame == "world" else R @ step


def _reversed_in(*frames):
    return lambda R, step, frame: _right(R, step.T if frame in frames else step, frame)


def _cases(rng):
    pairs = [(rot_z(_QUARTER), rot_x(_QUARTER)), (rot_x(_QUARTER), rot_y(0.3))]
    pairs += [(np.eye(3), rot_z(1.0)), (FACTOR.drawn(rng), FACTOR.drawn(rng))]
    return [(R, step, frame) for R, step in pairs for frame in FRAMES]


EXERCISE = declared(
    "compose",
    points=1,
    arguments={"R": FACTOR, "step": FACTOR, "frame": one_of(*FRAMES)},
    cases=_cases,
    tolerance=EXACT,
    library=_right,
    says='with frame = "world", step rotates every point of the body about the world\'s axes; with '
    'frame = "body", about the body\'s own axes, where R has taken them',
    otherwise=Question(
        "the answer is not the product of R and step for this frame",
        "Which two matrices does your code multiply here, is each of them as it came, and which of "
        "them acts first on a point of the body? How does it decide about frame, and would it "
        "decide so for an equal word that another line has made?",
    ),
    hints=(
        "Let p be a point of the body, in the body's coordinates. In the world's coordinates it is "
        "R p.",
        "If step is about the world's axes, it acts on R p. If it is about the body's axes, it "
        "acts on p.",
        'frame "world": step R; frame "body": R step.',
    ),
    mistakes=(
        Mistake(
            "world and body are swapped",
            "In `step @ R @ p`, which rotation acts last, and about whose axes?",
            lambda R, step, frame: R @ step if frame == "world" else step @ R,
        ),
        Mistake(
            "the frame makes no difference",
            "Compare both orders for rotations by 90 degrees about z and about x. Which line of "
            "yours decides about frame, and would it decide so for an equal word that another "
            "line has made?",
            lambda R, step, frame: R @ step,
            lambda R, step, frame: step @ R,
        ),
        Mistake(
            "step rotates in the opposite direction",
            "Does the task ask for step, or for its inverse? Which line transposes or inverts it?",
            _reversed_in(*FRAMES),
            _reversed_in("world"),
            _reversed_in("body"),
        ),
        Mistake(
            "* works entry by entry",
            "In numpy the product of matrices is @.",
            lambda R, step, frame: R * step,
        ),
    ),
)
