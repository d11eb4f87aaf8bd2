"""What students write for newton_step(q, xy)."""

import numpy as np


def _fk(q):
    a, b = q[0], q[0] + q[1]
    return np.array([np.cos(a) + np.cos(b), np.sin(a) + np.sin(b)])


def _J(q):
    a, b = q[0], q[0] + q[1]
    return np.array([[-np.sin(a) - np.sin(b), -np.sin(b)], [np.cos(a) + np.cos(b), np.cos(b)]])


def right_by_solve(q, xy):
    return q + np.linalg.solve(_J(q), xy - _fk(q))


def right_by_inverse(q, xy):
    return q - np.linalg.inv(_J(q)) @ (_fk(q) - xy)


def right_as_a_list(q, xy):
    (a, b), (c, d) = _J(q)
    e, f = xy - _fk(q)
    det = np.sin(q[1])
    return [q[0] + (d * e - b * f) / det, q[1] + (a * f - c * e) / det]


def wrong_half_a_radian_at_most(q, xy):
    """long steps are shortened"""
    q = np.asarray(q, float)
    first, both = q[0], q[0] + q[1]
    J = np.array(
        [
            [-np.sin(first) - np.sin(both), -np.sin(both)],
            [np.cos(first) + np.cos(both), np.cos(both)],
        ]
    )
    tip = np.array([np.cos(first) + np.cos(both), np.sin(first) + np.sin(both)])
    step = np.linalg.solve(J, xy - tip)
    return q + step * min(1, 0.5 / max(np.linalg.norm(step), 1e-300))


def wrong_pseudoinverse_with_a_cut_off(q, xy):
    """the answers to some inputs only are wrong"""
    return q + np.linalg.pinv(_J(q), rcond=1e-2) @ (xy - _fk(q))


def wrong_position_brought_into_reach(q, xy):
    """the answers to some inputs only are wrong"""
    return right_by_solve(q, xy * min(1.0, 2.0 / np.linalg.norm(xy)))


_last = []


def wrong_kept_for_the_angles(q, xy):
    """kept for some of the arguments"""
    if _last and _last[0] is q and np.array_equal(_last[1], q):
        return _last[2].copy()
    _last[:] = [q, np.array(q), right_by_solve(q, xy)]
    return _last[2].copy()
