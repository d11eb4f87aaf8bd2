"""Find the statements of a notebook that its functions need, from the source alone.

A notebook may draw and print for a minute, but defining its functions takes a moment. What a
function needs is found by names: every statement that binds or changes a name that the function
reads, and what that statement reads in turn.
"""

import ast
import bisect
import functools
import itertools
import re
import symtable
import types
import warnings
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from course_lib.arms import SerialArm

RUNS_ITS_CELL = (
    "time",
    "timeit",
    "capture",
    "prun",
    "python",
    "python3",
)  # cell magics around plain Python
MAX_TRANSFORMED = 100_000  # characters of a cell that IPython reads once for each of its magics
FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)
SCOPES = (*FUNCTIONS, ast.Lambda, ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)
IMPORTS = (ast.Import, ast.ImportFrom)
SIMPLE = (
    *FUNCTIONS,
    *IMPORTS,
    ast.Assign,
)  # they always bind their names, whatever was bound before
# The methods by which containers and arrays change themselves: what only the changing one of two
# types has.
CHANGING = {"fill", "put", "partition", "resize", "setfield", "setflags", "byteswap"}.union(
    *(
        set(dir(kind)) - set(dir(lasting))
        for kind, lasting in ((list, tuple), (set, frozenset), (dict, types.MappingProxyType))
    )
)
# The methods of containers, arrays and arms that return something new.
_KEEPING = {name for kind in (list, dict, np.ndarray, SerialArm) for name in dir(kind)} - CHANGING


@dataclass
class Statement:
    """One statement at the top of a cell, and the names it binds, reads and changes.

    cell, place: the numbers of the cell and of the statement in it, from 0. methods: the methods
    that it calls, each with the name in front of it.
    """

    cell: int
    place: int
    tree: ast.stmt
    binds: set = field(default_factory=set)
    reads: set = field(default_factory=set)
    changes: set = field(default_factory=set)
    methods: set = field(default_factory=set)


def statements(sources: Sequence[str], given: Collection[int] = ()) -> list[Statement]:
    """Return the Statements of a notebook's code cells, without stubs of functions that other cells
    define.

    A method may change what it is called on. It is known not to if only the cells of these numbers,
    which are as students are given them, say what that is.
    """
    in_order = [
        _looked_at(number, place, tree)
        for number, source in enumerate(sources)
        for place, tree in enumerate(parsed(source))
    ]
    own = {name for each in in_order if each.cell not in given for name in each.binds}
    for each in in_order:
        each.changes |= {
            name for name, method in each.methods if name in own or method not in _KEEPING
        }
    written = {
        name for statement in in_order if not is_stub(statement.tree) for name in statement.binds
    }
    return [
        statement
        for statement in in_order
        if not (is_stub(statement.tree) and statement.tree.name in written)
    ]


def stubs_only(in_order: Sequence[Statement]) -> set[str]:
    """Return the names of the functions that a notebook defines, but has not begun to write."""
    stubs, written = set(), set()
    for statement in in_order:
        names = stubs if is_stub(statement.tree) else written
        names |= statement.binds
    return stubs - written


def needed(in_order: Sequence[Statement], names: Sequence[str]) -> list[Statement]:
    """Return the Statements that functions of these names need: those that affect what they read.

    A function reads names when it is called, so the search begins before the statement that
    mentions the function.
    """
    imported = {
        name
        for statement in in_order
        if isinstance(statement.tree, IMPORTS)
        for name in statement.binds
    }
    places = {}  # {name: positions of the statements that bind or change it}
    for position, statement in enumerate(in_order):
        for name in statement.binds | (statement.changes - imported):
            places.setdefault(name, []).append(position)
    kept, left, seen = set(), [(name, len(in_order)) for name in [*names, "*"]], set()
    while left:
        name, end = left.pop()
        if (name, end) in seen:
            continue
        seen.add((name, end))
        positions = places.get(name, [])
        for position in reversed(positions[: bisect.bisect_left(positions, end)]):
            statement = in_order[position]
            kept.add(position)
            later = end if isinstance(statement.tree, FUNCTIONS) else position
            left += [(read, later) for read in statement.reads]
            if name in statement.binds and isinstance(statement.tree, SIMPLE):
                break
    return [in_order[position] for position in sorted(kept)]


def as_sent(needed_ones: Sequence[Statement], sources: Sequence[str]) -> list:
    """Return [number of a cell, its text as Python, places of statements in it] of what is
    needed."""
    by_cell = itertools.groupby(needed_ones, key=lambda statement: statement.cell)
    return [
        [cell, plain(sources[cell]), [statement.place for statement in in_cell]]
        for cell, in_cell in by_cell
    ]


# ---- the text of a cell ----


@functools.lru_cache(maxsize=1000)
def plain(source: str) -> str:
    """Return a cell as Python: itself if it is, else what IPython makes of its magics, commands and
    prompts."""
    if tree_of(source) is not None or len(source) > MAX_TRANSFORMED:
        return source
    from IPython.core.inputtransformer2 import (
        TransformerManager,
    )  # here, because few notebooks need it

    first, _, rest = source.lstrip().partition("\n")
    if first.startswith(
        "%%"
    ):  # the rest of a cell that is timed is run as it is; other magics take it as text
        return f"\n{plain(rest)}" if first[2:].partition(" ")[0] in RUNS_ITS_CELL else ""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return TransformerManager().transform_cell(source)
    except (SyntaxError, ValueError, RuntimeError, RecursionError, MemoryError):
        return source


def tree_of(source: str) -> ast.Module | None:
    """Return the ast of a text; None if it is not Python."""
    try:
        return ast.parse(source)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None


def parsed(source: str) -> list[ast.stmt]:
    """Return the statements of a cell; none if the cell is not valid Python."""
    tree = tree_of(plain(source))
    return tree.body if tree else []


def no_python(sources: Sequence[str], name: str) -> str:
    """Return why a cell that begins to define this function is not valid Python; "" if there is no
    such cell."""
    for number, source in enumerate(sources, 1):
        if not re.search(rf"^def[ \t]+{name}\b", source, re.MULTILINE):
            continue
        try:
            ast.parse(plain(source))
        except SyntaxError as error:
            line = (error.text or "").strip()[:100]
            return (
                f"Code cell {number} is not Python: {error.msg}, in line {error.lineno}, `{line}`."
            )
        except (ValueError, RecursionError, MemoryError):
            return f"Code cell {number} is not Python."
    return ""


def is_stub(tree: ast.stmt) -> bool:
    """Return whether a statement is a function that only raises NotImplementedError."""
    if not isinstance(tree, ast.FunctionDef):
        return False
    body = [
        line
        for line in tree.body
        if not (isinstance(line, ast.Expr) and isinstance(line.value, ast.Constant))
    ]
    names = (node.id for line in body for node in ast.walk(line) if isinstance(node, ast.Name))
    return len(body) == 1 and isinstance(body[0], ast.Raise) and "NotImplementedError" in names


# ---- one statement ----


def _looked_at(cell: int, place: int, tree: ast.stmt) -> Statement:
    statement = Statement(cell, place, tree)
    statement.reads = _read(tree)
    _bound(tree, statement.binds)
    for node in _outside_scopes(tree):
        if isinstance(node, ast.Subscript | ast.Attribute) and not isinstance(node.ctx, ast.Load):
            statement.changes |= base_of(node)
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            statement.methods |= {(name, node.func.attr) for name in base_of(node.func)}
    if (
        isinstance(tree, ast.Expr)
        and isinstance(tree.value, ast.Call)
        and not _only_shows(tree.value)
    ):
        statement.changes |= {node.id for node in tree.value.args if isinstance(node, ast.Name)}
    if isinstance(tree, FUNCTIONS):
        statement.changes, statement.methods = set(), set()
    return statement


def _read(tree: ast.stmt) -> set[str]:
    """Return the global names that a statement reads, or that the function it defines reads when
    called."""
    nodes = [*ast.walk(tree)]
    if not any(isinstance(node, SCOPES) for node in nodes):  # then there is nothing to work out
        return {
            node.id
            for node in nodes
            if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)
        }
    try:
        left, names = [symtable.symtable(ast.unparse(tree), "", "exec")], set()
        while left:
            table = left.pop()
            top = table.get_type() == "module"
            names |= {
                one.get_name()
                for one in table.get_symbols()
                if one.is_referenced() and (top or one.is_global())
            }
            left += table.get_children()
        return names
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}


def _bound(tree: ast.stmt, names: set[str]) -> None:
    """Add the names that a statement binds at the top of the notebook."""
    for node in _outside_scopes(tree):
        if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load):
            names.add(node.id)
        elif isinstance(node, FUNCTIONS):
            names.add(node.name)
        elif isinstance(node, ast.alias):
            names.add((node.asname or node.name).partition(".")[0])
        elif isinstance(node, ast.ExceptHandler | ast.MatchAs | ast.MatchStar) and node.name:
            names.add(node.name)


def _outside_scopes(tree: ast.AST) -> Iterator[ast.AST]:
    """Yield every node of the tree except those in functions, classes and comprehensions."""
    left = [tree]
    while left:
        node = left.pop()
        yield node
        if not isinstance(node, SCOPES):
            left += ast.iter_child_nodes(node)


def base_of(node: ast.AST) -> set[str]:
    """Return the name at the beginning of a.b[0].c, as a set."""
    while isinstance(node, ast.Subscript | ast.Attribute | ast.Call):
        node = node.func if isinstance(node, ast.Call) else node.value
    return {node.id} if isinstance(node, ast.Name) else set()


def _only_shows(call: ast.Call) -> bool:
    name = call.func.id if isinstance(call.func, ast.Name) else ""
    return name in ("print", "show", "display") or "check" in base_of(call.func)
