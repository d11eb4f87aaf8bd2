"""How many seconds of processor each file of tests takes, with the programs that it starts.

The clock on the wall says little on a busy machine. What a test waits for costs nobody anything.
"""

import os
from collections import Counter

import psutil


def _of_descendants():
    """Return the seconds of all programs that run below this process."""
    seconds = 0.0
    for process in psutil.Process().children(recursive=True):
        try:
            seconds += sum(process.cpu_times()[:4])  # its own, and of the programs that it awaited
        except psutil.Error:
            continue  # which has just ended
    return seconds


def used():
    """Return the seconds of processor of this process and of all that it has started so far."""
    return sum(os.times()[:4]) + _of_descendants()


class Stopwatch:
    """The seconds of each file that this process runs, from its first test to the end of its last.

    Programs are looked for only between files, because that takes some milliseconds.
    """

    def __init__(self):
        self.seconds = Counter()
        self._file, self._began = None, 0.0

    def before(self, item):
        """Begin a file with its first test."""
        if self._file != item.path:
            self._file, self._began = item.path, used()

    def after(self, item, following):
        """End a file when its last test has ended."""
        if following is None or following.path != item.path:
            self.seconds[item.path.name] += max(0.0, used() - self._began)
            self._file = None


def table(seconds, rows=10):
    """Return lines on all files together and on the slowest ones: seconds and names."""
    whole = f"{seconds.total():8.1f} s  all {len(seconds)} files"
    return [whole, *(f"{value:8.1f} s  {name}" for name, value in seconds.most_common(rows))]
