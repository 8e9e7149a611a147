"""Counterexamples of `prove` as theorems for Coq: what was asked does not hold for all, since it fails at a point.

The values are those of the verdict. Cosines and sines of angles are known there, and each function of a number has a
rational value; nothing here has to be believed.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from typing import Any

import sympy

from chasles import vocabulary as w
from chasles.checker.sparse import Rejected
from chasles.coq.expressions import Unsaid
from chasles.coq.of_sympy import ScalarStatement, SympyStatement
from chasles.coq.own_inequalities import OwnInequalities, as_asked
from chasles.coq.points import angle_with, claim_alone
from chasles.coq.polynomials import multiple
from chasles.coq.proof import theorem
from chasles.coq.scalar_values import ScalarValues, spelled_number
from chasles.coq.sentences import Claimed, assumed, failing, introduced
from chasles.statements import Goal, Hypothesis
from chasles.verdict import Counterexample
from chasles.vocabulary.functions import FunctionOf

LOW = 0
"""An angle of which the cosine and sine are given may be as large as one likes."""
SHOWN = {
    "sqrt": "apply (root_value _ _ _ eq_refl); [compared | {0}; computed]",
    "Rabs": "apply (size_value _ _ _ eq_refl); [compared | {0}; computed]",
    "tan": "unfold tan; {0}; computed",
}
"""By which step a function has a value; those without one here have it by cases."""
AT = {
    "exp": "rewrite exp_0",
    "ln": "rewrite ln_1",
    "sinh": "rewrite sinh_0",
    "cosh": "rewrite cosh_0",
    "tanh": "unfold tanh; rewrite sinh_0, cosh_0",
    "asin": "rewrite ?asin_0, ?asin_1",
    "acos": "rewrite ?acos_0, ?acos_1",
    "atan": "rewrite ?atan_0, ?atan_1",
    "Rpower": "unfold Rpower; rewrite ?ln_1, ?Rmult_0_l, ?Rmult_0_r, ?exp_0; rewrite ?Rmult_1_l, ?exp_ln by compared",
}
"""How functions are known where their arguments are 0 or 1, and no further."""
TURNS = (
    *("cos_plus", "sin_plus", "cos_minus", "sin_minus", "cos_neg", "sin_neg"),
    *("cos_0", "sin_0", "cos_PI", "sin_PI", "cos_PI2", "sin_PI2"),
)
"""By which a cosine or sine becomes one of angles that are known."""


def as_refutation(
    found: Counterexample, lhs: Any, rhs: Any, given: Any, nonzero: Any, claimed: Any = None, name: str = ""
) -> Claimed:
    """That what was asked does not hold for all, for Coq: a statement and its proof, or `why_not`."""
    claim = Claimed(name, "asked, which fails", name, f"{lhs} = {rhs}" if claimed is None else str(claimed))
    said = ""
    try:
        question = as_asked((lhs, rhs, given, nonzero))
        asked = question.asked
        needs = (*(f"{e} != 0" for e in asked.nonzero), *_where_defined((*asked.left.values(), *asked.right.values())))
        statement = ScalarStatement(asked, tuple(dict.fromkeys(needs)), question.values, claimed)
        own: SympyStatement = statement
        if question.compared:
            own = OwnInequalities(statement, question.compared, question.stand)
        own = own if claimed is None else own.claiming(claimed)
        said = failing(name, own)
        proof = theorem(name, _ScalarPoint(own, found).steps())
    except (Rejected, Unsaid) as reason:
        return replace(claim, said=said, why_not=str(reason))
    except (ArithmeticError, LookupError, ValueError, TypeError, sympy.PolynomialError):
        return replace(claim, said=said, why_not="no proof is written with such a point")
    return replace(claim, said=said, proof=proof)


def _where_defined(sides: Iterable[Any]) -> Iterator[str]:
    """That both sides have values: divisors do not vanish, and roots and logarithms are of what has them."""
    whole = sympy.Tuple(*sides)
    for power in sorted(whole.atoms(sympy.Pow), key=str):
        if power.exp.is_negative and not power.base.is_nonzero:
            yield f"{power.base} != 0"
        if power.exp.is_Rational and power.exp.q % 2 == 0 and not power.base.is_nonnegative:
            yield f"{power.base} >= 0"
    for function in sorted(whole.atoms(sympy.log, sympy.tan), key=str):
        (argument,) = function.args
        if isinstance(function, sympy.tan):
            yield f"cos({argument}) != 0"
        elif not argument.is_positive:
            yield f"{argument} > 0"


class _ScalarPoint:
    def __init__(self, said: SympyStatement, found: Counterexample) -> None:
        self.said, self.values = said, ScalarValues(said, found)
        self._words: dict[w.Node, str] = {}
        """The names under which the values of functions are known."""

    def steps(self) -> Iterator[str]:
        """All steps: the values under their names, that they satisfy the premises, and the contradiction."""
        yield "intro claim'."
        for symbol, value in self.values.numbers.items():
            yield f"destruct (named {spelled_number(value)}) as [{symbol} is'{symbol}]."
        for symbol, (unit, cosine, sine) in self.values.angles.items():
            yield from angle_with(str(symbol), unit, spelled_number(cosine), spelled_number(sine), LOW)
        for premise in self.said.premises:
            about = premise.about
            assert isinstance(about, Goal | Hypothesis)
            sides = about.sides if isinstance(about, Goal) else about.subjects
            yield from self._known(sides)
            if isinstance(about, Goal) and self.values(sides[0]) != self.values(sides[1]):
                raise Unsaid("no proof is written with a point that leaves something out")
            yield f"assert ({premise.name} : {assumed(premise)}) by ({self._satisfied(about)})."
        yield f"specialize (claim' {given})." if (given := introduced(self.said)) else ""
        yield from self._contradiction()

    def _satisfied(self, about: Goal | Hypothesis) -> str:
        """The step by which a premise is satisfied."""
        if isinstance(about, Goal):
            return f"{self._computed}; computed"
        replaced = ""
        for subject in about.subjects:
            with suppress(Unsaid):  # then it is an angle
                number = f"({self.said.spelling.number(subject)}) with {spelled_number(self.values(subject))}"
                replaced += f"replace {number} by (symmetry; {self._computed}; computed); "
        return f"{replaced}compared"

    def _contradiction(self) -> Iterator[str]:
        goals = list(self.said.problem.goals)
        if self.said.claimed is None:
            places = [k for k, goal in enumerate(goals) if self._differ(*goal.sides)]
            if not places:
                raise Unsaid("no proof is written where the values are not rational")
            yield from claim_alone(places[0], len(goals))
            goals = [goals[places[0]]]
        spelled = self.said.spelling.number
        sides = dict.fromkeys(side for goal in goals for side in goal.sides if not isinstance(side, w.Number))
        sides = dict.fromkeys(sorted(sides, key=lambda side: -len(spelled(side))))  # one may be in another
        yield from self._known(sides)
        for count, side in enumerate(sides):
            text = spelled(side)
            value = spelled_number(self.values(side))
            yield f"assert (side'{count} : {text} = {value}) by ({self._computed}; computed)."
            yield f"try rewrite side'{count} in claim'."
        yield "pose proof PI_RGT_0; first [lra | apply claim'; lra | intuition lra]."

    def _differ(self, left: w.Node, right: w.Node) -> bool:
        try:
            return bool(self.values(left) != self.values(right))
        except Unsaid:
            return False

    def _known(self, sides: Iterable[w.Node]) -> Iterator[str]:
        """The values of functions in these, the innermost first."""
        nodes = {part for side in sides for part in w.walk(side) if isinstance(part, w.Call | FunctionOf)}
        tangents = [each for each in nodes if isinstance(each, FunctionOf) and each.function == "tan"]
        nodes |= {w.Call(function, each.arguments[0]) for each in tangents for function in ("cos", "sin")}
        spelled = self.said.spelling.number
        for node in sorted(nodes - self._words.keys(), key=lambda each: (len(spelled(each)), spelled(each))):
            name = f"word'{len(self._words)}"
            yield f"assert ({name} : {spelled(node)} = {spelled_number(self.values(node))}) by ({self._shown(node)})."
            self._words[node] = name

    def _shown(self, node: w.Node) -> str:
        """The step by which a function has its value."""
        if isinstance(node, w.Call):
            of = f"transitivity ({node.function} {self._total(node.argument)})"
            return f"{of}; [f_equal; {self._computed}; computed | {self._turned}; computed]"
        assert isinstance(node, FunctionOf)
        if how := SHOWN.get(node.function):
            return how.format(self._computed)
        if lemma := AT.get(node.function):
            values = [self.values(each) for each in node.arguments]
            if not {0, 1} & set(values):
                raise Unsaid("no proof is written where the values are not rational")
            at = " ".join(map(spelled_number, values))
            equal = f"transitivity ({node.function} {at}); [f_equal; {self._computed}; computed | ]"
            return f"{equal}; {lemma}; computed"
        return f"{self._computed}; by_cases"

    def _total(self, argument: w.Node) -> str:
        """An angle as a sum of those of which cosine and sine are known, and of right angles."""
        parts = []
        for term in sympy.Add.make_args(sympy.expand(self.values.of(argument))):
            if term == 0:
                continue
            times, symbol = term.as_coeff_Mul()
            unit, *_ = self.values.angles[symbol] if symbol in self.values.angles else (Fraction(1, 2), 0, 0)
            count = times / sympy.Rational(unit.numerator, unit.denominator)
            if not count.is_Integer or not (symbol in self.values.angles or symbol is sympy.pi):
                raise Unsaid("no proof is written with a cosine of such a sum")
            angle = multiple("PI" if symbol is sympy.pi else str(symbol), unit)
            parts += [f"{'-' if count < 0 else '+'} {angle}"] * abs(int(count))
        return f"({' '.join(parts).removeprefix('+ ') or '0'})"

    @property
    def _turned(self) -> str:
        known = [f"{function}'{symbol}" for symbol in self.values.angles for function in ("cos", "sin")]
        return f"repeat first [{' | '.join(f'rewrite {each}' for each in (*TURNS, *known))}]"

    @property
    def _computed(self) -> str:
        """The step that puts in what is known."""
        known = [*reversed(self._words.values()), *(f"is'{symbol}" for symbol in self.values.numbers)]
        return "rewrite " + ", ".join(f"?{each}" for each in known) if known else "idtac"
