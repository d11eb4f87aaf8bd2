"""Write the animations stored in notebooks as GIF, and also as MP4 if ffmpeg is installed; no browser is needed.

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
from matplotlib.collections import TriMesh
from matplotlib.figure import Figure
from matplotlib.tri import Triangulation
from PIL import Image, ImageColor
from tqdm import tqdm

from course_lib import rigid
from course_lib.figures.display import PLOTLY
from course_lib.figures.solids.scene import projected
from course_lib.rotations import exp_so3

FOLDER = Path("build/animations")
RATE = 20  # pictures a second
_DASHES = {"dash": "--", "dot": ":", "solid": "-"}
_LAMP = np.array([2000, -3500, 6000]) / 7230  # the direction to it


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
        print(*write(movie, FOLDER / movie["layout"]["meta"]["movie"]), sep="\n")
    if shutil.which("ffmpeg") is None:
        print("No MP4: ffmpeg was not found.")
    return 0


def stored_movies(notebook):
    """Return the animations among a notebook's stored figures, as plotly's JSON."""
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    figures = [output.data[PLOTLY] for output in outputs if PLOTLY in output.get("data", {})]
    movies = [figure for figure in figures if "movie" in (figure["layout"].get("meta") or {})]
    return [m for m in movies if _is_film(m) or all(trace["type"] == "scatter" for trace in m["data"])]


def write(movie, path):
    """Write one animation, a stored figure, as GIF and (with ffmpeg) as MP4; return the paths of these files."""
    figure, show = (_in_space if _is_film(movie) else _in_the_plane)(movie)
    canvas, pictures = FigureCanvasAgg(figure), []
    times = np.arange(0, movie["layout"]["meta"]["seconds"] + 1e-9, 1 / RATE)
    for t in tqdm(times, desc=path.name, unit="picture", leave=False, disable=None):
        show(t)
        canvas.draw()  # twice as large, and averaged
        pictures.append(Image.fromarray(np.asarray(canvas.buffer_rgba())[..., :3]).reduce(2))
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


def _is_film(movie):
    return movie["layout"]["meta"].get("course", {}).get("kind") == "film"


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


def _in_the_plane(movie):
    """Return a matplotlib figure of a movie in the plane, and the function that shows it at a time in seconds."""
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
    times = np.linspace(0, movie["layout"]["meta"]["seconds"], len(frames))

    def show(t):
        i, share = _between(times, t)
        for number, here, there in zip(movie["frames"][0]["traces"], frames[i], frames[i + 1], strict=True):
            lines[number].set_data(here + share * (there - here))

    return figure, show


def _look(trace):
    look = {"linestyle": "none"}
    if line := trace.get("line"):
        look = {"color": line["color"], "linewidth": line["width"], "linestyle": _DASHES[line["dash"]]}
    if marker := trace.get("marker"):
        look |= {"color": marker["color"], "marker": "o", "markersize": 0.8 * marker["size"]}
    return look


# ---- in space ----


def _in_space(film):
    """Return a matplotlib figure of a stored film, and the function that shows it at a time in seconds."""
    course, scene = film["layout"]["meta"]["course"], film["layout"]["scene"]
    figure = Figure(figsize=(5.6, 5.6), dpi=200)
    axes = figure.add_axes((0, 0, 1, 1), xlim=(-1, 1), ylim=(-1, 1))
    axes.axis("off")
    for trace in film["data"]:
        if trace["type"] == "scatter3d" and trace["mode"] == "lines":
            look = trace["line"]
            width, style = 0.6 * look["width"], _DASHES[look.get("dash", "solid")]
            axes.plot(*projected(points(trace), scene).T, color=look["color"], linewidth=width, linestyle=style)
    moving, times = film["data"][course["trace"]], np.array(course["times"])
    still = [trace for trace in film["data"] if trace["type"] == "mesh3d" and trace is not moving]
    poses = rigid.transform(exp_so3(course["rotations"]), course["positions"])
    steps = rigid.log_se3(rigid.inverse(poses[:-1]) @ poses[1:])
    bodies = np.repeat(np.arange(len(course["counts"])), course["counts"])
    local, draw = placed(rigid.inverse(poses[0])[bodies], points(moving)), _painter(axes, [*still, moving], scene)

    def show(t):
        i, share = _between(times, t)
        at = poses[i] @ rigid.exp_se3(share * steps[i])
        draw(np.concatenate([*map(points, still), placed(at[bodies], local)]))

    return figure, show


def placed(poses, local):
    """Return points (n, 3) of a body each, moved by the pose of their body (n, 4, 4)."""
    return (poses[:, :3, :3] @ local[:, :, None])[..., 0] + poses[:, :3, 3]


def _painter(axes, meshes, scene):
    """Return a function of the vertices (n, 3) of all meshes that draws their faces from far to near, lit by a lamp.

    The mesh without light is the floor: it hides what is below it, and the lines are drawn on it.
    """
    counts = [len(points(mesh)) for mesh in meshes]
    starts = np.cumsum(counts) - counts
    faces = np.concatenate([points(mesh, "ijk") + start for mesh, start in zip(meshes, starts, strict=True)]).astype(
        int
    )
    colours = np.concatenate([_colours(mesh) for mesh in meshes])
    is_floor = np.repeat([mesh.get("lighting", {}).get("diffuse", 1) == 0 for mesh in meshes], counts)
    ranges = np.array([scene[f"{c}axis"]["range"] for c in "xyz"])
    ratio, eye = (np.array([of[c] for c in "xyz"]) for of in (scene["aspectratio"], scene["camera"]["eye"]))
    eye = ranges.mean(1) + eye / ratio * np.ptp(ranges, axis=1)

    def draw(vertices):
        corners = vertices[faces]
        across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals = np.zeros_like(vertices)
        np.add.at(normals, faces, across[:, None])
        normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-12)[:, None]
        light = np.where(is_floor, 1, 0.5 + 0.52 * np.maximum(normals @ _LAMP, 0) + 0.06 * normals[:, 2])
        shaded = np.clip(colours * light[:, None], 0, 1)
        towards, ground = eye - corners.mean(1), vertices[is_floor, 2].min(initial=np.inf)
        is_above = (corners[..., 2] >= ground).all(1) & ~is_floor[faces[:, 0]] | ~is_floor.any()
        order = np.lexsort([-np.linalg.norm(towards, axis=1), is_floor[faces[:, 0]]])
        order = order[(across * towards).sum(1)[order] > 0]  # those that face the eye
        for mesh in list(axes.collections):
            mesh.remove()
        for part, zorder in ((order[~is_above[order]], 1), (order[is_above[order]], 3)):  # the lines are between
            if len(part):
                triangles = Triangulation(*projected(vertices, scene).T, faces[part])
                axes.add_collection(TriMesh(triangles, facecolors=shaded, zorder=zorder), autolim=False)

    return draw


def _colours(mesh):
    """Return the colour (n, 3) of each vertex, from the trace's intensity and colour scale, 0 to 1."""
    palette = np.array([ImageColor.getrgb(colour) for _, colour in mesh["colorscale"]]) / 255
    share = (points(mesh, ["intensity"])[:, 0] - mesh["cmin"]) / (mesh["cmax"] - mesh["cmin"])
    return np.stack([np.interp(share, [stop for stop, _ in mesh["colorscale"]], channel) for channel in palette.T], -1)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
