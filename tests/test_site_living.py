"""The robot on the home page: a still picture that becomes a robot to rotate, drag and move."""

import io
import re

import numpy as np
from PIL import Image
from playwright.sync_api import expect
from site_visits import SHIFT, Visit

from course_lib.arms import panda
from course_lib.pack.site.living import START

PICTURE = "document.querySelector('.living canvas').toDataURL()"


def position(visit):
    """The position of the gripper, as the page reports it."""
    words = visit.page.locator(".living p").inner_text().replace("\N{MINUS SIGN}", "-")
    return [float(x) for x in re.findall(r"= (-?[\d.]+)", words)]


def pixels(locator):
    return np.array(Image.open(io.BytesIO(locator.screenshot())).convert("RGB"), float)


def test_the_reader_rotates_the_view_drags_the_gripper_and_moves_the_joints(course, browser):
    with Visit(browser, course / "index.html") as visit:
        canvas, sliders = visit.page.locator(".living canvas"), visit.page.locator(".living").get_by_role("slider")
        canvas.scroll_into_view_if_needed()
        T = panda().fk(START)
        assert np.allclose(position(visit), T[:3, 3] + 0.08 * T[:3, 2], atol=0.006), "that of the library"
        box, seen = canvas.bounding_box(), [visit.page.evaluate(PICTURE)]

        def drag(start, by):
            x, y = box["x"] + start[0] * box["width"], box["y"] + start[1] * box["height"]
            visit.page.mouse.move(x, y)
            visit.page.mouse.down()
            visit.page.mouse.move(x + by[0], y + by[1], steps=5)
            visit.page.mouse.up()
            visit.page.wait_for_function(f"before => {PICTURE} !== before", arg=seen[-1])
            seen.append(visit.page.evaluate(PICTURE))

        before = position(visit)
        drag((0.05, 0.1), (60, 0))
        assert position(visit) == before, "only the view"
        drag((0.05, 0.1), (-60, 0))
        place = visit.page.locator(".living .handle").bounding_box()
        drag(((place["x"] + 22 - box["x"]) / box["width"], (place["y"] + 22 - box["y"]) / box["height"]), (0, 40))
        pulled = np.subtract(position(visit), before)
        assert pulled[2] < -0.03, "downwards"
        assert sliders.count() == 4
        assert all(slider.get_attribute("aria-valuetext").endswith("°") for slider in sliders.all())
        for slider in sliders.all():
            slider.focus()
            visit.page.keyboard.press("Home")
            visit.page.wait_for_function(f"before => {PICTURE} !== before", arg=seen[-1])
            seen.append(visit.page.evaluate(PICTURE))
        canvas.focus()
        visit.page.keyboard.press("ArrowLeft")
        visit.page.wait_for_function(f"before => {PICTURE} !== before", arg=seen[-1])
        assert visit.complaints == []


def test_the_robot_replaces_its_still_picture_without_a_shift_of_the_layout(course, browser):
    with Visit(browser, course / "index.html", java_script_enabled=False) as visit:
        expect(visit.page.locator(".living img")).to_be_visible()
        still = pixels(visit.page.locator(".living img"))
    with Visit(browser, course / "index.html") as visit:
        live = pixels(visit.page.locator(".living canvas"))
        assert np.abs(np.subtract(live.shape, still.shape)).max() <= 1, "a fraction of a pixel, rounded"
        height = min(len(live), len(still))
        assert np.abs(live[:height] - still[:height]).mean() < 4, "the same robot in the same place"
        assert visit.page.evaluate(SHIFT) < 0.02
