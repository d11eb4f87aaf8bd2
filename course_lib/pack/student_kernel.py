"""A student's notebook in a kernel of its own, asked from outside: the stand-in that grading judges by.

Everything that comes out of the kernel is text that plain.read turns into numbers, lists and strings. The verdict
is formed here, where nothing the student's code does to its own interpreter can reach it. This keeps the verdict
apart; it is no sandbox: what the student's process may do to files and to other processes is not bounded here.
"""

import ast
import queue
import subprocess
import time

from jupyter_client.kernelspec import KernelSpecManager
from jupyter_client.manager import KernelManager

from course_lib.checks.plain import write

WALL_SECONDS = 120  # for one cell or one check; the CPU clock of ask.py is the tighter one
MOST_CHARACTERS = 100_000_000  # of one reply; the longest right one has about two million


class StudentKernel:
    """A kernel to run a student's cells in, as a context manager.

    folder: the working directory of the student's code.
    """

    def __init__(self, folder):
        self._folder = str(folder)

    def __enter__(self):
        # This environment's kernel, whatever the user has installed; encrypted, since others may listen here.
        here = KernelSpecManager(kernel_dirs=[])
        self._manager = KernelManager(kernel_spec_manager=here, kernel_name="python3", transport_encryption="auto")
        self._manager.start_kernel(cwd=self._folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self._client = self._manager.blocking_client()
        # Without the channel for outputs, no amount of them can fill this process's memory.
        self._client.start_channels(iopub=False, stdin=False)
        return self

    def __exit__(self, *raised):
        self._client.stop_channels()
        self._manager.shutdown_kernel(now=True)

    def run(self, source):
        """Run one cell. Returns None, or the name and message of the error it ended in."""
        return self._execute(source, {})[0]

    def function(self, name):
        """Return a student (see judge) that stands for the function of this name in the kernel."""
        if not name.isidentifier():
            raise ValueError(f"name must be the name of a function; it is {name!r}")
        return _Function(self, name)

    def evaluate(self, expression):
        """Return the string that the expression gives in the kernel, or None where it gives no string."""
        _, given = self._execute("", {"it": expression})
        try:
            text = given["it"]["data"]["text/plain"]
            value = ast.literal_eval(text) if len(text) <= MOST_CHARACTERS else None  # reads a literal; runs nothing
        except (LookupError, TypeError, AttributeError, ValueError, SyntaxError, RecursionError, MemoryError):
            return None
        return value if isinstance(value, str) else None

    def _execute(self, source, expressions):
        asked = self._client.execute(
            source,
            silent=False,
            store_history=False,
            user_expressions=expressions,
            allow_stdin=False,
            stop_on_error=False,
        )
        deadline = time.monotonic() + WALL_SECONDS
        while (left := deadline - time.monotonic()) > 0 and self._manager.is_alive():
            try:
                message = self._client.get_shell_msg(timeout=min(left, 1.0))
            except queue.Empty:
                continue
            if message["parent_header"].get("msg_id") == asked:
                content = message["content"]
                failed = content.get("status") == "error"
                error = f"{content.get('ename')}: {content.get('evalue')}" if failed else None
                return error, content.get("user_expressions", {})
        ended = f"more than {WALL_SECONDS} seconds" if self._manager.is_alive() else "the end of its kernel"
        return f"TimeUp: {ended}", {}


class _Function:
    def __init__(self, kernel, name):
        self._kernel, self._name = kernel, name

    def reply(self, questions):
        module = "__import__('course_lib.checks.ask', fromlist=['ask'])"
        text = self._kernel.evaluate(f"{module}.reply(globals().get({self._name!r}), {questions!r})")
        return text if text is not None else write("the kernel gave no answer")
