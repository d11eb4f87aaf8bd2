"""Where installed packages keep their files."""

import importlib.util
from pathlib import Path


def folder(name: str) -> Path:
    """Return the folder of an installed package."""
    return Path(importlib.util.find_spec(name).submodule_search_locations[0])
