"""One style for all pictures: colours that colour-blind readers distinguish, dark on an opaque white background."""

from matplotlib.figure import Figure

# Okabe and Ito's palette, the yellow left out: it is too pale for lines on white.
BLUE, ORANGE, GREEN, PURPLE = "#0072B2", "#E69F00", "#009E73", "#CC79A7"
SKY, RED, BLACK = "#56B4E9", "#D55E00", "#222222"
FRAME_COLOURS = (RED, GREEN, BLUE)  # of the x, y and z axis of a frame
COLOURS = (BLUE, RED, GREEN, PURPLE, ORANGE, SKY, BLACK)
GREY = "#8a8a8a"
CRIMSON = "#b2182b"  # of moving things: no shade of orange, and about as dark as the blue


def plane_figure(width, height, columns=1, rows=1, **options):
    """Return a matplotlib figure in the course's style, and its axes (rows * columns,), row by row.

    width, height: of the figure, in inches. options: passed to `matplotlib.figure.Figure.subplots`,
    such as sharey=True.
    """
    fig = Figure(figsize=(width, height), layout="constrained", facecolor="white")
    axes = fig.subplots(rows, columns, squeeze=False, **options).ravel()
    for ax in axes:
        ax.set_prop_cycle(color=COLOURS)
        ax.grid(color="#dddddd", linewidth=0.6)
        ax.set_axisbelow(True)
        ax.spines[["top", "right"]].set_visible(False)
    return fig, axes
