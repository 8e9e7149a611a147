"""Fractions, derivatives that look like them, and exponentials."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from itertools import product

from chasles.reading.applying import applied, of_matrix
from chasles.reading.context import FittingContext
from chasles.reading.fits import Fit, made
from chasles.reading.glyphs import Glyph, latex_of, letter_of
from chasles.reading.grammar import Atom, formula
from chasles.reading.grouping import Tokens, Unread, closing
from chasles.reading.page_notation import repeated_rate
from chasles.reading.spellings import exponential
from chasles.vocabulary import Node, Quotient
from chasles.vocabulary.partial import PartialDerivative
from chasles.vocabulary.spelling import Precedence


def of_tokens(tokens: Tokens, ctx: FittingContext) -> list[Fit]:
    """The readings of what braces hold."""
    try:
        chain = formula(tokens)
    except Unread as problem:
        ctx.problems.append(problem)
        return []
    if chain.relations or chain.sides[0] is None:
        ctx.note("an equation stands inside a formula", tokens[0] if tokens else None)
        return []
    return ctx.terms(chain.sides[0])


def partial_by(above: Tokens, below: Tokens, ctx: FittingContext) -> list[Node]:
    """What a partial derivative is taken by, where the fraction is one."""
    if [token.text for token in (*above[:1], *below[:1])] != [r"\partial"] * 2:
        return []
    return [fit.node for fit in of_tokens(below[1:], ctx) if fit.node is not None]


def order_of_rate(above: Tokens, below: Tokens) -> int:
    """Which derivative by the time a fraction d/dt says; 0 if it is none."""
    top, bottom = upright(above), upright(below)
    if top[:1] != ["d"] or bottom[:2] != ["d", "t"]:
        return 0
    if len(bottom) == 2:
        return 1
    powers = bottom[2:] == top[1:3] and top[1:2] == ["^"] and top[2].isdigit()
    return int(top[2]) if powers else 0


def derived(atom: Atom) -> list[str] | None:
    """What stands behind the d of a derivative, no rate: df/dx, Df/Dt, a higher partial one, a rate in a frame."""
    if atom.kind != "COMMAND_OF_TWO" or "frac" not in atom.text or order_of_rate(*atom.arguments):
        return None
    above, below = atom.arguments
    framed = [token.text for token in above[:3]] == ["{", "}", "^"]
    top, bottom = upright(above[closing(above, 3) + 1 if framed else 0 :]), upright(below)
    is_higher = top[:1] == [r"\partial"] and (top[1:2] == ["^"] or bottom.count(r"\partial") > 1)
    is_one = top[:1] == bottom[:1] and (top[:1] in (["d"], ["D"]) or is_higher) and len(bottom) > 1
    return top[1:] if is_one and "_" not in (*top[1:2], *bottom[1:2]) else None


def awaits(atom: Atom) -> bool:
    """Whether what a derivative is of stands behind it, as in d/dx or d^2/dx^2."""
    behind = derived(atom)
    return behind == [] or (behind is not None and behind[0] == "^" and len(behind) == 2)


def upright(tokens: Tokens) -> list[str]:
    """The tokens of a differential without their typeface."""
    return [token.text for token in tokens if token.text not in (r"\mathrm", "{", "}")]


def fraction_fits(atom: Atom, ctx: FittingContext) -> list[Fit]:
    """A quotient, or the rate of what stands behind the d of a numerator over dt."""
    above, below = atom.arguments
    if order := order_of_rate(above, below):
        start = next(k for k, token in enumerate(above) if token.text == "d") + 1
        start += 4 * (order > 1) + (above[0].text == r"\mathrm")
        return applied((repeated_rate(order),), of_tokens(above[start:], ctx), ctx, Glyph(""), atom.text)
    if derived(atom) is not None:
        return ctx.of_its_own(latex_of(atom))
    if len(above) > 1 and (variables := partial_by(above, below, ctx)):
        makes = [partial(PartialDerivative, by=by) for by in variables]
        return applied(makes, of_tokens(above[1:], ctx), ctx, replace(letter_of(atom), base="", accents=()), atom.text)
    found = []
    for top, bottom in product(of_tokens(above, ctx), of_tokens(below, ctx)):
        divisor = bottom.at((1, 1))
        if divisor is None:
            continue
        if top.node is None:
            found.append(ctx.of_open_size(Quotient, Precedence.SUM, top, divisor))
        if (one := top.sized_as((1, 1))) is not None:
            parts = ctx.inside(one, Precedence.SUM), ctx.inside(divisor, Precedence.SUM)
            found += ctx.made(Quotient, *parts, cost=one.cost + divisor.cost)
    return found


def exponential_fits(exponent: Tokens, ctx: FittingContext) -> list[Fit]:
    """The exponential of a scalar, of a multiple of a cross-product matrix, or of another matrix."""
    found = []
    for each in of_tokens(exponent, ctx):
        if (fit := each.sized_as(each.usual)) is not None and fit.node is not None:
            node = made(exponential, fit.node)
            found += of_matrix("exp", (fit.node,), ctx) if node is None else [Fit(node, fit.cost)]
    return found
