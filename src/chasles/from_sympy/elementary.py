"""Exponentials, logarithms and powers in independent variables.

Exponents are sums of rational multiples of terms; of each term one exponential is a positive variable. Arguments of
logarithms are products of powers; the logarithm of each factor is a variable. What is left has no known relation: that
none is missed is Schanuel's conjecture, so that these variables serve to prove, never to refute.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import lcm
from typing import Any

import sympy

from chasles.algebra.work_limit import check
from chasles.checker.expressions.quantities import is_atom
from chasles.checker.expressions.readings import CIRCULAR
from chasles.from_sympy.arcs import INVERSE, RECIPROCAL, arc_of, without_arcs
from chasles.from_sympy.factors import factors_of, is_entire, is_evident
from chasles.from_sympy.hyperbolic import EXPONENTIALS, LOGARITHMS
from chasles.from_sympy.opening import FunctionSymbol, Signed, excerpt, parts_of
from chasles.from_sympy.placeholders import Placeholders
from chasles.problems.variables import Untreatable

ROUNDS = 8


class Elementary(Placeholders):
    """Rewrites expressions in these variables."""

    def __call__(self, expressions: Sequence[Any], equal: Sequence[tuple[Any, Any]] = ()) -> list[Any]:
        """The expressions in the variables; raises `Untreatable` for logarithms of what is not positive.

        What is `equal` has equal logarithms or exponentials, too: `applied` are these, twice zero where neither helps.
        """
        self.applied: list[tuple[Any, Any]] = [(sympy.S.Zero, sympy.S.Zero)] * len(equal)
        if not any(map(is_elementary, expressions)):
            return list(expressions)
        for _ in range(ROUNDS):
            before = dict(self.units), dict(self.signs)
            self._reset()
            found = [self.read(e) for e in expressions]
            self.applied = [self._of_both(self.read(one), self.read(other)) for one, other in equal]
            if before == (self.units, self.signs):
                return found
        raise Untreatable("the exponents depend on each other in a way that is not treated")

    def _of_both(self, one: Any, other: Any) -> tuple[Any, Any]:
        """The logarithms of two positive products of which one has an exponential; or exponentials of logarithms."""
        words = one.free_symbols | other.free_symbols
        product = bool(words & self.exponents.keys()) and not (one.is_Add or other.is_Add)
        if product and (is_evident(one) or is_evident(other)):
            known = dict(self.signs)
            logarithms = self.log(one, one, evident=True), self.log(other, other, evident=True)
            self.signs = known  # A side is positive because of the other, wherever the question is meant.
            return logarithms
        if words & self.logs.keys() and all(is_linear(side, self.logs) for side in (one, other)):
            return self.exp(one), self.exp(other)
        return sympy.S.Zero, sympy.S.Zero

    def read(self, e: Any) -> Any:
        """One expression in the variables."""
        if e not in self._known:
            check()
            self._known[e] = result = self._read(e)
            if not is_entire(e):
                self._meet(result, *map(self.read, e.args))
        return self._known[e]

    def _read(self, e: Any) -> Any:
        if is_atom(e):
            return self._atom(e)
        if e is sympy.E:
            return self.exp(sympy.S.One)
        if not e.args:
            return e
        if isinstance(e, sympy.Pow):
            return self._power(e)
        for rules in (EXPONENTIALS, LOGARITHMS):
            if e.func in rules and len(e.args) == 1:
                return rules[e.func](self, self.read(e.args[0]), e.args[0])
        if e.func is sympy.log:
            return self.read(sympy.log(e.args[0]) / sympy.log(e.args[1]))
        arguments = tuple(map(self.read, e.args))
        if e.func in INVERSE:
            if e.func in RECIPROCAL:
                self.nonvanishing(arguments[0])
            return self._arc(*INVERSE[e.func](*arguments))
        if e.func in CIRCULAR and self.arcs:
            return without_arcs(e.func, arguments[0], self.arcs)
        return e.func(*arguments)

    def exponentials(self, difference: Any) -> tuple[Any, Any, int] | None:
        """Two products that are equal exactly where a sum of logarithms is zero, and of which multiple they are."""
        if not difference.has(*self.logs) or any(power.exp.is_Integer for power in difference.atoms(sympy.Pow)):
            return None
        terms = [term.as_coeff_Mul() for term in sympy.Add.make_args(sympy.expand(difference))]
        if not all(c.is_Rational and rest in self.logs for c, rest in terms):
            return None
        multiple = lcm(*(int(c.q) for c, _ in terms))
        one, other = (
            sympy.Mul(*(self._raised(self.logs[rest], abs(c) * multiple) for c, rest in terms if c * sign > 0))
            for sign in (1, -1)
        )
        return one, other, multiple

    def _arc(self, turn: Any, sign: int, function: type, arguments: tuple[Any, ...]) -> Any:
        """Turn + sign * arc; a value that SymPy knows is no arc."""
        value = function(*arguments)
        if isinstance(value, sympy.Mul) and value.args[0] is sympy.S.NegativeOne:
            return turn + self._arc(sympy.S.Zero, -sign, value.args[1].func, value.args[1].args)
        if value.func is not function:
            return turn + sign * self.read(value)
        word = self._word(self._original(value), positive=False)
        self.arcs[word] = arc = arc_of(function, value.args)
        self._meet(arc.x, 1 / arc.square if function is sympy.atan2 else 1)
        return turn + sign * word

    def exp(self, exponent: Any) -> Any:
        """The exponential of what is written in the variables."""
        result = sympy.S.One
        for term in sympy.Add.make_args(sympy.expand(exponent)):
            multiple, rest = term.as_coeff_Mul()
            if not multiple.is_Rational:
                raise Untreatable(f"exp({excerpt(self._original(exponent))}) is not treated")
            result *= self._raised(self.logs[rest], multiple) if rest in self.logs else self._multiple(rest, multiple)
        return result

    def _multiple(self, rest: Any, multiple: Any) -> Any:
        """exp(multiple * rest) as a power of the variable for exp(rest / unit)."""
        if multiple == 0:
            return sympy.S.One
        unit = self._unit(rest, multiple)
        word = self._word(sympy.exp(self._original(rest) / unit))
        self.exponents[word] = rest / unit
        return word ** (multiple * unit)

    def _raised(self, base: Any, exponent: Any) -> Any:
        """A power of the size of a factor of a logarithm."""
        size = base if base.is_positive else base * self.signs[base] if base in self.signs else sympy.Abs(base)
        if exponent.q & (exponent.q - 1) == 0:
            return size**exponent
        key = self.logs_key(base)
        unit = self._unit(("root", key), exponent)
        kind = FunctionSymbol if is_evident(size) else Signed
        word = self._word(self._original(size) ** sympy.Rational(1, unit), kind)
        if not is_atom(key):
            self.equations[(word**unit, size)] = None
        return word ** (exponent * unit)

    def _power(self, e: Any) -> Any:
        if e.base is sympy.E:
            return self.exp(self.read(e.exp))
        base = self.read(e.base)
        if e.exp.is_Integer:
            return base**e.exp
        if e.exp.is_Rational and e.exp.q & (e.exp.q - 1) == 0:
            return self._root(base, e.exp)
        return self.exp(self.read(e.exp) * self.log(base, e.base))

    def _root(self, base: Any, exponent: Any) -> Any:
        """A power p/2, p/4, ...: that of an exponential is taken in its exponent."""
        outside, inside = sympy.S.One, sympy.S.One
        for factor in sympy.Mul.make_args(base):
            word, power = factor.as_base_exp()
            if word in self.exponents and power.is_Rational:
                outside *= self.exp(self.exponents[word] * power * exponent)
            else:
                inside *= factor
        return outside * inside**exponent

    def log(self, value: Any, spelled: Any, evident: bool = False) -> Any:
        """The logarithm of what is written in the variables, and is positive; `spelled` as the user did."""
        total, sign, odd = sympy.S.Zero, 1, []
        for base, power, signed in self._factors(value):
            if base.is_Rational:
                sign *= -1 if base < 0 and signed.is_odd else 1
                for prime, count in sympy.factorrat(abs(base)).items():
                    total += power * count * self._logarithm(sympy.Integer(prime))
            elif base in self.exponents:
                total += power * self.exponents[base]
            else:
                total += power * self._logarithm(base)
                if not signed.is_Integer:
                    self._learn(base, 1)
                if not (signed.is_even or is_evident(base)):
                    odd.append(base)
        if len(odd) == 1:
            self._learn(odd[0], sign)
        if not evident:
            self._need(value, spelled, sign if not odd else 0)
        return total

    def _factors(self, value: Any) -> list[tuple[Any, Any, Any]]:
        """Factors with the exponents of their sizes and signs: in atoms, where only whole powers of these occur."""
        words = {word: origin for word in value.free_symbols if (origin := self.origins.get(word)) is not None}
        roots = {word: origin for word, origin in words.items() if origin.is_Pow and is_atom(origin.base)}
        plain = value.xreplace(roots)
        if not roots or any(not power.exp.is_Integer for power in plain.atoms(sympy.Pow)):
            return factors_of(value)
        back = {origin.base: word**origin.exp.q for word, origin in roots.items()}
        return [(base.xreplace(back), power, signed) for base, power, signed in factors_of(plain)]

    def _logarithm(self, base: Any) -> Any:
        """The variable for the logarithm of a factor's size."""
        number = base.is_Integer
        origin = self._original(base)
        size = origin if number or base.is_positive else sympy.Abs(origin)
        word = self._word(sympy.log(size), positive=number)
        self._meet(base)
        self.logs[word] = base
        return word


def is_linear(e: Any, logs: Mapping[Any, Any]) -> bool:
    """Whether a sum has logarithms with rational coefficients."""
    terms = [term.as_coeff_Mul() for term in sympy.Add.make_args(sympy.expand(e))]
    return all(c.is_Rational and (rest in logs or not rest.free_symbols & logs.keys()) for c, rest in terms)


def is_elementary(e: Any) -> bool:
    """Whether exponentials, logarithms, or powers with other exponents than halves, quarters, ... occur."""
    for part in parts_of(e):
        if any(part.func in rules for rules in (EXPONENTIALS, LOGARITHMS, INVERSE)) or part is sympy.E:
            return True
        if isinstance(part, sympy.Pow) and not (part.exp.is_Rational and part.exp.q & (part.exp.q - 1) == 0):
            return True
    return False
