"""What ``make`` runs: the environment, the executed notebooks and the site."""

import sys
from types import TracebackType

STOPPED = (
    "Stopped by Ctrl-C. A file that was about to be written is as it was before. "
    "To begin again, repeat the command."
)
_print_error = sys.excepthook


def report_ctrl_c(
    kind: type[BaseException], error: BaseException, trace: TracebackType | None
) -> None:
    """Print a sentence instead of a traceback when Ctrl-C ends a command.

    Python calls this for an error that nothing else handles. Every other error is printed as usual.
    """
    if issubclass(kind, KeyboardInterrupt):
        print(f"\n{STOPPED}", file=sys.stderr)
    else:
        _print_error(kind, error, trace)


# Here, because a command of this package imports numpy and others next, which takes seconds on a
# slow machine, and one may press Ctrl-C meanwhile.
sys.excepthook = report_ctrl_c
