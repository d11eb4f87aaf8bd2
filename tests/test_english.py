"""No text has an idiom that was carried over from another language, or half a sentence.

All texts are searched: the notebooks' Markdown, strings and comments, the strings, docstrings and
comments of the package and its scripts, the guides, and the messages of make. Words are not
counted. A phrase that is right where it stands is allowed by its name, in ``ALLOWED``.
"""

import ast
import io
import re
import tokenize
from collections.abc import Iterator
from fnmatch import fnmatchcase as fnmatch
from functools import cache
from pathlib import Path
from typing import NamedTuple

import nbformat
import pytest

ROOT = Path(__file__).parents[1]
CONTEXT = 60  # characters before and after what was found, in a message


class Idiom(NamedTuple):
    """What is searched for, a sentence that has it, and the same sentence as it should be."""

    pattern: str
    carried_over: str
    better: str


IDIOMS = [
    Idiom(
        r"\b(is|are) to (return|hold|reach)\b",
        "The function is to return a pose.",
        "The function should return a pose.",
    ),
    Idiom(
        r"\balso (for|if|where|when|without)\b",
        "It must be right for every angle, also for 0.",
        "It must be right for every angle, including 0.",
    ),
    Idiom(
        r"\bafter the time\b",
        "After the time t the body has rotated by 90 degrees.",
        "At time t the body has rotated by 90 degrees.",
    ),
    Idiom(
        r"\bof the beginning\b",
        "the robot of the beginning",
        "the robot from the beginning of this notebook",
    ),
    Idiom(
        r"\bunit matri(x|ces)\b",
        "the unit matrix of size 3",
        "the 3 x 3 identity matrix",
    ),
    Idiom(
        r"\bone (\w+ )?a row\b",
        "the poses, one a row",
        "the poses, one per row",
    ),
    Idiom(
        r"\b(hours|answers|exercises|sittings|points) a (notebook|sitting|question|row)\b",
        "It takes 2.5 hours a sitting.",
        "It takes 2.5 hours per sitting.",
    ),
    Idiom(
        r"\bbeside the (target|goal|dock|right|true)\b",
        "a few millimetres beside the target",
        "a few millimetres from the target",
    ),
    Idiom(
        r"\bin proportion\b(?! to\b)",
        "Both joints move in proportion.",
        "Both joints move in proportion to each other.",
    ),
    Idiom(
        r"\bby itself\b",
        "each coordinate by itself",
        "each coordinate independently of the others",
    ),
    Idiom(
        r"\b(is|are|be|stays?) alike\b",
        "A turntable is alike.",
        "A turntable shows the same in a simpler case.",
    ),
    Idiom(
        r"(^|[.:!?] )Given (is|are)\b",
        "Given are the first leg and the poses.",
        "You are given the first leg and the poses.",
    ),
    Idiom(
        r"\bthe ones? before\b(?! the\b)",
        "the pose of a frame in the one before",
        "the pose of a frame relative to the previous frame",
    ),
    Idiom(r"\bpostures?\b", "the posture of the arm", "the configuration of the arm"),
    Idiom(
        r"\beven(ly)? (drawn|distributed|distribution)\b",
        "evenly drawn angles",
        "uniformly distributed angles",
    ),
    Idiom(
        r"\b(unturned|(half |quarter )?a turn)\b",
        "by half a turn",
        "by half a revolution",
    ),
    Idiom(
        r"\bturned\b(?! (into|off|on|out|back)\b)",
        "The target is turned by 90 degrees.",
        "The target is rotated by 90 degrees.",
    ),
    Idiom(
        r"\bwith a minus\b(?! sign\b)",
        "Its angle has to be taken with a minus.",
        "The sign of its angle must be changed.",
    ),
    Idiom(
        r"\bin your own lines\b",
        "Repair it in your own lines.",
        "Correct the code.",
    ),
    Idiom(
        r"\b(is|are) told\b(?! (apart|to|otherwise)\b)",
        "The student is told.",
        "The message names it.",
    ),
    Idiom(
        r"\ba person (reads|marks)\b",
        "A person reads them.",
        "Your instructor reads them.",
    ),
    Idiom(
        r"\b(right|wrong) ones\b",
        "It rejects the wrong ones.",
        "It rejects the wrong versions.",
    ),
    Idiom(
        r"\babove 0\b(?!\.\d)",
        "Keep eps above 0.",
        "Keep eps positive.",
    ),
    Idiom(
        r"\bjoints to spare\b",
        "an arm with joints to spare",
        "a redundant arm",
    ),
    Idiom(r"\ba trifle\b", "off by a trifle", "off by less than the tolerance"),
    Idiom(
        r"\bleads? nowhere\b",
        "The step leads nowhere.",
        "The method fails to converge.",
    ),
    Idiom(r"\bthird frame\b", "seen from the third frame", "the hybrid twist"),
    Idiom(
        r"(^|[.!?] )The same for\b",
        "The same for a UR5e.",
        "Here is the same comparison for a UR5e.",
    ),
    Idiom(
        r"\banother \w+ than\b",
        "Let it begin at another configuration than ready.",
        "Let it begin at a configuration other than ready.",
    ),
    Idiom(
        r"\band besides\b",
        "as in notebook 1, and besides",
        "The notation is that of notebook 1, with these additions:",
    ),
    Idiom(
        r"\bso it is with\b",
        "So it is with stored results.",
        "The same holds for stored results.",
    ),
    Idiom(
        r"(?<!there )\b(is|are) (?-i:none)\b(?! the less\b)",
        "What looks like an error and is none.",
        "What looks like an error but is not one.",
    ),
    Idiom(
        r"\bevery second time\b",
        "Every second time the joint rotates the wrong way.",
        "Half of the time the joint rotates the wrong way.",
    ),
    Idiom(
        r"\bwhat came\b(?! (back|from)\b)",
        "What came is of type int.",
        "The argument is of type int.",
    ),
    Idiom(
        r"\b(refus\w+ \d+ ?%|tests? (that )?refus\w+)",
        "A test that refuses 85 % of them earns a point.",
        "A test that rejects 85 % of them earns a point.",
    ),
    Idiom(
        r"\bwrite `\w+\([^`]*\)`: ",
        "Write `f(q)`: for q the pose.",
        "Write `f(q)`, which returns the pose at the joint angles q.",
    ),
    Idiom(
        r", and which (one|others)\b[^.?!]*\?",
        "Which joint keeps the height, and which one the position?",
        "Which joint leaves the height unchanged, and which joint leaves the position unchanged?",
    ),
]


# {(file or pattern of files, words around the idiom): why it is right there}
ALLOWED = {
    ("notebooks/01_rotations.ipynb", "multiply a rotation by itself"): "the product R R",
    ("notebooks/04_poe_kuka_iiwa.ipynb", "third frame"): "the report's own name for it",
    ("notebooks/05_panda_dh_ik.ipynb", "wrong ones"): "versions, or matches, named just before",
    ("course_lib/lessons/*/exercises/*.py", "right ones"): "answers or numbers named just before",
    ("course_lib/lessons/*/exercises/*.py", "wrong ones"): "versions named just before",
    ("course_lib/checks/*.py", "right ones"): "functions or answers named just before",
    ("course_lib/checks/*.py", "wrong ones"): "functions or versions named just before",
}


# ---- the texts ----


def strings(tree: ast.AST) -> Iterator[str]:
    """Yield the strings of Python code; what an f-string inserts is a pair of braces."""
    parts = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr):
            parts.update(id(part) for part in ast.walk(node))
            values = [v.value if isinstance(v, ast.Constant) else "{}" for v in node.values]
            yield "".join(values)
        value = getattr(node, "value", None)
        if isinstance(node, ast.Constant) and isinstance(value, str) and id(node) not in parts:
            yield value


def comments(source: str) -> str:
    """Return the comments of Python code as one text; empty lines separate those apart."""
    tokens = tokenize.generate_tokens(io.StringIO(source).readline)
    found = {token.start[0]: token.string for token in tokens if token.type == tokenize.COMMENT}
    lines = source.count("\n") + 1
    return "\n".join(found.get(number, "").lstrip("# ") for number in range(1, lines + 1))


def of_python(source: str) -> str:
    """Return the strings and the comments of Python code, as paragraphs."""
    return "\n\n".join([*strings(ast.parse(source)), comments(source)])


def of_javascript(source: str) -> str:
    """Return the comments and the strings of JavaScript, as paragraphs."""
    kinds = r"/\*.*?\*/|(?:(?<=\s)//[^\n]*\n\s*)+|\"(?:[^\"\\\n]|\\.)*\"|`(?:[^`\\]|\\.)*`"
    found = re.findall(kinds, source, re.DOTALL)
    return "\n\n".join(re.sub(r"^\s*(\*|//) ?", "", text, flags=re.MULTILINE) for text in found)


def of_notebook(path: Path) -> str:
    """Return the Markdown, the strings and the comments of a notebook, as paragraphs."""
    cells = nbformat.read(path, 4).cells
    texts = [
        cell.source if cell.cell_type == "markdown" else of_python(cell.source) for cell in cells
    ]
    return "\n\n".join(texts)


READERS = {".ipynb": of_notebook, ".py": lambda path: of_python(path.read_text("utf-8"))}
READERS[".js"] = lambda path: of_javascript(path.read_text("utf-8"))
PLACES = ("*.md", "Makefile", ".github/**/*.md", ".github/**/*.yml", "notebooks/*.md")
PLACES += ("notebooks/*.ipynb",)
PLACES += tuple(f"course_lib/**/*{ending}" for ending in (".py", ".js", ".sh", ".md", "Makefile"))
FILES = sorted({path for place in PLACES for path in ROOT.glob(place) if path.is_file()})


def paragraphs(path: Path) -> list[str]:
    """Return the paragraphs of a file's texts, each on one line."""
    reader = READERS.get(path.suffix)
    text = reader(path) if reader else path.read_text("utf-8")
    return [" ".join(paragraph.split()) for paragraph in re.split(r"\n\s*\n", text)]


@cache
def finds(path: Path) -> list[tuple[str, str, Idiom]]:
    """Return (what was found, the words around it, the idiom) for each idiom in a file."""
    found = []
    for text in paragraphs(path):
        for idiom in IDIOMS:
            for match in re.finditer(idiom.pattern, text, re.IGNORECASE):
                around = text[max(0, match.start() - CONTEXT) : match.end() + CONTEXT]
                found.append((match[0], around, idiom))
    return found


def is_allowed(name: str, around: str) -> bool:
    """Whether the words around an idiom hold a phrase that is allowed in this file."""
    return any(fnmatch(name, files) and phrase in around for files, phrase in ALLOWED)


# ---- the tests ----


@pytest.mark.parametrize("idiom", IDIOMS, ids=lambda idiom: idiom.carried_over)
def test_an_idiom_is_found_in_the_sentence_that_has_it(idiom):
    assert re.search(idiom.pattern, idiom.carried_over, re.IGNORECASE)
    assert not re.search(idiom.pattern, idiom.better, re.IGNORECASE)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_no_text_has_a_carried_over_idiom(path):
    name = path.relative_to(ROOT).as_posix()
    found = [
        f'"{words}" in "…{around}…". Instead of "{idiom.carried_over}" write "{idiom.better}"'
        for words, around, idiom in finds(path)
        if not is_allowed(name, around)
    ]
    assert not found, "\n".join([name, *found])


# Three words or more that are followed by the same words, with nothing between them. Two words may be
# right, as in "list of list of".
SAID_TWICE = re.compile(r"\b((?:[^\W\d_]+ ){2,}[^\W\d_]+) \1\b")


def test_words_that_are_said_twice_are_found():
    assert SAID_TWICE.search("on Binder and on Colab and on Colab")
    assert not SAID_TWICE.search("on Binder and on Colab, and on Colab alone")


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_no_text_says_the_same_words_twice_in_a_row(path):
    found = [match[0] for text in paragraphs(path) for match in SAID_TWICE.finditer(text)]
    assert not found


def test_every_allowance_is_needed():
    found = [
        (path.relative_to(ROOT).as_posix(), around)
        for path in FILES
        for _, around, _ in finds(path)
    ]
    for files, phrase in ALLOWED:
        assert any(fnmatch(name, files) and phrase in around for name, around in found), phrase
