"""Late submissions: when each was due, when it was handed in, and how many points it loses.

Some platforms write the time of submission into the names of their exports, or into a list beside
them. The zips of others carry none: each file in them has the time of the export. Then times come
from a table, or from files that are said to keep them; without a time, the platform's own mark
counts.
"""

import math
import re
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path

from course_lib.pack.grade import GradingStopped
from course_lib.pack.grade.csv_text import count_noun, read_table, words
from course_lib.pack.grade.hand_ins.platforms import Platform, platforms
from course_lib.pack.grade.marks.graded_file import GradedFile

HOUR, DAY = 3600, 86_400
FILES = "files"  # TIMES=files: the files' own times are those of submission


@dataclass(frozen=True)
class Deadline:
    """When hand-ins are due, in seconds since 1970, and what a late one loses: percent of its
    points for each day.

    others: {(student, notebook): another deadline}. times: FILES; {(student, notebook): time of
    submission}; or {} if there are only the platform's marks. In both, "" stands for every student
    or notebook.
    """

    when: float
    percent: float = 0
    others: dict = field(default_factory=dict)
    times: str | dict = field(default_factory=dict)

    def time(self, file: GradedFile) -> float | None:
        """Return when a GradedFile was handed in, None if that is not known."""
        if self.times == FILES:
            return file.submission.modified
        by_platform = file.submission.modified if file.submission.timed else None
        return _entry(self.times, file, by_platform)

    def late(self, file: GradedFile) -> float | None:
        """Return how many seconds late a GradedFile is, by the clock of this machine's time zone;
        None if a mark of the platform is all that is known."""
        time = self.time(file)
        if time is not None:
            return _seconds_late(_entry(self.others, file, self.when), time)
        # The mark is about the platform's own deadline, so it says nothing of a student who has
        # another one here.
        marked = file.submission.late and not self.extended(file)
        return None if marked else 0.0

    def extended(self, file: GradedFile) -> bool:
        """Return whether the student of a GradedFile has a deadline of their own for it."""
        return any(
            self.others.keys() & {(name, file.notebook), (name, "")} for name in _names(file)
        )

    def share_left(self, late: float | None) -> float:
        """Return the share of its points that a file keeps, 0 to 1.

        late: as the method returns it.
        """
        return max(0.0, 1 - self.percent / 100 * begun_days(late))

    def __str__(self) -> str:
        moment = datetime.fromtimestamp(self.when).astimezone()
        when = f"{moment:%A, %d %B %Y, %H:%M:%S} {moment.tzname()} (UTC{moment:%z})"
        return f"Deadline: {when}, in this machine's time zone."


def _seconds_late(due: float, time: float) -> float:
    """Return how many seconds a time is after a deadline, as a clock shows it.

    So the same hour on the next day is one day later, also where clocks change in between and 23 or
    25 hours have passed.
    """
    if time <= due:
        return 0.0
    shown = datetime.fromtimestamp(time) - datetime.fromtimestamp(due)
    return shown.total_seconds() if shown.total_seconds() > 0 else time - due


def begun_days(late: float | None) -> int:
    """Return how many days late a file counts, each begun one; late: in seconds, or None, which
    counts as one day."""
    return 1 if late is None else math.ceil(late / DAY)


def _names(file: GradedFile) -> list[str]:
    """Return what a table may call the student of a GradedFile."""
    submission, who = file.submission, file.submission.who
    numbers = [submission.platform_id, who.id, who.number]
    logins = [words(who.login), words(who.address)]
    return [name for name in (*numbers, *logins, words(file.student)) if name]


def _entry(table: dict, file: GradedFile, default: float | None = None) -> float | None:
    keys = ((name, notebook) for name in (*_names(file), "") for notebook in (file.notebook, ""))
    return next((table[key] for key in keys if key in table), default)


def without_time(everything: Iterable[GradedFile], deadline: Deadline) -> list[GradedFile]:
    """Return the GradedFiles that count and whose time of submission nobody knows."""
    return [file for file in _counting(everything) if deadline.time(file) is None]


def _counting(everything: Iterable[GradedFile]) -> list[GradedFile]:
    return [file for file in everything if file.student and file.graded and not file.superseded_by]


def summary(everything: Sequence[GradedFile], deadline: Deadline) -> list[str]:
    """Return sentences on how many GradedFiles are late and by how much, and on what the tables
    leave open."""
    counting = _counting(everything)
    late = sorted(file.late for file in counting if file.late)
    sizes = Counter("an hour" if t <= HOUR else count_noun(begun_days(t), "day") for t in late)
    by = "".join(f", {number} by up to {size}" for size, number in sizes.items())
    marks = sum(file.late is None for file in counting)
    if marks:
        by += f", {marks} marked LATE by the platform"
    lines = [f"Late: {len(late) + marks} of {count_noun(len(counting), 'notebook')}{by}."]
    if marks:
        lines.append("A mark LATE counts as one day late, because no time is known.")
    unknown = without_time(everything, deadline)
    if deadline.times and unknown:
        some = ", ".join(sorted({file.student for file in unknown})[:5])
        lines.append(
            f"Without a time in TIMES=: {count_noun(len(unknown), 'notebook')}, for example of "
            f"{some}."
        )
    extended = [file for file in counting if deadline.extended(file)]
    if extended:
        lines.append(_about_extensions(extended, unknown))
    known = {name for file in everything for name in _names(file)}
    if strangers := sorted({name for name, _ in deadline.others} - known - {""}):
        lines.append(
            f"Nobody of this name, whom EXTENSIONS= names, handed in: {', '.join(strangers)}."
        )
    return lines


def _about_extensions(extended: list[GradedFile], unknown: list[GradedFile]) -> str:
    sentence = f"With an extension: {count_noun(len(extended), 'notebook')}."
    marked = {file.student for file in unknown if file.submission.late and file in extended}
    if not marked:
        return sentence
    names = ", ".join(sorted(marked))
    return f"{sentence} Their marks LATE do not count, because no time is known: {names}."


# ---- what was typed ----


def read_deadline(when: str, rule: str, extensions: str = "", times: str = "") -> Deadline | None:
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
    others = _table(Path(extensions), "deadline", _due) if extensions else {}
    if times != FILES:
        times = _times(times)
    return Deadline(moment, _percent(rule), others, times)


def _percent(rule: str) -> float:
    """Return the percent of a rule for late files."""
    if rule in ("", "none"):
        return 0.0
    typed = re.fullmatch(r"(\d+(?:\.\d+)?)\s*%?(?:\s*(?:a|per) day)?", rule.strip())
    if not typed or float(typed[1]) > 100:
        raise GradingStopped(
            f"LATE={rule} is neither none nor a number of percent a day from 0 to 100."
        )
    return float(typed[1])


def _times(typed: str) -> dict:
    """Return {(student, notebook): time} of a table, or of all in a folder."""
    if not typed:
        return {}
    paths = sorted(Path(typed).glob("*.csv")) if Path(typed).is_dir() else [Path(typed)]
    times = {}
    for path in paths:
        times |= _table(path, "time", _time)
    return times


def _due(typed: str) -> float | None:
    """Return a deadline in seconds since 1970, or None if the text is not a time.

    A date alone stands for the end of its day.
    """
    date_only = re.fullmatch(r"\s*[\d-]{8,10}\s*", typed)
    return _time(f"{typed.strip()} 23:59:59" if date_only else typed)


def _time(typed: str) -> float | None:
    """Return a time in ISO 8601, or as a platform writes it, in seconds since 1970, or None."""
    text = " ".join(typed.split())
    try:
        return datetime.fromisoformat(text).timestamp()
    except (ValueError, OverflowError, OSError):
        times = (platform.read_time(text) for platform in platforms().values())
        return next((time for time in times if time is not None), None)


def _table(path: Path, column: str, read: Callable[[str], float | None]) -> dict:
    """Return {(student, notebook): time} of a table with this column, or of times that a platform
    exports."""
    exporters = [platform for platform in platforms().values() if platform.time_columns]
    known = {"student", "notebook", column}
    for platform in exporters:
        known |= {*platform.time_columns}
    times = {}
    for row in read_table(path, known):
        exporter = None
        columns = ("student", column)
        if not row.keys() >= {*columns}:
            exporter = _exporter(row, exporters)
            if exporter is None:
                raise GradingStopped(_unknown_columns(path, column, exporters))
            columns = exporter.time_columns
        student, typed = (row[name].strip() for name in columns)
        if typed in ("", "-"):  # in a platform's table: nothing was handed in
            continue
        time = read(typed)
        if time is None:
            raise GradingStopped(
                f"{path}: {typed}, for {student or 'all'}, is not a time: write 2026-11-30 18:00."
            )
        name = words(exporter.read_student(student) if exporter else student)
        times[name, row.get("notebook", "").strip()] = time
    return times


def _exporter(row: dict, exporters: Sequence[Platform]) -> Platform | None:
    """Return the platform whose table of times has such rows."""
    return next(
        (platform for platform in exporters if row.keys() >= {*platform.time_columns}), None
    )


def _unknown_columns(path: Path, column: str, exporters: Sequence[Platform]) -> str:
    """Return what to say about a table of times whose columns nobody knows."""
    tables = [
        f"`{platform.time_columns[0]}` and `{platform.time_columns[1]}` ({platform.title})"
        for platform in exporters
    ]
    return (
        f"{path} has neither the columns `student` and `{column}` nor those of a learning "
        f"platform's table of times, in English: {', '.join(tables)}."
    )
