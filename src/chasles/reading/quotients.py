"""Fractions, derivatives that look like them, and exponentials."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from itertools import product

from chasles.reading.applying import applied, of_matrix
from chasles.reading.atoms import Atom, Atoms, Unread
from chasles.reading.context import FittingContext
from chasles.reading.derivatives import Derivative, derivative
from chasles.reading.fits import Fit, made
from chasles.reading.glyphs import Glyph, latex_of, letter_of
from chasles.reading.grammar import formula
from chasles.reading.page_notation import repeated_rate
from chasles.reading.spellings import exponential
from chasles.vocabulary import Node, Quotient
from chasles.vocabulary.partial import PartialDerivative
from chasles.vocabulary.pieces import Precedence


def of_atoms(atoms: Atoms, ctx: FittingContext) -> list[Fit]:
    """The readings of what braces hold."""
    try:
        chain = formula(atoms)
    except Unread as problem:
        ctx.problems.append(problem)
        return []
    if chain.relations or chain.sides[0] is None:
        ctx.note("an equation stands inside a formula", atoms[0].place if atoms else None)
        return []
    return ctx.terms(chain.sides[0])


def partial_by(found: Derivative, ctx: FittingContext) -> list[Node]:
    """What a partial derivative is taken by."""
    return [fit.node for fit in of_atoms(found.by, ctx) if fit.node is not None] if found.sign == r"\partial" else []


def fraction_fits(atom: Atom, ctx: FittingContext) -> list[Fit]:
    """A quotient, or the rate of what stands behind the d of a numerator over dt."""
    above, below = atom.arguments
    if (said := derivative(atom)) is not None:
        if said.rate:
            return applied((repeated_rate(said.rate),), of_atoms(said.of, ctx), ctx, Glyph(""), atom.text)
        if said.is_of_its_own:
            return ctx.of_its_own(latex_of(atom))
        if said.of and (makes := [partial(PartialDerivative, by=by) for by in partial_by(said, ctx)]):
            marks = replace(letter_of(atom), base="", accents=())
            fits = applied(makes, of_atoms(said.of, ctx), ctx, marks, atom.text)
            is_word = any(fit.node is None or not fit.node.fault for fit in fits)
            return fits if is_word else ctx.of_its_own(latex_of(atom))  # by a matrix, or by an expression
    found: list[Fit] = []
    for top, bottom in product(of_atoms(above, ctx), of_atoms(below, ctx)):
        divisor = bottom.at((1, 1)) or (bottom if ctx.tolerant and bottom.node is not None else None)
        if divisor is None:
            continue
        if top.node is None:
            found.append(ctx.of_open_size(Quotient, Precedence.SUM, top, divisor))
        if (one := top.sized_as((1, 1))) is not None:
            parts = ctx.inside(one, Precedence.SUM), ctx.inside(divisor, Precedence.SUM)
            found += ctx.made(Quotient, *parts, cost=one.cost + divisor.cost)
    return found or (ctx.of_its_own(latex_of(atom)) if said and said.of and said.by else [])  # by a column, with deltas


def exponential_fits(exponent: Atoms, ctx: FittingContext) -> list[Fit]:
    """The exponential of a scalar, of a multiple of a cross-product matrix, or of another matrix."""
    found = []
    for each in of_atoms(exponent, ctx):
        if (fit := each.sized_as(each.usual)) is not None and fit.node is not None:
            node = made(exponential, fit.node)
            found += of_matrix("exp", (fit.node,), ctx) if node is None else [Fit(node, fit.cost)]
    return found
