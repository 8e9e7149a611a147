"""Is an offered form what the statement says? Where it is not, an exact point shows it."""

from __future__ import annotations

from itertools import product

from chasles.lowering.divisors import divisors_of
from chasles.lowering.request import Request
from chasles.prover.decide import decide_problem
from chasles.statements import Goal, Problem, nonzero
from chasles.verdict import Counterexample, Fails
from chasles.vocabulary import Node

BUDGET = 1e7
"""The work that the search for a counterexample may take in each case, in products of terms."""


def counterexample(request: Request) -> tuple[str, Counterexample] | None:
    """A result and a point at which the offered form of it is not what the request's output is; None if none is found.

    The point satisfies the hypotheses, and nothing that either of the two divides by is zero there.
    """
    for way in product(*(choice.cases for choice in request.choices)):
        rules = dict(request.rules)
        for choice, case in zip(request.choices, way, strict=True):
            rules |= dict(zip(choice.symbols, case.values, strict=True))
        for output, form in zip(request.outputs, request.form, strict=True):
            verdict = decide_problem(_problem(request, rules, output.value, form), (), BUDGET)
            if isinstance(verdict, Fails):
                return output.name, verdict.counterexample
    return None


def in_words(found: tuple[str, Counterexample]) -> str:
    """The point, and what the two sides are there."""
    name, point = found
    at = ", ".join(f"{variable} = {value}" for variable, value in point.at.items())
    row, column = point.entry
    return f"at {at}, entry {row}, {column} of {name} is {point.left} by the statement and {point.right} by the form"


def _problem(request: Request, rules: dict[Node, Node], stated: Node, form: Node) -> Problem:
    seen: dict[Node, None] = {}
    divisors = dict.fromkeys(divisor for side in (stated, form) for divisor in divisors_of(side, rules, seen))
    hypotheses = tuple(dict.fromkeys((*request.hypotheses, *map(nonzero, divisors))))
    return Problem((Goal("the form is what is stated", stated, form),), tuple(rules.items()), hypotheses=hypotheses)
