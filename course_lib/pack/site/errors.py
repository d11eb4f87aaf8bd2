"""The one exception of this package."""


class SiteError(Exception):
    """Why the site cannot be built, in a sentence for the person who builds it."""
