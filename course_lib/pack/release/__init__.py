"""The release to students: notebooks without solutions, and what it takes to work in them. ``make student``."""


class ReleaseError(Exception):
    """Why no release can be written, in a sentence for the person who writes it."""
