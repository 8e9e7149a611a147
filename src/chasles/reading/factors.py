"""What can be one factor of a product: an atom, a function of something, a derivative, an integral."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial

from chasles.reading.applying import applied, made_of, with_marks
from chasles.reading.atoms import Atom, Atoms, said_of
from chasles.reading.context import FittingContext
from chasles.reading.derivatives import derivative
from chasles.reading.fits import UNUSUAL, Fit, made, own_quantity
from chasles.reading.glyphs import (
    Glyph,
    in_latex,
    is_operator,
    letter_of,
    pieces_of,
    spelled,
    text_of_atom,
    with_arguments,
)
from chasles.reading.letter_names import RATES
from chasles.reading.marks import atom_fits, letter_fits
from chasles.reading.page_functions import lists_letters, makes_difference
from chasles.reading.page_notation import repeated_rate
from chasles.reading.quotients import of_atoms, partial_by
from chasles.reading.spellings import Make, called
from chasles.vocabulary import At, Group, Node, Symbol, latex, symbols_of
from chasles.vocabulary.fitting import measured
from chasles.vocabulary.functions import FunctionOf
from chasles.vocabulary.nodes import lifted
from chasles.vocabulary.partial import PartialDerivative
from chasles.vocabulary.pieces import Precedence

COUNTERS = ("n", "k", "i", "j", "m", "t")
"""Letters that number the members of a sequence."""


def factors(items: Atoms, start: int, ctx: FittingContext) -> Iterator[tuple[int, list[Fit]]]:
    """What begins here and is one factor: an atom, a function of something, a quantity with its argument."""
    atom = items[start]
    spellings = ctx.notation.spellings
    name = called(atom)
    integral = _integral(items, start, ctx)
    if integral is not None:
        yield integral
        return
    makes = spellings.names.get(f"{name} _ {said_of(atom.sub)}" if atom.sub else name)
    if atom.sub and name == r"\log" and said_of(atom.sub).isdigit():
        makes = [partial(_logarithm, int(said_of(atom.sub)))]
    if makes and atom.kind in ("LETTER", "COMMAND") and start + 1 < len(items):
        values = list(_applications(items, start, makes, ctx))
        yield from values
        if any(fits for _, fits in values) or not _is_letter(atom, ctx):
            return
    if (makes := spellings.subscripted.get(name)) and atom.sub:
        yield start + 1, list(made_of(makes, [[fit] for fit in of_atoms(atom.sub, ctx)], atom, ctx))
        return
    if (operators := operators_of(atom, ctx)) and start + 1 < len(items):
        for end in range(start + 2, len(items) + 1):
            inner = [[fit] for fit in ctx.product(items[start + 1 : end])]
            yield end, list(made_of(operators, inner, None, ctx))
        return
    behind = items[start + 1] if start + 1 < len(items) else None
    if behind is not None and behind.text == "!":
        yield start + 2, with_marks(ctx.of_its_own(in_latex(f"{text_of_atom(atom)} !")), letter_of(behind), ctx)
        return
    if behind is not None and makes_difference(atom, behind, ctx.notation.alone) and not _is_function(behind, ctx):
        if lists_letters(behind) and (value := _value_fits(atom, behind, ctx)):
            yield start + 2, value
            return
        make = partial(_difference, atom, ctx.notation.home)
        for end, found in factors(items, start + 1, ctx):
            yield end, applied((make,), found, ctx, Glyph(""), atom.text)
        return
    if behind is not None and atom.kind in ("LETTER", "COMMAND") and _is_index(behind):
        yield start + 2, ctx.of_its_own(in_latex(f"{text_of_atom(atom)} {text_of_atom(behind)}"))
        return
    if behind is not None and is_argument(behind) and any(each.text == "*" for each in pieces_of(atom)):
        ctx.note("* between functions may be a convolution", atom.place)
        return
    if behind is not None and atom.kind == "NUMBER" and _is_numeral(behind):
        ctx.note("two numbers side by side may be one number: write a sign between them", atom.place)
        return
    if behind is not None and _is_inverse_function(atom, behind, ctx):
        ctx.note(f"{spelled(letter_of(atom))} before an argument is an inverse function", atom.place)
        return
    fits = atom_fits(atom, ctx)
    if behind is not None and (value := _value_fits(atom, behind, ctx)):
        yield start + 2, with_marks(value, replace(letter_of(behind), accents=(), base=""), ctx)
        less = not (lists_letters(behind) or is_operator(letter_of(atom)))
        fits = [replace(fit, cost=fit.cost + UNUSUAL - less) for fit in fits]
    elif start + 1 < len(items) and is_argument(items[start + 1]):
        at = [new for fit in fits if fit.node is not None for new in ctx.made(At, fit.node, "t", cost=fit.cost)]
        yield start + 2, with_marks(at, replace(letter_of(items[start + 1]), accents=(), base=""), ctx)
        fits = [replace(fit, cost=fit.cost + UNUSUAL) for fit in fits]
    yield start + 1, fits


def _difference(sign: Atom, home: str, of: Node) -> Node:
    """The change of a quantity: one of its own."""
    said = latex(of) if isinstance(of, Symbol | Group) else rf"\left( {latex(of)} \right)"
    return own_quantity(f"{spelled(letter_of(sign))} {said}", measured(of), home)


def _is_index(bracket: Atom) -> bool:
    """Whether it is [n], [k - 1] or the like behind a letter, which is a member of a sequence then."""
    are_counters = (each.kind in ("NUMBER", "INFIX") or each.text in COUNTERS for each in pieces_of(bracket))
    is_marked = any(each.is_marked for each in pieces_of(bracket))
    return bracket.text == "[]" and len(bracket.inside) == 1 and all(are_counters) and not is_marked


def _is_numeral(atom: Atom) -> bool:
    return atom.kind == "NUMBER" or ("frac" in atom.text and all(said_of(each).isdigit() for each in atom.arguments))


def _is_inverse_function(atom: Atom, behind: Atom, ctx: FittingContext) -> bool:
    """Whether a scalar function that bears the exponent -1 stands before its argument."""
    letter = letter_of(atom)
    if letter.sups != ("- 1",) or not ctx.notation.functions.get(replace(letter, sups=())) or not lists_letters(behind):
        return False
    return any(node.is_scalar for node, _ in ctx.notation.letters.meanings(letter))


def _value_fits(atom: Atom, bracket: Atom, ctx: FittingContext) -> list[Fit]:
    """The value of a function: the notation knows its arguments, or the page has letters alone between its brackets."""
    letter = with_arguments(letter_of(atom), bracket)
    if letter is None or is_argument(bracket):
        return []
    is_function = ctx.notation.functions.get(replace(letter, arguments="", sups=()))
    if is_function and is_operator(letter) and next(ctx.notation.letters.meanings(letter), None) is None:
        return ctx.of_its_own(spelled(letter))
    (place, *more) = pieces_of(bracket)
    is_rate = bool(letter.accents) and {*RATES}.issuperset(letter.accents)
    if is_rate and not more and (place.kind == "NUMBER" or place.sub):
        bare = letter_fits(replace(letter, arguments=""), ctx)  # the rate is taken before the place is
        return ctx.of_its_own(spelled(letter), [fit.node for fit in bare if fit.node is not None])
    fits = letter_fits(letter, ctx, is_function=is_function is not None)
    return [replace(fit, cost=fit.cost + (2 * UNUSUAL if is_function is False else 0)) for fit in fits]


def _logarithm(base: int, of: Node) -> Node:
    """The logarithm to a base that is a number, by natural ones; under a letter it may be that at a point."""
    return FunctionOf("log", (of,)) / FunctionOf("log", (lifted(base),))


def is_argument(atom: Atom) -> bool:
    """Whether it is (t), the time at which a quantity is taken."""
    if atom.text != "()" or atom.sub or len(atom.inside) != 1 or atom.inside[0].signs != ("",):
        return False
    row = atom.inside[0].rows[0]
    return len(row) == 1 and row[0].text == "t" and not row[0].sub


def operators_of(atom: Atom, ctx: FittingContext) -> list[Make]:
    """What d/dt, or a partial derivative without what it is of, makes of what stands behind it."""
    found = derivative(atom)
    if found is None or found.of:
        return []
    if found.rate:
        return [repeated_rate(found.rate)]
    return [] if found.is_of_its_own else [partial(PartialDerivative, by=by) for by in partial_by(found, ctx)]


def _applications(items: Atoms, start: int, makes: list[Make], ctx: FittingContext) -> Iterator[tuple[int, list[Fit]]]:
    """A function of what stands in brackets behind its name, or of one or several of the next factors."""
    name, first = items[start], items[start + 1]
    if first.kind == "BRACKET" and first.text in ("()", "[]", r"\{\}"):
        arguments = [ctx.terms(each) for each in first.inside]
        choices: list[list[Fit]] = [[]]
        for fits in arguments:
            choices = [[*chosen, fit] for chosen in choices for fit in fits]
        marks = replace(letter_of(first), accents=(), base="")
        yield start + 2, with_marks(list(made_of(makes, choices, name, ctx)), marks, ctx)
        return
    if _is_function(first, ctx):  # as in \ln\tan x
        for end, fits in factors(items, start + 1, ctx):
            yield end, list(made_of(makes, [[fit] for fit in fits], name, ctx))
        return
    for end in range(start + 2, len(items) + 1 if not _is_letter(name, ctx) else 0):
        last = items[end - 1]  # an argument without brackets ends before brackets, and before another function
        if (last.kind == "BRACKET" and "|" not in last.text) or _is_function(last, ctx):
            break
        inner = [[fit] for fit in ctx.product(items[start + 1 : end])]
        fits = list(made_of(makes, inner, name, ctx))
        few = first.kind == "NUMBER" and end == start + 2 and end < len(items) and items[end].kind != "GRID"
        yield end, [Fit(fit.node, fit.cost + 2 * UNUSUAL * few + (end - start - 2)) for fit in fits]


def _is_letter(atom: Atom, ctx: FittingContext) -> bool:
    return next(ctx.notation.letters.meanings(letter_of(atom)), None) is not None


def _is_function(atom: Atom, ctx: FittingContext) -> bool:
    return called(atom) in ctx.notation.spellings.names and not _is_letter(atom, ctx)


def _integral(items: Atoms, start: int, ctx: FittingContext) -> tuple[int, list[Fit]] | None:
    """An integral over a body, up to the d of what it is printed to run over."""
    make, atom = ctx.notation.integral, items[start]
    if make is None or atom.text != r"\int" or not atom.sub:
        return None
    body = said_of(atom.sub)
    for end in range(start + 2, len(items) - 1):
        after = letter_of(items[end + 1])
        if items[end].text == "d" and items[end].kind == "LETTER" and after.base == body:
            inner = [[fit] for fit in ctx.product(items[start + 1 : end])]
            fits = [_unbracketed(make, fit, ctx) for (fit,) in inner if fit.node is not None]
            return end + 2, [fit for fit in fits if fit is not None]
    return None


def _unbracketed(make: Make, fit: Fit, ctx: FittingContext) -> Fit | None:
    """The integral; a letter in it usually means what runs over the body, where that has the letter."""
    inner = ctx.inside(fit, Precedence.PRODUCT)
    if (node := made(make, inner, tolerant=ctx.tolerant)) is None:
        return None
    running = {symbol.letter: symbol for symbol in getattr(node, "running", ())}
    is_usual = all(running.get(symbol.letter, symbol) == symbol for symbol in symbols_of(inner))
    return Fit(node, fit.cost + UNUSUAL * (not is_usual))
