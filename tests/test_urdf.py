"""Arms from URDF files: against the library's own arms and a product of poses; what is no arm is
refused."""

from pathlib import Path

import numpy as np
import pytest
from helpers import close

from course_lib import ik
from course_lib.arms import DHRow, SerialArm, iiwa14, panda, ur5e
from course_lib.figures import alive, jog, reach
from course_lib.figures.solids import Model, shell
from course_lib.rigid import transform
from course_lib.rotations import exp_so3, rot_x, rot_y, rot_z

SHIPPED = Path(__file__).parents[1] / "notebooks/data/ur5e.urdf"
QUARTER = np.pi / 2


def link(*names):
    return "".join(f'<link name="{name}"/>' for name in names)


def joint(name, parent, child, kind="revolute", xyz="0 0 0", rpy="0 0 0", axis="0 0 1", more=None):
    if more is None:
        more = '<limit lower="-1" upper="2"/>' if kind in ("revolute", "prismatic") else ""
    ends = f'<parent link="{parent}"/><child link="{child}"/>'
    place = f'<origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="{axis}"/>'
    return f'<joint name="{name}" type="{kind}">{ends}{place}{more}</joint>'


def robot(*parts):
    return f'<?xml version="1.0"?><robot name="r">{"".join(parts)}</robot>'


@pytest.fixture
def file(tmp_path):
    def write(text, name="own.urdf"):
        (tmp_path / name).write_bytes(text if isinstance(text, bytes) else text.encode())
        return tmp_path / name

    return write


def chain_of(rows, flange, limits):
    """A URDF file of modified DH rows, whose joints rotate about z of their own frames, and a fixed
    flange."""
    parts = [link(*(f"link{i}" for i in range(len(rows) + 1)), "flange")]
    for i, row in enumerate(rows):
        # Craig's transform without the rotation: about and along x, then along the new z.
        offset = rot_x(row.alpha) @ [0, 0, row.d] + [row.a, 0, 0]
        limit = f'<limit lower="{limits[i][0]}" upper="{limits[i][1]}"/>'
        xyz = " ".join(f"{x:.17g}" for x in offset)
        parts.append(
            joint(
                f"joint{i + 1}",
                f"link{i}",
                f"link{i + 1}",
                xyz=xyz,
                rpy=f"{row.alpha} 0 0",
                more=limit,
            )
        )
    parts.append(joint("end", f"link{len(rows)}", "flange", "fixed", xyz=f"0 0 {flange}"))
    return robot(*parts)


PANDA = [
    DHRow(0, 0, 0.333),
    DHRow(0, -QUARTER, 0),
    DHRow(0, QUARTER, 0.316),
    DHRow(0.0825, QUARTER, 0),
    DHRow(-0.0825, -QUARTER, 0.384),
    DHRow(0, QUARTER, 0),
    DHRow(0.088, QUARTER, 0),
]
IIWA = [
    DHRow(0, 0, 0.36),
    DHRow(0, -QUARTER, 0),
    DHRow(0, QUARTER, 0.42),
    DHRow(0, QUARTER, 0),
    DHRow(0, -QUARTER, 0.4),
    DHRow(0, -QUARTER, 0),
    DHRow(0, QUARTER, 0),
]


def same_motion(arm, other):
    q = np.random.default_rng(3).uniform(-3, 3, (500, arm.n))
    close(arm.fk(q), other.fk(q), 1e-14)
    close(arm.space_jacobian(q), other.space_jacobian(q), 1e-14)
    close(arm.limits, other.limits, 1e-15)


def test_the_file_that_comes_with_the_course_is_the_ur5e():
    arm = SerialArm.from_urdf(SHIPPED)
    same_motion(arm, ur5e())
    assert arm.joint_names[:3] == ("shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint")


def test_the_panda_as_urdf_is_the_panda(file):
    arm = SerialArm.from_urdf(file(chain_of(PANDA, 0.107, panda().limits)))
    same_motion(arm, panda())
    close(arm.frames(np.zeros(7)), panda().frames(np.zeros(7)), 1e-15)


def test_the_iiwa_as_urdf_is_the_iiwa(file):
    same_motion(SerialArm.from_urdf(file(chain_of(IIWA, 0.121, iiwa14().limits))), iiwa14())


def test_a_chain_is_the_product_of_its_poses_and_rotations(file):
    rng = np.random.default_rng(5)
    xyz, rpy, axes = rng.normal(size=(3, 6, 3))
    kinds = ["revolute", "fixed", "continuous", "revolute", "fixed", "revolute"]
    names = [f"l{i}" for i in range(7)]
    parts = [link(*names[::-1])]  # the order in the file says nothing
    for i in reversed(range(6)):
        x, r, a = (" ".join(f"{v:.17g}" for v in values[i]) for values in (xyz, rpy, axes))
        parts.append(joint(f"j{i}", names[i], names[i + 1], kinds[i], x, r, a))
    arm = SerialArm.from_urdf(file(robot(*parts)))
    assert arm.joint_names == ("j0", "j2", "j3", "j5")
    close(arm.limits, [[-1, 2], [-np.inf, np.inf], [-1, 2], [-1, 2]], 0)
    for q in rng.uniform(-3, 3, (20, 4)):
        angles, T, frames = iter(q), np.eye(4), []
        for i in range(6):
            roll, pitch, yaw = rpy[i]
            T = T @ transform(rot_z(yaw) @ rot_y(pitch) @ rot_x(roll), xyz[i])
            if kinds[i] != "fixed":
                axis = axes[i] / np.linalg.norm(axes[i])
                T = T @ transform(exp_so3(next(angles) * axis), np.zeros(3))
                frames.append(T)
        close(arm.fk(q), T, 1e-13)
        close(arm.frames(q), [*frames, T], 1e-13)


def test_a_joint_without_an_axis_rotates_about_x(file):
    """A joint without an origin has no offset."""
    bare = '<joint name="a" type="continuous"><parent link="b"/><child link="c"/></joint>'
    arm = SerialArm.from_urdf(file(robot(link("b", "c"), bare)))
    close(arm.screw_axes, [[1, 0, 0, 0, 0, 0]], 0)
    close(arm.home, [np.eye(4)] * 2, 0)


FORK = (
    link("base", "arm", "left", "right", "sensor"),
    joint("a", "base", "arm"),
    joint("l", "arm", "left"),
    joint("r", "arm", "right"),
    joint("s", "base", "sensor", "fixed"),
)


def test_a_tip_chooses_the_chain(file):
    path = file(robot(*FORK))
    assert SerialArm.from_urdf(path, "left").joint_names == ("a", "l")
    assert SerialArm.from_urdf(path, tip="arm").joint_names == ("a",)


def test_an_end_without_a_rotating_joint_is_no_second_arm(file):
    path = file(robot(link("base", "arm", "sensor"), FORK[1], FORK[4]))
    assert SerialArm.from_urdf(path).joint_names == ("a",)


@pytest.mark.parametrize(("kind", "joints"), [("fixed", 1), ("continuous", 2), ("revolute", 2)])
def test_limits_of_0_and_0_are_asked_about_with_three_ways_out(file, kind, joints):
    zero, limits = '<limit lower="0" upper="0"/>', '<limit lower="-3.1" upper="3.1"/>'
    links, first = link("base", "arm", "hand"), joint("a", "base", "arm", more=zero)
    second = joint("b", "arm", "hand", more=limits)
    with pytest.raises(ValueError, match="limits are both 0") as asked:
        SerialArm.from_urdf(file(robot(links, first, second)))
    for line in ('type="fixed"', 'type="continuous"', limits):
        assert line in str(asked.value)
    answered = first.replace('type="revolute"', f'type="{kind}"').replace(zero, limits)
    assert SerialArm.from_urdf(file(robot(links, answered, second))).n == joints


def test_joints_beside_the_chain_may_be_of_any_type(file):
    beside = [
        joint("slide", "arm", "left", "prismatic"),
        joint("repeat", "arm", "right", more='<mimic joint="a"/><limit lower="0" upper="1"/>'),
        joint("bare", "arm", "sensor", more=""),
    ]
    path = file(robot(*FORK[:2], *beside))
    assert SerialArm.from_urdf(path, "arm").n == 1


def test_elements_of_other_programs_are_passed_over(file):
    extra = (
        '<transmission name="t"><joint name="a"/></transmission><drake:joint name="z"/><gazebo/>'
    )
    path = file(b"\n\n" + robot(link("base", "arm"), FORK[1], extra).encode())
    assert SerialArm.from_urdf(path).joint_names == ("a",)


NAMES = {
    "utf8": "gelenk_ü",
    "cp1252": "gelenk_ü",
    "Shift_JIS": "関節",
    "GBK": "关节",
    "utf-16": "關節",
}


@pytest.mark.parametrize("encoding", NAMES)
def test_a_file_is_read_in_the_encoding_that_it_declares(file, encoding):
    text = robot(link("base", "arm"), joint(NAMES[encoding], "base", "arm"))
    text = text.replace("?>", f' encoding="{encoding}"?>', 1)
    assert SerialArm.from_urdf(file(text.encode(encoding))).joint_names == (NAMES[encoding],)


@pytest.mark.parametrize("comment", ["<!-- ----- arm ----- -->", "<!-- made from a--1.xacro -->"])
def test_a_comment_may_hold_two_dashes_as_for_ros(file, comment):
    shown = "<gazebo><![CDATA[ <!-- ]]></gazebo>"
    path = file(robot(link("base", "arm"), comment, shown, FORK[1], comment))
    assert SerialArm.from_urdf(path).joint_names == ("a",)


BASE = link("base", "arm")
REFUSED = {
    "two ends": (robot(*FORK), None, r"ends in 2 links: 'left' \(2\), 'right' \(2\), .* tip='left'"),
    "a tip that is not there": (robot(*FORK), "hand", "tip is 'hand', and own.urdf has the links 'base'"),
    "a tip that is no text": (robot(*FORK), 3, "tip must be the name of a link; it is 3"),
    "a tip at the base": (robot(*FORK), "base", "no joint rotates between the root link and the root link"),
    "a joint that slides": (
        robot(BASE, link("hand"), FORK[1], joint("s", "arm", "hand", "prismatic")), None,
        "joint 's' is prismatic, it slides along its axis, .* tip='arm'",
    ),
    "a joint that floats": (robot(BASE, joint("f", "base", "arm", "floating")), None, "'f' is floating"),
    "a joint that slides in a plane": (robot(BASE, joint("p", "base", "arm", "planar")), None, "'p' is planar"),
    "a joint that repeats another": (
        robot(BASE, link("hand"), FORK[1], joint("m", "arm", "hand", more='<mimic joint="a"/>')), None,
        "joint 'm' repeats .* joint 'a'",
    ),
    "no joints": (robot(link("base")), None, "holds no joints: it has one link, 'base'"),
    "no joints, no links": (robot(), None, "holds no joints: it has no links"),
    "only fixed joints": (robot(BASE, joint("a", "base", "arm", "fixed")), None, "no joint rotates"),
    "xacro": (
        robot('<xacro:macro name="arm"/>', BASE, FORK[1]), None, "is a xacro file, .* xacro robot.urdf.xacro",
    ),
    "xacro's values": (robot(BASE, joint("a", "base", "arm", xyz="0 0 ${d1}")), None, "is a xacro file"),
    "SDF": ('<sdf version="1.9"><model name="m"/></sdf>', None, "it is an SDF file"),
    "MJCF": ("<mujoco><worldbody/></mujoco>", None, "it is an MJCF file"),
    "another XML": ("<svg/>", None, "it is XML of another kind, <svg>"),
    "cut off": (robot(BASE, FORK[1])[:-30], None, "is no whole XML file: .*line 1"),
    "no XML": ("solid cube", None, "is no whole XML file"),
    "nothing": ("", None, "own.urdf is empty"),
    "an encoding that is not there": ('<?xml version="1.0" encoding="klingon"?><robot/>', None, "own.urdf"),
    "another encoding than it says": (
        '<?xml version="1.0" encoding="utf-16"?><robot></robot>', None, "its encoding is not utf-16",
    ),
    "a byte that its encoding does not have": (
        '<?xml version="1.0" encoding="utf-8"?><robot name="\xfc"/>'.encode("cp1252"), None, "cannot be read as XML",
    ),
    "a cycle": (robot(BASE, FORK[1], joint("b", "arm", "base")), None, "the links are a cycle"),
    "a cycle beside the root": (
        robot(link("base", "arm", "x", "y"), FORK[1], joint("b", "x", "y"), joint("c", "y", "x")), "x",
        "leads back to itself",
    ),
    "a parent that is not there": (robot(BASE, joint("a", "bas", "arm")), None, "the parent of joint 'a' is 'bas'"),
    "a child that is not there": (robot(BASE, joint("a", "base", "arn")), None, "the child of joint 'a' is 'arn'"),
    "two parents": (robot(BASE, FORK[1], joint("b", "base", "arm")), None, "'a' and 'b' both lead to link 'arm'"),
    "two roots": (robot(BASE, link("other"), FORK[1]), None, "2 links have no parent, 'base', 'other'"),
    "two joints of one name": (robot(BASE, FORK[1], FORK[1]), None, "two joints have the name 'a'"),
    "two links of one name": (robot(BASE, BASE, FORK[1]), None, "two links have the name 'base'"),
    "a joint without name": (robot(BASE, joint("", "base", "arm")), None, "joint number 1 has no name"),
    "a joint without type": (robot(BASE, joint("a", "base", "arm", "hinge")), None, "must have a type, one of"),
    "a joint without parent": (robot(BASE, '<joint name="a" type="fixed"/>'), None, "must have a parent"),
    "no limits": (robot(BASE, joint("a", "base", "arm", more="")), None, "must have limits .* continuous"),
    "limits without order": (
        robot(BASE, joint("a", "base", "arm", more='<limit lower="2" upper="-2"/>')), None, "its lower limit, 2",
    ),
    "limits that are no numbers": (
        robot(BASE, joint("a", "base", "arm", more='<limit lower="low" upper="1"/>')), None,
        "limit lower must be a finite number; it is 'low'",
    ),
    "an axis of zero": (robot(BASE, joint("a", "base", "arm", axis="0 0 0")), None, "its axis is zero"),
    "two numbers for a place": (
        robot(BASE, joint("a", "base", "arm", xyz="0 1")), None, "origin xyz must be three finite numbers",
    ),
    "a place of nan": (robot(BASE, joint("a", "base", "arm", rpy="0 nan 0")), None, "origin rpy must be three"),
}  # fmt: skip


@pytest.mark.parametrize("fault", REFUSED)
def test_what_is_no_arm_is_refused_with_what_is_there(file, fault):
    text, tip, words = REFUSED[fault]
    with pytest.raises(ValueError, match=words):
        SerialArm.from_urdf(file(text), tip)


def test_a_document_type_declaration_is_refused(file):
    """It is refused before its entities grow."""
    lines = ['<?xml version="1.0"?><!DOCTYPE robot [<!ENTITY a0 "ha">']
    lines += [f'<!ENTITY a{i + 1} "{10 * f"&a{i};"}">' for i in range(12)]
    bomb = "".join(lines) + ']><robot name="&a12;"/>'
    outside = (
        '<!DOCTYPE robot [<!ENTITY x SYSTEM "file:///etc/passwd">]><robot name="r">&x;</robot>'
    )
    for text in (bomb, outside, "<!DOCTYPE robot><robot/>"):
        with pytest.raises(ValueError, match="has a document type declaration"):
            SerialArm.from_urdf(file(text))


@pytest.mark.parametrize("path", [None, 3, b"own.urdf", "a\0b"])
def test_a_path_that_is_none_is_refused_by_name(path):
    with pytest.raises(ValueError, match=r"^path must"):
        SerialArm.from_urdf(path)


def test_a_file_that_is_not_there_is_an_os_error(tmp_path):
    for missing in (tmp_path / "none.urdf", tmp_path):
        with pytest.raises(OSError, match=r"none|directory|denied|" + tmp_path.name):
            SerialArm.from_urdf(missing)


def test_any_cut_of_a_file_is_refused_in_a_sentence(file):
    whole = SHIPPED.read_text()
    for end in range(0, len(whole.rstrip()), 97):
        with pytest.raises(ValueError, match=r"^own\.urdf"):
            SerialArm.from_urdf(file(whole[:end]))


# What takes an arm
# -------------------------------------------------------------------------------------------------


def bent_elbow(file):
    """An arm that no other module knows: three axes of general direction, one of them without
    limits."""
    return SerialArm.from_urdf(
        file(
            robot(
                link("base", "a", "b", "c", "hand"),
                joint("one", "base", "a", xyz="0 0 0.3"),
                joint("two", "a", "b", "continuous", xyz="0.1 0 0.2", rpy="0.3 1 0", axis="0 1 1"),
                joint("three", "b", "c", xyz="0 0.2 0.3", axis="1 0 0"),
                joint("end", "c", "hand", "fixed", xyz="0 0 0.1"),
            )
        )
    )


def test_inverse_kinematics_takes_the_arm(file):
    for arm in (bent_elbow(file), SerialArm.from_urdf(SHIPPED)):
        targets = arm.fk(np.random.default_rng(1).uniform(-0.9, 0.9, (20, arm.n)))
        found = ik.solve(arm, targets, np.random.default_rng(2))
        assert found.success.all()
        close(arm.fk(found.q), targets, 1e-5)


def test_the_toys_take_the_arm(file):
    for arm in (bent_elbow(file), SerialArm.from_urdf(SHIPPED)):
        q = np.full(arm.n, 0.4)
        assert f"An arm with {arm.n} joints" in jog(arm, q=q).alt
        assert f"An arm with {arm.n} joints" in alive(reach(arm, arm.fk(q), q=q)).alt


def test_a_known_arm_from_a_file_is_drawn_in_its_own_shape():
    shapes = [Model.of(shell(arm)).vertices for arm in (ur5e(), SerialArm.from_urdf(SHIPPED))]
    close(*shapes, 1e-12)
