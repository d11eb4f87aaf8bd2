"""grasp_pose: where the gripper has to be in the world to take a mug as it was taken before."""

import numpy as np

from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.panda_dh_ik.point_sets import TRIANGLE, exactly, laid, middle, moved, noisy, reflecting
from course_lib.checks.panda_dh_ik.registering import IS_A_POSE, close, compared, read_pose
from course_lib.checks.panda_dh_ik.wrong_fits import fit, in_four_columns, mirrored, of_linear, with_block
from course_lib.checks.poe_kuka_iiwa.chains import SAME_TWICE, few_digits, remembered, turned_hand
from course_lib.checks.poe_kuka_iiwa.matrices import near
from course_lib.checks.rotations.poses import pose
from course_lib.rigid import inverse, transform
from course_lib.rotations import nearest_so, rot_x, rot_z

_ABOVE = transform(rot_x(np.pi), [0.0, 0, 0.5])  # a gripper that looks down on the mug


def _cases(rng):
    turned = transform(rot_z(np.pi / 2), [1.0, 2, 3])
    alike = np.ones(4)
    named = [
        (TRIANGLE, TRIANGLE, _ABOVE),
        (TRIANGLE, TRIANGLE + np.array([1, 2, 3]), _ABOVE),
        (TRIANGLE, moved(turned, TRIANGLE), np.eye(4)),
        (TRIANGLE, moved(turned, TRIANGLE), _ABOVE),
    ]
    drawn = [*(exactly(rng, alike) for _ in range(3)), *(exactly(rng, np.ones(3)) for _ in range(3))]
    drawn += [noisy(rng, alike, 0.1), noisy(rng, np.ones(15), 0.1), reflecting(rng, alike)]
    src, dst, _ = drawn[0]
    drawn += [(src + 50, dst - 80, alike), (src, dst, alike)]
    hands = [turned_hand(rng) for _ in drawn]
    everywhere = (moved(hands[0], src), dst, hands[0] @ hands[1])
    return [*named, *((a, b, hand) for (a, b, _), hand in zip(drawn, hands, strict=True)), everywhere, named[3]]


@remembered
def mug(template, scene):
    """The pose of the mug in the world."""
    return laid(template, scene, np.ones(len(template)))


def _right(template, scene, T_grasp):
    return mug(template, scene) @ T_grasp


def _unmoved(template, scene, T_grasp):
    return np.array_equal(template, scene)


def _rigid(template, scene, T_grasp):
    return np.abs(moved(mug(template, scene), template) - scene).max() < 1e-10 * (1 + np.abs(scene).max())


def _distances(T, points):
    return np.linalg.norm(points - T[:3, 3], axis=1)


def _keeps_distances(T, template, scene, T_grasp):
    return near(_distances(T, scene), _distances(T_grasp, template))


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
        return compared("The gripper's place", T[:3, 3], right[:3, 3])
    i = int(np.argmax(np.abs(T - right).max(0)))
    return "Your gripper is where it should be. " + compared(
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


def _fitted_by(registration):
    return _by(lambda template, scene: registration(template, scene, np.ones(len(template))))


def _fitted(**parts):
    return _fitted_by(fit(**parts))


def _reflected(T, template, scene, T_grasp):
    case = template, scene, np.ones(len(template))
    return near(T, with_block(mirrored(*case), *case) @ T_grasp)


def _shift(template, scene):
    alike = np.ones(len(template))
    return middle(scene, alike) - middle(template, alike)


_ORDER = "T_world_mug @ T_mug_gripper: the inner letters meet. First to the mug's frame, then to the world."
_WHOLE = "A pose carries both: the product T_world_mug @ T_grasp turns and moves the gripper at once."

GRASP_POSE = Exercise(
    name="grasp_pose",
    points=1,
    arguments=("template", "scene", "T_grasp"),
    cases=_cases,
    returns=read_pose,
    properties=(
        SAME_TWICE,
        *IS_A_POSE,
        Property(
            "where the mug lies as on the template, the gripper's pose is T_grasp",
            lambda T, template, scene, T_grasp: near(T, T_grasp),
            seen=_off,
            where=_unmoved,
        ),
        Property(
            "the gripper is as far from each point of the mug in the scene as it is on the template",
            _keeps_distances,
            seen=_distance,
            where=_rigid,
        ),
        Property(
            "the gripper stands to the mug as T_grasp says, wherever the mug lies",
            lambda T, *case: close(T, _right(*case)),
            seen=_off,
        ),
    ),
    mistakes=(
        few_digits(_right),
        Mistake(
            "only the pose of the mug is returned",
            "The gripper is not at the mug's origin: T_world_mug @ T_grasp.",
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
            "the scene is laid on the template, not the template on the scene",
            "T_world_mug takes points of the mug's frame to the world: template first, scene second.",
            _by(lambda template, scene: mug(scene, template)),
            lambda template, scene, T_grasp: T_grasp @ mug(scene, template),
        ),
        Mistake(
            "T_grasp is inverted",
            "T_grasp already is the gripper's pose in the mug's frame: no inverse is needed.",
            lambda template, scene, T_grasp: mug(template, scene) @ inverse(T_grasp),
            lambda template, scene, T_grasp: inverse(T_grasp) @ mug(template, scene),
        ),
        Mistake(
            "the inverse of the answer is returned",
            "The gripper seen from the world is asked for: " + _ORDER,
            lambda *case: inverse(_right(*case)),
        ),
        Mistake(
            "the gripper is moved with the mug, but not turned",
            _WHOLE,
            _of(lambda R, p, R_g, p_g: pose(R_g, R @ p_g + p)),
            _of(lambda R, p, R_g, p_g: pose(R_g, p)),
            _of(lambda R, p, R_g, p_g: pose(R_g, p + p_g)),
        ),
        Mistake(
            "the gripper is turned, but its place is only added to the mug's",
            "p_g is known along the mug's axes, which have turned: R p_g + p.",
            _of(lambda R, p, R_g, p_g: pose(R @ R_g, p + p_g)),
            _of(lambda R, p, R_g, p_g: pose(R_g @ R, p + p_g)),
        ),
        Mistake(
            "the gripper is turned as the mug, but sits at the mug's origin",
            _WHOLE,
            _of(lambda R, p, R_g, p_g: pose(R @ R_g, p)),
        ),
        Mistake(
            "the gripper is turned as the mug, but its place stays that of T_grasp",
            _WHOLE,
            _of(lambda R, p, R_g, p_g: pose(R @ R_g, p_g)),
        ),
        Mistake(
            "the gripper's place is turned but not shifted",
            "R p_g + p: the mug's own place p is missing.",
            _of(lambda R, p, R_g, p_g: pose(R @ R_g, R @ p_g)),
        ),
        Mistake(
            "the gripper has the mug's turn, and its own in T_grasp is lost",
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
            "the mug is only shifted, from middle to middle, and its turn is left out",
            "The mug may be turned in the scene: the whole registration is needed, R and p.",
            lambda template, scene, T_grasp: pose(T_grasp[:3, :3], T_grasp[:3, 3] + _shift(template, scene)),
            lambda template, scene, T_grasp: pose(T_grasp[:3, :3], T_grasp[:3, 3] + scene[0] - template[0]),
        ),
        Mistake(
            "the middle of the scene's points stands for the mug's place",
            "The mug's frame need not sit in the middle of its points: p = c_scene - R c_template.",
            _fitted(place=lambda R, c, d: d),
            lambda template, scene, T_grasp: pose(T_grasp[:3, :3], scene.mean(0) + T_grasp[:3, 3]),
        ),
        Mistake(
            "the mug's place is the difference of the middles, without R",
            "p = c_scene - R c_template.",
            _fitted(place=lambda R, c, d: d - c),
        ),
        Mistake(
            "the middles are not taken off before R is computed",
            "Your register_points does it: use it here.",
            _fitted(centred=False),
        ),
        Mistake(
            "the mug's rotation is transposed",
            "R takes the template's directions to those of the scene.",
            _fitted(rotation=lambda H: nearest_so(H).T),
            _of(lambda R, p, R_g, p_g: pose(R.T @ R_g, R.T @ p_g + p)),
        ),
        Mistake(
            "the product is entry by entry",
            "In numpy the matrix product is @.",
            lambda template, scene, T_grasp: mug(template, scene) * T_grasp,
        ),
        Mistake(
            "the two poses are added up",
            "One pose after another is a product: @.",
            lambda template, scene, T_grasp: mug(template, scene) + T_grasp,
        ),
        Mistake(
            "the answer is transposed", "T = [[R, p], [0, 1]]: p is the last column.", lambda *case: _right(*case).T
        ),
        Mistake(
            "the mug may be stretched: any linear map is allowed, not rotations only",
            "np.linalg.lstsq stretches and shears the points. Your register_points looks for a rotation.",
            _fitted_by(of_linear(np.copy)),
            _fitted_by(in_four_columns),
        ),
        Mistake(
            "only three of the points are used",
            "The more points, the less their noise counts: take all of them.",
            _by(lambda template, scene: mug(template[:3], scene[:3])),
        ),
        Mistake(
            "the mug's pose is a reflection",
            "Where det(U V^T) = -1 one sign has to turn. Your register_points does it: use it here.",
            seen=_reflected,
        ),
    ),
    hints=(
        "The same mug, seen twice: which pose takes the template's points to those of the scene? You have a function "
        "for it.",
        "T_world_mug = register_points(template, scene, np.ones(len(template))): the mug's pose in the world.",
        "T_grasp is the gripper in the mug's frame: T_world_mug @ T_grasp is the gripper in the world.",
    ),
)
