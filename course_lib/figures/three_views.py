"""The dimensioned drawings of notebook 4: the iiwa and the UR5e in three views, for reading their screw axes."""

import itertools

import numpy as np
from matplotlib.figure import Figure

from course_lib.figures.display import Picture
from course_lib.figures.style import BLACK, FRAME_COLOURS, GREY

# Each arm's corners at joint angles zero, from the base to the flange, the distance from each length between two of
# them to its dimension line, and the margins below and above the arm along x, y and z, all in metres; its views, and
# how many inches are drawn for a metre.
_TOP, _SIDE, _END = "top", "side", "end"
_ARMS = {
    "iiwa": {
        "title": "KUKA LBR iiwa 14",
        "corners": [(0, 0, z) for z in (0, 0.36, 0.78, 1.18, 1.301)],
        "beside": [0.22] * 4,
        "margins": [(0.22, 0.22)] * 3,
        "layout": [[_SIDE, _END, _TOP]],
        "scale": 3.6,
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
        "margins": [(0.22, 0.14), (0.25, 0.14), (0.12, 0.19)],
        "layout": [[_SIDE, _END], [_TOP, "."]],
        "scale": 4.8,
    },
}
_VIEWS = {_TOP: (0, 1, 2, "from above"), _SIDE: (0, 2, 1, "from the side"), _END: (1, 2, 0, "from the front")}
_TOWARDS = {_TOP: 1, _SIDE: -1, _END: 1}  # the sign of the hidden axis's direction that points at the viewer


def three_views(name, arm, frames=("s", "b")):
    """Return a Picture: a dimensioned drawing of an arm at joint angles zero, from the side, above and the front.

    name: "iiwa" or "ur5e". arm: the SerialArm whose screw axes are drawn. frames: how base and flange are called.
    """
    data = _ARMS[name]
    corners, layout, scale = np.array(data["corners"]), data["layout"], data["scale"]
    limits = np.stack([corners.min(0), corners.max(0)], 1) + np.array(data["margins"]) * [-1, 1]
    size = np.ptp(limits, axis=1)
    widths = [size[_VIEWS[view][0]] for view in layout[0]]
    heights = [size[_VIEWS[row[0]][1]] for row in layout]
    size = (scale * sum(widths) + 0.4, scale * sum(heights) + 0.35 * len(layout))
    fig = Figure(figsize=size, layout="constrained", facecolor="white")
    for view, ax in fig.subplot_mosaic(layout, width_ratios=widths, height_ratios=heights).items():
        _View(ax, view, corners, limits, 0.14 / scale).draw(arm, data["beside"], *frames)
    caption = "Dimensions in millimetres. A cross is an arrow that points away from you, a dot one that points at you."
    return Picture(fig, _in_words(arm, data, *frames), caption)


class _View:
    """One view of an arm: its lines first, then words where no line is; `letter` is the height of a word in metres."""

    def __init__(self, ax, view, corners, limits, letter):
        self.ax, self.view, self.corners, self.letter = ax, view, corners, letter
        self.i, self.j, self.k, title = _VIEWS[view]
        self.flat = corners[:, [self.i, self.j]]
        self.taken, self.words = [], []  # points (2,) on lines; (text, tip of its arrow, direction, look)
        ax.set(aspect="equal", title=title, xticks=[], yticks=[], xlim=limits[self.i], ylim=limits[self.j])
        ax.spines[:].set_visible(False)

    def draw(self, arm, besides, base, tool):
        for look in ({"color": "#c9d3dc", "linewidth": 11}, {"color": GREY, "linewidth": 1}):
            self.ax.plot(*self.flat.T, solid_capstyle="round", **look)
        for start, end in itertools.pairwise(self.flat):
            for side in np.array([[0.5, 0], [-0.5, 0], [0, 0.5], [0, -0.5]]) * self.letter:  # the arm is as wide
                self.cover(start + side, end + side)
        for ends, beside in zip(itertools.pairwise(self.corners), besides, strict=True):
            if self.view == (_TOP if np.ptp(ends, axis=0)[1] else _SIDE):
                self.dimension(*np.sort(ends, axis=0)[:, [self.i, self.j]], beside)
        self.joints(arm)
        straight = np.ptp(self.flat) == 0  # seen along the arm: its base frame is drawn beside it
        self.frame(np.array([-0.15, -0.13]) if straight else np.zeros(2), np.eye(3), base, 0.085)
        flange = arm.home[-1, :3, :3].round(9)
        if (flange != np.eye(3)).any():
            self.frame(self.flat[-1], flange, tool, 0.2)
        elif not straight:
            text = f"{tool}, parallel to {base}"
            self.words.append((text, self.flat[-1] + [0, 0.16], np.array([0, 1]), {"style": "italic"}))
        for word in self.words:
            self.write(*word)

    def cover(self, start, end):
        self.taken += list(start + np.linspace(0, 1, 12)[:, None] * (end - start))

    def arrow(self, start, end, colour, **look):
        self.ax.annotate("", end, start, arrowprops={"color": colour, "shrinkA": 0, "shrinkB": 0, **look}, zorder=4)
        self.cover(start, end)

    def joints(self, arm):
        """The arrows of the joint axes; a dot or a cross for one that is seen end-on."""
        numbers = {}
        for number, S in enumerate(arm.screw_axes, 1):
            at, omega = self.on_link(S)[[self.i, self.j]], S[:3]
            colour = FRAME_COLOURS[int(np.abs(omega).argmax())]
            along = omega[[self.i, self.j]].round(9) + 0.0
            tip = at + 0.13 * along
            if along.any():
                self.arrow(at - 0.07 * along, tip, colour, arrowstyle="-|>", linewidth=1.6)
            else:
                towards = omega[self.k] * _TOWARDS[self.view] > 0
                look = {"color": colour, "markeredgewidth": 1.8, "zorder": 5}
                self.ax.plot(*at, "o", markersize=11, markerfacecolor="white", **look)
                self.ax.plot(*at, "." if towards else "x", markersize=6, **look)
                t = np.arange(8) * np.pi / 4
                self.taken += list(at + 0.55 * self.letter * np.stack([np.cos(t), np.sin(t)], -1))
            numbers.setdefault((*tip.round(3), *along, colour), []).append(str(number))
        for (x, y, dx, dy, colour), group in numbers.items():
            look = {"color": colour, "weight": "bold", "size": 10}
            self.words.append((", ".join(group), np.array([x, y]), np.array([dx, dy]), look))

    def on_link(self, S):
        """The point of a screw axis at which its joint is drawn: the last corner of the arm that lies on it."""
        off = [np.linalg.norm(np.cross(S[:3], corner) + S[3:]) for corner in self.corners[:-1]]
        return self.corners[max(i for i, distance in enumerate(off) if distance < 1e-9)]

    def frame(self, origin, R, name, size):
        for axis, colour in enumerate(FRAME_COLOURS):
            along = R[[self.i, self.j], axis]
            if along.any():
                self.arrow(origin, origin + size * along, colour, arrowstyle="->", linewidth=1.2)
                self.words.append((f"${'xyz'[axis]}_{name}$", origin + size * along, along, {"color": colour}))
        self.words.append((name, origin, np.array([-0.7, -0.7]), {"style": "italic", "size": 11}))

    def dimension(self, start, end, beside):
        vertical = abs(end[0] - start[0]) < 1e-9
        offset = np.array([beside, 0]) if vertical else np.array([0, beside])
        for point in (start, end):
            self.ax.plot(*zip(point + 0.3 * offset, point + 1.1 * offset, strict=True), color=BLACK, linewidth=0.5)
            self.cover(point + 0.3 * offset, point + 1.1 * offset)
        self.arrow(start + offset, end + offset, BLACK, arrowstyle="<->", linewidth=0.8)
        away = offset / np.abs(offset).max() if vertical else np.array([0, 1])
        text = f"{1000 * np.abs(end - start).max():g}"
        self.words.append((text, (start + end) / 2 + offset, away, {}))

    def write(self, text, tip, along, look):
        """Write a word beyond the tip of its arrow if nothing is drawn there, otherwise where there is most room."""
        h, wide = self.letter, 0.3 * self.letter * len(text.strip("$"))
        angle = np.arctan2(along[1], along[0]) if along.any() else np.pi / 4
        angles = angle + np.pi / 8 * np.array([0, 1, -1, 2, -2, 3, -3, 4, -4, 6, -6, 8])
        spots = [
            tip + (h * far + wide * abs(np.cos(a))) * np.array([np.cos(a), np.sin(a)])
            for far in (0.8, 1.2, 1.6)
            for a in angles
        ]
        across = np.linspace(-wide, wide, 3 + len(text) // 2)[:, None] * [1, 0]
        gaps = [np.linalg.norm((spot + across)[:, None] - self.taken, axis=-1).min() for spot in spots]
        best = spots[int(np.argmax(np.minimum(gaps, 0.78 * h) - 1e-3 * h * np.arange(len(spots))))]
        self.taken += list(best + across)
        self.ax.text(*best, text, ha="center", va="center", **{"size": 9, "color": BLACK} | look)


def _in_words(arm, data, base, end):
    """The drawing in words: the arm's path from the base to the flange, its dimensions and arrows."""
    steps = np.diff(np.array(data["corners"]), axis=0)
    path = ", then ".join(f"{1000 * np.abs(step).max():g} along {direction(step)}" for step in steps)
    arrows = ", ".join(f"{i} {direction(S[:3])}" for i, S in enumerate(arm.screw_axes, 1))
    axes = ", ".join(f"{'xyz'[k]} along {direction(arm.home[-1, :3, k])}" for k in range(3))
    return (
        f"Drawing of the {data['title']} in three views, all joint angles zero, dimensions in millimetres. From the "
        f"base the arm goes {path}. The arrows of the joint axes point along: {arrows}. The "
        f"flange's frame {end} has {axes} of the base frame {base}."
    )


def direction(vector):
    """Return the coordinate axis along which a vector (3,) points, in words, such as "-y"."""
    axis = int(np.abs(vector).argmax())
    return f"{'-' if vector[axis] < 0 else '+'}{'xyz'[axis]}"
