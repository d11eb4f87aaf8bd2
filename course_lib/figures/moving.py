"""Films in the plane: plotly frames with play, pause and a slider, without a kernel."""

import plotly.graph_objects as go

from course_lib.figures.style import BLACK, PLOTLY_LAYOUT

_CONTROLS = 82  # pixels below the picture for the button and the slider


def plane_layout(half):
    """Return the plotly layout of a square of the plane about the origin, `half` to its edge, with equal scales."""
    axis = {"showgrid": True, "gridcolor": "#dddddd", "zeroline": False, "linecolor": BLACK, "constrain": "domain"}
    axis |= {"ticks": "outside", "ticklen": 4}
    return {
        **PLOTLY_LAYOUT,
        "xaxis": axis | {"range": [-half, half], "title": {"text": "x (m)"}},
        "yaxis": axis | {"range": [-half, half], "title": {"text": "y (m)"}, "scaleanchor": "x", "scaleratio": 1},
        "height": 560,
        "showlegend": False,
        "margin": {"l": 60, "r": 20, "t": 20, "b": 50},
    }


def path(points, colour, *, width=2, dash="solid", mode="lines", **options):
    """Return a line through points, shape (n, 2), or dots at them with mode="markers"."""
    x, y = zip(*points, strict=True)
    look = {"marker": {"color": colour, "size": options.pop("size", 7)}} if "markers" in mode else {}
    if "lines" in mode:
        look["line"] = {"color": colour, "width": width, "dash": dash}
    return go.Scatter(x=list(x), y=list(y), mode=mode, hoverinfo="skip", **look, **options)


def movie(name, layout, still, moving, times):
    """Return a figure that plays in real time.

    name: that of its file if it is written as an animation. still: the traces that stay. moving: the trace that moves,
    as it is at each of the times (n,), in seconds.
    """
    fig = go.Figure([*still, moving[0]], layout=layout)
    # Frames contain only positions: the style is that of the first one.
    fig.frames = [
        go.Frame(data=[type(trace)(x=trace.x, y=trace.y)], traces=[len(still)], name=str(i))
        for i, trace in enumerate(moving)
    ]
    _add_controls(fig, times)
    fig.layout.meta = {"movie": name, **fig.layout.meta}
    return fig


def _add_controls(fig, times):
    """Add a button that plays and a slider to a figure that has a frame for each time (n,), and make room for them."""
    seconds = float(times[-1] - times[0])
    at_once = {"mode": "immediate", "frame": {"duration": 0, "redraw": False}, "transition": {"duration": 0}}
    pace = {"frame": {"duration": 1000 * seconds / max(len(times) - 1, 1), "redraw": False}, "fromcurrent": True}
    pace["transition"] = {"duration": 0}
    fig.update_layout(
        height=fig.layout.height + _CONTROLS,
        margin_b=fig.layout.margin.b + _CONTROLS,
        updatemenus=[_buttons(pace, at_once)],
        sliders=[_slider([f"{t:.2f}" for t in times], at_once)],
        meta={"seconds": seconds, "controls": _CONTROLS},
    )


def _buttons(pace, at_once):
    play = {"label": "Play", "method": "animate", "args": [None, pace]}
    pause = {"label": "Pause", "method": "animate", "args": [[None], at_once]}
    where = {"x": 0, "y": 0, "xanchor": "left", "yanchor": "top", "pad": {"t": 60, "r": 10}}
    return {"type": "buttons", "direction": "left", "showactive": False, "buttons": [play, pause], **where}


def _slider(labels, at_once):
    steps = [{"label": label, "method": "animate", "args": [[str(i)], at_once]} for i, label in enumerate(labels)]
    where = {"x": 0.27, "len": 0.73, "y": 0, "yanchor": "top", "pad": {"t": 48}, "ticklen": 0, "minorticklen": 0}
    value = {"prefix": "time (s): ", "xanchor": "left", "font": {"size": 13, "color": BLACK}}
    return {"active": 0, "steps": steps, "currentvalue": value, "font": {"color": "rgba(0,0,0,0)"}, **where}
