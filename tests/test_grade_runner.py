"""How the script in the sandbox waits until there is room for another process."""

import os

import pytest

from course_lib.pack.grade.jail import runner


def test_a_process_is_made_once_killed_ones_have_ended(monkeypatch):
    results = [BlockingIOError(), BlockingIOError(), 1234]

    def fork():
        result = results.pop(0)
        if isinstance(result, BlockingIOError):
            raise result
        return result

    monkeypatch.setattr(os, "fork", fork)
    assert runner.fork_when_there_is_room() == 1234
    assert results == []


def test_waiting_for_room_ends(monkeypatch):
    def fork():
        raise BlockingIOError

    monkeypatch.setattr(os, "fork", fork)
    monkeypatch.setattr(runner, "ROOM_PATIENCE", 0)
    with pytest.raises(BlockingIOError):
        runner.fork_when_there_is_room()
