"""A notation from a TOML file: what the letters of a page are, and how its words are spelled."""

from __future__ import annotations

import re
import sys
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cache, partial
from hashlib import sha256
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any, cast

from chasles.nearest import nearest
from chasles.reading.atoms import Unread
from chasles.reading.declared_letters import declare_letter
from chasles.reading.fits import own_quantity
from chasles.reading.glyphs import letter_in
from chasles.reading.letter_table import BadNotation, LetterTable, require
from chasles.reading.lexemes import BadPage
from chasles.reading.one_meaning import one_meaning_each
from chasles.reading.page_notation import CONVENTIONS, PageNotation, declared_in, known_words, usual_spellings
from chasles.reading.spellings import Make
from chasles.vocabulary import Identity, Node, Rate, Zero, latex, symbols_of
from chasles.vocabulary.fitting import measured
from chasles.vocabulary.functions import PRINTED, FunctionOf
from chasles.vocabulary.nodes import node_fields
from chasles.vocabulary.notation import Notation

TABLES = ("operators", "symbols", "page", "equations", "section")
PAGE = ("units", "proposed", "assuming", "notation", *CONVENTIONS)
NOTES = ("role", "of", "given", "reading")
ROLES = ("claim", "condition", "law", "definition")
SHORT = {"exp": "rotation_by_vector", "vee": "vect", "abs": "norm", "adjoint": "adjoint_of_motion"}
NOT_PRINTED = (Rate, Identity, Zero)
USUAL = {
    "skew": [
        r"[#]_\times",
        r"[# \times]",
        r"\lfloor # \times \rfloor",
        r"[#]^\times",
        r"#^\times",
        r"#_\times",
        r"#^\wedge",
    ],
    "vee": [r"#^\vee"],
    "quaternion_product": [r"# \otimes #", r"# \circ #"],
    "outer_product": [r"# \otimes #"],
    "exp": [r"\operatorname{Exp}(#)"],
    "quantity": [r"#^\circ"],
}
"""Spellings that a file need not name; those that it names come first."""


def load_notation(source: str | Path | ModuleType | Mapping[str, Any]) -> PageNotation:
    """The notation of a TOML file, of its text, of its tables, or of a Python module.

    Raises `BadNotation`, which says in one line what is wrong and where.
    """
    if isinstance(source, ModuleType):
        return declared_in(source.__name__, one_meaning_each(vars(source).values()))
    if isinstance(source, Path):
        try:
            text = source.read_text(encoding="utf-8")
        except OSError as error:
            raise BadNotation(f"{source}: {error.strerror}") from None
        except UnicodeDecodeError:
            raise BadNotation(f"{source}: it is not UTF-8 text") from None
        try:
            return load_notation(text)
        except BadNotation as error:
            raise BadNotation(f"{source}{_line_of(str(error), text)}: {error}") from None
    try:
        tables = tomllib.loads(source) if isinstance(source, str) else dict(source)
    except tomllib.TOMLDecodeError as error:
        raise BadNotation(f"the notation is no TOML: {error}") from None
    _known(tables, TABLES, "the notation")
    for name, said in tables.items():
        require(said, dict, f"[{name}]")
    return _of_module(tables) if "notation" in tables.get("page", {}) else _Loading(tables).notation


@cache
def usual_names() -> frozenset[str]:
    """The names of functions that no file need name."""
    return frozenset(load_notation("").spellings.names)


def _of_module(tables: Mapping[str, Any]) -> PageNotation:
    """The notation of a Python module, with what the tables say of the page and its equations."""
    page = tables["page"]
    require(page["notation"], str, "[page] notation")
    _known(dict.fromkeys((*tables, *page)), ("page", "equations", "notation", "assuming"), "a file on a module")
    try:
        found = load_notation(import_module(page["notation"]))
    except (ImportError, AttributeError, TypeError, ValueError):
        raise BadNotation(f"[page] notation: there is no module {page['notation']!r}") from None
    notes = noted(tables.get("equations", {}), "[equations] ")
    return replace(found, assuming=_assumed(page), notes=notes)


def _assumed(page: Mapping[str, Any]) -> tuple[str, ...]:
    said = page.get("assuming", [])
    if not isinstance(said, list | tuple) or not all(isinstance(each, str) for each in said):
        raise BadNotation("[page] assuming: expected a list of equations in LaTeX")
    return tuple(said)


def _line_of(message: str, text: str) -> str:
    """Where the text has the entry that the message names, as in ":12"."""
    entry = re.search(r"\[\w+\] '?(.*?)(?:'|:| has| is|$)", message)
    places = [number for number, line in enumerate(text.splitlines(), 1) if entry and entry[1] in line]
    return f":{places[-1]}" if entry and places else ""


def _known(given: Mapping[str, Any], names: Sequence[str], where: str) -> None:
    for name in given:
        if name not in names:
            raise BadNotation(f"{where} has no {name!r}{nearest(name, list(names))}: it takes {', '.join(names)}")


def _alternatives(letters: str) -> list[str]:
    """The letters between bars that stand in no braces."""
    found, depth = [""], 0
    for mark in letters:
        depth += (mark == "{") - (mark == "}")
        if mark == "|" and not depth and not found[-1].endswith("\\"):
            found.append("")
        else:
            found[-1] += mark
    return found if all(found) else [letters]


def noted(said: Mapping[str, Any], where: str) -> dict[str, dict[str, Any]]:
    """What is said of single equations; raises `BadNotation` for what cannot be said of one."""
    for name, note in said.items():
        if not isinstance(note, Mapping):
            raise BadNotation(f"{where}'{name}': expected a table, such as {{ role = 'law' }}")
        _known(note, NOTES, f"{where}'{name}'")
        for key in ("role", "reading", "of"):
            require(note.get(key, ""), str, f"{where}'{name}' {key}")
        _known(dict.fromkeys([note["role"]] if note.get("role") else []), ROLES, f"{where}'{name}' role")
        texts = note.get("given", [])
        if not isinstance(texts, list) or not all(isinstance(each, str) for each in texts):
            raise BadNotation(f"{where}'{name}' given: expected a list of numbers, or of equations in LaTeX")
    return {name: dict(note) for name, note in said.items()}


class _Loading:
    """Reads the tables one after the other."""

    def __init__(self, tables: Mapping[str, Any]) -> None:
        page = tables.get("page", {})
        _known(page, PAGE, "[page]")
        for name in ("units", "proposed", *CONVENTIONS):
            require(page.get(name, False), bool, f"[page] {name}")
        self.notation = PageNotation()
        self.notation.home = _home(tables, bool(page.get("units", False)))
        self.notation.proposed = page.get("proposed", False)
        self.notation.assuming = _assumed(page)
        self.notation.notes = noted(tables.get("equations", {}), "[equations] ")
        self.conventions = {name: bool(page[name]) for name in CONVENTIONS if name in page}
        usual_spellings(self.notation)
        forms: dict[Any, str] = {}
        for name, spelled in (*tables.get("operators", {}).items(), *USUAL.items()):
            self._operator(name, spelled, forms)
        self.notation.forms = Notation(forms)
        sys.modules[self.notation.home].NOTATION = self.notation.forms  # type: ignore[attr-defined]
        for letters, said in tables.get("symbols", {}).items():
            for letter in _alternatives(letters):
                declare_letter(self.notation, self.notation.letters, letter, said)
        for name, section in tables.get("section", {}).items():
            require(section, dict, f"[section] '{name}'")
            require(section.get("symbols", {}), dict, f"[section] '{name}' symbols")
            table = LetterTable()
            for letters, said in section.get("symbols", {}).items():
                for letter in _alternatives(letters):
                    declare_letter(self.notation, table, letter, said)
            self.notation.sections[name] = table
        for check in self.notation.checks:
            check()
        self.notation.matched.update(dict.fromkeys(self.notation.matched, False))

    def _operator(self, name: str, spelled: Any, forms: dict[Any, str]) -> None:
        """Each spelling of a word; the first is the one in which it is printed."""
        if name == "function":
            require(spelled, dict, "[operators] function")
            for latex, called in spelled.items():
                require(called, str, f"[operators] function '{latex}'")
                self._operator(called, [f"{latex}(#)"], forms)
            return
        every = [spelled] if isinstance(spelled, str) else spelled
        if not isinstance(every, list | tuple) or not every or not all(isinstance(each, str) for each in every):
            raise BadNotation(f"[operators] {name}: expected a spelling such as '\\tilde{{#}}', or a list of them")
        for place, form in enumerate(every):
            if name in ("identity", "zero"):
                self._constant(name, form)
                continue
            kind, make = self._word(name, form) if name != "quantity" else (None, partial(_quantity, form))
            try:
                self.notation.spellings.add(form, make)
            except (Unread, BadPage) as problem:
                raise BadNotation(f"[operators] {name}: {problem}") from None
            if not place and kind is not None and kind not in NOT_PRINTED:
                forms.setdefault(kind, _numbered(form))

    def _constant(self, name: str, form: str) -> None:
        letter = letter_in(form)
        if letter is None:
            raise BadNotation(f"[operators] {name}: {form!r} is no letter")
        digits = [int(each) for each in re.findall(r"\d+", letter.sub)] or [3]
        node = Identity(digits[0], form) if name == "identity" else Zero(digits[0], (digits * 2)[1], form)
        self.notation.letters.add(letter, lambda _: node)
        self.notation.sizes.update(digits)

    def _word(self, name: str, form: str) -> tuple[type[Node] | None, Make]:
        places = form.count("#")
        words = dict(known_words())
        kind = words.get(SHORT.get(name, name))
        if kind is None and name in PRINTED:
            return None, lambda *of: FunctionOf(name, of)
        if kind is None:
            known = sorted({*words, *SHORT, *PRINTED, "identity", "zero", "function", "quantity"})
            raise BadNotation(f"[operators] has no word {name!r}{nearest(name, known)}")
        held = node_fields(cast(Any, kind))
        if len(held) != places:
            raise BadNotation(f"[operators] {name}: expected {len(held)} '#', found {places}")
        taken = {name: value for name, value in self.conventions.items() if name in dir(kind)}
        return kind, partial(cast(Make, kind), **taken)


def _quantity(form: str, of: Node) -> Node:
    """What a sign that is no word makes: a quantity of its own, as large as what it is put on."""
    letter = form.replace("#", f"{latex(of)} ", 1)
    homes = (symbol.home for symbol in symbols_of(of) if symbol.home)
    return own_quantity(letter, measured(of), next(homes, ""))


def _numbered(form: str) -> str:
    """The form with #1 and #2 for its places."""
    places = iter(range(1, 10))
    return re.sub("#", lambda _: f"#{next(places)}", form)


def _home(tables: Mapping[str, Any], units: bool) -> str:
    """A module that stands for the page: the vocabulary asks it for units and for how words are printed."""
    name = f"chasles_page_{sha256(repr(tables).encode()).hexdigest()[:16]}"
    module = ModuleType(name)
    module.UNITS = units  # type: ignore[attr-defined]
    sys.modules[name] = module
    return name
