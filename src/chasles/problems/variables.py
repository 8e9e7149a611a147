"""The variables of a problem: one for each entry of a free symbol or rate, two for an angle, one for a norm.

The fraction for each quantity is found in them.

An angle phi that occurs with the multiples q of itself is measured by the cosine and sine of u phi, where u is the
largest rational of which all these q are whole multiples: phi/2 if the half-angle occurs.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

from chasles.algebra.localization import Localization, Ratio
from chasles.statements.angles import linear_terms
from chasles.vocabulary import At, Node, Symbol, plain
from chasles.vocabulary.letters import entry_names

Factors = tuple[tuple[str, int], ...]
"""Names of variables and their exponents."""


class Untreatable(ValueError):
    """An expression that the decision procedure does not treat; the message names it."""


class NoForm(Untreatable):
    """A word without a polynomial form, or an angle that is no sum of rational multiples of symbols."""


class Unlisted(Untreatable):
    """A rate for which a problem has no variable."""


@dataclass(frozen=True, slots=True)
class Variable:
    """A variable of the ring: an "entry" of a symbol's `order`-th rate, a "cos", a "sin", a "norm" or a "moment".

    A moment is the integral over the body of a product of powers of `factors`, variables that differ from element to
    element.
    """

    kind: str
    name: str
    symbol: Symbol | None = None
    order: int = 0
    row: int = 0
    column: int = 0
    node: Node | None = None
    factors: Factors = ()
    unit: Fraction = Fraction(1)


@dataclass(slots=True)
class Variables:
    """What the scan of a problem finds; the moments are found later, when the integrands are unfolded.

    `orders` says up to which rate a symbol has variables, `reached` up to which it is asked for: rules may give it.
    """

    orders: dict[Symbol, int] = field(default_factory=dict)
    reached: dict[Symbol, int] = field(default_factory=dict)
    angles: dict[Symbol, Fraction] = field(default_factory=dict)
    norms: dict[Node, None] = field(default_factory=dict)
    running: frozenset[Symbol] = frozenset()
    densities: frozenset[str] = frozenset()
    body: str | None = None
    moments: dict[Factors, None] = field(default_factory=dict)
    sought: dict[Node, int] = field(default_factory=dict)
    scanned: set[tuple[Node, int]] = field(default_factory=set)

    def listed(self, unknowns: tuple[Symbol, ...]) -> Iterator[Variable]:
        """The variables from largest to smallest in the term order; the rates of unknowns follow from their values.

        The entries of a vector's rates are ordered so that e.e - 1 and its derivatives have coprime leading terms:
        then they are a Groebner basis as they stand.
        """
        for node in self.norms:
            yield Variable("norm", f"|{plain(node)}|", node=node)
        ranked = sorted(self.orders.items(), key=lambda item: item[0] not in unknowns)
        highest = max(self.orders.values(), default=0)
        for order in range(highest, -1, -1):
            for symbol, known in ranked:
                if order <= known and not (order and symbol in unknowns):
                    yield from _entries(symbol, order)
        for symbol, unit in self.angles.items():
            name = angle_name(symbol, unit)
            yield Variable("sin", f"sin({name})", symbol, unit=unit)
            yield Variable("cos", f"cos({name})", symbol, unit=unit)
        for factors in self.moments:
            yield Variable("moment", moment_name(factors), factors=factors)


def angle_name(symbol: Symbol, unit: Fraction) -> str:
    """The angle whose cosine and sine are the variables: phi, phi/2, 3phi/4."""
    above = "" if unit.numerator == 1 else str(unit.numerator)
    return f"{above}{symbol.name}" + (f"/{unit.denominator}" if unit.denominator != 1 else "")


def moment_name(factors: Factors) -> str:
    """The integral over the body of a product of variables: int(rho p_1 p_1), int(rho)."""
    return f"int({' '.join(name for name, exponent in factors for _ in range(exponent))})"


def entry_name(symbol: Symbol, order: int, row: int, column: int) -> str:
    """The name of one entry of a symbol or of its rate: e_1, Q_12, a_dot_3, phi."""
    return entry_names(symbol.name + (f"_{'d' * order}ot" if order else ""), *symbol.shape)[row][column]


def _entries(symbol: Symbol, order: int) -> Iterator[Variable]:
    rows, columns = symbol.shape
    places = [(i, j) for i in range(rows) for j in range(columns)]
    turn = (order - 1) % len(places)
    places = places[::-1] if order == 0 else places[turn:] + places[:turn]
    for i, j in places:
        yield Variable("entry", entry_name(symbol, order, i, j), symbol, order, i, j)


def angle_multiples(argument: Node, rules: Mapping[Node, Node]) -> dict[Symbol, Fraction]:
    """An angle as a sum of rational multiples of symbols; raises `Untreatable` for any other argument."""
    total: dict[Symbol, Fraction] = {}
    for term, multiple in linear_terms(argument, rules):
        if isinstance(term, At):
            raise Untreatable(f"{plain(term)} is of another instant than t: declare it as a constant of its own")
        if not isinstance(term, Symbol):
            raise NoForm(f"{plain(term)} is no angle: an angle is a sum of rational multiples of symbols")
        total[term] = total.get(term, Fraction(0)) + multiple
    return {symbol: multiple for symbol, multiple in total.items() if multiple}


class Coordinates:
    """One for each of `variables`, in their order."""

    def __init__(self, field: Localization, variables: Sequence[Variable]) -> None:
        self._field = field
        self._entries: dict[tuple[Symbol | None, int, int, int], int] = {}
        self._circular: dict[tuple[str, Symbol | None], int] = {}
        self._norms: dict[Node | None, int] = {}
        self._units: dict[Symbol | None, Fraction] = {}
        for place, variable in enumerate(variables):
            match variable.kind:
                case "entry":
                    self._entries[variable.symbol, variable.order, variable.row, variable.column] = place
                case "cos" | "sin":
                    self._circular[variable.kind, variable.symbol] = place
                    self._units[variable.symbol] = variable.unit
                case "norm":
                    self._norms[variable.node] = place

    def entry(self, symbol: Symbol, order: int, row: int, column: int) -> Ratio | None:
        """An entry of a symbol's `order`-th rate; None if there is no variable for it."""
        place = self._entries.get((symbol, order, row, column))
        return None if place is None else self._at(place)

    def unit(self, angle: Symbol) -> Fraction:
        """The variables are the cosine and sine of this multiple of the angle."""
        return self._units[angle]

    def circular(self, angle: Symbol) -> tuple[Ratio, Ratio]:
        """The cosine and sine of an angle's unit."""
        return self._at(self._circular["cos", angle]), self._at(self._circular["sin", angle])

    def norm(self, of: Node) -> Ratio:
        """The norm of an expression."""
        return self._at(self._norms[of])

    def _at(self, place: int) -> Ratio:
        return self._field.ratio(self._field.ring.generators[place])
