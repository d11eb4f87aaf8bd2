"""The kit for charts, and what a notebook stores of a plotly figure."""

import base64
import json
import re
import subprocess
import sys
from io import BytesIO
from pathlib import Path

import matplotlib.image
import nbformat
import numpy as np
import plotly.graph_objects as go
import pytest
from bs4 import BeautifulSoup
from helpers import ALT, shown, unavailable
from nbconvert.exporters import SlidesExporter
from nbformat.v4 import new_markdown_cell, new_notebook
from playwright.sync_api import expect
from site_visits import SETTLED, Visit
from traitlets.config import Config

from course_lib.figures import charts, show
from course_lib.figures.charts import ColourScale
from course_lib.figures.stills import stored_stills
from course_lib.figures.stored_chart import PLOTLY, stored
from course_lib.figures.style import COLOURS
from course_lib.lessons.decomposition_ik import figures as nb6
from course_lib.lessons.subproblems_damped_ik import figures as nb3
from course_lib.pack import notebooks
from course_lib.pack.site.build import build

METRES = {"xlabel": "x (m)", "ylabel": "y (m)"}
ERROR = ColourScale("error (cm)", low=0, high=10)
T = np.linspace(0, 1, 5)


def all_numbers(node):
    """Yield every float of a JSON document."""
    if isinstance(node, float):
        yield node
    elif isinstance(node, dict | list):
        for inner in node.values() if isinstance(node, dict) else node:
            yield from all_numbers(inner)


# ---- panels and series ----


def test_the_hover_label_has_the_name_and_values_with_units():
    fig = charts.panels(xlabel="time (s)", ylabel="speed (m/s)")
    charts.add_line(fig, T, T, "hand", details={"row": np.arange(5), "error (cm)": T})
    (curve,) = fig.data
    assert curve.hovertemplate.split("<br>") == [
        "hand",
        "time: %{x:.4~g} s",
        "speed: %{y:.4~g} m/s",
        "row: %{customdata[0]}",
        "error: %{customdata[1]:.4~g} cm<extra></extra>",
    ]
    assert curve.customdata[4] == [4, 1.0]


def test_lines_shows_all_values_at_one_x():
    fig = charts.lines(T, {"a": T, "b": 2 * T}, xlabel="time (s)", ylabel="height (m)")
    assert fig.layout.hovermode == "x unified"
    assert [curve.line.color for curve in fig.data] == list(COLOURS[:2])
    assert fig.data[0].line.dash != fig.data[1].line.dash


def test_the_pointer_does_not_say_a_name_twice():
    fig = charts.panels(["speed", "mug"], xlabel="t (s)", ylabel="y (m)", columns=1, share="x")
    charts.add_line(fig, T, T, "speed")
    charts.add_line(fig, T, T, "error", panel=1)
    hovers = [curve.hovertemplate for curve in fig.data]
    assert hovers == ["%{y:.4~g} m", "%{y:.4~g} m, mug"]


def test_a_name_has_one_colour_and_legend_entry_in_all_panels():
    fig = charts.panels(["left", "right"], **METRES)
    for panel in (0, 1):
        charts.add_line(fig, T, T, "a", panel=panel)
        charts.add_points(fig, T, T, "b", panel=panel)
    assert [series.showlegend for series in fig.data] == [True, True, False, False]
    assert fig.data[0].line.color == fig.data[2].line.color == COLOURS[0]
    assert fig.data[1].marker.color == fig.data[3].marker.color == COLOURS[1]
    assert fig.data[2].xaxis == "x2"


def test_one_series_needs_no_legend_and_a_second_one_brings_it():
    fig = charts.panels(**METRES)
    charts.add_line(fig, T, T, "a")
    assert not fig.layout.showlegend
    charts.add_line(fig, T, -T, "b")
    assert fig.layout.showlegend


def test_stacked_panels_share_one_time_axis():
    fig = charts.panels(["a", "b"], xlabel="time (s)", ylabel="y (m)", columns=1, share="x")
    charts.add_line(fig, T, T, "first", panel=0)
    charts.add_line(fig, T, T, "second", panel=1)
    assert [series.xaxis for series in fig.data] == ["x", "x"]
    assert [series.yaxis for series in fig.data] == ["y", "y2"]
    assert "xaxis2" not in fig.to_plotly_json()["layout"]


def test_side_by_side_panels_that_share_axes_zoom_together():
    fig = charts.panels(["a", "b"], **METRES, share="xy")
    assert (fig.layout.xaxis2.matches, fig.layout.yaxis2.matches) == ("x", "y")


def test_equal_scales_hold_in_every_panel():
    fig = charts.panels(["a", "b"], **METRES, equal=True)
    assert (fig.layout.yaxis.scaleanchor, fig.layout.yaxis2.scaleanchor) == ("x", "x2")


def test_angles_have_ticks_at_parts_of_pi():
    axis = charts.panels(xlabel="angle (rad)", ylabel="y", parts_of_pi=4).layout.xaxis
    texts = dict(zip(np.round(np.array(axis.tickvals) / np.pi, 9), axis.ticktext, strict=True))
    assert (texts[0], texts[1], texts[-0.75], texts[0.5]) == ("0", "π", "−3π/4", "π/2")


@pytest.mark.parametrize(
    ("count", "kind"), [(charts.MANY_POINTS - 1, "scatter"), (3000, "scattergl")]
)
def test_from_some_thousand_points_on_webgl_draws(count, kind):
    fig = charts.panels(**METRES)
    charts.add_points(fig, np.arange(count), np.arange(count), "many")
    assert fig.data[0].type == kind


def test_bars_say_between_which_edges_they_stand():
    fig = charts.panels(xlabel="angle (rad)", ylabel="share (%)")
    charts.add_bars(fig, [0, 1, 3], [20, 80], "rotations")
    assert list(fig.data[0].x) == [0.5, 2]
    assert list(fig.data[0].width) == [1, 2]
    assert fig.data[0].customdata[1] == [1, 3]


# ---- colours ----


def test_a_colour_bar_names_its_unit_and_says_that_it_is_clipped():
    fig = charts.panels(**METRES)
    charts.add_points(fig, T, T, "query", values=[-1, 2, 3, 4, 50], scale=ERROR)
    bar = fig.layout.coloraxis.colorbar
    assert bar.title.text == "error (cm)"
    assert (bar.ticktext[0], bar.ticktext[-1]) == ("≤ 0", "≥ 10")
    assert fig.data[0].customdata[4] == [50.0], "under the pointer stands the value itself"


@pytest.mark.parametrize("is_log", [False, True])
@pytest.mark.parametrize(
    ("low", "high"), [(0.003, 21.3), (0.9, 11), (1, 1.1), (10, 10.5), (0.2, 99), (1e-9, 1e3)]
)
def test_no_two_ticks_of_a_colour_bar_touch_on_a_phone(low, high, is_log):
    fig = charts.panels(xlabel="x (m)", ylabel="y (m)")
    scale = charts.ColourScale("error (cm)", low=low, high=high, log=is_log)
    beyond = [low / 2, 2 * high]
    charts.add_points(fig, beyond, beyond, "dots", values=beyond, scale=scale)
    bar = fig.layout.coloraxis.colorbar
    places = 260 * np.subtract(bar.tickvals, bar.tickvals[0]) / np.ptp(bar.tickvals)
    shown = [re.sub("<.*?>", "", text) for text in bar.ticktext]
    widths = np.array([7 * len(text) for text in shown])  # digits of 12 pixels are 7 wide
    room = np.diff(places) - (widths[1:] + widths[:-1]) / 2
    assert (room > 2).all(), bar.ticktext
    assert (shown[0][0], shown[-1][0]) == ("≤", "≥")


def test_a_colour_bar_that_holds_all_values_does_not_say_so():
    fig = charts.panels(**METRES)
    charts.add_points(fig, T, T, "query", values=10 * T, scale=ERROR)
    assert fig.layout.coloraxis.colorbar.ticktext == ("0", "2", "4", "6", "8", "10")


def test_the_middle_of_a_scale_has_the_middle_colour():
    scale = ColourScale("distance (m)", low=1e-8, high=1, log=True, middle=1e-2, colours="RdBu_r")
    fig = charts.panels(**METRES)
    charts.add_map(fig, [1, 2], [1, 2, 3], np.geomspace(1e-8, 1, 6).reshape(3, 2), scale)
    places = [place for place, _ in fig.layout.coloraxis.colorscale]
    assert places[len(places) // 2] == pytest.approx(0.75)
    np.testing.assert_allclose(fig.data[0].z[0], [-8, -6.4])
    assert fig.data[0].customdata[2][1] == [1.0]


# ---- what is refused ----

FIG = charts.panels(**METRES)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: charts.lines(T, {}, **METRES), "series must hold"),
        (lambda: charts.lines(T, {"$q_1$": T}, **METRES), "write q<sub>1</sub>"),
        (lambda: charts.panels(xlabel="", ylabel="y"), "xlabel must be words"),
        (lambda: charts.panels(["a", "b"], xlabel=["x"], ylabel="y"), "xlabel must be one or 2"),
        (lambda: charts.panels([], **METRES), "titles must name at least one"),
        (lambda: charts.add_line(FIG, T, T[:3], "a"), "x has 5, y has 3"),
        (lambda: charts.add_line(FIG, T, T, "a", panel=1), "panel must be from 0 to 0; it is 1"),
        (lambda: charts.add_line(FIG, T, T + 1j, "a"), "y must be"),
        (lambda: charts.add_line(FIG, T, T, "a", details={"n": T[:2]}), r"details\['n'\] must have"),
        (lambda: charts.add_line(go.Figure(), T, T, "a"), "fig must be a chart that"),
        (lambda: charts.add_points(FIG, T, T, "a", values=T), "scale must say"),
        (lambda: charts.add_points(FIG, T, T, "a", values=T * np.nan, scale=ERROR), "all are NaN"),
        (lambda: charts.add_map(FIG, T, T, np.ones((2, 5)), ERROR), "values must"),
        (lambda: charts.add_bars(FIG, [0, 1], [1, 2], "a"), "edges must be one more than the 2"),
        (lambda: charts.add_rule(FIG), "give one of the two"),
    ],
)  # fmt: skip
def test_the_error_of_a_chart_names_the_argument(call, words):
    with pytest.raises(ValueError, match=words):
        call()


# ---- what is stored ----


def test_numbers_keep_a_hundred_thousandth_of_their_axis():
    figure = stored(go.Figure(go.Scatter(x=[1 / 3, -0.0, 1e-17], y=np.array([2e6 / 3, 1 / 3, 0]))))
    assert figure["data"][0]["x"] == [0.33333, 0, 0]
    assert str(figure["data"][0]["x"][1]) == "0.0", "and no minus"
    assert figure["data"][0]["y"] == [666670, 0, 0]


def test_an_axis_spans_its_range_or_all_series_on_it():
    fig = go.Figure([go.Scatter(x=[1 / 3], y=[1000 + 1 / 3]), go.Scatter(x=[200 / 3], y=[1001])])
    assert [series["x"] for series in stored(fig)["data"]] == [[0.333], [66.667]]
    assert stored(fig)["data"][0]["y"] == [1000.33333]
    fig.update_xaxes(range=[0, 1])
    assert stored(fig)["data"][0]["x"] == [0.3333]


def test_numbers_on_a_logarithmic_axis_keep_five_digits():
    fig = charts.lines(T + 1, {"a": 10.0 ** -np.arange(0, 20, 4) / 3}, **METRES, log="y")
    assert stored(fig)["data"][0]["y"][-1] == 3.3333e-17


def test_nan_and_infinities_become_null():
    figure = stored(go.Figure(go.Scatter(x=np.array([0, 1, 2.0]), y=[np.nan, np.inf, -np.inf])))
    assert figure["data"][0]["y"] == [None, None, None]
    json.dumps(figure, allow_nan=False)


def test_no_array_stays_packed():
    fig = go.Figure(go.Heatmap(z=np.arange(6, dtype=np.uint8).reshape(2, 3), x=np.arange(3)))
    assert stored(fig)["data"][0]["z"] == [[0, 1, 2], [3, 4, 5]]
    assert "bdata" not in json.dumps(stored(fig))


def test_the_last_bits_of_a_machine_do_not_reach_the_file():
    halves = np.arange(0, 40) / 64  # exactly between two numbers of five decimals
    for shaken in (halves * (1 + 2e-16), halves * (1 - 2e-16)):
        first = stored(charts.lines(halves, {"a": np.cos(halves)}, **METRES))
        again = stored(charts.lines(shaken, {"a": np.cos(shaken)}, **METRES))
        assert json.dumps(again) == json.dumps(first)


def test_a_figure_of_anybody_gets_the_style_of_the_course():
    plain = go.Figure(go.Scatter(y=[1, 2]))
    assert stored(plain)["layout"]["template"]["layout"]["colorway"] == list(COLOURS)
    own = go.Figure(go.Scatter(y=[1, 2]), layout={"template": "plotly_dark"})
    assert stored(own)["layout"]["template"]["layout"]["paper_bgcolor"] == "rgb(17,17,17)"


def test_no_figure_offers_to_upload_itself():
    config = stored(go.Figure(go.Scatter(y=[1, 2])))["config"]
    assert config["showSendToCloud"] is False
    assert config["displaylogo"] is False


def test_jupyterlab_fits_charts_itself():
    # With plotly's own "responsive" a chart has no height there once the theme is switched.
    assert "responsive" not in stored(go.Figure(go.Scatter(y=[1, 2])))["config"]


def test_show_stores_the_figure_with_its_alternative_text():
    output = shown(charts.lines(T, {"a": T}, **METRES, height=300))
    assert set(output.data) == {PLOTLY, "text/plain"}
    assert output.data["text/plain"] == ALT
    assert output.metadata["image/png"] == {"alt": ALT, "width": 700, "height": 300}


@pytest.mark.parametrize(
    ("fig", "words"),
    [
        (go.Figure(), "must hold at least one series"),
        ({"data": [{"type": "nonsense", "y": [1]}]}, "plotly can draw: .*nonsense"),
        ({"data": [{"y": [1], "colour": "red"}]}, "plotly can draw: .*colour"),
        ({"data": 3}, "plotly can draw"),
        (go.Figure(go.Scattermap(lat=[1], lon=[2])), r"data\[0\] is of type 'scattermap'"),
        (go.Figure(go.Scatter(y=[1]), {"images": [{"source": "http://a.b/c.png"}]}), "address"),
        (go.Figure(go.Scatter(y=[1], customdata=[object()])), "plotly can draw: .*object"),
        ([1, 2], "must be a plotly or matplotlib figure; it is of type list"),
    ],
)  # fmt: skip
def test_show_refuses_what_no_page_can_draw(fig, words):
    with pytest.raises(ValueError, match=words):
        show(fig, alt=ALT)


@pytest.mark.parametrize("alt", ["", "short", None])
def test_a_chart_without_words_is_refused(alt):
    with pytest.raises(ValueError, match="alt must say"):
        show(charts.lines(T, {"a": T}, **METRES), alt=alt)


def test_the_package_does_not_load_plotly_until_a_chart_is_made():
    source = "import sys, course_lib, course_lib.figures; print('plotly' in sys.modules)"
    output = subprocess.run([sys.executable, "-c", source], capture_output=True, text=True)
    assert output.stdout.strip() == "False"


# ---- charts of the notebooks ----


def test_all_samples_are_in_the_chart_with_their_cells():
    rng = np.random.default_rng(1)
    xy = rng.uniform(0, 1, (4000, 2))
    cell = np.minimum((xy * 5).astype(int), 4)
    fig = nb6.samples(xy, cell, np.zeros(2), np.ones(2), 5).fig
    dots, held = fig.data
    assert dots.type == "scattergl"
    np.testing.assert_allclose(np.stack([dots.x, dots.y], -1), xy, rtol=0, atol=5.1e-4)
    column, row = cell[0]
    assert held.z[row][column] == (cell == cell[0]).all(axis=1).sum()
    assert held.customdata[row][column] == [column, row]


def test_the_map_of_steps_shows_the_distances_and_the_runs():
    alphas, epsilons = np.geomspace(0.01, 10, 7), np.geomspace(0.01, 100, 5)
    errors = 10 ** np.linspace(-7, 0, 35).reshape(7, 5)
    runs = [(0.2, 2.0), (2.8, 2.0)]
    model = nb3.step_map(alphas, epsilons, errors, 2.5, runs, np.zeros(4), [1, 2], 200).stored()
    shown = str(model)
    for numbers in (np.log10(errors.T).round(2), np.log10(alphas).round(4)):
        assert str(numbers.tolist())[1:-1] in shown
    assert "'runs': [[0.2, 2.0], [2.8, 2.0]]" in shown


def test_bars_of_one_name_in_two_panels_have_one_colour():
    fig = charts.panels(["a", "b"], xlabel="x (m)", ylabel="count")
    for panel in (0, 1):
        charts.add_bars(fig, [0.0, 1.0], [3.0], "sample", panel=panel)
    first, second = fig.data
    assert first.marker.color == second.marker.color
    assert (first.showlegend, second.showlegend) == (True, False)


# ---- charts as stored in the notebooks ----

ROOT = Path(__file__).parents[1]
STORED = [
    (path.stem, cell.id, output)
    for path in sorted((ROOT / "notebooks").glob("[0-9][0-9]_*.ipynb"))
    for cell in nbformat.read(path, as_version=4).cells
    for output in cell.get("outputs", [])
    if PLOTLY in output.get("data", {})
]


def test_there_are_charts_in_the_notebooks():
    assert {"03_subproblems_damped_ik", "06_decomposition_ik"} <= {name for name, *_ in STORED}


@pytest.mark.parametrize(("notebook", "cell", "output"), STORED, ids=lambda part: str(part)[:20])
def test_each_chart_in_the_notebooks_has_a_picture_and_a_text(notebook, cell, output):
    picture = matplotlib.image.imread(BytesIO(base64.b64decode(output.data["image/png"])))
    metadata = output.metadata["image/png"]
    assert picture.shape[1] == pytest.approx(1.5 * metadata["width"], abs=1)
    assert picture.shape[0] == pytest.approx(1.5 * metadata["height"], abs=1)
    assert np.ptp(picture[..., :3]) > 0.5, "it is not empty"
    assert len(metadata["alt"]) > 50
    assert output.data["text/plain"] == metadata["alt"]


@pytest.mark.slow
def test_nbconvert_keeps_the_words_of_charts_and_plots(tmp_path):
    if not (Path(sys.prefix) / "share/jupyter/nbconvert/templates/lab_with_alt").exists():
        unavailable("the course is not installed in this environment")
    path = ROOT / "notebooks/06_decomposition_ik.ipynb"
    command = [
        sys.executable,
        "-m",
        "jupyter",
        "nbconvert",
        "--to",
        "html",
        "--output-dir",
        tmp_path,
    ]
    subprocess.run([*command, path], check=True, capture_output=True)
    page = BeautifulSoup((tmp_path / f"{path.stem}.html").read_text(), "html.parser")
    words = [image["alt"] for image in page.select(".jp-OutputArea-output img")]
    assert len(words) > 10
    assert not [alt for alt in words if "No description" in alt or len(alt) < 50]


def test_slides_by_nbconvert_are_slides():
    """The template that the course sets for pages would make slides a page, too."""
    installed = ROOT / "course_lib/pack/installed/etc/jupyter/jupyter_nbconvert_config.json"
    exporter = SlidesExporter(config=Config(json.loads(installed.read_text())))
    page, _ = exporter.from_notebook_node(new_notebook(cells=[new_markdown_cell("# A title")]))
    assert page.count("<section") == 2


# ---- in a browser ----

HOVER = """box => {
  const { x, y, width, height } = box.querySelector(".nsewdrag").getBoundingClientRect();
  return [x, y, width, height];
}"""
LETTERS = """box => Math.min(...[...box.querySelectorAll(".chart-live text")]
  .filter((text) => text.textContent).map((text) => parseFloat(getComputedStyle(text).fontSize)))"""


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    """A page with a curve whose values are known, and with ten charts by WebGL."""
    folder = tmp_path_factory.mktemp("charts")
    source = (
        "import numpy as np\nfrom course_lib.figures import charts, show\n"
        "x = np.arange(11.0)\n"
        "fig = charts.panels(xlabel='time (s)', ylabel='height (m)')\n"
        "charts.add_line(fig, x, x**2 / 10, 'a ball', markers=True)\n"
        "show(fig, alt='A curve that rises as a parabola does, to 10 m.')"
    )
    many = (
        "for k in range(10):\n"
        "    fig = charts.panels(xlabel='x (m)', ylabel='y (m)', equal=True)\n"
        "    charts.add_points(fig, *np.random.default_rng(k).normal(size=(2, 3000)), 'dots')\n"
        "    show(fig, alt=f'Three thousand dots that are scattered about, {k}.')"
    )
    cells = [nbformat.v4.new_markdown_cell("# Charts")]
    cells += [nbformat.v4.new_code_cell(text, id=f"c{i}") for i, text in enumerate((source, many))]
    book = folder / "notebooks" / "01_charts.ipynb"
    book.parent.mkdir()
    nbformat.write(nbformat.v4.new_notebook(cells=cells), book)
    notebooks.refresh(book)
    build(book.parent, folder / "html")
    return folder / "html" / "01_charts.html"


def drawn(visit, number=0):
    """Scroll to a chart; return its box when it is drawn."""
    box = visit.page.locator(".chart-figure").nth(number)
    box.scroll_into_view_if_needed()
    visit.page.wait_for_function("box => box.matches('.drawn')", arg=box.element_handle())
    return box


@pytest.mark.tools("browser")
@pytest.mark.parametrize("theme", ["light", "dark"])
def test_the_hover_label_on_a_page_shows_the_value_of_the_data(page, browser, theme):
    with Visit(browser, page, theme=theme) as visit:
        box = drawn(visit)
        x, y, *_ = box.evaluate(HOVER)
        shown_by = visit.page.evaluate(
            "box => { const { _fullLayout: { xaxis, yaxis } } = box.querySelector('.chart-live');"
            " return [xaxis.c2p(5), yaxis.c2p(2.5)]; }",
            box.element_handle(),
        )
        visit.page.mouse.move(x + shown_by[0] - 1, y + shown_by[1])
        visit.page.mouse.move(x + shown_by[0], y + shown_by[1])
        label = box.locator(".hoverlayer .hovertext")
        expect(label).to_contain_text("time: 5 s")
        expect(label).to_contain_text("height: 2.5 m")
        assert box.get_attribute("role") == "group"
        assert "parabola" in box.get_attribute("aria-label")
        assert [url for url in visit.requests if not url.startswith("file:")] == []
        assert len([url for url in visit.requests if "plotly.min.js" in url]) == 1
        assert visit.complaints == []


@pytest.mark.tools("browser")
def test_a_chart_stays_readable_on_a_phone(page, browser):
    """Nothing is wider than the page."""
    with Visit(browser, page, width=390) as visit:
        box = drawn(visit)
        assert box.evaluate(LETTERS) >= 10
        assert visit.page.evaluate("document.documentElement.scrollWidth") <= 390


@pytest.mark.tools("browser")
def test_the_keyboard_opens_a_table_with_all_that_hover_says(page, browser):
    with Visit(browser, page) as visit:
        numbers = visit.page.locator(".chart-numbers").first
        numbers.locator("summary").focus()
        visit.page.keyboard.press("Enter")
        rows = numbers.locator("tr").all_inner_texts()
        assert rows[0].split("\t") == ["time", "height"]
        assert rows[6].split("\t") == ["5 s", "2.5 m"]
        assert len(rows) == 12


@pytest.mark.tools("browser")
def test_charts_far_from_the_window_are_let_go(page, browser):
    with Visit(browser, page) as visit:
        for number in range(11):
            drawn(visit, number)
        first = visit.page.locator(".chart-figure").first.element_handle()
        visit.page.wait_for_function("box => !box.matches('.drawn')", arg=first)
        drawn(visit, 0)
        assert visit.complaints == []


# A page whose reader scrolls on and on, until `busy` is cleared.
SCROLLS_ON = "window.busy = setInterval(() => window.dispatchEvent(new Event('scroll')), 50);"


@pytest.mark.tools("browser")
def test_a_chart_is_drawn_when_the_reader_rests(page, browser):
    with Visit(browser, None, has_touch=False) as visit:
        visit.page.add_init_script(SCROLLS_ON)
        visit.page.goto(page.as_uri())
        visit.page.locator(".chart-figure").first.scroll_into_view_if_needed()
        visit.page.wait_for_load_state()
        visit.page.evaluate(SETTLED, 1000)
        assert not [url for url in visit.requests if "plotly.min.js" in url]
        visit.page.evaluate("clearInterval(window.busy)")
        drawn(visit, 0)


@pytest.mark.tools("browser")
def test_without_plotlys_script_the_picture_stays(page, browser):
    with Visit(browser, page, without="plotly.min.js") as visit:
        box = visit.page.locator(".chart-figure").first
        box.scroll_into_view_if_needed()
        expect(box.locator(".chart-still")).to_be_visible()
        assert "drawn" not in box.get_attribute("class")


@pytest.mark.parametrize(("session", "has_still"), [("", True), ("/home/student/01.ipynb", False)])
def test_the_stored_picture_stays_with_the_same_chart(session, has_still, tmp_path, monkeypatch):
    fig = charts.lines(T, {"a": T}, **METRES)
    data = {PLOTLY: stored(fig), "image/png": "iVBORw0KGgo="}
    cell = nbformat.v4.new_code_cell("fig")
    cell.outputs = [nbformat.v4.new_output("display_data", data=data)]
    nbformat.write(nbformat.v4.new_notebook(cells=[cell]), tmp_path / "01.ipynb")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("JPY_SESSION_NAME", session)
    stored_stills.cache_clear()
    assert (shown(fig).data.get("image/png") == "iVBORw0KGgo=") == has_still
    assert "image/png" not in shown(charts.lines(T, {"a": 2 * T}, **METRES)).data
    stored_stills.cache_clear()
