"""Buttons and ranges of the site's figures: they take the place of plotly's own, by keyboard, and say what they set."""

import numpy as np
import pytest
from helpers import FIGURE, places, stored
from nbformat.v4 import new_markdown_cell
from numpy.testing import assert_allclose
from playwright.sync_api import expect
from site_notebooks import cell, output, write
from site_visits import Visit
from two_sliders import explorer

from course_lib.arms import planar_arm
from course_lib.figures.rigid_motion import body_movie
from course_lib.pack.site.build import build

TIMES = np.linspace(0, 1, 21)
POSES = np.stack([np.linspace(-6, 6, 21), np.linspace(-5, 2, 21), np.linspace(0, 2, 21)], -1)
ALPHAS, EPSILONS, START = np.array([0.05, 0.2, 2.8]), np.array([0.5, 2, 8]), (1, 2)
OWN = ".updatemenu-container, .updatemenu-button, .slider-container"  # what plotly draws
NAMES = ("step size alpha", "damping epsilon (m²)")

# A slider that does neither: it changes a colour. The margins at the sides are plotly's own.
STEPS = [{"label": colour, "method": "restyle", "args": [{"marker.color": colour}]} for colour in ("red", "blue")]
COLOURED = {
    "data": [{"type": "scatter", "mode": "markers", "x": [0], "y": [0]}],
    "layout": {
        "sliders": [{"steps": STEPS}],
        "height": 500,
        "margin": {"b": 180},
        "meta": {"controls": 100},
        "yaxis": {"scaleanchor": "x"},
    },
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

AXES = """live => Object.fromEntries(
  ["xaxis", "xaxis2", "xaxis3", "yaxis", "yaxis2", "yaxis3"].map((name) => [name, live._fullLayout[name].range]))"""


def explored():
    q = np.random.default_rng(1).normal(0, 0.1, (3, 3, 40, 4)).cumsum(-2)
    arms = planar_arm([1, 1, 1, 1]).frames(q)[..., :2, 3]
    return explorer(ALPHAS, EPSILONS, arms, np.array([-1.9, 1.1]), np.array([[2.5, 1.2]] * 3), START)


@pytest.fixture(scope="module")
def figures():
    return stored(body_movie("body", POSES, TIMES)["fig"]), stored(explored()), COLOURED, BESIDE


@pytest.fixture(scope="module")
def page(figures, tmp_path_factory):
    """A page with a movie, a figure of two sliders, one that is neither and one of two scenes, far from each other."""
    folder = tmp_path_factory.mktemp("controls")
    movie, two, other, beside = (cell(output({FIGURE: figure, "text/plain": "What it shows"})) for figure in figures)
    begin, *words = [new_markdown_cell(text) for text in ("# Controls", *["Words. " * 1200] * 3)]
    write(folder / "notebooks", "01.ipynb", begin, movie, words[0], two, words[1], other, words[2], beside)
    build(folder / "notebooks", folder / "html")
    return folder / "html/01.html"


@pytest.fixture(params=[1280, 390], ids=["desktop", "phone"])
def visit(page, browser, request):
    with Visit(browser, page, width=request.param) as visit:
        yield visit
        assert visit.complaints == []


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


def assert_windows(box, figure, pair):
    """Assert that windows, ranges and labels are those of a pair of step size and damping."""
    wanted = {}
    for slider, k in zip(figure["layout"]["sliders"], pair, strict=True):
        wanted |= {name.removesuffix(".range"): limits for name, limits in slider["steps"][k]["args"][0].items()}
    box.wait_for(
        "live => live._fullLayout.xaxis.range[0] + ' ' + live._fullLayout.yaxis.range[0]",
        "{} {}".format(*(f"{wanted[name][0]:.15g}" for name in ("xaxis", "yaxis"))),
    )
    axes = box.live.evaluate(AXES)
    for name, limits in wanted.items():
        assert_allclose(axes[name], limits, atol=1e-9, err_msg=name)
    for name, values, k in zip(NAMES, (ALPHAS, EPSILONS), pair, strict=True):
        bar = box.box.get_by_role("slider", name=name, exact=True)
        assert bar.input_value() == str(k)
        assert bar.get_attribute("aria-valuetext") == f"{name}: {values[k]:g}"
        assert bar.locator("xpath=../span").inner_text() == f"{name}: {values[k]:g}"


def assert_no_room_left(box, height, below):
    """Assert that nothing of plotly's own controls is there, nor the room that they stood in."""
    assert box.live.locator(OWN).count() == 0
    assert box.live.evaluate("live => live.layout.margin.b") == below
    wide = box.box.bounding_box()["width"]
    assert box.live.bounding_box()["height"] == pytest.approx(height(wide), abs=1)


# ---- a movie ----


def test_a_movie_has_one_button_and_one_range_and_no_room_for_others(visit, figures):
    box = Box(visit, 0)
    assert (box.box.get_by_role("button", name="Play").count(), box.ranges.count()) == (1, 1)
    assert_no_room_left(box, lambda wide: min(560, wide - 80 + 70), 50)
    sizes = box.live.evaluate("live => [live._fullLayout.xaxis._length, live._fullLayout.yaxis._length]")
    assert sizes[0] == pytest.approx(sizes[1], abs=1), "a square"
    assert_shows(box, figures[0], 0)


def test_the_keyboard_moves_the_range_and_the_drawing_follows(visit, figures):
    box = Box(visit, 0)
    box.ranges.focus()
    for key, i in (("ArrowRight", 1), ("ArrowRight", 2), ("End", 20), ("ArrowLeft", 19), ("Home", 0)):
        box.keyboard.press(key)
        assert_shows(box, figures[0], i)


def test_play_runs_to_the_end_and_again_and_a_touch_of_the_range_stops_it(visit, figures):
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


def test_a_movie_stands_where_it_was_left(visit, figures):
    box = Box(visit, 0)
    box.ranges.focus()
    for _ in range(7):
        box.keyboard.press("ArrowRight")
    assert_shows(box, figures[0], 7)
    box.leave(2)
    box.come()
    assert_shows(box, figures[0], 7)
    assert_no_room_left(box, lambda wide: min(560, wide - 80 + 70), 50)


# ---- two sliders ----


def test_two_sliders_become_two_ranges_with_names_and_values(visit, figures):
    box = Box(visit, 1)
    assert box.ranges.count() == 2
    assert box.box.locator(".plotly-player button").count() == 0
    assert [bar.get_attribute("aria-label") for bar in box.ranges.all()] == list(NAMES)
    assert [bar.get_attribute("max") for bar in box.ranges.all()] == ["2", "2"]
    assert_no_room_left(box, lambda wide: 600, 55)
    assert_windows(box, figures[1], START)


def test_each_range_moves_its_own_axes_and_they_work_together(visit, figures):
    box = Box(visit, 1)
    alpha, epsilon = box.ranges.all()
    i, j = START
    before = box.live.evaluate(AXES)
    alpha.focus()
    box.keyboard.press("ArrowRight")
    assert_windows(box, figures[1], (i + 1, j))
    after = box.live.evaluate(AXES)
    moved = [name for name in after if not np.allclose(after[name], before[name], atol=1e-9)]
    assert moved == ["xaxis", "xaxis2", "xaxis3"]
    box.keyboard.press("Tab")
    for key, k in (("ArrowLeft", 1), ("Home", 0), ("End", 2), ("ArrowLeft", 1)):
        box.keyboard.press(key)
        assert_windows(box, figures[1], (i + 1, k))
    box.keyboard.press("Shift+Tab")
    box.keyboard.press("Home")
    assert_windows(box, figures[1], (0, 1))
    assert epsilon.evaluate("e => document.activeElement !== e")


def test_ranges_and_windows_still_agree_when_the_figure_is_drawn_again(visit, figures):
    box = Box(visit, 1)
    alpha, epsilon = box.ranges.all()
    alpha.focus()
    box.keyboard.press("Home")
    epsilon.focus()
    box.keyboard.press("ArrowLeft")
    assert_windows(box, figures[1], (0, 1))
    box.leave(2)
    box.come()
    assert_windows(box, figures[1], (0, 1))
    alpha.focus()
    box.keyboard.press("End")
    assert_windows(box, figures[1], (2, 1))


# ---- other sliders ----


def test_a_slider_that_does_neither_stays_plotlys_own_with_its_room(visit):
    box = Box(visit, 2)
    assert box.ranges.count() == 0
    assert box.live.locator(".slider-container").count() == 1
    wide = box.box.bounding_box()["width"]
    assert box.live.evaluate("live => live.layout.margin.b") == 180
    assert box.live.bounding_box()["height"] == pytest.approx(min(500, wide - 160 + 280), abs=1), "a square, no wider"


# ---- colours, and room ----


def test_a_live_figure_takes_the_colours_of_the_theme_there_and_back(visit, figures):
    box = Box(visit, 0)
    drawn = "live => live.data[2].line.color + ' ' + live._fullLayout.font.color + ' ' + live._fullLayout.plot_bgcolor"
    light = box.live.evaluate(drawn)
    assert light.split() == ["#b2182b", "#222222", "white"]
    box.ranges.focus()
    box.keyboard.press("End")
    visit.page.evaluate("document.documentElement.dataset.theme = 'dark'")
    box.wait_for(drawn, "#f2667a #e7eaee #1b1f24")
    assert box.box.evaluate("box => getComputedStyle(box).backgroundColor") == "rgb(27, 31, 36)"
    assert_shows(box, figures[0], 20)  # drawn anew, and not from the beginning
    visit.page.evaluate("document.documentElement.dataset.theme = 'light'")
    box.wait_for(drawn, light)


def test_scenes_stand_below_each_other_on_a_phone_each_under_its_title(visit):
    box = Box(visit, 3)
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
