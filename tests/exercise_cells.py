"""The three cells of an exercise in its notebook: task, answer and check, known by their names."""

import re

SOLUTION = re.compile(r"( *)### BEGIN SOLUTION\n.*?### END SOLUTION", re.DOTALL)


def graded(notebook):
    """{grade_id: cell} of the cells that nbgrader knows."""
    cells = [cell for cell in notebook.cells if "nbgrader" in cell.metadata]
    found = {cell.metadata.nbgrader.grade_id: cell for cell in cells}
    names = [cell.metadata.nbgrader.grade_id for cell in cells]
    assert len(found) == len(names), f"these occur twice: {', '.join(sorted({n for n in names if names.count(n) > 1}))}"
    return found


def missing_of(exercise, cells):
    """What the notebook lacks of an exercise, in words for its author. cells: by their grade_id."""
    name, points = exercise.name, exercise.points
    absent = [
        f"no cell has the grade_id {prefix}{name}" for prefix in ("task_", "", "check_") if prefix + name not in cells
    ]
    if absent:
        return absent
    task, answer, check = (cells[prefix + name] for prefix in ("task_", "", "check_"))
    about, shown = check.metadata.nbgrader, f"({points} point{'s' if points > 1 else ''}, "
    minutes = re.search(re.escape(shown) + r"\d+ minutes\)", task.source)
    head = f"def {name}({', '.join(exercise.arguments)})"
    wanted = {
        f"the first line of its task does not name `{name}`": f"`{name}`" in task.source.splitlines()[0],
        "its task has no Example": "Example" in task.source,
        "its task does not say *Why it matters:*": "*Why it matters:*" in task.source,
        f"its task does not say {shown}... minutes), with the points that its Exercise gives": bool(minutes),
        "its answer has no BEGIN SOLUTION and END SOLUTION": bool(SOLUTION.search(answer.source)),
        f"its answer does not begin with {head}": head in answer.source,
        f"its check is not check.{name}({name})": check.source == f"check.{name}({name})",
        f"its check's metadata say points {about.get('points')}, its Exercise {points}": about.get("points") == points,
        "its check's metadata do not say grade and locked": about.grade and about.locked,
    }
    return [what for what, holds in wanted.items() if not holds]
