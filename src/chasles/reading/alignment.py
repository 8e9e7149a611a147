"""The rows of a display as equations: which goes on with the one before, and which number each has."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from chasles.reading import commands
from chasles.reading.atoms import CLOSING, OPENING, Atom, Atoms, marks_of, single
from chasles.reading.grammar import closing
from chasles.reading.lexemes import BadPage, Token, cut, lexemes, spelled
from chasles.reading.respelling import respelled, without_layout

ROW_END = ("\\\\", r"\cr")
WRAPPERS = re.compile(
    r"(?:aligned|split|gathered|multlined|align|gather|eqnarray|equation|multline|x?align(?:ed)?at|flalign)\*?"
)
SYSTEMS = ("array", "matrix", "cases", "dcases")
PAIRED = re.compile(r"x?align(?:ed)?(?:at)?\*?|flalign\*?")
NUMBER = re.compile(r"[A-Z]?[.-]?\d[\w.-]*'*")
PRINTED_NUMBER = re.compile(r"(?:\\q?quad|\\l?eqno|\\hspace\*?\{[^}]*\})\s*[{]?\(?[\w.'-]+\)?[}]?[\s.,;]*$")


class DisplayedEquation(NamedTuple):
    """One row of a display as it stands, or an equation of it, rows that go on with it joined.

    `fault` says why it is not clear whether one does. A row that `is_silent` says that it has no number. An equation
    begins at `place`; before that stands what it shares with the row before.
    """

    raw: list[Token]
    atoms: Sequence[Atom] = ()
    number: str | None = None
    label: str | None = None
    is_silent: bool = False
    is_ended: bool = False
    fault: str = ""
    place: Token = Token("")

    @property
    def latex(self) -> str:
        """Its LaTeX as the page has it, without a number printed at the end."""
        text = PRINTED_NUMBER.sub("", spelled(self.raw))
        aligned = len(cut(self.raw, ("&", *ROW_END))) > 1
        return rf"\begin{{aligned}} {text} \end{{aligned}}" if aligned else text


def rows_of(raw: Sequence[Token], is_split: bool) -> list[DisplayedEquation]:
    """The rows of a display, or the whole as one row; tags and labels are taken out of them."""
    rows = [_row(row) for row in (cut(raw, ROW_END) if is_split else [list(raw)])]
    return [row for row in rows if any(token.text not in (" ", "&", r"\par", "{", "}") for token in row.raw)]


def _row(raw: list[Token]) -> DisplayedEquation:
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
    is_silent = r"\nonumber" in said or r"\notag" in said
    return DisplayedEquation(kept, (), said.get(r"\tag"), said.get(r"\label"), is_silent)


def _end_of_argument(raw: list[Token], at: int) -> int:
    depth = 0
    for end in range(at, len(raw)):
        depth += (raw[end].text == "{") - (raw[end].text == "}")
        if depth <= 0 and raw[end].text == "}":
            return end + 1
    return len(raw)


def equations_of(environment: str, rows: Sequence[DisplayedEquation]) -> list[DisplayedEquation]:
    """The equations of the rows of a display; raises `BadPage` where braces do not match.

    One equation where the display has one row or number: its parts are then set off by a row's end.
    """
    found: list[DisplayedEquation] = []
    for row in rows:
        whole, printed = _trailing_number(respelled(row.raw))
        for line, is_paired in _lines(whole, environment):
            atoms, own = _trailing_number(_without_alignment(line, is_paired))
            kept = without_layout(_opened(atoms))
            if {atom.text for atom in kept}.difference(commands.DOTS):
                is_ended, number = atoms[-1].text in (",", ".", ";"), own or printed or row.number
                new = row._replace(atoms=kept, number=number, is_ended=is_ended, place=atoms[0].place)
                found = _added(found, new, line)
    if len(rows) > 1 or len({equation.number for equation in found}) > 1:
        return found
    return [_joined(found)] if found else []


def atoms_of_equation(latex: str, line: int = 1, column: int = 1) -> Atoms:
    """The atoms of one equation, its parts set off by a row's end; raises `BadPage` for one that is not clear."""
    rows = rows_of(lexemes(latex, line, column), False)[:1]
    (found,) = equations_of("", rows) or [DisplayedEquation([])]
    if found.fault:
        raise BadPage(found.fault, line, column)
    return tuple(found.atoms)


def _added(found: list[DisplayedEquation], new: DisplayedEquation, line: list[Atom]) -> list[DisplayedEquation]:
    """With one more line: an equation of its own, or the last one going on."""
    if not found:
        return [new]
    *before, last = found
    first = next((at for at, atom in enumerate(line) if atom.text not in ("&", r"\quad")), 0)
    sign, has_relation = line[first].text, bool(_relations(new.atoms))
    if sign in commands.IMPLICATIONS:
        return [*found, new]
    goes_on = sign in commands.RELATIONS or not _relations(last.atoms) or _is_open(last.atoms)
    if sign in commands.OPERATORS:
        goes_on |= not has_relation or any(atom.text == "&" for atom in line[:first])
    if not goes_on and (has_relation or last.is_ended or sign.startswith(r"\text{")):
        return [*found, new]
    side = last.atoms[max(_relations(last.atoms), default=-1) + 1 :]
    is_apart = bool(last.number and new.number) and last.number != new.number
    if sign in commands.RELATIONS and is_apart and len(cut(side, (",", r"\quad", *ROW_END))) == 1:
        return [*found, new._replace(atoms=[*side, *new.atoms])]
    fault = "" if goes_on else "a row that neither begins an equation nor goes on with a sign"
    raw = last.raw if last.raw is new.raw else [*last.raw, new.raw[0]._replace(text=r"\\"), *new.raw]
    joined = new._replace(atoms=_continued(last.atoms, new.atoms), raw=raw, fault=last.fault or fault)
    named = joined._replace(number=last.number or new.number, label=last.label or new.label)
    return [*before, named._replace(place=last.place)]


def _continued(before: Sequence[Atom], after: Sequence[Atom]) -> list[Atom]:
    """The atoms of two lines; a sign that ends the one and begins the other is one, and + says no more than -."""
    end, start = before[-1].text, after[0].text
    if (end == start and end != "-" and end in commands.RELATIONS | commands.OPERATORS) or (end, start) == ("+", "-"):
        return [*before[:-1], *after]
    is_said = (end, start) == ("-", "+") or (start in commands.EQUAL and end in commands.EQUAL)
    return [*before, *(after[1:] if is_said else after)]


def _joined(equations: list[DisplayedEquation]) -> DisplayedEquation:
    atoms = list(equations[0].atoms)
    for other in equations[1:]:
        atoms += [single(other.atoms[0].place._replace(text=r"\\")), *other.atoms]
    fault = next((each.fault for each in equations if each.fault), "")
    return equations[0]._replace(atoms=atoms, fault=fault)


def _relations(atoms: Sequence[Atom]) -> list[int]:
    """Where the signs of relation are that stand in no brackets."""
    found, depth = [], 0
    for at, atom in enumerate(atoms):
        depth += _deeper(atom)
        if depth == 0 and atom.kind == "RELATION":
            found.append(at)
    return found


def _opened(atoms: list[Atom]) -> list[Atom]:
    """Without brackets around an equation, a side of it, or what goes on with it, as in x = 2 (= a)."""
    start, outermost = 0, [(0, 0)]  # where brackets that stand in no other begin, and how they end
    while start < len(atoms):
        end = closing(atoms, start) if atoms[start].text == "(" else 0
        outermost += [(start, end)] * (end > outermost[-1][1])
        inside = atoms[start + 1 : end]
        if (places := _relations(inside)) and not atoms[end].is_marked:
            begins = start == 0 or atoms[start - 1].kind == "RELATION"
            ends = not {each.kind for each in atoms[end + 1 : end + 2]} - {"RELATION", "COMMA"}
            if (places[0] == 0 or begins) and (places[-1] == len(inside) - 1 or ends):
                atoms = [*atoms[:start], *inside, *atoms[end + 1 :]]
                outermost = outermost[:-2] or [(0, 0)]  # the bracket before may end at a relation now
                start = outermost[-1][0]
                continue
        start += 1
    return atoms


def _deeper(atom: Atom) -> int:
    return (atom.text in OPENING[:3]) - (atom.text in CLOSING[:3])


def states_relation(atoms: Sequence[Atom]) -> bool:
    """Whether a sign of relation stands in the atoms, in no argument and no script."""
    inside = (each for atom in atoms if atom.kind == "GRID" for each in atom.arguments)
    return any(atom.kind == "RELATION" for atom in atoms) or any(map(states_relation, inside))


def _is_open(atoms: Sequence[Atom]) -> bool:
    """Whether the atoms cannot end there: a bracket is open, or a sign wants another operand."""
    return sum(map(_deeper, atoms)) > 0 or atoms[-1].text in commands.RELATIONS | commands.OPERATORS


def _rows(atoms: Sequence[Atom]) -> list[list[Atom]]:
    return [row for row in cut(atoms, ROW_END) if {atom.text for atom in row} - {"&", r"\quad"}]


def _lines(atoms: list[Atom], environment: str) -> Iterator[tuple[list[Atom], bool]]:
    """The rows inside where the whole aligns equations or is a system of them, and whether & parts them in pairs."""
    while atoms and atoms[0].text in ROW_END:
        atoms = atoms[1:]
    whole = without_layout(atoms)
    inside: Sequence[Atom] = atoms
    has_brace = len(whole) > 1 and whole[0].text == r"\{"
    if len(whole) == 1 + has_brace and whole[-1].kind == "GRID" and not whole[-1].is_marked:
        name, rows = whole[-1].text, _rows(whole[-1].arguments[0])
        is_system = (has_brace or "cases" in name) and name in SYSTEMS and _are_equations(rows)
        bare = rows[:1] if name == "array" else rows if name == "matrix" else []
        is_system = is_system or (not has_brace and bool(bare) and all(map(_relations, bare)))
        if WRAPPERS.fullmatch(name) or is_system:
            inside, environment = whole[-1].arguments[0], name
    elif (place := next((at for at, each in enumerate(whole) if _aligns_equations(each)), -1)) >= 0:
        inside, environment = _spliced(whole, place) or inside, whole[place].text
    rows = _rows(inside)
    if inside is atoms and len(rows) < 2:
        yield (rows or [[]])[0], bool(PAIRED.fullmatch(environment))
    else:
        for row in rows:
            yield from _lines(row, environment)


def _aligns_equations(atom: Atom) -> bool:
    """Whether it is an environment with a relation in each row, as a whole."""
    is_system = bool(WRAPPERS.fullmatch(atom.text)) or atom.text in SYSTEMS[2:]
    return atom.kind == "GRID" and not atom.is_marked and is_system and _are_equations(_rows(atom.arguments[0]))


def _are_equations(rows: Sequence[Sequence[Atom]]) -> bool:
    """Whether each row states a relation, or goes on with a sign behind one that does."""
    return bool(rows and _relations(rows[0])) and all(_relations(row) or _goes_on(row) for row in rows)


def _goes_on(row: Sequence[Atom]) -> bool:
    """Whether it begins with a sign of operation."""
    first = next((atom for atom in without_layout(row) if atom.text != "&"), None)
    return first is not None and first.text in commands.OPERATORS


def _spliced(atoms: list[Atom], place: int) -> list[Atom]:
    """Its rows with what stands before the environment and behind it; nothing where they go on with a sign."""
    before, behind = atoms[:place], atoms[place + 1 :]
    if before and _is_open(before):
        return []
    behind = behind[1:] if behind and behind[0].kind == "CLOSE" else behind
    end, gap = (single(atoms[place].place._replace(text=sign)) for sign in (ROW_END[0], r"\quad"))
    inside = [*before, end if _relations(before) else gap, *atoms[place].arguments[0]]
    return [*inside, *([gap] if behind and behind[0].kind != "RELATION" else []), *behind]


def _without_alignment(line: list[Atom], is_paired: bool) -> list[Atom]:
    """Without marks of alignment; they part equations in pairs, in cells of their own, or behind a heading."""
    cells = cut(line, ("&",))
    found = list(cells[0])
    for number, cell in enumerate(cells[1:], 1):
        places = _relations(cell)
        are_whole = bool(places) and places[0] > 0 and bool(_relations(cells[number - 1][1:-1]))
        is_headed = bool(found) and found[-1].text == ":"
        if ((is_paired and number % 2 == 0) or are_whole or is_headed) and found:
            found.append(single(found[-1].place._replace(text=r"\quad")))
        found += cell
    return found


def _trailing_number(line: list[Atom]) -> tuple[list[Atom], str | None]:
    """The line without the number printed at its end after a space, and that number."""
    end = len(line)
    while end and line[end - 1].text in (",", ".", ";", r"\quad"):
        end -= 1
    start = max((at for at in range(end) if line[at].text in (r"\quad", r"\eqno", r"\leqno")), default=-1)
    text = "".join(marks_of(line[start + 1 : end]))
    text = text[6:-1] if text.startswith(r"\text{") else text
    if start >= 0 and text[:1] == "(" and text[-1:] == ")" and NUMBER.fullmatch(text[1:-1]):
        return line[:start], text[1:-1]
    return line, None
