"""Tests that students write, graded from outside: what they judge are stand-ins, whose answers come
from the grader.

A submission holds several of them, each for an exercise of its own, which no other may affect.
"""

import re
from dataclasses import replace

import numpy as np
import pytest
from hostile.build import SEED, SHORT, book, left_over, processes, traces
from toy_exercises import DOUBLE, TEST_LOG

from course_lib import rotations
from course_lib.checks.judge import LocalFunction, judge
from course_lib.checks.messages import describe
from course_lib.checks.verdict import ERROR, RIGHT
from course_lib.pack.grade.hand_ins import notebook_file
from course_lib.pack.grade.hand_ins.notebook_file import Course
from course_lib.pack.grade.verdicts import sandboxed_function, submission

pytestmark = pytest.mark.usefixtures("isolated")
BEGIN = (
    "import numpy as np\nfrom course_lib import rotations",
    "def double(x):\n    return [2 * entry for entry in x]",
)
THOROUGH = """
def test_log(log):
    for w in ([0.1, 0.2, 0.3], [0, 0, np.pi], [1.5, -1.2, 0.8]):
        R = rotations.exp_so3(np.array(w))
        if not np.allclose(rotations.exp_so3(np.array(log(R))), R):
            return False
    return True
"""


@pytest.fixture
def graded(monkeypatch):
    """Return a function that takes {name: the source of a test} and returns {name: its row}, of one
    submission."""

    def graded(tests, versions=TEST_LOG.versions, cpu_seconds=10):
        named = {f"test_log_{number}": name for number, name in enumerate(tests)}
        exercises = tuple(replace(TEST_LOG, name=exercise, versions=versions) for exercise in named)
        known = {"09_toys": Course("09_toys", "toys", (DOUBLE, *exercises), ())}
        monkeypatch.setattr(notebook_file, "courses", lambda: known)
        cells = [re.sub(r"\btest_log\b", each, tests[name]) for each, name in named.items()]
        before = processes(), traces()
        # A call of what is judged takes longer on a busy machine.
        limits = replace(SHORT, cpu_seconds=cpu_seconds)
        result = submission.grade(book(*BEGIN, *cells), "09_toys", SEED, limits)
        assert (left_over(before[0]), traces()) == (set(), before[1])
        double, *rows = result["exercises"]
        assert double["points"] == 2, "another exercise suffers for it"
        return {named[row["exercise"]]: row for row in rows}

    return graded


def test_a_test_earns_points_by_the_versions_it_judges_rightly(graded):
    often = "    for _ in range(1_000):\n        log(np.eye(3))\n    return True"
    rows = graded({
        "thorough": THOROUGH,
        "often": THOROUGH.replace("    return True", often),
        "without an end": "def test_log(log):\n    while True:\n        log(np.eye(3))",
        "superficial": (
            "def test_log(log):\n    return np.allclose(log(rotations.rot_z(0.5)), [0, 0, 0.5])"
        ),
    }, TEST_LOG.versions[:8])  # fmt: skip
    assert {name: (row["state"], row["points"]) for name, row in rows.items()} == {
        "thorough": ("right", 4),
        "often": ("right", 4),
        "without an end": ("error in your code", 0),
        "superficial": ("wrong", 1),
    }, rows
    calls = "more than 5,000 calls of the function that it tests."
    assert calls in rows["without an end"]["message"], "it is refused before its time is up"
    assert "one that is wrong only near half a turn" in rows["superficial"]["message"]


MANY_CALLS = """
def test_log(log):
    answers = [np.asarray(log(rotations.rot_z(0.5)), float) for _ in range(CALLS)]
    return bool(np.allclose(answers, [0, 0, 0.5]))
"""


def test_notebook_and_grading_count_calls_alike(graded):
    versions = (TEST_LOG.versions[0], TEST_LOG.versions[3])  # a right one and a wrong one
    tests = {calls: MANY_CALLS.replace("CALLS", str(calls)) for calls in (5_000, 5_001)}
    rows = graded(tests, versions)
    for calls, test in tests.items():
        notebook = {"np": np, "rotations": rotations}
        exec(test, notebook)
        verdict = judge(replace(TEST_LOG, versions=versions), LocalFunction(notebook["test_log"]))
        too_many = calls > 5_000
        assert verdict.state == (ERROR if too_many else RIGHT), calls
        assert (rows[calls]["state"], rows[calls]["points"]) == (verdict.state, verdict.points)
        for message in (describe(verdict), rows[calls]["message"]):
            assert ("more than 5,000 calls of the function" in message) == too_many, message


def test_the_calls_of_all_versions_together_are_not_bounded(graded, monkeypatch):
    monkeypatch.setattr(sandboxed_function, "MAX_CALLS_ANSWERED", 8)
    rows = graded({"three calls of each": THOROUGH}, TEST_LOG.versions[:4])
    assert rows["three calls of each"]["state"] == RIGHT, rows


SLOW = """
import time

def test_log(log):
    end = time.process_time() + 0.3
    while time.process_time() < end:
        pass
    return bool(np.allclose(log(rotations.rot_z(0.5)), [0, 0, 0.5]))
"""


def test_a_test_has_the_time_of_an_exercise_for_each_version(graded):
    rows = graded({"slow": SLOW}, TEST_LOG.versions[:6], cpu_seconds=1)
    assert rows["slow"]["state"] == RIGHT, rows


def test_an_endless_test_ends_after_its_first_version(graded, monkeypatch):
    asked, about_one = [], sandboxed_function.SandboxedFunction.about_one

    def counted(self, questions, number, *more):
        asked.append(number)
        return about_one(self, questions, number, *more)

    monkeypatch.setattr(sandboxed_function.SandboxedFunction, "about_one", counted)
    endless = "def test_log(log):\n    while True:\n        pass"
    rows = graded({"endless": endless}, cpu_seconds=1)
    assert rows["endless"]["state"] == ERROR
    assert "more than 1 seconds of computing" in rows["endless"]["message"], rows
    assert set(asked) == {0}


PLURALITY = """
import collections, fcntl, glob, json, mmap, os, resource, socket, subprocess, tempfile, time, zlib
R = rotations.exp_so3(np.array([0, 0, np.pi]))
shared = mmap.mmap(-1, 1 << 20)

def remember(log):
    {remember}

def test_log(log):
    try:
        mine = np.round(np.asarray(log(R), float), 6).tolist()
    except ValueError:
        mine = "raises"
    seen = remember(mine)
    most = collections.Counter(map(str, seen)).most_common(1)[0][0]
    return str(mine) == most
"""
# How a test may compare candidates with each other, on the way through something that outlives one
# call.
REMEMBERS = {
    "in a list": "seen.append(log)\n    return seen\nseen = []",
    "in a folder of its own": (
        "place = tempfile.gettempdir() + '/a/b'\n    os.makedirs(place, exist_ok=True)\n"
        "    open(place + '/seen', 'a').write(json.dumps(log) + chr(10))\n"
        "    return [json.loads(line) for line in open(place + '/seen')]"
    ),
    "in memory that all children share": (
        "end = shared.find(b'\\0')\n    text = json.dumps(log).encode() + b';'\n"
        "    shared[end : end + len(text)] = text\n"
        "    return [json.loads(part) for part in shared[: end + len(text)].split(b';')[:-1]]"
    ),
    "by asking for another's number": (
        "return others\nothers = []\nimport course_lib.checks.call_student as c\nreal ="
        " c._StandIn.__call__\ndef call(self, *arguments):\n    others.clear()\n    mine ="
        " self._number\n    for self._number in range(9):\n        try:\n           "
        " others.append(np.round(np.asarray(real(self, *arguments), float), 6).tolist())\n       "
        " except ValueError:\n            pass\n    self._number = mine\n    return real(self,"
        " *arguments)\nc._StandIn.__call__ = call"
    ),
    "in a process that stays": (
        "import socket\n    name = chr(0) + 'seen'\n    try:\n        one ="
        " socket.socket(socket.AF_UNIX)\n        one.connect(name)\n    except OSError:\n        if"
        " os.fork() == 0:\n            os.setsid()\n            server ="
        " socket.socket(socket.AF_UNIX)\n            server.bind(name)\n           "
        " server.listen()\n            kept = []\n            while True:\n                c, _ ="
        " server.accept()\n                kept.append(json.loads(c.recv(4000)))\n               "
        " c.sendall(json.dumps(kept).encode())\n                c.close()\n       "
        " time.sleep(0.3)\n        one = socket.socket(socket.AF_UNIX)\n        one.connect(name)\n"
        "    one.sendall(json.dumps(log).encode())\n    return json.loads(one.recv(100000))"
    ),
    "in ports that wait, and outlive their process": (
        """
    seen, own = [], 20_000 + zlib.crc32(str(log).encode()) % 16
    for port in range(20_000, 20_016):
        try:
            socket.socket().bind(("127.0.0.1", port))
        except OSError:
            seen.append(log if port == own else port)
    if not seen:
        server = socket.create_server(("127.0.0.1", own))
        client = socket.create_connection(("127.0.0.1", own))
        server.accept()[0].close()
        time.sleep(0.05)
        client.close()
    return seen or [log]
"""
    ),
    "in locks that a process holds on files of Python": (
        """
    number, seen, files = 0, [], sorted(glob.glob(os.path.dirname(os.__file__) + "/*.py"))
    try:  # the parent's limit counts the candidates
        limit, most = resource.prlimit(os.getppid(), resource.RLIMIT_NOFILE)
        resource.prlimit(os.getppid(), resource.RLIMIT_NOFILE, (limit - 1, most))
        number = most - limit
        if os.fork() == 0:
            fcntl.flock(os.open(files[number * 16 + zlib.crc32(str(log).encode()) % 16], 0), fcntl.LOCK_EX)
            time.sleep(600)
        time.sleep(0.3)
        for place, file in enumerate(files[:160]):
            try:
                fcntl.flock(os.open(file, 0), fcntl.LOCK_SH | fcntl.LOCK_NB)
            except BlockingIOError:
                seen.append(log if place % 16 == zlib.crc32(str(log).encode()) % 16 else place % 16)
    except OSError:
        pass
    return seen or [log]
"""
    ),
}


ALL = "by asking for another's number"  # this one spoils the calls of all tests beside it


@pytest.mark.parametrize(
    "ways", [[ALL], [way for way in REMEMBERS if way != ALL]], ids=["by number", "by the others"]
)
def test_candidates_cannot_be_compared_with_each_other(graded, ways):
    tests = {way: PLURALITY.replace("{remember}", REMEMBERS[way]) for way in ways}
    for number, way in enumerate(ways):  # each has its own names
        tests[way] = re.sub(
            r"\b(remember|shared|R|seen|others|real|call)\b", rf"\1_{number}", tests[way]
        )
    right, another, _, wrong, *_ = TEST_LOG.versions  # few, for each has a sandbox of its own
    rows = graded(tests, (right, another, wrong))
    assert {way: (row["state"], row["points"]) for way, row in rows.items()} == dict.fromkeys(
        ways, ("wrong", 0)
    ), rows


ATTACKS = {
    "always True": "def test_log(log):\n    return True",
    "always False": "def test_log(log):\n    return False",
    "an answer for each number": "def test_log(log):\n    return log._number % 2 == 0",
    "one answer after the other": (
        "turn = []\ndef test_log(log):\n    turn.append(1)\n    return len(turn) % 2 == 0"
    ),
    "what lies about in memory": (
        """
import gc
def test_log(log):
    for thing in gc.get_objects():
        if type(thing).__name__ in ("Version", "WriteTest", "Verdict"):
            return thing.right
    return True
"""
    ),
    "the callers' variables": (
        """
import sys
def test_log(log):
    frame = sys._getframe()
    while frame:
        for value in frame.f_locals.values():
            if hasattr(value, "right") or hasattr(value, "versions"):
                return value.right
        frame = frame.f_back
    return True
"""
    ),
    "a verdict of its own": (
        """
import os
def test_log(log):
    for number in range(3, 30):
        try:
            os.write(number, b'{"exercise": "test_log", "reply": "right"}\\n')
        except OSError:
            pass
    return True
"""
    ),
    "another's number": (
        """
def test_log(log):
    log._number = 0
    return np.allclose(log(rotations.rot_z(0.5)), [0, 0, 0.5])
"""
    ),
    "calls that are none": (
        """
def test_log(log):
    for junk in ("", "[]", "{}", "[" * 5000, "x" * 10**6):
        log._consult(junk)
    return True
"""
    ),
    "calls without an end": (
        """
def test_log(log):
    while True:
        try:
            log(np.eye(3))
        except BaseException:
            log._calls = 0
"""
    ),
    "asking and not listening": (
        """
import os
def test_log(log):
    pipe = max(int(name) for name in os.listdir("/proc/self/fd") if int(name) < 200)
    for number in range(3, 40):
        try:
            os.write(number, b'?{"candidate": 0, "arguments": []}\\n' * 3000)
        except OSError:
            pass
    return True
"""
    ),
    "a stand-in of the library": (
        """
import course_lib.rotations
def test_log(log):
    return log is course_lib.rotations.log_so3
"""
    ),
}


def test_an_attack_on_the_versions_earns_next_to_nothing(graded, monkeypatch):
    """An attack distinguishes versions by anything but their answers."""
    monkeypatch.setattr(
        sandboxed_function, "MAX_CALLS_ANSWERED", 1000
    )  # so that calls without an end do not take long
    rows = graded(ATTACKS)
    assert {name: row for name, row in rows.items() if row["state"] == "right"} == {}
    assert {name: row for name, row in rows.items() if row["points"] > 1} == {}, (
        "a guess may be lucky, and earn 1"
    )
