"""Find the submissions in a folder: whose each is, of which notebook, and why it is refused if it
is.

One student's files (nested, linked, unreadable, vanishing) must not stop the grading of the others:
any exception that they cause becomes that student's line. What may be the work of several students
is refused with a question, which the instructor answers before anything is graded.
"""

import collections
import itertools
import os
import stat
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from course_lib.pack.grade.csv_text import listing, printable
from course_lib.pack.grade.hand_ins import zips
from course_lib.pack.grade.hand_ins.holders import EACH_ENTRY, LOGIN, Holder, holders_in
from course_lib.pack.grade.hand_ins.identity import NOBODY, Doubt, Identity, Relation, tell_apart
from course_lib.pack.grade.hand_ins.names import initials, kind_of_file, split, unknown_ending
from course_lib.pack.grade.hand_ins.owners import owners
from course_lib.pack.grade.hand_ins.platforms import HandIn, Platform, named, platforms
from course_lib.pack.grade.hand_ins.platforms.base import (
    ADDED,
    READ,
    ending_of,
    is_clutter,
    is_folder,
    plain_name,
    stem_of,
)
from course_lib.pack.grade.hand_ins.roster import Roster
from course_lib.pack.grade.hand_ins.zips import Refused

MAX_BYTES = 100_000_000  # of one file; a notebook with all its animations has about ten million
MAX_DEPTH = 20  # folders in folders, of one student
MAX_ENTRIES = 20_000  # files and folders of one student that are looked at
MAX_GRADED = 60  # notebooks of one student that are graded; there are six
MAX_UNASKED = 20  # notebooks and links of one student that are taken for one student's
MAX_LISTED = 200  # notebooks and links of one student that get a line of their own
LINK = "It is a link to another file, and links are not followed."
CLASS = "It looks like a learning platform's export of a class:"


@dataclass(frozen=True)
class Submission:
    """A file that was handed in. A text that does not apply is "".

    student: whose it is. notebook: the course's name for it if the file's name contains one, else
    the file's own. place: the path below the folder of submissions, for messages and hashes.
    member: the file's name in the zip at `path`. refused: why it is not graded. modified: seconds
    since 1970, by the platform if `timed`, else by the file. platform_id: the learning platform's
    number in the file's name. late: whether the platform says so. in_folder: whether a folder bears
    the student's name. question: what the instructor must answer before this can be graded. remark:
    why the student may not be the one whom the name seems to say. who: what is known of the
    student, from which `find` makes the label `student`, which no other student has.
    """

    student: str
    notebook: str
    place: str
    path: Path
    member: str = ""
    refused: str = ""
    modified: float | None = None
    platform_id: str = ""
    late: bool = False
    in_folder: bool = False
    timed: bool = False
    question: str = ""
    remark: str = ""
    who: Identity = NOBODY

    def asked(self, question: str) -> "Submission":
        """Return the same, refused with a question to the instructor."""
        return replace(self, refused=question, question=question)


# ---- finding ----


def find(
    folder: Path,
    notebooks: Sequence[str],
    platform: str = "",
    students: str = "",
    roster: Roster | None = None,
) -> list[Submission]:
    """Return the Submissions in a folder, in the order of their places.

    folder: holds <student>/<notebook>.ipynb, <student>_<notebook>.ipynb, or what a learning
    platform exports. notebooks: the course's. platform: the name of the one that exported the
    files; "" or "none" if none did, but Gradescope's lists are read in any case. students: a
    pattern for the files and folders of which each is one student's, `*` or `*/*`; "" if that has
    not been said, so that what may be several students' is refused with a question. roster: of the
    class, which may say whether two hand-ins of one name are one student's.
    """
    exporter = named(platform)
    submissions = []
    holders = holders_in(folder, exporter, students)
    known_initials = _known_initials(holders, notebooks)
    for holder in holders:
        try:
            found = _of_holder(holder, folder, notebooks, exporter, students)
            submissions += [_without_initials(each, notebooks, known_initials) for each in found]
        except Exception as problem:  # any problem of one file must not affect the others
            reason = getattr(problem, "strerror", None)
            reason = reason or f"{type(problem).__name__}: {problem}"[:200]
            for hand_in in holder.hand_ins or [HandIn("")]:
                whole = _submission(hand_in, holder.path, folder)
                submissions.append(replace(whole, refused=f"It cannot be read: {reason}."))
    submissions = [
        submission
        for submission in submissions
        if not (submission.refused and exporter.is_typed_text(Path(submission.place).stem))
    ]
    submissions = [
        submission if submission.timed else replace(submission, modified=_modified(submission.path))
        for submission in submissions
    ]
    submissions = _labelled(submissions, notebooks, students, roster)
    return _within_bounds(sorted(submissions, key=lambda submission: submission.place))


def _within_bounds(submissions: list[Submission]) -> list[Submission]:
    """Return the Submissions; of each student, those beyond MAX_GRADED are refused."""
    counts: collections.Counter = collections.Counter()
    for number, submission in enumerate(submissions):
        counts[submission.student] += not submission.refused
        if counts[submission.student] > MAX_GRADED and not submission.refused:
            reason = f"Only {MAX_GRADED} notebooks of a student are graded."
            submissions[number] = replace(submission, refused=reason)
    return submissions


def _submission(hand_in: HandIn, path: Path, folder: Path) -> Submission:
    """Return the Submission of a whole file or folder, with what a platform says of it."""
    return Submission(
        hand_in.student,
        "",
        printable(path.relative_to(folder)),
        path,
        modified=hand_in.time,
        platform_id=hand_in.number,
        late=hand_in.late,
        in_folder=is_folder(path),
        timed=hand_in.time is not None,
        who=hand_in.identity(),
    )


def _of_holder(
    holder: Holder, folder: Path, notebooks: Sequence[str], exporter: Platform, students: str
) -> list[Submission]:
    """Return the Submissions of one file or folder."""
    whole = _submission(HandIn(""), holder.path, folder)
    if holder.outside:
        return [replace(whole, refused=holder.outside)]
    if not is_folder(holder.path):
        whole = replace(whole, in_folder=False)
        submissions = _flat(whole, holder, notebooks, students)
    else:
        known = bool(holder.hand_ins)
        whole = replace(whole, student=plain_name(holder.path))
        submissions = _in_folder(whole, notebooks, "" if known else exporter.name, known, students)
        if holder.hand_ins:
            submissions = [
                _of_student(submission, hand_in)
                for hand_in in holder.hand_ins
                for submission in submissions
            ]
    return [_of_holders_place(submission, holder) for submission in submissions]


def _known_initials(holders: Sequence[Holder], notebooks: Sequence[str]) -> dict[str, str]:
    """Return {student: initials} of those whose files end in one person's initials only."""
    endings: dict[str, set[str]] = collections.defaultdict(set)
    for holder in holders:
        student, _, letters = initials(printable(stem_of(holder.path.name)), notebooks)
        people, _ = owners([Path(student)], "", lambda stem: (stem, ""))
        if letters and people:
            endings[student].add(letters)
    return {student: min(several) for student, several in endings.items() if len(several) == 1}


def _without_initials(
    submission: Submission, notebooks: Sequence[str], known: dict[str, str]
) -> Submission:
    """Return a Submission whose file's name ends in the student's initials as the student's, with a
    remark."""
    student, notebook, letters = initials(submission.student, notebooks)
    if not letters or known.get(student) != letters or not submission.remark:
        return submission
    remark = (
        f"{letters} behind the notebook's name is taken for initials of {student}. If the file is "
        f"another student's, call it <student>_{notebook}.ipynb."
    )
    who = replace(submission.who, name=student)
    return replace(submission, student=student, notebook=notebook, remark=remark, who=who)


def _of_holders_place(submission: Submission, holder: Holder) -> Submission:
    """Return a Submission with what the place of its holder says of the student."""
    who = replace(submission.who, name=submission.student, section=holder.parent)
    if holder.by_login:
        who = replace(who, login=submission.student)
    return replace(submission, who=who)


def _of_student(submission: Submission, hand_in: HandIn) -> Submission:
    """Return a Submission with what a platform says of the student."""
    about = _submission(hand_in, submission.path, submission.path)
    return replace(
        about,
        notebook=submission.notebook,
        place=submission.place,
        member=submission.member,
        refused=submission.refused,
        question=submission.question,
        in_folder=submission.in_folder,
    )


def _flat(
    whole: Submission, holder: Holder, notebooks: Sequence[str], students: str
) -> list[Submission]:
    """Return the Submissions of a file whose name contains the student's."""
    path = holder.path
    stem, ending = printable(stem_of(path.name)), ending_of(path.name)
    student, notebook = split(stem, notebooks)
    remark = ""
    if holder.hand_ins:
        (hand_in,) = holder.hand_ins
        student = hand_in.student
        notebook = split(hand_in.rest, notebooks)[1] or hand_in.rest
        whole = replace(_of_student(whole, hand_in), in_folder=False)
    elif not notebook and ending in READ:
        remark = unknown_ending(stem, notebooks)
    refused = ""
    if path.is_symlink():
        refused = LINK
        if not ending and not notebook:  # in place of a student's folder
            student = printable(path.name)
    elif ending not in READ:
        kind = kind_of_file(path.name) or "not a notebook: its name does not end in .ipynb"
        refused = f"It is {kind}."
    elif notebook and not student:
        refused = (
            "Its name does not say whose it is: <student>_<notebook>.ipynb, or a folder for each "
            "student."
        )
    if not student and not refused:  # another name: its exercises determine which notebook it is
        student = notebook = stem
    whole = replace(whole, student=student, notebook=notebook, remark=remark)
    if ending == ".zip" and not refused:
        return _in_zip(whole, notebooks, students)
    return [replace(whole, refused=refused)]


def _in_folder(
    whole: Submission, notebooks: Sequence[str], platform: str, known: bool, students: str
) -> list[Submission]:
    """Return the Submissions in a student's folder.

    platform: the name of the one that exported, "" if it is to be guessed. known: whether a
    platform named the student.
    """
    top = whole.path
    files, others, problems = _walk(top)
    if not students:
        inside = [path.relative_to(top) for path in files]
        if not known and is_of_a_class([str(path) for path in inside], platform):
            remedy = "put its files directly into the folder of submissions, or grade it alone by"
            return [whole.asked(f"{CLASS} {remedy} SUBMISSIONS='{printable(top)}'.")]
        question = _question(whole, inside, notebooks, known)
        if question:
            return [whole.asked(question)]
    if len(files) > MAX_LISTED:
        problems.append(
            f"It holds {len(files)} notebooks and links: only {MAX_LISTED} were looked at."
        )
    submissions = []
    for path in files[:MAX_LISTED]:
        place = f"{whole.place}/{printable(path.relative_to(top))}"
        submission = replace(whole, place=place, path=path)
        ending, stem = ending_of(path.name), printable(stem_of(path.name))
        if ending == ".zip" and not path.is_symlink():
            submissions += _in_zip(submission, notebooks, students)
        else:
            notebook = (split(stem, notebooks)[1] or stem) if ending == ".ipynb" else ""
            refused = LINK if path.is_symlink() else ""
            submissions.append(replace(submission, notebook=notebook, refused=refused))
    if not submissions and not problems:
        problems.append(f"There is not a notebook in the folder: {_holds(others)}.")
    if problems:
        submissions.append(replace(whole, refused=" ".join(problems)))
    return submissions


def _holds(others: Sequence[str]) -> str:
    """Return a clause on the files of a folder without a notebook, with what the first few are."""
    if not others:
        return "it is empty"
    files = []
    for name in sorted(others)[:5]:
        kind = kind_of_file(name)
        files.append(f"{name} ({kind})" if kind else name)
    return f"it holds {', '.join(files)}"


def _question(
    whole: Submission, inside: Sequence[Path], notebooks: Sequence[str], known: bool
) -> str:
    """Return what to ask about a folder or zip that may be of several students, or "".

    inside: the paths of its notebooks. known: whether a platform said whose it is.
    """
    names, depth = owners(inside, whole.student, lambda stem: split(stem, notebooks))
    if names and not known:
        whom = "several students" if len(names) > 1 else "a student in a folder of something else"
        pattern = "/".join("*" * (depth + len(Path(whole.place).parts)))
        return (
            f"It seems to hold the work of {whom} ({listing(names, 3)}): add "
            f"STUDENTS='{pattern}' if each of these is a student, or STUDENTS='{EACH_ENTRY}' if "
            f"{whole.place} is one student's."
        )
    if len(inside) > MAX_UNASKED:
        return (
            f"It holds {len(inside)} notebooks and links, which is much for one student: add "
            f"STUDENTS='{EACH_ENTRY}' if it is one student's, or STUDENTS='*/*' if each folder in "
            "it is a student's."
        )
    return ""


def is_of_a_class(names: Sequence[str], platform: str) -> bool:
    """Return whether files of these paths, from one folder or zip, are a platform's export of
    several students.

    platform: the name of the one that exported; "" if it is to be guessed.
    """
    paths = [ADDED.sub("", name).removesuffix(".ipynb").split("/") for name in names]
    candidates = [
        known_platform for known_platform in platforms().values() if not known_platform.vague
    ]
    if platform:
        candidates = [named(platform)]
    for parts in ([path[0] for path in paths], [path[-1] for path in paths]):
        for candidate in candidates:
            hand_ins = [candidate.read_name(part) for part in parts]
            if platform or all(hand_ins):
                students = {h.student.removesuffix(f"_{h.number}") for h in hand_ins if h}
                if len(students) > 1:
                    return True
    folders = [
        known_platform.export_folder
        for known_platform in platforms().values()
        if known_platform.export_folder
    ]
    return any(pattern.fullmatch(part) for pattern in folders for path in paths for part in path)


def _in_zip(whole: Submission, notebooks: Sequence[str], students: str) -> list[Submission]:
    """Return the Submissions in a zip that a student handed in; `whole` is the zip's own."""
    try:
        members = [
            name
            for name in zips.notebooks_in(whole.path)
            if not any(map(is_clutter, zips.path_of(name).split("/")))
        ]
    except Refused as reason:
        return [replace(whole, refused=str(reason))]
    names = [zips.path_of(member) for member in members]
    if not students:
        if not whole.in_folder and is_of_a_class(names, ""):
            return [whole.asked(f"{CLASS} unpack it into the folder of submissions.")]
        known = whole.in_folder or bool(whole.platform_id or whole.who.known())
        if question := _question(whole, [Path(name) for name in names], notebooks, known):
            return [whole.asked(f"{question} A class must be unpacked first.")]
    if not names:
        return [replace(whole, refused="There is no notebook in the zip.")]
    submissions = []
    for member, name in itertools.islice(zip(members, names, strict=True), MAX_LISTED):
        stem = printable(stem_of(name))
        of_zip = whole.notebook if whole.notebook in notebooks else stem
        notebook = split(stem, notebooks)[1] or of_zip
        place = f"{whole.place}/{printable(name)}"
        submissions.append(replace(whole, notebook=notebook, place=place, member=member))
    if len(names) > MAX_LISTED:
        reason = f"It holds {len(names)} notebooks: only {MAX_LISTED} were looked at."
        submissions.append(replace(whole, refused=reason))
    return submissions


def _modified(path: Path) -> float | None:
    try:
        return os.lstat(path).st_mtime
    except (OSError, ValueError):
        return None


def _walk(top: Path) -> tuple[list[Path], list[str], list[str]]:
    """Search a student's folder within bounds.

    Returns the sorted paths of notebooks, zips and linked folders, the names of the other files,
    and sentences on what could not be searched.
    """
    files: list[Path] = []
    others: list[str] = []
    problems: set[str] = set()
    seen = 0

    def unread(error: OSError) -> None:
        problems.add(f"A folder in it cannot be read: {error.strerror or error}.")

    for place, folders, names in os.walk(top, onerror=unread):  # which enters no link
        seen += len(folders) + len(names)
        folders[:] = [name for name in folders if not is_clutter(name)]
        names = [name for name in names if not is_clutter(name)]
        wanted = [name for name in names if ending_of(name) in READ]
        links = [name for name in folders if os.path.islink(os.path.join(place, name))]
        files += [Path(place, name) for name in wanted + links]
        others += [printable(name) for name in names if name not in wanted]
        if seen > MAX_ENTRIES:
            problems.add(f"It holds more than {MAX_ENTRIES} files: the others were not looked at.")
            break
        if len(Path(place).relative_to(top).parts) + 1 >= MAX_DEPTH and len(folders) > len(links):
            folders.clear()
            problems.add(
                f"It holds folders nested more than {MAX_DEPTH} deep: those were not looked into."
            )
    return sorted(files), others, sorted(problems)


# ---- whose ----


def _labelled(
    submissions: list[Submission],
    notebooks: Sequence[str],
    students: str,
    roster: Roster | None,
) -> list[Submission]:
    """Return the Submissions with the labels of their students, or with a question about them."""
    handed_in: dict[Identity, set[str]] = {}
    for submission in submissions:
        if submission.student:
            names = handed_in.setdefault(submission.who, set())
            if submission.notebook in notebooks or not submission.refused:
                names.add(submission.notebook)
    unknown = Relation.DIFFERENT if students == EACH_ENTRY else Relation.UNKNOWN
    line_of = roster.line_of if roster else lambda identity: None
    told_apart = tell_apart(handed_in, line_of, unknown)
    questions = {identity: roster.question(identity) for identity in handed_in} if roster else {}
    for doubt in told_apart.doubts:
        asked = _one_or_two(doubt, has_roster=roster is not None)
        questions |= {doubt.one: asked, doubt.other: asked}
    labelled = []
    for submission in submissions:
        who = submission.who
        if not submission.student:
            labelled.append(submission)
            continue
        submission = replace(submission, student=told_apart.labels[who])
        if submission.student == f"{who.name} ({who.section})":
            remark = (
                f"{who.name} has the same notebook in another folder too. They are taken for two "
                "students: if they are one, put all files into one folder."
            )
            submission = replace(submission, remark=remark)
        question = questions.get(who, "")
        labelled.append(submission.asked(question) if question else submission)
    return labelled


def _one_or_two(doubt: Doubt, has_roster: bool) -> str:
    """Return the question whether two identities of one name are one student."""
    one, other = sorted((doubt.one.in_full(), doubt.other.in_full()))
    asked = f"{one} and {other} may be one student or two, because nothing else than the name is "
    asked += "known of both: "
    if has_roster:
        return (
            f"{asked}write them into the column `student` of the roster, on two lines if they are "
            f"two students, and on one line, as `{one}; {other}`, if they are one."
        )
    asked += "add ROSTER=roster.csv, where a name on a single line is one student's, or "
    if doubt.one.section or doubt.other.section:
        depth = len(Path(doubt.one.section or doubt.other.section).parts)
        pattern = "/".join(["*"] * depth + [LOGIN])
        return (
            f"{asked}STUDENTS='{pattern}' if these names are logins or numbers, of which each is "
            "one student wherever it stands."
        )
    return f"{asked}STUDENTS='{EACH_ENTRY}' if each of these is a student."


# ---- reading ----


def read(submission: Submission) -> bytes:
    """Return the bytes of a Submission's file.

    Raises Refused if it is refused, too large or cannot be read.
    """
    if submission.refused:
        raise Refused(submission.refused)
    flags = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK  # a pipe must not stop the run
    try:
        with os.fdopen(os.open(submission.path, flags), "rb") as file:
            if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
                raise Refused("It is not a regular file.")
            most, member = MAX_BYTES + 1, submission.member
            content = zips.content(file, member, most) if member else file.read(most)
    except (OSError, ValueError, MemoryError) as error:
        reason = getattr(error, "strerror", None) or type(error).__name__
        raise Refused(f"It cannot be read: {reason}.") from error
    if len(content) > MAX_BYTES:
        raise Refused(
            f"It is larger than {MAX_BYTES // 1_000_000} MB. Clear its outputs and hand it in "
            f"again."
        )
    return content
