"""Late submissions: when each was due, when it was handed in, and how many points it loses.

The zips of Canvas and Moodle carry no times of submission: each file in them has the time of the
export (instructure/canvas-lms, lib/content_zipper.rb, add_attachment_to_zip; moodle/moodle,
files/classes/local/archive_writer/zip_writer.php). So times come from a table, or from files that
are said to keep them; without a time, Canvas's mark LATE counts.
"""

import math
import re
from collections import Counter
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path

from course_lib.pack.grade import GradingStopped
from course_lib.pack.grade.csv_text import count_noun, read_table, words

HOUR, DAY = 3600, 86_400
FILES = "files"  # TIMES=files: the files' own times are those of submission
# The columns of Moodle's grading worksheet (mod/assign/gradingtable.php), and its times in British
# and American English (strftimedaydatetime in lang/en/langconfig.php).
MOODLE = ("Identifier", "Last modified (submission)")
MOODLE_TIMES = ("%A, %d %B %Y, %I:%M %p", "%A, %B %d, %Y, %I:%M %p")


@dataclass(frozen=True)
class Deadline:
    """When hand-ins are due, in seconds since 1970, and what a late one loses: percent of its points for each day.

    others: {(student, notebook): another deadline}. times: FILES; {(student, notebook): time of
    submission}; or {} if there are only the platform's marks. In both, "" stands for every student
    or notebook.
    """

    when: float
    percent: float = 0
    others: dict = field(default_factory=dict)
    times: str | dict = field(default_factory=dict)

    def time(self, each):
        """Return when a GradedFile was handed in, None if that is not known."""
        return each.submission.modified if self.times == FILES else _entry(self.times, each)

    def late(self, each):
        """Return how many seconds late a GradedFile is; None if a mark of the platform is all that is known."""
        if (time := self.time(each)) is not None:
            return max(0.0, time - _entry(self.others, each, self.when))
        # The mark is about the platform's own deadline, so it says nothing of a student who has
        # another one here.
        return None if each.submission.late and not self.extended(each) else 0.0

    def extended(self, each):
        """Return whether the student of a GradedFile has a deadline of their own for it."""
        return any(
            self.others.keys() & {(name, each.notebook), (name, "")} for name in _names(each)
        )

    def share_left(self, late):
        """Return the share of its points that a file keeps, 0 to 1.

        late: as the method returns it.
        """
        return max(0.0, 1 - self.percent / 100 * begun_days(late))

    def __str__(self):
        moment = datetime.fromtimestamp(self.when).astimezone()
        when = f"{moment:%A, %d %B %Y, %H:%M:%S} {moment.tzname()} (UTC{moment:%z})"
        return f"Deadline: {when}, in this machine's time zone."


def begun_days(late):
    """Return how many days late a file counts, each begun one; late: in seconds, or None, which counts as one day."""
    return 1 if late is None else math.ceil(late / DAY)


def _names(each):
    """Return what a table may call the student of a GradedFile."""
    numbers = [each.submission.platform_id, each.submission.user_id]
    return [name for name in (*numbers, words(each.student)) if name]


def _entry(table, each, default=None):
    found = ((name, notebook) for name in (*_names(each), "") for notebook in (each.notebook, ""))
    return next((table[key] for key in found if key in table), default)


def summary(everything, deadline):
    """Return sentences on how many GradedFiles are late and by how much, and on what the tables leave open."""
    counting = [
        each for each in everything if each.student and each.graded and not each.superseded_by
    ]
    late = sorted(each.late for each in counting if each.late)
    sizes = Counter("an hour" if t <= HOUR else count_noun(begun_days(t), "day") for t in late)
    by = "".join(f", {number} by up to {size}" for size, number in sizes.items())
    lines = [f"Late: {len(late)} of {count_noun(len(counting), 'notebook')}{by}."]
    if marks := sum(each.late is None for each in counting):
        lines.append(
            f"Marked LATE by the platform: {marks}, which count as one day late, because no time "
            f"is known."
        )
    unknown = [each for each in counting if deadline.time(each) is None]
    if deadline.times and unknown:
        some = ", ".join(sorted({each.student for each in unknown})[:5])
        lines.append(
            f"Without a time in TIMES=: {count_noun(len(unknown), 'notebook')}, for example of "
            f"{some}."
        )
    if extended := [each for each in counting if deadline.extended(each)]:
        marks = sorted(
            {each.student for each in unknown if each.submission.late and each in extended}
        )
        but = (
            f" Their marks LATE do not count, because no time is known: {', '.join(marks)}."
            if marks
            else ""
        )
        lines.append(f"With an extension: {count_noun(len(extended), 'notebook')}.{but}")
    known = {name for each in everything for name in _names(each)}
    if strangers := sorted({name for name, _ in deadline.others} - known - {""}):
        lines.append(
            f"Nobody of this name, whom EXTENSIONS= names, handed in: {', '.join(strangers)}."
        )
    return lines


# ---- what was typed ----


def read_deadline(when, rule, extensions="", times=""):
    """Return the Deadline that was typed, or None if none was.

    when: a date, or a date and a time, of this machine's time zone unless it names another; "" for
    no deadline. rule: what a late file loses: "none", or percent of its points for each begun day:
    "10", "10%", "10% a day". extensions: a table of other deadlines. times: FILES, or a table of
    times of submission, or a folder of such tables.
    """
    if not when:
        for name, typed in {"LATE": rule, "EXTENSIONS": extensions, "TIMES": times}.items():
            if typed not in ("", "none"):
                raise GradingStopped(f"{name}={typed} has no meaning without DEADLINE=.")
        return None
    moment = _due(when)
    if moment is None:
        raise GradingStopped(
            f"DEADLINE={when} is not a date: write 2026-11-30 or '2026-11-30 18:00'."
        )
    typed = re.fullmatch(r"(\d+(?:\.\d+)?)\s*%?(?:\s*(?:a|per) day)?", rule.strip())
    if rule not in ("", "none") and (not typed or float(typed[1]) > 100):
        raise GradingStopped(
            f"LATE={rule} is neither none nor a number of percent a day from 0 to 100."
        )
    others = _table(Path(extensions), "deadline", _due) if extensions else {}
    if times != FILES:
        paths = (
            sorted(Path(times).glob("*.csv"))
            if Path(times).is_dir()
            else [Path(times)]
            if times
            else []
        )
        times = {key: time for path in paths for key, time in _table(path, "time", _time).items()}
    return Deadline(moment, float(typed[1]) if typed else 0.0, others, times)


def _due(typed):
    """Return a deadline in seconds since 1970, None if it is none.

    A date alone stands for the end of its day.
    """
    return _time(
        f"{typed.strip()} 23:59:59" if re.fullmatch(r"\s*[\d-]{8,10}\s*", typed) else typed
    )


def _time(typed):
    """Return a time in ISO 8601, or as Moodle writes it, in seconds since 1970; None if it is none."""
    text = " ".join(typed.split())
    for read in (
        datetime.fromisoformat,
        *(lambda t, form=form: datetime.strptime(t, form) for form in MOODLE_TIMES),
    ):
        try:
            return read(text).timestamp()
        except (ValueError, OverflowError, OSError):
            continue
    return None


def _table(path, column, read):
    """Return {(student, notebook): time} of a table with this column, or of Moodle's grading worksheet."""
    found = {}
    for row in read_table(path, {"student", "notebook", column, *MOODLE}):
        columns = next(
            (names for names in (("student", column), MOODLE) if set(names) <= row.keys()), None
        )
        if columns is None:
            raise GradingStopped(
                f"{path} has neither the columns `student` and `{column}` nor `{MOODLE[0]}` and "
                f"`{MOODLE[1]}`, which "
                "Moodle's grading worksheet has in English."
            )
        student, typed = (row[name].strip() for name in columns)
        if typed in ("", "-"):  # in a worksheet: nothing was handed in
            continue
        if (time := read(typed)) is None:
            raise GradingStopped(
                f"{path}: {typed}, for {student or 'all'}, is not a time: write 2026-11-30 18:00."
            )
        name = re.sub(r".*\D", "", student) if columns == MOODLE else words(student)
        found[name, row.get("notebook", "").strip()] = time
    return found
