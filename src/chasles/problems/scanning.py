"""Expressions searched for the variables that they need once definitions are put in."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import gcd, lcm

from chasles import vocabulary as w
from chasles.problems.variables import NoForm, Untreatable, Variables, angle_multiples
from chasles.vocabulary import Node, plain


def scan(found: Variables, node: Node, order: int, rules: Mapping[Node, Node]) -> None:
    """Record the variables that the `order`-th rate of an expression needs, once the rules are applied."""
    if (node, order) in found.scanned:
        return
    if node in rules:
        _reach(found, node, order)
        _scan_rule(found, node, order, rules)
    else:
        _scan_parts(found, node, order, rules)
    # Only now: what leads back to itself has to be met again.
    found.scanned.add((node, order))


def _scan_parts(found: Variables, node: Node, order: int, rules: Mapping[Node, Node]) -> None:
    match node:
        case w.Symbol():
            _scan_symbol(found, node, order, rules)
        case w.Rate(of):
            scan(found, of, order + 1, rules)
        case w.Call(function, argument):
            if function not in ("sin", "cos"):
                raise Untreatable(f"the function {function} in {plain(node)} is not treated: only sin and cos are")
            for symbol, multiple in angle_multiples(argument, rules).items():
                if symbol != w.PI:
                    _scan_angle(found, symbol, multiple, order)
                elif (2 * multiple).denominator != 1:
                    raise NoForm(f"{plain(node)}: of angles in pi, only whole multiples of pi/2 are treated")
        case w.Power(w.Norm(of), exponent) if exponent % 2 == 0:
            scan(found, of, order, rules)
        case w.Quotient(numerator, denominator):
            scan(found, numerator, order, rules)
            _scan_divisor(found, denominator, order, rules)
        case w.At(of, argument):
            if argument != "t":
                raise Untreatable(f"{plain(node)} is of another instant than t: declare it as a constant of its own")
            scan(found, of, order, rules)
        case w.Norm(of):
            scan(found, of, order, rules)
            found.norms[of] = None
        case w.Integral(of):
            if found.running and found.running != node.running:
                raise Untreatable(f"{plain(node)} is not over the same quantities as another integral of the problem")
            if found.body not in (None, node.body):
                raise Untreatable(f"{plain(node)} is over another body than another integral of the problem")
            found.running, found.densities = node.running, found.densities | {node.density.name}
            found.body = node.body
            _require_running(node, rules)
            scan(found, of, order, rules)
        case _:
            for part in w.children(node):
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


def _require_running(node: w.Integral, rules: Mapping[Node, Node]) -> None:
    """Raise `Untreatable` if a rule makes something the same for all elements that the integral is taken over."""
    if not node.density.constant:
        raise Untreatable(f"{plain(node.density)} is a density: declare it constant, for an element keeps its mass")
    for symbol in node.running & rules.keys():
        if not differs(rules[symbol], node.running, rules):
            raise Untreatable(
                f"{plain(node)} is over {plain(symbol)}, and what is given says that {plain(symbol)} is "
                f"{plain(rules[symbol])}: take the integral over what differs from element to element there"
            )


def differs(node: Node, running: frozenset[w.Symbol], rules: Mapping[Node, Node]) -> bool:
    """Whether an expression differs from element to element of a body, as the running symbols do."""
    match node:
        case _ if node in rules:
            return differs(rules[node], running, rules)
        case w.Symbol(stands_for=Node() as inner):
            return differs(inner, running, rules)
        case w.Symbol():
            return node in running
        case w.Integral():
            return False
        case _:
            return any(differs(part, running, rules) for part in w.children(node))


def _scan_divisor(found: Variables, node: Node, order: int, rules: Mapping[Node, Node]) -> None:
    """A power of a norm is divided by as a power of the norm's variable, not of what is below the root."""
    match node:
        case _ if node in rules:
            _scan_divisor(found, rules[node], order, rules)
        case w.Power(of, _) | w.Group(of) | w.Negative(of):
            _scan_divisor(found, of, order, rules)
        case w.Scale(factor, term):
            _scan_divisor(found, factor, order, rules)
            _scan_divisor(found, term, order, rules)
        case _:
            scan(found, node, order, rules)


def _reach(found: Variables, node: Node, order: int) -> None:
    base, dots = w.undotted(node)
    if isinstance(base, w.Symbol):
        found.reached[base] = max(found.reached.get(base, 0), order + dots)


def _scan_symbol(found: Variables, symbol: w.Symbol, order: int, rules: Mapping[Node, Node]) -> None:
    if symbol.stands_for is not None:
        scan(found, symbol.stands_for, order, rules)
        return
    if symbol.constant:
        found.orders.setdefault(symbol, 0)
        return
    _reach(found, symbol, order)
    rate, free = w.Rate(symbol), 0
    while free < order and rate not in rules:
        rate, free = w.Rate(rate), free + 1
    found.orders[symbol] = max(found.orders.get(symbol, 0), free)
    if free < order:
        _scan_rule(found, rate, order - free - 1, rules)


def _scan_angle(found: Variables, symbol: w.Symbol, multiple: Fraction, order: int) -> None:
    old = found.angles.get(symbol)
    new = abs(multiple)
    if old is not None:
        new = Fraction(gcd(old.numerator, new.numerator), lcm(old.denominator, new.denominator))
    found.angles[symbol] = new
    if order:
        found.orders[symbol] = max(found.orders.get(symbol, 0), order)
        _reach(found, symbol, order)
