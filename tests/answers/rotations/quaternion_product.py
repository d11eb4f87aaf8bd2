"""What students write for quaternion_product(p, q)."""

import numpy as np


def right_scalar_and_vector(p, q):
    scalar = p[0] * q[0] - p[1:] @ q[1:]
    return np.array([scalar, *(p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:]))])


def right_entry_by_entry(p, q):
    a, b, c, d = p
    w, x, y, z = q
    return [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]


def right_matrix_of_the_first(p, q):
    w, x, y, z = p
    return np.array([[w, -x, -y, -z], [x, w, -z, y], [y, z, w, -x], [z, -y, x, w]]) @ q.reshape(4, 1)


def right_complex_pairs(p, q):
    (a, b), (c, d) = ((complex(r[0], r[1]), complex(r[2], r[3])) for r in (p, q))
    first, second = a * c - b * d.conjugate(), a * d + b * c.conjugate()
    return first.real, first.imag, second.real, second.imag


def wrong_one_sign(p, q):
    """one term of the cross product"""
    a, b, c, d = p
    w, x, y, z = q
    return [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z + d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]


def wrong_cross_product_the_other_way(p, q):
    """p and q are swapped"""
    return np.array([p[0] * q[0] - p[1:] @ q[1:], *(p[0] * q[1:] + q[0] * p[1:] + np.cross(q[1:], p[1:]))])


def wrong_no_cross_product(p, q):
    """the cross product is missing"""
    return np.array([p[0] * q[0] - p[1:] @ q[1:], *(p[0] * q[1:] + q[0] * p[1:])])


def wrong_plus_dot(p, q):
    """the dot product has the wrong sign"""
    return np.array([p[0] * q[0] + p[1:] @ q[1:], *(p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:]))])


def wrong_elementwise_in_the_scalar(p, q):
    """another form"""
    return np.array([*(p[0] * q[0] - p[1:] * q[1:]), *(p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:]))])


def wrong_nested(p, q):
    """ValueError"""
    return np.array([p[0] * q[0] - p[1:] @ q[1:], p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:])])


def wrong_normalised_scalar_last(p, q):
    """(x, y, z, w)"""
    w = p[0] * q[0] - p[1:] @ q[1:]
    return np.array([*(p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:])), w])


def wrong_tuple_added(p, q):
    """unnamed"""
    return (p[0] * q[0] - p[1:] @ q[1:]) + np.array([0, *(p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:]))])


def wrong_result_normalised(p, q):
    """the product is divided by its length"""
    r = right_scalar_and_vector(p, q)
    return r / np.linalg.norm(r)
