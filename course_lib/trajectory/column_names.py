"""What the title of a column says: a time, or the angle or velocity of a joint, and a unit.

A title is known if all its words are: those in this module for a time, an angle or a velocity, and
a joint's number or name. One word that is not among them, such as the torque of `joint_1_torque` or
the d of `q_d`, and the column is not used. What no title says, the user is asked for.
"""

import re
import unicodedata
from dataclasses import dataclass, replace

import numpy as np

UNITS = {
    "t": {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9},
    "q": {"rad": 1.0, "mrad": 1e-3, "deg": np.pi / 180},
    "qd": {"rad/s": 1.0, "deg/s": np.pi / 180, "rpm": np.pi / 30},
}
# Velocities without a unit have that of the angles, per second.
UNITS["qd"] |= UNITS["q"]
_SPELLINGS = {
    "s": "sec secs second seconds sekunde sekunden",
    "ms": "msec msecs millisec milliseconds",
    "us": "µs usec usecs microsec microseconds",
    "ns": "nsec nsecs nanosec nanosecs nanoseconds",
    "rad": "radian radians",
    "deg": "° degree degrees",
    "rad/s": "rad/sec rad*s^-1",
    "deg/s": "°/s deg/sec degrees/s",
}
_UNIT_OF = {unit: unit for units in UNITS.values() for unit in units} | {
    spelling: unit for unit, spellings in _SPELLINGS.items() for spelling in spellings.split()
}
_WORDS = {
    "t": "t time zeit timestamp timestamps stamp",
    "q": "q position positions pos angle angles winkel theta",
    "qd": "qd dq qdot velocity velocities vel speed geschw geschwindigkeit",
    "joint": "joint joints j axis achse axispos",
    "name": "name names",
    # Words that change nothing: of ROS' messages, of what was measured, of arms, and the letter of
    # KUKA's joints, a1 to a7.
    "": (
        "field header msg data state states actual measured act msr panda fr3 fer lbr iiwa a from "
        "start"
    ),
}
KIND_OF = {word: kind for kind, words in _WORDS.items() for word in words.split()}
# The number of q[0] is not a unit.
_UNIT_IN_BRACKETS = re.compile(
    r"(.*\S)[\s_]*[\[(<]\s*([^\[\]()<>]*[^\[\]()<>\d\s][^\[\]()<>]*)[\])>]"
)


@dataclass(frozen=True)
class Column:
    """What the title of a column says.

    Attributes
    ----------
    place : int
        Which column it is, from 0.
    title : str
        As messages show it.
    words : tuple of str
        The words of the title without its unit.
    kind : str
        "t", "q" or "qd"; "name" if it holds names of joints; "" if not known.
    pattern : tuple of str
        The words, with * for the joint's number: those of one set share it.
    number : int or None
        The joint's number.
    unit : str or None
        A unit of its kind; "?" and what stands in its place, if that is another text.
    """

    place: int
    title: str
    words: tuple = ()
    kind: str = ""
    pattern: tuple = ()
    number: int | None = None
    unit: str | None = None


def understand(place, title):
    """Return the Column that a title describes.

    Examples
    --------
    >>> column = understand(0, "panda_joint3_vel [deg/s]")
    >>> column.kind, column.number, column.unit
    ('qd', 3, 'deg/s')
    >>> understand(0, "tau_J_1").kind
    ''
    """
    title = title.strip()
    if bracket := _UNIT_IN_BRACKETS.fullmatch(title):
        column = column_of_words(place, title, words_of(bracket[1]))
        return _with_unit_in_brackets(column, bracket[2].strip())
    column = column_of_words(place, title, words_of(title))
    # A unit behind the title, such as time_ms; but the s of joint_s is not one.
    before, _, last = re.sub(r"[\s.]", "_", title.lower()).rpartition("_")
    unit = _UNIT_OF.get(last)
    if column.kind or unit is None:
        return column
    shorter = column_of_words(place, title, words_of(before))
    if unit in UNITS["t"] and not shorter.words and len(last) > 1:
        shorter = replace(shorter, kind="t")  # sec, nanosec
    return replace(shorter, unit=unit) if unit in UNITS.get(shorter.kind, ()) else column


def _with_unit_in_brackets(column, text):
    """Return a column with the unit that its title has in brackets."""
    unit = _UNIT_OF.get(text.lower().replace("μ", "µ"))
    is_rate = unit in UNITS["qd"] and unit not in UNITS["q"]
    says_angle = any(KIND_OF.get(word) == "q" for word in column.words)
    if is_rate and column.kind == "q" and not says_angle:
        column = replace(column, kind="qd")  # joint_1 [deg/s]: the unit decides
    known = unit is not None and unit in UNITS.get(column.kind, (unit,))
    return replace(column, unit=unit if known else f"?{text}")


def words_of(title):
    """Return the words of a title, in lower case: at punctuation, digits, and where a capital
    begins a word."""
    text = unicodedata.normalize("NFKD", title)
    text = re.sub("q\u0307", "qd", text)  # a dot above the letter
    parts = re.findall(r"fr3|[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+|[^\W\d_]+", text)
    return tuple(part.lower() for part in parts)


def column_of_words(place, title, words):
    """Return the Column of these words: its kind is known if all its words are."""
    digits = [i for i, word in enumerate(words) if word.isdigit()]
    number, pattern = None, words
    if digits:
        number = int(words[digits[-1]])
        pattern = (*words[: digits[-1]], "*", *words[digits[-1] + 1 :])
    return Column(place, title, words, kind_of(pattern), pattern, number)


def kind_of(pattern, has_name=False):
    """Return the kind of a title by its words; has_name: whether * is for the name of a joint."""
    kinds = {KIND_OF.get(word) for word in pattern if word != "*"}
    if None in kinds:
        return ""
    if "name" in kinds:
        return "name"
    if "t" in kinds:
        return "t" if kinds <= {"t", ""} and "*" not in pattern else ""
    if "*" not in pattern:
        return ""
    if "qd" in kinds:
        return "qd"
    # A position without a joint may be one in space; q and theta are angles, and `positions` is
    # what ROS calls those of all joints.
    alone = kinds <= {"q", ""} and set(pattern) & {"pos", "position"}
    if has_name or "joint" in kinds or ("q" in kinds and not alone):
        return "q"
    return ""
