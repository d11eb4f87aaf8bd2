"""The site's figures by plotly, which no notebook of the course has: their colours in the dark."""

import pytest
from helpers import FIGURE
from nbformat.v4 import new_markdown_cell
from playwright.sync_api import expect
from site_notebooks import cell, output, write
from site_visits import Visit
from sphinx_builds import build

LINE = {
    "data": [{"type": "scatter", "x": [0, 4], "y": [0, 1], "mode": "lines", "line": {"color": "#b2182b"}}],
    "layout": {"font": {"color": "#222222"}, "plot_bgcolor": "white", "paper_bgcolor": "white"},
}


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    """A page with a line twice, far from each other."""
    folder = tmp_path_factory.mktemp("controls")
    line, again = (cell(output({FIGURE: LINE, "text/plain": "What it shows"})) for _ in range(2))
    begin, words = new_markdown_cell("# Controls"), new_markdown_cell("Words. " * 2400)
    write(folder / "notebooks", "01.ipynb", begin, line, words, again)
    build(folder / "notebooks", folder / "html")
    return folder / "html/01.html"


def test_a_live_figure_follows_the_theme_and_back_and_keeps_what_was_zoomed(page, browser):
    drawn = "live => live.data[0].line.color + ' ' + live._fullLayout.font.color + ' ' + live._fullLayout.plot_bgcolor"
    with Visit(browser, page, width=1280) as visit:
        boxes, theme = visit.page.locator(".plotly-figure"), "theme => (document.documentElement.dataset.theme = theme)"
        live = boxes.first.locator(".plotly-live")

        def wait_for(look):
            done = f"([live, look]) => ({drawn})(live) === look"
            visit.page.wait_for_function(done, arg=[live.element_handle(), look])

        boxes.first.scroll_into_view_if_needed()
        expect(live.locator(".main-svg").first).to_be_visible()
        assert live.evaluate(drawn) == "#b2182b #222222 white"
        live.evaluate("live => window.Plotly.relayout(live, {'xaxis.range': [0, 2]})")
        visit.page.evaluate(theme, "dark")
        wait_for("#f2667a #e7eaee #1b1f24")
        boxes.last.scroll_into_view_if_needed()
        expect(live.locator(".main-svg")).to_have_count(0)
        boxes.first.scroll_into_view_if_needed()
        expect(live.locator(".main-svg").first).to_be_visible()
        assert live.evaluate("live => live.layout.xaxis.range") == [0, 2]
        visit.page.evaluate(theme, "light")
        wait_for("#b2182b #222222 white")
        assert visit.complaints == []
