"""The derivations that a chapter declares, by name."""

from __future__ import annotations

from collections.abc import Iterator
from importlib import import_module
from importlib.util import find_spec

from chasles.statements.derivation import Derivation
from chasles.statements.packages import BOOK, DeclarationError

ROADS = "roads"


def declared_derivations(chapter: str = BOOK) -> dict[str, Derivation]:
    """The derivations that a chapter's package `roads` declares, by name, in the order of its modules `ROADS`.

    A chapter without such a package has none. Raises `DeclarationError` for a name that is given twice, and for a
    package that does not list its modules.
    """
    package = f"{chapter}.{ROADS}"
    if find_spec(package) is None:
        return {}
    book = import_module(package)
    found: dict[str, Derivation] = {}
    if not hasattr(book, "ROADS"):
        raise DeclarationError(f'{package} lists no modules: give its __init__.py ROADS = ("r01_...",)')
    for module in book.ROADS:
        for name, derivation in _declared(f"{package}.{module}"):
            if found.setdefault(name, derivation) is not derivation:
                raise DeclarationError(f"two derivations are called {name}: give one another name")
    return found


def derivations_in(module: str, package: str = f"{BOOK}.{ROADS}") -> dict[str, Derivation]:
    """The derivations of one module of a package, by name; no other module is imported."""
    return dict(_declared(f"{package}.{module}"))


def _declared(module: str) -> Iterator[tuple[str, Derivation]]:
    for name, value in vars(import_module(module)).items():
        match value:
            case Derivation():
                yield name, value
            case dict():
                yield from ((key, found) for key, found in value.items() if isinstance(found, Derivation))
