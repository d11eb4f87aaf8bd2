"""What the title of a column says: a quantity, a joint and a unit.

A title is split into words, at punctuation, between letters and digits, and where a capital begins
a word. A small grammar reads them:

- a unit stands in brackets, or is the last word if it is one of the quantity: the s of `time_s` is
  seconds, and the s of `joint_s` is not;
- a word for what is no joint angle (torque, temperature, tcp ...) decides over all others;
- then a word for a velocity decides, then one for an angle;
- the number after such a word is the joint's; without a number, the other words are its name.

Whatever the grammar does not know it calls "unknown": nothing is guessed here.
"""

import re
import unicodedata
from dataclasses import dataclass
from itertools import pairwise

import numpy as np


def _words(text):
    return set(text.split())


# Each unit: the quantity that it measures, its name, and its size in seconds, radians or radians
# per second.
_SPELLINGS = {
    ("time", "s", 1.0): "s|sec|secs|second|seconds|sekunde|sekunden",
    ("time", "ms", 1e-3): "ms|msec|msecs|millis|millisecond|milliseconds|milli sec",
    ("time", "us", 1e-6): "us|usec|usecs|micros|microsec|microsecond|microseconds|micro sec",
    ("time", "ns", 1e-9): "ns|nsec|nsecs|nanos|nanosec|nanosecs|nanosecond|nanoseconds|nano sec",
    ("angle", "rad", 1.0): "rad|rads|radian|radians",
    ("angle", "mrad", 1e-3): "mrad",
    ("angle", "deg", np.pi / 180): "deg|degs|degree|degrees",
    ("rate", "rad/s", 1.0): "rad s|rad sec|rad per s|rad per sec|rad s 1|radians per second",
    (
        "rate",
        "deg/s",
        np.pi / 180,
    ): "deg s|deg sec|deg per s|deg per sec|deg s 1|degrees per second",
    ("rate", "rpm", np.pi / 30): "rpm",
    ("length", "m", None): "m|meter|meters|metre|metres",
    ("length", "mm", None): "mm|millimeter|millimeters",
    ("length", "cm", None): "cm",
    ("torque", "Nm", None): "nm|n m",
    ("force", "N", None): "n|newton",
    ("current", "A", None): "a|ampere|ma",
    ("voltage", "V", None): "v|volt|volts",
    ("temperature", "C", None): "c|k|celsius",
    ("acceleration", "rad/s^2", None): "rad s 2|deg s 2|rad s s|m s 2",
}
UNITS = {name: (kind, size) for kind, name, size in _SPELLINGS if kind in ("time", "angle", "rate")}
_UNIT_OF_WORDS = {
    tuple(spelling.split()): (kind, name)
    for (kind, name, _), spellings in _SPELLINGS.items()
    for spelling in spellings.split("|")
}
_UNITS_OF = {"time": ("time",), "position": ("angle",), "velocity": ("rate", "angle")}

# Words for what is no joint angle. The first of these that a title holds is its quantity.
_NO_ANGLES = {
    "sine or cosine": "sin cos",
    "gripper": "gripper finger fingers jaw grip",
    "acceleration": (
        "acc accel accels acceleration accelerations qdd ddq qddot ddot jerk beschl "
        "beschleunigung imu"
    ),
    "torque": "eff effort efforts torque torques tau dtau trq moment moments drehmoment load mt",
    "force": "force forces wrench ft fx fy fz mx my mz kraft",
    "temperature": "temp temperature temperatures temperatur",
    "voltage or power": "voltage volt power energy pwm",
    "setting": (
        "stiffness damping friction gain gains kp kd ki limit limits min max std var lower upper"
    ),
    "error": "error errors err fehler deviation residual",
    "count": "count counts pulse pulses tick ticks raw encoder encoders pressure",
    "pose": (
        "x y z w rx ry rz tcp eef ee eff pose poses cartesian quat quaternion orientation qx qy qz"
        " qw tx ty tz vx vy vz wx wy wz flange xyz rpy twist linear angular effector kartesisch"
    ),
    "status": (
        "mode status flag flags valid success done reward safety collision contact brake "
        "running enabled rate"
    ),
    "row number": "index idx seq sequence frame row sample episode iteration counter id",
}
_NO_ANGLE_OF = {word: kind for kind, words in _NO_ANGLES.items() for word in words.split()}
_CURRENT = {"current", "currents", "amps", "strom"}
_ROTATIONS = {"roll", "pitch", "yaw"}  # of a pose, but also in the names of joints
_TIME = _words("time times zeit stamp timestamp timestamps stamps temps tiempo tempo elapsed")
_BESIDE_TIME = _words(
    "from start since boot begin header ros rosbag bag field in unix epoch log record recorded "
    "system sim simulation sensor msg message robot controller states joint state zeit duration "
    "data rel relative abs absolute"
)
_DATES = {"datetime", "date", "datum", "uhrzeit"}
_VELOCITY = _words(
    "qd dq qdot vel vels velocity velocities speed speeds dot geschw geschwindigkeit "
    "geschwindigkeiten dtheta thetadot omega gelenkgeschwindigkeit vitesse velocidad velocita"
)
_ANGLE = _words(
    "q pos position positions angle angles winkel gelenkwinkel achswinkel angulo angolo posicion "
    "posizione theta θ φ phi"
)
_JOINT = _words(
    "joint joints jnt jt axis axes axe achse achsen ax rax gelenk gelenke giunto articulacion"
)
_BEFORE_A_NUMBER = {"a": "joint", "j": "joint", "th": "angle", "v": "velocity"}
_MEASURED = _words("meas measured msr actual act ist real fb feedback observation obs observed")
_COMMANDED = _words(
    "target targets desired des cmd cmds command commands commanded ref reference setpoint"
    " setpoints goal soll action actions ipo planned"
)
_PLAIN = _MEASURED | _words("current state states field data msg value values list in of the")
_MOTOMAN = set("slurbte")  # letters of Yaskawa Motoman's axes, which stand behind a joint's number
_LABEL = {"joint", "axis", "motor", "name", "names", "achse", "joints"}
_LABEL_COMPANIONS = _LABEL | {"id", "no", "nr", "number", "index", "field"}


@dataclass(frozen=True)
class Column:
    """What the title of a column says.

    Attributes
    ----------
    place : int
        Which column it is, from 0.
    title : str
        As in the header, or the column's number, from 1.
    quantity : str
        "time", "position" or "velocity" of a joint, "label" (which joint a row is of), one of the
        kinds in this module that are no joint angle, "unclear", or "unknown".
    number : int or None
        The joint's number, as it stands in the title.
    words : tuple of str
        The words of the title without its unit.
    unit : str or None
        A name in UNITS; "?" with what stands in its place, if that is no unit of the quantity.
    commanded : bool
        Whether the title says that these are targets.
    stem : tuple of str
        The words without the number: columns of one set share it.
    """

    place: int
    title: str
    quantity: str
    number: int | None = None
    words: tuple = ()
    unit: str | None = None
    commanded: bool = False
    stem: tuple = ()


def words_of(title):
    """Return the words of a title, in lower case.

    Examples
    --------
    >>> words_of("axisQMsr_LBR_iiwa_7[0]")
    ['axis', 'q', 'msr', 'lbr', 'iiwa', '7', '0']
    """
    text = unicodedata.normalize("NFKD", title)
    text = re.sub("([qθφ])\u0307", r"\1dot", text)  # a dot above the letter
    text = re.sub("([qθφ])\u0308", r"\1ddot", text)
    text = "".join(letter for letter in text if not unicodedata.combining(letter))
    text = text.replace("°", " deg ").replace("μ", "u")
    parts = re.findall(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+|[^\W\d_]+", text)
    return [part.lower() for part in parts]


def understand(place, title):
    """Return the Column that a title describes.

    Examples
    --------
    >>> column = understand(0, "panda_joint3_vel [deg/s]")
    >>> column.quantity, column.number, column.unit
    ('velocity', 3, 'deg/s')
    >>> understand(0, "tau_J_1").quantity
    'torque'
    """
    bare, bracket = _without_bracket(title)
    words = words_of(bare)
    quantity, number, commanded, stem = _read_words(words)
    unit = None
    if bracket is not None:
        kind, unit = _UNIT_OF_WORDS.get(tuple(words_of(bracket)), ("", f"?{bracket}"))
        quantity, unit = _with_unit(quantity, kind, unit, words)
    else:
        for size in (4, 3, 2, 1):
            if len(words) < size:
                continue
            kind, suffix = _UNIT_OF_WORDS.get(tuple(words[-size:]), ("", None))
            rest = words[:-size]
            if suffix is None:
                continue
            if rest:
                read = _read_words(rest)
            else:  # the unit alone, such as "sec"; a letter alone says nothing
                read = (
                    kind if len(suffix) > 1 or len(words[0]) > 1 else "unknown",
                    None,
                    False,
                    (),
                )
            if kind in _UNITS_OF.get(read[0], ()):
                quantity, number, commanded, stem = read
                words, unit = rest, suffix
                break
            if kind in ("angle", "rate") and read[0] in ("unknown", "pose"):
                quantity, number, commanded, stem = read
                words, unit = rest, suffix  # the user, or an arm's known names, may say what it is
                break
            if kind == "rate" and read[0] == "position" and not _ANGLE & set(rest):
                quantity, (_, number, commanded, stem) = "velocity", read
                words, unit = rest, suffix
                break
    return Column(place, title, quantity, number, tuple(words), unit, commanded, stem)


def only_quantity(column):
    """Return whether a title names nothing: all its words say what is measured, such as
    "position"."""
    return set(column.words) <= _ANGLE | _VELOCITY | _JOINT | _PLAIN | _COMMANDED


def quantity_beside(words):
    """Return the quantity and whether it is commanded that the words beside a joint's name say.

    No word says position: the title is then the name of the joint alone.
    """
    quantity, _, commanded, _ = _read_words([*words, "q"])
    return quantity, commanded


def _without_bracket(title):
    """Return a title without the unit in brackets at its end, and the unit, or None."""
    parted = re.fullmatch(r"\s*(.*?)[\s_]*[\[(<{]([^\[\](){}<>]*)[\])>}]\s*", title)
    if parted and parted[1] and not re.fullmatch(r"\s*\d*\s*", parted[2]):
        return parted[1], parted[2].strip()
    return title, None


def _with_unit(quantity, kind, unit, words):
    """Return the quantity and its unit in brackets; the unit decides where the words leave it
    open."""
    if kind in _UNITS_OF.get(quantity, ()):
        return quantity, unit
    if kind == "rate" and quantity == "position" and not _ANGLE & set(words):
        return "velocity", unit
    if quantity in ("time", "position", "velocity"):
        return quantity, unit if unit.startswith("?") else f"?{unit}"
    if quantity == "unknown" and kind in ("torque", "force", "current", "voltage", "temperature"):
        return kind, None
    return quantity, unit if kind in ("time", "angle", "rate") else None


def _read_words(words):
    """Return quantity, number, commanded and stem of the words of a title without its unit."""
    present = set(words)
    commanded = bool(_COMMANDED & present)
    if not words:
        return "unknown", None, False, ()
    if words == ["t"] or _is_time(words):
        return "time", None, False, tuple(words)
    if present & _LABEL and present <= _LABEL_COMPANIONS:
        return "label", None, False, tuple(words)
    if "name" in present or "names" in present:
        return "name", _last_number(words), False, _without_number(words, len(words) - 1)
    spoken = [word for word in words if word in _NO_ANGLE_OF]
    if spoken:
        return _NO_ANGLE_OF[spoken[0]], None, commanded, tuple(words)
    if present & _CURRENT and not present & _ANGLE:  # "current position" is the one measured now
        return "current", None, commanded, tuple(words)
    if present & _ROTATIONS and not present & _JOINT:
        return "pose", None, commanded, tuple(words)
    quantity, strong = _quantity(words, present)
    if quantity == "velocity" and "d" in present:  # dq_d, the desired velocity
        commanded = True
    if quantity == "unknown":
        return quantity, None, commanded, tuple(words)
    at = _number_at(words, strong)
    if at is None:
        return quantity, None, commanded, tuple(words)
    if at < 0 or not _fits_behind_number(words[at + 1 :]):
        return "unknown", None, commanded, tuple(words)
    return quantity, int(words[at]), commanded, _without_number(words, at)


def _is_time(words):
    present = {word for word in words if not word.isdigit()}
    named = present & (_TIME | _DATES) or present == {"duration"}
    ticking = {tuple(words[-size:]) for size in (1, 2)} & set(_UNIT_OF_WORDS)
    seconds = any(_UNIT_OF_WORDS[unit][0] == "time" for unit in ticking)
    units = {word for unit in ticking for word in unit} if seconds else set()
    return bool(named) and present <= _TIME | _DATES | _BESIDE_TIME | units | {"t", "duration"}


def _quantity(words, present):
    """Return position, velocity, unclear or unknown, and whether a word says so rather than "joint"
    alone."""
    before_number = {
        _BEFORE_A_NUMBER[word]
        for word, after in pairwise(words)
        if word in _BEFORE_A_NUMBER and after.isdigit()
    }
    velocity = present & _VELOCITY or "velocity" in before_number
    angle = present & _ANGLE or "angle" in before_number
    if velocity:
        return "velocity", True
    if "d" in present and angle:
        return "unclear", True  # q_d is the desired angle or the derivative
    if angle:
        return "position", True
    if present & _JOINT or "joint" in before_number:
        return "position", False
    return "unknown", False


def _number_at(words, strong):
    """Return where the joint's number stands, None if there is none, -1 if there are several."""
    speaking = _ANGLE | _VELOCITY | _JOINT | set(_BEFORE_A_NUMBER) | {"d"}
    after = []
    for i in range(1, len(words)):
        if not words[i].isdigit():
            continue
        before = words[:i]
        while before and before[-1] in _PLAIN | _COMMANDED:
            before = before[:-1]
        if before and before[-1] in speaking:
            after.append(i)
    if len(after) > 1:
        return -1
    if after:
        # [0] behind a joint's number, or joint_2 behind q_0: which of the two is the joint's?
        return -1 if words[-1].isdigit() and after[0] != len(words) - 1 else after[0]
    if strong and words[-1].isdigit():
        return len(words) - 1
    return None


def _fits_behind_number(words):
    known = _PLAIN | _COMMANDED | _ANGLE | _VELOCITY | _JOINT | _MOTOMAN | {"d"}
    return set(words) <= known


def _last_number(words):
    return int(words[-1]) if words[-1].isdigit() else None


def _without_number(words, at):
    return (*words[:at], *words[at + 1 :])
