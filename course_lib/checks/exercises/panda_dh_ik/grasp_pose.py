"""grasp_pose: the gripper's pose in the world, for a grasp that is known on the template."""

import numpy as np

from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.panda_dh_ik.shared_points import (
    IS_A_POSE,
    TRIANGLE,
    close,
    difference,
    exactly,
    moved,
    noisy,
    read_pose,
    reflecting,
    registered,
)
from course_lib.checks.vocabulary import SAME_TWICE, any_pose, near, pose
from course_lib.rigid import transform
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
    four = np.ones(4)
    drawn = [exactly(rng, four), exactly(rng, four), exactly(rng, np.ones(3)), noisy(rng, four, 0.1)]
    drawn += [noisy(rng, np.ones(15), 0.1), reflecting(rng, four)]
    src, dst, _ = drawn[0]
    drawn += [(src + 50, dst - 80, four)]
    grasps = [any_pose(rng) for _ in drawn]
    everywhere = (moved(grasps[0], src), dst, grasps[0] @ grasps[1])
    return [*named, *((a, b, grasp) for (a, b, _), grasp in zip(drawn, grasps, strict=True)), everywhere, named[0]]


def _mug(template, scene):
    """Return the pose of the mug in the world."""
    return registered(template, scene, np.ones(len(template)))


def right(template, scene, T_grasp):
    """Return the right answer."""
    return _mug(template, scene) @ T_grasp


def _off(T, *case):
    return difference(T, right(*case))


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
            _off,
            where=lambda template, scene, T_grasp: np.array_equal(template, scene),
        ),
        Property(
            "the gripper's pose relative to the mug is T_grasp, wherever the mug is",
            lambda T, *case: close(T, right(*case)),
            _off,
        ),
    ),
    hints=(
        "The same mug, seen twice: which pose takes the template's points to those of the scene? You have a function "
        "for it.",
        "T_world_mug = register_points(template, scene, np.ones(len(template))): the mug's pose in the world.",
        "T_grasp is the gripper in the mug's frame: T_world_mug @ T_grasp is the gripper in the world.",
    ),
    library=right,
    errors=(
        (
            "ValueError",
            "core dimension",
            Mistake("the mug is taken to have a fixed number of points", "How many points are in `template`?"),
        ),
    ),
)


@EXERCISE.mistake
def wrong_order(template, scene, T_grasp):
    """the product is in the wrong order. In T_world_mug T_mug_gripper the inner letters meet: do they in yours?"""
    return T_grasp @ _mug(template, scene)


def _parts(template, scene, T_grasp):
    T = _mug(template, scene)
    return T[:3, :3], T[:3, 3], T_grasp[:3, :3], T_grasp[:3, 3]


@EXERCISE.mistake(
    of=(
        lambda R, p, R_g, p_g: p + p_g,
        lambda R, p, R_g, p_g: p,
        lambda R, p, R_g, p_g: p_g,
        lambda R, p, R_g, p_g: R @ p_g,
    )
)
def part_of_the_position(*case, of):
    """the gripper's orientation is right, and its position is not. Along whose axes is that of T_grasp?"""
    R, p, R_g, p_g = _parts(*case)
    return pose(R @ R_g, of(R, p, R_g, p_g))


@EXERCISE.mistake(
    shift=(lambda template, scene: scene.mean(0) - template.mean(0), lambda template, scene: scene[0] - template[0])
)
def mug_translated(template, scene, T_grasp, shift):
    """the mug is only translated, and its rotation is left out. May it be rotated in the scene?"""
    return pose(T_grasp[:3, :3], T_grasp[:3, 3] + shift(template, scene))
