"""Inverse functions of cosines, sines and tangents, for proofs in Coq: names for angles, of which both are known."""

from __future__ import annotations

from typing import Any

import sympy

from chasles.coq.plain import PlainExpressions
from chasles.coq.rational import text_of

LEMMAS = {sympy.asin: "of_asin", sympy.acos: "of_acos", sympy.atan: "of_atan", sympy.atan2: "of_atan2"}
TANGENTS = (sympy.atan, sympy.atan2)


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
