"""The figures of notebook 3: circles of the subproblems in space, and steps of a planar arm.

Each function returns a Picture, for `show`. Axes are unit vectors, angles are in radians, lengths
in metres, and dampings in square metres. `points_of` takes joint angles to an arm's points, base
first: (..., joints + 1, 2).
"""

import re

import numpy as np

from course_lib.figures import charts
from course_lib.figures.digits import fixed, rounded, rounded_array
from course_lib.figures.display import Picture
from course_lib.figures.plots import draw_arms, in_metres, lines
from course_lib.figures.solids import Part
from course_lib.figures.solids.meshes import Mesh, arrow, ball, basis
from course_lib.figures.solids.model import (
    AMBER,
    AXIS,
    PALE,
    PALETTE,
    STEEL,
    VIOLET,
    Y_GREEN,
    Z_BLUE,
)
from course_lib.figures.solids.model import BLACK as INK
from course_lib.figures.solids.model import MUG_RED as RED
from course_lib.figures.style import BLACK, BLUE, COLOURS, CRIMSON, GREEN, GREY, plane_figure
from course_lib.figures.toys.film import still
from course_lib.figures.toys.toy import Toy
from course_lib.figures.words import interval
from course_lib.rotations import exp_so3, log_so3

VIEW = (1.3, 1.0, 0.7)
# Metres: what is below is drawn here, since rounding decides it, differently on other machines.
LEAST_DISTANCE = 1e-6
LEAST_IN_WORDS = "below 1 µm"
# A step of 122 radians magnifies rounding errors. Nobody sees a tenth of a millimetre in a picture
# of eight metres, and its digits are the same on every machine.
DECIMALS_OF_TIPS = 4  # of metres
DIGITS_OF_DISTANCES = 3
GREEK = {"alpha": "α", "eps": "ε"}  # as charts write them
MAX_DRAWN_STEP = 1  # metre: a tip that moves farther in one step jumps about
_LEAST_OF_MAP = 1e-8  # metres
CONVERGED = 0.01  # metres: a run that ends nearer to its target has converged
SAME_POINT = 1e-6  # metres: points that are nearer to each other are one
TRIED_ANGLES = 721  # half a degree apart, on a circle
GAP_DASHES = (6, 5)  # pixels, of the line from a point to its goal


# ---- circles in space ----


def rotated_onto(k, p, g, theta):
    """Return subproblem 1: the circle of p about k, R(k, theta) p, and the goal g.

    Parameters
    ----------
    k : ndarray, shape (3,)
        The axis, a unit vector.
    p, g : ndarray, shape (3,)
        The point and its goal, in metres.
    theta : float
        In radians.

    Returns
    -------
    Toy
    """
    end = _rotated(k, theta, p)
    foot = (k @ p) * k
    paths = [
        _circle(k, p, BLUE),
        (np.array([foot, p]), GREY, ()),
        (np.array([foot, end]), CRIMSON, ()),
        (np.array([end, g]), BLACK, GAP_DASHES),
    ]
    gap = np.linalg.norm(end - g)
    gap_at_start = np.linalg.norm(p - g)
    tried = np.linspace(-np.pi, np.pi, TRIED_ANGLES)
    nearest = min(np.linalg.norm(_rotated(k, angle, p) - g) for angle in tried)
    alt = (
        f"A point p moves on a circle about the axis k, with a goal g. R p is {fixed(gap, 3)} from "
        f"g; p itself {fixed(gap_at_start, 3)}."
    )
    caption = (
        f"The dashed line shows the distance of $R\\,p$ from $g$, {fixed(gap, 3)} m. Of "
        f"{TRIED_ANGLES} points of the circle the nearest is {fixed(nearest, 3)} m from $g$. The "
        f"radii to $p$ and "
        f"to $R\\,p$ enclose the angle $\\theta$. "
        "Only the parts of $p$ and $g$ that are perpendicular to $k$ determine this angle."
    )
    dots = [(p, "p", INK), (g, "g", INK), (end, "R p", RED)]
    return _scene({"k": k}, dots, paths, alt, caption)


def circles_meet(k1, k2, p1, p2, theta):
    """Return subproblem 2: the circles of p1 about k1 and of p2 about k2, and where they meet.

    Parameters
    ----------
    k1, k2 : ndarray, shape (3,)
        The axes, unit vectors.
    p1, p2 : ndarray, shape (3,)
        The points, in metres.
    theta : array_like, shape (m, 2)
        The pairs of angles, in radians. Points that a pair does not bring together are joined by a
        line.

    Returns
    -------
    Toy
    """
    paths = [_circle(k1, p1, BLUE), _circle(k2, p2, GREEN)]
    dots = [(p1, "p1", Z_BLUE), (p2, "p2", Y_GREEN)]
    meetings = 0
    for number, (t1, t2) in enumerate(theta, 1):
        first = _rotated(k1, t1, p1)
        second = _rotated(k2, t2, p2)
        if np.linalg.norm(first - second) < SAME_POINT:
            meetings += 1
            dots.append((first, str(number), RED))
        else:
            dots += [(first, "", RED), (second, "", RED)]
        paths.append((np.array([first, second]), CRIMSON, ()))
    verbs = ("do not meet", "touch in one point", "meet in two points, marked 1 and 2")
    alt = (
        "Two circles on one sphere, that of p1 about the axis k1 and that of p2 about k2; they "
        f"{verbs[min(meetings, 2)]}."
    )
    count = ("no point", "one point", "two points")[min(meetings, 2)]
    caption = (
        f"The circles meet in {count}, and each point in which they meet gives one pair of angles "
        "$(\\theta_1, \\theta_2)$."
    )
    return _scene({"k1": k1, "k2": k2}, dots, paths, alt, caption)


def circle_and_sphere(k, p, g, d, theta):
    """Return subproblem 3: the circle of p about k, and the sphere of radius d about g.

    Parameters
    ----------
    k : ndarray, shape (3,)
        The axis, a unit vector.
    p, g : ndarray, shape (3,)
        The point and the centre of the sphere, in metres.
    d : float
        In metres.
    theta : array_like, shape (m,)
        The angles at which the circle pierces the sphere, in radians.

    Returns
    -------
    Toy
    """
    answers = _answers(k, p, theta)
    tried = np.linspace(0, 2 * np.pi, TRIED_ANGLES)
    all_distances = np.linalg.norm([_rotated(k, angle, p) - g for angle in tried], axis=1)
    distances = [np.linalg.norm(end - g) for end, *_ in answers]
    alt = (
        f"The circle of p about the axis k pierces a sphere of radius {d:g} about g at "
        f"{_count(theta)}."
    )
    caption = (
        "Where the circle pierces the sphere, $R\\,p$ is at the wanted distance from $g$: "
        f"{_listed(distances)}. All points of the circle are {interval(all_distances, 3)} m from "
        "$g$."
    )
    dots = [(p, "p", INK), (g, "g", INK), *answers]
    sphere = Part(0, AMBER, ball(g, d, 32))
    return _scene({"k": k}, dots, [_circle(k, p, BLUE)], alt, caption, [sphere])


def circle_and_plane(k, h, p, d, theta):
    """Return subproblem 4: the circle of p about k, and the plane in which h . x = d.

    Parameters
    ----------
    k : ndarray, shape (3,)
        The axis, a unit vector.
    h : ndarray, shape (3,)
        The direction, of any length.
    p : ndarray, shape (3,)
        The point, in metres.
    d : float
        The value of h . R p in the plane.
    theta : array_like, shape (m,)
        The angles at which the circle pierces the plane, where h . R p = d, in radians.

    Returns
    -------
    Toy
    """
    a, b, n = basis(h)
    half = 1.1 * np.linalg.norm(p)
    answers = _answers(k, p, theta)
    corners = d / np.linalg.norm(h) * n + half * np.array([-a - b, a - b, a + b, b - a])
    front = np.array([[0, 1, 2], [0, 2, 3]])
    back = front[:, ::-1]
    plane = Part(0, AMBER, Mesh(corners, np.concatenate([front, back])))
    alt = (
        "The circle of p about the axis k pierces a plane perpendicular to the direction h at "
        f"{_count(theta)}."
    )
    caption = (
        "The height of $R\\,p$ along $h$ goes up and down once in a revolution, so it takes each "
        f"value between its extremes twice. Here it is {_listed([h @ end for end, *_ in answers])}."
    )
    dots = [(p, "p", INK), *answers]
    return _scene({"k": k, "h": n}, dots, [_circle(k, p, BLUE)], alt, caption, [plane])


def orientation_paths(tracks, duration):
    """Return where rotating frames take e_x, on a sphere.

    Parameters
    ----------
    tracks : dict
        Label to rotations, shape (n, 3, 3), evenly spaced in time, with the same first and last
        one.
    duration : float
        In seconds.

    Returns
    -------
    Toy
    """
    lengths, speeds, paths, words = [], [], [], []
    looks = zip((BLUE, CRIMSON, GREEN), ((), (9, 6), (3, 5)), tracks.items(), strict=False)
    for colour, dash, (label, R) in looks:
        path = R[:, :, 0]
        paths.append((1.005 * path, colour, dash))
        words.append((label.replace("omega", "ω"), 1.1 * path[len(R) // 2], colour))
        time_step = duration / (len(R) - 1)
        speed = np.linalg.norm(log_so3(R[1:] @ R[:-1].mT), axis=1) / time_step
        length = np.linalg.norm(np.diff(path, axis=0), axis=1).sum()
        speed_in_words = f"{interval(speed)} rad/s"
        lengths.append(f"{label} on a path of length {fixed(length, 2)}, at {speed_in_words}")
        symbol = label.replace("omega", "$\\omega$")
        speeds.append(f"at {speed_in_words} with {symbol}")
    start, end = next(iter(tracks.values()))[[0, -1], :, 0]
    words += [("start", 1.12 * start, BLACK), ("end", 1.12 * end, BLACK)]
    parts = [Part(0, PALE, ball(np.zeros(3), 0.98, 32))]
    parts += [Part(0, INK, ball(start, 0.025)), Part(0, INK, ball(end, 0.025))]
    for name, axis in zip("xyz", np.eye(3), strict=True):
        parts.append(Part(0, STEEL, arrow(np.zeros(3), axis, 1.25, 0.01)))
        words.append((name, 1.3 * axis, GREY))
    middle = np.concatenate(list(tracks.values()))[:, :, 0].mean(0)
    in_front_of_the_paths = np.add(middle, [0, 0, 0.3])
    alt = (
        "Where e_x goes on the unit sphere, in motions between the same two orientations: "
        f"{'; '.join(lengths)}."
    )
    caption = (
        "With constant $\\omega$ every point moves on a circle about $\\omega$, and with constant "
        f"rates it does not. The body rotates {' and '.join(speeds)}."
    )
    return still(parts, alt, caption, paths=paths, words=words, view=in_front_of_the_paths)


def _scene(axes, dots, paths, alt, caption, pale=()):
    """A picture with axes through the origin, dots, paths and what is pale.

    axes: {name: direction}. dots: (point, word, colour), whose word may be empty.
    """
    shown = [*(at for at, *_ in dots), *(points for points, *_ in paths)]
    reach = 1.15 * max(np.abs(points).max() for points in shown)
    size = 0.025 * reach
    parts = []
    words = []
    for name, k in axes.items():
        parts.append(Part(0, VIOLET, arrow(-reach * k, k, 2 * reach, 0.5 * size)))
        words.append((name, 1.08 * reach * np.asarray(k), AXIS))
    for at, word, colour in dots:
        parts.append(Part(0, colour, ball(at, size)))
        if word:
            word_colour = BLACK if colour == INK else PALETTE[colour]
            words.append((word, np.add(at, [0, 0, 3 * size]), word_colour))
    return still(parts, alt, caption, pale=pale, paths=paths, words=words, view=VIEW)


def _rotated(k, theta, p):
    return exp_so3(theta * k) @ p


def _circle(k, p, colour):
    """The circle of p about k, a path of `still`."""
    points = [_rotated(k, angle, p) for angle in np.linspace(0, 2 * np.pi, 73)]
    return np.array(points), colour, ()


def _answers(k, p, theta):
    return [(_rotated(k, t, p), str(i), RED) for i, t in enumerate(theta, 1)]


def _listed(lengths):
    """Return lengths in words; two that print alike are said once."""
    in_words = [f"{fixed(length, 3)} m" for length in lengths]
    if len(in_words) == 2 and in_words[0] == in_words[1]:
        return f"{in_words[0]} at both points"
    return " and ".join(in_words) or "nowhere"


def _count(theta):
    return ("no point", "one point", "two points, marked 1 and 2")[len(theta)]


# ---- arms ----


def arm_by_hand():
    """Return how an arm with links of 3 m and 4 m brings its wrist center to (3, 4, 0).

    The wrist center starts at (4, 0, 3), in metres.

    Returns
    -------
    Picture
    """
    fig, (side, top) = plane_figure(8.4, 4.2, 2)
    drawn = [
        (side, [[0, 0], [0, 3], [4, 3]], GREY, "$p = (4, 0, 3)$", (-40, 8)),
        (side, [[0, 0], [1.8, 2.4], [5, 0]], CRIMSON, "$q_2$: height 0", (-92, -14)),
        (top, [[0, 0], [5, 0]], CRIMSON, "$(5, 0, 0)$", (-50, 10)),
        (top, [[0, 0], [3, 4]], BLUE, "$q_1$: $(3, 4, 0)$", (-82, -4)),
    ]
    for ax, corners, colour, words, offset in drawn:
        ax.plot(*np.transpose(corners), "-o", color=colour, linewidth=4, markersize=7)
        ax.plot(*np.transpose([corners[0], corners[-1]]), ":", color=colour)
        ax.annotate(words, corners[-1], xytext=offset, textcoords="offset points", color=colour)
    window = {"xlim": (-0.6, 5.6), "ylim": (-0.8, 4.6)}
    in_metres(side, title="seen from the side", ylabel="z (m)", **window)
    in_metres(top, title="seen from above", **window)
    alt = (
        "Seen from the side, an arm with links of 3 and 4 m at a right angle; rotated down, its "
        "wrist center goes from (4, 3) to (5, 0). Seen from above, the wrist center goes from (5, "
        "0) to (3, 4)."
    )
    caption = "The dotted lines are 5 m long, like the distance from the shoulder to the goal."
    return Picture(fig, alt, caption)


def choices(times, counts):
    """Return how long a motion to each candidate takes, and how many candidates poses have.

    Parameters
    ----------
    times : ndarray, shape (n,)
        Of the motions to the candidates of one pose, in seconds, the shortest first.
    counts : sequence of int
        How many of the eight configurations are within the limits, for each of some poses.

    Returns
    -------
    Picture
    """
    fig = charts.panels(
        ["one pose", f"{len(counts)} poses"],
        xlabel=["candidate", "configurations within limits"],
        ylabel=["time of the motion (s)", "number of poses"],
        columns=2,
    )
    charts.add_points(fig, np.arange(len(times)) + 1, times, "time", size=10)
    tally = np.bincount(counts, minlength=9)
    charts.add_points(fig, np.arange(9), tally, "poses", panel=1, size=10, symbol="diamond")
    fig.update_traces(cliponaxis=False)  # dots at zero are whole
    fig.update_xaxes(dtick=1)
    fig.update_yaxes(rangemode="tozero")
    fig.update_layout(showlegend=False)
    commonest = int(tally.argmax())
    alt = (
        f"The times to {len(times)} candidates are {fixed(times[0], 2)} to {fixed(times[-1], 2)} "
        f"s. Beside them, dots count poses by their configurations within the limits: most often "
        f"{commonest}, for {tally[commonest]} of {len(counts)} poses."
    )
    caption = (
        f"One pose: the motion to the slowest of its {len(times)} candidates takes "
        f"{fixed(times[-1], 2)} s, and the motion to the fastest takes {fixed(times[0], 2)} s. "
        f"{len(counts)} poses: between {min(counts)} and {max(counts)} of their eight "
        f"configurations are within "
        "the limits."
    )
    return Picture(fig, alt, caption)


def joint_motion(motions):
    """Return the joint motion that a step commands over the bend of the last joint.

    Parameters
    ----------
    motions : dict
        Label to a function that takes the bend, in radians, and returns the length of the step of
        the joint angles, in radians.

    Returns
    -------
    Picture
    """
    bends = np.geomspace(0.003, 1, 60)
    by_label = {}
    for label, motion in motions.items():
        by_label[label] = np.array([motion(bend) for bend in bends])
    fig = lines(
        bends,
        by_label,
        log="xy",
        xlabel="bend of the last joint (rad)",
        ylabel="joint motion (rad)",
    )
    ranges = [
        f"{label} from {motion.min():.2g} to {motion.max():.3g} rad"
        for label, motion in by_label.items()
    ]
    alt = (
        f"The joint motion over the bend of the last joint, both logarithmic: {'; '.join(ranges)}."
    )
    caption = (
        "As long as the bend is small, half the bend doubles the motion, because the undamped "
        "step grows as one over the bend."
    )
    if len(by_label) > 1:
        caption = (
            "For small bends the undamped step grows as one over the bend, whereas the damped "
            "step stays small at every bend."
        )
    return Picture(fig, alt, caption)


def largest_rates(inverse_rate_matrix):
    """Return the largest rates of a wrist's angles over its middle angle.

    The rates are those for an angular velocity of one.

    Parameters
    ----------
    inverse_rate_matrix : callable
        inverse_rate_matrix(b) takes the three angles and returns the matrix, shape (3, 3), that
        maps an angular velocity to the rates of the angles.

    Returns
    -------
    Picture
    """
    b2 = np.linspace(0.02, np.pi - 0.02, 301)
    inverses = np.array([inverse_rate_matrix(np.array([0.4, angle, 0.0])) for angle in b2])
    together = np.linalg.norm(inverses, 2, axis=(1, 2))
    single = np.linalg.norm(inverses, axis=2).max(1)
    rates = {"all three together": together, "largest single rate": single}
    fig = charts.lines(
        b2,
        rates,
        log="y",
        parts_of_pi=4,
        xlabel="b<sub>2</sub> (rad)",
        ylabel="rates for 1 rad/s (rad/s)",
    )
    ranges = [
        f"{label} from {rate.min():.2g} to {fixed(rate.max(), 0)} rad/s"
        for label, rate in rates.items()
    ]
    alt = (
        "The largest rates for an angular velocity of one, over b2, on a logarithmic axis: "
        f"{'; '.join(ranges)}."
    )
    middle = np.abs(b2 - np.pi / 4).argmin()
    caption = (
        r"The largest single rate and the largest length grow without bound where "
        r"$\sin b_2 = 0$, because there the first and the third axis coincide. "
        rf"At $b_2 = \pi/4$ they are {fixed(single[middle], 2)} (single) and "
        f"{fixed(together[middle], 2)} rad/s (together)."
    )
    return Picture(fig, alt, caption)


def descents(runs, target, caption):
    """Return the tips' paths of several runs towards one target, and their distances from it.

    The distances are drawn over the steps; those below a micrometre are drawn at one. Each dot is a
    step and says its number. The arm is drawn where each run ends, unless the tip jumps about.

    Parameters
    ----------
    runs : dict
        Label to an arm's points, shape (n, links + 1, 2), one configuration for each step, base
        first, in metres.
    target : array_like, shape (2,)
        In metres.
    caption : str
        What to notice.

    Returns
    -------
    Picture
    """
    fig = charts.panels(
        ["path of the tip", "distance from the target"],
        xlabel=["x (m)", "step"],
        ylabel=["y (m)", "distance (m)"],
        columns=1,  # the path is much wider than high
        height=640,
    )
    fig.layout.yaxis.update(scaleanchor="x", constrain="domain")
    fig.layout.xaxis.constrain = "domain"
    in_words = []
    least_distance = np.inf
    largest_distance = 0.0
    for number, (label, arms) in enumerate(runs.items()):
        name = re.sub(r"\b(alpha|eps)\b", lambda word: GREEK[word[0]], label)
        colour = COLOURS[number % len(COLOURS)]
        tips = rounded_array(arms[:, -1], DECIMALS_OF_TIPS)
        steps = np.arange(len(tips))
        distances = _drawn_distances(arms[:, -1], target)
        details = {"step": steps, "distance from the target": _in_words(distances)}
        jumps_about = np.linalg.norm(np.diff(tips, axis=0), axis=1).max() > MAX_DRAWN_STEP
        if jumps_about:  # lines between the dots would hide everything
            charts.add_points(fig, *tips.T, name, colour=colour, opacity=0.6, details=details)
        else:
            charts.add_line(fig, *tips.T, name, colour=colour, markers=True, details=details)
            _draw_arm(fig, arms[-1], name, colour)
        charts.add_line(fig, steps, distances, name, panel=1, colour=colour, markers=True)
        fig.data[
            -1
        ].hovertemplate = f"{name}<br>step: %{{x}}<br>distance: %{{customdata}}<extra></extra>"
        fig.data[-1].customdata = _in_words(distances)
        least_distance = min(least_distance, distances.min())
        largest_distance = max(largest_distance, distances.max())
        is_near = distances[-1] == LEAST_DISTANCE
        end = "less than a micrometre" if is_near else f"{distances[-1]:.2g} m"
        verb = "jumps about and is" if jumps_about else "ends"
        in_words.append(f"{label}: {verb} {end} from it")
    fig.update_traces(marker_size=4, selector={"mode": "lines+markers"})  # a hundred steps or more
    charts.add_points(fig, [target[0]], [target[1]], "target", colour=BLACK, symbol="x", size=12)
    if least_distance < largest_distance / 30:
        log_range = [np.log10(least_distance / 2), np.log10(2 * largest_distance)]
        fig.update_layout(yaxis2={"type": "log", "range": log_range})
    x, y = target
    alt = (
        f"Paths of an arm's tip towards ({fixed(x, 1)}, {fixed(y, 1)}) m, and the distance over "
        f"the steps. {'; '.join(in_words)}."
    )
    return Picture(fig, alt, caption)


def _drawn_distances(tips, target):
    """Return the distances (n,) of tips (n, 2) from a target, as they are drawn."""
    distances = np.linalg.norm(tips - target, axis=-1)
    powers = np.floor(np.log10(distances.clip(LEAST_DISTANCE)) + 1e-9)
    last_digit = 10.0 ** (powers + 1 - DIGITS_OF_DISTANCES)
    drawn = rounded_array(distances / last_digit, 0) * last_digit
    return drawn.clip(LEAST_DISTANCE)


def _in_words(distances):
    """Return what the pointer says of drawn distances (n,)."""
    return [
        LEAST_IN_WORDS if distance == LEAST_DISTANCE else f"{distance:.{DIGITS_OF_DISTANCES}g} m"
        for distance in distances
    ]


def _draw_arm(fig, points, name, colour):
    """Draw an arm (links + 1, 2) in the first panel, on which the pointer says nothing.

    The legend's entry `name` switches it off.
    """
    points = rounded_array(points, DECIMALS_OF_TIPS)
    charts.add_line(fig, *points.T, name, colour=colour, dash="solid", width=5)
    fig.data[-1].update(opacity=0.45, hoverinfo="skip", hovertemplate=None)


def _window(corners, margin):
    """The lowest and the highest x and y of arrays of points (..., 2), with a margin around."""
    corners = np.concatenate([np.reshape(part, (-1, 2)) for part in corners])
    return corners.min(0) - margin, corners.max(0) + margin


def race(racers, points_of, target):
    """Return the runs of several methods towards one target.

    The legend says how fast they are and how large their steps are.

    Parameters
    ----------
    racers : dict
        Label of a method to its joint angles, shape (steps + 1, joints), in radians.
    points_of : callable
        points_of(angles) returns the arm's points, shape (..., joints + 1, 2), base first.
    target : array_like, shape (2,)
        It counts as reached within a centimetre.

    Returns
    -------
    Picture
    """
    runs = {}
    for label, path in racers.items():
        arms = points_of(path)
        distances = np.linalg.norm(arms[:, -1] - target, axis=-1)
        largest_step = np.linalg.norm(np.diff(path, axis=0), axis=1).max()
        steps = "never there"
        is_near = distances < CONVERGED
        if is_near.any():
            steps = f"{np.argmax(is_near)} steps to {100 * CONVERGED:g} cm"
        runs[f"{label}: {steps}, at most {largest_step:.3g} rad"] = arms
    caption = (
        "Gauss-Newton jumps from dot to dot. The other two methods take smooth paths and end in "
        "nearly the same configuration, which is drawn. Distances below a micrometre are drawn at "
        "one."
    )
    return descents(runs, target, caption)


def gains(epsilons, values, damping=2.0):
    """Return a toy: the length of a damped step over the singular value, and two singular values.

    The singular values are dragged on the ellipse of the velocities of the tip; a slider sets the
    damping. The undamped step, 1/s, and the damped step, s/(s^2 + eps), are curves beside it.

    Parameters
    ----------
    epsilons : sequence of float
        The dampings whose curves stay, in square metres.
    values : dict
        The singular values "s1" and "s2" at the start, in metres, with s1 >= s2.
    damping : float, optional
        The damping at the start, in square metres.

    Returns
    -------
    Toy

    Raises
    ------
    ValueError
        If `values` does not hold two singular values, or they lie outside their interval.
    """
    if set(values) != {"s1", "s2"} or not 0.02 <= values["s2"] <= values["s1"] <= 4:
        raise ValueError(
            f"values must hold s1 and s2, with 0.02 <= s2 <= s1 <= 4 m; it is {values!r}"
        )
    tops = ", ".join(f"{fixed(1 / (2 * np.sqrt(eps)), 2)} rad/m for {eps:g} m²" for eps in epsilons)
    alt = (
        "The joint step per metre of error, over the singular value. Without damping it grows "
        f"without bound towards zero; with damping it rises from zero to a largest value, {tops}, "
        f"and falls again. Two singular values, {fixed(values['s1'], 2)} and "
        f"{fixed(values['s2'], 2)} m, are "
        "the axes of an ellipse and can be dragged, and so can the direction of an error of 1 m. "
        "An arrow shows how far the damped step moves the tip."
    )
    caption = (
        r"Drag $s_2$ towards zero: the undamped step $1/s_2$ leaves the picture. The damped step "
        r"is longest at $s_2 = \sqrt\epsilon$, and then it shrinks to nothing."
    )
    model = {
        "dampings": [float(eps) for eps in epsilons],
        "damping": float(damping),
        "singularValues": [rounded(float(values[name]), 4) for name in ("s1", "s2")],
    }
    return Toy("gains", model, alt, caption=caption)


def step_map(alphas, epsilons, errors, largest, runs, start, target, steps):
    """Return a toy: a map of the error after a run, over step size and damping, and one run.

    A click on the map chooses the run that is shown. A curve in the map is the limit of the step
    size, 2 (1 + eps/s1^2), with the largest singular value s1.

    Parameters
    ----------
    alphas : array_like, shape (n,)
        Step sizes, evenly spaced on a logarithmic axis.
    epsilons : array_like, shape (m,)
        Dampings, in square metres, evenly spaced on a logarithmic axis.
    errors : ndarray, shape (n, m)
        In metres; NaN for a run that rounding decides, which has a colour of its own.
    largest : float
        The largest singular value at the target, in metres.
    runs : sequence of (alpha, eps)
        The runs to mark; the first one is shown at the start.
    start : array_like, shape (n_joints,)
        Joint angles, in radians, at the beginning of each run of an arm with links of 1 m.
    target : array_like, shape (2,)
        In metres.
    steps : int
        The number of steps of each run.

    Returns
    -------
    Toy
    """
    limit = 2 * (1 + np.array(epsilons) / largest**2)
    left = np.asarray(alphas)[:, None] < limit
    blue_left = 100 * (errors[left] < CONVERGED).mean()
    blue_right = 100 * (errors[~left] < CONVERGED).mean()
    marked = "1 run" if len(runs) == 1 else f"{len(runs)} runs"
    alt = (
        "A map of the distance after a run, over step size and damping, both logarithmic. Left of "
        f"a curve, the limit of the step size, {fixed(blue_left, 0)} % of it is blue, below a "
        f"centimetre; right of it {fixed(blue_right, 0)} %. Circles mark {marked}. A ring that can "
        f"be dragged chooses a run, and beside the map the arm makes it."
    )
    caption = (
        "Click just left and then just right of the black curve: on one side the tip comes to rest "
        "at the target, and on the other side it jumps about. Where it does so for long, rounding "
        "decides where it ends, and the map is grey. At the left and at the top the steps are too "
        "small, and the tip is still on its way."
    )
    model = {
        "lengths": [1.0] * len(start),
        "q": list(map(float, start)),
        "target": list(map(float, target)),
        "steps": int(steps),
        "alphas": rounded_array(np.log10(alphas), 4).tolist(),
        "epsilons": rounded_array(np.log10(epsilons), 4).tolist(),
        "logErrors": [[_log_or_none(error) for error in row] for row in errors.T],
        "largest": rounded(float(largest), 6),
        "runs": [list(map(float, run)) for run in runs],
        "at": list(map(float, runs[0])),
    }
    return Toy("step_map", model, alt, caption=caption)


def _log_or_none(error):
    """Return the decimal logarithm of a distance, in metres, or None for NaN."""
    if np.isnan(error):
        return None
    # Rounding decides smaller distances, and the map shows them by the same colour.
    return rounded(float(np.log10(max(error, _LEAST_OF_MAP))), 2)


def two_arms(paths, points_of):
    """Return arms side by side, at instants that are evenly spaced along their joint paths.

    Parameters
    ----------
    paths : dict
        Damping, in square metres, to joint angles, shape (n, joints), in radians.
    points_of : callable
        points_of(angles) returns the arm's points, shape (..., joints + 1, 2), base first, in
        metres.

    Returns
    -------
    Picture
    """
    arms = {}
    for eps, path in paths.items():
        steps = np.linalg.norm(np.diff(path, axis=0), axis=1)
        length = np.r_[0, np.cumsum(steps)]
        spaced = np.linspace(0, length[-1], 61)
        angles = [np.interp(spaced, length, angle) for angle in np.transpose(path)]
        arms[rf"$\epsilon$ = {eps:g} m²"] = points_of(np.transpose(angles))
    folds = ", ".join(
        f"epsilon = {eps:g} m²: {fixed(np.abs(path[:, -1]).max(), 1)} rad"
        for eps, path in paths.items()
    )
    alt = (
        "Arms between the same start and target, later ones darker. The last elbow bends at most "
        f"by {folds}."
    )
    caption = (
        "With much damping the tip leaves the straight line in an arc, and the joints move less."
    )
    return Picture(draw_arms(arms, 12, _window(arms.values(), 0.3)), alt, caption)


def manipulability_along(dampings, values):
    """Return the manipulability over the steps of runs with several dampings.

    Parameters
    ----------
    dampings : array_like, shape (m,)
        In square metres.
    values : array_like, shape (m, n)
        A row for each damping and a value for each step, in square metres.

    Returns
    -------
    Picture
    """
    by_damping = {f"ε = {eps:g} m²": row for eps, row in zip(dampings, values, strict=True)}
    fig = charts.lines(
        np.arange(values.shape[1]), by_damping, xlabel="step", ylabel="manipulability (m²)"
    )
    ranges = [
        f"epsilon = {eps:g} m²: {fixed(min(row), 1)} to {fixed(max(row), 1)}"
        for eps, row in zip(dampings, values, strict=True)
    ]
    alt = f"The manipulability (m²) over the steps. {'; '.join(ranges)}."
    caption = (
        "With little damping the curve settles within a few steps; with much damping it changes "
        "slowly."
    )
    return Picture(fig, alt, caption)
