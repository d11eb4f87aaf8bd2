"""Solid arms: their bodies lie on their joint axes and are where forward kinematics puts them,
complete and small."""

import json

import numpy as np
import pytest
from films import Film
from numpy.testing import assert_allclose

from course_lib import rigid
from course_lib.arms import SerialArm, iiwa14, panda, planar_arm, ur5e
from course_lib.figures import solids
from course_lib.figures.solids import meshes, scene
from course_lib.figures.solids.model import X_RED
from course_lib.figures.toys.film import film as make_film
from course_lib.rotations import random_rotations

NAMED = {"iiwa": iiwa14(), "panda": panda(), "ur5e": ur5e()}
RNG = np.random.default_rng(7)


def random_arm(n, rng):
    omega, points = rng.normal(size=(n, 3)), np.cumsum(rng.normal(scale=0.3, size=(n, 3)), 0)
    return SerialArm.from_screws(
        omega, points, rigid.transform(random_rotations(1, rng)[0], points[-1] + 0.2)
    )


ARMS = NAMED | {
    "planar": planar_arm([1, 0.8, 0.5]),
    "one joint": planar_arm([0.3]),
    **{f"random {n}": random_arm(n, RNG) for n in (1, 2, 4, 6, 9)},
}


# ---- any arm ----


@pytest.mark.parametrize("name", ARMS)
def test_every_arm_is_drawn_where_its_kinematics_puts_it(name):
    arm = ARMS[name]
    q = np.random.default_rng(1).uniform(-2, 2, arm.n)
    toy = make_film(solids.shell(arm), solids.link_poses(arm, q)[None], [0.0], "An arm.")
    film, bare = Film(toy), solids.Model.of(solids.shell(arm))
    assert len(film.local) <= 1650
    assert_allclose(film.poses[0], solids.link_poses(arm, q), atol=6e-6)
    for k, own in enumerate(film.bodies):
        assert_allclose(own, bare.vertices[bare.bodies == k], atol=1e-4)
    assert len(json.dumps(toy.stored())) < 60_000


@pytest.mark.parametrize("name", ARMS)
def test_bodies_move_with_their_joints(name):
    """The last body moves with the end-effector."""
    arm = ARMS[name]
    q = np.random.default_rng(2).uniform(-2, 2, (3, arm.n))
    poses = solids.link_poses(arm, q)
    assert_allclose(poses[:, 0], np.broadcast_to(np.eye(4), (3, 4, 4)))
    assert_allclose(poses[:, -1] @ arm.home[-1], arm.fk(q), atol=1e-12)
    model = solids.Model.of([*solids.shell(arm), *scene.triad(arm.n, arm.home[-1], 0.2)])
    placed, ends = model.placed(poses), arm.fk(q)
    for k in range(3):
        arrow = (model.bodies == arm.n) & (model.colours == X_RED + k)
        tip = np.flatnonzero(arrow)[-1]  # the point that closes it
        assert_allclose(placed[:, tip], ends[:, :3, 3] + 0.2 * ends[:, :3, k], atol=1e-9)


def test_meshes_are_closed_and_their_faces_point_outwards():
    bent = meshes.tube([[0, 0, 0], [0, 0, 1], [0.4, 0, 1.6]], [0.2, 0.1, 0.2])
    every = [
        bent, meshes.drum([1, 0, 0], [0, 1, 0], 0.3, 0.2), meshes.ring([0, 0, 0], [1, 1, 0], 1, 0.1),
        meshes.box([-1, -2, -3], [1, 2, 3]), meshes.arrow([0, 0, 0], [1, 0, 0], 1, 0.05), meshes.ball([0, 0, 1], 0.5),
        meshes.capsule([0, 0, 0], [1, 2, 3], 0.3), meshes.mug(),
    ]  # fmt: skip
    for mesh in every:
        # A closed surface bounds a volume, which does not depend on where it stands: the divergence
        # theorem.
        volumes = [
            _volume(mesh.moved(rigid.transform(np.eye(3), p))) for p in ([0, 0, 0], [3, -2, 1])
        ]
        assert volumes[0] == pytest.approx(volumes[1], rel=1e-9)
        assert volumes[0] > 0


def _volume(mesh):
    a, b, c = mesh.vertices[mesh.faces].swapaxes(0, 1)
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


# ---- films ----


def test_a_film_contains_the_poses_at_twenty_times_a_second():
    arm, times = iiwa14(), np.linspace(0, 4, 401)
    q = np.linspace(-0.5, 1, 401)[:, None] * np.ones(7)
    film = Film(
        made := make_film(
            solids.shell(arm), solids.link_poses(arm, q), times, "An arm swings.", name="a"
        )
    )
    assert_allclose(film.course["times"], times[::5], atol=1e-4)
    assert_allclose(film.poses, solids.link_poses(arm, q[::5]), atol=6e-5)
    assert_allclose(
        film.at(40),
        solids.Model.of(solids.shell(arm)).placed(solids.link_poses(arm, q[200])),
        atol=2e-4,
    )
    assert film.course["movie"] == "a"
    assert len(json.dumps(made.stored())) < 120_000
