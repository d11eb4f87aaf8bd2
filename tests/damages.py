"""Ways in which a student's notebook differs from what JupyterLab saved, for tests of updates.

Each function takes a notebook as JSON has it, and returns another one, or the bytes of a file.
"""

import copy
import json
import re
import zlib


def name_of(cell):
    """The exercise that a cell answers, or ""."""
    about = cell["metadata"].get("nbgrader", {})
    return about.get("grade_id", "") if about.get("solution") else ""


def new_cell(source, kind="code"):
    cell = {
        "cell_type": kind,
        "id": f"mine-{zlib.crc32(source.encode('utf-8', 'replace'))}",
        "metadata": {},
        "source": source,
    }
    return cell | ({"execution_count": None, "outputs": []} if kind == "code" else {})


def encoded(book):
    return json.dumps(book, indent=1, ensure_ascii=False).encode("utf-8", "surrogatepass")


# ---- what can be read: all answers arrive ----


def as_saved(book):
    return book


def with_a_byte_order_mark(book):
    return b"\xef\xbb\xbf" + encoded(book)


def in_utf_16(book):
    return encoded(book).decode().encode("utf-16")


def in_utf_16_without_a_mark(book):
    return encoded(book).decode().encode("utf-16-le")


def with_the_line_ends_of_windows(book):
    for cell in book["cells"]:
        cell["source"] = "".join(cell["source"]).replace("\n", "\r\n")
    return encoded(book).replace(b"\n", b"\r\n")


def without_metadata_of_cells(book):
    for cell in book["cells"]:
        cell["metadata"] = {}
    return book


def with_cells_that_have_no_entry_for_metadata(book):
    for cell in book["cells"]:
        del cell["metadata"]
    return book


def without_any_metadata(book):
    return without_metadata_of_cells(book) | {"metadata": {}}


def without_ids(book):
    for cell in book["cells"]:
        cell.pop("id", None)
    return book | {"nbformat_minor": 4}


def without_metadata_or_ids(book):
    return without_ids(without_any_metadata(book))


def with_cells_in_another_order(book):
    return book | {"cells": book["cells"][::-1]}


def with_answers_that_became_raw(book):
    for cell in book["cells"]:
        if name_of(cell):
            cell["cell_type"] = "raw"
    return book


def with_all_cells_turned_to_markdown(book):
    for cell in book["cells"]:
        cell["cell_type"] = "markdown"
    return book


def with_all_cells_turned_to_code(book):
    for cell in book["cells"]:
        cell["cell_type"] = "code"
    return book


def with_raw_answers_that_lost_metadata_and_ids(book):
    return without_metadata_or_ids(with_answers_that_became_raw(book))


def with_answers_that_are_split(book):
    cells = []
    for cell in book["cells"]:
        lines = "".join(cell["source"]).splitlines(keepends=True)
        cells.append(cell)
        if name_of(cell) and len(lines) > 1:
            rest = copy.deepcopy(cell) | {
                "id": f"{cell['id'][:50]}-2",
                "source": "".join(lines[1:]),
            }
            cell["source"] = lines[0]
            cells.append(rest)
    return book | {"cells": cells}


def with_own_cells_between(book):
    cells = []
    for number, cell in enumerate(book["cells"]):
        cells += [cell, new_cell(f"mine = {number}"), new_cell(f"Note {number}.", "markdown")]
    return book | {"cells": cells}


def with_answers_that_are_duplicated(book):
    cells = []
    for cell in book["cells"]:
        cells.append(cell)
        if name_of(cell):
            cells.append(copy.deepcopy(cell) | {"id": f"{cell['id'][:50]}-copy"})
    return book | {"cells": cells}


def with_a_copy_as_raw_beside_each_answer(book):
    cells = []
    for cell in book["cells"]:
        if name_of(cell):
            text = "An idea:\n" + "".join(cell["source"])
            cells.append(copy.deepcopy(cell) | {"id": f"{cell['id'][:50]}-old", "source": text})
            cells[-1]["cell_type"] = "raw"
        cells.append(cell)
    return book | {"cells": cells}


def in_format_3(book):
    cells = []
    for cell in without_ids(book)["cells"]:
        if cell["cell_type"] == "code":
            cell["input"] = cell.pop("source")
        cells.append(cell)
    return {"metadata": {}, "nbformat": 3, "nbformat_minor": 0, "worksheets": [{"cells": cells}]}


def with_a_huge_output(book):
    code = next(cell for cell in book["cells"] if cell["cell_type"] == "code")
    output = {"output_type": "stream", "name": "stdout", "text": "x" * 10_000_000}
    return book | {"cells": [*book["cells"], copy.deepcopy(code) | {"outputs": [output]}]}


def with_a_number_of_five_thousand_digits(book):
    return encoded(book).replace(b'"nbformat": 4', b'"own": ' + b"7" * 5000 + b', "nbformat": 4')


def with_half_a_character(book):
    return book | {"cells": [*book["cells"], new_cell("print('\ud83e')")]}


def with_cells_that_are_none(book):
    odd = [None, 7, "text", {}, {"cell_type": None, "metadata": 3, "source": None, "id": 5}]
    odd.append({"metadata": {"nbgrader": [1]}, "source": [1, None], "cell_type": "code"})
    return book | {"cells": [*odd, *book["cells"], *odd]}


def with_metadata_of_other_programs(book):
    for cell in book["cells"]:
        cell["metadata"] |= {"colab": {"base_uri": "x"}, "id": "Zm9v", "ExecuteTime": [1, 2]}
    return book


# ---- what holds some answers elsewhere ----


def with_answers_pasted_into_own_cells(book):
    """The answer cells are as they were released, and own cells below them hold the answers."""
    cells = []
    for cell in book["cells"]:
        cells.append(cell)
        if name_of(cell):
            text, kind = "".join(cell["source"]), cell["cell_type"]
            cells.append(new_cell(text, kind))
            cell["source"] = re.sub(r"(?s).*", "", text)
    return book | {"cells": cells}


def with_answers_pasted_into_other_answers(book):
    """Each second answer stands in the cell of the one before, below its answer."""
    answers = [cell for cell in book["cells"] if name_of(cell)]
    for first, second in zip(answers[::2], answers[1::2], strict=False):
        first["source"] = "".join(first["source"]) + "\n\n" + "".join(second["source"])
        second["source"] = ""
    return book


def with_exercises_that_are_gone(book):
    for cell in book["cells"]:
        if name_of(cell):
            cell["metadata"]["nbgrader"]["grade_id"] += "_of_before"
    return book


# ---- what cannot be read ----


def empty(book):
    return b""


def full_of_zeros(book):
    return bytes(5000)


def cut_off(book):
    return encoded(book)[:-5000]


def cut_off_within_a_text(book):
    content = encoded(book)
    return content[: content.index(b'"source"') + 12]


def half_merged(book):
    lines = encoded(book).decode().split("\n")
    ours, theirs = lines[10], lines[10]
    lines[10:11] = ["<<<<<<< HEAD", ours, "=======", theirs, ">>>>>>> main"]
    return "\n".join(lines).encode()


def in_latin_1(book):
    return encoded(book).decode().encode("latin-1", "replace") + "é".encode("latin-1")


def nested_too_deeply(book):
    return b"[" * 200_000


def a_list(book):
    return b"[1, 2]"


def without_cells(book):
    return {"metadata": {}, "nbformat": 4, "nbformat_minor": 5}


def a_web_page(book):
    return b"<!DOCTYPE html><html><body>Sign in</body></html>"


def two_notebooks_in_one(book):
    return encoded(book) + encoded(book)


READABLE = (
    as_saved,
    with_a_byte_order_mark,
    in_utf_16,
    in_utf_16_without_a_mark,
    with_the_line_ends_of_windows,
    without_metadata_of_cells,
    with_cells_that_have_no_entry_for_metadata,
    without_any_metadata,
    without_ids,
    without_metadata_or_ids,
    with_cells_in_another_order,
    with_answers_that_became_raw,
    with_all_cells_turned_to_markdown,
    with_all_cells_turned_to_code,
    with_raw_answers_that_lost_metadata_and_ids,
    with_answers_that_are_split,
    with_own_cells_between,
    with_answers_that_are_duplicated,
    with_a_copy_as_raw_beside_each_answer,
    with_a_huge_output,
    with_half_a_character,
    with_cells_that_are_none,
    with_metadata_of_other_programs,
)
ELSEWHERE = (
    with_answers_pasted_into_own_cells,
    with_answers_pasted_into_other_answers,
    with_exercises_that_are_gone,
)
UNREADABLE = (
    empty,
    full_of_zeros,
    cut_off,
    cut_off_within_a_text,
    half_merged,
    in_latin_1,
    nested_too_deeply,
    a_list,
    without_cells,
    a_web_page,
    two_notebooks_in_one,
    in_format_3,
    with_a_number_of_five_thousand_digits,
)
