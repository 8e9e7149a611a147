"""What is known of the signs of differences on one way through a program's cases."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from dataclasses import replace as with_fields

from chasles.lowering.algebra import Algebra
from chasles.lowering.cases import Case, Comparison
from chasles.proof.ratios import Ratio
from chasles.proof.rings import Polynomial

__all__ = ["Fork", "Signs"]

ALL = (-1, 0, 1)


class Fork(Exception):
    """A comparison comes out either way: each way is to be looked at."""

    def __init__(self, difference: Ratio) -> None:
        super().__init__("a comparison that is not settled")
        self.difference = difference


@dataclass(frozen=True, slots=True)
class Signs:
    """For each difference the signs that it can have; of the comparisons of a clause at least one comes out false."""

    algebra: Algebra
    known: tuple[tuple[Ratio, tuple[int, ...]], ...] = ()
    clauses: tuple[tuple[tuple[Ratio, tuple[int, ...]], ...], ...] = ()

    @property
    def zeros(self) -> tuple[Polynomial, ...]:
        """What is known to be zero."""
        return tuple(difference.numerator for difference, signs in self.known if signs == (0,))

    @property
    def is_possible(self) -> bool:
        """Whether every difference has a sign left, and no case that was passed over applies."""
        return all(signs for _, signs in self.known) and all(map(self._is_open, self.clauses))

    def of(self, difference: Ratio) -> tuple[int, ...]:
        """The signs that a difference can have."""
        if difference.is_zero:
            return (0,)
        terms = self.algebra.context.field.ring.terms(difference.numerator)
        if not any(difference.denominator) and len(terms) == 1 and not any(terms[0][0]):
            return (1,) if terms[0][1] > 0 else (-1,)
        found = self._find(difference)
        signs = ALL if found is None else tuple(sorted(sign * found[1] for sign in self.known[found[0]][1]))
        if 0 in signs and len(signs) > 1 and self.algebra.is_product_of_atoms(difference):
            return tuple(sign for sign in signs if sign)
        return signs

    def truth(self, kind: str, difference: Ratio) -> bool:
        """Whether a difference is negative ("less") or zero ("equal"); raises `Fork` where that is not settled."""
        wanted = _wanted(kind, holds=True)
        signs = self.of(difference)
        if set(signs) <= set(wanted):
            return True
        if not set(signs) & set(wanted):
            return False
        if kind == "equal" and self._find(difference) is None and self.algebra.cannot_vanish(difference):
            return False
        raise Fork(difference)

    def forked(self, difference: Ratio) -> Iterator[Signs]:
        """The ways in which a difference that is not settled can come out."""
        for sign in self.of(difference):
            settled = self.knowing(difference, (sign,))
            if settled.is_possible:
                yield settled

    def knowing(self, difference: Ratio, signs: tuple[int, ...]) -> Signs:
        """The same, and the difference has one of the given signs."""
        left = tuple(sign for sign in self.of(difference) if sign in signs)
        found = self._find(difference)
        if found is None:
            return with_fields(self, known=(*self.known, (difference, left)))
        place, turn = found
        entry = self.known[place][0], tuple(sorted(sign * turn for sign in left))
        return with_fields(self, known=(*self.known[:place], entry, *self.known[place + 1 :]))

    def in_case(self, case: Case) -> Signs:
        """The same, where the case applies."""
        signs = self
        for comparison in case.where:
            signs = signs.knowing(*signs._literal(comparison))
        return signs

    def not_in_case(self, case: Case) -> Signs:
        """The same, where the case does not apply."""
        clause = tuple(map(self._literal, case.where))
        if len(clause) == 1:
            difference, signs = clause[0]
            return self.knowing(difference, tuple(sign for sign in ALL if sign not in signs))
        registered = self
        for difference, _ in clause:
            registered = registered.knowing(difference, ALL)
        return with_fields(registered, clauses=(*self.clauses, clause))

    def _literal(self, comparison: Comparison) -> tuple[Ratio, tuple[int, ...]]:
        difference = self.algebra.entry(comparison.left) - self.algebra.entry(comparison.right)
        return difference, _wanted(comparison.kind, holds=comparison.holds)

    def _is_open(self, clause: tuple[tuple[Ratio, tuple[int, ...]], ...]) -> bool:
        """Whether some comparison of the clause can still come out false."""
        return any(set(self.of(difference)) - set(signs) for difference, signs in clause)

    def _find(self, difference: Ratio) -> tuple[int, int] | None:
        """Where the difference or its opposite is known, and which of the two."""
        for same in (_is_zero, self.algebra.vanishes):
            for place, (known, _) in enumerate(self.known):
                if same(known - difference):
                    return place, 1
                if same(known + difference):
                    return place, -1
        return None


def _is_zero(ratio: Ratio) -> bool:
    return ratio.is_zero


def _wanted(kind: str, *, holds: bool) -> tuple[int, ...]:
    signs = (-1,) if kind == "less" else (0,)
    return signs if holds else tuple(sign for sign in ALL if sign not in signs)
