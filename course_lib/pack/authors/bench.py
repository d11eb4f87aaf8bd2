"""Compare the library with others, and write README.md's table of speed.

`python -m course_lib.pack.authors.bench [NUMBER]` runs it.
"""

import argparse
import contextlib
import importlib
import platform
import re
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import partial
from importlib import metadata
from pathlib import Path
from timeit import Timer
from types import ModuleType

import numpy as np
from scipy.spatial.transform import Rotation

from course_lib import ik, rotations
from course_lib.arms import panda
from course_lib.pack.files import write_atomically

README = Path("README.md")
BEGIN, END = "<!-- written by make bench -->\n", "<!-- end -->"
# The libraries that are compared beside numpy and scipy: {module: package}.
PEERS = {
    "pinocchio": "pin",
    "roboticstoolbox": "roboticstoolbox-python",
}
# Vector instructions by their flags in /proc/cpuinfo, the widest first.
VECTORS = {"avx512f": "AVX-512", "avx2": "AVX2", "asimd": "NEON"}
# Where Linux describes the caches of the first processor: index0 is that of the first level for
# data, index2 that of the second.
CACHES = Path("/sys/devices/system/cpu/cpu0/cache")
MAX_DIFFERENCE = 1e-9  # of two libraries' answers
REACHED = 1e-6  # metres and radians, by inverse kinematics
MIN_SECONDS = 0.02  # that one measurement lasts; short calls are repeated
ROUNDS = 40  # of which the fastest counts
POSES = 10_000
LOOP = "pinocchio in a loop"
ARM = panda()


@dataclass(frozen=True)
class Task:
    """What is compared: items, the library's function, and those of others.

    `items` is an array whose first axis counts them.

    convert: for those of `others` that need it, converts what they return to the library's
    conventions; None if their answers need not agree. answers: makes one array of what the
    library's function returns. Neither is part of what is measured.
    """

    title: str
    items: np.ndarray
    library: Callable
    others: dict
    convert: dict = field(default_factory=dict)
    answers: Callable = np.asarray


def main(arguments: Sequence[str] | None = None) -> None:
    """Compare, print, and write the table if no library is missing.

    With a number of items it is a trial, which is not written.
    """
    parser = argparse.ArgumentParser(
        prog="python -m course_lib.pack.authors.bench",
        description="Measure the library beside numpy, scipy, pinocchio and the Robotics Toolbox, "
        f"and write the table of speed in {README}.",
        epilog="example: make bench, which measures in an environment of its own",
    )
    parser.add_argument(
        "poses",
        metavar="POSES",
        nargs="?",
        type=_number,
        help="how many poses to compute in a trial, whose table is printed only; "
        f"{POSES} without it",
    )
    poses = parser.parse_args(arguments).poses
    peers, missing = installed()
    lines = ["| | time for one | compared with | ratio |", "|---|---|---|---|"]
    for task in tasks(peers, poses or POSES):
        print(task.title, "...", flush=True)
        seconds, share_of = shares(task)
        one = np.format_float_positional(1e6 * seconds, 2, fractional=False, trim="-")
        for name, share in share_of.items():
            lines.append(f"| {task.title} | {one} µs | {name} | {share:.2g} |")
    versions = [
        f"{name} {metadata.version(PEERS.get(name, name))}" for name in ("numpy", "scipy", *peers)
    ]
    text = "\n".join([*lines, "", f"With {', '.join(versions)},\non {processor()}.", ""])
    print(text)
    if missing or poses:
        print(f"{README} stays as it is.")
        for name, why in missing.items():
            print(f"{name} cannot be loaded: {why}.")
        return
    before, _, rest = README.read_text(encoding="utf-8").partition(BEGIN)
    write_atomically(README, f"{before}{BEGIN}\n{text}\n{END}{rest.partition(END)[2]}")
    print(f"The table is written to {README}.")


def _number(typed: str) -> int:
    """Return a number of poses."""
    if not typed.isdecimal() or int(typed) < 10:
        raise argparse.ArgumentTypeError(f"{typed} is not a whole number, 10 or more")
    return int(typed)


def installed() -> tuple[dict[str, ModuleType], dict[str, str]]:
    """Return {name: module} of the other libraries, and {name: why it is missing}."""
    modules, missing = {}, {}
    for name in PEERS:
        try:
            modules[name] = importlib.import_module(name)
        except Exception as error:  # one that cannot start must not stop the others
            missing[name] = f"{type(error).__name__}: {error}"
    return modules, missing


def processor() -> str:
    """Return the processor's name, vector instructions and caches, as far as the system says.

    The ratios differ from one kind of processor to the next, because numpy uses wide vectors where
    there are any, and chunks are made for a second-level cache of 2 MB.
    """
    name = platform.processor() or platform.machine()
    features = []
    with contextlib.suppress(OSError):
        described = Path("/proc/cpuinfo").read_text()
        model = re.search(r"model name\s*: (.+)", described)
        name = model[1].strip() if model else name
        widest = [title for flag, title in VECTORS.items() if re.search(rf"\b{flag}\b", described)]
        features += widest[:1]
    with contextlib.suppress(OSError):
        for level, cache in (("first", "index0"), ("second", "index2")):
            size = (CACHES / cache / "size").read_text().strip().removesuffix("K")
            features.append(f"{size} kB of {level}-level cache")
    return f"{name} ({', '.join(features)})" if features else name


def shares(task: Task) -> tuple[float, dict[str, float]]:
    """Return the library's seconds for one item, and its shares of the others' times.

    The shares are {name: the library's time divided by the other's}.

    The functions are measured in turn, and the least times count. Raises ValueError if another
    library's answers differ by more than `MAX_DIFFERENCE`.
    """
    some_items = task.items[:200]
    for name, run in task.others.items():
        convert = task.convert.get(name, np.asarray)
        if convert:
            answers = task.answers(task.library(some_items))
            gap = np.abs(convert(run(some_items)) - answers).max()
            if not gap <= MAX_DIFFERENCE:
                raise ValueError(f"{task.title}: the answers of {name} differ by {gap:.1g}")
    # Processor time: other programs on the machine affect it less than the clock.
    timers = [
        Timer(partial(run, task.items), timer=time.process_time)
        for run in (task.library, *task.others.values())
    ]
    repeats = [1 + int(MIN_SECONDS / max(timer.timeit(1), 1e-6)) for timer in timers]
    times = np.empty((ROUNDS, len(timers)))
    for one_round in times:
        for i, (timer, n) in enumerate(zip(timers, repeats, strict=True)):
            one_round[i] = timer.timeit(n) / n
    best = times.min(axis=0) / len(task.items)
    return best[0], dict(zip(task.others, best[0] / best[1:], strict=True))


def tasks(peers: dict[str, ModuleType], n: int) -> list[Task]:
    """Return all Tasks.

    They have n poses, a tenth of that many targets, and ten times as many rotations.
    """
    q = np.random.default_rng(0).uniform(*ARM.limits.T, (n, 7))
    return [
        *_kinematics(peers, q, ARM.fk(q[: n // 10])),
        *_rotations(peers.get("pinocchio"), 10 * n),
    ]


def _over(function: Callable, items: np.ndarray) -> np.ndarray:
    """Return what a function that takes one item makes of each."""
    return np.array([function(item) for item in items])


def _kinematics(peers: dict[str, ModuleType], q: np.ndarray, targets: np.ndarray) -> Iterator[Task]:
    poses, jacobians, inverse = {}, {}, {}
    ik_name = "roboticstoolbox's `ik_LM`, C++"
    pin = peers.get("pinocchio")
    if pin:
        frames = _pinocchio(pin)
        poses[LOOP] = lambda qs: _over(lambda q: frames(q)[0], qs)
        jacobians[LOOP] = lambda qs: [frames(q, jacobian=True) for q in qs]
    rtb = peers.get("roboticstoolbox")
    if rtb:
        first, *others = (rtb.ET.SE3(step) for step in _steps())
        joints = [rtb.ET.Rz(qlim=limits.tolist()) for limits in ARM.limits]
        chain = rtb.ETS(
            [first, *(part for pair in zip(joints, others, strict=True) for part in pair)]
        )
        poses["roboticstoolbox, C++"] = chain.eval
        # Half the squared error is at most tol; k = 0.1 is the fastest of 1, 0.3, 0.1, 0.03.
        inverse[ik_name] = lambda T: _over(
            lambda one: chain.ik_LM(one, tol=REACHED**2 / 2, k=0.1).q, T
        )

    def solve(T):
        return ik.solve(ARM, T, np.random.default_rng(1)).q

    def flat(T, J):
        return np.concatenate([T.reshape(len(T), -1), J.reshape(len(J), -1)], -1)

    def ours(pairs):  # its Jacobians have v above omega
        return flat(np.array([T for T, _ in pairs]), np.array([np.roll(J, 3, 0) for _, J in pairs]))

    error = np.abs(ik.pose_error(ARM.fk(solve(targets)), targets)).max()
    solved = "all solved" if error <= REACHED else f"error up to {error:.0e}"
    yield Task(f"{len(q):,} poses of the Panda", q, ARM.fk, poses)
    both = f"{len(q):,} poses and space Jacobians"

    def poses_and_jacobians(qs):
        return ARM.fk(qs), ARM.space_jacobian(qs)

    yield Task(both, q, poses_and_jacobians, jacobians, {LOOP: ours}, lambda pair: flat(*pair))
    name = f"inverse kinematics of {len(targets):,} targets, {solved}"
    yield Task(name, targets, solve, inverse, {ik_name: None})


def _rotations(pin: ModuleType | None, n: int) -> Iterator[Task]:
    rng = np.random.default_rng(0)
    axes = rng.normal(size=(n, 3))
    w = axes / np.linalg.norm(axes, axis=-1, keepdims=True) * rng.uniform(0, np.pi, (n, 1))
    R, q = rotations.exp_so3(w), rotations.matrix_to_quaternion(rotations.exp_so3(w))
    exp = {"scipy": lambda w: Rotation.from_rotvec(w).as_matrix()}
    log = {"scipy": lambda R: Rotation.from_matrix(R).as_rotvec()}
    to_q = {"scipy": lambda R: Rotation.from_matrix(R).as_quat(canonical=True, scalar_first=True)}
    to_R = {"scipy": lambda q: Rotation.from_quat(q, scalar_first=True).as_matrix()}
    if pin:
        exp[LOOP], log[LOOP] = partial(_over, pin.exp3), partial(_over, pin.log3)
    yield Task(f"{n:,} rotations, exp", w, rotations.exp_so3, exp)
    yield Task(f"{n:,} rotations, log", R, rotations.log_so3, log)
    yield Task(f"{n:,} rotations, matrix to quaternion", R, rotations.matrix_to_quaternion, to_q)
    yield Task(f"{n:,} rotations, quaternion to matrix", q, rotations.quaternion_to_matrix, to_R)


def _steps() -> np.ndarray:
    """Return the poses (8, 4, 4) of the arm's frames in the frame before each, at q = 0.

    The frames are those of the joints, and then the end-effector's. Each joint rotates about the z
    axis of its frame.
    """
    return np.linalg.inv(np.concatenate([np.eye(4)[None], ARM.home[:-1]])) @ ARM.home


def _pinocchio(pin: ModuleType) -> Callable:
    """Return a function of one configuration: the pose, and the Jacobian or None."""
    model, joint = pin.Model(), 0
    *steps, last = (pin.SE3(T[:3, :3], T[:3, 3]) for T in _steps())
    for i, step in enumerate(steps):
        joint = model.addJoint(joint, pin.JointModelRZ(), step, f"joint{i}")
    end = model.addFrame(pin.Frame("end", joint, 0, last, pin.FrameType.OP_FRAME))
    data = model.createData()

    def frames(q, jacobian=False):
        J = (
            pin.computeJointJacobians(model, data, q).copy()
            if jacobian
            else pin.forwardKinematics(model, data, q)
        )
        return pin.updateFramePlacement(model, data, end).homogeneous, J

    return frames


if __name__ == "__main__":
    main()
