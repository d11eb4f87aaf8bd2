"""One style for all pictures: colours that colour-blind readers distinguish, dark on white.

The background is opaque. All colours of matplotlib's and plotly's pictures stand here, and those of
solid bodies in `course_lib.figures.solids.model`.
"""

from matplotlib.figure import Figure

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


def plane_figure(width, height, columns=1, rows=1, **options):
    """Return a matplotlib figure in the course's style, and its axes, row by row.

    Parameters
    ----------
    width, height : float
        Of the figure, in inches.
    columns, rows : int, optional
        How many panels stand beside each other and below each other.
    **options
        Passed to `matplotlib.figure.Figure.subplots`, such as ``sharey=True``.

    Returns
    -------
    fig : matplotlib.figure.Figure
    axes : ndarray of matplotlib.axes.Axes, shape (rows * columns,)

    Examples
    --------
    >>> fig, axes = plane_figure(8, 4, columns=2)
    >>> axes.shape
    (2,)
    """
    fig = Figure(figsize=(width, height), layout="constrained", facecolor="white")
    axes = fig.subplots(rows, columns, squeeze=False, **options).ravel()
    for ax in axes:
        ax.set_prop_cycle(color=COLOURS)
        ax.grid(color=GRID_GREY, linewidth=0.6)
        ax.set_axisbelow(True)
        ax.spines[["top", "right"]].set_visible(False)
    return fig, axes
