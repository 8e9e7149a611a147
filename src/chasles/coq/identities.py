"""Identities of `prove` as theorems for Coq: from the question and the certificate of its verdict.

Cosines and sines are taken apart, roots and absolute values become what the certificate says, and the difference of
both sides is a combination of what vanishes. Nothing here has to be believed.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from functools import reduce
from operator import mul
from typing import Any

import sympy

from chasles.checker.sparse import Rejected
from chasles.coq.exponentials import exponential, logarithm
from chasles.coq.expressions import Unsaid
from chasles.coq.of_sympy import ScalarStatement, SympyStatement
from chasles.coq.own_inequalities import OwnInequalities, as_asked
from chasles.coq.plain import PlainExpressions, text_of
from chasles.coq.proof import theorem
from chasles.coq.roots import root, words_named
from chasles.coq.scalar_points import as_refutation
from chasles.coq.sentences import NOW, Claimed, claiming, equal_rates, holding, introduced
from chasles.coq.turns import inverse, turned
from chasles.from_sympy.components import sides_of
from chasles.from_sympy.monotone import plainer
from chasles.from_sympy.sufficient import of_values, where_it_rises, with_name
from chasles.verdict import Fails, Holds, HoldsUnder, Verdict

GIVEN = re.compile(r"given (\d+) (\d+),(\d+)(?: d(\d+))?")
SQUARE = re.compile(r"square (\d+) (\d+),1")
TANGENT = re.compile(r"\btan ")
RATED = (sympy.sin, sympy.cos, sympy.exp)
"""Functions of which the theories know the rates."""
OTHERWISE = {
    "cases": "case by case",
    "substituted": "by putting in what is given",
    "frames": "of matrices of any size",
    "equal": "by products of roots",
    "turned": "by the angle of a point",
    "raised": "by the exponentials of both sides",
}
"""Parts of certificates of which no proof is written for Coq."""
READERS = (root, turned, inverse, exponential, logarithm)
COMPARED = ("", "apply by_square; ", "apply by_squares; [nonnegative | nonnegative |]; ")
"""By which step sides are equal, by the variant of a certificate: as they are, or since their squares are."""
BY_CASES = ("intros.", "repeat apply conj; by_cases.")
AS_SPELLED = ("intros.", "repeat apply conj; reflexivity.")


def as_theorem(
    verdict: Verdict,
    lhs: Any,
    rhs: Any,
    given: Any = (),
    nonzero: Any = (),
    claimed: Any = None,
    name: str = "identity",
) -> Claimed:
    """What the verdict of `chasles.prove` on this question says, for Coq, if it holds: a statement and its proof.

    Where the sides stand for an inequality, or for what joins several relations, that is `claimed`. Where there is no
    proof, or not even a statement, `why_not` says why. Raises TypeError for what does not hold.
    """
    if isinstance(verdict, Fails):
        return as_refutation(verdict.counterexample, lhs, rhs, given, nonzero, claimed, name)
    if not isinstance(verdict, Holds | HoldsUnder):
        raise TypeError(f"the verdict is {verdict.name}: only what holds is a theorem")
    claim = Claimed(name, "asked", name, f"{lhs} = {rhs}" if claimed is None else str(claimed))
    said = ""
    try:
        if "induction" in verdict.certificate:
            raise Unsaid("no proof is written of what is shown by induction")
        if claimed is not None and _follows(claimed, lhs):
            raise Unsaid("no proof is written of what follows from another claim, as by an increasing function")
        question = as_asked((lhs, rhs, given, nonzero))
        needs = tuple(need for need in verdict.needs if need not in question.spelled)
        statement = ScalarStatement(question.asked, needs, question.values, claimed)
        own: SympyStatement = statement
        if question.compared:
            with suppress(ValueError):  # then it is said by what stands for the inequalities
                own = OwnInequalities(statement, question.compared, question.stand)
        whole = own if claimed is None else own.claiming(claimed)
        said = holding(name, whole)
        steps = _steps(statement, verdict.certificate)
        steps = own.steps(steps) if isinstance(own, OwnInequalities) else steps
        proof = theorem(name, steps if whole is own else claiming(own, whole, steps))
    except (Rejected, Unsaid) as reason:
        return replace(claim, said=said, why_not=str(reason))
    except (ArithmeticError, LookupError, ValueError, sympy.PolynomialError):
        return replace(claim, said=said, why_not="no proof is written of what is shown in this way")
    return replace(claim, said=said, proof=proof)


def _follows(claim: Any, left: Any) -> bool:
    """Whether a claim was proved by one in other words, with another left side."""
    if isinstance(claim, sympy.Equality):
        return True
    others = any(said(claim) is not claim for said in (plainer, with_name, where_it_rises))
    others = others or next(of_values(claim, [sympy.Eq(left, 0, evaluate=False)]), None) is not None
    return others and sides_of(claim)[0] not in (left, *left.args)


def _steps(said: ScalarStatement, certificate: Mapping[str, Any]) -> Iterable[str]:
    """The steps that show both sides to be equal."""
    if all(left == right for left, right in said.goals) and not said.timed:
        return AS_SPELLED
    return BY_CASES if said.is_of_cases(certificate) else _ScalarProof(said, certificate).steps()


class _ScalarProof:
    def __init__(self, statement: ScalarStatement, certificate: Mapping[str, Any]) -> None:
        certificate = {**certificate, **certificate.get("proof", {})}  # of a more general question
        if other := next((how for part, how in OTHERWISE.items() if certificate.get(part)), ""):
            raise Unsaid(f"no proof is written of what is shown {other}")
        self.statement, self.certificate = statement, certificate
        self.plain = PlainExpressions(statement, certificate, READERS)
        words_named(self.plain)
        self._rates: list[str] = []

    def steps(self) -> Iterator[str]:
        """All steps."""
        said, plain = self.statement, self.plain
        bound = introduced(said)
        moving = [premise.name for premise in said.premises if premise.moves]
        combined = [self._combined(count, *pair) for count, pair in enumerate(said.goals)]
        for value in said.needed:
            with suppress(Unsaid):  # then it is of no use here
                plain(value)
        if said.timed:
            yield "unfold during."
        yield f"intros {bound}{NOW * said.timed}." if bound else "intros."
        yield from self._rates
        rates = [line.split()[1][1:] for line in self._rates]
        for name in (*moving, *rates):
            yield f"specialize ({name}{NOW}); cbv beta in {name}."
        for premise in said.premises:
            if premise.says.startswith("0 < "):
                yield f"pose proof (Rgt_not_eq _ _ {premise.name})."
        remembered = sorted(plain.remembered.items(), key=self._order)
        before = sum(bool(TANGENT.search(text)) for text, _ in remembered)
        asked = before + sum(text in plain.asked for text, _ in remembered[before:])
        named = [f"remember ({text}) as {name} eqn:of'{name} in *." for text, name in remembered]
        yield from (*named[:before], "unfold tan in *.", *named[before:asked], *plain.put, *named[asked:])
        yield from plain.facts
        yield from [f"{plain.rewritten.removesuffix('; ')} in *."] * bool(plain.values)
        yield from dict.fromkeys(step for pair in said.goals for side in pair for step in plain.nonzero(plain(side)))
        yield from ["repeat apply conj."] * (len(combined) > 1)
        for how, total in combined:
            way = f"{plain.rewritten}{how}apply (by_parts _ _ ({total})); [vanish | identity]"
            yield f"{'- ' * (len(combined) > 1)}{way}."

    def _order(self, remembered: tuple[str, str]) -> tuple[bool, bool, int]:
        """First what has tangents, then what definitions are put into; of these, the larger ones first."""
        text, _ = remembered
        return not TANGENT.search(text), text not in self.plain.asked, -len(text)

    def _combined(self, count: int, left: Any, right: Any) -> tuple[str, str]:
        """The difference of both sides, or of squares, as a combination of what vanishes; after the step to these."""
        plain, variant = self.plain, self.certificate.get("variant", 0)
        left, right = plain(left), plain(right)
        with suppress(Unsaid):
            return "", plain.total(left - right)
        claim = left**2 - right**2 if variant == 2 else (left - right) ** (1 + variant)
        try:
            return COMPARED[variant], plain.total(claim)
        except Unsaid:
            place = list(self.statement.asked.left)[count]
            said = self.certificate.get("entries", {}).get("{},{}".format(*(k + 1 for k in place)), {})
            if not said:
                raise
        divisors = [plain.parsed(text) for text in self.certificate.get("divisors", ())]
        below = reduce(mul, (divisors[int(k)] ** n for k, n in said.get("times", {}).items()), sympy.Integer(1))
        plain.facts += plain.nonzero(1 / below)
        products, rest = [], claim * below
        for label, text in said.get("cofactors", {}).items():
            value, spelled = self._given(label)
            cofactor = plain.parsed(text)
            products.append(f"({text_of(cofactor)} / {text_of(below)}) * {spelled}")
            rest -= cofactor * value
        return COMPARED[variant], " + ".join([*products, plain.total(rest, below)])

    def _square(self, place: int, which: int) -> tuple[Any, str]:
        """What vanishes since a sum of squares does, which is a sum of multiples of what is given."""
        plain, said = self.plain, self.certificate["squares"][place]
        squares = [[plain.parsed(text) for text in pair] for pair in said["squares"]]
        weight, base = squares[which]
        if not all(each.is_nonnegative for each, _ in squares) or not weight.is_positive:
            raise Unsaid("no proof is written with squares whose weights are not seen to be positive")
        of = [(plain.parsed(times), *self._given(label)) for label, times in said["of"]]
        terms = [f"({text_of(each)} * {text_of(root)}^2)" for each, root in squares]
        whole = sympy.Add(*(each * root**2 for each, root in squares), *(-times * value for times, value, _ in of))
        given = " + ".join(f"{text_of(times)} * {spelled}" for times, _, spelled in of)
        total = f"apply (by_parts _ _ ({given} + {plain.total(whole)})); [vanish | identity]"
        known = "".join(f"assert (0 <= {term}) by nonnegative; " for term in terms)
        steps = f"assert ({' + '.join(terms)} = 0) by ({total}); {known}"
        steps += f"apply (of_square {text_of(weight)}); [above | lra]"
        fact = f"assert (fact'{len(plain.facts)} : {text_of(base)} = 0) by ({steps})."
        plain.facts.append(fact)
        return base, text_of(base)

    def _given(self, label: str) -> tuple[Any, str]:
        """What is given, or its rate, as a polynomial that vanishes, and how it is spelled."""
        if found := SQUARE.fullmatch(label):
            return self._square(int(found[1]), int(found[2]) - 1)
        found = GIVEN.fullmatch(label)
        if found is None or int(found[1]) >= len(self.statement.asked.given):
            raise Unsaid("no proof is written with all that follows from what is given")
        count, i, j = (int(found[k]) for k in (1, 2, 3))
        places = [place for place, _ in self.statement.given]
        at = places.index((count, i - 1, j - 1))
        (left, right), name = self.statement.given[at][1], f"cond'{at}"
        sides = " ".join(f"(fun t => {self.statement.side(side)})" for side in (left, right))
        parts = sympy.Tuple(left, right).atoms(sympy.Function, sympy.Pow) - self.statement.words.atoms.keys()
        if found[4] and not all(e.func in RATED or (e.is_Pow and e.exp.is_Integer) for e in parts):
            raise Unsaid(f"no proof is written with the rate of {left} = {right}")
        for _ in range(int(found[4] or 0)):
            left, right = left.diff(self.statement.words.time), right.diff(self.statement.words.time)
            line = equal_rates(f"{name}'", "_", sides, f"exact {name} | rates | rates")
            self._rates += [line] * (line not in self._rates)
            name, sides = f"{name}'", "_ _"
        difference = self.plain(left) - self.plain(right)
        below = reduce(mul, sympy.fraction(sympy.together(difference))[1].as_coeff_mul()[1], sympy.Integer(1))
        value = sympy.cancel(difference * below)
        steps = f"apply (equal_numbers ({text_of(below)}) _ _ _ {name}); words; {self.plain.rewritten}identity"
        fact = f"assert (fact'{len(self.plain.facts)} : {text_of(value)} = 0) by ({steps})."
        self.plain.facts.append(fact)
        return value, text_of(value)
