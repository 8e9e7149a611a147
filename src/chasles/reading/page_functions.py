"""Which letters of a page are functions: the brackets behind them hold nothing but letters."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from itertools import pairwise

from chasles.reading.commands import MARKS
from chasles.reading.glyphs import Glyph, is_operator, letter_of, with_arguments
from chasles.reading.grammar import Atom, Chain, Terms, terms_in
from chasles.reading.grouping import TYPEFACES


def functions_in(chains: Iterable[Chain]) -> dict[Glyph, bool]:
    r"""The letters with arguments: True for those that have letters alone, \Gamma(\phi), False for those never without.

    (t) makes no function of a quantity.
    """
    listed: set[Glyph] = set()
    found: dict[bool, set[Glyph]] = {False: set(), True: set()}
    waiting = [side for chain in chains for side in chain.sides if side is not None]
    while waiting:
        for row in waiting.pop().rows:
            for one, bracket in pairwise((*row.pieces, None)):
                if not isinstance(one, Atom):
                    continue
                letter = replace(letter_of(one), sups=(), place=None)
                is_called = isinstance(bracket, Atom) and with_arguments(letter, bracket) is not None
                found[is_called].add(letter)
                listed |= {letter} if isinstance(bracket, Atom) and lists_letters(bracket) else set()
                waiting += terms_in(one)
    called = found[True] - found[False]
    return dict.fromkeys(called, False) | dict.fromkeys(listed | set(filter(is_operator, called)), True)


def lists_letters(bracket: Atom) -> bool:
    """Whether these are round brackets around letters and numbers, parted by commas, and not around t alone."""
    with_them = with_arguments(Glyph(""), bracket)
    return with_them is not None and with_them.arguments != "t" and all(map(_is_letter, bracket.inside))


def _is_letter(terms: Terms) -> bool:
    (row, *more) = terms.rows
    piece = row.pieces[0]
    if more or len(row.pieces) != 1 or terms.signs != ("",) or not isinstance(piece, Atom) or piece.sups:
        return False
    return piece.kind in ("LETTER", "NUMBER") or piece.text in TYPEFACES or piece.text in MARKS
