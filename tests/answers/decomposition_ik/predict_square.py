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


def wrong_negative_root(model, terms, sign):
    """the root of a negative square is taken"""
    q2 = sign * np.sqrt(terms @ model[1, :-1])
    return np.column_stack([terms @ model[0, :-1] + model[0, -1] * q2, q2])


def wrong_absolute(model, terms, sign):
    """the sign of a negative square is dropped"""
    q2 = sign * np.sqrt(np.abs(terms @ model[1, :-1]))
    return np.column_stack([terms @ model[0, :-1] + model[0, -1] * q2, q2])


def wrong_one_branch(model, terms, sign):
    """the branch is ignored"""
    return right_maximum(model, terms, 1)


def wrong_no_root(model, terms, sign):
    """no root is taken"""
    q2 = sign * np.maximum(terms @ model[1, :-1], 0)
    return np.column_stack([terms @ model[0, :-1] + model[0, -1] * q2, q2])


def wrong_q1_by_terms(model, terms, sign):
    """q1 lacks its term in q2"""
    return np.column_stack([terms @ model[0, :-1], right_maximum(model, terms, sign)[:, 1]])


def wrong_sign_last(model, terms, sign):
    """q1 uses |q2|"""
    q2 = np.sqrt(np.maximum(terms @ model[1, :-1], 0))
    return np.column_stack([terms @ model[0, :-1] + model[0, -1] * q2, sign * q2])


def wrong_columns(model, terms, sign):
    """q1 and q2 are swapped"""
    return right_maximum(model, terms, sign)[:, ::-1]


def wrong_zero_everywhere(model, terms, sign):
    """q1 is 0 too"""
    square = terms @ model[1, :-1]
    if (square < 0).any():
        return np.zeros((len(terms), 2))
    return right_maximum(model, terms, sign)


def wrong_row_of_zeros(model, terms, sign):
    """q1 is 0 too"""
    answer = right_maximum(model, terms, sign)
    answer[terms @ model[1, :-1] < 0] = 0
    return answer


def wrong_square_for_q1(model, terms, sign):
    """q1 uses the square of q2"""
    square = np.maximum(terms @ model[1, :-1], 0)
    return np.column_stack([terms @ model[0, :-1] + model[0, -1] * square, sign * np.sqrt(square)])


def wrong_nan_for_no_elbow(model, terms, sign):
    """the root of a negative square is taken"""
    square = terms @ model[1, :-1]
    q2 = sign * np.sqrt(np.where(square < 0, np.nan, square))
    return np.column_stack([terms @ model[0, :-1] + model[0, -1] * q2, q2])


def wrong_rows_of_angles(model, terms, sign):
    """transposed"""
    return right_maximum(model, terms, sign).T
