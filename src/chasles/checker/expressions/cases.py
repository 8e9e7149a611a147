"""One case of a question: the signs that are known in it, and what everything is there."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial, reduce
from itertools import combinations
from math import prod
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.checker.expressions.defined_functions import is_entire
from chasles.checker.expressions.enclosed import sign_of_multiple, sign_of_number, written
from chasles.checker.expressions.quantities import NUMBERS, SIGNS, is_atom, with_values
from chasles.checker.expressions.readings import MOST_PARTS, at_integer
from chasles.checker.expressions.switches import SWITCHES, deciding, factored, visible_signs
from chasles.checker.sparse import Rejected

MOST_SLOPES = 5
Pairs = tuple[tuple[Any, Any], ...]


@dataclass(frozen=True, slots=True)
class CheckedCase:
    """Both sides, what is given to be equal and not to vanish, and besides: what vanishes here, and known signs.

    `meant` says of each positive symbol what it stands for, `zeros` what was said to vanish, in the symbols of the
    question; `lost` is what the question needs and does not hold here. `values` are those of symbols in turn, `inside`
    the powers within conditions, as the question has them.
    """

    sides: tuple[tuple[Any, ...], ...]
    pairs: Pairs
    nonzero: tuple[Any, ...]
    equations: tuple[Any, ...] = ()
    facts: tuple[tuple[Any, int], ...] = ()
    meant: tuple[tuple[Any, Any], ...] = ()
    zeros: tuple[Any, ...] = ()
    lost: str = ""
    values: tuple[tuple[Any, Any], ...] = ()
    inside: tuple[Any, ...] | None = None

    @property
    def spoken(self) -> tuple[Any, ...]:
        """Everything of which is spoken."""
        return (*self.sides[0], *self.sides[1], *(e for pair in self.pairs for e in pair), *self.nonzero)

    @property
    def named(self) -> dict[str, Any]:
        """The symbols by their names."""
        return {str(s): s for e in (*self.spoken, *self.equations) for s in e.free_symbols}

    @property
    def names(self) -> set[str]:
        """The names that are taken, also of what has a value: a need that speaks of it is one of the question."""
        return {*self.named, *(str(symbol) for symbol, _ in (*self.meant, *self.values))}

    @property
    def undefined(self) -> bool:
        """Whether something is divided by zero."""
        return any(e.has(sympy.zoo, sympy.nan, sympy.oo, -sympy.oo) for e in (*self.spoken, *self.equations))

    @property
    def impossible(self) -> bool:
        """Whether what is known here visibly contradicts itself, two facts each other, or what is given."""
        signs = any(sign not in visible_signs(e) for e, sign in self.facts)
        for (e, sign), (other, known) in combinations(self.facts, 2):
            signs = signs or ((multiple := sign_of_multiple(e, other)) is not None and sign != multiple * known)
        apart = [one - other for one, other in self.pairs] + list(self.equations)
        return signs or any(self.sign(e) in (1, -1) or 0 not in visible_signs(e) for e in apart)

    def each(self, change: Callable[[Any], Any]) -> CheckedCase:
        """The case with everything changed."""
        sides, pairs = (tuple(tuple(map(change, part)) for part in item) for item in (self.sides, self.pairs))
        nonzero, equations = (tuple(map(change, part)) for part in (self.nonzero, self.equations))
        facts = tuple((change(e), sign) for e, sign in self.facts)
        return replace(self, sides=sides, pairs=pairs, nonzero=nonzero, equations=equations, facts=facts)

    def settled(self) -> CheckedCase:
        """The case with everything written out whose form is decided by known signs."""
        case = self
        while True:
            values = ((part, written(part, partial(case._deciding_sign, part))) for part in case.switches())
            if (put := next(({part: value} for part, value in values if value is not None), None)) is None:
                return case
            case = replace(case.each(partial(with_values, put=put)), equations=case.equations, facts=case.facts)

    def switches(self) -> list[Any]:
        """What changes its form with a sign, innermost first."""
        found = {part for e in self.spoken for part in e.atoms(*SWITCHES)}
        return sorted(found, key=lambda part: (len(part.atoms(*SWITCHES)), str(part)))

    def sign(self, e: Any) -> int | None:
        """The sign of an expression, if it is known: by itself, as a multiple of a known one, or by its factors."""
        e = sympy.expand(e)
        if len(visible := visible_signs(e)) == 1:
            return next(iter(visible))
        for known, sign in self.facts:
            if (multiple := sign_of_multiple(e, known)) is not None:
                return sign * multiple
        if e.has(*SWITCHES):
            return None
        if not e.is_polynomial(*e.free_symbols):
            above, below = sympy.fraction(sympy.together(e))
            one, other = (self.sign(above), self.sign(below)) if below.free_symbols else (None, None)
            return one * other if one is not None and other else None
        constant, factors = factored(e)
        alone = constant.is_Rational and sum(n for _, n in factors) < 2
        if alone or sympy.expand(constant * sympy.Mul(*(f**n for f, n in factors)) - e) != 0:
            return None
        signs = [sign_of_number(constant), *(self.sign(factor) for factor, power in factors for _ in range(int(power)))]
        return None if None in signs else prod(sign for sign in signs if sign is not None)

    def signs(self, e: Any, slopes: int = MOST_SLOPES) -> frozenset[int]:
        """The signs that an expression may have, at most so many derivatives being taken one of the other."""
        sign = self.sign(e)
        found = visible_signs(sympy.expand(e)) if sign is None else frozenset((sign,))
        if len(found) < 3:
            return found
        from chasles.checker.expressions.slopes import by_slope, up_to_end  # few questions are of such inequalities

        found = up_to_end(self, e) if slopes == MOST_SLOPES else found
        if len(found) < 3 or e.is_rational_function():
            return found
        above, below = sympy.fraction(sympy.together(e)) if slopes > MOST_SLOPES - 2 else (e, sympy.S.One)
        if below.free_symbols and (under := self.signs(below, slopes - 1)) in ({1}, {-1}):
            found = frozenset(sign * min(under) for sign in self.signs(above, slopes))
        return by_slope(self, e, slopes) if len(found) == 3 else found

    def _deciding_sign(self, part: Any, e: Any) -> int | None:
        """The sign by which a part is written out; one of two, where it is the same if something vanishes."""
        signs, either = self.signs(e), isinstance(part, sympy.Abs | sympy.Max | sympy.Min)
        return next((side for side in (1, -1, 0) if signs <= {side, 0 if either else side}), None)

    def split(self, factor: Any, size: str, named: bool = False) -> dict[str, CheckedCase]:
        """The cases in which something is positive, zero and negative: what decides some form, or a polynomial."""
        symbols = factor.free_symbols & {*self.named.values()}
        terms = sympy.Poly(factor, *symbols).coeffs() if symbols and factor.is_polynomial(*symbols) else [factor]
        if None in map(sign_of_number, terms) and factor not in deciding(self.switches()):
            raise Rejected(f"the sign of {factor} decides nothing")
        if not isinstance(size, str) or size in self.names:
            raise Rejected(f"the symbol {size} is not new")
        positive = sympy.Symbol(size, positive=True)
        return {name: self._with(factor, sign, positive, named) for name, sign in (("+", 1), ("0", 0), ("-", -1))}

    def split_by_remainder(self, text: str, modulus: int, name: str) -> dict[str, CheckedCase]:
        """The cases of an integer by its remainder, the quotient a new integer."""
        symbol = self.named[text]
        calls = {call for e in self.spoken for call in e.atoms(AppliedUndef, sympy.Derivative)}
        taken = name in self.names or any(call.has(symbol) for call in calls)
        if taken or not symbol.is_integer or modulus not in range(1, MOST_PARTS + 1):
            raise Rejected(f"{text} is not split by a remainder of {modulus}")
        signs = {kind: True for kind in ("nonnegative", "negative") if getattr(symbol, f"is_{kind}")}
        quotient = sympy.Symbol(name, integer=True, **signs)
        odd = [even is False for even in (symbol.is_even,) if even is not None] or [False, True]
        cases = {}
        for remainder in (r for r in range(modulus) if r % 2 in odd or modulus % 2):
            value = modulus * quotient + remainder
            known = [(value, 1)] if symbol.is_positive else [(value, -1)] if symbol.is_negative else []
            meant = (*self.meant, (quotient, (symbol - remainder) / modulus))
            case = self.each(partial(at_integer, put={symbol: value}))
            values, facts = (*self.values, (symbol, value)), (*case.facts, *known)
            cases[str(remainder)] = replace(case, facts=facts, meant=meant, values=values, inside=self.within())
        return cases

    def _at_an_instant(self) -> CheckedCase:
        """The case with symbols for functions and their rates: of what holds at an instant no rate follows."""
        atoms = {part for e in (*self.spoken, *self.equations) for part in e.atoms(AppliedUndef, sympy.Derivative)}
        if {*map(str, atoms)} & self.names or not all(map(is_atom, atoms)):
            raise Rejected("what is a rate of a case that lasts for an instant is not seen")
        case = self
        for atom in sorted(atoms, key=lambda e: (isinstance(e, AppliedUndef), str(e))):
            known = {kind: True for kind in (*SIGNS, *NUMBERS) if getattr(atom, f"is_{kind}")}
            symbol = sympy.Symbol(str(atom), real=True, **known)
            case = case.each(partial(_with_value, put={atom: symbol}))
            case = replace(case, meant=(*case.meant, (symbol, atom)), values=(*case.values, (atom, symbol)))
        return case

    def _with(self, factor: Any, sign: int, positive: Any, named: bool) -> CheckedCase:
        moving = {part for e in self.spoken for call in e.atoms(AppliedUndef) for part in (call, *call.args)}
        if (named or not sign) and factor.has(*moving):
            return (still := self._at_an_instant())._with(still.here(factor), sign, positive, named)
        zeros = self.zeros if sign else (*self.zeros, self.back(factor))
        free = () if named else self._free(factor)
        values = {e: sympy.expand(e + (sign * positive - factor) / sympy.diff(factor, e)) for e in free}
        if not values or sign not in visible_signs(factor):
            equations = (*self.equations, factor - sign * positive) if named or not sign else self.equations
            return replace(self, equations=equations, facts=(*self.facts, (factor, sign)), zeros=zeros)
        seen = ((e, value) for e, value in values.items() if not e.is_positive or visible_signs(value) == {1})
        atom, value = next(seen, next(iter(values.items())))
        put = {atom: value}
        if sympy.expand(factor.xreplace(put) - sign * positive) != 0:
            raise Rejected(f"{factor} is not solved for {atom}")
        case = replace(self.each(partial(_with_value, put=put)), zeros=zeros)
        if atom.is_positive or atom.is_negative:
            case = replace(case, facts=(*case.facts, (value, 1 if atom.is_positive else -1)))
        meant = (*case.meant, (positive, sign * factor)) if sign else case.meant
        case = replace(case, values=(*self.values, (atom, value)), inside=self.within())
        return replace(case, meant=meant, lost=self._lost(case, put))

    def _free(self, factor: Any) -> Iterator[Any]:
        """The symbols in which the factor is linear with a rational coefficient, and which may have any value."""
        calls = (call for e in (*self.spoken, *self.equations) for call in e.atoms(AppliedUndef, sympy.Derivative))
        for symbol in sorted(factor.free_symbols - {s for call in calls for s in call.free_symbols}, key=str):
            slope = sympy.diff(factor, symbol) if factor.is_polynomial(symbol) else sympy.nan
            if slope.is_Rational and slope != 0 and all(getattr(symbol, f"is_{kind}") is None for kind in NUMBERS):
                yield symbol

    def _lost(self, case: CheckedCase, put: Mapping[Any, Any]) -> str:
        """What is not to vanish and does, or a radicand that is negative, outside of conditions; "" if none is lost."""
        for power in (*(sympy.Pow(e, -1, evaluate=False) for e in self.nonzero), *self._outside()):
            sign = case.sign(power.base.xreplace(put))
            if sign == 0 and power.exp < 0:
                return f"{self.back(power.base)} != 0"
            if sign == -1 and not power.exp.is_Integer:
                return f"{self.back(power.base)} >= 0"
        return ""

    def _outside(self) -> list[Any]:
        """The powers with rational exponents that are not within conditions."""
        plain = (e.replace(lambda part: isinstance(part, sympy.Piecewise), lambda _: sympy.S.Zero) for e in self.spoken)
        return _rational_powers(plain)

    def within(self) -> tuple[Any, ...]:
        """The powers with rational exponents within conditions, as the question has them."""
        known, parts = self.inside, (part for e in self.spoken for part in e.atoms(sympy.Piecewise))
        return tuple(_rational_powers(parts)) if known is None else known

    def required(self) -> list[tuple[str, ...]]:
        """What is to be said of divisors and radicands outside of conditions, each in one of some ways."""
        return [texts for power in self._outside() for texts in _requirements(power)]

    def required_inside(self) -> list[tuple[str, ...]]:
        """What is to be said of those within, where it is not seen in this case whether it holds."""
        return [need for p in self.within() if self.sign(self.here(p.base)) is None for need in _requirements(p)]

    def here(self, e: Any) -> Any:
        """An expression of the question in this case."""
        return reduce(lambda part, at: part.xreplace(dict([at])), self.values, e)

    def back(self, e: Any) -> Any:
        """An expression in the symbols of the question."""
        for symbol, meaning in reversed(self.meant):
            e = e.xreplace({symbol: meaning})
        return sympy.expand(e)


def _with_value(e: Any, put: Mapping[Any, Any]) -> Any:
    """The expression at the value; undefined where something in it is that SymPy does not compare."""
    try:
        return with_values(e, put)
    except (TypeError, ValueError, ZeroDivisionError):
        return sympy.zoo


def _rational_powers(parts: Iterable[Any]) -> list[Any]:
    return sorted({power for e in parts for power in e.atoms(sympy.Pow) if power.exp.is_Rational}, key=str)


def _requirements(power: Any) -> list[tuple[str, ...]]:
    """The ways to say what a power with a rational exponent needs of its base."""
    base, found = power.base, list[tuple[str, ...]]()
    signs = {1} if is_entire(power) else visible_signs(base)  # a gamma function is never zero
    if power.exp < 0 and 0 in signs:
        found.append((f"{base} != 0", f"{base} > 0"))
    if not power.exp.is_Integer and -1 in signs:
        found.append((f"{base} >= 0", f"{base} > 0"))
    return found
