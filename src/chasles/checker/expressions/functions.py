"""Exponentials, logarithms and inverse functions of angles, for the checker: variables that a certificate names.

Of each product of quantities in an exponent, one exponential is a variable; so is the logarithm of the size of each
factor, and each angle of a point. What else is read is a product of powers, or a sum, of these.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from functools import reduce
from operator import and_

from chasles.checker.expressions.algebra import constant, primitive
from chasles.checker.expressions.factoring import Terms, quotient, terms_of
from chasles.checker.expressions.known_roots import KnownRoots
from chasles.checker.expressions.readings import FUNCTIONS
from chasles.checker.expressions.signs import is_positive
from chasles.checker.sparse import ONE, ZERO, Polynomial, Rejected, exponents, number, packed, variable

LARGEST_FACTOR = 100
Positive = tuple[Polynomial, frozenset[Terms], int]
"""What has to be positive, its factors with odd powers, and its sign where these are positive."""


class Functions:
    """The functions in a reading; `positives` are what logarithms are taken of, `pending` is the name to be given."""

    def __init__(self, reading: KnownRoots) -> None:
        self.reading = reading
        self.pending: str | None = None
        self.exponentials: dict[int, tuple[Fraction, int]] = {}
        self.exponents: dict[int, Polynomial] = {}
        self.logarithms: dict[Terms, int] = {}
        self.bases: dict[int, Polynomial] = {}
        self.positives: list[Positive] = []
        self.roots: dict[Terms, tuple[int, int]] = {}

    def named(self, function: str, *arguments: Polynomial) -> int:
        """The place of a new variable, by the name that is to be given to it."""
        name, self.pending = self.pending, None
        place = self.reading.named(name) if name else self.reading.fresh(f"{function} {len(self.reading.calls) + 1}")
        self.reading.calls[place] = function, arguments
        return place

    def exp(self, value: Polynomial) -> Polynomial:
        """The exponential of a sum."""
        total = ONE
        for monomial, coefficient in self.reading.normal(value).terms.items():
            total = self.reading.normal(total * self._exponential(monomial, Fraction(coefficient, value.below)))
        return total

    def raised(self, value: Polynomial, multiple: int) -> Polynomial:
        """What vanishes only where a sum of logarithms does: the exponential of a multiple of it, less one."""
        sums = [exponents(monomial) for monomial in value.terms]
        if multiple < 1 or not all(len(p) == 1 and p[0][0] in self.bases and p[0][1] == 1 for p in sums):
            raise Rejected("what is said to be a sum of logarithms is none")
        sides = ({m: multiple * abs(c) for m, c in value.terms.items() if c * sign > 0} for sign in (1, -1))
        above, below = (self.exp(Polynomial(side, value.below)) for side in sides)
        return self.reading.normal(above - below)

    def _exponential(self, monomial: int, multiple: Fraction) -> Polynomial:
        match exponents(monomial):
            case [(place, 1)] if place in self.bases:
                return self._raised(self.bases[place], multiple)
        if monomial not in self.exponentials:
            exponent = Polynomial({monomial: multiple.numerator}, multiple.denominator)
            place = self.named("exp", exponent)
            self.exponentials[monomial] = multiple, place
            self.exponents[place] = exponent
            self.reading.positive.add(place)
        unit, place = self.exponentials[monomial]
        if (multiple / unit).denominator != 1:
            raise Rejected("an exponential is no power of one that the certificate names")
        return self._power(variable(place), int(multiple / unit))

    def _power(self, base: Polynomial, exponent: int) -> Polynomial:
        base = base if exponent > 0 else self.reading.inverse(base)
        return self.reading.power(base, abs(exponent))

    def _raised(self, base: Polynomial, exponent: Fraction) -> Polynomial:
        """A power of the size of a factor."""
        size = self.reading.absolute(base)
        below = exponent.denominator
        if below & (below - 1):
            if (root := self.radical(size, exponent)) is None:
                raise Rejected("the certificate does not say what a root is")
            return root
        while below > 1:
            size, below = self.reading.root(size), below // 2
        return self._power(size, exponent.numerator)

    def state(self, name: str, function: str, arguments: list[Polynomial]) -> None:
        """Name a value: an exponential, the logarithm of a size, a power, or the angle of a point."""
        self.pending = name
        try:
            match function, arguments:
                case "log" | "size", [value]:
                    self.log(value, evident=True)
                case "power", [base, exponent] if (known := constant(exponent)) is not None:
                    self._state_root(base, known)
                case "power", [base, exponent]:
                    self.pending = None
                    value = self.reading.normal(exponent * self.log(base))
                    self.pending = name
                    self.exp(value)
                case (("exp" | "atan" | "asin" | "atan2"), _):
                    FUNCTIONS[function](self.reading, *arguments)
            if self.pending:
                raise Rejected(f"{name} names what has another name")
        finally:
            self.pending = None

    def _state_root(self, base: Polynomial, exponent: Fraction) -> None:
        """What is positive is a power of a new variable, and has it as its value if it is a quantity."""
        if exponent.numerator != 1 or (constant(base) is None and abs(primitive(base)[0]) != 1):
            raise Rejected("the certificate names a root of a multiple, or a power of a root")
        self.require_positive(base)
        root = self.named("root", base)
        self.reading.calls[root] = "root", (base, number(exponent))
        self.reading.positive.add(root)
        place = min(base.places, default=-1)
        place = place if place >= 0 and base.terms.keys() == {packed(place)} else -1
        if place in self.reading.atoms:
            self.reading.values[self.reading.atoms[place]] = variable(root, exponent.denominator)
            self.reading.rooted.add(self.reading.atoms[place])
        else:
            self.roots[frozenset(base.terms.items())] = root, exponent.denominator
            if place in self.reading.words:
                self.roots[frozenset(self.reading.squares[place].terms.items())] = root, 2 * exponent.denominator
            self.log(base, evident=True)

    def relation(self, root: int) -> Polynomial:
        """What vanishes because a variable is a root of no quantity."""
        if all(place != root for place, _ in self.roots.values()):
            raise Rejected("a variable is said to be a root that is none")
        base, exponent = self.reading.calls[root][1]
        return variable(root, exponent.below) - base

    def radical(self, value: Polynomial, exponent: Fraction) -> Polynomial | None:
        """A power of a product of powers that this makes whole again."""
        root, degree = self.roots.get(frozenset(value.terms.items()), (-1, 1))
        if root < 0 and self.roots and self.reading.is_known(value):
            root, degree = self.roots.get(frozenset(self.reading.normal(value * value).terms.items()), (-1, 2))
            degree //= 2
        if root >= 0 and value.below == 1 and (exponent * degree).denominator == 1:
            return self._power(variable(root), int(exponent * degree))
        pairs = exponents(next(iter(value.terms))) if len(value.terms) == 1 else []
        powers = [(place, power * exponent) for place, power in pairs]
        whole = all(p.denominator == 1 and place in self.reading.positive for place, p in powers)
        if not pairs or value.below != 1 or set(value.terms.values()) != {1} or not whole:
            return None
        return reduce(lambda one, pair: one * self._power(variable(pair[0]), int(pair[1])), powers, ONE)

    def log(self, value: Polynomial, evident: bool = False, size: bool = False) -> Polynomial:
        """The logarithm of a product, as a sum; what it is taken of has to be positive, if that is not `evident`.

        Of its `size`, it only must not vanish.
        """
        total = ZERO
        for base, power in self.factors(value):
            if (known := constant(base)) is not None:
                total += self._of_number(abs(known)) * number(power)
                continue
            place = next(iter(base.places)) if len(base.terms) == 1 else -1
            if place in self.reading.words:
                half = self.log(self.reading.squares[place], evident=evident, size=True)
                total += half * number(Fraction(power, 2))
                continue
            total += (self.exponents[place] if place in self.exponents else self._of_base(base)) * number(power)
        if not (evident or size):
            self.require_positive(value)
        elif not evident:
            self.require_nonzero(value)
        return self.reading.normal(total)

    def signs(self, value: Polynomial) -> tuple[frozenset[Terms], int]:
        """The factors of a product that decide on its sign, and the sign where these are positive."""
        odd, sign = frozenset[Terms](), 1
        for base, power in self.factors(value):
            if (known := constant(base)) is not None:
                sign *= -1 if known < 0 and power % 2 else 1
            elif power % 2 and is_positive(self.reading, -base):
                sign = -sign
            elif power % 2 and not is_positive(self.reading, base):
                is_root = len(base.terms) == 1 and base.places <= self.reading.words
                odd ^= frozenset() if is_root else {terms_of(base)}
        return odd, sign

    def require_positive(self, value: Polynomial) -> None:
        """Something is positive: that is visible, or has to be said."""
        odd, sign = self.signs(value)
        if not odd and sign > 0:
            self.require_nonzero(value)
            return
        self.positives.append((value, odd, sign))
        if len(odd) == 1:
            (terms,) = odd
            self.reading.know(Polynomial(dict(terms)) * number(sign))

    def require_nonzero(self, value: Polynomial) -> None:
        """None of the factors vanishes: that is visible, or has to be said."""
        for base, _ in self.factors(value):
            (place, *others) = base.places or {-1}
            if not others and place in self.reading.words and len(base.terms) == 1:
                self.require_nonzero(self.reading.squares[place])
            elif constant(base) is None and not is_positive(self.reading, base):
                self.reading.inverse(base)

    def factors(self, value: Polynomial) -> Iterable[tuple[Polynomial, int]]:
        """Factors with their exponents: quantities, what is divided by, and what logarithms are known of."""
        numerator, below = self.reading.cleared(value)
        for place, power in below.items():
            yield from ((base, -power * k) for base, k in self.factors(self.reading.inverses[place]))
        scale, base = primitive(numerator)
        yield number(scale), 1
        common = reduce(and_, (frozenset(k for k, _ in exponents(m)) for m in base.terms)) if base.terms else ()
        for place in common:
            power = min(dict(exponents(m))[place] for m in base.terms)
            base = Polynomial({m - packed(place, power): c for m, c in base.terms.items()})
            yield variable(place), power
        for known in [b for b in self.bases.values() if len(b.terms) > 1]:
            while len(base.terms) > 1 and (rest := quotient(base, known)) is not None:
                base = rest
                yield known, 1
        scale, base = primitive(base)
        yield number(scale), 1
        if constant(base) is None:
            yield base, 1

    def _of_number(self, value: Fraction) -> Polynomial:
        """The logarithm of a positive number, in those of the numbers that are named."""
        total = ZERO
        for part, sign in ((value.numerator, 1), (value.denominator, -1)):
            rest = part
            for place, base in self.bases.items():
                known = constant(base)
                while known is not None and rest % int(known) == 0:
                    rest //= int(known)
                    total += variable(place) * number(sign)
            for factor in range(2, LARGEST_FACTOR):
                while rest % factor == 0:
                    rest //= factor
                    total += self._of_base(number(factor)) * number(sign)
            if rest != 1:
                total += self._of_base(number(rest)) * number(sign)
        return total

    def _of_base(self, base: Polynomial) -> Polynomial:
        key = terms_of(base)
        if key not in self.logarithms:
            place = self.logarithms[key] = self.named("log", base)
            self.bases[place] = base
        return variable(self.logarithms[key])

    def inverse(self, value: Polynomial) -> Polynomial:
        """One over a product, factor by factor."""
        read, total = self.reading, ONE
        for base, power in self.factors(value):
            total = read.normal(total * read.power(read.inverse(base) if power > 0 else base, abs(power)))
        return total
