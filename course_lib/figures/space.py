"""Pieces of figures in space, made with plotly: points, lines, words, a sphere."""

import numpy as np
import plotly.graph_objects as go

from course_lib.figures.style import GREY

_OFF_TIES = 3.1e-7  # lengths of models are round numbers: one machine would round a tie up, another down


def scene_name(i):
    """Return plotly's name of the i-th scene, counted from 0."""
    return f"scene{i + 1}" if i else "scene"


def points(at, size, colour, scene="scene"):
    """Return dots at points, shape (n, 3), of a size in pixels."""
    marker = {"size": size, "color": colour}
    return go.Scatter3d(**coordinates(at), mode="markers", marker=marker, hoverinfo="skip", scene=scene)


def line(through, colour, width, scene="scene", dash="solid"):
    """Return a line through points, shape (n, 3), of a width in pixels; a row of NaN interrupts it."""
    look = {"color": colour, "width": width} | ({"dash": dash} if dash != "solid" else {})
    return go.Scatter3d(**coordinates(through), mode="lines", line=look, hoverinfo="skip", scene=scene)


def words_at(at, words, colour, scene="scene", size=16):
    """Return words at points, shape (n, 3), of a size in pixels."""
    font = {"color": colour, "size": size}
    return go.Scatter3d(**coordinates(at), mode="text", text=list(words), textfont=font, hoverinfo="skip", scene=scene)


def fixed_frame(scene, size):
    """Return traces of the fixed frame: three grey axes of a length, then their names."""
    axes = [line([np.zeros(3), size * e], GREY, 3, scene) for e in np.eye(3)]
    return [*axes, words_at(1.08 * size * np.eye(3), "xyz", GREY, scene, 14)]


def sphere(radius):
    """Return the arguments of a plotly surface: a pale sphere about the origin."""
    polar, around = np.meshgrid(np.linspace(0, np.pi, 17), np.linspace(0, 2 * np.pi, 33))
    at = radius * np.array([np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around), np.cos(polar)])
    return {
        **dict(zip("xyz", np.round(at, 3), strict=True)),
        "colorscale": [[0, "#ececec"], [1, "#ececec"]],
        "showscale": False,
        "hoverinfo": "skip",
        "lighting": {"ambient": 0.9, "diffuse": 0.2, "specular": 0, "fresnel": 0},
    }


def coordinates(points):
    """Return points (n, 3) as plotly's x, y and z, to a tenth of a millimetre, the same on every machine."""
    return dict(zip("xyz", np.round(np.asarray(points, float) + _OFF_TIES, 4).T, strict=True))
