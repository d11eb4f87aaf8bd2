"""Buttons and ranges of the site's figures: they replace plotly's own, work by keyboard and name their value."""

import numpy as np
import pytest
from helpers import FIGURE, places, stored
from nbformat.v4 import new_markdown_cell
from numpy.testing import assert_allclose
from playwright.sync_api import expect
from site_notebooks import cell, output, write
from site_visits import Visit
from sphinx_builds import build

from course_lib.figures.rigid_motion import body_movie

TIMES = np.linspace(0, 1, 21)
POSES = np.stack([np.linspace(-6, 6, 21), np.linspace(-5, 2, 21), np.linspace(0, 2, 21)], -1)
OWN = ".updatemenu-container, .updatemenu-button, .slider-container"  # what plotly draws

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
    return stored(body_movie("body", POSES, TIMES).fig), BESIDE


@pytest.fixture(scope="module")
def page(figures, tmp_path_factory):
    """A page with a movie and a figure of two scenes, far from each other."""
    folder = tmp_path_factory.mktemp("controls")
    movie, beside = (cell(output({FIGURE: figure, "text/plain": "What it shows"})) for figure in figures)
    begin, words = new_markdown_cell("# Controls"), new_markdown_cell("Words. " * 2400)
    write(folder / "notebooks", "01.ipynb", begin, movie, words, beside)
    build(folder / "notebooks", folder / "html")
    return folder / "html/01.html"


on_a_desktop = pytest.mark.parametrize("opened", [1280], indirect=True)


@pytest.fixture(scope="module", params=[1280, 390], ids=["desktop", "phone"])
def opened(page, browser, request):
    with Visit(browser, page, width=request.param) as visit:
        yield visit


@pytest.fixture
def visit(opened):
    """The page, opened once for all tests of a width; each leaves the movie at its beginning."""
    yield opened
    movie = opened.page.locator(".plotly-figure").first.get_by_role("slider")
    if movie.count():  # it is drawn
        movie.press("Home")
    assert opened.complaints == []


class Box:
    """A figure on the page, scrolled to and drawn."""

    def __init__(self, visit, number):
        self.visit, self.keyboard = visit, visit.page.keyboard
        self.box = visit.page.locator(".plotly-figure").nth(number)
        self.live = self.box.locator(".plotly-live")
        self.button, self.ranges = self.box.get_by_role("button", name="Play"), self.box.get_by_role("slider")
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


def assert_shows(box, figure, i):
    """Assert that a movie's drawing, range and label are those of frame i."""
    there = figure["frames"][i]["data"][0]
    box.wait_for("live => live.data[2].x[0]", there["x"][0])
    assert_allclose(places(box.live.evaluate("live => ({x: live.data[2].x, y: live.data[2].y})")), places(there))
    # What is on the screen, too: the red line goes where the data are.
    red = box.live.locator(".scatterlayer .trace").nth(2).locator("path.js-line")
    left, width = red.evaluate("path => [path.getBBox().x, path.getBBox().width]")
    scale = box.live.evaluate("live => live._fullLayout.xaxis._length / 20")
    assert left == pytest.approx(scale * (min(there["x"]) + 10), abs=0.5)
    assert width == pytest.approx(scale * np.ptp(there["x"]), abs=0.5)
    assert box.ranges.input_value() == str(i)
    assert box.ranges.get_attribute("aria-valuetext") == f"time (s): {TIMES[i]:.2f}"


def assert_no_space_left(box, height, below):
    """Assert that nothing of plotly's own controls is there, nor the space that they took."""
    assert box.live.locator(OWN).count() == 0
    assert box.live.evaluate("live => live.layout.margin.b") == below
    wide = box.box.bounding_box()["width"]
    assert box.live.bounding_box()["height"] == pytest.approx(height(wide), abs=1)


# ---- a movie ----


def test_a_movie_has_one_button_and_one_range_and_no_space_for_others(visit, figures):
    box = Box(visit, 0)
    assert (box.box.get_by_role("button", name="Play").count(), box.ranges.count()) == (1, 1)
    assert_no_space_left(box, lambda wide: min(560, wide - 80 + 70), 50)
    sizes = box.live.evaluate("live => [live._fullLayout.xaxis._length, live._fullLayout.yaxis._length]")
    assert sizes[0] == pytest.approx(sizes[1], abs=1), "a square"
    assert_shows(box, figures[0], 0)


@on_a_desktop
def test_the_keyboard_moves_the_range_and_the_drawing_follows(visit, figures):
    box = Box(visit, 0)
    box.ranges.focus()
    for key, i in (("ArrowRight", 1), ("ArrowRight", 2), ("End", 20), ("ArrowLeft", 19), ("Home", 0)):
        box.keyboard.press(key)
        assert_shows(box, figures[0], i)


@on_a_desktop
def test_play_runs_to_the_end_and_restarts_and_moving_the_range_stops_it(visit, figures):
    box = Box(visit, 0)
    button = box.box.get_by_role("button").and_(visit.page.locator(".plotly-player button"))
    button.focus()
    box.keyboard.press("Enter")
    expect(button).to_have_text("Pause")
    expect(button).to_have_text("Play")
    assert_shows(box, figures[0], 20)
    box.keyboard.press("Enter")
    expect(button).to_have_text("Pause")
    box.keyboard.press("Tab")
    box.keyboard.press("Home")
    expect(button).to_have_text("Play")
    assert_shows(box, figures[0], 0)


@on_a_desktop
def test_a_movie_that_leaves_the_window_returns_at_the_same_frame(visit, figures):
    box = Box(visit, 0)
    box.ranges.focus()
    for _ in range(7):
        box.keyboard.press("ArrowRight")
    assert_shows(box, figures[0], 7)
    box.leave(1)
    box.come()
    assert_shows(box, figures[0], 7)
    assert_no_space_left(box, lambda wide: min(560, wide - 80 + 70), 50)


# ---- colours, and room ----


@on_a_desktop
def test_a_live_figure_follows_the_theme_and_back(visit, figures):
    box = Box(visit, 0)
    drawn = "live => live.data[2].line.color + ' ' + live._fullLayout.font.color + ' ' + live._fullLayout.plot_bgcolor"
    light = box.live.evaluate(drawn)
    assert light.split() == ["#b2182b", "#222222", "white"]
    box.ranges.focus()
    box.keyboard.press("End")
    visit.page.evaluate("document.documentElement.dataset.theme = 'dark'")
    box.wait_for(drawn, "#f2667a #e7eaee #1b1f24")
    assert_shows(box, figures[0], 20)  # drawn anew, and not from the beginning
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
