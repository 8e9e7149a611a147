"""Square roots and absolute values as a certificate has them, for proofs in Coq."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from fractions import Fraction
from functools import reduce
from itertools import chain, product
from operator import mul
from typing import Any

import sympy

from chasles.algebra.squares import sum_of_squares
from chasles.coq.expressions import Unsaid
from chasles.coq.plain import PlainExpressions, divisors_of, text_of

MOST_KNOWN = 5
"""A root is looked for among the products and quotients of so many that are known."""
LEMMAS = {"sqrt": "root", "abs": "size"}


def words_named(plain: PlainExpressions) -> None:
    """The roots and absolute values of which a certificate speaks, whether or not the question does."""
    words = plain.certificate.get("words", ())
    for e in (sympy.sqrt(int(text)) for _, kind, text in words if kind == "sqrt" and text.isdigit()):
        plain(e)
    for name, kind, text in words:
        for e in _roots_of(plain, kind):
            if name not in plain.named and _same(plain, plain(e.args[0]), kind, text):
                plain(e)
        if name not in plain.named:
            _introduced(plain, name, kind, text)


def root(plain: PlainExpressions, e: Any) -> Any:
    """A power of a root, an absolute value or a sign in what is known or a symbol with its square; None for others."""
    if e.func is sympy.sign:
        return _positive(plain, e)
    if e.func is sympy.Abs:
        return _root(plain, e, "abs")
    if e.is_Pow and e.exp.is_Rational and e.exp.q == 2:
        of = sympy.sqrt(e.base)
        return _root(plain, e, "sqrt") if e == of else plain(of) ** (2 * e.exp)
    return None


def _root(plain: PlainExpressions, e: Any, kind: str) -> Any:
    said = sympy.together(plain(e.args[0]))
    square = said if kind == "sqrt" else said**2
    name = plain.remember(e)
    words = plain.certificate.get("words", ())
    names = [each for each, what, text in words if what == kind and _same(plain, said, kind, text)]
    known = f"pose proof ({LEMMAS[kind]}_positive _ _ of'{name}) as positive'{name}."
    plain.facts += [known] * (known not in plain.facts)
    ways = [_known(plain, square), _other_roots(plain), _other_sides(plain, e)]
    if plain.certificate.get("facts"):
        ways.reverse()
    for value in () if names else chain(*ways):
        try:
            total = plain.total(square - value**2)
        except Unsaid:
            continue
        plain.facts += plain.nonzero(value)
        equal = f"apply (by_parts _ _ ({total})); [vanish | {plain.rewritten}identity]"
        plain.facts += _squares(plain, value)
        plain.value(name, value, f"(apply ({LEMMAS[kind]}_value _ _ _ of'{name}); [nonnegative | {equal}])")
        return value
    plain.named |= dict.fromkeys(names, _symbol(plain, name, kind, square))
    return plain.symbol(name)


def _positive(plain: PlainExpressions, e: Any) -> Any:
    """The sign of what is positive: one."""
    of, name = plain(e.args[0]), plain.remember(e)
    plain.facts += [*plain.nonzero(1 / of), *_squares(plain, of)]
    ways = [f"replace a with {text_of(each)} by reckon; first [above | lra]" for each in (of, sympy.factor(of))]
    shown = " | ".join(f"match goal with |- 0 < ?a => {way} end" for way in dict.fromkeys(ways))
    steps = f"destruct (Rlt_dec 0 _) as [|no']; [reflexivity | exfalso; apply no'; first [above | {shown}]]"
    steps = f"rewrite of'{name}; unfold sign; {plain.rewritten}{steps}"
    plain.value(name, sympy.Integer(1), f"({steps})")
    return sympy.Integer(1)


def _squares(plain: PlainExpressions, value: Any) -> Iterator[str]:
    """The steps by which it is known that the numerator is a sum of squares, or a difference with such a square."""
    known = {square: head**2 for head, (rule, _) in plain.rules.items() if (square := head**2 - rule).is_Symbol}
    above = sympy.expand(sympy.fraction(sympy.together(value))[0])
    greater = sympy.Add(*(term for term in sympy.Add.make_args(above) if term.is_nonnegative))
    less = greater - above
    if not less or not above.free_symbols:
        return
    if total := _sum_of_squares(above.subs(known)):
        yield from (f"try (assert (0 <= {text_of(each)}) by nonnegative)." for each in sympy.Add.make_args(total))
    elif less.is_Add and (total := _sum_of_squares(_on_circles(plain, sympy.expand(greater**2 - less**2)))):
        with suppress(Unsaid):
            equal = plain.total(greater**2 - less**2 - total)
            yield f"try (assert (0 <= {text_of(total)}) by nonnegative)."
            steps = f"apply (by_parts _ _ ({equal})); [vanish | identity]"
            yield f"try (assert ({text_of(greater)}^2 - {text_of(less)}^2 = {text_of(total)}) by ({steps}))."
            steps = "apply Rsqr_incr_0_var; [unfold Rsqr; lra | nonnegative]"
            yield f"try (assert ({text_of(less)} <= {text_of(greater)}) by ({steps}))."


def _on_circles(plain: PlainExpressions, e: Any) -> Any:
    """A polynomial with squares of roots as they are, and in cosines and sines of as equal degrees as can be."""
    for head, (rule, _) in plain.rules.items():
        if str(head).startswith("(cos "):
            (sine,) = rule.free_symbols - {head}
            e = sympy.expand(e + e.subs({head: 0, sine: 0}) * (head**2 + sine**2 - 1))
        else:
            e = e.subs(head**2, head**2 - rule)
    return e


def _sum_of_squares(e: Any) -> Any:
    """A polynomial as a sum of squares, each with what it is multiplied by; zero if it is not seen to be one."""
    symbols = sorted(e.free_symbols, key=str)
    places = [place for place, symbol in enumerate(symbols) if symbol.is_nonnegative]
    terms = {m: Fraction(int(c.p), int(c.q)) for m, c in sympy.Poly(e, *symbols).terms()} if symbols else {}
    total = []
    for number, odd, base in sum_of_squares(terms, places) or ():
        factor, *others = (sympy.Mul(*map(sympy.Pow, symbols, m)) for m in (odd, *base))
        of = sympy.Add(*map(sympy.Mul, others, (sympy.Rational(c) for c in base.values())))
        total.append(sympy.Mul(sympy.Rational(number) * factor, sympy.Pow(of, 2), evaluate=False))
    return sympy.Add(*total, evaluate=False)


def _symbol(plain: PlainExpressions, name: str, kind: str, square: Any) -> Any:
    """A name as a symbol, with the rule that says what its square is."""
    v = plain.symbol(name, "nonnegative")
    positive = f" ltac:({plain.rewritten}nonnegative)" if kind == "sqrt" else ""
    plain.rule(v, square, f"refine (eq_trans _ ({LEMMAS[kind]}_of _ _ of'{name}{positive})); {plain.rewritten}identity")
    return v


def _introduced(plain: PlainExpressions, word: str, kind: str, text: str) -> None:
    """A root of which the question does not speak."""
    said, name = plain.parsed(text), f"word'{len(plain.facts)}"
    function = "sqrt" if kind == "sqrt" else "Rabs"
    plain.facts.append(f"destruct (named ({function} {text_of(said)})) as [{name} of'{name}].")
    plain.facts.append(f"pose proof ({LEMMAS[kind]}_positive _ _ of'{name}) as positive'{name}.")
    plain.named[word] = _symbol(plain, name, kind, said if kind == "sqrt" else said**2)


def _known(plain: PlainExpressions, square: Any) -> Iterator[Any]:
    """Products and quotients of roots that the certificate knows, with the right square; the simplest first."""
    certificate, one = plain.certificate, sympy.Integer(1)
    even = _even_part(square)
    words = certificate.get("words", ())
    roots = certificate.get("roots", ()) if all(name in plain.named for name, *_ in words) else ()
    known = [(plain.parsed(text), reduce(mul, map(plain.parsed, factors), one)) for text, factors in roots]
    named = ((plain.parsed(text), kind, plain.named[name]) for name, kind, text in words if name in plain.named)
    known += [(of if kind == "sqrt" else of**2, value) for of, kind, value in named]
    ways = (0, 1, -1) if divisors_of(square / even**2) else (0, 1)
    for powers in sorted(product(ways, repeat=min(len(known), MOST_KNOWN)), key=lambda each: sum(map(abs, each))):
        made = reduce(mul, (of**n for (of, _), n in zip(known, powers, strict=False)), even**2)
        ratio = sympy.cancel(square / made)
        if ratio.is_Rational and sympy.sqrt(ratio).is_Rational:
            yield reduce(mul, (v**n for (_, v), n in zip(known, powers, strict=False)), even * sympy.sqrt(ratio))


def _other_roots(plain: PlainExpressions) -> list[Any]:
    """Roots that may have the same square if cosines and roots in it are taken for what they are."""
    return [head for head in plain.rules if head.is_nonnegative]


def _other_sides(plain: PlainExpressions, e: Any) -> Iterator[Any]:
    """What the question says that the root is."""
    for left, right in plain.statement.goals:
        for side, other in ((left, right), (right, left)):
            if side == e and not _roots_in(other) & {e}:
                with suppress(Unsaid):
                    yield plain(other)


def _even_part(square: Any) -> Any:
    """What is positive, and of which the square divides."""
    sides = zip(sympy.fraction(square), (1, -1), strict=True)
    factors = ((factor, way * (count // 2)) for side, way in sides for factor, count in sympy.factor_list(side)[1])
    return reduce(mul, (factor**half for factor, half in factors if factor.is_positive), sympy.Integer(1))


def _roots_of(plain: PlainExpressions, kind: str) -> list[Any]:
    """The roots, or absolute values, of the question that are made of what is known; the innermost first."""
    everything = _roots_in(sympy.Tuple(*plain.statement.asked.expressions))
    found = {e for e in everything if e.is_Pow == (kind == "sqrt") and all(map(plain.knows, _roots_in(e.args[0])))}
    return sorted(found, key=lambda e: (e.count_ops(), str(e)))


def _roots_in(e: Any) -> set[Any]:
    """All roots and absolute values in an expression."""
    powers = (sympy.sqrt(power.base) for power in e.atoms(sympy.Pow) if power.exp.is_Rational and power.exp.q == 2)
    return {*powers, *e.atoms(sympy.Abs)}


def _same(plain: PlainExpressions, said: Any, kind: str, text: str) -> bool:
    """Whether a root, or an absolute value, is that of the certificate, of which all has a name that is in it."""
    try:
        value = plain.parsed(text)
    except Unsaid:
        return False
    return not sympy.expand(said - value) or (kind == "abs" and not sympy.expand(said + value))
