"""The README says what is true."""

import base64
import io
import re
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import nbformat
import numpy as np
from matplotlib.image import imread

from course_lib.pack.site.gather import PAGE, hours_in_words, sittings

ROOT = Path(__file__).parent.parent
README = (ROOT / "README.md").read_text(encoding="utf-8")


def test_its_picture_is_the_still_of_a_figure_in_a_notebook():
    (picture,) = re.findall(r"!\[[^\]]{40,}\]\((\S+)\)", README)
    shown, found = imread(ROOT / picture), []
    for path in sorted((ROOT / "notebooks").glob("[0-9][0-9]_*.ipynb")):
        outputs = [
            output for cell in nbformat.read(path, 4).cells for output in cell.get("outputs", [])
        ]
        found += [
            output.data["image/png"] for output in outputs if "image/png" in output.get("data", {})
        ]
    stills = [imread(io.BytesIO(base64.b64decode(still))) for still in found]
    distances = [np.abs(still - shown).mean() for still in stills if still.shape == shown.shape]
    assert min(distances) < 0.005, "copy the new still of the figure"


def test_it_and_the_changes_say_how_long_a_sitting_takes():
    paths = (ROOT / "notebooks").glob("[0-9][0-9]_*.ipynb")
    hours = [sitting for path in paths for sitting in sittings(nbformat.read(path, 4))]
    least, most = hours_in_words(min(hours)), hours_in_words(max(hours))
    for text in (README, (ROOT / "notebooks/changes.md").read_text(encoding="utf-8")):
        assert f"two sittings of {least} to {most} hours" in " ".join(text.split())


def test_the_plan_of_a_semester_has_the_hours_of_the_notebooks():
    plan = (ROOT / "course_lib/pack/semester.md").read_text(encoding="utf-8")
    planned = re.findall(r"^\| \d+ \| (\d), \w+ \| ([\d.]+) \|", plan, re.MULTILINE)
    paths = sorted((ROOT / "notebooks").glob("[0-9][0-9]_*.ipynb"))
    said = [
        (path.name[1], sitting) for path in paths for sitting in sittings(nbformat.read(path, 4))
    ]
    assert [(number, float(hours)) for number, hours in planned] == said
    assert f"{sum(hours for _, hours in said):g} in all" in plan


def test_every_command_and_file_it_names_is_there():
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    for target in re.findall(r"(?:`|^    )make ([a-z]+)", README, re.MULTILINE):
        assert re.search(rf"^{target}:.*## ", makefile, re.MULTILINE), target
    for name in re.findall(r"`((?:course_lib|tests|notebooks|\.ci|\.github)/[\w./]+)`", README):
        assert (ROOT / name).exists(), name


ONLY_ON_UNIX = ("fcntl", "grp", "pwd", "resource", "syslog", "termios")


def test_what_the_commands_for_windows_load_is_there_without_the_modules_of_unix():
    guides = [
        ROOT / name
        for name in ("notebooks/places.md", "course_lib/pack/release/students/README.md")
    ]
    text = "".join([README, PAGE, *(guide.read_text(encoding="utf-8") for guide in guides)])
    called = set(re.findall(r"\.venv\\Scripts\\(\w+) ([^`&\n]+?)(?= &&|`|\n)", text))
    modules = {
        words.split()[1]
        for program, words in called
        if program == "python" and words.startswith("-m ")
    }
    assert called - {("python", f"-m {module}") for module in modules} == {
        ("pip", "install -r environment.txt -e ."), ("python", r"carry_over.py ..\robot-kinematics-@RELEASE@"),
        ("jupyter", "lab exercises"), ("jupyter", "lab notebooks"),
    }  # fmt: skip
    assert modules >= {"course_lib.pack.release.exercises", "course_lib.pack.site"}
    checks = [
        f"course_lib.lessons.{path.stem[3:]}.check"
        for path in (ROOT / "notebooks").glob("[0-9][0-9]_*.ipynb")
    ]
    started = [
        f"{name}.__main__" if find_spec(name).submodule_search_locations else name
        for name in modules
    ]
    lines = [f"import sys; sys.modules.update(dict.fromkeys({ONLY_ON_UNIX}))"]
    lines += [
        f"import {module}"
        for module in (*sorted(started), *sorted(checks), "course_lib.figures.toys.alive")
    ]
    subprocess.run([sys.executable, "-c", "\n".join(lines)], check=True)


def test_no_line_is_too_wide_for_a_terminal():
    assert max(map(len, README.splitlines())) <= 100
