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
from chasles.checker.sparse import Rejected
from chasles.from_sympy.inequalities import COMPARED
from chasles.problems.variables import Untreatable
from chasles.verdict import Contradictory, Fails, Holds, HoldsUnder, Verdict

MOST_TRIED = 3
"""So many values of a letter are tried."""
STEP = sympy.Symbol("k_1", integer=True)


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
        at = [with_values(side, {letter: sympy.Integer(value)}) for side in question[:2]]
        verdict = answer(*at, *question[2:])
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


def stepwise(claim: Any) -> Any:
    """An inequality with products for b**n and n! of an integer n from zero on; the same if there are none."""
    if not isinstance(claim, COMPARED) or STEP in claim.free_symbols:
        return claim
    found = {part: _product(part) for part in claim.atoms(sympy.Pow, sympy.factorial)}
    found = {part: value for part, value in found.items() if value is not None}
    return claim.func(*(side.xreplace(found) for side in claim.args), evaluate=False) if found else claim


def _product(part: Any) -> Any:
    """What a power or a factorial is up to its letter; None for others."""
    base, exponent = (STEP, part.args[0]) if isinstance(part, sympy.factorial) else part.args
    letters = [s for s in exponent.free_symbols if s.is_integer and s.is_nonnegative and not base.has(s)]
    if len(letters) != 1 or base is sympy.E:
        return None
    (letter,) = letters
    slope, start = exponent.coeff(letter), exponent.xreplace({letter: sympy.S.Zero})
    whole = slope.is_Integer and start.is_Integer and exponent == slope * letter + start
    if not whole or slope < 1 or (base is STEP and exponent is not letter):
        return None
    product = sympy.Product(base**slope, (STEP, 1, letter))
    return product if base is STEP else base**start * product
