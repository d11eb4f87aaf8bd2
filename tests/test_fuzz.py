"""Garbage in random calls is refused by the argument's name, or answered; see fuzz.py for longer runs."""

import fuzz
import numpy as np
import pytest


@pytest.mark.parametrize("seed", [1, 2])
def test_random_calls_with_garbage(seed):
    assert fuzz.faults(3000, seed) == []


def test_the_fuzz_finds_faults(monkeypatch):
    """Silence, NaN, changed arguments, other errors and refusals without a name are each reported."""
    arguments = {"v": np.ones(3)}

    def fails(function):
        monkeypatch.setattr(fuzz, "calls", lambda rng: ("own", function, {"v": arguments["v"].copy()}))
        monkeypatch.setattr(fuzz, "garbage", lambda rng, valid: valid)
        return fuzz.fault(np.random.default_rng(0)) or ""

    def in_place(v):
        v *= 2
        return v

    def nameless(v):
        raise ValueError("what a vector")

    assert fails(lambda v: v) == ""
    assert "answers with NaN" in fails(lambda v: v * np.nan)
    assert "changes ['v']" in fails(in_place)
    assert "TypeError" in fails(lambda v: v + None)
    assert "names no argument" in fails(nameless)
    assert "RuntimeWarning" in fails(lambda v: v / 0)
