"""The known mistakes in panda_fk."""

import itertools

import numpy as np

from course_lib.checks.exercise import Mistake
from course_lib.checks.exercises.panda_dh_ik.shared import (
    BASE,
    FLANGE,
    T_W0,
    TABLE,
    along_x,
    along_z,
    chain,
    edited,
    frames,
    modified,
    standard,
    steps,
    truncated,
)
from course_lib.checks.vocabulary import few_digits, inverted, products
from course_lib.rigid import inverse, transform
from course_lib.rotations import rot_z

_BASE_FIRST = "The pose of the base in the world is the first factor, before the loop."
_FLANGE = "The flange is one more step, along the z axis of frame 7."
_ORDER = "Each step is seen from the frame before, so it is the right factor: T = T @ step."
_SHEET = "The data sheet's table is in the notebook as modified_table."
_SIGN = "Every joint rotates by q[i] about its own z axis, counter-clockwise."
_NONE = np.eye(4)

_UP = np.vstack([TABLE[1:, :2], [0, 0]])  # a and alpha moved up by a row
_STANDARD = np.column_stack([_UP, TABLE[:, 2]])
_LONGER = _STANDARD + np.outer(np.arange(7) == 6, [0, 0, FLANGE])
_PRINTED = _STANDARD.copy()  # the report's
_PRINTED[:, 1] = np.pi / 2 * np.array([-1, 1, -1, 1, -1, -1, 0])
_PRINTED[[2, 6], 2] = 0.136, 0.109


def _standard_frames(table):
    """Return an answer: eight frames of the standard convention, the base the first of them."""
    return lambda q: np.concatenate([[T_W0], chain(table, standard)(q)[:7]])


def _flange_at(pose_of):
    """Return an answer: the frames are right, the flange's pose is pose_of(that of frame 7)."""
    return lambda q: np.concatenate([frames(q)[:7], [pose_of(frames(q)[6])]])


def _with_base(*indices):
    """Return an answer: the base comes into these poses only."""

    def answer(q):
        T = chain(base=_NONE)(q)
        T[list(indices)] = T_W0 @ T[list(indices)]
        return T

    return answer


def _negated_joints(*joints):
    return chain(angles=lambda q: np.where(np.isin(np.arange(1, 8), joints), -q, q))


def _accumulated(product, start=T_W0):
    return lambda q: np.array(list(itertools.accumulate(steps(q), product, initial=start))[1:])


def _flange_after(answer):
    """Return an answer: its frames, and the flange one step after the last of them."""
    return lambda q: np.concatenate([answer(q)[:7], answer(q)[6:7] @ along_z(FLANGE)])


_reversed = _accumulated(lambda T, step: step @ T)

MISTAKES = (
    Mistake("the base is left out: these are poses seen from the base", _BASE_FIRST, chain(base=_NONE)),
    Mistake("the base is the right factor", _BASE_FIRST, lambda q: chain(base=_NONE)(q) @ T_W0),
    Mistake("the base is the left factor of some poses only", _BASE_FIRST, _with_base(7), _with_base(0)),
    Mistake(
        "the base comes in with every step",
        _BASE_FIRST,
        lambda q: np.array(products([T_W0 @ step for step in steps(q)])[1:]),
        lambda q: np.array(products([*(T_W0 @ step for step in steps(q)[:7]), steps(q)[7]])[1:]),
    ),
    Mistake("the inverse of the base's pose is taken", _BASE_FIRST, chain(base=inverse(T_W0))),
    Mistake(
        "the base has a wrong coordinate",
        "It is at (-0.2, 0.13, 0.6), in metres.",
        *(
            chain(base=transform(np.eye(3), np.multiply(BASE, signs)))
            for signs in itertools.product((-1, 0, 1), repeat=3)
            if signs not in ((1, 1, 1), (0, 0, 0), (-1, -1, -1))
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
        "the flange is moved in the opposite direction, or along another axis",
        _FLANGE,
        chain(flange=along_z(-FLANGE)),
        chain(flange=along_x(FLANGE)),
        chain(flange=transform(np.eye(3), [0, FLANGE, 0])),
    ),
    Mistake(
        "the flange comes in twice",
        "It is a step of its own, after frame 7: the d of row 7 is 0.",
        chain(edited((6, 2, FLANGE))),
        chain(flange=along_z(2 * FLANGE)),
    ),
    Mistake(
        "the flange is put into frame 7 already",
        "Frame 7 is on joint 7's axis, with d = 0. The flange is a step of its own.",
        chain(edited((6, 2, FLANGE)), flange=_NONE),
    ),
    Mistake(
        "0.109 stands for 0.107, as in the report", "The flange is 0.107 m from frame 7.", chain(flange=along_z(0.109))
    ),
    Mistake(
        "the last frame or the flange is rotated by pi/4, as the gripper is",
        "The gripper is mounted at an angle of -pi/4. The flange has the axes of frame 7.",
        *(chain(flange=transform(rot_z(angle), [0, 0, FLANGE])) for angle in (-np.pi / 4, np.pi / 4)),
        *(chain(angles=lambda q, s=s: q + np.pi / 4 * s * (np.arange(7) == 6)) for s in (-1, 1)),
        *(chain(flange=transform(rot_z(angle), [0, 0, FLANGE + 0.1034])) for angle in (-np.pi / 4, 0)),
    ),
    Mistake(
        "the poses are not multiplied up: each is seen from the frame before",
        _ORDER,
        steps,
        lambda q: T_W0 @ steps(q),
        lambda q: np.concatenate([T_W0 @ steps(q)[:1], steps(q)[1:]]),
        _flange_after(steps),
        _flange_after(lambda q: T_W0 @ steps(q)),
    ),
    Mistake(
        "the steps are multiplied in the reverse order",
        _ORDER,
        _reversed,
        _flange_after(_reversed),
        lambda q: T_W0 @ _accumulated(lambda T, step: step @ T, _NONE)(q),
    ),
    Mistake(
        "all poses are one and the same matrix, changed in place",
        "T @= ... and T[:] = ... change the matrix that is in the list already. T = T @ ... makes a new one.",
        lambda q: np.concatenate([[frames(q)[6]] * 7, frames(q)[7:]]),
        lambda q: np.array([frames(q)[7]] * 8),
    ),
    Mistake("joints 4 and 6 rotate in the opposite direction, as in the report's table", _SIGN, _negated_joints(4, 6)),
    Mistake(
        "some joint rotates in the opposite direction",
        _SIGN,
        *map(_negated_joints, range(1, 8)),
        _negated_joints(*range(1, 8)),
    ),
    Mistake(
        "the angles are taken for degrees",
        "Angles are in radians throughout.",
        chain(angles=np.deg2rad),
        chain(angles=np.rad2deg),
    ),
    Mistake("the angles are not used", "theta of row i is q[i].", chain(angles=lambda q: 0 * q)),
    Mistake(
        "the angles go with the wrong joints",
        "q[0] belongs to the first row of the table.",
        chain(angles=lambda q: q[::-1]),
        *(chain(angles=lambda q, shift=shift: np.roll(q, shift)) for shift in (-1, 1)),
        chain(angles=np.cumsum),
    ),
    Mistake(
        "the poses are in another order",
        "Frames 1 to 7 first, the flange last.",
        lambda q: frames(q)[::-1],
        *(lambda q, shift=shift: np.roll(frames(q), shift, axis=0) for shift in (-1, 1)),
    ),
    Mistake(
        "the base is the first pose and the flange is left out",
        "The first of the eight is frame 1, the last the flange.",
        lambda q: np.concatenate([[T_W0], frames(q)[:7]]),
        lambda q: np.concatenate([[_NONE], chain(base=_NONE)(q)[:7]]),
    ),
    inverted(frames),
    Mistake("the poses are transposed", "The origin of each is its last column.", lambda q: frames(q).swapaxes(-1, -2)),
    Mistake("the steps are multiplied entry by entry", "The matrix product is @.", _accumulated(np.multiply)),
    Mistake(
        "the steps are added", "One step after another is a product.", lambda q: T_W0 + np.cumsum(steps(q), axis=0)
    ),
    Mistake(
        "the rotations are left out",
        "dh_modified gives the whole pose.",
        lambda q: transform(np.eye(3), frames(q)[:, :3, 3]),
    ),
    Mistake(
        "the positions are left out",
        "dh_modified gives the whole pose.",
        lambda q: transform(frames(q)[:, :3, :3], np.zeros(3)),
    ),
    Mistake(
        "0.136 stands for 0.316, as in the report",
        "In the report two digits of d_3 are swapped. " + _SHEET,
        chain(edited((2, 2, 0.136))),
        chain(edited((2, 2, 0.136)), flange=along_z(0.109)),
    ),
    Mistake(
        "the standard convention is taken with the modified table",
        "modified_table belongs to dh_modified.",
        chain(convention=standard),
    ),
    Mistake(
        "the standard table is taken with the modified convention",
        "dh_modified needs modified_table, whose columns a and alpha are one row further down.",
        chain(_STANDARD),
        chain(_LONGER),
        chain(_LONGER, flange=_NONE),
    ),
    Mistake(
        "these are the frames of the standard convention",
        "They are one axis further on. The task asks for those of the modified one.",
        chain(_STANDARD, standard),
        chain(_LONGER, standard),
        chain(_LONGER, standard, flange=_NONE),
        _standard_frames(_STANDARD),
        _standard_frames(_LONGER),
    ),
    Mistake(
        "the report's printed table is taken",
        "It has two misprints and is in the standard convention. " + _SHEET,
        chain(_PRINTED, standard, flange=_NONE),
        chain(_PRINTED, standard),
        _standard_frames(_PRINTED),
        chain(_PRINTED),
        chain(_PRINTED, flange=_NONE),
    ),
    Mistake(
        "the signs of a in rows 4 and 5 are mixed up",
        "The two have opposite signs. " + _SHEET,
        chain(edited((3, 0, -0.0825), (4, 0, 0.0825))),
        chain(edited((4, 0, 0.0825))),
        chain(edited((3, 0, -0.0825))),
    ),
    Mistake(
        "alpha has the wrong sign in some row",
        _SHEET,
        *(
            chain(edited(*((row, 1, -TABLE[row, 1]) for row in rows)))
            for rows in itertools.chain(
                itertools.combinations(range(1, 7), 1), itertools.combinations(range(1, 7), 2), [range(1, 7)]
            )
        ),
    ),
    Mistake(
        "an entry of the table is left out",
        _SHEET,
        *(chain(edited((row, column, 0.0))) for row, column in np.argwhere(TABLE)),
        *(chain(TABLE * (np.arange(3) != column)) for column in range(3)),
    ),
    Mistake(
        "the columns of the table are mixed up",
        "A row is a, alpha, d, and the angle is theta.",
        *(chain(TABLE[:, list(order)]) for order in itertools.permutations(range(3)) if order != (0, 1, 2)),
        chain(convention=lambda a, alpha, d, theta: modified(a, theta, d, alpha)),
    ),
    Mistake(
        "the rows of the table are shifted against each other",
        _SHEET,
        *(chain(np.roll(TABLE, shift, axis=0)) for shift in (-1, 1)),
        *(chain(np.column_stack([TABLE[:, :2], np.roll(TABLE[:, 2], shift)])) for shift in (-1, 1)),
    ),
    truncated(frames),
    few_digits(frames),
)
