"""What students write for quaternion_product(p, q)."""

import numpy as np


def right_scalar_and_vector(p, q):
    scalar = p[0] * q[0] - p[1:] @ q[1:]
    return np.array([scalar, *(p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:]))])


def right_matrix_of_the_first(p, q):
    w, x, y, z = p
    return np.array([[w, -x, -y, -z], [x, w, -z, y], [y, z, w, -x], [z, -y, x, w]]) @ q.reshape(4, 1)


def right_complex_pairs(p, q):
    (a, b), (c, d) = ((complex(r[0], r[1]), complex(r[2], r[3])) for r in (p, q))
    first, second = a * c - b * d.conjugate(), a * d + b * c.conjugate()
    return first.real, first.imag, second.real, second.imag


def wrong_tuple_added(p, q):
    """unnamed"""
    return (p[0] * q[0] - p[1:] @ q[1:]) + np.array([0, *(p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:]))])
