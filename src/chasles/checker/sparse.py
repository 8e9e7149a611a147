"""Polynomials for the checker: exact, sparse, and nobody else's; and determinants of any numbers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from fractions import Fraction
from functools import reduce
from math import lcm
from operator import add, mul, or_
from struct import unpack
from typing import Any

MALFORMED = (
    ArithmeticError, AssertionError, AttributeError, LookupError, RuntimeError, SyntaxError, TypeError, ValueError,
)  # fmt: skip
MOST_PRODUCTS, MOST_POWER = 10_000_000, 2**15 - 1
"""So many products of terms does a check form at most, and no higher power of a variable."""
_left: ContextVar[list[int]] = ContextVar("left", default=[])  # noqa: B039 - nothing is counted there
Matrix = list[list[Any]]


class Rejected(ValueError):
    """What was to be checked does not show what it says; the message says why."""


@contextmanager
def limited(products: int) -> Iterator[None]:
    """So many products of terms are formed inside at most; more are `Rejected`, on every machine alike."""
    token = _left.set([products])
    try:
        yield
    finally:
        _left.reset(token)


@contextmanager
def well_formed(what: str) -> Iterator[None]:
    """Whatever goes wrong in reading `what` is malformed, or takes too much work, and `Rejected`."""
    try:
        with limited(MOST_PRODUCTS):
            yield
    except Rejected:
        raise
    except MALFORMED as error:
        raise Rejected(f"the {what} is malformed: {type(error).__name__}: {error}") from error


class Polynomial:
    """Integers by monomial, none of them zero, over one integer; 16 bits of a monomial are variable k's exponent."""

    __slots__ = ("below", "terms")

    def __init__(self, terms: dict[int, int], below: int = 1) -> None:
        self.terms, self.below = terms, below if terms else 1

    def __bool__(self) -> bool:
        return bool(self.terms)

    def plus(self, other: Polynomial, times: int) -> Polynomial:
        """The sum with a multiple of another."""
        below = lcm(self.below, other.below)
        one, another = below // self.below, below // other.below * times
        total = {monomial: c * one for monomial, c in self.terms.items()} if one > 1 else dict(self.terms)
        for monomial, coefficient in other.terms.items():
            if value := total.get(monomial, 0) + coefficient * another:
                total[monomial] = value
            else:
                del total[monomial]
        return Polynomial(total, below)

    def __add__(self, other: Polynomial) -> Polynomial:
        return self.plus(other, 1)

    def __sub__(self, other: Polynomial) -> Polynomial:
        return self.plus(other, -1)

    def __neg__(self) -> Polynomial:
        return ZERO.plus(self, -1)

    def __mul__(self, other: Polynomial) -> Polynomial:
        if left := _left.get():
            left[0] -= len(self.terms) * len(other.terms)
            if left[0] < 0:
                raise Rejected("it takes more products of terms than are formed at most")
        total: dict[int, int] = {}
        for one, coefficient in self.terms.items():
            for another, factor in other.terms.items():
                total[one + another] = total.get(one + another, 0) + coefficient * factor
        # With a bit to spare, two monomials are multiplied by adding them, and no exponent spills over into the next.
        if any(power > MOST_POWER for _, power in exponents(reduce(or_, total, 0))):
            raise Rejected(f"an exponent is larger than {MOST_POWER}")
        return Polynomial({monomial: c for monomial, c in total.items() if c}, self.below * other.below)

    @property
    def places(self) -> set[int]:
        """The variables that occur."""
        return {place for place, _ in exponents(reduce(or_, self.terms, 0))}

    def partials(self) -> dict[int, Polynomial]:
        """The derivative by each variable that occurs."""
        total: dict[int, dict[int, int]] = {}
        for monomial, coefficient in self.terms.items():
            for place, exponent in exponents(monomial):
                total.setdefault(place, {})[monomial - packed(place)] = coefficient * exponent
        return {place: Polynomial(terms, self.below) for place, terms in total.items()}


def cleared(polynomial: Polynomial, nonzero: Factors, mask: int | None = None) -> tuple[Polynomial, int]:
    """The polynomial times the least product of nonzero factors that leaves no inverse in it, and the powers of these.

    Variable k is the inverse of nonzero factor k, as long as there are any; or where the mask has bits.
    """
    mask = packed(len(nonzero)) - 1 if mask is None else mask
    parts: dict[int, dict[int, int]] = {}
    for monomial, coefficient in polynomial.terms.items():
        inverses = monomial & mask
        parts.setdefault(inverses, {})[monomial - inverses] = coefficient
    if parts.keys() <= {0}:
        return polynomial, 0
    powers = sorted(pair for inverses in parts for pair in exponents(inverses))
    top = sum(packed(*pair) for pair in dict(powers).items())
    terms = (Polynomial(part, polynomial.below) * product(nonzero, top - inverses) for inverses, part in parts.items())
    return reduce(add, terms), top


def product(nonzero: Factors, powers: int) -> Polynomial:
    """The product of the nonzero factors to these powers, packed as in a monomial."""
    return reduce(mul, (nonzero[k] for k, power in exponents(powers) for _ in range(power)), ONE)


Factors = list[Polynomial] | dict[int, Polynomial]
"""Polynomials by place."""


def packed(place: int, power: int = 1) -> int:
    """The monomial that is this power of a variable; that of a product is the sum of those of its factors."""
    return power << 16 * place


def exponents(monomial: int) -> list[tuple[int, int]]:
    """The variables of a monomial with their exponents."""
    count = monomial.bit_length() // 16 + 1
    powers = unpack(f"<{count}H", monomial.to_bytes(2 * count, "little"))
    return [(place, power) for place, power in enumerate(powers) if power]


def variable(place: int, power: int = 1) -> Polynomial:
    """A power of a variable."""
    return Polynomial({packed(place, power): 1})


def number(value: int | Fraction) -> Polynomial:
    """A constant."""
    return Polynomial({0: value.numerator} if value else {}, value.denominator)


ZERO, ONE = number(0), number(1)


def parsed(text: str, places: Mapping[str, int]) -> Polynomial:
    """A polynomial in the variables with these places, from text such as -1/2*e_1^2*cos(phi) + 3."""
    total = ZERO
    for term in text.split(" + "):
        coefficient, *factors = term.split("*")
        product = number(Fraction(coefficient))
        for factor in factors:
            name, _, power = (factor, "", "1") if factor in places else factor.rpartition("^")
            if name not in places:
                raise Rejected(f"the certificate has a factor {factor!r}, which is no power of a variable")
            product *= powered(places[name], power)
        total += product
    return total


def powered(place: int, power: str | int) -> Polynomial:
    """A power of a variable; raises `Rejected` for an exponent that is none."""
    if not 1 <= int(power) <= MOST_POWER:
        raise Rejected(f"the certificate has {power!r} where an exponent from 1 to {MOST_POWER} is due")
    return variable(place, int(power))


def determinant(m: Matrix, one: Any = ONE) -> Any:
    """The determinant, by expansion along the first row; `one` is that of nothing."""
    terms = [entry * cofactor(m, 0, j, one) for j, entry in enumerate(m[0] if m else []) if entry]
    return reduce(add, terms) if terms else m[0][0] if m else one


def cofactor(m: Matrix, i: int, j: int, one: Any = ONE) -> Any:
    """What multiplies an entry in the determinant."""
    minor = determinant([row[:j] + row[j + 1 :] for row in (*m[:i], *m[i + 1 :])], one)
    return -minor if (i + j) % 2 else minor
