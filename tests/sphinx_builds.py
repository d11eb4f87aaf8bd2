"""Builds of small sites that share one Sphinx: forks of a process that has imported it, which takes
longest."""

import os
import subprocess
import sys
import tempfile
from functools import cache
from multiprocessing import get_context
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
    with tempfile.NamedTemporaryFile("r", encoding="utf-8") as errors:
        child = forks().Process(target=in_the_child, args=(arguments[3:], errors.name))
        child.start()
        child.join()
        return SimpleNamespace(returncode=child.exitcode, stderr=errors.read())


@cache
def forks():
    """The context of processes in which Sphinx is imported."""
    from sphinx.application import builtin_extensions

    context = get_context("forkserver")
    context.set_forkserver_preload([*builtin_extensions, "sphinx.cmd.build", "myst_nb.sphinx_ext"])
    return context


def in_the_child(arguments, errors):
    """Run Sphinx; what it says goes to the file `errors`."""
    from sphinx.cmd.build import main

    with (
        open(errors, "w", encoding="utf-8") as file,
        open(os.devnull, "w", encoding="utf-8") as nowhere,
    ):
        os.dup2(file.fileno(), 2)
        os.dup2(nowhere.fileno(), 1)
        sys.exit(main(arguments))
