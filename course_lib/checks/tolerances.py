"""The tolerances of the checks, by name: a task states the number, and a test compares the two.

Numbers are stored with 16 digits, so each rounding changes a number near 1 by 1.1e-16 at most.
"""

# A formula in closed form: a few dozen roundings, with a factor of a million to spare for a method
# that loses some digits and is right all the same.
EXACT = 1e-9
# Finite differences of good size (central, with steps of 1e-5) or an iteration that has converged.
SOLVED = 1e-8
# Beside a special value, where a good method may lose half of the digits: the root of 1.1e-16 is
# 1e-8, and a few operations multiply it.
HALF_THE_DIGITS = 1e-7
# Where a task asks for six digits: float32, pi as 3.14159 and angles cut at 1e-6 come close to it.
SIX_DIGITS = 1e-6
# Relative, where a task asks for five digits of a small number.
FIVE_DIGITS = 1e-5
# Where a task is about which branch is taken, and the formula beside the special value is crude.
FOUR_DIGITS = 1e-4
# Where an answer counts as the one that a known mistake predicts, in each entry, absolute and
# relative: looser than any tolerance for right answers, for the mistake may have a form of its own.
PREDICTED = 1e-6
