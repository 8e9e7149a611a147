"""A certificate made of those of cases, down to cases that are proved as asked, or by a more general question."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.algebra.work_limit import check
from chasles.checker.expressions.cases import CheckedCase
from chasles.checker.expressions.switches import deciding
from chasles.checker.expressions.widened import holds_throughout, said_need
from chasles.checker.sparse import Rejected
from chasles.from_sympy.defined import Pairs, WithoutDefined, values_put_in
from chasles.from_sympy.generalising import Decide, generalised
from chasles.from_sympy.remainders import modulus_of
from chasles.problems.variables import Untreatable

MOST, MOST_PARTS = 100, 2_500
"""So many cases are looked at, and so many parts of expressions in these."""


@dataclass(slots=True)
class ProofByCases:
    """Proofs of cases, in which new symbols have none of the `names`; what they need is added to `needs`.

    Afterwards `refused` says what was not treated first, and `less` what was put in for quantities that are defined.
    """

    decide: Decide
    names: set[str]
    needs: dict[str, None] = field(default_factory=dict)
    refused: Untreatable | None = None
    less: WithoutDefined | None = None
    _cases: int = 0
    _parts: int = 0

    def of(
        self, case: CheckedCase, factors: Sequence[Any] | None = None, named: bool = False
    ) -> Mapping[str, Any] | None:
        """The certificates of a case's cases; None if one is not proved.

        The cases are those of the signs of some factors, one after the other, or of what decides the forms, the size
        of which is `named` in equations, too.
        """
        check()
        if case.lost:
            self.needs[case.lost] = None
        if case.lost or case.impossible:
            return {"impossible": True}
        case = case.settled()
        if case.impossible:
            return {"impossible": True}
        if case.undefined:
            if not case.zeros:
                return None
            self.needs[f"{case.zeros[-1]} != 0"] = None
            return {"impossible": True}
        turning = modulus_of(case.spoken)
        if turning:
            by = str(turning[0]), turning[1], self._fresh("k")
            by_remainder = self._each(case.split_by_remainder(*by), factors, named)
            return by_remainder and {"remainders": [*by], **by_remainder}
        open_ = case.switches()
        here = sorted((sympy.expand(case.here(e)) for e in factors or ()), key=lambda e: len(e.free_symbols))
        claimed = [part.args[0] for part in open_ if named and isinstance(part, sympy.Abs | sympy.sign)]
        said = claimed or (deciding(open_) if factors is None else here)
        factor = next((e for e in said if case.sign(e) is None), None) if open_ else None
        if factor is None:
            before, found = {*self.needs}, self.decided(case)
            # Of a form that is left open, it would be needed where its sign is zero that it is not.
            return found if factors is None or not open_ or self.needs.keys() <= before else None
        size = self._fresh("d")
        by_sign = self._each(case.split(factor, size, named), factors, named)
        return by_sign and {"on": str(factor), "size": size, **({"named": True} if named else {}), **by_sign}

    def _each(
        self, cases: Mapping[str, CheckedCase], factors: Sequence[Any] | None, named: bool
    ) -> dict[str, Any] | None:
        """The certificates of some cases by their names; None if one is not proved, or there are too many."""
        self._cases += len(cases) - 1
        self._parts += sum(1 for case in cases.values() for e in case.spoken for _ in sympy.preorder_traversal(e))
        if self._cases > MOST or self._parts > MOST_PARTS:
            return None
        parts: dict[str, Any] = {}
        for name, case in cases.items():
            found = self.of(case, factors, named)
            if found is None:
                return None
            parts[name] = found
        return {"cases": parts}

    def _fresh(self, letter: str) -> str:
        self._cases += 1
        number = self._cases
        while f"{letter}_{number}" in self.names:
            number += MOST
        return f"{letter}_{number}"

    def decided(self, case: CheckedCase) -> Mapping[str, Any] | None:
        """The certificate of a case that is decided as it is; None if it is not proved."""
        self.needs |= dict.fromkeys(ways[0] for ways in case.required_inside())
        spoken = [*case.sides[0], *case.sides[1], *case.nonzero]
        given = [*case.pairs, *((e, sympy.S.Zero) for e in case.equations)]
        less = values_put_in(spoken, given)
        moving = any(isinstance(atom, AppliedUndef) for atom in less.values)
        # What moves is proved where it has its value first: the witness is then a point of a motion.
        found = None if moving else self._generalised(case, spoken, given)
        if found is None and less.values:
            found = self._generalised(case, less.spoken, less.given)
            if found is not None:
                found["defined"] = [list(place) for place in less.places]
                self.less = less if not case.meant else None
        return self._generalised(case, spoken, given) if found is None and moving else found

    def _generalised(self, case: CheckedCase, spoken: list[Any], given: Pairs) -> dict[str, Any] | None:
        """The certificate of a case with these sides and scalars that do not vanish, and this given."""
        size = len(case.sides[0])
        try:
            proved = generalised(spoken[:size], spoken[size : 2 * size], given, spoken[2 * size :], self.decide)
        except Untreatable as error:
            self.refused = self.refused or error
            return None
        return {**proved.certificate} if proved and all(self._need(case, text) for text in proved.needs) else None

    def _need(self, case: CheckedCase, text: str) -> bool:
        """State a need of a case in the symbols of the question, unless it holds throughout the case."""
        need = read_need(text, case)
        if need is None:
            return False
        if holds_throughout(case, *need, self.needs) is None:
            said, relation = need
            in_question = not said.free_symbols & {symbol for symbol, _ in case.meant}
            self.needs[text if in_question else f"{case.back(said)} {relation} 0"] = None
        return True


def read_need(text: str, case: CheckedCase) -> tuple[Any, str] | None:
    """What a need speaks of and what it says of that; None for one that is not read."""
    with suppress(Rejected, sympy.SympifyError, TypeError):
        return said_need(text, case.named)
    return None
