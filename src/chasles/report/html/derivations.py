"""Derivations as the page shows them, each step with its result; carried out by several processes where that helps."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import fields
from itertools import chain
from typing import Any

from markupsafe import Markup

from chasles.decisions.processes import spread
from chasles.decisions.session import Session
from chasles.deriving import CheckedDerivation, CheckedStep, walk
from chasles.report.derivation_page import equations_of, objections_of, outcome_of
from chasles.report.html.formulas import with_formulas
from chasles.report.html.shown import DerivationView, StepShown, badge_of
from chasles.report.html.statements import equation, expression
from chasles.statements.derivation import Consider, Derivation, DerivationStep
from chasles.vocabulary import Node

A_DERIVATION = 0.3
"""About how many seconds one takes."""


def walked(roads: Mapping[str, Derivation], session: Session) -> tuple[DerivationView, ...]:
    """All derivations, checked; what the session has decided already is not decided again."""
    return tuple(spread(lambda name: derivation_view(name, walk(roads[name], session)), tuple(roads), A_DERIVATION))


def derivation_view(name: str, road: CheckedDerivation) -> DerivationView:
    """A derivation as the page shows it; it belongs to the number at its end."""
    derivation = road.derivation
    made = zip(derivation.steps, road.steps, strict=False)
    return DerivationView(
        number=derivation.number if derivation.to is None else derivation.to.number,
        name=name,
        says=derivation.says,
        outcome="".join(words for words, _ in outcome_of(road)),
        arrives=road.arrives,
        assuming=tuple(hypothesis.text for hypothesis in derivation.assuming),
        steps=tuple(_step(checked, step) for step, checked in made),
    )


def _step(step: CheckedStep, declared: DerivationStep) -> StepShown:
    """A step; of an expression that is only considered, nothing is said twice."""
    considers = isinstance(declared, Consider)
    shown = tuple(equation(left, right, label=label) for label, left, right in equations_of(step))
    if considers:
        shown = tuple(expression(right) for _, right in step.equations)
    return StepShown(
        kind=step.kind,
        reason=Markup() if considers else with_formulas(step.reason, _spoken_of(step, declared)),
        badges=() if step.comparison is not None else (badge_of(step.verdict.name),),
        equations=shown,
        objections=tuple(objections_of(step)),
    )


def _spoken_of(step: CheckedStep, declared: Any) -> Iterator[Node]:
    """The expressions that a step is declared with, and those that it comes to."""
    held = (getattr(declared, each.name) for each in fields(declared))
    parts = (part for value in held for part in (value if isinstance(value, tuple) else (value,)))
    yield from (part for part in chain(parts, *step.equations) if isinstance(part, Node))
