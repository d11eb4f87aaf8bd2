"""Run a notebook's cells and put questions to its functions: the script that is started in the sandbox.

All its output is only a claim, because the student's code runs in the same process and can forge it. It reads one JSON
object with the cells, and runs them. Then it reads requests {"ask": name, ...} until the end, and answers each in a
child process, so that a crash in one answer affects no other. If the object says "each", no student's code runs in this
process: each request is answered by a child that runs the cells for itself, and of which nothing is left afterwards.
What can be done without running the cells is done before.
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
import time
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

    def say(**message):
        write(replies, json.dumps(message).encode() + b"\n")

    importlib.import_module("numpy.random")  # numpy does so when it is first used: in each child process, again

    from course_lib.checks import call_student

    def tell(name, text):
        """Return a candidate's answer from the grader, for a student's test; None after too many calls."""
        say(exercise=name, call=text)
        return json.loads(requests.readline())["answer"]

    order = json.loads(requests.readline())
    each = order.get("each", False)
    plan = whole if order["whole"] else needed_only
    run = plan(order["cells"], order["names"], {tuple(place) for place in order["without"]}, each)
    if each:
        space, defined, alike = {}, order["names"], []
    else:
        space, defined, alike = run(say)
    say(defined=[name for name in order["names"] if name in defined], alike=alike)
    while line := requests.readline():
        asked = json.loads(line)
        name = asked["ask"]

        def answer(consult, name=name, asked=asked):
            if not each:
                return call_student.reply(space.get(name), asked["questions"], consult)
            os.close(requests.fileno())  # what is said to this child, or by it, goes through its own pipes
            os.close(replies)
            return call_student.reply(run(lambda **message: None)[0].get(name), asked["questions"], consult)

        say(exercise=name, **in_a_child(asked, answer, functools.partial(tell, name)))
        if each and settings["apart"]:
            leave_nothing()


def preload(trees):
    """Import what these statements import, from packages only, so that each child finds it loaded."""
    for node in (node for tree in trees for node in ast.walk(tree)):
        names = [alias.name for alias in node.names] if isinstance(node, ast.Import | ast.ImportFrom) else []
        if isinstance(node, ast.ImportFrom):
            names = [] if node.level else [node.module, *(f"{node.module}.{name}" for name in names)]
        for name in names:
            with contextlib.suppress(BaseException):
                importlib.import_module(name)


def leave_nothing():
    """End all other processes in these namespaces, and empty the folders that can be written to."""
    with contextlib.suppress(ProcessLookupError):
        while True:
            os.kill(-1, signal.SIGKILL)
            time.sleep(0.001)  # until the first process has reaped them
    for room in ("/scratch", "/tmp"):
        empty(room)
        with contextlib.suppress(OSError):  # where it is root's, no student can have set these
            os.chmod(room, 0o1777)
            for name in os.listxattr(room):
                os.removexattr(room, name)
            os.utime(room, (0, 0))
    shutil.copytree(f"{sys.argv[1]}/data", "data", dirs_exist_ok=True)


def empty(room):
    """Remove all in a folder, without recursion: what is in a folder there is moved up first."""
    count = 0
    while names := os.listdir(room):
        for name in names:
            path = os.path.join(room, name)
            if not os.path.isdir(path) or os.path.islink(path):
                os.unlink(path)
                continue
            os.chmod(path, 0o700)
            for inner in os.listdir(path):
                count += 1
                os.rename(os.path.join(path, inner), os.path.join(room, f"moved {count} {time.monotonic_ns()}"))
            os.rmdir(path)


# ---- cells ----


def whole(sources, names, without, each):
    """Return a function that runs the cells as Jupyter does, but continues after errors; see needed_only.

    each: whether to load beforehand what the cells import.
    """
    from IPython.core.interactiveshell import InteractiveShell
    from statements import statements, without_stubs
    from traitlets.config import Config

    cells = without_stubs(sources)
    if each:
        preload([found.tree for found in statements(sources)])

    def run(say):
        shell = InteractiveShell.instance(config=Config({"HistoryManager": {"enabled": False}}))
        for number, source in enumerate(cells):
            if (number, 0) in without:
                continue
            say(running=[number, 0])
            with contextlib.suppress(BaseException):
                shell.run_cell(source, store_history=False)
        return shell.user_ns, shell.user_ns, []

    return run


def needed_only(sources, names, without, each):
    """Return a function that runs only the statements that the functions of these names need, one after the other.

    It returns their namespace, all names that the cells bind, and the names of functions that would behave the same if
    only the statements that they themselves need had been run. each: whether to load beforehand what they import.
    """
    from statements import alike_alone, needed, statements

    for number, source in enumerate(sources):
        text = [f"{line}\n" for line in source.split("\n")]
        linecache.cache[f"<cell {number}>"] = (len(source), None, text, f"<cell {number}>")
    found = statements(sources)
    chosen = [one for one in needed(found, names) if (one.cell, one.tree.lineno) not in without]
    bound = {name for one in found for name in one.binds}
    alone = [] if without or each else alike_alone(found, names)
    if each:
        preload([one.tree for one in chosen])

    def run(say):
        module = types.ModuleType("__main__")
        space = vars(module)
        space["display"] = print
        sys.modules["__kept__"], sys.modules["__main__"] = sys.modules["__main__"], module
        left, alike = chosen, alone
        for _ in range(2):  # twice, for cells that a student moved before those that they need
            failed = []
            for one in left:
                say(running=[one.cell, one.tree.lineno])
                try:
                    exec(compile(ast.Module([one.tree], []), f"<cell {one.cell}>", "exec"), space)
                except NameError:
                    failed.append(one)
                except BaseException:
                    alike = []
            left = failed
        return space, bound, [] if left else alike

    return run


# ---- answers ----


def in_a_child(asked, answer, tell):
    """Return {"reply": text} from a child process, or {"ended": why}. Calls of candidates are passed on to `tell`."""
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
    """Read lines from the child: calls, which begin with ?, then its reply. Return the reply and why it was cut."""
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
            return buffer.decode(errors="replace"), "its answer is too long" if length > asked["reply"] else ""


def speak(pipe, answers, asked, answer):
    """In the child process: answer, and end this process in any case."""
    try:
        os.setpgid(0, 0)
        used = resource.getrusage(resource.RUSAGE_SELF)
        most = int(used.ru_utime + used.ru_stime + asked["cpu"])
        resource.setrlimit(resource.RLIMIT_CPU, (most, most + 1))
        random.seed(0)
        sys.modules["numpy.random"].seed(0)  # the same grade for the same file, even if it draws random numbers
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
