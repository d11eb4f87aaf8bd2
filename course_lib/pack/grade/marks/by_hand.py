"""What remains for the instructor after a run: one list, with the command that comes after each
entry."""

import shlex
from collections import Counter, defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from course_lib.pack.grade.csv_text import count_noun, words
from course_lib.pack.grade.hand_ins.notebook_file import NOT_CODE
from course_lib.pack.grade.hand_ins.platforms import Platform, named
from course_lib.pack.grade.hand_ins.roster import KEYS, Row
from course_lib.pack.grade.marks.deadline import Deadline, without_time
from course_lib.pack.grade.marks.gradebook import absent
from course_lib.pack.grade.marks.graded_file import GradedFile
from course_lib.pack.grade.marks.marks_table import MarkedAnswer
from course_lib.pack.grade.marks.tables import Totals

MAX_SHOWN = 10  # lines of one entry on the terminal; the page of the class has all
# Settings that change how a class is graded and no point of it; the seed is kept beside the grades.
OF_ONE_RUN = ("JOBS", "CLUSTER", "SEED")
# Not quoted, so that a shell refuses the command until a folder stands there: another folder would
# get another seed and none of the marks.
FOLDER_OF_THE_PAGE = "<the folder of this page>"


@dataclass(frozen=True)
class Entry:
    """One thing to do.

    task: what, in sentences. about: a line for each student or file that it concerns. command: what
    to run afterwards.
    """

    task: str
    about: tuple[str, ...] = ()
    command: str = ""


@dataclass(frozen=True)
class GradedClass:
    """What a run gave, and by which settings.

    output: the folder that is written. shown: how its name stands before the files in it.
    everything: GradedFiles. listed: (student, notebook, MarkedAnswer) of each written answer.
    settings: {name of make's setting: what was typed}.
    gradebook: the platform that gets the points; one without a name if none does. missing: students
    who are not in its file. nearest: {such a student: names in the roster}. shared: students who
    share a line of it.
    """

    output: Path
    shown: Path
    everything: Sequence[GradedFile]
    listed: Sequence[tuple[str, str, MarkedAnswer]]
    totals: Totals
    settings: dict[str, str]
    deadline: Deadline | None = None
    roster: Sequence[Row] | None = None
    gradebook: Platform = field(default_factory=Platform)
    missing: Sequence[str] = ()
    nearest: dict[str, list[str]] = field(default_factory=dict)
    shared: Sequence[Sequence[str]] = ()

    def on_the_page(self) -> "GradedClass":
        """Return the same as the page of the class has it: in equal bytes, wherever it was
        graded."""
        settings = {name: v for name, v in self.settings.items() if name not in OF_ONE_RUN}
        if "OUTPUT" in settings:
            settings["OUTPUT"] = FOLDER_OF_THE_PAGE
        return replace(self, shown=Path(), settings=settings)

    def command(self, **changed: str) -> str:
        """Return the command of this run, with other settings where they are given."""
        settings = {name: value for name, value in (self.settings | changed).items() if value}
        typed = {
            name: value if value == FOLDER_OF_THE_PAGE else shlex.quote(value)
            for name, value in settings.items()
        }
        return " ".join(["make grade", *(f"{name}={value}" for name, value in typed.items())])


def remaining(graded_class: GradedClass) -> list[Entry]:
    """Return what the instructor has to do by hand, in the order in which it is best done."""
    return [
        *_files(graded_class),
        *_owners(graded_class),
        *_cells(graded_class),
        *_releases(graded_class),
        *_times(graded_class),
        *_pictures(graded_class),
        *_marks(graded_class),
        *_gradebook(graded_class),
    ]


def text(entries: Sequence[Entry]) -> str:
    """Return the list as it stands on the terminal."""
    if not entries:
        return "Nothing is left to be done by hand."
    lines = ["By hand, still:"]
    for number, entry in enumerate(entries, 1):
        lines.append(f"{number}. {entry.task}")
        lines += [f"     {line}" for line in entry.about[:MAX_SHOWN]]
        if len(entry.about) > MAX_SHOWN:
            left = len(entry.about) - MAX_SHOWN
            lines.append(f"     ... and {left} more, which class.html lists.")
        if entry.command:
            lines.append(f"   Then: {entry.command}")
    return "\n".join(lines)


# ---- files, and whose they are ----


def _files(graded_class: GradedClass) -> Iterable[Entry]:
    troubled = [
        file
        for file in graded_class.everything
        if file.unreadable or file.result.get("state") == "refused"
    ]
    if troubled:
        about = _places_with_reasons(troubled)
        yield Entry(
            f"{count_noun(len(about), 'file')} could not be graded: correct the place or the "
            "name, or ask the student for another file.",
            about,
            graded_class.command(),
        )
    failed = [file for file in graded_class.everything if file.result.get("state") == "not graded"]
    if failed:
        about = _places_with_reasons(failed)
        yield Entry(
            f"The grader failed on {count_noun(len(about), 'file')}: the same command tries again.",
            about,
            graded_class.command(),
        )


def _places_with_reasons(files: Iterable[GradedFile]) -> tuple[str, ...]:
    """Return a line for each file; a group's file is one, though each member has it."""
    lines = (f"{file.submission.place}: {file.result['problems'][0]}" for file in files)
    return tuple(dict.fromkeys(lines))


def _owners(graded_class: GradedClass) -> Iterable[Entry]:
    remarks = [
        f"{file.submission.place}: {file.submission.remark}"
        for file in graded_class.everything
        if file.submission.remark
    ]
    if remarks:
        about = tuple(dict.fromkeys(remarks))
        yield Entry("Say whose these are by their names.", about, graded_class.command())
    names = defaultdict(list)
    for student in graded_class.totals.students:
        names[words(student)].append(student)
    alike = [several for name, several in sorted(names.items()) if name and len(several) > 1]
    if alike:
        yield Entry(
            "These names differ only in capitals, accents or the order of their words, and are "
            "taken for different students. If they are one, give the files one name.",
            tuple("; ".join(several) for several in alike),
            graded_class.command(),
        )


def _cells(graded_class: GradedClass) -> Iterable[Entry]:
    lost = [
        f"{file.student}, {file.notebook}: {problem}"
        for file in graded_class.everything
        if file.graded and not file.superseded_by
        for problem in file.result["problems"]
        if NOT_CODE in problem
    ]
    if lost:
        yield Entry(
            "Answers stand in cells that are not of code, so they were not run and earn nothing. "
            "If you accept them, set the cells to Code in JupyterLab.",
            tuple(lost),
            graded_class.command(),
        )


def _pictures(graded_class: GradedClass) -> Iterable[Entry]:
    """Yield what to do about written answers that refer to a picture, pasted or in a file."""
    shown = [
        f"{file.submission.place}: {answer.question}"
        for file in graded_class.everything
        for answer in file.answers
        if answer.points is None and ("![" in answer.text or "<img" in answer.text.lower())
    ]
    if shown:
        yield Entry(
            "These written answers hold pictures, which questions.csv cannot show. Look at them in "
            "the notebooks before you type the marks.",
            tuple(dict.fromkeys(shown)),  # the file of a group is one, though each member has it
            graded_class.command(),
        )


def _releases(graded_class: GradedClass) -> Iterable[Entry]:
    graded = [file for file in graded_class.everything if file.graded and not file.unreadable]
    counts = Counter(file.result["release"] for file in graded)
    if len(counts) < 2:
        return
    most = max(counts, key=lambda name: (bool(name), counts[name]))
    others = [file for file in graded if file.result["release"] != most]
    yield Entry(
        f"The notebooks are not all of one release: {counts[most]} of {len(graded)} are of "
        f"{most}, those below of another or of none. All are graded by the tasks of this version: "
        "compare the tasks that have changed since. No release is named if another program saved "
        "the file, or if it is from the instructors' folder.",
        tuple(
            f"{file.student or file.submission.place}: {file.notebook}, "
            f"{'release ' + file.result['release'] if file.result['release'] else 'no release'}"
            for file in others
        ),
        graded_class.command(),
    )


# ---- times and marks ----


def _times(graded_class: GradedClass) -> Iterable[Entry]:
    if not graded_class.deadline:
        return
    unknown = without_time(graded_class.everything, graded_class.deadline)
    named_table = graded_class.settings.get("TIMES")
    columns = "with the columns student, notebook and time"
    if named_table:
        # It may be a folder of tables already, or a platform's own export.
        write_it = (
            f"Write it into a table of your own, {columns}. TIMES= may name a folder with several "
            f"tables: put {named_table} and yours into one."
        )
    else:
        write_it = f"Write it into times.csv, a table {columns}."
    table = named_table or "times.csv"
    if not graded_class.deadline.times and named(graded_class.settings.get("LMS", "")).marks_late:
        # What the platform did not mark was in time, so nothing is to be done about it.
        unknown = [file for file in unknown if file.submission.late]
        count = count_noun(len(unknown), "notebook")
        task = (
            f"How late {count} marked LATE came is not known. {write_it} Until then each counts "
            "as one day late, and not at all for a student who has an extension."
        )
    else:
        count = count_noun(len(unknown), "notebook")
        task = (
            f"The time of submission of {count} is not known. {write_it} Until then a mark LATE "
            "counts as one day, and no mark as in time."
        )
    if unknown:
        about = (
            f"{file.student}: {file.notebook}{', marked LATE' if file.submission.late else ''}"
            for file in unknown
        )
        yield Entry(task, tuple(about), graded_class.command(TIMES=table))


def _marks(graded_class: GradedClass) -> Iterable[Entry]:
    table = graded_class.shown / "questions.csv"
    page = graded_class.shown / "questions.html"
    waiting = Counter(
        notebook for _, notebook, answer in graded_class.listed if answer.points is None
    )
    if waiting:
        yield Entry(
            f"{count_noun(waiting.total(), 'written answer')} to be read: open {page}, give points "
            f"by keys and replace {table} with the table that it saves, or type marks into that "
            "table. The rubric and a model answer stand beside each.",
            tuple(f"{notebook}: {count}" for notebook, count in sorted(waiting.items())),
            graded_class.command(),
        )
    wrong = [
        f"{student}: {notebook}, {answer.question}: {answer.wrong}"
        for student, notebook, answer in graded_class.listed
        if answer.wrong
    ]
    if wrong:
        yield Entry(
            f"{count_noun(len(wrong), 'invalid mark')} in {table}: the column `state` says why.",
            tuple(wrong),
            graded_class.command(),
        )


# ---- the gradebook ----


def _gradebook(graded_class: GradedClass) -> Iterable[Entry]:
    if graded_class.roster:
        missing = absent(graded_class.totals, graded_class.roster)
        if missing:
            yield Entry(
                f"{count_noun(len(missing), 'student')} of the roster handed in nothing: ask them, "
                "and put later files into the same folder.",
                tuple(_perhaps_known(name, graded_class.nearest) for name in missing),
                graded_class.command(),
            )
    name = graded_class.gradebook.name
    if not name:
        return
    path = graded_class.shown / f"{name}.csv"
    if graded_class.missing:
        yield Entry(*_missing(graded_class, path))
    if unknown := _known_by_name_alone(graded_class):
        platform = graded_class.gradebook.title
        yield Entry(
            f"{path} has the names of {count_noun(len(unknown), 'student')} in place of a login or "
            f"address, because the files say nothing else of them. If {platform} knows these "
            "students by something else, give its roster.",
            (),
            graded_class.command(ROSTER="roster.csv"),
        )
    for students in graded_class.shared:
        yield Entry(
            "One student of the roster, whose better points of each notebook count: "
            f"{', '.join(students)}. Rename the files of one if they are two.",
            (),
            graded_class.command(),
        )
    first = " Try it in a copy of the course first." if graded_class.gradebook.takes_tables else ""
    yield Entry(f"The points are in {path}. {graded_class.gradebook.imports}{first}")
    if (graded_class.output / "feedback" / name).is_dir():
        zips = graded_class.shown / "feedback" / name
        yield Entry(f"Upload the zips in {zips} as feedback files, one for each notebook.")


def _known_by_name_alone(graded_class: GradedClass) -> list[str]:
    """Return the students in the gradebook's file of whom neither a roster nor the files say what
    the platform knows them by."""
    if graded_class.roster or not graded_class.gradebook.takes_tables:
        return []
    identities = graded_class.totals.identities
    students = graded_class.totals.students
    return [name for name in students if not identities.get(name, {}).keys() & set(KEYS)]


def _perhaps_known(name: str, nearest: dict[str, list[str]]) -> str:
    """Return a name of the roster, with those who handed in and whose name it may be.

    nearest: {who handed in and has no line in the roster: the names in the roster that are near}.
    """
    perhaps = [student for student, names in nearest.items() if name in names]
    if not perhaps:
        return name
    return f"{name}, unless this is {' or '.join(perhaps)}, who has no line in the roster"


def _missing(graded_class: GradedClass, path: Path) -> tuple[str, tuple[str, ...], str]:
    """Return the entry about students who are not in the gradebook's file."""
    shown = list(graded_class.missing[:MAX_SHOWN])
    if len(graded_class.missing) > MAX_SHOWN:
        shown.append(f"... and {len(graded_class.missing) - MAX_SHOWN} more")
    task = (
        f"Not in {path}, because no line of the roster fits, or several: {', '.join(shown)}. "
        "Write each name into the column `student` of the right line."
    )
    about = tuple(
        f"{student}: {'nearest in the roster: ' + '; '.join(names) if names else 'no near name'}"
        for student, names in graded_class.nearest.items()
    )
    return (
        task,
        about,
        graded_class.command(ROSTER=graded_class.settings.get("ROSTER") or "roster.csv"),
    )
