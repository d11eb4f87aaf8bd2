"""The work on a Dask cluster: a scheduler and two workers on this machine, one of which is killed halfway."""

import os
import re
import subprocess
import sys
import threading
from contextlib import ExitStack
from pathlib import Path

import pytest
from grade_stand_in import TABLES, grade, hand_in, wait_for

from course_lib.pack.grade.__main__ import main
from course_lib.pack.grade.jobs import course_hash

ROOT = Path(__file__).parents[1]


class Cluster:
    """A scheduler and its workers, processes of this machine; close() ends them."""

    def __init__(self, folder):
        self.folder, self.workers, self._stack = folder, [], ExitStack()
        self._start(
            "scheduler", "--host", "127.0.0.1", "--port", "0", DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES="0"
        )
        self.address = self._told("scheduler", r"Scheduler at: +(tcp://[\d.:]+)")

    def add_workers(self, count):
        names = [f"worker-{number}" for number in range(count)]
        options = ["--no-nanny", "--nthreads", "1", "--host", "127.0.0.1", "--local-directory", str(self.folder)]
        self.workers += [self._start(name, self.address, *options) for name in names]
        for name in names:
            self._told(name, r"(Registered to)")

    def close(self):
        self._stack.close()

    def _start(self, name, *arguments, **settings):
        # What the workers import: the stand-in for the grading, and this course.
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(ROOT / "tests"), str(ROOT)]), **settings}
        command = [sys.executable, "-m", f"distributed.cli.dask_{name.partition('-')[0]}", *arguments, "--no-dashboard"]
        log = self._stack.enter_context((self.folder / f"{name}.log").open("w"))
        process = subprocess.Popen(command, env=environment, cwd=self.folder, stdout=log, stderr=log)
        self._stack.enter_context(process)
        self._stack.callback(process.kill)
        return process

    def _told(self, name, pattern):
        return wait_for(lambda: re.search(pattern, (self.folder / f"{name}.log").read_text()))[1]


@pytest.fixture
def cluster(tmp_path):
    course_hash.cache_clear()  # the workers compute theirs anew
    cluster = Cluster(tmp_path)
    yield cluster
    cluster.close()


def run(folder, output, *options):
    return main([str(folder / "in"), "--output", str(folder / output), "--seed", "5", *options], grade=grade)


def at_work(folder):
    """The processes that began to grade a submission, in that order."""
    begun = sorted((folder / "log").iterdir(), key=lambda path: path.stat().st_mtime_ns)
    return [int(text) for text in (path.read_text() for path in begun) if text]


def test_a_worker_killed_halfway_changes_no_table(tmp_path, cluster):
    cluster.add_workers(2)
    (tmp_path / "log").mkdir()
    for i in range(12):
        told = {"points": [2, i % 3], "texts": [f"because {i}"], "seconds": 0.25, "log": str(tmp_path / "log")}
        hand_in(tmp_path / "in", f"s{i}_01_rotations.ipynb", **told)
    results = tmp_path / "out/results"

    def kill_who_is_at_work():
        wait_for(lambda: len(list(results.glob("*.json"))) >= 4)
        pid = at_work(tmp_path)[-1]
        (worker,) = (worker for worker in cluster.workers if worker.pid == pid)
        worker.kill()
        left.append(12 - len(list(results.glob("*.json"))))

    left = []
    killer = threading.Thread(target=kill_who_is_at_work)
    killer.start()
    assert run(tmp_path, "out", "--scheduler", cluster.address) == 0
    killer.join()
    assert left[0] > 0, "it was not killed halfway"
    assert [worker.poll() is None for worker in cluster.workers].count(False) == 1
    assert set(at_work(tmp_path)) == {worker.pid for worker in cluster.workers}

    assert run(tmp_path, "here", "--jobs", "1") == 0
    assert at_work(tmp_path)[-12:] == [os.getpid()] * 12
    for name in TABLES:
        assert (tmp_path / "out" / name).read_bytes() == (tmp_path / "here" / name).read_bytes()
    assert (tmp_path / "out/grades.csv").read_text().count("exercise_0,2,2,right") == 12


def test_a_job_that_ends_its_workers_affects_no_other_job(tmp_path, cluster):
    cluster.add_workers(3)  # it ends one among the others, and one when it is tried alone
    for i in range(5):
        hand_in(tmp_path / "in", f"s{i}_01_rotations.ipynb", points=[2], do="end" if i == 1 else "", seconds=0.2)
    assert run(tmp_path, "out", "--scheduler", cluster.address) == 0
    grades = (tmp_path / "out/grades.csv").read_text()
    reason = "s1,01_rotations,,,0,,not graded,s1_01_rotations.ipynb: It could not be graded:"
    assert reason in grades, grades
    assert "the process that graded it ended (exit status 1)" in grades
    assert grades.count("exercise_0,2,2,right") == 4


def test_workers_with_another_course_stop_the_run(tmp_path, cluster, monkeypatch, capsys):
    cluster.add_workers(1)
    for i in range(5):
        hand_in(tmp_path / "in", f"s{i}_01_rotations.ipynb", points=[2], seconds=0.2)
    monkeypatch.setattr("course_lib.pack.grade.jobs.course_hash", lambda: "another")
    assert run(tmp_path, "out", "--scheduler", cluster.address) == 1
    assert "has another version of the course." in capsys.readouterr().err
    assert not list((tmp_path / "out").glob("results/*.json"))


def test_a_cluster_without_workers_is_reported(tmp_path, cluster, monkeypatch, capsys):
    monkeypatch.setattr("course_lib.pack.grade.jobs.CLUSTER_SECONDS", 2)
    hand_in(tmp_path / "in", "s_01_rotations.ipynb", points=[2])
    assert run(tmp_path, "out", "--scheduler", cluster.address) == 1
    assert "No worker can do the work (TimeoutError)." in capsys.readouterr().err


def test_a_missing_scheduler_is_reported(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr("course_lib.pack.grade.jobs.CLUSTER_SECONDS", 1)
    hand_in(tmp_path / "in", "s_01_rotations.ipynb", points=[2])
    for address in "tcp://127.0.0.1:1", "nonsense":
        assert run(tmp_path, "out", "--scheduler", address) == 1
        assert f"No scheduler answers at {address}." in capsys.readouterr().err
