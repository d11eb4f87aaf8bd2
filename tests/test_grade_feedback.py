"""The pages that grading writes: everything from a submission is escaped, and nothing needs a
network."""

import re
import zipfile
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

import numpy as np
import pytest
from grade_stand_in import result
from scipy.stats import pearsonr
from site_visits import CONTRAST_ON_PAGE, Visit

from course_lib.checks.verdict import NOT_ATTEMPTED
from course_lib.pack.grade.hand_ins.collect import Submission
from course_lib.pack.grade.hand_ins.notebook_file import UNREADABLE
from course_lib.pack.grade.jobs import ungraded_result
from course_lib.pack.grade.marks.class_page import BLUE, class_page
from course_lib.pack.grade.marks.feedback import feedback_page, write_feedback
from course_lib.pack.grade.marks.marks_table import key
from course_lib.pack.grade.marks.tables import graded_files

EVIL = (
    "</pre><script>alert(1)</script><img src=x onerror=alert(1)>\"' &amp; $\\frac$ \ud800\x1b[31m "
    "{brace}"
)
TAGS = {
    "html",
    "head",
    "meta",
    "title",
    "style",
    "body",
    "main",
    "h1",
    "h2",
    "p",
    "strong",
    "a",
    "pre",
}
TAGS |= {"div", "table", "thead", "tbody", "tr", "th", "td", "span", "i", "code"}


class Read(HTMLParser):
    """The tags, attributes and text of a page."""

    def __init__(self, text):
        super().__init__()
        self.tags, self.attributes, self.text = set(), [], ""
        text.encode()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.tags.add(tag)
        self.attributes += attributes

    def handle_data(self, data):
        self.text += data


def of(student, points=(), texts=(), place=None, notebook="01_rotations", **changed):
    submission = Submission(
        student, notebook, place or f"{student}/{notebook}.ipynb", Path("nowhere")
    )
    return submission, result(points, texts, notebook, **changed)


def one(*outcome, rows=()):
    """The GradedFile of one outcome."""
    return graded_files([outcome], dict(rows))[0]


def evil_one():
    submission, evil = of(
        EVIL, [2, 0], [EVIL], place=EVIL, notebook=EVIL, release=EVIL, problems=[EVIL]
    )
    evil["exercises"][1] |= {"message": EVIL, "mistake": EVIL, "exercise": EVIL}
    return submission, evil


def assert_inert(text):
    """Assert that a page shows the evil text as text, runs nothing and asks for nothing."""
    read = Read(text)
    assert read.tags <= TAGS
    assert "<script>alert(1)</script>" in read.text
    assert not any(
        name.startswith("on") or name in ("src", "srcset", "action") for name, _ in read.attributes
    )
    places = ("#", "feedback/")
    assert all(value.startswith(places) for name, value in read.attributes if name == "href")
    assert not re.search(r"@import|url\(", text)
    assert ("content", "default-src 'none'; style-src 'unsafe-inline'") in read.attributes


def test_both_pages_escape_all_text_from_a_submission():
    assert_inert(feedback_page(one(*evil_one())))
    page = class_page([one(*evil_one())])
    assert_inert(page)
    assert page.count("<h2>") == 5
    assert class_page([one(*of("zoe", [2, 2]))]).count("<h2>") == 3, "without mistakes"
    assert class_page([one(*of("zoe"))]).count("<h2>") == 1, "without grades"


# ---- feedback ----


def test_feedback_shows_points_messages_marks_and_comments():
    submission, its = of("zoe", [2, 0, 0], ["because"])
    its["exercises"][2] |= {"state": NOT_ATTEMPTED, "message": ""}
    its["questions"].append(
        {"question": "explain_frame", "of": 2, "text": "so", "task": "**B.** Which frame's?"}
    )
    rows = {
        key("zoe", "01_rotations", "explain_frame", "so"): {
            "mark": "1.5",
            "comment": "Nearly: which axis?",
        }
    }
    read = Read(feedback_page(one(submission, its, rows=rows)))
    for words in (
        *(
            "3.5 of 10 points, 1 written answer",
            "zoe",
            "What should hold: it is a rotation.",
            "because",
            "✓ right",
        ),
        *(
            "✗ wrong",
            "○ not attempted",
            "to be read",
            "release 0.1.0-abc",
            "zoe/01_rotations.ipynb",
        ),
        *("explain_frame (B): read, 1.5 of 2", "Which frame's?", "Nearly: which axis?"),
    ):
        assert words in read.text
    assert "yet" not in read.text
    anchors = [value[1:] for name, value in read.attributes if name == "href"]
    assert anchors == ["exercise_1", "explain_0", "explain_frame"]
    assert all(("id", anchor) in read.attributes for anchor in anchors)


def test_feedback_has_weighted_subtotals_of_core_and_more():
    its = of("zoe", [2, 2, 0], ["because"], more=["exercise_1", "exercise_2"])
    for weight, words in [
        (1, ("4 of 8 points", "Core: 2 of 4 points", "More: 2 of 4 points")),
        (
            0.25,
            (
                "2.5 of 5 points",
                "Core: 2 of 4 points",
                "More: 2 of 4 points, which count 0.25 times: 0.5 of 1",
            ),
        ),
        (
            0,
            (
                "2 of 4 points",
                "Core: 2 of 4 points",
                "More: 2 of 4 points, which count 0 times: 0 of 0",
            ),
        ),
    ]:
        (each,) = graded_files([its], {}, weight=weight)
        page = feedback_page(each)
        found = re.findall(r"<strong>(.*?)</strong>|<h2>(.*?)</h2>", page)
        assert tuple(total or title for total, title in found) == words
        core, more = page.split("<h2>More")
        assert "exercise_0" in core
        assert "exercise_0" not in more
        assert ("points of More count" in class_page([each])) == (weight < 1)
        assert "01_rotations: exercise_2 (More)" in class_page([each])


def test_feedback_has_code_in_place_of_backticks():
    """Its heading is the title of the notebook."""
    submission, its = of("zoe", [0], ["Use `R`."])
    its["exercises"][0]["message"] = "Return `R <= 1`, please."
    its["questions"][0]["task"] = "**A.** Is `nearest_so(M)`\nthe best?"
    page = feedback_page(one(submission, its))
    assert "<h1>1 · Rotations</h1>" in page
    assert "Return <code>R &lt;= 1</code>, please." in page
    assert "A. Is <code>nearest_so(M)</code> the best?" in page
    assert "Use `R`." in page, "what the student wrote stays as it is"


def test_feedback_is_written_only_below_its_folder(tmp_path):
    """Each file that counts has feedback, and no other file has."""
    everything = graded_files(
        [
            of("zoe", [2], place="a"),
            of("zoe", [0], place="b"),
            of("zoe", [2], notebook="02_rigid_motion"),
            of("../../up", [2]),
            of("..", [2]),
            of("anna", [2], notebook="../../x"),
            of("", place="roster.csv"),
            (
                of("bob")[0],
                ungraded_result(of("bob")[0], "It is a link to another file.", "refused"),
            ),
        ],
        {},
    )
    folder = tmp_path / "out" / "feedback"
    write_feedback(folder, everything)
    written = sorted(
        path.relative_to(tmp_path).as_posix() for path in tmp_path.rglob("*") if path.is_file()
    )
    assert len(written) == 6
    assert all(path.startswith("out/feedback/") and path.count("/") == 3 for path in written)
    assert {"out/feedback/zoe/01_rotations.html", "out/feedback/zoe/02_rigid_motion.html"} <= set(
        written
    )
    assert "<strong>2 of 2 points" in (folder / "zoe/01_rotations.html").read_text()
    assert "It is a link" in (folder / "bob/01_rotations.html").read_text()

    write_feedback(folder, [each for each in everything if each.student == "zoe"])
    assert [path.name for path in folder.iterdir()] == ["zoe"]


def test_feedback_for_moodle_is_a_zip_of_moodle_s_folders(tmp_path):
    """Parts of a path before the last: a name without underscores, the participant's number, the
    plugin's two words.

    So is_valid_filename_for_import in moodle/moodle, mod/assign/feedback/file/importziplib.php,
    splits them.
    """
    outcomes = []
    for number, notebook in [(42, "01_rotations"), (43, "01_rotations"), (77, "02_rigid_motion")]:
        place = f"Zoë Ünal_{number}_assignsubmission_file/{notebook}.ipynb"
        fields = {"platform_id": str(number), "in_folder": True}
        submission = replace(of(f"zoe_{number}")[0], place=place, notebook=notebook, **fields)
        outcomes.append((submission, result([2], notebook=notebook)))
    write_feedback(tmp_path, graded_files(outcomes, {}))
    first = (tmp_path / "moodle/01_rotations.zip").read_bytes()
    with zipfile.ZipFile(tmp_path / "moodle/01_rotations.zip") as archive:
        folders, pages = zip(*(name.split("/") for name in archive.namelist()), strict=True)
        assert [folder.split("_")[1:4] for folder in folders] == [
            [n, "assignsubmission", "file"] for n in ("42", "43")
        ]
        assert set(pages) == {"feedback_01_rotations.html"}
        assert b"2 of 2 points" in archive.read(archive.namelist()[0])
    assert (tmp_path / "moodle/02_rigid_motion.zip").exists()
    write_feedback(
        tmp_path, graded_files([(replace(submission, notebook=""), result([], notebook=""))], {})
    )
    assert {path.name for path in (tmp_path / "moodle").iterdir()} == {"other files.zip"}
    write_feedback(tmp_path, graded_files(outcomes[:2], {}))
    assert {path.name for path in (tmp_path / "moodle").iterdir()} == {"01_rotations.zip"}
    assert (tmp_path / "moodle/01_rotations.zip").read_bytes() == first


# ---- the class ----


def a_class():
    outcomes = [of(f"s{i}", [2 * (i % 2), 2 * (i % 5 == 0), 2], ["because"]) for i in range(12)]
    twice = [of("s1", [points], notebook="02_rigid_motion", place=f"{points}") for points in (2, 0)]
    return graded_files([*outcomes, *twice], {})


def rows(page, title):
    """The cells of a section's table, without its head, and the widths of its bars."""
    section = page.partition(f"<h2>{title}</h2>")[2].partition("<h2>")[0]
    found = [
        re.findall(r"<td>(.*?)</td>", line)
        for line in section.partition("<tbody>")[2].split("</tr>")[:-1]
    ]
    return [[*cells, re.findall(r"width:([\d.]+)rem", bar)] for *cells, bar in found]


def test_the_class_page_shows_its_tables_with_bars():
    page = class_page(a_class())
    read = Read(page)
    points = rows(page, "Distribution of the points")
    assert points[5] == [
        "50 to 60 %",
        "6",
        ["8.00"],
    ]  # four of eight points; two are for the answer not read
    assert sum(int(count) for _, count, _ in points) == 12
    hardest = rows(page, "Hardest exercises")
    assert hardest[0][:5] == ["01_rotations: exercise_1", "3", "9", "0", "0"]
    assert hardest[0][5:] == ["25", "", ["2.00", "6.00"]]
    assert rows(page, "Most frequent mistakes")[0] == ["exercise_1: R^T is returned", "9", ["8.00"]]
    assert "12 students, 13 notebooks graded, 12 written answers still to be read" in read.text
    assert read.tags <= TAGS


def test_discrimination_is_the_correlation_with_the_other_points():
    """By scipy's stats.pearsonr on exercise 0, 1 and the marked answer, each against the sum of the
    other two."""
    draws = np.random.default_rng(3).integers(0, 3, (40, 3))
    outcomes = [of(f"s{i:02}", draw[:2].tolist(), ["so"]) for i, draw in enumerate(draws)]
    keys = [key(f"s{i:02}", "01_rotations", "explain_0", "so") for i in range(40)]
    marks = {its: {"mark": str(draw[2])} for its, draw in zip(keys, draws, strict=True)}
    wanted = []
    for item in range(3):
        found = pearsonr(draws[:, item], draws.sum(axis=1) - draws[:, item])
        low, high = found.confidence_interval()
        wanted.append(f"{found.statistic:.2f} ({low:.2f} to {high:.2f})")
    page = class_page(graded_files(outcomes, marks))
    hardest = {row[0]: row[-2] for row in rows(page, "Hardest exercises")}
    assert [hardest[f"01_rotations: exercise_{i}"] for i in (0, 1)] == wanted[:2]
    (question,) = re.findall(r"<td>(.*?)</td>", page.partition("<h2>Written answers")[2])[3:4]
    assert question == wanted[2]
    few = class_page(graded_files(outcomes[:19], marks))
    assert {row[-2] for row in rows(few, "Hardest exercises")} == {""}


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_both_pages_are_readable_in_both_themes(browser, tmp_path, theme):
    everything = a_class()
    (tmp_path / "class.html").write_text(class_page(everything), encoding="utf-8")
    (tmp_path / "one.html").write_text(feedback_page(everything[0]), encoding="utf-8")
    for name in "class.html", "one.html":
        visit = Visit(browser, tmp_path / name, theme=theme, width=400)
        elements = visit.page.query_selector_all("h1, h2, p, td, th, a, pre")
        assert len(elements) > 10
        assert min(element.evaluate(CONTRAST_ON_PAGE) for element in elements) > 4.5
        assert visit.page.evaluate("document.documentElement.scrollWidth") <= 400
        assert visit.complaints == []
        assert [url for url in visit.requests if not url.startswith("file:")] == []
        visit.context.close()


def test_the_class_page_links_to_each_students_feedback(tmp_path):
    outcomes = [of(student, [2]) for student in ("Zoë Ü", "a%2e?#b", 'x"><script>')]
    everything = graded_files(outcomes, {})
    write_feedback(tmp_path / "feedback", everything)
    links = [value for name, value in Read(class_page(everything)).attributes if name == "href"]
    assert len(links) == 3
    assert all((tmp_path / unquote(link)).is_file() for link in links)


def test_the_class_page_has_a_key_to_its_colours():
    page = class_page(a_class())
    head = page.partition("<h2>Hardest exercises")[2].partition("</thead>")[0]
    for colour in set(re.findall(r"background:(#\w+)", page.partition("<h2>Hardest")[2])):
        assert colour == BLUE or f'class="key" style="background:{colour}"' in head


# ---- what is counted ----


def test_the_class_page_counts_ungraded_files_separately():
    outcomes = [of(f"s{i}", [2, 2]) for i in range(4)]
    broken = of("s4", [0, 0])
    for exercise in broken[1]["exercises"]:
        exercise["state"] = UNREADABLE
    refused = of("s5")[0]
    outcomes += [
        broken,
        (refused, ungraded_result(refused, "It is a link to another file.", "refused")),
    ]
    read = Read(class_page(graded_files(outcomes, {})))
    said = (
        "6 students, 4 notebooks graded, 2 more handed in but refused or unreadable (not in the "
        "means below)"
    )
    assert said in read.text
    assert "01_rotations6 4 4.0 4 4".replace(" ", "") in "".join(read.text.split())
