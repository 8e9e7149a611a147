"""The exercises of the book, by number: one module an exercise, imported when it is asked for."""

from __future__ import annotations

import re
from importlib import import_module
from pkgutil import iter_modules

from chasles.statements.chapter import Sentence
from chasles.statements.exercise import Exercise
from chasles.statements.inversion import Inverse
from chasles.statements.packages import BOOK
from chasles.statements.statement import Statement, Theorem

__all__ = ["UnknownExercise", "exercise", "exercise_numbers", "sentences_of_exercises"]

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


def sentences_of_exercises(package: str = PACKAGE) -> dict[str, Sentence]:
    """What the modules of the exercises declare in addition to the book, by module and name, each sentence once."""
    found: dict[int, tuple[str, Sentence]] = {}
    for module in sorted(module.name for module in iter_modules(import_module(package).__path__)):
        for name, value in vars(import_module(f"{package}.{module}")).items():
            parts = value.values() if isinstance(value, dict) else value if isinstance(value, tuple) else (value,)
            for place, one in enumerate(parts):
                if isinstance(one, Statement | Theorem | Inverse):
                    found.setdefault(id(one), (f"{module}.{name}{place or ''}", one))
    return dict(found.values())


def _modules(package: str) -> dict[str, str]:
    """The modules of the exercises, by number."""
    names = sorted(module.name for module in iter_modules(import_module(package).__path__))
    found = ((name, _MODULE.fullmatch(name)) for name in names)
    return {f"{int(match[1])}.{int(match[2])}": name for name, match in found if match}
