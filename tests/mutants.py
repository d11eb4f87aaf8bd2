"""Small mistakes made in the notebooks' own solutions by machine, one at a time."""

import ast
import builtins
import contextlib
import importlib
import math
import warnings
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import nbformat

NOTEBOOKS = Path(__file__).parent.parent / "notebooks"

OTHER_COMPARISON = {
    ast.Lt: [ast.LtE, ast.Gt],
    ast.LtE: [ast.Lt, ast.GtE],
    ast.Gt: [ast.GtE, ast.Lt],
    ast.GtE: [ast.Gt, ast.LtE],
    ast.Eq: [ast.NotEq],
    ast.In: [ast.NotIn],
}
PAIRS = [
    ("sin", "cos"),
    ("arcsin", "arccos"),
    ("min", "max"),
    ("argmin", "argmax"),
    ("floor", "ceil"),
]
PAIRS += [("ones", "zeros"), ("any", "all"), ("hstack", "vstack")]
OTHER_NAME = {old: new for a, b in PAIRS for old, new in ((a, b), (b, a))}
EVEN = ("abs", "cos", "len", "norm", "zeros")  # which take no notice of the sign
SIGNED = (ast.Name, ast.BinOp, ast.Call, ast.Subscript, ast.Attribute)
MAX_ENTRIES = 10**6  # of an answer


@dataclass(frozen=True)
class Mutant:
    """A solution with one change: its kind, the changed line (numbered where two look alike), and
    the whole source."""

    kind: str
    line: str
    source: str


def mutants(source):
    """Return every Mutant of the function whose source is given; no two with the same text."""
    tree = ast.parse(source)
    function = next(node for node in tree.body if isinstance(node, ast.FunctionDef))
    function.body = _reached(function.body[1:])  # without the docstring
    original = ast.unparse(tree)
    found, lines, seen = [], {}, {original}
    for holder, key, parent, in_index in _places(ast.Module(function.body)):
        node = holder[key]
        for kind, other in _changes(node, parent, key, in_index):
            holder[key] = other
            text = ast.unparse(tree)
            holder[key] = node
            if text not in seen:
                seen.add(text)
                line = _first_difference(original, text)
                lines[line] = lines.get(line, 0) + 1
                found.append(
                    Mutant(kind, line if lines[line] == 1 else f"{line} ({lines[line]})", text)
                )
    return found


def _reached(statements):
    """The statements up to the first return: below it, an exercise on finding a bug keeps its
    broken code."""
    ends = (k for k, statement in enumerate(statements) if isinstance(statement, ast.Return))
    return statements[: next(ends, len(statements)) + 1]


def spread(found, most):
    """Return at most so many of the mutants, taken in turn from each kind, and from everywhere in
    the function."""
    kinds = {}
    for mutant in found:
        kinds.setdefault(mutant.kind, []).append(mutant)
    shares = dict.fromkeys(kinds, 0)
    for _ in range(min(most, len(found))):
        least_served = max(kinds, key=lambda kind: (shares[kind] < len(kinds[kind]), -shares[kind]))
        shares[least_served] += 1
    return [
        each[k * len(each) // share]
        for kind, each in kinds.items()
        for share in [shares[kind]]
        for k in range(share)
    ]


def _first_difference(original, text):
    """The changed line."""
    old, new = original.splitlines(), text.splitlines()
    at = next(
        (k for k, pair in enumerate(zip(old, new, strict=False)) if pair[0] != pair[1]),
        len(new) - 1,
    )
    return (
        f"without {old[at].strip()}"
        if len(old) != len(new) or new[at].strip() == "pass"
        else new[at].strip()
    )


def _places(parent, in_index=False):
    """Each (holder, key, parent, in_index): holder[key] is a node below the parent, within an index
    or not."""
    for field, value in ast.iter_fields(parent):
        holder, keys = (
            (value, range(len(value))) if isinstance(value, list) else (vars(parent), [field])
        )
        inside = in_index or (isinstance(parent, ast.Subscript) and field == "slice")
        for key in keys:
            if isinstance(holder[key], ast.AST):
                yield holder, key, parent, inside
                yield from _places(holder[key], inside)


def _changes(node, parent, key, in_index):
    """Each (kind, other node) that may stand in this place."""
    if isinstance(getattr(node, "ctx", None), ast.Store):
        return
    if isinstance(node, ast.If | ast.AugAssign | ast.Expr) or _sets_entries(node):
        yield "statement", ast.Pass()
    if isinstance(node, ast.cmpop):
        yield from (("comparison", other()) for other in OTHER_COMPARISON.get(type(node), ()))
    if isinstance(node, ast.BoolOp):
        yield from (("condition", side) for side in node.values)
    if isinstance(node, ast.BinOp) and not isinstance(node.op, ast.Add | ast.Sub):
        yield from (("factor", side) for side in (node.left, node.right))
    if (
        isinstance(node, ast.Constant)
        and type(node.value) in (int, float)
        and _called(parent) != "default_rng"
    ):
        others = [node.value + 1] if in_index or node.value in (0, 1) else []
        others += (
            [node.value * 1.1] if abs(node.value) > 1e-3 and not in_index else []
        )  # no tolerance
        others += [-node.value] if node.value and not in_index else []
        yield from (("constant", ast.parse(repr(other), mode="eval").body) for other in others)
    if isinstance(node, ast.UnaryOp):
        yield "sign", node.operand
    elif isinstance(node, SIGNED) and _has_sign(parent, key) and not in_index:
        yield "sign", ast.UnaryOp(ast.USub(), node)
    yield from _other_names(node)


def _other_names(node):
    if isinstance(node, ast.Attribute) and node.attr == "T":
        yield "transpose", node.value
    if isinstance(node, ast.Attribute) and node.attr in OTHER_NAME:
        yield "name", ast.Attribute(node.value, OTHER_NAME[node.attr], node.ctx)
    if isinstance(node, ast.Name):
        if node.id in OTHER_NAME and hasattr(builtins, node.id):
            yield "name", ast.Name(OTHER_NAME[node.id], node.ctx)
        if node.id[0].isupper():  # most of them are matrices
            yield "transpose", ast.Attribute(node, "T", ast.Load())


def _sets_entries(node):
    """Whether a statement sets entries of what is there already: it can be left out."""
    return isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Subscript)


def _has_sign(parent, key):
    """Whether the sign of what stands here matters: a value, an item of a list, a first argument or
    a first term."""
    if isinstance(parent, ast.Return | ast.Assign):
        return key == "value"
    if isinstance(parent, ast.BinOp):
        return key == "left" and isinstance(parent.op, ast.Add)
    if isinstance(parent, ast.Call):
        return key == 0 and _called(parent) not in EVEN
    return isinstance(parent, ast.List | ast.Tuple)


def _called(node):
    """The last name of the function that a node calls."""
    return ast.unparse(node.func).rpartition(".")[2] if isinstance(node, ast.Call) else ""


@cache
def solved(name):
    """What a notebook's solutions are called in, as {name: value}, and their sources, as {exercise:
    source}.

    A solution that calls another one gets the library's function instead, which is faster.
    """
    cells = [
        cell
        for cell in nbformat.read(NOTEBOOKS / f"{name}.ipynb", 4).cells
        if cell.cell_type == "code"
    ]
    own = [cell for cell in cells if cell.metadata.get("nbgrader", {}).get("solution")]
    sources = {cell.metadata.nbgrader.grade_id: cell.source for cell in own}
    given = [
        statement
        for cell in cells[1:]
        if cell not in own
        for statement in ast.parse(cell.source).body
    ]
    space = {"__name__": name, "passes": Passes()}
    with contextlib.chdir(NOTEBOOKS):  # where the notebooks find their data
        exec(cells[0].source, space)
        wanted = set().union(
            *(_read(ast.parse(source).body[0]) for source in sources.values())
        ) - set(space)
        for part in [*sources.values(), *map(ast.unparse, _needed(given, wanted, set(space)))]:
            exec(part, space)
    checks = importlib.import_module(f"course_lib.lessons.{name.partition('_')[2]}.check").CHECKS
    right = {
        check.exercise.name: check.exercise.library for check in checks if check.exercise.library
    }
    return space | right, sources


def _needed(statements, wanted, known):
    """Those statements of the cells that are given which define a name that is wanted, and what
    they want in turn."""
    chosen = []
    for statement in reversed(statements):
        if _defined(statement) & wanted:
            chosen.insert(0, statement)
            wanted = (wanted - _defined(statement)) | (_read(statement) - known)
    return chosen


def _read(statement):
    """The names that a statement takes from outside."""
    names = [node for node in ast.walk(statement) if isinstance(node, ast.Name)]
    own = {node.arg for node in ast.walk(statement) if isinstance(node, ast.arg)}
    if isinstance(statement, ast.FunctionDef):
        own |= {node.id for node in names if isinstance(node.ctx, ast.Store)}
    return {node.id for node in names if isinstance(node.ctx, ast.Load)} - own


def _defined(statement):
    if isinstance(statement, (ast.FunctionDef, ast.ClassDef)):
        return {statement.name}
    targets = statement.targets if isinstance(statement, ast.Assign) else []
    return {
        node.id for target in targets for node in ast.walk(target) if isinstance(node, ast.Name)
    }


class TooMany(Exception):
    """A call has made more passes through loops than allowed; it may never end."""


class Passes:
    """Counts the passes through the loops of a function, and ends a call that makes too many."""

    def __init__(self):
        self.made, self.most, self.allowed = 0, 0, math.inf  # in this call, in any call, at most

    def count(self):
        self.made += 1
        self.most = max(self.most, self.made)
        if self.made > self.allowed:
            raise TooMany


class _Counted(ast.NodeTransformer):
    """Counts each pass of a loop."""

    def visit_While(self, node):
        self.generic_visit(node)
        node.body[:0] = ast.parse("passes.count()").body
        return node

    visit_For = visit_While


def made(source, name, space):
    """Return the function of that name which the source defines, among the names of a notebook.

    Each call counts its passes anew, and raises for an answer of more than a million entries, which
    is slow to write.
    """
    own = dict(space)
    tree = ast.fix_missing_locations(_Counted().visit(ast.parse(source)))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of the compiler, for what no person would write
        exec(compile(tree, "<mutant>", "exec"), own)

    def guarded(*arguments):
        space["passes"].made = 0
        value = own[name](*arguments)
        if getattr(value, "size", 0) > MAX_ENTRIES:
            raise OverflowError("an answer of this size takes long to write down")
        return value

    return guarded
