"""Every verdict once more, by numbers of 80 digits and more at explicit motions, with differences for rates."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from itertools import islice
from typing import Any

import pytest
import sympy

from chasles.numerics.enclosures import plain_context
from chasles.statements import (
    Claim,
    Condition,
    Definite,
    Definition,
    Entry,
    Inverse,
    OnlyWhere,
    Problem,
    Statement,
    Theorem,
    load,
    problem_of,
    unit,
)
from chasles.statements.premises import with_all_premises
from chasles.verdict import Counterexample, Fails, Holds, HoldsUnder, IllFormed, Posed, Verdict
from chasles.vocabulary import (
    CPM,
    FREQUENCY,
    Integral,
    Negative,
    Node,
    Number,
    Scale,
    Sum,
    Symbol,
    cos,
    cross,
    dot,
    integral,
    norm,
    rate,
    scalar,
    sin,
    vector,
)

from .decided import chapter_session
from .sampling import WHOLE, sample
from .second_opinion.instants import DIGITS, Instant, World
from .second_opinion.motions import Motion
from .second_opinion.opinion import AGREEMENT, NoMotion, Opinion, opinion_on, rooted, second_opinion

Sentence = Statement | Theorem | Inverse
CHAPTER = load()
SECTIONS = [section.number for section in CHAPTER.sections]
NO_ROOTS = {
    "energy_by_center_of_mass",
    "energy_by_inertia",
    "energy_by_twist_at_A",
    "energy_is_definite",
    "inertia_dyad_is_definite",
    "kinetic_energy",
    "least_moment_on_one_line",
    "least_velocity_on_one_line",
    "mozzi_chasles",
}
"""What cannot be said of the roots: a theorem varies what they determine, or a claim says of the landmark that it is
the center of mass, whose motion follows from that of the landmark."""


def decided(section: str) -> Iterator[tuple[Entry, Sentence, Verdict]]:
    """Every form of every sentence of a section on which there is a verdict that numbers can contradict."""
    for entry in CHAPTER:
        if entry.section.number != section:
            continue
        decision = chapter_session().decide(entry.statement)
        forms: list[tuple[Sentence, Verdict]] = [(decision.statement, decision.verdict)]
        correction = decision.correction
        for tried in () if correction is None else (correction, *correction.others):
            assert isinstance(decision.statement, Statement)
            forms.append((decision.statement.saying(*tried.sides), tried.verdict))
        for sentence, verdict in forms:
            if isinstance(verdict, Holds | HoldsUnder | Posed | Fails):
                yield entry, sentence, verdict


def contradictions(entry: Entry, verdict: Verdict, opinion: Opinion) -> Iterator[str]:
    if verdict.true and not opinion.agrees:
        yield f"({entry.number}) {entry.name}: {verdict.name}, but at a motion the sides are apart: {opinion}"
    if not verdict.true and not opinion.differs:
        yield f"({entry.number}) {entry.name}: {verdict.name}, but at a motion the sides agree: {opinion}"


@pytest.mark.sampled(5)
@pytest.mark.parametrize("section", SECTIONS)
def test_numbers_agree_with_every_verdict(section: str) -> None:
    found: list[str] = []
    for entry, sentence, verdict in decided(section):
        found += contradictions(entry, verdict, opinion_on(sentence, accepted=chapter_session().accepted))
    assert not found, "\n".join(found)


def test_a_wrong_verdict_is_contradicted() -> None:
    entry = next(entry for entry in CHAPTER if isinstance(entry.statement, Claim) and not entry.statement.fault)
    refuted = Fails(Counterexample({}, (1, 1), "0", "1"))
    proved = Holds({}, {})
    assert [*contradictions(entry, refuted, Opinion(400.0, 400.0, ""))]
    assert [*contradictions(entry, proved, Opinion(400.0, 0.0, ""))]
    assert [*contradictions(entry, refuted, Opinion(30.0, 0.0, ""))]
    assert not [*contradictions(entry, proved, Opinion(400.0, 170.0, ""))]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("section", SECTIONS)
def test_numbers_agree_where_everything_comes_from_its_roots(section: str) -> None:
    found: list[str] = []
    for entry, sentence, verdict in decided(section):
        if isinstance(sentence, Inverse) or not rooted(sentence) or entry.name in NO_ROOTS:
            continue
        found += contradictions(entry, verdict, opinion_from_roots(sentence))
    assert not found, "\n".join(found)


def opinion_from_roots(sentence: Statement | Theorem) -> Opinion:
    refused = ""
    for version in rooted(sentence):
        try:
            return opinion_on(version, accepted=chapter_session().accepted)
        except TypeError as error:
            refused = str(error)
    raise TypeError(refused)


def test_what_has_no_roots_has_none() -> None:
    for entry in CHAPTER:
        if entry.name in NO_ROOTS and not isinstance(entry.statement, Inverse):
            with pytest.raises(TypeError, match="given"):
                opinion_from_roots(entry.statement, "printed")


def test_every_verdict_has_had_a_second_opinion() -> None:
    opined = {(entry.number, entry.statement.part) for section in SECTIONS for entry, _, _ in decided(section)}
    for entry in CHAPTER:
        verdict = chapter_session().decide(entry.statement).verdict
        is_said = isinstance(entry.statement, Claim | Condition | Theorem | Inverse)
        if is_said and not isinstance(verdict, IllFormed):
            assert (entry.number, entry.statement.part) in opined


class Jets:
    """The motion of a counterexample: each symbol with the value and rates that are given, the others at random."""

    def __init__(self, at: dict[str, Fraction], motion: Motion) -> None:
        self.context, self.motion = plain_context(DIGITS), motion
        self.values = {name: self.context.mpf(x.numerator) / x.denominator for name, x in at.items()}

    def at(self, symbol: Symbol, moment: Any, element: int | None = None) -> list[list[Any]]:
        rows, columns = symbol.shape
        drawn = self.motion.at(symbol, moment, element)
        return [[self._entry(symbol, i, j, moment, drawn[i][j]) for j in range(columns)] for i in range(rows)]

    def _entry(self, symbol: Symbol, row: int, column: int, moment: Any, otherwise: Any) -> Any:
        rows, columns = symbol.shape
        place = "" if rows == columns == 1 else f"_{row + 1}" if columns == 1 else f"_{row + 1}{column + 1}"
        jet = [self.values.get(f"{symbol.name}{dots}{place}") for dots in ("", "_dot", "_ddot")]
        for share in ("", "/2", "/4"):
            if f"cos({symbol.name}{share})" in self.values:
                sine, cosine = (self.values[f"{f}({symbol.name}{share})"] for f in ("sin", "cos"))
                jet[0] = self.context.atan2(sine, cosine) * int(share[1:] or 1)
        if jet[0] is None:
            return otherwise
        return sum((x or 0) * moment**k / (1, 1, 2)[k] for k, x in enumerate(jet))


@pytest.mark.parametrize("section", SECTIONS)
def test_counterexamples_have_the_values_that_they_say(section: str) -> None:
    for entry, sentence, verdict in decided(section):
        if isinstance(verdict, Fails):
            assert isinstance(sentence, Statement)
            accepted = chapter_session().accepted
            problem = problem_of(with_all_premises(sentence, accepted), standing=accepted)
            for error in recomputed(problem, verdict.counterexample):
                assert abs(error) * 10**AGREEMENT < 1, entry.number


def recomputed(problem: Problem, found: Counterexample) -> Iterator[Any]:
    """By how much each side differs from what the counterexample says it is."""
    world = World(problem, 0)
    world.motion = Jets(dict(found.at), world.motion)  # type: ignore[assignment]
    now = world.instant()
    row, column = found.entry
    (goal,) = (goal for goal in problem.goals if goal.label == found.goal)
    for side, said in ((goal.left, found.left), (goal.right, found.right)):
        yield now(side)[row - 1][column - 1] - value_of(said, now)


def value_of(said: str, now: Instant) -> Any:
    """A number, or a polynomial in pi or in an angle, as text."""
    expression = sympy.sympify(re.sub(r"(\d) (?=[a-z])", r"\1*", said).replace("^", "**"))
    angles = {s: now(scalar(str(s), str(s), "an angle"))[0][0] for s in expression.free_symbols}
    return now.context.mpf(expression.subs(angles).evalf(DIGITS - 20))


def flipped_signs(node: Node) -> Iterator[Node]:
    """The expression with the sign of one term of a sum turned, for each sum that is no part of another."""
    if isinstance(node, Sum):
        for place, term in enumerate(node.terms):
            turned = term.term if isinstance(term, Negative) else Negative(term)
            yield Sum((*node.terms[:place], turned, *node.terms[place + 1 :]))


@pytest.mark.sampled(3)
@pytest.mark.parametrize("section", SECTIONS)
def test_without_a_hypothesis_that_it_needs_a_claim_is_violated(section: str) -> None:
    for entry, sentence, verdict in decided(section):
        if not isinstance(verdict, HoldsUnder) or isinstance(sentence, Inverse):
            continue
        problem = problem_of(sentence, standing=chapter_session().accepted)
        for hypothesis in problem.hypotheses:
            # That a matrix is definite is needed for its squares to be squares, not for an equation.
            if hypothesis.text in verdict.needs and hypothesis.equations and hypothesis.kind != "definite":
                others = tuple(h for h in problem.hypotheses if h != hypothesis)
                with suppress(NoMotion):
                    opinion = second_opinion(replace(problem, hypotheses=others), motions=2)
                    assert opinion.differs, (entry.number, hypothesis.text, opinion)


@pytest.mark.slow
def test_a_turned_sign_is_seen() -> None:
    tried = 0
    claims = [entry for entry in CHAPTER if type(entry.statement) is Claim and not entry.statement.fault]
    for entry in sample(claims, 6):
        statement = entry.statement
        assert isinstance(statement, Claim)
        if statement.solves or not chapter_session().decide(statement).verdict.true:
            continue
        for right in islice(flipped_signs(statement.right), 1):
            mutant = replace(statement, right=right)
            opinion = opinion_on(mutant, accepted=chapter_session().accepted, motions=1)
            # A term that vanishes at all motions may have either sign: the prover knows.
            assert opinion.agrees == chapter_session().decide(mutant).verdict.true, entry.number
            assert opinion.agrees or opinion.differs
            tried += 1
    assert tried >= (20 if WHOLE else 3)


@pytest.mark.parametrize("section", SECTIONS)
def test_repairs_agree_too(section: str) -> None:
    for entry in CHAPTER:
        statement, correction = entry.statement, chapter_session().decide(entry.statement).correction
        if entry.section.number != section or not isinstance(statement, Claim) or correction is None:
            continue
        assert correction.repairs
        for found in correction.repairs:
            opinion = opinion_on(statement.saying(found.left, found.right), accepted=chapter_session().accepted)
            assert opinion.agrees, (entry.number, found.changes, opinion)


@pytest.mark.parametrize("section", SECTIONS)
def test_what_is_said_to_be_a_square_is_not_negative(section: str) -> None:
    for entry in CHAPTER:
        if entry.section.number == section and isinstance(entry.statement, Theorem):
            problem = problem_of(entry.statement, standing=chapter_session().accepted)
            for form in entry.statement.forms:
                for square in form.squares if isinstance(form, Definite | OnlyWhere) else ():
                    assert all(World(problem, seed).instant()(square)[0][0] > 0 for seed in range(5)), entry.number


x = vector("x", "x", "any vector")
spin = vector("w", "w", "angular velocity", FREQUENCY)
e = vector("e", "e", "unit vector")
phi = scalar("phi", "phi", "angle")


def agrees(left: Node, right: Node, **more: Any) -> bool:
    return opinion_on(Claim("0.1", left, right, **more)).agrees


def test_rates_are_taken_of_products_and_functions() -> None:
    assert agrees(rate(cos(phi) * x), cos(phi) * rate(x) - rate(phi) * (sin(phi) * x))
    assert not agrees(rate(cos(phi) * x), cos(phi) * rate(x) + rate(phi) * (sin(phi) * x))
    assert agrees(rate(rate(dot(x, x))), 2 * dot(x, rate(rate(x))) + 2 * dot(rate(x), rate(x)))
    assert not agrees(rate(rate(dot(x, x))), 2 * dot(x, rate(rate(x))) + dot(rate(x), rate(x)))


def test_a_unit_vector_stays_one() -> None:
    assert agrees(dot(e, rate(rate(e))), -dot(rate(e), rate(e)), assuming=(unit(e),))
    assert not agrees(dot(x, rate(rate(x))), -dot(rate(x), rate(x)))


def test_what_only_has_a_rate_is_integrated() -> None:
    turns = Claim("0.2", rate(x), cross(spin, x))
    assert agrees(rate(norm(x)) ** 2, norm(spin - spin) ** 2, given=(turns,))
    assert agrees(rate(rate(x)), cross(rate(spin), x) + CPM(spin) @ CPM(spin) @ x, given=(turns,))
    assert not agrees(rate(rate(x)), CPM(spin) @ CPM(spin) @ x, given=(turns,))
    place = dot(e, x)
    by_parts = dot(rate(rate(e)), x) + 2 * dot(rate(e), rate(x)) + dot(e, rate(rate(x)))
    assert agrees(rate(rate(place)), by_parts, given=(turns,))


def test_integrals_are_sums_over_elements() -> None:
    density = scalar("rho", "rho", "density", constant=True)
    whole: Integral = integral(density * x, density, x)
    total = integral(density, density, x)
    assert agrees(rate(whole), integral(density * rate(x), density, x))
    assert not agrees(whole, Scale(total, x))
    assert agrees(integral(density * e, density, x), Scale(total, e))


def test_contradicting_hypotheses_have_no_motion() -> None:
    doubled = Definition("0.3", e, 2 * x)
    with pytest.raises(NoMotion, match="none of"):
        opinion_on(Claim("0.4", dot(e, e), Number(Fraction(1)), given=(doubled,), assuming=(unit(e),)))
