"""The roads that a book declares, by name."""

from __future__ import annotations

from collections.abc import Iterator
from importlib import import_module

from chasles.statements.chapter import DeclarationError
from chasles.statements.derivation import Derivation

__all__ = ["roads", "roads_in"]


def roads(package: str = "chasles.derivations.roads") -> dict[str, Derivation]:
    """The derivations that a package declares, by name, in the order of its modules `ROADS`.

    Raises `DeclarationError` for a name that is given twice, ModuleNotFoundError if there is no such package.
    """
    book = import_module(package)
    found: dict[str, Derivation] = {}
    for module in book.ROADS:
        for name, road in _declared(f"{package}.{module}"):
            if found.setdefault(name, road) is not road:
                raise DeclarationError(f"two roads are called {name}: give one another name")
    return found


def roads_in(module: str, package: str = "chasles.derivations.roads") -> dict[str, Derivation]:
    """The derivations of one module of a package, by name; no other module is imported."""
    return dict(_declared(f"{package}.{module}"))


def _declared(module: str) -> Iterator[tuple[str, Derivation]]:
    for name, value in vars(import_module(module)).items():
        match value:
            case Derivation():
                yield name, value
            case dict():
                yield from ((key, road) for key, road in value.items() if isinstance(road, Derivation))
