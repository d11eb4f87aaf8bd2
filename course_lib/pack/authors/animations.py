"""Write the animations stored in notebooks as GIF, and also as MP4 if ffmpeg is installed.

They are photographed in a headless browser, as the pages draw them.
"""

import argparse
import io
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

import nbformat
import numpy as np
from PIL import Image
from tqdm import tqdm

from course_lib.figures.stills import TOY
from course_lib.pack import in_words
from course_lib.pack.files import write_atomically
from course_lib.pack.notebooks import figure_outputs
from course_lib.pack.photograph import film_pictures

FOLDER = Path("build/animations")
RATE = 20  # pictures a second


def main(arguments: Sequence[str] | None = None) -> int:
    """Write the animations of some notebooks; return an exit code."""
    parser = argparse.ArgumentParser(
        prog="python -m course_lib.pack.authors.animations",
        description="Write the films that notebooks hold as GIF, and as MP4 if ffmpeg is "
        f"installed, to {FOLDER}/. A browser photographs them: Chrome or Chromium.",
        epilog="example: make animations NOTEBOOKS=notebooks/02_rigid_motion.ipynb",
    )
    parser.add_argument(
        "notebooks", metavar="NOTEBOOK", nargs="*", help="a notebook with its outputs"
    )
    notebooks = parser.parse_args(arguments).notebooks
    try:
        movies = [
            movie
            for path in notebooks
            for movie in stored_movies(nbformat.read(path, as_version=4))
        ]
    except (OSError, ValueError, AttributeError, nbformat.ValidationError) as error:
        reason = in_words(error).splitlines()[0]
        print(f"A notebook cannot be read. {reason:.200}", file=sys.stderr)
        return 1
    if not movies:
        print(
            "No animation is stored in these notebooks. Run them and save them first.",
            file=sys.stderr,
        )
        return 1
    FOLDER.mkdir(parents=True, exist_ok=True)
    for movie in movies:
        try:
            print(*write(movie, FOLDER / movie["movie"]), sep="\n")
        except TimeoutError as error:
            print(f"The films were not written, because {error}.", file=sys.stderr)
            return 1
    if shutil.which("ffmpeg") is None:
        print("There is no MP4, because ffmpeg was not found: install it to have both.")
    return 0


def stored_movies(notebook: nbformat.NotebookNode) -> list[dict]:
    """Return the animations among a notebook's stored toys, as JSON."""
    outputs = [output.data for output in figure_outputs(notebook)]
    toys = [data[TOY]["layout"]["meta"]["course"] for data in outputs if TOY in data]
    return [toy for toy in toys if "movie" in toy]


def write(movie: dict, path: Path) -> list[Path]:
    """Write one animation as GIF and, with ffmpeg, as MP4; return the files' paths.

    Each file is written beside its place and moved there when it is whole. Whoever ends this in
    the middle keeps the file of the time before.

    `movie` is the data of a stored toy, and `path` the files' path without a suffix.
    """
    times = np.arange(0, movie["times"][-1] + 1e-9, 1 / RATE)
    with_progress = tqdm(
        film_pictures(movie, times),
        total=len(times),
        desc=path.name,
        unit="picture",
        leave=False,
        disable=None,
    )
    pictures = list(with_progress)
    gif = path.with_suffix(".gif")
    mp4 = path.with_suffix(".mp4")
    # This method keeps the rarer colours.
    palette = pictures[0].quantize(method=Image.Quantize.MAXCOVERAGE)
    small = [picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in pictures]
    content = io.BytesIO()
    timing = {"duration": 1000 // RATE, "loop": 0}
    small[0].save(content, "GIF", save_all=True, append_images=small[1:], **timing)
    write_atomically(gif, content.getvalue(), mode=0o644)
    if shutil.which("ffmpeg") is None:
        return [gif]
    raw = "-f rawvideo -pixel_format rgb24 -video_size {}x{}".format(*pictures[0].size)
    command = f"ffmpeg -y -loglevel error {raw} -framerate {RATE} -i - -pix_fmt yuv420p".split()
    raw_pictures = b"".join(picture.tobytes() for picture in pictures)
    with tempfile.TemporaryDirectory() as aside:
        whole = Path(aside, mp4.name)
        subprocess.run([*command, whole], input=raw_pictures, check=True)
        write_atomically(mp4, whole.read_bytes(), mode=0o644)
    return [gif, mp4]


if __name__ == "__main__":
    sys.exit(main())
