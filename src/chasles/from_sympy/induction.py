"""Sums and products up to a letter: refuted at its least values, or proved by induction on it.

Powers and factorials of a letter are products up to it: then induction on it is tried.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

import sympy

from chasles.checker.expressions.induction import LONG, Question, joined, least_of, letters_of, scalar_question, steps
from chasles.checker.expressions.quantities import with_values
from chasles.checker.expressions.readings import is_integral
from chasles.checker.sparse import Rejected
from chasles.from_sympy.bounded_symbols import Said
from chasles.problems.variables import Untreatable
from chasles.verdict import Contradictory, Fails, Holds, HoldsUnder, Verdict

MOST_TRIED = 3
"""So many values of a letter are tried."""
STEP = sympy.Symbol("k_1", integer=True, positive=True)


def by_induction(asked: tuple[Any, ...], answer: Callable[..., Verdict]) -> Verdict | None:
    """The verdict on a question that adds or multiplies up to a letter; None where induction decides nothing."""
    if not any(isinstance(side, sympy.Expr) and side.has(*LONG) for side in asked[:2]):
        return None
    try:
        question = scalar_question(*asked)
        letters = letters_of(question)
    except (Rejected, TypeError, ValueError):  # of conditions that are none
        return None
    for letter in letters:
        try:
            found = _decided(question, letter, answer)
        except (Rejected, Untreatable):
            continue
        if found is not None:
            return found
    return None


def _decided(question: Question, letter: Any, answer: Callable[..., Verdict]) -> Verdict | None:
    """The verdict by one letter; raises `Rejected` or `Untreatable` where something is in the way."""
    least = least_of(letter)
    for value in range(least, least + MOST_TRIED):
        at = {letter: sympy.Integer(value)}
        sides, given = ([with_values(e, at) for e in said] for said in (question[:2], question[2]))
        verdict = answer(*sides, given, question[3])
        if isinstance(verdict, Contradictory):
            return verdict
        if isinstance(verdict, Fails):
            point = {**verdict.counterexample.at, str(letter): Fraction(value)}
            return Fails(replace(verdict.counterexample, at=point))
    name = "s"
    while any(str(symbol).startswith(name) for side in question[:2] for symbol in side.free_symbols):
        name += "_"
    _, base, step = steps(question, letter, name)
    parts = [answer(*base), answer(*step)]
    proved = [
        HoldsUnder(part.needs, part.certificate, part.witness) for part in parts if isinstance(part, Holds | HoldsUnder)
    ]
    if len(proved) < len(parts):
        return None
    needs, witness = joined(proved, (base, step), letter, least)
    said = [{"needs": list(part.needs), "proof": part.certificate, "witness": dict(part.witness)} for part in proved]
    certificate = {"induction": {"on": str(letter), "name": name, "parts": said}}
    return HoldsUnder(tuple(sorted(needs)), certificate, witness) if needs else Holds(certificate, witness)


def counts(part: Any) -> bool:
    """Whether a power or a factorial may be a product up to an integer."""
    up_to = part.args[-1]
    return not isinstance(up_to, sympy.Integer) and any(symbol.is_integer for symbol in up_to.free_symbols)


def stepwise(said: Said) -> Said | None:
    """What is said, with products in its sides for b**n and n! of an integer n from zero on; None if there are none.

    Of integers it is said that the greater one is at least by one more.
    """
    sides = said[:2]
    if not all(isinstance(side, sympy.Expr) for side in sides):
        return None
    found = {part: _product(part) for side in sides for part in side.atoms(sympy.Pow, sympy.factorial)}
    found = {part: value for part, value in found.items() if value is not None}
    if not found or any(STEP in side.free_symbols for side in sides):
        return None
    if isinstance(sides[0], sympy.sign) and sides[1] == 1 and _is_integral(sides[0].args[0]):
        more = sides[0].args[0] - 1
        sides = sympy.Abs(more), more
    return (*(side.xreplace(found) for side in sides), *said[2:])


def _is_integral(e: Any) -> bool:
    """Whether an expression is made of integers, and of powers of integers and factorials that have products."""
    e = sympy.expand(e).replace(lambda part: _base_of(part) is not None, lambda _: sympy.Dummy(integer=True))
    return is_integral(e)


def _base_of(part: Any) -> Any:
    """Whose product a power of an integer or a factorial is; None for others."""
    product = _product(part) if isinstance(part, sympy.Pow | sympy.factorial) else None
    return product if product is not None and is_integral(part.args[0]) else None


def _product(part: Any) -> Any:
    """What a power or a factorial is up to its letter; None for others."""
    base, exponent = (STEP, part.args[0]) if isinstance(part, sympy.factorial) else part.args
    letters = [s for s in exponent.free_symbols if s.is_integer and s.is_nonnegative and not base.has(s)]
    if len(letters) != 1 or base is sympy.E:
        return None
    (letter,) = letters
    slope, start = exponent.coeff(letter), exponent.xreplace({letter: sympy.S.Zero})
    whole = slope.is_Integer and start.is_Integer and exponent == slope * letter + start
    if not whole or slope < 1 or (base is STEP and (slope > 1 or start < 0)):
        return None
    if base is STEP:
        return sympy.factorial(start) * sympy.Product(STEP + start, (STEP, 1, letter))
    return base**start * sympy.Product(base**slope, (STEP, 1, letter))
