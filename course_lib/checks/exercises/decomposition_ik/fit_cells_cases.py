"""Samples of an arm of two links, cell by cell, for the check of the models that are fitted to them."""

import numpy as np

from course_lib.checks.exercises.decomposition_ik.shared import solutions

_WIDTH = 0.16  # metres: half a cell, from its middle to its border


def both(rng, middle, up, down):
    """Return positions and joint angles of one cell: `up` samples with q2 > 0, `down` with q2 < 0.

    The first three of each lie near three corners of the cell, so that they determine a plane well.
    """
    xy = np.concatenate([_positions(rng, middle, n) for n in (up, down)])
    elbow = np.repeat([0, 1], [up, down])
    return xy, solutions(xy)[np.arange(len(xy)), elbow]


def one_elbow(rng, middle, elbow, n):
    """Return samples of a cell that holds one elbow only: a small lump near to the base, a large one far from it."""
    outward = np.array(middle) / np.linalg.norm(middle)
    far = np.repeat([-1, 1], [n // 4, n - n // 4])
    xy = middle + 0.16 * far[:, None] * outward + rng.uniform(-0.04, 0.04, (n, 2))
    return xy, solutions(xy)[:, elbow]


def _positions(rng, middle, n):
    corners = np.array([[-1, -1], [1, -0.9], [-0.8, 1]])[:n] * rng.uniform(0.9, 1, (min(n, 3), 1))
    return middle + _WIDTH * np.concatenate([corners, rng.uniform(-1, 1, (max(n - 3, 0), 2))])


def mixed(rng, cells, count):
    """Return (xy, q, cell, count) of [(number, (positions, angles))], the samples in any order."""
    xy, q = (np.concatenate([samples[i] for _, samples in cells]) for i in (0, 1))
    cell = np.concatenate([np.full(len(samples[0]), number) for number, samples in cells])
    order = rng.permutation(len(cell))
    return xy[order], q[order], cell[order], count


def cases(rng):
    """Return the cases, in which every pair of clusters lies so far apart that there is no doubt about them."""
    a, b, c, d = (0.9, 1.3), (-0.2, 1.6), (1.2, 1.0), (-0.9, 1.4)
    lone, outside = both(rng, (0.5, 1.4), 1, 0), both(rng, (0.3, 1.55), 8, 8)
    return [
        mixed(rng, [(0, both(rng, a, 12, 12))], 1),
        mixed(rng, [(-1, both(rng, b, 12, 12))], 1),
        mixed(rng, [(0, both(rng, b, 22, 2))], 1),
        mixed(rng, [(0, both(rng, d, 1, 22))], 1),
        mixed(rng, [(0, both(rng, c, 20, 3))], 1),
        mixed(rng, [(0, one_elbow(rng, (0.5, 1.5), 0, 24))], 1),
        mixed(rng, [(0, one_elbow(rng, (-0.4, 1.5), 1, 25)), (-1, outside)], 1),
        mixed(rng, [(0, both(rng, a, 9, 7)), (2, both(rng, b, 8, 11)), (-1, outside)], 4),
        mixed(rng, [(3, both(rng, c, 9, 9)), (1, both(rng, d, 14, 6)), (-1, both(rng, (1.1, 1.15), 5, 5))], 4),
        mixed(
            rng,
            [
                (0, lone),
                (1, both(rng, b, 1, 1)),
                (2, both(rng, c, 3, 16)),
                (3, both(rng, d, 8, 2)),
                (4, both(rng, a, 4, 5)),
            ],
            5,
        ),
    ]
