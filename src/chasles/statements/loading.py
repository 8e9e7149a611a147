"""What do the modules of a package of declarations declare? Its statements, in the book's order, in their sections."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Mapping, Sequence
from importlib import import_module
from importlib.util import find_spec
from itertools import combinations
from pathlib import Path
from pkgutil import iter_modules
from types import ModuleType
from typing import Any

from chasles.statements.chapter import Entry, Section, place_of
from chasles.statements.elsewhere import is_of_another
from chasles.statements.inversion import Inverse
from chasles.statements.packages import DeclarationError
from chasles.statements.statement import Statement, Theorem


def declared_by(book: ModuleType) -> tuple[Entry, ...]:
    """The statements of a chapter, by its package, module by module. Raises `DeclarationError`."""
    entries: list[Entry] = []
    seen: set[int] = set()
    if not isinstance(getattr(book, "UNITS", True), bool):
        raise DeclarationError(f"UNITS of {book.__name__} is {book.UNITS!r}: write UNITS = False for a chapter without")
    for module in _modules(book):
        _refuse_lost(module)
        own = [each for each in _entries(module, seen) if not is_of_another(each.statement, book.__name__)]
        entries += _in_own_sections(module.__name__, own)
        seen.update(id(entry.statement) for entry in entries)
    titles: dict[str, str] = {}
    for section, place in ((entry.section, entry.place) for entry in entries):
        if titles.setdefault(section.number, section.title) != section.title:
            raise DeclarationError(
                f"{place}Section {section.number} is called {titles[section.number]!r} and {section.title!r}: give "
                "one of them another number"
            )
    if not entries:
        raise DeclarationError(f"{book.__name__} has no statements: none of its SECTIONS declares one")
    return tuple(entries)


def _refuse_lost(module: ModuleType) -> None:
    """Raise `DeclarationError` if a name of the module is that of a statement and was given before: that is lost."""
    file = getattr(module, "__file__", None) or ""
    text = Path(file).read_text("utf-8") if file.endswith(".py") else ""
    assigned = re.findall(r"^(\w+) = ", text, re.MULTILINE)
    lines: dict[str, int] = {}
    # Few modules have a name twice, and only these are worth the time of a parser.
    for each in ast.parse(text).body if len({*assigned}) < len(assigned) else ():
        if isinstance(each, ast.Assign) and isinstance(each.value, ast.Call):
            for name in (target.id for target in each.targets if isinstance(target, ast.Name)):
                if name in lines and isinstance(vars(module).get(name), Statement | Theorem | Inverse):
                    raise DeclarationError(
                        f"{file}, line {each.lineno}: {name} is what line {lines[name]} declares already, which would "
                        "be lost: give one of them another name"
                    )
                lines[name] = each.lineno


def _modules(book: ModuleType) -> Iterator[ModuleType]:
    """The modules that the package lists, in its order."""
    listed = getattr(book, "SECTIONS", None)
    if listed is None:
        raise DeclarationError(
            f"{book.__name__} has no SECTIONS: list the names of its modules there, in the book's order"
        )
    if isinstance(listed, str):
        raise DeclarationError(f"the SECTIONS of {book.__name__} are a text, {listed!r}: make them a tuple of names")
    for name in listed:
        module = f"{book.__name__}.{name}"
        if find_spec(module) is None:
            raise DeclarationError(f"{book.__name__} lists {name!r} among its SECTIONS, and there is no such module")
        yield import_module(module)


def unlisted(book: ModuleType) -> list[str]:
    """The modules of the package that are named as sections are, `s2_motion`, and are not among its SECTIONS."""
    names = (module.name for module in iter_modules(getattr(book, "__path__", ())))
    return sorted(name for name in names if re.match(r"s\d", name) and name not in book.SECTIONS)


def _entries(module: ModuleType, seen: set[int]) -> Iterator[Entry]:
    """The statements that a module declares, families of them by name too; those that it imports are `seen` already."""
    section: Section | None = None
    for name, value in _named(vars(module)):
        if isinstance(value, Section):
            section = value
        elif isinstance(value, Statement | Theorem | Inverse) and id(value) not in seen:
            yield Entry(name, section or Section("", ""), value)


def _in_own_sections(module: str, entries: Sequence[Entry]) -> Sequence[Entry]:
    """The entries; raises `DeclarationError` for a number that is among those of an earlier section of the module."""
    for entry in entries:
        if not entry.section.number:
            raise DeclarationError(f"{entry.place}{module}.{entry.name} is declared before any Section")
    numbered: dict[Section, list[tuple[list[int], Entry]]] = {}
    for entry in entries:
        kind, place, _ = place_of(entry.statement.number)
        if kind == 0:
            numbered.setdefault(entry.section, []).append(([digits for digits, _ in place], entry))
    for (earlier, before), (later, own) in combinations(numbered.items(), 2):
        places = [place for place, _ in before]
        strays = [entry for place, entry in own if min(places) <= place <= max(places)]
        rest = [place for place, entry in own if entry not in strays]
        if strays and len(rest) > len(strays) and min(rest) > max(places):
            stray = strays[0]
            raise DeclarationError(
                f"{stray.place}{module}.{stray.name} has the number ({stray.statement.number}), as in Section "
                f"{earlier.number}, and is declared in Section {later.number}: move it there"
                " or number it otherwise"
            )
    return entries


def _named(variables: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    """What has a name: each variable, or what it holds by name if that is a family of statements."""
    for name, value in variables.items():
        if isinstance(value, dict) and not name.startswith("__"):
            yield from value.items()
        else:
            yield name, value
