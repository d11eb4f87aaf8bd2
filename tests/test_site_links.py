"""What leads from one place of the pages to another, and the meanings of symbols."""

import re

import pytest
from bs4 import BeautifulSoup
from nbformat.v4 import new_markdown_cell
from playwright.sync_api import expect
from site_notebooks import cell, output, png, write
from site_visits import Visit, violations
from sphinx_builds import build

from course_lib.pack.site import SiteError, formulas, glossary
from course_lib.pack.site import build as builder

pytestmark = pytest.mark.slow  # Sphinx builds a site of its own for these tests

FIRST = r"""# Rotations

See *Axis and angle*, *Two ways*, *Both*, and notebook 2. Notebook 1 is this one, notebook 7 none.
`notebook 2` is code. In *Modern times*, $R_{ab}\,p_b = e^{[w]}$ with $k_1 = 2$, $e_x$ and $e$.

[The line](#cell-id=second-figure) rises, [this](#cell-id=no-figure) is code (and $q$, so $p$).

| symbol | meaning |
|---|---|
| $R_{ab}$, `R_ab` | the **orientation** of b, $R^T R = I$ |
| $k_1$, $k_2$ | axes of this notebook |

$$R = I$$

$$
p = R\,q
$$

## Axis and angle

## Two ways: here and there

## Both

## Sources

- K. M. Lynch and F. C. Park, *Modern Robotics*, 2017.
- T. Sugihara, *IEEE Transactions on Robotics* 27, 2011.
"""
SECOND = """# Rigid motion

## Both

## Both: again

*Axis and angle* of notebooks 1 and 3, and *Elsewhere*.
"""
THIRD = """# Plots

## Elsewhere

*Both* is in two notebooks.
"""
NOTATION = r"""# Notation

## What you need

Nothing.

## Symbols

| symbol | in code | meaning |
|---|---|---|
| $R_{ab}$ | `R_ab` | not the notebook's own words |
| $p_a$ | `p_a` | a point |
| $[w]$ | `hat(w)` | a matrix |
| $e^{[w]}$, $\log R$ | `exp_so3` | from a vector to a rotation |
| $e$ | `e` | an error |
| $J$ | `J` | a Jacobian |
"""


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    folder = tmp_path_factory.mktemp("links") / "notebooks"
    picture = output({"image/png": png()}, "A rising line")
    picture.metadata["caption"] = "It rises."
    second, last = cell(picture), cell(source="pass")
    second.id, last.id = "second-figure", "no-figure"
    write(folder, "01_rotations.ipynb", new_markdown_cell(FIRST), cell(picture), second, last)
    write(folder, "02_rigid_motion.ipynb", new_markdown_cell(f"{SECOND} [all](notation.md)"))
    write(folder, "03_plots.ipynb", new_markdown_cell(THIRD))
    (folder / "notation.md").write_text(NOTATION, encoding="utf-8")
    build(folder, folder.parent / "html", repository="https://github.com/owner/name")
    return folder.parent / "html"


@pytest.fixture(scope="module")
def pages(site):
    names = ("01_rotations", "02_rigid_motion", "03_plots", "index", "search")
    files = {name: (site / f"{name}.html").read_text(encoding="utf-8") for name in names}
    return {name: BeautifulSoup(text, "html.parser") for name, text in files.items()}


def links_of(page):
    """{text of a link: its address} of an article's running text."""
    links = page.select("article :is(p, li) a[href]")
    return {link.get_text(): link["href"] for link in links}


def test_another_notebook_that_a_text_names_is_a_link(pages):
    links = links_of(pages["01_rotations"])
    assert links["notebook 2"] == "02_rigid_motion.html"
    assert "Notebook 1" not in links, "the page itself"
    assert "notebook 7" not in links, "there is none"
    both = links_of(pages["02_rigid_motion"])
    assert both["notebooks 1"] == "01_rotations.html"
    assert both["3"] == "03_plots.html"


def test_a_section_named_in_italics_is_a_link_to_it(pages):
    links = links_of(pages["01_rotations"])
    assert links["Axis and angle"] == "#axis-and-angle"
    assert links["Two ways"] == "#two-ways-here-and-there"
    assert links["Both"] == "#both", "the page's own section comes first"
    assert "Modern times" not in links
    others = links_of(pages["02_rigid_motion"])
    assert others["Axis and angle"] == "01_rotations.html#axis-and-angle"
    assert others["Elsewhere"] == "03_plots.html#elsewhere"


def test_a_name_of_sections_in_two_notebooks_is_no_link(pages):
    assert "Both" not in links_of(pages["03_plots"])


def test_a_source_is_a_link_to_its_doi(pages):
    links = links_of(pages["01_rotations"])
    assert links["Modern Robotics"] == "https://doi.org/10.1017/9781316661239"
    assert links["T. Sugihara"] == "https://doi.org/10.1109/TRO.2011.2148230"


def test_figures_are_numbered_within_their_notebook(pages):
    """Equations are numbered in the same way."""
    page = pages["01_rotations"]
    captions = [part.get_text() for part in page.select("figcaption")]
    assert captions == ["Figure 1.1. It rises.", "Figure 1.2. It rises."]
    assert page.select_one("#figure-2 figcaption").get_text() == captions[1]
    assert page.select_one("#equation-2 .equation-number").get_text() == "(1.2)"
    assert page.select_one("#equation-2 math")


def test_a_link_to_the_cell_of_a_figure_names_the_figure(pages):
    assert links_of(pages["01_rotations"])["Figure 1.2"] == "#figure-2"


def test_a_link_to_a_cell_without_a_figure_leaves_its_words(pages):
    assert "this is code" in pages["01_rotations"].article.get_text()
    assert "this" not in links_of(pages["01_rotations"])


def test_a_link_to_a_cell_that_is_not_there_is_refused(tmp_path):
    text = new_markdown_cell("# A\n\nSee [the figure](#cell-id=gone).")
    write(tmp_path / "notebooks", "01.ipynb", text)
    with pytest.raises(SiteError, match=r"01\.ipynb, cell 1 links to the cell gone"):
        builder.build(tmp_path / "notebooks", tmp_path / "html")


def test_no_line_breaks_between_a_formula_and_punctuation(pages):
    page = BeautifulSoup(str(pages["01_rotations"]), "html.parser")
    for part in page.select("article .unbroken math"):
        part.decompose()  # what is left is punctuation
    kept = [part.get_text() for part in page.select("article .unbroken")]
    assert "," in kept
    assert ")." in kept


def test_tabs_name_the_page_and_the_course(pages):
    assert pages["01_rotations"].title.get_text() == "Rotations — Robot kinematics"
    assert pages["search"].title.get_text() == "Search — Robot kinematics"
    assert pages["index"].title.get_text() == "Robot kinematics"


def test_the_home_page_says_how_to_cite_and_what_is_needed_first(pages):
    home = pages["index"]
    citation = home.select_one("#licence-citation pre").get_text()
    assert re.search(r"@misc\{\S+,\n  title = ", citation)
    assert "https://github.com/owner/name" in citation
    assert "Six notebooks" in [part.get_text().rstrip("#") for part in home.select("h2")]
    assert home.select("p a[href='notation.html#what-you-need']")


@pytest.mark.parametrize(
    ("host", "repository"),
    [
        ("mybinder.org", "gh/owner/name/main"),
        ("colab.research.google.com", "github/owner/name/blob/main"),
    ],
)
def test_a_notebook_opens_where_its_repository_can_be_run(pages, host, repository):
    (link,) = pages["01_rotations"].select(f"a[href*='{host}']")
    assert repository in link["href"]
    assert link["href"].endswith("notebooks/01_rotations.ipynb")
    assert not pages["index"].select(f"a[href*='{host}']")


@pytest.mark.parametrize("address", ["github.com/owner/name", "https://github.com/owner", "x y"])
def test_an_address_that_is_no_repository_is_refused(tmp_path, address):
    write(tmp_path / "notebooks", "01.ipynb", new_markdown_cell("# A"))
    with pytest.raises(SiteError, match="is no address of a repository on GitHub"):
        builder.build(tmp_path / "notebooks", tmp_path / "html", repository=address)


# ---- symbols ----


@pytest.mark.parametrize(
    ("formula", "symbols"),
    [
        (r"R_{ab}^T", ["R_ab|R"]),
        (r"e^{[w]}", ["exp", "[", "w"]),
        (r"e_x + e", ["e_x", "e"]),
        (r"\dot R = R\,[\omega]", ["R", "[", "ω"]),
        (r"k_1", ["k_1|k"]),
        (r"\mathcal V", ["script-V"]),
        (r"[x_b \; y_b \; z_b]", ["x_b|x", "y_b|y", "z_b|z"]),
        (r"\lVert M \rVert", ["‖", "M"]),
    ],
)
def test_a_formula_names_its_symbols(formula, symbols):
    assert list(glossary.symbols_in(formulas.mathml_of(formula))) == symbols


def meanings(page):
    return [part.get_text() for part in page.select("#course-symbols dd")]


def test_the_glossary_of_a_page_has_its_symbols_and_no_others(pages):
    found = meanings(pages["01_rotations"])
    assert found[1] == "axes of this notebook"
    assert {"a point", "a matrix", "from a vector to a rotation", "an error"} <= set(found)
    assert "a Jacobian" not in found
    assert meanings(pages["03_plots"]) == []


def test_a_notebooks_own_meaning_replaces_the_common_one(pages):
    found = meanings(pages["01_rotations"])
    assert found[0].startswith("the orientation of b")
    assert "not the notebook's own words" not in found


def test_a_symbol_is_explained_under_the_pointer_until_escape(site, browser):
    with Visit(browser, site / "01_rotations.html") as visit:
        note = visit.page.locator(".symbols-note")
        visit.page.locator("article p .math").first.hover()
        expect(note).to_contain_text("the orientation of b")
        expect(note).to_contain_text("a point")
        assert violations(visit, within=".symbols-note") == []
        visit.page.keyboard.press("Escape")
        expect(note).to_be_hidden()


def test_a_symbol_is_explained_on_a_tap(site, browser):
    with Visit(browser, site / "01_rotations.html", width=390, has_touch=True) as visit:
        formula = visit.page.locator("article p .math").first
        formula.tap()
        note = visit.page.locator(".symbols-note")
        expect(note).to_contain_text("the orientation of b")
        assert visit.page.evaluate("document.documentElement.scrollWidth") <= 390
        visit.page.locator("article h1").tap()
        expect(note).to_be_hidden()


def test_the_keyboard_opens_the_list_of_all_symbols(site, browser):
    with Visit(browser, site / "01_rotations.html", theme="dark", width=390) as visit:
        button = visit.page.get_by_role("button", name="Symbols")
        button.press("Enter")
        dialog = visit.page.get_by_role("dialog", name="Symbols on this page")
        expect(dialog).to_contain_text("axes of this notebook")
        assert violations(visit, within=".symbols-list") == []
        visit.page.keyboard.press("Escape")
        expect(dialog).to_be_hidden()
        assert button.evaluate("button => button === document.activeElement")
        assert visit.complaints == []
