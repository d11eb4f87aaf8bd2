"""What a file with a notebook's name really is, in words with which its student can mend it."""

import json
import re

SAVE = "Open your notebook in JupyterLab, save it, and hand in that file."
# How files of other kinds begin, and what they are.
SIGNATURES = {
    b"PK\x03\x04": "a zip, or a document of an office program",
    b"%PDF": "a PDF",
    b"\x1f\x8b": "a compressed file",
    b"7z\xbc\xaf": "a 7z archive",
    b"Rar!": "a RAR archive",
    b"\x89PNG": "a picture",
    b"\xff\xd8\xff": "a picture",
}
# A browser that saves a page of GitHub or of JupyterLab may give the page the notebook's name.
WEB_PAGE = re.compile(rb"(?:\xef\xbb\xbf)?\s*<(?:!doctype html|html)\b", re.IGNORECASE)
GIT_LFS = b"version https://git-lfs.github.com/"
MERGE = re.compile(rb"^(<{7}|={7}|>{7})(?: |\r?$)", re.MULTILINE)


def describe_other_file(content: bytes, problem: Exception) -> str:
    """Return sentences on a file that is no JSON: what it is instead, and what to do.

    problem: what json.loads raised.
    """
    for beginning, kind in SIGNATURES.items():
        if content.startswith(beginning):
            return f"It is {kind} with the name of a notebook. {SAVE}"
    if WEB_PAGE.match(content):
        return (
            "It is a web page with the name of a notebook: the browser saved the page that shows "
            f"the notebook. {SAVE}"
        )
    if content.startswith(GIT_LFS):
        return (
            "It only names a file that Git LFS keeps elsewhere, and does not hold the notebook. "
            f"{SAVE}"
        )
    if not content.strip(b"\0"):
        return f"It holds nothing but zeros, because it was not written to its end. {SAVE}"
    marker = MERGE.search(content)
    if marker:
        line = content.count(b"\n", 0, marker.start()) + 1
        return (
            f"It is half merged: line {line} begins with {marker[1].decode()}. Choose one of the "
            "two versions in a text editor, open the notebook in JupyterLab, save it, and hand it "
            "in again."
        )
    if isinstance(problem, UnicodeDecodeError):
        return f"It is not a notebook: its text is not encoded as UTF-8. {SAVE}"
    if isinstance(problem, json.JSONDecodeError):
        return f"{_no_json(problem)} {SAVE}"
    return f"It is not a notebook: it holds more than a notebook does. {SAVE}"


def _no_json(problem: json.JSONDecodeError) -> str:
    if not problem.doc.lstrip("\ufeff \t\r\n").startswith("{"):
        return "It is not a notebook: it does not begin with {, as every notebook does."
    at_the_end = problem.pos >= len(problem.doc.rstrip()) and problem.msg != "Extra data"
    if at_the_end or problem.msg.startswith("Unterminated string"):
        return f"It ends in the middle, in line {problem.lineno}."
    return f"It is not a notebook: line {problem.lineno} is not as JSON demands."
