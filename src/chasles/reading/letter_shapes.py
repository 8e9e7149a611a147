"""Which shapes the letters of a page have: whether its equations fit together is seen without reading them in full."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache, reduce
from itertools import pairwise

from chasles.reading.atoms import Atom, Atoms, Terms, Unread
from chasles.reading.derivatives import Derivative, derivative
from chasles.reading.glyphs import Glyph, joined, letter_of, with_arguments
from chasles.reading.grammar import Chain, formula
from chasles.reading.page_functions import DIFFERENCES, lists_letters
from chasles.reading.spellings import called

Shape = tuple[int, int]
ShapeOf = Callable[[Glyph], tuple[Shape | None, tuple[str, ...]]]
"""What shape a letter has, None if that is not known, and which accents and superscripts are no part of its name."""
SCALAR, VECTOR, MATRIX, QUATERNION = (1, 1), (3, 1), (3, 3), (4, 1)
OF_ANY = (r"\exp", r"\log", r"\ln", "Exp", "Log", r"\det", "tr", r"\tr", "Tr", "trace", "diag", "skew", "vect")
"""Functions of what may be no scalar."""
TRACES = (r"\det", "tr", r"\tr", "Tr", "trace")
"""Numbers of a square matrix."""
TRANSPARENT = (r"\sum", r"\int", r"\oint", r"\prod", r"\lim")


class Misshapen(ValueError):
    """Two pieces that do not fit together."""


def shape_of_chain(chain: Chain, of: ShapeOf, names: frozenset[str]) -> list[Shape | None]:
    """The shapes of the sides; raises `Misshapen` where they do not fit together. `names` are those of functions."""
    shapes_of = _PieceShapes(of, names)
    shapes = [shapes_of.terms(side) for side in chain.sides if side is not None]
    reduce(_same, shapes, None)
    return shapes


def _same(one: Shape | None, other: Shape | None) -> Shape | None:
    if one is not None and other is not None and one != other:
        raise Misshapen
    return one if one is not None else other


def _times(one: Shape | None, other: Shape | None) -> Shape | None:
    if one is None or other is None:
        return None
    if one == SCALAR or other == SCALAR:
        return other if one == SCALAR else one
    if one[1] != other[0]:
        raise Misshapen
    return one[0], other[1]


@lru_cache(maxsize=4096)
def _is_of_any_shape(piece: Atom) -> bool:
    return piece.kind != "INFIX" and letter_of(piece).loose.base in (r"\nabla", "!")


@lru_cache(maxsize=4096)
def _parted(pieces: Atoms) -> tuple[tuple[str, ...], tuple[Atoms, ...]]:
    """The signs between the products of a row, and these."""
    places = [-1, *(k for k, piece in enumerate(pieces) if piece.kind == "INFIX"), len(pieces)]
    signs = tuple(pieces[k].text for k in places[1:-1])
    return signs, tuple(pieces[k + 1 : end] for k, end in pairwise(places))


class _PieceShapes:
    """The shapes of pieces of a formula; None for what may have any."""

    def __init__(self, of: ShapeOf, names: frozenset[str]) -> None:
        self.of, self.names = of, names

    def terms(self, terms: Terms) -> Shape | None:
        return reduce(_same, map(self.row, terms.rows), None)

    def atoms(self, atoms: Atoms) -> Shape | None:
        try:
            sides = formula(atoms).sides if atoms else ()
        except Unread:
            return None
        return self.terms(sides[0]) if len(sides) == 1 and sides[0] is not None else None

    def row(self, pieces: Atoms) -> Shape | None:
        if len(pieces) == 1 and pieces[0].text in ("0", "1"):
            return None
        if any(map(_is_of_any_shape, pieces)):
            return None
        signs, parts = _parted(pieces)
        shape, is_number = self.product(parts[0]), all(atom.kind == "NUMBER" for atom in parts[0])
        for sign, part in zip(signs, parts[1:], strict=True):
            shape = _combined(sign, shape, self.product(part), is_number) if part else self.marked(shape, (sign,))
        return shape

    def product(self, atoms: Sequence[Atom]) -> Shape | None:
        shape: Shape | None = SCALAR
        at = 0
        while at < len(atoms):
            atom, behind = atoms[at], atoms[at + 1] if at + 1 < len(atoms) else None
            name, at = called(atom), at + 1
            if atom.text in TRANSPARENT:
                continue
            if behind is not None and (name == "d" or (name in self.names and atom.kind in ("LETTER", "COMMAND"))):
                shape, at = shape if name == "d" else _times(shape, self.value(name, behind)), at + 1
            elif behind is not None and (difference := self.difference(atom, behind)):
                shape, at = _times(shape, difference), at + 1
            elif (found := derivative(atom)) and not found.of:
                shape = shape if found.rate else None
            elif behind is not None and behind.text == "()" and atom.kind != "NUMBER" and _is_argument(behind):
                shape, at = _times(shape, self.marked(self.atom(atom), letter_of(behind).sups)), at + 1
            else:
                shape = _times(shape, self.atom(atom))
        return shape

    def difference(self, sign: Atom, of: Atom) -> Shape | None:
        r"""The shape of a letter that is written by two, as \Delta t is; None if they are none."""
        pair = joined((sign, of)) if sign.text in DIFFERENCES else None
        shape, marks = self.of(letter_of(pair)) if pair else (None, ())
        return self.marked(shape, marks)

    def value(self, name: str, argument: Atom) -> Shape | None:
        """The shape of a function's value."""
        inner = self.atom(argument)
        if name not in OF_ANY and inner not in (SCALAR, None):
            raise Misshapen
        if name in TRACES and inner is not None and inner[0] != inner[1]:
            raise Misshapen
        return SCALAR if inner == SCALAR or name in TRACES else None

    def atom(self, atom: Atom) -> Shape | None:
        letter, text = letter_of(atom), atom.text
        shape: Shape | None = SCALAR
        match atom.kind:
            case "NUMBER":
                pass
            case "BRACKET" if r"\times" in (*letter.sups, letter.sub) and len(atom.inside) == 1:
                return self.marked(self.terms(atom.inside[0]), (r"\times",))
            case "BRACKET" if text == r"\|\|" and atom.inside:
                inner = self.terms(atom.inside[0])
                if inner is not None and (inner[1] != 1 or inner == SCALAR):
                    raise Misshapen
            case "BRACKET" if atom.inside and (
                text in ("()", "[]", r"\{\}") or (text == r"\langle\rangle" and atom.inside[2:])
            ):
                cells = [self.terms(each) for each in atom.inside]
                if len(cells) > 1:  # a column that is printed in a line, also where a T says so
                    return _stacked([[cell] for cell in cells])
                shape = cells[0]
            case "BRACKET":
                return SCALAR if text == "||" else None
            case "GRID" if atom.text.endswith(("matrix", "array")):
                shape = _stacked([[self.atoms(cell) for cell in row] for row in atom.rows])
            case "COMMAND_OF_TWO" if "frac" in text:
                shape = self.fraction(atom)
            case "COMMAND" if text == r"\sqrt":
                if self.atoms(atom.arguments[0]) not in (SCALAR, None):
                    raise Misshapen
            case "GROUP" if not letter.accents:
                shape = self.atoms(atom.arguments[0])
            case "LETTER" if text == "e" and len(atom.sups) == 1 and not atom.sub:
                shape = self.atoms(atom.sups[0])
                if shape not in (SCALAR, MATRIX, None):
                    raise Misshapen
                return shape
            case _:
                shape, marks = self.of(letter)
                return self.marked(shape, marks)
        return self.marked(shape, letter.sups)

    def fraction(self, atom: Atom) -> Shape | None:
        found = derivative(atom)
        if found and found.sign in ("d", "D", r"\partial"):
            if found.rate:
                return self.atoms(found.of)
            return self.derivative(found) if found.sign == r"\partial" and not found.is_of_its_own else None
        above, below = atom.arguments
        if self.atoms(below) not in (SCALAR, None):
            raise Misshapen
        return SCALAR if [each.text for each in above] in (["1"], ["0"]) else self.atoms(above)

    def derivative(self, partial: Derivative) -> Shape | None:
        """The shape of a partial derivative: by a scalar, or of a column by a column."""
        shape, variable = self.atoms(partial.of), self.atoms(partial.by)
        if shape is None or variable is None or variable == SCALAR:
            return shape if variable == SCALAR else None
        if shape[1] != 1 or variable[1] != 1:
            raise Misshapen
        return shape[0], variable[0]

    def marked(self, shape: Shape | None, marks: Sequence[str]) -> Shape | None:
        for mark in marks:
            plain = mark.replace(r"\mathrm ", "").replace(r"\mathsf ", "")
            if shape is None:
                return None
            if plain in ("T", r"\top", "- T", r"- \top"):
                shape = shape[1], shape[0]
            elif plain in (r"\tilde", r"\wedge", r"\times"):
                if shape != VECTOR:
                    raise Misshapen
                shape = MATRIX
            elif plain == r"\vee":
                shape = VECTOR
            elif plain == "2" and shape[1] == 1:
                shape = SCALAR
            elif (plain == "- 1" or plain.isdigit()) and shape[0] != shape[1]:
                raise Misshapen
        return shape


@lru_cache(maxsize=4096)
def _is_argument(bracket: Atom) -> bool:
    with_them = with_arguments(Glyph(""), bracket)
    return lists_letters(bracket) or len(bracket.inside) > 1 or (with_them is not None and with_them.arguments == "t")


def _combined(sign: str, one: Shape | None, other: Shape | None, is_number: bool) -> Shape | None:
    if sign == r"\times" and not is_number:
        if {one, other} - {VECTOR, None}:
            raise Misshapen
        return VECTOR
    if sign == r"\otimes" and None not in (one, other) and SCALAR not in (one, other):
        if one != other or one not in (VECTOR, QUATERNION):
            raise Misshapen
        return MATRIX if one == VECTOR else QUATERNION
    if sign == "/":
        if other not in (SCALAR, None):
            raise Misshapen
        return one
    if sign == r"\cdot" and one == other and one is not None and one[1] == 1:
        return SCALAR
    return _times(one, other) if sign in (r"\times", r"\cdot", "*") else None


def _stacked(rows: Sequence[Sequence[Shape | None]]) -> Shape | None:
    """The shape of a matrix of blocks; None where some row or column is of unknown size."""
    if len({*map(len, rows)}) != 1:
        return None
    heights = [{cell[0] for cell in row if cell} for row in rows]
    widths = [{cell[1] for cell in column if cell} for column in zip(*rows, strict=True)]
    if any(len(each) > 1 for each in (*heights, *widths)):
        raise Misshapen
    known = {cell for row in rows for cell in row if cell}
    heights = [each or {1} & set().union(*widths) for each in heights]  # [0, 1] below [R, r] is one row
    if not known or (known != {SCALAR} and not all((*heights, *widths))):
        return None
    return sum(next(iter(each), 1) for each in heights), sum(next(iter(each), 1) for each in widths)
