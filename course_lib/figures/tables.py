"""Tables that notebooks print: names of rows at the left, numbers at the right."""


def table(columns, rows):
    """Print rows of a table under the names of their columns.

    rows: {name: values, numbers or text, one for each column}. Numbers below 1e-6 are all shown as
    "< 1e-06".
    """
    shown = [
        [columns[k], *(_short([*values][k]) for values in rows.values())]
        for k in range(len(columns))
    ]
    names = ["", *rows]
    for i, name in enumerate(names):
        print(
            f"{name:{max(map(len, names))}}"
            + "".join(f"  {column[i]:>{max(map(len, column))}}" for column in shown)
        )


def _short(value):
    if isinstance(value, str):
        return value
    if isinstance(value, int):
        return f"{value:,}"
    return "< 1e-06" if 0 <= value < 1e-6 else f"{value:.2g}"
