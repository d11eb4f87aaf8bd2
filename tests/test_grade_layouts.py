"""However a student lays out a cell, what runs in Jupyter runs when it is graded."""

import itertools
import re

import pytest
from hostile.build import NAME, SEED, book

from course_lib.pack.grade.verdicts.submission import grade

pytestmark = pytest.mark.filterwarnings("ignore:.make_tokens_by_line")
SPREAD = """
def nearest_se(T):
    dimension = (
        len(T)
        % (2 * 10)
        - 1
    )
    text = '''
%time
!ls
?'''
    corrected = np.eye(dimension + 1)
    U, _, Vt = np.linalg.svd(T[:-1, :-1])
    U[:, -1] *= np.linalg.det(U @ Vt)
    corrected[:-1, :-1] = (
        U
        @ Vt
    ) if text else None
    corrected[:-1, -1] = T[:-1, -1]
    return corrected
"""
SIGNS = "\u2028 \u2029 \x85 \f \x1c \v"  # which end a line for str.splitlines, and not for Python
LAYOUTS = {
    "as it is": lambda source: source,
    "magics": lambda source: "%matplotlib inline\n!true\nfiles = !ls\n" + source + "\nlen?\n?print",
    "timed": lambda source: "%%time\n" + source,
    "captured": lambda source: "\n%%capture output\n" + source,
    "prompts": lambda source: "\n".join(
        f"{'>>>' if i == 0 else '...'} {s}" for i, s in enumerate(source.split("\n"))
    ),
    "In [3]:": lambda source: "In [3]: " + source.replace("\n", "\n   ...: "),
    "indented": lambda source: "    " + source.replace("\n", "\n    "),
    "Windows": lambda source: source.replace("\n", "\r\n"),
    "old Mac": lambda source: source.replace("\n", "\r"),
    "help after it": lambda source: source + "\n\nnp.linalg.svd?",
    "a magic in a block": lambda source: source + "\nif True:\n    %precision 3\n    done = 1\n",
    "commands in brackets": lambda source: source + "\nprint('%s'\n% 'x')\nfound = !echo\n",
    "an empty cell magic": lambda source: "%%script false\nnot Python",
    "signs in a comment": lambda source: f"# pasted {SIGNS} text\n{source}",
}
# What a function F may need besides the statements that name it. right_F is a right answer. Cells
# end with "# %%".
NEEDS = {
    "a comprehension": (
        "T_F = []\n[T_F.append(n) for n in range(5)]\ndef F(*a): T_F[4]; return right_F(*a)"
    ),
    "a loop": (
        "T_F = {}\ndef put(t, n): t[n] = 1\nfor n in (2, 3): put(T_F, n)\ndef F(*a): T_F[3]; "
        "return right_F(*a)"
    ),
    "a condition": (
        "T_F = {}\ndef put(t): t[2] = 1\nif T_F == {}: put(T_F)\ndef F(*a): T_F[2]; return "
        "right_F(*a)"
    ),
    "an assignment": (
        "T_F = []\ndef put(t): t.append(1)\nok = put(T_F)\ndef F(*a): T_F[0]; return right_F(*a)"
    ),
    "a keyword": (
        "T_F = []\ndef put(t): t.append(1)\nput(t=T_F)\ndef F(*a): T_F[0]; return right_F(*a)"
    ),
    "another name": (
        "T_F = {}\nalias = T_F\nalias['k'] = 1\ndef F(*a): T_F['k']; return right_F(*a)"
    ),
    "global": "def setup():\n    global K\n    K = 1\nsetup()\ndef F(*a): K; return right_F(*a)",
    "a default": (
        "def setup():\n    global L\n    L = 1\ndef F(*a, k=setup()): L; return right_F(*a)"
    ),
    "decorators": (
        "T_F = {}\ndef register(f):\n    T_F[f.__name__] = f\n    return f\n@register\ndef"
        " one(*a):\n    return right_F(*a)\ndef F(*a): return T_F['one'](*a)"
    ),
    "subclasses": (
        "class Base: pass\nclass One(Base):\n    def work(self, *a): return right_F(*a)\n"
        "def F(*a): return Base.__subclasses__()[0]().work(*a)"
    ),
    "singledispatch": (
        "import functools\n@functools.singledispatch\ndef dispatch(X, *a): raise TypeError\n"
        "@dispatch.register\ndef _(X: np.ndarray, *a): return right_F(X, *a)\ndef F(*a): return "
        "dispatch(*a)"
    ),
    "numpy's errors": (
        "np.seterr(divide='raise')\ndef F(*a):\n    try:\n        1 / np.zeros(1)\n"
        "    except FloatingPointError:\n        return right_F(*a)"
    ),
    "a module's attribute": "import math\nmath.mine = 1\ndef F(*a): math.mine; return right_F(*a)",
    "annotations": (
        "from __future__ import annotations\nfrom typing import TYPE_CHECKING\nif TYPE_CHECKING:\n "
        "   from numpy.typing import NDArray\n# %%\ndef F(*a: NDArray) -> NDArray: return"
        " right_F(*a)"
    ),
    "processes": (
        "from multiprocessing import Pool\nwith Pool(2) as pool:\n    S = pool.map(abs, [-1, -2])\n"
        "def F(*a): S[1]; return right_F(*a)"
    ),
    "a module of its own": (
        "%%writefile own_F.py\nvalue = 3\n# %%\nimport own_F\n"
        "def F(*a): own_F.value; return right_F(*a)"
    ),
    "await": (
        "async def soon(): return 1\n# %%\nA_F = await soon()\n# %%\ndef F(*a): A_F; return "
        "right_F(*a)"
    ),
    "a command": (
        "!echo\nlines = !echo\nC = 1\nfor _ in lines: pass\ndef F(*a): C; return right_F(*a)"
    ),
    "a later name": (
        "from numpy import exp\ndef F(*a): exp(1.0); return right_F(*a)\n"
        "# %%\ncheck.F(F)\n# %%\nexp = None"
    ),
    "another function at the check": "def mine(*a): return right_F(*a)\n# %%\ncheck.F(mine)",
}


FOURS = [list(LAYOUTS)[i : i + 4] for i in range(0, len(LAYOUTS), 4)]


@pytest.mark.parametrize("layouts", FOURS, ids=", ".join)
def test_a_layout_earns_all_points(few, layouts):
    """One layout for each of four exercises."""
    first, solutions = few
    solutions = [SPREAD if "def nearest_se" in source else source for source in solutions]
    used = list(zip(itertools.cycle(layouts), solutions, strict=False))
    cells = [first, *(LAYOUTS[layout](source.strip()) for layout, source in used)]
    rows = grade(book(*cells), NAME, SEED)["exercises"]
    missing = [layout for layout, _ in used if layout == "an empty cell magic"]
    assert sorted(row["state"] for row in rows) == ["not attempted yet"] * len(missing) + [
        "right"
    ] * (4 - len(missing))


FOUR_NEEDS = [list(NEEDS)[i : i + 4] for i in range(0, len(NEEDS), 4)]


@pytest.mark.parametrize("needs", FOUR_NEEDS, ids=", ".join)
def test_whatever_a_function_needs_is_there_when_graded(few, needs):
    first, solutions = few
    names = [re.search(r"def (\w+)", source)[1] for source in solutions]
    cells = [first]
    for need, name, source in zip(needs, names, solutions, strict=False):
        cells.append(re.sub(rf"\b{name}\b", f"right_{name}", source))
        layout = NEEDS[need] if "check.F" in NEEDS[need] else f"{NEEDS[need]}\n# %%\ncheck.F(F)"
        cells += re.sub(r"\bF\b|(?<=_)F\b", name, layout).split("\n# %%\n")
    found = {row["exercise"]: row for row in grade(book(*cells), NAME, SEED)["exercises"]}
    assert {name: found[name]["state"] for name in names[: len(needs)]} == dict.fromkeys(
        names[: len(needs)], "right"
    ), {name: found[name]["message"] for name in names[: len(needs)]}
