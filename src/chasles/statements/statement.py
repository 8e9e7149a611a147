"""The roles a printed equation can play: it defines, it restricts, it is postulated, or it claims and is decided."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from dataclasses import replace as with_fields
from typing import ClassVar, Self

from chasles.display import Displayed
from chasles.statements.forms import Form
from chasles.statements.hypotheses import Hypothesis
from chasles.statements.kernel import Kernel, nodes_of
from chasles.vocabulary import At, Group, Misfit, Node, Rate, Symbol, plain, replace, undotted
from chasles.vocabulary.arguments import Declared, WrongArgument
from chasles.vocabulary.measure import added

Equation = tuple[Node, Node]


@dataclass(frozen=True, eq=False)
class Statement(Declared, Displayed):
    """An equation of the book, exactly as printed, with what it rests on.

    `number` is the book's; `part` tells apart the equations of one number. `given` names earlier statements, `assuming`
    named hypotheses. `reading` is the equation's right side (or both sides) where a mark was lost in the scan,
    `corrected` what is right where it is wrong as printed and no repair is found: each is decided too, and used in its
    place. `sic` marks what does not fit together and is printed so. Raises `Misfit` if the sides do not fit
    together and nothing says that this is no mistake of the declaration: no `sic`, no reading, no correction.
    """

    role: ClassVar[str] = "statement"

    number: str
    left: Node
    right: Node
    says: str = ""
    part: int = 1
    given: tuple[Statement, ...] = ()
    assuming: tuple[Hypothesis, ...] = ()
    reading: Node | Equation | None = None
    corrected: Node | Equation | None = None
    sic: bool = False
    sign: str = "="
    kernel: Kernel | None = None
    fault: str | None = field(init=False, default=None)

    def __post_init__(self) -> None:
        fault = self._find_fault()
        if fault and not self.sic and self.reading is None and self.corrected is None:
            raise Misfit(f"({self.number}) does not fit: {fault}. If the book prints it so, say `sic=True`")
        object.__setattr__(self, "fault", fault)
        for node in (self.right, *(n for of in self.kernel.of for n in nodes_of(of))) if self.kernel else ():
            if node.measure is not None and node.measure.partition is not None:
                raise WrongArgument(
                    f"({self.number}) has no kernel: {plain(node)} is of any size; give `with_sizes` one"
                )

    def _find_fault(self) -> str | None:
        if self.left.fault or self.right.fault:
            return self.left.fault or self.right.fault
        assert self.left.measure is not None
        assert self.right.measure is not None
        try:
            added(self.left.measure, self.right.measure, (plain(self.left), plain(self.right)), "equate")
        except Misfit as misfit:
            return str(misfit)
        return None

    @property
    def printed(self) -> Equation:
        """Both sides as the book prints them."""
        return self.left, self.right

    def form(self, which: str) -> Equation:
        """Both sides of the "printed", "reading" or "corrected" form; raises KeyError if there is none."""
        if which == "printed":
            return self.printed
        other = {"reading": self.reading, "corrected": self.corrected}[which]
        if other is None:
            raise KeyError(f"({self.number}) has no {which} form")
        return (self.left, other) if isinstance(other, Node) else other

    def form_exists(self, which: str) -> bool:
        """Whether the statement has a form of that name."""
        return which == "printed" or {"reading": self.reading, "corrected": self.corrected}[which] is not None

    @property
    def relied_on(self) -> tuple[Statement, ...]:
        """The statements whose sides it uses."""
        return self.given

    def saying(self, left: Node, right: Node) -> Statement:
        """The statement with other sides, whether they fit or not, without other forms and without a kernel."""
        return with_fields(self, left=left, right=right, reading=None, corrected=None, sic=True, kernel=None)

    def at(self, values: Mapping[Node, Node]) -> Self:
        """The same statement said of other symbols; TypeError if it assumes or rests on anything about these."""
        self._refuse_to_move(values)
        return with_fields(self, left=replace(self.left, values), right=replace(self.right, values), kernel=None)

    def _refuse_to_move(self, values: Mapping[Node, Node]) -> None:
        spoken_of = [node for h in self.assuming for node in h.subjects]
        spoken_of += [node for given in self.given for node in (given.left, given.right)]
        spoken_of += [self.reading, self.corrected] if self.fault else []  # type: ignore[list-item]
        for node in spoken_of:
            if not isinstance(node, Node) or replace(node, values) != node:
                raise TypeError(f"({self.number}) cannot be said of other symbols: it rests on the old ones")


@dataclass(frozen=True, eq=False)
class Definition(Statement):
    """Introduces its left side, a symbol."""

    role: ClassVar[str] = "definition"
    sign: str = r"\equiv"


@dataclass(frozen=True, eq=False)
class Condition(Statement):
    """Restricts the symbols `on` which it is posed; together with others it may determine them.

    One that is `on` nothing is used as it stands. One that leaves its symbol some freedom gives a `solution` with it.
    """

    role: ClassVar[str] = "condition"
    on: tuple[Symbol, ...] = ()
    solution: Node | None = None

    def at(self, values: Mapping[Node, Node]) -> Self:
        moved = (values.get(symbol, symbol) for symbol in self.on)
        return with_fields(super().at(values), on=tuple(s for s in moved if isinstance(s, Symbol)))


@dataclass(frozen=True, eq=False)
class Postulate(Statement):
    """A law of nature, assumed."""

    role: ClassVar[str] = "postulate"


@dataclass(frozen=True, eq=False)
class Claim(Statement):
    """Says that its sides are equal whenever what is given and assumed holds; decided.

    `restates` and `by`: the claim is the given equation (or several, stacked) multiplied from the left; then what is
    decided is that left - right = by (its left - its right), for every value of the symbols, whether or not the
    equation holds. `solves`: what is decided is that the left side, set to the right side, solves that equation.
    """

    role: ClassVar[str] = "claim"
    restates: Statement | tuple[Statement, ...] | None = None
    by: Node | int | None = None
    solves: Statement | None = None

    @property
    def relied_on(self) -> tuple[Statement, ...]:
        """The statements whose sides it uses: those given, and those that it restates or solves."""
        restated = self.restates if isinstance(self.restates, tuple) else (self.restates,)
        return (*self.given, *(other for other in (*restated, self.solves) if other is not None))


@dataclass(frozen=True, eq=False)
class Theorem(Declared, Displayed):
    """A theorem of the book: its `forms` generate the equations that are decided."""

    role: ClassVar[str] = "theorem"

    number: str
    says: str
    forms: tuple[Form, ...]
    given: tuple[Statement, ...] = ()
    assuming: tuple[Hypothesis, ...] = ()
    part: int = 1
    kernel: None = None
    fault: None = None


def bare(node: Node) -> Node:
    """The quantity without the argument or the brackets with which it is printed: p for p(t), also under a rate."""
    match node:
        case At(of, "t") | Group(of):
            return bare(of)
        case Rate(of):
            return Rate(bare(of))
        case _:
            return node


def is_rule(statement: Statement) -> bool:
    """Whether the left side is a symbol, or the rate of one, that the right side can stand for."""
    left = bare(statement.left)
    return isinstance(undotted(left)[0], Symbol) and not (isinstance(left, Symbol) and left.stands_for)
