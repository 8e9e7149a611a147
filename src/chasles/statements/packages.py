"""Chapters as packages of declarations, found by the name of the package or by its folder."""

from __future__ import annotations

import os
import sys
from importlib import import_module
from importlib.util import find_spec, module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType

BOOK = "chasles.derivations"


class DeclarationError(ValueError):
    """The declarations contradict each other: a number said twice, a statement resting on a later one."""


def imported(package: str | os.PathLike[str], name: str = "") -> ModuleType:
    """The package of that name, or in the folder that text with a slash or that begins with a dot names.

    What is in a folder is imported as `name` if that is given, else as the folder is called. Raises `DeclarationError`
    for a folder that holds no package or whose name is taken, and ModuleNotFoundError if no package has the name.
    """
    folder = folder_of(package)
    return import_module(str(package)) if folder is None else _imported_from(folder, name or folder.name)


def generated_package(package: str) -> str:
    """The name under which what was emitted of a chapter is imported."""
    return "chasles.generated" if package == BOOK else f"{package}.generated"


def folder_of(package: str | os.PathLike[str]) -> Path | None:
    """The folder that is meant; None where a name is meant."""
    text = os.fspath(package)
    is_path = not isinstance(package, str) or text.startswith(".") or "/" in text or os.sep in text
    return Path(text).resolve() if is_path else None


def _imported_from(folder: Path, name: str) -> ModuleType:
    """The package in the folder, imported under the name; nothing beside it comes to be importable."""
    entrance = folder / "__init__.py"
    if not entrance.is_file():
        raise DeclarationError(f"{folder} is no chapter: there is no __init__.py in it")
    if not name.rpartition(".")[2].isidentifier():
        raise DeclarationError(
            f"{folder} cannot be imported: {name!r} is no name of a Python package; rename the folder"
        )
    known = find_spec(name)
    if known is not None and Path(known.origin or "").resolve() != entrance:
        other = known.origin or "another package"
        raise DeclarationError(f"{folder} cannot be imported: {name} is {other} already; rename the folder")
    if known is not None:
        return import_module(name)
    spec = spec_from_file_location(name, entrance, submodule_search_locations=[str(folder)])
    assert spec is not None
    assert spec.loader is not None
    module = sys.modules[name] = module_from_spec(spec)
    try:
        spec.loader.exec_module(module)
    except BaseException:
        del sys.modules[name]
        raise
    return module
