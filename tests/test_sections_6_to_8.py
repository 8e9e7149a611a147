"""Sections 3.6 to 3.8: moving frames, statics, dynamics. Every equation is declared and decided, and one fails."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace as with_fields

import pytest

from chasles import derivations
from chasles.checker.certificate import check
from chasles.checker.refutation import check_counterexample
from chasles.decisions.session import Session
from chasles.lowering.declaration import requested
from chasles.statements import Chapter, Entry, load, problem_of
from chasles.statements.arrays import argument_name
from chasles.statements.premises import with_all_premises
from chasles.verdict import Fails, Holds, HoldsUnder
from chasles.vocabulary import Negative, number, replace

from .decided import chapter_session

MODULES = (
    "s02_screw",
    "s03_fixed_point",
    "s04_twist",
    "s05_acceleration",
    "s06_moving_frame",
    "s07_statics",
    "s08_dynamics",
)
SECTIONS = ("3.6", "3.7", "3.8")
NUMBERS = {f"3.{k}" for k in range(98, 149) if k not in (119, 133, 134)}
LETTERED = {"3.119a", "3.119b", "3.133a", "3.133b", "3.134a", "3.134b"}
KERNELS = {
    "moving_frame_velocity": "o_dot Q omega rho rho_dot",
    "moving_frame_acceleration": "o_ddot Q omega omega_dot rho rho_dot rho_ddot",
    "wrench_transfer": "w_A a p",
    "wrench_axis": "f n_A a",
    "power": "t w",
    "reciprocal_product": "s_w s_t",
    "inertia_about_point": "I_C m c a",
    "inertia_dyad": "I_C m c a",
    "momentum_screw": "I_C m t",
    "kinetic_energy": "I_C m t",
    "newton_euler_wrench": "I_C m t t_dot",
    "newton_euler_twist_rate": "I_C m t w",
}


@pytest.fixture(scope="module")
def chapter() -> Chapter:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(derivations, "SECTIONS", MODULES)
        return load()


@pytest.fixture(scope="module")
def judge() -> Session:
    return chapter_session()


def here(chapter: Chapter) -> list[Entry]:
    return [entry for entry in chapter if entry.section.number in SECTIONS]


def named(chapter: Chapter, name: str):
    return next(entry.statement for entry in chapter if entry.name == name)


def test_every_number_is_declared(chapter: Chapter) -> None:
    numbers = {entry.number for entry in here(chapter) if entry.number.startswith("3.")}
    assert numbers == NUMBERS | LETTERED
    assert {"Thm 3.7.1", "Thm 3.7.2", "Ex 3.17", "Ex 3.18", "2.39", "2.40"} <= {entry.number for entry in here(chapter)}


def test_everything_is_decided_and_one_equation_fails(chapter: Chapter, judge: Session) -> None:
    decided = [(entry, judge.decide(entry.statement)) for entry in here(chapter)]
    counts = Counter(decision.verdict.name for _, decision in decided)
    assert set(counts) == {"holds", "holds-under", "defined", "posed", "assumed", "fails"}
    assert counts["assumed"] == 2
    assert counts["posed"] == 4
    assert [entry.number for entry, decision in decided if not decision.verdict.true] == ["3.148"]
    unused = {entry.name: decision.verdict.unused for entry, decision in decided if hasattr(decision.verdict, "unused")}
    assert not [name for name, hypotheses in unused.items() if hypotheses]


def test_the_certificates_prove_it(chapter: Chapter, judge: Session) -> None:
    for entry in here(chapter):
        decision = judge.decide(entry.statement)
        if decision.certificate is not None:
            check(decision.repaired, "printed", decision.certificate, judge.accepted)


def test_steiner_by_dyads_fails_in_a_block_without_p(chapter: Chapter, judge: Session) -> None:
    statement = named(chapter, "steiner_by_dyads")
    decision = judge.decide(statement)
    assert isinstance(decision.verdict, Fails)
    row, column_ = decision.verdict.counterexample.entry
    assert (row <= 3) != (column_ <= 3)
    assert decision.verdict.counterexample.at["m"] > 0
    asked = problem_of(with_all_premises(statement, judge.accepted), "printed", judge.accepted)
    check_counterexample(asked, decision.verdict.counterexample)
    assert decision.correction is not None
    assert isinstance(decision.correction.verdict, Holds | HoldsUnder)


@pytest.mark.parametrize(
    ("name", "needs"),
    [
        ("rate_of_rotation", {"Q is a rotation"}),
        ("least_moment_on_one_line", {"f != 0"}),
        ("energy_by_center_of_mass", {"m > 0"}),
        ("inertia_is_semidefinite", {"rho > 0"}),
        ("energy_is_definite", {"m > 0", "I_C is positive-definite"}),
        ("inertia_dyad_is_definite", {"m > 0", "I_C is positive-definite"}),
        ("no_decomposition", {"m > 0"}),
        ("difference_is_skew", {"I_C is symmetric"}),
        ("newton_euler_twist_rate", {"det(I_C) != 0", "m > 0"}),
    ],
)
def test_what_is_needed(chapter: Chapter, judge: Session, name: str, needs: set[str]) -> None:
    verdict = judge.decide(named(chapter, name)).verdict
    assert isinstance(verdict, HoldsUnder)
    assert set(verdict.needs) == needs


@pytest.mark.sampled(5)
@pytest.mark.parametrize(
    "name",
    [
        "moving_frame_acceleration",
        "moment_about_point_by_force",
        "wrench_point",
        "power",
        "wrench_transfer",
        "energy_by_center_of_mass",
        "inertia_about_point",
        "inertia_with_respect_to_point_expanded",
        "inertia_turns_with_the_body",
        "rate_of_angular_momentum",
        "newton_euler_by_dyads",
        "rate_of_momentum_screw",
        "kinetic_energy",
        "inertia_dyad",
        "rate_of_inertia_dyad",
    ],
)
def test_with_the_other_sign_it_fails(chapter: Chapter, judge: Session, name: str) -> None:
    statement = named(chapter, name)
    assert statement.number.startswith(("3.", "text", "Ex"))
    wrong = with_fields(statement, right=Negative(statement.right), kernel=None)
    assert isinstance(judge.decide(wrong).verdict, Fails)


def test_slips_of_the_pen_fail(chapter: Chapter, judge: Session) -> None:
    coriolis = named(chapter, "moving_frame_acceleration")
    once = with_fields(coriolis, right=replace(coriolis.right, {number(2): number(1)}), kernel=None)
    dyad = named(chapter, "inertia_dyad")
    C_A = dyad.right.rows[0][1]
    untransposed = with_fields(dyad, right=replace(dyad.right, {dyad.right.rows[1][0]: C_A}), kernel=None)
    inverse = named(chapter, "wrench_transfer_inverse")
    itself = with_fields(inverse, right=inverse.left.of)
    for wrong in (once, untransposed, itself):
        assert isinstance(judge.decide(wrong).verdict, Fails)


@pytest.mark.parametrize(("name", "arguments"), KERNELS.items())
def test_kernels(chapter: Chapter, judge: Session, name: str, arguments: str) -> None:
    entry = next(entry for entry in chapter if entry.name == name)
    request = requested(entry, judge.decide)
    assert [argument_name(node) for node in request.of] == arguments.split()
