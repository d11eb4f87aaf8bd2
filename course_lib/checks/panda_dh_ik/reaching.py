"""panda_ik: joint angles inside the Panda's limits for which its flange has a given pose in the world."""

import numpy as np

from course_lib.checks.answer_types import NOT_A_NUMBER, numbers
from course_lib.checks.exercise import Exercise, Mistake, Property, Unreadable
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.panda_dh_ik.tables import STAND, frames
from course_lib.checks.panda_dh_ik.targets import HIGH, LOW, PANDA, cases, flange
from course_lib.rigid import inverse, transform
from course_lib.rotations import length, log_so3

REACHED = 1.001e-6  # metres and radians; a little more than asked for, for the student's own sums round otherwise
NEAR = 0.02  # what counts as nearly there

_A_POSE = Mistake("a pose is returned, not joint angles", "panda_ik goes the other way: from a pose to seven angles.")
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
    """Whether the target is some hundredths of a radian a joint away."""
    return np.linalg.norm(_missing(flange(q0), T)) < 0.15


def _reachable(T, q0):
    return not _far(T, q0)


def _missing(A, B):
    """Metres and radians between two poses."""
    return np.array([length(B[:3, 3] - A[:3, 3]), length(log_so3(B[:3, :3] @ A[:3, :3].T))])


def _given(q):
    return np.isfinite(q).all()


def _left(q, T):
    return _missing(flange(q), T)


def _or_none(holds):
    """The property of angles that is not asked of seven NaN."""
    return lambda q, *case: not _given(q) or holds(q, *case)


def _inside(q, T, q0):
    return bool(((q >= LOW - 1e-9) & (q <= HIGH + 1e-9)).all())


def _outside(q, T, q0):
    j = int(np.argmax(np.maximum(LOW - q, q - HIGH)))
    return f"Joint {j + 1} may be between {LOW[j]:.4f} and {HIGH[j]:.4f}; yours is {q[j]:.6g}."


def _place_off(q, T, q0):
    p = flange(q)[:3, 3]
    metres = length(p - T[:3, 3])
    return f"It should be at {format_tuple(T[:3, 3])}; yours is at {format_tuple(p)}, {metres:.3g} m away."


def _turn_off(q, T, q0):
    return f"With your angles it is turned by {_left(q, T)[1]:.3g} rad away from it."


def _moved(q, T, q0):
    j = int(np.argmax(np.abs(q - q0)))
    return f"Your answer reaches T as well, but joint {j + 1} goes from {q0[j]:.4g} to {q[j]:.4g}."


def _at(pose_of, target_of=lambda T: T, needed=1e-3):
    """A `seen`: whether some pose that the answer gives is another target than the one asked for."""
    return lambda q, T, q0: _given(q) and bool((_missing(pose_of(q), target_of(T)) < needed).all())


def _turned_back(T):
    return transform(T[:3, :3].T, T[:3, 3])


def _in_whole_turns(q):
    """The angles moved by whole turns to where the limits are."""
    middle = (LOW + HIGH) / 2
    return q - 2 * np.pi * np.round((q - middle) / (2 * np.pi))


def _wrapped(q, T, q0):
    inside = _in_whole_turns(q)
    return _given(q) and _inside(inside, T, q0) and not _inside(q, T, q0)


def _nearly(q, T, q0):
    return _given(q) and bool(REACHED < _left(q, T).max() < NEAR)


def _one_part(q, T, q0, part):
    """Whether the place (0) or the turn (1) is reached and the other one is not."""
    left = _left(q, T)
    return _reachable(T, q0) and left[part] <= REACHED < left[1 - part]


_EARLY = Mistake(
    "the steps end too early, nearly there, or the angles are rounded",
    "1e-6 m and 1e-6 rad are asked for, not 0.02. Go on until the error's length is below 1e-7: near the target each "
    "step gets nearer by many digits.",
)
_NOT_CONVERGING = Mistake(
    "the steps do not lead to the target",
    "e and the rows of J stand in the same order (v, omega), both along the world's axes; e is target minus place; J "
    "and e are made anew for each q; and there are enough steps, say 40.",
)
_STUCK = Mistake(
    "the steps got stuck, and no other start is tried, or too few are",
    "After 40 steps without success begin again at random.uniform(low, high), 30 times at most. If you do that, "
    "eps is too large at the end: let it follow the error.",
)
_LAST = Mistake(
    "the steps got stuck, and the last angles are returned all the same",
    "Return q only where the error is below 1e-7. After 40 steps without success begin again at another posture.",
)

PANDA_IK = Exercise(
    name="panda_ik",
    points=4,
    arguments=("T", "q0"),
    cases=cases,
    returns=_read,
    properties=(
        Property(
            "every joint is inside its limits",
            _or_none(_inside),
            _outside,
            where=_reachable,
            mistake=Mistake(
                "the limits are not looked at", "After each step: q = np.clip(q, low, high), with low, high = limits.T."
            ),
        ),
        Property(
            "the flange is within 1e-6 m of the place that T gives, in the world",
            _or_none(lambda q, T, q0: _left(q, T)[0] <= REACHED),
            _place_off,
            where=_reachable,
            mistake=_LAST,
        ),
        Property(
            "the flange is turned as T is, to 1e-6 rad",
            _or_none(lambda q, T, q0: _left(q, T)[1] <= REACHED),
            _turn_off,
            where=_reachable,
            mistake=Mistake(
                "only the place is brought to T, not the turn",
                "e has six numbers: the way that is left and the turn that is left. pose_error gives both.",
            ),
        ),
        Property(
            "where q0 reaches T already, joint angles are returned: q0 is right",
            lambda q, *case: _given(q),
            where=_at_once,
            mistake=Mistake(
                "NaN is returned although an answer is at hand",
                "Look at the error before the first step, and return q where it is below 1e-7. T is the flange's pose "
                "in the world, as panda_fk gives it.",
            ),
        ),
        Property(
            "the steps begin at q0: where q0 reaches T already, the answer is q0",
            lambda q, T, q0: np.abs(q - q0).max() < 0.1,
            _moved,
            where=_at_once,
            mistake=Mistake(
                "q0 is not where the steps begin",
                "q = np.clip(q0, low, high) for the first start; random postures are for the starts after it.",
            ),
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
            mistake=Mistake(
                "angles are returned for a target that no angles reach",
                "After the last start: return np.full(7, np.nan).",
            ),
        ),
    ),
    mistakes=(
        Mistake(_EARLY.name, _EARLY.hint, seen=lambda q, *case: _nearly(q, *case) and _inside(q, *case)),
        Mistake(
            "the answer is in degrees",
            "Angles are radians everywhere: no np.rad2deg.",
            seen=lambda q, T, q0: _given(q) and (_left(np.deg2rad(q), T) < 1e-3).all(),
        ),
        Mistake(
            "the angles are moved by whole turns to where the limits are not",
            "Wrapping to (-pi, pi] or to [0, 2 pi) knows nothing of limits: joint 6 goes from -0.02 to 3.75. Clip "
            "after each step, and wrap nothing.",
            seen=_wrapped,
        ),
        Mistake(
            "the base is forgotten: the flange is at T as seen from the base",
            "T is given in the world, and the base stands at (-0.2, 0.13, 0.6). panda_fk answers in the world.",
            seen=_at(PANDA.fk),
        ),
        Mistake(
            "the base is counted the wrong way",
            "The flange in the world is T_w0 times the flange in the base. The target in the base: inverse(T_w0) @ T.",
            seen=lambda *case: any(
                _at(PANDA.fk, lambda T, A=A: A @ T)(*case) for A in (STAND, inverse(STAND) @ inverse(STAND))
            ),
        ),
        Mistake(
            "the flange is forgotten: the frame of joint 7 is at T",
            "The flange's pose is the last of the eight, panda_fk(q)[-1], 0.107 m beyond joint 7's frame.",
            seen=lambda *case: _at(lambda q: frames(q)[6])(*case) or _at(lambda q: PANDA.frames(q)[6])(*case),
        ),
        Mistake(
            "the target's turn is transposed",
            "What is left to turn is R_target R^T: pose_error(T of now, target).",
            seen=_at(flange, _turned_back),
        ),
        Mistake(
            "the inverse of T is reached",
            "pose_error(T of now, target): neither of the two is inverted.",
            seen=_at(flange, inverse),
        ),
        Mistake(
            "only the place is brought to T, not the turn",
            "e has six numbers: the way that is left and the turn that is left. pose_error gives both.",
            seen=lambda q, T, q0: _given(q) and _one_part(q, T, q0, 0),
        ),
        Mistake(
            "only the turn is brought to T, not the place",
            "e has six numbers: the way that is left and the turn that is left. pose_error gives both.",
            seen=lambda q, T, q0: _given(q) and _one_part(q, T, q0, 1),
        ),
        Mistake(
            "q0 itself is returned",
            "q0 is where the steps begin. Return the q they lead to.",
            seen=lambda q, T, q0: _reachable(T, q0) and _given(q) and np.abs(q - q0).max() < 1e-9,
        ),
    ),
    hints=(
        "A loop: frames = panda_fk(q), e = pose_error(frames[-1], T). If e is shorter than 1e-7, return q.",
        "Else q = ik_step_dls(q, geometric_jacobian(frames), e, eps), with eps = 0.05 * e @ e + 1e-12, and then "
        "q = np.clip(q, low, high), with low, high = limits.T.",
        "Around it a second loop: when 40 steps did not suffice, q = random.uniform(low, high), with "
        "random = np.random.default_rng(0). After 30 starts return np.full(7, np.nan).",
    ),
    forbidden=(
        "course_lib.ik.solve",
        "course_lib.ik.damped_path",
        "course_lib.ik._Search",
        "course_lib.ik._damped_step",
    ),
)
