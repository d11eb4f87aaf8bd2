"""Whether a folder that should be one student's holds the work of others: what its names say.

A class is often one folder deeper than expected: in a folder of a section, of an assignment, or of
an export that was unpacked. Then names of people stand at the first level at which the paths of the
notebooks differ, or the folder itself bears no person's name. It is a guess, so it only leads to a
question.
"""

import re
from collections.abc import Callable, Sequence
from pathlib import Path

from course_lib.pack.grade.csv_text import words

# Words in the names of folders and files that are of no person: what one student's folder holds.
WORDS = """
again all answer answers archive assignment assignments attempt backup basic book books class copy
autumn course data desktop document documents done download downloads draft ex exercise exercises
file files final finished first fixed fall folder group handin home homework hw ipynb kinematics
lab last late latest lesson main more my new notebook notebooks of old original other others own
part project projects ps resubmission robot robotics robots second section semester session sheet
solution solutions src spring student students submission submissions submit submitted summer task
tasks team temp term test the third tmp trial tutorial untitled update updated v version week work
working winter workspace year zip
"""
OF_NOBODY = set(WORDS.split())
# Names of students without a name: student7, or a number that is no year.
STUDENT = re.compile(
    r"(?:student|user|participant)[ _-]?\d|(?<!\d)(?!(?:19|20)\d\d(?!\d))\d{3}", re.IGNORECASE
)
MIN_NUMBER = 5  # digits from which a number may be a student's


def owners(
    inside: Sequence[Path], own: str, split: Callable[[str], tuple[str, str]]
) -> tuple[list[str], int]:
    """Return the names of people in the paths of a folder's notebooks, and how deep below it they
    stand.

    Both are empty (0) if there are fewer than two names at every level, or fewer than one if the
    folder itself bears no person's name. inside: the paths below the folder. own: its name, whose
    words are no other person's. split: returns (student, notebook) of a file's name without its
    ending.
    """
    ours = set(words(own).split()) | OF_NOBODY
    own_person = _person(own, split) or STUDENT.search(own)
    enough = 2 if own_person else 1
    for level in range(max((len(path.parts) for path in inside), default=0)):
        names: dict[str, str] = {}
        for path in inside:
            if level < len(path.parts):
                label = path.parts[level]
                if level == len(path.parts) - 1:  # the file itself
                    label = split(path.stem)[0]
                person = _person(label, split) - ours
                if person:
                    names.setdefault(" ".join(sorted(person)), label)
        if len(names) >= enough:
            return sorted(names.values()), level + 1
    return [], 0


def _person(label: str, split: Callable[[str], tuple[str, str]]) -> set[str]:
    """Return the words of a name that may be a person's."""
    notebook = split(label)[1]
    of_notebook = set(words(notebook).replace("_", " ").split()) | {words(notebook)}
    person = set()
    for word in words(label.replace("_", " ")).split():
        stem = word.rstrip("0123456789")
        is_number = word.isdecimal() and len(word) >= MIN_NUMBER
        is_release = bool(re.fullmatch(r"(?=.*\d)[0-9a-f]{6,}", word)) and not word.isdecimal()
        is_letter = len(stem) < 2 and stem.isascii()
        if is_number or not (is_letter or is_release or stem in OF_NOBODY | of_notebook):
            person.add(word)
    return person
