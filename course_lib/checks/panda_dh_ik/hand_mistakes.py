"""The known ways to go wrong in panda_fk."""

import itertools

import numpy as np

from course_lib.checks.exercise import Mistake
from course_lib.checks.panda_dh_ik.steps import along_x, along_z
from course_lib.checks.panda_dh_ik.table_mistakes import TABLE_MISTAKES
from course_lib.checks.panda_dh_ik.tables import BASE, FLANGE, STAND, chain, edited, frames, in_reverse, steps
from course_lib.checks.poe_kuka_iiwa.chains import few_digits, products
from course_lib.rigid import inverse, transform
from course_lib.rotations import rot_z

_BASE_FIRST = "The base is the first factor: T = rigid.transform(np.eye(3), [-0.2, 0.13, 0.6]) before the loop."
_FLANGE = "The flange is one more step along the last z: T @ rigid.transform(np.eye(3), [0, 0, 0.107])."
_ORDER = "T = T @ dh_modified(...): each step is seen from the frame before, so it stands on the right."
_COPY = "T @= ... and T[:] = ... change the matrix that is in the list already: write T = T @ dh_modified(...)."
_RADIANS = "Angles are radians everywhere: no np.deg2rad, no np.rad2deg."
_NONE = np.eye(4)


def _flange_at(pose_of):
    """A prediction: the frames are right, the flange's pose is pose_of(that of frame 7)."""
    return lambda q: np.concatenate([frames(q)[:7], [pose_of(frames(q)[6])]])


def _without_base(q):
    return chain(stand=_NONE)(q)


def _with_base(*indices):
    """A prediction: the base is added to these poses only."""

    def answer(q):
        T = _without_base(q)
        T[list(indices)] = STAND @ T[list(indices)]
        return T

    return answer


def _all_the_same(q):
    """The list holds one matrix, as it is after the loop; with the flange as the last, or there too."""
    return np.concatenate([[frames(q)[6]] * 7, frames(q)[7:]])


def _with_the_base_each_time(q):
    return np.array(products([STAND @ step for step in steps(q)])[1:])


def _with_the_base_each_time_but_the_last(q):
    return np.array(products([*(STAND @ step for step in steps(q)[:7]), steps(q)[7]])[1:])


def _turned_joints(*joints):
    """A prediction: these joints are counted the other way."""
    return chain(angles=lambda q: np.where(np.isin(np.arange(1, 8), joints), -q, q))


def _added(shift):
    """A prediction: the angles are counted from elsewhere."""
    return chain(angles=lambda q: q + shift)


def _backwards(q):
    """The products T_i ... T_1."""
    return np.array(list(itertools.accumulate(steps(q), lambda T, step: step @ T)))


def _entry_by_entry(q):
    T, found = STAND, []
    for step in steps(q):
        T = T * step
        found.append(T)
    return np.array(found)


MISTAKES = (
    Mistake("the base is left out: these are poses seen from the base", _BASE_FIRST, _without_base),
    Mistake(
        "the base stands on the right of the steps",
        "Each pose is then moved along its own axes. " + _BASE_FIRST,
        lambda q: _without_base(q) @ STAND,
    ),
    Mistake("the base is added to some of the poses only", _BASE_FIRST, _with_base(7), _with_base(0)),
    Mistake(
        "the base comes in with every step",
        _BASE_FIRST,
        _with_the_base_each_time,
        _with_the_base_each_time_but_the_last,
    ),
    Mistake("the base is taken off, not added", _BASE_FIRST, chain(stand=inverse(STAND))),
    Mistake(
        "the base is off in one coordinate or its sign",
        "It stands at (-0.2, 0.13, 0.6), in metres.",
        *(
            chain(stand=transform(np.eye(3), np.multiply(BASE, factors)))
            for factors in itertools.product((-1, 0, 1), repeat=3)
            if factors != (1, 1, 1)
        ),
    ),
    Mistake("the flange is left where frame 7 is", _FLANGE, chain(flange=_NONE)),
    Mistake(
        "the flange is moved along the world's z, not along its own",
        _FLANGE,
        _flange_at(lambda T: along_z(FLANGE) @ T),
        _flange_at(lambda T: along_z(-FLANGE) @ T),
    ),
    Mistake(
        "the flange is moved the other way, or along another axis",
        _FLANGE,
        chain(flange=along_z(-FLANGE)),
        chain(flange=along_x(FLANGE)),
        chain(flange=transform(np.eye(3), [0, FLANGE, 0])),
    ),
    Mistake(
        "the flange comes in twice",
        "It is a step of its own, behind frame 7: the d of row 7 is 0.",
        chain(edited((6, 2, FLANGE))),
        chain(flange=along_z(2 * FLANGE)),
    ),
    Mistake(
        "the flange is put into frame 7 already",
        "Frame 7 sits on joint 7's axis, with d = 0. The flange is a step of its own.",
        chain(edited((6, 2, FLANGE)), flange=_NONE),
    ),
    Mistake(
        "0.109 stands for 0.107, as in the report",
        "The flange is 0.107 m from frame 7: the report is misprinted.",
        chain(flange=along_z(0.109)),
    ),
    Mistake(
        "the last frame or the flange is turned by pi/4, as the hand is",
        "The hand is screwed on with a turn of -pi/4. The flange is turned as frame 7, and row 7 has theta = q[6].",
        *(chain(flange=transform(rot_z(turn), [0, 0, FLANGE])) for turn in (-np.pi / 4, np.pi / 4)),
        *(_added(np.pi / 4 * sign * (np.arange(7) == 6)) for sign in (-1, 1)),
        *(chain(flange=transform(rot_z(turn), [0, 0, FLANGE + 0.1034])) for turn in (-np.pi / 4, 0)),
    ),
    Mistake(
        "the poses are not multiplied up: each is seen from the frame before",
        _ORDER,
        steps,
        lambda q: STAND @ steps(q),
        lambda q: np.concatenate([STAND @ steps(q)[:1], steps(q)[1:]]),
        lambda q: np.concatenate([steps(q)[:7], steps(q)[6:7] @ along_z(FLANGE)]),
        lambda q: STAND @ np.concatenate([steps(q)[:7], steps(q)[6:7] @ along_z(FLANGE)]),
    ),
    Mistake(
        "the steps are multiplied in the reverse order",
        _ORDER,
        in_reverse,
        lambda q: np.concatenate([in_reverse(q)[:7], in_reverse(q)[6:7] @ along_z(FLANGE)]),
        lambda q: STAND @ _backwards(q),
        lambda q: STAND @ np.concatenate([_backwards(q)[:7], _backwards(q)[6:7] @ along_z(FLANGE)]),
    ),
    Mistake(
        "all poses are one and the same matrix, changed in place",
        _COPY,
        _all_the_same,
        lambda q: np.array([frames(q)[7]] * 8),
    ),
    Mistake(
        "joints 4 and 6 are counted the other way, as in the report",
        "Every joint turns by q[i] about its own z, counter-clockwise.",
        _turned_joints(4, 6),
    ),
    Mistake(
        "some joint is counted the other way",
        "Every joint turns by q[i] about its own z, counter-clockwise.",
        *(_turned_joints(i) for i in range(1, 8)),
        _turned_joints(*range(1, 8)),
    ),
    Mistake("the angles are taken for degrees", _RADIANS, chain(angles=np.deg2rad), chain(angles=np.rad2deg)),
    Mistake("the angles are not used", "theta of row i is q[i].", chain(angles=lambda q: 0 * q)),
    Mistake(
        "the angles go with the wrong joints",
        "q[0] belongs to the first row of the table.",
        chain(angles=lambda q: q[::-1]),
        *(chain(angles=lambda q, shift=shift: np.roll(q, shift)) for shift in (-1, 1)),
        chain(angles=lambda q: np.append(0, q[:-1])),
        chain(angles=lambda q: np.append(q[1:], 0)),
        chain(angles=np.cumsum),
    ),
    Mistake(
        "the poses stand in another order",
        "Frames 1 to 7 first, the flange last.",
        lambda q: frames(q)[::-1],
        *(lambda q, shift=shift: np.roll(frames(q), shift, axis=0) for shift in (-1, 1)),
    ),
    Mistake(
        "the base is put in front and the flange left out",
        "The first of the eight is frame 1, the last the flange.",
        lambda q: np.concatenate([[STAND], frames(q)[:7]]),
        lambda q: np.concatenate([[_NONE], _without_base(q)[:7]]),
        lambda q: np.concatenate([[_NONE], frames(q)[:7]]),
    ),
    Mistake(
        "the inverses are returned",
        "Each pose is the frame as the world sees it: no inverse.",
        lambda q: inverse(frames(q)),
    ),
    Mistake(
        "the poses are transposed", "The place of each stands in its last column.", lambda q: frames(q).swapaxes(-1, -2)
    ),
    Mistake("the steps are multiplied entry by entry", "The matrix product is @.", _entry_by_entry),
    Mistake(
        "the steps are added up",
        "One step after the other is a product: T = T @ dh_modified(...).",
        lambda q: STAND + np.cumsum(steps(q), axis=0),
    ),
    Mistake(
        "the places are right and the turns left out",
        "dh_modified gives both at once.",
        lambda q: transform(np.eye(3), frames(q)[:, :3, 3]),
    ),
    Mistake(
        "the turns are right and the places left out",
        "dh_modified gives both at once.",
        lambda q: transform(frames(q)[:, :3, :3], np.zeros(3)),
    ),
    *TABLE_MISTAKES,
    Mistake(
        "digits after the point are cut off",
        "np.zeros((8, 4, 4)) has room for digits, with dtype=int it has not.",
        lambda q: np.trunc(frames(q)),
    ),
    few_digits(frames),
)
