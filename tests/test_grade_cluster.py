"""Grading on the workers of a Dask cluster: real schedulers and workers, in processes of their
own."""

import json
import os
import signal
import subprocess
import sys
import threading
from collections import Counter
from contextlib import ExitStack, suppress
from pathlib import Path

import psutil
import pytest
from course_copy import copied
from grade_stand_in import hand_in, wait_for
from hostile.build import answers, book

from course_lib.pack.grade.__main__ import main
from course_lib.pack.grade.cluster import Cluster, Order, Task

STAND_IN = Path(__file__).with_name("grade_stand_in.py")
SEED = "48151623421"


@pytest.fixture
def dask(tmp_path):
    """Return a function that starts a scheduler or, given its address, a worker, and returns the
    process.

    The process has `log`, the path of what it says, and a scheduler its `address`.
    """
    with ExitStack() as started:

        def start(address="", *options, **changed):
            number, kind = len(os.listdir(tmp_path)), "worker" if address else "scheduler"
            log = tmp_path / f"{number}-{kind}.log"
            command = [
                sys.executable,
                "-m",
                f"distributed.cli.dask_{kind}",
                *filter(None, [address]),
            ]
            command += ["--no-dashboard", "--host", "127.0.0.1", *options]
            command += (
                ["--nthreads", "1", "--local-directory", str(tmp_path / "space")]
                if address
                else ["--port", "0"]
            )
            with log.open("w") as said:
                process = subprocess.Popen(
                    command, stdout=said, stderr=said, env=os.environ | changed, cwd=tmp_path
                )
            started.callback(process.wait)
            started.callback(process.terminate)
            process.log = log
            if not address:
                line = wait_for(
                    lambda: [
                        line for line in log.read_text().splitlines() if "Scheduler at:" in line
                    ]
                )
                process.address = line[0].split()[-1]
            return process

        yield start


def have_joined(*workers):
    """Wait until the scheduler has all workers, so that none grades a class before the others."""
    wait_for(lambda: all("Registered to" in worker.log.read_text() for worker in workers))


class Run(threading.Thread):
    """`make grade` with a cluster."""

    def __init__(self, place, address, output="out"):
        super().__init__()
        self._options = [
            str(place / "in"),
            "--output",
            str(place / output),
            "--seed",
            SEED,
            "--cluster",
            address,
        ]
        self.start()

    def run(self):
        self.code = main(self._options)


def written(folder):
    """All that a run writes."""
    return {
        path.relative_to(folder): path.read_bytes() for path in folder.rglob("*") if path.is_file()
    }


@pytest.fixture
def given(monkeypatch):
    """The submissions that have been given to workers so far; what they are asked before is not
    among them."""
    tasks, give = [], Cluster._give

    def noted(cluster, task, worker):
        give(cluster, task, worker)
        if task.path:
            tasks.append(task)

    monkeypatch.setattr(Cluster, "_give", noted)
    return tasks


def jailed(worker):
    """Return the processes below a worker if one of them is a jail."""
    below = psutil.Process(worker.pid).children(recursive=True)
    with suppress(psutil.NoSuchProcess):  # one ends meanwhile
        if any(process.name() == "bwrap" for process in below):
            return below
    return None


def test_workers_that_are_killed_old_late_or_without_bubblewrap(
    dask, tmp_path, solutions, isolated, given, capsys
):
    """The real grader on real workers gives the same bytes as on one machine, and no log shows the
    seed."""
    first, right = answers(solutions)
    waits = "import time\ntime.sleep(15)"  # so that its worker is killed while it runs
    contents = {"a": book(first, waits, right["nearest_so"]), "b": b"no JSON"}
    for student, content in contents.items():
        hand_in(tmp_path / "in", f"{student}_01_rotations.ipynb").write_bytes(content)
    old = copied(tmp_path / "old", notebooks="01*")
    address = dask().address
    killed = dask(address, "--no-nanny")
    dask(address, "--no-nanny", PYTHONPATH=str(old))
    dask(address, "--no-nanny", PATH=os.environ["PATH"].partition(":")[0])
    run = Run(tmp_path, address)
    wait_for(lambda: given)
    below = wait_for(lambda: jailed(killed))
    killed.kill()
    wait_for(lambda: not any(process.is_running() for process in below))
    late = dask(address)
    run.join()
    assert run.code == 0
    said = capsys.readouterr().out
    assert said.count(" ended: its submission goes to another.\n") == 1
    assert "grades nothing: its course is another version.\n" in said
    assert (
        "grades nothing: Submissions cannot be kept apart from this machine, so none was run"
        in said
    )
    assert (
        main(
            [
                str(tmp_path / "in"),
                "--output",
                str(tmp_path / "alone"),
                "--seed",
                SEED,
                "--jobs",
                "1",
            ]
        )
        == 0
    )
    assert written(tmp_path / "out") == written(tmp_path / "alone")
    assert (
        b"a,01_rotations,core,nearest_so,3,3,right" in written(tmp_path / "out")[Path("grades.csv")]
    )
    late.terminate()
    late.wait()
    assert SEED not in "".join(path.read_text() for path in tmp_path.glob("*.log"))


@pytest.fixture
def any_exercises(monkeypatch):
    """The stand-in's exercises are not the course's."""
    monkeypatch.setattr("course_lib.pack.grade.__main__.points_offered", lambda: None)


def fill(place, **orders):
    """Write submissions of five students, each with a log of its own gradings.

    orders: more of some of them.
    """
    for student in "abcde":
        log = place / f"log-{student}"
        log.mkdir(exist_ok=True)
        about = {"points": [2], "log": str(log), "texts": [student]} | orders.get(student, {})
        hand_in(place / "in", f"{student}_01_rotations.ipynb", **about)


def graded(place):
    """How often each student's submission was graded."""
    return {student: len(os.listdir(place / f"log-{student}")) for student in "abcde"}


def test_a_submission_that_ends_three_workers_is_not_graded(dask, tmp_path, capsys, any_exercises):
    """The other submissions are graded once."""
    fill(tmp_path, b={"do": "end"}, d={"do": "raise"})
    address = dask().address
    worker = dask(address, "--preload", str(STAND_IN))  # which a nanny starts again
    run = Run(tmp_path, address)
    run.join()
    assert run.code == 0
    assert graded(tmp_path) == {"a": 1, "b": 3, "c": 1, "d": 3, "e": 1}
    lines = (tmp_path / "out/grades.csv").read_text().splitlines()
    why = "It could not be graded: 3 workers ended while they graded it."
    assert [line for line in lines if "not graded" in line] == [
        f"{student},01_rotations,,,0,,not graded,{student}_01_rotations.ipynb: {why},"
        for student in "bd"
    ]
    assert sum("exercise_0,2,2,right" in line for line in lines) == 3
    assert "Compute Failed" in worker.log.read_text()
    assert SEED not in f"{worker.log.read_text()} {Order(SEED.encode())} {[Order(SEED.encode())]}"


def test_a_run_continues_on_another_scheduler(dask, tmp_path, capsys, any_exercises):
    """The run ends when its own scheduler is gone."""
    fill(tmp_path, c={"seconds": 600})
    scheduler = dask()
    worker = dask(scheduler.address, "--no-nanny", "--preload", str(STAND_IN))
    run = Run(tmp_path, scheduler.address)
    wait_for(lambda: graded(tmp_path)["c"])
    scheduler.send_signal(signal.SIGKILL)
    run.join()
    worker.kill()
    assert run.code == 1
    assert capsys.readouterr().err.endswith(
        f"Grading stopped. The connection to {scheduler.address} was lost. "
        "All finished results are kept: the same command continues from there.\n"
    )
    fill(tmp_path)
    again = dask().address
    run = Run(tmp_path, again)
    dask(again, "--no-nanny", "--preload", str(STAND_IN))
    run.join()
    assert run.code == 0
    assert graded(tmp_path) == {"a": 1, "b": 1, "c": 2, "d": 1, "e": 1}


def test_a_cluster_without_a_usable_worker_is_explained(dask, tmp_path, capsys, monkeypatch):
    fill(tmp_path)
    monkeypatch.setattr("course_lib.pack.grade.cluster.PATIENCE", 0)
    hand_in(tmp_path / "other", "course_lib/__init__.py").write_text("")
    scheduler = dask()
    dask(scheduler.address, "--no-nanny", PYTHONPATH=str(tmp_path / "other"))
    wait_for(lambda: "Register worker" in scheduler.log.read_text())
    run = Run(tmp_path, scheduler.address)
    run.join()
    said = capsys.readouterr().err
    assert (
        f"Grading stopped. No worker of {scheduler.address} could grade for 0 seconds. tcp://"
        in said
    )
    assert said.endswith(
        "lacks this course (ModuleNotFoundError: No module named 'course_lib.pack').\n"
    )
    assert (
        main([str(tmp_path / "in"), "--output", str(tmp_path / "out"), "--cluster", "tls//x"]) == 1
    )
    assert (
        "Grading stopped. CLUSTER=tls//x: the scheduler does not answer" in capsys.readouterr().err
    )


# ---- workers whose answers are not what they should be ----

GOOD = {"notebook": "01_rotations", "release": "", "problems": [], "questions": [], "exercises": []}
ROW = {"exercise": "a", "points": 1, "of": 2, "state": "right", "message": "", "more": False}


def with_row(**changed):
    return json.dumps({"value": GOOD | {"exercises": [ROW | changed]}})


# What a bad worker answers to each submission.
BAD_ANSWERS = {
    "a million points": with_row(points=1_000_000),
    "negative points": with_row(points=-1),
    "points that are no number": '{"value": ' + json.dumps(GOOD)[:-1] + ', "more": NaN}}',
    "no points": json.dumps({"value": GOOD | {"exercises": [{"exercise": "a"}]}}),
    "textual points": with_row(points="2"),
    "an empty value": '{"value": {}}',
    "a null value": '{"value": null}',
    "a listed value": '{"value": [1]}',
    "a number": "7",
    "nothing known": '{"neither": 1}',
    "no JSON": "{",
    "no text": None,
    "very much": '"' + "x" * 60_000_000 + '"',
    "a refusal with control characters": json.dumps({"unfit": "\x1b[2J no\r\n" * 50}),
    "a reason that is a list": '{"failed": [1]}',
}
BAD_WORKER = """
import json
from course_lib.pack.grade import cluster

ANSWER = {answer!r}

def carry_out(order):
    asked = json.loads(order.partition(b"\\n")[0])
    return json.dumps({{"fit": True}}) if asked["notebook"] is None else ANSWER

def dask_setup(worker):
    cluster.carry_out = carry_out
"""


@pytest.mark.parametrize("kind", BAD_ANSWERS)
def test_a_bad_answer_is_named_and_graded_by_another_worker(kind, any_exercises, capsys):
    """Without a real cluster: the answers alone."""
    cluster = without_dask({"bad", "good"}, ["bad", "good"])
    task = Task("path", Order(b"x"), worker="bad")
    outcomes = list(cluster._answered(task, Answered(BAD_ANSWERS[kind])))
    if "refusal" in kind:
        assert (outcomes, cluster._again, cluster._fit) == ([], [task], {"good"})
        assert "\x1b" not in capsys.readouterr().out
        return
    ((path, outcome),) = outcomes
    assert path == "path"
    assert outcome.get("unusable"), outcome
    assert outcome["worker"] == "the worker bad"
    assert cluster._free("path") == "good"


def without_dask(fit, workers):
    """Return a Cluster that is connected to nothing, with these workers, some of which are fit."""
    cluster = Cluster.__new__(Cluster)
    cluster._workers, cluster._fit, cluster._unfit = dict.fromkeys(workers, 1), set(fit), {}
    cluster._avoided, cluster._tasks, cluster._again = {}, {}, []
    cluster._bad = Counter()
    return cluster


def test_a_submission_prefers_a_joining_worker_to_a_bad_one():
    cluster = without_dask({"bad"}, ["bad", "joining"])
    cluster._avoided["path"] = {"bad"}
    assert cluster._free("path") is None
    assert cluster._free("another path") == "bad"
    cluster._fit.add("joining")
    assert cluster._free("path") == "joining"


def test_a_submission_returns_to_a_bad_worker_without_another():
    cluster = without_dask({"bad"}, ["bad", "refused"])
    cluster._avoided["path"], cluster._unfit = (
        {"bad"},
        {"refused": "its course is another version."},
    )
    assert cluster._free("path") == "bad"


class Answered:
    """A future of Dask's that is done."""

    status = "finished"

    def __init__(self, answer):
        self._answer = answer

    def result(self, timeout):
        return self._answer


def test_a_worker_with_too_many_points_is_replaced_by_another(
    dask, tmp_path, capsys, any_exercises
):
    fill(tmp_path)
    bad = tmp_path / "bad.py"
    bad.write_text(BAD_WORKER.format(answer=BAD_ANSWERS["a million points"]))
    address = dask().address
    have_joined(
        dask(address, "--no-nanny", "--preload", str(bad)),
        dask(address, "--no-nanny", "--preload", str(STAND_IN)),
    )
    run = Run(tmp_path, address)
    run.join()
    assert run.code == 0
    lines = (tmp_path / "out/grades.csv").read_text().splitlines()
    assert sum("exercise_0,2,2,right" in line for line in lines) == 5
    assert not any("not graded" in line for line in lines)
    assert "a has 1e+06 points of 2" in capsys.readouterr().out


def test_the_submission_of_a_silent_worker_goes_to_another(
    dask, tmp_path, capsys, monkeypatch, any_exercises
):
    fill(tmp_path)
    silent = tmp_path / "silent.py"
    silent.write_text(
        BAD_WORKER.format(answer="")
        .replace("else ANSWER", "else time.sleep(600)")
        .replace("import json", "import json, time")
    )
    address = dask().address
    asleep = dask(address, "--no-nanny", "--preload", str(silent))
    have_joined(asleep, dask(address, "--no-nanny", "--preload", str(STAND_IN)))
    refuse = Cluster._refuse

    def refuse_one(self, *reason):
        # The other worker has all the time that it needs for the last submission.
        monkeypatch.setattr("course_lib.pack.grade.cluster.MAX_SILENT", 600)
        refuse(self, *reason)

    run = Run(tmp_path, address)
    wait_for(lambda: len(list(tmp_path.glob("out/results/*.json"))) == 4)
    monkeypatch.setattr(Cluster, "_refuse", refuse_one)
    monkeypatch.setattr("course_lib.pack.grade.cluster.MAX_SILENT", 3)
    run.join()
    asleep.kill()
    assert run.code == 0
    lines = (tmp_path / "out/grades.csv").read_text().splitlines()
    assert sum("exercise_0,2,2,right" in line for line in lines) == 5
    assert "it said nothing for 3 seconds" in capsys.readouterr().out
