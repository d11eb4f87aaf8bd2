"""What an exercise is: arguments and cases, what must hold of every answer, and known mistakes."""

import functools
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from course_lib.arguments import read_only
from course_lib.checks.comparisons import attempt, difference, same
from course_lib.checks.examine import examine
from course_lib.checks.mistake import Mistakes, Question
from course_lib.checks.special_cases import Sweep, made_cases, special_at_once

# Of the sets of cases in the notebook, which ask for everything that is hard. Grading asks the same
# sets, and then the author's cases with other numbers, drawn from a secret seed.
PUBLIC_SEED = 2024
PUBLIC_SETS = 3


@dataclass(frozen=True)
class Property:
    """Something that must hold of every answer.

    Parameters
    ----------
    text : str
        What should hold, as a sentence that can follow "What should hold:".
    holds : callable
        holds(value, *arguments): whether it does. With across=True, holds(values, cases) looks at
        all answers together and returns the position of the first wrong one, or None. They are the
        first few if a later one cannot be read.
    says : callable, optional
        says(value, *arguments): a sentence, or a Finding, on what was found instead.
    where : callable, optional
        where(*arguments): whether the property applies to this case.
    across : bool
    otherwise : Question or callable, optional
        What is asked if no mistake explains the answers; or otherwise(value, *arguments), which
        returns a Question, None, or a Mistake that it has read off the value with certainty.
    points : int
        Partial credit: the points earned if this property holds and another does not.
    compares : bool
        Whether it compares the whole answer with the library's. Of an answer in which only later
        digits are off the message then says this, and asks nothing else.

    Examples
    --------
    >>> text = "the answer is positive"
    >>> positive = Property(text, lambda value, x: value > 0, where=lambda x: x != 0)
    >>> positive.failing([(0,), (1,), (2,)], [-1, -1, 5])
    [1]
    """

    text: str
    holds: Callable
    says: Callable | None = None
    where: Callable | None = None
    across: bool = False
    otherwise: Question | Callable | None = None
    points: int = 0
    compares: bool = False

    def __post_init__(self):
        if self.otherwise is None or isinstance(self.otherwise, Question):
            return
        if not callable(self.otherwise):
            raise TypeError(
                f"otherwise: a Question, or a function that looks at the answer; "
                f"{self.otherwise!r} came, which no answer needs to show"
            )

    def failing(self, cases, values):
        """Return the positions of the cases in which the property does not hold."""
        if self.across:
            first = self.holds(values, cases)
            return [] if first is None else [first]
        asked = [i for i, case in enumerate(cases) if self.where is None or self.where(*case)]
        return [i for i in asked if not attempt(self.holds, values[i], *cases[i])]


def _all(*arguments):
    return True


@dataclass(frozen=True, eq=False)
class Exercise:
    """One task of a notebook.

    Its mistakes are its argument `mistakes`, as `declared` gives them, or stand below it, as
    functions with the decorator `EXERCISE.mistake`.

    Parameters
    ----------
    name : str
        The function's name.
    points : int
    arguments : tuple of str
        The names of the function's arguments.
    cases : callable
        cases(rng): tuples of arguments, an ordinary simple one first, special cases after it. The
        engine adds more, of whole numbers for example; see special_cases.py.
    returns : callable
        returns(value, *arguments): the answer in the form that the properties expect (see
        answer_types.py); raises Unreadable.
    properties : tuple of Property
        In the order in which they are examined.
    hints : tuple of str
        In steps; the last one may give the formula.
    library : callable
        A right answer: the library's function, or one that the check defines if the library has
        none.
    forbidden : tuple of str
        Dotted names that the answer may not call.
    through : str
        How the function is called: a key of adapters.ADAPTERS.
    alike : callable
        alike(value, predicted, *arguments): whether an answer is what a mistake predicts.
    builds_on : tuple of str
        Exercises of the same notebook that the task tells to call, although it excludes the
        library's versions of them.
    distance : callable
        distance(value, right, *arguments): how far an answer is from the library's, however it is
        written; inf for another shape. Where it is small, messages print it.
    broken : callable, optional
        If the task is to find a bug: a function that answers as the broken code does, None
        included.
    tolerance : float, optional
        The error that a right answer may have, one of tolerances.py: the task states it.
    sweeps : tuple of Sweep
        The special values of the arguments: the engine makes cases beside each of them.
    angles : tuple of str
        The arguments that are angles: the engine makes a case beyond one revolution.
    small : tuple of str
        The arguments that may hold small numbers, which somebody may take for 0: the engine makes
        cases in which they do. Rotations, poses and unit vectors stay what they are.
    free : tuple of str
        The arguments that do not depend on the others: the engine makes cases in which one of them
        alone is changed.
    special : callable, optional
        special(rng): a case whose arguments are all special at once, on a coarse grid for example;
        None where there is no such case. The engine asks many of them, and others beside them.
    admits : callable
        admits(*arguments): whether the task admits these special arguments together.
    is_exact : bool
        Whether the last bits of the arguments decide which answer is right.
    tries_arguments : bool
        Whether to try the right answer for changed arguments, as it is done for every exercise;
        False where `library` is slow.
    sets : int
        Of cases, each of other numbers, that the notebook asks: fewer where an answer takes long.
    mistakes : Mistakes
        In the order in which they are tried; `mistake` adds one.

    Examples
    --------
    >>> twice = Property("the answer is 2 x", lambda value, x: value == 2 * x)
    >>> cases, read = lambda rng: [(2.0,), (3.0,)], lambda value, x: value
    >>> double = Exercise("double", 1, ("x",), cases, read, (twice,), hints=())
    >>> @double.mistake("x is squared", "What is twice x?")
    ... def squared(x):
    ...     return x**2
    >>> from course_lib.checks.judge import LocalFunction, judge
    >>> judge(double, LocalFunction(lambda x: x * x)).mistake
    Mistake('x is squared')
    """

    name: str
    points: int
    arguments: tuple[str, ...]
    cases: Callable
    returns: Callable
    properties: tuple[Property, ...]
    hints: tuple[str, ...]
    library: Callable | None = None
    forbidden: tuple[str, ...] = ()
    builds_on: tuple[str, ...] = ()
    through: str = ""
    alike: Callable = same
    distance: Callable = difference
    broken: Callable | None = None
    tolerance: float | None = None
    sweeps: tuple[Sweep, ...] = ()
    angles: tuple[str, ...] = ()
    small: tuple[str, ...] = ()
    free: tuple[str, ...] = ()
    special: Callable | None = None
    admits: Callable = _all
    is_exact: bool = False
    tries_arguments: bool = True
    sets: int = PUBLIC_SETS
    mistakes: Mistakes = field(default_factory=Mistakes)

    @property
    def mistake(self):
        """The decorator of a function that answers as a student does who makes this mistake; see
        Mistakes.add."""
        return self.mistakes.add

    @property
    def public_seeds(self):
        """The seeds of the sets that the notebook asks, and grading too."""
        return range(PUBLIC_SEED, PUBLIC_SEED + self.sets)

    def questions(self, seed):
        """Return the cases of a seed, and a function that answers calls of candidates; here None.

        The author's cases come first. In the notebook's sets those that the engine makes follow;
        see special_cases.py. A secret seed decides numbers and never difficulty: whether an answer
        passes just beside a special value must not depend on it.
        """
        return list(_drawn_cases(self, seed)), None

    def verdict(self, cases, answers):
        """Return the Verdict on the answers, given as call_student.reply describes them."""
        return examine(self, cases, answers)


@functools.lru_cache(maxsize=100)
def _drawn_cases(exercise, seed):
    """Return the cases of a seed, which are drawn once for all answers; see Exercise.questions."""
    rng = np.random.default_rng(seed)
    cases = list(exercise.cases(rng))
    if seed in exercise.public_seeds:
        sweeps, angles = exercise.sweeps, exercise.angles
        small, free = exercise.small, exercise.free
        cases += made_cases(cases, exercise.arguments, sweeps, angles, rng, small, free)
        if exercise.special is not None:
            admits = functools.partial(_is_admitted, exercise)
            cases += special_at_once(exercise.special, admits, rng, exercise.is_exact)
    return tuple(map(_unchangeable, cases))


def _is_admitted(exercise, *case):
    """Return whether the task admits these arguments together, and the library takes them: the
    engine does not know every kind of argument."""
    if not exercise.admits(*case):
        return False
    try:
        if exercise.library is not None:
            exercise.library(*case)
    except ValueError:
        return False
    return True


def _unchangeable(case):
    """Return a case of the same type with copies of its arrays that nobody can change."""
    return type(case)(read_only(part) if isinstance(part, np.ndarray) else part for part in case)
