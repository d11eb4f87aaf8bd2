"""Imports of the course's package that this release does not have, because a module has moved."""

import re
from pathlib import Path

_IMPORT = re.compile(
    r"^\s*(?:from\s+(course_lib[\w.]*)\s+import\s+(.*)|import\s+(course_lib[\w.]*))"
)
_BRACKETED = re.compile(r"\bimport\s*\(([^()]*)\)")


def moved_imports(text: str) -> list[str]:
    """Return the dotted names that lines of code import from the course and that are not there."""
    package = _package()
    imported = []
    for line in _BRACKETED.sub(_on_one_line, text).splitlines():
        statement = _IMPORT.match(line)
        if statement and statement[3]:
            imported.append(statement[3])
        elif statement:
            imported += [f"{statement[1]}.{name}" for name in _names(statement[2])]
    return [name for name in imported if package and not _is_there(package, name)]


def _package() -> Path | None:
    """Return the folder that holds the package of this release, or None if there is none."""
    for folder in Path(__file__).resolve().parents:
        if (folder / "course_lib" / "__init__.py").is_file():
            return folder
    return None


def _on_one_line(names: re.Match) -> str:
    lines = [line.partition("#")[0] for line in names[1].splitlines()]
    return f"import {' '.join(' '.join(lines).split())}"


def _names(clause: str) -> list[str]:
    """Return the names of "a, b as c", the rest of a line behind the word import."""
    parts = [part.split() for part in clause.partition("#")[0].split(",")]
    return [words[0] for words in parts if words]


def _is_there(package: Path, dotted_name: str) -> bool:
    """Return whether the package has this module, or a module that holds this name."""
    if _source(package, dotted_name) is not None:
        return True
    module, _, name = dotted_name.rpartition(".")
    source = _source(package, module)
    return source is not None and (name == "*" or name in re.findall(r"\w+", source))


def _source(package: Path, module: str) -> str | None:
    path = package.joinpath(*module.split("."))
    for file in (path / "__init__.py", path.with_suffix(".py")):
        if file.is_file():
            return file.read_text(encoding="utf-8")
    return None
