"""Which SymPy expressions are real quantities by themselves, the variables of a question, and values of them.

What SymPy assumes of a quantity is its sign and what kind of number it is.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational
from sympy.matrices.expressions.matexpr import MatrixElement

from chasles.checker.expressions.algebra import constant
from chasles.checker.expressions.reals import Reals
from chasles.checker.sparse import Polynomial, Rejected

COMPARING = (sympy.Piecewise, Relational, sympy.sign, sympy.Heaviside, sympy.atan2, sympy.arg)
SIGNS = {
    "positive": (1,), "negative": (-1,), "nonnegative": (0, 1), "nonpositive": (-1, 0),
    "zero": (0,), "nonzero": (-1, 1),
}  # fmt: skip
NUMBERS = (
    "integer", "noninteger", "even", "odd", "prime", "composite", "rational", "irrational", "algebraic",
    "transcendental",
)  # fmt: skip
"""What SymPy may assume of a quantity: its sign, and what kind of number it is."""


def is_atom(e: Any) -> bool:
    """Whether an expression is a real quantity by itself."""
    if isinstance(e, sympy.Derivative):
        return isinstance(e.expr, AppliedUndef)
    if isinstance(e, MatrixElement):
        return isinstance(e.parent, sympy.MatrixSymbol)
    return isinstance(e, sympy.Symbol | AppliedUndef)


def atoms_of(e: Any) -> Iterator[Any]:
    """The real quantities that occur in an expression, each once, however often its parts are repeated."""
    met = set()
    waiting = [e]
    while waiting:
        part = waiting.pop()
        if part in met:
            continue
        met.add(part)
        if is_atom(part):
            yield part
        elif isinstance(part, sympy.MatrixSymbol):
            yield from (part[i, j] for i in range(part.rows) for j in range(part.cols))
        else:
            waiting += reversed(part.args)


def require_independent(atoms: Iterable[Any]) -> None:
    """Raise `Rejected` where a function occurs with two sets of arguments, which may be the same at some point."""
    arguments: dict[Any, Any] = {}
    for e in atoms:
        function = e.expr if isinstance(e, sympy.Derivative) else e
        if isinstance(function, AppliedUndef) and arguments.setdefault(function.func, function.args) != function.args:
            raise Rejected(f"{function} occurs with other arguments too")


def is_unreal(e: Any) -> bool:
    """Whether SymPy is told that a quantity need not be a real number, or is none."""
    return e.is_commutative is False or (not e.is_real and any((e.is_real is False, e.is_complex, e.is_antihermitian)))


def require_real(e: Any) -> None:
    """Raise `Rejected` for what is no real number, or no function of different symbols."""
    function = e.expr if isinstance(e, sympy.Derivative) else e
    if is_unreal(e):
        raise Rejected(f"{e} is not real")
    if isinstance(function, AppliedUndef):
        arguments = function.args
        if len(set(arguments)) < len(arguments) or not all(isinstance(a, sympy.Symbol) for a in arguments):
            raise Rejected(f"the arguments of {function} are not different symbols")


def with_values(e: Any, put: Mapping[Any, Any]) -> Any:
    """The expression with values put in, its cases as they stand: SymPy may simplify conditions without end."""
    if e in put or isinstance(e, sympy.Product) or not e.has(*COMPARING, sympy.Product):
        return e.xreplace(put)
    return rebuilt(e, [with_values(part, put) for part in e.args])


def rebuilt(e: Any, parts: Sequence[Any]) -> Any:
    """The same of other parts, its signs as they stand: SymPy (1.14) errs on those of atan(0) and of empty products."""
    compared = isinstance(e, COMPARING) and any(part.free_symbols for part in parts)
    compared = compared or (isinstance(e, sympy.Function | sympy.Pow) and any(p.has(sympy.Product) for p in parts))
    return e.func(*parts, evaluate=False) if compared or isinstance(e, sympy.Piecewise) else e.func(*parts)


def is_so(point: Reals, value: Polynomial, assumption: str) -> bool | None:
    """Whether a number is what SymPy assumes; None where that is not known."""
    if assumption in SIGNS:
        return point.sign(value) in SIGNS[assumption]
    numerator, below = point.cleared(value)
    known = constant(numerator)
    if known is not None and not below:
        return bool(getattr(sympy.Rational(known.numerator, known.denominator), f"is_{assumption}"))
    if point.sign(value) < 0 and assumption in ("prime", "composite"):
        return False
    if len(numerator.places) > 1 or below:
        return None
    # A multiple of pi, or of another arctangent of a rational number, is transcendental (Lindemann).
    transcendental = not numerator.places & point.squares.keys()
    if transcendental or len(numerator.terms) == 1:
        return assumption in ("irrational", "noninteger", "transcendental" if transcendental else "algebraic")
    return {"algebraic": True, "transcendental": False}.get(assumption)
