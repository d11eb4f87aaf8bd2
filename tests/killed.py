"""Kill an update with SIGKILL before each step that changes a file or folder, in a process of its own.

``python killed.py STEP PROGRAM [ARGUMENT ...]`` runs the program's `main` and prints nothing but what
it prints. PROGRAM is a module of the package, or the path of a file. STEP counts from 1; it exits
with the program's code if the program has fewer steps.
"""

import importlib
import os
import runpy
import signal
import sys

CHANGES = ("os.rename", "os.remove", "os.rmdir", "os.mkdir", "os.chmod", "shutil.rmtree")


def changes(event, arguments):
    """Whether an audit event is about to change a file or folder."""
    if event == "open":
        flags = arguments[2] or 0
        return isinstance(flags, int) and bool(flags & (os.O_WRONLY | os.O_RDWR | os.O_CREAT))
    return event in CHANGES


def kill_before(step):
    """Have this process killed before its next change of that number."""
    count = 0

    def watch(event, arguments):
        nonlocal count
        if changes(event, arguments):
            count += 1
            if count == step:
                os.kill(os.getpid(), signal.SIGKILL)

    sys.addaudithook(watch)


if __name__ == "__main__":
    step, program, *arguments = sys.argv[1:]
    sys.dont_write_bytecode = True
    if program.endswith(".py"):
        sys.argv = [program, *arguments]
        kill_before(int(step))
        runpy.run_path(program, run_name="__main__")
    else:
        main = importlib.import_module(program).main
        kill_before(int(step))
        sys.exit(main(arguments))
