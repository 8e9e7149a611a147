"""The context in which a problem is decided: its ring, its hypotheses as polynomials, what may be divided by.

Only hypotheses about symbols that occur, and that no rule replaces, become polynomials; those on the others are checked
at the witness and at every counterexample.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any

from chasles.algebra.groebner import Basis, stated
from chasles.algebra.localization import Localization
from chasles.algebra.rings import Polynomial, make_ring
from chasles.evaluation.matrices import Matrix
from chasles.problems.divisors import UndeclaredDivisor
from chasles.problems.generators import Generator, generators_of, generators_of_hypothesis, minus
from chasles.problems.relevance import complete_subjects, free_symbols, relevant_hypotheses
from chasles.problems.scanning import scan
from chasles.problems.unfold import Unfolder
from chasles.problems.variables import Untreatable, Variable, Variables
from chasles.statements import Goal, Hypothesis, Problem
from chasles.statements.conditions import ASSUMED
from chasles.vocabulary import PI, Symbol, plain


class Vanishing(Untreatable):
    """What a hypothesis says not to vanish does everywhere."""

    def __init__(self, hypothesis: Hypothesis) -> None:
        super().__init__(f"{hypothesis.text} cannot be: the left side is zero")
        self.hypothesis = hypothesis


@dataclass(slots=True)
class Context:
    """The ring of a problem and what is known in it."""

    problem: Problem
    variables: tuple[Variable, ...]
    unfold: Unfolder
    generators: tuple[Generator, ...]
    basis: Basis
    nonzero: tuple[tuple[Hypothesis | None, Polynomial], ...]
    active: tuple[Hypothesis, ...]
    transcendental: frozenset[int]
    pi_measures: bool
    densities: frozenset[str] = frozenset()
    conditions: tuple[Generator, ...] = ()
    terms: dict[int, tuple[Polynomial, Any]] = field(default_factory=dict)
    moves: dict[tuple[int, ...], Any] = field(default_factory=dict)

    @property
    def field(self) -> Localization:
        """The fractions of polynomials in which the problem is decided."""
        return self.unfold.field


def build(problem: Problem) -> Context:
    """The context of a problem; raises `Untreatable` for what the procedure does not treat."""
    rules = dict(problem.rules)
    found = Variables()
    for hypothesis in problem.hypotheses:
        for node in hypothesis.subjects if hypothesis.free else ():
            scan(found, node, 0, rules)
    for goal in (*problem.goals, *problem.conditions):
        scan(found, goal.left, 0, rules)
        scan(found, goal.right, 0, rules)
    complete_subjects(problem, found)
    active = relevant_hypotheses(problem, found)
    order = "grevlex" if any(h.kind in ("rotation", "half_turn", "orthonormal") for h in active) else "lex"
    unfold, nonzero = _unfolder(problem, found, active, order)
    variables, ring = unfold.variables, unfold.field.ring
    generators = tuple(generators_of(unfold, variables, active))
    # In a lexicographic order, equations that give a variable are used so by themselves.
    free = order == "grevlex" and all(h.free for h in active)
    # What a rotation satisfies is a Groebner basis as it stands, and is no value of its entries.
    values = [k for k, g in enumerate(generators) if free and g.hypothesis and g.hypothesis.kind == "equation"]
    basis = stated(ring, tuple(g.polynomial for g in generators), complete=order == "grevlex", values=values)
    _refuse_restrictions(problem, active, unfold, basis, found)
    bare = {k for k, v in enumerate(variables) if v.kind == "entry" and v.order == 0 and v.symbol in found.angles}
    circle = {k for k, v in enumerate(variables) if v.symbol == PI}
    pi_measures = bool(circle) or len(bare) > 1
    return Context(
        problem,
        variables,
        unfold,
        generators,
        basis,
        nonzero,
        active,
        frozenset(bare | circle),
        bool(pi_measures and bare),
        found.densities,
    )


def _unfolder(
    problem: Problem, found: Variables, active: tuple[Hypothesis, ...], order: str
) -> tuple[Unfolder, tuple[tuple[Hypothesis | None, Polynomial], ...]]:
    """What turns words into fractions over a ring with a variable for all that occurs, and the nonzero factors."""
    while True:
        variables = tuple(found.listed(problem.unknowns))
        ring = make_ring([variable.name for variable in variables], order)
        if len(set(ring.names)) != len(ring.names):
            twice = next(name for name in ring.names if ring.names.count(name) > 1)
            raise Untreatable(f"two different symbols are both named {twice}: rename one")
        unfold = Unfolder(Localization(ring, []), variables, dict(problem.rules), found.running)
        nonzero = _declare_nonzero(unfold, active)
        if found.running:
            _unfold_all(problem, active, unfold)
        lacks, unfold.moments.lacks = unfold.moments.lacks, None
        if not lacks:
            return unfold, nonzero
        found.moments |= lacks


def _unfold_all(problem: Problem, active: tuple[Hypothesis, ...], unfold: Unfolder) -> None:
    """Unfold everything, to see which moments of the body occur; what cannot be unfolded is reported later."""
    goals = (*problem.goals, *problem.conditions)
    assumed = (pair for h in active if h.kind in ("of all members", *ASSUMED) for pair in h.equations)
    for pair in (*(goal.sides for goal in goals), *assumed):
        for side in pair:
            with suppress(UndeclaredDivisor):
                unfold(side)


def _refuse_restrictions(
    problem: Problem, active: tuple[Hypothesis, ...], unfold: Unfolder, basis: Basis, found: Variables
) -> None:
    """Raise `Untreatable` for a hypothesis that says more of a defined symbol than its definition does."""
    occurring = set(found.orders) | set(found.angles)
    for hypothesis in problem.hypotheses:
        symbols = {s for node in hypothesis.subjects for s in free_symbols(node, dict(problem.rules))}
        if hypothesis in active or not symbols or not symbols <= occurring:
            continue
        for generator in generators_of_hypothesis(unfold, hypothesis, 0):
            if basis.reduce(generator.polynomial)[1] != 0:
                raise Untreatable(
                    f"{hypothesis.text} is assumed of what a given statement defines, and does not follow from it: "
                    "assume it of the symbols in the definition"
                )


def _declare_nonzero(
    unfold: Unfolder, active: tuple[Hypothesis, ...]
) -> tuple[tuple[Hypothesis | None, Polynomial], ...]:
    """What may be divided by, evident things first; what itself divides comes after what it divides by."""
    declared: list[tuple[Hypothesis | None, Polynomial]] = []
    ordered = sorted(active, key=lambda hypothesis: hypothesis.kind != "evident")
    waiting = [(hypothesis, node) for hypothesis in ordered for node in hypothesis.nonvanishing]
    while waiting:
        postponed = []
        for hypothesis, node in waiting:
            try:
                numerator = unfold(node)[0][0].numerator
            except UndeclaredDivisor:
                postponed.append((hypothesis, node))
                continue
            if hypothesis.free and unfold.divisors.admit(node):
                continue
            if numerator == 0:
                raise Vanishing(hypothesis)
            unfold.field.nonzero.append(numerator)
            declared.append((hypothesis, numerator))
        if len(postponed) == len(waiting):
            unfold(postponed[0][1])
        waiting = postponed
    return tuple(declared)


def difference(context: Context, goal: Goal) -> Matrix:
    """What must vanish for the goal to hold: left - right."""
    return minus(context.unfold(goal.left), context.unfold(goal.right))


def describe(symbols: tuple[Symbol, ...]) -> str:
    """The symbols' names, for a message."""
    return ", ".join(plain(symbol) for symbol in symbols)
