"""Stored films of rigid bodies, read for the tests: poses and vertices of each body at each time, in metres."""

import numpy as np

from course_lib import rigid
from course_lib.figures.solids.scene import projected
from course_lib.pack.animations import placed, points
from course_lib.rotations import exp_so3


class Film:
    """A stored film: poses (m, bodies, 4, 4) and `bodies`, the vertices of each in its own frame."""

    def __init__(self, figure):
        self.figure, self.course = figure, figure["layout"]["meta"]["course"]
        self.poses = rigid.transform(exp_so3(self.course["rotations"]), np.array(self.course["positions"]) / 1000)
        self.of_body = np.repeat(np.arange(len(self.course["counts"])), self.course["counts"])
        vertices = points(figure["data"][self.course["trace"]]) / 1000
        self.local = placed(rigid.inverse(self.poses[0])[self.of_body], vertices)
        self.bodies = [self.local[self.of_body == k] for k in range(len(self.course["counts"]))]

    def at(self, i):
        """The vertices (n, 3) at the time i."""
        return placed(self.poses[i][self.of_body], self.local)

    def frame(self, i):
        """The vertices (n, 3) that JupyterLab shows in its frame i."""
        return points(self.figure["frames"][i]["data"][0]) / 1000


def assert_in_ranges(at, scene, unit=1.0):
    """Assert that points (n, 3) are inside the ranges of a scene, outside of which plotly clips, and in its picture."""
    ranges = np.array([scene[f"{c}axis"]["range"] for c in "xyz"]) / unit
    assert (at.min(0) > ranges[:, 0]).all()
    assert (at.max(0) < ranges[:, 1]).all()
    assert np.abs(projected(at * unit, scene)).max() < 1
