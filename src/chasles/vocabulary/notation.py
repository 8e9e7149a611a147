"""How a chapter prints words in LaTeX: a hat or brackets for a cross-product matrix, a T or a top for a transpose."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields
from inspect import isclass
from typing import Any, get_type_hints

from chasles.vocabulary.arguments import WrongArgument
from chasles.vocabulary.letters import Identity, Symbol, Zero
from chasles.vocabulary.nodes import Node, node_fields
from chasles.vocabulary.pieces import Piece, Precedence, Style
from chasles.vocabulary.tree import walk

JUXTAPOSED = re.compile(r"#1\s*#2")
PLACE = re.compile(r"#(\d)")
POSTFIX = re.compile(r"#1\s*\^\s*(?:\{(.*)\}|(\\?\w+(?:\{\w+\})?))$")
ENCLOSED = re.compile(r"(?:[{\[(|,]|\\left\S|\\langle)\s*#(\d)\s*(?=[}\]),|]|\\\||\\right|\\rangle)")
EXAMPLE = '{CPM: r"[#1]_\\times", Transpose: r"#1^\\top"}'
FORMS = f"`{EXAMPLE}`, where #1 is the first part of the word"


class Notation:
    """What words are printed as: `forms` maps a word to a form in which #1, #2 stand for its parts.

    A word is named by its class, by the function that writes it (`CPM`, `tr`), or, a function of a scalar, by its
    name ("sin"). With `round_brackets` brackets within brackets are round, but where the author chose others; with
    `bare_arguments` a function of a letter or of a fraction has none; if it is False, one of a letter has them, too.
    Raises `WrongArgument` for a form that leaves out a part or has none that the word has.
    """

    def __init__(self, forms: Mapping[Any, str], *, round_brackets: bool = False, bare_arguments: Any = None) -> None:
        self.round_brackets, self.bare_arguments = round_brackets, bare_arguments
        if not isinstance(forms, Mapping):
            raise WrongArgument(f"Notation takes a table of words and forms: {FORMS}")
        self.all_forms = {_key(word): form for word, form in forms.items()}
        named = _named() if self.all_forms else {}
        for word, form in self.all_forms.items():
            if isinstance(word, str) and word not in named:
                raise WrongArgument(f"Notation: {word!r} is no function of a scalar: name a word itself, as in {FORMS}")
            name, count = (word, named[word]) if isinstance(word, str) else (word.__name__, len(node_fields(word)))
            places = set(map(int, PLACE.findall(form))) if isinstance(form, str) else None
            if places is None or (count and places != set(range(1, count + 1))):
                raise WrongArgument(f"Notation: {form!r} for {name} has to name its {count} part(s): {FORMS}")

    def form(self, node: Node) -> str | None:
        """The form in which the chapter prints the word; None where it is printed as usual."""
        return self.all_forms.get(type(node)) or self.all_forms.get(getattr(node, "function", ""))

    def spelled(self, node: Node, style: Style, spell: Callable[[Node], Piece]) -> Piece | None:
        """The word in the chapter's form; None where it has no other than the usual one."""
        form = self.form(node)
        if form is None:
            return None
        if isinstance(node, Identity | Zero):
            usual = any(each.name == "letter" and each.default == node.letter for each in fields(node))
            return Piece(form.replace("#1", str(node.shape[0])), Precedence.ATOM) if usual else None
        parts = node.below
        if len(parts) < max(map(int, PLACE.findall(form)), default=0):
            return None
        infix = len(parts) > 1 and len(ENCLOSED.findall(form)) < len(parts)
        enclosed = {int(number) - 1 for number in ENCLOSED.findall(form)}
        least = Precedence.PRODUCT if infix else Precedence.ATOM
        beside = JUXTAPOSED.fullmatch(form) is not None
        texts, depth = [], 0
        for place, part in enumerate(parts):
            piece = spell(part)
            chained = infix and place == 0 and type(part) is type(node)
            if place not in enclosed and not chained:
                piece = piece.at_least(Precedence.POWER if beside and place else least, style)
            texts.append(piece.text)
            depth = max(depth, piece.depth)
        if power := POSTFIX.match(form):
            return Piece(style.power(texts[0], power[1] or power[2]), Precedence.POWER, depth)
        text = PLACE.sub(lambda found: texts[int(found[1]) - 1], form)
        bracketed = any(bracket in form for bracket in "([")
        level = Precedence.PRODUCT if beside else Precedence.DOT if infix else Precedence.ATOM
        return Piece(text, level, depth + bracketed)


BOOK = Notation({})
"""Each word as usual."""


def notation_of(node: Node) -> Notation:
    """The `NOTATION` of the chapter that declares the first symbol: in its module or in a package around it."""
    for part in walk(node):
        if isinstance(part, Symbol) and part.home:
            for module in _around(part.home):
                found = getattr(sys.modules.get(module), "NOTATION", None)
                if isinstance(found, Notation):
                    return found
                if isinstance(found, Mapping):
                    raise TypeError(f"NOTATION of {module} is {found!r}: write Notation({EXAMPLE})")
            return BOOK
    return BOOK


def _named() -> dict[str, int]:
    """The names of functions and of defined words, with how many parts they have; 0 for any number."""
    from chasles.vocabulary.functions import PRINTED  # of no use where words are printed as usual
    from chasles.vocabulary.shorthand import Shorthand

    defined, waiting = dict[str, int](), [Shorthand]
    while waiting:
        kind: Any = waiting.pop()
        waiting += kind.__subclasses__()
        if isinstance(name := getattr(kind, "function", None), str):
            defined[name] = len(node_fields(kind))
    return {**defined, **dict.fromkeys(("sin", "cos", *PRINTED), 1), "atan2": 2, "max": 0, "min": 0}


def _around(module: str) -> Iterator[str]:
    while module:
        yield module
        module = module.rpartition(".")[0]


def _key(word: Any) -> Any:
    if isinstance(word, str) or (isclass(word) and issubclass(word, Node)):
        return word
    made = get_type_hints(word).get("return") if callable(word) else None
    if isclass(made) and issubclass(made, Node) and made is not Node:
        return made
    raise WrongArgument(f"Notation: {word!r} is no word: {FORMS}")
