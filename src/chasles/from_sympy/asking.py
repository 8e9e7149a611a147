"""How a question is asked: both sides, the given equations and what does not vanish, read into one problem."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from functools import partial
from itertools import product
from typing import Any

import sympy

from chasles.checker.expressions.asked import Asked
from chasles.checker.sparse import Rejected
from chasles.from_sympy.arcs import turned
from chasles.from_sympy.atoms import QuantityNames, nonnegative_by_sign
from chasles.from_sympy.certificates import Writing
from chasles.from_sympy.complex_symbols import RealParts, taken_as_real
from chasles.from_sympy.divisors import DivisorText, divisor_of
from chasles.from_sympy.elementary import Elementary
from chasles.from_sympy.given import collected, evident, impossible, orders_of
from chasles.from_sympy.given_equations import Equations, SideConditions
from chasles.from_sympy.opening import Entries, opened
from chasles.from_sympy.question import Question, matrix_of
from chasles.from_sympy.reader import Reader
from chasles.from_sympy.readings import READINGS
from chasles.from_sympy.roots import resolve, words_of
from chasles.from_sympy.sampling import Sampling
from chasles.from_sympy.searching import is_about_motion, search_for
from chasles.from_sympy.side_conditions import nonvanishing
from chasles.statements import Goal, Hypothesis, Problem
from chasles.verdict import Contradictory, IllFormed
from chasles.vocabulary import Node
from chasles.vocabulary import replace as put


def ask(lhs: Any, rhs: Any, given: Any, nonzero: Any) -> Question | IllFormed | Contradictory:
    """The question whether two sides are equal; raises `Untreatable` for what the procedure does not treat."""
    left, right = opened(lhs, "the left side"), opened(rhs, "the right side")
    if left.shape != right.shape:
        return IllFormed(f"cannot equate {left.size} (the left side) and {right.size} (the right side)")
    parts = RealParts()
    parts.require([lhs, rhs, given, nonzero])
    declared = [parts.nonzero(scalar) for scalar in nonvanishing(nonzero)]
    rows = left.shape[0]
    left, right = parts.equal(left, right)
    spoken_of = [*declared, *_flat(left), *_flat(right), *parts.met]
    conditions, expressions = collected(given, spoken_of, parts)
    false = impossible(conditions, declared)
    if false:
        return Contradictory((false,))
    derived = [pair for item in conditions.equations if item.derived for pair in item.pairs]
    elementary = Elementary()
    expressions = _rewritten(elementary, expressions, conditions)
    first, size = len(declared), left.shape[0] * left.shape[1]
    given_sides = [side for item in conditions.equations for pair in item.pairs for side in pair]
    logs, arcs = (any(side.has(*words) for side in given_sides) for words in (elementary.logs, elementary.arcs))
    for k, place in enumerate(product(range(left.shape[0]), range(left.shape[1]))):
        sides = expressions[first + k], expressions[first + k + size]
        if not arcs and (cosine := turned(*sides, elementary.arcs)):
            expressions[first + k], expressions[first + k + size] = cosine[0], sympy.S.One
            elementary.halvings[place] = cosine[1]
        elif not logs and (raised := elementary.exponentials(sides[0] - sides[1])):
            expressions[first + k], expressions[first + k + size], elementary.multiples[place] = raised
    question = _Asking(conditions, expressions, len(declared), left.shape, elementary).question(
        (lhs, rhs, given, nonzero)
    )
    question.nonnegative = size == 1 and all(map(nonnegative_by_sign, expressions[first : first + 2]))
    question.search.rows = rows if left.shape[0] > rows else None
    still = not any(orders_of(pair) for pair in conditions.stated)
    defined = (*parts.met, *elementary.needs.values())
    question.sampling = Sampling(left, right, rows, [*conditions.stated, *derived], declared, defined, still)
    return question


def _rewritten(elementary: Elementary, expressions: list[Any], given: SideConditions) -> list[Any]:
    """Everything in variables that stand for exponentials and logarithms, and what roots of higher order satisfy."""
    pairs = [pair for item in given.equations for pair in item.pairs]
    labelled = [item for item in given.equations if item.label and len(item.pairs) == 1]
    found = elementary([*expressions, *(side for pair in pairs for side in pair)], [item.pairs[0] for item in labelled])
    named = QuantityNames()
    for atom in elementary.atoms:
        named.word(atom)
    sides = iter(found[len(expressions) :])
    for item in given.equations:
        item.pairs = [(next(sides), next(sides)) for _ in item.pairs]
    given.equations += [Equations(f"{a} = {b}", [(a, b)], ()) for a, b in elementary.equations]
    for item, (a, b) in zip(labelled, elementary.applied, strict=True):
        if a != b:
            given.equations.append(Equations(f"of both sides of {item.text}", [(a, b)], item.sources))
    return [*found[: len(expressions)], *elementary.defined]


def _flat(entries: Entries) -> list[Any]:
    return [entry for row in entries.rows for entry in row]


class _Asking:
    """Reads everything that belongs to a question in one go, and puts it together."""

    def __init__(
        self,
        given: SideConditions,
        expressions: list[Any],
        declared: int,
        shape: tuple[int, int],
        elementary: Elementary,
    ) -> None:
        self.elementary = elementary
        self.reader = reader = Reader(READINGS, elementary.origins)
        self.given = given
        for expression in expressions[:declared]:
            reader.declare(reader(expression), divisor_of(expression))
        self.declared = set(reader.divisors)
        reader.met.clear()
        nodes = [reader(expression) for expression in expressions[declared:]]
        self.met = set(reader.met)
        size = shape[0] * shape[1]
        self.goal = Goal("", matrix_of(nodes[:size], shape), matrix_of(nodes[size : 2 * size], shape))
        self.equations = []
        self.of_rates: set[Node] = set()
        for item in given.equations:
            before = {*reader.divisors}
            self.equations.append(self._hypothesis(item))
            self.of_rates |= reader.divisors.keys() - before if item.derived else set()
        for divisor in evident(given, expressions[declared : declared + 2 * size] if size == 1 else ()):
            reader.declare(reader(divisor), DivisorText(divisor_of(divisor).text, evident=True))

    def question(self, asked: tuple[Any, Any, Any, Any]) -> Question:
        """All that was read, as a problem, with what to say of it; `asked` is what was handed in."""
        reader = self.reader
        roots = resolve(reader, tuple(map(self._divisor, reader.divisors)))
        divisors = {node: self._divisor(node) for node in reader.divisors}
        words = words_of(roots.hypotheses)
        # Variables rank as they are met: a root above what is under it, so that its square is what leads.
        equations = [_with(hypothesis, dict(roots.rules)) for hypothesis in self.equations]
        hypotheses = dict.fromkeys((*self._ranking(), *reversed(roots.hypotheses), *equations, *divisors.values()))
        unsaid = [divisor.text for divisor in reader.divisors.values() if divisor.evident]
        unsaid += [f"{word} > 0" for word, origin in self.elementary.origins.items() if origin.is_Pow]
        met = [divisor.text for node, divisor in reader.divisors.items() if node in self.met]
        higher = [item.text for item in self.given.equations if not item.sources]
        substituted = [text for text, _, _ in self.given.substitutions]
        search = search_for(reader, self.given)
        search.unseen = bool(self.elementary.origins)
        search.blind = search.blind or search.unseen
        search.write = Writing(asked, reader, self.given, roots, search, self.elementary)
        question = Question(
            problem=Problem((self.goal,), roots.rules, (), words, tuple(hypotheses)),
            own=(
                *(h for h, item in zip(equations, self.given.equations, strict=True) if item.sources),
                *(divisors[node] for node in divisors if node in self.declared),
            ),
            search=search,
            needs=(
                *taken_as_real(asked),
                *substituted,
                *self.elementary.needs,
                *met,
                *roots.domains,
            ),
            hidden=frozenset((*unsaid, *higher, *(h.text for h in roots.hypotheses))),
            sources={item.text: item.sources for item in self.given.equations if item.sources},
            origins=reader.atoms.origins,
            roots=frozenset((*words, *reader.roots.values())),
            substituted=tuple((atom, value) for _, atom, value in self.given.substitutions),
            formal=bool(self.elementary.origins),
            of_rates=frozenset(map(divisors.get, self.of_rates)),
        )
        if is_about_motion(reader, self.given):
            with suppress(Rejected):  # what the checker does not read it does not follow
                search.moves = partial(question.moves, Asked(*asked))
        return question

    def _ranking(self) -> Iterator[Hypothesis]:
        """Rates of functions lead an equation between them, the highest first: it is what the equation determines."""
        if any(item.moving for item in self.given.equations):
            rates = [atom for atom in self.reader.atoms.words if isinstance(atom, sympy.Derivative)]
            rates.sort(key=lambda rate: -rate.derivative_count)
            yield Hypothesis("equation", tuple(map(self.reader, rates)), free=True)

    def _divisor(self, node: Node) -> Hypothesis:
        text = self.reader.divisors[node].text
        return Hypothesis("nonzero", (node,), (), (node,), "", text, free=True)

    def _hypothesis(self, item: Equations) -> Hypothesis:
        pairs = tuple((self.reader(a), self.reader(b)) for a, b in item.pairs)
        frames = {other.sources for other in self.given.equations if other.triad}
        kind = "rate of a frame" if item.derived and item.sources in frames else "equation"
        kind = "rotation" if item.triad and item.triad.proper and len(item.pairs) > 6 else kind
        subjects = tuple(dict.fromkeys(side for pair in pairs for side in pair))
        return Hypothesis(kind, subjects, pairs, (), "", item.text, free=True)


def _with(hypothesis: Hypothesis, values: Mapping[Node, Node]) -> Hypothesis:
    """The hypothesis said of what words stand for; a root that depends on another one comes after it."""
    for word, value in reversed(list(values.items())):
        pairs = tuple((put(one, {word: value}), put(other, {word: value})) for one, other in hypothesis.equations)
        subjects = tuple(put(subject, {word: value}) for subject in hypothesis.subjects)
        hypothesis = replace(hypothesis, equations=pairs, subjects=subjects)
    return hypothesis
