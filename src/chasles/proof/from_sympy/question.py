"""A question on SymPy expressions: the problem that decides it, and how to say the answer in SymPy's terms."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any

import sympy

from chasles.proof.from_sympy.atoms import ASSUMPTIONS
from chasles.proof.from_sympy.given import Equations, Given, collected
from chasles.proof.from_sympy.opening import Entries, opened, sides
from chasles.proof.from_sympy.reader import Reader, multiplied
from chasles.proof.from_sympy.roots import resolve, words_of
from chasles.proof.search import Frame, Motion, Search, entry_of
from chasles.proof.surds import Exact
from chasles.proof.variables import Untreatable
from chasles.proof.verdict import Counterexample, Fails, Holds, HoldsUnder, IllFormed, Undecided, Verdict
from chasles.statements import Goal, Hypothesis, Problem
from chasles.vocabulary import PI, Block, Negative, Node, Power, Quotient, Scale, Sum, Zero

__all__ = ["Question", "ask"]


@dataclass(slots=True)
class Question:
    """A problem in words, with the search for its points and the names that SymPy has for its variables.

    `needs` are reported whatever the proof uses: divisors, the domains of roots, substituted angles. `hidden` texts are
    true by themselves. `sources` give the text of what the user said for that of what follows from it.
    """

    problem: Problem
    own: tuple[Hypothesis, ...]
    search: Search
    needs: tuple[str, ...]
    hidden: frozenset[str]
    sources: Mapping[str, tuple[str, ...]]
    reader: Reader
    roots: frozenset[str] = field(default_factory=frozenset)

    def variants(self) -> Iterator[Problem]:
        """Problems that say the same, and may be easier to prove.

        The left side is multiplied and divided by what does not vanish; or the square of the difference is zero.
        """
        divisors = [node for h in self.problem.hypotheses for node in h.nonvanishing]
        for factors in [*([node] for node in divisors), divisors] if len(divisors) > 1 else [divisors] * len(divisors):
            factor = multiplied(factors)
            goals = [Goal(g.label, Quotient(Scale(factor, g.left), factor), g.right) for g in self.problem.goals]
            yield replace(self.problem, goals=tuple(goals))
        for goal in self.problem.goals if self.conditions else ():
            rows, columns = goal.left.shape
            pairs = [[(entry_of(s, (i + 1, j + 1)) for s in (goal.left, goal.right)) for j in range(columns)] for i in range(rows)]
            squares = [Power(Sum((one, Negative(other))), 2) for row in pairs for one, other in row]
            yield replace(self.problem, goals=(Goal("", _matrix(list(squares), goal.left.shape), Zero(rows, columns)),))

    @property
    def conditions(self) -> bool:
        """Whether equations are given."""
        return any(h.kind != "root" and h.equations for h in self.problem.hypotheses)

    def answered(self, verdict: Verdict) -> Verdict:
        """The verdict in SymPy's terms."""
        match verdict:
            case Holds() | HoldsUnder():
                needs = tuple(text for text in self._said((*self.needs, *verdict.needs)) if text not in self.hidden)
                unused = tuple(text for text in self._said(verdict.unused) if text not in needs)
                certificate = {
                    **verdict.certificate,
                    "names": self._names(),
                    "witness": {name: _written(value) for name, value in sorted(verdict.witness.items())},
                }
                witness = self._point(verdict.witness)
                if needs:
                    return HoldsUnder(needs, certificate, witness, unused)
                return Holds(certificate, witness, unused)
            case Fails(Counterexample() as found):
                return Fails(replace(found, at=self._point(found.at)))
            case IllFormed(reason):
                return Undecided(reason)
            case _:
                return verdict

    def _said(self, texts: Iterable[str]) -> tuple[str, ...]:
        """What the user said, for texts of hypotheses."""
        return tuple(dict.fromkeys(said for text in texts for said in self.sources.get(text, (text,))))

    def _names(self) -> dict[str, str]:
        """What each word stands for."""
        return {word.name: str(origin) for word, origin in self.reader.atoms.origins.items()}

    def _point(self, point: Mapping[str, Any]) -> dict[str, Any]:
        """A point by SymPy's names, irrational coordinates as SymPy numbers; roots follow from the others."""
        origins = {word.name: origin for word, origin in self.reader.atoms.origins.items()}
        angle = self._angle(point, origins)
        found: dict[str, Any] = {}
        for name, value in sorted(point.items()):
            if name in self.roots or name == PI.name:
                continue
            spelled = _spelled(name, origins)
            # A symbol may be called as a cosine is written.
            spelled = spelled if spelled not in found else sympy.srepr(origins.get(name, spelled))
            found[spelled] = _number(value, angle) if isinstance(value, Exact) else value
        return found

    def _angle(self, point: Mapping[str, Any], origins: Mapping[str, Any]) -> Any:
        """What the transcendental number is: pi, or the positive angle that has its cosine and sine at the point."""
        theta = self.search.theta
        for name, cosine in point.items():
            word, unit = _angle_of(name, origins) if name.startswith("cos(") else ("", sympy.S.One)
            if theta is not None and word == theta.name:
                sine = point["sin" + name.removeprefix("cos")]
                turned = sympy.atan2(*(sympy.Rational(x.numerator, x.denominator) for x in (sine, cosine)))
                return (turned if turned.is_positive else turned + 2 * sympy.pi) / unit
        return sympy.pi


def _number(value: Exact, angle: Any) -> Any:
    """An exact number as SymPy's, the transcendental number being an angle."""
    return sympy.sympify(value.text("theta"), locals={"theta": sympy.Symbol("theta")}).subs("theta", angle)


def _written(value: Fraction | Exact) -> str:
    """A coordinate for the checker: an angle that stands beside its cosine and sine is a multiple of one number."""
    if isinstance(value, Exact) and not value.is_algebraic and len(value.terms) == 1:
        ((_, factor),) = value.terms.items()
        return str(factor)
    return str(value)


def _spelled(name: str, origins: Mapping[str, Any]) -> str:
    """A variable in SymPy's spelling: x, Derivative(f(t), t), cos(phi/2)."""
    if not name.startswith(("cos(", "sin(")):
        return str(origins[name])
    word, unit = _angle_of(name, origins)
    return str(getattr(sympy, name[:3])(unit * origins[word], evaluate=False))


def _angle_of(name: str, origins: Mapping[str, Any]) -> tuple[str, Any]:
    """The word and the multiple of it of which a variable such as cos(3phi/2) is the cosine."""
    above, _, below = name[4:].removesuffix(")").partition("/")
    word = next(word for word in origins if above.endswith(word) and (above.removesuffix(word) or "1").isdigit())
    return word, sympy.Rational(int(above.removesuffix(word) or 1), int(below or 1))


def ask(lhs: Any, rhs: Any, given: Iterable[Any], nonzero: Iterable[Any]) -> Question | IllFormed:
    """The question whether two sides are equal; raises `Untreatable` for what the procedure does not treat."""
    left, right = opened(lhs, "the left side"), opened(rhs, "the right side")
    if left.shape != right.shape:
        return IllFormed(f"cannot equate {left.size} (the left side) and {right.size} (the right side)")
    declared = [entry for place, item in enumerate(nonzero) for entry in _nonzero(item, place)]
    spoken_of = [*declared, *_flat(left), *_flat(right)]
    conditions, expressions = collected(given, spoken_of)
    return _Asking(conditions, expressions, len(declared), left.shape).question()


def _flat(entries: Entries) -> list[Any]:
    return [entry for row in entries.rows for entry in row]


def _nonzero(item: Any, place: int) -> Iterator[Any]:
    what = f"nonzero[{place}]"
    if isinstance(item, sympy.Unequality):
        item = item.lhs - item.rhs
    entries = opened(item, what)
    if entries.shape != (1, 1):
        raise Untreatable(f"{what} is {entries.size}: a scalar is expected, such as the square of a vector's length")
    yield entries.rows[0][0]


class _Asking:
    """Reads everything that belongs to a question in one go, and puts it together."""

    def __init__(self, given: Given, expressions: list[Any], declared: int, shape: tuple[int, int]) -> None:
        self.reader = reader = Reader()
        self.given = given
        self.expressions = expressions
        for expression in expressions[:declared]:
            reader.declare(reader(expression), f"{expression} {'> 0' if expression.is_positive else '!= 0'}")
        self.own_divisors = set(reader.divisors)
        reader.met.clear()
        nodes = [reader(expression) for expression in expressions[declared:]]
        self.met = set(reader.met)
        self.goal = Goal("", _matrix(nodes[: len(nodes) // 2], shape), _matrix(nodes[len(nodes) // 2 :], shape))
        self.equations = [self._hypothesis(item) for item in given.equations]

    def question(self) -> Question:
        divisors = {node: self._divisor(node) for node in self.reader.divisors}
        roots = resolve(self.reader, tuple(divisors.values()))
        divisors = {node: self._divisor(node) for node in self.reader.divisors}
        # Variables rank as they are met: a root above what is under it, so that its square is what leads.
        hypotheses = (*reversed(roots.hypotheses), *self.equations, *divisors.values())
        words = words_of(roots.hypotheses)
        problem = Problem((self.goal,), roots.rules, (), words, tuple(dict.fromkeys(hypotheses)))
        texts = {node: divisor.text for node, divisor in self.reader.divisors.items()}
        constant = {divisor.text for divisor in self.reader.divisors.values() if divisor.constant}
        substituted = [text for text, _, _ in self.given.substitutions]
        met = [texts[node] for node in self.reader.divisors if node in self.met]
        return Question(
            problem,
            (*self.equations, *(divisors[node] for node in self.reader.divisors if node in self.own_divisors)),
            self._search(),
            (*substituted, *met, *roots.domains),
            frozenset(constant | {h.text for h in roots.hypotheses}),
            {item.text: item.sources for item in self.given.equations},
            self.reader,
            frozenset({word.name for word in words} | {root.word.name for root in self.reader.roots.values()}),
        )

    def _divisor(self, node: Node) -> Hypothesis:
        text = self.reader.divisors[node].text
        return Hypothesis("nonzero", (node,), (), (node,), "", text, free=True)

    def _hypothesis(self, item: Equations) -> Hypothesis:
        pairs = tuple((self.reader(a), self.reader(b)) for a, b in item.pairs)
        kind = "rotation" if item.triad and item.triad.proper and len(item.pairs) > 6 else "equation"
        subjects = tuple(dict.fromkeys(side for pair in pairs for side in pair))
        return Hypothesis(kind, subjects, pairs, (), "", item.text, free=True)

    def _search(self) -> Search:
        reader = self.reader
        words = {word.name: atom for atom, word in reader.atoms.words.items()}
        assumed = {name: _assumed(atom) for name, atom in words.items()}

        def allowed(name: str, value: Exact) -> bool:
            wanted = assumed.get(name)
            return not wanted or _agrees(value, wanted)

        frames = tuple(
            Frame(tuple(tuple(reader.atoms.word(a).name for a in row) for row in item.triad.matrix.tolist()), item.triad.proper)
            for item in self.given.equations
            if item.triad
        )
        return Search(
            allowed,
            reader.angles.products,
            frozenset(word for atom, word in reader.atoms.words.items() if atom.is_algebraic or atom.is_zero),
            frames,
            self._motion(),
            lambda symbol: str(reader.atoms.origins[symbol]),
            self._blind(),
        )

    def _motion(self) -> Motion | None:
        """What has to be looked at where given equations hold at all times, and rates occur."""
        atoms = self.reader.atoms.words
        derivatives = [atom for atom in atoms if isinstance(atom, sympy.Derivative)]
        highest: dict[Any, int] = {}
        equations: dict[str, int | None] = {}
        for item in self.given.equations:
            inside = [part for pair in item.pairs for side in pair for part in side.atoms(sympy.Derivative)]
            functions = {f for pair in item.pairs for side in pair for f in side.atoms(sympy.core.function.AppliedUndef)}
            if item.derived or not functions:
                continue
            for function in functions:
                orders = [d.derivative_count for d in inside if d.expr == function]
                highest[function] = max([highest.get(function, 0), *orders])
            equations[item.text] = None if item.triad is None else _rank(item.triad.matrix.cols, item.triad.matrix.rows)
        if not derivatives or not equations:
            return None
        names = [
            atoms[function if not order else sympy.Derivative(function, (function.args[0], order))].name
            for function, order in highest.items()
        ]
        return Motion(equations, names)

    def _blind(self) -> bool:
        """Whether SymPy knows of conditions on angles that points here do not respect."""
        atoms = [sympy.sympify(atom) for _, atom, value in self.given.substitutions for atom in (atom, *_atoms(value))]
        turning = [atom for atom, word in self.reader.atoms.words.items() if word in self.reader.angles.met]
        return any(_assumed(atom) for atom in atoms) or any(atom.is_algebraic or atom.is_zero for atom in turning)


def _rank(columns: int, rows: int) -> int:
    """How many independent equations say that the columns are orthonormal."""
    return columns * (columns + 1) // 2


def _atoms(value: Any) -> Iterator[Any]:
    yield from value.atoms(sympy.Symbol, sympy.core.function.AppliedUndef)


def _assumed(atom: Any) -> dict[str, bool]:
    """What SymPy knows of an atom, beyond its being real."""
    return {key: known for key in ASSUMPTIONS if (known := getattr(atom, f"is_{key}")) is not None}


def _agrees(value: Exact, wanted: Mapping[str, bool]) -> bool:
    number = value.as_rational
    exact = sympy.sympify(value.text("pi")) if number is None else sympy.Rational(number.numerator, number.denominator)
    return all(getattr(exact, f"is_{key}") is known for key, known in wanted.items())


def _matrix(nodes: list[Node], shape: tuple[int, int]) -> Node:
    rows, columns = shape
    if shape == (1, 1):
        return nodes[0]
    return Block(tuple(tuple(nodes[i * columns : (i + 1) * columns]) for i in range(rows)))
