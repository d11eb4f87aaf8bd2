"""The chain of joints in a URDF file, the format in which ROS describes robots.

A URDF file holds links and joints. A joint places the frame of its child link in that of its parent
link, by an origin (xyz in metres, rpy in radians about fixed axes), and moves it about or along an
axis. The joints make a tree; the chain from its root to one link, the tip, is an arm.

The standard library's XML parser reads it: shapes, masses and meshes, for which there are larger
packages, are of no use here. A document type declaration is refused, because entities declared in
one can grow without bound.

Source: the URDF specification, wiki.ros.org/urdf/XML/joint.
"""

import math
import re
from dataclasses import dataclass, replace
from xml.etree.ElementTree import TreeBuilder
from xml.parsers import expat

import numpy as np

from course_lib.arguments import file_path
from course_lib.rigid import transform
from course_lib.rotations import rot_x, rot_y, rot_z

ROTATING = ("revolute", "continuous")
_KNOWN = (*ROTATING, "fixed", "prismatic", "floating", "planar")
_OTHER_MOTIONS = {
    "prismatic": "slides along its axis",
    "floating": "lets the link move freely",
    "planar": "lets the link slide in a plane",
}
_MAX_NAMES = 12  # of links in a message
# expat refuses "--" inside a comment, as in a line of dashes, but ROS reads it, and a comment holds
# nothing of the robot. A CDATA section may hold what only looks like a comment.
_COMMENT = re.compile(rb"(<!\[CDATA\[.*?\]\]>)|<!--.*?-->", re.DOTALL)
_ENCODING = re.compile(rb"""(?:\xef\xbb\xbf)?<\?xml[^>]*?\sencoding\s*=\s*["']([\w.-]+)["']""")
_OTHER_FORMATS = {
    "sdf": "an SDF file, the format of Gazebo",
    "mujoco": "an MJCF file, the format of MuJoCo",
    "COLLADA": "a COLLADA file, which holds a shape",
    "html": "a web page",
}


@dataclass(frozen=True, eq=False)  # two joints are equal only if they are the same one
class URDFJoint:
    """A joint of a URDF file.

    Attributes
    ----------
    name, kind, parent, child : str
        Its name and type, and the names of its two links.
    mimics : str
        The name of the joint whose angle it repeats, or "".
    origin : array (4, 4)
        The pose of the child link's frame in the parent link's at joint angle zero; metres.
    axis : array (3,)
        The unit vector of its axis, in the child link's frame.
    limits : array (2,)
        Lowest and highest angle in radians; infinite for a continuous joint.
    """

    name: str
    kind: str
    parent: str
    child: str
    mimics: str = ""
    origin: np.ndarray | None = None
    axis: np.ndarray | None = None
    limits: np.ndarray | None = None


def chain(path, tip=None):
    """Return the joints from the root link of a URDF file to a tip.

    Parameters
    ----------
    path : str or pathlib.Path
    tip : str, optional
        The name of the last link. It may be left out if an arm leads to only one
        link that has no joint after it.

    Returns
    -------
    list of URDFJoint
        Revolute, continuous and fixed joints, in order.

    Raises
    ------
    ValueError
        If the file is no URDF file, its joints are no tree, the tip is not clear or not there, or a
        joint on the way to the tip slides, or repeats another one. The message says what is there,
        and what to write.
    OSError
        If there is no such file.
    """
    path = file_path(path, "path")
    if tip is not None and not isinstance(tip, str):
        raise ValueError(f"tip must be the name of a link; it is {tip!r:.60}")
    robot = _robot(path)
    links = _names(path, robot.findall("link"), "link")
    elements = robot.findall("joint")
    joints = [
        _with_links(path, name, element)
        for name, element in zip(_names(path, elements, "joint"), elements, strict=True)
    ]
    if not joints:
        raise ValueError(f"{path.name} holds no joints: it has {_listed(links, 'link')}")
    joint_to = _joint_to_each_link(path, links, joints)
    tip = _tip(path, links, joints, joint_to) if tip is None else tip
    if tip not in links:
        raise ValueError(f"tip is {tip!r}, and {path.name} has {_listed(links, 'link')}")
    way = []
    while tip in joint_to:
        joint = joint_to[tip]
        if joint in way:
            raise ValueError(
                f"{path.name}: joint {joint.name!r} leads back to itself: the links must be a tree"
            )
        way.append(joint)
        tip = joint.parent
    way.reverse()
    _refuse_other_motions(path, way)
    # Faults of joints that are not on the way to the tip matter to nobody.
    return [_with_geometry(path, joint, elements[joints.index(joint)]) for joint in way]


def _refuse_other_motions(path, way):
    """Refuse a chain that is no arm of rotating joints, each of which has an angle of its own."""
    for joint in way:
        if joint.kind not in (*ROTATING, "fixed"):
            raise ValueError(
                f"{path.name}: joint {joint.name!r} is {joint.kind}, it "
                f"{_OTHER_MOTIONS[joint.kind]}, and the joints of a SerialArm rotate. "
                f"{_arm_before(joint)}"
            )
        if joint.mimics and joint.kind in ROTATING:
            raise ValueError(
                f"{path.name}: joint {joint.name!r} repeats (mimics) the angle of joint "
                f"{joint.mimics!r}, and each joint of a SerialArm has an angle of its own. "
                f"{_arm_before(joint)}"
            )
    if not any(joint.kind in ROTATING for joint in way):
        where = repr(way[-1].child) if way else "the root link"
        raise ValueError(f"{path.name}: no joint rotates between the root link and {where}")


def _arm_before(joint):
    return f"The arm before that joint ends at link {joint.parent!r}: tip={joint.parent!r}"


# The tree
# -------------------------------------------------------------------------------------------------


def _joint_to_each_link(path, links, joints):
    """Return {link: the joint that leads to it}, or refuse joints that make no tree."""
    joint_to = {}
    for joint in joints:
        for role, link in (("parent", joint.parent), ("child", joint.child)):
            if link not in links:
                raise ValueError(
                    f"{path.name}: the {role} of joint {joint.name!r} is {link!r}, and the file "
                    f"has {_listed(links, 'link')}"
                )
        if joint.child in joint_to:
            other = joint_to[joint.child].name
            raise ValueError(
                f"{path.name}: joints {other!r} and {joint.name!r} both lead to link "
                f"{joint.child!r}: a link has one parent"
            )
        joint_to[joint.child] = joint
    roots = [link for link in links if link not in joint_to]
    if not roots:
        raise ValueError(
            f"{path.name}: the links are a cycle, in which each has a parent: one, the base, must "
            "have none"
        )
    if len(roots) > 1:
        raise ValueError(
            f"{path.name}: {len(roots)} links have no parent, {_quoted(roots)}: only the base may "
            "have none, so joints are missing"
        )
    return joint_to


def _tip(path, links, joints, joint_to):
    """Return the only link without a joint after it that an arm leads to, or ask which."""
    parents = {joint.parent for joint in joints}
    counts = {link: _rotating_before(link, joint_to) for link in links if link not in parents}
    arms = [leaf for leaf, count in counts.items() if count]
    if len(arms) == 1 or len(counts) == 1:
        return (arms or list(counts))[0]
    # The longest arm first: most often it is the one that is meant.
    leaves = sorted(arms or counts, key=lambda leaf: -counts[leaf])
    listed = [f"{leaf!r} ({counts[leaf]})" for leaf in leaves[:_MAX_NAMES]]
    more = ", ..." if len(leaves) > _MAX_NAMES else ""
    raise ValueError(
        f"{path.name} ends in {len(leaves)} links: {', '.join(listed)}{more}, with the number of "
        f"rotating joints before each. Write which one is the end-effector, for example "
        f"tip={leaves[0]!r}; any other link may be it, too"
    )


def _rotating_before(link, joint_to):
    count, seen = 0, set()
    while link in joint_to and link not in seen:
        seen.add(link)
        count += joint_to[link].kind in ROTATING
        link = joint_to[link].parent
    return count


# XML
# -------------------------------------------------------------------------------------------------


class _DoctypeError(Exception):
    """A file has a document type declaration."""


def _refuse_doctype(*declaration):
    raise _DoctypeError


def _parsed(data):
    """Return the root element of XML, or raise expat.ExpatError.

    Its prefixes need no declaration. Programs add elements of their own, such as drake:joint, and
    often leave the prefix undeclared; ElementTree's own parser would refuse the whole file.
    """
    data = _COMMENT.sub(lambda part: part[1] or re.sub(rb"[^\n]", b" ", part[0]), data)
    encoding = _ENCODING.match(data)
    if encoding:  # expat knows few names of encodings, and neither GBK nor utf8
        data = _in_utf8(data, encoding[1].decode())
    builder, parser = TreeBuilder(), expat.ParserCreate("utf-8" if encoding else None)
    parser.StartElementHandler = builder.start
    parser.EndElementHandler = builder.end
    parser.CharacterDataHandler = builder.data
    parser.StartDoctypeDeclHandler = _refuse_doctype  # is called before any entity is declared
    parser.Parse(data, True)
    return builder.close()


def _in_utf8(data, encoding):
    text = data.decode(encoding)
    if not text.removeprefix("\ufeff").startswith("<?xml"):
        raise LookupError(f"its encoding is not {encoding}")
    return text.encode()


def _robot(path):
    """Return the element <robot> of a file, or say what the file is instead."""
    data = path.read_bytes()
    if not data.strip():
        raise ValueError(f"{path.name} is empty")
    try:
        robot = _parsed(data.lstrip())  # programs read files that begin with an empty line
    except _DoctypeError:
        raise ValueError(
            f"{path.name} has a document type declaration (<!DOCTYPE ...>), which no URDF file "
            "needs and which can read other files or fill the memory: delete it"
        ) from None
    except expat.ExpatError as broken:
        raise ValueError(f"{path.name} is no whole XML file: {broken}") from broken
    except (ValueError, LookupError) as unreadable:  # an encoding that does not exist
        raise ValueError(f"{path.name} cannot be read as XML: {unreadable}") from unreadable
    for element in robot.iter():
        if element.tag.startswith("xacro:") or any(
            "${" in text for text in element.attrib.values()
        ):
            raise ValueError(
                f"{path.name} is a xacro file, a template of a URDF file. Write the URDF file with "
                "ROS, xacro robot.urdf.xacro > robot.urdf, and load that one"
            )
    if robot.tag != "robot":
        what = _OTHER_FORMATS.get(robot.tag, f"XML of another kind, <{robot.tag:.40}>")
        raise ValueError(
            f"{path.name} must be a URDF file, whose first element is <robot>; it is {what}"
        )
    return robot


def _names(path, elements, kind):
    names = [element.get("name", "").strip() for element in elements]
    for number, name in enumerate(names):
        if not name:
            raise ValueError(f"{path.name}: {kind} number {number + 1} has no name")
        if name in names[:number]:
            raise ValueError(f"{path.name}: two {kind}s have the name {name!r}")
    return names


def _with_links(path, name, element):
    """Return a joint with its type and its links, which the tree needs."""
    where = f"{path.name}: joint {name!r}"
    kind = element.get("type", "").strip()
    if kind not in _KNOWN:
        raise ValueError(
            f"{where} must have a type, one of {', '.join(_KNOWN)}; it is {kind!r:.40}"
        )
    links = []
    for role in ("parent", "child"):
        end = element.find(role)
        if end is None or not end.get("link", "").strip():
            raise ValueError(f'{where} must have a {role}, such as <{role} link="base"/>')
        links.append(end.get("link").strip())
    mimic = element.find("mimic")
    return URDFJoint(name, kind, *links, "" if mimic is None else mimic.get("joint", "?"))


def _with_geometry(path, joint, element):
    """Return a joint with its origin, axis and limits."""
    where = f"{path.name}: joint {joint.name!r}"
    origin = element.find("origin")
    xyz = _numbers(where, origin, "origin", "xyz", [0.0, 0, 0])
    roll, pitch, yaw = _numbers(where, origin, "origin", "rpy", [0.0, 0, 0])
    pose = transform(rot_z(yaw) @ rot_y(pitch) @ rot_x(roll), xyz)
    if joint.kind not in ROTATING:
        return replace(joint, origin=pose)
    axis = _numbers(where, element.find("axis"), "axis", "xyz", [1.0, 0, 0])
    size = np.linalg.norm(axis)
    if size == 0:
        raise ValueError(f"{where}: its axis is zero: an axis needs a direction")
    limits = np.array([-np.inf, np.inf])
    if joint.kind == "revolute":
        limits = _limits(where, element.find("limit"))
    return replace(joint, origin=pose, axis=axis / size, limits=limits)


def _limits(where, limit):
    if limit is None or limit.get("lower") is None or limit.get("upper") is None:
        raise ValueError(
            f"{where} is revolute and must have limits in radians, such as "
            '<limit lower="-3.1" upper="3.1"/>; a joint without limits has the type continuous'
        )
    low, high = (_numbers(where, limit, "limit", side, None, 1)[0] for side in ("lower", "upper"))
    if low == high == 0:  # SolidWorks' exporter writes this where nobody entered limits
        raise ValueError(
            f"{where}: its lower and upper limits are both 0, as some programs write for a joint "
            'without limits. If the joint is locked, write type="fixed"; if it turns without end, '
            'type="continuous"; else write its limits in radians, such as '
            '<limit lower="-3.1" upper="3.1"/>'
        )
    if low >= high:
        raise ValueError(
            f"{where}: its lower limit, {low:g}, must be below its upper one, {high:g}"
        )
    return np.array([low, high])


def _numbers(where, element, tag, attribute, default, count=3):
    """Return the numbers in an attribute, or the default if it is not there."""
    if element is None or element.get(attribute) is None:
        return np.array(default)
    text = element.get(attribute)
    try:
        numbers = [float(word) for word in text.split()]
    except ValueError:
        numbers = []
    if len(numbers) != count or not all(math.isfinite(number) for number in numbers):
        what = "three finite numbers" if count == 3 else "a finite number"
        raise ValueError(f"{where}: {tag} {attribute} must be {what}; it is {text!r:.60}")
    return np.array(numbers)


def _listed(names, kind):
    if not names:
        return f"no {kind}s"
    if len(names) == 1:
        return f"one {kind}, {names[0]!r}"
    return f"the {kind}s {_quoted(names)}"


def _quoted(names):
    shown = [repr(name) for name in names[:_MAX_NAMES]]
    return ", ".join(shown + ["..."] * (len(names) > _MAX_NAMES))
