"""What students write for wrap_angle(angle)."""

import cmath
import math

import numpy as np

from course_lib import planar


def right_rounded(angle):
    return angle - 2 * np.pi * np.round(angle / (2 * np.pi))


def right_shifted_remainder(angle):
    return (angle + np.pi) % (2 * np.pi) - np.pi


def wrong_loops(angle):
    """ValueError"""
    while angle > math.pi:
        angle -= 2 * math.pi
    while angle <= -math.pi:
        angle += 2 * math.pi
    return angle


def right_sine_and_cosine(angle):
    return np.arctan2([np.sin(angle)], [np.cos(angle)])


def wrong_phase(angle):
    """TypeError"""
    return cmath.phase(cmath.exp(1j * angle))


def right_mirrored(angle):
    return np.pi - np.mod(np.pi - angle, 2 * np.pi)


def wrong_remainder_of_ieee(angle):
    """TypeError"""
    return math.remainder(angle, math.tau)


def wrong_again_and_again(angle):
    """ValueError"""
    if abs(angle) <= np.pi:
        return angle
    return wrong_again_and_again(angle - math.copysign(2 * np.pi, angle))


def wrong_remainder_then_one_turn(angle):
    """ValueError"""
    angle = np.mod(angle, 2 * np.pi)
    if angle > np.pi:
        angle -= 2 * np.pi
    return np.array(angle)


def wrong_nothing_done(angle):
    """the angle comes back as it is"""
    return angle


def wrong_one_turn(angle):
    """only one revolution"""
    if angle > np.pi:
        return angle - 2 * np.pi
    if angle < -np.pi:
        return angle + 2 * np.pi
    return angle


def wrong_from_zero(angle):
    """between 0 and 2 pi"""
    return angle % (2 * np.pi)


def wrong_floor(angle):
    """between 0 and 2 pi"""
    return angle - 2 * math.pi * math.floor(angle / (2 * math.pi))


def wrong_truncated(angle):
    """between -2 pi and 2 pi"""
    return angle - int(angle / (2 * np.pi)) * 2 * np.pi


def wrong_fmod(angle):
    """with its sign"""
    return math.fmod(angle + math.pi, 2 * math.pi) - math.pi


def wrong_forwards_only(angle):
    """angles below -pi"""
    while angle > np.pi:
        angle -= 2 * np.pi
    return angle


def wrong_backwards_only(angle):
    """angles above pi"""
    while angle < -np.pi:
        angle += 2 * np.pi
    return angle


def wrong_one_turn_forwards_only(angle):
    """angles below -pi"""
    return angle - 2 * np.pi if angle > np.pi else angle


def wrong_shift_taken_off_only(angle):
    """pi is added before"""
    return angle % (2 * np.pi) - np.pi


def wrong_shift_added_only(angle):
    """pi is added before"""
    return (angle + np.pi) % (2 * np.pi)


def wrong_shift_added_twice(angle):
    """pi is added again"""
    return (angle + np.pi) % (2 * np.pi) + np.pi


def wrong_half_turns(angle):
    """half revolutions"""
    while angle > np.pi:
        angle -= np.pi
    while angle < -np.pi:
        angle += np.pi
    return angle


def wrong_half_turn_remainder(angle):
    """half revolutions"""
    return (angle + np.pi / 2) % np.pi - np.pi / 2


def wrong_loop_from_a_whole_turn(angle):
    """between -2 pi and 2 pi"""
    while angle > 2 * np.pi:
        angle -= 2 * np.pi
    while angle < -2 * np.pi:
        angle += 2 * np.pi
    return angle


def wrong_degrees(angle):
    """degrees"""
    return (angle + 180) % 360 - 180


def wrong_answer_in_degrees(angle):
    """degrees"""
    return np.degrees(np.arctan2(np.sin(angle), np.cos(angle)))


def wrong_arccos(angle):
    """the sign is lost"""
    return np.arccos(np.clip(np.cos(angle), -1, 1))


def wrong_absolute(angle):
    """the sign is lost"""
    return right_rounded(abs(angle))


def wrong_sign(angle):
    """the sign is changed"""
    return 2 * np.pi * np.round(angle / (2 * np.pi)) - angle


def wrong_arcsin(angle):
    """arcsin"""
    return np.arcsin(np.sin(angle))


def wrong_arctan_of_the_tangent(angle):
    """half revolutions"""
    return np.arctan(np.sin(angle) / np.cos(angle))


def wrong_arctan2_swapped(angle):
    """swapped in arctan2"""
    return np.arctan2(np.cos(angle), np.sin(angle))


def wrong_clipped(angle):
    """clipped"""
    return max(-np.pi, min(np.pi, angle))


def wrong_added(angle):
    """are added"""
    return angle + 2 * np.pi * np.round(angle / (2 * np.pi))


def wrong_short_pi(angle):
    """rounded number stands for pi"""
    return (angle + 3.14) % 6.28 - 3.14


def wrong_two_turns(angle):
    """whole revolutions remain in the answer"""
    return angle - 4 * np.pi * np.round(angle / (4 * np.pi))


def wrong_count_of_turns(angle):
    """unnamed"""
    return angle / (2 * np.pi) - np.round(angle / (2 * np.pi))


def wrong_printed(angle):
    """a return is missing"""
    print(right_rounded(angle))


def wrong_the_librarys(angle):
    """course_lib.planar.wrap_angle is called"""
    return planar.wrap_angle(angle)


def wrong_rounded_half_turns(angle):
    """half revolutions"""
    return angle - np.pi * np.round(angle / np.pi)
