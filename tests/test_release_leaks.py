"""Nothing that students are to find out themselves is in their zip: no solution, model answer,
rubric or output."""

import re

import nbformat
import pytest
from leaks import ROOT, answer_cells, secrets, texts
from test_bank import FILES, exercise_of, notebook_of

from course_lib.pack.release.bundle import collect


def may_say(exercise, name):
    """Whether a file may hold lines of a solution: the exercise's own check, which knows the
    answer."""
    own = re.fullmatch(r"course_lib/lessons/\w+/exercises/(\w+)\.py", name)
    return own is not None and own[1] in (exercise, f"{exercise}_mistakes")


def leaks(files, wanted):
    """The (exercise, file, text) that are found in the files."""
    return {
        (wanted[secret], name, secret)
        for name, content in files.items()
        for text in texts(name, content)
        for secret in wanted
        if secret in text
    }


@pytest.fixture(scope="module")
def files():
    return collect(ROOT)


@pytest.fixture(scope="module")
def wanted():
    return secrets()


@pytest.fixture(scope="module")
def found(files, wanted):
    return leaks(files, wanted)


def test_the_search_looks_for_every_answer(found, wanted):
    """test_site_leaks.py finds every answer by the same search, on the site that has them all."""
    assert len({exercise for exercise, *_ in found}) > 3
    assert set(wanted.values()) == {exercise for exercise, _ in answer_cells()}
    assert len(wanted) > 3 * len(set(wanted.values()))


EXERCISES = sorted({exercise for exercise, _ in answer_cells()})


@pytest.mark.parametrize("exercise", EXERCISES)
def test_no_part_of_an_answer_is_released(found, exercise):
    """Solutions, model answers and rubrics are looked for."""
    own = sorted(leak for leak in found if leak[0] == exercise and not may_say(*leak[:2]))
    lines = "\n".join(
        f"{name}, which students get, holds what answers {exercise}: {text}"
        for _, name, text in own
    )
    assert not own, f"\n{lines}\nSay it otherwise in one of the two."


@pytest.mark.parametrize("path", FILES, ids=[f"{notebook_of(path)}-{path.stem}" for path in FILES])
def test_no_hint_but_the_last_holds_a_line_of_the_solution(wanted, path):
    hints = {f"hint {k}": hint.encode() for k, hint in enumerate(exercise_of(path).hints[:-1], 1)}
    own = {secret: name for secret, name in wanted.items() if name == path.stem}
    assert leaks(hints, own) == set()


def test_no_output_goes_out_but_the_first_picture(files):
    for name in (name for name in files if name.endswith(".ipynb")):
        cells = nbformat.reads(files[name].decode(), 4).cells
        (first,) = (cell for cell in cells if cell.get("outputs") or cell.get("execution_count"))
        assert any("image/png" in output.get("data", {}) for output in first.outputs)
        assert not any("nbgrader" in cell.metadata for cell in cells[: cells.index(first)]), (
            "before all exercises"
        )


def test_markers_and_words_for_graders_are_gone(files):
    text = {name: content.decode() for name, content in files.items()}
    words = ["BEGIN SOLUTION", "END SOLUTION", "Model answer", "Rubric"]
    assert [(name, word) for name in text for word in words if word in text[name]] == []
