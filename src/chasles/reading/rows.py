"""Juxtapositions: products, functions and their arguments, signs between factors."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from itertools import pairwise, product

from chasles.reading.applying import applied, made_of
from chasles.reading.atoms import Atom, Atoms
from chasles.reading.context import FittingContext
from chasles.reading.expanding import OPEN, TOTALS, end_of_total, takes_all, totals
from chasles.reading.factors import factors, is_argument, operators_of
from chasles.reading.fits import UNUSUAL, Fit, kept, made
from chasles.reading.glyphs import Glyph, in_latex, joined, letter_of, text_of_row
from chasles.reading.grammar import NAMING
from chasles.reading.page_functions import lists_letters
from chasles.reading.products import times
from chasles.reading.spellings import Make, called, multiplied
from chasles.vocabulary import Quotient, Skew
from chasles.vocabulary.pieces import Precedence


def row_fits(row: Atoms, ctx: FittingContext) -> list[Fit]:
    """The readings of a row: the signs between factors hold less tightly than their juxtaposition."""
    ctx.product = lambda items: _product(items, ctx)
    return _signed(row, ctx)


def _signed(pieces: Atoms, ctx: FittingContext) -> list[Fit]:
    signs = TOTALS[: len(OPEN) if ctx.notation.integral else None]
    for place, piece in enumerate(pieces):
        if piece.kind != "INFIX" and (piece.text in signs or takes_all(piece, ctx.notation)):
            return _with_total(pieces, place, ctx)
    cuts = [k for k, piece in enumerate(pieces) if piece.kind == "INFIX"]
    if not cuts:
        return _product(pieces, ctx)
    if cuts[-1] == len(pieces) - 1 > 0 and pieces[-1].text == r"\times":  # what is multiplied is still to come
        return applied((Skew,), _signed(pieces[:-1], ctx), ctx, Glyph(""), r"\times")
    found: list[Fit] = []
    texts = {k: piece.text for k, piece in enumerate(pieces) if piece.kind == "INFIX"}
    step = 1 if r"\times" in texts.values() else UNUSUAL
    # The sign that binds least is the outermost: a stroke binds most, and of equal ones the last is outermost.
    for rank, cut in enumerate(sorted(cuts, key=lambda k: (texts[k] == "/", -k))):
        usual = rank * step
        sign, left, right = pieces[cut], pieces[:cut], pieces[cut + 1 :]
        makes = ctx.notation.spellings.infixes.get(sign.text, [])
        if not right or not (left or (sign.text in NAMING and not makes and ctx.notation.proposed)):
            ctx.note(f"{sign.text} has nothing on one side", sign.place)
            return []
        if sign.text == "/":
            found += _stroke(left, right, usual, ctx)
            continue
        if sign.text == "*" and _has_value(pieces, ctx):
            ctx.note("* between functions may be a convolution", sign.place)
            return []
        if not makes and ctx.notation.proposed and sign.text != "|":
            return ctx.of_its_own(in_latex(text_of_row(pieces)))
        if not makes:
            ctx.note(f"no word for {sign.text}", sign.place)
            return []
        pairs = [*product(_signed(left, ctx), _signed(right, ctx))]
        found += (fit for one, other in pairs for fit in _infix(makes, one, other, sign, usual, ctx))
        if pairs and not found and sign.text in NAMING:  # it has another meaning, too: that of Kronecker
            return ctx.of_its_own(in_latex(text_of_row(pieces)))
    return kept(found)


def _with_total(pieces: Atoms, place: int, ctx: FittingContext) -> list[Fit]:
    """A row with the sign of a sum over what is no numbers, or of an integral."""
    sign, before, inside = pieces[place], pieces[:place], pieces[place + 1 :]
    end = end_of_total(sign, inside)
    found = totals(sign, inside[:end], lambda each: _signed(each, ctx), ctx)
    if inside[end:]:
        found = [each for one in found for other in _signed(inside[end:], ctx) for each in times(one, other, ctx)]
    cut = max((k for k, piece in enumerate(before) if piece.kind == "INFIX"), default=-1)
    last = before[-1] if before else None
    functions = ctx.notation.spellings.names.get(called(last), []) if last and not last.is_marked else []
    if last and (operators := operators_of(last, ctx) or functions):
        found, before = list(made_of(operators, [[fit] for fit in found], None, ctx)), before[:-1]
    if before[cut + 1 :]:
        factors = _signed(before[cut + 1 :], ctx)
        found = [each for one in factors for other in found for each in times(one, other, ctx)]
    if cut < 0:
        return kept(found)
    infix = before[cut]
    makes = ctx.notation.spellings.infixes.get(infix.text, [])
    left = _signed(before[:cut], ctx) if cut else []
    return kept(each for one in left for other in found for each in _infix(makes, one, other, infix, 0, ctx))


def _infix(makes: list[Make], one: Fit, other: Fit, sign: Atom, usual: int, ctx: FittingContext) -> Iterator[Fit]:
    for k, make in enumerate(makes):
        shape = one.shape or other.shape or (1, 1)
        left, right = one.sized_as(shape), other.sized_as(shape)
        if left is None or right is None:
            continue
        node = made(make, ctx.inside(left, Precedence.PRODUCT), ctx.inside(right, Precedence.PRODUCT))
        if node is not None:
            yield Fit(node, one.cost + other.cost + usual + UNUSUAL * k)
            return
    if one.shape and other.shape:
        sizes = " and ".join(f"{rows} x {columns}" for rows, columns in (one.shape, other.shape))
        ctx.note(f"no word for {sign.text} between {sizes}", sign.place)


def _has_value(pieces: Atoms, ctx: FittingContext) -> bool:
    """Whether a function that is no word stands there with its argument."""
    names = ctx.notation.spellings.names
    pairs = ((one, behind) for one, behind in pairwise(pieces) if one.kind == "LETTER" and called(one) not in names)
    return any(is_argument(behind) or lists_letters(behind) for _, behind in pairs if behind.kind == "BRACKET")


def _stroke(left: Atoms, right: Atoms, usual: int, ctx: FittingContext) -> Iterator[Fit]:
    """A quotient on one line: of the product before the stroke by the next factor, or by all that follows.

    Which of them is clear where both are numbers, as in 1/2 m v^2; any other, such as a/b c, is a quantity of its own.
    """
    are_numbers = left[-1].kind == right[0].kind == "NUMBER" and right[1:] and right[1].text != r"\pi"
    is_one = are_numbers or any(end == len(right) and fits for end, fits in factors(right, 0, ctx))
    if not (is_one or any(piece.kind == "INFIX" for piece in right)):
        yield from ctx.of_its_own(in_latex(f"{text_of_row(left)} / {text_of_row(right)}"))
        return
    for end in range(1, len(right) + 1 if all(piece.kind != "INFIX" for piece in right) else 0):
        divisors = _product(right[:end], ctx)
        for top in _signed(left, ctx):
            for bottom in divisors:
                one, divisor = top.sized_as((1, 1)), bottom.at((1, 1))
                if divisor is None:
                    continue
                if top.node is None and end == len(right):
                    yield ctx.of_open_size(partial(Quotient, slash=True), Precedence.PRODUCT, top, divisor)
                if one is None:
                    continue
                parts = ctx.inside(one, Precedence.PRODUCT), ctx.inside(divisor, Precedence.POWER)
                for fit in ctx.made(Quotient, *parts, True, cost=one.cost + divisor.cost + usual + 3 * (end - 1)):
                    if end == len(right):
                        yield fit
                        continue
                    for rest in _product(right[end:], ctx):
                        yield from times(fit, rest, ctx)


def _product(items: Atoms, ctx: FittingContext) -> list[Fit]:
    """The readings of atoms side by side, whichever way they can be grouped, factors taken from the left first."""
    items = _names_whole(items, ctx)
    count = len(items)
    single: dict[tuple[int, int], list[Fit]] = {}
    for start in range(count):
        for end, fits in factors(items, start, ctx):
            single.setdefault((start, end), []).extend(fits)
    spans = {place: kept(fits) for place, fits in single.items()}
    for length in range(1, count + 1):
        for start in range(count - length + 1):
            end = start + length
            found = list(spans.get((start, end), ()))
            for cut in range(end - 1, start, -1):
                for left in spans.get((start, cut), ()):
                    for right in single.get((cut, end), ()):
                        found += times(left, right, ctx)
            if not found:
                for cut in range(end - 1, start, -1):
                    for left in spans.get((start, cut), ()):
                        for right in spans.get((cut, end), ()):
                            found += times(left, right, ctx)
            spans[start, end] = kept(found)
    if not spans[0, count] and ctx.tolerant:
        return _ill_formed(items, single, ctx)
    return spans[0, count]


def _names_whole(items: Atoms, ctx: FittingContext) -> Atoms:
    r"""The atoms with a name that is printed bold as one: \mathbf{1tr} is \mathbf{1} and tr."""
    names = [name for name in ctx.notation.spellings.names if name.isalpha() and len(name) > 1]
    letters = ctx.notation.letters
    longest = max((len(name.split()) for name in letters.names), default=1)
    found: list[Atom] = []
    place = 0
    while place < len(items):
        bold = [item.arguments[0][0].text if item.text == r"\mathbf" else "" for item in items[place : place + 8]]
        name = next((name for name in names if bold[: len(name)] == list(name)), "")
        name = "" if any(item.is_marked for item in items[place : place + len(name) - 1]) else name
        found.append(replace(items[place], kind="LETTER", text=name, arguments=()) if name else items[place])
        place += len(name) or 1
        for length in range(min(longest, len(found)), 1 if not name else longest, -1):
            joint = joined(found[-length:])
            letter = letter_of(joint) if joint else None
            if joint and letter and letter.loose.base in letters.names and next(letters.meanings(letter), None):
                found[-length:] = [joint]
                break
    return tuple(found)


def _ill_formed(items: Atoms, single: dict[tuple[int, int], list[Fit]], ctx: FittingContext) -> list[Fit]:
    """The product as it stands, though its factors do not fit together."""
    total: Fit | None = None
    start = 0
    while start < len(items):
        ends = [(end, fits) for (begin, end), fits in single.items() if begin == start and fits]
        if not ends:
            return []
        start, fits = max(ends, key=lambda each: each[0])
        fit = next((fit for fit in fits if fit.node is not None), None)
        if fit is None:
            return []
        if total is None:
            total = fit
            continue
        parts = ctx.inside(total, Precedence.PRODUCT), ctx.inside(fit, Precedence.PRODUCT)
        node = made(multiplied, *parts, tolerant=True)
        if node is not None and node.fault and ctx.notation.quaternions and total.shape == fit.shape == (4, 1):
            ctx.note("no word for quaternions side by side: quaternion_product = '# #' is one", items[start - 1].place)
            return []
        if node is not None and node.fault and ctx.mixes(total, fit):
            return []
        total = Fit(node, total.cost + fit.cost)
    return [] if total is None else [total]
