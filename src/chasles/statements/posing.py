"""How a statement is posed as a problem, in one of its forms; the prover and the checker both start here."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace as with_fields
from itertools import chain
from weakref import WeakKeyDictionary

from chasles.statements.angles import determined_angle, turning
from chasles.statements.conditions import assumed, solvable
from chasles.statements.directions import with_directions
from chasles.statements.goals import AcceptedSides, cases_of, equations_of, goals_of, goals_of_theorem, presupposed_by
from chasles.statements.hypotheses import Hypothesis, nonzero
from chasles.statements.problem import Goal, Problem
from chasles.statements.rules import behind, fit_together, passed_on, rated, refuse_circles
from chasles.statements.simpler_words import (
    factors_of,
    in_simpler_words,
    with_rates_said,
    with_simple_lengths,
    with_what_is_seen,
)
from chasles.statements.statement import Claim, Condition, Definition, Equation, Statement, Theorem, bare, is_rule
from chasles.statements.varied import opened_parts
from chasles.vocabulary import Determinant, Inverse, Negative, Node, Rate, Sum, Symbol, members_of, plain, undotted
from chasles.vocabulary.families import indices_of
from chasles.vocabulary.fitting import measured
from chasles.vocabulary.measure import added
from chasles.vocabulary.nodes import Scale
from chasles.vocabulary.totals import Total
from chasles.vocabulary.tree import replace

Decidable = Statement | Theorem


def default_form(statement: Statement) -> str:
    """The form in which a statement is used before it is decided: as read where it does not fit as printed."""
    if not statement.fault:
        return "printed"
    for form in ("reading", "corrected"):
        if statement.form_exists(form):
            return form
    raise TypeError(f"({statement.number}) does not fit as printed, and no other form of it is declared")


def default_sides(statement: Statement) -> Equation:
    """The sides with which a statement is used before it is decided; raises TypeError if none fit."""
    return statement.form(default_form(statement))


def problem_of(statement: Decidable, form: str = "printed", standing: AcceptedSides = default_sides) -> Problem:
    """The problem that decides a statement in one of its forms; `standing` gives the sides used of a given one.

    Raises `Misfit` if that form does not fit together, and TypeError if a given statement cannot be used.
    """
    relied_on = statement.relied_on if isinstance(statement, Statement) else ()
    sides = [standing(each) for each in dict.fromkeys((*statement.given, *relied_on))]
    known = _posed.setdefault(statement, {})
    if form not in known or known[form][0] != sides:
        known[form] = sides, _problem_of(statement, form, standing)
    return known[form][1]


_posed: WeakKeyDictionary[Decidable, dict[str, tuple[list[Equation], Problem]]] = WeakKeyDictionary()
"""The problems that were asked for, by statement and form, with the sides of what it relies on."""


def _problem_of(statement: Decidable, form: str, standing: AcceptedSides) -> Problem:
    rules, conditions, unknowns, used = _given(statement, standing)
    claimed = said_by(statement, form)
    rules = passed_on([*rules, *_angle_rules([*claimed, *chain(*rules)], conditions, unknowns)])
    refuse_circles(statement.number, rules, unknowns)
    rules += _counted([*claimed, *chain(*rules)], rules)
    said = [*claimed, *chain(*rules), *(side for goal in conditions for side in goal.sides)]
    if any(part.is_field for side in said for part in opened_parts(side)):
        from chasles.statements.field_equations import moving  # few chapters have fields

        rules += moving(said, rules)
    factors = (part for side in claimed if isinstance(side, Inverse) for part in factors_of(side.of))
    inverted = dict.fromkeys(Determinant(part) for part in factors if isinstance(part, Symbol) and not part.is_scalar)
    stated = tuple(dict.fromkeys((*hypotheses_of(statement), *used, *_agreeing(dict(rules)))))
    hypotheses = *stated, *(nonzero(det) for det in inverted if all(det not in each.nonvanishing for each in stated))
    if conditions and (any(each.is_field for each in unknowns) or not solvable(conditions, unknowns, dict(rules))):
        from chasles.statements.field_equations import freely_assumed  # of no use to most claims

        if told := freely_assumed(conditions, unknowns, [*claimed, *chain(*rules)], dict(rules)):
            hypotheses, conditions, unknowns = (*hypotheses, *told), [], {}
    problem = Problem((), tuple(rules), tuple(conditions), tuple(unknowns), hypotheses)
    if isinstance(statement, Theorem):
        goals = tuple(goals_of_theorem(statement, problem))
        presupposed = tuple(dict.fromkeys(presupposed_by(statement, problem)))
        problem = with_fields(problem, presupposed=presupposed, cases=tuple(cases_of(statement)))
    else:
        goals = tuple(goals_of(statement, form, standing, problem))
    for goal in goals:
        added(measured(goal.left), measured(goal.right), goal.sides, "equate")
    problem = in_simpler_words(with_rates_said(with_fields(problem, goals=goals)))
    return with_directions(with_simple_lengths(with_what_is_seen(problem)))


def _given(
    statement: Decidable, accepted: AcceptedSides
) -> tuple[list[Equation], list[Goal], dict[Symbol, None], tuple[Hypothesis, ...]]:
    """Rules by what is given, conditions, the symbols that these determine, and what is used as it stands."""
    rules: list[Equation] = []
    conditions, told = list[Goal](), list[Goal]()
    unknowns: dict[Symbol, None] = {}
    posed = [each.on for each in statement.given if isinstance(each, Condition)]
    defined = [(bare(each.left), accepted(each)[1]) for each in statement.given if isinstance(each, Definition)]
    apart = {each for hypothesis in hypotheses_of(statement) for each in hypothesis.nonvanishing}
    rates: dict[Node, Node] = {left: right for left, right in defined if isinstance(right, Rate)}
    for given in statement.given:
        left, right = accepted(given)
        on = given.on if isinstance(given, Condition) else ()
        if not rates.keys().isdisjoint(on):  # on a velocity, say: it is one on what the velocity is the rate of
            left, right = replace(left, rates), replace(right, rates)
            on = tuple(base for each in on if isinstance(base := undotted(rates.get(each, each))[0], Symbol))
        rule = bare(left), right
        match rule[0]:
            case Scale(factor, Rate() as term) if apart.issuperset(factors_of(factor)):
                rule = term, right / factor
        if isinstance(given, Condition) and given.solution is not None:
            raise TypeError(
                f"({statement.number}) is given ({given.number}), which leaves {given.on[0]} free: let it restate that"
            )
        moves = isinstance(rule[0], Rate) and (undotted(rule[0])[0],) == on and posed.count(on) < 2
        if moves and not {rule[0], Rate(rule[0])} & {*opened_parts(rule[1])}:
            rules.append(rule)
        elif isinstance(given, Condition):
            conditions += equations_of(f"({given.number})", left, right) if on else ()
            unknowns |= dict.fromkeys(on)
        elif is_rule(given) and (isinstance(given, Definition) or fit_together([*rules, *defined, rule])):
            rules.append(rule)
        elif indices_of(left):
            rules += [(one, other) for one, other in members_of(left, right)]
        else:
            told += equations_of(f"({given.number})", left, right)
    return rules, conditions, unknowns, tuple(assumed(told))


def _angle_rules(sides: list[Node], conditions: list[Goal], unknowns: dict[Symbol, None]) -> Iterator[Equation]:
    """What conditions say that angles are, whose cosines and sines are taken; these conditions are left out."""
    angles = turning(sides) if conditions else set[Symbol]()
    for goal in tuple(conditions):
        found = determined_angle(goal.left, goal.right, unknowns)
        if found is not None and found[0] in angles:
            conditions.remove(goal)
            del unknowns[found[0]]
            yield found


def said_by(statement: Decidable, form: str) -> list[Node]:
    """The sides of what is claimed in one of its forms."""
    if isinstance(statement, Theorem):
        return [side for part in statement.forms for each in part.equations() for side in each[1:]]
    return list(statement.form(form))


def _counted(sides: list[Node], rules: list[Equation]) -> Iterator[Equation]:
    """That the number of members over which sums are taken is the sum of ones, where nothing else is given of it."""
    found = dict.fromkeys(part.index for side in sides for part in opened_parts(side) if isinstance(part, Total))
    known = {left for left, _ in rules}
    yield from ((index.number, index.counted) for index in found if index.number not in known)


def _agreeing(rules: Mapping[Node, Node]) -> Iterator[Hypothesis]:
    """Where both a quantity and its rate are given, the rate of what is given for the other."""
    for left, right in rules.items():
        base, dots = behind(left, rules)
        if dots and base in rules:
            rate = rated(rules[base], dots)
            text = f"{plain(left)} is the rate of {plain(base)}"
            yield Hypothesis("given", (Sum((rate, Negative(right))),), ((rate, right),), (), "", text)


def hypotheses_of(statement: Decidable) -> Iterator[Hypothesis]:
    """What the statement and all that it rests on assume, its own first."""
    yield from statement.assuming
    if isinstance(statement, Condition) and not statement.on:
        yield from assumed((*equations_of(f"({statement.number}.{statement.part})", *default_sides(statement)),))
    if isinstance(statement, Claim) and (statement.left.expands or statement.right.expands):
        from chasles.statements.expanding import presupposed  # of no use to most claims

        yield from presupposed(statement.left, statement.right, statement.assuming)
    for given in statement.given:
        yield from hypotheses_of(given)
