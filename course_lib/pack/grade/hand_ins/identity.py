"""Who a student is: what tells one student from every other of the class.

A name alone tells nobody apart, so no table is kept by it. What an export says of the student (a
number, a login, an address) makes an Identity; identities of one student are joined, and each
student then has a label that no other student has. Where nothing says whether two identities of one
name are one student or two, that is a Doubt, about which the instructor is asked.
"""

import collections
import enum
import itertools
from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass, fields

CERTAIN = ("id", "number", "login", "address")  # each is of one student of the whole course


@dataclass(frozen=True)
class Identity:
    """What is known of the student of a hand-in. A text that is not known is "".

    Attributes
    ----------
    name : str
        The name, which several students may bear.
    id : str
        The learning platform's own number of the student.
    number, login, address : str
        The student's number, login and address, as a roster has them.
    participant : str
        The platform's number of the student within one assignment only, as Moodle writes it.
    section : str
        The folders above the student's, if there are some.
    """

    name: str
    id: str = ""
    number: str = ""
    login: str = ""
    address: str = ""
    participant: str = ""
    section: str = ""

    def known(self) -> dict[str, str]:
        """Return {one of CERTAIN: text} of what is of one student only."""
        values = {field.name: getattr(self, field.name) for field in fields(self)}
        return {name: values[name] for name in CERTAIN if values[name]}

    def in_full(self) -> str:
        """Return the name with what tells the student from others of this name, if there is such a
        thing."""
        marks = (self.participant, self.number, self.login, self.address, self.id)
        mark = next(filter(None, marks), "")
        if mark and mark not in self.name:
            return f"{self.name} {mark}"
        return f"{self.name} ({self.section})" if self.section and not mark else self.name


NOBODY = Identity("")


class Relation(enum.Enum):
    """What two identities say of their students."""

    SAME = enum.auto()
    DIFFERENT = enum.auto()
    UNKNOWN = enum.auto()


@dataclass(frozen=True)
class Doubt:
    """Two identities of one name, of which nothing says whether they are one student or two."""

    one: Identity
    other: Identity


@dataclass(frozen=True)
class Students:
    """The students of a class.

    Attributes
    ----------
    labels : Mapping
        {Identity: the student's label}. Two students never have the same label.
    doubts : sequence of Doubt
        One for each name about which the instructor has to be asked.
    """

    labels: Mapping[Identity, str]
    doubts: Sequence[Doubt] = ()


def relation(one: Identity, other: Identity, handed_in: Mapping[Identity, set[str]]) -> Relation:
    """Return what two identities say of their students.

    Parameters
    ----------
    one, other : Identity
    handed_in : Mapping
        {Identity: names of the notebooks that were handed in with it}. Two numbers within one
        assignment, or folders of two sections, that have the same notebook are two students.

    Examples
    --------
    >>> ana = Identity("Ana Lee", number="00123")
    >>> relation(ana, Identity("Annie Lee", number="00123"), {})
    <Relation.SAME: 1>
    >>> relation(ana, Identity("Ana Lee", number="00124"), {})
    <Relation.DIFFERENT: 2>
    >>> relation(ana, Identity("Ana Lee"), {})
    <Relation.UNKNOWN: 3>
    """
    known, known_too = one.known(), other.known()
    equal = {known[field] == known_too[field] for field in known.keys() & known_too.keys()}
    same_name = one.name == other.name
    if equal == {True}:
        return Relation.SAME
    if not same_name or equal == {False}:
        return Relation.DIFFERENT
    if equal or known or known_too:
        return Relation.UNKNOWN
    if one.participant and one.participant == other.participant:
        return Relation.SAME
    if bool(one.participant) != bool(other.participant):
        return Relation.UNKNOWN
    if not one.participant and one.section == other.section:
        return Relation.SAME  # a folder's name is the instructor's word for the student
    same_notebook = handed_in.get(one, set()) & handed_in.get(other, set())
    return Relation.DIFFERENT if same_notebook else Relation.UNKNOWN


def tell_apart(
    handed_in: Mapping[Identity, set[str]],
    line_of: Callable[[Identity], Hashable | None] = lambda identity: None,
    unknown: Relation = Relation.UNKNOWN,
) -> Students:
    """Return the Students to whom the identities belong.

    Parameters
    ----------
    handed_in : Mapping
        {Identity: names of the notebooks that were handed in with it}.
    line_of : callable
        Returns what stands for an identity's line in the roster, or None if no line is certain.
    unknown : Relation
        What the instructor said of those about whom nothing is known.
    """
    lines = {identity: line_of(identity) for identity in handed_in}

    def settled(one: Identity, other: Identity) -> Relation:
        said = relation(one, other, handed_in)
        if said is not Relation.UNKNOWN:
            return said
        if lines[one] is None or lines[other] is None:
            return unknown
        return Relation.SAME if lines[one] == lines[other] else Relation.DIFFERENT

    joined = _Groups(handed_in)
    for several in _alike(handed_in, lines):
        for one, other in itertools.combinations(several, 2):
            if settled(one, other) is Relation.SAME:
                joined.join(one, other)
    doubts: dict[str, Doubt] = {}
    for several in _of_one_name(handed_in, lines):
        for one, other in itertools.combinations(several, 2):
            if settled(one, other) is Relation.UNKNOWN:
                doubts.setdefault(one.name, Doubt(one, other))
    return Students(_labels(joined.groups()), tuple(doubts.values()))


def _alike(
    identities: Iterable[Identity], lines: Mapping[Identity, Hashable | None]
) -> list[list[Identity]]:
    """Return lists of identities, in one of which any two of the same student are."""
    alike = collections.defaultdict(list)
    for identity in identities:
        alike["name", identity.name, identity.participant, identity.section].append(identity)
        if identity.participant:
            alike["participant", identity.name, identity.participant].append(identity)
        if lines[identity] is not None:
            alike["line", identity.name, lines[identity]].append(identity)
        for item in identity.known().items():
            alike[item].append(identity)
    return [several for several in alike.values() if len(several) > 1]


def _of_one_name(
    handed_in: Mapping[Identity, set[str]], lines: Mapping[Identity, Hashable | None]
) -> list[list[Identity]]:
    """Return lists of identities of one name, with two at most of those to which the same applies.

    A whole class may have one name: an anonymous one.
    """
    names: dict[str, dict[Hashable, list[Identity]]] = {}
    for identity, notebooks in handed_in.items():
        about = (frozenset(identity.known().items()), bool(identity.participant), identity.section)
        kinds = names.setdefault(identity.name, {})
        kind = kinds.setdefault((about, frozenset(notebooks), lines[identity]), [])
        if len(kind) < 2:
            kind.append(identity)
    return [list(itertools.chain.from_iterable(kinds.values())) for kinds in names.values()]


class _Groups:
    """Sets of identities, of which any two can be joined."""

    def __init__(self, identities: Iterable[Identity]) -> None:
        self._group = {identity: [identity] for identity in identities}

    def join(self, one: Identity, other: Identity) -> None:
        """Make one group of those of two identities."""
        first, second = self._group[one], self._group[other]
        if first is second:
            return
        first += second
        for identity in second:
            self._group[identity] = first

    def groups(self) -> list[list[Identity]]:
        """Return the groups, each once."""
        return list({id(group): group for group in self._group.values()}.values())


def _labels(groups: Sequence[Sequence[Identity]]) -> dict[Identity, str]:
    """Return {Identity: label}, the same for all of a group and different for two groups.

    A label is the name if one student alone has it.
    """
    names = collections.Counter(group[0].name for group in groups)
    labels: dict[Identity, str] = {}
    taken: set[str] = set()
    for group in sorted(groups, key=lambda group: (names[group[0].name] > 1, group[0].name)):
        first = group[0]
        label = first.name if names[first.name] == 1 else first.in_full()
        for number in itertools.count(2):
            if label not in taken:
                break
            label = f"{first.in_full()} ({number})"
        taken.add(label)
        labels |= dict.fromkeys(group, label)
    return labels
