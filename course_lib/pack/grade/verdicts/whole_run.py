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
    CHANGING,
    FUNCTIONS,
    IMPORTS,
    SIMPLE,
    Statement,
    base_of,
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
    imported = _imported(in_order)
    own = [statement for statement in in_order if statement.cell not in given]
    if any(_assigned_inside(statement.tree) & imported for statement in own):
        return False
    return only_by_names(text for number, text in enumerate(sources) if number not in given)


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
    given = set(given)
    idle = {number for number in given if not CALLED_CHECK.search(sources[number])}
    left_by, in_cell = _places(in_order, given), {}
    for place, statement in enumerate(in_order):
        in_cell.setdefault(statement.cell, []).append(place)
    waiting = [number for number in range(len(sources)) if number not in idle]
    while waiting:
        for place in in_cell.get(waiting.pop(), []):
            found = {in_order[other].cell for other in _read_from(in_order, place, left_by)} & idle
            idle -= found
            waiting += found
    return idle


def _places(in_order: Sequence[Statement], given: Collection[int]) -> dict[str, list[int]]:
    """Return {name: the places of the statements that bind or change it}, in order.

    A statement also changes what a function of the student's does, if it may call that function.
    """
    places, imported = {}, _imported(in_order)
    for place, statement in enumerate(in_order):
        for name in statement.binds | (statement.changes - imported):
            places.setdefault(name, set()).add(place)
    for name, callers in _changed_by_calls(in_order, given).items():
        places.setdefault(name, set()).update(callers)
    return {name: sorted(several) for name, several in places.items()}


def _changed_by_calls(in_order: Sequence[Statement], given: Collection[int]) -> dict[str, set[int]]:
    """Return {name: the places of the statements that may call a function of the student's which
    changes it}.

    They read the name of the function, or a name that is bound by a statement that does. What is
    changed may go by all names that share a value with this one.
    """
    known, imported = _known(in_order, given), _imported(in_order)
    functions, callers = {}, {}  # functions: {changed name: those that change it}
    for statement in in_order:
        if statement.cell not in given and _is_called_later(statement.tree):
            for name in _changes(statement, known) - imported:
                functions.setdefault(name, set()).update(statement.binds)
    if not functions:
        return {}
    lasting = imported | {
        name for each in in_order if isinstance(each.tree, FUNCTIONS) for name in each.binds
    }
    values = [each for each in in_order if not isinstance(each.tree, (*FUNCTIONS, *IMPORTS))]
    links = [(each.binds | each.reads) - lasting for each in values]
    reads_and_binds = [(each.reads, each.binds) for each in in_order]
    for name, several in functions.items():
        names = _reached({name}, [(link, link) for link in links])
        called = _reached(several, reads_and_binds)
        places = {place for place, each in enumerate(in_order) if each.reads & called}
        for shared in names:
            callers.setdefault(shared, set()).update(places)
    return callers


def _reached(names: Collection[str], steps: Sequence[tuple[set[str], set[str]]]) -> set[str]:
    """Return these names and all that steps lead to, each from any of some names to others."""
    by_start = {}
    for starts, ends in steps:
        for name in starts:
            by_start.setdefault(name, []).append(ends)
    reached, waiting = set(names), [*names]
    while waiting:
        for ends in by_start.pop(waiting.pop(), []):
            waiting += ends - reached
            reached |= ends
    return reached


def _read_from(
    in_order: Sequence[Statement], place: int, left_by: Mapping[str, list[int]]
) -> Iterator[int]:
    """Yield the places of the statements of which the one at this place may read something."""
    statement = in_order[place]
    is_called_later = _is_called_later(statement.tree)
    for name in [*statement.reads, "*"]:
        for other in reversed(left_by.get(name, [])):
            if other > place and not is_called_later:
                continue
            yield other
            is_simple = isinstance(in_order[other].tree, SIMPLE) and name in in_order[other].binds
            if other <= place and is_simple:
                break  # what was bound before that is not read


def _is_called_later(tree: ast.stmt) -> bool:
    return any(isinstance(node, DEFINITIONS) for node in ast.walk(tree))


def is_settled(in_order: Sequence[Statement], name: str, given: Collection[int]) -> bool:
    """Return whether a function of this name is the same whenever it is asked.

    Each name that it reads, and that what it reads does, is bound by one statement, or by several
    that bind the same, and no other statement changes what stands behind it. What can be changed,
    such as a list, has no other reader among the student's statements, because one may pass it on.
    """
    bound_by, changed_by = _by_name(in_order, given)
    if "*" in bound_by:
        return False
    reached, needed, waiting = set(), [], [name]
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
        needed += bindings
        waiting += bindings[0].reads
    others = [statement for statement in in_order if statement not in needed]
    if any(statement in others for read in reached for statement in changed_by.get(read, [])):
        return False
    own_others = [statement for statement in others if statement.cell not in given]
    return not any(
        read in statement.reads
        for read in reached & _changeable(needed)
        for statement in own_others
    )


def stays(in_order: Sequence[Statement], name: str, cell: int, given: Collection[int]) -> bool:
    """Return whether a function of this name is the same after all cells as at the end of a cell.

    No later statement binds another thing to a name that it reads, or that what it reads does, and
    none changes what stands behind such a name. No function changes that either, because it may be
    called later. What can be changed has no later reader among the student's statements.
    """
    bound_by, changed_by = _by_name(in_order, given)
    if "*" in bound_by:
        return False
    reached, bindings, waiting = set(), [], [name]
    while waiting:
        read = waiting.pop()
        if read in reached:
            continue
        reached.add(read)
        of_name = bound_by.get(read, [])
        before = {_what_it_binds(each, read) for each in of_name if each.cell <= cell}
        later = {_what_it_binds(each, read) for each in of_name if each.cell > cell}
        if later and (later != before or len(before) > 1):
            return False
        bindings += of_name
        waiting += (other for each in of_name for other in each.reads)
    changing = (each for read in reached for each in changed_by.get(read, []))
    if any(each.cell > cell or _is_called_later(each.tree) for each in changing):
        return False
    own_later = [each for each in in_order if each.cell > cell and each.cell not in given]
    changeable = reached & _changeable(bindings)
    return not any(changeable & each.reads for each in own_later)


def _changeable(bindings: Iterable[Statement]) -> set[str]:
    """Return the names that are bound to what can be changed: to all but functions, modules and
    numbers or texts that are written down."""
    lasting = (*FUNCTIONS, *IMPORTS)
    return {
        name
        for statement in bindings
        if not isinstance(statement.tree, lasting) and not _is_constant(statement.tree)
        for name in statement.binds
    }


def _is_constant(tree: ast.stmt) -> bool:
    if not isinstance(tree, ast.Assign):
        return False
    parts = (ast.Constant, ast.UnaryOp, ast.BinOp, ast.operator, ast.unaryop)
    return all(isinstance(node, parts) for node in ast.walk(tree.value))


def _what_it_binds(statement: Statement, name: str) -> str:
    """Return a text that is the same for two statements if they bind the same thing to a name."""
    if isinstance(statement.tree, IMPORTS):
        module = getattr(statement.tree, "module", "")
        as_named = (alias for alias in statement.tree.names if name in (alias.asname, alias.name))
        return f"{module} {[ast.dump(alias) for alias in as_named]}"
    if isinstance(statement.tree, FUNCTIONS) or _is_constant(statement.tree):
        return ast.dump(statement.tree)
    return f"{statement.cell} {statement.place}"


def _by_name(in_order: Sequence[Statement], given: Collection[int]) -> tuple[dict, dict]:
    """Return {name: statements that bind it} and {name: statements that change it}.

    The settings of the given cells only say how numbers are printed.
    """
    bound_by, changed_by = {}, {}
    known, imported = _known(in_order, given), _imported(in_order)
    for statement in in_order:
        for name in statement.binds:
            bound_by.setdefault(name, []).append(statement)
        changes = statement.changes - imported
        if statement.cell not in given:
            changes |= _changes(statement, known) - imported | _settings(statement.tree)
        for name in changes:
            changed_by.setdefault(name, []).append(statement)
    return bound_by, changed_by


def _imported(in_order: Sequence[Statement]) -> set[str]:
    imports = (statement for statement in in_order if isinstance(statement.tree, IMPORTS))
    return {name for statement in imports for name in statement.binds}


def _assigned_inside(tree: ast.stmt) -> set[str]:
    """Return the names whose attributes or items a statement, or a function in it, assigns to or
    deletes."""
    parts = (node for node in ast.walk(tree) if isinstance(node, ast.Attribute | ast.Subscript))
    return {name for node in parts if not isinstance(node.ctx, ast.Load) for name in base_of(node)}


def _changes(statement: Statement, known: Collection[str]) -> set[str]:
    """Return the names of the notebook that a statement, or a function in it, may change: it
    assigns to a part of them, or calls a method.

    known: the names whose methods are known, see _known.
    """
    calls = (node for node in ast.walk(statement.tree) if isinstance(node, ast.Call))
    methods = (call.func for call in calls if isinstance(call.func, ast.Attribute))
    owners = {
        name
        for method in methods
        for name in base_of(method)
        if method.attr in CHANGING or name not in known
    }
    return (_assigned_inside(statement.tree) | owners) & statement.reads - {CHECK}


def _known(in_order: Sequence[Statement], given: Collection[int]) -> set[str]:
    """Return the names of whose methods, and of whose results' methods, it is known whether they
    change something.

    These are imported names, those that only given cells bind, and those that the student's cells
    bind only to what comes of the library, to numbers or texts that are written down, or to
    functions, as long as these read no other names than these.
    """
    library, unknown, readers = _from_library(in_order), set(), {}
    for each in in_order:
        if each.cell in given or isinstance(each.tree, IMPORTS) or _is_constant(each.tree):
            continue
        if isinstance(each.tree, ast.Assign) and _comes_of(each.tree.value, library):
            library |= each.binds
        elif not isinstance(each.tree, ast.FunctionDef):
            unknown |= each.binds
        for name in each.reads:
            readers.setdefault(name, []).append(each)
    waiting = [*unknown]
    while waiting:
        for reader in readers.get(waiting.pop(), []):
            waiting += reader.binds - unknown
            unknown |= reader.binds
    return {name for each in in_order for name in each.binds} - unknown | _imported(in_order)


def _from_library(in_order: Sequence[Statement]) -> set[str]:
    """Return the names that are imported from the course's library."""
    imports = (each for each in in_order if isinstance(each.tree, ast.ImportFrom))
    of_library = (each for each in imports if f"{each.tree.module}.".startswith("course_lib."))
    return {name for each in of_library for name in each.binds}


def _comes_of(value: ast.expr, names: Collection[str]) -> bool:
    """Return whether a value is a part of what one of these names stands for, or a result of it."""
    base = base_of(value)
    return bool(base) and base <= names


def _settings(tree: ast.stmt) -> set[str]:
    """Return the names of which a statement, or a function in it, calls a method for its effect, as
    np.seterr(all="raise") does."""
    results = (node.value for node in ast.walk(tree) if isinstance(node, ast.Expr))
    calls = (value for value in results if isinstance(value, ast.Call))
    methods = (call.func for call in calls if isinstance(call.func, ast.Attribute))
    return {name for method in methods for name in base_of(method)} - {CHECK}


def _words(source: str) -> set[str]:
    return set(re.findall(r"\w+", unicodedata.normalize("NFKC", source)))  # as Python reads names
