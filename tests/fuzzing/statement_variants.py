"""Declared statements asked otherwise, made smaller, and verdicts on them forged."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from random import Random
from typing import Any

from chasles import vocabulary as w
from chasles.statements import Claim, Definition, Hypothesis, Statement, Theorem
from chasles.vocabulary.tree import children, rebuilt

from .asking import statement_rejection
from .forging import ANYTHING, altered_certificates
from .statements import Asked

__all__ = ["accepted_forgery_of", "smaller_statements", "twisted_statements"]


def twisted_statements(asked: Asked, draw: Random) -> Iterator[tuple[str, Asked]]:
    """Claims with the same answer, each with what was done to it; theorems are left alone."""
    claim = asked.statement
    if not isinstance(claim, Claim):
        return
    yield "swapped", replace(asked, statement=replace(claim, left=claim.right, right=claim.left))
    factor = draw.choice((2, -1, Fraction(1, 3)))
    scaled = [w.number(factor) * side for side in (claim.left, claim.right)]
    yield f"scaled by {factor}", replace(asked, statement=replace(claim, left=scaled[0], right=scaled[1]))
    nothing = w.Zero(*claim.left.shape) if not claim.left.is_scalar else w.number(0)
    yield "difference", replace(asked, statement=replace(claim, left=claim.left - claim.right, right=nothing))
    given, assuming = (tuple(draw.sample(x, len(x))) for x in (claim.given, claim.assuming))
    yield "permuted", replace(asked, statement=replace(claim, given=given, assuming=assuming))
    yield "twice", replace(asked, statement=replace(claim, assuming=(*claim.assuming, *claim.assuming)))
    for k, item in enumerate(claim.given):
        if isinstance(item, Definition) and isinstance(item.left, w.Symbol) and not _spoken_of(item.left, claim):
            values: dict[w.Node, w.Node] = {item.left: item.right}
            sides = [w.replace(side, values) for side in (claim.left, claim.right)]
            rest = (*claim.given[:k], *claim.given[k + 1 :])
            yield "unfolded", replace(asked, statement=replace(claim, left=sides[0], right=sides[1], given=rest))
        if isinstance(item, Definition):
            nothing = w.number(0) if item.right.is_scalar else w.Zero(*item.right.shape)
            behind = Claim("behind", item.left, nothing + item.right, given=claim.given)
            yield f"behind a claim on {item.left}", replace(asked, statement=replace(claim, given=(behind,)))


def _spoken_of(symbol: w.Symbol, claim: Claim) -> bool:
    others = [side for g in claim.given if g.left != symbol for side in (g.left, g.right)]
    subjects = [node for h in claim.assuming for node in h.subjects]
    return any(symbol in w.walk(node) for node in (*others, *subjects))


def smaller_statements(asked: Asked) -> Iterator[Asked]:
    """Statements that are smaller by one thing."""
    asked = asked.unlabelled()
    statement = asked.statement
    for name in ("given", "assuming", *(("forms",) if isinstance(statement, Theorem) else ())):
        items = getattr(statement, name)
        for k in range(len(items)):
            if name != "forms" or len(items) > 1:
                yield replace(asked, statement=replace(statement, **{name: (*items[:k], *items[k + 1 :])}))
    if not isinstance(statement, Claim):
        return
    for name in ("left", "right"):
        for other in _smaller(getattr(statement, name)):
            try:
                yield replace(asked, statement=replace(statement, **{name: other}))
            except w.Misfit:
                continue


def _smaller(node: w.Node) -> Iterator[w.Node]:
    """Words with one part replaced by something below it, of the same shape."""
    nothing = w.number(0) if node.is_scalar else w.Zero(*node.shape)
    if children(node):
        yield nothing
    if isinstance(node, w.Sum):
        for k in range(len(node.terms)):
            rest = (*node.terms[:k], *node.terms[k + 1 :])
            yield rest[0] if len(rest) == 1 else w.Sum(rest)
    for part in children(node):
        if part.shape == node.shape:
            yield part
    for k, part in enumerate(children(node)):
        for other in _smaller(part):
            try:
                found = rebuilt(node, (*children(node)[:k], other, *children(node)[k + 1 :]))
                if not found.fault:
                    yield found
            except (w.Misfit, TypeError, ValueError):
                continue


def accepted_forgery_of(asked: Asked, verdict: Any, draw: Random) -> str | None:
    """What was forged, if a forged verdict on a claim was accepted or crashed the checker; None if all is well."""
    for what, statement, forged in _forgeries(asked, verdict, draw):
        reason = statement_rejection(statement, forged)
        if reason is None and not what.startswith(ANYTHING):
            return f"accepted: {what}"
        if reason is not None and not reason.startswith("Rejected"):
            return f"{what}: {reason}"
    return None


def _forgeries(asked: Asked, verdict: Any, draw: Random) -> Iterator[tuple[str, Statement | Theorem, Any]]:
    claim = asked.statement
    if not isinstance(claim, Claim):
        return
    if hasattr(verdict, "certificate"):
        different = replace(claim, right=claim.right + _unit_like(claim.right))
        yield "the claim with one added to the right side", different, verdict
        for what, certificate in altered_certificates(verdict.certificate, draw):
            yield what, claim, replace(verdict, certificate=certificate)
        return
    shown = verdict.counterexample
    yield "a refutation of an identity", replace(claim, right=claim.left), verdict
    for what, changes in (
        ("an entry that is none", {"entry": (7, 7)}),
        ("an entry counted from zero", {"entry": (0, 0)}),
        ("another value", {"left": f"{shown.left} + 1"}),
        ("a label that is none", {"goal": "no such equation"}),
        ("a point of nonsense", {"at": dict.fromkeys(shown.at, "nonsense")} if shown.at else {"entry": (9, 1)}),
    ):
        yield what, claim, replace(verdict, counterexample=replace(shown, **changes))
    for subject in _bound(claim.assuming):
        names = [name for name in shown.at if name.startswith(f"{subject.name}_") and "dot" not in name]
        if names:
            at = {**shown.at, draw.choice(names): Fraction(17)}
            yield f"a point off {subject}", claim, replace(verdict, counterexample=replace(shown, at=at))


def _bound(assuming: tuple[Hypothesis, ...]) -> list[w.Symbol]:
    """Vectors and matrices no entry of which can be 17."""
    kinds = ("unit", "rotation", "orthonormal", "half_turn")
    return [s for h in assuming if h.kind in kinds for s in h.subjects if isinstance(s, w.Symbol)]


def _unit_like(node: w.Node) -> w.Node:
    """Something of the same shape and dimension that nowhere vanishes: none if the dimension is none of a number."""
    if node.is_scalar:
        return w.number(1)
    rows, columns = node.shape
    return w.Identity(rows) if rows == columns else w.Block(tuple((w.number(1),) for _ in range(rows)))
