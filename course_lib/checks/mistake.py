"""Known mistakes, each once: a function as a student would write it, whose docstring names it and makes them think."""

import functools
import inspect


class Mistake:
    """A known mistake, called by its name.

    Parameters
    ----------
    name : str
        A clause that can follow "It looks as if": "R^T is returned".
    hint : str
        What to think about.
    *answers : callable
        Each answer(*arguments) is what somebody making this mistake returns; None, or an exception,
        for arguments to which the mistake does not apply. Several answers are variants of one
        mistake.
    seen : callable, optional
        seen(value, *arguments): whether an answer shows the mistake, if no function predicts it.
    part : index, optional
        The answers are this part of the whole answer, whatever its other parts are.
    alike : callable, optional
        alike(value, predicted, *arguments): whether a value is what was predicted; otherwise that
        of the exercise.
    """

    def __init__(self, name, hint, *answers, seen=None, part=None, alike=None):
        self.name, self.hint, self.answers = name, hint, answers
        self.seen, self.part, self.alike = seen, part, alike

    def __repr__(self):
        return f"Mistake({self.name!r})"


class Mistakes(list):
    """The mistakes of one exercise, in the order in which they are tried; its methods are decorators that add one.

    The first sentence of a function's docstring is the mistake's name, the rest is the hint.
    """

    def add(self, function=None, *, seen=None, part=None, alike=None, **variants):
        """Add the mistake of a function that answers as a student does who makes it; see Mistake.

        A keyword of another name lists the variants of a mistake: `terms=(2, 3)` calls the function
        with terms=2 and with terms=3. With `seen`, which recognises the mistake, the function need
        not predict the very answers: it is the wrong answer on which the check is tested.
        """
        if function is None:
            return functools.partial(self.add, seen=seen, part=part, alike=alike, **variants)
        answers = [function]
        for keyword, values in variants.items():
            answers = [
                functools.partial(each, **{keyword: value}) for each in answers for value in values
            ]
        self.append(Mistake(*words(function), *answers, seen=seen, part=part, alike=alike))
        return function

    def add_seen(self, function):
        """Add the mistake that function(value, *arguments) recognises in an answer, if no function predicts it."""
        self.append(Mistake(*words(function), seen=function))
        return function


def words(function):
    """Return the name and the hint that the docstring of a mistake gives."""
    name, stop, hint = " ".join((inspect.getdoc(function) or "").split()).partition(". ")
    if not stop:
        raise ValueError(
            f"{function.__name__}: the docstring gives the mistake's name, a full stop, and a hint"
        )
    return name, hint
