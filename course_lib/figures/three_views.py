"""The dimensioned drawings of notebook 4: the iiwa and the UR5e in three views.

They are for reading the arms' screw axes.
"""

import itertools
from dataclasses import dataclass

import numpy as np

from course_lib.figures.digits import rounded_array
from course_lib.figures.display import Picture
from course_lib.figures.style import BLACK, FRAME_COLOURS, GREY, LINK_BLUE

# Each arm's corners at joint angles zero, from the base to the flange, the distance from each
# length between two of them to its dimension line, and the margins below and above the arm along x,
# y and z, all in metres; its views; how many inches are drawn for a metre; and on which side of its
# point a word stands that would cover something, with the base called s and the flange b.
_TOP, _SIDE, _END = "top", "side", "end"
_ARMS = {
    "iiwa": {
        "title": "KUKA LBR iiwa 14",
        "corners": [(0, 0, z) for z in (0, 0.36, 0.78, 1.18, 1.301)],
        "beside": [0.22] * 4,
        "margins": [(0.22, 0.34), (0.22, 0.22), (0.14, 0.24)],
        "layout": [[_SIDE, _END, _TOP]],
        "scale": 2.75,
        "aside": {
            _SIDE: {"$x_s$": (0, -1)},
            _END: {},
            _TOP: {"1, 3, 5, 7": (1, 1), "$x_s$": (0, 1)},
        },
    },
    "ur5e": {
        "title": "UR5e",
        "corners": [
            (0, 0, 0),
            (0, 0, 0.1625),
            (-0.425, 0, 0.1625),
            (-0.8172, 0, 0.1625),
            (-0.8172, -0.1333, 0.1625),
            (-0.8172, -0.1333, 0.0628),
            (-0.8172, -0.2329, 0.0628),
        ],
        "beside": [-0.12, 0.14, 0.14, -0.1, -0.12, -0.1],
        "margins": [(0.22, 0.14), (0.25, 0.14), (0.12, 0.23)],
        "layout": [[_SIDE], [_TOP], [_END]],
        "scale": 3.55,
        "aside": {
            _SIDE: {"1": (1, 0), "2": (1, 1), "3": (1, -1), "4": (-1, 1), "6": (1, -1)},
            _END: {"2, 3": (1, 1), "6": (-1, -1), "b": (0, -1)},
            _TOP: {"1": (1, 1), "4, 6": (1, 0), "5": (1, 1)},
        },
    },
}
_VIEWS = {
    _TOP: (0, 1, 2, "from above"),
    _SIDE: (0, 2, 1, "from the side"),
    _END: (1, 2, 0, "from the front"),
}
_LEFT = {"$z_s$": (-1, 0), "$y_b$": (-1, 0)}  # aside in every view
# The sign of the hidden axis's direction that points at the viewer.
_TOWARDS = {_TOP: 1, _SIDE: -1, _END: 1}
_ON_AXIS = 1e-9  # metres: a corner nearer than that to a joint's axis lies on it


def three_views(name, arm, frames=("s", "b"), finding=""):
    """Return a dimensioned drawing of an arm at joint angles zero.

    It shows the arm from the side, from above and from the front.

    Parameters
    ----------
    name : {"iiwa", "ur5e"}
    arm : SerialArm
        Its screw axes are drawn.
    frames : tuple of str, optional
        The names of the frames of base and flange, a character each.
    finding : str, optional
        What is found in this drawing; the caption begins with it.

    Returns
    -------
    Picture
    """
    data = _ARMS[name]
    corners = np.array(data["corners"])
    layout = data["layout"]
    scale = data["scale"]
    limits = np.stack([corners.min(0), corners.max(0)], 1) + np.array(data["margins"]) * [-1, 1]
    metres = np.ptp(limits, axis=1)
    widths = [metres[_VIEWS[view][0]] for view in layout[0]]
    heights = [metres[_VIEWS[row[0]][1]] for row in layout]
    inches = (scale * sum(widths) + 0.4, scale * sum(heights) + 0.35 * len(layout))
    from matplotlib.figure import Figure

    fig = Figure(figsize=inches, layout="constrained", facecolor="white")
    panels = fig.subplot_mosaic(layout, width_ratios=widths, height_ratios=heights)
    for name_of_view, ax in panels.items():
        i, j, _, title = _VIEWS[name_of_view]
        ax.set(aspect="equal", title=title, xticks=[], yticks=[], xlim=limits[i], ylim=limits[j])
        ax.spines[:].set_visible(False)
        view = _View(ax, name_of_view, _LEFT | data["aside"][name_of_view], *frames)
        flat = corners[:, view.plane]
        ax.plot(*flat.T, solid_capstyle="round", color=LINK_BLUE, linewidth=11)
        ax.plot(*flat.T, solid_capstyle="round", color=GREY, linewidth=1)
        _draw_lengths(view, corners, data["beside"])
        _draw_joint_axes(view, arm, corners)
        _draw_frames(view, arm, corners)
    fig.draw_without_rendering()  # the layout of panels with equal scales settles in two rounds
    caption = (
        f"{finding} The dimensions are in millimetres. A cross is an arrow that points away from "
        "you, and a dot is an arrow that points at you."
    ).lstrip()
    return Picture(fig, _in_words(arm, data, *frames), caption)


@dataclass(frozen=True)
class _View:
    """One panel: what is along its axes and towards the viewer, and where its words stand aside."""

    ax: object  # of matplotlib
    name: str
    aside: dict
    base: str
    tool: str

    @property
    def plane(self):
        """The indices of the two coordinates that the panel shows."""
        return list(_VIEWS[self.name][:2])

    def points_at_viewer(self, vector):
        """Return whether a vector along the hidden axis points at the viewer."""
        hidden = _VIEWS[self.name][2]
        return vector[hidden] * _TOWARDS[self.name] > 0

    def word(self, text, tip, along, **style):
        """Write a word beyond the tip of its arrow, or aside."""
        named = text.translate({ord(self.base): "s", ord(self.tool): "b"})
        x, y = np.sign(self.aside.get(named, along)).astype(int)
        style = {
            "size": 10,
            "color": BLACK,
            "ha": ("center", "left", "right")[x],
            "va": ("center", "bottom", "top")[y],
            **style,
        }
        offset = (8 * x, 8 * y)
        written = self.ax.annotate(text, tip, offset, textcoords="offset points", **style)
        written.set_in_layout(False)

    def arrow(self, start, end, colour, **style):
        """Draw an arrow between two points of the panel."""
        properties = {"color": colour, "shrinkA": 0, "shrinkB": 0, **style}
        self.ax.annotate("", end, start, arrowprops=properties, zorder=4)

    def frame(self, origin, R, name, size):
        """Draw the axes of a frame at a point of the panel, with their names."""
        for axis, colour in enumerate(FRAME_COLOURS):
            along = R[self.plane, axis]
            if along.any():
                tip = origin + size * along
                self.arrow(origin, tip, colour, arrowstyle="->", linewidth=1.2)
                self.word(f"${'xyz'[axis]}_{name}$", tip, along, color=colour)
        self.word(name, origin, (-1, -1), style="italic", size=11)


def _draw_lengths(view, corners, beside):
    """Draw the dimension lines of the lengths between corners (n, 3), each so far `beside`."""
    for ends, distance in zip(itertools.pairwise(corners), beside, strict=True):
        is_along_y = np.ptp(ends, axis=0)[1] > 0
        if view.name != (_TOP if is_along_y else _SIDE):
            continue
        start, end = np.sort(ends, axis=0)[:, view.plane]
        is_vertical = start[0] == end[0]
        offset = distance * (np.array([1, 0]) if is_vertical else np.array([0, 1]))
        for point in (start, end):
            extension_line = [point + 0.3 * offset, point + 1.1 * offset]
            view.ax.plot(*np.transpose(extension_line), color=BLACK, linewidth=0.5)
        view.arrow(start + offset, end + offset, BLACK, arrowstyle="<->", linewidth=0.8)
        length = 1000 * np.abs(end - start).max()
        view.word(f"{length:g}", (start + end) / 2 + offset, offset)


def _draw_joint_axes(view, arm, corners):
    """Draw an arrow along each joint axis of an arm, or a dot or cross, with the joint's number."""
    numbers = {}
    for number, S in enumerate(arm.screw_axes, 1):
        # Its joint is drawn at the last corner of the arm that lies on the axis.
        distances = np.linalg.norm(np.cross(S[:3], corners[:-1]) + S[3:], axis=1)
        last_on_axis = np.flatnonzero(distances < _ON_AXIS)[-1]
        at = corners[last_on_axis, view.plane]
        along = rounded_array(S[view.plane], 9)
        tip = at + 0.13 * along
        colour = FRAME_COLOURS[int(np.abs(S[:3]).argmax())]
        if along.any():
            view.arrow(at - 0.07 * along, tip, colour, arrowstyle="-|>", linewidth=1.6)
        else:
            style = {"color": colour, "markeredgewidth": 1.8, "zorder": 5}
            mark = "." if view.points_at_viewer(S[:3]) else "x"
            view.ax.plot(*at, "o", markersize=11, markerfacecolor="white", **style)
            view.ax.plot(*at, mark, markersize=6, **style)
        # Joints whose arrows lie on each other share a label.
        numbers.setdefault((*rounded_array(tip, 3), *along, colour), []).append(str(number))
    for (x, y, dx, dy, colour), group in numbers.items():
        beyond = (dx, dy) if dx or dy else (-1, 0)
        view.word(", ".join(group), (x, y), beyond, color=colour, weight="bold", size=11)


def _draw_frames(view, arm, corners):
    """Draw the frames of base and flange, or say that the flange's is parallel to the base's."""
    flat = corners[:, view.plane]
    is_seen_along_the_arm = np.ptp(flat) == 0
    # Seen along the arm, its base frame is drawn beside it.
    origin = np.array([-0.15, -0.13]) if is_seen_along_the_arm else np.zeros(2)
    view.frame(origin, np.eye(3), view.base, 0.085)
    flange = rounded_array(arm.home[-1, :3, :3], 9)
    if (flange != np.eye(3)).any():
        view.frame(flat[-1], flange, view.tool, 0.2)
    elif not is_seen_along_the_arm:
        text = f"{view.tool}, parallel to {view.base}"
        view.word(text, flat[-1] + [0, 0.13], (0, 1), style="italic")


def _in_words(arm, data, base, end):
    """The drawing in words: the arm's path from base to flange, its dimensions and arrows."""
    steps = np.diff(np.array(data["corners"]), axis=0)
    path = ", then ".join(
        f"{1000 * np.abs(step).max():g} along {direction(step)}" for step in steps
    )
    arrows = ", ".join(f"{i} {direction(S[:3])}" for i, S in enumerate(arm.screw_axes, 1))
    axes = ", ".join(f"{'xyz'[k]} along {direction(arm.home[-1, :3, k])}" for k in range(3))
    return (
        f"Drawing of the {data['title']} in three views, all joint angles zero, dimensions in "
        f"millimetres. From the base the arm goes {path}. The arrows of the joint axes point "
        f"along: {arrows}. The flange's frame {end} has {axes} of the base frame {base}."
    )


def direction(vector):
    """Return the coordinate axis along which a vector points, in words.

    Parameters
    ----------
    vector : ndarray, shape (3,)

    Returns
    -------
    str

    Examples
    --------
    >>> direction(np.array([0, -1, 0]))
    '-y'
    """
    axis = int(np.abs(vector).argmax())
    sign = "-" if vector[axis] < 0 else "+"
    return f"{sign}{'xyz'[axis]}"
