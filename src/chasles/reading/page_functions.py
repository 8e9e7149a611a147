"""Which letters of a page are functions: the brackets behind them hold nothing but letters; and which are factors."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import pairwise

from chasles.reading.atoms import TYPEFACES, Atom, Terms
from chasles.reading.commands import MARKS
from chasles.reading.derivatives import derivative
from chasles.reading.glyphs import Glyph, is_operator, letter_of, text_of_atom, with_arguments
from chasles.reading.grammar import Chain, terms_in

DIFFERENCES = (r"\Delta", r"\delta", "d", r"\mathrm d", r"\partial")
"""Before a letter or brackets these make a change of it, and are no factors, unless the page has them alone too."""


def functions_in(chains: Iterable[Chain]) -> dict[Glyph, bool]:
    r"""The letters with arguments: True for functions, False for others that are never without.

    A function has letters alone for arguments, \Gamma(\phi), or different ones and is never without. (t) makes no
    function of a quantity.
    """
    listed: set[Glyph] = set()
    arguments: dict[Glyph, set[str]] = {}
    found: dict[bool, set[Glyph]] = {False: set(), True: set()}
    for one, bracket in neighbours(chains):
        letter = replace(letter_of(one), sups=(), place=None)
        is_called = bracket is not None and with_arguments(letter, bracket) is not None
        if bracket is not None and not is_called and letter.base != "E" and is_operator(letter):
            continue  # the L of \mathcal{L} f may be no factor
        found[is_called].add(letter)
        if bracket is not None and is_called:
            arguments.setdefault(letter, set()).add(text_of_atom(bracket.bare))
        listed |= {letter} if bracket is not None and lists_letters(bracket) else set()
    called = found[True] - found[False]
    listed |= {letter for letter in called if is_operator(letter) or _may_be_function(letter, arguments[letter])}
    return dict.fromkeys(called, False) | dict.fromkeys(listed, True)


def _may_be_function(letter: Glyph, arguments: set[str]) -> bool:
    """Whether it is a letter in italics before different arguments, each as short as 2 x or x + h."""
    is_plain = len(letter.base.split()) == 1 and not letter.accents
    return is_plain and len(arguments) > 1 and all(len(said.split()) < 9 for said in arguments)


def neighbours(chains: Iterable[Chain]) -> Iterator[tuple[Atom, Atom | None]]:
    """Each atom of the page but signs, and the one that stands right behind it."""
    waiting = [side for chain in chains for side in chain.sides if side is not None]
    while waiting:
        for row in waiting.pop().rows:
            for one, behind in pairwise((*row, None)):
                if one is not None and one.kind != "INFIX":
                    yield one, None if behind is None or behind.kind == "INFIX" else behind
                    found = derivative(one)
                    waiting += [*terms_in(one)][found is not None and not found.of :]


def shown_alone(chains: Iterable[Chain]) -> frozenset[str]:
    """The signs of differences that stand on the page where nothing follows them: there they are letters."""
    return frozenset(_sign(letter_of(one)) for one, behind in neighbours(chains) if behind is None) - {""}


def _sign(letter: Glyph) -> str:
    """The sign of a difference that a letter may be: with a letter below it D is one, too, as in D_t."""
    by = letter.sub[-1:].isalpha() and " " not in letter.sub
    if letter.sub and not (letter.base in (r"\Delta", r"\partial") or (by and letter.base in ("D", r"\mathrm D"))):
        return ""
    return letter.base if letter.base in DIFFERENCES else f"{letter.base}_{letter.sub}" if letter.sub else ""


def makes_difference(sign: Atom, behind: Atom | None, alone: frozenset[str]) -> bool:
    """Whether what stands behind is what a difference is taken of."""
    letter = letter_of(sign)
    is_sign = _sign(letter) not in ("", *alone) and not (letter.primes or letter.accents)
    return (
        is_sign
        and all(sup.isdigit() for sup in letter.sups)
        and behind is not None
        and behind.kind != "NUMBER"
        and len(behind.inside) < 2
    )


def lists_letters(bracket: Atom) -> bool:
    """Whether these are round brackets around letters and numbers, parted by commas, and not around t alone."""
    with_them = with_arguments(Glyph(""), bracket)
    return with_them is not None and with_them.arguments != "t" and all(map(_is_letter, bracket.inside))


def _is_letter(terms: Terms) -> bool:
    (row, *more) = terms.rows
    piece = row[0]
    if more or len(row) != 1 or terms.signs != ("",) or piece.kind == "INFIX" or piece.sups:
        return False
    return piece.kind in ("LETTER", "NUMBER") or piece.text in TYPEFACES or piece.text in MARKS
