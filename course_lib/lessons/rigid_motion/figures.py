"""The figures of notebook 2, rigid motion in the plane.

Each function returns a Picture, for `show`.

Poses are rows (x, y, theta), in metres and radians; times are in seconds.
"""

import numpy as np

from course_lib.figures import charts
from course_lib.figures.digits import fixed, rounded_array
from course_lib.figures.display import Picture
from course_lib.figures.plots import draw_arms, in_columns, in_metres, legend_above
from course_lib.figures.style import (
    BLACK,
    BLUE,
    COLOURS,
    CRIMSON,
    GREY,
    PALE_BLUE,
    PALE_CRIMSON,
    TABLE_BEIGE,
    plane_figure,
)
from course_lib.figures.toys.film import flat_film
from course_lib.figures.toys.toy import Toy
from course_lib.figures.words import interval
from course_lib.planar import pose_matrix

HALF = 10  # metres from the middle of the scene to its edge
GHOST = "#6b7177"  # the grey of lines in toys, which has another shade on a dark page
_GHOSTS = 4  # later poses in the photograph of a film
_FASTEST_WHEEL = 0.5  # m/s, to which the sliders of `wheels` go
RADIUS = 0.17  # of the vacuum robot and of the car, metres
# A body with a nose, which shows its direction: corners in its own frame, metres.
_BODY = np.array([[-1, -0.7], [0.7, -0.7], [1.4, 0], [0.7, 0.7], [-1, 0.7], [-1, -0.7]])
_CAPTIONS = {  # of films
    "body-interpolated": (
        "The red body follows the cubic time scaling, and is slow at both ends; the grey one "
        "follows the linear time scaling. When is which one ahead?"
    ),
    "body-propagated": (
        "While the body rotates, its path bends. In the third part the body moves sideways "
        "without rotating."
    ),
    "arm-interpolated": "Both joints move in proportion to each other, and the tip draws a curve.",
    "arm-linear": (
        "The left arm is linear in time and the right one cubic, along the same path and "
        "in the same duration. The left arm starts abruptly. The right arm is drawn beside it, "
        "and both have their base at x = 0."
    ),
    "arm-propagated": "The first joint moves for one second, then the second joint, then both.",
}


def outline(pose):
    """Return the corners of the body at a pose.

    Parameters
    ----------
    pose : array_like, shape (3,)

    Returns
    -------
    ndarray, shape (6, 2)
        In metres; the last corner is the first again.
    """
    T = pose_matrix(pose)
    return rounded_array(_BODY @ T[:2, :2].T + T[:2, 2], 3)


def _point(p):
    return f"({p[0]:.3g}, {p[1]:.3g})"


def _rotation(theta):
    """How far an angle rotates along a path, in words."""
    angle = np.sum(np.diff(theta))
    if abs(angle) < 0.005:
        return "without rotation"
    sense = "counter-clockwise" if angle > 0 else "clockwise"
    return f"rotating {sense} by {fixed(abs(angle), 2)} rad"


# ---- robots on wheels ----


def parking(poses, dock, table, keep_away):
    """Return the path of a robot that should stop in its dock, and the round table on its way.

    Parameters
    ----------
    poses : ndarray, shape (n, 3)
        Of the robot.
    dock : array_like, shape (3,)
        The pose in which the robot should stop.
    table : tuple of float
        (x, y, r), the middle of the table and its radius, in metres.
    keep_away : float
        How far from the middle of the table the robot's centre has to stay, in metres.

    Returns
    -------
    Picture
    """
    from matplotlib.patches import Circle

    middle = np.asarray(table[:2], float)
    fig, (ax,) = plane_figure(4.4, 4.6)
    ax.add_patch(Circle(middle, keep_away, facecolor="none", edgecolor=GREY, linestyle="--"))
    ax.add_patch(Circle(middle, table[2], facecolor=TABLE_BEIGE, edgecolor=GREY))
    ax.annotate("table", middle, ha="center", va="center")
    ax.plot(*poses[:, :2].T, color=BLUE, linewidth=2, label="path")
    drawn = np.unique(np.linspace(0, len(poses) - 1, 5).round().astype(int))
    for x, y, theta in poses[drawn]:
        robot = Circle((x, y), RADIUS, facecolor=PALE_BLUE, edgecolor=BLUE, linewidth=2, zorder=3)
        ax.add_patch(robot)
        front = (x + RADIUS * np.cos(theta), y + RADIUS * np.sin(theta))
        ax.plot([x, front[0]], [y, front[1]], color=BLUE, linewidth=2, zorder=4)
    T = pose_matrix(dock)
    corners = RADIUS * np.array([[1.1, -1.7], [1.7, -1.7], [1.7, 1.7], [1.1, 1.7]])
    ax.fill(*(T[:2, :2] @ corners.T + T[:2, 2:]), color=BLACK, label="dock")
    in_metres(ax)
    ax.margins(0.04)
    legend_above(fig, 2)
    nearest = np.linalg.norm(poses[:, :2] - middle, axis=1).min()
    alt = (
        f"A robot drives from {_point(poses[0])} to {_point(poses[-1])}. Its dock is at "
        f"{_point(dock)}. On its way its centre comes as near as {fixed(nearest, 2)} m to the "
        f"middle of a round table; {keep_away:g} m are allowed."
    )
    caption = (
        "The centre of the robot has to stay outside the dashed circle. The robot has to stop in "
        "the dock, facing its black wall."
    )
    return Picture(fig, alt, caption)


def wheels(left, right, track):
    """Return a toy: a robot on two wheels, whose speeds sliders set.

    It shows the pole, the paths of both wheels and of the robot's middle, and the robot on its
    path at a time that a further slider sets. The robot faces x at (0, 0) at first.

    Parameters
    ----------
    left, right : float
        Speeds of the wheels at the start, in m/s, from -0.5 to 0.5.
    track : float
        Distance between the wheels, in metres.

    Returns
    -------
    Toy

    Raises
    ------
    ValueError
        If a speed lies outside its interval, or `track` is not greater than 0.
    """
    for name, speed in (("left", left), ("right", right)):
        if not -_FASTEST_WHEEL <= speed <= _FASTEST_WHEEL:
            raise ValueError(
                f"{name} must lie between {-_FASTEST_WHEEL} and {_FASTEST_WHEEL} m/s; "
                f"it is {speed!r}"
            )
    if not track > 0:
        raise ValueError(f"track must be greater than 0; it is {track!r}")
    where = "there is no pole, because both wheels are equally fast"
    if left != right:
        pole = track * (left + right) / (2 * (right - left))
        side = "left" if pole >= 0 else "right"
        where = (
            f"both roll on circles about one point, the pole, {abs(pole):.3g} m to the {side} of "
            "the robot's middle"
        )
    alt = (
        f"A robot on two wheels, seen from above, whose speeds sliders set, with the paths of the "
        f"wheels. The left wheel rolls at {left:g} m/s and the right wheel at {right:g} m/s, and "
        f"{where}. The tips of the wheels' speeds, drawn as arrows, lie on a line through the pole."
    )
    caption = (
        "Let the left wheel roll backwards as fast as the right one rolls forwards. The pole moves "
        "into the robot's middle, and the robot rotates on the spot."
    )
    model = {"left": left, "right": right, "track": track}
    return Toy("wheels", model, alt, caption=caption)


# ---- a body ----


def body_movie(name, poses, times, ghost=None):
    """Return a film of the body, outlined in red, moving along its dashed blue path.

    Parameters
    ----------
    name : str
        That of its file if it is written as an animation.
    poses : ndarray, shape (n, 3)
    times : array_like, shape (n,)
        Of the poses, in seconds.
    ghost : ndarray, shape (n, 3), optional
        Poses of a second body at these times, which is outlined in grey behind the first.

    Returns
    -------
    Toy
    """
    track = poses[:, :2]
    alt = (
        f"Moving picture, {times[-1] - times[0]:.3g} s. A body outlined in red moves along a "
        f"dashed blue path from {_point(poses[0])} to {_point(poses[-1])}, "
        f"{_rotation(poses[:, 2])}."
    )
    still = [(track, BLUE, (7, 5)), (track[:1], BLUE, ()), (track[-1:], BLUE, ())]
    bodies = [[outline(pose) for pose in poses]]
    look = {"still": still, "half": HALF, "closed": True, "ghosts": _GHOSTS}
    if ghost is not None:
        bodies.insert(0, [outline(pose) for pose in ghost])
        look["colours"] = [GHOST, CRIMSON]
        apart = np.linalg.norm(track - ghost[:, :2], axis=1).max()
        alt += (
            f" A second body, outlined in grey, is up to {fixed(apart, 2)} m away from the first."
        )
    return flat_film(bodies, times, alt, _CAPTIONS.get(name, ""), name=name, **look)


def longer_arc(times, wrapped, unwrapped):
    """Return a film of a body that rotates along the shorter arc and one along the longer arc.

    Parameters
    ----------
    times : array_like, shape (n,)
        Of the poses, in seconds.
    wrapped, unwrapped : ndarray, shape (n, 3)
        Poses, whose angles do not jump.

    Returns
    -------
    Toy
    """
    motions = {"wrapped": wrapped, "not wrapped": unwrapped}
    in_words = []
    for name, poses in motions.items():
        in_words.append(
            f"{name}: {fixed(poses[-1, 2] - poses[0, 2], 2)} rad, {_rotation(poses[:, 2])}"
        )
    begin, end = _point(wrapped[0]), _point(wrapped[-1])
    alt = (
        f"Moving picture, {times[-1] - times[0]:.3g} s. One body wraps the difference of its "
        f"directions, and another one does not. Both move from {begin} to {end} along the same "
        f"line. {_capital('; '.join(in_words))}."
    )
    caption = (
        "Stop the film halfway: the two bodies point in opposite directions there. They end in the "
        "same pose, because the two rotations differ by $2\\pi$."
    )
    track = wrapped[:, :2]
    return flat_film(
        [[outline(pose) for pose in poses] for poses in motions.values()],
        times,
        alt,
        caption,
        name="body-wrapped-or-not",
        still=[(track, GHOST, (7, 5)), (track[:1], GHOST, ()), (track[-1:], GHOST, ())],
        half=8.5,  # small maps, in which the bodies should be large
        closed=True,
        colours=(CRIMSON, BLUE),
        names=tuple(motions),
        ghosts=_GHOSTS,
    )


def _capital(words):
    return words[0].upper() + words[1:]


def past_a_gate(paths):
    """Return paths of a body with given velocities at both ends.

    Parameters
    ----------
    paths : dict
        Title to poses, shape (n, 3).

    Returns
    -------
    Picture
    """
    caption = (
        "Both paths leave to the right and arrive upwards. The quintic is straighter at the ends, "
        "and bends more in the middle."
    )
    return _body_paths(paths, 16, caption)


def straight_and_screw(motions, pole):
    """Return two motions between two poses, the straight and the screw motion.

    Parameters
    ----------
    motions : dict
        Title to poses, shape (n, 3).
    pole : array_like, shape (2,)
        Of the screw motion, in metres.

    Returns
    -------
    Picture
    """
    in_words = []
    for title, poses in motions.items():
        distances = np.linalg.norm(poses[:, :2] - pole, axis=1)
        in_words.append(f"{title}: {interval(distances)} m")
    return _body_paths(motions, 10, f"Distance from the pole: {'; '.join(in_words)}.", pole)


def _body_paths(contents, every, caption, pole=None):
    """Paths {title: poses} side by side, with the body at several poses, the later the darker.

    The body is drawn at every so many poses and at the last one.
    """
    fig, axes = in_columns(contents, 4.2, 4.5, xlabel="x (m)", ylabel="y (m)")
    in_words = []
    for ax, (title, poses) in zip(axes, contents.items(), strict=True):
        ax.plot(*poses[:, :2].T, color=BLUE, linestyle="--", linewidth=1.5)
        last = len(poses) - 1
        for i in [*range(0, last, every), last]:
            corners = outline(poses[i]).T
            ax.plot(*corners, color=CRIMSON, linewidth=1.5, alpha=0.3 + 0.7 * i / last)
            ax.fill(*corners, color=PALE_CRIMSON, alpha=0.15 + 0.75 * i / last)
        if pole is not None:
            ax.plot(*pole, "o", color=BLACK)
            ax.annotate("pole", pole, xytext=(8, 6), textcoords="offset points")
        ax.set(xlim=(-HALF, HALF), ylim=(-HALF, HALF), aspect="equal")
        ax.set(xticks=range(-HALF, HALF + 1, 5), yticks=range(-HALF, HALF + 1, 5))
        length = np.linalg.norm(np.diff(poses[:, :2], axis=0), axis=1).sum()
        ends = f"from {_point(poses[0])} to {_point(poses[-1])} over {fixed(length, 1)} m"
        in_words.append(f"{title.capitalize()}: {ends}, {_rotation(poses[:, 2])}.")
    if pole is not None:
        in_words.append(f"A dot marks the pole, at {_point(pole)}.")
    count = "1 path" if len(contents) == 1 else f"{len(contents)} paths"
    return Picture(fig, f"The same body on {count}. {' '.join(in_words)}", caption)


def euler_paths(paths):
    """Return the paths of one plan by Euler's method with several steps, beside the exact path.

    Parameters
    ----------
    paths : dict
        Label to points, shape (n, 2), in metres; the exact path is the last one.

    Returns
    -------
    Picture
    """
    fig = charts.panels(xlabel="x (m)", ylabel="y (m)", equal=True, height=470)
    exact = list(paths)[-1]
    in_words = []
    for label, points in paths.items():
        off = np.linalg.norm(points[-1] - paths[exact][-1])
        name = label
        if label != exact:
            name = f"{label}: {fixed(off, 3)} m off"
            in_words.append(
                f'The path "{name}" ends at {_point(points[-1])}, {fixed(off, 2)} m from the '
                f'end of "{exact}".'
            )
        is_short = len(points) < 60
        number = {"number of steps": np.arange(len(points))}
        charts.add_line(fig, *points.T, name, markers=is_short, details=number)
    alt = f"Paths from one point. {' '.join(in_words)}"
    caption = (
        "Euler's method leaves the exact path in the first bend. With a smaller step it "
        "leaves the path less."
    )
    return Picture(fig, alt, caption)


def euler_errors(steps, errors):
    """Return the error of Euler's method over its step, beside a line of slope one.

    Parameters
    ----------
    steps : array_like, shape (n,)
        Time steps, in seconds, the longest first.
    errors : array_like, shape (n,)
        The error at the end for each step, in metres.

    Returns
    -------
    Picture
    """
    curves = {"Euler": errors, "slope 1": errors[-1] * steps / steps[-1]}
    fig = charts.lines(
        steps, curves, log="xy", xlabel="step dt (s)", ylabel="error at the end (m)", markers=True
    )
    alt = (
        "The error at the end over the step, on logarithmic axes, beside a line of slope one: "
        f"{errors[-1]:.2g} m for steps of {steps[-1]:.2g} s, {errors[0]:.2g} m for {steps[0]:.2g} "
        "s."
    )
    caption = "For short steps the slope is 1, because the error is proportional to the step."
    return Picture(fig, alt, caption)


# ---- time scalings ----


def time_scalings(u, curves):
    """Return time scalings with their velocities and accelerations, three panels below each other.

    Where a velocity jumps at an end, from a body at rest or to it, the acceleration is an impulse,
    and an arrow stands for it.

    Parameters
    ----------
    u : array_like, shape (n,)
        Time as a part of T, from 0 to 1.
    curves : dict
        Name of a time scaling to its values, velocities and accelerations, shape (3, n).

    Returns
    -------
    Picture
    """
    fig = charts.panels(
        ["", "", ""],
        xlabel="time t / T",
        ylabel=["s", "velocity of s (1/T)", "acceleration of s (1/T²)"],
        columns=1,
        share="x",
        height=620,
    )
    largest = max(np.abs(curve[2]).max() for curve in curves.values())
    in_words = []
    for number, (name, curve) in enumerate(curves.items()):
        for panel in range(3):
            charts.add_line(fig, u, np.asarray(curve[panel], float), name, panel=panel)
        _, velocity, acceleration = curve
        impulses = ""
        if abs(velocity[0]) > 1e-9 or abs(velocity[-1]) > 1e-9:
            _add_impulses(fig, velocity[0], velocity[-1], largest, COLOURS[number])
            impulses = ", with an impulse at each end, where the velocity jumps"
        in_words.append(
            f"The {name} one: velocity {fixed(velocity[0], 2)} at the start, up to "
            f"{fixed(max(velocity), 2)}; acceleration from {fixed(acceleration[0], 1)} to "
            f"{fixed(acceleration[-1], 1)}{impulses}."
        )
    alt = f"Time scalings from 0 to 1. {' '.join(in_words)}"
    caption = (
        "At both ends of each curve compare its velocity with that of a body at rest, "
        "which is 0. Where the velocity jumps, the acceleration is infinite, which an "
        "arrow shows."
    )
    return Picture(fig, alt, caption)


def _add_impulses(fig, first_velocity, last_velocity, largest, colour):
    """Draw the impulses by which a velocity jumps from 0 at the start, and back to 0 at the end."""
    x_axis, y_axis = fig.layout.meta["panels"][2]
    height = max(largest, 1.0)
    for x, jump in ((0.0, first_velocity), (1.0, -last_velocity)):
        fig.add_annotation(
            x=x,
            y=height * np.sign(jump),
            ax=x,
            ay=0.0,
            xref=x_axis,
            yref=y_axis,
            axref=x_axis,
            ayref=y_axis,
            text="",
            showarrow=True,
            arrowhead=2,
            arrowwidth=2.5,
            arrowcolor=colour,
        )
    fig.update_layout({f"yaxis{y_axis[1:]}": {"range": [-1.15 * height, 1.15 * height]}})


def speed_profiles(profiles):
    """Return motions along straight paths: distance, speed and acceleration over time.

    Parameters
    ----------
    profiles : dict
        Name to (times, distances, speeds, accelerations), each of shape (n,), in s, m, m/s, m/s².

    Returns
    -------
    Picture
    """
    fig = charts.panels(
        ["", "", ""],
        xlabel="time (s)",
        ylabel=["distance (m)", "speed (m/s)", "acceleration (m/s²)"],
        columns=1,
        share="x",
        height=620,
    )
    in_words = []
    for name, (times, *curves) in profiles.items():
        for panel, curve in enumerate(curves):
            charts.add_line(fig, times, curve, name, panel=panel)
        distance, speed, acceleration = curves
        in_words.append(
            f"{name}: {distance[-1]:.3g} m in {fixed(times[-1], 2)} s, speed up to "
            f"{fixed(speed.max(), 2)} m/s, acceleration up to {fixed(acceleration.max(), 2)} m/s²."
        )
    alt = f"Motions from rest to rest over time. {' '.join(in_words)}"
    caption = (
        "No motion passes a limit. At each instant a trapezoidal profile uses one limit fully; "
        "the cubic touches its limit only at its ends."
    )
    return Picture(fig, alt, caption)


def past_via_points(points, motions):
    """Return paths that pass by via points with blends, and their speeds.

    Parameters
    ----------
    points : ndarray, shape (m, 2)
        The via points, in metres.
    motions : dict
        Name to (times, path), shapes (n,) and (n, 2), in s and m.

    Returns
    -------
    Picture
    """
    fig = charts.panels(
        ["path", "speed"],
        xlabel=["x (m)", "time (s)"],
        ylabel=["y (m)", "speed (m/s)"],
        columns=2,
        height=330,
    )
    fig.layout.xaxis.constrain = "domain"  # one metre is as long along y as along x
    fig.layout.yaxis.update(scaleanchor="x", constrain="domain")
    charts.add_line(fig, *points.T, "via points", colour=GREY, dash="dot", markers=True)
    in_words = []
    for dash, (name, (times, path)) in zip(charts.DASHES, motions.items(), strict=False):
        charts.add_line(fig, *path.T, name, dash=dash, details={"time (s)": times})
        velocity = np.gradient(path, times, axis=0)
        speed = np.linalg.norm(velocity, axis=1)
        charts.add_line(fig, times, speed, name, dash=dash, panel=1)
        nearest = [np.linalg.norm(path - p, axis=1).min() for p in np.unique(points, axis=0)]
        in_words.append(
            f"{name}: takes {fixed(times[-1], 2)} s and passes the farthest corner at "
            f"{fixed(max(nearest), 3)} m."
        )
    fig.update_traces(line={"simplify": False})  # else plotly draws the blends as polygons
    count = len(np.unique(points, axis=0))
    alt = (
        f"Paths along straight lines between {count} points with blends, and the speed over "
        f"time. {' '.join(in_words)}"
    )
    caption = (
        "Zoom in on a corner: the faster body passes it farther away. In a blend around a right "
        "angle the speed falls to 71 %, because the velocity changes along a straight line."
    )
    return Picture(fig, alt, caption)


# ---- arms ----


def arm_movie(name, points, times, beside=None, names=("linear", "cubic")):
    """Return a film of a planar arm in red, with its tip's dashed blue path.

    Parameters
    ----------
    name : str
        That of its file if it is written as an animation.
    points : ndarray, shape (n, links + 1, 2)
        Of base, joints and tip, in metres; the links are one metre long.
    times : array_like, shape (n,)
        Of the points, in seconds.
    beside : ndarray, shape (n, links + 1, 2), optional
        The points of a second arm at these times, which is drawn to the right of the first.
    names : sequence of str, optional
        The names of both arms, if there are two.

    Returns
    -------
    Toy
    """
    links = points.shape[1] - 1
    arms = [points]
    look = {"half": links + 0.4}
    if beside is not None:
        arms.append(beside)
        look["names"] = names
    still = []
    for number, arm in enumerate(arms):
        path_of_tip = (arm[:, -1], BLUE, (7, 5), number)
        base = (arm[0, :1], BLACK, (), number)
        still += [path_of_tip, base]
    alt = (
        f"Moving picture, {times[-1] - times[0]:.3g} s. An arm of {links} links moves; its tip "
        f"draws a dashed blue curve from {_point(points[0, -1])} to {_point(points[-1, -1] + 0.0)}."
    )
    if beside is not None:
        off = np.linalg.norm(points[:, -1] - beside[:, -1], axis=1).max()
        alt += f" A second arm moves to its right; their tips are up to {fixed(off, 2)} m apart."
    return flat_film(
        arms, times, alt, _CAPTIONS.get(name, ""), name=name, still=still, ghosts=_GHOSTS, **look
    )


def arm_paths(contents):
    """Return arms side by side, each on its path between the same configurations.

    Every tenth instant is drawn.

    Parameters
    ----------
    contents : dict
        Title to points, shape (n, links + 1, 2), in metres.

    Returns
    -------
    Picture
    """
    in_words = []
    titled = {}
    for title, points in contents.items():
        length = np.linalg.norm(np.diff(points[:, -1], axis=0), axis=1).sum()
        titled[f"{title}: {fixed(length, 2)} m"] = points
        ends = f"{_point(points[0, -1])} to {_point(points[-1, -1])}"
        in_words.append(f"{title.capitalize()}: the path is {fixed(length, 2)} m long, {ends}.")
    caption = (
        "On the joint-space line, the joints move in proportion to each other, and the path of "
        "the tip is a curve. On the task-space line, the path of the tip is straight."
    )
    return Picture(draw_arms(titled, 10), " ".join(in_words), caption)


def joint_tracks(paths):
    """Return paths in the plane of the two joint angles.

    Parameters
    ----------
    paths : dict
        Label to joint angles, shape (n, 2), in radians.

    Returns
    -------
    Picture
    """
    fig = charts.panels(
        xlabel="angle of joint 1 (rad)", ylabel="angle of joint 2 (rad)", height=420
    )
    for label, theta in paths.items():
        degrees = {
            "joint 1 (degrees)": np.rad2deg(theta[:, 0]),
            "joint 2 (degrees)": np.rad2deg(theta[:, 1]),
        }
        charts.add_line(fig, *theta.T, label, details=degrees)
    in_words = [
        f"{label.capitalize()}: joint 2 between {fixed(theta[:, 1].min(), 2)} and "
        f"{fixed(theta[:, 1].max(), 2)} rad."
        for label, theta in paths.items()
    ]
    alt = f"Paths in the plane of the two joint angles. {' '.join(in_words)}"
    caption = (
        "These are the same two motions in joint space. Here the motion with the straight path of "
        "the tip is curved, and the other motion is straight."
    )
    return Picture(fig, alt, caption)
