"""The project holds what its guides promise: folders, packages, workflows and sections."""

import json
import os
import re
import subprocess
from pathlib import Path

import nbformat
import pytest
import yaml
from helpers import unavailable

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text(encoding="utf-8")
PLAN = (ROOT / "course_lib/pack/semester.md").read_text(encoding="utf-8")
TOP_LEVEL = {"Makefile", "README.md", "course_lib", "environment.txt", "notebooks", "tests"}
TOP_LEVEL |= {"pyproject.toml"}  # from which environment.txt is written


def workflow(name):
    return yaml.safe_load((ROOT / f".github/workflows/{name}.yml").read_text(encoding="utf-8"))


def commands(job):
    return [step["run"] for step in job["steps"] if "run" in step]


@pytest.mark.tools("git")
def test_the_top_level_holds_seven_names_and_hidden_settings():
    listed = subprocess.run(["git", "-C", ROOT, "ls-files"], capture_output=True, text=True)
    if listed.returncode:
        unavailable("this is not a git repository")
    names = {line.split("/")[0] for line in listed.stdout.splitlines()}
    assert {name for name in names if not name.startswith(".")} == TOP_LEVEL


@pytest.mark.tools("git")
def test_git_for_windows_keeps_the_line_endings_of_scripts(tmp_path):
    course = tmp_path / "course"
    course.mkdir()
    names = (".gitattributes", "Makefile", "course_lib/pack/environment.sh")
    for name in names:
        (course / name).parent.mkdir(parents=True, exist_ok=True)
        (course / name).write_bytes((ROOT / name).read_bytes())
    about = ["-c", "user.name=a", "-c", "user.email=a@example.org"]
    for command in (["init", "-q"], ["add", "."], [*about, "commit", "-q", "-m", "one"]):
        subprocess.run(["git", *command], cwd=course, check=True)
    clone = ["git", "-c", "core.autocrlf=true", "clone", "-q", str(course), "clone"]
    subprocess.run(clone, cwd=tmp_path, check=True)
    assert not any(b"\r" in (tmp_path / "clone" / name).read_bytes() for name in names)


def test_the_packages_that_the_readme_lists_are_locked():
    table = README.partition("| package |")[2].partition("\n\n")[0]
    packages = re.findall(r"^\| \[([\w-]+)\]", table, re.MULTILINE)
    lock = (ROOT / "environment.txt").read_text(encoding="utf-8").lower()
    assert {"numpy", "plotly", "kaleido", "JupyterLab", "nbval", "scikit-learn"} <= set(packages)
    assert all(re.search(rf"^{package.lower()}==", lock, re.MULTILINE) for package in packages)


def test_the_workflow_for_forks_runs_the_notebooks_on_each_push():
    settings = workflow("notebooks")
    assert settings[True].keys() == {"push", "workflow_dispatch"}  # YAML reads `on` as True
    runs = commands(settings["jobs"]["notebooks"])
    assert any(run.startswith(".venv/bin/pytest --nbval ") for run in runs)
    assert {"make html", "make html SOLUTIONS=no"} <= set(runs)
    kept = [step["with"]["path"] for step in settings["jobs"]["notebooks"]["steps"][-2:]]
    assert kept == ["build/html", "build/html-students"]


def test_the_workflow_publishes_the_pages_without_solutions():
    pages = workflow("notebooks")["jobs"]["pages"]
    assert "github.event.repository.has_pages" in pages["if"]
    assert pages["steps"][0]["with"]["name"] == "site-for-students"


def test_the_workflow_for_changes_tests_every_version_of_python():
    settings = workflow("test")
    assert settings[True].keys() == {"pull_request", "workflow_dispatch"}
    matrix = settings["jobs"]["test"]["strategy"]["matrix"]
    assert matrix["python"] == ["3.11", "3.12", "3.13", "3.14"]
    assert {line["versions"] for line in matrix["include"]} == {"lowest-direct", "highest"}


def test_a_development_container_has_make_s_environment():
    text = (ROOT / ".devcontainer/devcontainer.json").read_text(encoding="utf-8")
    container = json.loads(text)
    program, target = container["postCreateCommand"].split()
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    assert program == "make"
    assert re.search(rf"^{target}:", makefile, re.MULTILINE)
    settings = container["customizations"]["vscode"]["settings"]
    assert settings["python.defaultInterpreterPath"].endswith("/.venv/bin/python")


def test_containers_have_a_python_that_the_workflow_tests():
    tested = workflow("test")["jobs"]["test"]["strategy"]["matrix"]["python"]
    container = (ROOT / ".devcontainer/devcontainer.json").read_text(encoding="utf-8")
    binder = (ROOT / ".binder/runtime.txt").read_text(encoding="utf-8")
    (version,) = re.findall(r"/python:([\d.]+)", container)
    assert {version, binder.strip().removeprefix("python-")} <= set(tested)
    assert os.access(ROOT / ".binder/postBuild", os.X_OK)


def sections(number):
    (path,) = (ROOT / "notebooks").glob(f"0{number}_*.ipynb")
    words = [cell.source for cell in nbformat.read(path, 4).cells if cell.cell_type == "markdown"]
    return re.findall(r"^## (.*)$", "\n".join(words), re.MULTILINE)


def test_the_plan_of_a_semester_names_sections_of_the_notebooks():
    weeks = re.findall(r"^\| \d+ \| (\d), \w+ \|.*\| \*([^*]+)\*", PLAN, re.MULTILINE)
    assert len(weeks) == 12
    for number, title in weeks:
        assert any(section.startswith(title) for section in sections(number)), title
    assert "Where is the mug?" in sections(5)
