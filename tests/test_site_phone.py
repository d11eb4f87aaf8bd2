"""What a page does for a narrow window: tables, formulas, pictures beside each other, and captions that
name no side."""

import re
from pathlib import Path

import nbformat
import numpy as np
import pytest
from nbformat.v4 import new_markdown_cell
from plotly.graph_objects import Figure
from site_notebooks import cell, output, write
from site_visits import OPEN, Visit
from sphinx_builds import build

from course_lib.figures.stills import TOY
from course_lib.figures.stored_chart import PLOTLY, stored
from course_lib.lessons.rotations.figures import frames

pytestmark = pytest.mark.slow  # Sphinx builds a site of its own for these tests

NOTEBOOKS = sorted(Path(__file__).parent.parent.glob("notebooks/0*.ipynb"))

TEXT = r"""# Narrow

| place | what works there, and how you open it | how we know that it works there |
| --- | --- | --- |
| here | all that is in the notebooks works, as soon as one command was typed there | every change of the course is tested |
| there | only pictures are shown, because no script runs | nobody has tried it |

| name | report | ours |
| --- | --- | --- |
| a length | 1.0762 | 1.0723 |

"""

# Formulas of more and more letters: some of them are a little too wide for a phone.
LETTERS = "abcdefghijklmnopqrst"
FORMULAS = "\n".join(f"- Here ${' + '.join(LETTERS[:n])} = 9$ is." for n in range(6, 21))


def two_spheres():
    """A chart of two pictures in space beside each other, each with words above it."""
    fig = Figure(layout={"height": 430})
    for number in range(2):
        scene = f"scene{number + 1}" if number else "scene"
        fig.add_scatter3d(
            x=[0, 1],
            y=[0, 1],
            z=[0, 1],
            scene=scene,
            hovertemplate="R e<sub>x</sub> = (%{x:.2f}, %{y:.2f}, %{z:.2f})<extra></extra>",
        )
        fig.update_layout(
            {scene: {"domain": {"x": [number / 2, (number + 1) / 2], "y": [0, 0.88]}}}
        )
        fig.add_annotation(
            text=f"sphere {number}", x=(number + 0.5) / 2, y=1, xref="paper", yref="paper"
        )
    return fig


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    folder = tmp_path_factory.mktemp("narrow")
    turned = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    drones = frames({"start": np.eye(3), "after 10 s": turned, "after 20 s": 1.3 * turned})
    write(
        folder / "notebooks",
        "01.ipynb",
        new_markdown_cell(f"{TEXT}\n{FORMULAS}"),
        cell(output({TOY: drones.stored(), "text/plain": drones.alt})),
        cell(output({PLOTLY: stored(two_spheres()), "text/plain": "Two spheres."})),
    )
    build(folder / "notebooks", folder / "html")
    return folder / "html" / "01.html"


@pytest.fixture(scope="module")
def phone(page, browser):
    with Visit(browser, page, width=390) as visit:
        visit.page.evaluate(OPEN)
        yield visit


def test_a_row_of_long_texts_is_a_list_with_column_names(phone):
    cells = phone.page.locator(".stacked-table").first.locator("tbody tr").first.locator("td")
    names = cells.evaluate_all('tds => tds.map((td) => getComputedStyle(td, "::before").content)')
    assert [name.strip('"').removesuffix(": ") for name in names] == [
        "place",
        "what works there, and how you open it",
        "how we know that it works there",
    ]
    assert min(cells.evaluate_all("tds => tds.map((td) => td.clientWidth)")) > 300


def test_a_table_of_short_texts_keeps_its_columns_and_fits(phone):
    table = phone.page.locator("article table").nth(1)
    assert "stacked-table" not in table.get_attribute("class")
    assert table.evaluate("table => table.scrollWidth <= table.parentElement.clientWidth")
    assert (
        len(set(table.locator("tbody td").evaluate_all("tds => tds.map((td) => td.offsetTop)")))
        == 1
    )


def test_a_formula_a_little_too_wide_is_set_smaller(phone):
    formulas = phone.page.locator("li .math.wide").evaluate_all(
        """formulas => formulas.map((formula) =>
          [formula.style.fontSize, formula.scrollWidth / formula.clientWidth])"""
    )
    sizes = [float(size.removesuffix("em")) for size, _ in formulas if size]
    assert sizes
    assert min(sizes) >= 0.85
    assert all(share == 1 for size, share in formulas if size), "it fits then"
    assert [share for size, share in formulas if not size and 1 < share < 1 / 0.86] == []
    assert max(share for _, share in formulas) > 1.2, "a long one scrolls"


def test_the_titles_of_things_beside_each_other_do_not_touch(phone):
    box = phone.page.locator(".toy-figure")
    box.scroll_into_view_if_needed()
    box.locator(".course-toy .word").first.wait_for()
    words = box.locator(".word").evaluate_all(
        """words => words.map((word) => {
          const { x, y, width, height } = word.getBoundingClientRect();
          return [word.textContent, x, y, width, height];
        })"""
    )
    titles = [place for place in words if place[0] in ("start", "after 10 s", "after 20 s")]
    assert len(titles) == 3
    middles = [x + width / 2 for _, x, _, width, _ in titles]
    assert min(np.diff(middles)) > 80, "each stands above its own drone"


def test_pictures_in_space_are_stacked_with_their_titles(phone):
    chart = phone.page.locator(".chart-figure")
    chart.scroll_into_view_if_needed()
    chart.locator(".annotation").first.wait_for()
    layout = chart.locator(".chart-live").evaluate(
        """live => ({
          domains: [live.layout.scene.domain, live.layout.scene2.domain],
          words: live.layout.annotations.map(({ x, y }) => [x, y]),
        })"""
    )
    upper, lower = layout["domains"]
    assert upper["x"] == lower["x"] == [0, 1]
    assert upper["y"][0] > lower["y"][1]
    (first_x, first_y), (second_x, second_y) = layout["words"]
    assert first_x == second_x == 0.5
    assert first_y > upper["y"][1]
    assert lower["y"][1] < second_y < upper["y"][0]


def test_the_numbers_of_a_picture_in_space_have_its_name(phone):
    details = phone.page.locator(".chart-numbers")
    details.evaluate("details => (details.open = true)")
    details.locator("table").first.wait_for()
    assert details.locator("caption").all_text_contents() == ["sphere 0", "sphere 1"]
    assert details.locator("th").first.text_content() == "R ex"


SIDES = re.compile(r"\b(on the (left|right)|the (left|right) (panel|picture|plot)|(Left|Right),)")


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem[:2])
def test_no_caption_names_a_side_of_panels(notebook):
    captions = [
        made.get("metadata", {}).get("caption", "")
        for part in nbformat.read(notebook, as_version=4).cells
        if part.cell_type == "code" and any(map(is_stacked, part.outputs))
        for made in part.outputs
    ]
    assert any(captions)
    assert [caption for caption in captions if SIDES.search(caption)] == []


def is_stacked(made):
    """Whether a phone shows the panels of an output below each other."""
    layout = made.get("data", {}).get(PLOTLY, {}).get("layout", {})
    columns = (layout.get("meta") or {}).get("columns", 1)
    scenes = sum(key.startswith("scene") for key in layout)
    cuts = made.get("metadata", {}).get("image/png", {}).get("cuts")
    return columns > 1 or scenes > 1 or bool(cuts)
