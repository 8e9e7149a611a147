"""How words are spelled, the other way round: from an accent, a script, brackets, a name or a sign to the word."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from chasles.reading.atoms import TYPEFACES, Atom, Atoms, Terms, Unread, said_of
from chasles.reading.glyphs import letter_of, only_atom, text_of
from chasles.reading.grammar import formula
from chasles.reading.respelling import atoms_in
from chasles.vocabulary import Contract, Group, Misfit, Negative, Node, Scale, Skew
from chasles.vocabulary.functions import FunctionOf
from chasles.vocabulary.rotation_vectors import RotationByVector

Make = Callable[..., Node]
HOLES = (r"\holeA", r"\holeB")
EXTREMA, ARGUMENTS = ("min", "max", "sup", "inf"), ("argmin", "argmax", "minimize", "maximize")


@dataclass
class Spellings:
    """The words of a notation by what they look like; a look may stand for several."""

    accents: dict[str, list[Make]] = field(default_factory=dict)
    scripts: dict[str, list[Make]] = field(default_factory=dict)
    brackets: dict[tuple[str, str, str], list[Make]] = field(default_factory=dict)
    names: dict[str, list[Make]] = field(default_factory=dict)
    subscripted: dict[str, list[Make]] = field(default_factory=dict)
    infixes: dict[str, list[Make]] = field(default_factory=dict)

    def add(self, form: str, make: Make) -> None:
        """Let the form stand for what is made of its operands; raises `Unread` for a form that is no pattern."""
        for name, hole in (("#1", HOLES[0]), ("#2", HOLES[1]), ("#", HOLES[0])):
            form = form.replace(name, f"{hole} ")
        chain = formula(atoms_in(form))
        row = chain.sides[0].rows[0] if chain.sides[0] and len(chain.sides[0].rows) == 1 else ()
        found = _infix(row) or _applied(row)
        atom = only_atom(chain)
        if atom is not None:
            found = self._of_atom(atom)
        if found is None:
            raise Unread(f"{form} is no pattern: write an accent, a script, brackets, a name or a sign around '#'")
        look, key = found
        getattr(self, look).setdefault(key, []).append(make)

    def _of_atom(self, atom: Atom) -> tuple[str, object] | None:
        letter = letter_of(atom)
        if letter.base in HOLES and len(letter.accents) == 1 and not letter.sups and not letter.sub:
            return "accents", letter.accents[0]
        if letter.base in HOLES and not letter.accents and letter.sub and not letter.sups:
            return "scripts", f"_ {letter.loose.sub}"
        if letter.base in HOLES and not letter.accents and letter.sups:
            return "scripts", " ".join(letter.loose.sups)
        if letter.base in HOLES and letter.primes:
            return "scripts", "'" * letter.primes
        if atom.kind == "BRACKET" and len(atom.inside) == 2 and all(text_of(each) in HOLES for each in atom.inside):
            return "brackets", (f"{atom.text},", letter.loose.sub, " ".join(letter.loose.sups))
        if atom.kind == "BRACKET" and len(atom.inside) == 1 and text_of(signed(atom)[1]) in HOLES:
            return "brackets", (signed(atom)[0], letter.loose.sub, " ".join(letter.loose.sups))
        if atom.sub and said_of(atom.sub) in HOLES:
            return "subscripted", called(atom)
        if atom.kind == "COMMAND" and atom.text not in TYPEFACES and said_of(atom.arguments[0]) in HOLES:
            return "names", atom.text
        return None


def signed(atom: Atom) -> tuple[str, Terms]:
    r"""The brackets, with the sign that stands at their end as in [a \times], and what they hold without it."""
    (terms,) = atom.inside
    *pieces, last = terms.rows[-1]
    if last.kind != "INFIX" or not pieces:
        return atom.text, terms
    half = len(atom.text) // 2
    rows = (*terms.rows[:-1], tuple(pieces))
    return f"{atom.text[:half]}{last.text}{atom.text[half:]}", Terms(terms.signs, rows)


def called(atom: Atom) -> str:
    """The name of a function: without its typeface where that is upright."""
    letter = letter_of(atom)
    return letter.base.removeprefix(r"\mathrm ")


def is_extremum(row: Atoms) -> bool:
    """Whether a row begins with a minimum or maximum that says what runs, or with where it is taken."""
    name, behind = (called(piece).strip("\\") for piece in (*row, row[0])[:2])
    return (name in EXTREMA and row[0].sub is not None) or name in ARGUMENTS or (name == "arg" and behind in EXTREMA)


def _infix(row: Atoms) -> tuple[str, object] | None:
    if len(row) == 3 and row[1].kind == "INFIX" != row[0].kind:
        return "infixes", row[1].text
    return None


def _applied(row: Atoms) -> tuple[str, object] | None:
    """A name before brackets, or before what it is applied to; or two operands side by side."""
    if len(row) == 2 and "INFIX" not in (row[0].kind, row[1].kind):
        if row[0].text in HOLES and row[1].text in HOLES:
            return "infixes", ""
        subscript = f" _ {said_of(row[0].sub)}" if row[0].sub else ""
        return "names", called(row[0]) + subscript
    return None


def multiplied(a: Node, b: Node) -> Node:
    """The product as an author writes it from left to right."""
    if a.is_scalar:
        return Scale(a, b)
    if b.is_scalar:
        return Scale(b, a, trailing=True)
    return Contract((*(a.factors if isinstance(a, Contract) else (a,)), b))


def exponential(of: Node) -> Node:
    """The exponential of a scalar, or of a multiple of a cross-product matrix; raises `Misfit` for anything else."""
    if of.is_scalar:
        return FunctionOf("exp", (of,))
    vector = _axial(of)
    if vector is None:
        raise Misfit(f"{of} is neither a scalar nor a multiple of a cross-product matrix")
    return RotationByVector(vector)


def _axial(of: Node) -> Node | None:
    """The vector whose cross-product matrix it is."""
    if isinstance(of, Skew):
        return of.of
    if isinstance(of, Group | Negative) and (inner := _axial(of.below[0])) is not None:
        return inner if isinstance(of, Group) else Negative(inner)
    if isinstance(of, Scale) and (inner := _axial(of.term)) is not None:
        return Scale(of.factor, inner, of.trailing)
    return None
