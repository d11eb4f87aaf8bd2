"""The pictures in the plane of notebook 3: the arm, its steps, and what step size and damping do.

Each function returns {"fig", "alt", "caption"}, for ``show(**...)``.
"""

import numpy as np
from matplotlib.colors import TwoSlopeNorm

from course_lib.figures.planar_arm import arm_paths
from course_lib.figures.plots import STYLES, lines
from course_lib.figures.style import BLACK, COLOURS, GREY, plane_figure


def joint_motion(motions):
    """Return the joint motion that a step commands, over the bend of the last joint.

    Parameters
    ----------
    motions : dict
        Label to a function from a bend to a joint motion, both in radians.

    Returns
    -------
    dict

    Examples
    --------
    >>> joint_motion({"undamped": lambda bend: 1.2 / bend})["alt"][-29:]
    'undamped from 1.2 to 400 rad.'
    """
    bends = np.geomspace(0.003, 1, 60)
    rows = {label: np.array([motion(bend) for bend in bends]) for label, motion in motions.items()}
    fig = lines(bends, rows, log="xy", xlabel="bend of the last joint (rad)", ylabel="joint motion (rad)")
    said = "; ".join(f"{label} from {np.min(y):.2g} to {np.max(y):.3g} rad" for label, y in rows.items())
    alt = f"The joint motion over the bend of the last joint, both logarithmic: {said}."
    caption = "Half the bend, twice the motion: the undamped step grows as one over the bend."
    if len(rows) > 1:
        caption = "The undamped step grows as one over the bend; the damped step stays small at every bend."
    return {"fig": fig, "alt": alt, "caption": caption}


def largest_rates(inverse_rate_matrix):
    """Return the largest rates of a wrist's angles for an angular velocity of one, over its middle angle.

    Parameters
    ----------
    inverse_rate_matrix : callable
        From the three angles, in radians, to the matrix (3, 3) that takes angular velocities to rates.

    Returns
    -------
    dict

    Examples
    --------
    >>> largest_rates(lambda b: np.eye(3) / np.sin(b[1]))["alt"][-78:]
    'all three together from 1 to 50 rad/s; largest single rate from 1 to 50 rad/s.'
    """
    b2 = np.linspace(0.02, np.pi - 0.02, 301)
    inverses = np.array([inverse_rate_matrix(np.array([0.4, x, 0.0])) for x in b2])
    together, single = np.linalg.norm(inverses, 2, axis=(1, 2)), np.linalg.norm(inverses, axis=2).max(1)
    rates = {"all three together": together, "largest single rate": single}
    axes = {"xlabel": r"$b_2$ (rad)", "ylabel": "rates for 1 rad/s (rad/s)"}
    fig = lines(b2, rates, log="y", parts_of_pi=4, **axes)
    said = "; ".join(f"{label} from {np.min(y):.2g} to {np.max(y):.0f} rad/s" for label, y in rates.items())
    alt = f"The largest rates for an angular velocity of one, over b2, on a logarithmic axis: {said}."
    middle = np.abs(b2 - np.pi / 4).argmin()
    caption = (
        r"Both grow without bound where $\sin b_2 = 0$: there the first and the third axis coincide. "
        rf"At $b_2 = \pi/4$ they are {single[middle]:.2f} (single) and {together[middle]:.2f} rad/s (together)."
    )
    return {"fig": fig, "alt": alt, "caption": caption}


def columns_and_ellipse(points, J, scale=0.3):
    """Return a planar arm, the columns of its Jacobian as arrows, and the manipulability ellipse.

    Parameters
    ----------
    points : array_like, shape (n + 1, 2)
        The arm, base first, in metres.
    J : array_like, shape (2, n)
        The Jacobian of the tip's position.
    scale : float, optional
        Metres drawn for one metre of J.

    Returns
    -------
    dict

    Examples
    --------
    >>> columns_and_ellipse(np.array([[0, 0], [1, 0], [2, 0]]), np.array([[0, 0], [2, 1]]))["alt"][:41]
    'A planar arm with its tip at (2.0, 0.0) m'
    """
    fig, (ax,) = plane_figure(6.0, 4.6)
    ax.plot(*points.T, "-o", color=GREY, linewidth=3, markersize=7)
    tip = points[-1]
    for j, (colour, column) in enumerate(zip(COLOURS, J.T, strict=False)):
        ax.annotate("", tip + scale * column, tip, arrowprops={"arrowstyle": "-|>", "color": colour, "linewidth": 2})
        ax.plot([], [], color=colour, linewidth=3, label=f"$J_{j + 1}$")
    U, s, _ = np.linalg.svd(J)
    t = np.linspace(0, 2 * np.pi, 121)
    ax.plot(*(tip[:, None] + scale * U @ (s[:, None] * [np.cos(t), np.sin(t)])), color=BLACK, linewidth=1.5)
    ax.set(aspect="equal", xlabel="x (m)", ylabel="y (m)")
    ax.margins(0.12)
    fig.legend(loc="outside upper center", ncols=J.shape[1], frameon=False)
    alt = (
        f"A planar arm with its tip at ({tip[0]:.1f}, {tip[1]:.1f}) m. From the tip, {J.shape[1]} arrows of length "
        + ", ".join(f"{length:.1f}" for length in np.linalg.norm(J, axis=0))
        + f" m show the Jacobian's columns; an ellipse with half axes of {s[0]:.1f} and {s[1]:.1f} m surrounds the tip."
    )
    caption = "Each column is perpendicular to the line from its joint to the tip; the tip is fast along the ellipse."
    return {"fig": fig, "alt": alt, "caption": caption}


def descents(runs, target, caption=""):
    """Return, for several runs towards one target, the tips' paths with the last configurations, and the errors.

    Parameters
    ----------
    runs : dict
        Label to arms, shape (n, links + 1, 2), one configuration a step, base first, in metres.
    target : array_like, shape (2,)
        In metres.
    caption : str, optional
        What to notice.

    Returns
    -------
    dict

    Examples
    --------
    >>> arm = np.array([[[0, 0], [1.0, 0]], [[0, 0], [0.8, 0.6]]])
    >>> descents({"run": arm}, [0.8, 0.6])["alt"][-41:]
    'run: ends less than a micrometre from it.'
    """
    fig, (plane, error) = plane_figure(9.6, 4.4, 2, width_ratios=[1, 1.1])
    said, corners, lowest = [], [np.zeros(2), np.asarray(target, float)], np.inf
    for i, (colour, (label, points)) in enumerate(zip(COLOURS, runs.items(), strict=False)):
        tips, style = points[:, -1], STYLES[i % 4]
        jumps = np.linalg.norm(np.diff(tips, axis=0), axis=1).max() > 1
        if jumps:  # lines between jumps would hide everything
            plane.plot(*tips.T, ".", color=colour, markersize=5, alpha=0.6)
        else:
            plane.plot(*tips.T, color=colour, linestyle=style, linewidth=2)
            plane.plot(*points[-1].T, "-o", color=colour, linewidth=5, markersize=7, markeredgecolor="white", alpha=0.5)
            corners.append(points[-1])
        corners.append(tips)
        miss = np.linalg.norm(tips - target, axis=-1)
        lowest = min(lowest, miss.min())
        error.plot(miss, color=colour, linestyle=style, linewidth=2, label=label.replace("alpha", r"$\alpha$"))
        said.append(f"{label}: {'jumps about and is' if jumps else 'ends'} {_metres(miss[-1])} from it")
    plane.plot(*target, "x", color=BLACK, markersize=11, markeredgewidth=2.5, zorder=5)
    corners = np.vstack([np.atleast_2d(c) for c in corners])
    low, high = corners.min(0) - 0.2, corners.max(0) + 0.2
    plane.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal", xlabel="x (m)", ylabel="y (m)")
    error.set(xlabel="steps", ylabel="distance from the target (m)")
    if lowest < error.get_ylim()[1] / 30:
        error.set(yscale="log", ylim=(max(lowest, 1e-9) / 2, None))
    if len(runs) > 1:
        columns = 1 if max(map(len, runs)) > 30 else len(runs)
        fig.legend(loc="outside upper center", ncols=columns, frameon=False)
    x, y = target
    alt = f"Paths of an arm's tip towards ({x:.1f}, {y:.1f}) m, and the distance over the steps. {'; '.join(said)}."
    return {"fig": fig, "alt": alt, "caption": caption or "The arm is drawn as it ends; the cross is the target."}


def race(racers, points_of, target, near=0.01):
    """Return the runs of several methods towards one target; the legend says how fast and how large their steps are.

    Parameters
    ----------
    racers : dict
        Label to joint angles, shape (steps + 1, joints), in radians.
    points_of : callable
        From joint angles to the arm's points, base first, shape (..., joints + 1, 2), in metres.
    target : array_like, shape (2,)
        In metres.
    near : float, optional
        The distance at which the target counts as reached, in metres.

    Returns
    -------
    dict

    Examples
    --------
    >>> path = np.array([[0.0], [0.5], [1.0]])
    >>> told = race({"one": path}, lambda q: np.stack([0 * q, q], -2) @ np.ones((1, 2)), [1.0, 1.0])["alt"]
    >>> "one: 2 steps to 1 cm, at most 0.5 rad: ends less than a micrometre from it" in told
    True
    """
    runs = {}
    for label, path in racers.items():
        miss = np.linalg.norm(points_of(path)[:, -1] - target, axis=-1)
        count, largest = np.argmax(miss < near), np.linalg.norm(np.diff(path, axis=0), axis=1).max()
        steps = f"{count} steps to {100 * near:g} cm" if (miss < near).any() else "never there"
        runs[f"{label}: {steps}, at most {largest:.3g} rad"] = points_of(path)
    return descents(runs, target, "Gauss-Newton jumps; the damped tip takes a smooth path.")


def _in_words(label):
    return label.replace("$", "").replace("\\epsilon", "epsilon")


def _metres(distance):
    return "less than a micrometre" if distance < 1e-6 else f"{distance:.2g} m"


def gains(epsilons, values):
    """Return the factor s/(s^2 + eps) of each damping over the singular value s, with its largest value marked.

    Parameters
    ----------
    epsilons : sequence of float
        Dampings, in square metres.
    values : dict
        Label to a singular value to point out, in metres.

    Returns
    -------
    dict

    Examples
    --------
    >>> gains([1.0], {"s1": 2.0})["alt"][-54:]
    'a largest value, 0.50 rad/m for 1 m², and falls again.'
    """
    s = np.linspace(0.01, 4.2, 300)
    fig, (ax,) = plane_figure(7.2, 3.6)
    ax.plot(s, 1 / s, color=BLACK, linewidth=1, label="no damping: $1/s$")
    for colour, style, eps in zip(COLOURS, STYLES, epsilons, strict=False):
        ax.plot(s, s / (s**2 + eps), color=colour, linestyle=style, linewidth=2, label=rf"$\epsilon$ = {eps:g} m$^2$")
        if np.sqrt(eps) < s[-1]:
            ax.plot(np.sqrt(eps), 1 / (2 * np.sqrt(eps)), "o", color=colour)
    for label, value in values.items():
        ax.axvline(value, color=GREY, linewidth=1)
        name = f"${label[0]}_{label[1:]}$"
        ax.annotate(name, (value, 2.05), xytext=(4, 0), textcoords="offset points", color=BLACK)
    ax.set(ylim=(0, 2.2), xlabel="singular value $s$ of the Jacobian (m)", ylabel="joint step per error (rad/m)")
    fig.legend(loc="outside upper center", ncols=4, frameon=False)
    tops = ", ".join(f"{1 / (2 * np.sqrt(eps)):.2f} rad/m for {eps:g} m²" for eps in epsilons)
    alt = (
        "The joint step per metre of error, over the singular value. Without damping it grows without bound towards "
        f"zero; with damping it rises from zero to a largest value, {tops}, and falls again."
    )
    caption = (
        r"Each curve is highest at $s = \sqrt\epsilon$; below it the damping cuts the step, above it it hardly acts."
    )
    return {"fig": fig, "alt": alt, "caption": caption}


def step_map(alphas, epsilons, errors, largest, runs):
    """Return the error after a run, for step sizes and dampings, with the limit 2 (1 + eps/s1^2).

    Parameters
    ----------
    alphas, epsilons : array_like, shape (n,) and (m,)
        Step sizes, and dampings in square metres.
    errors : array_like, shape (n, m)
        In metres.
    largest : float
        The largest singular value at the target, in metres.
    runs : sequence of (float, float)
        The pairs (alpha, eps) to mark.

    Returns
    -------
    dict

    Examples
    --------
    >>> errors = np.array([[1e-4, 1e-4], [0.5, 0.5]])
    >>> step_map([0.1, 9.0], [0.1, 1.0], errors, 2.0, [(0.1, 1.0)])["alt"][-19:]
    'Circles mark 1 run.'
    """
    fig, (ax,) = plane_figure(7.2, 4.6)
    levels = TwoSlopeNorm(-2, -8, 0.5)
    decades = np.log10(np.maximum(errors.T, 1e-9))
    image = ax.pcolormesh(alphas, epsilons, decades, cmap="RdBu_r", norm=levels, rasterized=True)
    limit = 2 * (1 + np.array(epsilons) / largest**2)
    ax.plot(limit, epsilons, color=BLACK, linewidth=2, label=r"$\alpha = 2(1 + \epsilon/s_1^2)$")
    ax.plot(*np.transpose(runs), "o", color=BLACK, markerfacecolor="white", markersize=8, label="the report's runs")
    ax.set(xscale="log", yscale="log", xlim=(alphas[0], alphas[-1]), ylim=(epsilons[0], epsilons[-1]))
    ax.set(xlabel=r"step size $\alpha$", ylabel=r"damping $\epsilon$ (m$^2$)")
    fig.legend(loc="outside upper center", ncols=2, frameon=False)
    bar = fig.colorbar(image, ax=ax, label="distance from the target (m)", ticks=[0, -2, -4, -6, -8])
    bar.ax.set_yticklabels(["1", "$10^{-2}$", "$10^{-4}$", "$10^{-6}$", "$10^{-8}$"])
    left = errors[np.asarray(alphas)[:, None] < limit] < 0.01
    right = errors[np.asarray(alphas)[:, None] > limit] < 0.01
    alt = (
        "A map of the distance after a run, over step size and damping, both logarithmic. Left of a black curve, the "
        f"limit of the step size, {100 * left.mean():.0f} % of it is blue, below a centimetre; right of it "
        f"{100 * right.mean():.0f} %. Circles mark {len(runs)} run{'s' * (len(runs) != 1)}."
    )
    caption = (
        "Blue runs converge. Right of the black curve the steps are too large; at the left and at the top they are too "
        "small."
    )
    return {"fig": fig, "alt": alt, "caption": caption}


def two_arms(paths, points_of, every=12):
    """Return arms side by side, drawn at evenly spaced instants of their joint paths.

    Parameters
    ----------
    paths : dict
        Damping, in square metres, to joint angles, shape (n, joints).
    points_of : callable
        From joint angles to the arm's points, base first, shape (..., joints + 1, 2).
    every : int, optional
        One arm is drawn for so many of 60 instants.

    Returns
    -------
    dict

    Examples
    --------
    >>> arms = {0.5: np.array([[0.0], [1.0]])}
    >>> two_arms(arms, lambda q: np.stack([0 * q, q], -2) @ np.ones((1, 2)))["alt"][-58:]
    'The last elbow bends at most by epsilon = 0.5 m²: 1.0 rad.'
    """
    paths, arms = {rf"$\epsilon$ = {eps:g} m²": path for eps, path in paths.items()}, {}
    for title, path in paths.items():
        gone = np.r_[0, np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))]
        shares = np.linspace(0, gone[-1], 61)
        arms[title] = points_of(np.array([np.interp(shares, gone, x) for x in np.transpose(path)]).T)
    fig = arm_paths(arms, every)
    corners = np.concatenate([np.reshape(a, (-1, 2)) for a in arms.values()])
    for ax in fig.axes:
        ax.set(
            xlim=(corners[:, 0].min() - 0.3, corners[:, 0].max() + 0.3),
            ylim=(corners[:, 1].min() - 0.3, corners[:, 1].max() + 0.3),
        )
    folds = ", ".join(f"{_in_words(title)}: {np.abs(path[:, -1]).max():.1f} rad" for title, path in paths.items())
    alt = f"Arms between the same start and target, later ones darker. The last elbow bends at most by {folds}."
    caption = "With much damping the tip swings out in a bow, and the joints move less."
    return {"fig": fig, "alt": alt, "caption": caption}


def manipulability_along(dampings, values):
    """Return the manipulability over the steps of runs with several dampings.

    Parameters
    ----------
    dampings : array_like, shape (m,)
        In square metres.
    values : array_like, shape (m, n)
        One row a damping, one value a step, in square metres.

    Returns
    -------
    dict

    Examples
    --------
    >>> manipulability_along([2.0], [[1.0, 2.0]])["alt"]
    'The manipulability (m²) over the steps. epsilon = 2 m²: 1.0 to 2.0.'
    """
    rows = {rf"$\epsilon$ = {eps:g} m²": np.asarray(row) for eps, row in zip(dampings, values, strict=True)}
    fig = lines(np.arange(np.shape(values)[1]), rows, xlabel="steps", ylabel="manipulability (m²)")
    said = "; ".join(f"{_in_words(label)}: {np.min(y):.1f} to {np.max(y):.1f}" for label, y in rows.items())
    caption = "With little damping the curve settles within a few steps; with much damping it changes slowly."
    return {"fig": fig, "alt": f"The manipulability (m²) over the steps. {said}.", "caption": caption}
