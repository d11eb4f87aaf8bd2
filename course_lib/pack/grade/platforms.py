"""Learning platforms: the names of the files that they export.

A pattern that fits a name may be chance (`2026_01_15_alice`), so names are read as a platform's
only if the instructor says which (LMS=). If all names fit one, the instructor is asked.
"""

import re
from contextlib import suppress
from datetime import datetime
from typing import NamedTuple

# Moodle's "Download all submissions": <full name>_<number>_assignsubmission_file, a folder or the
# beginning of a file's name; the number is of the participant in this one assignment, or of the
# group. Those in no group are a group without a number (moodle/moodle,
# mod/assign/classes/downloader.php, get_student_prefix and load_submissionplugin_filelist).
MOODLE = re.compile(
    r"(?P<name>.+?)(?:_(?P<id>\d+))?_assignsubmission_(?:file|onlinetext)_?(?P<rest>.*)", re.DOTALL
)

# Canvas's "Download submissions": <name>_[LATE_]<user>_<file>_<file's own name>, or anon_<id> for
# name and user (instructure/canvas-lms, lib/content_zipper.rb, get_filename and
# add_upload_submission).
CANVAS = re.compile(
    r"(?:(?P<late1>LATE)_)?(?P<anonymous>anon_[A-Za-z0-9]+)_(?P<file1>\d+)_(?P<rest1>.*)"
    r"|(?P<name>.+?)(?P<late>_LATE)?_(?P<id>\d+)_(?P<file>\d+)_(?P<rest>.*)",
    re.DOTALL,
)

# What was typed into the platform: Moodle's folder or file, and Canvas's (add_text_or_url).
ONLINE_TEXT = re.compile(
    r".+_assignsubmission_onlinetext(_.*)?|.+_(\d+|anon_[A-Za-z0-9]+)_(text|link)", re.DOTALL
)

# Gradescope's "Export Submissions": this folder, with a folder for each hand-in and a list of who
# handed in which.
GRADESCOPE, GRADESCOPES_LIST = re.compile(r"assignment_\d+_export"), "submission_metadata.yml"


class Exported(NamedTuple):
    """The parts of a file name that Canvas or Moodle exported.

    rest: the student's own name for the file. number: the platform's, which distinguishes students
    of the same name. late: whether the platform marked the file as late. user_id: the number by
    which the gradebook knows the student, which only Canvas gives.
    """

    student: str = ""
    rest: str = ""
    number: str = ""
    late: bool = False
    user_id: str = ""

    def about(self):
        """Return the fields of a Submission that the platform gives."""
        return {"platform_id": self.number, "late": self.late, "user_id": self.user_id}


def exported_name(stem, platform):
    """Return the parts of a name that a platform exported, or an empty Exported for any other name.

    The platform's part comes first, so a student cannot imitate it by the file's own name.
    """
    if platform == "moodle" and (found := MOODLE.fullmatch(stem)):
        blind = (
            found["id"] and found["name"] == "Participant"
        )  # Moodle's name for all in anonymous submissions
        student = f"Participant {found['id']}" if blind else found["name"]
        return Exported(student, found["rest"], found["id"] or "")
    if platform == "canvas" and (found := CANVAS.fullmatch(stem)):
        if found["anonymous"]:
            return Exported(
                found["anonymous"], found["rest1"], found["anonymous"], bool(found["late1"])
            )
        return Exported(
            f"{found['name']}_{found['id']}",
            found["rest"],
            found["id"],
            bool(found["late"]),
            found["id"],
        )
    return Exported()


def recognized(stems, folders=()):
    """Return the platform whose export all these names may be, or "".

    stems: the names of all files and folders, without endings. folders: of those, the folders;
    Canvas exports none.
    """
    if stems and all(map(MOODLE.fullmatch, stems)):
        return "moodle"
    return "canvas" if stems and not folders and all(map(CANVAS.fullmatch, stems)) else ""


def is_of_a_class(names, platform):
    """Return whether files of these names (paths), from one folder or zip, are a platform's export of several students.

    platform: the one that exported; "" if it is to be guessed.
    """
    parts = [name.removesuffix(".ipynb").split("/") for name in names]
    for tops in ([each[0] for each in parts], [each[-1] for each in parts]):
        exported = [exported_name(top, platform or recognized(tops)) for top in tops]
        if len({each.student.removesuffix(f"_{each.number}") for each in exported} - {""}) > 1:
            return True
    return any(GRADESCOPE.fullmatch(part) for each in parts for part in each)


def handed_in(folder):
    """Return the paths in a folder and in Gradescope's exports in it, and {path: [fields of a Submission]} by its list.

    A group's path has the fields of each member.
    """
    places = [
        folder,
        *(
            path
            for path in folder.iterdir()
            if GRADESCOPE.fullmatch(path.name) and not path.is_symlink()
        ),
    ]
    lists = {
        place: place / GRADESCOPES_LIST for place in places if (place / GRADESCOPES_LIST).is_file()
    }
    known = {place: _students(path.read_text("utf-8", "replace")) for place, path in lists.items()}
    inside = {path for place in {folder, *lists} for path in place.iterdir()} - {
        *lists,
        *lists.values(),
    }
    return inside, {place / name: its for place in known for name, its in known[place].items()}


def _students(text):
    """Return {folder: [fields of a Submission, for each student who handed it in]} from the text of Gradescope's list.

    It is YAML as Ruby writes it: `submission_1:`, then indented `:submitters:` with `- :name:` and
    `:sid:`, and `:created_at:`. All text that students control is indented further.
    """
    found, times, name = {}, {}, ""
    for line in text.splitlines():
        if head := re.fullmatch(r"(submission_\w+):", line):
            name = head[1]
            found[name] = []
        elif entry := name and re.fullmatch(r"  (  |- |):(name|sid|created_at): (.+)", line):
            value = entry[3].strip("'\"").replace("''", "'")
            if entry[1] + entry[2] == "- name":
                found[name].append({"student": value})
            elif entry[1] + entry[2] == "  sid" and found[name]:
                found[name][-1]["platform_id"] = value
            elif entry[1] + entry[2] == "created_at":
                with suppress(ValueError):
                    time = datetime.fromisoformat(re.sub(r" (Z|[+-][\d:]+)$", r"\1", value))
                    times[name] = {"modified": time.timestamp()}
    return {name: [each | times.get(name, {}) for each in its] for name, its in found.items()}
