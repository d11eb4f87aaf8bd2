"""What is compared: the Panda's kinematics and rotations, by the other libraries that are installed."""

import importlib

import numpy as np

from course_lib import ik, rotations
from course_lib.arms import panda
from course_lib.pack.bench.measure import Contestant, Task

PEERS = ("scipy", "pinocchio", "roboticstoolbox", "modern_robotics")
ARM = panda()
REACHED = 1e-6  # metres and radians
LOOP = "in a loop"


def installed():
    """Return {name: module} of the other libraries, and {name: why it is missing}."""
    here, missing = {}, {}
    for name in PEERS:
        try:
            here[name] = importlib.import_module(name)
        except Exception as error:  # one that cannot start must not stop the others
            missing[name] = f"{type(error).__name__}: {error}"
    return here, missing


def tasks(peers, n):
    """Return all Tasks: with n poses, a tenth of that many targets, and ten times as many rotations."""
    q = np.random.default_rng(0).uniform(*ARM.limits.T, (n, 7))
    return [_poses(peers, q), _jacobians(peers, q), _inverse(peers, ARM.fk(q[: n // 10])), *_rotations(peers, 10 * n)]


def _over(function, items):
    return np.array([function(item) for item in items])


def _poses(peers, q):
    others = []
    if "pinocchio" in peers:
        frames = _pinocchio(peers["pinocchio"])
        others.append(Contestant(f"pinocchio {LOOP}", lambda qs: _over(lambda q: frames(q)[0], qs)))
    if "roboticstoolbox" in peers:
        others.append(Contestant("roboticstoolbox, C++", _toolbox(peers["roboticstoolbox"]).eval))
    if mr := peers.get("modern_robotics"):
        screws, home = ARM.screw_axes.T, ARM.home[-1]
        others.append(
            Contestant(f"modern_robotics {LOOP}", lambda qs: _over(lambda q: mr.FKinSpace(home, screws, q), qs), 300)
        )
    return Task(f"{len(q):,} poses of the Panda", q, ARM.fk, others)


def _jacobians(peers, q):
    others = []
    if "pinocchio" in peers:
        frames = _pinocchio(peers["pinocchio"])

        def ours(pairs):  # its Jacobians have v above omega
            return _flat(np.array([T for T, _ in pairs]), np.array([np.roll(J, 3, 0) for _, J in pairs]))

        others.append(Contestant(f"pinocchio {LOOP}", lambda qs: [frames(q, jacobian=True) for q in qs], convert=ours))
    return Task(
        f"{len(q):,} poses and space Jacobians", q, lambda qs: _flat(ARM.fk(qs), ARM.space_jacobian(qs)), others
    )


def _flat(T, J):
    return np.concatenate([T.reshape(len(T), -1), J.reshape(len(J), -1)], -1)


def _inverse(peers, targets):
    def solve(T):
        return ik.solve(ARM, T, np.random.default_rng(1)).q

    others = []
    if "roboticstoolbox" in peers:
        chain = _toolbox(peers["roboticstoolbox"])

        def theirs(T):  # half the squared error is at most tol; k = 0.1 is the fastest of 1, 0.3, 0.1, 0.03
            return _over(lambda one: chain.ik_LM(one, tol=REACHED**2 / 2, k=0.1).q, T)

        others.append(Contestant("roboticstoolbox's `ik_LM`, C++", theirs, convert=None))
    error = np.abs(ik.pose_error(ARM.fk(solve(targets)), targets)).max()
    solved = "all solved" if error <= REACHED else f"error up to {error:.0e}"
    return Task(f"inverse kinematics of {len(targets):,} targets, {solved}", targets, solve, others)


def _rotations(peers, n):
    rng = np.random.default_rng(0)
    axes = rng.normal(size=(n, 3))
    w = axes / np.linalg.norm(axes, axis=-1, keepdims=True) * rng.uniform(0, np.pi, (n, 1))
    R, q = rotations.exp_so3(w), rotations.matrix_to_quaternion(rotations.exp_so3(w))
    maps = {
        "exp": (w, rotations.exp_so3, lambda S: lambda w: S.from_rotvec(w).as_matrix()),
        "log": (R, rotations.log_so3, lambda S: lambda R: S.from_matrix(R).as_rotvec()),
        "matrix to quaternion": (
            R,
            rotations.matrix_to_quaternion,
            lambda S: lambda R: S.from_matrix(R).as_quat(canonical=True, scalar_first=True),
        ),
        "quaternion to matrix": (
            q,
            rotations.quaternion_to_matrix,
            lambda S: lambda q: S.from_quat(q, scalar_first=True).as_matrix(),
        ),
    }
    made = []
    for name, (items, library, scipys) in maps.items():
        others = []
        if "scipy" in peers:
            from scipy.spatial.transform import Rotation

            others.append(Contestant("scipy", scipys(Rotation)))
        if name in ("exp", "log") and (pin := peers.get("pinocchio")):
            one = {"exp": pin.exp3, "log": pin.log3}[name]
            others.append(Contestant(f"pinocchio {LOOP}", lambda items, one=one: _over(one, items), 20_000))
        made.append(Task(f"{n:,} rotations, {name}", items, library, others))
    return made


def _pinocchio(pin):
    """Return a function of one configuration: the pose, and the pose and the Jacobian."""
    model, joint, before = pin.Model(), 0, np.eye(4)
    # Its joints rotate about the z axis of frames that are given in the previous one, as in modified DH.
    placed = [np.linalg.inv(a) @ b for a, b in zip([before, *ARM.home[:-1]], ARM.home, strict=True)]
    placed = [pin.SE3(T[:3, :3], T[:3, 3]) for T in placed]
    for i, step in enumerate(placed[:-1]):
        joint = model.addJoint(joint, pin.JointModelRZ(), step, f"joint{i}")
    end = model.addFrame(pin.Frame("end", joint, 0, placed[-1], pin.FrameType.OP_FRAME))
    data = model.createData()

    def frames(q, jacobian=False):
        J = pin.computeJointJacobians(model, data, q).copy() if jacobian else pin.forwardKinematics(model, data, q)
        return pin.updateFramePlacement(model, data, end).homogeneous, J

    return frames


def _toolbox(rtb):
    """Return the toolbox's elementary transforms of ARM, from its modified DH rows."""
    ET, quarter = rtb.ET, np.pi / 2
    rows = [(0, 0, 0.333), (0, -quarter, 0), (0, quarter, 0.316), (0.0825, quarter, 0), (-0.0825, -quarter, 0.384)]
    rows += [(0, quarter, 0), (0.088, quarter, 0)]
    steps = [
        step
        for (a, alpha, d), limits in zip(rows, ARM.limits, strict=True)
        for step in (ET.tx(a), ET.Rx(alpha), ET.tz(d), ET.Rz(qlim=limits.tolist()))
    ]
    return rtb.ETS([*steps, ET.tz(0.107)])
