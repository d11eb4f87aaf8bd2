"""What students write for wrap_angle(angle)."""

import numpy as np


def right_rounded(angle):
    return angle - 2 * np.pi * np.round(angle / (2 * np.pi))


def right_shifted_remainder(angle):
    return (angle + np.pi) % (2 * np.pi) - np.pi


def right_sine_and_cosine(angle):
    return np.arctan2(np.sin(angle), np.cos(angle)).tolist()


def wrong_sign_times_arccos(angle):
    """an angle is changed that needs no wrapping"""
    return np.sign(np.sin(angle)) * np.arccos(np.cos(angle))


def wrong_short_pi(angle):
    """right to its first digits only"""
    return angle - 2 * 3.14159 * np.round(angle / (2 * 3.14159))


def wrong_float32(angle):
    """the seven digits of float32"""
    return np.float32(right_rounded(angle))


def wrong_slightly_beyond_pi(angle):
    """the answers to some inputs only are wrong"""
    return np.where(np.abs(angle) < np.pi + 1e-8, angle, right_rounded(angle))
