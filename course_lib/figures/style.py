"""One style for all pictures: colours that colour-blind readers distinguish, dark on white.

The background is opaque and white, in JupyterLab's dark theme too. A stored picture is one file for
both themes, and these inks cannot be read on both grounds: on a dark one black letters have a
contrast of 1.2 and crimson one of 2.8, and inks that are lighter are too pale on white. The pages
know their theme: there plots exchange light and dark, and pictures of robots are dimmed. The dark
theme of JupyterLab shows plots and charts as cards with a margin and round corners
(scripts/toys/style.js).

All colours of matplotlib's and plotly's pictures stand here, and those of solid bodies in
`course_lib.figures.solids.model`.
"""

# Okabe and Ito's palette, the yellow left out: it is too pale for lines on white.
BLUE = "#0072B2"
ORANGE = "#E69F00"
GREEN = "#009E73"
PURPLE = "#CC79A7"
SKY = "#56B4E9"
RED = "#D55E00"
BLACK = "#222222"
FRAME_COLOURS = (RED, GREEN, BLUE)  # of the x, y and z axis of a frame
COLOURS = (BLUE, RED, GREEN, PURPLE, ORANGE, SKY, BLACK)
GREY = "#8a8a8a"
GRID_GREY = "#dddddd"  # of the grid behind a plot
PALE_GREY = "#c4c8cd"  # of what is behind
SPHERE_GREY = "#e8e8e8"  # of a sphere that carries dots
LINK_BLUE = "#c9d3dc"  # of the links of an arm in a drawing
CRIMSON = "#b2182b"  # of moving things: no shade of orange, and about as dark as the blue
# Fills inside outlines: of the vacuum robot, of the moving body, and of the table.
PALE_BLUE = "#cfe0ec"
PALE_CRIMSON = "#f0b7bd"
TABLE_BEIGE = "#e4e0d8"

# A phone shows a picture 358 pixels wide. Letters of 10 points, 13.3 pixels, are 10.8 pixels high
# there if a panel is at most so many inches wide.
MAX_PANEL_WIDTH = 4.6
_POINTS_OF_POWERS = 12  # the exponent of 10 in a tick is smaller than its 10 by 0.7


def plane_figure(width, height, columns=1, rows=1, **options):
    """Return a matplotlib figure in the course's style, and its axes, row by row.

    Parameters
    ----------
    width, height : float
        Of the figure, in inches. The width of a panel is at most `MAX_PANEL_WIDTH`.
    columns, rows : int, optional
        How many panels stand beside each other and below each other.
    **options
        Passed to `matplotlib.figure.Figure.subplots`, such as ``sharey=True``.

    Returns
    -------
    fig : matplotlib.figure.Figure
    axes : ndarray of matplotlib.axes.Axes, shape (rows * columns,)

    Raises
    ------
    ValueError
        If a panel would be so wide that a phone shows its letters too small.

    Examples
    --------
    >>> fig, axes = plane_figure(8, 4, columns=2)
    >>> axes.shape
    (2,)
    """
    # Imported here, because it takes half a second, for which a notebook's first check would wait.
    from matplotlib.figure import Figure

    if width > MAX_PANEL_WIDTH * columns:
        raise ValueError(
            f"width must be at most {MAX_PANEL_WIDTH} inches for each of the {columns} columns, so "
            f"that letters are readable on a phone; it is {width:g}"
        )
    fig = Figure(figsize=(width, height), layout="constrained", facecolor="white")
    axes = fig.subplots(rows, columns, squeeze=False, **options).ravel()
    for ax in axes:
        ax.set_prop_cycle(color=COLOURS)
        ax.grid(color=GRID_GREY, linewidth=0.6)
        ax.set_axisbelow(True)
        ax.spines[["top", "right"]].set_visible(False)
    return fig, axes


def enlarge_powers(axis):
    """Enlarge the ticks of a logarithmic axis, so that a phone shows their exponents readably.

    Parameters
    ----------
    axis : matplotlib.axis.Axis
    """
    axis.set_tick_params(labelsize=_POINTS_OF_POWERS)
