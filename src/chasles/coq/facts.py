"""What a proof knows before it comes to its goals: norms, cosines, integrals, what is not zero and what vanishes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from chasles import vocabulary as w
from chasles.checker.quantities import squeezed
from chasles.checker.sparse import ZERO, Polynomial, cleared, exponents, packed
from chasles.coq.expressions import ATOM, Unsaid
from chasles.coq.motion import Instant
from chasles.coq.polynomials import Polynomials, in_units, literal
from chasles.coq.sources import StatedEntry
from chasles.coq.statement import CoqStatement


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
        self._integrals: list[tuple[str, w.Integral, str]] = []

    def polynomial(self, label: str) -> str:
        """What vanishes, by its label."""
        return self.spell(self.reading.vanishing[label])

    # Norms: each one a number whose square is known, and that is not negative.

    def named_norm(self, node: w.Norm) -> Iterator[str]:
        """A norm as a number n."""
        name = f"norm'{len(self._norms)}"
        self._norms[node.of] = name
        vector = self.instant.spelling.matrix(node.of, ATOM)
        if not self.reading.keeps_squares:
            yield f"rewrite ?(norm_square {vector}), ?(norm_fourth {vector})."
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
                steps = f"apply (same_root _ _ _ _ {known}); words; identity"
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
            steps = f"apply Rminus_diag_uniq; refine (eq_trans _ square'{name}); words; identity"
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
            turns = in_units(self.reading, call.argument, lambda of: self.spell.angle(of, Fraction(1)))
            steps = f"first [turned | turned_by {turns}]"
            yield f"assert (value'{name} : {name} = {value}) by (rewrite of'{name}; words; {steps})."
            yield f"clear of'{name}. subst {name}."

    # Integrals.

    def named_integrals(self) -> Iterator[str]:
        """Integrals as numbers and matrices of their own."""
        for node in dict.fromkeys(self.said.integrals):
            name = f"integral'{len(self._integrals)}"
            self._integrals.append((name, node, f"of'{name}"))
            side = self.instant.spelling.number if node.shape == (1, 1) else self.instant.spelling.matrix
            yield f"remember {side(node, ATOM)} as {name} eqn:of'{name}; revert of'{name}."

    def of_integrals(self, divided: bool) -> Iterator[str]:
        """What they are, and what their rates are, in moments: of those without divisors, or of the others."""
        rates = [(name, node, f"def'{name}") for node, name in self.instant.integrals.items()]
        if self.said.integrals and not divided:
            yield "destruct linear' as [plus' scale']."
        for name, node, known in (*self._integrals, *rates):
            if divided != self._has_divisors(node):
                continue
            entries = [[self.spell(entry) for entry in row] for row in self.reading(node)]
            value = entries[0][0] if node.shape == (1, 1) else literal(entries)
            yield f"assert (value'{name} : {name} = {value})."
            yield f"{{ rewrite {known}. words. entries."
            for entry, running in self._integrands(node):
                yield f"  - {self._integrated(entry, running)}"
            yield "}"
            yield f"clear {known}. subst {name}."

    def _has_divisors(self, node: w.Node) -> bool:
        divisors = set(range(len(self.reading.nonzero)))
        return any(not divisors.isdisjoint(entry.places) for row in self.reading(node) for entry in row)

    def _integrands(self, node: w.Node) -> Iterator[tuple[Polynomial, frozenset[w.Symbol]]]:
        """What is integrated, entry by entry, and what differs from element to element there."""
        integral = self.instant.told(node) if isinstance(node, w.Rate) else node
        assert isinstance(integral, w.Integral)
        for row in self.reading(integral.of):
            for entry in row:
                yield self.reading.rate(entry) if isinstance(node, w.Rate) else entry, integral.running

    def _integrated(self, entry: Polynomial, running: frozenset[w.Symbol]) -> str:
        """The steps by which an integral is a sum of multiples of moments."""
        parts: dict[int, Polynomial] = {}
        for monomial, coefficient in entry.terms.items():
            kinds = [(k, e, self.reading.variables[k]) for k, e in exponents(monomial)]
            inside = sum(packed(k, e) for k, e, what in kinds if what[0] == "entry" and what[1] in running)
            parts[inside] = parts.get(inside, ZERO) + Polynomial({monomial - inside: coefficient}, entry.below)
        products = [f"{self.spell(rest)} * {self.spell(Polynomial({inside: 1}))}" for inside, rest in parts.items()]
        products = products or ["0 * 0"]
        total = " + (".join(products) + ")" * (len(products) - 1)
        split = "rewrite plus'; " * (len(products) - 1)
        return (
            f"transitivity (integral (fun b => {total})); [f_equal; extensionality b; rewrite ?norm_square; words; "
            f"identity | {split}rewrite !scale'; spelled_out integral; identity]."
        )

    @property
    def names_of_words(self) -> list[str]:
        """What to call the premises that say what these numbers and matrices are."""
        named = [*(name for name, *_ in self._integrals), *(name for name, _ in self._angles)]
        return [f"of'{name}" for name in reversed(named)]

    # What is not zero, and what vanishes.

    def nonzero(self) -> Iterator[str]:
        """The factors that are not zero."""
        problem = self.instant.problem
        divisors = [(h, node) for h in problem.hypotheses for node in h.nonvanishing]
        for k, (hypothesis, node) in enumerate(divisors):
            if hypothesis.kind == "inequality" and node != hypothesis.subjects[0]:
                continue  # the root of the difference, of which no statement speaks
            if any(self.said.runs(part) for part in w.walk(node)) and not isinstance(node, w.Integral):
                continue
            source = self.instant.source(hypothesis)
            if hypothesis.kind == "definite":
                if hypothesis.subjects[0].shape != (3, 3):
                    raise Unsaid(f"the determinant of a matrix that is {hypothesis.text}")
                source = f"(Rgt_not_eq _ _ (definite_determinant _ {source}))"
            elif hypothesis.kind in ("positive", "inequality"):
                source = f"(Rgt_not_eq _ _ {source})"
            factor = self.spell(self.reading.nonzero[k])
            below = self.spell.product(cleared(self.reading(node)[0][0], self.reading.nonzero)[1])
            lemma = f"not_zero_factor _ _ (1 / ({below}))" if below else "not_zero_as _ _"
            yield f"assert (nonzero'{k} : {factor} <> 0) by (apply ({lemma} {source}); words; identity)."

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
            return f"apply (equal_numbers ({below}) _ _ _ square'{self.spell.norms[of]}); words; identity"
        if label not in self.sources:
            raise Unsaid(f"what vanishes as {label}")
        source = self.sources[label]
        below = self.spell.product(source.below) or "1"
        equation = self.instant.equation(source)
        squares = "".join(f"rewrite ?{each}; " for each in self.squares)
        steps = f"first [reckon | {squares}reckon]" if squares else "identity"
        if source.left.shape == (1, 1):
            return f"apply (equal_numbers ({below}) _ _ _ {equation}); words; {steps}"
        return f"apply (equal_entries ({below}) _ _ {source.i} {source.j} _ {equation}); words; {steps}"
