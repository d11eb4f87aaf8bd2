"""Write the animations stored in notebooks as GIF, and also as MP4 if ffmpeg is installed.

Films in space are photographed in a headless browser, those in the plane are drawn without.

Between the stored times bodies move along screws, and points of the plane along lines, as on the pages.
"""

import base64
import shutil
import subprocess
import sys
from pathlib import Path

import nbformat
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image
from tqdm import tqdm

from course_lib.pack.notebooks import figure_in
from course_lib.pack.photograph import film_pictures

FOLDER = Path("build/animations")
RATE = 20  # pictures a second
_DASHES = {"dash": "--", "dot": ":", "solid": "-"}


def main(notebooks):
    """Write the animations of some notebooks, by their paths; return an exit code."""
    try:
        movies = [movie for path in notebooks for movie in stored_movies(nbformat.read(path, as_version=4))]
    except (OSError, ValueError, AttributeError, nbformat.ValidationError) as error:
        print(f"A notebook cannot be read: {str(error).splitlines()[0]:.200}", file=sys.stderr)
        return 1
    if not movies:
        print("No animation is stored in these notebooks. Run them and save them first.", file=sys.stderr)
        return 1
    FOLDER.mkdir(parents=True, exist_ok=True)
    for movie in movies:
        try:
            print(*write(movie, FOLDER / _about(movie)["movie"]), sep="\n")
        except TimeoutError as error:
            print(f"A film in space needs a browser: {error}", file=sys.stderr)
            return 1
    if shutil.which("ffmpeg") is None:
        print("No MP4: ffmpeg was not found.")
    return 0


def stored_movies(notebook):
    """Return the animations among a notebook's stored figures, as plotly's JSON."""
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    figures = [figure for output in outputs if (figure := figure_in(output.get("data", {})))]
    return [figure for figure in figures if "movie" in _about(figure)]


def _about(figure):
    meta = figure["layout"].get("meta") or {}
    return meta.get("course", meta)


def write(movie, path):
    """Write one animation, a stored figure, as GIF and (with ffmpeg) as MP4; return the paths of these files."""
    course, draws = _about(movie), film_pictures if movie["layout"]["meta"].get("course") else _in_the_plane
    times = np.arange(0, course.get("seconds", course.get("times", [0])[-1]) + 1e-9, 1 / RATE)
    every = tqdm(draws(movie, times), total=len(times), desc=path.name, unit="picture", leave=False, disable=None)
    pictures = list(every)
    gif, mp4 = path.with_suffix(".gif"), path.with_suffix(".mp4")
    palette = pictures[0].quantize(method=Image.Quantize.MAXCOVERAGE)  # which keeps the rarer colours
    small = [picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in pictures]
    small[0].save(gif, save_all=True, append_images=small[1:], duration=1000 // RATE, loop=0)
    if shutil.which("ffmpeg") is None:
        return [gif]
    raw = "-f rawvideo -pixel_format rgb24 -video_size {}x{}".format(*pictures[0].size)
    command = f"ffmpeg -y -loglevel error {raw} -framerate {RATE} -i - -pix_fmt yuv420p".split()
    subprocess.run([*command, mp4], input=b"".join(picture.tobytes() for picture in pictures), check=True)
    return [gif, mp4]


def _between(times, t):
    """Return the number of the last of the times before t, and the share of the way to the next one."""
    i = np.clip(np.searchsorted(times, t, "right") - 1, 0, len(times) - 2)
    return i, (t - times[i]) / (times[i + 1] - times[i])


def points(trace, axes="xyz"):
    """Return arrays of a stored trace, which may be packed, as columns (n, len(axes))."""

    def numbers(array):
        packed = isinstance(array, dict)
        return np.frombuffer(base64.b64decode(array["bdata"]), array["dtype"]) if packed else np.array(array, float)

    return np.stack([numbers(trace[name]) for name in axes], -1).astype(float)


# ---- in the plane ----


def _in_the_plane(movie, shown):
    """Yield the pictures of a movie in the plane at times in seconds."""
    figure = Figure(figsize=(5.6, 5.6), dpi=200, layout="constrained")
    axes = figure.subplots()
    axes.set_aspect("equal")
    axes.grid(color="#dddddd", linewidth=0.6)
    axes.set_axisbelow(True)
    for axis in "xy":
        settings = movie["layout"][f"{axis}axis"]
        axes.set(**{f"{axis}lim": settings["range"], f"{axis}label": settings["title"]["text"]})
    lines = [axes.plot(*points(trace, "xy").T, **_look(trace))[0] for trace in movie["data"]]
    figure.draw_without_rendering()  # lays out the axes once, so that they do not move between pictures
    figure.set_layout_engine("none")
    frames = [[points(at, "xy").T for at in frame["data"]] for frame in movie["frames"]]
    times, canvas = np.linspace(0, movie["layout"]["meta"]["seconds"], len(frames)), FigureCanvasAgg(figure)
    for t in shown:
        i, share = _between(times, t)
        for number, here, there in zip(movie["frames"][0]["traces"], frames[i], frames[i + 1], strict=True):
            lines[number].set_data(here + share * (there - here))
        canvas.draw()  # twice as large, and averaged
        yield Image.fromarray(np.asarray(canvas.buffer_rgba())[..., :3]).reduce(2)


def _look(trace):
    look = {"linestyle": "none"}
    if line := trace.get("line"):
        look = {"color": line["color"], "linewidth": line["width"], "linestyle": _DASHES[line["dash"]]}
    if marker := trace.get("marker"):
        look |= {"color": marker["color"], "marker": "o", "markersize": 0.8 * marker["size"]}
    return look


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
