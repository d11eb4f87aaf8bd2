import difflib
import gc
import os
import zipfile
from contextlib import ExitStack, contextmanager
from pathlib import Path

import nbformat
import numpy as np
import pytest
from hypothesis import settings
from processor_time import Stopwatch, table
from tools import Machine, declared_tools, report_missing

pytest.register_assert_rewrite("site_visits")  # so that it says what differs, as the tests do

NOTEBOOKS = Path(__file__).parent.parent / "notebooks"

# The same examples on every run and every machine: a test that fails is one that will fail again.
settings.register_profile(
    "course", derandomize=True, database=None, deadline=None, max_examples=100
)
settings.load_profile("course")


LESSONS = Path(__file__).parent / "lessons"
collect_ignore = [
    "lessons"
]  # some are called test_..., as the exercises are in which a test is written
ABOUT_AN_EXERCISE = (
    "test_bank.py",
    "test_exercise_cells.py",
    "test_mutants.py",
    "test_release_leaks.py",
)
ABOUT_A_NOTEBOOK = (*ABOUT_AN_EXERCISE, "test_notebooks.py", "test_release_runs.py")


def pytest_ignore_collect(collection_path):
    """With ONLY=unhat (make test ONLY=unhat), leave out files that hold nothing of that name:
    collecting takes time."""
    only, name = os.environ.get("ONLY", ""), collection_path.name
    if not only or not collection_path.is_file():
        return None
    if any(LESSONS.glob(f"*/answers/*{only}*.py")):
        return name not in ABOUT_AN_EXERCISE or None
    if any(LESSONS.glob(f"*{only}*")):
        return not (name in ABOUT_A_NOTEBOOK or only in name) or None
    return (
        not (
            only in name
            or (name.endswith(".py") and only in collection_path.read_text(encoding="utf-8"))
        )
        or None
    )


# What takes longest: it goes first, so that the processes that share the files end together.
# JupyterLab is waited for most of the time, so others work meanwhile; files that need a browser
# follow each other, for it stays open.
LONGEST = [
    "test_lab.py",
    "05_panda_dh_ik.ipynb",
    "06_decomposition_ik.ipynb",
    "test_bank.py",
    "test_site_course.py",
    "test_mutants.py",
    "test_grade_hostile.py",
    "test_grade_submission.py",
    "test_release_runs.py",
    "test_accepted_forms.py",
    "test_toys_page.py",
    "test_site.py",
    "test_site_answers.py",
    "test_grade_tests.py",
    "test_grade_cluster.py",
    "test_commands.py",
    "test_author_guide.py",
    "test_guide_for_instructors.py",
    "test_grade_layouts.py",
    "test_release_nbgrader.py",
    "test_grade_isolation.py",
    "test_notebook_runner.py",
    "test_grade_jobs.py",
]


# Thousands of tests are collected and kept: searching for garbage among them would double the time
# that takes.
gc.disable()


def pytest_collection_finish(session):
    """With ONLY=typo say what there is instead of pytest's "no tests ran"."""
    gc.freeze()
    gc.enable()
    session.config.in_browser = {
        item.path for item in session.items if "browser" in getattr(item, "fixturenames", ())
    }
    only = os.environ.get("ONLY")
    if only and not session.items and not session.testsfailed:
        names = {path.stem for pattern in ("*", "*/answers/*.py") for path in LESSONS.glob(pattern)}
        names |= {
            path.stem
            for pattern in ("tests/*.py", "notebooks/*.ipynb")
            for path in LESSONS.parents[1].glob(pattern)
        }
        near = difflib.get_close_matches(
            only, sorted(names | {name.removeprefix("test_") for name in names})
        )
        raise pytest.UsageError(
            f"Nothing has {only} in its name. Near it: {', '.join(near) or 'nothing'}."
        )


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_auto_num_workers():
    """Half as many processes again as processors: a third of the time tests wait, for a sandbox, a
    kernel or a page."""
    return (
        None
        if "PYTEST_XDIST_AUTO_NUM_WORKERS" in os.environ
        else max(1, (os.cpu_count() or 1) * 3 // 2)
    )


# A sandbox, a browser, a cluster, a copy of the course and its sites, and programs that are killed
# at each of their steps take seconds, whatever the test does with them.
SLOW = {"isolated", "browser", "course", "sites", "dask", "killed_updates"}


@pytest.hookimpl(tryfirst=True)  # before pytest chooses by marks
def pytest_collection_modifyitems(items):
    """Mark as slow whatever uses a slow fixture or tool, unless it is marked as quick; sort files.

    With loadfile each process of pytest-xdist runs files in this order.
    """
    for item in items:
        used = {*getattr(item, "fixturenames", ()), *declared_tools(item)}
        if used & SLOW and item.get_closest_marker("quick") is None:
            item.add_marker("slow")
    ranks = {name: rank for rank, name in enumerate(LONGEST)}
    items.sort(key=lambda item: ranks.get(item.path.name, len(ranks)))


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item, nextitem):
    """Whatever a test, or a notebook's cell in it, sets for printing arrays ends with the test, and
    so do its tools."""
    item.config.stopwatch.before(item)
    with np.printoptions():
        outcome = yield
    item.config.machine.restore()
    item.config.stopwatch.after(item, nextitem)
    return outcome


def pytest_sessionfinish(session):
    """Hand the seconds that a process of pytest-xdist has counted to the one that prints them."""
    if hasattr(session.config, "workeroutput"):
        session.config.workeroutput["seconds"] = dict(session.config.stopwatch.seconds)


@pytest.hookimpl(optionalhook=True)
def pytest_testnodedown(node):
    node.config.stopwatch.seconds.update(getattr(node, "workeroutput", {}).get("seconds", {}))


def pytest_configure(config):
    config.machine = Machine()
    config.stopwatch = Stopwatch()
    config.browser, config.to_close = None, ExitStack()


def pytest_report_header(config):
    """Say before the first test which programs are missing."""
    return report_missing(config.machine.found)


def pytest_unconfigure(config):
    config.to_close.close()


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item):
    """Before fixtures are made: those of a module see what its first test declares."""
    item.config.machine.show(item)
    if (
        item.path not in item.config.in_browser
    ):  # while a browser is open, no other event loop can run
        item.config.to_close.close()
        item.config.browser = None
    elif item.config.browser:
        from site_visits import be_patient

        be_patient(item.config.browser)


@pytest.fixture(scope="session")
def solutions():
    """The notebook's name -> the sources of its first code cell (imports) and of the authors'
    solutions."""

    def read(name):
        cells = [
            c for c in nbformat.read(NOTEBOOKS / f"{name}.ipynb", 4).cells if c.cell_type == "code"
        ]
        return [cells[0].source] + [
            c.source for c in cells if c.metadata.get("nbgrader", {}).get("solution")
        ]

    return read


@contextmanager
def locked(path):
    """Wait until no other process is at work here."""
    with path.open("w") as file:
        try:
            import fcntl
        except ImportError:  # on Windows one process tests
            yield
            return
        fcntl.flock(file, fcntl.LOCK_EX)  # which the system takes off a process that ends
        yield


@pytest.fixture(scope="session")
def course(tmp_path_factory):
    """The folder of the whole course as a site, to be looked at and left as it is; one process
    builds it for all."""
    from course_lib.pack.site.build import build  # here, for most tests need none

    base = tmp_path_factory.getbasetemp()
    folder = (base.parent if "PYTEST_XDIST_WORKER" in os.environ else base) / "course"
    with locked(folder.with_suffix(".lock")):
        if not folder.exists():
            build(NOTEBOOKS, folder)
    return folder


@pytest.fixture(scope="session")
def isolated():
    """For tests that run a submission: they need a bubblewrap that works."""
    from helpers import unavailable

    from course_lib.pack.grade.jail import isolation

    if problem := isolation.problem():
        unavailable(f"bubblewrap {problem}")


@pytest.fixture
def few(isolated, monkeypatch, solutions):
    """The cell with the imports and those with right answers; the notebook has no other
    exercises."""
    from hostile.build import answers, few_exercises

    few_exercises(monkeypatch)
    first, found = answers(solutions)
    return first, list(found.values())


@pytest.fixture
def shown(monkeypatch):
    """The texts that checks display."""
    from course_lib.checks import kernel

    texts = []
    monkeypatch.setattr(kernel, "show", lambda text, *rest, **named: texts.append(text))
    return texts


@pytest.fixture(scope="module")
def unpacked(tmp_path_factory):
    """The students' zip, unpacked: the one folder in it."""
    from course_lib.pack.release.__main__ import main

    folder = tmp_path_factory.mktemp("student")
    assert main(["--root", str(NOTEBOOKS.parent), "--output", str(folder / "student.zip")]) == 0
    with zipfile.ZipFile(folder / "student.zip") as archive:
        archive.extractall(folder)
    (top,) = (path for path in folder.iterdir() if path.is_dir())
    return top


@pytest.fixture(scope="module")
def browser(request):
    """A browser, which stays open for the next module if that needs one, too: to start it takes as
    long as a page."""
    config = request.config
    if config.browser is None or not config.browser.is_connected():
        from site_visits import open_browser  # here, for most tests need no browser

        config.to_close.close()
        config.browser = config.to_close.enter_context(open_browser())
    return config.browser


def pytest_terminal_summary(terminalreporter):
    """Print what test_bank.py and test_mutants.py record of each exercise, whichever process ran
    them."""
    reports = [report for group in terminalreporter.stats.values() for report in group]
    recorded = [item for report in reports for item in getattr(report, "user_properties", ())]
    for kind, title, heads in (
        (
            "bank",
            "checks against answers",
            "right ones accepted,wrong ones refused,mistakes refused by name",
        ),
        (
            "mutants",
            "checks against mutants of the solutions",
            "mutants,tried,accepted,of these different",
        ),
    ):
        rows = sorted({tuple(row) for name, row in recorded if name == kind})
        if rows:
            rows.insert(0, ("notebook", "exercise", *heads.split(",")))
            widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
            terminalreporter.section(title)
            for row in rows:
                terminalreporter.line("  ".join(map(str.ljust, row, widths)).rstrip())
    seconds = terminalreporter.config.stopwatch.seconds
    if seconds:
        terminalreporter.section("the slowest files, in seconds of processor")
        for line in table(seconds):
            terminalreporter.line(line)
