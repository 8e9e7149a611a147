"""What a notation says of a symbol's kind, and what an expression divides by, as named hypotheses."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from chasles.statements import Hypothesis, definite, nonzero, positive, rotation, symmetric, unit
from chasles.statements.simpler_words import factors_of
from chasles.statements.varied import opened_parts
from chasles.vocabulary import Misfit, Node, Quotient, Symbol

HYPOTHESES: dict[str, Callable[[Node], Hypothesis]] = {
    "unit quaternion": unit,
    "unit vector": unit,
    "rotation": rotation,
    "positive-definite": definite,
    "symmetric": symmetric,
    "positive": positive,
}
"""The kinds of symbols that say something of their values."""


def kind_in_meaning(symbol: Symbol) -> str:
    """The kind with which the symbol's meaning begins, as in "unit vector along the axis"; empty for any other."""
    said = f"{symbol.meaning} ".replace(",", " ")
    return next((kind for kind in HYPOTHESES if said.startswith(f"{kind} ")), "")


def facts_of(symbol: Symbol, kind: str) -> tuple[Hypothesis, ...]:
    """The hypothesis that a kind names, said of the symbol; none where the kind says nothing, or not of its shape."""
    assume = HYPOTHESES.get(kind)
    if assume is None or symbol.stands_for is not None:
        return ()
    try:
        return (assume(symbol),)
    except (Misfit, TypeError):
        return ()


def divisors(sides: Iterable[Node]) -> tuple[Hypothesis, ...]:
    """What the expressions divide by, as hypotheses that it is not zero; each factor and each length once."""
    found = dict.fromkeys(
        factor
        for side in sides
        for part in opened_parts(side)
        if isinstance(part, Quotient)
        for factor in factors_of(part.denominator)
    )
    return tuple(map(nonzero, found))
