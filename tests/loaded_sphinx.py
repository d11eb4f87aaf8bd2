"""Builds of small sites that share one Sphinx: to import it takes longer than to make a page.

A process imports Sphinx once for all tests of this process, and each build runs in a fork of it.
"""

import atexit
import contextlib
import importlib
import json
import os
import subprocess
import sys
import tempfile
import traceback
from functools import cache
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

from course_lib.pack.site import build as builder

COMMAND = [sys.executable, "-m", "sphinx"]


def build(*arguments, **settings):
    """Call course_lib.pack.site.build.build, which then finds Sphinx loaded."""
    with mock.patch.object(builder, "subprocess", SimpleNamespace(run=run)):
        builder.build(*arguments, **settings)


def run(command, **settings):
    """Do what subprocess.run does, for a command that runs Sphinx."""
    arguments = [str(word) for word in command]
    if arguments[:3] != COMMAND:
        return subprocess.run(command, **settings)
    server = loaded()
    print(json.dumps({"arguments": arguments[3:], "environment": dict(os.environ)}), file=server.stdin, flush=True)
    return SimpleNamespace(**json.loads(server.stdout.readline()))


@cache
def loaded():
    """The process that has imported Sphinx; it ends with this one."""
    server = subprocess.Popen([sys.executable, __file__], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    atexit.register(server.__exit__, None, None, None)  # closes its pipes and waits for it
    return server


def serve():
    """Run Sphinx in a fork for each line that comes in; answer with a line about how it ended."""
    import myst_nb.sphinx_ext  # noqa: F401
    from sphinx.application import builtin_extensions
    from sphinx.cmd.build import main

    for name in builtin_extensions:
        importlib.import_module(name)
    for line in sys.stdin:
        with tempfile.TemporaryFile("w+") as errors:
            child = os.fork()
            if child == 0:
                in_the_child(main, json.loads(line), errors)
            status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
            errors.seek(0)
            print(json.dumps({"returncode": status, "stderr": errors.read()}), flush=True)


def in_the_child(main, order, errors):
    """Run Sphinx with the arguments and in the environment of the order, and end this process."""
    status = 1
    try:
        os.dup2(errors.fileno(), 2)
        with open(os.devnull, "w", encoding="utf-8") as nowhere, contextlib.redirect_stdout(nowhere):
            os.environ.clear()
            os.environ.update(order["environment"])
            status = main(order["arguments"])
    except BaseException:
        traceback.print_exc()
    finally:
        sys.stderr.flush()
        os._exit(status)


if __name__ == "__main__":
    sys.path.remove(str(Path(__file__).parent))
    serve()
