"""The feedback page of each submission, for its student.

Jinja escapes all text from submissions.
"""

import io
import re
import zipfile
from collections.abc import Iterable
from pathlib import Path

import jinja2
from markupsafe import Markup, escape

from course_lib.checks.verdict import ERROR, NOT_ATTEMPTED, RIGHT, WRONG
from course_lib.pack.files import write_atomically
from course_lib.pack.grade.csv_text import clean, count_noun
from course_lib.pack.grade.hand_ins.names import file_names
from course_lib.pack.grade.hand_ins.notebook_file import courses
from course_lib.pack.grade.hand_ins.platforms import Platform, platforms
from course_lib.pack.grade.marks.graded_file import GradedFile
from course_lib.pack.grade.marks.marks_table import MarkedAnswer
from course_lib.pack.grade.marks.tables import final_state, lateness

MAX_TEXT = 100_000  # characters of one message or answer
MARKS = {
    RIGHT: ("✓", "good"),
    WRONG: ("✗", "bad"),
    ERROR: ("!", "bad"),
    final_state(NOT_ATTEMPTED): ("○", "none"),
}


def _showable(value: object) -> object:
    """Return a text of a page without what cannot be shown, cut to MAX_TEXT characters."""
    if isinstance(value, Markup) or not isinstance(value, str):
        return value
    text = clean(value)
    return text if len(text) <= MAX_TEXT else text[:MAX_TEXT] + "\n... (cut here)"


PAGES = jinja2.FileSystemLoader(Path(__file__).with_name("pages"))
TEMPLATES = jinja2.Environment(loader=PAGES, autoescape=True, trim_blocks=True, finalize=_showable)


def rendered(name: str, **values: object) -> str:
    """Return an HTML page that needs no network and runs no script; name: of a template in
    pages/."""
    return TEMPLATES.get_template(name).render(values)


def feedback_page(file: GradedFile) -> str:
    """Return the HTML page of one GradedFile."""
    entries = [*map(_exercise, file.result["exercises"]), *map(_answer, file.answers)]
    for entry in entries:
        entry["mark"], entry["colour"] = MARKS.get(entry["state"], ("·", "none"))
    groups = [
        (_subtotal(file, more), [it for it in entries if it["more"] == more])
        for more in (False, True)
    ]
    left = f", {count_noun(file.unread, 'written answer')} still to be read" if file.unread else ""
    course = courses().get(file.notebook)
    heading = course.title if course else file.notebook or file.submission.place
    title = f"{heading}, {file.student}"
    about = {"title": title, "heading": heading, "late": lateness(file), "left": left}
    details = [it for it in entries if it["text"] or "task" in it]
    return rendered("feedback.html", file=file, groups=groups, details=details, **about)


def _subtotal(file: GradedFile, more: bool) -> str:
    points, of = file.part(more)
    subtotal = f"{'More' if more else 'Core'}: {points:g} of {of:g} points"
    if not more or file.weight == 1:
        return subtotal
    return (
        f"{subtotal}, which count {file.weight:g} times: {points * file.weight:.4g} of "
        f"{of * file.weight:.4g}"
    )


def _exercise(exercise: dict) -> dict:
    about = {
        "name": exercise["exercise"],
        "title": exercise["exercise"],
        "text": with_code(exercise["message"]),
    }
    return exercise | about | {"state": final_state(exercise["state"])}


def _answer(answer: MarkedAnswer) -> dict:
    letter = re.match(
        r"\W*([A-Z])\.", answer.task
    )  # of the question in the notebook: explain_frame (B)
    about = {
        "name": answer.question,
        "title": answer.question + (f" ({letter[1]})" if letter else ""),
    }
    about |= {
        "state": final_state(answer.state),
        "points": "" if answer.points is None else f"{answer.points:g}",
    }
    about |= {"of": answer.of, "more": answer.more, "text": answer.text}
    return about | {"task": with_code(in_paragraphs(answer.task)), "comment": answer.comment}


def in_paragraphs(text: str) -> str:
    """Return a text of the course without the signs for bold, with each paragraph in one line."""
    paragraphs = re.split(r"\n\s*\n", text.replace("**", ""))
    is_no_item = r"(?!\s*(?:[-*]|\d+\.)\s)"
    return "\n\n".join(re.sub(rf"\n{is_no_item}", " ", paragraph) for paragraph in paragraphs)


def with_code(text: str) -> Markup:
    """Return a text of the course as HTML, in which what stands between backticks is code.

    Examples
    --------
    >>> with_code("Return `R` & no `<b>`.")
    Markup('Return <code>R</code> &amp; no <code>&lt;b&gt;</code>.')
    """
    escaped = str(escape(_showable(text)))
    return Markup(re.sub(r"`([^`\n]+)`", r"<code>\1</code>", escaped))


# ---- all of them ----


def _counting(everything: Iterable[GradedFile]) -> list[GradedFile]:
    return [file for file in everything if not file.superseded_by and file.student]


def feedback_places(everything: Iterable[GradedFile]) -> dict[str, GradedFile]:
    """Return {path below the folder of feedback: GradedFile} of all pages of feedback."""
    files_of: dict[str, dict[str, GradedFile]] = {}
    for file in _counting(everything):
        files = files_of.setdefault(file.student, {})
        files.setdefault(file.notebook or file.submission.place, file)
    students = file_names(files_of)
    places = {}
    for student, files in files_of.items():
        names = file_names(files)
        for notebook, file in files.items():
            places[f"{students[student]}/{names[notebook]}.html"] = file
    return places


def write_feedback(folder: Path, everything: Iterable[GradedFile]) -> None:
    """Write <student>/<notebook>.html for each file that counts; delete the pages of students not
    in this run."""
    counting = _counting(everything)
    written = set()
    for place, file in feedback_places(counting).items():
        write_atomically(folder / place, feedback_page(file))
        written.add(folder / place)
    for platform in platforms().values():
        for notebook, content in _uploads(counting, platform).items():
            path = folder / platform.name / f"{notebook}.zip"
            write_atomically(path, content)
            written.add(path)
    zips = [path for name in platforms() for path in folder.glob(f"{name}/*.zip")]
    for path in (*folder.glob("*/*.html"), *zips):
        if path not in written:
            path.unlink()
            if not any(path.parent.iterdir()):
                path.parent.rmdir()


def _uploads(counting: list[GradedFile], platform: Platform) -> dict[str, bytes]:
    """Return {notebook: a zip of all its feedback, as a platform takes it}, empty if nothing came
    from it."""
    contents: dict[str, io.BytesIO] = {}
    for file in counting:
        submission = file.submission
        folder = platform.feedback_folder(submission.place, file.student, submission.platform_id)
        if not folder:
            continue
        name = file.notebook or "other files"
        content = contents.setdefault(name, io.BytesIO())
        with zipfile.ZipFile(content, "a", zipfile.ZIP_DEFLATED) as archive:
            # Dated 1980: equal pages, equal bytes.
            about = zipfile.ZipInfo(f"{folder}/feedback_{name}.html")
            archive.writestr(about, feedback_page(file), zipfile.ZIP_DEFLATED)
    names = file_names(set(contents))
    return {names[notebook]: content.getvalue() for notebook, content in contents.items()}
