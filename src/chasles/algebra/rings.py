"""Polynomials with rational coefficients behind one small surface, on python-flint or on SymPy's own rings.

Both give the same answers: division by a single polynomial has a unique result in a given term order. The environment
variable CHASLES_POLYNOMIALS=sympy chooses SymPy where flint is installed too. As text, for certificates, terms are
joined by " + ", factors by "*", the coefficient first; names are written without blanks, so that " + " in the name of a
norm is not read as the end of a term, and the factors of a moment in alphabetical order.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import cache
from heapq import heapify, heappop, heappush
from operator import add, sub
from typing import Any, Protocol

Polynomial = Any
Exponents = tuple[int, ...]


class Ring(Protocol):
    """A polynomial ring; its polynomials support + - * with each other and with integers, and len counts terms."""

    names: tuple[str, ...]
    generators: tuple[Polynomial, ...]

    def constant(self, value: Fraction) -> Polynomial: ...
    def from_terms(self, terms: dict[Exponents, Fraction]) -> Polynomial: ...
    def terms(self, polynomial: Polynomial) -> list[tuple[Exponents, Fraction]]: ...
    def leading(self, polynomial: Polynomial) -> tuple[Exponents, Fraction]: ...
    def degrees(self, polynomial: Polynomial) -> Exponents: ...
    def divide(self, polynomial: Polynomial, divisor: Polynomial) -> tuple[Polynomial, Polynomial]: ...
    def derivative(self, polynomial: Polynomial, variable: int) -> Polynomial: ...
    def square_free(self, polynomial: Polynomial) -> list[tuple[Polynomial, int]]: ...


class _FlintRing:
    def __init__(self, names: Sequence[str], order: str) -> None:
        import flint

        self.names = tuple(names)
        kind = flint.Ordering.lex if order == "lex" else flint.Ordering.degrevlex
        self._context = flint.fmpq_mpoly_ctx.get([f"x{i}" for i in range(max(len(names), 1))], kind)
        self._rational = flint.fmpq
        self.generators = tuple(self._context.gens())[: len(names)]

    def constant(self, value: Fraction) -> Polynomial:
        return self._context.constant(self._rational(value.numerator, value.denominator))

    def from_terms(self, terms: dict[Exponents, Fraction]) -> Polynomial:
        pad = () if self.names else (0,)
        return self._context.from_dict(
            {exponents + pad: self._rational(c.numerator, c.denominator) for exponents, c in terms.items()}
        )

    def terms(self, polynomial: Polynomial) -> list[tuple[Exponents, Fraction]]:
        size = len(self.names)
        return [(tuple(map(int, m))[:size], _fraction(c)) for m, c in polynomial.to_dict().items()]

    def leading(self, polynomial: Polynomial) -> tuple[Exponents, Fraction]:
        return tuple(map(int, polynomial.monomial(0))), _fraction(polynomial.coefficient(0))

    def degrees(self, polynomial: Polynomial) -> Exponents:
        return tuple(map(int, polynomial.degrees()))

    def divide(self, polynomial: Polynomial, divisor: Polynomial) -> tuple[Polynomial, Polynomial]:
        quotient, remainder = divmod(polynomial, divisor)
        return quotient, remainder

    def derivative(self, polynomial: Polynomial, variable: int) -> Polynomial:
        return polynomial.derivative(variable)

    def square_free(self, polynomial: Polynomial) -> list[tuple[Polynomial, int]]:
        """The product of the factors of each power, ascending, up to a number."""
        found: dict[int, Polynomial] = {}
        for factor, power in polynomial.factor_squarefree()[1]:
            found[int(power)] = found[int(power)] * factor if power in found else factor
        return [(found[power], power) for power in sorted(found)]


def _fraction(value: Any) -> Fraction:
    return Fraction(int(value.p), int(value.q))


class _SympyRing:
    def __init__(self, names: Sequence[str], order: str) -> None:
        from sympy import QQ, Symbol
        from sympy.polys.rings import PolyRing

        self.names = tuple(names)
        symbols = [Symbol(f"x{i}") for i in range(max(len(names), 1))]
        self._lexicographic = order == "lex"
        self._ring = PolyRing(symbols, QQ, "lex" if order == "lex" else "grevlex")
        self._rationals = QQ
        self.generators = tuple(self._ring.gens)[: len(names)]

    def constant(self, value: Fraction) -> Polynomial:
        return self._ring.ground_new(self._rationals(value.numerator, value.denominator))

    def from_terms(self, terms: dict[Exponents, Fraction]) -> Polynomial:
        pad = () if self.names else (0,)
        return self._ring.from_dict(
            {exponents + pad: self._rationals(c.numerator, c.denominator) for exponents, c in terms.items()}
        )

    def terms(self, polynomial: Polynomial) -> list[tuple[Exponents, Fraction]]:
        size = len(self.names)
        return [(tuple(m)[:size], self._fraction(c)) for m, c in polynomial.terms()]

    def leading(self, polynomial: Polynomial) -> tuple[Exponents, Fraction]:
        return tuple(polynomial.LM), self._fraction(polynomial.LC)

    def degrees(self, polynomial: Polynomial) -> Exponents:
        return tuple(polynomial.degrees())

    def divide(self, polynomial: Polynomial, divisor: Polynomial) -> tuple[Polynomial, Polynomial]:
        """Quotient and remainder, the largest monomial first, from a heap: SymPy searches all of them each time."""
        lead, top = divisor.LM, divisor.LC
        places = [(place, exponent) for place, exponent in enumerate(lead) if exponent]
        rest = [(tuple(map(sub, monomial, lead)), -c / top) for monomial, c in divisor.items() if monomial != lead]
        left, quotient = dict(polynomial), {}
        waiting = [self._waiting(m) for m in left if all(m[place] >= least for place, least in places)]
        heapify(waiting)
        while waiting:
            monomial = heappop(waiting)[-1]
            if monomial not in left:
                continue
            coefficient = left.pop(monomial)
            quotient[tuple(map(sub, monomial, lead))] = coefficient / top
            for shift, factor in rest:
                other = tuple(map(add, monomial, shift))
                if other in left:
                    left[other] += coefficient * factor
                    if not left[other]:
                        del left[other]
                else:
                    left[other] = coefficient * factor
                    if all(other[place] >= least for place, least in places):
                        heappush(waiting, self._waiting(other))
        return polynomial.new(quotient), polynomial.new(left)

    def _waiting(self, monomial: Exponents) -> tuple[Any, ...]:
        """The monomial, behind what is the smaller the larger it is in the order of the ring."""
        if self._lexicographic:
            return tuple(-exponent for exponent in monomial), monomial
        return -sum(monomial), monomial[::-1], monomial

    def derivative(self, polynomial: Polynomial, variable: int) -> Polynomial:
        return polynomial.diff(variable)

    def square_free(self, polynomial: Polynomial) -> list[tuple[Polynomial, int]]:
        """The product of the factors of each power, ascending, up to a number."""
        return [(factor, int(power)) for factor, power in polynomial.sqf_list()[1]]

    def _fraction(self, value: Any) -> Fraction:
        return Fraction(int(self._rationals.numer(value)), int(self._rationals.denom(value)))


@cache
def backend() -> str:
    """Which polynomials are in use: "flint" or "sympy"."""
    if os.environ.get("CHASLES_POLYNOMIALS", "") == "sympy":
        return "sympy"
    try:
        import flint  # noqa: F401
    except ImportError:
        return "sympy"
    return "flint"


def make_ring(names: Iterable[str], order: str = "lex") -> Ring:
    """The ring of polynomials in the named variables, the first the largest, in the order "lex" or "grevlex"."""
    names = tuple(names)
    return _FlintRing(names, order) if backend() == "flint" else _SympyRing(names, order)


def written(ring: Ring, polynomial: Polynomial) -> str:
    """The polynomial, as -1/2*e_1^2*cos(phi) + 3; zero is 0."""
    terms = []
    for exponents, coefficient in sorted(ring.terms(polynomial), reverse=True):
        factors = factors_text(ring, exponents)
        terms.append(f"{coefficient}*{factors}" if factors else str(coefficient))
    return " + ".join(terms) or "0"


def factors_text(ring: Ring, exponents: tuple[int, ...]) -> str:
    """A product of powers of the variables, as e_1^2*cos(phi); nothing where there are none."""
    powers = [(_squeezed(name), power) for name, power in zip(ring.names, exponents, strict=False) if power]
    return "*".join(name if power == 1 else f"{name}^{power}" for name, power in powers)


def _squeezed(name: str) -> str:
    """The name as a certificate spells it: int(rho p_1 p_1) becomes int(p_1.p_1.rho)."""
    if name.startswith("int(") and name.endswith(")"):
        return f"int({'.'.join(sorted(name[4:-1].split()))})"
    return name.replace(" ", "")
