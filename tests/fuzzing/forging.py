"""Certificates that prove nothing, made from those that do: each must be rejected, and with `Rejected`."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from copy import deepcopy
from dataclasses import replace
from functools import reduce
from random import Random
from typing import Any

import sympy as sp

from chasles.verdict import Holds

from .asking import rejection
from .equations import Equation

__all__ = ["ANYTHING", "accepted_forgery", "altered_certificates", "needs_forged"]

ODD_VARIANTS = (99, -1, "0", None, 1.5)
ODD = ("factorial(10**9)", "integrate(x, x)", "gamma(999999999)", "x**10000000", "1/0", "(", "", None, -1, 1.5, [], {})
ANYTHING = "anything"
"""So begins what is said of changes of which the checker may take no notice: it only has to end, and not to fail."""


def accepted_forgery(
    question: Equation, verdict: Any, draw: Random, false_without: Callable[[Equation], bool]
) -> str | None:
    """What was forged, if a forged certificate of a proof was accepted or crashed the checker; None if all is well."""
    for what, asked, forged in _forgeries(question, verdict, draw, false_without):
        reason = rejection(asked, forged)
        if reason is None and not what.startswith(ANYTHING):
            return f"accepted: {what}"
        if reason is not None and not reason.startswith("Rejected"):
            return f"{what}: {reason}"
    return None


def _forgeries(
    question: Equation, verdict: Any, draw: Random, false_without: Callable[[Equation], bool]
) -> Iterator[tuple[str, Equation, Any]]:
    one = sp.ones(*question.lhs.shape) if isinstance(question.lhs, sp.MatrixBase) else sp.Integer(1)
    yield "the claim with one added to the right side", replace(question, rhs=question.rhs + one), verdict
    for k, item in enumerate(question.given):
        less = replace(question, given=(*question.given[:k], *question.given[k + 1 :]))
        if false_without(less):
            yield f"the question without {item}", less, verdict
    for what, certificate in altered_certificates(verdict.certificate, draw):
        yield what, question, replace(verdict, certificate=certificate)


def needs_forged(question: Equation, verdict: Any) -> str | None:
    """Which needs were left out of a proof that was accepted all the same; None if none can be."""
    needs = tuple(getattr(verdict, "needs", ()))
    if not needs:
        return None
    forged = [(f"{need} left out", replace(verdict, needs=tuple(n for n in needs if n != need))) for need in needs]
    forged.append(("all needs left out", Holds(verdict.certificate, verdict.witness, verdict.unused)))
    forged.append(("a need that is none", replace(verdict, needs=(*needs[:-1], "nonsense"))))
    for what, other in forged:
        reason = rejection(question, other)
        if reason is None:
            return f"accepted: {what}"
        if not reason.startswith("Rejected"):
            return f"{what}: {reason}"
    return None


def altered_certificates(certificate: Any, draw: Random) -> Iterator[tuple[str, Any]]:
    """Certificates with one thing that is wrong."""
    whole = deepcopy(dict(certificate))
    for variant in ODD_VARIANTS if "variant" in whole else ():
        yield f"the variant {variant!r}", {**whole, "variant": variant}
    if whole.get("witness"):
        yield "a witness of nonsense", {**whole, "witness": dict.fromkeys(whole["witness"], "nonsense")}
    for label, said in whole.get("entries", {}).items():
        for name, cofactor in said.get("cofactors", {}).items():
            changed = deepcopy(whole)
            changed["entries"][label]["cofactors"][name] = f"{cofactor} + 1"
            yield f"the cofactor of {name} with one added", changed
            changed = deepcopy(whole)
            changed["entries"][label]["cofactors"]["no such equation"] = "1"
            yield "a cofactor of what is not given", changed
    for path in draw.sample(places := [*_places(whole)], min(3, len(places))):
        changed = deepcopy(whole)
        reduce(lambda part, key: part[key], path[:-1], changed)[path[-1]] = odd = draw.choice(ODD)
        yield f"{ANYTHING}: {odd!r} at {path}", changed
    for k, (label, term) in enumerate(whole.get("division", ())):
        changed = deepcopy(whole)
        changed["division"] = [list(d) for d in changed["division"]]
        changed["division"][k] = [label, draw.choice((f"{term}*{term}", "nothing", ""))]
        yield f"the term by which {label} divides", changed


def _places(part: Any) -> Iterator[tuple[Any, ...]]:
    """The ways to what stands anywhere in a certificate, where it can be changed."""
    inside = part.items() if isinstance(part, dict) else enumerate(part) if isinstance(part, list) else ()
    for key, value in inside:
        yield (key,)
        yield from ((key, *rest) for rest in _places(value))
