"""What stands for the grading of one submission where tests are about what happens around it.

A submission is JSON that says what to do: {"points": [1, 0], "log": folder that gets a file for
each call, "seconds": to take, "do": "raise", "end" (the process) or nothing, "texts": written
answers, "more": names of exercises and questions in More}.
"""

import json
import os
import sys
import time
import uuid
from pathlib import Path

TABLES = ("grades.csv", "totals.csv", "questions.csv")
SOON = 600  # seconds: a loaded machine may take long, and only what fails waits so long


def wait_for(what):
    """Return the first true value of what(), or fail after a while."""
    deadline = time.monotonic() + SOON
    while not (value := what()):
        assert time.monotonic() < deadline
        time.sleep(0.05)
    return value


def grade(content, notebook, seed):
    orders = json.loads(content)
    if "log" in orders:
        Path(orders["log"], f"{uuid.uuid4()}").write_text(str(os.getpid()))
    time.sleep(orders.get("seconds", 0))
    if orders.get("do") == "raise":
        raise ValueError("a grader has errors too")
    if orders.get("do") == "end":
        os._exit(1)
    return result(
        orders.get("points", ()), orders.get("texts", ()), notebook, orders.get("more", ())
    )


def dask_setup(worker):
    """Let a worker of a Dask cluster that loads this file grade by it."""
    from course_lib.pack.grade import cluster

    def carry_out(order):
        head, _, content = order.partition(b"\n")
        about = json.loads(head)
        value = about["notebook"] and grade(content, about["notebook"], about["seed"])
        return json.dumps({"value": value})

    cluster.carry_out = carry_out


def result(points=(), texts=(), notebook="01_rotations", more=(), **changed):
    """A result as grade gives it: an exercise of 2 points for each of `points`, a question for each
    of `texts`."""
    exercises = [
        {"exercise": f"exercise_{i}", "points": p, "of": 2, "state": "right" if p else "wrong"}
        | {
            "message": "" if p else "What should hold: it is a rotation.",
            "mistake": "" if p else "R^T is returned",
        }
        for i, p in enumerate(points)
    ]
    questions = [
        {"question": f"explain_{i}", "of": 2, "text": text} for i, text in enumerate(texts)
    ]
    exercises, questions = (
        [e | {"more": set(e.values()) & set(more) != set()} for e in x]
        for x in (exercises, questions)
    )
    plain = {"notebook": notebook, "release": "0.1.0-abc", "problems": []}
    return plain | {"exercises": exercises, "questions": questions} | changed


def hand_in(folder, name, **orders):
    """Write a submission; name: its path in the folder."""
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(orders))
    return path


if __name__ == "__main__":  # the whole command, with this in place of the grading
    import grade_stand_in

    from course_lib.pack.grade.__main__ import main

    sys.exit(main(grade=grade_stand_in.grade))
