"""The pictures of notebook 3: the subproblems' circles, turns on the sphere, and what step size and damping do."""

import numpy as np
import plotly.graph_objects as go
from matplotlib.colors import TwoSlopeNorm

from course_lib.figures.solids import Model, Part, scene
from course_lib.figures.solids.meshes import arrow
from course_lib.figures.solids.model import AXIS, VIOLET
from course_lib.figures.space import fixed_frame, line, name_at, points, space_layout, sphere
from course_lib.figures.style import BLACK, BLUE, COLOURS, CRIMSON, GREEN, GREY, ORANGE, plane_figure
from course_lib.rotations import exp_so3

CAMERA = (1.3, 1.0, 0.7)


def turn_onto(k, p, q, theta):
    """Return subproblem 1: the circle of p about k, and where the turn by theta takes p, beside q."""
    end = _turned(k, theta, p)
    drawn = [*_circle(k, p, BLUE), *_named({"p": p, "q": q}), *_named({"R p": 1.0 * end}, CRIMSON)]
    drawn += [line([_foot(k, p), p], GREY, 3, "scene"), line([_foot(k, p), end], CRIMSON, 4, "scene")]
    return _scene([k], ["k"], drawn, [p, q])


def circles_meet(k1, k2, p1, p2, theta):
    """Return subproblem 2: the circles of p1 about k1 and of p2 about k2, and where they meet.

    theta: (m, 2), the answers.
    """
    drawn = [*_circle(k1, p1, BLUE), *_circle(k2, p2, GREEN), *_named({"p1": p1, "p2": p2})]
    for i, (t1, t2) in enumerate(theta):
        first, second = _turned(k1, t1, p1), _turned(k2, t2, p2)
        name = f"{i + 1}" if np.linalg.norm(first - second) < 1e-6 else ""
        drawn += [points([first, second], 6, CRIMSON, "scene"), line([first, second], CRIMSON, 5, "scene")]
        drawn.append(name_at(1.12 * first, name, CRIMSON, "scene"))
    return _scene([k1, k2], ["k1", "k2"], drawn, [p1, p2])


def circle_and_sphere(k, p, q, d, theta):
    """Return subproblem 3: the circle of p about k, and the sphere of radius d about q that it pierces."""
    ball = sphere(d)
    for c, centre in zip("xyz", q, strict=True):
        ball[c] = np.round(ball[c] + centre, 3)
    ball |= {"opacity": 0.45, "colorscale": [[0, ORANGE], [1, ORANGE]]}
    drawn = [go.Surface(**ball), *_circle(k, p, BLUE), *_named({"p": p, "q": q}), *_answers(k, p, theta)]
    return _scene([k], ["k"], drawn, [p, np.abs(q) + d])


def circle_and_plane(k, h, p, d, theta):
    """Return subproblem 4: the circle of p about k, and the plane of the points at height d along h."""
    n = h / np.linalg.norm(h)
    a = np.cross(n, [1, 0, 0] if abs(n[0]) < 0.8 else [0, 1, 0])
    a = a / np.linalg.norm(a)
    b, middle, r = np.cross(n, a), d / np.linalg.norm(h) * n, 1.1 * np.linalg.norm(p)
    corners = [middle + r * (i * a + j * b) for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    x, y, z = np.round(corners, 3).T
    faces = {"i": [0, 0], "j": [1, 2], "k": [2, 3]}
    plane = go.Mesh3d(x=x, y=y, z=z, **faces, color=ORANGE, opacity=0.45, hoverinfo="skip")
    drawn = [plane, *_circle(k, p, BLUE), *_named({"p": p}), *_answers(k, p, theta)]
    return _scene([k, n], ["k", "h"], drawn, corners)


def turns_on_sphere(tracks):
    """Return where turning frames take e_x, on a sphere. tracks: {label: R (n, 3, 3)}, the same ends."""
    middle = np.concatenate(list(tracks.values()))[:, :, 0].mean(0)
    layout = space_layout([""], np.add(middle, [0, 0, 0.3]), distance=1.5)  # the eye stands before the tracks
    drawn = [go.Surface(**sphere(0.97)), *fixed_frame("scene", 1.2)]
    for colour, dash, (label, R) in zip((BLUE, CRIMSON, GREEN), ("solid", "dash", "dot"), tracks.items(), strict=False):
        drawn.append(line(R[:, :, 0], colour, 7, "scene", dash).update(name=label, showlegend=True))
    ends = next(iter(tracks.values()))[[0, -1], :, 0]
    drawn.append(points(ends, 6, BLACK, "scene"))
    drawn += [name_at(1.2 * end, name, BLACK, "scene") for name, end in zip(("start", "end"), ends, strict=True)]
    legend = {"orientation": "h", "x": 0.5, "xanchor": "center", "y": 1.0, "yanchor": "bottom"}
    return go.Figure(drawn, layout={**layout, "annotations": [], "showlegend": True, "legend": legend}).update_traces(
        selector={"showlegend": None}, showlegend=False
    )


def columns_and_ellipse(points, J, scale=0.3):
    """Return {"fig", "alt"}: a planar arm, the columns of its Jacobian as arrows, and the manipulability ellipse.

    points: (n + 1, 2), base first. J: (2, n). scale: metres drawn for one metre of J.
    """
    fig, (ax,) = plane_figure(6.0, 4.6)
    ax.plot(*points.T, "-o", color=GREY, linewidth=3, markersize=7)
    tip = points[-1]
    for j, (colour, column) in enumerate(zip(COLOURS, J.T, strict=False)):
        ax.annotate("", tip + scale * column, tip, arrowprops={"arrowstyle": "-|>", "color": colour, "linewidth": 2})
        ax.annotate(f"$J_{j + 1}$", tip + scale * column * 1.08, color=colour, ha="center", va="center")
    U, s, _ = np.linalg.svd(J)
    t = np.linspace(0, 2 * np.pi, 121)
    ax.plot(*(tip[:, None] + scale * U @ (s[:, None] * [np.cos(t), np.sin(t)])), color=BLACK, linewidth=1.5)
    ax.set(aspect="equal", xlabel="x (m)", ylabel="y (m)")
    ax.margins(0.12)
    alt = (
        f"A planar arm with its tip at ({tip[0]:.1f}, {tip[1]:.1f}) m. From the tip, {J.shape[1]} arrows of length "
        + ", ".join(f"{length:.1f}" for length in np.linalg.norm(J, axis=0))
        + f" m show the Jacobian's columns; an ellipse with half axes of {s[0]:.1f} and {s[1]:.1f} m surrounds the tip."
    )
    return {"fig": fig, "alt": alt}


def gains(epsilons, values):
    """Return the factor s/(s^2 + eps) of each damping over the singular value s, with its largest value marked.

    values: {label: s}, singular values to point out.
    """
    s = np.linspace(0.01, 4.2, 300)
    fig, (ax,) = plane_figure(7.2, 3.6)
    ax.plot(s, 1 / s, color=BLACK, linewidth=1, label="no damping: 1/s")
    for colour, style, eps in zip(COLOURS, ("-", "--", ":", "-."), epsilons, strict=False):
        ax.plot(s, s / (s**2 + eps), color=colour, linestyle=style, linewidth=2, label=rf"$\epsilon$ = {eps:g}")
        if np.sqrt(eps) < s[-1]:
            ax.plot(np.sqrt(eps), 1 / (2 * np.sqrt(eps)), "o", color=colour)
    for label, value in values.items():
        ax.axvline(value, color=GREY, linewidth=1)
        ax.annotate(label, (value, 1.5), xytext=(4, 0), textcoords="offset points", color=GREY)
    ax.set(ylim=(0, 2.2), xlabel="singular value s of the Jacobian (m)", ylabel="joint step per error (rad/m)")
    ax.legend(frameon=False, loc="upper center", ncols=2)
    return fig


def step_map(alphas, epsilons, errors, largest, runs):
    """Return the error left after a run, for step sizes and dampings, with the limit 2 (1 + eps/s1^2).

    errors: (len(alphas), len(epsilons)), metres. largest: s1, the largest singular value at the goal. runs: the pairs
    (alpha, eps) to mark.
    """
    fig, (ax,) = plane_figure(7.2, 4.4)
    levels = TwoSlopeNorm(-2, -8, 0.5)
    image = ax.pcolormesh(alphas, epsilons, np.log10(errors.T), cmap="RdBu_r", norm=levels, rasterized=True)
    limit = 2 * (1 + np.array(epsilons) / largest**2)
    ax.plot(limit, epsilons, color=BLACK, linewidth=2, label=r"$\alpha = 2(1 + \epsilon/s_1^2)$")
    ax.plot(*np.transpose(runs), "o", color=BLACK, markerfacecolor="white", markersize=8, label="the report's runs")
    ax.set(xscale="log", yscale="log", xlim=(alphas[0], alphas[-1]), ylim=(epsilons[0], epsilons[-1]))
    ax.set(xlabel=r"step size $\alpha$", ylabel=r"damping $\epsilon$ (m$^2$)")
    ax.legend(loc="lower left")
    fig.colorbar(image, ax=ax, label="log10 of the distance left (m)")
    return fig


def _scene(axes, names, drawn, far):
    reach = max(np.linalg.norm(point) for point in far)
    ends = [reach * np.asarray(k) for k in axes]
    arrows = Model.of([Part(0, VIOLET, arrow(-end, end, 2 * reach, 0.015 * reach)) for end in ends])
    drawn = [*drawn, arrows.trace([np.eye(4)])]
    drawn += [name_at(1.1 * end, name, AXIS, "scene") for end, name in zip(ends, names, strict=True)]
    points = [np.stack([np.ravel(np.array(trace[c], float)) for c in "xyz"], -1) for trace in drawn]
    settings = scene.fitted_scene(np.concatenate(points), CAMERA, fill=0.8)
    return go.Figure(drawn, layout=scene.layout([settings], height=420))


def _turned(k, theta, p):
    return exp_so3(theta * np.asarray(k, float)) @ p


def _foot(k, p):
    return np.dot(k, p) * np.asarray(k)


def _circle(k, p, colour):
    return [line([_turned(k, t, p) for t in np.linspace(0, 2 * np.pi, 73)], colour, 5, "scene")]


def _named(places, colour=BLACK):
    dots = points(list(places.values()), 5, colour, "scene")
    return [dots, *(name_at(1.13 * np.asarray(place), name, colour, "scene") for name, place in places.items())]


def _answers(k, p, theta):
    return _named({f"{i + 1}": _turned(k, t, p) for i, t in enumerate(theta)}, CRIMSON)
