"""The right geometric Jacobian, and the known ways to go wrong in it."""

import numpy as np

from course_lib.checks.exercise import Mistake
from course_lib.checks.poe_kuka_iiwa.chains import Z, few_digits

_FORMULA = "Column i is z_i x (p - o_i), and below it z_i."
_OWN_FRAME = (
    "In the modified convention joint i turns about the z axis of frame i itself: frames[0] belongs to joint 1."
)


def parts(frames):
    """Of each joint the axis z and the place o, (n, 3) each; and the flange's place p."""
    return frames[:-1, :3, 2], frames[:-1, :3, 3], frames[-1, :3, 3]


def stacked(v, omega):
    return np.concatenate([np.transpose(v), np.transpose(omega)])


def _of(z, o, p):
    """The Jacobian for these axes, places of the axes, and place of the flange."""
    return stacked(np.cross(z, p - o), z)


def jacobian(frames):
    """The right answer."""
    return _of(*parts(frames))


def _with_v(v_of):
    """A prediction: another v; v_of(z, o, p)."""
    return lambda frames: stacked(v_of(*parts(frames)), parts(frames)[0])


def _with_axes(axes_of):
    """Predictions: other axes, in both halves or in one."""

    def both(frames):
        return _of(axes_of(frames), *parts(frames)[1:])

    def below(frames):
        return np.concatenate([jacobian(frames)[:3], both(frames)[3:]])

    def above(frames):
        return np.concatenate([both(frames)[:3], jacobian(frames)[3:]])

    return both, below, above


def _with_frames(joints_of, flange_of=lambda frames: frames[-1]):
    """A prediction: other frames taken for the joints', or another for the flange's."""
    return lambda frames: jacobian(np.concatenate([joints_of(frames), [flange_of(frames)]]))


def _off_by_one(frames, first):
    return np.concatenate([[first], frames[:-2]])


def _mixed(frames, axes_from, places_from):
    return _of(axes_from[:, :3, 2], places_from[:, :3, 3], frames[-1, :3, 3])


def _before(frames):
    return _off_by_one(frames, np.eye(4))


def _seen_from(turn_of):
    """A prediction: both halves turned; turn_of(frames) is 3 x 3."""
    return lambda frames: np.kron(np.eye(2), turn_of(frames)) @ jacobian(frames)


def _in_its_own_frame(frames):
    """Each column along the axes of its joint's frame."""
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


MISTAKES = (
    few_digits(jacobian),
    Mistake(
        "omega stands above v",
        "Here the order is (v, omega): the velocity above, the angular velocity below.",
        lambda frames: np.roll(jacobian(frames), 3, axis=0),
    ),
    Mistake(
        "the cross product has its sign turned",
        "z x (p - o): z stands first, and p - o points from the axis to the flange.",
        _with_v(lambda z, o, p: np.cross(p - o, z)),
        lambda frames: np.roll(_with_v(lambda z, o, p: np.cross(p - o, z))(frames), 3, axis=0),
    ),
    Mistake(
        "p is missing: v is that of the point at the world's origin, as in the space Jacobian",
        "Here v is the velocity of the flange's origin: z x (p - o), not z x (-o).",
        _with_v(lambda z, o, p: np.cross(o, z)),
        lambda frames: np.roll(_with_v(lambda z, o, p: np.cross(o, z))(frames), 3, axis=0),
        _with_v(lambda z, o, p: np.cross(z, o)),
    ),
    Mistake(
        "o is missing",
        "The flange is p - o away from the joint's axis: subtract the origin of the joint's frame.",
        _with_v(lambda z, o, p: np.cross(z, p)),
        _with_v(lambda z, o, p: np.cross(p, z)),
    ),
    Mistake(
        "p + o stands for p - o",
        "The arrow from the axis to the flange is p - o.",
        _with_v(lambda z, o, p: np.cross(z, p + o)),
    ),
    Mistake(
        "rows of R are taken for its columns",
        "The z axis of a frame, as the world sees it, is the third column of R: frame[:3, 2], not frame[2, :3].",
        *_with_axes(lambda frames: frames[:-1, 2, :3]),
    ),
    Mistake(
        "the x or y axis is taken, not z",
        "A joint turns about the z axis of its frame: column 2, frame[:3, 2].",
        *(prediction for k in (0, 1) for prediction in _with_axes(lambda frames, k=k: frames[:-1, :3, k])),
    ),
    Mistake(
        "every axis is taken for the world's z",
        "Joint 1 carries the others: each turns about the z axis of its own frame as it stands now, frame[:3, 2].",
        *_with_axes(lambda frames: np.tile(Z, (len(frames) - 1, 1))),
    ),
    Mistake(
        "frame i - 1 is taken for joint i, as in the standard convention",
        _OWN_FRAME,
        _with_frames(_before),
        _with_frames(lambda frames: _off_by_one(frames, frames[0])),
        lambda frames: _mixed(frames, _before(frames), frames[:-1]),
        lambda frames: _mixed(frames, frames[:-1], _before(frames)),
    ),
    Mistake(
        "frame i + 1 is taken for joint i",
        _OWN_FRAME,
        _with_frames(lambda frames: frames[1:]),
        lambda frames: _mixed(frames, frames[1:], frames[:-1]),
        lambda frames: _mixed(frames, frames[:-1], frames[1:]),
    ),
    Mistake(
        "the place of frame n is taken for the flange's",
        "The flange stands last: p = frames[-1, :3, 3].",
        _with_frames(lambda frames: frames[:-1], lambda frames: frames[-2]),
    ),
    Mistake(
        "the place of the first frame is taken for the flange's",
        "The flange stands last: p = frames[-1, :3, 3].",
        _with_frames(lambda frames: frames[:-1], lambda frames: frames[0]),
    ),
    Mistake(
        "v and omega are along the flange's own axes",
        "Asked for is the Jacobian along the world's axes, as z, p and o are given: no R is needed.",
        _seen_from(lambda frames: frames[-1, :3, :3].T),
        _seen_from(lambda frames: frames[-1, :3, :3]),
        lambda frames: np.roll(_seen_from(lambda frames: frames[-1, :3, :3].T)(frames), 3, axis=0),
    ),
    Mistake(
        "v and omega are along the axes of the joint's own frame",
        "Asked for is the Jacobian along the world's axes, as z, p and o are given: no R is needed.",
        _in_its_own_frame,
        lambda frames: np.concatenate([_in_its_own_frame(frames)[:3], jacobian(frames)[3:]]),
        lambda frames: np.concatenate([jacobian(frames)[:3], _in_its_own_frame(frames)[3:]]),
    ),
    Mistake(
        "only the next frame is moved",
        "Joint i moves all that lies beyond it, the flange too: p - o, p being the flange's.",
        _with_v(lambda z, o, p: np.cross(z, np.diff(np.vstack([o, p]), axis=0))),
    ),
    Mistake(
        "omega is left out",
        "A turning joint turns the flange too: z below.",
        lambda frames: stacked(jacobian(frames)[:3].T, 0 * parts(frames)[0]),
    ),
    Mistake(
        "v is left out", "The flange moves as well as it turns: z x (p - o) above.", _with_v(lambda z, o, p: 0 * z)
    ),
    Mistake(
        "v is scaled to length one",
        "v is as long as the flange is far from the axis: do not normalise it.",
        _with_v(lambda z, o, p: _scaled(np.cross(z, p - o))),
        lambda frames: _scaled(jacobian(frames).T).T,
        lambda frames: _of(parts(frames)[0], _scaled(parts(frames)[1] - parts(frames)[2]), 0),
    ),
    Mistake(
        "p - o, or p, is taken for v",
        "A velocity is at right angles to the axis: z x (p - o).",
        _with_v(lambda z, o, p: p - o),
        _with_v(lambda z, o, p: 0 * o + p),
        _with_v(lambda z, o, p: o),
    ),
    Mistake(
        "z * (p - o), entry by entry, stands for the cross product",
        "In numpy the cross product is np.cross.",
        _with_v(lambda z, o, p: z * (p - o)),
    ),
    Mistake("the cross product is taken twice", _FORMULA, _with_v(lambda z, o, p: np.cross(z, np.cross(z, p - o)))),
    Mistake(
        "omega has its sign turned",
        _FORMULA,
        lambda frames: stacked(jacobian(frames)[:3].T, -parts(frames)[0]),
        lambda frames: -jacobian(frames),
    ),
    Mistake(
        "one column is left empty", "The loop goes over all n joints: range(n), or frames[:-1].", _empty(-1), _empty(0)
    ),
    Mistake(
        "the columns stand in another order",
        "Joint 1 belongs to the first column.",
        lambda frames: jacobian(frames)[:, ::-1],
        lambda frames: np.roll(jacobian(frames), 1, axis=1),
    ),
    Mistake(
        "the numbers are in the right order, but broken into rows wrongly",
        "Transpose with .T, not by reshape; np.column_stack takes a list of columns.",
        lambda frames: jacobian(frames).T.reshape(6, -1),
    ),
    Mistake(
        "rows and columns are swapped",
        "One column for each joint. Transpose with .T.",
        lambda frames: jacobian(frames).T,
    ),
    Mistake(
        "the columns are added up along the arm",
        "Each column is of one joint: J @ q_dot adds them up later.",
        lambda frames: np.cumsum(jacobian(frames), axis=1),
    ),
    Mistake(
        "digits after the point are cut off",
        "np.zeros((6, n)) has room for digits, with dtype=int it has not.",
        lambda frames: np.trunc(jacobian(frames)),
    ),
)
