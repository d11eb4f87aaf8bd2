"""Run a notebook's cells and put questions to its functions: the script that is started in the sandbox.

All its output is only a claim, because the student's code runs in the same process and can forge
it. It reads one JSON object with the cells, and runs them. Then it reads requests {"ask": name,
...} until the end, and answers each in a child process, so that a crash in one answer affects no
other. While the whole notebook runs, it says so at each of its checks, and answers requests about
the function that is checked, until one asks nothing.
"""

import ast
import contextlib
import functools
import importlib
import json
import linecache
import os
import random
import resource
import shutil
import signal
import sys
import threading
import types


def main():
    """Run the cells, then answer requests until the input ends."""
    course, settings = sys.argv[1], json.loads(sys.argv[2])
    sys.path[:0] = [course, *settings["packages"]]
    confine = importlib.import_module("confine").confine
    confine(settings["limits"], settings["uid"])
    requests, replies = os.fdopen(os.dup(0), "rb"), os.dup(1)
    nowhere = os.open(os.devnull, os.O_RDWR)
    for standard in (0, 1, 2):
        os.dup2(nowhere, standard)
    shutil.copytree(f"{course}/data", "data", dirs_exist_ok=True)
    importlib.import_module(
        "numpy.random"
    )  # numpy does so when it is first used: in each child process, again

    from course_lib import checks
    from course_lib.checks import call_student

    runner = os.getpid()

    def say(**message):
        write(replies, json.dumps(message).encode() + b"\n")

    def tell(name, text):
        """Return a candidate's answer from the grader, for a student's test; None after too many calls."""
        say(exercise=name, call=text)
        return json.loads(requests.readline())["answer"]

    def serve(find):
        """Answer requests about the functions that find(name) returns, until one asks nothing."""
        while (line := requests.readline()) and "ask" in (asked := json.loads(line)):
            answer = functools.partial(
                call_student.reply, find(asked["ask"]), asked["questions"], instead=asked["instead"]
            )
            say(
                exercise=asked["ask"],
                **in_a_child(asked, answer, functools.partial(tell, asked["ask"])),
            )

    def checked(name, function):
        """Let the grader ask now: what is right at its check counts, whatever a later cell does."""
        if os.getpid() == runner and threading.current_thread() is threading.main_thread():
            say(checked=name)
            serve({name: function}.get)

    order = json.loads(requests.readline())
    checks.checked = checked
    run = whole if order["whole"] else needed_only
    space = run(order["cells"], order["names"], {tuple(place) for place in order["without"]}, say)
    say(ran=True)
    serve(space.get)


# ---- cells ----


def whole(sources, names, without, say):
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
        say(running=[number, 0])
        with contextlib.suppress(BaseException):
            shell.run_cell(source, store_history=True)
    return shell.user_ns


def needed_only(sources, names, without, say):
    """Run only the statements that the functions of these names need, whatever fails; return their namespace."""
    from statements import needed, statements

    for number, source in enumerate(sources):
        text = [f"{line}\n" for line in source.split("\n")]
        linecache.cache[f"<cell {number}>"] = (len(source), None, text, f"<cell {number}>")
    module = types.ModuleType("__main__")
    space = vars(module)
    space["display"] = print
    sys.modules["__kept__"], sys.modules["__main__"] = sys.modules["__main__"], module
    for one in needed(statements(sources), names):
        if (one.cell, one.tree.lineno) not in without:
            say(running=[one.cell, one.tree.lineno])
            with contextlib.suppress(BaseException):
                exec(compile(ast.Module([one.tree], []), f"<cell {one.cell}>", "exec"), space)
    return space


# ---- answers ----


def in_a_child(asked, answer, tell):
    """Return {"reply": text} from a child process, or {"ended": why}.

    Calls of candidates are passed on to `tell`.
    """
    there, here = os.pipe()
    answers_there, answers_here = os.pipe()
    try:
        child = os.fork()
    except OSError as error:
        return {"ended": f"no process for it could be made, {error}"}
    if child == 0:
        speak(here, answers_there, asked, answer)
    os.close(here)
    os.close(answers_there)
    os.set_blocking(answers_here, False)
    text, reason = listen(there, answers_here, asked, tell)
    with contextlib.suppress(OSError):
        os.killpg(child, signal.SIGKILL)
    with contextlib.suppress(OSError):
        os.kill(child, signal.SIGKILL)
    os.close(there)
    os.close(answers_here)
    _, status, usage = os.wait4(child, 0)
    if text.endswith("\n"):
        return {"reply": text[:-1]}
    computed = usage.ru_utime + usage.ru_stime
    return {"ended": reason, "status": os.waitstatus_to_exitcode(status), "computed": computed}


def listen(there, answers_here, asked, tell):
    """Read lines from the child: calls, which begin with ?, then its reply.

    Return the reply and why it was cut.
    """
    buffer, length = b"", 0
    while True:
        data = os.read(there, 1 << 20)
        buffer, length = buffer + data, length + len(data)
        while buffer.startswith(b"?") and b"\n" in buffer:
            call, _, buffer = buffer.partition(b"\n")
            found = tell(call[1:].decode(errors="replace"))
            if found is None:
                return "", "it calls the functions that it tests too often"
            try:
                os.write(answers_here, found.encode() + b"\n")
            except OSError:
                return "", "it does not read what the functions that it tests answer"
        if not data or buffer.endswith(b"\n") or length > asked["reply"]:
            return buffer.decode(errors="replace"), "its answer is too long" if length > asked[
                "reply"
            ] else ""


def speak(pipe, answers, asked, answer):
    """In the child process: answer, and end this process in any case."""
    try:
        os.setpgid(0, 0)
        used = resource.getrusage(resource.RUSAGE_SELF)
        most = int(used.ru_utime + used.ru_stime + asked["cpu"])
        resource.setrlimit(resource.RLIMIT_CPU, (most, most + 1))
        random.seed(0)
        sys.modules["numpy.random"].seed(
            0
        )  # the same grade for the same file, even if it draws random numbers
        hear = os.fdopen(answers, "rb")

        def consult(text):
            write(pipe, b"?" + text.encode() + b"\n")
            return hear.readline().decode()

        write(pipe, answer(consult).encode() + b"\n")
    finally:
        os._exit(0)


def write(pipe, data):
    """Write all of the data to a pipe."""
    while data:
        data = data[os.write(pipe, data) :]


if __name__ == "__main__":
    main()
