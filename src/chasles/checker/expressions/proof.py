"""Does a certificate prove an equation of SymPy expressions? The checker imports nothing of the prover.

It reads both sides and what is given by itself, as polynomials. A certificate says by what to multiply, and supplies
cofactors, the values of roots, and a witness: each is tried, and nothing else is believed.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from chasles.checker.expressions.algebra import primitive
from chasles.checker.expressions.asked import Asked
from chasles.checker.expressions.at_point import AtPoint
from chasles.checker.expressions.complexes import differences, parts
from chasles.checker.expressions.facts import Facts
from chasles.checker.expressions.motion import require_given
from chasles.checker.expressions.needs import require_needs
from chasles.checker.expressions.reading_of_proof import Proven, Spoken
from chasles.checker.expressions.signs import may_vanish
from chasles.checker.expressions.widened import check_widened
from chasles.checker.sparse import MOST_POWER, ONE, Polynomial, Rejected, number, parsed, variable, well_formed

Data = Mapping[str, Any]
PARTS = frozenset((
    "variant", "names", "positive", "squares", "turned", "raised", "angles", "substituted", "words", "roots",
    "equal", "frames", "divisors", "entries", "turns", "witness",
))  # fmt: skip
"""What a certificate may say."""


def check_proof(verdict: Any, lhs: Any, rhs: Any, given: Any = (), nonzero: Any = ()) -> None:
    """Every entry of both sides is equal wherever the needs of the verdict hold, and its witness is such a place.

    Raises `Rejected` with the reason if the certificate does not prove that.
    """
    with well_formed("certificate"):
        if verdict.witness is None:
            raise Rejected("the verdict has no witness")
        asked = Asked(lhs, rhs, given, nonzero)
        if {"proof", "cases"} & verdict.certificate.keys():
            sides = [[*map(side.get, sorted(side)), *asked.hidden] for side in (asked.left, asked.right)]
            stated = [(item.text, list(item.pairs.values())) for item in asked.given if item.pairs]
            stated += [(text, []) for text in asked.real]
            # The witness of the parts of a proof is that of the whole.
            check_widened(verdict, sides, stated, asked.nonzero, check_part)
        else:
            _check(verdict.certificate, verdict.needs, asked, verdict.witness)


def check_part(certificate: Data, needs: Sequence[str], question: tuple[Any, ...]) -> None:
    """The same of a part of a proof, which has no witness of its own."""
    _check(certificate, needs, Asked(*question), None)


def _check(certificate: Data, needs: Sequence[str], asked: Asked, witness: Any) -> None:
    if unknown := certificate.keys() - PARTS:
        raise Rejected(f"the certificate has a part {min(unknown)!r}, which says nothing")
    reading = Proven(asked, certificate)
    claims = claims_of(asked, reading, certificate)
    for e in asked.hidden:
        parts(reading, e)
    divisors = set(reading.inverses)
    for e in asked.nonzero:
        _declare(reading, e)
    facts = Facts(asked, reading, certificate)
    for item in asked.given:
        differences(reading, item.pairs)
    granted = set(reading.inverses)  # by which is divided before anything is differentiated
    divisors |= _prove(certificate, reading, facts, claims)
    divisors |= reading.inverses.keys() - granted - divisors
    require_needs(needs, asked, reading, divisors, facts.used)
    if witness is not None:
        _require_witness(witness, certificate["witness"], asked, reading, divisors)


def claims_of(asked: Asked, reading: Proven, certificate: Data) -> dict[tuple[int, int], Polynomial]:
    """What vanishes where both sides are equal.

    A sum of angles may vanish where its cosine is one, and a sum of logarithms does where its exponential is. Sides
    that are not negative are equal where their squares are.
    """
    if certificate["variant"] == 2:
        return {place: _of_squares(reading, left, asked.right[place]) for place, left in asked.left.items()}
    claims = differences(reading, {place: (left, asked.right[place]) for place, left in asked.left.items()})
    for how, compared in (("turned", reading.arcs.turned), ("raised", reading.functions.raised)):
        for label, number_of_times in certificate.get(how, {}).items():
            row, column = (int(part) - 1 for part in label.split(","))
            claims[row, column] = compared(claims[row, column], int(number_of_times))
    return claims


def _of_squares(reading: Proven, *sides: Any) -> Polynomial:
    """The difference of the squares of two sides; raises `Rejected` if one is not seen to be nonnegative."""
    left, right = (reading.normal(reading(side)) for side in sides)
    if not (reading.is_seen(left) and reading.is_seen(right)):
        raise Rejected("the squares of sides are compared that are not seen to be nonnegative")
    if reading.vanishes(left - right):
        raise Rejected("the certificate squares what is equal by itself")
    return reading.normal(left * left) - reading.normal(right * right)


def _declare(reading: Proven, e: Any) -> None:
    """What does not vanish, and by what it divides, may be divided by."""
    a, b = parts(reading, e)
    inverse = reading.over(reading.normal(a * a + b * b), str(e)) if b else reading.divide(e)
    for place in (a.places | b.places | inverse.places) & reading.inverses.keys():
        reading.divided.setdefault(place, set()).add(str(e))


def _prove(certificate: Data, reading: Proven, facts: Facts, claims: Mapping[tuple[int, int], Polynomial]) -> set[int]:
    """Show that every claim vanishes; the places of the inverses by which claims were multiplied."""
    variant, entries, multiplied = certificate["variant"], certificate.get("entries", {}), set()
    if isinstance(variant, bool) or variant not in (0, 1, 2) or not isinstance(variant, int):
        raise Rejected(f"the certificate's variant is {variant!r}: 0, 1 or 2 is expected")
    if not claims:
        raise Rejected("there is nothing to prove")
    open_claims = {f"{i + 1},{j + 1}": claim for (i, j), claim in claims.items() if not reading.vanishes(claim)}
    if different := entries.keys() ^ open_claims.keys():
        raise Rejected(f"entry {min(different)} does not follow, or follows without more being said")
    if variant == 1 and not open_claims:
        raise Rejected("the certificate squares what vanishes by itself")
    for label, said in entries.items():
        claim = open_claims[label]
        claim = reading.normal(claim * claim) if variant == 1 else claim
        multiplied |= _follows(certificate, reading, facts, claim, said, label)
    return multiplied


def _follows(certificate: Data, reading: Proven, facts: Facts, claim: Polynomial, said: Data, label: str) -> set[int]:
    """A claim times powers of what does not vanish is a sum of cofactors times facts; the inverses of the former."""
    if unknown := said.keys() - {"times", "cofactors"}:
        raise Rejected(f"the certificate says {min(unknown)!r} of entry {label}, which means nothing")
    cofactors = [(parsed(text, reading.places), facts[fact]) for fact, text in said.get("cofactors", {}).items()]
    numerator, below = reading.cleared(claim)
    powers, factor = dict[int, int](), ONE
    for which, power in said.get("times", {}).items():
        divisor = reading.normal(parsed(certificate["divisors"][int(which)], reading.places))
        place = reading.inverse_place(divisor)
        if isinstance(power, bool) or not isinstance(power, int) or not 0 < power <= MOST_POWER:
            raise Rejected(f"entry {label} is multiplied by a power {power!r}")
        if place is not None:
            powers[place] = powers.get(place, 0) + power
        elif may_vanish(reading, divisor):
            raise Rejected(f"entry {label} is multiplied by what the question does not divide by, and may vanish")
        for _ in range(power):
            factor = factor * (divisor if place is None else number(primitive(divisor)[0]))
    left, right = (
        reading.divisors({k: max(0, other.get(k, 0) - own.get(k, 0)) for k in powers.keys() | below.keys()})
        for own, other in ((below, powers), (powers, below))
    )
    rest = reading.normal(numerator * left * factor)
    for cofactor, fact in cofactors:
        rest = rest - reading.normal(cofactor * fact * right)
    if reading.normal(rest):
        raise Rejected(f"entry {label} does not follow")
    return set(powers)


def _require_witness(witness: Any, said: Data, asked: Asked, reading: Proven, divisors: set[int]) -> None:
    """The witness satisfies all that is given and needed, everything is defined there, and its two forms agree."""
    point = AtPoint(reading, witness)
    require_given(asked, point, through=False)
    for place in divisors:
        if not point.sign(point.value_of(reading.inverses[place])):
            raise Rejected("what is divided by is zero at the witness")
    for domain in reading.domains:
        if point.sign(point.value_of(domain)) < 0:
            raise Rejected("a root is not real at the witness")
    for value, _, _ in reading.functions.positives:
        if point.sign(point.value_of(value)) <= 0:
            raise Rejected("a logarithm is not real at the witness")
    if reading.calls:
        if not said.items() <= {str(name): str(value) for name, value in witness.items()}.items():
            raise Rejected("the verdict and its certificate have different witnesses")
        return
    point.require_angles()
    spoken = Spoken(point, point.spelled())
    for name, text in said.items():
        if name not in reading.places:
            raise Rejected(f"the witness gives a value to {name}, which does not occur")
        if not point.vanishes(spoken(str(text)) - point.value_of(variable(reading.places[name]))):
            raise Rejected(f"the witness has two values of {name}")
    spelled = {str(e): e for e in reading.atoms.values()}
    if unknown := point.numbers.keys() - spelled.keys():
        raise Rejected(f"the witness gives a value to {min(unknown)}, which does not occur")
    valued = point.valued()
    for name, place in reading.places.items():
        if name not in said and (place in reading.words or place in valued):
            raise Rejected(f"no value is given for {name}")
