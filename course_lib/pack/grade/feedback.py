"""The feedback page of each submission, for its student.

Jinja escapes all text from submissions.
"""

import io
import re
import zipfile
from pathlib import Path

import jinja2
from markupsafe import Markup

from course_lib.checks.exercise import ERROR, NOT_ATTEMPTED, RIGHT, WRONG
from course_lib.pack.files import write_atomically
from course_lib.pack.grade.collect import file_names
from course_lib.pack.grade.csv_text import clean, count_noun
from course_lib.pack.grade.platforms import MOODLE
from course_lib.pack.grade.tables import final_message, final_state, lateness

LONGEST = 100_000  # characters of one message or answer
MARKS = {
    RIGHT: ("✓", "good"),
    WRONG: ("✗", "bad"),
    ERROR: ("!", "bad"),
    final_state(NOT_ATTEMPTED): ("○", "none"),
}


def _showable(value):
    """Return a text of a page without what cannot be shown, cut to LONGEST characters."""
    if isinstance(value, Markup) or not isinstance(value, str):
        return value
    text = clean(value)
    return text if len(text) <= LONGEST else text[:LONGEST] + "\n... (cut here)"


PAGES = jinja2.FileSystemLoader(Path(__file__).with_name("pages"))
TEMPLATES = jinja2.Environment(loader=PAGES, autoescape=True, trim_blocks=True, finalize=_showable)


def rendered(name, **values):
    """Return an HTML page that needs no network and runs no script; name: of a template in pages/."""
    return TEMPLATES.get_template(name).render(values)


def feedback_page(each):
    """Return the HTML page of one GradedFile."""
    entries = [*map(_exercise, each.result["exercises"]), *map(_answer, each.answers)]
    for entry in entries:
        entry["mark"], entry["colour"] = MARKS.get(entry["state"], ("·", "none"))
    groups = [
        (_subtotal(each, more), [it for it in entries if it["more"] == more])
        for more in (False, True)
    ]
    left = f", {count_noun(each.unread, 'written answer')} still to be read" if each.unread else ""
    about = {"title": f"{each.notebook}, {each.student}", "late": lateness(each), "left": left}
    details = [it for it in entries if it["text"] or "task" in it]
    return rendered("feedback.html", each=each, groups=groups, details=details, **about)


def _subtotal(each, more):
    points, of = each.part(more)
    said = f"{'More' if more else 'Core'}: {points:g} of {of:g} points"
    if not more or each.weight == 1:
        return said
    return (
        f"{said}, which count {each.weight:g} times: {points * each.weight:.4g} of "
        f"{of * each.weight:.4g}"
    )


def _exercise(exercise):
    about = {
        "name": exercise["exercise"],
        "title": exercise["exercise"],
        "text": final_message(exercise["message"]),
    }
    return exercise | about | {"state": final_state(exercise["state"])}


def _answer(answer):
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
    return about | {"task": answer.task.replace("**", ""), "comment": answer.comment}


# ---- all of them ----


def write_feedback(folder, everything):
    """Write <student>/<notebook>.html for each file that counts; delete the pages of students not in this run."""
    counting = [each for each in everything if not each.superseded_by and each.student]
    students = file_names({each.student for each in counting})
    pages = {}
    for each in counting:
        pages.setdefault(each.student, {}).setdefault(each.notebook or each.submission.place, each)
    written = set()
    for student, its in pages.items():
        names = file_names(set(its))
        for notebook, each in its.items():
            path = folder / students[student] / f"{names[notebook]}.html"
            write_atomically(path, feedback_page(each))
            written.add(path)
    for notebook, content in _uploads(counting).items():
        path = folder / "moodle" / f"{notebook}.zip"
        write_atomically(path, content)
        written.add(path)
    for path in (*folder.glob("*/*.html"), *folder.glob("moodle/*.zip")):
        if path not in written:
            path.unlink()
            if not any(path.parent.iterdir()):
                path.parent.rmdir()


def _uploads(counting):
    """Return {notebook: a zip of all its feedback, as Moodle takes it}, empty if nothing came from Moodle.

    Moodle finds the student by the number in the folder's name (moodle/moodle,
    mod/assign/feedback/file/ importziplib.php, is_valid_filename_for_import). The number belongs to
    one assignment.
    """
    contents = {}
    for each in counting:
        found = MOODLE.fullmatch(each.submission.place.partition("/")[0])
        if not (found and found["id"]):
            continue
        folder = (
            f"{each.student.replace('_', ' ')}_{each.submission.platform_id}_assignsubmission_file"
        )
        name = each.notebook or "other files"
        with zipfile.ZipFile(
            contents.setdefault(name, io.BytesIO()), "a", zipfile.ZIP_DEFLATED
        ) as archive:
            about = zipfile.ZipInfo(
                f"{folder}/feedback_{name}.html"
            )  # dated 1980: equal pages, equal bytes
            archive.writestr(about, feedback_page(each), zipfile.ZIP_DEFLATED)
    return {
        name: contents[notebook].getvalue() for notebook, name in file_names(set(contents)).items()
    }
