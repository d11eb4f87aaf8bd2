"""The page on the reports: numbers, errors and figures, theirs as printed, ours as the notebooks
hold them."""

import json
import re
from functools import cache
from pathlib import Path

import nbformat
import numpy as np
import pytest

from course_lib import arms, rigid, rotations
from course_lib.pack.site import heading_anchor

NOTEBOOKS = Path(__file__).parent.parent / "notebooks"
PAGE = (NOTEBOOKS / "reports.md").read_text(encoding="utf-8")
_, *PUBLISHED = json.loads(
    (NOTEBOOKS / "data/published.json").read_text()
).values()  # the first says what it is
PARTS = dict(
    zip(sorted(path.name for path in NOTEBOOKS.glob("0*.ipynb")), PUBLISHED, strict=False)
)  # the first six
NUMBER = r"-?\d+(?:\.\d+)?(?:e-?\d+)?"
LINK = re.compile(r"\[[^\]]+\]\(([\w.]+)#((?:[^()]|\([^()]*\))+)\)")


def table(notebook, first_column):
    """The rows of one of the tables in the part of a notebook, by the name of its first column."""
    (part,) = [part for part in PAGE.split("\n## ") if f"]({notebook}#Reproduce)" in part]
    tables = [text for text in part.split("\n\n") if text.startswith(f"| {first_column} |")]
    lines = [line for text in tables for line in text.splitlines()[2:]]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]


@cache
def cells_of(notebook):
    return nbformat.read(NOTEBOOKS / notebook, 4).cells


@cache
def stored(notebook):
    """The numbers in what a notebook printed, as printed."""
    outputs = [output for cell in cells_of(notebook) for output in cell.get("outputs", [])]
    return set(re.findall(NUMBER, " ".join(output.get("text", "") for output in outputs)))


@cache
def sections(notebook):
    """The text and the outputs below each heading of a notebook, by the heading's anchor."""
    texts, levels = {}, []
    for cell in cells_of(notebook):
        pieces = [cell.source]
        if cell.cell_type == "markdown":
            pieces = re.split(r"^(?=#{2,4} )", cell.source, flags=re.MULTILINE)
        for output in cell.get("outputs", []):
            pieces.append(output.get("text", ""))
            data = output.get("data", {})
            pieces += [data.get(kind, "") for kind in ("text/markdown", "text/plain")]
        for number, piece in enumerate(pieces):
            heading = re.match(r"(#{2,4}) (.*)", piece)
            if cell.cell_type == "markdown" and heading and number < len(pieces):
                level, anchor = len(heading[1]), heading_anchor(heading[2])
                levels = [kept for kept in levels if kept[0] < level] + [(level, anchor)]
            for _, anchor in levels:
                texts[anchor] = texts.get(anchor, "") + "\n" + piece
    return texts


def printed(value):
    """All numbers of a part of published.json, the distances of its corrections, and lengths in
    centimetres, too."""
    if isinstance(value, dict):
        if {"input", "published"} <= set(value):
            given, corrected = np.array(value["input"]), np.array(value["published"])
            if (
                corrected[-1] == np.eye(len(corrected))[-1]
            ).all():  # a pose: only its rotation is corrected
                given, corrected = given[:-1, :-1], corrected[:-1, :-1]
            yield np.linalg.norm(given - corrected)
        for part in value.values():
            yield from printed(part)
    elif isinstance(value, list):
        for part in value:
            yield from printed(part)
    elif isinstance(value, int | float):
        yield from (value, 100 * value)


def digits_that_agree(theirs, ours):
    """How many significant digits of a printed number agree, and how many it has."""
    significant = len(re.sub(r"e.*|\.", "", theirs).lstrip("-0"))
    first = np.floor(np.log10(abs(float(theirs))))
    off = abs(float(theirs) - float(ours))
    agree = sum(off <= 0.5 * 10.0 ** (first - n) for n in range(significant))
    return f"{agree} of {significant}"


@pytest.mark.parametrize("notebook", PARTS)
def test_each_number_is_the_reports_or_ours(notebook):
    rows, numbers = table(notebook, "quantity"), list(printed(PARTS[notebook]))
    assert rows
    for what, theirs, ours, _ in rows:
        if theirs != "none":
            shown = float(theirs)
            digits = len(theirs.partition("e")[0].partition(".")[2])
            near = 0.51 * 10.0 ** (int(theirs.partition("e")[2] or 0) - digits)
            assert min(abs(shown - number) for number in numbers) <= near, what
        for number in re.findall(NUMBER, ours):
            assert number in stored(notebook), what


@pytest.mark.parametrize("notebook", PARTS)
def test_the_digits_that_agree_are_counted_right(notebook):
    for what, theirs, ours, agreement in table(notebook, "quantity"):
        if agreement == "in the range":
            low, high = map(float, re.findall(NUMBER, ours))
            assert low < float(theirs) < high, what
        elif agreement not in ("–", "misprint"):
            assert agreement == digits_that_agree(theirs, ours), what
        else:
            assert theirs == "none" or float(theirs) != ours, what


@pytest.mark.parametrize("notebook", PARTS)
def test_every_error_is_listed_with_a_quoted_line(notebook):
    words = "\n".join(cell.source for cell in cells_of(notebook) if cell.cell_type == "markdown")
    titles = re.findall(r"^#### (\d+) · (.*)$", words, re.MULTILINE)
    rows = table(notebook, "error")
    listed = [re.match(r"\[(\d+)\]\(\S+\) (.*)", title).groups() for title, _ in rows]
    assert listed == titles
    for title, line in rows:
        quoted = re.findall(r'^"(.*)"|^`(.*)`|^(\$.*\$)', line)
        assert quoted, f"{title}: quote the line"
        (quotation,) = [text for text in quoted[0] if text]
        assert quotation in words, title


@pytest.mark.parametrize("notebook", PARTS)
def test_every_figure_is_linked_to_the_section_with_ours(notebook):
    rows, texts = table(notebook, "figure"), sections(notebook)
    assert rows
    for figure, what, ours in rows:
        name, anchor = LINK.match(ours).groups()
        assert name == notebook, figure
        assert anchor in texts, f"{figure}, {what}: no section {anchor}"
        (words,) = re.findall(r"\): \*(.+)\*$", ours)
        assert words in texts[anchor], f"{figure}, {what}: {words!r} is not in {anchor}"


def test_the_numbered_figures_of_two_reports_are_all_listed():
    for notebook, count in (("03_subproblems_damped_ik.ipynb", 12), ("04_poe_kuka_iiwa.ipynb", 16)):
        numbers = [int(n) for row in table(notebook, "figure") for n in row[0].split(", ")]
        assert numbers == list(range(1, count + 1)), notebook


def test_each_link_leads_to_a_section():
    for name, anchor in LINK.findall(PAGE):
        assert anchor in sections(name), f"{name} has no section {anchor}"


def test_the_two_bases_of_the_public_cases_follow_from_the_data():
    """A second way: base and offset of the end frame together, by linear least squares, one base
    for four sets."""
    table = np.genfromtxt(
        NOTEBOOKS / "data/panda_ik_cases.csv", delimiter=",", names=True, dtype=None
    )
    numbers = np.array([list(row)[1:] for row in table])
    flange = arms.panda().fk(numbers[:, :7])
    for base, sets in (([-0.2, 0.13, 0.6], "easy medium hard hard_ta"),
                       ([-0.13, 0.13, 0.5], "devil easy_ta medium_ta devil_ta")):  # fmt: skip
        rows = [np.flatnonzero(table["set"] == name) for name in sets.split()]
        next_start = flange[np.concatenate([row[1:] for row in rows])]
        target = numbers[np.concatenate([row[:-1] for row in rows]), 7:10]
        A = np.concatenate(
            [np.broadcast_to(np.eye(3), (len(target), 3, 3)), next_start[:, :3, :3]], 2
        ).reshape(-1, 6)
        found = np.linalg.lstsq(A, (target - next_start[:, :3, 3]).ravel())[0]
        np.testing.assert_allclose(found, [*base, 0, 0, -0.037], atol=1.5e-3)


def test_published_jacobians_follow_from_a_second_method():
    """A second way, without DH parameters and cross products: screws from the arm, columns from
    differences."""
    table = np.genfromtxt(
        NOTEBOOKS / "data/panda_fk_cases.csv", delimiter=",", skip_header=1, usecols=range(1, 57)
    )
    q, published = table[:, :7], table[:, 14:].reshape(-1, 6, 7)
    to_e = rigid.transform(rotations.rot_z(-np.pi / 4), [0, 0, -0.037])

    def end(angles):
        T = panda.home[-1] @ to_e
        for screw, angle in zip(panda.screw_axes[::-1], angles.T[::-1], strict=True):
            T = rigid.exp_se3(angle[:, None] * screw) @ T
        return T

    panda, h = arms.panda(), 1e-6
    T = end(q)
    np.testing.assert_allclose(T[:, :3, 3] + [-0.2, 0.13, 0.6], table[:, 7:10], atol=1.5e-3)
    for i, step in enumerate(h * np.eye(7)):
        change = (end(q + step) - end(q - step)) / (2 * h)
        spin = change[:, :3, :3] @ T[:, :3, :3].mT
        omega = np.stack([spin[:, 2, 1], spin[:, 0, 2], spin[:, 1, 0]], -1)
        column = np.concatenate([change[:, :3, 3], omega], -1)
        np.testing.assert_allclose(column, published[:, :, i], atol=2e-5)
