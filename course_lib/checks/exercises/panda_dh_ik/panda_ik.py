"""panda_ik: joint angles inside the Panda's limits for which its flange has a given pose in the world."""

import numpy as np

from course_lib.checks.answer_types import NOT_A_NUMBER, numbers
from course_lib.checks.exercise import Exercise, Mistake, Property, Unreadable
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.panda_dh_ik.shared import HIGH, LOW, PANDA, READY, T_W0, flange, frames, panda_jacobian
from course_lib.ik import solve
from course_lib.rigid import inverse, transform
from course_lib.rotations import exp_so3, length, log_so3

REACHED = 1.001e-6  # metres and radians; a little more than asked for, because the student's own sums round otherwise
NEAR = 0.02  # what counts as nearly there

_LOW_DOWN = np.array([0.1, 0.6, -0.1, -2.0, 0.1, 2.6, 0.8])  # its flange is within reach of the base, and of the world
_BEYOND = np.array([0.3, 0.4, -0.5, -1.9, 0.4, 3.4, 0.2])  # with joint 6 beyond pi

# Configurations whose flange poses are not reached from the ready configuration without a restart: damped steps of many
# kinds (damping constant, or by the error, large and small), clipped to the limits after each step, end beside these
# poses; steps without limits end outside the limits. From a random configuration about every third start succeeds.
HARD = np.array(
    [
        [-2.16, -0.75, -2.27, -2.42, -2.15, 0.72, -1.98],
        [-1.34, 1.45, -0.59, -2.27, -1.75, 0.91, -0.73],
        [1.17, -0.12, 0.61, -2.39, -1.6, 1.81, -0.98],
        [1.16, 0.92, -0.39, -2.7, -2.07, 1.86, -0.45],
        [-0.77, -0.09, 0.57, -2.62, -2.43, 2.8, 2.4],
        [1.8, -0.2, 0.58, -2.04, -0.03, 2.31, -1.74],
        [-1.53, 0.41, -2.09, -2.63, 0.7, 1.96, -2.14],
        [2.46, 0.33, 0.54, -2.67, 1.02, 0.84, -1.96],
    ]
)


def _configuration(rng, share):
    """Return joint angles in the inner share of the limits, away from singularities."""
    while True:
        q = (LOW + HIGH) / 2 + share * (HIGH - LOW) / 2 * rng.uniform(-1, 1, 7)
        if np.linalg.svd(panda_jacobian(q), compute_uv=False)[-1] > 0.1:
            return np.round(q, 2)


def _about(q, rng, size):
    """Return joint angles that each differ from q by `size`, inside the limits."""
    return np.clip(q + size * rng.choice([-1, 1], 7), LOW, HIGH)


def _cases(rng):
    at_limit = _configuration(rng, 0.5)
    at_limit[0] = HIGH[0] - 0.01
    hard = HARD[rng.permutation(len(HARD))[:2]]
    here = flange(READY)
    hardly = here @ transform(exp_so3([0, 1.3e-6, 0]), [9e-7, 0, 9e-7])  # who stops too early answers q0
    moved = transform(here[:3, :3], here[:3, 3] - [0.03, 0.02, 0.04])
    rotated = transform(exp_so3([0.1, 0.2, -0.3]) @ here[:3, :3], here[:3, 3])
    far = transform(here[:3, :3], [3.0, 0.13, 0.6])
    return [
        (flange(_about(READY, rng, 0.1)), READY),
        (here, READY),
        (flange(_BEYOND), _BEYOND),
        (hardly, READY),
        (moved, READY),
        (rotated, READY),
        (flange(_about(_LOW_DOWN, rng, 0.02)), _LOW_DOWN),
        (flange(at_limit), np.clip(at_limit - 0.2, LOW, HIGH)),
        *((flange(q), READY) for q in hard),
        (far, READY),
    ]


def _solved(T, q0):
    """Return the library's answer."""
    found = solve(PANDA, inverse(T_W0) @ T, np.random.default_rng(0), q0=q0, starts=100)
    return found.q if found.success else np.full(7, np.nan)


_A_POSE = Mistake("a pose is returned, not joint angles", "Inverse kinematics goes from a pose to joint angles.")
_seven = numbers(lambda T, q0: (7,), {(4, 4): _A_POSE})


def _read(value, T, q0):
    """Seven numbers, or seven NaN."""
    try:
        array = np.asarray(value)
        missing = array.dtype.kind == "f" and np.isnan(array)
    except ValueError:
        return _seven(value, T, q0)
    if np.all(missing) and np.size(missing) == 7:
        return np.full(7, np.nan) + _seven(np.zeros(array.shape), T, q0)
    try:
        return _seven(value, T, q0)
    except Unreadable as wrong:
        if wrong.mistake is NOT_A_NUMBER:
            reason = "the answer is seven numbers, or seven NaN. Yours holds nan or inf beside numbers."
            raise Unreadable(reason, NOT_A_NUMBER) from None
        raise


def _far(T, q0):
    return T[0, 3] > 2


def _at_once(T, q0):
    return np.abs(T - flange(q0)).max() < 1e-9


def _close_by(T, q0):
    """Return whether the target is some hundredths of a radian a joint away."""
    return np.linalg.norm(_missing(flange(q0), T)) < 0.15


def _reachable(T, q0):
    return not _far(T, q0)


def _missing(A, B):
    """Return the metres and radians between two poses."""
    return np.array([length(B[:3, 3] - A[:3, 3]), length(log_so3(B[:3, :3] @ A[:3, :3].T))])


def _given(q):
    return np.isfinite(q).all()


def _distances(q, T):
    return _missing(flange(q), T)


def _or_none(holds):
    """Return the property of angles that is not asked of seven NaN."""
    return lambda q, *case: not _given(q) or holds(q, *case)


def _inside(q, T, q0):
    return bool(((q >= LOW - 1e-9) & (q <= HIGH + 1e-9)).all())


def _outside(q, T, q0):
    j = int(np.argmax(np.maximum(LOW - q, q - HIGH)))
    return f"Joint {j + 1} may be between {LOW[j]:.4f} and {HIGH[j]:.4f}; yours is {q[j]:.6g}."


def _position_off(q, T, q0):
    p = flange(q)[:3, 3]
    metres = length(p - T[:3, 3])
    return f"It should be at {format_tuple(T[:3, 3])}; yours is at {format_tuple(p)}, {metres:.3g} m away."


def _moved(q, T, q0):
    j = int(np.argmax(np.abs(q - q0)))
    return f"Your answer reaches T_target as well, but joint {j + 1} goes from {q0[j]:.4g} to {q[j]:.4g}."


def _at(pose_of, target_of=lambda T: T, needed=1e-3):
    """A `seen`: whether some pose that the answer gives is another target than the one asked for."""
    return lambda q, T, q0: _given(q) and bool((_missing(pose_of(q), target_of(T)) < needed).all())


def _in_whole_turns(q):
    """Return the angles plus multiples of 2 pi that bring them near the middle of the limits."""
    middle = (LOW + HIGH) / 2
    return q - 2 * np.pi * np.round((q - middle) / (2 * np.pi))


def _wrapped(q, T, q0):
    inside = _in_whole_turns(q)
    return _given(q) and _inside(inside, T, q0) and not _inside(q, T, q0)


def _nearly(q, T, q0):
    return _given(q) and bool(REACHED < _distances(q, T).max() < NEAR)


def _one_part(q, T, q0, part):
    """Return whether the position (0) or the orientation (1) is reached and the other one is not."""
    distances = _distances(q, T)
    return _reachable(T, q0) and distances[part] <= REACHED < distances[1 - part]


_EARLY = (
    "the iteration stops too early, or the angles are rounded",
    "The task asks for 1e-6 m and 1e-6 rad. Near the target each damped step gains digits, if the damping gets small.",
)
_NOT_CONVERGING = Mistake(
    "the steps do not converge to a target close by",
    "Print the length of the error after each step. Do e and the rows of J have the same order and axes? Are both "
    "computed again for each q? Is the damping small enough near the target?",
)
_STUCK = Mistake(
    "no start leads to this target: there are no restarts, or too few of them converge",
    "A descent gets stuck in a local minimum or at a limit, and another one from a random configuration does not. If "
    "you restart already, count how many of your starts converge.",
)
_LAST = Mistake(
    "the steps got stuck, and the last angles are returned all the same",
    "Test the error before you return: angles that do not reach T_target are no answer.",
)
_ORIENTATION_LEFT = Mistake(
    "only the position is brought to T_target, not the orientation", "The error has six numbers: look at both halves."
)

EXERCISE = Exercise(
    name="panda_ik",
    points=4,
    arguments=("T_target", "q0"),
    cases=_cases,
    returns=_read,
    properties=(
        Property(
            "every joint is inside its limits",
            _or_none(_inside),
            _outside,
            where=_reachable,
            mistake=Mistake("the limits are ignored", "Bring q back inside the limits after each step."),
        ),
        Property(
            "the flange is within 1e-6 m of the position that T_target gives, in the world",
            _or_none(lambda q, T, q0: _distances(q, T)[0] <= REACHED),
            _position_off,
            where=_reachable,
            mistake=_LAST,
        ),
        Property(
            "the flange has the orientation of T_target, to 1e-6 rad",
            _or_none(lambda q, T, q0: _distances(q, T)[1] <= REACHED),
            lambda q, T, q0: f"With your angles its orientation is {_distances(q, T)[1]:.3g} rad away from that.",
            where=_reachable,
            mistake=_ORIENTATION_LEFT,
        ),
        Property(
            "if q0 reaches T_target already, joint angles are returned: q0 is right",
            lambda q, *case: _given(q),
            where=_at_once,
            mistake=Mistake(
                "NaN is returned although q0 is an answer",
                "Look at the error before the first step. T_target is a pose in the world, as those of panda_fk are.",
            ),
        ),
        Property(
            "the iteration begins at q0: if q0 reaches T_target already, the answer is q0",
            lambda q, T, q0: np.abs(q - q0).max() < 0.1,
            _moved,
            where=_at_once,
            mistake=Mistake("the iteration does not begin at q0", "Random configurations are for the restarts."),
        ),
        Property(
            "a target close by is reached: seven numbers are returned, not NaN",
            lambda q, *case: _given(q),
            where=_close_by,
            mistake=_NOT_CONVERGING,
        ),
        Property(
            "a target that some joint angles inside the limits reach is found: seven numbers are returned, not NaN",
            lambda q, *case: _given(q),
            where=_reachable,
            mistake=_STUCK,
        ),
        Property(
            "for a target out of reach (3 m away) seven NaN are returned",
            lambda q, *case: not _given(q),
            where=_far,
            mistake=Mistake("angles are returned for a target out of reach", "When no start converges, return NaN."),
        ),
    ),
    mistakes=(
        Mistake(*_EARLY, seen=lambda q, *case: _nearly(q, *case) and _inside(q, *case)),
        Mistake(
            "the answer is in degrees",
            "Angles are in radians throughout.",
            seen=lambda q, T, q0: _given(q) and (_distances(np.deg2rad(q), T) < 1e-3).all(),
        ),
        Mistake(
            "multiples of 2 pi are added, and lead out of the limits",
            "Wrapping knows nothing of the limits: joint 6 goes from -0.02 to 3.75.",
            seen=_wrapped,
        ),
        Mistake(
            "the base is forgotten: the flange is at T_target as seen from the base",
            "T_target is given in the world, and the base is at (-0.2, 0.13, 0.6) there.",
            seen=_at(PANDA.fk),
        ),
        Mistake(
            "the base's pose is inverted, or on the wrong side",
            "The flange in the world is T_w0 times the flange in the base.",
            seen=lambda *case: any(
                _at(PANDA.fk, lambda T, A=A: A @ T)(*case) for A in (T_W0, inverse(T_W0) @ inverse(T_W0))
            ),
        ),
        Mistake(
            "the flange is forgotten: the frame of joint 7 is at T_target",
            "The flange's pose is the last of the eight.",
            seen=lambda *case: _at(lambda q: frames(q)[6])(*case) or _at(lambda q: PANDA.frames(q)[6])(*case),
        ),
        Mistake(
            "the target's orientation is transposed",
            "Print the error at your answer: is it that to T_target?",
            seen=_at(flange, lambda T: transform(T[:3, :3].T, T[:3, 3])),
        ),
        Mistake(
            "the inverse of T_target is reached", "Neither of the two poses is inverted.", seen=_at(flange, inverse)
        ),
        Mistake(
            _ORIENTATION_LEFT.name,
            _ORIENTATION_LEFT.hint,
            seen=lambda q, T, q0: _given(q) and _one_part(q, T, q0, 0),
        ),
        Mistake(
            "only the orientation is brought to T_target, not the position",
            _ORIENTATION_LEFT.hint,
            seen=lambda q, T, q0: _given(q) and _one_part(q, T, q0, 1),
        ),
        Mistake(
            "q0 itself is returned",
            "q0 is the start of the iteration, not its result.",
            seen=lambda q, T, q0: _reachable(T, q0) and _given(q) and np.abs(q - q0).max() < 1e-9,
        ),
    ),
    hints=(
        "One start is a loop: the frames at q, the error to T_target, return q if it is small enough, else a damped "
        "step and np.clip to the limits.",
        "A damping that follows the error converges fast and reaches 1e-6: for example eps = 0.05 * e @ e + 1e-12.",
        "Around it a second loop over the starts: when 20 steps are not enough, q = random.uniform(low, high), with "
        "random = np.random.default_rng(0). After 15 starts return np.full(7, np.nan).",
    ),
    library=_solved,
    forbidden=("course_lib.ik.solve", "course_lib.ik.damped_path"),
)
