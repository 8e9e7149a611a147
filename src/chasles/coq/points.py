"""A point that satisfies what a statement assumes, in Coq: there is one, or at one the statement fails.

What moves does so through the point. Nothing is looked for: the values are those of a verdict.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import cached_property
from typing import Any

from chasles import vocabulary as w
from chasles.coq.expressions import Spelling, Unsaid
from chasles.coq.polynomials import in_units, multiple
from chasles.coq.proof import theorem
from chasles.coq.sentences import assumed
from chasles.coq.statement import CoqStatement, Premise
from chasles.coq.values import Angle, PointValues, rational
from chasles.statements import Hypothesis
from chasles.verdict import Counterexample

LOW = 100
"""An angle of which the cosine and sine are given is as large as one likes."""
COMPARED = ("positive", "nonzero", "evident")
"""What is said of a scalar, compared with zero."""
SQUARES = "rewrite ?norm_square, ?norm_fourth; "
KNOWN = "pose proof now' as known'; unfold T in known'; decompose [and] known'; "
"""What is not zero at an instant becomes known."""


def refutation(name: str, said: CoqStatement, found: Counterexample) -> str:
    """The theorem that a statement fails, which is said under that name. Raises `Unsaid` where no proof is known."""
    point = _CoqPoint(said, PointValues(said, found.at))
    return theorem(name, ["intro claim'.", *point.steps(), *point.contradiction(found)])


def existence(name: str, said: CoqStatement, witness: Mapping[str, Any]) -> str:
    """The theorem that there is what satisfies the premises, which is said under that name; all is at rest there."""
    point = _CoqPoint(said, PointValues(said, witness, at_rest=True))
    if not said.premises:
        raise Unsaid("nothing is assumed")
    *others, last = [each.name for each in said.premises]
    proof = "".join(f"conj {each} (" for each in others) + last + ")" * len(others)
    return theorem(name, [*point.steps(), f"exists {point.arguments.replace(' ', ', ')}.", f"exact ({proof})."])


class _CoqPoint:
    def __init__(self, said: CoqStatement, values: PointValues) -> None:
        self.said, self.values = said, values
        self.arguments = " ".join(name for name, _ in said.binders)
        self._unfold = f"cbv beta delta [{' '.join(values.nodes)}]"
        self._rewriting = SQUARES

    def steps(self) -> Iterator[str]:
        """The values under their names, and that they satisfy each premise, under its name."""
        for place, angle in self.values.angles.items():
            yield from self._angle_known(place, angle)
        for name, node in self.values.nodes.items():
            function = "fun t : R => " * self.said.moves(node)
            yield f"pose ({name} := {function}{self.values.in_time(node)})."
        if self.said.timed:
            during = " /\\ ".join([*self._open, "True"])
            yield f"pose (T := fun t : R => {during})."
            shown = "".join(
                f"split; [apply ({_lemma(kind)} {value}); [compared | {self._at_angles}computed] |]; "
                for kind, value in self._open.values()
            )
            yield f"assert (now : T 0) by (unfold T; {shown}exact Logic.I)."
        yield from self._words_known()
        for premise in self.said.premises:
            yield f"assert ({premise.name} : {assumed(premise)})."
            yield f"{{ {self._satisfied(premise)}. }}"

    @cached_property
    def _open(self) -> dict[str, tuple[str, str]]:
        """What is positive or not zero at the point, and need not be so at all times; its kind and its value there."""
        return {
            self._condition(h): (h.kind, self.values.number(self.values.at_once(node)[0][0]))
            for h in self.said.problem.hypotheses
            for node in h.nonvanishing
            if h.kind in COMPARED and not self.values.is_constant(node)
        }

    def _condition(self, hypothesis: Hypothesis) -> str:
        return f"{self.values.in_time(hypothesis.nonvanishing[0])} {'> 0' if hypothesis.kind == 'positive' else '<> 0'}"

    def _angle_known(self, place: int, angle: Angle) -> Iterator[str]:
        """An angle, of which the cosine and sine of a multiple are known."""
        symbol, unit, name = angle
        point = self.values.point
        bare = point.get(self.values.reading.places[symbol.name])
        cosine, sine = (rational(point[k][0]) for k in (place, place + 1))
        of = multiple(name, unit)
        if bare is not None and (self.values.has_pi or not bare[0]):
            yield f"assert (is'{name} : exists x, x = {_quarters(bare[0])}) by (eexists; reflexivity)."
            yield f"destruct is'{name} as [{name} is'{name}]."
            yield f"assert (cos'{name} : cos {of} = {cosine}) by (rewrite is'{name}; turned)."
            yield f"assert (sin'{name} : sin {of} = {sine}) by (rewrite is'{name}; turned)."
            return
        yield from angle_with(name, unit, cosine, sine, LOW)

    def _words_known(self) -> Iterator[str]:
        """The values of cosines, sines and norms, the innermost first; of what moves, at the instant 0."""
        now = Spelling(self.said.names, lambda node, name: name + " 0" * self.said.moves(node))
        nodes = dict.fromkeys(node for node in self.said.nodes if isinstance(node, w.Call | w.Norm))
        names: list[str] = []
        for node in sorted(nodes, key=lambda each: sum(1 for _ in w.walk(each))):
            try:
                [[value]] = self.values.at_once(node)
            except Unsaid:
                continue  # a norm of which the square occurs
            always = any(map(self.said.moves, w.walk(node))) and self.values.is_constant(node)
            text = f"forall t : R, {self.said.spelling.number(node)}" if always else now.number(node)
            if isinstance(node, w.Norm):
                steps = f"apply norm_is; [compared | {self._computed}]"
            else:
                turned = self.values.of_angles(self.values.reading(node)[0][0])
                steps = f"{self._unfold}; rewrite ?Rmult_0_l, ?Rplus_0_r; transitivity {turned}; "
                steps += f"[{self._turning(node)} | {self._at_angles}computed]"
            names.append(f"word'{len(names)}")
            steps = f"{'intros; ' * always}{steps}"
            yield f"assert ({names[-1]} : {text} = {self.values.number(value)}) by ({steps})."
            known = ", ".join(f"?{each}" for each in reversed(names))
            self._rewriting = f"rewrite {known}, ?norm_square, ?norm_fourth; "

    def _turning(self, node: w.Call) -> str:
        """The step by which a cosine or sine is made of those of the angles at the point."""
        names = {symbol: name for symbol, _, name in self.values.angles.values()}
        try:
            return f"first [turned | turned_by {in_units(self.values.reading, node.argument, names.__getitem__)}]"
        except (KeyError, ValueError):  # not a sum of these alone
            return "turned"

    @property
    def _computed(self) -> str:
        """The step that computes what is equal."""
        return f"{self._rewriting}{self._unfold}; {self._at_angles}computed"

    @cached_property
    def _at_angles(self) -> str:
        known = "".join(f", ?cos'{name}, ?sin'{name}" for *_, name in self.values.angles.values())
        return f"rewrite ?Rmult_0_l, ?Rplus_0_r{known}; " if known else ""

    def _satisfied(self, premise: Premise) -> str:
        """The steps by which a premise is satisfied."""
        if premise.name == "open'T":
            continuous = "(apply open_positive || apply open_nonzero); intro t; eexists; rates"
            return f"repeat apply open_both; first [exact open_all | {continuous}]"
        if premise.name.startswith("rate'"):
            assert isinstance(premise.about, w.Node)
            return self._rated(premise.about)
        steps = f"intros t now'; {KNOWN}" * premise.moves
        kind = premise.about.kind if isinstance(premise.about, Hypothesis) else ""
        if kind in COMPARED:
            assert isinstance(premise.about, Hypothesis)
            value, known = self.values.in_time(premise.about.nonvanishing[0]), "compared"
            if (condition := self._condition(premise.about)) in self._open:
                place = list(self._open).index(condition)
                known = f"exact (proj1 {'(proj2 ' * place}now'{')' * place})"
            return f"{steps}apply ({_lemma(kind)} {value}); [{known} | {self._computed}]"
        if kind == "definite":
            return f"{steps}{self._unfold}; apply definite_by_minors; computed"
        return f"{steps}unfold orthonormal, rotation, half_turn; repeat apply conj; {self._computed}"

    def _rated(self, node: w.Node) -> str:
        rows, columns = node.shape
        is_scalar = (rows, columns) == (1, 1)
        if not any(self.values.entry(entry) != "(0)" for row in self.values.reading(node) for entry in row):
            rest = f"exact ({'scalar_rest' if is_scalar else f'@rest {rows} {columns}'} T _)"
            return f"first [{rest} | {self._unfold}; {rest}]"
        places = "" if is_scalar else f" {_nested(rows)} {_nested(columns)}"
        steps = f"intros t now'{places}; {KNOWN}{self._unfold}; words"
        return f"{steps}; (eapply D_same; [rates | {self._unfold}; computed])"

    def contradiction(self, found: Counterexample) -> Iterator[str]:
        """An equation of the statement, which is false of one entry at the point."""
        count, left, right = self._differing(found)
        goals = self.said.problem.goals
        premises = " ".join(each.name for each in self.said.premises)
        yield f"specialize (claim' {self.arguments} {premises}{' 0 now' * self.said.timed})."
        yield from claim_alone(count, len(goals))
        yield "cbv beta in claim'."
        if not (goals[count].left.is_scalar and goals[count].right.is_scalar):
            yield f"apply (f_equal (fun A => entry A {found.entry[0] - 1} {found.entry[1] - 1})) in claim'."
        yield f"apply (differ _ _ {left} {right} claim'); [{self._computed} | {self._computed} | compared]."

    def _differing(self, found: Counterexample) -> tuple[int, str, str]:
        """Which of the equations fails, and the values of its sides."""
        i, j = (place - 1 for place in found.entry)
        for count, goal in enumerate(self.said.problem.goals):
            if goal.label == found.goal:
                left, right = (self.values.at_once(side)[i][j] for side in goal.sides)
                if left != right:
                    return count, self.values.number(left), self.values.number(right)
        raise Unsaid("both sides are the same at the point")


def angle_with(name: str, unit: Fraction, cosine: str, sine: str, low: int) -> Iterator[str]:
    """The steps to an angle, beyond some number, of a multiple of which this is the cosine and this the sine."""
    known = f"cos'{name} & sin'{name} & low'{name}"
    yield f"destruct (angle_with {rational(unit)} {cosine} {sine} {low}) as ({name} & {known}); [lra | lra |]."
    yield f"replace ({rational(unit)} * {name}) with {multiple(name, unit)} in cos'{name}, sin'{name} by field."


def claim_alone(count: int, several: int) -> Iterator[str]:
    """The step to one of several equations that are claimed, if there are more."""
    if several > 1:
        yield f"destruct claim' as ({'_ & ' * count}claim'{' & _' * (count < several - 1)})."


def _lemma(kind: str) -> str:
    """By which lemma something is positive, or not zero, if what it is equal to is."""
    return "positive_as" if kind == "positive" else "not_zero_as"


def _nested(size: int) -> str:
    """The pattern that tells so many places apart from all others."""
    return "?" if not size else f"[|{_nested(size - 1)}]"


def _quarters(turns: Fraction) -> str:
    """A multiple of pi, as a sum of quarter turns where it is one."""
    quarters = 2 * turns
    if quarters.denominator != 1:
        return f"{rational(turns)} * PI"
    total = " + ".join(["PI / 2"] * abs(int(quarters))) or "0"
    return f"({total})" if turns >= 0 else f"(- ({total}))"
