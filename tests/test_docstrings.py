"""Docstrings of the library: their examples run, and they say what goes in and what comes out."""

import doctest
import importlib
import inspect
import re
from pathlib import Path

import pytest

import course_lib

PACKAGE = Path(course_lib.__file__).parent
MODULES = [
    "arguments",
    "rotations",
    "rigid",
    "planar",
    "subproblems",
    "arms",
    "ik",
    "descents",
    "registration",
    "grid_ik",
    "trajectory",
]
# Their functions look at no argument, so they have nothing to say of errors.
TRUSTING = [
    "batched_arm",
    "batching",
    "cells",
    "checks.adapters",
    "checks.answer_types",
    "checks.call_student",
    "checks.exercise",
    "checks.format_numbers",
    "checks.notebook",
    "checks.prediction",
    "checks.vocabulary.cases",
    "checks.vocabulary.comparisons",
    "checks.vocabulary.mistakes",
    "checks.wire",
    "checks.write_test",
    "figures.damped_steps",
    "figures.decomposition_ik",
    "figures.decomposition_pictures",
    "figures.display",
    "figures.mobile_robots",
    "figures.moving",
    "figures.panda_dh_ik",
    "figures.panda_pictures",
    "figures.planar_arm",
    "figures.plots",
    "figures.poe_drawing",
    "figures.poe_kuka_iiwa",
    "figures.poe_pictures",
    "figures.rigid_motion",
    "figures.rotations",
    "figures.rotations_pictures",
    "figures.solids.draw",
    "figures.solids.film",
    "figures.solids.meshes",
    "figures.solids.model",
    "figures.solids.scene",
    "figures.solids.shells",
    "figures.space",
    "figures.style",
    "figures.subproblems_damped_ik",
    "figures.toys.arms",
    "figures.toys.bent_arm",
    "figures.toys.cells",
    "figures.toys.circles",
    "figures.toys.orientation",
    "figures.toys.planar_arm",
    "figures.toys.plane",
    "figures.toys.toy",
]
# Some of their functions need files, a sandbox or a browser, and have no example.
WORKING = [
    "checks.decomposition_ik.shared",
    "checks.panda_dh_ik.challenge",
    "checks.panda_dh_ik.shared",
    "checks.poe_kuka_iiwa.shared",
    "checks.rigid_motion.shared",
    "checks.rotations.shared",
    "checks.subproblems_damped_ik.challenge",
    "checks.subproblems_damped_ik.shared",
    "pack.files",
    "pack.grade.bounded",
    "pack.grade.cells",
    "pack.grade.collect",
    "pack.grade.deadline",
    "pack.grade.feedback",
    "pack.grade.gradebook",
    "pack.grade.marks",
    "pack.grade.notebook_file",
    "pack.grade.platforms",
    "pack.grade.seccomp",
    "pack.grade.student_view",
    "pack.grade.tables",
    "pack.grade.visible",
    "pack.notebooks",
    "pack.release.bundle",
    "pack.release.stubs",
    "pack.site.for_sphinx",
    "pack.site.formulas",
    "pack.site.prepare",
    "pack.site.sections",
]
# Other modules of the library call these with arrays that are looked at already.
WITHIN = {"checked_pose", "checked_arm", "unchecked_length", "SerialArm.pose_and_geometric_jacobian"}


def public(name):
    """Return {dotted name: function or class} of what a module defines for its users, methods too."""
    module = importlib.import_module(f"course_lib.{name}")
    found = {}
    for key, thing in vars(module).items():
        if not key.startswith("_") and getattr(thing, "__module__", "") == module.__name__ and callable(thing):
            found[key] = thing
            if inspect.isclass(thing):
                methods = {f"{key}.{name}": getattr(thing, name) for name in vars(thing) if not name.startswith("_")}
                found |= {name: m for name, m in methods.items() if callable(m) and inspect.getmodule(m) is module}
    return {key: thing for key, thing in found.items() if key not in WITHIN}


ALL = [(name, key, thing) for name in MODULES + TRUSTING for key, thing in public(name).items()]
# An exception has its example with a function that raises it.
SHOWN = [case for case in ALL if not (inspect.isclass(case[2]) and issubclass(case[2], BaseException))]
FUNCTIONS = [case for case in ALL if case[0] in MODULES and not inspect.isclass(case[2])]


def sections(thing):
    """Return {heading: lines} of a docstring in numpydoc style."""
    text = inspect.cleandoc(thing.__doc__)
    parts = re.split(r"^(\w[\w ]*)\n-+\n", text, flags=re.MULTILINE)
    return {"": parts[0], **dict(zip(parts[1::2], parts[2::2], strict=True))}


def test_every_module_is_listed():
    found = {path: ".".join(path.relative_to(PACKAGE).with_suffix("").parts) for path in PACKAGE.rglob("[!_]*.py")}
    of_notebooks = tuple(
        f"checks.{path.stem.partition('_')[2]}." for path in PACKAGE.parent.glob("notebooks/[0-9][0-9]_*.ipynb")
    )
    missing = {path: name for path, name in found.items() if name not in MODULES + TRUSTING + WORKING}
    may_lack_examples = (*of_notebooks, "pack.")
    for path, name in missing.items():
        assert name.startswith(may_lack_examples), name
        assert ">>> " not in path.read_text("utf-8"), f"the examples of {name} are not run"


@pytest.mark.parametrize("name", MODULES + TRUSTING + WORKING)
def test_the_examples_run(name):
    module = importlib.import_module(f"course_lib.{name}")
    outcome = doctest.testmod(module)
    assert outcome.attempted > 0
    assert outcome.failed == 0


@pytest.mark.parametrize(("name", "key", "thing"), ALL, ids=["-".join(case[:2]) for case in ALL])
def test_a_docstring_begins_with_one_sentence(name, key, thing):
    first = inspect.cleandoc(thing.__doc__).split("\n\n")[0]
    assert "\n" not in first
    assert first.endswith(".")


@pytest.mark.parametrize(("name", "key", "function"), FUNCTIONS, ids=["-".join(case[:2]) for case in FUNCTIONS])
def test_a_functions_docstring_has_all_sections(name, key, function):
    said = sections(function)
    taken = [name for name in inspect.signature(function).parameters if name != "self"]
    named = re.findall(r"^\*{0,2}(\w[\w, ]*?)(?: :|$)", said.get("Parameters", ""), flags=re.MULTILINE)
    assert [one for line in named for one in line.split(", ")] == taken
    assert "Returns" in said or said[""].startswith(("Write", "Learn", "Raise"))
    assert "Raises" in said or not taken or key in ("planar_forward", "entry")  # which look at nothing
    # A method of an estimator has its example with the class.
    assert "Examples" in said or key.startswith("GridIK.")


@pytest.mark.parametrize(("name", "key", "thing"), [case for case in SHOWN if case[0] in TRUSTING])
def test_a_docstring_has_an_example(name, key, thing):
    assert "Examples" in sections(thing) or "." in key, "a method may have its example with the class"


@pytest.mark.parametrize("name", TRUSTING + WORKING)
def test_docstrings_name_existing_parameters(name):
    for key, thing in public(name).items():
        listed = sections(thing).get("Parameters", "") if thing.__doc__ else ""
        named = set(", ".join(re.findall(r"^(\w[\w, ]*?) :", listed, re.MULTILINE)).split(", ")) - {""}
        assert not named or named <= set(inspect.signature(thing).parameters), key
