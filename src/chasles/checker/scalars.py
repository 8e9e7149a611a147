"""A problem in which functions of scalars occur, as a question on SymPy expressions, entry by entry.

Prover and checker read such a problem here, and from here on as they read what SymPy users ask.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from operator import add, mul
from typing import Any

import sympy as sp

from chasles import vocabulary as w
from chasles.checker.expressions.counterexample import check_refutation
from chasles.checker.expressions.proof import check_proof
from chasles.checker.refutation import Shown
from chasles.checker.sparse import Rejected
from chasles.statements import Problem
from chasles.verdict import Counterexample, Holds, HoldsUnder
from chasles.vocabulary.functions import Cases, FunctionOf

__all__ = ["ScalarQuestion", "check_scalar_counterexample", "check_scalars", "scalar_question"]

TIME = sp.Symbol("t", real=True)
FUNCTIONS = {
    "sin": sp.sin, "cos": sp.cos, "sqrt": sp.sqrt, "abs": sp.Abs, "exp": sp.exp, "log": sp.log, "arcsin": sp.asin,
    "arccos": sp.acos, "arctan": sp.atan, "atan2": sp.atan2, "sinh": sp.sinh, "cosh": sp.cosh, "tanh": sp.tanh,
    "sign": sp.sign, "max": sp.Max, "min": sp.Min,
}  # fmt: skip
RELATIONS = {"<": sp.Lt, "<=": sp.Le, ">": sp.Gt, ">=": sp.Ge}
BY_MORE = frozenset(("definite",))
"""Hypotheses that say more than their equations and what they keep from vanishing."""


@dataclass(frozen=True, slots=True)
class ScalarQuestion:
    """Both sides of all goals, one entry below the other, what is given, and what does not vanish.

    `places` are the goal, row and column of each entry; `sources` who says what is given, by its text in SymPy. If it
    is `partial`, hypotheses say more than that: a proof counts, a counterexample does not.
    """

    left: Any
    right: Any
    given: tuple[Any, ...]
    nonzero: tuple[Any, ...]
    places: tuple[tuple[str, tuple[int, int]], ...]
    sources: Mapping[str, str]
    partial: bool

    @property
    def asked(self) -> tuple[Any, ...]:
        """The question as `chasles.prove` takes it."""
        return self.left, self.right, self.given, self.nonzero


def scalar_question(problem: Problem) -> ScalarQuestion | None:
    """The question that a problem asks if functions occur in it, else None; raises `Rejected` for other words."""
    if not problem.has_functions:
        return None
    entries = _Entries(problem)
    given: list[Any] = []
    nonzero: list[Any] = []
    sources: dict[str, str] = {}
    stated = [(goal.label, goal.left, goal.right) for goal in problem.conditions]
    stated += [(h.text, left, right) for h in problem.hypotheses for left, right in h.equations]
    for text, left, right in stated:
        for equation in entries.equations(left, right):
            given.append(equation)
            sources[f"{equation.lhs} = {equation.rhs}"] = text
    for hypothesis in problem.hypotheses:
        for node in hypothesis.nonvanishing if hypothesis.kind != "positive" else ():
            value = entries(node)[0]
            nonzero.append(value)
            sources[f"{value} != 0"] = hypothesis.text
    sides = [[entries(side) for side in (goal.left, goal.right)] for goal in problem.goals]
    left, right = (sp.Matrix([entry for pair in sides for entry in pair[k]]) for k in (0, 1))
    shapes = [(goal.label, *goal.left.shape) for goal in problem.goals]
    places = tuple((label, (i + 1, j + 1)) for label, m, n in shapes for i in range(m) for j in range(n))
    partial = any(h.kind in BY_MORE for h in problem.hypotheses)
    return ScalarQuestion(left, right, tuple(given), tuple(nonzero), places, sources, partial)


def check_scalars(problem: Problem, certificate: Mapping[str, Any]) -> None:
    """The certificate proves the question that the problem asks; raises `Rejected` with the reason if not."""
    question = _asked(problem)
    needs = tuple(certificate["needs"])
    shown = certificate.get("point")
    witness: Any = None if shown is None else {name: Fraction(value) for name, value in shown.items()}
    made = HoldsUnder(needs, certificate["scalars"], witness) if needs else Holds(certificate["scalars"], witness)
    check_proof(made, *question.asked)


def check_scalar_counterexample(problem: Problem, shown: Shown) -> None:
    """The point refutes the question that the problem asks; raises `Rejected` with the reason if not."""
    question = _asked(problem)
    if question.partial:
        raise Rejected("a hypothesis says more than equations, and nothing shows that the point satisfies it")
    if (shown.goal, shown.entry) not in question.places:
        raise Rejected(f"no equation of the statement is called {shown.goal!r}, or it has no such entry")
    row = question.places.index((shown.goal, shown.entry))
    check_refutation(Counterexample(shown.at, (row + 1, 1), shown.left, shown.right), *question.asked)


def _asked(problem: Problem) -> ScalarQuestion:
    question = scalar_question(problem)
    if question is None:
        raise Rejected("no function of scalars occurs in the problem")
    return question


class _Entries:
    """The entries of expressions as SymPy expressions; where something moves, quantities are functions of time."""

    def __init__(self, problem: Problem) -> None:
        self.rules = dict(problem.rules)
        stated = [(goal.left, goal.right) for goal in (*problem.goals, *problem.conditions)]
        stated += [*problem.rules, *(equation for h in problem.hypotheses for equation in h.equations)]
        self.moving = any(isinstance(part, w.Rate) for pair in stated for side in pair for part in w.walk(side))
        positive = [s for h in problem.hypotheses if h.kind == "positive" for s in h.subjects]
        self.signs = (("positive", positive), ("nonnegative", problem.nonnegative))
        self.known: dict[w.Node, Any] = {}

    def __call__(self, node: w.Node) -> Any:
        """The entries as an immutable matrix."""
        if node not in self.known:
            self.known[node] = self._made(node)
        return self.known[node]

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
                return self(of).diff(TIME)
            case w.Number(value):
                return _one(sp.Rational(value.numerator, value.denominator))
            case w.Identity(size):
                return sp.eye(size).as_immutable()
            case w.Zero(rows, columns):
                return sp.zeros(rows, columns).as_immutable()
            case w.Block(rows):
                lines = [sp.Matrix.hstack(*map(self, row)) for row in rows]
                return sp.Matrix.vstack(*lines).as_immutable()
            case FunctionOf(function, arguments):
                return _one(FUNCTIONS[function](*(self(argument)[0] for argument in arguments)))
            case w.Call(function, argument):
                return _one(FUNCTIONS[function](self(argument)[0]))
            case Cases(values, left, right, signs):
                where = [RELATIONS[s](self(a)[0], self(b)[0]) for a, s, b in zip(left, signs, right, strict=True)]
                entries = zip(*map(self, values), strict=True)
                return _shaped(node, (sp.Piecewise(*zip(each, [*where, True], strict=True)) for each in entries))
            case _:
                return self._combined(node)

    def _combined(self, node: w.Node) -> Any:
        match node:
            case w.Sum(terms):
                return reduce(add, map(self, terms))
            case w.Negative(term):
                return -self(term)
            case w.Scale(factor, term):
                return self(term) * self(factor)[0]
            case w.Quotient(numerator, denominator):
                return self(numerator) / self(denominator)[0]
            case w.Contract(factors):
                return reduce(mul, map(self, factors))
            case w.Power(base, exponent):
                return self(base) ** exponent
            case w.Transpose(of):
                return self(of).T
            case w.Dot(left, right):
                return self(left).T * self(right)
            case w.Norm(of):
                return _one(sp.sqrt(sum(entry**2 for entry in self(of))))
            case w.Skew(of):
                return _skew(self(of))
            case w.Cross(left, right):
                return _skew(self(left)) * self(right)
            case w.Vect(of):
                m = self(of)
                return sp.ImmutableMatrix([m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]]) / 2
            case w.Trace(of):
                return _one(self(of).trace())
            case w.Determinant(of):
                return _one(self(of).det(method="berkowitz"))
            case w.Cofactor(of):
                return self(of).cofactor_matrix(method="berkowitz").as_immutable()
            case _:
                raise Rejected(f"{w.plain(node)} cannot stand beside functions of scalars")

    def _quantity(self, symbol: w.Symbol) -> Iterator[Any]:
        if symbol == w.PI:
            yield sp.pi
            return
        rows, columns = symbol.shape
        sign = {name: True for name, those in self.signs if symbol in those}
        for i in range(1, rows + 1):
            for j in range(1, columns + 1):
                place = "" if symbol.is_scalar else f"_{i}" if columns == 1 else f"_{i}{j}"
                name = f"{symbol.name}{place}"
                moves = self.moving and not symbol.constant
                yield sp.Function(name, real=True, **sign)(TIME) if moves else sp.Symbol(name, real=True, **sign)


def _one(value: Any) -> Any:
    return sp.ImmutableMatrix([[value]])


def _shaped(node: w.Node, entries: Iterator[Any]) -> Any:
    return sp.ImmutableMatrix(*node.shape, list(entries))


def _skew(vector: Any) -> Any:
    x, y, z = vector
    return sp.ImmutableMatrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])
