"""Which bound is proved of a program? The strongest of those that can be."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping
from decimal import ROUND_CEILING, Decimal
from fractions import Fraction
from hashlib import sha256

from chasles.bounds.bound import Bound, Guarantee
from chasles.bounds.cases import cases, errors_of_case
from chasles.bounds.cover import covered
from chasles.bounds.covering import largest
from chasles.bounds.intervals import Array
from chasles.bounds.model import SINGLE, Model
from chasles.bounds.outline import NoBound, Outline, outlined
from chasles.bounds.running import Running
from chasles.bounds.sensitivity import Group, against_largest
from chasles.bounds.termwise import TermwiseError, termwise_errors
from chasles.lowering.program import Program
from chasles.lowering.request import Request
from chasles.statements.kernel import Argument, nodes_of
from chasles.vocabulary import Node
from chasles.vocabulary.fitting import measured

METHOD = 4
"""Changes with every change of what is proved of a program, so that remembered bounds are not taken for new ones."""
BOXES = 250_000
DIGITS = Decimal("0.01")
COVERED_DIGITS = Decimal("0.1")
"""To what units are rounded upwards: coarser where the end depends on the order in which boxes are halved."""
ALL = "all inputs"
CONDITION = 2**12
"""The largest condition of a divisor, the sum of its terms' sizes over its own size, for which something is proved."""
WELL = f"all inputs of which that is at most {CONDITION}"


def bound_of(program: Program, request: Request, model: Model = SINGLE) -> Bound:
    """What is proved of the program's errors under the model, in units of its roundoff.

    Of two kinds of bounds the first that can be proved is given. Every entry against itself, by counting roundings; or
    against the largest entry, by covering all inputs with boxes, where all inputs are unit vectors and angles; or
    against the sum of its terms' sizes, by counting. What is proved for single precision holds in double precision.
    Raises ModuleNotFoundError where boxes are needed and python-flint is not installed.
    """
    key = key_of(program, request, model)
    try:
        outline = outlined(program)
    except NoBound:
        return _bound_of_cases(key, program, request, model)
    try:
        counted = _counted(outline, model)
        if any(guarantee.against == "terms" for guarantee in counted):
            return Bound(key, _over_boxes(outline, request, model) or counted)
        return Bound(key, counted)
    except NoBound as reason:
        return _bound_with_condition(key, outline, model, str(reason))


def _bound_of_cases(key: str, program: Program, request: Request, model: Model) -> Bound:
    """The worst of the program's cases, each compared with its own formula."""
    rotations = _subjects(request, "rotation")
    rotation = next((k for k, a in enumerate(request.arguments) if _is_among(a, rotations)), None)
    try:
        found = [(case.outline, errors_of_case(case, model, rotation)) for case in cases(program)]
    except NoBound as reason:
        return Bound(key, reason=str(reason))
    inputs = f"every rotation {program.arguments[rotation].name}" if rotation is not None else ALL
    guarantees = []
    for index, result in enumerate(program.results):
        entries = [error[k] for outline, error in found for k in outline.entries(index)]
        guarantees.append(_guarantee(result.name, entries, model, f"{inputs}, beside the case that is taken"))
    return Bound(key, tuple(guarantees))


def _bound_with_condition(key: str, outline: Outline, model: Model, reason: str) -> Bound:
    """By counting roundings, where a divisor may cancel."""
    try:
        found = termwise_errors(outline, model, most=CONDITION)
    except NoBound:
        return Bound(key, reason=reason)
    guarantees = []
    for index, result in enumerate(outline.program.results):
        entries = [found[k] for k in outline.entries(index)]
        conditioned = any(error.conditioned for error in entries)
        guarantees.append(_guarantee(result.name, entries, model, WELL if conditioned else ALL))
    return Bound(key, tuple(guarantees))


def key_of(program: Program, request: Request, model: Model = SINGLE) -> str:
    """The hash of all that the bound depends on."""
    rotations = _subjects(request, "rotation")
    assumed = _units(request), tuple(k for k, a in enumerate(request.arguments) if _is_among(a, rotations))
    parts = (METHOD, program.arguments, program.steps, program.results, assumed, _places(request), model)
    return sha256(repr(parts).encode()).hexdigest()


def _counted(outline: Outline, model: Model) -> tuple[Guarantee, ...]:
    """By counting roundings. Raises NoBound."""
    found = termwise_errors(outline, model)
    results = enumerate(outline.program.results)
    return tuple(_guarantee(r.name, [found[k] for k in outline.entries(i)], model, ALL) for i, r in results)


def _guarantee(result: str, entries: list[TermwiseError], model: Model, inputs: str) -> Guarantee:
    error = max(error.error for error in entries)
    against = "terms" if not all(error.single for error in entries) else "itself" if error else "nothing"
    if any(error.conditioned for error in entries):
        against = "conditioned"
    return Guarantee(result, against, _upwards(error / model.roundoff, DIGITS), inputs)


def _over_boxes(outline: Outline, request: Request, model: Model) -> tuple[Guarantee, ...]:
    """By covering the inputs; nothing where that does not work."""
    program, units = outline.program, _units(request)
    if outline.scales:
        return ()
    angles = {argument for argument, _, _ in outline.angles.values()}
    if set(range(len(program.arguments))) != {*units, *angles}:
        return ()
    groups = [list(_groups(outline, index, places)) for index, places in enumerate(_places(request))]
    found = []
    try:
        cover = covered(outline, units)
        for result, members in zip(program.results, groups, strict=True):

            def measure(running: Running, enough: float, members: list[Group] = members) -> Array:
                return against_largest(running, members, model.roundoff, enough)

            error = largest(outline, model, cover, measure, BOXES)
            found.append(
                Guarantee(result.name, "largest", _upwards(Fraction(error), COVERED_DIGITS), _inputs(program, units))
            )
    except NoBound:
        return ()
    return tuple(found)


def _inputs(program: Program, units: tuple[int, ...]) -> str:
    """All that is covered: "every unit e and every phi", "all angles"."""
    every = [
        f"every unit {item.name}" if k in units else f"all {item.name}" if item.shape else f"every {item.name}"
        for k, item in enumerate(program.arguments)
    ]
    return " and ".join(every)


def _groups(outline: Outline, result: int, places: tuple[tuple[int, ...], ...]) -> Iterator[Group]:
    entries = outline.entries(result)
    for group in places:
        yield tuple(dict.fromkeys(entries[place] for place in group))


def _units(request: Request) -> tuple[int, ...]:
    """The arguments that are unit vectors of space."""
    subjects = _subjects(request, "unit")
    return tuple(k for k, a in enumerate(request.arguments) if _is_among(a, subjects) and _is_column(a))


def _subjects(request: Request, kind: str) -> set[Node]:
    """What the request assumes to be of a kind."""
    return {h.subjects[0] for h in request.hypotheses if h.kind == kind}


def _is_among(argument: Argument, nodes: set[Node]) -> bool:
    return len(nodes_of(argument)) == 1 and nodes_of(argument)[0] in nodes


def _is_column(argument: object) -> bool:
    return getattr(argument, "shape", None) == (3, 1)


def _places(request: Request) -> tuple[tuple[tuple[int, ...], ...], ...]:
    """The places of each output's entries, those of one physical dimension together."""
    found = []
    for output in request.outputs:
        alike: dict[str, list[int]] = {}
        grid = measured(output.value).grid
        for place, (_, row, column) in enumerate(output.places):
            alike.setdefault(repr(grid[row][column]), []).append(place)
        found.append(tuple(map(tuple, alike.values())))
    return tuple(found)


def _upwards(value: Fraction, to: Decimal) -> str:
    """The numeral, rounded upwards."""
    exact = Decimal(value.numerator) / Decimal(value.denominator) * (1 + Decimal("1e-20"))
    return str(exact.quantize(to, ROUND_CEILING)) if value else "0"


def remembered(manifest: str) -> dict[str, Bound]:
    """The bounds of a manifest's kernels by their hashes. A damaged manifest, or entry, remembers nothing."""
    try:
        kernels = tomllib.loads(manifest).get("kernels", {})
    except tomllib.TOMLDecodeError:
        return {}
    found: dict[str, Bound] = {}
    for kernel in kernels.values() if isinstance(kernels, Mapping) else ():
        try:
            bound = Bound.from_data(kernel["bound"])
        except (KeyError, TypeError, ValueError, AttributeError):
            continue
        found[bound.program] = bound
    return found
