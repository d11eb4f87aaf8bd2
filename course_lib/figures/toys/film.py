"""Stills and films: solid bodies in space, corners in the plane, drawn as the toys are."""

import numpy as np

from course_lib import rigid
from course_lib.figures.digits import rounded, rounded_array
from course_lib.figures.solids import scene
from course_lib.figures.solids.model import Model, Part
from course_lib.figures.style import BLACK as INK
from course_lib.figures.toys.toy import Toy, solid
from course_lib.rotations import log_so3

# Poses in a second and in a film; bodies move along screws between them.
_RATE = 20
_MAX_POSES = 600
_MAX_POINTS = 300  # about so many points of a path are stored
_MAX_GHOSTS = 4  # in the photograph of a film; more cover each other
_START = 0.2  # where the cursor of charts begins, as a share of the film
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
    ghosts=0,
    arrows=(),
    charts=(),
):
    """Return a toy in which bodies move in real time, or stand still if there is one time.

    Parameters
    ----------
    parts : list of Part
        Of the bodies 0, 1, and so on.
    poses : array_like, shape (m, bodies, 4, 4)
    times : array_like, shape (m,)
        Of the poses, in seconds, increasing.
    alt, caption : str
        What the film shows, and what to notice in it.
    name : str, optional
        That of its file if it is written as an animation.
    paths : sequence of (points, colour, dashes), optional
        Points, shape (n, 3), in metres; a row of NaN interrupts a path. Dashes are in pixels.
    words : sequence of (word, point, colour), optional
        Points, shape (3,), in metres.
    pale : sequence of Part, optional
        Parts that are translucent.
    view : array_like, shape (3,), optional
        The direction to the eye.
    ground : float or False, optional
        The height of the floor; that of the lowest point if None, no floor if False.
    near : array_like, shape (n, 3), optional
        What the picture shows, in metres; all if None.
    ghosts : int, optional
        Where no script runs, a photograph of the first pose stands for the film. In it the bodies
        that move are drawn, translucent, at so many later poses, the last one among them.
    arrows : sequence of (body, colour, vectors), optional
        Arrows at the origins of bodies; vectors, shape (m, 3), in metres, one for each time.
    charts : sequence of (title, label, curves), optional
        Charts over time beside the picture, with a cursor at the time of the film. The label names
        the values and their unit; curves is a sequence of (name, colour, values), values of shape
        (m,).

    Returns
    -------
    Toy
    """
    sampled = round(_RATE * (times[-1] - times[0])) + 1
    kept = _evenly(len(times), min(_MAX_POSES, sampled))
    poses = np.asarray(poses, float)[kept]
    times = np.asarray(times, float)[kept]
    model = Model.of(parts)
    vertices = model.placed(poses[:: max(1, len(poses) // 20)]).reshape(-1, 3)
    pale_vertices = [part.moved(poses[0, part.body]).mesh.vertices for part in pale]
    path_points = [points for points, *_ in paths]
    word_points = [[point] for _, point, _ in words]
    shown = near
    if near is None:
        shown = np.concatenate([vertices, *pale_vertices, *path_points, *word_points])
    low = np.nanmin(shown, 0)
    high = np.nanmax(shown, 0)
    centre, radius = scene.floor_size(vertices)
    azimuth = np.arctan2(view[1], view[0])
    elevation = np.arctan2(view[2], np.hypot(view[0], view[1]))
    floor_height = low[2] if ground is None else ground
    positions = _MILLIMETRES * poses[..., :3, 3]
    meta = {
        "title": alt.split(": ", 1)[-1].split(". ")[0],
        "solid": solid(model),
        "times": rounded_array(times - times[0], 4).tolist(),
        # Two arrays, because each is rounded by its own largest number.
        "rotations": rounded_array(log_so3(poses[..., :3, :3]), 5).tolist(),
        "positions": rounded_array(positions, 2).tolist(),
        "paths": [
            [_rounded_path(points), _for_script(colour), list(dash)]
            for points, colour, dash in paths
        ],
        "words": [
            [word, rounded_array(point, 4).tolist(), _for_script(colour)]
            for word, point, colour in words
        ],
        "centre": rounded_array((low + high) / 2, 3).tolist(),
        "radius": rounded(0.25 * float(np.linalg.norm(high - low)), 3),
        "azimuth": rounded(float(azimuth), 4),
        "elevation": rounded(float(elevation), 4),
        "floor": [*centre.tolist(), rounded(float(floor_height), 4), float(radius)],
    }
    if ground is False:
        del meta["floor"]
    if pale:
        meta["pale"] = solid(Model.of(pale))
    if near is not None:
        meta["near"] = rounded_array(near, 4).tolist()
    if arrows:
        meta["arrows"] = [
            [
                body,
                _for_script(colour),
                rounded_array(np.asarray(vectors)[kept], 4).tolist(),
            ]
            for body, colour, vectors in arrows
        ]
    if charts:
        meta["charts"] = [_chart_over_time(*chart, kept) for chart in charts]
        meta["timeTicks"] = _round_ticks(0, meta["times"][-1])
        meta["proportion"] = 1.0
        meta["start"] = rounded(_START * meta["times"][-1], 2)
    if name:
        meta["movie"] = name
    if ghosts:
        meta["ghosts"] = _times_of_ghosts(meta["times"], ghosts)
        meta["moving"] = _moving(poses)
    return Toy("film", meta, alt, caption=caption)


def _for_script(colour):
    """Return the colour of a line or a word, which the script needs as a text like "#0072B2".

    The colours of bodies are numbers instead, those of solids.model, and would leave the picture
    empty.
    """
    if not isinstance(colour, str):
        raise TypeError(
            f"the colour of a line, an arrow or a word must be a text like '#0072B2'; it is "
            f"{colour!r}, which is a colour of bodies"
        )
    return colour


def _chart_over_time(title, label, curves, kept):
    """Return a chart for the script, with a margin around its curves and its name above them."""
    values = [np.asarray(values, float)[kept] for *_, values in curves]
    low, high = np.min(values), np.max(values)
    margin = max(0.08 * (high - low), 1e-3)
    low, high = rounded(float(low - margin), 3), rounded(float(high + 4 * margin), 3)
    lines = [
        [name, _for_script(colour), rounded_array(line, 4).tolist()]
        for (name, colour, _), line in zip(curves, values, strict=True)
    ]
    return {
        "title": title,
        "label": label,
        "range": [low, high],
        "ticks": _round_ticks(low, high),
        "curves": lines,
    }


def _round_ticks(low, high):
    """Return a few round numbers from low to high."""
    step = 10.0 ** np.floor(np.log10((high - low) / 2))
    step *= next(factor for factor in (1, 2, 5, 10) if (high - low) / (factor * step) <= 5)
    first, last = np.ceil(low / step), np.floor(high / step)
    return [rounded(step * k, 9) for k in np.arange(first, last + 1)]


def _times_of_ghosts(times, count):
    """Return so many times after the first, evenly spaced, with the last one."""
    if not 0 <= count <= _MAX_GHOSTS:
        raise ValueError(f"ghosts must be from 0 to {_MAX_GHOSTS}; it is {count!r}")
    return rounded_array(np.linspace(times[0], times[-1], count + 1)[1:], 4).tolist()


def _moving(poses):
    """Return the numbers of the bodies that move by more than a millimetre or a milliradian."""
    change = np.abs(poses - poses[0]).max(axis=(0, 2, 3))
    return np.flatnonzero(change > 1e-3).tolist()


def _rounded_path(points):
    """Return about `_MAX_POINTS` of the points of a path, as JSON."""
    step = max(1, len(points) // _MAX_POINTS)
    return rounded_array(points[::step], 4).tolist()


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
    colours=(),
    names=(),
    ghosts=0,
):
    """Return a film in the plane, around a centre, with `half` metres to both sides.

    Parameters
    ----------
    shapes : sequence of array_like, shape (m, n, 2)
        The corners of each thing that moves, in metres.
    times : array_like, shape (m,)
        In seconds, increasing.
    alt, caption : str
        What the film shows, and what to notice in it.
    name : str
        That of its file if it is written as an animation.
    still : sequence of (points, colour, dashes) or (points, colour, dashes, number)
        What stands still: points, shape (n, 2), in metres, joined by a line; a single point is a
        dot. Dashes are in pixels. Where things have maps of their own, it is drawn in each of them,
        or only in that of the thing with this number.
    half : float
        Metres from the centre to both sides.
    centre : array_like, shape (2,), optional
        In metres.
    proportion : float, optional
        Height over width.
    closed : bool, optional
        Whether the last corner is joined to the first.
    colours : sequence of str, optional
        One for each thing that moves; all are crimson by default.
    names : sequence of str, optional
        One for each thing that moves, which then has a map of its own, beside the others.
    ghosts : int, optional
        As those of `film`.

    Returns
    -------
    Toy
    """
    meta = {
        "title": alt.split(". ")[1],
        "times": rounded_array(np.subtract(times, times[0]), 4).tolist(),
        "shapes": [rounded_array(corners, 3).tolist() for corners in shapes],
        "still": [
            [rounded_array(points, 3).tolist(), _for_script(colour), list(dash), *number]
            for points, colour, dash, *number in still
        ],
        "half": half,
        "centre": list(centre),
        "proportion": proportion,
        "closed": closed,
        "movie": name,
    }
    if colours:
        meta["colours"] = list(map(_for_script, colours))
    if names:
        meta["names"] = list(names)
    if ghosts:
        meta["ghosts"] = _times_of_ghosts(meta["times"], ghosts)
    return Toy("film", meta, alt, caption=caption)


def still(parts, alt, caption="", *, at=None, proportion=0.75, **look):
    """Return a picture of Parts that stand still, without a floor.

    Parameters
    ----------
    parts : list of Part
    alt, caption : str
        What the picture shows, and what to notice in it.
    at : array_like, shape (bodies, 4, 4), optional
        The poses of bodies; if None, there is one, where its meshes are.
    proportion : float, optional
        Height over width.
    **look
        Further arguments of `film`.

    Returns
    -------
    Toy
    """
    poses = [np.eye(4)[None]] if at is None else [at]
    picture = film(parts, poses, [0.0], alt, caption, ground=False, **look)
    picture.meta["proportion"] = proportion
    return picture


def beside(groups, apart, alt, caption="", *, view=VIEW, high=0.0, proportion=0.5, near=None):
    """Return a picture of things beside each other.

    Parameters
    ----------
    groups : dict
        Title to (Parts, pale Parts, paths, words), each around the origin; paths and words are
        those of `film`.
    apart : float
        Metres between neighbours, as seen from `view`.
    alt, caption : str
        What the picture shows, and what to notice in it.
    view : array_like, shape (3,), optional
        The direction to the eye.
    high : float, optional
        Metres above the origin at which the titles stand.
    proportion : float, optional
        Height over width.
    near : array_like, shape (n, 3), optional
        What the picture shows of each thing, in metres, as seen from its origin; all if None.

    Returns
    -------
    Toy
    """
    parts, pale, paths, words = [], [], [], []
    right = apart * np.cross([0, 0, 1], view) / np.linalg.norm(view[:2])
    places = (np.arange(len(groups)) - (len(groups) - 1) / 2)[:, None] * right
    for body, (place, (title, group)) in enumerate(zip(places, groups.items(), strict=True)):
        own_parts, own_pale, own_paths, own_words = group
        parts += [Part(body, part.colour, part.mesh) for part in own_parts]
        pale += [Part(body, part.colour, part.mesh) for part in own_pale]
        paths += [(points + place, *look) for points, *look in own_paths]
        words += [(word, point + place, colour) for word, point, colour in own_words]
        words.append((title, place + np.array([0, 0, high]), INK))
    at = rigid.transform(np.broadcast_to(np.eye(3), (len(places), 3, 3)), places)
    look = {"proportion": proportion, "view": view}
    if near is not None:
        look["near"] = np.concatenate([place + np.asarray(near) for place in places])
    return still(parts, alt, caption, at=at, pale=pale, paths=paths, words=words, **look)


def _evenly(n, max_count):
    """The numbers of at most so many of n samples, the first and the last among them."""
    return np.unique(np.linspace(0, n - 1, min(n, max(max_count, 2))).astype(int))
