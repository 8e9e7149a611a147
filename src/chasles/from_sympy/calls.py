"""Values of functions that are not known, at expressions, as quantities: f(x - c*t), f'(x + c*t), f(0) beside f(t).

Whatever holds for all values of these holds for every function. What fails at some values fails for a function that has
these values there, unless something given ties them to each other: then nothing is said to fail.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.checker.expressions.enclosed import sign_of_number
from chasles.checker.expressions.quantities import is_unreal
from chasles.checker.sparse import Rejected
from chasles.from_sympy.atoms import assumed_of
from chasles.from_sympy.complex_symbols import expressions_in
from chasles.from_sympy.decimals import with_values
from chasles.from_sympy.opening import atoms_of, different_parts, parts_of
from chasles.from_sympy.side_conditions import listed

VALUES = AppliedUndef | sympy.Derivative | sympy.Subs
BINDING = sympy.Sum | sympy.Product | sympy.Integral | sympy.Limit


@dataclass(frozen=True, slots=True)
class Value:
    """The value of a function, or of its derivative by some of its arguments (counted from one), at these arguments."""

    function: Any
    orders: tuple[int, ...]
    arguments: tuple[Any, ...]

    @property
    def name(self) -> str:
        """How it is spelled: f''(x + y); of several arguments, D[1, 2](f)(x, y)."""
        called = str(self.function)
        if self.orders:
            several = len(self.arguments) > 1
            called = f"D[{', '.join(map(str, self.orders))}]({called})" if several else called + "'" * len(self.orders)
        return f"{called}({', '.join(map(str, self.arguments))})"

    def at(self, put: Mapping[Any, Any]) -> Value:
        """The same with values in its arguments."""
        return replace(self, arguments=tuple(sympy.expand(e.xreplace(put)) for e in self.arguments))

    @property
    def spelled(self) -> Any:
        """The same as SymPy writes it where the arguments are different symbols."""
        call = self.function(*self.arguments)
        return sympy.Derivative(call, *(self.arguments[k - 1] for k in self.orders)) if self.orders else call


class Calls:
    """A question in which all values of a function are at the same different symbols: others are quantities.

    `said` is the question so, and `defined` are the equations given by which arguments are said; a function keeps the
    first set of arguments of which it has a derivative.
    """

    def __init__(self, said: tuple[Any, ...]) -> None:
        moving = [e for e in expressions_in(said) if e.has(sympy.Derivative)]
        rates = [e for e in _parts(moving, sympy.Derivative) if value_of(e) is None]
        slopes = {e: slope for e in rates if not (slope := e.doit()).has(sympy.DiracDelta)}
        said = with_values(said, slopes) if slopes else said
        self.said, self.given = said, said[2:]
        spoken = _with_functions(said)
        # SymPy (1.14) leaves symbols called like a place in derivatives of what is there.
        places = {sympy.Symbol(f"_{p}"): p for e in _parts(spoken, sympy.Subs) for p in e.point if p.args}
        self.read = {e: value.at(places) for e, value in _values(spoken)}
        given = {} if any(e.has(AppliedUndef) for e in expressions_in(said[2])) else _said_values(said[2])
        places_of = {(value.function, value.arguments) for value in self.read.values()}
        several = len(places_of) > len({function for function, _ in places_of})
        met = {symbol for value in self.read.values() for e in value.arguments for symbol in e.free_symbols}
        self.defined = tuple(text for symbol, (_, text) in given.items() if symbol in met and several)
        if self.defined:
            known = {symbol: value for symbol, (value, _) in given.items()}
            self.read = {e: value.at(known) for e, value in self.read.items()}
        self.plain = _plain(self.read.values())
        self.named: dict[Value, Any] = {}
        self.put = {e: self._quantity(value) for e, value in self.read.items()}
        if any(e != quantity for e, quantity in self.put.items()):
            self.said = with_values(said, self.put)

    def _quantity(self, value: Value) -> Any:
        """A symbol; a function of the variables on which functions in the arguments depend, if there are any."""
        call = value.function(*value.arguments)
        if value.arguments == self.plain.get(value.function) or is_unreal(call) or call.has(sympy.I):
            return value.spelled
        if value not in self.named:
            assumed = {} if value.orders else assumed_of(call)
            moving = {t for e in value.arguments for part in e.atoms(AppliedUndef) for t in part.args if t.is_Symbol}
            symbol = sympy.Symbol(value.name, **{**assumed, "real": True})
            named = sympy.Function(value.name, **assumed)(*sorted(moving, key=str)) if moving else symbol
            self.named[value] = named
        return self.named[value]

    @property
    def _several(self) -> set[Any]:
        """The functions that have values at other places than the one at which they are kept."""
        return {value.function for value in self.named}

    def require_free(self, at: Mapping[str, Any]) -> None:
        """A counterexample counts: functions can have its values, and of those at several arguments nothing is given.

        Raises `Rejected` if not.
        """
        if any(value.function in self._several for _, value in _values(_with_functions(self.given))):
            raise Rejected("something is given of a function whose values at several arguments occur")
        self._places(list(self.named), at)
        self.require_apart(at)

    def require_apart(self, at: Mapping[str, Any]) -> None:
        """A function can have these values, given by name: they belong to different arguments, or are the same.

        Raises `Rejected` unless that is seen.
        """
        for one, other in self._pairs():
            told, other_told = (at.get(str(self._quantity(value))) for value in (one, other))
            places = [] if str(told) == str(other_told) else zip(*self._places((one, other), at), strict=True)
            if places and not any(sign_of_number(a - b) for a, b in places):
                raise Rejected(f"{one.name} and {other.name} may have the same arguments at the point")

    def apart(self) -> list[Any]:
        """For two values of a function, a difference of arguments that is no number, of what else is asked about."""
        spoken = self._spoken()
        found: dict[Any, None] = {}
        for one, other in self._pairs():
            gaps = (sympy.expand(a - b) for a, b in zip(one.arguments, other.arguments, strict=True))
            put = with_values(tuple(gap for gap in gaps if not gap.is_number), self.put)
            found |= dict.fromkeys([gap for gap in put if spoken.issuperset(atoms_of(gap))][:1])
        return [*found]

    def _pairs(self) -> Iterator[tuple[Value, Value]]:
        """Any two values of a function, or of one derivative of it, that occurs at several places."""
        values = [value for value in dict.fromkeys(self.read.values()) if value.function in self._several]
        for one, other in combinations(values, 2):
            if (one.function, one.orders) == (other.function, other.orders):
                yield one, other

    def _spoken(self) -> set[Any]:
        return {atom for e in expressions_in(self.said) for atom in atoms_of(e)}

    def _places(self, values: Sequence[Value], at: Mapping[str, Any]) -> list[list[Any]]:
        """The arguments of values at the point; what occurs in them only is a prime number, each another."""
        inside = [with_values(value.arguments, self.put) for value in values]
        spoken = self._spoken()
        point: dict[Any, Any] = {}
        for place, atom in enumerate(
            sorted({a for arguments in inside for e in arguments for a in atoms_of(e)}, key=str)
        ):
            number = sympy.Integer(sympy.prime(90 + place))
            may_be = all(getattr(number, f"is_{kind}") is known for kind, known in assumed_of(atom).items())
            if str(atom) not in at and (atom in spoken or not may_be):
                raise Rejected(f"the point has no value for {atom}")
            point[atom] = sympy.sympify(str(at[str(atom)])) if str(atom) in at else number
        found = [[e.xreplace(point) for e in arguments] for arguments in inside]
        if any(not (place.is_real and place.is_finite) for places in found for place in places):
            raise Rejected("an argument of a function is not seen to have a value at the point")
        return found


def _said_values(given: Any) -> dict[Any, tuple[Any, str]]:
    """Symbols of which it is given what they are, in others, and by which equation: f(x) is f(y) where x is y."""
    found: dict[Any, tuple[Any, str]] = {}
    for e in (item for _, item in listed(given, "given") if isinstance(item, sympy.Equality)):
        taken = {*found, *(symbol for value, _ in found.values() for symbol in value.free_symbols)}
        known = isinstance(e.rhs, sympy.Expr) and not e.rhs.free_symbols & {e.lhs, *found}
        if e.lhs.is_Symbol and e.lhs not in taken and known:
            found[e.lhs] = e.rhs, f"{e.lhs} = {e.rhs}"
    return found


def _plain(values: Iterable[Value]) -> dict[Any, tuple[Any, ...]]:
    """The arguments of a function that are different symbols, by function."""
    ordered = sorted(set(values), key=lambda value: (-len(value.orders), value.name), reverse=True)
    return {
        value.function: value.arguments for value in ordered
        if len(set(value.arguments)) == len(value.arguments) and all(e.is_Symbol for e in value.arguments)
    }  # fmt: skip


def _values(expressions: Iterable[Any]) -> Iterator[tuple[Any, Value]]:
    """The values of functions in expressions, but for those inside others and those of what is bound."""
    for whole in expressions:
        parts = [e for e in different_parts(whole, lambda e: isinstance(e, VALUES)) if isinstance(e, VALUES | BINDING)]
        limits = [limit for e in parts if isinstance(e, BINDING) for limit in getattr(e, "limits", [e.args[1:]])]
        bound = {symbol for limit in limits for symbol in limit[0].free_symbols}
        for e in parts:
            value = None if isinstance(e, BINDING) or e.free_symbols & bound else value_of(e)
            if value is not None:
                yield e, value


def _with_functions(said: tuple[Any, ...]) -> list[Any]:
    return [e for e in expressions_in(said) if e.has(AppliedUndef)]


def _parts(expressions: Iterable[Any], kind: Any) -> Iterator[Any]:
    return (e for whole in expressions for e in parts_of(whole) if isinstance(e, kind))


def value_of(e: Any) -> Value | None:
    """The value of a function, or of a derivative of one by its arguments; None for what is none."""
    if isinstance(e, AppliedUndef):
        return Value(e.func, (), tuple(map(sympy.expand, e.args)))
    if isinstance(e, sympy.Subs):
        inner = value_of(e.args[0])  # `e.expr` has other symbols in it
        return inner and inner.at(dict(zip(e.variables, e.point, strict=True)))
    if not isinstance(e, sympy.Derivative) or not isinstance(e.expr, AppliedUndef):
        return None
    arguments = e.expr.args
    if not all(v in arguments and sum(a.has(v) for a in arguments) == 1 for v in e.variables):
        return None
    orders = tuple(sorted(1 + arguments.index(v) for v in e.variables))
    return Value(e.expr.func, orders, tuple(map(sympy.expand, arguments)))
