"""Stored films and stills of rigid bodies, read for the tests: poses and vertices of each body, in
metres."""

import base64

import numpy as np

from course_lib import rigid
from course_lib.rotations import exp_so3


class Film:
    """A stored film: poses (m, bodies, 4, 4), and the vertices of each body in its own frame."""

    def __init__(self, toy):
        self.course = toy.stored()["layout"]["meta"]["course"]
        self.poses = rigid.transform(
            exp_so3(self.course["rotations"]), np.array(self.course["positions"]) / 1000
        )
        self.local, self.of_body = _read(self.course["solid"])
        self.bodies = [self.local[self.of_body == k] for k in range(self.of_body.max() + 1)]
        self.paths = [np.array(points, float) for points, *_ in self.course["paths"]]
        self.words = {word: np.array(at) for word, at, _ in self.course["words"]}

    def at(self, i):
        """The vertices (n, 3) at the time i."""
        return self._placed(self.poses[i], self.local, self.of_body)

    def pale(self):
        """The vertices (n, 3) of what is translucent in a still."""
        return self._placed(self.poses[0], *_read(self.course["pale"]))

    def has_dot(self, point):
        """Whether a small ball stands at a point (3,)."""
        away = np.sort(np.linalg.norm(self.at(0) - point, axis=1))
        away = away[away < 0.1]  # a ball has 60 vertices equally far from its middle
        return bool((away[59:] - away[: max(0, len(away) - 59)] < 6e-4).any())

    @staticmethod
    def _placed(poses, local, of_body):
        return (poses[of_body, :3, :3] @ local[:, :, None])[..., 0] + poses[of_body, :3, 3]


def _read(solid):
    vertices, of_body = (base64.b64decode(solid[name]) for name in ("vertices", "bodies"))
    return np.frombuffer(vertices, "<i2").reshape(-1, 3) / 1e4, np.frombuffer(of_body, "u1")
