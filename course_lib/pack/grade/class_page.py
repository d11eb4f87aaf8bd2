"""A page about the class: the distribution of points, the hardest exercises, the most frequent mistakes."""

import io
import re
import statistics
import textwrap
import warnings
from collections import Counter

from course_lib.checks.exercise import ERROR, NOT_ATTEMPTED, RIGHT, WRONG
from course_lib.pack.grade.csv_text import clean, count_noun
from course_lib.pack.grade.feedback import escaped, page, wide_table
from course_lib.pack.grade.tables import totals

MOST = 15  # bars of a picture
INK = "#010203"  # replaced by the page's text colour, light or dark
STATES = {RIGHT: "right", WRONG: "wrong", ERROR: "error", NOT_ATTEMPTED: "not attempted"}
COLOURS = {RIGHT: "#3a9d6a", WRONG: "#d9792f", ERROR: "#b8475c", NOT_ATTEMPTED: "#8c8c8c"}


def class_page(everything, marks_of):
    """Return the HTML page about the class. everything: GradedFiles; marks_of(each): the MarkedAnswers of one."""
    found = totals(everything, marks_of)
    counting = [each for each in everything if not each.superseded_by and each.student and each.notebook]
    graded = [each for each in counting if each.graded and not each.unreadable]
    said = f"{count_noun(len(found.students), 'student')}, {count_noun(len(graded), 'notebook')} graded"
    if missed := len(counting) - len(graded):
        said += f", {missed} more handed in but refused or unreadable (not in the means below)"
    left = sum(found.waiting.values())
    said += f", {count_noun(left, 'written answer')} still to be read, for no points yet." if left else "."
    parts = ["<h1>The class</h1>", f"<p>{said}</p>", _notebooks(found.of, counting, graded, found.students)]
    parts += [_distribution(found.of, graded, found.students), _hardest(graded), _mistakes(graded)]
    return page("The class", "\n".join(part for part in parts if part))


# ---- the sections of the page ----


def _notebooks(of, counting, graded, students):
    """Return a table: how many students handed in each notebook, and the points of those that could be graded."""
    rows = []
    for notebook, most in of.items():
        handed_in = len({each.student for each in counting if each.notebook == notebook})
        points = [students[student][notebook] for student in {e.student for e in graded if e.notebook == notebook}]
        mean, median = (f"{statistics.mean(points):.1f}", f"{statistics.median(points):g}") if points else ("", "")
        rows.append((notebook, handed_in, len(points), mean, median, most))
    return _table(("notebook", "handed in", "graded", "mean", "median", "of"), rows)


def _distribution(of, graded, students):
    """Return a histogram of the students' points, as shares of the points of their graded notebooks."""
    shares, pairs = [], {}
    for each in graded:
        pairs.setdefault(each.student, set()).add(each.notebook)
    for student, notebooks in pairs.items():
        most = sum(of.get(notebook, 0) for notebook in notebooks)
        if most:
            shares.append(sum(students[student][notebook] for notebook in notebooks) / most)
    if not shares:
        return ""
    counts = [0] * 10
    for share in shares:
        counts[min(int(share * 10 + 1e-9), 9)] += 1
    names = [f"{10 * i} to {10 * i + 10} %" for i in range(10)]
    figure, axes = _figure(3)
    axes.bar([10 * i + 5 for i in range(10)], counts, width=9, color="#4a90d9")
    axes.set_xticks(range(0, 101, 10))
    axes.set_xlabel("points, in percent of those of the notebooks handed in")
    axes.set_ylabel("students")
    axes.yaxis.get_major_locator().set_params(integer=True)
    most = max(range(10), key=lambda i: counts[i])
    alt = f"Bars: how many students have how many percent of the points. Most, {counts[most]}, have {names[most]}."
    rows = list(zip(names, counts, strict=True))
    caption = "Each student's points, as a share of those of the notebooks that they handed in."
    return _section("Distribution of the points", figure, alt, caption, _table(("points", "students"), rows))


def _hardest(graded):
    """Return bars of the exercises that the fewest students solved, with the states of all answers."""
    states = {}
    for each in graded:
        for exercise in each.result["exercises"]:
            name = _short(f"{each.notebook}: {exercise['exercise']}")
            if exercise["state"] in COLOURS:  # skips files that could not be read
                states.setdefault(name, Counter())[exercise["state"]] += 1
    order = sorted(states, key=lambda name: (states[name][RIGHT] / states[name].total(), name))
    shown = [name for name in order if states[name][RIGHT] < states[name].total()][:MOST]
    if not shown:
        return ""
    figure, axes = _figure(1.3 + 0.32 * len(shown))
    begin = [0.0] * len(shown)
    for state, colour in COLOURS.items():
        width = [100 * states[name][state] / states[name].total() for name in shown]
        axes.barh(range(len(shown)), width, left=begin, color=colour, label=STATES[state])
        begin = [x + w for x, w in zip(begin, width, strict=True)]
    _label_bars(axes, shown)
    axes.set_xlabel("percent of the notebooks that could be read")
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncols=4, frameon=False, labelcolor=INK)
    hardest = order[0]
    alt = f"Bars: the states of the exercises, hardest first. {hardest} is right for {states[hardest][RIGHT]} "
    alt += f"of {states[hardest].total()}."
    rows = [(name, *(states[name][state] for state in COLOURS)) for name in order]
    caption = f"The exercises that the fewest students solved, at most {MOST} of them."
    return _section("Hardest exercises", figure, alt, caption, _table(("exercise", *STATES.values()), rows))


def _mistakes(graded):
    """Return bars of the mistakes that the checks recognized."""
    counts = Counter(
        _short(f"{exercise['exercise']}: {exercise['mistake']}")
        for each in graded
        for exercise in each.result["exercises"]
        if exercise["mistake"]
    )
    order = sorted(counts, key=lambda name: (-counts[name], name))
    if not order:
        return ""
    shown = order[:MOST]
    figure, axes = _figure(1 + 0.45 * len(shown))
    axes.barh(range(len(shown)), [counts[name] for name in shown], color="#d9792f")
    _label_bars(axes, [textwrap.fill(name, 55) for name in shown])
    axes.set_xlabel("students")
    axes.xaxis.get_major_locator().set_params(integer=True)
    most = count_noun(counts[order[0]], "student")
    alt = f"Bars: how many made each mistake, most frequent first. {most}: {order[0]}."
    rows = [(name, counts[name]) for name in order]
    caption = f"The mistakes that the checks recognized, at most {MOST} of them."
    return _section("Most frequent mistakes", figure, alt, caption, _table(("mistake", "students"), rows))


def _short(text):
    """Return the text on one line, short enough for the label of a bar."""
    text = " ".join(clean(text).split())
    return text if len(text) <= 120 else text[:120] + " ..."


# ---- pictures and tables ----


def _figure(height):
    """Return a figure, without pyplot and so without a window, and its axes."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8, height), layout="constrained")
    axes = figure.add_subplot()
    axes.tick_params(colors=INK)
    for side in axes.spines.values():
        side.set_color(INK)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    axes.xaxis.label.set_color(INK)
    axes.yaxis.label.set_color(INK)
    axes.set_facecolor("none")
    return figure, axes


def _label_bars(axes, names):
    # A dollar sign in a student's text does not begin a formula.
    axes.set_yticks(range(len(names)), names, parse_math=False)
    axes.set_ylim(len(names) - 0.4, -0.6)


def _svg(figure):
    """Return the figure as an element of the page, the same bytes for the same figure."""
    import matplotlib

    file = io.StringIO()
    # Letters as outlines, so that the page looks the same with any fonts.
    with matplotlib.rc_context({"svg.hashsalt": "class", "svg.fonttype": "path"}), warnings.catch_warnings():
        warnings.simplefilter("ignore")  # about letters that the font lacks
        figure.savefig(file, format="svg", transparent=True, metadata={"Date": None})
    text = file.getvalue()
    text = re.sub(r"<metadata>.*?</metadata>", "", text[text.index("<svg") :], flags=re.DOTALL)
    return text.replace(INK, "currentColor").strip()


def _section(title, figure, alt, caption, table):
    """Return a picture with a caption, a text alternative and its numbers."""
    label = escaped(alt)
    svg = _svg(figure).replace("<svg ", f'<svg role="img" aria-label="{label}" ', 1)
    numbers = f"<details>\n<summary>The numbers</summary>\n{table}\n</details>"
    return (
        f"<h2>{escaped(title)}</h2>\n<figure>\n{svg}\n<figcaption>{escaped(caption)}</figcaption>\n</figure>\n{numbers}"
    )


def _table(columns, rows):
    head = "".join(f"<th>{escaped(name)}</th>" for name in columns)
    lines = ["<tr>" + "".join(f"<td>{escaped(value)}</td>" for value in row) + "</tr>" for row in rows]
    return wide_table(f"<tr>{head}</tr>", lines)
