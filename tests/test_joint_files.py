"""Joint files as programs write them: what is read is by name and unit, and the rest is asked
about.

Each form is written as its program writes it; its comment names the source.
"""

import re

import numpy as np
import pytest

from course_lib.arms import iiwa14, panda, ur5e
from course_lib.trajectory import JointCountError, UnclearFileError, disagreement, load

N = 5  # rows
T = 0.02 * np.arange(N)
SEVEN = 0.1 * np.arange(1, 8) + 0.013 * np.arange(N)[:, None]
SIX = SEVEN[:, :6]
SPEED = np.full((N, 7), 0.65)  # of these angles, in rad/s
UR_NAMES = (
    "elbow_joint shoulder_lift_joint shoulder_pan_joint wrist_1_joint wrist_2_joint wrist_3_joint"
)
UR_NAMES = UR_NAMES.split()
UR_ORDER = [2, 1, 0, 3, 4, 5]  # of the alphabetical columns: pan, lift, elbow, wrists
STAMP = 1_690_000_000  # seconds since 1970
HALF_TURN = np.tile([-np.pi, np.pi], (7, 1))


def numbered(form, k, first=0):
    return [form.format(i) for i in range(first, first + k)]


def lines(header, *blocks, by=",", comma=False):
    """Lines of a table: a header, and rows of the blocks, each (n, k), (n,), a text, or a list of
    texts."""
    rows = []
    for i in range(N):
        row = []
        for block in blocks:
            if isinstance(block, str):
                row.append(block)
            elif isinstance(block, list):
                row += block
            else:
                row += [f"{x:.16g}" for x in np.atleast_1d(np.asarray(block)[i])]
        if comma:
            row = [cell.replace(".", ",") for cell in row]
        rows.append(by.join(row))
    return "\n".join([*([by.join(header)] if header else []), *rows]) + "\n"


@pytest.fixture
def file(tmp_path):
    def write(text, name="own.csv", encoding="utf-8"):
        (tmp_path / name).write_bytes(text.encode(encoding))
        return tmp_path / name

    return write


def stamps():
    return [str(STAMP * 10**9 + 20_000_000 * i) for i in range(N)]


def with_stamps(text):
    """Put nanoseconds since 1970 in the place of the word STAMP of each row."""
    header, *rows = text.splitlines()
    rows = [row.replace("STAMP", stamp) for row, stamp in zip(rows, stamps(), strict=True)]
    return "\n".join([header, *rows]) + "\n"


def rostopic():
    # rostopic echo -p of sensor_msgs/JointState (ros_comm, rostopic, _str_plot_fields).
    header = ["%time", "field.header.seq", "field.header.stamp", "field.header.frame_id"]
    header += numbered("field.name{}", 6) + numbered("field.position{}", 6)
    header += numbered("field.velocity{}", 6) + numbered("field.effort{}", 6)
    rows = lines(header, "STAMP", "7", "STAMP", "", UR_NAMES, SIX, SPEED[:, :6], 0 * SIX)
    return with_stamps(rows)


def ros2_csv(velocities=True):
    # ros2 topic echo --csv (ros2cli, ros2topic, message_to_csv): no header, fields in their order.
    nano = 20_000_000 * np.arange(N)
    more = (SPEED[:, :6], 0 * SIX) if velocities else ()
    return lines([], str(STAMP), nano, "base", UR_NAMES, SIX, *more)


def rosbag_lists():
    # A row for each message, arrays as lists in quotes (fishros/rosbag_to_csv and others).
    header = "rosbagTimestamp,header,seq,stamp,secs,nsecs,frame_id,name,position,velocity,effort"
    rows = [header]
    for i, stamp in enumerate(stamps()):
        cells = [UR_NAMES, SIX[i].round(6).tolist(), SPEED[i, :6].tolist(), []]
        quoted = ",".join(f'"{cell}"' for cell in cells)
        rows.append(f"{stamp},,{i},,{STAMP},{20_000_000 * i},,{quoted}")
    return "\n".join(rows) + "\n"


def libfranka():
    # libfranka, franka::logToCSV: the state of n + 1 beside the command of n.
    names = [f"state.{name}[{{}}]" for name in ("q", "q_d", "dq", "dq_d", "tau_J")]
    header = ["duration", "success_rate"]
    for name in names:
        header += numbered(name, 7)
    header += numbered("state.O_T_EE[{}]", 16) + numbered("cmd.q_d[{}]", 7)
    pose = np.zeros((N, 16))
    blocks = (SEVEN, SEVEN + 0.001, SPEED, SPEED, 9 * SEVEN, pose, SEVEN + 0.001)
    return lines(header, 20 * np.arange(N), np.ones(N), *blocks)


def sunrise():
    # KUKA Sunrise, DataRecorder with addCurrentJointPosition and external torques.
    header = ["% ZeitInSec", "ZeitInNanoSec"]
    header += numbered("axisQMsr_LBR_iiwa_14_R820_1[{}]", 7)
    header += numbered("axisTauExtMsr_LBR_iiwa_14_R820_1[{}]", 7)
    return lines(header, str(STAMP), 20_000_000 * np.arange(N), SEVEN, 5 * SEVEN, by=" ")


def fri():
    # pyfri, collect_data: mp are measured and ip interpolated positions.
    header = ["index", "time", "record_time_nsec", "tsec", "tnsec"]
    for name in ("mp", "ip", "mt", "et"):
        header += numbered(name + "{}", 7, 1)
    return lines(
        [*header, "dt"], np.arange(N), T, "7", "0", "0", SEVEN, SEVEN, SEVEN, SEVEN, "0.02"
    )


def rtde():
    # Universal Robots' rtde_control_loop recorder (record.py): columns by spaces.
    header = ["timestamp"]
    for name in ("target_q", "target_qd", "actual_q", "actual_qd", "actual_current"):
        header += numbered(name + "_{}", 6)
    header += numbered("actual_TCP_pose_{}", 6)
    speed = SPEED[:, :6]
    return lines(header, T, SIX + 0.001, speed, SIX, speed, SIX, SIX, by=" ")


def plotjuggler():
    # PlotJuggler, CSV export of /joint_states.
    header = ["__time"]
    for kind in ("position", "velocity", "effort"):
        header += [f"/joint_states/{name}/{kind}" for name in UR_NAMES]
    return lines(header, STAMP + T, SIX, SPEED[:, :6], 0 * SIX)


def robomimic():
    # robomimic and robosuite, observations of robot0 flattened to columns.
    header = ["time"]
    for name in ("joint_pos", "joint_pos_cos", "joint_pos_sin", "joint_vel"):
        header += numbered(f"robot0_{name}_{{}}", 7)
    header += numbered("robot0_eef_pos_{}", 3) + numbered("robot0_gripper_qpos_{}", 2)
    more = (np.cos(SEVEN), np.sin(SEVEN), SPEED, SEVEN[:, :3], SEVEN[:, :2])
    return lines(header, T, SEVEN, *more)


def rlbench():
    # RLBench, Observation: joint_positions, joint_velocities, gripper_open, gripper_pose; no times.
    header = numbered("joint_positions_{}", 7) + numbered("joint_velocities_{}", 7)
    header += ["gripper_open", *numbered("gripper_pose_{}", 7)]
    return lines(header, SEVEN, SPEED, "1.0", SEVEN)


def lerobot():
    # LeRobot, SO-101: names of motors as in its dataset's features.
    names = ["shoulder_pan", "shoulder_lift", "elbow_flex", "wrist_flex", "wrist_roll", "gripper"]
    header = ["timestamp", "frame_index", "episode_index", *(f"{name}.pos" for name in names)]
    return lines(header, T, np.arange(N), "0", SIX)


def lerobot_state():
    # LeRobot, a table of the dataset by pandas' to_csv: lists, whose unit no column says.
    rows = ["timestamp,frame_index,observation.state,action"]
    for i in range(N):
        state = " ".join(f"{x:.6f}" for x in SIX[i])
        rows.append(f"{T[i]:.3f},{i},[{state}],[{state}]")
    return "\n".join(rows) + "\n"


def krc_trace():
    # KUKA KRC trace, exported for a spreadsheet: axes in degrees, decimal commas.
    header = ["Time [s]", *numbered("AxisPos_Act A{} [°]", 6, 1)]
    return lines(header, T, np.rad2deg(SIX), by=";", comma=True)


def motoman():
    # Yaskawa Motoman in ROS (motoman_driver): names of the joints with the axis's letter.
    header = [
        "time(ms)",
        "joint_1_s",
        "joint_2_l",
        "joint_3_u",
        "joint_4_r",
        "joint_5_b",
        "joint_6_t",
    ]
    return lines(header, 1000 * T, SIX)


def abb():
    # ABB Externally Guided Motion, joint feedback: axes and one external axis that is not there.
    header = ["Time [s]", *numbered("rax_{} [deg]", 6, 1), "eax_a"]
    return lines(header, T, np.rad2deg(SIX), "9e+09")


def gazebo():
    # Gazebo's joint states by rostopic and bagpy: seconds and nanoseconds.
    header = ["Time", "header.seq", "header.stamp.secs", "header.stamp.nsecs", "header.frame_id"]
    header += numbered("name_{}", 7) + numbered("position_{}", 7) + numbered("velocity_{}", 7)
    names = numbered("lbr_iiwa_joint_{}", 7, 1)
    return lines(
        header, STAMP + T, "1", str(STAMP), 20_000_000 * np.arange(N), "", names, SEVEN, SPEED
    )


def moveit_fingers():
    # A Panda's joint states: the fingers come first by the alphabet.
    names = ["panda_finger_joint1", "panda_finger_joint2", *numbered("panda_joint{}", 7, 1)]
    header = ["%time", *numbered("field.name{}", 9), *numbered("field.position{}", 9)]
    return with_stamps(lines(header, "STAMP", names, ["0.04", "0.04"], SEVEN))


def timetable():
    # MATLAB, writetimetable with a duration: seconds as text.
    header = ["Time", *numbered("q{}", 7, 1)]
    times = [f"{t:g} sec" for t in T]
    rows = lines(header, "TIME", SEVEN).splitlines()
    filled = [row.replace("TIME", time) for row, time in zip(rows[1:], times, strict=True)]
    return "\n".join([rows[0], *filled]) + "\n"


def pandas_index():
    # pandas, DataFrame.to_csv with its row numbers in a column without title.
    return lines(["", "time", *numbered("q{}", 7, 1)], np.arange(N), T, SEVEN)


def kdl():
    # Orocos KDL, JntArray beside the time, as examples print them.
    return lines(["t", *numbered("q[{}]", 7)], T, SEVEN, by="\t")


def long_form():
    # pandas, melt: a row for each joint; the joints by the alphabet of their names.
    rows = ["time_s,joint,position,velocity,effort"]
    for i in range(N):
        for j in range(7):
            rows.append(f"{T[i]:.3f},joint_a{j + 1},{SEVEN[i, j]:.9f},{SPEED[i, j]},0.0")
    return "\n".join(rows) + "\n"


def excel_wide():
    # Excel, "Unicode text": UTF-16, tabs, decimal commas.
    return lines(
        ["Zeit [ms]", *numbered("Achse {} [°]", 7, 1)],
        1000 * T,
        np.rad2deg(SEVEN),
        by="\t",
        comma=True,
    )


def matlab():
    # MATLAB, writematrix: no header.
    return lines([], T, SEVEN, SPEED)


def writetable():
    # MATLAB, writetable: titles are names of variables.
    return lines(
        ["Time", *numbered("Joint_{}", 7, 1), *numbered("JointVel_{}", 7, 1)], T, SEVEN, SPEED
    )


def savetxt():
    # numpy.savetxt with a header, which it writes as a comment.
    return lines(["# t", *numbered("q{}", 7, 1), *numbered("qd{}", 7, 1)], T, SEVEN, SPEED, by=" ")


def moveit_states():
    # MoveIt, robotStateToStream: the names of the model's joints, and no times.
    return lines(numbered("panda_joint{}", 7, 1), SEVEN)


def moveit_points():
    # MoveIt, trajectory_msgs/JointTrajectoryPoint.
    header = ["time_from_start", *numbered("positions[{}]", 7), *numbered("velocities[{}]", 7)]
    return lines(header, T, SEVEN, SPEED)


def two_arms():
    header = ["t", *numbered("left_joint_{}", 7, 1), *numbered("right_joint_{}", 7, 1)]
    return lines(header, T, SEVEN, 2 * SEVEN)


def px4():
    # PX4, pyulog's ulog2csv of vehicle_odometry: a position and a quaternion in space.
    header = ["timestamp", *numbered("position[{}]", 3), *numbered("q[{}]", 4)]
    return lines(header, 1e6 + 2e4 * np.arange(N), SEVEN[:, :3], np.tile([1.0, 0, 0, 0], (N, 1)))


UR_PENDANT = ["base", "shoulder", "elbow", "wrist1", "wrist2", "wrist3"]
LEROBOT = ["shoulder_pan", "shoulder_lift", "elbow_flex", "wrist_flex", "wrist_roll"]
MOTOMAN = ["joint_1_s", "joint_2_l", "joint_3_u", "joint_4_r", "joint_5_b", "joint_6_t"]
SUNRISE = {"t": [1, 2], "q": "axisQMsr_LBR_iiwa_14_R820_1[*]"}

# What is read as it comes: (text, angles, whether it has velocities, encoding).
READ = {
    "rostopic.csv": (rostopic(), SIX[:, UR_ORDER], True),
    "ros2.csv": (ros2_csv(), SIX[:, UR_ORDER], True),
    "ros2 positions.csv": (ros2_csv(False), SIX[:, UR_ORDER], False),
    "rosbag lists.csv": (rosbag_lists(), SIX[:, UR_ORDER], True),
    "gazebo.csv": (gazebo(), SEVEN, True),
    "plotjuggler.csv": (plotjuggler(), SIX[:, UR_ORDER], True),
    "fingers.csv": (moveit_fingers(), SEVEN, False),
    "moveit points.csv": (moveit_points(), SEVEN, True),
    "libfranka.csv": (libfranka(), SEVEN, True),
    "rtde.csv": (rtde(), SIX, True),
    "ur pendant.csv": (lines(["time", *UR_PENDANT], T, SIX), SIX, False),
    "krc.csv": (krc_trace(), SIX, False, "cp1252"),
    "excel.txt": (excel_wide(), SEVEN, False, "utf-16"),
    "matlab writetable.csv": (writetable(), SEVEN, True),
    "savetxt.txt": (savetxt(), SEVEN, True),
    "pandas.csv": (pandas_index(), SEVEN, False),
    "kdl.txt": (kdl(), SEVEN, False),
    "q and q_d.csv": (
        lines(["t", "q1", "q2", "q_d_1", "q_d_2"], T, SEVEN[:, :2], SEVEN[:, :2] + 1), SEVEN[:, :2], False,
    ),
}  # fmt: skip
# What is asked: (text, a part of the line to write, the answer, angles, whether it has velocities).
ASKED = {
    "sunrise.txt": (sunrise(), "columns={", {"columns": SUNRISE}, SEVEN, False),
    "fri.csv": (fri(), 'columns={"q": "mp*"}', {"columns": {"q": "mp*"}}, SEVEN, False),
    "robomimic.csv": (
        robomimic(), 'columns={"q": "robot0_joint_pos_*"}',
        {"columns": {"q": "robot0_joint_pos_*", "qd": "robot0_joint_vel_*"}}, SEVEN, True,
    ),
    "rlbench.csv": (rlbench(), "step=0.01", {"step": 0.02}, SEVEN, True),
    "moveit states.csv": (moveit_states(), "step=0.01", {"step": 0.02}, SEVEN, False),
    "lerobot.csv": (lerobot(), '"shoulder_pan.pos", ', {"joints": LEROBOT}, SIX[:, :5], False),
    "lerobot state.csv": (
        lerobot_state(), 'columns={"q": "observation.state[*]"}', {"columns": {"q": "observation.state[*]"}}, SIX,
        False,
    ),
    "motoman.csv": (motoman(), 'joints=["joint_1_s", ', {"joints": MOTOMAN}, SIX, False),
    "abb.csv": (abb(), 'columns={"q": "rax_* [deg]"}', {"columns": {"q": "rax_* [deg]"}}, SIX, False),
    "matlab.csv": (matlab(), 'columns={"t": 1, "q1": 2, ', {"limits": HALF_TURN}, SEVEN, True),
    "long.csv": (long_form(), 'table.pivot(index=..., columns="joint", values=...)', None, None, False),
    "timetable.csv": (
        timetable(), "holds '0 sec', and a time must be a number", {"columns": {"q": "q*"}, "step": 0.02}, SEVEN, False,
    ),
    "two arms.csv": (two_arms(), 'columns={"q": "left_joint_*"}', {"columns": {"q": "left_joint_*"}}, SEVEN, False),
    "two sets.csv": (
        lines(["t", *numbered("q{}", 2, 1), *numbered("joint_{}", 2, 1)], T, SEVEN[:, :2], SEVEN[:, :2]),
        'columns={"q": "q*"}', {"columns": {"q": "q*"}}, SEVEN[:, :2], False,
    ),
    "names.csv": (
        lines(["t", "hip_joint", "knee_joint"], T, SEVEN[:, :2]), 'joints=["hip_joint", "knee_joint"]',
        {"joints": ["hip_joint", "knee_joint"]}, SEVEN[:, :2], False,
    ),
    "one joint.csv": (
        lines(["t", "position"], T, SEVEN[:, :1]), 'joints=["position"]', {"columns": {"q1": "position"}},
        SEVEN[:, :1], False,
    ),
    "degrees.csv": (
        lines(["Time", *numbered("J{}", 6, 1)], T, np.rad2deg(SIX)), 'units={"q": "deg"}',
        {"units": {"q": "deg"}}, SIX, False,
    ),
    "microseconds.csv": (
        lines(["timestamp", *numbered("q{}", 7)], 1e6 + 2e4 * np.arange(N), SEVEN),
        'units={"t": "s"}, {"t": "ms"}, {"t": "us"} or {"t": "ns"}', {"units": {"t": "us"}}, SEVEN, False,
    ),
    "two clocks.csv": (
        lines(["time_ms", "time_s", "q1"], 1000 * T, T, SEVEN[:, :1]), 'columns={"t": "time_ms"}',
        {"columns": {"t": "time_ms"}}, SEVEN[:, :1], False,
    ),
    "some units.csv": (
        lines(["t [s]", "q1 [rad]", "q2"], T, SEVEN[:, :2]), 'units={"q": "rad"}', {"units": {"q": "rad"}},
        SEVEN[:, :2], False,
    ),
    "no title.csv": (
        lines(["t", "q1", "", "q3"], T, SEVEN[:, :3]), 'columns={"q": ["q1", 3, "q3"]}',
        {"columns": {"q": ["q1", 3, "q3"]}}, SEVEN[:, :3], False,
    ),
    "no titles.csv": (
        lines(["t", "", "", ""], T, SEVEN[:, :3]), 'columns={"q": [2, 3, ...]}', {"columns": {"q": [2, 3, 4]}},
        SEVEN[:, :3], False,
    ),
    "pandas without titles.csv": (
        lines(["", *numbered("{}", 8)], np.arange(N), T, SEVEN), 'columns={"t": 1}',
        {"columns": {"t": 2, "q": [3, 4, 5, 6, 7, 8, 9]}}, SEVEN, False,
    ),
}  # fmt: skip


def is_right(read, q, has_velocities):
    np.testing.assert_allclose(read.q, q, rtol=0, atol=1e-6)
    np.testing.assert_allclose(read.t - read.t[0], T, rtol=0, atol=1e-6)
    assert read.velocities_given == has_velocities
    np.testing.assert_allclose(read.qd, SPEED[:, : q.shape[1]], rtol=0, atol=1e-4)


@pytest.mark.parametrize("name", READ)
def test_a_form_of_a_program_is_read(file, name):
    text, q, has_velocities, *encoding = READ[name]
    is_right(load(file(text, name, *encoding)), q, has_velocities)


@pytest.mark.parametrize("name", ASKED)
def test_another_form_is_asked_and_read_by_the_answer(file, name):
    text, line, answer, q, has_velocities = ASKED[name]
    path = file(text, name)
    with pytest.raises(ValueError, match=re.escape(line)) as asked:
        load(path)
    assert str(asked.value).startswith(name)
    if answer is not None:
        is_right(load(path, **answer), q, has_velocities)


QUATERNION = np.tile([0, 0, np.sin(0.1), np.cos(0.1)], (N, 1))
POSITION = SEVEN[:, :3]
MATRICES = np.concatenate([np.tile(np.eye(3), (N, 1, 1)), POSITION[:, :, None]], 2).reshape(N, 12)
XYZ, XYZW = "xyz", "xyzw"
NO_ANGLES = {
    "tum.txt": lines([], STAMP + T, POSITION, QUATERNION, by=" "),
    "tum with header.txt": lines(
        ["# timestamp", "tx", "ty", "tz", "qx", "qy", "qz", "qw"], T, POSITION, QUATERNION, by=" ",
    ),
    "kitti.txt": lines([], MATRICES, by=" "),
    "euroc.csv": lines(
        ["#timestamp [ns]", *(f"p_RS_R_{a} [m]" for a in XYZ), *(f"q_RS_{a} []" for a in "wxyz")],
        20_000_000 * np.arange(N), POSITION, QUATERNION,
    ),
    "pose topic.csv": lines(
        ["%time", *(f"field.pose.position.{a}" for a in XYZ), *(f"field.pose.orientation.{a}" for a in XYZW)],
        T, POSITION, QUATERNION,
    ),
    "px4.csv": px4(),
    "tcp.csv": lines(["timestamp", *numbered("actual_TCP_pose_{}", 6)], T, SIX),
    "torques.csv": lines(["time", *numbered("tau_{}", 7, 1)], T, SEVEN),
    "temperatures.csv": lines(["time", *numbered("joint_{}_temperature", 7, 1)], T, SEVEN),
    "currents.csv": lines(["time", *numbered("actual_current_{}", 6)], T, SIX),
    "accelerations.csv": lines(["time", *numbered("qdd{}", 6, 1)], T, SIX),
    "targets.csv": lines(["time", *numbered("target_q_{}", 6)], T, SIX),
    "velocities.csv": lines(["time", *numbered("joint_{} [deg/s]", 6)], T, SIX),
    "pos_x.csv": lines(["time", "pos_x", "pos_y", "pos_z"], T, POSITION),
    "positions.csv": lines(["time", *numbered("position_{}", 3)], T, POSITION),
    "millimetres.csv": lines(["t", "joint_1 [mm]"], T, SEVEN[:, :1]),
}  # fmt: skip


@pytest.mark.parametrize("name", NO_ANGLES)
@pytest.mark.parametrize("limits", [None, HALF_TURN], ids=["no limits", "seven joints"])
def test_columns_that_are_no_joint_angles_are_not_read(file, name, limits):
    with pytest.raises(UnclearFileError, match=re.escape(name)):
        load(file(NO_ANGLES[name], name), limits)


def test_torques_beside_the_angles_are_left_out_and_named(file):
    header = ["time", *numbered("q_{}", 7, 1), *numbered("tau_J_{}", 7, 1)]
    read = load(file(lines(header, T, SEVEN, 30 * SEVEN)), HALF_TURN)
    np.testing.assert_allclose(read.q, SEVEN)
    assert "not used: tau_J_1, tau_J_2" in read.understood


def test_understood_describes_the_column_of_each_joint(file):
    header = ["Zeit [ms]", "Winkel 1 [°]", "Winkel 2 [°]"]
    degrees = np.column_stack([np.linspace(-10, 20, N), np.full(N, 45.5)])
    said = load(file(lines(header, 1000 * T, degrees))).understood.splitlines()
    assert said[1:] == [
        "  t: 'Zeit [ms]', ms",
        "  q1: 'Winkel 1 [°]', deg, -10.0 to 20.0 degrees",
        "  q2: 'Winkel 2 [°]', deg, 45.5 to 45.5 degrees",
    ]


def test_another_number_of_joints_is_said_as_such(file):
    with pytest.raises(
        JointCountError, match="this file has 6 joints, and limits are given for 7"
    ) as wrong:
        load(file(lines(["t", *numbered("q{}", 6, 1)], T, SIX)), iiwa14().limits)
    assert (wrong.value.found, wrong.value.expected) == (6, 7)


# Arguments by which the user says what is what
# -------------------------------------------------------------------------------------------------


def test_joints_are_put_in_the_order_that_the_user_names(file):
    path = file(lines(["t", "knee_joint", "hip_joint"], T, SEVEN[:, :2]))
    np.testing.assert_allclose(load(path, joints=["hip_joint", "knee_joint"]).q, SEVEN[:, [1, 0]])


def test_joints_are_found_in_rows_of_names_too(file):
    read = load(file(rostopic()), joints=["wrist_3_joint", "elbow_joint"])
    np.testing.assert_allclose(read.q, SIX[:, [5, 0]])
    np.testing.assert_allclose(read.qd, SPEED[:, :2])


def test_a_joint_that_is_named_and_not_there_is_refused(file):
    with pytest.raises(UnclearFileError, match="joints names 'ankle_joint', and no column"):
        load(
            file(lines(["t", "knee_joint"], T, SEVEN[:, :1])), joints=["knee_joint", "ankle_joint"]
        )


def test_columns_are_chosen_by_title_or_number(file):
    path = file(lines(["stamp", "a", "b"], T, SEVEN[:, :2]))
    for chosen in ({"t": "stamp", "q1": "b", "q2": "a"}, {"t": 1, "q1": 3, "q2": 2}):
        np.testing.assert_allclose(load(path, columns=chosen).q, SEVEN[:, [1, 0]])


def test_columns_of_a_file_without_header_are_chosen_by_number(file):
    path = file(lines([], SEVEN[:, :2], T))
    read = load(path, columns={"t": 3, "q1": 2, "q2": 1})
    np.testing.assert_allclose(read.q, SEVEN[:, [1, 0]])
    np.testing.assert_allclose(read.t, T)


def test_seconds_and_nanoseconds_are_chosen_as_two_columns(file):
    path = file(lines([], "3", 20_000_000 * np.arange(N), SEVEN[:, 0]))
    np.testing.assert_allclose(load(path, columns={"t": [1, 2], "q1": 3}).t, 3 + T)


def test_a_title_that_occurs_twice_is_chosen_by_its_number(file):
    path = file(lines(["t", "q1", "q1"], T, SEVEN[:, :2]))
    with pytest.raises(
        UnclearFileError,
        match=r'column q1 occurs twice: columns 2 and 3 .*\n.*\n.*\n.*"q": \[2\]',
    ):
        load(path)
    np.testing.assert_allclose(load(path, columns={"q1": 3}).q[:, 0], SEVEN[:, 1])


def test_units_may_differ_from_title_to_title(file):
    path = file(lines(["t", "q1 [deg]", "q2 [rad]"], T, SEVEN[:, :2]))
    np.testing.assert_allclose(load(path).q, SEVEN[:, :2] * [np.pi / 180, 1])


def test_a_unit_that_the_header_denies_is_refused(file):
    path = file(lines(["timestamp_us", "q1"], 1e6 * T, SEVEN[:, :1]))
    np.testing.assert_allclose(load(path).t, T)
    with pytest.raises(
        UnclearFileError, match="units says that t is in ms, and 'timestamp_us' says us"
    ):
        load(path, units={"t": "ms"})


def test_microseconds_are_read_in_every_spelling(file):
    for title, units in (
        ("time [us]", None),
        ("time_us", None),
        ("t [µs]", None),
        ("t", {"t": "us"}),
    ):
        path = file(lines([title, "q1"], 1e6 * T, SEVEN[:, :1]))
        np.testing.assert_allclose(load(path, units=units).t, T)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"joints": "q1"}, "joints must be a list"),
        ({"joints": [1]}, "joints must be names"),
        ({"joints": ["q1", "q1"]}, "joints must be different"),
        ({"columns": "q1"}, "columns must be a dict"),
        ({"columns": {"z": "q1"}}, "columns must have keys"),
        ({"columns": {"q1": None}}, r'columns\["q1"\] must be a title or a number'),
        ({"columns": {"q1": 9}}, r'columns\["q1"\] is 9: columns count from 1'),
        ({"columns": {"q1": ["q1", "q2"]}}, r'columns\["q1"\] must be one column'),
        ({"columns": {"q1": "q1", "q3": "q2"}}, "columns must name q1 to q3; q2 is missing"),
        ({"columns": {"q": "z*"}}, r'columns\["q"\] is \'z\*\''),
        ({"columns": {"t": ["t", "q1", "q2"]}}, r'columns\["t"\] must be one column'),
        ({"units": {"z": "s"}}, "units must be such as"),
        ({"units": {"t": "deg"}}, "units must be such as .*: of t it may be s, ms, us, ns"),
        ({"units": {"q2": "rad"}}, "units must be such as .*: its keys are t, q and qd"),
        ({"units": {"q": 1}}, "units must be such as"),
        ({"units": "deg"}, "units must be such as"),
    ],
)  # fmt: skip
def test_arguments_that_say_nothing_are_refused_by_name(file, arguments, words):
    with pytest.raises(ValueError, match=f"^{words}"):
        load(file(lines(["t", "q1", "q2"], T, SEVEN[:, :2])), **arguments)


# Text
# -------------------------------------------------------------------------------------------------

WHOLE_FIRST = {
    "semicolon.csv": "Zeit;Achse 1;Achse 2\n0;0;0\n0,5;0,6;0,1\n1;1,2;0,2\n",
    "tab.txt": "t\tq1\tq2\n0\t0\t0\n0,5\t0,6\t0,1\n1\t1,2\t0,2\n",
    "space.txt": "t q1 q2\n0 0 0\n0,5 0,6 0,1\n1 1,2 0,2\n",
    "quoted.csv": 't,q1,q2\n0,0,0\n"0,5","0,6","0,1"\n1,"1,2","0,2"\n',
    "declared.csv": "sep=;\nt;q1;q2\n0;0;0\n0,5;0,6;0,1\n1;1,2;0,2\n",
}


@pytest.mark.parametrize("name", WHOLE_FIRST)
def test_a_later_row_shows_the_decimal_comma(file, name):
    read = load(file(WHOLE_FIRST[name], name))
    np.testing.assert_allclose(read.t, [0, 0.5, 1])
    np.testing.assert_allclose(read.q, [[0, 0], [0.6, 0.1], [1.2, 0.2]])
    assert ", decimal comma" in read.understood


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "cp1252"])
def test_text_is_read_in_the_encodings_of_spreadsheets(file, encoding):
    text = lines(["Zeit [s]", "Winkel 1 [°]"], T, np.full(N, 90.0), by=";", comma=True)
    np.testing.assert_allclose(load(file(text, encoding=encoding)).q, np.pi / 2)


SPELLED = {
    "a minus sign": "t;q1\n0;\u22120,5\n0,5;1,5e\u22121\n",
    "Fortran's exponents": "t q1\n0.0D+00 -5.0D-01\n5.0D-01 1.5d-1\n",
}


@pytest.mark.parametrize("program", SPELLED)
def test_numbers_are_read_as_programs_spell_them(file, program):
    read = load(file(SPELLED[program]))
    np.testing.assert_allclose(read.t, [0, 0.5])
    np.testing.assert_allclose(read.q, [[-0.5], [0.15]])


@pytest.mark.parametrize("time", ["2026-03-01 10:00:0{}.5", "2026-03-01T10:00:0{}Z", "17:03:2{}"])
def test_times_that_are_dates_are_asked_about(file, time):
    path = file("stamp,q1\n" + "".join(f"{time.format(i)},0.{i}\n" for i in range(N)))
    with pytest.raises(UnclearFileError, match=r"a time must be a number(?s:.*)step=0\.01"):
        load(path)
    assert load(path, step=0.5).t.tolist() == [0, 0.5, 1, 1.5, 2]


@pytest.mark.parametrize(
    ("name", "advice"),
    [("a.mcap", "--csv"), ("a.YAML", "--csv"), ("a.xlsx", "CSV"), ("a.mat", "writetable")],
)
def test_a_file_that_is_no_table_is_refused_with_what_writes_one(file, name, advice):
    with pytest.raises(ValueError, match=f"must name a .csv.*{advice}"):
        load(file("", name))


BROKEN = {
    "1.234,5 and 0,5": ("t;q1\n0,5;1.234,5\n1,0;0,5\n", "row 1, column q1 is '1.234,5', with a point"),
    "cut off": ("t,q1,q2\n0,1,2\n1,2,3\n2,3", "row 3 has 2 columns, not 3: is the file cut off"),
    "an empty cell": ("t,q1\n0,0.1\n1,\n", "row 2, column q1 is '', which is not a number"),
    "a quote that does not end": ('t,q1\n0,"0.1\n1,0.2\n', "which is not a number"),
    "a null byte": ("t,q1\n0,\0\n1,2\n", "which is not a number"),
    "digits with underscores": ("t,q1\n0,1_0\n1,2\n", "'1_0', which is not a number"),
    "nothing": ("", "it must hold a row of numbers"),
    "no rows": ("t,q1\n", "it must hold a row of numbers"),
    "no number for a time": ("t,q1\nnan,1\n1,2\n", "column t is not a finite number"),
    "a time without end": ("t,q1\n0,1\n1e400,2\n", "column t is not a finite number"),
    "names that change places": (
        "t,name0,name1,position0,position1\n0,joint_1,joint_2,1,2\n0.1,joint_2,joint_1,2,1\n",
        "the joints change their places",
    ),
    "more columns than titles": ("t,q1\n0,1,2\n1,1,2\n", "row 1 has 3 columns, not 2; its header is t,q1. Write a title"),
    "rows without velocities": (
        "t,q1,qd1\n0,1,1\n1,1\n2,1\n3,1,1\n",
        "row 2 has 2 columns, not 3; 2 of 4 rows have another number of columns than the rest. Fill",
    ),
    "a line between messages": ("0,1\n---\n1,1\n", "row 2 has 1 column, not 2; 1 of 3 rows"),
    "an angle that is not a number": ("t,q1\n0,.nan\n1,2\n", "row 1, column q1 is not a finite number"),
}  # fmt: skip


@pytest.mark.parametrize("damage", BROKEN)
def test_a_broken_file_is_refused_in_a_sentence(file, damage):
    text, words = BROKEN[damage]
    with pytest.raises(ValueError, match=re.escape(words)):
        load(file(text))


def test_any_cut_of_a_file_is_read_or_refused_in_a_sentence(file):
    refusals = []
    for text in (rostopic(), rosbag_lists(), long_form(), krc_trace(), ros2_csv()):
        for end in range(1, len(text), 37):
            try:
                load(file(text[:end]))
            except ValueError as refused:
                refusals.append(str(refused))
    assert len(refusals) > 20
    assert all(refused.startswith("own.csv") for refused in refusals)


def test_bytes_at_random_are_refused_in_a_sentence(tmp_path):
    rng = np.random.default_rng(7)
    for size in (1, 2, 3, 7, 40, 999):
        for _ in range(20):
            (tmp_path / "own.csv").write_bytes(rng.bytes(size))
            with pytest.raises(ValueError, match=r"^own\.csv"):
                load(tmp_path / "own.csv")


def test_a_library_arm_s_joint_names_order_its_recording(file):
    assert load(file(rostopic()), ur5e().limits).q.shape == (N, 6)
    shifted = SEVEN + np.array([0, 0, 0, -2, 0, 0.5, 0])
    header = ["%time", *numbered("panda_joint{}", 7, 1)]
    assert load(file(lines(header, T, shifted)), panda().limits).q.shape == (N, 7)


# A joint that was logged within one turn, and velocities that are not there
# -------------------------------------------------------------------------------------------------


def within_one_turn(file, with_velocities, speed=2.0, n=200):
    """Write two joints, of which the second turns on and on, between -180 and 180 degrees."""
    t = 0.02 * np.arange(n)
    turned = np.rad2deg(speed * t)
    rows = [t, 0 * t, (turned + 180) % 360 - 180]
    header = "t,q1 [deg],q2 [deg]"
    if with_velocities:
        rows += [0 * t, np.full(n, np.rad2deg(speed))]
        header += ",qd1 [deg/s],qd2 [deg/s]"
    table = "\n".join(",".join(f"{x:.6f}" for x in row) for row in zip(*rows, strict=True))
    return file(f"{header}\n{table}\n"), speed * t


@pytest.mark.parametrize("with_velocities", [False, True])
def test_a_joint_logged_within_one_turn_is_unwrapped_and_said(file, with_velocities):
    path, angle = within_one_turn(file, with_velocities)
    read = load(path)
    np.testing.assert_allclose(read.q[:, 1], angle, atol=1e-6)
    np.testing.assert_allclose(read.qd[:, 1], 2.0, atol=1e-4)
    assert "q2 is logged within one turn, and unwrapped after row 79" in read.understood
    assert disagreement(read) == ""


def test_a_joint_is_not_unwrapped_beyond_its_limits(file):
    path = file("t,q1\n0,-2.5\n1,-2.4\n2,2.5\n3,2.6\n")
    read = load(path, limits=[[-2.9, 2.9]], units={"t": "s"})
    np.testing.assert_allclose(read.q[:, 0], [-2.5, -2.4, 2.5, 2.6])
    assert "q1 jumps by up to 4.90 rad after row 2, as in the file" in read.understood


def test_an_ambiguous_jump_is_resolved_by_limits(file):
    path = file("t,q1\n0,-2.5\n0.5,2.5\n")
    with pytest.raises(UnclearFileError, match="logged within one turn") as asked:
        load(path)
    assert "[-np.inf, np.inf]" in str(asked.value)
    for limits, last in ([[-np.inf, np.inf]], 2.5 - 2 * np.pi), ([[-3, 3]], 2.5):
        np.testing.assert_allclose(load(path, limits).q[1, 0], last)


@pytest.mark.parametrize("empty", ["nan", "NaN", ".nan", ""])
def test_velocities_without_a_number_are_left_out_and_said(file, empty):
    rows = "".join(f"{0.1 * i:.1f},{0.2 * i:.1f},{i},{empty},{empty}\n" for i in range(4))
    read = load(file(f"t,q1,q2,qd1,qd2\n{rows}"))
    np.testing.assert_allclose(read.qd, np.tile([2.0, 10.0], (4, 1)))
    assert not read.velocities_given
    assert "no velocities" in read.understood
    assert "left out, because they are NaN throughout: qd1, qd2" in read.understood


def test_one_joint_without_velocities_gets_differences(file):
    rows = "".join(f"{0.1 * i:.1f},{0.2 * i:.1f},{i},2,nan\n" for i in range(4))
    read = load(file(f"t,q1,q2,qd1,qd2\n{rows}"))
    np.testing.assert_allclose(read.qd, np.tile([2.0, 10.0], (4, 1)))
    assert "1 velocity" in read.understood
    assert "left out, because they are NaN throughout: qd2" in read.understood
