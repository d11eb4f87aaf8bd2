"""The README says what is true."""

import base64
import re
from pathlib import Path

import nbformat

ROOT = Path(__file__).parent.parent
README = (ROOT / "README.md").read_text(encoding="utf-8")


def test_its_picture_is_the_still_of_a_figure_in_the_notebook():
    (picture,) = re.findall(r"!\[[^\]]{40,}\]\((\S+)\)", README)
    cells = nbformat.read(ROOT / "notebooks" / "01_rotations.ipynb", 4).cells
    stills = [o.data["image/png"] for c in cells for o in c.get("outputs", []) if "image/png" in o.get("data", {})]
    assert (ROOT / picture).read_bytes() in [base64.b64decode(still) for still in stills]


def test_every_command_and_file_it_names_is_there():
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    for target in re.findall(r"(?:`|^    )make ([a-z]+)", README, re.MULTILINE):
        assert re.search(rf"^{target}:.*## ", makefile, re.MULTILINE), target
    for name in re.findall(r"`((?:course_lib|tests|notebooks|\.ci|\.github)/[\w./]+)`", README):
        assert (ROOT / name).exists(), name
