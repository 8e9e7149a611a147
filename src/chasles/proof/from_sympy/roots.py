"""Square roots, each the nonnegative one: which of them are independent, and what are the others made of?

sqrt(4 x^2 y) is 2 |x| sqrt(y), and sqrt(a b) is sqrt(a) sqrt(b) where these occur too. A radicand is factored; squares
leave the root, factors that are not negative get roots of their own. What is left over is independent as far as is
known, so that its square is all that a proof needs; where it is not, a true statement may stay undecided.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import sympy

from chasles.proof.context import Context, build
from chasles.proof.from_sympy.reader import Reader, multiplied
from chasles.proof.rings import Polynomial
from chasles.proof.variables import Variable
from chasles.statements import Goal, Hypothesis, Problem
from chasles.vocabulary import Call, Node, Number, Power, Quotient, Scale, Sum, Symbol

__all__ = ["Roots", "resolve"]

MOST_TERMS = 80
Key = frozenset[tuple[tuple[tuple[str, int], ...], Fraction]]
Factors = list[tuple[Polynomial, int]]


@dataclass(frozen=True, slots=True)
class Roots:
    """What the words for roots stand for, what the independent ones satisfy, and where they are real."""

    rules: tuple[tuple[Node, Node], ...] = ()
    hypotheses: tuple[Hypothesis, ...] = ()
    domains: tuple[str, ...] = ()


def resolve(reader: Reader, divisors: tuple[Hypothesis, ...]) -> Roots:
    """The roots that a reader has met, in terms of independent ones."""
    hypotheses = tuple(_defining(word, Number(Fraction(p)), f"sqrt({p})") for p, word in reader.primes.items())
    if not reader.roots:
        return Roots((), hypotheses, ())
    return _Resolver(reader, divisors, list(hypotheses)).resolved()


def _defining(word: Symbol, radicand: Node, spelled: str) -> Hypothesis:
    """The word is a root of the radicand; `text` is for certificates, it is never a need."""
    subjects = (word, radicand)
    return Hypothesis("root", subjects, ((Power(word, 2), radicand),), (), "", f"{word.name} = {spelled}", free=True)


class _Resolver:
    def __init__(self, reader: Reader, divisors: tuple[Hypothesis, ...], hypotheses: list[Hypothesis]) -> None:
        self.reader = reader
        self.divisors = divisors
        self.hypotheses = hypotheses
        self.rules: list[tuple[Node, Node]] = []
        self.domains: list[str] = []
        self.words: dict[Key, Symbol] = {}
        self.known: set[Key] = set()
        self.positive = {word.name for word in reader.primes.values()}
        self.positive |= {word.name for atom, word in reader.atoms.words.items() if atom.is_nonnegative}

    def resolved(self) -> Roots:
        """One root after the other: those inside a radicand come before it."""
        context = self._context()
        for root in self.reader.roots.values():
            self._note(context, self._radicand(context, root.radicand)[0])
        for root in self.reader.roots.values():
            context = self._context()
            polynomial, absolute = self._radicand(context, root.radicand)
            value = self._root(context, polynomial)
            below = [self._absolute(context, atom) for atom in absolute]
            above = [value, *(node for node, _ in below)]
            squares: list[Node] = [Power(node, 2) for _, node in below]
            total = Quotient(multiplied(above), multiplied(squares)) if squares else multiplied(above)
            self.rules.append((root.word, total))
        return Roots(tuple(self.rules), tuple(self.hypotheses), tuple(dict.fromkeys(self.domains)))

    def _context(self) -> Context:
        goals = tuple(Goal("", root.radicand, Number(Fraction(0))) for root in self.reader.roots.values())
        return build(Problem(goals, tuple(self.rules), hypotheses=(*self.hypotheses, *self.divisors)))

    def _radicand(self, context: Context, node: Node) -> tuple[Polynomial, list[tuple[Polynomial, Node]]]:
        """N d for a radicand N / d, and the factors of d, by whose absolute values the root is to be divided."""
        ratio = context.unfold(node)[0][0]
        numerator = ratio.numerator
        below: list[tuple[Polynomial, Node]] = []
        for place, power in enumerate(ratio.denominator):
            hypothesis, atom = context.atoms[place]
            assert hypothesis is not None
            numerator = numerator * atom if power % 2 else numerator
            below += [(atom, hypothesis.nonvanishing[0])] * ((power + 1) // 2)
        return self._reduced(context, numerator), below

    def _reduced(self, context: Context, polynomial: Polynomial) -> Polynomial:
        return context.basis.reduce(polynomial)[1]

    def _note(self, context: Context, polynomial: Polynomial) -> None:
        """A root of a single factor says that this factor is not negative."""
        sign, _, factors = _factored(context, polynomial)
        odd = [factor for factor, power in factors if power % 2]
        if len(odd) == 1:
            self.known.add(_key(context, odd[0] if sign > 0 else -odd[0]))

    def _root(self, context: Context, polynomial: Polynomial) -> Node:
        if polynomial == 0:
            return Number(Fraction(0))
        sign, size, factors = _factored(context, polynomial)
        parts: list[Node] = [] if size == 1 else [self.reader.numeric_root(size)]
        self._know_primes()
        left = context.field.ring.constant(Fraction(1))
        for factor, power in factors:
            parts += [self._absolute(context, (factor, None))[0]] * (power // 2)
            if power % 2 and self._is_known(context, factor):
                parts.append(self._word(context, factor))
            elif power % 2 and self._is_known(context, -factor):
                sign = -sign
                parts.append(self._word(context, -factor))
            elif power % 2:
                left = left * factor
        if sign < 0 and left == 1:
            return self._word(context, polynomial)
        if left != 1:
            parts.append(self._word(context, left * context.field.ring.constant(Fraction(sign))))
        return multiplied(parts)

    def _know_primes(self) -> None:
        """State the roots of primes that have come up since."""
        for number, word in self.reader.primes.items():
            if word.name not in self.positive:
                self.positive.add(word.name)
                self.hypotheses.append(_defining(word, Number(Fraction(number)), f"sqrt({number})"))

    def _absolute(self, context: Context, factor: tuple[Polynomial, Node | None]) -> tuple[Node, Node]:
        """The absolute value of a polynomial, and the polynomial, as words."""
        polynomial = factor[0]
        plain = factor[1] if factor[1] is not None else _as_node(context, polynomial)
        if self._is_known(context, polynomial):
            return plain, plain
        if self._is_known(context, -polynomial):
            return _as_node(context, -polynomial), plain
        square = self._reduced(context, polynomial * polynomial)
        key = _key(context, square)
        if key not in self.words:
            self._define(key, Power(plain, 2), sympy.Abs(_as_sympy(self.reader, context, polynomial)))
        return self.words[key], plain

    def _is_known(self, context: Context, polynomial: Polynomial) -> bool:
        return self._is_nonnegative(context, polynomial) or _key(context, polynomial) in self.known

    def _is_nonnegative(self, context: Context, polynomial: Polynomial) -> bool:
        """Whether every term is visibly not negative, a cosine or sine being at least -1."""
        reserve, swing = Fraction(0), Fraction(0)
        for exponents, coefficient in context.field.ring.terms(polynomial):
            odd = [context.variables[k] for k, e in enumerate(exponents) if e % 2]
            if coefficient > 0 and all(v.name in self.positive for v in odd):
                reserve += coefficient if not any(exponents) else 0
            elif all(v.kind in ("cos", "sin") for v in odd) and all(
                v.kind in ("cos", "sin") for k, v in enumerate(context.variables) if exponents[k]
            ):
                swing += abs(coefficient)
            else:
                return False
        return swing <= reserve

    def _word(self, context: Context, polynomial: Polynomial) -> Node:
        """The root of a polynomial as an independent one."""
        terms = context.field.ring.terms(polynomial)
        if not any(any(exponents) for exponents, _ in terms) and terms[0][1] > 0:
            return self.reader.numeric_root(terms[0][1])
        key = _key(context, polynomial)
        if key not in self.words:
            expression = _as_sympy(self.reader, context, polynomial)
            if not self._is_nonnegative(context, polynomial):
                self.domains.append(f"{expression} >= 0")
            self._define(key, _as_node(context, polynomial), sympy.sqrt(expression))
        return self.words[key]

    def _define(self, key: Key, radicand: Node, origin: Any) -> None:
        word = self.reader.atoms.fresh(f"w_{len(self.words) + 1}", origin)
        self.words[key] = word
        self.positive.add(word.name)
        self.hypotheses.append(_defining(word, radicand, str(origin)))


def _key(context: Context, polynomial: Polynomial) -> Key:
    """The polynomial in the names of its variables, the same in every ring."""
    names = context.field.ring.names
    return frozenset(
        (tuple(sorted((names[k], e) for k, e in enumerate(exponents) if e)), coefficient)
        for exponents, coefficient in context.field.ring.terms(polynomial)
    )


def _factored(context: Context, polynomial: Polynomial) -> tuple[int, Fraction, Factors]:
    """Sign, size and irreducible factors with their powers; a long polynomial counts as irreducible."""
    ring = context.field.ring
    terms = ring.terms(polynomial)
    places = [k for k in range(len(ring.names)) if any(exponents[k] for exponents, _ in terms)]
    if not places or len(terms) > MOST_TERMS:
        constant = terms[0][1] if not places else Fraction(1)
        return (1 if constant > 0 else -1), abs(constant), [] if not places else [(polynomial, 1)]
    gens = sympy.symbols(f"x:{len(places)}")
    packed = {tuple(e[k] for k in places): sympy.Rational(c.numerator, c.denominator) for e, c in terms}
    content, factors = sympy.Poly.from_dict(packed, *gens).factor_list()
    size = Fraction(int(content.p), int(content.q))
    sign = 1 if size > 0 else -1
    found: Factors = []
    for factor, power in factors:
        unpacked = {}
        for exponents, coefficient in factor.terms():
            spread = [0] * len(ring.names)
            for place, exponent in zip(places, exponents, strict=True):
                spread[place] = int(exponent)
            unpacked[tuple(spread)] = Fraction(int(coefficient.p), int(coefficient.q))
        first = min(unpacked, key=lambda e: sorted((ring.names[k], x) for k, x in enumerate(e) if x))
        flip = -1 if unpacked[first] < 0 else 1
        sign *= flip if power % 2 else 1
        found.append((ring.from_terms({e: flip * c for e, c in unpacked.items()}), int(power)))
    return sign, abs(size), found


def _as_node(context: Context, polynomial: Polynomial) -> Node:
    terms = []
    for exponents, coefficient in sorted(context.field.ring.terms(polynomial), reverse=True):
        factors: list[Node] = [] if coefficient == 1 and any(exponents) else [Number(coefficient)]
        for variable, exponent in zip(context.variables, exponents, strict=True):
            if exponent:
                base = _variable_node(context, variable)
                factors.append(base if exponent == 1 else Power(base, exponent))
        terms.append(multiplied(factors))
    return terms[0] if len(terms) == 1 else Sum(tuple(terms))


def _variable_node(context: Context, variable: Variable) -> Node:
    assert variable.symbol is not None
    if variable.kind == "entry":
        return variable.symbol
    unit = context.unfold.unit(variable.symbol)
    return Call(variable.kind, variable.symbol if unit == 1 else Scale(Number(unit), variable.symbol))


def _as_sympy(reader: Reader, context: Context, polynomial: Polynomial) -> Any:
    """The polynomial in SymPy's spelling."""
    total = sympy.S.Zero
    for exponents, coefficient in context.field.ring.terms(polynomial):
        term = sympy.Rational(coefficient.numerator, coefficient.denominator)
        for variable, exponent in zip(context.variables, exponents, strict=True):
            if exponent and variable.symbol is not None:
                origin = reader.atoms.origins[variable.symbol]
                if variable.kind != "entry":
                    origin = getattr(sympy, variable.kind)(origin * context.unfold.unit(variable.symbol))
                term = term * origin**exponent
        total = total + term
    return total
