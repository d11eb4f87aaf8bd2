"""reached_targets: which of many targets damped least squares reaches, in the limits and in so many steps."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.panda_dh_ik.shared import HIGH, LOW, PANDA, READY
from course_lib.checks.vocabulary import remembered
from course_lib.rotations import exp_so3, log_so3

REACHED = 1e-3  # metres and radians


def _errors_and_jacobians(q, targets):
    """Return the errors (n, 6) and the Jacobians (n, 6, 7), both in the order (v, omega)."""
    frames = PANDA.frames(q)
    T, z, o = frames[:, -1], frames[:, :-1, :3, 2], frames[:, :-1, :3, 3]
    phi = log_so3(targets[:, :3, :3] @ np.swapaxes(T[:, :3, :3], -1, -2))
    J = np.concatenate([np.cross(z, T[:, None, :3, 3] - o), z], -1)
    return np.concatenate([targets[:, :3, 3] - T[:, :3, 3], phi], -1), np.swapaxes(J, -1, -2)


def _descended(targets, q0, eps, steps, clip="each", sign=1):
    """Return the errors (steps + 1, n, 6), those after the last step included; clip: "each" step, at the "end"."""
    q, seen = np.zeros((len(targets), 7)) + q0, []
    for _ in range(steps):
        e, J = _errors_and_jacobians(q, targets)
        seen.append(e)
        A = J @ np.swapaxes(J, -1, -2) + eps * np.eye(6)
        q = q + sign * np.einsum("nij,ni->nj", J, np.linalg.solve(A, e[..., None])[..., 0])
        q = np.clip(q, LOW, HIGH) if clip == "each" else q
    q = np.clip(q, LOW, HIGH) if clip == "end" else q
    inside = ((q >= LOW) & (q <= HIGH)).all(-1, keepdims=True)
    return np.array([*seen, _errors_and_jacobians(q, targets)[0]]), inside[:, 0]


def _small(e, halves=(0, 1)):
    sizes = np.linalg.norm(e.reshape(-1, 2, 3), axis=-1)
    return (sizes[:, list(halves)] <= REACHED).all(-1)


@remembered
def right(targets, q0, eps, steps):
    """Return the right answer, computed once for equal arguments."""
    return _small(_descended(targets, q0, eps, int(steps))[0][-1])


def _clear(targets, q0, eps, steps):
    """Return for which targets the answer does not hang on one step more or less, or on the last digits."""
    errors, _ = _descended(targets, q0, eps, steps + 2)
    sizes = np.linalg.norm(errors.reshape(-1, len(targets), 2, 3), axis=-1).max(-1)
    near_end = sizes[-4:]
    return (near_end < REACHED / 3).all(0) | (near_end > 20 * REACHED).all(0)


def _case(rng, n, q0, eps, steps, spread, limited=False):
    """Return n targets, some of which are reached and some are not, none of them a close call.

    limited: one of those not reached is reached by whoever ignores the limits.
    """
    while True:
        q = np.clip(READY + spread * rng.uniform(-1, 1, (4 * n, 7)), LOW, HIGH)
        targets = PANDA.fk(q)
        targets = targets[_clear(targets, q0, eps, steps)][:n]
        found = right(targets, q0, eps, steps)
        if len(targets) < n or found.all() or not found.any():
            continue
        beyond = np.abs(_descended(targets, q0, eps, steps, clip="")[0][-1]).max(-1) < REACHED / 3
        if not limited or (beyond & ~found).any():
            return targets, q0, eps, steps


def _cases(rng):
    near = PANDA.fk(READY + 0.1 * rng.uniform(-1, 1, (3, 7)))
    far = near[0].copy()
    far[0, 3] = 3.0
    here = PANDA.fk(READY)
    halves = np.array([here, here, here])  # reached; with the right position only; with the right orientation only
    halves[1, :3, :3] = exp_so3([0.03, -0.02, 0.03]) @ here[:3, :3]
    halves[2, :3, 3] += [0.02, -0.02, 0.01]
    others = READY + 0.4 * rng.uniform(-1, 1, 7)
    return [
        (np.array([near[0], far]), READY, 0.01, 20),
        _case(rng, 10, READY, 0.01, 20, 2.0, limited=True),
        _case(rng, 6, np.clip(others, LOW, HIGH), 0.05, 35, 1.5),
        (near, READY, 0.01, 15),
        (halves, READY, 100.0, 2),
    ]


def _other(**options):
    """Return an answer by another descent."""
    return lambda targets, q0, eps, steps: _small(_descended(targets, q0, eps, steps, **options)[0][-1])


def _half(k):
    return lambda targets, q0, eps, steps: _small(_descended(targets, q0, eps, steps)[0][-1], [k])


def _not_inside(targets, q0, eps, steps):
    errors, inside = _descended(targets, q0, eps, steps, clip="")
    return _small(errors[-1]) & inside


_ONE_MATRIX = Mistake(
    "a batch is transposed, multiplied or solved as if it were one matrix",
    "J has the shape (n, 6, 7): its transposes are np.swapaxes(J, -1, -2), and e needs the shape (n, 6, 1).",
)

EXERCISE = Exercise(
    name="reached_targets",
    points=3,
    arguments=("targets", "q0", "eps", "steps"),
    cases=_cases,
    returns=numbers(
        lambda targets, *rest: (len(targets),),
        {(): Mistake("one number is returned", "The answer is True or False for each target: its mean is the share.")},
    ),
    properties=(
        Property(
            "the answer is True or False for each target",
            lambda found, *case: np.isin(found, [0, 1]).all(),
            mistake=Mistake("errors or counts are returned", "Compare the lengths of both halves of e with 1e-3."),
        ),
        Property(
            "a target is reached if damped steps, each clipped to the limits, bring both parts of its error below 1e-3",
            lambda found, *case: (found == right(*case)).all(),
            says=lambda found, *case: (
                f"In yours {int(found.sum())} of {len(found)} are reached; {int(right(*case).sum())} are."
            ),
        ),
    ),
    mistakes=(
        Mistake("the answer is negated", "True means: reached.", lambda *case: ~right(*case)),
        Mistake(
            "every target counts as reached",
            "Test the error at the end.",
            lambda targets, *r: np.ones(len(targets), bool),
        ),
        Mistake(
            "no target counts as reached",
            "Print the error after each step.",
            lambda targets, *r: np.zeros(len(targets), bool),
        ),
        Mistake("the limits are ignored", "Clip after each step: an arm cannot go beyond its limits.", _other(clip="")),
        Mistake(
            "the limits are applied at the end only",
            "Clip after each step: then the next one starts from a configuration that the arm can take.",
            _other(clip="end"),
            _not_inside,
        ),
        Mistake("only the position is tested", "Both halves of the error have to be small.", _half(0)),
        Mistake("only the orientation is tested", "Both halves of the error have to be small.", _half(1)),
        Mistake(
            "another damping is used",
            "eps is given, and stays the same in all steps.",
            *(lambda t, q, eps, s, f=f: right(t, q, f(eps), s) for f in (np.square, np.sqrt, lambda eps: 1e-9)),
        ),
    ),
    hints=(
        "The functions of the library take batches: panda.fk(q) for q of shape (n, 7) has shape (n, 4, 4). Begin with "
        "q = np.tile(q0, (len(targets), 1)), and take `steps` steps with all targets at once.",
        "One damped step for all: x = np.linalg.solve(A, e[..., None]) with A = J J^T + eps I of shape (n, 6, 6), then "
        "J^T x. Swap the last two axes of J with np.swapaxes(J, -1, -2).",
        "After the last step compute the errors once more: both norms, of e[:, :3] and e[:, 3:], are to be below 1e-3.",
    ),
    library=right,
    errors=(("ValueError", "core dimension", _ONE_MATRIX),),
    forbidden=("course_lib.ik.solve",),
)
