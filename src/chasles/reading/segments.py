"""What stands side by side or line by line in an equation: chains of relations, conditions, and what is left out."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from chasles.reading.abbreviations import SETS, written_out
from chasles.reading.atoms import RELATIONS, Atom, Atoms, Unread, lines_of, single
from chasles.reading.commands import DOTS, IMPLICATIONS
from chasles.reading.grammar import Chain, closing, formula
from chasles.reading.lexemes import BadPage, cut
from chasles.reading.printed import PrintedEquation
from chasles.reading.spellings import is_extremum

CONDITIONS = re.compile(r"(?:(?:for|if|when|where|provided|with|as|in|on|at|over)\b|i\.e\.)", re.IGNORECASE)
PROSE = re.compile(r"(?:is|are|being)\b")
"""What words begin with that say something of what stands before them."""
UPRIGHT = re.compile(r"\\operatorname\{(and|where|with|for|if|otherwise|when|or|subject|such|that|to)\}")
ABBREVIATIONS = [[*"s.t."], [*"i.e."], [*"w.r.t."]]
LEFT_OUT = (*DOTS, "..")


def segments(marks: Atoms) -> list[tuple[Atoms, bool]]:
    """What stands side by side or line by line, and whether it is a condition, without what says of what kind it is."""
    found: list[tuple[Atoms, bool]] = []
    is_problem = False  # what is to be made least, and the words behind it, claim nothing
    for line in filter(None, lines_of(marks, (r"\\",))):
        condition = is_used = for_all = False
        pieces = _side_by_side(line)
        for (part, word), (_, behind) in pairwise((*pieces, ([], ""))):
            condition = condition and not (is_used and word == "quad" and "=" in _relations(part))
            condition = condition or bool(CONDITIONS.match(word) and (found or word.lower() not in ("where", "with")))
            is_used = condition and (is_used or bool(part))
            for_all = for_all or word == "forall"
            if word == "forall" or (for_all and not _relations(part)):
                continue
            is_problem |= bool(part) and is_extremum(tuple(part)) and not _relations(part)
            if is_problem and not _relations(part):
                continue
            if not _relations(part) and (PROSE.match(behind) or [token.text for token in part] in ABBREVIATIONS):
                continue
            if {word, behind} <= {"", "quad"} and _is_heading(part):
                continue
            is_prose = condition and CONDITIONS.match(word) and not _relations(part)
            if (part and part[-1].text == ":") or is_prose:  # a heading, or as in "for small angles"
                continue
            in_brackets = bool(found and _relations(part[1:-1]) and closing(part) == len(part) - 1)
            mapped = cut(part[1:-1] if in_brackets else part, (r"\mapsto",))
            *before, last = cut(mapped[-1] if _relations(mapped[-1]) else part, tuple(IMPLICATIONS))
            found += [(tuple(each), True) for each in before if each]
            found += [(tuple(last), condition or in_brackets)] if last else []
    found = _joined_lists(found)
    found = [each for each in found if not _lists_values(each[0])] if len(found) > 1 else found
    if not all(_is_membership(part) for part, _ in found):
        found = [each for each in found if not _is_membership(each[0])]
    return [(full, condition) for part, condition in found for full in written_out(_ended(part))]


def _ended(part: Atoms) -> Atoms:
    """Without a sign of relation at the end, behind which nothing stands on the page."""
    return part[:-1] if len(part) > 1 and part[-1].kind == "RELATION" else part


def chains_of(equation: PrintedEquation) -> list[Chain]:
    """What stands side by side or line by line in the equation; nothing where that cannot be read."""
    try:
        return [formula(line) for line, _ in segments(equation.atoms) if line]
    except (Unread, BadPage):
        return []


def _relations(part: Sequence[Atom]) -> list[str]:
    return [token.text for token in part if token.text in RELATIONS]


def _is_heading(part: Sequence[Atom]) -> bool:
    """Whether it is one upright word, as before a formula or between two."""
    return len(part) == 1 and bool(re.match(r"\\operatorname\{\w{2,}\}$", part[0].text)) and not part[0].is_marked


def _is_membership(part: Atoms) -> bool:
    r"""Whether it says of what kind something is, and nothing else: x \in A, f : A \to B."""
    is_function = any(atom.text == ":" for atom in part) and _relations(part) in ([r"\to"], [r"\rightarrow"])
    return is_function or (_relations(part)[:1] == [r"\in"] and set(SETS).issuperset(_relations(part)))


def _lists_values(part: Atoms) -> bool:
    """Whether it says which values letters run through, as i = 1, 2, 3 and j = 1, ..., n do; x = 1 + ... is a sum."""
    sides = lines_of(part, ("=", r"\in"))
    before = lines_of(sides[-1], LEFT_OUT)[:-1]
    runs = any(each and each[-1].kind != "SIGN" for each in before)
    return len(sides) == 2 and (runs or len(lines_of(sides[1], (",",))) > 1)


def _side_by_side(line: list[Atom]) -> list[tuple[list[Atom], str]]:
    """The parts between commas, wide spaces and words, each with the words before it."""
    parts: list[tuple[list[Atom], str]] = [([], "")]
    line = [atom if atom.is_marked else replace(atom, text=UPRIGHT.sub(r"\\text{\1}", atom.text)) for atom in line]
    words = tuple({mark.text for mark in line if mark.text.startswith(r"\text{")})
    marks = (",", ";", r"\quad", r"\forall", *words)
    place = 0
    for part in lines_of(line, marks):
        mark = line[place - 1].text if place else ""
        parts.append((part, mark[6:-1] if mark.startswith(r"\text{") else mark.strip("\\")))
        place += len(part) + 1
    return parts


def _are_values(marks: Atoms) -> bool:
    return all(mark.text.isdigit() or mark.text in LEFT_OUT for mark in marks)


def _joined_lists(parts: list[tuple[Atoms, bool]]) -> list[tuple[Atoms, bool]]:
    """Parts without a relation, such as the i and the 2 of i, j = 1, 2, belong to the part behind or before."""
    found: list[tuple[Atoms, bool]] = []
    waiting: Atoms = ()
    for marks, condition in parts:
        comma = single(marks[0].place._replace(text=","))
        if _relations(marks) or any(mark.text == ":" for mark in marks):
            is_closed = not closing((replace(comma, text="("), *marks))
            found.append(((*(waiting if is_closed else waiting[:-1]), *marks), condition))
            waiting = ()
        elif found and marks[0].text in "+-":
            found[-1] = (*found[-1][0], *marks), found[-1][1]
        elif found and (found[-1][0][-1].text in LEFT_OUT or _are_values(marks)):
            found[-1] = (*found[-1][0], comma, *marks), found[-1][1]
        else:
            waiting = (*waiting, *marks, comma)
    if waiting and not found:
        found.append((waiting[:-1], False))
    elif waiting:
        raise Unread("what stands here is no equation", waiting[0].place)
    return found
