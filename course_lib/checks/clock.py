"""A clock of processor time, which ends a computation in the same process."""

import contextlib
import signal
import threading
from collections.abc import Callable, Iterator


@contextlib.contextmanager
def cpu_clock(seconds: float, error: type[BaseException], text: str) -> Iterator[Callable]:
    """Raise error(text) in the block after so many seconds of processor time.

    The error is raised again after each further second, because code that is interrupted may
    swallow the first one. The error should not be an Exception, which `except Exception` swallows.

    The clock has no effect outside the main thread, where Python runs no signal handlers, and on
    Windows, which has no such clock.

    Parameters
    ----------
    seconds : float
    error : type
        An exception that is made with one text.
    text : str

    Yields
    ------
    callable
        Without arguments; it starts the clock again.

    Examples
    --------
    >>> with cpu_clock(10, TimeoutError, "more than 10 seconds") as start_again:
    ...     start_again()
    """

    def ring(signum, frame):
        raise error(text)

    def start() -> None:
        signal.setitimer(signal.ITIMER_PROF, seconds, 1)

    in_main_thread = threading.current_thread() is threading.main_thread()
    if not hasattr(signal, "setitimer") or not in_main_thread:
        yield lambda: None
        return
    earlier = signal.signal(signal.SIGPROF, ring)
    try:
        start()
        yield start
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, earlier)
