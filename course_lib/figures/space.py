"""Pieces of pictures in space, made with plotly: scenes, points, lines, vectors with names."""

import numpy as np
import plotly.graph_objects as go

from course_lib.figures.style import GREY, PLOTLY_LAYOUT


def space_layout(names, camera, half=1.3, height=420, distance=1.75):
    """Return the plotly layout of scenes in space side by side, each with its title.

    Parameters
    ----------
    names : sequence of str
        The titles, one for each scene.
    camera : array_like, shape (3,)
        The direction from the middle of the scene to the eye.
    half : float, optional
        Each scene shows the cube from -half to half.
    height : int, optional
        In pixels.
    distance : float, optional
        From the middle to the eye, in edges of the cube: at 1.75 nothing is cropped; nearer is right where the corners
        are empty.

    Returns
    -------
    dict

    Examples
    --------
    >>> layout = space_layout(["before", "after"], (1, 1, 1))
    >>> [note["text"] for note in layout["annotations"]], layout["scene2"]["domain"]["x"]
    (['before', 'after'], [0.5, 1.0])
    """
    hidden = {"range": [-half, half], "visible": False}  # the pictures draw the axes they need
    scenes, titles, width = {}, [], 1 / len(names)
    scale = distance / sum(c * c for c in camera) ** 0.5
    for i, name in enumerate(names):
        scenes[scene_name(i)] = {
            **{f"{c}axis": hidden for c in "xyz"},
            "aspectmode": "cube",
            "domain": {"x": [i * width, (i + 1) * width], "y": [0, 1]},
            "camera": {"eye": {c: scale * value for c, value in zip("xyz", camera, strict=True)}},
        }
        where = {
            "x": (i + 0.5) * width,
            "y": 1,
            "xanchor": "center",
            "yanchor": "bottom",
            "xref": "paper",
            "yref": "paper",
        }
        titles.append({"text": name, "showarrow": False, **where})
    return {**PLOTLY_LAYOUT, **scenes, "annotations": titles, "height": height, "showlegend": False}


def scene_name(i):
    """Return plotly's name of the i-th scene, counted from 0.

    Examples
    --------
    >>> scene_name(0), scene_name(1)
    ('scene', 'scene2')
    """
    return f"scene{i + 1}" if i else "scene"


def points(at, size, colour, scene):
    """Return dots at points, shape (n, 3), of a size in pixels.

    Examples
    --------
    >>> points([[0, 0, 1]], 5, "black", "scene").z
    array([1.])
    """
    marker = {"size": size, "color": colour}
    return go.Scatter3d(**_xyz(at), mode="markers", marker=marker, hoverinfo="skip", scene=scene)


def line(through, colour, width, scene, dash="solid"):
    """Return a line through points, shape (n, 3), of a width in pixels.

    Examples
    --------
    >>> line([[0, 0, 0], [1, 2, 3]], "black", 3, "scene").y
    array([0., 2.])
    """
    look = {"color": colour, "width": width} | ({"dash": dash} if dash != "solid" else {})
    return go.Scatter3d(**_xyz(through), mode="lines", line=look, hoverinfo="skip", scene=scene)


def name_at(point, name, colour, scene):
    """Return a word at a point, shape (3,).

    Examples
    --------
    >>> name_at([0, 0, 1], "z", "black", "scene").text
    ('z',)
    """
    font = {"color": colour, "size": 16}
    return go.Scatter3d(**_xyz([point]), mode="text", text=[name], textfont=font, hoverinfo="skip", scene=scene)


def fixed_frame(scene, size):
    """Return traces of the fixed frame: three grey axes of a length, then their names.

    Examples
    --------
    >>> len(fixed_frame("scene", 1.0))
    4
    """
    axes = [line([np.zeros(3), size * e], GREY, 3, scene) for e in np.eye(3)]
    font = {"color": GREY, "size": 14}
    names = go.Scatter3d(
        **_xyz(1.08 * size * np.eye(3)), mode="text", text=list("xyz"), textfont=font, hoverinfo="skip", scene=scene
    )
    return [*axes, names]


def segments(starts, ends, colour, width, scene):
    """Return one trace of many separate segments, from `starts` to `ends`, each of shape (n, 3).

    NaN (null in JSON) after each segment lifts the pen.

    Examples
    --------
    >>> segments(np.zeros((2, 3)), np.ones((2, 3)), "black", 2, "scene").x
    array([ 0.,  1., nan,  0.,  1., nan])
    """
    gap = np.full_like(starts, np.nan)
    return line(np.stack([starts, ends, gap], 1).reshape(-1, 3), colour, width, scene)


def sphere(radius, n=17):
    """Return the arguments of a plotly surface: a pale sphere about the origin, with n circles of latitude.

    Examples
    --------
    >>> float(sphere(2.0)["z"].max())
    2.0
    """
    polar, around = np.meshgrid(np.linspace(0, np.pi, n), np.linspace(0, 2 * np.pi, 2 * n - 1))
    height = np.cos(polar)
    ring = np.sin(polar)
    x, y = ring * np.cos(around), ring * np.sin(around)
    return {
        **dict(zip("xyz", np.round([radius * x, radius * y, radius * height], 3), strict=True)),
        "colorscale": [[0, "#ececec"], [1, "#ececec"]],
        "showscale": False,
        "hoverinfo": "skip",
        "lighting": {"ambient": 0.9, "diffuse": 0.2, "specular": 0, "fresnel": 0},
    }


def _xyz(at):
    return dict(zip("xyz", np.round(np.asarray(at, float), 3).T, strict=True))
