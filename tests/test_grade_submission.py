"""The points of one submission: only the student's function counts, whatever program wrote the
file."""

import ast
import importlib
import random
import re
from dataclasses import replace

import nbformat
import pytest
from hostile.build import FULL, NAME, SEED, SHORT, book, cell, points

from course_lib.pack.grade.hand_ins import notebook_file
from course_lib.pack.grade.hand_ins.notebook_file import NOTEBOOKS, UNREADABLE, courses
from course_lib.pack.grade.verdicts import notebook_run, submission
from course_lib.pack.grade.verdicts.notebook_run import sandbox_files
from course_lib.pack.grade.verdicts.submission import grade
from course_lib.pack.release.stubs import students_copy

pytestmark = pytest.mark.usefixtures("isolated")


def states(result):
    return {row["exercise"]: row["state"] for row in result["exercises"]}


def messages(result):
    return {row["exercise"]: row["message"] for row in result["exercises"]}


# ---- as the course has them ----


@pytest.mark.parametrize("name", courses())
def test_all_solutions_of_a_notebook_earn_all_points(name, monkeypatch):
    if name != NAME:  # a sandbox for each candidate of a test takes time: one notebook has them
        monkeypatch.setattr(notebook_run, "ask_separately", lambda run, outcome, *rest: outcome)
    result = grade((NOTEBOOKS / f"{name}.ipynb").read_bytes(), name, SEED)
    assert set(states(result).values()) == {"right"}, result
    assert points(result) == sum(exercise.points for exercise in courses()[name].exercises)
    assert all(question["text"] and question["of"] for question in result["questions"])
    assert result["notebook"] == name


@pytest.mark.parametrize("name", courses())
def test_grading_has_what_a_notebook_imports_of_the_course(name, solutions):
    modules = {
        path.removesuffix("/__init__.py").removesuffix(".py").replace("/", ".")
        for path in sandbox_files(frozenset())
    }
    imported = [
        node for node in ast.walk(ast.parse(solutions(name)[0])) if isinstance(node, ast.ImportFrom)
    ]
    assert {node.module for node in imported if node.module.startswith("course_lib")} <= modules


def test_the_students_copy_as_released_is_not_attempted_yet():
    text = students_copy((NOTEBOOKS / f"{NAME}.ipynb").read_text(), NAME, "0.1.0-abcd")
    result = grade(text.encode(), NAME, SEED)
    bugs = {each.name for each in courses()[NAME].exercises if each.broken}
    assert {
        name for name, state in states(result).items() if state == "the bug is still there"
    } == bugs
    assert {state for name, state in states(result).items() if name not in bugs} == {
        "not attempted yet"
    }
    assert points(result) == 0
    assert result["release"] == "0.1.0-abcd"
    assert {question["text"] for question in result["questions"]} == {""}
    assert result["problems"] == []


# ---- as other programs and students change them ----


def split(first, rest):
    return [line for source in [first, *rest] for line in source.partition("\n\n")[::2]]


STUB, ATTEMPT = (
    "def nearest_so(M):\n    raise NotImplementedError\n",
    "def nearest_so(M):\n    return M\n",
)
RENAMED = "mine = nearest_so\nnearest_so = lambda M: mine(M)"
CHANGES = {
    "merged into one": lambda first, rest: ["\n\n".join([first, *rest])],
    "split": split,
    "moved and duplicated": lambda first, rest: (
        random.Random(1).sample([first, *rest], len(rest) + 1) + rest
    ),
    "an earlier attempt, a cell that raises, an exec, stubs left below": lambda first, rest: [
        *(first, ATTEMPT, "1 / 0\n" + rest[0], f"exec({rest[1]!r})", *rest[2:], STUB)
    ],
    "another name": lambda first, rest: [first, *rest, RENAMED],
}


@pytest.mark.parametrize("change", CHANGES)
def test_cells_that_were_changed_keep_their_points(few, change):
    result = grade(book(*CHANGES[change](*few)), NAME, SEED)
    assert points(result) == FULL, result


WRITTEN = {
    "utf-8-sig": lambda cells: {},
    "utf-16": lambda cells: {},
    "no ids, an old minor version": lambda cells: {"nbformat_minor": 0},
    "nbformat 5": lambda cells: {"nbformat": 5},
    "clashing ids": lambda cells: {"cells": [each | {"id": "a"} for each in cells]},
    "a kernel that is not there": lambda cells: {"metadata": {"kernelspec": {"name": "julia", "language": "julia"}}},
    "lists of lines": lambda cells: {"cells": [each | {"source": each["source"].splitlines(True)} for each in cells]},
    "cells that are none": lambda cells: {"cells": [None, 3, "x", [], {}, {"source": 5}, *cells]},
    "outputs kept": lambda cells: {
        "cells": [each | {"outputs": [{"text": "x" * 10**6}], "execution_count": 7} for each in cells]
    },
    "Colab": lambda cells: {
        "metadata": {"colab": {"provenance": []}, "accelerator": "GPU"},
        "cells": [each | {"metadata": {"id": "aB3", "outputId": "x", "cellView": "form"}} for each in cells],
    },
    # extensions/ipynb/src/serializers.ts of microsoft/vscode
    "VS Code": lambda cells: {
        "nbformat_minor": 2,
        "cells": [each | {"source": each["source"].splitlines(True), "execution_count": None} for each in cells],
    },
    "JupyterLab, a picture pasted into a text": lambda cells: {
        "cells": [{"cell_type": "markdown", "source": "![](attachment:a.png)", "metadata": {},
                   "attachments": {"a.png": {"image/png": "iVBORw0KGgo="}}}, *cells],
    },
}  # fmt: skip


@pytest.mark.parametrize("written", WRITTEN)
def test_a_file_from_any_program_is_read_under_any_name(few, written):
    sources = [few[0], *few[1]]
    cells = [cell(source) for source in sources]
    text = book(**{"cells": cells} | WRITTEN[written](cells)).decode()
    found, _ = notebook_file.read(
        text.encode(written if written in ("utf-8-sig", "utf-16") else "utf-8")
    )
    assert notebook_file.code(found) == sources
    for name in ("Untitled (1)", NAME, "02_rigid_motion"):
        assert notebook_file.course_of(name, found).name == NAME


def test_an_unknown_notebook_is_not_of_the_course():
    result = grade(book("print(1)"), "größe", SEED)
    assert (result["notebook"], result["exercises"]) == ("größe", [])
    assert "not one of the course's notebooks" in result["problems"][0]


def answer(few, name):
    return next(source for source in few[1] if f"def {name}(" in source)


@pytest.mark.quick
def test_each_exercise_of_a_notebook_is_judged_for_itself(few):
    loud = answer(few, "matrix_to_quaternion").replace(
        "):\n",
        "):\n    import sys, warnings; warnings.warn('odd'); print(1 / np.zeros(2), "
        "file=sys.stderr)\n",
        1,
    )
    uses = answer(few, "nearest_so").replace(
        "return U @", "rotations.nearest_quaternion(np.ones(4))\n    return U @"
    )
    assert {"warn(", "nearest_quaternion("} <= {
        word for text in (loud, uses) for word in re.findall(r"\w+\(", text)
    }
    rude = (
        "def is_valid(X, kind, tol):\n    raise ValueError(chr(27) + '[2J' + chr(0xd800) + "
        "chr(0x202e))"
    )
    result = grade(book(few[0], loud, uses, rude), NAME, SEED)
    wanted = {
        "matrix_to_quaternion": "right",
        "nearest_so": "right",
        "is_valid": "error in your code",
    }
    assert states(result) == wanted | {"nearest_se": "not attempted yet"}
    message = messages(result)["is_valid"]
    assert "[2J" in message
    assert not {"\x1b", "\ud800", "\u202e"} & set(message)


CALLS = """
def nearest_se(T):
    corrected = np.eye(len(T))
    corrected[:-1, :-1] = nearest_so(M=T[:-1, :-1])
    corrected[:-1, -1] = T[:-1, -1]
    return corrected
"""
UNFINISHED = {
    "wrong": "def nearest_so(M):\n    return 3.0",
    "unwritten": "def nearest_so(M):\n    raise NotImplementedError('Write nearest_so here.')",
    "missing": "",
}


@pytest.mark.parametrize("unfinished", UNFINISHED)
def test_a_function_is_judged_with_right_ones_for_those_it_calls(few, unfinished):
    said = "Judged with a right nearest_so in place of yours, which it calls."
    result = grade(book(few[0], UNFINISHED[unfinished], CALLS, "%reset -f"), NAME, SEED)
    rows = {row["exercise"]: row for row in result["exercises"]}
    assert (rows["nearest_so"]["points"], rows["nearest_se"]["points"]) == (0, 2)
    assert rows["nearest_se"]["message"] == said
    assert rows["nearest_se"]["instead"] == ["nearest_so"]
    wrong = CALLS.replace("return corrected", "return corrected.T")
    rows = {
        row["exercise"]: row
        for row in grade(book(few[0], UNFINISHED[unfinished], wrong), NAME, SEED)["exercises"]
    }
    assert rows["nearest_se"]["points"] == 0
    assert rows["nearest_se"]["message"].startswith(said)
    assert "What should hold" in rows["nearest_se"]["message"]


# How nearest_se may call nearest_so, which is wrong.
WRONG_SO = "def nearest_so(M):\n    return 3.0"
WAYS = {
    "an alias inside the cell": (
        "",
        "nearest_rotation = nearest_so\n",
        "nearest_rotation(T[:-1, :-1])",
    ),
    "a cache": (
        "import functools\n",
        (
            "cached = functools.lru_cache(lambda text: 0)\n"
            "kept = functools.lru_cache(nearest_so)\ndel nearest_so\n"
            "class Key(np.ndarray):\n    __hash__ = object.__hash__\n"
        ),
        "kept(T[:-1, :-1].view(Key))",
    ),
    "a partial": (
        "import functools\n",
        "part = functools.partial(nearest_so)\n",
        "part(M=T[:-1, :-1])",
    ),
    "a default argument": ("", "def use(M, f=nearest_so):\n    return f(M)\n", "use(T[:-1, :-1])"),
    "a dictionary": ("", "tools = {'so': nearest_so}\n", "tools['so'](T[:-1, :-1])"),
}
OBJECTS = {
    "an object with __call__": (
        "class Nearest:\n    def __call__(self, M):\n        return 3.0\nnearest_so = Nearest()\n",
        CALLS,
    ),
    "an object with __call__ under another name": (
        "class Nearest:\n    def __call__(self, M):\n        return 3.0\nnearest_so = Nearest()\n",
        "mine = nearest_so\n" + CALLS.replace("nearest_so(M=", "mine("),
    ),
    "a function under lru_cache": (
        "import functools\n@functools.lru_cache\ndef nearest_so(M):\n    return 3.0\n",
        CALLS.replace("nearest_so(M=T[:-1, :-1])", "nearest_so(Key(T[:-1, :-1].tolist()))")
        + "\nclass Key(list):\n    __hash__ = object.__hash__\n",
    ),
    "a function that is a partial": (
        (
            "import functools\ndef shared(kind, M):\n    return 3.0\n"
            "nearest_so = functools.partial(shared, 'so')\n"
        ),
        "mine = nearest_so\n" + CALLS.replace("nearest_so(M=", "mine("),
    ),
    "a method": (
        WRONG_SO,
        CALLS.replace("def nearest_se(T", "class Repair:\n  def __call__(self, T").replace(
            "\n    ", "\n        "
        )
        + "\nnearest_se = Repair()\n",
    ),
    "a bound method": (
        WRONG_SO,
        CALLS.replace("def nearest_se(T", "class Repair:\n  def repair(self, T").replace(
            "\n    ", "\n        "
        )
        + "\nnearest_se = Repair().repair\n",
    ),
}


def nearest_se_of(few, *cells):
    rows = {row["exercise"]: row for row in grade(book(few[0], *cells), NAME, SEED)["exercises"]}
    assert rows["nearest_so"]["points"] == 0
    return rows["nearest_se"]


@pytest.mark.parametrize("way", WAYS)
def test_a_function_s_calls_are_found_in_every_form(few, way):
    imports, before, call = WAYS[way]
    source = CALLS.replace("nearest_so(M=T[:-1, :-1])", call)
    row = nearest_se_of(few, WRONG_SO, imports + before + source)
    assert (row["points"], row["instead"]) == (2, ["nearest_so"]), row


@pytest.mark.parametrize("kind", OBJECTS)
def test_the_calls_of_and_by_any_object_are_found(few, kind):
    row = nearest_se_of(few, *OBJECTS[kind])
    assert (row["points"], row["instead"]) == (2, ["nearest_so"]), row


IN_A_CIRCLE = (
    (
        "def nearest_se(T):\n    fixed = np.eye(len(T))\n    fixed[:-1, :-1] = nearest_so(T[:-1,"
        " :-1])\n    fixed[:-1, -1] = T[:-1, -1]\n    return fixed"
    ),
    (
        "def nearest_so(M):\n    T = np.eye(len(M) + 1)\n    T[:-1, :-1] = M\n"
        "    return nearest_se(T)[:-1, :-1]"
    ),
)


def test_functions_that_call_each_other_in_a_circle_earn_nothing(few):
    result = grade(book(few[0], *IN_A_CIRCLE), NAME, SEED)
    assert points(result) == 0
    assert "call each other in a circle" in messages(result)["nearest_se"]


def test_a_call_that_the_task_excludes_earns_nothing(few):
    result = grade(book(few[0], IN_A_CIRCLE[1], STUB.replace("so", "se")), NAME, SEED)
    row = next(row for row in result["exercises"] if row["exercise"] == "nearest_so")
    assert (row["points"], row["state"]) == (0, "wrong"), row
    assert "It looks as if nearest_se is called." in row["message"]


# ---- what leaves by the feedback ----

WRITES_ITS_CASES = {
    "the text of an error": "raise ValueError(text)",
    "the text of numpy's error": "np.linalg.inv(np.zeros((1, 1))) if text is None else int(text)",
    "the name of an error": "raise type('E' + text.encode().hex(), (Exception,), {})()",
    "a warning": "warnings.warn(text); return rightly(M)",
    "a text": "return text",
    "the name of a type": "return type('E' + text.encode().hex(), (), {})()",
    "a missing key": "return {}[text]",
}


@pytest.mark.parametrize("way", WRITES_ITS_CASES)
def test_a_student_s_text_carries_no_case_into_the_feedback(few, way):
    right = answer(few, "nearest_so").replace("def nearest_so", "def rightly")
    source = (
        f"import warnings\n{right}\ndef nearest_so(M):\n    text = 'secret' + str(M.tolist())\n"
        f"    {WRITES_ITS_CASES[way]}"
    )
    row = next(
        row
        for row in grade(book(few[0], source), NAME, SEED)["exercises"]
        if row["exercise"] == "nearest_so"
    )
    own_text = row["message"].partition("\nFor M = ")[0].replace(source, "")
    assert not re.search(r"\d\.\d{4}", own_text), row["message"]
    assert b"secret".hex() not in own_text, row["message"]


def test_another_file_gets_other_cases_with_the_same_seed():
    assert submission.seed_of(b"one", SEED) == submission.seed_of(b"one", SEED)
    assert submission.seed_of(b"one", SEED) != submission.seed_of(b"two", SEED)
    assert submission.seed_of(b"one", SEED) != submission.seed_of(b"one", SEED + 1)


def test_a_random_answer_gets_the_same_message_in_each_run(few):
    guess = (
        "import time, secrets\ndef nearest_so(M):\n"
        "    return np.eye(len(M)) * (2 + time.perf_counter_ns() % 1000 / 7 + secrets.randbelow(9))"
    )
    rows = [grade(book(few[0], guess), NAME, SEED)["exercises"] for _ in range(2)]
    assert rows[0] == rows[1]
    row = next(row for row in rows[0] if row["exercise"] == "nearest_so")
    assert "R^T R = I" in row["message"]
    assert "differ from one time to the next" in row["message"]


# ---- what the checks offer, and what is not there ----


def test_grading_has_what_checks_offer_of_other_exercises(few):
    uses = (
        "def nearest_se(T):\n    fixed = np.eye(len(T))\n"
        "    fixed[:-1, :-1] = check.nearest_so.library(T[:-1, :-1])\n"
        "    fixed[:-1, -1] = T[:-1, -1]\n    return fixed"
    )
    offered = "def nearest_so(M):\n    return check.nearest_so.library(M)"
    result = grade(book(few[0], uses, offered), NAME, SEED)
    assert states(result)["nearest_so"] == "wrong"
    assert states(result)["nearest_se"] == "wrong", "its task excludes the library's nearest_so"
    assert "nearest_so is called" in messages(result)["nearest_se"]


def test_a_function_that_only_the_checks_have_answers_in_grading(solutions):
    name = "06_decomposition_ik"
    first, *rest = solutions(name)
    right = next(source for source in rest if "def approximation_error(" in source)
    asks = "table = check.split_branches.library(np.array([[0.1, 0.2], [0.1, -0.2], [0.3, 0.4]]))\n"
    inside = right.replace("def approximation_error(", "def own_error(")
    inside += (
        "\n\ndef approximation_error(*arguments):\n    assert len(table)\n"
        "    check.split_branches.library(np.array([[0.1, 0.2], [0.1, -0.2]]))\n"
        "    return own_error(*arguments)\n"
    )
    result = grade(book(first, asks, inside), name, SEED)
    assert states(result)["approximation_error"] == "right", messages(result)["approximation_error"]


OWN_MODULES = {
    "from": "from my_rotations import nearest_so",
    "all": "from my_rotations import *",
    "the module": "import my_rotations\ndef nearest_so(M):\n    return my_rotations.nearest_so(M)",
    "run": "%run my_rotations.py",
}


@pytest.mark.parametrize("way", OWN_MODULES)
def test_a_module_of_the_student_s_own_is_named_as_missing(few, way):
    result = grade(book(few[0], OWN_MODULES[way]), NAME, SEED)
    assert states(result)["nearest_so"] == "error in your code"
    assert "my_rotations" in messages(result)["nearest_so"]
    assert any("my_rotations" in problem for problem in result["problems"]), result["problems"]


MATHEMATICS = "import numpy as np\nfrom course_lib import rigid, rotations\n"
FORMER = MATHEMATICS + "from course_lib.checks import rotations as check"
PRESENT = MATHEMATICS + "from course_lib.lessons.rotations import check, figures"


@pytest.mark.parametrize("imports", [FORMER, PRESENT], ids=["former", "present"])
def test_notebooks_of_both_layouts_of_the_course_are_graded(few, imports):
    checked = [f"check.{e.name}({e.name})" for e in notebook_file.courses()[NAME].exercises]
    uses = "used = check.nearest_so.use(nearest_so)\nused(np.eye(2)), check.progress()"
    assert points(grade(book(imports, *few[1], *checked, uses), NAME, SEED)) == FULL


def test_assigning_to_the_name_of_the_checks_costs_nothing(few):
    result = grade(book(few[0], "check = 3", *few[1], "check.nearest_so(nearest_so)"), NAME, SEED)
    assert points(result) == FULL


def test_metadata_and_stored_outputs_earn_no_points(few):
    about = {"nbgrader": {"grade_id": "nearest_so", "points": 100, "grade": True, "solution": True}}
    outputs = [{"output_type": "stream", "text": "✓ nearest_so: right, 3 of 3 points"}]
    cells = [cell("def nearest_so(M):\n    return M", metadata=about, outputs=outputs)]
    rows = {row["exercise"]: row for row in grade(book(cells=cells), NAME, SEED)["exercises"]}
    row = rows["nearest_so"]
    assert (row["points"], row["of"], row["state"]) == (0, 3, "wrong")


def test_a_cell_that_is_not_python_is_an_error(few):
    broken = answer(few, "nearest_se").replace("return ", "return @", 1)
    rows = {row["exercise"]: row for row in grade(book(broken), NAME, SEED)["exercises"]}
    row = rows["nearest_se"]
    assert row["state"] == "error in your code"
    reason = r"Code cell \d+ is not Python: invalid syntax, in line \d+, `return @"
    assert re.search(reason, row["message"])


def test_the_seed_chooses_the_cases_beyond_those_of_the_notebook(few):
    exercise = importlib.import_module("course_lib.lessons.rotations.exercises.nearest_so").EXERCISE
    known = {
        round(float(case[0].sum()), 3)
        for seed in exercise.public_seeds
        for case in exercise.questions(seed)[0]
    }
    tells = (
        answer(few, "nearest_so").replace("def nearest_so", "def rightly")
        + f"\nknown = {known}\ndef nearest_so(M):\n"
        "    if round(float(np.sum(M)), 3) not in known: raise ValueError(M.tolist())\n"
        "    return rightly(M)\n"
    )
    guess = "def is_valid(X, kind, tol):\n    return bool(np.random.random() < 0.5)"
    results = [grade(book(few[0], tells, guess), NAME, seed) for seed in (1, 1, 2)]
    assert results[0] == results[1]
    assert "ValueError" in messages(results[0])["nearest_so"]
    assert messages(results[0])["nearest_so"] != messages(results[2])["nearest_so"]


def test_a_submission_that_takes_too_long_keeps_its_points(few):
    sleeps = "import time\ndef nearest_so(M):\n    time.sleep(100)"
    limits = replace(SHORT, idle_seconds=2, submission_seconds=1)
    result = grade(book(few[0], *few[1], sleeps), NAME, SEED, limits)
    assert "computed nothing for 2 seconds" in messages(result)["nearest_so"]
    assert "not graded" in messages(result)["nearest_se"]


def test_a_process_left_behind_costs_later_cells_nothing(few):
    loops = (
        "import os\ndef loop():\n    if not os.fork():\n        while True: pass\nlooping = loop()"
    )
    uses = answer(few, "nearest_so").replace("return ", "looping\n    return ")
    waits = answer(few, "is_valid").replace("    ", "    waited\n    ", 1)
    result = grade(
        book(few[0], loops, uses, "import time\nwaited = time.sleep(4)", waits), NAME, SEED, SHORT
    )
    assert states(result)["is_valid"] == "right"


# ---- files that are none ----


@pytest.mark.parametrize(
    ("content", "why"),
    [
        (b"", "empty"),
        (b"  \n", "empty"),
        (b"\xef\xbb\xbf\r\n", "empty"),
        (b'{"cells": [', "ends in the middle, in line 1"),
        (b'{"cells": [],}', "line 1 is not as JSON demands"),
        (b'{"cells": []}}', "line 1 is not as JSON demands"),
        (b'{"cells": [{"source": "x', "ends in the middle, in line 1"),
        (b'{\n"cells": [},\n{}]}', "line 2 is not as JSON demands"),
        (b'{"cells": ["\xe9"]}', "not encoded as UTF-8"),
        (b"[" * 100_000, "more than a notebook does"),
        (b"import numpy as np\n", "does not begin with {"),
        (b"\n<!DOCTYPE html>\n<html>", "web page"),
        (b"version https://git-lfs.github.com/spec/v1\noid sha256:4d\n", "Git LFS"),
        (b"\0" * 4096, "nothing but zeros"),
        (b"PK\x03\x04\x14\0", "a zip"),
        (b"%PDF-1.7\n", "a PDF"),
        (b'{"cells": [\n<<<<<<< HEAD\n{}\n=======\n', "half merged: line 2 begins with <<<<<<<"),
        (b"[]", "no list of cells"),
        (b'{"cells": 3}', "no list of cells"),
        (
            b'{"nbformat": 3, "worksheets": [{"cells": []}]}',
            "the format that notebooks had before 2014",
        ),
        (b'{"cells": [' + b"{}," * 6000 + b"{}]}", "more than"),
        (book("x" * 3_000_000), "million characters"),
    ],
    ids=[
        "empty",
        "blank",
        "a mark of UTF-8",
        "half",
        "a comma too many",
        "a brace too many",
        "half a text",
        "damaged",
        "another encoding",
        "deep",
        "a script",
        "a page",
        "git-lfs",
        "zeros",
        "a zip",
        "a PDF",
        "half merged",
        "a list",
        "no cells",
        "old",
        "many cells",
        "much code",
    ],
)
def test_an_unreadable_file_is_the_reason_for_every_exercise(content, why):
    result = grade(content, NAME, SEED)
    assert why in result["problems"][0]
    assert [row["exercise"] for row in result["exercises"]] == [
        e.name for e in courses()[NAME].exercises
    ]
    assert set(states(result).values()) == {UNREADABLE}
    assert points(result) == 0
    assert [question["state"] for question in result["questions"]] == [UNREADABLE] * 3


SOURCES = [
    "\ud800",
    "(" * 10_000,
    "-" * 200_000 + "1",
    "x = " + "[" * 5000,
    "\0",
    "def f(:\n" * 5000,
]


def test_sources_that_cannot_be_parsed_affect_no_other_exercise(few):
    assert points(grade(book(few[0], *SOURCES, *few[1]), NAME, SEED, SHORT)) == FULL


# ---- written answers ----


@pytest.mark.parametrize("without", [[], ["metadata"], ["metadata", "id"]])
def test_written_answers_are_found_by_name_id_or_task(without):
    notebook = nbformat.read(NOTEBOOKS / f"{NAME}.ipynb", 4)
    wanted = ["explain_torch", "explain_weights", "explain_tolerance"]
    for each in notebook.cells:
        if each.metadata.get("nbgrader", {}).get("grade_id") in wanted:
            each.source = f"because of {each.metadata.nbgrader.grade_id}"
        each |= {key: {} for key in without}
    found, _ = notebook_file.read(book(cells=[dict(each) for each in notebook.cells]))
    answers = {each.name: notebook_file.answer(each, found) for each in courses()[NAME].questions}
    assert answers == {name: f"because of {name}" for name in wanted}


@pytest.mark.parametrize("without", [[], ["metadata", "id"]])
def test_an_answer_in_a_new_cell_below_the_prompt_is_found(without):
    """The prompt itself is no answer."""
    given = nbformat.reads(
        students_copy((NOTEBOOKS / f"{NAME}.ipynb").read_text(), NAME, ""), 4
    ).cells
    cells = [
        {key: {} if key in without else value for key, value in each.items()} for each in given
    ]
    (place,) = (
        k for k, each in enumerate(given) if each.get("id") == courses()[NAME].questions[0].id
    )
    unanswered, _ = notebook_file.read(book(cells=cells))
    assert {notebook_file.answer(each, unanswered) for each in courses()[NAME].questions} == {""}
    found, _ = notebook_file.read(
        book(cells=[*cells[: place + 1], cell("because", "markdown"), *cells[place + 1 :]])
    )
    assert [notebook_file.answer(each, found) for each in courses()[NAME].questions] == [
        "because",
        "",
        "",
    ]
