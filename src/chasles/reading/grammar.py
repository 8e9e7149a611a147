"""The grammar of a printed formula: sides, terms, brackets and bars; a juxtaposition stays a flat row.

It is LALR(1), hence unambiguous, and says nothing of what letters mean.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

from lark import Lark, Transformer
from lark import Token as Terminal
from lark.exceptions import UnexpectedInput, VisitError
from lark.lexer import Lexer

from chasles.reading.atoms import CLOSING, DEEPEST_BRACKET, OPENING, Atom, Atoms, Terms, Unread, in_braces
from chasles.reading.lexemes import Token

GRAMMAR = r"""
chain: terms? (RELATION terms)*
terms: SIGN? row (SIGN row)*
row: (ATOM | bracket | INFIX)+
bracket: OPEN (terms (COMMA terms)*)? CLOSE
%declare RELATION SIGN INFIX ATOM OPEN CLOSE COMMA
"""
WITHOUT_SCRIPTS = ("OPEN", "SIGN", "INFIX", "RELATION", "COMMA")
TRANSPOSED = (["T"], [r"\top"], ["*"], [r"\dagger"])
NAMING = (r"\boxplus", r"\boxminus", r"\oplus", r"\ominus", r"\otimes", r"\odot", r"\circ", r"\star")
"""Signs of operations that may stand before their operands, too."""


@dataclass(frozen=True, slots=True)
class Chain:
    """Sides and the relations between them; the first side is None where the print continues a line before."""

    sides: tuple[Terms | None, ...]
    relations: tuple[Token, ...]


class _Prepared(Lexer):
    """Terminals as they come: what is printed has been split before."""

    def __init__(self, lexer_conf: Any) -> None:
        pass

    def lex(self, lexer_state: Any, parser_state: Any = None) -> Iterator[Terminal]:
        return iter(lexer_state)


class _Built(Transformer[Any, Any]):
    """The tree of lark as rows of atoms."""

    def chain(self, parts: list[Any]) -> Chain:
        sides: list[Terms | None] = [part for part in parts if isinstance(part, Terms)]
        relations = tuple(part.value.place for part in parts if isinstance(part, Terminal))
        return Chain((*([None] if len(sides) == len(relations) else []), *sides), relations)

    def terms(self, parts: list[Any]) -> Terms:
        signs = [] if isinstance(parts[0], Terminal) else [""]
        signs += [part.value.text for part in parts if isinstance(part, Terminal)]
        signs[0] = signs[0].replace("+", "")
        return Terms(tuple(signs), tuple(part for part in parts if isinstance(part, tuple)))

    def row(self, parts: list[Any]) -> Atoms:
        pieces: list[Atom] = []
        left: Atom | None = None
        for part in (part.value if isinstance(part, Terminal) else part for part in parts):
            if part.kind == "GROUP" and not part.arguments[0]:
                left = part
                continue
            before = (left.sub or (), left.sups[0] if left.sups else ()) if left else part.before
            pieces.append(part if part.kind == "INFIX" else replace(part, before=before))
            left = None
        if not pieces:
            raise Unread("scripts are put on nothing", left.place if left else None)
        return tuple(pieces)

    def bracket(self, parts: list[Any]) -> Atom:
        opening, *inside, closing = parts
        text = opening.value.text + closing.value.text
        held = tuple(part for part in inside if isinstance(part, Terms))
        found: Atom = closing.value
        return replace(found, kind="BRACKET", text=text, place=opening.value.place, inside=held)


def terms_in(atom: Atom) -> Iterator[Terms]:
    """What brackets, fractions, roots, braces and matrices hold, and an exponent of e."""
    yield from atom.inside
    held = list(atom.arguments) if atom.kind in ("COMMAND_OF_TWO", "GROUP") or atom.text == r"\sqrt" else []
    held += [cell for row in atom.rows for cell in row]
    held += [sup for sup in atom.sups if atom.text == "e" and [each.text for each in sup] not in TRANSPOSED]
    for atoms in held:
        with suppress(Unread):
            yield from (side for side in (formula(atoms).sides if atoms else ()) if side is not None)


PARSER = Lark(GRAMMAR, parser="lalr", lexer=_Prepared, start="chain")
BUILT = _Built()


@lru_cache(maxsize=4096)
def formula(atoms: Atoms) -> Chain:
    """The chain of relations, or the one expression, that the atoms make; raises `Unread` where they make none."""
    try:
        return BUILT.transform(PARSER.parse(_terminals(atoms)))  # type: ignore[no-any-return]
    except VisitError as error:
        raise error.orig_exc from None
    except UnexpectedInput as error:
        found = getattr(getattr(error, "token", None), "value", None)
        if not isinstance(found, Atom):
            raise _unfinished(atoms) from None
        raise Unread(f"{found.place.text} is not expected here", found.place) from None


def _terminals(atoms: Atoms) -> list[Terminal]:
    """The terminals of the grammar; a bar that says where something is taken is a script of what stands before it."""
    found: list[Terminal] = []
    open_bars = [""]
    atoms = _with_events(atoms)
    for place, atom in enumerate(atoms):
        kind, text = atom.kind, atom.text
        is_behind = bool(found) and found[-1].type not in WITHOUT_SCRIPTS
        if text == "|" and open_bars[-1] != "|" and is_behind and atom.sub is not None:
            before = found[-1].value
            found[-1] = Terminal(found[-1].type, replace(before, sups=(*before.sups, (atom,))))
            continue
        if kind == "BAR":
            is_closed = open_bars[-1] == text or _is_closed(atoms[place + 1 :], text)
            kind = "OPEN" if not is_behind else "CLOSE" if open_bars[-1] == text else "OPEN" if is_closed else "INFIX"
            atom = replace(atom, kind="INFIX") if kind == "INFIX" else atom  # noqa: PLW2901
        if kind == "LAYOUT" or (kind in WITHOUT_SCRIPTS and atom.is_marked):
            raise Unread(f"{text} is not expected here", atom.place)
        if text == r"\sqrt" and len(atom.arguments) > 1:
            raise Unread("only square roots are known", atom.place)
        if kind == "OPEN":
            open_bars.append(text)
            if len(open_bars) > DEEPEST_BRACKET:
                raise Unread(f"brackets nested more than {DEEPEST_BRACKET} deep", atom.place)
        elif kind == "CLOSE" and len(open_bars) > 1:
            open_bars.pop()
        found.append(Terminal(kind if kind in (*WITHOUT_SCRIPTS, "CLOSE") else "ATOM", atom))
    return found


def _with_events(atoms: Atoms) -> Atoms:
    r"""The atoms with what is said of an event as one, P(X = 1), p(x | y), and a set: \{x | x > 0\}.

    So is a sign that stands before brackets as a function does: \boxplus(x, y).
    """
    found: list[Atom] = []
    place = 0
    while place < len(atoms):
        atom, end = atoms[place], closing(atoms, place)
        is_behind = bool(found) and found[-1].kind in ("LETTER", "COMMAND", "EVENT") and not found[-1].sups
        is_named = (
            place > 0 and atoms[place - 1].text in NAMING and (len(found) < 2 or found[-2].kind in WITHOUT_SCRIPTS)
        )
        says = is_named or ((is_behind or atom.text == r"\{") and _says_event(atoms[place + 1 : end]))
        if atom.kind == "OPEN" and end and says:
            name, last = found[-1:] * (is_behind or is_named), atoms[end]
            del found[len(found) - len(name) :]
            inside = (*name, *atoms[place:end], last.bare)
            found.append(replace(last, kind="EVENT", text=in_braces(inside), place=inside[0].place))
            place = end
        else:
            found.append(atom)
        place += 1
    return tuple(found)


def closing(atoms: Sequence[Atom], start: int = 0) -> int:
    """Where the bracket that opens there is closed; 0 where it is not."""
    depth = 0
    for place in range(start, len(atoms)):
        depth += (atoms[place].text in OPENING) - (atoms[place].text in CLOSING)
        if depth <= 0:
            return place if place > start else 0
    return 0


def _says_event(inside: Atoms) -> bool:
    """Whether a relation stands there, or one stroke that says under which condition."""
    texts = [atom.text for atom in inside]
    return r"\mid" in texts or texts.count("|") == 1 or any(atom.kind == "RELATION" for atom in inside)


def _is_closed(behind: Atoms, bar: str) -> bool:
    """Whether another such bar follows before the bracket around it closes: the bar of p(x | y) stands alone."""
    depth = 0
    for atom in behind:
        depth += (atom.text in OPENING) - (atom.text in CLOSING)
        if depth < 0 or atom.text == bar or atom.kind == "RELATION":
            return depth >= 0 and atom.text == bar
    return False


def _unfinished(atoms: Atoms) -> Unread:
    """What is missing at the end: a bracket that closes, or anything behind a sign."""
    open_ones: list[Atom] = []
    for atom in atoms:
        if atom.text in OPENING:
            open_ones.append(atom)
        elif atom.text in CLOSING and open_ones:
            open_ones.pop()
    if open_ones:
        return Unread(f"{open_ones[-1].text} is not closed", open_ones[-1].place)
    return Unread("something is missing at the end", atoms[-1].place if atoms else None)
