"""What conf.py names: kept apart from the modules that draw, so that Sphinx does not load matplotlib."""

LIVING = ("motion", "scene", "toys", "panda")  # the home page's scripts, of course_lib/figures/scripts, in order


def heading_anchor(text: str) -> str:
    """Return the name by which JupyterLab lets other cells link to a heading.

    Examples
    --------
    >>> heading_anchor("Run it yourself")
    'Run-it-yourself'
    """
    return text.strip().replace(" ", "-")
