"""What ``make`` runs: the environment, the executed notebooks and the site."""

import errno
import sys
from types import TracebackType

STOPPED = (
    "Stopped by Ctrl-C. A file that was about to be written is as it was before. "
    "To begin again, repeat the command."
)
# What the machine refuses: a file without permission, a full disk. No traceback helps with these.
OF_THE_MACHINE = (errno.EACCES, errno.EPERM, errno.EROFS, errno.ENOSPC, errno.EDQUOT)
_print_error = sys.excepthook


def in_words(error: Exception) -> str:
    """Return what an error says, without the number that Python writes before an OSError.

    Examples
    --------
    >>> in_words(FileNotFoundError(2, "No such file or directory", "notebooks/07_x.ipynb"))
    'notebooks/07_x.ipynb: No such file or directory'
    """
    if isinstance(error, OSError) and error.strerror:
        return f"{error.filename}: {error.strerror}" if error.filename else error.strerror
    return str(error)


def report(kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
    """Print a sentence, and no traceback, when Ctrl-C or the machine ends a command.

    Python calls this for an error that nothing else handles. Every other error is printed as usual.
    """
    if isinstance(error, KeyboardInterrupt):
        print(f"\n{STOPPED}", file=sys.stderr)
    elif isinstance(error, OSError) and error.errno in OF_THE_MACHINE:
        print(f"Stopped. {in_words(error)}. Correct this and repeat the command.", file=sys.stderr)
    else:
        _print_error(kind, error, trace)


# Here, because a command of this package imports numpy and others next, which takes seconds on a
# slow machine, and one may press Ctrl-C meanwhile.
sys.excepthook = report
