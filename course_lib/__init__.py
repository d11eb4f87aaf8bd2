"""The helper package of the robot kinematics course.

It holds mathematics, figures, checks and the course's own tools.

In the mathematics, arrays are batched on the left: a function of one (3, 3) matrix takes (..., 3,
3). Angles are in radians, lengths in metres. Public functions raise ValueError, naming the
argument, for one that is not as described: for a wrong shape, for entries that are not finite real
numbers, or larger than 1e100.
"""

__version__ = "1.3.0"
