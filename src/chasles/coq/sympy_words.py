"""Expressions of SymPy in words: symbols are real numbers, and functions of one symbol move."""

from __future__ import annotations

from fractions import Fraction
from functools import reduce
from typing import Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.matrices.expressions.matexpr import MatrixElement

from chasles import vocabulary as w
from chasles.checker.expressions.complexes import OF_COMPLEX
from chasles.coq.expressions import Unsaid
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
DECIDED = {sympy.Lt: "Rlt_dec", sympy.Le: "Rle_dec", sympy.Eq: "Req_EM_T"}
"""What Coq decides of two numbers."""
SAID = frozenset({
    *FUNCTIONS, *QUOTIENTS, *OF_TWO, *IN_OTHER_WORDS, *OF_COMPLEX, sympy.cos, sympy.sin, sympy.atan2, sympy.Piecewise,
})  # fmt: skip
"""Functions with a word, or written in others; those of complex numbers, in their parts."""


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
                raise Unsaid(f"{each} is a derivative of an expression, and no rate of a function of time")
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
        if isinstance(condition, sympy.Not):
            return self._chosen(condition.args[0], otherwise, then)
        if isinstance(condition, sympy.Implies | sympy.Equivalent) and len(condition.args) == 2:
            first, second = condition.args
            unless = then if isinstance(condition, sympy.Implies) else self._chosen(second, otherwise, then)
            return self._chosen(first, self._chosen(second, then, otherwise), unless)
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
