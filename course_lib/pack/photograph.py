"""Pictures and PDFs that a headless browser makes of pages.

The pictures show what scripts draw, for places that run no script.
"""

import io
import json
import os
import shutil
import subprocess
import tempfile
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from PIL import Image

from course_lib.figures.toys.toy import script

INSTALL_BROWSER = (
    "install one (on Debian: sudo apt install chromium), or name it with "
    "BROWSER_PATH=/path/to/chromium"
)
WIDTH = 720  # pixels
MAX_HEIGHT = 1600  # pixels, of the window in which a toy is drawn
MAX_SECONDS = 600  # for a picture, on a busy machine
FILM_WIDTH = 560  # pixels
FILMS_ACROSS = 4  # pictures of a film beside each other and below each other in one photograph
NAME_HEIGHT = 24  # pixels, of a map's name, with a margin
_TOY = """<style>body{{background:#fff}}.course-toy{{padding:0!important}}
.controls{{display:none!important}}</style><div id="toy"></div>{scripts}<script>
const meta = {{ ...{meta}, photographed: true }};
window.course.kinds[meta.kind](document.getElementById("toy"), meta, null);</script>"""
_SHEET = """<style>
body{{background:#fff;display:grid;grid-template-columns:repeat({across},{width}px)}}
.course-toy{{padding:0!important}}.controls{{display:none!important}}</style><body>{scripts}<script>
for (const at of {times}) {{
  const meta = {{ ...{meta}, at }};
  const host = document.body.appendChild(document.createElement("div"));
  window.course.kinds[meta.kind](host, meta, null);
}}</script>"""
_OPTIONS = ["--headless", "--no-sandbox", "--hide-scrollbars", "--enable-unsafe-swiftshader"]
_OPTIONS += ["--force-prefers-reduced-motion", "--default-background-color=00000000"]


def photograph(meta: dict) -> bytes:
    """Return a PNG of what a toy shows at its start, without its controls."""
    body = _TOY.format(scripts=inline(meta["scripts"]), meta=_as_script_data(meta))
    image = screenshot(body, WIDTH, MAX_HEIGHT).convert("RGB")
    # The last row that is not white.
    bottom = image.convert("L").point(lambda dot: 255 * (dot < 255)).getbbox()[3]
    file = io.BytesIO()
    image.crop((0, 0, WIDTH, bottom)).save(file, "PNG")
    return file.getvalue()


def _as_script_data(meta: dict) -> str:
    """Return data as JSON that may stand in a script element."""
    # "</" would end the element; in JSON "<\\/" is the same string.
    return json.dumps(meta).replace("</", "<\\/")


def film_pictures(meta: dict, times: Sequence[float]) -> Iterator[Image.Image]:
    """Yield the pictures of a film at times in seconds.

    `meta` is the data of a toy. Sixteen pictures are photographed at once.
    """
    width, across = FILM_WIDTH, FILMS_ACROSS
    height = _height_of_film(meta, width)
    for first in range(0, len(times), across**2):
        times_of_sheet = [round(float(t), 4) for t in times[first : first + across**2]]
        body = _SHEET.format(
            scripts=inline(meta["scripts"]),
            meta=_as_script_data(meta),
            times=times_of_sheet,
            across=across,
            width=width,
        )
        sheet = screenshot(body, across * width, across * height).convert("RGB")
        for k in range(len(times_of_sheet)):
            x, y = width * (k % across), height * (k // across)
            yield sheet.crop((x, y, x + width, y + height))


def _height_of_film(meta: dict, width: int) -> int:
    """Return the height of a film in pixels: of maps below their names, or of one picture."""
    proportion = meta.get("proportion", 0.75)
    names = meta.get("names")
    if not names:
        return round(width * proportion)
    return round(width / len(names) * proportion) + NAME_HEIGHT


def inline(scripts: Iterable[str]) -> str:
    """Return the HTML of scripts of course_lib/figures/scripts, named without ".js"."""
    return "".join(f"<script>{script(name)}</script>" for name in scripts)


def screenshot(body: str, width: int, height: int) -> Image.Image:
    """Return what a page shows in a window of so many pixels, on a transparent ground.

    Raises TimeoutError if there is no browser, or it takes no picture.
    """
    with tempfile.TemporaryDirectory() as folder:
        page, shot = Path(folder, "page.html"), Path(folder, "page.png")
        page.write_text(
            f'<!doctype html><meta charset="utf-8"><style>body{{margin:0}}</style>{body}',
            encoding="utf-8",
        )
        headless(page, f"--window-size={width},{height}", f"--screenshot={shot}")
        try:
            return Image.open(io.BytesIO(shot.read_bytes())).convert("RGBA")
        except OSError as error:
            raise TimeoutError(f"the browser took no picture: {error}") from error


def headless(page: Path, *options: str) -> None:
    """Open a page in a browser without a window, which then does what the options say.

    Raises TimeoutError if there is no browser, or it fails.
    """
    browser = find_browser()
    with tempfile.TemporaryDirectory() as profile:
        command = [
            browser,
            *_OPTIONS,
            f"--user-data-dir={profile}",
            *options,
            page.resolve().as_uri(),
        ]
        try:
            subprocess.run(command, check=True, capture_output=True, timeout=MAX_SECONDS)
        except (subprocess.SubprocessError, OSError) as error:
            raise TimeoutError(f"the browser {browser} failed: {error}") from error


def find_browser() -> str:
    """Return the path of the browser; raises TimeoutError if there is none."""
    from choreographer.browsers.chromium import Chromium

    named = os.environ.get("BROWSER_PATH")
    browser = shutil.which(named) if named else Chromium.find_browser(skip_local=False)
    if named and not browser:
        raise TimeoutError(f"BROWSER_PATH={named} is not a program: {INSTALL_BROWSER}")
    if not browser:
        raise TimeoutError(f"no Chrome or Chromium was found: {INSTALL_BROWSER}")
    return str(browser)
