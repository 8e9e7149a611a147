"""What moves, at one instant: functions of time become what they are then, rates what the rules say that they are."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import chain

from chasles import vocabulary as w
from chasles.coq.expressions import Spelling, Unsaid
from chasles.coq.names import bare_of
from chasles.coq.polynomials import Polynomials
from chasles.coq.sentences import equal_rates
from chasles.coq.sources import StatedEntry
from chasles.coq.statement import CoqStatement, Premise, bare_rate
from chasles.statements import Hypothesis, Problem

PARTS = ("(proj1 {})", "(proj1 (proj2 {}))", "(proj2 (proj2 {}))")


class Instant:
    """The first steps of a proof, and what is known after them.

    `free` are the variables, by name, `defined` are those that a premise E_... says, and `premises` is what to call
    the premises, in order.
    """

    def __init__(self, said: CoqStatement, problem: Problem, spell: Polynomials, sources: list[StatedEntry]) -> None:
        self.said, self.problem = said, problem
        self.spelling = Spelling(said.names, lambda node, name: name + " b" * said.runs(node), said.spelling.entries)
        self._sources = list(_chains(sources))
        self._spins = list(self._turning(spell))
        self.defined: dict[w.Node, str] = {}
        self.free: dict[str, w.Node] = {}
        for node, name in chain(said.names.symbols.items(), said.names.rates.items()):
            if node in said.rules or (isinstance(node, w.Rate) and not self._is_free(node)):
                self.defined[node] = name
            else:
                self.free[name] = node
        for spin, names in self._spins:
            self.free |= dict.fromkeys(names, spin)
        rates = (node for node in self.defined if isinstance(node, w.Rate) and node not in said.rules)
        self.derived = [node for node in rates if node not in self._turned]
        self.integrals = {node: self.defined[node] for node in self.derived if isinstance(self.told(node), w.Integral)}
        self._kept = [each for each in said.premises if not each.name.startswith(("rate'", "open'T", "under'"))]

    def _turning(self, spell: Polynomials) -> Iterator[tuple[w.Symbol, tuple[str, ...]]]:
        """The spins of rotations, which rules of the problem say and the statement does not."""
        self._turned: dict[w.Rate, str] = {}
        for left, right in self.problem.rules[len(self.said.problem.rules) :]:
            assert isinstance(left, w.Rate)
            assert isinstance(left.of, w.Symbol)
            spin = next(part for part in w.walk(right) if isinstance(part, w.Symbol) and part != left.of)
            name = self.said.names.fresh(f"w_{self.said.names.symbol(left.of)}")
            moves = w.Rate(left) in self.said.names.rates
            names = (name, f"{name}_dot") if moves else (name,)
            spell.spins[spin] = (name, f"{name}_dot")
            self._turned[left] = self.said.names.rates[left]
            yield spin, names

    def told(self, node: w.Rate) -> w.Node:
        """What a rate is the rate of, by its definition."""
        of = bare_rate(node.of)
        return bare_of(self.said.rules.get(of, of))

    def _is_free(self, node: w.Rate) -> bool:
        """Whether nothing says what a rate is."""
        inner: w.Node = node
        while isinstance(inner, w.Rate):
            if inner in self.said.rules or inner in self._turned:
                return False
            inner = inner.of
        return isinstance(inner, w.Symbol) and inner not in self.said.rules and not inner.constant

    @property
    def premises(self) -> list[str]:
        """The names of what is assumed, in order."""
        return [each for each, _ in self._facts()]

    def _facts(self) -> Iterator[tuple[str, bool]]:
        """What is known, and whether it holds at every instant."""
        for each in self._kept:
            yield each.name, each.moves
        for node in (*self._turned, *self.derived):
            yield f"def'{self.said.names.rates[node]}", True
        for source in self._sources:
            yield source.name, True

    def source(self, hypothesis: Hypothesis) -> str:
        """The premise that says a hypothesis."""
        return self._premise(hypothesis).name

    def _premise(self, about: object) -> Premise:
        same = (each for each in self.said.premises if type(each.about) is type(about) and each.about == about)
        if (found := next(same, None)) is None:
            raise Unsaid(f"no premise says {about.text if isinstance(about, Hypothesis) else about}")
        return found

    def equation(self, source: StatedEntry) -> str:
        """The term that says an equation."""
        return source.name if source.order else self._said(source, self._premise(source.about).name)

    def _said(self, source: StatedEntry, premise: str) -> str:
        """The part of a premise that is the equation."""
        kind = source.about.kind if isinstance(source.about, Hypothesis) else ""
        match kind:
            case "rotation" | "orthonormal":
                return PARTS[source.equation].format(f"(rotation_quadrics _ {premise})")
            case "half_turn":
                return PARTS[source.equation].format(premise)
            case "definite":
                return f"(proj1 {premise})"
        return premise

    def steps(self) -> Iterator[str]:
        """All is brought to one instant, and what is known is put before the claim."""
        said = self.said
        binders = " ".join(name for name, _ in said.binders)
        if not said.timed:
            yield from [f"intros {binders}."] * bool(binders)
            return
        yield f"intros {binders} {' '.join(each.name for each in said.premises)} t now'."
        yield from self._spun()
        for node in self.derived:
            yield from self._rate(node)
        for source in self._sources:
            yield from self._rate_of(source)
        if facts := [f"({name} t now')" if moves else name for name, moves in self._facts()]:
            yield f"generalize {' '.join(facts)}; cbv beta."
        names = [*self.free, *self.defined.values()]
        now = [f"({name} t)" if self._moves(name) else name for name in names]
        yield f"generalize {' '.join(now)}; clear; intros {' '.join(names)}."

    def _moves(self, name: str) -> bool:
        spins = {each for _, names in self._spins for each in names}
        nodes = {**self.free, **{known: node for node, known in self.defined.items()}}
        return name in spins or self.said.moves(nodes[name])

    def _spun(self) -> Iterator[str]:
        """Rotations that move have a spin."""
        for (_, names), (left, name) in zip(self._spins, self._turned.items(), strict=True):
            assert isinstance(left, w.Rate)
            rotation = next(h for h in self.problem.hypotheses if h.kind == "rotation" and h.subjects[0] == left.of)
            known = f"open'T {self.source(rotation)} rate'{name}"
            if len(names) == 1:
                yield f"destruct (spin_of_rotation T _ _ {known}) as ({names[0]} & def'{name})."
            else:
                second = f"rate'{self.said.names.rates[w.Rate(left)]}"
                found = f"{' & '.join(names)} & rate'{names[0]} & def'{name}"
                yield f"destruct (spin_of_rotation_moves T _ _ _ {known} {second}) as ({found})."

    def _rate(self, node: w.Node) -> Iterator[str]:
        """What a rate is, by the rules of differentiation."""
        assert isinstance(node, w.Rate)
        name = self.said.names.rates[node]
        of = bare_rate(node.of)
        if self.said.runs(node):
            raise Unsaid(f"the rate of {node.of}, which differs from element to element")
        if any(isinstance(part, w.Determinant | w.Cofactor) for part in w.walk(self._opened(self.told(node)))):
            raise Unsaid("the rate of a determinant")
        if of in self.derived or of in self._turned:
            sides, equal = "_ _", f"exact def'{self.said.names.rates[of]}"
        else:
            opened = self._opened(self.said.rules.get(of, of))
            sides = f"{self.said.spelling.function(of)} {self.said.spelling.function(opened)}"
            equal = self._by_definitions(isinstance(opened, w.Integral))
        steps = f"{equal} | exact (rate'{name} s' now's) | clear rate'{name}; rates"
        yield equal_rates(f"def'{name}", f"{name} t", sides, steps, node.shape == (1, 1))

    def _by_definitions(self, integrated: bool) -> str:
        """That two expressions are the same, by what is given."""
        rules: dict[bool, list[str]] = {False: [], True: []}
        for node, name in self.defined.items():
            if node in self.said.rules:
                runs = self.said.runs(node)
                now = " x' now'x" * self.said.moves(node)
                rules[runs].append(f"?(def'{name}{now}{' b' * runs})")
        steps = [_rewritten(rules[False])] if rules[False] else []
        if integrated:
            steps += ["apply f_equal", "extensionality b"]
            steps += [_rewritten(rules[True] + rules[False])] if rules[True] else []
        return "; ".join(["intros x' now'x; cbv beta", *steps, "reflexivity"])

    def _opened(self, node: w.Node) -> w.Node:
        """An expression in symbols that have a rate here, or none."""
        node = bare_of(node)
        if isinstance(node, w.Rate):
            return node
        if isinstance(node, w.Symbol):
            if not self.said.moves(node) or w.Rate(node) in self.said.names.rates or node not in self.said.rules:
                return node
            return self._opened(self.said.rules[node])
        return w.rebuilt(node, tuple(map(self._opened, w.children(node)))) if w.children(node) else node

    def _rate_of(self, source: StatedEntry) -> Iterator[str]:
        """The rate of what is assumed."""
        if source.order == 1:
            sides = f"{self.said.spelling.function(source.left)} {self.said.spelling.function(source.right)}"
            premise = self._premise(source.about)
            if not premise.moves:
                raise Unsaid(f"the rate of {source.left}, which does not move")
            known = self._said(source, f"({premise.name} x' now'x)")
            known = f"(fun x' now'x => {known})"
        else:
            sides, known = "_ _", f"{source.stem}_{source.order - 1}"
        yield equal_rates(source.name, "_", sides, f"exact {known} | rates | rates", source.left.shape == (1, 1))


def _rewritten(rules: list[str]) -> str:
    return f"repeat (progress (rewrite {', '.join(rules)}))"


def _chains(sources: list[StatedEntry]) -> Iterator[StatedEntry]:
    """The rates of equations that are asked for, each once and after those of which it is the rate."""
    found: dict[str, StatedEntry] = {}
    for source in sources:
        for order in range(1, source.order + 1):
            each = replace(source, order=order)
            found.setdefault(each.name, each)
    yield from found.values()
