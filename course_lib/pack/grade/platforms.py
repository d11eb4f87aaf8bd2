"""Learning platforms: the names of the files that they export."""

import re

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


def exported_name(stem):
    """Return (student, rest, number, late) from the name of a file or folder that Canvas or Moodle exported.

    rest: the student's own name for the file. number: the platform's number of the student. late: True if the platform
    marked the file as late. For any other name all are empty. The platform's part comes first, so a student cannot
    imitate it by the file's own name.

    Examples
    --------
    >>> exported_name("doejane_LATE_1234_5678_01_rotations")
    ('doejane_1234', '01_rotations', '1234', True)
    >>> exported_name("Jane Doe_42_assignsubmission_file_")
    ('Jane Doe', '', '42', False)
    """
    if found := MOODLE.fullmatch(stem):
        blind = found["name"] == "Participant"  # Moodle's name for everybody in anonymous submissions
        student = f"Participant {found['id']}" if blind else found["name"]
        return student, found["rest"], found["id"], False
    found = CANVAS.fullmatch(stem)
    if not found:
        return "", "", "", False
    if found["anonymous"]:
        return found["anonymous"], found["rest1"], found["anonymous"], bool(found["late1"])
    return f"{found['name']}_{found['id']}", found["rest"], found["id"], bool(found["late"])
