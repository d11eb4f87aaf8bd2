"""What students write for test_log_so3(log_so3)."""

import numpy as np

from course_lib.rotations import exp_so3, is_so, rot_x
from course_lib.rotations import log_so3 as library


def _agrees(log_so3, w, atol=1e-7):
    R = exp_so3(np.asarray(w))
    answer = np.asarray(log_so3(R))
    return np.allclose(exp_so3(answer), R, rtol=0, atol=atol) and np.linalg.norm(answer) <= np.pi + 1e-9


def right_exponential_of_the_answer(log_so3):
    axes = np.array([[1, 0, 0], [0, 0.6, -0.8], [-0.48, 0.6, 0.64], [-1, 0, 0]])
    for n in axes:
        for a in (0, 1e-3, 0.5, 2, 3, np.pi):
            if not _agrees(log_so3, a * n):
                return False
    return True


def right_with_asserts(log_so3):
    rng = np.random.default_rng(5)
    for _ in range(40):
        w = rng.normal(size=3)
        w *= rng.uniform(0.01, 3.1) / np.linalg.norm(w)
        assert np.allclose(log_so3(exp_so3(w)), w)
    assert np.allclose(log_so3(np.eye(3)), 0)
    assert np.allclose(log_so3(rot_x(1e-3)), [1e-3, 0, 0])
    n = np.array([0.6, -0.8, 0])
    assert abs(abs(np.dot(log_so3(2 * np.outer(n, n) - np.eye(3)), n)) - np.pi) < 1e-6
    return True


def right_known_answers(log_so3):
    n = np.array([2, -1, 2]) / 3
    answers = [np.asarray(log_so3(exp_so3(a * n))) for a in (0.0, 0.005, 1.0, 2.5)]
    wanted = [0 * n, 0.005 * n, n, 2.5 * n]
    half = np.asarray(log_so3(2 * np.outer(n, n) - np.eye(3)))
    return bool(
        all(np.abs(x - y).max() < 1e-6 for x, y in zip(answers, wanted, strict=True))
        and min(np.abs(half - np.pi * n).max(), np.abs(half + np.pi * n).max()) < 1e-6
    )


def right_one_and_zero(log_so3):
    return int(right_exponential_of_the_answer(log_so3))


def wrong_always_true(log_so3):
    """your test accepts everything"""
    return True


def wrong_always_false(log_so3):
    """your test refuses everything"""
    return False


def wrong_no_special_rotations(log_so3):
    """unnamed"""
    rng = np.random.default_rng(0)
    return all(_agrees(log_so3, w) for w in 0.5 * rng.normal(size=(20, 3)))


def wrong_one_sign_at_half_turns(log_so3):
    """unnamed"""
    for w in ([0, 0, 0], [0, 1e-3, 0], [2.5, 0.5, 0], [0, -np.pi, 0]):
        if not np.allclose(log_so3(exp_so3(np.array(w, float))), w):
            return False
    return True


def wrong_length_not_asked(log_so3):
    """unnamed"""
    for a in (0, 1e-3, 1.0, 2.0, 3.0, np.pi):
        R = exp_so3(a * np.array([-0.48, 0.6, 0.64]))
        if not np.allclose(exp_so3(np.asarray(log_so3(R))), R):
            return False
    return True


def wrong_exact_comparison(log_so3):
    """your test refuses everything"""
    R = rot_x(0.5)
    return bool(np.all(exp_so3(np.asarray(log_so3(R))) == R))


def wrong_compared_with_the_answer_of_itself(log_so3):
    """your test accepts everything"""
    return np.array_equal(log_so3(np.diag([1.0, 1.0, 1.0])), log_so3(np.eye(3)), equal_nan=True)


def wrong_exponential_is_a_rotation(log_so3):
    """your test accepts everything"""
    answer = np.asarray(log_so3(rot_x(0.5)))
    return bool(is_so(exp_so3(answer), 1e-9))


def wrong_printed(log_so3):
    """another form"""
    print(right_exponential_of_the_answer(log_so3))


def wrong_list_for_array(log_so3):
    """TypeError"""
    return np.linalg.norm(log_so3(rot_x(0.5)) - library(rot_x(0.5))) < 1e-9 and log_so3(rot_x(0.5)) * 1.0 is not None


def wrong_identity_of_the_function(log_so3):
    """your test refuses everything"""
    return log_so3 is library


def wrong_function_of_the_library_tested(log_so3):
    """your test accepts everything"""
    R = rot_x(2.0)
    return np.allclose(exp_so3(library(R)), R)


def wrong_failure_swallowed(log_so3):
    """your test accepts everything"""
    try:
        assert right_exponential_of_the_answer(log_so3)
    except Exception:
        print("wrong")
    return True


def wrong_answer_returned(log_so3):
    """another form"""
    return log_so3(rot_x(0.5))


def wrong_return_in_one_branch(log_so3):
    """another form"""
    if not right_exponential_of_the_answer(log_so3):
        return False


def wrong_batch_asked(log_so3):
    """ValueError"""
    R = exp_so3(np.eye(3))
    return np.allclose(exp_so3(log_so3(R)), R)
