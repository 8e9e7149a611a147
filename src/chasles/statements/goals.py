"""What does a statement claim? Its sides, or those of a theorem's forms, as goals: two sides each, to prove equal."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction

from chasles import vocabulary as w
from chasles.statements.forms import Definite, Iff, OnlyWhere
from chasles.statements.hypotheses import Hypothesis
from chasles.statements.lengths import relied_on
from chasles.statements.problem import Goal, Problem
from chasles.statements.statement import Claim, Condition, Definition, Equation, Statement, Theorem
from chasles.statements.varied import demands, visible
from chasles.vocabulary import Node
from chasles.vocabulary.nodes import lifted

AcceptedSides = Callable[[Statement], Equation]
"""Gives the sides with which a given statement is used; raises TypeError for one that cannot be."""


def goals_of_theorem(statement: Theorem, problem: Problem) -> Iterator[Goal]:
    """What proves a theorem, by the rules of the problem; raises TypeError for one that varies what they fix."""
    restricted = tuple(side for goal in problem.conditions for side in goal.sides) + problem.unknowns
    for part in statement.forms:
        try:
            shown = visible(part, dict(problem.rules), restricted)
            equations = (*shown.equations(), *demands(shown, problem.hypotheses))
        except TypeError as error:
            raise TypeError(f"({statement.number}): {error}") from None
        for label, left, right in equations:
            yield Goal(label, left, right)


def cases_of(statement: Theorem) -> Iterator[Goal]:
    """Where either side of "if and only if" vanishes: of elsewhere it says nothing."""
    for part in statement.forms:
        for side in (part.one, part.other) if isinstance(part, Iff) else ():
            yield Goal(f"{w.plain(side)} = 0", side, w.Number(Fraction(0)) if side.is_scalar else w.Zero(*side.shape))


def presupposed_by(statement: Theorem, problem: Problem) -> Iterator[Hypothesis]:
    """The hypotheses by which the squares of a theorem's forms are squares; raises `Misfit` if one of them is not."""
    ruled = {left for left, _ in problem.rules}
    for part in statement.forms:
        for square in part.squares if isinstance(part, Definite | OnlyWhere) else ():
            for hypothesis in relied_on(square, problem.hypotheses):
                if hypothesis.equations and ruled.intersection(hypothesis.subjects):
                    raise TypeError(
                        f"({statement.number}): {hypothesis.text} is assumed of what a given statement defines: "
                        "leave that statement out"
                    )
                yield hypothesis


def goals_of(statement: Statement, form: str, accepted: AcceptedSides, problem: Problem) -> Iterator[Goal]:
    """What proves a statement in one of its forms; raises `Misfit` where the form does not fit together."""
    left, right = statement.form(form)
    if fault := (statement.fault if form == "printed" else left.fault or right.fault):
        raise w.Misfit(fault)
    match statement:
        case Definition():
            return
        case Condition(on=(symbol, *_), solution=Node() as solution):
            yield Goal("its solution satisfies it", *(w.replace(side, {symbol: solution}) for side in (left, right)))
        case Condition(on=(_, *_)):
            yield from equations_of("", left, right)
        case Claim(restates=Statement() as other):
            yield _multiple(statement, (other,), accepted, left, right)
        case Claim(restates=tuple() as others):
            yield _multiple(statement, others, accepted, left, right)
        case Claim(solves=Statement() as other):
            if not isinstance(left, w.Symbol):
                raise TypeError(f"({statement.number}) solves ({other.number}) for {left}, which is no symbol")
            yield Goal("it solves the equation", *(w.replace(side, {left: right}) for side in accepted(other)))
        case _ if left.expands or right.expands:
            from chasles.statements.expanding import coefficients_of  # of no use to most claims

            if problem.conditions:
                raise TypeError(f"({statement.number}) is expanded: what it is given has to be definitions")
            rules = dict(problem.rules)
            yield from (Goal(label, one, other) for label, one, other in coefficients_of(left, right, rules))
        case _:
            yield from equations_of("", left, right)


def equations_of(label: str, left: Node, right: Node) -> Iterator[Goal]:
    """An equation as what it says of an inverse, and without indices."""
    if isinstance(right, w.Inverse) and not isinstance(left, w.Inverse):
        left, right = right, left
    if isinstance(left, w.Inverse):
        identity = w.Identity(left.shape[0])
        yield Goal(label or "the matrix times its inverse", w.Contract((left.of, right)), identity)
        yield Goal(label or "the inverse times its matrix", w.Contract((right, left.of)), identity)
        return
    for one, another in w.members_of(left, right):
        yield Goal(label, one, another)


def _multiple(
    statement: Claim, others: tuple[Statement, ...], accepted: AcceptedSides, left: Node, right: Node
) -> Goal:
    sides = [accepted(other) for other in others]
    differences: list[Node] = [w.Sum((one, w.Negative(another))) for one, another in sides]
    difference = differences[0] if len(differences) == 1 else w.column(*differences)
    if statement.by is not None:
        by = lifted(statement.by)
        difference = by * difference if by.is_scalar else w.Contract((by, difference))
    numbers = ", ".join(f"({other.number})" for other in others)
    return Goal(f"it is a multiple of {numbers}", w.Sum((left, w.Negative(right))), difference)
