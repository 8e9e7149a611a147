r"""What a formula abbreviates, written out: sums over numbers, \pm on both sides; \in with a set is left out."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import partial

from chasles.reading.atoms import (
    CLOSING,
    OPENING,
    RELATIONS,
    TYPEFACES,
    Atom,
    Atoms,
    everywhere,
    lines_of,
    marks_of,
    single,
)

MOST_TERMS = 12
MOST_MARKS = 5_000
SETS = (r"\in", r"\subset", r"\subseteq")
SIGNS = {r"\pm": "+-", r"\mp": "-+"}
JOINED = {r"\sum": "+", r"\prod": ""}


def written_out(line: Atoms) -> Iterator[Atoms]:
    r"""The equations that a line stands for: two for \pm on both sides of a relation, else one.

    What stands behind \in, as in R = Q^T \in SO(3), says of what kind it is and claims no equality.
    """
    before, *kind = lines_of(line, SETS)
    if kind and any(atom.text in RELATIONS for atom in before):
        line = tuple(before)
    line = _terms_in_full(line)
    sides = lines_of(line, tuple(RELATIONS))
    if len(sides) > 1 and all(SIGNS.keys() & set(marks_of(side)) for side in sides):
        for way in ({sign: said[place] for sign, said in SIGNS.items()} for place in (0, 1)):
            yield everywhere(line, partial(_in_one_way, way))
    else:
        yield line


def _in_one_way(way: Mapping[str, str], atom: Atom) -> Atom:
    return replace(atom, text=way.get(atom.text, atom.text))


def _terms_in_full(line: Atoms) -> Atoms:
    """Sums and products over a few numbers with each term, the innermost first."""
    held = ((atom, tuple(map(_terms_in_full, atom.arguments))) for atom in line)
    line = tuple(replace(atom, arguments=arguments) if arguments else atom for atom, arguments in held)
    for start in range(len(line) - 1, -1, -1):
        if not (bounds := _bounds(line[start])):
            continue
        index, values = bounds
        end = _end_of_term(line, start + 1)
        opening, closing = (single(line[start].place._replace(text=text)) for text in "()")
        terms: list[Atom] = []
        for value in values:
            sign = JOINED[line[start].text] if terms else ""
            terms += [single(line[start].place._replace(text=sign))] if sign else []
            inside = _with(line[start + 1 : end], index, str(value))
            terms += [opening, *inside, closing] if line[start + 1].kind == "SIGN" else inside
        if sum(1 for _ in marks_of((*line, *terms))) > MOST_MARKS:
            return line
        line = (*line[:start], opening, *terms, closing, *line[end:])
    return line


def _bounds(sign: Atom) -> tuple[str, range] | None:
    r"""The index of a sum and its values; None where the bounds are no small numbers."""
    match [*marks_of(sign.sub or ())], [*marks_of(sign.sups[0] if sign.sups else ())]:
        case [index, "=", first], [last] if sign.text in JOINED and first.isdigit() and last.isdigit():
            values = range(int(first), int(last) + 1)
            return (index, values) if 0 < len(values) <= MOST_TERMS else None
    return None


def _end_of_term(line: Atoms, begin: int) -> int:
    """Where the term that begins here is over: before the next sign or bracket that closes."""
    depth = 0
    for place in range(begin, len(line)):
        atom = line[place]
        if depth == 0 and place > begin and atom.kind in ("SIGN", "RELATION", "COMMA", "LAYOUT", "CLOSE"):
            return place
        depth += (atom.text in OPENING) - (atom.text in CLOSING)
    return len(line)


def _with(term: Atoms, index: str, value: str, is_script: bool = False) -> list[Atom]:
    """The term with a number for its index, where that is a letter without a typeface; in brackets but in scripts."""
    found: list[Atom] = []
    for each in term:
        held = [tuple(_with(argument, index, value, is_script)) for argument in each.arguments]
        sups = tuple(tuple(_with(sup, index, value, True)) for sup in each.sups)
        sub = None if each.sub is None else tuple(_with(each.sub, index, value, True))
        arguments = each.arguments if each.text in TYPEFACES else tuple(held)
        atom = replace(each, sub=sub, sups=sups, arguments=arguments)
        number = single(each.place._replace(text=value))
        if each.text != index or each.kind != "LETTER":
            found.append(atom)
        elif is_script:
            found.append(replace(atom, kind="NUMBER", text=value))
        else:
            found += [replace(number, kind="OPEN", text="("), number, replace(atom, kind="CLOSE", text=")")]
    return found
