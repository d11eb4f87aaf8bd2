"""The feedback page of each submission, for its student. All text from submissions is escaped."""

import html
import re

from course_lib.checks.exercise import ERROR, NOT_ATTEMPTED, RIGHT, WRONG
from course_lib.pack.files import write_atomically
from course_lib.pack.grade.collect import file_names
from course_lib.pack.grade.csv_text import clean, count_noun
from course_lib.pack.grade.tables import final_state, lateness

LONGEST = 100_000  # characters of one message or answer
MARKS = {RIGHT: ("✓", "good"), WRONG: ("✗", "bad"), ERROR: ("!", "bad"), final_state(NOT_ATTEMPTED): ("○", "none")}

PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">
<title>{title}</title>
<style>
:root {{ color-scheme: light dark; --good: #1d6f42; --bad: #a8480a; --none: #666; --line: #8886; --soft: #eee; }}
@media (prefers-color-scheme: dark) {{ :root {{ --good: #6fcf97; --bad: #f2a365; --none: #aaa; --soft: #2b2b2b; }} }}
body {{ font: 16px/1.5 system-ui, sans-serif; max-width: 50rem; margin: 2rem auto; padding: 0 1rem; }}
h1, h2 {{ line-height: 1.2; overflow-wrap: anywhere; }}
h2 {{ font-size: 1.1rem; margin: 2rem 0 0.5rem; }}
table {{ border-collapse: collapse; }}
th, td {{ text-align: left; padding: 0.2rem 1rem 0.2rem 0; border-bottom: 1px solid var(--line); }}
td.number, th.number {{ text-align: right; }}
pre {{ background: var(--soft); padding: 0.6rem 0.8rem; margin: 0.4rem 0;
  white-space: pre-wrap; overflow-wrap: anywhere; }}
.wide {{ overflow-x: auto; }}
.bar {{ display: flex; width: 8rem; height: 1rem; }}
.good {{ color: var(--good); }} .bad {{ color: var(--bad); }} .none {{ color: var(--none); }}
.task {{ white-space: pre-wrap; }}
.problem {{ border-left: 0.3rem solid var(--bad); padding-left: 0.8rem; }}
</style>
</head>
<body>
<main>
{body}
</main>
</body>
</html>
"""


def page(title, body):
    """Return an HTML page that needs no network and runs no script. body: HTML."""
    return PAGE.format(title=escaped(title), body=body)


def escaped(text):
    """Return text as HTML that shows it, cut to LONGEST characters."""
    text = clean(text)
    return html.escape(text if len(text) <= LONGEST else text[:LONGEST] + "\n... (cut here)")


def wide_table(head, rows):
    """Return a table that scrolls by itself if the page is narrower. head, rows: the HTML of its rows."""
    body = "\n".join(rows)
    return f'<div class="wide"><table>\n<thead>{head}</thead>\n<tbody>\n{body}\n</tbody>\n</table></div>'


# ---- one submission ----


def feedback_page(each):
    """Return the HTML page of one GradedFile."""
    body = [f"<h1>{escaped(each.notebook or each.submission.place)}</h1>", f"<p>{escaped(each.student)}</p>"]
    if each.graded:
        later = f", {count_noun(each.unread, 'written answer')} still to be read" if each.unread else ""
        body.append(f"<p><strong>{each.total:.4g} of {each.of:g} points</strong>{later}</p>")
        body.append(f'<p class="problem">{escaped(lateness(each))}</p>' if lateness(each) else "")
    body += [f'<p class="problem">{escaped(problem)}</p>' for problem in each.result["problems"]]
    body += [_overview(each, more) for more in (False, True)]
    body += [_exercise(exercise) for exercise in each.result["exercises"] if exercise["message"]]
    body += [_answer(answer) for answer in each.answers]
    release = f", release {escaped(each.result['release'])}" if each.result["release"] else ""
    body.append(f'<p class="none">Graded from {escaped(each.submission.place)}{release}.</p>')
    return page(f"{each.notebook}, {each.student}", "\n".join(body))


def _overview(each, more):
    """Return a table of the core or of More: a row for each exercise, linked to its details if there are any."""
    exercises = [exercise for exercise in each.result["exercises"] if exercise["more"] == more]
    answers = [answer for answer in each.answers if answer.more == more]
    if not exercises and not answers:
        return ""
    points, of = each.part(more)
    said = f"{'More' if more else 'Core'}: {points:g} of {of:g} points"
    if more and each.weight < 1:
        said += f", which count {each.weight:g} times: {points * each.weight:.4g} of {of * each.weight:.4g}"
    lines = [(e["exercise"], e["state"], e["points"], e["of"], e["message"]) for e in exercises]
    lines = [(name, final_state(state), *rest) for name, state, *rest in lines]
    lines += [
        (_title(a), final_state(a.state), "" if a.points is None else f"{a.points:g}", a.of, a.text) for a in answers
    ]
    rows = []
    for name, state, points, of, more in lines:
        mark, colour = MARKS.get(state, ("·", "none"))
        name = f'<a href="#{escaped(name.partition(" ")[0])}">{escaped(name)}</a>' if more else escaped(name)
        numbers = f'<td class="number">{points}</td><td class="number">{of}</td>'
        rows.append(f'<tr><td>{name}</td><td class="{colour}">{mark} {escaped(state)}</td>{numbers}</tr>')
    head = '<tr><th>exercise</th><th>state</th><th class="number">points</th><th class="number">of</th></tr>'
    return f"<h2>{said}</h2>\n{wide_table(head, rows)}"


def _title(answer):
    """Return the name of a question with its letter in the notebook: explain_frame (B)."""
    letter = re.match(r"\W*([A-Z])\.", answer.task)
    return f"{answer.question} ({letter[1]})" if letter else answer.question


def _exercise(exercise):
    name, points = escaped(exercise["exercise"]), f"{exercise['points']} of {exercise['of']}"
    heading = f'<h2 id="{name}">{name}: {escaped(final_state(exercise["state"]))}, {points}</h2>'
    return f"{heading}\n<pre>{escaped(exercise['message'])}</pre>"


def _answer(answer):
    name, points = escaped(answer.question), "" if answer.points is None else f", {answer.points:g} of {answer.of}"
    heading = f'<h2 id="{name}">{escaped(_title(answer))}: {escaped(final_state(answer.state))}{points}</h2>'
    task = f'\n<p class="task">{escaped(answer.task.replace("**", ""))}</p>' if answer.task else ""
    comment = f"\n<p><strong>Comment:</strong> {escaped(answer.comment)}</p>" if answer.comment else ""
    return f"{heading}{task}\n<pre>{escaped(answer.text)}</pre>{comment}"


# ---- all of them ----


def write_feedback(folder, everything):
    """Write <student>/<notebook>.html for each file that counts; delete the pages of students not in this run."""
    counting = [each for each in everything if not each.superseded_by and each.student]
    students = file_names({each.student for each in counting})
    pages = {}
    for each in counting:
        pages.setdefault(each.student, {}).setdefault(each.notebook or each.submission.place, each)
    written = set()
    for student, its in pages.items():
        names = file_names(set(its))
        for notebook, each in its.items():
            path = folder / students[student] / f"{names[notebook]}.html"
            write_atomically(path, feedback_page(each))
            written.add(path)
    for path in folder.glob("*/*.html"):
        if path not in written:
            path.unlink()
            if not any(path.parent.iterdir()):
                path.parent.rmdir()
