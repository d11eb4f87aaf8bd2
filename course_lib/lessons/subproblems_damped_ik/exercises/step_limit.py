"""step_limit: find the bug.

The largest step size with which damped steps converge near the target.
"""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.kinds import Kind, number, whole_numbers
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import SMALL, SMALL_NUMBERS, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import compared
from course_lib.lessons.subproblems_damped_ik.exercises.shared import single

# The eigenvalues of a square J are not its singular values.
_SHAPES = (3, 6), (2, 2), (3, 3), (2, 4), (1, 4)


def _nearly_equal(rng, gap):
    """Return a Jacobian (2, 4) whose singular values are nearly the same."""
    U, _, Vt = np.linalg.svd(rng.normal(size=(2, 4)), full_matrices=False)
    return U * [1.0, 1 - gap] @ Vt


def _coarse(rng):
    """Return a Jacobian (2, 3) of full rank in whole numbers."""
    J = whole_numbers(rng, (2, 3))
    return J if np.cross(*J).any() else _coarse(rng)


JACOBIAN = Kind(
    drawn=lambda rng: rng.normal(size=(2, 4)),
    named=lambda rng: [
        np.diag([2.0, 1.0]),
        np.diag([1.0, 2.0]),
        np.array([[0.0, -1, -1, -1], [4, 3, 2, 1]]),
        *(rng.normal(size=shape) for shape in _SHAPES),
    ],
    beside=(("nearly equal singular values", _nearly_equal, SMALL),),
    coarse=_coarse,
    small=True,
)
DAMPING = number(0.3, 5, 1.0, 0.01, 50.0).but(
    beside=(("little damping", lambda rng, eps: eps, SMALL_NUMBERS),)
)


def _by(limit):
    return lambda J, eps: limit(np.linalg.svd(J, compute_uv=False), eps)


def _with_share(share):
    """Return the answer 2 (1 + share(s, eps)), of the singular values s."""
    return _by(lambda s, eps: 2 * (1 + share(s, eps)))


def _with_square(square):
    return _with_share(lambda s, eps: eps / square(s))


def _smaller(rng, size):
    """Return the case of an arm in smaller units, whose limit is the same however tiny eps is."""
    return size * rng.normal(size=(2, 4)), 0.5 * size**2


def _found(limit, J, eps):
    s = np.linalg.svd(J, compute_uv=False)
    factors = 1 - limit * s**2 / (s**2 + eps)
    return (
        "With your alpha a step multiplies the errors along the singular directions by "
        f"{format_tuple(factors)}. The smallest factor should be "
        + compared(-1.0, factors.min())
        + "."
    )


EXERCISE = declared(
    "step_limit",
    points=1,
    arguments={"J": JACOBIAN, "eps": DAMPING},
    sweeps=(Sweep("an arm in smaller units", _smaller, SMALL_NUMBERS),),
    tolerance=EXACT,
    reads=lambda value, *case: single(value, "one number"),
    library=_with_square(lambda s: s[0] ** 2),
    broken=_with_square(lambda s: s[-1] ** 2),
    says="at the limit the smallest factor is -1, and no factor is below it",
    found=_found,
    otherwise=Question(
        "the smallest factor is not -1 at your limit",
        "How does the factor of a direction depend on alpha and on eps, and in which direction "
        "does it reach -1 first? To how many digits does your code find that alpha?",
    ),
    hints=(
        "Take J = diag(2, 1) and eps = 1, and compute the factor of a step in both directions at "
        "the returned limit.",
        "The factor has to lie between -1 and 1 in every direction: the strictest direction "
        "decides.",
        "numpy sorts singular values from the largest to the smallest: the largest one is number "
        "0.",
    ),
    mistakes=(
        Mistake(
            "one direction decides, and not the strictest one",
            "The factor must stay above -1 in every direction: in which direction does it reach -1 "
            "first?",
            _with_square(lambda s: s[1] ** 2),
            _with_square(lambda s: s[-2] ** 2),
        ),
        Mistake(
            "the singular values are combined: in a norm, a mean or a product",
            "Each direction has a factor of its own. At which alpha does the first of them reach "
            "-1?",
            _with_square(lambda s: np.mean(s) ** 2),
            _with_square(np.prod),
            _with_square(lambda s: np.sum(s**2)),
        ),
        Mistake(
            "s or eps stands in a wrong power",
            "Compare with the factor of a step, and ask whether you have s or its square: what are "
            "the eigenvalues of J J^T?",
            _with_share(lambda s, eps: eps / s[0]),
            _with_share(lambda s, eps: (eps / s[0]) ** 2),
            _with_share(lambda s, eps: eps / s[0] ** 4),
        ),
        Mistake(
            "the limit without damping is returned",
            "eps makes each step shorter: what does this mean for alpha?",
            lambda J, eps: 2.0,
            _by(lambda s, eps: 2 / s[0] ** 2),
        ),
    ),
)
