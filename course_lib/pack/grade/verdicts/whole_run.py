"""What a run of the whole notebook can change, found from the source alone.

The cells that students are given are known, and most of them only draw and print. They need not run
again if nothing that they bind is read by the student's own cells. And the function that a run of
the whole notebook has is the one that a run of the needed statements has, if each name that it
reads is bound once in the notebook.

All this holds as long as the student's cells leave something to others by names alone. A cell that
makes names in another way, by exec or in a file, shows it by its words.
"""

import ast
import builtins
import re
import unicodedata
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence

from course_lib.pack.grade.jail.statements import (
    FUNCTIONS,
    IMPORTS,
    SIMPLE,
    Statement,
    plain,
)

# Words by which a cell finds or makes names that it does not write down, or leaves something behind
# that is no name of the notebook. So does each word with two underlines at its beginning.
OTHER_WAYS = {
    *("global", "globals", "locals", "vars", "eval", "exec", "compile", "In", "Out"),
    *("getattr", "setattr", "delattr", "importlib", "import_module", "runpy", "builtins", "types"),
    *("sys", "os", "io", "gc", "inspect", "ctypes", "threading", "subprocess", "atexit", "signal"),
    *("IPython", "get_ipython", "open", "write", "write_text", "write_bytes", "pathlib", "Path"),
    *("pickle", "dump", "save", "tempfile", "shutil"),
}
# Of a notebook that is looked at; the longest one of the course has about 420 and 41,000. A much
# longer one runs as a whole: to look at it takes a time that grows with the square of its length.
MAX_STATEMENTS, MAX_CHARACTERS = 3_000, 200_000
CHECK = "check"
CALLED_CHECK = re.compile(r"\bcheck\.\w+\(")  # in a cell at which the grader may ask
DEFINITIONS = (*FUNCTIONS, ast.Lambda)  # what they read, they read when they are called


def can_be_told(
    in_order: Sequence[Statement], sources: Sequence[str], given: Collection[int]
) -> bool:
    """Return whether the source tells what a run of the whole notebook can change.

    given: the numbers of the cells that are as students are given them.
    """
    if len(in_order) > MAX_STATEMENTS or sum(map(len, sources)) > MAX_CHARACTERS:
        return False
    if any(patches(each.tree) for each in in_order if each.cell not in given):
        return False
    return only_by_names(text for number, text in enumerate(sources) if number not in given)


def patches(tree: ast.stmt) -> bool:
    """Return whether a function in a statement changes attributes of what may be another's, as
    np.abs = f does. Those of self are its own.

    Examples
    --------
    >>> patches(ast.parse("def f(x):\\n    np.abs = x").body[0])
    True
    >>> patches(ast.parse("def f(x):\\n    x[0] = np.abs(x)").body[0])
    False
    """
    definitions = (node for node in ast.walk(tree) if isinstance(node, DEFINITIONS))
    inside = (node for definition in definitions for node in ast.walk(definition))
    attributes = (node for node in inside if isinstance(node, ast.Attribute))
    return any(
        isinstance(node.ctx, ast.Store | ast.Del) and ast.unparse(node.value) != "self"
        for node in attributes
    )


def only_by_names(sources: Iterable[str]) -> bool:
    """Return whether cells leave something to other cells by names alone.

    Examples
    --------
    >>> only_by_names(["def hat(w):\\n    return -w", "hat(3)"])
    True
    >>> only_by_names(["exec('def hat(w): return -w')"]), only_by_names(["%run mine.py"])
    (False, False)
    """
    for source in sources:
        words = _words(source)
        if words & OTHER_WAYS or any(word.startswith("__") for word in words):
            return False
        if plain(source) != source:  # it holds commands of IPython
            return False
    return True


def idle_cells(
    in_order: Sequence[Statement], sources: Sequence[str], given: Iterable[int]
) -> set[int]:
    """Return the numbers of the given cells that bind or change nothing that others read.

    Parameters
    ----------
    in_order : sequence of Statement
        Those of the notebook.
    sources : sequence of str
        Of its cells.
    given : iterable of int
        The numbers of the cells that are as students are given them. Those with a check are not
        idle.
    """
    idle = {number for number in given if not CALLED_CHECK.search(sources[number])}
    left_by, in_cell = _places(in_order), {}
    for place, statement in enumerate(in_order):
        in_cell.setdefault(statement.cell, []).append(place)
    waiting = [number for number in range(len(sources)) if number not in idle]
    while waiting:
        for place in in_cell.get(waiting.pop(), []):
            found = {in_order[other].cell for other in _read_from(in_order, place, left_by)} & idle
            idle -= found
            waiting += found
    return idle


def _places(in_order: Sequence[Statement]) -> dict[str, list[int]]:
    """Return {name: the places of the statements that bind or change it}."""
    places, imported = {}, _imported(in_order)
    for place, statement in enumerate(in_order):
        for name in statement.binds | (statement.changes - imported):
            places.setdefault(name, []).append(place)
    return places


def _read_from(
    in_order: Sequence[Statement], place: int, left_by: Mapping[str, list[int]]
) -> Iterator[int]:
    """Yield the places of the statements of which the one at this place may read something."""
    statement = in_order[place]
    is_called_later = any(isinstance(node, DEFINITIONS) for node in ast.walk(statement.tree))
    for name in [*statement.reads, "*"]:
        for other in reversed(left_by.get(name, [])):
            if other > place and not is_called_later:
                continue
            yield other
            is_simple = isinstance(in_order[other].tree, SIMPLE) and name in in_order[other].binds
            if other <= place and is_simple:
                break  # what was bound before that is not read


def is_settled(in_order: Sequence[Statement], name: str, given: Collection[int]) -> bool:
    """Return whether a function of this name is the same whenever it is asked.

    Each name that it reads, and that what it reads does, is bound by one statement, or by several
    that bind the same, and changed by no other. The settings of the given cells, whose numbers are
    given, only say how numbers are printed.
    """
    bound_by, changed_by = _by_name(in_order, given)
    if "*" in bound_by:
        return False
    reached, waiting = set(), [name]
    while waiting:
        read = waiting.pop()
        if read in reached:
            continue
        reached.add(read)
        bindings = bound_by.get(read, [])
        if not bindings and hasattr(builtins, read):
            continue
        if not bindings or len({_what_it_binds(each, read) for each in bindings}) > 1:
            return False
        if any(statement not in bindings for statement in changed_by.get(read, [])):
            return False
        waiting += bindings[0].reads
    return True


def _what_it_binds(statement: Statement, name: str) -> str:
    """Return a text that is the same for two statements if they bind the same thing to a name."""
    if isinstance(statement.tree, IMPORTS):
        module = getattr(statement.tree, "module", "")
        as_named = (alias for alias in statement.tree.names if name in (alias.asname, alias.name))
        return f"{module} {[ast.dump(alias) for alias in as_named]}"
    if isinstance(statement.tree, FUNCTIONS):
        return ast.dump(statement.tree)
    return f"{statement.cell} {statement.place}"


def _by_name(in_order: Sequence[Statement], given: Collection[int]) -> tuple[dict, dict]:
    """Return {name: statements that bind it} and {name: statements that change it}."""
    bound_by, changed_by, imported = {}, {}, _imported(in_order)
    for statement in in_order:
        for name in statement.binds:
            bound_by.setdefault(name, []).append(statement)
        settings = set() if statement.cell in given else _settings(statement.tree)
        for name in (statement.changes - imported) | settings:
            changed_by.setdefault(name, []).append(statement)
    return bound_by, changed_by


def _imported(in_order: Sequence[Statement]) -> set[str]:
    imports = (statement for statement in in_order if isinstance(statement.tree, IMPORTS))
    return {name for statement in imports for name in statement.binds}


def _settings(tree: ast.stmt) -> set[str]:
    """Return the name whose attribute a statement assigns to, or of which it only calls a method,
    as np.seterr(all="raise") does."""
    targets = []
    if isinstance(tree, ast.Assign):
        targets = tree.targets
    elif isinstance(tree, ast.AugAssign | ast.AnnAssign):
        targets = [tree.target]
    elif isinstance(tree, ast.Expr) and isinstance(tree.value, ast.Call):
        targets = [tree.value.func]
    names = set()
    for target in targets:
        inside = target
        while isinstance(inside, ast.Attribute | ast.Subscript):
            inside = inside.value
        if inside is not target and isinstance(inside, ast.Name):
            names.add(inside.id)
    return names - {CHECK}


def _words(source: str) -> set[str]:
    return set(re.findall(r"\w+", unicodedata.normalize("NFKC", source)))  # as Python reads names
