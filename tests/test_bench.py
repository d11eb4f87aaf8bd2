"""What `make bench` makes of its measurements: it compares what agrees, and its table is
README's."""

import numpy as np
import pytest
import scipy

from course_lib.pack.authors import bench
from course_lib.pack.authors.bench import Task, shares


def task(other, convert=np.asarray):
    return Task("Twice", np.arange(3.0), lambda x: 2 * x, {"other": other}, {"other": convert})


def test_a_library_with_a_different_answer_stops_the_bench():
    shares(task(lambda x: 2 * x + 5e-10))
    shares(task(lambda x: -2 * x, np.negative))
    shares(task(lambda x: 7 * x, None))
    for other in (lambda x: 2 * x + 1e-8, lambda x: x * np.nan):
        with pytest.raises(ValueError, match="Twice: the answers of other differ by"):
            shares(task(other))


def test_the_table_takes_its_place_in_the_readme(monkeypatch, tmp_path):
    monkeypatch.setattr(bench, "README", tmp_path / "README.md")
    monkeypatch.setattr(bench, "installed", lambda: ({}, {}))
    monkeypatch.setattr(bench, "tasks", lambda peers, n: [task(lambda x: 2 * x)])
    bench.README.write_text(f"before\n\n{bench.BEGIN}old\n{bench.END}\nafter\n")
    bench.main([])
    text = bench.README.read_text(encoding="utf-8")
    assert text.startswith(
        f"before\n\n{bench.BEGIN}\n| | time for one | compared with | ratio |\n|---|---|---|---|\n"
        "| Twice | "
    )
    versions = f"numpy {np.__version__}, scipy {scipy.__version__}"
    assert text.endswith(f"With {versions},\non {bench.processor()}.\n\n{bench.END}\nafter\n")
