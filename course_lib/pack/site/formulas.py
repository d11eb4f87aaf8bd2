"""Typeset formulas as pictures and MathML while the site is built.

MathJax runs here, not in the reader's browser.
"""

import html
import json
import re
from functools import cache
from importlib.resources import files

from py_mini_racer import MiniRacer

from course_lib.pack.site.glossary import symbols_in

PARTS = (
    "loader",
    "core",
    "adaptors/liteDOM",
    "input/tex-full",
    "output/svg",
    "output/svg/fonts/tex",
)

# Two packages are left out, so that an unknown macro or a wrong brace is an error and not red text.
SET_UP = r"""
const _ = MathJax._, adaptor = _.adaptors.liteAdaptor.liteAdaptor();
_.handlers.html_ts.RegisterHTMLHandler(adaptor);
const without = ["noundefined", "noerrors"];
const packages = _.input.tex.AllPackages.AllPackages.filter((name) => !without.includes(name));
const tex = new _.input.tex_ts.TeX({ packages });
const font = new _.output.svg.fonts.tex_ts.TeXFont();
const svg = new _.output.svg_ts.SVG({ fontCache: "global", font });
const page = _.mathjax.mathjax.document("", { InputJax: tex, OutputJax: svg });
const visitor = new _.core.MmlTree.SerializedMmlVisitor.SerializedMmlVisitor();
function set(text, display) {
  const made = page.convert(text, { display, em: 16, ex: 8, containerWidth: 1280 });
  return JSON.stringify([adaptor.innerHTML(made), visitor.visitTree(tex.mathNode)]);
}
const letters = () => adaptor.innerHTML(svg.fontCache.getCache());
0"""

WIDE = 30  # ex; about 250 pixels
GROUP_TAG = re.compile(r"(<g(?: [^>]*)?>|</g>)")
MOVED_LETTER = re.compile(r'<g (transform="[^"]*")><use (href="[^"]*")></use></g>')
LETTER = re.compile(r'href="#(MJX-[^"]+)"')
# A formula in a line, as `typeset` makes it, and with punctuation before it, behind it, or both.
INLINE = r'<span class="math(?: wide)?"[^>]*>(?:(?!<span class="math).)*?</math></span></span>'
OPENING, CLOSING = r"[(\[“‘]", r"[,.;:!?)\]”’]"
PUNCTUATED = re.compile(f"{OPENING}+{INLINE}{CLOSING}*|{INLINE}{CLOSING}+", re.DOTALL)


class FormulaError(ValueError):
    """A formula that MathJax cannot typeset; the text says why."""


@cache
def _mathjax() -> MiniRacer:
    """Return a JavaScript engine with MathJax.

    A process has one, because it takes half a second to start.
    """
    folder = files("sphinx-mathjax-offline") / "static" / "mathjax"
    engine = MiniRacer()
    engine.eval("globalThis.MathJax = { loader: { load: [] } }; 0")
    for part in PARTS:
        engine.eval((folder / f"{part}.js").read_text(encoding="utf-8") + "\n;0")
    engine.eval(SET_UP)
    return engine


def close() -> None:
    """End the engine, if there is one; otherwise Python would wait for its thread when it exits."""
    if _mathjax.cache_info().currsize:
        _mathjax().close()
        _mathjax.cache_clear()
        typeset.cache_clear()


def mathml_of(text: str) -> str:
    """Return the MathML of a formula; raises FormulaError with MathJax's message."""
    return _set(text, False)[1]


def _set(text: str, display: bool) -> tuple[str, str]:
    """Return a formula as a picture and as MathML."""
    picture, words = json.loads(_mathjax().eval(f"set({json.dumps(text)}, {json.dumps(display)})"))
    error = re.search(r'<merror data-mjx-error="([^"]*)"', words)
    if error:
        raise FormulaError(html.unescape(error[1]))
    return picture, words


@cache
def typeset(text: str, display: bool = False) -> str:
    """Return HTML for a formula: a picture, and MathML for readers who do not see it.

    `text` is TeX without dollars; `display` puts it on a line of its own. Raises FormulaError with
    MathJax's message.
    """
    picture, mathml = _set(text, display)
    # Attributes for MathJax's own menu, and an outline of width zero around each letter, are not
    # needed.
    picture = re.sub(r' (?:data-[a-z-]+|role|xmlns:xlink|xmlns)="[^"]*"', "", picture).replace(
        "xlink:href", "href"
    )
    picture = picture.replace(
        ' stroke="currentColor" fill="currentColor" stroke-width="0"', ' fill="currentColor"'
    )
    picture = _with_fewer_groups(picture)
    picture = picture.replace("<svg ", '<svg aria-hidden="true" ', 1)
    symbols = html.escape(" ".join(symbols_in(mathml)))
    named = f' data-symbols="{symbols}"' if symbols else ""
    mathml = re.sub(r"\n\s*", "", mathml)
    made = f'{picture}<span class="visually-hidden">{mathml}</span>'
    if display:
        return f'<div class="math"{named}>{made}</div>'
    # On a phone a wide formula scrolls in a box, which then needs the vertical alignment of its
    # letters.
    depth = re.search(r"vertical-align: ([^;]*);", picture)[1]
    width = float(re.search(r'width="([\d.]+)ex"', picture)[1])
    wide = f' wide" style="vertical-align: {depth}' if width > WIDE else ""
    return f'<span class="math{wide}"{named}>{made}</span>'


def _with_fewer_groups(picture: str) -> str:
    """Return a picture without groups that change nothing: a page has thousands of them.

    MathJax puts each part of a formula into a group. A group without attributes is left out, and
    one that moves a single letter leaves the movement to that letter.
    """
    kept = []
    have_attributes = []  # of the groups that are open
    for part in GROUP_TAG.split(picture):
        is_kept = True
        if part.startswith("<g"):
            is_kept = part != "<g>"
            have_attributes.append(is_kept)
        elif part == "</g>":
            is_kept = have_attributes.pop()
        if is_kept:
            kept.append(part)
    return MOVED_LETTER.sub(r"<use \1 \2></use>", "".join(kept))


def with_punctuation(page: str) -> str:
    """Return HTML in which no line breaks between a formula and the punctuation at its sides.

    A browser breaks lines before and after a picture, and a formula is one: a line would begin with
    a comma, or end with a bracket. `page` is HTML with formulas that `typeset` made.
    """
    return PUNCTUATED.sub(r'<span class="unbroken">\g<0></span>', page)


def letters_of(page: str) -> str:
    """Return the outlines of the letters that a page's formulas use, each once.

    They are "" for a page without formulas. `page` is HTML with formulas that `typeset` made in
    this process.
    """
    used = dict.fromkeys(LETTER.findall(page))
    if not used:
        return ""
    outlines = dict(
        re.findall(r'(?=<path id="([^"]+)")(<path .*?</path>)', _mathjax().eval("letters()"))
    )
    paths = "".join(outlines[name] for name in sorted(used))
    hidden = 'width="0" height="0" style="position: absolute" aria-hidden="true"'
    return f"<svg {hidden}><defs>{paths}</defs></svg>"
