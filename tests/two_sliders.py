"""A picture with two sliders, over step size and damping, that needs neither kernel nor frames.

Every pair of values is drawn, each in a cell of its own in one large plane: step sizes along x, dampings along y. A
slider does not change what is drawn; it moves the window along its axis. So the two do not know of each other, and
work together all the same, wherever plotly runs.
"""

import numpy as np
import plotly.graph_objects as go

from course_lib.figures.style import BLACK, BLUE, CRIMSON, GREEN, GREY, PLOTLY_LAYOUT, PURPLE

# Of each panel: where it stands, what its window shows of x and y, its ticks, and the titles of its axes.
_PANELS = (
    {"x": [0.0, 0.42], "y": [0.52, 1.0], "window": ((-4.3, 4.3), (-4.3, 4.3)), "titles": ("x (m)", "y (m)")},
    {"x": [0.57, 1.0], "y": [0.52, 1.0], "window": ((0, 100), (-8, 1)), "titles": ("steps", "distance left (m)")},
    {
        "x": [0.0, 1.0],
        "y": [0.0, 0.26],
        "window": ((0, 4.2), (-3.2, 1.4)),
        "titles": ("singular value s of the Jacobian (m)", "joint step (rad/m)"),
    },
)
_TICKS = (
    ((range(-4, 5, 2), range(-4, 5, 2)), (str, str)),
    ((range(0, 101, 25), range(-8, 2, 2)), (str, lambda v: f"1e{v}" if v else "1")),
    ((range(5), range(-3, 2)), (str, lambda v: f"{10.0**v:g}")),
)
_CONTROLS = 160  # pixels below the picture for the sliders
_PITCH = 3  # from one cell to the next, in widths of a window


def explorer(alphas, epsilons, arms, target, singular_values, start):
    """Return the picture: the tip's way and the last posture, the distance left, and the step for each singular value.

    alphas (a,), epsilons (e,): the sliders' values. arms: (a, e, n, links + 1, 2), the arm's points at each step.
    NaN for steps that are not to be drawn. target: (2,). singular_values: (e, 2) of the Jacobian at the goal. start:
    (i, j), the pair shown first.
    """
    fig = go.Figure()
    for i, alpha in enumerate(alphas):
        for j, eps in enumerate(epsilons):
            _run(fig, (i, j), arms[i, j], target)
            _steps(fig, (i, j), alpha, eps, singular_values[j])
    fig = _one_trace_a_look(fig)
    layout = {**PLOTLY_LAYOUT, "height": 600 + _CONTROLS, "showlegend": True, "meta": {"controls": _CONTROLS}}
    layout["margin"] = {"l": 65, "r": 15, "t": 15, "b": 55 + _CONTROLS}
    layout["legend"] = {"orientation": "h", "x": 0.5, "xanchor": "center", "y": 0.27, "yanchor": "bottom"}
    fig.update_layout(**layout, **_axes(len(alphas), len(epsilons), start))
    sliders = [
        _slider("x", "step size alpha: ", alphas, start[0], 60),
        _slider("y", "damping epsilon (m²): ", epsilons, start[1], 140),
    ]
    return fig.update_layout(sliders=sliders)


def _run(fig, cell, arm, target):
    arm = arm[np.isfinite(arm).all((1, 2))]
    tip = arm[:, -1]
    shown = np.r_[0:30, 30 : len(tip) : 3]  # nothing is to be seen between most of the later steps
    shown = shown[shown < len(tip)]
    miss = np.log10(np.maximum(np.linalg.norm(tip - target, axis=-1), 1e-8))
    _draw(fig, cell, 0, tip[shown], BLUE)
    _draw(fig, cell, 0, arm[-1], CRIMSON, width=4)
    _draw(fig, cell, 0, [target], BLACK, mode="markers", symbol="x", size=10)
    _draw(fig, cell, 1, np.stack([shown, miss[shown]], -1), BLUE)


def _steps(fig, cell, alpha, eps, singular_values):
    s = np.linspace(0.05, 4.2, 30)
    _draw(fig, cell, 2, np.stack([s, np.log10(alpha * s / (s**2 + eps))], -1), BLUE, name="alpha s/(s² + epsilon)")
    bound = np.log10(alpha / (2 * np.sqrt(eps)))
    _draw(fig, cell, 2, [[0, bound], [4.2, bound]], GREEN, dash="dash", name="alpha/(2 √epsilon)")
    _draw(fig, cell, 2, np.stack([s[2:], np.log10(2 / s[2:])], -1), PURPLE, dash="dot", name="2/s")
    marked = [[value, np.log10(alpha * value / (value**2 + eps))] for value in singular_values]
    _draw(fig, cell, 2, marked, CRIMSON, mode="markers", symbol="circle", size=9)
    limit = 2 * (1 + eps / max(singular_values) ** 2)
    words = f"alpha = {alpha:g} is {'below' if alpha < limit else 'above'} its limit {limit:.2f}"
    x, y = _moved(cell, 2, [[2.1, 1.15]])[0]
    look = {"mode": "text", "textfont": {"color": BLACK}, "hoverinfo": "skip", "showlegend": False}
    fig.add_scatter(x=[x], y=[y], text=[words], xaxis="x3", yaxis="y3", **look)


def _moved(cell, panel, places):
    """Places in the window of a panel, moved to its cell; what lies outside the window is cut off."""
    moved = np.array(places, float)
    for axis, (low, high) in enumerate(_PANELS[panel]["window"]):
        outside = (moved[:, axis] < low) | (moved[:, axis] > high)
        moved[outside] = np.nan
        moved[:, axis] += cell[axis] * _PITCH * (high - low)
    return np.round(moved, 3)


def _draw(fig, cell, panel, places, colour, *, mode="lines", width=2, dash="solid", symbol="circle", size=6, name=None):
    x, y = _moved(cell, panel, places).T
    look = {"marker": {"color": colour, "symbol": symbol, "size": size}}
    if mode == "lines":
        look = {"line": {"color": colour, "width": width, "dash": dash}}
    number = panel + 1 if panel else ""
    look |= {"xaxis": f"x{number}", "yaxis": f"y{number}", "name": name, "showlegend": name is not None}
    fig.add_scatter(x=x, y=y, mode=mode, hoverinfo="skip", **look)


def _one_trace_a_look(fig):
    """Join the traces that look alike, with a gap between them: a few long traces draw faster than many short ones."""
    joined = {}
    for trace in fig.data:
        look = trace.to_plotly_json()
        x, y, text = list(look.pop("x")), list(look.pop("y")), list(look.pop("text", [None] * len(trace.x)))
        found = joined.setdefault(repr(look), {"look": look, "x": [], "y": [], "text": []})
        found["x"] += [*x, None]
        found["y"] += [*y, None]
        found["text"] += [*text, None]
    traces = []
    for found in joined.values():
        words = {"text": found["text"]} if found["look"]["mode"] == "text" else {}
        traces.append(go.Scatter(**found["look"], x=found["x"], y=found["y"], **words))
    return go.Figure(traces)


def _range(window, k):
    low, high = window
    shift = k * _PITCH * (high - low)
    return [low + shift, high + shift]


def _axes(columns, rows, start):
    layout = {}
    for number, (panel, (ticks, words)) in enumerate(zip(_PANELS, _TICKS, strict=True), 1):
        for axis, (letter, cells) in enumerate((("x", columns), ("y", rows))):
            low, high = panel["window"][axis]
            shifts = [k * _PITCH * (high - low) for k in range(cells)]
            layout[f"{letter}axis{number if number > 1 else ''}"] = {
                "domain": panel[letter],
                "anchor": f"{'y' if letter == 'x' else 'x'}{number if number > 1 else ''}",
                "range": _range(panel["window"][axis], start[axis]),
                "tickvals": [tick + shift for shift in shifts for tick in ticks[axis]],
                "ticktext": [words[axis](tick) for _ in shifts for tick in ticks[axis]],
                "title": {"text": panel["titles"][axis], "standoff": 6},
                "gridcolor": "#dddddd",
                "linecolor": GREY,
                "zeroline": False,
                "fixedrange": True,
            }
    layout["yaxis"] |= {"scaleanchor": "x", "scaleratio": 1, "constrain": "domain"}
    layout["xaxis"] |= {"constrain": "domain"}
    return layout


def _slider(letter, prefix, values, active, pad):
    steps = []
    for k, value in enumerate(values):
        windows = {
            f"{letter}axis{number if number > 1 else ''}.range": _range(panel["window"]["xy".index(letter)], k)
            for number, panel in enumerate(_PANELS, 1)
        }
        steps.append({"label": f"{value:g}", "method": "relayout", "args": [windows]})
    value = {"prefix": prefix, "xanchor": "left", "font": {"size": 13, "color": BLACK}}
    return {"active": active, "steps": steps, "currentvalue": value, "pad": {"t": pad}, "x": 0, "len": 1}
