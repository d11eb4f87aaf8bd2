"""Charts by plotly in the course's style: values under the pointer, zoom, series that the legend
switches off.

A chart is a plotly Figure, so everything that plotly offers works on it too. `panels` (or `lines`,
for the most common case) makes one, the functions that begin with ``add_`` draw into it, and `show`
displays it. An axis is named with its unit, "time (s)"; what appears under the pointer says both.
Plotly is imported when the first chart is made.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from course_lib.arguments import real_array
from course_lib.figures.style import BLACK, COLOURS, GREY

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

# From so many points on, WebGL draws a series: as SVG each point is an element of the page, and
# some thousands of elements make zooming slow.
MANY_POINTS = 3000
DASHES = ("solid", "dash", "dot", "dashdot")  # as the curves of plots.lines, for print in grey
WIDTH = 700  # pixels, of the picture that stands in for a chart; live, a chart fills its column
_COLUMN_GAP = 90 / WIDTH  # between panels side by side: room for the ticks and the name of an axis
_ROW_GAP = 62  # pixels between panels below each other: room for ticks and a title
_ROW_GAP_WITH_NAMES = 85  # and for the name of an axis too
# The part of a colour bar beside each end that has no tick: on a phone a bar is about 260 pixels
# wide, and half of "≥ 21.3" and of a number beside it take 36.
_FREE_OF_TICKS = 0.15
_LARGEST_ANGLE = 8  # multiples of pi up to which an axis of angles has ticks

FONT = {"family": "system-ui, 'DejaVu Sans', sans-serif", "size": 14, "color": BLACK}
_SMALL = {"size": 12}  # of ticks and of the colour bar
_AXIS = {
    "automargin": True,
    "exponentformat": "power",
    "gridcolor": "#dddddd",
    "linecolor": "#8a8a8a",
    "showline": True,
    "tickfont": _SMALL,
    "ticks": "outside",
    "tickcolor": "#8a8a8a",
    "minorloglabels": "none",  # they are too small to read
    "title": {"standoff": 6, "font": {"size": 14}},
    "zeroline": False,
}
STYLE = {
    "colorway": list(COLOURS),
    "font": FONT,
    "hoverlabel": {"align": "left", "bgcolor": "white", "font": {"size": 13, "color": BLACK}},
    "legend": {
        "orientation": "h",
        "x": 0,
        "xanchor": "left",
        "y": 1,
        "yanchor": "top",
        "yref": "container",
        "bgcolor": "rgba(0,0,0,0)",
    },
    "margin": {"l": 20, "r": 20, "t": 30, "b": 20},
    "modebar": {"orientation": "v", "bgcolor": "rgba(0,0,0,0)", "color": GREY},
    "paper_bgcolor": "white",
    "plot_bgcolor": "white",
    "xaxis": _AXIS,
    "yaxis": _AXIS,
    "coloraxis": {"colorbar": {"thickness": 14, "outlinewidth": 0, "tickfont": _SMALL}},
}


class ColourScale(NamedTuple):
    """How numbers become colours, and what the colour bar says.

    Parameters
    ----------
    label : str
        What the numbers are, with their unit: "error (cm)".
    low, high : float, optional
        Ends of the colour bar. Numbers beyond an end take the colour of that end, and the colour
        bar then says so: its last tick reads "≥ 10". By default the range of the numbers.
    log : bool, optional
        Whether the colours are spaced logarithmically.
    middle : float, optional
        The number that takes the colour in the middle of the scale.
    colours : str, optional
        One of plotly's colour scales: "Viridis", or "RdBu_r" with a middle.

    Examples
    --------
    >>> ColourScale("error (cm)", high=10).label
    'error (cm)'
    """

    label: str
    low: float | None = None
    high: float | None = None
    log: bool = False
    middle: float | None = None
    colours: str = "Viridis"


# ---- charts and their panels ----


def panels(
    titles: Sequence[str] = ("",),
    *,
    xlabel: str | Sequence[str],
    ylabel: str | Sequence[str],
    columns: int | None = None,
    share: str = "",
    log: str = "",
    parts_of_pi: int = 0,
    equal: bool = False,
    height: int | None = None,
) -> Figure:
    """Return a chart of empty panels, row by row, to which the functions ``add_…`` add series.

    On a narrow screen the panels stand below each other.

    Parameters
    ----------
    titles : sequence of str, optional
        A title for each panel, or "" for none. One panel without a title by default.
    xlabel, ylabel : str or sequence of str
        Names of the axes, with their units in parentheses: one for all panels or one for each.
    columns : int, optional
        How many panels stand side by side; all of them by default.
    share : {"", "x", "y", "xy"}, optional
        Which axes the panels share. With "x", panels below each other have one x axis: who zooms
        in one of them zooms in all, and the pointer shows the values of all at that x. With "y",
        all panels have the same range of y.
    log : {"", "x", "y", "xy"}, optional
        Which axes are logarithmic.
    parts_of_pi : int, optional
        If it is 2, say, x is an angle in radians with ticks at multiples of pi / 2, written so.
    equal : bool, optional
        Whether one unit of x is as long as one unit of y, as it should be for positions in a plane.
    height : int, optional
        In pixels.

    Returns
    -------
    plotly.graph_objects.Figure

    Raises
    ------
    ValueError
        If a name of an axis has no words, or if there are not as many as there are panels.

    Examples
    --------
    >>> fig = panels(["left", "right"], xlabel="x (m)", ylabel="y (m)", equal=True)
    >>> add_line(fig, [0, 1], [0, 2], "path", panel=1)
    >>> fig.data[0].hovertemplate
    'path<br>x: %{x:.4~g} m<br>y: %{y:.4~g} m<extra></extra>'
    """
    from plotly.graph_objects import Figure

    titles = [_words(title, "titles", may_be_empty=True) for title in titles]
    if not titles:
        raise ValueError("titles must name at least one panel; it is empty")
    columns = len(titles) if columns is None else columns
    rows = -(-len(titles) // columns)
    xlabels = _for_each_panel(xlabel, "xlabel", len(titles))
    ylabels = _for_each_panel(ylabel, "ylabel", len(titles))
    one_x = "x" in share and rows > 1  # panels below each other really have one axis
    height = height or (380 if rows == 1 else 60 + 210 * rows)
    row_gap = (_ROW_GAP if one_x else _ROW_GAP_WITH_NAMES) / height
    layout = {"height": height, "hovermode": "x unified" if one_x else "closest"}
    layout["showlegend"] = False  # until there are two names
    if any(titles):
        layout["margin"] = {"t": 55}
    if one_x:
        layout["hoversubplots"] = "axis"
    notes, axes = [], []
    for i, title in enumerate(titles):
        row, column = divmod(i, columns)
        x_number = column + 1 if one_x else i + 1
        x_name, y_name = _axis_name("x", x_number), _axis_name("y", i + 1)
        axes.append([x_name, y_name])
        is_lowest = i + columns >= len(titles)
        if is_lowest or not one_x:
            layout[_layout_key(x_name)] = {
                "anchor": y_name,
                "domain": _part(column, columns, _COLUMN_GAP),
                "title": {"text": xlabels[i]},
                "unifiedhovertitle": {"text": _hover_line(xlabels[i], "x")},
                "type": "log" if "x" in log else "linear",
                **(_ticks_in_parts_of_pi(parts_of_pi) if parts_of_pi else {}),
                **({"matches": "x"} if "x" in share and x_name != "x" else {}),
            }
        layout[_layout_key(y_name)] = {
            "anchor": x_name,
            "domain": _part(rows - 1 - row, rows, row_gap),
            "title": {"text": ylabels[i]},
            "type": "log" if "y" in log else "linear",
            **({"matches": "y"} if "y" in share and y_name != "y" else {}),
            **({"scaleanchor": x_name, "constrain": "domain"} if equal else {}),
        }
        if equal:
            layout[_layout_key(x_name)]["constrain"] = "domain"
        if title:
            notes.append(_title_of_panel(title, x_name, y_name))
    layout |= {"annotations": notes, "meta": {"panels": axes, "columns": columns}}
    fig = Figure(layout=layout)
    fig.layout.template = {"layout": STYLE}
    return fig


def lines(
    x,
    series: Mapping,
    *,
    xlabel: str,
    ylabel: str,
    log: str = "",
    parts_of_pi: int = 0,
    markers: bool = False,
    height: int | None = None,
) -> Figure:
    """Return a chart of several series over one x: the pointer shows the values of all of them at
    an x.

    Parameters
    ----------
    x : array_like, shape (n,)
        The common abscissa.
    series : dict
        Label to ordinates, shape (n,); NaN leaves a gap.
    xlabel, ylabel, log, parts_of_pi, height
        As those of `panels`.
    markers : bool, optional
        Whether each point has a dot, as the steps of an iteration should.

    Returns
    -------
    plotly.graph_objects.Figure

    Examples
    --------
    >>> fig = lines([0, 1, 2], {"a": [0, 1, 4]}, xlabel="time (s)", ylabel="height (m)")
    >>> fig.layout.yaxis.title.text
    'height (m)'
    """
    if not series:
        raise ValueError("series must hold at least one label with its ordinates; it is empty")
    fig = panels(xlabel=xlabel, ylabel=ylabel, log=log, parts_of_pi=parts_of_pi, height=height)
    fig.layout.hovermode = "x unified"
    for name, y in series.items():
        add_line(fig, x, y, name, markers=markers)
    return fig


# ---- series ----


def add_line(
    fig: Figure,
    x,
    y,
    name: str,
    *,
    panel: int = 0,
    colour: str | None = None,
    dash: str | None = None,
    width: float = 2,
    markers: bool = False,
    details: Mapping | None = None,
) -> None:
    """Add a curve to a panel. Curves of one name in several panels have one colour and one entry in
    the legend.

    Parameters
    ----------
    fig : plotly.graph_objects.Figure
        A chart that `panels` or `lines` made.
    x, y : array_like, shape (n,)
        NaN leaves a gap.
    name : str
        For the legend and for what is shown under the pointer.
    panel : int, optional
        Which panel, from 0 on, row by row.
    colour, dash : str, optional
        The next of the course's colours, and of "solid", "dash", "dot" and "dashdot", by default.
    width : float, optional
        In pixels.
    markers : bool, optional
        Whether each point has a dot.
    details : dict, optional
        More to show under the pointer: {"damping (m²)": one value for each point}. A value is a
        number or a string.
    """
    place = _place(fig, name)
    line = {
        "color": colour or place.colour,
        "dash": dash or DASHES[place.number % len(DASHES)],
        "width": width,
    }
    mode = "lines+markers" if markers else "lines"
    style = {"line": line, "mode": mode, "marker": {"size": 6}}
    _add_series(fig, x, y, name, panel, details, place, style)


def add_points(
    fig: Figure,
    x,
    y,
    name: str,
    *,
    panel: int = 0,
    colour: str | Sequence[str] | None = None,
    symbol: str = "circle",
    size=7,
    opacity: float = 1,
    values=None,
    scale: ColourScale | None = None,
    details: Mapping | None = None,
) -> None:
    """Add dots to a panel, in one colour, in colours of their own, or coloured by numbers.

    From 3,000 dots on WebGL draws them.

    Parameters
    ----------
    fig, x, y, name, panel, details
        As those of `add_line`.
    colour : str or sequence of str, optional
        One colour, or one for each dot. The next of the course's colours by default.
    symbol : str, optional
        One of plotly's symbols: "circle", "triangle-up", "diamond-open", "x".
    size : float or array_like, shape (n,), optional
        Diameter in pixels.
    opacity : float, optional
        From 0 to 1.
    values : array_like, shape (n,), optional
        Numbers that `scale` turns into colours.
    scale : ColourScale, optional
        All dots and maps of a chart share one colour bar, that of the scale given last.
    """
    place = _place(fig, name)
    sizes = real_array(size, "size", (), ("n",), batched=False).tolist()
    marker = {"color": place.colour, "size": sizes, "symbol": symbol, "opacity": opacity}
    if isinstance(colour, str):
        marker["color"] = colour
    elif colour is not None:
        marker |= _indexed_colours(colour)
    details = dict(details or {})
    if values is not None:
        if scale is None:
            raise ValueError("scale must say how the values become colours: a ColourScale")
        values = real_array(values, "values", ("n",), batched=False, gaps=True)
        marker["color"] = _add_colour_axis(fig, values, scale)
        marker["coloraxis"] = "coloraxis"
        details = {scale.label: values} | details
    _add_series(fig, x, y, name, panel, details, place, {"mode": "markers", "marker": marker})


def add_bars(
    fig: Figure, edges, heights, name: str, *, panel: int = 0, colour: str | None = None
) -> None:
    """Add a histogram to a panel: a bar between each two edges.

    Parameters
    ----------
    fig, name, panel, colour
        As those of `add_line`.
    edges : array_like, shape (n + 1,)
        As numpy.histogram returns them.
    heights : array_like, shape (n,)
    """
    edges = real_array(edges, "edges", ("n",), batched=False)
    heights = real_array(heights, "heights", ("n",), batched=False, gaps=True)
    if len(edges) != len(heights) + 1:
        raise ValueError(
            f"edges must be one more than the {len(heights)} heights; there are {len(edges)}"
        )
    x_name, y_name = _axes_of(fig, panel)
    x_label, x_unit = _name_and_unit(fig, x_name)
    ends = np.stack([edges[:-1], edges[1:]], -1).tolist()
    between = f"{x_label}: %{{customdata[0]:.4~g}} to %{{customdata[1]:.4~g}}{x_unit}"
    place = _place(fig, name)
    fig.add_bar(
        x=(edges[1:] + edges[:-1]) / 2,
        y=heights,
        width=np.diff(edges),
        customdata=ends,
        hovertemplate=f"{name}<br>{between}<br>{_hover_of(fig, y_name, 'y')}<extra></extra>",
        marker={"color": colour or place.colour, "line": {"color": "white", "width": 1}},
        **_membership(fig, name, place, x_name, y_name),
    )


def add_map(
    fig: Figure,
    x,
    y,
    values,
    scale: ColourScale,
    *,
    panel: int = 0,
    details: Mapping | None = None,
) -> None:
    """Add a map to a panel: a coloured cell for each pair of an x and a y, with a colour bar.

    Parameters
    ----------
    fig, panel
        As those of `add_line`.
    x, y : array_like, shape (n,) and (m,)
        The cells' middles; on a logarithmic axis the middles of their logarithms.
    values : array_like, shape (m, n)
        A row for each y. A cell with NaN stays empty.
    scale : ColourScale
    details : dict, optional
        More to show under the pointer: {"steps": an array (m, n)}.
    """
    x = real_array(x, "x", ("n",), batched=False)
    y = real_array(y, "y", ("n",), batched=False)
    values = real_array(values, "values", (len(y), len(x)), batched=False, gaps=True)
    x_name, y_name = _axes_of(fig, panel)
    details = {scale.label: values} | dict(details or {})
    hover, columns = _details(details, values.shape)
    fig.add_heatmap(
        x=x,
        y=y,
        z=_add_colour_axis(fig, values, scale),
        coloraxis="coloraxis",
        customdata=columns,
        hovertemplate="<br>".join(
            [_hover_of(fig, x_name, "x"), _hover_of(fig, y_name, "y"), *hover]
        )
        + "<extra></extra>",
        name=_split(scale.label)[0],
        xaxis=x_name,
        yaxis=y_name,
    )


def add_rule(
    fig: Figure, *, x: float | None = None, y: float | None = None, text: str = "", panel: int = 0
) -> None:
    """Add a thin dashed line across a panel at an x or at a y, a limit say, with words at its
    end."""
    if (x is None) == (y is None):
        raise ValueError("a rule stands at an x or at a y: give one of the two")
    x_name, y_name = _axes_of(fig, panel)
    line = {"color": GREY, "width": 1, "dash": "dash"}
    across = {"xref": x_name, "yref": f"{y_name} domain", "x0": x, "x1": x, "y0": 0, "y1": 1}
    place = {"x": x, "y": 1, "xanchor": "left", "yanchor": "top"}
    if y is not None:
        across = {"xref": f"{x_name} domain", "yref": y_name, "x0": 0, "x1": 1, "y0": y, "y1": y}
        place = {"x": 1, "y": y, "xanchor": "right", "yanchor": "bottom"}
    fig.add_shape(type="line", line=line, layer="below", **across)
    if text:
        refs = {"xref": across["xref"], "yref": across["yref"]}
        note = {"text": _words(text, "text"), "showarrow": False, "font": {"size": 12}}
        fig.add_annotation(**note, **refs, **place)


# ---- how a series is named, coloured and read ----


class _Place(NamedTuple):
    number: int  # among the names of the chart, in the order in which they came
    colour: str
    is_new: bool  # whether no series had this name before


def _place(fig: Figure, name: str) -> _Place:
    """Return which colour a series has: that of an earlier series of the same name, or the next
    one."""
    names = list(dict.fromkeys(trace.legendgroup for trace in fig.data if trace.legendgroup))
    if name in names:
        number = names.index(name)
        first = next(trace for trace in fig.data if trace.legendgroup == name)
        is_curve = first.type != "bar" and "lines" in (first.mode or "")
        colour = first.line.color if is_curve else first.marker.color
        return _Place(number, colour, False)
    number = len(names)
    return _Place(number, COLOURS[number % len(COLOURS)], True)


def _membership(fig: Figure, name: str, place: _Place, x_name: str, y_name: str) -> dict:
    """Return what puts a series into its panel, and into the legend once for all panels."""
    if place.number > 0:
        fig.layout.showlegend = True
    return {
        "name": _words(name, "name"),
        "legendgroup": name,
        "showlegend": place.is_new,
        "xaxis": x_name,
        "yaxis": y_name,
    }


def _add_series(fig, x, y, name, panel, details, place, style) -> None:
    x = real_array(x, "x", ("n",), batched=False, gaps=True)
    y = real_array(y, "y", ("n",), batched=False, gaps=True)
    if x.shape != y.shape:
        raise ValueError(f"x and y must have as many entries; x has {len(x)}, y has {len(y)}")
    x_name, y_name = _axes_of(fig, panel)
    hover, columns = _details(details or {}, x.shape)
    texts = [_hover_of(fig, x_name, "x"), _hover_of(fig, y_name, "y"), *hover]
    unified = str(fig.layout.hovermode) == "x unified"
    texts.insert(0, name)
    if unified:  # x stands above the values of all series, and each has its name before it
        value = f"%{{y:.4~g}}{_name_and_unit(fig, y_name)[1]}"
        title = _title_at(fig, y_name)
        says_more = title and title != name
        texts = [f"{value}, {title}" if says_more else value, *hover]
    add = fig.add_scattergl if len(x) >= MANY_POINTS else fig.add_scatter
    add(
        x=x,
        y=y,
        customdata=columns,
        hovertemplate="<br>".join(texts) + ("" if unified else "<extra></extra>"),
        **style,
        **_membership(fig, name, place, x_name, y_name),
    )


def _details(details: Mapping, shape: tuple) -> tuple[list[str], list | None]:
    """Return the lines under the pointer for further values of each point, and plotly's customdata
    for them."""
    texts, columns = [], []
    for i, (label, values) in enumerate(details.items()):
        column = np.asarray(values)
        if column.shape != shape:
            raise ValueError(
                f"details[{label!r}] must have the shape {shape} of the points; its shape is "
                f"{column.shape}"
            )
        is_number = column.dtype.kind == "f"
        name, unit = _split(label)
        texts.append(f"{name}: %{{customdata[{i}]{':.4~g' if is_number else ''}}}{unit}")
        columns.append(column.astype(object))
    if not columns:
        return texts, None
    return texts, np.stack(columns, -1).tolist()


def _indexed_colours(colours: Sequence[str]) -> dict:
    """Return plotly's marker for a colour of each dot: an index takes a fifth of the room of a
    name."""
    distinct = list(dict.fromkeys(colours))
    numbers = {colour: number for number, colour in enumerate(distinct)}
    steps = []
    for number, colour in enumerate(distinct):
        steps += [[number / len(distinct), colour], [(number + 1) / len(distinct), colour]]
    return {
        "color": [numbers[colour] for colour in colours],
        "cmin": -0.5,
        "cmax": len(distinct) - 0.5,
        "colorscale": steps,
    }


def _add_colour_axis(fig: Figure, values: np.ndarray, scale: ColourScale) -> np.ndarray:
    """Set the chart's colour bar for these values, and return what plotly turns into colours."""
    label = _words(scale.label, "scale.label")
    known = values[np.isfinite(values)]
    if not known.size:
        raise ValueError("values must hold at least one number; all are NaN")
    if scale.log and not (known > 0).all():
        raise ValueError(
            f"values must be greater than zero on a logarithmic scale; the least is {known.min():g}"
        )
    low = known.min() if scale.low is None else scale.low
    high = known.max() if scale.high is None else scale.high
    if not low < high:
        low, high = low - 0.5 * abs(low) - 1e-12, high + 0.5 * abs(high) + 1e-12
    ticks = _ticks_of_colours(low, high, scale.log)
    texts = [_tick_text(tick, scale.log) for tick in ticks]
    if known.max() > high:
        texts[-1] = f"≥ {texts[-1]}"
    if known.min() < low:
        texts[0] = f"≤ {texts[0]}"
    as_drawn = np.log10 if scale.log else np.asarray
    fig.layout.coloraxis = {
        "cmin": float(as_drawn(low)),
        "cmax": float(as_drawn(high)),
        "cmid": None if scale.middle is None else float(as_drawn(scale.middle)),
        "colorscale": _colours(scale, as_drawn(low), as_drawn(high), as_drawn),
        "colorbar": {
            "title": {"text": label, "side": "right"},
            "tickvals": [float(as_drawn(tick)) for tick in ticks],
            "ticktext": texts,
        },
    }
    if scale.middle is not None:
        fig.layout.coloraxis.cmid = None  # it would move an end; the colours are bent instead
    return as_drawn(values)


def _colours(scale: ColourScale, low: float, high: float, as_drawn):
    """Return plotly's colour scale, with its middle moved to scale.middle."""
    if scale.middle is None:
        return scale.colours
    from plotly.colors import get_colorscale

    middle = (float(as_drawn(scale.middle)) - low) / (high - low)
    if not 0 < middle < 1:
        raise ValueError(f"scale.middle must lie between both ends; it is {scale.middle:g}")
    bent = []
    for place, colour in get_colorscale(scale.colours):
        beyond = middle + (place - 0.5) / 0.5 * (1 - middle)
        bent.append([place / 0.5 * middle if place < 0.5 else beyond, colour])
    return bent


def _ticks_of_colours(low: float, high: float, log: bool) -> list[float]:
    """Return ticks of a colour bar: both ends, and round numbers between them and not near them."""
    if log:
        margin = _FREE_OF_TICKS * np.log10(high / low)
        first, last = int(np.ceil(np.log10(low) + margin)), int(np.floor(np.log10(high) - margin))
        every = max(1, -(-(last - first + 1) // 5))
        inner = [10.0**power for power in range(first, last + 1, every)]
    else:
        step = 10.0 ** np.floor(np.log10((high - low) / 2))
        step *= next(factor for factor in (1, 2, 5, 10) if (high - low) / (factor * step) <= 6)
        margin = _FREE_OF_TICKS * (high - low)
        first, last = np.ceil((low + margin) / step), np.floor((high - margin) / step)
        inner = [step * k for k in np.arange(first, last + 1)]
    return [low, *inner, high]


def _tick_text(value: float, log: bool) -> str:
    """Return a number as the colour bar writes it: a power of ten where it is one, else three
    digits."""
    power = np.log10(value) if log and value > 0 else np.nan
    if abs(power - np.round(power)) < 1e-9 and abs(power) > 1.5:
        return f"10<sup>{round(power)}</sup>".replace("-", "\N{MINUS SIGN}")
    return f"{value:.3g}".replace("-", "\N{MINUS SIGN}")


# ---- axes ----


def _axis_name(letter: str, number: int) -> str:
    return letter if number == 1 else f"{letter}{number}"


def _layout_key(axis: str) -> str:
    """Return the layout's key of an axis: "x2" is described by "xaxis2"."""
    return f"{axis[0]}axis{axis[1:]}"


def _part(index: int, parts: int, gap: float) -> list[float]:
    """Return where one of several panels begins and ends, as parts of the whole."""
    width = (1 - gap * (parts - 1)) / parts
    begin = index * (width + gap)
    return [round(begin, 6), round(begin + width, 6)]


def _title_of_panel(title: str, x_name: str, y_name: str) -> dict:
    return {
        "text": f"<b>{title}</b>",
        "showarrow": False,
        "x": 0,
        "xanchor": "left",
        "xref": f"{x_name} domain",
        "y": 1,
        "yanchor": "bottom",
        "yref": f"{y_name} domain",
    }


def _title_at(fig: Figure, y_name: str) -> str:
    """Return the title of the panel with this y axis, or ""."""
    titles = [note.text for note in fig.layout.annotations if note.yref == f"{y_name} domain"]
    return re.sub("</?b>", "", titles[0]) if titles else ""


def _ticks_in_parts_of_pi(parts: int) -> dict:
    """Return ticks at multiples of pi / parts; of those far away, which plotly leaves out, there
    are enough."""
    multiples = range(-_LARGEST_ANGLE * parts, _LARGEST_ANGLE * parts + 1)
    return {
        "tickmode": "array",
        "tickvals": [np.pi * k / parts for k in multiples],
        "ticktext": [_fraction_of_pi(Fraction(k, parts)) for k in multiples],
    }


def _fraction_of_pi(part: Fraction) -> str:
    if part == 0:
        return "0"
    top = "π" if abs(part.numerator) == 1 else f"{abs(part.numerator)}π"
    sign = "\N{MINUS SIGN}" if part < 0 else ""
    return f"{sign}{top}" if part.denominator == 1 else f"{sign}{top}/{part.denominator}"


def _axes_of(fig: Figure, panel: int) -> list[str]:
    """Return the names of the axes of a panel, ["x2", "y2"]."""
    meta = fig.layout.meta
    if not isinstance(meta, Mapping) or "panels" not in meta:
        raise ValueError("fig must be a chart that charts.panels or charts.lines made")
    axes = meta["panels"]
    if not isinstance(panel, int) or not 0 <= panel < len(axes):
        raise ValueError(f"panel must be from 0 to {len(axes) - 1}; it is {panel!r}")
    return axes[panel]


def _hover_line(label: str, letter: str) -> str:
    """Return the line under the pointer for one coordinate: "time: %{x:.4~g} s"."""
    name, unit = _split(label)
    return f"{name}: %{{{letter}:.4~g}}{unit}"


def _hover_of(fig: Figure, axis: str, letter: str) -> str:
    return _hover_line(fig.layout[_layout_key(axis)].title.text, letter)


def _name_and_unit(fig: Figure, axis: str) -> tuple[str, str]:
    return _split(fig.layout[_layout_key(axis)].title.text)


def _split(label: str) -> tuple[str, str]:
    """Return what a label names and its unit, with a space before it: "time (s)" gives "time" and "
    s"."""
    parts = re.fullmatch(r"(.+?) \(([^()]*)\)", label)
    return (parts[1], f" {parts[2]}") if parts else (label, "")


def _for_each_panel(label: str | Sequence[str], name: str, count: int) -> list[str]:
    labels = [label] * count if isinstance(label, str) else list(label)
    if len(labels) != count:
        raise ValueError(f"{name} must be one or {count}, one for each panel; it has {len(labels)}")
    return [_words(label, name) for label in labels]


def _words(text: str, name: str, may_be_empty: bool = False) -> str:
    """Return words for a chart, which has no TeX: refuse formulas between dollars, which would stay
    as they are."""
    if not isinstance(text, str) or not (text.strip() or may_be_empty):
        raise ValueError(f"{name} must be words; it is {text!r}")
    if "$" in text:
        raise ValueError(
            f"{name} must not hold formulas between dollars, which a chart does not typeset: write "
            f"q<sub>1</sub>, x² or ε instead; it is {text!r}"
        )
    return text
