"""Write the pictures of README.md from the notebooks: their covers, and a small film.

A cover is the stored picture that the home page shows of a notebook, as a small file. The film is
what `make animations` writes, in fewer and smaller pictures. For example:

    python -m course_lib.pack.authors.pictures

The same notebooks give the same files, so a second run changes nothing.
"""

from __future__ import annotations

import argparse
import base64
import io
import sys
from collections.abc import Sequence
from pathlib import Path

import nbformat
from PIL import Image, ImageSequence

from course_lib.pack.authors.animations import FOLDER as FILMS
from course_lib.pack.cover import cover_of
from course_lib.pack.files import write_atomically

FOLDER = Path(".github/pictures")
COVER_SIZE = (264, 176)  # three of them fit beside each other in a repository's web view
COVER_COLOURS = 64
FILM = "pick.gif"
FILM_WIDTH = 400
FILM_COLOURS = 64
FILM_STEP = 2  # of the pictures of the film each second one is kept
MAX_FILM_BYTES = 500_000  # what a reader waits for on a slow line is less than two seconds


def main(arguments: Sequence[str] | None = None) -> int:
    """Write the pictures of the notebooks in ``notebooks/``; return an exit code."""
    parser = argparse.ArgumentParser(
        prog="python -m course_lib.pack.authors.pictures",
        description=f"Write the covers of the notebooks and, if {FILMS / FILM} is there, a small "
        f"copy of this film to {FOLDER}/, from where README.md shows them.",
        epilog="example: python -m course_lib.pack.authors.pictures",
    )
    parser.parse_args(arguments)
    pictures = {f"{path.stem}.png": cover(path) for path in _notebooks()}
    if (FILMS / FILM).is_file():
        pictures[FILM] = small_film((FILMS / FILM).read_bytes())
    for name, content in pictures.items():
        path = FOLDER / name
        if content and not (path.is_file() and path.read_bytes() == content):
            write_atomically(path, content, mode=0o644)
            print(f"{path} written")
    return 0


def _notebooks() -> list[Path]:
    return sorted(Path("notebooks").glob("[0-9][0-9]_*.ipynb"))


def cover(notebook: Path) -> bytes:
    """Return the cover of a notebook as a PNG of `COVER_SIZE`, or b"" if it has no picture.

    It is the picture of the cell that is tagged for it, or else the notebook's first picture.
    """
    output, kind = cover_of(nbformat.read(notebook, as_version=4), ["image/png"])
    if output is None:
        return b""
    picture = Image.open(io.BytesIO(base64.b64decode(output.data[kind]))).convert("RGBA")
    picture.thumbnail(COVER_SIZE, Image.Resampling.LANCZOS)
    sheet = Image.new("RGBA", COVER_SIZE, "white")
    left = (COVER_SIZE[0] - picture.width) // 2
    top = (COVER_SIZE[1] - picture.height) // 2
    sheet.alpha_composite(picture, (left, top))
    few_colours = sheet.convert("RGB").quantize(COVER_COLOURS, dither=Image.Dither.NONE)
    content = io.BytesIO()
    few_colours.save(content, "PNG", optimize=True)
    return content.getvalue()


def small_film(gif: bytes) -> bytes:
    """Return a GIF with every second picture of `gif`, at `FILM_WIDTH` and with fewer colours."""
    film = Image.open(io.BytesIO(gif))
    durations = [picture.info["duration"] for picture in ImageSequence.Iterator(film)]
    pictures = [picture.convert("RGB") for picture in ImageSequence.Iterator(film)]
    size = (FILM_WIDTH, round(film.height * FILM_WIDTH / film.width))
    kept = [picture.resize(size, Image.Resampling.LANCZOS) for picture in pictures[::FILM_STEP]]
    # One palette for all pictures, so that what stands still is the same in each and takes no room.
    palette = kept[len(kept) // 2].quantize(FILM_COLOURS)
    few_colours = [p.quantize(palette=palette, dither=Image.Dither.NONE) for p in kept]
    content = io.BytesIO()
    few_colours[0].save(
        content,
        "GIF",
        save_all=True,
        append_images=few_colours[1:],
        duration=FILM_STEP * durations[0],
        loop=0,
        optimize=True,
    )
    return content.getvalue()


if __name__ == "__main__":
    sys.exit(main())
