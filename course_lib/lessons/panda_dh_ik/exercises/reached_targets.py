"""reached_targets: which of many targets damped least squares reaches, in the limits and in so many
steps."""

import numpy as np

from course_lib import ik
from course_lib.checks.answer_types import numbers
from course_lib.checks.declared import declared
from course_lib.checks.exercise import Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.kinds import OWN_CASES
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import Sweep
from course_lib.checks.vocabulary import remembered
from course_lib.lessons.panda_dh_ik.exercises.shared import HIGH, LOW, PANDA, READY
from course_lib.rotations import exp_so3

_REACHED = 1e-3  # metres and radians
_WHOLE = np.array([0, -1, 0, -2, 0, 2, 1])
_TWO_WHOLE = np.array([_WHOLE, [0, 0, 0, -2, 0, 2, 0]])
_BESIDE_THE_BOUND = (0.3, -0.3, 0.1, -0.1, 0.01, -0.01, 1e-4, -1e-4, 1e-6, -1e-6)
# From here one step with eps = 1e-6 leads to 0.4 mm from the target, the next to 3 mm, and the
# third to 0.04 mm.
_PASSING = np.array([-0.107, 0.83, 0.509, -0.359, 1.817, 0.075, -1.281])
_PASSED = np.array([-0.0783, 0.7986, 0.3386, -0.3516, 2.0003, 0.0513, -1.2196])


def _descended(targets, q0, eps, steps, clip="each"):
    """Return the errors (steps + 1, n, 6), those after the last step included; clip: "each" step,
    at the "end"."""
    q, errors = np.zeros((len(targets), 7)) + q0, []
    for _ in range(int(steps)):
        J, e = PANDA.geometric_jacobian(q), ik.pose_error(PANDA.fk(q), targets)
        errors.append(e)
        A = J @ np.swapaxes(J, -1, -2) + eps * np.eye(6)
        q = q + np.einsum("nij,ni->nj", J, np.linalg.solve(A, e[..., None])[..., 0])
        q = np.clip(q, LOW, HIGH) if clip == "each" else q
    q = np.clip(q, LOW, HIGH) if clip == "end" else q
    return np.array([*errors, ik.pose_error(PANDA.fk(q), targets)])


def _sizes(errors):
    """Return the lengths of both halves, (..., 2): radians and metres."""
    return np.linalg.norm(errors.reshape(*errors.shape[:-1], 2, 3), axis=-1)


@remembered
def _right(targets, q0, eps, steps):
    """Return the right answer, computed once for equal arguments."""
    return (_sizes(_descended(targets, q0, eps, steps)[-1]) < _REACHED).all(-1)


def _clipped(clip):
    """Return the answer that ignores the limits, or clips at the "end" only."""
    return lambda *case: (_sizes(_descended(*case, clip)[-1]) < _REACHED).all(-1)


def _with_eps(number):
    return lambda targets, q0, eps, steps: _right(targets, q0, float(number(eps)), steps)


def _shows_all(case, found):
    """Return whether other limits and another damping show in a case."""
    ignored = _clipped("")(*case)
    others = [answer(*case) for answer in (_clipped("end"), *map(_with_eps, (np.square, np.sqrt)))]
    return (ignored & ~found).any() and all((other != found).any() for other in others)


def _case(rng, n, q0, eps, steps, spread, limited=False):
    """Return n targets, some of which are reached and some are not, none of them a close call.

    limited: one of those not reached is reached by whoever ignores the limits, and clipping at the
    end only, and another damping, show too.
    """
    while True:
        targets = PANDA.fk(np.clip(READY + spread * rng.uniform(-1, 1, (4 * n, 7)), LOW, HIGH))
        near_end = _sizes(_descended(targets, q0, eps, steps + 2)[-4:]).max(-1)
        targets = targets[(near_end < _REACHED / 3).all(0) | (near_end > 20 * _REACHED).all(0)][:n]
        found = _right(targets, q0, eps, steps)
        if len(targets) < n or found.all() or not found.any():
            continue
        case = targets, q0, eps, steps
        if not limited or _shows_all(case, found):
            return case


def _cases(rng):
    near = PANDA.fk(READY + 0.1 * rng.uniform(-1, 1, (3, 7)))
    far = near[0].copy()
    far[0, 3] = 3.0
    halves = np.tile(
        PANDA.fk(READY), (6, 1, 1)
    )  # some with the right position, or the right orientation, only
    angles, metres = np.array([[0, 0.04, 0, 0.8e-3, 1.3e-3, 0], [0, 0, 0.03, 0.8e-3, 0, 1.3e-3]])
    halves[:, :3, :3] = exp_so3(angles[:, None] / np.sqrt([3, 3, 3])) @ halves[:, :3, :3]
    halves[:, :3, 3] += metres[:, None] / np.sqrt([3, 3, 3])
    others = np.clip(READY + 0.4 * rng.uniform(-1, 1, 7), LOW, HIGH)
    passed, starts = PANDA.fk(np.array([_PASSED, READY])), np.array([_PASSING, others])
    seven = np.clip(READY + 0.3 * rng.uniform(-1, 1, (7, 7)), LOW, HIGH)
    # The first step reaches this target, beyond the limit of joint 6, unless it is clipped.
    below = np.where(np.arange(7) == 5, HIGH - 0.004, READY)
    beyond = np.where(np.arange(7) == 5, HIGH + 0.036, READY)
    aside = PANDA.fk(READY)
    aside[1, 3] += 1.2 * _REACHED
    return [
        (np.array([near[0], far]), READY, 0.01, 20),
        _case(rng, 10, READY, 0.01, 20, 2.0, limited=True),
        _case(rng, 6, others, 0.05, 35, 1.5),
        (near, READY, 0.01, 15),
        (PANDA.fk(HIGH[None] + 0.1), HIGH + 0.1, 0.01, 0),
        (halves, READY, 1000.0, 2),
        *((passed, starts, 1e-6, steps) for steps in (1, 2, 3)),
        (PANDA.fk(np.array([_WHOLE, READY])), _WHOLE, 0.01, 15),
        (PANDA.fk(seven), seven, 0.01, 1),  # as many starts as joints
        (PANDA.fk(_TWO_WHOLE + 0.1), _TWO_WHOLE, 0.03, 20),
        (aside[None], READY, 10.0, 40),  # all steps are short, and lead there
        (PANDA.fk(beyond[None]), below, 1e-6, 1),
    ]


def _beside_the_bound(half):
    """Return the case(rng, gap) of a start whose error, in one half, is near the bound."""

    def case(rng, gap):
        target = PANDA.fk(READY)
        if half == "metres":
            target[0, 3] += _REACHED * (1 + gap)
        else:
            target[:3, :3] = exp_so3([0, _REACHED * (1 + gap), 0]) @ target[:3, :3]
        return target[None], READY, 0.01, 0

    return case


def _never_at_the_start(targets, q0, eps, steps):
    return _right(targets, q0, eps, steps) if steps else np.zeros(len(targets), bool)


def _one_half(k):
    return lambda *case: _sizes(_descended(*case)[-1])[:, k] < _REACHED


def _found(found, *case):
    """Return in words which target is the first that counts otherwise."""
    right = _right(*case)
    k = int(np.argmax(found != right))
    counts = ("does not count", "counts")
    reached, yours = counts[int(right[k])], counts[int(found[k])]
    metres, radians = _sizes(_descended(*case)[-1])[k]
    position = format_tuple(case[0][k, :3, 3])
    return (
        f"targets[{k}], whose position is {position}, {reached} as reached; in your answer it "
        f"{yours}. The two halves of its error are {metres:.4g} and {radians:.4g} after the last "
        "step."
    )


EXERCISE = declared(
    "reached_targets",
    points=3,
    sets=1,
    arguments=dict.fromkeys(("targets", "q0", "eps", "steps"), OWN_CASES),
    cases=_cases,
    reads=numbers(lambda targets, *rest: (len(targets),)),
    library=_right,
    tries_arguments=False,
    properties=(
        Property(
            "the answer is True or False for each target",
            lambda found, *case: np.isin(found, [0, 1]).all(),
            otherwise=Question(
                "something other than True or False is returned",
                "Which comparison gives True or False, and what does your code return?",
            ),
        ),
    ),
    says="a target is reached if after the last of the damped steps, each clipped to the limits, "
    "both halves of its error are below 1e-3",
    found=_found,
    otherwise=Question(
        "the steps, or the test after them, differ from the task's",
        "Follow this target through your function. At which row of q0 does it start, what changes "
        "q before, in and after each of the steps, how many steps are there, and which errors are "
        "compared with which bound at the end?",
    ),
    sweeps=tuple(
        Sweep(f"{half} next to the bound", _beside_the_bound(half), _BESIDE_THE_BOUND)
        for half in ("metres", "radians")
    ),
    hints=(
        "The functions of the library take batches: panda.fk(q) for q of shape (n, 7) has shape "
        "(n, 4, 4). Begin with q = np.zeros((len(targets), 7)) + q0, and take `steps` steps with "
        "all targets at once.",
        "One damped step for all: x = np.linalg.solve(A, e[..., None]) with A = J J^T + eps I of "
        "shape (n, 6, 6), then J^T x. Swap the last two axes of J with np.swapaxes(J, -1, -2).",
        "After the last step compute the errors once more: both norms, of e[:, :3] and e[:, 3:], "
        "must be below 1e-3.",
    ),
    forbidden=("course_lib.ik.solve",),
    mistakes=(
        Mistake(
            "one number is returned",
            "The answer is True or False for each target: its mean is the share.",
            form=(),
        ),
        Mistake(
            "a batch is transposed, multiplied or solved as if it were one matrix",
            "J has the shape (n, 6, 7). Which shape does J.T have, and which shape does e need?",
            raises=("ValueError", "core dimension"),
        ),
        Mistake(
            "the limits are ignored, or applied at the end only",
            "From which configuration does each step start?",
            _clipped(""),
            _clipped("end"),
        ),
        Mistake(
            "with no steps no target counts as reached",
            "What does the task say about steps = 0?",
            _never_at_the_start,
        ),
        Mistake(
            "only the position, or only the orientation, is compared with the bound",
            "Which two lengths does the task compare with 1e-3?",
            _one_half(0),
            _one_half(1),
        ),
        Mistake(
            "the number on the diagonal is not eps",
            "Print the matrix that you invert minus J J^T. Which number stands on its diagonal?",
            _with_eps(np.square),
            _with_eps(np.sqrt),
        ),
        Mistake(
            "a target counts as reached as soon as any step comes close to it",
            "At the end of how many steps does the task judge a target?",
            lambda *case: (_sizes(_descended(*case)) < _REACHED).all(-1).any(0),
        ),
    ),
)
