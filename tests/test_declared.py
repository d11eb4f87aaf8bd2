"""Exercises that say of which kind their arguments are."""

import numpy as np
import pytest

from course_lib.checks import kinds
from course_lib.checks.declared import declared
from course_lib.checks.judge import LocalFunction, review
from course_lib.checks.kinds import Kind, cases_of, sweeps_of
from course_lib.checks.messages import describe
from course_lib.checks.mistake import Mistake
from course_lib.checks.verdict import RIGHT, WRONG
from course_lib.checks.wire import write
from course_lib.rigid import is_se
from course_lib.rotations import is_so

KINDS = {name: kind for name, kind in vars(kinds).items() if isinstance(kind, Kind)}
KINDS |= {"vector": kinds.vector(), "joints": kinds.joint_angles(4), "table": kinds.table(3, 4)}
KINDS |= {"number": kinds.number(1, 2, 1.0), "word": kinds.one_of("world", "body")}


def values(kind):
    """Return values of a kind: an ordinary one, the named ones, those beside these, and some on
    the coarse grid."""
    rng = np.random.default_rng(0)
    beside = [value(rng, gap) for _, value, gaps in kind.beside for gap in gaps[::7]]
    special = [kind.special(rng) for _ in range(20)]
    return [kind.drawn(rng), *kind.named(rng), *beside, *special]


@pytest.mark.parametrize("name", KINDS)
def test_every_value_of_a_kind_can_be_sent_to_the_student(name):
    assert all(write(value) for value in values(KINDS[name]))


@pytest.mark.parametrize(("kind", "is_of_it"), [(kinds.ROTATION, is_so), (kinds.POSE, is_se)])
def test_rotations_and_poses_are_such(kind, is_of_it):
    assert all(is_of_it(value) for value in values(kind))


def test_quaternions_have_length_one():
    lengths = [np.linalg.norm(q) for q in values(kinds.QUATERNION)]
    assert np.allclose(lengths, 1, rtol=0, atol=1e-15)


def test_each_named_value_is_asked_among_ordinary_others():
    first = Kind(drawn=lambda rng: 0, named=lambda rng: [1, 2])
    second = Kind(drawn=lambda rng: 10, named=lambda rng: [11, 12])
    cases = cases_of((first, second), np.random.default_rng(0))
    assert cases[:5] == [(1, 11), (1, 10), (2, 10), (0, 11), (0, 12)]
    assert set(cases[5:]) == {(0, 10)}


def test_what_lies_beside_is_asked_among_ordinary_others():
    first = Kind(drawn=lambda rng: 0, beside=(("1", lambda rng, gap: 1 + gap, (0.5, 0.25)),))
    (sweep,) = sweeps_of((first, Kind(drawn=lambda rng: 10)))
    assert sweep.cases(np.random.default_rng(0)) == [(1.5, 10), (1.25, 10)]


def twice(**more):
    """Return the exercise to double a rotation vector."""
    return declared(
        "twice",
        points=1,
        arguments={"w": kinds.ROTATION_VECTOR},
        library=lambda w: 2 * w,
        says="the answer is 2 w",
        hints=("Double it.",),
        mistakes=(Mistake("w is halved", "Which is larger?", lambda w: w / 2),),
        **more,
    )


TWICE = twice(scale=lambda w: np.linalg.norm(w))


def test_the_library_s_answer_is_right_and_a_mistake_is_named():
    assert review(TWICE, LocalFunction(lambda w: w + w)).state == RIGHT
    assert review(TWICE, LocalFunction(lambda w: 0.5 * w)).mistake.name == "w is halved"


@pytest.mark.parametrize("stated", [{"tolerance": 1e-9}, {"allowed": lambda w: 1e-9}, {}])
def test_a_message_refers_to_a_bound_of_the_task_only_if_it_has_one(stated):
    text = describe(review(twice(**stated), LocalFunction(lambda w: 2 * w + 1e-8)))
    assert ("The task says how large the error may be." in text) == bool(stated)


def test_an_answer_that_is_nearly_right_is_shown_the_entry_that_is_off():
    found = dict(found=lambda value, w: "It is not 2 w.")
    nearly = LocalFunction(lambda w: 2 * w + [0, 1e-5, 0])
    text = describe(review(twice(**found), nearly))
    assert "It is not 2 w. Entry [1] should be 0; yours is 1e-05." in text


def test_a_distance_in_another_measure_is_not_put_beside_numbers():
    nearly = LocalFunction(lambda w: 2 * w + 1e-5)
    half_as_far = twice(
        distance=lambda value, right, w: np.abs(value - right).max() / 2,
        found=lambda value, w: "It is not 2 w.",
    )
    assert "Entry" not in describe(review(half_as_far, nearly))


def test_a_small_argument_counts_where_its_scale_is_given():
    lost = LocalFunction(lambda w: 2 * w if np.linalg.norm(w) > 1e-10 else 0 * w)
    assert review(TWICE, lost).state == WRONG


def test_a_rotation_of_many_revolutions_is_asked():
    wrong_far_out = LocalFunction(lambda w: 2 * w if np.linalg.norm(w) < 40 else w)
    assert review(TWICE, wrong_far_out).state == WRONG


def test_a_case_may_allow_a_larger_error_than_the_others():
    def allowed(w):
        return 1e-3 if np.linalg.norm(w) < 1 else 1e-9

    coarse = twice(allowed=allowed)
    off_if_short = LocalFunction(lambda w: 2 * w + 5e-4 * (np.linalg.norm(w) < 1))
    off_if_long = LocalFunction(lambda w: 2 * w + 5e-4 * (np.linalg.norm(w) > 1))
    assert review(coarse, off_if_short).state == RIGHT
    assert review(coarse, off_if_long).state == WRONG
