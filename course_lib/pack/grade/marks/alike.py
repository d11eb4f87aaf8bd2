"""Students whose code is more similar than the tasks force, side by side, for a person to judge.

What is compared are passages: runs of tokens, wherever they stand, in which all names are equal
(the fingerprints of Schleimer, Wilkerson and Aiken, "Winnowing", SIGMOD 2003, with a window of
one). As in MOSS, a passage that many students have comes from the task and says nothing, and
neither does one of the release or of the library.
"""

import functools
import hashlib
import itertools
from collections import Counter, defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from markupsafe import Markup, escape
from pygments.lexers import PythonLexer
from pygments.token import Comment, Name, String

from course_lib.pack.files import write_atomically
from course_lib.pack.grade.bounded import OutOfBounds, call_bounded
from course_lib.pack.grade.csv_text import words
from course_lib.pack.grade.hand_ins import notebook_file
from course_lib.pack.grade.hand_ins.collect import Submission, find, read
from course_lib.pack.grade.hand_ins.holders import EACH_ENTRY
from course_lib.pack.grade.hand_ins.notebook_file import NOTEBOOKS, Unreadable, code, course_of
from course_lib.pack.grade.hand_ins.zips import Refused
from course_lib.pack.grade.jail.course_view import PACKAGE
from course_lib.pack.grade.jobs import course_hash
from course_lib.pack.grade.marks.feedback import rendered
from course_lib.pack.release.stubs import students_copy

PASSAGE = 20  # tokens: about two lines
MAX_STUDENTS = 10  # students; MOSS has the same number
MIN_SCORE = 8  # score of a pair on the page, see pairs
VERBATIM = 120  # passages of the library or a solution, names included: some 15 lines
MAX_PAIRS = 100  # pairs on the page
CPU_SECONDS, MEMORY = 7200, 8 * 10**9  # for the page

Passages = dict[int, tuple[int, int]]  # {hash of a passage: (begin, end)}


@dataclass(frozen=True)
class Work:
    """The code cells of one student's notebook.

    year: the folder of the earlier year that it is from, or "".
    """

    student: str
    notebook: str
    cells: tuple
    year: str = ""


@functools.lru_cache(5_000)  # cells of the release are the same in all files
def passages(source: str, names: bool = False) -> Passages:
    """Return {hash of a passage: (begin, end)} of a source.

    names: whether passages differ if a name in them does.
    """
    tokens = []
    for begin, kind, text in PythonLexer(stripnl=False, ensurenl=False).get_tokens_unprocessed(
        source
    ):
        if text.strip() and kind not in Comment and kind not in String.Doc:
            text = text if names else "name" if kind in Name else "text" if kind in String else text
            tokens.append((text, begin, begin + len(text.strip())))
    runs = (tokens[i : i + PASSAGE] for i in range(len(tokens) - PASSAGE + 1))
    return {hash(tuple(text for text, *_ in run)): (run[0][1], run[-1][2]) for run in runs}


def _all(sources: Iterable[str], names: bool = False) -> set[int]:
    return set().union(*(passages(source, names) for source in sources))


def works(submissions: Iterable[Submission], year: str = "") -> list[Work]:
    """Return the Works in the Submissions that can be read."""
    readable = []
    for submission in submissions:
        try:
            cells, _ = notebook_file.read(read(submission))
        except (Refused, Unreadable):
            continue
        if submission.student and (course := course_of(submission.notebook, cells)):
            readable.append(Work(submission.student, course.name, tuple(code(cells)), year))
    return readable


def earlier_works(folder: Path, platform: str = "", students: str = EACH_ENTRY) -> list[Work]:
    """Return the Works in a folder of an earlier year's submissions, or in one that has such a
    folder for each year."""
    names = [path.stem for path in NOTEBOOKS.glob("[0-9][0-9]_*.ipynb")]
    years = [
        path for path in sorted(folder.iterdir()) if path.is_dir() and path.name.isdecimal()
    ] or [folder]
    earlier = []
    for year in years:
        # Whether two hand-ins of an earlier year are of one student makes no difference here.
        found = [
            replace(submission, refused="") if submission.question else submission
            for submission in find(year, names, platform, students)
        ]
        earlier += works(found, year.name)
    return earlier


@functools.cache
def _ours() -> tuple[dict[str, list[str]], list[str]]:
    """Return ({name: source} of the library and the solutions, the sources of what students are
    given)."""
    library = {
        f"{PACKAGE.name}/{path.relative_to(PACKAGE).as_posix()}": [path.read_text(encoding="utf-8")]
        for path in [*PACKAGE.glob("*.py"), *PACKAGE.glob("trajectory/*.py")]
    }
    given = []
    for path in sorted(NOTEBOOKS.glob("[0-9][0-9]_*.ipynb")):
        text = path.read_text(encoding="utf-8")
        library[f"the solutions of {path.stem}"] = code(notebook_file.read(text.encode())[0])
        given += code(notebook_file.read(students_copy(text, path.stem, "").encode())[0])
    return library, given


def write_alike(
    path: Path,
    submissions: Sequence[Submission],
    earlier: str = "",
    platform: str = "",
    students: str = "",
) -> None:
    """Write the page, unless it is there for these Submissions and this folder of earlier years.

    Lexing what students wrote may take any time, so it is done in a process of its own, within
    bounds.
    """
    depends = [
        earlier,
        course_hash(),
        *(f"{submission.place} {submission.modified}" for submission in submissions),
    ]
    stamp = hashlib.sha256("\n".join(depends).encode("utf-8", "backslashreplace")).hexdigest()
    if path.exists() and stamp in path.read_text(encoding="utf-8"):
        return

    def page() -> str:
        return alike_page(
            works(submissions)
            + (earlier_works(Path(earlier), platform, students or EACH_ENTRY) if earlier else []),
            stamp,
        )

    try:
        write_atomically(
            path,
            call_bounded(page, cpu_seconds=CPU_SECONDS, memory=MEMORY, clock_seconds=10 * 3600),
        )
    except (OutOfBounds, RuntimeError) as problem:
        print(f"{path} was not written: {problem}.")


def pairs(everyone: Sequence[Work]) -> list[tuple[float, Work, Work, set[int]]]:
    """Return [(score, a Work, another, their passages)], the pairs of highest score first.

    Only passages that at most MAX_STUDENTS students of a year have count.

    Passages of the release and the library are left out. The score is the number of passages that
    the two share, where one that n students have counts 1 / (n - 1), times the share that this is
    of the smaller one's rare passages. everyone: Works, of this class and of earlier years.
    """
    library, given = _ours() if everyone else ({}, [])
    ours = _all(itertools.chain(given, *library.values()))
    rare, counts, shared = Counter(), Counter(), defaultdict(set)
    for notebook in {work.notebook for work in everyone}:  # one after the other, for memory
        having = defaultdict(list)
        for work in everyone:
            for passage in _all(work.cells) - ours if work.notebook == notebook else ():
                having[passage].append(work)
        for passage, those in having.items():
            if max(Counter(work.year for work in those).values()) <= MAX_STUDENTS:
                rare.update(those)
                for one, other in itertools.combinations(those, 2):
                    if not (one.year and other.year) and words(one.student) != words(other.student):
                        counts[one, other] += 1 / (len(those) - 1)
                        shared[one, other].add(passage)
    scores = {pair: count**2 / min(rare[work] for work in pair) for pair, count in counts.items()}
    similar = [(score, *pair, shared[pair]) for pair, score in scores.items() if score >= MIN_SCORE]
    return sorted(
        similar, key=lambda pair: (-pair[0], pair[1].student, pair[2].student, pair[1].notebook)
    )


def copies(everyone: Sequence[Work]) -> list[tuple[str, str, str, int]]:
    """Return [(student, notebook, what it is copied from, how many passages)], names included, of
    this class."""
    library, given = _ours() if everyone else ({}, [])
    released, copied = _all(given, names=True), []
    sources = {name: _all(texts, names=True) - released for name, texts in library.items()}
    for work in (work for work in everyone if not work.year):
        own = _all(work.cells, names=True)
        counts = {name: len(own & source) for name, source in sources.items()}
        copied += [
            (work.student, work.notebook, name, n) for name, n in counts.items() if n >= VERBATIM
        ]
    return sorted(copied, key=lambda line: (-line[3], line))


def alike_page(everyone: Sequence[Work], stamp: str = "") -> str:
    """Return the HTML page of pairs and of copies from the library.

    everyone: Works. stamp: a comment on the page.
    """
    similar = pairs(everyone)
    shown = [
        {"who": [_whose(one), _whose(other)], "notebook": one.notebook, "score": round(score),
         "sides": [_marked(one.cells, shared), _marked(other.cells, shared)]}
        for score, one, other, shared in similar[:MAX_PAIRS]
    ]  # fmt: skip
    about = {
        "passage": PASSAGE,
        "many": MAX_STUDENTS,
        "left": len(similar) - len(shown),
        "copies": copies(everyone),
    }
    return rendered("alike.html", title="Alike", pairs=shown, stamp=stamp, **about)


def _whose(work: Work) -> str:
    return f"{work.student} ({work.year})" if work.year else work.student


def _marked(cells: Iterable[str], shared: set[int]) -> Markup:
    """Return the cells that hold shared passages, with those marked."""
    parts = []
    for cell in cells:
        inside = sorted(place for passage, place in passages(cell).items() if passage in shared)
        end = 0
        for begin, stop in inside:
            if begin > end or not end:
                parts += ["</mark>" * bool(end), escape(cell[end:begin]), "<mark>"]
                end = begin
            parts.append(escape(cell[end : max(end, stop)]))
            end = max(end, stop)
        parts += ["</mark>", escape(cell[end:]), "\n\n"] if inside else []
    return Markup("").join(map(Markup, parts))
