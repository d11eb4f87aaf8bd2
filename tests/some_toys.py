"""One of each toy, for tests."""

import numpy as np

from course_lib import figures, rotations
from course_lib.arms import iiwa14, panda, planar_arm, ur5e
from course_lib.checks.exercises.subproblems_damped_ik.six_axis_arm import ARM, all_solutions
from course_lib.figures.toys.arms import PANDA_ROWS
from course_lib.figures.toys.plane import _ROUND

Q6 = [0.3, -1.2, 1.5, -1.8, -1.5, 0.2]
AT = ARM.fk([0.3, 0.4, -0.5, 0.6, 0.7, -0.8])
NAMES = ["iiwa_toy", "panda_toy", "two_poses_toy", "dead_reckoning_toy", "circles_toy", "planar_arm_toy", "cells_toy"]
TOYS = {name: getattr(figures, name) for name in [*NAMES, "bent_arm_toy", "orientation_toy"]}
TOYS |= {
    "jog": lambda: figures.jog(iiwa14()),
    "product": lambda: figures.build_up_toy(iiwa14()),
    "rows": lambda: figures.build_up_toy(panda(), q=np.mean(panda().limits, axis=1), rows=PANDA_ROWS),
    "plane": lambda: figures.alive(figures.reach(planar_arm([1, 1]), [1.2, 0.8])),
    "reach": lambda: figures.alive(figures.reach(ur5e(), ur5e().fk(Q6), q=Q6)),
    "eight": lambda: figures.alive(figures.reach(ARM, AT, q=all_solutions(AT))),
    "fly": lambda: figures.alive(figures.fly(rotations.rot_z(0.5), rotations.rot_x(1.2))),
    "table": lambda: figures.alive(figures.table(), lambda p: [np.arctan2(p[1], p[0]) - 0.5, 1.0]),
    "drive": lambda: figures.alive(figures.drive(_ROUND)),
}
