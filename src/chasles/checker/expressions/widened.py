"""Does a certificate by cases, or of a more general question, prove what was asked?

A case puts a value in the place of a symbol: x is y + d for a positive d where x - y is positive. In a more general
question, what stands in the arguments of cosines and sines is a symbol, and so is cos(pi/n).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.checker.expressions.cases import CheckedCase
from chasles.checker.expressions.enclosed import EnclosedValues, vanishes
from chasles.checker.expressions.needs import RELATIONS
from chasles.checker.expressions.quantities import atoms_of, is_atom, require_independent
from chasles.checker.expressions.readings import CIRCULAR
from chasles.checker.sparse import Rejected

PLAIN = re.compile(r"[A-Za-z0-9_+\-*/(), .\[\]]*")
ASSUMED = (
    "positive", "negative", "nonnegative", "nonpositive", "zero", "nonzero", "integer", "even", "odd", "rational",
)  # fmt: skip
PARTS = frozenset(("on", "size", "cases", "proof", "needs", "parts", "facts", "impossible", "witness"))
"""What a certificate by cases, or of a more general question, may say."""
Standard = Callable[[Mapping[str, Any], Sequence[str], tuple[Any, ...]], None]
"""Checks a certificate, with what it needs, of both sides, what is given and what does not vanish."""


def check_widened(
    verdict: Any, sides: Sequence[Sequence[Any]], given: Any, nonzero: Sequence[Any], check: Standard
) -> None:
    """Raises `Rejected` unless the certificate proves the entries of both sides equal; `given` are texts and pairs."""
    texts = [text for text, _ in given]
    if missing := [text for text in texts if text not in verdict.needs]:
        raise Rejected(f"the proof may use {missing[0]}, and the verdict does not say so")
    pairs = tuple(pair for _, item in given for pair in item)
    whole = CheckedCase(tuple(map(tuple, sides)), pairs, tuple(nonzero))
    if missing := [texts for texts in whole.required() if not texts & set(verdict.needs)]:
        raise Rejected(f"the question needs {min(missing[0])}, and the verdict does not say so")
    if verdict.certificate["witness"] != {name: str(value) for name, value in verdict.witness.items()}:
        raise Rejected("the verdict and its certificate have different witnesses")
    _Widened(tuple(verdict.needs), texts, check).tree(whole, verdict.certificate)
    _require_witness(verdict, whole)


class _Widened:
    def __init__(self, needs: tuple[str, ...], texts: Sequence[str], check: Standard) -> None:
        self.needs, self.texts, self.check = needs, texts, check

    def tree(self, case: CheckedCase, node: Mapping[str, Any]) -> None:
        """A certificate of one case."""
        if unknown := node.keys() - PARTS:
            raise Rejected(f"the certificate has a part {min(unknown)!r}, which says nothing")
        if case.lost:
            if case.lost not in self.needs:
                raise Rejected(f"one of the cases is excluded by {case.lost}, and the verdict does not say so")
            return
        if case.impossible:
            return
        case = case.settled()
        if case.impossible:
            return
        if case.undefined:
            if not any(f"{zero} != 0" in self.needs for zero in case.zeros):
                raise Rejected("something is divided by zero in one of the cases")
            return
        if "cases" not in node:
            self._leaf(case, node)
            return
        for name, part in case.split(node["on"], node["size"]).items():
            self.tree(part, node["cases"][name])

    def _leaf(self, case: CheckedCase, node: Mapping[str, Any]) -> None:
        if "proof" not in node:
            raise Rejected("one of the cases is not proved")
        if missing := [texts for texts in case.required_inside() if not texts & set(self.needs)]:
            raise Rejected(f"one of the cases needs {min(missing[0])}, and the verdict does not say so")
        more = _General(int(node.get("parts", 0)), case.names)
        sides = [list(map(more, side)) for side in case.sides]
        given = [sympy.Eq(more(one), more(other), evaluate=False) for one, other in case.pairs]
        given += [sympy.Eq(more(e), 0, evaluate=False) for e in case.equations]
        nonzero = list(map(more, case.nonzero))
        met: list[Any] = []
        while len(met) < len(more.met):
            met.append(more(more.met[len(met)]))
        moving = any(e.has(AppliedUndef) for pair in case.pairs for e in pair)
        if met and moving:
            raise Rejected("functions that are given are angles inside others")
        for text in node.get("facts", ()):
            fact = _parsed(text, {})
            if not vanishes(fact):
                raise Rejected(f"{text} is not known to be zero")
            given.append(sympy.Eq(fact.xreplace(more.symbols), 0, evaluate=False))
        stated = list(node["needs"])
        self.check(node["proof"], stated, (*(sympy.Matrix([*side, *met]) for side in sides), given, nonzero))
        own = {f"{e.lhs} = {e.rhs}" for e in given}
        for text in stated:
            if text not in own and text not in self.needs and not self._holds(case, text):
                raise Rejected(f"one of the cases needs {text}, and the verdict does not say so")

    def _holds(self, case: CheckedCase, text: str) -> bool:
        """Whether something holds throughout a case, or the verdict says it in the symbols of the question."""
        relation = next((relation for relation in RELATIONS if text.endswith(relation)), None)
        if relation is None:
            return False
        e = _parsed(text.removesuffix(relation), case.named)
        return case.sign(e) in ((1, -1) if relation == " != 0" else (1,)) or f"{case.back(e)}{relation}" in self.needs


class _General:
    """Puts symbols in the place of what is no plain angle, and of the cosine of a part of half a turn."""

    def __init__(self, parts: int, taken: set[str]) -> None:
        self.parts, self.taken = parts, taken
        self.symbols: dict[Any, Any] = {}
        if parts:
            self.cosine = self._symbol(sympy.cos(sympy.pi / parts))

    @property
    def met(self) -> list[Any]:
        """What the symbols stand for, as far as it has to be defined."""
        return [e for e in self.symbols if e.free_symbols]

    def __call__(self, e: Any) -> Any:
        if is_atom(e) or not e.args:
            return e
        if type(e) not in CIRCULAR:
            return e.func(*map(self, e.args))
        rest, turn = sympy.S.Zero, Fraction(0)
        for term in sympy.Add.make_args(sympy.expand(e.args[0])):
            multiple, factor = term.as_coeff_Mul()
            if factor is sympy.pi:
                turn += Fraction(int(multiple.p), int(multiple.q))
            else:
                rest += multiple * (factor if _is_angle(factor) else self._symbol(factor))
        if not self.parts:
            return type(e)(rest + sympy.Rational(turn.numerator, turn.denominator) * sympy.pi)
        above, below = (self._turned(name, rest, turn) for name in CIRCULAR[type(e)])
        if rest != 0 and CIRCULAR[type(e)][1]:
            raise Rejected(f"what {e} divides by is not seen any more")
        return above / below

    def _turned(self, name: str, rest: Any, turn: Fraction) -> Any:
        if not name:
            return sympy.S.One
        turn = turn if name == "cos" else turn - Fraction(1, 2)
        c, s = self._chebyshev(turn), self._chebyshev(turn - Fraction(1, 2))
        return c if rest == 0 else sympy.cos(rest) * c - sympy.sin(rest) * s

    def _chebyshev(self, turn: Fraction) -> Any:
        """cos(k t) is 2 cos(t) cos((k - 1) t) - cos((k - 2) t)."""
        count = turn * self.parts
        if count.denominator != 1:
            raise Rejected(f"{turn} pi is no multiple of pi/{self.parts}")
        before, value = self.cosine, sympy.S.One
        for _ in range(int(count) % (2 * self.parts)):
            before, value = value, sympy.expand(2 * self.cosine * value - before)
        return value

    def _symbol(self, e: Any) -> Any:
        if str(e) in self.taken:
            raise Rejected(f"a symbol is called {e}, as something else is written")
        return self.symbols.setdefault(e, sympy.Symbol(str(e), real=True))


def _is_angle(e: Any) -> bool:
    """Whether an expression is a product of quantities."""
    return e != 1 and all(is_atom(base) and n.is_Integer and n > 0 for base, n in e.as_powers_dict().items())


def _parsed(text: str, names: Mapping[str, Any]) -> Any:
    if not PLAIN.fullmatch(text) or "__" in text:
        raise Rejected(f"{text!r} is no plain expression")
    return sympy.sympify(text, locals=dict(names))


def _require_witness(verdict: Any, case: CheckedCase) -> None:
    """At the witness everything has a value, what is given holds, and nothing vanishes that must not."""
    values = _values(case, verdict.witness)
    for one, other in zip(*case.sides, strict=True):
        if not values(one).meets(values(other)):
            raise Rejected("the two sides differ at the witness")


def check_enclosed(
    at: Mapping[str, Any], place: int, said: Sequence[str], sides: Any, given: Any, nonzero: Sequence[Any]
) -> None:
    """Raises `Rejected` unless the point satisfies everything, and the entries in a place differ and are as said."""
    pairs = tuple(pair for _, item in given for pair in item)
    case = CheckedCase(tuple(map(tuple, sides)), pairs, tuple(nonzero))
    values = _values(case, at)
    for e in case.spoken:
        values(e)
    one, other = (values(side[place]) for side in case.sides)
    for text, value in zip(said, (one, other), strict=True):
        if not value.meets(values(_parsed(text, {}))):
            raise Rejected(f"a side is not {text} at the point")
    if one.meets(other):
        raise Rejected("the two sides are not seen to differ at the point")


def _values(case: CheckedCase, at: Mapping[str, Any]) -> EnclosedValues:
    """The values at a point that the symbols may have, and at which what is given holds."""
    point: dict[Any, Any] = {}
    atoms = {atom for e in case.spoken for atom in atoms_of(e)}
    require_independent(atoms)
    for atom in atoms:
        if str(atom) not in at:
            raise Rejected(f"no value is given for {atom}")
        value = at[str(atom)]
        number = sympy.Rational(value.numerator, value.denominator) if isinstance(value, Fraction) else value
        point[atom] = sympy.sympify(number)
    values = EnclosedValues(point)
    for atom, value in point.items():
        sign = value if value.is_Rational else sympy.Integer(values.sign(value))
        if any(getattr(atom, f"is_{kind}") not in (None, getattr(sign, f"is_{kind}")) for kind in ASSUMED):
            raise Rejected(f"{atom} cannot be {value}")
    if any(values.sign(one - other) for one, other in case.pairs) or any(values.sign(e) == 0 for e in case.nonzero):
        raise Rejected("the point does not satisfy the side conditions")
    return values
