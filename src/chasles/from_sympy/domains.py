"""Where what is compared or differentiated is defined: parts that cancel when it is evaluated."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import combinations
from typing import Any

import sympy
from sympy.concrete.expr_with_limits import ExprWithLimits
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational
from sympy.matrices import MatrixBase

from chasles.checker.expressions.defined_functions import BY_OTHERS, is_entire
from chasles.checker.expressions.quantities import is_atom
from chasles.from_sympy.opening import different_parts

EVERYWHERE = (
    sympy.sin, sympy.cos, sympy.exp, sympy.sinh, sympy.cosh, sympy.tanh, sympy.atan, sympy.asinh, sympy.erf, sympy.Abs,
    sympy.sign, sympy.Max, sympy.Min, sympy.floor, sympy.ceiling, sympy.frac, sympy.Heaviside, sympy.re, sympy.im,
    sympy.conjugate, sympy.Piecewise, AppliedUndef,
)  # fmt: skip
"""Functions that have a value wherever their arguments have one."""
BINDING = (ExprWithLimits, sympy.Derivative, sympy.Subs)
ABOVE: Mapping[type, Callable[[Any, Any], tuple[Any, ...]]] = {
    sympy.binomial: lambda n, k: () if k.is_Integer else (n + 1,), sympy.rf: lambda x, n: (x + n,),
    sympy.ff: lambda x, n: (x + 1,), sympy.beta: lambda x, y: (x, y),
}  # fmt: skip
"""Of what gamma functions are divided by others in the functions that are said by them."""


def also_defined(side: Any, lost: Iterable[Any]) -> Any:
    """The same, but that it has a value only where others have: those that are lost of log(x) < log(x) + 1.

    Its first entry is multiplied by one, or zero is said: by a determinant, whose entries have to be defined.
    """
    lost = [*dict.fromkeys(lost)]
    if not lost or not isinstance(side, int | sympy.Expr | MatrixBase):
        return side
    first, *rest = side if isinstance(side, MatrixBase) else [side]
    rows = [[int(first != 0), *lost], *([int(i == j) for j in range(1 + len(lost))] for i in range(1, 1 + len(lost)))]
    first = (first or 1) * sympy.Determinant(sympy.ImmutableMatrix(rows))
    return type(side)(*side.shape, [first, *rest]) if isinstance(side, MatrixBase) else first


def lost_in(said: Iterable[Any]) -> Iterator[Any]:
    """What has to be defined in relations and derivatives; of relations that stand by themselves sides are read.

    Where gamma functions cancel, as in binomial(x, x), those of a quotient that may have a pole.
    """
    for e in said:
        yield from _poles(e)
        stands = {e, *(e.args if isinstance(e, sympy.And) else ())}
        for part in sorted(e.atoms(Relational, sympy.Derivative), key=str):
            if isinstance(part, sympy.Derivative):
                yield from _differentiated(part)
            elif part not in stands:
                yield from (each for side in part.args for each in _partial(side))
            elif not isinstance(part, sympy.Equality):
                yield from cancelled(part, part)


def cancelled(relation: Any, plainer: Any) -> list[Any]:
    """What may not be defined in one side of a relation, and is not in the difference of those for which it stands."""
    if not all(isinstance(side, sympy.Expr) and not side.is_Matrix for side in relation.args):
        return []
    parts = {part: None for side in relation.args for part in _partial(side)}
    if not parts:
        return []
    difference = plainer.lhs - plainer.rhs
    left = set(_partial(difference))
    spoken = {symbol for part in _partial(sympy.expand(difference)) for symbol in part.free_symbols}
    return [part for part in parts if part not in left or part.free_symbols - spoken]


def _partial(e: Any) -> Iterator[Any]:
    """The parts of an expression that may have no value where their own parts have."""
    for part in different_parts(e, lambda part: isinstance(part, BINDING)):
        power = part.is_Pow and not (part.exp.is_integer and part.exp.is_nonnegative) and part.base is not sympy.E
        factorial = isinstance(part, sympy.factorial) and part.args[0].is_nonnegative
        function = isinstance(part, sympy.Function) and not isinstance(part, EVERYWHERE) and not factorial
        if part.free_symbols and (power or function or (isinstance(part, BINDING) and not is_atom(part))):
            yield part


def _poles(e: Any) -> Iterator[Any]:
    """The gamma functions above the line of those that stand for others, where the whole comes to something without."""
    calls = sorted(e.atoms(*ABOVE), key=str)
    if calls and not e.has(*BINDING):
        said = e.replace(lambda part: type(part) in ABOVE, lambda call: BY_OTHERS[type(call)](call))
        left = said.replace(is_entire, lambda part: sympy.S.One).atoms(sympy.gamma)
        poles = (sympy.gamma(argument) for call in calls for argument in ABOVE[type(call)](*call.args))
        yield from (pole for pole in poles if pole not in left and pole.free_symbols and not pole.args[0].is_positive)


def _differentiated(rate: Any) -> Iterator[Any]:
    """What has to be defined for something to have a derivative, and is not in it."""
    if is_atom(rate):
        return
    inside = [*different_parts(rate.expr, lambda part: isinstance(part, BINDING))]
    yield from (1 / e for part in inside if part.has(*rate.variables) for e in _kinks(part, rate.derivative_count))
    if wanted := [*_partial(rate.expr)]:
        left = {*_partial(rate.doit())}
        yield from (part for part in wanted if part not in left)


def _kinks(e: Any, times: int) -> Iterator[Any]:
    """What does not vanish where a function of its arguments, or a root, has so many derivatives."""
    if isinstance(e, sympy.Abs | sympy.sign | sympy.Heaviside):
        yield e.args[0]
    elif isinstance(e, sympy.Max | sympy.Min):
        yield from (one - other for one, other in combinations(e.args, 2))
    elif e.is_Pow and e.exp.is_Rational and not e.exp.is_Integer and 0 < e.exp < times:
        yield e.base
    elif isinstance(e, sympy.Piecewise):
        yield from (part.lhs - part.rhs for part in sorted(e.atoms(Relational), key=str))
