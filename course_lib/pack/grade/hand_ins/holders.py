"""What holds the students' work in a folder: files and folders, each of which is one student's or
one group's."""

import fnmatch
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from course_lib.pack.grade import GradingStopped
from course_lib.pack.grade.csv_text import printable
from course_lib.pack.grade.hand_ins.platforms import HandIn, Platform, platforms
from course_lib.pack.grade.hand_ins.platforms.base import (
    READ,
    ending_of,
    entries,
    entries_inside,
    is_folder,
    plain_name,
)

EACH_ENTRY = "*"  # STUDENTS=*: each file and folder directly in the folder is one student's
# In place of the last * of a pattern: the names are logins or numbers, each of one student wherever
# it stands.
LOGIN = "login"
MAX_LEVELS = 10  # of folders in a pattern


@dataclass(frozen=True)
class Holder:
    """A file or folder that is one student's, or one group's.

    hand_ins: what a platform says of it, one for each student; empty if the name is the student's
    own. outside: why it holds nobody's work. parent: the folders between the folder of submissions
    and this, by which two students of the same name are told apart. by_login: whether the name is
    the student's login or number.
    """

    path: Path
    hand_ins: tuple[HandIn, ...] = ()
    outside: str = ""
    parent: str = ""
    by_login: bool = False


def holders_in(folder: Path, exporter: Platform, students: str) -> list[Holder]:
    """Return what holds the students' work in a folder."""
    if students not in ("", EACH_ENTRY):
        return _by_pattern(folder, students, exporter)
    always = [platform for platform in platforms().values() if not platform.asks]
    holders = {}
    for platform in [*always, exporter]:
        for path, hand_ins in platform.hand_ins(folder).items():
            holders[path] = Holder(path, tuple(hand_ins))
    inside = {folder / path.relative_to(folder).parts[0] for path in holders if path != folder}
    for path in entries(folder):
        own_files = any(platform.ignores(path) for platform in [*always, exporter])
        if path not in inside and not own_files:
            holders[path] = Holder(path)
    for top in sorted(inside - holders.keys()):
        for path in _beside(top, holders.keys()):
            if not exporter.ignores(path):
                reason = "It lies beside what the learning platform exports."
                holders[path] = Holder(path, outside=reason)
    return [holders[path] for path in sorted(holders)]


def _beside(top: Path, holders: Iterable[Path]) -> list[Path]:
    """Return the notebooks, zips and folders below a folder that are outside of all holders."""
    holders = set(holders)
    above = {parent for path in holders for parent in path.parents}
    outside = []
    for path in entries_inside(top):
        if path in holders:
            continue
        if path in above:
            outside += _beside(path, holders)
        elif is_folder(path) or ending_of(path.name) in READ:
            outside.append(path)
    return outside


def _by_pattern(folder: Path, pattern: str, exporter: Platform) -> list[Holder]:
    """Return what holds the students' work by a pattern such as */*; other files are outside."""
    *above, last = pattern.strip("/").split("/")
    by_login = last == LOGIN
    holders = []
    places = [folder]
    for level in above:
        inner = []
        for path in (path for place in places for path in entries_inside(place)):
            if is_folder(path) and fnmatch.fnmatchcase(path.name, level):
                inner.append(path)
            elif not exporter.ignores(path):
                holders.append(Holder(path, outside=f"It is not what STUDENTS={pattern} names."))
        places = inner
    for place in places:
        for path in entries_inside(place):
            if exporter.ignores(path):
                continue
            if not by_login and not fnmatch.fnmatchcase(path.name, last):
                holders.append(Holder(path, outside=f"It is not what STUDENTS={pattern} names."))
                continue
            hand_in = exporter.read_name(plain_name(path))
            parent = "" if place == folder else printable(place.relative_to(folder))
            hand_ins = (hand_in,) if hand_in else ()
            holders.append(Holder(path, hand_ins, parent=parent, by_login=by_login and not hand_in))
    return sorted(holders, key=lambda holder: holder.path)


def read_pattern(typed: str) -> str:
    """Return the pattern that was typed for STUDENTS=; raises GradingStopped if it is not one."""
    parts = typed.split("/")
    if typed and (len(parts) > MAX_LEVELS or "" in parts or {".", "..", "**"} & {*parts}):
        raise GradingStopped(
            f"STUDENTS={typed} is not a pattern: write * if each file and folder directly in the "
            "folder of submissions is one student's, */* if each in one of its folders is."
        )
    return typed
