"""Kill a program with SIGKILL before each step in which it changes a file or folder.

``python killed.py FOLDER COPIES PROGRAM [ARGUMENT ...]`` copies FOLDER to COPIES/1, COPIES/2, …,
runs the program's `main` in each, and kills it in copy N before its change number N. The last copy
is the first one in which it was not killed. PROGRAM is a module of the package, or a file in
FOLDER.
"""

import importlib
import os
import runpy
import shutil
import signal
import sys
from itertools import count
from pathlib import Path

CHANGES = ("os.rename", "os.remove", "os.rmdir", "os.mkdir", "os.chmod", "shutil.rmtree")


def changes(event, arguments):
    """Whether an audit event is about to change a file or folder."""
    if event == "open":
        flags = arguments[2] or 0
        return isinstance(flags, int) and bool(flags & (os.O_WRONLY | os.O_RDWR | os.O_CREAT))
    return event in CHANGES


def kill_before(step):
    """Have this process killed before its change of that number."""
    number = 0

    def watch(event, arguments):
        nonlocal number
        if changes(event, arguments):
            number += 1
            if number == step:
                os.kill(os.getpid(), signal.SIGKILL)

    sys.addaudithook(watch)


def run(step, program, arguments):
    """Run the program in this process until it is killed, and leave."""
    sys.argv = [program, *arguments]
    kill_before(step)
    if program.endswith(".py"):
        sys.path.insert(0, str(Path(program).parent.resolve()))  # as Python itself does
        runpy.run_path(program, run_name="__main__")
    sys.exit(importlib.import_module(program).main(arguments))


def was_killed(step, program, arguments):
    """Run the program in a copy of this process; return whether it was killed."""
    child = os.fork()
    if child == 0:
        run(step, program, arguments)
    _, status = os.waitpid(child, 0)
    if os.WIFSIGNALED(status):
        return True
    if status:
        sys.exit(f"{program} failed at step {step}")
    return False


if __name__ == "__main__":
    folder, copies, program, *arguments = sys.argv[1:]
    folder, copies = Path(folder).resolve(), Path(copies).resolve()
    sys.dont_write_bytecode = True
    if not program.endswith(".py"):
        importlib.import_module(program)  # once, for all copies of this process
    for step in count(1):
        shutil.copytree(folder, copies / str(step))
        os.chdir(copies / str(step))
        if not was_killed(step, program, arguments):
            break
