"""Figures with a script of their own: the page loads it, starts it when the figure is near, stops it when it is far."""

import pytest
from nbformat.v4 import new_markdown_cell
from playwright.sync_api import expect
from site_notebooks import MOVING, PLOTLY, cell, output, write
from site_visits import Visit
from sphinx_builds import build

from course_lib.pack.site import build as builder

CORE = "window.course = window.course || { kinds: {} }; window.course.twice = (x) => 2 * x;"
COUNTER = """window.course.kinds["toy:counter"] = (live, meta) => {
  if (window.fails) throw Error("not now");
  const button = document.createElement("button");
  const show = () => (button.textContent = `count ${window.course.twice(meta.count)}`);
  button.addEventListener("click", () => { meta.count += 1; show(); });
  window.course.bar(live).append(button);
  show();
  window.running = (window.running || 0) + 1;
  return () => (window.running -= 1);
};"""


def toy(**meta):
    course = {"kind": "toy:counter", "count": 3, **meta}
    return {"data": MOVING["data"], "layout": {"height": 450, "meta": {"course": course}}}


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    folder = tmp_path_factory.mktemp("scripts")
    (folder / "scripts").mkdir()
    (folder / "scripts/core.js").write_text(CORE, encoding="utf-8")
    (folder / "scripts/counter.js").write_text(COUNTER, encoding="utf-8")
    scripts = ["core", "counter"]
    for name, meta in (("01", {"scripts": scripts}), ("02", {"scripts": scripts, "plotly": False})):
        figure = cell(output({PLOTLY: toy(**meta), "text/plain": "A counter"}))
        last = cell(output({PLOTLY: toy(**meta), "text/plain": "Another counter"}))
        words = new_markdown_cell("Words. " * 1500)
        write(folder / "notebooks", f"{name}.ipynb", new_markdown_cell(f"# Page {name}"), figure, words, last)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(builder, "SCRIPTS", folder / "scripts")
        build(folder / "notebooks", folder / "html")
    return folder / "html"


@pytest.mark.parametrize("page", ["01", "02"])
def test_a_figures_script_starts_when_it_is_near_and_stops_when_it_is_far(site, browser, page):
    with Visit(browser, site / f"{page}.html", width=390) as visit:
        box = visit.page.locator(".plotly-figure").first
        button = box.get_by_role("button", name="count")
        box.scroll_into_view_if_needed()
        button.click()
        assert button.inner_text() == "count 8"
        assert box.locator(".main-svg").count() == (3 if page == "01" else 0)
        visit.page.locator(".plotly-figure").nth(1).scroll_into_view_if_needed()
        visit.page.locator(".plotly-figure").nth(1).get_by_role("button", name="count 6").wait_for()
        if page == "01":
            box.locator(".plotly-words").wait_for()
        assert visit.page.evaluate("window.running") == (1 if page == "01" else 2), "a toy stays"
        box.scroll_into_view_if_needed()
        button.wait_for()
        assert button.inner_text() == "count 8", "what it keeps in meta is there again"
        assert box.get_by_role("button", name="count").count() == 1
        loaded = [url.rsplit("/", 1)[1].split("?")[0] for url in visit.requests if url.split("?")[0].endswith(".js")]
        assert ("plotly.packed.js" in loaded) == (page == "01")
        assert loaded.index("core.js") < loaded.index("counter.js") < loaded.index("figures.js")
        assert visit.complaints == []


@pytest.mark.parametrize("page", ["01", "02"])
def test_a_figure_that_failed_is_drawn_when_it_comes_near_again_and_a_resize_meanwhile_does_no_harm(
    site, browser, page
):
    with Visit(browser, None, java_script_enabled=True) as visit:
        visit.page.add_init_script("""window.fails = true;
            const isFigure = ({ target }) => target.matches(".plotly-figure");
            new MutationObserver((changes) => changes.some(isFigure) && dispatchEvent(new Event("resize")))
              .observe(document, { subtree: true, attributeFilter: ["class"] });""")
        visit.page.goto((site / f"{page}.html").as_uri())
        first, last = (visit.page.locator(".plotly-figure").nth(i) for i in (0, 1))
        first.scroll_into_view_if_needed()
        visit.page.wait_for_function("performance.now() > 1500")
        expect(first.locator(".plotly-words")).to_be_visible()
        visit.page.evaluate("window.fails = false")
        last.scroll_into_view_if_needed()
        last.get_by_role("button", name="count").wait_for()
        first.scroll_into_view_if_needed()
        first.get_by_role("button", name="count").wait_for()
        assert visit.complaints == []


def test_a_page_without_the_script_still_shows_the_figure(site, browser):
    with Visit(browser, site / "01.html", without="figures/counter.js") as visit:
        visit.draw_figures()
    with Visit(browser, site / "02.html", without="figures/counter.js") as visit:
        assert visit.page.locator(".plotly-words").first.is_visible()
