"""A file that was handed in, with its result and the marks of its written answers."""

from dataclasses import dataclass

from course_lib.pack.grade.hand_ins.collect import Submission
from course_lib.pack.grade.hand_ins.notebook_file import UNREADABLE


@dataclass(frozen=True)
class GradedFile:
    """A submission with its result, as `submission.grade` returns it, and its MarkedAnswers.

    superseded_by: the place of the file that counts instead of it, or "". late: by how many
    seconds, None if only the platform says so. share: of its points that a late file keeps. weight:
    of the points of More.
    """

    submission: Submission
    result: dict
    answers: tuple = ()
    superseded_by: str = ""
    late: float | None = 0.0
    share: float = 1.0
    weight: float = 1.0

    @property
    def student(self) -> str:
        """The student's name, or ""."""
        return self.submission.student

    @property
    def notebook(self) -> str:
        """The name of the notebook, found in the file or else in its name."""
        return self.result["notebook"] or self.submission.notebook

    @property
    def graded(self) -> bool:
        """False if the file was refused or could not be graded."""
        return "state" not in self.result

    @property
    def unreadable(self) -> bool:
        """True if nothing in the file could be read.

        It then earns nothing, and the student should be informed.
        """
        return any(exercise["state"] == UNREADABLE for exercise in self.result["exercises"])

    @property
    def points(self) -> float:
        """The points of the exercises, before a deduction for lateness and without written
        answers."""
        return sum(
            exercise["points"] * (self.weight if exercise["more"] else 1)
            for exercise in self.result["exercises"]
        )

    def part(self, more: bool) -> tuple[float, float]:
        """Return the points of exercises and written answers in the core or in More, and the points
        there are.

        Neither is weighted, and nothing is deducted for lateness.
        """
        exercises = [entry for entry in self.result["exercises"] if entry["more"] == more]
        answers = [entry for entry in self.answers if entry.more == more]
        points = sum(entry["points"] for entry in exercises) + sum(
            entry.points or 0 for entry in answers
        )
        return points, sum(entry["of"] for entry in exercises) + sum(entry.of for entry in answers)

    @property
    def of_more(self) -> float:
        """The points of More, weighted and after a deduction for lateness."""
        return self.part(True)[0] * self.weight * self.share

    @property
    def total(self) -> float:
        """The points of exercises and written answers, weighted and after a deduction for
        lateness."""
        return self.part(False)[0] * self.share + self.of_more

    @property
    def unread(self) -> int:
        """The number of written answers that have no mark yet."""
        return sum(answer.points is None for answer in self.answers)

    @property
    def of(self) -> float:
        """The points that the notebook offers, weighted, written answers included."""
        return self.part(False)[1] + self.part(True)[1] * self.weight
