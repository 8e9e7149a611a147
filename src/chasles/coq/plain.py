"""What an expression of SymPy is in a proof for Coq: a rational function of symbols, and facts that say so.

Cosines and sines are taken apart by the addition formulas, exponentials and logarithms into those of their parts; roots
and absolute values become what the certificate says. Nothing here has to be believed.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import reduce
from operator import mul
from typing import Any

import sympy

from chasles.checker.sparse import Rejected, exponents, parsed
from chasles.coq.expressions import ATOM, Unsaid
from chasles.coq.of_sympy import SIGNS, ScalarStatement
from chasles.coq.sympy_words import IN_OTHER_WORDS, QUOTIENTS

Reader = Callable[["PlainExpressions", Any], Any]
"""What functions of a kind are; None for other expressions."""


class PlainExpressions:
    """Expressions in symbols that are called as Coq calls them.

    `remembered` are what gets a name in the proof, `facts` are the steps by which it is known what these are: by
    `rules`, one for a square, something vanishes, by `values` a name has a value. By `put` a function of what is said
    by others is one of these; expressions that are `asked` have names before that. `angles` have names where they are
    no rational functions. Symbols may be cosines and sines `of_numbers`, exponentials, of `exponents` that are
    multiples of `units`, or `logarithms`.
    """

    def __init__(
        self, statement: ScalarStatement, certificate: Mapping[str, Any], readers: Sequence[Reader] = ()
    ) -> None:
        self.statement, self.certificate, self._readers = statement, certificate, readers
        self.rules: dict[Any, tuple[Any, str]] = {}
        self.facts: list[str] = []
        self.remembered: dict[str, str] = {}
        self.asked: set[str] = set()
        self.put: list[str] = []
        given = enumerate(pair for _, pair in statement.given)
        self.values = [f"cond'{at}" for at, pair in given if statement.values.get(pair[0]) == pair[1]]
        self.angles: dict[Any, str] = {}
        self.of_numbers: set[Any] = set()
        self.named: dict[str, Any] = {}
        self.labels = {text: key for key, text in certificate["names"].items()}
        self.units: dict[Any, Any] = {}
        self.exponents: dict[Any, Any] = {}
        self.logarithms: dict[Any, Any] = {}
        self._symbols: dict[str, Any] = {}
        self._known: dict[Any, Any] = {}
        self._pending: set[Any] = set()
        for atom in statement.words.atoms:
            if str(atom) in self.labels:
                self.named[self.labels[str(atom)]] = self(atom)

    def __call__(self, e: Any) -> Any:
        """The expression as a rational function of symbols."""
        if e not in self._known:
            if e in self._pending:
                raise Unsaid(f"no proof is written of what {e} is, an exponential in another")
            self._pending.add(e)
            try:
                self._known[e] = self._plain(e)
            finally:
                self._pending.discard(e)
        return self._known[e]

    def knows(self, e: Any) -> bool:
        """Whether it has been asked what an expression is."""
        return e in self._known

    def _plain(self, e: Any) -> Any:
        if e in self.statement.values:
            return self(self.statement.values[e])
        if e is sympy.pi:
            self.facts.append("pose proof PI_neq0.")
        if e.func in IN_OTHER_WORDS:
            return self(e.rewrite(IN_OTHER_WORDS[e.func]))
        if e in self.statement.words.atoms or e is sympy.pi:
            sign = next((kind for kind in SIGNS if getattr(e, f"is_{kind}", False)), "real")
            return self.symbol(self.statement.side(e, ATOM), sign)
        if e.is_Rational:
            return e
        if e.is_Add or e.is_Mul:
            return e.func(*map(self, e.args))
        if e.is_Pow and e.exp.is_Integer:
            return self(e.base) ** e.exp
        if e.func in QUOTIENTS:
            above, below = QUOTIENTS[e.func](e.args[0])
            return self(above) / self(below)
        rooted = e.func in (sympy.Abs, sympy.sign) or (e.is_Pow and e.exp.is_Rational and e.exp.q == 2)
        if self.statement.values and e.has(*self.statement.values) and not rooted:
            return self._by_definition(e)
        for reader in self._readers:
            if (found := reader(self, e)) is not None:
                return found
        raise Unsaid(f"no proof is written of what {e.func if e.is_Function else e} is")

    def _by_definition(self, e: Any) -> Any:
        """A function of symbols that are said by others: the same function of these."""
        put = e.func(*(part.xreplace(self.statement.values) for part in e.args), evaluate=False)
        left, right = self.statement.side(e), self.statement.side(put)
        if left != right:
            steps = f"{self.rewritten}first [reflexivity | f_equal; solve [ring | reckon]]"
            self.put.append(f"assert (put'{len(self.put)} : {left} = {right}) by ({steps}).")
            self.put.append(f"rewrite put'{len(self.put) - 1} in *.")
        return self(put)

    def symbol(self, text: str, sign: str = "real") -> Any:
        """A symbol by its name in Coq; what is known of its sign is told where it first occurs."""
        return self._symbols.setdefault(text, sympy.Symbol(text, **{"real": True, sign: True}))

    def parsed(self, text: str) -> Any:
        """A polynomial of the certificate."""
        places = {name: place for place, name in enumerate(self.named)}
        symbols = list(self.named.values())
        try:
            found = parsed(text, places)
        except Rejected as reason:
            raise Unsaid("no proof is written with all that the certificate names") from reason
        terms = (
            reduce(mul, (symbols[k] ** n for k, n in exponents(m)), sympy.Integer(c)) for m, c in found.terms.items()
        )
        return sympy.Add(*terms) / found.below

    @property
    def rewritten(self) -> str:
        """The step that puts in the values that are known."""
        return f"rewrite {', '.join(f'?{each}' for each in self.values)}; " if self.values else ""

    def remember(self, e: Any) -> str:
        """A name for an expression of the question."""
        text = self.statement.side(e)
        self.asked |= {text} if e.has(*self.statement.values) else set()
        return self.remembered.setdefault(text, f"value'{len(self.remembered)}")

    def angle(self, e: Any) -> str:
        """The name of an angle that is no rational function of symbols."""
        if e not in self.angles:
            self.angles[e] = self.remember(e)
        return self.angles[e]

    def value(self, name: str, value: Any, steps: str) -> None:
        """A name has a value, by these steps."""
        self.facts.append(f"assert (is'{name} : {name} = {text_of(value)}) by {steps}.")
        self.values.append(f"is'{name}")

    def rule(self, head: Any, equal: Any, steps: str) -> None:
        """The square of a symbol is a polynomial, by these steps."""
        if divisors_of(equal):
            raise Unsaid("no proof is written of the root of a quotient")
        text, name = f"({head}^2 - {text_of(equal)})", f"rule'{len(self.rules)}"
        self.facts.append(f"assert ({name} : {text} = 0) by ({steps}).")
        self.facts.append(f"try (pose proof (not_zero_square _ _ {name} ltac:(not_zero_known))).")
        self.rules[head] = head**2 - equal, text

    def nonzero(self, e: Any) -> Iterator[str]:
        """The steps by which it is known, where that is seen, that what an expression is divided by is not zero."""
        for factor in divisors_of(e):
            if factor.free_symbols <= self.of_numbers:
                raise Unsaid(f"no proof is written that {factor} is not zero")
            made_of_roots = all(symbol.name.startswith("value") for symbol in factor.free_symbols)
            known = "first [not_zero_known | intro; nra]" if made_of_roots else "not_zero_known"
            yield f"try (assert ({polynomial(factor)} <> 0) by {known})."

    def total(self, vanishing: Any, over: Any = 1) -> str:
        """What vanishes as a combination of rules; raises `Unsaid` if it is none."""
        numerator, below = sympy.fraction(sympy.together(vanishing))
        numerator = sympy.expand(numerator)
        rules = [rule for rule, _ in self.rules.values()]
        symbols = sorted({s for each in (numerator, *rules) for s in each.free_symbols}, key=rank)
        if not numerator:
            return "0"
        quotients, rest = sympy.reduced(numerator, rules, *symbols) if rules else ((), numerator)
        if rest:
            raise Unsaid("the difference is not seen to vanish by the squares of roots, cosines and absolute values")
        pairs = zip(quotients, self.rules.values(), strict=True)
        return " + ".join(f"({text_of(q / below / over)}) * {text}" for q, (_, text) in pairs if q)


def text_of(e: Any) -> str:
    """A rational function, in brackets unless it is a symbol."""
    above, below = (sympy.sstr(part).replace("**", "^") for part in sympy.fraction(sympy.together(e)))
    text = above if below == "1" else f"({above}) / ({below})"
    return text if text.isalnum() else f"({text})"


def polynomial(e: Any) -> str:
    """A polynomial, in brackets unless it is a symbol."""
    return text_of(sympy.expand(e))


def rank(symbol: Any) -> tuple[int, str]:
    """What rules replace comes first: the root of something with roots in it before these, cosines before sines."""
    found = re.fullmatch(r"(?:value|word)'(\d+)", symbol.name)
    return (-int(found[1]) - 1, "") if found else (0, symbol.name)


def divisors_of(e: Any) -> list[Any]:
    """What is divided by, factor by factor, also where it cancels."""
    bases = [power.base for power in e.atoms(sympy.Pow) if power.exp.is_negative]
    belows = [
        sympy.fraction(sympy.together(e))[1],
        *(part for base in bases for part in sympy.fraction(sympy.together(base))),
    ]
    factors = (factor.as_base_exp()[0] for below in belows for factor in sympy.Mul.make_args(below))
    return sorted({factor for factor in factors if factor.free_symbols}, key=str)
