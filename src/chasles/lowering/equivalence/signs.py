"""What is known of the signs of differences on one way through a program's cases."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from dataclasses import replace as with_fields

from chasles.algebra.localization import Ratio
from chasles.algebra.rings import Polynomial
from chasles.lowering.cases import Case, Comparison
from chasles.lowering.equivalence.algebra import Algebra

ALL = (-1, 0, 1)
Literal = tuple[Ratio, tuple[int, ...]]


class Fork(Exception):
    """A comparison comes out either way: each way is to be looked at."""

    def __init__(self, difference: Ratio, wanted: tuple[int, ...]) -> None:
        super().__init__("a comparison that is not settled")
        self.difference = difference
        self.wanted = wanted


class Impossible(Exception):
    """What the comparisons say contradicts what is known."""


class Differences:
    """The differences whose signs are asked for, each once, however it is written; opposite ones are one."""

    def __init__(self, algebra: Algebra) -> None:
        self.algebra = algebra
        self.ratios: list[Ratio] = []
        # What the cases compare is taken as it is written; only what a program compares is looked for among it.
        self.is_thorough = False
        self._seen: list[tuple[Ratio, int, int]] = []

    def find(self, difference: Ratio) -> tuple[int, int]:
        """The number of a difference, and 1, or -1 if it is the opposite of that one."""
        for known, number, turn in self._seen:
            if known.denominator == difference.denominator and known.numerator == difference.numerator:
                return number, turn
        number, turn = self._match(self.algebra.reduced(difference))
        self._seen.append((difference, number, turn))
        return number, turn

    def _match(self, difference: Ratio) -> tuple[int, int]:
        """The same for a difference in normal form; those over the same denominators are looked at first."""
        alike = [k for k, known in enumerate(self.ratios) if known.denominator == difference.denominator]
        for number in alike:
            for turned, turn in ((difference, 1), (-difference, -1)):
                if self.ratios[number].numerator == turned.numerator:
                    return number, turn
        for number, known in enumerate(self.ratios):
            if number in alike or not self.is_thorough:
                continue
            for turned, turn in ((difference, 1), (-difference, -1)):
                if self.algebra.vanishes(known - turned):
                    return number, turn
        self.ratios.append(difference)
        return len(self.ratios) - 1, 1


@dataclass(frozen=True, slots=True)
class Signs:
    """For each difference the signs that it can have; of the comparisons of a clause at least one comes out false."""

    differences: Differences
    known: Mapping[int, tuple[int, ...]] = field(default_factory=dict)
    clauses: tuple[tuple[Literal, ...], ...] = ()

    @property
    def zeros(self) -> tuple[Polynomial, ...]:
        """What is known to be zero."""
        return tuple(self.differences.ratios[k].numerator for k, signs in self.known.items() if signs == (0,))

    @property
    def is_possible(self) -> bool:
        """Whether every difference has a sign left, and no case that was passed over applies."""
        return all(self.known.values()) and all(map(self._is_open, self.clauses))

    def is_zero(self, ratio: Ratio) -> bool:
        """Whether a fraction is known to be zero; raises `Impossible` where it is one that is not."""
        is_zero = ratio.is_zero or ((0,) in self.known.values() and self.of(ratio) == (0,))
        if is_zero and self.differences.algebra.is_unit(ratio):
            raise Impossible
        return is_zero

    def of(self, difference: Ratio) -> tuple[int, ...]:
        """The signs that a difference can have."""
        value = self.differences.algebra.number(difference)
        if value is not None:
            return ((value > 0) - (value < 0),)
        number, turn = self.differences.find(difference)
        return tuple(sorted(sign * turn for sign in self.known.get(number, ALL)))

    def truth(self, kind: str, difference: Ratio) -> bool:
        """Whether a difference is negative ("less") or zero ("equal"); raises `Fork` where that is not settled."""
        wanted = _wanted(kind, holds=True)
        signs = self.of(difference)
        if set(signs) <= set(wanted):
            return True
        if not set(signs) & set(wanted):
            return False
        if kind == "equal":
            is_new = self.differences.find(difference)[0] not in self.known
            algebra = self.differences.algebra
            if algebra.is_unit(difference) or (is_new and algebra.cannot_vanish(difference)):
                return False
        raise Fork(difference, wanted)

    def forked(self, fork: Fork) -> Iterator[Signs]:
        """The two ways in which a comparison that is not settled can come out."""
        for signs in (fork.wanted, tuple(sign for sign in ALL if sign not in fork.wanted)):
            settled = self.knowing(fork.difference, signs)
            if settled.is_possible:
                yield settled

    def knowing(self, difference: Ratio, signs: tuple[int, ...]) -> Signs:
        """What is known once the difference has one of the given signs."""
        left = tuple(sign for sign in self.of(difference) if sign in signs)
        if self.differences.algebra.number(difference) is not None:
            # Two numbers that compare the other way make the whole way impossible: nothing is left for an empty clause.
            return self if left else with_fields(self, clauses=(*self.clauses, ()))
        number, turn = self.differences.find(difference)
        return with_fields(self, known={**self.known, number: tuple(sorted(sign * turn for sign in left))})

    def in_case(self, case: Case) -> Signs:
        """What is known where the case applies."""
        signs = self
        for comparison in case.where:
            signs = signs.knowing(*signs._literal(comparison))
        return signs

    def not_in_case(self, case: Case) -> Signs:
        """What is known where the case does not apply."""
        clause = tuple(map(self._literal, case.where))
        if len(clause) == 1:
            difference, signs = clause[0]
            return self.knowing(difference, tuple(sign for sign in ALL if sign not in signs))
        registered = self
        for difference, _ in clause:
            registered = registered.knowing(difference, ALL)
        return with_fields(registered, clauses=(*self.clauses, clause))

    def _literal(self, comparison: Comparison) -> Literal:
        entry = self.differences.algebra.entry
        return entry(comparison.left) - entry(comparison.right), _wanted(comparison.kind, holds=comparison.holds)

    def _is_open(self, clause: tuple[Literal, ...]) -> bool:
        """Whether some comparison of the clause can still come out false."""
        return any(set(self.of(difference)) - set(signs) for difference, signs in clause)


def _wanted(kind: str, *, holds: bool) -> tuple[int, ...]:
    signs = (-1,) if kind == "less" else (0,)
    return signs if holds else tuple(sign for sign in ALL if sign not in signs)
