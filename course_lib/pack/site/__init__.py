"""The executed notebooks as a static site that opens from a folder with the network off."""

HOME = "home"  # the tag of the cell whose toy is on the home page


class SiteError(Exception):
    """Why the site cannot be built, in a sentence for the person who builds it."""


def heading_anchor(text: str) -> str:
    """Return the name by which JupyterLab lets other cells link to a heading."""
    return text.strip().replace(" ", "-")
