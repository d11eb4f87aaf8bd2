"""The sandbox of a submission: the kinds of isolation, its copy of the course, and which statements are run."""

import importlib.util
import marshal
import os
import subprocess
import sys

import pytest
from hostile.build import FULL, NAME, SEED, SHORT, book, points, processes, sources

from course_lib.pack.grade import sandbox, submission
from course_lib.pack.grade.cells import alike_alone, needed, statements
from course_lib.pack.grade.notebook_file import courses
from course_lib.pack.grade.student_view import contents
from course_lib.pack.grade.submission import grade


@pytest.mark.parametrize("kind", sandbox.NOTICES)
def test_each_kind_of_isolation_gives_the_same_grades(few, kind, monkeypatch):
    if not sandbox.works(kind):
        pytest.skip(f"{kind}: not possible here")
    monkeypatch.setattr(sandbox, "kind", lambda: kind)
    loop = "def nearest_so(M):\n    while True:\n        pass"
    assert points(grade(book(few[0], *few[1]), NAME, SEED)) == FULL
    result = grade(book(few[0], *few[1], loop), NAME, SEED, SHORT)
    assert points(result) == FULL - 3
    assert "Does a loop never end?" in next(r for r in result["exercises"] if r["exercise"] == "nearest_so")["message"]
    before = processes()
    assert points(grade(book(few[0], *few[1], *sources("daemon")), NAME, SEED, SHORT)) == FULL
    assert processes() <= before


@pytest.mark.skipif(sandbox.kind() != sandbox.NAMESPACES, reason="namespaces are not allowed here")
def test_a_python_named_by_a_path_from_another_folder_keeps_submissions_apart_too(tmp_path):
    relative = os.path.relpath(sys.executable, tmp_path)
    asked = [relative, "-c", "from course_lib.pack.grade import sandbox; print(sandbox.kind())"]
    done = subprocess.run(asked, cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout == f"{sandbox.NAMESPACES}\n"


@pytest.mark.parametrize("name", courses())
def test_the_copy_of_the_course_contains_no_judge_and_no_answers(name):
    course = courses()[name]
    forbidden = {dotted for exercise in course.exercises for dotted in exercise.forbidden}
    files = contents({course.package: course.exercises}, frozenset(forbidden))
    sources = {path: source for path, source in files.items() if path.endswith(".py") and path != "runner.py"}
    compiled = {path: content for path, content in files.items() if "__pycache__" in path}
    assert list(compiled) == [importlib.util.cache_from_source(path) for path in sources]
    codes = [compile(source, "", "exec", dont_inherit=True) for source in sources.values()]
    assert [marshal.loads(content[16:]) for content in compiled.values()] == codes, "and so of what the sources hold"
    checks = {path for path in set(files) - set(compiled) if path.startswith("course_lib/checks/")}
    asking = ("__init__.py", "call_student.py", "wire.py", "adapters.py", f"{course.package}/__init__.py")
    assert checks == {f"course_lib/checks/{file}" for file in asking}
    assert not any(path.startswith("course_lib/pack") or path.endswith(".ipynb") for path in files)
    for dotted in forbidden:
        module, _, function = dotted.rpartition(".")
        path = f"{module.replace('.', '/')}.py"
        if dotted.startswith("course_lib."):
            source = files[path].decode()
            assert f'NotAllowed("{dotted}")' in source or f"NotAllowed('{dotted}')" in source
            assert source.count(f"def {function}(") == 1
            assert f"class {function}" not in source


def test_only_what_a_function_needs_is_run():
    cells = [
        "import numpy as np\nimport time",
        "k = 3\nother = 4\nnp.abs = None",
        "for k in range(5):\n    pass\ntable = []\ntable.append(k)\ntime.sleep(1000)",
        "def helper(x):\n    other = x\n    return table[0] * other\nprint(helper(2))",
        "def wanted(x, k=1):\n    return helper(x) + k",
    ]
    kept = [each.tree.lineno + 10 * each.cell for each in needed(statements(cells), ["wanted"])]
    assert kept == [1, 2, 11, 21, 23, 24, 31, 41]


def test_functions_that_a_separate_run_would_not_change_are_found_from_the_source():
    cells = [
        "import numpy as np\nk = 3\ntable = []",
        "def plain(x):\n    return helper(x)\ndef helper(x):\n    return k * x",
        "table.append(1)\ndef draws(x):\n    return table",
        "@wrapped\ndef decorated(x):\n    return x",
    ]
    names = ["plain", "draws", "decorated"]
    assert alike_alone(statements(cells[:2]), ["plain"]) == ["plain"]
    assert alike_alone(statements(cells), ["plain", "missing"]) == ["plain", "missing"]
    assert alike_alone(statements(cells), names) == []
    assert alike_alone(statements(cells[:3]), ["plain", "draws"]) == ["draws"]


@pytest.mark.parametrize(
    ("line", "harmless"),
    [
        *(("a = np.array([1.0])", True), ("a, b = 1, 2", True), ("def a(x=2):\n    pass", True)),
        *(("a = plain(2)", False), ("a = np.seterr()", False), ("a = exec('k = 2')", False), ("np.k = a = 3", False)),
        *(("np.k[0] = a = 3", False), ("a: int = 3", False), ("def a(x=plain(2)):\n    pass", False)),
    ],
)
def test_a_statement_that_may_change_more_than_a_variable_requires_a_separate_run(line, harmless):
    found = statements(["import numpy as np", "def plain(x):\n    return x", f"{line}\ndef other(x):\n    return a"])
    assert alike_alone(found, ["plain", "other"]) == (["plain", "other"] if harmless else ["other"])


@pytest.fixture
def attempts(monkeypatch):
    """The exercises of each sandbox that was started."""
    asked, real = [], submission.attempt

    def counted(run, exercises, *rest, **named):
        asked.append([exercise.name for exercise in exercises])
        return real(run, exercises, *rest, **named)

    monkeypatch.setattr(submission, "attempt", counted)
    return asked


def test_an_answer_that_is_wrong_anyway_is_asked_once(few, attempts):
    result = grade(book(few[0], *few[1], "def nearest_so(M):\n    return np.array(M)"), NAME, SEED)
    assert points(result) == FULL - 3
    assert len(attempts) == 1


@pytest.mark.parametrize("source", ["import nowhere", "1 / 0\nk = 1 / 0\ndef nearest_so(M):\n    return M * k"])
def test_an_answer_beside_cells_that_fail_is_asked_again_alone(few, attempts, source):
    wrong = "def nearest_so(M):\n    return np.array(M)"
    assert points(grade(book(few[0], *few[1], wrong, source), NAME, SEED)) == FULL - 3
    assert ["nearest_so"] in attempts


def test_a_caught_refusal_of_a_function_that_only_others_forbid_is_asked_again_alone(few, attempts):
    careful = "from course_lib import rotations\nright = nearest_so\ndef nearest_so(M):\n    try:\n"
    careful += "        rotations.is_so(M)\n    except BaseException:\n        return M\n    return right(M)"
    assert points(grade(book(few[0], *few[1], careful), NAME, SEED)) == FULL
    assert ["nearest_so"] in attempts
