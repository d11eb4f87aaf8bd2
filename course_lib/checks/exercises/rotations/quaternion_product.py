"""quaternion_product: one rotation after another, by quaternions."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.exercises.rotations.shared import hamilton_product
from course_lib.rotations import quaternion_to_matrix, random_quaternions


def _cases(rng):
    half = np.sqrt(0.5)
    about_x, about_z, none = [half, half, 0, 0], [half, 0, 0, half], [1.0, 0, 0, 0]
    named = [(about_z, about_x), (about_x, about_z), (about_x, none), (none, about_z)]
    named += [([0.0, 1, 0, 0], [0.0, 0, 1, 0]), ([0.0, 0, 0, 1], [0.0, 0, 0, 1])]
    drawn = random_quaternions(8, rng).reshape(4, 2, 4)
    return [(np.array(p), np.array(q)) for p, q in [*named, *drawn, ([0.0, 1, 2, 3], drawn[0][0])]]


def _term(p, q, dot=-1, cross=1, first=1, second=1):
    """The product with other factors of its terms."""
    v = first * p[0] * q[1:] + second * q[0] * p[1:] + cross * np.cross(p[1:], q[1:])
    return np.array([p[0] * q[0] + dot * (p[1:] @ q[1:]), *v])


EXERCISE = Exercise(
    name="quaternion_product",
    points=1,
    arguments=("p", "q"),
    cases=_cases,
    returns=numbers(lambda p, q: (4,)),
    library=hamilton_product,
    properties=(
        Property(
            "the length of the product is the product of the lengths",
            lambda pq, p, q: abs(np.linalg.norm(pq) - np.linalg.norm(p) * np.linalg.norm(q)) < 1e-9,
            says=lambda pq, p, q: (
                f"|p| |q| is {np.linalg.norm(p) * np.linalg.norm(q):.4g}; yours {np.linalg.norm(pq):.4g}."
            ),
        ),
        Property(
            "the matrix of p q is the product of the two matrices",
            lambda pq, p, q: np.allclose(
                quaternion_to_matrix(pq), quaternion_to_matrix(p) @ quaternion_to_matrix(q), atol=1e-9
            ),
            where=lambda p, q: abs(np.linalg.norm(p) - 1) < 1e-9,
        ),
        Property(
            "p q = (w1 w2 - v1 . v2, w1 v2 + w2 v1 + v1 x v2)",
            lambda pq, p, q: np.allclose(pq, hamilton_product(p, q), atol=1e-9),
        ),
    ),
    hints=(
        "Split p into w1 = p[0] and v1 = p[1:], and q likewise.",
        "The scalar has two terms, the vector part three. np.cross is the cross product.",
        "np.array([w, *v]) puts the scalar w1 w2 - v1 . v2 before the vector w1 v2 + w2 v1 + v1 x v2.",
    ),
)


@EXERCISE.mistake
def factors_swapped(p, q):
    """p and q are swapped. v1 x v2 is not v2 x v1: whose vector comes first?"""
    return hamilton_product(q, p)


@EXERCISE.mistake(dot=(1, 0))
def dot_wrong(p, q, dot):
    """the dot product is missing, or has the wrong sign. What is i i?"""
    return _term(p, q, dot=dot)


@EXERCISE.mistake
def own_scalar(p, q):
    """each vector part meets its own scalar. w1 multiplies v2, and w2 multiplies v1."""
    return np.array([p[0] * q[0] - p[1:] @ q[1:], *(p[0] * p[1:] + q[0] * q[1:] + np.cross(p[1:], q[1:]))])


@EXERCISE.mistake(whole=(True, False))
def scalar_last(p, q, whole):
    """the entries are taken as (x, y, z, w). Here a quaternion is (w, x, y, z), with the scalar first."""
    return np.roll(hamilton_product(np.roll(p, 1), np.roll(q, 1)) if whole else hamilton_product(p, q), -1)


@EXERCISE.mistake
def normalised(p, q):
    """the product is divided by its length. Quaternions of any length can be multiplied."""
    return hamilton_product(p, q) / np.linalg.norm(hamilton_product(p, q))
