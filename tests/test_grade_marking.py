"""Written answers are marked in the browser by keys, from the disk, and questions.csv is what the
next run reads."""

import csv
import json
import re

import grade_stand_in
import pytest
from grade_stand_in import hand_in
from site_visits import CONTRAST_ON_PAGE, Visit

from course_lib.pack.grade.__main__ import main

EVIL = [
    "</script><script>document.title = 'owned'</script><img src=x onerror=\"document.title='owned'\">",
    '=HYPERLINK("http://x"), "quoted"\n\n+ and another line',
    "An answer \u2028 with <b>tags</b> & a picture ![p](attachment:a.png)",
]


def graded(content, notebook, seed):
    texts = json.loads(content)["texts"]
    found = grade_stand_in.result([2], texts, notebook)
    for question in found["questions"]:
        question["task"] = "**A.** What does `R` do?"
    return found


class Marking:
    """A class of ten with three written answers each, and its page in a browser."""

    def __init__(self, folder, browser):
        self.folder, self.browser = folder, browser
        for number in range(10):
            texts = [f"{EVIL[(number + i) % 3]} {number}" for i in range(3)]
            hand_in(folder / "in", f"student{number}/01_rotations.ipynb", texts=texts)
        self.out = folder / "out"
        self.grade()
        self.visit = Visit(browser, self.out / "questions.html", width=1280)
        self.page = self.visit.page

    def grade(self):
        arguments = [str(self.folder / "in"), "--output", str(self.out), "--jobs", "1"]
        assert main(arguments, grade=graded) == 0

    def press(self, *keys):
        for key in keys:
            self.page.keyboard.press(key)

    def save(self):
        with self.page.expect_download() as download:
            self.press("w")
        download.value.save_as(self.out / "questions.csv")

    def rows(self):
        with (self.out / "questions.csv").open(encoding="utf-8-sig", newline="") as file:
            return list(csv.DictReader(file))

    def text(self, element):
        return self.page.text_content(f"#{element}")


@pytest.fixture
def marking(browser, tmp_path):
    shown = Marking(tmp_path, browser)
    yield shown
    shown.visit.context.close()


def test_thirty_answers_marked_by_keys_are_read_by_the_next_run(marking):
    for number in range(30):
        marking.press(str(number % 3), "Enter")
    assert marking.text("count").startswith("30 of 30 have points")
    marking.save()
    marks = [row["mark"] for row in marking.rows()]
    assert marks == [str(number % 3) for number in range(30)]
    marking.grade()
    assert {row["state"] for row in marking.rows()} == {"read"}
    assert [row["mark"] for row in marking.rows()] == marks
    assert marking.visit.complaints == []
    assert [url for url in marking.visit.requests if not url.startswith(("file:", "blob:"))] == []


def test_the_saved_table_differs_in_nothing_but_the_marks(marking):
    before = (marking.out / "questions.csv").read_bytes()
    marking.save()
    assert (marking.out / "questions.csv").read_bytes() == before


def test_a_comment_like_a_formula_comes_back_as_it_was_typed(marking):
    marking.press("c")
    marking.page.keyboard.type("=1+1; see *More*\n-2")
    marking.press("Escape", "1", ".")
    marking.save()
    assert marking.rows()[0]["comment"].startswith("'=1+1")
    marking.grade()
    marking.page.reload()
    assert marking.page.input_value("#comment") == ""  # the next answer, which has none
    marking.press("ArrowLeft")
    assert marking.page.input_value("#comment") == "=1+1; see *More*\n-2"
    assert marking.page.text_content('#points [aria-pressed="true"]') == "1.5"


def test_what_students_wrote_is_shown_and_never_run(marking):
    seen = set()
    for _ in range(30):
        seen.add(marking.text("answer"))
        marking.press("ArrowRight")
    assert {re.sub(r" \d$", "", text) for text in seen} == set(EVIL)
    assert marking.page.title() == "Written answers"
    assert marking.page.query_selector_all("#answer *, img") == []


def test_the_policy_lets_no_other_script_run(marking):
    marking.page.evaluate(
        "() => { const s = document.createElement('script'); s.textContent = 'document.title = 1';"
        " document.body.append(s); }"
    )
    assert marking.page.title() == "Written answers"
    assert any("Content Security Policy" in said for said in marking.visit.complaints)


def test_points_are_kept_until_the_table_has_them(marking):
    marking.press("2", "Enter", "1", "u")
    marking.page.reload()
    assert marking.text("count").startswith("1 of 30 have points")
    assert "as you left them here" in marking.text("state")
    marking.save()
    marking.grade()
    marking.page.reload()
    assert marking.text("state") == ""


def test_points_that_were_typed_into_the_table_since_count(marking):
    marking.press("2")
    table = (marking.out / "questions.csv").read_text("utf-8-sig")
    first = marking.rows()[0]
    head = f"{first['notebook']},{first['question']},{first['student']},2,"
    assert head in table
    (marking.out / "questions.csv").write_text(table.replace(head, f"{head}0", 1), "utf-8")
    marking.grade()
    marking.page.reload()
    assert "1 of the points kept here differ from newer ones in the table" in marking.text("state")
    marking.press("ArrowLeft")
    assert marking.page.text_content('#points [aria-pressed="true"]') == "0"


def test_a_comment_is_used_again_by_one_key(marking):
    marking.press("c")
    marking.page.keyboard.type("Which axis?")
    marking.press("Control+Enter", "ArrowRight", "a")
    assert marking.page.input_value("#comment") == "Which axis?"
    marking.press("a")
    assert marking.page.input_value("#comment") == ""


def test_names_are_hidden_until_they_are_asked_for(marking):
    assert "student" not in marking.text("whose")
    marking.press("n")
    assert marking.text("whose").startswith("student0: explain_0")


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_the_marking_page_is_readable(marking, theme):
    visit = Visit(marking.browser, marking.out / "questions.html", theme=theme, width=390)
    visit.page.keyboard.press("1")
    elements = visit.page.query_selector_all("h1, h2, p, button, pre, dd, kbd, #task")
    contrasts = [e.evaluate(CONTRAST_ON_PAGE) for e in elements if e.is_visible()]
    assert min(contrasts) > 4.5
    assert visit.page.evaluate("document.documentElement.scrollWidth") <= 390
    visit.context.close()
