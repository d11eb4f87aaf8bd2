"""Write files so that an interruption leaves the old content or the new one, never half of it."""

import os
import tempfile
from pathlib import Path

PART = ".part"  # suffix of an incomplete file; its name begins with a dot


def write_atomically(path: str | os.PathLike, content: str | bytes, mode: int = 0o600) -> None:
    """Replace a file by new content in one step, and create its folder if there is none.

    Parameters
    ----------
    path : path
        The file.
    content : str or bytes
        A string is written as UTF-8, with its newlines as they are.
    mode : int, default 0o600
        The permissions of a new file. A file that exists keeps its own.

    Raises
    ------
    OSError
        If the file cannot be written; it then stays as it was.
    """
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, part = tempfile.mkstemp(dir=path.parent, prefix=".", suffix=PART)
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(content.encode() if isinstance(content, str) else content)
        os.chmod(part, path.stat().st_mode & 0o777 if path.exists() else mode)
        os.replace(part, path)
    except BaseException as error:
        os.unlink(part)
        if isinstance(error, OSError) and not error.filename:  # a full disk does not say where
            error.filename = str(path)
        raise
