"""Equations solved for unknowns: the linear system decides, and the values are written with given terms."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace as with_fields

from chasles.deriving.state import Equation, State
from chasles.rewriting.coefficients import ONE
from chasles.rewriting.isolate import alone
from chasles.statements import Goal, Problem, Statement
from chasles.verdict import Verdict
from chasles.vocabulary import Node, Rate, Scale, Symbol, replace, symbols_of


def solve_by_moving(state: State, unknown: Node, using: Sequence[Statement]) -> tuple[Equation, Verdict]:
    """The unknown is brought to stand alone; decided: the equation is a multiple of the one found."""
    left, right = state.equations[0]
    value, coefficient = alone(unknown, left, right)
    multiple = Scale(coefficient, unknown - value)
    return (unknown, value), state.decide(
        [("a multiple of what was found", left - right, multiple)], state.environment(using)
    )


def solve_by_multiplying(
    state: State, unknown: Node, by: Statement, using: Sequence[Statement]
) -> tuple[Equation, Verdict]:
    """The equation is multiplied from the left by what `by` says an inverse is."""
    left, right = state.equations[0]
    factor = state.sides(by)[1]
    value = factor * right if factor.is_scalar else factor @ right
    product = factor * left if factor.is_scalar else factor @ left
    verdict = state.decide([("the unknown stands alone", product, unknown)], state.environment(using))
    return (unknown, value), verdict


def solve_linear_system(
    state: State, unknowns: Sequence[Node], terms: Sequence[Node], using: Sequence[Statement]
) -> tuple[tuple[Equation, ...], Verdict]:
    """The equations reached are the conditions; for a rate, so are the rates of what is assumed of its symbol.

    Decided: the conditions have this solution and no other, and it satisfies them.
    """
    names = {unknown: _named(unknown) for unknown in unknowns}
    rates = tuple((unknown, name) for unknown, name in names.items() if isinstance(unknown, Rate))
    environment = state.environment(using, rates)
    conditions = tuple(
        Goal("equation", left, right) for left, right in (*state.equations, *_rates(environment, unknowns))
    )
    problem = with_fields(environment, conditions=conditions, unknowns=tuple(names.values()))
    values = {u: state.combination(name, terms or (ONE,), problem) for u, name in names.items()}
    only = [(f"{unknown} can be nothing else", names[unknown], value) for unknown, value in values.items()]
    verdict = state.decide(only, problem)
    if verdict.true:
        there: dict[Node, Node] = {name: values[unknown] for unknown, name in names.items()}
        rules = tuple((unknown, values[unknown]) for unknown, _ in rates)
        sides = [("it satisfies the equation", replace(c.left, there), replace(c.right, there)) for c in conditions]
        verdict = state.decide(sides, state.environment(using, rules))
    return tuple(values.items()), verdict


def _named(unknown: Node) -> Symbol:
    """The unknown itself, or a symbol that stands for a rate while it is sought."""
    if isinstance(unknown, Symbol):
        return unknown
    assert unknown.measure is not None
    return Symbol(f"[{unknown}]", str(unknown), unknown.measure)


def _rates(environment: Problem, unknowns: Sequence[Node]) -> Iterator[Equation]:
    """What is assumed of a symbol whose rate is sought, differentiated."""
    sought = {unknown.of for unknown in unknowns if isinstance(unknown, Rate)}
    for hypothesis in environment.hypotheses:
        if any(symbol in sought for subject in hypothesis.subjects for symbol in symbols_of(subject)):
            yield from ((Rate(left), Rate(right)) for left, right in hypothesis.equations)
