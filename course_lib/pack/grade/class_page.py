"""A page about the class: the distribution of points, the hardest exercises, the most frequent mistakes.

Each is a table with a bar in every row, so that the numbers and the picture are one.
"""

import statistics
from collections import Counter

from markupsafe import Markup

from course_lib.checks.exercise import ERROR, NOT_ATTEMPTED, RIGHT, WRONG
from course_lib.pack.grade.csv_text import clean, count_noun
from course_lib.pack.grade.feedback import rendered
from course_lib.pack.grade.tables import totals

STATES = {RIGHT: ("right", "#3a9d6a"), WRONG: ("wrong", "#d9792f"), ERROR: ("error", "#b8475c")}
STATES |= {NOT_ATTEMPTED: ("not attempted", "#8c8c8c")}
BLUE = "#4a90d9"


def class_page(everything):
    """Return the HTML page about the class. everything: GradedFiles."""
    found = totals(everything)
    counting = [each for each in everything if not each.superseded_by and each.student and each.notebook]
    graded = [each for each in counting if each.graded and not each.unreadable]
    said = f"{count_noun(len(found.students), 'student')}, {count_noun(len(graded), 'notebook')} graded"
    if missed := len(counting) - len(graded):
        said += f", {missed} more handed in but refused or unreadable (not in the means below)"
    if counting and counting[0].weight < 1:
        said += f", points of More count {counting[0].weight:g} times"
    left = sum(found.waiting.values())
    said += f", {count_noun(left, 'written answer')} still to be read, for no points yet." if left else "."
    sections = [_notebooks(found.of, counting, graded, found.students)]
    sections += [_distribution(found.of, graded, found.students), _hardest(graded), _mistakes(graded)]
    return rendered("class.html", title="The class", said=said, sections=sections)


def _notebooks(of, counting, graded, students):
    """Return a table: how many students handed in each notebook, and the points of those that could be graded."""
    rows = []
    for notebook, most in of.items():
        handed_in = len({each.student for each in counting if each.notebook == notebook})
        points = [students[student][notebook] for student in {e.student for e in graded if e.notebook == notebook}]
        mean, median = (f"{statistics.mean(points):.1f}", f"{statistics.median(points):g}") if points else ("", "")
        rows.append((notebook, handed_in, len(points), mean, median, most))
    return "", "", ("notebook", "handed in", "graded", "mean", "median", "of"), rows


def _distribution(of, graded, students):
    counts, pairs = [0] * 10, {}
    for each in graded:
        pairs.setdefault(each.student, set()).add(each.notebook)
    for student, notebooks in pairs.items():
        if most := sum(of.get(notebook, 0) for notebook in notebooks):
            share = sum(students[student][notebook] for notebook in notebooks) / most
            counts[min(int(share * 10 + 1e-9), 9)] += 1
    rows = [(f"{10 * i} to {10 * i + 10} %", n, _bar([(n, BLUE)], max(counts))) for i, n in enumerate(counts)]
    caption = "Each student's points, as a share of those of the notebooks that they handed in."
    return "Distribution of the points", caption, ("points", "students", ""), rows if any(counts) else []


def _hardest(graded):
    states = {}
    for each in graded:
        for exercise in each.result["exercises"]:
            if exercise["state"] in STATES:  # skips files that could not be read
                name = _short(f"{each.notebook}: {exercise['exercise']}") + " (More)" * exercise["more"]
                states.setdefault(name, Counter())[exercise["state"]] += 1
    order = sorted(states, key=lambda name: (" (More)" in name, states[name][RIGHT] / states[name].total(), name))
    rows = []
    for name in (name for name in order if states[name][RIGHT] < states[name].total()):
        counts = [states[name][state] for state in STATES]
        bar = _bar([(n, colour) for n, (_, colour) in zip(counts, STATES.values(), strict=True)], sum(counts))
        rows.append((name, *counts, bar))
    columns = ("exercise", *(words for words, _ in STATES.values()), "")
    caption = "The exercises by the share of students who solved them, of the notebooks that could be read."
    return "Hardest exercises", caption, columns, rows


def _mistakes(graded):
    named = ((e["exercise"], e["mistake"]) for each in graded for e in each.result["exercises"] if e["mistake"])
    counts = Counter(_short(f"{exercise}: {mistake}") for exercise, mistake in named)
    order = sorted(counts, key=lambda name: (-counts[name], name))
    rows = [(name, counts[name], _bar([(counts[name], BLUE)], counts[order[0]])) for name in order]
    caption = "The mistakes that the checks recognized, and how many students made them."
    return "Most frequent mistakes", caption, ("mistake", "students", ""), rows


def _short(text):
    text = " ".join(clean(text).split())
    return text if len(text) <= 120 else text[:120] + " ..."


def _bar(parts, most):
    """Return a bar whose parts have these (lengths, colours); `most` fills the width."""
    pieces = (f'<i style="width:{8 * n / (most or 1):.2f}rem;background:{colour}"></i>' for n, colour in parts if n)
    return Markup(f'<span class="bar" aria-hidden="true">{"".join(pieces)}</span>')
