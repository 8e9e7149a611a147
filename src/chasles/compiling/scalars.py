"""Which steps compute a SymPy scalar? Those of its operations, one by one; what no program computes is refused by name.

Symbols are real. A number that is not rational, such as pi or the root of 2, is read to sixty digits.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from functools import reduce
from itertools import islice
from sys import float_info
from typing import Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational
from sympy.simplify.cse_main import Unevaluated

from chasles.compiling.elementary import PowerTimesLog, functions_by_class
from chasles.compiling.powers import power
from chasles.compiling.taylor import NearZero
from chasles.lowering.builder import Builder
from chasles.lowering.refusal import LoweringError

DIGITS = 60
NEGLIGIBLE = sympy.Float("1e-40")
_LEAST, _MOST, _TINIEST = map(Fraction, (float_info.min, float_info.max, 5e-324))
_SHOWN = 60
_LONG = 500

KNOWN = (
    "sums, products, quotients, powers, roots, exp, log, circular and hyperbolic functions and their inverses, sinc, "
    "erf, gamma, functions of Bessel, Airy, Fresnel and Lambert, integrals of exponentials and sines, floor, ceiling, "
    "Mod, Abs, sign, Heaviside, Min, Max, Piecewise and comparisons"
)


class Scalars:
    """The steps of expressions, asked for by expression; `places` are the steps of symbols.

    Sums and products may be `spelled` as sums and products of others, as SymPy's search for common ones has them. By
    a power that is `shared` is not divided: its reciprocal is multiplied by.
    """

    def __init__(
        self,
        build: Builder,
        places: Mapping[sympy.Expr, int],
        spelled: Mapping[sympy.Basic, Any] | None = None,
        shared: Iterable[sympy.Basic] = (),
    ) -> None:
        self.build = build
        self._places: dict[sympy.Basic, int] = dict(places)
        self._spelled, self._shared = spelled or {}, frozenset(shared)
        self._functions = functions_by_class(build)

    def of(self, expression: sympy.Basic) -> int:
        """The step that holds the expression. Raises `LoweringError` for what no program computes."""
        found = self._places.get(expression)
        if found is None:
            found = self._places[expression] = self._made(expression)
        return found

    def _made(self, expression: sympy.Basic) -> int:
        build = self.build
        spelled = self._spelled.get(expression, expression)
        if isinstance(spelled, Unevaluated) and spelled.func in (sympy.Add, sympy.Mul):
            return (self._sum if spelled.func is sympy.Add else self._product)(spelled.args)
        if expression.is_number:
            return self._number(expression)
        match expression:
            case sympy.Add():
                return self._sum(expression.args)
            case sympy.Mul():
                return self._product(expression.args)
            case sympy.Pow():
                return self._product([expression])
            case sympy.Piecewise():
                value = build.not_a_number()
                for piece, condition in reversed(expression.args):
                    value = self._chosen(condition, self.of(piece), value)
                stated = expression.args[-1][0]
                if isinstance(expression, NearZero) and len(stated.args) == 2 and stated.args[0].is_Number:
                    # In the derivative of one term and a number nothing cancels.
                    build.rate_by(value, (self.of(stated), build.one))
                return value
            case sympy.log():
                return self._logarithm(expression.args[0])
            case PowerTimesLog():
                base, exponent, of = expression.args
                return self._power_times_log(base, Fraction(int(exponent.p), int(exponent.q)), of)
            case sympy.UnevaluatedExpr():
                return self.of(expression.args[0])
            case sympy.logic.boolalg.Boolean():
                return self._chosen(expression, build.one, build.zero)
            case _ if type(expression) in self._functions:
                return self._functions[type(expression)](*map(self.of, expression.args))
            case sympy.Symbol():
                raise LoweringError(f"{expression} is not among the inputs")
            case sympy.Function():
                # A curve of biomechanics, and whatever else says itself what it is.
                meant = expression.doit(deep=False)
                if meant != expression:
                    return self.of(meant)
        raise LoweringError(_refusal(expression))

    def _number(self, expression: sympy.Expr) -> int:
        if expression is sympy.nan:
            return self.build.not_a_number()
        value = expression if isinstance(expression, sympy.Rational | sympy.Float) else expression.evalf(DIGITS)
        if isinstance(value, sympy.Float) and abs(value) < NEGLIGIBLE and expression.equals(0):
            return self.build.zero
        if not isinstance(value, sympy.Rational | sympy.Float) or not value.is_finite:
            raise LoweringError(f"the constant {shown(expression)} is no finite real number")
        exact = Fraction(*map(int, sympy.Rational(value).as_numer_denom()))
        if exact and not _LEAST <= abs(exact) <= _MOST and (abs(exact) > _MOST or (exact / _TINIEST).denominator > 1):
            raise LoweringError(f"the constant {shown(expression)} is out of the range of double precision")
        return self.build.constant(exact)

    def _sum(self, terms: Sequence[sympy.Expr]) -> int:
        first, *rest = map(self.of, terms)
        return reduce(self.build.add, rest, first)

    def _logarithm(self, of: sympy.Expr) -> int:
        """The logarithm; that of 1 + x is a function of its own, which loses nothing near one.

        That of a whole power is a multiple, which is in range where the power is not.
        """
        if isinstance(of, sympy.Pow) and of.exp.is_Integer and of.exp > 0:
            base = sympy.Abs(of.base) if of.exp.is_even else of.base
            return self.build.multiply(self.of(of.exp), self._logarithm(base))
        build = self.build
        if isinstance(of, sympy.Add) and sympy.S.One in of.args:
            return build.function("log1p", self._sum([term for term in of.args if term is not sympy.S.One]))
        return build.function("log", self.of(of))

    def _power_times_log(self, base: Any, exponent: Fraction, of: Any) -> int:
        build, b, whole, log = self.build, self.of(base), self.of(of), self._logarithm(of)
        others = [] if base == of else [f.as_base_exp() for f in sympy.Mul.make_args(of) if f != base]
        factors = [(self.of(f), self.of(times)) for f, times in others]

        def raised(to: Fraction) -> int:
            """The power times the logarithm."""
            product = build.multiply(power(build, b, to), log)
            zero = build.select(build.equal(b, build.zero), build.zero, product)
            return zero if base == of else build.select(build.equal(whole, build.zero), zero, product)

        value = raised(exponent)
        if exponent < 1:
            slope = build.add(build.multiply(build.constant(exponent), log), build.one)
            slope = build.divide(slope, power(build, b, 1 - exponent))
        else:
            inner = raised(exponent - 1) if exponent > 1 else log
            slope = build.add(build.multiply(build.constant(exponent), inner), power(build, b, exponent - 1))
        by_others = [(f, build.divide(build.multiply(times, power(build, b, exponent)), f)) for f, times in factors]
        return build.rate_by(value, (b, slope), *by_others)

    def _product(self, factors: Sequence[sympy.Expr]) -> int:
        above: list[int] = []
        below: list[int] = []
        for factor in factors:
            if len(factors) > 1 and isinstance(factor, sympy.Pow) and factor in self._shared:
                above.append(self.of(factor))
                continue
            if not isinstance(factor, sympy.Pow):
                above.append(self.of(factor))
                continue
            base, exponent = factor.as_base_exp()
            if not isinstance(exponent, sympy.Rational | sympy.Float):
                above.append(self.build.function("pow", self.of(base), self.of(exponent)))
                continue
            exact = Fraction(*map(int, sympy.Rational(exponent).as_numer_denom()))
            (below if exact < 0 else above).append(power(self.build, self.of(base), abs(exact)))
        numerator = reduce(self.build.multiply, above, self.build.one)
        return self.build.divide(numerator, reduce(self.build.multiply, below)) if below else numerator

    def _chosen(self, condition: sympy.Basic, one: int, other: int) -> int:
        """The one step where the condition holds, else the other."""
        match condition:
            case sympy.logic.boolalg.BooleanTrue():
                return one
            case sympy.logic.boolalg.BooleanFalse():
                return other
            case sympy.And():
                for part in sorted(condition.args, key=sympy.default_sort_key):
                    one = self._chosen(part, one, other)
                return one
            case sympy.Or():
                for part in sorted(condition.args, key=sympy.default_sort_key):
                    other = self._chosen(part, one, other)
                return other
            case sympy.ITE():
                test, if_so, otherwise = condition.args
                return self._chosen(test, self._chosen(if_so, one, other), self._chosen(otherwise, one, other))
            case sympy.Not():
                return self._chosen(condition.args[0], other, one)
            case Relational():
                return self._compared(condition, one, other)
        if isinstance(condition, sympy.logic.boolalg.BooleanFunction):
            return self._chosen(sympy.to_nnf(condition), one, other)
        raise LoweringError(
            f"the condition {shown(condition)} is no comparison of numbers; write it with <, <=, >, >=, Eq, Ne, And, "
            "Or and Not"
        )

    def _compared(self, relation: Relational, one: int, other: int) -> int:
        """The one step where the relation holds, else the other; with NaN none holds but `Ne`."""
        build, left, right = self.build, self.of(relation.lhs), self.of(relation.rhs)
        if isinstance(relation, sympy.StrictGreaterThan | sympy.GreaterThan):
            left, right = right, left
        match relation:
            case sympy.Equality():
                return build.select(build.equal(left, right), one, other)
            case sympy.Unequality():
                return build.select(build.equal(left, right), other, one)
            case sympy.StrictLessThan() | sympy.StrictGreaterThan():
                return build.select(build.less(left, right), one, other)
        return build.select(build.less(left, right), one, build.select(build.equal(left, right), one, other))


def _refusal(expression: sympy.Basic) -> str:
    said = shown(expression)
    if isinstance(expression, AppliedUndef):
        return f"{said} is an unknown function: put what it is in its place, or a symbol that is an input"
    if isinstance(expression, sympy.Derivative | sympy.Integral | sympy.Sum | sympy.Product | sympy.Limit):
        return f"{said} is not evaluated ({type(expression).__name__}): call .doit() first"
    return f"no program computes {said} ({type(expression).__name__}); it computes {KNOWN}"


def shown(value: object) -> str:
    """The beginning of what it reads, on one line; nothing of what would take long to print."""
    if isinstance(value, sympy.Basic) and next(islice(sympy.preorder_traversal(value), _LONG, None), None) is not None:
        return f"{type(value).__name__}(...)"
    text = " ".join(str(value).split())
    return text if len(text) <= _SHOWN else f"{text[:_SHOWN]}..."
