"""What is reported: what became of each answer, prediction and cell, in sentences."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

CARRIED, PRESENT, NOT_CARRIED = "carried over", "here already", "not carried over"
ANSWER, PREDICTION = "answer", "prediction"
OWN_CELL, GIVEN_CELL = "cell of your own", "given cell that you had changed"
PLURALS = {
    ANSWER: "answers",
    PREDICTION: "predictions",
    GIVEN_CELL: "given cells that you had changed",
    OWN_CELL: "cells of your own",
}


@dataclass(frozen=True)
class Result:
    """What became of one answer, prediction, or cell.

    kind: ANSWER, PREDICTION, OWN_CELL or GIVEN_CELL. name: the exercise's, or the number and the
    first line of a cell. state: CARRIED, PRESENT or NOT_CARRIED. remark: for a state that needs
    one, the reason, as a clause that begins with "because", or a sentence. number: of the older
    cell.
    """

    kind: str
    name: str
    state: str
    remark: str = ""
    number: int = 0


@dataclass
class Report:
    """What became of one notebook.

    name: of the new notebook. older: the file that was read, as a person will find it. problem: why
    nothing could be done, in sentences, or "". remarks: further sentences.
    """

    name: str
    older: str
    results: list[Result] = field(default_factory=list)
    remarks: list[str] = field(default_factory=list)
    problem: str = ""

    def lines(self) -> Iterator[str]:
        """Yield the report as sentences: a summary, then one for each thing that needs
        attention."""
        if self.problem:
            yield f"{self.name}: {self.problem}"
            return
        yield f"{self.name}: {self._summary()}"
        for sentence in [*self._not_carried(), *self._remarks()]:
            yield f"    {sentence}"

    def __str__(self) -> str:
        return "\n".join(self.lines())

    def _summary(self) -> str:
        summary = f"{self._counted(CARRIED) or 'nothing was'} carried over"
        present = self._counted(PRESENT)
        return f"{summary}, and {present} here already." if present else f"{summary}."

    def _not_carried(self) -> Iterator[str]:
        """Yield a sentence for each kind of thing and reason, with the places in the older file."""
        left = [result for result in self.results if result.state == NOT_CARRIED]
        for kind, reason in dict.fromkeys((result.kind, result.remark) for result in left):
            alike = [r for r in left if (r.kind, r.remark) == (kind, reason)]
            names = ", ".join(result.name for result in alike)
            numbers = ", ".join(str(result.number) for result in alike)
            if len(alike) == 1:
                yield (
                    f"The {kind} {names} was not carried over, {reason}. It is cell {numbers} of "
                    f"{self.older}."
                )
            else:
                yield (
                    f"The {PLURALS[kind]} {names} were not carried over, {reason}. They are the "
                    f"cells {numbers} of {self.older}."
                )

    def _remarks(self) -> Iterator[str]:
        for result in self.results:
            if result.state == CARRIED and result.remark:
                yield result.remark
        yield from self.remarks

    def _counted(self, state: str) -> str:
        """Return how many of each kind are in this state, in words with their verb; "" if none."""
        kinds = [result.kind for result in self.results if result.state == state]
        counts = []
        for kind, plural in PLURALS.items():
            if kind in kinds:
                count = kinds.count(kind)
                counts.append(f"{count} {kind if count == 1 else plural}")
        verb = "was" if len(kinds) == 1 else "were"
        return f"{', '.join(counts)} {verb}" if counts else ""


@dataclass
class Update:
    """What became of a whole folder: a report for each notebook, and sentences on the other
    files."""

    reports: list[Report] = field(default_factory=list)
    sentences: list[str] = field(default_factory=list)
    failed_files: list[str] = field(default_factory=list)

    def lines(self) -> Iterator[str]:
        """Yield everything as sentences."""
        for report in self.reports:
            yield from report.lines()
        yield from self.sentences

    def failed(self) -> list[str]:
        """Return the names of the notebooks and files that a second run should try again."""
        return [report.name for report in self.reports if report.problem] + self.failed_files
