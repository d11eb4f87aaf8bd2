"""What students write for gyroscope(R_0, log, dt, R_bi)."""

import numpy as np
import scipy.linalg

from course_lib.rotations import exp_so3, hat


def right_in_the_bodys_axes(R_0, log, dt, R_bi):
    orientations = [R_0]
    for omega in log:
        orientations.append(orientations[-1] @ exp_so3(R_bi @ omega * dt))
    return np.array(orientations)


def right_for_the_sensor_and_then_the_body(R_0, log, dt, R_bi):
    sensor = [np.array(R_0) @ R_bi]
    for omega in log:
        sensor.append(sensor[-1] @ scipy.linalg.expm(hat(omega) * dt))
    return [(R @ np.transpose(R_bi)).tolist() for R in sensor]


def right_in_fixed_axes(R_0, log, dt, R_bi):
    R = np.empty((len(log) + 1, 3, 3))
    R[0] = R_0
    for k in range(len(log)):
        omega_s = R[k] @ R_bi @ log[k]
        R[k + 1] = exp_so3(dt * omega_s) @ R[k]
    return R


def wrong_last_only(R_0, log, dt, R_bi):
    """only the last item is returned"""
    for omega in log:
        R_0 = R_0 @ exp_so3(R_bi @ omega * dt)
    return R_0


def wrong_rates_in_an_array_of_integers(R_0, log, dt, R_bi):
    """the answer is wrong for arrays of integers only"""
    body_rates = np.zeros_like(log)
    for k, rate in enumerate(log):
        body_rates[k] = R_bi @ rate
    return right_in_the_bodys_axes(R_0, body_rates, dt, np.eye(3))


def wrong_orientations_of_the_type_of_the_first(R_0, log, dt, R_bi):
    """digits after the point are cut off"""
    orientations = np.empty((len(log) + 1, 3, 3), dtype=R_0.dtype)
    orientations[:] = right_in_the_bodys_axes(R_0, log, dt, R_bi)
    return orientations


def wrong_orientations_of_the_common_type(R_0, log, dt, R_bi):
    """digits after the point are cut off"""
    orientations = np.empty((len(log) + 1, 3, 3), dtype=np.result_type(R_0, log))
    orientations[:] = right_in_the_bodys_axes(R_0, log, dt, R_bi)
    return orientations


def wrong_second_order_for_slow_samples(R_0, log, dt, R_bi):
    """the answer is right to its first digits only"""
    orientations = [R_0]
    for omega in log:
        step = hat(R_bi @ omega * dt)
        is_slow = np.abs(step).max() < 1e-3
        factor = np.eye(3) + step + step @ step / 2 if is_slow else scipy.linalg.expm(step)
        orientations.append(orientations[-1] @ factor)
    return np.array(orientations)


def wrong_fixed_axes_and_transposed_mounting(R_0, log, dt, R_bi):
    """each step is made about the fixed axes"""
    R = [R_0]
    for omega in log:
        R.append(exp_so3(R_bi.T @ omega * dt) @ R[-1])
    return np.array(R)


def wrong_entries_of_the_rotation_vector_wrapped(R_0, log, dt, R_bi):
    """the answers to some inputs only are wrong"""
    R = [R_0]
    for omega in log:
        R.append(R[-1] @ exp_so3((R_bi @ omega * dt + np.pi) % (2 * np.pi) - np.pi))
    return np.array(R)
