"""The page on the reports: what it says they print they print, and ours is what the notebooks have
computed."""

import json
import re
from pathlib import Path

import nbformat
import numpy as np
import pytest

from course_lib import arms, rigid, rotations

NOTEBOOKS = Path(__file__).parent.parent / "notebooks"
PAGE = (NOTEBOOKS / "reports.md").read_text(encoding="utf-8")
_, *PUBLISHED = json.loads(
    (NOTEBOOKS / "data/published.json").read_text()
).values()  # the first says what it is
PARTS = dict(
    zip(sorted(path.name for path in NOTEBOOKS.glob("0*.ipynb")), PUBLISHED, strict=False)
)  # the first six
NUMBER = r"-?\d+(?:\.\d+)?(?:e-?\d+)?"


def rows(notebook):
    """The rows of the table below the link to a notebook: what is printed, and ours."""
    (part,) = [part for part in PAGE.split("\n## ") if f"]({notebook}#Reproduce)" in part]
    lines = [
        [cell.strip() for cell in line.strip("|").split("|")]
        for line in re.findall(r"^\|.*", part, re.MULTILINE)
    ]
    return lines[2:]


def stored(notebook):
    """The numbers in what a notebook printed, as printed."""
    cells = nbformat.read(NOTEBOOKS / notebook, 4).cells
    return set(
        re.findall(
            NUMBER, " ".join(o.get("text", "") for cell in cells for o in cell.get("outputs", []))
        )
    )


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


@pytest.mark.parametrize("notebook", PARTS)
def test_each_number_is_the_reports_or_ours(notebook):
    table, numbers = rows(notebook), list(printed(PARTS[notebook]))
    assert table
    for what, theirs, ours in table:
        if theirs != "none":
            shown = float(theirs)
            digits = len(theirs.partition("e")[0].partition(".")[2])
            near = 0.51 * 10.0 ** (int(theirs.partition("e")[2] or 0) - digits)
            assert min(abs(shown - number) for number in numbers) <= near, what
        for number in re.findall(NUMBER, ours):
            assert number in stored(notebook), what


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


def test_published_poses_and_jacobians_follow_from_a_product_of_exponentials_and_finite_differences():
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
