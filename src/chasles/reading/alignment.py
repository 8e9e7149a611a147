"""The rows of a display as equations: which goes on with the one before, and which number each has."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from chasles.reading import commands
from chasles.reading.atoms import respelled
from chasles.reading.grouping import closing
from chasles.reading.lexemes import BadPage, Token, cut, lexemes, spelled
from chasles.reading.tokens import without_layout

ROW_END = ("\\\\", r"\cr")
WRAPPERS = re.compile(
    r"(?:aligned|split|gathered|multlined|align|gather|eqnarray|equation|multline|x?align(?:ed)?at|flalign)\*?"
)
SYSTEMS = ("array", "matrix", "cases", "dcases")
PAIRED = re.compile(r"x?align(?:ed)?(?:at)?\*?|flalign\*?")
DOTS = {r"\vdots", r"\dots", r"\ldots", r"\cdots"}
NUMBER = re.compile(r"[A-Z]?[.-]?\d[\w.-]*'*")
PRINTED_NUMBER = re.compile(r"(?:\\q?quad|\\l?eqno|\\hspace\*?\{[^}]*\})\s*[{]?\(?[\w.'-]+\)?[}]?[\s.,;]*$")
BEGIN = re.compile(r"\\begin\{(\w+\*?)\}$")
OPENING = re.compile(r"[{(\[]$|\\\{$|\\begin\b")
CLOSING = re.compile(r"[})\]]$|\\\}$|\\end\b")


class DisplayRow(NamedTuple):
    """A row of a display as it stands, with what it says of its number."""

    raw: list[Token]
    tag: str | None = None
    label: str | None = None
    is_silent: bool = False


class DisplayedEquation(NamedTuple):
    """One equation of a display, rows that go on with it joined; `fault` says why it is not clear whether one does.

    It begins at `place`; before that stands what it shares with the row before.
    """

    tokens: list[Token]
    raw: list[Token]
    number: str | None = None
    label: str | None = None
    is_ended: bool = False
    fault: str = ""
    place: Token = Token("")

    @property
    def latex(self) -> str:
        """Its LaTeX as the page has it, without a number printed at the end."""
        text = PRINTED_NUMBER.sub("", spelled(self.raw))
        aligned = len(cut(self.raw, ("&", *ROW_END))) > 1
        return rf"\begin{{aligned}} {text} \end{{aligned}}" if aligned else text


def rows_of(raw: Sequence[Token], is_split: bool) -> list[DisplayRow]:
    """The rows of a display, or the whole as one row; tags and labels are taken out of them."""
    rows = [_row(row) for row in (cut(raw, ROW_END) if is_split else [list(raw)])]
    return [row for row in rows if any(token.text not in (" ", "&", r"\par", "{", "}") for token in row.raw)]


def _row(raw: list[Token]) -> DisplayRow:
    kept: list[Token] = []
    said: dict[str, str] = {}
    at = 0
    while at < len(raw):
        text, at = raw[at].text, at + 1
        if text in (r"\tag", r"\label", r"\nonumber", r"\notag"):
            end = _end_of_argument(raw, at) if text in (r"\tag", r"\label") else at
            said[text], at = re.sub(r"^\*?\s*\{|\}$", "", spelled(raw[at:end])).strip("()$ "), end
        else:
            kept.append(raw[at - 1])
    return DisplayRow(kept, said.get(r"\tag"), said.get(r"\label"), r"\nonumber" in said or r"\notag" in said)


def _end_of_argument(raw: list[Token], at: int) -> int:
    depth = 0
    for end in range(at, len(raw)):
        depth += (raw[end].text == "{") - (raw[end].text == "}")
        if depth <= 0 and raw[end].text == "}":
            return end + 1
    return len(raw)


def equations_of(
    environment: str, rows: Sequence[DisplayRow], numbers: Sequence[str | None]
) -> list[DisplayedEquation]:
    """The equations of a display, each row's number given; raises `BadPage` where braces do not match.

    One equation where the display has one row or number: its parts are then set off by a row's end.
    """
    found: list[DisplayedEquation] = []
    for row, counted in zip(rows, numbers, strict=True):
        whole, printed = _trailing_number(respelled(row.raw))
        for line, is_paired in _lines(whole, environment):
            tokens, own = _trailing_number(_without_alignment(line, is_paired))
            number = own or printed or row.tag or counted
            kept = without_layout(tokens)
            if {token.text for token in kept} - DOTS:
                is_ended = tokens[-1].text in ",.;"
                new = DisplayedEquation(kept, row.raw, number, row.label, is_ended, place=tokens[0])
                found = _added(found, new, line)
    if len(rows) > 1 or len({equation.number for equation in found}) > 1:
        return found
    return [_joined(found)] if found else []


def tokens_of_equation(latex: str, line: int = 1, column: int = 1) -> tuple[Token, ...]:
    """The tokens of one equation, its parts set off by a row's end; raises `BadPage` for one that is not clear."""
    rows = rows_of(lexemes(latex, line, column), False)[:1]
    (found,) = equations_of("", rows, [None] * len(rows)) or [DisplayedEquation([], [])]
    if found.fault:
        raise BadPage(found.fault, line, column)
    return tuple(found.tokens)


def _added(found: list[DisplayedEquation], new: DisplayedEquation, line: list[Token]) -> list[DisplayedEquation]:
    """With one more line: an equation of its own, or the last one going on."""
    if not found:
        return [new]
    *before, last = found
    first = next((at for at, token in enumerate(line) if token.text not in ("&", r"\quad")), 0)
    sign, has_relation = line[first].text, bool(_relations(new.tokens))
    if sign in commands.IMPLICATIONS:
        return [*found, new]
    goes_on = sign in commands.RELATIONS or not _relations(last.tokens) or _is_open(last.tokens)
    if sign in commands.OPERATORS:
        goes_on |= not has_relation or any(token.text == "&" for token in line[:first])
    if not goes_on and (has_relation or last.is_ended or sign.startswith(r"\text{")):
        return [*found, new]
    side = last.tokens[max(_relations(last.tokens), default=-1) + 1 :]
    is_apart = bool(last.number and new.number) and last.number != new.number
    if sign in commands.RELATIONS and is_apart and len(cut(side, (",", r"\quad", *ROW_END))) == 1:
        return [*found, new._replace(tokens=[*side, *new.tokens])]
    fault = "" if goes_on else "a row that neither begins an equation nor goes on with a sign"
    raw = last.raw if last.raw is new.raw else [*last.raw, new.raw[0]._replace(text=r"\\"), *new.raw]
    joined = new._replace(tokens=_continued(last.tokens, new.tokens), raw=raw, fault=last.fault or fault)
    named = joined._replace(number=last.number or new.number, label=last.label or new.label)
    return [*before, named._replace(place=last.place)]


def _continued(before: list[Token], after: list[Token]) -> list[Token]:
    """The tokens of two lines; a sign that ends the one and begins the other is one, and + says no more than -."""
    end, start = before[-1].text, after[0].text
    if end == start and end != "-" and end in commands.RELATIONS | commands.OPERATORS:
        return [*before[:-1], *after]
    if end == "+" and start == "-":
        return [*before[:-1], *after]
    return [*before, *(after[1:] if (end, start) == ("-", "+") else after)]


def _joined(equations: list[DisplayedEquation]) -> DisplayedEquation:
    tokens = list(equations[0].tokens)
    for other in equations[1:]:
        tokens += [other.tokens[0]._replace(text=r"\\"), *other.tokens]
    fault = next((each.fault for each in equations if each.fault), "")
    return equations[0]._replace(tokens=tokens, fault=fault)


def _relations(tokens: Sequence[Token]) -> list[int]:
    """Where the signs of relation are that stand in no brackets."""
    found, depth = [], 0
    for at, token in enumerate(tokens):
        depth += bool(OPENING.match(token.text)) - bool(CLOSING.match(token.text))
        if depth == 0 and token.text in commands.RELATIONS:
            found.append(at)
    return found


def states_relation(tokens: Sequence[Token]) -> bool:
    """Whether a sign of relation stands in the tokens, in no argument and no script."""
    depth = 0
    for token in tokens:
        depth += (token.text == "{") - (token.text == "}")
        if depth == 0 and token.text in commands.RELATIONS:
            return True
    return False


def _is_open(tokens: Sequence[Token]) -> bool:
    """Whether the tokens cannot end there: a bracket is open, or a sign wants another operand."""
    depth = sum(bool(OPENING.match(token.text)) - bool(CLOSING.match(token.text)) for token in tokens)
    return depth > 0 or tokens[-1].text in commands.RELATIONS | commands.OPERATORS


def _lines(tokens: list[Token], environment: str) -> Iterator[tuple[list[Token], bool]]:
    """The rows inside where the whole aligns equations or is a system of them, and whether & parts them in pairs."""
    while tokens and tokens[0].text in ROW_END:
        tokens = tokens[1:]
    bare = without_layout(tokens)
    inside = tokens
    start = int(len(bare) > 1 and bare[0].text == r"\{")
    begin = BEGIN.match(bare[start].text) if bare else None
    if begin and closing(bare, start) == len(bare) - 1:
        name = begin[1]
        rows = [row for row in cut(bare[start + 1 : -1], ROW_END) if {token.text for token in row} - {"&", r"\quad"}]
        is_system = (start > 0 or "cases" in name) and name in SYSTEMS and all(map(_relations, rows))
        is_system = is_system or (name == "array" and not start and bool(rows) and bool(_relations(rows[0])))
        if WRAPPERS.fullmatch(name) or is_system:
            inside, environment = bare[start + 1 : -1], name
    rows = [row for row in cut(inside, ROW_END) if {token.text for token in row} - {"&", r"\quad"}]
    if inside is tokens and len(rows) < 2:
        yield (rows or [[]])[0], bool(PAIRED.fullmatch(environment))
    else:
        for row in rows:
            yield from _lines(row, environment)


def _without_alignment(line: list[Token], is_paired: bool) -> list[Token]:
    """Without marks of alignment; they part equations where these come in pairs, or stand in cells of their own."""
    cells = cut(line, ("&",))
    found = list(cells[0])
    for number, cell in enumerate(cells[1:], 1):
        places = _relations(cell)
        are_whole = bool(places) and places[0] > 0 and bool(_relations(cells[number - 1][1:-1]))
        if ((is_paired and number % 2 == 0) or are_whole) and found:
            found.append(found[-1]._replace(text=r"\quad"))
        found += cell
    return found


def _trailing_number(line: list[Token]) -> tuple[list[Token], str | None]:
    """The line without the number printed at its end after a space, and that number."""
    end = len(line)
    while end and line[end - 1].text in (",", ".", ";", r"\quad"):
        end -= 1
    start = max((at for at in range(end) if line[at].text in (r"\quad", r"\eqno", r"\leqno")), default=-1)
    text = "".join(token.text for token in line[start + 1 : end])
    text = text[6:-1] if text.startswith(r"\text{") else text
    if start >= 0 and text[:1] == "(" and text[-1:] == ")" and NUMBER.fullmatch(text[1:-1]):
        return line[:start], text[1:-1]
    return line, None
