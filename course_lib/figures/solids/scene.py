"""The surroundings of a robot: floor with grid and soft shadow, table, joint axes, named frames, and the camera."""

import numpy as np
import plotly.graph_objects as go

from course_lib.figures.solids.meshes import arrow, revolve
from course_lib.figures.solids.model import WHITE, X_RED, Part
from course_lib.figures.solids.shells import joint_points
from course_lib.figures.space import coordinates, line, scene_name, words_at
from course_lib.figures.style import BLACK, PLOTLY_LAYOUT

_FIELD_OF_VIEW = np.tan(np.pi / 8)  # plotly's: 45 degrees from top to bottom
_FLOOR, _SHADOW, _GRID = "#eceef1", "#6b727b", "#c3c8ce"
VIEW = (1.05, -1.3, 0.55)  # the direction to the eye, unless a picture sets another


def fitted_scene(points, view=VIEW, *, aspect=1.0, fill=0.94, domain=(0, 1)):
    """Return plotly's settings of a scene whose camera shows all points, as large as it can.

    points: (n, 3), everything that must be visible, in every frame of a film. view: (3,), the direction to the eye.
    aspect: width of the scene over its height, in pixels; plotly draws to the scale of the height. fill: the share of
    the picture's height or width that the points take. domain: left and right edge, as shares of the figure's width.
    """
    points = np.asarray(points, float).reshape(-1, 3)
    low, high = points.min(0), points.max(0)
    size = max(high - low)
    low, high = low - 0.15 * size, high + 0.15 * size  # plotly clips what is outside, labels too
    scale = 1 / max(high - low)
    p = (points - (low + high) / 2) * scale
    axes = camera_axes(view)
    centre, distance = np.zeros(3), 2.0
    for _ in range(60):
        seen = (p - centre) @ axes.T
        ndc = seen[:, :2] / (distance - seen[:, 2:]) / _FIELD_OF_VIEW / [aspect, 1]
        middle = (ndc.max(0) + ndc.min(0)) / 2
        centre = centre + distance * _FIELD_OF_VIEW * (middle * [aspect, 1]) @ axes[:2]
        distance *= 1 + 0.8 * (np.abs(ndc - middle).max() / fill - 1)
    hidden = {"visible": False, "showspikes": False}
    ranges = {c: [round(a, 4), round(b, 4)] for c, a, b in zip("xyz", low, high, strict=True)}
    return {
        **{f"{c}axis": hidden | {"range": both} for c, both in ranges.items()},
        "aspectmode": "manual",
        "aspectratio": _xyz((high - low) * scale),
        "camera": {"eye": _xyz(centre + distance * axes[2]), "center": _xyz(centre), "up": {"x": 0, "y": 0, "z": 1}},
        "domain": {"x": list(domain), "y": [0, 1]},
        "dragmode": "orbit",
    }


def projected(points, scene, aspect=1.0):
    """Return where points (n, 3) are drawn: (n, 2), from -1 to 1 to the right and up, by a scene's settings."""
    ranges = np.array([scene[f"{c}axis"]["range"] for c in "xyz"])
    ratio = np.array([scene["aspectratio"][c] for c in "xyz"])
    eye, centre = (np.array([scene["camera"][name][c] for c in "xyz"]) for name in ("eye", "center"))
    p = (np.asarray(points) - ranges.mean(1)) * ratio / np.ptp(ranges, axis=1)
    seen = (p - centre) @ camera_axes(eye - centre).T
    return seen[:, :2] / (np.linalg.norm(eye - centre) - seen[:, 2:]) / _FIELD_OF_VIEW / [aspect, 1]


def camera_axes(view):
    """Return the unit vectors to the right, up, and to the eye, as rows (3, 3)."""
    z = np.asarray(view, float) / np.linalg.norm(view)
    x = np.cross([0, 0, 1], z)
    x = x / np.linalg.norm(x)
    return np.array([x, np.cross(z, x), z])


def column(points, view, i, n, *, height, fill=0.94):
    """Return the settings of the i-th of n scenes side by side in a figure 700 pixels wide, and its aspect."""
    aspect = 700 / n / height
    return fitted_scene(points, view, aspect=aspect, fill=fill, domain=(i / n, (i + 1) / n)), aspect


def eye(settings):
    """Return the position (3,) of the camera of a scene's settings, in metres."""
    ranges = np.array([settings[f"{c}axis"]["range"] for c in "xyz"])
    seen = np.array([settings["camera"]["eye"][c] for c in "xyz"])
    return ranges.mean(1) + seen * np.ptp(ranges[0]) / settings["aspectratio"]["x"]


def layout(scenes, *, height=480, titles=()):
    """Return the layout of a figure with these scenes side by side, each under its title."""
    notes = []
    for i, title in enumerate(titles):
        at = {"x": (i + 0.5) / len(scenes), "y": 1, "xref": "paper", "yref": "paper", "yanchor": "bottom"}
        notes.append({"text": title, "showarrow": False, **at})
    margin = {"l": 0, "r": 0, "t": 30 if titles else 0, "b": 0}
    own = {"annotations": notes, "height": height, "margin": margin, "showlegend": False}
    return {**PLOTLY_LAYOUT, **own, **{scene_name(i): settings for i, settings in enumerate(scenes)}}


def floor(vertices, *, height=0.0):
    """Return a round floor with the soft shadow of what stands above it, and its grid: two traces.

    vertices: (n, 3), of the bodies that cast the shadow; of a film, those of several frames.
    """
    centre, radius = floor_size(vertices)
    rings, around = 11, 32
    t = 2 * np.pi * np.arange(around) / around
    r = radius * np.linspace(0, 1, rings + 1)[1:, None]
    x = np.r_[centre[0], (centre[0] + r * np.cos(t)).ravel()]
    y = np.r_[centre[1], (centre[1] + r * np.sin(t)).ravel()]
    disc = go.Mesh3d(
        **coordinates(np.stack([x, y, np.full_like(x, height - 0.003 * radius)], -1)),
        **dict(zip("ijk", _disc_faces(rings, around), strict=True)),
        intensity=np.round(100 * _shade(vertices - [0, 0, height], x, y, radius)).astype(int),
        cmin=0,
        cmax=100,
        colorscale=[[0, _FLOOR], [1, _SHADOW]],
        showscale=False,
        lighting={"ambient": 1, "diffuse": 0, "specular": 0, "fresnel": 0},
        hoverinfo="skip",
    )
    return [disc, _grid(centre, radius, height)]


def floor_size(vertices):
    """Return centre (2,) and radius of the floor below vertices (n, 3)."""
    low, high = vertices[:, :2].min(0), vertices[:, :2].max(0)
    centre = (low + high) / 2
    reach = np.linalg.norm(vertices[:, :2] - centre, axis=1).max()
    return np.round(centre, 3), round(max(1.12 * reach, 0.3 * np.ptp(vertices[:, 2])), 3)


def rim(vertices, height=0.0):
    """Return points (24, 3) on the edge of the floor below vertices, for the camera."""
    centre, radius = floor_size(vertices)
    t = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    return np.stack([centre[0] + radius * np.cos(t), centre[1] + radius * np.sin(t), np.full(24, height)], -1)


def joint_axes(arm, poses, vertices, bodies, *, beyond=0.16):
    """Return the joint axes outside the bodies that they pass through: dashes, arrowheads and numbers.

    poses: (n + 1, 4, 4), of the arm's bodies. vertices, bodies: (m, 3) and (m,), of the model at these poses. beyond:
    how far an axis extends beyond the bodies. Of what is returned, dashes (k, 3) are ends with a row of NaN after each
    pair; heads are Meshes where the axes point; words say where each number stands, with one name, such as "1, 3, 5,
    7", for axes on one line.
    """
    moved = poses[1:]
    p = (moved[:, :3, :3] @ joint_points(arm)[..., None])[..., 0] + moved[:, :3, 3]
    w = (moved[:, :3, :3] @ arm.screw_axes[:, :3, None])[..., 0]
    dashes, heads, words, left = [], [], {}, list(range(len(p)))
    while left:
        i = left[0]
        point, axis = p[i], w[i]
        group = [j for j in left if _on_one_line(point, axis, p[j], w[j], 1e-6 + 1e-3 * beyond)]
        left = [j for j in left if j not in group]
        carried = np.isin(bodies, [body for j in group for body in (j, j + 1)])
        if len(group) > 1:
            carried[:] = True  # the bodies between them, too
        own = vertices[carried] - point
        t = own @ axis
        near = t[np.linalg.norm(own - t[:, None] * axis, axis=1) < 0.45 * beyond]
        low, high = (near.min(), near.max()) if len(near) else (0, 0)
        for start, sign in ((low, -1), (high, 1)):
            for share in np.arange(0.03, 0.9, 0.27):
                dashes += [point + (start + sign * s * beyond) * axis for s in (share, share + 0.17)]
                dashes.append(np.full(3, np.nan))
        for sign in {float(np.sign(w[j] @ axis)) for j in group}:
            foot = point + ((high if sign > 0 else low) + sign * beyond) * axis
            cone = [(0.055 * beyond, 0), (0.055 * beyond, 0), (0.001, 0.2 * beyond)]
            heads.append(revolve(foot, sign * axis, cone, 8))
        words[", ".join(str(j + 1) for j in group)] = point + (high + 1.25 * beyond) * axis
    return np.array(dashes), heads, words


def _on_one_line(point, axis, other, direction, near):
    parallel = np.linalg.norm(np.cross(axis, direction)) < 1e-6
    return parallel and np.linalg.norm(np.cross(axis, other - point)) < near


def triad(body, pose, size, radius=None):
    """Return the arrows along the x, y and z axis of a frame (4, 4), as Parts of a body: red, green, blue."""
    radius = 0.055 * size if radius is None else radius
    return [Part(body, X_RED + k, arrow(pose[:3, 3], pose[:3, k], size, radius)) for k in range(3)]


def table(centre, radius, height=0.0):
    """Return the edge of a round table under the floor of that size: a Part of body 0."""
    low, high, r = -0.03, -0.006 * radius, radius
    edge = [(0.97 * r, low), (r, 0.8 * low), (r, high), (0.99 * r, high)]
    return Part(0, WHITE, revolve([*centre, height], [0, 0, 1], edge, 32))


def labels(words, settings, taken=(), *, colour=BLACK, size=15, aspect=1.0, scene="scene", gap=0.05):
    """Return words beside their points, moved in the picture so that they cover neither each other nor other points.

    words: {word: (3,)}. settings: the scene's, as fitted_scene returns them. taken: (n, 3), points to keep free.
    """
    if not words:
        return []
    at_eye, middle = eye(settings), eye({**settings, "camera": {"eye": settings["camera"]["center"]}})
    right, up, _ = camera_axes(at_eye - middle)
    step = gap * np.linalg.norm(at_eye - middle) * 2 * _FIELD_OF_VIEW
    metres = np.ptp(settings["xaxis"]["range"]) / settings["aspectratio"]["x"]
    points = np.array(list(words.values()), float)
    occupied = list(projected(np.concatenate([points, np.reshape(taken, (-1, 3))]), settings, aspect))
    placed = []
    for i, (word, point) in enumerate(zip(words, points, strict=True)):
        wide = 1 + 0.25 * (len(word) - 1)
        best, where = -np.inf, point
        for far in (0.9, 1.3, 1.8):
            for t in np.arange(8) * np.pi / 4:
                candidate = point + far * step * (wide * np.cos(t) * right + np.sin(t) * up)
                at = projected(candidate[None], settings, aspect)[0]
                others = np.array(occupied[:i] + occupied[i + 1 :] + placed)
                apart = min(np.linalg.norm(others - at, axis=1).min() if len(others) else 1, 2.2 * gap)
                score = apart - 0.03 * far - 10 * max(0, np.abs(at).max() - 0.97)
                if score > best + 1e-9:
                    best, where, spot = score, candidate, at
        placed.append(spot)
        # Towards the eye, so that no body hides it; where it is seen stays the same.
        points[i] = where + 0.12 * metres / np.linalg.norm(towards := at_eye - where) * towards
    return [words_at(points, words, colour, scene, size).update(textposition="middle center")]


def _shade(vertices, x, y, radius):
    """Return the shadow's darkness at points of the floor, 0 to 1; higher parts cast it paler, wider and farther."""
    size = radius / 0.6
    p = vertices[:: max(1, len(vertices) // 350)] / size
    x, y = x / size, y / size
    high = np.maximum(p[:, 2], 0)
    spread = 0.075 * (1 + 1.2 * high)
    d2 = (x[:, None] - p[:, 0] - 0.1 * high) ** 2 + (y[:, None] - p[:, 1] - 0.12 * high) ** 2
    dark = (np.exp(-0.9 * high - d2 / (2 * spread**2)) / spread**2).sum(-1) / len(p)
    return 1 - np.exp(-0.055 * dark)


def _disc_faces(rings, around):
    a = np.arange(around)
    b = (a + 1) % around
    faces = [np.stack([0 * a, 1 + a, 1 + b], -1)]
    for r in range(rings - 1):
        o, p = 1 + r * around, 1 + (r + 1) * around
        faces += [np.stack([o + a, p + a, p + b], -1), np.stack([o + a, p + b, o + b], -1)]
    return np.concatenate(faces).T


def _grid(centre, radius, height):
    step = next(s for s in (0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 100, 1e9) if radius / s < 5)
    lines = []
    for c in range(2):
        for t in step * np.arange(np.ceil((centre[c] - radius) / step), np.floor((centre[c] + radius) / step) + 1):
            half = np.sqrt(max((0.99 * radius) ** 2 - (t - centre[c]) ** 2, 0))
            if half > 0.15 * radius:
                ends = [(t, centre[1 - c] - half), (t, centre[1 - c] + half)]  # x and y, or y and x
                lines += [[end[c], end[1 - c], height] for end in ends] + [[np.nan] * 3]
    return line(lines, _GRID, 1.5)


def _xyz(values):
    return {c: round(float(v), 4) for c, v in zip("xyz", values, strict=True)}
