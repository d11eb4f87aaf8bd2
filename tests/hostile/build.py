"""Notebooks as students hand them in, made from the course's own and from the sources in this
folder.

Each text beside this file holds the code cells of a submission, between lines of "# %%". Its head
tells what the message to its student is to say, or "earns" where the answer is right, which problem
with the notebook is told, and whether the student's other answers stand before it, as it spoils
what they use in Jupyter too.
"""

import json
import os
import tempfile
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

from grade_stand_in import wait_for

from course_lib.pack.grade.hand_ins import notebook_file
from course_lib.pack.grade.hand_ins.notebook_file import courses
from course_lib.pack.grade.jail.sandbox import Limits

HERE = Path(__file__).parent
PROJECT = HERE.parent.parent
SEED = 7741
SHORT = Limits(cpu_seconds=1, cell_cpu_seconds=1, idle_seconds=4, everything=1_000_000_000)


def cell(source, kind="code", **about):
    return {"cell_type": kind, "source": source, "metadata": {}} | about


def book(*sources, **about):
    """Return the bytes of a notebook with code cells of these sources."""
    whole = {
        "cells": [cell(source) for source in sources],
        "metadata": {},
        "nbformat": 4,
        "nbformat_minor": 5,
    }
    return json.dumps(whole | about).encode()


def sources(name, project=PROJECT):
    """Return the code cells of a hostile submission; project: the folder of the grader's that it
    looks for."""
    text = (HERE / f"{name}.txt").read_text(encoding="utf-8")
    text = "\n".join(
        line
        for line in text.splitlines()
        if not line.startswith(("# says", "# problem", "# others"))
    )
    return [
        part.strip()
        for part in text.replace("PROJECT", repr(str(project)))
        .replace("COURSE", repr(str(PROJECT)))
        .split("# %%")
    ]


def said(name, key):
    """Return what the head of a hostile submission says: what the message is to hold, which problem
    is told."""
    lines = (HERE / f"{name}.txt").read_text(encoding="utf-8").splitlines()[:2]
    return next((line.partition(": ")[2] for line in lines if line.startswith(f"# {key}:")), "")


NAMES = sorted(path.stem for path in HERE.glob("*.txt"))


def processes():
    """The first processes of sandboxes that this one started: no other can outlive them."""
    found = set()
    for name in filter(str.isdigit, os.listdir("/proc")):
        try:
            command = Path("/proc", name, "cmdline").read_bytes()
        except OSError:
            continue
        if f"grade-{os.getpid()}-".encode() in command:
            found.add(int(name))
    return found


def left_over(before):
    """The processes of sandboxes beyond those before, once those that were killed have had time to
    end."""
    with suppress(AssertionError):
        wait_for(lambda: not processes() - before)
    return processes() - before


def traces():
    """The folders of sandboxes that are there."""
    return set(Path(tempfile.gettempdir()).glob(f"grade-{os.getpid()}-*"))


NAME = "01_rotations"
OTHERS = ("is_valid", "matrix_to_quaternion", "nearest_se")  # answered right beside the hostile one
FULL = 3 + 3 + 2 + 3  # what these and nearest_so earn
NEAREST_SE = """
def nearest_se(T):
    corrected = np.eye(len(T))
    U, _, Vt = np.linalg.svd(T[:-1, :-1])
    U[:, -1] *= np.linalg.det(U @ Vt)
    corrected[:-1, :-1] = U @ Vt
    corrected[:-1, -1] = T[:-1, -1]
    return corrected
"""


def few_exercises(monkeypatch):
    """The first notebook with four of its exercises, for what is run many times."""
    course = courses()[NAME]
    few = tuple(each for each in course.exercises if each.name in (*OTHERS, "nearest_so"))
    known = {course.name: replace(course, exercises=few)}
    monkeypatch.setattr(notebook_file, "courses", lambda: known)


def answers(solutions):
    """The cell with the imports, {exercise: the cell with its right answer} of these four."""
    first, *rest = solutions(NAME)
    found = {
        name: source
        for source in rest
        for name in (*OTHERS, "nearest_so")
        if f"def {name}(" in source
    }
    return first, found | {"nearest_se": NEAREST_SE}


def points(result):
    """What a graded submission earns."""
    return sum(row["points"] for row in result["exercises"])
