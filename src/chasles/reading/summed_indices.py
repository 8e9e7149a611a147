"""Indices that a page sums over without saying so: in a_i b_i = s the i runs, where i numbers things on the page."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

from chasles.reading.atoms import Atom, Atoms, Terms
from chasles.reading.glyphs import letter_of
from chasles.reading.grammar import Chain, terms_in
from chasles.reading.page_functions import neighbours

INDICES = frozenset("ijkl") | {r"\mu", r"\nu", r"\alpha", r"\beta", r"\rho", r"\sigma", r"\lambda", r"\kappa"}
SAID = (r"\sum", r"\prod", r"\int", r"\max", r"\min")
"""Signs that say themselves what runs."""


def index_letters(chains: Iterable[Chain]) -> frozenset[str]:
    """The letters that number things: several stand together in one script, or in turn below the same letter."""
    found: set[str] = set()
    below: dict[str, set[str]] = {}
    for one, _ in neighbours(chains):
        words = _scripts(one)
        if words and set(words) <= INDICES:
            turns = below.setdefault(letter_of(one).base, set())
            turns |= set(words)
            found |= turns if len(turns) > 1 else set()
    return frozenset(found)


def summed_over(chain: Chain, indices: frozenset[str]) -> frozenset[str]:
    """The indices that one term of an equation has twice and another does not have."""
    rows = [row for side in chain.sides if side is not None for row in side.rows]
    terms = [counted(row) for row in rows if [piece.text for piece in row] != ["0"]]
    if any(piece.text in SAID for piece, _ in neighbours([chain])):
        return frozenset()
    return frozenset(each for each in indices if {0, 2} <= {term[each] for term in terms})


def counted(row: Atoms) -> Counter[str]:
    """How often each index stands in a product; in a sum in brackets, as often as in its terms."""
    total: Counter[str] = Counter()
    for piece in row:
        total.update(_scripts(piece) * (2 if "2" in letter_of(piece).sups else 1))
        for terms in terms_in(piece):
            total.update(_most(terms))
    return total


def _most(terms: Terms) -> Counter[str]:
    most: Counter[str] = Counter()
    for row in terms.rows:
        most |= counted(row)
    return most


def _scripts(atom: Atom) -> list[str]:
    letter = letter_of(atom)
    return [word for text in (letter.sub, *letter.sups) for word in text.split() if not word.isdigit()]
