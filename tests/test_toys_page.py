"""Toys on an exported page: moved by keyboard and pointer, offline, wide and narrow, in both themes."""

import re

import numpy as np
import pytest
from helpers import FIGURE, stored
from loaded_sphinx import build
from nbformat.v4 import new_markdown_cell
from playwright.sync_api import expect
from site_notebooks import cell, output, write
from site_visits import CONTRAST, PATIENCE, Visit, violations

from course_lib import figures
from course_lib.arms import iiwa14

TOYS = {name: getattr(figures, name) for name in figures._TOYS if name != "jog"}
TOYS["jog"] = lambda: figures.jog(iiwa14())
TOYS |= {mode: lambda mode=mode: figures.orientation_toy(mode) for mode in ("gimbals", "order", "belt")}


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    folder = tmp_path_factory.mktemp("toys")
    cells = [new_markdown_cell("# Toys")]
    for i, make in enumerate(TOYS.values()):
        toy = make()
        cells += [new_markdown_cell(f"## {i}"), cell(output({FIGURE: stored(toy.figure), "text/plain": toy.alt}))]
    write(folder / "notebooks", "01.ipynb", *cells)
    build(folder / "notebooks", folder / "html")
    return folder / "html/01.html"


@pytest.fixture(scope="module", params=[(1280, "light"), (390, "dark")], ids=["desktop", "phone"])
def visit(page, browser, request):
    width, theme = request.param
    with Visit(browser, page, width=width, theme=theme) as visit:
        yield visit
        assert visit.complaints == []
        assert [url for url in visit.requests if not url.startswith(("file:", "data:", "blob:"))] == []
        assert not visit.page.evaluate("document.documentElement.scrollWidth > innerWidth")


def come(visit, name):
    box = visit.page.locator(".plotly-figure").nth(list(TOYS).index(name))
    toy, seen = box.locator(".course-toy"), []

    def stays():  # toys before it take room when they come, which may push it away again
        box.scroll_into_view_if_needed()
        seen.append(toy.count() > 0)
        return seen[-5:] == [True] * 5

    assert comes(visit, stays)
    return box


def picture(box):
    """All that the toy shows: its drawings and its words."""
    return box.evaluate("""box => [...box.querySelectorAll("canvas")].map((c) => c.toDataURL()).join()
      + [...box.querySelectorAll("svg")].map((s) => s.outerHTML).join()
      + [...box.querySelectorAll("pre, p")].map((p) => p.textContent).join()""")


def comes(visit, condition):
    """Wait until a condition holds, for a toy draws when the browser is ready for it; return whether it ever does."""
    for _ in range(PATIENCE // 50):
        visit.page.wait_for_timeout(50)
        if condition():
            return True
    return False


def changes(visit, box, before):
    return comes(visit, lambda: picture(box) != before)


@pytest.mark.parametrize("name", TOYS)
def test_every_range_has_a_name_and_words_and_moves_the_picture_by_keyboard(visit, name):
    box = come(visit, name)
    ranges = [one for one in box.get_by_role("slider").all() if one.is_enabled()]
    assert ranges
    narrow = visit.page.viewport_size["width"] < 500
    for one in ranges[:1] if narrow else ranges:
        assert one.evaluate("e => e.labels[0].textContent.trim()")
        words, before = one.get_attribute("aria-valuetext"), picture(box)
        one.focus()
        low = float(one.input_value()) < float(one.get_attribute("max"))
        for _ in range(3):
            visit.page.keyboard.press("ArrowRight" if low else "ArrowLeft")
        assert changes(visit, box, before), words
        assert one.get_attribute("aria-valuetext") != words


@pytest.mark.parametrize("name", ["two_poses_toy", "planar_arm_toy", "cells_toy", "bent_arm_toy"])
def test_every_handle_follows_arrow_keys_and_pointer(visit, name):
    box = come(visit, name)
    for handle in box.locator(".handle").all():
        label = handle.get_attribute("aria-label")
        handle.focus()
        visit.page.keyboard.press("ArrowUp")
        visit.page.keyboard.press("Shift+ArrowUp")
        expect(handle).not_to_have_attribute("aria-label", label)
        label, place = handle.get_attribute("aria-label"), handle.locator("circle").last.bounding_box()
        x, y = place["x"] + place["width"] / 2, place["y"] + place["height"] / 2
        visit.page.mouse.move(x, y)
        visit.page.mouse.down()
        visit.page.mouse.move(x - 25, y + 30, steps=5)
        visit.page.mouse.up()
        expect(handle).not_to_have_attribute("aria-label", label)
        if "direction" not in label:  # that one stays at its distance
            after = handle.locator("circle").last.bounding_box()
            assert after["x"] + after["width"] / 2 == pytest.approx(x - 25, abs=3)
            assert after["y"] + after["height"] / 2 == pytest.approx(y + 30, abs=3)
        assert handle.evaluate("e => getComputedStyle(e).touchAction") == "none"


@pytest.mark.parametrize("name", ["axis", "circles_toy", "panda_toy"])
def test_arrow_keys_and_pointer_look_from_another_side(visit, name):
    box = come(visit, "orientation_toy" if name == "axis" else name)
    canvas = box.locator("canvas").first
    for move in ("ArrowLeft", "ArrowUp"):
        before = picture(box)
        canvas.focus()
        visit.page.keyboard.press(move)
        assert changes(visit, box, before)
    before, place = picture(box), canvas.bounding_box()
    visit.page.mouse.move(place["x"] + 100, place["y"] + 60)
    visit.page.mouse.down()
    visit.page.mouse.move(place["x"] + 140, place["y"] + 80, steps=4)
    visit.page.mouse.up()
    assert changes(visit, box, before)


# ---- colours ----

# From now on every canvas notes the colours of its words, and of its lines that are no grid and no seam between faces.
NOTE = """() => {
  window.noted = { words: new Set(), lines: new Set() };
  const context = CanvasRenderingContext2D.prototype, { fillText, stroke } = context;
  context.fillText = function (...a) { window.noted.words.add(this.fillStyle); fillText.apply(this, a); };
  context.stroke = function (...a) {
    if (this.lineWidth >= 1.5 && this.globalAlpha === 1) window.noted.lines.add(this.strokeStyle);
    stroke.apply(this, a);
  };
}"""
# The same of what is drawn in SVG; what separates filled cells has the colour of the ground.
DRAWN = """(box) => {
  const words = new Set(window.noted.words), lines = new Set(window.noted.lines);
  const style = (e) => getComputedStyle(e), ground = style(box.querySelector("canvas, svg")).backgroundColor;
  box.querySelectorAll("svg text").forEach((e) => words.add(style(e).fill));
  box.querySelectorAll("svg :is(path, circle)").forEach((e) => {
    if (!e.closest(".grid") && style(e).stroke !== "none" && style(e).stroke !== ground) lines.add(style(e).stroke);
  });
  return [ground, [...words], [...lines]];
}"""


STAGES = {"light": "rgb(247, 248, 250)", "dark": "rgb(20, 23, 27)"}


def contrast(visit, colour, ground):
    with_both = f"""([colour, ground]) => {{
      const there = document.createElement("p");
      there.style = `color:${{colour}};background-color:${{ground}}`;
      document.body.append(there);
      const measured = ({CONTRAST})(there);
      there.remove();
      return measured;
    }}"""
    return visit.page.evaluate(with_both, [colour, ground])


@pytest.mark.parametrize("name", TOYS)
def test_words_and_lines_stand_out_from_the_ground_of_the_theme(visit, name):
    box = come(visit, name)
    visit.page.evaluate(NOTE)
    before = picture(box)
    if box.locator("canvas").count():
        box.locator("canvas").first.focus()
        visit.page.keyboard.press("ArrowLeft")
        assert changes(visit, box, before)
    ground, words, lines = box.evaluate(DRAWN)
    assert ground == STAGES[visit.page.evaluate("document.documentElement.dataset.theme")]
    assert words or name == "belt"
    assert lines
    assert [colour for colour in words if contrast(visit, colour, ground) < 4.5] == []
    assert [colour for colour in lines if contrast(visit, colour, ground) < 3] == []
    card = box.locator(".course-toy").last
    for part in (card, card.locator("pre, button, label").first, card.locator("p").last):
        if part.count():
            assert part.evaluate(CONTRAST) > 4.5


@pytest.mark.parametrize("name", ["circles_toy", "planar_arm_toy"])
def test_a_toy_takes_the_colours_of_the_other_theme_and_stays_as_it_was_moved(visit, name):
    box = come(visit, name)
    slider = box.get_by_role("slider").first
    slider.focus()
    visit.page.keyboard.press("ArrowRight")
    value, before = slider.input_value(), picture(box)
    theme = visit.page.evaluate("document.documentElement.dataset.theme")
    for shown in ({"light": "dark", "dark": "light"}[theme], theme):
        visit.page.evaluate("(theme) => (document.documentElement.dataset.theme = theme)", shown)
        ground = STAGES[shown]
        assert comes(visit, lambda ground=ground: box.evaluate(DRAWN)[0] == ground)
        assert comes(visit, lambda shown=shown: (picture(box) == before) == (shown == theme))
        expect(slider).to_have_value(value)


# ---- what they are for ----


def put(box, label, value):
    one = box.get_by_label(label, exact=True)
    one.evaluate("(e, value) => { e.value = value; e.dispatchEvent(new Event('input')); }", value)


def test_pitch_drives_the_gimbals_into_lock(visit):
    box = come(visit, "gimbals")
    assert "Gimbal lock" not in box.locator("p[role=status]").inner_text()
    box.get_by_role("button", name="Drive into lock").click()
    expect(box.locator("p[role=status]")).to_contain_text("Gimbal lock")
    assert box.get_by_label("Pitch (middle ring)").input_value() == "90"
    before = box.locator("pre").inner_text()
    box.get_by_role("button", name="Yaw +10°, roll +10°").click()
    rows = [re.findall(r"-?\d\.\d{3}", text.split("q =")[0]) for text in (before, box.locator("pre").inner_text())]
    assert rows[0] == rows[1], "both together leave the orientation as it is"


def test_after_a_full_turn_q_is_minus_one_and_after_two_the_belt_comes_flat(visit):
    box = come(visit, "orientation_toy")
    put(box, "Angle", 360)
    expect(box.locator("p[role=status]")).to_contain_text("R is the identity again, but q is")
    assert "(-1.000, 0.000, 0.000, 0.000)" in box.locator("pre").inner_text()
    box = come(visit, "belt")
    undo = box.get_by_label("Move the box, without rotating it", exact=True)
    put(box, "Rotate the box", 360)
    assert undo.is_disabled()
    put(box, "Rotate the box", 720)
    assert undo.is_enabled()
    put(box, "Move the box, without rotating it", 100)
    expect(box.locator("p[role=status]")).to_contain_text("flat again")


def test_the_elbow_moves_and_the_gripper_stays_within_a_micrometre(visit):
    box = come(visit, "panda_toy")
    pose = box.locator("pre").inner_text()
    joints = [box.get_by_label(f"Joint {i}", exact=True) for i in range(1, 8)]

    def values():
        return [float(joint.input_value()) for joint in joints]

    before = values()
    for share in (0.0, 0.3, 1.0):
        put(box, "Elbow (gripper stays)", share)
        expect(box.locator("pre")).to_contain_text("the gripper moved by")
        assert comes(visit, lambda before=before: np.abs(np.subtract(values(), before)).max() > 3)
        words = box.locator("pre").inner_text()
        assert float(re.search(r"gripper moved by (\S+) mm", words)[1]) < 1e-3
        if share == 0.3:
            assert words.startswith(pose.split("\n\n")[0].splitlines()[0])
        before = values()


def test_steps_above_the_limit_diverge_and_steps_below_arrive(visit):
    box = come(visit, "planar_arm_toy")
    box.get_by_role("button", name="Start again").click()
    put(box, "Damping (m²)", -2)
    put(box, "Step size", 0.8)
    expect(box.locator("p[role=status]")).to_contain_text(re.compile(r"distance left \de-[78]"))
    box.get_by_role("button", name="Start again").click()
    put(box, "Step size", 2.4)
    visit.page.wait_for_timeout(200)
    assert float(re.search(r"distance left (\S+) m", box.locator("p[role=status]").inner_text())[1]) > 0.01


def test_another_step_size_is_tried_from_the_first_configuration_though_the_arm_has_arrived(visit):
    box = come(visit, "planar_arm_toy")
    put(box, "Damping (m²)", -2)
    status = box.locator("p[role=status]")
    for size in (0.8, 0.9):
        put(box, "Step size", size)
        expect(status).to_contain_text(re.compile(r"distance left \de-[78]"))
        assert int(status.inner_text().split()[0]) > 5


def test_smaller_steps_dock_and_larger_ones_miss(visit):
    box = come(visit, "dead_reckoning_toy")
    put(box, "Step dt", 0)
    assert "Docking needs" in box.locator("p[role=status]").inner_text()
    put(box, "Step dt", -2)
    assert "Close enough to dock" in box.locator("p[role=status]").inner_text()


def test_circles_meet_touch_and_miss(visit):
    box = come(visit, "circles_toy")
    for p, q, said in ((50, 45, "twice"), (30, 40, "touch"), (20, 20, "farther apart"), (100, 20, "inside the other")):
        put(box, "Between the axes k1, k2", 70)
        put(box, "From k1 to p1", p)
        put(box, "From k2 to p2", q)
        expect(box.locator("p[role=status]")).to_contain_text(said)


def test_at_the_edge_a_higher_degree_helps_the_square_of_the_bend_only(visit):
    box = come(visit, "bent_arm_toy")
    put(box, "Distance r", 1.95)
    off = []
    for degree in (1, 3):
        put(box, "Degree", degree)
        off.append([float(x) for x in re.findall(r"(\S+)° off", box.locator("pre").inner_text())])
    assert "touches the edge" in box.locator("p[role=status]").inner_text()
    (line, line_of_square), (cubic, cubic_of_square) = off
    assert cubic > 0.3 * line
    assert cubic_of_square < 0.1 * line_of_square
    picture_before = picture(box)
    box.get_by_role("button", name="Other elbow").click()
    assert changes(visit, box, picture_before)
    assert "q2 = -" in box.locator("p[role=status]").inner_text()
    box.get_by_role("button", name="Other elbow").click()


def test_every_toy_is_accessible(visit):
    """One after the other, because a page lets go of toys that are far from the screen."""
    for name in TOYS:
        come(visit, name)
        assert violations(visit, within=".course-toy") == [], name
