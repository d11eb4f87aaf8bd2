"""The four steps that a row of DH parameters stands for, put together rightly and wrongly.

Functions of (a, alpha, d, theta). A convention is one of them: `modified` or `standard`.
"""

import functools

import numpy as np

from course_lib.rigid import transform


def about_x(alpha, a=0.0):
    c, s = np.cos(alpha), np.sin(alpha)
    return np.array([[1, 0, 0, a], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]])


def about_z(theta, d=0.0):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])


def along_x(a):
    return about_x(0.0, a)


def along_z(d):
    return about_z(0.0, d)


def modified(a, alpha, d, theta):
    """Craig's convention: first along and about x, then along and about z."""
    return about_x(alpha, a) @ about_z(theta, d)


def standard(a, alpha, d, theta):
    """The standard convention: first along and about z, then along and about x."""
    return about_z(theta, d) @ about_x(alpha, a)


def joined(order, join=np.matmul):
    """A prediction: the four steps in this order, X a Z d for Rot_x, Trans_x, Rot_z, Trans_z; join: their product."""

    def answer(a, alpha, d, theta):
        steps = {"X": about_x(alpha), "a": along_x(a), "Z": about_z(theta), "d": along_z(d)}
        return functools.reduce(join, [steps[name] for name in order])

    return answer


def halves(convention, join):
    """A prediction: the half along x and the half along z, put together otherwise than by their product."""

    def answer(a, alpha, d, theta):
        halves = convention(a, alpha, 0, 0), convention(0, 0, d, theta)
        return join(*(halves if convention is modified else halves[::-1]))

    return answer


def with_other_sign(convention, i, j):
    """A prediction: the right matrix, but for the sign of one entry."""

    def answer(*row):
        T = convention(*row)
        T[i, j] *= -1
        return T

    return answer


def placed(convention, place):
    """A prediction: the right turn, and the origin at place(a, alpha, d, theta)."""
    return lambda *row: transform(convention(*row)[:3, :3], place(*row))


def with_another_turn(convention, turn):
    """A prediction: the right origin, turned by turn(alpha, theta)."""
    return lambda a, alpha, d, theta: transform(turn(alpha, theta), convention(a, alpha, d, theta)[:3, 3])


def with_sines_for_cosines(convention):
    """A prediction: sine and cosine swapped in both turns."""

    def answer(a, alpha, d, theta):
        X, Z = about_x(alpha, a), about_z(theta, d)
        X[1:3, 1:3] = [[np.sin(alpha), -np.cos(alpha)], [np.cos(alpha), np.sin(alpha)]]
        Z[:2, :2] = [[np.sin(theta), -np.cos(theta)], [np.cos(theta), np.sin(theta)]]
        return X @ Z if convention is modified else Z @ X

    return answer
