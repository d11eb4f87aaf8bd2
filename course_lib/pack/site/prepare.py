"""Turn an executed notebook into a copy that MyST-NB can show.

Toys, charts, and pictures with alternative text become HTML.
"""

import base64
import hashlib
import html
import io
import json
import re
import textwrap
from itertools import pairwise
from pathlib import Path
from urllib.parse import quote

import nbformat
from PIL import Image

from course_lib.figures.stills import TOY
from course_lib.figures.stored_chart import PLOTLY, size
from course_lib.pack.more import TAG, heading_level
from course_lib.pack.site import SiteError
from course_lib.pack.site.answers import (
    defined_answers,
    fold,
    fold_what_serves,
    is_written,
    leave_out,
)
from course_lib.pack.site.links import notebook_number
from course_lib.pack.site.sections import PAGES as SECTION_PAGES

OPENING = 4  # cells, with the first figure among them
# The words of a prediction's box before its choices, and what a page says instead: it runs no code.
OPEN_QUESTION = re.compile(r'(<div class="course-predict"[^>]*>)[^<]*(?=<details)')
HOW_TO_CHOOSE = (
    r"\1Choose before you read on. Then open your choice: it holds the reply. "
    "(In JupyterLab you write your choice into the cell.)"
)
NAME_LETTERS = 36  # of a line of the legend on a phone, as charts.js has it
# A link of a text to the cell that shows a figure, as JupyterLab follows it; on the page of another
# notebook the notebook's name is before the hash.
FIGURE_LINK = re.compile(r"\[([^]]*)\]\(([\w-]*\.ipynb)?#cell-id=([\w-]+)\)")
SHOWN = '<figure class="shown">'  # a figure with a caption, which conf.py numbers
# MyST keeps no tags of text; conf.py folds the sections of this class
MORE = "```{rst-class} more\n```\n\n"
IMAGES = {"image/svg+xml": "svg", "image/png": "png", "image/jpeg": "jpg", "image/gif": "gif"}


def prepare(notebook: Path, folder: Path, solutions: bool = True, model: bool = False) -> None:
    """Write to `folder` a copy of `notebook` with HTML for its figures and pictures.

    Pictures go to `folder/_static/pictures`, named by their content. The notebook itself is only
    read.

    With `solutions` the answers are folded, else left out; with `model` those to written questions
    are folded. Raises SiteError, which names notebook and cell, for what must not be published.
    """
    try:
        book = nbformat.read(notebook, as_version=4)
    except (ValueError, nbformat.validator.NotebookValidationError) as error:
        raise SiteError(f"{notebook.name} is not a notebook: {error}") from error
    code_cells = [cell for cell in book.cells if cell.cell_type == "code"]
    if code_cells and not any(cell.outputs for cell in code_cells):
        raise SiteError(f"{notebook.name} holds no outputs. Run it and save it first.")

    answers = defined_answers(book)
    for number, cell in enumerate(book.cells, 1):
        place = f"{notebook.name}, cell {number}"
        if cell.cell_type == "code" and cell.source.strip() and cell.execution_count is None:
            raise SiteError(
                f"{place} was changed, and not run since. Run the notebook and save it."
            )
        if solutions or (model and is_written(cell)):
            fold(cell)
        else:
            leave_out(cell, place, answers)
        if cell.get("attachments"):
            _show_attached(cell, place, folder)
        if TAG in cell.metadata.get("tags", []) and heading_level(cell):
            cell.source = MORE + cell.source
        if cell.cell_type == "code":
            fold_what_serves(cell, is_opening=number <= OPENING)
        if cell.get("outputs"):
            _move_captions(cell)
        for output in cell.get("outputs", []):
            if output.output_type == "error":
                if "raises-exception" not in cell.metadata.get("tags", []):
                    raise SiteError(f"{place} stopped with {output.ename}: {output.evalue}")
            elif output.output_type != "stream":
                show(output, place, folder)
    name_figures(book, notebook.name)
    nbformat.write(book, folder / notebook.name)


def name_figures(book: nbformat.NotebookNode, name: str) -> None:
    """Replace the links to cells by links to the figures that these cells show, "Figure 5.1".

    `book` is a prepared notebook, and `name` that of its file. The words of a link are kept where
    its cell shows no figure with a number, and where the figure is on another page: such links are
    not looked up. Raises SiteError, which names notebook and cell, if a notebook has no such cell.
    """
    notebook = notebook_number(name)
    cells = {cell.id for cell in book.cells}
    numbers = _figure_numbers(book) if notebook else {}
    for position, cell in enumerate(book.cells, 1):
        if cell.cell_type != "markdown":
            continue
        place = f"{name}, cell {position}"

        def named(link: re.Match, place: str = place) -> str:
            words, page, cell_id = link.groups()
            # A page of sections of all notebooks has not the cells of these notebooks.
            if name.removesuffix(".ipynb") in SECTION_PAGES:
                return words
            if not page and cell_id not in cells:
                raise SiteError(f"{place} links to the cell {cell_id}, which is not there.")
            if page or cell_id not in numbers:
                return words
            number = numbers[cell_id]
            return f'<a href="#figure-{number}">Figure {notebook}.{number}</a>'

        cell.source = FIGURE_LINK.sub(named, cell.source)


def _figure_numbers(book: nbformat.NotebookNode) -> dict[str, int]:
    """Return {cell: the number of the first figure that it shows} of a prepared notebook."""
    numbers = {}
    count = 0
    for cell in book.cells:
        for output in cell.get("outputs", []):
            if SHOWN in output.get("data", {}).get("text/html", ""):
                count += 1
                numbers.setdefault(cell.id, count)
    return numbers


def show(output, place: str, folder: Path) -> None:
    """Give `output` the HTML that the page shows, if MyST-NB would not show it properly."""
    image = next((kind for kind in IMAGES if kind in output.data), None)
    if PLOTLY in output.data:
        alt = alternative(output, place)
        still = picture(output, image, "picture chart-still", alt, folder) if image else ""
        output.data = {"text/html": _captioned(_chart(output.data[PLOTLY], alt, still), output)}
    elif figure := output.data.get(TOY):
        alt = alternative(output, place)
        still = picture(output, image, "toy-still", alt, folder) if image else ""
        output.data = {"text/html": _captioned(_figure(figure, alt, still), output)}
    elif image and "text/html" not in output.data:
        shown = picture(output, image, "picture", alternative(output, place), folder)
        output.data = {"text/html": _captioned(shown, output)}
    elif "text/html" in output.data:
        page = mark_dollars(output.data["text/html"])
        output.data["text/html"] = OPEN_QUESTION.sub(HOW_TO_CHOOSE, page)


def _show_attached(cell, place: str, folder: Path) -> None:
    """Store the pictures that were pasted into a cell of text, and let the text refer to them.

    JupyterLab keeps them beside the text, where MyST-NB does not look.
    """
    for name, forms in cell.attachments.items():
        kind = next((kind for kind in IMAGES if kind in forms), None)
        reference = re.compile(
            rf"!\[([^]]*)\]\(attachment:(?:{re.escape(name)}|{re.escape(quote(name))})(?=[)\s])"
        )
        shown = reference.findall(cell.source)
        if not (kind and shown):
            continue
        for alt in map(str.strip, shown):
            if not alt or alt == name or re.fullmatch(r"[\w-]+\.\w{3,4}", alt):
                raise SiteError(
                    f"{place} shows a picture without alternative text. Write what it shows "
                    f"between the brackets: ![the arm at rest](attachment:{name})."
                )
        text = forms[kind]
        content = text.encode() if kind == "image/svg+xml" else base64.b64decode(text)
        path = _path_of(content, IMAGES[kind], folder)
        cell.source = reference.sub(rf"![\1]({path.as_posix()}", cell.source)
    left = re.search(r"(?:src=[\"']?|\]\()attachment:([^)\s\"'>]*)", cell.source)
    if left:
        raise SiteError(
            f"{place} refers to the picture attachment:{left[1]} in a form that a page does not "
            f"show. Write ![what it shows](attachment:{left[1]}), and paste the picture there."
        )


def _move_captions(cell) -> None:
    """Move each caption into the metadata of its figure.

    A caption is stored as an output of its own after the figure.
    """
    kept = []
    for output in cell.outputs:
        if kept and "text/markdown" in output.get("data", {}) and output.metadata.get("caption"):
            kept[-1].metadata["caption"] = output.metadata["caption"]
        else:
            kept.append(output)
    cell.outputs = kept


def _captioned(shown: str, output) -> str:
    """Return a figure with its caption below it, if its output has one."""
    caption = output.metadata.get("caption")
    if not caption:
        return shown
    words = re.sub(r"\*(\w[^*$]*)\*", r"<em>\1</em>", html.escape(caption, quote=False))
    words = mark_dollars(re.sub(r"`([^`]+)`", r"<code>\1</code>", words))
    return f"{SHOWN}{shown}<figcaption>{words}</figcaption></figure>"


def mark_dollars(page: str) -> str:
    """Return HTML in which formulas between dollars are marked for Sphinx.

    JupyterLab typesets such formulas. The contents of code and of attributes are left as they are.
    """
    parts = re.split(
        r"(<(?:code|pre|script|style)\b.*?</(?:code|pre|script|style)>|<[^>]*>)",
        page,
        flags=re.DOTALL,
    )
    parts[::2] = [
        re.sub(r"\$([^$]+)\$", r'<span class="math" data-tex="\1"></span>', text)
        for text in parts[::2]
    ]
    return "".join(parts)


def alternative(output, place: str) -> str:
    """Return the alternative text of a figure, wherever its output stores it."""
    kept = [output.metadata.get(kind, {}).get("alt") for kind in IMAGES]
    alt = next((words for words in [*kept, output.metadata.get("alt")] if words), None)
    if alt is None:
        alt = output.data.get("text/plain", "")
        # "<Figure size 640x480 with 1 Axes>" and "Figure({…" are no help to a reader.
        if not alt or re.match(r"<.*>$|\w+\(", alt):
            raise SiteError(
                f"{place} shows a figure without alternative text. Use show(fig, alt=…)."
            )
    return " ".join(alt.split())


def _figure(figure: dict, alt: str, still: str) -> str:
    """Return a toy as data that figures.js draws.

    Until then, and in print, its still picture shows. Without a still picture the alternative text
    takes its place, except in print.
    """
    meta = figure["layout"]["meta"]["course"]
    fallback = still or f'<p class="toy-words">{html.escape(alt)}</p>'
    kind = html.escape(meta["kind"])
    scripts = html.escape(" ".join(meta["scripts"]))
    return (
        f'<div class="toy-figure" data-kind="{kind}" data-scripts="{scripts}" '
        f'role="group" aria-label="{html.escape(alt)}">{fallback}'
        f'<div class="toy-live"></div>{_data(figure)}</div>'
    )


def _chart(chart: dict, alt: str, still: str) -> str:
    """Return a chart as data that charts.js draws, and a folded place for its numbers.

    Until it is drawn, without scripts and in print its picture shows, else its words.
    """
    fallback = still or f'<p class="chart-words">{html.escape(alt)}</p>'
    room, on_phone = size(chart)[1], _height_on_phone(chart)
    return (
        f'<div class="chart-figure" style="--room:{room}px;--room-on-phone:{on_phone}px" '
        f'role="group" aria-label="{html.escape(alt)}">{fallback}'
        f'<div class="chart-live"></div>{_data(chart)}</div>'
        '<details class="chart-numbers" hidden><summary>The numbers</summary></details>'
    )


def _height_on_phone(chart: dict) -> int:
    """Return how high a chart is on a phone, where panels stand below each other, in pixels.

    A plane with equal scales is there about as high as it is wide.
    """
    layout, height = chart["layout"], size(chart)[1]
    meta = layout.get("meta") or {}
    panels, columns = len(meta.get("panels", [0])), meta.get("columns", 1)
    axes = [axis for key, axis in layout.items() if key.startswith("yaxis")]
    is_plane = any(axis.get("scaleanchor") for axis in axes)
    if is_plane and panels == 1:
        height = min(height, 340)
    if columns > 1:
        height = panels * (350 if is_plane else 270)
    scenes = sum(key.startswith("scene") for key in layout)
    if scenes > 1:
        height = scenes * 330
    if "coloraxis" in layout:
        height += 55
    if layout.get("showlegend"):  # below, a line or more for each name
        height += sum(map(_height_in_legend, chart["data"]))
    return height


def _height_in_legend(series: dict) -> int:
    """Return how high the name of a series is in the legend on a phone, in pixels."""
    if not series.get("showlegend", True):
        return 0
    further_lines = textwrap.wrap(series.get("name") or "", NAME_LETTERS)[1:]
    return 24 + 18 * len(further_lines)


def _data(figure: dict) -> str:
    """Return a figure as an element that holds data for a script."""
    # "</" would end the script element; in JSON "<\/" is the same string.
    data = json.dumps(figure, separators=(",", ":")).replace("</", "<\\/")
    # The class keeps the search from marking words in the data.
    return f'<script type="application/json" class="nohighlight">{data}</script>'


def picture(output, kind: str, name: str, alt: str, folder: Path) -> str:
    """Store an image beside the pages, and return the element that shows it.

    Its panels are cut apart, so that a phone shows them below each other.
    """
    text, stored = output.data[kind], output.metadata.get(kind, {})
    content = text.encode() if kind == "image/svg+xml" else base64.b64decode(text)
    if kind != "image/png":
        return _stored(content, IMAGES[kind], name, alt, folder)
    image = Image.open(io.BytesIO(content))
    # Known beforehand, so that the text below does not jump when the picture arrives.
    shown = stored.get("width", image.width)
    scale, ends, parts = image.width / shown, [0, *stored.get("cuts", []), shown], []
    for left, right in pairwise(ends):
        part = image.crop((round(scale * left), 0, round(scale * right), image.height))
        # The same dots in well under half the bytes.
        smaller = io.BytesIO()
        part.save(smaller, "WEBP", lossless=True, method=1, quality=50)
        size = f' width="{right - left:.0f}" height="{image.height / scale:.0f}"'
        one = (name, alt) if len(ends) == 2 else ("panel", "")
        parts.append(_stored(smaller.getvalue(), "webp", *one, folder, size))
    if len(parts) == 1:
        return parts[0]
    shape = image.width / image.height
    attributes = f'role="img" aria-label="{html.escape(alt)}" style="--shape:{shape:.3f}"'
    return f'<div class="{name} panels" {attributes}>{"".join(parts)}</div>'


def _path_of(content: bytes, ending: str, folder: Path) -> Path:
    """Store the bytes of an image, named by its content; return its path below the pages."""
    path = Path("_static", "pictures", f"{hashlib.sha256(content).hexdigest()[:16]}.{ending}")
    (folder / path).parent.mkdir(parents=True, exist_ok=True)
    (folder / path).write_bytes(content)
    return path


def _stored(content: bytes, ending: str, name: str, alt: str, folder: Path, size: str = "") -> str:
    """Store the bytes of an image, named by its content; return its element."""
    path = _path_of(content, ending, folder)
    # "dark-light" tells the theme to keep the colours in the dark theme.
    return f'<img class="{name} dark-light" src="{path.as_posix()}" alt="{html.escape(alt)}"{size}>'
