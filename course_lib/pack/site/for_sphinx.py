"""What Sphinx's settings name that needs no figures: Sphinx would load matplotlib with the rest, for nothing."""

LIVING = ("motion", "kinematics", "toys", "panda")  # the home page's scripts, of course_lib/figures/scripts, in order


def heading_anchor(text: str) -> str:
    """Return the name by which JupyterLab lets other cells link to a heading."""
    return text.strip().replace(" ", "-")
