"""What a student's process claims, as far as it may go into feedback.

Feedback is read before the next hand-in. So a student's own text goes into it only as a plain
mistake needs it: the type of the error, the line of the notebook, and the first words of the
message. Otherwise an answer could carry the secret cases out, as the text of its errors.
"""

import builtins
import functools
import json
import re
from collections.abc import Sequence

from course_lib.checks.call_student import BOUNDS
from course_lib.checks.errors import UNWRITTEN

MAX_WORDS = 10  # of a message of an error or a warning
MAX_LETTERS = 60
LONG_NUMBER = re.compile(r"\d[\d.]{4,}")  # shapes and indices are shorter
OTHER_TYPE = "an exception of its own"
OF_LIBRARIES = ("LinAlgError", "AxisError", "UFuncTypeError", "SympifyError", "NotFittedError")
OF_CHECKS = ("NotPlain", "NotAllowed", "TimeUp", "NoNumber")
KNOWN_TYPES = frozenset(
    name for name, value in vars(builtins).items() if isinstance(value, type)
) | {*OF_LIBRARIES, *OF_CHECKS}


def first_words(text: object) -> str:
    """Return the first words of a text, without long numbers.

    Examples
    --------
    >>> first_words("shapes (3,) and (4,) differ")
    'shapes (3,) and (4,) differ'
    >>> first_words("M = [[0.4161468365471424, 1]]")
    'M = [[…, 1]]'
    """
    words = LONG_NUMBER.sub("…", str(text)[:2000]).split()
    short = " ".join(words[:MAX_WORDS])
    cut = len(words) > MAX_WORDS or len(short) > MAX_LETTERS
    return short[:MAX_LETTERS] + " …" if cut else short


def read_claims(text: str, sources: Sequence[str]) -> tuple[str, set[str]]:
    """Return a reply with texts that may be shown, and the names of the functions that were
    refused.

    text: a reply as call_student.reply returns it, or anything else, which is returned as it is.
    sources: of the notebook's cells.
    """
    try:
        claims = json.loads(text)
        for answer in claims["answers"]:
            _cut_texts(answer, tuple(sources))
        refused = {name for name in claims["refused"] if isinstance(name, str)}
        return json.dumps(claims), refused
    except (ValueError, LookupError, TypeError, AttributeError, RecursionError):
        return text, set()


def _cut_texts(answer: dict, sources: tuple[str, ...]) -> None:
    if "warning" in answer:
        answer["warning"] = first_words(answer["warning"])
    error = answer.get("error")
    if error is None:
        return
    kind, source, cell = (str(error.get(key) or "") for key in ("type", "source", "cell"))
    message = str(error.get("message") or "")
    source = source if source in _lines(sources) else ""
    if kind not in KNOWN_TYPES and not _is_written(kind, sources):
        kind = OTHER_TYPE
    if not _is_of_the_course(kind, message):
        message = first_words(message)
    caller = str(error.get("caller") or "")
    caller = caller if caller in _lines(sources) else ""
    error |= {"type": kind, "message": message, "source": source, "caller": caller}
    error["cell"] = cell if _is_written(cell, sources) else ""


def _is_of_the_course(kind: str, message: str) -> bool:
    """Return whether the message is one that the course's own code writes."""
    if kind == "NotImplementedError":
        return re.fullmatch(UNWRITTEN.format(r"\w{1,40}"), message) is not None
    if kind == "NotAllowed":
        return re.fullmatch(r"(check\.|the library's )?[\w.]{1,80}", message) is not None
    return kind == "TimeUp" and message in BOUNDS


def _is_written(name: str, sources: tuple[str, ...]) -> bool:
    """Return whether a name stands in the notebook."""
    if not re.fullmatch(r"[A-Za-z_]\w{0,40}", name):
        return False
    word = re.compile(rf"\b{name}\b")
    return any(map(word.search, sources))


@functools.lru_cache(maxsize=4)
def _lines(sources: tuple[str, ...]) -> frozenset[str]:
    """Return the lines of the notebook's cells, as an error shows them."""
    return frozenset(line.strip()[:200] for source in sources for line in source.split("\n"))
