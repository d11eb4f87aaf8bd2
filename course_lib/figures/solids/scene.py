"""The surroundings of a robot: floor with grid and soft shadow, table, joint axes, named frames, and the camera."""

import numpy as np

from course_lib.figures.solids.meshes import arrow, revolve
from course_lib.figures.solids.model import X_RED, Part
from course_lib.figures.solids.shells import joint_points
from course_lib.figures.space import scene_name, words_at
from course_lib.figures.style import BLACK, PLOTLY_LAYOUT

_FIELD_OF_VIEW = np.tan(np.pi / 8)  # plotly's: 45 degrees from top to bottom
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
        notes.append({"text": title, "xanchor": "center", "showarrow": False, **at})
    margin = {"l": 0, "r": 0, "t": 30 if titles else 0, "b": 0}
    own = {"annotations": notes, "height": height, "margin": margin, "showlegend": False}
    return {**PLOTLY_LAYOUT, **own, **{scene_name(i): settings for i, settings in enumerate(scenes)}}


def floor_size(vertices):
    """Return centre (2,) and radius of the floor below vertices (n, 3)."""
    low, high = vertices[:, :2].min(0), vertices[:, :2].max(0)
    centre = (low + high) / 2
    reach = np.linalg.norm(vertices[:, :2] - centre, axis=1).max()
    return np.round(centre, 3), round(max(1.12 * reach, 0.3 * np.ptp(vertices[:, 2])), 3)


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


def _xyz(values):
    return {c: round(float(v), 4) for c, v in zip("xyz", values, strict=True)}
