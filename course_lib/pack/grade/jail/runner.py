"""Run a notebook's cells and put questions to its functions: what a process in the sandbox does.

All its output is only a claim, because the student's code runs in the same process and can forge
it. It reads an order with the cells, and runs them. Then it reads requests until the end, and
answers each in a child process, so that a crash in one answer affects no other. While the whole
notebook runs, it says so at each of its checks, and answers requests about the function that is
checked, until one asks nothing.

What a cell, or an answer, asks of a function that only the checks have is passed on to the grader.

Each message is a JSON object on one line. The grader (verdicts/cells.py, sandboxed_function.py)
sends

    message     key         what it holds
    ----------  ----------  --------------------------------------------------------------------
    order,      cells       the texts of all code cells
    once        whole       whether all cells run as in Jupyter, or only the needed statements
                needed      [number of a cell, its text as Python, places of statements in it]
                            for each cell that has needed statements; empty if whole
                without     [number of a cell, line] of what is left out; line 0: the whole cell
    request     ask         the name of the exercise that is asked
                questions   JSON text, see call_student.reply
                cpu         the most seconds of processor time for the answers
                instead     {name: names of its arguments} of functions that the grader answers
                reply       the most bytes of the reply
    {}                      no more requests at this check: the cells go on
    answer      answer      to `library` and `call`: JSON text; null after too many calls

and this process (Conversation.say) sends

    key         what it holds, and what follows
    ----------  --------------------------------------------------------------------------------
    running     [number of a cell, line] of what begins to run; line 0: the whole cell
    missing     the name of a module that an import did not find
    printed     true: what runs was ended because it printed too much
    checked     the name of the exercise whose check runs now; requests follow, then {}
    library     a cell's call of a function of the checks, as JSON text; an answer follows
    ran         true: the cells have run; requests follow, until the pipe is closed

    exercise    the name of the exercise that was asked, together with one of these:
    - call      an answer's call of a function that the grader answers; an answer follows
    - reply     the answers, JSON text as of call_student.reply
    - ended     why there is no reply, or "" if the child process ended; with `status`, its exit
                code or the negative number of a signal, and `computed`, its processor seconds,
                unless no child process could be made
"""

import ast
import contextlib
import functools
import importlib
import io
import json
import linecache
import os
import random
import resource
import select
import shutil
import signal
import sys
import threading
import time
import types
from collections.abc import Callable, Iterator
from typing import IO

PATIENCE = 20  # seconds in which a child reads an answer
ROOM_PATIENCE = 5  # seconds in which killed processes end and leave room for another one
ROOM_PAUSE = 0.01  # seconds between two attempts to make a process
# Of what a cell prints: the bytes that this takes in the file of a notebook, of which no hand-in
# may have more. Each piece takes about ten more than its characters there.
MAX_PRINTED, EACH_PRINTED = 10**8, 10
TOO_LONG = "its answer is too long"
TOO_OFTEN = "it calls the functions that it tests too often"
NOT_READING = "it does not read what the functions that it calls answer"


def main(course: str, requests: int, replies: int, put_aside: dict) -> None:
    """Run the cells, then answer requests until the input ends.

    Parameters
    ----------
    course : str
        The folder with the course's files.
    requests, replies : int
        Numbers of the pipes from and to the grader.
    put_aside : dict
        {name: module} of what is loaded already, for a run of the whole notebook.
    """
    os.dup2(1, 2)  # which leads nowhere: the grader reads of an end by the pipe that this was
    shutil.copytree(f"{course}/data", "data", dirs_exist_ok=True)
    conversation = Conversation(os.fdopen(requests, "rb"), replies)
    order = conversation.read()
    begin_all_random_numbers_alike()
    sys.stdout = sys.stderr = conversation.printed
    run = needed_only
    if order["whole"]:
        run = whole
        sys.modules |= put_aside
    left_out = {tuple(place) for place in order["without"]}
    space = run(order["cells"], order["needed"], left_out, conversation)
    conversation.say(ran=True)
    conversation.serve(space.get)


class Conversation:
    """What this process and the grader tell each other, in lines of JSON."""

    def __init__(self, requests: IO[bytes], replies: int) -> None:
        self._requests, self._replies, self._process = requests, replies, os.getpid()
        self.printed = Printed(sys.stdout.buffer, encoding="utf-8", errors="replace")
        self._checks = importlib.import_module("course_lib.checks")
        self._call_student = importlib.import_module("course_lib.checks.call_student")
        self._checks.checked = self.checked
        self._checks.asking = self.ask_library

    def say(self, **message: object) -> None:
        """Write a line to the grader."""
        write(self._replies, json.dumps(message).encode() + b"\n")

    @contextlib.contextmanager
    def running(self, number: int, line: int = 0) -> Iterator[None]:
        """Say what runs in the block, and at its end whether it printed too much.

        number, line: of the cell, and of the statement in it; line 0 for the whole cell.
        """
        self.say(running=[number, line])
        self.printed.begin()
        yield
        if self.printed.is_too_much():
            self.say(printed=True)
        self.printed.begin()

    def read(self) -> dict:
        """Read a line from the grader; {} if there is none."""
        line = self._requests.readline()
        return json.loads(line) if line else {}

    def serve(self, find: Callable) -> None:
        """Answer requests about the functions that find(name) returns, until one asks nothing."""
        while "ask" in (asked := self.read()):
            function, name = find(asked["ask"]), asked["ask"]
            answer = functools.partial(
                self._call_student.reply, function, asked["questions"], instead=asked["instead"]
            )
            pass_on = functools.partial(self._pass_on, name)
            self.say(exercise=name, **in_a_child(asked, answer, self._checks, pass_on))

    def checked(self, name: str, function: Callable) -> None:
        """Let the grader ask now: what is right at its check counts, whatever a later cell does."""
        if self._in_charge():
            self.say(checked=name)
            self.serve({name: function}.get)

    def ask_library(self, text: str) -> str:
        """Return what the grader answers to a cell that calls a function of the checks."""
        if not self._in_charge():
            raise RuntimeError("only a cell itself, or an answer, can call a function of a check")
        self.say(library=text)
        return self.read().get("answer") or json.dumps({"error": TOO_OFTEN})

    def _pass_on(self, name: str, text: str) -> str | None:
        """Return what the grader answers to a call in an exercise's answer; None after too many."""
        self.say(exercise=name, call=text)
        return self.read().get("answer")

    def _in_charge(self) -> bool:
        in_main_thread = threading.current_thread() is threading.main_thread()
        return os.getpid() == self._process and in_main_thread


class Printed(io.TextIOWrapper):
    """Where cells print to: nowhere, and not without end."""

    size = 0  # of what was printed since `begin`

    def begin(self) -> None:
        """Let the next cell print as much as any other."""
        self.size = 0

    def write(self, text: str) -> int:
        """Drop a piece; raise TooMuchPrinted from the one on that is too much."""
        self.size += len(text) + EACH_PRINTED
        if self.is_too_much():
            raise TooMuchPrinted
        return super().write(text)

    def is_too_much(self) -> bool:
        """Return whether more was printed than any notebook can hold."""
        return self.size > MAX_PRINTED


class TooMuchPrinted(BaseException):
    """Ends what prints too much. Not an Exception, which `except Exception` swallows."""


def begin_all_random_numbers_alike() -> None:
    """Let random numbers begin alike, so that the same file gets the same grade.

    numpy's default_rng() begins with bytes that it gets from the operating system, and so does
    random.SystemRandom.
    """
    source = random.Random(0)
    random.seed(0)
    numpy_random = sys.modules["numpy.random"]
    numpy_random.seed(0)
    numpy_random.bit_generator.randbits = source.getrandbits
    os.urandom = random._urandom = source.randbytes


# ---- cells ----


def whole(
    sources: list[str], needed: list, without: set[tuple], conversation: Conversation
) -> dict:
    """Run the cells as Jupyter does, but continue after errors; return their namespace."""
    from IPython.core.interactiveshell import InteractiveShell
    from IPython.utils.text import SList
    from traitlets.config import Config

    sys.path.insert(0, "")  # for modules that cells write
    shell = InteractiveShell.instance(config=Config({"HistoryManager": {"enabled": False}}))
    shell.enable_gui = shell.system = lambda *given, **named: (
        None
    )  # no window, no shell for the commands of cells
    shell.getoutput = lambda *given, **named: SList()
    for number, source in enumerate(sources):
        if (number, 0) in without:
            continue
        with conversation.running(number), contextlib.suppress(BaseException):
            result = shell.run_cell(source, store_history=True)
            note_missing(result.error_before_exec or result.error_in_exec, conversation.say)
        keep_the_name_of_the_checks(shell.user_ns)
    return shell.user_ns


def needed_only(
    sources: list[str], needed: list, without: set[tuple], conversation: Conversation
) -> dict:
    """Run only the statements that are needed, whatever fails; return their namespace.

    needed: [number of a cell, its text as Python, places of statements in it], see statements.py.
    """
    for number, source in enumerate(sources):
        text = [f"{line}\n" for line in source.split("\n")]
        linecache.cache[f"<cell {number}>"] = (len(source), None, text, f"<cell {number}>")
    module = types.ModuleType("__main__")
    space = vars(module)
    space["display"] = print
    sys.modules["__kept__"], sys.modules["__main__"] = sys.modules["__main__"], module
    for number, text, places in needed:
        body = ast.parse(text).body
        for tree in (body[place] for place in places):
            if (number, tree.lineno) in without:
                continue
            with conversation.running(number, tree.lineno):
                try:
                    exec(compile(ast.Module([tree], []), f"<cell {number}>", "exec"), space)
                except BaseException as error:  # also those that students derive from BaseException
                    note_missing(error, conversation.say)
    return space


def keep_the_name_of_the_checks(space: dict) -> None:
    """Give the name `check` back to the checks after a cell that assigned to it, as the notebook
    does."""
    checks = space.get("check")
    if isinstance(checks, types.ModuleType):
        space["__checks__"] = checks
    elif "__checks__" in space:
        space["check"] = space["__checks__"]


def note_missing(error: object, say: Callable) -> None:
    """Tell the name of a module that an import did not find."""
    if isinstance(error, ModuleNotFoundError) and isinstance(error.name, str):
        say(missing=error.name)


# ---- answers ----


def in_a_child(asked: dict, answer: Callable, checks: types.ModuleType, pass_on: Callable) -> dict:
    """Return {"reply": text} from a child process, or {"ended": why}.

    Calls of candidates, and of functions of the checks, are passed on.
    """
    from_child, to_parent = os.pipe()
    from_parent, to_child = os.pipe()
    try:
        child = fork_when_there_is_room()
    except OSError as error:
        return {"ended": f"no process for it could be made, {error}"}
    if child == 0:
        answer_and_end(to_parent, from_parent, asked, answer, checks)
    os.close(to_parent)
    os.close(from_parent)
    os.set_blocking(to_child, False)
    text, reason = read_reply(from_child, to_child, asked["reply"], pass_on)
    with contextlib.suppress(OSError):
        os.killpg(child, signal.SIGKILL)
    with contextlib.suppress(OSError):
        os.kill(child, signal.SIGKILL)
    os.close(from_child)
    os.close(to_child)
    _, status, usage = os.wait4(child, 0)
    if text.endswith("\n"):
        return {"reply": text[:-1]}
    computed = usage.ru_utime + usage.ru_stime
    return {"ended": reason, "status": os.waitstatus_to_exitcode(status), "computed": computed}


def fork_when_there_is_room() -> int:
    """Return what os.fork returns; wait a while if there are as many processes as are allowed.

    Those that an earlier answer started are killed with it, but count until they have ended.
    """
    end = time.monotonic() + ROOM_PATIENCE
    while True:
        try:
            return os.fork()
        except BlockingIOError:
            if time.monotonic() > end:
                raise
            time.sleep(ROOM_PAUSE)


def read_reply(
    from_child: int, to_child: int, max_bytes: int, pass_on: Callable
) -> tuple[str, str]:
    """Read lines from the child: calls, which begin with ?, then its reply.

    Return the reply and why it was cut. Only the reply is bounded by max_bytes, and each call
    separately: a test may call its candidates some thousand times.
    """
    buffer = b""
    while True:
        data = os.read(from_child, 1 << 20)
        buffer += data
        while buffer.startswith(b"?") and b"\n" in buffer:
            call, _, buffer = buffer.partition(b"\n")
            answer = pass_on(call[1:].decode(errors="replace"))
            if answer is None:
                return "", TOO_OFTEN
            if not write_in_time(to_child, answer.encode() + b"\n"):
                return "", NOT_READING
        too_long = len(buffer) > max_bytes
        if not data or buffer.endswith(b"\n") or too_long:
            return buffer.decode(errors="replace"), TOO_LONG if too_long else ""


def write_in_time(pipe: int, data: bytes) -> bool:
    """Write all of the data to a pipe that may be full; return whether it was read in time."""
    while data:
        try:
            data = data[os.write(pipe, data) :]
        except BlockingIOError:
            if not select.select([], [pipe], [], PATIENCE)[1]:
                return False
        except OSError:
            return False
    return True


def answer_and_end(
    to_parent: int, from_parent: int, asked: dict, answer: Callable, checks: types.ModuleType
) -> None:
    """In the child process: answer, and end this process in any case."""
    try:
        os.setpgid(0, 0)
        used = resource.getrusage(resource.RUSAGE_SELF)
        max_seconds = int(used.ru_utime + used.ru_stime + asked["cpu"])
        resource.setrlimit(resource.RLIMIT_CPU, (max_seconds, max_seconds + 1))
        begin_all_random_numbers_alike()
        lines = os.fdopen(from_parent, "rb")

        def consult(text: str) -> str:
            write(to_parent, b"?" + text.encode() + b"\n")
            return lines.readline().decode()

        checks.asking = consult
        write(to_parent, answer(consult).encode() + b"\n")
    finally:
        os._exit(0)


def write(pipe: int, data: bytes) -> None:
    """Write all of the data to a pipe."""
    while data:
        data = data[os.write(pipe, data) :]
