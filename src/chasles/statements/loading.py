"""What do the modules of a package of declarations declare? Its statements, in the book's order, in their sections."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Mapping, Sequence
from difflib import get_close_matches
from importlib import import_module
from importlib.util import find_spec
from itertools import chain, combinations
from os import PathLike
from pathlib import Path
from pkgutil import iter_modules
from types import ModuleType
from typing import Any

from chasles.statements.chapter import Chapter, Entry, Section, place_of
from chasles.statements.elsewhere import is_of_another
from chasles.statements.inversion import Inverse
from chasles.statements.packages import BOOK, DeclarationError, imported
from chasles.statements.posing import default_form, problem_of
from chasles.statements.statement import Claim, Condition, Definition, Statement, Theorem, bare, is_rule
from chasles.statements.varied import opened_parts
from chasles.vocabulary import Node, Symbol
from chasles.vocabulary.arguments import fits
from chasles.vocabulary.families import indices_of
from chasles.vocabulary.fitting import measured
from chasles.vocabulary.letters import entry_names
from chasles.vocabulary.measure import Misfit, added
from chasles.vocabulary.tree import symbols_of

KNOWN: dict[str, tuple[Any, str]] = {
    "TITLE": (str, "a text"),
    "SOURCE": (str, "a text"),
    "UNITS": (bool, "True or False: UNITS = False for a chapter without"),
    "CONVENTIONS": (tuple[str, ...], 'a tuple of texts: ("Angles are in radians.",)'),
    "NOTATION": (Any, ""),
}
"""What a package says of itself beside its SECTIONS."""
INEQUALITIES = {"<": "<", ">": ">", "<=": "<=", ">=": ">=", r"\leq": "<=", r"\geq": ">=", r"\le": "<=", r"\ge": ">="}
"""Signs that an equation does not have, as they are written in Python."""


def load(package: str | PathLike[str] = BOOK) -> Chapter:
    """The chapter that a package of declarations declares: its `SECTIONS`, module by module.

    `package` is a name that can be imported, or the path of a folder, known by a separator in it ("./planar").

    Raises `DeclarationError` for contradictory declarations, for none at all and for a folder that is no package, and
    ModuleNotFoundError if there is no package of the name.
    """
    book = imported(package)
    title, source = getattr(book, "TITLE", book.__name__), getattr(book, "SOURCE", "")
    return Chapter(title, declared_by(book), book.__name__, source)


def declared_by(book: ModuleType) -> tuple[Entry, ...]:
    """The statements of a chapter, by its package, module by module. Raises `DeclarationError`."""
    entries: list[Entry] = []
    seen: set[int] = set()
    defined: dict[Node, Node] = {}
    _refuse_misnamed(book)
    for module in _modules(book):
        _refuse_lost(module)
        for each in _entries(module, seen):
            if isinstance(each.statement, Definition):
                defined[bare(each.statement.left)] = each.statement.right
            _refuse_senseless(each, defined)
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


def _refuse_misnamed(book: ModuleType) -> None:
    """Raise `DeclarationError` for what the package says of itself in another way than is read, or by another name."""
    for name, value in vars(book).items() if book.__file__ else ():
        meant = next(iter(get_close_matches(name, KNOWN, 1, 0.8)), "") if name.isupper() else ""
        wrong = ""
        if meant not in ("", name) and meant not in vars(book):
            wrong = f"nothing reads {name}: write {meant}, or give it another name"
        elif name in KNOWN and not fits(value, KNOWN[name][0]):
            wrong = f"{name} is {value!r}: make it {KNOWN[name][1]}"
        if wrong:
            lines = Path(book.__file__ or "").read_text("utf-8").splitlines()
            line = next((k for k, text in enumerate(lines, 1) if re.match(rf"{name}\b", text)), 1)
            raise DeclarationError(f"{book.__file__}, line {line}: {wrong}")


def _refuse_senseless(entry: Entry, defined: Mapping[Node, Node]) -> None:
    """Raise `DeclarationError` for a declaration that says nothing, or that no other could use."""
    said, wrong = entry.statement, ""
    sides = said.printed if isinstance(said, Statement) else ()
    if not said.number.strip():
        wrong = "has no number"
    elif isinstance(said, Theorem) and not said.forms:
        wrong = "has no forms: they are what it says"
    elif isinstance(said, Claim) and said.by is not None and said.restates is None:
        wrong = f"is said to be multiplied by {said.by}, and not what it restates"
    elif isinstance(said, Definition) and not (is_rule(said) or indices_of(said.left)):
        wrong = f"defines {said.left}, which is no symbol: state it as a Condition on what it determines"
    elif isinstance(said, Definition) and bare(said.left) in {*opened_parts(said.right)}:
        wrong = f"defines {said.left} by itself: state it as a Condition on what it determines"
    elif isinstance(said, Statement) and said.sign in INEQUALITIES:
        wrong = f"is an equation, and printed with {said.sign}: say *says_that(left {INEQUALITIES[said.sign]} right)"
    elif isinstance(said, Condition) and (idle := _idle_unknowns(said, defined)):
        wrong = f"is posed on {idle[0]}, which does not occur in it: pose it on what it determines"
    elif isinstance(said, Claim) and said.restates is not None and (unfit := _unfit(said)):
        wrong = f"does not restate what it says it does: {unfit}"
    try:
        others = ("reading", "corrected") if isinstance(said, Statement) else ()
        for left, right in (said.form(which) for which in others if said.form_exists(which)):  # type: ignore[union-attr]
            added(measured(left), measured(right), (left, right), "equate")
    except Misfit as misfit:
        wrong = f"has another form that does not fit: {misfit}"
    named: dict[str, Symbol] = {}
    for side in (*sides, *(side for each in said.given for side in each.printed)):
        for symbol in symbols_of(side):
            if not (symbol.name.strip() and (letter := symbol.letter).strip()):
                wrong = (
                    f"is about {symbol.name or letter!r}: declare it with a name and a letter, neither of them empty"
                )
            if name := next((n for n in _names(symbol) if named.setdefault(n, symbol) != symbol), ""):
                wrong = f"is about two different quantities that are both named {name!r}: give one another name"
    if wrong:
        raise DeclarationError(f"{entry.place}{entry.name} ({said.number}) {wrong}")


def _names(symbol: Symbol) -> Iterator[str]:
    """The names of a symbol's entries, as points show them."""
    rows, columns = symbol.shape
    has_entries = isinstance(rows, int) and isinstance(columns, int)
    yield from chain.from_iterable(entry_names(symbol.name, rows, columns)) if has_entries else (symbol.name,)


def _idle_unknowns(said: Condition, defined: Mapping[Node, Node]) -> list[Symbol]:
    """The symbols that a condition is posed on, and that neither it nor what its letters mean has."""
    seen, waiting = set[Node](), [*said.printed, *(side for each in said.given for side in each.printed)]
    while waiting:
        for part in opened_parts(waiting.pop()):
            if part not in seen:
                seen.add(part)
                waiting += [defined[part]] if part in defined else []
    return [symbol for symbol in said.on if symbol not in seen]


def _unfit(said: Claim) -> str:
    """Why what a claim restates, multiplied, is no equation of its shape and dimension."""
    try:
        problem_of(said, default_form(said))
    except Misfit as misfit:
        return str(misfit)
    except TypeError:
        return ""
    return ""


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
            why = "is declared before any Section, or has a name that something imported had before"
            raise DeclarationError(f"{entry.place}{module}.{entry.name} {why}")
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
