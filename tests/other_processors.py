"""Run a notebook as another processor would, and list the cells whose outputs differ.

.venv/bin/python tests/other_processors.py notebooks/03_*.ipynb   # every variant, as a table
"""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

TESTS = Path(__file__).parent

# OpenBLAS's kernels by the processors that they were written for, from the oldest on.
KERNELS = ("Nehalem", "Haswell", "SkylakeX")
PLAIN_LOOPS = {"NPY_DISABLE_CPU_FEATURES": "X86_V3 X86_V4"}
PLAIN_SINES = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA"}

VARIANTS = {
    "noise 1": {"NOISE": "1"},
    "noise 2": {"NOISE": "2"},
    "noise 3": {"NOISE": "3"},
    "kernels of Nehalem, plain loops and sines, one thread": {
        "OPENBLAS_CORETYPE": "Nehalem",
        "OPENBLAS_NUM_THREADS": "1",
        **PLAIN_LOOPS,
        **PLAIN_SINES,
    },
    "kernels of Haswell, two threads": {
        "OPENBLAS_CORETYPE": "Haswell",
        "OPENBLAS_NUM_THREADS": "2",
        "OMP_NUM_THREADS": "2",
    },
    "kernels of SkylakeX, plain sines": {"OPENBLAS_CORETYPE": "SkylakeX", **PLAIN_SINES},
}

# Each check asks one set of its cases: the others differ in their numbers alone.
_START_UP = """\
import sys
sys.path.append({tests!r})
import rounding_noise
rounding_noise.begin({seed})
from course_lib.checks.exercise import PUBLIC_SEED, Exercise
Exercise.public_seeds = (PUBLIC_SEED,)
del sys, rounding_noise, PUBLIC_SEED, Exercise
"""


def missing(variant):
    """Return why this machine cannot run a variant, "" if it can."""
    features = _processor_features()
    if "OPENBLAS_CORETYPE" in variant and not features:
        return "this machine does not say which instructions its processor has"
    if variant.get("OPENBLAS_CORETYPE") == "Haswell" and "avx2" not in features:
        return "the processor has no AVX2"
    if variant.get("OPENBLAS_CORETYPE") == "SkylakeX" and "avx512f" not in features:
        return "the processor has no AVX-512"
    return ""


def differing_cells(notebook, variant):
    """Return the numbers of the code cells, as nbval counts them, whose outputs differ.

    Parameters
    ----------
    notebook : path
    variant : dict
        Environment variables; NOISE is the seed of noise in the last bits.

    Returns
    -------
    list of (int, str)
        The number, and nbval's report of the cell.

    Raises
    ------
    RuntimeError
        If nbval did not come to its end.
    """
    environment = {**os.environ, **variant, "PYTHONPATH": str(TESTS.parent)}
    if "OPENBLAS_CORETYPE" in variant:
        # It belongs to a kernel type that was set for this machine.
        environment.pop("OPENBLAS_L2_SIZE", None)
    with tempfile.TemporaryDirectory() as profile:
        environment["IPYTHONDIR"] = profile
        if "NOISE" in variant:
            start_up = Path(profile, "profile_default", "startup", "noise.py")
            start_up.parent.mkdir(parents=True)
            start_up.write_text(_START_UP.format(tests=str(TESTS), seed=variant["NOISE"]))
        nbval = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", "-p", "no:xdist", "-rN"]
        nbval += ["--nbval", "--nbval-current-env", "--nbval-cell-timeout=1200", "--color=no"]
        run = subprocess.run(
            [*nbval, str(notebook)], env=environment, capture_output=True, text=True, check=False
        )
    if run.returncode not in (0, 1):
        raise RuntimeError(f"nbval ended with {run.returncode}: {run.stdout}{run.stderr}")
    reports = re.split(r"^_+ .*::Cell (\d+) _+$", run.stdout, flags=re.MULTILINE)[1:]
    return [
        (int(number), report) for number, report in zip(reports[::2], reports[1::2], strict=True)
    ]


def _processor_features():
    features = np._core._multiarray_umath.__cpu_features__
    return {name.lower() for name, has in features.items() if has}


def main(notebooks):
    for name, variant in VARIANTS.items():
        reason = missing(variant)
        if reason:
            print(f"{name}: skipped, because {reason}")
            continue
        for notebook in notebooks:
            cells = differing_cells(notebook, variant)
            numbers = ", ".join(str(number) for number, _ in cells) or "none"
            print(f"{name}: {Path(notebook).name}: cells that differ: {numbers}", flush=True)
            for _, report in cells:
                print("    " + "\n    ".join(report.splitlines()[:60]), file=sys.stderr)


if __name__ == "__main__":
    main(sys.argv[1:])
