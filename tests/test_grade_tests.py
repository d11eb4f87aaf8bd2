"""Tests that students write, graded from outside: what they judge are stand-ins, whose answers come from the grader."""

import pytest
from hostile.build import SEED, SHORT, book, processes, traces
from toy_exercises import DOUBLE, TEST_LOG

from course_lib.pack.grade import notebook_file, submission
from course_lib.pack.grade.notebook_file import Course

IMPORTS = "import numpy as np\nfrom course_lib import rotations"
THOROUGH = """
def test_log(log):
    for w in ([0.1, 0.2, 0.3], [0, 0, np.pi], [1.5, -1.2, 0.8]):
        R = rotations.exp_so3(np.array(w))
        if not np.allclose(rotations.exp_so3(np.array(log(R))), R):
            return False
    return True
"""
RIGHT_DOUBLE = "def double(x):\n    return [2 * entry for entry in x]"


@pytest.fixture(autouse=True)
def course(monkeypatch):
    known = {"09_toys": Course("09_toys", "toys", (DOUBLE, TEST_LOG), ())}
    monkeypatch.setattr(notebook_file, "courses", lambda: known)
    monkeypatch.setattr(submission, "courses", lambda: known)


def graded(*cells):
    """{exercise: its row} of a submission with a right `double` and these cells."""
    before = processes(), traces()
    result = submission.grade(book(IMPORTS, RIGHT_DOUBLE, *cells), "09_toys", SEED, SHORT)
    assert (processes(), traces()) == before
    rows = {row["exercise"]: row for row in result["exercises"]}
    assert rows["double"]["points"] == 2, "another exercise suffers for it"
    return rows["test_log"]


def test_a_thorough_test_earns_all_points():
    row = graded(THOROUGH)
    assert (row["state"], row["points"]) == ("right", 4), row["message"]


def test_a_superficial_test_earns_a_part_and_the_message_names_what_slips_through():
    row = graded("def test_log(log):\n    return np.allclose(log(rotations.rot_z(0.5)), [0, 0, 0.5])")
    assert (row["state"], row["points"]) == ("wrong", 3)
    assert "one that is wrong only near half a turn" in row["message"]


ATTACKS = {
    "always True": "def test_log(log):\n    return True",
    "always False": "def test_log(log):\n    return False",
    "an answer for each number": "def test_log(log):\n    return log._number % 2 == 0",
    "one answer after the other": "turn = []\ndef test_log(log):\n    turn.append(1)\n    return len(turn) % 2 == 0",
    "what lies about in memory": """
import gc
def test_log(log):
    for thing in gc.get_objects():
        if type(thing).__name__ in ("Version", "WriteTest", "Verdict"):
            return thing.right
    return True
""",
    "the callers' variables": """
import sys
def test_log(log):
    frame = sys._getframe()
    while frame:
        for value in frame.f_locals.values():
            if hasattr(value, "right") or hasattr(value, "versions"):
                return value.right
        frame = frame.f_back
    return True
""",
    "a verdict of its own": """
import os
def test_log(log):
    for number in range(3, 30):
        try:
            os.write(number, b'{"exercise": "test_log", "reply": "right"}\\n')
        except OSError:
            pass
    return True
""",
    "another's number": """
def test_log(log):
    log._number = 0
    return np.allclose(log(rotations.rot_z(0.5)), [0, 0, 0.5])
""",
    "calls that are none": """
def test_log(log):
    for junk in ("", "[]", "{}", "[" * 5000, "x" * 10**6):
        log._consult(junk)
    return True
""",
    "calls without an end": """
def test_log(log):
    while True:
        try:
            log(np.eye(3))
        except ValueError:
            log._calls = 0
""",
    "asking and not listening": """
import os
def test_log(log):
    pipe = max(int(name) for name in os.listdir("/proc/self/fd") if int(name) < 200)
    for number in range(3, 40):
        try:
            os.write(number, b'?{"candidate": 0, "arguments": []}\\n' * 3000)
        except OSError:
            pass
    return True
""",
    "a stand-in of the library": """
import course_lib.rotations
def test_log(log):
    return log is course_lib.rotations.log_so3
""",
}


@pytest.mark.parametrize("attack", ATTACKS)
def test_what_tells_candidates_apart_by_anything_but_their_answers_earns_nothing_to_speak_of(attack, monkeypatch):
    monkeypatch.setattr(submission, "MOST_CALLS", 1000)  # so that calls without an end do not take long
    row = graded(ATTACKS[attack])
    assert row["state"] != "right", row
    assert row["points"] <= 1, row  # a guess may be lucky: on average it earns nothing


def test_candidates_answer_so_many_calls_and_no_more(monkeypatch):
    calls, reply = [], submission.Student.reply

    def counted(student, questions, consult=None):
        calls.append(0)

        def count(call):
            calls[-1] += 1
            return consult(call)

        return reply(student, questions, consult and count)

    monkeypatch.setattr(submission, "MOST_CALLS", 1000)
    monkeypatch.setattr(submission.Student, "reply", counted)
    graded(ATTACKS["calls without an end"])
    assert max(calls) == 1000
