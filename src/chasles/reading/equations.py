"""Printed equations to words: lines and commas apart, chains of relations, every reading whose sides fit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from chasles.reading.alignment import atoms_of_equation
from chasles.reading.atoms import RELATIONS, Atoms, Unread
from chasles.reading.context import FittingContext
from chasles.reading.fits import MOST, UNUSUAL, Fit, letters_agree
from chasles.reading.grammar import Chain, formula
from chasles.reading.lexemes import BadPage
from chasles.reading.page_functions import functions_in, shown_alone
from chasles.reading.page_notation import PageNotation
from chasles.reading.printed import PrintedEquation
from chasles.reading.reading import Part, ReadEquation, Reading, settled
from chasles.reading.respelling import atoms_in
from chasles.reading.segments import chains_of, segments
from chasles.reading.summed_indices import index_letters, summed_over
from chasles.reading.sums import sum_fits
from chasles.vocabulary import Misfit, Node, Rate, Symbol, symbols_of, walk
from chasles.vocabulary.fitting import measured
from chasles.vocabulary.measure import added

NO_CLAIM = (r"\in", r"\ni", r"\subset", r"\subseteq", r"\models", r"\mapsto")
MOST_READINGS = 6


@dataclass(frozen=True, slots=True)
class PrintedChain:
    """One chain of relations that begins on a line; a condition is what stands behind a word such as "for"."""

    chain: Chain
    is_condition: bool
    line: int


def read_equations(printed: Sequence[PrintedEquation], notation: PageNotation) -> tuple[ReadEquation, ...]:
    """Each printed equation with its readings; one that begins with a relation goes on with the side before."""
    found: list[ReadEquation] = []
    before: Atoms | None = None
    chains = [chain for equation in printed for chain in chains_of(equation)]
    functions, alone, numbering = functions_in(chains), shown_alone(chains), index_letters(chains)
    notation = replace(notation, functions=functions, alone=alone, numbering=numbering)
    for equation in printed:
        try:
            marks, here = _as_noted(equation, notation), notation.within(equation.section)
            read, before = _read(equation, marks, before, here)
        except Unread as problem:
            read = ReadEquation(equation, (), str(problem), problem.place.column if problem.place else None)
        except BadPage as problem:
            read = ReadEquation(equation, (), str(problem), problem.column)
        except RecursionError:
            read = ReadEquation(equation, (), "it is too long, or nested too deep: write it as several")
        found.append(read)
    return settled(found)


def expressions(latex: str, notation: PageNotation) -> list[Node]:
    """The readings of one expression that are well formed; raises `Unread` where there is none."""
    ctx = _context(notation, 0)
    chain = formula(atoms_in(latex))
    if chain.relations or chain.sides[0] is None:
        raise Unread("expected one expression without a relation")
    fits = ctx.terms(chain.sides[0])
    found = [fit.node for each in fits if (fit := each.sized_as(each.usual)) and fit.node is not None]
    if not found:
        raise ctx.problems[0] if ctx.problems else Unread("its parts do not fit together")
    return found


def _context(notation: PageNotation, level: int, where: str = "") -> FittingContext:
    ctx = FittingContext(notation, level, where)
    ctx.terms = lambda terms: sum_fits(terms, ctx)
    return ctx


def _as_noted(equation: PrintedEquation, notation: PageNotation) -> Atoms:
    """The atoms of the equation, or of what the notation says that the print should be."""
    for name in (equation.number, equation.label):
        if name is not None and "reading" in notation.notes.get(name, {}):
            return atoms_of_equation(notation.notes[name]["reading"])
    return equation.atoms


def _read(
    equation: PrintedEquation, marks: Atoms, before: Atoms | None, notation: PageNotation
) -> tuple[ReadEquation, Atoms | None]:
    lines = [line for line in segments(marks) if line[0]]
    chains = [
        PrintedChain(formula(line), condition, max(equation.line, line[0].place.line))
        for line, condition in lines
        if not _is_range(line, notation)
    ]
    if chains and chains[0].chain.sides[0] is None and before:
        whole = (*before, *lines[0][0])
        chains[0] = replace(chains[0], chain=formula(whole))
        lines[0] = whole, lines[0][1]
    if not any(said.chain.relations for said in chains):
        raise Unread("no relation stands in it", marks[0].place if marks else None)
    for level in range(3):
        ctx = _context(notation, level, f"{equation.file}:{equation.line}:{equation.column}")
        readings = _readings(chains, ctx)
        if readings or (level and ctx.problems):
            break
    if not readings:
        raise (
            ctx.problems[0]
            if ctx.problems
            else Unread("no reading of it fits together and prints the same again", None)
        )
    last = ([line for line, condition in lines if not condition] or [lines[-1][0]])[-1]
    end = max((k for k, mark in enumerate(last) if mark.text in RELATIONS), default=-1)
    return ReadEquation(equation, tuple(readings)), last[end + 1 :]


def _is_range(marks: Atoms, notation: PageNotation) -> bool:
    """Whether it says what indices run over."""
    left = [mark.text for mark in marks if mark.text not in ("=", r"\dots", r"\ldots", r"\in", ".")]
    names = [text for text in left if not text.isdigit()]
    return bool(names) and len(names) < len(left) and all(name in notation.indices for name in names)


def _readings(chains: list[PrintedChain], ctx: FittingContext) -> list[Reading]:
    """The readings of all chains together, the usual ones first."""
    partial: list[tuple[int, tuple[Part, ...], tuple[Part, ...]]] = [(0, (), ())]
    for said in chains:
        found = _chain(said, ctx)
        if said.is_condition:
            if not found:
                raise ctx.problems[-1] if ctx.problems else Unread("what it holds for cannot be read")
            partial = [(cost, parts, (*given, *found[0][1])) for cost, parts, given in partial]
            continue
        partial = [(cost + more, (*parts, *new), given) for cost, parts, given in partial for more, new in found]
        partial = sorted(partial, key=lambda each: each[0])[: MOST * 2]
    weighed = sorted(((cost + _unusual(parts), parts, given) for cost, parts, given in partial),
                     key=lambda each: each[0])  # fmt: skip
    return [Reading(parts, given) for cost, parts, given in weighed if cost < weighed[0][0] + UNUSUAL][:MOST_READINGS]


def _unusual(parts: tuple[Part, ...]) -> int:
    """What it costs that letters, or a letter and a function, are two quantities, or that what rests has a rate."""
    letters: dict[str, set[Symbol]] = {}
    constant = 0
    for node in (node for part in parts for side in (part.left, part.right) for node in walk(side)):
        if isinstance(node, Symbol):
            letters.setdefault(node.letter, set()).add(node)
        elif isinstance(node, Rate):
            constant += all(symbol.constant for symbol in symbols_of(node))
    twice = sum("(" in each and each.partition("(")[0] in letters for each in letters)
    return 5 * (twice + sum(len(symbols) - 1 for symbols in letters.values())) + 3 * bool(constant)


def _chain(said: PrintedChain, ctx: FittingContext) -> list[tuple[int, tuple[Part, ...]]]:
    """The chain as relations between neighbours, all sides of one shape and of dimensions that agree."""
    chain = said.chain
    if not chain.relations:
        raise Unread("no relation stands here", None)
    if chain.sides[0] is None:
        raise Unread("the left side is missing", chain.relations[0])
    signs = [RELATIONS.get(relation.text, relation.text) for relation in chain.relations]
    unknown = next((r for r in chain.relations if r.text in NO_CLAIM), None)
    if unknown:
        raise Unread(f"{unknown.text} claims nothing that can be decided", unknown)
    ctx.summed = summed_over(chain, ctx.notation.numbering - ctx.notation.indices.keys())
    sides = [ctx.terms(side) for side in chain.sides if side is not None]
    if not all(sides):
        return []
    places = [(sign, max(said.line, chain.relations[k].line if k else 0)) for k, sign in enumerate(signs)]
    found: list[tuple[int, tuple[Part, ...]]] = []
    shapes = dict.fromkeys(fit.shape for fits in sides for fit in fits if fit.shape)
    squares = [(size, size) for size in sorted(ctx.notation.sizes) if size > 1]
    for shape in (*shapes, *(each for each in squares if each not in shapes)):
        at = [[fit for each in fits if (fit := each.at(shape)) is not None] for fits in sides]
        chosen: list[tuple[Fit, ...]] = [()]
        for fits in at:
            chosen = [(*before, fit) for before in chosen for fit in fits if not before or _agree(before[-1], fit)]
            chosen = sorted(chosen, key=_unlikely)[: MOST * 2]
        found += [(sum(fit.cost for fit in each), _parts(each, places)) for each in chosen]
    if not found and ctx.tolerant:
        firsts = [next((fit for fit in fits if fit.node is not None), fits[0]) for fits in sides]
        firsts = [fit.sized_as((3, 3)) or fit for fit in firsts]
        if any(ctx.mixes(one, other) for one, other in pairwise(firsts)):
            return []
        if all(fit.node is not None for fit in firsts):
            found = [(0, _parts(tuple(firsts), places))]
    return found


def _unlikely(sides: tuple[Fit, ...]) -> tuple[bool, int]:
    agree = letters_agree(*(fit.node for fit in sides if fit.node is not None))
    return not agree, sum(fit.cost for fit in sides)


def _agree(one: Fit, other: Fit) -> bool:
    return one.node is not None and other.node is not None and not _fault(one.node, other.node)


def _parts(sides: tuple[Fit, ...], signs: list[tuple[str, int]]) -> tuple[Part, ...]:
    nodes = [fit.node for fit in sides if fit.node is not None]
    return tuple(
        Part(left, sign, right, _fault(left, right), line)
        for (left, right), (sign, line) in zip(pairwise(nodes), signs, strict=True)
    )


def _fault(left: Node, right: Node) -> str:
    """Why the two sides cannot be equal, or stand in another relation; empty if they can."""
    try:
        added(measured(left), measured(right), (left, right), "equate")
    except Misfit as misfit:
        return str(misfit)
    return ""
