"""What does a SymPy expression come to? As power series in time, by walking its tree: SymPy evaluates nothing here."""

from __future__ import annotations

from collections.abc import Mapping
from functools import reduce
from typing import Any

import numpy as np
import sympy as sp
from sympy.core.function import AppliedUndef

from . import series
from .series import NOTHING, Series, Undefined, constant, mp, mpc, mpf

__all__ = ["Values", "atoms_of", "orders_of"]

ONE = sp.Integer(1)


class Values:
    """Values of expressions where atoms, symbols and functions of time, have the given series."""

    def __init__(self, atoms: Mapping[Any, Series], like: Any) -> None:
        self.atoms = atoms
        self.like = like

    def __call__(self, e: Any, n: int = 0) -> Series:
        """The coefficients 0 to n; raises `Undefined` where there is no value."""
        match e:
            case sp.Rational():
                return self._number(mpf(int(e.p)) / int(e.q), n)
            case sp.Float():
                return self._number(mpf(str(e)), n)
            case sp.Symbol() | AppliedUndef():
                return self._atom(e, n)
            case sp.Derivative():
                return self._derivative(e, n)
            case sp.Add():
                return reduce(series.plus, [self(a, n) for a in e.args])
            case sp.Mul():
                return reduce(series.times, [self(a, n) for a in e.args])
            case sp.Pow():
                return self._power(e, n)
            case sp.Piecewise():
                return self._piecewise(e, n)
            case sp.Min() | sp.Max():
                return reduce(lambda a, b: self._extreme(e, a, b), [self(a, n) for a in e.args])
            case sp.atan2():
                return self._atan2(*(self(a, n) for a in e.args))
            case sp.Function():
                return self._function(e.func.__name__, self(e.args[0], n))
        if e.is_number and e in (sp.pi, sp.E):
            return self._number(+mp.pi if e is sp.pi else +mp.e, n)
        if e is sp.I:
            return constant(mpc(0, 1), n)
        raise NotImplementedError(f"the oracle cannot evaluate {e}")

    def _number(self, value: Any, n: int) -> Series:
        return constant(self.like * 0 + float(value) if isinstance(self.like, np.ndarray) else value, n)

    def _atom(self, e: Any, n: int) -> Series:
        known = self.atoms[e]
        if isinstance(e, sp.Symbol):
            return [known[0], *[known[0] * 0] * n] if len(known) == 1 else known[: n + 1]
        return known[: n + 1]

    def _derivative(self, e: Any, n: int) -> Series:
        found = self(e.expr, n + e.derivative_count)
        for _ in range(e.derivative_count):
            found = series.rate(found)
        return found

    def _power(self, e: Any, n: int) -> Series:
        base, exponent = e.args
        if base is sp.E:
            return series.exponential(self(exponent, n))
        if isinstance(exponent, sp.Rational):
            return series.power(self(base, n), int(exponent.p), int(exponent.q))
        below, above = self(base, n), self(exponent, n)
        whole = int(mp.nint(above[0])) if n == 0 and not _array(above[0]) and abs(mp.im(above[0])) < NOTHING else None
        if whole is not None and abs(above[0] - whole) < NOTHING:
            return series.power(below, whole)
        return series.exponential(series.times(above, series.logarithm(below)))

    def _function(self, name: str, one: Series) -> Series:
        match name:
            case "sin":
                return series.sine(one)
            case "cos":
                return series.cosine(one)
            case "tan":
                return series.over(series.sine(one), series.cosine(one))
            case "cot":
                return series.over(series.cosine(one), series.sine(one))
            case "sec":
                return series.power(series.cosine(one), -1)
            case "csc":
                return series.power(series.sine(one), -1)
            case "Abs":
                return series.absolute(one)
            case "sign":
                return series.sign(one)
            case "exp":
                return series.exponential(one)
            case "log":
                return series.logarithm(one)
            case "sinh" | "cosh" | "tanh" | "coth":
                return self._hyperbolic(name, one)
            case "asin" | "acos" | "atan":
                return series.arc(name, one)
            case "re" | "im" | "conjugate":
                if _array(one[0]):
                    return [a * (name != "im") for a in one]
                return [getattr(mp, {"conjugate": "conj"}.get(name, name))(a) for a in one]
        raise NotImplementedError(f"the oracle has no {name}")

    def _hyperbolic(self, name: str, one: Series) -> Series:
        up, down = series.exponential(one), series.exponential(series.negative(one))
        above, below = series.minus(up, down), series.plus(up, down)
        return {
            "sinh": lambda: series.divided(above, 2),
            "cosh": lambda: series.divided(below, 2),
            "tanh": lambda: series.over(above, below),
            "coth": lambda: series.over(below, above),
        }[name]()

    def _extreme(self, e: Any, one: Series, other: Series) -> Series:
        smaller = one[0] < other[0]
        return series.chosen(
            one, other, smaller if isinstance(e, sp.Min) else ~smaller if _array(smaller) else not smaller
        )

    def _atan2(self, y: Series, x: Series) -> Series:
        if _array(x[0]):
            return [np.arctan2(y[0], x[0])]
        if len(x) > 1 or (abs(x[0]) < NOTHING and abs(y[0]) < NOTHING):
            raise Undefined("the angle of nothing, or its rate")
        return [mp.atan2(y[0], x[0])]

    def _piecewise(self, e: Any, n: int) -> Series:
        for value, condition in e.args:
            if condition == sp.true or self.truth(condition):
                return self(value, n)
        raise Undefined("no piece applies")

    def truth(self, relation: Any) -> bool:
        """Whether a relation holds; a difference that is rounded away is none."""
        if relation in (sp.true, sp.false):
            return bool(relation)
        if isinstance(relation, sp.And | sp.Or):
            return (all if isinstance(relation, sp.And) else any)(self.truth(a) for a in relation.args)
        if isinstance(relation, sp.Not):
            return not self.truth(relation.args[0])
        difference = self(relation.lhs - relation.rhs)[0]
        if isinstance(difference, np.ndarray):
            difference = float(difference.flat[0])
        difference = mp.re(difference)
        rounded = abs(difference) < NOTHING
        match relation:
            case sp.Eq():
                return bool(rounded)
            case sp.Ne():
                return not rounded
            case sp.Ge():
                return bool(rounded or difference > 0)
            case sp.Le():
                return bool(rounded or difference < 0)
            case sp.Gt():
                return bool(not rounded and difference > 0)
            case sp.Lt():
                return bool(not rounded and difference < 0)
        raise NotImplementedError(f"the oracle cannot judge {relation}")


def _array(value: Any) -> bool:
    return isinstance(value, np.ndarray)


def atoms_of(*expressions: Any) -> list[Any]:
    """The symbols and functions of time that occur, by name; the time itself only where it stands alone."""
    functions = {f for e in expressions for f in e.atoms(AppliedUndef)}
    times = {argument for f in functions for argument in f.args}
    symbols = {s for e in expressions for s in e.free_symbols} - times
    return sorted(functions | symbols, key=str)


def orders_of(*expressions: Any) -> dict[Any, int]:
    """How often each function of time is differentiated."""
    found: dict[Any, int] = {}
    for e in expressions:
        for f in e.atoms(AppliedUndef):
            found.setdefault(f, 0)
        for d in e.atoms(sp.Derivative):
            for f in d.expr.atoms(AppliedUndef):
                inner = orders_of(d.expr)[f]
                found[f] = max(found[f], d.derivative_count + inner)
    return found
