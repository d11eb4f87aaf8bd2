"""Draw the frames of a stored film in space without a browser: bodies shaded in one light, with a depth buffer.

A browser takes about a second for each picture; this takes some hundredths.
"""

import base64

import numpy as np
from matplotlib.figure import Figure
from PIL import Image, ImageColor, ImageDraw

from course_lib import rigid
from course_lib.figures.solids.scene import projected
from course_lib.rotations import exp_so3

SIZE = 560  # pixels, of a square picture
_FINER = 2  # drawn this many times larger, and averaged
_MOST = 48  # frames of a film
_BOXES = (
    4,
    6,
    8,
    11,
    15,
    20,
    27,
    36,
    50,
    70,
    100,
    150,
    250,
    500,
    _FINER * SIZE,
)  # pixels: triangles are drawn with others of about their size


def draw(film):
    """Return a matplotlib figure, a function that shows the frame i in it, and how many frames there are.

    film: a stored plotly figure, as figures.solids.film makes it.
    """
    course = film["layout"]["meta"]["course"]
    trace = film["data"][course["trace"]]
    poses = rigid.transform(exp_so3(course["rotations"]), course["positions"])[_evenly(course["times"])]
    bodies = np.repeat(np.arange(len(course["counts"])), course["counts"])
    local = _placed(rigid.inverse(poses[0]), bodies, vertices(trace))
    back = _background(film)
    faces, colours = _faces(trace), _colours(trace)
    fig = Figure(figsize=(SIZE / 100, SIZE / 100), dpi=100)
    ax = fig.add_axes((0, 0, 1, 1))
    ax.axis("off")
    image = ax.imshow(np.full((SIZE, SIZE, 3), 255, np.uint8))
    done = {}  # a film is written in two formats

    def show(i):
        if i not in done:
            done[i] = picture(i)
        image.set_data(done[i])

    def picture(i):
        at = _placed(poses[i], bodies, local)
        canvas = (back[0].copy(), back[1].copy())
        _fill(canvas, _seen(at, film), faces, _shaded(at, faces, colours))
        pixels = canvas[0].reshape(SIZE, _FINER, SIZE, _FINER, 3).mean((1, 3))
        return np.clip(pixels, 0, 255).astype(np.uint8)

    show(0)
    return fig, show, len(poses)


def numbers(array):
    """Return an array of a stored figure, which may be packed."""
    if isinstance(array, dict):
        return np.frombuffer(base64.b64decode(array["bdata"]), array["dtype"])
    return np.array(array, float)


def vertices(trace):
    """Return the points (n, 3) of a stored trace."""
    return np.stack([numbers(trace[c]) for c in "xyz"], -1).astype(float)


def _evenly(times):
    """The numbers of the poses that are drawn: evenly spaced in time, and not too many."""
    times = np.array(times)
    wanted = np.linspace(times[0], times[-1], min(len(times), _MOST))
    return np.abs(times - wanted[:, None]).argmin(1)


def _placed(poses, bodies, points):
    poses = poses[bodies]
    return (poses[:, :3, :3] @ points[:, :, None])[..., 0] + poses[:, :3, 3]


def _faces(trace):
    return np.stack([numbers(trace[c]) for c in "ijk"], -1).astype(int)


def _colours(trace):
    """The colour (n, 3) of each vertex, from the trace's intensity and colour scale, 0 to 255."""
    stops = np.array([stop for stop, _ in trace["colorscale"]])
    palette = np.array([ImageColor.getrgb(colour) for _, colour in trace["colorscale"]], float)
    share = (numbers(trace["intensity"]) - trace["cmin"]) / (trace["cmax"] - trace["cmin"])
    return np.stack([np.interp(share, stops, channel) for channel in palette.T], -1)


def _shaded(points, faces, colours):
    a, b, c = points[faces].swapaxes(0, 1)
    across = np.cross(b - a, c - a)
    normals = np.zeros_like(points)
    for k in range(3):
        np.add.at(normals, faces[:, k], across)
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-12)[:, None]
    lamp = np.array([2000, -3500, 6000]) / 7230
    light = 0.5 + 0.52 * np.maximum(normals @ lamp, 0) + 0.06 * normals[:, 2]
    return colours * np.minimum(light, 1.08)[:, None]


def _seen(points, film):
    """Where points are on the finer picture, in pixels to the right and down, and how near they are."""
    scene = film["layout"]["scene"]
    flat = projected(points, scene)
    ranges = np.array([scene[f"{c}axis"]["range"] for c in "xyz"])
    ratio = np.array([scene["aspectratio"][c] for c in "xyz"])
    eye = np.array([scene["camera"]["eye"][c] for c in "xyz"])
    far = np.linalg.norm((points - ranges.mean(1)) * ratio / np.ptp(ranges, axis=1) - eye, axis=1)
    return np.concatenate([(flat * [1, -1] + 1) / 2 * SIZE * _FINER, -far[:, None]], -1)


def _background(film):
    """Return the picture and depths of everything that does not move, with lines on top."""
    n = SIZE * _FINER
    canvas = (np.full((n, n, 3), 255.0), np.full((n, n), -np.inf))
    still = [trace for k, trace in enumerate(film["data"]) if k != film["layout"]["meta"]["course"]["trace"]]
    for trace in still:
        if trace["type"] == "mesh3d":
            points, faces, colours = vertices(trace), _faces(trace), _colours(trace)
            lit = trace.get("lighting", {}).get("diffuse", 1) > 0
            _fill(canvas, _seen(points, film), faces, _shaded(points, faces, colours) if lit else colours)
    image = Image.fromarray(np.clip(canvas[0], 0, 255).astype(np.uint8))
    pen = ImageDraw.Draw(image)
    for trace in still:
        if trace["type"] == "scatter3d" and trace["mode"] == "lines":
            look, at = trace["line"], _seen(vertices(trace), film)
            dash = 3 if look.get("dash", "solid") == "solid" else 2
            for k in range(len(at) - 1):
                if not np.isnan(at[k : k + 2]).any() and k % dash < 2 - (dash == 2):
                    pen.line([*at[k, :2], *at[k + 1, :2]], look["color"], max(1, round(look["width"] * 0.8)))
    canvas[0][:] = np.asarray(image)
    canvas[1][:] = -np.inf  # what moves is above the floor and beside the table
    return canvas


def _fill(canvas, points, faces, colours):
    """Fill triangles that face the eye, each pixel by the nearest of them, colours interpolated."""
    picture, depth = canvas
    corners = points.astype(np.float32)[faces]
    (x0, y0), (x1, y1), (x2, y2) = (corners[:, k, :2].T for k in range(3))
    area = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
    low = np.floor(corners[:, :, :2].min(1)).astype(int)
    size = (np.ceil(corners[:, :, :2].max(1)) - low).max(1)
    front = area < -1e-9  # pixels run downwards
    for smaller, larger in zip((-1, *_BOXES), _BOXES, strict=False):
        chosen = np.flatnonzero(front & (size > smaller) & (size <= larger))
        for part in np.array_split(chosen, max(1, len(chosen) * larger**2 // 2_000_000)):
            if len(part):
                _fill_boxes(picture, depth, corners[part], faces[part], low[part], larger + 1, colours, area[part])


def _fill_boxes(picture, depth, corners, faces, low, width, colours, area):
    dy, dx = np.mgrid[0:width, 0:width].reshape(2, 1, -1)
    x, y = low[:, :1] + dx, low[:, 1:] + dy
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    px, py = np.float32(0.5) + x.astype(np.float32), np.float32(0.5) + y.astype(np.float32)

    def share(p, q):
        """The barycentric coordinate that belongs to the corner opposite the edge from p to q."""
        return ((q[:, :1] - p[:, :1]) * (py - p[:, 1:2]) - (px - p[:, :1]) * (q[:, 1:2] - p[:, 1:2])) / area[:, None]

    u, v = share(b, c), share(c, a)
    w = 1 - u - v
    n = len(depth)
    inside = (u >= -1e-4) & (v >= -1e-4) & (w >= -1e-4) & (x >= 0) & (y >= 0) & (x < n) & (y < n)
    row, _ = np.nonzero(inside)
    u, v, w, x, y = u[inside], v[inside], w[inside], x[inside], y[inside]
    near = u * a[row, 2] + v * b[row, 2] + w * c[row, 2]
    order = np.argsort(near, kind="stable")  # of several at one pixel the nearest is written last
    order = order[near[order] > depth[y[order], x[order]]]
    x, y, row = x[order], y[order], row[order]
    depth[y, x] = near[order]
    at = colours[faces[row]]
    picture[y, x] = u[order, None] * at[:, 0] + v[order, None] * at[:, 1] + w[order, None] * at[:, 2]
