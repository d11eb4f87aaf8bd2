"""dh_symbolic: the matrix of one link by its Denavit-Hartenberg parameters, as a formula."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.rigid import transform
from course_lib.rotations import rot_x, rot_y, rot_z

_SHAPES = {
    (3, 3): Mistake("the rotation alone is returned", "The matrix is 4 x 4: the origin stands in its last column."),
    (3, 4): Mistake("the last row is missing", "Below stands 0, 0, 0, 1, so that such matrices can be multiplied."),
    (16,): Mistake("the matrix is flat", "Matrix(4, 4, [...]) makes four rows of sixteen entries."),
}
_NUMPY_USED = Mistake(
    "numpy's or math's function is used on symbols: take SymPy's",
    "import sympy as sp, then sp.cos(theta), sp.sin(theta), sp.Matrix([...]). They take numbers too.",
)
_ASKED_A_SYMBOL = Mistake(
    "an if or a comparison looks at the value of a symbol, which has none",
    "The matrix is one formula for all values: no case needs a branch of its own.",
)
_NUMBERS_NOT_TAKEN = Mistake(
    "the arguments are taken for symbols only",
    "The function is called with numbers too: sp.cos(alpha) takes both.",
)


def _cases(rng):
    """Whole numbers go in as they are, all others as symbols; see adapters.py."""
    whole = [(0, 0, 0, 0), (1, 0, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1), (0, 1, 0, 0)]
    some = [(1, 0, 0, 0.5), (0, np.pi / 2, 0, 0), (0.5, 0, 0, 0.5), (0.5, 0, 0.3, 2.0), (2, 1, 3, -2)]
    sizes = rng.uniform([0.2, 0.3, 1.0, 0.4], [0.8, 1.2, 1.9, 1.3], (3, 4))
    drawn = np.round(sizes * [(1, 1, 1, 1), (1, -1, 1, 1), (-1, 1, -1, -1)], 2)
    return whole + some + [tuple(float(number) for number in row) for row in [*drawn, [0.4, 2.5, -0.7, -2.0]]]


def _about_z(theta):
    return transform(rot_z(theta), np.zeros(3))


def _about_x(alpha):
    return transform(rot_x(alpha), np.zeros(3))


def _along_z(d):
    return transform(np.eye(3), [0, 0, d])


def _along_x(a):
    return transform(np.eye(3), [a, 0, 0])


def _right(a, alpha, d, theta):
    return transform(rot_z(theta), [0, 0, d]) @ transform(rot_x(alpha), [a, 0, 0])


def _x_axis(a, alpha, d, theta):
    return np.array([np.cos(theta), np.sin(theta), 0])


def _z_axis(a, alpha, d, theta):
    return np.array([np.sin(theta) * np.sin(alpha), -np.cos(theta) * np.sin(alpha), np.cos(alpha)])


def _y_axis(*case):
    return np.cross(_z_axis(*case), _x_axis(*case))


def _origin(a, alpha, d, theta):
    return np.array([a * np.cos(theta), a * np.sin(theta), d])


def _column(k, text, wanted):
    """The first three entries of column k are wanted(a, alpha, d, theta)."""
    return Property(
        text,
        lambda T, *case: np.allclose(T[:3, k], wanted(*case), rtol=0, atol=1e-9),
        says=lambda T, *case: (
            f"Here that is {format_tuple(np.round(wanted(*case), 9))}. Yours is {format_tuple(np.round(T[:3, k], 9))}."
        ),
    )


def _with_other_sign(i, j):
    """The right matrix, but for the sign of one entry."""

    def answer(*case):
        T = _right(*case)
        T[i, j] *= -1
        return T

    return answer


def _swapped(a, alpha, d, theta):
    """Sine and cosine swapped in both rotations."""
    c, s, ca, sa = np.sin(theta), np.cos(theta), np.sin(alpha), np.cos(alpha)
    return np.array([[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]])


def dh_symbolic(a, alpha, d, theta):
    """Return the standard DH matrix of one row, a SymPy Matrix."""
    import sympy

    def step(rotation, along):
        return sympy.Matrix(sympy.BlockMatrix([[rotation, along], [sympy.zeros(1, 3), sympy.ones(1, 1)]]))

    about_z = step(sympy.rot_ccw_axis3(theta), sympy.Matrix([0, 0, d]))
    return about_z * step(sympy.rot_ccw_axis1(alpha), sympy.Matrix([a, 0, 0]))


EXERCISE = Exercise(
    name="dh_symbolic",
    points=1,
    arguments=("a", "alpha", "d", "theta"),
    cases=_cases,
    through="symbols",
    returns=numbers(lambda *case: (4, 4), _SHAPES),
    properties=(
        Property(
            "the last row is 0, 0, 0, 1",
            lambda T, *case: np.allclose(T[3], [0, 0, 0, 1], rtol=0, atol=1e-9),
        ),
        _column(0, "the x axis, the first column, is rotated by theta about z: (cos theta, sin theta, 0)", _x_axis),
        _column(
            2,
            "the z axis, the third column, is rotated by alpha about x, then by theta about z: "
            "(sin theta sin alpha, -cos theta sin alpha, cos alpha)",
            _z_axis,
        ),
        _column(1, "the y axis, the second column, is the cross product of the z axis and the x axis", _y_axis),
        _column(3, "the origin, the last column, is (a cos theta, a sin theta, d)", _origin),
    ),
    mistakes=(
        Mistake(
            "the modified convention is taken, Rot_x(alpha) Trans_x(a) Rot_z(theta) Trans_z(d)",
            "The standard convention begins with the joint: Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha).",
            lambda a, alpha, d, theta: transform(rot_x(alpha), [a, 0, 0]) @ transform(rot_z(theta), [0, 0, d]),
        ),
        Mistake("the matrix is transposed", "The origin stands in the last column.", lambda *case: _right(*case).T),
        Mistake(
            "alpha and theta are swapped",
            "theta is the rotation about z, alpha about x; the order is a, alpha, d, theta.",
            lambda a, alpha, d, theta: _right(a, theta, d, alpha),
        ),
        Mistake(
            "a and d are swapped",
            "d is the translation along z, a that along x.",
            lambda a, alpha, d, theta: _right(d, alpha, a, theta),
        ),
        Mistake(
            "the rotation by theta has the wrong sense",
            "Rot_z has -sin theta in its first row.",
            lambda a, alpha, d, theta: _right(a, alpha, d, -theta),
        ),
        Mistake(
            "the rotation by alpha has the wrong sense",
            "Rot_x has -sin alpha in its second row.",
            lambda a, alpha, d, theta: _right(a, -alpha, d, theta),
        ),
        Mistake(
            "both rotations have the wrong sense",
            "The minus stands above the diagonal of Rot_z and Rot_x.",
            lambda a, alpha, d, theta: _right(a, -alpha, d, -theta),
        ),
        Mistake(
            "a sine or a cosine has the wrong sign",
            "Multiply the four matrices by SymPy and compare entry by entry.",
            *(_with_other_sign(i, j) for i, j in [(0, 1), (1, 0), (0, 2), (1, 2), (2, 1), (0, 3), (1, 3), (1, 1)]),
        ),
        Mistake(
            "matrices are multiplied entry by entry",
            "The product of SymPy's matrices is A * B or A @ B, not multiply_elementwise.",
            lambda a, alpha, d, theta: _about_z(theta) * _along_z(d) * _along_x(a) * _about_x(alpha),
            lambda a, alpha, d, theta: (_about_z(theta) @ _along_z(d)) * (_along_x(a) @ _about_x(alpha)),
            lambda a, alpha, d, theta: _about_z(theta) * _about_x(alpha),
        ),
        Mistake(
            "the matrices are added",
            "One motion after another is a product.",
            lambda a, alpha, d, theta: _about_z(theta) + _along_z(d) + _along_x(a) + _about_x(alpha),
        ),
        Mistake("sine and cosine are swapped", "At the angle 0 the cosine is 1: it stands on the diagonal.", _swapped),
        Mistake(
            "the angles are taken for degrees",
            "Angles are radians everywhere.",
            lambda a, alpha, d, theta: _right(a, np.deg2rad(alpha), d, np.deg2rad(theta)),
        ),
        Mistake(
            "alpha rotates about y",
            "Rot_x(alpha) leaves the x axis where it is.",
            lambda a, alpha, d, theta: _right(a, 0, d, theta) @ transform(rot_y(alpha), np.zeros(3)),
        ),
        Mistake(
            "the translation a is not rotated by theta",
            "Trans_x(a) comes after Rot_z(theta), so it goes along the new x.",
            lambda a, alpha, d, theta: _along_x(a) @ _right(0, alpha, d, theta),
        ),
        Mistake(
            "Rot_x(alpha) stands before Rot_z(theta)",
            "In Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha) it is the last.",
            lambda a, alpha, d, theta: _about_x(alpha) @ _right(a, 0, d, theta),
            lambda a, alpha, d, theta: transform(rot_x(alpha) @ rot_z(theta), _origin(a, alpha, d, theta)),
        ),
        Mistake(
            "the translation d is rotated by alpha",
            "Trans_z(d) comes before Rot_x(alpha): it goes along the old z.",
            lambda a, alpha, d, theta: _right(a, alpha, 0, theta) @ _along_z(d),
        ),
        Mistake("a is left out", "Trans_x(a) moves along x.", lambda a, *rest: _right(0, *rest)),
        Mistake("d is left out", "Trans_z(d) moves along z.", lambda a, alpha, d, theta: _right(a, alpha, 0, theta)),
        Mistake(
            "alpha is left out",
            "The last of the four is Rot_x(alpha).",
            lambda a, alpha, d, theta: _right(a, 0, d, theta),
        ),
        Mistake(
            "theta is left out",
            "The first of the four is Rot_z(theta).",
            lambda a, alpha, d, theta: _right(a, alpha, d, 0),
        ),
        Mistake(
            "entries are rounded, or a rounded number stands for pi",
            "Leave the formula exact: no round, no evalf, no numbers where symbols can stay.",
            seen=lambda T, *case: 1e-9 < np.abs(T - _right(*case)).max() < 0.006,
        ),
    ),
    library=dh_symbolic,
    hints=(
        "Make four SymPy matrices, each 4 x 4: Rot_z(theta), Trans_z(d), Trans_x(a), Rot_x(alpha).",
        "Rot_z(theta) = Matrix([[cos, -sin, 0, 0], [sin, cos, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]), with sp.cos(theta) "
        "and sp.sin(theta). Rot_x has the same four entries in its rows and columns of y and z.",
        "Multiply them in this order with * or @. Use the arguments as they come: symbols, or numbers.",
    ),
    errors=(
        ("TypeError", "Cannot convert expression to float", _NUMPY_USED),
        ("TypeError", "which has no callable", _NUMPY_USED),
        ("AttributeError", "'Dummy' object has no attribute", _NUMPY_USED),
        ("AttributeError", "'int' object has no attribute", _NUMBERS_NOT_TAKEN),
        ("TypeError", "cannot determine truth value of Relational", _ASKED_A_SYMBOL),
    ),
)
