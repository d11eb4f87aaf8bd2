"""What an answer to ik_2r does: where its rows lead, which side its elbows are on, and what would mend it."""

import numpy as np

from course_lib.checks.decomposition_ik.two_links import place
from course_lib.checks.exercise import Mistake

_RIM = 2 - 1e-3  # from here on it is near the rim
_FOLDED = np.pi - 1e-6  # theta2 and -theta2 are the same from here on


def inside(xy):
    return np.linalg.norm(xy) < _RIM


def on_rim(xy):
    return _RIM <= np.linalg.norm(xy) < 2 + 1e-9


def outside(xy):
    return np.linalg.norm(xy) > 2 + 1e-9


def wrapped(angle):
    return np.angle(np.exp(1j * angle))


def off(theta, xy):
    """How far from xy the end is, (2,), for both rows."""
    return np.linalg.norm(place(theta) - xy, axis=-1)


def in_order(theta, xy):
    """Whether theta2 >= 0 stands first, where its sign means anything."""
    bend = wrapped(theta[:, 1])
    if (np.abs(bend) > _FOLDED).all():
        return True
    return bend[0] >= -1e-3 * on_rim(xy) and bend[1] <= 1e-3 * on_rim(xy)


def mended(name, hint, *mendings):
    """One mistake that can be mended: each of the mendings makes the right answer of a wrong one."""

    def seen(mending):
        def looks(theta, xy):
            better = mending(theta, xy)
            return bool((off(better, xy) < 1e-6).all() and in_order(better, xy))

        return looks

    return tuple(Mistake(name, hint, seen=seen(mending)) for mending in mendings)


def with_theta1(change):
    return lambda theta, xy: np.stack([change(theta[:, 0], theta[:, 1], xy), theta[:, 1]], -1)


def with_theta2(change):
    return lambda theta, xy: np.stack([theta[:, 0], change(theta[:, 0], theta[:, 1], xy)], -1)


def towards(xy):
    return np.arctan2(xy[1], xy[0])


def corrected(theta, xy):
    """The right pairs for the theta2 in the answer."""
    return with_theta1(lambda t1, t2, xy: towards(xy) - correction(t2))(theta, xy)


def right_bend(theta, xy):
    return bool((off(corrected(theta, xy), xy) < 1e-6).all() and in_order(theta, xy))


def same_theta1(theta, xy):
    """One row right, and theta1 the same in both."""
    return (off(theta, xy) < 1e-6).any() and np.abs(wrapped(theta[0, 0] - theta[1, 0])) < 1e-9


def theta1_is(formula):
    """Whether theta2 is right and theta1 is formula(xy, theta2)."""

    def looks(theta, xy):
        wanted = formula(xy, theta[:, 1])
        return right_bend(theta, xy) and (np.abs(wrapped(theta[:, 0] - wanted)) < 1e-6).all()

    return looks


def by_arctan(side):
    """Whether theta1 comes from atan(y / x), with either sign of the elbow correction; at x = 0 it may be anything."""

    def looks(theta, xy):
        if xy[0] == 0:
            return not xy.any() or right_bend(theta, xy) or bool(np.isnan(theta[:, 0]).all())
        return theta1_is(lambda xy, t2: np.arctan(xy[1] / xy[0]) - side * correction(t2))(theta, xy)

    return looks


def correction(t2):
    return np.arctan2(np.sin(t2), 1 + np.cos(t2))


def supplement(theta):
    """The answer with pi - |theta2| for |theta2|."""
    bend = wrapped(theta[:, 1])
    return np.stack([theta[:, 0], np.where(bend < 0, -np.pi, np.pi) - bend], -1)


def cosine_is(formula):
    """Whether the cosine of theta2 is formula(r), or would be, if it were one."""

    def looks(theta, xy):
        if outside(xy):
            return False
        cosine = formula(np.linalg.norm(xy))
        if abs(cosine) > 1 and np.isnan(theta).any():
            return True
        return (np.abs(np.cos(theta[:, 1]) - np.clip(cosine, -1, 1)) < 1e-6).all()

    return looks
