"""The exercises of a chapter, by number: one module an exercise, imported when it is asked for."""

from __future__ import annotations

import re
from importlib import import_module
from importlib.util import find_spec
from itertools import chain
from pkgutil import iter_modules

from chasles.statements.chapter import Sentence
from chasles.statements.exercise import Exercise
from chasles.statements.inversion import Inverse
from chasles.statements.packages import BOOK, DeclarationError
from chasles.statements.statement import Statement, Theorem

EXERCISES = "exercises"
_MODULE = re.compile(r"x(\d+(?:_\d+)*)")


class UnknownExercise(LookupError):
    """No exercise of that number; the message names those that there are."""


def exercise_numbers(chapter: str = BOOK) -> tuple[str, ...]:
    """The numbers of all exercises of a chapter, by its package, in order; none where it has no package `exercises`."""
    return tuple(_modules(chapter))


def exercise(number: str, chapter: str = BOOK) -> Exercise:
    """The exercise of that number, "3.7", which the module `x3_07` of the chapter's package `exercises` declares.

    Raises UnknownExercise, and `DeclarationError` for a module that declares none of its number.
    """
    modules = _modules(chapter)
    if number not in modules:
        missing = f"{chapter}.{EXERCISES} would hold it, in a module x{number.replace('.', '_')}"
        there = f"there are {', '.join(modules)}" if modules else missing
        raise UnknownExercise(f"there is no exercise {number!r}; {there}")
    module = f"{chapter}.{EXERCISES}.{modules[number]}"
    found = getattr(import_module(module), "exercise", None)
    if not isinstance(found, Exercise):
        raise DeclarationError(f"{module} declares no `exercise`: write exercise = Exercise({number!r}, ...)")
    if found.number != number:
        raise DeclarationError(f"{found.place}: {module} declares exercise {found.number}: it must be {number}")
    _require_known_names(found)
    return found


def _require_known_names(found: Exercise) -> None:
    """Raises DeclarationError where an exercise speaks of an answer, a datum or a status that it does not have."""
    answers, statuses = {answer.name for answer in found.answers}, set(found.statuses)
    spoken = (
        ("symbols", found.symbols, answers),
        ("signs", chain(*found.signs), answers),
        ("turns", found.turns, answers),
        ("orders", chain(*found.orders), answers),
        ("axes", chain(found.axes, *found.axes.values()), answers | set(found.keys)),
        ("stand_ins", found.stand_ins, set(found.keys)),
        ("only", chain(*(answer.only for answer in found.answers)), statuses),
        ("given", (answer.given for answer in found.answers if answer.given), set(found.keys)),
    )
    for field, names, known in spoken:
        if unknown := [name for name in names if name not in known]:
            there = ", ".join(sorted(known)) or "none"
            raise DeclarationError(f"{found.place}: {field}: there is no {unknown[0]!r}; there are: {there}")


def sentences_of_exercises(chapter: str = BOOK) -> dict[str, Sentence]:
    """What the modules of the exercises declare in addition to the book, by module and name, each sentence once."""
    found: dict[int, tuple[str, Sentence]] = {}
    for module in _files(chapter):
        for name, value in vars(import_module(f"{chapter}.{EXERCISES}.{module}")).items():
            parts = value.values() if isinstance(value, dict) else value if isinstance(value, tuple) else (value,)
            for place, one in enumerate(parts):
                if isinstance(one, Statement | Theorem | Inverse):
                    found.setdefault(id(one), (f"{module}.{name}{place or ''}", one))
    return dict(found.values())


def _modules(chapter: str) -> dict[str, str]:
    """The modules of the exercises, by number."""
    found = [(name, match) for name in _files(chapter) if (match := _MODULE.fullmatch(name))]
    numbers = {name: [int(digits) for digits in match[1].split("_")] for name, match in found}
    return {".".join(map(str, numbers[name])): name for name in sorted(numbers, key=numbers.__getitem__)}


def _files(chapter: str) -> list[str]:
    package = f"{chapter}.{EXERCISES}"
    if find_spec(package) is None:
        return []
    return sorted(module.name for module in iter_modules(import_module(package).__path__))
