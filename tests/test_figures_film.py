"""Films in a page: the script moves the bodies as their poses say."""

import numpy as np
import pytest
from films import Film
from helpers import FIGURE, stored
from nbformat.v4 import new_markdown_cell
from numpy.testing import assert_allclose
from site_notebooks import cell, output, write
from site_visits import Visit
from sphinx_builds import build

from course_lib import rigid
from course_lib.arms import iiwa14
from course_lib.figures import poe_kuka_iiwa
from course_lib.trajectory import Trajectory

ARM = iiwa14()
TIMES = np.linspace(0, 2, 21)
Q = np.array([0.3, 0.5, 0, -1.3, 0, 0.9, 0]) + np.linspace(0, 1, 21)[:, None] * [1, 0.4, 0.2, 0.5, 1, -0.3, 2]


# ---- in a page ----


@pytest.fixture(scope="module")
def figure():
    return stored(poe_kuka_iiwa.arm_movie(ARM, Trajectory(TIMES, Q, 0 * Q)))


@pytest.fixture(scope="module")
def page(figure, tmp_path_factory):
    folder = tmp_path_factory.mktemp("film")
    shown = cell(output({FIGURE: figure, "text/plain": "The arm swings"}))
    write(folder / "notebooks", "01.ipynb", new_markdown_cell("# Film"), shown, new_markdown_cell("Words. " * 1500))
    build(folder / "notebooks", folder / "html")
    return folder / "html/01.html"


@pytest.fixture(scope="module")
def visit(page, browser):
    """A visit to the film on a phone; neither test needs what the other one does."""
    with Visit(browser, page, width=390) as visit:
        yield visit
        assert visit.complaints == []
        assert all(url.startswith(("file:", "data:", "blob:")) for url in visit.requests)


DRAWN = "([live, trace]) => ['x', 'y', 'z'].map((c) => Array.from(live.data[trace][c]))"


def drawn(visit, film):
    """The vertices (n, 3) that plotly has, in metres."""
    live = visit.page.locator(".plotly-live").first.element_handle()
    return np.transpose(visit.page.evaluate(DRAWN, [live, film.course["trace"]])) / 1000


def test_the_range_moves_the_bodies_between_their_poses_and_reduced_motion_stands_still(visit, figure):
    film = Film(figure)
    box = visit.page.locator(".plotly-figure").first
    box.scroll_into_view_if_needed()
    bar = box.get_by_role("slider", name="Time")
    bar.wait_for()
    box.get_by_role("button", name="Play").wait_for()
    assert_allclose(drawn(visit, film), film.at(0), atol=1e-3)
    bar.focus()
    for _ in range(5):  # 0.05 s, in the middle between two of the poses that the film holds
        visit.page.keyboard.press("ArrowRight")
    assert bar.get_attribute("aria-valuetext") == "0.05 seconds"
    visit.page.wait_for_function("() => window.course && !document.querySelector('.plotly-live')._transitioning")
    relative = rigid.inverse(film.poses[0]) @ film.poses[1]
    middle = film.poses[0] @ rigid.exp_se3(0.5 * rigid.log_se3(relative))
    expected = np.concatenate([b @ T[:3, :3].T + T[:3, 3] for T, b in zip(middle, film.bodies, strict=True)])
    live = visit.page.locator(".plotly-live").first.element_handle()
    near = "([live, k, x]) => Math.abs(live.data[k].x[live.data[k].x.length - 1] - x) < 0.5"
    visit.page.wait_for_function(near, arg=[live, film.course["trace"], 1000 * expected[-1, 0]])
    assert_allclose(drawn(visit, film), expected, atol=1e-3)


def test_play_moves_it_and_pause_holds_it(visit, figure):
    film = Film(figure)
    box = visit.page.locator(".plotly-figure").first
    box.scroll_into_view_if_needed()
    box.get_by_role("button", name="Play").click()
    moved = "([live, k, x]) => Math.abs(live.data[k].x[live.data[k].x.length - 1] - x) > 5"
    live = visit.page.locator(".plotly-live").first.element_handle()
    visit.page.wait_for_function(moved, arg=[live, film.course["trace"], 1000 * film.at(0)[-1, 0]])
    slider = box.get_by_role("slider").element_handle()
    visit.page.wait_for_function("slider => parseFloat(slider.ariaValueText) > 0", arg=slider)
    box.get_by_role("button", name="Pause").click()
    box.get_by_role("button", name="Play").wait_for()
    later = "() => new Promise((done) => setTimeout(() => requestAnimationFrame(() => done()), 100))"
    visit.page.evaluate(later)  # what was begun before the click is drawn
    at = box.get_by_role("slider").get_attribute("aria-valuetext")
    assert 0 <= float(at.split()[0]) <= 2  # on a busy machine it may have begun again
    held = drawn(visit, film)
    visit.page.evaluate(later)
    assert box.get_by_role("slider").get_attribute("aria-valuetext") == at
    assert_allclose(drawn(visit, film), held)
