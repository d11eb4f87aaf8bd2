"""The symbols of a page with their meanings, from the tables of notation.

A formula carries the names of its symbols, and symbols.js shows their meanings under the pointer. A
name is the letter, such as "R", or the letter and its subscript, such as "k_1".
"""

import html
import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from xml.etree import ElementTree

HEADER = re.compile(r"^\|\s*symbol\s*\|.*\n\|[-| ]+\|\n((?:\|.*\n?)+)", re.MULTILINE)
NOT_MULTIPLIED = {"T", "−1", "⊤", "*", "∗", "′", "+"}  # a superscript that is no symbol
# e alone is an error and e_x is a unit vector, so a subscript makes another symbol of this letter.
WITH_SUBSCRIPT_ANOTHER = {"e"}


@dataclass(frozen=True)
class Entry:
    """A line of the glossary: a symbol and its meaning as HTML, and the names that find it."""

    symbol: str
    meaning: str
    names: frozenset[str]


@cache
def symbols_in(mathml: str) -> tuple[str, ...]:
    """Return the symbols of a formula, each as its names, the more special one first: "k_1|k"."""
    symbols = []
    formula = ElementTree.fromstring(mathml)
    _collect(formula, symbols)
    # Brackets around one symbol make a matrix of it. Others enclose a list.
    if not re.search(r"\[[^\[\]]{1,3}\]", _text(formula)):
        symbols = [name for name in symbols if name != "["]
    return tuple(dict.fromkeys(symbols))


def _collect(node: ElementTree.Element, symbols: list[str]) -> None:
    """Append the symbols of a node of MathML to `symbols`, in the order of reading."""
    kind = node.tag.rpartition("}")[2]
    if kind in ("mi", "mo"):
        name = _name(node)
        if kind == "mi" or name in ("[", "‖"):
            symbols.append(name)
        return
    parts = list(node)
    if kind in ("msub", "msubsup"):
        base, subscript = _text(parts[0]), _text(parts[1])
        letter = _name(parts[0])
        if len(base) == 1:
            special = f"{letter}_{subscript}"
            is_another = letter in WITH_SUBSCRIPT_ANOTHER
            symbols.append(special if is_another else f"{special}|{letter}")
        else:
            _collect(parts[0], symbols)
        parts = parts[2:]
    elif kind == "msup":
        # The base of natural logarithms is no error e.
        if _text(parts[0]) == "e":
            symbols.append("exp")
        else:
            _collect(parts[0], symbols)
        parts = parts[1:]
    if kind in ("msup", "msubsup") and _text(parts[0]) in NOT_MULTIPLIED:
        return
    for part in parts:
        _collect(part, symbols)


def _text(node: ElementTree.Element) -> str:
    return "".join("".join(node.itertext()).split())


def _name(node: ElementTree.Element) -> str:
    """Return the name of a letter; script letters have names of their own."""
    is_script = any(part.get("mathvariant") == "script" for part in node.iter())
    return f"script-{_text(node)}" if is_script else _text(node)


def entries(text: str, mathml_of: Callable[[str], str]) -> list[Entry]:
    """Return the entries of all tables of symbols in a Markdown text.

    `mathml_of` is a function that returns the MathML of a formula in TeX.
    """
    made = []
    for table in HEADER.finditer(text):
        for row in table[1].strip().splitlines():
            symbol, *_, meaning = [cell.strip() for cell in row.strip().strip("|").split("|")]
            names = frozenset(
                name
                for formula in re.findall(r"\$([^$]+)\$", symbol)
                for part in _parts(formula)
                for name in _names_of_row(symbols_in(mathml_of(part)))
            )
            if names:
                made.append(Entry(_inline(symbol), _inline(meaning), names))
    return made


def _parts(formula: str) -> list[str]:
    """Return the symbols that a formula of the table lists: those before "=", between commas.

    A tuple, such as (u, v), is no symbol.
    """
    left = formula.partition("=")[0].strip()
    if left.startswith("("):
        return []
    return re.split(r",(?![^(\[{]*[)\]}])", left)


def _names_of_row(symbols: tuple[str, ...]) -> set[str]:
    """Return the names of the symbol that a formula of the table begins with.

    R_ab stands for R with any subscript, and k_1 for itself.
    """
    if not symbols:
        return set()
    special, _, letter = symbols[0].partition("|")
    is_numbered = special[-1].isdigit()
    return {special} if is_numbered or not letter else {special, letter}


def _inline(text: str) -> str:
    """Return Markdown in one line as HTML, with formulas marked for `set_formulas_in_outputs`."""
    pieces = re.split(r"(`[^`]+`|\$[^$]+\$)", text)
    made = []
    for piece in pieces:
        words = html.escape(piece[1:-1])
        if piece.startswith("`"):
            made.append(f"<code>{words}</code>")
        elif piece.startswith("$"):
            made.append(f'<span class="math" data-tex="{words}"></span>')
        else:
            stressed = re.sub(r"\*\*?([^*]+)\*\*?", r"<em>\1</em>", html.escape(piece, quote=False))
            made.append(stressed)
    return "".join(made)


def glossary(body: str, own: list[Entry], common: list[Entry]) -> str:
    """Return the meanings of the symbols on a page as hidden HTML, or "" if it uses none.

    The entries of the notebook's `own` table come before the `common` ones, and in place of them.
    """
    own_names = {name for entry in own for name in entry.names}
    chosen = [*own, *(entry for entry in common if not entry.names <= own_names)]
    used = set()
    for symbols in re.findall(r'data-symbols="([^"]*)"', body):
        for symbol in html.unescape(symbols).split():
            used |= set(symbol.split("|"))
    lines = []
    for entry in chosen:
        if entry.names & used:
            is_common = entry not in own
            names = html.escape(" ".join(sorted(entry.names - (own_names if is_common else set()))))
            lines.append(
                f'<div data-names="{names}"><dt>{entry.symbol}</dt><dd>{entry.meaning}</dd></div>'
            )
    return f'<dl id="course-symbols" hidden>{"".join(lines)}</dl>' if lines else ""
