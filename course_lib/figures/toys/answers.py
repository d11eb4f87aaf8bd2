"""The student's own function in a figure: it is called in the kernel for what the reader drags."""

import inspect


class Answers:
    """The student's function as a script sees it: a callable that takes a question and returns an answer.

    The attribute ``whose`` of f, if it has one, says whose it is. ``ask(f, question)`` calls a function for a question
    and returns its answer, a dict of JSON; it raises ValueError if what f returned cannot be drawn.
    """

    def __init__(self, f, ask):
        self.f, self.ask = f, ask
        whose = str(getattr(f, "whose", "your function"))
        self.whose = {"yours": "your function", "the library's": "the library's function"}.get(whose, whose)

    def __call__(self, question):
        answer = {"whose": self.whose, "problem": None, "value": None, "gap": None}
        try:
            return answer | self.ask(self.f, question)
        except (Exception, KeyboardInterrupt) as error:  # of the student's code
            said = " ".join(str(error).split())
            answer["problem"] = f"{self.whose[0].upper()}{self.whose[1:]}: {type(error).__name__}: {said}."[:300]
        return answer


def positional(function):
    """Return how many positional arguments a function takes; 1 where it does not say."""
    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):
        return 1
    return sum(p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD) and p.default is p.empty for p in parameters)
