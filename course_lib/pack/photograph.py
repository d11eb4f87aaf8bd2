"""What a headless browser makes of pages: pictures of what scripts draw, for places that run no script, and PDFs."""

import io
import json
import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from PIL import Image

from course_lib.figures.toys.toy import script

WIDTH, HIGHEST, PATIENCE = 720, 1600, 600  # pixels, pixels, seconds
_TOY = """<style>body{{background:#fff}}.course-toy{{padding:0!important}}
.controls{{display:none!important}}</style><div id="toy"></div>{scripts}<script>
const meta = {meta};
window.course.kinds[meta.kind](document.getElementById("toy"), meta, null);</script>"""
_SHEET = """<style>body{{background:#fff;display:grid;grid-template-columns:repeat({across},{width}px)}}
.course-toy{{padding:0!important}}.controls{{display:none!important}}</style><body>{scripts}<script>
for (const at of {times}) {{
  const meta = {{ ...{meta}, at }};
  window.course.kinds[meta.kind](document.body.appendChild(document.createElement("div")), meta, null);
}}</script>"""
_OPTIONS = ["--headless", "--no-sandbox", "--hide-scrollbars", "--enable-unsafe-swiftshader"]
_OPTIONS += ["--force-prefers-reduced-motion", "--default-background-color=00000000"]


def photograph(meta: dict) -> bytes:
    """Return a PNG of what a toy shows at its start, without its controls."""
    data = json.dumps(meta).replace("</", "<\\/")
    image = screenshot(
        _TOY.format(scripts=inline(meta["scripts"]), meta=data), WIDTH, HIGHEST
    ).convert("RGB")
    bottom = image.convert("L").point(lambda dot: 255 * (dot < 255)).getbbox()[3]
    image.crop((0, 0, WIDTH, bottom)).save(file := io.BytesIO(), "PNG")
    return file.getvalue()


def film_pictures(course: dict, times):
    """Yield the pictures of a film, a toy's data, at times in seconds: sixteen are photographed at once."""
    width, across = 560, 4
    height = round(width * course.get("proportion", 0.75))
    for first in range(0, len(times), across**2):
        some = [round(float(t), 4) for t in times[first : first + across**2]]
        data = json.dumps(course).replace("</", "<\\/")
        body = _SHEET.format(
            scripts=inline(course["scripts"]), meta=data, times=some, across=across, width=width
        )
        sheet = screenshot(body, across * width, across * height).convert("RGB")
        for k in range(len(some)):
            x, y = width * (k % across), height * (k // across)
            yield sheet.crop((x, y, x + width, y + height))


def inline(scripts) -> str:
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
            subprocess.run(command, check=True, capture_output=True, timeout=PATIENCE)
        except (subprocess.SubprocessError, OSError) as error:
            raise TimeoutError(f"the browser {browser} failed: {error}") from error


def find_browser() -> str:
    """Return the path of the browser; raises TimeoutError if there is none."""
    from choreographer.browsers.chromium import Chromium

    named = os.environ.get("BROWSER_PATH")
    browser = shutil.which(named) if named else Chromium.find_browser(skip_local=False)
    if not browser:
        raise TimeoutError("no Chrome or Chromium was found; BROWSER_PATH may name one")
    return str(browser)
