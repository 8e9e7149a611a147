"""A problem as a statement in Coq: for all symbols, what is assumed implies what is claimed.

Only this, the spelling of expressions and the theories `Words` and `Hypotheses` have to be read to know what it claims.
What moves is a function of time, and everything holds during an open set of instants; what differs from element to
element of a body is a function of the element; every rate has a name, and is assumed to be the rate.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import chain

from chasles import vocabulary as w
from chasles.coq.expressions import ATOM, EMPTY, EntryOf, Spelling, Unsaid
from chasles.coq.names import CoqNames, bare_of
from chasles.statements import Hypothesis, Problem

KINDS = {"unit": "unit_vector", "symmetric": "symmetric", "definite": "definite", "rotation": "rotation",
         "perpendicular": "perpendicular", "orthonormal": "orthonormal", "half_turn": "half_turn"}  # fmt: skip
"""Hypotheses with a word of their own; the others are said by their equations."""
BY_EQUATIONS = ("unit column", "direction", "untaken", "orthogonal")


@dataclass(frozen=True, slots=True)
class Premise:
    """Something assumed, by the name that proofs give it; `says` holds at each instant if it is about what `moves`."""

    name: str
    says: str
    moves: bool = False
    about: object = None


class CoqStatement:
    """The statement of a problem. Raises `Unsaid` where the theories have no words for it."""

    def __init__(
        self, problem: Problem, like: CoqNames | None = None, entries: Mapping[w.Node, EntryOf] = EMPTY
    ) -> None:
        self.problem = problem
        self.names = CoqNames(like)
        self.spelling = Spelling(self.names, self.applied, entries)
        self.rules = {bare_rate(left): right for left, right in problem.rules}
        self.nodes = list(self._nodes())
        if any(not isinstance(extent, int) for node in self.nodes for extent in node.shape):
            raise Unsaid("matrices of any size: the theories have those of known sizes")
        for node in self.nodes:
            if isinstance(node, w.Symbol) and node.stands_for is not None:
                self.rules[node] = node.stands_for
        self.timed = any(isinstance(node, w.Rate) for node in self.nodes)
        self.integrals = [node for node in self.nodes if isinstance(node, w.Integral)]
        self.running = self._running()
        for node in self.nodes:
            if isinstance(node, w.Symbol) and node != w.PI:
                self.names.symbol(node)
        for node in self.nodes:
            if isinstance(node, w.Rate):
                self.names.rate(node)
                for each in self._differentiated(node.of, 1):
                    self.names.rate(each)

    def _nodes(self) -> Iterator[w.Node]:
        said = [h for h in self.problem.hypotheses if h.kind != "given"]
        by_sign = {h for h in said if h.kind == "inequality"}  # the root of the difference is not spoken of
        pairs = (*self.problem.rules, *(equation for h in said if h not in by_sign for equation in h.equations))
        subjects = (h.subjects[:1] if h in by_sign else h.subjects for h in said)
        parts = chain(self.problem.sides, chain.from_iterable(pairs), *subjects)
        return chain.from_iterable(map(opened, parts))

    def _differentiated(self, node: w.Node, order: int) -> Iterator[w.Rate]:
        """The rates that must exist for an expression to have one."""
        node = bare_of(node)
        base, inner = w.undotted(node)
        if isinstance(base, w.Symbol) and base != w.PI:
            told, more = bare_rate(node), order
            while told not in self.rules and isinstance(told, w.Rate):
                told, more = told.of, more + 1
            if told in self.rules:
                yield from self._differentiated(self.rules[told], more)
            if inner or (told not in self.rules and not base.constant):
                for _ in range(order):
                    node = w.Rate(node)
                    yield node
        elif inner:
            yield from self._differentiated(base, order + inner)
        else:
            for part in w.children(node):
                yield from self._differentiated(part, order)

    def _running(self) -> frozenset[w.Node]:
        """What differs from element to element of a body."""
        found: set[w.Node] = {symbol for node in self.integrals for symbol in node.running}
        rules = [(w.undotted(left)[0], right) for left, right in self.rules.items()]
        while more := {base for base, right in rules if found.intersection(_outside(right))} - found:
            found |= more
        return frozenset(found)

    def moves(self, node: w.Node) -> bool:
        """Whether a symbol, or the rate of something, is a function of time here."""
        return isinstance(node, w.Rate) or (self.timed and isinstance(node, w.Symbol) and not node.constant)

    def runs(self, node: w.Node) -> bool:
        """Whether it is a function of the element of a body."""
        return w.undotted(bare_of(node))[0] in self.running

    def applied(self, node: w.Node, name: str) -> str:
        """A symbol or rate at the instant, of the element."""
        return name + " t" * self.moves(node) + " b" * self.runs(node)

    def type_of(self, node: w.Node) -> str:
        """Its type."""
        rows, columns = node.shape
        values = "R" if (rows, columns) == (1, 1) else f"M {rows} {columns}"
        return "R -> " * self.moves(node) + "B -> " * self.runs(node) + values

    @cached_property
    def premises(self) -> list[Premise]:
        """All that is assumed."""
        return [*self._of_time_and_bodies(), *self._definitions(), *self._conditions(), *self._hypotheses()]

    def _of_time_and_bodies(self) -> Iterator[Premise]:
        if self.timed:
            yield Premise("open'T", "open_set T")
        if self.integrals:
            yield Premise("linear'", "linear integral")
        if any(self._has_integral(node.of) for node in self.names.rates):
            yield Premise("under'", "differentiable_under integral")
        for node, name in self.names.rates.items():
            word = "scalar_rate" if node.shape == (1, 1) else "rate"
            if self.runs(node):
                of = self.spelling.side(node.of)
                says = f"forall b, {word} T (fun t => {of}) (fun t => {name} t b)"
            else:
                says = f"{word} T {self._function(node.of)} {name}"
            yield Premise(f"rate'{name}", says, about=node)

    def _has_integral(self, node: w.Node) -> bool:
        """Whether an integral is in an expression, definitions put in."""
        told = (self.rules.get(bare_rate(part)) for part in w.walk(node))
        here = any(isinstance(part, w.Integral) for part in w.walk(node))
        return here or any(each is not None and self._has_integral(each) for each in told)

    def _function(self, node: w.Node) -> str:
        """An expression as a function of time."""
        match bare_of(node):
            case w.Symbol() as symbol if self.moves(symbol):
                return self.names.symbol(symbol)
            case w.Rate() as rate:
                return self.names.rate(rate)
        return self.spelling.function(node)

    def _definitions(self) -> Iterator[Premise]:
        for left, right in self.rules.items():
            if not isinstance(w.undotted(left)[0], w.Symbol):
                raise Unsaid(f"a rule for {left}, which is no symbol")
            if self.is_named(left):
                name = self.names.rate(left) if isinstance(left, w.Rate) else self.names.symbol(left)  # type: ignore[arg-type]
                says = self.spelling.equation(left, right)
                says = f"forall b, {says}" if self.runs(left) else says
                yield Premise(f"def'{name}", says, self.moves(left), left)

    def is_named(self, left: w.Node) -> bool:
        """Whether a symbol or its rate occurs."""
        return left in self.names.symbols or left in self.names.rates

    def _conditions(self) -> Iterator[Premise]:
        for count, goal in enumerate(self.problem.conditions):
            yield Premise(f"cond'{count}", self.spelling.equation(*goal.sides), self._any_moves(*goal.sides), goal)

    def _hypotheses(self) -> Iterator[Premise]:
        for count, hypothesis in enumerate(self.problem.hypotheses):
            if hypothesis.kind != "given":  # it says that a rate is the rate, which is assumed of every rate
                says = self._hypothesis(hypothesis)
                if any(self.runs(part) for subject in hypothesis.subjects for part in _outside(subject)):
                    says = f"forall b, {says}"
                moves = self._any_moves(*hypothesis.subjects)
                yield Premise(f"hyp'{count}", says, moves, hypothesis)

    def _hypothesis(self, hypothesis: Hypothesis) -> str:
        subjects = hypothesis.subjects
        if hypothesis.kind in KINDS:
            return f"{KINDS[hypothesis.kind]} {' '.join(self.spelling.matrix(each, ATOM) for each in subjects)}"
        if hypothesis.kind == "positive":
            return f"0 < {self.spelling.number(subjects[0])}"
        if hypothesis.kind == "inequality":
            return f"0 {'<' if hypothesis.nonvanishing else '<='} {self.spelling.number(subjects[0])}"
        if hypothesis.kind in ("nonzero", "evident"):
            return f"{self.spelling.number(hypothesis.nonvanishing[0])} <> 0"
        if hypothesis.kind in BY_EQUATIONS and not hypothesis.nonvanishing:
            return " /\\ ".join(self.spelling.equation(left, right) for left, right in hypothesis.equations)
        raise Unsaid(f"the hypothesis {hypothesis.text!r} ({hypothesis.kind})")

    def _any_moves(self, *nodes: w.Node) -> bool:
        return any(self.moves(part) for node in nodes for part in opened(node))

    @property
    def equations(self) -> list[str]:
        """What the goals say."""
        return [self.spelling.equation(*goal.sides) for goal in self.problem.goals]

    @property
    def binders(self) -> list[tuple[str, str]]:
        """What the statement is for all of, with types."""
        everything = [*self.names.symbols.items(), *self.names.rates.items()]
        first = [("T", "R -> Prop")] * self.timed
        if self.integrals:
            first += [("B", "Type"), ("integral", "(B -> R) -> R")]
        return [*first, *((name, self.type_of(node)) for node, name in everything)]


def bare_rate(node: w.Node) -> w.Node:
    """A symbol or its rate, without brackets and arguments."""
    node = bare_of(node)
    return w.Rate(bare_rate(node.of)) if isinstance(node, w.Rate) else node


def opened(node: w.Node) -> Iterator[w.Node]:
    """The node and all below it, abbreviations opened."""
    for part in w.walk(node):
        yield part
        if isinstance(part, w.Symbol) and part.stands_for is not None:
            yield from opened(part.stands_for)


def _outside(node: w.Node) -> Iterator[w.Node]:
    """The node and all below it that is not integrated, abbreviations opened."""
    if isinstance(node, w.Integral):
        return
    yield node
    below = w.children(node)
    if isinstance(node, w.Symbol) and node.stands_for is not None:
        below = (node.stands_for,)
    for part in below:
        yield from _outside(part)
