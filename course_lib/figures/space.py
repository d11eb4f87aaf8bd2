"""Pieces of pictures in space, made with plotly: scenes, points, lines, vectors with names."""

import numpy as np
import plotly.graph_objects as go

from course_lib.figures.style import GREY, PLOTLY_LAYOUT


def space_layout(names, camera, half=1.3, height=420, distance=1.75):
    """Return the plotly layout of 3D scenes side by side, each the cube from -half to half, with a title each.

    names: titles. camera: the direction the eye looks from. height: pixels. distance: of the eye, in edges of the cube;
    at 1.75 nothing is cropped, nearer is right where the corners are empty.
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
        place = {
            "x": (i + 0.5) * width,
            "y": 1,
            "xanchor": "center",
            "yanchor": "bottom",
            "xref": "paper",
            "yref": "paper",
        }
        titles.append({"text": name, "showarrow": False, **place})
    return {**PLOTLY_LAYOUT, **scenes, "annotations": titles, "height": height, "showlegend": False}


def scene_name(i):
    """Return plotly's name of the i-th scene, counted from 0."""
    return f"scene{i + 1}" if i else "scene"


def points(places, size, colour, scene):
    """Dots at `places` (n, 3)."""
    marker = {"size": size, "color": colour}
    return go.Scatter3d(**_xyz(places), mode="markers", marker=marker, hoverinfo="skip", scene=scene)


def line(places, colour, width, scene, dash="solid"):
    """A line through `places` (n, 3)."""
    look = {"color": colour, "width": width} | ({"dash": dash} if dash != "solid" else {})
    return go.Scatter3d(**_xyz(places), mode="lines", line=look, hoverinfo="skip", scene=scene)


def name_at(place, name, colour, scene):
    """A word at a place (3,)."""
    font = {"color": colour, "size": 16}
    return go.Scatter3d(**_xyz([place]), mode="text", text=[name], textfont=font, hoverinfo="skip", scene=scene)


def fixed_frame(scene, size):
    """The three grey axes, then their names."""
    axes = [line([np.zeros(3), size * e], GREY, 3, scene) for e in np.eye(3)]
    font = {"color": GREY, "size": 14}
    names = go.Scatter3d(
        **_xyz(1.08 * size * np.eye(3)), mode="text", text=list("xyz"), textfont=font, hoverinfo="skip", scene=scene
    )
    return [*axes, names]


def segments(starts, ends, colour, width, scene):
    """Many separate segments in one trace: NaN (null in JSON) lifts the pen."""
    gap = np.full_like(starts, np.nan)
    return line(np.stack([starts, ends, gap], 1).reshape(-1, 3), colour, width, scene)


def sphere(radius, n=17):
    """The arguments of a pale surface, a sphere about the origin."""
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


def _xyz(places):
    return dict(zip("xyz", np.round(np.asarray(places, float), 3).T, strict=True))
