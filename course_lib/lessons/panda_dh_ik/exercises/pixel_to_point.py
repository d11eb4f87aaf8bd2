"""pixel_to_point: pixels with their depths, as points in the world, by the pinhole model and the
camera's pose."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.kinds import OWN_CASES, coarse_pose, some_equal, whole_numbers
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import SIZES, SMALL, Sweep
from course_lib.checks.vocabulary import any_pose, away_from_zero, first_off
from course_lib.lessons.panda_dh_ik.exercises.shared_points import moved
from course_lib.rigid import inverse, transform
from course_lib.rotations import exp_so3, rot_x

# With focal lengths that differ by less than one pixel, as those of a calibrated camera do.
_K_NEARLY_SQUARE = np.array([[615.3, 0, 321.1], [0, 615.7, 238.4], [0, 0, 1]])
_K = np.array([[580.0, 0, 311.5], [0, 610, 252], [0, 0, 1]])  # with two focal lengths


def _drawn(rng, n):
    pixels = np.round(rng.uniform([0, 0], [640, 480], (n, 2)), n % 2)
    return pixels, np.round(rng.uniform(0.3, 1.5, n), 3), _K, any_pose(rng)


def _cases(rng):
    simple = np.array([[600.0, 0, 320], [0, 600, 240], [0, 0, 1]])
    hangs = transform(rot_x(np.pi), [0.3, 0.1, 1.4])
    three = np.array([[320.0, 240], [380, 240], [320, 180]])
    few = [(three[:1], np.array([0.8])), (three, np.array([0.8, 0.8, 0.5]))]
    named = [(*points, simple, T_wc) for T_wc in (np.eye(4), hangs) for points in few]
    pixels, _, K, T_wc = _drawn(rng, 3)
    distant = pixels, np.round(rng.uniform(200, 900, 3)), K, T_wc
    whole = three, np.array([1.0, 2, 1]), K, T_wc
    nearly_square = pixels, np.array([0.7, 0.6, 0.9]), _K_NEARLY_SQUARE, T_wc
    return [*named, _drawn(rng, 4), distant, whole, nearly_square, _drawn(rng, 5)]


def _on_the_axis(rng, size):
    """Return a pixel near (c_x, c_y) = 0, and a camera close to the world's origin."""
    K = _K * np.eye(3)
    T_wc = transform(rot_x(size), [size, -2 * size, 3 * size])
    return np.array([[580 * size, -610 * size]]), np.array([0.7]), K, T_wc


def _nearly_down(rng, gap):
    """Return pixels of a camera that hangs above the table, and looks nearly straight down."""
    pixels, depths, K, _ = _drawn(rng, 2)
    R = rot_x(np.pi) @ exp_so3(gap * away_from_zero(rng, 3))
    return pixels, depths, K, transform(R, [0.3, 0.1, 1.4])


def _special(rng):
    """Pixels and depths in whole numbers, some of them equal, and a camera on a coarse grid."""
    n = int(rng.integers(1, 5))
    pixels = np.array([320.0, 240]) + 60 * whole_numbers(rng, (n, 2))
    return some_equal(rng, pixels), rng.integers(1, 4, n).astype(float), _K, coarse_pose(rng)


def _rays(pixels, K):
    """Return the points at depth 1, (n, 3)."""
    ones = np.ones((len(pixels), 1))
    return np.hstack([pixels, ones]) @ np.linalg.inv(K).T


def _in_the_camera(pixels, depths, K, T_wc):
    return depths[:, None] * _rays(pixels, K)


def _right(pixels, depths, K, T_wc):
    return moved(T_wc, _in_the_camera(pixels, depths, K, T_wc))


def _along_the_ray(pixels, depths, K, T_wc):
    rays = _rays(pixels, K)
    return moved(T_wc, depths[:, None] * rays / np.linalg.norm(rays, axis=1, keepdims=True))


EXERCISE = declared(
    "pixel_to_point",
    points=2,
    arguments=dict.fromkeys(("pixels", "depths", "K", "T_wc"), OWN_CASES.but(free=True)),
    cases=_cases,
    library=_right,
    says="T_wc takes each point to the world from the camera's frame, where its z is its depth, "
    "u = f_x x / z + c_x and v = f_y y / z + c_y",
    found=lambda points, *case: first_off(points.T, _right(*case).T, "The {} point"),
    otherwise=Question(
        "a pixel, a depth, or a number in K or T_wc is not used as it is given",
        "Compute this point in two steps: in the camera's frame from u, v and z, then "
        "in the world. At which step does your code differ?",
    ),
    sweeps=(
        Sweep("the number of pixels", _drawn, (*SIZES, 300)),
        Sweep("nearly on the camera's axis", _on_the_axis, SMALL),
        Sweep("a camera that looks nearly straight down", _nearly_down, SMALL),
    ),
    special=_special,
    hints=(
        "In two steps: the point in the camera's frame first, then the same point in the world's.",
        "In the camera's frame z is the depth. Solve u = f_x x / z + c_x for x, and the same for "
        "y.",
        "p_c = depth * inv(K) @ (u, v, 1), and p_w = R_wc p_c + p_wc.",
    ),
    mistakes=(
        Mistake(
            "the points have a fourth entry 1",
            "The task asks for three coordinates for each point.",
            form=lambda array, pixels, *rest: array.shape == (len(pixels), 4),
        ),
        Mistake(
            "the points are not moved by T_wc",
            "Take the point in the camera's frame for the first pixel below. Where does T_wc take "
            "it?",
            _in_the_camera,
        ),
        Mistake(
            "T_wc is inverted",
            "T_wc is the camera's pose in the world. From which frame to which frame does it take "
            "coordinates?",
            lambda pixels, depths, K, T_wc: _right(pixels, depths, K, inverse(T_wc)),
        ),
        Mistake(
            "the points are rotated by the transpose of R_wc",
            "The points are rows. What is R p, if p is written as a row?",
            lambda *case: _in_the_camera(*case) @ case[3][:3, :3] + case[3][:3, 3],
        ),
        Mistake(
            "the depth is used as the distance along the ray",
            "Along which axis of the camera is the depth measured?",
            _along_the_ray,
        ),
    ),
)
