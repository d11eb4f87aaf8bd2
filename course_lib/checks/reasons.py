"""Why a verdict is what it is: the reason in fields, and the sentence that is written from them.

Whatever depends on a reason asks for its type and its fields, and never for words of its sentence.
So a word of a message can be changed, and no verdict changes with it. Two reasons are equal if they
say the same whatever the numbers of the cases are: fields that differ with these are not compared.
A reason on which nothing else depends may be a plain text.
"""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from course_lib.checks import call_student
from course_lib.checks.format_numbers import format_tuple

MAX_KINDS = 4  # of versions, which a message lists all
_ROUNDING = 1e-12  # below which an entry is shown as 0
_DIGITS = (4, 7, 10, 13, 17)  # tried in turn, until two numbers look different


@dataclass(frozen=True)
class Finding:
    """What was found in place of what should hold, in words, and by how much the answer is off.

    Texts can be added at both ends, which keep the number.

    Parameters
    ----------
    text : str
    off_by : float, optional
        Only if the text says it, or shows the two numbers whose difference it is.

    Examples
    --------
    >>> finding = "The tip is at (1, 2), " + off_by(0.5) + "."
    >>> str(finding), finding.off_by
    ('The tip is at (1, 2), off by 0.5.', 0.5)
    """

    text: str = ""
    off_by: float | None = None

    def __str__(self):
        return self.text

    def __add__(self, more):
        off_by = self.off_by
        if off_by is None:
            off_by = getattr(more, "off_by", None)
        return Finding(f"{self}{more}", off_by)

    def __radd__(self, before):
        return Finding(f"{before}{self}", self.off_by)


def off_by(gap):
    """Return the Finding that an answer is off by a gap, with two digits."""
    return Finding(f"off by {gap:.2g}", float(gap))


def compared(expected, answer, verb="is"):
    """Return the Finding what is wanted and what came, with the digits in which they differ, and by
    how much it is off if four digits do not show that.

    verb: "are" where the numbers are spoken of, and not a column or a point.
    """
    right, yours = format_tuple(expected), format_tuple(answer)
    gap = float(np.abs(answer - expected).max())
    if right != yours:
        return Finding(f"{right}; yours {verb} {yours}", gap)
    rounding = min(_ROUNDING, gap / 100)  # so that the entry that is off is not shown as 0
    for digits in _DIGITS:
        right, yours = (format_tuple(numbers, rounding, digits) for numbers in (expected, answer))
        if right != yours:
            break
    return f"{right}; yours {verb} {yours}, " + off_by(gap)


def first_entry_off(value, right, allowed=0.0):
    """Return the Finding which entry of an answer is the first that is off by more than allowed."""
    off = np.abs(value - right)
    index = tuple(int(k) for k in np.argwhere(off > min(allowed, off.max() / 2))[0])
    which = f"Entry {list(index)}" if index else "The answer"
    return f"{which} should be " + compared(right[index], value[index]) + "."


@dataclass(frozen=True)
class Fails:
    """Something that should hold of every answer does not.

    Parameters
    ----------
    holds : str
        What should hold, as a sentence without its end.
    found : Finding or str
        What was found instead, in whole sentences.
    """

    holds: str
    found: Finding | str = field(compare=False, default="")

    def __str__(self):
        return f"{self.holds}. {self.found}".rstrip()


@dataclass(frozen=True)
class Varies:
    """The same questions were answered otherwise when they were put again.

    Parameters
    ----------
    holds : str
        What does not hold of the answers.
    """

    holds: str = "called a second time with the same arguments, it gives the same result"

    def __str__(self):
        differ = "Your answers to the same questions differ from one time to the next."
        return f"{self.holds}. {differ}"


@dataclass(frozen=True)
class CallsForbidden:
    """The answer calls what its task excludes.

    Parameters
    ----------
    name : str
        Of the function that it calls.
    """

    name: str

    def __str__(self):
        return "compute the answer yourself."


@dataclass(frozen=True)
class WaitsFor:
    """The answer calls a function that is not written yet.

    Parameters
    ----------
    name : str
        Of that function.
    handed_in : bool
        Whether it can be written no more.
    """

    name: str
    handed_in: bool = field(default=False, compare=False)

    def __str__(self):
        if self.handed_in:
            return f"it calls {self.name}, which is not written."
        return (
            f"it calls {self.name}, which is not written yet. Write {self.name} first, then run "
            "this check again."
        )


@dataclass(frozen=True)
class Raised:
    """A call ended in an error.

    Parameters
    ----------
    call : str
        The call as a student writes it.
    kind, message : str
        The type of the error, and its text.
    source : str
        The student's last line that ran; "" if it is not known.
    cell : str
        The function in whose cell the line stands, "" if in the cell of the function itself.
    line : str
        The number of the line in its cell.
    caller : str
        The line of the function's own cell that led to a line of another cell; "" otherwise.
    """

    call: str
    kind: str
    message: str = field(compare=False, default="")
    source: str = ""
    cell: str = ""
    line: str = ""
    caller: str = ""

    def __str__(self):
        where = f"Calling {self.call}"
        if self.source:
            cell = f"the cell of {self.cell}" if self.cell else "its cell"
            where = f"Line {self.line} of {cell}, `{self.source}`,"
            if self.caller:
                where += f" which your line `{self.caller}` calls,"
        return f"{where} raises {self.kind}" + (f": {self.message}" if self.message else "")


@dataclass(frozen=True)
class OutOfTime:
    """Calls took more than they may.

    Parameters
    ----------
    call : str
        The call as a student writes it.
    bound : str
        What was used up: one of the bounds of call_student.
    seconds : float
        Of processor time, for all cases.
    """

    call: str
    bound: str
    seconds: float = call_student.CPU_SECONDS

    def __str__(self):
        if self.bound == call_student.TOO_MANY_CALLS:
            most = f"{call_student.MAX_CALLS:,} calls of the function that it tests"
        else:
            most = f"{self.seconds} seconds of computing"
        together = " in several calls together" if self.bound == call_student.TOGETHER else ""
        return f"{self.call} took more than {most}{together}."


@dataclass(frozen=True)
class CannotBeRead:
    """What a process sent back is not what was asked for.

    Parameters
    ----------
    problem : str
        "" where the text would be the student's.
    """

    problem: str = ""

    def __str__(self):
        problem = f": {self.problem}" if self.problem else ""
        return f"What came back cannot be read{problem}."


@dataclass(frozen=True)
class Misjudges:
    """A test rejects right versions, or accepts wrong ones.

    Parameters
    ----------
    rejected, accepted : sequence of str
        The kinds of the right versions that it rejects, and of the wrong ones that it accepts.
    n_right, n_wrong : int
        How many versions there are.
    """

    rejected: Sequence[str] = field(compare=False)
    accepted: Sequence[str] = field(compare=False)
    n_right: int = field(compare=False)
    n_wrong: int = field(compare=False)

    def __str__(self):
        rejected = f"{len(self.rejected)} of {self.n_right} right ones{_listed(self.rejected)}"
        accepted = f"{len(self.accepted)} of {self.n_wrong} wrong ones{_listed(self.accepted)}"
        return (
            "your test accepts every right version and rejects every wrong one. "
            f"Yours rejects {rejected} and accepts {accepted}."
        )


def _listed(kinds):
    """Return the kinds of versions, in brackets, of more than four only three; without their names.

    Each kind stands there with the number of its versions, and the last number counts the versions
    of all kinds that are not named, so that the numbers in a message add up.
    """
    counts = Counter(kinds)
    if not counts:
        return ""
    n_shown = len(counts) if len(counts) <= MAX_KINDS else 3
    shown = list(counts.items())[:n_shown]
    parts = [f"one {kind}{_and_more(count - 1)}" for kind, count in shown]
    n_others = len(kinds) - sum(count for _, count in shown)
    if n_others:
        parts.append(f"and {n_others} {'other' if n_others == 1 else 'others'}")
    return f" ({'; '.join(parts)})"


def _and_more(count):
    return f", and {count} more of this kind" if count else ""


@dataclass(frozen=True)
class RaisedForRightVersion:
    """A test raised an error for a right version.

    Parameters
    ----------
    error : Raised or Fails
    version : str
        The kind of the version.
    """

    error: object
    version: str = field(compare=False)

    def __str__(self):
        return f"{self.error}\nYour test raised this for a right version: one {self.version}."


@dataclass(frozen=True)
class InCircle:
    """Functions call each other in a circle, so that none of them computes anything.

    Parameters
    ----------
    names : tuple of str
        The function that was checked is the first.
    """

    names: tuple[str, ...]

    def __str__(self):
        return f"Your {' and '.join(self.names)} call each other in a circle."


@dataclass(frozen=True)
class LeftOut:
    """A cell that the answer may need was left out.

    Parameters
    ----------
    reason : object
        The reason of the verdict without that cell.
    how : str
        How the cell ended or blocked its process.
    """

    reason: object
    how: str

    def __str__(self):
        return f"{self.reason}\nA cell that it may need was left out: {self.how}.".strip()


def as_handed_in(reason):
    """Return a reason that gives no advice for which it is too late after the hand-in."""
    if isinstance(reason, WaitsFor):
        return replace(reason, handed_in=True)
    if isinstance(reason, LeftOut):
        return replace(reason, reason=as_handed_in(reason.reason))
    return reason


def first_error(reason):
    """Return the Raised that a reason is, or stands on; None if there is none."""
    while reason is not None and not isinstance(reason, Raised):
        reason = getattr(reason, "error", getattr(reason, "reason", None))
    return reason
