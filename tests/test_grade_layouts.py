"""However a student lays out a cell, what runs in Jupyter runs when it is graded."""

import ast
import itertools
import json

import pytest
from hostile.build import NAME, SEED, book
from IPython.core.inputtransformer2 import TransformerManager
from jupyter_client.manager import start_new_kernel

from course_lib.pack.grade.notebook_file import courses
from course_lib.pack.grade.statements import parsed, plain, statements
from course_lib.pack.grade.submission import grade

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
    "prompts": lambda source: "\n".join(f"{'>>>' if i == 0 else '...'} {s}" for i, s in enumerate(source.split("\n"))),
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


@pytest.fixture(scope="module")
def kernel():
    manager, client = start_new_kernel()
    yield client
    client.stop_channels()
    manager.shutdown_kernel(now=True)


JUDGED = """
import json
from course_lib.checks.exercise import Here, judge
from course_lib.checks.rotations import CHECKS
found = {c.exercise.name: judge(c.exercise, Here(globals().get(c.exercise.name))).state for c in CHECKS}
print(json.dumps({name: found[name] for name in ("is_valid", "matrix_to_quaternion", "nearest_se", "nearest_so")}))
"""


def in_a_kernel(kernel, cells):
    """{exercise: its state} of cells that a real kernel runs from a fresh start."""
    said = []
    kernel.execute_interactive("%reset -f", timeout=120)
    for source in [*cells, JUDGED]:
        kernel.execute_interactive(source, timeout=120, output_hook=said.append)
    texts = [message["content"]["text"] for message in said if message["msg_type"] == "stream"]
    return json.loads("".join(texts).strip().splitlines()[-1])


FOURS = [list(LAYOUTS)[i : i + 4] for i in range(0, len(LAYOUTS), 4)]


@pytest.mark.parametrize("layouts", FOURS, ids=", ".join)
def test_a_layout_earns_when_graded_what_is_right_in_a_kernel(few, layouts, kernel):
    """One layout for each of four exercises."""
    first, solutions = few
    solutions = [SPREAD if "def nearest_se" in source else source for source in solutions]
    used = list(zip(itertools.cycle(layouts), solutions, strict=False))
    cells = [first, *(LAYOUTS[layout](source.strip()) for layout, source in used)]
    states = in_a_kernel(kernel, cells)
    result = grade(book(*cells), NAME, SEED)
    assert {row["exercise"]: row["state"] for row in result["exercises"]} == states
    missing = [layout for layout, _ in used if layout == "an empty cell magic"]
    assert sorted(states.values()) == ["not attempted yet"] * len(missing) + ["right"] * (4 - len(missing))


@pytest.mark.parametrize("layout", LAYOUTS)
def test_every_answer_is_read_as_ipython_reads_it(solutions, layout):
    sources = [SPREAD, *(source for name in courses() for source in solutions(name))]
    for source in sources:
        cell = LAYOUTS[layout](source.strip()).replace("\r\n", "\n").replace("\r", "\n")
        wanted = ast.parse(TransformerManager().transform_cell(cell)).body
        if cell.lstrip().startswith("%%"):  # IPython passes the rest to the magic, as text
            body = next(node.args[2].value for node in ast.walk(wanted[0]) if isinstance(node, ast.Call))
            wanted = ast.parse(body).body if "script" not in cell[:9] else []
        assert [ast.dump(tree) for tree in parsed(cell)] == [ast.dump(tree) for tree in wanted], cell


def test_what_the_transformer_cannot_read_is_left_as_it_is():
    for source in ("x = (", "%" * 300, "!" + "(" * 5000, "?" * 100_001, "'''", "%%time", "%%", "\\"):
        assert isinstance(plain(source), str)
        assert isinstance(parsed(source), list)
    assert len(statements(["a = (\n  1\n  % 2\n)", "%time b = 1", "!c", "d = !e"])) == 4
