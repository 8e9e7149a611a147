"""Questions of `prove` as statements in Coq: expressions of SymPy in words, and with these a statement like any other.

Symbols are real numbers; functions of one symbol move, and all is said during an open set of instants. Only this has to
be read to know what is claimed, with what declared statements are written by.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import reduce
from typing import Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.matrices import MatrixBase, MatrixExpr
from sympy.matrices.expressions.matexpr import MatrixElement

from chasles import vocabulary as w
from chasles.checker.expressions.asked import Asked
from chasles.checker.expressions.complexes import Parts
from chasles.checker.expressions.unevaluated import explicit, written_out
from chasles.coq.expressions import APPLIED, ATOM, LOOSE, PLUS, Spelled, Spelling, Unsaid
from chasles.coq.names import CoqNames
from chasles.coq.statement import CoqStatement
from chasles.statements import Goal, Hypothesis, Problem
from chasles.vocabulary.dimension import NO_DIMENSION
from chasles.vocabulary.fitting import SCALAR
from chasles.vocabulary.functions import FunctionOf
from chasles.vocabulary.measure import uniform

FUNCTIONS = {
    sympy.tan: "tan", sympy.Abs: "Rabs", sympy.sign: "sign", sympy.exp: "exp", sympy.log: "ln", sympy.sinh: "sinh",
    sympy.cosh: "cosh", sympy.tanh: "tanh", sympy.asin: "asin", sympy.acos: "acos", sympy.atan: "atan",
}  # fmt: skip
"""What Coq, or the theories, call functions of one number."""
QUOTIENTS = {
    sympy.tan: lambda x: (sympy.sin(x), sympy.cos(x)), sympy.cot: lambda x: (sympy.cos(x), sympy.sin(x)),
    sympy.sec: lambda x: (sympy.Integer(1), sympy.cos(x)), sympy.csc: lambda x: (sympy.Integer(1), sympy.sin(x)),
    sympy.coth: lambda x: (sympy.cosh(x), sympy.sinh(x)), sympy.sech: lambda x: (sympy.Integer(1), sympy.cosh(x)),
    sympy.csch: lambda x: (sympy.Integer(1), sympy.sinh(x)),
}  # fmt: skip
"""Functions as quotients; but for the tangent, Coq has no words for them."""
OF_TWO = {sympy.Max: "Rmax", sympy.Min: "Rmin"}
IN_OTHER_WORDS = {
    **dict.fromkeys((sympy.asinh, sympy.acosh, sympy.atanh, sympy.acoth), sympy.log),
    sympy.asec: sympy.acos, sympy.acsc: sympy.asin, sympy.Heaviside: sympy.Piecewise,
}  # fmt: skip
"""Functions that others are written for, as SymPy does it."""
BY_CASES = (sympy.sign, sympy.Piecewise, sympy.Heaviside, *OF_TWO)
DECIDED = {sympy.Lt: "Rlt_dec", sympy.Le: "Rle_dec", sympy.Eq: "Req_EM_T"}
"""What Coq decides of two numbers."""
SIGNS = {
    "positive": "0 < {}",
    "negative": "{} < 0",
    "nonnegative": "0 <= {}",
    "nonpositive": "{} <= 0",
    "nonzero": "{} <> 0",
}
RELATIONS = {" != 0": "nonzero", " >= 0": "nonnegative", " > 0": "positive"}


def in_entries(value: Any) -> Any:
    """The scalar, matrix, equation or list with matrices, what is made of them, and finite sums in their entries."""
    if isinstance(value, list | tuple):
        return type(value)(map(in_entries, value))
    if isinstance(value, sympy.Equality):
        return sympy.Eq(*map(in_entries, value.args), evaluate=False)
    if isinstance(value, MatrixBase | MatrixExpr):
        return explicit(value)
    return written_out(value) if isinstance(value, sympy.Expr) else value


def in_parts(asked: Asked) -> Asked:
    """What was asked, of real and imaginary parts: these, if there are any, in further rows."""
    parts = Parts()
    sides = parts.sides(*(list(side.values()) for side in (asked.left, asked.right)))
    asked.left, asked.right = (_placed(asked.left, side) for side in sides)
    given = []
    for item in asked.given:
        said = [parts.pairs(*pair) for pair in item.pairs.values()]
        pairs = [pair[0] for pair in said] + [pair[1] for pair in said if len(pair) > 1]
        given.append(replace(item, pairs=_placed(item.pairs, pairs)))
    asked.given = given
    return asked


def _placed(places: Iterable[tuple[int, int]], parts: Sequence[Any]) -> dict[tuple[int, int], Any]:
    """Parts by their places: imaginary ones as many rows below."""
    places = list(places)
    below = 1 + max((row for row, _ in places), default=0)
    return dict(zip([*places, *((row + below, column) for row, column in places)], parts, strict=False))


def is_exponential(power: Any) -> bool:
    """Whether a power is that of an exponential: of any exponent, or of a positive number that is no square root."""
    return not power.exp.is_Rational or (power.exp.q > 2 and power.base.is_positive is True)


class SympyWords:
    """Expressions of SymPy in words: `atoms` are the symbols, functions and rates; `time` is what functions are of."""

    def __init__(self, expressions: sympy.Tuple) -> None:
        functions = sorted(expressions.atoms(AppliedUndef), key=str)
        times = {each.args[0] for each in functions if len(each.args) == 1}
        if len(times) > 1 or any(len(each.args) > 1 or not each.args[0].is_Symbol for each in functions):
            raise Unsaid("functions of something else than one symbol")
        self.time = next(iter(times), None)
        self.atoms: dict[Any, w.Node] = {}
        variables = {each for each in expressions.free_symbols if each.is_Symbol} | expressions.atoms(MatrixElement)
        for each in (*sorted(variables, key=str), *functions):
            name = each.func.__name__ if each in functions else str(each)
            size = uniform(SCALAR, NO_DIMENSION)
            self.atoms[each] = w.Symbol(name, name, size, constant=each in variables, home=__name__, has_units=False)
        for each in sorted(expressions.atoms(sympy.Derivative), key=str):
            if each.expr not in functions:
                raise Unsaid(f"the rate of {each.expr}")
            rate = self.atoms[each.expr]
            for order in range(each.derivative_count):
                rate = self.atoms[each.expr.diff((self.time, order + 1))] = w.Rate(rate)

    def __call__(self, e: Any) -> w.Node:
        """An expression; raises `Unsaid` where there is no word for it."""
        if e in self.atoms:
            return self.atoms[e]
        if isinstance(e, sympy.Piecewise):
            return self._by_cases(*e.args)
        if e.func is sympy.atan2:
            return FunctionOf("atan2", tuple(map(self, e.args)))
        if e.func in IN_OTHER_WORDS:
            return self(e.rewrite(IN_OTHER_WORDS[e.func]))
        if e is sympy.pi:
            return w.PI
        if e.is_Rational and e < 0:
            return w.Negative(self(-e))
        if e.is_Rational:
            return w.Number(Fraction(int(e.p), int(e.q)))
        if e.func in (sympy.cos, sympy.sin):
            return w.Call(e.func.__name__, self(e.args[0]))
        if e.func in FUNCTIONS:
            return FunctionOf(FUNCTIONS[e.func], (self(e.args[0]),))
        if e.func in QUOTIENTS:
            above, below = QUOTIENTS[e.func](e.args[0])
            return w.Quotient(self(above), self(below))
        if e is sympy.E:
            return FunctionOf("exp", (self(sympy.Integer(1)),))
        if e.func in OF_TWO:
            return reduce(lambda rest, each: FunctionOf(OF_TWO[e.func], (each, rest)), map(self, reversed(e.args)))
        if e.is_Add:
            return w.Sum(tuple(map(self, e.as_ordered_terms())))
        if e.is_Mul:
            return w.Negative(self(-e)) if e.could_extract_minus_sign() else self._product(e)
        if e.is_Pow:
            return self._power(e)
        raise Unsaid(f"{e.func if e.is_Function else e} is no word of the theories")

    def _by_cases(self, first: Any, *others: Any) -> w.Node:
        value, condition = first
        if condition is sympy.true:
            return self(value)
        if not others:
            raise Unsaid(f"what has no value unless {condition}")
        return self._chosen(condition, self(value), self._by_cases(*others))

    def _chosen(self, condition: Any, then: w.Node, otherwise: w.Node) -> w.Node:
        if isinstance(condition, sympy.And):
            return reduce(lambda rest, each: self._chosen(each, rest, otherwise), condition.args, then)
        if isinstance(condition, sympy.Or):
            return reduce(lambda rest, each: self._chosen(each, then, rest), condition.args, otherwise)
        if isinstance(condition, sympy.Ne):
            return self._chosen(sympy.Eq(*condition.args, evaluate=False), otherwise, then)
        condition = condition.reversed if isinstance(condition, sympy.Gt | sympy.Ge) else condition
        if type(condition) not in DECIDED:
            raise Unsaid(f"{condition} is no word of the theories")
        return FunctionOf(DECIDED[type(condition)], (*map(self, condition.args), then, otherwise))

    def _product(self, e: Any) -> w.Node:
        above, below = [], []
        for factor in e.as_ordered_factors():
            if factor.is_Rational and not factor.is_Integer:
                above += [sympy.Integer(factor.p)] * (factor.p != 1)
                below.append(sympy.Integer(factor.q))
            elif factor.is_Pow and factor.exp.is_Rational and factor.exp < 0:
                below.append(1 / factor)
            else:
                above.append(factor)
        return reduce(w.Quotient, map(self, below), reduce(w.Scale, map(self, above or [sympy.Integer(1)])))

    def _power(self, e: Any) -> w.Node:
        base, exponent = e.as_base_exp() if e.exp.is_Rational and e.exp > 0 else (e.base, e.exp)
        if is_exponential(e):
            return FunctionOf("Rpower", (self(base), self(exponent)))
        if exponent < 0:
            return w.Quotient(self(sympy.Integer(1)), self(1 / e))
        if exponent.q > 2:
            raise Unsaid(f"{e} is no word of the theories")
        root = self(base) if exponent.q == 1 else FunctionOf("sqrt", (self(base),))
        return root if exponent.p == 1 else w.Power(root, int(exponent.p))


class _ScalarSpelling(Spelling):
    def _number(self, node: w.Node) -> Spelled:
        if isinstance(node, FunctionOf) and node.function in DECIDED.values():
            *compared, then, otherwise = node.arguments
            decided = " ".join((node.function, *(self.number(each, ATOM) for each in compared)))
            return f"if {decided} then {self.number(then)} else {self.number(otherwise)}", LOOSE + 1
        if isinstance(node, FunctionOf):
            return f"{node.function} {' '.join(self.number(each, ATOM) for each in node.arguments)}", APPLIED
        return super()._number(node)


class ScalarStatement(CoqStatement):
    """What was asked, under what the verdict needs. Raises `Unsaid` where there are no words for it."""

    def __init__(self, asked: Asked, needs: tuple[str, ...]) -> None:
        self.asked = asked
        self.words = words = SympyWords(sympy.Tuple(*asked.expressions))
        self.goals = [(left, asked.right[place]) for place, left in asked.left.items()]
        self.given = [
            ((count, *place), pair) for count, item in enumerate(asked.given) for place, pair in item.pairs.items()
        ]
        self.needed: list[Any] = []
        self.positive: list[Any] = []
        goals, conditions = (
            tuple(Goal("", words(left), words(right)) for left, right in pairs)
            for pairs in (self.goals, [pair for _, pair in self.given])
        )
        assumed = tuple(dict.fromkeys((*self._signs(), *self._divisors(), *self._needs(needs))))
        names = CoqNames()
        self._clock = words.atoms.get(words.time)
        if isinstance(self._clock, w.Symbol):
            names.symbols[self._clock] = "t"
        super().__init__(Problem(goals, conditions=conditions, hypotheses=assumed), names)
        self.timed = words.time is not None
        self.spelling = _ScalarSpelling(self.names, self.applied)

    def is_of_cases(self, certificate: Mapping[str, Any]) -> bool:
        """Whether something is spoken of whose value is told by cases, all else being rational and at rest."""
        everything = sympy.Tuple(*self.asked.expressions)
        others = everything.atoms(sympy.Function) - everything.atoms(sympy.Abs, *BY_CASES)
        return (everything.has(*BY_CASES) or "cases" in certificate) and not others

    def _signs(self) -> Iterator[Hypothesis]:
        for atom, node in self.words.atoms.items():
            kind = next((kind for kind in SIGNS if getattr(atom, f"is_{kind}")), None)
            if kind and atom != self.words.time:
                yield Hypothesis(kind, (node,))

    def _divisors(self) -> Iterator[Hypothesis]:
        """That the given equations divide by nothing that is zero."""
        sides = sympy.Tuple(*(side for _, pair in self.given for side in pair))
        divisors = {power.base for power in sides.atoms(sympy.Pow) if power.exp.is_negative}
        for divisor in sorted(divisors, key=str):
            yield Hypothesis("nonzero", (self.words(divisor),))

    def _needs(self, needs: tuple[str, ...]) -> Iterator[Hypothesis]:
        atoms = self.words.atoms
        said = {*self.asked.real, *(item.text for item in self.asked.given)}
        names = {str(atom): atom for atom in atoms if str(atom).isidentifier()}
        names |= {str(atom.parent): atom.parent for atom in atoms if isinstance(atom, MatrixElement)}
        names |= {str(atom.func): atom.func for atom in atoms if isinstance(atom, AppliedUndef)}
        for text in (need for need in needs if need not in said):
            ending = next((each for each in RELATIONS if text.endswith(each)), None)
            value = sympy.sympify(text.removesuffix(str(ending)), locals=names) if ending else sympy.nan
            if ending is None or not value.atoms(sympy.Symbol, AppliedUndef) <= atoms.keys():
                raise Unsaid(f"the need {text}")
            self.needed.append(value)
            self.positive += [value] * (ending == " > 0")
            yield Hypothesis(RELATIONS[ending], (self.words(value),))

    def _hypothesis(self, hypothesis: Hypothesis) -> str:
        return SIGNS[hypothesis.kind].format(self.spelling.number(hypothesis.subjects[0], PLUS))

    def moves(self, node: w.Node) -> bool:
        """Whether a symbol is a function of time, or time itself."""
        return super().moves(node) or (self.timed and node == self._clock)

    def applied(self, node: w.Node, name: str) -> str:
        """A symbol or rate at the instant."""
        return name if node == self._clock else super().applied(node, name)

    @property
    def binders(self) -> list[tuple[str, str]]:
        """What the statement is for all of, with types."""
        return [(name, kind) for name, kind in super().binders if name != "t"]

    def side(self, e: Any, most: int = LOOSE) -> str:
        """An expression, in brackets if it is looser than `most`."""
        return self.spelling.number(self.words(e), most)
