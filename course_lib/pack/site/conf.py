"""Sphinx's settings; ``build`` copies this file beside the prepared notebooks."""

import html
import re
from functools import cache
from pathlib import Path

import nbformat
from bs4 import BeautifulSoup
from docutils import nodes
from sphinx.util import logging

from course_lib.pack.site import formulas, glossary, links
from course_lib.pack.site.prepare import SHOWN

project = "Robot kinematics"
html_title = project  # it follows the title of each page
html_favicon = "_static/icon.svg"
language = "en"

# The last one writes .nojekyll, without which GitHub Pages leaves out _static.
extensions = ["myst_nb", "sphinx_copybutton", "sphinx.ext.githubpages"]
copybutton_selector = ".bd-article div.highlight:not(.output div.highlight) pre"
include_patterns = ["*.md", "*.ipynb"]

nb_execution_mode = "off"
nb_merge_streams = True

myst_enable_extensions = ["dollarmath", "amsmath"]
# The notebooks are written to be read in JupyterLab too, so they link to headings and set formulas
# as it does.
myst_heading_anchors = 4
myst_heading_slug_func = "course_lib.pack.site.heading_anchor"
myst_dmath_double_inline = True
myst_dmath_allow_labels = False

# A block of `colour_commands` that no shell would read keeps its plain letters.
suppress_warnings = ["misc.highlighting_failure"]

html_math_renderer = "built"  # below

html_theme = "sphinx_book_theme"
html_static_path = ["_static"]
html_css_files = ["icons.css", "site.css"]
html_js_files = ["page.js", ("symbols.js", {"defer": "defer"})]
html_copy_source = False
html_use_index = False
html_show_copyright = False
# The course has a search of its own, in search.py and search.js.
templates_path = ["_templates"]
html_additional_pages = {"search": "search.html"}
# Without it the theme logs an error on a reader's first visit.
html_context = {"default_mode": "auto"}
html_theme_options = {
    "use_download_button": False,
    "search_bar_text": "Search the course",
    "toc_title": "On this page",
    # It would hold a place for advertisements.
    "primary_sidebar_end": [],
    "home_page_in_toc": True,
    # The side bar already has the search.
    "navbar_persistent": [],
    # The footer would name an author and a date.
    "footer_content_items": [],
}
# The title is already the first entry there, and the theme's own title is outside every landmark.
html_sidebars = {"**": ["search-button-field.html", "sbt-sidebar-nav.html"]}

BRANCH = "main"  # GitHub's name for the first branch of a repository


def offer_to_run(app, config):
    """Let the theme put buttons on the notebooks' pages that open them on Binder and on Colab."""
    if config.course_repository:
        config.html_theme_options |= {
            "repository_url": config.course_repository,
            "repository_branch": BRANCH,
            "path_to_docs": "notebooks",
            "launch_buttons": {
                "binderhub_url": "https://mybinder.org",
                "colab_url": "https://colab.research.google.com",
                "notebook_interface": "jupyterlab",
            },
        }


def name_tables_of_symbols(app, document):
    """Give the tables of symbols a class, by which a phone sets them in another way."""
    for table in document.findall(nodes.table):
        head = next(iter(table.findall(nodes.thead)), None)
        if head is not None and head.astext().startswith("symbol"):
            table["classes"].append("symbols-table")


# Characters. About 50 stand beside each other on a phone, so a row with more of them has columns of
# a word each; a formula of more does not fit beside another column.
MAX_ROW = 100
MAX_FORMULA = 40


def stack_wide_tables(app, document):
    """Give tables that are too wide for a phone a class, by which it sets a row as a list."""
    for table in document.findall(nodes.table):
        rows = [[cell.astext() for cell in row] for row in table.findall(nodes.row)]
        longest = [max(map(len, column)) for column in zip(*rows, strict=False)]
        formulas_of_table = [len(formula.astext()) for formula in table.findall(nodes.math)]
        has_long_rows = len(longest) > 2 and sum(longest) > MAX_ROW
        is_wide = has_long_rows or max(formulas_of_table, default=0) > MAX_FORMULA
        if is_wide and "symbols-table" not in table["classes"]:
            table["classes"].append("stacked-table")


def name_columns(app, pagename, templatename, context, doctree):
    """Give each cell of a stacked table the name of its column, which is shown before the cell."""

    def with_names(match):
        table = BeautifulSoup(match[0], "html.parser")
        names = [head.get_text(" ", strip=True) for head in table.select("thead th")]
        for row in table.select("tbody tr"):
            for name, cell in zip(names, row.find_all("td"), strict=False):
                cell["data-column"] = name
        return str(table)

    pattern = r'<table class="[^"]*\bstacked-table\b.*?</table>'
    context["body"] = re.sub(pattern, with_names, context.get("body", ""), flags=re.DOTALL)


def colour_commands(app, document):
    """Let the indented blocks of a page of text be coloured as a shell's: they hold commands."""
    if app.env.doc2path(app.env.docname).endswith(".md"):
        for block in document.findall(nodes.literal_block):
            if block.get("language") == "none":
                block["language"] = "sh"


def find_dollars(app, document):
    """Warn of dollars that did not become a formula."""
    logger = logging.getLogger(__name__)
    for node in document.findall(nodes.Text):
        inside = (nodes.FixedTextElement, nodes.literal, nodes.math, nodes.math_block, nodes.raw)
        if isinstance(node.parent, inside) or isinstance(node.parent.parent, inside):
            continue
        left_over = re.search(r"\$[^$]+\$|\\[([]|\\begin\{", node)
        if left_over:
            logger.warning(
                "formula: left as plain text: %s",
                node[left_over.start() :][:70],
                location=node.parent,
            )


def leave_unnumbered(app, document):
    """Remove the numbers that MyST gives to align and similar environments.

    JupyterLab gives none. Their names are removed too: they are random, so every build would change
    every page.
    """
    for node in document.findall(nodes.math_block):
        if "amsmath" in node["classes"]:
            node["number"] = None
            node["ids"].clear()


def number_equations(app, document):
    """Give each equation of a notebook that stands on a line of its own a number and an anchor."""
    notebook = links.notebook_number(app.env.docname)
    if not notebook:
        return
    for number, node in enumerate(document.findall(nodes.math_block), 1):
        node["numbered"] = (notebook, number)


def link_what_is_named(app, document, docname):
    """Make links of the notebooks, sections and sources that a text names."""

    def address_of(page):
        return app.builder.get_relative_uri(docname, page)

    titles = {}
    for page in app.env.found_docs:
        references = app.env.tocs[page].findall(nodes.reference)
        titles[page] = {part.astext(): part["anchorname"] for part in references}
    links.link_notebooks(document, docname, address_of, sorted(app.env.found_docs))
    links.link_sections(document, docname, address_of, titles)
    links.link_sources(document)


def fold_more(app, document, docname):
    """Fold each section of More.

    Its title and its first paragraph, a promise, are the line that opens it.
    """
    for section in document.findall(
        lambda node: isinstance(node, nodes.section) and "more" in node["classes"]
    ):
        title, *rest = section.children
        promise = [rest.pop(0)] if rest and isinstance(rest[0], nodes.paragraph) else []
        for link in [link for part in promise for link in part.findall(nodes.reference)]:
            link.parent.replace(link, link.children)  # a click on the line opens the section
        if promise:  # a summary may hold a heading and words, and no paragraph
            promise = [nodes.inline("", "", *promise[0].children, classes=["promise"])]
        texts = ('<details><summary class="more">', "</summary>", "</details>")
        begin, end, close = (nodes.raw("", text, format="html") for text in texts)
        section.children = []
        section.extend([begin, title, *promise, end, *rest, close])


def do_without_sphinx_search(app):
    """Let Sphinx write no search page and no index."""
    app.builder.search = False


def name_the_course_once(app, pagename, templatename, context, doctree):
    """Leave the course's name out of the tab's title where it is the title of the page."""
    if context.get("title") == project:
        context["docstitle"] = ""


def load_scripts_where_needed(app, pagename, templatename, context, doctree):
    """Add the scripts of toys and charts, after the text, to the pages that hold one."""
    figures = re.findall(r'<div class="toy-figure"([^>]*)>', context.get("body", ""))
    scripts = [name for figure in figures for name in re.findall(r'data-scripts="([^"]*)"', figure)]
    for script in dict.fromkeys(" ".join(scripts).split()):
        app.add_js_file(f"figures/{script}.js", loading_method="defer")
    if figures:
        app.add_js_file("figures.js", loading_method="defer")
    if '<div class="chart-figure"' in context.get("body", ""):
        app.add_js_file("charts.js", loading_method="defer")


def set_formula(translator, node):
    """Write a formula as HTML, or warn of one that cannot be set."""
    display = isinstance(node, nodes.math_block)
    text = node.astext()
    # Several lines outside any environment need one; amsmath's blocks are environments already.
    if display and r"\\" in text and not node.get("no-wrap", node.get("nowrap")):
        text = rf"\begin{{split}}{text}\end{{split}}"
    try:
        made = formulas.typeset(text, display)
    except formulas.FormulaError as error:
        logging.getLogger(__name__).warning(
            "formula: %s: %s", error, " ".join(text.split())[:70], location=node
        )
        made = ""
    if made and "numbered" in node:
        notebook, number = node["numbered"]
        made = (
            f'<div class="equation" id="equation-{number}">{made}'
            f'<span class="equation-number">({notebook}.{number})</span></div>'
        )
    translator.body.append(made)
    raise nodes.SkipNode


def number_figures(app, pagename, templatename, context, doctree):
    """Give each figure of a notebook that has a caption a number and an anchor."""
    notebook = links.notebook_number(pagename)
    if not notebook:
        return
    first, *others = context["body"].split(SHOWN)
    parts = [first]
    for number, part in enumerate(others, 1):
        caption = f'<figcaption><span class="figure-number">Figure {notebook}.{number}.</span> '
        part = part.replace("<figcaption>", caption, 1)
        parts.append(f'<figure class="shown" id="figure-{number}">{part}')
    context["body"] = "".join(parts)


@cache
def _table_of_symbols(file):
    """Return the entries of the tables of symbols in a page of Markdown or a notebook."""
    if not file.exists():
        return []
    text = file.read_text(encoding="utf-8")
    if file.suffix == ".ipynb":
        cells = nbformat.reads(text, as_version=4).cells
        text = "\n\n".join(cell.source for cell in cells if cell.cell_type == "markdown")
    return glossary.entries(text, formulas.mathml_of)


def add_glossary(app, pagename, templatename, context, doctree):
    """Add the meanings of the symbols on the page of a notebook, which symbols.js shows."""
    if links.notebook_number(pagename):
        own = _table_of_symbols(Path(app.srcdir, f"{pagename}.ipynb"))
        common = _table_of_symbols(Path(app.srcdir, "notation.md"))
        context["body"] += glossary.glossary(context["body"], own, common)


def _in_output(match):
    return formulas.typeset(html.unescape(match[1]))


def set_formulas_in_outputs(app, pagename, templatename, context, doctree):
    """Typeset the formulas in HTML outputs, as JupyterLab does.

    Then all formulas of the page are there: punctuation is kept with them, and their letters are
    defined, once per page.
    """
    body = re.sub(
        r'<span class="math" data-tex="([^"]*)"></span>', _in_output, context.get("body", "")
    )
    body = formulas.with_punctuation(body)
    context["body"] = body
    if letters := formulas.letters_of(body + (context.get("toc") or "")):
        context["body"] = letters + body


def setup(app):
    """Register the functions above."""
    app.add_config_value("course_repository", "", "html")
    app.connect("config-inited", offer_to_run, priority=1)
    app.connect("doctree-read", name_tables_of_symbols)
    app.connect("doctree-read", stack_wide_tables)
    app.connect("html-page-context", name_columns)
    app.connect("builder-inited", do_without_sphinx_search)
    app.connect("html-page-context", name_the_course_once)
    app.connect("doctree-read", colour_commands)
    app.connect("doctree-read", find_dollars)
    app.connect("doctree-read", leave_unnumbered)
    app.connect("doctree-read", number_equations)
    app.connect("doctree-resolved", link_what_is_named)
    app.connect("doctree-resolved", fold_more)
    app.add_html_math_renderer(
        "built", inline_renderers=(set_formula, None), block_renderers=(set_formula, None)
    )
    app.connect("html-page-context", number_figures)
    app.connect("html-page-context", add_glossary)
    app.connect("html-page-context", set_formulas_in_outputs)
    app.connect("build-finished", lambda app, error: formulas.close())
    app.connect("html-page-context", load_scripts_where_needed)
