"""Stored films and stills of rigid bodies, read for the tests: poses and vertices of each body, in metres."""

import base64

import numpy as np

from course_lib import rigid
from course_lib.rotations import exp_so3


class Film:
    """A stored film: poses (m, bodies, 4, 4), and the vertices of each body in its own frame."""

    def __init__(self, toy):
        self.course = toy.stored()["layout"]["meta"]["course"]
        self.poses = rigid.transform(exp_so3(self.course["rotations"]), np.array(self.course["positions"]) / 1000)
        vertices, of_body = (base64.b64decode(self.course["solid"][name]) for name in ("vertices", "bodies"))
        self.local = np.frombuffer(vertices, "<i2").reshape(-1, 3) / 1e4
        self.of_body = np.frombuffer(of_body, "u1")
        self.bodies = [self.local[self.of_body == k] for k in range(self.of_body.max() + 1)]
        self.paths = [np.array(points, float) for points, *_ in self.course["paths"]]

    def at(self, i):
        """The vertices (n, 3) at the time i."""
        poses = self.poses[i][self.of_body]
        return (poses[:, :3, :3] @ self.local[:, :, None])[..., 0] + poses[:, :3, 3]
