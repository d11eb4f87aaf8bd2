"""What a notebook stores of a plotly figure: JSON that every machine writes alike, and every page
can draw."""

from __future__ import annotations

import base64
import json
import math
from typing import TYPE_CHECKING

import numpy as np

from course_lib.figures import charts
from course_lib.figures.digits import decimals_for, rounded

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

PLOTLY = "application/vnd.plotly.v1+json"  # MIME type, which JupyterLab draws by plotly's extension
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

    Coordinates have the digits that their axis shows: on a linear axis a hundred-thousandth of what
    it spans is kept, on a logarithmic one five digits of each number. Other numbers have five
    digits of the largest one of their list. NaN and infinities, which JSON does not have, become
    null, which plotly leaves out.

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
    series = [_unpacked(part) for part in figure["data"]]
    axes = _Axes(layout, series)
    data = [_rounded_series(part, axes) for part in series]
    json_of_figure = {"data": data, "layout": _rounded(_unpacked(layout)), "config": CONFIG}
    if figure.get("frames"):
        json_of_figure["frames"] = _rounded(_unpacked(figure["frames"]))
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


class _Axes:
    """What the plane axes of a chart span.

    Parameters
    ----------
    layout : dict
        Of the figure's JSON.
    data : list of dict
        Its series.
    """

    def __init__(self, layout: dict, data: list[dict]):
        self._of_layout = {
            key.replace("axis", ""): axis for key, axis in layout.items() if "axis" in key[:5]
        }
        self._numbers = {}
        for series in data:
            for key in ("x", "y"):
                found = self._numbers.setdefault(series.get(f"{key}axis", key), [])
                found += _flat_numbers(series.get(key) or [])

    def is_logarithmic(self, name: str) -> bool:
        """Return whether an axis, such as "x" or "y2", is logarithmic."""
        return self._of_layout.get(name, {}).get("type") == "log"

    def span(self, name: str) -> float:
        """Return what a linear axis spans: its range, or the range of all numbers on it.

        Where the numbers are one number, this is its size, because plotly then chooses a range.
        """
        ends = _flat_numbers(self._of_layout.get(name, {}).get("range") or [])
        numbers = ends if len(ends) == 2 else self._numbers[name]
        if not numbers:
            return 0
        return abs(max(numbers) - min(numbers)) or max(map(abs, numbers))


def _rounded_series(series: dict, axes: _Axes) -> dict:
    """Return a series with rounded numbers; those on a logarithmic axis keep digits of their
    own."""
    result = {}
    for key, value in series.items():
        name = series.get(f"{key}axis", key)
        if key not in ("x", "y") or not isinstance(value, list):
            result[key] = _rounded(value, own_digits=key == "customdata")
        elif axes.is_logarithmic(name):
            result[key] = _rounded(value, own_digits=True)
        else:
            result[key] = _with_decimals(value, decimals_for(axes.span(name)))
    return result


def _rounded(node: object, own_digits: bool = False) -> object:
    """Return JSON with rounded numbers, 0 for -0 and null for NaN."""
    if isinstance(node, dict):
        return {key: _rounded(value, own_digits) for key, value in node.items()}
    if isinstance(node, list):
        numbers = _flat_numbers(node)
        if own_digits or not numbers:
            return [_rounded(item, own_digits) for item in node]
        return _with_decimals(node, decimals_for(max(map(abs, numbers))))
    if isinstance(node, float):
        return rounded(node, decimals_for(node))
    return node


def _with_decimals(items: list, decimals: int) -> list:
    """Return a list, and the lists in it, with so many decimals."""
    result = []
    for item in items:
        if isinstance(item, list):
            result.append(_with_decimals(item, decimals))
        elif isinstance(item, float):
            result.append(rounded(item, decimals))
        else:
            result.append(_rounded(item))
    return result


def _flat_numbers(items: object) -> list[float]:
    """Return the finite floats of a list and of the lists in it."""
    if isinstance(items, list | tuple):
        return [number for item in items for number in _flat_numbers(item)]
    is_number = isinstance(items, float | int) and not isinstance(items, bool)
    return [float(items)] if is_number and math.isfinite(items) else []


def _unpacked(node: object) -> object:
    """Return JSON in which each array that plotly has packed into base64 is a nested list."""
    if isinstance(node, list):
        return [_unpacked(item) for item in node]
    if not isinstance(node, dict):
        return node
    if "bdata" not in node:
        return {key: _unpacked(value) for key, value in node.items()}
    array = np.frombuffer(base64.b64decode(node["bdata"]), np.dtype(node["dtype"]))
    if "shape" in node:  # "3, 4" for two axes, absent for one
        array = array.reshape([int(length) for length in str(node["shape"]).split(",")])
    return array.tolist()
