"""The dimensioned drawings of notebook 4: the iiwa and the UR5e in three views, for reading their screw axes."""

import numpy as np
from matplotlib.figure import Figure

from course_lib.figures.display import Picture
from course_lib.figures.style import BLACK, FRAME_COLOURS, GREY

# Corners of each arm at joint angles zero, from the base to the flange, and its dimensions in millimetres: the view in
# which each is drawn, its ends, and the offset of the dimension line from them.
_TOP, _SIDE, _END = "top", "side", "end"
_ARMS = {
    "iiwa": {
        "corners": [(0, 0, 0), (0, 0, 0.36), (0, 0, 0.78), (0, 0, 1.18), (0, 0, 1.301)],
        "dimensions": [
            (_SIDE, (0, 0), (0, 0.36), 0.22),
            (_SIDE, (0, 0.36), (0, 0.78), 0.22),
            (_SIDE, (0, 0.78), (0, 1.18), 0.22),
            (_SIDE, (0, 1.18), (0, 1.301), 0.22),
        ],
        "flange": np.eye(3),
    },
    "ur5e": {
        "corners": [
            (0, 0, 0),
            (0, 0, 0.1625),
            (-0.425, 0, 0.1625),
            (-0.8172, 0, 0.1625),
            (-0.8172, -0.1333, 0.1625),
            (-0.8172, -0.1333, 0.0628),
            (-0.8172, -0.2329, 0.0628),
        ],
        "dimensions": [
            (_SIDE, (0, 0), (0, 0.1625), 0.18),
            (_SIDE, (-0.425, 0.1625), (0, 0.1625), 0.14),
            (_SIDE, (-0.8172, 0.1625), (-0.425, 0.1625), 0.14),
            (_SIDE, (-0.8172, 0.0628), (-0.8172, 0.1625), -0.12),
            (_TOP, (-0.8172, -0.1333), (-0.8172, 0), -0.1),
            (_TOP, (-0.8172, -0.2329), (-0.8172, -0.1333), -0.1),
        ],
        "flange": np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]]),
    },
}
_VIEWS = {_TOP: (0, 1, 2, "from above"), _SIDE: (0, 2, 1, "from the side"), _END: (1, 2, 0, "from the end")}
_MARGIN = 0.24  # metres around the arm in each view
_TOWARDS = {_TOP: 1, _SIDE: -1, _END: 1}  # the sign of the hidden axis's direction that points at the viewer


def three_views(name, arm):
    """Return a dimensioned drawing of an arm at joint angles zero, from above, from the side and from the end.

    Parameters
    ----------
    name : str
        "iiwa" or "ur5e".
    arm : SerialArm
        Whose screw axes are drawn.

    Returns
    -------
    dict
        "fig", "alt" and "caption", for show.

    Examples
    --------
    >>> from course_lib.arms import iiwa14
    >>> len(three_views("iiwa", iiwa14())["fig"].axes)
    3
    """
    data = _ARMS[name]
    corners = np.array(data["corners"])
    size = np.ptp(corners, axis=0) + 2 * _MARGIN
    layout = [[_SIDE, _END, _TOP]] if name == "iiwa" else [[_SIDE], [_TOP], [_END]]
    widths = [size[_VIEWS[view][0]] for view in layout[0]]
    heights = [size[_VIEWS[row[0]][1]] for row in layout]
    scale = 6.4 / sum(widths) if name == "ur5e" else 3.4
    size = (scale * sum(widths) + 1.2, scale * sum(heights) + 0.8)
    fig = Figure(figsize=size, layout="constrained", facecolor="white")
    for view, ax in fig.subplot_mosaic(layout, width_ratios=widths, height_ratios=heights).items():
        _draw_view(ax, view, corners, arm, data)
    caption = "A cross is an arrow that points away from you, a dot one that points at you."
    return Picture(fig, _told(name, arm, data), caption)


def _draw_view(ax, view, corners, arm, data):
    i, j, k, words = _VIEWS[view]
    ax.plot(corners[:, i], corners[:, j], color="#c9d3dc", linewidth=11, solid_capstyle="round", zorder=1)
    ax.plot(corners[:, i], corners[:, j], color=GREY, linewidth=1, zorder=2)
    straight = np.ptp(corners[:, [i, j]]) == 0  # seen along the arm: its base frame is drawn beside it
    taken = _draw_frame(ax, (-0.17, -0.15) if straight else (0, 0), np.eye(3), (i, j), "s", 0.1)
    if (data["flange"] != np.eye(3)).any():
        taken += _draw_frame(ax, corners[-1][[i, j]], data["flange"], (i, j), "b", 0.12)
    elif not straight:
        x, y = corners[-1][[i, j]]
        ax.text(x, y + 0.19, "b, parallel to s", fontsize=9, style="italic", ha="center")
    seen = {}
    for number, S in enumerate(arm.screw_axes, 1):
        omega, point = S[:3], _on_link(S, corners)
        colour = FRAME_COLOURS[int(np.abs(omega).argmax())]
        at = point[[i, j]]
        if abs(omega[k]) > 0.9:
            towards = omega[k] * _TOWARDS[view] > 0
            _draw_end_on(ax, at, towards, colour)
            seen.setdefault((*at.round(3), 0, 0), []).append((number, colour))
        else:
            direction = omega[[i, j]]
            ax.annotate(
                "",
                at + 0.13 * direction,
                at - 0.07 * direction,
                arrowprops={"arrowstyle": "-|>", "color": colour, "linewidth": 1.6, "linestyle": "-"},
                zorder=4,
            )
            taken += [at + along * direction for along in np.linspace(-0.07, 0.13, 6)]
            seen.setdefault((*(at + 0.13 * direction).round(3), *direction), []).append((number, colour))
    for (x, y, dx, dy), numbers in seen.items():
        text = ", ".join(str(number) for number, _ in numbers)
        beside = _free_spot(np.array([x, y]), np.array([dx, dy]), taken) if dx or dy else None
        where = beside if beside is not None else (x + 0.02 + 0.03 * len(numbers), y + 0.05)
        taken.append(np.array(where))
        ax.text(*where, text, color=numbers[0][1], fontweight="bold", ha="center", va="center")
    for where, start, end, beside in data["dimensions"]:
        if where == view:
            _draw_dimension(ax, np.array(start), np.array(end), beside)
    ax.set(aspect="equal", xlabel=f"{'xyz'[i]}", ylabel=f"{'xyz'[j]}", title=words, xticks=[], yticks=[])
    low, high = corners.min(0) - _MARGIN, corners.max(0) + _MARGIN
    ax.set(xlim=(low[i], high[i]), ylim=(low[j], high[j]))
    ax.spines[:].set_visible(False)


def _on_link(S, corners):
    """The point of a screw axis at which its joint is drawn: the last corner of the arm that lies on it."""
    off = [np.linalg.norm(np.cross(S[:3], corner) + S[3:]) for corner in corners[:-1]]
    return corners[max(i for i, distance in enumerate(off) if distance < 1e-9)]


def _draw_end_on(ax, at, towards, colour):
    ax.plot(*at, "o", markersize=11, markerfacecolor="white", markeredgecolor=colour, markeredgewidth=1.8, zorder=5)
    ax.plot(*at, "." if towards else "x", color=colour, markersize=6, markeredgewidth=1.8, zorder=6)


def _free_spot(tip, direction, taken):
    """Where an arrow's number stands: beyond its tip if nothing is drawn there, otherwise beside it."""
    across = np.array([-direction[1], direction[0]])
    spots = [tip + 0.035 * direction]
    spots += [tip - back * direction + side * across for back in (0.01, 0.09) for side in (0.045, -0.045)]
    return max(spots, key=lambda spot: min(0.034, np.linalg.norm(np.array(taken) - spot, axis=1).min()))


def _draw_frame(ax, origin, R, plane, name, size):
    """Draw a frame's axes and letters; return the points that they cover."""
    covered = []
    for axis, colour in enumerate(FRAME_COLOURS):
        direction = R[list(plane), axis]
        if np.abs(direction).max() > 0.5:
            tip = origin + size * direction
            ax.annotate("", tip, origin, arrowprops={"arrowstyle": "->", "color": colour, "linewidth": 1.2}, zorder=7)
            ax.text(*(origin + 1.3 * size * direction), "xyz"[axis], color=colour, fontsize=9, ha="center", va="center")
            covered += [origin + along * size * direction for along in (0.25, 0.5, 0.75, 1, 1.3)]
    x, y = origin
    ax.text(x - 0.045, y - 0.05, name, color=BLACK, fontsize=11, style="italic")
    return [*covered, np.array([x - 0.025, y - 0.035])]


def _draw_dimension(ax, start, end, beside):
    vertical = abs(end[0] - start[0]) < 1e-9
    offset = np.array([beside, 0]) if vertical else np.array([0, beside])
    for point in (start, end):
        ax.plot(*zip(point, point + 1.1 * offset, strict=True), color=BLACK, linewidth=0.5)
    style = {"arrowstyle": "<->", "color": BLACK, "linewidth": 0.8, "shrinkA": 0, "shrinkB": 0}
    ax.annotate("", end + offset, start + offset, arrowprops=style)
    length = 1000 * np.abs(end - start).max()
    middle = (start + end) / 2 + offset * (1.12 if vertical else 1.0)
    place = {"va": "center", "ha": "left" if beside > 0 else "right"} if vertical else {"va": "bottom", "ha": "center"}
    ax.text(*middle, f"{length:g}", fontsize=9, **place)


def _told(name, arm, data):
    """The drawing in words: the arm's path from the base to the flange, its dimensions and arrows."""
    steps = np.diff(np.array(data["corners"]), axis=0)
    parts = []
    for step in steps:
        axis = int(np.abs(step).argmax())
        parts.append(f"{1000 * abs(step[axis]):g} along {'-' if step[axis] < 0 else '+'}{'xyz'[axis]}")
    arrows = ", ".join(f"{i} {direction(S[:3])}" for i, S in enumerate(arm.screw_axes, 1))
    axes = ", ".join(
        f"{letter} along {direction(column)}" for letter, column in zip("xyz", data["flange"].T, strict=True)
    )
    title = {"iiwa": "KUKA LBR iiwa 14", "ur5e": "UR5e"}[name]
    return (
        f"Drawing of the {title} in three views, all joint angles zero, dimensions in millimetres. From the base the "
        f"arm goes {', then '.join(parts)}. The arrows of the joint axes point along: {arrows}. The flange's frame b "
        f"has {axes} of the base frame s."
    )


def direction(vector):
    """Return the coordinate axis along which a vector points, in words.

    Parameters
    ----------
    vector : array_like, shape (3,)

    Returns
    -------
    str

    Examples
    --------
    >>> direction([0, -1, 0])
    '-y'
    """
    axis = int(np.abs(vector).argmax())
    return f"{'-' if vector[axis] < 0 else '+'}{'xyz'[axis]}"
