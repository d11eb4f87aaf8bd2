"""What several exercises about the Panda need: its DH table, poses and Jacobian, and the right
answers they share."""

import numpy as np

from course_lib import ik
from course_lib.arms import PANDA_ROWS, panda
from course_lib.checks.vocabulary import compared, remembered
from course_lib.rigid import transform

T_W0 = transform(np.eye(3), [-0.2, 0.13, 0.6])
TABLE = np.array(PANDA_ROWS)
READY = np.array([0, -np.pi / 4, 0, -3 * np.pi / 4, 0, np.pi / 2, np.pi / 4])
PANDA = panda()  # made here, because no answer may call what makes it
LOW, HIGH = PANDA.limits.T
FLAT = np.array([[1.0, 0, 0], [0, 1, 0]])  # a Jacobian to compute with by hand


def about_x(alpha, a=0.0):
    """Return the pose of a rotation about x by `alpha` and a translation along x by `a`."""
    c, s = np.cos(alpha), np.sin(alpha)
    return np.array([[1, 0, 0, a], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]])


def about_z(theta, d=0.0):
    """Return the pose of a rotation about z by `theta` and a translation along z by `d`."""
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])


def modified(a, alpha, d, theta):
    """Return Rot_x Trans_x Rot_z Trans_z, Craig's convention."""
    return about_x(alpha, a) @ about_z(theta, d)


def standard(a, alpha, d, theta):
    """Return Rot_z Trans_z Trans_x Rot_x, the convention of Denavit and Hartenberg."""
    return about_z(theta, d) @ about_x(alpha, a)


@remembered
def frames(q):
    """Return the poses (8, 4, 4) of frames 1 to 7 and the flange in the world, by the library's
    screws."""
    return T_W0 @ PANDA.frames(q)


def flange(q):
    """Return the pose of the flange in the world."""
    return frames(q)[-1]


def panda_jacobian(q):
    """Return the Jacobian (6, 7) of the Panda's flange, (v, omega)."""
    return np.roll(PANDA.geometric_jacobian(q), 3, axis=0)


@remembered
def pose_error(T, T_target):
    """Return the right pose error (6,), (v, omega); at an angle of pi phi and -phi are both
    right."""
    return np.roll(ik.pose_error(T, T_target), 3)


def roll_pitch_yaw(R):
    """Return the angles of R = Rot_z(yaw) Rot_y(pitch) Rot_x(roll)."""
    pitch = np.arctan2(-R[2, 0], np.hypot(R[0, 0], R[1, 0]))
    return np.array([np.arctan2(R[2, 1], R[2, 2]), pitch, np.arctan2(R[1, 0], R[0, 0])])


def damped(q, J, e, eps):
    """Return the angles after a damped step, by singular values: nothing is lost to rounding."""
    U, s, Vt = np.linalg.svd(J, full_matrices=False)
    return q + Vt.T @ (s / (s**2 + eps) * (U.T @ e))


def panda_step(rng):
    """Return joint angles of the Panda, their Jacobian and an error."""
    q = np.round(rng.uniform(LOW, HIGH), 2)
    return q, panda_jacobian(q), np.round(rng.uniform(0.2, 0.9, 6) * rng.choice([-1, 1], 6), 2)


def changed(answer, right, q):
    """Return the Finding by how much an answer changes the joint angle q[j] that is off most."""
    j = int(np.argmax(np.abs(answer - right)))
    return f"The change of q[{j}] should be " + compared(right[j] - q[j], answer[j] - q[j]) + "."
