"""The site's figures by plotly: their colours in the dark, and their room on a phone."""

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

# Two scenes beside each other, with their titles.
CUBE = {"type": "scatter3d", "x": [0, 1], "y": [0, 1], "z": [0, 1]}
TITLE = {"xref": "paper", "yref": "paper", "y": 1, "showarrow": False}
BESIDE = {
    "data": [CUBE, {**CUBE, "scene": "scene2"}],
    "layout": {
        "width": 800,
        "height": 400,
        "scene": {"domain": {"x": [0, 0.48]}},
        "scene2": {"domain": {"x": [0.52, 1]}},
        "annotations": [{**TITLE, "x": 0.24, "text": "before"}, {**TITLE, "x": 0.76, "text": "after"}],
    },
}


@pytest.fixture(scope="module")
def figures():
    return LINE, BESIDE


@pytest.fixture(scope="module")
def page(figures, tmp_path_factory):
    """A page with a line and a figure of two scenes, far from each other."""
    folder = tmp_path_factory.mktemp("controls")
    line, beside = (cell(output({FIGURE: figure, "text/plain": "What it shows"})) for figure in figures)
    begin, words = new_markdown_cell("# Controls"), new_markdown_cell("Words. " * 2400)
    write(folder / "notebooks", "01.ipynb", begin, line, words, beside)
    build(folder / "notebooks", folder / "html")
    return folder / "html/01.html"


on_a_desktop = pytest.mark.parametrize("opened", [1280], indirect=True)


@pytest.fixture(scope="module", params=[1280, 390], ids=["desktop", "phone"])
def opened(page, browser, request):
    with Visit(browser, page, width=request.param) as visit:
        yield visit


@pytest.fixture
def visit(opened):
    """The page, opened once for all tests of a width."""
    yield opened
    assert opened.complaints == []


class Box:
    """A figure on the page, scrolled to and drawn."""

    def __init__(self, visit, number):
        self.visit = visit
        self.box = visit.page.locator(".plotly-figure").nth(number)
        self.live = self.box.locator(".plotly-live")
        self.come()

    def come(self):
        self.box.scroll_into_view_if_needed()
        expect(self.box.locator(".main-svg").first).to_be_visible()

    def leave(self, number):
        """Scroll to another figure, so far away that this one is let go."""
        self.visit.page.locator(".plotly-figure").nth(number).scroll_into_view_if_needed()
        expect(self.box.locator(".main-svg")).to_have_count(0)

    def wait_for(self, js, value):
        """Wait until a function of the live figure gives a number or a string."""
        handle = self.live.element_handle()
        self.visit.page.wait_for_function(f"([live, value]) => ({js})(live) === value", arg=[handle, value])


# ---- colours, and room ----


@on_a_desktop
def test_a_live_figure_follows_the_theme_and_back_and_keeps_what_was_zoomed(visit):
    box = Box(visit, 0)
    drawn = "live => live.data[0].line.color + ' ' + live._fullLayout.font.color + ' ' + live._fullLayout.plot_bgcolor"
    light = box.live.evaluate(drawn)
    assert light.split() == ["#b2182b", "#222222", "white"]
    box.live.evaluate("live => window.Plotly.relayout(live, {'xaxis.range': [0, 2]})")
    visit.page.evaluate("document.documentElement.dataset.theme = 'dark'")
    box.wait_for(drawn, "#f2667a #e7eaee #1b1f24")
    box.leave(1)
    box.come()
    assert box.live.evaluate("live => live.layout.xaxis.range") == [0, 2]
    visit.page.evaluate("document.documentElement.dataset.theme = 'light'")
    box.wait_for(drawn, light)


def test_on_a_phone_scenes_are_stacked_each_under_its_title(visit):
    box = Box(visit, 1)
    layout = box.live.evaluate("""live => ({
      x: [live._fullLayout.scene.domain.x, live._fullLayout.scene2.domain.x],
      y: [live._fullLayout.scene.domain.y, live._fullLayout.scene2.domain.y],
      titles: live._fullLayout.annotations.map(({ x, y }) => [x, y]),
    })""")
    size, (first, second) = box.live.bounding_box(), layout["y"]
    if visit.page.viewport_size["width"] > 600:
        assert layout["x"] == [[0, 0.48], [0.52, 1]]
        assert first == second == [0, 1]
        return
    assert layout["x"] == [[0, 1], [0, 1]]
    assert second[1] < first[0], "below"
    assert [first[1] <= y <= 1 for y in [layout["titles"][0][1]]] == [True]
    assert second[1] <= layout["titles"][1][1] < first[0], "between the scenes"
    assert [x for x, _ in layout["titles"]] == pytest.approx([0.5, 0.5])
    assert size["height"] > 1.5 * size["width"], "each as large as the phone is wide"
