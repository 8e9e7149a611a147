"""The labels by which the checker knows the facts that a proof uses, found by comparing polynomials."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from chasles.algebra.groebner import Combination
from chasles.algebra.rings import written as text_of
from chasles.checker.expressions.algebra import primitive
from chasles.checker.expressions.asked import Asked
from chasles.checker.expressions.complexes import differences
from chasles.checker.expressions.facts import Facts
from chasles.checker.expressions.reading_of_proof import Proven
from chasles.checker.sparse import Polynomial, Rejected, parsed
from chasles.problems.context import Context

Key = frozenset[tuple[int, int]]


class FactLabels:
    """Finds the checker's label for a polynomial that vanishes."""

    def __init__(self, asked: Asked, reading: Proven, certificate: Mapping[str, Any]) -> None:
        self.reading = reading
        self.facts = Facts(asked, reading, certificate)
        self.names = [
            f"given {k} {i + 1},{j + 1}"
            for k, item in enumerate(asked.given)
            for i, j in differences(reading, item.pairs)
        ]
        for k, frame in enumerate(certificate.get("frames", ())):
            size = len(frame["rows"])
            rows = range(1, size * (2 if frame["proper"] else 1) + 1)
            self.names += [f"frame {k} {i},{j}" for i in rows for j in range(1, size + 1)]
        for k, found in enumerate(certificate.get("squares", ())):
            self.names += [f"square {k} {i + 1},1" for i in range(len(found["squares"]))]
        if reading.calls:
            self.names += [f"{of} {name}" for name in self.names if name.startswith("given") for of in ("exp", "log")]
        self.names += [f"zero {name}" for name, place in reading.places.items()
                       if getattr(reading.atoms.get(place), "is_zero", False)]  # fmt: skip
        roots = {place for place, _ in reading.functions.roots.values()}
        self.names += [f"root {name}" for name, place in reading.places.items() if place in roots]
        self.equal = [f"equal {k}" for k in range(len(certificate.get("equal", ())))]
        self.known: dict[Key, tuple[str, Fraction]] = {}
        self.order = -1

    def __call__(self, text: str) -> tuple[str, Fraction]:
        """The label, and of which multiple of it this is the text."""
        scale, base = primitive(self.reading.normal(parsed(text, self.reading.places)))
        key = _key(base)
        while key not in self.known and self._differentiate():
            pass
        if key not in self.known:
            raise Rejected(f"{text} is not seen to follow from what is given")
        label, other = self.known[key]
        return label, scale / other

    def cofactors(self, context: Context, combination: Combination) -> dict[str, str]:
        """What each fact is multiplied by, by its label."""
        ring, found = context.field.ring, {}
        for k, cofactor in combination.items():
            generator = context.generators[k]
            if generator.hypothesis is not None and generator.hypothesis.kind != "root":
                label, scale = self(text_of(ring, generator.polynomial))
                found[label] = text_of(ring, cofactor * ring.constant(scale))
        return found

    def _differentiate(self) -> bool:
        """Take the next derivative of everything."""
        self.order += 1
        most = max((int(getattr(e, "derivative_count", 0)) for e in self.reading.atoms.values()), default=0)
        if self.order > most + 1:
            return False
        rate = f" d{self.order}" if self.order else ""
        for label in (*(name + rate for name in self.names), *(self.equal if not rate else ())):
            try:
                scale, base = primitive(self.facts[label])
            except Rejected:
                continue
            self.known.setdefault(_key(base), (label, scale))
        return True


def _key(polynomial: Polynomial) -> Key:
    return frozenset(polynomial.terms.items())
