"""Stills and films: solid bodies in space, corners in the plane, drawn as the toys are."""

import numpy as np

from course_lib import rigid
from course_lib.figures.solids import scene
from course_lib.figures.solids.model import Model, Part
from course_lib.figures.style import BLACK as INK
from course_lib.figures.toys.toy import Toy, solid
from course_lib.rotations import log_so3

_RATE, _MOST_POSES = (
    20,
    600,
)  # poses in a second, and in a film; bodies move along screws between them
_MILLIMETRES = 1000  # the unit of positions, in which numbers are short
VIEW = (1.05, -1.3, 0.55)  # the direction to the eye, unless a picture sets another


def film(
    parts,
    poses,
    times,
    alt,
    caption="",
    *,
    name="",
    paths=(),
    words=(),
    pale=(),
    view=VIEW,
    ground=None,
    near=None,
):
    """Return a toy in which bodies move in real time, or stand still if there is one time.

    parts: Parts, of the bodies 0, 1, ... poses: (m, bodies, 4, 4), at times (m,), in seconds,
    increasing. name: that of its file if it is written as an animation. paths: (points (n, 3),
    colour, dashes in pixels); a row of NaN interrupts a path. words: (word, point, colour). pale:
    Parts that are translucent. view: (3,), the direction to the eye. ground: the height of the
    floor; that of the lowest point if None, no floor if False. near: (n, 3), what the picture
    shows; all if None.
    """
    kept = _evenly(len(times), min(_MOST_POSES, round(_RATE * (times[-1] - times[0])) + 1))
    poses, times = np.asarray(poses, float)[kept], np.asarray(times, float)[kept]
    model = Model.of(parts)
    vertices = model.placed(poses[:: max(1, len(poses) // 20)]).reshape(-1, 3)
    more = [
        *(part.moved(poses[0, part.body]).mesh.vertices for part in pale),
        *(points for points, *_ in paths),
        *([p] for _, p, _ in words),
    ]
    shown = np.concatenate([vertices, *more])
    low, high = (extreme(shown if near is None else near, 0) for extreme in (np.nanmin, np.nanmax))
    centre, radius = scene.floor_size(vertices)
    azimuth, elevation = (
        np.arctan2(view[1], view[0]),
        np.arctan2(view[2], np.hypot(view[0], view[1])),
    )
    meta = {
        "title": alt.split(": ", 1)[-1].split(". ")[0],
        "solid": solid(model),
        "times": (times - times[0]).round(4).tolist(),
        # Two arrays, because each is rounded by its own largest number.
        "rotations": (np.round(log_so3(poses[..., :3, :3]) + 3.1e-7, 5) + 0.0).tolist(),
        "positions": (np.round(_MILLIMETRES * poses[..., :3, 3] + 3.1e-4, 2) + 0.0).tolist(),
        "paths": [
            [
                np.round(points[:: max(1, len(points) // 300)] + 3.1e-7, 4).tolist(),
                colour,
                list(dash),
            ]
            for points, colour, dash in paths
        ],
        "words": [
            [word, np.round(np.add(point, 3.1e-7), 4).tolist(), colour]
            for word, point, colour in words
        ],
        "centre": ((low + high) / 2).round(3).tolist(),
        "radius": round(0.25 * float(np.linalg.norm(high - low)), 3),
        "azimuth": round(float(azimuth), 4),
        "elevation": round(float(elevation), 4),
        "floor": [
            *centre.tolist(),
            round(float(low[2] if ground is None else ground), 4),
            float(radius),
        ],
    }
    if ground is False:
        del meta["floor"]
    if pale:
        meta["pale"] = solid(Model.of(pale))
    if near is not None:
        meta["near"] = np.round(near, 4).tolist()
    return Toy("film", meta | ({"movie": name} if name else {}), alt, caption=caption)


def flat_film(
    shapes,
    times,
    alt,
    caption="",
    *,
    name,
    still,
    half,
    centre=(0, 0),
    proportion=1.0,
    closed=False,
):
    """Return a film in the plane, around a centre, with `half` metres to both sides.

    shapes: the corners (m, n, 2) of each thing that moves, at times (m,), in seconds: joined, and
    closed or not. name: that of its file if it is written as an animation. still: (points (n, 2),
    colour, dashes in pixels); one is a dot.
    """
    meta = {
        "title": alt.split(". ")[1],
        "times": np.subtract(times, times[0]).round(4).tolist(),
        "shapes": [(np.round(corners, 3) + 0.0).tolist() for corners in shapes],
        "still": [
            [(np.round(points, 3) + 0.0).tolist(), colour, list(dash)]
            for points, colour, dash in still
        ],
        "half": half,
        "centre": list(centre),
        "proportion": proportion,
        "closed": closed,
        "movie": name,
    }
    return Toy("film", meta, alt, caption=caption)


def still(parts, alt, caption="", *, at=None, proportion=0.75, **look):
    """Return a picture of Parts that stand still, without a floor.

    at: (bodies, 4, 4), the poses of bodies; if None, there is one, where its meshes are.
    proportion: height over width. look: as of `film`.
    """
    poses = [np.eye(4)[None]] if at is None else [at]
    made = film(parts, poses, [0.0], alt, caption, ground=False, **look)
    made.meta["proportion"] = proportion
    return made


def beside(groups, apart, alt, caption="", *, view=VIEW, high=0.0):
    """Return a picture of things beside each other, `apart` metres as seen from `view`.

    groups: {title: (Parts, pale Parts, paths, words)}, each around the origin. high: where the
    titles stand.
    """
    parts, pale, paths, words = [], [], [], []
    right = apart * np.cross([0, 0, 1], view) / np.linalg.norm(view[:2])
    places = (np.arange(len(groups)) - (len(groups) - 1) / 2)[:, None] * right
    for i, (place, (title, group)) in enumerate(zip(places, groups.items(), strict=True)):
        for drawn, own in zip((parts, pale), group, strict=False):
            drawn += [Part(i, part.colour, part.mesh) for part in own]
        paths += [(points + place, *look) for points, *look in group[2]]
        words += [(word, point + place, colour) for word, point, colour in group[3]]
        words.append((title, place + np.array([0, 0, high]), INK))
    at = rigid.transform(np.broadcast_to(np.eye(3), (len(places), 3, 3)), places)
    return still(
        parts, alt, caption, at=at, proportion=0.5, pale=pale, paths=paths, words=words, view=view
    )


def _evenly(n, most):
    """The numbers of at most so many of n samples, the first and the last among them."""
    return np.unique(np.linspace(0, n - 1, min(n, max(most, 2))).astype(int))
