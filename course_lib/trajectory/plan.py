"""Where times, joint angles and velocities stand in a table."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Plan:
    """Where things stand in a table.

    Attributes
    ----------
    time : tuple of Column
        One column of times, or one of seconds and one of nanoseconds, or none.
    q, qd : tuple of Column
        One for each joint, from the base; qd is empty without velocities.
    remark : str
        What else is to be said, for example that there is no header.
    unused : tuple of Column
        Columns of numbers that are not used.
    """

    time: tuple
    q: tuple
    qd: tuple
    remark: str = ""
    unused: tuple = ()
