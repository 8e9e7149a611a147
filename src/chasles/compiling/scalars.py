"""Which steps compute a SymPy scalar? Those of its operations, one by one; what no program computes is refused by name.

Symbols are real. A number that is not rational, such as pi or the root of 2, stands for its first sixty digits.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction

import sympy
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational

from chasles.lowering.builder import Builder
from chasles.lowering.refusal import LoweringError

__all__ = ["Scalars", "shown"]

DIGITS = 60
NEGLIGIBLE = sympy.Float("1e-40")
_SHOWN = 60

KNOWN = (
    "sums, products, quotients, whole and half powers, sqrt, sin, cos, tan, cot, sec, csc, sinc, asin, acos, atan, "
    "atan2, Abs, sign, Min, Max and Piecewise"
)


class Scalars:
    """The steps of expressions, asked for by expression; `places` are the steps of symbols."""

    def __init__(self, build: Builder, places: Mapping[sympy.Expr, int]) -> None:
        self.build = build
        self._places: dict[sympy.Basic, int] = dict(places)
        self._conditions: dict[sympy.Basic, sympy.Basic] = {}
        self._functions: dict[type, Callable[..., int]] = {
            sympy.sin: build.sine,
            sympy.cos: build.cosine,
            sympy.tan: lambda a: build.divide(build.sine(a), build.cosine(a)),
            sympy.cot: lambda a: build.divide(build.cosine(a), build.sine(a)),
            sympy.sec: lambda a: build.divide(build.one, build.cosine(a)),
            sympy.csc: lambda a: build.divide(build.one, build.sine(a)),
            sympy.sinc: self._sinc,
            sympy.atan2: build.arctangent2,
            sympy.atan: lambda a: build.arctangent2(a, build.one),
            sympy.asin: lambda a: build.arctangent2(a, self._leg(a)),
            sympy.acos: lambda a: build.arctangent2(self._leg(a), a),
            sympy.Abs: lambda a: build.select(build.less(a, build.zero), build.negate(a), a),
            sympy.sign: self._sign,
            sympy.Max: lambda *many: self._extreme(many, largest=True),
            sympy.Min: lambda *many: self._extreme(many, largest=False),
        }

    def define(self, symbol: sympy.Symbol, meaning: sympy.Basic) -> None:
        """Let a symbol stand for an expression or a condition."""
        if isinstance(meaning, sympy.logic.boolalg.Boolean):
            self._conditions[symbol] = meaning
        else:
            self._places[symbol] = self.of(meaning)

    def of(self, expression: sympy.Basic) -> int:
        """The step that holds the expression. Raises `LoweringError` for what no program computes."""
        found = self._places.get(expression)
        if found is None:
            found = self._places[expression] = self._made(expression)
        return found

    def _made(self, expression: sympy.Basic) -> int:
        build = self.build
        if expression.is_number:
            return self._number(expression)
        match expression:
            case sympy.Add():
                terms = [self.of(term) for term in expression.args]
                total = terms[0]
                for term in terms[1:]:
                    total = build.add(total, term)
                return total
            case sympy.Mul():
                return self._product(expression.args)
            case sympy.Pow():
                return self._product([expression])
            case sympy.Piecewise():
                value = build.not_a_number()
                for piece, condition in reversed(expression.args):
                    value = self._chosen(condition, self.of(piece), value)
                return value
            case sympy.Function() | sympy.Max() | sympy.Min() if type(expression) in self._functions:
                return self._functions[type(expression)](*map(self.of, expression.args))
            case sympy.Symbol():
                raise LoweringError(f"{expression} is not among the inputs")
        raise LoweringError(_refusal(expression))

    def _number(self, expression: sympy.Expr) -> int:
        if expression is sympy.nan:
            return self.build.not_a_number()
        value = expression if isinstance(expression, sympy.Rational | sympy.Float) else expression.evalf(DIGITS)
        if isinstance(value, sympy.Float) and abs(value) < NEGLIGIBLE and expression.equals(0):
            return self.build.zero
        if not isinstance(value, sympy.Rational | sympy.Float) or not value.is_finite:
            raise LoweringError(f"the constant {shown(expression)} is no finite real number")
        exact = sympy.Rational(value)
        return self.build.constant(Fraction(int(exact.p), int(exact.q)))

    def _product(self, factors: Iterable[sympy.Expr]) -> int:
        above: list[int] = []
        below: list[int] = []
        for factor in factors:
            base, exponent = factor.as_base_exp() if isinstance(factor, sympy.Pow) else (factor, sympy.Integer(1))
            halves = 2 * sympy.Rational(exponent) if isinstance(exponent, sympy.Rational | sympy.Float) else sympy.nan
            if not halves.is_Integer:
                raise LoweringError(_refusal(factor))
            power = self._power(self.of(base), abs(int(halves)))
            (below if halves.is_negative else above).append(power)
        numerator = self._multiplied(above)
        return self.build.divide(numerator, self._multiplied(below)) if below else numerator

    def _multiplied(self, steps: Iterable[int]) -> int:
        total = self.build.one
        for step in steps:
            total = self.build.multiply(total, step)
        return total

    def _power(self, base: int, halves: int) -> int:
        """The base to so many halves, by squaring."""
        total = self.build.square_root(base) if halves % 2 else self.build.one
        whole = halves // 2
        while whole:
            if whole % 2:
                total = self.build.multiply(total, base)
            whole //= 2
            base = self.build.multiply(base, base) if whole else base
        return total

    def _leg(self, a: int) -> int:
        """The root of 1 - a^2, in factors, which lose nothing near 1."""
        build = self.build
        return build.square_root(build.multiply(build.subtract(build.one, a), build.add(build.one, a)))

    def _sinc(self, a: int) -> int:
        """The quotient sin(a) / a, and 1 for 0."""
        build = self.build
        is_zero = build.equal(a, build.zero)
        return build.divide(build.select(is_zero, build.one, build.sine(a)), build.select(is_zero, build.one, a))

    def _sign(self, a: int) -> int:
        build = self.build
        positive = build.select(build.less(build.zero, a), build.one, a)
        return build.select(build.less(a, build.zero), build.negate(build.one), positive)

    def _extreme(self, many: Iterable[int], *, largest: bool) -> int:
        """The largest or the smallest; not a number where one of them is none."""
        build, (found, *rest) = self.build, many
        for other in rest:
            low, high = (found, other) if largest else (other, found)
            same = build.select(build.equal(found, other), found, build.not_a_number())
            found = build.select(build.less(low, high), other, build.select(build.less(high, low), found, same))
        return found

    def _chosen(self, condition: sympy.Basic, one: int, other: int) -> int:
        """The one step where the condition holds, else the other."""
        condition = self._conditions.get(condition, condition)
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
        return f"{said} is not carried out ({type(expression).__name__}): call .doit() first"
    if isinstance(expression, sympy.Pow):
        return f"the power {said}: exponents must be whole numbers or halves of them"
    return f"no program computes {said} ({type(expression).__name__}); it computes {KNOWN}"


def shown(value: object) -> str:
    """The beginning of what it reads, on one line."""
    text = " ".join(str(value).split())
    return text if len(text) <= _SHOWN else f"{text[:_SHOWN]}..."
