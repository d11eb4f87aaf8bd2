"""What students write for test_ik_2r(ik_2r)."""

import numpy as np

INSIDE = [[1.0, 1.0], [-0.6, 1.3], [-1.1, -0.4], [0.2, -1.7], [1.999, 0.0], [0.5, 0.1]]
EDGE = [[2.0, 0.0], [0.0, -2.0], [-1.2, 1.6]]
BEYOND = [[2.02, 0.0], [-2.0, 2.0], [1.5, 1.5], [0.5, -2.1]]


def _fk(q):
    a, b = q[..., 0], q[..., 0] + q[..., 1]
    return np.stack([np.cos(a) + np.cos(b), np.sin(a) + np.sin(b)], -1)


def right_by_forward_kinematics(ik_2r, tolerance=1e-6, inside=INSIDE, edge=EDGE, beyond=BEYOND):
    for xy in inside + edge:
        q = np.array(ik_2r(xy))
        if (
            q.shape != (2, 2)
            or not np.allclose(_fk(q), xy, rtol=0, atol=tolerance)
            or q[0, 1] < -1e-6
            or q[1, 1] > 1e-6
        ):
            return False
    return all(np.isnan(ik_2r(xy)).all() for xy in beyond)


def right_by_assertions_many_times(ik_2r):
    rng = np.random.default_rng(2)
    for r in (0.3, 1.0, 1.7, 1.999, 2.0):
        for angle in rng.uniform(-np.pi, np.pi, 25):
            xy = r * np.array([np.cos(angle), np.sin(angle)])
            q = np.array(ik_2r(xy))
            assert q[0, 1] > -1e-9
            assert q[1, 1] < 1e-9
            np.testing.assert_allclose(_fk(q), [xy, xy], atol=1e-7)
    for beyond in ([2.001, 0.1], [-2.001, -0.1], [0.1, 3], [-0.1, -3]):
        assert np.isnan(np.array(ik_2r(beyond))).all()
    return True


def right_against_the_law_of_cosines(ik_2r):
    for x, y in INSIDE + EDGE:
        bend, to = np.arccos(np.clip((x**2 + y**2 - 2) / 2, -1, 1)), np.arctan2(y, x)
        gap = np.array(ik_2r([x, y])) - [[to - bend / 2, bend], [to + bend / 2, -bend]]
        if not np.abs(np.exp(1j * gap) - 1).max() < 1e-6:
            return False
    return all(np.isnan(np.array(ik_2r(xy))).all() for xy in BEYOND)


def wrong_exactly_equal(ik_2r):
    """rejects everything"""
    return all((_fk(np.array(ik_2r(xy))) == xy).all() for xy in INSIDE)


def wrong_three_quadrants(ik_2r):
    """unnamed"""
    inside = [xy for xy in INSIDE if xy[0] > 0 or xy[1] > 0]
    return right_by_forward_kinematics(ik_2r, inside=inside)


def wrong_edge_on_the_axes(ik_2r):
    """unnamed"""
    return right_by_forward_kinematics(ik_2r, edge=EDGE[:2])


def wrong_far_beyond(ik_2r):
    """unnamed"""
    return right_by_forward_kinematics(ik_2r, beyond=BEYOND[1:])


def wrong_direction_of_the_base(ik_2r):
    """rejects right versions"""
    q = np.array(ik_2r([0.0, 0.0]))
    return bool(np.all(abs(q[:, 0] + q[:, 1] / 2) < 1e-6)) and right_by_forward_kinematics(ik_2r)


def wrong_to_a_centimetre(ik_2r):
    """unnamed"""
    return right_by_forward_kinematics(ik_2r, tolerance=0.01)
