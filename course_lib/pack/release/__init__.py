"""The release to students: notebooks without solutions, and all that they need to run.

``make student``.
"""

PROMPT = "*Type your answer here.*"  # stands where a written answer goes


class ReleaseError(Exception):
    """Why no release can be written, in a sentence for the person who writes it."""
