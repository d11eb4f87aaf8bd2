"""What exercises of notebook 2 share: paths of a body from start to goal, and plans of velocities.

The right path is known except for half a revolution, which is as short in either direction, so that
there a path in either direction is right.
"""

import numpy as np

from course_lib.checks.exercise import Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import SMALL_NUMBERS, Sweep
from course_lib.checks.tolerances import EXACT, PREDICTED
from course_lib.checks.vocabulary import compared
from course_lib.planar import quintic_time_scaling, wrap_angle

BODY = np.array([False, False, True])  # the columns x, y and theta: which are angles
REVOLUTION = 2 * np.pi
_ROUNDING = 1e-10  # rad: nearer to half a revolution, either arc is right to the tolerance
MATRICES = Mistake(
    "the matrices of the poses are returned",
    "A row is (x, y, theta), read from the matrix T.",
    form=lambda array, *case: array.ndim == 3 and array.shape[1:] == (3, 3),
)


def cubic(u):
    """Return the time scaling from rest to rest."""
    return u * u * (3 - 2 * u)


TIME_SCALINGS = (  # that students take for the cubic
    lambda u: u,
    lambda u: quintic_time_scaling(u, 1.0),
    lambda u: (1 - np.cos(np.pi * u)) / 2,
    *(lambda u, a=a, b=b: a * u**2 + b * u**3 for a, b in ((3, 2), (2, -3), (2, -1), (-2, 3))),
)


def scaling(n):
    """Return n values of the cubic time scaling, from 0 to 1."""
    return cubic(np.linspace(0, 1, n))


def straight(start, change, s):
    """Return the rows start + s change."""
    return np.array(start, float) + np.asarray(s)[:, None] * change


def size(start, goal):
    """Return the size of the numbers in a case, for tolerances."""
    return 1 + np.abs([start, goal]).max()


def deviation(rows, wanted, angles=BODY):
    """Return the largest difference between rows and those wanted; inf if their shapes differ.

    angles: for each column whether it is an angle, in which whole revolutions do not count.
    """
    rows, wanted = np.asarray(rows), np.asarray(wanted)
    if rows.shape != wanted.shape:
        return np.inf
    apart = np.abs(rows - wanted)
    countable = apart < 1e6  # no revolutions are counted in 1e200
    revolutions = np.where(countable & angles, np.round(apart / REVOLUTION), 0)
    return np.abs(apart - REVOLUTION * revolutions).max(initial=0)


def distance_of_rows(angles):
    """Return how far rows are from the right ones, as `distance` of an exercise."""
    return lambda rows, right, *case: deviation(rows, right, angles)


def in_the_other_direction(rows, start, goal):
    """Return the mirror image of a path by half a revolution: x and y at the line from start to
    goal."""
    rows, start = np.asarray(rows, float), np.asarray(start, float)
    ahead = np.subtract(goal, start)[:2]
    length = np.linalg.norm(ahead)
    aside = rows[:, :2] - start[:2]
    if length:
        aside = 2 * np.outer(aside @ ahead, ahead) / length**2 - aside
    return np.column_stack([start[:2] + aside, 2 * start[2] - rows[:, 2]])


def change(start, goal):
    """Return the change from start to goal, the angle along the shorter arc."""
    apart = np.subtract(goal, start).astype(float)
    return np.where(BODY, wrap_angle(apart), apart)


def one_arc_is_shorter(start, goal):
    """Return whether the angles are less than half a revolution apart, so that one arc is the
    shorter."""
    return abs(change(start, goal)[2]) < np.pi - _ROUNDING


def distance_of_paths(rows, right, start, goal, n):
    """Return how far a path is from the right one, or at half a revolution from its mirror image
    if that is nearer."""
    if one_arc_is_shorter(start, goal):
        return deviation(rows, right)
    return min(deviation(rows, right), deviation(rows, in_the_other_direction(right, start, goal)))


def same_path(rows, predicted, start, goal, n):
    """Return whether an answer is the path that a mistake predicts."""
    return distance_of_paths(rows, predicted, start, goal, n) <= PREDICTED * size(start, goal)


def first_wrong_row(right_path):
    """Return `found` of an exercise on a path: where the body should be at the first row that is
    off."""

    def found(rows, start, goal, n):
        right = right_path(start, goal, n)
        apart = [deviation(*pair) for pair in zip(rows, right, strict=True)]
        k = int(np.argmax(np.array(apart) > EXACT * size(start, goal)))
        u = k / (n - 1)
        return (
            f"The row with index {k} belongs to u = {u:.4g}, and s is {cubic(u):.4g} there. It "
            "should be " + compared(right[k], rows[k]) + "."
        )

    return found


_BEYOND = 0.01  # radians: an angle that misses the goal by little is on no other arc


def _leaves_the_shorter_arc(rows, start, goal):
    if not one_arc_is_shorter(start, goal):
        return False
    angle = change(start, goal)[2]
    ahead = np.copysign(1.0, angle) * (rows[:, 2] - start[2])
    return (np.mod(wrap_angle(ahead) + 1e-7, REVOLUTION) - 1e-7).max() > abs(angle) + _BEYOND


def lost_sign(*answers):
    """Return the Mistake of these answers, whose angle is an arccos."""
    return Mistake(
        "arccos loses the sign of the angle",
        "Which function uses both sine and cosine, so that the angle keeps its sign?",
        *answers,
    )


_LONGER_ARC = Mistake(
    "the body takes the longer arc",
    "By which angle should the body rotate in all, and by which does it in yours? Which line of "
    "your code decides between the two directions of rotation?",
)


def longer_arc(rows, start, goal, n):
    """Return the Mistake of a path on which the body takes the longer arc; None for another."""
    return _LONGER_ARC if _leaves_the_shorter_arc(rows, start, goal) else None


def lengths(duration, dt):
    """Return the lengths of the steps of one pair: dt each, the last one shorter if it must be."""
    whole = int(np.ceil(duration / dt - 1e-6)) - 1
    return np.append(np.full(whole, dt), duration - whole * dt)


def steps(plan, dt):
    """Return the velocities (n, k) and the lengths (n,) of all steps of a plan."""
    each = [(velocity, h) for velocity, duration in plan for h in lengths(duration, dt)]
    return np.array([velocity for velocity, _ in each], float), np.array([h for _, h in each])


def follow(move, lengths=lengths):
    """Return the answer of a student who goes from row to row by move(row, velocity, h), in steps
    of these lengths."""

    def answer(start, plan, dt):
        rows = [np.array(start, float)]
        for velocity, duration in plan:
            for h in lengths(duration, dt):
                rows.append(move(rows[-1], np.array(velocity, float), h))
        return np.array(rows)

    return answer


def path_mistakes(path):
    """Return the mistakes in the timing of a path; path(start, goal, n, s): the answer with another
    time scaling."""

    def timed(s_of):
        return lambda start, goal, n: path(start, goal, n, s_of(n))

    others = (lambda n, s=s: s(np.linspace(0, 1, n)) for s in TIME_SCALINGS)
    return (
        Mistake(
            "s is not the cubic: it is linear, a cosine, the quintic, or has other coefficients",
            "The cubic is 0, 1/2 and 1 at u = 0, 1/2 and 1, and its derivative is 0 at both ends. "
            "What is the derivative of your s?",
            *map(timed, others),
        ),
        Mistake(
            "u does not go from 0 to 1: one of the ends has no pose",
            "Print your u: what are its first and its last value?",
            timed(lambda n: cubic(np.arange(n) / n)),
            timed(lambda n: cubic(np.arange(1, n + 1) / n)),
        ),
    )


def step_mistakes(move):
    """Return the mistakes in the steps of a plan; move(row, velocity, h): a step of the answer."""

    def of_equal_steps(count):
        """Return the answer with count(duration / dt) steps of length dt for each pair."""
        return follow(move, lambda duration, dt: np.full(int(count(duration / dt)), dt))

    def start_again(start, plan, dt):
        parts = [follow(move)(start, [pair], dt)[1:] for pair in plan]
        return np.concatenate([np.array([start], float), *parts])

    return (
        Mistake(
            "a pair ends too late, because its last step is not shortened",
            "How much time of its duration remains for the last step?",
            of_equal_steps(lambda ratio: np.ceil(ratio - 1e-6)),
        ),
        Mistake(
            "a pair ends too early, because its last, shorter step is missing",
            "How much time of its duration remains after the steps of length dt?",
            of_equal_steps(lambda ratio: np.floor(ratio + 1e-6)),
        ),
        Mistake(
            "the number of steps is rounded, so that a pair ends too early or too late",
            "How much time of its duration remains for the last step?",
            of_equal_steps(np.round),
            of_equal_steps(lambda ratio: max(1, round(ratio))),
        ),
        Mistake("each pair begins at start again", "Where did the previous pair end?", start_again),
        Mistake(
            "the time since the pair began is taken for the length of a step",
            "How much time passes between the previous row and this one?",
            follow(move, lambda duration, dt: np.cumsum(lengths(duration, dt))),
        ),
        Mistake(
            "the steps of a pair are equally long, and not those of step_lengths(duration, dt)",
            "How long is each step that step_lengths returns for this pair?",
            follow(move, lambda duration, dt: _equal(duration, len(lengths(duration, dt)))),
        ),
    )


def _equal(duration, number):
    return np.full(number, duration / number)


def rotated(theta, v):
    """Return the vectors v (..., 2), rotated by theta (...)."""
    c, s = np.cos(theta), np.sin(theta)
    return np.stack([c * v[..., 0] - s * v[..., 1], s * v[..., 0] + c * v[..., 1]], -1)


def near(rows, others, angles, tolerance=PREDICTED):
    """Return whether two arrays of rows are the same but for whole revolutions of their angles."""
    largest = max(1, np.abs(others).max(initial=0))
    return bool(deviation(rows, others, angles) <= tolerance * largest)


def same_rows(angles):
    """Return whether answers are the rows that a mistake predicts, as `alike` of an exercise."""
    return lambda rows, predicted, *case: near(rows, predicted, angles)


def _ends(plan, dt):
    ends = [f"{end:.8g}" for end in np.cumsum(steps(plan, dt)[1])]
    return ", ".join(ends if len(ends) < 8 else [*ends[:3], "...", *ends[-2:]])


def _number_of_rows(rows, start, plan, dt):
    """Return the Mistake of an answer that has another number of rows."""
    too_few = len(rows) < 1 + len(steps(plan, dt)[1])
    # Where int(duration / dt) is the number of rows of each pair, one division shows what it drops.
    by_int = sum(int(duration / dt) for _, duration in plan) == len(rows) - 1
    for _, duration in plan:
        number = int(duration / dt)
        if by_int and number < len(lengths(duration, dt)):
            hint = (
                f"int({duration:.6g} / {dt:.6g}) is {number}. How many entries has "
                f"step_lengths({duration:.6g}, {dt:.6g})?"
            )
            return Question("a step has no row", hint)
    name = "a step has no row" if too_few else "there are more rows than steps"
    if len(plan) > 1:  # the wrong pair need not be the first
        numbers = ", ".join(str(len(lengths(duration, dt))) for _, duration in plan)
        return Question(
            name,
            f"For the pairs of this plan, step_lengths returns {numbers} entries, in this order. "
            "How many rows does your code append for each pair?",
        )
    duration = plan[0][1]
    return Question(
        name,
        f"How many entries has step_lengths({duration:.6g}, {dt:.6g}), and how many rows does your "
        "code append for this pair?",
    )


def form(angles):
    """Return the properties that come first: the start stands in the first row, and each step has a
    row."""
    return (
        Property(
            "the first row is start",
            lambda rows, start, plan, dt: near(rows[:1], [start], angles, EXACT),
            says=lambda rows, *case: (
                "It should be " + compared(np.asarray(case[0], float), rows[0]) + "."
                if len(rows)
                else "Yours has no row."
            ),
            otherwise=Question(
                "start is not the first row",
                "The list begins with start, before any step is made. Which line of yours writes "
                "its first row?",
            ),
        ),
        Property(
            "after start there is one row for each step",
            lambda rows, start, plan, dt: len(rows) == 1 + len(steps(plan, dt)[1]),
            says=lambda rows, start, plan, dt: (
                f"The steps end at {_ends(plan, dt)} s, so with start there are "
                f"{1 + len(steps(plan, dt)[1])} rows. "
                f"Yours has {len(rows)}."
            ),
            otherwise=_number_of_rows,
        ),
    )


def first_wrong_step(right_rows, angles):
    """Return `found` of an exercise on a plan: where the first step that is off should lead."""

    def found(rows, start, plan, dt):
        right = right_rows(start, plan, dt)
        apart = [deviation(*pair, angles) for pair in zip(rows, right, strict=True)]
        k = int(np.argmax(np.array(apart) > EXACT * max(1, np.abs(right).max())))
        velocities, times = steps(plan, dt)
        return (
            f"Step {k} is {times[k - 1]:.4g} s long, with the velocities "
            f"{format_tuple(velocities[k - 1])}: it leads from {format_tuple(right[k - 1])} to "
            + compared(right[k], rows[k])
            + "."
        )

    return found


def plans(columns):
    """Return what every exercise on a plan asks, with so many columns in a row: a velocity that
    occurs twice, a pause, and thirds of a second."""
    start = np.array([1.0, -2.0, 0.5])[-columns:]
    one, another = (0.5, -1.0, 2.0)[-columns:], (-2.0, 1.5, -1.0)[-columns:]
    pause = (0.0,) * columns
    each = [
        ([(one, 0.6), (one, 0.6)], 0.25),  # side by side, and apart
        ([(one, 0.6), (another, 0.5), (one, 0.6)], 0.25),
        # Nothing moves in a pause, but it has its rows, wherever it stands in the plan.
        ([(pause, 0.5)], 0.25),
        ([(pause, 0.5), (one, 0.5)], 0.25),
        ([(one, 0.5), (pause, 0.35)], 0.25),
        ([(one, 1.0), (another, 0.5)], 1 / 3),
        ([(one, 1 / 3), (another, 0.5)], 0.25),
    ]
    return [(start, plan, dt) for plan, dt in each]


def slow_motions(columns):
    """Return the Sweep of a start near 0 and of slow motions, with so many columns in a row."""

    def case(rng, size):
        start, slow, sideways = size * rng.uniform(-0.9, 0.9, (3, columns)).round(3)
        sideways[0] = 0.4
        plan = [(tuple(velocity.tolist()), 0.5) for velocity in (slow, sideways)]
        return start, plan, 0.25

    return Sweep("a start near 0, and slow motions", case, SMALL_NUMBERS)
