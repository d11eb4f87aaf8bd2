"""A toy's script: the page loads it, starts it, and does so again in the other theme or after a failure."""

import pytest
from nbformat.v4 import new_markdown_cell
from playwright.sync_api import expect
from site_notebooks import cell, output, write
from site_visits import Visit
from sphinx_builds import build

from course_lib.figures.display import TOY
from course_lib.pack.site import build as builder

CORE = "window.course = window.course || { kinds: {} }; window.course.twice = (x) => 2 * x;"
COUNTER = """window.course.kinds["toy:counter"] = (live, meta) => {
  if (window.fails) throw Error("not now");
  const button = document.createElement("button");
  const show = () => (button.textContent = `count ${window.course.twice(meta.count)}`);
  button.addEventListener("click", () => { meta.count += 1; show(); });
  live.append(button);
  show();
  window.running = (window.running || 0) + 1;
  return () => (window.running -= 1);
};"""
META = {"kind": "toy:counter", "scripts": ["core", "counter"], "count": 3, "title": "A </script> in it"}


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    folder = tmp_path_factory.mktemp("scripts")
    (folder / "scripts").mkdir()
    (folder / "scripts/core.js").write_text(CORE, encoding="utf-8")
    (folder / "scripts/counter.js").write_text(COUNTER, encoding="utf-8")
    figure = {TOY: {"data": [], "layout": {"meta": {"course": META}}}, "text/plain": "A counter"}
    words = new_markdown_cell("Words. " * 1500)
    write(
        folder / "notebooks", "01.ipynb", new_markdown_cell("# Page"), cell(output(figure)), words, cell(output(figure))
    )
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(builder, "SCRIPTS", folder / "scripts")
        build(folder / "notebooks", folder / "html")
    return folder / "html/01.html"


def test_a_toy_s_script_starts_when_it_is_near_and_keeps_its_state_in_the_other_theme(page, browser):
    with Visit(browser, page, width=390) as visit:
        first, last = (visit.page.locator(".toy-figure").nth(i) for i in (0, 1))
        button = first.get_by_role("button", name="count")
        button.click()
        assert button.inner_text() == "count 8"
        last.scroll_into_view_if_needed()
        last.get_by_role("button", name="count 6").wait_for()
        visit.page.evaluate("document.documentElement.dataset.theme = 'dark'")
        visit.page.wait_for_function("window.running === 2")
        expect(first.get_by_role("button", name="count")).to_have_text("count 8")
        loaded = [url.rsplit("/", 1)[1].split("?")[0] for url in visit.requests if url.split("?")[0].endswith(".js")]
        assert loaded.index("core.js") < loaded.index("counter.js") < loaded.index("figures.js")
        assert visit.complaints == []


def test_a_toy_that_failed_is_drawn_when_it_comes_near_again(page, browser):
    with Visit(browser, None, java_script_enabled=True) as visit:
        visit.page.add_init_script("window.fails = true;")
        visit.page.goto(page.as_uri())
        first, last = (visit.page.locator(".toy-figure").nth(i) for i in (0, 1))
        with visit.page.expect_console_message(lambda message: "not now" in message.text):
            first.scroll_into_view_if_needed()
        expect(first.locator(".toy-words")).to_be_visible()
        last.scroll_into_view_if_needed()
        visit.page.evaluate("window.fails = false")
        first.scroll_into_view_if_needed()
        first.get_by_role("button", name="count").wait_for()
        assert visit.complaints == []


def test_a_page_without_the_script_still_shows_the_words(page, browser):
    with Visit(browser, page, without="figures/counter.js") as visit:
        assert visit.page.locator(".toy-words").first.is_visible()
