"""The pictures in space of notebook 3: circles of the subproblems, and paths of orientations on the sphere.

Each function returns {"fig", "alt", "caption"}, for ``show(**...)``.
"""

import numpy as np
import plotly.graph_objects as go

from course_lib.figures.solids import Model, Part, draw, scene
from course_lib.figures.solids.meshes import arrow
from course_lib.figures.solids.model import AXIS, VIOLET, coordinates
from course_lib.figures.space import fixed_frame, line, name_at, points, sphere
from course_lib.figures.style import BLACK, BLUE, CRIMSON, GREEN, GREY, ORANGE
from course_lib.rotations import exp_so3, log_so3

CAMERA = np.array([1.3, 1.0, 0.7])
_TO_EYE = CAMERA / np.linalg.norm(CAMERA)


def rotated_onto(k, p, g, theta):
    """Return the picture of subproblem 1: the circle of p about k, and R(k, theta) p beside g.

    Parameters
    ----------
    k, p, g : array_like, shape (3,)
        A unit axis, the point that rotates, and the goal.
    theta : float
        The angle, in radians.

    Returns
    -------
    dict

    Examples
    --------
    >>> rotated_onto([0, 0, 1], [1, 0, 0], [0, 2, 0], 1.5)["alt"][-36:]
    'R p is 1.005 from g; p itself 2.236.'
    >>> rotated_onto([0, 0, 1], [1, 0, 0], [0, 2, 0], np.pi / 2)["caption"][:26]
    '$R\\\\,p$ is 1.000 m from $g$'
    """
    k, p, g = (np.asarray(x, float) for x in (k, p, g))
    end, reach = _rotated(k, theta, p), _reach([p, g])
    drawn = [*_circle(k, p, BLUE), points([p, g], 6, BLACK, "scene"), points([end], 6, CRIMSON, "scene")]
    drawn += [line([_foot(k, p), p], GREY, 3, "scene"), line([_foot(k, p), end], CRIMSON, 4, "scene")]
    gap, start = np.linalg.norm(end - g), np.linalg.norm(p - g)
    alt = f"A point p runs on a circle about the axis k, with a goal g. R p is {gap:.3f} from g; p itself {start:.3f}."
    nearest = min(np.linalg.norm(_rotated(k, t, p) - g) for t in np.linspace(-np.pi, np.pi, 721))
    caption = (
        f"$R\\,p$ is {gap:.3f} m from $g$; of 721 points of the circle the nearest is {nearest:.3f} m from it. The "
        "radii to $p$ and to $R\\,p$ enclose the angle $\\theta$; only what is perpendicular to $k$ decides it."
    )
    words = {BLACK: {"p": p, "g": g}, CRIMSON: {"R p": end}}
    return {"fig": _scene({"k": k}, drawn, words, reach), "alt": alt, "caption": caption}


def circles_meet(k1, k2, p1, p2, theta):
    """Return the picture of subproblem 2: the circles of p1 about k1 and of p2 about k2, and where they meet.

    Parameters
    ----------
    k1, k2, p1, p2 : array_like, shape (3,)
        Two unit axes, and the point that rotates about each.
    theta : array_like, shape (m, 2)
        The pairs of angles, in radians; points that they do not bring together are joined by a line.

    Returns
    -------
    dict

    Examples
    --------
    >>> x, y, z = np.eye(3)
    >>> circles_meet(z, x, x, z, [(np.pi / 2, -np.pi / 2)])["alt"][-28:]
    'k2; they touch in one point.'
    """
    reach = _reach([p1, p2])
    drawn = [*_circle(k1, p1, BLUE), *_circle(k2, p2, GREEN)]
    drawn += [points([p1], 6, BLUE, "scene"), points([p2], 6, GREEN, "scene")]
    meetings = {}
    for i, (t1, t2) in enumerate(theta):
        first, second = _rotated(k1, t1, p1), _rotated(k2, t2, p2)
        if np.linalg.norm(first - second) < 1e-6:
            meetings[f"{i + 1}"] = first
        drawn += [points([first, second], 6, CRIMSON, "scene"), line([first, second], CRIMSON, 5, "scene")]
    many = ("do not meet", "touch in one point", "meet in two points, marked 1 and 2")[min(len(meetings), 2)]
    alt = f"Two circles on one sphere, that of p1 about the axis k1 and that of p2 about k2; they {many}."
    caption = "Each point in which the circles meet gives one pair of angles $(\\theta_1, \\theta_2)$."
    words = {BLUE: {"p1": p1}, GREEN: {"p2": p2}, CRIMSON: meetings}
    return {"fig": _scene({"k1": k1, "k2": k2}, drawn, words, reach), "alt": alt, "caption": caption}


def circle_and_sphere(k, p, g, d, theta):
    """Return the picture of subproblem 3: the circle of p about k, and the sphere of radius d about g.

    Parameters
    ----------
    k, p, g : array_like, shape (3,)
        A unit axis, the point that rotates, and the goal.
    d : float
        The distance from the goal.
    theta : array_like, shape (m,)
        The angles at which the circle pierces the sphere, in radians.

    Returns
    -------
    dict

    Examples
    --------
    >>> x, y, z = np.eye(3)
    >>> circle_and_sphere(z, x, x, 1.0, [np.pi / 3, -np.pi / 3])["alt"][-40:]
    '1 about g at two points, marked 1 and 2.'
    """
    ball, reach = sphere(d), _reach([p, np.abs(g) + d])
    for c, centre in zip("xyz", g, strict=True):
        ball[c] = np.round(ball[c] + centre, 3)
    ball |= {"opacity": 0.45, "colorscale": [[0, ORANGE], [1, ORANGE]]}
    answers = _answers(k, p, theta)
    drawn = [go.Surface(**ball), *_circle(k, p, BLUE), points([p], 6, BLACK, "scene")]
    drawn += [points([g], 5, BLACK, "scene"), name_at(g + (d + 0.15 * reach) * _TO_EYE, "g", BLACK, "scene")]
    drawn += [points([*answers.values()], 6, CRIMSON, "scene")] if answers else []
    alt = f"The circle of p about the axis k pierces a sphere of radius {d:g} about g at {_count(theta)}."
    away = np.linalg.norm([_rotated(k, t, p) - g for t in np.linspace(0, 2 * np.pi, 721)], axis=1)
    found = [np.linalg.norm(_rotated(k, t, p) - g) for t in theta]
    caption = (
        f"Where the circle pierces the sphere, $R\\,p$ is at the wanted distance from $g$: {_listed(found)}. All "
        f"points of the circle are {away.min():.3f} to {away.max():.3f} m from $g$."
    )
    words = {BLACK: {"p": p}, CRIMSON: answers}
    return {"fig": _scene({"k": k}, drawn, words, reach, ball=(g, d)), "alt": alt, "caption": caption}


def circle_and_plane(k, h, p, d, theta):
    """Return the picture of subproblem 4: the circle of p about k, and the plane of the points at height d along h.

    Parameters
    ----------
    k, h, p : array_like, shape (3,)
        A unit axis, the direction of the height, and the point that rotates.
    d : float
        The height, h . R p = d.
    theta : array_like, shape (m,)
        The angles at which the circle pierces the plane, in radians.

    Returns
    -------
    dict

    Examples
    --------
    >>> x, y, z = np.eye(3)
    >>> circle_and_plane(z, x, x, 1.0, [0.0])["alt"][-36:]
    'lar to the direction h at one point.'
    """
    n = h / np.linalg.norm(h)
    a = np.cross(n, [1, 0, 0] if abs(n[0]) < 0.8 else [0, 1, 0])
    a = a / np.linalg.norm(a)
    b, middle, r = np.cross(n, a), d / np.linalg.norm(h) * n, 1.1 * np.linalg.norm(p)
    corners = [middle + r * (i * a + j * b) for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    x, y, z = np.round(corners, 3).T
    reach = _reach([p, *corners])
    faces = {"i": [0, 0], "j": [1, 2], "k": [2, 3]}
    plane = go.Mesh3d(x=x, y=y, z=z, **faces, color=ORANGE, opacity=0.45, hoverinfo="skip")
    answers = _answers(k, p, theta)
    drawn = [plane, *_circle(k, p, BLUE), points([p], 6, BLACK, "scene")]
    drawn += [points([*answers.values()], 6, CRIMSON, "scene")] if answers else []
    alt = f"The circle of p about the axis k pierces a plane perpendicular to the direction h at {_count(theta)}."
    found = [h @ _rotated(k, t, p) for t in theta]
    caption = (
        "The height of $R\\,p$ along $h$ goes up and down once in a revolution, so it takes each value between its "
        f"extremes twice. Here it is {_listed(found)}."
    )
    words = {BLACK: {"p": p}, CRIMSON: answers}
    return {"fig": _scene({"k": k, "h": n}, drawn, words, reach), "alt": alt, "caption": caption}


def six_axis_arm(arm, q):
    """Return a six-axis arm as a solid body with its joint axes, at joint angles q (6,) in radians.

    Examples
    --------
    >>> from course_lib.arms import panda
    >>> six_axis_arm(panda(), np.zeros(7))["alt"][:33]
    'A solid arm with 7 dashed, number'
    """
    high = arm.fk(q)[2, 3]
    alt = f"A solid arm with {arm.n} dashed, numbered joint axes; its flange is {high:.2f} m above the floor."
    caption = "Axes 2 and 3 are parallel; axes 4, 5 and 6 meet in the wrist center."
    return {"fig": draw(arm, q, axes=True, view=(0.6, 1.4, 0.5)), "alt": alt, "caption": caption}


def orientation_paths(tracks, duration):
    """Return where rotating frames take e_x, on a sphere.

    Parameters
    ----------
    tracks : dict
        Label to rotations, shape (n, 3, 3), evenly spaced in time, with the same first and last one.
    duration : float
        In seconds.

    Returns
    -------
    dict

    Examples
    --------
    >>> orientation_paths({"still": np.array([np.eye(3), np.eye(3)])}, 1.0)["alt"][-54:]
    'still on a path of length 0.00, at 0.00 to 0.00 rad/s.'
    """
    middle = np.concatenate(list(tracks.values()))[:, :, 0].mean(0)
    drawn = [go.Surface(**sphere(0.97)), *fixed_frame("scene", 1.2)]
    lengths, speeds = {}, []
    for colour, dash, (label, R) in zip((BLUE, CRIMSON, GREEN), ("solid", "dash", "dot"), tracks.items(), strict=False):
        drawn.append(
            line(R[:, :, 0], colour, 7, "scene", dash).update(name=label.replace("omega", "ω"), showlegend=True)
        )
        step = np.linalg.norm(log_so3(R[1:] @ R[:-1].mT), axis=1) / (duration / (len(R) - 1))
        length = np.linalg.norm(np.diff(R[:, :, 0], axis=0), axis=1).sum()
        lengths[label] = f"on a path of length {length:.2f}, at {step.min():.2f} to {step.max():.2f} rad/s"
        speeds.append(label.replace("omega", "$\\omega$") + f", {step.min():.2f} to {step.max():.2f} rad/s")
    ends = next(iter(tracks.values()))[[0, -1], :, 0]
    drawn.append(points(ends, 6, BLACK, "scene"))
    shown = np.concatenate([_places(trace) for trace in drawn])
    settings = scene.fitted_scene(shown, np.add(middle, [0, 0, 0.3]), fill=0.88)  # the eye is in front of the paths
    taken = [_places(trace) for trace in drawn if trace.type == "scatter3d"]
    taken += [np.linspace(1, 1.2, 9)[:, None] * e for e in np.eye(3)]
    names = scene.labels(dict(zip(("start", "end"), ends, strict=True)), settings, np.concatenate(taken), size=16)
    drawn += [trace.update(_in_front(_places(trace), settings, (0, 0, 0), 1.0)) for trace in names]
    legend = {"orientation": "h", "x": 0.5, "xanchor": "center", "y": 1.0, "yanchor": "bottom"}
    layout = {**scene.layout([settings], height=440), "showlegend": True, "legend": legend}
    layout["margin"] = {**layout["margin"], "t": 30}
    fig = go.Figure(drawn, layout=layout).update_traces(selector={"showlegend": None}, showlegend=False)
    said = "; ".join(f"{label} {told}" for label, told in lengths.items())
    alt = f"Where e_x goes on the unit sphere, in motions between the same two orientations: {said}."
    caption = (
        "With constant $\\omega$ every point runs on a circle about $\\omega$; with constant rates it does not. "
        f"The bodies rotate at: {'; '.join(speeds)}."
    )
    return {"fig": fig, "alt": alt, "caption": caption}


def _scene(axes, drawn, words, reach, ball=((0, 0, 0), 0)):
    """A figure of what is drawn, with axes {name: direction} and words {colour: {word: point}} clear of all lines.

    ball: centre and radius of a sphere that must not hide the words.
    """
    ends = {name: reach * np.asarray(k) for name, k in axes.items()}
    arrows = Model.of([Part(0, VIOLET, arrow(-end, end, 2 * reach, 0.015 * reach)) for end in ends.values()])
    taken = [_places(trace) for trace in drawn if trace.type == "scatter3d"]
    taken += [np.linspace(-1, 1, 41)[:, None] * end for end in ends.values()]
    drawn = [*drawn, arrows.trace([np.eye(4)])]
    settings = scene.fitted_scene(np.concatenate([_places(trace) for trace in drawn]), CAMERA, fill=0.82)
    for colour, at in {AXIS: ends, **words}.items():
        names = scene.labels(at, settings, np.concatenate(taken), colour=colour, size=16)
        taken += [_places(trace) for trace in names]
        drawn += [trace.update(_in_front(_places(trace), settings, *ball)) for trace in names]
    return go.Figure(drawn, layout=scene.layout([settings], height=460))


def _in_front(at, settings, centre, radius):
    """Coordinates of points (n, 3), those behind a sphere moved towards the eye: they are seen at the same place."""
    ranges = np.array([settings[f"{c}axis"]["range"] for c in "xyz"])
    metres = np.ptp(ranges[0]) / settings["aspectratio"]["x"]
    towards = ranges.mean(1) + metres * np.array([settings["camera"]["eye"][c] for c in "xyz"]) - at
    towards /= np.linalg.norm(towards, axis=1, keepdims=True)
    centre = np.asarray(centre, float)
    along = ((centre - at) * towards).sum(1)
    half = np.sqrt(np.maximum(radius**2 - ((centre - at - along[:, None] * towards) ** 2).sum(1), 0))
    return coordinates(at + np.where(half > 0, np.maximum(along + half + 0.1 * radius, 0), 0)[:, None] * towards)


def _places(trace):
    return np.stack([np.ravel(np.array(trace[c], float)) for c in "xyz"], -1)


def _reach(far):
    return 1.15 * max(np.linalg.norm(point) for point in far)


def _rotated(k, theta, p):
    return exp_so3(theta * np.asarray(k, float)) @ p


def _foot(k, p):
    return np.dot(k, p) * np.asarray(k)


def _circle(k, p, colour):
    return [line([_rotated(k, t, p) for t in np.linspace(0, 2 * np.pi, 73)], colour, 5, "scene")]


def _answers(k, p, theta):
    return {f"{i + 1}": _rotated(k, t, p) for i, t in enumerate(theta)}


def _listed(lengths):
    return " and ".join(f"{length:.3f} m" for length in lengths) or "nowhere"


def _count(theta):
    return {0: "no point", 1: "one point", 2: "two points, marked 1 and 2"}[len(theta)]
