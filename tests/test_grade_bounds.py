"""What a submission may cost outside its sandbox: processor time and memory are bounded there
too."""

import ast
import base64
import json
import os
import resource
import signal
import subprocess
import sys
import time

import pytest
from hostile.build import FULL, NAME, SEED, SHORT, book, points

from course_lib.pack.grade.bounded import OutOfBounds, call_bounded
from course_lib.pack.grade.hand_ins import notebook_file
from course_lib.pack.grade.hand_ins.notebook_file import UNREADABLE, code, defines, read
from course_lib.pack.grade.jail import runner, sandbox
from course_lib.pack.grade.verdicts import grading, judging
from course_lib.pack.grade.verdicts.grading import Grading
from course_lib.pack.grade.verdicts.result import row_of
from course_lib.pack.grade.verdicts.sandboxed_function import SandboxedFunction
from course_lib.pack.grade.verdicts.submission import grade

# ---- a process of its own ----


def busy(seconds):
    while time.process_time() < seconds:
        pass


ENDS = [
    (lambda: 1 / 0, {}, "ZeroDivisionError: division by zero"),
    (
        lambda: busy(time.process_time() + 100),
        {"cpu_seconds": 1},
        "more than 1 seconds of computing",
    ),
    (
        lambda: len(bytearray(2 * 10**9)),
        {"memory": 10**9},
        "MemoryError|process that graded it ended",
    ),
    (lambda: os.kill(os.getpid(), signal.SIGTERM), {}, r"ended \(exit status -15\)"),
    (lambda: time.sleep(100), {"clock_seconds": 1}, "not done after 1 seconds"),
]


@pytest.mark.parametrize(
    ("function", "bounds", "words"), ENDS, ids=["raises", "cpu", "memory", "killed", "clock"]
)
def test_the_end_of_the_process_is_reported(function, bounds, words):
    with pytest.raises((OutOfBounds, RuntimeError), match=words):
        call_bounded(function, **bounds)


def test_a_process_that_ends_while_it_is_watched_ends_no_watch():
    with subprocess.Popen([sys.executable, "-c", ""]) as process:
        pass
    assert sandbox._below(process.pid) == [process.pid]
    assert sandbox._used(process.pid) is None
    assert sandbox._delay(process.pid) == 0
    assert sandbox._share_of_memory(process.pid) == 0


# ---- files ----

LONG_NUMBER = "9" * 5000


def test_a_notebook_with_numbers_of_any_length_is_read():
    text = (
        book("x = 1", metadata={"x": "NUMBER"})
        .decode()
        .replace('"NUMBER"', f"[{LONG_NUMBER}, 0.{LONG_NUMBER}]")
    )
    assert code(read(text.encode())[0]) == ["x = 1"]


def test_a_file_of_too_many_parts_is_refused_before_parsing():
    content = ('{"cells": [' + ",".join(["[]"] * 6_000_000) + "]}").encode()
    begin = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    result = grade(content, NAME, SEED)
    assert "far more than a notebook does" in result["problems"][0]
    assert {row["state"] for row in result["exercises"]} == {UNREADABLE}
    assert (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - begin) < 100_000


@pytest.mark.parametrize(
    "unit",
    [
        "import x ",
        "x=",
        "\n",
        " ",
        "import ",
        "helper ",
        "for helper ",
        "\t\n",
        "def helperx ",
        "=helper ",
    ],
)
def test_a_search_for_names_in_a_text_of_any_kind_ends(unit):
    call_bounded(defines, [unit * (1_600_000 // len(unit))], "helper", cpu_seconds=60)


# ---- calls of candidates ----


def test_the_calls_of_a_test_do_not_count_as_its_answer():
    """A test may call its candidates some thousand times, which is more text than any answer
    has."""
    from_child, to_parent = os.pipe()
    from_parent, to_child = os.pipe()
    os.set_blocking(to_child, False)
    os.write(to_parent, (b"?" + b"x" * 1000 + b"\n") * 20 + b"the reply\n")
    passed_on = []
    text, reason = runner.read_reply(
        from_child, to_child, 5_000, lambda call: passed_on.append(call) or "answered"
    )
    assert (text, reason, len(passed_on)) == ("the reply\n", "", 20)
    assert os.read(from_parent, 1 << 16) == b"answered\n" * 20
    for pipe in (from_child, to_parent, from_parent, to_child):
        os.close(pipe)


def test_an_answer_that_is_too_long_is_cut_all_the_same():
    from_child, to_parent = os.pipe()
    os.write(to_parent, b"x" * 20_000)
    _, reason = runner.read_reply(from_child, to_parent, 5_000, None)
    assert reason == runner.TOO_LONG
    os.close(from_child)
    os.close(to_parent)


# ---- claims ----


class Claims:
    """A sandbox in which the student's code controls the runner and replies as it likes."""

    def __init__(self, reply):
        self._reply, self._asked = reply, {}

    def send(self, message, watch):
        self._asked = message

    def watch(self, *bounds):
        return bounds

    def receive(self, watch):
        count = len(json.loads(self._asked["questions"])["dict"][0][1]["list"])
        return {"exercise": self._asked["ask"], "reply": self._reply(count)}


def colliding(count):
    pairs = ",".join(f"[{(2**61 - 1) * k}, 0]" for k in range(1, 8_000))
    return answers(count, '{"dict": [' + pairs + "]}")


def answers(count, value):
    one = f'{{"value": {value}, "changed": []}}'
    return f'{{"answers": [{", ".join([one] * count)}], "calls": []}}'


def array(shape, data=b""):
    return json.dumps({"array": "<f8", "shape": shape, "bytes": base64.b64encode(data).decode()})


CLAIMS = {
    "a long number": lambda count: answers(count, "9" * 4300),
    "a longer number": lambda count: answers(count, LONG_NUMBER),
    "a number beyond floats": lambda count: answers(count, "1" + "0" * 400),
    "keys of one hash": colliding,
    "a shape of large numbers": lambda count: answers(count, array([10**300] * 5000)),
    "nested": lambda count: answers(count, "[" * 50_000 + "]" * 50_000),
    "lists in lists": lambda count: answers(count, '{"list": [' * 11 + "1" + "]}" * 11),
    "lists of long numbers": lambda count: answers(
        count, '{"list": [' + ",".join(["9" * 4000] * 50) + "]}"
    ),
    "positions": lambda count: (
        '{"answers": [' + ",".join(['{"value": 1, "changed": [1e308]}'] * count) + '], "calls": []}'
    ),
    "calls": lambda count: answers(count, "1").replace(
        '"calls": []', '"calls": [' + "9" * 4000 + "]"
    ),
}


@pytest.mark.parametrize("claim", CLAIMS)
def test_any_claim_of_a_hijacked_process_becomes_a_verdict(claim, few):
    one = Grading([], SHORT, SEED, (), None)

    def row(exercise):
        function = SandboxedFunction(Claims(CLAIMS[claim]), one, exercise)
        return row_of(exercise, judging.ask_and_judge(one, function, {}))

    for exercise in (
        each
        for each in notebook_file.courses()[NAME].exercises
        if each.name in ("is_valid", "nearest_so")
    ):
        earned = call_bounded(row, exercise, cpu_seconds=60)["points"]
        assert earned < exercise.points or claim == "lists in lists"


PRINTS = {
    "in a cell": "while True:\n    print('y' * 10_000)",
    "in what is needed": (
        "k = 0\nwhile True:\n    k += 1\n    print('y' * 10_000)\ndef nearest_so(M): k; return M"
    ),
    "to stderr": "import sys\nwhile True:\n    print('y' * 10_000, file=sys.stderr)",
}


@pytest.mark.parametrize("place", PRINTS)
def test_a_cell_that_prints_without_end_is_ended(place, few):
    first, right = few
    broken = "def nearest_so(M):\n    return missing"  # so that the whole notebook runs
    result = grade(book(first, *right, broken, PRINTS[place]), NAME, SEED)
    assert result["problems"] == [
        f"Code cell {len(right) + 3} was left out: it printed more than a notebook can hold."
    ]
    assert sorted(row["state"] == "right" for row in result["exercises"]) == [
        False,
        True,
        True,
        True,
    ]


def test_endless_judging_is_stopped_for_that_exercise_only(few, monkeypatch):
    judged = judging.judged

    def endless(exercise, *rest):
        if exercise.name == "nearest_so":
            busy(time.process_time() + 100)
        return judged(exercise, *rest)

    monkeypatch.setattr(judging, "judged", endless)
    monkeypatch.setattr(judging, "JUDGING_SECONDS", 0.5)
    result = grade(book(few[0], *few[1]), NAME, SEED)
    said = {row["exercise"]: row["message"] for row in result["exercises"]}["nearest_so"]
    assert said == "Its answers cannot be judged: that takes more than 0.5 seconds of computing."
    assert points(result) == FULL - 3
    assert signal.getitimer(signal.ITIMER_PROF) == (0, 0)


# ---- what costs the grader time ----


def test_too_many_statements_are_refused_before_parsing(monkeypatch):
    notebook_file.courses()  # which parses the course's own code
    parsed = []
    with monkeypatch.context() as while_grading:
        while_grading.setattr(ast, "parse", lambda *arguments, **options: parsed.append(arguments))
        result = grade(book("x = 1\n" * 150_000), NAME, SEED)
    assert "more than 50,000 lines" in result["problems"][0]
    assert parsed == []


FLOOD = """
import os

def flood():
    while True:
        for pipe in range(3, 40):
            try:
                os.write(pipe, b'{}\\n' * 20_000)
            except OSError:
                pass

def nearest_so(M, given=flood()):
    return M
"""


def test_a_flood_of_the_pipe_costs_the_grader_a_bounded_time(few, monkeypatch):
    monkeypatch.setattr(sandbox, "READING_SECONDS", 0.5)
    monkeypatch.setattr(grading, "MAX_READING_SECONDS", 1)
    result = call_bounded(grade, book(few[0], FLOOD), NAME, SEED, SHORT, cpu_seconds=60)
    assert points(result) == 0
    assert "it wrote too much" in " ".join(result["problems"])
