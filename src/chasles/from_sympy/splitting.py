"""Verdicts by cases: each case is decided by itself, and together they are all that is possible."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import partial
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.checker.expressions.cases import CheckedCase
from chasles.checker.expressions.defined_functions import VALUED
from chasles.checker.expressions.generalised import is_numeric, is_root_of_number
from chasles.checker.expressions.readings import at_integer
from chasles.checker.expressions.switches import deciding
from chasles.checker.expressions.widened import holds_throughout, put, said_need
from chasles.checker.sparse import Rejected
from chasles.from_sympy.atoms import QuantityNames
from chasles.from_sympy.by_squares import by_squares
from chasles.from_sympy.complex_symbols import taken_as_real
from chasles.from_sympy.complexes import RealParts, in_rows
from chasles.from_sympy.defined import Pairs, WithoutDefined, values_put_in
from chasles.from_sympy.generalising import Decide, generalised
from chasles.from_sympy.opening import Entries, atoms_of, opened, sides
from chasles.from_sympy.remainders import modulus_of
from chasles.from_sympy.sampling import Sampling, exactly
from chasles.from_sympy.side_conditions import listed, nonvanishing
from chasles.from_sympy.thresholds import thresholds
from chasles.problems.variables import Untreatable
from chasles.prover.certifying import proved
from chasles.verdict import Counterexample, Fails, Undecided, Verdict

MOST, MOST_PARTS = 100, 2_500
"""So many cases are looked at, and so many parts of expressions in these."""
UNREADABLE = (sympy.Max, sympy.Min, sympy.Piecewise, sympy.Heaviside, sympy.sign, *VALUED)


@dataclass(slots=True)
class Splitting:
    """A question by cases, each of which is decided by `decide`; `possible` says whether its sides are of one shape."""

    lhs: Any
    rhs: Any
    given: Any
    nonzero: Any
    decide: Decide
    needs: dict[str, None] = field(default_factory=dict)
    possible: bool = field(init=False)
    _rows: int = field(init=False)
    _left: Entries = field(init=False)
    _right: Entries = field(init=False)
    _whole: CheckedCase = field(init=False)
    _texts: list[str] = field(init=False)
    _met: tuple[Any, ...] = field(init=False)
    _cases: int = 0
    _parts: int = 0
    _refused: Untreatable | None = None
    _less: WithoutDefined | None = None

    def __post_init__(self) -> None:
        self._left, self._right = opened(self.lhs, "the left side"), opened(self.rhs, "the right side")
        self.possible, self._rows = self._left.shape == self._right.shape, self._left.shape[0]
        parts = RealParts()
        parts.require([self.lhs, self.rhs, self.given, self.nonzero])
        self._left, self._right = parts.equal(self._left, self._right)
        declared = tuple(map(parts.nonzero, nonvanishing(self.nonzero)))
        items = listed(self.given, "given")
        self._texts = [str(item) if not isinstance(item, sympy.Eq) else f"{item.lhs} = {item.rhs}" for _, item in items]
        sides_ = tuple((*(e for row in side.rows for e in row), *parts.met) for side in (self._left, self._right))
        pairs = tuple(found for what, item in items for pair in sides(item, what) for found in parts.pairs(*pair))
        self._whole = CheckedCase(sides_, pairs, declared)
        self._met = tuple(parts.met)
        known = QuantityNames()
        for atom in (atom for e in self._whole.spoken for atom in atoms_of(e)):
            known.word(atom)

    def states(self, texts: Iterable[str]) -> bool:
        """Whether all of this is said by the question itself."""
        return {*texts} <= {*self._texts, *(f"{e} != 0" for e in self._whole.nonzero)}

    @property
    def wanted(self) -> bool:
        """Whether something is spoken of that is treated by cases alone, or numbers that are treated by themselves."""
        powers = {part for e in self._whole.spoken for part in e.atoms(sympy.Pow)}
        roots = any(map(is_root_of_number, powers)) and all(map(is_numeric, powers))
        return (roots or self._switched() or self._is_bound()) and self.possible

    def _is_bound(self) -> bool:
        """Whether it is claimed of something that it is not negative, where something is given."""
        (one, *_), (other, *_) = self._whole.sides
        return bool(self._whole.pairs) and isinstance(one, sympy.Abs) and sympy.expand(one.args[0] ** 2 - other**2) == 0

    def _switched(self, kinds: tuple[type, ...] = UNREADABLE) -> bool:
        """Whether something has other forms in other cases, of these kinds or by the remainder of an integer."""
        return any(e.has(*kinds) for e in self._whole.spoken) or modulus_of(self._whole.spoken) is not None

    @property
    def readable(self) -> bool:
        """Whether the question is also treated as a whole."""
        return not self._switched(tuple(kind for kind in UNREADABLE if kind is not sympy.sign))

    def verdict(self, refuting: bool = True) -> Verdict:
        """`Holds` or `HoldsUnder` if it is proved as a whole or in every case, `Fails` with a point, or `Undecided`."""
        whole = self._whole
        still = not any(e.has(AppliedUndef) for pair in whole.pairs for e in pair)
        sampling = Sampling(self._left, self._right, self._rows, whole.pairs, whole.nonzero, self._met, still)
        self.needs |= dict.fromkeys(taken_as_real((self.lhs, self.rhs, self.given, self.nonzero)))
        self.needs |= dict.fromkeys(ways[0] for ways in whole.required())
        whole, before = whole.each(partial(at_integer, put={})), {**self.needs}
        switched = self._switched()
        tree = self._proved(whole) if switched else self._decided(whole)
        if tree is None and not switched and whole.switches():
            tree = self._proved(whole)
        found = None if tree or not refuting else sampling.counterexample() or self._refuted()
        if tree is None and found is None:
            self.needs, factors = {**before}, thresholds(whole)
            tree = self._proved(whole, factors) if factors else None
        if tree is None and found is None and whole.switches():
            self.needs, self.decide = {**before}, by_squares(self.decide)
            tree = self._proved(whole, named=True)
        if tree is None:
            if found is None and self._refused is not None:
                raise self._refused
            return Fails(found) if found else Undecided("a remainder is left, and no counterexample was found")
        said_needs = [need for text in self.needs if (need := self._read(text, self._whole))]
        apart = (*whole.nonzero, *(e for e, relation in said_needs if relation != ">="))
        real = (*self._met, *(sympy.sqrt(e) for e, relation in said_needs if relation != "!="))
        sampling = Sampling(self._left, self._right, self._rows, whole.pairs, apart, real, still)
        witness = self._witness(sampling)
        if witness is None:
            return Undecided("it follows from its hypotheses, but no point was found that satisfies them all")
        needs = (*self._texts, *self.needs)
        said = {str(name): str(value) for name, value in witness.items()}
        certificate = {**tree, "witness": said}
        return proved(tuple(needs), certificate, witness)

    def _proved(
        self, case: CheckedCase, factors: Sequence[Any] | None = None, named: bool = False
    ) -> Mapping[str, Any] | None:
        """The certificates of a case's cases; None if one is not proved.

        The cases are those of the signs of some factors, one after the other, or of what decides the forms, the size
        of which is `named` in equations, too.
        """
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
            return self._decided(case) if factors is None or not open_ else None
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
            found = self._proved(case, factors, named)
            if found is None:
                return None
            parts[name] = found
        return {"cases": parts}

    def _fresh(self, letter: str) -> str:
        self._cases += 1
        number = self._cases
        while f"{letter}_{number}" in self._whole.names:
            number += MOST
        return f"{letter}_{number}"

    def _decided(self, case: CheckedCase) -> Mapping[str, Any] | None:
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
                self._less = less if not case.meant else None
        return self._generalised(case, spoken, given) if found is None and moving else found

    def _witness(self, sampling: Sampling) -> Mapping[str, Any] | None:
        """A point at which all conditions hold; what is defined has its value there, and so have its rates."""
        less = self._less
        if less is None:
            return sampling.point()
        everything = {atom: atom for e in self._whole.spoken for atom in atoms_of(e)}
        for defined, value in less.values.items():
            everything = {atom: put(e, defined, value) for atom, e in everything.items()}
        nothing = Entries(((sympy.S.Zero,),), is_matrix=False)
        found = Sampling(nothing, nothing, 1, less.given, (), [*less.spoken, *everything.values()]).point()
        if found is None:
            return None
        known = {atom: sympy.sympify(found[str(atom)]) for e in everything.values() for atom in atoms_of(e)}
        return {str(atom): exactly(e.xreplace(known)) for atom, e in everything.items()}

    def _refuted(self) -> Counterexample | None:
        """A point at which the sides differ where every function of which something is given has its value."""
        whole = self._whole
        spoken = [*whole.sides[0], *whole.sides[1], *whole.nonzero]
        less = values_put_in(spoken, list(whole.pairs), AppliedUndef)
        times = {t for pair in whole.pairs for e in pair for call in e.atoms(AppliedUndef) for t in call.args}
        if not less.values or any(e.has(AppliedUndef) or e.free_symbols & times for pair in less.given for e in pair):
            return None
        size, count = len(whole.sides[0]), len(whole.sides[0]) - len(self._met)
        said = [less.spoken[:size], less.spoken[size : 2 * size]]
        left, right = (in_rows(side[:count], self._left) for side in said)
        met = said[0][count:]
        return Sampling(left, right, self._rows, less.given, less.spoken[2 * size :], met).counterexample()

    def _generalised(self, case: CheckedCase, spoken: list[Any], given: Pairs) -> dict[str, Any] | None:
        """The certificate of a case with these sides and scalars that do not vanish, and this given."""
        size = len(case.sides[0])
        try:
            proved = generalised(spoken[:size], spoken[size : 2 * size], given, spoken[2 * size :], self.decide)
        except Untreatable as error:
            self._refused = self._refused or error
            return None
        return {**proved.certificate} if proved and all(self._need(case, text) for text in proved.needs) else None

    def _need(self, case: CheckedCase, text: str) -> bool:
        """State a need of a case in the symbols of the question, unless it holds throughout the case."""
        need = self._read(text, case)
        if need is None:
            return False
        if holds_throughout(case, *need, self.needs) is None:
            said, relation = need
            in_question = not said.free_symbols & {symbol for symbol, _ in case.meant}
            self.needs[text if in_question else f"{case.back(said)} {relation} 0"] = None
        return True

    def _read(self, text: str, case: CheckedCase) -> tuple[Any, str] | None:
        """What a need speaks of and what it says of that; None for one that is not read."""
        with suppress(Rejected, sympy.SympifyError, TypeError):
            return said_need(text, case.named)
        return None
