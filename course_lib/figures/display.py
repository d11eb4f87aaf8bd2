"""Put a figure into the notebook, always with words that say what it shows."""

import io
from itertools import accumulate
from typing import NamedTuple

from course_lib.figures import stills, stored_chart

# A plot of one panel is drawn small, so that its letters are large on a phone, and is shown larger
# where there is room, until its letters are those of the text around it or it fills the column.
_MAX_ENLARGEMENT = 1.35  # letters of 10 points become 18 pixels high
_MAX_SHOWN = (760, 600)  # pixels: the column's width, and a height that a laptop shows whole
_DOTS_PER_INCH = 192  # twice the dots of a plot's own size


class Picture(NamedTuple):
    """A figure with the words that `show` puts beside it.

    Parameters
    ----------
    fig : plotly.graph_objects.Figure or matplotlib.figure.Figure
    alt : str
        What it shows, in a sentence or two, for those who do not see it.
    caption : str, optional
        What to notice in it, one sentence in Markdown.
    """

    fig: object
    alt: str
    caption: str = ""


def show(fig, *, alt="", caption=""):
    """Display a figure with alternative text and, below it, a caption.

    Parameters
    ----------
    fig : Picture, plotly.graph_objects.Figure or matplotlib.figure.Figure
        What to display. A Picture has words of its own, which may be replaced. Of a plotly figure
        the notebook stores its data, which JupyterLab and the pages draw; `make notebooks` adds a
        PNG for places that draw nothing.
    alt : str
        What the figure shows, in a sentence or two, for those who do not see it.
    caption : str, optional
        What to notice in it, one sentence in Markdown, formulas between dollars. It does not repeat
        `alt`.

    Raises
    ------
    ValueError
        If `alt` says nothing, if `caption` is no text, or if `fig` is no figure, or one that no
        page can draw (see `course_lib.figures.stored_chart`).

    Examples
    --------
    >>> from course_lib.figures import lines
    >>> show(lines([0, 1], {"a": [0, 1]}, xlabel="time (s)", ylabel="height (m)"), alt="A plot")
    Traceback (most recent call last):
        ...
    ValueError: alt must say in words what the figure shows; it is 'A plot'
    """
    if hasattr(fig, "stored"):  # a toy, which has words of its own
        return fig._ipython_display_()
    if isinstance(fig, Picture):
        fig, alt, caption = fig.fig, alt or fig.alt, caption or fig.caption
    if not isinstance(alt, str) or len(alt.strip()) < 20:
        raise ValueError(f"alt must say in words what the figure shows; it is {alt!r}")
    if not isinstance(caption, str):
        raise ValueError(f"caption must be a sentence that says what to notice; it is {caption!r}")
    if stored_chart.is_chart(fig):
        _show_chart(fig, alt)
    elif hasattr(fig, "savefig"):
        _show_plot(fig, alt)
    else:
        raise ValueError(
            f"fig must be a plotly or matplotlib figure; it is of type {type(fig).__name__}"
        )
    show_caption(caption)


def _show_chart(fig, alt):
    """Display a plotly figure: its data and, except in JupyterLab, the stored PNG if it still shows
    these.

    JupyterLab would show the PNG until a pointer enters it.
    """
    from IPython.display import display

    chart = stored_chart.stored(fig)
    width, height = stored_chart.size(chart)
    data = {stored_chart.PLOTLY: chart, "text/plain": alt}
    still = None if stills.is_live() else stills.stored_stills().get(stills.as_key(chart))
    if still:
        data["image/png"] = still
    metadata = {"alt": alt, "width": width, "height": height}
    display(data, raw=True, metadata={"image/png": metadata})


def _show_plot(fig, alt):
    """Display a matplotlib figure as a PNG."""
    from IPython.display import display

    # Before the cuts: drawing it puts its panels into place.
    data = {"image/png": _png(fig), "text/plain": alt}
    width, height = (96 * inches for inches in fig.get_size_inches())
    cuts = _cuts(fig, width)
    if not cuts:
        room = min(_MAX_SHOWN[0] / width, _MAX_SHOWN[1] / height)
        enlargement = max(1, min(_MAX_ENLARGEMENT, room))
        width, height = enlargement * width, enlargement * height
    metadata = {"alt": alt, "width": round(width), "height": round(height)} | cuts
    display(data, raw=True, metadata={"image/png": metadata})


def show_caption(caption, remark=""):
    """Display a caption, Markdown or "", as an output of its own.

    Pages join it to the figure before it. They leave out the remark, which is for places where a
    stored notebook is looked at and the figure before it is a picture.
    """
    from IPython.display import display

    if not caption:
        return
    words = f"{caption} *{remark}*" if remark else caption
    display(
        {"text/markdown": words, "text/plain": words},
        raw=True,
        metadata={"caption": caption},
    )


def _cuts(fig, width):
    """Where pages may cut a drawn figure between columns of panels, in pixels from the left; {} if
    it is not wide."""
    boxes = [
        ax.get_tightbbox() for ax in fig.axes if ax.get_label() != "<colorbar>" and width > 700
    ]
    boxes.sort(key=lambda box: box.x0)
    ends = accumulate(
        (box.x1 for box in boxes), max
    )  # of each panel and those that begin left of it
    cuts = [(end + box.x0) / 2 for end, box in zip(ends, boxes[1:], strict=False) if end < box.x0]
    return {"cuts": [round(x / fig.bbox.width * width) for x in cuts]} if cuts else {}


def _png(fig):
    """The figure as PNG, without the version of matplotlib, which would change it."""
    buffer = io.BytesIO()
    uncompressed = {"compress_level": 0}  # smaller_png compresses it
    fig.savefig(
        buffer,
        format="png",
        dpi=_DOTS_PER_INCH,
        facecolor="white",
        metadata={"Software": None},
        pil_kwargs=uncompressed,
    )
    return smaller_png(buffer.getvalue())


def smaller_png(content):
    """Return a PNG file (bytes) with at most 256 colours if that is smaller: a third, with no
    visible difference."""
    from PIL import Image

    picture = Image.open(io.BytesIO(content)).convert("RGB")
    picture = picture.quantize(256, Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
    picture.save(smaller := io.BytesIO(), "PNG", optimize=True)
    return min(content, smaller.getvalue(), key=len)
