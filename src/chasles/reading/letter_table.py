"""Letters with their accents and scripts, and the table in which a notation says what they are."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from functools import lru_cache

from chasles.reading.commands import MARKS
from chasles.reading.grammar import Atom, Chain, FlatRow, Terms, formula
from chasles.reading.grouping import TYPEFACES, Tokens, Unread
from chasles.reading.tokens import Token, tokens
from chasles.vocabulary import Node

__all__ = ["Glyph", "LetterTable", "Meaning", "letter_in", "letter_of", "only_atom", "said_of", "text_of"]

BOLD = {r"\boldsymbol": r"\mathbf"}
NAME = re.compile(r"\\(?:operatorname|text)\{(.*)\}$")
MAY_LOSE_BOLD = re.compile(r"\\[A-Za-z]+$")
Meaning = Callable[["Glyph"], Node]


@dataclass(frozen=True, slots=True)
class Glyph:
    """A letter with its accents from the inside out, its subscript, primes and superscripts, each as one text.

    `before` are a subscript and a superscript at its left.
    """

    base: str
    accents: tuple[str, ...] = ()
    sub: str = ""
    primes: int = 0
    sups: tuple[str, ...] = ()
    before: tuple[str, str] = ("", "")
    place: Token | None = field(default=None, compare=False)

    @property
    def loose(self) -> Glyph:
        """The same without its typefaces."""
        return replace(self, base=_unstyled(self.base), sub=_unstyled(self.sub), sups=tuple(map(_unstyled, self.sups)))


def _unstyled(text: str) -> str:
    return " ".join(word for word in text.split() if word not in TYPEFACES)


def said_of(marks: Tokens) -> str:
    """The tokens as one text: without braces, bold in one way, upright names as one word."""
    words = (NAME.sub(r"\1", BOLD.get(token.text, token.text)) for token in marks)
    return " ".join(word for word in words if word not in ("{", "}"))


def only_atom(chain: Chain) -> Atom | None:
    """The atom, where the chain is nothing else."""
    if chain.relations or chain.sides[0] is None or chain.sides[0].signs != ("",):
        return None
    pieces = chain.sides[0].rows[0].pieces
    return pieces[0] if len(pieces) == 1 and isinstance(pieces[0], Atom) else None


def _text(atom: Atom) -> str:
    """What scripts are put on, as one text."""
    match atom.kind:
        case "BRACKET":
            inside = " , ".join(text_of(terms) for terms in atom.inside)
            half = len(atom.text) // 2
            return f"{atom.text[:half]} {inside} {atom.text[half:]}"
        case "GROUP":
            return said_of(atom.arguments[0])
        case "COMMAND" | "COMMAND_OF_TWO":
            return " ".join((BOLD.get(atom.text, atom.text), *(said_of(each) for each in atom.arguments)))
        case "GRID":
            return r"\begin"
        case _:
            return NAME.sub(r"\1", atom.text)


def text_of(terms: Terms) -> str:
    """The terms as one text."""
    return " ".join(f"{sign} {_text_of_row(row)}" for sign, row in zip(terms.signs, terms.rows, strict=True)).strip()


def _text_of_row(row: FlatRow) -> str:
    return " ".join(piece.text if isinstance(piece, Token) else _whole(piece) for piece in row.pieces)


def _whole(atom: Atom) -> str:
    sub = f" _ {said_of(atom.sub)}" if atom.sub else ""
    return _text(atom) + sub + " '" * atom.primes + "".join(f" ^ {said_of(sup)}" for sup in atom.sups)


@lru_cache(maxsize=4096)
def letter_of(atom: Atom) -> Glyph:
    """The letter that the atom is, styles and accents in whatever order the author put them."""
    accents: list[str] = []
    styles: list[str] = []
    sub, primes, sups, place = "", 0, list[str](), atom.place
    before = ("", "")
    while True:
        if atom.sub:
            sub = " ".join(filter(None, (said_of(atom.sub), sub)))
        primes += atom.primes
        before = (said_of(atom.before[0]), said_of(atom.before[1])) if any(atom.before) else before
        sups = [*map(said_of, atom.sups), *sups]
        inner = None
        if atom.kind == "GROUP" or atom.text in TYPEFACES or atom.text in MARKS:
            try:
                inner = only_atom(formula(atom.arguments[0])) if atom.arguments[0] else None
            except Unread:
                inner = None
        if inner is None:
            break
        if atom.text in TYPEFACES:
            styles.append(BOLD.get(atom.text, atom.text))
        elif atom.kind == "COMMAND":
            accents.insert(0, {r"\widetilde": r"\tilde", r"\widehat": r"\hat"}.get(atom.text, atom.text))
        atom = inner
    base = " ".join((*dict.fromkeys(styles), _text(atom)))
    return Glyph(base, tuple(accents), sub, primes, tuple(sups), before, place)


class LetterTable:
    """What letters mean: exact ones, and patterns of subscripts and superscripts."""

    def __init__(self) -> None:
        self.exact: dict[Glyph, list[Meaning]] = {}
        self.loose: dict[Glyph, list[Meaning]] = {}
        self.patterns: list[tuple[Glyph, tuple[re.Pattern[str], ...], Meaning]] = []
        self.behind: LetterTable | None = None

    def before(self, other: LetterTable) -> LetterTable:
        """The letters of this table, and those of another that this one does not have."""
        self.behind = other
        return self

    def add(self, letter: Glyph, meaning: Meaning) -> None:
        """Say what a letter means, beside what it may mean already."""
        if any("#" in part or "|" in part for part in (letter.sub, *letter.sups, *letter.before)):
            bare = replace(letter, sub="", sups=(), before=("", ""), place=None)
            self.patterns.append((bare, tuple(map(_pattern, _marks(letter))), meaning))
            return
        letter = replace(letter, sups=_joined(" ".join(letter.sups).split()))
        self.exact.setdefault(letter, []).append(meaning)
        self.loose.setdefault(letter.loose, []).append(meaning)

    def meanings(self, letter: Glyph) -> Iterator[tuple[Node, Glyph]]:
        """What the letter may be, most of its marks taken into the symbol first, and the marks left over."""
        found = list(self._found(letter, self.exact))
        if not found and MAY_LOSE_BOLD.search(letter.base):
            found = list(self._found(letter.loose, self.loose))
        yield from found or (self.behind.meanings(letter) if self.behind else ())

    def _found(self, letter: Glyph, table: dict[Glyph, list[Meaning]]) -> Iterator[tuple[Node, Glyph]]:
        for taken, rest in _divided(letter):
            for meaning in table.get(taken, ()):
                yield meaning(taken), rest
            if taken in table or table is not self.exact:
                continue
            bare = replace(taken, sub="", sups=(), before=("", ""))
            for base, patterns, meaning in self.patterns:
                pairs = zip(patterns, _marks(taken), strict=True)
                if base == bare and all(pattern.fullmatch(marks) for pattern, marks in pairs):
                    yield meaning(taken), rest


def _divided(letter: Glyph) -> Iterator[tuple[Glyph, Glyph]]:
    """The ways in which marks belong to a symbol, or to what is done to it: most of them to the symbol first."""
    sups = " ".join(letter.sups).split()
    place = letter.place
    for count in range(len(letter.accents), -1, -1):
        for sub in dict.fromkeys((letter.sub, "")):
            for primes in dict.fromkeys((letter.primes, 0)):
                for cut in range(len(sups), -1, -1):
                    own, other = _joined(sups[:cut]), _joined(sups[cut:])
                    taken = Glyph(letter.base, letter.accents[:count], sub, primes, own, letter.before, place)
                    left = "" if sub else letter.sub
                    yield (
                        taken,
                        Glyph(letter.base, letter.accents[count:], left, letter.primes - primes, other, place=place),
                    )


def _marks(letter: Glyph) -> tuple[str, ...]:
    return letter.sub, " ".join(letter.sups), *letter.before


def _joined(words: list[str]) -> tuple[str, ...]:
    return (" ".join(words),) if words else ()


def _pattern(text: str) -> re.Pattern[str]:
    """A pattern of marks: '##' stands for one or more, '#' for one, a|b for either."""
    words = []
    for word in re.sub(r"\s*\|\s*", "|", text.replace("# #", "##")).split():
        if word in ("##", "#"):
            words.append(r"\S+(?: \S+)*" if word == "##" else r"\S+")
        else:
            words.append("(?:" + "|".join(map(re.escape, word.split("|"))) + ")")
    return re.compile(" ".join(words))


def letter_in(text: str) -> Glyph | None:
    """The letter that a notation writes; None where that is several."""
    atom = only_atom(formula(tokens(text)))
    return None if atom is None else letter_of(atom)
