"""Facts about an answer to ik_2r: its tips, the sides of its elbows, and which change would make it right."""

import numpy as np

from course_lib.checks.exercises.decomposition_ik.shared import position
from course_lib.checks.exercise import Mistake

_EDGE = 2 - 1e-3  # from here on it is near the edge
_FOLDED = np.pi - 1e-6  # q2 and -q2 are the same from here on


def inside(xy):
    """Return whether a position is in reach and not near the edge."""
    return np.linalg.norm(xy) < _EDGE


def at_edge(xy):
    """Return whether a position is at the edge of the workspace, or near it inside."""
    return _EDGE <= np.linalg.norm(xy) < 2 + 1e-9


def outside(xy):
    """Return whether a position is out of reach."""
    return np.linalg.norm(xy) > 2 + 1e-9


def wrapped(angle):
    """Return an angle between -pi and pi."""
    return np.angle(np.exp(1j * angle))


def off(q, xy):
    """Return the distance of the tip from xy, (2,), for both rows."""
    return np.linalg.norm(position(q) - xy, axis=-1)


def in_order(q, xy):
    """Return whether the row with q2 >= 0 is the first, where its sign is defined."""
    bend = wrapped(q[:, 1])
    if (np.abs(bend) > _FOLDED).all():
        return True
    return bend[0] >= -1e-3 * at_edge(xy) and bend[1] <= 1e-3 * at_edge(xy)


def right_after(name, hint, *changes):
    """Return a Mistake that an answer shows if one of the changes, change(q, xy), makes it right."""

    def seen(q, xy):
        better = (change(q, xy) for change in changes)
        return any(bool((off(each, xy) < 1e-6).all() and in_order(each, xy)) for each in better)

    return Mistake(name, hint, seen=seen)


def with_q1(change):
    """Return a correction that replaces q1 by change(q1, q2, xy)."""
    return lambda q, xy: np.stack([change(q[:, 0], q[:, 1], xy), q[:, 1]], -1)


def with_q2(change):
    """Return a correction that replaces q2 by change(q1, q2, xy)."""
    return lambda q, xy: np.stack([q[:, 0], change(q[:, 0], q[:, 1], xy)], -1)


def towards(xy):
    """Return the direction of a position, as an angle."""
    return np.arctan2(xy[1], xy[0])


def corrected(q, xy):
    """Return the right pairs for the q2 in the answer."""
    return with_q1(lambda t1, t2, xy: towards(xy) - correction(t2))(q, xy)


def right_bend(q, xy):
    """Return whether q2 is right in both rows."""
    return bool((off(corrected(q, xy), xy) < 1e-6).all() and in_order(q, xy))


def same_q1(q, xy):
    """Return whether one row is right and both have the same q1."""
    return (off(q, xy) < 1e-6).any() and np.abs(wrapped(q[0, 0] - q[1, 0])) < 1e-9


def q1_is(formula):
    """Return a function that returns whether q2 is right and q1 is formula(xy, q2)."""

    def looks(q, xy):
        wanted = formula(xy, q[:, 1])
        return right_bend(q, xy) and (np.abs(wrapped(q[:, 0] - wanted)) < 1e-6).all()

    return looks


def by_arctan(side):
    """Return a function that returns whether q1 comes from atan(y / x); at x = 0 it may be anything."""

    def looks(q, xy):
        if xy[0] == 0:
            return not xy.any() or right_bend(q, xy) or bool(np.isnan(q[:, 0]).all())
        return q1_is(lambda xy, t2: np.arctan(xy[1] / xy[0]) - side * correction(t2))(q, xy)

    return looks


def correction(t2):
    """Return the angle of the tip, seen from the base, for q1 = 0."""
    return np.arctan2(np.sin(t2), 1 + np.cos(t2))


def supplement(q):
    """Return the answer with pi - |q2| in place of |q2|."""
    bend = wrapped(q[:, 1])
    return np.stack([q[:, 0], np.where(bend < 0, -np.pi, np.pi) - bend], -1)


def cosine_is(formula):
    """Return a function that returns whether the cosine of q2 is formula(r), limited to -1 and 1."""

    def looks(q, xy):
        if outside(xy):
            return False
        cosine = formula(np.linalg.norm(xy))
        if abs(cosine) > 1 and np.isnan(q).any():
            return True
        return (np.abs(np.cos(q[:, 1]) - np.clip(cosine, -1, 1)) < 1e-6).all()

    return looks
