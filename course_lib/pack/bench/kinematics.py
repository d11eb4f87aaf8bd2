"""The Panda's kinematics: many poses, their Jacobians, one pose, and inverse kinematics."""

import time
from functools import partial

import numpy as np

from course_lib import ik
from course_lib.pack.bench.measure import Contestant, Task
from course_lib.pack.bench.peers import ARM, Q_LIMITS, over, pinocchio_panda, toolbox_panda

REACHED = 1e-6


def configurations(n, seed=0):
    """Return n random configurations within the limits, (n, 7)."""
    return np.random.default_rng(seed).uniform(*Q_LIMITS.T, (n, 7))


def pose_functions(peers):
    """Return {name: function of configurations (n, 7) that gives the poses (n, 4, 4)} of the installed libraries."""
    functions = {}
    if pin := peers.get("pinocchio"):
        model, data, end = pinocchio_panda(pin)

        def with_pinocchio(qs):
            poses = np.empty((len(qs), 4, 4))
            for i, q in enumerate(qs):
                pin.framesForwardKinematics(model, data, q)
                poses[i] = data.oMf[end].homogeneous
            return poses

        functions["pinocchio, Python loop"] = with_pinocchio
    if rtb := peers.get("roboticstoolbox"):
        functions["roboticstoolbox, C++ over the batch"] = toolbox_panda(rtb).eval
    if mr := peers.get("modern_robotics"):
        screws = ARM.screw_axes.T
        functions["modern_robotics, Python loop"] = lambda qs: over(lambda q: mr.FKinSpace(ARM.home[-1], screws, q), qs)
    if "pytransform3d" in peers:
        from pytransform3d import trajectories

        def with_pytransform3d(qs):
            moved = trajectories.transforms_from_exponential_coordinates(qs[..., None] * ARM.screw_axes)
            poses = moved[:, 0]
            for i in range(1, 7):
                poses = poses @ moved[:, i]
            return poses @ ARM.home[-1]

        functions["pytransform3d, batch of exponentials"] = with_pytransform3d
    return functions


def poses(peers, n=10_000):
    """Return the task of computing the poses of n configurations."""
    contestants = [Contestant("course_lib", ARM.fk)]
    for name, function in pose_functions(peers).items():
        few = 300 if name.startswith("modern_robotics") else None
        at_most = 0.5 if name.startswith("pinocchio") else None
        contestants.append(Contestant(name, function, items=few, at_most=at_most))
    if "pinocchio" in peers:
        contestants.append(_not_kept(peers["pinocchio"], jacobians=False))
    return Task(f"Forward kinematics of {n:,} Panda poses, a pose", configurations(n), contestants)


def _not_kept(pin, jacobians):
    model, data, end = pinocchio_panda(pin)

    def run(qs):
        for q in qs:
            if jacobians:
                pin.computeJointJacobians(model, data, q)
                pin.updateFramePlacement(model, data, end)
            else:
                pin.framesForwardKinematics(model, data, q)

    note = "its loop alone, whose answers are dropped; the loop above also puts them into an array"
    return Contestant("pinocchio, answers thrown away", run, note=note, check=False)


def poses_and_jacobians(peers, n=10_000):
    """Return the task of computing the poses and the space Jacobians of n configurations."""
    library = Contestant("course_lib", lambda qs: (ARM.fk(qs), ARM.space_jacobian(qs)), convert=_flat)
    contestants = [library]
    if pin := peers.get("pinocchio"):
        model, data, end = pinocchio_panda(pin)

        def with_pinocchio(qs):
            T, J = np.empty((len(qs), 4, 4)), np.empty((len(qs), 6, 7))
            for i, q in enumerate(qs):
                J[i] = pin.computeJointJacobians(model, data, q)
                T[i] = pin.updateFramePlacement(model, data, end).homogeneous
            return T, J

        def swapped(answer):
            T, J = answer
            return _flat((T, np.concatenate([J[:, 3:], J[:, :3]], 1)))

        note = "its Jacobians have v above omega: swapped before they are compared"
        contestants.append(Contestant("pinocchio, Python loop", with_pinocchio, None, swapped, note, at_most=0.6))
        contestants.append(_not_kept(pin, jacobians=True))
    if rtb := peers.get("roboticstoolbox"):
        chain = toolbox_panda(rtb)

        def of_the_base(answer):
            T, J = answer
            omega = J[:, 3:]
            return _flat((T, np.concatenate([omega, J[:, :3] - np.cross(omega, T[:, :3, 3, None], axis=1)], 1)))

        def with_toolbox(qs):
            return chain.eval(qs), over(chain.jacob0, qs)

        note = "its Jacobians have the velocity of the end's origin above omega: converted before they are compared"
        contestants.append(
            Contestant("roboticstoolbox, C++, loop for Jacobians", with_toolbox, None, of_the_base, note)
        )
    if mr := peers.get("modern_robotics"):
        screws, home = ARM.screw_axes.T, ARM.home[-1]

        def with_modern_robotics(qs):
            return over(lambda q: mr.FKinSpace(home, screws, q), qs), over(lambda q: mr.JacobianSpace(screws, q), qs)

        contestants.append(Contestant("modern_robotics, Python loop", with_modern_robotics, 200, _flat))
    return Task(f"Poses and space Jacobians of {n:,} configurations, a configuration", configurations(n), contestants)


def _flat(answer):
    """Return poses and Jacobians as one array, to be compared."""
    return np.concatenate([part.reshape(len(part), -1) for part in answer], -1)


def single_pose(peers):
    """Return the task of computing one pose in each of 100 calls."""
    contestants = [Contestant("course_lib", lambda qs: over(ARM.fk, qs))]
    for name, function in pose_functions(peers).items():
        at_most = 0.25 if name.startswith("modern_robotics") else None
        alone = name.split(",")[0]
        contestants.append(
            Contestant(alone, lambda qs, f=function: over(lambda q: f(q[None]).reshape(4, 4), qs), at_most=at_most)
        )
    return Task("One Panda pose, a call", configurations(100), contestants)


def inverse(peers, n=1000):
    """Return the task of inverse kinematics for n reachable targets, and lines on the accuracy of each solver."""
    targets = ARM.fk(configurations(n))
    contestants = [Contestant("course_lib", lambda T: ik.solve(ARM, T, _rng()).q)]
    if rtb := peers.get("roboticstoolbox"):
        chain = toolbox_panda(rtb)

        def with_toolbox(k):
            # Half the squared error is at most tol, so the error at most REACHED, as the library's is.
            return lambda T: over(lambda one: chain.ik_LM(one, tol=REACHED**2 / 2, k=k).q, T)

        def cost(k):
            start = time.process_time()
            unsolved = ~_solved(with_toolbox(k)(targets), targets)[0]
            return unsolved.sum() > n / 100, time.process_time() - start

        best = min((1.0, 0.3, 0.1, 0.03, 0.01), key=cost)
        name = f"roboticstoolbox, C++ ik_LM, k = {best:g}, loop"
        note = (
            f"k is the best of 1, 0.3, 0.1, 0.03, 0.01; tol = {REACHED**2 / 2:g}, for it bounds half the squared error"
        )
        contestants.append(Contestant(name, with_toolbox(best), note=note, check=False, at_most=0.6))
    reached = []
    for c in contestants:
        solved, left = _solved(c.run(targets), targets)
        reached.append(
            f"  {c.name}: {solved.sum():,} of {n:,} within 1e-6 m, 1e-6 rad and the limits; "
            f"error: median {np.median(left):.0e}, largest {left.max():.0e}"
        )
    return Task(f"Inverse kinematics of {n:,} reachable Panda targets, a target", targets, contestants), reached


def single_target(peers, n=100):
    """Return the task of inverse kinematics with one target in each call."""
    contestants = [Contestant("course_lib", lambda T: over(lambda one: ik.solve(ARM, one, _rng()).q, T))]
    if rtb := peers.get("roboticstoolbox"):
        chain = toolbox_panda(rtb)
        run = partial(over, lambda one: chain.ik_LM(one, tol=REACHED**2 / 2, k=0.1).q)
        contestants.append(Contestant("roboticstoolbox, C++ ik_LM, k = 0.1", run, check=False))
    return Task("Inverse kinematics of one reachable Panda target, a call", ARM.fk(configurations(n)), contestants)


def _rng():
    return np.random.default_rng(1)


def _solved(q, targets):
    """Return which targets are reached within the limits, and the larger error in metres or radians, (n,) both."""
    left = ik.pose_error(ARM.fk(q), targets)
    left = np.maximum(np.linalg.norm(left[:, :3], axis=1), np.linalg.norm(left[:, 3:], axis=1))
    # The limits of a joint as the toolbox has them may differ in the last digit.
    inside = ((q >= Q_LIMITS[:, 0] - 1e-12) & (q <= Q_LIMITS[:, 1] + 1e-12)).all(-1)
    return (left <= REACHED) & inside, left
