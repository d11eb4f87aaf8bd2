"""What a notebook stores of a plotly figure: JSON that every machine writes alike, and every page
can draw."""

from __future__ import annotations

import base64
import json
import math
from typing import TYPE_CHECKING

import numpy as np

from course_lib.figures import charts

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

PLOTLY = "application/vnd.plotly.v1+json"  # MIME type, which JupyterLab draws by plotly's extension
DIGITS = (
    6  # enough for every pixel of a screen, and far from the last bits, in which machines differ
)
# Added before rounding, in units of the last digit kept: a number half-way between two of them, as
# 0.5 m is in steps of 1 m, would otherwise be rounded up on one machine and down on another.
_OFF_TIES = 0.0137
# Without "responsive", which charts.js sets on pages: JupyterLab fits charts itself, and with it
# they
# would vanish there when its theme is switched.
CONFIG = {
    "displaylogo": False,
    "showSendToCloud": False,  # plotly would offer to upload the figure
    "modeBarButtonsToRemove": ["select2d", "lasso2d", "autoScale2d"],
}
# Maps of the Earth fetch their tiles or coastlines from a server when they are drawn.
FROM_THE_NET = (
    "choropleth",
    "choroplethmap",
    "densitymap",
    "scattergeo",
    "scattermap",
)


def is_chart(fig: object) -> bool:
    """Return whether something is a plotly figure, or the dict of one."""
    return hasattr(fig, "to_plotly_json") or (isinstance(fig, dict) and "data" in fig)


def stored(fig: Figure | dict) -> dict:
    """Return what a notebook stores of a plotly figure under the MIME type PLOTLY.

    Numbers have six digits: each of its own on a logarithmic axis, else of the largest number of
    their list. NaN and infinities, which JSON does not have, become null, which plotly leaves out.

    Parameters
    ----------
    fig : plotly.graph_objects.Figure or dict
        A dict is that of a figure's JSON. The figure is not changed. Where it has plotly's
        default template, what is stored has the course's style.

    Returns
    -------
    dict
        With the keys "data", "layout", "config" and, if there are any, "frames".

    Raises
    ------
    ValueError
        If the figure is empty, if plotly does not know a part of it, if it would fetch something
        from the net, or if it holds what JSON cannot store.
    """
    figure = _as_json(fig)
    if not figure.get("data"):
        raise ValueError("fig must hold at least one series; it is empty")
    layout = figure.setdefault("layout", {})
    _refuse_what_is_fetched(figure)
    if layout.get("template") == _default_template():
        layout["template"] = {"layout": charts.STYLE}
    layout.setdefault("height", 400)
    logarithmic = _logarithmic_axes(layout)
    data = [_rounded_series(series, logarithmic) for series in figure["data"]]
    json_of_figure = {"data": data, "layout": _rounded(layout), "config": CONFIG}
    if figure.get("frames"):
        json_of_figure["frames"] = _rounded(figure["frames"])
    return json_of_figure


def size(chart: dict) -> tuple[int, int]:
    """Return the width and the height, in pixels, at which a stored chart becomes a picture."""
    layout = chart.get("layout", {})
    return round(layout.get("width") or charts.WIDTH), round(layout.get("height") or 400)


def _as_json(fig: Figure | dict) -> dict:
    """Return a figure as JSON, in which arrays are still packed."""
    from plotly.graph_objects import Figure

    try:
        valid = Figure(fig) if isinstance(fig, dict) else fig
        return json.loads(valid.to_json(validate=False, engine="json"))
    except (AttributeError, TypeError, ValueError) as error:
        reason = " ".join(str(error).split())
        raise ValueError(f"fig must be a figure that plotly can draw: {reason:.250}") from error


def _refuse_what_is_fetched(figure: dict) -> None:
    """Raise ValueError for what would be fetched from the net."""
    for number, series in enumerate(figure["data"]):
        if series.get("type") in FROM_THE_NET:
            raise ValueError(
                f"fig.data[{number}] is of type {series['type']!r}, which fetches a map from the "
                "net; notebooks and pages of the course work without one"
            )
    images = [*figure["data"], *(figure["layout"].get("images") or [])]
    for image in images:
        source = image.get("source")
        if source is not None and not str(source).startswith("data:"):
            raise ValueError(
                f"fig holds an image by its address {source!r}; put the image itself into the "
                "figure, as a data: URI"
            )


def _default_template() -> dict:
    import plotly.io

    template = plotly.io.templates[plotly.io.templates.default or "none"]
    return json.loads(json.dumps(template.to_plotly_json()))


def _logarithmic_axes(layout: dict) -> set[str]:
    """Return the names of the axes that are logarithmic, such as "x" or "y2"."""
    axes = {key.replace("axis", ""): axis for key, axis in layout.items() if "axis" in key[:5]}
    return {name for name, axis in axes.items() if axis.get("type") == "log"}


def _rounded_series(series: dict, logarithmic: set[str]) -> dict:
    """Return a series with rounded numbers: those on a logarithmic axis keep digits of their
    own."""
    rounded = {}
    for key, value in series.items():
        axis = series.get(f"{key}axis", key)
        is_log = key in ("x", "y") and axis in logarithmic
        rounded[key] = _rounded(value, own_digits=is_log or key == "customdata")
    return rounded


def _rounded(node: object, own_digits: bool = False) -> object:
    """Return JSON with rounded numbers, packed arrays unpacked, 0 for -0 and null for NaN."""
    if isinstance(node, dict) and "bdata" in node:
        node = _unpacked(node)
    if isinstance(node, dict):
        return {key: _rounded(value, own_digits) for key, value in node.items()}
    if isinstance(node, list):
        return _rounded_list(node, own_digits)
    if isinstance(node, float):
        return _round(node, _decimals(node))
    return node


def _rounded_list(items: list, own_digits: bool) -> list:
    numbers = _flat_numbers(items)
    if own_digits or not numbers:
        return [_rounded(item, own_digits) for item in items]
    decimals = _decimals(max(abs(number) for number in numbers))

    def rounded(item):
        if isinstance(item, list):
            return [rounded(inner) for inner in item]
        if isinstance(item, float):
            return _round(item, decimals)
        return _rounded(item)

    return [rounded(item) for item in items]


def _flat_numbers(items: list) -> list[float]:
    """Return the finite floats of a list and of the lists in it."""
    numbers = []
    for item in items:
        if isinstance(item, list):
            numbers += _flat_numbers(item)
        elif isinstance(item, float) and math.isfinite(item):
            numbers.append(item)
    return numbers


def _decimals(largest: float) -> int:
    """Return how many decimals leave DIGITS digits of a number."""
    if not math.isfinite(largest) or largest == 0:
        return DIGITS
    return DIGITS - 1 - math.floor(math.log10(abs(largest)))


def _round(number: float, decimals: int) -> float | None:
    if not math.isfinite(number):
        return None
    if decimals > 300:  # 10 ** -decimals would be 0
        return 0.0
    return round(number + _OFF_TIES * 10.0**-decimals, decimals) + 0.0


def _unpacked(packed: dict) -> list:
    """Return an array that plotly has packed into base64 as nested lists."""
    array = np.frombuffer(base64.b64decode(packed["bdata"]), np.dtype(packed["dtype"]))
    if "shape" in packed:  # "3, 4" for two axes, absent for one
        array = array.reshape([int(length) for length in str(packed["shape"]).split(",")])
    return array.tolist()
