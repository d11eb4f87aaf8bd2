"""Keep matplotlib's messages about its own folders out of notebooks.

Where the home folder cannot be written, matplotlib makes a temporary one for its list of fonts and
says so on stderr; where it looks for fonts for more than five seconds, it says that, too. Below a
student's first cell such a message looks like an error, and nbval compares it with the stored
output. This module is imported before matplotlib.
"""

import logging

ABOUT_THE_MACHINE = (
    "mkdir -p failed for path",
    "is not a writable directory",
    "created a temporary cache directory",
    "is building the font cache",
)


def concerns_the_reader(record):
    """Return whether a message of matplotlib says something of the figure, not of the machine."""
    message = record.getMessage()
    return not any(words in message for words in ABOUT_THE_MACHINE)


for logger in ("matplotlib", "matplotlib.font_manager"):
    logging.getLogger(logger).addFilter(concerns_the_reader)
