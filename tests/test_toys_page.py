"""Toys on an exported page, and a film: moved by keyboard and pointer, offline, wide and narrow, in
both themes."""

import re

import numpy as np
import pytest
from films import Film
from nbformat.v4 import new_markdown_cell
from numpy.testing import assert_allclose
from playwright.sync_api import expect
from site_notebooks import cell, output, write
from site_visits import CONTRAST, SETTLED, Visit, violations
from some_toys import TOYS
from sphinx_builds import build

from course_lib import rigid
from course_lib.arms import iiwa14
from course_lib.figures.solids import Part
from course_lib.figures.solids.meshes import ball
from course_lib.figures.solids.model import AMBER, PALETTE, PLAIN
from course_lib.figures.stills import TOY
from course_lib.figures.toys.film import still
from course_lib.lessons.poe_kuka_iiwa.figures import arm_movie
from course_lib.trajectory import Trajectory

GLOBE = Part(0, AMBER, ball(np.zeros(3), 1))
MINUS = "\N{MINUS SIGN}"
TALL = 12000  # pixels: the height of a window in which many toys are drawn at once


@pytest.fixture(scope="module")
def figure():
    """A film of the iiwa."""
    q = np.array([0.3, 0.5, 0, -1.3, 0, 0.9, 0]) + np.linspace(0, 1, 21)[:, None] * [
        1,
        0.4,
        0.2,
        0.5,
        1,
        -0.3,
        2,
    ]
    return arm_movie(iiwa14(), Trajectory(np.linspace(0, 2, 21), q, 0 * q))


@pytest.fixture(scope="module")
def page(figure, tmp_path_factory):
    """The page of the toys; the film is on the next one."""
    folder = tmp_path_factory.mktemp("toys")
    cells = [new_markdown_cell("# Toys")]
    for i, make in enumerate(TOYS.values()):
        toy = make()
        cells += [
            new_markdown_cell(f"## {i}"),
            cell(output({TOY: toy.stored(), "text/plain": toy.alt})),
        ]
    write(folder / "notebooks", "01.ipynb", *cells)
    film = cell(output({TOY: figure.stored(), "text/plain": figure.alt}))
    write(folder / "notebooks", "02.ipynb", new_markdown_cell("# Film"), film)
    globe = still([Part(0, PLAIN, ball(np.zeros(3), 0.1))], "A globe.", pale=[GLOBE])
    globe = cell(output({TOY: globe.stored(), "text/plain": globe.alt}))
    write(folder / "notebooks", "03.ipynb", new_markdown_cell("# Globe"), globe)
    build(folder / "notebooks", folder / "html")
    return folder / "html/01.html"


# Counts the contexts of WebGL and keeps the last; a page with the hash #none gets none.
KEPT = """{
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
    if (!kind.startsWith("webgl")) return getContext.call(this, kind, ...more);
    if (location.hash === "#none") return null;
    if (kind !== "webgl2") return getContext.call(this, kind, ...more);
    window.contexts = (window.contexts || 0) + 1;
    return (window.gl = getContext.call(this, kind, ...more));
  };
}"""


@pytest.fixture(scope="module")
def visit(page, browser):
    """The page on a desktop, in the light, with pictures of a quarter of the dots, for all are
    drawn in software."""
    with Visit(browser, None, width=1280, device_scale_factor=0.5) as visit:
        visit.page.add_init_script(KEPT)
        visit.page.set_viewport_size({"width": 1280, "height": TALL})
        visit.page.goto(page.as_uri())
        # A toy waits until it is near the window, and no window may be as tall as the page: a
        # browser paints at most 16,384 pixels of it.
        for toy in visit.page.locator(".toy-figure").all():
            toy.scroll_into_view_if_needed()
        visit.page.wait_for_function(DRAWN)
        visit.page.set_viewport_size(
            {"width": 1280, "height": 1100}
        )  # a taller one takes longer to paint
        yield from until_it_ends(visit)


@pytest.fixture(scope="module")
def phone(page, browser):
    """The page on a phone, in the dark."""
    looks = {
        "theme": "dark",
        "width": 390,
        "has_touch": True,
        "is_mobile": True,
        "device_scale_factor": 0.5,
    }
    with Visit(browser, page, **looks) as visit:
        yield from until_it_ends(visit)


# Until each toy has its height, what stands above the window grows and moves what is in it.
DRAWN = "() => !document.querySelector('.toy-figure:not(.drawn)')"


def until_it_ends(visit):
    visit.page.wait_for_function(DRAWN)
    yield visit
    assert visit.complaints == []
    assert [url for url in visit.requests if not url.startswith(("file:", "data:", "blob:"))] == []
    assert not visit.page.evaluate("document.documentElement.scrollWidth > innerWidth")


# A number that stands for all that a toy shows, its drawings and its words (FNV-1a).
PICTURE = """(box) => {
  let hash = 0x811c9dc5;
  const add = (word) => { hash = Math.imul(hash ^ word, 0x01000193); };
  for (const canvas of box.querySelectorAll("canvas")) {
    const dots = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
    new Uint32Array(dots.buffer).forEach(add);
  }
  const words = [...box.querySelectorAll(".numbers, .word, p")].map((p) => p.textContent).join();
  for (let i = 0; i < words.length; i++) add(words.charCodeAt(i));
  return hash;
}"""


def figure_of(visit, name):
    """A toy, whose picture is in the middle of the window."""
    box = visit.page.locator(".toy-figure").nth(list(TOYS).index(name))
    box.evaluate("e => (e.querySelector('canvas') ?? e).scrollIntoView({ block: 'center' })")
    return box


AT_REST = 250  # milliseconds: after a movement a toy is drawn once more, and finely


def picture(box):
    """The picture of a toy that has come to rest, for one that moves may be drawn coarsely."""
    box.page.evaluate(SETTLED, AT_REST)
    return box.evaluate(PICTURE)


def wait_until(visit, condition, box, arg=None):
    """Wait until condition(box, arg) holds in the page, for a toy draws when the browser is ready
    for it."""
    visit.page.wait_for_function(
        f"([box, arg]) => ({condition})(box, arg)", arg=[box.element_handle(), arg]
    )


def wait_for_another_picture(visit, box, before):
    wait_until(visit, f"(box, before) => ({PICTURE})(box) !== before", box, before)


@pytest.mark.parametrize("name", TOYS)
def test_every_range_is_named_and_moves_the_picture_by_keyboard(visit, name):
    box = figure_of(visit, name)
    box.evaluate("box => box.querySelectorAll('details').forEach((part) => (part.open = true))")
    ranges = box.locator("input[type=range]:enabled").all()
    assert ranges or name == "table"
    for one in ranges[::-1]:  # the first may shut others off
        label, words, room = one.evaluate(
            "e => { e.focus(); return [e.labels[0].textContent.trim(), e.ariaValueText, e.max -"
            " e.value]; }"
        )
        assert label
        if re.match("Joint [2-6]", label):  # made as the first and the last are
            continue
        before = picture(box)
        visit.page.keyboard.press("PageUp" if room > 0 else "PageDown")
        wait_for_another_picture(visit, box, before)
        assert one.get_attribute("aria-valuetext") not in (words, None)


# The drive starts again with an empty log, and its own tests begin there.
@pytest.mark.parametrize("name", [name for name in TOYS if name != "drive"])
def test_start_again_returns_to_the_first_picture(visit, name):
    box = figure_of(visit, name)
    again = box.get_by_role("button", name="Start again")
    if not box.locator("input, button, .handle").count():
        return  # nothing but the view changes
    again.click()
    first = picture(box)
    control = box.locator("input, .handle").first
    for part in box.locator("details:not([open]) > summary").all():
        part.click()
    control.focus()
    for key in ("Home", "PageUp", "ArrowUp", "Space"):
        visit.page.keyboard.press(key)
    wait_for_another_picture(visit, box, first)
    again.click()
    wait_until(visit, f"(box, first) => ({PICTURE})(box) === first", box, first)
    expect(again).to_be_focused()


HANDLES = ["axis", "two_poses_toy", "planar_arm_toy", "cells_toy", "circles_toy", "reach", "fly"]
HANDLES += ["table", "click", "gains", "step_map", "pose_errors"]
FREE = (
    "axis",
    "circles_toy",
    "fly",
    "reach",
    "table",
    "gains",
)  # on a sphere, on the axes of an ellipse, the view widens, or where the function was asked


def drag(page, x, y, dx, dy):
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + dx, y + dy, steps=5)
    page.mouse.up()


def centre(handle):
    """Where a handle is in the window."""
    place = handle.bounding_box()
    return place["x"] + place["width"] / 2, place["y"] + place["height"] / 2


@pytest.mark.parametrize("name", HANDLES)
def test_every_handle_follows_arrow_keys_and_pointer(visit, name):
    box = figure_of(visit, name)
    for handle in box.locator(".handle").all():
        label = handle.get_attribute("aria-label")
        handle.focus()
        visit.page.keyboard.press("ArrowUp")
        visit.page.keyboard.press("Shift+ArrowUp")
        if handle.get_attribute("aria-label") == label:  # a direction that points up stays as it is
            visit.page.keyboard.press("Shift+ArrowRight")
        expect(handle).not_to_have_attribute("aria-label", label)
        label, (x, y) = handle.get_attribute("aria-label"), centre(handle)
        drag(visit.page, x, y, -25, 30)
        expect(handle).not_to_have_attribute("aria-label", label)
        if "direction" not in label and name not in FREE:
            assert centre(handle) == pytest.approx((x - 25, y + 30), abs=3)


@pytest.mark.parametrize("name", HANDLES)
def test_a_finger_drags_a_handle_or_scrolls_the_page(phone, name):
    touch = phone.page.context.new_cdp_session(phone.page)

    def swipe(x, y, dx, dy):
        for k in range(9):
            kind, at = (
                "touchMove" if k else "touchStart",
                {"x": x + dx * k / 8, "y": y + dy * k / 8},
            )
            touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [at]})
            phone.page.wait_for_timeout(16)
        phone.page.wait_for_timeout(60)  # a finger that leaves at rest: the page does not scroll on
        touch.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})

    box = figure_of(phone, name)
    for handle in box.locator(".handle").all():
        handle.evaluate("e => e.closest('.course-stage').scrollIntoView({ block: 'center' })")
        (x, y), scrolled = centre(handle), phone.page.evaluate("scrollY")
        swipe(x, y, 40 if x < 195 else -40, 32)
        assert phone.page.evaluate("scrollY") == scrolled, "the handle moves, not the page"
        moved = (
            "([e, x, y], b = e.getBoundingClientRect()) => Math.hypot(b.x + 22 - x, b.y + 22 - y) "
            "> 10"
        )
        phone.page.wait_for_function(moved, arg=[handle.element_handle(), x, y])
    stage, before = (
        box.locator(".course-stage").first.bounding_box(),
        phone.page.evaluate("scrollY"),
    )
    swipe(stage["x"] + 8, stage["y"] + stage["height"] - 8, 0, -120)
    phone.page.wait_for_function("before => scrollY > before + 60", arg=before)


@pytest.mark.parametrize("name", ["axis", "circles_toy", "panda_toy"])
def test_arrow_keys_and_pointer_change_the_view(visit, name):
    box = figure_of(visit, name)
    canvas = box.locator("canvas").first
    for move in ("ArrowLeft", "ArrowUp"):
        before = picture(box)
        canvas.focus()
        visit.page.keyboard.press(move)
        wait_for_another_picture(visit, box, before)
    before, place = picture(box), canvas.bounding_box()
    drag(visit.page, place["x"] + 100, place["y"] + 60, 40, 20)
    wait_for_another_picture(visit, box, before)


@pytest.mark.parametrize("way", ["Home", "double click"])
def test_a_turned_picture_is_turned_back(visit, way):
    box = figure_of(visit, "circles_toy")
    canvas = box.locator("canvas").first
    canvas.focus()
    visit.page.keyboard.press("Home")
    at_first = picture(box)
    for key in ("ArrowLeft", "+"):
        before = picture(box)
        visit.page.keyboard.press(key)
        wait_for_another_picture(visit, box, before)
    if way == "Home":
        visit.page.keyboard.press("Home")
    else:
        canvas.dblclick(position={"x": 5, "y": 5})
    wait_until(visit, f"(box, before) => ({PICTURE})(box) === before", box, at_first)


def test_the_wheel_zooms_only_with_ctrl_or_after_a_click(visit):
    box = figure_of(visit, "circles_toy")
    canvas = box.locator("canvas").first
    visit.page.evaluate("document.activeElement.blur()")
    place = canvas.bounding_box()
    visit.page.mouse.move(place["x"] + 5, place["y"] + 5)
    before, scrolled = picture(box), visit.page.evaluate("scrollY")
    visit.page.mouse.wheel(0, 10)
    visit.page.wait_for_function("scrolled => scrollY > scrolled", arg=scrolled)
    assert picture(box) == before
    visit.page.keyboard.down("Control")
    visit.page.mouse.wheel(0, -100)
    visit.page.keyboard.up("Control")
    wait_for_another_picture(visit, box, before)
    visit.page.mouse.click(place["x"] + 5, place["y"] + 5)
    before, scrolled = picture(box), visit.page.evaluate("scrollY")
    visit.page.mouse.wheel(0, 100)
    wait_for_another_picture(visit, box, before)
    assert visit.page.evaluate("scrollY") == scrolled


@pytest.mark.parametrize(
    ("device", "words"),
    [("mouse", "A double click turns it back"), ("keys", "Home turns it back")],
)
def test_the_first_picture_says_once_how_it_is_rotated(page, browser, device, words):
    """The next picture does not say it again."""
    with Visit(browser, page) as visit:
        for name in ("circles_toy", "axis"):
            canvas = figure_of(visit, name).locator("canvas").first
            canvas.wait_for()
            if device == "mouse":
                canvas.hover(position={"x": 5, "y": 5})
            else:
                canvas.evaluate("e => e.focus()")
                visit.page.keyboard.press("Shift+Tab")
                visit.page.keyboard.press("Tab")
        expect(visit.page.locator(".hint")).to_have_count(1)
        expect(visit.page.locator(".hint")).to_contain_text(words)


# ---- the one WebGL context ----


def test_all_toys_share_one_context_and_survive_its_loss(visit):
    box = figure_of(visit, "panda_toy")
    assert visit.page.evaluate("window.contexts") == 1
    before = picture(box)
    visit.page.evaluate("window.lost = gl.getExtension('WEBGL_lose_context'), lost.loseContext()")
    visit.page.wait_for_function("gl.isContextLost()")
    put(box, "Joint 2", 10)
    visit.page.evaluate(SETTLED, 200)
    dots = "box => box.querySelector('canvas').toDataURL().length"
    assert box.evaluate(dots) > 10_000, "the last picture stays"
    visit.page.evaluate("lost.restoreContext()")
    wait_for_another_picture(visit, box, before)
    visit.page.wait_for_function("!gl.isContextLost()")


def test_a_picture_that_failed_is_drawn_when_it_returns(page, browser):
    with Visit(browser, None, java_script_enabled=True) as visit:
        visit.page.add_init_script(KEPT)
        visit.page.goto(page.as_uri() + "#none")
        plane, space = (figure_of(visit, name) for name in ("two_poses_toy", "panda_toy"))
        plane.scroll_into_view_if_needed()
        plane.locator(".course-toy").wait_for()
        space.scroll_into_view_if_needed()
        expect(space.locator(".toy-words")).to_be_visible()
        expect(space.locator(".course-toy")).to_have_count(0)
        visit.page.evaluate("location.hash = ''; scrollTo(0, 0)")
        visit.page.evaluate(SETTLED, 100)
        space.scroll_into_view_if_needed()
        expect(space.locator(".course-toy")).to_be_visible()
        assert visit.complaints == []


# ---- colours ----

# From now on every toy notes the colours of its words, and of its lines that are no grid and part
# no cells.
NOTE = """() => {
  const context = CanvasRenderingContext2D.prototype, { fillText, stroke } = context, { scene } = window.course;
  const { draw } = scene;
  const noted = ({ canvas }) =>
    (canvas.closest(".toy-figure").noted ??= { words: new Set(), lines: new Set() });
  context.fillText = function (...a) { noted(this).words.add(this.fillStyle); fillText.apply(this, a); };
  context.stroke = function (...a) {
    if (this.lineWidth >= 1.5 && this.globalAlpha === 1) noted(this).lines.add(this.strokeStyle);
    stroke.apply(this, a);
  };
  scene.draw = (context, what, redraw) => {
    what.lines.filter(({ layer }) => layer !== "floor").forEach(({ colour }) => noted(context).lines.add(colour));
    draw(context, what, redraw);
  };
}"""
STAGES = {"light": "rgb(247, 248, 250)", "dark": "rgb(20, 23, 27)"}
# Of each toy: its ground, {colour: its contrast with the ground} of the words and of the lines that
# were noted, and the least contrast of the text below the drawing.
CONTRASTS = f"""() => [...document.querySelectorAll(".toy-figure")].map((box) => {{
  const style = (e) => getComputedStyle(e), all = (part) => [...box.querySelectorAll(part)];
  const there = document.body.appendChild(document.createElement("p")), noted = box.noted ?? {{ words: [], lines: [] }};
  const ground = there.style.backgroundColor = style(box.querySelector("canvas")).backgroundColor;
  const measured = (colours) => Object.fromEntries([...colours].map((colour) => {{
    there.style.color = colour;
    return [colour, ({CONTRAST})(there)];
  }}));
  const words = measured([...all(".word").map((e) => style(e).color), ...noted.words]);
  const lines = measured(noted.lines), text = [".course-toy", ".numbers", "button", "label", "p"].flatMap(all);
  there.remove();
  box.noted = null;
  return [ground, words, lines, Math.min(...text.map({CONTRAST}))];
}})"""


def test_toys_follow_a_change_of_theme(visit):
    before = {}
    for box in (figure_of(visit, "circles_toy"), figure_of(visit, "planar_arm_toy")):
        slider, at_first = box.get_by_role("slider").first, picture(box)
        slider.focus()
        visit.page.keyboard.press("ArrowRight")
        wait_for_another_picture(visit, box, at_first)
        before[box] = slider, slider.input_value(), picture(box)
    visit.page.evaluate(NOTE)
    for theme in ("dark", "light"):
        visit.page.evaluate("(theme) => (document.documentElement.dataset.theme = theme)", theme)
        sign = "!==" if theme == "dark" else "==="
        for box, (slider, value, seen) in before.items():
            wait_until(visit, f"(box, seen) => ({PICTURE})(box) {sign} seen", box, seen)
            expect(slider).to_have_value(value)
        for name, (ground, words, lines, text) in zip(
            TOYS, visit.page.evaluate(CONTRASTS), strict=True
        ):
            assert ground == STAGES[theme], name
            assert words or name in ("belt", "reach", "eight", "fly"), name
            assert lines or name in ("belt", "panda_toy", "reach", "eight"), name
            assert {
                colour: contrast for colour, contrast in words.items() if contrast < 4.5
            } == {}, name
            faint = {colour for colour, contrast in lines.items() if contrast < 3}
            if name == "step_map":  # a black curve with a white rim: one of the two is seen
                assert not faint >= {"#000000", "#e8eaed"}
                faint -= {"#000000", "#e8eaed"}
            assert faint == set(), name
            assert text > 4.5, name


# ---- what they are for ----


def put(box, label, value):
    one = box.get_by_label(label, exact=True)
    one.evaluate("(e, value) => { e.value = value; e.dispatchEvent(new Event('input')); }", value)


SAYS = [  # what is put into a toy's ranges, and what it then says
    (
        "axis",
        {"Angle": 360},
        rf"\({MINUS}1.000, 0.000, 0.000, 0.000\).*R is the identity again, but q is",
    ),
    (
        "belt",
        {"Rotate the box": 360, "Move the box, without rotating it": 1},
        rf"\({MINUS}1.000.*changed its direction",
    ),
    ("belt", {"Rotate the box": 720, "Move the box, without rotating it": 1}, "flat again"),
    (
        "planar_arm_toy",
        {"Damping (m²)": -2, "Step size": 0.8},
        r"(?<!\d)([6-9]|\d\d) steps, distance left \d·10⁻[⁷⁸]",
    ),
    ("planar_arm_toy", {"Damping (m²)": -2, "Step size": 4}, r"200 steps, distance left (?!\d·10)"),
    ("wheels", {"Left wheel": -0.4, "Right wheel": 0.4}, "pole is the robot's middle"),
    ("wheels", {"Left wheel": 0.4, "Right wheel": 0.4}, "drives straight ahead. There is no pole"),
    ("wheels", {"Left wheel": 0.35, "Right wheel": 0.4}, "1.50 m to the left .* outside the pict"),
    ("wheels", {"Left wheel": 0.4, "Right wheel": 0.2}, "clockwise .* 0.30 m to the right of"),
    ("step_map", {"Steps": 0}, r"from the target after 0 steps"),
    ("step_map", {"Steps": 1}, r"from the target after 1 step\."),
    ("pose_errors", {"Rotate the target": 0}, r"0.65 m \(space\), 0.65 m \(body\) and 0.65 m"),
    ("pose_errors", {"Rotate the target": 90}, r"0.65 m \(geometric\)"),
    ("drive", {"Step dt": 0}, r"is \d{2,} cm and"),
    ("drive", {"Step dt": -2}, r"is \d\.\d cm and"),
    (
        "circles_toy",
        {"Between the axes k₁, k₂": 70, "From k₁ to p₁": 50, "From k₂ to p₂": 45},
        "twice",
    ),
    (
        "circles_toy",
        {"Between the axes k₁, k₂": 70, "From k₁ to p₁": 20, "From k₂ to p₂": 20},
        "farther apart",
    ),
    (
        "circles_toy",
        {"Between the axes k₁, k₂": 70, "From k₁ to p₁": 100, "From k₂ to p₂": 20},
        "inside the other",
    ),
    (
        "circles_toy",
        {"Between the axes k₁, k₂": 70, "From k₁ to p₁": 30, "From k₂ to p₂": 40},
        "touch: one solution",
    ),
    (
        "circles_toy",
        {"Between the axes k₁, k₂": 70, "From k₁ to p₁": 0, "From k₂ to p₂": 70},
        "1: θ₁ = any angle, θ₂ = .*infinitely many solutions, because θ₁ is free",
    ),
    (
        "circles_toy",
        {"Between the axes k₁, k₂": 70, "From k₁ to p₁": 110, "From k₂ to p₂": 180},
        "θ₂ = any angle.*infinitely many solutions, because θ₂ is free",
    ),
]


@pytest.mark.parametrize(("name", "values", "says"), SAYS)
def test_a_toy_says_what_it_computes(visit, name, values, says):
    box = figure_of(visit, name)
    for label, value in values.items():
        put(box, label, value)
    expect(box.locator(".controls")).to_contain_text(re.compile(says))


# What reaches the goal of a toy, and what nearly does.
GOALS = [
    (
        "axis",
        {"Axis: azimuth": 90, "Axis: elevation": 0, "Angle": -90},
        {"Angle": -86},
    ),
    ("wheels", {"Left wheel": -0.3, "Right wheel": -0.1}, {"Left wheel": 0.3, "Right wheel": 0.1}),
    (
        "circles_toy",
        {"Between the axes k₁, k₂": 20, "From k₁ to p₁": 60, "From k₂ to p₂": 40},
        {"From k₁ to p₁": 61},
    ),
    ("planar_arm_toy", {"Damping (m²)": -2, "Step size": 1}, {"Damping (m²)": 0}),
]


def goal_of(box):
    return box.locator("p[role=status]", has_text=re.compile("^(Goal|✓ Reached): "))


@pytest.mark.parametrize(("name", "there", "nearly"), GOALS)
def test_a_goal_is_ticked_when_it_is_reached_and_not_before(visit, name, there, nearly):
    box = figure_of(visit, name)
    box.get_by_role("button", name="Start again").click()
    before = picture(box)
    for label, value in (there | nearly).items():
        put(box, label, value)
    wait_for_another_picture(visit, box, before)
    visit.page.evaluate(SETTLED, 200)
    expect(goal_of(box)).to_have_text(re.compile("^Goal: "))
    for label, value in there.items():
        put(box, label, value)
    expect(goal_of(box)).to_have_text(re.compile("^✓ Reached: "))


def test_a_goal_that_was_reached_stays_ticked_until_the_toy_starts_again(visit):
    box = figure_of(visit, "wheels")
    for label, value in GOALS[1][1].items():
        put(box, label, value)
    expect(goal_of(box)).to_have_text(re.compile("^✓"))
    put(box, "Right wheel", 0.5)
    expect(box.locator(".controls")).to_contain_text("to the left of its middle")
    expect(goal_of(box)).to_have_text(re.compile("^✓"))
    box.get_by_role("button", name="Start again").click()
    expect(goal_of(box)).to_have_text(re.compile("^Goal"))


def test_the_goal_of_the_cells_is_a_query_that_large_cells_miss(visit):
    box = figure_of(visit, "cells_toy")
    box.get_by_role("button", name="Start again").click()
    handle = box.locator(".handle")
    x, y = centre(handle)
    metre = box.locator("canvas").first.bounding_box()["width"] / 5.2
    drag(visit.page, x, y, -1.7 * metre, -0.2 * metre)
    expect(box.locator(".numbers")).to_contain_text("from the query")
    expect(goal_of(box)).to_have_text(re.compile("^Goal"))
    put(box, "Cell size", 0)
    expect(goal_of(box)).to_have_text(re.compile("^✓"))


GAINS = r"along u{0}: 1/s{0} = (\S+) rad/m, damped (\S+) rad/m, which removes (\d+) %"


@pytest.mark.parametrize("log_damping", [-3, 0, 1.3])
def test_damped_steps_follow_from_the_singular_values_shown(visit, log_damping):
    box = figure_of(visit, "gains")
    before = picture(box)
    put(box, "Damping ε", log_damping)
    wait_for_another_picture(visit, box, before)
    visit.page.evaluate(SETTLED, 0)
    words = box.locator(".controls").inner_text()
    damping = 10**log_damping
    for index in "₁₂":
        undamped, damped, percent = map(float, re.search(GAINS.format(index), words).groups())
        s = 1 / undamped
        assert damped == pytest.approx(s / (s**2 + damping), abs=0.02), words
        assert percent == pytest.approx(100 * s**2 / (s**2 + damping), abs=2), words
    assert re.search(r"damped step, red, is \d\.\d+ rad .* undamped .* \d\.\d+ rad", words), words


def test_pitch_drives_the_gimbals_into_lock(visit):
    box = figure_of(visit, "gimbals")
    assert "Gimbal lock" not in box.locator("p[role=status]").inner_text()
    for sign, counts in (("+", f"difference roll {MINUS} yaw"), (MINUS, "sum roll + yaw")):
        box.get_by_role("button", name=f"Drive to {sign}90°").click()
        expect(box.locator("p[role=status]")).to_contain_text(
            re.compile(f"Gimbal lock.*{re.escape(counts)}")
        )
        before, yaw = (
            box.locator(".matrix").get_attribute("aria-label"),
            box.get_by_label("Yaw (outer ring, about z)"),
        )
        angle = yaw.input_value()
        box.get_by_role("button", name=f"Yaw +10°, roll {sign}10°").click()
        expect(yaw).not_to_have_value(angle)
        assert box.locator(".matrix").get_attribute("aria-label") == before, "the orientation stays"
        expect(box.locator(".word", has_text="lost")).to_be_visible()


def test_a_belt_can_be_moved_only_after_full_rotations(visit):
    box = figure_of(visit, "belt")
    move = box.get_by_label("Move the box, without rotating it", exact=True)
    put(box, "Rotate the box", 180)
    expect(move).to_be_disabled()
    put(box, "Rotate the box", 360)
    expect(move).to_be_enabled()


# The joint angles that a toy's ranges show, in degrees.
JOINTS = """(box) => [...box.querySelectorAll("input[type=range]")]
  .filter((e) => /^Joint \\d/.test(e.labels[0].textContent.trim())).map((e) => Number(e.value))"""


def test_the_flange_stays_while_the_elbow_moves(visit):
    """The flange stays within a micrometre."""
    box = figure_of(visit, "panda_toy")
    pose = box.locator(".matrix").get_attribute("aria-label")
    before = box.evaluate(JOINTS)
    assert len(before) == 7
    for share in (0.0, 0.3, 1.0):
        put(box, "Elbow (flange stays)", share)
        expect(box.locator(".numbers")).to_contain_text("the flange moved by")
        moved = (
            f"(box, before) => ({JOINTS})(box).some((angle, i) => Math.abs(angle - before[i]) > 3)"
        )
        wait_until(visit, moved, box, before)
        words = box.locator(".numbers").inner_text()
        assert float(re.search(r"flange moved by (\S+) mm", words)[1]) < 1e-3
        assert box.locator(".matrix").get_attribute("aria-label") == pose
        before = box.evaluate(JOINTS)


def test_each_toy_names_its_pose_as_its_notebook_does(visit):
    for name, pose in (("panda_toy", "T0f"), ("jog", "Tsb")):
        expect(figure_of(visit, name).locator(".numbers")).to_contain_text(f"{pose} =")


def test_a_click_on_the_map_chooses_the_run(visit):
    box = figure_of(visit, "step_map")
    put(box, "Steps", 30)
    said = box.locator("p[role=status]")
    place = box.locator("canvas").first.bounding_box()
    answers = [said.inner_text()]
    for across in (0.75, 0.95):
        x = place["x"] + across * place["width"]
        visit.page.mouse.click(x, place["y"] + 0.75 * place["height"])
        expect(said).not_to_have_text(answers[-1])
        answers.append(said.inner_text())
    del answers[0]
    sizes = [float(re.search(r"α = (\S+)", words)[1]) for words in answers]
    assert sizes[0] < 2 < sizes[1]
    left = [float(re.search(r"tip is (\d+\.\d+|\d)", words)[1]) for words in answers]
    assert left[1] > 0.1, "steps that are too large leave the tip away from its target"
    assert "10" in answers[0], "a small distance is written as a power of ten"


def test_a_drag_across_a_chart_moves_the_time_of_all_of_them(visit):
    box = figure_of(visit, "velocities")
    time, numbers = box.get_by_role("slider", name="Time"), box.locator(".numbers")
    for chart, pixels in ((1, 60), (2, 120)):  # to two places: the numbers are others each time
        put(box, "Time", 0)
        before = numbers.inner_text()
        place = box.locator("canvas").nth(chart).bounding_box()
        drag(visit.page, place["x"] + 100, place["y"] + 40, pixels, 0)
        across = (100 + pixels - 48) / (place["width"] - 64)  # 48 and 16 pixels are margins
        visit.page.wait_for_function(
            "([time, seconds]) => Math.abs(time.value - seconds) < 0.03",
            arg=[time.element_handle(), 2 * across],
        )
        expect(numbers).not_to_have_text(before)


def test_a_click_on_a_dot_shows_the_arm_that_made_it(visit):
    box = figure_of(visit, "errors")
    rank = box.get_by_role("slider", name="Query, by the size of its error")
    put(box, "Query, by the size of its error", 20)
    said = box.locator("p[role=status]")
    before = said.inner_text()
    place = box.locator("canvas").bounding_box()
    visit.page.mouse.click(place["x"] + 0.8 * place["width"], place["y"] + 0.3 * place["height"])
    expect(said).not_to_have_text(before)
    number = int(rank.input_value())
    chosen = said.inner_text()
    put(box, "Query, by the size of its error", number + 1)
    expect(said).not_to_have_text(chosen)
    put(box, "Query, by the size of its error", number)
    expect(said).to_have_text(chosen)


def test_the_ranks_of_queries_fall_with_their_errors(visit):
    box = figure_of(visit, "errors")
    said = box.locator("p[role=status]")
    found = []
    for rank in (1, 2, 10, 30):
        put(box, "Query, by the size of its error", rank)
        visit.page.evaluate(SETTLED, 100)
        found.append(
            float(re.search(r"better answer misses it by ([\d.]+) cm", said.inner_text())[1])
        )
    assert found == sorted(found, reverse=True)


def test_dead_reckoning_follows_the_driven_robot(visit):
    box = figure_of(visit, "drive")
    status = box.locator("p[role=status]")
    box.get_by_role("button", name="Start again").click()
    put(box, "Step dt", -0.3)  # half a second
    expect(status).to_contain_text("0.0 cm and 0° off")
    left, ahead = (box.get_by_role("button", name=name, exact=True) for name in ("Left", "Ahead"))
    ahead.press(
        "Enter"
    )  # half a second: on a straight line Euler's method is right, and on the spot
    left.press("Enter")
    expect(status).to_contain_text("0.0 cm and 0° off")
    x, y = centre(ahead)
    visit.page.mouse.move(x, y)
    before = picture(box)
    visit.page.mouse.down()
    wait_for_another_picture(visit, box, before)
    visit.page.mouse.up()
    before = picture(box)
    assert picture(box) == before, "it stops when the button is released"
    box.locator("canvas").focus()
    for key in ("ArrowUp", "ArrowRight"):
        visit.page.keyboard.down(key)
    expect(status).to_contain_text(re.compile(r"is [1-9]\S* cm and \S+° off"))
    for key in ("ArrowUp", "ArrowRight"):
        visit.page.keyboard.up(key)
    box.get_by_label("Hide the robot").check()
    expect(status).to_contain_text("Drive the red robot to the dock")
    box.get_by_label("Hide the robot").uncheck()


@pytest.mark.parametrize("control", ["Start again", "Hide the robot", "Left"])
def test_arrow_keys_drive_after_a_control_was_clicked(visit, control):
    """They do not scroll the page."""
    box = figure_of(visit, "drive")
    box.get_by_role("button", name="Start again").click()
    button, checkbox = (
        box.get_by_role(role, name=control, exact=True) for role in ("button", "checkbox")
    )
    button.or_(checkbox).click()
    before, scrolled = picture(box), visit.page.evaluate("scrollY")
    for key in ("ArrowUp", "ArrowDown"):
        visit.page.keyboard.down(key)
        wait_for_another_picture(visit, box, before)
        visit.page.keyboard.up(key)
        before = picture(box)
    assert visit.page.evaluate("scrollY") == scrolled
    if control == "Hide the robot":
        checkbox.uncheck()


def test_a_range_of_the_drive_keeps_its_arrow_keys(visit):
    box = figure_of(visit, "drive")
    put(box, "Step dt", -1)
    box.get_by_label("Step dt").focus()
    visit.page.keyboard.press("ArrowRight")
    expect(box.get_by_label("Step dt")).to_have_value("-0.9")


def test_a_click_that_is_5_mm_off_raises_the_residual(visit):
    box = figure_of(visit, "click")
    words = box.locator("p[role=status]")
    box.get_by_role("button", name="Start again").click()
    put(box, "Point to click, 0 to 6", 2)

    def said():
        return [float(x) for x in re.findall(r"[\d.]+(?= mm)", words.inner_text())]

    expect(words).to_contain_text(
        re.compile(r"Residual [01]\.\d mm .* is [01]\.\d mm from the mug")
    )
    handle, at_first, before = box.locator(".handle").nth(1), said(), picture(box)
    handle.focus()
    for _ in range(2):  # 10 pixels: at 0.6 m about 5 mm
        visit.page.keyboard.press("Shift+ArrowRight")
    wait_for_another_picture(visit, box, before)
    visit.page.evaluate(SETTLED, 0)  # for the second key
    off = said()
    assert off[0] > at_first[0] + 0.8
    assert off[1] > at_first[1] + 0.4
    x, y = centre(handle)
    visit.page.mouse.click(
        x - 8, y
    )  # clicked, not dragged: also where the handle covers the picture
    expect(words).not_to_contain_text(f"Residual {off[0]} mm")
    assert centre(handle)[0] == pytest.approx(x - 8, abs=1)
    other = box.locator("canvas").first.bounding_box()
    visit.page.mouse.click(other["x"] + 60, other["y"] + 60)
    expect(box.get_by_label("Point to click, 0 to 6")).to_have_value(
        "0"
    )  # both are clicked: the next that is not


@pytest.mark.parametrize("name", HANDLES)
def test_a_handle_is_named_by_few_numbers(visit, name):
    for handle in figure_of(visit, name).locator(".handle").all():
        label = handle.get_attribute("aria-label")
        assert len(re.findall(r"[\d.]+", label)) <= 4, label


def test_the_handles_say_where_nose_and_wing_point(visit):
    box = figure_of(visit, "fly")
    nose, wing = (box.get_by_label(re.compile(f"^Start, {part}")) for part in ("nose", "wing"))
    vectors = [
        [float(x.replace(MINUS, "-")) for x in re.findall(rf"{MINUS}?[\d.]+", label)]
        for label in (nose.get_attribute("aria-label"), wing.get_attribute("aria-label"))
    ]
    assert_allclose(np.linalg.norm(vectors, axis=1), 1, atol=0.02)
    assert_allclose(np.dot(*vectors), 0, atol=0.02)


def test_picture_controls_and_numbers_are_in_view_together(visit, phone):
    for page in (visit.page, phone.page):
        page.evaluate(
            "document.querySelectorAll('.course-toy details').forEach((part) => (part.open = "
            "false))"
        )
        page.evaluate(SETTLED, 200)
        heights = page.evaluate(
            "[...document.querySelectorAll('.course-toy')].map((toy) => toy.offsetHeight)"
        )
        assert {name: high for name, high in zip(TOYS, heights, strict=True) if high > 640} == {}


def test_on_a_phone_the_planar_arm_is_larger_than_its_chart(phone):
    box = figure_of(phone, "planar_arm_toy")
    arm, chart = (canvas.bounding_box() for canvas in box.locator("canvas").all())
    assert arm["width"] == chart["width"]
    assert arm["y"] + arm["height"] <= chart["y"]
    assert chart["height"] >= 130
    assert arm["height"] > 1.5 * chart["height"]  # its goal and its words take the rest of a window


@pytest.mark.parametrize("name", ["iiwa_toy", "panda_toy", "jog"])
def test_opening_the_joint_angles_keeps_the_picture_s_height(visit, name):
    box = figure_of(visit, name)
    canvas, fold = box.locator("canvas").first, box.locator("details").first
    heights = []
    for is_open in (False, True, False):
        fold.evaluate("(part, open) => (part.open = open)", is_open)
        put(box, "Joint 2", 10 + len(heights))  # it is drawn anew
        visit.page.evaluate(SETTLED, 200)
        heights.append(canvas.bounding_box()["height"])
    assert heights[1:] == heights[:1] * 2


def test_every_toy_is_accessible(visit, phone):
    assert violations(visit, within=".course-toy") == []
    assert violations(phone, within=".course-toy") == []


SETTINGS = """(box) => Object.fromEntries([...box.querySelectorAll(".setting")]
  .map((row) => [row.querySelector("label").textContent, row.querySelector("output").textContent]))"""


@pytest.mark.parametrize(
    ("name", "moved"), [("jog", "Joint"), ("gimbals", "Yaw"), ("belt", "Rotate")]
)
def test_a_dragged_body_rotates_about_its_joint_only(visit, name, moved):
    box = figure_of(visit, name)
    if name == "belt":
        put(box, "Rotate the box", 180)
    canvas = box.locator("canvas").first
    place, grabs = canvas.bounding_box(), []
    for share in np.arange(
        0.3, 0.86, 0.08
    ):  # of the picture's width and height: where the pointer is above a body
        for high in (0.35, 0.5, 0.65):
            x, y = place["x"] + share * place["width"], place["y"] + high * place["height"]
            visit.page.mouse.move(x, y)
            visit.page.evaluate(SETTLED, 0)
            grabs += [(x, y)] if canvas.evaluate("e => e.style.cursor") == "grab" else []
    changed = set()
    for x, y in grabs[::2]:
        before = box.evaluate(SETTINGS)
        drag(visit.page, x, y, 25, -20)
        visit.page.evaluate(SETTLED, 0)
        now = box.evaluate(SETTINGS)
        other = {label for label in now if now[label] != before[label]}
        assert len(other) <= 1
        changed |= other
    assert changed
    assert all(label.startswith(moved) or name == "gimbals" for label in changed)


def test_the_library_follows_each_of_several_solutions(visit):
    box = figure_of(visit, "eight")
    for axis in "zyx":
        put(box, f"Rotate about {axis}", 0)
    expect(box.locator("p[role=status]")).to_contain_text("8 solutions")
    before = box.locator(".numbers").inner_text()
    box.get_by_label("Rotate about z").first.focus()
    visit.page.keyboard.press("ArrowRight")
    wait_until(
        visit, "(box, before) => box.querySelector('.numbers').innerText !== before", box, before
    )
    assert "8 solutions" in box.inner_text()
    assert box.locator(".numbers > div").count() == 8
    assert "from the target" not in box.locator(".numbers").inner_text(), "all eight reach it"


def test_fast_moves_leave_all_angles_within_half_a_revolution(visit):
    box = figure_of(visit, "eight")
    for value in (-180, 170, -90, 120, 0):
        for axis in "zyx":
            put(box, f"Rotate about {axis}", value)
    visit.page.evaluate(SETTLED, 100)
    numbers = box.locator(".numbers").inner_text().replace(MINUS, "-")
    degrees = [abs(int(angle)) for angle in re.findall(r"-?\d+(?=°)", numbers)]
    assert len(degrees) == 48
    assert max(degrees) <= 180


def test_all_solutions_return_after_a_target_out_of_reach(visit):
    box = figure_of(visit, "eight")
    says = box.locator("p[role=status]")
    expect(says).to_contain_text("8 solutions")
    box.locator(".handle").first.focus()
    count = 0
    while "Out of reach" not in says.inner_text():
        count += 1
        assert count < 60
        visit.page.keyboard.press("Shift+ArrowRight")
        visit.page.evaluate(SETTLED, 0)
    for _ in range(count):
        visit.page.keyboard.press("Shift+ArrowLeft")
        visit.page.evaluate(SETTLED, 0)
    expect(says).to_contain_text("8 solutions")
    assert box.locator(".numbers > div").count() == 8


HEIGHT = "(box) => box.querySelector('.course-toy').offsetHeight"
CHANGING = [  # ranges after which a toy says more, or shows fewer lines
    ("gimbals", {"Pitch (middle ring)": 90}),
    ("axis", {"Angle": 0}),
    ("belt", {"Rotate the box": 720}),
    ("circles_toy", {"From k₁ to p₁": 0, "From k₂ to p₂": 0}),
    (
        "circles_toy",
        {"Between the axes k₁, k₂": 70, "From k₁ to p₁": 0, "From k₂ to p₂": 70},
    ),
    ("eight", {"Rotate about z": 90}),
    ("wheels", {"Left wheel": 0.4, "Right wheel": 0.4}),
    ("wheels", {"Left wheel": -0.35, "Right wheel": -0.4}),
    ("eight", {"Rotate about y": 120, "Rotate about x": 60}),
]


@pytest.mark.parametrize(("name", "values"), CHANGING)
@pytest.mark.parametrize("wide", [True, False], ids=["desktop", "phone"])
def test_the_height_of_a_toy_stays_whatever_it_says(visit, phone, name, values, wide):
    here = visit if wide else phone
    box = figure_of(here, name)
    at_first = {label: box.get_by_label(label, exact=True).input_value() for label in values}
    before, words = box.evaluate(HEIGHT), box.locator(".controls").inner_text()
    for label, value in values.items():
        put(box, label, value)
    here.page.evaluate(SETTLED, 200)
    changed, after = box.locator(".controls").inner_text(), box.evaluate(HEIGHT)
    for label, value in at_first.items():
        put(box, label, value)
    assert changed != words
    assert after == before


# ---- a film ----


@pytest.fixture(scope="module")
def film(page, browser):
    """The film's page on a phone, and the film."""
    with Visit(browser, page.with_name("02.html"), width=390) as visit:
        visit.page.get_by_role("button", name="Play").wait_for()
        yield visit.page, visit.page.locator(".toy-figure").first
        assert visit.complaints == []
        assert all(url.startswith(("file:", "data:", "blob:")) for url in visit.requests)


# The poses that are drawn from now on, as lists of numbers: those of the first mesh.
POSES = """() => {
  const { scene } = window.course, { draw } = scene;
  scene.draw = (context, what, redraw) => { window.poses = what.meshes[0].poses; draw(context, what, redraw); };
}"""


def test_the_range_moves_the_bodies_along_screws(film, figure):
    page, _ = film
    page.evaluate(POSES)
    slider, poses = page.get_by_role("slider", name="Time"), Film(figure).poses
    assert slider.get_attribute("aria-valuetext") == "0.00 s"
    slider.focus()
    for _ in range(5):  # 0.05 s, in the middle between two of the poses that the film holds
        page.keyboard.press("ArrowRight")
    assert slider.get_attribute("aria-valuetext") == "0.05 s"
    half = poses[0] @ rigid.exp_se3(0.5 * rigid.log_se3(rigid.inverse(poses[0]) @ poses[1]))
    page.wait_for_function(
        "x => Math.abs(window.poses.at(-1)[0][3] - x) < 1e-4", arg=half[-1, 0, 3]
    )
    assert_allclose(page.evaluate("window.poses"), half, atol=1e-4)


def test_play_moves_it_and_pause_holds_it(film):
    page, box = film
    slider, before = page.get_by_role("slider", name="Time"), picture(box)
    page.get_by_role("button", name="Play").click()
    page.wait_for_function(
        f"([box, before]) => ({PICTURE})(box) !== before", arg=[box.element_handle(), before]
    )
    page.get_by_role("button", name="Pause").click()
    page.get_by_role("button", name="Play").wait_for()
    at, held = slider.get_attribute("aria-valuetext"), picture(box)
    assert 0 <= float(at.split()[0]) <= 2  # on a busy machine it may have begun again
    page.evaluate(SETTLED, 200)
    assert slider.get_attribute("aria-valuetext") == at
    assert picture(box) == held


# The colours of translucent bodies that are drawn from now on.
TRANSLUCENT = """() => {
  const { scene } = window.course, { draw } = scene;
  scene.draw = (context, what, redraw) => {
    const mesh = what.meshes.find(({ opacity }) => opacity < 1);
    window.colours = mesh.mesh.colours.map((index) => mesh.palette[index]);
    draw(context, what, redraw);
  };
}"""


def test_a_translucent_amber_body_keeps_its_colour_in_the_dark(page, browser):
    with Visit(browser, page.with_name("03.html")) as visit:
        visit.page.locator(".toy-figure.drawn").wait_for()
        visit.page.evaluate(TRANSLUCENT)
        for theme, colour in (("dark", "#e8eaed"), ("light", PALETTE[AMBER])):
            visit.page.evaluate("theme => (document.documentElement.dataset.theme = theme)", theme)
            visit.page.wait_for_function(
                "colour => window.colours?.every((own) => own === colour)", arg=colour
            )
