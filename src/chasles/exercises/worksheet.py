"""The worksheet of an exercise: each step evaluates, tests or solves an equation of the book, exactly.

Values are bound to the book's symbols. A step names a declaration; its right side, at the values known so far, gives
the value of its left side. A claim is decided before it is used, and used as repaired where it is wrong as printed;
what it assumes is tested at the values. Nothing is computed by a formula that the book does not declare.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import sympy as sp

from chasles.exact.evaluate import NoValue, evaluate, matrix_of
from chasles.exact.linear import Solutions, solve_linear
from chasles.exact.numbers import is_zero, normal, sign
from chasles.exact.spelling import SpelledValue, text_of, words_in_latex
from chasles.exercises.decided import Decided, Refuted, Sentence
from chasles.exercises.picture import Picture
from chasles.exercises.solution import (
    SolutionStep,
    chain,
    compared,
    confirmed,
    equation,
    scalar_or_matrix,
    solved,
    stated,
)
from chasles.problems.variables import angle_multiples
from chasles.statements import Hypothesis, Inverse, Statement
from chasles.statements.statement import bare
from chasles.vocabulary import Call, Node, latex, plain

__all__ = ["HypothesisFails", "Refuted", "Worksheet", "equal"]


class HypothesisFails(ValueError):
    """A step uses a declaration at values that do not satisfy what it assumes: the exercise left out a case."""


def equal(one: Any, other: Any) -> bool:
    """Whether two numbers or matrices are equal, exactly."""
    left, right = _matrix(one), _matrix(other)
    return bool(left.shape == right.shape and all(is_zero(x - y) for x, y in zip(left, right, strict=True)))


class Worksheet(Decided):
    """What is known, step by step. `sheet["a"]` is a datum; `sheet.values` are the values of the book's symbols."""

    def __init__(self, data: Mapping[str, Any], chapter: str = "") -> None:
        super().__init__(chapter)
        self.data = data
        self.values: dict[Node, Any] = {}
        self.checks: list[SolutionStep] = []
        self.tests: list[tuple[Node, Node, Mapping[Any, Any], str]] = []
        """What is substituted back: two sides, values for these alone, what it says."""
        self.answers: dict[str, Any] = {}
        self.picture: Picture | None = None

    def __getitem__(self, key: str) -> Any:
        return self.data[key]

    def value(self, node: Node, at: Mapping[Any, Any] | None = None) -> Any:
        """The value of an expression: a number for a scalar, else a matrix."""
        return scalar_or_matrix(evaluate(node, {**self.values, **(at or {})}))

    def given(self, values: Mapping[Any, Any], says: str = "What is given.") -> None:
        """Bind symbols to data, to what follows from data at once, or to expressions in the book's words."""
        known = {node: self.value(value) if isinstance(value, Node) else value for node, value in values.items()}
        self.values |= known
        self.steps.append(SolutionStep(says, (), tuple(equation(node, value) for node, value in known.items())))

    def compute(
        self,
        statement: Statement,
        says: str = "",
        *,
        at: Mapping[Any, Any] | None = None,
        moved: Mapping[Any, Node] | None = None,
    ) -> Any:
        """Evaluate the right side of a statement; its left side, if it is a symbol, is known from then on.

        `at` are values for this step alone; `moved` says the statement of other symbols. Raises HypothesisFails.
        """
        left, right = self.sides(statement, moved)
        self._require(statement.assuming, at)
        value = self.value(right, at)
        if not at:
            self.values[bare(left)] = value
        line = chain([plain(left), plain(right)], [latex(left), latex(right)], value)
        self.steps.append(SolutionStep(says or statement.says, (self.cite(statement),), (line,)))
        return value

    def holds(self, statement: Statement, says: str = "", *, at: Mapping[Any, Any] | None = None) -> bool:
        """Whether a statement is true of the values; a step that shows the value of each side."""
        left, right = self.sides(statement, None)
        values = self.value(left, at), self.value(right, at)
        same = equal(*values)
        lines = compared(left, right, values, same)
        self.steps.append(SolutionStep(says or statement.says, (self.cite(statement),), lines))
        return same

    def satisfied(self, hypothesis: Hypothesis) -> bool:
        """Whether the values satisfy a named hypothesis; no step."""
        return self._true((hypothesis,))

    def solve(self, statements: Statement | Sequence[Statement], unknown: Node, says: str = "") -> Solutions:
        """All values of one vector or scalar that satisfy equations linear in it; bound if there is exactly one."""
        rules = (statements,) if isinstance(statements, Statement) else tuple(statements)
        letters = sp.symbols(f"x:{unknown.shape[0]}", real=True)
        at = {unknown: sp.ImmutableMatrix(letters)}
        equations: list[Any] = []
        for left, right in (self.sides(rule, None) for rule in rules):
            equations += list(_matrix(self.value(left, at)) - _matrix(self.value(right, at)))
        matrix, right_side = sp.linear_eq_to_matrix([normal(e) for e in equations], letters)
        found = solve_linear(matrix, right_side)
        if found.unique:
            self.values[unknown] = scalar_or_matrix(found.one)
        lines = [*(stated("", *self.sides(rule, None)) for rule in rules), solved(unknown, found)]
        self.steps.append(SolutionStep(says or rules[0].says, tuple(map(self.cite, rules)), tuple(lines)))
        return found

    def invert(self, inverse: Inverse, says: str = "") -> bool:
        """Bind the arguments of the formula that is inverted, by its first branch that applies.

        An angle becomes known by its cosine and sine, also where those of its half are found. Signs are chosen as the
        inverse says: the first entry of what shares a sign that is not zero is positive. False, with nothing bound,
        where no branch applies.
        """
        for branch in inverse.branches:
            if is_zero(self.value(branch.where)) or not self._true(branch.assuming):
                continue
            found = {node: self.value(value) for node, value in branch.values}
            turn = self._turn(inverse.sign, found)
            found = {node: turn * value if node in inverse.sign else value for node, value in found.items()}
            self.values |= found | _whole_angles(found)
            lines = tuple(chain([plain(node), *([plain(value)] if turn == 1 or node not in inverse.sign else [])],
                                 [latex(node), *([latex(value)] if turn == 1 or node not in inverse.sign else [])],
                                 found[node]) for node, value in branch.values)  # fmt: skip
            self.steps.append(SolutionStep(says or inverse.says, (self.cite(inverse),), lines))
            return True
        return False

    def step(self, says: str, *lines: tuple[Node | str, Any], cites: Iterable[Sentence] = (), **values: Any) -> None:
        """A step of its own: each line an expression of the book, or a name, with its value."""
        written = tuple(equation(node, value) for node, value in (*lines, *values.items()))
        self.steps.append(SolutionStep(says, tuple(map(self.cite, cites)), written))

    def show(self, node: Node, says: str, *, named: str = "", at: Mapping[Any, Any] | None = None,
             cites: Iterable[Sentence] = ()) -> Any:  # fmt: skip
        """Evaluate an expression written in the book's words, as a step; its value."""
        value = self.value(node, at)
        name = [named] if named else []
        in_latex = [words_in_latex(named)] if " " in named else name
        line = chain([*name, plain(node)], [*in_latex, latex(node)], value)
        self.steps.append(SolutionStep(says, tuple(map(self.cite, cites)), (line,)))
        return value

    def check(self, what: Statement | tuple[Any, Any], says: str, *, at: Mapping[Any, Any] | None = None,
              cites: Iterable[Sentence] = ()) -> None:  # fmt: skip
        """Substitute back: the two sides of a statement, two expressions, or two values are equal; raises Refuted."""
        cited = (what, *cites) if isinstance(what, Statement) else tuple(cites)
        sides = self.sides(what, None) if isinstance(what, Statement) else what
        values = tuple(self.value(side, at) if isinstance(side, Node) else scalar_or_matrix(_matrix(side))
                       for side in sides)  # fmt: skip
        if not equal(*values):
            raise Refuted(f"{says}: {text_of(values[0])} is not {text_of(values[1])}")
        left, right = sides
        if isinstance(left, Node) and isinstance(right, Node):
            self.tests.append((left, right, at or {}, says))
        says_more = isinstance(left, Node) and isinstance(right, Node) and plain(left) != plain(right)
        lines = (confirmed(left, right, values[1]),) if says_more else ()
        self.checks.append(SolutionStep(says, tuple(map(self.cite, cited)), lines))

    def answer(self, **answers: Any) -> None:
        """The answers, by the names of the interface."""
        self.answers |= {name: _normal(value) for name, value in answers.items()}

    def _require(self, assuming: Iterable[Hypothesis], at: Mapping[Any, Any] | None = None) -> None:
        for hypothesis in assuming:
            if not self._true((hypothesis,), at):
                raise HypothesisFails(f"{hypothesis.text} does not hold for these data")

    def _true(self, assuming: Iterable[Hypothesis], at: Mapping[Any, Any] | None = None) -> bool:
        """Whether the hypotheses hold of the values; what is not known yet cannot contradict one."""
        for hypothesis in assuming:
            try:
                if not all(equal(self.value(a, at), self.value(b, at)) for a, b in hypothesis.equations):
                    return False
                sizes = [self.value(node, at) for node in hypothesis.nonvanishing]
            except NoValue:
                continue
            if any(map(is_zero, sizes)) or (hypothesis.kind == "positive" and sign(sizes[0]) < 0):
                return False
        return True

    def _turn(self, nodes: Sequence[Node], found: Mapping[Any, Any]) -> int:
        entries = [entry for node in nodes for entry in _matrix(found[node])]
        return next((turn for turn in map(sign, entries) if turn), 1)


def _matrix(value: Any) -> Any:
    return sp.ImmutableMatrix(value) if hasattr(value, "shape") else matrix_of([[value]])


def _normal(value: Any) -> Any:
    """A value with its numbers in normal form."""
    match value:
        case SpelledValue():
            return value
        case list() | tuple():
            return [_normal(part) for part in value]
        case dict():
            return {key: _normal(part) for key, part in value.items()}
        case sp.MatrixBase():
            return matrix_of(value)
        case sp.Expr():
            return normal(value)
        case _:
            return value


def _whole_angles(found: Mapping[Node, Any]) -> dict[Node, Any]:
    """Cosine and sine of the angles of which a fraction is known by its own."""
    whole: dict[Node, Any] = {}
    for node, cosine in found.items():
        if isinstance(node, Call) and node.function == "cos":
            sine = found[Call("sin", node.argument)]
            ((symbol, fraction),) = angle_multiples(node.argument, {}).items()
            turned = cosine, sine
            for _ in range(1, (1 / fraction).numerator):
                turned = turned[0] * cosine - turned[1] * sine, turned[1] * cosine + turned[0] * sine
            whole |= {Call(name, symbol): normal(value) for name, value in zip(("cos", "sin"), turned, strict=True)}
    return whole
