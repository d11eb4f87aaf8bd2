"""The site as readers see it: in a browser, from a folder, without a network."""

import base64
import re
import runpy
import subprocess
import sys

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_markdown_cell, new_output
from playwright.sync_api import expect
from site_notebooks import (
    CHECK,
    EXPLAINED,
    MATRIX,
    MODEL_ANSWER,
    NBGRADER,
    SLIDING,
    SOLUTION,
    TABLE,
    TEXT,
    TURNING,
    caption_output,
    cell,
    output,
    png,
    write,
)
from site_visits import CONTRAST, OPEN, Visit, assert_readable
from sphinx_builds import build

from course_lib.figures.stills import TOY
from course_lib.pack.site import SiteError
from course_lib.pack.site import build as builder
from course_lib.pack.site.prepare import prepare

CHOICE = "<details><summary>a</summary>Prediction</details>"
CAPTION = "Both circles turn the same way."


@pytest.fixture(scope="module")
def notebooks(tmp_path_factory):
    folder = tmp_path_factory.mktemp("site") / "notebooks"
    write(
        folder,
        "01_rotations.ipynb",
        new_markdown_cell(TEXT),
        cell(source=SOLUTION, nbgrader=NBGRADER),
        new_markdown_cell(MODEL_ANSWER, metadata={"nbgrader": EXPLAINED}),
        cell(
            output({TOY: TURNING, "image/png": png()}, 'Two "circles" on a sphere'),
            caption_output(CAPTION),
        ),
        cell(
            output(
                {"image/png": png(), "text/plain": "<Figure size 640x480 with 1 Axes>"},
                "A rising line",
            )
        ),
        cell(
            output({"text/html": CHECK}),
            output({"text/html": CHOICE}),
            new_output("stream", text="distance 1.48 " * 30),
        ),
        cell(output({"text/html": TABLE}), output({"text/latex": MATRIX})),
        *[new_markdown_cell("Words. " * 400) for _ in range(3)],
        cell(output({TOY: SLIDING, "text/plain": "Two poses on a floor </script>"})),
        cell(source="hidden_input = 1", tags=["hide-input"]),
        cell(source="removed_cell = 1", tags=["remove-cell"]),
    )
    links = "see [the first](01_rotations.ipynb), [notation](notation.md)"
    plain = new_markdown_cell(f"# Rigid motion\n\nNo figure; {links}. The adjoint.")
    write(folder, "02_rigid_motion.ipynb", plain)
    write(folder, "03_plots.ipynb", new_markdown_cell("# Plots"), cell(output({})))
    (folder / "notation.md").write_text("# Notation\n\n$R$ is a rotation.\n", encoding="utf-8")
    return folder


@pytest.fixture(scope="module")
def site(notebooks):
    before = {file: file.read_bytes() for file in notebooks.iterdir()}
    build(notebooks, notebooks.parent / "html")
    assert {file: file.read_bytes() for file in notebooks.iterdir()} == before
    return notebooks.parent / "html"


@pytest.fixture(scope="module")
def reader(site, browser):
    """A visit to the page with figures, all drawn, for several tests, none of which depends on
    another."""
    with Visit(browser, site / "01_rotations.html", theme="dark") as visit:
        visit.draw_figures()
        yield visit
        assert visit.complaints == []


def test_a_block_of_code_is_copied_by_its_button(reader):
    page = reader.page
    page.locator("summary", has_text="Solution").press("Enter")
    button = page.locator("details[open] .highlight").get_by_role("button", name="Copy")
    button.focus()
    page.wait_for_function(
        "getComputedStyle(document.activeElement).opacity === '1'"
    )  # whoever has no mouse sees it
    page.keyboard.press("Enter")
    page.locator("button.copybtn.success").wait_for()
    page.evaluate("document.querySelector('article').prepend(document.createElement('textarea'))")
    words = page.locator("textarea")
    words.focus()
    page.keyboard.press("Control+v")
    assert (
        words.input_value().strip()
        == re.sub(r".*### (BEGIN|END) SOLUTION\n?", "", SOLUTION).strip()
    )
    words.evaluate("e => e.remove()")
    blocks = page.locator("article .highlight:not(.output .highlight)").count()
    assert page.locator("button.copybtn").count() == blocks


def test_still_pictures_are_printed_in_place_of_figures(reader):
    page = reader.page
    figure = page.locator(".toy-figure:has(.toy-still)")
    figure.scroll_into_view_if_needed()
    page.locator(".toy-figure.drawn:has(.toy-still) .course-toy").first.wait_for()
    assert figure.locator(".toy-live").is_visible()
    page.emulate_media(media="print")
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    assert figure.locator(".toy-still").is_visible()
    assert not figure.locator(".toy-live").is_visible()
    assert page.locator("html").get_attribute("data-theme") == "light"
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    page.emulate_media(media="null")
    assert page.locator("html").get_attribute("data-theme") == "dark"


@pytest.mark.tools("pdftotext")
def test_the_printed_page_contains_every_word(reader, tmp_path):
    """No word is beyond the edge of the paper."""
    page = reader.page
    page.pdf(path=tmp_path / "page.pdf", format="A4")
    printed = subprocess.run(
        ["pdftotext", tmp_path / "page.pdf", "-"], capture_output=True, text=True, check=True
    )
    page.evaluate(OPEN)
    read = """() => {
      const text = document.querySelector("article").cloneNode(true);
      text.querySelectorAll(".math, .toy-figure, .headerlink, button, .tag_not-on-paper details, .expanded")
        .forEach((part) => part.remove());
      return document.body.appendChild(text).innerText;
    }"""
    words = {*re.findall(r"[A-Za-z]{4,}", page.evaluate(read))}
    page.locator("article").last.evaluate("e => e.remove()")
    assert {"return", "orthogonal", "Rubric", "Prediction"} <= words, "what is folded shut"
    letters = "".join(printed.stdout.split())
    assert [word for word in words if word not in letters] == []
    page.set_viewport_size({"width": 680, "height": 844})  # A4 within its margins
    page.emulate_media(media="print")
    beyond = """() => [...document.querySelectorAll("article .math svg, article img, article pre")]
      .filter((part) => part.getBoundingClientRect().right > 681 || part.scrollWidth > part.clientWidth + 1)
      .map((part) => part.outerHTML.slice(0, 200))"""
    assert page.locator("article .math svg").count() > 5
    assert page.evaluate(beyond) == []
    page.emulate_media(media="null")
    page.set_viewport_size({"width": 1280, "height": 844})


@pytest.mark.quick
def test_page_works_offline_on_a_phone_in_the_dark(site, notebooks, browser):
    with Visit(browser, site / "01_rotations.html", theme="dark", width=390) as visit:
        facts = assert_readable(visit, notebooks / "01_rotations.ipynb", 390)
        assert facts["theme"] == "dark"
        assert visit.page.locator("figure figcaption").all_inner_texts() == [
            f"Figure 1.1. {CAPTION}"
        ]
        assert facts["groups"] == ['Two "circles" on a sphere', "Two poses on a floor </script>"]
        assert {alt for _, alt in facts["images"]} == {'Two "circles" on a sphere', "A rising line"}
        for part in (
            ".text_html > [role=status]",
            ".dataframe td",
            ".highlight pre",
            "article p",
            "article td",
        ):
            assert visit.page.locator(part).first.evaluate(CONTRAST) > 4.5, part
        style = "e => [getComputedStyle(e).backgroundColor, getComputedStyle(e).filter]"
        plot = visit.page.locator("img.picture").first.evaluate(style)
        assert plot == ["rgb(255, 255, 255)", "invert(0.92) hue-rotate(180deg)"]


def test_still_pictures_are_shown_without_scripts(site, browser):
    page = site / "01_rotations.html"
    with Visit(browser, page, java_script_enabled=False) as visit:
        formulas = visit.page.locator("article .math > svg").all()
        assert len(formulas) > 5
        assert all(
            formula.bounding_box()["width"] > 5 for formula in formulas if formula.is_visible()
        )
        assert visit.page.locator(".toy-still").is_visible()
        assert visit.page.locator(".toy-words", has_text="Two poses on a floor").is_visible()
    with Visit(browser, page, without="figures.js") as visit:
        assert visit.page.get_by_text("A rotation keeps lengths").is_visible()
        assert visit.page.locator(".toy-still").is_visible()


FOR_INSTRUCTORS = [
    "For instructors: from the release to the gradebook",
    "A semester with the course",
]


def test_home_lists_assignments_and_the_search_leads_to_the_word(site, browser):
    with Visit(browser, site / "index.html") as visit:
        links = visit.page.locator(".card h3 a, #reference li a")
        assert [link.inner_text() for link in links.all()] == [
            "Rotations",
            "Rigid motion",
            "Plots",
            "Notation",
            *FOR_INSTRUCTORS,
        ]
        links.nth(1).click()
        assert visit.page.locator("h1").first.inner_text().startswith("Rigid motion")
        assert not [url for url in visit.requests if "figures.js" in url], "a page without a toy"
        visit.page.wait_for_load_state()  # until then nothing listens to the keys
        visit.page.keyboard.press("Control+k")
        visit.page.keyboard.type("symbol\n")
        visit.page.locator("#search-results a", has_text="Rotations").press("Enter")
        expect(visit.page.locator("article .highlighted", has_text="symbol")).to_be_in_viewport()
        visit.page.goto((site / "search.html").as_uri() + "?q=nosuchword")
        expect(visit.page.locator("#search-summary")).to_contain_text("No page holds these words")
        assert visit.page.locator("#search-results li").count() == 0
        assert visit.complaints == []


def test_cells_follow_their_tags_and_the_site_is_small(site):
    page = (site / "01_rotations.html").read_text(encoding="utf-8")
    assert "removed_cell" not in page
    assert "hidden_input" in page.split("<summary", 1)[1]
    assert sum(file.stat().st_size for file in site.rglob("*") if file.is_file()) < 7e6


def test_github_pages_keeps_the_folder_of_the_styles(site):
    assert (site / ".nojekyll").is_file()
    assert (site / "_static").is_dir()


@pytest.mark.slow
def test_building_again_gives_the_same_files(site, notebooks, tmp_path):
    builder.build(notebooks, tmp_path / "html")
    for file in site.rglob("*"):
        again = tmp_path / "html" / file.relative_to(site)
        assert file.is_dir() or file.read_bytes() == again.read_bytes(), file


def test_defects_that_readers_would_see_stop_the_build(tmp_path):
    book = tmp_path / "notebooks"
    bad = (
        r"Text $\frac{1}{2$ and $\left( x$ and $\nosuchmacro$ and \\( y \\) and"
        r" [nowhere](#Nothing)."
    )
    write(book, "01_bad.ipynb", new_markdown_cell("# Bad"), new_markdown_cell(bad))
    with pytest.raises(SiteError) as caught:
        build(book, tmp_path / "html")
    message = str(caught.value)
    for words in ("close brace", r"missing \right", "nosuchmacro", "left as plain text", "Nothing"):
        assert any(
            "01_bad.ipynb, cell 2" in line for line in message.splitlines() if words in line
        ), message
    assert not (tmp_path / "html").exists()
    assert [file.name for file in tmp_path.iterdir()] == ["notebooks"]


def with_picture(folder, text, name):
    picture = {name: {"image/png": png()}}
    write(folder, "01_arm.ipynb", new_markdown_cell(text, attachments=picture))
    return folder / "01_arm.ipynb"


@pytest.mark.parametrize(
    ("name", "reference"), [("image.png", "image.png"), ("my arm.png", "my%20arm.png")]
)
def test_a_picture_that_was_pasted_into_a_text_is_shown(tmp_path, name, reference):
    text = f"# The arm\n\n![An arm at rest](attachment:{reference}) and words."
    book = with_picture(tmp_path / "notebooks", text, name)
    prepare(book, tmp_path)
    (source,) = [each.source for each in nbformat.read(tmp_path / book.name, 4).cells]
    path = re.search(r"!\[An arm at rest\]\((\S+)\) and words", source)[1]
    assert (tmp_path / path).read_bytes() == base64.b64decode(png())


@pytest.mark.parametrize("first", ["", "![An arm at rest](attachment:image.png) "])
@pytest.mark.parametrize("alt", ["", "image.png", "0957d379-efea.png"])
def test_a_pasted_picture_without_alternative_text_is_refused(tmp_path, alt, first):
    text = f"# The arm\n\n{first}![{alt}](attachment:image.png)"
    book = with_picture(tmp_path / "notebooks", text, "image.png")
    with pytest.raises(SiteError, match="cell 1 shows a picture without alternative text"):
        prepare(book, tmp_path)


@pytest.mark.parametrize(
    "reference",
    ['<img src="attachment:image.png" alt="An arm">', "![An arm](attachment:image.png.png)"],
)
def test_a_pasted_picture_that_a_page_would_not_show_is_refused(tmp_path, reference):
    book = with_picture(tmp_path / "notebooks", f"# The arm\n\n{reference}", "image.png")
    with pytest.raises(SiteError, match="cell 1 refers to the picture attachment:"):
        prepare(book, tmp_path)


ERROR = new_output("error", ename="ValueError", evalue="R is not square", traceback=[])


@pytest.mark.parametrize(
    ("output", "sentence"),
    [
        (ERROR, "01_bad.ipynb, cell 2 stopped with ValueError: R is not square"),
        (
            output({"image/png": "", "text/plain": "<Figure size 640x480>"}),
            "cell 2 shows a figure without alt",
        ),
        (
            output({TOY: TURNING, "text/plain": "Figure({'data': []})"}),
            "cell 2 shows a figure without alt",
        ),
        (output({"text/html": "x"}), "01_bad.ipynb, cell 3 was changed, and not run since"),
    ],
)
def test_cells_that_must_not_be_published(tmp_path, output, sentence):
    write(
        tmp_path / "notebooks",
        "01_bad.ipynb",
        new_markdown_cell("# Bad"),
        cell(output),
        new_code_cell("1 + 1"),
    )
    with pytest.raises(SiteError, match=sentence):
        build(tmp_path / "notebooks", tmp_path / "html")


def test_a_failed_build_gives_its_reason_in_a_sentence(tmp_path, monkeypatch, capsys):
    def run():
        with pytest.raises(SystemExit) as left:
            runpy.run_module("course_lib.pack.site", run_name="__main__")
        assert left.value.code == 1
        return capsys.readouterr().err

    books, target = tmp_path / "notebooks", tmp_path / "html"
    books.mkdir()
    monkeypatch.setattr(sys, "argv", ["site", "--notebooks", str(books), "--output", str(target)])
    assert run() == f"No site was built. There are no notebooks in {books}.\n"
    with monkeypatch.context() as typed:
        typed.setattr(sys, "argv", [*sys.argv, "--solutions", "1"])
        assert run() == "No site was built. SOLUTIONS=1 is neither yes nor no nor model.\n"
    with monkeypatch.context() as bare:
        bare.setattr(
            "choreographer.browsers.chromium.Chromium.find_browser", lambda **options: None
        )
        bare.delenv("BROWSER_PATH", raising=False)
        bare.setattr(sys, "argv", [*sys.argv, "--pdf", str(tmp_path / "course.pdf")])
        assert "No site was built. A browser prints the PDF, and no Chrome or Chromium" in run()
    write(books, "01.ipynb", cell())
    assert "01.ipynb holds no outputs" in run()
    (books / "01.ipynb").write_text("<<<<<<< two versions of a notebook")
    assert "01.ipynb is not a notebook" in run()
    target.mkdir()
    (target / "thesis.txt").write_text("mine")
    assert "holds other files than a site" in run()
    monkeypatch.setattr(
        sys, "argv", ["site", "--notebooks", str(tmp_path), "--output", str(target)]
    )
    (books / "01.ipynb").rename(tmp_path / "01.ipynb")
    assert "lies inside" in run()
