"""What is assumed of all members of a collection, or of all elements of a body, summed over them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace as with_fields

from chasles.statements.hypotheses import Hypothesis
from chasles.statements.varied import opened_parts
from chasles.vocabulary import Integral, Node, Scale, Symbol


def summed(sides: Iterable[Node], hypotheses: tuple[Hypothesis, ...]) -> Iterator[Hypothesis]:
    """The sums of both sides of each equation that is assumed of what differs, also weighted by what differs."""
    integrals = [part for side in sides for part in opened_parts(side) if isinstance(part, Integral)]
    if not integrals:
        return
    first = integrals[0]
    weights = [
        part for part in dict.fromkeys(part for each in integrals for part in opened_parts(each.of))
        if isinstance(part, Symbol) and part.is_scalar and part in first.running
    ]  # fmt: skip
    for hypothesis in hypotheses:
        about = {part for pair in hypothesis.equations for side in pair for part in opened_parts(side)}
        if not about & first.running:
            continue
        pairs = [*hypothesis.equations]
        pairs += [(Scale(weight, one), Scale(weight, other)) for weight in weights for one, other in pairs]
        sums = tuple(tuple(with_fields(first, of=side) for side in pair) for pair in pairs)
        equations = tuple((one, other) for one, other in sums)
        text = f"{hypothesis.text} for each"
        yield Hypothesis("of all members", sum(sums, ()), equations, (), hypothesis.latex, text, free=True)
