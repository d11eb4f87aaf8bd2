"""Late submissions: how many days late a file is, and how many points it loses."""

import math
import re
from dataclasses import dataclass
from datetime import datetime

from course_lib.pack.grade import GradingStopped

DAY = 86_400


@dataclass(frozen=True)
class Deadline:
    """The deadline in seconds since 1970, and the percentage of its points that a late file loses for each day."""

    when: float
    percent: float = 0

    def days_late(self, modified):
        """Return how many days after the deadline a file was last modified; each begun day counts."""
        return 0 if modified is None or modified <= self.when else math.ceil((modified - self.when) / DAY)

    def share_left(self, days):
        """Return the share of its points that a file keeps, 0 to 1."""
        return max(0.0, 1 - self.percent / 100 * days)


def read_deadline(when, rule):
    """Return the Deadline that was typed, or None if none was.

    when: a date, or a date and a time, of this machine's time zone unless it names another; "" for no deadline.
    rule: what a late file loses: "none", or percent of its points for each begun day: "10", "10%", "10% a day".
    """
    if not when:
        if rule not in ("", "none"):
            raise GradingStopped(f"LATE={rule} has no meaning without DEADLINE=.")
        return None
    try:
        moment = datetime.fromisoformat(when)
        if len(when) <= 10:  # a date alone: its whole day counts
            moment = moment.replace(hour=23, minute=59, second=59)
        seconds = moment.timestamp()
    except (ValueError, OverflowError, OSError):
        raise GradingStopped(f"DEADLINE={when} is not a date: write 2026-11-30 or '2026-11-30 18:00'.") from None
    typed = re.fullmatch(r"(\d+(?:\.\d+)?)\s*%?(?:\s*(?:a|per) day)?", rule.strip())
    if rule not in ("", "none") and (not typed or float(typed[1]) > 100):
        raise GradingStopped(f"LATE={rule} is neither none nor a number of percent a day from 0 to 100.")
    return Deadline(seconds, float(typed[1]) if typed else 0.0)
