"""Draw charts as PNGs by kaleido, which runs plotly in a browser without a window."""

from __future__ import annotations

import asyncio
from collections.abc import Sequence
from typing import TYPE_CHECKING

from course_lib.figures.stored_chart import size
from course_lib.pack.photograph import MAX_SECONDS, find_browser

if TYPE_CHECKING:
    from kaleido import Kaleido

CLOSING_SECONDS = 30
SCALE = 1.5  # pixels of the PNG for one on the page, as the PNGs of matplotlib have
# What is pressed or dragged does not belong into a picture.
_CONTROLS = ("updatemenus", "sliders")


class ChartNotDrawn(Exception):
    """A chart that plotly cannot draw; the text says which, and why."""


def draw_charts(charts: Sequence[dict]) -> list[bytes]:
    """Return PNG files of stored charts, drawn by one browser after each other.

    Raises TimeoutError if there is no browser, or it fails, and ChartNotDrawn for a chart that
    plotly refuses.
    """
    from kaleido.errors import BrowserClosedError, BrowserFailedError, ChromeNotFoundError

    browser = find_browser()
    try:
        return asyncio.run(_draw(browser, charts))
    except (BrowserClosedError, BrowserFailedError, ChromeNotFoundError, OSError) as error:
        raise TimeoutError(f"the browser {browser} failed: {type(error).__name__}") from error


async def _draw(browser: str, charts: Sequence[dict]) -> list[bytes]:
    # Not kaleido's sync server: its calls wait forever for a browser that did not start.
    from kaleido import Kaleido

    # MathJax would come from the net, and charts have no formulas.
    kaleido = Kaleido(n=1, timeout=MAX_SECONDS, mathjax=False, path=browser)
    try:
        # Kaleido's own timeout begins with a picture, and so after the browser has answered.
        async with asyncio.timeout(MAX_SECONDS):
            await kaleido.open()
        return [await _draw_one(kaleido, chart) for chart in charts]
    finally:
        # A browser that does not answer is not asked to close for longer than this: it is killed.
        async with asyncio.timeout(CLOSING_SECONDS):
            await kaleido.close()


async def _draw_one(kaleido: Kaleido, chart: dict) -> bytes:
    from kaleido.errors import KaleidoError

    width, height = size(chart)
    layout = {key: value for key, value in chart["layout"].items() if key not in _CONTROLS}
    options = {"format": "png", "width": width, "height": height, "scale": SCALE}
    try:
        return await kaleido.calc_fig({"data": chart["data"], "layout": layout}, opts=options)
    except KaleidoError as error:
        names = ", ".join(repr(series.get("name", "")) for series in chart["data"])
        reason = " ".join(str(error).split())
        raise ChartNotDrawn(
            f"plotly cannot draw the chart with the series {names:.80}: {reason:.200}"
        ) from error
