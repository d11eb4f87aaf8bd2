"""Submissions that try to forge points or do damage: each gets a reason, and nothing else
changes."""

import os
import resource

import pytest
from hostile import build
from hostile.build import NAMES, OTHERS, PROJECT, SEED, SHORT, book, said, sources

from course_lib.pack.grade.verdicts.submission import grade


@pytest.fixture
def graders(tmp_path):
    """A folder such as a grader has, with another student's work and results."""
    for place in (
        "grades.csv",
        "in/other/01_rotations.ipynb",
        "build/grades/feedback/other/01_rotations.html",
    ):
        file = tmp_path / place
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text("as the grader left it")
        file.chmod(0o666)
    return tmp_path


def computed():
    """Return the processor time of this process and of the sandboxes that have ended."""
    usages = [
        resource.getrusage(whose) for whose in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    ]
    return sum(usage.ru_utime + usage.ru_stime for usage in usages)


def contents(folder):
    """What the folder holds, and whether something was left where a submission might write."""
    found = {str(path): path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    for place in (folder, PROJECT, "/", "/tmp", "/var/tmp", "/etc", os.path.expanduser("~")):
        found[f"in {place}"] = {"HOSTILE", "grades.csv"} & set(os.listdir(place))
    return found


@pytest.mark.parametrize("name", NAMES)
def test_a_hostile_submission_earns_and_changes_nothing(name, few, graders):
    first, right = few
    others = [source for source in right if "def nearest_so(" not in source]
    before, folders, files, begin = build.processes(), build.traces(), contents(graders), computed()
    cells = [first, *sources(name, graders), *others]
    if said(name, "others"):
        cells = [
            first,
            *others,
            *(f"check.{other}({other})" for other in OTHERS),
            *cells[1 : -len(others)],
        ]
    result = grade(book(*cells), "01_rotations", SEED, SHORT)
    rows = {row["exercise"]: row for row in result["exercises"]}
    row, earns = rows["nearest_so"], said(name, "says") == "earns"
    assert row["points"] == (3 if earns else 0), str(row)
    assert earns or (row["state"] not in ("right", "not attempted yet") and row["message"]), row
    assert earns or said(name, "says") in row["message"] + row["mistake"], row
    assert said(name, "problem") in " ".join(result["problems"]), result["problems"]
    assert {o: rows[o]["points"] for o in OTHERS} == {o: rows[o]["of"] for o in OTHERS}, [
        rows[o] for o in OTHERS
    ]
    assert (
        sum(r["points"] for r in rows.values())
        == sum(rows[o]["of"] for o in OTHERS) + row["points"]
    )
    assert computed() - begin < 60
    assert not build.left_over(before)
    assert build.traces() <= folders
    assert contents(graders) == files
