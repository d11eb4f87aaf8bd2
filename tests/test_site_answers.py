"""What is folded shut on the pages: answers, which may be left out, and sections of More, with a
report among them."""

import shutil

import pytest
from bs4 import BeautifulSoup
from nbformat.v4 import new_markdown_cell, new_output
from playwright.sync_api import expect
from site_notebooks import (
    CHECK,
    EXPLAINED,
    MODEL_ANSWER,
    NBGRADER,
    SLIDING,
    SOLUTION,
    cell,
    output,
    png,
    write,
)
from site_visits import CONTRAST, Visit, assert_readable
from sphinx_builds import build

from course_lib.figures.stills import TOY
from course_lib.pack.site import SiteError

pytestmark = pytest.mark.slow  # Sphinx builds a site of its own for these tests

TITLE, PROMISE = (
    "More: rotations at random",
    "You draw them uniformly, $R^\\top R = I$. 40 minutes.",
)
PAGES = {"01.html", "02_rotations.html", "03_rigid_motion.html", "index.html", "search.html"}
# What an answer computes, and the score of what is given: they are no verdicts.
PRINTED = """as you sent it: [0. 0. 0.] m/s
your table misses by 0.04 cm
the rows that you read off agree: True
targets out of reach: 1 of 400
"""
CHOICES = (
    '<div class="course-predict" role="status">No choice yet.'
    "<details><summary>a</summary>In vain.</details></div>"
)
ANSWERS = {
    "Solution": "gooseberry",
    "Model answer": "stay orthogonal",
}  # name: words that are inside


def more(text):
    return new_markdown_cell(text, metadata={"tags": ["more"]})


@pytest.fixture(scope="module")
def notebooks(tmp_path_factory):
    folder = tmp_path_factory.mktemp("answers") / "notebooks"
    write(
        folder,
        "01.ipynb",
        new_markdown_cell("# Answers"),
        cell(source=SOLUTION, nbgrader=NBGRADER),
        new_markdown_cell(MODEL_ANSWER, metadata={"nbgrader": EXPLAINED}),
        cell(output({"text/html": CHECK}), source="check.turn(turn)"),
        cell(output({"text/html": "<p>A result</p>"}), source="turn()"),
        cell(
            new_output("stream", text="raisins: 3\nyour score: 94 of 100\n"), source="score(turn)"
        ),
        cell(
            new_output("stream", text=PRINTED),
            output({"text/html": CHOICES}),
            source="check.turn.use(turn)",
        ),
        cell(source="import numpy as np\n\nraisins = 3"),
        cell(
            output({"image/png": png()}, "A rising line"), source='show(fig, caption="It rises.")'
        ),
        cell(
            output({"image/png": png()}, "A line"),
            new_output("stream", text="7"),
            source="show(fig)\nprint(plums)",
        ),
    )
    write(
        folder,
        "02_rotations.ipynb",
        new_markdown_cell("# Rotations\n\nA drone grows. It takes about three hours."),
        cell(source="import numpy as np"),
        cell(
            output({"image/png": png()}, "A rising line"),
            source="x = 2\nprint(x)\ndraw(x)",
            tags=["cover"],
        ),
        new_markdown_cell("Words of the core. See [the numbers](#Reproduce)."),
        more(f"## {TITLE}\n\n{PROMISE}"),
        new_markdown_cell("Haar's measure.\n\n### Three angles\n\nThey are not uniform."),
        cell(source=SOLUTION, nbgrader=NBGRADER),
        cell(output({TOY: SLIDING, "image/png": png()}, "Two poses on a floor")),
        more("## Appendix: the report\n\nWhat it did."),
        new_markdown_cell(
            "### What it is\n\nA homework report.\n\n### Reproduce\n\nAll digits agree."
        ),
    )
    plain = "# Rigid motion\n\n[There](02_rotations.ipynb#Reproduce)."
    write(folder, "03_rigid_motion.ipynb", new_markdown_cell(plain))
    write(folder, "Untitled.ipynb", new_markdown_cell("# Notes of the author's own"))
    (folder / "Marks.md").write_text("# For graders")
    return folder


@pytest.fixture(scope="module")
def site(notebooks):
    """The site with solutions (True), and the one without (False) that was built in its place."""
    folder, copy = notebooks.parent / "html", notebooks.parent / "html-with-solutions"
    build(notebooks, folder)
    (folder / "of_before.html").touch()
    shutil.copytree(folder, copy)
    build(notebooks, folder, solutions=False)
    return {True: copy, False: folder}


def test_the_pages_are_those_of_this_build_alone(
    site,
):
    assert {page.name for page in site[False].glob("*.html")} == PAGES


def test_only_the_instructors_pages_speak_of_teaching(site):
    home = {solutions: (site[solutions] / "index.html").read_text("utf-8") for solutions in site}
    assert 'href="guide.html"' in home[True]
    assert "Teach with it" not in home[False]


@pytest.fixture(scope="module")
def visit(site, browser):
    """A visit to the page with answers; every test leaves them shut."""
    with Visit(browser, site[True] / "01.html", theme="dark", width=390) as visit:
        yield visit
        assert visit.complaints == []


@pytest.mark.parametrize("name", ANSWERS)
def test_mouse_and_keyboard_unfold_an_answer(visit, name):
    line = visit.page.locator("summary").filter(has_text=name)
    inside = visit.page.locator("article").get_by_text(ANSWERS[name])
    expect(inside).not_to_be_visible()
    line.click()
    expect(inside).to_be_visible()
    assert visit.page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    for part in (line.locator("p:visible"), inside):
        assert part.evaluate(CONTRAST) > 4.5
    line.click()
    expect(inside).not_to_be_visible()
    line.focus()
    visit.page.keyboard.press("Enter")
    expect(inside).to_be_visible()
    visit.page.keyboard.press("Space")
    expect(inside).not_to_be_visible()


def test_only_imports_and_lines_that_draw_are_folded(site):
    soup = BeautifulSoup((site[True] / "01.html").read_text(encoding="utf-8"), "html.parser")
    assert not soup.select("summary[aria-label]"), "a screen reader reads the line that is shown"
    folds = {
        fold.summary.p.get_text(strip=True): fold for fold in soup.select("article details.hide")
    }
    assert [*folds] == [*ANSWERS, "Imports and settings", "The lines that draw it"]
    assert "import numpy" in folds["Imports and settings"].get_text()
    drawn = folds["The lines that draw it"]
    assert "It rises." in drawn.get_text()
    assert not drawn.select("img"), "the figure itself stands open"
    assert not [fold for fold in folds.values() if "plums" in fold.get_text()], (
        "it computes, and prints"
    )


def test_without_answers_a_page_shows_what_students_find(site):
    text = (site[False] / "01.html").read_text(encoding="utf-8")
    assert "NotImplementedError" in text
    assert "Type your answer here." in text
    assert "A result" in text
    assert "raisins: 3" in text
    assert "your score" in (site[True] / "01.html").read_text(encoding="utf-8")
    assert "your score" not in text, "there is no answer yet that could be scored"
    assert not [
        words
        for words in ("gooseberry", "orthogonal", "Rubric", "Model answer", ">Solution", "Right: ")
        if words in text
    ]
    assert "orthogon" not in (site[False] / "searchindex.js").read_text(encoding="utf-8")


def test_left_out_no_printed_line_goes_for_a_word_in_it(site):
    text = (site[False] / "01.html").read_text(encoding="utf-8")
    assert [line for line in PRINTED.splitlines() if line not in text] == []


def test_left_out_the_score_of_given_code_stays(tmp_path):
    given = new_output("stream", text="your score: 21 of 100\n")
    write(
        tmp_path / "notebooks",
        "01.ipynb",
        new_markdown_cell("# Answers"),
        cell(source=SOLUTION, nbgrader=NBGRADER),
        cell(given, source="def mine():\n    return 1\n\n\nscore(mine)"),
    )
    build(tmp_path / "notebooks", tmp_path / "html", solutions=False)
    assert "your score: 21 of 100" in (tmp_path / "html" / "01.html").read_text(encoding="utf-8")


def test_left_out_the_replies_to_a_prediction_can_be_opened(site, browser):
    with Visit(browser, site[False] / "01.html") as visit:
        choice = visit.page.locator(".course-predict details", has_text="In vain.")
        assert not choice.evaluate("choice => choice.open")
        choice.locator("summary").press("Enter")
        assert choice.evaluate("choice => choice.open")


def test_a_site_can_have_model_answers_without_solutions(notebooks, tmp_path):
    build(notebooks, tmp_path / "html", solutions=False, model=True)
    text = (tmp_path / "html" / "01.html").read_text(encoding="utf-8")
    assert (
        "stay orthogonal"
        in BeautifulSoup(text, "html.parser").select_one("article details.hide").get_text()
    )
    assert "NotImplementedError" in text
    assert "gooseberry" not in text


def test_an_answer_that_cannot_be_told_from_the_rest_is_named(tmp_path):
    bare = cell(source="def turn():\n    return 42", nbgrader=NBGRADER)
    write(
        tmp_path / "notebooks",
        "01.ipynb",
        new_markdown_cell("# Answers"),
        bare,
        cell(output({"text/html": "x"})),
    )
    with pytest.raises(
        SiteError, match=r"01\.ipynb, cell 2: an answer cell without ### BEGIN SOLUTION"
    ):
        build(tmp_path / "notebooks", tmp_path / "html", solutions=False)
    assert not (tmp_path / "html").exists()


# ---- sections of More ----


@pytest.fixture
def more_visit(site, browser):
    with Visit(browser, site[True] / "02_rotations.html", width=390, theme="dark") as visit:
        yield visit


def test_the_keyboard_opens_a_folded_section(more_visit, notebooks):
    page = more_visit.page
    line, inside = page.locator("summary.more").first, page.get_by_text("Haar")
    expect(line.locator("h2")).to_contain_text(TITLE)
    expect(line.locator(".promise")).to_contain_text("40 minutes")
    expect(line.locator(".promise .math")).to_be_visible()
    expect(inside).not_to_be_visible()
    assert page.locator("summary.more").count() == 2
    assert page.locator("details details summary", has_text="Solution").count() == 1
    line.focus()
    page.keyboard.press("Enter")
    expect(inside).to_be_visible()
    expect(page.get_by_text("All digits agree")).not_to_be_visible()
    assert_readable(more_visit, notebooks / "02_rotations.ipynb", 390)


def test_a_link_into_a_section_opens_it_each_time(more_visit, site):
    page, there = more_visit.page, more_visit.page.get_by_text("All digits agree")
    for _ in range(2):
        page.get_by_role("link", name="the numbers").click()
        expect(there).to_be_in_viewport()
        page.locator("summary.more").nth(1).press("Enter")
        expect(there).not_to_be_visible()
    page.goto((site[True] / "03_rigid_motion.html").as_uri())
    page.get_by_role("link", name="There").click()
    expect(there).to_be_in_viewport()


def test_a_hit_of_the_search_opens_what_is_folded_around_it(site, browser):
    with Visit(browser, site[True] / "search.html", query="?q=gooseberry") as visit:
        visit.page.locator("#search-results a", has_text="Rotations").first.click()
        expect(visit.page.locator("details details .highlighted")).to_be_in_viewport()


def test_an_open_section_is_printed_with_its_answers(more_visit):
    page = more_visit.page
    section = page.locator("section.more > details").first
    page.emulate_media(media="print")
    expect(page.get_by_text("Haar")).not_to_be_visible()
    expect(section.locator("summary.more")).to_be_visible()
    section.evaluate("details => (details.open = true)")
    for words in ("Haar", "gooseberry"):
        expect(page.get_by_text(words)).to_be_visible()
    expect(page.locator(".tag_not-on-paper summary").first).not_to_be_visible()
    section.evaluate("details => (details.open = false)")
    page.emulate_media(media="null")


def test_paper_shows_the_replies_to_a_prediction(visit):
    reply = visit.page.locator(".course-predict details")
    height = "details => details.offsetHeight - details.querySelector('summary').offsetHeight"
    visit.page.emulate_media(media="print")
    assert reply.evaluate(height) > 10
    visit.page.emulate_media(media="null")
    assert reply.evaluate(height) < 2


def test_the_first_screen_shows_the_figure_before_the_words(more_visit):
    tops = [
        more_visit.page.locator(part).first.bounding_box()["y"]
        for part in ("article h1", "article img", "p:has-text('core')")
    ]
    assert tops == sorted(tops)
    assert tops[1] < 600
    folded = [
        line.strip() for line in more_visit.page.locator("details.hide > summary").all_inner_texts()
    ]
    assert folded[:2] == ["Imports and settings", "The lines that draw it"]
