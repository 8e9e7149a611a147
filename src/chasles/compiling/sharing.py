"""What do sums share with sums, and products with products? Terms and factors that come together more than once."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import sympy
from sympy.simplify.cse_main import Unevaluated, match_common_args


def common(expressions: Iterable[sympy.Basic]) -> dict[sympy.Basic, Any]:
    """Sums and products spelled as such of others, so that what they share is one of them; opposite ones are one.

    SymPy's search for common terms and factors is taken, but not that for signs, which orders the terms of all sums: of
    a sum and its opposite that with fewer negative terms is taken, or else the first.
    """
    spelled: dict[sympy.Basic, Any] = {}
    sums: dict[frozenset[tuple[Any, Any]], sympy.Basic] = {}
    products: dict[sympy.Basic, None] = {}
    for part in parts_before(expressions):
        taken = part
        if isinstance(part, sympy.Add):
            terms = [term.as_coeff_Mul() for term in part.args]
            opposite = frozenset((-number, of) for number, of in terms)
            if opposite in sums or 2 * sum(bool(number.is_negative) for number, _ in terms) > len(terms):
                taken = sums.setdefault(opposite, sympy.Add(*(-term for term in part.args)))
            else:
                sums[frozenset(terms)] = part
        elif isinstance(part, sympy.Mul):
            taken = -part if part.args[0].is_Number and part.args[0].is_negative else part
            if isinstance(taken, sympy.Mul):
                products[taken] = None
        if taken is not part:
            spelled[part] = Unevaluated(sympy.Mul, (sympy.S.NegativeOne, taken))
    match_common_args(sympy.Add, list(sums.values()), spelled)
    match_common_args(sympy.Mul, list(products), spelled)
    return spelled


def repeated(entries: Sequence[sympy.Basic], spelled: Mapping[sympy.Basic, Any]) -> Iterator[sympy.Basic]:
    """The parts that come more than once where each part is written once."""
    seen: set[sympy.Basic] = set()
    waiting = list(entries)
    while waiting:
        part = waiting.pop()
        if part in seen:
            yield part
        else:
            seen.add(part)
            waiting += [inner for inner in spelled.get(part, part).args if not isinstance(inner, int)]


def parts_before(expressions: Iterable[sympy.Basic]) -> Iterator[sympy.Basic]:
    """All parts of the expressions, each once, those of a part before it."""
    seen: set[sympy.Basic] = set()
    waiting = list(expressions)[::-1]
    while waiting:
        part = waiting[-1]
        missing = [inner for inner in reversed(part.args) if inner not in seen and inner.args]
        if missing and part not in seen:
            waiting += missing
            continue
        waiting.pop()
        if part not in seen:
            seen.add(part)
            yield part
