"""The contracts of the import linter hold for every module, also for one that nobody has named in
them."""

from course_copy import copied, run

# {a new module: its source}
STRAYS = {
    "stray.py": "import scipy\n",
    "figures/stray.py": "from course_lib import pack\n",
    "lessons/rotations/stray.py": "from course_lib.lessons.panda_dh_ik import pick\n",
}
SENTENCES = (
    "not listed as layers: - course_lib.stray",
    "course_lib.stray is not allowed to import scipy",
    "course_lib.figures is not allowed to import course_lib.pack",
    "course_lib.lessons.rotations is not allowed to import",
)


def test_a_new_module_that_breaks_a_contract_is_named(tmp_path):
    package = copied(tmp_path, notebooks="01*")
    for module, source in STRAYS.items():
        (package / "course_lib" / module).write_text(source, encoding="utf-8")
    linted = run(package, ".venv/bin/lint-imports", "--no-cache", "--no-logo")
    printed = " ".join(linted.stdout.split())
    assert linted.returncode == 1
    assert [sentence for sentence in SENTENCES if sentence not in printed] == []
