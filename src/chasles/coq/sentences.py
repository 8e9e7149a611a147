"""What is claimed in Coq: statements with proofs.

Of a problem, that it holds, that it fails, or that something satisfies all that it assumes.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby

from chasles.coq.statement import CoqStatement, Premise

NOW = " t now'"
"""An instant, and that it is among those of which something is said."""


@dataclass(frozen=True, slots=True)
class Claimed:
    """One statement in Coq and its proof: `said` is empty where it cannot be said, `proof` where there is none yet.

    `number` and `form` tell what it is of, `kernel` of which kernel, if of one; `whole` says whether the statement is
    all that the verdict claims. Of a misfit the proof is a command that succeeds because Coq refuses the equation; a
    witness says that there is what satisfies the premises of another statement.
    """

    number: str
    form: str
    name: str
    says: str
    said: str = ""
    proof: str = ""
    why_not: str = ""
    whole: bool = True
    is_misfit: bool = False
    is_witness: bool = False
    kernel: str = ""

    @property
    def theorem(self) -> str:
        """The name of the theorem."""
        return f"{self.name}_holds"


def equal_rates(name: str, value: str, sides: str, steps: str, scalar: bool = True) -> str:
    """The step by which rates of what is equal are equal, by further steps for that it is and what the rates are."""
    lemma = "equal_scalar_rates" if scalar else "equal_rates"
    steps = f"eapply ({lemma} T {sides} s'); [exact open'T | exact now's | {steps}]"
    return f"eassert ({name} : forall t, T t -> {value} = _) by (intros s' now's; {steps})."


def holding(name: str, said: CoqStatement) -> str:
    """The definition of the statement, under its name."""
    return f"Definition {name} : Prop :=\n{for_all(said, said.equations)}.\n"


def failing(name: str, said: CoqStatement) -> str:
    """The definition of its negation."""
    return f"Definition {name} : Prop := ~ (\n{for_all(said, said.equations)}).\n"


def satisfiable(name: str, said: CoqStatement) -> str:
    """The definition of the statement that there is what satisfies its premises."""
    bound = f"  exists {_bound(said)},\n" if said.binders else ""
    return f"Definition {name} : Prop :=\n{bound}  " + " /\\\n  ".join(map(assumed, said.premises)) + ".\n"


def asserted(name: str, said: CoqStatement, steps: Iterable[str]) -> Iterator[str]:
    """The steps by which it is known, under a name, what a statement says."""
    yield from (f"assert ({name} :\n{for_all(said, said.equations)}).", "{", *steps, "}")


def claiming(sides: CoqStatement, said: CoqStatement, steps: Iterable[str]) -> Iterator[str]:
    """The steps by which a relation follows from an equation that says the same, and from the same premises."""
    yield from asserted("sides'", sides, steps)
    now = NOW * said.timed
    yield f"intros {introduced(said)}{now}. specialize (sides' {introduced(sides)}{now}). as_claimed sides'."


def introduced(said: CoqStatement) -> str:
    """The names of all that a statement is about and of all that it assumes."""
    return " ".join([*(name for name, _ in said.binders), *(each.name for each in said.premises)])


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
