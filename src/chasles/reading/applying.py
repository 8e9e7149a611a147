"""What accents and scripts make of a reading, as the notation spells it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace as with_fields
from itertools import product

from chasles.reading.atoms import Atom, said_of
from chasles.reading.context import FittingContext
from chasles.reading.fits import Fit, Shape, made
from chasles.reading.glyphs import Glyph, in_latex
from chasles.reading.spellings import Make
from chasles.vocabulary import Call, Dot, Node, Power, Transpose, latex, symbols_of
from chasles.vocabulary.functions import PRINTED, FunctionOf
from chasles.vocabulary.motion_vectors import MotionByVector
from chasles.vocabulary.parts import part
from chasles.vocabulary.pieces import Precedence
from chasles.vocabulary.rotation_vectors import RotationByVector
from chasles.vocabulary.shorthand import Shorthand

OF_VECTORS = ("exp", "log", "sqrt", "operatorname{Exp}")
"""What may be of columns, too."""
BACKSLASH = "\\"

EXPONENT = re.compile(r"- \S+|\S+")
EVALUATED = "| _ "
HALF = ("1 / 2", r"\frac 1 2")
PLACES = {"x": 1, "y": 2, "z": 3}


def with_marks(fits: list[Fit], rest: Glyph, ctx: FittingContext) -> list[Fit]:
    """What accents and scripts make of it, from the inside out."""
    for accent in rest.accents:
        fits = applied(ctx.notation.spellings.accents.get(accent, ()), fits, ctx, rest, accent)
    if rest.sub and (makes := ctx.notation.spellings.scripts.get(f"_ {rest.loose.sub}")):
        fits = applied(makes, fits, ctx, rest, f"_{{{rest.sub}}}")
    elif rest.sub:
        parts = [fit for each in fits for fit in _component(each, rest, ctx)]
        fits = parts if parts or rest.base or not ctx.level else _of_its_own(fits, f"_{{{in_latex(rest.sub)}}}", ctx)
    if rest.primes:
        fits = applied(ctx.notation.spellings.scripts.get("'" * rest.primes, ()), fits, ctx, rest, "'" * rest.primes)
    for sup in rest.sups:
        fits = _raised(fits, sup, rest, ctx)
    return fits


def _raised(fits: list[Fit], sup: str, rest: Glyph, ctx: FittingContext) -> list[Fit]:
    words = " ".join(rest.loose.sups) if sup == rest.sups[0] else sup
    if words.isdigit():
        makes: tuple[Make, ...] = (lambda of: Power(of, int(words)) if of.is_scalar or int(words) != 2 else square(of),)
    elif words in HALF:
        makes = tuple(ctx.notation.spellings.names[r"\sqrt"])
    elif words.startswith(EVALUATED):
        taken = [fit for fit in fits if fit.node is None or fit.shape]
        return _of_its_own(taken, rf" \right{in_latex(words)}", ctx, r"\left. ")
    else:
        makes = tuple(ctx.notation.spellings.scripts.get(words, ()))
    parts = EXPONENT.findall(words)
    if not makes and len(parts) > 1 and all(part.isdigit() or part in ctx.notation.spellings.scripts for part in parts):
        for word in parts:
            fits = _raised(fits, word, Glyph("", sups=(word,), place=rest.place), ctx)
        return fits
    if Transpose in makes:
        numbers = [fit for fit in fits if fit.node is not None and _is_of_numbers(fit.node)]
        powers = _of_its_own(numbers, f"}}^{{{in_latex(words)}}}", ctx, "{")
        return powers + applied(makes, [fit for fit in fits if fit not in numbers], ctx, rest, f"^{{{words}}}")
    found = applied(makes, fits, ctx, rest, f"^{{{words}}}")
    if found or not ctx.level or words.isdigit():
        return found
    return _of_its_own(fits, f"}}^{{{in_latex(words)}}}", ctx, "{", is_alike=False)


def _is_of_numbers(node: Node) -> bool:
    """Whether no letter in it has rows or columns, so that nobody transposes it: the T is an exponent."""
    return node.is_scalar and all(symbol.is_scalar for symbol in symbols_of(node))


def _of_its_own(
    fits: list[Fit], behind: str, ctx: FittingContext, before: str = "", is_alike: bool = True
) -> list[Fit]:
    """What a mark that is no word makes of each of the readings: a quantity of its own, of the same kind or any."""
    said: dict[str, list[Node]] = {}
    for fit in fits:
        if (sample := fit.sample) is not None:
            said[latex(sample)] = [] if fit.node is None or not is_alike else [fit.node]
    return [fit for text, like in said.items() for fit in ctx.of_its_own(f"{before}{text}{behind}", like)]


def square(of: Node) -> Node:
    """The square of a matrix, or that of a vector, which is its length squared."""
    return Power(of, 2) if of.shape[1] != 1 else Dot(of, of)


def applied(makes: Sequence[Make], fits: list[Fit], ctx: FittingContext, rest: Glyph, mark: str) -> list[Fit]:
    """Each of the words made of each reading, as far as it fits; the first of them is the usual one."""
    found: list[Fit] = []
    spelled: set[int] = set()
    for make, (place, fit) in product(makes, enumerate(fits)):
        if fit.node is None and mark.startswith("^"):
            found.append(_applied_to_sized(make, fit, ctx))
        elif fit.node is None:
            sizes = filter(None, map(fit.at, ctx.sizes_of([fit])))
            found += [new for size in sizes for new in applied((make,), [size], ctx, rest, mark)][:1]
        elif new := ctx.made(make, ctx.inside(fit, Precedence.ATOM), cost=fit.cost + (place in spelled)):
            found += new
            spelled.add(place)
    if not makes:
        ctx.note(f"{mark} has no meaning in the notation", rest.place)
    return [fit for fit in found if fit.node is None or not fit.node.fault] or found


def _applied_to_sized(make: Make, fit: Fit, ctx: FittingContext) -> Fit:
    def of_shape(shape: Shape) -> Node | None:
        inner = fit.at((shape[1], shape[0]))
        node = None if inner is None else made(make, ctx.inside(inner, Precedence.ATOM))
        return node if node is not None and node.shape == shape else None

    return Fit(None, fit.cost, sized=of_shape, usual=fit.usual[::-1])


def _component(fit: Fit, rest: Glyph, ctx: FittingContext) -> list[Fit]:
    """An entry of a letter that is printed thin: omega_x, R_{12}; bold ones with subscripts are other letters."""
    node, sub = fit.node, rest.sub
    if node is None or node.is_scalar or node.measure is None or (r"\mathbf" in rest.base and ":" not in sub):
        return []
    rows, columns = node.shape
    make: Make | None = None
    if columns == 1 and ((sub in PLACES and rows == 3) or (sub.isdigit() and 0 < int(sub) <= rows)):
        make = (
            (lambda of: with_fields(part(of, PLACES[sub]), mark=sub))
            if sub in PLACES
            else (lambda of: part(of, int(sub)))
        )
    if ":" in sub:
        places = tuple(map(_range, sub.replace(" ", "").split(",")))
        return applied((lambda of: part(of, places if len(places) > 1 else places[0]),), [fit], ctx, rest, sub)  # type: ignore[arg-type]
    digits = [int(digit) for digit in sub.replace(",", "").replace(" ", "") if digit.isdigit()]
    if columns > 1 and len(digits) == 2 and sub.replace(",", "").replace(" ", "").isdigit():
        make = lambda of: part(of, (digits[0], digits[1]))  # noqa: E731
    return [] if make is None else applied((make,), [fit], ctx, rest, f"_{{{sub}}}")


def _range(text: str) -> int | slice:
    first, _, last = text.partition(":")
    return slice(int(first), int(last)) if last else int(first)


def made_of(
    makes: list[Make], choices: Iterable[Sequence[Fit]], name: Atom | None, ctx: FittingContext
) -> Iterator[Fit]:
    """What words make of each choice of operands; their name may bear an exponent."""
    for chosen in choices:
        for make in makes:
            more = 0
            for shape in ctx.sizes_of(chosen):
                fits = [fit.sized_as(shape) for fit in chosen]
                nodes = [fit.node for fit in fits if fit is not None and fit.node is not None]
                if len(nodes) < len(chosen):
                    continue
                node = made(_with_exponent, make, nodes, name, tolerant=ctx.tolerant)
                called = _of_matrices(node) if node is not None and node.fault else ""
                if own := of_matrix(called, nodes, ctx) if called else []:
                    yield from own
                    continue
                if node is not None:
                    yield Fit(node, sum(fit.cost for fit in chosen) + more)
                    more = 1  # of an identity every size is told of, the usual one first


def of_matrix(function: str, nodes: Sequence[Node], ctx: FittingContext) -> list[Fit]:
    """A function of a square matrix, or of a column, that no word says: a quantity of its own."""
    rows, columns = nodes[0].shape if len(nodes) == 1 and not nodes[0].fault else (1, 0)
    is_known = rows == columns or (columns == 1 and (function in OF_VECTORS or function.startswith("operatorname")))
    return ctx.of_its_own(rf"\{function}\left({latex(nodes[0])}\right)") if is_known else []


def _of_matrices(node: Node) -> str:
    """The name of a function that may have a meaning for what it has no word for."""
    if isinstance(node, Power):
        return f"{name}^{node.exponent}" if (name := _of_matrices(node.base)) else ""
    if isinstance(node, FunctionOf | Call):
        return node.function
    if isinstance(node, Shorthand):
        return f"operatorname{{{node.function}}}"
    return "operatorname{Exp}" if isinstance(node, RotationByVector | MotionByVector) else ""


def _with_exponent(make: Make, nodes: list[Node], name: Atom | None) -> Node:
    """What a function makes of its arguments, raised to the exponent that its name bears; -1 makes it the inverse."""
    exponents = [said_of(sup) for sup in name.sups] if name else []
    if name is not None and exponents == ["- 1"] and (inverse := f"arc{name.text.strip(BACKSLASH)}") in PRINTED:
        return FunctionOf(inverse, tuple(nodes))
    node = make(*nodes)
    if any(not each.isdigit() for each in exponents):
        raise ValueError("a function's name bears something else than an exponent")
    for each in exponents:
        node = Power(node, int(each))
    return node
