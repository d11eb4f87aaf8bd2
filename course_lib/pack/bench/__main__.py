"""Run the comparison, print it, and write it to build/bench/."""

import platform
from importlib import metadata
from pathlib import Path

import numpy as np

from course_lib.pack.bench import kinematics, others, peers, picture, rotation_maps
from course_lib.pack.bench.measure import measured, table

FOLDER = Path("build/bench")


def main():
    """Run all comparisons and write them to build/bench/; return an exit code."""
    here, missing = peers.load()
    versions = [f"{peers.PEERS[name]} {metadata.version(peers.PEERS[name])}" for name in here]
    lines = [
        f"Python {platform.python_version()}, numpy {np.__version__}, {', '.join(versions)}; one thread.",
        *(f"Left out: {peers.PEERS[name]}. {reason}" for name, reason in missing.items()),
        "Compared answers agree to 1e-9. Times are processor time, measured alternately.",
        "",
    ]
    for task in (kinematics.poses(here), kinematics.poses_and_jacobians(here), kinematics.single_pose(here)):
        lines += table(measured(task))
    lines += others.memory()
    task, reached = kinematics.inverse(here)
    outcome = table(measured(task, repeats=5))
    lines += [*outcome[:-1], *reached, "", *table(measured(kinematics.single_target(here)))]
    tasks, exact = rotation_maps.tasks(here)
    for task in tasks:
        lines += table(measured(task))
    lines += [
        "Largest error of rotations by angles near 0 and up to pi; the ratio counts beside those within 1e-12",
        *exact,
        "",
    ]
    lines += others.assignment_6()
    lines += others.import_times()
    curves = picture.seconds_by_size(here)
    batch = "course_lib, one batch"
    loops = [name for name in curves if "loop" in name]
    pays = {name: n for name in loops if (n := picture.pays_from(curves, batch, name)) is not None}
    lines += ["One batch of N poses is as fast as", *(f"  {name}, from N = {n}" for name, n in pays.items())]
    FOLDER.mkdir(parents=True, exist_ok=True)
    text = "\n".join(lines) + "\n"
    (FOLDER / "table.txt").write_text(text, encoding="utf-8")
    picture.draw(curves, {name: n for name, n in pays.items() if n > 1}, FOLDER / "cost.png")
    print(text)
    print(f"Written to {FOLDER}/table.txt and {FOLDER}/cost.png.")


if __name__ == "__main__":
    main()
