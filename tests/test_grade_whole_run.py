"""What a run of the whole notebook can change, found from the source alone."""

import pytest
from hostile.build import NAME, SEED, book

from course_lib.pack.grade.jail.statements import statements
from course_lib.pack.grade.verdicts import notebook_run, submission
from course_lib.pack.grade.verdicts.submission import grade
from course_lib.pack.grade.verdicts.whole_run import (
    can_be_told,
    idle_cells,
    is_settled,
    only_by_names,
    stays,
)

IMPORT = "import numpy as np"
DOUBLE = "def double(x):\n    return 2 * x"
FOUR = "def four(x):\n    return double(double(x))"


def idle(*sources, given):
    return idle_cells(statements(sources), sources, given)


def settled(name, *sources, given=()):
    return is_settled(statements(sources), name, given)


# ---- cells that need not run ----


def test_a_given_cell_that_only_prints_is_idle():
    assert idle(DOUBLE, "print(double(2))", given={1}) == {1}


def test_a_cell_of_the_student_s_is_never_idle():
    assert idle(DOUBLE, "print(double(2))", given={}) == set()


def test_a_given_cell_with_a_check_is_not_idle():
    assert idle(DOUBLE, "check.double(double)", given={1}) == set()


@pytest.mark.parametrize(
    "binding", ["k = 2", "k, m = 2, 3", "for k in range(3):\n    pass", "from a import *"]
)
def test_a_given_cell_that_binds_what_a_function_reads_is_not_idle(binding):
    assert idle(binding, "def times(x):\n    return k * x", given={0}) == set()


def test_a_given_cell_that_changes_what_a_function_reads_is_not_idle():
    cells = "table = {}", "table['k'] = 2", "def times(x):\n    return table['k'] * x"
    assert idle(*cells, given={0, 1}) == set()


def test_a_given_cell_that_another_needs_is_not_idle():
    assert idle("a = 1", "k = a", "def times(x):\n    return k * x", given={0, 1}) == set()


def test_a_function_may_read_what_a_later_cell_binds():
    assert idle("def times(x):\n    return k * x", "k = 2", given={1}) == set()


def test_what_was_bound_before_the_last_binding_is_not_read():
    assert idle("k = 1", "k = 2", "def times(x):\n    return k * x", given={0, 1}) == {0}


# ---- functions that are the same whenever they are asked ----


def test_a_function_whose_names_are_bound_once_is_settled():
    assert settled("four", IMPORT, DOUBLE, FOUR)


@pytest.mark.parametrize(
    "other",
    [
        "def double(x):\n    return x + x",
        "double = abs",
        "double.__code__ = abs",
        "from mine import *",
    ],
)
def test_a_function_that_reads_a_name_of_two_meanings_is_not_settled(other):
    assert not settled("four", DOUBLE, other, FOUR)


def test_a_function_that_reads_a_name_that_nothing_binds_is_not_settled():
    assert not settled("four", FOUR)


def test_the_same_import_in_two_cells_binds_one_thing():
    root = "def root(x):\n    return np.sqrt(x)"
    assert settled("root", IMPORT, f"{IMPORT}\n{root}")
    assert not settled("root", IMPORT, f"import mine as np\n{root}")


CHANGED = "table = {'k': 1}", "def f(x):\n    return table['k'] * x"


@pytest.mark.parametrize(
    "others",
    [
        ("def change():\n    table['k'] = 2", "change()"),
        ("def change():\n    table.update(k=2)", "change()"),
        ("other = table\nother['k'] = 2",),
        ("update = table.update", "update(k=2)"),
        ("table.update(k=2)",),
        ("f.table = 3",),
    ],
)
def test_a_function_whose_table_another_cell_may_change_is_not_settled(others):
    assert settled("f", *CHANGED)
    assert not settled("f", *CHANGED, *others)


def test_a_table_that_another_function_reads_is_not_settled():
    read = "def g(x):\n    return table.get(x)"
    assert settled("f", *CHANGED, given={0})
    assert not settled("f", *CHANGED, read, given={0})


# ---- functions that are after all cells what they are at their check ----


def after(name, *sources, cell=0, given=()):
    return stays(statements(sources), name, cell, given)


@pytest.mark.parametrize(
    "later",
    [
        (),
        ("print(double(2))",),
        ("def other(x):\n    return double(x)",),
        (IMPORT,),
        (DOUBLE,),
    ],
)
def test_a_function_stays_if_nothing_binds_or_changes_it_later(later):
    assert after("four", f"{IMPORT}\n{DOUBLE}\n{FOUR}", *later)


@pytest.mark.parametrize(
    "later", ["def double(x):\n    return x", "double = abs", "double.k = 2", "from mine import *"]
)
def test_a_function_of_which_a_part_is_bound_or_changed_later_does_not_stay(later):
    assert not after("four", f"{DOUBLE}\n{FOUR}", later)


def test_a_function_of_which_a_part_is_bound_only_later_does_not_stay():
    assert not after("four", FOUR, DOUBLE)


@pytest.mark.parametrize(
    "later", ["table['k'] = 2", "put(table)", "other = table", "def g(x):\n    return table"]
)
def test_a_function_whose_table_is_read_later_does_not_stay(later):
    assert after("f", "\n".join(CHANGED), "print(f(1))")
    assert not after("f", "\n".join(CHANGED), later)


def test_a_function_that_changes_what_it_reads_does_not_stay():
    count = "table = {'k': 1}\ndef f(x):\n    table['k'] += 1\n    return table['k'] * x"
    assert not after("f", count, "print(f(1))", given={1})


CALLS = ("change()", "again()")


@pytest.mark.parametrize("call", CALLS)
@pytest.mark.parametrize(
    "change",
    [
        "def change():\n    table['k'] = 2",
        "other = table\ndef change():\n    other['k'] = 2",
        "other = [table]\ndef change():\n    other[0].update(k=2)",
        "change = lambda: table.update(k=2)",
        "class change:\n    def __init__(self):\n        table['k'] = 2",
    ],
)
def test_a_given_cell_that_may_call_what_changes_a_table_is_not_idle(change, call):
    cells = *CHANGED, change, "def again():\n    change()", call, "print(1)"
    assert idle(*cells, given={4, 5}) == {5}


@pytest.mark.parametrize(
    "cell",
    [
        "from course_lib.arms import panda\narm = panda()\ndef f(q):\n    return arm.fk(q)",
        "def g(q):\n    return 2 * q\ndef f(q):\n    return g(q).mean()",
    ],
)
def test_a_method_of_what_the_library_or_a_function_returns_changes_nothing(cell):
    assert idle(cell, "print(f(1))", given={1}) == {1}


def test_a_method_of_an_object_of_the_student_s_may_change_it():
    cell = "rng = np.random.default_rng(0)\ndef f(q):\n    return q + rng.normal()"
    assert idle(IMPORT, cell, "print(f(1))", given={2}) == set()


def told(*sources):
    return can_be_told(statements(sources), sources, ())


@pytest.mark.parametrize(
    "patch",
    [
        "np.abs = max",
        "if True:\n    np.abs = max",
        "def patch():\n    np.linalg.norm = max",
        "del np.abs",
    ],
)
def test_of_a_notebook_that_patches_a_module_nothing_can_be_told(patch):
    assert told(IMPORT, DOUBLE)
    assert not told(IMPORT, DOUBLE, patch)


@pytest.mark.parametrize(
    "setting", ["np.seterr(all='raise')", "def strict():\n    np.seterr(all='raise')"]
)
def test_a_setting_of_the_student_s_may_change_a_function(setting):
    root = "def root(x):\n    return np.sqrt(x)"
    assert not settled("root", IMPORT, root, setting)
    assert settled("root", IMPORT, root, setting, given={2})


@pytest.mark.parametrize(
    "cell",
    ["exec('k = 2')", "%run mine.py", "%%writefile a.py\nk = 2", "globals()['k'] = 2", "__k"],
)
def test_a_cell_that_makes_names_in_another_way_shows_it(cell):
    assert only_by_names([IMPORT, DOUBLE, FOUR])
    assert not only_by_names([DOUBLE, cell])


# ---- runs of a submission ----


@pytest.fixture
def whole_runs(monkeypatch):
    """The names of the exercises of each run of the whole notebook."""
    runs = []

    def run_and_ask(run, exercises, *rest, whole=False):
        if whole:
            runs.append([exercise.name for exercise in exercises])
        return one_run(run, exercises, *rest, whole=whole)

    one_run = submission.run_and_ask
    monkeypatch.setattr(submission, "run_and_ask", run_and_ask)
    return runs


WRONG = "def nearest_so(M):\n    return 2 * M"


@pytest.mark.usefixtures("isolated")
def test_a_wrong_function_that_is_settled_needs_no_run_of_the_whole_notebook(few, whole_runs):
    first, right = few
    others = [source for source in right if "def nearest_so(" not in source]
    result = grade(book(first, *others, WRONG), NAME, SEED)
    states = {row["exercise"]: row["state"] for row in result["exercises"]}
    assert states["nearest_so"] == "wrong"
    assert whole_runs == []


@pytest.mark.usefixtures("isolated")
def test_a_function_that_was_right_at_its_check_is_found_by_such_a_run(few, whole_runs):
    first, right = few
    result = grade(book(first, *right, "check.nearest_so(nearest_so)", WRONG), NAME, SEED)
    assert {row["state"] for row in result["exercises"]} == {"right"}
    assert whole_runs[0] == ["nearest_so"]


@pytest.mark.usefixtures("isolated")
@pytest.mark.parametrize(("later", "times"), [("print(1)", [0, 1]), ("missing = 2", [0, 1, 0])])
def test_what_stays_is_asked_at_its_check_and_not_again(later, times, few, monkeypatch):
    first, right = few
    asked = []

    def ask(grading, function, left_out, at=0, **about):
        if function.exercise.name == "nearest_so":
            asked.append(at)
        return one(grading, function, left_out, at, **about)

    one = notebook_run.ask_and_judge
    monkeypatch.setattr(notebook_run, "ask_and_judge", ask)
    broken = "def nearest_so(M):\n    return missing"
    grade(book(first, *right, broken, "check.nearest_so(nearest_so)", later), NAME, SEED)
    assert asked == times
