"""Learning platforms: the names of the files that they export."""

import re
from typing import NamedTuple

# Moodle's "Download all submissions": <full name>_<number>_assignsubmission_file_, a folder or the beginning of a
# file's name; the number is of the participant in this one assignment.
MOODLE = re.compile(r"(?P<name>.+?)_(?P<id>\d+)_assignsubmission_(?:file|onlinetext)_?(?P<rest>.*)", re.DOTALL)

# Canvas's "Download submissions": <name>_[LATE_]<user>_<file>_<file's own name>, or anon_<id> for name and user
# (instructure/canvas-lms, lib/content_zipper.rb, get_filename and add_upload_submission).
CANVAS = re.compile(
    r"(?:(?P<late1>LATE)_)?(?P<anonymous>anon_[A-Za-z0-9]+)_\d+_(?P<rest1>.*)"
    r"|(?P<name>.+?)(?P<late>_LATE)?_(?P<id>\d+)_\d+_(?P<rest>.*)",
    re.DOTALL,
)


class Exported(NamedTuple):
    """The parts of a file name that Canvas or Moodle exported.

    Parameters
    ----------
    student : str
        Whose the file is.
    rest : str
        The student's own name for the file.
    number : str
        The platform's number, which distinguishes students of the same name.
    late : bool
        True if the platform marked the file as late.
    user_id : str
        The number by which the gradebook knows the student, which only Canvas gives.

    Examples
    --------
    >>> exported_name("Jane Doe_42_assignsubmission_file_").number
    '42'
    """

    student: str = ""
    rest: str = ""
    number: str = ""
    late: bool = False
    user_id: str = ""


def exported_name(stem):
    """Return the parts of a name that Canvas or Moodle exported, or an empty Exported for any other name.

    The platform's part comes first, so a student cannot imitate it by the file's own name.

    Examples
    --------
    >>> exported_name("doejane_LATE_1234_5678_01_rotations")
    Exported(student='doejane_1234', rest='01_rotations', number='1234', late=True, user_id='1234')
    >>> exported_name("Jane Doe_42_assignsubmission_file_")
    Exported(student='Jane Doe', rest='', number='42', late=False, user_id='')
    """
    if found := MOODLE.fullmatch(stem):
        blind = found["name"] == "Participant"  # Moodle's name for everybody in anonymous submissions
        student = f"Participant {found['id']}" if blind else found["name"]
        return Exported(student, found["rest"], found["id"])
    found = CANVAS.fullmatch(stem)
    if not found:
        return Exported()
    if found["anonymous"]:
        return Exported(found["anonymous"], found["rest1"], found["anonymous"], bool(found["late1"]))
    return Exported(f"{found['name']}_{found['id']}", found["rest"], found["id"], bool(found["late"]), found["id"])
