"""Exercises in which the student writes a test: a function that takes a candidate and returns
whether it is right.

The candidates are several forms of the library's function, and wrong versions of it. None of them
is in the student's process. The student's test calls a stand-in, which sends the arguments to the
process that judges and returns that process's answer. Grading asks about each candidate in a
process of its own, to which only that one answers: so a test can distinguish candidates only by
their answers, and not by comparing one with another. Their order is drawn from the seed.
"""

import hashlib
import json
from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np

from course_lib.checks.answer_types import Unreadable, boolean
from course_lib.checks.comparisons import attempt
from course_lib.checks.examine import FORGOTTEN_RETURN, no_answer
from course_lib.checks.exercise import Exercise
from course_lib.checks.mistake import Mistake
from course_lib.checks.reasons import Fails, Misjudges, RaisedForRightVersion
from course_lib.checks.verdict import ERROR, NOT_ATTEMPTED, RIGHT, WRONG, Verdict
from course_lib.checks.wire import Candidate, from_json, to_json

_MAX_CHARACTERS = 20_000  # in the arguments of one call, as JSON
# Of answers that are kept, of at most so many characters. About twenty-five versions are called up
# to 5,000 times each. Together they take about 60 MB.
_MAX_KEPT = 130_000
_MAX_KEPT_CHARACTERS = 1_000
_ENDS_HERE = ("NotImplementedError", "NotPlain", "NotAllowed", "TimeUp", "KeyboardInterrupt")

ALWAYS_TRUE = Mistake(
    "your test accepts everything",
    "With which arguments does it call the function that it is given, and would a wrong answer "
    "show there? Compare it "
    "with something that must hold for every right version.",
)
ALWAYS_FALSE = Mistake(
    "your test rejects everything",
    "A right version must pass. Right versions differ from each other in their last digits. Which "
    "of your comparisons do their answers fail, and by how much?",
)

REJECTS_SOME = Mistake(
    "your test rejects right versions",
    "A right version must pass, whatever the form of its answers. The message below says what is "
    "special about one. Which of your comparisons do its answers fail, and by how much?",
)


@dataclass(frozen=True)
class Version:
    """A candidate that a student's test judges.

    Parameters
    ----------
    kind : str
        What is special about it, to follow "one": "that is wrong only near pi", "that returns
        lists".
    function : callable
        Called with arrays; it may raise ValueError.
    right : bool
    example : bool
        Whether the task shows it as an example: a test that misjudges it earns nothing.
    mistake : Mistake, optional
        What a test overlooks that refuses it, a right version, and accepts another right one of the
        same kind, or refuses no right version but those with this mistake.
    """

    kind: str
    function: Callable
    right: bool = False
    example: bool = False
    mistake: Mistake | None = None


@dataclass(frozen=True, eq=False)
class WriteTest(Exercise):
    """An exercise whose answer is a test of other functions.

    Parameters
    ----------
    versions : tuple of Version
        At least three right and six wrong ones.
    shapes : tuple of tuple of int
        The shape of each argument that a candidate takes, which is an array of real numbers.
    refuses : Mistake
        What a test overlooks that refuses everything.
    given : callable, optional
        The weak test that the student's cell begins with: as long as theirs judges alike, it is not
        attempted.
    """

    cases: None = None
    returns: None = None
    properties: tuple = ()
    hints: tuple[str, ...] = ()
    sets: int = 1
    versions: tuple[Version, ...] = ()
    shapes: tuple[tuple[int, ...], ...] = ()
    refuses: Mistake = ALWAYS_FALSE
    given: Callable | None = None
    _kept: dict[bytes, str] = field(default_factory=dict, init=False, repr=False)

    def questions(self, seed):
        """Return a case for each version, in random order, and the function that answers calls of
        candidates."""
        order = np.random.default_rng(seed).permutation(len(self.versions)).tolist()
        cases = [(_Case(number, self.versions[index]),) for number, index in enumerate(order)]
        return cases, self._consultant(order)

    def verdict(self, cases, answers):
        """Return the Verdict on the student's judgements; an exception counts as refusing, as in
        pytest."""
        judged = []
        for (case,), answer in zip(cases, answers, strict=True):
            error = answer.get("error")
            if error and error["type"] in _ENDS_HERE:
                return replace(no_answer(self, None, error), case=None)
            if error and case.version.right:
                verdict = no_answer(self, None, error)
                reason = RaisedForRightVersion(verdict.reason, case.version.kind)
                return replace(verdict, state=ERROR, reason=reason, case=None)
            if not error and answer["value"] is None:
                reason = Fails("your test returns True or False")
                return Verdict(self, WRONG, reason, FORGOTTEN_RETURN)
            try:
                judged.append((case.version, False if error else boolean(answer["value"])))
            except Unreadable as wrong_kind:
                return Verdict(self, WRONG, wrong_kind.reason, wrong_kind.mistake)
        scored = self._scored(judged)
        as_given = [
            accepted == bool(attempt(self.given, version.function)) for version, accepted in judged
        ]
        if self.given and scored.state == WRONG and all(as_given):
            return Verdict(
                self, NOT_ATTEMPTED, f"{NOT_ATTEMPTED}: it judges as the given test does"
            )
        return scored

    def _scored(self, judged):
        refused = [version for version, accepted in judged if version.right and not accepted]
        missed = [version for version, accepted in judged if not version.right and accepted]
        n_right = sum(version.right for version, _ in judged)
        n_wrong = len(judged) - n_right
        if not refused and not missed:
            return Verdict(
                self,
                RIGHT,
                note=f"{n_right} right versions accepted, {n_wrong} wrong ones rejected",
            )
        # Points begin at 70 % of the wrong versions: a test that looks at one property, or at one
        # input, refuses hardly more. One that always returns the same, or guesses, earns nothing.
        share = max(1 - len(missed) / n_wrong / 0.3, 0)
        rejected, let_pass = ([version.kind for version in some] for some in (refused, missed))
        reason = Misjudges(rejected, let_pass, n_right, n_wrong)
        always = ALWAYS_TRUE if len(missed) == n_wrong and not refused else None
        if refused and not missed:
            always = self.refuses if len(refused) == n_right else REJECTS_SOME
        accepted = [version.kind for version, accepted in judged if version.right and accepted]
        overlooked = [version.mistake for version in refused]
        always = next(
            (
                version.mistake
                for version in refused
                if version.mistake
                and (version.kind in accepted or set(overlooked) == {version.mistake})
            ),
            always,
        )
        failed_example = any(version.example for version in (*refused, *missed))
        # The tasks give points only to a test that accepts every right version.
        nothing = refused or failed_example
        credit = 0 if nothing else min(int(share * self.points + 1e-9), self.points - 1)
        return Verdict(self, WRONG, reason, always, credit=credit)

    def _consultant(self, order):
        """Return a function that answers a call of a candidate; a student controls its argument.

        order: the index of the version that each candidate is.
        """

        def consult(text, only=None):
            """Answer one call, in JSON; only: the number of the candidate that answers, whatever
            the call says."""
            try:
                if len(text) > _MAX_CHARACTERS:
                    raise ValueError("the arguments are too large")
                asked = json.loads(text)
                number = asked["candidate"] if only is None else only
                if not isinstance(number, int) or not 0 <= number < len(order):
                    raise ValueError("there is no such function")
                return self._answer_of(order[number], asked["arguments"])
            except (
                ValueError,
                LookupError,
                TypeError,
                AttributeError,
                ArithmeticError,
                RecursionError,
            ) as problem:
                return json.dumps({"error": str(problem)[:200]})

        return consult

    def _answer_of(self, index, nodes):
        """Return as JSON text what the version with this index answers.

        A version answers the same arguments always alike. Grading asks a test two to eight times
        about each version, and most tests call a version with the same arguments each time. So the
        answers are kept, because computing one takes ten times as long as finding it.
        """
        key = hashlib.blake2b(json.dumps([index, nodes]).encode(), digest_size=16).digest()
        answer = self._kept.get(key)
        if answer is not None:
            return answer
        arguments = self._arguments([from_json(node) for node in nodes])
        with np.errstate(all="ignore"):
            answer = json.dumps({"value": to_json(self.versions[index].function(*arguments))})
        if len(answer) <= _MAX_KEPT_CHARACTERS and len(self._kept) < _MAX_KEPT:
            self._kept[key] = answer
        return answer

    def _arguments(self, given):
        if len(given) != len(self.shapes):
            raise ValueError(f"the function takes {len(self.shapes)} arguments; {len(given)} came")
        arrays = [np.asarray(value) for value in given]
        for array, shape in zip(arrays, self.shapes, strict=True):
            if (
                array.dtype.kind not in "biuf"
                or array.shape != shape
                or not np.isfinite(array).all()
            ):
                wanted = (
                    f"an array of finite numbers of shape {shape}" if shape else "one finite number"
                )
                raise ValueError(
                    f"the function takes {wanted}; an argument of shape {array.shape} came"
                )
        return [array.astype(float) for array in arrays]


@dataclass(frozen=True)
class _Case(Candidate):
    """A candidate: the student's process gets its number, but not its version."""

    version: Version
