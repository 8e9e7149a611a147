"""What is a language to us? A folder: a package whose `TARGET` says which pages it has, and the pages' templates.

Adding a language is adding a folder, here or anywhere else; nothing is registered.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from importlib import import_module
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from textwrap import wrap
from types import ModuleType

from chasles.targets.kernel import EmissionError, TargetKernel

_HOME = Path(__file__).parent
_WIDTH = 112


@dataclass(frozen=True, slots=True)
class Page:
    """A file to be written: `path` below the target's folder, the template's file name, and what it is filled with."""

    path: str
    template: str
    values: Mapping[str, object]


@dataclass(frozen=True, slots=True)
class Origin:
    """What files are made of: the chapter's package, empty for the book, its conventions, and the command."""

    package: str = ""
    conventions: tuple[str, ...] = ()
    command: str = ""

    @property
    def values(self) -> Mapping[str, object]:
        """What every template may say of it."""
        chapter = f" --chapter {self.package}" if self.package else ""
        kernels = f"{self.package}.kernels" if self.package else "chasles.kernels"
        plain = " ".join(self.conventions).replace("*/", "* /").replace("/*", "/ *")
        return {
            "package": self.package,
            "command": self.command or f"chasles{chapter} emit",
            "kernels_module": kernels,
            "checked_module": f"{kernels}.checked" if self.package else "chasles.checked",
            "conventions": wrap(plain, _WIDTH),
        }


Pages = Callable[[tuple[TargetKernel, ...]], Iterable[Page]]


@dataclass(frozen=True, slots=True)
class Target:
    """A language: its name (also its folder in generated/), the folder of its templates, and its pages.

    What is `alone` are the pages that need no other file of ours, to be taken away; None where there are none. A
    language that is not emitted `by_default` is emitted where it is asked for by its name.
    """

    name: str
    templates: Path
    pages: Pages
    alone: Pages | None = None
    by_default: bool = True


def discover(folders: Iterable[Path] = (), named: Iterable[str] | None = None) -> tuple[Target, ...]:
    """The languages that have a folder here and are emitted by default, by name, then those of `folders`.

    With `named`, those of these names, in their order. Raises EmissionError where a folder holds no target, two targets
    have one name, or none has a name that is asked for.
    """
    targets = every_target(folders)
    if named is None:
        return tuple(target for target in targets if target.by_default)
    known = {target.name: target for target in targets}
    for name in (wanted := tuple(dict.fromkeys(named))):
        if name not in known:
            raise EmissionError(f"there is no target {name!r}; there are {', '.join(known)}")
    return tuple(known[name] for name in wanted)


def every_target(folders: Iterable[Path] = ()) -> tuple[Target, ...]:
    """Every language that has a folder here, and those of `folders`; raises EmissionError as `discover` does."""
    here = sorted(path.parent for path in _HOME.glob("*/__init__.py"))
    targets = [_loaded(folder, f"{__package__}.{folder.name}") for folder in here]
    targets += [_loaded(Path(folder), f"{__package__}.added.{Path(folder).name}") for folder in folders]
    names = [target.name for target in targets]
    for name in names:
        if names.count(name) > 1:
            raise EmissionError(f"two targets are called {name!r}; rename one of the folders")
    return tuple(targets)


def _loaded(folder: Path, name: str) -> Target:
    """The TARGET of the package in `folder`."""
    module = import_module(name) if folder.parent == _HOME else _executed(folder, name)
    target = getattr(module, "TARGET", None)
    if not isinstance(target, Target):
        raise EmissionError(f"{folder} is no target: its __init__.py must set TARGET to a Target")
    if target.name != folder.name:
        raise EmissionError(f"{folder} holds the target {target.name!r}; the folder must have the target's name")
    return target


def _executed(folder: Path, name: str) -> ModuleType:
    entrance = folder / "__init__.py"
    spec = spec_from_file_location(name, entrance, submodule_search_locations=[str(folder)])
    if spec is None or spec.loader is None or not entrance.is_file():
        raise EmissionError(f"{folder} is no target: there is no __init__.py in it")
    module = module_from_spec(spec)
    sys.modules[name] = module
    try:
        spec.loader.exec_module(module)
    except Exception as error:
        del sys.modules[name]
        raise EmissionError(f"the target in {folder} does not load: {type(error).__name__}: {error}") from error
    return module
