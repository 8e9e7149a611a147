"""Verdicts by cases: each case is decided by itself, and together they are all that is possible.

Cases are those of signs; where something may change its sign tells into which a question is divided.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import partial
from itertools import accumulate, permutations
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.checker.expressions.cases import CheckedCase
from chasles.checker.expressions.defined_functions import VALUED
from chasles.checker.expressions.enclosed import sign_of_number
from chasles.checker.expressions.generalised import is_numeric, is_root_of_number
from chasles.checker.expressions.readings import at_integer
from chasles.checker.expressions.switches import visible_signs
from chasles.checker.expressions.widened import put
from chasles.from_sympy.atoms import QuantityNames
from chasles.from_sympy.by_squares import by_squares
from chasles.from_sympy.complex_symbols import RealParts, in_rows, taken_as_real
from chasles.from_sympy.defined import values_put_in
from chasles.from_sympy.generalising import Decide
from chasles.from_sympy.given import text_of
from chasles.from_sympy.opening import Entries, atoms_of, opened, sides
from chasles.from_sympy.proof_by_cases import ProofByCases, read_need
from chasles.from_sympy.remainders import modulus_of
from chasles.from_sympy.sampling import Sampling, exactly
from chasles.from_sympy.side_conditions import listed, nonvanishing
from chasles.prover.certifying import proved
from chasles.verdict import Counterexample, Fails, Undecided, Verdict

UNREADABLE = (sympy.Max, sympy.Min, sympy.Piecewise, sympy.Heaviside, sympy.sign, *VALUED)
FRACTIONS = map(sympy.Rational, ("0", "1", "1/2", "2", "1/4", "4", "1/3", "3"))
NUMBERS = [
    side * n for n in (*FRACTIONS, sympy.E, sympy.exp(-1), sympy.pi / 2, sympy.pi) for side in ((1, -1) if n else (1,))
]
FAR = 4
MOST_NUMBERS, MOST_SYMBOLS, MOST_TERMS = 3, 3, 60
CALLED = (sympy.exp, sympy.sin, sympy.cos, sympy.sinh, sympy.cosh, sympy.tanh, sympy.atan)


@dataclass(slots=True)
class Splitting:
    """A question by cases, each of which is decided by `decide`; `possible` says whether its sides are of one shape."""

    lhs: Any
    rhs: Any
    given: Any
    nonzero: Any
    decide: Decide
    possible: bool = field(init=False)
    _rows: int = field(init=False)
    _left: Entries = field(init=False)
    _right: Entries = field(init=False)
    _whole: CheckedCase = field(init=False)
    _texts: list[str] = field(init=False)
    _met: tuple[Any, ...] = field(init=False)
    _proof: ProofByCases = field(init=False)

    def __post_init__(self) -> None:
        self._left, self._right = opened(self.lhs, "the left side"), opened(self.rhs, "the right side")
        self.possible, self._rows = self._left.shape == self._right.shape, self._left.shape[0]
        parts = RealParts()
        parts.require([self.lhs, self.rhs, self.given, self.nonzero])
        self._left, self._right = parts.equal(self._left, self._right)
        declared = tuple(map(parts.nonzero, nonvanishing(self.nonzero)))
        items = listed(self.given, "given")
        self._texts = [text_of(item, what) for what, item in items]
        sides_ = tuple((*(e for row in side.rows for e in row), *parts.met) for side in (self._left, self._right))
        pairs = tuple(found for what, item in items for pair in sides(item, what) for found in parts.pairs(*pair))
        self._whole = CheckedCase(sides_, pairs, declared)
        self._met = tuple(parts.met)
        self._proof = ProofByCases(self.decide, self._whole.names)
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
        whole, proof = self._whole, self._proof
        still = not any(e.has(AppliedUndef) for pair in whole.pairs for e in pair)
        sampling = Sampling(self._left, self._right, self._rows, whole.pairs, whole.nonzero, self._met, still)
        proof.needs |= dict.fromkeys(taken_as_real((self.lhs, self.rhs, self.given, self.nonzero)))
        proof.needs |= dict.fromkeys(ways[0] for ways in whole.required())
        whole, before = whole.each(partial(at_integer, put={})), {**proof.needs}
        switched = self._switched()
        tree = proof.of(whole) if switched else proof.decided(whole)
        if tree is None and not switched and whole.switches():
            tree = proof.of(whole)
        found = None if tree or not refuting else sampling.counterexample() or self._refuted()
        if tree is None and found is None:
            proof.needs, factors = {**before}, thresholds(whole)
            tree = proof.of(whole, factors) if factors else None
            found = self._refuted_at(factors) if tree is None and refuting and still else None
        if tree is None and found is None and whole.switches():
            proof.needs, proof.decide = {**before}, by_squares(proof.decide)
            tree = proof.of(whole, named=True)
        if tree is None:
            if found is None and proof.refused is not None:
                raise proof.refused
            return Fails(found) if found else Undecided("a remainder is left, and no counterexample was found")
        said_needs = [need for text in proof.needs if (need := read_need(text, self._whole))]
        apart = (*whole.nonzero, *(e for e, relation in said_needs if relation != ">="))
        real = (*self._met, *(sympy.sqrt(e) for e, relation in said_needs if relation != "!="))
        sampling = Sampling(self._left, self._right, self._rows, whole.pairs, apart, real, still)
        witness = self._witness(sampling)
        if witness is None:
            return Undecided("it follows from its hypotheses, but no point was found that satisfies them all")
        needs = (*self._texts, *proof.needs)
        said = {str(name): str(value) for name, value in witness.items()}
        certificate = {**tree, "witness": said}
        return proved(tuple(needs), certificate, witness)

    def _witness(self, sampling: Sampling) -> Mapping[str, Any] | None:
        """A point at which all conditions hold; what is defined has its value there, and so have its rates."""
        less = self._proof.less
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

    def _refuted_at(self, factors: Iterable[Any]) -> Counterexample | None:
        """A point at which the sides differ where one of some factors vanishes."""
        for factor in factors:
            given = (*self._whole.pairs, (factor, sympy.S.Zero))
            sampling = Sampling(self._left, self._right, self._rows, given, self._whole.nonzero, self._met)
            if found := sampling.counterexample(few=True):
                return found
        return None

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


def thresholds(case: CheckedCase) -> list[Any]:
    """What is to have a known sign, so that what decides a form has one: of one symbol, its distance from numbers.

    There something vanishes, or does not change to the first order; if it nowhere does so, a piece around zero is told
    from what is far. Of several symbols it is which one is larger.
    """
    e = next((part.args[0] for part in case.switches() if isinstance(part, sympy.Abs | sympy.sign)), sympy.S.Zero)
    symbols = sorted(e.free_symbols, key=str)
    if len(symbols) == 1:
        gaps = [symbols[0] - number for number in NUMBERS if _is_flat(e, symbols[0], number)]
        gaps = gaps or ([] if e.is_rational_function() else [symbols[0] - FAR, symbols[0] + FAR])
        return [gap for gap in gaps if len(visible_signs(gap)) == 3][:MOST_NUMBERS]
    if not symbols or len(symbols) > MOST_SYMBOLS or (e.is_rational_function() and not _has_sign_in_order(e, symbols)):
        return []
    inside = sorted({call.args[0] for call in e.atoms(*CALLED) if call.args[0].is_polynomial()} - {*symbols}, key=str)
    gaps = [symbols[k] - symbols[k + step] for step in range(1, len(symbols)) for k in range(len(symbols) - step)]
    return [*inside[:1], *gaps]


def _is_flat(e: Any, symbol: Any, number: Any) -> bool:
    """Whether an expression vanishes, or its slope does, where its only symbol has a value."""
    slope = e.diff(symbol)
    parts = (e,) if slope.has(sympy.Derivative) else (e, slope)
    return any(sign_of_number(part.xreplace({symbol: number})) == 0 for part in parts)


def _has_sign_in_order(e: Any, symbols: list[Any]) -> bool:
    """Whether all coefficients have one sign in the least of positive symbols and in how much more each next one is."""
    sides = [sympy.Poly(side, *symbols) for side in sympy.fraction(sympy.together(e))]
    if not all(symbol.is_positive for symbol in symbols) or len(sides[0].terms()) > MOST_TERMS:
        return False
    orders = (dict(zip(order, accumulate(symbols), strict=True)) for order in permutations(symbols))
    shifted = (sympy.Poly(sides[0].as_expr().xreplace(put), *symbols) for put in orders)
    return len({c > 0 for c in sides[1].coeffs()}) == len({c > 0 for side in shifted for c in side.coeffs()}) == 1
