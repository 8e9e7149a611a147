"""The certificate of what was proved of a question: in the prover's names, as the checker reads it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

from chasles.algebra.groebner import Combination
from chasles.algebra.rings import written as text_of
from chasles.checker.expressions.asked import Asked
from chasles.checker.expressions.proof import claims_of
from chasles.checker.expressions.quantities import is_atom
from chasles.checker.expressions.reading_of_proof import Proven
from chasles.checker.sparse import ZERO, Polynomial, Rejected, limited
from chasles.from_sympy.elementary import Elementary
from chasles.from_sympy.fact_labels import FactLabels
from chasles.from_sympy.given_equations import SideConditions
from chasles.from_sympy.naming import spelled, written
from chasles.from_sympy.opening import FunctionSymbol
from chasles.from_sympy.reader import Reader
from chasles.from_sympy.roots import Roots
from chasles.points.search import Search
from chasles.problems.context import Context
from chasles.problems.variables import Untreatable
from chasles.prover.certifying import ProvedEntry
from chasles.vocabulary import Node, Power, Scale

MOST_PRODUCTS = 500_000
"""So many products of terms are formed at most to see which facts of the checker a proof rests on."""
ALWAYS = ("variant", "names", "witness")
"""What a certificate says even where there is nothing to be said."""


@dataclass(frozen=True, slots=True)
class SquaresAgainst:
    """Squares with weights of at least zero, the first positive, that add up to a combination of what is zero."""

    squares: list[tuple[Polynomial, Polynomial]]
    cofactors: Combination


@dataclass(frozen=True, slots=True)
class Writing:
    """Writes the certificate of a question.

    The facts from which an entry follows are found among those that the checker reads, as polynomials.
    """

    asked: tuple[Any, Any, Any, Any]
    reader: Reader
    given: SideConditions
    roots: Roots
    search: Search
    elementary: Elementary

    def __call__(
        self,
        context: Context,
        done: list[ProvedEntry],
        witness: Mapping[str, Any],
        variant: int = 0,
        impossible: SquaresAgainst | None = None,
    ) -> dict[str, Any]:
        """All that the checker needs, as text; `variant` says how the problem differs from the question."""
        ring = context.field.ring
        certificate: dict[str, Any] = {
            "variant": variant,
            "names": {word.name: str(atom) for atom, word in self.reader.atoms.words.items()},
            "positive": list(self._positive(context)),
            "squares": list(self._squares(context)),
            "turned": _by_label(self.elementary.halvings),
            "raised": _by_label(self.elementary.multiples),
            "angles": {word.name: _product(powers) for word, powers in self.reader.angles.products.items()},
            "substituted": {str(atom): text for text, atom, _ in self.given.substitutions},
            "words": list(self._words(context)),
            "roots": list(self._values(context)),
            "equal": list(self._equal(context)),
            "frames": [
                {"rows": [list(row) for row in frame.rows], "proper": frame.proper}
                for frame in self.search.frames
                if len(frame.rows) == len(frame.rows[0])
            ],
            "divisors": [text_of(ring, atom) for _, atom in context.nonzero],
            "witness": self._witness(witness),
        }
        certificate = {part: said for part, said in certificate.items() if said or part in ALWAYS}
        try:
            with limited(MOST_PRODUCTS):
                entries = dict(self._entries(context, done, certificate, impossible))
        except Rejected as reason:
            return certificate | {"unread": str(reason)}
        if not any("times" in said for said in entries.values()):
            certificate.pop("divisors", None)
        return certificate | ({"entries": entries} if entries else {})

    def _positive(self, context: Context) -> Iterator[str]:
        """What is positive because of logarithms."""
        for e, sign in self.elementary.signs.items():
            if not is_atom(e):
                with suppress(KeyError, Untreatable):
                    yield _text(context, self.reader(sign * e))
            elif not isinstance(e, FunctionSymbol):
                yield f"{sign}*{self._name(e)}"

    def _squares(self, context: Context) -> Iterator[dict[str, Any]]:
        """Sums of squares that are given to vanish."""
        for found in self.given.squares:
            with suppress(KeyError, Untreatable):
                squares = [[_text(context, self.reader(part)) for part in pair] for pair in found.squares]
                yield {"of": [[found.label, _text(context, self.reader(found.factor))]], "squares": squares}

    def _name(self, atom: Any) -> str:
        """The name of the word for an atom, or its spelling if it has none."""
        named = (word.name for known, word in self.reader.atoms.words.items() if str(known) == str(atom))
        return next(named, str(atom))

    def _words(self, context: Context) -> Iterator[list[str]]:
        for word, inside in self._defined():
            match inside:
                case Power(of, 2):
                    yield [str(word), "abs", _text(context, of)]
                case _:
                    yield [str(word), "sqrt", _text(context, inside)]

    def _values(self, context: Context) -> Iterator[list[Any]]:
        """Roots by their squares; what a word is the root of is said already."""
        own = {_text(context, inside): f"1*{word}" for word, inside in self._defined()}
        said: dict[str, list[str]] = {}
        for square, root in self.roots.values:
            # What is gone from the question has no variable any more.
            with suppress(KeyError):
                said[_text(context, square)] = list(_factors(context, root))
        yield from ([square, factors] for square, factors in said.items() if factors != [own.get(square)])

    def _defined(self) -> Iterator[tuple[Node, Node]]:
        for hypothesis in self.roots.hypotheses:
            if hypothesis.kind == "root":
                word, inside = hypothesis.subjects
                yield word, inside

    def _equal(self, context: Context) -> Iterator[list[list[str]]]:
        for hypothesis in self.roots.hypotheses:
            if hypothesis.kind == "consequence":
                ((absolute, product),) = hypothesis.equations
                yield [list(_factors(context, absolute)), [_text(context, product)]]

    def _witness(self, witness: Mapping[str, Any]) -> dict[str, str]:
        theta = self.search.theta
        name = "pi" if theta is None else spelled(theta.name, {w.name: e for w, e in self.reader.atoms.origins.items()})
        return {key: written(value, name) for key, value in sorted(witness.items())}

    def _entries(
        self, context: Context, done: list[ProvedEntry], certificate: dict[str, Any], impossible: SquaresAgainst | None
    ) -> Iterator[tuple[str, dict[str, Any]]]:
        """What is to be said of entries that do not vanish as they are read."""
        asked = Asked(*self.asked)
        reading = Proven(asked, certificate)
        claims = claims_of(asked, reading, certificate)
        labels = FactLabels(asked, reading, certificate)
        if impossible:
            squares = [[text_of(context.field.ring, part) for part in pair] for pair in impossible.squares]
            of = [[*pair] for pair in labels.cofactors(context, impossible.cofactors).items()]
            certificate["squares"] = [*certificate.get("squares", ()), {"of": of, "squares": squares}]
        for entry in done:
            row, column = entry.place
            if reading.vanishes(claims.get((row - 1, column - 1), ZERO)):
                continue
            times = {str(k): power for k, power in enumerate(entry.ratio.denominator) if power}
            cofactors = labels.cofactors(context, entry.cofactors or {})
            if impossible:
                cofactors = {
                    f"square {len(self.given.squares)} 1,1": text_of(context.field.ring, entry.ratio.numerator)
                }
            said: dict[str, Any] = ({"times": times} if times else {}) | ({"cofactors": cofactors} if cofactors else {})
            yield f"{row},{column}", said


def _by_label(entries: Mapping[tuple[int, int], int]) -> dict[str, int]:
    """What is said of entries, by row and column counted from one."""
    return {f"{i + 1},{j + 1}": said for (i, j), said in entries.items()}


def _product(powers: Mapping[Any, int]) -> str:
    return "*".join(word.name if power == 1 else f"{word.name}^{power}" for word, power in powers.items())


def _text(context: Context, node: Node) -> str:
    return text_of(context.field.ring, context.unfold(node)[0][0].numerator)


def _factors(context: Context, node: Node) -> Iterable[str]:
    match node:
        case Scale(one, other):
            yield from _factors(context, one)
            yield from _factors(context, other)
        case _:
            yield _text(context, node)
