"""Whether the velocities of a trajectory are those of its positions and times."""

import numpy as np

from course_lib.trajectory.motion import checked_trajectory

_STANDS_STILL = 1e-6  # radians: what moves less in all stands still
# A joint moves if it moves by more than this many standard deviations of its noise. Of 10,000
# normal samples the largest is about 4 of them away, so that a range is about 8.
_NOISE_RANGE = 10
_TOLERANCE = 0.01  # of the factor between times, for exact data
# Differences of samples are recognized if they fit this much better than the velocity at the sample
# does, which lies between the differences before it and after it.
_DIFFERENCES_FIT = 0.05
_MAX_DELAY = 5  # steps by which a robot's filter may delay velocities without a word
_TINY = 1e-300  # in place of zero, where something is divided


def disagreement(trajectory):
    """Return a sentence on how positions, velocities and times disagree, or "" if they agree or
    nothing moves.

    Joint by joint, the angle is compared with the integral of the velocity by the trapezoidal rule.
    What is left must not grow, and the factor by which all times would have to be multiplied for
    the best fit must be 1. The tolerances follow from the noise of the samples and from how much
    the rule may be off at this sampling, by the changes of the velocity.

    Velocities that are differences of neighbouring positions belong half a step earlier or later
    than their rows say; this is said, too. Without given velocities there is nothing to compare.

    Parameters
    ----------
    trajectory : Trajectory

    Returns
    -------
    str

    Examples
    --------
    >>> from course_lib.trajectory import Trajectory
    >>> disagreement(Trajectory(np.array([0.0, 1]), np.array([[0.0], [2]]), np.array([[1.0], [1]])))
    'The velocities fit times that are 2 times as far apart: a mean step of about 2 s, not 1 s.'
    """
    t, q, qd = checked_trajectory(trajectory)
    if not trajectory.velocities_given or len(t) < 2:
        return ""
    if said := _differences_of_neighbours(t, q, qd):
        return said
    steps = np.diff(t)[:, None]
    integral = np.vstack([np.zeros(q.shape[1]), np.cumsum(steps * (qd[1:] + qd[:-1]) / 2, axis=0)])
    position = q - q.mean(0)
    integral -= integral.mean(0)
    q_noise, walk = _noise(q), _random_walk(steps, qd)
    moving = np.maximum(np.ptp(position, axis=0), np.ptp(integral, axis=0)) > (
        _STANDS_STILL + _NOISE_RANGE * (q_noise + walk)
    )
    if not moving.any():
        return ""
    delayed, spread = _delayed(steps, position, integral, qd)
    position = position - delayed
    square = np.maximum((integral**2).sum(0), _TINY)
    factor = (position * integral).sum(0) / square
    left = position - factor * integral
    # What the trapezoidal rule may be off, as an angle, over all steps.
    rule = _rule_error(steps, qd)
    reach = np.maximum(np.ptp(integral, axis=0), _TINY)
    allowed = _TOLERANCE + (rule + 3 * walk + q_noise) * spread / reach
    grown = np.ptp(left, axis=0) > (
        0.3 * np.ptp(position, axis=0) + _NOISE_RANGE * (q_noise + walk) + rule
    )
    wrong = moving & (grown | ((factor <= 0) & (allowed < 1)))
    off = moving & (np.abs(factor - 1) > allowed)
    if not (wrong | off).any():
        return ""
    which = np.flatnonzero(wrong | off) + 1
    joint = f" of joint{'s' * (len(which) > 1)} {', '.join(map(str, which))}"
    if wrong.any():
        slopes = np.abs(np.diff(q, axis=0) / steps - (qd[1:] + qd[:-1]) / 2)
        whose = "" if wrong[moving].all() else joint
        return (
            f"The velocities{whose} are not those of the positions, whatever the times: off by up "
            f"to {slopes[:, wrong].max():.3g} rad/s."
        )
    mean = np.median(factor[moving])
    together = np.abs(mean - 1) > _TOLERANCE
    if together and (np.abs(factor - mean)[moving] <= allowed[moving] + 0.01 * mean).all():
        return (
            f"The velocities fit times that are {mean:.3g} times as far apart: a mean step of about"
            f" {mean * steps.mean():.2g} s, not {steps.mean():.3g} s."
        )
    factors = ", ".join(f"{one:.3g}" for one in factor[off])
    return f"The positions move {factors} times as fast as the velocities{joint} say."


def _delayed(steps, position, integral, qd):
    """Return the part of the positions that a small delay of the velocities explains, and a factor
    of noise.

    A robot filters the velocities that it reports, and so they are late by some steps. The delay
    times the velocity is that part; the least-squares fit of the positions by the integral and the
    velocity tells the delay from the factor of the times. The more alike these two are, the more
    noise matters: by the second value, which is 1 if they are orthogonal.
    """
    spread = np.ones(qd.shape[1])
    if len(qd) < 8:
        return np.zeros_like(position), spread
    velocity = qd - qd.mean(0)
    ii, vv = (integral**2).sum(0), (velocity**2).sum(0)
    iv = (integral * velocity).sum(0)
    ip, vp = (integral * position).sum(0), (velocity * position).sum(0)
    independent = 1 - iv**2 / np.maximum(ii * vv, _TINY)
    apart = independent > 1e-6  # otherwise the motion cannot tell one from the other
    delay = np.zeros(qd.shape[1])
    np.divide(ii * vp - iv * ip, ii * vv * independent, out=delay, where=apart & (ii * vv > _TINY))
    spread[apart] = 1 / np.sqrt(independent[apart])
    largest = _MAX_DELAY * steps.mean()
    return np.clip(delay, -largest, largest) * velocity, spread


def _noise(values):
    """Return the standard deviation of the noise of each column, from differences in which a motion
    cancels.

    Third differences of a smooth motion are small beside noise, whose variance they multiply by 20;
    their median stays what it is if the motion jerks at some samples.
    """
    if len(values) < 8:
        return np.zeros(values.shape[1])
    third = np.abs(np.diff(values, 3, axis=0))
    # Half of normal samples are within 0.6745 standard deviations.
    normal = np.median(third, axis=0) / (0.6745 * np.sqrt(20))
    # Rounding to a resolution r has the standard deviation r / sqrt(12).
    changes = np.abs(np.diff(values, axis=0))
    resolution = np.where(changes > 0, changes, np.inf).min(0)
    return np.maximum(normal, np.where(np.isfinite(resolution), resolution, 0) / np.sqrt(12))


def _random_walk(steps, qd):
    """Return the standard deviation of the integral at its end that comes from the noise of the
    velocities."""
    return _noise(qd) * np.linalg.norm(steps)


def _rule_error(steps, qd):
    """Return how much the trapezoidal rule may be off in all: a twelfth of h times the second
    differences."""
    if len(qd) < 3:
        return np.abs(np.diff(qd, axis=0) * steps).sum(0) / 2
    return np.abs(steps[1:] * np.diff(qd, 2, axis=0)).sum(0) / 12


def _differences_of_neighbours(t, q, qd):
    """Return a sentence if the velocities are differences with the sample before or after, else "".

    A motion at constant velocity has the same differences on both sides, and nothing is said.
    """
    if len(t) < 4:
        return ""
    slopes = np.diff(q, axis=0) / np.diff(t)[:, None]
    # The velocity at a sample lies halfway between the slopes on its two sides.
    halfway = np.abs(np.diff(slopes, axis=0)).max() / 2
    speed = np.abs(slopes).max()
    if halfway <= 1e-3 * speed:
        return ""
    for rows, late, side, edge in (
        (qd[1:], "late", "before", qd[0]),
        (qd[:-1], "early", "after", qd[-1]),
    ):
        if np.abs(rows - slopes).max() > _DIFFERENCES_FIT * halfway:
            continue
        which = "first" if late == "late" else "last"
        zero = "" if edge.any() else f", and the {which} row is zero"
        step = np.diff(t).mean()
        return (
            f"The velocities are differences with the sample {side}: each is half a step, about "
            f"{step / 2:.2g} s, {late}{zero}."
        )
    return ""
