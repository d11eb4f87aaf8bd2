"""Submissions that have their secret cases answered by what knows right answers, and answer from
that at the next check."""

from dataclasses import replace

import pytest
from hostile.build import NAME, SEED, SHORT, answers, book, few_exercises

from course_lib.pack.grade.hand_ins import notebook_file
from course_lib.pack.grade.hand_ins.notebook_file import courses
from course_lib.pack.grade.verdicts.submission import grade

ATTACKED = ("nearest_so", "is_valid", "matrix_to_quaternion")
# Every function is made by exec, so that only a run of the whole notebook has it. Each writes down
# what it is asked, and answers from the table if that holds the answer.
KEEPS = """
import glob, os, pickle, uuid
os.makedirs("/scratch/kept", exist_ok=True)

def key(arguments):
    return repr([np.asarray(argument).tolist() for argument in arguments])

def keep(kind, thing):
    with open(f"/scratch/kept/{kind}-{uuid.uuid4()}", "wb") as file:
        pickle.dump(thing, file)

def kept(kind):
    things = []
    for path in glob.glob(f"/scratch/kept/{kind}-*"):
        with open(path, "rb") as file:
            things.append(pickle.load(file))
    return things

def answer(name, arguments):
    keep("asked", (name, arguments))
    for table in kept("table"):
        if (name, key(arguments)) in table:
            return table[name, key(arguments)]
    DUMMY
    return "nothing"
"""
MADE = 'exec("def {name}(*arguments):\\n    return answer({name!r}, arguments)")'
# With right functions in place of the wrong ones, the sacrificed one asks them.
SACRIFICED = """
exec('''
def nearest_se(T):
    table = {}
    for name, arguments in kept("asked"):
        right = globals()[name](*arguments)
        if not isinstance(right, str):
            table[name, key(arguments)] = right
    keep("table", table)
    return "wrong"
''')
"""
# A test that its versions answer, of which most are right at most arguments.
BY_VERSIONS = """
exec('''
def test_log_so3(log):
    votes = {}
    for name, arguments in kept("asked"):
        try:
            keep("vote", (name, key(arguments), np.asarray(log(*arguments), float)))
        except ValueError:
            pass
    for name, arguments, vector in kept("vote"):
        votes.setdefault((name, arguments), []).append(vector)
    table = {}
    for asked, vectors in votes.items():
        most = [sum(np.allclose(one, other, atol=1e-9) for other in vectors) for one in vectors]
        table[asked] = vectors[int(np.argmax(most))]
    keep("table", table)
    return True
''')
"""


def rows_of(*cells):
    result = grade(book(*cells), NAME, SEED, replace(SHORT, cpu_seconds=10, cell_cpu_seconds=60))
    return {row["exercise"]: row for row in result["exercises"]}


def test_right_functions_answer_no_case_that_was_kept(isolated, solutions, monkeypatch):
    few_exercises(monkeypatch)
    first, _ = answers(solutions)
    keeps = KEEPS.replace("DUMMY", "nearest_se(np.eye(4))")
    made = "\n".join(MADE.format(name=name) for name in ATTACKED)
    asked = "\n".join(f"check.{name}({name})" for name in (*ATTACKED, "nearest_se"))
    rows = rows_of(first, keeps, made, SACRIFICED, *[asked] * 5)
    assert {name: rows[name]["points"] for name in rows} == dict.fromkeys(rows, 0), rows


def test_versions_of_a_test_answer_no_case_that_was_kept(isolated, solutions, monkeypatch):
    course = courses()[NAME]
    few = tuple(e for e in course.exercises if e.name in ("log_so3", "test_log_so3"))
    monkeypatch.setattr(notebook_file, "courses", lambda: {NAME: replace(course, exercises=few)})
    keeps = KEEPS.replace("DUMMY", "pass")
    asked = "check.test_log_so3(test_log_so3)\ncheck.log_so3(log_so3)"
    first = solutions(NAME)[0]
    rows = rows_of(first, keeps, MADE.format(name="log_so3"), BY_VERSIONS, *[asked] * 5)
    assert rows["log_so3"]["points"] == 0, rows


HONEST = {
    "an earlier one": ("nearest_so", "nearest_se"),
    "a later one": ("nearest_se", "nearest_so"),
}


@pytest.mark.parametrize("order", HONEST)
def test_a_right_answer_that_calls_a_wrong_one_keeps_its_points(order, few):
    """Whichever of the two is checked first."""
    first, _ = few
    wrong = "exec('def nearest_so(M):\\n    return M')"
    calls = (
        "exec('''\ndef nearest_se(T):\n    corrected = np.eye(len(T))\n"
        "    corrected[:-1, :-1] = nearest_so(T[:-1, :-1])\n    corrected[:-1, -1] = T[:-1, -1]\n"
        "    return corrected\n''')"
    )
    asked = "\n".join(f"check.{name}({name})" for name in HONEST[order])
    rows = rows_of(first, wrong, calls, asked)
    assert rows["nearest_so"]["points"] == 0
    is_excluded = rows["nearest_se"]["mistake"] == "nearest_so is called"
    assert rows["nearest_se"]["points"] == rows["nearest_se"]["of"] or is_excluded, rows
