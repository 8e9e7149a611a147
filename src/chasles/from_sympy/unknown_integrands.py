"""Integrals and sums of functions that are not known, by antiderivatives and antidifferences, which are not either.

Integrals are split by linearity, substitution and integration by parts; what is left of an integrand has an
antiderivative of its own. Whatever holds for all of these holds; what fails for some need not, since squares, say, have
integrals that are not negative: see `is_tied`.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.checker.expressions.readings import is_integral
from chasles.checker.expressions.unevaluated import require_running, summed
from chasles.checker.expressions.visible import is_running
from chasles.checker.sparse import Rejected
from chasles.from_sympy.antiderivatives import is_continuous
from chasles.from_sympy.atoms import assumed_of
from chasles.from_sympy.complex_symbols import expressions_in
from chasles.from_sympy.decimals import with_values
from chasles.from_sympy.side_conditions import listed

INTEGRAL, COMPOSED, SUM = "Integral(", "Integral((", "Sum("
"""How the names of antiderivatives begin: of a function itself, which may have any values, of others, and of sums."""
MOST_TERMS, MOST_STEPS, MOST_SHIFTS = 40, 8, 20
"""So many terms has an integrand, so often one is integrated by parts, and so many terms are told of a sum."""


def without_unknown_integrands(said: tuple[Any, ...]) -> tuple[Any, ...]:
    """What is said, with antiderivatives at both ends for integrals of functions that are not known, and so for sums.

    What substitution divides by does not vanish.
    """
    spoken = [
        e for e in expressions_in(said) if e.has(AppliedUndef) and e.has(sympy.Integral, sympy.Sum, sympy.Product)
    ]
    if not spoken:
        return said
    rates = {e for whole in spoken for e in whole.atoms(sympy.Derivative) if e.has(sympy.Integral)}
    if rates:
        return without_unknown_integrands(with_values(said, {e: e.expr.diff(*e.variables) for e in rates}))
    lost: dict[Any, None] = {}
    parts = {e for whole in spoken for e in whole.atoms(sympy.Integral, sympy.Sum, sympy.Product)}
    values = {e: value for e in parts if (value := _value(e, lost)) is not None}
    lhs, rhs, given, nonzero = with_values(said, values)
    return lhs, rhs, given, [*(item for _, item in listed(nonzero, "nonzero")), *lost] if lost else nonzero


def is_tied(functions: Iterable[Any], given: Any) -> bool:
    """Whether an antiderivative may not have any values: it is of a composed integrand, or something is given."""
    names = [*map(str, functions)]
    composed = any(name.startswith((COMPOSED, SUM)) for name in names)
    known = any(e.has(AppliedUndef) for e in expressions_in(given))
    return composed or (known and any(name.startswith(INTEGRAL) for name in names))


def _value(e: Any, lost: dict[Any, None]) -> Any:
    """The value of an integral or sum, as far as functions that are not known are in it; None where it is left."""
    if len(e.limits) != 1 or len(e.limits[0]) != 3 or not e.function.has(AppliedUndef):
        return None
    ((x, low, high),) = e.limits
    if e.function.has(sympy.Integral, sympy.Sum, sympy.Product, sympy.I) or any(end.is_infinite for end in (low, high)):
        return None
    if not isinstance(e, sympy.Integral):
        return _sum(e, x, low, high)
    terms = sympy.Add.make_args(sympy.expand(e.function.doit()))
    unknown = [term for term in terms if any(call.has(x) for call in term.atoms(AppliedUndef))]
    if not unknown or len(terms) > MOST_TERMS or not is_running(x, (low, high), "real"):
        return None
    calls = {call for term in unknown for call in term.atoms(AppliedUndef, sympy.Derivative, sympy.Subs)}
    smooth = [term.xreplace({call: sympy.Dummy() for call in calls}) for term in unknown]
    smooth += [argument for call in calls if isinstance(call, AppliedUndef) for argument in call.args]
    if not all(is_continuous(each, x, (low, high)) for each in smooth):
        return None
    before = sympy.Add(*(_before(term, x, lost) for term in unknown))
    rest = sympy.Add(*(term for term in terms if term not in unknown))
    known = sympy.Integral(rest, (x, low, high)) if rest != 0 else rest
    return before.subs(x, high) - before.subs(x, low) + known


def _before(term: Any, x: Any, lost: dict[Any, None]) -> Any:
    """What has a term as its derivative: said by what is substituted, if that is another variable."""
    constant, rest = term.as_independent(x, as_Add=False)
    inside = {a for call in rest.atoms(AppliedUndef) for a in call.args if a.has(x)}
    inner = next(iter(inside)) if len(inside) == 1 else x
    s, slope = sympy.Dummy("s", real=True), inner.diff(x)
    if inner == x or rest.has(sympy.Derivative, sympy.Subs):
        return constant * _by_parts(rest.xreplace({x: s}), s, MOST_STEPS).xreplace({s: x})
    plain = sympy.cancel((rest / slope).xreplace({call: _at(call, inner, s) for call in rest.atoms(AppliedUndef)}))
    if not slope.has(x):
        plain = sympy.expand(plain.xreplace({x: (s - inner.xreplace({x: sympy.S.Zero})) / slope}))
        lost |= {} if slope.is_number else {slope: None}
    if plain.has(x):
        return constant * _antiderivative(rest.xreplace({x: s}), s).xreplace({s: x})
    return constant * sum(_before(part, s, lost) for part in sympy.Add.make_args(plain)).xreplace({s: inner})


def _at(call: Any, inner: Any, s: Any) -> Any:
    return call.func(*(s if argument == inner else argument for argument in call.args))


def _by_parts(e: Any, s: Any, steps: int) -> Any:
    """What has a product as its derivative: the highest rate in it is integrated where that leaves a simpler one."""
    (constant, rest), orders = e.as_independent(s, as_Add=False), _orders(e, s)
    rates = sorted((-order, str(call), call) for call, order in orders.items())
    if rates and rates[0][0] < 0 and steps:
        order, _, call = -rates[0][0], *rates[0][1:]
        lower = sympy.Derivative(call, (s, order - 1)) if order > 1 else call
        left = sympy.cancel(rest / sympy.Derivative(call, (s, order)))
        power = left.as_independent(lower, as_Add=False)[1].as_base_exp()
        others = max(((n, str(f)) for f, n in _orders(left, s).items()), default=(-1, ""))
        if power[0] == lower and not (left / lower ** power[1]).has(s) and power[1].is_positive:
            return constant * left * lower / (power[1] + 1)
        if others[0] + 1 < order or (others[0] + 1 == order and others[1] > str(call) and left.diff(s) != 0):
            inner = sympy.Add.make_args(sympy.expand(left.diff(s) * lower))
            return constant * (left * lower - sympy.Add(*(_by_parts(part, s, steps - 1) for part in inner)))
    return constant * _antiderivative(rest, s)


def _orders(e: Any, s: Any) -> dict[Any, int]:
    """The highest derivative of each function of a variable."""
    found = {call: 0 for call in e.atoms(AppliedUndef) if call.has(s)}
    for rate in e.atoms(sympy.Derivative):
        found[rate.expr] = max(found.get(rate.expr, 0), rate.variables.count(s))
    return found


def _antiderivative(e: Any, s: Any, kind: str = INTEGRAL) -> Any:
    """A function that is called after what is integrated or added, of the variable and of what else is in that."""
    if e == 0:
        return e
    others, letter = sorted(e.free_symbols - {s}, key=str), "s"
    while letter in map(str, others):
        letter += "_"
    calls = sorted(e.atoms(AppliedUndef), key=str)
    assumed = [f"{call.func}: {', '.join(known)}" for call in calls if (known := assumed_of(call))]
    named = "; ".join((str(e.xreplace({s: sympy.Symbol(letter)})), *assumed))
    named = named if kind == SUM or (calls == [e] and e.args == (s,) and not assumed) else f"({named})"
    return sympy.Function(f"{kind}{named}, {letter})")(s, *others)


def _sum(e: Any, x: Any, low: Any, high: Any) -> Any:
    """A sum or product term by term if there are a few; else a sum by what grows by its terms."""
    try:
        require_running(e)
        if (high - low).is_Integer:
            return summed(e)
    except Rejected:
        return None
    terms = sympy.Add.make_args(sympy.expand(e.function))
    if isinstance(e, sympy.Product) or not is_integral(high - low) or len(terms) > MOST_TERMS:
        return None
    total, rest = sympy.S.Zero, sympy.S.Zero
    for term in terms:
        constant, each = term.as_independent(x, as_Add=False)
        shifts = {a - x for call in each.atoms(AppliedUndef) for a in call.args if a.has(x)}
        shift = min(shifts, key=str) if shifts and all(each.is_Integer for each in shifts) else None
        if shift is None:
            rest += term
            continue
        plain = each.xreplace({x: x - shift})
        total += constant * (_up_to(plain, x, high + 1 + shift) - _up_to(plain, x, low + shift))
    return None if total == 0 else total + (sympy.Sum(rest, (x, low, high)) if rest != 0 else rest)


def _up_to(term: Any, x: Any, end: Any) -> Any:
    """What grows by a term where its index grows by one: where that is a number more than elsewhere, from there."""
    before, (number, start) = _antiderivative(term, x, SUM), sympy.expand(end).as_coeff_Add()
    if not number.is_Integer or abs(number) > MOST_SHIFTS:
        return before.xreplace({x: end})
    terms = [term.xreplace({x: start + k}) for k in range(int(min(number, 0)), int(max(number, 0)))]
    return before.xreplace({x: start}) + sympy.Add(*terms) * (1 if number > 0 else -1)
