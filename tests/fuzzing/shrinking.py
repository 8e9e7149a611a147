"""The smallest question that still gives the same alarm: givens dropped, parts replaced by smaller ones."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from time import process_time
from typing import Any, TypeVar

import sympy as sp
from sympy.core.function import AppliedUndef

from .equations import Equation

__all__ = ["shrunk", "smaller"]

Q = TypeVar("Q")
SECONDS = 20.0
"""Processor time for one alarm: it is for people to read, and no verdict depends on it."""
SIMPLEST = (sp.Integer(0), sp.Integer(1))


def shrunk(
    question: Q, ways: Callable[[Q], Iterator[Q]], persists: Callable[[Q], bool], most: int = 150
) -> tuple[Q, int]:
    """The question made smaller as long as the alarm persists, with at most so many tries, and how many it took."""
    tries, end = 0, process_time() + SECONDS
    while True:
        for smaller_one in ways(question):
            tries += 1
            if tries > most or process_time() > end:
                return question, tries
            if persists(smaller_one):
                question = smaller_one
                break
        else:
            return question, tries


def smaller(question: Equation) -> Iterator[Equation]:
    """Questions that are smaller by one thing, the ones that are much smaller first."""
    question = question.unlabelled()
    for name in ("given", "nonzero", "where"):
        items = getattr(question, name)
        for k in range(len(items)):
            yield replace(question, **{name: (*items[:k], *items[k + 1 :])})
    if isinstance(question.lhs, sp.MatrixBase):
        for left, right in zip(question.lhs, question.rhs, strict=True):
            yield replace(question, lhs=left, rhs=right)
        return
    yield from _both_smaller(question)
    for name in ("lhs", "rhs"):
        for other in _smaller(getattr(question, name)):
            yield replace(question, **{name: other})
    for k, item in enumerate(question.given):
        if isinstance(item, sp.Equality):
            items = [sp.Eq(a, item.rhs, evaluate=False) for a in _smaller(item.lhs)]
            items += [sp.Eq(item.lhs, b, evaluate=False) for b in _smaller(item.rhs)]
        else:
            items = list(_smaller(item)) if isinstance(item, sp.Expr) else []
        for other in items:
            yield replace(question, given=(*question.given[:k], other, *question.given[k + 1 :]))


def _both_smaller(question: Equation) -> Iterator[Equation]:
    """A part that occurs on both sides, replaced in both."""
    common = {p for p in sp.preorder_traversal(question.lhs) if p.args} & set(sp.preorder_traversal(question.rhs))
    for part in sorted(common, key=lambda p: (-sp.count_ops(p), str(p))):
        for other in SIMPLEST:
            try:
                left, right = (side.xreplace({part: other}).doit() for side in (question.lhs, question.rhs))
            except (TypeError, ValueError, ZeroDivisionError):
                continue
            if sound(left) and sound(right):
                yield replace(question, lhs=left, rhs=right)


def _smaller(e: Any) -> Iterator[Any]:
    """Expressions with one part of it replaced by something below it, by an atom or by a small number."""
    seen = {e}
    size = _size(e)
    times = {argument for f in e.atoms(AppliedUndef) for argument in f.args}
    for part in sorted(set(sp.preorder_traversal(e)), key=lambda p: (-_size(p), str(p))):
        if part in times:
            continue
        moving = isinstance(part, sp.Derivative | AppliedUndef)
        below = [] if moving else [a for a in part.args if isinstance(a, sp.Expr)]
        numbers = SIMPLEST if not isinstance(part, sp.Integer) or abs(part) > 1 else ()
        for other in (*numbers, *below):
            try:
                found = e.xreplace({part: other}).doit()
            except (TypeError, ValueError, ZeroDivisionError, AttributeError):
                continue
            if found not in seen and _size(found) < size and sound(found):
                seen.add(found)
                yield found


def sound(e: Any) -> bool:
    """Whether it has a value at most points, and functions of time are functions of time in it."""
    times = {argument for f in e.atoms(AppliedUndef) for argument in f.args}
    moving = all(isinstance(derivative.expr, AppliedUndef) for derivative in e.atoms(sp.Derivative))
    return moving and all(isinstance(s, sp.Symbol) for s in times) and not e.has(sp.nan, sp.zoo, sp.oo, sp.Subs)


def _size(e: Any) -> int:
    return sum(1 + 2 * (isinstance(p, sp.Rational) and p not in SIMPLEST) for p in sp.preorder_traversal(e))
