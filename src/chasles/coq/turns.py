"""Cosines and sines of sums of angles in those of the angles, for proofs in Coq."""

from __future__ import annotations

import re
from fractions import Fraction
from typing import Any

import sympy

from chasles.coq.expressions import ATOM, TIMES, Unsaid
from chasles.coq.plain import PlainExpressions

UNIT = re.compile(r"(?:cos|sin)\(([1-9]\d*)?(.+?)(?:/([1-9]\d*))?\)")
OPENED = (
    "repeat first [rewrite cos_plus | rewrite sin_plus | rewrite cos_minus | rewrite sin_minus | rewrite cos_neg "
    "| rewrite sin_neg | at_parts_of_pi]"
)
MOST_TURNS = 16
"""Multiples of an angle beyond this are not taken apart."""
KNOWN = tuple(sympy.pi / part for part in (2, 3, 4, 6))
"""Angles whose cosine and sine the theories know."""


def turned(plain: PlainExpressions, e: Any) -> Any:
    """A cosine or sine, by the addition formulas; None for what is none."""
    if e.func not in (sympy.cos, sympy.sin):
        return None
    cosine, sine, parts = sympy.Integer(1), sympy.Integer(0), []
    for atom, multiple in sympy.expand(e.args[0]).as_coefficients_dict().items():
        unit = _unit_of(plain, atom, multiple)
        turns = multiple / sympy.Rational(unit.numerator, unit.denominator)
        at = {each: sympy.Dummy() for each in plain.statement.words.atoms}
        if not turns.is_Integer or abs(turns) > MOST_TURNS or not atom.xreplace(at).is_rational_function():
            raise Unsaid(f"no proof is written about the angle {e.args[0]}")
        angle = atom * sympy.Rational(unit.numerator, unit.denominator)
        c, s = _circle(plain, atom, angle)
        if abs(turns) == 1 and e.args[0] == angle:
            return c if e.func is sympy.cos else s
        parts += [f"{'-' if turns < 0 else '+'} {plain.statement.side(angle, TIMES)}"] * abs(turns)
        for _ in range(abs(turns)):
            d = s if turns > 0 else -s
            cosine, sine = sympy.expand(cosine * c - sine * d), sympy.expand(sine * c + cosine * d)
    value, name = cosine if e.func is sympy.cos else sine, plain.remember(e)
    total = " ".join(parts).removeprefix("+ ")
    function = "cos" if e.func is sympy.cos else "sin"
    replaced = f"replace ({plain.statement.side(e)}) with ({function} ({total})) by (f_equal; first [lra | reckon])"
    known = "".join(f"rewrite <- ?of'{each}; " for text, each in plain.remembered if text.startswith("sqrt"))
    plain.value(name, value, f"(rewrite of'{name}; {replaced}; {OPENED}; {known}reckon)")
    return value


def _unit_of(plain: PlainExpressions, atom: Any, multiple: Any) -> Fraction:
    """The part of an angle of which the cosine and the sine are variables: as the certificate has it."""
    if atom is sympy.pi:
        return Fraction(1, max(2, multiple.q))
    said = (*plain.certificate.get("witness", {}), *plain.certificate.get("turns", ()))
    labels = _labels(plain, atom)
    units = [Fraction(int(m[1] or 1), int(m[3] or 1)) for m in map(UNIT.fullmatch, said) if m and m[2] in labels]
    return units[-1] if units else abs(Fraction(int(multiple.p), int(multiple.q)))


def _labels(plain: PlainExpressions, atom: Any) -> list[str]:
    """What a certificate may call an angle."""
    angles = plain.certificate.get("angles", {}).items()
    return [
        str(atom),
        plain.labels.get(str(atom), str(atom)),
        *(label for label, text in angles if not sympy.expand(plain.parsed(f"1*{text}") - plain(atom))),
    ]


def _circle(plain: PlainExpressions, atom: Any, angle: Any) -> tuple[Any, Any]:
    """The cosine and sine of an angle: known to the theories, or on a circle."""
    if angle in KNOWN:
        return plain(sympy.cos(angle)), plain(sympy.sin(angle))
    text = plain.statement.side(angle, ATOM)
    c, s = (plain.symbol(f"({function} {text})") for function in ("cos", "sin"))
    labels = [str(angle.subs(atom, sympy.Symbol(name))).replace("*", "") for name in _labels(plain, atom)]
    if f"cos({labels[0]})" not in plain.named:
        plain.named |= {f"{f}({label})": v for f, v in (("cos", c), ("sin", s)) for label in labels}
        plain.facts.append(f"pose proof (COS_bound {text}). pose proof (SIN_bound {text}).")
        plain.rule(c, 1 - s**2, f"refine (eq_trans _ (circle {text})); identity")
    return c, s
