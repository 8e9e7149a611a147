"""What must hold of a kernel's arguments? What its proof assumes of them, and what is expected of them besides.

What is assumed of other symbols cannot be seen in the arguments: a declaration says in `expected` what amounts to it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from chasles.lowering.lower import program_of
from chasles.lowering.program import Program
from chasles.lowering.reach import Reach
from chasles.lowering.refusal import LoweringError
from chasles.lowering.request import Output, Request, composed
from chasles.statements import Hypothesis, Packed
from chasles.statements.arrays import argument_name
from chasles.statements.kernel import nodes_of
from chasles.targets.kernel import Demand
from chasles.vocabulary import Node


def demands_of(request: Request, hypotheses: Iterable[Hypothesis]) -> tuple[Demand, ...]:
    """Those of the hypotheses that are about the arguments, each once; what another one implies is left out.

    Of those that say the same in words, as those of a statement and of what is given to it may, the first is taken.
    """
    chosen = [h for h in dict.fromkeys(hypotheses) if not _is_built_in(h, request)]
    implied = {node for h in chosen if h.kind != "nonzero" for node in h.nonvanishing}
    found = (_demand(h, request) for h in chosen if h.kind != "nonzero" or not implied.issuperset(h.nonvanishing))
    said: dict[str, Demand] = {}
    for demand in found:
        if demand is not None:
            said.setdefault(demand.text, demand)
    return tuple(said.values())


def _is_built_in(hypothesis: Hypothesis, request: Request) -> bool:
    """Whether it says that a matrix is symmetric of which only six numbers are given."""
    packed = {argument.matrix for argument in request.arguments if isinstance(argument, Packed)}
    return hypothesis.kind == "symmetric" and packed.issuperset(hypothesis.subjects)


def _demand(hypothesis: Hypothesis, request: Request) -> Demand | None:
    """What the hypothesis demands; None if it is not about the arguments alone."""
    if hypothesis.kind == "nonzero":
        divisor = _divisor(hypothesis.nonvanishing[0], request)
        names = tuple(argument.name for argument in divisor.arguments) if divisor else ()
        return Demand(hypothesis.kind, hypothesis.text, names, divisor) if divisor else None
    if not set(request.of).issuperset(hypothesis.subjects):
        return None
    return Demand(hypothesis.kind, hypothesis.text, tuple(_holders(hypothesis.subjects, request)))


def _holders(subjects: Iterable[Node], request: Request) -> Iterator[str]:
    for subject in subjects:
        for argument in request.arguments:
            if subject in nodes_of(argument):
                yield argument_name(argument)


def _divisor(node: Node, request: Request) -> Program | None:
    """The program of what must not vanish, as a function of the arguments on which it depends; None if of others."""
    rules, angles = dict(request.rules), dict(request.angles)
    reach = Reach(request.name, request.of, rules, request.choices, angles)
    try:
        reach.follow(node)
    except LoweringError:
        return None
    arguments = [argument for argument in request.arguments if any(map(reach.is_used, nodes_of(argument)))]
    if not arguments:
        return None
    value = Output("divisor", "what must not vanish", node)
    return program_of(composed(request.name, arguments, [value], rules=rules, choices=request.choices, angles=angles))
