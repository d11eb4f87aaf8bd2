"""What `make bench` makes of its measurements: it compares what agrees, and its table is README's."""

import time

import numpy as np
import pytest

from course_lib.pack.bench import __main__ as bench
from course_lib.pack.bench import tasks
from course_lib.pack.bench.measure import Contestant, Task, shares


def task(*others):
    return Task("Twice", np.arange(3.0), lambda x: 2 * x, list(others))


def test_a_share_counts_one_item_and_each_library_gets_the_items_it_can_bear():
    def busy(seconds):
        def run(items):
            end = time.process_time() + seconds
            while time.process_time() < end:
                pass
            return 2 * items

        return run

    both = Task("Twice", np.arange(4.0), busy(0.04), [Contestant("few", busy(0.04), items=2)])
    seconds, found = shares(both, repeats=1)
    assert seconds == pytest.approx(0.01, rel=0.1)
    assert found["few"] == pytest.approx(0.5, rel=0.1)


def test_a_library_that_gives_another_answer_stops_the_comparison():
    shares(
        task(Contestant("near", lambda x: 2 * x + 5e-10), Contestant("turned", lambda x: -2 * x, convert=np.negative))
    )
    for other in (lambda x: 2 * x + 1e-8, lambda x: x * np.nan):
        with pytest.raises(ValueError, match="Twice: the answers of far differ by"):
            shares(task(Contestant("far", other)))


def test_a_library_that_is_missing_is_named(monkeypatch):
    monkeypatch.setattr(tasks, "PEERS", ("numpy", "no_such_library"))
    here, missing = tasks.installed()
    assert here == {"numpy": np}
    assert "No module named 'no_such_library'" in missing["no_such_library"]


def test_the_table_takes_its_place_in_the_readme(monkeypatch, tmp_path):
    monkeypatch.setattr(bench, "README", tmp_path / "README.md")
    monkeypatch.setattr(bench, "installed", lambda: ({"numpy": np}, {}))
    monkeypatch.setattr(bench, "tasks", lambda peers, n: [task(Contestant("again", lambda x: 2 * x))])
    bench.README.write_text(f"before\n\n{bench.BEGIN}old\n{bench.END}\nafter\n")
    bench.main([])
    text = bench.README.read_text(encoding="utf-8")
    assert text.startswith(
        f"before\n\n{bench.BEGIN}\n| | time for one | beside | ratio |\n|---|---|---|---|\n| Twice | "
    )
    numpy, processor = f"numpy {np.__version__}", bench.processor()
    assert text.endswith(f"With {numpy}, {numpy},\non {processor}.\n\n{bench.END}\nafter\n")
