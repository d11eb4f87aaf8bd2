"""pixel_to_point: pixels with their depths, as points in the world, by the pinhole model and the
camera's pose."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.special_cases import SIZES, SMALL, Sweep
from course_lib.checks.vocabulary import any_pose, first_off, near
from course_lib.lessons.panda_dh_ik.exercises.shared_points import moved
from course_lib.rigid import inverse, transform
from course_lib.rotations import rot_x

_NOT_MOVED = Mistake(
    "the points are not moved by T_wc",
    "Take the point in the camera's frame for the first pixel below. Where does T_wc take it?",
)
_ONES = Mistake(
    "the points have a fourth entry 1", "The task asks for three coordinates for each point."
)


def _rays(pixels, K):
    """Return the points at depth 1, (n, 3)."""
    ones = np.ones((len(pixels), 1))
    return np.hstack([pixels, ones]) @ np.linalg.inv(K).T


def right(pixels, depths, K, T_wc):
    """Return the right answer."""
    return moved(T_wc, depths[:, None] * _rays(pixels, K))


def _cases(rng):
    simple = [[600.0, 0, 320], [0, 600, 240], [0, 0, 1]]
    hangs = transform(rot_x(np.pi), [0.3, 0.1, 1.4])
    three = np.array([[320.0, 240], [380, 240], [320, 180]])
    cases = [(three[:1], np.array([0.8])), (three, np.array([0.8, 0.8, 0.5]))]
    cases = [(*case, np.array(simple), T) for T in (np.eye(4), hangs) for case in cases]
    pixels, _, K, T_wc = _drawn(rng, 3)
    distant = pixels, np.round(rng.uniform(20, 90, 3), 1), K, T_wc
    return [*cases, _drawn(rng, 4), distant, _drawn(rng, 5)]


def _drawn(rng, n):
    """Return n pixels of a camera with two focal lengths."""
    K = np.array([[580.0, 0, 311.5], [0, 610, 252], [0, 0, 1]])
    pixels = np.round(rng.uniform([0, 0], [640, 480], (n, 2)), n % 2)
    return pixels, np.round(rng.uniform(0.3, 1.5, n), 3), K, any_pose(rng)


def _on_the_axis(rng, size):
    """Return a pixel near (c_x, c_y) = 0, and a camera close to the world's origin."""
    K = np.array([[580.0, 0, 0], [0, 610, 0], [0, 0, 1]])
    T_wc = transform(rot_x(size), [size, -2 * size, 3 * size])
    return np.array([[580 * size, -610 * size]]), np.array([0.7]), K, T_wc


def _right(points, *case):
    return near(points, right(*case))


def _off(points, *case):
    return first_off(points.T, right(*case).T, "The {} point")


EXERCISE = Exercise(
    name="pixel_to_point",
    points=2,
    arguments=("pixels", "depths", "K", "T_wc"),
    cases=_cases,
    returns=numbers(
        lambda pixels, *rest: (len(pixels), 3),
    ),
    properties=(
        Property(
            "with T_wc = I, which moves nothing, each point has its depth as z and is seen at its "
            "pixel",
            _right,
            _off,
            where=lambda pixels, depths, K, T_wc: np.array_equal(T_wc, np.eye(4)),
            mistake=Mistake(
                "the point in the camera's frame is wrong",
                "Solve u = f_x x / z + c_x for x, and v = f_y y / z + c_y for y.",
            ),
        ),
        Property(
            "the points are seen from the world: T_wc takes them there from the camera's frame",
            _right,
            _off,
            where=lambda pixels, depths, K, T_wc: K[0, 0] == K[1, 1],
            mistake=_NOT_MOVED,
        ),
        Property(
            "u = f_x x / z + c_x and v = f_y y / z + c_y in the camera's frame, with the numbers "
            "in this K",
            _right,
            _off,
            mistake=Mistake(
                "a number in K, a pixel or a depth is not used as it is given",
                "Which entries of K does your code use, and does it change a pixel or a depth "
                "first?",
            ),
        ),
    ),
    hints=(
        "In two steps: the point in the camera's frame first, then the same point in the world's.",
        (
            "In the camera's frame z is the depth. Solve u = f_x x / z + c_x for x, and the same"
            " for y."
        ),
        "p_c = depth * inv(K) @ (u, v, 1), and p_w = R_wc p_c + p_wc.",
    ),
    library=right,
    sweeps=(
        Sweep("the number of pixels", _drawn, SIZES),
        Sweep("nearly on the camera's axis", _on_the_axis, SMALL),
    ),
)

EXERCISE.mistake(_ONES, form=lambda array, pixels, *rest: array.shape == (len(pixels), 4))


@EXERCISE.mistake(
    "T_wc is inverted",
    "T_wc is the camera's pose in the world. From which frame to which frame does it take "
    "coordinates?",
)
def inverted(pixels, depths, K, T_wc):
    return right(pixels, depths, K, inverse(T_wc))


@EXERCISE.mistake(
    "the points are rotated by the transpose of R_wc",
    "The points are rows. What is R p, if p is written as a row?",
)
def transposed(pixels, depths, K, T_wc):
    return right(pixels, depths, K, np.eye(4)) @ T_wc[:3, :3] + T_wc[:3, 3]


@EXERCISE.mistake(
    "the depth is used as the distance along the ray",
    "Along which axis of the camera is the depth measured?",
)
def along_the_ray(pixels, depths, K, T_wc):
    rays = _rays(pixels, K)
    return moved(T_wc, depths[:, None] * rays / np.linalg.norm(rays, axis=1, keepdims=True))
