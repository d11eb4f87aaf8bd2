"""What exercises of notebook 2 share: paths of a body from start to goal, and plans of velocities.

The right path is known except for half a revolution, which is as short in either direction. So the
properties speak of the other cases first, and a path in either direction counts as the same.
"""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.special_cases import SMALL_NUMBERS, Sweep
from course_lib.checks.tolerances import EXACT, PREDICTED
from course_lib.checks.vocabulary import compared
from course_lib.planar import quintic_time_scaling, wrap_angle

BODY = np.array([False, False, True])  # the columns x, y and theta: which are angles
REVOLUTION = 2 * np.pi
MATRICES = Mistake(
    "the matrices of the poses are returned", "A row is (x, y, theta), read from the matrix T."
)


def are_matrices(array, *case):
    """Return whether an answer is a list of matrices (3, 3)."""
    return array.ndim == 3 and array.shape[1:] == (3, 3)


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


def same_path(rows, predicted, start, goal, n):
    """Return whether an answer is the path that a mistake predicts.

    For half a revolution, which is as short in either direction, the path in the other direction is
    as good.
    """
    paths = [predicted]
    if half_a_revolution(start, goal, n):
        paths.append(in_the_other_direction(predicted, start, goal))
    return any(deviation(rows, path) <= PREDICTED * size(start, goal) for path in paths)


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


def close(rows, wanted, start, goal):
    """Return whether rows are those wanted within a tolerance for rounding, up to multiples of 2 pi
    in the angle."""
    return deviation(rows, wanted) <= EXACT * size(start, goal)


def change(start, goal):
    """Return the change from start to goal, the angle along the shorter arc."""
    apart = np.subtract(goal, start).astype(float)
    return np.where(BODY, wrap_angle(apart), apart)


def one_arc_is_shorter(start, goal, n):
    """Return whether the angles are less than half a revolution apart, so that one arc is the
    shorter."""
    return abs(change(start, goal)[2]) < np.pi - 1e-9


def half_a_revolution(start, goal, n):
    """Return whether the angles are half a revolution apart, so that both arcs are equally long."""
    return not one_arc_is_shorter(start, goal, n)


read_path = numbers(lambda start, goal, n: (n, 3))  # n rows (x, y, theta)


ENDS = tuple(
    Property(
        f"the {word} pose is {name}",
        lambda rows, start, goal, n, k=k: close(rows[k], (start, goal)[k], start, goal),
        says=lambda rows, start, goal, n, k=k: (
            f"The right row is {compared((start, goal)[k], rows[k])}."
        ),
        where=one_arc_is_shorter,
    )
    for k, word, name in ((0, "first", "start"), (-1, "last", "goal"))
)


def _on_the_shorter_arc(rows, start, goal, n):
    """Return whether theta never leaves the shorter arc between the ends."""
    angle = change(start, goal)[2]
    ahead = np.copysign(1.0, angle) * (rows[:, 2] - start[2])
    return (np.mod(wrap_angle(ahead) + 1e-7, REVOLUTION) - 1e-7).max() <= abs(angle) + 1e-6


SHORTER_ARC = Property(
    "theta takes the shorter arc from start to goal",
    _on_the_shorter_arc,
    says=lambda rows, start, goal, n: (
        f"From {start[2]:.4g} to {goal[2]:.4g} rad the shorter arc is a rotation by "
        f"{change(start, goal)[2]:.4g} rad."
    ),
    where=one_arc_is_shorter,
    mistake=Mistake(
        "the body takes the longer arc",
        "Between which bounds should the difference of two directions lie?",
    ),
)


def on_a_line(rows, start, goal, n):
    """Return whether x and y lie on the straight line from start to goal."""
    p, q = np.asarray(start, float)[:2], np.asarray(goal, float)[:2]
    length = np.linalg.norm(q - p)
    ahead = (q - p) / length if length else np.zeros(2)
    aside = rows[:, :2] - p
    along = np.clip(aside @ ahead, 0, length)
    return np.linalg.norm(aside - along[:, None] * ahead, axis=1).max() <= EXACT * size(start, goal)


def timed(right, fits=close):
    """Return the properties that each row is on time; right(start, goal, s, angle): the right rows
    for any angle."""
    text = "at evenly spaced u from 0 to 1, the part s = 3 u^2 - 2 u^3 of the change is made"

    def path(start, goal, n, sign=1):
        return right(start, goal, scaling(n), sign * change(start, goal)[2])

    def seen(rows, start, goal, n):
        missed = [deviation(*pair) for pair in zip(rows, path(start, goal, n), strict=True)]
        k = int(np.argmax(np.array(missed) > EXACT * size(start, goal)))
        u = k / (n - 1)
        return f"The row with index {k} belongs to u = {u:.4g}, and s is {cubic(u):.4g} there."

    def holds(rows, start, goal, n):
        return fits(rows, path(start, goal, n), start, goal)

    def in_either_direction(rows, start, goal, n):
        return any(fits(rows, path(start, goal, n, sign), start, goal) for sign in (1, -1))

    return (
        Property(text, holds, seen, where=one_arc_is_shorter),
        Property(
            f"for half a revolution, in either direction: {text}",
            in_either_direction,
            where=half_a_revolution,
        ),
    )


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


def add_path_mistakes(exercise, path):
    """Add the mistakes in the timing of a path; path(start, goal, n, s): the answer with another
    time scaling."""

    exercise.mistake(MATRICES, form=lambda array, start, goal, n: array.shape == (n, 3, 3))

    @exercise.mistake(
        "s is not the cubic: it is linear, a cosine, the quintic, or has other coefficients",
        "The cubic is 0, 1/2 and 1 at u = 0, 1/2 and 1, and its derivative is 0 at both ends. What "
        "is the derivative of your s?",
        s=TIME_SCALINGS,
    )
    def other_time_scaling(start, goal, n, s):
        return path(start, goal, n, s(np.linspace(0, 1, n)))

    @exercise.mistake(
        "u does not go from 0 to 1: one of the ends has no pose",
        "Print your u: what are its first and its last value?",
        u=(lambda n: np.arange(n) / n, lambda n: np.arange(1, n + 1) / n),
    )
    def an_end_missing(start, goal, n, u):
        return path(start, goal, n, cubic(u(n)))


def add_step_mistakes(exercise, move):
    """Add the mistakes in the steps of a plan; move(row, velocity, h): a step of the answer."""

    def of_equal_steps(count, *case):
        """Return the answer with `count` steps of length dt for each pair."""
        return follow(move, lambda duration, dt: np.full(int(count(duration / dt)), dt))(*case)

    @exercise.mistake(
        "a pair ends too late, because its last step is not shortened",
        "How much time of its duration remains for the last step?",
    )
    def too_late(*case):
        return of_equal_steps(lambda ratio: np.ceil(ratio - 1e-6), *case)

    @exercise.mistake(
        "a pair ends too early, because its last, shorter step is missing",
        "How much time of its duration remains after the steps of length dt?",
    )
    def too_early(*case):
        return of_equal_steps(lambda ratio: np.floor(ratio + 1e-6), *case)

    @exercise.mistake(
        "the number of steps is rounded, so that a pair ends too early or too late",
        "How much time of its duration remains for the last step?",
        count=(np.round, lambda ratio: max(1, round(ratio))),
    )
    def rounded(*case, count):
        return of_equal_steps(count, *case)

    @exercise.mistake(
        "each pair begins at start again",
        "Where did the previous pair end?",
    )
    def start_again(start, plan, dt):
        parts = [follow(move)(start, [pair], dt)[1:] for pair in plan]
        return np.concatenate([np.array([start], float), *parts])


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
    ends = [f"{end:.4g}" for end in np.cumsum(steps(plan, dt)[1])]
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
            return Mistake("a step has no row", hint)
    name = "a step has no row" if too_few else "there are more rows than steps"
    if len(plan) > 1:  # the wrong pair need not be the first
        numbers = ", ".join(str(len(lengths(duration, dt))) for _, duration in plan)
        return Mistake(
            name,
            f"For the pairs of this plan, step_lengths returns {numbers} entries, in this order. "
            "How many rows does your code append for each pair?",
        )
    duration = plan[0][1]
    return Mistake(
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
                f"Yours is {format_tuple(rows[0])}." if len(rows) else "Yours has no row."
            ),
            mistake=Mistake(
                "start is not the first row", "The list begins with start, before any step is made."
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
            mistake=_number_of_rows,
        ),
    )


def each_step(text, move, angles, part=slice(None), where=None):
    """Return the Property that each step leads where move(row, velocity, h) does, in some
    columns."""

    def first_off(rows, plan, dt):
        for k, (velocity, h) in enumerate(zip(*steps(plan, dt), strict=True)):
            right = move(rows[k], velocity, h)
            if not near(rows[k + 1, part], right[part], np.asarray(angles)[part], EXACT):
                return k, velocity, h, right[part]
        return None

    def says(rows, start, plan, dt):
        k, velocity, h, right = first_off(rows, plan, dt)
        return (
            f"Step {k + 1} is {h:.4g} s long, with the velocities {format_tuple(velocity)}: it "
            f"leads from "
            f"{format_tuple(rows[k, part])} to {compared(right, rows[k + 1, part])}."
        )

    return Property(
        text, lambda rows, start, plan, dt: first_off(rows, plan, dt) is None, says, where=where
    )


def slow_motions(columns):
    """Return the Sweep of a start near 0 and of slow motions, with so many columns in a row."""

    def case(rng, size):
        start, slow, sideways = size * rng.uniform(-0.9, 0.9, (3, columns)).round(3)
        sideways[0] = 0.4
        plan = [(tuple(velocity.tolist()), 0.5) for velocity in (slow, sideways)]
        return start, plan, 0.25

    return Sweep("a start near 0, and slow motions", case, SMALL_NUMBERS)


def goes_straight(start, plan, dt):
    """Return whether a plan has no rotation, and no rest."""
    return all(velocity[2] == 0 and np.any(velocity) for velocity, _ in plan)


def _lengths_covered(rows, plan, dt):
    ahead, left = rotated(-rows[0, 2], np.diff(rows[:, :2], axis=0)).T
    return np.where(np.abs(left) < EXACT, ahead, 0) / steps(plan, dt)[0][:, 0]


STEP_LENGTHS = Property(
    "each step is dt long, and the last one of a pair is shortened if otherwise the pair would end "
    "too late",
    # A step in another direction has no length here: of its direction other properties speak.
    lambda rows, start, plan, dt: (
        (covered := _lengths_covered(rows, plan, dt)).min() < EXACT
        or np.abs(covered - steps(plan, dt)[1]).max() < EXACT
    ),
    says=lambda rows, start, plan, dt: (
        f"By the distance covered, yours are {format_tuple(_lengths_covered(rows, plan, dt))} s "
        f"long; "
        f"they should be {format_tuple(steps(plan, dt)[1])}."
    ),
    where=lambda start, plan, dt: all(ahead and not any(rest) for (ahead, *rest), _ in plan),
    mistake=Mistake(
        "the steps have other lengths than step_lengths(duration, dt)",
        "A step begins where the previous step has ended: how long is each step itself?",
    ),
)
