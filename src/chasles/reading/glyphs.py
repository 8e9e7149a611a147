"""Letters with their accents, scripts and arguments."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from itertools import pairwise

from chasles.reading.atoms import BOLD, TYPEFACES, Atom, Atoms, Terms, Unread, in_braces, said_of
from chasles.reading.commands import MARKS
from chasles.reading.grammar import Chain, formula
from chasles.reading.lexemes import Token
from chasles.reading.respelling import atoms_in

_LETTERS = TYPEFACES | MARKS
ARROWS = frozenset({r"\vec", r"\underline", r"\overrightarrow", r"\underrightarrow"})
"""Accents that say that a letter is a vector: they are part of its name, whatever else is put under them."""
OTHER_BRACKETS = ("[]", r"\{\}")
OF_OPERATORS = frozenset((r"\mathbb", r"\mathcal", r"\mathscr", r"\mathrm"))


@dataclass(frozen=True, slots=True)
class Glyph:
    r"""A letter with its accents from the inside out, its subscript, primes and superscripts, each as one text.

    `before` are a subscript and a superscript at its left, `arguments` what brackets behind it hold: \Gamma(\phi).
    """

    base: str
    accents: tuple[str, ...] = ()
    sub: str = ""
    primes: int = 0
    sups: tuple[str, ...] = ()
    before: tuple[str, str] = ("", "")
    arguments: str = ""
    place: Token | None = field(default=None, compare=False)

    @property
    def marks(self) -> int:
        """How many accents, scripts and primes it has."""
        return len(self.accents) + bool(self.sub) + self.primes + len(self.sups)

    @property
    def loose(self) -> Glyph:
        """The same without its typefaces."""
        return replace(self, base=_unstyled(self.base), sub=_unstyled(self.sub), sups=tuple(map(_unstyled, self.sups)))


def _unstyled(text: str) -> str:
    return " ".join(word for word in text.split() if word not in TYPEFACES)


def only_atom(chain: Chain) -> Atom | None:
    """The atom, where the chain is nothing else."""
    if chain.relations or chain.sides[0] is None or chain.sides[0].signs != ("",):
        return None
    pieces = chain.sides[0].rows[0]
    return pieces[0] if len(pieces) == 1 else None


def _inside(chain: Chain, is_accented: bool) -> Atom | None:
    """The letter in an argument: under an accent also one of several letters side by side."""
    side = chain.sides[0]
    row = side.rows[0] if is_accented and side and not chain.relations and side.signs == ("",) else ()
    return only_atom(chain) or joined(row)


def _text(atom: Atom) -> str:
    """What scripts are put on, as one text."""
    if atom.kind == "BRACKET":
        inside = " , ".join(text_of(terms) for terms in atom.inside)
        half = len(atom.text) // 2
        return f"{atom.text[:half]} {inside} {atom.text[half:]}"
    return (said_of if atom.kind in ("GROUP", "COMMAND") else in_braces)((atom.bare,))


def latex_of(atom: Atom) -> str:
    """The atom without its scripts in LaTeX."""
    return in_latex(_text(atom))


def pieces_of(bracket: Atom) -> list[Atom]:
    """All that stands directly between brackets."""
    return [piece for terms in bracket.inside for row in terms.rows for piece in row]


def text_of(terms: Terms) -> str:
    """The terms as one text."""
    return " ".join(f"{sign} {text_of_row(row)}" for sign, row in zip(terms.signs, terms.rows, strict=True)).strip()


def text_of_row(row: Atoms) -> str:
    """The atoms of a row as one text."""
    return " ".join(map(text_of_atom, row))


def text_of_atom(atom: Atom) -> str:
    """The atom with its scripts as one text."""
    left = [f"{sign} {{ {said_of(mark)} }} " for sign, mark in zip("_^", atom.before, strict=True) if mark]
    sub = f" _ {{ {said_of(atom.sub)} }}" if atom.sub else ""
    sups = "".join(f" ^ {{ {said_of(sup)} }}" for sup in atom.sups)
    return "{} " * bool(left) + "".join(left) + _text(atom) + sub + " '" * atom.primes + sups


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
                inner = _inside(formula(atom.arguments[0]), atom.text in MARKS) if atom.arguments[0] else None
            except Unread:
                inner = None
        if inner is None or (atom.kind == "GROUP" and atom.sub and inner.sub):
            break  # a second subscript is put on all that stands in the braces
        if atom.text in TYPEFACES:
            styles.append(BOLD.get(atom.text, atom.text))
        elif atom.kind == "COMMAND":
            accents.insert(0, {r"\widetilde": r"\tilde", r"\widehat": r"\hat"}.get(atom.text, atom.text))
        atom = inner
    base = " ".join((*dict.fromkeys(styles), _text(atom)))
    accents.sort(key=lambda accent: accent not in ARROWS)
    return Glyph(base, tuple(accents), sub, primes, tuple(sups), before, place=place)


def with_arguments(letter: Glyph, bracket: Atom) -> Glyph | None:
    r"""The letter with what brackets behind it hold as its arguments; None for others than round ones.

    What is not round holds the argument of an expectation E[x], or of what is set upright, in script or with double
    strokes: \mathcal{L}\{f\}.
    """
    if not bracket.inside or bracket.text not in ("()", *(OTHER_BRACKETS if is_operator(letter) else ())):
        return None
    return replace(letter, arguments=" , ".join(map(text_of, bracket.inside)))


def is_operator(letter: Glyph) -> bool:
    """Whether other brackets than round ones hold the argument of a letter: of E, of words, and in such typefaces."""
    return (
        letter.base == "E"
        or letter.base.split(" ")[0] in OF_OPERATORS
        or (len(letter.base) > 1 and letter.base.isalpha())
    )


def joined(atoms: Sequence[Atom]) -> Atom | None:
    r"""Letters side by side as one name, as in \Delta t and GM; None where something else is among them."""
    found = [atom for atom in atoms if atom.kind == "LETTER" or atom.text in _LETTERS]
    if len(found) < max(2, len(atoms)) or any(atom.is_marked or atom.text in MARKS for atom in found[:-1]):
        return None
    first, last = found[0], found[-1]
    if last.text in MARKS:  # an accent on the last of them is put on all: \delta\dot\theta
        signs = [atom for atom in found[:-1] if atom.kind == "LETTER"]
        held = ((*signs, *last.arguments[0]),)
        return replace(last, arguments=held, place=first.place) if len(signs) == len(found) - 1 else None
    text = " ".join(map(_text, found))
    return replace(last, kind="LETTER", text=text, place=first.place, arguments=(), before=first.before)


@lru_cache(maxsize=4096)
def letter_in(text: str) -> Glyph | None:
    """The letter that a notation writes, with arguments where it is a function; None where that is several."""
    chain = formula(atoms_in(text))
    if chain.relations or chain.sides[0] is None or chain.sides[0].signs != ("",):
        return None
    *name, last = chain.sides[0].rows[0]
    bracket = last if name and last.kind == "BRACKET" and not last.is_marked else None
    row = name if bracket else [*name, last]
    atom = row[0] if len(row) == 1 else joined(row)
    letter = None if atom is None else letter_of(atom)
    return with_arguments(letter, bracket) if letter and bracket else letter


def spelled(letter: Glyph) -> str:
    """The letter in LaTeX."""
    text = in_latex(letter.base)
    for accent in letter.accents:
        text = f"{accent}{{{text}}}"
    sub = f"_{{{in_latex(letter.sub)}}}" if letter.sub else ""
    sups = "".join(f"^{{{in_latex(sup)}}}" for sup in letter.sups)
    left = "".join(f"{sign}{{{in_latex(mark)}}}" for sign, mark in zip("_^", letter.before, strict=True) if mark)
    arguments = f"({in_latex(letter.arguments)})" if letter.arguments else ""
    return ("{}" + left if left else "") + text + sub + "'" * letter.primes + sups + arguments


def in_latex(text: str) -> str:
    """A text of tokens in LaTeX: typefaces hold the next letter, and so do scripts without braces."""
    found: list[str] = []
    styles: list[str] = []
    is_script = False
    for word, behind in pairwise((*text.split(), "")):
        if word in TYPEFACES:
            (found if behind == "{" else styles).append(word)
            continue
        is_name = len(word) > 1 and word[0] != "\\" and not re.fullmatch(r"[\d.]+|.*[#|].*", word)
        said = (
            word if not is_name else rf"\mathrm{{{word}}}" if word.isalpha() else rf"\text{{{word.replace('~', ' ')}}}"
        )
        for style in reversed(styles):
            said = (r"\boldsymbol" if style == r"\mathbf" and said[:1] == "\\" else style) + f"{{{said}}}"
        styles = []
        found.append(f"{{{said}}}" if is_script else said)
        is_script = word in ("_", "^") and behind != "{"
    return re.sub(r" ?([_^]) ?\{ ?| (?=[,}])", lambda found: found[1] + "{" if found[1] else "", " ".join(found))
