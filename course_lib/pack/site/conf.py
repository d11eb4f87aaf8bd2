"""Sphinx's settings; ``build`` copies this file beside the prepared notebooks."""

import re

from docutils import nodes
from sphinx.util import logging

project = "Robot kinematics"
html_title = project
language = "en"

extensions = ["myst_nb"]
include_patterns = ["*.md", "*.ipynb"]

nb_execution_mode = "off"
nb_merge_streams = True

myst_enable_extensions = ["dollarmath", "amsmath"]
# The notebooks are written to be read in JupyterLab too, so they link to headings and set formulas as it does.
myst_heading_anchors = 4
myst_heading_slug_func = "course_lib.pack.site.prepare.heading_anchor"
myst_dmath_double_inline = True
myst_dmath_allow_labels = False

mathjax_path = "mathjax.js"
mathjax3_config = {
    "tex": {
        # HTML outputs may hold $…$, which JupyterLab typesets; Sphinx itself writes \( … \).
        "inlineMath": [["\\(", "\\)"], ["$", "$"]],
        # An unknown macro is then an error, which the tests find, rather than a name in red.
        "packages": {"[-]": ["noundefined"]},
    },
    # MyST adds these classes by itself; text_html is ours, for HTML outputs.
    "options": {
        "processHtmlClass": "tex2jax_process|mathjax_process|math|text_html",
        # The menu's speech and zoom would look for files that are not shipped.
        "enableMenu": False,
    },
}
myst_update_mathjax = False

html_theme = "sphinx_book_theme"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_js_files = ["page.js"]
html_copy_source = False
html_use_index = False
html_show_copyright = False
# Without it the theme logs an error on a reader's first visit.
html_context = {"default_mode": "auto"}
# The search page would fetch every page it lists, which a browser refuses for a file on disk.
html_show_search_summary = False
html_theme_options = {
    "use_download_button": False,
    "home_page_in_toc": True,
    # Search stands in the side bar already.
    "navbar_persistent": [],
    # The footer would name an author and a date.
    "footer_content_items": [],
    # Pages that stand alone lead to no others.
    "show_prev_next": not tags.has("single"),  # noqa: F821 (Sphinx puts it here)
}
# The title stands there as the first entry already; the theme's own lies in no landmark.
html_sidebars = {"**": [] if tags.has("single") else ["search-button-field.html", "sbt-sidebar-nav.html"]}  # noqa: F821


def check_formulas(app, document):
    """Warn of formulas that no browser can set, and of dollars that did not become one."""
    logger = logging.getLogger(__name__)
    for node in document.findall(lambda n: isinstance(n, nodes.math | nodes.math_block)):
        text = re.sub(r"\\\\|\\[{}]", "", node.astext())
        begun = re.findall(r"\\begin\{([^}]*)\}", text)
        ended = re.findall(r"\\end\{([^}]*)\}", text)
        left, right = (len(re.findall(rf"\\{side}(?![A-Za-z])", text)) for side in ("left", "right"))
        problem = (
            (text.count("{") != text.count("}") and "braces do not match")
            or (sorted(begun) != sorted(ended) and r"\begin and \end do not match")
            or (left != right and r"\left and \right do not match")
        )
        if problem:
            logger.warning("formula: %s: %s", problem, " ".join(node.astext().split())[:70], location=node)
    for node in document.findall(nodes.Text):
        inside = (nodes.FixedTextElement, nodes.literal, nodes.math, nodes.math_block, nodes.raw)
        if isinstance(node.parent, inside) or isinstance(node.parent.parent, inside):
            continue
        left_over = re.search(r"\$[^$]+\$|\\[([]|\\begin\{", node)
        if left_over:
            logger.warning("formula: left as plain text: %s", node[left_over.start() :][:70], location=node.parent)


def leave_unnumbered(app, document):
    """Take off the numbers that MyST gives to align and its like: JupyterLab gives none.

    With them go their names, which are random and would change every page at every build.
    """
    for node in document.findall(nodes.math_block):
        if "amsmath" in node["classes"]:
            node["number"] = None
            node["ids"].clear()


def load_scripts_where_needed(app, pagename, templatename, context, doctree):
    """Add plotly.js and the scripts of the figures, after the text, to the pages that hold a figure."""
    figures = re.findall(r'<div class="plotly-figure"([^>]*)>', context.get("body", ""))
    if any("data-without-plotly" not in figure for figure in figures):
        app.add_js_file("plotly.min.js", loading_method="defer")
    scripts = [name for figure in figures for name in re.findall(r'data-scripts="([^"]*)"', figure)]
    for script in dict.fromkeys(" ".join(scripts).split()):
        app.add_js_file(f"figures/{script}.js", loading_method="defer")
    if figures:
        app.add_js_file("figures.js", loading_method="defer")


def name_what_is_folded(app, pagename, templatename, context, doctree):
    """Let a screen reader say "Solution", as the page does, and not MyST-NB's one name for all that is folded."""
    if "body" in context:
        context["body"] = context["body"].replace(' aria-label="Toggle hidden content"', "")


def setup(app):
    """Register the functions above."""
    app.connect("doctree-read", check_formulas)
    app.connect("doctree-read", leave_unnumbered)
    app.connect("html-page-context", name_what_is_folded)
    app.connect("html-page-context", load_scripts_where_needed)
