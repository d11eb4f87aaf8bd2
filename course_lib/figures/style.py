"""One look for all pictures: colours that colour-blind eyes tell apart, dark on an opaque white ground."""

from matplotlib.figure import Figure

# Okabe and Ito's palette, the yellow left out: it is too pale for lines on white.
BLUE, ORANGE, GREEN, PURPLE, SKY, RED, BLACK = (
    "#0072B2",
    "#E69F00",
    "#009E73",
    "#CC79A7",
    "#56B4E9",
    "#D55E00",
    "#222222",
)
COLOURS = (BLUE, RED, GREEN, PURPLE, ORANGE, SKY, BLACK)
GREY = "#8a8a8a"

PLOTLY_LAYOUT = {
    "template": None,
    "paper_bgcolor": "white",
    "plot_bgcolor": "white",
    "font": {"color": BLACK, "size": 13},
    "margin": {"l": 10, "r": 10, "t": 40, "b": 10},
}


def plane_figure(width, height, columns=1, **options):
    """Return a matplotlib figure and its axes in one row, of the given size in inches, in the course's look."""
    fig = Figure(figsize=(width, height), layout="constrained", facecolor="white")
    axes = fig.subplots(1, columns, squeeze=False, **options)[0]
    for ax in axes:
        ax.set_prop_cycle(color=COLOURS)
        ax.grid(color="#dddddd", linewidth=0.6)
        ax.set_axisbelow(True)
        ax.spines[["top", "right"]].set_visible(False)
    return fig, axes


def space_layout(names, camera, half=1.3, height=420):
    """Return the plotly layout of 3D scenes side by side, each the cube from -half to half, with a title each.

    names: titles. camera: the direction the eye looks from; it stands far enough off to crop nothing.
    height: pixels.
    """
    hidden = {"range": [-half, half], "visible": False}  # the pictures draw the axes they need
    scenes, titles, width = {}, [], 1 / len(names)
    distance = 1.75 / sum(c * c for c in camera) ** 0.5
    for i, name in enumerate(names):
        scenes[scene_name(i)] = {
            **{f"{c}axis": hidden for c in "xyz"},
            "aspectmode": "cube",
            "domain": {"x": [i * width, (i + 1) * width], "y": [0, 1]},
            "camera": {"eye": {c: distance * value for c, value in zip("xyz", camera, strict=True)}},
        }
        place = {
            "x": (i + 0.5) * width,
            "y": 1,
            "xanchor": "center",
            "yanchor": "bottom",
            "xref": "paper",
            "yref": "paper",
        }
        titles.append({"text": name, "showarrow": False, **place})
    return {**PLOTLY_LAYOUT, **scenes, "annotations": titles, "height": height, "showlegend": False}


def scene_name(i):
    """Return plotly's name of the i-th scene, counted from 0."""
    return f"scene{i + 1}" if i else "scene"
