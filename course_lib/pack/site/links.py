"""Links that the notebooks' texts have no need of in JupyterLab, and pages do.

They lead to the notebooks and the sections that a text names, and to sources.
"""

import re
from collections.abc import Callable

from docutils import nodes

from course_lib.pack.site.sources import ADDRESSES

# "notebook 3", "notebooks 1 and 2", "notebooks 3, 5 and 6"
NOTEBOOKS = re.compile(r"\b[Nn]otebooks? \d(?:(?:, and|,| and| or| to) \d)*\b")
NUMBER = re.compile(r"(?:[Nn]otebooks? )?\d")
# Where words are no running text, or lead elsewhere already.
LEFT_ALONE = (
    nodes.reference,
    nodes.title,
    nodes.FixedTextElement,
    nodes.literal,
    nodes.math,
    nodes.raw,
)


def notebook_number(name: str) -> int | None:
    """Return the number that the name of a notebook's page begins with, or None."""
    number = re.match(r"\d+(?=_)", name)
    return int(number[0]) if number else None


def link_notebooks(
    document: nodes.document, own: str, address_of: Callable[[str], str], pages: list[str]
) -> None:
    """Make a link of each mention of another notebook by its number, such as "notebook 3".

    `own` is the name of the page itself, and `address_of` gives the address of a page by its name.
    """
    numbers = {notebook_number(page): page for page in pages if notebook_number(page)}

    def linked(match: re.Match) -> list[nodes.Node]:
        made, end = [], 0
        for part in NUMBER.finditer(match[0]):
            made.append(nodes.Text(match[0][end : part.start()]))
            page = numbers.get(int(part[0][-1]))
            leads_elsewhere = page is not None and page != own
            made.append(
                _link(part[0], address_of(page)) if leads_elsewhere else nodes.Text(part[0])
            )
            end = part.end()
        return [node for node in made if node.astext()]

    for text in _running_texts(document):
        _replace(text, NOTEBOOKS, linked)


def link_sections(
    document: nodes.document,
    own: str,
    address_of: Callable[[str], str],
    titles: dict[str, dict[str, str]],
) -> None:
    """Make a link of each heading that a text names in italics, whole or up to its colon.

    `titles` are {page: {heading: anchor}}. A heading of the page itself comes first; one of another
    page must be the only one of its name.
    """
    for stressed in list(document.findall(nodes.emphasis)):
        if _is_left_alone(stressed):
            continue
        name = stressed.astext().strip()
        places = [(own, anchor) for anchor in _anchors(name, titles.get(own, {}))]
        if not places:
            others = [page for page in titles if notebook_number(page) and page != own]
            places = [(page, anchor) for page in others for anchor in _anchors(name, titles[page])]
        if len(places) != 1:
            continue
        page, anchor = places[0]
        address = anchor if page == own else address_of(page) + anchor
        reference = nodes.reference("", "", internal=True, refuri=address)
        stressed.replace_self(reference)
        reference += stressed


def _anchors(name: str, titles: dict[str, str]) -> list[str]:
    """Return the anchors of the headings that a name stands for."""
    if name in titles:
        return [titles[name]]
    beginning = re.compile(rf"{re.escape(name)}[:,?]")
    return [anchor for title, anchor in titles.items() if beginning.match(title)]


def link_sources(document: nodes.document) -> None:
    """Make links of the sources whose addresses are known."""
    for section in document.findall(nodes.section):
        # On the page of all sources those of a notebook are a section inside.
        titles = [part[0].astext() for part in (section, section.parent) if part.children]
        if "Sources" not in titles:
            continue
        for item in section.findall(nodes.list_item):
            for words, address in ADDRESSES.items():
                _link_words(item, words, address)


def _link_words(node: nodes.Node, words: str, address: str) -> None:
    pattern = re.compile(re.escape(words))
    for text in _running_texts(node):
        _replace(text, pattern, lambda _: [_link(words, address, is_internal=False)])


def _running_texts(node: nodes.Node) -> list[nodes.Text]:
    return [text for text in node.findall(nodes.Text) if not _is_left_alone(text)]


def _is_left_alone(node: nodes.Node) -> bool:
    while node is not None:
        if isinstance(node, LEFT_ALONE):
            return True
        node = node.parent
    return False


def _link(words: str, address: str, is_internal: bool = True) -> nodes.reference:
    return nodes.reference("", words, internal=is_internal, refuri=address)


def _replace(
    text: nodes.Text, pattern: re.Pattern, make: Callable[[re.Match], list[nodes.Node]]
) -> None:
    """Replace what a pattern matches in a text by nodes."""
    words, parts, end = text.astext(), [], 0
    for match in pattern.finditer(words):
        parts += [nodes.Text(words[end : match.start()]), *make(match)]
        end = match.end()
    if parts:
        parts.append(nodes.Text(words[end:]))
        text.parent.replace(text, [part for part in parts if part.astext()])
