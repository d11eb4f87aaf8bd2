"""One of each toy, for tests."""

import numpy as np

from course_lib import figures, rigid, rotations
from course_lib.arms import iiwa14, planar_arm, ur5e
from course_lib.ik import damped_path
from course_lib.lessons.decomposition_ik import figures as nb6
from course_lib.lessons.decomposition_ik.toys import cells_toy, table
from course_lib.lessons.panda_dh_ik import figures as nb5
from course_lib.lessons.panda_dh_ik.toys import click, panda_toy
from course_lib.lessons.poe_kuka_iiwa import figures as nb4
from course_lib.lessons.poe_kuka_iiwa.toys import build_up_toy, iiwa_toy
from course_lib.lessons.rigid_motion.figures import wheels
from course_lib.lessons.rigid_motion.toys import drive, two_poses_toy
from course_lib.lessons.rotations.toys import fly, orientation_toy
from course_lib.lessons.subproblems_damped_ik import figures as nb3
from course_lib.lessons.subproblems_damped_ik.exercises.six_axis_arm import ARM, all_solutions
from course_lib.lessons.subproblems_damped_ik.toys import circles_toy, planar_arm_toy

# A round trip of a vacuum cleaner: ((vx, vy, omega), seconds), in m/s and rad/s.
ROUND = (
    ((0.5, 0, 0), 4),
    ((0.3, 0, 0.9), 3.5),
    ((0.5, 0, 0), 3),
    ((0.3, 0, -0.9), 2),
    ((0.4, 0, 0.45), 7),
)
Q6, Q7 = [0.3, -1.2, 1.5, -1.8, -1.5, 0.2], [0.3, 0.5, -0.4, -1.1, 0.2, 0.9, 0.1]
READY = [0, -np.pi / 4, 0, -3 * np.pi / 4, 0, np.pi / 2, np.pi / 4]
AT = ARM.fk([0.3, 0.4, -0.5, 0.6, 0.7, -0.8])
MODES = ("axis", "gimbals", "order", "velocity", "belt")
PLAIN = (iiwa_toy, two_poses_toy, circles_toy, planar_arm_toy, cells_toy)
T_WM = rigid.transform(
    rotations.rot_z(0.7), [0.3, -0.05, 0.6]
)  # a mug, and two cameras that see it
T_WC = rigid.transform(
    rotations.rot_x(np.pi) @ rotations.rot_z(0.3) @ rotations.rot_y(-0.45), [0.6, -0.1, 1.2]
)
T_MC = rigid.transform(rotations.rot_z(0.4) @ rotations.rot_x(-2.0), [0.2, -0.41, 0.256])
VIEWS = np.array([[1300, 0, 320], [0, 1300, 240], [0, 0, 1]]), T_MC, T_WC, T_WM


def velocities():
    """A film of the end-effector of the iiwa beside charts of its velocity."""
    t = np.linspace(0, 2, 21)
    poses = iiwa14().fk(np.outer(t, Q7))
    v = np.gradient(poses[:, :3, 3], t, axis=0)
    return nb4.velocities_over_time(t, {"space": 2 * v, "hybrid": v}, poses)


def errors_of_arm():
    """Thirty queries with two answers each, one of which is missing."""
    rng = np.random.default_rng(5)
    angles = rng.uniform([0.1, 0.3], [1.4, 1.5], (30, 2))
    queries = planar_arm([1, 1]).fk(angles)[:, :2, 3]
    answers = angles[:, None] + rng.normal(0, [[[0.01], [0.1]]], (30, 2, 2))
    tips = planar_arm([1, 1]).fk(answers)[..., :2, 3]
    errors = 100 * np.linalg.norm(tips - queries[:, None], axis=-1)
    answers[3, 1] = errors[3, 1] = np.nan
    return nb6.errors_of_arm(queries, answers, errors, range(30), "Click a dot.")


def step_map():
    """The map of step size and damping, coarser than that of the notebook."""
    q, target = np.array([0, 0, 0, np.pi / 2]), np.array([-1.8663, 1.1207])
    alphas, epsilons = np.geomspace(0.01, 10, 7), np.geomspace(0.01, 100, 5)
    paths = damped_path(planar_arm([1] * 4), target, q, alphas[:, None], epsilons, 30)
    tips = planar_arm([1] * 4).fk(paths[:, :, -1])[..., :2, 3]
    errors = np.linalg.norm(tips - target, axis=-1)
    errors[-1, 0] = np.nan  # as of a run that rounding decides
    return nb3.step_map(alphas, epsilons, errors, 3.2, [(0.2, 2)], q, target, 30)


TOYS = {toy.__name__: toy for toy in PLAIN}
TOYS |= {mode: lambda mode=mode: orientation_toy(mode) for mode in MODES}
TOYS |= {
    "panda_toy": lambda: panda_toy(READY),
    "jog": lambda: figures.jog(iiwa14(), q=Q7),
    "product": lambda: build_up_toy(iiwa14(), q=Q7),
    "reach": lambda: figures.alive(figures.reach(ur5e(), ur5e().fk(Q6), q=Q6)),
    "eight": lambda: figures.alive(figures.reach(ARM, AT, q=all_solutions(AT))),
    "fly": lambda: figures.alive(fly(rotations.rot_z(0.5), rotations.rot_x(1.2))),
    "table": lambda: figures.alive(
        table([0.9, 0.7]), lambda p: [np.arctan2(p[1], p[0]) - 0.5, 1.0]
    ),
    "drive": lambda: figures.alive(drive(ROUND)),
    "wheels": lambda: wheels(0.2, 0.4, 0.2),
    "gains": lambda: nb3.gains([0.5, 2, 8], {"s1": 3.2, "s2": 1.1}),
    "step_map": step_map,
    "pose_errors": lambda: nb5.pose_errors(
        rigid.transform(rotations.rot_z(0.2), [0.45, 0.3, 0]),
        rigid.transform(rotations.rot_z(1.0), [1.0, 0.65, 0]),
    ),
    "velocities": velocities,
    "errors": errors_of_arm,
    "click": lambda: figures.alive(click(*VIEWS)),
}
