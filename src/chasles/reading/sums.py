"""Sums: every term has one shape; zeros and identities without a size take it from the others."""

from __future__ import annotations

from chasles.reading.atoms import Atoms, Terms, Unread
from chasles.reading.commands import DOTS
from chasles.reading.context import FittingContext
from chasles.reading.expanding import order_of, up_to_order, whole_extrema, whole_integrals
from chasles.reading.fits import MOST, Fit, Shape, kept, made
from chasles.reading.glyphs import in_latex, text_of, text_of_row
from chasles.reading.rows import row_fits
from chasles.reading.spellings import called
from chasles.reading.summed_indices import counted
from chasles.vocabulary import Negative, Node, Sum
from chasles.vocabulary.dimension import has_units
from chasles.vocabulary.pieces import Precedence

MOST_TERMS = 500
OPEN = (*DOTS[:3], "const", "constant")
"""Of what is left out nothing is known, and a constant is another one in each equation."""
EITHER = frozenset({r"\pm", r"\mp"})


def sum_fits(terms: Terms, ctx: FittingContext) -> list[Fit]:
    """The readings of a sum, the usual ones first."""
    if len(terms.rows) > MOST_TERMS:
        raise Unread(f"a sum of more than {MOST_TERMS} terms: write it as several")
    terms = terms if has_units(ctx.notation.home) else whole_integrals(whole_extrema(terms))
    said = [row for row in terms.rows if not _is_open(row)]
    if EITHER.intersection(terms.signs) or 0 < len(said) < len(terms.rows):
        return _either(terms, ctx)
    if not said and not has_units(ctx.notation.home):
        return ctx.of_its_own(in_latex(text_of(terms)), here=ctx.where)
    if len(terms.rows) > 1 and terms.signs[-1] == "+" and (order := order_of(terms.rows[-1], ctx)):
        return up_to_order(sum_fits(Terms(terms.signs[:-1], terms.rows[:-1]), ctx), order, ctx)
    problems = len(ctx.problems)
    rows = [_row(row, ctx) for row in terms.rows]
    if not all(rows):
        return []
    del ctx.problems[problems:]
    if len(rows) == 1 and terms.signs[0] != "-":
        return rows[0]
    shapes = dict.fromkeys(fit.shape for fits in rows for fit in fits if fit.shape)
    found: list[Fit] = []
    for shape in shapes:
        found += _of_shape(terms.signs, rows, shape, ctx)
    of_open_size = [[fit for fit in fits if fit.node is None] for fits in rows]
    if all(of_open_size):
        found.append(_sized(terms.signs, of_open_size, ctx))
    if not found and ctx.tolerant:
        found = _ill_formed(terms.signs, rows, ctx)
    return kept(found)


def _row(row: Atoms, ctx: FittingContext) -> list[Fit]:
    """The readings of a row; one with factors that are left out, or summed over, is a quantity of its own."""
    is_summed = bool(ctx.summed) and max(map(counted(row).__getitem__, ctx.summed)) > 1
    is_open = any(piece.text in OPEN[:3] for piece in row)
    if has_units(ctx.notation.home) or not (is_summed or is_open):
        return row_fits(row, ctx)
    return ctx.of_its_own(in_latex(text_of_row(row)), here=ctx.where if is_open else "")


def _is_open(row: Atoms) -> bool:
    """Whether these are dots for what is left out, or a constant that is not named."""
    return len(row) == 1 and called(row[0]) in OPEN


def _either(terms: Terms, ctx: FittingContext) -> list[Fit]:
    r"""A sum with a \pm that is not on both sides, or dots: a quantity of its own, another one in each equation."""
    pairs = [(sign, row) for sign, row in zip(terms.signs, terms.rows, strict=True) if not _is_open(row)]
    signs = ["+" if sign in EITHER else sign for sign, _ in pairs]
    fits = sum_fits(Terms(("" if signs[0] == "+" else signs[0], *signs[1:]), tuple(row for _, row in pairs)), ctx)
    said = [fit.node for fit in fits if fit.node is not None and fit.shape]
    return ctx.of_its_own(in_latex(text_of(terms)), said, here=ctx.where) if fits else []


def _of_shape(signs: tuple[str, ...], rows: list[list[Fit]], shape: Shape, ctx: FittingContext) -> list[Fit]:
    partial: list[Fit] = []
    for place, (sign, fits) in enumerate(zip(signs, rows, strict=True)):
        here = [fit for each in fits if (fit := each.at(shape)) is not None]
        if place == 0:
            partial = [fit for each in here if (fit := _first(sign, each, ctx)) is not None]
        else:
            partial = [
                fit
                for one in partial
                for other in here
                if (fit := _plus(one, sign, other, ctx, place == 1)) is not None
            ]
        partial = kept(partial)[:MOST]
    return partial


def _first(sign: str, fit: Fit, ctx: FittingContext) -> Fit | None:
    if not sign:
        return Fit(ctx.inside(fit, Precedence.NEGATIVE), fit.cost)
    if sign == "+":
        return None
    return next(iter(ctx.made(Negative, ctx.inside(fit, Precedence.DOT), cost=fit.cost)), None)


def _plus(one: Fit, sign: str, other: Fit, ctx: FittingContext, is_first: bool, tolerant: bool = False) -> Fit | None:
    if sign not in "+-":
        return None
    assert one.node is not None
    if tolerant and ctx.mixes(one, other):
        return None
    node = ctx.inside(other, Precedence.DOT)
    term = Negative(node) if sign == "-" else node
    before = one.node.terms if isinstance(one.node, Sum) and not is_first else (one.node,)
    total = made(Sum, (*before, term), tolerant=tolerant)
    return None if total is None else Fit(total, one.cost + other.cost)


def _sized(signs: tuple[str, ...], rows: list[list[Fit]], ctx: FittingContext) -> Fit:
    """A sum of zeros and identities alone."""

    def at(shape: Shape) -> Node | None:
        found = _of_shape(signs, rows, shape, ctx)
        return found[0].node if found else None

    return Fit(None, sum(fits[0].cost for fits in rows), sized=at, usual=rows[0][0].usual)


def _ill_formed(signs: tuple[str, ...], rows: list[list[Fit]], ctx: FittingContext) -> list[Fit]:
    firsts = [next((fit for fit in fits if fit.node is not None), None) or fits[0].at((3, 3)) for fits in rows]
    if any(fit is None or fit.node is None for fit in firsts):
        return []
    total = _first(signs[0], firsts[0], ctx)  # type: ignore[arg-type]
    for place, (sign, fit) in enumerate(zip(signs[1:], firsts[1:], strict=True)):
        total = total and _plus(total, sign, fit, ctx, place == 0, True)  # type: ignore[arg-type]
    return [total] if total else []
