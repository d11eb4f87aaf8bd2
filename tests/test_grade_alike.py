"""Pairs that are alike: a disguised copy is found, what the task or the library forces is not
named, nothing judges."""

import json
import os

import pytest
from course_copy import ROOT
from hostile.build import book

from course_lib.pack.grade.hand_ins.collect import find
from course_lib.pack.grade.marks import alike
from course_lib.pack.grade.marks.alike import (
    Work,
    alike_page,
    copies,
    earlier_works,
    pairs,
    write_alike,
)

NOTEBOOK = "01_rotations"
OWN = """
def nearest_so(M):
    left, stretch, right = np.linalg.svd(np.array(M, dtype=float))
    flips = [1.0] * (len(stretch) - 1) + [round(np.linalg.det(left) * np.linalg.det(right))]
    total = np.zeros_like(left)
    for k, sign in enumerate(flips):  # one rank after the other
        total = total + sign * np.outer(left[:, k], right[k])
    if abs(np.linalg.det(total) - 1) > 1e-9:
        raise ValueError("no rotation")
    return total
"""
DISGUISED = (
    OWN.replace("left", "a").replace("right", "b").replace("stretch", "s").replace("total", "R")
)
DISGUISED = DISGUISED.replace("  # one rank after the other", "").replace("no rotation", "error")
OTHER = """
def nearest_so(M):
    R = scipy.linalg.polar(M)[0]
    while np.linalg.det(R) < 0:
        w, v = np.linalg.eigh(M.T @ M)
        R = R - 2 * R @ v[:, :1] @ v[:, :1].T
    return R
"""


def work(student, *cells, year=""):
    return Work(student, NOTEBOOK, cells, year)


def named(*works):
    return [(one.student, other.student) for _, one, other, _ in pairs(works)]


def test_a_disguised_copy_is_found_wherever_it_stands():
    """An honest answer makes no pair."""
    assert named(work("anna", "x = 1", OWN), work("bo", DISGUISED, "y = 2"), work("cy", OTHER)) == [
        ("anna", "bo")
    ]


def test_what_many_students_have_comes_from_the_task(monkeypatch):
    everyone = [work(f"s{i}", OWN) for i in range(3)]
    assert len(named(*everyone)) == 3
    monkeypatch.setattr(alike, "MAX_STUDENTS", 2)
    assert named(*everyone) == []


def test_copies_of_the_course_s_own_code_make_no_pair():
    given = json.loads((ROOT / f"notebooks/{NOTEBOOK}.ipynb").read_text())["cells"]
    cells = ["".join(cell["source"]) for cell in given if cell["cell_type"] == "code"]
    library = (ROOT / "course_lib/rotations.py").read_text()
    everyone = [
        work("anna", *cells),
        work("bo", *cells),
        work("cy", library),
        work("di", library),
        work("eve", OTHER),
    ]
    assert named(*everyone) == []
    found = {(student, source) for student, _, source, _ in copies(everyone)}
    assert {(s, f"the solutions of {NOTEBOOK}") for s in ("anna", "bo")} <= found
    assert {(s, "course_lib/rotations.py") for s in ("cy", "di")} <= found
    assert "eve" not in {student for student, _ in found}


@pytest.mark.parametrize("place", ["", "2025/"])
def test_earlier_years_are_compared_and_not_with_each_other(tmp_path, place):
    for name in ("uma", "viv"):
        path = tmp_path / f"{place}{name}/{NOTEBOOK}.ipynb"
        path.parent.mkdir(parents=True)
        path.write_bytes(book(OWN))
    earlier = earlier_works(tmp_path)
    assert sorted(named(work("anna", DISGUISED), work("uma", OTHER), *earlier)) == [
        ("anna", "uma"),
        ("anna", "viv"),
    ]
    assert f"anna and uma ({'2025' if place else tmp_path.name})" in alike_page(
        [work("anna", DISGUISED), *earlier]
    )


def test_the_page_is_rewritten_only_when_a_submission_changes(tmp_path, monkeypatch):
    for name, source in (("anna", OWN), ("bo", DISGUISED)):
        (tmp_path / "in" / name).mkdir(parents=True)
        (tmp_path / f"in/{name}/{NOTEBOOK}.ipynb").write_bytes(book(source))
    path = tmp_path / "alike.html"
    write_alike(path, find(tmp_path / "in", [NOTEBOOK]))
    assert "anna and bo" in path.read_text()
    monkeypatch.setattr(alike, "MIN_SCORE", 10**6)
    write_alike(path, find(tmp_path / "in", [NOTEBOOK]))
    assert "anna and bo" in path.read_text()
    os.utime(tmp_path / f"in/bo/{NOTEBOOK}.ipynb", (5, 5))
    write_alike(path, find(tmp_path / "in", [NOTEBOOK]))
    assert "No pair is alike." in path.read_text()


def test_the_page_marks_what_both_have_without_a_verdict():
    """Names and code are escaped."""
    page = alike_page(
        [work("<b>anna", OWN), work("bo", DISGUISED.replace("error", "</pre><script>"))]
    )
    assert "&lt;b&gt;anna and bo" in page
    assert "<script>" not in page
    assert page.count("<mark>") == page.count("</mark>") == 2
    assert "for you to judge" in page
    assert "plagiar" not in page.lower()
    assert "No pair is alike." in alike_page([work("anna", OWN)])
