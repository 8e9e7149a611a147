"""Do the powers of a scale cancel? Only where they do is a result the same whatever positive number the scale is."""

from __future__ import annotations

from collections import Counter

from chasles.bounds.outline import NoBound, Outline
from chasles.lowering.program import Op

__all__ = ["ensure_free_of_scales"]

Powers = dict[int, int]
"""By what power of each scale a step's exact value is multiplied, where the scales are; powers of 0 are left out."""


def ensure_free_of_scales(outline: Outline) -> None:
    """Raises NoBound unless every result, and every sign that is chosen by, is free of the outline's scales."""
    found: dict[int, Powers | None] = {}
    for number in outline.needed:
        found[number] = {number: 1} if number in outline.scales else _powers(outline, number, found)
    results = [k for index in range(len(outline.program.results)) for k in outline.entries(index)]
    if any(found[k] != {} for k in results) or any(found[k] is None for k in outline.signs):
        raise NoBound("it depends on a scale that is rounded")


def _powers(outline: Outline, number: int, found: dict[int, Powers | None]) -> Powers | None:
    """The powers that a step is multiplied by; none where it is no multiple of a power."""
    step = outline.program.steps[number]
    of = [found[k] for k in outline.operands(number)] if number not in outline.angles else []
    known = [powers for powers in of if powers is not None]
    if len(known) < len(of):
        return None
    match step.op:
        case Op.INPUT | Op.CONSTANT | Op.SINE | Op.COSINE:
            return {}
        case Op.NEGATE:
            return known[0]
        case Op.MULTIPLY:
            return _combined(known[0], known[1], 1)
        case Op.DIVIDE:
            return _combined(known[0], known[1], -1)
        case Op.SQUARE_ROOT if all(power % 2 == 0 for power in known[0].values()):
            return {scale: power // 2 for scale, power in known[0].items()}
        case Op.ADD | Op.SUBTRACT if known[0] == known[1]:
            return known[0]
        case Op.ARCTANGENT2 if known[0] == known[1]:
            return {}
        case _:
            return None


def _combined(one: Powers, other: Powers, sign: int) -> Powers:
    """The powers of a product, or of a quotient."""
    total = Counter(one)
    total.update({scale: sign * power for scale, power in other.items()})
    return {scale: power for scale, power in total.items() if power}
