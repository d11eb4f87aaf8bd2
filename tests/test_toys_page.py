"""Toys on an exported page: moved by keyboard and pointer, offline, wide and narrow, in both themes."""

import re

import pytest
from nbformat.v4 import new_markdown_cell
from playwright.sync_api import expect
from site_notebooks import cell, output, write
from site_visits import CONTRAST, Visit, violations
from some_toys import TOYS
from sphinx_builds import build

from course_lib.figures.display import TOY

MINUS = "\N{MINUS SIGN}"
ALL = 26000  # pixels: a window in which all toys are near, so that none is removed and made anew for every test


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    folder = tmp_path_factory.mktemp("toys")
    cells = [new_markdown_cell("# Toys")]
    for i, make in enumerate(TOYS.values()):
        toy = make()
        cells += [new_markdown_cell(f"## {i}"), cell(output({TOY: toy.stored(), "text/plain": toy.alt}))]
    write(folder / "notebooks", "01.ipynb", *cells)
    build(folder / "notebooks", folder / "html")
    return folder / "html/01.html"


LOOKS = {"desktop": (1280, "light"), "phone": (390, "dark")}  # width in pixels, theme


@pytest.fixture(scope="module", params=LOOKS.values(), ids=LOOKS)
def visit(page, browser, request):
    width, theme = request.param
    with Visit(browser, page, width=width, theme=theme) as visit:
        visit.page.set_viewport_size({"width": width, "height": ALL})
        visit.page.wait_for_function("() => !document.querySelector('.plotly-figure:not(:has(.course-toy))')")
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
    return visit.page.locator(".plotly-figure").nth(list(TOYS).index(name))


def picture(box):
    return box.evaluate(PICTURE)


def wait_until(visit, condition, box, arg=None):
    """Wait until condition(box, arg) holds in the page, for a toy draws when the browser is ready for it."""
    once = f"([box, arg]) => ({condition})(box, arg)"
    visit.page.wait_for_function(once, arg=[box.element_handle(), arg])


def wait_for_another_picture(visit, box, before):
    wait_until(visit, f"(box, before) => ({PICTURE})(box) !== before", box, before)


@pytest.mark.parametrize("name", TOYS)
def test_every_range_has_a_name_and_a_value_in_words_and_moves_the_picture_by_keyboard(visit, name):
    box = figure_of(visit, name)
    ranges = box.locator("input[type=range]:enabled").all()
    assert ranges or name == "table"
    narrow = visit.page.viewport_size["width"] < 500
    for one in ranges[:1] if narrow else ranges[::-1]:  # the first may shut others off
        label, words, room = one.evaluate(
            "e => { e.focus(); return [e.labels[0].textContent.trim(), e.ariaValueText, e.max - e.value]; }"
        )
        assert label
        before = picture(box)
        for _ in range(3):
            visit.page.keyboard.press("ArrowRight" if room > 0 else "ArrowLeft")
        wait_for_another_picture(visit, box, before)
        assert one.get_attribute("aria-valuetext") not in (words, None)


HANDLES = ["two_poses_toy", "planar_arm_toy", "cells_toy", "bent_arm_toy", "circles_toy", "reach", "fly", "table"]
FREE = ("circles_toy", "fly", "reach")  # their handles stay on a sphere, or the view widens


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
        expect(handle).not_to_have_attribute("aria-label", label)
        label, (x, y) = handle.get_attribute("aria-label"), centre(handle)
        drag(visit.page, x, y, -25, 30)
        expect(handle).not_to_have_attribute("aria-label", label)
        if "direction" not in label and name not in FREE:
            assert centre(handle) == pytest.approx((x - 25, y + 30), abs=3)


@pytest.fixture(scope="module")
def phone(page, browser):
    with Visit(browser, page, width=390, has_touch=True, is_mobile=True, device_scale_factor=2) as visit:
        # Until each toy has its height, what stands above the window grows and moves what is in it.
        visit.page.wait_for_function("() => !document.querySelector('.plotly-figure:not(.drawn)')")
        yield visit
        assert visit.complaints == []


@pytest.mark.parametrize("name", HANDLES)
def test_a_finger_drags_every_handle_and_scrolls_the_page_beside_it(phone, name):
    touch = phone.page.context.new_cdp_session(phone.page)

    def swipe(x, y, dx, dy):
        for k in range(9):
            kind, at = "touchMove" if k else "touchStart", {"x": x + dx * k / 8, "y": y + dy * k / 8}
            touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [at]})
            phone.page.wait_for_timeout(16)
        phone.page.wait_for_timeout(60)  # a finger that leaves at rest: the page does not scroll on
        touch.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})

    box = figure_of(phone, name)
    box.scroll_into_view_if_needed()
    for handle in box.locator(".handle").all():
        handle.evaluate("e => e.closest('.course-stage').scrollIntoView({ block: 'center' })")
        (x, y), scrolled = centre(handle), phone.page.evaluate("scrollY")
        dx = 40 if x < 195 else -40
        swipe(x, y, dx, 32)
        assert phone.page.evaluate("scrollY") == scrolled, "the handle moves, not the page"
        moved = "([e, x, y], b = e.getBoundingClientRect()) => Math.hypot(b.x + 22 - x, b.y + 22 - y) > 10"
        phone.page.wait_for_function(moved, arg=[handle.element_handle(), x, y])
    stage, before = box.locator(".course-stage").first.bounding_box(), phone.page.evaluate("scrollY")
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


# ---- the one WebGL context ----

KEPT = """() => {
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
    if (kind !== "webgl2") return getContext.call(this, kind, ...more);
    if (location.hash === "#none") return null;
    window.contexts = (window.contexts || 0) + 1;
    return (window.gl = getContext.call(this, kind, ...more));
  };
}"""


def test_all_toys_share_one_context_and_survive_its_loss(page, browser):
    with Visit(browser, None, java_script_enabled=True) as visit:
        visit.page.add_init_script(f"({KEPT})()")
        visit.page.goto(page.as_uri())
        for name in ("circles_toy", "panda_toy"):
            box = figure_of(visit, name)
            box.scroll_into_view_if_needed()
            box.locator(".course-toy").wait_for()
        assert visit.page.evaluate("window.contexts") == 1
        visit.page.wait_for_timeout(500)
        before = picture(box)
        visit.page.evaluate("window.lost = gl.getExtension('WEBGL_lose_context'), lost.loseContext()")
        visit.page.wait_for_function("gl.isContextLost()")
        put(box, "Joint 2", 10)
        visit.page.wait_for_timeout(200)
        dots = "box => box.querySelector('canvas').toDataURL().length"
        assert box.evaluate(dots) > 10_000, "the last picture stays"
        visit.page.evaluate("lost.restoreContext()")
        wait_for_another_picture(visit, box, before)
        visit.page.wait_for_function("!gl.isContextLost()")


def test_without_webgl_the_words_or_the_still_stay_and_toys_in_the_plane_live(page, browser):
    with Visit(browser, None, java_script_enabled=True) as visit:
        visit.page.add_init_script(f"({KEPT})()")
        visit.page.goto(page.as_uri() + "#none")
        figure_of(visit, "two_poses_toy").scroll_into_view_if_needed()
        figure_of(visit, "two_poses_toy").locator(".course-toy").wait_for()
        box = figure_of(visit, "panda_toy")
        box.scroll_into_view_if_needed()
        expect(box.locator(".plotly-words")).to_be_visible()
        expect(box.locator(".course-toy")).to_have_count(0)
        assert visit.complaints == []


# ---- colours ----

# From now on every canvas notes the colours of its words, and of its lines that are no grid and part no cells.
NOTE = """() => {
  const begun = window.noted;
  window.noted = { words: new Set(), lines: new Set() };
  if (begun) return;
  const context = CanvasRenderingContext2D.prototype, { fillText, stroke } = context, { scene } = window.course;
  const { draw } = scene;
  context.fillText = function (...a) { window.noted.words.add(this.fillStyle); fillText.apply(this, a); };
  context.stroke = function (...a) {
    if (this.lineWidth >= 1.5 && this.globalAlpha === 1) window.noted.lines.add(this.strokeStyle);
    stroke.apply(this, a);
  };
  scene.draw = (context, what, redraw) => {
    what.lines.filter(({ layer }) => layer !== "floor").forEach(({ colour }) => window.noted.lines.add(colour));
    draw(context, what, redraw);
  };
}"""
# The same, with the words that are HTML.
DRAWN = """(box) => {
  const style = (e) => getComputedStyle(e), words = [...box.querySelectorAll(".word")].map((e) => style(e).color);
  const ground = style(box.querySelector("canvas")).backgroundColor;
  return [ground, [...words, ...window.noted.words], [...window.noted.lines]];
}"""
STAGES = {"light": "rgb(247, 248, 250)", "dark": "rgb(20, 23, 27)"}
# How much each of some colours stands out from the ground, as {colour: contrast}.
CONTRASTS = f"""([ground, colours]) => {{
  const there = document.body.appendChild(document.createElement("p"));
  there.style.backgroundColor = ground;
  const measured = colours.map((colour) => {{
    there.style.color = colour;
    return [colour, ({CONTRAST})(there)];
  }});
  there.remove();
  return Object.fromEntries(measured);
}}"""


@pytest.mark.parametrize("name", TOYS)
def test_text_and_lines_have_enough_contrast_in_both_themes(visit, name):
    box = figure_of(visit, name)
    visit.page.evaluate(NOTE)
    before = picture(box)
    one = box.locator("canvas[tabindex], .handle, input").first
    one.focus()
    visit.page.keyboard.press("ArrowLeft")
    wait_for_another_picture(visit, box, before)
    ground, words, lines = box.evaluate(DRAWN)
    assert ground == STAGES[visit.page.evaluate("document.documentElement.dataset.theme")]
    assert words or name in ("belt", "reach", "eight", "fly")
    assert lines or name in ("belt", "panda_toy", "reach", "eight")
    contrasts = visit.page.evaluate(CONTRASTS, [ground, words + lines])
    assert [colour for colour in words if contrasts[colour] < 4.5] == []
    assert [colour for colour in lines if contrasts[colour] < 3] == []
    parts = f"(box, parts) => parts.flatMap((part) => [...box.querySelectorAll(part)]).map({CONTRAST})"
    assert min(box.evaluate(parts, [".course-toy", ".numbers", "button", "label", "p"])) > 4.5


@pytest.mark.parametrize("name", ["circles_toy", "planar_arm_toy"])
def test_a_toy_follows_a_change_of_theme_and_keeps_its_configuration(visit, name):
    box = figure_of(visit, name)
    visit.page.evaluate(NOTE)
    slider, before = box.get_by_role("slider").first, picture(box)
    slider.focus()
    visit.page.keyboard.press("ArrowRight")
    wait_for_another_picture(visit, box, before)
    visit.page.wait_for_timeout(500)  # the last picture of a movement is finer
    value, before = slider.input_value(), picture(box)
    theme = visit.page.evaluate("document.documentElement.dataset.theme")
    for shown in ({"light": "dark", "dark": "light"}[theme], theme):
        visit.page.evaluate("(theme) => (document.documentElement.dataset.theme = theme)", shown)
        wait_until(visit, f"(box, ground) => ({DRAWN})(box)[0] === ground", box, STAGES[shown])
        sign = "===" if shown == theme else "!=="
        wait_until(visit, f"(box, before) => ({PICTURE})(box) {sign} before", box, before)
        expect(slider).to_have_value(value)


# ---- what they are for ----

# What a toy says of what it computes is the same at any width: one visit proves it.
computes = pytest.mark.parametrize("visit", [LOOKS["desktop"]], ids=["desktop"], indirect=True)


def put(box, label, value):
    one = box.get_by_label(label, exact=True)
    one.evaluate("(e, value) => { e.value = value; e.dispatchEvent(new Event('input')); }", value)


SAYS = [  # what is put into a toy's ranges, and what it then says
    ("axis", {"Angle": 360}, "R is the identity again, but q is"),
    ("axis", {"Angle": 360}, rf"\({MINUS}1.000, 0.000, 0.000, 0.000\)"),
    ("belt", {"Rotate the box": 360, "Move the box, without rotating it": 1}, "only changed its direction"),
    ("belt", {"Rotate the box": 360, "Move the box, without rotating it": 1}, rf"\({MINUS}1.000"),
    ("belt", {"Rotate the box": 720, "Move the box, without rotating it": 1}, "flat again"),
    ("planar_arm_toy", {"Damping (m²)": -2, "Step size": 0.8}, r"(?<!\d)([6-9]|\d\d) steps, distance left \de-[78]"),
    ("planar_arm_toy", {"Damping (m²)": -2, "Step size": 0.9}, r"(?<!\d)([6-9]|\d\d) steps, distance left \de-[78]"),
    ("planar_arm_toy", {"Damping (m²)": -2, "Step size": 4}, r"200 steps, distance left (?!\de-)"),
    ("dead_reckoning_toy", {"Step dt": 0}, "Docking needs"),
    ("dead_reckoning_toy", {"Step dt": -2}, "Close enough to dock"),
    ("circles_toy", {"Between the axes k1, k2": 70, "From k1 to p1": 50, "From k2 to p2": 45}, "twice"),
    ("circles_toy", {"Between the axes k1, k2": 70, "From k1 to p1": 30, "From k2 to p2": 40}, "touch"),
    ("circles_toy", {"Between the axes k1, k2": 70, "From k1 to p1": 20, "From k2 to p2": 20}, "farther apart"),
    ("circles_toy", {"Between the axes k1, k2": 70, "From k1 to p1": 100, "From k2 to p2": 20}, "inside the other"),
]


@computes
@pytest.mark.parametrize(("name", "values", "says"), SAYS)
def test_a_toy_says_what_it_computes(visit, name, values, says):
    box = figure_of(visit, name)
    for label, value in values.items():
        put(box, label, value)
    expect(box.locator(".controls")).to_contain_text(re.compile(says))


@computes
def test_pitch_drives_the_gimbals_into_lock(visit):
    box = figure_of(visit, "gimbals")
    assert "Gimbal lock" not in box.locator("p[role=status]").inner_text()
    for sign, counts in (("+", "the difference yaw"), (MINUS, "the sum yaw + roll")):
        box.get_by_role("button", name=f"Drive to {sign}90°").click()
        expect(box.locator("p[role=status]")).to_contain_text(re.compile(f"Gimbal lock.*{re.escape(counts)}"))
        before, yaw = box.locator(".matrix").get_attribute("aria-label"), box.get_by_label("Yaw (outer ring, about z)")
        angle = yaw.input_value()
        box.get_by_role("button", name=f"Yaw +10°, roll {sign}10°").click()
        expect(yaw).not_to_have_value(angle)
        assert box.locator(".matrix").get_attribute("aria-label") == before, "the orientation stays"
        expect(box.locator(".word", has_text="lost")).to_be_visible()


@computes
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


@computes
def test_the_elbow_moves_and_the_gripper_stays_within_a_micrometre(visit):
    box = figure_of(visit, "panda_toy")
    pose = box.locator(".matrix").get_attribute("aria-label")
    before = box.evaluate(JOINTS)
    assert len(before) == 7
    for share in (0.0, 0.3, 1.0):
        put(box, "Elbow (gripper stays)", share)
        expect(box.locator(".numbers")).to_contain_text("the gripper moved by")
        moved = f"(box, before) => ({JOINTS})(box).some((angle, i) => Math.abs(angle - before[i]) > 3)"
        wait_until(visit, moved, box, before)
        words = box.locator(".numbers").inner_text()
        assert float(re.search(r"gripper moved by (\S+) mm", words)[1]) < 1e-3
        assert box.locator(".matrix").get_attribute("aria-label") == pose
        before = box.evaluate(JOINTS)


def test_a_robot_is_driven_by_keys_and_by_buttons_and_its_dead_reckoning_follows(visit):
    box = figure_of(visit, "drive")
    status, number = box.locator("p[role=status]"), re.compile(r"is (\S+) cm and (\S+)° off")
    box.get_by_role("button", name="Start again").click()
    expect(status).to_contain_text("0.0 cm and 0° off")
    left, ahead = (box.get_by_role("button", name=name, exact=True) for name in ("Left", "Ahead"))
    ahead.press("Enter")  # half a second: on a straight line Euler's method is right, and on the spot
    left.press("Enter")
    expect(status).to_contain_text("0.0 cm and 0° off")
    x, y = centre(ahead)
    visit.page.mouse.move(x, y)
    visit.page.mouse.down()
    visit.page.wait_for_timeout(200)
    visit.page.mouse.up()
    visit.page.wait_for_timeout(300)  # what was begun before is drawn
    before = picture(box)
    visit.page.wait_for_timeout(200)
    assert picture(box) == before, "it stops when the button is released"
    box.locator("canvas").focus()
    for key in ("ArrowUp", "ArrowRight"):
        visit.page.keyboard.down(key)
    visit.page.wait_for_timeout(1500)
    for key in ("ArrowUp", "ArrowRight"):
        visit.page.keyboard.up(key)
    expect(status).not_to_contain_text("is 0.")
    assert float(number.search(status.inner_text())[1]) > 1
    box.get_by_label("Hide the robot").check()
    expect(status).to_contain_text("Drive the red robot to the dock")
    box.get_by_label("Hide the robot").uncheck()


@computes
def test_at_the_edge_a_higher_degree_helps_the_square_of_the_bend_only(visit):
    box = figure_of(visit, "bent_arm_toy")
    put(box, "Distance r", 1.95)
    put(box, "Degree", 2)  # whatever it was before
    off = []
    for degree in (3, 1):
        words = box.locator(".numbers").inner_text()
        put(box, "Degree", degree)
        expect(box.locator(".numbers")).not_to_have_text(words, use_inner_text=True)
        off.append([float(x) for x in re.findall(r"(\S+)° off", box.locator(".numbers").inner_text())])
    assert "touches the edge" in box.locator("p[role=status]").inner_text()
    (cubic, cubic_of_square), (line, line_of_square) = off
    assert cubic > 0.3 * line
    assert cubic_of_square < 0.1 * line_of_square
    box.get_by_role("button", name="Other elbow").click()
    expect(box.locator("p[role=status]")).to_contain_text(f"q2 = {MINUS}")


def test_every_toy_is_accessible(visit):
    assert violations(visit, within=".course-toy") == []


def test_the_library_follows_each_of_several_solutions_while_the_target_moves(visit):
    box = figure_of(visit, "eight")
    once = box.locator(".numbers").inner_text()
    assert "8 solutions" in box.inner_text()
    box.get_by_label("Rotate about z").first.focus()
    visit.page.keyboard.press("ArrowRight")
    wait_until(visit, "(box, once) => box.querySelector('.numbers').innerText !== once", box, once)
    assert "8 solutions" in box.inner_text()
    assert box.locator(".numbers").inner_text().count(" 0.0 mm from the target") == 8
