"""The grammar of a printed formula: brackets, scripts, accents and fractions; a juxtaposition stays a flat row.

It is LALR(1), hence unambiguous, and says nothing of what letters mean: scripts and what is accented stay tokens.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

from lark import Lark, Transformer
from lark import Token as Terminal
from lark.exceptions import UnexpectedInput, VisitError
from lark.lexer import Lexer

from chasles.reading.grouping import CLOSING, OPENING, Grid, Tokens, Unread, grouped
from chasles.reading.lexemes import Token

GRAMMAR = r"""
chain: terms? (RELATION terms)*
terms: sign? row (sign row)*
sign: SIGN
row: (atom | INFIX)+
atom: nucleus script*
script: SUB ARGUMENT | SUP ARGUMENT | PRIME
nucleus: LETTER | NUMBER | GRID | GROUP | bracket | COMMAND ARGUMENT | COMMAND_OF_TWO ARGUMENT ARGUMENT
bracket: OPEN (terms (COMMA terms)*)? CLOSE
%declare RELATION SIGN INFIX SUB SUP PRIME LETTER NUMBER GRID GROUP ARGUMENT COMMAND COMMAND_OF_TWO OPEN CLOSE COMMA
"""


@dataclass(frozen=True, slots=True)
class Atom:
    """What scripts are put on, and its scripts; `kind` is the terminal that it is made of, or "BRACKET".

    `before` are a subscript and a superscript that are printed at its left.
    """

    kind: str
    text: str
    place: Token
    arguments: tuple[Tokens, ...] = ()
    inside: tuple[Terms, ...] = ()
    grid: Grid | None = None
    sub: Tokens | None = None
    primes: int = 0
    sups: tuple[Tokens, ...] = ()
    before: tuple[Tokens, Tokens] = ((), ())

    @property
    def is_marked(self) -> bool:
        """Whether it has scripts."""
        return bool(self.sub or self.primes or self.sups)


@dataclass(frozen=True, slots=True)
class FlatRow:
    """Atoms, and tokens for infix operators, as they stand side by side."""

    pieces: tuple[Atom | Token, ...]


@dataclass(frozen=True, slots=True)
class Terms:
    """Rows with their signs, "+" or "-"; the first sign is "" where none is printed."""

    signs: tuple[str, ...]
    rows: tuple[FlatRow, ...]


@dataclass(frozen=True, slots=True)
class Chain:
    """Sides and the relations between them; the first side is None where the print continues a line before."""

    sides: tuple[Terms | None, ...]
    relations: tuple[Token, ...]


class _Prepared(Lexer):
    """Terminals as they come: the tokens have been grouped before."""

    def __init__(self, lexer_conf: Any) -> None:
        pass

    def lex(self, lexer_state: Any, parser_state: Any = None) -> Iterator[Terminal]:
        return iter(lexer_state)


class _Built(Transformer[Any, Any]):
    """The tree of lark as rows of atoms."""

    def chain(self, parts: list[Any]) -> Chain:
        sides: list[Terms | None] = [part for part in parts if isinstance(part, Terms)]
        relations = tuple(part.value for part in parts if isinstance(part, Terminal))
        return Chain((*([None] if len(sides) == len(relations) else []), *sides), relations)

    def terms(self, parts: list[Any]) -> Terms:
        signs = [] if isinstance(parts[0], str) else [""]
        signs += [part for part in parts if isinstance(part, str)]
        signs[0] = signs[0].replace("+", "")
        return Terms(tuple(signs), tuple(part for part in parts if isinstance(part, FlatRow)))

    def sign(self, parts: list[Any]) -> str:
        return str(parts[0].value.text)

    def row(self, parts: list[Any]) -> FlatRow:
        pieces: list[Atom | Token] = []
        left: Atom | None = None
        for part in parts:
            if isinstance(part, Atom) and part.kind == "GROUP" and not part.arguments[0]:
                left = part
                continue
            if left is not None and isinstance(part, Atom):
                before = left.sub or (), left.sups[0] if left.sups else ()
                part = replace(part, before=before)  # noqa: PLW2901
            pieces.append(part.value if isinstance(part, Terminal) else part)
            left = None
        if not pieces:
            raise Unread("scripts are put on nothing", parts[0].place)
        return FlatRow(tuple(pieces))

    def bracket(self, parts: list[Any]) -> Atom:
        opening, *inside, closing = parts
        inside = [part for part in inside if isinstance(part, Terms)]
        return Atom("BRACKET", opening.value.text + closing.value.text, opening.value, inside=tuple(inside))

    def nucleus(self, parts: list[Any]) -> Atom:
        first = parts[0]
        if isinstance(first, Atom):
            return first
        if isinstance(first.value, Grid):
            return Atom("GRID", first.value.name, first.value.place, grid=first.value)
        if first.type == "GROUP":
            return Atom("GROUP", "", first.value[0], (first.value[1:-1],))
        return Atom(str(first.type), first.value.text, first.value, tuple(part.value for part in parts[1:]))

    def script(self, parts: list[Any]) -> tuple[str, Any]:
        return str(parts[0].type), parts[-1].value

    def atom(self, parts: list[Any]) -> Atom:
        nucleus, *scripts = parts
        subs = [value for kind, value in scripts if kind == "SUB"]
        primes = sum(kind == "PRIME" for kind, _ in scripts)
        sups = []
        for sup in (value for kind, value in scripts if kind == "SUP"):
            marks = next((k for k, token in enumerate(sup) if token.text not in ("'", "{", "}")), len(sup))
            marks = marks if any(token.text == "'" for token in sup[:marks]) else 0
            primes += sum(token.text == "'" for token in sup[:marks])
            sups += [sup[marks:]] if sup[marks:] else []
        if len(subs) > 1:
            raise Unread("two subscripts stand on one letter", subs[1][0] if subs[1] else nucleus.place)
        made = nucleus.kind, nucleus.text, nucleus.place, nucleus.arguments, nucleus.inside, nucleus.grid
        return Atom(*made, subs[0] if subs else None, primes, tuple(sups))


def terms_in(atom: Atom) -> Iterator[Terms]:
    """What brackets, fractions, roots, braces and matrices hold, and an exponent of e."""
    yield from atom.inside
    held = list(atom.arguments) if atom.kind in ("COMMAND_OF_TWO", "GROUP") or atom.text == r"\sqrt" else []
    held += [cell for row in atom.grid.rows for cell in row] if atom.grid else []
    held += [sup for sup in atom.sups if atom.text == "e" and [each.text for each in sup] not in TRANSPOSED]
    for tokens in held:
        with suppress(Unread):
            yield from (side for side in (formula(tokens).sides if tokens else ()) if side is not None)


TRANSPOSED = (["T"], [r"\top"], ["*"], [r"\dagger"])
PARSER = Lark(GRAMMAR, parser="lalr", lexer=_Prepared, start="chain")
BUILT = _Built()


@lru_cache(maxsize=4096)
def formula(tokens: Tokens) -> Chain:
    """The chain of relations, or the one expression, that the tokens make; raises `Unread` where they make none."""
    try:
        return BUILT.transform(PARSER.parse(grouped(tokens)))  # type: ignore[no-any-return]
    except VisitError as error:
        raise error.orig_exc from None
    except UnexpectedInput as error:
        found = getattr(error, "token", None)
        value = found.value if found is not None else None
        first = value[:1] if isinstance(value, tuple) and not isinstance(value, Token) else (value,)
        place = first[0] if first and isinstance(first[0], Token) else getattr(value, "place", None)
        if place is None:
            raise _unfinished(tokens) from None
        raise Unread(f"{place.text} is not expected here", place) from None


def _unfinished(tokens: Tokens) -> Unread:
    """What is missing at the end: a bracket that closes, or anything behind a sign."""
    open_ones: list[Token] = []
    for token in tokens:
        if token.text in OPENING:
            open_ones.append(token)
        elif token.text in CLOSING and open_ones:
            open_ones.pop()
    if open_ones:
        return Unread(f"{open_ones[-1].text} is not closed", open_ones[-1])
    return Unread("something is missing at the end", tokens[-1] if tokens else None)
