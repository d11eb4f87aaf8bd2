"""The contracts of the import linter hold for every module, also for one that nobody has named in
them."""

import pytest
from course_copy import copied, run


@pytest.fixture(scope="module")
def package(tmp_path_factory):
    return copied(tmp_path_factory.mktemp("layers"), notebooks="01*")


def verdict_on(package, module, source):
    """Add a module to the package, return what the linter prints, and take the module away."""
    path = package / "course_lib" / module
    path.write_text(source, encoding="utf-8")
    try:
        linted = run(package, ".venv/bin/lint-imports", "--no-cache", "--no-logo")
    finally:
        path.unlink()
    assert linted.returncode == 1, linted.stdout
    return " ".join(linted.stdout.split())


def test_a_module_without_a_layer_is_refused(package):
    assert "not listed as layers: - course_lib.stray" in verdict_on(
        package, "stray.py", '"""A module without a layer."""\n'
    )


def test_a_new_module_may_not_import_scipy(package):
    printed = verdict_on(package, "stray.py", "import scipy\n")
    assert "course_lib.stray is not allowed to import scipy" in printed


def test_figures_may_not_import_pack(package):
    printed = verdict_on(package, "figures/stray.py", "from course_lib import pack\n")
    assert "course_lib.figures is not allowed to import course_lib.pack" in printed


def test_a_lesson_may_not_import_another(package):
    source = "from course_lib.lessons.panda_dh_ik import pick\n"
    printed = verdict_on(package, "lessons/rotations/stray.py", source)
    assert "course_lib.lessons.rotations is not allowed to import" in printed
