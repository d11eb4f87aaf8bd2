"""Joint trajectories in files: read what other programs write, or ask what is not clear.

A file holds time, joint angles and, if it has them, velocities, as a table in text or as NPY.
`load` uses a column if its title says what it is, or if the user says so; everything else it
refuses with the header, what it understood of each column, and the line to write. `disagreement`
says whether velocities, positions and times belong together, and `save` writes what `load` reads.
"""

from course_lib.trajectory.agreement import disagreement
from course_lib.trajectory.loading import JointCountError, load
from course_lib.trajectory.motion import Trajectory, save
from course_lib.trajectory.understood import UnclearFileError

__all__ = ["JointCountError", "Trajectory", "UnclearFileError", "disagreement", "load", "save"]
