"""What students write for dh_symbolic(a, alpha, d, theta)."""

import math

import numpy as np
import sympy as sp


def right_product_of_four(a, alpha, d, theta):
    Rz = sp.Matrix(
        [
            [sp.cos(theta), -sp.sin(theta), 0, 0],
            [sp.sin(theta), sp.cos(theta), 0, 0],
            [0, 0, 1, 0],
            [0, 0, 0, 1],
        ]
    )
    Tz = sp.Matrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])
    Tx = sp.Matrix([[1, 0, 0, a], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    Rx = sp.Matrix(
        [
            [1, 0, 0, 0],
            [0, sp.cos(alpha), -sp.sin(alpha), 0],
            [0, sp.sin(alpha), sp.cos(alpha), 0],
            [0, 0, 0, 1],
        ]
    )
    return Rz * Tz * Tx * Rx


def right_entry_by_entry(a, alpha, d, theta):
    c, s, ca, sa = sp.cos(theta), sp.sin(theta), sp.cos(alpha), sp.sin(alpha)
    return sp.Matrix([[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]])


def right_lists_simplified(a, alpha, d, theta):
    c, s, ca, sa = map(sp.simplify, (sp.cos(theta), sp.sin(theta), sp.cos(alpha), sp.sin(alpha)))
    return [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1.0]]


def right_blocks(a, alpha, d, theta):
    R = sp.rot_ccw_axis3(theta) @ sp.rot_ccw_axis1(alpha)
    p = sp.rot_ccw_axis3(theta) @ sp.Matrix([a, 0, d])
    return R.row_join(p).col_join(sp.Matrix([[0, 0, 0, 1]])).as_immutable()


def right_own_symbols_replaced(a, alpha, d, theta):
    A, B, D, T = sp.symbols("a alpha d theta")
    formula = right_entry_by_entry(A, B, D, T)
    return formula.subs({A: a, B: alpha, D: d, T: theta}, simultaneous=True)


def right_numpy_holds_the_expressions(a, alpha, d, theta):
    first = np.eye(4, dtype=object)
    first[:2, :2] = [[sp.cos(theta), -sp.sin(theta)], [sp.sin(theta), sp.cos(theta)]]
    first[2, 3] = d
    second = np.eye(4, dtype=object)
    second[1:3, 1:3] = [[sp.cos(alpha), -sp.sin(alpha)], [sp.sin(alpha), sp.cos(alpha)]]
    second[0, 3] = a
    return first @ second


def right_complex_exponentials(a, alpha, d, theta):
    c, s = (sp.exp(sp.I * theta) + sp.exp(-sp.I * theta)) / 2, (sp.exp(sp.I * theta) - sp.exp(-sp.I * theta)) / 2 / sp.I
    ca, sa = sp.cos(alpha), sp.sin(alpha)
    return sp.Matrix([[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]])


def _rz(t):
    return sp.Matrix([[sp.cos(t), -sp.sin(t), 0, 0], [sp.sin(t), sp.cos(t), 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])


def _rx(t):
    return sp.Matrix([[1, 0, 0, 0], [0, sp.cos(t), -sp.sin(t), 0], [0, sp.sin(t), sp.cos(t), 0], [0, 0, 0, 1]])


def _move(x, z):
    return sp.Matrix([[1, 0, 0, x], [0, 1, 0, 0], [0, 0, 1, z], [0, 0, 0, 1]])


def wrong_modified(a, alpha, d, theta):
    """the modified convention"""
    return _rx(alpha) * _move(a, 0) * _rz(theta) * _move(0, d)


def wrong_order_reversed(a, alpha, d, theta):
    """the modified convention"""
    return _move(a, 0) * _rx(alpha) * _move(0, d) * _rz(theta)


def wrong_sine_sign_of_theta(a, alpha, d, theta):
    """the rotation by theta has the wrong sense"""
    return _rz(-theta) * _move(a, d) * _rx(alpha)


def wrong_sine_sign_of_alpha(a, alpha, d, theta):
    """the rotation by alpha has the wrong sense"""
    return _rz(theta) * _move(a, d) * _rx(-alpha)


def wrong_sympys_rot_axis(a, alpha, d, theta):
    """both rotations have the wrong sense"""
    T = sp.eye(4)
    T[:3, :3] = sp.rot_axis3(theta) * sp.rot_axis1(alpha)
    T[:3, 3] = sp.rot_axis3(theta) * sp.Matrix([a, 0, d])
    return T


def wrong_one_sign(a, alpha, d, theta):
    """a sine or a cosine has the wrong sign"""
    T = right_entry_by_entry(a, alpha, d, theta)
    T[1, 2] = sp.cos(theta) * sp.sin(alpha)
    return T


def wrong_minus_forgotten(a, alpha, d, theta):
    """a sine or a cosine has the wrong sign"""
    T = right_entry_by_entry(a, alpha, d, theta)
    T[0, 1] = sp.sin(theta) * sp.cos(alpha)
    return T


def wrong_alpha_and_theta_swapped(a, alpha, d, theta):
    """alpha and theta are swapped"""
    return _rz(alpha) * _move(a, d) * _rx(theta)


def wrong_a_and_d_swapped(a, alpha, d, theta):
    """a and d are swapped"""
    return _rz(theta) * _move(d, a) * _rx(alpha)


def wrong_transposed(a, alpha, d, theta):
    """transposed"""
    return (_rz(theta) * _move(a, d) * _rx(alpha)).T


def wrong_entry_by_entry(a, alpha, d, theta):
    """entry by entry"""
    product = _rz(theta)
    for factor in (_move(0, d), _move(a, 0), _rx(alpha)):
        product = product.multiply_elementwise(factor)
    return product


def wrong_entry_by_entry_in_numpy(a, alpha, d, theta):
    """entry by entry"""
    return np.array(_rz(theta) * _move(0, d)) * np.array(_move(a, 0) * _rx(alpha))


def wrong_added(a, alpha, d, theta):
    """the matrices are added"""
    return _rz(theta) + _move(0, d) + _move(a, 0) + _rx(alpha)


def wrong_numpy(a, alpha, d, theta):
    """which has no callable cos method"""
    c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]])


def wrong_math(a, alpha, d, theta):
    """Cannot convert expression to float"""
    c, s, ca, sa = math.cos(theta), math.sin(theta), math.cos(alpha), math.sin(alpha)
    return sp.Matrix([[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]])


def wrong_array_of_floats(a, alpha, d, theta):
    """Cannot convert expression to float"""
    T = np.eye(4)
    T[:, :] = right_entry_by_entry(a, alpha, d, theta)
    return T


def wrong_branch(a, alpha, d, theta):
    """cannot determine truth value"""
    if abs(alpha) < 1e-9:
        return _rz(theta) * _move(a, d)
    return right_entry_by_entry(a, alpha, d, theta)


def wrong_rounded(a, alpha, d, theta):
    """entries are rounded"""
    return right_entry_by_entry(a, alpha, d, theta).evalf(3)


def wrong_short_number_for_pi(a, alpha, d, theta):
    """entries are rounded"""
    ca, sa = sp.sin(alpha + 1.5708), sp.sin(alpha)
    c, s = sp.cos(theta), sp.sin(theta)
    return sp.Matrix([[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]])


def wrong_symbols_of_its_own(a, alpha, d, theta):
    """a symbol made elsewhere"""
    a, alpha, d, theta = sp.symbols("a alpha d theta", real=True)
    return right_entry_by_entry(a, alpha, d, theta)


def wrong_symbol_for_the_joint(a, alpha, d, theta):
    """a symbol made elsewhere"""
    return right_entry_by_entry(a, alpha, d, sp.Symbol("theta"))


def wrong_degrees(a, alpha, d, theta):
    """degrees"""
    return _rz(sp.rad(theta)) * _move(a, d) * _rx(sp.rad(alpha))


def wrong_sine_and_cosine(a, alpha, d, theta):
    """sine and cosine are swapped"""
    c, s, ca, sa = sp.sin(theta), sp.cos(theta), sp.sin(alpha), sp.cos(alpha)
    return sp.Matrix([[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]])


def wrong_way_not_turned(a, alpha, d, theta):
    """the translation a is not rotated"""
    return _move(a, 0) * _rz(theta) * _move(0, d) * _rx(alpha)


def wrong_alpha_first(a, alpha, d, theta):
    """Rot_x(alpha) stands before Rot_z(theta)"""
    return _rx(alpha) * _rz(theta) * _move(a, d)


def wrong_d_last(a, alpha, d, theta):
    """the translation d is rotated by alpha"""
    return _rz(theta) * _move(a, 0) * _rx(alpha) * _move(0, d)


def wrong_about_y(a, alpha, d, theta):
    """alpha rotates about y"""
    Ry = sp.Matrix(
        [
            [sp.cos(alpha), 0, sp.sin(alpha), 0],
            [0, 1, 0, 0],
            [-sp.sin(alpha), 0, sp.cos(alpha), 0],
            [0, 0, 0, 1],
        ]
    )
    return _rz(theta) * _move(a, d) * Ry


def wrong_rotation_only(a, alpha, d, theta):
    """the rotation alone"""
    return (_rz(theta) * _rx(alpha))[:3, :3]


def wrong_last_row_missing(a, alpha, d, theta):
    """the last row is missing"""
    return right_entry_by_entry(a, alpha, d, theta)[:3, :]


def wrong_without_d(a, alpha, d, theta):
    """d is left out"""
    return _rz(theta) * _move(a, 0) * _rx(alpha)


def wrong_without_alpha(a, alpha, d, theta):
    """alpha is left out"""
    return _rz(theta) * _move(a, d)


def wrong_one_entry(a, alpha, d, theta):
    """unnamed"""
    T = right_entry_by_entry(a, alpha, d, theta)
    T[1, 3] = a * sp.cos(theta)
    return T


def wrong_printed(a, alpha, d, theta):
    """a return is missing"""
    print(_rz(theta) * _move(a, d) * _rx(alpha))
