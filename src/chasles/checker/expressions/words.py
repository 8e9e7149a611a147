"""The entries of words as SymPy expressions; where something moves, quantities are functions of time."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from chasles import vocabulary as w
from chasles.checker.expansion import Formless, expanded
from chasles.checker.expressions.bounded_angles import Bounds, in_fewer_squares
from chasles.checker.expressions.rates import MOST_RATES
from chasles.checker.expressions.switches import SWITCHES, deciding
from chasles.checker.expressions.visible import signs_of
from chasles.checker.sparse import Rejected
from chasles.statements import Hypothesis, Problem
from chasles.vocabulary.functions import Cases, FunctionOf
from chasles.vocabulary.letters import entry_names

TIME = sp.Symbol("t")  # no quantity is the time, whatever its name: quantities are real
FUNCTIONS = {
    "sin": sp.sin, "cos": sp.cos, "sqrt": sp.sqrt, "abs": sp.Abs, "exp": sp.exp, "log": sp.log, "arcsin": sp.asin,
    "arccos": sp.acos, "arctan": sp.atan, "atan2": sp.atan2, "sinh": sp.sinh, "cosh": sp.cosh, "tanh": sp.tanh,
    "arcsinh": sp.asinh, "arccosh": sp.acosh, "arctanh": sp.atanh,
    "sign": lambda x: sp.Piecewise((1, x > 0), (-1, x < 0), (0, True)), "max": sp.Max, "min": sp.Min,
}  # fmt: skip
DOMAINS = {
    "sqrt": lambda x: x, "log": lambda x: x, "arccosh": lambda x: x - 1,
    **dict.fromkeys(("arcsin", "arccos", "arctanh"), lambda x: 1 - x**2),
}  # fmt: skip
"""What is not negative where a function is real."""
RELATIONS = {"<": sp.Lt, "<=": sp.Le, ">": sp.Gt, ">=": sp.Ge}


class EntriesOfWords:
    """The entries of expressions as SymPy expressions; where something moves, quantities are functions of time."""

    def __init__(self, problem: Problem) -> None:
        self.rules = dict(problem.rules)
        stated = [goal.sides for goal in (*problem.goals, *problem.conditions)]
        stated += [*problem.rules, *(equation for h in problem.hypotheses for equation in h.equations)]
        self.moving = any(isinstance(part, w.Rate) for pair in stated for side in pair for part in w.walk(side))
        self.known: dict[w.Node, Any] = {}
        self.named: dict[str, tuple[w.Symbol, int, int]] = {}
        self.divisors: dict[Any, None] = {}
        self.applied: dict[Any, Any] = {}
        self.used: dict[str, None] = {}
        self.units: dict[str, list[Any]] = {}
        self.positive: dict[Any, str] = {}
        self.bounds: dict[tuple[Any, Any], Bounds] = {}
        assumed = [h for h in problem.hypotheses if h.kind != "inequality"]
        self.signs = {str(s): {"nonnegative": True} for s in problem.nonnegative}
        self.signs |= {str(s): {"positive": True} for h in assumed if h.kind == "positive" for s in h.subjects}
        inequalities = [h for h in problem.hypotheses if h.kind == "inequality"]
        self.by_sign = frozenset(h.text for h in inequalities if self._signed(h))
        self.known.clear()
        units = (h for h in assumed if h.kind == "unit" and h.subjects[0] not in self.rules)
        self.units |= {h.text: list(self(h.subjects[0])) for h in units}
        for h in inequalities:
            difference = self(h.subjects[0])[0]
            if h.nonvanishing:
                self.positive[difference] = h.text
            quantity = min(difference.atoms(AppliedUndef) or difference.free_symbols, key=str, default=sp.S.Zero)
            for unit in (sp.pi, sp.S.One):
                known = self.bounds.setdefault((quantity, unit), Bounds(unit))
                known.narrow(difference, quantity, bool(h.nonvanishing), h.text)

    def __call__(self, node: w.Node) -> Any:
        """The entries as an immutable matrix."""
        if node not in self.known:
            self.known[node] = self._made(node)
        return self.known[node]

    def _signed(self, hypothesis: Hypothesis) -> bool:
        """Whether an inequality is the sign of one quantity, which is taken note of."""
        difference = self(hypothesis.subjects[0])[0]
        for sign, names in ((1, ("positive", "nonnegative")), (-1, ("negative", "nonpositive"))):
            quantity = sign * difference
            if quantity.is_Symbol or (quantity.is_Function and quantity.args == (TIME,)):
                name = str(quantity if quantity.is_Symbol else quantity.func)
                self.signs[name] = {**self.signs.get(name, {}), names[not hypothesis.nonvanishing]: True}
                return True
        return False

    def values_between(self, sides: Any, numbers: bool) -> dict[Any, tuple[Any, tuple[str, ...]]]:
        """Quantities between multiples of pi, or `numbers`: what has all values between these, and their texts."""
        found: dict[Any, tuple[Any, tuple[str, ...]]] = {}
        for (quantity, unit), bounds in self.bounds.items():
            wanted = quantity not in found and (numbers or unit == sp.pi)
            value = bounds.value(quantity, [sides], self._fresh) if wanted else None
            if value is not None:
                found[quantity] = value, bounds.texts
        return found

    def factored(self, matrix: w.Node) -> tuple[Any, list[Any]]:
        """Any positive-definite matrix of that shape: L D L.T, L lower triangular with ones; and D's diagonal."""
        size, name = matrix.shape[0], w.plain(matrix)
        diagonal = [self._fresh(f"d_{name}_{k + 1}", positive=True) for k in range(size)]
        below = {(i, j): self._fresh(f"l_{name}_{i + 1}{j + 1}") for i in range(size) for j in range(i)}
        lower = sp.Matrix(size, size, lambda i, j: below.get((i, j), int(i == j)))
        return lower * sp.diag(*diagonal) * lower.T, diagonal

    def _fresh(self, name: str, **sign: bool) -> Any:
        """A quantity with a name that no other has."""
        while name in self.named:
            name += "_"
        self.named[name] = (w.PI, 0, 0)
        return sp.Function(name, real=True, **sign)(TIME) if self.moving else sp.Symbol(name, real=True, **sign)

    @property
    def reasons(self) -> dict[str, None]:
        """The texts of the hypotheses by which quantities have signs, and arguments are said otherwise."""
        return dict.fromkeys((*sorted(self.by_sign), *self.used))

    def equations(self, left: w.Node, right: w.Node) -> Iterator[Any]:
        """The equations between the entries, but for those that are true on their face."""
        for one, other in zip(self(left), self(right), strict=True):
            if one != other:
                yield sp.Eq(one, other, evaluate=False)

    def _made(self, node: w.Node) -> Any:
        match node:
            case _ if node in self.rules:
                return self(self.rules[node])
            case w.Symbol(stands_for=w.Node() as of) | w.Group(of) | w.At(of, "t"):
                return self(of)
            case w.Symbol():
                return _shaped(node, self._quantity(node))
            case w.Rate(of):
                self._divide(e for e in deciding(sorted(self(of).atoms(*SWITCHES), key=str)) if e.has(TIME))
                return self._with_given_rates(self(of).diff(TIME))
            case FunctionOf(function, arguments):
                return _one(self._value(function, [self._shorter(self(of)[0]) for of in arguments]))
            case w.Call(function, argument):
                return _one(FUNCTIONS[function](self(argument)[0]))
            case Cases(values, left, right, signs):
                where = [RELATIONS[s](self(a)[0], self(b)[0]) for a, s, b in zip(left, signs, right, strict=True)]
                entries = zip(*map(self, values), strict=True)
                return _shaped(node, (sp.Piecewise(*zip(each, [*where, True], strict=True)) for each in entries))
            case w.Quotient(numerator, denominator):
                divisor = self(denominator)[0]
                self._divide([divisor])
                return self(numerator) / divisor
            case w.Norm(of):
                return _one(sp.sqrt(self._shorter(sum(entry**2 for entry in self(of)))))
        try:
            return sp.ImmutableMatrix(expanded(node, lambda of: self(of).tolist(), sp.Rational))
        except Formless:
            raise Rejected(f"{w.plain(node)} cannot stand beside what has no polynomial form") from None

    def _divide(self, divisors: Iterable[Any]) -> None:
        """Take note of the factors of what must not vanish."""
        factors = [part.as_base_exp()[0] for e in divisors for part in sp.Mul.make_args(e)]
        self.divisors |= {of.args[0] if isinstance(of, sp.Abs) else of: None for of in factors}

    def _with_given_rates(self, entries: Any) -> Any:
        """The entries with what is given for the rates of symbols, and for higher rates what follows of it."""
        given: dict[Any, tuple[int, Any]] = {}
        for left, right in self.rules.items():
            base, order = w.undotted(left)
            if order and isinstance(base, w.Symbol) and base not in self.rules:
                given |= {q: (order, value) for q, value in zip(self._quantity(base), self(right), strict=True)}
        for _ in range(MOST_RATES):
            rates = [each for each in entries.atoms(sp.Derivative) if each.expr in given]
            known = {each: given[each.expr] for each in rates if each.derivative_count >= given[each.expr][0]}
            if not known:
                return entries
            values = {each: value.diff((TIME, each.derivative_count - k)) for each, (k, value) in known.items()}
            entries = entries.xreplace(values)
        raise Rejected("what is given for rates leads back to them")

    def _value(self, function: str, arguments: list[Any]) -> Any:
        """A function's value; where it is real is noted. Of a point's angle, positive factors are left out."""
        if function == "atan2":
            common = {*sp.Mul.make_args(arguments[0])}.intersection(sp.Mul.make_args(arguments[1]))
            positive = [e for e in common if e in self.positive or signs_of(e) == {1}]
            self.used |= dict.fromkeys(sorted(self.positive[e] for e in positive if e in self.positive))
            arguments = [argument / sp.Mul(*positive) for argument in arguments]
        value = FUNCTIONS[function](*arguments)
        if function in DOMAINS:
            self.applied[value] = DOMAINS[function](*arguments)
        return value

    def lost_divisors(self, sides: Any) -> list[Any]:
        """The factors by which is divided, and which have been cancelled: sides that stand where they vanish too."""
        left = {power.base for power in sides.atoms(sp.Pow) if power.exp.is_negative}
        return [divisor for divisor in self.divisors if 0 in signs_of(divisor) and divisor not in left]

    def lost_domains(self, sides: Any) -> list[Any]:
        """What is not negative where functions are real that have been simplified away, or to what is not real."""
        return [d for v, d in self.applied.items() if (not sides.has(v) or v.has(sp.I)) and -1 in signs_of(d)]

    def _shorter(self, argument: Any) -> Any:
        found, texts = in_fewer_squares(argument, self.units)
        self.used |= dict.fromkeys(texts)
        turned = {e.args[0] for e in found.atoms(sp.sin, sp.cos)}
        circles = {str(angle): [sp.sin(angle), sp.cos(angle)] for angle in sorted(turned, key=str)}
        return in_fewer_squares(found, circles)[0]

    def _quantity(self, symbol: w.Symbol) -> Iterator[Any]:
        if symbol == w.PI:
            yield sp.pi
            return
        for i, row in enumerate(entry_names(symbol.name, *symbol.shape), 1):
            for j, name in enumerate(row, 1):
                if self.named.setdefault(name, (symbol, i, j)) != (symbol, i, j):
                    raise Rejected(f"two different quantities are both named {name}: rename one")
                sign = self.signs.get(name, {})
                moves = self.moving and not symbol.constant
                yield sp.Function(name, real=True, **sign)(TIME) if moves else sp.Symbol(name, real=True, **sign)


def _one(value: Any) -> Any:
    return sp.ImmutableMatrix([[value]])


def _shaped(node: w.Node, entries: Iterator[Any]) -> Any:
    return sp.ImmutableMatrix(*node.shape, list(entries))
