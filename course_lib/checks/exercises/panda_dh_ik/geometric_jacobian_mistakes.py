"""The right geometric Jacobian, and the known mistakes in it."""

import numpy as np

from course_lib.checks.exercise import Mistake
from course_lib.checks.exercises.panda_dh_ik.shared import truncated
from course_lib.checks.vocabulary import Z, few_digits, halves_swapped, transposed

_FORMULA = "Column i is z_i x (p - o_i), and below it z_i."
_OWN_FRAME = "In the modified convention joint i rotates about the z axis of frame i itself: frames[0] is joint 1's."
_WORLD = "The task asks for the world's axes, in which z, p and o are given: no R is needed."
_LAST = "The flange is the last frame."
_AXIS = "A joint rotates about the z axis of its own frame, which is a column of R."


def parts(frames):
    """Return the axes z and origins o of the joints, (n, 3) each, and the flange's origin p."""
    return frames[:-1, :3, 2], frames[:-1, :3, 3], frames[-1, :3, 3]


def _stacked(v, omega):
    return np.concatenate([np.transpose(v), np.transpose(omega)])


def _of(z, o, p):
    return _stacked(np.cross(z, p - o), z)


def jacobian(frames):
    """Return the geometric Jacobian (6, n) of the last frame, (v, omega) along the world's axes."""
    return _of(*parts(frames))


def _with_v(v_of):
    return lambda frames: _stacked(v_of(*parts(frames)), parts(frames)[0])


def _with_axes(axes_of):
    """Return answers with other axes: in both halves, below only, above only."""

    def both(frames):
        return _of(axes_of(frames), *parts(frames)[1:])

    def below(frames):
        return np.concatenate([jacobian(frames)[:3], both(frames)[3:]])

    def above(frames):
        return np.concatenate([both(frames)[:3], jacobian(frames)[3:]])

    return both, below, above


def _with_frames(joints_of, flange_of=lambda frames: frames[-1]):
    return lambda frames: jacobian(np.concatenate([joints_of(frames), [flange_of(frames)]]))


def _before(frames):
    return np.concatenate([[np.eye(4)], frames[:-2]])


def _mixed(axes_from, origins_from):
    def answer(frames):
        return _of(axes_from(frames)[:, :3, 2], origins_from(frames)[:, :3, 3], frames[-1, :3, 3])

    return answer


def _joints(frames):
    return frames[:-1]


def _next(frames):
    return frames[1:]


def _rotated(R_of):
    return lambda frames: np.kron(np.eye(2), R_of(frames)) @ jacobian(frames)


def _in_its_own_frame(frames):
    back = frames[:-1, :3, :3].swapaxes(1, 2)
    return np.column_stack([np.kron(np.eye(2), R) @ column for R, column in zip(back, jacobian(frames).T, strict=True)])


def _scaled(v):
    size = np.linalg.norm(v, axis=-1, keepdims=True)
    return v / np.where(size > 1e-9, size, 1)


def _empty(column):
    def answer(frames):
        J = jacobian(frames)
        J[:, column] = 0
        return J

    return answer


def _backwards(frames):
    return _with_v(lambda z, o, p: np.cross(p - o, z))(frames)


def _about_the_world(frames):
    return _with_v(lambda z, o, p: np.cross(o, z))(frames)


MISTAKES = (
    few_digits(jacobian),
    halves_swapped(jacobian, "omega stands above v", "Here the order is (v, omega): the velocity is the upper half."),
    Mistake(
        "the cross product has the wrong sign",
        "z is the first factor, and p - o points from the axis to the flange.",
        _backwards,
        lambda frames: np.roll(_backwards(frames), 3, axis=0),
    ),
    Mistake(
        "p is missing: v is that of the point at the world's origin, as in the space Jacobian",
        "Here v is the velocity of the flange's origin.",
        _about_the_world,
        lambda frames: np.roll(_about_the_world(frames), 3, axis=0),
        _with_v(lambda z, o, p: np.cross(z, o)),
    ),
    Mistake(
        "o is missing",
        "The lever arm is the vector from a point on the joint's axis to the flange.",
        _with_v(lambda z, o, p: np.cross(z, p)),
        _with_v(lambda z, o, p: np.cross(p, z)),
    ),
    Mistake(
        "p + o stands for p - o",
        "The vector from the axis to the flange is p - o.",
        _with_v(lambda z, o, p: np.cross(z, p + o)),
    ),
    Mistake("rows of R are taken for its columns", _AXIS, *_with_axes(lambda frames: frames[:-1, 2, :3])),
    Mistake(
        "the x or y axis is taken, not z",
        _AXIS,
        *(answer for k in (0, 1) for answer in _with_axes(lambda frames, k=k: frames[:-1, :3, k])),
    ),
    Mistake(
        "every axis is taken for the world's z", _AXIS, *_with_axes(lambda frames: np.tile(Z, (len(frames) - 1, 1)))
    ),
    Mistake(
        "frame i - 1 is taken for joint i, as in the standard convention",
        _OWN_FRAME,
        _with_frames(_before),
        _with_frames(lambda frames: np.concatenate([frames[:1], frames[:-2]])),
        _mixed(_before, _joints),
        _mixed(_joints, _before),
    ),
    Mistake(
        "frame i + 1 is taken for joint i",
        _OWN_FRAME,
        _with_frames(_next),
        _mixed(_next, _joints),
        _mixed(_joints, _next),
    ),
    Mistake("the origin of frame n is taken for the flange's", _LAST, _with_frames(_joints, lambda frames: frames[-2])),
    Mistake(
        "the origin of the first frame is taken for the flange's",
        _LAST,
        _with_frames(_joints, lambda frames: frames[0]),
    ),
    Mistake(
        "v and omega are along the flange's own axes",
        _WORLD,
        _rotated(lambda frames: frames[-1, :3, :3].T),
        _rotated(lambda frames: frames[-1, :3, :3]),
    ),
    Mistake(
        "v and omega are along the axes of the joint's own frame",
        _WORLD,
        _in_its_own_frame,
        lambda frames: np.concatenate([_in_its_own_frame(frames)[:3], jacobian(frames)[3:]]),
    ),
    Mistake(
        "only the next frame is moved",
        "Joint i moves everything beyond it, the flange too.",
        _with_v(lambda z, o, p: np.cross(z, np.diff(np.vstack([o, p]), axis=0))),
    ),
    Mistake("omega is left out", _FORMULA, lambda frames: _stacked(jacobian(frames)[:3].T, 0 * parts(frames)[0])),
    Mistake("v is left out", _FORMULA, _with_v(lambda z, o, p: 0 * z)),
    Mistake(
        "v is scaled to length one",
        "v is longer if the flange is farther from the axis: do not normalize it.",
        _with_v(lambda z, o, p: _scaled(np.cross(z, p - o))),
        lambda frames: _scaled(jacobian(frames).T).T,
    ),
    Mistake(
        "p - o, or p, is taken for v",
        "A velocity is perpendicular to the axis: there is a cross product.",
        _with_v(lambda z, o, p: p - o),
        _with_v(lambda z, o, p: 0 * o + p),
        _with_v(lambda z, o, p: o),
    ),
    Mistake(
        "z * (p - o), entry by entry, stands for the cross product",
        "See np.cross.",
        _with_v(lambda z, o, p: z * (p - o)),
    ),
    Mistake("the cross product is taken twice", _FORMULA, _with_v(lambda z, o, p: np.cross(z, np.cross(z, p - o)))),
    Mistake(
        "omega has the wrong sign",
        _FORMULA,
        lambda frames: _stacked(jacobian(frames)[:3].T, -parts(frames)[0]),
        lambda frames: -jacobian(frames),
    ),
    Mistake("one column is left empty", "The loop goes over all n joints.", _empty(-1), _empty(0)),
    Mistake(
        "the columns are in another order",
        "The first column belongs to joint 1.",
        lambda frames: jacobian(frames)[:, ::-1],
        lambda frames: np.roll(jacobian(frames), 1, axis=1),
    ),
    Mistake(
        "the numbers are in the right order, but broken into rows wrongly",
        "Transpose with .T, not by reshape.",
        lambda frames: jacobian(frames).T.reshape(6, -1),
    ),
    transposed(jacobian, "rows and columns are swapped", "One column for each joint: the shape is (6, n)."),
    truncated(jacobian),
    Mistake(
        "the columns are added up along the arm",
        "Each column belongs to one joint.",
        lambda frames: np.cumsum(jacobian(frames), axis=1),
    ),
)
