"""Verdicts: replies that nobody honest writes, and what tells uniform rotations from others."""

import numpy as np
import pytest

from course_lib.checks import rotations as check
from course_lib.checks import wire
from course_lib.checks.exercise import ERROR, WRONG, judge
from course_lib.checks.notebook import describe

NEAREST_SO = check.nearest_so.exercise


def right(M):
    U, _, Vt = np.linalg.svd(M)
    U[:, -1] *= np.linalg.det(U @ Vt)
    return U @ Vt


class Forged:
    def __init__(self, text):
        self.text = text

    def reply(self, questions):
        return self.text


N = len(NEAREST_SO.cases(np.random.default_rng(0)))


def _all(answer):
    return wire.write([answer] * N)


@pytest.mark.parametrize(
    "text",
    [
        None,
        "",
        "null",
        "[]",
        "1",
        wire.write("right"),
        wire.write([]),
        wire.write({i: {} for i in range(N)}),
        wire.write(np.zeros(N)),
        wire.write("x" * N),
        _all({}),
        _all("right"),
        _all(None),
        _all({"value": 1, "changed": []}),
        _all({"value": None, "changed": []}),
        _all({"value": "nonsense", "changed": []}),
        _all({"value": wire.write(np.eye(2))}),
        _all({"value": wire.write(np.eye(2)), "changed": [99]}),
        _all({"value": wire.write(np.eye(2)), "changed": ["M"]}),
        _all({"value": wire.write(np.eye(2)), "changed": np.zeros(3)}),
        _all({"value": wire.write(np.eye(2)), "changed": 1}),
        _all({"value": wire.write(np.eye(2)), "changed": [], "warning": np.zeros(3)}),
        _all({"error": None}),
        _all({"error": "right"}),
        _all({"error": {}}),
        _all({"error": {"type": "right"}}),
        _all({"error": {"type": np.zeros(3), "message": [], "line": {}, "source": None, "state": "right"}}),
        _all({"error": {"type": "x" * 10**6, "message": "x" * 10**6, "line": 0, "source": "x" * 10**6}}),
    ],
    ids=lambda text: repr(text)[:80],
)
def test_a_forged_reply_earns_nothing_and_stops_nothing(text):
    verdict = judge(NEAREST_SO, Forged(text))
    assert verdict.state in (WRONG, ERROR)
    assert verdict.points == 0
    assert len(describe(verdict)) < 2500
