"""What students write for number_distance(a, b), whose cell holds broken code."""


def right_absolute_difference(a, b):
    return abs(a - b)


def right_larger_minus_smaller(a, b):
    return max(a, b) - min(a, b)


def right_zero_goes_with_the_same_sign(a, b):
    if a * b >= 0:
        return abs(abs(a) - abs(b))
    return abs(a) + abs(b)


def right_root_of_the_square(a, b):
    return ((a - b) ** 2) ** 0.5


def wrong_zero_gets_zero(a, b):
    """the distance from 0 is always 0"""
    if a * b > 0:
        return abs(abs(a) - abs(b))
    if a * b < 0:
        return abs(a) + abs(b)
    return 0


def wrong_signed_difference(a, b):
    """the difference is returned with its sign"""
    return a - b


def wrong_one_case_for_all(a, b):
    """without their signs"""
    return abs(abs(a) - abs(b))


def wrong_sum_for_all(a, b):
    """the sizes of a and b are added"""
    return abs(a) + abs(b)


def wrong_other_number(a, b):
    """with its sign"""
    if a == 0:
        return b
    if b == 0:
        return a
    return abs(a - b)


def wrong_square(a, b):
    """the difference is squared"""
    return (a - b) ** 2


def wrong_only_one_zero(a, b):
    """None"""
    if a * b > 0:
        return abs(abs(a) - abs(b))
    if a * b < 0:
        return abs(a) + abs(b)
    if a == 0:
        return abs(b)


def wrong_as_a_list(a, b):
    """has another form"""
    return [abs(a - b), abs(b - a)]
