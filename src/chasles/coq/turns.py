"""Angles for proofs in Coq: cosines and sines of sums in those of the parts, and angles by their sine or tangent."""

from __future__ import annotations

import re
from typing import Any

import sympy

from chasles.coq.expressions import ATOM, Unsaid
from chasles.coq.plain import PlainExpressions, text_of

LEMMAS = {sympy.asin: "of_asin", sympy.acos: "of_acos", sympy.atan: "of_atan", sympy.atan2: "of_atan2"}
TANGENTS = (sympy.atan, sympy.atan2)
UNIT = re.compile(r"(?:cos|sin)\(([1-9]\d*)?(.+?)(?:/([1-9]\d*))?\)")
OPENED = (
    "repeat first [rewrite cos_plus | rewrite sin_plus | rewrite cos_minus | rewrite sin_minus | rewrite cos_neg "
    "| rewrite sin_neg | at_parts_of_pi]"
)
MOST_TURNS = 16
"""Multiples of an angle beyond this are not taken apart."""
KNOWN = tuple(sympy.pi / part for part in (2, 3, 4, 6))
"""Angles whose cosine and sine the theories know."""


def inverse(plain: PlainExpressions, e: Any) -> Any:
    """An angle by its sine or tangent as a symbol, by its cosine as what is left of a right one; None for others."""
    if e.func not in LEMMAS:
        return None
    name = plain.angle(e)
    value = plain.symbol(name)
    if e.func is sympy.acos:
        sine = plain(sympy.asin(e.args[0]))
        value = plain(sympy.pi) / 2 - sine
        sines = "".join(f", <- ?of'{known}" for of, known in plain.angles.items() if of.func is sympy.asin)
        plain.value(name, value, f"(rewrite of'{name}, acos_asin by (split; nra); rewrite ?asin_opp{sines}; reckon)")
    plain.named |= {plain.labels[str(e)]: value} if str(e) in plain.labels else {}
    return value


def cosine_and_sine(plain: PlainExpressions, e: Any) -> tuple[str, Any, Any]:
    """The name of such an angle, its cosine and its sine."""
    name, known = plain.angle(e), f"both'{plain.angle(e)}"
    of = [plain(each) for each in e.args]
    squares = sympy.Add(*(each**2 for each in e.args))
    square = {sympy.atan: squares + 1, sympy.atan2: squares}.get(e.func, 1 - squares)
    r = plain(sympy.sqrt(square))
    if e.func in TANGENTS:
        cosine, sine = (of[1] if len(of) == 2 else 1) / r, of[0] / r
    else:
        cosine, sine = (of[0], r) if e.func is sympy.acos else (r, of[0])
    if not any(known in fact for fact in plain.facts):
        is_known = f"{plain.rewritten}identity"
        square_is = f"apply (by_parts _ _ ({plain.total(r**2 - plain(square))})); [vanish | {is_known}]"
        steps = [*[is_known] * len(of), "nonnegative", square_is, *["not_zero_known"] * (len(of) - 1)]
        third = " ".join(["_"] * (len(of) + 1) + [text_of(r), *map(text_of, of)])
        says = f"cos {name} = {text_of(cosine)} /\\ sin {name} = {text_of(sine)}"
        plain.facts += plain.nonzero(1 / r)
        plain.facts += [
            f"assert ({known} : {says}) by (apply ({LEMMAS[e.func]} {third} of'{name}); [{' | '.join(steps)}]).",
            f"destruct {known} as [cos'{name} sin'{name}].",
        ]
        plain.values += [f"cos'{name}", f"sin'{name}"]
    return name, cosine, sine


def turned(plain: PlainExpressions, e: Any) -> Any:
    """A cosine or sine, by the addition formulas; None for what is none."""
    if e.func not in (sympy.cos, sympy.sin):
        return None
    cosine, sine, parts = sympy.Integer(1), sympy.Integer(0), []
    for atom, multiple in sympy.expand(e.args[0]).as_coefficients_dict().items():
        unit = _unit_of(plain, atom, multiple)
        turns = multiple / unit
        if not turns.is_Integer or abs(turns) > MOST_TURNS:
            raise Unsaid(f"no proof is written about the angle {e.args[0]}")
        text, c, s = _circle(plain, atom, unit)
        if abs(turns) == 1 and e.args[0] == atom * unit:
            return c if e.func is sympy.cos else s
        parts += [f"{'-' if turns < 0 else '+'} {text}"] * abs(turns)
        for _ in range(abs(turns)):
            d = s if turns > 0 else -s
            cosine, sine = sympy.expand(cosine * c - sine * d), sympy.expand(sine * c + cosine * d)
    value, name = cosine if e.func is sympy.cos else sine, plain.remember(e)
    total = " ".join(parts).removeprefix("+ ")
    function = "cos" if e.func is sympy.cos else "sin"
    angles = "".join(f"rewrite ?of'{each}; " for each in plain.angles.values())
    equal = f"apply f_equal; {angles}first [lra | reckon]"
    known = "".join(f"rewrite <- ?of'{each}; " for text, each in plain.remembered.items() if text.startswith("sqrt"))
    steps = f"transitivity ({function} ({total})); [{equal} | {OPENED}; {known}{plain.rewritten}reckon]"
    plain.value(name, value, f"(rewrite of'{name}; {steps})")
    return value


def _unit_of(plain: PlainExpressions, atom: Any, multiple: Any) -> Any:
    """The part of an angle of which the cosine and the sine are variables: as the certificate has it."""
    if atom is sympy.pi:
        return sympy.Rational(1, max(2, multiple.q))
    if atom.func in LEMMAS:
        return sympy.Integer(1)
    said = (*plain.certificate.get("witness", {}), *plain.certificate.get("turns", ()))
    labels = _labels(plain, atom)
    units = [sympy.Rational(int(m[1] or 1), int(m[3] or 1)) for m in map(UNIT.fullmatch, said) if m and m[2] in labels]
    return units[-1] if units else abs(multiple)


def _labels(plain: PlainExpressions, atom: Any) -> list[str]:
    """What a certificate may call an angle; a number as an angle stands in brackets there."""
    angles = plain.certificate.get("angles", {}).items()
    text = "(1)" if atom is sympy.S.One else str(atom)
    return [
        str(atom),
        plain.labels.get(text, str(atom)),
        *(label for label, text in angles if not sympy.expand(plain.parsed(f"1*{text}") - plain(atom))),
    ]


def _circle(plain: PlainExpressions, atom: Any, unit: Any) -> tuple[str, Any, Any]:
    """An angle as it is spelled, its cosine and its sine: known to the theories, or on a circle."""
    angle = atom * unit
    text = plain.statement.side(angle, ATOM)
    if angle in KNOWN:
        return text, plain(sympy.cos(angle)), plain(sympy.sin(angle))
    if atom.func in LEMMAS:
        return cosine_and_sine(plain, atom)
    at = {each: sympy.Dummy() for each in plain.statement.words.atoms}
    if not atom.xreplace(at).is_rational_function():
        text = plain.angle(angle)
    c, s = (plain.symbol(f"({function} {text})") for function in ("cos", "sin"))
    plain.of_numbers |= {c, s} if atom is sympy.S.One else set()
    labels = [str(sympy.Symbol(name) * unit).replace("*", "") for name in _labels(plain, atom)]
    if f"cos({labels[0]})" not in plain.named:
        plain.named |= {f"{f}({label})": v for f, v in (("cos", c), ("sin", s)) for label in labels}
        plain.facts.append(f"pose proof (COS_bound {text}). pose proof (SIN_bound {text}).")
        plain.rule(c, 1 - s**2, f"refine (eq_trans _ (circle {text})); identity")
    return text, c, s
