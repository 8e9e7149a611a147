"""Functions that others define, and of which no more is known than their recurrence, their sign, and values at points.

The remainder and the fractional part are said by the greatest integer, as in Graham, Knuth and Patashnik, Concrete
Mathematics, 3.1 and 3.4, factorials by the gamma function, as in Abramowitz and Stegun, Handbook of Mathematical
Functions, 6.1.5 and 6.1.15.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import factorial, prod
from typing import Any

import sympy

from chasles.checker.expressions.readings import Floor, is_integral
from chasles.checker.expressions.visible import signs_of
from chasles.checker.sparse import Rejected

LARGEST = 200
"""So many factors has a product that a recurrence gives at most."""
BOUNDED = {sympy.Si: 2, **dict.fromkeys((sympy.erf, sympy.fresnels, sympy.fresnelc, sympy.airyai, sympy.besselj), 1)}
"""Real functions of which no more is known than that they are no larger; of Bessel's, those of integral order."""
VALUED = (Floor, sympy.Mod, sympy.gamma, *BOUNDED)
"""What is a quantity by itself once all others are said by these."""


def _apart(one: Any, other: Any, value: Any, same: Any) -> Any:
    """One value where two differ, and another where they are the same."""
    return sympy.Piecewise((value, sympy.Ne(one, other, evaluate=False)), (same, True), evaluate=False)


def _binomial(e: Any) -> Any:
    n, k = e.args
    if k.is_Integer and 0 <= k <= LARGEST:
        return sympy.Mul(*(n - j for j in range(int(k)))) / factorial(int(k))
    return sympy.gamma(n + 1) / (sympy.gamma(k + 1) * sympy.gamma(n - k + 1))


def _binet(e: Any) -> Any:
    """By powers of the roots of x^2 = x + 1, if it is one of an integer."""
    n, root, sign = e.args[0], (1 + sympy.sqrt(5)) / 2, 1 if isinstance(e, sympy.lucas) else -1
    whole = len(e.args) == 1 and is_integral(n)
    return (root**n + sign * (-1) ** n * root**-n) / sympy.sqrt(3 - 2 * sign) if whole else e


def remainder(e: Any) -> Any:
    """By the greatest integer."""
    return e.args[0] - e.args[1] * Floor(e.args[0] / e.args[1])


def _principal(e: Any) -> Any:
    """The principal value where a number is raised to another that is not real otherwise, by its size and angle."""
    base = e.base
    if base.is_Pow and base.exp.is_even and base.exp.is_Integer and e.exp.is_Rational and e.exp.q == 2:
        return e if base.has(sympy.I) or base.is_number else sympy.Abs(base.base) ** (base.exp * e.exp)
    if not e.is_number or not (base.is_negative or base.is_real is False):
        return e
    exponent = e.exp.doit()
    if exponent.is_Integer:
        return base**exponent
    size, angle = sympy.Abs(base), sympy.arg(base)
    if exponent.is_real:
        return size**exponent * (sympy.cos(exponent * angle) + sympy.I * sympy.sin(exponent * angle))
    return sympy.exp(sympy.expand(exponent * (sympy.log(size) + sympy.I * angle)))


BY_OTHERS = {
    sympy.floor: lambda e: Floor(e.args[0]), sympy.ceiling: lambda e: -Floor(-e.args[0]),
    sympy.frac: lambda e: e.args[0] - Floor(e.args[0]), sympy.erfc: lambda e: 1 - sympy.erf(e.args[0]),
    # Else what divides by zero might cancel.
    sympy.Mod: lambda e: remainder(e) if 0 not in signs_of(e.args[1]) else e,
    sympy.factorial: lambda e: sympy.gamma(e.args[0] + 1), sympy.binomial: _binomial,
    sympy.rf: lambda e: sympy.gamma(e.args[0] + e.args[1]) / sympy.gamma(e.args[0]),
    sympy.ff: lambda e: sympy.gamma(e.args[0] + 1) / sympy.gamma(e.args[0] - e.args[1] + 1),
    sympy.beta: lambda e: sympy.gamma(e.args[0]) * sympy.gamma(e.args[1]) / sympy.gamma(e.args[0] + e.args[1]),
    **dict.fromkeys((sympy.fibonacci, sympy.lucas), _binet),
    sympy.sinc: lambda e: _apart(e.args[0], 0, sympy.sin(e.args[0]) / e.args[0], 1),
    sympy.KroneckerDelta: lambda e: _apart(e.args[0], e.args[1], 0, 1) if len(e.args) == 2 else e,
    **dict.fromkeys(map(type, (sympy.GoldenRatio, sympy.TribonacciConstant)), lambda e: e.expand(func=True)),
    sympy.Pow: _principal,
}  # fmt: skip


class Recurrences:
    """What the gamma functions of some expressions are multiples of, among those that differ by integers: the lowest.

    It is the highest where one is divided by: what is one over them is then its multiple without being divided.
    """

    def __init__(self, expressions: Iterable[Any]) -> None:
        self._ends: dict[Any, int] = {}
        powers = {power for e in expressions for power in e.atoms(sympy.Pow, sympy.gamma)}
        below = {_shifted(power.base)[0] for power in powers if is_entire(power)}
        for call in powers:
            if isinstance(call, sympy.gamma):
                rest, shift = _shifted(call)
                self._ends[rest] = (max if rest in below else min)(shift, self._ends.get(rest, shift))

    def __call__(self, call: Any) -> tuple[Any, Any, int]:
        """A factor, and a quantity that has a value everywhere, with the exponent with which it is multiplied by that.

        A gamma function is one over its reciprocal, which has none of the poles.
        """
        if not isinstance(call, sympy.gamma):
            quantity = call.func(*map(sympy.expand, call.args))
            return sympy.S.One, remainder(call) if isinstance(call, sympy.Mod) else quantity, 1
        rest, shift = _shifted(call)
        end, known = self._ends[rest], sympy.expand(rest)
        if abs(shift - end) > LARGEST:
            raise Rejected(f"{call} is too many factors away from another one")
        between = prod((known + j for j in range(min(shift, end), max(shift, end))), start=sympy.S.One)
        return between if shift > end else 1 / between, 1 / sympy.gamma(known + end), -1


def is_entire(e: Any) -> bool:
    """Whether an expression is a power of one over a gamma function, which has no pole."""
    return bool(e.is_Pow and isinstance(e.base, sympy.gamma) and e.exp.is_Integer and e.exp < 0)


def _shifted(call: Any) -> tuple[Any, int]:
    """The argument of a gamma function without an integer, and this."""
    constant, rest = sympy.expand(call.args[0]).as_coeff_Add()
    shift = int(sympy.floor(constant)) if constant.is_Rational else 0
    return rest + constant - shift, shift


def defined_by(e: Any) -> tuple[Any, ...]:
    """What has to be defined for a quantity that is the value of a function to be; nothing for any other."""
    call = 1 / e if e.is_Pow else e
    return call.args if isinstance(call, VALUED) else ()


def gamma_at(x: Any) -> Any:
    """The value at an integer, or between two; raises `Rejected` where there is none, or none is known."""
    if not x.is_Rational or x.q > 2 or abs(x) > LARGEST or (x.q == 1 and x <= 0):
        raise Rejected(f"gamma({x}) has no value that is known to the checker")
    return sympy.gamma(x)
