"""What students write for predict_square(model, terms, sign)."""

import numpy as np


def right_maximum(model, terms, sign):
    q2 = sign * np.sqrt(np.maximum(terms @ model[1, :-1], 0))
    return np.column_stack([terms @ model[0, :-1] + model[0, -1] * q2, q2])


def right_both_rows_at_once(model, terms, sign):
    first, square = model[:, :-1] @ terms.T
    q2 = sign * square.clip(0) ** 0.5
    return np.array([first + model[0, -1] * q2, q2]).T


def right_one_by_one(model, terms, sign):
    found = []
    for row in terms:
        square = sum(a * t for a, t in zip(model[1], row))
        q2 = sign * square**0.5 if square > 0 else 0.0
        found.append((sum(a * t for a, t in zip(model[0], [*row, q2])), q2))
    return found
