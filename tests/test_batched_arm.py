"""Many configurations at once (course_lib.batched_arm) against a few at a time, in any batch,
within little memory."""

import tracemalloc

import numpy as np
import pytest
from helpers import close, pose_samples

from course_lib import arms
from course_lib.arms import DHRow, SerialArm, iiwa14, panda, planar_arm, ur5e
from course_lib.batched_arm import CHUNK

RNG = np.random.default_rng(0)
SKEW = SerialArm.from_screws(
    RNG.normal(size=(6, 3)), RNG.normal(size=(6, 3)), pose_samples(3)(RNG, ())
)
STANDARD = SerialArm.from_dh(
    [DHRow(0.3, 0.4, 0.2, 1.0), DHRow(-0.1, -2.0, 0.5), DHRow(0, 0, 0.1, -3.0)],
    "standard",
    pose_samples(3)(RNG, ()),
)
ALL = {
    "panda": panda(),
    "iiwa14": iiwa14(),
    "planar": planar_arm([1, 1e-9, 2]),
    "skew": SKEW,
    "standard": STANDARD,
}
ALL["ur5e"] = ur5e()
ALL["one joint"] = SerialArm.from_screws([[0, -1, 0]], [[1, 2, 3]], np.eye(4))
METHODS = [
    "frames",
    "fk",
    "space_jacobian",
    "body_jacobian",
    "geometric_jacobian",
    "position_jacobian",
]


def configurations(arm, *batch):
    return np.random.default_rng(1).uniform(-4, 4, (*batch, arm.n))


SHAPES = [
    (0,),
    (1,),
    (0, 7),
    (3, 1, 2),
    (arms._SMALL_BATCH,),
    (arms._SMALL_BATCH + 1,),
    (20, 1, 5),
    (CHUNK + 1,),
]


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    ("name", "batch"), [*((name, (400,)) for name in ALL), *(("skew", shape) for shape in SHAPES)]
)
def test_a_batch_gives_the_results_of_each_alone(name, batch, method):
    of, q = getattr(ALL[name], method), configurations(ALL[name], *batch)
    q.flags.writeable = False
    shape = of(np.zeros(ALL[name].n)).shape
    alone = np.array([of(one) for one in q.reshape(-1, ALL[name].n)]).reshape(batch + shape)
    close(of(q), alone, 2e-14)
    close(of(0 * q), np.broadcast_to(of(np.zeros(ALL[name].n)), alone.shape), 1e-14)


@pytest.mark.parametrize("method", METHODS)
def test_memory_is_at_most_three_times_the_result(method):
    arm, q = panda(), configurations(panda(), 100_000)
    tracemalloc.start()
    try:
        result = getattr(arm, method)(q)
        most = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert most <= 3 * (result.base.nbytes if method == "position_jacobian" else result.nbytes)
