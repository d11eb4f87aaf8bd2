"""The outcome of a check."""

from dataclasses import dataclass

from course_lib.checks.format_numbers import SHOWN_DIGITS
from course_lib.checks.mistake import Mistake, Question

RIGHT, WRONG, ERROR, NOT_ATTEMPTED = "right", "wrong", "error in your code", "not attempted yet"
UNCHANGED = "the bug is still there"  # what is returned is what the given code returns


@dataclass(frozen=True)
class Verdict:
    """The outcome of a check.

    Parameters
    ----------
    exercise : Exercise
    state : str
        RIGHT, WRONG, ERROR, NOT_ATTEMPTED or UNCHANGED.
    reason : str or one of reasons.py
        What should hold, or what happened. str(reason) is its sentence.
    mistake : Mistake or Question, optional
        What the message claims, or asks where it claims nothing.
    case, answer : optional
        The simplest failing case and the answer given in it.
    digits : int
        With which the numbers of the case must be shown for it to fail when it is pasted.
    note : str
        A remark on a right answer.
    credit : int
        The points of a wrong answer.
    blames : str
        The name of another exercise that the answer calls and that is not right yet.
    instead : tuple of str
        The names of the exercises that the answer calls and that are not right, so that right
        functions stood in their place.
    """

    exercise: object
    state: str
    reason: object = ""
    mistake: Mistake | Question | None = None
    case: tuple | None = None
    answer: object = None
    digits: int = SHOWN_DIGITS[0]
    note: str = ""
    credit: int = 0
    blames: str = ""
    instead: tuple[str, ...] = ()

    @property
    def points(self):
        """All points of the exercise if the answer is right, else the partial credit."""
        return self.exercise.points if self.state == RIGHT else self.credit
