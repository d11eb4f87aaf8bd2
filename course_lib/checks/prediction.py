"""Predictions: a question about what the next cell will show, answered before that cell runs.

No points.
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class Prediction:
    """A question with two to four choices, each with an answer of its own.

    The notebook contains the question and the choices; only this object contains which one is
    right.

    Parameters
    ----------
    name : str
        As in check.<name>.predict("b").
    right : str
        The letter of the right choice.
    replies : dict of str to str
        The reply to each letter; for a wrong choice, what it overlooks.
    more : bool
        Whether the question stands in More, not in the core.

    Examples
    --------
    >>> replies = {"a": "Mass cancels.", "b": "Yes: without air both fall alike."}
    >>> fall = Prediction("fall", "b", replies)
    >>> fall.replies["a"]
    'Mass cancels.'
    """

    name: str
    right: str
    replies: dict[str, str]
    more: bool = False

    def __post_init__(self):
        if self.right not in self.replies or not 2 <= len(self.replies) <= 4:
            raise ValueError(
                f"{self.name}: two to four choices, the right one among them; {list(self.replies)} "
                "came"
            )
