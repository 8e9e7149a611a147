"""Which variables does a problem have? One for each entry of a free symbol or rate, two for an angle, one for a norm.

An angle phi that occurs with the multiples q of itself is measured by the cosine and sine of u phi, where u is the
largest rational of which all these q are whole multiples: phi/2 if the half-angle occurs.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from math import gcd, lcm

from chasles.vocabulary import (
    PI,
    At,
    Call,
    Group,
    Integral,
    Negative,
    Node,
    Norm,
    Number,
    Power,
    Quotient,
    Rate,
    Scale,
    Sum,
    Symbol,
    children,
    plain,
    undotted,
)

__all__ = [
    "Factors",
    "Untreatable",
    "Variable",
    "Variables",
    "angle_multiples",
    "differs",
    "entry_name",
    "moment_name",
    "scan",
]


Factors = tuple[tuple[str, int], ...]
"""Names of variables and their exponents."""


class Untreatable(ValueError):
    """An expression that the decision procedure does not treat; the message names it."""


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
    angle_orders: dict[Symbol, int] = field(default_factory=dict)
    norms: dict[Node, None] = field(default_factory=dict)
    instants: set[str] = field(default_factory=set)
    running: frozenset[Symbol] = frozenset()
    densities: frozenset[str] = frozenset()
    body: str | None = None
    moments: dict[Factors, None] = field(default_factory=dict)
    sought: dict[Node, int] = field(default_factory=dict)

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
    rows, columns = symbol.shape
    stem = symbol.name + (f"_{'d' * order}ot" if order else "")
    if (rows, columns) == (1, 1):
        return stem
    return f"{stem}_{row + 1}" if columns == 1 else f"{stem}_{row + 1}{column + 1}"


def _entries(symbol: Symbol, order: int) -> Iterator[Variable]:
    rows, columns = symbol.shape
    places = [(i, j) for i in range(rows) for j in range(columns)]
    turn = (order - 1) % len(places)
    places = places[::-1] if order == 0 else places[turn:] + places[:turn]
    for i, j in places:
        yield Variable("entry", entry_name(symbol, order, i, j), symbol, order, i, j)


def scan(found: Variables, node: Node, order: int, rules: Mapping[Node, Node]) -> None:
    """Record the variables that the `order`-th rate of an expression needs, once the rules are applied."""
    if node in rules:
        _reach(found, node, order)
        _scan_rule(found, node, order, rules)
        return
    match node:
        case Symbol():
            _scan_symbol(found, node, order, rules)
        case Rate(of):
            scan(found, of, order + 1, rules)
        case Call(function, argument):
            if function not in ("sin", "cos"):
                raise Untreatable(f"the function {function} in {plain(node)} is not treated: only sin and cos are")
            for symbol, multiple in angle_multiples(argument, rules).items():
                if symbol != PI:
                    _scan_angle(found, symbol, multiple, order)
                elif (2 * multiple).denominator != 1:
                    raise Untreatable(f"{plain(node)}: of angles in pi, only whole multiples of pi/2 are treated")
        case Power(Norm(of), exponent) if exponent % 2 == 0:
            scan(found, of, order, rules)
        case Quotient(numerator, denominator):
            scan(found, numerator, order, rules)
            _scan_divisor(found, denominator, order, rules)
        case At(of, argument):
            found.instants.add(argument)
            if len(found.instants) > 1:
                raise Untreatable(f"{plain(node)}: one instant is treated, and there are {sorted(found.instants)}")
            scan(found, of, order, rules)
        case Norm(of):
            scan(found, of, order, rules)
            found.norms[of] = None
        case Integral(of):
            if found.running and found.running != node.running:
                raise Untreatable(f"{plain(node)} is not over the same quantities as another integral beside it")
            if found.body not in (None, node.body):
                raise Untreatable(f"{plain(node)} is over another body than an integral beside it")
            found.running, found.densities = node.running, found.densities | {node.density.name}
            found.body = node.body
            _require_running(node, rules)
            scan(found, of, order, rules)
        case _:
            for part in children(node):
                scan(found, part, order, rules)


def _scan_rule(found: Variables, left: Node, order: int, rules: Mapping[Node, Node]) -> None:
    """The same for what a rule says, which may lead back to the rule only for a lower rate."""
    before = found.sought.get(left)
    if before is not None and before <= order:
        raise Untreatable(f"what is given says what the rate of {plain(left)} is by this rate itself: leave out a rule")
    found.sought[left] = order
    scan(found, rules[left], order, rules)
    del found.sought[left]
    if before is not None:
        found.sought[left] = before


def _require_running(node: Integral, rules: Mapping[Node, Node]) -> None:
    """Raise `Untreatable` if a rule makes something the same for all elements that the integral is taken over."""
    if not node.density.constant:
        raise Untreatable(f"{plain(node.density)} is a density: declare it constant, for an element keeps its mass")
    for symbol in node.running & rules.keys():
        if not differs(rules[symbol], node.running, rules):
            raise Untreatable(
                f"{plain(node)} is over {plain(symbol)}, and what is given says that {plain(symbol)} is "
                f"{plain(rules[symbol])}: take the integral over what differs from element to element there"
            )


def differs(node: Node, running: frozenset[Symbol], rules: Mapping[Node, Node]) -> bool:
    """Whether an expression differs from element to element of a body, as the running symbols do."""
    match node:
        case _ if node in rules:
            return differs(rules[node], running, rules)
        case Symbol(stands_for=Node() as inner):
            return differs(inner, running, rules)
        case Symbol():
            return node in running
        case Integral():
            return False
        case _:
            return any(differs(part, running, rules) for part in children(node))


def _scan_divisor(found: Variables, node: Node, order: int, rules: Mapping[Node, Node]) -> None:
    """A power of a norm is divided by as a power of the norm's variable, not of what is below the root."""
    match node:
        case _ if node in rules:
            _scan_divisor(found, rules[node], order, rules)
        case Power(of, _) | Group(of) | Negative(of):
            _scan_divisor(found, of, order, rules)
        case Scale(factor, term):
            _scan_divisor(found, factor, order, rules)
            _scan_divisor(found, term, order, rules)
        case _:
            scan(found, node, order, rules)


def _reach(found: Variables, node: Node, order: int) -> None:
    base, dots = undotted(node)
    if isinstance(base, Symbol):
        found.reached[base] = max(found.reached.get(base, 0), order + dots)


def _scan_symbol(found: Variables, symbol: Symbol, order: int, rules: Mapping[Node, Node]) -> None:
    if symbol.stands_for is not None:
        scan(found, symbol.stands_for, order, rules)
        return
    if symbol.constant:
        found.orders.setdefault(symbol, 0)
        return
    _reach(found, symbol, order)
    rate, free = Rate(symbol), 0
    while free < order and rate not in rules:
        rate, free = Rate(rate), free + 1
    found.orders[symbol] = max(found.orders.get(symbol, 0), free)
    if free < order:
        _scan_rule(found, rate, order - free - 1, rules)


def _scan_angle(found: Variables, symbol: Symbol, multiple: Fraction, order: int) -> None:
    old = found.angles.get(symbol)
    new = abs(multiple)
    if old is not None:
        new = Fraction(gcd(old.numerator, new.numerator), lcm(old.denominator, new.denominator))
    found.angles[symbol] = new
    found.angle_orders[symbol] = max(found.angle_orders.get(symbol, 0), order)
    if order:
        found.orders[symbol] = max(found.orders.get(symbol, 0), order)
        _reach(found, symbol, order)


def angle_multiples(argument: Node, rules: Mapping[Node, Node]) -> dict[Symbol, Fraction]:
    """An angle as a sum of rational multiples of symbols; raises `Untreatable` for any other argument."""
    total: dict[Symbol, Fraction] = {}
    for symbol, multiple in _linear(argument, Fraction(1), rules):
        total[symbol] = total.get(symbol, Fraction(0)) + multiple
    return {symbol: multiple for symbol, multiple in total.items() if multiple}


def _linear(node: Node, scale: Fraction, rules: Mapping[Node, Node]) -> Iterator[tuple[Symbol, Fraction]]:
    match node:
        case _ if node in rules:
            yield from _linear(rules[node], scale, rules)
        case Symbol(stands_for=Node() as of) | At(of):
            yield from _linear(of, scale, rules)
        case Symbol():
            yield node, scale
        case Group(of):
            yield from _linear(of, scale, rules)
        case Negative(term):
            yield from _linear(term, -scale, rules)
        case Sum(terms):
            for term in terms:
                yield from _linear(term, scale, rules)
        case Scale(Number(value), term) | Scale(term, Number(value)):
            yield from _linear(term, scale * value, rules)
        case Quotient(numerator, Number(value)):
            yield from _linear(numerator, scale / value, rules)
        case _:
            raise Untreatable(f"{plain(node)} is no angle: an angle is a sum of rational multiples of symbols")
