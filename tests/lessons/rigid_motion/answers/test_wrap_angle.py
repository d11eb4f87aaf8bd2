"""What students write for test_wrap_angle(wrap_angle)."""

import math

import numpy as np

SIZES = [0.15, 0.2, 1.0, 2.0, 3.1, 3.145, np.pi, 3.3, 6.0, 10.0, 3 * np.pi, 18.0, 100.0]
ANGLES = [0.0, *SIZES, *(-size for size in SIZES)]


def right_range_and_direction(wrap_angle):
    for angle in ANGLES:
        value = wrap_angle(angle)
        allowed = 1e-9 * max(1, abs(angle))
        if abs(value) > np.pi + allowed:
            return False
        if not np.allclose(
            [np.cos(value), np.sin(value)], [np.cos(angle), np.sin(angle)], rtol=0, atol=allowed
        ):
            return False
    return True


def right_against_a_version_of_its_own(wrap_angle):
    off = [abs(wrap_angle(a) - math.remainder(a, 2 * math.pi)) for a in ANGLES]
    half = [abs(math.cos(a / 2)) < 1e-9 for a in ANGLES]  # where the sign of pi is free
    allowed = [1e-9 * max(1, abs(a)) for a in ANGLES]
    return all(
        min(gap, abs(gap - 2 * math.pi)) < bound if either else gap < bound
        for gap, either, bound in zip(off, half, allowed, strict=True)
    )


def right_whole_revolutions_with_assertions(wrap_angle):
    angles = np.append(np.linspace(-20, 20, 4950), np.pi * np.array([-5, -3, -1, 1, 3, 5]))
    for angle in angles:
        value = wrap_angle(angle)
        revolutions = (angle - value) / (2 * np.pi)
        assert abs(revolutions - round(revolutions)) < 1e-8
        assert -np.pi - 1e-7 <= value <= np.pi + 1e-7
    return True


def wrong_compares_exactly(wrap_angle):
    """your test rejects right versions"""
    # For these angles most right versions are right to the last digit.
    for angle in (0.0, 0.2, 0.5, 3.145, np.pi, 4.0, 7.0, -4.0, 18.0, 100.0, -100.0):
        revolutions = (angle - wrap_angle(angle)) / (2 * np.pi)
        if abs(wrap_angle(angle)) > np.pi or revolutions != round(revolutions):
            return False
    return True


def wrong_only_angles_drawn(wrap_angle):
    """unnamed"""
    for angle in np.random.default_rng(1).uniform(-20, 20, 4000):
        if abs(wrap_angle(angle) - math.remainder(angle, 2 * math.pi)) > 1e-7:
            return False
    return True
