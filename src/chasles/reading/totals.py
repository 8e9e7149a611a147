"""Sums over what is no numbers, and integrals: quantities of their own, as print has them; some limits are words."""

from __future__ import annotations

from collections.abc import Callable

from chasles.reading.context import FittingContext
from chasles.reading.expanding import limits
from chasles.reading.fits import Fit, own_quantity
from chasles.reading.glyphs import in_latex, letter_of, said_of, text_of_atom
from chasles.reading.grammar import Atom
from chasles.reading.lexemes import Token
from chasles.vocabulary import NO_DIMENSION, latex, uniform
from chasles.vocabulary.dimension import has_units
from chasles.vocabulary.fitting import measured

Pieces = tuple[Atom | Token, ...]
TOTALS = (r"\sum", r"\lim", r"\prod", r"\int", r"\oint")
OPEN = TOTALS[:3]


def totals(sign: Atom, inside: Pieces, read: Callable[[Pieces], list[Fit]], ctx: FittingContext) -> list[Fit]:
    """The sum or integral of all that stands inside, differentials included; none, and a note why, if it is none."""
    end = len(inside) - 2 * (sign.text not in OPEN)
    tail = [piece for piece in inside[max(end, 0) :] if isinstance(piece, Atom)]
    if end < 0 or not inside or (tail and has_units(ctx.notation.home)):
        ctx.note(f"no word for {sign.text} here", sign.place)
        return []
    mark = sign.text + (f"_{{{in_latex(said_of(sign.sub))}}}" if sign.sub else "")
    mark += "".join(f"^{{{in_latex(said_of(sup))}}}" for sup in sign.sups)
    behind = in_latex(" ".join(map(text_of_atom, tail)))
    fits = read(inside[:end]) if end else []
    terms = [fit.node for fit in fits if fit.node is not None and fit.shape and ctx.is_as_printed(fit)]
    if known := limits(sign, terms, ctx):
        return known
    sizes = [(latex(term), measured(term)) for term in terms] if end else [("", uniform((1, 1), NO_DIMENSION))]
    letters = {" ".join(filter(None, (mark, said, behind))): size for said, size in sizes}
    found = [own_quantity(letter, size, ctx.notation.home) for letter, size in letters.items()]
    return [Fit(each, ctx.said(each)) for each in found]


def end_of_total(sign: Atom, inside: Pieces) -> int:
    """Where what the sign is put before ends: behind the last differential, or at the end of a sum."""
    if sign.text in OPEN:
        return len(inside)
    return max((k + 2 for k in range(len(inside) - 1) if _is_differential(inside[k], inside[k + 1])), default=0)


def _is_differential(sign: Atom | Token, of: Atom | Token) -> bool:
    if isinstance(sign, Token) or isinstance(of, Token) or of.kind == "BRACKET" or sign.is_marked:
        return False
    return letter_of(sign).base in ("d", r"\mathrm d")
