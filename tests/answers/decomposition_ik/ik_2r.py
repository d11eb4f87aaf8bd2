"""What students write for ik_2r(xy)."""

import math

import numpy as np

from course_lib import ik
from course_lib.arms import planar_arm
from course_lib.rigid import transform
from course_lib.subproblems import subproblem1, subproblem3

OUT = np.full((2, 2), np.nan)


def right_law_of_cosines(xy):
    x, y = xy
    if np.hypot(x, y) > 2 + 1e-9:
        return np.full((2, 2), np.nan)
    bend = np.arccos(np.clip((x**2 + y**2 - 2) / 2, -1, 1))
    return np.array([[np.arctan2(y, x) - np.arctan2(np.sin(t), 1 + np.cos(t)), t] for t in (bend, -bend)])


def right_half_angles_in_lists(xy):
    r, towards = math.hypot(*xy), math.atan2(xy[1], xy[0])
    if r > 2.000001:
        return [[math.nan, math.nan], [math.nan, math.nan]]
    half = math.acos(min(r / 2, 1))
    return [[towards - half, 2 * half], [towards + half, -2 * half]]


def right_meeting_circles(xy):
    r = np.linalg.norm(xy)
    if r > 2 * (1 + 1e-12):
        return OUT
    along = xy / r if r > 0 else np.array([1.0, 0])
    height = np.sqrt(max(1 - r * r / 4, 0))
    answers = []
    for side in (-1, 1):
        elbow = r / 2 * along + side * height * np.array([-along[1], along[0]])
        rest = xy - elbow
        t1 = np.arctan2(elbow[1], elbow[0])
        answers.append((t1, np.arctan2(elbow[0] * rest[1] - elbow[1] * rest[0], elbow @ rest)))
    return answers


def right_whole_turns_up(xy):
    angles = right_law_of_cosines(xy)
    return np.where(angles < 0, angles + 2 * np.pi, angles)


def right_sine_by_root(xy):
    x, y = xy[0], xy[1]
    c = (x * x + y * y - 2) / 2
    if c > 1 + 1e-9:
        return np.array([[np.nan] * 2] * 2)
    s = np.sqrt(np.maximum(1 - c * c, 0))
    rows = []
    for sine in (s, -s):
        t2 = np.arctan2(sine, c)
        t1 = np.arctan2((1 + c) * y - sine * x, (1 + c) * x + sine * y)
        rows.append([t1, t2])
    return rows


def right_tangent_of_half(xy):
    r2 = xy @ xy
    if r2 > 4.0001:
        return np.full((2, 2), float("nan"))
    with np.errstate(divide="ignore"):
        bend = 2 * np.arctan(np.sqrt(np.maximum(4 - r2, 0) / r2))
    phi = np.angle(complex(*xy))
    return np.array([[phi - bend / 2, phi + bend / 2], [bend, -bend]]).T


def right_by_subproblems(xy):
    z, x, place = np.array([0, 0, 1.0]), np.array([1.0, 0, 0]), np.array([*xy, 0.0])
    if np.linalg.norm(xy) > 2 + 1e-6:
        return np.full((2, 2), np.nan)
    bends = subproblem3(z, x, -x, np.linalg.norm(xy)).theta
    bends = [max(bends), min(bends)] if abs(max(bends)) < 3.1415 else [np.pi, np.pi]
    return [[float(subproblem1(z, x + [np.cos(t), np.sin(t), 0], place).theta) if xy.any() else 0.3, t] for t in bends]


def _bend(xy):
    return np.arccos(np.clip((xy @ xy - 2) / 2, -1, 1))


def _far(xy):
    return np.linalg.norm(xy) > 2 + 1e-9


def wrong_only_one(xy):
    """only one solution is returned"""
    return right_law_of_cosines(xy)[0]


def wrong_one_twice(xy):
    """only one solution is returned, twice"""
    row = right_law_of_cosines(xy)[0]
    return np.array([row, row])


def wrong_order(xy):
    """in the other order"""
    return right_law_of_cosines(xy)[::-1]


def wrong_same_q1(xy):
    """q1 is the same for both"""
    angles = right_law_of_cosines(xy)
    angles[1, 0] = angles[0, 0]
    return angles


def wrong_correction_left_out(xy):
    """without the correction for the elbow"""
    if _far(xy):
        return OUT
    t = np.arctan2(xy[1], xy[0])
    return np.array([[t, _bend(xy)], [t, -_bend(xy)]])


def wrong_sign_of_correction(xy):
    """the elbow correction of q1 has the wrong sign"""
    if _far(xy):
        return OUT
    return [[np.arctan2(xy[1], xy[0]) + t / 2, t] for t in (_bend(xy), -_bend(xy))]


def wrong_atan(xy):
    """atan of y / x"""
    if _far(xy):
        return OUT
    return [[np.arctan(xy[1] / xy[0]) - t / 2 if xy[0] else t / -2, t] for t in (_bend(xy), -_bend(xy))]


def wrong_math_atan(xy):
    """ZeroDivisionError"""
    if _far(xy):
        return OUT
    return [[math.atan(float(xy[1]) / float(xy[0])) - t / 2, t] for t in (_bend(xy), -_bend(xy))]


def wrong_atan_unguarded(xy):
    """atan of y / x"""
    if _far(xy):
        return OUT
    return [[np.arctan(xy[1] / xy[0]) - t / 2, t] for t in (_bend(xy), -_bend(xy))]


def wrong_atan2_swapped(xy):
    """x and y are swapped in atan2"""
    if _far(xy):
        return OUT
    return [[np.arctan2(xy[0], xy[1]) - t / 2, t] for t in (_bend(xy), -_bend(xy))]


def wrong_atan2_of_correction_swapped(xy):
    """swapped in the elbow correction"""
    if _far(xy):
        return OUT
    return [[np.arctan2(xy[1], xy[0]) - np.arctan2(1 + np.cos(t), np.sin(t)), t] for t in (_bend(xy), -_bend(xy))]


def wrong_whole_correction(xy):
    """not half of it"""
    if _far(xy):
        return OUT
    return [[np.arctan2(xy[1], xy[0]) - t, t] for t in (_bend(xy), -_bend(xy))]


def wrong_degrees(xy):
    """in degrees"""
    return np.rad2deg(right_law_of_cosines(xy))


def wrong_not_clipped(xy):
    """positions at the edge"""
    if _far(xy):
        return OUT
    bend = np.arccos((xy @ xy - 2) / 2)
    return [[np.arctan2(xy[1], xy[0]) - t / 2, t] for t in (bend, -bend)]


def wrong_rim_out_of_reach(xy):
    """positions at the edge"""
    return OUT if np.hypot(*xy) > 2 else right_law_of_cosines(xy)


def wrong_math_acos(xy):
    """ValueError"""
    bend = math.acos((xy[0] ** 2 + xy[1] ** 2 - 2) / 2)
    return [[math.atan2(xy[1], xy[0]) - t / 2, t] for t in (bend, -bend)]


def wrong_clipped_out_of_reach(xy):
    """clipping hides"""
    return [[np.arctan2(xy[1], xy[0]) - t / 2, t] for t in (_bend(xy), -_bend(xy))]


def wrong_half_nan(xy):
    """only some of the numbers are NaN"""
    with np.errstate(all="ignore"):
        bend = np.arccos((xy @ xy - 2) / 2) if _far(xy) else _bend(xy)
    direction = np.arctan2(xy[1], xy[0])
    return [[direction - (0 if _far(xy) else t / 2), t] for t in (bend, -bend)]


def wrong_empty_list(xy):
    """a position out of reach is given another form"""
    return [] if _far(xy) else right_law_of_cosines(xy)


def wrong_one_row_of_nan(xy):
    """a position out of reach is given another form"""
    return np.array([np.nan, np.nan]) if _far(xy) else right_law_of_cosines(xy)


def wrong_zeros_out_of_reach(xy):
    """a position out of reach is answered"""
    return np.zeros((2, 2)) if _far(xy) else right_law_of_cosines(xy)


def wrong_law_of_cosines(xy):
    """the law of cosines has the wrong sign"""
    if _far(xy):
        return OUT
    bend = np.arccos(np.clip((2 - xy @ xy) / 2, -1, 1))
    return [[np.arctan2(xy[1], xy[0]) - np.arctan2(np.sin(t), 1 + np.cos(t)), t] for t in (bend, -bend)]


def wrong_angle_inside(xy):
    """the angle inside the elbow is taken"""
    if _far(xy):
        return OUT
    angles = np.array(right_law_of_cosines(xy))
    angles[:, 1] = [np.pi - angles[0, 1], -np.pi - angles[1, 1]]
    return angles


def wrong_half_missing(xy):
    """the cosine of q2 is not"""
    if _far(xy):
        return OUT
    bend = np.arccos(np.clip(xy @ xy - 2, -1, 1))
    return [[np.arctan2(xy[1], xy[0]) - t / 2, t] for t in (bend, -bend)]


def wrong_root_for_square(xy):
    """the cosine of q2 is not"""
    if _far(xy):
        return OUT
    bend = np.arccos(np.clip((np.linalg.norm(xy) - 2) / 2, -1, 1))
    return [[np.arctan2(xy[1], xy[0]) - t / 2, t] for t in (bend, -bend)]


def wrong_columns(xy):
    """have changed positions"""
    return np.array(right_law_of_cosines(xy))[:, ::-1]


def wrong_transposed(xy):
    """the answer is transposed"""
    return np.array(right_law_of_cosines(xy)).T


def wrong_second_from_x_axis(xy):
    """q2 is counted from the x axis"""
    return np.cumsum(right_law_of_cosines(xy), axis=1)


def wrong_sorted(xy):
    """unnamed"""
    return np.sort(right_law_of_cosines(xy), axis=1)


def wrong_positive_both(xy):
    """unnamed"""
    return np.abs(right_law_of_cosines(xy))


def wrong_divided_in_place(xy):
    """xy is changed in place"""
    r = np.linalg.norm(xy)
    if r > 2 + 1e-9:
        return OUT
    xy /= max(r, 1e-300)
    half = np.arccos(min(r / 2, 1))
    return [[np.arctan2(xy[1], xy[0]) - half, 2 * half], [np.arctan2(xy[1], xy[0]) + half, -2 * half]]


def wrong_the_librarys(xy):
    """course_lib.arms.planar_arm is called"""
    target = transform(np.eye(3), [*xy, 0.0])
    found = ik.solve(planar_arm([1.0, 1.0]), target, np.random.default_rng(0))
    return found.q if found.success else OUT


def wrong_sign_and_atan(xy):
    """has the wrong sign, and atan of y / x"""
    x, y = xy
    cosine = (x**2 + y**2 - 2) / 2
    if cosine > 1 + 1e-12:
        return np.full((2, 2), np.nan)
    q2 = np.arccos(np.clip(cosine, -1, 1))
    direction = np.arctan(np.divide(y, x))
    return np.array([[direction + q2 / 2, q2], [direction - q2 / 2, -q2]])


def wrong_atan2_and_sign(xy):
    """q2 is right, and q1 is not"""
    x, y = xy
    cosine = (x**2 + y**2 - 2) / 2
    if cosine > 1 + 1e-12:
        return np.full((2, 2), np.nan)
    q2 = np.arccos(np.clip(cosine, -1, 1))
    return np.array([[np.arctan2(x, y) + q2 / 2, q2], [np.arctan2(x, y) - q2 / 2, -q2]])
