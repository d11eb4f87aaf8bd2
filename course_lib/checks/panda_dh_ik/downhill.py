"""ik_step_transpose: one step of the joint angles along J^T e. Its cases and its reader serve ik_step_dls too."""

import numpy as np

from course_lib.arms import panda
from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.poe_kuka_iiwa.chains import few_digits
from course_lib.checks.rotations.predicates import either
from course_lib.checks.subproblems_damped_ik.damped_step import off

FLAT = np.array([[1.0, 0, 0], [0, 1, 0]])
SQUARE = np.array([[1.0, 2], [0, 1]])
WHOLE = np.array([[0, 1, 2], [1, -1, 0]])
_PANDA = panda()


def panda_jacobian(q):
    """The Jacobian (6, 7) of the Panda's flange, (v, omega)."""
    return np.roll(_PANDA.geometric_jacobian(q), 3, axis=0)


def panda_step(rng):
    """Joint angles of the Panda, beyond its limits in places, their Jacobian and an error."""
    q = np.round(rng.uniform(*_PANDA.limits.T), 2)
    return q, panda_jacobian(q), np.round(rng.uniform(0.2, 0.9, 6) * rng.choice([-1, 1], 6), 2)


def some_step(rng, m, n):
    """Angles (n,), a matrix (m, n) and an error (m,), none of their entries small, some angles above half a turn."""
    drawn = (rng.uniform(0.3, 1.2, size) * rng.choice([-1, 1], size) for size in (n, (m, n), m))
    q, J, e = (np.round(array, 2) for array in drawn)
    q[-1] += 3
    return q, J, e


_TABLE = Mistake(
    "q and what is added to it differ in shape",
    "Arrays of the shapes (n,) and (n, 1) add up to a table (n, n). Keep e flat: J.T @ e has shape (n,).",
)
read = numbers(
    lambda q, *rest: (len(q),),
    lambda array, q, J, *rest: _TABLE if array.shape in ((len(q), len(q)), J.T.shape) else None,
)

_SHAPES = "J is (m, n), e is (m,), q is (n,). Which product of J, or J.T, and e has the shape (n,)?"
NO_PRODUCT = Mistake("e is multiplied by a matrix of another shape: J takes rates of joints, J.T takes e", _SHAPES)
NO_SUM = Mistake("arrays are multiplied entry by entry, or added, whose shapes do not fit", f"@, not *. {_SHAPES}")
NO_PRODUCTS = ("ValueError", "core dimension", NO_PRODUCT), ("ValueError", "not aligned", NO_PRODUCT)
WHOLE_NUMBERS = Mistake(
    "q is kept as whole numbers",
    "q += ... writes into q itself, which may hold whole numbers only, and changes it. q + ... makes a new array.",
)


def cut_off(right):
    """The mistake of an answer that holds whole numbers only, always or where q does."""
    name = "digits after the point are cut off"
    hint = "np.array([1, 2, -1]) holds whole numbers only: np.array(q, float) has room for digits."

    def seen(answer, q, *rest):
        return q.dtype.kind == "i" and np.array_equal(answer, np.trunc(answer))

    return (
        Mistake(name, hint, lambda q, *rest: np.trunc(right(q, *rest)) if q.dtype.kind == "i" else None),
        Mistake(name, hint, lambda *case: np.trunc(right(*case))),
        Mistake(name, hint, seen=seen),
    )


def clipped(right):
    """The mistake of keeping joints inside limits."""

    def inside_the_pandas(q, *rest):
        return np.clip(right(q, *rest), *_PANDA.limits.T) if len(q) == 7 else None

    return either(
        (
            "the angles are kept inside limits",
            "No limits are asked for here. They are looked at in panda_ik, after the step.",
        ),
        lambda *case: np.clip(right(*case), -np.pi, np.pi),
        lambda *case: np.clip(right(*case), -2 * np.pi, 2 * np.pi),
        inside_the_pandas,
        lambda q, *rest: np.clip(right(q, *rest), *_PANDA.limits.T) if len(q) == 7 else right(q, *rest),
    )


def in_degrees(right):
    return either(
        ("degrees and radians are mixed up", "Angles are radians everywhere: no np.deg2rad, no np.rad2deg."),
        lambda *case: case[0] + np.rad2deg(right(*case) - case[0]),
        lambda *case: case[0] + np.deg2rad(right(*case) - case[0]),
        lambda *case: np.rad2deg(right(*case)),
        lambda *case: np.deg2rad(right(*case)),
    )


def turns(right):
    """Return a `seen` that tells of the joint that is turned most wrongly."""

    def seen(answer, q, *rest):
        wanted, turned = right(q, *rest) - q, answer - q
        j = int(np.argmax(np.abs(np.exp(1j * turned) - np.exp(1j * wanted))))
        return f"q[{j}] should change by {wanted[j]:.5g}; in your answer it changes by {turned[j]:.5g}."

    return seen


def step_of(q, J, e, step):
    return q + step * J.T @ e


def _cases(rng):
    zero = np.zeros(3)
    named = [
        (zero, FLAT, [1, 2], 0.1),
        (np.array([0.5, -0.5, 2]), FLAT, [1, 2], 0.1),
        (np.array([0.5, -0.5, 2]), FLAT, [0, 0], 0.1),
        (np.array([0.5, -0.5, 2]), FLAT, [1e-5, 2e-5], 0.1),
        (np.array([1.0, 2]), SQUARE, [1, 3], 0.2),
        (np.array([1.0, 2]), SQUARE, [1, 3], 2.0),
        (np.array([1, 2, -1]), WHOLE, [1, 3], 0.25),
    ]
    drawn = [(*some_step(rng, *size), step) for size, step in (((2, 4), 0.3), ((1, 3), 1.5), ((3, 3), 0.05))]
    drawn += [(*some_step(rng, 6, 6), 0.7), (*some_step(rng, 3, 2), 0.4)]
    drawn += [(*panda_step(rng), step) for step in (0.3, 0.05, 1.0, 4.0)]
    q, J, _ = panda_step(rng)
    return [(q, J, np.array(e, float), step) for q, J, e, step in [*named, *drawn, (q, J, np.zeros(6), 0.3)]]


def _right(answer, *case):
    return off(answer, step_of(*case)) < 1e-9 * (1 + np.abs(step_of(*case)).max())


def _parallel(answer, q, J, e, step):
    wanted, turned = J.T @ e, answer - q
    size = wanted @ wanted
    return size > 0 and np.abs(turned - (turned @ wanted) / size * wanted).max() < 1e-9 * (1 + np.abs(turned).max())


def _by(way_of):
    """The angles of somebody who adds way_of(J, e, step)."""
    return lambda q, J, e, step: q + way_of(J, e, step)


def unit_or_zero(vector):
    return vector / (np.linalg.norm(vector) or 1)


def halves_exchanged(e):
    return np.roll(e, 3) if len(e) == 6 else e


IK_STEP_TRANSPOSE = Exercise(
    name="ik_step_transpose",
    points=1,
    arguments=("q", "J", "e", "step"),
    cases=_cases,
    returns=read,
    properties=(
        Property(
            "where nothing is left to do (e is 0) the angles stay as they are",
            _right,
            turns(step_of),
            where=lambda q, J, e, step: not e.any(),
        ),
        Property("the answer is q + step J^T e", _right, turns(step_of), where=lambda q, J, e, step: e.any()),
    ),
    mistakes=(
        few_digits(step_of),
        Mistake(
            "the step goes the other way, away from the target",
            "e is what is left to do, target minus place. So the step is added.",
            lambda q, J, e, step: q - step * J.T @ e,
        ),
        Mistake(
            "only the step is returned",
            "The angles after the step: q and the step together.",
            lambda q, J, e, step: step * J.T @ e,
            lambda q, J, e, step: -step * J.T @ e,
            lambda q, J, e, step: J.T @ e,
        ),
        Mistake("q itself is returned: nothing moves", "Add step J^T e to it.", lambda q, *rest: q),
        Mistake("step is not used", "J^T e is multiplied by step.", _by(lambda J, e, step: J.T @ e)),
        Mistake("step is squared", "J^T e is multiplied by step once.", _by(lambda J, e, step: step**2 * J.T @ e)),
        Mistake("J^T e is divided by step", "J^T e is multiplied by step.", _by(lambda J, e, step: J.T @ e / step)),
        Mistake(
            "step multiplies q as well",
            "Only J^T e is multiplied by step: q + step * (J.T @ e).",
            lambda q, J, e, step: step * (q + J.T @ e),
            lambda q, J, e, step: (1 - step) * q + step * J.T @ e,
            lambda q, J, e, step: step * q + J.T @ e,
        ),
        Mistake(
            "the step is the pseudoinverse's, not the transpose's",
            "J.T @ e, and no equations to solve: that is what makes this step cheap.",
            _by(lambda J, e, step: step * np.linalg.pinv(J) @ e),
            _by(lambda J, e, step: np.linalg.pinv(J) @ e),
        ),
        Mistake(
            "the step is the damped one",
            "That is ik_step_dls. Here it is J.T @ e, times step.",
            _by(lambda J, e, step: J.T @ np.linalg.solve(J @ J.T + step * np.eye(len(J)), e)),
        ),
        Mistake(
            "the step is scaled to the length `step`",
            "J^T e gets small near the target by itself. It is not divided by its length.",
            _by(lambda J, e, step: step * unit_or_zero(J.T @ e)),
            _by(lambda J, e, step: unit_or_zero(J.T @ e)),
        ),
        Mistake(
            "the error is divided by its length",
            "The step is made of e itself: near the target it gets small.",
            _by(lambda J, e, step: step * J.T @ unit_or_zero(e)),
        ),
        Mistake(
            "J stands for its transpose where both have the right shape",
            "J.T @ e, or e @ J.",
            *(
                lambda q, J, e, step, sign=sign: q + sign * step * J @ e if len(q) == len(e) else step_of(q, J, e, step)
                for sign in (1, -1)
            ),
        ),
        Mistake(
            "the step is twice as long as asked for, or half",
            "It is the gradient of half the squared error.",
            _by(lambda J, e, step: 2 * step * J.T @ e),
            _by(lambda J, e, step: step / 2 * J.T @ e),
        ),
        Mistake(
            "the halves of e are exchanged",
            "e and the rows of J stand in the same order already: J.T @ e.",
            _by(lambda J, e, step: step * J.T @ halves_exchanged(e)),
        ),
        Mistake(
            "each entry of J^T e loses its sign, or keeps nothing else",
            "J.T @ e as it is: no abs, no sign.",
            _by(lambda J, e, step: step * np.abs(J.T @ e)),
            _by(lambda J, e, step: step * np.sign(J.T @ e)),
        ),
        *clipped(step_of),
        *in_degrees(step_of),
        *cut_off(step_of),
        Mistake(
            "the step has the right direction and a wrong length",
            "Print your step for this input, and step * J.T @ e: is there a factor that does not belong?",
            seen=_parallel,
        ),
    ),
    hints=(
        "J is (m, n): it takes n joint rates to m numbers. Its transpose goes from m to n: J.T @ e.",
        "Multiply by step and add to q.",
        "return q + step * J.T @ e makes a new array, so that q stays as it is.",
    ),
    errors=(*NO_PRODUCTS, ("ValueError", "broadcast", NO_SUM), ("UFuncTypeError", "", WHOLE_NUMBERS)),
)
