"""The README says what is true."""

import base64
import io
import re
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path
from unittest import mock

import nbformat
import numpy as np
import pytest
from PIL import Image, ImageSequence

from course_lib.lessons.rotations import check
from course_lib.pack.authors import pictures
from course_lib.pack.grade.jail import isolation
from course_lib.pack.photograph import INSTALL_BROWSER
from course_lib.pack.site.gather import PAGE, sittings

ROOT = Path(__file__).parent.parent
README = (ROOT / "README.md").read_text(encoding="utf-8")
NOTEBOOKS = sorted((ROOT / "notebooks").glob("[0-9][0-9]_*.ipynb"))


def small(picture):
    """Return a picture as an array of one size, with numbers from 0 to 1."""
    return np.asarray(picture.convert("RGB").resize((120, 90)), float) / 255


def opened(path):
    return Image.open(io.BytesIO(path.read_bytes()))


def stored_pictures(shape):
    """Yield the pictures of a shape that the notebooks store, as small arrays."""
    for path in NOTEBOOKS:
        for cell in nbformat.read(path, 4).cells:
            for output in cell.get("outputs", []):
                if "image/png" in output.get("data", {}):
                    content = base64.b64decode(output.data["image/png"])
                    picture = Image.open(io.BytesIO(content))
                    if picture.width * shape[1] == picture.height * shape[0]:
                        yield small(picture)


def test_its_film_is_a_film_of_a_notebook_and_small():
    (name,) = re.findall(r"!\[[^\]]{40,}\]\((\S+)\)", README)
    film = opened(ROOT / name)
    assert (ROOT / name).stat().st_size < pictures.MAX_FILM_BYTES
    frames = np.array([small(frame) for frame in ImageSequence.Iterator(film)])
    assert len(frames) > 20
    distances = [
        np.abs(frames - still).mean((1, 2, 3)).min() for still in stored_pictures(film.size)
    ]
    assert min(distances) < 0.01, (
        "run make animations, then python -m course_lib.pack.authors.pictures"
    )


def test_it_links_every_notebook_with_its_cover():
    for path in NOTEBOOKS:
        number = int(path.name[:2])
        assert f"[{number}]: notebooks/{path.name}" in README
        assert f"[p{number}]: .github/pictures/{path.stem}.png" in README
        assert README.count(f"][{number}]") == 2, "the title and the cover"
        assert README.count(f"][p{number}]") == 1


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_cover_is_that_of_the_notebook_as_it_is_stored(path):
    shown = ROOT / f".github/pictures/{path.stem}.png"
    assert shown.stat().st_size < 20_000
    stored = Image.open(io.BytesIO(pictures.cover(path)))
    difference = np.abs(small(opened(shown)) - small(stored)).mean()
    assert difference < 0.005, "run python -m course_lib.pack.authors.pictures"


def test_the_answer_of_the_check_is_what_the_check_says():
    code, answer = re.search(r"```python\n(def .*?)```\n\n```text\n(.*?)```", README, re.S).groups()
    outputs = []
    with mock.patch("IPython.display.display", lambda data, **options: outputs.append(data)):
        exec(code, {"np": np, "check": check})
    assert outputs[-1]["text/plain"].strip() == answer.strip()


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


def test_a_missing_program_is_named_with_its_package(monkeypatch):
    assert "sudo apt install chromium" in INSTALL_BROWSER
    monkeypatch.setattr("sys.platform", "linux")
    monkeypatch.setattr("shutil.which", lambda name: None)
    assert "sudo apt install bubblewrap" in isolation.problem()


ONLY_ON_UNIX = ("fcntl", "grp", "pwd", "resource", "syslog", "termios")


def test_the_commands_for_windows_need_no_module_of_unix():
    guides = [
        ROOT / name
        for name in ("notebooks/places.md", "course_lib/pack/release/students/README.md")
    ]
    text = "".join([README, PAGE, *(guide.read_text(encoding="utf-8") for guide in guides)])
    assert "&&" not in text, "which PowerShell 5.1 does not know"
    called = set(re.findall(r"\.venv\\Scripts\\(\w+) ([^`\n]+?)(?=`|\n)", text))
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
