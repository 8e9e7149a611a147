"""What is printed, as a tree: letters, numbers, signs and commands, each with its arguments, scripts and place."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field, replace
from functools import lru_cache

from chasles.reading import commands
from chasles.reading.lexemes import Token, cut

TYPEFACES = frozenset(commands.STYLES)
BOLD = {r"\boldsymbol": r"\mathbf"}
RELATIONS = {sign: sign for sign in commands.RELATIONS} | dict.fromkeys(
    (":=", "=:", r"\triangleq", r"\doteq"), r"\equiv"
)
"""Relations, and the sign that each is in words; of those that have none, the sign itself."""
SIGNS = ("+", "-", r"\pm", r"\mp")
INFIXES = (commands.OPERATORS | {"*", ":", r"\ominus", r"\boxminus", r"\vee"}) - {*SIGNS}
OPENING = ("(", "[", r"\{", r"\langle", r"\lfloor", r"\lceil", r"\llbracket")
CLOSING = (")", "]", r"\}", r"\rangle", r"\rfloor", r"\rceil", r"\rrbracket")
DEEPEST_BRACKET = 40
ROW_END = "\\\\"
LAYOUT = ("&", ROW_END, r"\quad")
BRACED = re.compile(r"(?:(?<=\s)|^)\{ ([^\s{}]+) \}(?=\s|$)")
NAME = re.compile(r"\\(?:operatorname|text)\{(.*)\}$")
KINDS = {
    **dict.fromkeys(INFIXES, "INFIX"), **dict.fromkeys(SIGNS, "SIGN"), **dict.fromkeys(RELATIONS, "RELATION"),
    **dict.fromkeys(OPENING, "OPEN"), **dict.fromkeys(CLOSING, "CLOSE"), **dict.fromkeys(("|", r"\|"), "BAR"),
    **dict.fromkeys((",", ";"), "COMMA"), **dict.fromkeys(LAYOUT, "LAYOUT"),
}  # fmt: skip
"""The kinds of what is no letter and no number."""


class Unread(ValueError):
    """What is no formula, or what the notation gives no meaning; `place` is where it shows."""

    def __init__(self, why: str, place: Token | None = None) -> None:
        super().__init__(why)
        self.place = place


@dataclass(frozen=True, slots=True)
class Terms:
    """Rows of atoms side by side with their signs, "+" or "-"; the first sign is "" where none is printed."""

    signs: tuple[str, ...]
    rows: tuple[Atoms, ...]


@dataclass(frozen=True, slots=True)
class Atom:
    """What scripts are put on, and its scripts; the nuclei of commands are their arguments.

    `kind` is LETTER, NUMBER, COMMAND (with one argument), COMMAND_OF_TWO, GROUP (of several things in braces), GRID (an
    environment: its name is the text), or one of `KINDS`. The grammar makes a BRACKET of what stands `inside` one, and
    an EVENT of what is said of a relation: P(X = 1).
    `before` are a subscript and a superscript that are printed at its left.
    """

    kind: str
    text: str
    place: Token
    arguments: tuple[Atoms, ...] = ()
    inside: tuple[Terms, ...] = ()
    sub: Atoms | None = None
    primes: int = 0
    sups: tuple[Atoms, ...] = ()
    before: tuple[Atoms, Atoms] = ((), ())
    _hash: int = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        said = (self.kind, self.text, self.place, self.arguments, self.inside, self.sub, self.primes, self.sups)
        object.__setattr__(self, "_hash", hash((*said, self.before)))

    def __hash__(self) -> int:
        return self._hash

    @property
    def is_marked(self) -> bool:
        """Whether it has scripts."""
        return bool(self.sub or self.primes or self.sups)

    @property
    def bare(self) -> Atom:
        """The same without its scripts."""
        return replace(self, sub=None, primes=0, sups=())

    @property
    def rows(self) -> tuple[tuple[Atoms, ...], ...]:
        """The cells of an environment."""
        return _cells(self.arguments[0]) if self.kind == "GRID" else ()


Atoms = tuple[Atom, ...]


@lru_cache(maxsize=4096)
def _cells(inside: Atoms) -> tuple[tuple[Atoms, ...], ...]:
    return tuple(tuple(tuple(cell) for cell in lines_of(row, ("&",))) for row in lines_of(inside, (ROW_END,)))


def single(token: Token) -> Atom:
    """What the token is by itself."""
    text = token.text
    is_number = text[:1].isdigit() or (text[:1] == "." and len(text) > 1)
    return Atom(KINDS.get(text, "NUMBER" if is_number else "LETTER"), text, token)


def lines_of(atoms: Iterable[Atom], marks: tuple[str, ...]) -> list[list[Atom]]:
    """The atoms cut at these marks, outside of all brackets."""
    return cut(atoms, marks, OPENING, CLOSING)


def everywhere(atoms: Atoms, change: Callable[[Atom], Atom]) -> Atoms:
    """The atoms with each changed, also in arguments and scripts."""

    def inside(held: tuple[Atoms, ...]) -> tuple[Atoms, ...]:
        return tuple(everywhere(each, change) for each in held)

    return tuple(
        change(replace(atom, arguments=inside(atom.arguments), sups=inside(atom.sups),
                       sub=None if atom.sub is None else everywhere(atom.sub, change)))
        for atom in atoms
    )  # fmt: skip


def marks_of(atoms: Iterable[Atom]) -> Iterator[str]:
    """Control words, letters, numbers and signs in their order: arguments and scripts always stand in braces."""
    for atom in atoms:
        match atom.kind:
            case "GROUP":
                yield from _braced(atom.arguments[0])
            case "GRID":
                yield from (rf"\begin{{{atom.text}}}", *marks_of(atom.arguments[0]), rf"\end{{{atom.text}}}")
            case _:
                yield from (atom.text, *(mark for argument in atom.arguments for mark in _braced(argument)))
        if atom.sub is not None:
            yield from ("_", *_braced(atom.sub))
        yield from "'" * atom.primes
        for sup in atom.sups:
            yield from marks_of(sup) if [each.text for each in sup] == ["|"] else ("^", *_braced(sup))


def _braced(atoms: Atoms) -> tuple[str, ...]:
    return ("{", *marks_of(atoms), "}")


def in_braces(atoms: Iterable[Atom]) -> str:
    """The atoms as one text: bold in one way, upright names as one word."""
    return " ".join(NAME.sub(lambda name: name[1].replace(" ", "~"), BOLD.get(text, text)) for text in marks_of(atoms))


def said_of(atoms: Iterable[Atom]) -> str:
    """The same without braces around all of it, or one letter or sign alone: others tell x^{2y} from x^2 y."""
    atoms = tuple(atoms)
    while len(atoms) == 1 and atoms[0].kind == "GROUP" and not atoms[0].is_marked:
        (atoms,) = atoms[0].arguments
    return BRACED.sub(r"\1", in_braces(atoms))
