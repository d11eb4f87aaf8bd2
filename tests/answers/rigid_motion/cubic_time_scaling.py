"""What students write for cubic_time_scaling(t, T, s0, s1, v0, v1)."""

import numpy as np
from scipy.interpolate import CubicHermiteSpline

from course_lib import planar


def right_textbook(t, T, s0, s1, v0, v1):
    u = t / T
    way = s1 - s0
    return s0 + v0 * T * u + (3 * way - (2 * v0 + v1) * T) * u**2 + (-2 * way + (v0 + v1) * T) * u**3


def right_coefficients_of_t(t, T, s0, s1, v0, v1):
    a2 = 3 * (s1 - s0) / T**2 - (2 * v0 + v1) / T
    a3 = -2 * (s1 - s0) / T**3 + (v0 + v1) / T**2
    return np.polyval([a3, a2, v0, s0], t)


def right_four_equations(t, T, s0, s1, v0, v1):
    A = np.array([[1, 0, 0, 0], [1, T, T**2, T**3], [0, 1, 0, 0], [0, 1, 2 * T, 3 * T**2]])
    a = np.linalg.solve(A, [s0, s1, v0, v1])
    return a[0] + t * (a[1] + t * (a[2] + t * a[3]))


def right_hermite(t, T, s0, s1, v0, v1):
    u = np.asarray(t) / T
    h00, h10 = (1 + 2 * u) * (1 - u) ** 2, u * (1 - u) ** 2
    h01, h11 = u**2 * (3 - 2 * u), u**2 * (u - 1)
    return h00 * s0 + h10 * T * v0 + h01 * s1 + h11 * T * v1


def right_bezier_one_by_one(t, T, s0, s1, v0, v1):
    points = [s0, s0 + v0 * T / 3, s1 - v1 * T / 3, s1]

    def value(time):
        row = points
        while len(row) > 1:
            row = [a + time / T * (b - a) for a, b in zip(row, row[1:], strict=False)]
        return row[0]

    return value(t) if np.ndim(t) == 0 else [value(time) for time in t]


def right_filled_in(t, T, s0, s1, v0, v1):
    times = np.atleast_1d(t)
    s = np.empty(len(times))
    for k, time in enumerate(times):
        s[k] = right_textbook(time, T, s0, s1, v0, v1)
    return s


def right_spline_of_scipy(t, T, s0, s1, v0, v1):
    return CubicHermiteSpline([0, T], [s0, s1], [v0, v1])(t)


def wrong_linear(t, T, s0, s1, v0, v1):
    """s is linear in time"""
    return s0 + (s1 - s0) * t / T


def wrong_rest_to_rest(t, T, s0, s1, v0, v1):
    """the velocities at the ends are left out"""
    u = t / T
    return s0 + (s1 - s0) * (3 * u**2 - 2 * u**3)


def wrong_velocities_of_u(t, T, s0, s1, v0, v1):
    """not multiplied by T"""
    u = t / T
    way = s1 - s0
    return s0 + v0 * u + (3 * way - 2 * v0 - v1) * u**2 + (-2 * way + v0 + v1) * u**3


def wrong_velocities_divided(t, T, s0, s1, v0, v1):
    """divided by T"""
    return right_textbook(t, T, s0, s1, v0 / T**2, v1 / T**2)


def wrong_no_T(t, T, s0, s1, v0, v1):
    """T is left out"""
    way = s1 - s0
    return s0 + v0 * t + (3 * way - 2 * v0 - v1) * t**2 + (-2 * way + v0 + v1) * t**3


def wrong_no_T_at_rest(t, T, s0, s1, v0, v1):
    """T is left out"""
    return s0 + (s1 - s0) * (3 * t**2 - 2 * t**3)


def wrong_velocities_swapped(t, T, s0, s1, v0, v1):
    """v0 and v1 are swapped"""
    return right_hermite(t, T, s0, s1, v1, v0)


def wrong_ends_swapped(t, T, s0, s1, v0, v1):
    """s0 and s1 are swapped"""
    return right_hermite(t, T, s1, s0, v0, v1)


def wrong_backwards(t, T, s0, s1, v0, v1):
    """backwards in time"""
    return right_hermite(T - t, T, s0, s1, v0, v1)


def wrong_quintic(t, T, s0, s1, v0, v1):
    """quintic"""
    u = t / T
    return s0 + (s1 - s0) * (10 * u**3 - 15 * u**4 + 6 * u**5)


def wrong_quintic_with_velocities(t, T, s0, s1, v0, v1):
    """quintic"""
    return planar.quintic_time_scaling(t, T, s0, s1, v0, v1)


def wrong_start_not_added(t, T, s0, s1, v0, v1):
    """s0 is not added"""
    return right_textbook(t, T, s0, s1, v0, v1) - s0


def wrong_goal_for_the_way(t, T, s0, s1, v0, v1):
    """s1 stands where s1 - s0 belongs"""
    u = t / T
    return s0 + v0 * T * u + (3 * s1 - (2 * v0 + v1) * T) * u**2 + (-2 * s1 + (v0 + v1) * T) * u**3


def wrong_from_zero_to_one(t, T, s0, s1, v0, v1):
    """s goes from 0 to 1"""
    return 3 * (t / T) ** 2 - 2 * (t / T) ** 3


def wrong_start_velocity_left_out(t, T, s0, s1, v0, v1):
    """v0 is left out"""
    return right_textbook(t, T, s0, s1, 0, v1)


def wrong_end_velocity_left_out(t, T, s0, s1, v0, v1):
    """v1 is left out"""
    u = t / T
    return s0 + v0 * t + (3 * (s1 - s0) - 2 * v0 * T) * u**2 + (2 * (s0 - s1) + v0 * T) * u**3


def wrong_sign_of_the_end_velocity(t, T, s0, s1, v0, v1):
    """a velocity has the opposite sign"""
    points = [s0, s0 + v0 * T / 3, s1 + v1 * T / 3, s1]
    u = t / T
    return (1 - u) ** 3 * points[0] + 3 * (1 - u) ** 2 * u * points[1] + 3 * (1 - u) * u**2 * points[2] + u**3 * s1


def wrong_sign_in_the_second(t, T, s0, s1, v0, v1):
    """wrong sign"""
    u = t / T
    way = s1 - s0
    return s0 + v0 * T * u + (3 * way - (2 * v0 - v1) * T) * u**2 + (-2 * way + (v0 + v1) * T) * u**3


def wrong_sign_in_the_third(t, T, s0, s1, v0, v1):
    """wrong sign"""
    u = t / T
    way = s1 - s0
    return s0 + v0 * T * u + (3 * way - (2 * v0 + v1) * T) * u**2 + (2 * way + (v0 + v1) * T) * u**3


def wrong_two_with_the_other_velocity(t, T, s0, s1, v0, v1):
    """the 2 stands with v1"""
    u = t / T
    way = s1 - s0
    return s0 + v0 * T * u + (3 * way - (v0 + 2 * v1) * T) * u**2 + (-2 * way + (v0 + v1) * T) * u**3


def wrong_two_forgotten(t, T, s0, s1, v0, v1):
    """the 2 with v0 is forgotten"""
    u = t / T
    way = s1 - s0
    return s0 + v0 * T * u + (3 * way - (v0 + v1) * T) * u**2 + (-2 * way + (v0 + v1) * T) * u**3


def wrong_first_term_forgotten(t, T, s0, s1, v0, v1):
    """the term v0 t is forgotten"""
    return right_textbook(t, T, s0, s1, v0, v1) - v0 * t


def wrong_powers_swapped(t, T, s0, s1, v0, v1):
    """are swapped, or u^2 and u^3"""
    u = t / T
    way = s1 - s0
    return s0 + v0 * T * u + (3 * way - (2 * v0 + v1) * T) * u**3 + (-2 * way + (v0 + v1) * T) * u**2


def wrong_whole_numbers(t, T, s0, s1, v0, v1):
    """cut off to whole numbers"""
    if np.ndim(t) == 0:
        return right_textbook(t, T, s0, s1, v0, v1)
    s = np.zeros_like(t)
    for k in range(len(t)):
        s[k] = right_textbook(t[k], T, s0, s1, v0, v1)
    return s


def wrong_floor_division(t, T, s0, s1, v0, v1):
    """t // T"""
    return right_textbook((t // T) * T, T, s0, s1, v0, v1)


def wrong_even_times_of_its_own(t, T, s0, s1, v0, v1):
    """evenly spaced times from 0 to T are used"""
    return right_textbook(T * np.linspace(0, 1, np.size(t)) if np.ndim(t) else t, T, s0, s1, v0, v1)


def wrong_cosine(t, T, s0, s1, v0, v1):
    """unnamed"""
    return s0 + (s1 - s0) * (1 - np.cos(np.pi * t / T)) / 2


def wrong_one_value_for_an_array(t, T, s0, s1, v0, v1):
    """another form"""
    return right_textbook(np.max(t), T, s0, s1, v0, v1)


def wrong_changed_in_place(t, T, s0, s1, v0, v1):
    """t is changed in place"""
    if np.ndim(t) and t.dtype == float:
        t /= T
        return right_textbook(t, 1.0, s0, s1, v0 * T, v1 * T)
    return right_textbook(t, T, s0, s1, v0, v1)


def wrong_the_librarys(t, T, s0, s1, v0, v1):
    """course_lib.planar.cubic_time_scaling is called"""
    return planar.cubic_time_scaling(t, T, s0, s1, v0, v1)


def wrong_power_of_T(t, T, s0, s1, v0, v1):
    """a power of T is missing"""
    t = np.asarray(t)
    second, third = 2 * T * v0 + T * v1 + 3 * s0 - 3 * s1, T * v0 + T * v1 + 2 * s0 - 2 * s1
    return s0 + v0 * t - second / T**2 * t**2 + third / T**2 * t**3


def wrong_velocity_added_to_rest(t, T, s0, s1, v0, v1):
    """v0 t is added to the cubic from rest to rest"""
    u = np.asarray(t) / T
    return s0 + (s1 - s0) * (3 * u**2 - 2 * u**3) + v0 * t


def wrong_velocity_returned(t, T, s0, s1, v0, v1):
    """the velocity ds/dt is returned"""
    u = np.asarray(t) / T
    change = s1 - s0
    return v0 + 2 * (3 * change - (2 * v0 + v1) * T) / T * u + 3 * (-2 * change + (v0 + v1) * T) / T * u**2


def wrong_parentheses(t, T, s0, s1, v0, v1):
    """unnamed"""
    t = np.asarray(t)
    return s0 + v0 * t - 2 * T * v0 + T * v1 + 3 * s0 - 3 * s1 / T**2 * t**2


def wrong_loop_over_one_time(t, T, s0, s1, v0, v1):
    """'float' object is not iterable"""
    values = []
    for time in t:
        u, change = time / T, s1 - s0
        second, third = 3 * change - (2 * v0 + v1) * T, -2 * change + (v0 + v1) * T
        values.append(s0 + v0 * T * u + second * u**2 + third * u**3)
    return values


def wrong_float_of_the_times(t, T, s0, s1, v0, v1):
    """TypeError"""
    u, change = float(t) / T, s1 - s0
    second, third = 3 * change - (2 * v0 + v1) * T, -2 * change + (v0 + v1) * T
    return s0 + v0 * T * u + second * u**2 + third * u**3
