"""A chapter may rest on another: which chapter declares a statement, and how it is cited in a different one."""

from __future__ import annotations

import sys
from typing import Any


def chapter_of(sentence: Any) -> str:
    """The package of the chapter in whose modules a sentence is declared; empty where that is in none."""
    package = str(sentence.declared_in)
    while package and not _is_chapter(sys.modules.get(package)):
        package = package.rpartition(".")[0]
    return package


def _is_chapter(module: Any) -> bool:
    """Whether a module is a package that lists its sections; in a module alone the name may mean anything."""
    return hasattr(module, "__path__") and hasattr(module, "SECTIONS")


def is_of_another(sentence: Any, package: str) -> bool:
    """Whether a sentence that a module of the chapter holds is imported from another chapter, which has it by name."""
    if chapter_of(sentence) in ("", package):
        return False
    held = vars(sys.modules[sentence.declared_in]).values()
    families = [value.values() for value in held if isinstance(value, dict)]
    return any(value is sentence for values in (held, *families) for value in values)


def other_chapter(statement: Any, here: str) -> str:
    """The package of the chapter that declares a statement, where that is another than `here`; else empty."""
    home = chapter_of(statement)
    return home if here and home != here else ""


def cited(statement: Any, here: str) -> str:
    """The number as a reader of the chapter looks for it: "(3.16)", "(3.4) part 2", "(3.18) of chasles.derivations"."""
    number = f"({statement.number})" if statement.number[:1].isdecimal() else statement.number
    home = other_chapter(statement, here)
    of = f" of {home}" if home else ""
    return f"{number} part {statement.part}{of}" if statement.part > 1 else f"{number}{of}"
