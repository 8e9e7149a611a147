"""Identities of `prove` as theorems for Coq: from the question and the certificate of its verdict.

Cosines and sines are taken apart, roots and absolute values become what the certificate says, and the difference of
both sides is a combination of what vanishes. Nothing here has to be believed.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import reduce
from operator import mul
from typing import Any

import sympy

from chasles.checker.expressions.asked import Asked
from chasles.checker.sparse import Rejected, exponents, parsed
from chasles.coq.expressions import ATOM, TIMES, Unsaid
from chasles.coq.of_sympy import ScalarStatement
from chasles.coq.proof import theorem
from chasles.coq.theorems import Claimed
from chasles.verdict import Holds, HoldsUnder, Verdict

UNIT = re.compile(r"(?:cos|sin)\(([1-9]\d*)?(.+?)(?:/([1-9]\d*))?\)")
GIVEN = re.compile(r"given (\d+) (\d+),(\d+)(?: d(\d+))?")
OTHERWISE = {"cases", "proof", "substituted", "angles", "positive", "frames", "equal", "turned"}
NOW = " t now'"
OPENED = (
    "repeat first [rewrite cos_plus | rewrite sin_plus | rewrite cos_minus | rewrite sin_minus | rewrite cos_neg "
    "| rewrite sin_neg | at_parts_of_pi]"
)
BY_CASES = ("intros.", "repeat apply conj; by_cases.")
KNOWN = tuple(sympy.pi / part for part in (2, 3, 4, 6))
"""Angles whose cosine and sine the theories know."""


def as_theorem(
    verdict: Verdict, lhs: Any, rhs: Any, given: Any = (), nonzero: Any = (), name: str = "identity"
) -> Claimed:
    """What the verdict of `chasles.prove` on this question says, for Coq, if it holds: a statement and its proof.

    Where there is no proof, or not even a statement, `why_not` says why. Raises TypeError for what does not hold.
    """
    if not isinstance(verdict, Holds | HoldsUnder):
        raise TypeError(f"the verdict is {verdict.name}: only what holds is a theorem")
    claim = Claimed(name, "asked", name, f"{lhs} = {rhs}")
    said = ""
    try:
        statement = ScalarStatement(Asked(lhs, rhs, given, nonzero), verdict.needs)
        said = statement.holding(name)
        by_cases = statement.has_cases and not statement.moves
        proof = theorem(name, BY_CASES if by_cases else _ScalarProof(statement, verdict.certificate).steps())
    except (Rejected, Unsaid, sympy.PolynomialError) as reason:
        return Claimed(name, "asked", name, claim.says, said, why_not=str(reason))
    return Claimed(name, "asked", name, claim.says, said, proof)


class _ScalarProof:
    """The steps of a proof; `plain` expressions are in symbols that are called as Coq calls them."""

    def __init__(self, statement: ScalarStatement, certificate: Mapping[str, Any]) -> None:
        if other := OTHERWISE & certificate.keys() | ({"squares"} if certificate.get("variant") else set()):
            raise Unsaid(f"a certificate of {', '.join(sorted(other))}")
        self.statement, self.certificate = statement, certificate
        self._rules: list[tuple[Any, str]] = []
        self._facts: list[str] = []
        self._rates: list[str] = []
        self._remembered: list[tuple[str, str]] = []
        self._values: list[str] = []
        self._divisors: dict[str, None] = {}
        self._known: dict[Any, Any] = {}
        found = [UNIT.fullmatch(each) for each in (*certificate.get("witness", {}), *certificate.get("turns", ()))]
        self._units = {m[2]: Fraction(int(m[1] or 1), int(m[3] or 1)) for m in found if m}
        spelled = {str(atom): atom for atom in statement.names}
        self._named = {k: self.plain(spelled[text]) for k, text in certificate["names"].items() if text in spelled}
        for name, kind, text in certificate.get("words", ()):
            numbers = [sympy.sqrt(int(text))] if kind == "sqrt" and text.isdigit() else []
            for e in (*self._roots_of(kind), *numbers):
                if name not in self._named and self._same(self.plain(e.args[0]), kind, text):
                    self.plain(e)
            if name not in self._named:
                raise Unsaid(f"a certificate of the {kind} of {text}, of which the question does not speak")

    def steps(self) -> Iterator[str]:
        """All steps."""
        said = self.statement
        bound = ["T"] * said.moves + [name for name in said.names.values() if name != "t"]
        bound += [premise.name for premise in said.premises]
        moving = [premise.name for premise in said.premises if premise.moves]
        combined = [self._combined(count, *pair) for count, pair in enumerate(said.goals)]
        if said.moves:
            yield "unfold during."
        yield f"intros {' '.join(bound)}{NOW * said.moves}." if bound else "intros."
        yield from self._rates
        rates = [line.split()[1][1:] for line in self._rates]
        for name in (*moving, *rates):
            yield f"specialize ({name}{NOW}); cbv beta in {name}."
        for premise in said.premises:
            if premise.says.startswith("0 < "):
                yield f"pose proof (Rgt_not_eq _ _ {premise.name})."
        yield "unfold tan in *."
        for text, name in sorted(self._remembered, key=lambda each: -len(each[0])):
            yield f"remember ({text}) as {name} eqn:of'{name} in *."
        yield from self._facts
        yield from [f"{self._rewritten.removesuffix('; ')} in *."] * bool(self._values)
        for count in range(len(self._rules)):
            yield f"try (pose proof (not_zero_square _ _ rule'{count} ltac:(not_zero_known)))."
        for text in self._divisors:
            yield f"try (assert ({text} <> 0) by not_zero_known)."
        yield from ["repeat apply conj."] * (len(combined) > 1)
        for total in combined:
            yield f"{'- ' * (len(combined) > 1)}{self._rewritten}apply (by_parts _ _ ({total})); [vanish | identity]."

    @property
    def _rewritten(self) -> str:
        return f"rewrite {', '.join(f'?{each}' for each in self._values)}; " if self._values else ""

    def plain(self, e: Any) -> Any:
        """An expression in symbols: a rational function of them."""
        if e not in self._known:
            self._known[e] = self._plain(e)
        return self._known[e]

    def _plain(self, e: Any) -> Any:
        if e in self.statement.names or e is sympy.pi:
            return sympy.Symbol(self.statement.side(e, ATOM))
        if e.is_Rational:
            return e
        if e.is_Add or e.is_Mul:
            return e.func(*map(self.plain, e.args))
        if e.is_Pow and e.exp.is_Integer:
            return self.plain(e.base) ** e.exp
        if e.is_Pow and (2 * e.exp).is_Integer:
            root = sympy.sqrt(e.base)
            return self._root(e, e.base, "sqrt") if e == root else self.plain(root) ** (2 * e.exp)
        if e.func is sympy.Abs:
            return self._root(e, e.args[0], "abs")
        if e.func is sympy.tan:
            return self.plain(sympy.sin(e.args[0])) / self.plain(sympy.cos(e.args[0]))
        if e.func in (sympy.cos, sympy.sin):
            return self._turned(e)
        raise Unsaid(f"{e.func} in a proof")

    # Cosines and sines, by the addition formulas.

    def _turned(self, e: Any) -> Any:
        cosine, sine, parts = sympy.Integer(1), sympy.Integer(0), []
        for atom, multiple in sympy.expand(e.args[0]).as_coefficients_dict().items():
            unit = self._units.get(str(atom), abs(Fraction(int(multiple.p), int(multiple.q))))
            unit = Fraction(1, max(2, multiple.q)) if atom is sympy.pi else unit
            turns = multiple / sympy.Rational(unit.numerator, unit.denominator)
            if not turns.is_Integer or not (atom is sympy.pi or atom in self.statement.names):
                raise Unsaid(f"the angle {e.args[0]}")
            angle = atom * sympy.Rational(unit.numerator, unit.denominator)
            c, s = self._of_pi(angle) if atom is sympy.pi else self._unit(angle)
            if abs(turns) == 1 and e.args[0] == angle:
                return c if e.func is sympy.cos else s
            parts += [f"{'-' if turns < 0 else '+'} {self.statement.side(angle, TIMES)}"] * abs(turns)
            for _ in range(abs(turns)):
                d = s if turns > 0 else -s
                cosine, sine = sympy.expand(cosine * c - sine * d), sympy.expand(sine * c + cosine * d)
        value, name = cosine if e.func is sympy.cos else sine, self._remember(e)
        total = " ".join(parts).removeprefix("+ ")
        function = "cos" if e.func is sympy.cos else "sin"
        replaced = f"replace ({self.statement.side(e)}) with ({function} ({total})) by (f_equal; lra)"
        known = "".join(f"rewrite <- ?of'{each}; " for text, each in self._remembered if text.startswith("sqrt"))
        self._value(name, value, f"(rewrite of'{name}; {replaced}; {OPENED}; {known}reckon)")
        return value

    def _of_pi(self, angle: Any) -> tuple[Any, Any]:
        """The cosine and sine of a part of half a turn that the theories know."""
        if angle not in KNOWN:
            raise Unsaid(f"the angle {angle}")
        return self.plain(sympy.cos(angle)), self.plain(sympy.sin(angle))

    def _unit(self, angle: Any) -> tuple[Any, Any]:
        text = self.statement.side(angle, ATOM)
        c, s = (sympy.Symbol(f"({function} {text})") for function in ("cos", "sin"))
        label = str(angle).replace("*", "")
        if f"cos({label})" not in self._named:
            self._named |= {f"cos({label})": c, f"sin({label})": s}
            self._rule(c, 1 - s**2, f"refine (eq_trans _ (circle {text})); identity")
        return c, s

    # Roots and absolute values.

    def _root(self, e: Any, inside: Any, kind: str) -> Any:
        if kind == "sqrt" and inside.is_Integer and len(sympy.factorint(inside)) > 1:
            return self._product_of_roots(e, inside)
        said = sympy.together(self.plain(inside))
        square = said if kind == "sqrt" else said**2
        name = self._remember(e)
        lemma = "root" if kind == "sqrt" else "size"
        words = self.certificate.get("words", ())
        names = [each for each, what, text in words if what == kind and self._same(said, kind, text)]
        self._facts.append(f"pose proof ({lemma}_positive _ _ of'{name}) as positive'{name}.")
        for text, factors in () if names else self.certificate.get("roots", ()):
            ratio = sympy.cancel(square / self._parsed(text))
            if ratio.is_Rational and sympy.sqrt(ratio).is_Rational:
                value = sympy.expand(reduce(mul, map(self._parsed, factors), sympy.sqrt(ratio)))
                equal = f"apply (by_parts _ _ ({self._total(square - value**2)})); [vanish | {self._rewritten}identity]"
                known = f"(apply ({lemma}_value _ _ _ of'{name}); [nonnegative | {equal}])"
                self._value(name, value, known)
                return value
        v = sympy.Symbol(name)
        self._named |= dict.fromkeys(names, v)
        positive = f" ltac:({self._rewritten}nonnegative)" if kind == "sqrt" else ""
        steps = f"refine (eq_trans _ ({lemma}_of _ _ of'{name}{positive})); {self._rewritten}identity"
        self._rule(v, square, steps)
        return v

    def _product_of_roots(self, e: Any, inside: Any) -> Any:
        """The root of a number as the product of those of its primes."""
        value = reduce(mul, (self.plain(sympy.sqrt(prime)) for prime in sympy.factorint(inside)))
        name = self._remember(e)
        equal = f"apply (by_parts _ _ ({self._total(inside - value**2)})); [vanish | identity]"
        self._value(name, value, f"(apply (root_value _ _ _ of'{name}); [nonnegative | {equal}])")
        return value

    def _roots_of(self, kind: str) -> list[Any]:
        """The roots, or absolute values, of the question, the innermost first."""
        expressions = sympy.Tuple(*self.statement.asked.expressions)
        powers = (sympy.sqrt(e.base) for e in expressions.atoms(sympy.Pow) if e.exp.is_Rational and e.exp.q == 2)
        found = powers if kind == "sqrt" else expressions.atoms(sympy.Abs)
        return sorted(set(found), key=lambda e: (e.count_ops(), str(e)))

    def _same(self, said: Any, kind: str, text: str) -> bool:
        """Whether a root, or an absolute value, is that of the certificate."""
        value = self._parsed(text)
        return not sympy.expand(said - value) or (kind == "abs" and not sympy.expand(said + value))

    def _remember(self, e: Any) -> str:
        name = f"value'{len(self._remembered)}"
        self._remembered.append((self.statement.side(e), name))
        return name

    def _value(self, name: str, value: Any, steps: str) -> None:
        self._facts.append(f"assert (is'{name} : {name} = {self._text(value)}) by {steps}.")
        self._values.append(f"is'{name}")

    def _rule(self, head: Any, equal: Any, steps: str) -> None:
        if sympy.fraction(equal)[1].free_symbols:
            raise Unsaid("a root of a quotient")
        text = f"({head}^2 - {self._text(equal)})"
        self._facts.append(f"assert (rule'{len(self._rules)} : {text} = 0) by ({steps}).")
        self._rules.append((head**2 - equal, text))

    # The difference of both sides, as a combination of what vanishes.

    def _combined(self, count: int, left: Any, right: Any) -> str:
        claim = self.plain(left) - self.plain(right)
        for below in (sympy.fraction(sympy.together(e))[1] for e in (self.plain(left), self.plain(right))):
            factors = (factor.as_base_exp()[0] for factor in sympy.Mul.make_args(below))
            self._divisors |= {_polynomial(factor): None for factor in factors if factor.free_symbols}
        places = list(self.statement.asked.left)
        said = self.certificate.get("entries", {}).get("{},{}".format(*(k + 1 for k in places[count])), {})
        divisors = [self._parsed(text) for text in self.certificate.get("divisors", ())]
        below = reduce(mul, (divisors[int(k)] ** n for k, n in said.get("times", {}).items()), sympy.Integer(1))
        products, rest = [], claim * below
        for label, text in said.get("cofactors", {}).items():
            value, spelled = self._given(label)
            cofactor = self._parsed(text)
            products.append(f"({self._text(cofactor)} / {self._text(below)}) * {spelled}")
            rest -= cofactor * value
        return " + ".join([*products, self._total(rest, below)])

    def _total(self, polynomial: Any, over: Any = 1) -> str:
        """What is a combination of rules; raises `Unsaid` if it is none."""
        numerator, below = sympy.fraction(sympy.together(polynomial))
        numerator = sympy.expand(numerator)
        rules = [rule for rule, _ in self._rules]
        symbols = sorted({s for each in (numerator, *rules) for s in each.free_symbols}, key=_rank)
        if not numerator:
            return "0"
        quotients, rest = sympy.reduced(numerator, rules, *symbols) if rules else ((), numerator)
        if rest:
            raise Unsaid("something is left when the difference is divided")
        pairs = zip(quotients, self._rules, strict=True)
        return " + ".join(f"({self._text(q / below / over)}) * {text}" for q, (_, text) in pairs if q)

    def _given(self, label: str) -> tuple[Any, str]:
        """What is given, or its rate, as a polynomial that vanishes, and how it is spelled."""
        found = GIVEN.fullmatch(label)
        if found is None:
            raise Unsaid(f"what vanishes as {label}")
        count, i, j = (int(found[k]) for k in (1, 2, 3))
        left, right = self.statement.asked.given[count].pairs[i - 1, j - 1]
        name = f"given'{count}_{i}_{j}"
        sides = " ".join(f"(fun t => {self.statement.side(side)})" for side in (left, right))
        for _ in range(int(found[4] or 0)):
            left, right = left.diff(self.statement.time), right.diff(self.statement.time)
            steps = (
                f"eapply (equal_scalar_rates T {sides} s'); [exact open'T | exact now's | exact {name} | rates | rates]"
            )
            line = f"eassert ({name}' : forall t, T t -> _ = _) by (intros s' now's; {steps})."
            self._rates += [line] * (line not in self._rates)
            name, sides = f"{name}'", "_ _"
        value, below = sympy.fraction(sympy.together(self.plain(left) - self.plain(right)))
        steps = f"apply (equal_numbers ({self._text(below)}) _ _ _ {name}); words; {self._rewritten}identity"
        fact = f"assert (fact'{len(self._facts)} : {self._text(value)} = 0) by ({steps})."
        self._facts.append(fact)
        return value, self._text(value)

    def _parsed(self, text: str) -> Any:
        """A polynomial of the certificate."""
        places = {name: place for place, name in enumerate(self._named)}
        symbols = list(self._named.values())
        polynomial = parsed(text, places)
        terms = (
            reduce(mul, (symbols[k] ** n for k, n in exponents(m)), sympy.Integer(c))
            for m, c in polynomial.terms.items()
        )
        return sympy.Add(*terms) / polynomial.below

    @staticmethod
    def _text(e: Any) -> str:
        """A rational function of symbols, in brackets unless it is one of them."""
        above, below = sympy.fraction(sympy.together(e))
        factors = [f"{_polynomial(b)}^{n}" for b, n in (factor.as_base_exp() for factor in sympy.Mul.make_args(below))]
        return _polynomial(above) if below == 1 else f"({_polynomial(above)} / ({' * '.join(factors)}))"


def _polynomial(e: Any) -> str:
    total = ""
    for term in sympy.Add.make_args(sympy.expand(e)):
        coefficient, factors = term.as_coeff_mul()
        powers = [f"{b}^{n}" if n != 1 else str(b) for b, n in (factor.as_base_exp() for factor in factors)]
        if abs(coefficient) != 1 or not powers:
            powers.insert(0, f"{abs(coefficient.p)}" + f" / {coefficient.q}" * (coefficient.q != 1))
        total += f" {'-' if coefficient < 0 else '+'} {' * '.join(powers)}"
    total = total.removeprefix(" + ").strip()
    return total if total.isalnum() else f"({total})"


def _rank(symbol: Any) -> tuple[int, str]:
    """What rules replace comes first: the root of something with roots in it before these, cosines before sines."""
    found = re.fullmatch(r"value'(\d+)", symbol.name)
    return (-int(found[1]) - 1, "") if found else (0, symbol.name)
