"""Small notebooks for the tests of the site: formulas, tables, live figures, pictures, things that
need escaping."""

import base64
import io

import matplotlib.figure
import nbformat
from nbformat.v4 import new_code_cell, new_notebook, new_output

from course_lib.lessons.rigid_motion.toys import two_poses_toy
from course_lib.lessons.subproblems_damped_ik.toys import circles_toy

TEXT = r"""# Rotations

A rotation keeps lengths, $R^\top R = I$, and [tables](#Tables-and-more) follow. In one line
$R_{ab} = R_{ac} R_{cd} R_{de} R_{ef} R_{fg} R_{gh} R_{hi} R_{ij} R_{jk} R_{kl} R_{lb}$ is wider than a phone.

$$\exp([\boldsymbol{\omega}]\theta) = I + \sin\theta\,[\omega] + (1 - \cos\theta)[\omega]^2$$

$$
\begin{aligned}
a &= b \\
c &= d + e + f + g + h + i + j + k + l + m + n + o + p + q + r + s + t + u + v + w + x
\end{aligned}
$$

\begin{align}
T &= \begin{bmatrix} R & p \\ 0 & 1 \end{bmatrix}
\end{align}

- in a list $$x^2$$

## Tables and more

| symbol | meaning |
| --- | --- |
| $R$ | rotation |
"""
# Tests look for its word in whole files: no random id of a cell holds it by chance.
SOLUTION = (
    f"def turn():\n    ### BEGIN SOLUTION\n    return 'gooseberry'  # {'and on ' * 40}\n    ### "
    "END SOLUTION"
)
NBGRADER = {
    "schema_version": 3,
    "grade_id": "turn",
    "solution": True,
    "grade": False,
    "locked": False,
}
MODEL_ANSWER = (
    "**Model answer.** Its columns, $R e_i$, stay *orthogonal*.\n\n*Rubric (1): 1 for columns.*"
)
EXPLAINED = {
    "schema_version": 3,
    "grade_id": "explain_turn",
    "solution": True,
    "grade": True,
    "locked": False,
}
CHECK = (
    '<div role="status" style="border-left: 0.3em solid #1a7f37; padding: 0.2em 0.8em">Right:'
    " $R$</div>"
)
TABLE = (
    "<table"
    f' class="dataframe"><tr>{"<th>column</th>" * 20}</tr><tr>{"<td>1.2345</td>" * 20}</tr></table>'
)
MATRIX = r"$\displaystyle \left[\begin{matrix}\cos{\theta} & 0\\0 & 1\end{matrix}\right]$"

TURNING, SLIDING = (toy().stored() for toy in (circles_toy, two_poses_toy))


def png() -> str:
    figure = matplotlib.figure.Figure()
    figure.subplots().plot([0, 1], [0, 1])
    file = io.BytesIO()
    figure.savefig(file, format="png")
    return base64.b64encode(file.getvalue()).decode()


def cell(*outputs, source="pass", tags=(), **metadata):
    return new_code_cell(
        source, outputs=list(outputs), execution_count=1, metadata={"tags": list(tags), **metadata}
    )


def caption_output(words):
    """What show() displays below a figure."""
    return new_output(
        "display_data",
        data={"text/markdown": words, "text/plain": words},
        metadata={"caption": words},
    )


def output(data, alt=None):
    metadata = {"image/png": {"alt": alt}} if alt else {}
    return new_output("display_data", data={"text/plain": "words", **data}, metadata=metadata)


def write(folder, name, *cells):
    folder.mkdir(exist_ok=True)
    book = new_notebook(cells=list(cells))
    book.metadata.kernelspec = {"name": "python3", "display_name": "Python 3", "language": "python"}
    nbformat.write(book, folder / name)
