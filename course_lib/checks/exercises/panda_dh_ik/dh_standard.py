"""dh_standard: the pose of a frame in the one before by the convention of Denavit and Hartenberg."""

from course_lib.checks.exercises.panda_dh_ik.dh_modified import made
from course_lib.checks.exercises.panda_dh_ik.shared import modified, standard

EXERCISE = made(
    "dh_standard",
    standard,
    modified,
    "rotated by theta about the old z; alpha does not change it",
    "rotated by alpha about x, then by theta about the old z",
    "d along the old z, then a along the new x",
    (
        "The same two poses as in dh_modified: one along x, one along z.",
        "rigid.transform(rotations.rot_z(theta), [0, 0, d]) is the one along z.",
        "In the standard convention the pose along z is the left factor: along_z @ along_x.",
    ),
)
