"""What a message says of the cause of a wrong answer: a known mistake, or a question.

A mistake is claimed ("It looks as if ..."), so it must predict the wrong answers, or be read off
them with certainty. Where no mistake does that, a message asks a question and claims nothing.
"""

import functools
import itertools


class Question:
    """What a message asks where no mistake explains the answer.

    Parameters
    ----------
    name : str
        What fails, in a few words, for authors and tests. No message shows it.
    hint : str
        A question that is fair to every answer which fails here: it presupposes no cause, and
        leaves out no part of the task that may be the wrong one.
    of_the_formula : bool
        Whether it asks about lines that every answer takes. It is not asked then where only a few
        answers are wrong.

    Examples
    --------
    >>> Question("the answer is not 2 x", "Which factor has each x in your line?")
    Question('the answer is not 2 x')
    """

    def __init__(self, name, hint, of_the_formula=False):
        self.name, self.hint, self.of_the_formula = name, hint, of_the_formula

    def __repr__(self):
        return f"Question({self.name!r})"


class Mistake:
    """A known mistake, called by its name.

    What recognises it is one or several of the keywords; without any, it is said where the engine,
    or a version of a test, has read it off the answers.

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
    raises : tuple of str, optional
        The type of the error in which the student's code ends, and a part of its message.
    form : tuple of int or callable, optional
        The shape of an answer that has not the shape asked for; or form(array, *arguments): whether
        such an array shows the mistake, or the Mistake that it shows, where one look tells several
        apart.
    nan : callable, optional
        nan(*arguments): whether nan or inf in the answer to this case shows the mistake.
    """

    def __init__(
        self,
        name,
        hint,
        *answers,
        seen=None,
        part=None,
        alike=None,
        raises=None,
        form=None,
        nan=None,
    ):
        self.name, self.hint, self.answers = name, hint, answers
        self.seen, self.part, self.alike = seen, part, alike
        self.raises, self.form, self.nan = raises, form, nan

    def __repr__(self):
        return f"Mistake({self.name!r})"

    def is_raised(self, kind, message):
        """Return whether an error of this type, with this message, shows the mistake."""
        if self.raises is None:
            return False
        wanted_kind, words = self.raises
        return kind == wanted_kind and words in message

    def of_form(self, array, arguments):
        """Return the Mistake that an array shows whose shape is not the one asked for; or
        None."""
        shown = self.form(array, *arguments) if callable(self.form) else array.shape == self.form
        if isinstance(shown, Mistake):
            return shown
        return self if shown else None


OTHER_FORM = Mistake(
    "the answer does not have the form asked for", "Print your answer and its np.shape."
)


class Mistakes(list):
    """The mistakes of one exercise, in the order in which they are tried."""

    def add(
        self,
        name=OTHER_FORM,
        hint=None,
        *,
        seen=None,
        part=None,
        alike=None,
        raises=None,
        form=None,
        nan=None,
        recognises=False,
        **variants,
    ):
        """Return a decorator that adds the mistake that a function makes; or add a Mistake.

        Parameters
        ----------
        name, hint : str
            As of a Mistake. The decorated function answers as a student does who makes the mistake.
            Or name is a Mistake, which is added at once, if only `raises`, `form` or `nan`
            recognises it. Without a name, `form` is a function that returns the Mistake which an
            array of another shape shows, or None.
        seen, part, alike, raises, form, nan
            As of a Mistake. With `seen` the function need not predict the very answers: it is the
            wrong answer on which the check is tested.
        recognises : bool
            True if the function is function(value, *arguments), which says whether an answer shows
            the mistake: for mistakes that no function predicts.
        **variants
            A keyword of another name lists the variants of a mistake: `terms=(2, 3)` calls the
            function with terms=2 and with terms=3.

        Returns
        -------
        callable or Mistake
            The decorator, which returns the function as it was; or the Mistake that was passed.

        Raises
        ------
        ValueError
            If the name or the hint is not a text: a decorator without brackets passes a function.
        """
        known = {"seen": seen, "part": part, "alike": alike}
        known |= {"raises": raises, "form": form, "nan": nan}
        if isinstance(name, Mistake):
            self.append(Mistake(name.name, name.hint, *name.answers, **known))
            return name
        for what, text in (("name", name), ("hint", hint)):
            if not (isinstance(text, str) and text):
                raise ValueError(
                    f"mistake: the {what} must be a text, as in @EXERCISE.mistake(name, hint); "
                    f"it is {text!r}"
                )

        def add_mistake_of(function):
            if recognises:
                self.append(Mistake(name, hint, **(known | {"seen": function})))
            else:
                self.append(Mistake(name, hint, *_versions(function, variants), **known))
            return function

        return add_mistake_of


def _versions(function, variants):
    """Return the function with each combination of the variants' values."""
    keywords = list(variants)
    return [
        functools.partial(function, **dict(zip(keywords, values, strict=True)))
        for values in itertools.product(*variants.values())
    ]
