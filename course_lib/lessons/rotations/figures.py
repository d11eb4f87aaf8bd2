"""The figures of notebook 1, rotations.

Each function returns a Picture: a figure with its words, for `show`.
"""

import numpy as np

from course_lib.arms import SerialArm
from course_lib.figures import charts
from course_lib.figures.digits import fixed, rounded_array
from course_lib.figures.display import Picture
from course_lib.figures.plots import in_columns, lines, plain
from course_lib.figures.solids import Part, scene
from course_lib.figures.solids.meshes import arrow, box, capsule, revolve
from course_lib.figures.solids.model import DARK, LIGHT_BLUE, ORANGE, SILVER, STEEL, VIOLET, X_RED
from course_lib.figures.style import BLACK, BLUE, FRAME_COLOURS, GREY, RED, SPHERE_GREY
from course_lib.figures.toys.arms import jog
from course_lib.figures.toys.film import beside, still
from course_lib.rigid import transform
from course_lib.rotations import log_so3, nearest_so, rot_y

# The camera of the spheres, below the equator: there the two samplers differ most.
FROM_BELOW = {"eye": {"x": 0.75, "y": 0.75, "z": -0.85}}
LEAST_ERROR = 1e-17  # radians: an error of zero is drawn here on a logarithmic axis
HIDDEN_AXIS = {"visible": False, "range": [-1.3, 1.3]}


def arm_toy():
    """Return a toy, not a Picture: the six-axis arm of notebooks 1 to 4, with joint sliders.

    Returns
    -------
    Toy
    """
    x, y, z = np.eye(3)
    origins = [[0, 0, 0], [0, 0, 0.29], [0, 0, 0.56], *3 * [[0.302, 0, 0.63]]]
    home = transform(rot_y(np.pi / 2), [0.374, 0, 0.63])
    arm = SerialArm.from_screws([z, y, y, x, y, x], origins, home)
    return jog(arm, q=[0.3, 0.4, -0.5, 0.6, 0.7, -0.8])


def body_frame(R):
    """Return a drone with its own frame b, coloured, in the fixed frame a, grey.

    The axes of both frames are named.

    Parameters
    ----------
    R : ndarray, shape (3, 3)
        The orientation of b in a.

    Returns
    -------
    Toy
    """
    words = list(zip("xyz", 1.32 * R.T, FRAME_COLOURS, strict=True))
    words += [(name, 1.45 * axis, GREY) for name, axis in zip("xyz", np.eye(3), strict=True)]
    axes = "; ".join(f"{name} along ({_numbers(R[:, k])})" for k, name in enumerate("xyz"))
    alt = (
        "A drone with its own frame b, tilted in a fixed frame a. The axes of b, in coordinates "
        f"of a: {axes}."
    )
    caption = (
        "Frame b is fixed to the drone (x orange, ahead; y green; z blue, up), frame a (grey) to "
        "the room."
    )
    return still(_turned_drone(R, 1.15, 1.35), alt, caption, words=words, view=(1.0, 1.3, 0.9))


def frames(
    orientations, caption="The two products end in different orientations, so the order matters."
):
    """Return a drone with its frame at several orientations, side by side.

    The axes are x orange, y green, and z blue; the fixed axes are grey.

    Parameters
    ----------
    orientations : dict
        Title to an orientation, shape (3, 3). A matrix that is not a rotation deforms the drone.
    caption : str, optional
        What to notice if all matrices are rotations.

    Returns
    -------
    Toy
    """
    groups = {}
    in_words = []
    longest = max(np.linalg.norm(R, axis=0).max() for R in orientations.values())
    scale = min(1, 2.4 / longest)  # one for all orientations
    for title, R in orientations.items():
        words = list(zip("xyz", 1.2 * scale * R.T, FRAME_COLOURS, strict=True))
        words += [(name, 1.4 * axis, GREY) for name, axis in zip("xyz", np.eye(3), strict=True)]
        lengths = np.linalg.norm(R, axis=0)
        if np.ptp(np.append(lengths, 1)) > 0.01:
            groups[title] = (*_grown_drone(R, scale), (), words)
        else:
            groups[title] = (_turned_drone(scale * R, 1.0, 1.25), (), (), words)
        axes = ", ".join(f"{name} {_direction(R[:, k])}" for k, name in enumerate("xyz"))
        stretched = ""
        if np.ptp(np.append(lengths, 1)) > 0.01:
            stretched = f", of lengths {_numbers(lengths)}"
        in_words.append(f"{title}: {axes}{stretched}")
    alt = (
        f"A drone with its three axes, {len(in_words)} times. The axes point near the fixed axes "
        f"so: {'; '.join(in_words)}."
    )
    if longest > 1.01:
        caption = (
            "A rotation keeps all three axes at length one; here the longest grows to "
            f"{fixed(longest, 2)}. Inside the pale drone is one of the true size."
        )
    size = max(1, scale * longest)
    apart, look = 2.5 * size, {"view": (1.35, 1.1, 0.8), "high": 1.5 * size}
    if longest > 1.01:  # as large as the picture allows, so that the growth is seen
        apart, look = 2.2 * size, look | {"high": 1.35 * size, "proportion": 0.42}
    return beside(groups, apart, alt, caption, **look)


def _drone():
    """The parts of a drone with four rotors, the front two blue: x ahead, y to its left, z up."""
    parts = [
        Part(0, DARK, box([-0.36, -0.2, -0.09], [0.36, 0.2, 0.1], 0.5, n=10)),
        Part(0, ORANGE, box([0.22, -0.1, -0.02], [0.46, 0.1, 0.07], 0.4, n=6)),  # the nose
    ]
    for x, y in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
        hub = np.array([0.5 * x, 0.5 * y, 0.06])
        arm = capsule([0.18 * x, 0.12 * y, 0.02], hub - [0, 0, 0.02], 0.035, 6)
        motor = revolve(hub, [0, 0, 1], [(0.06, -0.07), (0.06, 0.07)], 6)
        rotor = revolve(hub, [0, 0, 1], [(0.33, 0.08), (0.33, 0.1)], 12)
        rotor_colour = LIGHT_BLUE if x > 0 else STEEL
        parts += [Part(0, SILVER, arm), Part(0, DARK, motor), Part(0, rotor_colour, rotor)]
    return parts


def _turned_drone(R, own, fixed):
    """The drone with its axes as R rotates (or stretches) it, and the fixed axes.

    own, fixed: the lengths of these axes.
    """
    pose = np.eye(4)
    pose[:3, :3] = R
    parts = [*_drone(), *scene.triad(0, np.eye(4), own, 0.042)]
    turned = [part.moved(pose) for part in parts]
    fixed_axes = [Part(0, STEEL, arrow(np.zeros(3), axis, fixed, 0.013)) for axis in np.eye(3)]
    return turned + fixed_axes


def _grown_drone(R, scale):
    """Return what a matrix makes of the drone: the solid parts and the translucent ones.

    The drone of the true size is solid and the one that the matrix deforms is translucent.
    """
    grown = np.eye(4)
    grown[:3, :3] = scale * R
    true = np.eye(4)
    true[:3, :3] = scale * nearest_so(R)
    axes = [part.moved(grown) for part in scene.triad(0, np.eye(4), 1.0, 0.042)]
    fixed_axes = [Part(0, STEEL, arrow(np.zeros(3), axis, 1.25, 0.013)) for axis in np.eye(3)]
    drone = [part.moved(true) for part in _drone()]
    return drone + axes + fixed_axes, [part.moved(grown) for part in _drone()]


def rotated_point(w, p, exp):
    """Return the path of a point under exp(t w), where t goes from 0 to 1.

    Parameters
    ----------
    w : ndarray, shape (3,)
        The rotation vector: the axis times the angle, in radians.
    p : ndarray, shape (3,)
        The point.
    exp : callable
        The exponential that computes the path, from a rotation vector to a matrix, shape (3, 3).

    Returns
    -------
    Toy
    """
    path = np.array([exp(t * w) @ p for t in np.linspace(0, 1, 60)])
    angle = np.linalg.norm(w)
    n = w / angle
    arrows = [(VIOLET, 1.25 * n), (LIGHT_BLUE, path[0]), (X_RED, path[-1])]
    parts = [
        Part(0, colour, arrow(np.zeros(3), tip, np.linalg.norm(tip), 0.022, 10))
        for colour, tip in arrows
    ]
    parts += [Part(0, STEEL, arrow(np.zeros(3), axis, 1.0, 0.01)) for axis in np.eye(3)]
    words = [("w", 1.32 * n, BLACK), ("p", 1.1 * path[0], BLACK), ("R p", 1.1 * path[-1], BLACK)]
    for name, at in zip("xyz", 1.1 * np.eye(3), strict=True):
        lies_on_w = abs(at @ n) >= 1
        if not lies_on_w:
            words.append((name, at, BLACK))
    where = "in a plane" if np.ptp(path @ n) < 1e-6 else "which leaves the plane"
    alt = (
        f"A point p moves about the axis w by {fixed(angle, 2)} rad to R p, along an arc {where} "
        "perpendicular to it."
    )
    caption = "The point keeps its height along the axis $w$ and its distance from it."
    paths = [(path, BLUE, ())]
    return still(parts, alt, caption, paths=paths, words=words, view=(1.3, 1.0, 0.7))


def log_errors(short_of_pi, errors):
    """Return the errors of logarithms over how far the angle is from pi.

    Parameters
    ----------
    short_of_pi : array_like, shape (n,)
        pi minus the angle, in radians.
    errors : dict
        Label of a logarithm to its errors, shape (n,), in radians.

    Returns
    -------
    Picture
    """
    drawn = {label: np.maximum(error, LEAST_ERROR) for label, error in errors.items()}
    # Not a chart: rounding decides these errors, and a notebook may store no number that differs
    # from one machine to the next.
    fig = lines(short_of_pi, drawn, log="xy", xlabel=r"$\pi - a$ (rad)", ylabel="error (rad)")
    sizes = [f"{label} {_size_of_errors(error)}" for label, error in drawn.items()]
    alt = (
        f"Errors of logarithms over pi minus the angle, both axes logarithmic. {'; '.join(sizes)}."
    )
    caption = (
        "From right to left the angle approaches $\\pi$, and the formula with arccos loses digit "
        "after digit."
    )
    return Picture(fig, alt, caption)


def euler_rates(beta, smallest):
    """Return the smallest singular value of the Euler rate matrix over the pitch.

    Parameters
    ----------
    beta : array_like, shape (n,)
        The pitch, in radians.
    smallest : array_like, shape (n,)
        The smallest singular value at each pitch.

    Returns
    -------
    Picture
    """
    fig = charts.lines(
        beta,
        {"smallest singular value": smallest},
        xlabel="pitch β (rad)",
        ylabel="smallest singular value",
        parts_of_pi=4,
    )
    top = _numbers([beta[np.argmax(smallest)]])
    first = _numbers(smallest[:1])
    last = _numbers(smallest[-1:])
    alt = (
        f"The smallest singular value of the Euler rate matrix is {fixed(max(smallest), 2)} at "
        f"pitch {top} and falls to {first} at pitch {fixed(beta[0], 2)} and to {last} at pitch "
        f"{fixed(beta[-1], 2)}: gimbal lock."
    )
    caption = (
        "At $\\beta = \\pm\\pi/2$ the smallest singular value is zero, so no rates of the "
        "angles rotate the body about one direction."
    )
    return Picture(fig, alt, caption)


def projections(M, rotations):
    """Return what each rotation makes of s1 z11 + s2 z22 = tr(R^T M).

    A rotation takes v1 and v2 to two arrows of length one; z11 and z22 are their projections on the
    axes u1 and u2 of the ellipse that M makes of the unit circle.

    Parameters
    ----------
    M : ndarray, shape (2, 2)
    rotations : dict
        Title of a panel to a rotation, shape (2, 2).

    Returns
    -------
    Picture
    """
    fig, axes = in_columns(rotations, 4.2, 4.3, xlabel="x", ylabel="y")
    U, s, Vt = np.linalg.svd(M)
    # With these signs v1 and v2 point along the axes, not against them.
    signs = np.sign(Vt[[0, 1], np.abs(Vt).argmax(1)])
    U = U * signs
    Vt = signs[:, None] * Vt
    t = np.linspace(0, 2 * np.pi, 181)
    circle = np.array([np.cos(t), np.sin(t)])
    reach = max(1, s[0]) + 0.3
    in_words = []
    for ax, (title, R) in zip(axes, rotations.items(), strict=True):
        ax.plot(*circle, color=GREY, linewidth=1)
        ax.plot(*(M @ circle), color=BLACK, linewidth=1, linestyle="--")
        sizes = np.diag(U.T @ R @ Vt.T)
        for i, colour in enumerate((BLUE, RED)):
            _draw_projection(ax, i, U[:, i], s[i], R @ Vt[i], sizes[i], colour)
        terms = " + ".join(rf"{size:.3g} ({z:.2g})" for size, z in zip(s, sizes, strict=True))
        ax.set(xlim=(-reach, reach), ylim=(-reach, reach), aspect="equal")
        ax.set_title(f"{title}\n$s_1 z_{{11}} + s_2 z_{{22}} = {terms} = {s @ sizes:.3g}$")
        in_words.append(f"{plain(title)}: {_numbers(sizes)}, and a sum of {fixed(s @ sizes, 2)}")
    alt = (
        "The ellipse that M makes of the unit circle, with its axes, and the images of v1 and v2 "
        f"under a rotation, with their projections on these axes. {'; '.join(in_words)}."
    )
    caption = (
        "The ellipse is what $M$ makes of the unit circle, and the thin lines are its axes. The "
        "arrows are the images of $v_1$ and $v_2$ under the rotation. The broad strokes, $z_{11}$ "
        "and $z_{22}$, are their projections on the axes. No projection of an arrow of length one "
        "is longer than one."
    )
    if np.linalg.det(M) < 0:
        caption = (
            "One arrow lies on its axis. The other arrow points against its own axis, so its "
            "$z_{ii}$ is $-1$."
        )
    return Picture(fig, alt, caption)


def _draw_projection(ax, i, u, s, tip, size, colour):
    """Draw an axis u of the ellipse, of half length s, and the projection of an arrow on it."""
    ax.plot(*np.outer(u, [-s, s]), color=BLACK, linewidth=1)
    ax.plot(*np.outer(u, [0, size]), color=colour, linewidth=7, alpha=0.35, solid_capstyle="butt")
    ax.plot(*np.transpose([tip, size * u]), color=colour, linewidth=1, linestyle=":")
    arrow_look = {"arrowstyle": "-|>", "color": colour, "lw": 2, "shrinkA": 0, "shrinkB": 0}
    ax.annotate("", tip, (0, 0), arrowprops=arrow_look)
    aside = 0.15 * np.array([-u[1], u[0]])
    box_look = {"color": "white", "pad": 0.3, "alpha": 0.8}
    text_look = {"ha": "center", "va": "center", "bbox": box_look}
    beyond = 1.32 * tip + aside  # so far that the arrow's head remains free
    ax.annotate(f"$R v_{i + 1}$", beyond, color=colour, **text_look)
    ax.annotate(f"$s_{i + 1} u_{i + 1}$", s * u - 1.6 * aside, **text_look)


def on_sphere(samples):
    """Return rotations on spheres to be rotated: a dot at R e_x, and a tick towards R e_y.

    A rotation is its axis R e_x, a point of the sphere, and a rotation about this axis, which the
    short tick shows. The spheres turn together.

    Parameters
    ----------
    samples : dict
        Title of a sphere to rotations, shape (n, 3, 3).

    Returns
    -------
    Picture
    """
    from plotly.graph_objects import Figure

    fig = Figure(layout={"template": {"layout": charts.STYLE}, "height": 430, "showlegend": False})
    in_words = []
    width = 1 / len(samples)
    for number, (title, R) in enumerate(samples.items()):
        scene = "scene" if number == 0 else f"scene{number + 1}"
        _add_sphere(fig, scene)
        tips = R[:, :, 0]
        ends = 1.001 * tips + 0.09 * R[:, :, 1]
        # One line for all ticks: NaN, between one tick and the next, leaves a gap.
        gaps = np.full_like(tips, np.nan)
        ticks = np.stack([tips, ends, gaps], 1).reshape(-1, 3)
        fig.add_scatter3d(
            **dict(zip("xyz", rounded_array(ticks.T, 3), strict=True)),
            mode="lines",
            line={"color": RED, "width": 2},
            hoverinfo="skip",
            scene=scene,
        )
        angle = np.rad2deg(np.linalg.norm(log_so3(R), axis=-1))
        fig.add_scatter3d(
            **dict(zip("xyz", rounded_array(tips.T, 3), strict=True)),
            mode="markers",
            marker={"color": BLUE, "size": 2.5},
            customdata=rounded_array(angle, 1)[:, None],
            hovertemplate=(
                "R e<sub>x</sub> = (%{x:.2f}, %{y:.2f}, %{z:.2f})<br>rotation angle: "
                "%{customdata[0]:.0f}°<extra></extra>"
            ),
            scene=scene,
        )
        fig.update_layout(
            {
                scene: {
                    "aspectmode": "cube",
                    "camera": FROM_BELOW,
                    "domain": {"x": [number * width, (number + 1) * width], "y": [0, 0.88]},
                    **dict.fromkeys(("xaxis", "yaxis", "zaxis"), HIDDEN_AXIS),
                }
            }
        )
        below = int((R[:, 2, 0] < 0).sum())
        fig.add_annotation(
            text=f"<b>{title}</b><br>{below} of {len(R)} below the equator",
            showarrow=False,
            x=(number + 0.5) * width,
            xanchor="center",
            xref="paper",
            y=1,
            yref="paper",
            yanchor="top",
        )
        up = np.mean(R[:, 2, 0] > 0.9)
        down = np.mean(R[:, 2, 0] < -0.9)
        in_words.append(f"{title}: {up:.0%} in the cap above 0.9, {down:.0%} below -0.9")
    alt = (
        "Spheres, which you can rotate, with a dot where each rotation takes the x axis and a "
        f"short tick towards where it takes the y axis. {'; '.join(in_words)}."
    )
    caption = (
        "Turn the spheres. With uniform Euler angles the dots crowd at the lower pole, and none "
        "is in the upper half. With uniform rotations equal areas hold about equally many dots, "
        "and the ticks point in all directions."
    )
    return Picture(fig, alt, caption)


def _add_sphere(fig, scene):
    """Add a grey sphere, a little smaller than one, which hides what is behind it; its poles."""
    fig.add_scatter3d(
        x=[0, 0],
        y=[0, 0],
        z=[-1.25, 1.25],
        mode="lines+text",
        text=["−z", "z"],
        textposition=["bottom center", "top center"],
        line={"color": GREY, "width": 3},
        hoverinfo="skip",
        scene=scene,
    )
    around, up = np.meshgrid(np.linspace(0, 2 * np.pi, 37), np.linspace(0, np.pi, 19))
    points = 0.985 * np.stack(
        [np.cos(around) * np.sin(up), np.sin(around) * np.sin(up), np.cos(up)]
    )
    fig.add_surface(
        **dict(zip("xyz", rounded_array(points, 3), strict=True)),
        colorscale=[[0, SPHERE_GREY], [1, SPHERE_GREY]],
        showscale=False,
        hoverinfo="skip",
        lighting={"ambient": 0.9, "diffuse": 0.15, "specular": 0},
        scene=scene,
    )


def angles(samples):
    """Return histograms of rotation angles beside the density of uniformly distributed rotations.

    Parameters
    ----------
    samples : dict
        Title of a panel to rotations, shape (n, 3, 3).

    Returns
    -------
    Picture
    """
    fig = charts.panels(
        list(samples),
        xlabel="rotation angle a (rad)",
        ylabel="density (1/rad)",
        share="y",
        parts_of_pi=4,
    )
    in_words = []
    for panel, (title, R) in enumerate(samples.items()):
        angle = np.linalg.norm(log_so3(R), axis=-1)
        heights, edges = np.histogram(angle, 20, (0, np.pi), density=True)
        charts.add_bars(fig, edges, heights, "sample", panel=panel)
        a = np.linspace(0, np.pi, 61)
        density = (1 - np.cos(a)) / np.pi
        charts.add_line(fig, a, density, "f(a), uniform rotations", panel=panel, dash="dash")
        in_words.append(f"{title}: {np.mean(heights[10:]) * np.pi / 2:.0%} above 90 degrees")
    alt = f"Histograms of rotation angles. {'; '.join(in_words)}."
    return Picture(fig, alt, "The dashed curve is $f(a)$, the density of uniform rotations.")


def distances(d_a, d_E, d_q):
    """Return two distances of pairs of rotations over the angle between them.

    Parameters
    ----------
    d_a : ndarray, shape (n,)
        The angle of each pair, in radians.
    d_E : ndarray, shape (n,)
        The difference of the Euler angles, in radians.
    d_q : ndarray, shape (n,)
        One minus the absolute inner product of the quaternions.

    Returns
    -------
    Picture
    """
    fig = charts.panels(
        ["Euler angles", "quaternions"],
        xlabel="angle (degrees)",
        ylabel=["d<sub>E</sub> (rad)", "d<sub>q</sub>"],
        columns=2,
    )
    degrees = np.rad2deg(d_a)
    curve = np.linspace(0, np.pi, 91)
    pairs = "a pair of rotations"
    charts.add_points(fig, degrees, d_E, pairs, size=4, opacity=0.6)
    charts.add_points(fig, degrees, d_q, pairs, panel=1, size=4, opacity=0.6)
    as_functions = {
        "d<sub>a</sub>": (0, curve),
        "1 − cos(d<sub>a</sub>/2)": (1, 1 - np.cos(curve / 2)),
    }
    for name, (panel, values) in as_functions.items():
        charts.add_line(fig, np.rad2deg(curve), values, name, panel=panel)
    apart = d_a > 0
    ratios = d_E[apart] / d_a[apart]
    alt = (
        f"Two distances of {len(d_a)} pairs of rotations over the angle between them. The "
        f"difference of the Euler angles is {fixed(ratios.min(), 1)} to {fixed(ratios.max(), 1)} "
        f"times the angle. The quaternion distance lies on one curve, from 0 to 1."
    )
    caption = (
        "Pairs with the same angle have very different $d_E$, some of them more than twice the "
        "angle. With $d_q$, all pairs lie on one curve."
    )
    return Picture(fig, alt, caption)


def _size_of_errors(errors):
    """How large errors are, in words that rounding does not change."""
    for bound in ("1e-4", "1e-8", "1e-12"):
        if max(errors) > float(bound):
            return f"rises to more than {bound}"
    return "stays below 1e-12"


def _direction(v):
    """The fixed axis that is nearest to the direction of v, in words."""
    k = np.argmax(np.abs(v))
    sign = "" if v[k] > 0 else "minus "
    return f"along {sign}{'xyz'[k]}"


def _numbers(values):
    return ", ".join(fixed(value, 2) for value in values)
