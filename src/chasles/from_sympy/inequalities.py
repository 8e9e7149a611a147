"""Inequalities that are given, as equations with new symbols that may have any value, or any of a sign."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.checker.expressions.quantities import is_atom
from chasles.from_sympy.atoms import assumed_of
from chasles.from_sympy.bounded_symbols import COMPARED, STRICT, Said, with_angle, with_excess, with_ratio
from chasles.from_sympy.complex_symbols import expressions_in
from chasles.from_sympy.decimals import with_values
from chasles.from_sympy.divisors import lost_divisors
from chasles.from_sympy.monotone import is_whole, of_arguments
from chasles.from_sympy.opening import atoms_of, excerpt
from chasles.from_sympy.side_conditions import listed
from chasles.problems.variables import Untreatable

SIGNS = {sympy.Gt: "positive", sympy.Ge: "nonnegative", sympy.Lt: "negative", sympy.Le: "nonpositive"}


def without_inequalities(said: Said, by_excess: bool = False, by_sine: bool = False) -> Said:
    """What was said, with equations for what is given as `a > b`, and `a != b` as what does not vanish.

    A symbol or function that is compared with zero is read with that assumption. One between two multiples of pi is
    an angle whose tangent, sine or direction may have any value; one between a and b is (a + b d_1)/(1 + d_1), or, if
    it may be both, a + (b - a) (1 + d_1)^2/(2 + 2 d_1^2). Else a = b + d_1 for a positive d_1, and where that defines a
    symbol, everything is said by d_1; `by_excess`, of what is between others, too. An angle between others neither of
    which it is may be said `by_sine`, instead of by its tangent. Inequalities of functions of time hold at all times.

    Raises `Untreatable` for an inequality between functions of different variables, or with what is infinite.
    """
    items = [part for _, item in listed(said[2], "given") for part in _plain(item) if part is not sympy.true]
    items = [item for item in items if not any(_follows(item, other) for other in items)]
    apart = [item for item in items if isinstance(item, sympy.Ne)]
    if not apart and not any(isinstance(item, COMPARED) for item in items):
        return said
    stated = _joined([item for item in items if item not in apart])
    said = *said[:2], stated, [*(item for _, item in listed(said[3], "nonzero")), *apart]
    compared = [item for item in stated if isinstance(item, COMPARED) and not by_excess]
    for symbol in sorted({s for item in compared for s in item.free_symbols}, key=str):
        said = with_angle(said, symbol, by_sine)
    while found := next((values for item in said[2] if (values := signed(item, by_excess))), None):
        put = with_values(said, found)
        said = (*put[:3], [*put[3], *lost_divisors(said[:3], put[:3], found)])
    number = 0
    while compared := [item for item in said[2] if isinstance(item, COMPARED)]:
        number += 1
        symbols = sorted({s for item in compared for s in (item.lts, item.gts) if s.is_Symbol}, key=str)
        ways = (with_ratio(said, symbol, f"d_{number}") for symbol in symbols if not by_excess)
        said = next(filter(None, ways), ()) or with_excess(said, compared[0], f"d_{number}")
    return (*said[:2], [item for item in said[2] if item is not sympy.true], said[3])


def definitions(said: Said, asked: Said) -> list[str]:
    """How the verdict says the equations by which something is said otherwise than it was, if it is spoken of."""
    known, before, now = (
        {atom for e in expressions_in(part) for atom in atoms_of(e)}
        for part in (said, (*said[:2], said[3]), (*asked[:2], asked[3]))
    )
    equations = (e for e in expressions_in(asked[2]) if isinstance(e, sympy.Eq) and is_atom(e.lhs))
    new = ((e, set(atoms_of(e.rhs)) - known) for e in equations)
    return [f"{e.lhs} = {e.rhs}" for e, atoms in new if atoms & now or (atoms and e.lhs in before)]


def _plain(item: Any) -> Iterator[Any]:
    """What is said of a size, as two inequalities; of integers, what it comes to with the nearest possible bound."""
    if not isinstance(item, COMPARED):
        yield item
    elif item.has(sympy.oo, -sympy.oo, sympy.zoo, sympy.nan):
        raise Untreatable(f"{excerpt(item)} is not treated: it compares with what is infinite")
    elif isinstance(item.lts, sympy.Abs) and not item.lts.has(sympy.I):
        less = sympy.Lt if isinstance(item, STRICT) else sympy.Le
        yield from _plain(less(item.lts.args[0], item.gts))
        yield from _plain(less(-item.gts, item.lts.args[0]))
    elif (other := of_arguments(item)) is not item:
        yield from _plain(other)
    else:
        yield _rounded(item)


def _rounded(item: Any) -> Any:
    """What an inequality between integers and rational numbers says: 2 n > 1 that 2 n >= 2, and n < 5/2 that n <= 2."""
    constant, rest = sympy.expand(item.gts - item.lts).as_coeff_Add()
    content, terms = rest.primitive()
    if not constant.is_Rational or not rest.free_symbols or not is_whole(terms):
        return item
    least = -constant / content
    more = content * ((sympy.floor(least) + 1 if isinstance(item, STRICT) else sympy.ceiling(least)) - least)
    if not more:
        return item
    return item.lts <= item.gts - more if item.gts.is_number else item.gts >= item.lts + more


def _joined(items: list[Any]) -> list[Any]:
    """The same, with an equation for two inequalities that say of two sides that neither is greater."""
    for one, other in combinations([item for item in items if isinstance(item, sympy.Ge | sympy.Le)], 2):
        if sympy.expand(one.gts - one.lts + other.gts - other.lts) == 0:
            rest = [item for item in items if item not in (one, other)]
            return _joined([*rest, sympy.Eq(one.gts, one.lts, evaluate=False)])
    return items


def _follows(item: Any, other: Any) -> bool:
    """Whether an inequality says less than another, which compares the same with a number that is closer."""
    if not (isinstance(item, COMPARED) and isinstance(other, COMPARED)):
        return False
    more = isinstance(other, STRICT) and not isinstance(item, STRICT)
    gaps = (item.gts == other.gts, other.lts - item.lts), (item.lts == other.lts, item.gts - other.gts)
    return any(same and gap.is_number and (gap.is_positive or (gap.is_zero and more)) for same, gap in gaps)


def signed(item: Any, above: bool = False) -> dict[Any, Any]:
    """The symbol or function that is compared with zero, and maybe `above`, with that sign in its assumptions."""
    kind = SIGNS.get(type(item))
    if kind is None:
        return {}
    e, other = item.args
    if e.is_zero:
        e, other, kind = other, e, SIGNS[type(item.reversed)]
    below = above and kind in ("negative", "nonpositive")
    if below or not other.is_zero or not isinstance(e, sympy.Symbol | AppliedUndef):
        return {}
    assumed = {**(e.assumptions0 if e.is_Symbol else assumed_of(e)), kind: True}
    return {e: sympy.Symbol(e.name, **assumed) if e.is_Symbol else sympy.Function(e.name, **assumed)(*e.args)}
