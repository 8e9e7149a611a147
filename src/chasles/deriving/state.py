"""The state of a derivation: the equations reached, the statements found so far, and what may be used to decide."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from dataclasses import replace as with_fields
from functools import partial

from chasles.decisions.kept_answers import combination_fits
from chasles.decisions.session import Session
from chasles.deriving.combine import combined
from chasles.problems.divisors import UndeclaredDivisor
from chasles.problems.variables import Untreatable
from chasles.rewriting.products import without_brackets
from chasles.statements import Claim, Condition, Goal, Hypothesis, Problem, Statement, problem_of
from chasles.statements.derivation import Ansatz, Derivation
from chasles.statements.elsewhere import cited
from chasles.statements.statement import is_rule
from chasles.verdict import Holds, IllFormed, Undecided, Verdict
from chasles.vocabulary import Misfit, Node, number
from chasles.vocabulary.families import indices_of

Equation = tuple[Node, Node]
Rules = tuple[tuple[Node, Node], ...]


@dataclass
class State:
    """The equations reached, those solved for last, the ansatz made, and each statement as it was found."""

    derivation: Derivation
    session: Session
    equations: tuple[Equation, ...] = ()
    solved: tuple[Equation, ...] = ()
    ansatz: Ansatz | None = None
    found: dict[int, Statement] = field(default_factory=dict)

    def sides(self, statement: Statement) -> Equation:
        """The sides of a statement: as found in this derivation, or in the form that is accepted."""
        found = self.found.get(id(statement))
        left, right = self._relied_on(statement) if found is None else found.printed
        return without_brackets(left), without_brackets(right)

    def _relied_on(self, statement: Statement) -> Equation:
        """The sides with which a statement may be used; raises ValueError for a claim of which no form holds."""
        if isinstance(statement, Claim):
            decision = self.session.decide(statement)
            if not decision.stands:
                raise ValueError(f"{self.cited(statement)} is used, and it {decision.verdict.name}")
        return self.session.accepted(statement)

    def cited(self, statement: Statement) -> str:
        """The statement's number as a reader looks for it."""
        return cited(statement, self.session.package)

    def environment(self, using: Iterable[Statement] = (), rules: Rules = ()) -> Problem:
        """What may be used: rules of the statements that are given, and all that is assumed."""
        named = dict.fromkeys((*self.derivation.given, *using))
        given = tuple(self.found.get(id(s), s) for s in named if usable(s))
        claim = Claim("road", number(0), number(0), given=given, assuming=self._assumed)
        problem = problem_of(claim, "printed", self._standing)
        kept = tuple(rule for rule in problem.rules if rule[0] not in dict(rules))
        return with_fields(problem, goals=(), rules=(*kept, *rules))

    @property
    def _assumed(self) -> tuple[Hypothesis, ...]:
        """What the derivation assumes, and what is assumed of each statement that it cites."""
        cited = (*self.derivation.given, *(each for step in self.derivation.steps for each in step.cited))
        return tuple(dict.fromkeys((*self.derivation.assuming, *(h for each in cited for h in each.assuming))))

    def _standing(self, statement: Statement) -> Equation:
        if any(statement is found for found in self.found.values()):
            return statement.printed
        return self._relied_on(statement)

    def decide(self, goals: Sequence[tuple[str, Node, Node]], problem: Problem) -> Verdict:
        """The verdict on equations that must all hold; without any, there was nothing to prove."""
        made = tuple(Goal(label, left, right) for label, left, right in goals if left != right)
        if not made:
            return Holds({"entries": {}}, {})
        try:
            return self.session.verdict_on(with_fields(problem, goals=made))
        except Misfit as error:
            return IllFormed(str(error))
        except (UndeclaredDivisor, Untreatable) as error:
            return Undecided(str(error))

    def combination(self, node: Node, terms: Sequence[Node], problem: Problem) -> Node:
        """The expression written with the terms: a conjecture. Raises `NoCombination`."""
        memory = self.session.memory
        fits = partial(combination_fits, node)
        key = memory.key_of_combination(node, terms, problem)
        found: Node = memory.answer(key, fits, lambda: combined(node, terms, problem))
        return found


def usable(statement: Statement) -> bool:
    """Whether a statement can stand as a rule."""
    if isinstance(statement, Condition):
        return False
    return is_rule(statement) or bool(indices_of(statement.left))


def rules_behind(statement: Statement) -> Iterator[Statement]:
    """The statement, or what it rests on if it is no rule."""
    if usable(statement):
        yield statement
    else:
        yield from (given for given in statement.given if usable(given))
