"""The other libraries: which are installed, why others are not, and the Panda in the form that each one needs."""

import importlib
from pathlib import Path

import numpy as np

from course_lib.arms import panda

# module -> name of the package
PEERS = {
    "scipy": "scipy",
    "pinocchio": "pin",
    "roboticstoolbox": "roboticstoolbox-python",
    "modern_robotics": "modern-robotics",
    "pytransform3d": "pytransform3d",
}
LEFT_OUT = Path(".venv-bench/left-out")  # written by environment.sh, "name==version: reason" on each line
ARM = panda()
Q_LIMITS = ARM.limits


def load(names=PEERS, left_out=LEFT_OUT):
    """Return {module's name: module} of those that can be imported, and {its name: reason} of the others."""
    lines = left_out.read_text(encoding="utf-8").splitlines() if left_out.exists() else []
    reasons = {line.partition("==")[0]: line.partition(": ")[2] for line in lines}
    here, missing = {}, {}
    for name, package in names.items():
        try:
            here[name] = importlib.import_module(name)
        except Exception as broken:  # a library that cannot start must not stop the others
            missing[name] = reasons.get(package) or f"{type(broken).__name__}: {broken}"
    return here, missing


def pinocchio_panda(pin):
    """Return pinocchio's model of ARM, its data and the number of the end-effector's frame."""
    model, joint = pin.Model(), 0
    # pinocchio's joints rotate about the z axis of frames that are given in the previous one, as in modified DH.
    before = np.eye(4)
    for i, frame in enumerate(ARM.home[:-1]):
        placed = np.linalg.inv(before) @ frame
        joint = model.addJoint(joint, pin.JointModelRZ(), pin.SE3(placed[:3, :3], placed[:3, 3]), f"joint{i}")
        before = frame
    placed = np.linalg.inv(before) @ ARM.home[-1]
    frame = pin.Frame("end", joint, 0, pin.SE3(placed[:3, :3], placed[:3, 3]), pin.FrameType.OP_FRAME)
    number = model.addFrame(frame)
    return model, model.createData(), number


def toolbox_panda(rtb):
    """Return the toolbox's elementary transforms of ARM, from the modified DH rows that the library uses."""
    ET, quarter = rtb.ET, np.pi / 2
    rows = [(0, 0, 0.333), (0, -quarter, 0), (0, quarter, 0.316), (0.0825, quarter, 0), (-0.0825, -quarter, 0.384)]
    rows += [(0, quarter, 0), (0.088, quarter, 0)]
    chain = [
        step
        for (a, alpha, d), limits in zip(rows, Q_LIMITS, strict=True)
        for step in (ET.tx(a), ET.Rx(alpha), ET.tz(d), ET.Rz(qlim=limits.tolist()))
    ]
    return rtb.ETS([*chain, ET.tz(0.107)])


def over(function, items):
    """Return function of each of the items, in one array: a Python loop."""
    return np.array([function(item) for item in items])
