"""What is said of a problem: that it holds, that it fails, or that something satisfies all that it assumes."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby

from chasles.coq.statement import CoqStatement, Premise

NOW = " t now'"
"""An instant, and that it is among those of which something is said."""


def equal_rates(name: str, value: str, sides: str, steps: str, scalar: bool = True) -> str:
    """The step by which rates of what is equal are equal, by further steps for that it is and what the rates are."""
    lemma = "equal_scalar_rates" if scalar else "equal_rates"
    steps = f"eapply ({lemma} T {sides} s'); [exact open'T | exact now's | {steps}]"
    return f"eassert ({name} : forall t, T t -> {value} = _) by (intros s' now's; {steps})."


def holding(name: str, said: CoqStatement) -> str:
    """The definition of the statement, under its name."""
    return f"Definition {name} : Prop :=\n{for_all(said, equations(said))}.\n"


def failing(name: str, said: CoqStatement) -> str:
    """The definition of its negation."""
    return f"Definition {name} : Prop := ~ (\n{for_all(said, equations(said))}).\n"


def satisfiable(name: str, said: CoqStatement) -> str:
    """The definition of the statement that there is what satisfies its premises."""
    bound = f"  exists {_bound(said)},\n" if said.binders else ""
    return f"Definition {name} : Prop :=\n{bound}  " + " /\\\n  ".join(map(assumed, said.premises)) + ".\n"


def equations(said: CoqStatement) -> list[str]:
    """What the goals say."""
    return [said.spelling.equation(goal.left, goal.right) for goal in said.problem.goals]


def for_all(said: CoqStatement, goals: Sequence[str]) -> str:
    """The claim that these follow from the premises."""
    premises = [f"  {assumed(each)} ->" for each in said.premises]
    claim = f" /\\\n{'      ' if said.timed else '  '}".join(goals)
    claim = f"  during T (fun t =>\n      {claim})" if said.timed else f"  {claim}"
    bound = [f"  forall {_bound(said)},"] if said.binders else []
    return "\n".join([*bound, *premises, claim])


def _bound(said: CoqStatement) -> str:
    groups = groupby(said.binders, key=lambda each: each[1])
    return " ".join(f"({' '.join(name for name, _ in each)} : {kind})" for kind, each in groups)


def assumed(premise: Premise) -> str:
    """What is assumed, during the instants if it moves."""
    says = premise.says
    if premise.moves:
        return f"during T (fun t => {says})"
    return f"({says})" if says.startswith("forall") or "/\\" in says else says
