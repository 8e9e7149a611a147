"""Time derivatives of expressions, carried out by the usual rules; terms that are zero are left out."""

from __future__ import annotations

from chasles.rewriting.coefficients import added
from chasles.vocabulary import At, Block, Group, Integral, Node, Rate, Sum, Symbol, Zero, differentiation, rebuilt
from chasles.vocabulary.tree import with_parts


def carried_out(node: Node) -> Node:
    """The expression with every rate taken as far as the rules go; rates of symbols stay as they are."""
    if isinstance(node, Rate):
        inner = carried_out(node.of)
        return Rate(inner) if isinstance(inner, Symbol | Rate) else rate_of(inner)
    return with_parts(node, carried_out)


def rate_of(node: Node) -> Node:
    """The time derivative of an expression, carried out down to the rates of symbols."""
    match node:
        case Symbol(constant=True):
            return Zero(*node.shape)
        case Symbol() | Rate():
            return Rate(node)
        case Integral() | At() | Group():
            return _simplified(rebuilt(node, (Rate(node.below[0]),)), node)
    try:
        return _simplified(differentiation.rate_of(node), node)
    except differentiation.NoRule:
        return Rate(node)


def _simplified(rate: Node, of: Node) -> Node:
    """A rate by the rates of parts of an expression, these carried out; a product with a zero is left out."""
    if isinstance(rate, Rate):
        return rate_of(rate.of)
    parts = rate.below
    if rate in of.below or not parts:
        return rate
    changed = tuple(_simplified(part, of) for part in parts)
    if isinstance(rate, Sum):
        return added(changed)
    if changed == parts:
        return rate
    is_zero = any(isinstance(new, Zero) and new != old for new, old in zip(changed, parts, strict=True))
    return Zero(*rate.shape) if is_zero and not isinstance(rate, Block) else rebuilt(rate, changed)
