"""Random rotations are uniform: laws of the uniform distribution, tested on many of them."""

import numpy as np
import pytest
import scipy.stats
from scipy.spatial.transform import Rotation

from course_lib.rotations import is_quaternion, is_so, random_quaternions, random_rotations

LEVEL = 1e-6
MANY = 20_000


@pytest.fixture(scope="module", params=[0, 1])
def many(request):
    rng = np.random.default_rng(request.param)
    return random_rotations(MANY, rng), random_quaternions(MANY, rng)


@pytest.fixture(params=["matrices", "quaternions"])
def matrices(request, many):
    """Return rotations drawn either way, turned into matrices by scipy where they are quaternions."""
    R, q = many
    return R if request.param == "matrices" else Rotation.from_quat(q, scalar_first=True).as_matrix()


class TestUniform:
    def test_rotations(self, many):
        R, q = many
        assert is_so(R, 1e-14).all()
        assert is_quaternion(q, 1e-14).all()

    def test_angle(self, matrices):
        """The angle has the density (1 - cos a) / pi."""
        angles = Rotation.from_matrix(matrices).magnitude()
        assert scipy.stats.kstest(angles, lambda a: (a - np.sin(a)) / np.pi).pvalue > LEVEL

    @pytest.mark.parametrize("column", [0, 1, 2])
    def test_image_of_each_axis(self, matrices, column):
        """z and the longitude are uniform and independent on a sphere, so that these cells have equal areas."""
        x, y, z = matrices[..., column].T
        cells = np.histogram2d(z, np.arctan2(y, x), bins=(10, 20), range=[[-1, 1], [-np.pi, np.pi]])[0]
        assert cells.sum() == MANY
        assert scipy.stats.chisquare(cells.ravel()).pvalue > LEVEL

    def test_quaternions_lie_on_the_whole_sphere(self, many):
        """Every entry of a point on S^3 has the density (2 / pi) sqrt(1 - t^2), and all signs are equally likely."""
        for entry in many[1].T:
            p = scipy.stats.kstest(entry, lambda t: 0.5 + (t * np.sqrt(1 - t**2) + np.arcsin(t)) / np.pi).pvalue
            assert p > LEVEL
        signs = np.bincount((many[1] > 0) @ [1, 2, 4, 8], minlength=16)
        assert scipy.stats.chisquare(signs).pvalue > LEVEL


def global_state():
    return np.random.get_state()[1:]  # noqa: NPY002


@pytest.mark.parametrize("draw", [random_rotations, random_quaternions])
def test_the_seed_alone_decides(draw):
    before = global_state()
    first = draw(5, np.random.default_rng(7))
    assert all(np.array_equal(a, b) for a, b in zip(global_state(), before, strict=True))
    np.random.seed(2)  # noqa: NPY002
    rng = np.random.default_rng(7)
    assert np.array_equal(draw(5, rng), first)
    assert not np.isclose(draw(5, rng), first).all(axis=tuple(range(1, first.ndim))).any()
    assert len(np.unique(first.round(9), axis=0)) == 5
