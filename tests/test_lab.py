"""JupyterLab as a student meets it: make's own command, whole notebooks for minutes, toys moved by
one's own function.

The lightest notebook is run in each run of the tests, all with ``make test LAB=all ONLY=lab``.
"""

import os
import re
import shlex
import subprocess
import sys
import time
from contextlib import contextmanager, suppress
from pathlib import Path
from urllib.request import urlopen

import nbformat
import numpy as np
import pytest
from nbformat.v4 import new_code_cell, new_notebook
from playwright.sync_api import TimeoutError as NoRequest
from playwright.sync_api import expect
from site_visits import CONTRAST, be_patient

from course_lib.figures.toys.toy import CORE, module
from course_lib.jupyter import saving

ROOT = Path(__file__).parent.parent
PORT, TOKEN = 8000 + os.getpid() % 1000, "toys"
SOURCES = (
    (
        "import numpy as np\nfrom course_lib import figures\nfrom course_lib.arms import iiwa14\n"
        "from course_lib.lessons.decomposition_ik.toys import table\n"
        "from course_lib.lessons.subproblems_damped_ik.toys import planar_arm_toy\n"
        "from course_lib.rigid import exp_se3\nplanar_arm_toy()"
    ),
    (
        "def reversed_order(screws, M, theta):\n    T = np.eye(4)\n    for S, angle in zip(screws, "
        "theta, strict=True):\n"
        "        T = exp_se3(np.array(S) * angle) @ T\n    return T @ M\n\n\n"
        "figures.jog(iiwa14(), reversed_order, q=7 * [0.3])"
    ),
    "figures.jog(iiwa14(), lambda q: iiwa14().frames(q), q=7 * [0.3])",
    (
        "import time\nfrom pathlib import Path\nasked = []\n\n\ndef slow(p):\n    asked.append(p)\n"
        "    while Path('held').exists():\n        time.sleep(0.05)\n    return np.log([p[0], 1 / 0"
        " if p[1] < 0 else 2])\n\n\nfigures.alive(table(at=(1, 0.5)), slow)"
    ),
    "len(asked)",
)
# "Kernel status: Idle" stands there before there is a kernel, too
IDLE = "Python 3 (ipykernel) | Idle"


# How many dots of a canvas are bluish, as the library's pale arm is.
BLUE_DOTS = """canvas => {
  const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  let count = 0;
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] > 200 && data[i + 2] > data[i] + 25 && data[i + 2] > data[i + 1] + 8) count++;
  }
  return count;
}"""


def lab_options(makefile, *options):
    """Of the one command of `make lab` the folder of settings, the options, and the notebook that
    it opens."""
    command = ["make", "-n", "-f", makefile, "lab", *options]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    shell = done.stdout.replace("\\\n", " ")
    ((config, command),) = re.findall(r'JUPYTER_CONFIG_PATH="([^$"]*).* -m jupyter lab (.*)', shell)
    *options, notebook = shlex.split(command)
    return config, options, notebook


def test_both_makefiles_start_jupyterlab_alike():
    ours = lab_options("Makefile", "SOLUTIONS=yes")
    assert ours == lab_options("course_lib/pack/release/students/Makefile")
    assert (ROOT / ours[-1]).is_file()
    assert lab_options("Makefile") == (*ours[:-1], ours[-1].replace("notebooks", "exercises"))


@pytest.fixture(scope="module")
def folder(unpacked):
    """The students' notebooks, and one with toys."""
    return unpacked / "notebooks"


@pytest.fixture(scope="module")
def server(folder, tmp_path_factory):
    """The address of JupyterLab in that folder, for a user without settings, and the file of its
    messages."""
    home = tmp_path_factory.mktemp("lab")
    book = new_notebook(cells=[new_code_cell(source) for source in SOURCES])
    book.metadata.kernelspec = {"name": "python3", "display_name": "Python 3", "language": "python"}
    nbformat.write(book, folder / "toys.ipynb")
    config, options, _ = lab_options("Makefile")
    settings = {
        f"JUPYTER_{name}_DIR": str(home / name.lower()) for name in ("CONFIG", "DATA", "RUNTIME")
    }
    settings["JUPYTER_CONFIG_PATH"] = str(ROOT / config)
    options += ["--no-browser", f"--port={PORT}", f"--IdentityProvider.token={TOKEN}"]
    if hasattr(os, "getuid") and os.getuid() == 0 and "--allow-root" not in options:
        options.append("--allow-root")
    with open(home / "log", "w") as log:
        command = [sys.executable, "-m", "jupyter", "lab", *options, str(folder / "toys.ipynb")]
        process = subprocess.Popen(
            command, stdout=log, stderr=log, cwd=folder, env={**os.environ, **settings}
        )
        try:
            while True:
                try:
                    urlopen(f"http://localhost:{PORT}/api?token={TOKEN}").close()
                    break
                except OSError:
                    assert process.poll() is None, (home / "log").read_text()
                    time.sleep(0.2)
            yield home / "log"
        finally:
            process.terminate()
            with suppress(subprocess.TimeoutExpired):  # now and then a thread of its own keeps it
                process.wait(60)
            process.kill()
            process.wait()


@contextmanager
def opened(browser, name):
    """A page of JupyterLab with that notebook and an idle kernel; it records what it asks for and
    what is closed."""
    context = browser.new_context(viewport={"width": 1366, "height": 768}, reduced_motion="reduce")
    be_patient(browser)
    page = context.new_page()
    page.asked, page.closed = [], []
    page.on("request", lambda request: page.asked.append(request.url))
    page.on(
        "websocket",
        lambda socket: socket.on("close", lambda closed: page.closed.append(closed.url)),
    )
    # Where saving takes long, JupyterLab's own save meets the next one, and it asks which of the
    # two to keep.
    page.add_locator_handler(
        page.get_by_role("button", name="Overwrite", exact=True), lambda button: button.click()
    )
    page.goto(f"http://localhost:{PORT}/lab/workspaces/{name}/tree/{name}.ipynb?token={TOKEN}")
    expect(page.locator(".jp-Notebook").first).to_be_visible()
    page.get_by_text(IDLE).wait_for()
    yield page
    context.close()


def choose(page, menu, item):
    page.get_by_role("menuitem", name=menu).first.click()
    page.locator(".lm-Menu-item:not(.lm-mod-disabled)").get_by_text(item, exact=True).click()


# ---- a notebook, for minutes ----

NOTEBOOKS = sorted(path.stem for path in (ROOT / "notebooks").glob("[0-9][0-9]_*.ipynb"))
PING = 30  # seconds between two signs of life of the server
WHOLE = 100  # seconds for which a notebook is open at least


def code_cells(path):
    with suppress(nbformat.reader.NotJSONError):
        return [cell for cell in nbformat.read(path, 4).cells if cell.cell_type == "code"]
    time.sleep(0.2)  # JupyterLab is writing it once more
    return code_cells(path)


def all_have_run(page, path, number):
    """Wait until all cells have run, save, and return them; of one the execution count was another
    before."""
    prompts = page.locator(".jp-CodeCell .jp-InputPrompt")
    expect(prompts.nth(number)).to_have_text(re.compile(rf"\[(\*|{number + 1})\]:"))
    waiting = prompts.get_by_text("[*]:")
    while left := waiting.count():  # however long it takes, if only one after the other is done
        expect(waiting).not_to_have_count(left)
    page.get_by_text(IDLE).wait_for()
    return saved(page, path)


def is_save(request):
    return request.method == "PUT" and "/contents/" in request.url


def save_once(page):
    """Ask for a save until one begins, and wait for its end: JupyterLab passes over the command
    without a word while another save of its own, or the checkpoint after it, is under way."""
    for _ in range(20):
        with suppress(NoRequest):
            with page.expect_request(is_save, timeout=5000) as begun:
                choose(page, "File", "Save Notebook")
            return begun.value.response()
    raise AssertionError("JupyterLab began no save.")


def saved(page, path):
    """Save the notebook and return its code cells."""
    for _ in range(2):  # the first may be JupyterLab's own save, of what it had before
        save_once(page)
    return code_cells(path)


def run(page, number, source=None):
    """Run a code cell, with another source if there is one, and return where its outputs appear."""
    cell = page.locator(".jp-Notebook .jp-CodeCell").nth(number)
    cell.scroll_into_view_if_needed()
    cell.locator(".cm-content").click()
    if source:
        page.keyboard.press("ControlOrMeta+a")
        page.keyboard.insert_text(source)
    page.keyboard.press("Shift+Enter")
    return cell.locator(".jp-OutputArea")


@pytest.mark.quick
def test_a_notebook_runs_from_its_first_cell_to_its_last(server, browser, folder):
    name = NOTEBOOKS[0]  # another than the one that is kept open below, whose kernel it would use
    path = folder / f"{name}.ipynb"
    solved = code_cells(ROOT / "notebooks" / path.name)
    first_check = next(k for k, cell in enumerate(solved) if cell.source.startswith("check."))
    with opened(browser, name) as page:
        expect(page.locator(".jp-Notebook .jp-CodeCell")).to_have_count(len(code_cells(path)))
        choose(page, "Run", "Run All Cells")
        cells = all_have_run(page, path, first_check)
    assert [cell.id for cell in cells if cell.execution_count is None] == []
    shown = {cell.id for cell in solved if cell.outputs}
    assert [cell.id for cell in cells if cell.id in shown and not cell.outputs] == []


@pytest.mark.parametrize("name", NOTEBOOKS if os.environ.get("LAB") == "all" else NOTEBOOKS[1:2])
def test_a_notebook_keeps_every_result_and_its_connection(server, browser, folder, name):
    path, begun = folder / f"{name}.ipynb", time.monotonic()
    solved = code_cells(ROOT / "notebooks" / path.name)
    ids = [cell.id for cell in code_cells(path)]
    shown = {cell.id for cell in solved if cell.outputs}
    exercise = next(
        k for k, cell in enumerate(solved) if cell.metadata.get("nbgrader", {}).get("solution")
    )
    right, check = solved[exercise].source, ids.index(solved[exercise + 1].id)
    function = solved[exercise].metadata.nbgrader.grade_id

    def assert_all_ran(cells):
        assert [cell.id for cell in cells] == ids
        assert [cell.id for cell in cells if cell.execution_count is None] == []
        assert [cell.id for cell in cells if cell.id in shown and not cell.outputs] == []

    with opened(browser, name) as page:
        expect(page.locator(".jp-Notebook .jp-CodeCell")).to_have_count(len(ids))
        choose(page, "Run", "Run All Cells")
        assert_all_ran(all_have_run(page, path, check))
        run(page, exercise, f"{right}\n\n\n{function} = lambda *arguments: {function}_is_wrong")
        expect(run(page, check)).to_contain_text("NameError")
        run(
            page, exercise, f"import time\n\ntime.sleep({1.2 * PING})\n\n\n{right}"
        )  # busy between two pings
        expect(run(page, check)).to_contain_text("right")
        assert page.closed == []
        choose(page, "Kernel", "Restart Kernel and Run All Cells…")
        page.get_by_role("button", name="Confirm Kernel Restart").click()
        assert_all_ran(all_have_run(page, path, check))
        page.closed.clear()  # a restart closes the connection and opens another
        page.wait_for_timeout(max(0, WHOLE - (time.monotonic() - begun)) * 1000)
        expect(run(page, check)).to_contain_text("right")
        assert page.closed == []
    warnings = re.findall(r"(?:\[[WE] .*?\]|WARNING \|) (.*)", server.read_text())
    # the last at a restart
    known = r"is not trusted|ping_timeout .* cannot be longer|Got events for closed stream"
    # while a file is saved, and while a new kernel is busy
    known += r"|/\.~\S+ doesn't exist|Nudge: attempt"
    assert [line for line in warnings if not re.search(known, line)] == []
    # A long list that would stand below the address that is to be opened.
    assert "Skipped non-installed server" not in server.read_text()


# ---- toys ----


@pytest.fixture(scope="module")
def lab(server, browser):
    with opened(browser, "toys") as page:
        expect(page.locator(".jp-Notebook .jp-CodeCell")).to_have_count(len(SOURCES))
        yield page


def output(lab, number):
    cell = lab.locator(".jp-Notebook .jp-CodeCell").nth(number)
    cell.scroll_into_view_if_needed()
    return cell.locator(".jp-OutputArea-output")


def test_toys_appear_in_jupyterlab_without_a_question(lab):
    choose(lab, "Run", "Run All Cells")
    expect(lab.locator(".course-toy")).to_have_count(len(SOURCES) - 1)
    assert lab.locator(".Toastify__toast").all_inner_texts() == []
    assert lab.locator(".jp-RenderedImage").count() == 0, (
        "the widget alone, not the still figure too"
    )


def test_arrow_keys_move_the_target_and_not_to_another_cell(lab):
    handle = output(lab, 0).locator(".handle")
    handle.focus()
    label = handle.get_attribute("aria-label")
    lab.keyboard.press("ArrowUp")
    expect(handle).not_to_have_attribute("aria-label", label)
    assert handle.evaluate("e => e.ownerDocument.activeElement === e"), (
        "JupyterLab's own keys do not take over"
    )


@pytest.mark.parametrize("control", ["input[type=range]", "button", "summary"])
def test_shift_enter_in_a_toy_goes_on_to_the_next_cell(lab, control):
    number = 1 if control == "summary" else 0
    output(lab, number).locator(control).first.click()
    lab.keyboard.press("Shift+Enter")
    following = lab.locator(".jp-Notebook .jp-CodeCell").nth(number + 1)
    expect(following).to_have_class(re.compile("jp-mod-active"))


def test_a_wrong_forward_kinematics_is_seen_beside_the_librarys(lab):
    out = output(lab, 1)
    words = out.locator("p[role=status]")
    expect(words).to_contain_text("Moved by your function. The pale blue arm is the library's")
    before = out.locator(".matrix").inner_text()
    assert before != output(lab, 2).locator(".matrix").inner_text(), (
        "the pose is the student's, not the library's"
    )
    out.get_by_text("Joint angles").click()
    out.get_by_label("Joint 2", exact=True).focus()
    for _ in range(5):
        lab.keyboard.press("ArrowRight")
    expect(out.locator(".matrix")).not_to_have_text(before)
    expect(words).to_contain_text("differ by")
    both = [one.locator("canvas").element_handle() for one in (out, output(lab, 2))]
    lab.wait_for_function(
        f"(both) => (([ours, theirs]) => ours > 500 + 3 * theirs)(both.map({BLUE_DOTS}))", arg=both
    )


def test_a_slow_function_answers_the_newest_question(lab, folder):
    out = output(lab, 3)
    words, handle = out.locator("p[role=status]"), out.locator(".handle")

    def press(times, key):
        """Press a key again and again while the function computes its answer."""
        (folder / "held").touch()
        handle.focus()
        for _ in range(times):
            lab.keyboard.press(key)
        (folder / "held").unlink()

    expect(words).to_contain_text("Answered by your function. The tip is")
    press(20, "ArrowRight")
    newest = 1 + 20 * 2 * 1.15 * 2 / 120  # a key moves the handle by a 120th of the picture's width
    expect(out.locator(".numbers")).to_contain_text(f"({np.rad2deg(np.log(newest)):.1f}")
    press(8, "Shift+ArrowDown")
    expect(words).to_contain_text("Your function: ZeroDivisionError")
    expect(words).to_contain_text("library")
    press(8, "Shift+ArrowUp")
    expect(words).to_contain_text("Answered by your function.")
    # At first, and two of each time: one for the first key and one for the newest.
    expect(run(lab, 4)).to_have_text(re.compile(r"\D[2-7]$"))


def test_in_the_dark_theme_the_toys_are_dark(lab):
    out = output(lab, 2)
    values = [slider.input_value() for slider in out.get_by_role("slider").all()]
    lab.get_by_role("menuitem", name="Settings").first.click()
    lab.get_by_text("Theme", exact=True).first.hover()
    lab.get_by_text("JupyterLab Dark", exact=True).click()
    expect(lab.locator("body")).to_have_attribute("data-jp-theme-light", "false")
    for one in (out, output(lab, 0)):
        expect(one.locator(".course-toy")).to_have_css("background-color", "rgb(27, 31, 36)")
    expect(out.locator("p[role=status]")).to_have_text(
        "Moved by your function, which agrees with the library."
    )
    assert [slider.input_value() for slider in out.get_by_role("slider").all()] == values
    assert output(lab, 0).locator("p[role=status]").last.evaluate(CONTRAST) > 4.5


def test_a_saved_notebook_holds_words_for_its_toys_and_no_widget(lab, folder):
    cells = saved(lab, folder / "toys.ipynb")
    bundles = [output.data for cell in cells for output in cell.outputs if "data" in output]
    toys = [data for data in bundles if saving.TOY in data]
    assert len(toys) == len(SOURCES) - 1
    assert [sorted(data) for data in toys if saving.VIEW in data] == []
    assert all("It moves in JupyterLab once its cell has run" in data["text/html"] for data in toys)


def test_no_request_left_the_machine(lab):
    assert len(lab.asked) > 10
    assert [url for url in lab.asked if not re.match(r"https?://localhost|data:|blob:", url)] == []


UNANSWERED = """async (source) => {
  const { default: widget } = await import(URL.createObjectURL(new Blob([source], { type: "text/javascript" })));
  course.kinds.asking = (el, meta, kernel) => { kernel.ask({}); return () => {}; };
  const state = { meta: { kind: "asking" }, alt: "", answers: true };
  const on = (name, act) => { window.answer = act; };
  widget.render({ model: { get: (name) => state[name], on, send() {} }, el: document.body });
}"""


def test_a_kernel_that_does_not_answer_is_reported(browser):
    """The sentence disappears when the kernel answers."""
    context = browser.new_context()
    page = context.new_page()
    page.clock.install(time=0)
    page.clock.pause_at(3600)
    page.evaluate(UNANSWERED, module(CORE))
    page.clock.fast_forward(4000)
    assert page.text_content("body") == ""
    page.clock.fast_forward(2000)
    assert page.text_content("body").endswith("When it is idle, run this cell again.")
    page.evaluate("answer({ begun: true })")
    assert page.text_content("body") == ""
    page.clock.fast_forward(3000)
    assert page.text_content("body").endswith("Your function is still computing this answer.")
    page.evaluate("answer({})")
    assert page.text_content("body") == ""
    context.close()


# ---- charts ----

CHART = """import numpy as np
from course_lib.figures import charts, show
x = np.arange(11.0)
fig = charts.panels(xlabel="time (s)", ylabel="height (m)")
charts.add_line(fig, x, x**2 / 10, "a ball", markers=True)
show(fig, alt="A curve that rises as a parabola does, to 10 m.")"""
PLACE = "({ _fullLayout: { xaxis, yaxis } }) => ({ x: xaxis.c2p(5), y: yaxis.c2p(2.5) })"


def test_a_chart_is_live_in_both_themes(server, folder, browser):
    book = new_notebook(cells=[new_code_cell(CHART)])
    book.metadata.kernelspec = {"name": "python3", "display_name": "Python 3", "language": "python"}
    nbformat.write(book, folder / "charts.ipynb")
    with opened(browser, "charts") as page:
        choose(page, "Run", "Run All Cells")
        plot = page.locator(".js-plotly-plot")
        expect(plot.locator(".nsewdrag")).to_be_attached()
        for theme in ("JupyterLab Dark", "JupyterLab Light"):
            page.get_by_role("menuitem", name="Settings").first.click()
            page.get_by_text("Theme", exact=True).first.hover()
            page.get_by_text(theme, exact=True).first.click()
            expect(page.locator("body")).to_have_attribute("data-jp-theme-name", theme)
            plot.locator(".nsewdrag").hover(position=plot.evaluate(PLACE))
            label = plot.locator(".hoverlayer .hovertext")
            expect(label).to_contain_text("time: 5 s")
            expect(label).to_contain_text("height: 2.5 m")
            page.mouse.move(5, 5)
        assert [
            url for url in page.asked if f"localhost:{PORT}" not in url and "http" in url[:5]
        ] == []
