"""The helper package of the robot kinematics course: mathematics, figures, checks and the course's own tools."""

__version__ = "0.1.0"
