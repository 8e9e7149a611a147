"""What is taken of all that follows: sums over what is no numbers, integrals, limits; and terms of an order, O(x^3).

Sums and integrals are quantities of their own, as print has them; limits of what goes to zero are words.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

from chasles.reading.atoms import Atom, Atoms, Terms
from chasles.reading.context import FittingContext
from chasles.reading.derivatives import derivative
from chasles.reading.fits import Fit, made
from chasles.reading.glyphs import in_latex, letter_of, text_of, text_of_row
from chasles.reading.grammar import terms_in
from chasles.reading.page_notation import PageNotation
from chasles.reading.quotients import of_atoms
from chasles.reading.spellings import called, is_extremum
from chasles.vocabulary import Node, Norm, Number, Power, Symbol, symbols_of
from chasles.vocabulary.dimension import has_units
from chasles.vocabulary.expansions import Limit, UpTo

TOTALS = (r"\sum", r"\lim", r"\prod", r"\int", r"\oint")
OPEN = TOTALS[:3]
Order = tuple[Symbol, int]


def order_of(row: Atoms, ctx: FittingContext) -> Order | None:
    """What is small and to which power, where a row is O(x^3) or O(|v|^2) and O is no letter of the notation."""
    if len(row) != 2:
        return None
    name, bracket = row
    letter = letter_of(name)
    if letter.loose.base != "O" or name.is_marked or bracket.kind != "BRACKET" or len(bracket.inside) != 1:
        return None
    if bracket.is_marked or next(ctx.notation.letters.meanings(letter), None) is not None:
        return None
    return next((order for fit in ctx.terms(bracket.inside[0]) if (order := _power(fit.node)) is not None), None)


def _power(node: Node | None) -> Order | None:
    match node:
        case Power(of, int(exponent)) if (inner := _power(of)) is not None and exponent > 0:
            return inner[0], inner[1] * exponent
        case Norm(Symbol(stands_for=None) as small):
            return small, 1
        case Symbol(stands_for=None, is_scalar=True):
            return node, 1
        case _:
            return None


def up_to_order(fits: Sequence[Fit], order: Order, ctx: FittingContext) -> list[Fit]:
    """The readings of what stands before the order, with it."""
    found = []
    for fit in fits:
        usual = fit.sized_as(fit.usual)
        node = made(UpTo, usual.node, *order) if usual else None
        found += [] if node is None else [Fit(node, fit.cost)]
    return found


def limits(sign: Atom, terms: Sequence[Node], ctx: FittingContext) -> list[Fit]:
    """The limits of terms in which nothing else stands than what goes to zero: other letters may go with it."""
    arrows = [place for place, token in enumerate(sign.sub or ()) if token.text in (r"\to", r"\rightarrow")]
    if sign.text != r"\lim" or not sign.sub or len(arrows) != 1 or sign.sups:
        return []
    small = [fit.node for fit in of_atoms(sign.sub[: arrows[0]], ctx)]
    behind = [fit.node for fit in of_atoms(sign.sub[arrows[0] + 1 :], ctx)]
    if Number(0) not in behind:  # type: ignore[arg-type]
        return []
    words = [made(Limit, term, each) for term in terms for each in small if symbols_of(term) == (each,)]
    return [Fit(word) for word in words if word is not None]


def takes_all(atom: Atom, notation: PageNotation) -> bool:
    """Whether it makes a quantity of its own of the product behind it: a derivative, or a nabla in any typeface."""
    letter = letter_of(atom)
    is_known = called(atom) in notation.spellings.names or next(notation.letters.meanings(letter), None) is not None
    found = derivative(atom)
    return bool(found and found.is_of_its_own and not found.of) or (letter.loose.base == r"\nabla" and not is_known)


def totals(sign: Atom, inside: Atoms, read: Callable[[Atoms], list[Fit]], ctx: FittingContext) -> list[Fit]:
    """The sum or integral of all that stands inside, differentials included; none, and a note why, if it is none."""
    is_sum = sign.text in OPEN
    if not any(piece.kind != "INFIX" for piece in inside) or (has_units(ctx.notation.home) and not is_sum):
        ctx.note(f"no word for {sign.text} here", sign.place)
        return []
    fits = read(inside) if is_sum else []
    terms = [fit.node for fit in fits if fit.node is not None and fit.shape]
    return limits(sign, terms, ctx) or ctx.of_its_own(in_latex(text_of_row((sign, *inside))), terms)


def whole_extrema(terms: Terms) -> Terms:
    """The terms with an extremum of all that follows as one piece."""
    for place, row in enumerate(terms.rows):
        begin = next((k for k in range(len(row)) if is_extremum(row[k:])), None)
        if begin is not None:
            inside = Terms(("", *terms.signs[place + 1 :]), (row[begin:], *terms.rows[place + 1 :]))
            whole = *row[:begin], Atom("EVENT", text_of(inside), row[begin].place)
            return Terms(terms.signs[: place + 1], (*terms.rows[:place], whole))
    return terms


def whole_integrals(terms: Terms) -> Terms:
    """The terms with each integral of a sum without brackets, up to its differential, as one piece."""
    signs, rows = terms.signs, terms.rows
    for first, row in enumerate(rows):
        begin = next((place for place, piece in enumerate(row) if piece.text in TOTALS[len(OPEN) :]), None)
        if begin is None or _differentials(row):
            continue
        for last, other in enumerate(rows[first + 1 :], first + 1):
            end = end_of_total(row[begin], other)
            if any(piece.text in TOTALS[len(OPEN) :] for piece in other):
                break
            if _differentials(other[:end]) and end:
                inside = row[begin:], *rows[first + 1 : last], other[:end]
                text = text_of(Terms(("", *signs[first + 1 : last + 1]), inside))
                whole = (*row[:begin], Atom("EVENT", text, row[begin].place), *other[end:])
                less = Terms((*signs[: first + 1], *signs[last + 1 :]), (*rows[:first], whole, *rows[last + 1 :]))
                return whole_integrals(less)
    return terms


def _differentials(row: Atoms) -> int:
    """How many differentials stand in a row, and in the fractions and brackets there."""
    inner = (each for piece in row for terms in terms_in(piece) for each in terms.rows)
    return sum(_is_differential(one, other) for one, other in pairwise(row)) + sum(map(_differentials, inner))


def end_of_total(sign: Atom, inside: Atoms) -> int:
    """Where what the sign is put before ends: behind the last differential, or all that is a product with a sum's."""
    ends = [k + 2 for k in range(len(inside) - 1) if _is_differential(inside[k], inside[k + 1])]
    return len(inside) if sign.text not in TOTALS[len(OPEN) :] or 2 in ends or not ends else ends[-1]


def _is_differential(sign: Atom, of: Atom) -> bool:
    if "INFIX" in (sign.kind, of.kind) or of.kind == "BRACKET" or sign.is_marked:
        return False
    return letter_of(sign).base in ("d", r"\mathrm d")
