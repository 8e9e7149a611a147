"""Fractions, derivatives that look like them, and exponentials."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from itertools import product

from chasles.reading.applying import applied, of_matrix
from chasles.reading.context import FittingContext
from chasles.reading.fits import Fit, made, own_quantity
from chasles.reading.glyphs import Glyph, in_latex, letter_of, said_of
from chasles.reading.grammar import Atom, formula
from chasles.reading.grouping import Tokens, Unread, closing, lines_of
from chasles.reading.page_notation import repeated_rate
from chasles.reading.spellings import Make, exponential
from chasles.vocabulary import (
    Node,
    Quotient,
    Rate,
    latex,
)
from chasles.vocabulary.dimension import has_units
from chasles.vocabulary.fitting import measured
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


def seen_from(above: Tokens, below: Tokens) -> tuple[str, Tokens]:
    """The frame from which a rate is seen, as its d bears it at the left, and what it is the rate of."""
    if [token.text for token in above[:3]] != ["{", "}", "^"] or upright(below) != ["d", "t"]:
        return "", ()
    end = closing(above, 3)
    frame, rest = said_of(above[3:end]), above[end + 1 :]
    start = 4 if [token.text for token in rest[:4]] == [r"\mathrm", "{", "d", "}"] else 1
    return (frame, rest[start:]) if upright(rest[:start]) == ["d"] else ("", ())


def rate_in_frame(frame: str, home: str) -> Make:
    """A rate as seen from a frame: a quantity of its own, for frames are no words."""

    def make(of: Node) -> Node:
        letter = rf"\frac{{{{}}^{{{frame}}} d}}{{dt}} {latex(of)}"
        return own_quantity(letter, measured(Rate(of)), home, f"rate in {frame} of {of}")

    return make


def derivative_by(above: Tokens, below: Tokens, ctx: FittingContext) -> list[Make]:
    """A derivative by a letter that is no time: a quantity of its own, for which units have no word."""
    behind = below[next((at for at, token in enumerate(below) if token.text == "d"), 0) + 1 :]
    behind = behind[1:] if [token.text for token in behind[:1]] == ["}"] else behind
    variable = lines_of(behind, ("^",))[0]
    if has_units(ctx.notation.home) or not any(fit.shape == (1, 1) for fit in of_tokens(tuple(variable), ctx)):
        return []
    texts = in_latex(said_of(above[: 1 if upright(above)[1:2] != ["^"] else 5])), in_latex(said_of(behind))
    mark = rf"\frac{{{texts[0]}}}{{d {texts[1]}}}"
    return [lambda of: own_quantity(f"{mark} ({latex(of)})", measured(of), ctx.notation.home)]


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
    frame, of = seen_from(above, below)
    if frame and of:
        return applied((rate_in_frame(frame, ctx.notation.home),), of_tokens(of, ctx), ctx, Glyph(""), atom.text)
    if upright(above)[:1] == ["D"] == upright(below)[:-1]:
        ctx.note("no word for such a derivative", atom.place)
        return []
    if upright(above)[:1] == upright(below)[:1] == ["d"]:
        start = next(at for at, token in enumerate(above) if token.text == "d") + 1 + (above[0].text == r"\mathrm")
        start = closing(above, start + 1) + 1 if above[start:] and above[start].text == "^" else start
        if not (makes := derivative_by(above, below, ctx)):
            ctx.note("no word for a derivative by anything but a scalar letter: write a partial one", atom.place)
            return []
        return applied(makes, of_tokens(above[start:], ctx), ctx, Glyph(""), atom.text)
    if len(above) > 1 and (variables := partial_by(above, below, ctx)):
        makes = [partial(PartialDerivative, by=by) for by in variables]
        return applied(makes, of_tokens(above[1:], ctx), ctx, replace(letter_of(atom), base="", accents=()), atom.text)
    found = []
    for top, bottom in product(of_tokens(above, ctx), of_tokens(below, ctx)):
        divisor = bottom.at((1, 1))
        if divisor is None:
            continue
        if top.node is None:
            found.append(sized_quotient(top, divisor, ctx))
        one = top if top.node is not None else top.at((1, 1))
        if one is None:
            continue
        (a, a_said), (b, b_said) = ctx.inside(one, Precedence.SUM), ctx.inside(divisor, Precedence.SUM)
        node = made(Quotient, a, b, tolerant=ctx.tolerant)
        if node is not None:
            found.append(Fit(node, (r"\frac", *a_said, *b_said), one.cost + divisor.cost))
    return found


def exponential_fits(exponent: Tokens, ctx: FittingContext) -> list[Fit]:
    """The exponential of a scalar, of a multiple of a cross-product matrix, or of another matrix."""
    fits = [fit for each in of_tokens(exponent, ctx) if (fit := each if each.node is not None else each.at(each.usual))]
    as_printed = [(fit, fit.node) for fit in fits if fit.node is not None and ctx.is_as_printed(fit)]
    found = []
    for fit, of in as_printed:
        node = made(exponential, of)
        node = of_matrix("exp", (of,), ctx) if node is None else node
        found += [] if node is None else [Fit(node, ctx.said(node), fit.cost)]
    return found


def sized_quotient(top: Fit, divisor: Fit, ctx: FittingContext, stroke: str = "") -> Fit:
    """An identity or a zero over a number is of open size as well."""

    def divided(one: Node, other: Node) -> Node:
        return Quotient(one, other, bool(stroke))

    fit = ctx.of_open_size(divided, Precedence.PRODUCT if stroke else Precedence.SUM, top, divisor, stroke)
    return fit if stroke else replace(fit, said=(r"\frac", *fit.said))
