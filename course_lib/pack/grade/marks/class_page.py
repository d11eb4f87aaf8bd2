"""A page about the class: points, how hard each exercise is and how well it separates, and frequent
mistakes.

Each is a table with a bar in every row, so that the numbers and the picture are one.
"""

import statistics
from collections import Counter
from collections.abc import Iterable, Sequence
from urllib.parse import quote

from markupsafe import Markup
from scipy.stats import pearsonr

from course_lib.checks.verdict import ERROR, NOT_ATTEMPTED, RIGHT, UNCHANGED, WRONG
from course_lib.pack.grade.csv_text import clean, count_noun
from course_lib.pack.grade.marks.by_hand import Entry
from course_lib.pack.grade.marks.feedback import feedback_places, rendered
from course_lib.pack.grade.marks.graded_file import GradedFile
from course_lib.pack.grade.marks.marks_table import READ
from course_lib.pack.grade.marks.tables import totals

STATES = {RIGHT: ("right", "#3a9d6a"), WRONG: ("wrong", "#d9792f"), ERROR: ("error", "#b8475c")}
STATES |= {NOT_ATTEMPTED: ("not attempted", "#8c8c8c")}
BLUE = "#4a90d9"
KEY = '<i class="key" style="background:{}" aria-hidden="true"></i> {}'
LINK = '<a href="{}">{}</a>'
MIN_STUDENTS = 20  # students, for a correlation
POINTS = ("mean %", "separates")
SEPARATES = (
    "The column separates is the correlation of its points with the student's other points in the "
    "notebook, with a "
    f"95 % confidence interval, from {MIN_STUDENTS} students on: near 0, it does not tell strong "
    f"students from weak ones."
)

Section = tuple[str, str, tuple, list]  # title, caption, headings and rows of a table


def class_page(
    everything: Sequence[GradedFile],
    absent: Sequence[str] = (),
    by_hand: Sequence[Entry] = (),
) -> str:
    """Return the HTML page about the class.

    everything: GradedFiles. absent: names of those who handed in nothing. by_hand: what remains for
    the instructor.
    """
    class_totals = totals(everything)
    counting = [
        file for file in everything if not file.superseded_by and file.student and file.notebook
    ]
    graded = [file for file in counting if file.graded and not file.unreadable]
    summary = (
        f"{count_noun(len(class_totals.students), 'student')}, "
        f"{count_noun(len(graded), 'notebook')} graded"
    )
    if missed := len(counting) - len(graded):
        summary += f", {missed} more handed in but refused or unreadable (not in the means below)"
    if counting and counting[0].weight < 1:
        summary += f", points of More count {counting[0].weight:g} times"
    unread = sum(class_totals.waiting.values())
    summary += (
        f", {count_noun(unread, 'written answer')} still to be read, for no points yet."
        if unread
        else "."
    )
    sections = [_notebooks(class_totals.of, counting, graded, class_totals.students)]
    sections += [_distribution(class_totals.of, graded, class_totals.students), _hardest(graded)]
    sections += [_written(graded), _mistakes(graded)]
    sections += [_students(class_totals.of, class_totals.students, everything)]
    return rendered(
        "class.html",
        title="The class",
        summary=summary,
        sections=sections,
        absent=absent,
        by_hand=by_hand,
    )


def _notebooks(
    of: dict, counting: list[GradedFile], graded: list[GradedFile], students: dict
) -> Section:
    """Return a table: how many students handed in each notebook, and the points of those that could
    be graded."""
    rows = []
    for notebook, most in of.items():
        handed_in = len({file.student for file in counting if file.notebook == notebook})
        points = [
            students[student][notebook]
            for student in {e.student for e in graded if e.notebook == notebook}
        ]
        mean, median = (
            (f"{statistics.mean(points):.1f}", f"{statistics.median(points):g}")
            if points
            else ("", "")
        )
        rows.append((notebook, handed_in, len(points), mean, median, most))
    caption = "How many students handed in each notebook, and the points of what could be graded."
    return "Notebooks", caption, ("notebook", "handed in", "graded", "mean", "median", "of"), rows


def _distribution(of: dict, graded: list[GradedFile], students: dict) -> Section:
    counts, pairs = [0] * 10, {}
    for file in graded:
        pairs.setdefault(file.student, set()).add(file.notebook)
    for student, notebooks in pairs.items():
        if most := sum(of.get(notebook, 0) for notebook in notebooks):
            share = sum(students[student][notebook] for notebook in notebooks) / most
            counts[min(int(share * 10 + 1e-9), 9)] += 1
    rows = [
        (f"{10 * i} to {10 * i + 10} %", n, _bar([(n, BLUE)], max(counts)))
        for i, n in enumerate(counts)
    ]
    caption = "Each student's points, as a share of those of the notebooks that they handed in."
    return (
        "Distribution of the points",
        caption,
        ("points", "students", ""),
        rows if any(counts) else [],
    )


def _hardest(graded: list[GradedFile]) -> Section:
    states, points = {}, _points(graded)
    for file in graded:
        for exercise in file.result["exercises"]:
            state = NOT_ATTEMPTED if exercise["state"] == UNCHANGED else exercise["state"]
            if state in STATES:  # skips files that could not be read
                states.setdefault(
                    (file.notebook, exercise["exercise"], exercise["more"]), Counter()
                )[state] += 1
    order = sorted(states, key=lambda it: (it[2], states[it][RIGHT] / states[it].total(), it))
    rows = []
    for it in (it for it in order if states[it][RIGHT] < states[it].total()):
        counts = [states[it][state] for state in STATES]
        bar = _bar(
            [(n, colour) for n, (_, colour) in zip(counts, STATES.values(), strict=True)],
            sum(counts),
        )
        rows.append(
            (_short(f"{it[0]}: {it[1]}") + " (More)" * it[2], *counts, *points[it[:2]], bar)
        )
    headings = [Markup(KEY).format(colour, heading) for heading, colour in STATES.values()]
    columns = ("exercise", *headings, *POINTS, "")
    caption = (
        "The exercises by the share of students who solved them, of the notebooks that could be "
        "read. The parts of a bar have the colours of the headings. "
    )
    return "Hardest exercises", caption + SEPARATES, columns, rows


def _written(graded: list[GradedFile]) -> Section:
    points, asked = _points(graded), Counter()
    for file in graded:
        asked.update((file.notebook, a.question) for a in file.answers if a.state == READ)
    rows = [(_short(f"{it[0]}: {it[1]}"), asked[it], *points[it]) for it in sorted(asked)]
    return (
        "Written answers",
        "Those that you marked. " + SEPARATES,
        ("question", "marked", *POINTS),
        rows,
    )


def _points(graded: list[GradedFile]) -> dict[tuple[str, str], tuple[str, str]]:
    """Return {(notebook, exercise or question): (mean points in percent, item-rest correlation)} as
    texts."""
    items, difficulties = {}, {}
    for file in graded:
        entries = [(e["exercise"], e["points"], e["of"]) for e in file.result["exercises"]]
        entries += [(a.question, a.points, a.of) for a in file.answers]
        total = sum(points or 0 for _, points, _ in entries)
        for name, points, of in entries:
            if points is not None and of:
                items.setdefault((file.notebook, name), []).append((points / of, total - points))
    for it, pairs in items.items():
        shares, rests = zip(*pairs, strict=True)
        difficulties[it] = f"{100 * statistics.mean(shares):.0f}", ""
        if len(pairs) >= MIN_STUDENTS and min(map(len, (set(shares), set(rests)))) > 1:
            correlation = pearsonr(shares, rests)
            bounds = correlation.confidence_interval()
            difficulties[it] = (
                difficulties[it][0],
                f"{correlation.statistic:.2f} ({bounds.low:.2f} to {bounds.high:.2f})",
            )
    return difficulties


def _mistakes(graded: list[GradedFile]) -> Section:
    named = (
        (e["exercise"], e["mistake"])
        for file in graded
        for e in file.result["exercises"]
        if e["mistake"]
    )
    counts = Counter(_short(f"{exercise}: {mistake}") for exercise, mistake in named)
    order = sorted(counts, key=lambda name: (-counts[name], name))
    rows = [(name, counts[name], _bar([(counts[name], BLUE)], counts[order[0]])) for name in order]
    caption = "The mistakes that the checks recognized, and how many students made them."
    return "Most frequent mistakes", caption, ("mistake", "students", ""), rows


def _students(of: dict, students: dict, everything: Sequence[GradedFile]) -> Section:
    """Return a table: each student's points, each a link to the feedback about the notebook."""
    links: dict[tuple[str, str], str] = {}
    others: dict[str, list[str]] = {}
    for place, file in feedback_places(everything).items():
        address = f"feedback/{quote(place)}"
        if file.notebook in of:
            links[file.student, file.notebook] = address
        else:
            others.setdefault(file.student, []).append(Markup(LINK).format(address, "feedback"))
    rows = []
    for student, points in sorted(students.items()):
        cells = []
        for notebook in of:
            address = links.get((student, notebook))
            shown = f"{points.get(notebook, 0):g}"
            cells.append(Markup(LINK).format(address, shown) if address else "")
        total = f"{sum(points.values()):g}"
        rows.append([student, *cells, total])
        if others:
            rows[-1].append(Markup(" ").join(others.get(student, [])))
    caption = "Each student's points, which link to the feedback."
    return "Students", caption, ("student", *of, "total", *["other files"] * bool(others)), rows


def _short(text: str) -> str:
    text = " ".join(clean(text).split())
    return text if len(text) <= 120 else text[:120] + " ..."


def _bar(parts: Iterable[tuple[int, str]], most: int) -> Markup:
    """Return a bar whose parts have these (lengths, colours); `most` fills the width."""
    pieces = (
        f'<i style="width:{8 * n / (most or 1):.2f}rem;background:{colour}"></i>'
        for n, colour in parts
        if n
    )
    return Markup(f'<span class="bar" aria-hidden="true">{"".join(pieces)}</span>')
