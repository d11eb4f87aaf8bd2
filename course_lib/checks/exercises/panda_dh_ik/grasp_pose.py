"""grasp_pose: the gripper's pose in the world, for a grasp that is known on the template."""

import numpy as np

from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.panda_dh_ik.shared_points import (
    IS_A_POSE,
    TRIANGLE,
    close,
    compared,
    exactly,
    moved,
    noisy,
    read_pose,
    reflecting,
    registered,
)
from course_lib.checks.vocabulary import (
    SAME_TWICE,
    any_pose,
    entry_by_entry,
    few_digits,
    inverted,
    near,
    pose,
    remembered,
    transposed,
)
from course_lib.rigid import inverse, transform
from course_lib.rotations import rot_x, rot_z

_ABOVE = transform(rot_x(np.pi), [0.0, 0, 0.5])  # a gripper that points down at the mug


def _cases(rng):
    moved_mug = transform(rot_z(np.pi / 2), [1.0, 2, 3])
    named = [
        (TRIANGLE, moved(moved_mug, TRIANGLE), _ABOVE),
        (TRIANGLE, TRIANGLE, _ABOVE),
        (TRIANGLE, TRIANGLE + np.array([1, 2, 3]), _ABOVE),
        (TRIANGLE, moved(moved_mug, TRIANGLE), np.eye(4)),
    ]
    alike = np.ones(4)
    drawn = [exactly(rng, alike), exactly(rng, alike), exactly(rng, np.ones(3)), noisy(rng, alike, 0.1)]
    drawn += [noisy(rng, np.ones(15), 0.1), reflecting(rng, alike)]
    src, dst, _ = drawn[0]
    drawn += [(src + 50, dst - 80, alike)]
    grasps = [any_pose(rng) for _ in drawn]
    everywhere = (moved(grasps[0], src), dst, grasps[0] @ grasps[1])
    return [*named, *((a, b, grasp) for (a, b, _), grasp in zip(drawn, grasps, strict=True)), everywhere, named[0]]


@remembered
def mug(template, scene):
    """The pose of the mug in the world."""
    return registered(template, scene, np.ones(len(template)))


def _right(template, scene, T_grasp):
    return mug(template, scene) @ T_grasp


def _rigid(template, scene, T_grasp):
    return np.abs(moved(mug(template, scene), template) - scene).max() < 1e-10 * (1 + np.abs(scene).max())


def _distances(T, points):
    return np.linalg.norm(points - T[:3, 3], axis=1)


def _distance(T, template, scene, T_grasp):
    yours, wanted = _distances(T, scene), _distances(T_grasp, template)
    i = int(np.argmax(np.abs(yours - wanted)))
    return (
        f"From the gripper at {format_tuple(T_grasp[:3, 3])} to template[{i}] it is {wanted[i]:.4g}; "
        f"from yours at {format_tuple(T[:3, 3])} to scene[{i}] it is {yours[i]:.4g}."
    )


def _off(T, *case):
    right = _right(*case)
    if not close(T[:3, 3], right[:3, 3]):
        return compared("The gripper's position", T[:3, 3], right[:3, 3])
    i = int(np.argmax(np.abs(T - right).max(0)))
    return "The position of your gripper is right. " + compared(
        f"Its {'xyz'[i]} axis, column {i},", T[:3, i], right[:3, i]
    )


def _of(formula):
    """A prediction: formula(R, p, R_g, p_g), the block and the column of the mug's pose and of T_grasp."""

    def answer(template, scene, T_grasp):
        T = mug(template, scene)
        return formula(T[:3, :3], T[:3, 3], T_grasp[:3, :3], T_grasp[:3, 3])

    return answer


def _by(registration):
    """A prediction: another registration(template, scene) of the mug."""
    return lambda template, scene, T_grasp: registration(template, scene) @ T_grasp


def _shift(template, scene):
    return scene.mean(0) - template.mean(0)


def _transposed(template, scene):
    R = mug(template, scene)[:3, :3].T
    return pose(R, scene.mean(0) - R @ template.mean(0))


_ORDER = "T_world_mug T_mug_gripper: the inner letters meet."
_WHOLE = "A pose holds both: a product of poses rotates and moves the gripper at once."

EXERCISE = Exercise(
    name="grasp_pose",
    points=1,
    arguments=("template", "scene", "T_grasp"),
    cases=_cases,
    returns=read_pose,
    properties=(
        SAME_TWICE,
        *IS_A_POSE,
        Property(
            "if the mug lies as on the template, the gripper's pose is T_grasp",
            lambda T, template, scene, T_grasp: near(T, T_grasp),
            says=_off,
            where=lambda template, scene, T_grasp: np.array_equal(template, scene),
        ),
        Property(
            "the gripper is as far from each point of the mug in the scene as it is on the template",
            lambda T, template, scene, T_grasp: near(_distances(T, scene), _distances(T_grasp, template)),
            says=_distance,
            where=_rigid,
        ),
        Property(
            "the gripper's pose relative to the mug is T_grasp, wherever the mug is",
            lambda T, *case: close(T, _right(*case)),
            says=_off,
        ),
    ),
    mistakes=(
        few_digits(_right),
        Mistake(
            "only the pose of the mug is returned",
            "The gripper is not at the mug's origin: T_grasp is its pose there.",
            lambda template, scene, T_grasp: mug(template, scene),
        ),
        Mistake(
            "T_grasp is returned as it is",
            "It is the gripper seen from the mug, and the mug has moved.",
            lambda template, scene, T_grasp: T_grasp,
        ),
        Mistake(
            "the product is in the wrong order", _ORDER, lambda template, scene, T_grasp: T_grasp @ mug(template, scene)
        ),
        Mistake(
            "the scene is registered to the template, not the template to the scene",
            "T_world_mug takes points of the mug's frame to the world.",
            _by(lambda template, scene: mug(scene, template)),
            lambda template, scene, T_grasp: T_grasp @ mug(scene, template),
        ),
        Mistake(
            "T_grasp is inverted",
            "T_grasp already is the gripper's pose in the mug's frame.",
            lambda template, scene, T_grasp: mug(template, scene) @ inverse(T_grasp),
            lambda template, scene, T_grasp: inverse(T_grasp) @ mug(template, scene),
        ),
        inverted(
            _right, "the inverse of the answer is returned", "The task asks for the gripper in the world. " + _ORDER
        ),
        Mistake(
            "the gripper is moved with the mug, but not rotated",
            _WHOLE,
            _of(lambda R, p, R_g, p_g: pose(R_g, R @ p_g + p)),
            _of(lambda R, p, R_g, p_g: pose(R_g, p)),
            _of(lambda R, p, R_g, p_g: pose(R_g, p + p_g)),
        ),
        Mistake(
            "the gripper is rotated, but its position is only added to the mug's",
            "p_g is known along the mug's axes, which the mug's rotation rotates too.",
            _of(lambda R, p, R_g, p_g: pose(R @ R_g, p + p_g)),
            _of(lambda R, p, R_g, p_g: pose(R_g @ R, p + p_g)),
        ),
        Mistake(
            "the gripper's orientation is right, and its position that of the mug or of T_grasp",
            _WHOLE,
            _of(lambda R, p, R_g, p_g: pose(R @ R_g, p)),
            _of(lambda R, p, R_g, p_g: pose(R @ R_g, p_g)),
            _of(lambda R, p, R_g, p_g: pose(R @ R_g, R @ p_g)),
        ),
        Mistake(
            "the gripper has the mug's orientation: that of T_grasp is lost",
            _WHOLE,
            _of(lambda R, p, R_g, p_g: pose(R, R @ p_g + p)),
            _of(lambda R, p, R_g, p_g: pose(R, p + p_g)),
        ),
        Mistake(
            "the two rotations are multiplied in the wrong order",
            _ORDER,
            _of(lambda R, p, R_g, p_g: pose(R_g @ R, R @ p_g + p)),
        ),
        Mistake(
            "the mug is only translated, and its rotation is left out",
            "The mug may be rotated in the scene: the whole registration is needed.",
            lambda template, scene, T_grasp: pose(T_grasp[:3, :3], T_grasp[:3, 3] + _shift(template, scene)),
            lambda template, scene, T_grasp: pose(T_grasp[:3, :3], T_grasp[:3, 3] + scene[0] - template[0]),
            lambda template, scene, T_grasp: pose(T_grasp[:3, :3], scene.mean(0) + T_grasp[:3, 3]),
        ),
        Mistake(
            "the mug's rotation is transposed",
            "R takes the template's directions to those of the scene.",
            _of(lambda R, p, R_g, p_g: pose(R.T @ R_g, R.T @ p_g + p)),
            lambda template, scene, T_grasp: _transposed(template, scene) @ T_grasp,
        ),
        entry_by_entry(lambda template, scene, T_grasp: mug(template, scene) * T_grasp),
        Mistake(
            "the two poses are added",
            "One pose after another is a product.",
            lambda template, scene, T_grasp: mug(template, scene) + T_grasp,
        ),
        transposed(_right, "the answer is transposed", "p is the last column of T."),
        Mistake(
            "only three of the points are used",
            "The more points, the less their noise matters.",
            _by(lambda template, scene: mug(template[:3], scene[:3])),
        ),
    ),
    hints=(
        "The same mug, seen twice: which pose takes the template's points to those of the scene? You have a function "
        "for it.",
        "T_world_mug = register_points(template, scene, np.ones(len(template))): the mug's pose in the world.",
        "T_grasp is the gripper in the mug's frame: T_world_mug @ T_grasp is the gripper in the world.",
    ),
    library=_right,
    errors=(
        (
            "ValueError",
            "core dimension",
            Mistake("the mug is taken to have a fixed number of points", "Any number may come: len(template)."),
        ),
    ),
)
