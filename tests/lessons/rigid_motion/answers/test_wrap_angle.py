"""What students write for test_wrap_angle(wrap_angle)."""

import math

import numpy as np

ANGLES = [0.0, 1.0, -1.0, 2.0, -2.0, 3.1, -3.1, 3.3, -3.3, 6.0, -6.0, 10.0, -10.0, 100.0, -100.0]


def right_range_and_direction(wrap_angle):
    for angle in ANGLES:
        value = wrap_angle(angle)
        if abs(value) > np.pi + 1e-9:
            return False
        if not np.allclose(
            [np.cos(value), np.sin(value)], [np.cos(angle), np.sin(angle)], atol=1e-9
        ):
            return False
    return True


def right_against_a_version_of_its_own(wrap_angle):
    return all(abs(wrap_angle(a) - math.remainder(a, 2 * math.pi)) < 1e-9 for a in ANGLES)


def right_whole_revolutions_with_assertions(wrap_angle):
    for angle in np.random.default_rng(1).uniform(-50, 50, 60):
        revolutions = (angle - wrap_angle(angle)) / (2 * np.pi)
        assert abs(revolutions - round(revolutions)) < 1e-9
        assert -np.pi <= wrap_angle(angle) <= np.pi
    return True


def wrong_compares_exactly(wrap_angle):
    """your test rejects right versions"""
    # For these angles most right versions are right to the last digit.
    for angle in (4.0, 7.0, -4.0, 100.0, 0.0, 0.5):
        revolutions = (angle - wrap_angle(angle)) / (2 * np.pi)
        if abs(wrap_angle(angle)) > np.pi or revolutions != round(revolutions):
            return False
    return True
