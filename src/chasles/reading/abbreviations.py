r"""What a formula abbreviates, written out: sums over numbers, \pm on both sides; \in with a set is left out."""

from __future__ import annotations

from collections.abc import Iterator

from chasles.reading.grouping import RELATIONS, Tokens, closing, lines_of
from chasles.reading.lexemes import Token

MOST_TERMS = 12
MOST_TOKENS = 5_000
KINDS = (r"\in", r"\subset")
SIGNS = {r"\pm": "+-", r"\mp": "-+"}
JOINED = {r"\sum": "+", r"\prod": ""}
SIGNED = frozenset({"+", "-"})
ENDS = frozenset({*RELATIONS, "+", "-", r"\pm", r"\mp", ",", ";", r"\quad", "&", r"\\", ")", "]", r"\}", "}"})


def written_out(line: Tokens) -> Iterator[Tokens]:
    r"""The equations that a line stands for: two for \pm on both sides of a relation, else one.

    What stands behind \in, as in R = Q^T \in SO(3), says of what kind it is and claims no equality.
    """
    before, *kind = lines_of(line, KINDS)
    if kind and any(token.text in RELATIONS for token in before):
        line = tuple(before)
    line = _terms_in_full(line)
    sides = lines_of(line, tuple(RELATIONS))
    if len(sides) > 1 and all(any(token.text in SIGNS for token in side) for side in sides):
        for way in (0, 1):
            yield tuple(token._replace(text=SIGNS.get(token.text, (token.text,) * 2)[way]) for token in line)
    else:
        yield line


def _terms_in_full(line: Tokens) -> Tokens:
    """Sums and products over a few numbers with each term, the innermost first."""
    for start in range(len(line) - 1, -1, -1):
        if line[start].text in JOINED and (bounds := _bounds(line, start)):
            index, values, begin = bounds
            end = _end_of_term(line, begin)
            terms: list[Token] = []
            around = [line[start]._replace(text=text) for text in "()"]
            for value in values:
                sign = JOINED[line[start].text] if terms else ""
                terms += [line[start]._replace(text=sign)] if sign else []
                inside = _with(line[begin:end], index, str(value))
                terms += [around[0], *inside, around[1]] if line[begin].text in SIGNED else inside
            if len(line) + len(terms) > MOST_TOKENS:
                return line
            line = (*line[:start], around[0], *terms, around[1], *line[end:])
    return line


def _bounds(line: Tokens, start: int) -> tuple[str, range, int] | None:
    r"""The index of a sum, its values, and where its term begins; None where the bounds are no small numbers."""
    texts = [token.text for token in line[start + 1 : start + 10]]
    match texts:
        case ["_", "{", index, "=", first, "}", "^", "{", last] if first.isdigit() and last.isdigit():
            values = range(int(first), int(last) + 1)
            is_closed = len(line) > start + 10 and line[start + 10].text == "}"
            return (index, values, start + 11) if is_closed and 0 < len(values) <= MOST_TERMS else None
    return None


def _end_of_term(line: Tokens, begin: int) -> int:
    """Where the term that begins here is over: before the next sign or bracket that closes."""
    depth, place = 0, begin
    while place < len(line):
        text = line[place].text
        if depth == 0 and place > begin and (text in ENDS or text.startswith(r"\end")):
            break
        place = closing(line, place) if text == "{" or text.startswith(r"\begin{") else place
        depth += (text in ("(", "[", r"\{")) - (text in (")", "]", r"\}"))
        place += 1
    return place


def _with(term: Tokens, index: str, value: str) -> Iterator[Token]:
    """The term with a number for its index, where that is a letter without a typeface; in brackets but in scripts."""
    groups = [""]
    for place, token in enumerate(term):
        if token.text == "{":
            groups.append(term[place - 1].text if place and groups[-1] not in ("_", "^") else groups[-1])
        is_index = token.text == index and not groups[-1].startswith((r"\math", r"\bold"))
        is_bare = is_index and groups[-1] not in ("_", "^")
        yield from (token._replace(text=text) for text in (("(", value, ")") if is_bare else (value,) * is_index))
        yield from (token,) * (not is_index)
        if token.text == "}" and len(groups) > 1:
            groups.pop()
