"""The release to students, which `make student` writes.

It holds notebooks without solutions, and all that they need to run.
"""

PROMPT = "*Type your answer here.*"  # stands where a written answer goes


class ReleaseError(Exception):
    """Why no release can be written, in a sentence for the person who writes it."""
