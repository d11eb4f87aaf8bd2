"""Write the animations of notebooks as GIF, and also as MP4 if ffmpeg is installed.

    python -m course_lib.pack.animations notebooks/*.ipynb

The animations come from a notebook's stored outputs: run and save it first.
"""

import argparse
import sys
from pathlib import Path

import nbformat
from matplotlib.animation import FFMpegWriter, PillowWriter
from matplotlib.figure import Figure
from tqdm import tqdm

from course_lib.figures.display import PLOTLY
from course_lib.pack import film_frames

FOLDER = Path("build/animations")
_DASHES = {"dash": "--", "dot": ":", "solid": "-"}


def main(arguments=None):
    """Write the animations of the notebooks named on the command line; return an exit code."""
    parser = argparse.ArgumentParser(prog="python -m course_lib.pack.animations")
    parser.add_argument("notebooks", nargs="+", type=Path, metavar="NOTEBOOK")
    movies = []
    for path in parser.parse_args(arguments).notebooks:
        try:
            movies += stored_movies(nbformat.read(path, as_version=4))
        except (
            OSError,
            ValueError,
            AttributeError,
            nbformat.ValidationError,
        ) as error:  # AttributeError: JSON that is not a notebook
            print(f"{path} cannot be read: {str(error).splitlines()[0]:.100}", file=sys.stderr)
            return 1
    if not movies:
        print("No animation is stored in these notebooks. Run them and save them first.", file=sys.stderr)
        return 1
    FOLDER.mkdir(parents=True, exist_ok=True)
    writers = {".gif": PillowWriter} | ({".mp4": FFMpegWriter} if FFMpegWriter.isAvailable() else {})
    for movie in movies:
        drawn = _drawn(movie)
        for ending, writer in writers.items():
            path = FOLDER / f"{movie['layout']['meta']['movie']}{ending}"
            write(movie, path, writer, drawn)
            print(path)
    if len(writers) == 1:
        print("No MP4: ffmpeg was not found.")
    return 0


def stored_movies(notebook):
    """Return the animations among a notebook's stored figures, as plotly's JSON.

    Parameters
    ----------
    notebook : NotebookNode

    Returns
    -------
    list of dict
        Those that figures.moving.movie or solids.film made.
    """
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    figures = [output.data[PLOTLY] for output in outputs if PLOTLY in output.get("data", {})]
    movies = [figure for figure in figures if "movie" in (figure["layout"].get("meta") or {})]
    return [m for m in movies if _is_film(m) or all(trace["type"] == "scatter" for trace in m["data"])]


def write(movie, path, writer_class, drawn=None):
    """Write one animation to a file, frame by frame, with a progress bar.

    Parameters
    ----------
    movie : dict
        A stored figure.
    path : Path
    writer_class : type
        A writer of matplotlib.animation.
    drawn : tuple, optional
        The figure, the function that shows frame i in it, and the number of frames; drawn from `movie` if None.
    """
    fig, show, frames = drawn or _drawn(movie)
    writer = writer_class(fps=(frames - 1) / movie["layout"]["meta"]["seconds"])
    with writer.saving(fig, str(path), dpi=100):
        for i in tqdm(range(frames), desc=path.name, unit="frame", leave=False, disable=None):
            show(i)
            writer.grab_frame(facecolor="white")


def _drawn(movie):
    return film_frames.draw(movie) if _is_film(movie) else _plane_frames(movie)


def _is_film(movie):
    return movie["layout"]["meta"].get("course", {}).get("kind") == "film"


def _plane_frames(movie):
    """Return (figure, function that shows frame i in it, number of frames)."""
    fig, lines = draw(movie)

    def show(i):
        frame = movie["frames"][i]
        for number, where in zip(frame["traces"], frame["data"], strict=True):
            lines[number].set_data(where["x"], where["y"])

    return fig, show, len(movie["frames"])


def draw(movie):
    """Return a matplotlib figure of the movie's first frame, and the line of each trace."""
    fig = Figure(figsize=(5.6, 5.6), layout="constrained")
    ax = fig.subplots()
    ax.set_aspect("equal")
    ax.grid(color="#dddddd", linewidth=0.6)
    ax.set_axisbelow(True)
    for axis in "xy":
        settings = movie["layout"][f"{axis}axis"]
        ax.set(**{f"{axis}lim": settings["range"], f"{axis}label": settings["title"]["text"]})
    lines = [ax.plot(trace["x"], trace["y"], **_look(trace))[0] for trace in movie["data"]]
    fig.draw_without_rendering()  # lays out the axes once, so that they do not move between frames
    fig.set_layout_engine("none")
    return fig, lines


def _look(trace):
    look = {"linestyle": "none"}
    if "line" in trace:
        line = trace["line"]
        look = {"color": line["color"], "linewidth": line["width"], "linestyle": _DASHES[line["dash"]]}
    if "marker" in trace:
        look |= {"color": trace["marker"]["color"], "marker": "o", "markersize": 0.8 * trace["marker"]["size"]}
    return look


if __name__ == "__main__":
    sys.exit(main())
