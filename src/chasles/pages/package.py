"""A chapter as a package of declarations: its notation, and a module for each section."""

from __future__ import annotations

import keyword
import re
from collections.abc import Callable, Container, Iterator, Mapping
from contextlib import suppress
from itertools import count
from typing import Any

from chasles import statements, vocabulary
from chasles.pages.python_layout import laid_out
from chasles.pages.python_source import PythonSource, imports
from chasles.statements import Chapter, Entry, Section
from chasles.vocabulary import Symbol, abbreviation, scalar, square, vector
from chasles.vocabulary.notation import BOOK, notation_of
from chasles.vocabulary.sizes import rectangular

NOTATION = "notation"
RESERVED = (
    *vocabulary.__all__,
    *statements.__all__,
    *keyword.kwlist,
    "Fraction",
    "Notation",
    "NOTATION",
    "replace",
    "section",
)
KEPT = "A declaration that you change here is kept when the page is read again."


def package_of(chapter: Chapter, said: Mapping[str, str]) -> dict[str, str]:
    """The text of each module by its file's name; `said` is told above the entries of these names."""
    return _Modules(chapter, said).files()


def identifier(text: str) -> str:
    """The text as a name in Python, with underscores for signs that cannot be in one; empty if no other is left."""
    return re.sub(r"\W+", "_", text.replace("'", "_prime"), flags=re.ASCII).strip("_")


def free_name(name: str, taken: Container[str]) -> str:
    """The name, with a number if it is taken."""
    return next(each for k in count(1) if (each := f"{name}_{k}" if k > 1 else name) not in taken)


class _Modules:
    """Writes the modules; a symbol is declared in the notation when it is first used."""

    def __init__(self, chapter: Chapter, said: Mapping[str, str]) -> None:
        self.chapter, self.said = chapter, said
        self.taken = {*RESERVED, *(entry.name for entry in chapter)}
        self.modules = {section: self._free(f"s{identifier(section.number)}") for section in chapter.sections}
        self.variables: dict[Any, tuple[str, str]] = {
            entry.statement: (f".{self.modules[entry.section]}", entry.name) for entry in chapter
        }
        self.notation = PythonSource(self.variable)
        self.declared: list[str] = []
        self.homes: dict[str, Symbol] = {}

    def files(self) -> dict[str, str]:
        """The modules of the sections, of the notation and of the package, by their names."""
        sections = {f"{name}.py": self._section(section) for section, name in self.modules.items()}
        own = [
            f"TITLE = {self.notation.text(self.chapter.title)}",
            laid_out(f"SECTIONS = {self.notation.text(tuple(self.modules.values()))}"),
        ]
        own += [] if all(each.has_units for each in self.homes.values()) else ["UNITS = False"]
        forms = next((forms for each in self.homes.values() if (forms := notation_of(each)) is not BOOK), None)
        last = [] if forms is None else [laid_out(f"NOTATION = {self.notation.text(forms)}")]
        return {
            "__init__.py": _module("What was read of a page", [], ["\n".join(own)]),
            f"{NOTATION}.py": _module(
                "What the letters are", self._imports(self.notation, NOTATION), ["\n".join(self.declared), *last]
            ),
            **sections,
        }

    def variable(self, value: Any) -> tuple[str, str] | None:
        """The module and the name of the variable that stands for a statement or a symbol."""
        if isinstance(value, Symbol) and value not in self.variables:
            written = self._symbol(value)
            name = identifier(value.name)
            name = self._free(name if name.isidentifier() else f"x_{name}")
            self.declared.append(laid_out(f"{name} = {written}"))
            self.variables[value] = f".{NOTATION}", name
            self.homes.setdefault(value.home, value)
        return self.variables.get(value)

    def _free(self, name: str) -> str:
        found = free_name(name, self.taken)
        self.taken.add(found)
        return found

    def _symbol(self, symbol: Symbol) -> str:
        """The symbol by the function that declares one of its shape, or by its class."""
        for make, given, named in _ways(symbol):
            with suppress(TypeError, ValueError):
                if make(*given, **named) == symbol:
                    texts = [self.notation.text(each) for each in given]
                    texts += [f"{name}={self.notation.text(value)}" for name, value in named.items()]
                    return f"{self.notation.called(make)}({', '.join(texts)})"
        return self.notation.made(symbol)

    def _section(self, section: Section) -> str:
        source = PythonSource(self.variable)
        name = self.modules[section]
        lines = [f"section = {source.text(section)}"]
        for entry in self.chapter:
            if entry.section == section:
                lines.append(self._entry(entry, source))
        return _module(f"Section {section.number}", self._imports(source, name), lines)

    def _entry(self, entry: Entry, source: PythonSource) -> str:
        above = f"# {self.said[entry.name]}\n" if entry.name in self.said else ""
        return f"{above}{entry.name} = {source.made(entry.statement, in_lines=True)}"

    @staticmethod
    def _imports(source: PythonSource, own: str) -> list[str]:
        return [imports(each for each in source.used if each[0] != f".{own}")]


def _ways(symbol: Symbol) -> Iterator[tuple[Callable[..., Symbol], tuple[Any, ...], dict[str, Any]]]:
    """The functions that may declare the symbol, with what they take."""
    given = symbol.name, symbol.letter, symbol.meaning
    height, width = symbol.shape
    if symbol.stands_for is not None:
        yield abbreviation, (*given[:2], symbol.stands_for, symbol.meaning), {}
        return
    dimension = symbol.size.grid[0][0]
    more: dict[str, Any] = {"constant": True} if symbol.constant else {}
    more |= {} if dimension in (None, vocabulary.NO_DIMENSION) else {"dimension": dimension}
    yield scalar, given, more
    for make in (vector, square):
        yield make, given, more if height == 3 else {**more, "size": height}
    yield rectangular, (*given, height, width), more


def _module(says: str, above: list[str], declarations: list[str]) -> str:
    return "\n".join([f'"""{says}. {KEPT}"""', "", *above, "\n\n".join(declarations), ""])
