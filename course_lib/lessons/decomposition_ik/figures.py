"""The figures of notebook 6: the 2R arm, samples in cells, clusters, errors over the plane, costs.

Each function returns a Picture, for `show`. Positions are in metres, errors in centimetres.
"""

import re

import numpy as np

from course_lib.figures import charts
from course_lib.figures.digits import fixed, rounded, rounded_array
from course_lib.figures.display import Picture
from course_lib.figures.plots import in_metres
from course_lib.figures.style import BLACK, BLUE, COLOURS, CRIMSON, PALE_GREY, RED, plane_figure
from course_lib.figures.toys.toy import Toy

_ANSWERS = ("the better answer", "the worse answer")
EDGE_IS_NEAR = 36.0  # degrees: with such a bend the tip is 10 cm from the outer edge
LEAST_ERROR = 1e-3  # cm: a tenth of the thickness of paper; smaller errors have its colour
ERROR_COLOURS = "Viridis_r"  # dark for a large error, which stands out on a white ground
EXACT = 0.01  # cm: a tip that is nearer than that to the desired position is at it


def two_elbows(solutions, xy, sent=None):
    """Return the 2R arm at two pairs of joint angles, and the desired position.

    Parameters
    ----------
    solutions : array_like, shape (2, 2)
        Joint angles, in radians, a row for each elbow, q2 >= 0 first.
    xy : array_like, shape (2,)
        The desired position, in metres.
    sent : array_like, shape (2, 2), optional
        The joint angles that were sent, if the arm took other ones. The arm at these is drawn pale,
        and an inset shows by how much the tips miss.

    Returns
    -------
    Picture
    """
    fig, (ax,) = plane_figure(4.4, 4.2)
    looks = ((BLUE, "-", r"$q_2 \geq 0$"), (RED, "--", r"$q_2 \leq 0$"))
    elbows = []
    tips = []
    for q, (colour, style, name) in zip(solutions, looks, strict=True):
        joints = _joints(q)
        ax.plot(*joints.T, style, color=colour, linewidth=3, marker="o", label=name)
        elbows.append(f"({fixed(joints[1, 0], 2)}, {fixed(joints[1, 1], 2)})")
        tips.append(joints[2])
    distances = [100 * np.linalg.norm(tip - xy) for tip in tips]
    for q in [] if sent is None else sent:
        ax.plot(*_joints(q).T, color=PALE_GREY, linewidth=3, zorder=1)
    # Hollow, so that a tip near it remains visible.
    hollow = {"markerfacecolor": "none", "markeredgewidth": 1.8, "markersize": 13}
    ax.plot(*xy, "D", color=BLACK, linestyle="", label="desired position", **hollow)
    ax.plot(0, 0, "s", color=BLACK, markersize=10)
    in_metres(ax)
    ax.margins(0.12)
    if sent is None:
        ax.legend(frameon=False)
    else:
        ax.plot([], [], color=PALE_GREY, linewidth=3, label="as sent")
        # Below the arm, because the inset takes the room within it.
        ax.legend(frameon=False, loc="upper left", bbox_to_anchor=(0, -0.16), ncols=2)
        _enlarge_misses(ax, tips, xy, distances)
    alt = (
        f"An arm with two links twice, its elbows at {' and '.join(elbows)} m, and the desired "
        f"position ({xy[0]:g}, {xy[1]:g}) m."
    )
    if max(distances) < EXACT:
        alt += " Both tips are there; the two form a rhombus."
        bend = np.rad2deg(abs(solutions[0][1]))
        caption = (
            f"Both elbows lead to the same position, ({xy[0]:g}, {xy[1]:g}) m. Each is bent by "
            f"{fixed(bend, 1)}°, one to each side."
        )
        return Picture(fig, alt, caption)
    caption = (
        f"Neither tip is at the desired position: they miss it by {fixed(distances[0], 1)} and "
        f"{fixed(distances[1], 1)} cm."
    )
    alt += " Neither tip is there."
    if sent is not None:
        caption += " The arm sags: the angles that were sent would bring both tips there, pale."
        alt += " Pale, the arm at the angles that were sent, which reaches it."
    return Picture(fig, alt, caption)


def _joints(q):
    """Return the base, the elbow and the tip (3, 2) of the 2R arm at joint angles (2,)."""
    angles = np.cumsum(q)
    links = np.stack([np.cos(angles), np.sin(angles)], -1)
    return np.cumsum([np.zeros(2), *links], 0)


def _enlarge_misses(ax, tips, xy, distances):
    """Draw the neighbourhood of the desired position enlarged, with the distances of both tips."""
    inset = ax.inset_axes([0.28, 0.25, 0.43, 0.43])
    farthest = tips[int(np.argmax(distances))]
    middle = (xy + farthest) / 2
    half = 0.9 * max(distances) / 100
    for tip, distance, colour, side in zip(tips, distances, (BLUE, RED), (1, -1), strict=True):
        inset.plot(*np.transpose([xy, tip]), color=colour, linewidth=3)
        inset.plot(*tip, "o", color=colour, markersize=9)
        # On one side of the longer line and on the other side of the shorter one, beyond its end.
        along = (tip - xy) / np.linalg.norm(tip - xy)
        beside = middle if tip is farthest else tip
        place = beside + side * 0.45 * half * np.array([-along[1], along[0]])
        words = f"{fixed(distance, 1)} cm"
        inset.annotate(words, place, color=colour, ha="center", va="center", weight="bold")
    inset.plot(*xy, "D", color=BLACK, markersize=13, markerfacecolor="none", markeredgewidth=1.8)
    window = half * np.array([-1, 1])
    inset.set(xlim=middle[0] + window, ylim=middle[1] + window, xticks=[], yticks=[])
    ax.indicate_inset_zoom(inset, edgecolor=BLACK)


def samples(xy, cell, low, high, n):
    """Return all samples in the workspace, coloured by their cells; neighbours differ.

    Zoom shows each cell, and the cell under the pointer says how many samples it holds.

    Parameters
    ----------
    xy : ndarray, shape (m, 2)
        Positions, in metres.
    cell : ndarray of int, shape (m, 2)
        Column and row of each.
    low, high : array_like, shape (2,)
        The corners of the grid, in metres.
    n : int
        The number of cells along each side.

    Returns
    -------
    Picture
    """
    number = cell[:, 0] + n * cell[:, 1]
    count = np.bincount(number, minlength=n * n)
    fig = charts.panels(xlabel="x (m)", ylabel="y (m)", equal=True, height=560)
    colours = [COLOURS[k] for k in (cell[:, 0] + 3 * cell[:, 1]) % len(COLOURS)]
    # Millimetres are fine enough for any zoom, and make the notebook shorter.
    charts.add_points(fig, *rounded_array(xy, 3).T, "sample", colour=colours, size=3)
    _count_under_the_pointer(fig, count.reshape(n, n), low, high)
    for lines_of, first, last in (("x", low[0], high[0]), ("y", low[1], high[1])):
        edges = first + np.arange(n + 1) * (last - first) / n
        fig.update_layout({f"{lines_of}axis": {"range": [first, last], "showgrid": False}})
        fig.update_layout({f"{lines_of}axis.minor": {"tickvals": edges, "showgrid": True}})
    radius = np.hypot(*xy.T)
    counts = count[count > 0]
    alt = (
        f"{len(xy):,} positions: a band between the radii {fixed(radius.min(), 2)} and "
        f"{fixed(radius.max(), 2)} m, from ({fixed(low[0], 1)}, {fixed(low[1], 1)}) to "
        f"({fixed(high[0], 1)}, "
        f"{fixed(high[1], 1)}) m, each in the colour of its cell. The cells that hold samples hold "
        f"{counts.min()} to {counts.max()} of them."
    )
    caption = (
        "The samples are denser near the outer edge, which cuts many cells. Zoom in to see single "
        "cells, and point at a cell to read how many samples it holds."
    )
    return Picture(fig, alt, caption)


def _count_under_the_pointer(fig, count, low, high):
    """Let the cell under the pointer say how many samples it holds.

    An invisible map of the cells does it: the same words for each of 50,000 dots would be half of
    the chart.
    """
    rows, columns = count.shape
    middles = [
        first + (np.arange(cells) + 0.5) * (last - first) / cells
        for first, last, cells in zip(low, high, (columns, rows), strict=True)
    ]
    where = np.stack(np.meshgrid(np.arange(columns), np.arange(rows)), -1)
    fig.update_traces(hoverinfo="skip", hovertemplate=None)
    fig.add_heatmap(
        x=rounded_array(middles[0], 4),
        y=rounded_array(middles[1], 4),
        z=np.where(count > 0, count.astype(float), np.nan),
        customdata=where.tolist(),
        colorscale=[[0, "rgba(0,0,0,0)"], [1, "rgba(0,0,0,0)"]],
        showscale=False,
        showlegend=False,
        name="cell",
        hovertemplate=(
            "cell (%{customdata[0]}, %{customdata[1]})<br>%{z:,} samples<extra></extra>"
        ),
    )


def clusters(contents):
    """Return the samples of a few cells in joint space, a panel for each cell.

    Parameters
    ----------
    contents : dict
        Title of a cell to its samples' joint angles, shape (m, 2), in radians, and their labels,
        shape (m,), which are 0 or 1. `cells.kinds` returns such a dict.

    Returns
    -------
    Picture
    """
    titles = [title.replace("q2", "q<sub>2</sub>") for title in contents]
    fig = charts.panels(
        titles,
        xlabel="q<sub>1</sub> (degrees)",
        ylabel="q<sub>2</sub> (degrees)",
        height=400,
    )
    ranges = []
    for panel, (title, (q, label)) in enumerate(contents.items()):
        in_words = []
        for k, symbol, colour in ((0, "circle", BLUE), (1, "triangle-up", RED)):
            group = np.rad2deg(q[label == k])
            name = f"cluster {k}"
            charts.add_points(
                fig, *group.T, name, panel=panel, colour=colour, symbol=symbol, opacity=0.8
            )
            in_words.append(f"{fixed(group[:, 1].min(), 0)} to {fixed(group[:, 1].max(), 0)}")
        charts.add_rule(fig, y=0.0, panel=panel)
        ranges.append(f"{title}: q2 from {' and '.join(in_words)} degrees in the two clusters")
    alt = (
        f"Joint angles of {len(contents)} cells, q2 over q1, with two clusters each. "
        f"{'; '.join(ranges)}."
    )
    caption = "Compare each cut with the dashed line $q_2 = 0$, which separates the elbows."
    return Picture(fig, alt, caption)


def two_cells(q, xy, in_joints, in_plane):
    """Return samples in joint space and where they lead.

    One cell of each space is marked in both.

    Parameters
    ----------
    q, xy : array_like, shape (m, 2)
        Joint angles, in radians, and positions, in metres.
    in_joints, in_plane : array_like of bool, shape (m,)
        Whether a sample lies in the cell of joint space, and in the cell of the workspace.

    Returns
    -------
    Picture
    """
    degrees = rounded_array(np.rad2deg(q), 1)
    xy = rounded_array(xy, 3)
    fig = charts.panels(
        ["joint angles", "positions"],
        xlabel=["q<sub>1</sub> (degrees)", "x (m)"],
        ylabel=["q<sub>2</sub> (degrees)", "y (m)"],
        height=420,
    )
    fig.layout.yaxis2.update(scaleanchor="x2", constrain="domain")
    fig.layout.xaxis2.constrain = "domain"
    groups = (
        ("other samples", np.arange(len(q)) % 25 == 0, PALE_GREY, 2),
        ("a cell of joint space", in_joints, BLUE, 4),
        ("a cell of the workspace", in_plane, CRIMSON, 4),
    )
    for name, inside, colour, size in groups:
        dots = {"colour": colour, "size": size}
        angles = {
            "q<sub>1</sub> (degrees)": degrees[inside, 0],
            "q<sub>2</sub> (degrees)": degrees[inside, 1],
        }
        positions = {"x (m)": xy[inside, 0], "y (m)": xy[inside, 1]}
        # Beside its own coordinates each dot says where it is in the other panel.
        charts.add_points(fig, *degrees[inside].T, name, panel=0, details=positions, **dots)
        charts.add_points(fig, *xy[inside].T, name, panel=1, details=angles, **dots)
    q2 = degrees[in_plane, 1]
    ranges = [
        f"{fixed(part.min(), 0)} to {fixed(part.max(), 0)}" for part in (q2[q2 > 0], q2[q2 <= 0])
    ]
    alt = (
        "Left, joint angles; right, their positions. A blue rectangle of joint angles leads to "
        "one patch of positions; a red rectangle of positions is reached from two patches of "
        f"joint angles, with q2 from {' and '.join(ranges)} degrees."
    )
    caption = (
        "In how many patches does the blue cell appear on the other side, and in how many the red "
        "one? Point at a dot to see where it is on the other side."
    )
    return Picture(fig, alt, caption)


def errors(contents, caption, details=None):
    """Return errors at positions in the plane, by size and colour, with the largest one named.

    Parameters
    ----------
    contents : dict
        Title of a panel to positions, shape (m, 2), in metres, and their errors, shape (m,), in
        centimetres; NaN where there is no answer.
    caption : str
        What to notice.
    details : dict, optional
        Title of a panel to what its dots say besides: {"cell": values, shape (m,)}.

    Returns
    -------
    Picture
    """
    fig = charts.panels(
        list(contents),
        xlabel="x (m)",
        ylabel="y (m)",
        columns=1,
        equal=True,
        height=90 + 330 * len(contents),
    )
    # What is drawn and how it is sorted follow from rounded errors, so that two errors that differ
    # in the last bits only keep their places on every machine.
    contents = {title: (xy, rounded_array(error, 5)) for title, (xy, error) in contents.items()}
    largest = max(np.nanmax(error) for _, error in contents.values())
    scale = charts.ColourScale(
        "error (cm)", low=LEAST_ERROR, high=largest, log=True, colours=ERROR_COLOURS
    )
    in_words = []
    for panel, (title, (xy, error)) in enumerate(contents.items()):
        answered = ~np.isnan(error)
        position = xy[answered]
        size = np.maximum(error[answered], LEAST_ERROR)
        # The large errors are drawn last, above the others, and equal ones in the order given.
        order = np.argsort(size, kind="stable")
        # The pointer shows the error itself, also of a dot that is drawn as if it were larger.
        own_details = {"error (cm)": error} | (details or {}).get(title, {})
        charts.add_points(
            fig,
            *position[order].T,
            title,
            panel=panel,
            size=4 + 14 * np.sqrt(size[order] / largest),
            values=size[order],
            scale=scale,
            opacity=0.85,
            details={name: values[answered][order] for name, values in own_details.items()},
        )
        worst = int(np.argmax(size))
        x, y = position[worst]
        _name_largest(fig, panel, (x, y), f"largest: {fixed(size[worst], 1)} cm")
        in_words.append(
            f"{title}: half below {np.median(size):.2g}, the largest {fixed(size[worst], 1)} at "
            f"({fixed(x, 1)}, {fixed(y, 1)}) m"
        )
    fig.layout.showlegend = False  # the titles of the panels name the series
    alt = f"Errors in cm at positions in the plane, by size and colour. {'; '.join(in_words)}."
    return Picture(fig, alt, caption)


def errors_of_arm(xy, angles, errors, cells, caption):
    """Return a toy: queries with the errors of two answers, and the arm at the answers to one.

    A click chooses a query.

    Parameters
    ----------
    xy : ndarray, shape (m, 2)
        Positions that were asked for, in metres.
    angles : ndarray, shape (m, 2, 2)
        Two answers to each, in radians; NaN where there is none.
    errors : ndarray, shape (m, 2)
        Their errors, in centimetres; NaN where there is no answer.
    cells : array_like, shape (m,)
        The number of each query's cell.
    caption : str
        What to try, and what is seen.

    Returns
    -------
    Toy
    """
    xy = np.asarray(xy, float)
    order = np.argsort(np.where(np.isnan(errors), np.inf, errors), axis=1, kind="stable")
    angles = np.take_along_axis(np.asarray(angles, float), order[..., None], axis=1)
    errors = np.take_along_axis(np.asarray(errors, float), order, axis=1)
    in_words = []
    for name, column in zip(_ANSWERS, errors.T, strict=True):
        worst = int(np.nanargmax(column))
        x, y = xy[worst]
        in_words.append(
            f"{name}: half below {np.nanmedian(column):.2g}, the largest {fixed(column[worst], 1)} "
            f"at ({fixed(x, 1)}, {fixed(y, 1)}) m"
        )
    alt = (
        "Errors in cm at positions in the plane, by size and colour, of two answers to each query. "
        f"{_capital('; '.join(in_words))}. The planar arm is drawn at the answers to the query "
        "that is chosen by a click or a slider."
    )
    low, high = xy.min(0), xy.max(0)
    centre = (np.minimum(low, 0) + np.maximum(high, 0)) / 2
    model = {
        "lengths": [1.0, 1.0],
        "queries": rounded_array(xy, 3).tolist(),
        "angles": [_with_gaps(rounded_array(column, 3)) for column in angles.swapaxes(0, 1)],
        "errors": [[rounded(float(error), 2) for error in column] for column in errors.T],
        "cells": [int(cell) for cell in cells],
        "names": list(_ANSWERS),
        "half": round(0.6 * float(max(np.maximum(high, 0) - np.minimum(low, 0))), 2),
        "centre": rounded_array(centre, 2).tolist(),
    }
    return Toy("errors", model, alt, caption=caption)


def _with_gaps(rows):
    """Return rows as JSON, with None for those that hold NaN."""
    return [None if np.isnan(row).any() else row.tolist() for row in rows]


def _capital(words):
    return words[0].upper() + words[1:]


def _name_largest(fig, panel, position, text):
    """Write a text beside a dot of a panel, with a line from the text to the dot."""
    x_axis, y_axis = fig.layout.meta["panels"][panel]
    fig.add_annotation(
        x=position[0],
        y=position[1],
        xref=x_axis,
        yref=y_axis,
        text=text,
        # Towards the middle of the panel, so that the words stay inside it.
        ax=-75 if position[0] > 0 else 75,
        ay=-30 if position[1] < 0 else 30,
        arrowhead=0,
        arrowcolor=BLACK,
        bgcolor="rgba(255,255,255,0.8)",
        font={"color": BLACK, "size": 12},
    )


def convergence(sizes, curves, slopes):
    """Return the largest error of the position in a cell over the width of the cell.

    Parameters
    ----------
    sizes : array_like, shape (n,)
        Widths of the cell, in metres.
    curves : dict
        Name of a model and place to the largest errors, shape (n,), in metres.
    slopes : dict
        Name to the slope of its curve on logarithmic axes.

    Returns
    -------
    Picture
    """
    in_words = []
    by_name = {}
    for name, largest in curves.items():
        in_words.append(
            f"{name} falls with slope {fixed(slopes[name], 1)} to {100 * largest[-1]:.1g}"
        )
        # Three digits: the further ones of the smallest errors are those of rounding.
        by_name[f"{name}: slope {fixed(slopes[name], 1)}"] = [
            _three_digits(100 * e) for e in largest
        ]
    fig = charts.lines(
        100 * sizes,
        by_name,
        xlabel="width of the cell (cm)",
        ylabel="largest error (cm)",
        log="xy",
        markers=True,
        height=430,
    )
    alt = (
        "The largest error of the position in a cell, in cm, over the width of the cell, both "
        f"logarithmic: {'; '.join(in_words)}."
    )
    caption = "At the workspace's edge the degree of the polynomial does not change the slope."
    return Picture(fig, alt, caption)


def _three_digits(number):
    return float(f"{number:.3g}")


def by_bend(edges, mean):
    """Return the mean error over the bend |q2| of the elbow.

    A dashed line marks the bend at which the workspace's edge is the diagonal of a cell away.

    Parameters
    ----------
    edges : array_like, shape (n + 1,)
        Of the intervals of |q2|, in degrees.
    mean : array_like, shape (n,)
        The mean error in each interval, in centimetres.

    Returns
    -------
    Picture
    """
    fig, (ax,) = plane_figure(4.4, 3.0)
    ax.bar(edges[:-1], mean, np.diff(edges), align="edge", color=BLUE, edgecolor="white")
    ax.axvline(EDGE_IS_NEAR, color=BLACK, linestyle="--", linewidth=1.2)
    ax.annotate(
        f"{fixed(EDGE_IS_NEAR, 0)}°",
        (EDGE_IS_NEAR, 0.97 * max(mean)),
        (4, 0),
        textcoords="offset points",
    )
    ax.set(xlabel="$|q_2|$ (degrees)", ylabel="mean error (cm)", xlim=(0, edges[-1]))
    top = int(np.argmax(mean))
    alt = (
        f"Mean error over |q2|: {fixed(mean[0], 2)} cm for a stretched arm, largest, "
        f"{fixed(mean[top], 2)} "
        f"cm, between {edges[top]} and {edges[top + 1]} degrees, and {fixed(mean[-1], 2)} cm near "
        f"{edges[-1]} degrees."
    )
    caption = (
        f"Left of the dashed line ({fixed(EDGE_IS_NEAR, 0)} degrees) the tip is less than 10 cm, "
        f"the diagonal of a cell, from the outer edge of the workspace."
    )
    return Picture(fig, alt, caption)


def costs(memory, error):
    """Return the mean error of methods over the memory that they need, both logarithmic.

    Parameters
    ----------
    memory : dict
        Name of a method to its bytes.
    error : dict
        Name to its mean error, in centimetres.

    Returns
    -------
    Picture
    """
    fig = charts.panels(
        xlabel="memory (bytes)",
        ylabel="mean error of both branches (cm)",
        log="xy",
        height=470,
    )
    symbols = ("circle", "square", "diamond", "triangle-up", "triangle-down", "cross", "star")
    for number, (name, size) in enumerate(memory.items()):
        # Open marks of different sizes: where two coincide, both are seen.
        charts.add_points(
            fig,
            [float(size)],
            [_three_digits(error[name])],
            re.sub(r"\bq(\d)", r"q<sub>\1</sub>", name),
            symbol=f"{symbols[number % len(symbols)]}-open",
            size=11 + 2 * (number % len(symbols)),
        )
    # The pointer shows the numbers as the text and the table write them.
    fig.update_traces(
        marker_line_width=3,
        hovertemplate="%{fullData.name}<br>memory: %{x:,} bytes<br>mean error: %{y:.2~g} cm"
        "<extra></extra>",
    )
    in_words = [f"{name}: {size:,} bytes, {error[name]:.2g} cm" for name, size in memory.items()]
    alt = f"Mean error of both branches over memory, both logarithmic. {'; '.join(in_words)}."
    caption = (
        "Two fitted numbers make the error more than ten times smaller, and the best tables of the "
        "samples make it more than ten times smaller again."
    )
    return Picture(fig, alt, caption)


def samples_as_reported(xy, cell):
    """Return the report's first two charts: the positions of the samples, and those by cell.

    They are drawn as plotly draws them. The second one has a colour for each cell that is drawn at
    random.

    Parameters
    ----------
    xy : array_like, shape (m, 2)
        Positions, in metres; the charts show centimetres, as the report does.
    cell : array_like of int, shape (m, 2)
        Column and row of each.

    Returns
    -------
    Picture
    """
    column, row = cell.T
    number = column * (row.max() + 1) + row
    colours = np.random.default_rng(0).choice(COLOURS, number.max() + 1)
    fig, axes = plane_figure(8.8, 3.8, columns=2, sharey=True)
    for ax, colour in zip(axes, (BLUE, colours[number]), strict=True):
        # Six pixels in plotly are 4.5 points.
        ax.scatter(*(100 * xy).T, s=4.5**2, c=colour, linewidths=0, rasterized=True)
        ax.set(aspect="equal", xlabel="x (cm)")
    axes[0].set_ylabel("y (cm)")
    radius = 100 * np.hypot(*xy.T)
    alt = (
        f"{len(xy):,} positions as overlapping dots of 6 pixels in a half ring from radius "
        f"{fixed(radius.min(), 0)} to {fixed(radius.max(), 0)} cm, twice. At the right the dots of "
        f"each of {len(np.unique(number))} cells have one colour, and cells that touch may by "
        f"chance have the same."
    )
    caption = (
        "This is the report's first chart, of the samples (left), in which dots of this size hide "
        "how dense they are. This is the report's second chart, of the samples by cell (right), "
        "with colours that are drawn at random, as the report intended."
    )
    return Picture(fig, alt, caption)


def errors_as_reported(xy, error):
    """Return the third of the report's charts: markers of error + 5 pixels.

    Its colours run from light to dark, as in `errors`, and in the report the other way.

    Parameters
    ----------
    xy : array_like, shape (m, 2)
        Positions of the queries, in metres.
    error : array_like, shape (m,)
        Their errors, in centimetres.

    Returns
    -------
    Picture
    """
    fig = charts.panels(xlabel="x (cm)", ylabel="y (cm)", equal=True, height=430)
    error = rounded_array(error, 5)
    scale = charts.ColourScale("error (cm)", low=0.0, colours=ERROR_COLOURS)
    position = rounded_array(100 * xy, 1)
    charts.add_points(fig, *position.T, "query", size=error + 5, values=error, scale=scale)
    small = (error < 1).mean()
    alt = (
        f"{len(xy):,} queries as dots whose diameter in pixels is the error in cm plus 5, in the "
        f"colours of a bar from 0 to {fixed(error.max(), 1)} cm; {small:.0%} of them are below 1 "
        f"cm and look alike."
    )
    caption = (
        "This is the report's third chart, with the colour bar that the report leaves out and with "
        "its colours reversed, so that a dark dot is a large error here too. Because the diameter "
        "is the error in cm plus 5 pixels, all differences below a centimetre are hidden."
    )
    return Picture(fig, alt, caption)
