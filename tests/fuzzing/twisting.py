"""The same question asked otherwise: what holds must not fail when it is swapped, renamed, scaled or told more."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from random import Random
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from .equations import Equation, pairs

__all__ = ["twisted"]


def twisted(question: Equation, draw: Random) -> Iterator[tuple[str, Equation]]:
    """Questions with the same answer, each with what was done to it."""
    lhs, rhs = question.lhs, question.rhs
    yield "swapped", replace(question, lhs=rhs, rhs=lhs)
    yield "renamed", _renamed(question, draw)
    factor = draw.choice((sp.Integer(-1), sp.Integer(3), sp.Rational(2, 3), sp.pi))
    yield f"scaled by {factor}", replace(question, lhs=factor * lhs, rhs=factor * rhs)
    if not isinstance(lhs, sp.MatrixBase):
        yield "difference", replace(question, lhs=lhs - rhs, rhs=sp.Integer(0))
    if question.given:
        yield "permuted", replace(question, given=tuple(draw.sample(question.given, len(question.given))))
        yield "told more", replace(question, given=(*question.given, _redundant(question, draw)))
        yield "unfolded", _unfolded(question)


def _renamed(question: Equation, draw: Random) -> Equation:
    """Other letters, in another order of the alphabet, with the same assumptions."""
    letters = [f"{c}_" for c in "qwertzuiopasdfghjklyxcvbnm"]
    names = draw.sample(letters, len(question.atoms))
    new: dict[Any, Any] = {}
    for atom, name in zip(question.atoms, names, strict=True):
        if isinstance(atom, AppliedUndef):
            new[atom] = sp.Function(name)(*atom.args)
        else:
            new[atom] = sp.Symbol(name, **atom._assumptions_orig)

    symbols = {a: b for a, b in new.items() if isinstance(a, sp.Symbol)}
    functions = {a.func: b.func for a, b in new.items() if isinstance(a, AppliedUndef)}

    def swapped(e: Any) -> Any:
        if not hasattr(e, "xreplace"):
            return e
        return e.xreplace(symbols).replace(
            lambda x: isinstance(x, AppliedUndef) and x.func in functions, lambda x: functions[x.func](*x.args)
        )

    parts = [swapped(e) for e in (question.lhs, question.rhs)]
    return replace(
        question,
        lhs=parts[0],
        rhs=parts[1],
        given=tuple(map(swapped, question.given)),
        nonzero=tuple(map(swapped, question.nonzero)),
    )


def _redundant(question: Equation, draw: Random) -> Any:
    """What follows from the given equations: their sum, a multiple of one, or a rate of it."""
    (one, other) = draw.choice([p for item in question.given for p in pairs(item)])
    times = sorted({f.args[0] for e in (one, other) for f in e.atoms(AppliedUndef)}, key=str)
    if times and draw.random() < 0.5:
        return sp.diff(one - other, times[0])
    if draw.random() < 0.5:
        return sp.expand(2 * (one - other))
    (more, less) = draw.choice([p for item in question.given for p in pairs(item)])
    return one - other + more - less


def _unfolded(question: Equation) -> Equation:
    """A symbol that a given equation defines, replaced by what it is."""
    for k, item in enumerate(question.given):
        rest = (*question.given[:k], *question.given[k + 1 :])
        if not isinstance(item, sp.Equality) or not isinstance(item.lhs, sp.Symbol) or item.lhs._assumptions_orig:
            continue
        if isinstance(item.rhs, sp.Expr) and not item.rhs.has(item.lhs):
            values = {item.lhs: item.rhs}
            return replace(
                question,
                lhs=question.lhs.xreplace(values),
                rhs=question.rhs.xreplace(values),
                given=tuple(said for e in rest if (said := e.xreplace(values)) not in (True, 0)),
                nonzero=tuple(sp.sympify(e).xreplace(values) for e in question.nonzero),
            )
    return question
