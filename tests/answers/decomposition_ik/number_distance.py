"""What students write for number_distance(a, b), whose cell holds broken code."""


def right_absolute_difference(a, b):
    return abs(a - b)


def right_larger_minus_smaller(a, b):
    return [max(a, b) - min(a, b)][0]


def right_zero_goes_with_the_same_sign(a, b):
    if a * b >= 0:
        return abs(abs(a) - abs(b))
    return abs(a) + abs(b)


def wrong_only_one_zero(a, b):
    """None"""
    if a != 0:
        return abs(a - b)


def wrong_as_a_list(a, b):
    """has another form"""
    return [abs(a - b), abs(b - a)]
