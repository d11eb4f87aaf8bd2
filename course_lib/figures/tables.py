"""Tables that notebooks print: names of rows at the left, numbers at the right."""


def table(columns, rows):
    """Print rows of a table under the names of their columns.

    Parameters
    ----------
    columns : sequence of str
        The names of the columns.
    rows : dict
        Name of a row to its values, numbers or text, one for each column. Numbers below 1e-6 are
        all shown as "< 1e-06", because rounding decides them.

    Examples
    --------
    >>> table(["error (m)", "steps"], {"undamped": [0.0312, 12], "damped": [2e-9, 1200]})
              error (m)  steps
    undamped      0.031     12
    damped      < 1e-06  1,200
    """
    lines = [["", *columns]]
    for name, values in rows.items():
        lines.append([name, *map(_short, values)])
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    for name, *cells in lines:
        padded = [f"{cell:>{width}}" for cell, width in zip(cells, widths[1:], strict=True)]
        print("  ".join([f"{name:{widths[0]}}", *padded]))


def _short(value):
    if isinstance(value, str):
        return value
    if isinstance(value, int):
        return f"{value:,}"
    if 0 <= value < 1e-6:
        return "< 1e-06"
    return f"{value:.2g}"
