"""What students write for dh_symbolic(a, alpha, d, theta)."""

import math

import sympy as sp


def right_entry_by_entry(a, alpha, d, theta):
    c, s, ca, sa = sp.cos(theta), sp.sin(theta), sp.cos(alpha), sp.sin(alpha)
    return sp.Matrix(
        [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]]
    )


def right_blocks(a, alpha, d, theta):
    R = sp.rot_ccw_axis3(theta) @ sp.rot_ccw_axis1(alpha)
    p = sp.rot_ccw_axis3(theta) @ sp.Matrix([a, 0, d])
    return R.row_join(p).col_join(sp.Matrix([[0, 0, 0, 1]])).as_immutable()


def right_own_symbols_replaced_in_lists(a, alpha, d, theta):
    A, B, D, T = sp.symbols("a alpha d theta")
    formula = right_entry_by_entry(A, B, D, T).tolist()
    values = {A: a, B: alpha, D: d, T: theta}
    return [[sp.expand(entry).subs(values, simultaneous=True) for entry in row] for row in formula]


def wrong_math(a, alpha, d, theta):
    """Cannot convert expression to float"""
    return right_entry_by_entry(a, alpha, d, theta) * math.cos(theta)


def wrong_branch(a, alpha, d, theta):
    """cannot determine truth value"""
    return right_entry_by_entry(a, 0 if abs(alpha) < 1e-9 else alpha, d, theta)


def wrong_symbol_for_the_joint(a, alpha, d, theta):
    """a symbol that is no argument"""
    return right_entry_by_entry(a, alpha, d, sp.Symbol("theta"))


def wrong_simple_fractions(a, alpha, d, theta):
    """the numbers in the matrix are rounded, or replaced by simple fractions"""
    a, d = (sp.nsimplify(x, rational=True, tolerance=0.005) for x in (a, d))
    return right_entry_by_entry(a, alpha, d, theta)


def _without_small_numbers(matrix, threshold):
    return matrix.applyfunc(lambda x: 0 if x.is_number and abs(x) < threshold else x)


def wrong_small_cosines(a, alpha, d, theta):
    """the numbers in the matrix are rounded, or replaced by simple fractions"""
    return _without_small_numbers(right_entry_by_entry(a, alpha, d, theta), 1e-6)


def wrong_numbers_up_to_rounding(a, alpha, d, theta):
    """the numbers in the matrix are rounded, or replaced by simple fractions"""
    return _without_small_numbers(right_entry_by_entry(a, alpha, d, theta), 5e-9)


def wrong_nsimplify(a, alpha, d, theta):
    """the numbers in the matrix are rounded, or replaced by simple fractions"""
    numbers = (sp.nsimplify(x, rational=True, tolerance=1e-6) for x in (a, alpha, d, theta))
    return right_entry_by_entry(*numbers)


def right_exact_fractions(a, alpha, d, theta):
    return right_entry_by_entry(*(sp.nsimplify(x, rational=True) for x in (a, alpha, d, theta)))
