"""Verdicts by cases: each case is decided by itself, and together they are all that is possible."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.from_sympy.atoms import QuantityNames
from chasles.from_sympy.cases import SplitCase
from chasles.from_sympy.complexes import OF_COMPLEX
from chasles.from_sympy.defined import Pairs, WithoutDefined, put, without_defined
from chasles.from_sympy.divisors import divisor_of
from chasles.from_sympy.general import is_numeric, is_root_of_number
from chasles.from_sympy.generalising import Decide, generalised
from chasles.from_sympy.opening import Entries, atoms_of, opened, sides
from chasles.from_sympy.remainders import at_integer, modulus_of
from chasles.from_sympy.sampling import Sampling, exactly
from chasles.from_sympy.side_conditions import listed, nonvanishing
from chasles.from_sympy.switches import powers_in, switches_in
from chasles.problems.variables import Untreatable
from chasles.verdict import Counterexample, Fails, Holds, HoldsUnder, Undecided, Verdict

MOST = 100
UNREADABLE = (sympy.Max, sympy.Min, sympy.Piecewise, sympy.Heaviside, sympy.sign)
RELATIONS = (" != 0", " > 0", " >= 0")


@dataclass(slots=True)
class Splitting:
    """A question by cases, each of which is decided by `decide`."""

    lhs: Any
    rhs: Any
    given: Any
    nonzero: Any
    decide: Decide
    needs: dict[str, None] = field(default_factory=dict)
    _left: Entries = field(init=False)
    _right: Entries = field(init=False)
    _pairs: list[tuple[Any, Any]] = field(init=False)
    _declared: list[Any] = field(init=False)
    _texts: list[str] = field(init=False)
    _cases: int = 0
    _refused: Untreatable | None = None
    _less: WithoutDefined | None = None

    def __post_init__(self) -> None:
        self._left, self._right = opened(self.lhs, "the left side"), opened(self.rhs, "the right side")
        items = listed(self.given, "given")
        self._pairs = [pair for what, item in items for pair in sides(item, what)]
        self._texts = [str(item) if not isinstance(item, sympy.Eq) else f"{item.lhs} = {item.rhs}" for _, item in items]
        self._declared = list(nonvanishing(self.nonzero))
        known = QuantityNames()
        for atom in (atom for e in self.spoken for atom in atoms_of(e)):
            known.word(atom)

    @property
    def spoken(self) -> tuple[Any, ...]:
        """Everything of which the question speaks."""
        entries = (e for side in (self._left, self._right) for row in side.rows for e in row)
        return (*entries, *(side for pair in self._pairs for side in pair), *self._declared)

    def states(self, texts: Iterable[str]) -> bool:
        """Whether all of this is said by the question itself."""
        return {*texts} <= {*self._texts, *(f"{e} != 0" for e in self._declared)}

    @property
    def wanted(self) -> bool:
        """Whether something is spoken of that is treated by cases alone, or numbers that are treated by themselves."""
        powers = {part for e in self.spoken for part in e.atoms(sympy.Pow)}
        roots = any(map(is_root_of_number, powers)) and all(map(is_numeric, powers))
        return (roots or self._switched) and self.possible

    @property
    def _switched(self) -> bool:
        """Whether something has other forms in other cases."""
        return bool(switches_in(self.spoken, *UNREADABLE) or modulus_of(self.spoken))

    @property
    def readable(self) -> bool:
        """Whether the question is also treated as a whole."""
        unreadable = (kind for kind in UNREADABLE if kind is not sympy.sign)
        return not (switches_in(self.spoken, *unreadable) or modulus_of(self.spoken))

    @property
    def possible(self) -> bool:
        """Whether the question is one of real numbers."""
        return self._left.shape == self._right.shape and not any(e.has(*OF_COMPLEX) for e in self.spoken)

    def verdict(self) -> Verdict:
        """`Holds` or `HoldsUnder` if it is proved as a whole or in every case, `Fails` with a point, or `Undecided`."""
        still = not any(e.has(AppliedUndef) for pair in self._pairs for e in pair)
        sampling = Sampling(self._left, self._right, self._left.shape[0], self._pairs, self._declared, still=still)
        whole = SplitCase(tuple(map(at_integer, self.spoken)))
        self._require(whole, within=False)
        switched = self._switched
        tree = self._proved(whole) if switched else self._decided(whole)
        if tree is None and not switched and switches_in(self.spoken):
            tree = self._proved(whole)
        if tree is None:
            found = sampling.counterexample() or self._refuted()
            if found is None and self._refused is not None:
                raise self._refused
            return Fails(found) if found else Undecided("a remainder is left, and no counterexample was found")
        witness = self._witness(sampling)
        if witness is None:
            return Undecided("it follows from its hypotheses, but no point was found that satisfies them all")
        needs = (*self._texts, *self.needs)
        said = {str(name): str(value) for name, value in witness.items()}
        certificate = {**tree, "witness": said}
        return HoldsUnder(tuple(needs), certificate, witness) if needs else Holds(certificate, witness)

    def _proved(self, case: SplitCase) -> Mapping[str, Any] | None:
        """The certificates of a case's cases; None if one is not proved."""
        if case.excluded:
            self.needs[case.excluded] = None
        if case.excluded or not case.possible:
            return {"impossible": True}
        turning = modulus_of(case.spoken)
        if turning:
            symbol, modulus = turning
            name = self._fresh("k")
            by_remainder = self._each(case.split_by_remainder(symbol, modulus, name))
            return by_remainder and {"remainders": [str(symbol), modulus, name], **by_remainder}
        case = case.settled()
        if self._contradicts(case):
            return {"impossible": True}
        if case.vanishing:
            if not case.zeros:
                return None
            self.needs[f"{case.zeros[-1]} != 0"] = None
            return {"impossible": True}
        factor = case.open
        if factor is None:
            return self._decided(case)
        name = self._fresh("d")
        by_sign = self._each(case.split(factor, sympy.Symbol(name, positive=True)))
        return by_sign and {"on": str(factor), "size": name, **by_sign}

    def _each(self, cases: Mapping[str, SplitCase]) -> dict[str, Any] | None:
        """The certificates of some cases by their names; None if one is not proved, or there are too many."""
        self._cases += len(cases) - 1
        if self._cases > MOST:
            return None
        parts: dict[str, Any] = {}
        for name, case in cases.items():
            found = self._proved(case)
            if found is None:
                return None
            parts[name] = found
        return {"cases": parts}

    def _fresh(self, letter: str) -> str:
        names = {str(s) for e in self.spoken for s in e.free_symbols}
        self._cases += 1
        number = self._cases
        while f"{letter}_{number}" in names:
            number += MOST
        return f"{letter}_{number}"

    def _contradicts(self, case: SplitCase) -> bool:
        """Whether two sides that are given to be equal visibly differ."""
        size = 2 * self._left.shape[0] * self._left.shape[1]
        flat = iter(case.spoken[size : size + 2 * len(self._pairs)])
        pairs = [*zip(flat, flat, strict=True), *((e, sympy.S.Zero) for e in case.equations)]
        return any(case.sign(one - other) in (1, -1) or (one - other).is_odd for one, other in pairs)

    def _require(self, case: SplitCase, within: bool) -> None:
        """State what divisors and radicands need, where it is not seen in this case whether it holds."""
        for power in powers_in(self.spoken, within):
            sign, root = case.sign_here(power.base), not power.exp.is_Integer
            if within and (sign == 0 or (root and sign == -1)):
                continue
            if power.exp < 0 and sign not in (1, -1):
                self.needs[divisor_of(power.base).text] = None
            if root and sign not in (0, 1) and not power.base.is_nonnegative:
                self.needs[f"{power.base} >= 0"] = None

    def _decided(self, case: SplitCase) -> Mapping[str, Any] | None:
        self._require(case, within=True)
        spoken, given = self._apart(case.spoken)
        given += [(e, sympy.S.Zero) for e in case.equations]
        less = without_defined(spoken, given)
        moving = any(isinstance(atom, AppliedUndef) for atom in less.values)
        # What moves is proved where it has its value first: the witness is then a point of a motion.
        found = None if moving else self._generalised(case, spoken, given)
        if found is None and less.values:
            found = self._generalised(case, less.spoken, less.given)
            if found is not None:
                found["defined"] = [list(place) for place in less.places]
                self._less = less if not case.path else None
        return self._generalised(case, spoken, given) if found is None and moving else found

    def _witness(self, sampling: Sampling) -> Mapping[str, Any] | None:
        """A point at which all conditions hold; what is defined has its value there, and so have its rates."""
        less = self._less
        if less is None:
            return sampling.point()
        everything = {atom: atom for e in self.spoken for atom in atoms_of(e)}
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
        spoken, given = self._apart(self.spoken)
        less = without_defined(spoken, given, AppliedUndef)
        times = {t for pair in self._pairs for e in pair for call in e.atoms(AppliedUndef) for t in call.args}
        if not less.values or any(e.has(AppliedUndef) or e.free_symbols & times for pair in less.given for e in pair):
            return None
        height, width = self._left.shape
        rows = [tuple(less.spoken[k : k + width]) for k in range(0, 2 * height * width, width)]
        left, right = (Entries(tuple(part), self._left.is_matrix) for part in (rows[:height], rows[height:]))
        return Sampling(left, right, height, less.given, less.spoken[2 * height * width :]).counterexample()

    def _apart(self, spoken: Sequence[Any]) -> tuple[list[Any], Pairs]:
        """The sides and scalars that do not vanish, and the pairs of what is given, of all that is spoken of."""
        size, pairs = 2 * self._left.shape[0] * self._left.shape[1], 2 * len(self._pairs)
        flat = iter(spoken[size : size + pairs])
        return [*spoken[:size], *spoken[size + pairs :]], list(zip(flat, flat, strict=True))

    def _generalised(self, case: SplitCase, spoken: list[Any], given: Pairs) -> dict[str, Any] | None:
        """The certificate of a case with these sides and scalars that do not vanish, and this given."""
        size = self._left.shape[0] * self._left.shape[1]
        try:
            proved = generalised(spoken[:size], spoken[size : 2 * size], given, spoken[2 * size :], self.decide)
        except Untreatable as error:
            self._refused = self._refused or error
            return None
        return {**proved.certificate} if proved and all(self._need(case, text) for text in proved.needs) else None

    def _need(self, case: SplitCase, text: str) -> bool:
        """State a need of a case in the symbols of the question, unless it holds throughout the case."""
        relation = next((relation for relation in RELATIONS if text.endswith(relation)), None)
        if relation is None:
            return False
        names = {str(s): s for e in case.spoken for s in e.free_symbols}
        try:
            said = sympy.sympify(text.removesuffix(relation), locals=names)
        except (sympy.SympifyError, TypeError):
            return False
        if not said.free_symbols and case.sign(said) in ((1, -1) if relation == " != 0" else (1,)):
            return True
        if not said.free_symbols & {symbol for symbol, _ in case.path}:
            self.needs[text] = None
        elif case.sign(said) not in (1, -1):
            self.needs[f"{case.back(said)}{relation}"] = None
        return True
