"""Run the cells of a submission in a sandbox, and answer what they ask on the way."""

from collections import Counter

from course_lib.pack.grade.jail.missing_modules import note_missing
from course_lib.pack.grade.jail.sandbox import Ended, Sandbox
from course_lib.pack.grade.verdicts.grading import Grading, Place

MAX_CHECKS = 5  # of one exercise, in the notebook, at which its function is asked
PRINTED = "it printed more than a notebook can hold"
MAX_LINE = 10**7  # the number of a line that the runner claims to run


def run_cells(
    sandbox: Sandbox, order: dict, grading: Grading, conversation: object
) -> tuple[Place | None, Ended | None]:
    """Run the cells of a submission in a sandbox.

    Parameters
    ----------
    sandbox : Sandbox
    order : dict
        What the runner is to do, see runner.py.
    grading : Grading
    conversation : object
        Its ask_now(name, number) asks for an exercise at one of its checks, and returns whether no
        more cells are to be run; its answer_cell(text) answers a call of check.NAME.library.

    Returns
    -------
    place : tuple or None
        The one that ran last, (cell, line).
    end : Ended or None
        How the sandbox ended.
    """
    limits, place, checks = grading.limits, None, Counter()
    watch = sandbox.watch(limits.notebook_seconds, limits.cell_cpu_seconds)
    try:
        sandbox.send(order, watch)
        while True:
            message = sandbox.receive(watch)
            if "ran" in message:
                return place, None
            if isinstance(name := message.get("checked"), str):
                checks[name] += 1
                if checks[name] <= MAX_CHECKS and conversation.ask_now(name, checks[name]):
                    return place, None
                sandbox.send({}, watch)
            elif isinstance(call := message.get("library"), str):
                sandbox.send({"answer": conversation.answer_cell(call)}, watch)
                continue  # the same cell goes on
            elif isinstance(name := message.get("missing"), str):
                note_missing(grading, name)
            elif message.get("printed") is True and place is not None:
                grading.left_out[place[0]] = PRINTED
            else:
                place = _place(message.get("running"), grading) or place
            watch.begin(limits.cell_cpu_seconds, limits.notebook_cpu_seconds)
    except Ended as end:
        return place, end


def _place(claimed: object, grading: Grading) -> Place | None:
    """Return the place that the runner claims to run, (cell, line); None if there is no such
    place."""
    if not isinstance(claimed, list) or [type(number) for number in claimed] != [int, int]:
        return None
    cell, line = claimed
    return (cell, line) if 0 <= cell < len(grading.sources) and 0 <= line < MAX_LINE else None
