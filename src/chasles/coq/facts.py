"""What a proof knows before it comes to its goals: norms, cosines, integrals, what is not zero and what vanishes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property

from chasles import vocabulary as w
from chasles.checker.quantities import squeezed
from chasles.checker.sparse import cleared
from chasles.coq.expressions import ATOM, Unsaid
from chasles.coq.motion import Instant
from chasles.coq.polynomials import Polynomials
from chasles.coq.sources import StatedEntry
from chasles.coq.statement import CoqStatement

__all__ = ["KnownFacts"]


class KnownFacts:
    """Assertions, each with its proof, in the order in which they are needed."""

    def __init__(
        self, said: CoqStatement, spell: Polynomials, instant: Instant, sources: Mapping[str, StatedEntry]
    ) -> None:
        self.said, self.spell, self.instant, self.sources = said, spell, instant, sources
        self.reading = spell.reading
        self.squares: list[str] = []
        self._norms: dict[w.Node, str] = {}
        self._angles: list[tuple[str, w.Call]] = []
        self._integrals: list[tuple[str, w.Integral]] = []

    @cached_property
    def identity(self) -> str:
        """The step that shows an identity, the likelier one first."""
        return "fraction" if any(isinstance(node, w.Quotient | w.Vect) for node in self.said.nodes) else "identity"

    def polynomial(self, label: str) -> str:
        """What vanishes, by its label."""
        return self.spell(self.reading.vanishing[label])

    # Norms: each one a number whose square is known, and that is not negative.

    def named_norm(self, node: w.Norm) -> Iterator[str]:
        """A norm as a number n."""
        name = f"norm'{len(self._norms)}"
        self._norms[node.of] = name
        vector = self.instant.spelling.matrix(node.of, ATOM)
        yield f"generalize (norm_squared {vector}) (norm_not_negative {vector}); generalize (norm {vector});"
        yield f"  intros {name} square'{name} positive'{name}."

    def of_norms(self) -> Iterator[str]:
        """Norms with the same square are the same."""
        first: dict[int, str] = {}
        for of, name in self._norms.items():
            place = self.reading.place_of_norm(of)
            if place is None:
                continue
            if place in first:
                other = first[place]
                known = f"positive'{name} positive'{other} square'{name} square'{other}"
                steps = f"apply (same_root _ _ _ _ {known}); words; {self.identity}"
                yield f"assert (same'{name} : {name} = {other}) by ({steps})."
                yield f"subst {name}."
            else:
                first[place] = name
                self.spell.norms[self.reading.variables[place][1]] = name

    def of_squares(self) -> Iterator[str]:
        """What the squares of norms are."""
        for of, name in self.spell.norms.items():
            self.squares.append(f"squared'{name}")
            value = self.spell(self.reading(w.Dot(of, of))[0][0])
            steps = f"apply Rminus_diag_uniq; refine (eq_trans _ square'{name}); words; {self.identity}"
            yield f"assert (squared'{name} : {name} ^ 2 = {value}) by ({steps})."

    # Cosines and sines: of multiples of angles, by the addition formulas.

    def named_angles(self) -> Iterator[str]:
        """The cosine and the sine of whatever is not an angle as the certificate has it, as numbers."""
        for argument in dict.fromkeys(node.argument for node in self.said.nodes if isinstance(node, w.Call)):
            for function in ("cos", "sin"):
                call = w.Call(function, argument)
                text = self.instant.spelling.number(call, ATOM)
                if text != self.spell(self.reading.turned(call)).replace("((", "(").replace("))", ")"):
                    name = f"angle'{len(self._angles)}"
                    self._angles.append((name, call))
                    yield f"remember {text} as {name} eqn:of'{name}; revert of'{name}."

    def of_angles(self) -> Iterator[str]:
        """What they are."""
        for name, call in self._angles:
            value = self.spell(self.reading.turned(call))
            yield f"assert (value'{name} : {name} = {value}) by (rewrite of'{name}; words; turned)."
            yield f"clear of'{name}. subst {name}."

    @property
    def names_of_angles(self) -> list[str]:
        """What to call the premises that say of what angles these numbers are cosines and sines."""
        return [f"of'{name}" for name, _ in reversed(self._angles)]

    # Integrals.

    def named_integrals(self) -> Iterator[str]:
        """Integrals as numbers and matrices of their own."""
        if self.said.integrals:
            raise Unsaid("integrals")
        yield from ()

    def of_integrals(self) -> Iterator[str]:
        """What they are, in moments."""
        yield from ()

    # What is not zero, and what vanishes.

    def nonzero(self) -> Iterator[str]:
        """The factors that are not zero."""
        problem = self.instant.problem
        divisors = [(h, node) for h in problem.hypotheses for node in h.nonvanishing]
        for k, (hypothesis, _) in enumerate(divisors):
            source = self.instant.source(hypothesis)
            if hypothesis.kind == "definite":
                if hypothesis.subjects[0].shape != (3, 3):
                    raise Unsaid(f"the determinant of a matrix that is {hypothesis.text}")
                source = f"(Rgt_not_eq _ _ (definite_determinant _ {source}))"
            elif hypothesis.kind == "positive":
                source = f"(Rgt_not_eq _ _ {source})"
            factor = self.spell(self.reading.nonzero[k])
            yield f"assert (nonzero'{k} : {factor} <> 0) by (apply (not_zero_as _ _ {source}); words; {self.identity})."

    def vanishing(self, labels: list[str]) -> Iterator[str]:
        """What vanishes, of these labels."""
        for count, label in enumerate(labels):
            yield f"assert (fact'{count} : {self.polynomial(label)} = 0) by ({self._why(label)})."

    def _why(self, label: str) -> str:
        vanishing = self.reading.vanishing[label]
        if label.startswith("circle "):
            place = min(vanishing.places)
            _, angle, unit = self.reading.variables[place]
            return f"refine (eq_trans _ (circle {self.spell.angle(angle, unit)})); ring"
        if label.startswith("norm "):
            place = self.reading.places[squeezed(label.removeprefix("norm "))]
            of = self.reading.variables[place][1]
            below = self.spell.product(cleared(self.reading(w.Dot(of, of))[0][0], self.reading.nonzero)[1]) or "1"
            return f"apply (equal_numbers ({below}) _ _ _ square'{self.spell.norms[of]}); words; fraction"
        if label not in self.sources:
            raise Unsaid(f"what vanishes as {label}")
        source = self.sources[label]
        below = self.spell.product(source.below) or "1"
        equation = self.instant.equation(source)
        squares = "".join(f" rewrite ?{each};" for each in self.squares)
        if source.left.shape == (1, 1):
            return f"apply (equal_numbers ({below}) _ _ _ {equation}); words;{squares} fraction"
        return f"apply (equal_entries ({below}) _ _ {source.i} {source.j} _ {equation}); words;{squares} fraction"
