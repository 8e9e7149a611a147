"""The exercises of the book, by number: one module an exercise, imported when it is asked for."""

from __future__ import annotations

import re
from importlib import import_module
from pkgutil import iter_modules

from chasles.statements.exercise import Exercise
from chasles.statements.packages import BOOK

__all__ = ["UnknownExercise", "exercise", "exercise_numbers"]

PACKAGE = f"{BOOK}.exercises"
_MODULE = re.compile(r"x(\d+)_(\d+)")


class UnknownExercise(LookupError):
    """No exercise of that number; the message names those that there are."""


def exercise_numbers(package: str = PACKAGE) -> tuple[str, ...]:
    """The numbers of all exercises, in the book's order."""
    return tuple(_modules(package))


def exercise(number: str, package: str = PACKAGE) -> Exercise:
    """The exercise of that number, "3.7". Raises UnknownExercise."""
    modules = _modules(package)
    if number not in modules:
        raise UnknownExercise(f"there is no exercise {number!r}; there are {', '.join(modules)}")
    found = import_module(f"{package}.{modules[number]}").exercise
    assert isinstance(found, Exercise)
    return found


def _modules(package: str) -> dict[str, str]:
    """The modules of the exercises, by number."""
    names = sorted(module.name for module in iter_modules(import_module(package).__path__))
    found = ((name, _MODULE.fullmatch(name)) for name in names)
    return {f"{int(match[1])}.{int(match[2])}": name for name, match in found if match}
